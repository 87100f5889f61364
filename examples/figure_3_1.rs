//! Figure 3.1: the exponents of three bounds over the regularity τ, and the orders that are measured.
//!
//! For u in H^τ, 3/2 < τ < 2, linear elements of size h and any contact set, ‖u − u^h‖ ≤ C h^p in the energy norm with
//!
//! ```text
//! p = τ/2 − 1/4  (E2), known before,      p = τ² − 5τ/2 + 2  (N1), Theorems 3.1 and 4.1,      p = τ − 1, optimal.
//! ```
//!
//! (N1) less (E2) is (τ − 3/2)², the optimal one less (N1) is (τ − 3/2)(2 − τ): 0 at both ends, 1/16 at τ = 7/4. The figure has
//! these curves only; here points are measured, for one end of contact at two places. Refuted if a measured order is not above
//! (N1) by more than its ±, or if a difference is not that square or product (both are positive: this is the sequence of the
//! curves). Loose if every order is τ − 1 to its ±, which Drouet and Hild (2015) prove.
//!
//! Test problem: on the edge y = 0 of the unit square g ≤ 0 and a pressure λ ≥ 0, g λ = 0; u is harmonic, g on the edge, 0
//! at y = 1, without flux at the sides. For x < a contact, λ = (a − x)^(τ−2); for x > a g = −δ^(τ−1), δ = d (2 − 2a − d)/(2
//! − 2a), d = x − a: u in H^s for s < τ only. On N = 32·2^finest cells: g at the nodes, ∫ λ over a cell half to each node
//! (from the last node below a up to a: all to it). `elastic`: plane strain, λ = μ = 1, periodic in x, contact but for (a,
//! a + 1/2), no friction, δ = (x − a)(a + 1/2 − x)/(1/2), λ = r^(τ−2), r the distance to the gap, S_k by elimination. u^h:
//! linear on n × n squares cut into triangles, h = 1/n; nodal cone: u^h ≤ 0 at the nodes of the edge; midpoint cone: means
//! over its cells ≤ 0. Squared error e²: v·A_n v is the energy of the discrete harmonic function with edge values v; A_n =
//! Σ S_k w_k w_kᵀ, w_k = (cos kπi/n)ᵢ, end nodes by half, S_k = (2/n) sinh η coth nη, S_0 = 1/n², S_n by half, cosh η = 2 −
//! cos(kπ/n). With P from n to N cells u^h has the edge values v that minimise ½ v·A_n v − (A_N g + λ)·P v in the cone, e²
//! = g·A_N g − 2 (A_N g)·P v + v·A_n v. Order: as e² ≈ A h^(2p) + B h² + const (const: u on N cells), p is that of 4 d(h/2)
//! − d(h), d(h) = e(h)² − e(h/2)² (`order_of_squares`).
// x.at_most(b), at_least(b): with its error; near(x, b, t): |x − b| plus its error ≤ t. Of several calls the worst counts.
// stronger: if it holds, the bound is loose.
use example_report::prelude::*;
use signorini::cone::Cone;
use signorini::problems::{StripData, TransitionPowers};
use signorini::strip::{Reference, StripKind, StripProblem};

example! { seconds "Figure 3.1", "τ/2 − 1/4  ≤  τ² − 5τ/2 + 2  ≤  τ − 1 for 3/2 < τ < 2, the last two 1/16 apart at 7/4;  measured: τ − 1";
    /// regularities τ
    tau: Vec<f64> = "1.55,1.6,1.65,1.7,1.75,1.8,1.85,1.9,1.95" in "(1.5, 2)",
    /// scalar, or elastic with periodic sides
    kind: StripKind = "scalar",
    /// meshes of 8, 16, .. 2^finest cells along the edge
    finest: u32 = "12" in "[8, 15]",
}

/// e², mean over a = 5/12 and 11/24, for n = 8, .. 2^finest: the square eliminated, an active set on the edge to 1e-13.
fn squares(kind: StripKind, tau: f64, cone: Cone, finest: u32) -> Result<Vec<f64>> {
    let mut squares = vec![0.0; finest as usize - 2];
    for position in [5.0 / 12.0, 11.0 / 24.0] {
        let data = match kind {
            StripKind::Scalar => TransitionPowers::of_regularity(tau).data(position, 32 << finest)?,
            StripKind::Elastic => StripData::Transition { position }.data(tau, 32 << finest, kind.sides())?,
        };
        let problem = StripProblem::new(kind, &data, Reference::Nested, 8)?;
        let mut coarser = None; // where the active set starts
        for (n, square) in (3..=finest).map(|k| 1 << k).zip(&mut squares) {
            let u = problem.operator(n)?.0.solve_contact(&problem.load(n)?, cone, coarser.as_ref(), 1e-13)?;
            *square += problem.error(n, &u.values)?.value.powi(2) / 2.0;
            coarser = Some(u);
        }
    }
    Ok(squares)
}

fn run(options: &Options, out: &mut Report) -> Result<()> {
    for &tau in &options.tau {
        let (earlier, printed, optimal) = (0.5 * tau - 0.25, tau * tau - 2.5 * tau + 2.0, tau - 1.0);
        let measured = |cone| Ok(order_of_squares(&squares(options.kind, tau, cone, options.finest)?, 2));
        let [nodal, midpoint]: [Result<Measured>; 2] = [Cone::Nodal, Cone::Midpoint].map(measured);
        let (nodal, midpoint) = (nodal?, midpoint?);
        out.row(cells! { tau => earlier, printed, optimal, nodal, midpoint });
        for (cone, order) in [("nodal", nodal), ("midpoint", midpoint)] {
            out.check(format!("{cone} cone: order − (N1)")).at_least(order - printed, 0.0, "(3.1), (4.2)");
            let distance = Measured::from((order.value - optimal).abs() / order.error);
            let claim = format!("{cone} cone: |order − (τ − 1)|/error");
            out.stronger(claim).at_most(distance, 1.0, "Drouet, Hild 2015");
        }
        out.check("(N1) − (E2)").near(printed - earlier, (tau - 1.5).powi(2), 1e-15, "(τ − 3/2)²");
        let apart = (tau - 1.5) * (2.0 - tau);
        out.check("(τ − 1) − (N1)").near(optimal - printed, apart, 1e-15, "(τ − 3/2)(2 − τ)");
    }
    out.column("earlier", "(E2)", "τ/2 − 1/4");
    out.column("printed", "(N1)", "τ² − 5τ/2 + 2");
    out.column("optimal", "τ − 1", "");
    let taus = || (0..=50).map(|k| 1.5 + 0.01 * f64::from(k));
    out.plot("figure_3_1", "Exponents over the regularity", Axes::Linear("τ", "exponent of h"))
        .points("tau", "nodal")
        .points("tau", "midpoint")
        .dashed_line("(E2), τ/2 − 1/4", taus().map(|tau| (tau, 0.5 * tau - 0.25)).collect())
        .line("(N1), τ² − 5τ/2 + 2", taus().map(|tau| (tau, tau * tau - 2.5 * tau + 2.0)).collect())
        .dashed_line("τ − 1", taus().map(|tau| (tau, tau - 1.0)).collect());
    Ok(())
}
