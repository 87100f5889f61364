//! Triangulations of polygons: labelled boundaries, nested refinement, Gmsh files, rings graded toward a point, and
//! the contact edge as an ordered chain.

mod bisection;
mod check;
mod contact_edge;
mod edges;
mod geometry;
mod grid;
mod hierarchy;
mod msh;
mod rings;
mod structured;
mod triangulation;

pub use contact_edge::ContactEdge;
pub(crate) use edges::Edges;
pub use geometry::{BoundaryEdge, Part, Point};
pub(crate) use geometry::{distance, doubled_area, middle};
pub(crate) use grid::Grid;
pub use hierarchy::Hierarchy;
pub use msh::{parse_msh, read_msh};
pub use rings::{Outline, polar_rings};
pub use structured::{SideParts, mapped_grid, rectangles, unit_square, unit_squares};
pub use triangulation::Triangulation;
