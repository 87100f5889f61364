//! Noise of values: rounding inside of a formula, above that of x and u.
//!
//! A formula f(x + c) rounds its argument to ulps of c, and its values by |f′| times that; u − v with v near u rounds to ulps
//! of u. Neither x nor the value of the formula tell. Values u(t) + η(t) of the local coordinate t of a cell, u smooth and
//! η noise of size σ, have at the spacing h the fourth difference
//!
//! ```text
//! Δ⁴ = h⁴ u⁗ + (η₋₂ − 4 η₋₁ + 6 η₀ − 4 η₁ + η₂),
//! ```
//!
//! the last term of which is about √70 σ, 8 σ, if the η are independent, and at most 16 σ. With h = 2⁻²⁴ the first one is
//! 2⁻⁹⁶ u⁗: below rounding for every function that polynomials on cells not much shorter can resolve. So Δ⁴ is noise and its
//! rounding, unless a jump or a kink lies between these five points, which is possible at one of several places: the second
//! largest of [`HEARD`] is taken.
//!
//! A polynomial of degree 18 through values with noise differs from other values by at most about 4 σ, and this difference
//! ε, to which all samples of the cell belong, is doubled. If a cell is no better than that of which it is a half, and 2ε
//! is at most [`NOISY`] Δ⁴, then ε is noise: division does not make it smaller, and the cell counts as resolved. ε ≥ |u − p| is the error of the cell as everywhere
//! else, and enters the ± of all verbs in the same way: a feature of which the comparison meets more than 16 |Δ⁴| is
//! resolved as if there were no noise, a smaller one is part of ε. Where the noise allowed is not the cause of ε nothing
//! changes.
//!
//! Noise has no derivatives: in seminorms the error u − p is that of a polynomial through noisy values. An oscillation
//! shorter than 2⁻²² of a cell looks the same. So noise above [`QUIET`] must have the same size at the spacing 2⁻³⁸, where
//! 10¹⁰ oscillations are smooth; otherwise the cell is rough: L^q norms have the noise in their error, seminorms are rejected
//! for ν ≥ 1/2.

use crate::error::Result;

/// Places of a cell at which the noise of the values is measured, and the distances of the points there in units of h: if
/// h is a multiple of the ulp of the rounded argument, rounding is the same at all five points.
const HEARD: [(f64, f64); 5] =
    [(0.11, 1.0), (0.31, 0.834), (0.52, 0.713), (0.74, 0.617), (0.93, 0.541)];
/// Multiple of the noise at two of them by which that of the others may be larger.
const UNEVEN: f64 = 16.0;
/// The distance of the points of a fourth difference, and of the one for oscillations.
const APART: f64 = 1.0 / (1_u64 << 24) as f64;
const CLOSER: f64 = 1.0 / (1_u64 << 38) as f64;
/// Noise of values of a function of size 1 up to which it is taken for rounding, and the share of a larger one that stays.
pub(super) const QUIET: f64 = 1e-9;
const STAYS: f64 = 0.25;
/// Multiple of the fourth difference up to which a difference from a polynomial is noise.
pub(super) const NOISY: f64 = 4.0;

/// What is known of the noise of the values on a cell.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(super) struct Noise {
    /// the fourth difference, if it was measured
    fourth: Option<f64>,
    /// true if the error of the cell is noise
    pub(super) is_part_of_error: bool,
    /// true if it may be an oscillation
    pub(super) is_rough: bool,
}

impl Noise {
    /// The rounding of a sum, which is the error of the cell.
    pub(super) fn known(size: f64) -> Self {
        Self { fourth: Some(size), is_part_of_error: true, is_rough: false }
    }

    /// The noise of a function of the local coordinate.
    ///
    /// # Errors
    /// Those of the values.
    pub(super) fn of(value: impl Fn(f64) -> Result<f64>) -> Result<f64> {
        second_largest(&value, APART)
    }

    /// The noise of a cell whose polynomial is `off`, and whether it explains that; `heard` is known of a larger cell.
    ///
    /// # Errors
    /// Those of the values.
    pub(super) fn explaining(
        off: f64,
        heard: f64,
        value: impl Fn(f64) -> Result<f64>,
    ) -> Result<Self> {
        let known = Self { fourth: None, is_part_of_error: true, is_rough: false };
        if off <= NOISY * heard.min(QUIET) {
            return Ok(known);
        }
        let first = |(place, factor)| fourth(&value, place, factor * APART);
        if off > QUIET && off > UNEVEN * NOISY * first(HEARD[1])?.max(first(HEARD[3])?) {
            return Ok(Self::default());
        }
        let size = Self::of(&value)?;
        if off > NOISY * size.max(heard) {
            return Ok(Self { fourth: Some(size), ..Self::default() });
        }
        let is_rough = size.max(heard) > QUIET && second_largest(&value, CLOSER)? < STAYS * size;
        Ok(Self { fourth: Some(size), is_rough, ..known })
    }

    /// The fourth difference, 0 where it was not measured.
    pub(super) fn heard(&self) -> f64 {
        self.fourth.unwrap_or(0.0)
    }

    /// The size, measured once.
    ///
    /// # Errors
    /// Those of the measurement.
    pub(super) fn size(&mut self, measure: impl FnOnce() -> Result<f64>) -> Result<f64> {
        let found = self.fourth.map_or_else(measure, Ok)?;
        Ok(*self.fourth.insert(found))
    }
}

fn fourth(value: &impl Fn(f64) -> Result<f64>, centre: f64, apart: f64) -> Result<f64> {
    let at = |k: f64| value(centre + k * apart);
    Ok((at(-2.0)? + 6.0 * at(0.0)? + at(2.0)? - 4.0 * (at(-1.0)? + at(1.0)?)).abs())
}

fn second_largest(value: &impl Fn(f64) -> Result<f64>, apart: f64) -> Result<f64> {
    let at = |(place, factor): (f64, f64)| fourth(value, place, factor * apart);
    let mut all = HEARD.into_iter().map(at).collect::<Result<Vec<_>>>()?;
    all.sort_by(f64::total_cmp);
    Ok(all[all.len() - 2])
}
