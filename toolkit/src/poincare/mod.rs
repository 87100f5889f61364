//! Appendix A: the Poincaré constants γ_θ(ν) of Lemma 5.2.
//!
//! γ = sup ‖u‖₀ / |u|_ν over those u ∈ H^ν(0,1), 0 < ν < 1, that have mean zero over a zone or vanish there;
//! the zone, of length θ, is an interval or a union of intervals, [`Zones`]. The seminorm is
//! |u|_ν² = ∬ (u(x) − u(y))² / |x − y|^{1+2ν} dx dy over the whole square. The paper bounds γ by θ^{ν−1/2}, ln(1/θ),
//! C in (5.1)-(5.3); [`gamma`] computes it, for zones down to 1e-300. [`law`] describes its growth as the zone
//! shrinks. Moments in place of ‖u‖₀, for functions that vanish on a zone at an end, are computed by [`moment`].

mod bracket;
mod constant;
mod constraint;
mod continuation;
mod discrete;
mod extremal;
mod law;
mod mean;
mod mellin;
mod mesh;
mod moments;
mod rounding;
pub(crate) mod slopes;
mod spaces;
mod two_sided;
mod uniform;
mod zones;

pub use constant::gamma;
pub use constraint::Constraint;
pub use law::{Law, law};
pub use mean::mean_constant;
pub use moments::{Moment, moment};
pub use zones::Zones;
