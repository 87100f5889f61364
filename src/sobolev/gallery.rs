//! Functions whose norms are worth knowing, by name: `power:0.3`, `step:0.4`, `hat`, `log:0.25`, `samples:FILE`.
//!
//! All but samples live on (0, 1). |u|_ν is finite exactly for ν below the critical order: a + 1/2 for x^a, 1/2 for a step, 1 for the hat
//! (a kink is in H^{3/2−ε}), and up to 1/2 included for |ln x|^α, α < 1/2.

use super::closed_forms;
use super::functions::{Position, SingularFunction};
use super::order::FractionalOrder;
use super::partition::Partition;
use super::piecewise::PiecewisePolynomial;
use crate::error::{Error, Result};
use crate::estimate::{Estimate, Tolerance};
use std::fmt;
use std::path::PathBuf;
use std::str::FromStr;

/// A function by name.
#[derive(Debug, Clone, PartialEq)]
pub enum GalleryFunction {
    /// x^a.
    Power(f64),
    /// 0 left of the point, 1 right of it.
    Step(f64),
    /// 1 − |2x − 1|.
    Hat,
    /// |ln x|^α.
    Log(f64),
    /// The piecewise linear function through the rows (x, value) of a text file.
    Samples(PathBuf),
}

/// The names, for messages.
const EXPECTED: &str = "power:A, step:X with 0 < X < 1, hat, log:ALPHA with ALPHA > 0, or samples:FILE";

impl GalleryFunction {
    /// |u|_ν.
    ///
    /// # Errors
    /// [`Error::InfiniteNorm`] above the critical order, [`Error::ToleranceNotMet`], [`Error::File`].
    pub fn seminorm(&self, order: FractionalOrder, tolerance: Tolerance) -> Result<Estimate> {
        match self.sampled()? {
            Some(samples) => samples.seminorm(order, tolerance),
            None => self.closure()?.seminorm(order, tolerance),
        }
    }

    /// ||u||_ν.
    ///
    /// # Errors
    /// As [`GalleryFunction::seminorm`].
    pub fn norm(&self, order: FractionalOrder, tolerance: Tolerance) -> Result<Estimate> {
        match self.sampled()? {
            Some(samples) => samples.norm(order, tolerance),
            None => self.closure()?.norm(order, tolerance),
        }
    }

    /// |u|_ν in closed form, where one is known.
    ///
    /// # Errors
    /// [`Error::InfiniteNorm`] above the critical order.
    pub fn closed_form(&self, order: FractionalOrder) -> Result<Option<Estimate>> {
        let squared = match self {
            Self::Power(a) => closed_forms::power(*a, order)?,
            Self::Step(at) => closed_forms::jump(*at, 1.0 - at, order)?,
            Self::Hat => closed_forms::hat(0.0, 0.5, 0.5, 0.0, order)?,
            Self::Log(alpha) if order.offset() == 0.0 => closed_forms::log_power(*alpha)?,
            _ => return Ok(None),
        };
        squared.sqrt().map(Some)
    }

    /// The order from which the seminorm is infinite; `None` for samples, whose slopes alone are infinite at 3/2.
    pub fn critical_order(&self) -> Option<f64> {
        match self {
            // A polynomial is smooth; x^a with a > 1/2 outlives every ν < 1.
            Self::Power(a) => Some(if *a == 0.0 { 1.0 } else { (a + 0.5).min(1.0) }),
            Self::Step(_) | Self::Log(_) => Some(0.5),
            Self::Hat => Some(1.0),
            Self::Samples(_) => None,
        }
    }

    fn closure(&self) -> Result<SingularFunction<'_>> {
        match *self {
            Self::Power(a) => SingularFunction::from_positions(&[0.0, 1.0], move |at| match at.anchor() {
                0 => at.offset().powf(a),
                _ => (a * at.offset().ln_1p()).exp(),
            }),
            Self::Step(x) => SingularFunction::from_positions(&[0.0, x, 1.0], |at: Position| {
                let right = at.anchor() == 2 || at.anchor() == 1 && at.offset() > 0.0;
                f64::from(u8::from(right))
            }),
            Self::Hat => SingularFunction::from_positions(&[0.0, 0.5, 1.0], |at| match at.anchor() {
                1 => 1.0 - 2.0 * at.offset().abs(),
                _ => 2.0 * at.offset().abs(),
            }),
            Self::Log(alpha) => {
                SingularFunction::from_log_distances(&[0.0, 1.0], move |at| match at.anchor() {
                    0 => (-at.log_distance()).powf(alpha),
                    _ => (-at.offset().ln_1p()).powf(alpha),
                })
            }
            Self::Samples(_) => Err(unknown(&self.to_string())),
        }
    }

    fn sampled(&self) -> Result<Option<PiecewisePolynomial>> {
        let Self::Samples(path) = self else { return Ok(None) };
        let text = std::fs::read_to_string(path).map_err(|e| Error::file(path, e))?;
        let (mut nodes, mut values) = (Vec::new(), Vec::new());
        for (number, line) in text.lines().enumerate() {
            let line = line.trim();
            if line.is_empty() || line.starts_with('#') {
                continue;
            }
            let columns: Vec<f64> = line
                .split(|c: char| c.is_whitespace() || c == ',')
                .filter(|word| !word.is_empty())
                .map_while(|word| word.parse().ok())
                .collect();
            let [x, value] = columns[..] else {
                return Err(Error::file(path, format!("line {} is not two numbers: {line}", number + 1)));
            };
            nodes.push(x);
            values.push(value);
        }
        if nodes.len() < 2 {
            return Err(Error::file(path, "fewer than two rows of x, value"));
        }
        PiecewisePolynomial::linears(Partition::from_nodes(&nodes)?, &values).map(Some)
    }
}

impl fmt::Display for GalleryFunction {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Power(a) => write!(f, "power:{a}"),
            Self::Step(at) => write!(f, "step:{at}"),
            Self::Hat => write!(f, "hat"),
            Self::Log(alpha) => write!(f, "log:{alpha}"),
            Self::Samples(path) => write!(f, "samples:{}", path.display()),
        }
    }
}

fn unknown(text: &str) -> Error {
    Error::UnknownName { what: "function", given: text.to_owned(), expected: EXPECTED }
}

impl FromStr for GalleryFunction {
    type Err = Error;

    fn from_str(text: &str) -> Result<Self> {
        let (name, argument) = text.split_once(':').unwrap_or((text, ""));
        let number = argument.parse::<f64>().ok().filter(|value| value.is_finite());
        match (name, number) {
            ("power", Some(a)) if a <= 1e3 => Ok(Self::Power(a)),
            ("step", Some(at)) if at > 0.0 && at < 1.0 => Ok(Self::Step(at)),
            ("hat", _) if argument.is_empty() => Ok(Self::Hat),
            ("log", Some(alpha)) if alpha > 0.0 => Ok(Self::Log(alpha)),
            ("samples", _) if !argument.is_empty() => Ok(Self::Samples(argument.into())),
            _ => Err(unknown(text)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_read_and_written() {
        for name in ["power:-0.3", "step:0.4", "hat", "log:0.25", "samples:a/b.txt"] {
            let function: GalleryFunction = name.parse().unwrap();
            assert_eq!(function.to_string(), name);
        }
        for bad in ["power", "power:x", "step:1", "hat:3", "log:-1", "samples:", "sine", "power:nan"] {
            assert!(bad.parse::<GalleryFunction>().is_err(), "{bad}");
        }
    }
}
