//! Parameters given as their type or as plain numbers.

#[cfg(doc)]
use super::Error;
use super::Result;

/// A parameter given as its type or as a plain number: `u.norm(0.5, 1e-8)?`.
///
/// Implemented for orders, tolerances and embedding targets, and for `f64` in their place; for
/// [`Zones`](crate::Zones) and ranges in their place; and for constraints. An order or a tolerance outside
/// its range is [`Error::OutOfRange`].
///
/// ```
/// use fractional_sobolev::{Function, Given, Order, Result, Tolerance};
/// // a function of one's own that takes what the toolkit takes
/// fn energy(
///     u: &Function<'_>,
///     s: impl Given<Order>,
///     tolerance: impl Given<Tolerance>,
/// ) -> Result<f64> {
///     Ok(u.seminorm(s.given()?, tolerance)?.value.powi(2))
/// }
/// let x = Function::from_fn(&[0.0, 1.0], |x| x)?; // |x|² = 1 at order 1/2
/// assert!((energy(&x, 0.5, 1e-8)? - energy(&x, Order::HALF, Tolerance::fast())?).abs() < 1e-4);
/// assert!(energy(&x, 1.5, 1e-8).is_err());
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a plain number or a value for this parameter",
    note = "orders, tolerances and positions are `f64`: write 0.5 (not the integer 1/2 or 0.5_f32); \
            zones are ranges from start to end: 0.2..0.25"
)]
pub trait Given<T> {
    /// The parameter.
    ///
    /// # Errors
    /// [`Error::OutOfRange`].
    fn given(self) -> Result<T>;
}
