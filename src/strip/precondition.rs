//! Preconditioner of the edge operator on a face: one sine transform per gap.
//!
//! On a gap of L nodes between contact runs the operator is close to the function of the sine modes with the same symbol:
//! B = DST⁻¹ S(πk/(L+1))⁻¹ DST (odd extension of period 2(L+1)); both are equivalent to the half Laplacian on the gap. The
//! spectrum of BA stays in a fixed interval however many gaps there are and however long. A gap that reaches a natural side
//! is continued evenly past it; without any contact B is the exact inverse. Contact runs (midpoint amplitudes) are divided
//! by ‖A‖. L + 1 is raised to the next number with prime factors up to 13, so that no transform has a large prime length.
//! Cost O(n log n).

use super::edge::{EdgeOperator, Workspace};
use super::sides::Sides;
use crate::cone::{Block, Face};
use realfft::num_complex::Complex;
use realfft::{ComplexToReal, RealFftPlanner, RealToComplex};
use std::collections::HashMap;
use std::sync::Arc;

struct GapPlan {
    /// S(πk/(L'+1))⁻¹ / (2(L'+1)), k = 0 ... L'+1.
    factor: Vec<f64>,
    forward: Arc<dyn RealToComplex<f64>>,
    backward: Arc<dyn ComplexToReal<f64>>,
}

/// Plans and buffers, kept over all steps on one edge.
pub(crate) struct Preconditioner<'a> {
    operator: &'a EdgeOperator,
    planner: RealFftPlanner<f64>,
    plans: HashMap<usize, GapPlan>,
    real: Vec<f64>,
    spectrum: Vec<Complex<f64>>,
    scratch: Vec<Complex<f64>>,
}

impl<'a> Preconditioner<'a> {
    pub(crate) fn new(operator: &'a EdgeOperator) -> Self {
        Self {
            operator,
            planner: RealFftPlanner::new(),
            plans: HashMap::new(),
            real: Vec::new(),
            spectrum: Vec::new(),
            scratch: Vec::new(),
        }
    }

    /// z ← B r on the face.
    pub(crate) fn apply(&mut self, face: &Face, r: &[f64], z: &mut [f64], work: &mut Workspace) {
        let nodes = self.operator.nodes();
        let diagonal = 1.0 / self.operator.norm();
        for run in face.runs() {
            run.nodes(nodes).for_each(|i| z[i] = diagonal * r[i]);
        }
        for gap in face.gaps() {
            if gap.len == nodes {
                self.operator.solve_into(r, z, work);
            } else {
                self.gap(gap, r, z);
            }
        }
    }

    fn gap(&mut self, gap: Block, r: &[f64], z: &mut [f64]) {
        let nodes = self.operator.nodes();
        let natural = self.operator.sides() == Sides::Natural;
        let mirror_left = natural && gap.start == 0;
        let mirror_right = natural && gap.start + gap.len == nodes;
        let mirrored = mirror_left || mirror_right;
        let length = if mirrored { 2 * gap.len - 1 } else { gap.len };
        let half = smooth_at_least(length + 1);
        if !self.plans.contains_key(&half) {
            let plan = self.plan(half);
            self.plans.insert(half, plan);
        }
        let Some(plan) = self.plans.get(&half) else {
            return;
        };
        let period = 2 * half;
        self.real.clear();
        self.real.resize(period, 0.0);
        let value = |j: usize| r[(gap.start + j) % nodes];
        // Position 1 + j on the odd grid; the end node of a natural side is the centre of the mirrored gap and its dual
        // value counts twice there.
        for j in 0..gap.len {
            let v = value(j);
            if !mirrored {
                self.real[1 + j] = v;
            } else {
                let distance = if mirror_left { j } else { gap.len - 1 - j };
                let centre = gap.len;
                if distance == 0 {
                    self.real[centre] = 2.0 * v;
                } else {
                    self.real[centre - distance] = v;
                    self.real[centre + distance] = v;
                }
            }
        }
        for j in 1..=length {
            self.real[period - j] = -self.real[j];
        }
        self.spectrum.clear();
        self.spectrum.resize(half + 1, Complex::default());
        let scratch = plan.forward.get_scratch_len().max(plan.backward.get_scratch_len());
        if self.scratch.len() < scratch {
            self.scratch.resize(scratch, Complex::default());
        }
        // Lengths are those of the plan.
        let done = plan.forward.process_with_scratch(&mut self.real, &mut self.spectrum, &mut self.scratch);
        debug_assert!(done.is_ok());
        for (value, factor) in self.spectrum.iter_mut().zip(&plan.factor) {
            *value = Complex::new(0.0, value.im * factor);
        }
        self.spectrum[half].im = 0.0;
        let done = plan.backward.process_with_scratch(&mut self.spectrum, &mut self.real, &mut self.scratch);
        debug_assert!(done.is_ok());
        for j in 0..gap.len {
            let position = if !mirrored {
                1 + j
            } else if mirror_left {
                gap.len + j
            } else {
                1 + j
            };
            z[(gap.start + j) % nodes] = self.real[position];
        }
    }

    fn plan(&mut self, half: usize) -> GapPlan {
        let symbol = self.operator.symbol();
        let last = symbol.len() - 1;
        let factor = (0..=half)
            .map(|k| {
                // The symbol between its grid values, linearly.
                let place = k as f64 * last as f64 / half as f64;
                let i = (place as usize).min(last - 1);
                let t = place - i as f64;
                1.0 / (((1.0 - t) * symbol[i] + t * symbol[i + 1]) * (2 * half) as f64)
            })
            .collect();
        GapPlan {
            factor,
            forward: self.planner.plan_fft_forward(2 * half),
            backward: self.planner.plan_fft_inverse(2 * half),
        }
    }
}

/// The smallest number ≥ n whose prime factors are at most 13.
fn smooth_at_least(n: usize) -> usize {
    (n..)
        .find(|&candidate| {
            let mut rest = candidate;
            for p in [2, 3, 5, 7, 11, 13] {
                while rest.is_multiple_of(p) {
                    rest /= p;
                }
            }
            rest == 1
        })
        .unwrap_or(n)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cone::Cone;
    use crate::strip::ScalarStrip;

    #[test]
    fn smooth_numbers() {
        assert_eq!([1, 17, 19, 529].map(smooth_at_least), [1, 18, 20, 539]);
    }

    #[test]
    fn symmetric_on_every_face() {
        let strip = ScalarStrip::new(32, 32).unwrap();
        let operator = strip.operator();
        let mut preconditioner = Preconditioner::new(operator);
        for pattern in 0..4usize {
            let active: Vec<bool> = (0..33)
                .map(|i| match pattern {
                    0 => i % 7 == 3,
                    1 => i < 9,
                    2 => i > 20 || i == 4,
                    _ => false,
                })
                .collect();
            let face = Face::new(operator.cone(Cone::Nodal), &active);
            let mut image = |r: &[f64]| {
                let mut z = vec![0.0; 33];
                preconditioner.apply(&face, r, &mut z, &mut operator.workspace());
                face.project(&mut z);
                z
            };
            let mut x: Vec<f64> = (0..33).map(|i| (i as f64).sin()).collect();
            let mut y: Vec<f64> = (0..33).map(|i| (2.0 * i as f64).cos()).collect();
            face.project(&mut x);
            face.project(&mut y);
            let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(p, q)| p * q).sum::<f64>();
            let (zx, zy) = (image(&x), image(&y));
            assert!((dot(&zx, &y) - dot(&zy, &x)).abs() < 1e-12, "{pattern}");
            assert!(dot(&zx, &x) > 0.0);
        }
    }
}
