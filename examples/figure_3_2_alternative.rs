//! Figure 3.2: the two cases of the nodal cone, segment by segment, on a computed contact set.
//!
//! Let t be a segment of the contact edge, of length h, and 0 < θ < 1. The paper puts t in a case:
//!
//! ```text
//! first case:    u_N has a zero nearer than θh to the left end of t, and one to the right end;
//! second case:   σ_N = 0 on a piece of t of length θh at one of its ends.
//! ```
//!
//! Why one of them holds: without a zero near an end, u_N < 0 there, hence σ_N = 0, because σ_N
//! u_N = 0 (2.5). The cases bound the consistency term ∫ σ_N I^h u_N ≥ 0 over t, where I^h u_N is
//! linear with the values of u_N at both ends of t. The proof takes θ = h^(2τ−3), and h² at τ = 2.
//!
//! This file computes u on a fine mesh, puts each of n equal segments of the edge in its case or
//! cases, and adds up the term. Two kinds of problems:
//!
//! ```text
//! block, ..        the unit square in plane strain, λ = μ = 1, held at y = 1, contact edge y = 0,
//!                  volume load (0, −cos πx), linear between nodes; the sides x = 0 and x = 1 are
//!                  free, and σ_T = 0 on the contact edge; u_N = −u₂ ≤ 0 at the nodes. u is the P1
//!                  solution on 8n × 8n squares, n the largest of the list, each cut from bottom
//!                  left to top right; at each node of the edge there is a force
//!                  l(φ) − a(u, φ) ≥ 0
//! transition:a, .. a prescribed pair on 64n cells, at least 2^16: u_N = −δ^p in a gap (a, b), with
//!                  δ = (x − a)(b − x)/(b − a), or x − a if b = 1; in contact the density of the
//!                  force is r^(τ−2), r the distance to the next gap, half of the integral over a
//!                  cell at each of its nodes; p = τ − 1. (Cantor sets: see `worst_contact_set`.)
//! ```
//!
//! So σ_N is minus a force at each node, and both u_N = 0 and σ_N < 0 are sets of intervals between
//! neighbouring nodes, or of single nodes. Below 1e-12 of the largest counts as zero. The column
//! d/h is for the first segment with a term: d is the larger one of the distances of its two ends
//! to the nearest zero of u_N. As a zero is known up to one cell, its ± is a cell over h.
//!
//! Refuted if a segment is in neither case, or if more segments have a term (over 1e-12 of the sum)
//! than the contact set has ends inside the edge. Both follow from σ_N u_N = 0, so that only a
//! fault of the computation can refute them. Not trivial is what the cases are for, the bounds of
//! the term of a segment. With ν = τ − 3/2, q = 1/(2 − τ), |v|²_ν = ∬ (v(x) − v(y))² / |x −
//! y|^(1+2ν) dx dy over t × t, ‖v‖²_ν = ‖v‖₀² + |v|²_ν they are
//!
//! ```text
//! first case:    C_q h θ^(1−1/q) ‖σ_N‖_ν ‖u_N'‖_ν,        C_q in ‖v‖_(L^q) ≤ C_q ‖v‖_ν     (3.9)
//! second case:   C_I γ_θ h^(2τ−2) |σ_N|_ν |u_N'|_ν,       C_I in ‖v − I v‖₀ ≤ C_I |v'|_ν,
//!                γ_θ in ‖v‖₀ ≤ γ_θ |v|_ν for mean zero on (0, θ)                          (3.14)
//! ```
//!
//! with constants on (0, 1): C_q is 1 for τ ≤ 7/4 and else Beckner's bound (example
//! `theta_balance`). γ_θ² is the largest eigenvalue of ‖v‖₀² against |v|²_ν among functions with
//! mean zero on (0, θ) whose slopes are polynomials in ln r, r the distance to the nearest of 0, θ
//! and 1; C_I² is that of ‖v − I v‖₀² against |v'|²_ν, where v' runs through a Legendre series.
//! Their errors are added, so that the bounds are upper bounds. For the share of a bound that is
//! used the force of a node is spread over its cells, so that σ_N is constant on a cell, both in
//! the norms and in the term over the bound; refuted if the largest share is above 1. There is none
//! at τ = 2, where such a σ_N has no |σ_N|_ν.
//!
//! Another contact set (for the other cone see example `figure_4_1_alternative`):
//!
//! `cargo run --release --example figure_3_2_alternative -- --problem transitions:3`

use example_report::prelude::*;
use fractional_sobolev::{Gram, Mesh};
use signorini::cone::Cone;
use signorini::contact::Solver;
use signorini::edge::{EdgeTrace, Interval};
use signorini::problems::NamedProblem;
use signorini::proof::ProofConstants;
use signorini::strip::LateralCondition;

example! { quick "Figure 3.2",
    "each segment: zeros of u_N within θh of both ends, or σ_N = 0 on a piece θh at one end";
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
    /// The larger distance of an end of the segment to the nearest zero of u_N.
    pub distance: f64,
}

/// The distance from each end of a segment to the nearest point of a set inside it.
struct FromEnds {
    left: f64,
    right: f64,
}

/// These distances for a union of intervals: at most 0 where one covers the end, infinite where
/// none meets the segment.
fn from_ends<'a>(t: Interval, set: impl Iterator<Item = &'a Interval>) -> FromEnds {
    let mut nearest = FromEnds { left: f64::INFINITY, right: f64::INFINITY };
    for p in set {
        nearest.left = nearest.left.min(p.start - t.start);
        nearest.right = nearest.right.min(t.end - p.end);
    }
    nearest
}

/// The cases of the segment t.
pub(crate) fn cases(u: &EdgeTrace, t: Interval, theta: f64) -> Cases {
    // A zero may be an end point of t; a pressure must be inside.
    let zeros = u.contact().iter().filter(|p| p.start <= t.end && t.start <= p.end);
    let pressures = u.pressed().iter().filter(|p| p.start < t.end && t.start < p.end);
    let (zero, pressure) = (from_ends(t, zeros), from_ends(t, pressures));
    let reach = theta * t.length();
    Cases {
        first: zero.left < reach && zero.right < reach,
        second: pressure.left >= reach || pressure.right >= reach,
        distance: zero.left.max(zero.right).max(0.0),
    }
}

/// A segment with its cases and its part of the consistency term.
struct Segment {
    t: Interval,
    cases: Cases,
    integral: f64,
}

/// The norms of a function that is constant on the cells of a segment of length h.
struct Norms {
    seminorm: f64,
    norm: f64,
}

fn norms(v: &[f64], h: f64, nu: Order) -> Result<Norms> {
    // vᵀA v, A the matrix of |·|²_ν: entries in closed form, products by FFT.
    let image = Gram::constants(&Mesh::uniform(v.len(), h)?, nu, 1e-8)?.apply(v)?;
    let square = image.iter().zip(v).map(|(y, x)| x * y).sum::<f64>().max(0.0);
    let l2 = v.iter().map(|v| v * v).sum::<f64>() * h / v.len() as f64;
    Ok(Norms { seminorm: square.sqrt(), norm: (l2 + square).sqrt() })
}

/// u on the edge: the solution on a mesh eight times finer than the finest one of the list, or a
/// prescribed pair (u_N, σ_N).
fn fine_solution(problem: &NamedProblem, finest: usize, tau: f64) -> Result<EdgeTrace> {
    match problem {
        NamedProblem::Mesh(body) => {
            // A contact edge without two ends is rejected here, before the long solve.
            let coarse = body.problem(8)?;
            EdgeTrace::of_solution(&coarse, &coarse.solve(Cone::Nodal, Solver::ActiveSet)?)?;
            let problem = body.problem(8 * finest)?;
            let u = problem.solve(Cone::Nodal, Solver::ActiveSet)?; // exact up to rounding
            Ok(EdgeTrace::of_solution(&problem, &u)?)
        }
        NamedProblem::Strip(set) => {
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
    /// Segments with a part of the consistency term.
    pub carried_by: usize,
}

pub(crate) fn run(options: &Options, out: &mut Report) -> Result<Vec<Row>> {
    let finest = options.n.iter().copied().max().unwrap_or(2);
    let u = fine_solution(&options.problem, finest, options.tau)?;
    let (x, u_n) = (u.nodes(), u.displacement());
    let cells = x.len() - 1;
    let theta_of = |h: f64| {
        if options.tau == 2.0 { h * h } else { h.powf(2.0 * options.tau - 3.0) }
    };
    let thetas: Vec<f64> = options.n.iter().map(|&n| theta_of(1.0 / n as f64)).collect();
    let c = ProofConstants::new(options.tau, 2.0, &thetas)?; // 2: the exponent q at τ = 2
    let mut rows = Vec::new();
    for &n in &options.n {
        let k = cells / n; // cells of u in a segment
        Error::unless(cells == k * n, "n", "divisors of the number of cells of u")?;
        let h = 1.0 / n as f64;
        let theta = theta_of(h);
        let mut segments = Vec::new();
        for s in 0..n {
            let (a, b) = (s * k, (s + 1) * k); // nodes of u at the ends
            let t = Interval { start: x[a], end: x[b] };
            let slope = (u_n[b] - u_n[a]) / t.length();
            let interpolant = |i: usize| u_n[a] + slope * (x[i] - t.start); // I^h u_N
            // ∫ σ_N I^h u_N; at the ends of t the force times u_N is 0.
            let integral = (a + 1..b).map(|i| -u.force()[i] * interpolant(i)).sum();
            segments.push(Segment { t, cases: cases(&u, t, theta), integral });
        }
        let intervals = |first: bool, second: bool| -> Vec<Interval> {
            let is_in = |cases: &Cases| cases.first == first && cases.second == second;
            segments.iter().filter(|segment| is_in(&segment.cases)).map(|s| s.t).collect()
        };
        let shown = [intervals(true, false), intervals(false, true), intervals(true, true)];
        let (first, second, both) = (shown[0].len(), shown[1].len(), shown[2].len());
        let integral: f64 = segments.iter().map(|segment| segment.integral).sum();
        let carriers: Vec<&Segment> =
            segments.iter().filter(|segment| segment.integral > 1e-12 * integral).collect();
        let carried_by = carriers.len();
        // Shares of (3.9) and of (3.14): largest over the segments of each case. σ_N is constant on
        // a cell: half of the forces of its nodes, of the end nodes of the edge all.
        let pressure = u.pressure();
        let (mut first_used, mut second_used): (Option<f64>, Option<f64>) = (None, None);
        for segment in carriers.iter().filter(|_| options.tau < 2.0) {
            let a = (segment.t.start / h).round() as usize * k;
            let sigma: Vec<f64> =
                (a..a + k).map(|i| 0.5 * (pressure[i] + pressure[i + 1])).collect();
            let slope: Vec<f64> =
                (a..a + k).map(|i| (u_n[i + 1] - u_n[i]) / (x[i + 1] - x[i])).collect();
            // The term of this σ_N: I^h u_N is linear on a cell, its mean the value in the middle.
            let (left, right) = (u_n[a], u_n[a + k]);
            let middle = |i: usize| left + (right - left) * (i as f64 + 0.5) / k as f64;
            let cell = h / k as f64;
            let term: f64 = (0..k).map(|i| -sigma[i] * middle(i) * cell).sum();
            let (sigma, slope) = (norms(&sigma, h, c.order())?, norms(&slope, h, c.order())?);
            let used = |bound: f64| term / bound;
            if segment.cases.first {
                let bound = c.embedding * h * theta.powf(c.hoelder()) * sigma.norm * slope.norm;
                first_used = Some(first_used.unwrap_or(0.0).max(used(bound)));
            }
            if segment.cases.second {
                let scale = h.powf(2.0 * options.tau - 2.0) * sigma.seminorm * slope.seminorm;
                let bound = c.interpolation * c.gamma(theta)? * scale;
                second_used = Some(second_used.unwrap_or(0.0).max(used(bound)));
            }
        }
        for (bound, share) in [("(3.9)", first_used), ("(3.14)", second_used)] {
            let Some(share) = share else { continue };
            let claim = out.check(format!("largest share of {bound} that is used"));
            claim.at_most(share, 1.0, "Section 3");
        }
        // ±: a cell over h
        let d = carriers
            .first()
            .map(|segment| Measured::new(segment.cases.distance / h, 1.0 / k as f64));
        out.row(cells! { n => theta, first, second, both, integral, carried_by,
        d, first_used, second_used });

        let neither = n - first - second - both;
        out.check("segments in neither case").at_most(neither, 0.0, "σ_N u_N = 0");
        let ends = u.transitions();
        out.check("segments with ∫ σ_N I^h u_N ≠ 0").at_most(carried_by, ends, "transitions");
        out.edge_trace(&format!("figure_3_2_alternative_h_{n}"), &u, shown);
        rows.push(Row { n, first, second, carried_by });
    }
    out.column("first", "first", "segments in the first case only");
    out.column("second", "second", "in the second only");
    out.column("both", "both", "in both");
    out.column("integral", "term", "∫ σ_N I^h u_N over the edge");
    out.column("carried_by", "carried by", "segments with a term");
    out.column(
        "d",
        "d/h",
        "in the first of these, d: the larger distance of an end to a zero of u_N, ± a cell",
    );
    out.column("first_used", "of (3.9)", "largest term/bound in the first case");
    out.column("second_used", "of (3.14)", "largest term/bound in the second case");
    out.remark(format!(
        "u is given on {cells} cells of the edge. If another largest n changes their number, a row \
         for the same n differs."
    ));
    Ok(rows)
}
