//! Both sides of Lemmas 6.1 and 6.2 and of (4.6) for one function, given by its slope v = u' (in (4.6): by φ
//! = v).

use super::elements::ElementMesh;
use super::norms::{ROUNDING, error_norms, sample_norms};
use super::sample::{SampleSlope, power_error_norms};
use crate::ErrorExt;
use crate::scale::{power_of_two, unit_of};
use fractional_sobolev::{Error, Given, Result};
use fractional_sobolev::{Estimate, Tolerance, Work};
use fractional_sobolev::{Function, Mesh, Order, closed_forms};

/// The norms in Lemma 6.1 for one function on an interval, or in Lemma 6.2 on a mesh.
///
/// Kept in units of the function: lengths and values divided by powers of two near the length of the interval
/// and near the largest value. The ratios do not depend on either, and neither squares of tiny values nor
/// short elements underflow.
///
/// # Method
///
/// e' = v − v̄ and e(x) = ∫₀^x (v − v̄). A slope on cells as short as 1e-300 is taken as it is; nothing is
/// divided by a cell length. For v = x^a everything is closed:
/// ‖e'‖₀² = a²/((2a+1)(a+1)²),  ‖e‖₀² = 2a²/(3(2a+3)(a+3)(a+1)²).
///
/// ```
/// use experiments::interpolation::{ElementMesh, InterpolationError, SampleSlope, power_slope};
/// use fractional_sobolev::{Order, Mesh, Function, Tolerance};
/// // u = x²/2 on (0, 1), slope x: e = x(x−1)/2, ‖e‖₀² = 1/120, ‖e'‖₀² = 1/12, |u|_{3/2} = 1
/// let order = Order::HALF;
/// let cells = Mesh::uniform(2, 1.0)?;
/// let slope = Function::linears(&cells, &[0.0, 0.5, 1.0])?;
/// let found = InterpolationError::of_slope(&slope, order, Tolerance::balanced())?;
/// assert!((found.l2()?.value.powi(2) - 1.0 / 120.0).abs() < 1e-9 && found.h() == 1.0);
/// assert!((found.derivative()?.value.powi(2) - 1.0 / 12.0).abs() < 1e-9);
/// assert!((found.seminorm()?.value - 1.0).abs() < 1e-8);
/// let [l2, derivative, h1] = found.ratios()?.map(|ratio| ratio.value);
/// assert!(l2 == found.l2_ratio()?.value && derivative == found.derivative_ratio()?.value);
/// assert!(h1 == found.h1_ratio()?.value && h1 < 1.0);
/// // in closed form; on two elements; and any number of them for a slope in closed form
/// assert!((power_slope(1.0, order)?.l2()?.value - found.l2()?.value).abs() < 1e-9);
/// let mesh = ElementMesh::uniform(2, 1)?;
/// let halved = InterpolationError::on_elements(&slope, &mesh, order, Tolerance::balanced())?;
/// let sample = InterpolationError::of_sample(SampleSlope::Power(1.0), &cells, order)?;
/// assert!((halved.l2()?.value / sample.l2()?.value - 1.0).abs() < 1e-8);
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct InterpolationError {
    l2: Estimate,
    derivative: Estimate,
    seminorm: Estimate,
    h: f64,
    units: Units,
    order: Order,
}

/// Powers of two: what one unit of length and one of the slope stand for.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Units {
    length: f64,
    slope: f64,
}

impl InterpolationError {
    /// On one element: Lemma 6.1 for the slope v of u.
    ///
    /// # Errors
    /// [`Error::InfiniteNorm`] when v jumps and ν ≥ 1/2; [`Error::ToleranceNotMet`].
    pub fn of_slope(
        slope: &Function<'_>,
        order: impl Given<Order>,
        tolerance: impl Given<Tolerance>,
    ) -> Result<Self> {
        let (order, tolerance) = (order.given()?, tolerance.given()?);
        let (scaled, units) = in_units(slope)?;
        let slope = scaled.as_ref().unwrap_or(slope);
        let seminorm = slope.seminorm(order, tolerance)?;
        let (l2, derivative) = error_norms(slope)?;
        Ok(Self { h: slope.mesh()?.total(), l2, derivative, seminorm, units, order })
    }

    /// On a mesh: Lemma 6.2 for the slope v of u, and (4.6) for φ = v.
    ///
    /// # Errors
    /// As [`InterpolationError::of_slope`]; [`Error::LengthMismatch`] unless v lives on the cells of the
    /// mesh.
    pub fn on_elements(
        slope: &Function<'_>,
        mesh: &ElementMesh,
        order: impl Given<Order>,
        tolerance: impl Given<Tolerance>,
    ) -> Result<Self> {
        let (order, tolerance) = (order.given()?, tolerance.given()?);
        require_cells(mesh, slope)?;
        let (scaled, units) = in_units(slope)?;
        let slope = scaled.as_ref().unwrap_or(slope);
        let seminorm = slope.seminorm(order, tolerance)?;
        let (mut l2, mut derivative) = (Vec::new(), Vec::new());
        for range in mesh.elements() {
            let (error, error_slope) = error_norms(&slope.restrict(range.clone())?)?;
            l2.push(error);
            derivative.push(error_slope);
        }
        let (l2, derivative) = (root_of_squares(&l2)?, root_of_squares(&derivative)?);
        Ok(Self { h: mesh.h() / units.length, l2, derivative, seminorm, units, order })
    }

    /// On a mesh of (0, 1), for a slope in closed form; any number of elements, cost O(N).
    ///
    /// # Errors
    /// [`Error::InfiniteNorm`] when the slope is not in H^ν; [`Error::OutOfRange`] unless the mesh is one of
    /// (0, 1).
    pub fn of_sample(slope: SampleSlope, mesh: &Mesh, order: impl Given<Order>) -> Result<Self> {
        let order = order.given()?;
        let seminorm = slope.seminorm(order)?;
        let (l2, derivative) = sample_norms(slope, mesh)?;
        let h = mesh.lengths().iter().copied().fold(0.0, f64::max);
        Ok(Self { h, l2, derivative, seminorm, units: Units::ONE, order })
    }

    /// Length of the interval, or of the longest element.
    pub fn h(&self) -> f64 {
        self.h * self.units.length
    }

    /// ‖u − I u‖₀.
    ///
    /// # Errors
    /// [`Error::NotFinite`] when it exceeds the range of binary64 (the ratios never do); below the range it
    /// is 0 ± 1e-307.
    pub fn l2(&self) -> Result<Estimate> {
        self.units.restore(self.l2, 1.5)
    }

    /// ‖(u − I u)'‖₀.
    ///
    /// # Errors
    /// As [`InterpolationError::l2`].
    pub fn derivative(&self) -> Result<Estimate> {
        self.units.restore(self.derivative, 0.5)
    }

    /// |u|\_{1+ν} = |v|_ν.
    ///
    /// # Errors
    /// As [`InterpolationError::l2`].
    pub fn seminorm(&self) -> Result<Estimate> {
        self.units.restore(self.seminorm, -self.order.offset())
    }

    /// ‖u − I u‖₀ / (h^{1+ν} |u|\_{1+ν}): at most 1 by the lemma, at most C_L2(ν) in truth.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] when |u|_{1+ν} = 0: for affine u the ratio is 0/0.
    pub fn l2_ratio(&self) -> Result<Estimate> {
        let ratio = self.quotient(self.l2)?;
        Estimate::new(ratio.value / self.h, ratio.error / self.h, ratio.work)
    }

    /// ‖(u − I u)'‖₀ / (h^ν |u|\_{1+ν}): at most C_H1(ν).
    ///
    /// # Errors
    /// As [`InterpolationError::l2_ratio`].
    pub fn derivative_ratio(&self) -> Result<Estimate> {
        self.quotient(self.derivative)
    }

    /// ‖u − I u‖₁ / (h^ν |u|\_{1+ν}) with the full norm: at most C_1(ν, h).
    ///
    /// # Errors
    /// As [`InterpolationError::l2_ratio`]; [`Error::NotFinite`] when the length exceeds the range of
    /// binary64.
    pub fn h1_ratio(&self) -> Result<Estimate> {
        let (l2, derivative) = (self.quotient(self.l2)?, self.quotient(self.derivative)?);
        // The one ratio that depends on the length: ‖e‖₀ carries one unit of it more than ‖e'‖₀.
        let unit = self.units.length;
        let value = (unit * l2.value).hypot(derivative.value);
        Estimate::new(value, unit * l2.error + derivative.error, l2.work)
    }

    /// The three ratios: of ‖u − I u‖₀, of ‖(u − I u)'‖₀ and of ‖u − I u‖₁.
    ///
    /// # Errors
    /// As [`InterpolationError::h1_ratio`].
    pub fn ratios(&self) -> Result<[Estimate; 3]> {
        Ok([self.l2_ratio()?, self.derivative_ratio()?, self.h1_ratio()?])
    }

    fn quotient(&self, part: Estimate) -> Result<Estimate> {
        let seminorm = self.seminorm.value;
        Error::require("|u'|_nu", seminorm, "(0, inf): the ratio of an affine u is 0/0", seminorm > 0.0)?;
        let power = self.h.powf(self.order.value());
        let value = part.value / seminorm / power;
        let relative = self.seminorm.relative_error() + 4.0 * f64::EPSILON;
        let error = part.error / seminorm / power + value * relative;
        Estimate::new(value, error, part.work + self.seminorm.work)
    }
}

impl Units {
    const ONE: Self = Self { length: 1.0, slope: 1.0 };

    /// A norm of the slope that scales like length^exponent.
    fn restore(self, norm: Estimate, exponent: f64) -> Result<Estimate> {
        // Two factors: their product may leave the range of binary64 where the norm itself does not.
        let half = self.length.powf(0.5 * exponent);
        let restored = |x: f64| x * half * self.slope * half;
        let rounding =
            if self == Self::ONE { 0.0 } else { ROUNDING * restored(norm.value) + f64::MIN_POSITIVE };
        Estimate::new(restored(norm.value), restored(norm.error) + rounding, norm.work)
    }
}

/// The slope lives on the cells of the mesh.
fn require_cells(mesh: &ElementMesh, slope: &Function<'_>) -> Result<()> {
    if slope.mesh()?.lengths() == mesh.cells().lengths() {
        return Ok(());
    }
    let (given, expected) = (slope.mesh()?.len(), mesh.cells().len());
    Err(Error::LengthMismatch { name: "cells of the function (lengths must agree)", given, expected })
}

/// The root of the sum of squares, errors weighted by the parts.
fn root_of_squares(parts: &[Estimate]) -> Result<Estimate> {
    let value = parts.iter().fold(0.0, |norm, part| part.value.hypot(norm));
    let mut error = 0.0;
    let mut work = Work::default();
    for part in parts {
        let weight = if value > 0.0 { part.value / value } else { 1.0 };
        error += part.error * weight;
        work += part.work;
    }
    Estimate::new(value, error, work)
}

/// The slope with lengths and values in units near their own size: exact, since the units are powers of two. A slope
/// of degree above one is kept as it is: none.
fn in_units(slope: &Function<'_>) -> Result<(Option<Function<'static>>, Units)> {
    if slope.degree()? > 1 {
        return Ok((None, Units::ONE));
    }
    let (lengths, total) = (slope.mesh()?.lengths(), slope.mesh()?.total());
    let ends = (0..lengths.len()).map(|i| Ok([slope.value(i, 0.0)?, slope.value(i, 1.0)?]));
    let ends = ends.collect::<Result<Vec<[f64; 2]>>>()?;
    let units = Units { length: power_of_two(total), slope: unit_of(ends.iter().flatten()) };
    let partition = Mesh::from_lengths(lengths.iter().map(|h| h / units.length).collect())?;
    let ends: Vec<[f64; 2]> = ends.iter().map(|pair| pair.map(|v| v / units.slope)).collect();
    Ok((Some(Function::piecewise(&partition, 1, ends.as_flattened())?), units))
}

/// The norms of Lemma 6.1 on (0, 1) for u' = x^a, a > ν − 1/2, a > −1/2, by closed forms.
///
/// # Errors
/// [`Error::InfiniteNorm`] for a ≤ ν − 1/2, [`Error::OutOfRange`] for a not finite or above 1e4.
pub fn power_slope(a: f64, order: impl Given<Order>) -> Result<InterpolationError> {
    let order = order.given()?;
    let seminorm = closed_forms::power_seminorm_squared(a, order)?.sqrt()?;
    let (l2, derivative) = power_error_norms(a);
    // 2a + 1 is exact to the rounding of a, which weighs where it is small.
    let relative = ROUNDING + f64::EPSILON * (a / (2.0 * a + 1.0)).abs();
    let estimate = |value: f64| Estimate::new(value, relative * value, Work::default());
    let (l2, derivative) = (estimate(l2)?, estimate(derivative)?);
    Ok(InterpolationError { h: 1.0, l2, derivative, seminorm, units: Units::ONE, order })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_linear_slope_has_the_power_s_norms() {
        let partition = Mesh::geometric(7, 0.3, 1.0).unwrap();
        let nodes = partition.nodes();
        let slope = Function::linears(&partition, &nodes).unwrap();
        for nu in [0.1, 0.5, 0.9] {
            let order = Order::new(nu).unwrap();
            let cells = InterpolationError::of_slope(&slope, order, Tolerance::reference()).unwrap();
            let closed = power_slope(1.0, order).unwrap();
            for (a, b) in [
                (cells.l2().unwrap(), closed.l2().unwrap()),
                (cells.derivative().unwrap(), closed.derivative().unwrap()),
                (cells.seminorm().unwrap(), closed.seminorm().unwrap()),
                (cells.h1_ratio().unwrap(), closed.h1_ratio().unwrap()),
            ] {
                assert!((a.value - b.value).abs() <= a.error + b.error, "{nu}: {a} {b}");
            }
        }
    }

    #[test]
    fn ratios_do_not_depend_on_the_length() {
        let order = Order::new(0.3).unwrap();
        let ratio = |h: f64| {
            let partition = Mesh::from_lengths(vec![0.2 * h, 0.5 * h, 0.3 * h]).unwrap();
            let slope = Function::linears(&partition, &[0.0, 1.0, -1.0, 0.5]).unwrap();
            InterpolationError::of_slope(&slope, order, Tolerance::balanced()).unwrap()
        };
        let unit = ratio(1.0);
        for h in [1e-100, 1e-3, 7.0, 1e100] {
            let scaled = ratio(h);
            for (a, b) in [
                (unit.l2_ratio().unwrap(), scaled.l2_ratio().unwrap()),
                (unit.derivative_ratio().unwrap(), scaled.derivative_ratio().unwrap()),
            ] {
                assert!((a.value - b.value).abs() <= 1e-12 * a.value, "{h}: {a} {b}");
            }
        }
    }

    #[test]
    fn affine_functions_have_no_ratio() {
        let partition = Mesh::uniform(3, 1.0).unwrap();
        let slope = Function::piecewise(&partition, 0, &[2.0; 3]).unwrap();
        let order = Order::new(0.3).unwrap();
        let error = InterpolationError::of_slope(&slope, order, Tolerance::fast()).unwrap();
        assert!(matches!(error.l2_ratio(), Err(Error::OutOfRange { value: 0.0, .. })));
        assert!(matches!(power_slope(0.0, order).unwrap().derivative_ratio(), Err(Error::OutOfRange { .. })));
        assert!(power_slope(-0.2, order).is_err());
    }
}
