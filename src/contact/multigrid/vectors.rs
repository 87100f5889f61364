//! Operations on long vectors, in parallel: sums are formed in blocks of fixed length, so that results do not depend
//! on the number of threads.

use crate::fem::inner;
use rayon::prelude::*;

/// Number of entries of a block.
const PIECE: usize = 1 << 13;

/// Σ a_i b_i, b in f64 or in f32.
pub(super) fn dot<T: Into<f64> + Copy + Sync>(a: &[f64], b: &[T]) -> f64 {
    let pieces: Vec<f64> =
        a.par_chunks(PIECE).zip(b.par_chunks(PIECE)).map(|(a, b)| inner(a, b)).collect();
    pieces.into_iter().sum()
}

/// max |a_i|; NaN where an entry is.
pub(super) fn largest(a: &[f64]) -> f64 {
    let most = |m: f64, v: f64| if v > m || v.is_nan() { v } else { m };
    let pieces: Vec<f64> =
        a.par_chunks(PIECE).map(|a| a.iter().fold(0.0, |m, v| most(m, v.abs()))).collect();
    pieces.into_iter().fold(0.0, most)
}

/// a ← a + s b.
pub(super) fn add_scaled(a: &mut [f64], s: f64, b: &[f64]) {
    a.par_chunks_mut(PIECE).zip(b.par_chunks(PIECE)).for_each(|(a, b)| {
        a.iter_mut().zip(b).for_each(|(a, b)| *a += s * b);
    });
}

/// p ← s z + t p with z in f32.
pub(super) fn turn(p: &mut [f64], t: f64, s: f64, z: &[f32]) {
    p.par_chunks_mut(PIECE).zip(z.par_chunks(PIECE)).for_each(|(p, z)| {
        p.iter_mut().zip(z).for_each(|(p, z)| *p = s * f64::from(*z) + t * *p);
    });
}

/// out ← s a in f32.
pub(super) fn rounded(out: &mut [f32], s: f64, a: &[f64]) {
    out.par_chunks_mut(PIECE).zip(a.par_chunks(PIECE)).for_each(|(out, a)| {
        out.iter_mut().zip(a).for_each(|(out, a)| *out = (s * a) as f32);
    });
}

/// a ← b − a.
pub(super) fn subtract_from(a: &mut [f64], b: &[f64]) {
    a.par_chunks_mut(PIECE).zip(b.par_chunks(PIECE)).for_each(|(a, b)| {
        a.iter_mut().zip(b).for_each(|(a, b)| *a = b - *a);
    });
}
