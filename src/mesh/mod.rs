//! Triangulations of polygons: labelled boundary, nested refinement, the contact edge as an ordered chain.

mod check;
mod contact_edge;
mod hierarchy;
mod structured;
mod triangulation;

pub use contact_edge::ContactEdge;
pub use hierarchy::Hierarchy;
pub use structured::{Sides, mapped_grid, rectangles, unit_square};
pub use triangulation::{BoundaryEdge, Part, Point, Triangulation};
pub(crate) use triangulation::{distance, doubled_area};
