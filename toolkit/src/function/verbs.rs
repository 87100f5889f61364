//! Verbs of functions on an interval that make a function or a number of one or two others, and the decision how a norm of
//! a formula is computed (`Function::of_formula`).

use super::{Function, Kind};
use crate::error::{Error, Given, Result};
use crate::estimate::{Estimate, Tolerance, Work};
use crate::functions::SingularFunction;
use crate::order::SobolevOrder;
use crate::piecewise::PiecewisePolynomial;
use crate::resolved::Resolved;
use std::ops::Range;

/// Rounding error of a value of a formula or of a polynomial, relative to the values of which it is made.
const ROUNDING: f64 = 8.0 * f64::EPSILON;
/// Number of halvings towards a breakpoint up to which polynomials are used first, for differences up to that from which a
/// smooth function varies by less than the rounding of its values, and the least work limit for it.
const HALVINGS: usize = 24;
const TO_ROUNDING: usize = 52;
/// Share of the work limit that rules are given where no polynomials resolve a function between its breakpoints.
const HOPELESS: u64 = 16;
const WORK: u64 = 1 << 20;
/// Tolerance below which the last digits are asked for, which polynomials do not have.
const LAST_DIGITS: f64 = 1e-14;
/// Largest number of elements of a mesh for which a difference is resolved first.
const ELEMENTS: usize = 2000;
/// Message: what limits the accuracy of an inner product.
const LIMIT: &str = "the norms of u + cv and u - cv, of which an inner product is the difference, are not accurate enough";

/// A part of an interval: elements of a mesh, or the points between two coordinates.
#[derive(Debug, Clone, PartialEq)]
pub enum Part {
    /// Elements, by their numbers.
    Elements(Range<usize>),
    /// The interval between two coordinates.
    Between(Range<f64>),
}

impl Given<Part> for Range<usize> {
    fn given(self) -> Result<Part> {
        Ok(Part::Elements(self))
    }
}

impl Given<Part> for Range<f64> {
    fn given(self) -> Result<Part> {
        Ok(Part::Between(self))
    }
}

/// Functions on an interval: values, derivatives, restrictions, sums, products, inner products.
///
/// Sums, products, multiples and restrictions of formulas are formulas; their values are computed when they are
/// needed, with the distances to the breakpoints of both. Multiples, derivatives, sums on one mesh and restrictions to
/// elements of piecewise polynomials are piecewise polynomials. A formula minus a piecewise polynomial is kept as it is.
///
/// Everything else is made of the polynomials by which a function is resolved: cells that shrink towards the breakpoints,
/// jumps and kinks, with a polynomial on each and an estimate of its distance from the function, which is rounding where
/// that can be reached. They are made when they are first needed, and kept. A norm of a formula reads them if few are
/// enough, or if rules in the logarithm of the distance to the breakpoints do not meet the tolerance.
impl<'a> Function<'a> {
    /// u(x), from the right at a jump. The error is that of rounding for a formula and a piecewise polynomial, else that of
    /// the polynomials by which u is resolved.
    ///
    /// ```
    /// use fractional_sobolev::{Function, Mesh};
    /// let u = Function::from_fn(&[0.0, 1.0], |x: f64| x.sin())?;
    /// assert_eq!(u.value(0.5)?.value, 0.5f64.sin());
    /// let hat = Function::linears(&Mesh::uniform(2, 1.0)?, &[0.0, 1.0, 0.0])?;
    /// assert!((u.times(&hat)?.value(0.75)?.value - 0.5 * 0.75f64.sin()).abs() < 1e-15);
    /// # Ok::<(), fractional_sobolev::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::OutOfRange`] outside the interval; [`Error::NotFinite`]; [`Error::Incompatible`] unless u is a function on
    /// an interval.
    pub fn value(&self, x: f64) -> Result<Estimate> {
        match &self.kind {
            Kind::Formula(u) | Kind::NearlyOne(_, u) => value_of(u, x, 0.0),
            Kind::Piecewise(u) => rounded(&[u.value_at(x)?]),
            Kind::Difference(u, v) => rounded(&[u.value_from(x, 0.0, None)?, -v.value_at(x)?]),
            Kind::Resolved(u) => u.value(x),
            _ => Err(self.refused("value at a coordinate")),
        }
    }

    /// The value at a signed distance from breakpoint k: the k-th breakpoint of a formula, the k-th node of a mesh. The
    /// distance keeps its digits down to 1e-290; a signed zero is the limit from that side.
    ///
    /// ```
    /// use fractional_sobolev::Function;
    /// let u = Function::from_positions(&[0.0, 0.3, 1.0], |at| at.log_distance_to(1))?;
    /// assert!((u.value_near(1, 1e-290)?.value / 1e-290f64.ln() - 1.0).abs() < 1e-15);
    /// # Ok::<(), fractional_sobolev::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`Function::value`]; [`Error::CountOutOfRange`] if there is no breakpoint k.
    pub fn value_near(&self, k: usize, distance: f64) -> Result<Estimate> {
        match &self.kind {
            Kind::Formula(u) | Kind::NearlyOne(_, u) => value_of(u, u.break_at(k)?, distance),
            Kind::Piecewise(u) => rounded(&[u.value_near(k, distance)?]),
            Kind::Difference(u, v) => {
                let c = u.break_at(k)?;
                rounded(&[u.value_from(c, distance, None)?, -v.value_at(c + distance)?])
            }
            Kind::Resolved(u) => u.value_near(k, distance),
            _ => Err(self.refused("value near a breakpoint")),
        }
    }

    /// The derivative between the breakpoints: of a piecewise polynomial element by element, of a formula the one given by
    /// [`Function::with_gradient`], else that of the polynomials by which it is resolved.
    ///
    /// ```
    /// use fractional_sobolev::{Function, Mesh};
    /// let hat = Function::linears(&Mesh::uniform(2, 1.0)?, &[0.0, 1.0, 0.0])?;
    /// assert_eq!(hat.derivative()?.value(0.75)?.value, -2.0);
    /// let sine = Function::from_fn(&[0.0, 1.0], |x: f64| x.sin())?;
    /// let slope = sine.derivative()?.value(0.5)?;
    /// assert!((slope.value - 0.5f64.cos()).abs() <= slope.error && slope.error < 1e-10);
    /// # Ok::<(), fractional_sobolev::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Incompatible`] unless u is a function on an interval; [`Error::NotFinite`] if a slope overflows;
    /// [`Error::ToleranceNotMet`] if a formula cannot be resolved.
    pub fn derivative(&self) -> Result<Self> {
        match (&self.kind, &self.gradient[..]) {
            (Kind::Piecewise(u), _) => u.derivative().map(Function::from),
            (_, [slope]) => slope.scaled(1.0),
            _ => self.resolved()?.derivative().map(Kind::Resolved).map(Function::of),
        }
    }

    /// The restriction to elements of a mesh (a range of their numbers; the left end of the mesh of the result is 0), or to
    /// the interval between two coordinates (a range of numbers; coordinates are kept).
    ///
    /// ```
    /// use fractional_sobolev::{Function, Mesh};
    /// let u = Function::linears(&Mesh::uniform(4, 1.0)?, &[0.0, 1.0, 2.0, 0.0, 0.0])?;
    /// assert!(u.restrict(1..3)?.mesh()?.total() == 0.5);
    /// assert!((u.restrict(0.25..0.75)?.mean(1e-12)?.value - 1.25).abs() < 1e-14);
    /// # Ok::<(), fractional_sobolev::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Incompatible`] for elements of a function that is not a piecewise polynomial, and for functions that are
    /// not on an interval; [`Error::CountOutOfRange`] for an empty range of elements or one that is not contained in the
    /// mesh; [`Error::OutOfRange`] unless a < b lie in the interval.
    pub fn restrict(&self, part: impl Given<Part>) -> Result<Self> {
        let Range { start, end } = match part.given()? {
            Part::Elements(elements) => {
                return self
                    .polynomials("restriction to elements")?
                    .restrict(elements)
                    .map(Function::from);
            }
            Part::Between(between) => between,
        };
        let kind = match &self.kind {
            Kind::Formula(u) | Kind::NearlyOne(_, u) => Kind::Formula(u.restricted(start, end)?),
            _ => Kind::Resolved(self.resolved()?.restrict(start, end)?),
        };
        // The derivative that was given is restricted with the function.
        let parts = self.gradient.iter().map(|slope| slope.restrict(start..end));
        let gradient = parts.collect::<Result<Vec<_>>>()?;
        Ok(Self { gradient, ..Self::of(kind) })
    }

    /// c u.
    ///
    /// ```
    /// use fractional_sobolev::Function;
    /// let u = Function::from_fn(&[0.0, 1.0], |x| x)?;
    /// assert!((u.scaled(-3.0)?.seminorm(0.5, 1e-8)?.value - 3.0).abs() < 1e-8);
    /// # Ok::<(), fractional_sobolev::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::NotFinite`] unless c is finite; [`Error::Incompatible`] unless u is a function on an interval.
    pub fn scaled(&self, factor: f64) -> Result<Self> {
        if !factor.is_finite() {
            return Err(Error::NotFinite { name: "factor", index: 0, value: factor });
        }
        let kind = match &self.kind {
            Kind::Formula(u) | Kind::NearlyOne(_, u) => Kind::Formula(u.scaled(factor)?),
            Kind::Piecewise(u) => Kind::Piecewise(u.scaled_by(factor)),
            Kind::Difference(u, v) => {
                Kind::Difference(Box::new(u.scaled(factor)?), Box::new(v.scaled_by(factor)))
            }
            Kind::Resolved(u) => Kind::Resolved(u.scaled(factor)),
            _ => return Err(self.refused("multiple")),
        };
        let gradient =
            self.gradient.iter().map(|slope| slope.scaled(factor)).collect::<Result<Vec<_>>>()?;
        Ok(Self { gradient, ..Self::of(kind) })
    }

    /// u + v, on the same interval.
    ///
    /// ```
    /// use fractional_sobolev::{Function, Mesh};
    /// let u = Function::from_fn(&[0.0, 1.0], |x: f64| x.sqrt())?;
    /// let v = Function::linears(&Mesh::uniform(7, 1.0)?, &[1.0; 8])?;
    /// let sum = u.plus(&v)?;
    /// assert!((sum.mean(1e-10)?.value - 5.0 / 3.0).abs() < 1e-10);
    /// assert!((sum.seminorm(0.5, 1e-7)?.value / u.seminorm(0.5, 1e-7)?.value - 1.0).abs() < 2e-7);
    /// # Ok::<(), fractional_sobolev::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`Function::minus`].
    pub fn plus(&self, other: &Self) -> Result<Self> {
        self.combined(1.0, other, 1.0)
    }

    /// u − v, on the same interval.
    ///
    /// The difference of a formula and a piecewise polynomial is computed with the cancellation in mind: its norms have
    /// their digits although the difference may be 10¹⁰ times smaller than u.
    ///
    /// ```
    /// use fractional_sobolev::{Function, Mesh};
    /// // u = x − 1/2, v = 0: ‖u − v‖²_{1/2} = 1/12 + 1
    /// let u = Function::from_fn(&[0.0, 1.0], |x| x - 0.5)?;
    /// let zero = Function::piecewise(&Mesh::uniform(10, 1.0)?, 0, &[0.0; 10])?;
    /// assert!((u.minus(&zero)?.norm(0.5, 1e-8)?.value.powi(2) - 13.0 / 12.0).abs() < 1e-8);
    /// assert!(zero.minus(&zero)?.norm(0.5, 1e-8)?.value == 0.0);
    /// // x² and its interpolants: the error in |·|_{1/2} decreases like h^{3/2}
    /// let u = Function::from_fn(&[0.0, 1.0], |x| x * x)?;
    /// let error = |n: usize| {
    ///     let field = Function::interpolate(&Mesh::uniform(n, 1.0)?, 1, |x| x * x)?;
    ///     u.minus(&field)?.seminorm(0.5, 1e-6)
    /// };
    /// assert!(((error(100)?.value / error(200)?.value).log2() - 1.5).abs() < 0.01);
    /// # Ok::<(), fractional_sobolev::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Incompatible`] unless both are functions on an interval; [`Error::OutOfRange`], of the difference of a
    /// formula and a piecewise polynomial from its norms only, unless it is the same interval.
    pub fn minus(&self, other: &Self) -> Result<Self> {
        self.combined(1.0, other, -1.0)
    }

    /// a u + b v.
    fn combined(&self, a: f64, other: &Self, b: f64) -> Result<Self> {
        let formula_minus = |u: &SingularFunction<'a>, a: f64, v: &PiecewisePolynomial, b: f64| {
            let u = Box::new(u.scaled(a)?);
            Ok::<_, Error>(Kind::Difference(u, Box::new(v.scaled_by(-b))))
        };
        let kind = match (&self.kind, &other.kind) {
            (
                Kind::Formula(u) | Kind::NearlyOne(_, u),
                Kind::Formula(v) | Kind::NearlyOne(_, v),
            ) => Kind::Formula(u.sum(a, v, b)?),
            (Kind::Formula(u) | Kind::NearlyOne(_, u), Kind::Piecewise(v)) => {
                formula_minus(u, a, v, b)?
            }
            (Kind::Piecewise(u), Kind::Formula(v) | Kind::NearlyOne(_, v)) => {
                formula_minus(v, b, u, a)?
            }
            (Kind::Piecewise(u), Kind::Piecewise(v)) if u.mesh() == v.mesh() => {
                Kind::Piecewise(u.scaled_by(a).minus(&v.scaled_by(-b))?)
            }
            _ => Kind::Resolved(self.resolved()?.combined(a, other.resolved()?, b)?),
        };
        let gradient = match (&self.gradient[..], &other.gradient[..]) {
            ([u], [v]) => vec![u.combined(a, v, b)?],
            _ => Vec::new(),
        };
        Ok(Self { gradient, ..Self::of(kind) })
    }

    /// u v, on the same interval.
    ///
    /// ```
    /// use fractional_sobolev::Function;
    /// let u = Function::from_fn(&[0.0, 0.5, 1.0], |x| (x - 0.5).abs())?;
    /// let square = u.times(&u)?;
    /// assert!((square.mean(1e-10)?.value - 1.0 / 12.0).abs() < 1e-10);
    /// # Ok::<(), fractional_sobolev::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Incompatible`] unless both are functions on an interval; [`Error::OutOfRange`] unless it is the same one.
    pub fn times(&self, other: &Self) -> Result<Self> {
        let kind = match (&self.kind, &other.kind) {
            (
                Kind::Formula(u) | Kind::NearlyOne(_, u),
                Kind::Formula(v) | Kind::NearlyOne(_, v),
            ) => Kind::Formula(u.times(v)?),
            _ => Kind::Resolved(self.resolved()?.times(other.resolved()?)?),
        };
        Ok(Self::of(kind))
    }

    /// The inner product (u, v)_s whose norm is [`Function::norm`] of order −1 < s < 2, real, by polarisation:
    /// with c = ‖u‖/‖v‖,
    ///
    /// ```text
    /// (u, v)_s = (‖u + cv‖² − ‖u − cv‖²) / (4c).
    /// ```
    ///
    /// The tolerance is relative to ‖u‖_s ‖v‖_s. For s = 0 it is ∫ u v.
    ///
    /// ```
    /// use fractional_sobolev::Function;
    /// let u = Function::from_fn(&[0.0, 1.0], |x| x)?;
    /// let v = Function::from_fn(&[0.0, 1.0], |x| x * x)?;
    /// assert!((u.inner(&v, 0.0, 1e-8)?.value - 0.25).abs() < 1e-8);
    /// // ∫∫ (x − y)(x² − y²)/(x − y)² = ∫∫ (x + y) = 1
    /// assert!((u.inner(&v, 0.5, 1e-8)?.value - 1.25).abs() < 1e-7);
    /// # Ok::<(), fractional_sobolev::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`Function::norm`] of both and [`Function::minus`].
    pub fn inner(
        &self,
        other: &Self,
        s: impl Given<SobolevOrder>,
        tolerance: impl Given<Tolerance>,
    ) -> Result<Estimate> {
        let (s, tolerance) = (s.given()?, tolerance.given()?);
        let inner =
            Tolerance::new((0.5 * tolerance.relative()).max(1e-15))?.with_work(tolerance.work());
        let [u, v] = [self.norm(s, inner), other.norm(s, inner)].map(Estimate::or_best);
        let (u, v) = (u?, v?);
        if u.value == 0.0 || v.value == 0.0 {
            return u.product(v);
        }
        let c = u.value / v.value;
        let of = |c: f64| match Estimate::or_best(self.combined(1.0, other, c)?.norm(s, inner)) {
            // A sum that cancels is rounding, which is no formula.
            Err(Error::ToleranceNotMet { .. }) => {
                let sum = self.resolved()?.combined(1.0, other.resolved()?, c)?;
                Estimate::or_best(Function::of(Kind::Resolved(sum)).norm(s, inner))
            }
            found => found,
        };
        let [sum, difference] = [of(c)?, of(-c)?];
        let value = (sum.value - difference.value) * (sum.value + difference.value) / (4.0 * c);
        let error_of = |norm: Estimate| (2.0 * norm.value + norm.error) * norm.error / (4.0 * c);
        let size = u.value * v.value;
        let error = error_of(sum) + error_of(difference) + ROUNDING * size;
        let found = Estimate::new(value, error, u.work + v.work + sum.work + difference.work)?;
        if error <= tolerance.relative() * size {
            return Ok(found);
        }
        Err(Error::not_met("inner product", tolerance.relative(), found, LIMIT))
    }

    /// The polynomials by which the function is resolved, made once.
    ///
    /// # Errors
    /// [`Error::Incompatible`] unless it is a function on an interval; [`Error::ToleranceNotMet`] if it cannot be resolved;
    /// [`Error::NotFinite`].
    pub(super) fn resolved(&self) -> Result<&Resolved> {
        if let Kind::Resolved(u) = &self.kind {
            return Ok(u);
        }
        let make = || match &self.kind {
            Kind::Formula(u) | Kind::NearlyOne(_, u) => Resolved::of(u),
            Kind::Piecewise(u) => Ok(Resolved::of_polynomials(u)),
            Kind::Difference(u, v) => {
                Resolved::of(u)?.combined(1.0, &Resolved::of_polynomials(v), -1.0)
            }
            _ => Err(self.refused("verb for functions on an interval")),
        };
        self.resolved.get_or_init(make).as_ref().map_err(Error::clone)
    }

    /// The polynomials from which a norm is computed first: those that were made before, however many; otherwise those that
    /// take at most [`HALVINGS`] halvings towards a breakpoint, enough where a function is smooth up to its breakpoints or
    /// has moderate layers there. `None` for powers and logarithms of the distance to a breakpoint, which take more
    /// ([`crate::resolved`]), for a work limit below [`WORK`], and for a tolerance below [`LAST_DIGITS`].
    ///
    /// Those of a difference are used first where the formula has structure between its breakpoints; otherwise its values
    /// are subtracted before they are approximated, which keeps more digits of a small difference.
    fn at_hand(&self, tolerance: Tolerance) -> Option<&Resolved> {
        if tolerance.work() < WORK || tolerance.relative() < LAST_DIGITS {
            return None;
        }
        let keep = |found: Option<Resolved>| {
            found.is_some_and(|found| {
                self.resolved.get_or_init(|| Ok(found));
                true
            })
        };
        let is_short = || match &self.kind {
            Kind::Formula(u) | Kind::NearlyOne(_, u) => {
                self.is_short.get_or_init(|| keep(Resolved::within(u, HALVINGS).ok()))
            }
            Kind::Difference(u, v) => self.is_short.get_or_init(|| {
                let formula = match v.mesh().len() {
                    ..=ELEMENTS => Resolved::within(u, TO_ROUNDING).ok(),
                    _ => None,
                };
                let formula = formula.filter(|u| u.has_structure() || u.is_noisy());
                let v = Resolved::of_polynomials(v);
                keep(formula.and_then(|formula| formula.combined(1.0, &v, -1.0).ok()))
            }),
            _ => &false,
        };
        let is_difference = matches!(self.kind, Kind::Difference(..));
        let is_first = !is_difference && self.resolved.get().is_some() || *is_short();
        self.resolved.get().filter(|_| is_first)?.as_ref().ok()
    }

    /// A norm of a formula: of its polynomials if they are at hand and meet the tolerance; otherwise by `rules` along the
    /// sides of the breakpoints, and if these fail by polynomials on as many cells as needed. What noise of the values
    /// refuses to polynomials, rules do not have either.
    pub(super) fn of_formula(
        &self,
        tolerance: Tolerance,
        rules: impl FnOnce(Tolerance) -> Result<Estimate>,
        of: impl Fn(&Resolved) -> Result<Estimate>,
    ) -> Result<Estimate> {
        let Some(polynomials) = self.at_hand(tolerance) else {
            return self.or_resolved(rules(tolerance), of);
        };
        let refused = match of(polynomials) {
            Err(refused @ Error::ToleranceNotMet { best: Some(_), .. })
                if polynomials.is_noisy() =>
            {
                return Err(refused);
            }
            Err(refused) => refused,
            found => return found,
        };
        let is_hopeless =
            matches!(refused, Error::ToleranceNotMet { best: None, .. }) && polynomials.is_rough();
        let share = if is_hopeless { HOPELESS } else { 1 };
        let found = rules(tolerance.with_work(tolerance.work() / share));
        if is_hopeless && let Err(Error::ToleranceNotMet { best: None, .. }) = found {
            return Err(refused);
        }
        self.or_resolved(found, |_| Err(refused))
    }

    /// An answer, or where it does not meet the tolerance that of the polynomials, or the better one of both.
    pub(super) fn or_resolved(
        &self,
        found: Result<Estimate>,
        of: impl FnOnce(&Resolved) -> Result<Estimate>,
    ) -> Result<Estimate> {
        let refused = match found {
            Err(refused @ Error::ToleranceNotMet { why, .. }) if why != crate::estimate::SPENT => {
                refused
            }
            found => return found,
        };
        // The last digits are those of rounding, for which polynomials are no better.
        if let Error::ToleranceNotMet { asked, best: Some(_), .. } = refused
            && asked < LAST_DIGITS
        {
            return Err(refused);
        }
        match self.resolved().and_then(of) {
            Err(Error::ToleranceNotMet { best: Some(other), asked, what, why, .. })
                if refused.best().is_none_or(|best| other.error < best.error) =>
            {
                Err(Error::not_met(what, asked, other, why))
            }
            Err(Error::ToleranceNotMet { .. } | Error::NotFinite { .. }) => Err(refused),
            answered => answered,
        }
    }
}

/// The value of a formula at an offset from a coordinate; its rounding is relative to the terms of which it is the sum.
fn value_of(u: &SingularFunction, base: f64, offset: f64) -> Result<Estimate> {
    let [value, size] = [u.value_from(base, offset, None)?, u.size_from(base, offset, None)?];
    Estimate::new(value, ROUNDING * size, Work::default())
}

/// The sum of values, with its rounding error.
fn rounded(values: &[f64]) -> Result<Estimate> {
    let size: f64 = values.iter().map(|value| value.abs()).sum();
    Estimate::new(values.iter().sum(), ROUNDING * size, Work::default())
}
