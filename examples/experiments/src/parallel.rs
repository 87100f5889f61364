//! Loops dealt out over threads. The loops are compiled once per kind of value, not once per body: what is
//! dealt out is work of microseconds, beside which a call through a pointer costs nothing.

use rayon::prelude::*;

/// f(0), …, f(count − 1), in order.
pub(crate) fn map<T: Send>(count: usize, f: &(dyn Fn(usize) -> T + Sync)) -> Vec<T> {
    map_together(count, 1, f)
}

/// The same, at least `together` of them in a row on one thread.
pub(crate) fn map_together<T: Send>(
    count: usize,
    together: usize,
    f: &(dyn Fn(usize) -> T + Sync),
) -> Vec<T> {
    (0..count).into_par_iter().with_min_len(together).map(f).collect()
}

/// f of every item, in order.
pub(crate) fn over<I: Sync, T: Send>(items: &[I], f: impl Fn(&I) -> T + Sync) -> Vec<T> {
    map(items.len(), &|k| f(&items[k]))
}
