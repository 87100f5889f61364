//! Triangulations for the norms in the plane: nodes and triangles, without boundary data.

use super::geometry::{Point, twice_area};
use super::overlap::overlapping;
use crate::error::{Error, Result};
use crate::numeric::check::require_finite_at;
use crate::numeric::check::require_memory;
use std::collections::HashMap;

/// Bytes per square of a grid: a node, two triangles, and three edges in the table that checks them.
const BYTES_OF_SQUARE: usize = 300;

/// A triangulation of a polygon.
///
/// # Method
///
/// Triangles meet only in whole edges or at nodes, which they share by number, and do not overlap. Either
/// orientation is allowed. Coordinates may have any size from 1e-100 to 1e100.
#[doc(alias("mesh", "triangulation"))]
#[derive(Debug, Clone, PartialEq)]
pub struct Triangles {
    nodes: Vec<[f64; 2]>,
    triangles: Vec<[usize; 3]>,
    areas: Vec<f64>,
}

impl Triangles {
    /// The triangulation with the given nodes and the three node numbers of each triangle.
    ///
    /// ```
    /// use fractional_sobolev::Triangles;
    /// let corners = vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    /// let square = Triangles::new(&corners, &[[0, 1, 2], [0, 2, 3]])?;
    /// assert_eq!(square.areas(), [0.5, 0.5]);
    /// # Ok::<(), fractional_sobolev::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::CountOutOfRange`] without triangles, [`Error::NotFinite`] for a coordinate, [`Error::Triangle`]
    /// for a node number out of range or a triangle whose area is zero, underflows or overflows,
    /// [`Error::Edge`] for an edge of more than two triangles, [`Error::Overlap`] for two triangles with
    /// interior points in common.
    pub fn new(nodes: &[[f64; 2]], triangles: &[[usize; 3]]) -> Result<Self> {
        if triangles.is_empty() {
            return Err(Error::CountOutOfRange { name: "triangles", value: 0, range: "[1, inf)" });
        }
        for (index, node) in nodes.iter().enumerate() {
            node.iter().try_for_each(|&x| require_finite_at("coordinate", index, x))?;
        }
        let mut edges: HashMap<[usize; 2], usize> = HashMap::new();
        let mut areas = Vec::with_capacity(triangles.len());
        for (triangle, corners) in triangles.iter().enumerate() {
            if let Some(&node) = corners.iter().find(|&&node| node >= nodes.len()) {
                return Err(Error::Triangle {
                    triangle,
                    reason: "refers to a node that does not exist:",
                    value: node as f64,
                });
            }
            let [a, b, c] = *corners;
            let twice = twice_area(nodes[a], nodes[b], nodes[c]).abs();
            if !(twice >= f64::MIN_POSITIVE && twice.is_finite()) {
                return Err(Error::Triangle {
                    triangle,
                    reason: "is degenerate, or its area overflows: twice its area is",
                    value: twice,
                });
            }
            areas.push(0.5 * twice);
            for (a, b) in [(a, b), (b, c), (c, a)] {
                let ends = [a.min(b), a.max(b)];
                let count = edges.entry(ends).or_insert(0);
                *count += 1;
                if *count > 2 {
                    return Err(Error::Edge {
                        nodes: ends,
                        reason: "belongs to more than two triangles",
                    });
                }
            }
        }
        let corners: Vec<[Point; 3]> =
            triangles.iter().map(|triangle| triangle.map(|node| nodes[node])).collect();
        match overlapping(&corners) {
            Some(triangles) => Err(Error::Overlap { triangles }),
            None => Ok(Self { nodes: nodes.to_vec(), triangles: triangles.to_vec(), areas }),
        }
    }

    /// The triangulation of (0, n₁ h) × (0, n₂ h) by n₁ × n₂ squares, each cut from bottom left to top
    /// right.
    ///
    /// ```
    /// use fractional_sobolev::{Function, Triangles, closed_forms};
    /// let mesh = Triangles::grid([8, 8], 0.125)?;
    /// let x: Vec<f64> = mesh.nodes().iter().map(|p| p[0]).collect();
    /// let seminorm = Function::on_triangles(&mesh, 1, &x)?.seminorm(0.5, 1e-8)?.value;
    /// let exact = closed_forms::coordinate_on_square_seminorm_squared(0.5)?.value;
    /// assert!((seminorm.powi(2) / exact - 1.0).abs() < 1e-7);
    /// assert!(mesh.nodes().len() == 81);
    /// # Ok::<(), fractional_sobolev::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::CountOutOfRange`] for a grid without squares, [`Error::TooLarge`] if the memory does not
    /// suffice, [`Error::OutOfRange`] unless h > 0; as [`Triangles::new`].
    pub fn grid(squares: [usize; 2], h: f64) -> Result<Self> {
        Error::require("h", h, "(0, inf)", h > 0.0 && h.is_finite())?;
        let [columns, rows] = squares;
        if columns == 0 || rows == 0 {
            return Err(Error::CountOutOfRange { name: "squares", value: 0, range: "[1, inf)" });
        }
        require_memory("squares", columns.saturating_mul(rows), BYTES_OF_SQUARE)?;
        let node = |i: usize, j: usize| j * (columns + 1) + i;
        let places =
            (0..=rows).flat_map(|j| (0..=columns).map(move |i| [i as f64 * h, j as f64 * h]));
        let pair = |i: usize, j: usize| {
            let [a, b, c, d] = [node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)];
            [[a, b, c], [a, c, d]]
        };
        let triangles: Vec<_> =
            (0..rows).flat_map(|j| (0..columns).flat_map(move |i| pair(i, j))).collect();
        Self::new(&places.collect::<Vec<_>>(), &triangles)
    }

    /// The triangulation of the polygon with vertices 0, P_1, ..., P_m by the triangles 0 P_k P_{k+1}; node 0
    /// is the origin.
    ///
    /// # Errors
    /// As [`Triangles::new`].
    pub fn star(points: &[[f64; 2]]) -> Result<Self> {
        let nodes = std::iter::once([0.0; 2]).chain(points.iter().copied()).collect::<Vec<_>>();
        Self::new(&nodes, &(1..points.len()).map(|k| [0, k, k + 1]).collect::<Vec<_>>())
    }

    /// The refined triangulation in which every triangle at a node is divided into three: a copy at that
    /// node, scaled by the factor `share` < 1, and two triangles that fill the rest.
    ///
    /// ```
    /// use fractional_sobolev::Triangles;
    /// let wedge = Triangles::star(&[[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0]])?;
    /// assert_eq!(wedge.cut_at(0, 0.5)?.areas(), [0.125, 0.25, 0.125, 0.125, 0.25, 0.125]);
    /// # Ok::<(), fractional_sobolev::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless 0 < share < 1; as [`Triangles::new`].
    pub fn cut_at(&self, node: usize, share: f64) -> Result<Self> {
        Error::require("share", share, "(0, 1)", share > 0.0 && share < 1.0)?;
        let (mut nodes, mut triangles) = (self.nodes.clone(), Vec::new());
        let mut middles: HashMap<usize, usize> = HashMap::new();
        for corners in &self.triangles {
            let Some(at) = corners.iter().position(|&corner| corner == node) else {
                triangles.push(*corners);
                continue;
            };
            let ends = [corners[(at + 1) % 3], corners[(at + 2) % 3]];
            let [p, q] = ends.map(|end| {
                *middles.entry(end).or_insert_with(|| {
                    let (a, b) = (self.nodes[node], self.nodes[end]);
                    nodes.push([a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1])]);
                    nodes.len() - 1
                })
            });
            triangles.extend([[node, p, q], [p, ends[0], ends[1]], [p, ends[1], q]]);
        }
        Self::new(&nodes, &triangles)
    }

    /// The same triangulation with its nodes moved by a map.
    ///
    /// ```
    /// use fractional_sobolev::Triangles;
    /// let sheared = Triangles::grid([2, 2], 0.5)?.mapped(|[x, y]| [x + y, y])?;
    /// assert!(sheared.nodes()[8] == [2.0, 1.0] && sheared.triangles().len() == 8);
    /// assert!((sheared.areas().iter().sum::<f64>() - 1.0).abs() < 1e-15);
    /// # Ok::<(), fractional_sobolev::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`Triangles::new`] for the moved nodes.
    pub fn mapped(&self, map: impl FnMut([f64; 2]) -> [f64; 2]) -> Result<Self> {
        Self::new(&self.nodes.iter().copied().map(map).collect::<Vec<_>>(), &self.triangles.clone())
    }

    /// The coordinates of the nodes.
    pub fn nodes(&self) -> &[[f64; 2]] {
        &self.nodes
    }

    /// The node numbers of the triangles.
    pub fn triangles(&self) -> &[[usize; 3]] {
        &self.triangles
    }

    /// The area of every triangle.
    pub fn areas(&self) -> &[f64] {
        &self.areas
    }

    /// The area of the polygon.
    pub(crate) fn area(&self) -> f64 {
        self.areas.iter().sum()
    }

    pub(super) fn corners(&self, triangle: usize) -> [Point; 3] {
        self.triangles[triangle].map(|node| self.nodes[node])
    }

    /// The size of the polygon: the longer side of its bounding box.
    pub(super) fn extent(&self) -> f64 {
        let span = |k: usize| {
            let of = |node: &usize| self.nodes[*node][k];
            let ends = self.triangles.iter().flatten().map(of);
            ends.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| {
                (low.min(x), high.max(x))
            })
        };
        let ((left, right), (bottom, top)) = (span(0), span(1));
        (right - left).max(top - bottom)
    }
}
