//! Lengths of elements that shrink towards an end, without cancellation.

use crate::error::{Error, Result};

/// The lengths L σ^m, then L σ^k (1 − σ), k = m − 1, ..., 0.
pub(super) fn geometric_lengths(layers: usize, ratio: f64, length: f64) -> Result<Vec<f64>> {
    require_length_of_interval(length)?;
    Error::require("grading ratio", ratio, "(0, 1)", ratio > 0.0 && ratio < 1.0)?;
    let power = |k: usize| length * ratio.powf(k as f64);
    let mut lengths = vec![power(layers)];
    lengths.extend((0..layers).rev().map(|k| power(k) * (1.0 - ratio)));
    Ok(lengths)
}

/// The lengths L ((i+1)/n)^β − L (i/n)^β, i < n.
pub(super) fn algebraic_lengths(count: usize, exponent: f64, length: f64) -> Result<Vec<f64>> {
    require_length_of_interval(length)?;
    let admissible = exponent > 0.0 && exponent.is_finite();
    Error::require("grading exponent", exponent, "(0, inf)", admissible)?;
    let element = |i: usize| {
        let right = length * ((i + 1) as f64 / count as f64).powf(exponent);
        if i == 0 { right } else { right * -(-exponent * (1.0 / i as f64).ln_1p()).exp_m1() }
    };
    Ok((0..count).map(element).collect())
}

/// The length L if 0 < L < ∞.
pub(super) fn require_length_of_interval(length: f64) -> Result<f64> {
    Error::require("length of the interval", length, "(0, inf)", length > 0.0 && length.is_finite())
}
