//! Figure 3.1 and the introduction: the printed exponents p of ‖u − u^h‖ ≤ C h^p over the
//! regularity τ, and the orders that are measured.
//!
//! Let u in H^τ solve Signorini's problem, and u^h the discrete one with linear elements of size h.
//! In the energy norm the paper has these exponents; (E1)-(E4) were known before, (N1) and (N2) are
//! new.
//!
//! ```text
//! (E1)  τ − 1                   τ ≤ 3/2
//! (E2)  τ/2 − 1/4               3/2 < τ < 2     (finitely many transitions: τ − 1)
//! (E3)  3/4                     τ = 2           (finitely many transitions: up to 1)
//! (E4)  1                       τ > 2
//! (N1)  τ² − 5τ/2 + 2           3/2 < τ < 2
//! (N2)  1, with |ln h|^(1/2)    τ = 2
//! ```
//!
//! Figure 3.1 draws (E2), (N1) and the best possible τ − 1. What it shows are two differences:
//!
//! ```text
//! (N1) − (E2) = (τ − 3/2)²,        (τ − 1) − (N1) = (τ − 3/2)(2 − τ), at most 1/16.
//! ```
//!
//! This file computes both differences, and measures the order for problems with known u. u^h is
//! sought in each of two cones. In the nodal one u^h ≤ 0 at the nodes of the contact edge. In the
//! midpoint one the mean of u^h over each segment of this edge, its value at the midpoint, is ≤ 0.
//!
//! Refuted if a computed difference is off its formula by more than 1e-15. Refuted too if in one of
//! the cones a measured order plus its ± is below an exponent that applies; the midpoint cone is
//! held to those too that are known for the nodal cone. At τ = 2 the exponent 1 is taken without
//! the logarithm of (N2): this is what (E3) says for finitely many transitions. An order with a ±
//! above 0.1 refutes nothing.
//!
//! The paper is loose if, for the problem `transition` below, the order less its ± is above (N1).
//! It is not if the order plus its ± is below (N1). Between these two it is undecided. The expected
//! order is min(τ − 1, 1). Whether the order less its ± is at most this is shown, and decides
//! nothing.
//!
//! **The problems.** On the edge y = 0 of the unit square a displacement g ≤ 0 and a pressure λ ≥ 0
//! with g λ = 0 are chosen. u is harmonic inside, g on the edge, 0 at y = 1, and ∂u/∂n = 0 at the
//! sides; here u_N = u. Let the load on the edge be ∂u/∂n + λ. Then the contact stress σ_N is −λ,
//! and u solves Signorini's problem. A gap is an interval (a, b) without contact. With a power q,
//! and where the problem says nothing else,
//!
//! ```text
//! in a gap    g = −δ^q,  δ = (x − a)(b − x)/(b − a),     and λ = 0;
//! outside     λ = r^(τ−2),  r the distance to the nearest gap,     and g = 0.
//!
//! transition      one gap from a to x = 1, with b = 2 − a: g is mirrored at x = 1, so that its
//!                 slope is 0 there; q = τ − 1; u is in H^s for s < τ only, which is enough, as
//!                 the exponents are continuous in τ; the squared error e² (below) is the mean
//!                 over a = 5/12 and a = 11/24
//! in H²           at τ = 2: the same gap for the same two a, g = −δ/(2 + ln(1/δ)) and
//!                 λ = 1/(2 + ln(1/r)); the integral of this λ over a cell is taken by the
//!                 midpoint rule; u is just in H²
//! fat-cantor:30   at τ = 7/4, q = 1 and λ = 1, a Cantor set: for k = 1, .. 30 a gap of length
//!                 4^(−k) is taken out of the middle of each of the 2^(k−1) intervals that are
//!                 left; all gaps together are 1/2 long, and so is the contact set; the function
//!                 that is one on such a set is in H^s for s < 1/4 only, hence τ = 3/2 + 1/4
//! ```
//!
//! The finest mesh has 2^finest cells on the edge, and u is given on N = 32 · 2^finest cells. There
//! g is taken at the nodes. The integral of λ over a cell goes to its two nodes by halves. If a
//! lies inside the cell, all of it goes to the node left of a. The ends of Cantor's gaps are
//! rounded to nodes. A gap that then has no inner node, or leaves an interval without a cell, is
//! not cut out, and its interval is not divided further.
//!
//! **The error.** Let v be values at the nodes of n cells of the edge. Then v·A_n v is the energy
//! of the discrete harmonic function that is v on the edge and 0 at y = 1, on n × n squares cut
//! into triangles:
//!
//! ```text
//! A_n = Σ_k S_k w_k w_kᵀ over k = 0, .. n,     w_k = (cos kπi/n)ᵢ, first and last entry halved,
//! S_0 = 1/n²,     S_k = (2/n) sinh η coth nη, S_n half of that,     sinh(η/2) = sin(kπ/(2n)).
//! ```
//!
//! Let P be the interpolation from n to N cells, and λ the vector of the integrals at the nodes.
//! The edge values v of u^h minimise ½ v·A_n v − (A_N g + λ)·P v in the cone. The squared error is
//!
//! ```text
//! e² = g·A_N g − 2 (A_N g)·P v + v·A_n v.
//! ```
//!
//! **The order and its ±.** The squared error is e² ≈ A h^(2p) + B h² + const. The constant is
//! there because u itself is on N cells. d removes it, and t removes B h²:
//!
//! ```text
//! d(h) = e(h)² − e(h/2)²,     t(h) = 4 d(h/2) − d(h) ~ h^(2p),     p = ¼ log₂ |t(h)/t(h/4)|.
//! ```
//!
//! The order is p at the finest h for which there is a t(h/4). Its ± has two parts. The first is
//! the largest difference from the p of the three h before, which shows a drift. The second is what
//! the ± of the squares does to p, by the derivatives of p. The squares have a ± because of
//! rounding, and because conjugate gradients stop at a relative residual of 1e-13. If p > 1, then B
//! h² is the larger part of e² and the order is 1: p ± s is replaced by 1 ± max(0, 1 − p + s).
//!
//! One regularity on finer meshes:
//!
//! `cargo run --release --example figure_3_1 -- --tau 1.75 --finest 13`

use example_report::prelude::*;
use signorini::cone::Cone;
use signorini::problems::{StripData, TransitionPowers};
use signorini::strip::{EdgeData, LateralCondition, Reference, StripKind, StripProblem};

example! { seconds "Figure 3.1, introduction",
    "(E1)-(E4), (N1), (N2) hold;  (E2) ≤ (N1) = τ² − 5τ/2 + 2 ≤ τ − 1 for 3/2 < τ < 2;  \
    shown: orders up to min(τ − 1, 1)";
    /// regularities τ
    tau: Vec<f64> = "1.4,1.5,1.55,1.6,1.65,1.7,1.75,1.8,1.85,1.9,1.95,2,2.25,2.5" in "[1.4, 2.5]",
    /// meshes of 8, 16, .. 2^finest cells along the edge
    finest: u32 = "12" in "[10, 17]",
}

/// The bounds for u in H^τ: known before, new, and the one for finitely many transitions.
fn bounds(tau: f64) -> Vec<(&'static str, f64)> {
    match tau {
        ..=1.5 => vec![("(E1)", tau - 1.0)],
        2.0 => vec![("(E3)", 0.75), ("(N2)", 1.0), ("(E3), finitely many", 1.0)],
        2.0.. => vec![("(E4)", 1.0)],
        _ => vec![
            ("(E2)", 0.5 * tau - 0.25),
            ("(N1)", tau * tau - 2.5 * tau + 2.0),
            ("(E2), finitely many", tau - 1.0),
        ],
    }
}

/// The data g and λ on an edge of `cells` cells, for every place a of the transition.
fn data(problem: &str, tau: f64, cells: usize) -> Result<Vec<EdgeData>> {
    let powers = match problem {
        "transition" => TransitionPowers::of_regularity(tau),
        "in H²" => TransitionPowers { opening: 1.0, pressure: 0.0, logarithm: 1.0 },
        cantor => {
            return Ok(vec![cantor.parse::<StripData>()?.data(
                tau,
                cells,
                LateralCondition::Natural,
            )?]);
        }
    };
    Ok(vec![powers.data(5.0 / 12.0, cells)?, powers.data(11.0 / 24.0, cells)?])
}

/// The squared errors e² for n = 8, 16, .. 2^finest, which are finest − 2 meshes. v is found by an
/// active set method with conjugate gradients to 1e-13, and products with A_n by fast transforms.
fn squares(problem: &str, tau: f64, cone: Cone, finest: u32) -> Result<Vec<Measured>> {
    let edges = data(problem, tau, 32 << finest)?;
    let mut squares = vec![Measured::from(0.0); finest as usize - 2];
    for edge in &edges {
        // Nested: u is the function on the N cells of `edge` itself; n is at least 8.
        let strip = StripProblem::new(StripKind::Scalar, edge, Reference::Nested, 8)?;
        for (u_h, square) in strip.solutions(cone, 8, 1 << finest)?.iter().zip(&mut squares) {
            *square = *square + Measured::from(strip.error(u_h)?).squared() / edges.len() as f64;
        }
    }
    Ok(squares)
}

/// The orders of both cones against every bound that applies.
fn study(problem: &str, tau: f64, finest: u32, out: &mut Report) -> Result<()> {
    let (all, optimal) = (bounds(tau), (tau - 1.0).min(1.0));
    // The Cantor set has infinitely many transitions: the third bound does not apply to it.
    let applying = if problem == "fat-cantor:30" { &all[..2] } else { &all };
    let mut orders = Vec::new();
    for cone in Cone::ALL {
        // 2 halvings of h, from t(h) to t(h/4)
        let order = order_of_squares(&squares(problem, tau, cone, finest)?, 2).min(1.0);
        for &(label, exponent) in applying {
            let claim = format!("{label}: order + its ± − exponent");
            let claim = if order.error <= 0.1 { out.check(claim) } else { out.observe(claim) };
            claim.at_least(order.value + order.error - exponent, 0.0, "printed exponent");
            if label == "(N1)" && problem == "transition" {
                let claim = format!("{cone} cone: order − (N1)");
                let claim = out.stronger(claim);
                claim.whole_error_bars_at_least(order - exponent, 0.0, "(3.1), (4.2)");
            }
        }
        let above = order.value - optimal - order.error;
        let claim = out.observe("order − its ± − min(τ − 1, 1)");
        claim.at_most(above, 0.0, "optimal for P1 elements");
        orders.push(order);
    }
    let name = problem.split(':').next().unwrap_or(problem);
    let exponent = |k: usize| all.get(k).map(|&(_, exponent)| exponent);
    let (earlier, printed) = (exponent(0), exponent(1));
    out.row(cells! { tau, problem: name =>
        earlier, printed, optimal, nodal: orders[0], midpoint: orders[1]
    });
    Ok(())
}

fn run(options: &Options, out: &mut Report) -> Result<()> {
    for &tau in &options.tau {
        let problems: &[&str] = match tau {
            1.75 => &["transition", "fat-cantor:30"],
            2.0 => &["in H²"],
            _ => &["transition"],
        };
        for problem in problems {
            study(problem, tau, options.finest, out)?;
        }
        if let [("(E2)", earlier), (_, printed), (_, optimal)] = bounds(tau)[..] {
            let [square, product] = [(tau - 1.5).powi(2), (tau - 1.5) * (2.0 - tau)];
            let claim = out.check("(N1) − (E2)");
            claim.differ_by_at_most(printed - earlier, square, 1e-15, "(τ − 3/2)²");
            let claim = out.check("(τ − 1) − (N1)");
            claim.differ_by_at_most(optimal - printed, product, 1e-15, "(τ − 3/2)(2 − τ)");
        }
    }
    out.column("earlier", "before", "(E1)-(E4) for any contact set");
    out.column("printed", "new", "(N1), (N2)");
    out.column("optimal", "optimal", "min(τ − 1, 1)");
    let curve = |from: f64, to: f64, f: fn(f64) -> f64| {
        (0..=20)
            .map(|k| from + (to - from) * f64::from(k) / 20.0)
            .map(|tau| (tau, f(tau)))
            .collect()
    };
    out.plot("figure_3_1", "Exponents over the regularity", Axes::Linear("τ", "exponent of h"))
        .points("tau", "nodal")
        .points("tau", "midpoint")
        .dashed_line("(E2), τ/2 − 1/4", curve(1.5, 2.0, |tau| 0.5 * tau - 0.25))
        .line("(N1), τ² − 5τ/2 + 2", curve(1.5, 2.0, |tau| tau * tau - 2.5 * tau + 2.0))
        .dashed_line("min(τ − 1, 1)", curve(1.4, 2.5, |tau| (tau - 1.0).min(1.0)));
    Ok(())
}
