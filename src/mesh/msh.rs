//! Reading Gmsh meshes: the ASCII format 4.1 (Gmsh reference manual, section "MSH file format").
//!
//! Two-node lines of curves in a physical group become boundary edges, three-node triangles the mesh,
//! physical surfaces its regions. A curve's group must be called `dirichlet`, `neumann` or `contact` (in any
//! case); of several groups the first counts. Nodes in no triangle (points of the geometry) are left out. z is
//! ignored. What was read passes the checks of [`Triangulation::new`], and what does not is named by its line.
//! Cost: O(length of the file); nothing is reserved on the word of a count in the file.

use super::geometry::{BoundaryEdge, Part, Point};
use super::msh_lines::{Lines, at, fault};
use super::triangulation::Triangulation;
use crate::error::{Error, Result};
use crate::numeric::text::{quoted, read_text};
use std::collections::{BTreeMap, BTreeSet, HashMap};
use std::path::Path;

/// Reads a `.msh` file.
///
/// # Errors
/// [`Error::File`] when it cannot be read, and those of [`parse_msh`].
pub fn read_msh(path: &Path) -> Result<Triangulation> {
    parse_msh(&read_text(path)?)
}

/// Reads the text of a `.msh` file.
///
/// # Errors
/// [`Error::Syntax`] with the line where the text does not follow the format; [`Error::AtLine`] with the line
/// that gives what is no triangulation: [`Error::UnknownName`] for a group that is no boundary part, and the
/// errors of [`Triangulation::new`].
pub fn parse_msh(text: &str) -> Result<Triangulation> {
    let mut raw = Raw::default();
    let mut lines = Lines::new(text);
    let mut known = BTreeSet::new();
    while let Some(header) = lines.next_header()? {
        let read = match header {
            "$MeshFormat" => Raw::read_format,
            "$PhysicalNames" => Raw::read_names,
            "$Entities" => Raw::read_entities,
            "$Nodes" => Raw::read_nodes,
            "$Elements" => Raw::read_elements,
            _ => {
                lines.skip_section(header)?;
                continue;
            }
        };
        if known.is_empty() && header != "$MeshFormat" {
            return Err(lines.fault("no $MeshFormat section before this one"));
        }
        if !known.insert(header) {
            return Err(lines.fault(&format!("a second section {header}")));
        }
        read(&mut raw, &mut lines)?;
        lines.expect_end(header)?;
    }
    if known.is_empty() {
        return Err(lines.fault("no $MeshFormat section"));
    }
    raw.triangulation(lines.number())
}

/// A line or a triangle as the file has it.
struct Element<const N: usize> {
    /// Where in the file.
    line: usize,
    /// Tag of its curve or surface.
    entity: i64,
    /// Tags of its nodes.
    nodes: [u64; N],
}

impl<const N: usize> Element<N> {
    fn has(&self, tags: [u64; 2]) -> bool {
        tags.iter().all(|tag| self.nodes.contains(tag))
    }
}

/// What the sections hold, by the tags of the file.
#[derive(Default)]
struct Raw {
    names: HashMap<(i32, i64), String>,
    /// Physical group of an entity (dimension, tag).
    groups: HashMap<(i32, i64), i64>,
    /// Line and place of a node tag.
    nodes: HashMap<u64, (usize, Point)>,
    lines: Vec<Element<2>>,
    triangles: Vec<Element<3>>,
}

impl Raw {
    fn read_format(&mut self, lines: &mut Lines<'_>) -> Result<()> {
        let line = lines.next_line()?;
        let mut words = line.split_whitespace();
        match (words.next(), words.next()) {
            (Some("4.1"), Some("0")) => Ok(()),
            (version, _) => {
                let found = quoted(version.unwrap_or(""));
                Err(lines.fault(&format!("expected format 4.1 in ASCII, found version {found} or binary")))
            }
        }
    }

    fn read_names(&mut self, lines: &mut Lines<'_>) -> Result<()> {
        let [count] = lines.exactly::<u64, 1>()?;
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

    fn read_entities(&mut self, lines: &mut Lines<'_>) -> Result<()> {
        let counts: [u64; 4] = lines.exactly()?;
        for (dimension, count) in (0..4).zip(counts) {
            // Tag, then a point or a bounding box, then the number of groups.
            let at = if dimension == 0 { 4 } else { 7 };
            for _ in 0..count {
                let numbers: Vec<f64> = lines.numbers()?;
                let groups = numbers.get(at).copied().unwrap_or(0.0);
                if let (true, Some(&tag), Some(&group)) = (groups > 0.0, numbers.first(), numbers.get(at + 1))
                {
                    self.groups.insert((dimension, tag as i64), group as i64);
                }
            }
        }
        Ok(())
    }

    fn read_nodes(&mut self, lines: &mut Lines<'_>) -> Result<()> {
        let [blocks, total, _, _] = lines.exactly::<u64, 4>()?;
        for _ in 0..blocks {
            let [_, _, parametric, count] = lines.exactly::<i64, 4>()?;
            if parametric != 0 {
                return Err(lines.fault("parametric nodes are not supported"));
            }
            let count = lines.count(count)?;
            let mut tags = Vec::new();
            for _ in 0..count {
                tags.push(lines.exactly::<u64, 1>()?[0]);
            }
            for tag in tags {
                let [x, y, z] = lines.exactly::<f64, 3>()?;
                if !(x.is_finite() && y.is_finite() && z.is_finite()) {
                    return Err(lines.fault("a coordinate is not finite"));
                }
                if self.nodes.insert(tag, (lines.number(), [x, y])).is_some() {
                    return Err(lines.fault(&format!("node {tag} appears twice")));
                }
            }
        }
        if self.nodes.len() as u64 != total {
            return Err(lines.fault(&format!("{} nodes, {total} announced", self.nodes.len())));
        }
        Ok(())
    }

    fn read_elements(&mut self, lines: &mut Lines<'_>) -> Result<()> {
        let [blocks, total, _, _] = lines.exactly::<u64, 4>()?;
        let mut seen = 0;
        for _ in 0..blocks {
            let [_, entity, kind, count] = lines.exactly::<i64, 4>()?;
            for _ in 0..lines.count(count)? {
                seen += 1;
                match kind {
                    1 => self.lines.push(element(lines, entity)?),
                    2 => self.triangles.push(element(lines, entity)?),
                    15 => {
                        lines.exactly::<u64, 2>()?;
                    }
                    other => {
                        return Err(lines.fault(&format!(
                            "element type {other}: only points, two-node lines and three-node triangles are read"
                        )));
                    }
                }
            }
        }
        if seen != total {
            return Err(lines.fault(&format!("{seen} elements, {total} announced")));
        }
        Ok(())
    }

    /// The triangulation; `end` is the last line of the file.
    fn triangulation(&self, end: usize) -> Result<Triangulation> {
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
        let mut boundary = Vec::new();
        for &Element { line, entity, nodes: [a, b] } in &self.lines {
            let part = self.part(entity).map_err(|cause| at(line, cause))?;
            let Some(part) = part else { continue };
            let (Some(&from), Some(&to)) = (number.get(&a), number.get(&b)) else {
                return Err(fault(line, "an edge with a label belongs to no triangle"));
            };
            boundary.push(BoundaryEdge { nodes: [from, to], part });
        }
        let nodes = tags.iter().map(|tag| self.nodes[tag].1).collect();
        let mesh = Triangulation::new(nodes, triangles, boundary)
            .map_err(|cause| at(self.line_of(&cause, &tags).unwrap_or(end), cause))?;
        let regions = self.regions();
        if regions.iter().all(|&region| region == 0) { Ok(mesh) } else { mesh.with_regions(regions) }
    }

    /// The line that gives the node, edge or triangle which is not usable; node k has the k-th tag.
    fn line_of(&self, cause: &Error, tags: &[u64]) -> Option<usize> {
        match *cause {
            Error::Triangle { triangle, .. } => Some(self.triangles.get(triangle)?.line),
            Error::Node { node, .. } => Some(self.nodes.get(tags.get(node)?)?.0),
            Error::Edge { nodes: [a, b], .. } => {
                let ends = [*tags.get(a)?, *tags.get(b)?];
                let label = self.lines.iter().rfind(|edge| edge.has(ends)).map(|edge| edge.line);
                label.or_else(|| self.triangles.iter().rfind(|t| t.has(ends)).map(|t| t.line))
            }
            _ => None,
        }
    }

    /// The label of a curve; `None` when it is in no group.
    fn part(&self, curve: i64) -> Result<Option<Part>> {
        let Some(&group) = self.groups.get(&(1, curve)) else {
            return Ok(None);
        };
        let name = self.names.get(&(1, group)).cloned().unwrap_or_else(|| group.to_string());
        match name.to_lowercase().as_str() {
            "dirichlet" => Ok(Some(Part::Dirichlet)),
            "neumann" => Ok(Some(Part::Neumann)),
            "contact" => Ok(Some(Part::Contact)),
            _ => Err(Error::UnknownName {
                what: "boundary part",
                given: name.chars().take(40).collect(),
                expected: "dirichlet, neumann or contact",
            }),
        }
    }

    /// Surface groups, numbered from 0 in ascending order.
    fn regions(&self) -> Vec<u32> {
        let group = |surface: i64| self.groups.get(&(2, surface)).copied();
        let mut groups: Vec<Option<i64>> =
            self.triangles.iter().map(|triangle| group(triangle.entity)).collect();
        let all = groups.clone();
        groups.sort_unstable();
        groups.dedup();
        all.iter().map(|found| groups.partition_point(|other| other < found) as u32).collect()
    }
}

fn element<const N: usize>(lines: &mut Lines<'_>, entity: i64) -> Result<Element<N>> {
    let (_, nodes) = lines.tagged()?;
    Ok(Element { line: lines.number(), entity, nodes })
}
