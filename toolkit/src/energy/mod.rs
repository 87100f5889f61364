//! Double integrals over pairs of cells in O(N log(1/ε)²): near pairs one by one, far pairs by moments.

mod interval;
mod moments;
mod pair_sum;

pub(crate) use interval::{CellEnergies, energy};
pub(crate) use moments::Samples;
pub(crate) use pair_sum::PairSum;
