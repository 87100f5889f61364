//! Figure 3.2: the two cases, segment by segment, on a computed contact set.
//! u_N ≤ 0, σ_N ≤ 0: normal displacement and stress on the contact edge, σ_N u_N = 0; 0 < θ < 1. A segment t of length h is
//! in one case or both: (1) u_N has a zero nearer than θh to either end; (2) σ_N = 0 on a piece of length θh at one end. They
//! bound ∫ σ_N I^h u_N ≥ 0 over t, I^h u_N linear with the values of u_N at the ends. Refuted if a segment is in neither case, or
//! if more carry the integral than the contact set has ends. For u stands a solution on 8n × 8n squares, n finest (±: a cell).
// `at_most(x, b)` holds if x + its ± ≤ b; otherwise it fails, or is undecided within ±; the worst call counts.
use example_report::{figures::edge_trace, prelude::*};
use signorini::edge::{EdgeTrace, Interval, nodal_term};
use signorini::problems::NamedProblem;

example! { quick "Figure 3.2", "each segment: zeros of u_N within θh of both ends, or σ_N = 0 on a piece θh at one end";
    /// a body, or a contact set chosen on an edge
    problem: NamedProblem = "block",
    /// numbers of segments
    n: Vec<usize> = "8,16,32" in "[2, 16384]",
    /// regularity τ in θ, and that of a chosen contact set
    tau: f64 = "1.75" in "(1.5, 2]" slider "1.55 to 2",
}

/// Whether t is in the first and the second case, and d: the larger distance of an end of t to the nearest zero of u_N.
pub(crate) fn cases(edge: &EdgeTrace, t: Interval, theta: f64) -> ([bool; 2], f64) {
    let distance = |set: &[Interval], meets: fn(&f64, &f64) -> bool| {
        let met = set.iter().filter(|part| meets(&part.start, &t.end) && meets(&t.start, &part.end));
        let near = |d: [f64; 2], p: &Interval| [d[0].min(p.start - t.start), d[1].min(t.end - p.end)];
        met.fold([f64::INFINITY; 2], near).into_iter().fold(0.0, f64::max)
    };
    let (d, reach) = (distance(edge.contact(), f64::le), theta * t.length()); // ≤: an end of t may be a zero
    ([d < reach, distance(edge.pressed(), f64::lt) >= reach], d)
}

/// Cases of a segment, and its integral: the sum over the nodes of force × (−I^h u_N); in Figure 4.1 × (mean of −u_N).
pub(crate) type Figure = (fn(&EdgeTrace, Interval, f64) -> ([bool; 2], f64), fn(&EdgeTrace, Interval) -> f64);

pub(crate) fn alternative(name: &str, (cases, term): Figure, of: &Options, out: &mut Report) -> Result<()> {
    // P1 elements, u_N ≤ 0 at the nodes, active set method; block: λ = μ = 1, fixed on top, load (0, −cos πx).
    let u = EdgeTrace::reference(&of.problem, of.n.iter().copied().max().unwrap_or(2), of.tau)?;
    for &n in &of.n {
        let (x, k) = (u.nodes(), (u.nodes().len() - 1) / n); // k cells of u per segment
        Error::unless(x.len() == k * n + 1, "n", "divisors of the largest one")?;
        let theta = (n as f64).powf(if of.tau == 2.0 { -2.0 } else { 3.0 - 2.0 * of.tau });
        let segments = x.windows(k + 1).step_by(k).map(|x| Interval { start: x[0], end: x[k] });
        let found: Vec<_> = segments.map(|t| (t, cases(&u, t, theta), term(&u, t))).collect();
        let in_case = |case| found.iter().filter(|found| found.1.0 == case).map(|found| found.0).collect();
        let shown: [Vec<_>; 3] = [[true, false], [false, true], [true, true]].map(in_case);
        let [first, second, both] = shown.each_ref().map(Vec::len);
        let integral = found.iter().map(|found| found.2).sum::<f64>();
        let carry: Vec<_> = found.iter().filter(|found| found.2 > 1e-12 * integral).collect();
        let d = Measured::from(carry.first().map(|(t, (_, d), _)| (d / t.length(), 1.0 / k as f64)));
        out.row(cells! { n => theta, first, second, both, integral, carried_by: carry.len(), d });
        out.check("segments in neither case").at_most(n - first - second - both, 0.0, "σ_N u_N = 0");
        out.check("segments that carry the integral").at_most(carry.len(), u.transitions(), "contact ends");
        out.chart(format!("{name}_h_{n}"), edge_trace(&u, shown));
    }
    out.column("d", "d/h", "d of the first segment that carries the integral");
    Ok(())
}

fn run(options: &Options, out: &mut Report) -> Result<()> {
    alternative("figure_3_2_alternative", (cases, nodal_term), options, out)
}
