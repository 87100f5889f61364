//! Theorem 3.1: the rate of convergence, ‖u − u^h‖ ≤ C h^(τ² − 5τ/2 + 2) for u in H^τ, 3/2 < τ < 2, whatever the contact set.
//!
//! Test problem: on the edge y = 0 of the unit square g ≤ 0 and a pressure λ ≥ 0, g λ = 0; u is harmonic, g on the edge, 0
//! at y = 1, without flux at the sides; ‖v‖² = ∫ |∇v|². For x < a contact, λ = (a − x)^(τ−2); for x > a g = −δ^(τ−1), δ = d
//! (2 − 2a − d)/(2 − 2a), d = x − a: u in H^s for s < τ only. On N cells: g at the nodes, ∫ λ over a cell half to each node
//! (from the last node below a up to a: all to it). u^h: linear on n × n squares cut into triangles, h = 1/n, u^h ≤ 0 at
//! the nodes of the edge (nodal cone). e: root mean square over a = 5/12, 11/24, u on N = 32·2^finest cells.
//!
//! Refuted if e/h^(τ² − 5τ/2 + 2) keeps growing: if its last increment over the one before exceeds 0.95 (those of a growth
//! like h^(−δ) grow by 2^δ; those that fall by 0.95 add up to a bound), or if `by_definition` differs by 1e-6. Loose if the
//! order p less its ± is above that exponent; expected: τ − 1. `order_of_squares`: e² ≈ A h^(2p) + B h² + const, so t(h) = 4 d(h/2)
//! − d(h) ~ h^(2p), d(h) = e(h)² − e(h/2)²; p over two halvings, ±: its largest change since three meshes before.
// near(x, b, t): |x − b| + error ≤ t; the worst call counts. stronger: the theorem is loose; observe decides nothing.
use example_report::prelude::*;
use nalgebra::{DMatrix, DVector};
use signorini::cone::Cone;
use signorini::problems::TransitionPowers;
use signorini::strip::{EdgeData, Reference, StripKind, StripProblem};

example! { seconds "Theorem 3.1", "nodal cone, u in H^τ:  ‖u − u^h‖ ≤ C h^(τ² − 5τ/2 + 2),  3/2 < τ < 2";
    /// regularities τ of the solution
    tau: Vec<f64> = "1.55,1.65,1.75,1.85,1.95" in "(1.5, 2)" slider "1.55 to 1.95",
    /// meshes of 8, 16, .. 2^finest cells along the edge
    finest: u32 = "12" in "[9, 17]" slider "9 to 13",
}

/// ‖u − u^h‖ for one a. v·A_n v: energy of the discrete harmonic function with edge values v; A_n = Σ S_k w_k w_kᵀ, w_k =
/// (cos kπi/n)ᵢ, end nodes by half, S_k = (2/n) sinh η coth nη, S_0 = 1/n², S_n by half, cosh η = 2 − cos(kπ/n). The load
/// on the edge is A_N g + λ.
fn by_definition(edge: &EdgeData, n: usize) -> Result<f64> {
    let (g, lambda) = (DVector::from_column_slice(edge.values()), DVector::from_column_slice(edge.forces()));
    let hat = |j, i| (1.0 - (j as f64 * n as f64 / edge.cells() as f64 - i as f64).abs()).max(0.0);
    let (a, p) = (harmonic_energy(n), DMatrix::from_fn(g.len(), n + 1, hat)); // p: from n to N cells
    let force = harmonic_energy(edge.cells()) * &g;
    let v = constrained_minimiser(&a, &p.tr_mul(&(&force + lambda)), &DMatrix::identity(n + 1, n + 1))?;
    Ok((g.dot(&force) - 2.0 * force.dot(&(p * &v)) + v.dot(&(a * &v))).sqrt()) // v: ½ v·A v − load·v least, v ≤ 0
}

/// The same for n = 8, .. 2^finest, by fast transforms, an active set, and conjugate gradients to 1e-13.
fn errors(edge: &EdgeData, finest: u32) -> Result<Vec<Measured>> {
    let strip = StripProblem::new(StripKind::Scalar, edge, Reference::Nested, 8)?;
    let solutions = strip.solutions(Cone::Nodal, 8, 1 << finest)?;
    solutions.iter().map(|u| Ok(strip.error(u)?.into())).collect()
}

fn run(options: &Options, out: &mut Report) -> Result<()> {
    for &tau in &options.tau {
        let (printed, optimal) = (tau * tau - 2.5 * tau + 2.0, tau - 1.0);
        let data = |a: f64, cells: usize| TransitionPowers::of_regularity(tau).data(a, cells);
        let coarse = data(5.0 / 12.0, 256)?;
        let (definition, library) = (by_definition(&coarse, 32)?, errors(&coarse, 5)?[2]);
        out.check("error, h = 1/32: by_definition/library").near(
            Measured::from(definition) / library,
            1.0,
            1e-6,
            "N = 256",
        );
        let [e, f] =
            [5.0 / 12.0, 11.0 / 24.0].map(|a| errors(&data(a, 32 << options.finest)?, options.finest));
        let squares: Vec<Measured> =
            e?.iter().zip(&f?).map(|(e, f)| (e.squared() + f.squared()) * 0.5).collect();
        let points: Vec<_> = (3..).zip(&squares).map(|(k, s)| (0.5f64.powi(k), s.sqrt())).collect();
        let order = order_of_squares(&squares, 2);
        out.row(cells! { tau => definition, library, finest: points[points.len() - 1].1, order, printed, optimal });
        let over: Vec<Measured> = points.iter().rev().map(|&(h, e)| e / h.powf(printed)).collect(); // finest first
        let ratio = (over[0] - over[1]) / (over[1] - over[2]).abs();
        out.check("ratio of successive increments of error/bound").at_most(ratio, 0.95, "bounded");
        out.observe("order − (τ − 1)").near(order - optimal, 0.0, 0.02, "Drouet, Hild 2015");
        out.stronger("order − printed exponent").at_least(order - printed, 0.0, "(3.1)");
        let axes = Axes::LogLog("h", "‖u − u^h‖");
        let plot = out.plot(&format!("theorem_3_1_errors_{tau}"), &format!("nodal cone, τ = {tau}"), axes);
        let points: Vec<_> = points.iter().map(|(h, e)| (*h, e.value)).collect();
        plot.power("the theorem", &points, printed).power("h^(τ−1)", &points, optimal).line("error", points);
    }
    Ok(())
}
