//! The coordinates of a face, w = o + Z q, and the multipliers obtained from the forces on its contact intervals.
//!
//! Along a contact interval of the midpoint cone w_{i+1} = 2 g_i − w_i: one amplitude of the sawtooth
//! (−1)^i, the kernel of B, is free, and none if an end of the interval is fixed. B'λ = r on the interval
//! is the same recursion, λ_i = 2 r_i − λ_{i−1}, started at both ends so that rounding propagates over half
//! the interval only. Where λ is determined only up to a sawtooth (an interval between two fixed ends, a
//! closed edge with an even number of nodes entirely in contact) the λ with the greatest minimum is selected.
//! In the nodal cone w = g and λ = r. Cost O(n).

use super::edge_cone::{EdgeCone, Ends};
use super::face::{Block, Face};
use super::kind::Cone;

/// w = offset + sign · q at every node; no q where the node is determined by the contact set.
///
/// w = o + Z q with Z'Z diagonal and entries 0, ±1: o holds (B o)_i = g_i on the set, and B Z = 0 there.
pub(crate) struct Coordinates {
    pub(crate) offset: Vec<f64>,
    /// Index of the amplitude q, and its sign.
    pub(crate) amplitude: Vec<Option<(usize, f64)>>,
    pub(crate) count: usize,
}

impl Coordinates {
    fn add(&mut self, node: usize) {
        self.amplitude[node] = Some((self.count, 1.0));
        self.count += 1;
    }
}

impl EdgeCone {
    /// Coordinates of { w : (B w)_i = g_i on the set, w = 0 at fixed nodes }; the fixed nodes are end nodes
    /// of an open edge; a closed edge has none. On a closed edge entirely in contact with an even number of
    /// nodes g is assumed to be compatible.
    pub(crate) fn coordinates(self, active: &[bool], bound: &[f64], fixed: &[bool]) -> Coordinates {
        let nodes = self.nodes();
        let mut free =
            Coordinates { offset: vec![0.0; nodes], amplitude: vec![None; nodes], count: 0 };
        for &block in Face::new(self, active).blocks() {
            match (block.is_run, self.kind()) {
                (false, _) => block.nodes(nodes).filter(|&i| !fixed[i]).for_each(|i| free.add(i)),
                (true, Cone::Nodal) => {
                    block
                        .nodes(nodes)
                        .filter(|&i| !fixed[i])
                        .for_each(|i| free.offset[i] = bound[i]);
                }
                (true, Cone::Midpoint) if self.ends() == Ends::Joined => {
                    let list: Vec<usize> = block.nodes(nodes).collect();
                    free.add_ring_sawtooth(&list, bound, active.iter().all(|&a| a));
                }
                (true, Cone::Midpoint) => free.add_sawtooth(block, bound, fixed),
            }
        }
        free
    }

    /// λ on the active constraints from B'λ = `force` there, zero elsewhere; `is_fixed` marks the nodes at
    /// which forces are unknown (end nodes of an open edge).
    pub(crate) fn multipliers(
        self,
        active: &[bool],
        force: &[f64],
        is_fixed: impl Fn(usize) -> bool,
    ) -> Vec<f64> {
        let nodes = self.nodes();
        let mut multiplier = vec![0.0; active.len()];
        if self.kind() == Cone::Nodal {
            for i in (0..nodes).filter(|&i| active[i] && !is_fixed(i)) {
                multiplier[i] = force[i];
            }
            return multiplier;
        }
        let is_ring = self.ends() == Ends::Joined && active.iter().all(|&a| a);
        for run in Face::new(self, active).runs() {
            let list: Vec<usize> = run.nodes(nodes).collect();
            let (Some(&first), Some(&last)) = (list.first(), list.last()) else {
                continue;
            };
            let (from_left, from_right) = (!is_fixed(first), !is_fixed(last));
            let meeting = match (from_left, from_right) {
                _ if is_ring => list.len(),
                (true, true) => list.len() / 2,
                (true, false) => list.len() - 1,
                (false, _) => 0,
            };
            let mut previous = 0.0;
            for &node in &list[..meeting] {
                previous = 2.0 * force[node] - previous;
                multiplier[node] = previous;
            }
            // Between two fixed ends the last segment is left open.
            let open = usize::from(!from_left && !from_right);
            let mut previous = 0.0;
            for pair in list[meeting..].windows(2).rev().skip(open) {
                previous = 2.0 * force[pair[1]] - previous;
                multiplier[pair[0]] = previous;
            }
            if is_ring && nodes % 2 == 1 {
                // λ_{−1} was taken as 0 and is λ_{n−1}.
                let shift = -0.5 * multiplier[nodes - 1];
                shift_sawtooth(&mut multiplier, shift);
            } else if is_ring {
                center_sawtooth(&mut multiplier);
            } else if open == 1 {
                center_sawtooth(&mut multiplier[first..last]);
            }
        }
        multiplier
    }
}

impl Coordinates {
    /// A contact interval of a closed edge; if it is the whole edge, no amplitude is free for an odd number
    /// of nodes.
    fn add_ring_sawtooth(&mut self, run: &[usize], bound: &[f64], whole: bool) {
        let (first, last) = (run[0], run[run.len() - 1]);
        for pair in run.windows(2) {
            self.offset[pair[1]] = 2.0 * bound[pair[0]] - self.offset[pair[0]];
        }
        if whole && run.len() % 2 == 1 {
            let mut start = bound[last] - 0.5 * self.offset[last];
            for &node in run {
                self.offset[node] += start;
                start = -start;
            }
            return;
        }
        self.add(first);
        for pair in run.windows(2) {
            self.amplitude[pair[1]] = self.amplitude[pair[0]].map(|(q, sign)| (q, -sign));
        }
    }

    /// Starts where the value is known: at a fixed end if there is one, otherwise at the left end with a new
    /// amplitude.
    ///
    /// o_{k+1} = 2 g_k − o_k and Z_{k+1} = −Z_k along the interval; between two fixed ends no amplitude is
    /// left, and the last equation may fail.
    fn add_sawtooth(&mut self, run: Block, bound: &[f64], fixed: &[bool]) {
        let (first, last) = (run.start, run.start + run.len - 1);
        if fixed[last] && !fixed[first] {
            for k in (first..last).rev() {
                self.offset[k] = 2.0 * bound[k] - self.offset[k + 1];
            }
            return;
        }
        if !fixed[first] {
            self.add(first);
        }
        for k in (first..last).filter(|&k| !fixed[k + 1]) {
            self.offset[k + 1] = 2.0 * bound[k] - self.offset[k];
            self.amplitude[k + 1] = self.amplitude[k].map(|(q, sign)| (q, -sign));
        }
    }
}

/// Adds ±c, + to the first.
fn shift_sawtooth(multiplier: &mut [f64], c: f64) {
    for (k, value) in multiplier.iter_mut().enumerate() {
        *value += if k % 2 == 0 { c } else { -c };
    }
}

/// Adds ±c so that the smallest even and the smallest odd multiplier are equal.
///
/// The shift c = (min_odd − min_even)/2 maximises min_k (λ_k + (−1)^k c), the least multiplier of the family
/// λ + ker B'.
fn center_sawtooth(multiplier: &mut [f64]) {
    let least = |parity: usize| multiplier.iter().skip(parity).step_by(2).copied().reduce(f64::min);
    let (Some(even), Some(odd)) = (least(0), least(1)) else {
        return;
    };
    shift_sawtooth(multiplier, 0.5 * (odd - even));
}

#[cfg(test)]
mod tests {
    use super::*;

    /// B'λ of a known λ is given back, whichever ends are fixed; up to a sawtooth where both are.
    #[test]
    fn multipliers_are_found_again() {
        let known = [1.0, 3.0, 2.0, 0.5, 4.0];
        let edge = Cone::Midpoint.on(6, Ends::Open);
        let force = edge.apply_transposed(&known).unwrap();
        for fixed in 0..3_usize {
            let is_fixed = |node: usize| node == 0 && fixed & 1 == 1 || node == 5 && fixed & 2 == 2;
            let found = edge.multipliers(&[true; 5], &force, is_fixed);
            assert_eq!(found, known, "{fixed}");
        }
        let centred = edge.multipliers(&[true; 5], &force, |node| node == 0 || node == 5);
        let shift = centred[0] - known[0];
        for (k, (value, known)) in centred.iter().zip(known).enumerate() {
            assert_eq!(*value, known + if k % 2 == 0 { shift } else { -shift });
        }
        let odd = Cone::Midpoint.on(5, Ends::Joined);
        let force = odd.apply_transposed(&known).unwrap();
        assert_eq!(odd.multipliers(&[true; 5], &force, |_| false), known);
        let ring = Cone::Midpoint.on(4, Ends::Joined);
        let force = ring.apply_transposed(&[1.0, 3.0, 2.0, 4.0]).unwrap();
        assert_eq!(ring.multipliers(&[true; 4], &force, |_| false), [2.0, 2.0, 3.0, 3.0]);
    }
}
