//! An approximate inverse of the Gram matrices: the negative power of the tridiagonal pencil (K, M).
//!
//! With K of (u′, v′) and M of L² on the same mesh,
//!   (M⁻¹K)^{-ν} M⁻¹ = sin(πν)/π ∫_0^∞ t^{-ν} (tM + K)⁻¹ dt   (Balakrishnan 1960),
//! by the trapezoidal rule in ln t: each point is one tridiagonal solve, O(N). The form of (M⁻¹K)^ν is that of the
//! interpolation space between L² and H¹ (H¹_0 if the functions vanish outside), whose norm is equivalent to that
//! of the double integral; multiplied by 2/C(1, ν) it agrees with it on short waves. The ratio of the two forms
//! lies between constants that depend on ν and on the ratios of neighbouring lengths, not on the number of elements: a
//! step across an element of length h between longer ones has the energy h^{1−2ν} or less, in the discrete interpolation
//! space h^{−ν}.

use super::tridiagonal::{Basis, Network, Tridiagonal};
use crate::kernel::power::symbol_constant;
use crate::mesh::Mesh;
use crate::numeric::parallel;
use crate::numeric::sum::compensated;
use crate::order::Order;
use rayon::prelude::*;

/// Step in ln t: relative error 2 e^{-2π²/step} < 0.3 %.
const STEP: f64 = 3.0;

/// Factor by which the range of t exceeds that of the eigenvalues at both ends; the remainder is a geometric
/// series.
const BEYOND: f64 = 100.0;

/// Largest value of t; the squared relative length of the shortest element may be smaller than its reciprocal.
const LARGEST: f64 = 1e280;

/// Number of entries of a vector summed by one thread.
const PIECE: usize = 1 << 12;

/// The inverse of (2/C) (M⁻¹K)^ν, on functions with mean zero if constants have seminorm zero.
pub(crate) struct Spectral {
    points: Vec<(f64, Tridiagonal)>,
    /// ∫ φ_i divided by the length of the interval, if constants are subtracted
    shares: Option<Vec<f64>>,
}

impl Spectral {
    pub(crate) fn new(mesh: &Mesh, basis: Basis, order: Order) -> Self {
        let nu = order.value();
        let shortest = mesh.lengths().iter().copied().fold(f64::INFINITY, f64::min);
        let total = mesh.total();
        let low = (1.0 / total) * (1.0 / total) / BEYOND;
        let high = (12.0 * BEYOND / shortest / shortest).min(LARGEST);
        let count = ((high / low).ln() / STEP).ceil() as usize;
        let sine = (std::f64::consts::PI * nu.min(order.complement())).sin();
        let factor = sine / std::f64::consts::PI / symbol_constant(order);
        let points = parallel::map(count + 1, &|k| {
            let t = low * (STEP * k as f64).exp();
            // Below and above the factors are those of K⁻¹ and (tM)⁻¹: the rest of a geometric series.
            let rest = match k {
                0 => -(-STEP * order.complement()).exp_m1(),
                _ if k == count => -(-STEP * nu).exp_m1(),
                _ => 1.0,
            };
            let weight = factor * STEP * t.powf(order.complement()) / rest;
            (weight, Network::new(mesh, basis, 1.0, t).factor())
        });
        let constants = basis != Basis::InnerHats;
        let shares = constants.then(|| Network::new(mesh, basis, 0.0, 1.0 / total).ground);
        Self { points, shares }
    }

    /// Subtracts the mean from a load, so that Σ r_i = 0, if constants have seminorm zero.
    pub(crate) fn without_mean(&self, r: &mut [f64]) {
        if let Some(shares) = &self.shares {
            let sum = compensated(r.iter().copied());
            r.iter_mut().zip(shares).for_each(|(r, share)| *r -= sum * share);
        }
    }

    /// Subtracts the mean from a function.
    pub(crate) fn without_constant(&self, x: &mut [f64]) {
        if let Some(shares) = &self.shares {
            let mean = compensated(x.iter().zip(shares).map(|(x, share)| x * share));
            x.iter_mut().for_each(|x| *x -= mean);
        }
    }

    /// The approximate inverse applied to r.
    pub(crate) fn times(&self, r: &[f64], out: &mut [f64]) {
        let mut load = r.to_vec();
        self.without_mean(&mut load);
        // In order of the points: the sum does not depend on the number of threads.
        let parts: Vec<Vec<f64>> = parallel::over(&self.points, |(_, factor)| factor.solve(&load));
        out.par_chunks_mut(PIECE).enumerate().for_each(|(piece, out)| {
            out.fill(0.0);
            for ((weight, _), part) in self.points.iter().zip(&parts) {
                out.iter_mut().zip(&part[piece * PIECE..]).for_each(|(sum, x)| *sum += weight * x);
            }
        });
        self.without_constant(out);
    }
}
