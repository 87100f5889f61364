//! Slopes with a closed-form or quadrature seminorm, and their interpolation errors on any element, without
//! cancellation.

use super::panels::{PanelRules, Squares, panel_squares, panels};
use crate::ErrorExt;
use fractional_sobolev::{Error, Given, Result};
use fractional_sobolev::{Estimate, Tolerance, Work};
use fractional_sobolev::{Function, Mesh, Order, closed_forms};
use std::f64::consts::PI;
use std::fmt;
use std::str::FromStr;

/// Degree of the polynomials that stand for a wave: four pieces per half wave leave 1e-13 of its seminorm.
const WAVE_DEGREE: usize = 9;

/// A slope on (0, 1) whose norms are known to rounding.
///
/// # Method
///
/// | slope v = u' on (0, 1) | in H^ν(0,1) for |
/// | --- | --- |
/// | x^a | ν < a + 1/2 |
/// | 0 below s, 1 above | ν < 1/2 |
/// | cos(kπx) | all ν |
/// | 1 | all ν; its ratios are 0/0 |
///
/// ‖v − v̄‖ and ‖∫(v − v̄)‖ on (a, b) are integrated in the difference v(x) − v(x₀), x₀ an end of the
/// element: powers by expm1, waves by the product of sines. Panels grow away from the singular point; 12
/// Gauss points on each leave 1e-16.
///
/// ```
/// use experiments::interpolation::{SampleSlope};
/// use fractional_sobolev::Order;
/// let slope: SampleSlope = SampleSlope::Power(1.0);
/// assert!(slope.value(0.25) == 0.25 && (slope.seminorm(Order::HALF)?.value - 1.0).abs() < 1e-12);
/// let rough = SampleSlope::barely_in(0.5)?; // x^{0.005}
/// assert!(rough.seminorm(Order::new(0.51)?).is_err());
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum SampleSlope {
    /// x^a, a > −1/2.
    Power(f64),
    /// 0 left of the point, 1 right of it.
    Step(f64),
    /// cos(kπx).
    Cosine(usize),
    /// 1: u is affine.
    Constant,
}

impl SampleSlope {
    /// x^a with a = r − 1/2 + [`SampleSlope::EDGE`]: in H^r(0,1), and in H^s for no s above r + EDGE.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless 0 ≤ r ≤ 10.
    pub fn barely_in(r: f64) -> Result<Self> {
        Error::require("r", r, "[0, 10]", (0.0..=10.0).contains(&r))?;
        Ok(SampleSlope::Power(r - 0.5 + Self::EDGE))
    }

    /// How far the power that is barely in H^r lies inside it: its own rates of approximation are off by as
    /// much.
    ///
    /// ```
    /// use experiments::interpolation::SampleSlope;
    /// assert_eq!(SampleSlope::barely_in(0.5)?, SampleSlope::Power(SampleSlope::EDGE));
    /// # Ok::<(), fractional_sobolev::Error>(())
    /// ```
    pub const EDGE: f64 = 0.005;

    /// |v|_ν on (0, 1).
    ///
    /// # Errors
    /// [`Error::InfiniteNorm`] outside the domain of the table above; [`Error::OutOfRange`] for parameters
    /// outside it.
    pub fn seminorm(self, order: impl Given<Order>) -> Result<Estimate> {
        let order = order.given()?;
        self.check()?;
        match self {
            SampleSlope::Power(a) => closed_forms::power_seminorm_squared(a, order)?.sqrt(),
            SampleSlope::Step(s) => closed_forms::jump_seminorm_squared(s, 1.0 - s, order)?.sqrt(),
            SampleSlope::Constant => Estimate::new(0.0, 0.0, Work::default()),
            SampleSlope::Cosine(k) => {
                let omega = PI * k as f64;
                let partition = Mesh::uniform(4 * k, 1.0)?;
                let wave = Function::interpolate(&partition, WAVE_DEGREE, |x| (omega * x).cos())?;
                wave.seminorm(order, Tolerance::new(1e-10)?)
            }
        }
    }

    /// v(x).
    pub fn value(self, x: f64) -> f64 {
        match self {
            SampleSlope::Power(a) => x.powf(a),
            SampleSlope::Step(s) => f64::from(x > s),
            SampleSlope::Cosine(k) => (PI * k as f64 * x).cos(),
            SampleSlope::Constant => 1.0,
        }
    }

    pub(in crate::interpolation) fn check(self) -> Result<()> {
        match self {
            SampleSlope::Power(a) => {
                Error::require("exponent a", a, "(-1/2, 1e4]", a > -0.5 && a <= 1e4)?;
            }
            SampleSlope::Step(s) => {
                Error::require("place of the step", s, "(0, 1)", s > 0.0 && s < 1.0)?;
            }
            SampleSlope::Cosine(k) if k == 0 || k > 64 => {
                return Err(Error::CountOutOfRange { name: "half waves", value: k, range: "1..=64" });
            }
            _ => {}
        }
        Ok(())
    }

    /// The squares on the element (left, left + h).
    pub(super) fn element_squares(self, left: f64, h: f64, rules: &PanelRules) -> Squares {
        match self {
            SampleSlope::Constant => Squares::default(),
            SampleSlope::Power(a) if left == 0.0 => {
                let (error, slope) = power_error_norms(a);
                let scale = h.powf(2.0 * a + 1.0);
                Squares { error: scale * h * h * error * error, slope: scale * slope * slope, points: 1 }
            }
            SampleSlope::Power(a) => {
                // From the right end: a tiny left end would make x^a huge there, for a < 0.
                let right = left + h;
                let difference = |d: f64| {
                    let ratio = (left + d) / right;
                    let log = if ratio > 0.5 { ((d - h) / right).ln_1p() } else { ratio.ln() };
                    right.powf(a) * (a * log).exp_m1()
                };
                panel_squares(&panels(h, |done| left + done), difference, rules.choose(h, left))
            }
            SampleSlope::Cosine(k) => {
                let omega = PI * k as f64;
                let panel = 0.5 / k as f64;
                let difference = |d: f64| -2.0 * (omega * (left + 0.5 * d)).sin() * (0.5 * omega * d).sin();
                panel_squares(&panels(h, |_| panel), difference, rules.choose(h, panel))
            }
            SampleSlope::Step(s) => {
                // v − v̄ takes the values −q and p on the parts p = (s − left)/h, q = 1 − p.
                let p = ((s - left) / h).clamp(0.0, 1.0);
                let q = 1.0 - p;
                Squares { error: (p * q).powi(2) / 3.0 * h.powi(3), slope: p * q * h, points: 1 }
            }
        }
    }

    /// (1/h) ∫ v (1−t) and (1/h) ∫ v t over the cell (left, left + h), t = (x − left)/h.
    pub(in crate::interpolation) fn cell_moments(self, left: f64, h: f64, rules: &PanelRules) -> [f64; 2] {
        match self {
            SampleSlope::Power(a) if left == 0.0 => {
                let falling = h.powf(a) / ((a + 1.0) * (a + 2.0));
                [falling, falling * (a + 1.0)]
            }
            SampleSlope::Step(s) => {
                let p = ((s - left) / h).clamp(0.0, 1.0);
                let q = 1.0 - p;
                [0.5 * q * q, 0.5 * q * (1.0 + p)]
            }
            SampleSlope::Constant => [0.5; 2],
            SampleSlope::Power(_) => self.panel_moments(&panels(h, |done| left + done), left, rules),
            SampleSlope::Cosine(k) => self.panel_moments(&panels(h, |_| 0.5 / k as f64), left, rules),
        }
    }

    fn panel_moments(self, panels: &[f64], left: f64, rules: &PanelRules) -> [f64; 2] {
        let h: f64 = panels.iter().sum();
        let (mut moments, mut start) = ([0.0; 2], 0.0);
        for &length in panels {
            for (t, w) in rules.long.iter() {
                let d = start + length * t;
                let value = length * w * self.value(left + d) / h;
                moments[0] += value * (1.0 - d / h);
                moments[1] += value * d / h;
            }
            start += length;
        }
        moments
    }
}

/// (‖e‖₀, ‖e'‖₀) on (0, 1) for u' = x^a.
pub(super) fn power_error_norms(a: f64) -> (f64, f64) {
    let next = a + 1.0;
    let derivative = a.abs() / next / (2.0 * a + 1.0).sqrt();
    let l2 = a.abs() / next * (2.0 / (3.0 * (2.0 * a + 3.0) * (a + 3.0))).sqrt();
    (l2, derivative)
}

impl fmt::Display for SampleSlope {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            SampleSlope::Power(a) => write!(f, "power:{a}"),
            SampleSlope::Step(s) => write!(f, "step:{s}"),
            SampleSlope::Cosine(k) => write!(f, "cosine:{k}"),
            SampleSlope::Constant => f.write_str("constant"),
        }
    }
}

impl FromStr for SampleSlope {
    type Err = Error;

    /// `power:A`, `step:S`, `cosine:K` or `constant`.
    fn from_str(text: &str) -> Result<Self> {
        let unknown = || Error::UnknownName {
            what: "function",
            given: text.to_owned(),
            expected: "power:A, step:S, cosine:K or constant",
        };
        let (name, parameter) = text.split_once(':').map_or((text, None), |(name, rest)| (name, Some(rest)));
        let number = || parameter.unwrap_or("").parse::<f64>().map_err(|_| unknown());
        let slope = match name {
            "power" => SampleSlope::Power(number()?),
            "step" => SampleSlope::Step(number()?),
            "cosine" => SampleSlope::Cosine(parameter.unwrap_or("").parse().map_err(|_| unknown())?),
            "constant" if parameter.is_none() => SampleSlope::Constant,
            _ => return Err(unknown()),
        };
        slope.check()?;
        Ok(slope)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn squares_agree_with_exact_integrals() {
        let rules = PanelRules::new().unwrap();
        // v = x on (a, a+h): ‖v − v̄‖² = h³/12, ‖∫‖² = h⁵/120.
        for (left, h) in [(1e-9, 1.0), (0.3, 1e-6), (1.0, 1.0), (1e-3, 0.5)] {
            let squares = SampleSlope::Power(1.0).element_squares(left, h, &rules);
            assert!((squares.slope / (h.powi(3) / 12.0) - 1.0).abs() < 1e-13, "{left} {h}: {squares:?}");
            assert!((squares.error / (h.powi(5) / 120.0) - 1.0).abs() < 1e-13, "{left} {h}: {squares:?}");
        }
        // A whole period of cos(2πx): mean zero, primitive sin(2πx)/(2π).
        let wave = SampleSlope::Cosine(2).element_squares(0.0, 1.0, &rules);
        assert!((wave.slope - 0.5).abs() < 1e-13);
        assert!((wave.error * 8.0 * PI * PI - 1.0).abs() < 1e-12);
        // From a tiny left end the element is the one at 0.
        for a in [-0.4, 0.3, 2.0] {
            let near = SampleSlope::Power(a).element_squares(1e-60, 1.0, &rules);
            let at = SampleSlope::Power(a).element_squares(0.0, 1.0, &rules);
            assert!((near.slope / at.slope - 1.0).abs() < 1e-10, "{a}: {near:?} {at:?}");
            assert!((near.error / at.error - 1.0).abs() < 1e-10, "{a}: {near:?} {at:?}");
        }
    }

    #[test]
    fn functions_are_read() {
        for text in ["power:0.3", "step:0.25", "cosine:3", "constant"] {
            assert_eq!(text.parse::<SampleSlope>().unwrap().to_string(), text);
        }
        for text in ["power", "power:x", "power:-0.5", "step:1", "cosine:0", "cosine:1000", "sine:1", ""] {
            assert!(text.parse::<SampleSlope>().is_err(), "{text}");
        }
    }
}
