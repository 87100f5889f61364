//! Conjugate gradients in a face, preconditioned by the cycle, with estimates of the spectrum of the
//! preconditioned matrix.
//!
//! A step makes the next direction conjugate to the last one p by z'q/p'q, q = K p, z the preconditioned
//! residual (the cycle applied to r = F − K x), which accounts for the rounding errors of the cycle. The
//! coefficients are those of a Lanczos process: the smallest eigenvalue of its matrix is an upper bound of
//! the smallest eigenvalue κ of cycle times K, and ρ = r'z estimates the energy of the error, ρ/κ ≥ |e|² ≥ ρ
//! for exact coarse spaces. Unlike `numeric::ConjugateGradients`, the plain method in f64, the preconditioned
//! residual is in f32, the update of the direction uses a different quotient, and the coefficients are
//! stored.

use super::cycle::Cycle;
use super::level::Level;
use super::vectors::{add_scaled, dot, turn};

/// Number of bisections for the smallest eigenvalue: three digits.
const BISECTIONS: usize = 12;

pub(super) struct Gradients {
    pub(super) residual: Vec<f64>,
    direction: Vec<f64>,
    image: Vec<f64>,
    rho: f64,
    /// Step lengths and update coefficients since the last start.
    lengths: Vec<f64>,
    turns: Vec<f64>,
    /// The smallest eigenvalue found so far.
    least: f64,
}

impl Gradients {
    /// The state for this many unknowns; `least` is a known bound of κ, otherwise 1.
    pub(super) fn new(unknowns: usize, least: f64) -> Self {
        let zeros = || vec![0.0; unknowns];
        Self {
            residual: zeros(),
            direction: zeros(),
            image: zeros(),
            rho: 0.0,
            lengths: Vec::new(),
            turns: Vec::new(),
            least,
        }
    }

    pub(super) fn start<L: Level>(&mut self, cycle: &mut Cycle<'_, L>) {
        self.least = self.least.min(self.least_eigenvalue());
        self.lengths.clear();
        self.turns.clear();
        let (z, factor) = cycle.apply(&self.residual);
        self.rho = (factor * dot(&self.residual, z)).max(0.0);
        turn(&mut self.direction, 0.0, factor, z);
    }

    /// ρ = r'z.
    pub(super) fn rho(&self) -> f64 {
        self.rho
    }

    /// Performs one step; false if there is no descent direction.
    pub(super) fn step<L: Level>(
        &mut self,
        level: &L,
        cycle: &mut Cycle<'_, L>,
        x: &mut [f64],
    ) -> bool {
        level.multiply(&self.direction, &mut self.image);
        let curvature = dot(&self.direction, &self.image);
        let length = self.rho / curvature;
        // The negated comparison also holds for NaN.
        if !(curvature > 0.0 && length > 0.0 && length.is_finite()) {
            return false;
        }
        add_scaled(x, length, &self.direction);
        add_scaled(&mut self.residual, -length, &self.image);
        let (z, factor) = cycle.apply(&self.residual);
        let next = (factor * dot(&self.residual, z)).max(0.0);
        let turned = -factor * dot(&self.image, z) / curvature;
        turn(&mut self.direction, turned, factor, z);
        self.lengths.push(length);
        self.turns.push(next / self.rho);
        self.rho = next;
        true
    }

    /// The estimate of κ from the steps so far.
    pub(super) fn least(&self) -> f64 {
        self.least.min(self.least_eigenvalue())
    }

    /// The smallest eigenvalue of the Lanczos matrix with diagonal 1/α_k + β_k/α_{k−1} and off-diagonal √β_k/α_{k−1}.
    fn least_eigenvalue(&self) -> f64 {
        let (mut low, mut high) = (0.0, 1.0);
        for _ in 0..BISECTIONS {
            let middle = 0.5 * (low + high);
            if self.has_eigenvalue_below(middle) { high = middle } else { low = middle }
        }
        high
    }

    fn has_eigenvalue_below(&self, bound: f64) -> bool {
        let mut pivot = 1.0;
        for (k, length) in self.lengths.iter().enumerate() {
            let mut diagonal = 1.0 / length - bound;
            if k > 0 {
                let (turn, before) = (self.turns[k - 1], self.lengths[k - 1]);
                diagonal += turn / before - turn / (before * before) / pivot;
            }
            if diagonal <= 0.0 {
                return true;
            }
            pivot = diagonal;
        }
        false
    }
}
