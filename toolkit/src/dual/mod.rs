//! Dual norms, sup ⟨f, v⟩ / ||v||: the one place where all of them are named.
//!
//! `dual_norm` is dual to `norm` of the same type, with the same arguments: the order ν of the space whose dual
//! is meant (the norm of H^{−ν}) and a tolerance.
//!
//! | ⟨f, v⟩ | supremum over | here |
//! | --- | --- | --- |
//! | ∫ f v, f a piecewise polynomial, up to 10⁵ elements | H^ν(I), (1.1) | [`PiecewisePolynomial::dual_norm`] |
//! | ∫ f v, f a closure with declared breaks | the same | [`SingularFunction::dual_norm`] |
//! | ∫ f v, f by name | the same | [`GalleryFunction::dual_norm`] |
//! | ∫ (u − u_h) v | the same | [`FieldError::dual_norm`] |
//! | the same four, in interpolation spaces | what [`DualOf`] names | `dual_norm_in` |
//! | f by its values on hats | the piecewise linears of the mesh, (1.1) | [`MeshFunctional::dual_norm`] |
//! | ∫_Γ f v on the boundary of a polygon | H^ν(Γ) | [`BoundaryFunction::dual_norm`] |
//!
//! Two suprema of other kinds have names of their own: the largest mean beside the seminorm, under a condition,
//! [`crate::poincare::largest_mean`]; moments under a condition, [`crate::poincare::moment_norm`]. In the plane no
//! dual norm is offered.
//!
//! [`PiecewisePolynomial::dual_norm`]: super::PiecewisePolynomial::dual_norm
//! [`SingularFunction::dual_norm`]: super::SingularFunction::dual_norm
//! [`GalleryFunction::dual_norm`]: super::GalleryFunction::dual_norm
//! [`FieldError::dual_norm`]: super::FieldError::dual_norm
//! [`BoundaryFunction::dual_norm`]: super::BoundaryFunction::dual_norm

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
pub use on_mesh::MeshFunctional;
