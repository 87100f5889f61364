//! Figure 3.2: the two cases, segment by segment, on a computed contact set.
//!
//! u_N ≤ 0 is the normal displacement of the solution u on the contact edge, σ_N ≤ 0 the normal stress, σ_N u_N = 0, 0 < θ < 1.
//! For every segment (side of a triangle) of length h at least one of two cases holds, since u_N < 0 where it has no zero:
//!
//! ```text
//! first case     u_N has a zero nearer than θh to the left end, and one nearer than θh to the right end;
//! second case    σ_N vanishes on a piece of length θh at one of the ends.
//! ```
//!
//! They bound ∫ σ_N I^h u_N ≥ 0 over the segment, I^h u_N linear with the values of u_N at the ends; θ = h^(2τ−3), or h² at
//! τ = 2. It is 0 on segments in full contact and on those without: at most one segment per end of the contact set carries it.
//! Refuted if a segment is in neither case, or if more segments carry the integral than the contact set has ends.
//!
//! In place of u stands a solution on 8n × 8n squares, n of the finest mesh: an end of the contact set is known to one of its
//! cells. `unsure`: one cell more or less in θh changes the case. Of 8 segments of the block one is: first case by a solution
//! on 8·32 squares to a side, second by one on 8·8 (`--n 8`). Where in its segment the contact set ends, d/h, changes from
//! mesh to mesh, and with it the case of that segment and the size of the integral: three meshes show no order.
//!
//! `cargo run --release --example figure_3_2_alternative -- --problem fat-cantor --tau 1.7 --n 16,64,256`

use example_report::figures::{Axis, Chart, PALETTE, Series};
use example_report::prelude::*;
use signorini::cone::Cone;
use signorini::edge::EdgeTrace;
use signorini::problems::NamedProblem;
use signorini::proof::Section;

example! { quick "Figure 3.2", "each segment: zeros of u_N within θh of both ends, or σ_N = 0 on a piece θh at one end";
    /// a body, or a contact set chosen on an edge
    problem: NamedProblem = "block",
    /// numbers of segments
    n: Vec<usize> = "8,16,32" in "[2, 16384]",
    /// regularity τ in θ = h^(2τ−3), and that of a chosen contact set
    tau: f64 = "1.75" in "(1.5, 2]" slider "1.55 to 2",
    /// another θ
    theta: Option<f64> = "" in "(0, 1)",
}

/// One segment: is it a first, a second case; does one cell more or less change that; ∫ σ_N I^h u_N, or that of Figure 4.1;
/// the length that is compared with θh, in cells.
pub(crate) struct Segment {
    pub(crate) cases: [bool; 2],
    unsure: bool,
    pub(crate) integral: f64,
    d: f64,
}

/// The n segments of an edge of equal cells: u_N is linear in each cell, −σ_N is a point force at each node.
pub(crate) fn classify(section: Section, edge: &EdgeTrace, n: usize, theta: f64) -> Vec<Segment> {
    let (u, force) = (edge.displacement(), edge.force());
    let (last, cells) = (u.len() - 1, (u.len() - 1) / n);
    let rounding = |v: &[f64]| 1e-12 * v.iter().fold(0.0, |m: f64, v| m.max(v.abs()));
    let (zero, least) = (rounding(u), rounding(force));
    let segment = |s: usize| {
        let (a, b) = (s * cells, (s + 1) * cells); // the nodes at its ends
        let zeros = (a..=b).filter(|&k| u[k] >= -zero);
        // A force at an end, without one at the next node, is pressure on the neighbour.
        let beside = |k: usize| if k == a { a + 1 } else { k - usize::from(k == b) };
        let pressed = (a..=b).filter(|&k| force[k] > least && force[beside(k)] > least);
        // Cells from either end to the nearest of these nodes, and from the first to the last of them.
        let distances = |nodes: Vec<usize>| match nodes.as_slice() {
            [] => [f64::INFINITY, f64::INFINITY, 0.0],
            found => [found[0] - a, b - found[found.len() - 1], found[found.len() - 1] - found[0]]
                .map(|d| d as f64),
        };
        let (zeros, pressed) = (distances(zeros.collect()), distances(pressed.collect()));
        // First case: `first` is shorter than θh (Figure 4.1: no longer); second case: `second` is not shorter.
        let (first, second) = match section {
            Section::Three => (zeros[0].max(zeros[1]), pressed[0].max(pressed[1])),
            Section::Four => (zeros[2].max(pressed[2]), zeros[2]), // diameters of both sets, and of the contact set
        };
        let touches = section == Section::Four;
        let cases = |reach: f64| [first < reach || touches && first == reach, second >= reach];
        let (reach, d) = (theta * cells as f64, if touches { zeros[2] } else { first }); // θh and d in cells
        let mean = (a..b).map(|k| 0.5 * (u[k] + u[k + 1])).sum::<f64>() / cells as f64;
        let value = |k: usize| match section {
            Section::Three => u[a] + (u[b] - u[a]) * (k - a) as f64 / cells as f64,
            Section::Four => mean,
        };
        let share = |k: usize| if k == a && a > 0 || k == b && b < last { 0.5 } else { 1.0 };
        let integral = 0.0 - (a..=b).map(|k| share(k) * force[k] * value(k)).sum::<f64>();
        Segment {
            cases: cases(reach),
            unsure: cases((reach - 1.0).max(0.5)) != cases(reach + 1.0),
            integral,
            d,
        }
    };
    (0..n).map(segment).collect()
}

fn run(options: &Options, out: &mut Report) -> Result<()> {
    alternative(Section::Three, options, out)
}

/// The table of Figure 3.2, or that of Figure 4.1 with the integral of its proof.
pub(crate) fn alternative(section: Section, options: &Options, out: &mut Report) -> Result<()> {
    let Options { problem, n, tau, theta } = options;
    // A body: P1 elements on 8n × 8n squares, each cut into two triangles, u_N ≤ 0 at the nodes, by an active set method;
    // the block has λ = μ = 1, its top fixed, the load (0, −cos πx). Otherwise u_N and σ_N are chosen, at 65536 nodes.
    let fine = EdgeTrace::reference(problem, n.iter().copied().max().unwrap_or(2), *tau)?;
    let (u, cells) = (fine.displacement(), fine.nodes().len() - 1);
    let ends = u.windows(2).filter(|p| (p[0] == 0.0) != (p[1] == 0.0)).count();
    out.column("unsure", "unsure", "θh longer or shorter by one cell of the fine mesh changes the case");
    out.column("carriers", "carried by", "segments with a part of the integral above 1e-12");
    let meaning = match section {
        Section::Three => "there, larger distance of an end to a zero, over h: first case if below θ",
        Section::Four => "there, diameter of the contact set over h: first case if at most θ",
    };
    out.column("d", "d/h", meaning);
    for &n in n {
        if !cells.is_multiple_of(n) {
            return Err(Error::option("n", "divisors of the number of cells of the fine mesh"));
        }
        let printed = (n as f64).recip().powf(if *tau == 2.0 { 2.0 } else { 2.0 * tau - 3.0 });
        let theta = theta.unwrap_or(printed);
        let found = classify(section, &fine, n, theta);
        let at = |cases: [bool; 2]| (0..n).filter(|&s| found[s].cases == cases).collect::<Vec<usize>>();
        let [first, second, both] = [[true, false], [false, true], [true, true]].map(at);
        let integral = found.iter().map(|s| s.integral).sum::<f64>();
        let carriers = found.iter().filter(|s| s.integral > 1e-12 * integral);
        let (carriers, most) =
            (carriers.clone().count(), carriers.max_by(|a, b| a.integral.total_cmp(&b.integral)));
        let d = most.map(|s| Measured::new(s.d, 1.0) * (n as f64 / cells as f64));
        let case = most.map(|s| {
            [["none", "second"], ["first", "both"]][usize::from(s.cases[0])][usize::from(s.cases[1])]
        });
        out.row(cells! { n => theta, first: first.len(), second: second.len(), both: both.len(),
        unsure: found.iter().filter(|s| s.unsure).count(), integral, carriers, case, d });
        let neither = n - first.len() - second.len() - both.len();
        out.check("segments in neither case").at_most(neither, 0.0, "σ_N u_N = 0");
        out.check("segments that carry the integral").at_most(carriers, ends, "ends of the contact set");
        // The same for the discrete solution u^h, which has one cell per segment.
        let cone = if section == Section::Three { Cone::Nodal } else { Cone::Midpoint };
        let own = classify(section, &EdgeTrace::discrete(problem, n, *tau, cone)?, n, theta);
        let moved = own.iter().zip(&found).filter(|(a, b)| a.cases != b.cases).count();
        out.check("segments whose case is another one for u^h").at_most(moved, ends, "one for each end");
        if section == Section::Three {
            let own = own.iter().map(|s| s.integral).sum::<f64>();
            out.check("integral with u^h in place of u").at_most(own, 0.0, "force times u^h is 0 at nodes");
        }
        if out.draws() {
            let name = if section == Section::Three { "figure_3_2" } else { "figure_4_1" };
            let title = format!("Contact edge of {problem}, {n} segments, θ = {theta:.3}");
            out.chart(format!("{name}_alternative_h_{n}"), chart(title, &fine, n, [first, second, both]));
        }
    }
    Ok(())
}

/// u_N and −σ_N over their largest values, the segments shaded by case.
fn chart(title: String, edge: &EdgeTrace, n: usize, cases: [Vec<usize>; 3]) -> Chart {
    let mut chart =
        Chart::new(title, Axis::linear("x along the contact edge"), Axis::linear("over the largest value"));
    for (name, values) in [("u_N", edge.displacement()), ("−σ_N, contact pressure", &edge.pressure())] {
        let largest = values.iter().fold(f64::MIN_POSITIVE, |m: f64, v| m.max(v.abs()));
        let points = edge.nodes().iter().zip(values).map(|(&x, v)| (x, v / largest));
        chart = chart.with(Series::line(name, points.step_by(values.len().div_ceil(2000)).collect()));
    }
    for ((name, segments), colour) in
        ["first case", "second case", "both cases"].into_iter().zip(cases).zip([4, 5, 2])
    {
        let interval = |s: usize| (s as f64 / n as f64, (s + 1) as f64 / n as f64);
        chart = chart.with_bands(name, segments.into_iter().map(interval).collect(), PALETTE[colour]);
    }
    chart
}
