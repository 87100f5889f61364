//! Section 2 and (4.1): discrete Signorini problems, two cones, two unrelated solvers, one judge.
//!
//! Sign convention of the paper: u_N ≤ g and σ_N ≤ 0 on the contact edge, n outward; multipliers λ ≥ 0 are
//! generalised forces with K u − F + B'λ = 0 and B u ≤ g. [`Cone`], [`ContactSet`], [`Status`] and the judge
//! ([`Evidence`]) know no mesh: they act on a chain of contact unknowns, whatever stands behind it.

mod cone;
mod contact_set;
mod judge;
mod status;

pub use cone::Cone;
pub use contact_set::ContactSet;
pub use judge::{Evidence, Judgement, Margins, NOISE};
pub use status::Status;
