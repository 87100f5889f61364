//! Contact problems on the unit square with known solution: displacement, gradient, σ_N, regularity, the problem on
//! uniform meshes, and errors of discrete solutions.
//!
//! The contact edge is y = 0, with outward normal (0, −1); z = x + iy. The solutions differ in their formula,
//! hence in material and regularity:
//!
//! | constructor | solution | u ∈ H^τ and σ_N ∈ H^{τ−3/2} for τ below |
//! | --- | --- | --- |
//! | [`KnownSolution::three_halves`] | −Re (z − 2/5)^{3/2}, scalar; u given on top, ∂u/∂n on the sides | 5/2 |
//! | [`KnownSolution::one_transition`], [`KnownSolution::two_transitions`] | Westergaard's function, scalar or elastic | 5/2 |
//! | [`KnownSolution::power`] | r^p about one transition, 1/2 < p < 3/2, scalar or elastic | p + 1 |
//! | [`KnownSolution::transition`], [`KnownSolution::whole_boundary`] | [`TransitionPowers`], scalar | min(p + 1, q + 2) |

mod harmonic;
mod power;
mod westergaard;

pub use power::EdgeDatum;

use super::transition_powers::TransitionPowers;
use crate::contact::ContactProblem;
use crate::error::{Error, Result, ToolkitError};
use crate::fem::{Cubature, ErrorNorms, Field, Form, Lame, error_norms};
use crate::mesh::{Part, Point, SideParts, Triangulation, unit_square};
use fractional_sobolev::{Estimate, Given, Order, Tolerance, Work};
use harmonic::Harmonic;
use power::Power;
use std::fmt;
use westergaard::Westergaard;

/// Number of points along each side of a triangle, graded toward the transitions.
const POINTS: usize = 4;
/// Largest number of points along each side of a triangle for an error of given accuracy.
const MOST_POINTS: usize = 16;

/// A contact problem on the unit square with known solution u.
///
/// −Δu = 0 or −div σ(u) = 0 in the square, −Δu + u = f for [`KnownSolution::whole_boundary`]; u_N ≤ 0,
/// σ_N ≤ 0, u_N σ_N = 0 and σ_T = 0 at y = 0 (initial gap 0), with u_N = u in the scalar case. Values are
/// exact up to rounding.
///
/// ```
/// use signorini::problems::KnownSolution;
/// let u = KnownSolution::two_transitions(None);
/// for k in 0..=20 {
///     let x = k as f64 / 20.0;
///     // complementarity on y = 0
///     let (normal, stress) = (u.displacement([x, 0.0])[0], u.normal_stress(x));
///     assert!(normal <= 1e-12 && stress <= 1e-12 && (normal * stress).abs() < 1e-12);
/// }
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct KnownSolution {
    formula: Formula,
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum Formula {
    Westergaard(Westergaard),
    Power(Power),
    Harmonic(Harmonic),
}

impl KnownSolution {
    /// The scalar solution u = −Re (z − 2/5)^{3/2}, z = x + iy, with contact on \[0, 2/5\]: the solution of
    /// [`TestProblem::Manufactured`](super::TestProblem::Manufactured).
    ///
    /// ```
    /// use signorini::{cone::Cone, contact::Solver, problems::KnownSolution};
    /// let u = KnownSolution::three_halves();
    /// let problem = u.problem(16)?;
    /// let solution = problem.solve(Cone::Nodal, Solver::ActiveSet)?;
    /// let error = u.error(&problem, &solution.displacement, 1e-2)?;
    /// // less than a tenth of the norm of u_h
    /// assert!(error.value < 0.1 * problem.energy_norm(&solution.displacement)?);
    /// # Ok::<(), signorini::Error>(())
    /// ```
    pub fn three_halves() -> Self {
        Self { formula: Formula::Westergaard(Westergaard::three_halves()) }
    }

    /// The solution with contact for x < 3/10 and no contact for x > 3/10; scalar for `None`, otherwise elastic.
    ///
    /// F = (z − 3/10)^{3/2}, z = x + iy: u = −Re F (scalar); 2μ u_x = −α Im F − y Re F', 2μ u_y = β Re F
    /// + y Im F', α = μ/(λ + μ), β = 1 + α (elastic, zero volume load and zero shear on the edge).
    ///
    /// ```
    /// use signorini::{fem::Lame, problems::KnownSolution};
    /// let u = KnownSolution::one_transition(Some(Lame::new(1.0, 1.0)?));
    /// // σ_N = −Im F' = −(3/2) √(3/10 − x) before the transition, 0 beyond
    /// assert!((u.normal_stress(0.05) + 0.75).abs() < 1e-14 && u.normal_stress(0.6).abs() < 1e-14);
    /// # Ok::<(), signorini::Error>(())
    /// ```
    pub fn one_transition(lame: Option<Lame>) -> Self {
        Self { formula: Formula::Westergaard(Westergaard::one_transition(lame)) }
    }

    /// The solution with contact for x < 3/10 and for x > 7/10; scalar for `None`, otherwise elastic.
    ///
    /// F = ((z − 3/10)(7/10 − z))^{3/2} in the formulas of [`KnownSolution::one_transition`]; symmetric about x = 1/2.
    ///
    /// ```
    /// use signorini::problems::KnownSolution;
    /// let u = KnownSolution::two_transitions(None);
    /// // u = −((x − 3/10)(7/10 − x))^{3/2} on the non-contact interval, symmetric
    /// assert!((u.displacement([0.5, 0.0])[0] + 0.008).abs() < 1e-15);
    /// assert!((u.displacement([0.4, 0.0])[0] - u.displacement([0.6, 0.0])[0]).abs() < 1e-15);
    /// ```
    pub fn two_transitions(lame: Option<Lame>) -> Self {
        Self { formula: Formula::Westergaard(Westergaard::two_transitions(lame)) }
    }

    /// The solution that behaves like r^p at the transition x = 2/5, with contact for x < 2/5; scalar for
    /// `None`, otherwise elastic.
    ///
    /// With r = |x − 2/5|: u_N = −c r^p outside contact, σ_N = −p |sin pπ| r^{p−1} in contact, with an edge
    /// load ∂u/∂n − σ_N; c = |sin pπ|, for elasticity times (λ + 2μ)/(2μ (λ + μ)).
    ///
    /// ```
    /// use signorini::problems::KnownSolution;
    /// let u = KnownSolution::power(0.75, None)?;
    /// assert_eq!(u.regularity(), 1.75);
    /// // u_N scales like r^p: a distance 16 times as small gives 1/8
    /// let at = |r: f64| u.displacement([0.4 + r, 0.0])[0];
    /// assert!((at(0.32) / at(0.02) - 8.0).abs() < 1e-12);
    /// # Ok::<(), signorini::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`ToolkitError::OutOfRange`] unless 1/2 < p < 3/2 and |p − 1| ≥ 1/100 (u is linear for p = 1).
    pub fn power(p: f64, lame: Option<Lame>) -> Result<Self> {
        Ok(Self { formula: Formula::Power(Power::new(p, lame)?) })
    }

    /// The scalar solution with a transition at `position` and the given exponents there, contact to its right, and
    /// Dirichlet conditions on the other three sides.
    ///
    /// u = Re F − 4y, F = i z^p/sin πp, z = x − a + iy, a = `position`; for p = 1, with ℓ = 2 − ln z,
    /// F = i z ℓ^{1−α}/(π (1 − α)), or i z ln ℓ/π for α = 1. No contact for 0 ≤ x < a: with r = |x − a|,
    /// u_N = −r^p, or −r ℓ(r)^{−α} to leading order as r → 0 for p = 1. Contact for a ≤ x ≤ 1:
    /// σ_N = −r^q ℓ(r)^{−α}.
    ///
    /// ```
    /// use signorini::problems::{KnownSolution, TransitionPowers};
    /// let u = KnownSolution::transition(TransitionPowers::of_regularity(1.75), 0.4)?;
    /// // u = −r^{3/4} before the transition, 0 beyond
    /// assert!((u.displacement([0.4 - 0.0625, 0.0])[0] + 0.125).abs() < 1e-14);
    /// assert!(u.displacement([0.7, 0.0])[0].abs() < 1e-14);
    /// # Ok::<(), signorini::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`ToolkitError::OutOfRange`] unless 3/10 ≤ p ≤ 3/2, q > −1, α ≥ 0, 0 < position < 1; for p ≠ 1 also
    /// |p − 1| ≥ 1/10 and α = 0.
    pub fn transition(powers: TransitionPowers, position: f64) -> Result<Self> {
        Ok(Self { formula: Formula::Harmonic(Harmonic::new(powers, position, false)?) })
    }

    /// The solution of [`KnownSolution::transition`] for the problem with a reaction term and contact conditions on
    /// the whole boundary: Remark 1 as printed.
    ///
    /// −Δu + u = f with f = u, since u is harmonic; u ≤ 0 on all four sides, without contact on three of them.
    ///
    /// ```
    /// use signorini::problems::{KnownSolution, TransitionPowers};
    /// let powers = TransitionPowers::of_regularity(1.75);
    /// let [held, whole] = [KnownSolution::transition(powers, 0.4)?, KnownSolution::whole_boundary(powers, 0.4)?];
    /// // the same u, another form
    /// assert_eq!(held.displacement([0.3, 0.2]), whole.displacement([0.3, 0.2]));
    /// assert_ne!(held.form(), whole.form());
    /// # Ok::<(), signorini::Error>(())
    /// ```
    ///
    /// # Errors
    /// As for [`KnownSolution::transition`].
    pub fn whole_boundary(powers: TransitionPowers, position: f64) -> Result<Self> {
        Ok(Self { formula: Formula::Harmonic(Harmonic::new(powers, position, true)?) })
    }

    /// The Lamé constants; `None` for a scalar solution.
    pub fn lame(&self) -> Option<Lame> {
        match self.formula {
            Formula::Harmonic(_) => None,
            Formula::Westergaard(known) => known.lame,
            Formula::Power(known) => known.lame,
        }
    }

    /// The bilinear form.
    ///
    /// The Laplacian, plus the reaction term u v for [`KnownSolution::whole_boundary`]; elasticity with the given
    /// constants.
    ///
    /// ```
    /// use signorini::{fem::{Form, Lame}, problems::KnownSolution};
    /// let lame = Lame::new(2.0, 1.0)?;
    /// assert_eq!(KnownSolution::one_transition(Some(lame)).form(), Form::elastic(lame));
    /// assert_eq!(KnownSolution::three_halves().form(), Form::LAPLACE);
    /// # Ok::<(), signorini::Error>(())
    /// ```
    pub fn form(&self) -> Form {
        match self.formula {
            Formula::Harmonic(known) if known.whole_boundary => Form::Scalar { reaction: 1.0 },
            _ => self.lame().map_or(Form::LAPLACE, Form::elastic),
        }
    }

    /// The abscissae of the transitions, the end points of the contact set on y = 0 with 0 < x < 1,
    /// ascending.
    ///
    /// Those at 3/10, 2/5 and 7/10 are not nodes of a uniform dyadic mesh.
    pub fn transitions(&self) -> Vec<f64> {
        match self.formula {
            Formula::Westergaard(known) => known.transitions.to_vec(),
            Formula::Power(_) => vec![power::TRANSITION],
            Formula::Harmonic(known) => vec![known.position],
        }
    }

    /// The supremum of the τ with u ∈ H^τ and σ_N ∈ H^{τ−3/2}.
    ///
    /// It is 5/2 for r^{3/2}, p + 1 for powers, min(p + 1, q + 2) in general; attained only with a
    /// logarithmic factor, α > 1/2.
    ///
    /// ```
    /// use signorini::problems::KnownSolution;
    /// assert_eq!(KnownSolution::three_halves().regularity(), 2.5);
    /// assert_eq!(KnownSolution::power(1.25, None)?.regularity(), 2.25);
    /// # Ok::<(), signorini::Error>(())
    /// ```
    pub fn regularity(&self) -> f64 {
        match self.formula {
            Formula::Westergaard(_) => 2.5,
            Formula::Power(known) => known.power + 1.0,
            Formula::Harmonic(known) => {
                (known.powers.opening + 1.0).min(known.powers.pressure + 2.0)
            }
        }
    }

    /// The displacement u; for a scalar solution the second entry is 0.
    ///
    /// Cartesian components, at a point (x, y) of the closed unit square.
    pub fn displacement(&self, point: Point) -> Point {
        match self.formula {
            Formula::Westergaard(known) => known.displacement(point),
            Formula::Power(known) => known.displacement(point),
            Formula::Harmonic(known) => [known.displacement(point), 0.0],
        }
    }

    /// The gradient ∇u: row c is the gradient of component c.
    ///
    /// It is not finite at a transition if u ∉ C¹ there.
    ///
    /// ```
    /// use signorini::problems::KnownSolution;
    /// let u = KnownSolution::three_halves();
    /// let ([x, y], d) = ([0.7, 0.3], 1e-5);
    /// let along = |s: f64| u.displacement([x + s, y])[0];
    /// assert!(((along(d) - along(-d)) / (2.0 * d) - u.gradient([x, y])[0][0]).abs() < 1e-9);
    /// ```
    pub fn gradient(&self, point: Point) -> [Point; 2] {
        match self.formula {
            Formula::Westergaard(known) => known.gradient(point),
            Formula::Power(known) => known.gradient(point),
            Formula::Harmonic(known) => [known.gradient(point), [0.0; 2]],
        }
    }

    /// The normal stress σ_N ≤ 0 of the contact at (x, 0): n·σ(u)n, in the scalar case ∂u/∂n, minus the edge
    /// load.
    ///
    /// It is zero outside the contact set.
    pub fn normal_stress(&self, x: f64) -> f64 {
        match self.formula {
            Formula::Westergaard(known) => known.normal_stress(x),
            Formula::Power(known) => known.normal_stress(x),
            Formula::Harmonic(known) => known.normal_stress(x - known.position),
        }
    }

    /// The contact problem solved by u, on the structured mesh with n × n squares.
    ///
    /// Dirichlet data are interpolated at the nodes; loads on the contact edge are integrated exactly or by
    /// rules graded toward the transition.
    ///
    /// ```
    /// use signorini::{cone::Cone, contact::Solver, problems::KnownSolution};
    /// let u = KnownSolution::one_transition(None);
    /// let solution = u.problem(8)?.solve(Cone::Nodal, Solver::ActiveSet)?;
    /// // total contact force ∫ (3/2) √(3/10 − x) dx = (3/10)^{3/2}, up to the discretisation error
    /// assert!((solution.contact_force - 0.3f64.powf(1.5)).abs() < 0.05);
    /// # Ok::<(), signorini::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`ToolkitError::CountOutOfRange`] unless 1 ≤ n ≤ 16384; [`ToolkitError::TooLarge`] if there is not
    /// enough memory.
    pub fn problem(&self, n: usize) -> Result<ContactProblem> {
        let other = match self.formula {
            Formula::Westergaard(known) if known.has_free_sides => {
                return three_halves_problem(unit_square(n, SideParts::HANGING)?, 1.0);
            }
            Formula::Harmonic(known) if known.whole_boundary => Part::Contact,
            _ => Part::Dirichlet,
        };
        let sides = SideParts { bottom: Part::Contact, right: other, top: other, left: other };
        let mesh = unit_square(n, sides)?;
        let nothing = vec![0.0; mesh.nodes().len() * self.form().components()];
        let edge_load = match self.formula {
            Formula::Westergaard(_) => nothing.clone(),
            Formula::Power(known) => known.edge_load(n),
            Formula::Harmonic(known) => known.edge_load(&mesh)?,
        };
        let mut problem = ContactProblem::new(mesh, self.form(), &nothing)?;
        if let Formula::Harmonic(known) = self.formula
            && known.whole_boundary
        {
            // f = u: u is harmonic.
            let rule = self.rule(known.points() - 1)?;
            self.with_field(|field| problem.add_volume_load(field, &rule))?;
        }
        problem.add_load(&edge_load)?;
        self.with_field(|field| problem.set_dirichlet(field))?;
        Ok(problem)
    }

    /// The values of u at the nodes of a problem, node-major.
    ///
    /// ```
    /// use signorini::problems::KnownSolution;
    /// let u = KnownSolution::two_transitions(None);
    /// let problem = u.problem(4)?;
    /// let values = u.interpolant(&problem)?;
    /// // nodal values of u: the normal displacement at x = 1/2 is −(1/5)³
    /// assert!((problem.normal_displacement(&values)?[2] + 0.008).abs() < 1e-15);
    /// # Ok::<(), signorini::Error>(())
    /// ```
    ///
    /// # Errors
    /// As for [`Field::sample`].
    pub fn interpolant(&self, problem: &ContactProblem) -> Result<Vec<f64>> {
        self.with_field(|field| field.sample(problem.mesh().nodes()))
    }

    /// The norms of u − v for nodal values v on the mesh of a problem, by a fixed cubature rule graded toward
    /// the transitions, with 4 × 4 points per triangle: relative error about 1e-3, up to 3e-3 for [`KnownSolution::power`].
    ///
    /// ```
    /// use signorini::problems::KnownSolution;
    /// let u = KnownSolution::one_transition(None);
    /// let norms = |n| -> signorini::Result<_> {
    ///     let problem = u.problem(n)?;
    ///     u.error_norms(&problem, &u.interpolant(&problem)?)
    /// };
    /// // the interpolation error of a function of H^{5/2−ε}: order 1 in H¹, 2 in L²
    /// let (coarse, fine) = (norms(4)?, norms(8)?);
    /// assert!((coarse.h1 / fine.h1 - 2.0).abs() < 0.3 && coarse.l2 / fine.l2 > 3.0);
    /// # Ok::<(), signorini::Error>(())
    /// ```
    ///
    /// # Errors
    /// As for [`error_norms`].
    pub fn error_norms(&self, problem: &ContactProblem, values: &[f64]) -> Result<ErrorNorms> {
        self.norms(problem, values, POINTS)
    }

    /// The energy error a(u − v, u − v)^{1/2} for nodal values v on the mesh of a problem. Its error estimate is the
    /// difference from the rule with n − 1 instead of n points per direction; points are added until the
    /// tolerance is met. Near the transition the rule converges algebraically, and the true quadrature error may be a
    /// few times as large. Cost: two passes over the mesh with 9 to 25 points per triangle for two digits.
    ///
    /// ```
    /// use signorini::problems::KnownSolution;
    /// let u = KnownSolution::one_transition(None);
    /// let problem = u.problem(8)?;
    /// let zero = vec![0.0; problem.mesh().nodes().len()];
    /// let [norm, error] = [u.error(&problem, &zero, 1e-2)?, u.error(&problem, &u.interpolant(&problem)?, 1e-2)?];
    /// // the interpolation error is O(h), far below the norm of u
    /// assert!(error.value < 0.2 * norm.value && norm.error <= 1e-2 * norm.value);
    /// # Ok::<(), signorini::Error>(())
    /// ```
    ///
    /// # Errors
    /// As for [`error_norms`]; [`ToolkitError::ToleranceNotMet`] if 16 × 16 points per triangle do not suffice.
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
                return Err(Error::not_met(
                    "error in the energy norm",
                    tolerance.relative(),
                    found,
                    why,
                ));
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
        rule(points, &self.transitions())
    }

    fn with_field<T>(&self, then: impl FnOnce(&Field<'_>) -> T) -> T {
        if self.lame().is_some() {
            then(&Field::Vector(&|point| self.displacement(point)))
        } else {
            then(&Field::Scalar(&|point| self.displacement(point)[0]))
        }
    }

    /// The seminorm |u|₂ on (0, 1) × (0, 1/n), the square root of Σ_c ∫ (∂_x²u_c)² + 2 (∂_x∂_y u_c)² +
    /// (∂_y²u_c)²; the error estimate is the difference from a rule with fewer points, and points are added
    /// until the tolerance is met.
    ///
    /// It enters the interpolation error h |u|₂ on the row of elements at the contact edge. |u|₂² is additive over
    /// strips and finite, since u ∈ H^{5/2−ε}.
    ///
    /// ```
    /// use signorini::problems::KnownSolution;
    /// let u = KnownSolution::one_transition(None);
    /// let [all, half] = [u.second_seminorm(1, 1e-3)?.value, u.second_seminorm(2, 1e-3)?.value];
    /// // the second derivatives behave like r^{−1/2}: |u|₂² is concentrated near the edge
    /// assert!(half < all && half * half > 0.5 * all * all);
    /// # Ok::<(), signorini::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`ToolkitError::CountOutOfRange`] for n > 16384, [`ToolkitError::NotFinite`] for n = 0;
    /// [`ToolkitError::Incompatible`] unless u is [`KnownSolution::one_transition`] or
    /// [`KnownSolution::two_transitions`]; [`ToolkitError::ToleranceNotMet`] if the largest number of points
    /// does not meet the tolerance.
    pub fn second_seminorm(&self, n: usize, tolerance: impl Given<Tolerance>) -> Result<Estimate> {
        let tolerance = tolerance.given()?;
        match self.formula {
            Formula::Westergaard(known) => known.second_seminorm(n, tolerance),
            _ => Err(self
                .without("the seminorm of second derivatives", "one with one or two transitions")),
        }
    }

    /// The seminorm |∇u|_{τ−1} for 1 < τ < 2, and ‖D²u‖ for τ = 2, on the smallest half disc centred at the
    /// transition that contains the square.
    ///
    /// For τ = 2, with R the radius, q = p − 1, and polar coordinates (r, φ) at the transition:
    /// ‖D²(r^p sin pφ)‖² = p² q π R^{2q}; for elasticity this times (α² + β² + 1 − q + q²)/(4μ²),
    /// α = μ/(λ + μ), β = 1 + α.
    ///
    /// ```
    /// use signorini::problems::KnownSolution;
    /// let found = KnownSolution::power(1.25, None)?.body_seminorm(2.0, 1e-8)?;
    /// // the farthest corner of the square from (2/5, 0) is (1, 1): R² = 1.36
    /// let (p, q) = (1.25, 0.25);
    /// let exact = (p * p * q * std::f64::consts::PI * 1.36f64.powf(q)).sqrt();
    /// assert!((found.value - exact).abs() < 1e-12);
    /// # Ok::<(), signorini::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`ToolkitError::InfiniteNorm`] for τ ≥ p + 1; [`ToolkitError::OutOfRange`] unless 1 < τ ≤ 2;
    /// [`ToolkitError::Incompatible`] unless u is [`KnownSolution::power`]; and the errors of
    /// [`CornerFunction::elastic`](fractional_sobolev::CornerFunction::elastic).
    pub fn body_seminorm(&self, tau: f64, tolerance: impl Given<Tolerance>) -> Result<Estimate> {
        let tolerance = tolerance.given()?;
        match self.formula {
            Formula::Power(known) => known.body_seminorm(tau, tolerance),
            _ => Err(self.without("the seminorm of fractional order", "KnownSolution::power")),
        }
    }

    /// The seminorm |σ_N|_ν or |u_N'|_ν on the interval `part` = (from, to) of the edge.
    ///
    /// It is the Gagliardo seminorm (∫∫ |f(x) − f(y)|²/|x − y|^{1+2ν})^{1/2} on the interval. It is
    /// homogeneous: dilating the interval by k about the transition multiplies the value by k^{p−1/2−ν}.
    ///
    /// ```
    /// use signorini::problems::{EdgeDatum, KnownSolution};
    /// let u = KnownSolution::power(1.0 + 0.25, None)?;
    /// let on = |length: f64| u.edge_seminorm(EdgeDatum::Pressure, [0.4 - length, 0.4], 0.25, 1e-8);
    /// assert!((on(0.4)?.value / on(0.1)?.value - 4f64.powf(0.5)).abs() < 1e-6);
    /// # Ok::<(), signorini::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`ToolkitError::InfiniteNorm`] for ν ≥ p − 1/2; [`ToolkitError::Incompatible`] unless u is
    /// [`KnownSolution::power`]; and the errors of
    /// [`Function::from_fn`](fractional_sobolev::Function::from_fn) and
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
            _ => Err(self.without("the seminorm on the edge", "KnownSolution::power")),
        }
    }

    fn without(&self, with: &'static str, expected: &'static str) -> Error {
        let given = self.to_string();
        Error::Toolkit(ToolkitError::Incompatible { what: "known solution", given, with, expected })
    }
}

/// The problem of [`KnownSolution::three_halves`] on a mesh of the square, with all data multiplied by `scale`.
pub(super) fn three_halves_problem(mesh: Triangulation, scale: f64) -> Result<ContactProblem> {
    let u = Westergaard::three_halves();
    let load = vec![0.0; mesh.nodes().len()];
    let mut problem = ContactProblem::new(mesh, Form::LAPLACE, &load)?;
    problem.set_dirichlet(&Field::Scalar(&|point| scale * u.displacement(point)[0]))?;
    problem.add_boundary_load(Part::Neumann, &|point, normal| {
        Ok([scale * u.traction(point, normal)[0], 0.0])
    })?;
    Ok(problem)
}

/// α = μ/(λ + μ) and 2μ.
fn moduli(lame: Lame) -> (f64, f64) {
    (lame.mu() / (lame.lambda() + lame.mu()), 2.0 * lame.mu())
}

/// The rule with n × n points per triangle, graded toward the transitions.
fn rule(points: usize, transitions: &[f64]) -> Result<Cubature> {
    let singular: Vec<Point> = transitions.iter().map(|&x| [x, 0.0]).collect();
    Ok(Cubature::new(points)?.singular_at(&singular))
}

impl fmt::Display for KnownSolution {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.formula {
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
    use super::harmonic::tests::all_known;
    use super::*;
    use crate::cone::Cone;
    use crate::contact::Solver;

    #[test]
    fn the_rule_of_the_errors_is_fine_enough() {
        let lame = Some(Lame::new(1.3, 0.7).unwrap());
        let powers = [0.65, 1.3].map(|p| KnownSolution::power(p, lame).unwrap());
        let of_each =
            |lame| [KnownSolution::one_transition(lame), KnownSolution::two_transitions(lame)];
        let known = [of_each(None), of_each(lame), powers].concat();
        for known in known.into_iter().chain([KnownSolution::three_halves()]) {
            let problem = known.problem(8).unwrap();
            let values = known.interpolant(&problem).unwrap();
            let coarse = known.error_norms(&problem, &values).unwrap().energy;
            let fine = known.norms(&problem, &values, 10).unwrap().energy;
            // Four points a side see less of the gradient r^{p−1} of a rough solution than of r^{1/2}.
            let allowed = if powers.contains(&known) { 3e-3 } else { 1e-3 };
            assert!((coarse / fine - 1.0).abs() < allowed, "{known}: {coarse} {fine}");
            let found = known.error(&problem, &values, 1e-2).unwrap();
            assert_eq!(found.value, coarse, "{known}");
            assert!((found.value - fine).abs() <= 4.0 * found.error, "{known}: {found:?} {fine}");
        }
    }

    #[test]
    fn a_tolerance_is_met_or_refused() {
        let known = KnownSolution::power(0.65, None).unwrap();
        let problem = known.problem(4).unwrap();
        let values = known.interpolant(&problem).unwrap();
        let [rough, sharp] =
            [1e-2, 1e-5].map(|asked| known.error(&problem, &values, asked).unwrap());
        assert!(
            sharp.error <= 1e-5 * sharp.value
                && (rough.value - sharp.value).abs() <= 2.0 * rough.error
        );
        assert!(known.error(&problem, &values, 1e-15).is_err());
        assert!(known.second_seminorm(4, 1e-2).is_err());
        assert!(KnownSolution::three_halves().body_seminorm(1.75, 1e-3).is_err());
    }

    #[test]
    fn contact_is_found_where_it_is_in_both_cones() {
        for known in all_known(true).into_iter().chain(all_known(false)) {
            let known = KnownSolution { formula: Formula::Harmonic(known) };
            let problem = known.problem(16).unwrap();
            let [nodal, midpoint] = [Cone::Nodal, Cone::Midpoint].map(|cone| {
                let solution = problem.solve(cone, Solver::ActiveSet).unwrap();
                assert!(
                    solution.status.is_converged() && solution.kkt.worst() < 1e-12,
                    "{known} {cone}"
                );
                let error = known.error(&problem, &solution.displacement, 1e-2).unwrap();
                assert!(error.error < 1e-3 * error.value, "{known} {cone}: {error:?}");
                (solution.contact_set.count(), error.value)
            });
            assert!(nodal.0.abs_diff(2 * 16 / 3) <= 2, "{known}: {nodal:?}");
            // The errors of the two cones are of one size on every test problem.
            assert!(
                midpoint.1 < 1.5 * nodal.1 && nodal.1 < 1.5 * midpoint.1,
                "{known}: {nodal:?} {midpoint:?}"
            );
        }
        for opening in [0.2, 0.95, 1.6, f64::NAN] {
            let powers = TransitionPowers { opening, ..TransitionPowers::of_regularity(1.75) };
            assert!(KnownSolution::whole_boundary(powers, 0.5).is_err(), "{opening}");
        }
        assert!(KnownSolution::transition(TransitionPowers::of_regularity(1.75), 1.0).is_err());
    }
}
