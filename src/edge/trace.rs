//! The trace of a computed solution on the contact edge.
//!
//! | paper | here |
//! | --- | --- |
//! | u_N on Γ_C | piecewise linear with nodal values `displacement` ≤ 0 |
//! | −σ_N dΓ | point forces `force` ≥ 0 at the nodes, so that ∫ σ_N v dΓ = −Σ λᵢ v(xᵢ) |
//! | contact set {u_N = 0} | closed intervals between nodes where u_N = 0, single points included |

use crate::error::{Error, Result};
use crate::numeric::check::{require_entry, require_values};

/// A closed interval [start, end] of the contact edge; a single point if the two coincide.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Interval {
    /// Left end.
    pub start: f64,
    /// Right end, ≥ `start`.
    pub end: f64,
}

impl Interval {
    /// The length end − start.
    pub fn length(&self) -> f64 {
        self.end - self.start
    }
}

/// The trace of a solution at the nodes of a fine mesh of the contact edge: normal displacements and contact forces.
///
/// u_N ≤ 0 is linear between the nodes; −σ_N dΓ is a sum of point forces λᵢ ≥ 0, so ∫ σ_N v dΓ = −Σ λᵢ v(xᵢ).
///
/// ```
/// use signorini::edge::{EdgeTrace, Interval};
/// let (nodes, gap) = (vec![0.0, 0.25, 0.5, 0.75, 1.0], vec![0.0, -0.25, -0.5, 0.0, 0.0]);
/// let trace = EdgeTrace::new(&nodes, &gap, &[1.0, 0.0, 0.0, 3.0, 2.0], 0.0)?;
/// let contact = [Interval { start: 0.0, end: 0.0 }, Interval { start: 0.75, end: 1.0 }];
/// assert_eq!((trace.contact(), trace.transitions()), (&contact[..], 2));
/// # Ok::<(), signorini::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct EdgeTrace {
    nodes: Vec<f64>,
    displacement: Vec<f64>,
    force: Vec<f64>,
    contact: Vec<Interval>,
    pressed: Vec<Interval>,
}

impl EdgeTrace {
    /// The trace with the given increasing nodes, values u_N ≤ 0 and forces λ at the nodes; the signs of the
    /// forces are not checked.
    ///
    /// A node is in contact if u_N = 0 to within `rounding` (absolute, in units of u_N). It belongs to the support of
    /// σ_N if λ exceeds `rounding` times the ratio of the largest force to the largest displacement.
    ///
    /// # Errors
    /// [`ToolkitError::LengthMismatch`](crate::ToolkitError::LengthMismatch),
    /// [`ToolkitError::NotFinite`](crate::ToolkitError::NotFinite),
    /// [`ToolkitError::CountOutOfRange`](crate::ToolkitError::CountOutOfRange) for fewer than two nodes,
    /// [`ToolkitError::EntryOutOfRange`](crate::ToolkitError::EntryOutOfRange) if the nodes do not increase or u_N
    /// exceeds `rounding`.
    pub fn new(nodes: &[f64], displacement: &[f64], force: &[f64], rounding: f64) -> Result<Self> {
        if nodes.len() < 2 {
            return Err(Error::count("nodes of the contact edge", nodes.len(), "[2, inf)"));
        }
        for (name, values) in [("node", nodes), ("displacement", displacement), ("force", force)] {
            require_values(name, values, nodes.len())?;
        }
        if let Some(k) = nodes.windows(2).position(|p| p[0] >= p[1]) {
            require_entry("node", k + 1, nodes[k + 1], "(previous node, inf)", false)?;
        }
        if let Some(k) = displacement.iter().position(|&u| u > rounding) {
            require_entry("normal displacement", k, displacement[k], "(-inf, 0]", false)?;
        }
        let largest_u = displacement.iter().fold(0.0f64, |m, u| m.max(u.abs()));
        let largest_force = force.iter().fold(0.0f64, |m, f| m.max(f.abs()));
        let force_rounding =
            if largest_u > 0.0 { rounding / largest_u * largest_force } else { 0.0 };
        let contact = runs(nodes, |i| displacement[i] >= -rounding);
        let pressed = runs(nodes, |i| force[i] > force_rounding);
        Ok(Self {
            nodes: nodes.to_vec(),
            displacement: displacement.to_vec(),
            force: force.to_vec(),
            contact,
            pressed,
        })
    }

    /// The nodes, in increasing order.
    pub fn nodes(&self) -> &[f64] {
        &self.nodes
    }

    /// The normal displacement u_N at the nodes.
    pub fn displacement(&self) -> &[f64] {
        &self.displacement
    }

    /// The contact forces λ at the nodes.
    pub fn force(&self) -> &[f64] {
        &self.force
    }

    /// The contact pressure −σ_N at the nodes: each force divided by half the total length of the adjacent cells.
    ///
    /// These are the lumped densities λᵢ / ∫ φᵢ, φᵢ the hat function of node i: Σ pressureᵢ ∫ φᵢ is the total force.
    ///
    /// ```
    /// use signorini::edge::EdgeTrace;
    /// let trace = EdgeTrace::new(&[0.0, 0.25, 1.0], &[0.0; 3], &[1.0, 1.0, 3.0], 0.0)?;
    /// assert_eq!(trace.pressure(), [8.0, 2.0, 8.0]);
    /// # Ok::<(), signorini::Error>(())
    /// ```
    pub fn pressure(&self) -> Vec<f64> {
        let last = self.nodes.len() - 1;
        let width = |i: usize| self.nodes[(i + 1).min(last)] - self.nodes[i.saturating_sub(1)];
        self.force.iter().enumerate().map(|(i, force)| 2.0 * force / width(i)).collect()
    }

    /// The contact set {u_N = 0}, as intervals in ascending order.
    pub fn contact(&self) -> &[Interval] {
        &self.contact
    }

    /// Number of end points of the contact set inside the edge; an isolated contact point counts twice.
    pub fn transitions(&self) -> usize {
        let (start, end) = (self.nodes[0], self.nodes[self.nodes.len() - 1]);
        self.contact.iter().map(|c| usize::from(c.start > start) + usize::from(c.end < end)).sum()
    }

    /// The support of σ_N, as intervals in ascending order.
    pub fn pressed(&self) -> &[Interval] {
        &self.pressed
    }
}

/// Maximal ranges of consecutive nodes with a property, as closed intervals.
fn runs(nodes: &[f64], has: impl Fn(usize) -> bool) -> Vec<Interval> {
    let mut found: Vec<Interval> = Vec::new();
    let mut open = false;
    for (i, &x) in nodes.iter().enumerate() {
        match (has(i), open) {
            (true, false) => found.push(Interval { start: x, end: x }),
            (true, true) => {
                if let Some(last) = found.last_mut() {
                    last.end = x;
                }
            }
            (false, _) => {}
        }
        open = has(i);
    }
    found
}
