//! The number of zeros in a rectangle, by the argument principle with steps so short that no full turn is
//! missed.
//!
//! At a point of the path with |f| = a, |f′| = b and |f″| ≤ M along the rest of it, f changes by at most b t + M t²/2
//! in a step of length t. If this is at most 7a/10, the image does not encircle zero and the argument changes by
//! exactly that of the ratio of the two values: the count is rigorous up to rounding. A path so close to a zero that
//! rounding dominates, or that steps become too short, is rejected; the caller then moves it.

use super::factor::Factor;
use faer::c64;
use std::f64::consts::TAU;

/// Largest relative change of f in a step.
const CHANGE: f64 = 0.7;
/// Values below this multiple of the rounding errors of their terms are rejected.
const ROUNDINGS: f64 = 1e3;
/// Smallest step, relative to the side; near a zero the steps shrink with the distance from it, a few per digit.
const SHORTEST: f64 = 1e-12;
/// Largest distance of the winding number from an integer: a sum of at most a million angles.
const INTEGER: f64 = 1e-3;

/// An upright rectangle of the λ-plane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Rectangle {
    pub(super) left: f64,
    pub(super) right: f64,
    pub(super) bottom: f64,
    pub(super) top: f64,
}

impl Rectangle {
    pub(super) fn contains(&self, z: c64) -> bool {
        self.left < z.re && z.re < self.right && self.bottom < z.im && z.im < self.top
    }

    pub(super) fn center(&self) -> c64 {
        c64::new(0.5 * (self.left + self.right), 0.5 * (self.bottom + self.top))
    }

    /// True if it is symmetric about the real axis.
    pub(super) fn is_symmetric(&self) -> bool {
        self.bottom == -self.top
    }

    fn reach(&self) -> f64 {
        self.left.abs().max(self.right.abs()).hypot(self.height())
    }

    fn height(&self) -> f64 {
        self.bottom.abs().max(self.top.abs())
    }
}

/// The number of zeros of f in a rectangle, with multiplicities; `None` if the path is too close to a zero.
///
/// (1/2π) times the change of arg f around the rectangle, in steps so short that f changes by at most 0.7 |f| in each:
/// |f''| is bounded on the rectangle, so no turn is missed.
pub(super) fn zeros(f: &Factor, area: &Rectangle, points: &mut u64) -> Option<usize> {
    let Rectangle { left, right, bottom, top } = *area;
    let corners =
        [(left, bottom), (right, bottom), (right, top), (left, top)].map(|(x, y)| c64::new(x, y));
    let bend = f.bend(area.reach(), area.height());
    let mut angle = 0.0;
    for side in 0..4 {
        angle += turn(f, corners[side], corners[(side + 1) % 4], bend, points)?;
    }
    let turns = angle / TAU;
    let whole = turns.round();
    ((turns - whole).abs() < INTEGER && whole >= 0.0).then_some(whole as usize)
}

/// The change of the argument of f from one point to another.
///
/// Σ arg(f(z_{k+1})/f(z_k)) along the segment, each below arcsin 0.7 in absolute value.
fn turn(f: &Factor, from: c64, to: c64, bend: f64, points: &mut u64) -> Option<f64> {
    let length = (to - from).norm();
    let direction = (to - from) / length;
    let (mut place, mut angle, mut at) = (0.0, 0.0, from);
    let [mut value, mut slope, _] = f.values(at);
    while place < length {
        *points += 1;
        let (size, steep) = (value.norm(), slope.norm());
        // The positive root of b t + M t²/2 = 7a/10, without a difference.
        let step =
            2.0 * CHANGE * size / (steep + (steep * steep + 2.0 * bend * CHANGE * size).sqrt());
        let is_clear = size > ROUNDINGS * f64::EPSILON * f.terms(at);
        if !is_clear || step.is_nan() || step < SHORTEST * length {
            return None;
        }
        place = (place + step).min(length);
        at = if place < length { from + direction * place } else { to };
        let [next, next_slope, _] = f.values(at);
        angle += (next / value).arg();
        (value, slope) = (next, next_slope);
    }
    Some(angle)
}
