//! Triangulations of polygons: labelled boundaries, nested refinement, Gmsh files, rings graded toward a point, and
//! the contact edge as an ordered chain.

mod bisection;
mod check;
mod contact_edge;
mod edges;
mod geometry;
mod grid;
mod grouped;
mod hierarchy;
mod msh;
mod names;
mod rings;
mod structured;
mod triangulation;

pub use contact_edge::ContactEdge;
pub(crate) use edges::Edges;
pub use geometry::{BoundaryEdge, Part, Point};
pub(crate) use geometry::{distance, doubled_area, middle};
pub(crate) use grid::Grid;
pub use hierarchy::Hierarchy;
pub use msh::{parse_msh, parse_msh_with, read_msh, read_msh_with};
pub use names::Interface;
pub use rings::Outline;
pub(crate) use rings::polar_rings;
pub use structured::{SideParts, mapped_grid, unit_square, unit_squares};
pub use triangulation::Triangulation;
