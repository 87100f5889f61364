//! Figure 4.1: the two cases of the midpoint cone, on a computed contact set. θ = h^(2τ−3), at τ = 2 h²; h = 1/n; σ_N u_N = 0.
//!
//! On a segment t of length h, π the mean over t, the term to bound is (4.9): ∫ (σ_N − π σ_N)(π u_N − u_N) = (1/h) ∫ σ_N ∫ u_N ≥ 0.
//! t is in one case or both: (1) its contact set {u_N = 0} has diameter ≤ θh, and so has the set where σ_N ≠ 0; (2) its contact set
//! has diameter ≥ θh. Refuted if a segment is in neither case, or if more carry the term (over 1e-12 of the sum) than the contact
//! set has ends inside the edge. Contact set, pressed set: intervals between neighbouring nodes, and nodes, with u_N = 0, force λ > 0.
//!
//! `block`: unit square, plane strain, λ = μ = 1, fixed at y = 1, contact edge y = 0, u_N = −u₂ ≤ 0 at its nodes, load (0, −cos πx)
//! linear between nodes. For u stands the P1 solution, exact by an active set, on 8n × 8n squares, n the largest, cut from bottom left
//! to top right; λ = l(φ) − a(u, φ) at a node. Zero: below 1e-12 of the largest. Of several calls of a check the worst counts.
use example_report::prelude::*;
use signorini::cone::Cone;
use signorini::contact::Solver;
use signorini::edge::{EdgeTrace, Interval};
use signorini::problems::NamedProblem;
use signorini::strip::LateralCondition;

example! { quick "Figure 4.1", "each segment: contact set and pressure no wider than θh, or contact set at least θh";
    /// test problem: a body, or a prescribed contact set on an edge
    problem: NamedProblem = "block",
    /// numbers of segments
    n: Vec<usize> = "8,16,32" in "[2, 16384]",
    /// regularity τ in θ = h^(2τ−3), also that of a prescribed contact set
    tau: f64 = "1.75" in "(1.5, 2]" slider "1.55 to 2",
}

/// Whether t is in the first and the second case.
pub(crate) fn cases(u: &EdgeTrace, t: Interval, theta: f64) -> [bool; 2] {
    let hull = |d: [f64; 2], p: &Interval| [d[0].min(p.start.max(t.start)), d[1].max(p.end.min(t.end))];
    let (empty, contact, pressed) = ([t.end, t.start], u.contact().iter(), u.pressed().iter());
    let zeros = contact.filter(|p| p.start <= t.end && t.start <= p.end).fold(empty, hull);
    let forces = pressed.filter(|p| p.start < t.end && t.start < p.end).fold(empty, hull);
    let [d, wide] = [zeros, forces].map(|[start, end]| (end - start).max(0.0)); // diameters, 0 of the empty set
    [d.max(wide) <= theta * t.length(), d >= theta * t.length()]
}

fn run(options: &Options, out: &mut Report) -> Result<()> {
    let finest = *options.n.iter().max().unwrap_or(&2);
    let u = match &options.problem {
        NamedProblem::Mesh(body) => {
            let problem = body.problem(8 * finest)?;
            EdgeTrace::of_solution(&problem, &problem.solve(Cone::Nodal, Solver::ActiveSet)?)?
        }
        NamedProblem::Strip(set) => {
            let cells = (64 * finest).max(1 << 16); // the pair (u_N, σ_N) is given at their ends
            EdgeTrace::of_data(&set.data(options.tau, cells, LateralCondition::Natural)?)?
        }
    };
    let (x, values) = (u.nodes(), u.displacement());
    for &n in &options.n {
        let (k, h) = ((x.len() - 1) / n, 1.0 / n as f64); // k cells of u in a segment
        Error::unless(x.len() == k * n + 1, "n", "divisors of the largest one")?;
        let theta = h.powf(if options.tau == 2.0 { 2.0 } else { 2.0 * options.tau - 3.0 });
        let mut found = Vec::new();
        for (a, b) in (0..n).map(|s| (s * k, (s + 1) * k)) {
            let t = Interval { start: x[a], end: x[b] };
            let shared = |i: usize| (i == a && a > 0) || (i == b && b < n * k); // half a force to either segment
            let force: f64 = (a..=b).map(|i| u.force()[i] * if shared(i) { 0.5 } else { 1.0 }).sum();
            let area: f64 = (a..b).map(|i| (x[i + 1] - x[i]) * (values[i] + values[i + 1]) / 2.0).sum();
            found.push((t, cases(&u, t, theta), 0.0 - force * area / t.length()));
        }
        let in_case = |case| found.iter().filter(|found| found.1 == case).map(|found| found.0).collect();
        let shown: [Vec<_>; 3] = [[true, false], [false, true], [true, true]].map(in_case);
        let [first, second, both] = shown.each_ref().map(Vec::len);
        let integral: f64 = found.iter().map(|found| found.2).sum();
        let carried_by = found.iter().filter(|found| found.2 > 1e-12 * integral).count();
        out.row(cells! { n => theta, first, second, both, integral, carried_by });
        out.check("segments in neither case").at_most(n - first - second - both, 0.0, "σ_N u_N = 0");
        out.check("segments with nonzero term (4.9)").at_most(carried_by, u.transitions(), "transitions");
        out.edge_trace(&format!("figure_4_1_alternative_h_{n}"), &u, shown);
    }
    Ok(())
}
