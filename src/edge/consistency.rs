//! The contribution of a contact segment to the consistency term, which the paper's alternatives bound.
//!
//! Section 3: ∫_T σ_N (I^h u)_N dΓ = −Σ λᵢ (I^h u)_N(xᵢ), I^h the Lagrange interpolant on the segment.
//! Section 4: ∫_T (σ_N − π^h σ_N)(π^h u_N − u_N) dΓ = (1/h_e) ∫_T σ_N dΓ ∫_T u_N dΓ, because σ_N u_N = 0 and
//! π^h is the mean over the segment. Both are ≥ 0. A force at a vertex shared by two segments counts half in
//! each.

use super::trace::{EdgeTrace, Interval};

/// ∫_T σ_N (I^h u)_N dΓ over one segment. Cost: the number of nodes of the trace in the segment.
///
/// Equals −Σ λᵢ (I^h u)_N(xᵢ) ≥ 0, where (I^h u)_N is the linear interpolant of u_N at the two end points of the
/// segment; it vanishes when u_N = 0 at both. Exact up to rounding for the piecewise linear u_N.
///
/// ```
/// use signorini::edge::{EdgeTrace, Interval, nodal_term};
/// let (nodes, gap) = (vec![0.0, 0.25, 0.5, 0.75, 1.0], vec![0.0, -0.25, -0.5, 0.0, 0.0]);
/// let trace = EdgeTrace::new(nodes, gap, vec![1.0, 0.0, 0.0, 3.0, 2.0], 0.0)?;
/// // The force 3 at x = 3/4 meets the interpolant −1/4 of the values −1/2 and 0.
/// assert_eq!(nodal_term(&trace, Interval { start: 0.5, end: 1.0 }), 0.75);
/// # Ok::<(), signorini::Error>(())
/// ```
pub fn nodal_term(trace: &EdgeTrace, segment: Interval) -> f64 {
    let (left, right) = (trace.displacement_at(segment.start), trace.displacement_at(segment.end));
    forces_in(trace, segment)
        .map(|(x, force)| {
            let s = (x - segment.start) / segment.length();
            -force * ((1.0 - s) * left + s * right)
        })
        .fold(0.0, |sum, term| sum + term)
}

/// ∫_T (σ_N − π^h σ_N)(π^h u_N − u_N) dΓ over one segment. Cost: the number of nodes of the trace in the
/// segment.
///
/// Equals (1/h_e) (∫_T σ_N)(∫_T u_N) ≥ 0, since σ_N u_N = 0: it vanishes on a segment that is wholly open or wholly in
/// contact. Exact up to rounding for the piecewise linear u_N.
///
/// ```
/// use signorini::edge::{EdgeTrace, Interval, midpoint_term};
/// let (nodes, gap) = (vec![0.0, 0.25, 0.5, 0.75, 1.0], vec![0.0, -0.25, -0.5, 0.0, 0.0]);
/// let trace = EdgeTrace::new(nodes, gap, vec![1.0, 0.0, 0.0, 3.0, 2.0], 0.0)?;
/// // ∫σ_N = −5, ∫u_N = −1/16, h_e = 1/2.
/// assert_eq!(midpoint_term(&trace, Interval { start: 0.5, end: 1.0 }), 5.0 / 8.0);
/// # Ok::<(), signorini::Error>(())
/// ```
pub fn midpoint_term(trace: &EdgeTrace, segment: Interval) -> f64 {
    let force: f64 = forces_in(trace, segment).map(|(_, force)| force).sum();
    0.0 - force * integral(trace, segment) / segment.length()
}

/// Nodes in the segment with their forces, halved at its ends unless the end is an end of the whole edge.
fn forces_in(trace: &EdgeTrace, segment: Interval) -> impl Iterator<Item = (f64, f64)> + '_ {
    let nodes = trace.nodes();
    let (edge_start, edge_end) = (nodes[0], nodes[nodes.len() - 1]);
    let (from, to) = node_range(trace, segment);
    (from..to).map(move |i| {
        let x = nodes[i];
        let is_shared = (x == segment.start && x > edge_start) || (x == segment.end && x < edge_end);
        (x, if is_shared { 0.5 * trace.force()[i] } else { trace.force()[i] })
    })
}

/// Indices [from, to) of the nodes with start ≤ x ≤ end, by bisection: O(log N).
fn node_range(trace: &EdgeTrace, segment: Interval) -> (usize, usize) {
    let nodes = trace.nodes();
    (nodes.partition_point(|&x| x < segment.start), nodes.partition_point(|&x| x <= segment.end))
}

/// ∫_T u_N dΓ by trapezes between the nodes, exact for the piecewise linear trace.
fn integral(trace: &EdgeTrace, segment: Interval) -> f64 {
    let (from, to) = node_range(trace, segment);
    let inner = trace.nodes()[from..to].iter().copied();
    let stops: Vec<f64> = std::iter::once(segment.start).chain(inner).chain([segment.end]).collect();
    stops
        .windows(2)
        .map(|p| 0.5 * (p[1] - p[0]) * (trace.displacement_at(p[0]) + trace.displacement_at(p[1])))
        .sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// u_N = −x on [0, 1/2] mirrored, contact at the ends; forces 1 and 3 at the ends, coarse segments of
    /// length 1/2.
    fn trace() -> EdgeTrace {
        let nodes = vec![0.0, 0.25, 0.5, 0.75, 1.0];
        EdgeTrace::new(nodes, vec![0.0, -0.25, -0.5, 0.0, 0.0], vec![1.0, 0.0, 0.0, 3.0, 2.0], 0.0).unwrap()
    }

    #[test]
    fn nodal_term_sees_forces_where_the_interpolant_is_open() {
        let left = Interval { start: 0.0, end: 0.5 };
        let right = Interval { start: 0.5, end: 1.0 };
        assert_eq!(nodal_term(&trace(), left), 0.0);
        // force 3 at x = 3/4, where the interpolant of (−1/2, 0) is −1/4
        assert_eq!(nodal_term(&trace(), right), 0.75);
    }

    #[test]
    fn midpoint_term_is_the_product_of_the_means() {
        let right = Interval { start: 0.5, end: 1.0 };
        // ∫ u_N = −1/16, forces 3 + 2, length 1/2
        assert_eq!(midpoint_term(&trace(), right), 5.0 / 8.0);
    }
}
