//! Inner products of shifted functions on (0, 1), the factors of double integrals on the square.
//!
//! For w = X(x) Y(y) and the displacement (a, b), w(x+a, y+b) − w(x, y) = ΔX Y + X⁺ ΔY with X⁺ = X(x+a),
//! ΔX = X⁺ − X: products over the overlap of one function of x and one of y, formed from differences.

use super::legendre::fill_with_quotients;
use fractional_sobolev::{Result, gauss_legendre};

/// ⟨f_i f_k⟩, ⟨f_i Δf_k⟩, ⟨f_i⁺ f_k⁺⟩, ⟨Δf_i f_k⁺⟩ and ⟨Δf_i Δf_k⟩ over (0, 1 − a), row after row.
pub(super) struct Increments {
    pub(super) plain: Vec<f64>,
    pub(super) mixed: Vec<f64>,
    pub(super) moved: Vec<f64>,
    pub(super) mixed_moved: Vec<f64>,
    pub(super) both: Vec<f64>,
}

/// Functions with their increments.
pub(super) trait Family {
    /// How many.
    fn count(&self) -> usize;
    /// (f_i(x), f_i(x+a) − f_i(x)) for all i, the second without cancellation.
    fn fill(&self, x: f64, a: f64, values: &mut [f64], steps: &mut [f64]);
    /// Ends of cells of (0, 1 − a) on which they are smooth, from the right to 0, and points of a rule.
    fn cells(&self, a: f64) -> (Vec<f64>, usize);
}

/// Legendre polynomials of one parity about 1/2, degrees `first`, `first` + 2, ....
pub(super) struct Parity {
    pub(super) first: usize,
    pub(super) degree: usize,
}

impl Family for Parity {
    fn count(&self) -> usize {
        (self.degree - self.first) / 2 + 1
    }

    fn fill(&self, x: f64, a: f64, values: &mut [f64], steps: &mut [f64]) {
        let (mut all, mut quotients) = (vec![0.0; self.degree + 1], vec![0.0; self.degree + 1]);
        let t = 2.0 * x - 1.0;
        fill_with_quotients(&mut all, &mut quotients, t, t + 2.0 * a);
        for (i, k) in (self.first..=self.degree).step_by(2).enumerate() {
            (values[i], steps[i]) = (all[k], 2.0 * a * quotients[k]);
        }
    }

    fn cells(&self, a: f64) -> (Vec<f64>, usize) {
        (vec![1.0 - a, 0.0], self.degree + 1)
    }
}

/// P_0, ..., P_m and y^p P_0, ..., y^p P_n, Legendre polynomials on (0, 1): what a least energy looks like
/// near the edge y = 0.
pub(super) struct EdgeFamily {
    pub(super) power: f64,
    pub(super) smooth: usize,
    pub(super) singular: usize,
}

/// Ratio of the cells towards 0, how many below the displacement, and points of a rule.
const RATIO: f64 = 0.2;
const BELOW: i32 = 8;
const POINTS: usize = 12;

impl EdgeFamily {
    /// The values at y = 0.
    pub(super) fn at_edge(&self) -> Vec<f64> {
        (0..self.count())
            .map(|j| if j > self.smooth { 0.0 } else { (1 - 2 * (j as i32 % 2)).into() })
            .collect()
    }
}

impl Family for EdgeFamily {
    fn count(&self) -> usize {
        self.smooth + self.singular + 2
    }

    fn fill(&self, y: f64, b: f64, values: &mut [f64], steps: &mut [f64]) {
        let most = self.smooth.max(self.singular) + 1;
        let (mut all, mut quotients) = (vec![0.0; most], vec![0.0; most]);
        let t = 2.0 * y - 1.0;
        fill_with_quotients(&mut all, &mut quotients, t, t + 2.0 * b);
        let power = y.powf(self.power);
        let rise = power * (self.power * (b / y).ln_1p()).exp_m1();
        for j in 0..=self.smooth {
            (values[j], steps[j]) = (all[j], 2.0 * b * quotients[j]);
        }
        for j in 0..=self.singular {
            let step = 2.0 * b * quotients[j];
            let place = self.smooth + 1 + j;
            (values[place], steps[place]) = (power * all[j], rise * (all[j] + step) + power * step);
        }
    }

    fn cells(&self, b: f64) -> (Vec<f64>, usize) {
        let mut cuts = vec![1.0 - b];
        while cuts[cuts.len() - 1] > b.min(1.0 - b) * RATIO.powi(BELOW) {
            cuts.push(cuts[cuts.len() - 1] * RATIO);
        }
        cuts.push(0.0);
        (cuts, POINTS)
    }
}

impl Increments {
    /// All inner products for one displacement 0 < a < 1.
    pub(super) fn new(family: &impl Family, a: f64) -> Result<Self> {
        let n = family.count();
        let zero = || vec![0.0; n * n];
        let mut all = Self { plain: zero(), mixed: zero(), moved: zero(), mixed_moved: zero(), both: zero() };
        let (mut values, mut steps) = (vec![0.0; n], vec![0.0; n]);
        let (cuts, points) = family.cells(a);
        let rule = gauss_legendre(points)?;
        for pair in cuts.windows(2) {
            for (t, w) in rule.iter() {
                let (x, weight) = (pair[1] + (pair[0] - pair[1]) * t, w * (pair[0] - pair[1]));
                family.fill(x, a, &mut values, &mut steps);
                for i in 0..n {
                    for k in 0..n {
                        let (at, (f, df), (g, dg)) =
                            (i * n + k, (values[i], steps[i]), (values[k], steps[k]));
                        all.plain[at] += weight * f * g;
                        all.mixed[at] += weight * f * dg;
                        all.moved[at] += weight * (f + df) * (g + dg);
                        all.mixed_moved[at] += weight * df * (g + dg);
                        all.both[at] += weight * df * dg;
                    }
                }
            }
        }
        Ok(all)
    }
}
