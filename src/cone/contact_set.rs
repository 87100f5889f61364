//! A set of active constraints along the contact edge, and its runs.

use std::ops::Range;

/// Which constraints hold with equality: nodes (nodal cone) or segments (midpoint cone), in the order of the
/// edge.
#[derive(Debug, Clone, PartialEq, Eq, Hash, Default)]
pub struct ContactSet {
    active: Vec<bool>,
}

impl ContactSet {
    /// The set with the given characteristic function.
    pub fn new(active: Vec<bool>) -> Self {
        Self { active }
    }

    /// The empty subset of `constraints` constraints.
    pub fn empty(constraints: usize) -> Self {
        Self::new(vec![false; constraints])
    }

    /// Number of constraints, active or not.
    pub fn constraints(&self) -> usize {
        self.active.len()
    }

    /// Number of active constraints.
    pub fn count(&self) -> usize {
        self.active.iter().filter(|&&active| active).count()
    }

    /// True when constraint `i` exists and is active.
    pub fn contains(&self, i: usize) -> bool {
        self.active.get(i).copied().unwrap_or(false)
    }

    /// The characteristic function.
    pub fn as_slice(&self) -> &[bool] {
        &self.active
    }

    /// The active indices, ascending.
    pub fn indices(&self) -> Vec<usize> {
        (0..self.active.len()).filter(|&i| self.active[i]).collect()
    }

    /// Maximal runs of consecutive active indices.
    pub fn runs(&self) -> Vec<Range<usize>> {
        let mut runs: Vec<Range<usize>> = Vec::new();
        for i in self.indices() {
            match runs.last_mut() {
                Some(run) if run.end == i => run.end = i + 1,
                _ => runs.push(i..i + 1),
            }
        }
        runs
    }

    /// Number of constraints that are active in exactly one of the two sets.
    pub fn distance(&self, other: &Self) -> usize {
        let longest = self.active.len().max(other.active.len());
        (0..longest).filter(|&i| self.contains(i) != other.contains(i)).count()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn runs_are_maximal() {
        let set = ContactSet::new(vec![true, true, false, true, false]);
        assert_eq!(set.runs(), vec![0..2, 3..4]);
        assert_eq!((set.count(), set.distance(&ContactSet::empty(5))), (3, 3));
        assert!(ContactSet::empty(4).runs().is_empty());
    }
}
