//! (3.2), (4.3): at τ = 2, does the error need a power of |ln h|?
//!
//! For u in H² the paper proves, for u^h linear on triangles of size h, in the energy norm
//!
//! ```text
//! e = ‖u − u^h‖ ≤ C h |ln h|^(1/2),
//! ```
//!
//! for the nodal cone, u^h ≤ 0 at the nodes of the contact edge (3.2), and for the midpoint cone,
//! means of u^h over the segments of the edge ≤ 0 (4.3).
//!
//! This file takes solutions that are just inside or just outside of H². Near an end of the contact
//! set let u_N' on one side and σ_N on the other be like ℓ(r)^(−α), where r is the distance from
//! the end and ℓ(r) = 2 + ln(1/r). Then u is in H² if and only if α > 1/2. Triangles at the
//! distance r add h² ℓ(r)^(−2α) dr/r to e², so that one expects
//!
//! ```text
//! (e/h)² ≈ B + A ℓ(h)^q / q,     q = 1 − 2α:
//! no logarithm for q < 0,     |ln h|^(q/2) for q > 0.
//! ```
//!
//! q is measured from this. Let D be the increment of (e/h)² over two halvings, from 2h to h/2: it
//! is like ℓ(h)^(q−1). So q − 1 is the slope of ln D over ln ℓ, from the first to the last mesh of
//! the finer half of all. Its ± is the difference of the slopes in both halves of that range, and
//! the effect of the ± of e.
//!
//! Refuted if for an α > 1/2 the quotient e/(h |ln h|^(1/2)) keeps growing: its last increment has
//! to be at most half of the one before, while those of a power of |ln h| fall by a factor near 1.
//! (For α = 0 it would be, too: there the quotient tends to a constant.) The paper is loose if q,
//! with its ±, is at most 0 for every α > 1/2: no logarithm. Undecided while a bound lies inside of
//! an error bar.
//!
//! **The problems.** On the edge y = 0 of the unit square a displacement g ≤ 0 and a pressure λ ≥ 0
//! with g λ = 0 are chosen. u is harmonic inside, g on the edge, 0 at y = 1, and ∂u/∂n = 0 at the
//! sides; u_N = u, and with the load ∂u/∂n + λ on the edge σ_N = −λ. In a gap (a, b), without
//! contact,
//!
//! ```text
//! g = −δ^p ℓ(δ)^(−α),  δ = (x − a)(b − x)/(b − a);   else λ = ℓ(r)^(−α),  r to the next gap.
//!
//! transition       one gap from a to b = 2 − a (a mirror at x = 1), p = 1;
//!                  e² is the mean over a = 5/12 and a = 11/24
//! transitions:11   gaps ((i + 1/4)/11, (i + 3/4)/11), i = 0, .. 10, ends rounded to nodes, p = 1
//! cantor:0.25      the middle half of (0, 1) is a gap, so that of both other quarters, .. 20
//!                  times, or until a rounded gap has no inner node or a piece no cell;
//!                  dimension 1/2, p = 5/4; λ is on pieces of measure ≈ 0: nodal cone only
//! ```
//!
//! N = 16 · 2^finest cells carry these data. g is taken at the nodes. A cell in contact has the
//! force λ at its middle times 1/N, half to each node; of the cell in which a lies, λ at the middle
//! of its part in contact times the length of that part goes to the node left of a.
//!
//! Another contact set, other powers of the logarithm:
//!
//! `cargo run --release --example equation_3_2_logarithm -- --problem transitions:5 --alpha 0.75,2`

use example_report::prelude::*;
use signorini::cone::Cone;
use signorini::problems::{StripData, TransitionPowers};
use signorini::strip::{EdgeData, LateralCondition, Reference, StripKind, StripProblem};

example! { seconds "(3.2), (4.3)", "u in H²:  ‖u − u^h‖ ≤ C h |ln h|^(1/2),  both cones";
    /// contact sets on the edge
    problem: Vec<StripData> = "transition,transitions:11,cantor:0.25",
    /// exponents α: slopes and pressures behave like |ln r|^(−α)
    alpha: Vec<f64> = "0,0.75,1" in "[0, 4]" slider "0 to 2",
    /// meshes of 8, 16, .. 2^finest cells along the edge
    finest: u32 = "14" in "[10, 18]",
}

/// (h, e) for h = 1/8, .. 2^−finest, on n × n squares cut into triangles, h = 1/n. For values v on
/// n cells of the edge v·A_n v is the energy of the discrete harmonic function inside, 0 at y = 1:
///
/// ```text
/// A_n = Σ_k S_k w_k w_kᵀ,   w_k = (cos kπi/n)ᵢ, first and last entry halved,   S_0 = 1/n²,
/// S_k = (2/n) sinh η coth nη, S_n half of that,   η = 2 arsinh(sin(kπ/2n)).
/// ```
///
/// With the interpolation P from n to N cells u^h has the edge values v that minimise ½ v·A_n v −
/// (A_N g + λ)·P v in the cone: an active set, conjugate gradients to 1e-13, products with A by
/// cosine transforms. Then
///
/// ```text
/// e² = (g·A_N g − 2 (A_N g)·P v + v·A_n v) / (1 − (n/N)²).
/// ```
///
/// The denominator is there because u is the discrete solution on N cells, whose own error, like
/// 1/N, is missing: the difference of the squares is like h² − 1/N² in place of h².
fn errors(edges: &[EdgeData], cone: Cone, finest: u32) -> Result<Vec<(f64, Measured)>> {
    let mut points: Vec<_> =
        (3..=finest).map(|k| (0.5f64.powi(k as i32), Measured::from(0.0))).collect();
    for edge in edges {
        let problem = StripProblem::new(StripKind::Scalar, edge, Reference::Nested, 8)?;
        for (u, (_, e)) in problem.solutions(cone, 8, 1 << finest)?.iter().zip(&mut points) {
            let found = 1.0 - (u.cells as f64 / edge.cells() as f64).powi(2);
            let square = Measured::from(problem.error(u)?).squared() / found;
            *e = (e.squared() + square / edges.len() as f64).sqrt();
        }
    }
    Ok(points)
}

fn study(problem: &StripData, alpha: f64, cone: Cone, finest: u32, out: &mut Report) -> Result<()> {
    let cells = 16usize << finest;
    let transition = TransitionPowers { opening: 1.0, pressure: 0.0, logarithm: alpha };
    let edges = match problem.moves() {
        true => vec![transition.data(5.0 / 12.0, cells)?, transition.data(11.0 / 24.0, cells)?],
        false => vec![problem.damped_data(alpha, cells, LateralCondition::Natural)?],
    };
    let points = errors(&edges, cone, finest)?;
    let square = |(h, e): (f64, Measured)| (e / h).squared();
    // (ℓ(h), D) from the points of the meshes 2h, h, h/2
    let increment = |p: &[(f64, Measured)]| {
        let (h, _) = p[1];
        (2.0 - h.ln(), square(p[2]) - square(p[0]))
    };
    let increments: Vec<(f64, Measured)> = points.windows(3).map(increment).collect();
    let q = exponent_of(&increments[increments.len() / 2..]) + 1.0; // the finer half of the meshes
    let (middle, last) = (points[points.len() / 2], points[points.len() - 1]);
    let over = |power: f64, (h, e): (f64, Measured)| e / (h * (-h.ln()).powf(power));
    let [optimal, sharp, paper] =
        [0.0, 0.25, 0.5].map(|power| over(power, last) / over(power, middle));
    let expected = 1.0 - 2.0 * alpha;
    let name = problem.to_string().split(':').next().unwrap_or_default().to_owned();
    out.row(cells! { problem: name, alpha, cone: cone.to_string() => expected, q,
    optimal: optimal.value, sharp: sharp.value, paper: paper.value });
    if alpha > 0.5 {
        let [before, middle, last] = [3, 2, 1].map(|k| over(0.5, points[points.len() - k]));
        let growth = (last - middle) / (middle - before).abs();
        let claim = format!("{cone} cone: ratio of successive increments of e/(h √|ln h|)");
        out.check(claim).whole_error_bars_at_most(growth, 0.5, "(3.2), (4.3)");
        let claim = out.stronger(format!("{cone} cone, H²: exponent q"));
        claim.whole_error_bars_at_most(q, 0.0, "no logarithm");
        let claim = out.observe("u in H²: e/h, finest mesh/middle mesh");
        claim.whole_error_bars_at_least(optimal, 1.0, "order 1 is optimal");
    } else if alpha == 0.0 {
        let claim = out.observe("α = 0, u not in H²: exponent q");
        claim.whole_error_bars_at_least(q, 0.0, "|ln h|^(q/2)");
    }
    if problem.moves() {
        let claim = out.observe("transition: q − (1 − 2α)");
        claim.whole_error_bars_differ_by_at_most(q - expected, 0.0, 0.2, "asymptotics of (e/h)²");
        if cone == Cone::Nodal {
            let relative =
                |&(h, e): &(f64, Measured)| (h, (over(0.0, (h, e)) / over(0.0, points[0])).value);
            chart(out).line(&format!("α = {alpha}"), points.iter().map(relative).collect());
        }
    }
    Ok(())
}

fn chart(out: &mut Report) -> &mut example_report::Plot {
    let axes = Axes::LogLinear("h", "error/h over that at h = 1/8");
    out.plot("equation_3_2_logarithm", "τ = 2, nodal cone: does error/h grow?", axes)
}

fn run(options: &Options, out: &mut Report) -> Result<()> {
    for (power, name) in [(0.25, "|ln h|^(1/4)"), (0.5, "|ln h|^(1/2)")] {
        let meshes = (3..=options.finest).map(|level| 0.5f64.powi(level as i32));
        let curve = meshes.map(|h| (h, (h.ln() / 8f64.ln()).abs().powf(power)));
        chart(out).dashed_line(name, curve.collect());
    }
    for problem in &options.problem {
        let cones =
            if matches!(problem, StripData::Cantor { .. }) { &Cone::ALL[..1] } else { &Cone::ALL };
        for &alpha in &options.alpha {
            for &cone in cones {
                study(problem, alpha, cone, options.finest, out)?;
            }
        }
    }
    out.column("expected", "1−2α", "");
    out.column("optimal", "e/h", "on the finest mesh, over that on the middle one; e = ‖u−u^h‖");
    out.column("sharp", "e/(h L^1/4)", "the same, L = |ln h|");
    out.column("paper", "e/(h L^1/2)", "the same");
    Ok(())
}
