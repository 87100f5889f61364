//! Figure 3.2: the two cases, segment by segment, on a computed contact set. θ = h^(2τ−3), at τ = 2 h²; h = 1/n; σ_N u_N = 0.
//! A segment t of length h is in one case or both: (1) u_N has a zero nearer than θh to the left end of t and one to the right end;
//! (2) σ_N = 0 on a piece of length θh at one end. They bound ∫ σ_N I^h u_N ≥ 0 over t, I^h u_N linear with the values of u_N at both
//! ends. Refuted if a segment is in neither case, or if more carry the integral (over 1e-12 of the sum) than the contact set has ends
//! inside the edge; both follow from σ_N u_N = 0, so that only a fault of the computation can refute them. Contact set, pressed set: intervals between neighbouring nodes, and nodes, with u_N = 0, force λ > 0.
//! `block`: unit square, plane strain, λ = μ = 1, fixed at y = 1, contact edge y = 0, u_N = −u₂ ≤ 0 at its nodes, load (0, −cos πx)
//! linear between nodes. For u stands the P1 solution, exact by an active set, on 8n × 8n squares, n the largest, cut from bottom left
//! to top right; λ = l(φ) − a(u, φ) at a node. Zero: below 1e-12 of the largest. Of several calls of a check the worst counts.
use example_report::prelude::*;
use signorini::cone::Cone;
use signorini::contact::Solver;
use signorini::edge::{EdgeTrace, Interval};
use signorini::problems::NamedProblem;
use signorini::strip::LateralCondition;

example! { quick "Figure 3.2", "each segment: zeros of u_N within θh of both ends, or σ_N = 0 on a piece θh at one end";
    /// test problem: a body, or a prescribed contact set on an edge
    problem: NamedProblem = "block",
    /// numbers of segments
    n: Vec<usize> = "8,16,32" in "[2, 16384]",
    /// regularity τ in θ = h^(2τ−3), also that of a prescribed contact set
    tau: f64 = "1.75" in "(1.5, 2]" slider "1.55 to 2",
}

/// Whether t is in the first and the second case, and d: the larger distance of an end of t to the nearest zero of u_N.
pub(crate) fn cases(u: &EdgeTrace, t: Interval, theta: f64) -> ([bool; 2], f64) {
    // From the left and from the right end of t to the nearest of the intervals; ≤ 0 where one covers the end.
    let near = |d: [f64; 2], p: &Interval| [d[0].min(p.start - t.start), d[1].min(t.end - p.end)];
    let (contact, pressed) = (u.contact().iter(), u.pressed().iter());
    let zeros = contact.filter(|p| p.start <= t.end && t.start <= p.end).fold([f64::INFINITY; 2], near);
    let forces = pressed.filter(|p| p.start < t.end && t.start < p.end).fold([f64::INFINITY; 2], near);
    let (reach, d) = (theta * t.length(), zeros[0].max(zeros[1]));
    ([d < reach, forces[0].max(forces[1]) >= reach], d.max(0.0))
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
            let chord = |x: f64| values[a] + (x - t.start) / t.length() * (values[b] - values[a]); // I^h u_N
            let integral: f64 = (a + 1..b).map(|i| -u.force()[i] * chord(x[i])).sum(); // 0 at the ends of t
            found.push((t, cases(&u, t, theta), integral));
        }
        let in_case = |case| found.iter().filter(|found| found.1.0 == case).map(|found| found.0).collect();
        let shown: [Vec<_>; 3] = [[true, false], [false, true], [true, true]].map(in_case);
        let [first, second, both] = shown.each_ref().map(Vec::len);
        let integral: f64 = found.iter().map(|found| found.2).sum();
        let carry: Vec<_> = found.iter().filter(|found| found.2 > 1e-12 * integral).collect();
        let d = Measured::from(carry.first().map(|(t, (_, d), _)| (d / t.length(), 1.0 / k as f64)));
        out.row(cells! { n => theta, first, second, both, integral, carried_by: carry.len(), d });
        out.check("segments in neither case").at_most(n - first - second - both, 0.0, "σ_N u_N = 0");
        out.check("segments with ∫ σ_N I^h u_N ≠ 0").at_most(carry.len(), u.transitions(), "transitions");
        out.edge_trace(&format!("figure_3_2_alternative_h_{n}"), &u, shown);
    }
    out.column("d", "d/h", "d of the first segment that carries the integral; ±: a cell of u");
    Ok(())
}
