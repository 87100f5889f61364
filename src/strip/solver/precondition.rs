//! Preconditioner of the edge operator on a face: one sine transform per non-contact interval.
//!
//! On a non-contact interval of L nodes between contact intervals the operator is close to the function of the sine
//! modes with the same symbol: B = DST⁻¹ S(πk/(L+1))⁻¹ DST (odd extension of period 2(L+1)); both are equivalent to
//! the half Laplacian on the interval. The spectrum of BA lies in a fixed interval, independent of the number and
//! length of the non-contact intervals. A non-contact interval that reaches a natural side is extended evenly beyond
//! it; without any contact B is the exact inverse. Contact intervals (midpoint amplitudes) are divided by ‖A‖. L + 1
//! is raised to the next number with prime factors up to 13, so that no transform has a large prime length. Cost: O(n
//! log n).

use crate::cone::{Block, Face};
use crate::error::Result;
use crate::strip::operator::edge::EdgeOperator;
use crate::strip::operator::fourier::{RealFourier, Workspace};
use crate::strip::sides::LateralCondition;
use fractional_sobolev_numeric::transforms::{Complex, Planner};
use std::collections::HashMap;

struct GapPlan {
    /// S(πk/(L'+1))⁻¹ / (2(L'+1)), k = 0 ... L'+1.
    factor: Vec<f64>,
    fourier: RealFourier,
}

/// Plans and buffers, kept over all steps on one edge.
pub(crate) struct Preconditioner<'a> {
    operator: &'a EdgeOperator,
    planner: Planner,
    plans: HashMap<usize, GapPlan>,
    work: Workspace,
}

impl<'a> Preconditioner<'a> {
    pub(crate) fn new(operator: &'a EdgeOperator) -> Self {
        Self {
            operator,
            planner: Planner::default(),
            plans: HashMap::new(),
            work: Workspace::default(),
        }
    }

    /// z ← B r on the face.
    ///
    /// On a non-contact interval of L nodes z = Σ_k (2/(L + 1)) S(πk/(L + 1))⁻¹ ⟨r, s_k⟩ s_k with
    /// s_k(j) = sin(πkj/(L + 1)); on a contact interval of the midpoint cone z = Π r/‖A‖.
    pub(crate) fn apply(
        &mut self,
        face: &Face,
        r: &[f64],
        z: &mut [f64],
        work: &mut Workspace,
    ) -> Result<()> {
        let nodes = self.operator.nodes();
        let diagonal = 1.0 / self.operator.norm();
        for run in face.runs() {
            run.nodes(nodes).for_each(|i| z[i] = diagonal * r[i]);
        }
        for gap in face.gaps() {
            if gap.len == nodes {
                self.operator.solve_into(r, z, work)?;
            } else {
                self.gap(gap, r, z)?;
            }
        }
        Ok(())
    }

    fn gap(&mut self, gap: Block, r: &[f64], z: &mut [f64]) -> Result<()> {
        let nodes = self.operator.nodes();
        let natural = self.operator.sides() == LateralCondition::Natural;
        let mirror_left = natural && gap.start == 0;
        let mirror_right = natural && gap.start + gap.len == nodes;
        let mirrored = mirror_left || mirror_right;
        let length = if mirrored { 2 * gap.len - 1 } else { gap.len };
        let half = smooth_at_least(length + 1);
        let plan = self
            .plans
            .entry(half)
            .or_insert_with(|| GapPlan::new(self.operator, &mut self.planner, half));
        let period = 2 * half;
        let work = &mut self.work;
        plan.fourier.fit(work);
        work.real.fill(0.0);
        // Position on the odd grid; the end node of a natural side is the centre of the reflected interval, and its
        // dual value counts twice there.
        let position = |j: usize| if mirror_left { gap.len + j } else { 1 + j };
        for j in 0..gap.len {
            let value = r[(gap.start + j) % nodes];
            work.real[position(j)] = value;
            if mirrored {
                work.real[2 * gap.len - position(j)] = value;
            }
        }
        if mirrored {
            work.real[gap.len] *= 2.0;
        }
        for j in 1..=length {
            work.real[period - j] = -work.real[j];
        }
        plan.fourier.forward(work)?;
        for (value, factor) in work.spectrum.iter_mut().zip(&plan.factor) {
            *value = Complex::new(0.0, value.im * factor);
        }
        plan.fourier.backward(work)?;
        for j in 0..gap.len {
            z[(gap.start + j) % nodes] = work.real[position(j)];
        }
        Ok(())
    }
}

impl GapPlan {
    fn new(operator: &EdgeOperator, planner: &mut Planner, half: usize) -> Self {
        let symbol = operator.symbol();
        let last = symbol.len() - 1;
        let factor = (0..=half)
            .map(|k| {
                // The symbol interpolated linearly between its grid values.
                let place = k as f64 * last as f64 / half as f64;
                let i = (place as usize).min(last - 1);
                let t = place - i as f64;
                1.0 / (((1.0 - t) * symbol[i] + t * symbol[i + 1]) * (2 * half) as f64)
            })
            .collect();
        Self { factor, fourier: RealFourier::new(planner, 2 * half) }
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
    use crate::strip::Strip;

    #[test]
    fn smooth_numbers() {
        assert_eq!([1, 17, 19, 529].map(smooth_at_least), [1, 18, 20, 539]);
    }

    #[test]
    fn symmetric_on_every_face() {
        let strip = Strip::scalar(32, 32).unwrap();
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
                preconditioner.apply(&face, r, &mut z, &mut operator.workspace()).unwrap();
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
