//! Figure 4.1: the two cases of the midpoint cone, segment by segment, on a computed contact set.
//!
//! Let t be a segment of the contact edge, of length h, π^h the mean over t, and 0 < θ < 1. The
//! term to bound is
//!
//! ```text
//! ∫ (σ_N − π^h σ_N)(π^h u_N − u_N) = (1/h) ∫ σ_N ∫ u_N ≥ 0 over t,                        (4.9)
//! ```
//!
//! the equality because σ_N u_N = 0 (2.5). The paper puts t in a case:
//!
//! ```text
//! first case:    the contact set {u_N = 0} in t has a diameter ≤ θh, hence so has {σ_N ≠ 0};
//! second case:   the contact set in t has a diameter ≥ θh.
//! ```
//!
//! The proof takes θ = h^(2τ−3), and h² at τ = 2.
//!
//! This file computes u on a fine mesh, puts each of n equal segments of the edge in its case or
//! cases, and adds up the term. `block` is the unit square in plane strain, Lamé constants 1 and 1,
//! u = 0 at y = 1, free sides x = 0 and 1, with the contact edge y = 0, where u_N = −u₂ ≤ 0 at the
//! nodes; the force per area is the interpolant of (0, −cos πx) between nodes, integrated exactly.
//! u is the P1 solution on 8n × 8n squares, n the largest of the list, each cut from bottom left to
//! top right. At each node of the edge the floor exerts a force λ = a(u, φ) − l(φ) ≥ 0, φ = (0, 1)
//! times the hat function of the node; so σ_N is a force −λ at each node, and ∫ σ_N is a sum of
//! these; both u_N = 0 and λ > 0 are sets of intervals between neighbouring nodes, or of single
//! nodes. |u_N| below 1e-12 of the largest |u_N| of the edge counts as zero, and so does λ. For a
//! prescribed set, as below, u_N = −δ^(τ−1) in a gap (a, b), δ = (x − a)(b − x)/(b − a), and −σ_N =
//! r^(τ−2) in contact, r the distance to the nearest gap (for Cantor sets the exponents of example
//! `worst_contact_set`).
//!
//! Refuted if a segment is in neither case, or if more segments have a term (over 1e-12 of the sum)
//! than the contact set has ends inside the edge (both ends of each interval of {u_N = 0}, so that
//! a single node counts twice). Both are counts and have no error bar. For an exact solution both
//! follow from σ_N u_N = 0, so that only an error of the program refutes them; what is not trivial
//! are the shares of both cases.
//!
//! Another contact set: `transition` (one end of contact), `transitions:3` (three gaps, so six
//! ends), `cantor:0.3:4` (ratio, generations), `fat-cantor:4`, or `samples:FILE` with a line `u_N
//! λ` for each node of equal cells. (For the other cone see example `figure_3_2_alternative`.)
//!
//! `cargo run --release --example figure_4_1_alternative -- --problem transitions:3`

use example_report::prelude::*;
use signorini::cone::Cone;
use signorini::contact::Solver;
use signorini::edge::{EdgeTrace, Interval};
use signorini::problems::NamedProblem;
use signorini::strip::LateralCondition;

example! { quick "Figure 4.1",
    "each segment: contact set and pressure no wider than θh, or contact set at least θh";
    /// test problem: a body, or a prescribed contact set on an edge
    problem: NamedProblem = "block",
    /// numbers of segments
    n: Vec<usize> = "8,16,32" in "[2, 16384]",
    /// regularity τ in θ = h^(2τ−3), also that of a prescribed contact set
    tau: f64 = "1.75" in "(1.5, 2]" slider "1.55 to 2",
}

/// The cases of one segment.
pub(crate) struct Cases {
    pub first: bool,
    pub second: bool,
}

/// The diameter of the part of a union of intervals that lies in t; 0 of the empty set.
fn diameter<'a>(t: Interval, set: impl Iterator<Item = &'a Interval>) -> f64 {
    let (mut start, mut end) = (t.end, t.start);
    for p in set {
        start = start.min(p.start.max(t.start));
        end = end.max(p.end.min(t.end));
    }
    (end - start).max(0.0)
}

/// The cases of the segment t.
pub(crate) fn cases(u: &EdgeTrace, t: Interval, theta: f64) -> Cases {
    // A zero may be an end point of t; a pressure must be inside.
    let zeros = u.contact().iter().filter(|p| p.start <= t.end && t.start <= p.end);
    let pressures = u.pressed().iter().filter(|p| p.start < t.end && t.start < p.end);
    let (contact, pressed) = (diameter(t, zeros), diameter(t, pressures));
    let width = theta * t.length();
    Cases { first: contact <= width && pressed <= width, second: contact >= width }
}

/// A segment with its cases and its part of the term (4.9).
struct Segment {
    t: Interval,
    cases: Cases,
    term: f64,
}

/// u on the edge: the solution on a mesh eight times finer than the finest one of the list, or a
/// prescribed pair (u_N, σ_N) on 2^16 cells, or 64 n for the largest n if that is more.
fn fine_solution(problem: &NamedProblem, finest: usize, tau: f64) -> Result<EdgeTrace> {
    match problem {
        NamedProblem::Mesh(body) => {
            // A contact edge without two ends is rejected here, before the long solve.
            let coarse = body.problem(8)?;
            EdgeTrace::of_solution(&coarse, &coarse.solve(Cone::Nodal, Solver::ActiveSet)?)?;
            let problem = body.problem(8 * finest)?;
            // u_N = 0 at the active nodes, Cholesky; a node with λ < 0 leaves, one with u_N > 0
            // enters, until none does: exact up to rounding.
            let u = problem.solve(Cone::Nodal, Solver::ActiveSet)?;
            Ok(EdgeTrace::of_solution(&problem, &u)?)
        }
        NamedProblem::Strip(set) => {
            // `Natural`: no flux at the sides of the square above the edge
            let cells = (64 * finest).max(1 << 16);
            Ok(EdgeTrace::of_data(&set.data(tau, cells, LateralCondition::Natural)?)?)
        }
    }
}

/// The counts of one mesh.
pub struct Row {
    /// Number of segments.
    pub n: usize,
    /// Segments in the first case only.
    pub first: usize,
    /// Segments in the second case only.
    pub second: usize,
}

pub(crate) fn run(options: &Options, out: &mut Report) -> Result<Vec<Row>> {
    let finest = options.n.iter().copied().max().unwrap_or(2);
    let u = fine_solution(&options.problem, finest, options.tau)?;
    let (x, u_n) = (u.nodes(), u.displacement());
    let cells = x.len() - 1;
    let mut rows = Vec::new();
    for &n in &options.n {
        let k = cells / n; // cells of u in a segment
        Error::unless(cells == k * n, "n", "divisors of the number of cells of u")?;
        let h = 1.0 / n as f64;
        let theta = if options.tau == 2.0 { h * h } else { h.powf(2.0 * options.tau - 3.0) };
        let mut segments = Vec::new();
        for s in 0..n {
            let (a, b) = (s * k, (s + 1) * k); // nodes of u at the ends
            let t = Interval { start: x[a], end: x[b] };
            // The force at a node between two segments belongs to each of them by half.
            let is_shared = |i: usize| (i == a && a > 0) || (i == b && b < cells);
            let share = |i: usize| if is_shared(i) { 0.5 } else { 1.0 };
            let force: f64 = (a..=b).map(|i| share(i) * u.force()[i]).sum(); // −∫ σ_N
            let area: f64 = (a..b).map(|i| (x[i + 1] - x[i]) * (u_n[i] + u_n[i + 1]) / 2.0).sum();
            let term = 0.0 - force * area / t.length();
            segments.push(Segment { t, cases: cases(&u, t, theta), term });
        }
        let intervals = |first: bool, second: bool| -> Vec<Interval> {
            let is_in = |cases: &Cases| cases.first == first && cases.second == second;
            segments.iter().filter(|segment| is_in(&segment.cases)).map(|s| s.t).collect()
        };
        let shown = [intervals(true, false), intervals(false, true), intervals(true, true)];
        let (first, second, both) = (shown[0].len(), shown[1].len(), shown[2].len());
        let integral: f64 = segments.iter().map(|segment| segment.term).sum();
        let carried_by = segments.iter().filter(|segment| segment.term > 1e-12 * integral).count();
        out.row(cells! { n => theta, first, second, both, integral, carried_by });

        let neither = n - first - second - both;
        out.check("segments in neither case").at_most(neither, 0.0, "σ_N u_N = 0");
        let ends = u.transitions();
        out.check("segments with nonzero term (4.9)").at_most(carried_by, ends, "transitions");
        out.edge_trace(&format!("figure_4_1_alternative_h_{n}"), &u, shown);
        rows.push(Row { n, first, second });
    }
    out.column("first", "first", "segments in the first case only");
    out.column("second", "second", "in the second only");
    out.column("both", "both", "in both");
    out.column("integral", "term", "(4.9) over the edge");
    out.column("carried_by", "carried by", "segments with a term");
    out.remark(format!(
        "u is given on {cells} cells of the edge. If another largest n changes their number, a row \
         for the same n differs."
    ));
    Ok(rows)
}
