//! The exact projection onto a cone B p ≤ g, in O(n).
//!
//! Nodal: p_i = min(z_i, g_i). Midpoint, minimise ½ Σ d_i (p_i − z_i)² over p_i + p_{i+1} ≤ 2 g_i on a chain:
//! with F_i(t) the least cost of the nodes up to i when p_i = t, and m_i its minimiser,
//!
//! F_{i+1}(t) = ½ d_{i+1} (t − z_{i+1})² + F_i(min(2 g_i − t, m_i)).
//!
//! F_i' is increasing and piecewise linear; a step truncates its positive part, reflects it and adds d (t − z)
//! (module `derivative`). In the backward pass p_n = m_n and p_i = min(m_i, 2 g_i − p_{i+1}); the constraint is
//! active where the second term is smaller. Fixed nodes stay at 0: a new chain begins after each of them, with a hard
//! upper bound.
//!
//! A closed edge is cut at a segment that is inactive in the projection; if the projection of the chain
//! satisfies the omitted constraint, it is the projection. If no segment is inactive, p_i + p_{i+1} = 2 g_i
//! for all i.

use super::derivative::Derivative;
use super::edge_cone::{EdgeCone, Ends};
use super::kind::Cone;

impl EdgeCone {
    /// The point of { B p ≤ 0 } nearest to z, and the constraints active there.
    pub(crate) fn nearest(self, z: &[f64]) -> (Vec<f64>, Vec<bool>) {
        match (self.kind(), self.ends()) {
            (Cone::Nodal, _) => {
                (z.iter().map(|v| v.min(0.0)).collect(), z.iter().map(|&v| v > 0.0).collect())
            }
            (Cone::Midpoint, ends) => {
                let plain = Weighted { weight: |_| 1.0, bound: |_| 0.0, is_fixed: |_| false };
                match ends {
                    Ends::Open => project_weighted(z, &plain),
                    Ends::Joined => project_ring(z, &plain, deepest(z)),
                }
            }
        }
    }
}

/// The node with the smallest value, where a segment is probably inactive.
fn deepest(z: &[f64]) -> usize {
    (0..z.len()).min_by(|&a, &b| z[a].total_cmp(&z[b])).unwrap_or(0)
}

/// The data of a weighted projection along a chain: d > 0, g (one entry less), and the nodes fixed at 0.
pub(crate) struct Weighted<W, G, F> {
    pub(crate) weight: W,
    pub(crate) bound: G,
    pub(crate) is_fixed: F,
}

/// Projects z onto p_i + p_{i+1} ≤ 2 g_i along a chain in the norm with weights d; returns p and the n − 1
/// active flags.
///
/// The minimiser of ½ Σ_i d_i (p_i − z_i)²: with λ ≥ 0 on the segments, d_i (z_i − p_i) = λ_{i−1} + λ_i and
/// λ_i (p_i + p_{i+1} − 2 g_i) = 0. Two passes, forwards for the m_i and backwards for the p_i; O(n).
pub(crate) fn project_weighted<W, G, F>(
    z: &[f64],
    data: &Weighted<W, G, F>,
) -> (Vec<f64>, Vec<bool>)
where
    W: Fn(usize) -> f64,
    G: Fn(usize) -> f64,
    F: Fn(usize) -> bool,
{
    let n = z.len();
    if n == 0 {
        return (Vec::new(), Vec::new());
    }
    let mut p = minimisers(z, data);
    let mut active = vec![false; n - 1];
    for i in (0..n - 1).rev() {
        let allowed = 2.0 * (data.bound)(i) - p[i + 1];
        active[i] = allowed < p[i];
        if (data.is_fixed)(i) {
            // A node pressed against the hard bound of a fixed left neighbour touches it with equality.
            active[i] |= !(data.is_fixed)(i + 1) && p[i + 1] >= 2.0 * (data.bound)(i);
        } else if active[i] {
            p[i] = allowed;
        }
    }
    (p, active)
}

/// m_i for every i; 0 at fixed nodes.
///
/// m_i is the zero of the increasing function F_i'(t) = d_i (t − z_i) − min(F_{i−1}'(2 g_{i−1} − t), 0).
fn minimisers<W, G, F>(z: &[f64], data: &Weighted<W, G, F>) -> Vec<f64>
where
    W: Fn(usize) -> f64,
    G: Fn(usize) -> f64,
    F: Fn(usize) -> bool,
{
    let mut derivative = Derivative::flat();
    let mut minimisers = Vec::with_capacity(z.len());
    // For the first node of a chain; the nodes after it are bounded through the derivative.
    let mut limit = Some(f64::INFINITY);
    for (i, &value) in z.iter().enumerate() {
        if (data.is_fixed)(i) {
            derivative = Derivative::flat();
            limit = Some(if i + 1 < z.len() { 2.0 * (data.bound)(i) } else { f64::INFINITY });
            minimisers.push(0.0);
            continue;
        }
        let minimiser = match limit.take() {
            Some(limit) => {
                derivative.add((data.weight)(i), value);
                derivative.cut_first(limit)
            }
            None => {
                derivative.reflect(2.0 * (data.bound)(i - 1));
                derivative.add((data.weight)(i), value);
                derivative.cut()
            }
        };
        minimisers.push(minimiser);
    }
    minimisers
}

/// Largest number of cuts tried on a closed edge; two or three are typical unless nearly all constraints
/// are active.
const TRIES: usize = 32;

/// The constraints active at the projection on a closed edge in the norm with weights d.
///
/// The same conditions with indices modulo n; all segments are active on a closed edge entirely in contact.
pub(crate) fn active_on_ring<W, G, F>(z: &[f64], data: &Weighted<W, G, F>) -> Vec<bool>
where
    W: Fn(usize) -> f64,
    G: Fn(usize) -> f64,
    F: Fn(usize) -> bool,
{
    project_ring(z, data, deepest(z)).1
}

/// Projects z onto the cone of a closed edge (x_{n−1} + x_0 ≤ 2 g_{n−1} as well); returns x and the n
/// active flags.
///
/// `cut` is a segment that is probably inactive. After the tries allowed, all constraints are taken as
/// active, which is the projection whenever none can be left out. Cost: O(n) for each try.
fn project_ring<W, G, F>(z: &[f64], data: &Weighted<W, G, F>, cut: usize) -> (Vec<f64>, Vec<bool>)
where
    W: Fn(usize) -> f64,
    G: Fn(usize) -> f64,
    F: Fn(usize) -> bool,
{
    let n = z.len();
    let mut cut = cut % n.max(1);
    let mut tried = vec![false; n];
    for _ in 0..TRIES.min(n) {
        tried[cut] = true;
        // Segment `cut` joins node `cut` and the next one: the chain starts there.
        let at = |i: usize| (cut + 1 + i) % n;
        let turned: Vec<f64> = (0..n).map(|i| z[at(i)]).collect();
        let (x, active) = project_weighted(
            &turned,
            &Weighted {
                weight: |i| (data.weight)(at(i)),
                bound: |i| (data.bound)(at(i)),
                is_fixed: |i| (data.is_fixed)(at(i)),
            },
        );
        let back = |i: usize| (i + n - (cut + 1) % n) % n;
        if x[n - 1] + x[0] <= 2.0 * (data.bound)(cut) {
            // The multipliers on a closed edge are determined up to ±c; those of the chain vanish at the cut.
            let closed = (0..n).all(|i| x[i] + x[(i + 1) % n] == 2.0 * (data.bound)(at(i)));
            let flags = (0..n).map(|s| closed || (s != cut && active[back(s)])).collect();
            return ((0..n).map(|i| x[back(i)]).collect(), flags);
        }
        let slack = |s: usize| x[back(s)] + x[back((s + 1) % n)] - 2.0 * (data.bound)(s);
        let next = (0..n).filter(|&s| !tried[s]).min_by(|&a, &b| slack(a).total_cmp(&slack(b)));
        match next {
            Some(segment) => cut = segment,
            None => break,
        }
    }
    (sawtooth(z, data), vec![true; n])
}

/// The nearest x with x_i + x_{i+1} = 2 g_i on the closed edge: x = o ± q; no q is free for an odd number
/// of nodes.
///
/// o_0 = 0, o_{i+1} = 2 g_i − o_i; for an even number of nodes q = Σ_i d_i (−1)^i (z_i − o_i) / Σ_i d_i,
/// the weighted least squares fit; on a closed edge with an odd number of nodes the closing condition gives
/// q = g_{n−1} − o_{n−1}/2.
fn sawtooth<W, G, F>(z: &[f64], data: &Weighted<W, G, F>) -> Vec<f64>
where
    W: Fn(usize) -> f64,
    G: Fn(usize) -> f64,
    F: Fn(usize) -> bool,
{
    let n = z.len();
    let sign = |i: usize| if i.is_multiple_of(2) { 1.0 } else { -1.0 };
    let mut offset = vec![0.0; n];
    for i in 1..n {
        offset[i] = 2.0 * (data.bound)(i - 1) - offset[i - 1];
    }
    let q = if n % 2 == 1 {
        (data.bound)(n - 1) - 0.5 * offset[n - 1]
    } else {
        let shares = (0..n).map(|i| (data.weight)(i) * sign(i) * (z[i] - offset[i]));
        shares.sum::<f64>() / (0..n).map(&data.weight).sum::<f64>().max(f64::MIN_POSITIVE)
    };
    (0..n).map(|i| offset[i] + sign(i) * q).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Numbers in (0, 1) of a linear congruential generator.
    fn random(seed: u64) -> impl FnMut() -> f64 {
        let mut state = seed;
        move || {
            state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            ((state >> 33) as f64 + 0.5) / (1u64 << 31) as f64
        }
    }

    #[test]
    fn weighted_ring_projection_is_optimal() {
        let (mut random, mut proved) = (random(3), 0);
        for _ in 0..256 {
            let n = 3 + (37.0 * random()) as usize;
            let z: Vec<[f64; 3]> = (0..n)
                .map(|_| [2.0 * random() - 1.0, 0.5 + 1.5 * random(), 0.4 * random() - 0.2])
                .collect();
            let data = Weighted {
                weight: |i: usize| z[i][1],
                bound: |i: usize| z[i][2],
                is_fixed: |_| false,
            };
            let values: Vec<f64> = z.iter().map(|z| z[0]).collect();
            let (x, active) = project_ring(&values, &data, 0);
            let slack = |s: usize| x[s] + x[(s + 1) % n] - 2.0 * z[s][2];
            // All round even rings have a solution for compatible bounds only.
            let Some(cut) = active.iter().position(|a| !a) else { continue };
            assert!(
                (0..n).all(|s| slack(s) <= 1e-12 && (!active[s] || slack(s) > -1e-12)),
                "{z:?}"
            );
            // d (z − x) = B'λ from an inactive segment on: λ ≥ 0 proves optimality.
            let mut multiplier = 0.0;
            for i in (0..n).map(|i| (cut + 1 + i) % n) {
                multiplier = z[i][1] * (values[i] - x[i]) - multiplier;
                assert!(
                    multiplier > -1e-10 && (active[i] || multiplier < 1e-10),
                    "{z:?}, {i}: {multiplier}"
                );
            }
            proved += 1;
        }
        assert!(proved > 128, "{proved}");
    }
}
