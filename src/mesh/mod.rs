//! Triangulations of polygons: labelled boundary, nested refinement, Gmsh files, the contact edge as an ordered chain.

mod bisection;
mod check;
mod contact_edge;
mod edges;
mod hierarchy;
mod msh;
mod structured;
mod triangulation;

pub use contact_edge::ContactEdge;
pub use hierarchy::Hierarchy;
pub use msh::{parse_msh, read_msh};
pub use structured::{Sides, mapped_grid, rectangles, unit_square};
pub use triangulation::{BoundaryEdge, Part, Point, Triangulation};
pub(crate) use triangulation::{distance, doubled_area};
