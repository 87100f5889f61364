//! A polynomial on a cell, and how far the function is from it.

use super::noise::Noise;
use crate::error::Result;
use crate::piecewise::{Piece, bubbles_of};
use crate::quadrature::Rule;
use std::cell::RefCell;

/// Degree of the polynomials.
pub(super) const DEGREE: usize = 18;
/// Number of points at which function and polynomial are compared.
const BETWEEN: usize = 24;
/// Relative rounding error of values.
const FLOOR: f64 = 64.0 * f64::EPSILON;
/// Relative size up to which the last coefficients are cut off, and up to which a function is linear.
const NOTHING: f64 = 4.0 * f64::EPSILON;
/// Bound of the ratio of the largest residual to that at the points that are compared.
const UNSEEN: f64 = 2.0;
/// Share of the largest rounding that is always there.
const AT_LEAST: f64 = 1.0 / 16.0;
/// Share of the variation on a cell that the rounding of x may explain.
const MOVED: f64 = 0.1;

/// A polynomial and a bound of its distance from the function.
pub(super) struct Fitted {
    pub(super) piece: Piece,
    pub(super) off: f64,
    /// true if this distance is rounding
    pub(super) is_resolved: bool,
    /// the largest difference that is attributed to rounding
    pub(super) allowed: f64,
    /// the noise of the values, where the distance is noise
    pub(super) noise: Noise,
}

impl Fitted {
    /// The same compared with all known values, which a polynomial that is off between its points is not.
    pub(super) fn beside(self, (places, values): &(Vec<f64>, Vec<f64>)) -> Self {
        let off = self.off.max(UNSEEN * apart(&self.piece, places, values));
        Self { off, ..self }
    }
}

/// The largest distance of values from a polynomial.
fn apart(piece: &Piece, places: &[f64], values: &[f64]) -> f64 {
    let apart = |(value, p): (&f64, f64)| (value - p).abs();
    values.iter().zip(piece.values(places)).map(apart).fold(0.0, f64::max)
}

/// The points of the polynomials and of the comparison.
pub(super) struct Fit {
    between: Rule,
}

impl Fit {
    pub(super) fn new() -> Result<Self> {
        Ok(Self { between: Rule::gauss_legendre(BETWEEN)? })
    }

    /// The polynomial of a function of the local coordinate t ∈ \[0, 1\] with known values `seen` (t, u) in it; `rounded`
    /// is the rounding error of t, and `floor` a size below which values are nothing.
    pub(super) fn of(
        &self,
        value: impl Fn(f64) -> Result<f64>,
        seen: &(Vec<f64>, Vec<f64>),
        rounded: f64,
        floor: f64,
    ) -> Result<Fitted> {
        let ends = [value(0.0)?, value(1.0)?];
        let fault = RefCell::new(None);
        let at = |t: f64| {
            value(t).unwrap_or_else(|error| {
                fault.borrow_mut().get_or_insert(error);
                0.0
            })
        };
        let between = self.between.points();
        let values: Vec<f64> = between.iter().map(|&t| at(t)).collect();
        let [low, high] = values
            .iter()
            .chain(&seen.1)
            .chain(&ends)
            .fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], &v| [low.min(v), high.max(v)]);
        let size = low.abs().max(high.abs());
        // The rounding of x moves a value along a slope; a jump is no slope.
        let moved = (FLOOR * rounded).min(MOVED) * (high - low);
        let noise = NOTHING * size + AT_LEAST * moved;
        let allowed = (FLOOR * size + moved).max(floor);
        // A polynomial that is off between its points need not be compared with the known values.
        let off = |piece: &Piece, enough: f64| {
            let residual = apart(piece, between, &values);
            if residual > enough { residual } else { residual.max(apart(piece, &seen.0, &seen.1)) }
        };
        let mut piece = Piece { left: ends[0], right: ends[1], bubbles: Vec::new() };
        let mut residual = off(&piece, noise.max(floor));
        if residual > noise.max(floor) {
            piece.bubbles = bubbles_of(DEGREE, ends, at)?;
            let mut cut = 0.0;
            while let Some(last) = piece.bubbles.last() {
                // |t (1 − t) P_k(2t − 1)| ≤ 1/4
                cut += 0.25 * last.abs();
                if cut > noise.max(floor) {
                    break;
                }
                piece.bubbles.pop();
            }
            residual = off(&piece, allowed);
        }
        if let Some(error) = fault.into_inner() {
            return Err(error);
        }
        let is_resolved = residual <= allowed;
        // The values of a constant have no rounding of their own.
        let off = if low == high { 0.0 } else { UNSEEN * residual + noise };
        Ok(Fitted { piece, off, is_resolved, allowed, noise: Noise::default() })
    }
}
