//! Parallel maps. The loop over threads is compiled once, not once per type of value or loop body: a task takes
//! microseconds, so that calls through pointers and one lock per piece are negligible.

use std::sync::{Mutex, PoisonError};

use rayon::prelude::*;

/// Largest number of pieces into which a map is divided.
const PIECES: usize = 1024;

/// f(0), …, f(count − 1), in order.
pub fn map<T: Send>(count: usize, f: &(dyn Fn(usize) -> T + Sync)) -> Vec<T> {
    map_together(count, 1, f)
}

/// As [`map`], with at least `together` consecutive items per thread.
pub fn map_together<T: Send>(
    count: usize,
    together: usize,
    f: &(dyn Fn(usize) -> T + Sync),
) -> Vec<T> {
    let size = together.max(count.div_ceil(PIECES)).max(1);
    if count <= size {
        return (0..count).map(f).collect();
    }
    let pieces: Vec<Mutex<Vec<T>>> =
        (0..count.div_ceil(size)).map(|_| Mutex::new(Vec::new())).collect();
    for_each(pieces.len(), &|piece| {
        let values = (piece * size..count.min((piece + 1) * size)).map(f).collect();
        *pieces[piece].lock().unwrap_or_else(PoisonError::into_inner) = values;
    });
    let mut values = Vec::with_capacity(count);
    for piece in pieces {
        values.append(&mut piece.into_inner().unwrap_or_else(PoisonError::into_inner));
    }
    values
}

/// The values of f for every item, in order.
pub fn over<I: Sync, T: Send>(items: &[I], f: impl Fn(&I) -> T + Sync) -> Vec<T> {
    map(items.len(), &|k| f(&items[k]))
}

fn for_each(count: usize, f: &(dyn Fn(usize) + Sync)) {
    (0..count).into_par_iter().for_each(f);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_order_is_kept() {
        for count in [0, 1, 2, 1000, 1024, 1025, 5000] {
            let squares: Vec<usize> = (0..count).map(|k| k * k).collect();
            assert_eq!(map(count, &|k| k * k), squares);
            for together in [1, 7, 256, 6000] {
                assert_eq!(map_together(count, together, &|k| k * k), squares);
            }
            assert_eq!(over(&squares, |k| k + 1).last().copied(), squares.last().map(|k| k + 1));
        }
    }
}
