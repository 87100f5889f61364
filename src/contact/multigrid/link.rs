//! The contact edges of two consecutive levels.

use crate::cone::{Cone, ContactSet};
use crate::error::{Error, Result, ToolkitError};
use crate::mesh::ContactEdge;
use std::collections::HashMap;

/// For every node of the fine contact edge, the two coarse nodes whose midpoint it is.
#[derive(Debug, Clone)]
pub(super) struct Link {
    parents: Vec<[usize; 2]>,
    coarse: usize,
}

impl Link {
    pub(super) fn new(
        fine: &ContactEdge,
        coarse: &ContactEdge,
        parents: &[[u32; 2]],
    ) -> Result<Self> {
        let places: HashMap<usize, usize> =
            coarse.nodes().iter().enumerate().map(|(k, &node)| (node, k)).collect();
        let place = |node: u32| {
            let outside = Error::Toolkit(ToolkitError::Node {
                node: node as usize,
                reason: "is the parent of a contact node, but not a contact node",
            });
            places.get(&(node as usize)).copied().ok_or(outside)
        };
        let pairs = fine.nodes().iter().map(|&node| {
            let [a, b] = parents[node];
            Ok([place(a)?, place(b)?])
        });
        Ok(Self { parents: pairs.collect::<Result<_>>()?, coarse: coarse.nodes().len() })
    }

    /// The coarse nodes whose hat functions are nonzero at some marked fine node.
    pub(super) fn touched(&self, fine: &[bool]) -> Vec<bool> {
        let mut touched = vec![false; self.coarse];
        for (&[a, b], _) in self.parents.iter().zip(fine).filter(|&(_, &marked)| marked) {
            touched[a] = true;
            touched[b] = true;
        }
        touched
    }

    /// The constraints of the fine edge that lie in a coarse set. Where segments of the midpoint cone are alternately
    /// active, they are alternately active on the fine edge as well: the pattern is that of the mesh, its extent that
    /// of the solution.
    pub(super) fn refined(
        &self,
        cone: Cone,
        constraints: usize,
        coarse: &ContactSet,
    ) -> ContactSet {
        if cone == Cone::Nodal {
            let active = |k: usize| self.parents[k].iter().all(|&a| coarse.contains(a));
            return ContactSet::new(&(0..constraints).map(active).collect::<Vec<_>>());
        }
        let turns = by_turns(coarse.as_slice());
        let mut active: Vec<bool> = Vec::with_capacity(constraints);
        let mut before = None;
        for k in 0..constraints {
            // The segment between the first and the last coarse parent of the ends of the fine segment.
            let ends = [self.parents[k], self.parents[k + 1]];
            let segment =
                ends.as_flattened().iter().min().copied().filter(|&s| s < coarse.constraints());
            let turn = segment.and_then(|segment| turns[segment]);
            active.push(match (turn, segment) {
                (Some(_), _) if turn == before => !active[k - 1],
                (Some(first), _) => coarse.contains(first),
                (None, segment) => segment.is_some_and(|segment| coarse.contains(segment)),
            });
            before = turn;
        }
        ContactSet::new(&active)
    }
}

/// The start of every sequence of three or more consecutive segments that each differ from both neighbours.
fn by_turns(set: &[bool]) -> Vec<Option<usize>> {
    let differs = |a: usize, b: usize| set.get(a).zip(set.get(b)).is_none_or(|(a, b)| a != b);
    let is_single = |&i: &usize| (i == 0 || differs(i - 1, i)) && differs(i, i + 1);
    let singles: Vec<usize> = (0..set.len()).filter(is_single).collect();
    let mut turns = vec![None; set.len()];
    for stretch in singles.chunk_by(|a, b| a + 1 == *b).filter(|stretch| stretch.len() > 2) {
        stretch.iter().for_each(|&i| turns[i] = Some(stretch[0]));
    }
    turns
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn contact_by_turns_stays_so() {
        // Coarse node a is fine node 2 a.
        let link =
            Link { parents: (0..17_usize).map(|k| [k / 2, k.div_ceil(2)]).collect(), coarse: 9 };
        let set =
            |text: &str| ContactSet::new(&text.bytes().map(|b| b == b'1').collect::<Vec<_>>());
        for (coarse, fine) in [
            ("11100000", "1111110000000000"),
            ("10101110", "1010101011111100"),
            ("10111011", "1100111111001111"),
        ] {
            assert_eq!(link.refined(Cone::Midpoint, 16, &set(coarse)), set(fine), "{coarse}");
        }
    }
}
