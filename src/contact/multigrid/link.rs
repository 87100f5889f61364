//! The contact edges of two consecutive levels.

use crate::cone::{Cone, ContactSet};
use crate::error::{Error, Result};
use crate::mesh::ContactEdge;
use std::collections::HashMap;

/// For every node of the fine contact edge the two nodes of the coarse one in the middle of which it lies.
#[derive(Debug, Clone)]
pub(super) struct Link {
    parents: Vec<[usize; 2]>,
    coarse: usize,
}

impl Link {
    pub(super) fn new(fine: &ContactEdge, coarse: &ContactEdge, parents: &[[u32; 2]]) -> Result<Self> {
        let places: HashMap<usize, usize> =
            coarse.nodes().iter().enumerate().map(|(k, &node)| (node, k)).collect();
        let place = |node: u32| {
            let outside =
                Error::Node { node: node as usize, reason: "is the parent of a contact node, and is none" };
            places.get(&(node as usize)).copied().ok_or(outside)
        };
        let pairs = fine.nodes().iter().map(|&node| {
            let [a, b] = parents[node];
            Ok([place(a)?, place(b)?])
        });
        Ok(Self { parents: pairs.collect::<Result<_>>()?, coarse: coarse.nodes().len() })
    }

    /// The coarse nodes whose hat functions do not vanish at a marked fine node.
    pub(super) fn touched(&self, fine: &[bool]) -> Vec<bool> {
        let mut touched = vec![false; self.coarse];
        for (&[a, b], _) in self.parents.iter().zip(fine).filter(|&(_, &marked)| marked) {
            touched[a] = true;
            touched[b] = true;
        }
        touched
    }

    /// The fine set that lies in a coarse one.
    pub(super) fn refined(&self, cone: Cone, constraints: usize, coarse: &ContactSet) -> ContactSet {
        let active = |k: usize| match cone {
            Cone::Nodal => self.parents[k].iter().all(|&a| coarse.contains(a)),
            // The segment between the first and the last coarse node that the ends of the fine segment know.
            Cone::Midpoint => {
                let ends = [self.parents[k], self.parents[k + 1]];
                ends.as_flattened().iter().min().is_some_and(|&segment| coarse.contains(segment))
            }
        };
        ContactSet::new((0..constraints).map(active).collect())
    }
}
