//! Figure 3.2: the two cases, segment by segment, on a computed contact set.
//!
//! u_N ≤ 0 is the normal displacement on the contact edge, σ_N ≤ 0 the normal stress, σ_N u_N = 0, 0 < θ < 1. Each segment T
//! (side of a triangle, length h) is in one case or both, since σ_N = 0 where u_N has no zero: (1) u_N has a zero nearer
//! than θh to either end of T; (2) σ_N = 0 on a piece of length θh at one end. They bound ∫ σ_N I^h u_N ≥ 0 over T, I^h u_N
//! linear with the values of u_N at the ends; θ = h^(2τ−3), h² if τ = 2.
//!
//! Refuted if a segment is in neither case, or if more segments carry the integral than the contact set has ends. For u stands
//! a solution on 8n × 8n squares, n of the finest mesh: lengths are known to one of its cells (±), cases where d/h is not θ ±.
use example_report::{figures::edge_trace, prelude::*};
use signorini::edge::{EdgeTrace, Interval, nodal_term};
use signorini::{problems::NamedProblem, proof::Section};

example! { quick "Figure 3.2", "each segment: zeros of u_N within θh of both ends, or σ_N = 0 on a piece θh at one end";
    /// a body, or a contact set chosen on an edge
    problem: NamedProblem = "block",
    /// numbers of segments
    n: Vec<usize> = "8,16,32" in "[2, 16384]",
    /// regularity τ in θ, and that of a chosen contact set
    tau: f64 = "1.75" in "(1.5, 2]" slider "1.55 to 2",
}

/// Of a union of intervals in t: the larger distance of an end of t to the nearest one, and their diameter.
fn lengths(t: Interval, union: impl Iterator<Item = Interval>) -> [f64; 2] {
    let parts: Vec<Interval> = union.collect();
    let Some((first, last)) = parts.first().zip(parts.last()) else { return [f64::INFINITY, 0.0] };
    let (from, to) = (first.start.max(t.start), last.end.min(t.end));
    [(from - t.start).max(t.end - to), to - from]
}

/// First and second case on the segment t, and the length that the first one compares with θh. Contact: u_N = 0; pressed: force.
pub(crate) fn cases(section: Section, edge: &EdgeTrace, t: Interval, theta: f64) -> ([bool; 2], f64) {
    let (contact, pressed) = (edge.contact().iter().copied(), edge.pressed().iter().copied());
    let zeros = lengths(t, contact.filter(|c| c.start <= t.end && c.end >= t.start));
    let pressed = lengths(t, pressed.filter(|c| c.start < t.end && c.end > t.start));
    let reach = theta * t.length();
    match section {
        Section::Three => ([zeros[0] < reach, pressed[0] >= reach], zeros[0]),
        Section::Four => ([zeros[1].max(pressed[1]) <= reach, zeros[1] >= reach], zeros[1]),
    }
}

/// Name, section, and the sum over the nodes of t of force × (−I^h u_N); in Figure 4.1 of force × (mean of −u_N).
pub(crate) type Figure = (&'static str, Section, fn(&EdgeTrace, Interval) -> f64);

pub(crate) fn alternative((name, section, term): Figure, options: &Options, out: &mut Report) -> Result<()> {
    let (n, tau) = (&options.n, options.tau);
    // P1 elements, u_N ≤ 0 at the nodes, active set method; block: λ = μ = 1, fixed on top, load (0, −cos πx).
    let fine = EdgeTrace::reference(&options.problem, n.iter().copied().max().unwrap_or(2), tau)?;
    let (x, cells) = (fine.nodes(), fine.nodes().len() - 1);
    for &n in n {
        if !cells.is_multiple_of(n) {
            return Err(Error::option("n", "divisors of the largest one"));
        }
        let theta = (n as f64).powf(if tau == 2.0 { -2.0 } else { 3.0 - 2.0 * tau });
        let segments = (0..n).map(|s| Interval { start: x[s * cells / n], end: x[(s + 1) * cells / n] });
        let found: Vec<_> = segments.map(|t| (t, cases(section, &fine, t, theta), term(&fine, t))).collect();
        let in_case = |case| found.iter().filter(|found| found.1.0 == case).map(|found| found.0).collect();
        let shown: [Vec<_>; 3] = [[true, false], [false, true], [true, true]].map(in_case);
        let [first, second, both] = [0, 1, 2].map(|k: usize| shown[k].len());
        let integral = found.iter().map(|found| found.2).sum::<f64>();
        let carrying: Vec<_> = found.iter().filter(|found| found.2 > 1e-12 * integral).collect();
        let d = carrying.first().map(|(t, (_, d), _)| (d / t.length(), n as f64 / cells as f64));
        let (d, carriers) = (Measured::from(d), carrying.len());
        out.row(cells! { n => theta, first, second, both, integral, carriers, d });
        out.check("segments in neither case").at_most(n - first - second - both, 0.0, "σ_N u_N = 0");
        let claim = out.check("segments that carry the integral");
        claim.at_most(carriers, fine.transitions(), "ends of the contact set");
        out.chart(format!("{name}_h_{n}"), edge_trace(&fine, shown));
    }
    Ok(())
}

fn run(options: &Options, out: &mut Report) -> Result<()> {
    alternative(("figure_3_2_alternative", Section::Three, nodal_term), options, out)
}
