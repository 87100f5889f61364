//! A scalar contact problem on the unit square with known solution of any regularity about one transition.
//!
//! u = ± r^p sin(pφ), 1/2 < p < 3/2, p ≠ 1, with r, φ from the transition (a, 0), φ = 0 on the side of
//! contact x < a: harmonic, u = 0 in contact and u = −|sin(pπ)| r^p in the gap. σ_N = −p |sin(pπ)| r^{p−1} in
//! contact and 0 in the gap, of the size of u_N'; the edge carries the load ∂u/∂n − σ_N besides, which is
//! again a power on each side, and u is prescribed on the other three sides. So u ∈ H^τ exactly for τ < p +
//! 1, and σ_N, u_N' ∈ H^ν exactly for ν < p − 1/2. For p = 3/2 no load would be left.

use crate::cone::Cone;
use crate::contact::{ContactProblem, ContactSolution, Solver};
use crate::error::{Error, Result};
use crate::estimate::{Estimate, Tolerance};
use crate::fem::{Cubature, ErrorNorms, Field, Form, error_norms};
use crate::mesh::{Part, Point, Sides, unit_square};
use crate::sobolev::{FractionalOrder, Position, SingularFunction};
use std::f64::consts::PI;

/// a: no node of uniform dyadic meshes.
const TRANSITION: f64 = 0.4;
/// Points along each side of a triangle's rule for errors, graded towards the transition.
const POINTS: usize = 4;

/// The scene, by its power.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RoughTransition {
    power: f64,
}

/// One mesh with n × n squares.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RoughLevel {
    /// n; h = 1/n.
    pub n: usize,
    /// |u − u_h|₁.
    pub error: f64,
    /// |u − I^h u|₁.
    pub interpolation: f64,
}

/// Which function of the edge.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum EdgeDatum {
    /// σ_N.
    Pressure,
    /// u_N'.
    Slope,
}

impl RoughTransition {
    /// u ∈ H^τ for τ < p + 1.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless 1/2 < p < 3/2 and |p − 1| ≥ 1/100 (u would be linear).
    pub fn new(power: f64) -> Result<Self> {
        let admissible = power > 0.5 && power < 1.5 && (power - 1.0).abs() >= 0.01;
        let power = Error::require("p", power, "(1/2, 3/2), not about 1", admissible)?;
        Ok(Self { power })
    }

    /// p.
    pub fn power(&self) -> f64 {
        self.power
    }

    /// The radius of the half disc about the transition that holds the square.
    pub fn radius(&self) -> f64 {
        TRANSITION.max(1.0 - TRANSITION).hypot(1.0)
    }

    /// u = `sign` r^p sin(pφ).
    fn sign(&self) -> f64 {
        -(PI * self.power).sin().signum()
    }

    fn polar([x, y]: Point) -> (f64, f64) {
        ((x - TRANSITION).hypot(y), y.atan2(TRANSITION - x))
    }

    /// u.
    pub fn exact(&self, point: Point) -> f64 {
        let (r, phi) = Self::polar(point);
        self.sign() * r.powf(self.power) * (self.power * phi).sin()
    }

    /// ∇u.
    pub fn gradient(&self, point: Point) -> Point {
        let (r, phi) = Self::polar(point);
        let (size, angle) = (self.sign() * self.power * r.powf(self.power - 1.0), (self.power - 1.0) * phi);
        [-size * angle.sin(), size * angle.cos()]
    }

    /// σ_N before the transition and u_N' beyond, over r^{p−1}.
    fn size(&self) -> f64 {
        -self.power * (PI * self.power).sin().abs()
    }

    /// |σ_N|_ν or |u_N'|_ν on the part (from, to) of the edge.
    ///
    /// # Errors
    /// [`Error::InfiniteNorm`] for ν ≥ p − 1/2; as [`SingularFunction::seminorm`].
    pub fn edge_seminorm(
        &self,
        datum: EdgeDatum,
        [from, to]: [f64; 2],
        order: FractionalOrder,
        tolerance: Tolerance,
    ) -> Result<Estimate> {
        if order.value() >= self.power - 0.5 {
            let why = "r^(p-1) on one side of a point is in H^nu only for nu < p - 1/2";
            return Err(Error::InfiniteNorm { order: order.value(), why });
        }
        let value = |distance: f64| {
            let is_inside = (distance < 0.0) == (datum == EdgeDatum::Pressure);
            if is_inside { self.size() * distance.abs().powf(self.power - 1.0) } else { 0.0 }
        };
        if !(from < TRANSITION && TRANSITION < to) {
            let whole = SingularFunction::new(&[from, to], |x| value(x - TRANSITION))?;
            return whole.seminorm(order, tolerance);
        }
        let breaks = [from, TRANSITION, to];
        let at = |at: Position| value(if at.anchor() == 1 { at.offset() } else { at.x() - TRANSITION });
        SingularFunction::from_positions(&breaks, at)?.seminorm(order, tolerance)
    }

    /// The segment with the transition inside, of n equal ones.
    pub fn segment(&self, n: usize) -> [f64; 2] {
        let first = (TRANSITION * n as f64).floor();
        [first, first + 1.0].map(|i| i / n as f64)
    }

    /// ∂u/∂n − σ_N on both sides, over r^{p−1}.
    fn loads(&self) -> [f64; 2] {
        let slope = self.sign() * self.power;
        [-slope - self.size(), slope * (PI * self.power).cos()]
    }

    /// The problem on the structured mesh with n × n squares; the load of the edge is integrated exactly.
    ///
    /// # Errors
    /// [`Error::CountOutOfRange`] unless 1 ≤ n ≤ 16384.
    pub fn problem(&self, n: usize) -> Result<ContactProblem> {
        let given = Part::Dirichlet;
        let mesh = unit_square(n, Sides { bottom: Part::Contact, right: given, top: given, left: given })?;
        let mut load = vec![0.0; mesh.nodes().len()];
        let (h, q) = (1.0 / n as f64, self.power - 1.0);
        // ∫ r^q over the part and ∫ r^{q+1}, with r from `near` to `far`.
        let moment = |k: f64, near: f64, far: f64| (far.powf(q + k) - near.powf(q + k)) / (q + k);
        for i in 0..n {
            let (left, right) = (i as f64 * h, (i + 1) as f64 * h);
            for (size, side) in self.loads().into_iter().zip([-1.0, 1.0]) {
                let (low, high) =
                    if side < 0.0 { (left, right.min(TRANSITION)) } else { (left.max(TRANSITION), right) };
                if low >= high {
                    continue;
                }
                let distances = [low, high].map(|x| side * (x - TRANSITION));
                let (near, far) = (distances[0].min(distances[1]).max(0.0), distances[0].max(distances[1]));
                let (whole, first) = (moment(1.0, near, far), moment(2.0, near, far));
                // The hat of the right node is (x − left)/h, x = a ± r.
                let right_part = ((TRANSITION - left) * whole + side * first) / h;
                load[i + 1] += size * right_part;
                load[i] += size * (whole - right_part);
            }
        }
        let nothing = vec![0.0; load.len()];
        let mut problem = ContactProblem::new(mesh, Form::LAPLACE, &nothing)?;
        problem.add_load(&load)?;
        problem.set_dirichlet(&Field::Scalar(&|point| self.exact(point)))?;
        Ok(problem)
    }

    /// Norms of u − v for nodal values v on the mesh of a problem.
    ///
    /// # Errors
    /// As [`error_norms`].
    pub fn error(&self, problem: &ContactProblem, values: &[f64]) -> Result<ErrorNorms> {
        let rule = Cubature::new(POINTS)?.singular_at(&[[TRANSITION, 0.0]]);
        let (field, gradient) = (|point| self.exact(point), |point| [self.gradient(point), [0.0; 2]]);
        error_norms(problem.mesh(), problem.form(), values, (&Field::Scalar(&field), &gradient), &rule)
    }

    /// n = 4, 8, ..., 2^finest, each solved from the contact set of the mesh before.
    ///
    /// # Errors
    /// [`Error::CountOutOfRange`] unless 2 ≤ finest ≤ 11; [`Error::ToleranceNotMet`] for a solution that does
    /// not meet its conditions; whatever problems and solvers return.
    pub fn levels(&self, cone: Cone, finest: u32) -> Result<Vec<RoughLevel>> {
        if !(2..=11).contains(&finest) {
            let (name, value) = ("finest level", finest as usize);
            return Err(Error::CountOutOfRange { name, value, range: "[2, 11]" });
        }
        let mut coarse: Option<ContactSolution> = None;
        let mut levels = Vec::new();
        for n in (2..=finest).map(|level| 1usize << level) {
            let problem = self.problem(n)?;
            let solution = match &coarse {
                Some(coarse) => problem.solve_after(coarse)?,
                None => problem.solve(cone, Solver::ActiveSet)?,
            };
            if !solution.status.is_converged() {
                let reached = solution.judgement.worst();
                let why = "the active-set iteration did not converge";
                return Err(Error::out_of_reach("contact conditions", 1e-8, reached, why));
            }
            let sampled = Field::Scalar(&|point| self.exact(point)).sample(problem.mesh().nodes())?;
            levels.push(RoughLevel {
                n,
                error: self.error(&problem, &solution.displacement)?.energy,
                interpolation: self.error(&problem, &sampled)?.energy,
            });
            coarse = Some(solution);
        }
        Ok(levels)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn conditions_hold_and_the_load_is_what_is_left() {
        for power in [0.65, 0.8, 0.95, 1.1, 1.3] {
            let scene = RoughTransition::new(power).unwrap();
            for i in 0..=20 {
                let x = f64::from(i) / 20.0 + 1e-3;
                let (r, side) = ((x - TRANSITION).abs(), usize::from(x > TRANSITION));
                let (u, normal) = (scene.exact([x, 0.0]), -scene.gradient([x, 0.0])[1]);
                let pressure = normal - scene.loads()[side] * r.powf(power - 1.0);
                assert!(u <= 1e-15 && pressure <= 1e-14 && (u * pressure).abs() < 1e-14, "{power} {x}");
                assert!(side == 0 || u < 0.0);
                assert!(side == 1 || pressure < 0.0);
            }
            let (h, [x, y]) = (1e-5, [0.55, 0.2]);
            let sides = [[x + h, y], [x - h, y], [x, y + h], [x, y - h]].map(|p| scene.exact(p));
            let slope = scene.gradient([x, y]);
            assert!(((sides[0] - sides[1]) / (2.0 * h) - slope[0]).abs() < 1e-8);
            assert!(((sides[2] - sides[3]) / (2.0 * h) - slope[1]).abs() < 1e-8);
        }
    }

    #[test]
    fn bad_powers_and_infinite_norms_are_errors() {
        assert!(RoughTransition::new(1.0).is_err() && RoughTransition::new(0.4).is_err());
        let scene = RoughTransition::new(0.8).unwrap();
        let order = FractionalOrder::new(0.3).unwrap();
        assert!(scene.edge_seminorm(EdgeDatum::Slope, [0.0, 1.0], order, Tolerance::fast()).is_err());
    }
}
