//! Theorem 3.1: the rate of convergence, ‖u − u^h‖ ≤ C h^(τ² − 5τ/2 + 2) for u in H^τ, 3/2 < τ < 2, whatever the contact set.
//!
//! u^h: linear triangles of size h, u^h ≤ 0 at the nodes of the contact edge (nodal cone); energy norm. Test problem: on the
//! edge y = 0 of the unit square choose g ≤ 0 and a pressure λ ≥ 0, g λ = 0; u is harmonic, g on the edge, 0 on top, without
//! flux at the sides. Contact for x < a: λ = (a − x)^(τ−2); then g = −δ^(τ−1), δ = d (2 − 2a − d)/(2 − 2a), d = x − a: u in H^s
//! for s < τ only. Errors: root mean squares over a = 5/12 and 11/24, u replaced by its values on a grid 32 times finer than the last.
//! Expected: order τ − 1, (τ − 3/2)(2 − τ) above the theorem's. Refuted if error/bound keeps growing (growth like h^(−δ) has
//! increments that grow by 2^δ; here they are negative, or fall by 0.95) or if `by_definition` differs by one in a million.
// `at_most(x, b)` holds if x + its ± ≤ b, `at_least(x, b)` if x − its ± ≥ b, `near(x, b, t)` if |x − b| + its ± ≤ t;
// otherwise it fails, or is undecided within ±. Of several calls the worst counts. Where `stronger` holds, the
// statement is loose. `observe` decides nothing.
use example_report::prelude::*;
use nalgebra::{DMatrix, DVector};
use signorini::strip::{EdgeData, Reference, StripKind, StripProblem};
use signorini::{cone::Cone, problems::TransitionPowers, rates::ConvergenceOrder};
use std::f64::consts::SQRT_2;

example! { seconds "Theorem 3.1", "nodal cone, u in H^τ:  ‖u − u^h‖ ≤ C h^(τ² − 5τ/2 + 2),  3/2 < τ < 2";
    /// regularities τ of the solution
    tau: Vec<f64> = "1.55,1.65,1.75,1.85,1.95" in "(1.5, 2)" slider "1.55 to 1.95",
    /// meshes of 8, 16, .. 2^finest cells along the edge
    finest: u32 = "12" in "[9, 17]" slider "9 to 13",
}

/// ‖u − u^h‖, u^h on n × n squares cut into triangles, u on N × N. v·A_n v is the energy of the discrete harmonic function with
/// edge values v: A_n multiplies the wave cos kπx by sinh η coth nη, cosh η = 2 − cos(kπ/n). The load on the edge is A_N g + λ.
fn by_definition(edge: &EdgeData, below: &DMatrix<f64>) -> Result<f64> {
    let (g, n) = (DVector::from_column_slice(edge.values()), below.ncols() - 1);
    let hat = |j, i| (1.0 - (j as f64 * n as f64 / edge.cells() as f64 - i as f64).abs()).max(0.0);
    let (a, p) = (harmonic_energy(n), DMatrix::from_fn(g.len(), n + 1, hat)); // p: from n to N cells
    let force = harmonic_energy(edge.cells()) * &g;
    let load = p.tr_mul(&(&force + DVector::from_column_slice(edge.forces())));
    let v = constrained_minimiser(&a, &load, below)?; // ½ v·A v − load·v least, `below` v ≤ 0
    Ok((g.dot(&force) - 2.0 * force.dot(&(p * &v)) + v.dot(&(a * &v))).sqrt())
}

/// (h, ‖u − u^h‖), h = 1/8, .. 2^−finest: as `by_definition`, by fast transforms, an active set, and conjugate gradients.
fn errors(edge: &EdgeData, cone: Cone, finest: u32) -> Result<Vec<(f64, f64)>> {
    let strip = StripProblem::new(StripKind::Scalar, edge, Reference::Nested, 8)?;
    let solve = |n| strip.operator(n)?.0.solve_contact(&strip.load(n)?, cone, None, 1e-13);
    let error = |n| Ok((1.0 / n as f64, strip.error(n, &solve(n)?.values)?.value));
    (3..=finest).map(|k| error(1 << k)).collect()
}

/// For either theorem: solve, halve h, fit. `below` v are the numbers that its cone asks to be ≤ 0.
pub fn rates(name: &str, cone: Cone, below: &DMatrix<f64>, of: &Options, out: &mut Report) -> Result<()> {
    for &tau in &of.tau {
        let data = |a: f64, cells: usize| TransitionPowers::of_regularity(tau).data(a, cells); // g at nodes, ∫ λ over cells
        let coarse = data(5.0 / 12.0, 256)?;
        let (definition, library) = (by_definition(&coarse, below)?, errors(&coarse, cone, 5)?[2].1);
        out.check("by_definition over the library, h = 1/32").near(definition / library, 1.0, 1e-6, "256");
        let [e, f] = [5.0 / 12.0, 11.0 / 24.0].map(|a| errors(&data(a, 32 << of.finest)?, cone, of.finest));
        let points: Vec<_> = e?.iter().zip(&f?).map(|(e, f)| (e.0, e.1.hypot(f.1) / SQRT_2)).collect();
        // p of e² ≈ A h^(2p) + B h² + ..; all p that explain the errors as well, u on the fine grid or not, are within ±.
        let [mut order, fine] = [None, Some(0.5f64.powi(of.finest as i32 + 5))]
            .map(|grid| Measured::from(ConvergenceOrder::against(&points, grid)));
        order.error = order.error.max(0.5 * (order - fine).value.abs());
        let (printed, optimal) = ((tau * tau - 2.5 * tau + 2.0).min(1.0), (tau - 1.0).min(1.0)); // τ > 2: (4.4)
        let over: Vec<f64> = points.iter().rev().map(|(h, error)| error / h.powf(printed)).collect();
        out.row(cells! { tau => definition, library, finest: points[points.len() - 1].1, order, printed, optimal });
        let range = if tau < 2.0 { "3/2 < τ < 2" } else { "τ > 2" };
        let claim = out.check(format!("{range}: increment of error/bound over the one before"));
        claim.at_most((over[0] - over[1]) / (over[1] - over[2]).abs(), 0.95, "bounded");
        out.observe("order − min(τ − 1, 1)").near(order - optimal, 0.0, 0.1, "Drouet, Hild 2015");
        if optimal - printed > 0.05 {
            let claim = out.stronger("order − printed exponent, where τ − 1 is 0.05 above it");
            claim.at_least(order - printed, 0.0, "(3.1), (4.2)");
        }
        let axes = Axes::LogLog("h", "‖u − u^h‖");
        let plot = out.plot(&format!("{name}_errors_{tau}"), &format!("{cone} cone, τ = {tau}"), axes);
        plot.power("the theorem", &points, printed).power("h^(τ−1)", &points, optimal).line("error", points);
    }
    out.column("library", "library", "‖u − u^h‖ for h = 1/32, a = 5/12, as by_definition");
    out.column("optimal", "optimal", "the exponent min(τ − 1, 1)");
    Ok(())
}

fn run(options: &Options, out: &mut Report) -> Result<()> {
    rates("theorem_3_1", Cone::Nodal, &DMatrix::identity(33, 33), options, out)
}
