//! Norms in the plane of functions given by code that are smooth in each triangle up to declared corner
//! singularities.

mod apart;
mod fan;
mod function;
mod norms;
mod piece;
mod position;
mod radial;
mod side;
mod sums;

pub(crate) use function::SingularPlaneFunction;
pub use position::PlanePosition;
