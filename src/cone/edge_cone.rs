//! The cones of (2.9) and (4.1) on an edge with a given number of nodes: constraints B w, nodal forces B'λ, supports,
//! refinement and feasible steps.
//!
//! On a closed edge the last node is a neighbour of the first. Cost: O(nodes) for every operation.

use super::contact_set::ContactSet;
use super::kind::Cone;
use crate::error::Result;
use crate::numeric::check::require_length;

/// Whether the ends of an edge are joined.
///
/// ```
/// use signorini::cone::{Cone, Ends};
/// // an open edge of n nodes has n − 1 segments, a closed edge n
/// let segments = |ends| Cone::Midpoint.on(6, ends).constraints();
/// assert_eq!((segments(Ends::Open), segments(Ends::Joined)), (5, 6));
/// # Ok::<(), signorini::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Ends {
    /// The edge has a first and a last node: one segment fewer than nodes.
    Open,
    /// The last node is joined to the first by a segment (a periodic or closed edge): as many segments as
    /// nodes.
    Joined,
}

/// The set { w : B w ≤ g } of nodal values w on an edge.
///
/// A closed convex polyhedral set; for g = 0 a cone. The matrix B is never stored.
///
/// | | rows of B | B B' | kernel of B |
/// | --- | --- | --- | --- |
/// | nodal | e_i | I | 0 |
/// | midpoint | (e_i + e_{i+1})/2 | tridiag(1/4, 1/2, 1/4) | the sawtooth (−1)^i; 0 if closed with an odd number of nodes |
///
/// The smallest eigenvalue of the midpoint B B' on an open edge of n nodes is about (π/(2n))²; multipliers are
/// therefore computed by recursion along a contact interval and not from B B'.
///
/// ```
/// use signorini::cone::{Cone, Ends};
/// let cone = Cone::Midpoint.on(5, Ends::Open);
/// // the sawtooth lies in the kernel of B, and constants are reproduced
/// assert_eq!(cone.apply(&[1.0, -1.0, 1.0, -1.0, 1.0]), [0.0; 4]);
/// assert_eq!(cone.apply(&[3.0; 5]), [3.0; 4]);
/// # Ok::<(), signorini::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct EdgeCone {
    cone: Cone,
    nodes: usize,
    ends: Ends,
}

impl Cone {
    /// The cone of this kind on an edge of `nodes` nodes.
    ///
    /// ```
    /// use signorini::cone::{Cone, Ends};
    /// let cone = Cone::Nodal.on(5, Ends::Open);
    /// // the nodal B is the identity
    /// assert_eq!((cone.kind(), cone.nodes(), cone.constraints(), cone.weight()), (Cone::Nodal, 5, 5, 1.0));
    /// # Ok::<(), signorini::Error>(())
    /// ```
    pub const fn on(self, nodes: usize, ends: Ends) -> EdgeCone {
        EdgeCone { cone: self, nodes, ends }
    }

    /// Number of constraints on an open edge of `nodes` nodes.
    ///
    /// Nodal: `nodes`; midpoint: `nodes` − 1.
    pub const fn constraints(self, nodes: usize) -> usize {
        self.on(nodes, Ends::Open).constraints()
    }
}

impl EdgeCone {
    /// The kind of cone.
    pub const fn kind(self) -> Cone {
        self.cone
    }

    /// Number of nodes of the edge.
    pub const fn nodes(self) -> usize {
        self.nodes
    }

    /// Whether the ends of the edge are joined.
    pub const fn ends(self) -> Ends {
        self.ends
    }

    /// Number of constraints: one per node (nodal) or one per segment (midpoint).
    pub const fn constraints(self) -> usize {
        match (self.cone, self.ends) {
            (Cone::Nodal, _) | (Cone::Midpoint, Ends::Joined) => self.nodes,
            (Cone::Midpoint, Ends::Open) => self.nodes.saturating_sub(1),
        }
    }

    /// The vector B w: the nodal values, or the means over the segments. On an open edge this also maps the positions of the
    /// nodes to those of the constraints.
    ///
    /// On a closed edge the last mean is that of the closing segment, (w_{n−1} + w_0)/2. Each value is halved before
    /// the addition, so that no mean of finite values overflows. Cost: O(nodes).
    ///
    /// ```
    /// use signorini::cone::{Cone, Ends};
    /// let w = [1.0, 3.0, -2.0];
    /// assert_eq!(Cone::Midpoint.on(3, Ends::Open).apply(&w), [2.0, 0.5]);
    /// assert_eq!(Cone::Midpoint.on(3, Ends::Joined).apply(&w), [2.0, 0.5, -0.5]);
    /// assert_eq!(Cone::Nodal.on(3, Ends::Open).apply(&w), w);
    /// # Ok::<(), signorini::Error>(())
    /// ```
    pub fn apply(self, w: &[f64]) -> Vec<f64> {
        // Each value is halved first, so that the sum of two huge values does not overflow.
        let mean = |left: f64, right: f64| 0.5 * left + 0.5 * right;
        match self.cone {
            Cone::Nodal => w.to_vec(),
            Cone::Midpoint => {
                let mut means: Vec<f64> = w.windows(2).map(|pair| mean(pair[0], pair[1])).collect();
                if let (Ends::Joined, [first, .., last]) = (self.ends, w) {
                    means.push(mean(*last, *first));
                }
                means
            }
        }
    }

    /// The vector B'λ: the nodal forces that correspond to the multipliers.
    ///
    /// Nodal: (B'λ)_i = λ_i; midpoint: (B'λ)_i = (λ_{i−1} + λ_i)/2, with λ_{−1} = λ_{n−1} = 0 at the ends of an open
    /// edge. The rows of B sum to 1, so that the resultant is preserved: Σ_i (B'λ)_i = Σ_i λ_i = −∫ σ_N.
    ///
    /// ```
    /// use signorini::cone::{Cone, Ends};
    /// let cone = Cone::Midpoint.on(4, Ends::Open);
    /// let (w, multiplier) = ([1.0, -2.0, 4.0, 3.0], [2.0, 1.0, 5.0]);
    /// let force = cone.apply_transposed(&multiplier)?;
    /// // (B w)'λ = w'(B'λ), and the resultant is kept
    /// let product = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    /// assert_eq!(product(&cone.apply(&w), &multiplier), product(&w, &force));
    /// assert_eq!(force.iter().sum::<f64>(), multiplier.iter().sum::<f64>());
    /// # Ok::<(), signorini::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`ToolkitError::LengthMismatch`](crate::ToolkitError::LengthMismatch) unless λ has one entry per constraint.
    pub fn apply_transposed(self, multiplier: &[f64]) -> Result<Vec<f64>> {
        require_length("multiplier", multiplier.len(), self.constraints())?;
        Ok(match self.cone {
            Cone::Nodal => multiplier.to_vec(),
            Cone::Midpoint => {
                let mut force = vec![0.0; self.nodes];
                for (i, &value) in multiplier.iter().enumerate() {
                    force[i] += 0.5 * value;
                    force[self.after(i)] += 0.5 * value;
                }
                force
            }
        })
    }

    /// The nodes of constraint `i`, one node or the two ends of a segment: the columns in which row `i` of B is
    /// nonzero.
    ///
    /// Node i for the nodal cone; nodes i and i + 1 for the midpoint cone, modulo the number of nodes on a closed
    /// edge. Together with [`EdgeCone::weight`] this determines B.
    ///
    /// ```
    /// use signorini::cone::{Cone, Ends};
    /// let ring = Cone::Midpoint.on(4, Ends::Joined);
    /// assert_eq!(ring.support(3).collect::<Vec<_>>(), [3, 0]);
    /// // every row of B sums to 1
    /// assert_eq!(ring.support(3).count() as f64 * ring.weight(), 1.0);
    /// # Ok::<(), signorini::Error>(())
    /// ```
    pub fn support(self, i: usize) -> impl Iterator<Item = usize> {
        let second = match self.cone {
            Cone::Nodal => None,
            Cone::Midpoint => Some(self.after(i)),
        };
        std::iter::once(i).chain(second)
    }

    /// The value of the nonzero entries of B.
    ///
    /// 1 for the nodal cone, 1/2 for the midpoint cone.
    pub const fn weight(self) -> f64 {
        match self.cone {
            Cone::Nodal => 1.0,
            Cone::Midpoint => 0.5,
        }
    }

    /// The refinement of `coarse`, a contact set on the edge with segments twice as long: the constraints of this
    /// edge that lie in it.
    ///
    /// Nodal: an old node keeps its flag, a new node is active if both its neighbours are. Midpoint: both halves of a
    /// segment inherit its flag. The refined set covers the same contact intervals, as subsets of the edge.
    ///
    /// ```
    /// use signorini::cone::{Cone, ContactSet, Ends};
    /// let coarse = ContactSet::new(&[true, true, false]);
    /// let fine = Cone::Nodal.on(5, Ends::Open).refined_set(&coarse)?;
    /// assert_eq!(fine.indices(), [0, 1, 2]);
    /// assert_eq!(Cone::Nodal.on(6, Ends::Joined).refined_set(&coarse)?.indices(), [0, 1, 2]);
    /// assert_eq!(Cone::Midpoint.on(7, Ends::Open).refined_set(&coarse)?.indices(), [0, 1, 2, 3]);
    /// assert!(Cone::Nodal.on(6, Ends::Open).refined_set(&coarse).is_err());
    /// # Ok::<(), signorini::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`ToolkitError::LengthMismatch`](crate::ToolkitError::LengthMismatch) unless bisection of the coarse
    /// edge gives this one.
    pub fn refined_set(self, coarse: &ContactSet) -> Result<ContactSet> {
        let set = coarse.as_slice();
        let given = match (self.cone, self.ends) {
            (Cone::Nodal, Ends::Open) => (2 * set.len()).saturating_sub(1),
            _ => 2 * set.len(),
        };
        require_length("contact set", given, self.constraints())?;
        Ok(ContactSet::new(&match self.cone {
            // Coarse nodes and, between two active ones, the new node.
            Cone::Nodal => {
                (0..given).map(|i| set[i / 2] && set[i.div_ceil(2) % set.len()]).collect::<Vec<_>>()
            }
            Cone::Midpoint => set.iter().flat_map(|&active| [active; 2]).collect::<Vec<_>>(),
        }))
    }

    /// The largest t ≤ 1 with w + t (v − w) in the cone B w ≤ 0, for w in the cone; the constraints in `active` hold
    /// with equality at both w and v.
    ///
    /// t = min(1, min { s_i / (s_i − v_i) : v_i > 0 }) with s = B w ≤ 0 and v = B v: the ratio test over the inactive
    /// constraints. J decreases along the step if v minimises J on the face.
    pub(crate) fn longest_step(self, w: &[f64], v: &[f64], active: &[bool]) -> f64 {
        let (here, there) = (self.apply(w), self.apply(v));
        let mut longest: f64 = 1.0;
        for i in 0..here.len() {
            if !active[i] && there[i] > 0.0 {
                longest = longest.min((here[i] / (here[i] - there[i])).max(0.0));
            }
        }
        longest
    }

    /// The right end of segment `i`.
    pub(super) fn after(self, i: usize) -> usize {
        if self.ends == Ends::Joined && i + 1 == self.nodes { 0 } else { i + 1 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn transposed_is_the_adjoint() {
        let w = [0.5, -1.0, 2.0, 0.25];
        for cone in Cone::ALL {
            for edge in [Ends::Open, Ends::Joined].map(|ends| cone.on(4, ends)) {
                let multiplier: Vec<f64> =
                    (0..edge.constraints()).map(|i| 1.0 + i as f64).collect();
                let means = edge.apply(&w);
                let left: f64 = means.iter().zip(&multiplier).map(|(a, b)| a * b).sum();
                let force = edge.apply_transposed(&multiplier).unwrap();
                let right: f64 = force.iter().zip(&w).map(|(a, b)| a * b).sum();
                assert_eq!(left, right, "{edge:?}");
                for i in 0..edge.constraints() {
                    let row: f64 = edge.support(i).map(|node| edge.weight() * w[node]).sum();
                    assert_eq!(row, means[i], "{edge:?} {i}");
                }
                assert!(edge.apply_transposed(&[1.0; 7]).is_err());
            }
        }
    }
}
