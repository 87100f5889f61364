//! Conforming triangulations of polygons with labelled boundary edges.
//!
//! Triangles are listed counterclockwise, boundary edges with the domain on their left, so that the outward
//! normal of an edge from a to b is (b_y − a_y, a_x − b_x)/|b − a|. Every edge on the boundary carries
//! exactly one label. Checks cost O(N log N) for N triangles; triangulations made by this library are built
//! without them.

use super::check;
use super::geometry::{BoundaryEdge, Part, Point, distance};
use crate::error::{Error, Result, ToolkitError};

/// A conforming triangulation with labelled boundary.
#[derive(Debug, Clone, PartialEq)]
pub struct Triangulation {
    nodes: Vec<Point>,
    triangles: Vec<[usize; 3]>,
    boundary: Vec<BoundaryEdge>,
    regions: Vec<u32>,
    /// The numbers of the nodes in the source file; empty for their indices.
    numbers: Vec<usize>,
}

impl Triangulation {
    /// A checked triangulation. Boundary edges may be given in either direction.
    ///
    /// ```
    /// use signorini::mesh::{BoundaryEdge, Part, Triangulation};
    /// let side = |nodes, part| BoundaryEdge { nodes, part };
    /// let (bottom, top) = (side([0, 1], Part::Contact), side([1, 2], Part::Neumann));
    /// let sides = vec![bottom, top, side([2, 0], Part::Dirichlet)];
    /// let mesh = Triangulation::new(vec![[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]], vec![[0, 1, 2]], sides)?;
    /// assert_eq!(mesh.mesh_size(), 2f64.sqrt());
    /// # Ok::<(), signorini::Error>(())
    /// ```
    ///
    /// # Errors
    /// The invalid node, triangle or edge: coordinates that are not finite, node numbers out of range,
    /// triangles that are inverted or without area, edges shared by more than two triangles, labels on
    /// inner edges, boundary edges without a label or with two, nodes in no triangle.
    pub fn new(nodes: Vec<Point>, triangles: Vec<[usize; 3]>, boundary: Vec<BoundaryEdge>) -> Result<Self> {
        let mut mesh = Self::trusted(nodes, triangles, boundary);
        check::nodes_and_triangles(&mesh.nodes, &mesh.triangles)?;
        check::boundary(&mut mesh.boundary, &mesh.triangles)?;
        Ok(mesh)
    }

    /// Without checks, for triangulations built by this library.
    pub(super) fn trusted(
        nodes: Vec<Point>,
        triangles: Vec<[usize; 3]>,
        boundary: Vec<BoundaryEdge>,
    ) -> Self {
        Self { nodes, triangles, boundary, regions: Vec::new(), numbers: Vec::new() }
    }

    /// The same triangulation with a region number on every triangle (for piecewise constant materials).
    ///
    /// ```
    /// use signorini::mesh::{SideParts, unit_square};
    /// let mesh = unit_square(1, SideParts::HANGING)?;
    /// assert_eq!((mesh.region(1), mesh.clone().with_regions(vec![0, 3])?.region(1)), (0, 3));
    /// assert!(mesh.with_regions(vec![0]).is_err());
    /// # Ok::<(), signorini::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`ToolkitError::LengthMismatch`](crate::ToolkitError::LengthMismatch) unless there is one number per triangle.
    pub fn with_regions(mut self, regions: Vec<u32>) -> Result<Self> {
        if regions.len() != self.triangles.len() {
            return Err(Error::Toolkit(ToolkitError::LengthMismatch {
                name: "regions",
                given: regions.len(),
                expected: self.triangles.len(),
            }));
        }
        self.regions = regions;
        Ok(self)
    }

    /// The same triangulation with these node numbers in its errors.
    pub(super) fn with_numbers(self, numbers: Vec<usize>) -> Self {
        Self { numbers, ..self }
    }

    /// The number of a node in the file it was read from; its index without a file.
    pub(crate) fn number(&self, node: usize) -> usize {
        self.numbers.get(node).copied().unwrap_or(node)
    }

    /// An error about a node or an edge, by the numbers of the file.
    pub(super) fn in_own_numbers(&self, error: Error) -> Error {
        in_numbers(error, |node| self.number(node))
    }

    /// For every node the smallest node that a chain of triangles with common nodes joins it to. Cost: O(N log N) at most.
    pub(crate) fn bodies(&self) -> Vec<usize> {
        let mut parents: Vec<usize> = (0..self.nodes.len()).collect();
        let root = |parents: &mut Vec<usize>, mut node: usize| {
            while parents[node] != node {
                parents[node] = parents[parents[node]];
                node = parents[node];
            }
            node
        };
        for &[a, b, c] in &self.triangles {
            for (from, to) in [(a, b), (b, c)] {
                let (from, to) = (root(&mut parents, from), root(&mut parents, to));
                parents[from.max(to)] = from.min(to);
            }
        }
        (0..self.nodes.len()).map(|node| root(&mut parents, node)).collect()
    }

    /// The coordinates of the nodes.
    pub fn nodes(&self) -> &[Point] {
        &self.nodes
    }

    /// The triangles, counterclockwise.
    pub fn triangles(&self) -> &[[usize; 3]] {
        &self.triangles
    }

    /// The labelled boundary edges.
    ///
    /// In the order in which they were given, each turned so that the domain is on its left.
    pub fn boundary(&self) -> &[BoundaryEdge] {
        &self.boundary
    }

    /// The region of a triangle; 0 by default.
    pub fn region(&self, triangle: usize) -> usize {
        self.regions.get(triangle).map_or(0, |&region| region as usize)
    }

    /// The region numbers, empty when there is only region 0.
    pub fn regions(&self) -> &[u32] {
        &self.regions
    }

    /// The three corners of a triangle.
    ///
    /// In the order of [`Triangulation::triangles`], counterclockwise: the signed area of the triangle is positive.
    pub fn corners(&self, triangle: usize) -> [Point; 3] {
        self.triangles[triangle].map(|node| self.nodes[node])
    }

    /// The end points of an edge.
    ///
    /// ```
    /// use signorini::mesh::{Part, SideParts, unit_square};
    /// let mesh = unit_square(2, SideParts::HANGING)?;
    /// let length = |[a, b]: [[f64; 2]; 2]| (b[0] - a[0]).hypot(b[1] - a[1]);
    /// let contact = mesh.boundary().iter().filter(|edge| edge.part == Part::Contact);
    /// assert_eq!(contact.map(|edge| length(mesh.ends(edge))).sum::<f64>(), 1.0);
    /// # Ok::<(), signorini::Error>(())
    /// ```
    pub fn ends(&self, edge: &BoundaryEdge) -> [Point; 2] {
        edge.nodes.map(|node| self.nodes[node])
    }

    /// h: the longest edge.
    ///
    /// The largest diameter of a triangle, h in the estimates; halved exactly by a uniform refinement. Cost: O(triangles).
    pub fn mesh_size(&self) -> f64 {
        (0..self.triangles.len())
            .flat_map(|t| {
                let [a, b, c] = self.corners(t);
                [distance(a, b), distance(b, c), distance(c, a)]
            })
            .fold(0.0, f64::max)
    }

    /// True for every node on a boundary edge with the given label, end nodes included.
    ///
    /// ```
    /// use signorini::mesh::{Part, SideParts, unit_square};
    /// let mesh = unit_square(3, SideParts::HANGING)?;
    /// let on = mesh.nodes_on(Part::Contact);
    /// assert!(mesh.nodes().iter().zip(on).all(|(point, on)| on == (point[1] == 0.0)));
    /// # Ok::<(), signorini::Error>(())
    /// ```
    pub fn nodes_on(&self, part: Part) -> Vec<bool> {
        let mut on = vec![false; self.nodes.len()];
        for edge in self.boundary.iter().filter(|edge| edge.part == part) {
            edge.nodes.into_iter().for_each(|node| on[node] = true);
        }
        on
    }

    /// The same triangulation with its nodes moved by `map`, which must keep the orientation of every
    /// triangle.
    ///
    /// ```
    /// use signorini::mesh::{ContactEdge, SideParts, unit_square};
    /// let (sin, cos) = 0.3_f64.sin_cos();
    /// let turned = unit_square(2, SideParts::HANGING)?.mapped(|[x, y]| [cos * x - sin * y, sin * x + cos * y])?;
    /// assert!((ContactEdge::of(&turned)?.normal()?[0] - sin).abs() < 1e-15);
    /// # Ok::<(), signorini::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`ToolkitError::Triangle`](crate::ToolkitError::Triangle) with the first triangle that the map
    /// inverts or flattens.
    pub fn mapped(mut self, map: impl Fn(Point) -> Point) -> Result<Self> {
        self.nodes.iter_mut().for_each(|node| *node = map(*node));
        check::nodes_and_triangles(&self.nodes, &self.triangles)?;
        Ok(self)
    }
}

/// An error about a node or an edge with other numbers of the nodes.
pub(super) fn in_numbers(error: Error, number: impl Fn(usize) -> usize) -> Error {
    match error {
        Error::Toolkit(ToolkitError::Node { node, reason }) => {
            Error::Toolkit(ToolkitError::Node { node: number(node), reason })
        }
        Error::Toolkit(ToolkitError::Edge { nodes, reason }) => {
            Error::Toolkit(ToolkitError::Edge { nodes: nodes.map(number), reason })
        }
        other => other,
    }
}
