//! Functions on polygonal curves that are linear or constant on every element.

use super::curve::Curve;
use super::pairs::CurvePairs;
use crate::energy::PairSum;
use crate::error::{Error, Result};
use crate::estimate::{Estimate, Tolerance, Work};
use crate::numeric::check::require_memory;
use crate::numeric::check::require_values;
use crate::numeric::scale::power_of_two;
use crate::order::Order;
use crate::root::{ENTRY_ROUNDING, accept, root_of_squares};
use rayon::prelude::*;

/// Largest number of elements; such a seminorm takes some minutes.
const MOST: usize = 20_000;
/// Ratio of the relative accuracy of the kernel to that of the seminorm.
const SHARE: f64 = 0.5;
/// Message: what limits the accuracy.
const LIMIT: &str = "rounding of the values limits the accuracy of their differences";

/// A function on a [`Curve`]: continuous and linear on every element, or constant on every element.
#[doc(alias("H1/2", "H-1/2", "trace", "boundary element", "BEM", "Gagliardo"))]
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct BoundaryFunction {
    curve: Curve,
    /// values at the ends of the elements
    ends: Vec<[f64; 2]>,
    constants: bool,
}

impl BoundaryFunction {
    /// The function that is continuous and linear on every element, with the given values at
    /// [`Curve::nodes`].
    ///
    /// # Errors
    /// [`Error::LengthMismatch`], [`Error::NotFinite`].
    pub(crate) fn linears(curve: Curve, values: &[f64]) -> Result<Self> {
        let count = curve.len() + usize::from(!curve.is_closed());
        require_values("nodal values", values, count)?;
        let ends = (0..curve.len()).map(|e| curve.nodes_of(e).map(|k| values[k])).collect();
        Ok(Self { curve, ends, constants: false })
    }

    /// The function that is constant on every element, like approximate normal derivatives.
    ///
    /// # Errors
    /// [`Error::LengthMismatch`], [`Error::NotFinite`].
    pub(crate) fn constants(curve: Curve, values: &[f64]) -> Result<Self> {
        require_values("element values", values, curve.len())?;
        Ok(Self { curve, ends: values.iter().map(|&v| [v, v]).collect(), constants: true })
    }

    /// The curve.
    pub(crate) fn curve(&self) -> &Curve {
        &self.curve
    }

    pub(super) fn ends(&self) -> &[[f64; 2]] {
        &self.ends
    }

    /// The seminorm |u|_ν, |u|²_ν = ∫_Γ ∫_Γ (u(x)−u(y))² / |x−y|^{1+2ν} with the distance in the plane, 0 < ν <
    /// 1; on a Lipschitz curve it is equivalent to the seminorm of the trace space.
    ///
    /// # Method
    ///
    /// The sum over all pairs of elements: adjacent elements in Duffy's coordinates about their common point,
    /// on one side or across a corner of any angle; all others by Gauss rules on pieces no longer than their
    /// distance. Cost: O(N²) pairs with 10 to 100 kernel values each, some seconds for 2000 elements; at most
    /// 20 000 elements.
    ///
    /// # Errors
    /// [`Error::InfiniteNorm`] for piecewise constants with a jump and ν ≥ 1/2; [`Error::CountOutOfRange`] for
    /// more than 20 000 elements, [`Error::TooLarge`] if the memory does not suffice;
    /// [`Error::ToleranceNotMet`] if rounding exceeds the tolerance.
    pub(crate) fn seminorm(&self, order: Order, tolerance: Tolerance) -> Result<Estimate> {
        accept("seminorm", self.seminorm_as_it_is(order, tolerance)?, tolerance, LIMIT)
    }

    /// The norm ||u||_ν, whose square is the sum of the squares of the L² norm and of the seminorm.
    ///
    /// # Errors
    /// As [`BoundaryFunction::seminorm`].
    pub(crate) fn norm(&self, order: Order, tolerance: Tolerance) -> Result<Estimate> {
        let parts = [self.seminorm_as_it_is(order, tolerance)?, self.l2_norm()?];
        accept("norm", root_of_squares(&parts)?, tolerance, LIMIT)
    }

    /// The L² norm on the curve, exact to rounding.
    ///
    /// # Errors
    /// [`Error::NotFinite`] on overflow.
    pub(crate) fn l2_norm(&self) -> Result<Estimate> {
        let scale = self.size();
        let square = |e: usize| {
            let [a, b] = self.ends[e].map(|v| v / scale);
            self.curve.element_length(e) * (a * a + a * b + b * b) / 3.0
        };
        let value = scale * (0..self.ends.len()).map(square).sum::<f64>().sqrt();
        Estimate::new(value, ENTRY_ROUNDING * value, Work::default())
    }

    /// The derivative with respect to the arc length, constant on every element.
    ///
    /// # Errors
    /// [`Error::InfiniteNorm`] of order 1 if the function jumps; [`Error::NotFinite`] if a slope overflows.
    pub(crate) fn derivative(&self) -> Result<Self> {
        let jumps = self.ends.iter().flatten().any(|&v| v != self.ends[0][0]);
        if self.constants && jumps {
            let why = "a function that jumps has no derivative in L^2";
            return Err(Error::InfiniteNorm { order: 1.0, why });
        }
        let slope = |(e, [a, b]): (usize, &[f64; 2])| (b - a) / self.curve.element_length(e);
        let slopes: Vec<f64> = self.ends.iter().enumerate().map(slope).collect();
        Self::constants(self.curve.clone(), &slopes)
    }

    fn size(&self) -> f64 {
        power_of_two(self.ends.iter().flatten().fold(0.0, |most, v| v.abs().max(most)))
    }

    fn seminorm_as_it_is(&self, order: Order, tolerance: Tolerance) -> Result<Estimate> {
        let n = self.ends.len();
        let first = self.ends[0][0];
        if self.ends.iter().flatten().all(|&v| v == first) {
            return Estimate::new(0.0, 0.0, Work::default());
        }
        if self.constants && !order.is_below_half() {
            let why = "a function with a jump is not in H^nu for nu >= 1/2";
            return Err(Error::InfiniteNorm { order: order.value(), why });
        }
        if n > MOST {
            return Err(Error::CountOutOfRange { name: "elements", value: n, range: "[1, 20000]" });
        }
        require_memory("elements", n, 64)?;
        let scale = self.size();
        let target = SHARE * tolerance.relative();
        let pairs = CurvePairs::new(&self.curve, order, self.constants, target, tolerance.work())?;
        let value = |e: usize, s: f64| {
            let [a, b] = self.ends[e];
            (a / scale) * (1.0 - s) + (b / scale) * s
        };
        let sum = (0..n)
            .into_par_iter()
            .map(|e| {
                let step = value(e, 1.0) - value(e, 0.0);
                let mut sum = PairSum {
                    value: pairs.own(self.curve.element_length(e)) * step * step,
                    ..PairSum::default()
                };
                for f in e + 1..n {
                    pairs.visit(e, f, &mut |w, s, t| {
                        let difference = value(e, s) - value(f, t);
                        sum.value += w * difference * difference;
                        sum.rounding += w * difference.abs();
                        sum.points += 1;
                    });
                }
                sum
            })
            .reduce(PairSum::default, |a, b| a + b);
        pairs.require_all()?;
        let error = (target + ENTRY_ROUNDING) * sum.value + 8.0 * f64::EPSILON * sum.rounding;
        let work = Work { points: sum.points, pairs: (n * (n + 1) / 2) as u64, ..Work::default() };
        Estimate::new(sum.value, error, work)?.sqrt()?.times(scale)
    }
}
