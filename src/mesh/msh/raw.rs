//! What the sections of a `.msh` file hold, by the tags of the file, and the triangulation they make.

use super::lines::Lines;
use crate::error::{Error, Result};
use crate::mesh::geometry::{BoundaryEdge, Part, Point, doubled_area};
use crate::mesh::triangulation::Triangulation;
use std::collections::{BTreeMap, HashMap};

/// The surface of a triangle, and its physical group.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Surface {
    pub(super) entity: i64,
    pub(super) group: Option<i64>,
}

#[derive(Default)]
pub(super) struct Raw {
    names: HashMap<(i32, i64), String>,
    /// Physical group of an entity (dimension, tag).
    pub(super) groups: HashMap<(i32, i64), i64>,
    nodes: HashMap<u64, [f64; 3]>,
    /// Physical group and node tags.
    pub(super) lines: Vec<(Option<i64>, [u64; 2])>,
    /// Surface and node tags.
    pub(super) triangles: Vec<(Surface, [u64; 3])>,
}

impl Raw {
    pub(super) fn read_names(&mut self, lines: &mut Lines<'_>) -> Result<()> {
        let [count] = lines.first::<u64, 1>()?;
        for _ in 0..count {
            let line = lines.next_line()?;
            let fault = || lines.fault("expected: dimension tag \"name\"");
            let (head, name) = line.split_once('"').ok_or_else(fault)?;
            let mut words = head.split_whitespace().map(str::parse::<i64>);
            let (Some(Ok(dimension)), Some(Ok(tag))) = (words.next(), words.next()) else {
                return Err(fault());
            };
            let dimension = i32::try_from(dimension).map_err(|_| fault())?;
            self.names.insert((dimension, tag), name.trim_end_matches('"').to_owned());
        }
        Ok(())
    }

    pub(super) fn add_node(&mut self, tag: u64, place: [f64; 3], lines: &Lines<'_>) -> Result<()> {
        match self.nodes.insert(tag, place) {
            Some(_) => Err(lines.fault(&format!("node {tag} appears twice"))),
            None => Ok(()),
        }
    }

    pub(super) fn require_nodes(&self, total: u64, lines: &Lines<'_>) -> Result<()> {
        if self.nodes.len() as u64 == total {
            return Ok(());
        }
        Err(lines.fault(&format!("{} nodes, {total} announced", self.nodes.len())))
    }

    pub(super) fn unknown_kind(kind: i64, lines: &Lines<'_>) -> Error {
        lines.fault(&format!(
            "element type {kind}: only points, two-node lines and three-node triangles are read"
        ))
    }

    pub(super) fn triangulation(&self) -> Result<Triangulation> {
        let mut number: BTreeMap<u64, usize> =
            self.triangles.iter().flat_map(|(_, tags)| tags).map(|&tag| (tag, 0)).collect();
        let (mut nodes, mut heights) = (Vec::with_capacity(number.len()), Vec::new());
        for (tag, place) in &mut number {
            let unknown =
                || Error::Node { node: *tag as usize, reason: "is used by a triangle and not in the file" };
            *place = nodes.len();
            let &[x, y, z] = self.nodes.get(tag).ok_or_else(unknown)?;
            nodes.push([x, y]);
            heights.push((*tag, z));
        }
        if let Some((tag, _)) = heights.iter().find(|(_, z)| *z != heights[0].1) {
            let reason = "(tag) has another z: the body must lie in a plane z = const";
            return Err(Error::Node { node: *tag as usize, reason });
        }
        // Every tag of a triangle is in the map.
        let place = |tag: u64| number.get(&tag).copied();
        let mut triangles: Vec<[usize; 3]> =
            self.triangles.iter().map(|(_, tags)| tags.map(|tag| place(tag).unwrap_or(usize::MAX))).collect();
        self.turn_clockwise_surfaces(&mut triangles, &nodes);
        let mut boundary = Vec::new();
        for &(group, [a, b]) in &self.lines {
            let Some(part) = self.part(group)? else { continue };
            let (Some(from), Some(to)) = (place(a), place(b)) else {
                let nodes = [a as usize, b as usize];
                return Err(Error::Edge {
                    nodes,
                    reason: "(tags) carries a label and belongs to no triangle",
                });
            };
            boundary.push(BoundaryEdge { nodes: [from, to], part });
        }
        let mesh = Triangulation::new(nodes, triangles, boundary)?;
        let regions = self.regions();
        if regions.iter().all(|&region| region == 0) { Ok(mesh) } else { mesh.with_regions(regions) }
    }

    /// A surface drawn clockwise has all its triangles clockwise; single ones are a fault and stay.
    fn turn_clockwise_surfaces(&self, triangles: &mut [[usize; 3]], nodes: &[Point]) {
        let is_clockwise = |corners: &[usize; 3]| doubled_area(corners.map(|node| nodes[node])) < 0.0;
        let mut all: HashMap<i64, bool> = HashMap::new();
        for (&(surface, _), corners) in self.triangles.iter().zip(triangles.iter()) {
            *all.entry(surface.entity).or_insert(true) &= is_clockwise(corners);
        }
        for (&(surface, _), corners) in self.triangles.iter().zip(triangles.iter_mut()) {
            if all.get(&surface.entity) == Some(&true) {
                corners.swap(1, 2);
            }
        }
    }

    /// What a group of curves is called to be; `None` without a group.
    fn part(&self, group: Option<i64>) -> Result<Option<Part>> {
        let Some(group) = group else {
            return Ok(None);
        };
        let name = self.names.get(&(1, group)).cloned().unwrap_or_else(|| group.to_string());
        let lower = name.to_lowercase();
        match lower.split([' ', '_', '-']).next().unwrap_or_default() {
            "clamped" | "fixed" | "dirichlet" => Ok(Some(Part::Dirichlet)),
            "free" | "neumann" => Ok(Some(Part::Neumann)),
            "contact" => Ok(Some(Part::Contact)),
            _ => Err(Error::UnknownName {
                what: "boundary part",
                given: name,
                expected: "clamped (fixed, dirichlet), contact or free (neumann)",
            }),
        }
    }

    /// Surface groups, numbered from 0 in ascending order.
    fn regions(&self) -> Vec<u32> {
        let mut groups: Vec<Option<i64>> = self.triangles.iter().map(|(surface, _)| surface.group).collect();
        let all = groups.clone();
        groups.sort_unstable();
        groups.dedup();
        all.iter().map(|found| groups.partition_point(|other| other < found) as u32).collect()
    }
}
