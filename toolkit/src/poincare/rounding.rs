//! A priori estimates of the rounding error of γ.

use super::constraint::Constraint;
use super::slopes::local::{SHORT, negligible_for_jumps};
use crate::Order;

/// Relative error of assembly, factorization and quotient: the largest error observed for an exact space is
/// 1.3e-13.
pub(super) const ROUNDING: f64 = 2e-13;

/// The same for a short zone in the interior, where energies at all distances are added: two independent bases
/// differ by 4e-14 at θ = 1e-20, 4e-12 at 1e-100 and 5e-11 at 1e-300, in proportion to the square of the
/// logarithm.
const ROUNDING_INSIDE: f64 = 5e-11;

/// Relative error as ν → 0, multiplied by ν, because ν|u|_ν² is computed as a difference of terms of order one.
const ROUNDING_OF_DIFFERENCES: f64 = 4e-16;

/// The same for a zone of several intervals: each contributes θ^{1−2ν}, the difference of numbers of the size
/// of ℓ^{1−2ν}, where ℓ is the extent of a short zone and 1 otherwise.
const ROUNDING_OF_DIPS: f64 = 4e-15;

/// The relative error of γ that no refinement of the space reduces.
pub(super) fn rounding(order: Order, constraint: &Constraint) -> f64 {
    let neighbour = |part: Option<usize>| part.and_then(|k| constraint.parts.get(k)).copied();
    let (first, last) = (constraint.zones[0], constraint.zones[constraint.zones.len() - 1]);
    let sides = [neighbour(first.checked_sub(1)), neighbour(Some(last + 1))];
    let theta: f64 = constraint.parts[first..=last].iter().sum();
    let extent = match sides {
        [Some(left), Some(right)] if theta <= SHORT * left.min(right) => theta,
        _ => 1.0,
    };
    let longest = constraint.zones.iter().map(|&part| constraint.parts[part]).fold(0.0, f64::max);
    let dips = if first == last {
        0.0
    } else {
        ROUNDING_OF_DIPS * (extent / longest).powf(order.one_minus_twice().max(0.0))
    };
    let inside = match sides {
        [Some(left), Some(right)] if theta > 0.0 => {
            let decades = (left.min(right) / theta).log10().max(0.0);
            ROUNDING_INSIDE * (decades / 300.0).powi(2)
                + negligible_for_jumps(order.one_minus_twice())
        }
        _ => 0.0,
    };
    ROUNDING + ROUNDING_OF_DIFFERENCES / order.value() + inside + dips
}
