//! Lemma 6.1 on a triangle: sup ‖∇(u − Iu)‖₀/|∇u|_s and sup ‖u − Iu‖₀/|∇u|_s, I linear interpolation at the
//! corners.

use super::extremal::{TriangleExtremal, largest_quotient};
use super::shape::TriangleShape;
use super::space::{Forms, Space};
use super::upper::bounds;
use crate::Order;
use crate::error::{Error, Given, Result};
use crate::estimate::{Estimate, Work};
use nalgebra::DMatrix;
use std::sync::Arc;

/// Powers r^μ with μ nearer to 1 or 2 than this would be polynomials to too many digits: μ is moved away (the
/// difference to a polynomial is then nearly that of r ln r or r² ln r).
const FROM_POLYNOMIALS: f64 = 0.004;
/// Angular polynomials of the powers.
const ANGULAR: usize = 8;
/// Degrees that are admissible.
const DEGREES: std::ops::RangeInclusive<usize> = 10..=30;
/// Part of what was extrapolated that may be wrong, and of the value by quadrature.
const TRUST: f64 = 0.03;
const QUADRATURE: f64 = 3e-8;

/// A best constant from below, extrapolated, and from above.
///
/// Returned by [`TriangleConstants`].
///
/// ```
/// use fractional_sobolev::interpolation::{TriangleConstant, TriangleConstants, TriangleShape};
/// let found = TriangleConstants::new(&TriangleShape::right_isosceles()?, 0.5, 10)?;
/// let TriangleConstant { lower, value, upper, levels, .. } = found.l2;
/// // the bounds of rising degrees climb to the value
/// assert!(levels.windows(2).all(|pair| pair[0].1 <= pair[1].1));
/// assert!(lower <= value.value + value.error && upper.is_some_and(|upper| value.value <= upper));
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct TriangleConstant {
    /// Quotient of a function: a lower bound up to quadrature.
    pub lower: f64,
    /// The limit of the lower bounds, with its error.
    pub value: Estimate,
    /// An upper bound; `None` at s = 1, see [`kobayashi`].
    pub upper: Option<f64>,
    /// Degree and lower bound of each space.
    pub levels: Vec<(usize, f64)>,
    /// The function of the lower bound.
    pub extremal: TriangleExtremal,
}

/// Both constants of one triangle and one order.
///
/// # Method
///
/// |∇u|_s² = ∫∫|∇u(x) − ∇u(y)|²/|x−y|^{2+2s}, 0 < s < 1; at s = 1 the norm ‖D²u‖₀, to which ((1−s) 2/π)^{1/2}
/// |∇u|_s tends. A trial space (`space`) gives a lower bound: a generalised eigenvalue problem. The
/// bounds of degrees p, p − 2, ... settle like p^{-k}, with k from three of them: the limit so found is the
/// value, and its error is what that limit changed by from p − 2 to p, a part of the distance from the bound,
/// and what the last direction of the powers still gave. `upper` is an upper bound.
#[derive(Debug, Clone)]
pub struct TriangleConstants {
    /// ‖∇(u − Iu)‖₀ over |∇u|_s; scales like (size)^s.
    pub derivative: TriangleConstant,
    /// ‖u − Iu‖₀ over |∇u|_s; scales like (size)^{1+s}.
    pub l2: TriangleConstant,
}

impl TriangleConstants {
    /// For an order s < 1, with polynomials up to a degree.
    ///
    /// ```
    /// use fractional_sobolev::{Order, interpolation::{TriangleConstants, TriangleShape}};
    /// let shape = TriangleShape::right_isosceles()?;
    /// let found = TriangleConstants::new(&shape, Order::new(0.75)?, 10)?;
    /// assert!((found.derivative.value.value - 0.262_185_14).abs() < 1e-7);
    /// assert!(found.derivative.upper > Some(found.derivative.lower));
    /// # Ok::<(), fractional_sobolev::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for an order below 0.02, [`Error::CountOutOfRange`] for a degree outside 10 ...
    /// 30.
    pub fn new(shape: &TriangleShape, order: impl Given<Order>, degree: usize) -> Result<Self> {
        let order = order.given()?;
        let s = Error::require("s", order.value(), "[0.02, 1)", order.value() >= 0.02)?;
        require_degree(degree)?;
        let unit = shape.unit();
        let is_near = (2.0 * s - 1.0).abs() < FROM_POLYNOMIALS;
        let power = if is_near { 1.0 + FROM_POLYNOMIALS } else { (2.0 * s).min(2.0 - FROM_POLYNOMIALS) };
        let space = Space::new(unit, degree, power, ANGULAR);
        let forms = space.forms(order)?;
        Self::of(space, &forms, degree, ANGULAR)?.scaled(shape, s, Some(bounds(&unit, order)?))
    }

    /// For s = 1, with ‖D²u‖₀ below.
    ///
    /// # Errors
    /// As [`TriangleConstants::new`].
    pub fn at_one(shape: &TriangleShape, degree: usize) -> Result<Self> {
        require_degree(degree)?;
        let space = Space::new(shape.unit(), degree, 2.0, 0);
        let forms = space.forms_at_one()?;
        Self::of(space, &forms, degree, 0)?.scaled(shape, 1.0, None)
    }

    fn of(space: Space, forms: &Forms, degree: usize, angular: usize) -> Result<Self> {
        let space = Arc::new(space);
        let one = |form: &DMatrix<f64>| settled(&space, &forms.seminorm, form, degree, angular);
        Ok(Self { derivative: one(&forms.derivative)?, l2: one(&forms.l2)? })
    }

    fn scaled(mut self, shape: &TriangleShape, s: f64, upper: Option<[f64; 2]>) -> Result<Self> {
        for (k, constant) in [&mut self.derivative, &mut self.l2].into_iter().enumerate() {
            let factor = shape.size().powf(s + k as f64);
            constant.lower *= factor;
            constant.value = constant.value.times(factor)?;
            constant.upper = upper.map(|bounds| bounds[k] * factor);
            constant.levels.iter_mut().for_each(|level| level.1 *= factor);
        }
        Ok(self)
    }
}

fn require_degree(degree: usize) -> Result<()> {
    if DEGREES.contains(&degree) {
        return Ok(());
    }
    Err(Error::CountOutOfRange { name: "degree", value: degree, range: "10 <= p <= 30" })
}

/// All lower bounds of one constant, and their limit.
fn settled(
    space: &Arc<Space>,
    seminorm: &DMatrix<f64>,
    form: &DMatrix<f64>,
    degree: usize,
    angular: usize,
) -> Result<TriangleConstant> {
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
    let error = (value - before).abs() + TRUST * (value - lower) + 2.0 * direction.abs() + QUADRATURE * lower;
    let work = Work { points: degrees.len() as u64, ..Work::default() };
    Ok(TriangleConstant {
        lower,
        value: Estimate::new(value, error, work)?,
        upper: None,
        levels,
        extremal: TriangleExtremal { space: space.clone(), coefficients },
    })
}

/// The limit of three values c − C p^{-k}; the last value where they do not look like that.
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
///
/// ```
/// use fractional_sobolev::interpolation::{TriangleConstants, TriangleExtremal, TriangleShape, kobayashi};
/// let shape = TriangleShape::right_isosceles()?;
/// let best = TriangleConstants::at_one(&shape, 10)?.derivative;
/// assert!((kobayashi(&shape) - 0.491_596_0).abs() < 1e-7 && best.lower < kobayashi(&shape));
/// let extremal: &TriangleExtremal = &best.extremal;
/// assert!(extremal.value([1.0, 0.0, 0.0]).abs() < 1e-9); // zero at the corners
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
pub fn kobayashi(shape: &TriangleShape) -> f64 {
    let [f, t] = shape.frame(0);
    let squares = [f, t, [f[0] + t[0], f[1] + t[1]]].map(|e| e[0] * e[0] + e[1] * e[1]);
    let area = 0.25 * shape.twice() * shape.twice();
    let product: f64 = squares.iter().product();
    let (sum, over): (f64, f64) = (squares.iter().sum(), squares.iter().map(|x| x.recip()).sum());
    shape.size() * (product / (16.0 * area) - sum / 30.0 - area / 5.0 * over).sqrt()
}
