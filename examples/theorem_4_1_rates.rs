//! Theorem 4.1: the rate of convergence in the midpoint cone.
//!
//! Let u solve Signorini's problem and be in H^τ. Let u^h be its approximation by continuous
//! piecewise linear functions whose mean over each segment of the contact edge is ≤ 0. This mean is
//! the value at the midpoint, hence the name of the cone; elsewhere u^h may penetrate. The paper
//! proves, whatever the contact set,
//!
//! ```text
//! ‖u − u^h‖ ≤ C h^p,     p = τ² − 5τ/2 + 2 for 3/2 < τ < 2  (4.2),     p = 1 for τ > 2  (4.4).
//! ```
//!
//! At τ = 2 the bound, (4.3), has a logarithm: see example `equation_3_2_logarithm`.
//!
//! This file computes the error e for a known solution on meshes h = 1/8, 1/16, .. 2^(−finest). On
//! the edge y = 0 of the unit square let u = g ≤ 0, and let the pressure there be λ ≥ 0, with g = 0
//! for x ≤ a and λ = 0 for x > a (`transition`). Inside u is harmonic, u = 0 at y = 1, and there is
//! no flux at the sides; ‖v‖² = ∫ |∇v|². At the transition a, λ and g behave like the powers τ − 2
//! and τ − 1 of the distance, so that u is in H^s for s < τ only. For τ > 2 the theorem gives h.
//! For τ < 2 it gives every order below p. So h^p itself is a little more than it says, but growth
//! of e/h^p like a power of 1/h would contradict it. u^h is linear on n × n squares cut into
//! triangles, h = 1/n; u itself is taken on N = 32 · 2^finest cells. The error depends on where a
//! lies in its segment. So e is the root mean square of the errors for a = 5/12 and a = 11/24,
//! which lie at one third or two thirds of a segment on every mesh.
//!
//! Refuted if e/h^p keeps growing. An increment is the change of e/h^p from one mesh to the next.
//! Growth like h^(−δ) has increments that grow by the factor 2^δ from mesh to mesh. Increments that
//! shrink by a fixed factor add up to a bound. So the last increment may be at most 0.95 times the
//! modulus of the one before. Where e/h^p falls, the increment is negative.
//!
//! One error is computed twice, from the definition and by the library, at n = 32 with N = 256.
//! Refuted too if the two differ by more than 1e-6 of the error. Undecided while a bound lies
//! inside of an error bar.
//!
//! (4.2) is loose if, for τ < 2, the order of e, less its ±, is above p. The expected order is
//! min(τ − 1, 1), the best possible for this u (Drouet and Hild, 2015). Whether the order is within
//! 0.02 of it is only shown, and refutes nothing.
//!
//! The order q is computed from e² ≈ A h^(2q) + B h² + const. B h² is from the smooth part of the
//! error, and the constant is there because u itself is on N cells. d removes the constant, and t
//! removes B h²:
//!
//! ```text
//! d(h) = e(h)² − e(h/2)²,     t(h) = 4 d(h/2) − d(h) ~ h^(2q),     q = ¼ log₂ |t(h)/t(h/4)|;
//! ```
//!
//! its ± is the largest |q − q'| over the q' of the three meshes before, plus what the ± of e does
//! to q. The ± of e is rounding and what conjugate gradients leave. If q is above 1, B h² is the
//! larger part of e², and q is replaced by 1.
//!
//! For another contact set change `transition`. The other cone is in example `theorem_3_1_rates`.
//! Another regularity is given by the option `--tau`:
//!
//! `cargo run --release --example theorem_4_1_rates -- --tau 1.7`

use example_report::prelude::*;
use nalgebra::{DMatrix, DVector};
use signorini::cone::Cone;
use signorini::strip::{EdgeData, LateralCondition, Reference, StripKind, StripProblem};

example! { seconds "Theorem 4.1",
    "midpoint cone:  ‖u − u^h‖ ≤ C h^(τ² − 5τ/2 + 2) for 3/2 < τ < 2,  ≤ C h for τ > 2";
    /// regularities τ of the solution, other than 2
    tau: Vec<f64> = "1.55,1.65,1.75,1.85,1.95,2.25" in "(1.5, 2.5]" slider "1.55 to 1.95",
    /// meshes of 8, 16, .. 2^finest cells along the edge
    finest: u32 = "12" in "[9, 17]" slider "9 to 13",
}

/// The data of the test problem on N cells: contact on (0, a), a gap on (a, 1).
fn transition(a: f64, tau: f64, cells: usize) -> Result<EdgeData> {
    let x = |i: usize| i as f64 / cells as f64;
    // g at the nodes: 0 up to a, then −gap(d)^(τ−1) with the distance d = x − a. For small d,
    // gap(d) is almost d; at x = 1 its slope is 0.
    let gap = |d: f64| d * (2.0 - 2.0 * a - d) / (2.0 - 2.0 * a);
    let g: Vec<f64> =
        (0..=cells).map(|i| if x(i) <= a { 0.0 } else { -gap(x(i) - a).powf(tau - 1.0) }).collect();
    // Forces at the nodes: the integral of λ = (a − x)^(τ−2) over a cell, half to each of its
    // nodes; from the last node below a up to a, all to that node.
    let integral_from = |x: f64| (a - x).powf(tau - 1.0) / (tau - 1.0); // ∫ λ over (x, a)
    let last = (a * cells as f64).floor() as usize;
    let mut force = vec![0.0; cells + 1];
    for i in 0..last {
        let on_cell = integral_from(x(i)) - integral_from(x(i + 1));
        force[i] += 0.5 * on_cell;
        force[i + 1] += 0.5 * on_cell;
    }
    force[last] += integral_from(x(last));
    Ok(EdgeData::new(cells, LateralCondition::Natural, &g, &force)?)
}

/// ‖u − u^h‖ from the definition, for one a. Let v·A_n v be the energy of the discrete harmonic
/// function with the edge values v on n cells:
///
/// ```text
/// A_n = Σ_k S_k w_k w_kᵀ over k = 0, .. n,     w_k = (cos kπi/n)ᵢ, first and last entry halved,
/// S_0 = 1/n²,     S_k = (2/n) sinh η coth nη, S_n half of that,     sinh(η/2) = sin(kπ/(2n)).
/// ```
///
/// The load on the edge that has u as its solution is A_N g + λ. The values v of u^h minimise
/// ½ v·A_n v − (A_N g + λ)·P v over means ≤ 0, P the linear interpolation from n to N cells, and
/// ‖u − u^h‖² = g·A_N g − 2 (A_N g)·P v + v·A_n v.
fn by_definition(edge: &EdgeData, n: usize) -> Result<f64> {
    let cells = edge.cells();
    let g = DVector::from_column_slice(edge.values());
    let lambda = DVector::from_column_slice(edge.forces());
    let hat = |t: f64| (1.0 - t.abs()).max(0.0);
    let ratio = n as f64 / cells as f64;
    let p = DMatrix::from_fn(cells + 1, n + 1, |j, i| hat(j as f64 * ratio - i as f64));
    let a_n = harmonic_energy(n);
    let a_g = harmonic_energy(cells) * &g; // A_N g
    let load = p.tr_mul(&(&a_g + lambda));
    let means = DMatrix::from_fn(n, n + 1, |t, i| if i == t || i == t + 1 { 0.5 } else { 0.0 });
    let v = constrained_minimiser(&a_n, &load, &means)?; // means of v ≤ 0
    Ok((g.dot(&a_g) - 2.0 * a_g.dot(&(p * &v)) + v.dot(&(a_n * &v))).sqrt())
}

/// ‖u − u^h‖² for n = 8, 16, .. 2^finest: the same with fast transforms, an active set, and
/// conjugate gradients to 1e-13.
fn squared_errors(edge: &EdgeData, finest: u32) -> Result<Vec<Measured>> {
    // Nested: u is the function on the N cells of `edge` itself; n is at least 8.
    let exact = StripProblem::new(StripKind::Scalar, edge, Reference::Nested, 8)?;
    let solutions = exact.solutions(Cone::Midpoint, 8, 1 << finest)?;
    solutions.iter().map(|u_h| Ok(Measured::from(exact.error(u_h)?).squared())).collect()
}

/// What the theorem says and what is found for one τ.
pub struct Rate {
    /// p = τ² − 5τ/2 + 2, at most 1.
    pub printed: f64,
    /// min(τ − 1, 1).
    pub optimal: f64,
    /// The order of the error.
    pub order: Measured,
}

pub(crate) fn run(options: &Options, out: &mut Report) -> Result<Vec<Rate>> {
    let mut rates = Vec::new();
    for &tau in &options.tau {
        if tau == 2.0 {
            return Err(Error::option("tau", "at 2 (4.3) has ln h: see equation_3_2_logarithm"));
        }
        let (printed, optimal) = ((tau * tau - 2.5 * tau + 2.0).min(1.0), (tau - 1.0).min(1.0));

        // One error twice: n = 32, N = 256.
        let coarse = transition(5.0 / 12.0, tau, 256)?;
        let definition = by_definition(&coarse, 32)?;
        let library = squared_errors(&coarse, 5)?[2].sqrt(); // of n = 8, 16, 32
        let claim = out.check("error, h = 1/32: by_definition/library");
        claim.whole_error_bars_differ_by_at_most(
            library.recip() * definition,
            1.0,
            1e-6,
            "N = 256",
        );

        // e² on all meshes: the mean over two places of the transition.
        let meshes: Vec<f64> = (3..=options.finest).map(|k| 0.5f64.powi(k as i32)).collect(); // h
        let mut squares = vec![Measured::from(0.0); meshes.len()];
        for a in [5.0 / 12.0, 11.0 / 24.0] {
            let edge = transition(a, tau, 32 << options.finest)?;
            for (mean, square) in squares.iter_mut().zip(squared_errors(&edge, options.finest)?) {
                *mean = *mean + square * 0.5;
            }
        }

        // Does e/h^p keep growing?
        let over_bound: Vec<Measured> =
            meshes.iter().zip(&squares).map(|(h, e2)| e2.sqrt() / h.powf(printed)).collect();
        let k = meshes.len() - 1;
        let last = over_bound[k] - over_bound[k - 1];
        let before = over_bound[k - 1] - over_bound[k - 2];
        let ratio = last / before.abs();
        let order = order_of_squares(&squares, 2).min(1.0); // 2 halvings of h, t(h) to t(h/4)
        out.row(cells! { tau =>
            definition, library: library.value, finest: squares[k].sqrt().value,
            over_bound: over_bound[k].value, increments: ratio.value, order, printed, optimal
        });

        let range = if tau < 2.0 { "3/2 < τ < 2" } else { "τ > 2" };
        let claim = out.check(format!("{range}: ratio of successive increments of error/bound"));
        claim.whole_error_bars_at_most(ratio, 0.95, "bounded");
        let claim = out.observe("order − min(τ − 1, 1)");
        claim.whole_error_bars_differ_by_at_most(order - optimal, 0.0, 0.02, "Drouet, Hild 2015");
        if tau < 2.0 {
            let claim = out.stronger("τ < 2: order − printed exponent");
            claim.whole_error_bars_at_least(order - printed, 0.0, "(4.2)");
        }
        rates.push(Rate { printed, optimal, order });

        let points: Vec<_> =
            meshes.iter().zip(&squares).map(|(&h, e2)| (h, e2.sqrt().value)).collect();
        let name = format!("theorem_4_1_errors_{tau}");
        out.plot(&name, &format!("midpoint cone, τ = {tau}"), Axes::LogLog("h", "‖u − u^h‖"))
            .power("the theorem", &points, printed)
            .power("h^min(τ−1, 1)", &points, optimal)
            .line("error", points);
    }
    out.column(
        "definition",
        "definition",
        "‖u − u^h‖ by `by_definition`, n = 32, N = 256, a = 5/12",
    );
    out.column("library", "library", "the same by the library");
    out.column("finest", "e", "error on the finest mesh");
    out.column("over_bound", "e/h^p", "error over the bound on the finest mesh");
    let meaning = "last increment of e/h^p over the modulus of the one before; < 0: e/h^p falls";
    out.column("increments", "ratio", meaning);
    out.column("order", "order", "of e");
    out.column("printed", "p", "exponent of the theorem");
    out.column("optimal", "min(τ−1, 1)", "expected order");
    Ok(rates)
}
