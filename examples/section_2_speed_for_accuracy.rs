//! Section 2: speed for accuracy of contact solvers: the error belongs to the mesh, whatever solves
//! the discrete problem.
//!
//! The introduction, (E4), has for u in H^s with s > 2 the rate h of linear elements,
//!
//! ```text
//! |u − u^h|_a ≤ C h,        |v|²_a = a(v, v) = ∫ |∇v|²,
//! ```
//!
//! where u^h is the discrete solution (2.9): it minimises J(v) = ½ a(v, v) − l(v) over the cone of
//! the v with v ≤ 0 at the nodes of the contact edge, or with means ≤ 0 over its segments. A
//! program returns some other v, and
//!
//! ```text
//! |u − v|_a  ≤  |u − u^h|_a + |u^h − v|_a.
//! ```
//!
//! The first term belongs to the mesh, the second to the solver. This file solves a problem with
//! known u by four solvers and computes both terms.
//!
//! The problem, on the unit square with z = x + iy and contact on the bottom edge y = 0:
//!
//! ```text
//! u = −Re (z − 2/5)^(3/2),     harmonic, in H^s for s < 5/2;
//! bottom    u = 0, ∂u/∂n ≤ 0 for x < 2/5 (contact),   u = −(x − 2/5)^(3/2), ∂u/∂n = 0 beyond (gap)
//! top       the nodal values of u are prescribed
//! sides     the load ∂u/∂n, by five Gauss points on each segment
//! ```
//!
//! So u solves the scalar Signorini problem with these data. The meshes have n × n squares, each
//! cut from bottom left to top right.
//!
//! Multigrid stops where its own estimate of |u^h − v|_a is small enough: below 1e-10 of |v|_a
//! (`multigrid, 1e-10`), or below a hundredth of the first term as coarser meshes show it
//! (`multigrid, h/100`). The estimate is
//!
//! ```text
//! R/2 + (R²/4 + S)^(1/2),     R the dual norm of l − a(v, ·) − λ,  by one more cycle,
//!                             S = −∫ λ v,  λ ≥ 0 the contact forces.
//! ```
//!
//! Refuted if the order of |u − u^h|_a in h, between the last two meshes, differs by more than 0.1
//! from 1; if a solver to ten digits changes |u − v|_a by more than 1e-6 of it, or `multigrid,
//! h/100` by more than 1e-3; if the J of a solver to ten digits differs by more than 1e-11 of it
//! from that of the active set, or one constraint is active for only one of them; if |u^h − v|_a,
//! u^h by the active set, is above the estimate of multigrid plus 1e-13 (rounding), both over
//! |u^h|_a; or if |u − v|_a from its definition differs by 0.3 %. Other bodies, materials and
//! meshes: `tests/section_2/multigrid.rs`. Undecided while a bound lies inside of an error bar.
//!
//! ```text
//! cargo run --release --example section_2_speed_for_accuracy -- \
//!     --n 16,64,256,1024 --cone midpoint
//! ```

use example_report::prelude::*;
use signorini::cone::Cone;
use signorini::contact::{Accuracy, ContactProblem, ContactSolution, Settings, Solver};
use signorini::fem::gradients;
use signorini::problems::KnownSolution;
use std::time::Instant;

example! { seconds "Section 2, speed for accuracy",
    "|u − u^h|_a ≤ C h, whatever solves the discrete problem";
    /// squares along each side, coarsest mesh first
    n: Vec<usize> = "8,16,32,64,128,256" in "[4, 2048]",
    /// discrete cone: nodal (2.9) or midpoint (4.1)
    cone: Cone = "nodal",
    /// number of timed runs, of which the median is reported
    repeat: usize = "3" in "[1, 100]",
}

/// |u − v|_a from its definition. With f' = −3/2 (z − 2/5)^(1/2), ∇u = (Re f', −Im f'), and ∇v is
/// constant on a triangle. The integral of |∇u − ∇v|² over a triangle is taken as a third of its
/// area times the sum of the values at the middles of its sides.
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

/// The solvers, by name.
const SOLVERS: [&str; 4] = ["active set", "multigrid, 1e-10", "multigrid, h/100", "interior point"];

fn settings(solver: &str) -> Result<Settings<'static>> {
    let multigrid =
        |accuracy| Settings { solver: Solver::Multigrid, accuracy, ..Settings::default() };
    Ok(match solver {
        // Interior eliminated by a sparse factorisation, then guesses of the contact set on the
        // edge: exact to rounding.
        "active set" => Solver::ActiveSet.into(),
        // Nested iteration; gradients with a V-cycle on the contact set in hand; stops by an
        // estimate of |u^h − v|_a.
        "multigrid, 1e-10" => multigrid(Accuracy::Relative(Tolerance::new(1e-10)?)),
        "multigrid, h/100" => multigrid(Accuracy::OfDiscretisation(0.01)),
        // Primal-dual path (Clarabel) on all unknowns.
        _ => Solver::InteriorPoint.into(),
    })
}

fn run(options: &Options, out: &mut Report) -> Result<()> {
    out.column("error", "error", "|u − v|_a");
    out.column("definition", "definition", "the same by `by_definition`");
    out.column("algebraic", "algebraic", "|u^h − v|_a/|u^h|_a, u^h by the active set");
    out.column("estimate", "estimate", "what multigrid states");
    out.column("steps", "steps", "linear systems, barrier steps, or cycles");
    out.column("ms", "ms", "median of the milliseconds, with mesh and assembly");
    let known = KnownSolution::three_halves();
    let mut errors = Vec::new();
    for &n in &options.n {
        let mut exact: Option<(f64, ContactSolution)> = None; // |u − u^h|_a and u^h
        // The interior point method is slow beyond these meshes.
        let solvers = if n <= 64 { &SOLVERS[..] } else { &SOLVERS[..3] };
        for &solver in solvers {
            // A new problem each time: no solver finds the factors of another.
            let timed = || -> Result<(ContactProblem, ContactSolution, f64)> {
                let start = Instant::now();
                let problem = known.problem(n)?;
                let v = problem.solve(options.cone, settings(solver)?)?;
                Ok((problem, v, 1e3 * start.elapsed().as_secs_f64()))
            };
            let (problem, v, first) = timed()?;
            let mut times = vec![first];
            for _ in 1..options.repeat {
                let (_, _, again) = timed()?;
                times.push(again);
            }
            times.sort_by(f64::total_cmp);
            let ms = (100.0 * times[options.repeat / 2]).ceil() / 100.0;
            // Cubature of |∇u − ∇v|² on each triangle, refined towards the transition: to 1e-4.
            let error = known.error_norms(&problem, &v.displacement)?.h1;
            let definition = by_definition(&problem, &v.displacement)?;
            let over = definition / error;
            let claim = out.check("|u − v|_a: by_definition/library");
            claim.differ_by_at_most(over, 1.0, 3e-3, "edge midpoint rule");
            let estimate =
                v.multigrid.as_ref().and_then(|report| report.error).map(|e| e.relative_error());
            let mut algebraic = None;
            if let Some((of_mesh, u)) = &exact {
                let apart: Vec<f64> =
                    u.displacement.iter().zip(&v.displacement).map(|(a, b)| a - b).collect();
                let distance =
                    problem.energy_norm(&apart)? / problem.energy_norm(&u.displacement)?;
                let change = (error / of_mesh - 1.0).abs();
                if solver.ends_with("h/100") {
                    let claim = out.check("multigrid, h/100: change of |u − v|_a");
                    claim.at_most(change, 1e-3, "0.1 % of the error");
                } else {
                    let claim = out.check("solvers to 1e-10: change of |u − v|_a");
                    claim.at_most(change, 1e-6, "six digits");
                    let of_j = (v.energy / u.energy - 1.0).abs();
                    out.check("two solvers: |ΔJ|/|J|").at_most(of_j, 1e-11, "rounding error");
                    let other = v.contact_set.distance(&u.contact_set);
                    let claim = out.check("constraints active for only one solver");
                    claim.at_most(other, 0.0, "uniqueness");
                }
                if let Some(estimate) = estimate {
                    // Two solutions in binary64 differ by 1e-13 whatever the estimate.
                    let over = distance / (estimate + 1e-13);
                    let claim = out.check("algebraic error/estimate");
                    claim.at_most(over, 1.0, "stated error estimate");
                }
                algebraic = Some(distance);
            }
            out.row(cells! { n, solver => error, definition, algebraic, estimate,
            steps: v.work.iterations as usize, ms });
            if exact.is_none() {
                errors.push((1.0 / n as f64, error));
                exact = Some((error, v));
            }
        }
    }
    if let [.., coarse, fine] = errors[..] {
        // ln(e₁/e₂)/ln(h₁/h₂). As u is known, the errors e have no ± but that of their cubature,
        // which moves the order by 3e-4 at most and is not counted.
        let order = exponent_between(coarse, fine);
        let claim = out.check("order of |u − u^h|_a");
        claim.whole_error_bars_differ_by_at_most(order, 1.0, 0.1, "linear elements");
    }
    out.remark(
        "h/100 asks for a hundredth of the mesh's error, 1e-10 for ten digits: both solve all \
         coarser meshes first, most of the time up to n = 64; beyond, the looser one is faster.",
    );
    let name = format!("section_2_seconds_{}", options.cone);
    out.plot(&name, "True error against seconds", Axes::LogLog("milliseconds", "|u − v|_a"))
        .curve_by("solver", "ms", "error");
    Ok(())
}
