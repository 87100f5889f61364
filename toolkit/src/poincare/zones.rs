//! The zone E ⊂ (0,1) on which a function is controlled: an interval or a union of intervals.

use crate::error::{Error, Given, Result};
use crate::numeric::check::{require_entry, require_finite, require_finite_at};
use std::fmt;
use std::ops::Range;

/// Smallest admissible length; f64 loses digits below it.
const SHORTEST: f64 = 1e-300;
/// Largest number of intervals; each adds some hundred unknowns.
const MOST: usize = 32;
/// Relative length up to which a gap between given positions is attributed to rounding.
const TOUCHING: f64 = 4.0 * f64::EPSILON;

/// A zone E ⊂ (0,1): an interval, or a union of disjoint intervals with gaps between them.
///
/// A range `a..b` or an array of ranges is accepted wherever a zone is an argument. The zone is stored as a
/// list of lengths, so that short intervals and gaps given by their lengths have full relative accuracy at
/// any position.
///
/// ```
/// use fractional_sobolev::{Constraint, Zones, gamma};
/// // (1/5, 1/5 + 1e-20)
/// let tiny = Zones::from_start_and_length(0.2, 1e-20)?;
/// assert!(tiny.length() == 1e-20 && tiny.count() == 1);
/// let found = |zone: &Zones| gamma(0.5, Constraint::mean_zero_on(zone), 1e-6).map(|found| found.constant.value);
/// assert!(found(&tiny)? > found(&Zones::union(&[0.2..0.25])?)?);
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
#[doc(alias("zone", "interval", "subinterval"))]
#[derive(Debug, Clone, PartialEq)]
pub struct Zones {
    /// Gap, interval, gap, ..., interval, gap; the first and the last gap may be empty.
    lengths: Vec<f64>,
}

impl Given<Zones> for Zones {
    fn given(self) -> Result<Zones> {
        Ok(self)
    }
}

impl Given<Zones> for &Zones {
    fn given(self) -> Result<Zones> {
        Ok(self.clone())
    }
}

impl Given<Zones> for Result<Zones> {
    fn given(self) -> Result<Zones> {
        self
    }
}

impl Given<Zones> for Range<f64> {
    fn given(self) -> Result<Zones> {
        Zones::between(self.start, self.end)
    }
}

impl<const N: usize> Given<Zones> for [Range<f64>; N] {
    fn given(self) -> Result<Zones> {
        Zones::union(&self)
    }
}

impl Zones {
    /// The interval (a, a+θ) with a = 0 or a ≥ 1e-300, 1e-300 ≤ θ ≤ 1, and a + θ ≤ 1 up to rounding.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for all other values.
    pub fn from_start_and_length(start: f64, length: f64) -> Result<Self> {
        Error::require("theta", length, "[1e-300, 1]", (SHORTEST..=1.0).contains(&length))?;
        require_start(start)?;
        let rest = (1.0 - start) - length;
        // a + θ = 1 need not hold exactly for the rounded a and θ
        Error::require("zone end", start + length, "(0, 1]", rest >= -f64::EPSILON)?;
        let rest = if rest <= f64::EPSILON { 0.0 } else { rest };
        Ok(Self { lengths: vec![start, length, rest] })
    }

    /// The interval (a, b), 0 ≤ a < b ≤ 1, given by the range `a..b`.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] as for [`Zones::from_start_and_length`], and for b outside (a, 1].
    fn between(a: f64, b: f64) -> Result<Self> {
        require_start(a)?;
        let inside = b - a >= SHORTEST && b <= 1.0;
        Error::require("zone end", b, "[a + 1e-300, 1], a the zone start", inside)?;
        Ok(Self { lengths: vec![a, b - a, 1.0 - b] })
    }

    /// The union of intervals (a, b), given as ranges `a..b` in any order.
    ///
    /// ```
    /// use fractional_sobolev::{Constraint, Zones, gamma};
    /// let two = Zones::union(&[0.2..0.25, 0.7..0.75])?;
    /// let apart = gamma(0.5, Constraint::mean_zero_on(&two), 1e-3)?.constant;
    /// assert!(apart.value < gamma(0.5, Constraint::mean_zero_on(0.0..two.length()), 1e-3)?.constant.value);
    /// assert!(Zones::union(&[0.2..0.25, 0.22..0.27]).is_err());
    /// # Ok::<(), fractional_sobolev::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::CountOutOfRange`] unless there are 1 to 32 intervals; [`Error::EntryOutOfRange`] for
    /// lengths of intervals or gaps below 1e-300, for intervals that overlap or touch, and for a start below
    /// 0; [`Error::OutOfRange`] for an end beyond 1; [`Error::NotFinite`].
    pub fn union(intervals: &[Range<f64>]) -> Result<Self> {
        require_count(intervals.len())?;
        for (k, interval) in intervals.iter().enumerate() {
            require_finite_at("start of an interval", k, interval.start)?;
            require_finite_at("end of an interval", k, interval.end)?;
        }
        let mut sorted = intervals.to_vec();
        sorted.sort_by(|a, b| a.start.total_cmp(&b.start));
        let (mut lengths, mut before) = (Vec::new(), 0.0);
        for (k, &Range { start, end }) in sorted.iter().enumerate() {
            let gap = start - before;
            if k > 0 {
                let apart = gap > TOUCHING * start;
                require_entry(
                    "start of an interval",
                    k,
                    start,
                    "(end of the previous interval, inf)",
                    apart,
                )?;
            }
            lengths.extend([gap, end - start]);
            before = end;
        }
        Self::closed(lengths, 1.0 - before)
    }

    /// The zone with the lengths gap, interval, gap, interval, ..., interval from the left end; the remaining
    /// length up to 1 is the last gap.
    ///
    /// ```
    /// use fractional_sobolev::Zones;
    /// // (1/2, 1/2 + 1e-12) and (1/2 + 3e-12, 1/2 + 4e-12)
    /// let pair = Zones::from_lengths(&[0.5, 1e-12, 2e-12, 1e-12])?;
    /// assert!(pair.count() == 2 && pair.length() == 2e-12);
    /// # Ok::<(), fractional_sobolev::Error>(())
    /// ```
    ///
    /// # Errors
    /// As for [`Zones::union`]; [`Error::LengthMismatch`] for an odd number of lengths.
    pub fn from_lengths(lengths: &[f64]) -> Result<Self> {
        require_count(lengths.len() / 2)?;
        if lengths.len() % 2 == 1 {
            let expected = lengths.len() + 1;
            return Err(Error::LengthMismatch {
                name: "list of gap and interval lengths",
                given: expected - 1,
                expected,
            });
        }
        require_finite("length", lengths)?;
        Self::closed(lengths.to_vec(), 1.0 - lengths.iter().sum::<f64>())
    }

    /// The zone with these lengths, after they are checked and the last gap is added.
    fn closed(mut lengths: Vec<f64>, rest: f64) -> Result<Self> {
        for (k, &length) in lengths.iter().enumerate() {
            let name = if k % 2 == 0 { "gap" } else { "interval" };
            let admissible = (SHORTEST..=1.0).contains(&length) || (k == 0 && length == 0.0);
            require_entry(name, k / 2, length, "[1e-300, 1] (or 0 for the first gap)", admissible)?;
        }
        Error::require("end of the last interval", 1.0 - rest, "(0, 1]", rest >= -f64::EPSILON)?;
        lengths.push(if rest <= f64::EPSILON { 0.0 } else { rest });
        Ok(Self { lengths })
    }

    /// The measure θ of the zone.
    pub fn length(&self) -> f64 {
        self.lengths.iter().skip(1).step_by(2).sum()
    }

    /// The number of intervals.
    pub fn count(&self) -> usize {
        self.lengths.len() / 2
    }

    /// The intervals as pairs (a, ℓ); the positions are rounded.
    fn intervals(&self) -> Vec<(f64, f64)> {
        let pairs = self.lengths.chunks_exact(2);
        let located = pairs.scan(0.0, |end, pair| {
            let start = *end + pair[0];
            *end = start + pair[1];
            Some((start, pair[1]))
        });
        located.collect()
    }

    /// The length of a single interval that touches exactly one end of (0,1), the length of its complement, and
    /// whether that end is 1; `None` for other zones.
    pub(super) fn at_one_end(&self) -> Option<(f64, f64, bool)> {
        match self.lengths[..] {
            [0.0, length, rest] if rest > 0.0 => Some((length, rest, false)),
            [rest, length, 0.0] if rest > 0.0 => Some((length, rest, true)),
            _ => None,
        }
    }

    /// The nonzero lengths, with a flag for those that belong to the zone.
    pub(crate) fn parts(&self) -> (Vec<f64>, Vec<usize>) {
        let first = usize::from(self.lengths[0] > 0.0);
        let parts = self.lengths.iter().copied().filter(|&length| length > 0.0).collect();
        (parts, (0..self.count()).map(|k| first + 2 * k).collect())
    }
}

impl fmt::Display for Zones {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (k, (start, length)) in self.intervals().into_iter().enumerate() {
            let joined = if k == 0 { "" } else { " u " };
            if start == 0.0 {
                write!(f, "(0, {length:e})")?;
            } else {
                write!(f, "{joined}({start:e}, {start:e}+{length:e})")?;
            }
        }
        Ok(())
    }
}

fn require_start(start: f64) -> Result<f64> {
    let inside = start == 0.0 || (SHORTEST..1.0).contains(&start);
    Error::require("zone start", start, "{0} or [1e-300, 1)", inside)
}

fn require_count(count: usize) -> Result<()> {
    if (1..=MOST).contains(&count) {
        return Ok(());
    }
    Err(Error::CountOutOfRange { name: "intervals of a zone", value: count, range: "[1, 32]" })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Mesh;
    use crate::Order;
    use crate::estimate::{Estimate, Tolerance};
    use crate::gram::{gram_linears, mass_form};
    use crate::numeric::pencil::Factored;
    use crate::poincare::constant::gamma;
    use crate::poincare::constraint::{Condition, Constraint};
    use crate::poincare::mean::largest_mean;
    use nalgebra::DMatrix;

    const CONDITIONS: [Condition; 2] = [Condition::MeanZero, Condition::Vanishing];

    fn found(nu: f64, zones: impl Given<Zones>, condition: Condition) -> Estimate {
        gamma(nu, Constraint::on_zones(&zones.given().unwrap(), condition), 1e-6).unwrap().constant
    }

    #[test]
    fn bad_unions_are_refused() {
        let overlapping = [&[0.1..0.3, 0.2..0.4][..], &[0.1..0.2, 0.2..0.3], &[0.1..0.3, 0.1..0.3]];
        let outside = [[0.5..1.1], [-0.1..0.1], [0.1..0.1], [0.1..f64::NAN]];
        let outside = outside.iter().map(|one| &one[..]).chain([&[][..]]);
        for bad in overlapping.into_iter().chain(outside) {
            assert!(Zones::union(bad).is_err(), "{bad:?}");
        }
        for bad in [&[][..], &[0.5], &[0.1, 0.2, 0.0, 0.1], &[0.5, 0.6], &[0.1, -0.1, 0.1, 0.3]] {
            assert!(Zones::from_lengths(bad).is_err(), "{bad:?}");
        }
        let whole = Zones::union(&[0.0..1.0]).unwrap();
        assert!(
            gamma(Order::HALF, Constraint::vanishing_on(whole), Tolerance::fast())
                .map(|found| found.constant)
                .is_err()
        );
    }

    #[test]
    fn one_interval_has_the_bits_of_the_zone() {
        for (a, b) in [(0.0, 0.3), (0.25, 0.25 + 1e-9), (0.75, 1.0)] {
            for condition in CONDITIONS {
                let single = found(0.3, a..b, condition);
                assert_eq!(found(0.3, Zones::union(&[a..b]).unwrap(), condition), single);
                assert_eq!(found(0.3, [a..b], condition), single);
            }
        }
    }

    /// A conforming value on continuous piecewise linear functions of a mesh that is graded to the ends of
    /// the intervals: the constant is a sum of basis functions there and no slope appears.
    fn with_linears(nu: f64, zones: &Zones, condition: Condition) -> f64 {
        let order = Order::new(nu).unwrap();
        let mut points = vec![0.0, 1.0];
        points.extend(zones.intervals().iter().flat_map(|&(a, length)| [a, a + length]));
        points.sort_by(f64::total_cmp);
        points.dedup();
        let partition = Mesh::graded(&points, 14, 0.5).unwrap();
        let nodes = partition.nodes();
        let inside = |x: f64| {
            zones.intervals().iter().any(|&(a, length)| x > a - 1e-12 && x < a + length + 1e-12)
        };
        let (size, gram, mass) =
            (nodes.len(), gram_linears(&partition, order), mass_form(&partition));
        let mut mean = vec![0.0; size];
        for (k, pair) in nodes.windows(2).enumerate() {
            if inside(0.5 * (pair[0] + pair[1])) {
                let half = 0.5 * (pair[1] - pair[0]);
                mean[k] += half;
                mean[k + 1] += half;
            }
        }
        // u = Σ x_k φ_k: one node of the zone is expressed by the others, or all are left out
        let vanishes = condition == Condition::Vanishing;
        let pivot = (0..size).max_by(|&i, &j| mean[i].total_cmp(&mean[j])).unwrap();
        let kept: Vec<usize> =
            (0..size).filter(|&k| if vanishes { !inside(nodes[k]) } else { k != pivot }).collect();
        let slope = |k: usize| if vanishes { 0.0 } else { -mean[kept[k]] / mean[pivot] };
        let form = |of: &DMatrix<f64>| {
            DMatrix::from_fn(kept.len(), kept.len(), |i, j| {
                of[(kept[i], kept[j])]
                    + slope(i) * of[(pivot, kept[j])]
                    + slope(j) * of[(kept[i], pivot)]
                    + slope(i) * slope(j) * of[(pivot, pivot)]
            })
        };
        let factored = Factored::new(&form(&gram)).unwrap();
        factored.largest_eigenvalue(&form(&mass)).unwrap().0.sqrt()
    }

    #[test]
    fn unions_agree_with_piecewise_linears() {
        // Linears on cells that double have an error of some per cent, and from below.
        let three = [[0.0..0.05, 0.3..0.32, 0.9..1.0], [0.4..0.41, 0.45..0.47, 0.5..0.51]];
        for intervals in [&[0.1..0.3, 0.6..0.7][..], &three[0], &three[1]] {
            let zones = Zones::union(intervals).unwrap();
            for nu in [0.2, 0.5, 0.8] {
                for condition in CONDITIONS {
                    let (sharp, rough) =
                        (found(nu, zones.clone(), condition), with_linears(nu, &zones, condition));
                    let share = rough / sharp.value;
                    assert!(
                        share < 1.0 + 1e-6 && share > 0.96,
                        "{zones}, {nu}, {condition:?}: {share}"
                    );
                }
            }
        }
    }

    /// The mirror image under x → 1 − x.
    fn mirrored(zones: &Zones) -> Zones {
        Zones { lengths: zones.lengths.iter().rev().copied().collect() }
    }

    #[test]
    fn mirror_images_agree_and_short_gaps_close() {
        for nu in [0.1, 0.5, 0.9] {
            for condition in CONDITIONS {
                let far = [[0.1, 1e-5, 0.6, 1e-4], [0.2, 1e-9, 0.5, 1e-10]];
                for lengths in [[0.1, 0.05, 0.2, 1e-3], [0.3, 1e-8, 5e-8, 2e-8], far[0], far[1]] {
                    let zones = Zones::from_lengths(&lengths).unwrap();
                    let (one, other) = (
                        found(nu, zones.clone(), condition),
                        found(nu, mirrored(&zones), condition),
                    );
                    let apart = (one.value - other.value).abs();
                    assert!(
                        apart <= one.error + other.error,
                        "{zones}, {nu}, {condition:?}: {apart:e}"
                    );
                }
                let single = found(nu, 0.3..0.5, condition);
                let split = Zones::from_lengths(&[0.3, 0.1, 1e-9, 0.1 - 1e-9]).unwrap();
                let apart = (found(nu, split, condition).value / single.value - 1.0).abs();
                assert!(apart < 2e-6, "{nu}, {condition:?}: {apart:e}");
            }
        }
    }

    #[test]
    fn the_extremal_function_meets_its_condition_and_the_dual_norm_is_below() {
        let zones = Zones::union(&[0.1..0.12, 0.3..0.4, 0.8..0.85]).unwrap();
        let (order, tolerance) = (Order::new(0.4).unwrap(), Tolerance::new(1e-6).unwrap());
        for condition in CONDITIONS {
            let constraint = Constraint::on_zones(&zones, condition);
            let norm = largest_mean(order, &constraint, tolerance).unwrap();
            let found = gamma(order, constraint, tolerance).unwrap();
            let function = found.extremal().unwrap();
            assert!(norm.value > 0.0 && norm.value < found.constant.value);
            let mean: f64 = zones
                .intervals()
                .iter()
                .map(|&(a, length)| {
                    let at = |k: u32| function.value(&[a + length * (f64::from(k) + 0.5) / 4000.0]);
                    let values: Vec<f64> = (0..4000).map(at).collect();
                    if condition == Condition::Vanishing {
                        assert!(values.iter().all(|u| u.abs() < 1e-9), "{zones}");
                    }
                    values.iter().sum::<f64>() / 4000.0 * length
                })
                .sum();
            assert!(mean.abs() < 1e-6, "{condition:?}: {mean:e}");
        }
    }
}
