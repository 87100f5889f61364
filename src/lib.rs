//! Finite elements for the Signorini problem: a numerical companion to a paper on their convergence, statement by
//! statement.
//!
//! The library provides meshes, linear elements, the two discrete cones, solvers, problems reduced exactly to their
//! contact edge, test problems of given regularity, and the steps of the proofs evaluated on computed solutions.
//! Quantities are nondimensional unless stated otherwise. Norms of fractional order, Poincaré and interpolation
//! constants are in the crate [`fractional_sobolev`], on which this one is based.
//!
//! **A body from Gmsh** on a floor:
#![doc = include_str!("with_contact.md")]
#![warn(unreachable_pub)]
#![cfg_attr(not(test), warn(clippy::unwrap_used, clippy::expect_used, clippy::panic))]

#[cfg(doctest)]
mod book;
pub mod bounds;
pub mod cone;
pub mod contact;
pub mod edge;
mod error;
pub mod fem;
pub mod mesh;
mod numeric;
pub mod problems;
pub mod proof;
pub mod rates;
pub mod singular;
pub mod strip;
mod text;

pub use error::{Error, Result, ToolkitError, Unfinished};
