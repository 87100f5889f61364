//! A set of active constraints along the contact edge, and its contact intervals.

use std::ops::Range;

/// The set of constraints that hold with equality: nodes (nodal cone) or segments (midpoint cone), in the
/// order of the edge.
///
/// A contact interval is a maximal range of consecutive active indices; on a closed edge a contact interval
/// through node 0 is listed as two, one at either end of the numbering.
///
/// ```
/// use signorini::cone::{Cone, ContactSet, Ends};
/// let coarse = ContactSet::new(&[true, true, false, false]);
/// // halved segments inherit contact: the set covers the same part of the edge
/// let fine = Cone::Midpoint.on(9, Ends::Open).refined_set(&coarse)?;
/// assert_eq!(fine.count() * coarse.constraints(), coarse.count() * fine.constraints());
/// # Ok::<(), signorini::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Eq, Hash, Default)]
pub struct ContactSet {
    active: Vec<bool>,
}

impl ContactSet {
    /// The set with the given characteristic function.
    ///
    /// Entry i is true if constraint i holds with equality, (B w)_i = g_i. Constraints are numbered in
    /// the order of the edge.
    pub fn new(active: &[bool]) -> Self {
        Self { active: active.to_vec() }
    }

    /// The empty contact set for `constraints` constraints.
    ///
    /// This is the default initial guess of the active set ([`Start::Open`](crate::contact::Start::Open)):
    /// the first linear problem is unconstrained.
    ///
    /// ```
    /// let none = signorini::cone::ContactSet::empty(4);
    /// assert_eq!((none.constraints(), none.count(), none.runs().len()), (4, 0, 0));
    /// # Ok::<(), signorini::Error>(())
    /// ```
    pub fn empty(constraints: usize) -> Self {
        Self::new(&vec![false; constraints])
    }

    /// Number of constraints, active or not.
    pub fn constraints(&self) -> usize {
        self.active.len()
    }

    /// Number of active constraints.
    ///
    /// For the midpoint cone on a uniform mesh of n segments, the contact set covers the fraction count/n of the
    /// edge. Cost: O(constraints).
    pub fn count(&self) -> usize {
        self.active.iter().filter(|&&active| active).count()
    }

    /// True if constraint `i` exists and is active.
    ///
    /// An index out of range is not active.
    pub fn contains(&self, i: usize) -> bool {
        self.active.get(i).copied().unwrap_or(false)
    }

    /// The characteristic function.
    ///
    /// Its length is [`ContactSet::constraints`].
    ///
    /// ```
    /// use signorini::cone::ContactSet;
    /// let set = ContactSet::new(&[true, false, true]);
    /// // characteristic function and indices describe the same set
    /// assert!(set.indices().iter().all(|&i| set.as_slice()[i]) && set.indices().len() == set.count());
    /// # Ok::<(), signorini::Error>(())
    /// ```
    pub fn as_slice(&self) -> &[bool] {
        &self.active
    }

    /// The active indices, ascending.
    ///
    /// ```
    /// let set = signorini::cone::ContactSet::new(&[true, false, true, true]);
    /// assert_eq!(set.indices(), [0, 2, 3]);
    /// assert_eq!(set.indices(), set.runs().into_iter().flatten().collect::<Vec<_>>());
    /// # Ok::<(), signorini::Error>(())
    /// ```
    pub fn indices(&self) -> Vec<usize> {
        (0..self.active.len()).filter(|&i| self.active[i]).collect()
    }

    /// The contact intervals: maximal ranges of consecutive active indices.
    ///
    /// Half-open ranges in ascending order, consecutive ones separated by at least one inactive constraint: the components
    /// of the contact set on an open edge; on a closed edge an interval through node 0 is listed as two. Cost: O(constraints).
    ///
    /// ```
    /// use signorini::cone::ContactSet;
    /// let set = ContactSet::new(&[true, true, false, true, false]);
    /// assert_eq!(set.runs(), [0..2, 3..4]);
    /// // the lengths of the contact intervals sum to the number of active constraints
    /// assert_eq!(set.runs().iter().map(|run| run.len()).sum::<usize>(), set.count());
    /// # Ok::<(), signorini::Error>(())
    /// ```
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
    ///
    /// The cardinality of the symmetric difference, a metric on sets of equal length; the shorter set is extended by
    /// inactive constraints. The active set iteration ends at a set that its next step would not change.
    ///
    /// ```
    /// use signorini::cone::ContactSet;
    /// let [a, b] = [[true, false, true], [true, true, false]].map(|set| ContactSet::new(&set));
    /// assert_eq!((a.distance(&a), a.distance(&b), b.distance(&a)), (0, 2, 2));
    /// # Ok::<(), signorini::Error>(())
    /// ```
    pub fn distance(&self, other: &Self) -> usize {
        let longest = self.active.len().max(other.active.len());
        (0..longest).filter(|&i| self.contains(i) != other.contains(i)).count()
    }
}
