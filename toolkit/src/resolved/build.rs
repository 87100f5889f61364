//! The constructor: from a formula to cells.

use super::cells::{Cell, Place, Resolved};
use super::edges::{Edge, edge};
use super::fit::{DEGREE, Fit, Fitted};
use super::noise::{NOISY, Noise, QUIET};
use crate::error::{Error, Result};
use crate::estimate::Tolerance;
use crate::functions::{Arm, Normalized, SingularFunction, Units};
use crate::piecewise::Piece;
use std::cell::OnceCell;

/// Largest number of cells.
const MOST: usize = 1 << 17;
/// Largest number of bisections of a cell away from the breakpoint.
const HALVINGS: u32 = 60;
/// Number of bisections from which a cell is examined for a jump or a kink.
const EXAMINED: u32 = 2;
/// Values of a function of size 1 whose squares are no numbers.
const NOTHING: f64 = 1e-150;
/// At a distance δ from the breakpoint of a side of length R, values of a function of size 1 are nothing below this times
/// δ/R: relative accuracy is kept towards the breakpoint, where u may tend to zero, not in the tails of a bell.
const NEXT_TO: f64 = 1.0 / 16.0 * f64::EPSILON;
/// The cell at a breakpoint is tried after every one of the first halvings, then after every fourth.
const FIRST: usize = 4;
/// Relative rounding error of values.
const FLOOR: f64 = 64.0 * f64::EPSILON;
/// Rounding of a coordinate in ulps, of the place of a kink and of the values beside it.
const STAIRS: f64 = 4.0;
/// Number of cells on either side whose slopes count, and their least length in units of this rounding.
const NEARBY: usize = 3;
const LONG: f64 = 64.0;
/// Local coordinate below which a polynomial of degree 18 has its value at the end: its slope is at most 2 · 18² times its
/// size.
const AT_END: f64 = 1e-20;
/// Rounding of a sum relative to the size of its terms, and the places of a cell at which this is taken.
const OF_TERMS: f64 = 4.0 * f64::EPSILON;
const AT_TERMS: [f64; 4] = [0.0, 0.31, 0.69, 1.0];
/// Factor by which a halved cell is better where a function is smooth; where it is not, there is an edge or noise.
const BETTER: f64 = 16.0;
/// Number of times that the logarithm of the smallest distance is doubled where a function can be evaluated at any depth.
const DOUBLINGS: u32 = 64;
/// Message: more halvings than asked for.
const DEEP: &str = "the function is singular at a breakpoint";
/// Message: too many cells.
const TOO_MANY: &str = "the structure of the function is not resolved by 131072 cells";

/// A cell of a side, by its distances from the breakpoint; its polynomial is from left to right.
struct Side {
    near: f64,
    far: f64,
    piece: Piece,
    off: f64,
    /// what is known of the noise of the values
    noise: Noise,
    is_rough: bool,
}

/// A part of a side that is not resolved yet: u is evaluated at distances in \[low, high\] only, on one side of a jump.
#[derive(Clone, Copy)]
struct Part {
    near: f64,
    far: f64,
    low: f64,
    high: f64,
    halvings: u32,
    /// how far the polynomial on the part of which this is a part is from u
    before: f64,
    /// the noise of the parts of which this is a part, as far as it was measured
    heard: f64,
}

impl Resolved {
    /// The polynomials of a function with breakpoints, accurate to rounding where that is possible.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for a value that is not finite; [`Error::ToleranceNotMet`] without a value if 131072 cells
    /// do not resolve it.
    pub(crate) fn of(u: &SingularFunction) -> Result<Self> {
        Self::within(u, usize::MAX)
    }

    /// The same if at most `most` halvings towards a breakpoint are enough: for functions that are smooth up to their
    /// breakpoints or have moderate layers there, not for powers and logarithms.
    ///
    /// # Errors
    /// As [`Resolved::of`]; [`Error::ToleranceNotMet`] if more halvings are needed.
    pub(crate) fn within(u: &SingularFunction, most: usize) -> Result<Self> {
        let Normalized { units: Units { length: unit, size }, u: normal } =
            u.normalized(Tolerance::balanced())?;
        let builder = Builder { u: &normal, fit: Fit::new()?, halvings: most };
        let (mut cells, mut open): (Vec<Cell>, Vec<f64>) = (Vec::new(), Vec::new());
        let (mut before, mut is_noisy) = (0.0, false);
        for (k, arm) in normal.arms().iter().enumerate() {
            let (mut side, is_open) = builder.side(arm, MOST.saturating_sub(cells.len()))?;
            let base = u.breaks()[arm.anchor];
            if is_open {
                open.push(base);
            }
            let slack = slack_of(&side[0], arm);
            builder.join_along(&mut side, arm)?;
            is_noisy |= side.iter().any(|cell| cell.noise.is_part_of_error);
            if arm.sign < 0.0 {
                side.reverse();
            }
            let first = cells.len();
            cells.extend(side.into_iter().map(
                |Side { near, far, piece, off, is_rough, .. }| Cell {
                    start: Place { base, offset: unit * if arm.sign > 0.0 { near } else { -far } },
                    length: (far - near) * unit,
                    piece: piece.scaled(size),
                    off: size * off,
                    is_rough,
                },
            ));
            if k > 0 {
                join(&mut cells, first, k % 2 == 1, [size * before, size * slack]);
            }
            before = slack;
        }
        let end = Place::at(u.breaks()[u.breaks().len() - 1]);
        Ok(Self { cells, end, breaks: u.breaks().to_vec(), open, is_noisy })
    }
}

/// Where two sides meet: in the middle of an interval the value is the same, at a breakpoint it is if the limits agree to
/// their slack. Then it is the limit on the longer scale: a step of its rounding error, seen from there, would outweigh
/// a function that lives on the shorter one.
fn join(cells: &mut [Cell], at: usize, is_middle: bool, slack: [f64; 2]) {
    let (left, right) = (cells[at - 1].piece.right, cells[at].piece.left);
    if is_middle || (left - right).abs() <= slack[0] + slack[1] {
        let limit = match slack[0].total_cmp(&slack[1]) {
            std::cmp::Ordering::Less => left,
            std::cmp::Ordering::Equal => 0.5 * (left + right),
            std::cmp::Ordering::Greater => right,
        };
        cells[at - 1].piece.right = limit;
        cells[at].piece.left = limit;
    }
}

/// A bound of the difference between the value at the breakpoint and the limit there.
fn slack_of(cell: &Side, arm: &Arm) -> f64 {
    let size = cell.piece.size();
    let slope = 2.0 * (DEGREE * DEGREE) as f64 * size / (cell.far - cell.near);
    let noise = if cell.noise.is_part_of_error { cell.off } else { 0.0 };
    FLOOR * size + noise + slope * (arm.delta(arm.depth) + 16.0 * arm.blur)
}

struct Builder<'a> {
    u: &'a SingularFunction<'a>,
    fit: Fit,
    /// the largest number of halvings towards a breakpoint
    halvings: usize,
}

impl Builder<'_> {
    /// The cells of a side from its breakpoint outwards, and whether the variation of u has not ended at the smallest
    /// distance.
    fn side(&self, arm: &Arm, most: usize) -> Result<(Vec<Side>, bool)> {
        let deepest = arm.depth.floor() as usize;
        // The values on all scales; only a polynomial that is resolved is compared with them. A function of the logarithm
        // of the distance may change far below the smallest one.
        let scales = OnceCell::new();
        let sampled = || -> Vec<(f64, f64)> {
            let seen = (0..deepest)
                .map(|k| arm.delta(k as f64 + 0.5))
                .map_while(|delta| self.u.evaluated(arm, delta).ok().map(|v| (delta, v)));
            let doublings = if self.u.is_known_at_any_depth() { DOUBLINGS } else { 0 };
            let deeper = (1..=doublings)
                .map(|k| arm.depth * f64::from(k).exp2())
                .map_while(|t| self.u.at_depth(arm, t).ok().map(|value| (0.0, value)));
            seen.chain(deeper).collect()
        };
        let least = arm.delta(arm.depth);
        let (mut far, mut halvings, mut count) = (arm.length, Vec::new(), 0);
        let mut before = f64::INFINITY;
        let (end, is_open) = loop {
            let is_last = 0.25 * far <= least;
            if is_last || count < FIRST || count % FIRST == 0 {
                let part = Part { low: least, before, ..Part::of(0.0, far) };
                let Fitted { piece, off, is_resolved, allowed, noise } = self.fitted(arm, &part)?;
                before = off;
                let is_rough = noise.is_rough;
                let cell = Side { near: 0.0, far, piece, off, noise, is_rough };
                if is_resolved || is_last {
                    let below = scales.get_or_init(sampled);
                    let below = below.iter().filter(|(delta, _)| *delta < far);
                    let apart = below
                        .map(|(delta, value)| (value - cell.value(arm, *delta)).abs())
                        .fold(0.0, f64::max);
                    let agrees = is_resolved && apart <= allowed;
                    if agrees || is_last {
                        break (Side { off: cell.off.max(apart), ..cell }, !agrees);
                    }
                }
            }
            halvings.push(far);
            far *= 0.5;
            count += 1;
            if count > self.halvings {
                return Err(Error::out_of_reach("polynomials", f64::EPSILON, f64::INFINITY, DEEP));
            }
        };
        let mut cells = vec![end];
        for &far in halvings.iter().rev() {
            let near = 0.5 * far;
            self.refine(arm, Part::of(near, far), &mut cells)?;
            if cells.len() > most {
                return Err(Error::out_of_reach(
                    "polynomials",
                    f64::EPSILON,
                    f64::INFINITY,
                    TOO_MANY,
                ));
            }
        }
        Ok((cells, is_open))
    }

    /// The rounding of a place at a distance.
    fn blur(&self, arm: &Arm, delta: f64) -> f64 {
        STAIRS * f64::EPSILON * (self.u.coordinate_if_seen(arm.anchor).abs() + delta)
    }

    /// The cells on both sides of node k, without those of a few ulps, which have no slope and no noise.
    fn long_near<'a>(
        &'a self,
        side: &'a [Side],
        arm: &'a Arm,
        k: usize,
    ) -> impl Iterator<Item = usize> + 'a {
        let near = k.saturating_sub(NEARBY)..(k + NEARBY).min(side.len());
        near.filter(|&k| side[k].far - side[k].near > LONG * self.blur(arm, side[k].near))
    }

    /// The largest noise of them.
    fn noise_near(&self, side: &mut [Side], arm: &Arm, k: usize) -> Result<f64> {
        let near: Vec<usize> = self.long_near(side, arm, k).collect();
        let mut noise = 0.0_f64;
        for k in near {
            let part = Part::of(side[k].near, side[k].far);
            let measure = || {
                let heard = Noise::of(self.values(arm, &part))?;
                Ok(heard.max(self.rounding(arm, &part)?))
            };
            noise = noise.max(side[k].noise.size(measure)?);
        }
        Ok(noise)
    }

    /// Neighbouring cells of a side have the same value at their common end if the values differ by no more than noise and
    /// the rounding of x, which enters u, moves them along the slopes of the cells nearby: a kink is located to an ulp, and
    /// u is a staircase of ulps beside it. The value of the longer cell is taken; the difference is part of the error of the
    /// other. The noise is measured where only it could explain a difference.
    fn join_along(&self, side: &mut [Side], arm: &Arm) -> Result<()> {
        let outwards = arm.sign > 0.0;
        for k in 0..side.len() {
            // The staircase of rounding inside of u is no structure.
            let may_be_noise = side[k].is_rough && !side[k].noise.is_rough;
            if may_be_noise && side[k].off <= NOISY * self.noise_near(side, arm, k)? {
                side[k].is_rough = false;
                side[k].noise.is_part_of_error = true;
            }
        }
        for k in 1..side.len() {
            let [inner, outer] = [&side[k - 1], &side[k]];
            let (before, after) = match outwards {
                true => (inner.piece.right, outer.piece.left),
                false => (inner.piece.left, outer.piece.right),
            };
            let apart = (before - after).abs();
            if apart == 0.0 {
                continue;
            }
            let size = inner.piece.size().max(outer.piece.size());
            let is_inner_longer = inner.far - inner.near >= outer.far - outer.near;
            let blur = self.blur(arm, inner.far);
            let slope = |k: usize| {
                let cell = &side[k];
                (cell.piece.right - cell.piece.left).abs() / (cell.far - cell.near)
            };
            let steep = self.long_near(side, arm, k).map(slope).fold(0.0, f64::max);
            let rounding = FLOOR * size + 2.0 * blur * steep;
            let is_noise = apart > rounding;
            if is_noise && apart > rounding + NOISY * self.noise_near(side, arm, k)? {
                continue;
            }
            let (limit, other) = if is_inner_longer { (before, k) } else { (after, k - 1) };
            let cell = &mut side[other];
            cell.off += apart;
            cell.noise.is_part_of_error |= is_noise;
            // the end at which the other cell meets the longer one
            if is_inner_longer == outwards {
                cell.piece.left = limit;
            } else {
                cell.piece.right = limit;
            }
        }
        Ok(())
    }

    /// Divides a part until polynomials agree with u.
    fn refine(&self, arm: &Arm, part: Part, cells: &mut Vec<Side>) -> Result<()> {
        let coordinate = self.u.coordinate_if_seen(arm.anchor);
        let mut stack = vec![part];
        while let Some(part) = stack.pop() {
            let Part { near, far, low, high, halvings, .. } = part;
            let fitted = self.fitted(arm, &part)?;
            let short = far - near <= 8.0 * f64::EPSILON * (far + coordinate.abs());
            if fitted.is_resolved || short || halvings == HALVINGS || cells.len() > MOST {
                let Fitted { piece, off, is_resolved, noise, .. } = fitted;
                let is_rough = !is_resolved || noise.is_rough;
                cells.push(Side { near, far, piece, off, noise, is_rough });
                continue;
            }
            let value = |delta: f64| self.u.evaluated(arm, delta);
            let same = |a: f64, b: f64| {
                a == b
                    || coordinate != 0.0 && coordinate + arm.sign * a == coordinate + arm.sign * b
            };
            let found = if halvings < EXAMINED { None } else { edge(low, high, &value, same)? };
            let divided = Part {
                halvings: halvings + 1,
                before: fitted.off,
                heard: part.heard.max(fitted.noise.heard()),
                ..part
            };
            // A jump lies at the distance of the first value beyond it; nearer to the breakpoint u is not evaluated there.
            let [inner, outer] = match found {
                Some(Edge::Jump { below, above }) if above < far => [
                    Part { far: above, high: below, ..divided },
                    Part { near: above, low: above, ..divided },
                ],
                Some(Edge::Kink { at }) => {
                    [Part { far: at, high: at, ..divided }, Part { near: at, low: at, ..divided }]
                }
                _ => {
                    let middle = 0.5 * (near + far);
                    [
                        Part { far: middle, high: middle, ..divided },
                        Part { near: middle, low: middle, ..divided },
                    ]
                }
            };
            // Nearest to the breakpoint on top.
            stack.extend([outer, inner]);
        }
        Ok(())
    }

    /// The values on a part, as a function of the local coordinate from left to right.
    fn values(&self, arm: &Arm, part: &Part) -> impl Fn(f64) -> Result<f64> + Copy {
        let (arm, Part { near, far, low, high, .. }) = (*arm, *part);
        // Neighbouring cells have exactly the same value at their common end.
        let [first, last] = if arm.sign > 0.0 { [near, far] } else { [far, near] };
        move |t: f64| {
            let delta = match t {
                0.0 => first,
                1.0 => last,
                _ => first + arm.sign * (far - near) * t,
            };
            if near == 0.0 && delta < low && 2.0 * low <= high {
                // To second order: a limit that is a value at the smallest distance is off by a slope times this distance.
                let [nearest, next] = [low, 2.0 * low].map(|delta| self.u.evaluated(&arm, delta));
                let (nearest, next) = (nearest?, next?);
                return Ok(nearest + (1.0 - delta / low) * (nearest - next));
            }
            self.u.evaluated(&arm, delta.clamp(low, high))
        }
    }

    /// The rounding of values that are sums; 0 of others.
    fn rounding(&self, arm: &Arm, part: &Part) -> Result<f64> {
        if !self.u.is_sum() {
            return Ok(0.0);
        }
        let size = |t: f64| {
            let delta = part.near + (part.far - part.near) * t;
            self.u.size_of_terms(arm, delta.clamp(part.low, part.high))
        };
        let sizes = AT_TERMS.into_iter().map(size).collect::<Result<Vec<_>>>()?;
        Ok(OF_TERMS * sizes.into_iter().fold(0.0, f64::max))
    }

    fn fitted(&self, arm: &Arm, part: &Part) -> Result<Fitted> {
        let Part { near, far, before, halvings, heard, .. } = *part;
        let values = self.values(arm, part);
        let seen = self.u.seen_in_cell(arm, near, far);
        // That of x, as it may enter u.
        let rounded = (self.u.coordinate_if_seen(arm.anchor).abs() + far) / (far - near);
        let floor = (NEXT_TO * far / arm.length).max(NOTHING);
        let mut fitted = self.fit.of(values, &seen, rounded, floor)?;
        let rounding = self.rounding(arm, part)?;
        if rounding > FLOOR * fitted.piece.size() {
            // Digits have cancelled: values may be equal, or those of a staircase.
            fitted = fitted.beside(&seen);
            fitted.is_resolved |= fitted.off <= NOISY * rounding;
            fitted.off = fitted.off.max(rounding);
            if fitted.is_resolved {
                let allowed = fitted.allowed.max(NOISY * rounding);
                return Ok(Fitted { allowed, noise: Noise::known(rounding), ..fitted });
            }
        }
        // A search for edges takes more values, and finds them in noise.
        let is_small = halvings >= EXAMINED && fitted.off <= QUIET;
        if fitted.is_resolved || !is_small && fitted.off * BETTER < before {
            return Ok(fitted);
        }
        let fitted = fitted.beside(&seen);
        let noise = Noise::explaining(fitted.off, heard.max(rounding), values)?;
        if !noise.is_part_of_error {
            return Ok(Fitted { noise, ..fitted });
        }
        let allowed = fitted.allowed.max(fitted.off);
        Ok(Fitted { is_resolved: true, allowed, noise, ..fitted })
    }
}

impl Part {
    /// A part of a side between two distances.
    fn of(near: f64, far: f64) -> Self {
        Self { near, far, low: near, high: far, halvings: 0, before: f64::INFINITY, heard: 0.0 }
    }
}

impl Side {
    /// The value of the polynomial at distance δ.
    fn value(&self, arm: &Arm, delta: f64) -> f64 {
        let t = (delta - self.near) / (self.far - self.near);
        if t < AT_END {
            return if arm.sign > 0.0 { self.piece.left } else { self.piece.right };
        }
        self.piece.value(if arm.sign > 0.0 { t } else { 1.0 - t })
    }
}
