//! A polynomial for u − u_h on a cell away from the breakpoints, of a degree chosen by the decay of its
//! coefficients.

use super::layout::Part;
use crate::error::Result;
use crate::functions::SingularFunction;
use crate::piecewise::{Piece, PiecewisePolynomial, bubbles_of};

/// Successive degrees.
const DEGREES: [usize; 5] = [5, 8, 12, 16, 20];
/// Rounding error of bubbles, in units of that of the values.
const NOISE: f64 = 8.0;
/// Ratio of the error at a sample to that of the last coefficients from which the function is not the polynomial.
const UNSEEN: f64 = 16.0;
/// Values of a function of size 1 whose squares are no numbers.
const NOTHING: f64 = 1e-150;
/// Largest number of bisections of a cell.
const DEEPEST: usize = 30;

/// A polynomial, its truncation error estimated from its last coefficients, and the rounding error of its data.
pub(super) struct Fitted {
    pub(super) part: Part,
    pub(super) piece: Piece,
    pub(super) rest: f64,
    pub(super) noise: f64,
}

/// The difference u − u_h on a part, at local coordinates t of the part.
pub(super) struct Difference<'a> {
    pub(super) function: &'a SingularFunction<'a>,
    pub(super) field: &'a PiecewisePolynomial,
}

impl Difference<'_> {
    /// The values (u, u − u_h).
    pub(super) fn at(&self, part: &Part, t: f64) -> Result<(f64, f64)> {
        let from_left = part.left + part.length * t;
        let from_right = part.right + part.length * (1.0 - t);
        let value = if from_left <= from_right {
            self.function.value_at(part.gap, from_left, None)?
        } else {
            self.function.value_at(part.gap + 1, -from_right, None)?
        };
        let local = part.from * (1.0 - t) + part.to * t;
        Ok((value, value - self.field.pieces()[part.element].value(local)))
    }

    /// The value of u − u_h at the distance `share` of the length of a singular part from its breakpoint.
    pub(super) fn near_break(&self, part: &Part, mirrored: bool, share: f64) -> Result<f64> {
        let offset = part.length * share;
        let (k, offset) = if mirrored { (part.gap + 1, -offset) } else { (part.gap, offset) };
        let t = if mirrored { 1.0 - share } else { share };
        let local = part.from * (1.0 - t) + part.to * t;
        Ok(self.function.value_at(k, offset, None)?
            - self.field.pieces()[part.element].value(local))
    }

    /// The polynomials of a part or, if it must be bisected, of its halves, to `tolerance` times their size.
    pub(super) fn fit(&self, part: Part, tolerance: f64) -> Result<Vec<Fitted>> {
        let mut found = Vec::new();
        self.fit_into(part, tolerance, DEEPEST, &mut found)?;
        Ok(found)
    }

    fn fit_into(
        &self,
        part: Part,
        tolerance: f64,
        depth: usize,
        found: &mut Vec<Fitted>,
    ) -> Result<()> {
        let [(first, left), (last, right)] = [self.at(&part, 0.0)?, self.at(&part, 1.0)?];
        let (middle, _) = self.at(&part, 0.5)?;
        // Rounded values at rounded places.
        let place = part
            .left
            .min(part.right)
            .max(self.function.blur(part.gap))
            .max(self.function.blur(part.gap + 1))
            / part.length;
        let steep = (last - middle).abs().max((middle - first).abs());
        let size = first.abs().max(last.abs()).max(middle.abs());
        let noise = f64::EPSILON * (size + 2.0 * (1.0 + place) * steep);
        for degree in DEGREES {
            let piece = Piece { left, right, bubbles: self.bubbles(&part, degree, [left, right])? };
            let count = piece.bubbles.len();
            let rest = piece.bubbles[count - 2..].iter().fold(0.0_f64, |most, c| most.max(c.abs()));
            let whole =
                piece.bubbles.iter().fold(0.25 * (right - left).abs(), |most, c| most.max(c.abs()));
            let is_last = degree == DEGREES[DEGREES.len() - 1] && depth == 0;
            let allowed = (tolerance * whole).max(NOISE * noise).max(NOTHING);
            if is_last || rest <= allowed && self.agrees(&part, &piece, allowed) {
                let rest = if rest <= NOISE * noise { 0.0 } else { rest };
                found.push(Fitted { part, piece, rest, noise });
                return Ok(());
            }
        }
        for half in part.halves() {
            self.fit_into(half, tolerance, depth - 1, found)?;
        }
        Ok(())
    }

    /// True if a polynomial agrees with the samples of u in a part.
    fn agrees(&self, part: &Part, piece: &Piece, allowed: f64) -> bool {
        let off = |t: f64, value: f64| {
            let local = part.from * (1.0 - t) + part.to * t;
            let difference = value - self.field.pieces()[part.element].value(local);
            (difference - piece.value(t)).abs() <= UNSEEN * allowed
        };
        let arms = self.function.arms();
        let [left, right] = [&arms[2 * part.gap], &arms[2 * part.gap + 1]];
        let from_left = self.function.seen_within(left, part.left, part.left + part.length);
        let from_right = self.function.seen_within(right, part.right, part.right + part.length);
        from_left.into_iter().all(|(delta, value)| off((delta - part.left) / part.length, value))
            && from_right
                .into_iter()
                .all(|(delta, value)| off(1.0 - (delta - part.right) / part.length, value))
    }

    fn bubbles(&self, part: &Part, degree: usize, ends: [f64; 2]) -> Result<Vec<f64>> {
        // A value that is no number is reported where it is asked for again.
        let value = |t: f64| self.at(part, t).map_or(f64::NAN, |(_, e)| e);
        let bubbles = bubbles_of(degree, ends, value)?;
        if bubbles.iter().any(|c| !c.is_finite()) {
            self.at(part, 0.5)?;
        }
        Ok(bubbles)
    }
}
