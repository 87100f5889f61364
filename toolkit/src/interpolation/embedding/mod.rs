//! (3.6), (3.10), (4.12), (E3): the constants of H^ν(0,1) ⊂ L^q(0,1) and of H^{3/2}(0,1) ⊂ C^{0,α}, from both
//! sides.

mod hoelder;
mod trial;
mod upper;

pub use hoelder::EndIncrements;
pub use trial::{EMBEDDING_GROWTH, EmbeddingSpace, EmbeddingTrial};
pub use upper::{critical_exponent, embedding_upper_bound};
