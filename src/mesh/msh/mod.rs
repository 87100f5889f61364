//! Reading Gmsh meshes: [`read_msh`], [`parse_msh`].

mod file;
mod lines;
mod raw;
mod sections_2;
mod sections_4;
mod text;

pub use file::{parse_msh, read_msh};
pub(crate) use text::{quoted, read_text};
