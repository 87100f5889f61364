//! Norms on polygonal curves: Slobodeckij norms with the distance in the plane, and their dual norms.

mod along;
mod curve;
mod dual;
mod formula;
mod function;
mod load;
mod pairs;

pub use curve::Curve;
pub(crate) use formula::CurveFormula;
pub(crate) use function::BoundaryFunction;
