//! All zeros of a factor in a strip: counts on bisected rectangles, then an iteration in double-double.
//!
//! A rectangle with one or two zeros is passed to the iteration, which must converge inside it to as many different
//! zeros as were counted; otherwise it is bisected. A cut through a zero is moved. f is real on the real axis: a
//! rectangle symmetric about it with one zero has a real zero. The iteration for two zeros starts from the parabola
//! at the centre; every step solves f + f′d + f″d²/2 = 0, which converges also for nearly double zeros. Two zeros may
//! be as close as 1e-8 for binary64 data; double-double arithmetic then still determines them to sixteen digits.

use super::count::{Rectangle, zeros};
use super::factor::Factor;
use crate::error::{Error, Result};
use crate::numeric::real::square_root;
use faer::c64;
use fractional_sobolev_numeric::transforms::Complex;
use qd::Quad;

type Wide = Complex<Quad>;

/// Largest number of steps; the order of convergence is three.
const STEPS: usize = 40;
/// Relative step below which the iteration ends.
const SETTLED: f64 = 1e-24;
/// Rounding error of a value in double-double, relative to its terms.
const ROUNDING: f64 = 1e-30;
/// Relative distance below which two zeros are identified.
pub(super) const SAME: f64 = 1e-12;
/// Positions of the cuts, as fractions of a side, tried in turn.
const CUTS: [f64; 7] = [0.5, 0.4427, 0.5719, 0.3819, 0.6283, 0.4781, 0.5347];
/// Widths added to the strip, tried in turn.
const MARGINS: [f64; 5] = [0.0618, 0.0472, 0.0831, 0.0293, 0.0127];
/// Smallest rectangle that is bisected.
const SMALLEST: f64 = 1e-10;

/// A zero with its multiplicity; a conjugate pair is represented by the member above the axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Zero {
    pub(super) place: c64,
    /// Bound of the absolute rounding error.
    pub(super) error: f64,
    pub(super) multiplicity: usize,
}

/// Number of zeros with left < Re λ < right; `None` if a zero is too close to one of the lines.
pub(super) fn count_in_strip(f: &Factor, left: f64, right: f64, points: &mut u64) -> Option<usize> {
    zeros(f, &strip(f, left, right), points)
}

fn strip(f: &Factor, left: f64, right: f64) -> Rectangle {
    let top = f.ceiling(left.abs().max(right.abs()));
    Rectangle { left, right, bottom: -top, top }
}

/// All zeros with 0 < Re λ < right, except those within 1e-12 of the ends.
pub(super) fn zeros_in_strip(f: &Factor, right: f64, points: &mut u64) -> Result<Vec<Zero>> {
    let start = MARGINS.iter().find_map(|margin| {
        let area = strip(f, -margin, right + margin);
        Some((area, zeros(f, &area, points)?))
    });
    let (area, count) = start.ok_or(lost())?;
    let mut found = Vec::new();
    search(f, area, count, points, &mut found)?;
    found.retain(|zero| zero.place.re > SAME && zero.place.re < right - SAME);
    Ok(found)
}

fn lost() -> Error {
    let why = "zeros are too close to each other or to the path of integration";
    Error::out_of_reach("zeros of a characteristic function", SAME, 1.0, why)
}

fn search(
    f: &Factor,
    area: Rectangle,
    count: usize,
    points: &mut u64,
    found: &mut Vec<Zero>,
) -> Result<()> {
    if count == 0 {
        return Ok(());
    }
    if count <= 2
        && let Some(mut zeros) = iterate(f, &area, count)
    {
        found.append(&mut zeros);
        return Ok(());
    }
    let width = area.right - area.left;
    let height = if area.is_symmetric() { area.top } else { area.top - area.bottom };
    if width.max(height) < SMALLEST {
        return Err(lost());
    }
    for cut in CUTS {
        let parts = if height > width { lying(area, cut) } else { standing(area, cut) };
        let counts: Option<Vec<usize>> = parts.iter().map(|part| zeros(f, part, points)).collect();
        let Some(counts) = counts else { continue };
        // Zeros below the axis are the reflections of those above.
        let is_mirrored = area.is_symmetric() && height > width;
        let total = counts[0] + counts[1] * if is_mirrored { 2 } else { 1 };
        if total != count {
            continue;
        }
        for (part, count) in parts.into_iter().zip(counts) {
            search(f, part, count, points, found)?;
        }
        return Ok(());
    }
    Err(lost())
}

/// Left and right part.
fn standing(area: Rectangle, cut: f64) -> [Rectangle; 2] {
    let middle = area.left + cut * (area.right - area.left);
    [Rectangle { right: middle, ..area }, Rectangle { left: middle, ..area }]
}

/// Lower and upper part; for a symmetric rectangle the middle part and the part above it.
fn lying(area: Rectangle, cut: f64) -> [Rectangle; 2] {
    let Rectangle { bottom, top, .. } = area;
    if area.is_symmetric() {
        let middle = cut * top;
        return [
            Rectangle { bottom: -middle, top: middle, ..area },
            Rectangle { bottom: middle, ..area },
        ];
    }
    let middle = bottom + cut * (top - bottom);
    [Rectangle { top: middle, ..area }, Rectangle { bottom: middle, ..area }]
}

/// The one or two zeros of a rectangle, if the iteration finds them all inside.
fn iterate(f: &Factor, area: &Rectangle, count: usize) -> Option<Vec<Zero>> {
    let center = area.center();
    let start = Complex::new(Quad::from(center.re), Quad::from(center.im));
    if count == 1 {
        let mut place = converge(f, start, area)?;
        if area.is_symmetric() {
            place.im = Quad::ZERO;
        }
        return Some(vec![zero(f, place, 1)]);
    }
    let [a, b] = parabola(f, start)?.map(|step| converge(f, start + step, area));
    let (a, b) = (a?, b?);
    let apart = narrow(a - b).norm();
    if apart <= SAME * narrow(a).norm() {
        // The same zero twice, unless the parabola at that point shows that it is double.
        let both = parabola(f, a)?.map(|step| narrow(step).norm());
        let is_double = both[0].max(both[1]) <= SAME * narrow(a).norm();
        return is_double.then(|| vec![zero(f, real_if(area, a), 2)]);
    }
    if !area.is_symmetric() {
        return Some(vec![zero(f, a, 1), zero(f, b, 1)]);
    }
    // Two zeros and their complex conjugates coincide as sets: both are real, or they are conjugates.
    let is_pair = (a.im - b.im).0.abs() > (a.re - b.re).0.abs();
    if is_pair {
        let upper = if a.im.0 > 0.0 { a } else { b };
        return Some(vec![zero(f, upper, 1)]);
    }
    Some(vec![zero(f, real_if(area, a), 1), zero(f, real_if(area, b), 1)])
}

fn real_if(area: &Rectangle, place: Wide) -> Wide {
    if area.is_symmetric() { Complex::new(place.re, Quad::ZERO) } else { place }
}

/// The two roots d of f + f′d + f″d²/2 = 0.
fn parabola(f: &Factor, at: Wide) -> Option<[Wide; 2]> {
    let [value, slope, bend] = f.values(at);
    let two = Complex::new(Quad::from(2.0), Quad::ZERO);
    let root = square_root(slope * slope - two * value * bend);
    let (plus, minus) = (slope + root, slope - root);
    let larger = if narrow(plus).norm() >= narrow(minus).norm() { plus } else { minus };
    if narrow(larger).norm() == 0.0 || narrow(bend).norm() == 0.0 {
        return None;
    }
    Some([-(two * value) / larger, -larger / bend])
}

/// Steps to the nearer root of the parabola until convergence; `None` if the limit is outside.
fn converge(f: &Factor, start: Wide, area: &Rectangle) -> Option<Wide> {
    let mut place = start;
    for _ in 0..STEPS {
        let [value, ..] = f.values(place);
        if narrow(value).norm() <= ROUNDING * f.terms(narrow(place)) {
            break;
        }
        let step = match parabola(f, place) {
            Some([near, _]) => near,
            None => -value / f.values(place)[1],
        };
        place += step;
        let size = narrow(step).norm();
        if !size.is_finite()
            || narrow(place - start).norm()
                > 4.0 * (area.top - area.bottom + area.right - area.left)
        {
            return None;
        }
        if size <= SETTLED * narrow(place).norm() {
            break;
        }
    }
    area.contains(narrow(place)).then_some(place)
}

/// The nearest binary64 numbers, with the error of the zero: its rounding error, and that of f divided by its
/// derivative, or the square root of that divided by the second derivative.
fn zero(f: &Factor, place: Wide, multiplicity: usize) -> Zero {
    let [_, slope, bend] = f.values(place).map(|value| narrow(value).norm());
    let at = narrow(place);
    let noise = ROUNDING * f.terms(at);
    let near = (noise / slope).min((2.0 * noise / bend).sqrt());
    Zero { place: at, error: f64::EPSILON * at.norm() + near, multiplicity }
}

fn narrow(z: Wide) -> c64 {
    c64::new(z.re.0, z.im.0)
}
