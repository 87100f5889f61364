//! The regularity of a test problem, from its polygon, its boundary conditions, and the contact set computed on a
//! mesh.
//!
//! Whether contact extends to the ends of the contact edge is determined on a mesh graded toward them, since uniform
//! squares may be too coarse.
//!
//! | test problem | sup τ | corner that determines it |
//! | --- | --- | --- |
//! | elastic squares | 1 + λ, 1.745 at ν_P = 1/4 | clamped/free right angle |
//! | `leaning`, `raised` | 1.657 at ω = 120° | clamped/contact edge, open there |
//! | `taper` | 1.616 at ω = 120° | contact edge, closed there, and free side |
//! | `bracket` | 1.544 | free reentrant corner |
//! | `corner`, ω > 90° | 1 + 90°/ω | clamped/contact edge, open there |
//! | `corner`, ω < 90° | 1 + 90°/(180° − ω) | clamped/free, at the other end of the clamped side |
//! | other scalar | 5/2 | the transition of contact, r^{3/2} |
//!
//! At a right angle between u = 0 and zero flux λ = 1, 3, ...: polynomials. See [`super::solution_regularity`].

use super::corners::{SolutionRegularity, is_closed_at, regularity_with_ends};
use super::test_problem::{Parameters, TestProblem};
use crate::cone::Cone;
use crate::contact::Solver;
use crate::error::Result;
use crate::mesh::Hierarchy;

/// Number of squares along each side of the mesh on which the contact set is computed.
const SQUARES: usize = 32;
/// Number of squares along each side and of levels of the meshes graded toward the ends of the contact edge, and the
/// radius of the first level: four squares.
const COARSE: usize = 16;
const LEVELS: usize = 36;
const RADIUS: f64 = 0.25;
/// Radius, relative to the length of the edge, at which the contact set is evaluated: far from both limits of the
/// grading.
const READ: f64 = 1e-7;

impl TestProblem {
    /// Corners, transitions and the supremum of the τ with u ∈ H^τ. The contact set is computed with the nodal cone
    /// on 32 × 32 squares, and at the ends of the contact edge on meshes graded toward them.
    ///
    /// ```
    /// use signorini::problems::{Parameters, TestProblem};
    /// // clamped/free right angle, Poisson's ratio 1/4: exponent 0.745
    /// assert!((TestProblem::Block.regularity(&Parameters::default())?.tau - 1.745).abs() < 1e-3);
    /// # Ok::<(), signorini::Error>(())
    /// ```
    ///
    /// # Errors
    /// As for [`TestProblem::problem_with`], [`ContactProblem::solve`](crate::contact::ContactProblem::solve)
    /// and [`super::solution_regularity`].
    pub fn regularity(self, setting: &Parameters) -> Result<SolutionRegularity> {
        let problem = self.problem_with(SQUARES, setting)?;
        let solution = problem.solve(Cone::Nodal, Solver::ActiveSet)?;
        let mut ends = [None; 2];
        if !problem.edge().is_closed() {
            for (k, end) in ends.iter_mut().enumerate() {
                *end = Some(self.closes_at(setting, k == 1)?);
            }
        }
        regularity_with_ends(&problem, &solution, ends)
    }

    /// True if there is contact near the first or the last node of the contact edge.
    fn closes_at(self, setting: &Parameters, last: bool) -> Result<bool> {
        let mut hierarchy = Hierarchy::new(self.mesh_with(COARSE, setting)?);
        let ends = self.problem_with(COARSE, setting)?;
        let points = ends.edge().points();
        let length = ends.edge().arc()[points.len() - 1];
        let place = points[if last { points.len() - 1 } else { 0 }];
        hierarchy.refine_around(place, RADIUS, LEVELS)?;
        let problem = self.on_with(hierarchy.finest().clone(), setting)?;
        let solution = problem.solve(Cone::Nodal, Solver::ActiveSet)?;
        Ok(is_closed_at(
            &problem,
            &solution,
            if last { length * (1.0 - READ) } else { length * READ },
        ))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Twelve digits.
    const DIGITS: f64 = 1e-12;

    /// Regularities typed by hand, with the limit 2, against the computed ones.
    #[test]
    fn computed_regularity_stands_beside_the_typed_one() {
        let setting = Parameters::default();
        for test_problem in TestProblem::all() {
            let typed = match test_problem {
                // 1 + the root of Williams' equation at a right angle and ratio 1/4, by bisection.
                TestProblem::Block | TestProblem::Free | TestProblem::Closed => {
                    1.744_749_698_597_720_7
                }
                TestProblem::Corner => 1.75,
                TestProblem::Incompressible => continue,
                // To twelve digits by the count of `singular`.
                TestProblem::Leaning | TestProblem::Raised => 1.657_460_971_897,
                TestProblem::Taper => 1.615_731_059_491,
                TestProblem::Bracket => 1.544_483_736_782,
                _ => 2.0,
            };
            let found = test_problem.regularity(&setting).unwrap();
            assert!((found.tau.min(2.0) - typed).abs() < DIGITS, "{test_problem}: {found:?}");
            let responsible = found.responsible().unwrap().to_string();
            let expected = match test_problem {
                TestProblem::Corner | TestProblem::Leaning | TestProblem::Raised => {
                    "O-D 120 deg at (0.000, 0.000)"
                }
                TestProblem::Taper => "C-N 120 deg at (0.000, 0.000)",
                TestProblem::Bracket => "N-N 270 deg at (0.000, 1.000)",
                test_problem if test_problem.is_elastic() => "90 deg",
                _ => "180 deg",
            };
            assert!(responsible.contains(expected), "{test_problem}: {responsible}");
        }
    }

    #[test]
    fn a_sharp_corner_has_a_blunt_one_opposite() {
        // Typed was 1 + 90/ω, at most 2: for ω < 90 the clamped side meets the free top at 180 − ω.
        for angle in [30.0, 60.0, 80.0, 100.0, 135.0, 150.0] {
            let found = TestProblem::Corner
                .regularity(&Parameters { angle, ..Parameters::default() })
                .unwrap();
            let blunt = f64::max(angle, 180.0 - angle);
            assert!((found.tau - (1.0 + 90.0 / blunt)).abs() < DIGITS, "{angle}: {found:?}");
        }
        let hard = TestProblem::Incompressible.regularity(&Parameters::default()).unwrap();
        assert!(hard.tau > 1.5 && hard.tau < 1.7, "{hard:?}");
    }
}
