//! Jumps and kinks of a function inside a cell, located by bisection.
//!
//! A jump: of eight parts, and then of two halves at a time, the one with the larger difference of end values is kept.
//! The difference of a smooth function is halved in every step, that of a jump stays. It ends at two neighbouring
//! numbers.
//!
//! A kink: of three halves (left, middle, right) the one with the largest second difference is kept. It falls like h²
//! for a smooth function, like h for a kink. The lines through two points on either side of it meet in the kink, up to
//! O(h²); with them the interval is shortened by a factor of 8 at a time.

use crate::error::Result;

/// Steps after which the differences are compared.
const STEPS: [usize; 2] = [6, 12];
/// Parts of which the one with a jump is kept first: in an eighth a smooth part of the function varies less.
const PARTS: usize = 8;
/// Largest number of bisections.
const MOST: usize = 1100;
/// Ratio of differences six steps apart that a jump does not fall below.
const STAYS: f64 = 0.5;
/// Ratio of second differences four steps apart above which there is a kink: 1/16 for a kink, up to its position, 1/256
/// for a smooth function.
const BENDS: f64 = 1.0 / 40.0;
/// Steps of the search for a kink, after half of which the second difference is compared.
const TO_KINK: usize = 8;
/// Factor by which the interval of a kink is shortened, and the number of times.
const SHORTER: f64 = 0.125;
const TIMES: usize = 18;
/// Relative rounding error of a difference, with a margin.
const NOISE: f64 = 1e3 * f64::EPSILON;

/// A place where a function is not smooth.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Edge {
    /// between two neighbouring numbers
    Jump {
        below: f64,
        above: f64,
    },
    Kink {
        at: f64,
    },
}

/// The jump or kink of u between `near` and `far`, if there is one that stands out; `same` is true for two numbers
/// between which there is none.
pub(super) fn edge(
    near: f64,
    far: f64,
    u: &impl Fn(f64) -> Result<f64>,
    same: impl Fn(f64, f64) -> bool,
) -> Result<Option<Edge>> {
    match jump(near, far, u, &same)? {
        Some(found) => Ok(Some(found)),
        None => kink(near, far, u, &same),
    }
}

fn jump(
    near: f64,
    far: f64,
    u: &impl Fn(f64) -> Result<f64>,
    same: &impl Fn(f64, f64) -> bool,
) -> Result<Option<Edge>> {
    let part = (far - near) / PARTS as f64;
    let place = |k: usize| if k == PARTS { far } else { near + part * k as f64 };
    let points: Vec<(f64, f64)> =
        (0..=PARTS).map(|k| Ok((place(k), u(place(k))?))).collect::<Result<_>>()?;
    let apart = |a: (f64, f64), b: (f64, f64)| (b.1 - a.1).abs();
    let largest = points.windows(2).max_by(|p, q| apart(p[0], p[1]).total_cmp(&apart(q[0], q[1])));
    let Some(&[mut a, mut b]) = largest else { return Ok(None) };
    let (mut before, mut size) = (f64::INFINITY, 0.0_f64);
    for step in 0..MOST {
        let middle = 0.5 * (a.0 + b.0);
        if same(a.0, middle) || same(middle, b.0) {
            break;
        }
        let m = (middle, u(middle)?);
        size = size.max(m.1.abs());
        if apart(a, m) >= apart(m, b) {
            b = m
        } else {
            a = m
        }
        if step + 1 == STEPS[0] {
            before = apart(a, b);
        }
        if step + 1 >= STEPS[1] && apart(a, b) < STAYS * before {
            return Ok(None);
        }
    }
    let found = apart(a, b) >= STAYS * before && apart(a, b) > NOISE * size;
    Ok(found.then_some(Edge::Jump { below: a.0, above: b.0 }))
}

fn kink(
    near: f64,
    far: f64,
    u: &impl Fn(f64) -> Result<f64>,
    same: &impl Fn(f64, f64) -> bool,
) -> Result<Option<Edge>> {
    let middle = 0.5 * (near + far);
    let mut points = [(near, u(near)?), (middle, u(middle)?), (far, u(far)?)];
    let second = |[a, m, b]: [(f64, f64); 3]| ((a.1 - m.1) + (b.1 - m.1)).abs();
    let mut before = f64::INFINITY;
    for step in 0..TO_KINK {
        let [a, m, b] = points;
        let (left, right) = (0.5 * (a.0 + m.0), 0.5 * (m.0 + b.0));
        if same(a.0, left) || same(right, b.0) {
            return Ok(None);
        }
        let (left, right) = ((left, u(left)?), (right, u(right)?));
        let thirds = [[a, left, m], [left, m, right], [m, right, b]];
        points =
            thirds.into_iter().max_by(|p, q| second(*p).total_cmp(&second(*q))).unwrap_or(points);
        if step + 1 == TO_KINK / 2 {
            before = second(points);
        }
    }
    let [a, m, b] = points;
    let size = a.1.abs().max(b.1.abs());
    if second(points) < BENDS * before || second(points) <= NOISE * size {
        return Ok(None);
    }
    let (mut centre, mut reach) = (m.0, 0.5 * (b.0 - a.0));
    for _ in 0..TIMES {
        let [p, q] = [centre - reach, centre - 0.5 * reach].map(|x| (x, u(x)));
        let [r, s] = [centre + 0.5 * reach, centre + reach].map(|x| (x, u(x)));
        let slope = 0.5 * reach;
        let (p, q, r, s) = (p.1?, (q.0, q.1?), (r.0, r.1?), s.1?);
        let [before, after] = [(q.1 - p) / slope, (s - r.1) / slope];
        // q + before (x − x_q) = r + after (x − x_r), from the centre
        let meets = (r.1 - q.1 - after * 0.5 * reach - before * 0.5 * reach) / (before - after);
        if meets.is_nan() || meets.abs() > reach {
            break;
        }
        centre += meets;
        reach *= SHORTER;
        if same(centre - 0.5 * reach, centre) {
            break;
        }
    }
    let inside = centre > near && centre < far && !same(near, centre) && !same(centre, far);
    Ok(inside.then_some(Edge::Kink { at: centre }))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn found(f: impl Fn(f64) -> f64) -> Option<Edge> {
        edge(0.25, 0.5, &|x| Ok(f(x)), |a, b| a == b).unwrap()
    }

    #[test]
    fn jumps_and_kinks_are_found_to_an_ulp() {
        let c = 0.3217;
        let step = found(|x| (9.0 * x).sin() + if x > c { 1.0 } else { 0.0 });
        let Some(Edge::Jump { below, above }) = step else { panic!("{step:?}") };
        assert!(below <= c && c <= above && above - below <= f64::EPSILON, "{below} {above}");
        for bend in [|x: f64| x.abs(), |x: f64| x.max(0.0) + (3.0 * x).exp()] {
            let found = found(|x| bend(x - c));
            let Some(Edge::Kink { at }) = found else { panic!("{found:?}") };
            assert!((at - c).abs() <= 4.0 * f64::EPSILON, "{at}");
        }
    }

    #[test]
    fn smooth_functions_have_none() {
        for k in 1..40 {
            let k = f64::from(k);
            assert_eq!(found(|x| (k * x).sin()), None, "{k}");
            assert_eq!(found(|x| (-(k * (x - 0.4)).powi(2)).exp()), None, "{k}");
        }
        assert_eq!(found(|_| 1.0), None);
    }
}
