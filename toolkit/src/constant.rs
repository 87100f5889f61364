//! Best constants: their domains, norms and bounds.

use crate::error::{Error, Result};
use crate::estimate::{Estimate, Tolerance, Work};
use crate::function::Function;
use crate::mesh::Mesh;
use crate::order::{Order, SobolevOrder};
use std::fmt;
use std::sync::Arc;

/// The domain to which a best constant belongs.
///
/// | domain | interpolation, projection | trace |
/// | --- | --- | --- |
/// | `Interval`, `Mesh` | [`interpolation_constant`](crate::interpolation_constant), [`projection_constant`](crate::projection_constant) | |
/// | `Triangle` | [`interpolation_constant`](crate::interpolation_constant) | |
/// | `HalfPlane`, `Corner`, `Square` | | [`trace_constant`](crate::trace_constant) |
///
/// ```
/// use fractional_sobolev::{Domain, ErrorNorm, Mesh, interpolation_constant};
/// let mesh = Domain::Mesh(Mesh::uniform(4, 1.0)?);
/// let on_mesh = interpolation_constant(mesh, ErrorNorm::L2, 0.5, 1e-2)?.constant;
/// let on_element = interpolation_constant(Domain::Interval(0.25), ErrorNorm::L2, 0.5, 1e-2)?.constant;
/// assert!(on_mesh.value < on_element.value);
/// assert!(interpolation_constant(Domain::HalfPlane, ErrorNorm::L2, 0.5, 1e-2).is_err());
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub enum Domain {
    /// The interval (0, h) as a single element; the field is h.
    Interval(f64),
    /// All elements of a mesh.
    Mesh(Mesh),
    /// The triangle with these corners.
    Triangle([[f64; 2]; 3]),
    /// The half-plane y > 0 and its edge y = 0.
    HalfPlane,
    /// The sector 0 < θ < ω and its edge θ = 0; the field is ω, in radians.
    Corner(f64),
    /// The unit square and its edge y = 0.
    Square,
}

impl Domain {
    /// [`Error::Incompatible`] for a domain without a method.
    pub(crate) fn refused(&self, with: &'static str, expected: &'static str) -> Error {
        Error::Incompatible { what: "domain", given: format!("{self:?}"), with, expected }
    }
}

/// The norm of an error e that a constant bounds.
///
/// ```
/// use fractional_sobolev::{Domain, ErrorNorm, projection_constant};
/// // φ less its mean, for φ with ‖φ'‖ = 1: in L² and at an end
/// let of = |norm| projection_constant(Domain::Interval(1.0), norm, 1.0, 1e-8).map(|found| found.constant.value);
/// assert!((of(ErrorNorm::L2)? - std::f64::consts::FRAC_1_PI).abs() < 1e-12);
/// assert!((of(ErrorNorm::At(0.0))? - 1.0 / 3f64.sqrt()).abs() < 1e-12);
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ErrorNorm {
    /// The L² norm ‖e‖.
    L2,
    /// The norm ‖∇e‖ of the derivative.
    Derivative,
    /// The norm (‖e‖² + ‖∇e‖²)^{1/2}.
    H1,
    /// The norm of e of order −1/2, dual to that of order 1/2.
    Dual,
    /// The value |e(x)| at a point x.
    At(f64),
}

impl ErrorNorm {
    /// [`Error::Incompatible`] for a norm without a method.
    pub(crate) fn refused(self, with: &'static str, expected: &'static str) -> Error {
        Error::Incompatible {
            what: "norm of the error",
            given: format!("{self:?}"),
            with,
            expected,
        }
    }
}

/// A best constant: its value, its lower and upper bounds, and a function that attains it. The one result of
/// every function that computes a best constant.
///
/// ```
/// use fractional_sobolev::{BestConstant, Domain, ErrorNorm, interpolation_constant};
/// let triangle = Domain::Triangle([[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]);
/// let gradient: BestConstant = interpolation_constant(triangle, ErrorNorm::Derivative, 0.75, 1e-5)?;
/// assert!((gradient.constant.value - 0.262_185_14).abs() < 1e-6);
/// assert!(gradient.lower.value <= gradient.constant.value + gradient.constant.error);
/// assert!(gradient.upper.is_some_and(|upper| upper.value > gradient.constant.value));
/// // in another norm, from the same matrices
/// assert!(gradient.in_norm(ErrorNorm::L2)?.constant.value < gradient.constant.value);
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
#[derive(Clone)]
pub struct BestConstant {
    /// The constant, to the requested tolerance; for an embedding and for [`Law::bracket`](crate::Law::bracket) the
    /// midpoint between `lower` and `upper`, with half their distance as error unless `upper` is 1.
    pub constant: Estimate,
    /// A lower bound: the quotient for a particular function. Its error is that of quadrature and rounding.
    pub lower: Estimate,
    /// A proved upper bound, where one is known; that of `gamma` and `moment` is computed by
    /// [`bounded`](Self::bounded). Its error is that of rounding.
    pub upper: Option<Estimate>,
    extremal: Option<OnRequest<Extremal>>,
    others: Option<Others>,
    bounds: Option<OnRequest<[f64; 2]>>,
}

/// Computed where it is asked for.
type OnRequest<T> = Arc<dyn Fn() -> Result<T> + Send + Sync>;

/// The constant in another norm, computed on request.
type Others = Arc<dyn Fn(ErrorNorm) -> Result<BestConstant> + Send + Sync>;

impl fmt::Debug for BestConstant {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("BestConstant")
            .field("constant", &self.constant)
            .field("lower", &self.lower)
            .field("upper", &self.upper)
            .finish_non_exhaustive()
    }
}

impl BestConstant {
    pub(crate) fn new(constant: Estimate, lower: Estimate, upper: Option<Estimate>) -> Self {
        Self { constant, lower, upper, extremal: None, others: None, bounds: None }
    }

    /// A constant in closed form.
    pub(crate) fn exact(constant: Estimate) -> Self {
        Self::new(constant, constant, Some(constant))
    }

    pub(crate) fn with_extremal(
        self,
        value: impl Fn(&[f64]) -> f64 + Send + Sync + 'static,
    ) -> Self {
        let extremal = Extremal(Kind::Points(Arc::new(value)));
        self.with_extremal_by(move || Ok(extremal.clone()))
    }

    /// The extremal function, computed on request.
    pub(crate) fn with_extremal_by(
        self,
        extremal: impl Fn() -> Result<Extremal> + Send + Sync + 'static,
    ) -> Self {
        Self { extremal: Some(Arc::new(extremal)), ..self }
    }

    /// Lower and upper bound, computed on request.
    pub(crate) fn with_bounds_by(
        self,
        bounds: impl Fn() -> Result<[f64; 2]> + Send + Sync + 'static,
    ) -> Self {
        Self { bounds: Some(Arc::new(bounds)), ..self }
    }

    /// The constant between two proved bounds: their midpoint, with half their distance as error.
    pub(crate) fn between(lower: f64, upper: f64, work: Work) -> Result<Self> {
        let exactly = |value| Estimate::new(value, 0.0, work);
        let constant = Estimate::new(0.5 * (lower + upper), 0.5 * (upper - lower), work)?;
        Ok(Self::new(constant, exactly(lower)?, Some(exactly(upper)?)))
    }

    pub(crate) fn with_others(
        self,
        others: impl Fn(ErrorNorm) -> Result<Self> + Send + Sync + 'static,
    ) -> Self {
        Self { others: Some(Arc::new(others)), ..self }
    }

    /// The constant and its bounds, multiplied by a factor.
    pub(crate) fn times(self, factor: f64) -> Result<Self> {
        let upper = self.upper.map(|upper| upper.times(factor)).transpose()?;
        Ok(Self {
            constant: self.constant.times(factor)?,
            lower: self.lower.times(factor)?,
            upper,
            ..self
        })
    }

    /// The same constant if its error meets the tolerance.
    pub(crate) fn met(
        self,
        what: &'static str,
        tolerance: Tolerance,
        why: &'static str,
    ) -> Result<Self> {
        if self.constant.relative_error() <= tolerance.relative() {
            return Ok(self);
        }
        Err(Error::not_met(what, tolerance.relative(), self.constant, why))
    }

    /// The constant of the same domain, order and tolerance in another norm of the error. On a triangle the
    /// Gram matrices, which account for nearly all of the cost, are reused.
    ///
    /// # Errors
    /// As for the function that returned this constant; [`Error::Incompatible`] for the embedding and trace
    /// constants.
    pub fn in_norm(&self, norm: ErrorNorm) -> Result<Self> {
        let refused = || norm.refused("this constant", "an interpolation or projection constant");
        self.others.as_ref().ok_or_else(refused)?(norm)
    }

    /// The same constant with a lower and an upper bound by an independent computation, for the constants of
    /// [`gamma`](crate::gamma) and [`moment`](crate::moment), where the method and its cost are described; a constant
    /// that has its bounds already is returned as it is.
    ///
    /// ```
    /// use fractional_sobolev::{Constraint, gamma};
    /// let found = gamma(0.3, Constraint::mean_zero_on(0.25..0.26), 1e-4)?.bounded()?;
    /// let (gamma, upper) = (found.constant.value, found.upper.map_or(f64::NAN, |upper| upper.value));
    /// assert!(found.lower.value <= gamma && gamma <= upper && upper < 1.5 * gamma);
    /// # Ok::<(), fractional_sobolev::Error>(())
    /// ```
    ///
    /// # Errors
    /// Those of the computation; [`Error::Incompatible`] if no upper bound is known.
    pub fn bounded(&self) -> Result<Self> {
        if let Some(bounds) = &self.bounds {
            let [lower, upper] = bounds()?;
            let exactly = |value| Estimate::new(value, 0.0, self.constant.work);
            return Ok(Self {
                lower: exactly(lower)?,
                upper: Some(exactly(upper)?),
                bounds: None,
                ..self.clone()
            });
        }
        match self.upper {
            Some(_) => Ok(self.clone()),
            None => Err(unknown("upper bound", "a constant with a known upper bound")),
        }
    }

    /// The product of two best constants: the best constant of a product of two quotients whose functions are chosen
    /// independently of each other. Its bounds are the products of theirs, and [`bounded`](Self::bounded) computes both.
    ///
    /// ```
    /// use fractional_sobolev::{Estimate, Moment, moment};
    /// // ∫ σ ∫ w ≤ K |σ| |w| for functions on (0, 1) that vanish on one half each
    /// let on = |zone| moment(0.5, zone, Moment::Mass, 1e-6);
    /// let product = on(0.5..1.0)?.product(&on(0.0..0.5)?)?.bounded()?;
    /// let (lower, upper) = (product.lower.value, product.upper.map_or(f64::NAN, |upper| upper.value));
    /// assert!((product.constant.value - 0.051_868_428).abs() < 1e-7);
    /// let Estimate { value, error, .. } = product.constant;
    /// assert!(lower - error <= value && value <= upper + error && upper - lower < 1e-6);
    /// # Ok::<(), fractional_sobolev::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::NotFinite`] for a product that overflows.
    pub fn product(&self, other: &Self) -> Result<Self> {
        let upper = self.upper.zip(other.upper).map(|(a, b)| a.product(b)).transpose()?;
        let constant = self.constant.product(other.constant)?;
        let product = Self::new(constant, self.lower.product(other.lower)?, upper);
        if self.bounds.is_none() && other.bounds.is_none() {
            return Ok(product);
        }
        let (first, second) = (self.clone(), other.clone());
        Ok(product.with_bounds_by(move || {
            let (first, second) = (first.bounded()?, second.bounded()?);
            let upper = |of: &Self| of.upper.map_or(f64::NAN, |upper| upper.value);
            Ok([first.lower.value * second.lower.value, upper(&first) * upper(&second)])
        }))
    }

    /// A function that attains the constant (for the embedding constant, the lower bound).
    ///
    /// ```
    /// use fractional_sobolev::{Constraint, gamma};
    /// let u = gamma(0.5, Constraint::vanishing_on(0.0..0.01), 1e-4)?.extremal()?;
    /// assert!(u.value(&[0.005]).abs() < 1e-12 && u.value(&[1.0]) > 1.0);
    /// # Ok::<(), fractional_sobolev::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Incompatible`] if no such function is known; those of [`moment`](crate::moment), whose function is
    /// computed on request.
    #[doc(alias("eigenfunction", "minimiser", "worst function"))]
    pub fn extremal(&self) -> Result<Extremal> {
        let known = "a constant whose extremal function is known";
        self.extremal.as_ref().ok_or_else(|| unknown("extremal function", known))?()
    }
}

/// [`Error::Incompatible`] for what is not known of a constant.
fn unknown(what: &'static str, expected: &'static str) -> Error {
    Error::Incompatible { what, given: "on request".to_owned(), with: "this constant", expected }
}

/// A function of the coordinates of a point.
type PointFunction = dyn Fn(&[f64]) -> f64 + Send + Sync;

/// Nodes of an interpolant are merged if they are closer than this, relative to their position or to their
/// distance from 1.
const ONE_NODE: f64 = 1e-10;
/// Nodes of the graded cells are removed if they are closer than this (in the same sense) to a given node.
const MAKES_WAY: f64 = 1e-5;

/// A function of x in (0, 1) on graded cells.
pub(crate) trait OnInterval: fmt::Debug + Send + Sync {
    /// u(x) for 0 ≤ x ≤ 1, extended by its end values; the position is taken from the nearer end of the
    /// interval.
    fn value(&self, x: f64) -> f64;

    /// The positions x and values u(x) at `per_cell` + 1 points of every cell, with increasing x.
    fn profile(&self, per_cell: usize) -> Vec<(f64, f64)>;
}

/// A function for which a best constant is attained.
///
/// | constant | function | sign |
/// | --- | --- | --- |
/// | [`gamma`](crate::gamma) | u with ‖u‖ = 1 on (0, 1) | positive where \|u\| is largest |
/// | [`moment`](crate::moment) | w with \|w\|_ν = 1 on (0, 1) | likewise |
/// | interpolation | the error u − Iu of u with \|∇u\|_s = 1 | free |
/// | projection | φ with \|φ\|_r = 1 | free |
/// | embedding, trace | the function in the quotient, not normalised | free |
///
/// ```
/// use fractional_sobolev::{Constraint, Domain, ErrorNorm, Extremal, Tolerance, gamma, interpolation_constant};
/// let found = interpolation_constant(Domain::Interval(1.0), ErrorNorm::L2, 0.5, 1e-8)?;
/// let error: Extremal = found.extremal()?;
/// let e = [0.0, 0.25, 0.5].map(|x| error.value(&[x]).abs());
/// assert!(e[0] < 1e-12 && e[1] < e[2]); // zero at the nodes, largest in the middle
///
/// let asked = Tolerance::fast();
/// let found = gamma(0.5, Constraint::mean_zero_on(0.0..0.01), asked)?;
/// let u = found.extremal()?;
/// assert!(u.profile(4).iter().all(|&(x, value)| (value - u.value(&[x])).abs() < 1e-9));
/// // its interpolant nearly has the quotient γ
/// let u = u.interpolate(3, 1, &[0.01])?;
/// let quotient = u.norm(0.0, asked)?.value / u.seminorm(0.5, asked)?.value;
/// assert!((quotient / found.constant.value - 1.0).abs() < 1e-2);
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
#[derive(Clone)]
pub struct Extremal(Kind);

/// The representation of a function.
#[derive(Clone)]
enum Kind {
    Points(Arc<PointFunction>),
    Interval(Arc<dyn OnInterval>),
}

impl fmt::Debug for Extremal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("Extremal(..)")
    }
}

impl Extremal {
    pub(crate) fn on_interval(u: impl OnInterval + 'static) -> Self {
        Self(Kind::Interval(Arc::new(u)))
    }

    /// The value at a point of the domain: one coordinate on an interval, two in the plane. NaN outside the
    /// domain; the extremal functions of `gamma` and `moment` are extended by their end values.
    pub fn value(&self, point: &[f64]) -> f64 {
        match &self.0 {
            Kind::Points(u) => u(point),
            Kind::Interval(u) => point.first().map_or(f64::NAN, |&x| u.value(x)),
        }
    }

    /// The positions x and values u(x) at `per_cell` + 1 points of every graded cell, with increasing x, for
    /// plots that resolve all scales. Empty for a function without graded cells; the extremal functions of
    /// `gamma` and `moment` have such cells.
    pub fn profile(&self, per_cell: usize) -> Vec<(f64, f64)> {
        match &self.0 {
            Kind::Points(_) => Vec::new(),
            Kind::Interval(u) => u.profile(per_cell),
        }
    }

    /// The interpolant of the given degree on the graded cells, each divided into `pieces`, with additional
    /// nodes at `breaks`. Nodes x < 1 are omitted if they are within 1e-10 of 1, within 1e-10 x of another
    /// node, or within 1e-5 x of a breakpoint.
    ///
    /// # Errors
    /// As [`Function::interpolate`]; [`Error::Incompatible`] for a function without graded cells.
    pub fn interpolate(
        &self,
        degree: usize,
        pieces: usize,
        breaks: &[f64],
    ) -> Result<Function<'static>> {
        let Kind::Interval(u) = &self.0 else {
            let (given, expected) =
                ("on graded cells".to_owned(), "an extremal function of gamma or moment");
            return Err(Error::Incompatible {
                what: "interpolant",
                given,
                with: "a function without such cells",
                expected,
            });
        };
        let near =
            |x: f64, other: f64, share: f64| (x - other).abs() < share * x.abs().max(other.abs());
        let mut nodes: Vec<f64> = u.profile(pieces).into_iter().map(|(x, _)| x).collect();
        nodes.retain(|&x| x < 1.0 - ONE_NODE && breaks.iter().all(|&b| !near(x, b, MAKES_WAY)));
        nodes.extend(breaks.iter().filter(|&&b| b < 1.0 - ONE_NODE));
        nodes.sort_by(f64::total_cmp);
        nodes.dedup_by(|x, before| near(*x, *before, ONE_NODE));
        nodes.push(1.0);
        Function::interpolate(&Mesh::from_nodes(&nodes)?, degree, |x| u.value(x))
    }
}

/// The order 0 ≤ s ≤ 1 of a seminorm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum UnitOrder {
    /// s = 0.
    Zero,
    /// 0 < s < 1.
    Inner(Order),
    /// s = 1.
    One,
}

impl UnitOrder {
    /// The order s, classified.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] outside [0, 1].
    pub(crate) fn new(s: SobolevOrder) -> Result<Self> {
        let outside = |value| Err(Error::OutOfRange { name: "s", value, range: "[0, 1]" });
        match s {
            SobolevOrder::Zero => Ok(Self::Zero),
            SobolevOrder::Fractional(order) => Ok(Self::Inner(order)),
            SobolevOrder::One => Ok(Self::One),
            SobolevOrder::Dual(order) => outside(-order.value()),
            SobolevOrder::OnePlus(order) => outside(1.0 + order.value()),
        }
    }

    /// The order s.
    pub(crate) fn value(self) -> f64 {
        match self {
            Self::Zero => 0.0,
            Self::Inner(order) => order.value(),
            Self::One => 1.0,
        }
    }
}
