//! The data of the sections of a `.msh` file by tag, and the triangulation built from them.

use super::lines::{Lines, at, fault};
use crate::error::{Error, Result, ToolkitError};
use crate::mesh::geometry::{BoundaryEdge, Part, Point, doubled_area};
use crate::mesh::triangulation::{Triangulation, in_numbers};
use std::collections::{BTreeMap, BTreeSet, HashMap};

/// The surface of a triangle, and its physical group.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Surface {
    pub(super) entity: i64,
    pub(super) group: Option<i64>,
}

/// A line or a triangle of the file.
pub(super) struct Element<T, const N: usize> {
    pub(super) line: usize,
    /// The entity it belongs to.
    pub(super) of: T,
    pub(super) nodes: [u64; N],
}

impl<T, const N: usize> Element<T, N> {
    fn has(&self, tags: [u64; 2]) -> bool {
        tags.iter().all(|tag| self.nodes.contains(tag))
    }
}

#[derive(Default)]
pub(super) struct Raw {
    names: HashMap<(i32, i64), String>,
    /// Physical group of an entity (dimension, tag).
    pub(super) groups: HashMap<(i32, i64), i64>,
    /// Line and coordinates of a node, by its tag.
    nodes: HashMap<u64, (usize, [f64; 3])>,
    /// The lines with their physical group.
    pub(super) lines: Vec<Element<Option<i64>, 2>>,
    /// The triangles with their surface.
    pub(super) triangles: Vec<Element<Surface, 3>>,
}

impl Raw {
    pub(super) fn read_names(&mut self, lines: &mut Lines<'_>) -> Result<()> {
        let [count] = lines.exactly::<u64, 1>()?;
        for _ in 0..count {
            let line = lines.next_line()?;
            let fault = || lines.fault("expected dimension, tag and \"name\"");
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
        if !place.iter().all(|x| x.is_finite()) {
            return Err(lines.fault("a coordinate is not finite"));
        }
        match self.nodes.insert(tag, (lines.number(), place)) {
            Some(_) => Err(lines.fault(&format!("node {tag} appears twice"))),
            None => Ok(()),
        }
    }

    pub(super) fn require_nodes(&self, total: u64, lines: &Lines<'_>) -> Result<()> {
        if self.nodes.len() as u64 == total {
            return Ok(());
        }
        Err(lines.fault(&format!("found {} nodes, expected {total}", self.nodes.len())))
    }

    pub(super) fn unknown_kind(kind: i64, lines: &Lines<'_>) -> Error {
        lines.fault(&format!(
            "element type {kind}: only points, two-node lines and three-node triangles are read"
        ))
    }

    /// The triangulation; `end` is the last line of the file.
    pub(super) fn triangulation(&self, end: usize) -> Result<Triangulation> {
        let tags: BTreeSet<u64> = self.triangles.iter().flat_map(|triangle| triangle.nodes).collect();
        let number: BTreeMap<u64, usize> =
            tags.iter().enumerate().map(|(place, &tag)| (tag, place)).collect();
        let tags: Vec<u64> = tags.into_iter().collect();
        let mut triangles = Vec::with_capacity(self.triangles.len());
        for Element { line, nodes, .. } in &self.triangles {
            if let Some(tag) = nodes.iter().find(|tag| !self.nodes.contains_key(tag)) {
                return Err(fault(*line, &format!("node {tag} is not in the file")));
            }
            triangles.push(nodes.map(|tag| number[&tag]));
        }
        let places: Vec<(usize, [f64; 3])> = tags.iter().map(|tag| self.nodes[tag]).collect();
        if let Some(node) = places.iter().position(|(_, place)| place[2] != places[0].1[2]) {
            let reason = "has a different z: the body must lie in a plane z = const";
            let tag = tags[node] as usize;
            return Err(at(places[node].0, Error::Toolkit(ToolkitError::Node { node: tag, reason })));
        }
        let nodes: Vec<Point> = places.iter().map(|&(_, [x, y, _])| [x, y]).collect();
        self.turn_clockwise_surfaces(&mut triangles, &nodes);
        let mut boundary = Vec::new();
        for &Element { line, of, nodes: [a, b] } in &self.lines {
            let part = self.part(of).map_err(|cause| at(line, cause))?;
            let Some(part) = part else { continue };
            let (Some(&from), Some(&to)) = (number.get(&a), number.get(&b)) else {
                return Err(fault(line, "a labelled edge belongs to no triangle"));
            };
            boundary.push(BoundaryEdge { nodes: [from, to], part });
        }
        let named = |cause: Error| {
            let line = self.line_of(&cause, &tags).unwrap_or(end);
            at(line, in_numbers(cause, |node| tags[node] as usize))
        };
        let mesh = Triangulation::new(&nodes, &triangles, &boundary)
            .map_err(named)?
            .with_numbers(tags.iter().map(|&tag| tag as usize).collect());
        let regions = self.regions();
        if regions.iter().all(|&region| region == 0) { Ok(mesh) } else { mesh.with_regions(&regions) }
    }

    /// The line of an invalid node, edge or triangle; node k has the k-th tag.
    fn line_of(&self, cause: &Error, tags: &[u64]) -> Option<usize> {
        match *cause {
            Error::Toolkit(ToolkitError::Triangle { triangle, .. }) => {
                Some(self.triangles.get(triangle)?.line)
            }
            Error::Toolkit(ToolkitError::Node { node, .. }) => Some(self.nodes.get(tags.get(node)?)?.0),
            Error::Toolkit(ToolkitError::Edge { nodes: [a, b], .. }) => {
                let ends = [*tags.get(a)?, *tags.get(b)?];
                let label = self.lines.iter().rfind(|edge| edge.has(ends)).map(|edge| edge.line);
                label.or_else(|| self.triangles.iter().rfind(|t| t.has(ends)).map(|t| t.line))
            }
            _ => None,
        }
    }

    /// Reverses surfaces whose triangles are all clockwise; single clockwise triangles are an error and are
    /// kept.
    fn turn_clockwise_surfaces(&self, triangles: &mut [[usize; 3]], nodes: &[Point]) {
        let is_clockwise = |corners: &[usize; 3]| doubled_area(corners.map(|node| nodes[node])) < 0.0;
        let mut all: HashMap<i64, bool> = HashMap::new();
        for (Element { of: surface, .. }, corners) in self.triangles.iter().zip(triangles.iter()) {
            *all.entry(surface.entity).or_insert(true) &= is_clockwise(corners);
        }
        for (Element { of: surface, .. }, corners) in self.triangles.iter().zip(triangles.iter_mut()) {
            if all.get(&surface.entity) == Some(&true) {
                corners.swap(1, 2);
            }
        }
    }

    /// The boundary part named by a group of curves; `None` without a group.
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
            _ => Err(Error::Toolkit(ToolkitError::UnknownName {
                what: "boundary part",
                given: name.chars().take(40).collect(),
                expected: "clamped (fixed, dirichlet), contact or free (neumann)",
            })),
        }
    }

    /// Surface groups, numbered from 0 in ascending order.
    fn regions(&self) -> Vec<u32> {
        let mut groups: Vec<Option<i64>> = self.triangles.iter().map(|triangle| triangle.of.group).collect();
        let all = groups.clone();
        groups.sort_unstable();
        groups.dedup();
        all.iter().map(|found| groups.partition_point(|other| other < found) as u32).collect()
    }
}
