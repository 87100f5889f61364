//! Functions made of formulas: u + v, u v, c u, and u on a part of its interval, again as formulas.
//!
//! The breakpoints are those of both. A point is known by its distance from the nearest of them, from which its distance
//! from the nearest breakpoint of u follows: exactly if they are the same point, else to the rounding of their distance,
//! which matters to neither.

use super::function::{Position, SingularFunction};
use crate::error::{Error, Result};

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
        let (anchor, offset) = if from_left <= -from_right {
            (right - 1, from_left.max(0.0))
        } else {
            (right, if from_right < 0.0 { from_right } else { -0.0 })
        };
        self.value_at(anchor, offset, depth.filter(|_| breaks[anchor] == base))
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
}

impl<'a> SingularFunction<'a> {
    /// f(u).
    pub(crate) fn mapped(&self, f: impl Fn(f64) -> f64 + Send + Sync + 'a) -> Result<Self> {
        let u = self.clone();
        let of = move |at: Position| f(u.value_or_nan(u.breaks()[at.anchor()], &at));
        self.seen_likewise(self.breaks(), of)
    }

    /// f(u, v).
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless both are defined on the same interval.
    pub(crate) fn with(
        &self,
        other: &Self,
        f: impl Fn(f64, f64) -> f64 + Send + Sync + 'a,
    ) -> Result<Self> {
        let (mine, others) = (self.breaks(), other.breaks());
        let (n, m) = (mine.len() - 1, others.len() - 1);
        let size = [mine[0], mine[n], others[0], others[m]]
            .iter()
            .fold(0.0_f64, |most, c| most.max(c.abs()));
        for (name, a, b) in [
            ("left end of the other function's interval", mine[0], others[0]),
            ("right end of the other function's interval", mine[n], others[m]),
        ] {
            let range =
                "{end of the function's interval}: both must be defined on the same interval";
            Error::require(name, b, range, (a - b).abs() <= SAME * size)?;
        }
        let mut breaks = [mine, &others[1..m]].concat();
        breaks.sort_by(f64::total_cmp);
        breaks.dedup();
        let (all, u, v) = (breaks.clone(), self.clone(), other.clone());
        let of = move |at: Position| {
            let base = all[at.anchor()];
            f(u.value_or_nan(base, &at), v.value_or_nan(base, &at))
        };
        if self.is_less_exact_than(other) {
            self.seen_likewise(&breaks, of)
        } else {
            other.seen_likewise(&breaks, of)
        }
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
        self.seen_likewise(&breaks, move |at: Position| u.value_or_nan(all[at.anchor()], &at))
    }
}
