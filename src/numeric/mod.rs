//! Small numerical tools of the contact code: sums, scales, searches, checks of input.

pub(crate) mod check;
pub(crate) mod conjugate_gradients;
pub(crate) mod legendre;
pub(crate) mod memory;
#[cfg(test)]
pub(crate) mod random;
pub(crate) mod scale;
pub(crate) mod search;
pub(crate) mod sum;
pub(crate) mod text;
