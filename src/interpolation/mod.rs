//! Appendix B, (4.6), (4.7), Remarks 2 and 4, and the embeddings of Sections 3 and 4: constants of interpolation.
//!
//! | paper | here |
//! | --- | --- |
//! | I^h u, Lagrange interpolation of degree one in one dimension | affine on each element, equal to u at the nodes |
//! | e = u − I^h u, e' = u' − (mean of u' on the element) | everything is written in the slope v = u' |
//! | \|u\|_{1+ν} = \|u'\|_ν | [`crate::sobolev`], double integral over both orders of x and y |
//! | Lemma 6.1: ‖e‖₀ ≤ h^{1+ν} \|u\|_{1+ν}, ‖e‖₁ ≤ h^ν \|u\|_{1+ν} | [`element_constant`] for the best constants in place of 1 |
//! | Lemma 6.1 for one u | [`LocalError`], [`power_slope`] |
//! | functions to try, and an optimiser | [`RoughSlopes`], [`ascend`] |
//! | limits ν → 0, ν → 1, (6.2) | [`limits`] |
//!
//! All constants are those of the seminorm (1.1) as the paper defines it, on an interval of length h = 1 unless said.

mod ascent;
mod element;
mod legendre;
pub mod limits;
mod local;
mod rough;

pub use ascent::ascend;
pub use element::{ElementExtremal, ErrorNorm, element_constant, element_extremal, longest_element};
pub use local::{LocalError, power_slope};
pub use rough::{RoughFamily, RoughSlopes};
