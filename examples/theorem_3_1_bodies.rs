//! Theorems 3.1 and 4.1 for bodies: the singularity is that of a corner, and a finer solution
//! stands for u.
//!
//! The paper proves ‖u − u^h‖ ≤ C h^(τ² − 5τ/2 + 2) for u in H^τ, 3/2 < τ < 2, in the energy norm.
//! u^h is linear on triangles, and ≤ 0 at the nodes of the contact edge (nodal cone), or in the
//! mean over its segments (midpoint cone). This file computes the order of the error for bodies.
//!
//! `corner`: −Δu = −1 on the square with its left side turned to the angle ω = 90°/(τ − 1), by (x,
//! y) → (x + y (1 − x) cot ω, y), ω ≥ 90°. On that side u = 0; y = 0 is the contact edge; ∂u/∂n = 0
//! on the other sides. By the maximum principle u < 0: there is no contact, and u ~ r^(τ−1) at the
//! corner, which is in H^s for s < τ only. Other bodies have the τ of their own corners: `block` is
//! in plane strain, λ = μ = 1, f = (0, −cos πx), fixed on top.
//!
//! Meshes: the grid of 2 × 2 squares, each cut from lower left to upper right; its nine nodes are
//! moved by this map; then every triangle is cut into four by its midpoints, again and again: 4, 8,
//! .. 2^finest squares along a side, h = 1/4, 1/8, ... The solution on the last mesh stands for u,
//! e(h) = ‖u − u^h‖/‖u‖ on all others, all by multigrid to 1e-10. The order p of e, at most 1, is
//! computed from e² ≈ A h^(2p) + B h² + const (`order_of_squares`):
//!
//! ```text
//! d(h) = e(h)² − e(h/2)²,     t(h) = 4 d(h/2) − d(h) ~ h^(2p),     p = ¼ log₂ |t(h)/t(h/4)|,
//! ```
//!
//! p over the last two halvings, ± its largest change since the three meshes before, or as many as
//! there are; then p is cut at 1.
//!
//! Expected is min(τ − 1, 1), once h^(2τ−2) is seen beside h². Refuted if the order with its ± is
//! below the printed exponent.
//!
//! The other cone:
//!
//! `cargo run --release --example theorem_3_1_bodies -- --tau 1.7 --cone midpoint`

use example_report::prelude::*;
use signorini::cone::Cone;
use signorini::contact::{Accuracy, ContactProblem, Settings, Solver};
use signorini::fem::Form;
use signorini::mesh::Hierarchy;
use signorini::problems::{Parameters, TestProblem};

example! { seconds "Theorems 3.1, 4.1, bodies",
    "a corner decides τ:  ‖u − u^h‖ ≤ C h^(τ² − 5τ/2 + 2),  3/2 < τ < 2";
    /// regularities τ of the solution of `corner`; other bodies are computed once
    tau: Vec<f64> = "1.6,1.75,1.9" in "[1.57, 2)" slider "1.6 to 1.95",
    /// test problems
    problem: Vec<TestProblem> = "corner",
    /// cone of the discrete problem
    cone: Cone = "nodal",
    /// meshes of 4, 8, .. 2^finest squares along a side
    finest: u32 = "9" in "[9, 11]",
}

/// (h, ‖u^* − u^h‖/‖u^*‖), ±: multigrid's error estimates of both solutions (none where a mesh is
/// so coarse that it eliminates).
fn errors(body: TestProblem, tau: f64, cone: Cone, finest: u32) -> Result<Vec<(f64, Measured)>> {
    let setting = Parameters { angle: 90.0 / (tau - 1.0), ..Parameters::default() };
    let last = finest as usize - 1;
    let hierarchy = Hierarchy::refined(body.mesh_with(2, &setting)?, last)?;
    let solve = |level: usize| -> signorini::Result<_> {
        let (mesh, meshes) = (hierarchy.levels()[level].clone(), hierarchy.up_to(level));
        let load = vec![-1.0; mesh.nodes().len()];
        let problem = match body {
            TestProblem::Corner => ContactProblem::new(mesh, Form::LAPLACE, &load)?,
            _ => body.on_with(mesh, &setting)?,
        };
        let accuracy = Accuracy::Relative(Tolerance::new(1e-10)?);
        let how = Settings {
            solver: Solver::Multigrid,
            accuracy,
            hierarchy: Some(&meshes),
            ..Settings::default()
        };
        let found = problem.solve(cone, how)?;
        let stated = found.multigrid.as_ref().and_then(|report| report.error);
        let off = stated.map_or(0.0, |norm| norm.error);
        Ok((problem, found.displacement, off))
    };
    let (problem, u, off) = solve(last)?;
    let norm = Measured::new(problem.energy_norm(&u)?, off);
    let error = |k: usize| -> Result<Measured> {
        let (_, u_h, off_h) = solve(k)?;
        let apart = problem.nested_energy_error(&hierarchy, (k, &u_h), (last, &u))?;
        Ok(Measured::new(apart, off + off_h) / norm)
    };
    (1..last).map(|k| Ok((0.5f64.powi(k as i32 + 1), error(k)?))).collect()
}

fn run(options: &Options, out: &mut Report) -> Result<()> {
    let cone = options.cone;
    for &body in &options.problem {
        let is_corner = body == TestProblem::Corner;
        for &asked in options.tau.iter().take(if is_corner { options.tau.len() } else { 1 }) {
            // 1 + the smallest exponent of the singular functions at the corners of a body
            // (section_2_singular_exponents).
            let tau = if is_corner { asked } else { body.regularity(&Parameters::default())?.tau };
            let points = errors(body, asked, cone, options.finest)?;
            let squares: Vec<Measured> = points.iter().map(|(_, e)| e.squared()).collect();
            let order = order_of_squares(&squares, 2).min(1.0);
            let (printed, optimal) = ((tau * tau - 2.5 * tau + 2.0).min(1.0), (tau - 1.0).min(1.0));
            out.row(cells! { problem: body.name(), tau =>
                finest: squares[squares.len() - 1].sqrt(), order, printed, optimal
            });
            // Undecided where an order 0.1 below the printed exponent would pass as well.
            let claim = out
                .check("order + error − printed exponent")
                .undecided_if_also_true_of(order.error - 0.1);
            claim.at_least(order.value + order.error - printed, 0.0, "(3.1), (4.2)");
            // Undecided where the printed exponent would pass as well.
            let width = order.error.max(1e-3);
            let claim = out
                .observe("|order − min(τ − 1, 1)|/error of the order")
                .undecided_if_also_true_of((printed - optimal).abs() / width);
            claim.at_most((order.value - optimal).abs() / width, 1.0, "Drouet, Hild 2015");
            let points: Vec<(f64, f64)> = points.iter().map(|&(h, e)| (h, e.value)).collect();
            let title = format!("{body}, {cone} cone, τ = {tau:.2}");
            let plot = out.plot(
                &format!("theorem_3_1_{body}_{asked}"),
                &title,
                Axes::LogLog("h", "‖u − u^h‖"),
            );
            plot.power("the theorem", &points, printed)
                .power("h^(τ−1)", &points, optimal)
                .line("error", points);
        }
    }
    out.column("finest", "finest", "error on the last mesh but one, over ‖u‖");
    Ok(())
}
