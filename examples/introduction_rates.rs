//! The introduction: the rates known before, (E1)-(E4), and the new ones, (N1), (N2), each with what problems show.
//!
//! u in H^τ solves Signorini's problem, u^h the discrete one with linear elements of size h. The paper prints for ‖u − u^h‖
//!
//! ```text
//! (E1) h^(τ−1), τ ≤ 3/2           (E2) h^(τ/2−1/4), 3/2 < τ < 2; finitely many transitions: h^(τ−1)
//! (E3) h^(3/4), τ = 2; finitely many: up to h      (E4) h, τ > 2       (N1) h^(τ²−5τ/2+2)       (N2) h |ln h|^(1/2), τ = 2
//! ```
//!
//! Powers r^(τ−1) are in H^s for s < τ only; so is the Cantor row, whose gaps longer than l number l^(2τ−4) (page of the
//! strip). Refuted if a measured order with its ± is below a printed exponent; (N1) is loose if for one transition, τ =
//! 7/4, the order is above 11/16 by more than ±. A row whose ± is above 0.1 decides nothing. Expected: min(τ − 1, 1), both
//! cones (nodal: u^h ≤ 0 at the nodes; midpoint: means of u^h over the cells ≤ 0).
//!
//! Problems, on the edge y = 0 of the unit square: g ≤ 0, λ ≥ 0, g λ = 0; u harmonic, g on the edge, 0 at y = 1, ∂u/∂n = 0
//! at the sides, u_N = u, σ_N = −λ. In a gap (a, b), where there is no contact, g = −δ^p, δ = (x − a)(b − x)/(b − a); else
//! λ = r^(τ−2), r the distance to the next gap. N = 32·2^finest cells: g at the nodes; ∫ λ over a cell half to each node
//! (if a lies in a cell, all to the node left of a).
//!
//! ```text
//! transition       one gap, b = 2 − a (a mirror at x = 1), p = τ − 1; e² is the mean over a = 5/12 and a = 11/24
//! in H²            the same with p = 1, τ = 2, and g and λ (at the middle of a cell) over 2 + ln(1/δ), 2 + ln(1/r): just inside H²
//! transitions:11   gaps ((i + 1/4)/11, (i + 3/4)/11), i = 0, .. 10, ends rounded to nodes, p = τ − 1
//! fat-cantor:30    a gap L s^k in the middle of each of the 2^(k−1) pieces that remain, k = 1, .. 30, s = 2^(−1/(4 − 2τ)), all 30 levels
//!                  1/2 long, ends rounded; a gap without an inner node, or that leaves a piece without a cell, is left out; p = 1, λ = 1
//! ```
//!
//! Squared error e²: v·A_n v is the energy of the discrete harmonic function on n × n squares cut into triangles, edge
//! values v; A_n = Σ S_k w_k w_kᵀ, w_k = (cos kπi/n)ᵢ, end nodes by half, S_k = (2/n) sinh η coth nη, S_0 = 1/n², S_n by
//! half, cosh η = 2 − cos(kπ/n). With P from n to N cells u^h has the edge values v that minimise ½ v·A_n v − (A_N g + λ)·P
//! v in the cone, e² = g·A_N g − 2 (A_N g)·P v + v·A_n v. Order: as e² ≈ A h^(2p) + B h² + const (const: u on N cells), p
//! is that of 4 d(h/2) − d(h), d(h) = e(h)² − e(h/2)², at most 1 (`order_of_squares`).
// x.at_most(b) holds if x + ± ≤ b, x.at_least(b) if x − ± ≥ b; otherwise it fails, or is undecided within ±. The worst call counts.
// stronger: if it holds, the bound is loose. observe: shown, decides nothing.
use example_report::prelude::*;
use signorini::cone::Cone;
use signorini::problems::{StripData, TransitionPowers};
use signorini::strip::{EdgeData, LateralCondition, Reference, StripKind, StripProblem};

example! { seconds "Introduction", "(E1)-(E4), known before, and (N1), (N2), new: no printed order is violated; measured: min(τ − 1, 1)";
    /// meshes of 8, 16, .. 2^finest cells along the edge
    finest: u32 = "12" in "[9, 17]",
}

/// The data on an edge of so many cells, at every place of the transition.
fn data(problem: &str, tau: f64, cells: usize) -> Result<Vec<EdgeData>> {
    let powers = match problem {
        "transition" => TransitionPowers::of_regularity(tau),
        "in H²" => TransitionPowers { opening: 1.0, pressure: 0.0, logarithm: 1.0 },
        set => return Ok(vec![set.parse::<StripData>()?.data(tau, cells, LateralCondition::Natural)?]),
    };
    Ok(vec![powers.data(5.0 / 12.0, cells)?, powers.data(11.0 / 24.0, cells)?])
}

/// e² for n = 8, .. 2^finest: the square eliminated, an active set on the edge to 1e-13.
fn squares(problem: &str, tau: f64, cone: Cone, finest: u32) -> Result<Vec<f64>> {
    let edges = data(problem, tau, 32 << finest)?;
    let mut squares = vec![0.0; finest as usize - 2];
    for edge in &edges {
        let strip = StripProblem::new(StripKind::Scalar, edge, Reference::Nested, 8)?;
        let mut coarser = None; // where the active set starts
        for (n, square) in (3..=finest).map(|k| 1 << k).zip(&mut squares) {
            let u = strip.operator(n)?.0.solve_contact(&strip.load(n)?, cone, coarser.as_ref(), 1e-13)?;
            *square += strip.error(n, &u.values)?.value.powi(2) / edges.len() as f64;
            coarser = Some(u);
        }
    }
    Ok(squares)
}

fn run(options: &Options, out: &mut Report) -> Result<()> {
    type Row = (f64, &'static str, &'static [(&'static str, f64)]);
    let rows: [Row; 9] = [
        (1.4, "transition", &[("(E1)", 0.4)]),
        (1.5, "transition", &[("(E1)", 0.5)]),
        (1.75, "fat-cantor:30", &[("(E2)", 0.625), ("(N1)", 0.6875)]),
        (1.75, "transition", &[("(E2), finite", 0.75), ("(N1)", 0.6875)]),
        (1.75, "transitions:11", &[("(E2), finite", 0.75), ("(N1)", 0.6875)]),
        (2.0, "transitions:11", &[("(E3)", 0.75)]),
        (2.0, "in H²", &[("(E3), finite", 1.0), ("(N2)", 1.0)]),
        (2.25, "transition", &[("(E4)", 1.0)]),
        (2.5, "transition", &[("(E4)", 1.0)]),
    ];
    for (tau, problem, printed) in rows {
        let optimal = (tau - 1.0).min(1.0);
        let mut orders = Vec::new();
        for cone in Cone::ALL {
            let order = order_of_squares(&squares(problem, tau, cone, options.finest)?, 2).min(1.0);
            for &(label, exponent) in printed {
                let above = order.value + order.error - exponent;
                let claim = format!("{label}: order + error − exponent");
                let claim = if order.error <= 0.1 { out.check(claim) } else { out.observe(claim) };
                claim.at_least(above, 0.0, "printed exponent");
            }
            if tau == 1.75 && problem == "transition" {
                let claim = "τ = 7/4, transition: order − (N1)";
                out.stronger(claim).at_least(order - 0.6875, 0.0, "exponent 11/16");
            }
            let above = order.value - optimal - order.error;
            out.observe("order − min(τ − 1, 1) − error").at_most(above, 0.0, "optimal for P1 elements");
            orders.push(order);
        }
        let name = problem.split(':').next().unwrap_or(problem);
        let labels: Vec<&str> = printed.iter().map(|(label, _)| *label).collect();
        out.row(cells! { tau, problem: name => printed: labels.join(" "), optimal, nodal: orders[0], midpoint: orders[1] });
    }
    out.column("printed", "printed", "labels of the bounds that hold for it");
    let curve = |from: f64, to: f64, f: fn(f64) -> f64| {
        (0..=20).map(|k| from + (to - from) * f64::from(k) / 20.0).map(|tau| (tau, f(tau))).collect()
    };
    out.plot("introduction_rates", "Printed and measured orders", Axes::Linear("τ", "exponent of h"))
        .points("tau", "nodal")
        .points("tau", "midpoint")
        .dashed_line("(E2)", curve(1.5, 2.0, |tau| 0.5 * tau - 0.25))
        .line("(N1)", curve(1.5, 2.0, |tau| tau * tau - 2.5 * tau + 2.0))
        .dashed_line("min(τ − 1, 1)", curve(1.4, 2.5, |tau| (tau - 1.0).min(1.0)));
    Ok(())
}
