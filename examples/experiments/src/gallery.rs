//! Functions by name for `section_1_fractional_norms` and its page: `power:0.3`, `step:0.4`, `hat`, `log:0.25`,
//! `samples:FILE`.

use fractional_sobolev::{Estimate, Function, Given, Mesh, Order, Position, Tolerance, closed_forms};
use signorini::{Error, Result, ToolkitError, read_pairs};
use std::fmt;
use std::path::{Path, PathBuf};
use std::str::FromStr;

/// A function by name.
///
/// # Method
///
/// All but samples live on (0, 1). Where |u|_ν is finite, [`GalleryFunction::is_in`] says.
///
/// ```
/// use experiments::gallery::GalleryFunction;
/// use fractional_sobolev::Order;
/// let root: GalleryFunction = "power:0.5".parse()?;
/// let exact = root.closed_form(0.25)?.map(|e| e.value).unwrap_or(f64::NAN);
/// assert!((root.function()?.seminorm(0.25, 1e-8)?.value / exact - 1.0).abs() < 1e-8);
/// // a step is in H^ν for ν < 1/2 only
/// let step: GalleryFunction = "step:0.4".parse()?;
/// assert!(step.is_in(Order::new(0.25)?) && !step.is_in(Order::HALF) && step.last_order() == 0.5);
/// assert_eq!(step.finite_seminorm(0.5, 1e-8)?, None);
/// # Ok::<(), signorini::Error>(())
/// ```
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
const EXPECTED: &str = "power:A, step:X with 0 < X < 1, hat, log:ALPHA with 0 < ALPHA <= 80, or samples:FILE";

impl GalleryFunction {
    /// |u|_ν in closed form, where one is known.
    ///
    /// # Errors
    /// [`ToolkitError::InfiniteNorm`] above the critical order.
    pub fn closed_form(&self, order: impl Given<Order>) -> fractional_sobolev::Result<Option<Estimate>> {
        let order = order.given()?;
        let squared = match self {
            // right also where the square underflows
            Self::Power(a) => return closed_forms::power_seminorm(*a, order).map(Some),
            Self::Step(at) => closed_forms::jump_seminorm_squared(*at, 1.0 - at, order)?,
            Self::Hat => closed_forms::hat_seminorm_squared(0.0, 0.5, 0.5, 0.0, order)?,
            Self::Log(alpha) if order.offset() == 0.0 => closed_forms::log_power_seminorm_squared(*alpha)?,
            _ => return Ok(None),
        };
        squared.sqrt().map(Some)
    }

    /// Whether |u|_ν < ∞: x^a for ν < a + 1/2 (every ν at a = 0), a step for ν < 1/2, |ln x|^α for ν < 1/2,
    /// and at ν = 1/2 for α < 1/2; piecewise linear functions always.
    pub fn is_in(&self, order: Order) -> bool {
        match *self {
            Self::Power(a) => a == 0.0 || order.offset() < a,
            Self::Step(_) => order.offset() < 0.0,
            Self::Log(alpha) => order.offset() < 0.0 || order.offset() == 0.0 && alpha < 0.5,
            Self::Hat | Self::Samples(_) => true,
        }
    }

    /// The least upper bound of the orders below one with |u|_ν < ∞: where a curve of seminorms over ν ends.
    pub fn last_order(&self) -> f64 {
        match *self {
            Self::Power(a) if a != 0.0 => (a + 0.5).min(1.0),
            Self::Step(_) | Self::Log(_) => 0.5,
            Self::Power(_) | Self::Hat | Self::Samples(_) => 1.0,
        }
    }

    /// The function.
    ///
    /// # Errors
    /// [`Error::File`] for samples that cannot be read.
    pub fn function(&self) -> Result<Function<'static>> {
        Ok(match *self {
            Self::Power(a) => Function::power(a)?,
            Self::Step(x) => Function::from_positions(&[0.0, x, 1.0], |at: Position| {
                let right = at.anchor() == 2 || at.anchor() == 1 && at.offset() > 0.0;
                f64::from(u8::from(right))
            })?,
            Self::Hat => Function::from_positions(&[0.0, 0.5, 1.0], |at| match at.anchor() {
                1 => 1.0 - 2.0 * at.offset().abs(),
                _ => 2.0 * at.offset().abs(),
            })?,
            Self::Log(alpha) => Function::from_log_distances(&[0.0, 1.0], move |at| match at.anchor() {
                0 => (-at.log_distance()).powf(alpha),
                // The distance to 1 is −ln x; at small α its power is far from 0 where it underflows.
                _ if at.log_distance() < -46.0 => (alpha * at.log_distance()).exp(),
                _ => (-at.offset().ln_1p()).powf(alpha),
            })?,
            Self::Samples(ref path) => read_samples(path)?,
        })
    }

    /// |u|_ν, none where it is found to be infinite.
    ///
    /// # Errors
    /// As [`Function::seminorm`] otherwise; [`Error::File`].
    pub fn finite_seminorm(
        &self,
        order: impl Given<Order>,
        tolerance: impl Given<Tolerance>,
    ) -> Result<Option<Estimate>> {
        match self.function()?.seminorm(order.given()?, tolerance) {
            Err(ToolkitError::InfiniteNorm { .. }) => Ok(None),
            outcome => Ok(Some(outcome?)),
        }
    }
}

/// The piecewise linear function through the rows (x, value) of a file.
fn read_samples(path: &Path) -> Result<Function<'static>> {
    let rows = read_pairs(path)?;
    if rows.len() < 2 {
        return Err(Error::file(path, "fewer than two rows of x, value"));
    }
    if let Some([_, (line, _)]) = rows.array_windows().find(|[(_, left), (_, right)]| left[0] >= right[0]) {
        return Err(Error::file(path, format!("line {line}: x is not above that of the line before")));
    }
    let (nodes, values): (Vec<f64>, Vec<f64>) = rows.iter().map(|&(_, [x, value])| (x, value)).unzip();
    Ok(Function::linears(&Mesh::from_nodes(&nodes)?, &values)?)
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

fn unknown(text: &str) -> ToolkitError {
    ToolkitError::UnknownName { what: "function", given: text.to_owned(), expected: EXPECTED }
}

impl FromStr for GalleryFunction {
    type Err = ToolkitError;

    fn from_str(text: &str) -> fractional_sobolev::Result<Self> {
        let (name, argument) = text.split_once(':').map_or((text, None), |(name, rest)| (name, Some(rest)));
        let number = argument.unwrap_or("").parse::<f64>().ok().filter(|value| value.is_finite());
        match (name, number) {
            ("power", Some(a)) if a <= 1e3 => Ok(Self::Power(a)),
            ("step", Some(at)) if at > 0.0 && at < 1.0 => Ok(Self::Step(at)),
            ("hat", _) if argument.is_none() => Ok(Self::Hat),
            // ∫ |ln x|^{2α} = Γ(2α + 1), which binary64 holds.
            ("log", Some(alpha)) if alpha > 0.0 && alpha <= 80.0 => Ok(Self::Log(alpha)),
            ("samples", _) => match argument {
                Some(path) if !path.is_empty() => Ok(Self::Samples(path.into())),
                _ => Err(unknown(text)),
            },
            _ => Err(unknown(text)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn orders_end_where_the_last_one_says() {
        for name in ["power:-0.3", "power:0.2", "step:0.4", "log:0.25", "log:2"] {
            let function: GalleryFunction = name.parse().unwrap();
            let last = function.last_order();
            let is_in = |nu: f64| function.is_in(Order::new(nu).unwrap());
            assert!(is_in(last - 1e-9) && !is_in(last + 1e-9), "{name}");
        }
        for name in ["power:0", "power:0.6", "hat"] {
            assert_eq!(name.parse::<GalleryFunction>().unwrap().last_order(), 1.0, "{name}");
        }
    }

    #[test]
    fn names_are_read_and_written() {
        for name in ["power:-0.3", "step:0.4", "hat", "log:0.25", "samples:a/b.txt"] {
            let function: GalleryFunction = name.parse().unwrap();
            assert_eq!(function.to_string(), name);
        }
        for bad in ["power", "power:x", "step:1", "hat:", "hat:3", "log:-1", "samples:", "sine", "power:nan"]
        {
            assert!(bad.parse::<GalleryFunction>().is_err(), "{bad}");
        }
    }
}
