//! Best constants of Lemma 6.1, (6.1), on one element, by an eigenproblem for the slope.

use super::legendre::{converge, evaluate, odd_degrees, primitive_gram, seminorm_gram};
use crate::Order;
use crate::error::{Error, Given, Result};
use crate::estimate::{Estimate, Tolerance};
use crate::numeric::pencil::Factored;
use nalgebra::DMatrix;

/// Which norm of the interpolation error e = u − I u is bounded.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ErrorNorm {
    /// ‖e‖₀, first line of Lemma 6.1.
    L2,
    /// ‖e'‖₀, the second line without its lower order part.
    Derivative,
    /// ‖e‖₁ = (‖e‖₀² + ‖e'‖₀²)^{1/2}, the second line, on an element of length h.
    H1 {
        /// Length of the element.
        h: f64,
    },
}

impl ErrorNorm {
    /// The form whose quotient with |v|²_ν is maximised, on the unit element.
    pub(super) fn form(self, degrees: &[usize]) -> Result<DMatrix<f64>> {
        let mass = |i: usize, j: usize| if i == j { 1.0 } else { 0.0 };
        let size = degrees.len();
        Ok(match self {
            ErrorNorm::L2 => primitive_gram(degrees),
            ErrorNorm::Derivative => DMatrix::from_fn(size, size, mass),
            ErrorNorm::H1 { h } => {
                // h² must stay finite beside 1.
                Error::require("element length h", h, "(0, 1e150]", h > 0.0 && h <= 1e150)?;
                let primitive = primitive_gram(degrees);
                DMatrix::from_fn(size, size, |i, j| mass(i, j) + h * h * primitive[(i, j)])
            }
        })
    }
}

/// A best constant with the slope that attains it.
///
/// Returned by [`element_extremal`].
///
/// ```
/// use fractional_sobolev::interpolation::{ElementExtremal, ErrorNorm, element_extremal};
/// // where the worst function for ‖u − I u‖₀ is off most: in the middle of the element
/// let worst: ElementExtremal = element_extremal(ErrorNorm::L2, 0.5, 1e-6)?;
/// let errors = [0.25, 0.5, 0.75].map(|x| worst.error(x).map(f64::abs));
/// let [left, middle, right] = errors;
/// assert!(middle? > left?.max(right?) && worst.constant.value > 0.0);
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct ElementExtremal {
    /// The constant.
    pub constant: Estimate,
    degrees: Vec<usize>,
    /// Coefficients in φ_k, scaled so that |v|_ν = 1.
    coefficients: Vec<f64>,
}

impl ElementExtremal {
    /// The extremal slope v at x ∈ [0, 1]; |v|_ν = 1, mean zero, v(1) > 0.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] outside [0, 1].
    pub fn slope(&self, x: f64) -> Result<f64> {
        self.at(x).map(|(slope, _)| slope)
    }

    /// The interpolation error e = u − I u of the extremal function at x ∈ [0, 1].
    ///
    /// # Errors
    /// [`Error::OutOfRange`] outside [0, 1].
    pub fn error(&self, x: f64) -> Result<f64> {
        self.at(x).map(|(_, error)| error)
    }

    fn at(&self, x: f64) -> Result<(f64, f64)> {
        Error::require("x", x, "[0, 1]", (0.0..=1.0).contains(&x))?;
        Ok(evaluate(&self.degrees, &self.coefficients, x))
    }
}

/// The best constant of Lemma 6.1 in the given norm of the error: C_L2(ν), C_H1(ν) = γ₁(ν) or C_1(ν, h).
///
/// # Method
///
/// For u on (0, 1) with slope v, e = u − I u has e' = v − v̄ and e(0) = e(1) = 0. The best constants are
/// C_L2(ν) = sup ‖e‖₀/|v|_ν,  C_H1(ν) = sup ‖e'‖₀/|v|_ν = γ₁(ν),  and for the full norm on an element of
/// length h C_1(ν, h)² = sup (‖e'‖₀² + h² ‖e‖₀²)/|v|²_ν: then ‖u − I u‖\_{1,I} ≤ C_1(ν, h) h^ν |u|\_{1+ν,I},
/// sharp. C_1(ν, h) rises with h; [`longest_element`] finds the length up to which the printed constant 1
/// holds.
///
/// Both extremal slopes are odd about the centre, behave like a constant plus r^a at the ends, 2ν < a < 2ν +
/// 1, and are analytic inside: with K odd Legendre polynomials the constant is approached from below like
/// K^{-4(a+1/2−ν)}, measured K^{-5.6}: 1e-9 at K = 16, 1e-13 at K = 64. Cost O(K⁴).
///
/// ```
/// use fractional_sobolev::{Order, Tolerance, interpolation::{ErrorNorm, element_constant}};
/// let slope = element_constant(ErrorNorm::Derivative, Order::HALF, Tolerance::balanced())?;
/// assert!((slope.value - 0.291_564_029).abs() < 1e-8); // the paper's constant is 1
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
///
/// # Errors
/// [`Error::ToleranceNotMet`] when the tolerance cannot be reached; [`Error::OutOfRange`] for a bad length h.
#[doc(alias("interpolation error", "Lagrange interpolation", "Bramble-Hilbert"))]
pub fn element_constant(
    norm: ErrorNorm,
    order: impl Given<Order>,
    tolerance: impl Given<Tolerance>,
) -> Result<Estimate> {
    let (order, tolerance) = (order.given()?, tolerance.given()?);
    element_extremal(norm, order, tolerance).map(|extremal| extremal.constant)
}

/// The best constant with its extremal function.
///
/// ```
/// use fractional_sobolev::{Order, Tolerance, interpolation::{ErrorNorm, element_extremal}};
/// let found = element_extremal(ErrorNorm::Derivative, Order::HALF, Tolerance::balanced())?;
/// assert!((found.constant.value - 0.291_564_029).abs() < 1e-8);
/// assert!((found.slope(0.25)? + found.slope(0.75)?).abs() < 1e-8); // odd about the centre
/// assert!(found.error(0.0)?.abs() < 1e-12);
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
///
/// # Errors
/// As [`element_constant`].
pub fn element_extremal(
    norm: ErrorNorm,
    order: impl Given<Order>,
    tolerance: impl Given<Tolerance>,
) -> Result<ElementExtremal> {
    let (order, tolerance) = (order.given()?, tolerance.given()?);
    let mut last = None;
    let constant = converge("interpolation constant", tolerance, |count| {
        let degrees = odd_degrees(count);
        let (gram, mut work) = seminorm_gram(order, &degrees)?;
        let (top, vector) = Factored::new(&gram)?.largest_eigenvalue(&norm.form(&degrees)?)?;
        work.factorizations += 2;
        last = Some((normalised(&gram, &vector, &degrees), degrees));
        Ok((top.sqrt(), work))
    })?;
    let (coefficients, degrees) = last.unwrap_or_default();
    Ok(ElementExtremal { constant, degrees, coefficients })
}

/// The vector scaled to |v|_ν = 1 and v(1) > 0.
fn normalised(gram: &DMatrix<f64>, vector: &[f64], degrees: &[usize]) -> Vec<f64> {
    let size = vector.len();
    let energy: f64 =
        (0..size).map(|i| (0..size).map(|j| vector[i] * gram[(i, j)] * vector[j]).sum::<f64>()).sum();
    let at_end: f64 = degrees.iter().zip(vector).map(|(&k, c)| c * (2.0 * k as f64 + 1.0).sqrt()).sum();
    let scale = energy.sqrt().recip().copysign(at_end);
    vector.iter().map(|c| c * scale).collect()
}

/// The length h* up to which the second line of Lemma 6.1 holds with the printed constant 1: C_1(ν, h*) = 1.
///
/// C_1 rises with h and lies between h C_L2 and (C_H1² + h² C_L2²)^{1/2}, which brackets h*.
///
/// ```
/// use fractional_sobolev::{Order, Tolerance, interpolation::{ErrorNorm, element_constant, longest_element}};
/// let (order, asked) = (Order::HALF, Tolerance::balanced());
/// let h = longest_element(order, asked)?.value;
/// assert!((element_constant(ErrorNorm::H1 { h }, order, asked)?.value - 1.0).abs() < 1e-7);
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
///
/// # Errors
/// As [`element_constant`].
pub fn longest_element(order: impl Given<Order>, tolerance: impl Given<Tolerance>) -> Result<Estimate> {
    let (order, tolerance) = (order.given()?, tolerance.given()?);
    let l2 = element_constant(ErrorNorm::L2, order, tolerance)?;
    let derivative = element_constant(ErrorNorm::Derivative, order, tolerance)?.value;
    let mut work = l2.work;
    let mut low = (1.0 - derivative * derivative).sqrt() / l2.value;
    let mut high = 1.0 / l2.value;
    let wanted = 0.25 * tolerance.relative().max(8.0 * f64::EPSILON);
    while high - low > wanted * high {
        let h = 0.5 * (low + high);
        let full = element_constant(ErrorNorm::H1 { h }, order, tolerance)?;
        work += full.work;
        if full.value < 1.0 { low = h } else { high = h }
    }
    let value = 0.5 * (low + high);
    // dC_1/dh is at least about C_L2/2 there: the relative error of C_1 at most doubles.
    Estimate::new(value, 0.5 * (high - low) + 2.0 * l2.relative_error() * value, work)
}
