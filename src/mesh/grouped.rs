//! A triangulation from triangles and edges with the names of their groups, as mesh files hold them.

use super::check::NO_LABEL;
use super::geometry::{BoundaryEdge, Part, Point, doubled_area};
use super::names::Interface;
use super::triangulation::Triangulation;
use crate::error::{Error, Result, ToolkitError};
use std::collections::BTreeSet;

/// Triangles and named edges; nodes may be in no triangle, triangles in either orientation, edges inside the body.
pub(super) struct Grouped<'a> {
    pub(super) nodes: &'a [Point],
    pub(super) triangles: &'a [[usize; 3]],
    /// The region of every triangle.
    pub(super) regions: &'a [u32],
    pub(super) region_names: Vec<String>,
    /// Edges with the names of their groups.
    pub(super) edges: &'a [([usize; 2], &'a str)],
    /// The boundary part of groups whose name does not state it.
    pub(super) parts: &'a [(&'a str, Part)],
}

/// An error in the numbers of the given nodes and triangles, and the position of the edge it is about.
type Fault = (Error, Option<usize>);

impl Triangulation {
    /// The triangulation with these triangles and named edges, as they are in a mesh file.
    ///
    /// Triangles may be listed in either orientation; nodes in no triangle are omitted. `regions` has the name of the
    /// region of every triangle, or is empty; regions are numbered in the order in which their names appear. An edge
    /// on the boundary is clamped, free or in contact as the name of its group states, case-insensitively, up to the
    /// first blank, `_` or `-`: `clamped`, `fixed`, `dirichlet`; `free`, `neumann`; `contact`. Groups with other names
    /// are listed in `parts`. Edges inside are an [`Interface`].
    ///
    /// ```
    /// use signorini::mesh::{Part, Triangulation};
    /// let nodes = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    /// let edges = [([0, 1], "floor"), ([1, 2], "free"), ([2, 3], "clamped"), ([3, 0], "free"), ([0, 2], "weld")];
    /// let floor = [("floor", Part::Contact)];
    /// let mesh = Triangulation::from_groups(&nodes, &[[0, 1, 2], [0, 3, 2]], &[], &edges, &floor)?;
    /// assert_eq!((mesh.groups().len(), &*mesh.interfaces()[0].name), (3, "weld"));
    /// assert_eq!(mesh.remarks(), ["1 of 2 triangles is listed clockwise and was turned"]);
    /// # Ok::<(), signorini::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`ToolkitError::UnknownName`](crate::ToolkitError::UnknownName) for a group on the boundary whose part is not
    /// known, or whose name states another part than `parts`, or two parts of one group in `parts`,
    /// [`Error::NoGroup`](crate::Error::NoGroup) for a name in `parts` without an edge,
    /// [`ToolkitError::Edge`](crate::ToolkitError::Edge) for a contact or clamped edge inside the body, and those of
    /// [`Triangulation::new`].
    pub fn from_groups(
        nodes: &[Point],
        triangles: &[[usize; 3]],
        regions: &[&str],
        edges: &[([usize; 2], &str)],
        parts: &[(&str, Part)],
    ) -> Result<Self> {
        let body = vec!["body"; triangles.len()];
        let of = if regions.is_empty() { &body[..] } else { regions };
        crate::numeric::check::require_length("regions", of.len(), triangles.len())?;
        let (region_names, regions) = super::names::Names::numbered(of);
        let grouped = Grouped { nodes, triangles, regions: &regions, region_names, edges, parts };
        grouped.triangulation().map_err(|(cause, _)| cause)
    }
}

impl Grouped<'_> {
    /// The triangulation. Cost: O(N log N) for N triangles.
    pub(super) fn triangulation(self) -> std::result::Result<Triangulation, Fault> {
        let whole = |cause: ToolkitError| (Error::Toolkit(cause), None);
        let mut used = vec![false; self.nodes.len()];
        for (triangle, corners) in self.triangles.iter().enumerate() {
            for &node in corners {
                let reason = "refers to a node that does not exist:";
                *used.get_mut(node).ok_or_else(|| {
                    whole(ToolkitError::Triangle { triangle, reason, value: node as f64 })
                })? = true;
            }
        }
        let numbers: Vec<usize> = (0..self.nodes.len()).filter(|&node| used[node]).collect();
        let place = |node: usize| numbers.binary_search(&node).unwrap_or_default();
        let nodes: Vec<Point> = numbers.iter().map(|&node| self.nodes[node]).collect();
        let mut triangles: Vec<[usize; 3]> = self.triangles.iter().map(|t| t.map(place)).collect();
        let turned = turn_clockwise(&mut triangles, &nodes);
        let (boundary, names, interfaces) = self.sorted_edges(place)?;
        let in_given = |cause: Error| (in_numbers(cause, |node| numbers[node], |t| t), None);
        let mesh = Triangulation::new(&nodes, &triangles, &boundary)
            .map_err(|cause| in_given(say_group(cause)))?;
        let mut remarks = Vec::new();
        if turned > 0 && turned < triangles.len() {
            let are = if turned == 1 {
                "is listed clockwise and was"
            } else {
                "are listed clockwise and were"
            };
            remarks.push(format!("{turned} of {} triangles {are} turned", triangles.len()));
        }
        let named = || {
            let mesh = mesh.with_groups(&names)?.with_interfaces(interfaces).with_remarks(remarks);
            let is_one = self.regions.iter().all(|&region| region == 0);
            let mesh = if is_one { mesh } else { mesh.with_regions(self.regions)? };
            let regions: Vec<&str> = self.region_names.iter().map(|name| &**name).collect();
            let mesh = mesh.with_region_names(&regions)?;
            let all = numbers.len() == self.nodes.len();
            Ok(if all { mesh } else { mesh.with_numbers(numbers) })
        };
        named().map_err(|cause| (cause, None))
    }

    /// The boundary edges with the names of their groups, and the curves inside.
    #[allow(clippy::type_complexity)] // used once
    fn sorted_edges(
        &self,
        place: impl Fn(usize) -> usize,
    ) -> std::result::Result<(Vec<BoundaryEdge>, Vec<&str>, Vec<Interface>), Fault> {
        for &(name, _) in self.parts {
            if !self.edges.iter().any(|&(_, group)| same(group, name)) {
                let known: BTreeSet<&str> = self.edges.iter().map(|&(_, group)| group).collect();
                let known = known.into_iter().take(20).collect::<Vec<_>>().join(", ");
                let given = name.to_owned();
                return Err((Error::NoGroup { what: "boundary group", given, known }, None));
            }
        }
        for (k, &(name, part)) in self.parts.iter().enumerate() {
            let before = self.parts[..k].iter().find(|&&(one, of)| same(one, name) && of != part);
            if let Some(&(_, before)) = before {
                let both = format!("{} and {}", before.name(), part.name());
                let expected =
                    "one of them: a displacement clamps, a gap is a floor, a traction leaves free";
                return Err((part_of_group(&both, name, expected), None));
            }
        }
        let key = |[a, b]: [usize; 2]| [a.min(b), a.max(b)];
        let mut sides: Vec<[usize; 2]> = self
            .triangles
            .iter()
            .flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]])
            .map(key)
            .collect();
        sides.sort_unstable();
        let (mut boundary, mut names, mut interfaces) =
            (Vec::new(), Vec::new(), Vec::<Interface>::new());
        for (row, &(nodes, name)) in self.edges.iter().enumerate() {
            let bad =
                |reason| Err((Error::Toolkit(ToolkitError::Edge { nodes, reason }), Some(row)));
            let first = sides.partition_point(|side| *side < key(nodes));
            let triangles = sides[first..].iter().take_while(|side| **side == key(nodes)).count();
            let part = self.part(name).map_err(|cause| (cause, Some(row)));
            if triangles == 0 {
                return bad("is in a group but belongs to no triangle");
            }
            let nodes = nodes.map(&place);
            if triangles > 1 {
                match part {
                    Ok(Part::Dirichlet | Part::Contact) => {
                        return bad(
                            "is inside the body: its group must not be called clamped or contact",
                        );
                    }
                    _ => match interfaces.iter_mut().find(|interface| interface.name == name) {
                        Some(interface) => interface.edges.push(nodes),
                        None => {
                            interfaces.push(Interface { name: name.to_owned(), edges: vec![nodes] })
                        }
                    },
                }
                continue;
            }
            boundary.push(BoundaryEdge { nodes, part: part? });
            names.push(name);
        }
        Ok((boundary, names, interfaces))
    }

    /// The boundary part of a group.
    fn part(&self, name: &str) -> Result<Part> {
        let given = self.parts.iter().find(|(group, _)| same(group, name)).map(|&(_, part)| part);
        match (given, Part::named(name)) {
            (Some(given), Some(named)) if given != named => {
                Err(part_of_group(given.name(), name, "the part that the name of the group states"))
            }
            (Some(part), _) | (None, Some(part)) => Ok(part),
            (None, None) => Err(Error::Toolkit(ToolkitError::UnknownName {
                what: "boundary part",
                given: name.chars().take(40).collect(),
                expected: "clamped (fixed, dirichlet), contact or free (neumann), alone or in front, as in 'free top'; \
                           under another name by what acts there: a displacement (0 clamps), a gap (0 is a \
                           floor), a traction (0 is free)",
            })),
        }
    }
}

/// The error for parts that a group cannot be.
fn part_of_group(parts: &str, name: &str, expected: &'static str) -> Error {
    let name: String = name.chars().take(40).collect();
    let given = format!("{parts} for the group {name}");
    Error::Toolkit(ToolkitError::UnknownName { what: "boundary part", given, expected })
}

/// Whether two names of groups are the same, up to capital letters.
fn same(a: &str, b: &str) -> bool {
    a.to_lowercase() == b.to_lowercase()
}

/// Turns the triangles that are listed clockwise; their number.
///
/// A mesh that is folded remains inconsistent: the two triangles at an edge of the fold then lie on the same side of
/// it, which the check of the edges refuses.
fn turn_clockwise(triangles: &mut [[usize; 3]], nodes: &[Point]) -> usize {
    let is_clockwise = |corners: &[usize; 3]| doubled_area(corners.map(|node| nodes[node])) < 0.0;
    let clockwise = triangles.iter_mut().filter(|corners| is_clockwise(corners));
    clockwise.map(|corners| corners.swap(1, 2)).count()
}

/// Why an edge of the boundary without a group is refused.
pub(super) const NO_GROUP: &str = "is on the boundary but in no physical group: add its curve to one named clamped, contact or free";

/// What to do about a boundary edge without a group.
fn say_group(cause: Error) -> Error {
    match cause {
        Error::Toolkit(ToolkitError::Edge { nodes, reason }) if reason == NO_LABEL => {
            Error::Toolkit(ToolkitError::Edge { nodes, reason: NO_GROUP })
        }
        other => other,
    }
}

/// An error about a node, an edge or a triangle with other numbers of nodes and triangles.
pub(super) fn in_numbers(
    error: Error,
    node_number: impl Fn(usize) -> usize,
    triangle_number: impl Fn(usize) -> usize,
) -> Error {
    let Error::Toolkit(cause) = error else { return error };
    Error::Toolkit(match cause {
        ToolkitError::Node { node, reason } => {
            ToolkitError::Node { node: node_number(node), reason }
        }
        ToolkitError::Edge { nodes, reason } => {
            ToolkitError::Edge { nodes: nodes.map(node_number), reason }
        }
        ToolkitError::Triangle { triangle, reason, value } => {
            ToolkitError::Triangle { triangle: triangle_number(triangle), reason, value }
        }
        other => other,
    })
}
