//! Scenes on meshes: domain, data, and what is known of their solutions.
//!
//! | scene | form | volume load f | contact edge | u in H^τ for all τ < |
//! | --- | --- | --- | --- | --- |
//! | `block` | plane strain, λ = μ = 1 | (0, −cos πx) | bottom | clamped/free corner |
//! | `membrane` | ∫ ∇u·∇v | cos 2πx + 0.3 | bottom | 5/2 |
//! | `membrane-reaction` | ∫ ∇u·∇v + uv (Remark 1) | 4 (cos πx + cos πy) | all | not classified |
//! | `corner` | ∫ ∇u·∇v | −2 cos πx | bottom | 1 + π/(2ω), at most 5/2 |
//! | `manufactured` | ∫ ∇u·∇v | 0; exact solution −Re (z − a)^{3/2}, contact on [0, a] | bottom | 5/2 |
//! | `incompressible` | plane strain, E = 5/2, given Poisson's ratio | as `block` | bottom | as `block` |
//! | `free` | as `block` | (0, 1): lifted, no contact | bottom | as `block` |
//! | `closed` | as `block` | (0, −1): pressed down, full contact | bottom | as `block` |
//!
//! The body hangs from its top, u = 0, with free sides; in `corner` from its left side, which meets the
//! bottom at the angle ω. On the unit square except `corner`; n = (0, −1) on the bottom, so u_N = −u_y ≤ 0
//! for elastic scenes and u ≤ 0 for scalar ones. Volume loads are replaced by their P1 interpolants. 5/2 is
//! the transition between contact and no contact inside a straight edge, r^{3/2}.

use super::manufactured;
use crate::contact::ContactProblem;
use crate::error::{Error, Result};
use crate::fem::{Field, Form, Lame};
use crate::mesh::{Part, Point, Sides, Triangulation, mapped_grid, unit_square};
use std::f64::consts::PI;
use std::fmt;
use std::str::FromStr;
use std::sync::LazyLock;

/// A named scene.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
#[non_exhaustive]
pub enum MeshScene {
    /// Elastic square hanging from its top, pushed down on the left and up on the right.
    #[default]
    Block,
    /// The scalar counterpart.
    Membrane,
    /// Remark 1 as printed: reaction term, contact on the whole boundary.
    MembraneReaction,
    /// Scalar corner of given opening between a Dirichlet side and the contact edge.
    Corner,
    /// Scalar, with known solution and contact set.
    Manufactured,
    /// `block` with a material that is hard to compress: P1 elements lock.
    Incompressible,
    /// Elastic without contact.
    Free,
    /// Elastic with full contact.
    Closed,
}

/// Parameters of the scenes that have some.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Setting {
    /// Opening ω at the left end of the contact edge of `corner`, in degrees, in [20, 160].
    pub angle: f64,
    /// Poisson's ratio of `incompressible`, in (0, 1/2).
    pub poisson: f64,
    /// Factor on all data.
    pub load_scale: f64,
}

impl Default for Setting {
    fn default() -> Self {
        Self { angle: 120.0, poisson: 0.4999, load_scale: 1.0 }
    }
}

const ALL_CONTACT: Sides =
    Sides { bottom: Part::Contact, right: Part::Contact, top: Part::Contact, left: Part::Contact };

const LEFT_HELD: Sides =
    Sides { bottom: Part::Contact, right: Part::Neumann, top: Part::Neumann, left: Part::Dirichlet };

impl MeshScene {
    /// All scenes.
    pub const ALL: [MeshScene; 8] = [
        MeshScene::Block,
        MeshScene::Membrane,
        MeshScene::MembraneReaction,
        MeshScene::Corner,
        MeshScene::Manufactured,
        MeshScene::Incompressible,
        MeshScene::Free,
        MeshScene::Closed,
    ];

    /// The names of all mesh scenes, for help texts and errors.
    pub fn names() -> &'static str {
        static NAMES: LazyLock<String> = LazyLock::new(|| MeshScene::ALL.map(|s| s.to_string()).join(", "));
        &NAMES
    }

    /// True for the scenes of elasticity.
    pub fn is_elastic(self) -> bool {
        matches!(self, MeshScene::Block | MeshScene::Incompressible | MeshScene::Free | MeshScene::Closed)
    }

    /// The solution where it is known in closed form, default setting: u as a function of the point.
    pub fn solution(self) -> Option<fn(Point) -> f64> {
        (self == MeshScene::Manufactured).then_some(manufactured::exact)
    }

    /// The structured mesh of the scene with n x n squares, default setting.
    ///
    /// # Errors
    /// [`Error::CountOutOfRange`] unless 1 ≤ n ≤ 16384.
    pub fn mesh(self, n: usize) -> Result<Triangulation> {
        self.mesh_with(n, &Setting::default())
    }

    /// The problem on a given triangulation of the scene's domain (a level of a hierarchy, say), default
    /// setting.
    ///
    /// # Errors
    /// As for [`ContactProblem::new`].
    pub fn on(self, mesh: Triangulation) -> Result<ContactProblem> {
        self.on_with(mesh, &Setting::default())
    }

    /// The problem on the structured mesh with n x n squares, default setting.
    ///
    /// # Errors
    /// As for [`MeshScene::mesh`] and [`MeshScene::on`].
    pub fn problem(self, n: usize) -> Result<ContactProblem> {
        self.problem_with(n, &Setting::default())
    }

    /// The problem on the structured mesh with n x n squares.
    ///
    /// # Errors
    /// As for [`MeshScene::mesh_with`] and [`MeshScene::on_with`].
    pub fn problem_with(self, n: usize, setting: &Setting) -> Result<ContactProblem> {
        self.on_with(self.mesh_with(n, setting)?, setting)
    }

    /// The structured mesh of the scene with n x n cells.
    ///
    /// # Errors
    /// [`Error::CountOutOfRange`] unless 1 ≤ n ≤ 16384, [`Error::OutOfRange`] for an angle outside [20, 160].
    pub fn mesh_with(self, n: usize, setting: &Setting) -> Result<Triangulation> {
        match self {
            MeshScene::MembraneReaction => unit_square(n, ALL_CONTACT),
            MeshScene::Corner => {
                let angle = setting.angle;
                Error::require("angle in degrees", angle, "[20, 160]", (20.0..=160.0).contains(&angle))?;
                // The left side leans by cot ω; the right one with it when it leans inwards.
                let lean = 1.0 / angle.to_radians().tan();
                mapped_grid(n, n, LEFT_HELD, |[x, y]| [x + y * ((1.0 - x) * lean + x * lean.max(0.0)), y])
            }
            _ => unit_square(n, Sides::HANGING),
        }
    }

    /// The problem on a given triangulation of the scene's domain.
    ///
    /// # Errors
    /// As for [`ContactProblem::new`]; [`Error::OutOfRange`] for a parameter that is not admissible.
    pub fn on_with(self, mesh: Triangulation, setting: &Setting) -> Result<ContactProblem> {
        let scale = setting.load_scale;
        Error::require("load scale", scale, "finite numbers", scale.is_finite())?;
        if self == MeshScene::Manufactured {
            return manufactured::problem(mesh, scale);
        }
        let form = self.form(setting)?;
        let load = if self.is_elastic() {
            let density = |point: Point| [0.0, scale * self.density(point)];
            Field::Vector(&density).sample(mesh.nodes())?
        } else {
            let density = |point: Point| scale * self.density(point);
            Field::Scalar(&density).sample(mesh.nodes())?
        };
        ContactProblem::new(mesh, form, &load)
    }

    fn form(self, setting: &Setting) -> Result<Form> {
        Ok(match self {
            MeshScene::Incompressible => Form::elastic(Lame::plane_strain(2.5, setting.poisson)?),
            MeshScene::MembraneReaction => Form::Scalar { reaction: 1.0 },
            scene if scene.is_elastic() => Form::elastic(Lame::new(1.0, 1.0)?),
            _ => Form::LAPLACE,
        })
    }

    /// The volume load, vertical for elastic scenes.
    fn density(self, [x, y]: Point) -> f64 {
        match self {
            MeshScene::Block | MeshScene::Incompressible => -(PI * x).cos(),
            MeshScene::Membrane => (2.0 * PI * x).cos() + 0.3,
            MeshScene::MembraneReaction => 4.0 * ((PI * x).cos() + (PI * y).cos()),
            MeshScene::Corner => -2.0 * (PI * x).cos(),
            MeshScene::Manufactured => 0.0,
            MeshScene::Free => 1.0,
            MeshScene::Closed => -1.0,
        }
    }
}

impl fmt::Display for MeshScene {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            MeshScene::Block => "block",
            MeshScene::Membrane => "membrane",
            MeshScene::MembraneReaction => "membrane-reaction",
            MeshScene::Corner => "corner",
            MeshScene::Manufactured => "manufactured",
            MeshScene::Incompressible => "incompressible",
            MeshScene::Free => "free",
            MeshScene::Closed => "closed",
        })
    }
}

impl FromStr for MeshScene {
    type Err = Error;

    fn from_str(text: &str) -> Result<Self> {
        let found = MeshScene::ALL.into_iter().find(|scene| scene.to_string() == text);
        found.ok_or_else(|| Error::UnknownName {
            what: "scene",
            given: text.to_owned(),
            expected: MeshScene::names(),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cone::Cone;
    use crate::contact::Solver;

    #[test]
    fn every_scene_has_the_contact_it_is_named_for() {
        for scene in MeshScene::ALL {
            assert_eq!(scene.to_string().parse(), Ok(scene));
            let solution = scene.problem(16).unwrap().solve(Cone::Nodal, Solver::ActiveSet).unwrap();
            let (count, all) = (solution.contact_set.count(), solution.contact_set.constraints());
            match scene {
                MeshScene::Free => assert_eq!(count, 0, "{scene}"),
                MeshScene::Closed => assert_eq!(count, all, "{scene}"),
                _ => assert!(0 < count && count < all, "{scene}: {count} of {all}"),
            }
            assert!(solution.status.is_converged() && solution.judgement.worst() < 1e-13, "{scene}");
        }
        assert!("drum".parse::<MeshScene>().is_err());
        let setting = Setting { angle: 10.0, ..Setting::default() };
        assert!(MeshScene::Corner.problem_with(4, &setting).is_err());
        let setting = Setting { poisson: 0.5, ..Setting::default() };
        assert!(MeshScene::Incompressible.problem_with(4, &setting).is_err());
    }
}
