//! ∫ f(u) for functions with structure on many scales: Gauss rules on cells of t = ln(R/δ) along every
//! side, from the middle of an interval down to the smallest distance, halved wherever two rules differ.
//!
//! On a cell where f(u) is smooth the error falls by 2^{−18} or more with every halving, and is extrapolated. Where it
//! does not fall, at a kink or a step between the breakpoints, the differences of rules are random numbers of the size
//! of their errors, and may be small by accident. There the error is the integral of |f(u) − p|, p the polynomial
//! through the points of the finer rule, by the coarser rule: |∫ (f(u) − p)| is the error of the finer rule, and
//! the absolute values do not cancel.

use super::arm::Arm;
use super::function::SingularFunction;
use super::look::Look;
use crate::error::{Error, Result};
use crate::estimate::{Estimate, Work};
use crate::quadrature::Rule;

/// Orders of the two rules.
const ORDERS: [usize; 2] = [9, 14];
/// Share of the tolerance for one cell.
const SHARE: f64 = 0.003;
/// Distance of the first point of the fine rule from the end of a cell, as a fraction of the cell.
const END: f64 = 0.007;
/// Largest number of bisections of a cell, and largest number of cells.
const HALVINGS: u32 = 50;
const CELLS: usize = 100_000;
/// Safety factor for errors extrapolated at their observed rate.
const SAFETY: f64 = 10.0;
/// Relative rounding error of values of f.
const ROUNDING: f64 = 64.0 * f64::EPSILON;
/// Ratio of errors above which they count as not decreasing.
const FALLS: f64 = 0.99;
/// The same for the halves of a cell: above it the function is not smooth there.
const SMOOTH: f64 = 0.01;
/// Factor of the integral of |f(u) − p| by nine points.
const UNSEEN: f64 = 2.0;
/// Message: the integral may diverge.
const GROWS: &str = "contributions still grow at the smallest distance from a breakpoint at which the function \
     can be evaluated";

/// An integral over a cell by the coarse rule, by the fine rule, and by the fine rule with the error at the
/// ends; last ∫ |f(u) − p|.
type Sums = [f64; 4];

fn apart_of(sums: &Sums) -> f64 {
    (sums[0] - sums[1]).abs().max((sums[2] - sums[1]).abs())
}

/// The error of the halves of a cell whose rules differ by `coarse`, where the rules of the halves differ by
/// `fine`: the errors are extrapolated at the observed rate with a safety factor, by at most three digits.
fn after(coarse: f64, fine: f64) -> f64 {
    if fine < coarse { SAFETY * fine * (fine / coarse).max(1e-3) } else { fine }
        .min(coarse.max(fine))
}

/// Weights of the values at given points in the value of the interpolating polynomial at `end`.
fn extrapolation(points: &[f64], end: f64) -> Vec<f64> {
    let weight = |k: usize| {
        let others = (0..points.len()).filter(|&j| j != k);
        others.map(|j| (end - points[j]) / (points[k] - points[j])).product()
    };
    (0..points.len()).map(weight).collect()
}

impl SingularFunction<'_> {
    /// ∫ f(u(x)) dx with its error, which may exceed the tolerance; cells are bisected to the relative
    /// tolerance.
    pub(super) fn integral_by_scales(
        &self,
        look: &Look,
        tolerance: f64,
        f: &impl Fn(f64) -> f64,
    ) -> Result<Estimate> {
        let [coarse, fine] = [Rule::gauss_legendre(ORDERS[0])?, Rule::gauss_legendre(ORDERS[1])?];
        let to_ends = [0.0, 1.0].map(|end| extrapolation(fine.points(), end));
        let between: Vec<Vec<f64>> =
            coarse.points().iter().map(|&t| extrapolation(fine.points(), t)).collect();
        let mut points = 0;
        // By both rules, and by the finer one with what its polynomial is off at the ends: there kinks may hide.
        let mut all = |arm: &Arm, from: f64, width: f64| -> Result<Sums> {
            let mut value = |t: f64| -> Result<f64> {
                let t = (from + width * t).min(arm.depth);
                let delta = arm.delta(t);
                points += 1;
                Ok(width * delta * f(self.along(arm, t, delta)?))
            };
            let mut sums = [0.0; 4];
            let mut known = [0.0; ORDERS[1]];
            for (known, (t, w)) in known.iter_mut().zip(fine.iter()) {
                *known = value(t)?;
                sums[1] += w * *known;
            }
            let polynomial =
                |weights: &[f64]| weights.iter().zip(&known).map(|(w, v)| w * v).sum::<f64>();
            for ((t, w), weights) in coarse.iter().zip(&between) {
                let here = value(t)?;
                sums[0] += w * here;
                sums[3] += w * (here - polynomial(weights)).abs();
            }
            let off =
                [value(0.0)? - polynomial(&to_ends[0]), value(1.0)? - polynomial(&to_ends[1])];
            sums[2] = sums[1] + END * (off[0].abs() + off[1].abs());
            Ok(sums)
        };
        let (mut value, mut error, mut size) = (0.0, 0.0, 0.0);
        let mut open = Vec::new();
        for arm in self.arms() {
            let count = arm.depth.ceil().max(1.0);
            let width = arm.depth / count;
            let mut last = [0.0; 2];
            for k in 0..count as usize {
                let (mut from, end) = (width * k as f64, width * (k + 1) as f64);
                let mut whole = 0.0;
                let cuts = look.cuts(&arm, arm.delta(end), arm.delta(from)).iter().rev();
                for to in cuts.map(|&cut| (arm.length / cut).ln().min(end)).chain([end]) {
                    if to > from {
                        let sums = all(&arm, from, to - from)?;
                        size += sums[1].abs();
                        whole += sums[1];
                        open.push((arm, from, to - from, sums, 0));
                        from = to;
                    }
                }
                last = [last[1], whole];
            }
            // Quotients of subnormal numbers have no digits.
            if last[1].abs() > f64::MIN_POSITIVE / f64::EPSILON {
                let ratio = (last[1] / last[0]).abs();
                if ratio.is_nan() || ratio > FALLS {
                    return Err(Error::out_of_reach("integral", tolerance, f64::INFINITY, GROWS));
                }
                let rest = last[1] * ratio / (1.0 - ratio);
                value += rest;
                error += rest.abs();
            }
        }
        let (enough, nothing) = (SHARE * tolerance * size, f64::EPSILON * size);
        let mut cells = open.len();
        while let Some((arm, from, width, sums, halvings)) = open.pop() {
            let apart = apart_of(&sums);
            if apart <= nothing || halvings == HALVINGS || cells > CELLS {
                value += sums[1];
                error += if apart <= nothing { apart } else { apart.max(UNSEEN * sums[3]) };
                continue;
            }
            cells += 1;
            let half = 0.5 * width;
            let halves = [from, from + half].map(|start| Ok((start, all(&arm, start, half)?)));
            let [left, right]: [Result<(f64, Sums)>; 2] = halves;
            let (left, right) = (left?, right?);
            // At a kink two rules may agree by accident; a third value hardly does at the same time.
            let together = [0, 1, 2, 3].map(|k| left.1[k] + right.1[k]);
            let finer = apart_of(&together).max((sums[1] - together[1]).abs());
            if finer.max(apart) <= enough {
                value += together[1];
                let is_smooth = finer <= (SMOOTH * apart).max(nothing);
                error +=
                    after(apart, finer).max(if is_smooth { 0.0 } else { UNSEEN * together[3] });
                continue;
            }
            for (start, sums) in [left, right] {
                open.push((arm, start, half, sums, halvings + 1));
            }
        }
        let work = Work { points, ..Work::default() };
        Estimate::new(value, error + ROUNDING * size, work)
    }
}
