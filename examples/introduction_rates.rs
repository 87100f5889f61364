//! The introduction: the rates known before, (E1)-(E4), and the new ones, (N1), (N2), each with what problems show.
//!
//! u in H^τ solves Signorini's problem, u^h the discrete one with linear elements of size h. The paper prints for ‖u − u^h‖
//!
//! ```text
//! (E1) h^(τ−1), τ ≤ 3/2           (E2) h^(τ/2−1/4), 3/2 < τ < 2; finitely many transitions: h^(τ−1)
//! (E3) h^(3/4), τ = 2; finitely many: up to h      (E4) h, τ > 2       (N1) h^(τ²−5τ/2+2)       (N2) h |ln h|^(1/2), τ = 2
//! ```
//!
//! On the edge y = 0 of the unit square g = u_N ≤ 0 and a pressure λ ≥ 0 with g λ = 0 are chosen. `transition`: contact for
//! x < a, g ~ −r^(τ−1) and λ ~ r^(τ−2) at distance r from a; `in H²`: both over 2 + ln(1/r), at τ = 2 just inside H²;
//! `transitions`: eleven gaps; `fat-cantor`: contact on a Cantor set of measure 1/2 and infinitely many transitions. Errors are
//! root mean squares over places a that doubling n permutes in their cells.
//!
//! Strips: with N = 16 times the finest n, A_n the matrix that multiplies the wave cos kπx by sinh η coth nη,
//! cosh η = 2 − cos(kπ/n), and P the interpolation from n to N cells, u^h minimises ½ vᵀA_n v − (A_N g + λ)ᵀPv over v ≤ 0
//! (midpoint cone: means ≤ 0), and ‖u − v‖² = gᵀA_N g − 2 (A_N g)ᵀPv + vᵀA_n v. Elastic strips: periodic, 2 × 2 symbols.
//! Squares: n × n, cut by diagonals; u is the harmonic function of these data, errors are integrals over triangles.
//!
//! Expected: order min(τ − 1, 1) in both cones, whatever the contact set. Refuted if an order with what it may be off by
//! (±) is below a printed exponent.
//!
//! `cargo run --release --example introduction_rates -- --finest 15 --meshes 8 --out out`

// `at_most(x, b)` holds if x + its ± ≤ b, `at_least(x, b)` if x − its ± ≥ b; otherwise it fails, or is undecided
// within ±. Of several calls the worst counts. Where `stronger` holds, the statement is loose. `observe` decides
// nothing.
use example_report::prelude::*;
use signorini::cone::Cone;
use signorini::contact::Solver;
use signorini::problems::{KnownSolution, StripData, TransitionPowers};
use signorini::rates::ConvergenceOrder;
use signorini::strip::{EdgeData, Reference, StripKind, StripProblem};

example! { long "Introduction", "(E1)-(E4), known before, and (N1), (N2), new: every printed order is reached; measured: min(τ − 1, 1)";
    /// meshes of 16, 32, .. 2^finest cells along the edge of a strip
    finest: u32 = "12" in "[9, 17]",
    /// meshes of 2, 4, .. 2^meshes squares along each side
    meshes: u32 = "6" in "[4, 9]",
}

/// What stands for a regularity.
#[derive(Clone, Copy)]
enum Problem {
    Transition(TransitionPowers),
    Strip(&'static str),
    Elastic,
    ElasticInH2,
    Squares(TransitionPowers),
}
use Problem::{Elastic, ElasticInH2, Squares, Strip, Transition};

/// The data at all places of the transition, on an edge of so many cells.
fn data(problem: Problem, tau: f64, cells: usize) -> Result<Vec<EdgeData>> {
    let fifths = || (0..5).map(|k| StripData::Transition { position: 0.381966 + f64::from(k) / 80.0 });
    let sides = StripKind::Elastic.sides();
    Ok(match problem {
        Transition(powers) | Squares(powers) => [19.0 / 48.0, 20.0 / 48.0]
            .map(|a| powers.data(a, cells))
            .into_iter()
            .collect::<std::result::Result<_, _>>()?,
        Strip(name) => vec![name.parse::<StripData>()?.data(tau, cells, StripKind::Scalar.sides())?],
        Elastic => {
            fifths().map(|strip| strip.data(tau, cells, sides)).collect::<std::result::Result<_, _>>()?
        }
        ElasticInH2 => fifths()
            .map(|strip| strip.damped_data(1.0, cells, sides))
            .collect::<std::result::Result<_, _>>()?,
    })
}

/// (h, ‖u − u^h‖) on every mesh.
fn errors(problem: Problem, tau: f64, cone: Cone, options: &Options) -> Result<Vec<(f64, f64)>> {
    let mut squares: Vec<(f64, f64)> = Vec::new();
    let mut add = |k: usize, n: usize, square: f64| match squares.get_mut(k) {
        Some(sum) => sum.1 += square,
        None => squares.push((1.0 / n as f64, square)),
    };
    let mut count = 2.0;
    if let Squares(powers) = problem {
        for position in [1.0 / 3.0, 2.0 / 3.0] {
            let known = KnownSolution::transition(powers, position)?;
            for (k, n) in (1..=options.meshes).map(|k| 1usize << k).enumerate() {
                let body = known.problem(n)?;
                let u = body.solve(cone, Solver::ActiveSet)?; // interior eliminated, active set: exact to rounding
                add(k, n, known.error(&body, &u.displacement, 1e-2)?.value.powi(2)); // cubature, two rules within 1 %
            }
        }
    } else {
        let kind =
            if matches!(problem, Elastic | ElasticInH2) { StripKind::Elastic } else { StripKind::Scalar };
        let all = data(problem, tau, 16 << options.finest)?;
        count = all.len() as f64;
        for data in &all {
            let strip = StripProblem::new(kind, data, Reference::Nested, 16)?;
            let mut coarser = None;
            for (k, n) in (4..=options.finest).map(|k| 1usize << k).enumerate() {
                // Active set on the edge, each linear problem by preconditioned conjugate gradients to 1e-13.
                let u = strip.operator(n)?.0.solve_contact(&strip.load(n)?, cone, coarser.as_ref(), 1e-13)?;
                add(k, n, strip.error(n, &u.values)?.value.powi(2)); // a sum of positive terms over the waves
                coarser = Some(u);
            }
        }
    }
    Ok(squares.into_iter().map(|(h, square)| (h, (square / count).sqrt())).collect())
}

fn run(options: &Options, out: &mut Report) -> Result<()> {
    out.column("printed", "printed", "labels of the bounds that hold for it");
    out.column("nodal", "nodal", "order of ‖u − u^h‖, nodal cone");
    out.column("midpoint", "midpoint", "the same, midpoint cone");
    let powers = TransitionPowers::of_regularity;
    let in_h2 = TransitionPowers { opening: 1.0, pressure: 0.0, logarithm: 1.0 };
    type Row = (f64, &'static str, Problem, &'static [(&'static str, f64)]);
    let rows: [Row; 16] = [
        (1.4, "transition", Transition(powers(1.4)), &[("(E1)", 0.4)]),
        (1.4, "squares", Squares(powers(1.4)), &[("(E1)", 0.4)]),
        (1.5, "transition", Transition(powers(1.5)), &[("(E1)", 0.5)]),
        (1.5, "squares", Squares(powers(1.5)), &[("(E1)", 0.5)]),
        (1.75, "fat-cantor", Strip("fat-cantor:30"), &[("(E2)", 0.625), ("(N1)", 0.6875)]),
        (1.75, "transition", Transition(powers(1.75)), &[("(E2), finite", 0.75), ("(N1)", 0.6875)]),
        (1.75, "transitions", Strip("transitions:11"), &[("(E2), finite", 0.75), ("(N1)", 0.6875)]),
        (2.0, "transitions", Strip("transitions:11"), &[("(E3)", 0.75)]),
        (2.0, "in H²", Transition(in_h2), &[("(E3), finite", 1.0), ("(N2)", 1.0)]),
        (2.0, "in H², squares", Squares(in_h2), &[("(E3), finite", 1.0), ("(N2)", 1.0)]),
        (2.0, "in H², elastic", ElasticInH2, &[("(E3), finite", 1.0), ("(N2)", 1.0)]),
        (2.25, "transition", Transition(powers(2.25)), &[("(E4)", 1.0)]),
        (2.25, "elastic", Elastic, &[("(E4)", 1.0)]),
        (2.25, "squares", Squares(powers(2.25)), &[("(E4)", 1.0)]),
        (2.5, "transition", Transition(powers(2.5)), &[("(E4)", 1.0)]),
        (2.5, "squares", Squares(powers(2.5)), &[("(E4)", 1.0)]),
    ];
    for (tau, name, problem, printed) in rows {
        let optimal = (tau - 1.0).min(1.0);
        let mut orders = [Measured::NONE; 2];
        for (cone, order) in [Cone::Nodal, Cone::Midpoint].into_iter().zip(&mut orders) {
            let points = errors(problem, tau, cone, options)?;
            // The mean of all p that explain e² ≈ A h^(2p) + B h² + .., and the distance within which 96 % of them lie.
            *order = Measured::from(ConvergenceOrder::of(&points));
            for &(label, exponent) in printed {
                let above = order.value + order.error - exponent;
                out.check(format!("{label}: order + ± − exponent")).at_least(above, 0.0, "printed exponent");
            }
            if tau == 1.75 && name == "transition" {
                let claim = "τ = 7/4, transition: order − (N1)";
                out.stronger(claim).at_least(*order - 0.6875, 0.0, "11/16");
            }
            out.observe("|order − min(τ − 1, 1)| over ±").at_most(
                (order.value - optimal).abs() / order.error,
                1.0,
                "optimal order",
            );
            out.observe("order − min(τ − 1, 1) − ±").at_most(
                order.value - optimal - order.error,
                0.0,
                "no linear element does more",
            );
        }
        let labels: Vec<&str> = printed.iter().map(|(label, _)| *label).collect();
        out.row(cells! { tau, problem: name => printed: labels.join(" "), optimal, nodal: orders[0], midpoint: orders[1] });
    }
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
