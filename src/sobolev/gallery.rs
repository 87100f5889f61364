//! Functions whose norms are worth knowing, by name: `power:0.3`, `step:0.4`, `hat`, `log:0.25`,
//! `samples:FILE`.

use super::closed_forms;
use super::evaluated::{Evaluated, hat, log, power, read_samples, step};
use super::functions::SingularFunction;
use super::order::FractionalOrder;
use super::piecewise::PiecewisePolynomial;
use crate::error::{Error, Given, Result};
use crate::estimate::{Estimate, Tolerance};
use std::fmt;
use std::path::PathBuf;
use std::str::FromStr;

/// A function by name.
///
/// # Method
///
/// All but samples live on (0, 1). Where |u|_ν is finite, [`GalleryFunction::is_in`] says.
///
/// ```
/// use signorini::{Tolerance, sobolev::{FractionalOrder, GalleryFunction}};
/// let (order, asked) = (FractionalOrder::new(0.25)?, Tolerance::balanced());
/// let root: GalleryFunction = "power:0.5".parse()?;
/// let exact = root.closed_form(order)?.map(|e| e.value).unwrap_or(f64::NAN);
/// assert!((root.seminorm(order, asked)?.value / exact - 1.0).abs() < 1e-8);
/// assert!((root.norm(order, asked)?.value.powi(2) - exact.powi(2) - 0.5).abs() < 1e-7);
/// // a step is in H^ν for ν < 1/2 only
/// let step: GalleryFunction = "step:0.4".parse()?;
/// assert!(step.is_in(order) && !step.is_in(FractionalOrder::HALF) && step.last_order() == 0.5);
/// assert_eq!(step.finite_seminorm(FractionalOrder::HALF, asked)?, None);
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
    /// |u|_ν.
    ///
    /// # Errors
    /// [`Error::InfiniteNorm`] above the critical order, [`Error::ToleranceNotMet`], [`Error::File`].
    pub fn seminorm(
        &self,
        order: impl Given<FractionalOrder>,
        tolerance: impl Given<Tolerance>,
    ) -> Result<Estimate> {
        self.evaluated()?.seminorm(order.given()?, tolerance.given()?)
    }

    /// |u|_ν, none where it is found to be infinite.
    ///
    /// # Errors
    /// As [`GalleryFunction::seminorm`] otherwise.
    pub fn finite_seminorm(&self, order: FractionalOrder, tolerance: Tolerance) -> Result<Option<Estimate>> {
        match self.seminorm(order, tolerance) {
            Err(Error::InfiniteNorm { .. }) => Ok(None),
            outcome => outcome.map(Some),
        }
    }

    /// ||u||_ν.
    ///
    /// # Errors
    /// As [`GalleryFunction::seminorm`].
    pub fn norm(
        &self,
        order: impl Given<FractionalOrder>,
        tolerance: impl Given<Tolerance>,
    ) -> Result<Estimate> {
        self.evaluated()?.norm(order.given()?, tolerance.given()?)
    }

    /// |u − u_h|_ν for a field on many elements, as [`SingularFunction::seminorm_of_error`].
    ///
    /// ```
    /// use signorini::Tolerance;
    /// use signorini::sobolev::{FractionalOrder, GalleryFunction, Partition, PiecewisePolynomial};
    /// let mesh = Partition::algebraic(1000, 2.0, 1.0)?;
    /// let values: Vec<f64> = mesh.from_left().iter().map(|x| x.sqrt()).collect();
    /// let field = PiecewisePolynomial::linears(mesh, &values)?;
    /// let root = GalleryFunction::Power(0.5);
    /// let (order, asked) = (FractionalOrder::HALF, Tolerance::fast());
    /// let found = root.seminorm_of_error(&field, order, asked)?;
    /// assert!(found.value < 3e-3 && found.value < root.norm_of_error(&field, order, asked)?.value);
    /// # Ok::<(), signorini::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`SingularFunction::seminorm_of_error`]; [`Error::Incompatible`] for samples.
    pub fn seminorm_of_error(
        &self,
        field: &PiecewisePolynomial,
        order: FractionalOrder,
        tolerance: Tolerance,
    ) -> Result<Estimate> {
        self.closure()?.seminorm_of_error(field, order, tolerance)
    }

    /// ||u − u_h||_ν, as [`GalleryFunction::seminorm_of_error`].
    ///
    /// # Errors
    /// As [`GalleryFunction::seminorm_of_error`].
    pub fn norm_of_error(
        &self,
        field: &PiecewisePolynomial,
        order: FractionalOrder,
        tolerance: Tolerance,
    ) -> Result<Estimate> {
        self.closure()?.norm_of_error(field, order, tolerance)
    }

    fn closure(&self) -> Result<SingularFunction<'_>> {
        match *self {
            Self::Power(a) => power(a),
            Self::Step(x) => step(x),
            Self::Hat => hat(),
            Self::Log(alpha) => log(alpha),
            Self::Samples(_) => Err(Error::Incompatible {
                what: "function",
                given: self.to_string(),
                with: "the error of a field",
                expected: "a function by formula, or the field minus the samples as one piecewise polynomial",
            }),
        }
    }

    fn evaluated(&self) -> Result<Evaluated<'_>> {
        match self {
            Self::Power(a) => Evaluated::power(*a),
            Self::Samples(path) => read_samples(path).map(Evaluated::Samples),
            _ => self.closure().map(Evaluated::Closure),
        }
    }

    /// |u|_ν in closed form, where one is known.
    ///
    /// # Errors
    /// [`Error::InfiniteNorm`] above the critical order.
    pub fn closed_form(&self, order: FractionalOrder) -> Result<Option<Estimate>> {
        let squared = match self {
            Self::Power(a) => return closed_forms::root_of_power(*a, order).map(Some),
            Self::Step(at) => closed_forms::jump(*at, 1.0 - at, order)?,
            Self::Hat => closed_forms::hat(0.0, 0.5, 0.5, 0.0, order)?,
            Self::Log(alpha) if order.offset() == 0.0 => closed_forms::log_power(*alpha)?,
            _ => return Ok(None),
        };
        squared.sqrt().map(Some)
    }

    /// Whether |u|_ν < ∞: x^a for ν < a + 1/2 (every ν at a = 0), a step for ν < 1/2, |ln x|^α for ν < 1/2,
    /// and at ν = 1/2 for α < 1/2; piecewise linear functions always.
    pub fn is_in(&self, order: FractionalOrder) -> bool {
        match *self {
            Self::Power(a) => a == 0.0 || order.offset() < a,
            Self::Step(_) => order.is_below_half(),
            Self::Log(alpha) => order.is_below_half() || order.offset() == 0.0 && alpha < 0.5,
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
}

impl fmt::Display for GalleryFunction {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Power(a) => write!(f, "power:{}", short(*a)),
            Self::Step(at) => write!(f, "step:{}", short(*at)),
            Self::Hat => write!(f, "hat"),
            Self::Log(alpha) => write!(f, "log:{}", short(*alpha)),
            Self::Samples(path) => write!(f, "samples:{}", path.display()),
        }
    }
}

/// The shortest text that is read as this number again, without rows of zeros.
fn short(value: f64) -> String {
    let plain = value.to_string();
    if plain.len() > 20 { format!("{value:e}") } else { plain }
}

fn unknown(text: &str) -> Error {
    Error::UnknownName { what: "function", given: text.to_owned(), expected: EXPECTED }
}

impl FromStr for GalleryFunction {
    type Err = Error;

    fn from_str(text: &str) -> Result<Self> {
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
            let is_in = |nu: f64| function.is_in(FractionalOrder::new(nu).unwrap());
            assert!(is_in(last - 1e-9) && !is_in(last + 1e-9), "{name}");
        }
        for name in ["power:0", "power:0.6", "hat"] {
            assert_eq!(name.parse::<GalleryFunction>().unwrap().last_order(), 1.0, "{name}");
        }
    }

    /// x^a with a so small that its values round to one: |u|_ν ~ |a| below ν = 1/2, √a at 1/2.
    #[test]
    fn powers_next_to_a_constant_have_their_norms() {
        let asked = Tolerance::balanced();
        for a in [1e-300, 1e-17, -1e-17, 1e-12, -1e-6, 1e-3, 0.003906] {
            for nu in [1e-3, 0.1, 0.25, 0.49] {
                let (u, order) = (GalleryFunction::Power(a), FractionalOrder::new(nu).unwrap());
                let (found, exact) =
                    (u.seminorm(order, asked).unwrap(), u.closed_form(order).unwrap().unwrap());
                let off = (found.value - exact.value).abs();
                assert!(off <= found.error + exact.error, "{u}, {nu}: {found}, exact {exact}");
                assert!(found.error <= 1.1e-8 * exact.value, "{u}, {nu}: {found}");
                let norm = u.norm(order, asked).unwrap();
                let whole = (1.0 / (1.0 + 2.0 * a) + exact.value.powi(2)).sqrt();
                assert!((norm.value - whole).abs() <= norm.error + 1e-15, "{u}, {nu}: {norm}, exact {whole}");
            }
            let half = GalleryFunction::Power(a).finite_seminorm(FractionalOrder::HALF, asked);
            match half {
                Ok(Some(found)) => {
                    let exact =
                        GalleryFunction::Power(a).closed_form(FractionalOrder::HALF).unwrap().unwrap();
                    assert!((found.value - exact.value).abs() <= found.error + exact.error, "{a}: {found}");
                }
                Ok(None) => assert!(a < 0.0, "x^{a} is in H^(1/2)"),
                Err(error) => assert!(matches!(error, Error::ToleranceNotMet { .. }), "{a}: {error}"),
            }
            let above = GalleryFunction::Power(a).finite_seminorm(FractionalOrder::new(0.75).unwrap(), asked);
            assert_eq!(above.unwrap(), None, "{a}");
        }
        let written = |a: f64| GalleryFunction::Power(a).to_string();
        assert_eq!([1e-300, 0.3, -2.0].map(written), ["power:1e-300", "power:0.3", "power:-2"]);
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
