//! How smooth a scene is: from its polygon, its conditions, and the contact set found on a mesh.
//!
//! | scene | sup τ | corner responsible |
//! | --- | --- | --- |
//! | elastic | 1 + λ, 1.745 at ν_P = 1/4 | clamped/free right angle |
//! | `corner`, ω > 90° | 1 + 90°/ω | clamped/contact edge, open there |
//! | `corner`, ω < 90° | 1 + 90°/(180° − ω) | clamped/free, at the other end of the clamped side |
//! | other scalar | 5/2 | the transition of contact, r^{3/2} |
//!
//! At a right angle between u = 0 and zero flux λ = 1, 3, ...: polynomials. See [`super::body_regularity`].

use super::corners::{BodyRegularity, body_regularity};
use super::mesh::{MeshScene, Setting};
use crate::cone::Cone;
use crate::contact::Solver;
use crate::error::Result;

/// Squares along each side of the mesh on which the contact set is found.
const SQUARES: usize = 32;

impl MeshScene {
    /// Corners, transitions and the supremum of the τ with u ∈ H^τ, with the contact set of the nodal cone on 32 x 32 squares.
    ///
    /// # Errors
    /// As [`MeshScene::problem_with`] and [`body_regularity`].
    pub fn regularity(self, setting: &Setting) -> Result<BodyRegularity> {
        let problem = self.problem_with(SQUARES, setting)?;
        let solution = problem.solve(Cone::Nodal, Solver::ActiveSet)?;
        body_regularity(&problem, &solution)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Twelve digits.
    const DIGITS: f64 = 1e-12;

    /// What was typed by hand before, with its cap 2, and where it was wrong.
    #[test]
    fn computed_regularity_stands_beside_the_typed_one() {
        let setting = Setting::default();
        for scene in MeshScene::all() {
            let typed = match scene {
                // 1 + the root of Williams' equation at a right angle and ratio 1/4, by bisection.
                MeshScene::Block | MeshScene::Free | MeshScene::Closed => 1.744_749_698_597_720_7,
                MeshScene::Corner => 1.75,
                MeshScene::Incompressible => continue,
                _ => 2.0,
            };
            let found = scene.regularity(&setting).unwrap();
            assert!((found.tau.min(2.0) - typed).abs() < DIGITS, "{scene}: {found:?}");
            let responsible = found.responsible().unwrap().to_string();
            let expected = match scene {
                scene if scene.is_elastic() => "90 deg",
                MeshScene::Corner => "120 deg at (0.000, 0.000)",
                _ => "180 deg",
            };
            assert!(responsible.contains(expected), "{scene}: {responsible}");
        }
    }

    #[test]
    fn a_sharp_corner_has_a_blunt_one_opposite() {
        // Typed was 1 + 90/ω, at most 2: for ω < 90 the clamped side meets the free top at 180 − ω.
        for angle in [30.0, 60.0, 80.0, 100.0, 135.0, 150.0] {
            let found = MeshScene::Corner.regularity(&Setting { angle, ..Setting::default() }).unwrap();
            let blunt = f64::max(angle, 180.0 - angle);
            assert!((found.tau - (1.0 + 90.0 / blunt)).abs() < DIGITS, "{angle}: {found:?}");
        }
        let hard = MeshScene::Incompressible.regularity(&Setting::default()).unwrap();
        assert!(hard.tau > 1.5 && hard.tau < 1.7, "{hard:?}");
    }
}
