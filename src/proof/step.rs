//! The steps of the ladder.

/// Rungs of a ladder, the consistency term and the final bound included.
pub(crate) const RUNGS: usize = 7;
