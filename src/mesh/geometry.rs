//! Points, boundary edges with their labels, lengths and areas.

/// A point in the plane.
pub type Point = [f64; 2];

/// The boundary condition on an edge: the three open parts of Section 2.1.
///
/// The closures of the three parts cover ∂Ω; a node between edges of two parts belongs to both.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Part {
    /// Γ_D: prescribed displacement.
    Dirichlet,
    /// Γ_N: given surface load (zero by default).
    Neumann,
    /// Γ_C: unilateral contact without friction.
    Contact,
}

/// A boundary edge, oriented with the domain on its left.
///
/// The outward unit normal is (b_y − a_y, a_x − b_x)/|b − a| for `nodes` = [a, b].
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct BoundaryEdge {
    /// Start and end node.
    pub nodes: [usize; 2],
    /// The boundary condition on the edge.
    pub part: Part,
}

/// The Euclidean distance, without overflow.
pub(crate) fn distance(a: Point, b: Point) -> f64 {
    (b[0] - a[0]).hypot(b[1] - a[1])
}

/// Twice the signed area of a triangle, computed from differences with its first corner.
pub(crate) fn doubled_area([a, b, c]: [Point; 3]) -> f64 {
    (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1])
}

pub(crate) fn middle([a, b, c]: [Point; 3]) -> Point {
    [0, 1].map(|k| (a[k] + b[k] + c[k]) / 3.0)
}
