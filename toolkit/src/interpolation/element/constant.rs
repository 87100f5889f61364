//! Best constants of Lemma 6.1, (6.1), on one element, from an eigenproblem for the slope.

use super::form::form;
use super::legendre::{converge, evaluate, odd_degrees, seminorm_gram};
use super::limits;
use crate::Order;
use crate::constant::{BestConstant, ErrorNorm, UnitOrder};
use crate::error::{Error, Result};
use crate::estimate::{Estimate, Tolerance};
use crate::numeric::pencil::Factored;
use nalgebra::DMatrix;

/// Largest order for which the constant of the limit ν → 0 is returned; the difference of the two constants is
/// less than the order.
const LIMIT: f64 = 1e-30;

/// The length of an element if it is admissible; its square plus 1 must be finite.
pub(in crate::interpolation) fn require_length(h: f64) -> Result<f64> {
    Error::require("element length h", h, "[1e-150, 1e150]", (1e-150..=1e150).contains(&h))
}

/// The power of the length of the element in a constant: h^s, times h for the L² norm.
pub(in crate::interpolation) fn scale(norm: ErrorNorm, s: f64, h: f64) -> f64 {
    h.powf(if norm == ErrorNorm::L2 { 1.0 + s } else { s })
}

/// The best constant of Lemma 6.1 on (0, h): h^{1+ν} C_L2(ν), h^ν C_H1(ν) = h^ν γ₁(ν) or h^ν C_1(ν, h).
///
/// # Errors
/// As [`crate::interpolation_constant`].
pub(in crate::interpolation) fn on_interval(
    h: f64,
    norm: ErrorNorm,
    s: UnitOrder,
    tolerance: Tolerance,
) -> Result<BestConstant> {
    require_length(h)?;
    let factor = scale(norm, s.value(), h);
    let found = match s {
        UnitOrder::Zero => BestConstant::exact(limits::zero(norm, h)?).times(factor)?,
        UnitOrder::One => BestConstant::exact(limits::one(norm, h)?).times(factor)?,
        UnitOrder::Inner(order) if order.value() < LIMIT => {
            let limit = limits::at_zero(norm, h)?;
            BestConstant::new(limit, limit, None).times(factor)?
        }
        UnitOrder::Inner(order) => {
            let found = extremal(norm, h, order, tolerance).map_err(|error| {
                error.carry("interpolation constant", |best| best.times(factor))
            })?;
            let constant = found.constant.times(factor)?;
            // |v(·/h)|_ν = h^{1/2−ν} |v|_ν
            let unit = h.powf(0.5 + order.value());
            BestConstant::new(constant, constant, None)
                .with_extremal(move |point| unit * found.at(point, h).1)
        }
    };
    Ok(found.with_others(move |norm| on_interval(h, norm, s, tolerance)))
}

/// The supremum of ‖v − v̄‖ / |v|_ν on (0, h), the constant for the derivative, with the extremal v.
///
/// # Errors
/// [`Error::ToleranceNotMet`].
pub(in crate::interpolation) fn of_mean(
    h: f64,
    order: Order,
    tolerance: Tolerance,
) -> Result<BestConstant> {
    if order.value() < LIMIT {
        return on_interval(h, ErrorNorm::Derivative, UnitOrder::Inner(order), tolerance);
    }
    let factor = h.powf(order.value());
    let found = extremal(ErrorNorm::Derivative, h, order, tolerance)
        .map_err(|error| error.carry("projection constant", |best| best.times(factor)))?;
    let constant = found.constant.times(factor)?;
    let unit = h.powf(order.value() - 0.5);
    Ok(BestConstant::new(constant, constant, None)
        .with_extremal(move |point| unit * found.at(point, h).0))
}

/// A constant with the slope that attains it, on the unit element.
#[derive(Debug, Clone)]
struct ElementExtremal {
    constant: Estimate,
    degrees: Vec<usize>,
    /// Coefficients in φ_k, scaled so that |v|_ν = 1.
    coefficients: Vec<f64>,
}

impl ElementExtremal {
    /// The extremal slope v and the error e = u − I u at x/h in [0, 1]; |v|_ν = 1, mean zero, v(1) > 0.
    fn at(&self, point: &[f64], h: f64) -> (f64, f64) {
        let t = point.first().map_or(f64::NAN, |x| x / h);
        let is_inside = (0.0..=1.0).contains(&t);
        if is_inside {
            evaluate(&self.degrees, &self.coefficients, t)
        } else {
            (f64::NAN, f64::NAN)
        }
    }
}

/// The best constant on the unit element with its extremal function, for ‖e'‖₀² + h² ‖e‖₀² in the full norm.
///
/// # Errors
/// [`Error::ToleranceNotMet`].
fn extremal(
    norm: ErrorNorm,
    h: f64,
    order: Order,
    tolerance: Tolerance,
) -> Result<ElementExtremal> {
    let mut last = None;
    let constant = converge("interpolation constant", tolerance, |count| {
        let degrees = odd_degrees(count);
        let (gram, mut work) = seminorm_gram(order, &degrees)?;
        let (top, vector) = Factored::new(&gram)?.largest_eigenvalue(&form(norm, h, &degrees)?)?;
        work.factorizations += 2;
        last = Some((normalised(&gram, &vector, &degrees), degrees));
        Ok((top.sqrt(), work))
    })?;
    let (coefficients, degrees) = last.unwrap_or_default();
    Ok(ElementExtremal { constant, degrees, coefficients })
}

/// The vector normalised such that |v|_ν = 1 and v(1) > 0.
fn normalised(gram: &DMatrix<f64>, vector: &[f64], degrees: &[usize]) -> Vec<f64> {
    let size = vector.len();
    let energy: f64 = (0..size)
        .map(|i| (0..size).map(|j| vector[i] * gram[(i, j)] * vector[j]).sum::<f64>())
        .sum();
    let at_end: f64 =
        degrees.iter().zip(vector).map(|(&k, c)| c * (2.0 * k as f64 + 1.0).sqrt()).sum();
    let scale = energy.sqrt().recip().copysign(at_end);
    vector.iter().map(|c| c * scale).collect()
}
