//! Appendix B, (4.6), (4.7), Remarks 2 and 4, and the embeddings of Sections 3 and 4: constants of interpolation.
//!
//! | paper | here |
//! | --- | --- |
//! | I^h u, Lagrange interpolation of degree one in one dimension | affine on each element, equal to u at the nodes |
//! | e = u − I^h u, e' = u' − (mean of u' on the element) | everything is written in the slope v = u' |
//! | \|u\|_{1+ν} = \|u'\|_ν | [`crate::sobolev`], double integral over both orders of x and y |
//! | Lemma 6.1: ‖e‖₀ ≤ h^{1+ν} \|u\|_{1+ν}, ‖e‖₁ ≤ h^ν \|u\|_{1+ν} | [`element_constant`] for the best constants in place of 1 |
//! | Lemma 6.1 for one u | [`InterpolationError`], [`power_slope`] |
//! | Lemma 6.2: for one u on a mesh, best constants on a mesh | [`InterpolationError`], [`mesh_constant`] |
//! | functions to try, and an optimiser | [`RoughSlopes`], [`ascend`] |
//! | π^h v, mean on each element; π^h(u') = (I^h u)' | [`ElementMesh`]; (4.6) is the derivative part of Lemma 6.2 for φ = u' |
//! | (4.6), (4.7): best constants, norms on a mesh | [`projection_constant`], [`dual_projection_constant`], [`projection_norm_on_mesh`] |
//! | (4.6), (4.7): their rates for all of H^r, from both sides | [`supremum_rate`], [`wave_constant`] |
//! | Remark 2 | [`AliasedWave`], [`all_waves_mean`] |
//! | ‖·‖_{1/2,*} | [`DualNorm`]: dual to the full norm (1.1) of order 1/2 on the interval |
//! | C(q), C(α) in (3.6), (3.10), (4.12), (E3) | [`embedding_upper_bound`], [`EmbeddingSpace`], [`EndIncrements`] |
//! | limits ν → 0, ν → 1, (6.2) | [`limits`] |
//!
//! All constants are those of the seminorm (1.1) as the paper defines it, on an interval of length h = 1 unless said.

mod aliasing;
mod ascent;
mod dual;
mod element;
mod elements;
mod embedding;
mod forms;
mod global;
mod hoelder;
mod legendre;
pub mod limits;
mod local;
mod projection;
mod rough;
mod samples;
mod supremum;

pub use aliasing::{AliasedWave, all_waves_mean};
pub use ascent::ascend;
pub use dual::DualNorm;
pub use element::{ElementExtremal, ErrorNorm, element_constant, element_extremal, longest_element};
pub use elements::{ElementMesh, lagrange};
pub use embedding::{EmbeddingSpace, EmbeddingTrial, critical_exponent, embedding_upper_bound};
pub use global::mesh_constant;
pub use hoelder::EndIncrements;
pub use local::{InterpolationError, power_slope};
pub use projection::{
    ProjectionNorm, dual_projection_constant, projection_constant, projection_norm_on_mesh,
    sample_projection_dual_error, sample_projection_error,
};
pub use rough::{RoughFamily, RoughSlopes};
pub use samples::SampleSlope;
pub use supremum::{SupremumRate, supremum_rate, wave_constant};
