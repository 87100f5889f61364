//! Numerical utilities of the contact library: sums, scales, searches, checks of input, conjugate gradients, double-double.
//!
//! Functions that are private in the toolkit are compiled from its source files.

#[path = "../../toolkit/src/numeric/check.rs"]
pub(crate) mod check;
#[path = "../../toolkit/src/numeric/conjugate_gradients.rs"]
pub(crate) mod conjugate_gradients;
#[allow(dead_code, reason = "one function of the toolkit's file is used")]
#[path = "../../toolkit/src/numeric/legendre.rs"]
pub(crate) mod legendre;
#[path = "../../toolkit/src/numeric/memory.rs"]
pub(crate) mod memory;
pub(crate) mod real;
pub(crate) mod scale;
#[path = "../../toolkit/src/numeric/search.rs"]
pub(crate) mod search;
#[path = "../../toolkit/src/numeric/sum.rs"]
pub(crate) mod sum;

use crate::error::ToolkitError as Error;
