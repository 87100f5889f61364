//! Functions of the gallery, ready to be measured.

use super::functions::{Position, SingularFunction};
use super::order::FractionalOrder;
use super::partition::Partition;
use super::piecewise::PiecewisePolynomial;
use crate::error::{Error, Result};
use crate::estimate::{Estimate, Tolerance};
use crate::numeric::text::{pairs, read_text};
use std::path::Path;

/// What measures it.
pub(super) enum Evaluated<'a> {
    /// x^a by a and (x^a − 1)/a.
    NearlyOne(f64, SingularFunction<'a>),
    Closure(SingularFunction<'a>),
    Samples(PiecewisePolynomial),
}

impl<'a> Evaluated<'a> {
    /// x^a.
    pub(super) fn power(a: f64) -> Result<Self> {
        if a != 0.0 && a.abs() < NEARLY_NONE {
            Ok(Self::NearlyOne(a, slope_of_power(a)?))
        } else {
            power(a).map(Self::Closure)
        }
    }

    pub(super) fn seminorm(&self, order: FractionalOrder, tolerance: Tolerance) -> Result<Estimate> {
        match self {
            Self::Samples(u) => u.seminorm(order, tolerance),
            Self::Closure(u) => u.seminorm(order, tolerance),
            Self::NearlyOne(a, slope) => {
                let found = match slope.seminorm(order, tolerance) {
                    Err(Error::InfiniteNorm { .. }) if *a > order.offset() => {
                        return Err(Error::out_of_reach(
                            "seminorm",
                            tolerance.relative(),
                            f64::INFINITY,
                            "x^a with so small an a decays where no number of binary64 has its logarithm",
                        ));
                    }
                    found => found?.times(a.abs())?,
                };
                // What is subnormal is rounded.
                Estimate::new(found.value, found.error + f64::MIN_POSITIVE * f64::EPSILON, found.work)
            }
        }
    }

    pub(super) fn norm(&self, order: FractionalOrder, tolerance: Tolerance) -> Result<Estimate> {
        match self {
            Self::Samples(u) => u.norm(order, tolerance),
            Self::Closure(u) => u.norm(order, tolerance),
            Self::NearlyOne(a, _) => {
                let seminorm = self.seminorm(order, tolerance)?;
                // ∫ x^{2a} = 1/(1 + 2a)
                let norm = (1.0 / (1.0 + 2.0 * a) + seminorm.value.powi(2)).sqrt();
                let error = seminorm.error * (seminorm.value + seminorm.error).min(norm) / norm;
                Estimate::new(norm, error + 2.0 * f64::EPSILON * norm, seminorm.work)
            }
        }
    }
}

/// From |a| = 1/256 down x^a is measured by its distance from one: next to one its values lose digits.
const NEARLY_NONE: f64 = 1.0 / 256.0;

/// As it is written, whatever a.
pub(super) fn power(a: f64) -> Result<SingularFunction<'static>> {
    SingularFunction::from_positions(&[0.0, 1.0], move |at| match at.anchor() {
        0 => at.offset().powf(a),
        _ => (a * at.offset().ln_1p()).exp(),
    })
}

/// (x^a − 1)/a, ln x at a → 0; for a > 0 of a singularity so weak that what lies below 1e-300 counts at
/// ν = 1/2.
fn slope_of_power(a: f64) -> Result<SingularFunction<'static>> {
    // Where a ln x is next to nothing a division would cost digits.
    let slope = move |log: f64| if (a * log).abs() < 1e-17 { log } else { (a * log).exp_m1() / a };
    let ends = &[0.0, 1.0];
    if a > 0.0 {
        SingularFunction::from_log_distances(ends, move |at| {
            slope(if at.anchor() == 0 { at.log_distance() } else { at.offset().ln_1p() })
        })
    } else {
        SingularFunction::from_positions(ends, move |at| {
            slope(if at.anchor() == 0 { at.offset().ln() } else { at.offset().ln_1p() })
        })
    }
}

/// 0 left of x, 1 right of it.
pub(super) fn step(x: f64) -> Result<SingularFunction<'static>> {
    SingularFunction::from_positions(&[0.0, x, 1.0], |at: Position| {
        let right = at.anchor() == 2 || at.anchor() == 1 && at.offset() > 0.0;
        f64::from(u8::from(right))
    })
}

/// 1 − |2x − 1|.
pub(super) fn hat() -> Result<SingularFunction<'static>> {
    SingularFunction::from_positions(&[0.0, 0.5, 1.0], |at| match at.anchor() {
        1 => 1.0 - 2.0 * at.offset().abs(),
        _ => 2.0 * at.offset().abs(),
    })
}

/// |ln x|^α.
pub(super) fn log(alpha: f64) -> Result<SingularFunction<'static>> {
    SingularFunction::from_log_distances(&[0.0, 1.0], move |at| match at.anchor() {
        0 => (-at.log_distance()).powf(alpha),
        // The distance to 1 is −ln x; at small α its power is far from 0 where it underflows.
        _ if at.log_distance() < -46.0 => (alpha * at.log_distance()).exp(),
        _ => (-at.offset().ln_1p()).powf(alpha),
    })
}

/// The piecewise linear function through the rows (x, value) of a file.
pub(super) fn read_samples(path: &Path) -> Result<PiecewisePolynomial> {
    let rows = pairs(&read_text(path)?, "samples").map_err(|fault| Error::file(path, fault))?;
    if rows.len() < 2 {
        return Err(Error::file(path, "fewer than two rows of x, value"));
    }
    if let Some([_, (line, _)]) = rows.array_windows().find(|[(_, left), (_, right)]| left[0] >= right[0]) {
        return Err(Error::file(path, format!("line {line}: x is not above that of the line before")));
    }
    let (nodes, values): (Vec<f64>, Vec<f64>) = rows.iter().map(|&(_, [x, value])| (x, value)).unzip();
    PiecewisePolynomial::linears(Partition::from_nodes(&nodes)?, &values)
}
