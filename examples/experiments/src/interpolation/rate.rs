//! The order of h between the two finer of three meshes, as an estimate.

use fractional_sobolev::{Error, Estimate, Result, Work};
use signorini::rates::ConvergenceOrder;

/// [`ConvergenceOrder::of_last`] for meshes given with their numbers of elements, coarsest first.
///
/// # Errors
/// [`Error::CountOutOfRange`] unless the numbers of elements rise; the same for norms that vanish.
pub(super) fn last_order(meshes: [(usize, Estimate); 3]) -> Result<Estimate> {
    let points = meshes.map(|(n, norm)| (1.0 / n as f64, norm));
    let none = Error::CountOutOfRange { name: "elements", value: meshes[2].0, range: "rising, >= 1" };
    let found = ConvergenceOrder::of_last(&points).ok_or(none)?;
    let work = meshes[1..].iter().fold(Work::default(), |sum, mesh| sum + mesh.1.work);
    Estimate::new(found.order, found.uncertainty, work)
}
