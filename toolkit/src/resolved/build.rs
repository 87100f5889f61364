//! The constructor: from a formula to cells.

use super::cells::{Cell, Place, Resolved};
use super::edges::{Edge, edge};
use super::fit::{DEGREE, Fit, Fitted};
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
        let mut before = 0.0;
        for (k, arm) in normal.arms().iter().enumerate() {
            let (mut side, is_open) = builder.side(arm, MOST.saturating_sub(cells.len()))?;
            let base = u.breaks()[arm.anchor];
            if is_open {
                open.push(base);
            }
            let slack = slack_of(&side[0], arm);
            join_along(&mut side, arm, normal.coordinate_if_seen(arm.anchor).abs());
            if arm.sign < 0.0 {
                side.reverse();
            }
            let first = cells.len();
            cells.extend(side.into_iter().map(|Side { near, far, piece, off, is_rough }| Cell {
                start: Place { base, offset: unit * if arm.sign > 0.0 { near } else { -far } },
                length: (far - near) * unit,
                piece: piece.scaled(size),
                off: size * off,
                is_rough,
            }));
            if k > 0 {
                join(&mut cells, first, k % 2 == 1, [size * before, size * slack]);
            }
            before = slack;
        }
        let end = Place::at(u.breaks()[u.breaks().len() - 1]);
        Ok(Self { cells, end, breaks: u.breaks().to_vec(), open })
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

/// Neighbouring cells of a side have the same value at their common end if the values differ by no more than the
/// rounding of x, `coordinate` of which enters u, moves them along the slopes of the cells nearby: a kink is located to
/// an ulp, and u is a staircase of ulps beside it. The value of the longer cell is taken; the difference is part of the
/// error of the other.
fn join_along(side: &mut [Side], arm: &Arm, coordinate: f64) {
    let outwards = arm.sign > 0.0;
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
        let blur = STAIRS * f64::EPSILON * (coordinate + inner.far);
        // A cell of a few ulps has no slope.
        let nearby = side[k.saturating_sub(NEARBY)..(k + NEARBY).min(side.len())].iter();
        let steep = nearby
            .filter(|cell| cell.far - cell.near > LONG * blur)
            .map(|cell| (cell.piece.right - cell.piece.left).abs() / (cell.far - cell.near))
            .fold(0.0, f64::max);
        let size = inner.piece.size().max(outer.piece.size());
        if apart > FLOOR * size + 2.0 * blur * steep {
            continue;
        }
        let is_inner_longer = inner.far - inner.near >= outer.far - outer.near;
        let (limit, other) = if is_inner_longer { (before, k) } else { (after, k - 1) };
        let cell = &mut side[other];
        cell.off += apart;
        // the end at which the other cell meets the longer one
        if is_inner_longer == outwards {
            cell.piece.left = limit;
        } else {
            cell.piece.right = limit;
        }
    }
}

/// A bound of the difference between the value at the breakpoint and the limit there.
fn slack_of(cell: &Side, arm: &Arm) -> f64 {
    let size = cell.piece.size();
    let slope = 2.0 * (DEGREE * DEGREE) as f64 * size / (cell.far - cell.near);
    FLOOR * size + slope * (arm.delta(arm.depth) + 16.0 * arm.blur)
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
        let (end, is_open) = loop {
            let is_last = 0.25 * far <= least;
            if is_last || count < FIRST || count % FIRST == 0 {
                let part = Part { near: 0.0, far, low: least, high: far, halvings: 0 };
                let Fitted { piece, off, is_resolved, allowed } = self.fitted(arm, &part)?;
                let cell = Side { near: 0.0, far, piece, off, is_rough: false };
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
            self.refine(arm, Part { near, far, low: near, high: far, halvings: 0 }, &mut cells)?;
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

    /// Divides a part until polynomials agree with u.
    fn refine(&self, arm: &Arm, part: Part, cells: &mut Vec<Side>) -> Result<()> {
        let coordinate = self.u.coordinate_if_seen(arm.anchor);
        let mut stack = vec![part];
        while let Some(part) = stack.pop() {
            let Part { near, far, low, high, halvings } = part;
            let fitted = self.fitted(arm, &part)?;
            let short = far - near <= 8.0 * f64::EPSILON * (far + coordinate.abs());
            if fitted.is_resolved || short || halvings == HALVINGS || cells.len() > MOST {
                let Fitted { piece, off, is_resolved, .. } = fitted;
                cells.push(Side { near, far, piece, off, is_rough: !is_resolved });
                continue;
            }
            let value = |delta: f64| self.u.evaluated(arm, delta);
            let same = |a: f64, b: f64| {
                a == b
                    || coordinate != 0.0 && coordinate + arm.sign * a == coordinate + arm.sign * b
            };
            let found = if halvings < EXAMINED { None } else { edge(low, high, &value, same)? };
            let halvings = halvings + 1;
            // A jump lies at the distance of the first value beyond it; nearer to the breakpoint u is not evaluated there.
            let [inner, outer] = match found {
                Some(Edge::Jump { below, above }) if above < far => [
                    Part { near, far: above, low, high: below, halvings },
                    Part { near: above, far, low: above, high, halvings },
                ],
                Some(Edge::Kink { at }) => [
                    Part { near, far: at, low, high: at, halvings },
                    Part { near: at, far, low: at, high, halvings },
                ],
                _ => {
                    let middle = 0.5 * (near + far);
                    [
                        Part { near, far: middle, low, high: middle, halvings },
                        Part { near: middle, far, low: middle, high, halvings },
                    ]
                }
            };
            // Nearest to the breakpoint on top.
            stack.extend([outer, inner]);
        }
        Ok(())
    }

    fn fitted(&self, arm: &Arm, part: &Part) -> Result<Fitted> {
        let Part { near, far, low, high, .. } = *part;
        let length = far - near;
        // Neighbouring cells have exactly the same value at their common end.
        let [first, last] = if arm.sign > 0.0 { [near, far] } else { [far, near] };
        let value = |t: f64| {
            let delta = match t {
                0.0 => first,
                1.0 => last,
                _ => first + arm.sign * length * t,
            };
            self.u.evaluated(arm, delta.clamp(low, high))
        };
        let seen = self.u.seen_in_cell(arm, near, far);
        // That of x, as it may enter u.
        let rounded = (self.u.coordinate_if_seen(arm.anchor).abs() + far) / length;
        self.fit.of(value, seen, rounded, (NEXT_TO * far / arm.length).max(NOTHING))
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
