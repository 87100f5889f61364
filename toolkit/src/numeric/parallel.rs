//! Parallel maps. The loops are compiled once per type of value, not once per loop body: a task takes
//! microseconds, so that a call through a pointer is negligible.

use rayon::prelude::*;

/// f(0), …, f(count − 1), in order.
pub(crate) fn map<T: Send>(count: usize, f: &(dyn Fn(usize) -> T + Sync)) -> Vec<T> {
    map_together(count, 1, f)
}

/// As [`map`], with at least `together` consecutive items per thread.
pub(crate) fn map_together<T: Send>(
    count: usize,
    together: usize,
    f: &(dyn Fn(usize) -> T + Sync),
) -> Vec<T> {
    (0..count).into_par_iter().with_min_len(together).map(f).collect()
}

/// The values of f for every item, in order.
pub(crate) fn over<I: Sync, T: Send>(items: &[I], f: impl Fn(&I) -> T + Sync) -> Vec<T> {
    map(items.len(), &|k| f(&items[k]))
}

/// Calls f(k, k-th piece) for the pieces of `size` values; the last piece may be shorter.
pub(crate) fn pieces<T: Send>(values: &mut [T], size: usize, f: &(dyn Fn(usize, &mut [T]) + Sync)) {
    values.par_chunks_mut(size).enumerate().for_each(|(k, piece)| f(k, piece));
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_order_is_kept() {
        let squares: Vec<usize> = (0..1000).map(|k| k * k).collect();
        assert_eq!(map(1000, &|k| k * k), squares);
        assert_eq!(over(&squares, |k| k + 1).last(), Some(&(999 * 999 + 1)));
        let mut values = vec![0; 10];
        pieces(&mut values, 4, &|k, piece| piece.fill(k));
        assert_eq!(values, [0, 0, 0, 0, 1, 1, 1, 1, 2, 2]);
    }
}
