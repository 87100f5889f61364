//! Dual norms sup ⟨f, v⟩ / ‖v‖, for [`Function::dual_norm`](crate::Function::dual_norm) and norms of
//! negative order.
//!
//! | ⟨f, v⟩ | supremum over | here |
//! | --- | --- | --- |
//! | ∫ f v, f a piecewise polynomial, up to 10⁵ elements | H^ν(I), (1.1) | `regional` |
//! | the same, in interpolation spaces | the spaces of [`DualOf`] | `resolvent` |
//! | ∫ f v, f a formula with breakpoints | both | `closure` |
//! | f given by its values on hat functions | the piecewise linear functions on the mesh, (1.1) | [`MeshFunctional`] |
//!
//! For ∫ (u − u_h) v see `fields`, for ∫_Γ f v on the boundary of a polygon `boundary`. Two related suprema are
//! computed elsewhere: the largest ratio of norm to seminorm under a constraint, [`crate::gamma`], and
//! moments under a constraint, [`crate::moment`]. In the plane there is no method for dual norms.

mod cells;
pub(crate) mod closure;
mod comparison;
mod cosines;
mod functional;
mod missed;
mod on_mesh;
mod regional;
mod resolvent;

pub use functional::DualOf;
pub(crate) use on_mesh::MeshFunctional;
