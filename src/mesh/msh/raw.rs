//! The data of the sections of a `.msh` file by tag, and the triangulation made from them.

use super::source::{Source, at, fault};
use crate::error::{Error, Result, ToolkitError};
use crate::mesh::geometry::{Part, Point};
use crate::mesh::grouped::{Grouped, NO_GROUP, in_numbers};
use crate::mesh::triangulation::Triangulation;
use std::collections::{BTreeMap, BTreeSet, HashMap};

/// Largest deviation of a node from the plane of the body, relative to the largest coordinate: the rounding of
/// coordinates after a rotation.
const FLAT: f64 = 1e-12;

/// A line or a triangle of the file; a line has two nodes and a zero.
#[derive(Debug, Clone, Copy)]
pub(super) struct Element {
    /// The place of its record in the file.
    pub(super) place: usize,
    pub(super) tag: u64,
    /// The curve or the surface that it belongs to.
    pub(super) entity: i64,
    /// Its physical group in format 2; 0 if it has none.
    pub(super) group: i64,
    pub(super) nodes: [u64; 3],
}

impl Element {
    pub(super) fn at(place: usize) -> Self {
        Self { place, tag: 0, entity: 0, group: 0, nodes: [0; 3] }
    }

    fn has(&self, tags: [u64; 2]) -> bool {
        tags.iter().all(|tag| self.nodes.contains(tag))
    }
}

#[derive(Default)]
pub(super) struct Raw {
    pub(super) is_binary: bool,
    /// Names of the physical groups, by dimension and tag.
    pub(super) names: BTreeMap<(i32, i64), String>,
    /// Physical groups of an entity (dimension, tag).
    pub(super) groups: HashMap<(i32, i64), Vec<i64>>,
    /// Place in the file and coordinates of a node, by its tag.
    nodes: HashMap<u64, (usize, [f64; 3])>,
    /// Entity and group of the elements that are points.
    pub(super) points: Vec<(i64, i64)>,
    pub(super) lines: Vec<Element>,
    pub(super) triangles: Vec<Element>,
    /// Whether an element has nodes beside its corners.
    pub(super) higher: bool,
}

impl Raw {
    /// The dimension of a name in format 2.0, which states none.
    pub(super) const ANY_DIMENSION: i32 = -1;

    pub(super) fn add_node(
        &mut self,
        tag: u64,
        place: [f64; 3],
        source: &Source<'_>,
    ) -> Result<()> {
        if !place.iter().all(|x| x.is_finite()) {
            return Err(source.fault("a coordinate is not finite"));
        }
        match self.nodes.insert(tag, (source.place(), place)) {
            Some(_) => Err(source.fault(&format!("node {tag} appears twice"))),
            None => Ok(()),
        }
    }

    pub(super) fn require_nodes(&self, total: u64, source: &Source<'_>) -> Result<()> {
        if self.nodes.len() as u64 == total {
            return Ok(());
        }
        Err(source.fault(&format!("found {} nodes, expected {total}", self.nodes.len())))
    }

    fn fault(&self, place: usize, reason: &str) -> Error {
        fault(self.is_binary, place, reason)
    }

    fn at(&self, place: usize, cause: Error) -> Error {
        at(self.is_binary, place, cause)
    }

    /// The triangulation; `end` is the last place of the file. A group of boundary edges in `parts` is that part.
    pub(super) fn triangulation(
        &self,
        parts: &[(&str, Part)],
        end: usize,
    ) -> Result<Triangulation> {
        if self.triangles.is_empty() {
            return Err(self.fault(
                end,
                "the file has no triangles: Gmsh meshes a body by gmsh -2 and saves only what is in a physical \
                 group; add Physical Surface(\"body\") = {1};",
            ));
        }
        let mut tags: Vec<u64> =
            self.triangles.iter().flat_map(|triangle| triangle.nodes).collect();
        tags.sort_unstable();
        tags.dedup();
        for Element { place, nodes, .. } in &self.triangles {
            if let Some(tag) = nodes.iter().find(|tag| !self.nodes.contains_key(tag)) {
                return Err(self.fault(*place, &format!("node {tag} is not in the file")));
            }
        }
        self.refuse_doubles()?;
        let nodes = self.plane(&tags)?;
        let number = |tag: u64| tags.binary_search(&tag).ok();
        let corners =
            |triangle: &Element| triangle.nodes.map(|tag| number(tag).unwrap_or_default());
        let triangles: Vec<[usize; 3]> = self.triangles.iter().map(corners).collect();
        let (regions, region_names) = self.regions()?;
        let (mut edges, mut rows, mut names) = (Vec::new(), Vec::new(), HashMap::new());
        for line in &self.lines {
            let Some(group) = self.group(1, line)? else { continue };
            let [a, b, _] = line.nodes;
            let (Some(from), Some(to)) = (number(a), number(b)) else {
                return Err(self.fault(line.place, "a labelled edge belongs to no triangle"));
            };
            names.entry(group).or_insert_with(|| self.name(1, group));
            edges.push(([from, to], group));
            rows.push(line.place);
        }
        let edges: Vec<([usize; 2], &str)> =
            edges.iter().map(|(edge, group)| (*edge, &*names[group])).collect();
        let grouped = Grouped {
            nodes: &nodes,
            triangles: &triangles,
            regions: &regions,
            region_names,
            edges: &edges,
            parts,
        };
        let mesh = grouped.triangulation().map_err(|(cause, edge)| {
            if matches!(cause, Error::NoGroup { .. }) {
                return cause; // no line of the file is at fault
            }
            let place =
                edge.map(|edge| rows[edge]).or_else(|| self.place_of(&cause, &tags)).unwrap_or(end);
            let numbers = |node: usize| tags.get(node).map_or(node, |&tag| tag as usize);
            let triangle =
                |t: usize| self.triangles.get(t).map_or(t, |triangle| triangle.tag as usize);
            if let Error::Toolkit(ToolkitError::Edge { nodes: ends, reason: NO_GROUP }) = cause {
                let [a, b] = ends.map(numbers);
                let [from, to] = ends.map(|node| nodes[node].map(short));
                let at = format!("({}, {}) to ({}, {})", from[0], from[1], to[0], to[1]);
                return self.fault(place, &format!("edge {a}-{b} from {at} {NO_GROUP}"));
            }
            self.at(place, in_numbers(cause, numbers, triangle))
        })?;
        Ok(mesh
            .with_numbers(tags.iter().map(|&tag| tag as usize).collect())
            .with_remarks(self.remarks()?))
    }

    /// The coordinates of nodes in the plane of the body.
    fn plane(&self, tags: &[u64]) -> Result<Vec<Point>> {
        let places: Vec<(usize, [f64; 3])> = tags.iter().map(|tag| self.nodes[tag]).collect();
        let size = places.iter().flat_map(|(_, place)| place).fold(0.0, |m: f64, x| m.max(x.abs()));
        let off = |place: &[f64; 3]| (place[2] - places[0].1[2]).abs() > FLAT * size;
        if let Some(node) = places.iter().position(|(_, place)| off(place)) {
            let reason = "has a different z: the body must lie in a plane z = const";
            let cause = ToolkitError::Node { node: tags[node] as usize, reason };
            return Err(self.at(places[node].0, Error::Toolkit(cause)));
        }
        Ok(places.iter().map(|&(_, [x, y, _])| [x, y]).collect())
    }

    /// The place of an invalid node, edge or triangle; node k has the k-th tag.
    fn place_of(&self, cause: &Error, tags: &[u64]) -> Option<usize> {
        match *cause {
            Error::Toolkit(ToolkitError::Triangle { triangle, .. }) => {
                Some(self.triangles.get(triangle)?.place)
            }
            Error::Toolkit(ToolkitError::Node { node, .. }) => {
                Some(self.nodes.get(tags.get(node)?)?.0)
            }
            Error::Toolkit(ToolkitError::Edge { nodes: [a, b], .. }) => {
                let ends = [*tags.get(a)?, *tags.get(b)?];
                let label = self.lines.iter().rfind(|edge| edge.has(ends));
                label
                    .or_else(|| self.triangles.iter().rfind(|t| t.has(ends)))
                    .map(|element| element.place)
            }
            _ => None,
        }
    }

    /// The name of a physical group; its tag if it has none.
    fn name(&self, dimension: i32, group: i64) -> String {
        let named = self.names.get(&(dimension, group));
        let named = named.or_else(|| self.names.get(&(Self::ANY_DIMENSION, group)));
        named.cloned().unwrap_or_else(|| group.to_string())
    }

    /// The physical group of a line or a triangle.
    ///
    /// # Errors
    /// An entity in several groups. Groups that Gmsh makes of the parts of a partition do not count.
    fn group(&self, dimension: i32, element: &Element) -> Result<Option<i64>> {
        if element.group != 0 {
            return Ok(Some(element.group));
        }
        let all = self.groups.get(&(dimension, element.entity)).map_or(&[][..], |groups| groups);
        let own = |group: &&i64| {
            !self.names.get(&(dimension, **group)).is_some_and(|n| n.starts_with("_part"))
        };
        let mut groups: Vec<i64> = all.iter().filter(own).copied().collect();
        groups.dedup();
        match groups[..] {
            [] => Ok(None),
            [group] => Ok(Some(group)),
            [one, two, ..] => Err(self.in_two(dimension, element, [one, two])),
        }
    }

    fn in_two(&self, dimension: i32, element: &Element, groups: [i64; 2]) -> Error {
        let what = if dimension == 1 { "curve" } else { "surface" };
        let [one, two] = groups.map(|group| crate::text::quoted(&self.name(dimension, group)));
        let why = format!(
            "{what} {} is in the physical groups {one} and {two}: it must be in one",
            element.entity
        );
        self.fault(element.place, &why)
    }

    /// Refuses an entity in two groups where format 2 lists its elements once for each of them, and a triangle that is
    /// listed twice. (An edge that is listed twice in one group is refused with all others.)
    fn refuse_doubles(&self) -> Result<()> {
        for (dimension, elements) in [(1, &self.lines), (2, &self.triangles)] {
            let mut known: HashMap<[u64; 3], &Element> = HashMap::new();
            for element in elements {
                let mut nodes = element.nodes;
                nodes.sort_unstable();
                let Some(before) = known.insert(nodes, element) else { continue };
                match (self.group(dimension, before)?, self.group(dimension, element)?) {
                    (Some(one), Some(two)) if one != two => {
                        return Err(self.in_two(dimension, element, [one, two]));
                    }
                    _ if dimension == 2 => {
                        let why = format!(
                            "triangle {} has the corners of triangle {}",
                            element.tag, before.tag
                        );
                        return Err(self.fault(element.place, &why));
                    }
                    _ => {}
                }
            }
        }
        Ok(())
    }

    /// The region of every triangle, numbered from 0 in ascending order of the tags of the surface groups, and the
    /// names of the groups.
    fn regions(&self) -> Result<(Vec<u32>, Vec<String>)> {
        let of: Vec<Option<i64>> =
            self.triangles.iter().map(|triangle| self.group(2, triangle)).collect::<Result<_>>()?;
        let mut groups = of.clone();
        groups.sort_unstable();
        groups.dedup();
        let name = |group: &Option<i64>| match group {
            Some(group) => self.name(2, *group),
            None if groups.len() == 1 => "body".to_owned(),
            None => "rest".to_owned(),
        };
        let names = groups.iter().map(name).collect();
        Ok((
            of.iter().map(|found| groups.partition_point(|other| other < found) as u32).collect(),
            names,
        ))
    }

    /// What is read by its corners only, and the physical groups that are not used.
    fn remarks(&self) -> Result<Vec<String>> {
        let mut remarks = Vec::new();
        if self.higher {
            remarks.push(
                "elements of higher order are read by their corners: curved edges become straight"
                    .to_owned(),
            );
        }
        let used = |dimension: i32, elements: &[Element]| -> Result<BTreeSet<i64>> {
            let groups = elements.iter().map(|element| self.group(dimension, element));
            Ok(groups.collect::<Result<Vec<_>>>()?.into_iter().flatten().collect())
        };
        let used = [used(1, &self.lines)?, used(2, &self.triangles)?];
        let of_points = self.points.iter().flat_map(|&(entity, group)| match group {
            0 => self.groups.get(&(0, entity)).cloned().unwrap_or_default(),
            group => vec![group],
        });
        let unnamed = of_points.map(|group| (0, group)).filter(|key| !self.names.contains_key(key));
        let groups: BTreeSet<(i32, i64)> = self.names.keys().copied().chain(unnamed).collect();
        for (dimension, group) in groups {
            let name = crate::text::quoted(&self.name(dimension, group));
            match dimension {
                0 => remarks
                    .push(format!("Physical Point {name} is not used: conditions hold on curves")),
                1 | 2 if !used[dimension as usize - 1].contains(&group) => {
                    let what = if dimension == 1 { "Curve" } else { "Surface" };
                    remarks.push(format!("Physical {what} {name} is not used: it has no elements"));
                }
                3 => remarks.push(format!("Physical Volume {name} is not used: the body is plane")),
                _ => {}
            }
        }
        remarks.retain(|remark| !remark.contains("'_part"));
        Ok(remarks)
    }
}

/// Six significant digits.
fn short(x: f64) -> f64 {
    format!("{x:.5e}").parse().unwrap_or(x)
}
