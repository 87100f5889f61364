//! A diagonal form close to the regional form: β ∫ u v + c ⟨A^ν u, v⟩, A = -d²/dx² with Neumann conditions on
//! (0, 1).
//!
//! With c = 2π / (Γ(1+2ν) sin πν) the form c ⟨A^ν u, v⟩ has the symbol c |ξ|^{2ν} of (1.1) on the line; on the
//! interval it is (1.1) with the kernel of all even images. Its dual form has two representations:
//! - exactly, by resolvents ([`super::resolvent`]):
//!   1/(β + cλ^ν) = (sin πν / π) ∫_0^∞ c s^ν / (β² + 2βc s^ν cos πν + c² s^{2ν}) ds / (s + λ);
//! - over the piecewise linear functions on M equal elements: they are spanned by the interpolants of cos kπx, whose
//!   coefficients at the aliases k + 2Mm are (sin φ/(φ+πm))², φ = kπ/2M, so that the Gram matrix is diagonal,
//!   μ_k = sin⁴φ/2 Σ_m (β + c (2M)^{2ν} |φ+πm|^{2ν}) |φ+πm|^{-4}, twice that for k = M, β for k = 0.
//!   sin⁴φ times the sum is (2 + cos 2φ)/3 for β and a sum of two Hurwitz zeta functions for c; a transform
//!   costs O(M log M).

use super::cells::Cells;
use super::resolvent::{Ends, Load, geometric};
use crate::error::{Error, Result};
use crate::numeric::parallel;
use crate::numeric::sum::RunningSum;
use crate::order::Order;
use fractional_sobolev_numeric::transforms::{Complex, Planner, RealToComplex};
use std::f64::consts::PI;
use std::sync::Arc;

/// Largest number of trapezoidal nodes.
const MOST_NODES: f64 = 1e6;

/// ⟨f, (β + cA^ν)^{-1} f⟩ and its error on (0, 1), for f with mean zero, to a relative `goal`.
pub(super) fn exact_form(
    cells: Cells,
    order: Order,
    [beta, c]: [f64; 2],
    goal: f64,
) -> Result<(f64, f64)> {
    let (nu, complement) = (order.value(), order.complement());
    let sine = (PI * nu.min(complement)).sin() / PI;
    // Half width of the strip in which the integrand is analytic in y = ln s.
    let strip = if beta > 0.0 { PI * (complement / nu).min(1.0) } else { PI };
    // Poles of the weight may meet one of the form: e^{-2π strip / step} has a larger factor then.
    let factor = if beta > 0.0 { 64.0 } else { 4.0 };
    let step = 2.0 * PI * strip / (factor / goal).ln();
    let lowest = (goal.ln() / (1.0 + complement) / step).floor() * step;
    let load = Load::new(Ends::Neumann, 1.0, cells, (0.5 * lowest).exp())?;
    let cosine = (PI * nu).cos();
    let weight = |y: f64| {
        if beta == 0.0 {
            return (-nu * y).exp() / c;
        }
        let ratio = c / beta * (nu * y).exp();
        if ratio.is_finite() { ratio / (1.0 + ratio * (2.0 * cosine + ratio)) / beta } else { 0.0 }
    };
    // Above, the law of large τ holds and β does not count.
    let free = if beta > 0.0 { ((beta / c).ln() - goal.ln()) / nu } else { 0.0 };
    let count =
        (((2.0 * load.settled.ln()).max(free) - lowest) / step).ceil().clamp(1.0, MOST_NODES);
    let nodes: Vec<f64> = (0..=count as usize).map(|k| lowest + k as f64 * step).collect();
    let terms: Vec<(f64, f64)> = parallel::over(&nodes, |&y| {
        let (value, error) = load.form((0.5 * y).exp());
        (step * weight(y) * value, step * weight(y) * error)
    });
    let (mut sum, mut error) = (RunningSum::default(), 0.0);
    for &(term, rounding) in &terms {
        sum.add(term);
        error += rounding;
    }
    // ρ(τ) grows like τ² below, where the weight turns from e^{νy}/β² to e^{-νy} at β = c e^{νy}
    let below = if beta == 0.0 {
        terms[0].0 * geometric(complement, step, step) / step
    } else {
        let lowest_form = step * load.form((0.5 * lowest).exp()).0;
        let further = (1..).map(|k| k as f64 * step).take_while(|d| complement * d < 50.0);
        further.map(|d| lowest_form * (-d).exp() * weight(lowest - d)).sum()
    };
    sum.add(below);
    let end = nodes[nodes.len() - 1] + step;
    sum.add(geometric(nu, step, end) * load.square / c);
    sum.add(-geometric(nu + 0.5, step, end) * load.slope / c);
    error += geometric(nu, step, end) / c
        * (load.form((0.5 * end).exp()).1 + load.square * (-nu * end).exp() * beta / c);
    error += lowest.exp() * below;
    Ok((
        sine * sum.value(),
        sine * error + (goal + 16.0 * f64::EPSILON) * (sine * sum.value()).abs(),
    ))
}

/// Σ_{m≥0} (m + x)^{-p}, x > 0, p > 1: eight terms and Euler-Maclaurin.
fn hurwitz(p: f64, x: f64) -> f64 {
    const DIRECT: usize = 8;
    const BERNOULLI: [f64; 5] =
        [1.0 / 12.0, -1.0 / 720.0, 1.0 / 30_240.0, -1.0 / 1_209_600.0, 1.0 / 47_900_160.0];
    let head: f64 = (0..DIRECT).map(|m| (m as f64 + x).powf(-p)).sum();
    let start = DIRECT as f64 + x;
    let power = start.powf(-p);
    let mut sum = head + power * start / (p - 1.0) + 0.5 * power;
    let mut derivative = power * p / start;
    for (k, b) in BERNOULLI.iter().enumerate() {
        sum += b * derivative;
        let next = p + 2.0 * k as f64 + 1.0;
        derivative *= next * (next + 1.0) / (start * start);
    }
    sum
}

/// The piecewise linear functions on M equal elements of (0, 1).
pub(super) struct Cosines {
    cells: usize,
    forward: Arc<dyn RealToComplex<f64>>,
    signal: Vec<f64>,
    spectrum: Vec<Complex<f64>>,
    scratch: Vec<Complex<f64>>,
    /// μ_k for β = 1, c = 0 and for β = 0, c = 1
    mass: Vec<f64>,
    power: Vec<f64>,
}

impl Cosines {
    pub(super) fn new(cells: usize, order: Order) -> Self {
        let forward = Planner::default().forward(2 * cells);
        let (spectrum, scratch) = (forward.make_output_vec(), forward.make_scratch_vec());
        let exponent = 2.0 * order.value();
        let scale = (2.0 * PI * cells as f64).powf(exponent);
        let sums: Vec<[f64; 2]> = parallel::map(cells + 1, &|k| {
            if k == 0 {
                return [1.0, 0.0];
            }
            let x = k as f64 / (2 * cells) as f64;
            let half = if k == cells { 1.0 } else { 0.5 };
            let p = 4.0 - exponent;
            let sum = ((PI * x).sin() / PI).powi(4) * (hurwitz(p, x) + hurwitz(p, 1.0 - x));
            [half * (2.0 + (2.0 * PI * x).cos()) / 3.0, half * scale * sum]
        });
        let (mass, power) = sums.iter().map(|s| (s[0], s[1])).unzip();
        Self { cells, forward, signal: vec![0.0; 2 * cells], spectrum, scratch, mass, power }
    }

    /// out_k = Σ_i cos(kπi/M) x_i.
    fn transform(&mut self, x: &[f64], out: &mut [f64]) -> Result<()> {
        let m = self.cells;
        self.signal[0] = x[0];
        self.signal[m] = x[m];
        for i in 1..m {
            self.signal[i] = 0.5 * x[i];
            self.signal[2 * m - i] = 0.5 * x[i];
        }
        self.forward
            .process_with_scratch(&mut self.signal, &mut self.spectrum, &mut self.scratch)
            .map_err(|error| Error::Solver { reason: format!("Fourier transform: {error}") })?;
        out.iter_mut().zip(&self.spectrum).for_each(|(o, s)| *o = s.re);
        Ok(())
    }

    /// Σ ⟨f, (β + cA^ν)^{-1} g⟩ over pairs of g and β, without the means.
    pub(super) fn form(&mut self, f: &[f64], others: &[(&[f64], f64)], c: f64) -> Result<f64> {
        let [mut waves, mut other] = [vec![0.0; f.len()], vec![0.0; f.len()]];
        self.transform(f, &mut waves)?;
        let mut sum = RunningSum::default();
        for &(g, beta) in others {
            self.transform(g, &mut other)?;
            for k in 1..=self.cells {
                sum.add(waves[k] * other[k] / (beta * self.mass[k] + c * self.power[k]));
            }
        }
        Ok(sum.value())
    }

    /// out ← (β + cA^ν)^{-1} x with mean zero.
    pub(super) fn solve(&mut self, x: &[f64], out: &mut [f64], [beta, c]: [f64; 2]) -> Result<()> {
        let mut waves = vec![0.0; x.len()];
        self.transform(x, &mut waves)?;
        waves[0] = 0.0;
        for k in 1..=self.cells {
            waves[k] /= beta * self.mass[k] + c * self.power[k];
        }
        self.transform(&waves, out)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Mesh;
    use crate::piecewise::PiecewisePolynomial;

    /// The form of a step in the middle: Σ_{k odd} 8/(kπ)² / (β + c (kπ)^{2ν}), its tail without β by the
    /// midpoint rule.
    fn step_by_cosines(nu: f64, [beta, c]: [f64; 2]) -> (f64, f64) {
        const LAST: f64 = 400_000.0;
        let term = |k: f64| 8.0 / (PI * k).powi(2) / (beta + c * (PI * k).powf(2.0 * nu));
        let head: f64 = (0..LAST as u32 / 2).rev().map(|m| term(2.0 * f64::from(m) + 1.0)).sum();
        let tail = 4.0 * (PI * LAST).powf(-1.0 - 2.0 * nu) / (1.0 + 2.0 * nu) / (PI * c);
        (head + tail, tail * beta / (c * (PI * LAST).powf(2.0 * nu)) + 1e-13 * head)
    }

    #[test]
    fn small_and_large_shifts_are_summed_with_both_ends() {
        let halves = Mesh::uniform(2, 1.0).unwrap();
        let step = Cells::new(&PiecewisePolynomial::constants(halves, &[1.0, -1.0]).unwrap(), 1.0)
            .unwrap();
        for nu in [0.1, 0.3, 0.5, 0.7, 0.9] {
            let order = Order::new(nu).unwrap();
            for c in [0.1, 1.0, 9.0] {
                // the last puts the pole of the weight beside that of the first wave
                for beta in [0.0, 1e-30, 1e-9, 1e-4, 1e-2, 0.1, 1.0, 30.0, c * PI.powf(2.0 * nu)] {
                    let (value, own) = step_by_cosines(nu, [beta, c]);
                    for goal in [1e-4, 1e-7, 1e-10] {
                        let (found, error) =
                            exact_form(step.clone(), order, [beta, c], goal).unwrap();
                        let off = (found - value).abs();
                        assert!(
                            off <= error + own,
                            "{nu} {beta:e} {c} {goal:e}: {found} {value}, {off:e}"
                        );
                        assert!(
                            error <= 4.0 * goal * found,
                            "{nu} {beta:e} {c}: {error:e} for {goal:e}"
                        );
                    }
                }
            }
        }
    }
}
