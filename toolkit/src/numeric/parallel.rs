//! Parallel maps and pieces. Loops are compiled once per type of value, not once per loop body.

pub(crate) use fractional_sobolev_numeric::parallel::{map, map_together, over};
use rayon::prelude::*;

/// Calls f(k, k-th piece) for the pieces of `size` values; the last piece may be shorter.
pub(crate) fn pieces<T: Send>(values: &mut [T], size: usize, f: &(dyn Fn(usize, &mut [T]) + Sync)) {
    values.par_chunks_mut(size).enumerate().for_each(|(k, piece)| f(k, piece));
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_piece_is_filled() {
        let mut values = vec![0; 10];
        pieces(&mut values, 4, &|k, piece| piece.fill(k));
        assert_eq!(values, [0, 0, 0, 0, 1, 1, 1, 1, 2, 2]);
    }
}
