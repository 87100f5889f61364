//! Two-sided energies: the error of a computed contact problem, guaranteed, and a mesh that is fine
//! where it has to be.
//!
//! For v in V with v = u_D on Γ_D and v_N ≤ g on Γ_C, and a symmetric stress q with div q + f = 0
//! in Ω, q n = F on Γ_N, q_T = 0 and q_N ≤ 0 on Γ_C, let J(v) = ½ a(v, v) − l(v) and
//!
//! ```text
//! J*(q) = −½ ∫ q : 𝒜⁻¹q + ∫_{Γ_C} q_N g + ∫_{Γ_D} q n·u_D.
//! ```
//!
//! Then J*(q) ≤ J(u) ≤ J(v), and with |||·||| the energy norm, |||q|||*² = ∫ q : 𝒜⁻¹q,
//!
//! ```text
//! |||u − v|||² + |||σ(u) − q|||*² + 2∫ σ_N(u)(v_N − g) + 2∫ q_N (u_N − g)
//!     = |||σ(v) − q|||*² + 2∫ q_N (v_N − g) = 2 (J(v) − J*(q))
//! ```
//!
//! where every term is at least 0: the right side bounds the error with constant one, and is a sum
//! over triangles and contact segments. Proof: expand the squares; a(u, v − u) − l(v − u) = ∫
//! σ_N(u) (v_N − u_N), ∫ q : ε(v − u) = l(v − u) + ∫ q_N (v_N − u_N), and σ_N(u) (u_N − g) = 0. W.
//! Prager and J. L. Synge, Quart. Appl. Math. 5 (1947), for the principle; I. Hlaváček, Aplikace
//! matematiky 22 (1977), and J. Haslinger and I. Hlaváček, Aplikace matematiky 26 (1981), for
//! unilateral contact.
//!
//! v is the discrete solution, corrected into the cone where it penetrates. q is the best stress of
//! its kind (module `dual`) on the same triangles, or on those of a coarser mesh whose refinement
//! is the mesh of v: a second contact problem, which requires several times the time and memory of
//! the first on the same mesh. What of the load q does not carry is in the bound as oscillation
//! with explicit constants (module `parts`), as is rounding.
//!
//! The verbs: [`Body::enclose`](crate::contact::Body::enclose) on one mesh, [`Refinement`] to a
//! tolerance.

mod boundary_values;
mod dual;
mod element;
mod enclosure;
mod force;
mod own;
mod parts;
mod polynomial;
mod refine;
mod rule;
mod setting;

pub use element::Traction;
pub use enclosure::{Enclosure, Interval};
pub use refine::{Ended, Refinement};
