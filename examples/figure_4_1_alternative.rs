//! Figure 4.1: the two cases of Section 4, on a computed contact set; the program is that of Figure 3.2, its twin.
//!
//! For the midpoint cone (the mean of u_N over every segment is ≤ 0) the term to bound on a segment t of length h is (4.9),
//!
//! ```text
//! ∫ (σ_N − π σ_N)(π u_N − u_N) = (1/h) ∫ σ_N ∫ u_N     over t,     π the mean over t, since σ_N u_N = 0,
//! first case     the contact set {u_N = 0} of t has diameter at most θh, and so has the set where σ_N ≠ 0;
//! second case    the contact set has diameter at least θh: u_N' has mean zero between two points so far apart.
//! ```
//!
//! A segment in full contact is a second case here and a first case in Figure 3.2; on it, and on a segment without
//! contact, the term is zero. Refuted if a segment is in neither case, or if more segments carry the term than the contact
//! set has ends.

#[allow(dead_code, reason = "the options and the command line of the twin are its own")]
#[path = "figure_3_2_alternative.rs"]
mod figure_3_2_alternative;

use example_report::prelude::*;
use signorini::edge::{EdgeTrace, Interval, midpoint_term};
use signorini::problems::NamedProblem;

example! { quick "Figure 4.1", "each segment: contact set and pressure no wider than θh, or contact set at least θh";
    /// a body, or a contact set chosen on an edge
    problem: NamedProblem = "block",
    /// numbers of segments
    n: Vec<usize> = "8,16,32" in "[2, 16384]",
    /// regularity τ in θ, and that of a chosen contact set
    tau: f64 = "1.75" in "(1.5, 2]" slider "1.55 to 2",
}

/// Whether t is in the first and the second case, and d: the diameter of its contact set.
pub(crate) fn cases(edge: &EdgeTrace, t: Interval, theta: f64) -> ([bool; 2], f64) {
    let diameter = |set: &[Interval], meets: fn(&f64, &f64) -> bool| {
        let met = set.iter().filter(|part| meets(&part.start, &t.end) && meets(&t.start, &part.end));
        let parts = met.map(|part| [part.start.max(t.start), part.end.min(t.end)]);
        let ends = parts.reduce(|[start, end], [from, to]| [start.min(from), end.max(to)]);
        ends.map_or(0.0, |[start, end]| end - start)
    };
    let (d, reach) = (diameter(edge.contact(), f64::le), theta * t.length()); // ≤: an end of t may be a zero
    ([d.max(diameter(edge.pressed(), f64::lt)) <= reach, d >= reach], d)
}

fn run(options: &Options, out: &mut Report) -> Result<()> {
    let Options { problem, n, tau } = options.clone();
    let twin = figure_3_2_alternative::Options { problem, n, tau };
    figure_3_2_alternative::alternative("figure_4_1_alternative", (cases, midpoint_term), &twin, out)
}
