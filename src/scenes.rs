//! Named scenes: domain, data, and what is known of their solutions.
//!
//! | scene | form | data | contact edge |
//! | --- | --- | --- | --- |
//! | `block` | plane strain, λ = μ = 1 | f = (0, −cos πx), clamped top, free sides | bottom, n = (0, −1), u_N = −u_y |
//! | `membrane` | ∫ ∇u·∇v | f = cos 2πx + 0.3, u = 0 on top, free sides | bottom, u ≤ 0 |
//!
//! Both on the unit square, f replaced by its P1 interpolant. Their solutions are smooth up to the transition between
//! contact and no contact (r^{3/2}: H^{5/2−ε}) and the corners between clamped and free sides.

use crate::contact::ContactProblem;
use crate::error::{Error, Result};
use crate::fem::{Form, Lame};
use crate::mesh::{Sides, Triangulation, unit_square};
use std::f64::consts::PI;
use std::fmt;
use std::str::FromStr;

/// A named scene.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum Scene {
    /// Elastic square hanging from its top, pushed down on the left and up on the right.
    #[default]
    Block,
    /// The scalar counterpart.
    Membrane,
}

impl Scene {
    /// The structured mesh of the scene with n x n squares.
    ///
    /// # Errors
    /// [`Error::CountOutOfRange`] unless 1 ≤ n ≤ 16384.
    pub fn mesh(self, n: usize) -> Result<Triangulation> {
        unit_square(n, Sides::HANGING)
    }

    /// The problem on a given triangulation of the scene's domain (a level of a hierarchy, say).
    ///
    /// # Errors
    /// As for [`ContactProblem::new`].
    pub fn on(self, mesh: Triangulation) -> Result<ContactProblem> {
        match self {
            Scene::Block => {
                let load: Vec<f64> = mesh.nodes().iter().flat_map(|&[x, _]| [0.0, -(PI * x).cos()]).collect();
                ContactProblem::new(mesh, Form::elastic(Lame::new(1.0, 1.0)?), &load)
            }
            Scene::Membrane => {
                let load: Vec<f64> = mesh.nodes().iter().map(|&[x, _]| (2.0 * PI * x).cos() + 0.3).collect();
                ContactProblem::new(mesh, Form::LAPLACE, &load)
            }
        }
    }

    /// The problem on the structured mesh with n x n squares.
    ///
    /// # Errors
    /// As for [`Scene::mesh`] and [`Scene::on`].
    pub fn problem(self, n: usize) -> Result<ContactProblem> {
        self.on(self.mesh(n)?)
    }
}

impl fmt::Display for Scene {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Scene::Block => "block",
            Scene::Membrane => "membrane",
        })
    }
}

impl FromStr for Scene {
    type Err = Error;

    fn from_str(text: &str) -> Result<Self> {
        match text {
            "block" => Ok(Scene::Block),
            "membrane" => Ok(Scene::Membrane),
            _ => Err(Error::UnknownName {
                what: "scene",
                given: text.to_owned(),
                expected: "block or membrane",
            }),
        }
    }
}
