//! The two discrete cones of the paper on a chain of contact nodes.
//!
//! With w_i = (u_N)(x_i) at the nodes x_0, ..., x_m of the contact edge, in order, a cone is { w : B w ≤ g }:
//!
//! * nodal (2.9): every node, B w = w, so u_N ≤ g on the whole edge (u_N is piecewise affine);
//! * midpoint (4.1): the mean over every segment, (B w)_i = (w_i + w_{i+1})/2, so u_N may exceed g inside a segment.
//!
//! The multiplier λ ≥ 0 of B w ≤ g is a generalised force: K u + B'λ = F. For the nodal cone λ_i = -∫ σ_N φ_i, for
//! the midpoint cone λ_i = -∫ σ_N over segment i. The kernel of the midpoint B is the sawtooth (-1)^i.
//! Cost: O(m) for every operation.

use super::contact_set::ContactSet;
use crate::error::{Error, Result};
use std::fmt;
use std::str::FromStr;

/// Which discrete noninterpenetration condition.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum Cone {
    /// K^h of (2.9): u_N ≤ g at every node of the contact edge, end nodes included.
    #[default]
    Nodal,
    /// The cone of (4.1): the mean of u_N - g over every contact segment is ≤ 0.
    Midpoint,
}

impl Cone {
    /// Both cones, in the order of the paper.
    pub const ALL: [Cone; 2] = [Cone::Nodal, Cone::Midpoint];

    /// Number of constraints on a chain of `nodes` nodes.
    pub fn constraints(self, nodes: usize) -> usize {
        match self {
            Cone::Nodal => nodes,
            Cone::Midpoint => nodes.saturating_sub(1),
        }
    }

    /// B w: nodal values, or the means over the segments. Also maps nodal positions to those of the constraints.
    pub fn apply(self, w: &[f64]) -> Vec<f64> {
        match self {
            Cone::Nodal => w.to_vec(),
            // Halves first: the sum of two huge values must not overflow.
            Cone::Midpoint => w.windows(2).map(|pair| 0.5 * pair[0] + 0.5 * pair[1]).collect(),
        }
    }

    /// B'λ: the nodal forces of the multipliers on a chain of `nodes` nodes.
    ///
    /// # Errors
    /// [`Error::LengthMismatch`] when λ does not hold one entry per constraint.
    pub fn apply_transposed(self, multiplier: &[f64], nodes: usize) -> Result<Vec<f64>> {
        let expected = self.constraints(nodes);
        if multiplier.len() != expected {
            return Err(Error::LengthMismatch { name: "multiplier", given: multiplier.len(), expected });
        }
        Ok(match self {
            Cone::Nodal => multiplier.to_vec(),
            Cone::Midpoint => {
                let mut force = vec![0.0; nodes];
                for (i, &value) in multiplier.iter().enumerate() {
                    force[i] += 0.5 * value;
                    force[i + 1] += 0.5 * value;
                }
                force
            }
        })
    }

    /// The nodes of constraint `i`: one node or the two ends of a segment.
    pub fn support(self, i: usize) -> std::ops::RangeInclusive<usize> {
        match self {
            Cone::Nodal => i..=i,
            Cone::Midpoint => i..=i + 1,
        }
    }

    /// The guess for a chain with every segment halved: constraints lying in the contact set of the coarse chain.
    pub fn refined_set(self, coarse: &ContactSet) -> ContactSet {
        let set = coarse.as_slice();
        ContactSet::new(match self {
            // Old nodes and, between two active ones, the new node.
            Cone::Nodal => {
                (0..(2 * set.len()).saturating_sub(1)).map(|i| set[i / 2] && set[i.div_ceil(2)]).collect()
            }
            Cone::Midpoint => set.iter().flat_map(|&active| [active; 2]).collect(),
        })
    }
}

impl fmt::Display for Cone {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Cone::Nodal => "nodal",
            Cone::Midpoint => "midpoint",
        })
    }
}

impl FromStr for Cone {
    type Err = Error;

    fn from_str(text: &str) -> Result<Self> {
        match text {
            "nodal" => Ok(Cone::Nodal),
            "midpoint" => Ok(Cone::Midpoint),
            _ => Err(Error::UnknownName {
                what: "cone",
                given: text.to_owned(),
                expected: "nodal or midpoint",
            }),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn halved_segments_inherit_contact() {
        let coarse = ContactSet::new(vec![true, true, false]);
        let fine = Cone::Nodal.refined_set(&coarse);
        assert_eq!(fine.as_slice(), [true, true, true, false, false]);
        let fine = Cone::Midpoint.refined_set(&coarse);
        assert_eq!(fine.as_slice(), [true, true, true, true, false, false]);
    }

    #[test]
    fn transposed_is_the_adjoint() {
        let w = [0.5, -1.0, 2.0, 0.25];
        for cone in Cone::ALL {
            let multiplier: Vec<f64> = (0..cone.constraints(4)).map(|i| 1.0 + i as f64).collect();
            let left: f64 = cone.apply(&w).iter().zip(&multiplier).map(|(a, b)| a * b).sum();
            let force = cone.apply_transposed(&multiplier, 4).unwrap();
            let right: f64 = force.iter().zip(&w).map(|(a, b)| a * b).sum();
            assert_eq!(left, right, "{cone}");
            assert_eq!(cone.to_string().parse(), Ok(cone));
            assert!(cone.apply_transposed(&[1.0; 7], 4).is_err());
        }
        assert!("planar".parse::<Cone>().is_err());
    }
}
