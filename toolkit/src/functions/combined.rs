//! Functions made of formulas: u + v, u v, c u, and u on a part of its interval, again as formulas.
//!
//! The breakpoints are those of both. A point is known by its distance from the nearest of them, from which its distance
//! from the nearest breakpoint of u follows: exactly if they are the same point, else to the rounding of their distance,
//! which matters to neither.
//!
//! The rounding of a u + b v is relative to |a u| + |b v|, not to the value: with every sum goes the size of its terms.

use super::function::{Position, SingularFunction, Values};
use crate::error::{Error, Result};
use std::sync::Arc;

/// Multiple of the rounding of the ends up to which two intervals are the same.
const SAME: f64 = 64.0 * f64::EPSILON;

/// The breakpoint c_k.
///
/// # Errors
/// [`Error::CountOutOfRange`] if there is none.
pub(crate) fn break_of(breaks: &[f64], k: usize) -> Result<f64> {
    breaks.get(k).copied().ok_or(Error::CountOutOfRange {
        name: "breakpoint",
        value: k,
        range: "[0, number of breakpoints)",
    })
}

impl SingularFunction<'_> {
    /// The value at a signed offset from any coordinate `base` of the interval; `depth` is ln of the distance where it
    /// underflows.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] outside the interval, [`Error::NotFinite`].
    pub(crate) fn value_from(&self, base: f64, offset: f64, depth: Option<f64>) -> Result<f64> {
        let (anchor, offset) = self.nearest(base, offset)?;
        self.value_at(anchor, offset, depth.filter(|_| self.breaks()[anchor] == base))
    }

    /// The size of the terms of this value.
    ///
    /// # Errors
    /// As [`SingularFunction::value_from`].
    pub(crate) fn size_from(&self, base: f64, offset: f64, depth: Option<f64>) -> Result<f64> {
        let (anchor, offset) = self.nearest(base, offset)?;
        self.size_at(anchor, offset, depth.filter(|_| self.breaks()[anchor] == base))
    }

    /// The nearest breakpoint of a point, and the offset from it.
    fn nearest(&self, base: f64, offset: f64) -> Result<(usize, f64)> {
        let breaks = self.breaks();
        let last = breaks.len() - 1;
        let from = |k: usize| (base - breaks[k]) + offset;
        let slack = SAME * breaks[0].abs().max(breaks[last].abs());
        let inside = from(0) >= -slack && from(last) <= slack;
        Error::require("x", base + offset, "{the interval of the function}", inside)?;
        // A zero is on the side of its sign.
        let is_left = |k: &f64| {
            let apart = (base - k) + offset;
            apart > 0.0 || apart == 0.0 && !offset.is_sign_negative()
        };
        let right = breaks.partition_point(is_left).clamp(1, last);
        let [from_left, from_right] = [from(right - 1), from(right)];
        Ok(if from_left <= -from_right {
            (right - 1, from_left.max(0.0))
        } else {
            (right, if from_right < 0.0 { from_right } else { -0.0 })
        })
    }

    /// Breakpoint k.
    ///
    /// # Errors
    /// [`Error::CountOutOfRange`] if there is none.
    pub(crate) fn break_at(&self, k: usize) -> Result<f64> {
        break_of(self.breaks(), k)
    }

    fn value_or_nan(&self, base: f64, at: &Position) -> f64 {
        self.value_from(base, at.offset(), at.depth_if_any()).unwrap_or(f64::NAN)
    }

    fn size_or_nan(&self, base: f64, at: &Position) -> f64 {
        self.size_from(base, at.offset(), at.depth_if_any()).unwrap_or(f64::NAN)
    }
}

impl<'a> SingularFunction<'a> {
    /// c u.
    pub(crate) fn scaled(&self, factor: f64) -> Result<Self> {
        let u = self.clone();
        let of = move |at: Position| factor * u.value_or_nan(u.breaks()[at.anchor()], &at);
        let u = self.clone();
        let size = move |at: Position| factor.abs() * u.size_or_nan(u.breaks()[at.anchor()], &at);
        let terms = self.is_sum().then(|| Arc::new(size) as Values<'a>);
        Ok(self.seen_likewise(self.breaks(), of)?.with_terms(terms))
    }

    /// a u + b v.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless both are defined on the same interval.
    pub(crate) fn sum(&self, a: f64, other: &Self, b: f64) -> Result<Self> {
        let of = move |[u, v]: [f64; 2]| a * u + b * v;
        let size = move |_, [u, v]: [f64; 2]| a.abs() * u + b.abs() * v;
        self.with(other, true, of, size)
    }

    /// u v.
    ///
    /// # Errors
    /// As [`SingularFunction::sum`].
    pub(crate) fn times(&self, other: &Self) -> Result<Self> {
        let size = |[u, v]: [f64; 2], of: [f64; 2]| of[0] * v.abs() + u.abs() * of[1];
        self.with(other, self.is_sum() || other.is_sum(), |[u, v]| u * v, size)
    }

    /// f(u, v), and if it is a sum the size of its terms, from the values and from the sizes of theirs.
    fn with(
        &self,
        other: &Self,
        is_sum: bool,
        f: impl Fn([f64; 2]) -> f64 + Send + Sync + 'a,
        size: impl Fn([f64; 2], [f64; 2]) -> f64 + Send + Sync + 'a,
    ) -> Result<Self> {
        let (mine, others) = (self.breaks(), other.breaks());
        let (n, m) = (mine.len() - 1, others.len() - 1);
        let farthest = [mine[0], mine[n], others[0], others[m]]
            .iter()
            .fold(0.0_f64, |most, c| most.max(c.abs()));
        for (name, a, b) in [
            ("left end of the other function's interval", mine[0], others[0]),
            ("right end of the other function's interval", mine[n], others[m]),
        ] {
            let range =
                "{end of the function's interval}: both must be defined on the same interval";
            Error::require(name, b, range, (a - b).abs() <= SAME * farthest)?;
        }
        let mut breaks = [mine, &others[1..m]].concat();
        breaks.sort_by(f64::total_cmp);
        breaks.dedup();
        let both = Arc::new([self.clone(), other.clone()]);
        let (of, all) = (Arc::clone(&both), breaks.clone());
        let values =
            move |at: &Position| [0, 1].map(|k: usize| of[k].value_or_nan(all[at.anchor()], at));
        let (values, all) = (Arc::new(values), breaks.clone());
        let of = Arc::clone(&values);
        let size = move |at: Position| {
            let sizes = [0, 1].map(|k: usize| both[k].size_or_nan(all[at.anchor()], &at));
            size(values(&at), sizes)
        };
        let exact = if self.is_less_exact_than(other) { self } else { other };
        let found = exact.seen_likewise(&breaks, move |at: Position| f(of(&at)))?;
        Ok(found.with_terms(is_sum.then(|| Arc::new(size) as Values<'a>)))
    }

    /// u on (a, b).
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless a < b lie in the interval.
    pub(crate) fn restricted(&self, a: f64, b: f64) -> Result<Self> {
        let mine = self.breaks();
        let inside = |x: f64| x >= mine[0] && x <= mine[mine.len() - 1];
        let range = "{the interval of the function}";
        Error::require("left end of the restriction", a, range, inside(a))?;
        Error::require("right end of the restriction", b, range, inside(b) && a < b)?;
        let mut breaks = vec![a];
        breaks.extend(mine.iter().copied().filter(|&c| c > a && c < b));
        breaks.push(b);
        let (all, u) = (breaks.clone(), self.clone());
        let size = move |at: Position| u.size_or_nan(all[at.anchor()], &at);
        let (all, u) = (breaks.clone(), self.clone());
        let of = move |at: Position| u.value_or_nan(all[at.anchor()], &at);
        let terms = self.is_sum().then(|| Arc::new(size) as Values<'a>);
        Ok(self.seen_likewise(&breaks, of)?.with_terms(terms))
    }
}
