//! Constraints on a function: mean zero on a zone, or zero there.

use super::zones::Zones;
use crate::error::{Error, Given, Result};

/// The condition on u on a zone.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Condition {
    /// ∫_E u = 0.
    MeanZero,
    /// u = 0 on E.
    Vanishing,
}

/// A constraint on u: mean zero on a zone, zero on a zone, or zero at a point.
///
/// A zone is a range `a..b` given by its two ends, an array of such ranges, or, for very small lengths,
/// [`Zones`] given by start and length. The constructors with a zone or a point return `Result<Constraint>`,
/// which [`gamma`](crate::gamma) accepts directly: it returns the error of an invalid zone.
///
/// ```
/// use fractional_sobolev::{Constraint, Zones, gamma};
/// let by_ends = gamma(0.5, Constraint::mean_zero_on(0.25..0.5), 1e-6)?;
/// let by_length = gamma(0.5, Constraint::mean_zero_on(Zones::from_start_and_length(0.25, 0.25)), 1e-6)?;
/// assert_eq!(by_ends.constant, by_length.constant);
/// let two = gamma(0.5, Constraint::vanishing_on([0.0..0.1, 0.8..0.9]), 1e-6)?;
/// assert!(two.constant.value < gamma(0.5, Constraint::vanishing_on(0.0..0.1), 1e-6)?.constant.value);
/// assert!(gamma(0.5, Constraint::mean_zero_on(0.5..0.25), 1e-6).is_err());
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Constraint {
    /// The lengths of the consecutive parts of (0,1). Every length is positive, except that of a single point.
    pub(crate) parts: Vec<f64>,
    /// The indices of the parts on which the condition holds, in order; no two are neighbours.
    pub(crate) zones: Vec<usize>,
    pub(crate) condition: Condition,
}

impl Constraint {
    /// The constraint that the mean over (0,1) is zero.
    ///
    /// ```
    /// use fractional_sobolev::{Constraint, Order, gamma};
    /// let near_one = Order::new(1.0 - 1e-9)?;
    /// let found = gamma(near_one, Constraint::mean_zero(), 1e-8)?.constant.value / (1.0 - near_one.value()).sqrt();
    /// assert!((found - std::f64::consts::FRAC_1_PI).abs() < 1e-6);
    /// # Ok::<(), fractional_sobolev::Error>(())
    /// ```
    pub fn mean_zero() -> Self {
        Self { parts: vec![1.0], zones: vec![0], condition: Condition::MeanZero }
    }

    /// The constraint ∫_E u = 0, where E is the union of the zones.
    ///
    /// # Errors
    /// Those of the zone, as for [`Zones::from_start_and_length`] and [`Zones::union`].
    pub fn mean_zero_on(zones: impl Given<Zones>) -> Result<Self> {
        Ok(Self::on_zones(&zones.given()?, Condition::MeanZero))
    }

    /// The constraint u = 0 on the zones.
    ///
    /// # Errors
    /// Those of the zone; [`Error::OutOfRange`] for the whole interval, on which only u = 0 remains.
    pub fn vanishing_on(zones: impl Given<Zones>) -> Result<Self> {
        let zones = zones.given()?;
        let found = Self::on_zones(&zones, Condition::Vanishing);
        let leaves = !found.is_whole();
        Error::require("theta", zones.length(), "(0, 1) for the constraint u = 0", leaves)?;
        Ok(found)
    }

    /// The constraint u(x) = 0, for orders above 1/2 (Remark 6).
    ///
    /// ```
    /// use fractional_sobolev::{Constraint, gamma};
    /// let [end, middle] = [0.0, 0.5].map(|x| gamma(0.75, Constraint::vanishing_at(x), 1e-4));
    /// assert!(middle?.constant.value < end?.constant.value);
    /// assert!(gamma(0.5, Constraint::vanishing_at(0.0), 1e-4).is_err());
    /// # Ok::<(), fractional_sobolev::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for a point outside [0, 1], and for one in (0, 1e-300).
    pub fn vanishing_at(x: f64) -> Result<Self> {
        let inside = x == 0.0 || (1e-300..=1.0).contains(&x);
        Ok(Self::at_point(Error::require("point", x, "{0} or [1e-300, 1]", inside)?))
    }

    /// The shortest positive length.
    pub(crate) fn shortest(&self) -> f64 {
        self.parts.iter().copied().filter(|&l| l > 0.0).fold(1.0, f64::min)
    }

    /// True if the condition is imposed on the whole interval.
    pub(crate) fn is_whole(&self) -> bool {
        self.parts.len() == 1
    }

    /// True if the condition is imposed at a point.
    pub(crate) fn is_point(&self) -> bool {
        self.parts[self.zones[0]] == 0.0
    }

    pub(crate) fn on_zones(zones: &Zones, condition: Condition) -> Self {
        let (parts, zones) = zones.parts();
        Self { parts, zones, condition }
    }

    /// The constraint u(a) = 0.
    pub(crate) fn at_point(a: f64) -> Self {
        let before = usize::from(a > 0.0);
        let mut parts = vec![a, 0.0, 1.0 - a];
        parts.retain(|&l| l > 0.0);
        parts.insert(before, 0.0);
        Self { parts, zones: vec![before], condition: Condition::Vanishing }
    }
}

impl Given<Constraint> for Constraint {
    fn given(self) -> Result<Constraint> {
        Ok(self)
    }
}

impl Given<Constraint> for &Constraint {
    fn given(self) -> Result<Constraint> {
        Ok(self.clone())
    }
}

impl Given<Constraint> for Result<Constraint> {
    fn given(self) -> Result<Constraint> {
        self
    }
}
