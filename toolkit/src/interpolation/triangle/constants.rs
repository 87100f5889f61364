//! Lemma 6.1 on a triangle: sup ‖∇(u − Iu)‖₀/|∇u|_s and sup ‖u − Iu‖₀/|∇u|_s, I linear interpolation at the
//! corners.

use super::extremal::largest_quotient;
use super::shape::{TriangleShape, at_point};
use super::space::{Forms, Space};
use super::upper::bounds;
use crate::constant::{BestConstant, ErrorNorm, UnitOrder};
use crate::error::{Error, Result};
use crate::estimate::{Estimate, Tolerance, Work};
use crate::interpolation::element::{refused, scale};
use nalgebra::DMatrix;
use std::sync::Arc;

/// Powers r^μ with μ nearer to 1 or 2 than this are polynomials to almost all digits: μ is moved away (the
/// difference to a polynomial is then nearly that of r ln r or r² ln r).
const FROM_POLYNOMIALS: f64 = 0.004;
/// Angular polynomials of the powers.
const ANGULAR: usize = 8;
/// Successive degrees, from the second one for tolerances below [`COARSE`].
const DEGREES: [usize; 6] = [10, 14, 18, 22, 26, 30];
const COARSE: f64 = 1e-5;
/// The search ends at a degree whose error exceeds this share of the previous error.
const GAIN: f64 = 0.8;
/// Relative error of the extrapolated part, and of the value by quadrature.
const TRUST: f64 = 0.03;
const QUADRATURE: f64 = 3e-8;
/// Largest distance outside the triangle that rounding may cause.
const OUTSIDE: f64 = -1e-12;

const WHAT: &str = "interpolation constant of a triangle";

/// The best constant of a triangle, by rising degrees.
///
/// # Errors
/// As [`crate::interpolation_constant`].
pub(in crate::interpolation) fn on_triangle(
    corners: [[f64; 2]; 3],
    norm: ErrorNorm,
    s: UnitOrder,
    tolerance: Tolerance,
) -> Result<BestConstant> {
    let from = usize::from(tolerance.relative() < COARSE);
    refine(corners, norm, s, tolerance, &DEGREES[from..])
}

/// The first of some degrees that meets the tolerance.
fn refine(
    corners: [[f64; 2]; 3],
    norm: ErrorNorm,
    s: UnitOrder,
    tolerance: Tolerance,
    degrees: &[usize],
) -> Result<BestConstant> {
    let shape = TriangleShape::new(corners)?;
    let upper = upper(&shape.unit(), s)?;
    let mut best: Option<Estimate> = None;
    for (k, &degree) in degrees.iter().enumerate() {
        let matrices = Arc::new(Matrices::new(&shape, s, degree, upper)?);
        let found = matrices.constant(corners, norm)?;
        let constant = found.constant;
        if constant.relative_error() <= tolerance.relative() {
            let rest: Vec<usize> = degrees[k + 1..].to_vec();
            return Ok(found.with_others(move |norm| {
                let other = matrices.constant(corners, norm)?;
                if other.constant.relative_error() <= tolerance.relative() {
                    return Ok(other);
                }
                refine(corners, norm, s, tolerance, &rest).map_err(|error| {
                    if error.best().is_some() { error } else { missed(tolerance, other.constant) }
                })
            }));
        }
        let gained = best.is_none_or(|best| constant.error < GAIN * best.error);
        if best.is_none_or(|best| constant.error < best.error) {
            best = Some(constant);
        }
        if !gained || tolerance.relative() < QUADRATURE {
            break;
        }
    }
    Err(best.map_or_else(
        || Error::best_of(WHAT, tolerance.relative(), None, WHY),
        |best| missed(tolerance, best),
    ))
}

/// Upper bounds of both constants in units of the longest edge; for the gradient at s = 1 Kobayashi's.
fn upper(unit: &TriangleShape, s: UnitOrder) -> Result<[f64; 2]> {
    let s = s.value();
    Error::require("s", s, "[0.02, 1]", (0.02..=1.0).contains(&s))?;
    let [slope, l2] = bounds(unit, s)?;
    Ok([if s == 1.0 { kobayashi(unit) } else { slope }, l2])
}

const WHY: &str = "polynomials of degree 30 and the quadrature do not suffice";

fn missed(tolerance: Tolerance, best: Estimate) -> Error {
    Error::not_met(WHAT, tolerance.relative(), best, WHY)
}

/// The matrices of one triangle, order and degree, in units of the longest edge.
struct Matrices {
    shape: TriangleShape,
    s: f64,
    degree: usize,
    angular: usize,
    space: Arc<Space>,
    forms: Forms,
    /// Upper bounds of both constants.
    upper: [f64; 2],
}

impl Matrices {
    fn new(shape: &TriangleShape, s: UnitOrder, degree: usize, upper: [f64; 2]) -> Result<Self> {
        let unit = shape.unit();
        let with = |space: Space, forms, angular| Self {
            shape: *shape,
            s: s.value(),
            degree,
            angular,
            space: Arc::new(space),
            forms,
            upper,
        };
        match s {
            UnitOrder::Inner(order) if order.value() >= 0.02 => {
                let s = order.value();
                let is_near = (2.0 * s - 1.0).abs() < FROM_POLYNOMIALS;
                let power = if is_near {
                    1.0 + FROM_POLYNOMIALS
                } else {
                    (2.0 * s).min(2.0 - FROM_POLYNOMIALS)
                };
                let space = Space::new(unit, degree, power, ANGULAR);
                let forms = space.forms(order)?;
                Ok(with(space, forms, ANGULAR))
            }
            UnitOrder::One => {
                let space = Space::new(unit, degree, 2.0, 0);
                let forms = space.forms_at_one()?;
                Ok(with(space, forms, 0))
            }
            _ => Err(Error::OutOfRange { name: "s", value: s.value(), range: "[0.02, 1]" }),
        }
    }

    /// The constant in one norm.
    fn constant(&self, corners: [[f64; 2]; 3], norm: ErrorNorm) -> Result<BestConstant> {
        let size = self.shape.size();
        let [derivative, l2] = self.upper;
        let (form, upper) = match norm {
            ErrorNorm::Derivative => (self.forms.derivative.clone(), derivative),
            ErrorNorm::L2 => (self.forms.l2.clone(), l2),
            ErrorNorm::H1 => (
                &self.forms.derivative + &self.forms.l2 * (size * size),
                derivative.hypot(size * l2),
            ),
            ErrorNorm::Dual | ErrorNorm::At(_) => return Err(refused(norm)),
        };
        let found = settled(&self.space, &self.forms.seminorm, &form, self.degree, self.angular)?;
        let lower = Estimate::new(found.lower, QUADRATURE * found.lower, found.value.work)?;
        let upper = Estimate::new(upper, 0.0, found.value.work)?;
        let (space, coefficients) = (self.space.clone(), found.coefficients);
        // |∇u(·/h)|_s = h^{−s} |∇u|_s in the plane
        let unit = size.powf(self.s);
        let value = move |x: [f64; 2]| {
            let beta = at_point(&corners, x);
            if beta.iter().any(|&b| b.is_nan() || b < OUTSIDE) {
                return f64::NAN;
            }
            unit * space
                .errors(beta)
                .iter()
                .zip(&coefficients)
                .map(|(value, c)| value * c)
                .sum::<f64>()
        };
        BestConstant::new(found.value, lower, Some(upper))
            .with_extremal(move |point| point.first_chunk().map_or(f64::NAN, |&x| value(x)))
            .times(scale(norm, self.s, size))
    }
}

/// Lower bound, limit of the lower bounds, and coefficients of the function of the lower bound.
struct Settled {
    lower: f64,
    value: Estimate,
    coefficients: Vec<f64>,
}

/// The lower bounds of one constant, and their limit.
fn settled(
    space: &Space,
    seminorm: &DMatrix<f64>,
    form: &DMatrix<f64>,
    degree: usize,
    angular: usize,
) -> Result<Settled> {
    let degrees = space.degrees();
    let quotient = |p: usize, k: usize| -> Result<(f64, Vec<f64>)> {
        let is_kept = |&i: &usize| match degrees[i] {
            (degree, false) => (2..=p).contains(&degree),
            (angle, true) => angle < k,
        };
        let kept: Vec<usize> = (0..degrees.len()).filter(is_kept).collect();
        let (value, vector) = largest_quotient(seminorm, form, &kept)?;
        Ok((value.sqrt(), vector))
    };
    let mut levels = Vec::new();
    for back in (0..4).rev() {
        let p = degree - 2 * back;
        levels.push((p, quotient(p, angular)?.0));
    }
    let (lower, coefficients) = quotient(degree, angular)?;
    let direction = if angular == 0 { 0.0 } else { lower - quotient(degree, angular - 1)?.0 };
    let (before, value) = (limit(&levels[..3]), limit(&levels[1..]));
    let error = (value - before).abs()
        + TRUST * (value - lower)
        + 2.0 * direction.abs()
        + QUADRATURE * lower;
    let work = Work { points: degrees.len() as u64, ..Work::default() };
    Ok(Settled { lower, value: Estimate::new(value, error, work)?, coefficients })
}

/// The limit of three values c − C p^{-k}; the last value if they do not fit.
fn limit(levels: &[(usize, f64)]) -> f64 {
    let [(p, a), (q, b), (r, c)] = [0, 1, 2].map(|k| (levels[k].0 as f64, levels[k].1));
    let ratio = (c - b) / (b - a);
    let model = |k: f64| (q.powf(-k) - r.powf(-k)) / (p.powf(-k) - q.powf(-k));
    let (mut low, mut high) = (0.5, 20.0);
    if !(ratio < model(low) && ratio > model(high)) {
        return c;
    }
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if model(middle) > ratio { low = middle } else { high = middle }
    }
    c + (c - b) / ((r / q).powf(low) - 1.0)
}

/// Kobayashi's upper bound of sup ‖∇(u − Iu)‖₀/‖D²u‖₀, with the edges a, b, c and the area S: the root of
/// a²b²c²/(16S²) − (a²+b²+c²)/30 − (S²/5)(1/a² + 1/b² + 1/c²).
///
/// Source: Kobayashi, in Proc. Symp. RIMS 1733 (2011) 58-77; 0.4915960 for the right isosceles triangle with
/// legs 1, where Babuska and Aziz have 0.4929.
fn kobayashi(shape: &TriangleShape) -> f64 {
    let [f, t] = shape.frame(0);
    let squares = [f, t, [f[0] + t[0], f[1] + t[1]]].map(|e| e[0] * e[0] + e[1] * e[1]);
    let area = 0.25 * shape.twice() * shape.twice();
    let product: f64 = squares.iter().product();
    let (sum, over): (f64, f64) = (squares.iter().sum(), squares.iter().map(|x| x.recip()).sum());
    shape.size() * (product / (16.0 * area) - sum / 30.0 - area / 5.0 * over).sqrt()
}
