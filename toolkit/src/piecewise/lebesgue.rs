//! Means and L^q norms of piecewise polynomials.

use super::polynomial::{Piece, PiecewisePolynomial};
use crate::error::{Error, Result};
use crate::estimate::{Estimate, Tolerance, Work};
use crate::numeric::search::sign_change;
use crate::numeric::sum::RunningSum;
use crate::quadrature::Rule;
use crate::root::accept;

/// Largest number of bisections of one element.
const MAX_DEPTH: usize = 60;
/// Ratio of the values at the ends of a part to its bubbles above which |u|^q is smooth there.
const APART: f64 = 2.0;
/// Number of halvings after which a polynomial is expanded on the part.
const EXPANDED: usize = 12;
/// Number of points per degree between which extrema are sought.
const SAMPLES: usize = 12;
/// Rounding error of a compensated mean, relative to the mean of the sizes of the pieces.
const MEAN_ROUNDING: f64 = 8.0 * f64::EPSILON;

impl PiecewisePolynomial {
    /// The mean (1/|I|) ∫ u, exact to rounding relative to the size of u, so that it meets every tolerance.
    ///
    /// # Errors
    /// [`Error::NotFinite`] on overflow.
    pub(crate) fn mean(&self) -> Result<Estimate> {
        let rule = Rule::gauss_legendre(self.degree() + 1)?;
        let total = self.mesh().total();
        let (mut sum, mut absolute) = (RunningSum::default(), 0.0);
        for (piece, &h) in self.pieces().iter().zip(self.mesh().lengths()) {
            sum.add(h / total * rule.integrate(|t| piece.value(t)));
            absolute += h / total * piece.size();
        }
        Estimate::new(sum.value(), MEAN_ROUNDING * absolute, Work::default())
    }

    /// The norm ||u||\_{L^q} = (∫ |u|^q)^{1/q}, 1 ≤ q ≤ ∞, which is the maximum of |u| at q = ∞.
    ///
    /// # Method
    ///
    /// On an element of length h where u is linear from a to b, ∫ |u|^q = h (b|b|^q − a|a|^q) / ((q+1)(b−a)),
    /// evaluated with expm1 in terms of 1 − a/b if a and b have the same sign. Elements of higher degree are
    /// bisected between the zeros of u until a Gauss rule and its two halves agree; the zeros are enclosed by bisection
    /// until u is linear there. At q = ∞ the largest |u| is located, also in the
    /// interior of elements. Cost O(N).
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for q < 1 or NaN; [`Error::ToleranceNotMet`].
    pub(crate) fn lq_norm(&self, q: f64, tolerance: Tolerance) -> Result<Estimate> {
        Error::require("q", q, "[1, inf]", q >= 1.0)?;
        let peak = self.largest()?;
        if q == f64::INFINITY || peak.value == 0.0 {
            return accept(
                "L^inf norm",
                peak,
                tolerance,
                "rounding of the values limits the accuracy",
            );
        }
        let (scale, total) = (peak.value, self.mesh().total());
        let rule = Rule::gauss_legendre(12)?;
        let (mut sum, mut error, mut points) = (RunningSum::default(), 0.0, 0);
        for (piece, &h) in self.pieces().iter().zip(self.mesh().lengths()) {
            let weight = h / total;
            if piece.bubbles.is_empty() {
                sum.add(weight * linear_power(piece.left / scale, piece.right / scale, q));
            } else {
                // In its own unit: a long low element may contribute more than a short high one.
                let own = piece.size();
                if own == 0.0 {
                    continue;
                }
                let weight = weight * (own / scale).powf(q);
                let mut integral = PowerIntegral {
                    piece,
                    scale: own,
                    q,
                    rule: &rule,
                    tolerance,
                    error: 0.0,
                    points: 0,
                };
                sum.add(weight * integral.whole()?);
                error += weight * integral.error;
                points += integral.points;
            }
        }
        let root = sum.value().powf(1.0 / q);
        let value = scale * (total.powf(1.0 / q) * root);
        let relative = (error / sum.value() + 32.0 * f64::EPSILON) / q + 8.0 * f64::EPSILON;
        let work = Work { points, ..Work::default() };
        let why = "rounding, or the maximum number of bisections, limits the accuracy";
        accept("L^q norm", Estimate::new(value, value * relative, work)?, tolerance, why)
    }

    /// max |u|: exact at the ends of elements; in the interior of elements of higher degree by sampling between
    /// bounds of the derivative.
    fn largest(&self) -> Result<Estimate> {
        let mut largest = 0.0f64;
        let mut error = 0.0f64;
        for piece in self.pieces() {
            largest = largest.max(piece.left.abs()).max(piece.right.abs());
        }
        let inside = self.pieces().iter().filter(|piece| !piece.bubbles.is_empty());
        let mut bounds: Vec<(f64, &Piece)> = inside.map(|piece| (piece.size(), piece)).collect();
        bounds.sort_by(|a, b| b.0.total_cmp(&a.0));
        for (bound, piece) in bounds {
            // A piece is no larger than its bound, and all that follow have smaller ones.
            if bound <= largest {
                break;
            }
            let (value, uncertainty) = largest_inside(piece, largest);
            largest = largest.max(value);
            error = error.max(uncertainty);
        }
        Estimate::new(largest, error, Work::default())
    }
}

/// ∫₀¹ |a(1−t) + bt|^q dt for |a|, |b| ≤ 1.
fn linear_power(a: f64, b: f64, q: f64) -> f64 {
    if a * b <= 0.0 {
        let (a, b) = (a.abs(), b.abs());
        if a + b == 0.0 {
            return 0.0;
        }
        return (a.powf(q) * a + b.powf(q) * b) / ((q + 1.0) * (a + b));
    }
    let (small, large) = (a.abs().min(b.abs()), a.abs().max(b.abs()));
    // large^q (1 − r^{q+1}) / ((q+1)(1−r)) with r = small/large, by expm1 and log1p in 1 − r
    let gap = (large - small) / large;
    if gap == 0.0 {
        return large.powf(q);
    }
    large.powf(q) * -((q + 1.0) * (-gap).ln_1p()).exp_m1() / ((q + 1.0) * gap)
}

/// The adaptive integral ∫₀¹ |u/scale|^q of the local coordinate.
///
/// Where u vanishes |u|^q has a kink, and a Gauss rule and its two halves may agree by accident. They are compared only
/// between the zeros, which are enclosed first ([`around_zeros`]). Next to a zero u is linear up to its bubbles, whose
/// bound is that of the error of the closed form for linear u: ||a|^q − |b|^q| ≤ q max(|a|, |b|)^{q−1} |a − b|.
struct PowerIntegral<'a> {
    piece: &'a Piece,
    scale: f64,
    q: f64,
    rule: &'a Rule,
    tolerance: Tolerance,
    error: f64,
    points: u64,
}

impl PowerIntegral<'_> {
    fn whole(&mut self) -> Result<f64> {
        let mut enclosures = Vec::new();
        // Even powers are polynomials.
        if self.q % 2.0 != 0.0 {
            around_zeros(self.piece, self.scale, self.q, [0.0, 1.0], &mut enclosures)?;
        }
        let (mut sum, mut from) = (0.0, 0.0);
        for &Enclosure { start, end, value, error } in &enclosures {
            sum += self.between(from, start) + value;
            self.error += error;
            from = end;
        }
        Ok(sum + self.between(from, 1.0))
    }

    /// The integral over a part in which u has one sign.
    fn between(&mut self, from: f64, to: f64) -> f64 {
        if to <= from {
            return 0.0;
        }
        let whole = self.gauss(from, to - from);
        self.bisect(from, to - from, whole, MAX_DEPTH)
    }

    fn gauss(&mut self, start: f64, width: f64) -> f64 {
        self.points += self.rule.points().len() as u64;
        let value = |t: f64| (self.piece.value(start + width * t) / self.scale).abs().powf(self.q);
        width * self.rule.integrate(value)
    }

    fn bisect(&mut self, start: f64, width: f64, whole: f64, depth: usize) -> f64 {
        let half = 0.5 * width;
        let (left, right) = (self.gauss(start, half), self.gauss(start + half, half));
        let difference = (left + right - whole).abs();
        if difference <= 0.1 * self.tolerance.relative() * (left + right).max(1e-3 * width)
            || depth == 0
        {
            self.error += difference;
            return left + right;
        }
        self.bisect(start, half, left, depth - 1)
            + self.bisect(start + half, half, right, depth - 1)
    }
}

/// A part of an element in which u may vanish, and the integral of |u/scale|^q over it.
struct Enclosure {
    start: f64,
    end: f64,
    value: f64,
    error: f64,
}

/// Encloses the zeros of a polynomial on the part (from, to) of an element, from left to right: parts are bisected until u
/// has one sign or the error of the closed form for linear u is rounding.
///
/// By Legendre's equation |(t (1 − t) P_k(2t − 1))″| ≤ 2 + 2k(k+1). On a part of width w therefore u is linear up to
/// w²/8 Σ |c_k| (2 + 2k(k+1)), and on every part up to Σ |c_k|/4. After [`EXPANDED`] halvings the polynomial is expanded
/// on the part itself: where u is flat these coefficients are much smaller.
fn around_zeros(
    piece: &Piece,
    scale: f64,
    q: f64,
    [from, to]: [f64; 2],
    found: &mut Vec<Enclosure>,
) -> Result<()> {
    let weighted = |of: &dyn Fn(f64) -> f64| {
        let terms = piece.bubbles.iter().enumerate();
        terms.map(|(k, c)| c.abs() * of(k as f64)).sum::<f64>() / scale
    };
    let (most, bend) = (weighted(&|_| 0.25), weighted(&|k| 0.25 * (1.0 + k * (k + 1.0))));
    let mut stack = vec![([0.0, 1.0], [piece.left / scale, piece.right / scale], 0)];
    while let Some(([start, end], [a, b], halvings)) = stack.pop() {
        let width = end - start;
        let bubbles = most.min(bend * width * width);
        if a * b > 0.0 && a.abs().min(b.abs()) > APART * bubbles {
            continue;
        }
        let on_element = (to - from) * width;
        let largest = a.abs().max(b.abs()) + bubbles;
        let error = on_element * q * largest.powf(q - 1.0) * bubbles;
        let [first, last] = [start, end].map(|t| from + (to - from) * t);
        if error * (q + 1.0) <= f64::EPSILON {
            let value = on_element * linear_power(a, b, q);
            found.push(Enclosure { start: first, end: last, value, error });
        } else if halvings == EXPANDED {
            around_zeros(&piece.part(start, end)?, scale, q, [first, last], found)?;
        } else {
            let middle = start + 0.5 * width;
            let m = piece.value(middle) / scale;
            stack.push(([middle, end], [m, b], halvings + 1));
            stack.push(([start, middle], [a, m], halvings + 1));
        }
    }
    Ok(())
}

/// The maximum of |u| in the interior if it exceeds `known`, otherwise a smaller value, and its uncertainty: the zeros of
/// u' are located by sign changes on a fine grid and bisection.
///
/// A polynomial of degree n in t = (1 − cos φ)/2 is a cosine series of n terms. Its extrema are at least ~1/n apart in φ
/// unless they cancel. By Bernstein's inequality its second derivative in φ is at most n² max |u|: between grid points
/// at a distance d in φ, |u| exceeds the larger one of the values there by at most (dn)²/8 max |u|. Zeros are looked for
/// only where this may exceed the largest value on the grid.
fn largest_inside(piece: &Piece, known: f64) -> (f64, f64) {
    let degree = piece.bubbles.len() + 1;
    let samples = SAMPLES * degree;
    let place = |k: usize| (0.5 * std::f64::consts::PI * k as f64 / samples as f64).sin().powi(2);
    let places: Vec<f64> = (0..=samples).map(place).collect();
    let values: Vec<f64> = piece.values(&places).into_iter().map(f64::abs).collect();
    let mut largest = values.iter().copied().fold(0.0, f64::max);
    let between = (std::f64::consts::PI / SAMPLES as f64).powi(2) / 8.0 * piece.size();
    for (ends, values) in places.windows(2).zip(values.windows(2)) {
        if values[0].max(values[1]) + between <= largest.max(known) {
            continue;
        }
        let (rising, after) = (piece.slope(ends[0]), piece.slope(ends[1]));
        if rising * after < 0.0 {
            let turn = sign_change(ends[0], ends[1], 1e-9, |t| piece.slope(t) * rising <= 0.0).0;
            largest = largest.max(piece.value(turn).abs());
        }
    }
    // Near an extremum u is flat: 1e-9 in t is 1e-18 in u; what is left is rounding.
    (largest, 4.0 * f64::EPSILON * piece.size())
}
