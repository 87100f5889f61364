//! Contact problems on the unit square whose solution is known: displacement, gradient, σ_N, regularity, the problem on
//! uniform meshes, and errors of discrete solutions.
//!
//! Contact edge y = 0, outward normal (0, −1). The solutions differ in their formula, hence in material and regularity:
//!
//! | constructor | solution | u ∈ H^τ for τ below |
//! | --- | --- | --- |
//! | [`KnownSolution::three_halves`] | −Re (z − 2/5)^{3/2}, scalar; u given on top, ∂u/∂n on the sides | 5/2 |
//! | [`KnownSolution::one_transition`], [`KnownSolution::two_transitions`] | Westergaard's function, scalar or elastic | 5/2 |
//! | [`KnownSolution::power`] | r^p about one transition, 1/2 < p < 3/2, scalar or elastic | p + 1 |
//! | [`KnownSolution::transition`], [`KnownSolution::whole_boundary`] | powers and logarithms of [`TransitionPowers`], scalar | min(p + 1, q + 2) |

mod harmonic;
mod harmonic_problem;
mod power;
mod power_problem;
mod three_halves;
mod westergaard;

pub use power::EdgeDatum;

use super::transition_powers::TransitionPowers;
use crate::contact::ContactProblem;
use crate::error::{Error, Result, ToolkitError};
use crate::fem::{Cubature, ErrorNorms, Field, Form, Lame, error_norms};
use crate::mesh::{Point, SideParts, unit_square};
use fractional_sobolev::{Estimate, Given, Order, Tolerance, Work};
use harmonic::Harmonic;
use power::Power;
use std::fmt;
use westergaard::Westergaard;

pub(super) use three_halves::problem as three_halves_problem;

/// Points along each side of a triangle's rule for errors, graded toward the transitions.
const POINTS: usize = 4;
/// Most points along each side of a triangle's rule for an error of given accuracy.
const MOST_POINTS: usize = 16;

/// A contact problem on the unit square with known solution u.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct KnownSolution {
    formula: Formula,
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum Formula {
    ThreeHalves,
    Westergaard(Westergaard),
    Power(Power),
    Harmonic(Harmonic),
}

impl KnownSolution {
    /// u = −Re (z − 2/5)^{3/2}, scalar, with contact on \[0, 2/5\]: the solution of
    /// [`TestProblem::Manufactured`](super::TestProblem::Manufactured).
    ///
    /// ```
    /// use signorini::{cone::Cone, contact::Solver, problems::KnownSolution};
    /// let u = KnownSolution::three_halves();
    /// let problem = u.problem(16)?;
    /// let solution = problem.solve(Cone::Nodal, Solver::ActiveSet)?;
    /// let error = u.error(&problem, &solution.displacement, 1e-2)?;
    /// // a tenth of the norm of u on this mesh
    /// assert!(error.value < 0.1 * problem.energy_norm(&solution.displacement)?);
    /// # Ok::<(), signorini::Error>(())
    /// ```
    pub fn three_halves() -> Self {
        Self { formula: Formula::ThreeHalves }
    }

    /// Contact before 3/10, a gap beyond; scalar without Lamé's constants, else elastic.
    pub fn one_transition(lame: Option<Lame>) -> Self {
        Self { formula: Formula::Westergaard(Westergaard { two_transitions: false, lame }) }
    }

    /// Contact before 3/10 and beyond 7/10; scalar without Lamé's constants, else elastic.
    pub fn two_transitions(lame: Option<Lame>) -> Self {
        Self { formula: Formula::Westergaard(Westergaard { two_transitions: true, lame }) }
    }

    /// r^p about the transition 2/5, contact before it; scalar without Lamé's constants, else elastic.
    ///
    /// # Errors
    /// [`ToolkitError::OutOfRange`] unless 1/2 < p < 3/2 and |p − 1| ≥ 1/100 (u would be linear).
    pub fn power(p: f64, lame: Option<Lame>) -> Result<Self> {
        Ok(Self { formula: Formula::Power(Power::new(p, lame)?) })
    }

    /// The powers of a transition at `position`, contact beyond it, the other three sides held; scalar.
    ///
    /// # Errors
    /// [`ToolkitError::OutOfRange`] unless 3/10 ≤ p ≤ 3/2, q > −1, α ≥ 0, 0 < position < 1; for p ≠ 1 also
    /// |p − 1| ≥ 1/10 and α = 0.
    pub fn transition(powers: TransitionPowers, position: f64) -> Result<Self> {
        Ok(Self { formula: Formula::Harmonic(Harmonic::new(powers, position, false)?) })
    }

    /// The same with a reaction term and conditions of contact on the whole boundary: Remark 1 as printed.
    ///
    /// # Errors
    /// As [`KnownSolution::transition`].
    pub fn whole_boundary(powers: TransitionPowers, position: f64) -> Result<Self> {
        Ok(Self { formula: Formula::Harmonic(Harmonic::new(powers, position, true)?) })
    }

    /// Lamé's constants; none for a scalar solution.
    pub fn lame(&self) -> Option<Lame> {
        match self.formula {
            Formula::ThreeHalves | Formula::Harmonic(_) => None,
            Formula::Westergaard(known) => known.lame,
            Formula::Power(known) => known.lame,
        }
    }

    /// The bilinear form.
    pub fn form(&self) -> Form {
        match self.formula {
            Formula::Harmonic(known) => known.form(),
            _ => self.lame().map_or(Form::LAPLACE, Form::elastic),
        }
    }

    /// The ends of contact on y = 0; with contact on the whole boundary those inside that side.
    pub fn transitions(&self) -> Vec<f64> {
        match self.formula {
            Formula::ThreeHalves => vec![three_halves::TRANSITION],
            Formula::Westergaard(known) => known.transitions().to_vec(),
            Formula::Power(_) => vec![power::TRANSITION],
            Formula::Harmonic(known) => vec![known.position],
        }
    }

    /// The supremum of the τ with u ∈ H^τ and σ_N ∈ H^{τ−3/2}.
    pub fn regularity(&self) -> f64 {
        match self.formula {
            Formula::ThreeHalves | Formula::Westergaard(_) => 2.5,
            Formula::Power(known) => known.power + 1.0,
            Formula::Harmonic(known) => (known.powers.opening + 1.0).min(known.powers.pressure + 2.0),
        }
    }

    /// u; a scalar solution has second entry 0.
    pub fn displacement(&self, point: Point) -> Point {
        match self.formula {
            Formula::ThreeHalves => [three_halves::displacement(point), 0.0],
            Formula::Westergaard(known) => known.displacement(point),
            Formula::Power(known) => known.displacement(point),
            Formula::Harmonic(known) => [known.displacement(point), 0.0],
        }
    }

    /// ∇u: row c is the gradient of component c.
    pub fn gradient(&self, point: Point) -> [Point; 2] {
        match self.formula {
            Formula::ThreeHalves => [three_halves::gradient(point), [0.0; 2]],
            Formula::Westergaard(known) => known.gradient(point),
            Formula::Power(known) => known.gradient(point),
            Formula::Harmonic(known) => [known.gradient(point), [0.0; 2]],
        }
    }

    /// σ_N at (x, 0); scalar: the contact force, ∂u/∂n less the load of the edge.
    pub fn normal_stress(&self, x: f64) -> f64 {
        match self.formula {
            Formula::ThreeHalves => three_halves::normal_stress(x),
            Formula::Westergaard(known) => known.normal_stress(x),
            Formula::Power(known) => known.normal_stress(x),
            Formula::Harmonic(known) => known.normal_stress(x - known.position),
        }
    }

    /// The problem on the structured mesh with n × n squares, its data from u.
    ///
    /// # Errors
    /// [`ToolkitError::CountOutOfRange`] unless 1 ≤ n ≤ 16384.
    pub fn problem(&self, n: usize) -> Result<ContactProblem> {
        match self.formula {
            Formula::ThreeHalves => three_halves_problem(unit_square(n, SideParts::HANGING)?, 1.0),
            Formula::Westergaard(known) => {
                let mut problem = known.problem(n)?;
                self.with_field(|field| problem.set_dirichlet(field))?;
                Ok(problem)
            }
            Formula::Power(known) => {
                let mut problem = known.problem(n)?;
                self.with_field(|field| problem.set_dirichlet(field))?;
                Ok(problem)
            }
            Formula::Harmonic(known) => known.problem(n),
        }
    }

    /// Values of u at the nodes of a problem, node-major.
    ///
    /// # Errors
    /// As [`Field::sample`].
    pub fn interpolant(&self, problem: &ContactProblem) -> Result<Vec<f64>> {
        self.with_field(|field| field.sample(problem.mesh().nodes()))
    }

    /// Norms of u − v for nodal values v on the mesh of a problem, by a fixed rule graded toward the transitions: four
    /// points along each side of a triangle, exact to a thousandth.
    ///
    /// # Errors
    /// As [`error_norms`].
    pub fn error_norms(&self, problem: &ContactProblem, values: &[f64]) -> Result<ErrorNorms> {
        self.norms(problem, values, POINTS)
    }

    /// a(u − v, u − v)^{1/2} for nodal values v on the mesh of a problem. The error is what a rule with one point less
    /// along each side of a triangle changes; points are added until the tolerance is met. The rule converges
    /// algebraically near the transition: the true error of quadrature may be a few times as large. Cost: two passes over the
    /// mesh with 9 to 25 points on a triangle for two digits.
    ///
    /// # Errors
    /// As [`error_norms`]; [`ToolkitError::ToleranceNotMet`] when 16 points do not meet the tolerance.
    pub fn error(
        &self,
        problem: &ContactProblem,
        values: &[f64],
        tolerance: impl Given<Tolerance>,
    ) -> Result<Estimate> {
        let tolerance = tolerance.given()?;
        let first = match self.formula {
            Formula::Harmonic(known) => known.points(),
            _ => POINTS,
        };
        let mut before = self.norms(problem, values, first - 1)?.energy;
        let mut points = first;
        loop {
            let value = self.norms(problem, values, points)?.energy;
            let found = Estimate::new(value, value - before, Work::default())?;
            if found.error <= tolerance.relative() * value {
                return Ok(found);
            }
            if points == MOST_POINTS {
                let why = "quadrature of the error converges slowly near the transition";
                return Err(ToolkitError::not_met(
                    "error in the energy norm",
                    tolerance.relative(),
                    found,
                    why,
                )
                .into());
            }
            (before, points) = (value, points + 1);
        }
    }

    fn norms(&self, problem: &ContactProblem, values: &[f64], points: usize) -> Result<ErrorNorms> {
        let (gradient, rule) = (|point| self.gradient(point), self.rule(points)?);
        self.with_field(|exact| {
            error_norms(problem.mesh(), problem.form(), values, (exact, &gradient), &rule)
        })
    }

    fn rule(&self, points: usize) -> Result<Cubature> {
        let singular: Vec<Point> = self.transitions().into_iter().map(|x| [x, 0.0]).collect();
        Ok(Cubature::new(points)?.singular_at(&singular))
    }

    fn with_field<T>(&self, then: impl FnOnce(&Field<'_>) -> T) -> T {
        if self.lame().is_some() {
            then(&Field::Vector(&|point| self.displacement(point)))
        } else {
            then(&Field::Scalar(&|point| self.displacement(point)[0]))
        }
    }

    /// |u|₂ on (0, 1) × (0, 1/n), the root of the sum over components of ∫ u_xx² + 2 u_xy² + u_yy²; the error is
    /// what a rule of fewer points changes, and points are added until the tolerance is met.
    ///
    /// # Errors
    /// [`ToolkitError::CountOutOfRange`] unless 1 ≤ n ≤ 16384; [`ToolkitError::Incompatible`] unless u is that of
    /// [`KnownSolution::one_transition`] or [`KnownSolution::two_transitions`]; [`ToolkitError::ToleranceNotMet`].
    pub fn second_seminorm(&self, n: usize, tolerance: impl Given<Tolerance>) -> Result<Estimate> {
        let tolerance = tolerance.given()?;
        match self.formula {
            Formula::Westergaard(known) => known.second_seminorm(n, tolerance),
            _ => Err(self.without("the seminorm of second derivatives", "one transition or two")),
        }
    }

    /// |∇u|_{τ−1} on the half disc about the transition that holds the square, 3/2 < τ < 2, ‖D²u‖ at τ = 2:
    /// ‖D²(r^p sin pφ)‖² = p² q π R^{2q}, q = p − 1; for elasticity α² + β² + 1 − q + q² times that over 4μ².
    ///
    /// # Errors
    /// [`ToolkitError::InfiniteNorm`] for τ ≥ p + 1; [`ToolkitError::OutOfRange`] unless 1 < τ ≤ 2;
    /// [`ToolkitError::Incompatible`] unless u is that of [`KnownSolution::power`]; as
    /// [`Function::elastic_corner`](fractional_sobolev::Function::elastic_corner).
    pub fn body_seminorm(&self, tau: f64, tolerance: impl Given<Tolerance>) -> Result<Estimate> {
        let tolerance = tolerance.given()?;
        match self.formula {
            Formula::Power(known) => known.body_seminorm(tau, tolerance),
            _ => Err(self.without("the seminorm of fractional order", "a power about one transition")),
        }
    }

    /// |σ_N|_ν or |u_N'|_ν on the part (from, to) of the edge.
    ///
    /// # Errors
    /// [`ToolkitError::InfiniteNorm`] for ν ≥ p − 1/2; [`ToolkitError::Incompatible`] unless u is that of
    /// [`KnownSolution::power`]; as
    /// [`Function::seminorm`](fractional_sobolev::Function::seminorm).
    pub fn edge_seminorm(
        &self,
        datum: EdgeDatum,
        part: [f64; 2],
        order: impl Given<Order>,
        tolerance: impl Given<Tolerance>,
    ) -> Result<Estimate> {
        let (order, tolerance) = (order.given()?, tolerance.given()?);
        match self.formula {
            Formula::Power(known) => known.edge_seminorm(datum, part, order, tolerance),
            _ => Err(self.without("the seminorm on the edge", "a power about one transition")),
        }
    }

    fn without(&self, with: &'static str, expected: &'static str) -> Error {
        let given = self.to_string();
        Error::Toolkit(ToolkitError::Incompatible { what: "known solution", given, with, expected })
    }
}

impl fmt::Display for KnownSolution {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.formula {
            Formula::ThreeHalves => f.write_str("scalar, r^(3/2)"),
            Formula::Westergaard(known) => known.fmt(f),
            Formula::Power(known) => {
                let kind = if known.lame.is_some() { "elastic" } else { "scalar" };
                write!(f, "{kind}, r^{}", known.power)
            }
            Formula::Harmonic(known) => known.fmt(f),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::harmonic::tests::scenes;
    use super::*;
    use crate::cone::Cone;
    use crate::contact::Solver;

    #[test]
    fn the_rule_of_the_errors_is_fine_enough() {
        let lame = Some(Lame::new(1.3, 0.7).unwrap());
        let powers = [0.65, 1.3].map(|p| KnownSolution::power(p, lame).unwrap());
        let of_each = |lame| [KnownSolution::one_transition(lame), KnownSolution::two_transitions(lame)];
        let known = [of_each(None), of_each(lame), powers].concat();
        for scene in known.into_iter().chain([KnownSolution::three_halves()]) {
            let problem = scene.problem(8).unwrap();
            let values = scene.interpolant(&problem).unwrap();
            let coarse = scene.error_norms(&problem, &values).unwrap().energy;
            let fine = scene.norms(&problem, &values, 10).unwrap().energy;
            assert!((coarse / fine - 1.0).abs() < 1e-3, "{scene}: {coarse} {fine}");
            let found = scene.error(&problem, &values, 1e-2).unwrap();
            assert_eq!(found.value, coarse, "{scene}");
            assert!((found.value - fine).abs() <= 4.0 * found.error, "{scene}: {found:?} {fine}");
        }
    }

    #[test]
    fn a_tolerance_is_met_or_refused() {
        let scene = KnownSolution::power(0.65, None).unwrap();
        let problem = scene.problem(4).unwrap();
        let values = scene.interpolant(&problem).unwrap();
        let [rough, sharp] = [1e-2, 1e-5].map(|asked| scene.error(&problem, &values, asked).unwrap());
        assert!(sharp.error <= 1e-5 * sharp.value && (rough.value - sharp.value).abs() <= 2.0 * rough.error);
        assert!(scene.error(&problem, &values, 1e-15).is_err());
        assert!(scene.second_seminorm(4, 1e-2).is_err());
        assert!(KnownSolution::three_halves().body_seminorm(1.75, 1e-3).is_err());
    }

    #[test]
    fn contact_is_found_where_it_is_in_both_cones() {
        for known in scenes(true).into_iter().chain(scenes(false)) {
            let scene = KnownSolution { formula: Formula::Harmonic(known) };
            let problem = scene.problem(16).unwrap();
            let [nodal, midpoint] = [Cone::Nodal, Cone::Midpoint].map(|cone| {
                let solution = problem.solve(cone, Solver::ActiveSet).unwrap();
                assert!(solution.status.is_converged() && solution.kkt.worst() < 1e-12, "{scene} {cone}");
                let error = scene.error(&problem, &solution.displacement, 1e-2).unwrap();
                assert!(error.error < 1e-3 * error.value, "{scene} {cone}: {error:?}");
                (solution.contact_set.count(), error.value)
            });
            assert!(nodal.0.abs_diff(2 * 16 / 3) <= 2, "{scene}: {nodal:?}");
            // The errors of the two cones are of one size on every test problem.
            assert!(
                midpoint.1 < 1.5 * nodal.1 && nodal.1 < 1.5 * midpoint.1,
                "{scene}: {nodal:?} {midpoint:?}"
            );
        }
        for opening in [0.2, 0.95, 1.6, f64::NAN] {
            let powers = TransitionPowers { opening, ..TransitionPowers::of_regularity(1.75) };
            assert!(KnownSolution::whole_boundary(powers, 0.5).is_err(), "{opening}");
        }
        assert!(KnownSolution::transition(TransitionPowers::of_regularity(1.75), 1.0).is_err());
    }
}
