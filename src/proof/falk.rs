//! Falk's lemma for both cones, term by term, in the energy norm of the strip.
//!
//! With |·| the energy norm, σ_N the exact contact stress and v_h any function of the discrete cone,
//!
//! |u − u_h|² ≤ |u − v_h|² + 2 ∫ σ_N (v_h − u)_N                                        (K^h ⊂ K, Section 3),
//! |u − ū_h|² ≤ |u − v_h|² + 2 ∫ σ_N (v_h − u)_N + 2 inf_{v ∈ K} ∫ σ_N (v − ū_h)_N      (4.5).
//!
//! Proof: |u−u_h|² = a(u−u_h, u−v_h) + a(u−u_h, v_h−u_h), the last is at most ∫σ_N(v_h−u_h)_N by both
//! variational statements; Young with weights 1/2, 1/2. Hence the constant of the lemma is at most 2 when, as
//! in the paper, the integrals have no factor 2.
//!
//! * v_h = I^h u: its values on the edge, continued with least energy, so |u − v_h| is at most that of the
//!   Lagrange interpolant.
//! * *The first infimum is known*: ½|u−v|² + ∫σ_N(v−u)_N = J(v) − J(u), which u_h minimises over its cone. It
//!   equals |u−u_h|² + 2∫σ_N u_{h,N}: with it (4.5) is an equality for K̄^h, and for K^h it exceeds |u−u_h|²
//!   by 2∫σ_N u_{h,N} ≥ 0.
//! * *The second infimum is known*: ∫σ_N v_N ≥ 0 on K, so v = 0 attains it, −∫σ_N ū_{h,N}; negative if ū_h
//!   is open where σ_N < 0.
//! * (4.8): −∫σ_N ū_h ≤ −∫(σ_N − π^hσ_N)(ū_h − u)_N − ∫(σ_N − π^hσ_N)u_N, since π^hσ_N ≤ 0 has ∫π^hσ_N ū_h ≥
//!   0.
//!
//! σ_N is given by nodal forces of the fine edge; a force at a vertex counts half in each of its segments.
//! Cost: two transforms of the fine edge.

use crate::cone::Cone;
use crate::edge::{EdgeTrace, Interval, midpoint_term, nodal_term};
use crate::error::Result;
use crate::strip::{EdgeSolution, StripProblem};

/// The terms of the lemma for one pair (u, u_h); all squared, integrals without the factor 2.
///
/// |·|² is the energy of the strip, the sign convention u_N ≤ 0, σ_N ≤ 0. `consistency` is ≥ 0, as an integral of a
/// product of two nonpositive functions; |u − u_h|² ≤ 2 [`FalkTerms::bracket`].
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct FalkTerms {
    /// |u − u_h|².
    pub error: f64,
    /// |u − v_h|², v_h = I^h u on the edge.
    pub approximation: f64,
    /// ∫ σ_N (I^h u − u)_N = ∫ σ_N (I^h u)_N.
    pub consistency: f64,
    /// inf over K of ∫ σ_N (v − u_h)_N = −∫ σ_N u_{h,N}; in K^h it is ≤ 0 and does not enter.
    pub second_infimum: f64,
    /// −∫ (σ_N − π^h σ_N)(u_h − u)_N.
    pub first_part: f64,
    /// −∫ (σ_N − π^h σ_N) u_N.
    pub second_part: f64,
}

impl FalkTerms {
    /// The terms on the mesh of `n` segments: u is the exact edge of `problem`, `trace` its trace on the fine grid,
    /// `solution` the discrete solution.
    ///
    /// # Errors
    /// [`ToolkitError::LengthMismatch`](crate::ToolkitError::LengthMismatch) where the solution does not belong to the mesh.
    pub fn new(problem: &StripProblem, trace: &EdgeTrace, n: usize, solution: &EdgeSolution) -> Result<Self> {
        let vertices: Vec<f64> = (0..=n).map(|i| i as f64 / n as f64).collect();
        let segments = || vertices.windows(2).map(|v| Interval { start: v[0], end: v[1] });
        let step = (trace.nodes().len() - 1) / n;
        // As many nodal values as the discrete solution has: a ring does not repeat its first one.
        let interpolant: Vec<f64> =
            (0..solution.values.len()).map(|i| trace.displacement()[i * step]).collect();
        let mut discrete = solution.values.clone();
        if discrete.len() == n {
            discrete.push(discrete[0]);
        }
        let on_edge = EdgeTrace::new(vertices.clone(), discrete, vec![0.0; n + 1], f64::INFINITY)?;
        let approximation = problem.error(n, &interpolant)?;
        let error = problem.error(n, &solution.values)?;
        let mut terms = Self {
            error: error.value * error.value,
            approximation: approximation.value * approximation.value,
            ..Self::default()
        };
        terms.consistency = sum(segments().map(|s| nodal_term(trace, s)));
        terms.second_part = sum(segments().map(|s| midpoint_term(trace, s)));
        // σ_N = −λ: −∫ σ_N w = Σ λ_i w(x_i).
        let work: Vec<f64> = trace
            .nodes()
            .iter()
            .zip(trace.force())
            .map(|(&x, force)| force * on_edge.displacement_at(x))
            .collect();
        terms.second_infimum = sum(work.iter().copied());
        // −∫ π^h σ_N w = Σ_T F_T mean_T w; mean_T u_N enters through the second part.
        let projected = sum(segments().enumerate().map(|(i, s)| {
            let mean = 0.5 * (on_edge.displacement()[i] + on_edge.displacement()[i + 1]);
            force_in(trace, s) * mean
        }));
        terms.first_part = terms.second_infimum - projected - terms.second_part;
        Ok(terms)
    }

    /// |u−v_h|² + ∫σ_N(v_h−u)_N, for the midpoint cone + inf_K ∫σ_N(v−ū_h)_N: the factor of C in the lemma.
    pub fn bracket(&self, cone: Cone) -> f64 {
        let second = if cone == Cone::Midpoint { self.second_infimum } else { 0.0 };
        self.approximation + self.consistency + second
    }

    /// |u−u_h|² over the bracket: the measured constant, at most 2.
    pub fn constant(&self, cone: Cone) -> f64 {
        self.error / self.bracket(cone)
    }

    /// inf over the discrete cone of |u−v_h|² + 2∫σ_N(v_h−u)_N = |u−u_h|² + 2∫σ_N u_{h,N}.
    pub fn first_infimum(&self) -> f64 {
        self.error - 2.0 * self.second_infimum
    }
}

/// −∫_T σ_N; forces at inner vertices count half.
fn force_in(trace: &EdgeTrace, segment: Interval) -> f64 {
    let nodes = trace.nodes();
    let (from, to) =
        (nodes.partition_point(|&x| x < segment.start), nodes.partition_point(|&x| x <= segment.end));
    let last = nodes.len() - 1;
    sum((from..to).map(|i| {
        let is_vertex = nodes[i] == segment.start || nodes[i] == segment.end;
        let share = if is_vertex && i > 0 && i < last { 0.5 } else { 1.0 };
        share * trace.force()[i]
    }))
}

fn sum(terms: impl Iterator<Item = f64>) -> f64 {
    terms.fold(0.0, |sum, term| sum + term)
}
