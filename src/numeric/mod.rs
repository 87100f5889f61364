//! Small numerical tools of the contact code: sums, scales, searches, checks of input.

pub(crate) mod check;
pub(crate) mod memory;
pub(crate) mod scale;
pub(crate) mod search;
pub(crate) mod sum;
