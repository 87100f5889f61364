//! Polygonal curves with a mesh on every side, and distances on them.
//!
//! A point is stored as its side and its distances from the two ends of the side. Two points on adjacent
//! sides at distances σ, τ from the common vertex have the distance √((σ−τ)² + στ |a−b|²), a and b the
//! directions of the sides from the vertex: no digits are lost near a corner of any angle.

use crate::error::{Error, Result};
use crate::grading::geometric_lengths;
use crate::mesh::Mesh;
use crate::numeric::check::{require_entry, require_finite_at, require_length};
use crate::numeric::scale::unit_of;

/// The boundary of a polygon, or an open polygonal curve, with a mesh on every side.
#[doc(alias("polygon", "boundary mesh", "BEM"))]
#[derive(Debug, Clone, PartialEq)]
pub struct Curve {
    vertices: Vec<[f64; 2]>,
    closed: bool,
    sides: Vec<Side>,
    /// side and index in the mesh of that side, for every element
    elements: Vec<(usize, usize)>,
}

/// A side with its direction and mesh.
#[derive(Debug, Clone, PartialEq)]
struct Side {
    start: [f64; 2],
    direction: [f64; 2],
    mesh: Mesh,
}

/// Relative position of two elements, with the data needed for their distances.
#[derive(Debug, Clone, Copy)]
pub(super) enum Relation {
    /// on the same side: distances along it
    Same,
    /// the first side ends where the second one begins; |a − b|²
    Before(f64),
    /// the second side ends where the first one begins
    After(f64),
    Apart,
}

impl Curve {
    /// The boundary of the polygon with the given vertices, in either orientation. Side k, which starts at
    /// vertex k, has the elements of `meshes[k]`, scaled to its length.
    ///
    /// ```
    /// use fractional_sobolev::{Mesh, Curve};
    /// let triangle = [[0.0, 0.0], [3.0, 0.0], [0.0, 4.0]];
    /// let graded = Mesh::algebraic(3, 2.0, 1.0)?;
    /// let meshes = [Mesh::uniform(2, 1.0)?, graded, Mesh::uniform(1, 1.0)?];
    /// let curve = Curve::closed(&triangle, &meshes)?;
    /// assert!(curve.len() == 6 && (curve.length() - 12.0).abs() < 1e-14);
    /// assert_eq!(curve.nodes()[1], [1.5, 0.0]);
    /// # Ok::<(), fractional_sobolev::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::CountOutOfRange`] for fewer than three vertices; [`Error::LengthMismatch`] unless there is
    /// one mesh per side; [`Error::NotFinite`] with the index of the vertex; [`Error::EntryOutOfRange`] with
    /// the index of a side of length zero, or of a vertex at which the curve turns back; [`Error::Edge`] for a
    /// side that meets another.
    pub fn closed(vertices: &[[f64; 2]], meshes: &[Mesh]) -> Result<Self> {
        Self::build(vertices, meshes, true)
    }

    /// The open polygonal curve through the given vertices: as [`Curve::closed`], without the side from the
    /// last vertex to the first.
    ///
    /// ```
    /// use fractional_sobolev::{Mesh, Curve};
    /// let corner = [[0.0, 1.0], [0.0, 0.0], [1.0, 0.0]];
    /// let mesh = Mesh::uniform(4, 1.0)?;
    /// let curve = Curve::open(&corner, &[mesh.clone(), mesh])?;
    /// assert!(curve.len() == 8 && curve.nodes().len() == 9);
    /// # Ok::<(), fractional_sobolev::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`Curve::closed`], with at least two vertices.
    pub fn open(vertices: &[[f64; 2]], meshes: &[Mesh]) -> Result<Self> {
        Self::build(vertices, meshes, false)
    }

    /// The closed curve with `count` elements on every side, graded towards both ends of a side of length ℓ: the
    /// distances of the nodes from the nearer end are (ℓ/2) (i/n)^β, n = `count`/2, β = `exponent`; all elements of a
    /// side are equal for β = 1. `count` must be even.
    ///
    /// ```
    /// use fractional_sobolev::Curve;
    /// let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    /// let curve = Curve::algebraic(&square, 4, 2.0)?;
    /// assert_eq!(curve.nodes()[1], [0.125, 0.0]);
    /// # Ok::<(), fractional_sobolev::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`Curve::closed`] and [`Mesh::algebraic`]; [`Error::CountOutOfRange`] for an odd
    /// count.
    pub fn algebraic(vertices: &[[f64; 2]], count: usize, exponent: f64) -> Result<Self> {
        if !count.is_multiple_of(2) {
            return Err(Error::CountOutOfRange {
                name: "elements per side",
                value: count,
                range: "{2, 4, 6, ...}",
            });
        }
        let mesh = Mesh::two_sided_algebraic(count / 2, exponent, 1.0)?;
        Self::closed(vertices, &vec![mesh; vertices.len()])
    }

    fn build(vertices: &[[f64; 2]], meshes: &[Mesh], closed: bool) -> Result<Self> {
        let least = if closed { 3 } else { 2 };
        if vertices.len() < least {
            let (value, range) = (vertices.len(), if closed { "[3, inf)" } else { "[2, inf)" });
            return Err(Error::CountOutOfRange { name: "vertices", value, range });
        }
        for (index, vertex) in vertices.iter().enumerate() {
            vertex.iter().try_for_each(|&value| require_finite_at("vertex", index, value))?;
        }
        let count = if closed { vertices.len() } else { vertices.len() - 1 };
        require_length("meshes of the sides", meshes.len(), count)?;
        let mut sides: Vec<Side> = Vec::with_capacity(count);
        for (k, mesh) in meshes.iter().enumerate() {
            let (start, end) = (vertices[k], vertices[(k + 1) % vertices.len()]);
            let length = distance(start, end);
            require_entry(
                "length of a side",
                k,
                length,
                "(0, inf)",
                length > 0.0 && length.is_finite(),
            )?;
            let share = length / mesh.total();
            let mesh =
                Mesh::from_lengths(&mesh.lengths().iter().map(|h| h * share).collect::<Vec<_>>())?;
            let direction = [(end[0] - start[0]) / length, (end[1] - start[1]) / length];
            sides.push(Side { start, direction, mesh });
        }
        let curve = Self { vertices: vertices.to_vec(), closed, elements: numbered(&sides), sides };
        curve.require_simple()?;
        Ok(curve)
    }

    /// Checks that consecutive sides do not turn back and that other sides do not meet.
    fn require_simple(&self) -> Result<()> {
        let count = self.sides.len();
        for i in 0..count {
            for j in i + 1..count {
                match self.relation(i, j) {
                    Relation::Before(bend) | Relation::After(bend) => {
                        let vertex = if j == i + 1 { j } else { i };
                        let name = "angle between the sides at a vertex";
                        require_entry(name, vertex, bend.sqrt(), "[1e-14, 2 pi)", bend >= 1e-28)?;
                    }
                    Relation::Apart if self.cross(i, j) => {
                        let nodes = [j, (j + 1) % self.vertices.len()];
                        return Err(Error::Edge {
                            nodes,
                            reason: "intersects another edge of the polygon",
                        });
                    }
                    _ => {}
                }
            }
        }
        Ok(())
    }

    fn cross(&self, i: usize, j: usize) -> bool {
        // In units of the curve, products of four coordinates stay in the range of binary64.
        let unit = unit_of(self.vertices.iter().flatten());
        let vertex = |k: usize| self.vertices[k % self.vertices.len()].map(|x| x / unit);
        let ([a, b], [c, d]) = ([vertex(i), vertex(i + 1)], [vertex(j), vertex(j + 1)]);
        let turn = |p: [f64; 2], q: [f64; 2], r: [f64; 2]| {
            (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])
        };
        let apart = |k: usize| a[k].max(b[k]) < c[k].min(d[k]) || c[k].max(d[k]) < a[k].min(b[k]);
        let sides = |p, q, r, s| turn(p, q, r) * turn(p, q, s);
        !apart(0) && !apart(1) && sides(a, b, c, d) <= 0.0 && sides(c, d, a, b) <= 0.0
    }

    /// The curve with every element bisected.
    pub(super) fn halved(&self) -> Result<Self> {
        let halves = |side: &Side| {
            let lengths =
                side.mesh.lengths().iter().flat_map(|h| [0.5 * h, 0.5 * h]).collect::<Vec<_>>();
            Ok(Side { mesh: Mesh::from_lengths(&lengths)?, ..side.clone() })
        };
        let sides: Vec<Side> = self.sides.iter().map(halves).collect::<Result<_>>()?;
        Ok(Self { elements: numbered(&sides), sides, ..self.clone() })
    }

    /// The number of elements.
    #[expect(clippy::len_without_is_empty, reason = "never empty")]
    pub fn len(&self) -> usize {
        self.elements.len()
    }

    /// True if the last side ends where the first begins.
    pub(super) fn is_closed(&self) -> bool {
        self.closed
    }

    /// The length of the curve.
    pub fn length(&self) -> f64 {
        self.sides.iter().map(|side| side.mesh.total()).sum()
    }

    /// The coordinates of the nodes in order, rounded: one per element on a closed curve, one more on an open
    /// one.
    pub fn nodes(&self) -> Vec<[f64; 2]> {
        let mut nodes: Vec<[f64; 2]> = Vec::with_capacity(self.len() + 1);
        for side in &self.sides {
            let before = side.mesh.from_left()[..side.mesh.len()].iter();
            nodes.extend(before.map(|&t| side.at(t)));
        }
        if !self.closed {
            nodes.extend(self.vertices.last());
        }
        nodes
    }

    /// The length of an element.
    pub(super) fn element_length(&self, e: usize) -> f64 {
        let (side, cell) = self.elements[e];
        self.sides[side].mesh.lengths()[cell]
    }

    /// The point at distance t from the left end of an element, as an argument of [`Curve::apart`].
    pub(super) fn place(&self, e: usize, t: f64) -> Place {
        let (side, cell) = self.elements[e];
        let mesh = &self.sides[side].mesh;
        let rest = mesh.lengths()[cell] - t;
        Place {
            side,
            from_start: mesh.from_left()[cell] + t,
            to_end: mesh.from_right()[cell + 1] + rest,
        }
    }

    /// The point of a side at a distance from its first (0) or its last vertex (1).
    pub(super) fn place_near(&self, side: usize, end: usize, distance: f64) -> Place {
        let rest = self.side_length(side) - distance;
        let [from_start, to_end] = if end == 0 { [distance, rest] } else { [rest, distance] };
        Place { side, from_start, to_end }
    }

    /// The curve with the first and the last element of every side graded towards its vertices, with `layers(side)` layers
    /// of the given ratio at both; every side needs two elements. For every element of the result the one it is part of.
    pub(super) fn graded_at_vertices(
        &self,
        ratio: f64,
        layers: impl Fn(usize) -> [usize; 2],
    ) -> Result<(Self, Vec<Part>)> {
        let (mut sides, mut parts, mut element) = (Vec::new(), Vec::new(), 0);
        for (k, side) in self.sides.iter().enumerate() {
            let [first, last] = layers(k);
            let (old, count) = (side.mesh.lengths(), side.mesh.len());
            let mut lengths = Vec::with_capacity(count + first + last);
            for (cell, &h) in old.iter().enumerate() {
                let (is_first, is_last) = (cell == 0, cell + 1 == count);
                let mut pieces = match (is_first, is_last) {
                    (true, _) => geometric_lengths(first, ratio, h)?,
                    (_, true) => geometric_lengths(last, ratio, h)?,
                    _ => vec![h],
                };
                if is_last && !is_first {
                    pieces.reverse();
                }
                let mut start = 0.0;
                for (j, piece) in pieces.iter().enumerate() {
                    let at_vertex =
                        is_first && j == 0 || is_last && !is_first && j + 1 == pieces.len();
                    parts.push(Part { element, start, at_vertex });
                    start += piece;
                }
                lengths.extend(pieces);
                element += 1;
            }
            sides.push(Side { mesh: Mesh::from_lengths(&lengths)?, ..side.clone() });
        }
        Ok((Self { elements: numbered(&sides), sides, ..self.clone() }, parts))
    }

    /// The coordinates of a point, computed from the nearer end of its side.
    pub(super) fn point(&self, place: Place) -> [f64; 2] {
        let side = &self.sides[place.side];
        if place.from_start <= place.to_end {
            return side.at(place.from_start);
        }
        let end = self.vertices[(place.side + 1) % self.vertices.len()];
        [0, 1].map(|k| end[k] - place.to_end * side.direction[k])
    }

    /// The distances by which rounding may move a point along its side near the first and the last vertex of the
    /// side: an ulp of the largest coordinate of the vertex that varies along the side.
    pub(super) fn blurs(&self, side: usize) -> [f64; 2] {
        [0, 1].map(|end| {
            let vertex = self.vertices[(side + end) % self.vertices.len()];
            let varying =
                vertex.iter().zip(self.sides[side].direction).filter(|(_, slope)| *slope != 0.0);
            f64::EPSILON * varying.fold(0.0, |most: f64, (x, _)| most.max(x.abs()))
        })
    }

    /// The length of a side.
    pub(super) fn side_length(&self, side: usize) -> f64 {
        self.sides[side].mesh.total()
    }

    /// The distance of a point from the first (0) or the last vertex (1) of its side.
    pub(super) fn distance_to_vertex(place: Place, end: usize) -> f64 {
        if end == 0 { place.from_start } else { place.to_end }
    }

    /// The lengths of the first and the last element of a side.
    pub(super) fn end_lengths(&self, side: usize) -> [f64; 2] {
        let lengths = self.sides[side].mesh.lengths();
        [lengths[0], lengths[lengths.len() - 1]]
    }

    /// The relative position of the sides of two elements.
    pub(super) fn relation_of(&self, e: usize, f: usize) -> Relation {
        self.relation(self.elements[e].0, self.elements[f].0)
    }

    fn relation(&self, i: usize, j: usize) -> Relation {
        let count = self.sides.len();
        let follows = |i: usize, j: usize| j == i + 1 || self.closed && i + 1 == count && j == 0;
        // Directions from the common vertex.
        let bend = |i: usize, j: usize| {
            let (a, b) = (self.sides[i].direction, self.sides[j].direction);
            (a[0] + b[0]).powi(2) + (a[1] + b[1]).powi(2)
        };
        if i == j {
            Relation::Same
        } else if follows(i, j) {
            Relation::Before(bend(i, j))
        } else if follows(j, i) {
            Relation::After(bend(j, i))
        } else {
            Relation::Apart
        }
    }

    /// The distance of two points in the plane.
    pub(super) fn apart(&self, relation: Relation, x: Place, y: Place) -> f64 {
        let around = |s: f64, t: f64, bend: f64| (s - t).hypot((s * t * bend).sqrt());
        match relation {
            // From the end that is nearer: short elements lie there.
            Relation::Same if x.from_start + y.from_start <= x.to_end + y.to_end => {
                (x.from_start - y.from_start).abs()
            }
            Relation::Same => (x.to_end - y.to_end).abs(),
            Relation::Before(bend) => around(x.to_end, y.from_start, bend),
            Relation::After(bend) => around(x.from_start, y.to_end, bend),
            Relation::Apart => {
                distance(self.sides[x.side].at(x.from_start), self.sides[y.side].at(y.from_start))
            }
        }
    }

    /// True if the end node of e is the first node of f.
    pub(super) fn follows(&self, e: usize, f: usize) -> bool {
        f == e + 1 || self.closed && e + 1 == self.len() && f == 0
    }

    /// The nodes at both ends of an element.
    pub(super) fn nodes_of(&self, e: usize) -> [usize; 2] {
        [e, if self.closed { (e + 1) % self.len() } else { e + 1 }]
    }
}

/// A part of an element: its distance from the start of the element, and whether it begins or ends at a vertex.
#[derive(Debug, Clone, Copy)]
pub(super) struct Part {
    pub(super) element: usize,
    pub(super) start: f64,
    pub(super) at_vertex: bool,
}

/// A point of a side by its distances to both ends.
#[derive(Debug, Clone, Copy)]
pub(super) struct Place {
    side: usize,
    from_start: f64,
    to_end: f64,
}

impl Side {
    fn at(&self, t: f64) -> [f64; 2] {
        [self.start[0] + t * self.direction[0], self.start[1] + t * self.direction[1]]
    }
}

/// Side and index in its mesh, for every element.
fn numbered(sides: &[Side]) -> Vec<(usize, usize)> {
    sides
        .iter()
        .enumerate()
        .flat_map(|(k, side)| (0..side.mesh.len()).map(move |e| (k, e)))
        .collect()
}

fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}
