//! The exact Euclidean projection onto { x : x_i + x_{i+1} ≤ 0 } along a chain or a ring, in O(n).
//!
//! Dynamic programming: f_i(t) = min of ½ Σ_{j≤i} (x_j − z_j)² over admissible x_0, ..., x_i = t. With the constraint,
//! f_{i+1}(t) = ½ (t − z_{i+1})² + f_i(min(−t, m_i)), m_i = argmin f_i. The derivative f_i' is increasing and piecewise
//! linear; a step cuts its positive part off, reflects it and adds t − z. Pieces are kept in a deque in coordinates that
//! absorb reflection and addition, so that each is created and removed once. Backwards: x_n = m_n, x_i = min(m_i, −x_{i+1});
//! the constraint is active where the second is smaller.
//!
//! On a ring a segment that is inactive in the projection is a place to cut; the chain projection that satisfies
//! the constraint left out is the projection.

use std::collections::VecDeque;

/// On t in a piece (between its neighbours' breakpoints): derivative (slope + count)·t + (intercept + shift).
#[derive(Clone, Copy)]
struct Piece {
    /// Left end in stored coordinates.
    left: f64,
    slope: f64,
    intercept: f64,
}

/// Projects z onto the chain cone; returns x and the active flags of the n − 1 segments.
pub(crate) fn project_chain(z: &[f64]) -> (Vec<f64>, Vec<bool>) {
    let n = z.len();
    if n == 0 {
        return (Vec::new(), Vec::new());
    }
    let minima = minima(z);
    let mut x = vec![0.0; n];
    let mut active = vec![false; n - 1];
    x[n - 1] = minima[n - 1];
    for i in (0..n - 1).rev() {
        active[i] = -x[i + 1] < minima[i];
        x[i] = minima[i].min(-x[i + 1]);
    }
    (x, active)
}

/// m_i = argmin f_i for every i.
fn minima(z: &[f64]) -> Vec<f64> {
    // Stored coordinate t' = σ t and stored derivative D = σ f'; adding t − z to f' adds t' − σ z to D.
    let mut pieces: VecDeque<Piece> = VecDeque::new();
    pieces.push_back(Piece { left: f64::NEG_INFINITY, slope: 0.0, intercept: 0.0 });
    let (mut sigma, mut count, mut shift) = (1.0, 0.0, 0.0);
    let mut minima = Vec::with_capacity(z.len());
    for (i, &value) in z.iter().enumerate() {
        if i > 0 {
            sigma = -sigma;
        }
        count += 1.0;
        shift -= sigma * value;
        let zero = if sigma > 0.0 {
            cut_right(&mut pieces, count, shift)
        } else {
            cut_left(&mut pieces, count, shift)
        };
        minima.push(sigma * zero);
    }
    minima
}

/// Removes D > 0 at the right end, puts zero there, returns where D vanishes.
fn cut_right(pieces: &mut VecDeque<Piece>, count: f64, shift: f64) -> f64 {
    let mut zero = f64::NEG_INFINITY;
    while let Some(&piece) = pieces.back() {
        zero = -(piece.intercept + shift) / (piece.slope + count);
        if zero >= piece.left {
            break;
        }
        zero = piece.left;
        pieces.pop_back();
    }
    pieces.push_back(Piece { left: zero, slope: -count, intercept: -shift });
    zero
}

/// Removes D < 0 at the left end, puts zero there, returns where D vanishes.
fn cut_left(pieces: &mut VecDeque<Piece>, count: f64, shift: f64) -> f64 {
    let mut zero = f64::INFINITY;
    while let Some(&piece) = pieces.front() {
        let right = pieces.get(1).map_or(f64::INFINITY, |next| next.left);
        zero = -(piece.intercept + shift) / (piece.slope + count);
        if zero <= right {
            if let Some(front) = pieces.front_mut() {
                front.left = zero;
            }
            break;
        }
        zero = right;
        pieces.pop_front();
    }
    pieces.push_front(Piece { left: f64::NEG_INFINITY, slope: -count, intercept: -shift });
    zero
}

/// Projects z onto the ring cone (x_{n−1} + x_0 ≤ 0 as well); returns x and the n active flags.
///
/// `cut` is a segment that is probably inactive. After the tries allowed, all constraints are taken as active, which is the
/// projection whenever none can be left out.
pub(crate) fn project_ring(z: &[f64], cut: usize) -> (Vec<f64>, Vec<bool>) {
    const TRIES: usize = 32;
    let n = z.len();
    let mut cut = cut % n;
    let mut tried = vec![false; n];
    for _ in 0..TRIES.min(n) {
        tried[cut] = true;
        // Segment `cut` joins node `cut` and the next one: the chain starts there.
        let turned: Vec<f64> = (0..n).map(|i| z[(cut + 1 + i) % n]).collect();
        let (x, active) = project_chain(&turned);
        let back = |i: usize| (i + n - (cut + 1) % n) % n;
        if x[n - 1] + x[0] <= 0.0 {
            // A closed ring determines its multipliers up to ±c, and the chain shows those with a zero at the cut.
            let closed = (0..n).all(|i| x[i] + x[(i + 1) % n] == 0.0);
            let flags = (0..n).map(|s| closed || (s != cut && active[back(s)])).collect();
            return ((0..n).map(|i| x[back(i)]).collect(), flags);
        }
        let slack = |s: usize| x[back(s)] + x[back((s + 1) % n)];
        let next = (0..n).filter(|&s| !tried[s]).min_by(|&a, &b| slack(a).total_cmp(&slack(b)));
        match next {
            Some(segment) => cut = segment,
            None => break,
        }
    }
    let mean = (0..n).map(|i| if i % 2 == 0 { z[i] } else { -z[i] }).sum::<f64>() / n as f64;
    let x = (0..n).map(|i| if i % 2 == 0 { mean } else { -mean }).collect();
    (x, vec![true; n])
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// Multipliers of the projection, z − x = B'λ with B w = w_i + w_{i+1}: λ ≥ 0 and complementary proves optimality.
    fn chain_defect(z: &[f64], x: &[f64]) -> f64 {
        let (mut multiplier, mut worst) = (0.0, 0.0f64);
        for i in 0..z.len() {
            let next = z[i] - x[i] - multiplier;
            if i + 1 == z.len() {
                return worst.max(next.abs());
            }
            let gap = x[i] + x[i + 1];
            worst = worst.max(gap).max(-next).max((next * gap).abs());
            multiplier = next;
        }
        worst
    }

    proptest! {
        #[test]
        fn chain_projection_is_optimal(z in prop::collection::vec(-1.0f64..1.0, 1..200)) {
            let (x, _) = project_chain(&z);
            prop_assert!(chain_defect(&z, &x) < 1e-11);
        }

        #[test]
        fn ring_projection_is_the_chain_of_many_turns(z in prop::collection::vec(-1.0f64..1.0, 2..20), cut in 0usize..40) {
            prop_assume!(z.len().is_multiple_of(2));
            let (x, active) = project_ring(&z, cut);
            let n = z.len();
            for s in 0..n {
                prop_assert!(x[s] + x[(s + 1) % n] <= 1e-12);
            }
            // Unwinding the ring many times changes the middle turn only if no constraint is inactive.
            if active.iter().any(|a| !a) {
                let unrolled: Vec<f64> = (0..21 * n).map(|i| z[i % n]).collect();
                let (y, _) = project_chain(&unrolled);
                let worst = (0..n).map(|i| (x[i] - y[10 * n + i]).abs()).fold(0.0, f64::max);
                prop_assert!(worst < 1e-10, "{worst}");
            }
        }
    }
}
