//! Rates of convergence: the a priori bounds of the paper, and the observed order of convergence.
//!
//! | | here |
//! | --- | --- |
//! | h^{τ/2−1/4}, (3.1), (3.2), h^{τ−1} | [`Bound`] |
//! | the order p of errors e ~ h^p, with its uncertainty | [`ConvergenceOrder`] |
//! | the order between two levels, without uncertainty | [`order_between`] |

mod bounds;
mod order;
mod posterior;

pub use bounds::Bound;
pub use order::{ConvergenceOrder, order_between};
pub use posterior::ErrorModel;
