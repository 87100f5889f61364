//! Reading Gmsh meshes: [`read_msh`], [`parse_msh`].

mod file;
mod lines;
mod raw;
mod sections_2;
mod sections_4;

pub use file::{parse_msh, read_msh};
