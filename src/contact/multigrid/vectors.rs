//! Operations on long vectors, in parallel: sums are formed in blocks of fixed length, so that results do not depend
//! on the number of threads.

use rayon::prelude::*;

/// Number of entries of a block.
const PIECE: usize = 1 << 13;

/// Σ a_i b_i.
pub(super) fn dot(a: &[f64], b: &[f64]) -> f64 {
    let pieces: Vec<f64> =
        a.par_chunks(PIECE).zip(b.par_chunks(PIECE)).map(|(a, b)| short_dot(a, b)).collect();
    pieces.into_iter().sum()
}

/// Σ a_i b_i with b in f32.
pub(super) fn dot_mixed(a: &[f64], b: &[f32]) -> f64 {
    let pieces: Vec<f64> =
        a.par_chunks(PIECE).zip(b.par_chunks(PIECE)).map(|(a, b)| short_dot_mixed(a, b)).collect();
    pieces.into_iter().sum()
}

/// max |a_i|; NaN where an entry is.
pub(super) fn largest(a: &[f64]) -> f64 {
    let most = |m: f64, v: f64| if v > m || v.is_nan() { v } else { m };
    let pieces: Vec<f64> = a.par_chunks(PIECE).map(|a| a.iter().fold(0.0, |m, v| most(m, v.abs()))).collect();
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

fn short_dot(a: &[f64], b: &[f64]) -> f64 {
    let mut sums = [0.0; 8];
    let (a, b) = (a.chunks_exact(8), b.chunks_exact(8));
    let rest: f64 = a.remainder().iter().zip(b.remainder()).map(|(a, b)| a * b).sum();
    for (a, b) in a.zip(b) {
        for k in 0..8 {
            sums[k] += a[k] * b[k];
        }
    }
    sums.iter().sum::<f64>() + rest
}

fn short_dot_mixed(a: &[f64], b: &[f32]) -> f64 {
    let mut sums = [0.0; 8];
    let (a, b) = (a.chunks_exact(8), b.chunks_exact(8));
    let rest: f64 = a.remainder().iter().zip(b.remainder()).map(|(a, b)| a * f64::from(*b)).sum();
    for (a, b) in a.zip(b) {
        for k in 0..8 {
            sums[k] += a[k] * f64::from(b[k]);
        }
    }
    sums.iter().sum::<f64>() + rest
}
