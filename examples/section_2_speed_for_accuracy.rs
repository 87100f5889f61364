//! Section 2: speed for accuracy of contact solvers, on a problem with known solution.
//!
//! On the unit square, with z = x + iy, let u = −Re (z − 2/5)^(3/2): harmonic, 0 on the bottom edge for x < 2/5 (contact) and
//! −(x − 2/5)^(3/2) beyond (gap), with ∂u/∂n ≤ 0 in contact and 0 in the gap. So u solves the scalar Signorini problem
//! with contact on the bottom edge, its own values prescribed on top, its own ∂u/∂n on both sides. u is in H^s for s < 5/2.
//!
//! ```text
//! |u − v|_a  ≤  |u − u^h|_a + |u^h − v|_a,      |v|_a² = ∫ |∇v|²,      |u − u^h|_a ≤ C h for linear elements
//! ```
//!
//! u^h is the discrete solution (2.9) on n × n squares, cut into triangles; v what a solver returns. The first term belongs
//! to the mesh, the second to the algebra: a hundredth of the first is worth nothing.
//!
//! Expected: order 1 whatever solves the discrete problem. Refuted if the order is off by more than 0.1, if a solver to
//! ten digits changes |u − v|_a by more than 1e-6 of it or one to a hundredth by more than 1e-3, if a true algebraic error
//! is above its estimate, or if the error from the definition is off by more than 0.3 %.
//!
//! `cargo run --release --example section_2_speed_for_accuracy -- --n 16,64,256,1024 --cone midpoint`

use example_report::prelude::*;
use signorini::cone::Cone;
use signorini::contact::{Accuracy, ContactProblem, ContactSolution, Settings, Solver};
use signorini::fem::gradients;
use signorini::problems::KnownSolution;
use signorini::rates::ConvergenceOrder;
use std::time::Instant;

example! { seconds "Section 2, speed for accuracy", "|u − u^h|_a ≤ C h for u in H^(5/2−ε), whatever solves the discrete problem;  C h/100 of algebra changes nothing";
    /// squares along each side, coarsest mesh first
    n: Vec<usize> = "8,16,32,64,128,256" in "[4, 2048]",
    /// discrete cone: nodal (2.9) or midpoint (4.1)
    cone: Cone = "nodal",
}

/// |u − v|_a from its definition: ∇v is constant on triangles, ∇u = (Re f', −Im f') for f' = −3/2 (z − 2/5)^(1/2), and the
/// integral is a third of the area at the middle of each side.
fn by_definition(problem: &ContactProblem, v: &[f64]) -> Result<f64> {
    let mesh = problem.mesh();
    let mut square = 0.0;
    for (t, slope) in gradients(mesh, v)?.into_iter().enumerate() {
        let [a, b, c] = mesh.corners(t);
        let area = 0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]));
        for (p, q) in [(a, b), (b, c), (c, a)] {
            let [x, y] = [0.5 * (p[0] + q[0]) - 0.4, 0.5 * (p[1] + q[1])];
            let (size, angle) = (1.5 * x.hypot(y).sqrt(), 0.5 * y.atan2(x));
            let off = [-size * angle.cos() - slope[0], size * angle.sin() - slope[1]];
            square += area / 3.0 * (off[0] * off[0] + off[1] * off[1]);
        }
    }
    Ok(square.sqrt())
}

fn run(options: &Options, out: &mut Report) -> Result<()> {
    out.column("error", "error", "|u − v|_a");
    out.column("definition", "definition", "the same by `by_definition`");
    out.column("algebraic", "algebraic", "|u^h − v|_a/|u^h|_a, u^h by the active set");
    out.column("estimate", "estimate", "what multigrid states for it");
    out.column("steps", "steps", "linear systems, barrier steps, or cycles on the finest mesh");
    out.column("ms", "ms", "milliseconds for mesh, assembly, solution");
    let known = KnownSolution::three_halves();
    let multigrid = |accuracy| Settings { solver: Solver::Multigrid, accuracy, ..Settings::default() };
    let mut errors = Vec::new();
    for &n in &options.n {
        let mut exact: Option<(f64, ContactSolution)> = None; // |u − u^h|_a and u^h
        let solvers: [(&str, usize, Settings<'_>); 5] = [
            // Interior eliminated by a sparse factorisation, then guesses of the contact set on the edge: exact to rounding.
            ("active set", 1024, Solver::ActiveSet.into()),
            // Primal-dual path (Clarabel) on all unknowns; the same on the edge.
            ("interior point", 64, Solver::InteriorPoint.into()),
            ("interior point, edge", 1024, Solver::EdgeInteriorPoint.into()),
            // Nested iteration; gradients with a V-cycle on the contact set in hand; stops by an estimate of |u^h − v|_a.
            ("multigrid, 1e-10", 2048, multigrid(Accuracy::Relative(Tolerance::new(1e-10)?))),
            ("multigrid, h/100", 2048, multigrid(Accuracy::OfDiscretisation(0.01))),
        ];
        for (name, _, settings) in solvers.into_iter().filter(|(_, most, _)| n <= *most) {
            let start = Instant::now();
            let problem = known.problem(n)?;
            let v = problem.solve(options.cone, settings)?;
            let ms = (1e5 * start.elapsed().as_secs_f64()).ceil() / 100.0;
            // Cubature of |∇u − ∇v|² on each triangle, refined towards the transition.
            let error = known.error_norms(&problem, &v.displacement)?.h1;
            let definition = by_definition(&problem, &v.displacement)?;
            let estimate = v.multigrid.as_ref().and_then(|report| report.error).map(|e| e.relative_error());
            let algebraic = exact.as_ref().map(|(_, u)| -> Result<f64> {
                let apart: Vec<f64> =
                    u.displacement.iter().zip(&v.displacement).map(|(a, b)| a - b).collect();
                Ok(problem.energy_norm(&apart)? / problem.energy_norm(&u.displacement)?)
            });
            let algebraic = algebraic.transpose()?;
            out.row(cells! { n, solver: name => error, definition, algebraic, estimate, steps: v.work.iterations as usize, ms });
            out.check("error by its definition, over error").near(
                definition / error,
                1.0,
                3e-3,
                "side middles",
            );
            if let Some((of_mesh, _)) = &exact {
                let change = (error / of_mesh - 1.0).abs();
                if name.ends_with("h/100") {
                    out.check("h/100: change of the error").at_most(change, 1e-3, "a thousandth");
                } else {
                    out.check("ten digits: change of the error").at_most(change, 1e-6, "six digits");
                }
            }
            if !name.ends_with("h/100") {
                out.check("conditions of contact, scaled").at_most(v.kkt.worst(), 1e-8, "(2.5)");
            }
            if let (Some(algebraic), Some(estimate)) = (algebraic, estimate) {
                out.check("algebraic error over its estimate").at_most(
                    algebraic / (estimate + 1e-13),
                    1.0,
                    "stated",
                );
            }
            if exact.is_none() {
                errors.push((1.0 / n as f64, error));
                exact = Some((error, v));
            }
        }
    }
    if let Some(order) = ConvergenceOrder::of(&errors) {
        out.check("order of |u − u^h|_a").near(order, 1.0, 0.1, "linear elements");
    }
    out.plot(
        &format!("section_2_seconds_{}", options.cone),
        "True error against seconds",
        Axes::LogLog("milliseconds", "|u − v|_a"),
    )
    .curve_by("solver", "ms", "error");
    Ok(())
}
