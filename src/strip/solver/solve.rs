//! Contact on the edge: min ½ g'A g − b'g over the nodal or the midpoint cone.
//!
//! Semismooth Newton method for w = Proj(w + (b − A w)/σ), σ = ‖A‖, Proj the exact projection onto the cone: the
//! constraints active in the projection define a face, and the next w solves the linear problem on it. For the nodal
//! cone this is the primal-dual active set rule λ_i + σ w_i > 0, monotone because the scalar edge matrix is an
//! M-matrix; for the midpoint cone the standard rule stalls in checkerboard patterns, while the projection does not.
//! While the set changes, the linear problems are solved to only two digits. A start from the grid of twice the mesh
//! size interpolates set and values. If a set recurs, the linear problems are solved accurately; if one
//! recurs again, the iteration continues with feasible descent: every step decreases J, so that no set can
//! recur.
//!
//! Multipliers: A w + B'λ = b with λ ≥ 0; for the midpoint cone (B w)_i = (w_i + w_{i+1})/2, λ by recursion
//! along each contact interval. Cost: O(n log n) per inner iteration, a few dozen of them per level.

use super::inner::FaceSolver;
use super::solution::EdgeSolution;
use crate::cone::{Cone, ContactSet, EdgeCone, Face, KktTerms, Status};
use crate::error::{Error, Result, ToolkitError};
use crate::numeric::check::{require_finite, require_values};
use crate::numeric::scale::largest;
use crate::numeric::sum::pairwise_dot;
use crate::strip::operator::edge::EdgeOperator;
use crate::strip::transfer::prolong;
use fractional_sobolev::{Given, Tolerance};
use std::collections::HashSet;
use std::hash::{DefaultHasher, Hash, Hasher};

/// Reduction of the residual of the linear problems while the contact set changes.
const REDUCTION: f64 = 1e-2;

/// Largest number of linear problems; about ten are typical for a start from the grid of twice the mesh
/// size.
const STEPS: usize = 200;

/// Largest number of inner iterations per linear problem; about twenty are typical.
const INNER_STEPS: usize = 200;

/// A repeated accurate linear solve whose residual remains above this fraction of the previous one has reached the
/// rounding level.
const STALLED: f64 = 0.5;

impl EdgeOperator {
    /// The contact solution, the minimiser of ½ g'A g − b'g over the cone, for nodal forces b; the initial guess
    /// `start` is a solution on the grid of twice the mesh size or on the same grid.
    ///
    /// The residual of the linear problem on the final contact set is at most `tolerance`, relative and in
    /// the norm (r'B r)^{1/2}, B the preconditioner, which is equivalent to the energy norm of the error; a
    /// further step at this accuracy leaves the set unchanged; 1e-13 is about a hundred times the rounding
    /// level of binary64. Cost: O(n log n) per inner iteration, a few dozen of them per level.
    ///
    /// ```
    /// use signorini::{cone::Cone, strip::Strip};
    /// let strip = Strip::scalar(8, 8)?;
    /// let b: Vec<f64> = (0..9).map(|i| (i as f64).cos()).collect();
    /// let solve = |cone| strip.operator().solve_contact(&b, cone, None, 1e-13);
    /// // the midpoint cone contains the nodal one: its minimum is not larger
    /// assert!(solve(Cone::Midpoint)?.energy <= solve(Cone::Nodal)?.energy + 1e-14);
    /// # Ok::<(), signorini::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`ToolkitError::LengthMismatch`], [`ToolkitError::NotFinite`], [`ToolkitError::OutOfRange`] for
    /// invalid data. [`Error::NotConverged`], with the best [`EdgeSolution`], if the tolerance is not reached; one
    /// below the rounding level leads to [`Status::Stalled`].
    pub fn solve_contact(
        &self,
        force: &[f64],
        cone: Cone,
        start: Option<&EdgeSolution>,
        tolerance: impl Given<Tolerance>,
    ) -> Result<EdgeSolution> {
        let tolerance = tolerance.given()?.relative();
        require_values("edge load", force, self.nodes())?;
        // The problem is positively homogeneous: it is solved for a load of size one.
        let size = largest(force);
        let scale = if size > 0.0 { size } else { 1.0 };
        let unit: Vec<f64> = force.iter().map(|b| b / scale).collect();
        let mut iteration = Iteration::new(self, &unit, cone, tolerance);
        iteration.start(start, scale)?;
        let status = iteration.run()?;
        let mut solution = iteration.finish(status)?;
        solution.values.iter_mut().chain(&mut solution.multiplier).for_each(|v| *v *= scale);
        solution.energy = solution.energy * scale * scale;
        solution.error *= scale;
        require_finite("energy", &[solution.energy])?;
        match solution.status.is_converged() {
            true => Ok(solution),
            false => Err(Error::not_converged(solution.status, solution.energy, solution)),
        }
    }
}

struct Iteration<'a> {
    operator: &'a EdgeOperator,
    cone: EdgeCone,
    tolerance: f64,
    b: &'a [f64],
    solver: FaceSolver<'a>,
    values: Vec<f64>,
    active: Vec<bool>,
    inner: Vec<usize>,
}

impl<'a> Iteration<'a> {
    fn new(operator: &'a EdgeOperator, b: &'a [f64], cone: Cone, tolerance: f64) -> Self {
        let cone = operator.cone(cone);
        Self {
            operator,
            cone,
            tolerance,
            b,
            solver: FaceSolver::new(operator),
            values: vec![0.0; operator.nodes()],
            active: vec![false; cone.constraints()],
            inner: Vec::new(),
        }
    }

    /// Without a start: the face of Proj(b/σ). With a coarse start: values interpolated, contact intervals refined.
    fn start(&mut self, start: Option<&EdgeSolution>, scale: f64) -> Result<()> {
        let Some(start) = start else {
            self.active = self.next_set()?;
            return Ok(());
        };
        let cells = self.operator.cells();
        let nodes = self.operator.nodes();
        if start.values.len() == nodes {
            self.values.copy_from_slice(&start.values);
        } else if start.values.len() == self.operator.sides().nodes(cells / 2) {
            self.values = prolong(&start.values, nodes);
        } else {
            return Err(Error::Toolkit(ToolkitError::LengthMismatch {
                name: "start",
                given: start.values.len(),
                expected: nodes,
            }));
        }
        self.values.iter_mut().for_each(|v| *v /= scale);
        self.active = match (start.cone == self.cone.kind(), start.values.len() == nodes) {
            (true, true) => start.contact.as_slice().to_vec(),
            (true, false) => self.cone.refined_set(&start.contact)?.as_slice().to_vec(),
            // For a start from the other cone, a constraint counts as active if (B w)_i ≥ 0.
            (false, _) => self.cone.apply(&self.values).iter().map(|&mean| mean >= 0.0).collect(),
        };
        Ok(())
    }

    fn run(&mut self) -> Result<Status> {
        let mut visited = HashSet::new();
        let mut accurate = false;
        let mut last = f64::INFINITY;
        for _ in 0..STEPS {
            let reduction = if accurate { 0.0 } else { REDUCTION };
            let residual = self.newton_step(reduction)?;
            let next = self.next_set()?;
            if next == self.active {
                if residual <= self.tolerance {
                    return Ok(Status::Converged);
                }
                if accurate && residual > STALLED * last {
                    return Ok(Status::Stalled { residual });
                }
                last = if accurate { residual } else { f64::INFINITY };
                accurate = true;
                continue;
            }
            // If a set recurs: first more accurate linear problems, then a descent that cannot cycle.
            if !visited.insert(fingerprint(&next)) {
                if accurate {
                    return self.descend();
                }
                accurate = true;
                visited.clear();
            }
            last = f64::INFINITY;
            self.active = next;
        }
        Ok(Status::StepLimit { steps: self.inner.len() })
    }

    fn newton_step(&mut self, reduction: f64) -> Result<f64> {
        let face = Face::new(self.cone, &self.active);
        let inner = self.solver.solve(
            &face,
            self.b,
            &mut self.values,
            self.tolerance,
            reduction,
            INNER_STEPS,
        )?;
        self.inner.push(inner.iterations);
        Ok(inner.residual)
    }

    /// w + (b − A w)/σ on contact intervals, w on non-contact intervals.
    fn shifted(&mut self) -> Result<Vec<f64>> {
        let mut product = vec![0.0; self.operator.nodes()];
        self.solver.product(&self.values, &mut product)?;
        let face = Face::new(self.cone, &self.active);
        let mut shifted = self.values.clone();
        let sigma = self.operator.norm();
        for run in face.runs() {
            for i in run.nodes(shifted.len()) {
                shifted[i] += (self.b[i] - product[i]) / sigma;
            }
        }
        Ok(shifted)
    }

    fn next_set(&mut self) -> Result<Vec<bool>> {
        let shifted = if self.active.iter().any(|&a| a) || self.values.iter().any(|&v| v != 0.0) {
            self.shifted()?
        } else {
            self.b.to_vec()
        };
        Ok(self.cone.nearest(&shifted).1)
    }

    /// Feasible descent: a projected gradient step selects the face, the Newton step on it is truncated at the
    /// boundary of the cone.
    ///
    /// p = Proj(w + (b − A w)/σ) lowers J by at least σ|p − w|²/2, as A ≤ σ; then w ← p + t (v − p), v the minimiser on
    /// the face of p and t the longest step in the cone. J falls strictly until the KKT conditions hold.
    fn descend(&mut self) -> Result<Status> {
        let sigma = self.operator.norm();
        let (mut feasible, _) = self.cone.nearest(&self.values);
        let mut product = vec![0.0; feasible.len()];
        while self.inner.len() < STEPS {
            self.solver.product(&feasible, &mut product)?;
            let z: Vec<f64> = (0..feasible.len())
                .map(|i| feasible[i] + (self.b[i] - product[i]) / sigma)
                .collect();
            let (point, active) = self.cone.nearest(&z);
            self.active = active;
            self.values.copy_from_slice(&point);
            let residual = self.newton_step(0.0)?;
            let step = self.cone.longest_step(&point, &self.values, &self.active);
            if step >= 1.0 && self.next_set()? == self.active && residual <= self.tolerance {
                return Ok(Status::Converged);
            }
            feasible =
                (0..point.len()).map(|i| point[i] + step * (self.values[i] - point[i])).collect();
        }
        Ok(Status::StepLimit { steps: self.inner.len() })
    }

    fn finish(mut self, status: Status) -> Result<EdgeSolution> {
        let nodes = self.operator.nodes();
        let mut product = vec![0.0; nodes];
        self.solver.product(&self.values, &mut product)?;
        let surplus: Vec<f64> = (0..nodes).map(|i| self.b[i] - product[i]).collect();
        let multiplier = self.cone.multipliers(&self.active, &surplus, |_| false);
        let held = self.cone.apply_transposed(&multiplier)?;
        let residual: Vec<f64> = (0..nodes).map(|i| held[i] - surplus[i]).collect();
        let gap = self.cone.apply(&self.values);
        let displacement = largest(&self.values);
        let terms = KktTerms {
            residual: &residual,
            multiplier: &multiplier,
            gap: &gap,
            // ‖A‖ max|g| + max|b|: the size of the terms of the balance.
            force: self.operator.norm() * displacement + largest(self.b),
            displacement,
        };
        let kkt = terms.residuals()?;
        let status = match status {
            Status::Stalled { .. } => Status::Stalled { residual: kkt.worst() },
            status => status,
        };
        let margins = terms.margins(&self.active)?;
        let error = self.error(&product, &multiplier, &gap)?;
        let energy =
            0.5 * pairwise_dot(&self.values, &product) - pairwise_dot(self.b, &self.values);
        Ok(EdgeSolution {
            cells: self.operator.cells(),
            multiplier,
            contact: ContactSet::new(&self.active),
            values: self.values,
            cone: self.cone.kind(),
            energy,
            error,
            status,
            kkt,
            margins,
            inner_iterations: self.inner,
        })
    }
}

impl Iteration<'_> {
    /// The bound on |w − w_h|_A.
    ///
    /// With e = w_h − w, A w_h = b − B'λ_h and A w = b − r − B'λ⁺: e'A e = r'e + (λ⁺ − λ_h)'B e ≤ R |e|_A + C, because
    /// B w_h ≤ 0, λ_h'B w_h = 0 and λ_h ≈ λ⁺ where rounding leaves B w > 0. Two transforms of length P leave errors
    /// of ε log₂ P (|b| + |A w|) in r, without a preferred mode: in A⁻¹ they count by the mean of 1/S.
    fn error(&self, product: &[f64], multiplier: &[f64], gap: &[f64]) -> Result<f64> {
        let pushing: Vec<f64> = multiplier.iter().map(|l| l.max(0.0)).collect();
        let held = self.cone.apply_transposed(&pushing)?;
        let residual: Vec<f64> =
            (0..held.len()).map(|i| self.b[i] - product[i] - held[i]).collect();
        let square = pairwise_dot(&residual, &self.operator.solve(&residual)?);
        let (symbol, period) =
            (self.operator.symbol(), self.operator.sides().period(self.operator.cells()));
        let size = (pairwise_dot(product, product) + pairwise_dot(self.b, self.b)).sqrt();
        let mean = symbol.iter().map(|s| s.recip()).sum::<f64>() / symbol.len() as f64;
        let rounding = f64::EPSILON * (period as f64).log2() * size * mean.sqrt();
        let dual = square.max(0.0).sqrt() + rounding;
        let work: f64 = pushing.iter().zip(gap).map(|(l, gap)| l * gap.abs()).sum();
        Ok(0.5 * dual + (0.25 * dual * dual + work).sqrt())
    }
}

/// A 64-bit hash of the active flags; a collision would start the descent early, which also converges.
fn fingerprint(active: &[bool]) -> u64 {
    let mut hasher = DefaultHasher::new();
    active.hash(&mut hasher);
    hasher.finish()
}
