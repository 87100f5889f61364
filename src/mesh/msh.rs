//! Reading Gmsh meshes: the ASCII format 4.1 (Gmsh reference manual, section "MSH file format").
//!
//! Two-node lines of curves in a physical group become boundary edges, three-node triangles the mesh,
//! physical surfaces its regions. A curve's group must be called `dirichlet`, `neumann` or `contact` (in any
//! case). Nodes in no triangle (points of the geometry) are left out. z is ignored. What was read passes the
//! checks of [`Triangulation::new`]. Cost: O(length of the file); nothing is reserved on the word of a count
//! in the file.

use super::geometry::{BoundaryEdge, Part, Point};
use super::triangulation::Triangulation;
use crate::error::{Error, Result};
use std::collections::{BTreeMap, HashMap};
use std::path::Path;
use std::str::FromStr;

/// Reads a `.msh` file.
///
/// # Errors
/// [`Error::File`] when it cannot be read, and those of [`parse_msh`].
pub fn read_msh(path: &Path) -> Result<Triangulation> {
    parse_msh(&std::fs::read_to_string(path).map_err(|e| Error::file(path, e))?)
}

/// Reads the text of a `.msh` file.
///
/// # Errors
/// [`Error::Syntax`] with the line, [`Error::UnknownName`] for a group that is no boundary part, and the
/// errors of [`Triangulation::new`].
pub fn parse_msh(text: &str) -> Result<Triangulation> {
    let mut raw = Raw::default();
    let mut lines = Lines { numbered: text.lines().enumerate(), line: 0 };
    let mut versioned = false;
    while let Some(header) = lines.next_header() {
        match header {
            "$MeshFormat" => {
                raw.read_format(&mut lines)?;
                versioned = true;
            }
            "$PhysicalNames" => raw.read_names(&mut lines)?,
            "$Entities" => raw.read_entities(&mut lines)?,
            "$Nodes" => raw.read_nodes(&mut lines)?,
            "$Elements" => raw.read_elements(&mut lines)?,
            _ => {
                lines.skip_section(header);
                continue;
            }
        }
        lines.expect_end(header)?;
    }
    if !versioned {
        return Err(lines.fault("no $MeshFormat section"));
    }
    raw.triangulation()
}

/// Lines with their numbers; blank ones are passed over.
struct Lines<'a> {
    numbered: std::iter::Enumerate<std::str::Lines<'a>>,
    line: usize,
}

impl<'a> Lines<'a> {
    fn next_header(&mut self) -> Option<&'a str> {
        self.next_line().ok()
    }

    fn next_line(&mut self) -> Result<&'a str> {
        for (index, line) in self.numbered.by_ref() {
            self.line = index + 1;
            if !line.trim().is_empty() {
                return Ok(line.trim());
            }
        }
        Err(self.fault("the file ends early"))
    }

    /// The numbers of the next line.
    fn numbers<T: FromStr>(&mut self) -> Result<Vec<T>> {
        let line = self.next_line()?;
        line.split_whitespace()
            .map(|word| {
                word.parse().map_err(|_| self.fault(&format!("'{word}' is not a number of the right kind")))
            })
            .collect()
    }

    /// The first `N` numbers of the next line.
    fn first<T: FromStr + Copy, const N: usize>(&mut self) -> Result<[T; N]> {
        let numbers = self.numbers()?;
        let first = numbers.first_chunk().copied();
        first.ok_or_else(|| self.fault(&format!("{} numbers, expected {N}", numbers.len())))
    }

    fn skip_section(&mut self, header: &str) {
        let end = header.replacen('$', "$End", 1);
        while self.next_line().is_ok_and(|line| line != end) {}
    }

    fn expect_end(&mut self, header: &str) -> Result<()> {
        let end = header.replacen('$', "$End", 1);
        let line = self.next_line()?;
        if line == end { Ok(()) } else { Err(self.fault(&format!("expected {end}, found '{line}'"))) }
    }

    fn fault(&self, reason: &str) -> Error {
        Error::Syntax { format: "msh", line: self.line, reason: reason.to_owned() }
    }
}

/// What the sections hold, by the tags of the file.
#[derive(Default)]
struct Raw {
    names: HashMap<(i32, i64), String>,
    /// Physical group of an entity (dimension, tag).
    groups: HashMap<(i32, i64), i64>,
    nodes: HashMap<u64, Point>,
    /// Curve and node tags.
    lines: Vec<(i64, [u64; 2])>,
    /// Surface and node tags.
    triangles: Vec<(i64, [u64; 3])>,
}

impl Raw {
    fn read_format(&mut self, lines: &mut Lines<'_>) -> Result<()> {
        let line = lines.next_line()?;
        let mut words = line.split_whitespace();
        match (words.next(), words.next()) {
            (Some("4.1"), Some("0")) => Ok(()),
            (version, _) => {
                let found = version.unwrap_or("nothing");
                Err(lines.fault(&format!("expected format 4.1 in ASCII, found version {found} or binary")))
            }
        }
    }

    fn read_names(&mut self, lines: &mut Lines<'_>) -> Result<()> {
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

    fn read_entities(&mut self, lines: &mut Lines<'_>) -> Result<()> {
        let counts: [u64; 4] = lines.first()?;
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
        let [blocks, total] = lines.first::<u64, 2>()?;
        for _ in 0..blocks {
            let [_, _, parametric, count] = lines.first::<i64, 4>()?;
            if parametric != 0 {
                return Err(lines.fault("parametric nodes are not supported"));
            }
            let mut tags = Vec::new();
            for _ in 0..count {
                tags.push(lines.first::<u64, 1>()?[0]);
            }
            for tag in tags {
                let [x, y, _] = lines.first::<f64, 3>()?;
                if self.nodes.insert(tag, [x, y]).is_some() {
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
        let [blocks, total] = lines.first::<u64, 2>()?;
        let mut seen = 0;
        for _ in 0..blocks {
            let [_, entity, kind, count] = lines.first::<i64, 4>()?;
            for _ in 0..count {
                seen += 1;
                match kind {
                    1 => {
                        let [_, a, b] = lines.first()?;
                        self.lines.push((entity, [a, b]));
                    }
                    2 => {
                        let [_, a, b, c] = lines.first()?;
                        self.triangles.push((entity, [a, b, c]));
                    }
                    15 => {
                        lines.next_line()?;
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

    fn triangulation(&self) -> Result<Triangulation> {
        let mut number: BTreeMap<u64, usize> =
            self.triangles.iter().flat_map(|(_, tags)| tags).map(|&tag| (tag, 0)).collect();
        let mut nodes = Vec::with_capacity(number.len());
        for (tag, place) in &mut number {
            let unknown =
                || Error::Node { node: *tag as usize, reason: "is used by a triangle and not in the file" };
            *place = nodes.len();
            nodes.push(*self.nodes.get(tag).ok_or_else(unknown)?);
        }
        // Every tag of a triangle is in the map.
        let place = |tag: u64| number.get(&tag).copied();
        let triangles: Vec<[usize; 3]> =
            self.triangles.iter().map(|(_, tags)| tags.map(|tag| place(tag).unwrap_or(usize::MAX))).collect();
        let mut boundary = Vec::new();
        for &(curve, [a, b]) in &self.lines {
            let Some(part) = self.part(curve)? else { continue };
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
                given: name,
                expected: "dirichlet, neumann or contact",
            }),
        }
    }

    /// Surface groups, numbered from 0 in ascending order.
    fn regions(&self) -> Vec<u32> {
        let group = |surface: i64| self.groups.get(&(2, surface)).copied();
        let mut groups: Vec<Option<i64>> =
            self.triangles.iter().map(|&(surface, _)| group(surface)).collect();
        let all = groups.clone();
        groups.sort_unstable();
        groups.dedup();
        all.iter().map(|found| groups.partition_point(|other| other < found) as u32).collect()
    }
}
