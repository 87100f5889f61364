//! Section 2: speed for accuracy of contact solvers: the error belongs to the mesh, whatever solves the discrete problem.
//!
//! On the unit square, with z = x + iy, let u = −Re (z − 2/5)^(3/2): harmonic, 0 on the bottom edge for x < 2/5 (contact) and
//! −(x − 2/5)^(3/2) beyond (gap), with ∂u/∂n ≤ 0 in contact and 0 in the gap. So u solves the scalar Signorini problem
//! with contact on the bottom edge, its own values prescribed on top, its own ∂u/∂n on both sides. u is in H^s for s < 5/2.
//!
//! ```text
//! |u − v|_a  ≤  |u − u^h|_a + |u^h − v|_a,      |v|_a² = a(v, v),      |u − u^h|_a ≤ C h for linear elements
//! ```
//!
//! u^h is the discrete solution (2.9) on n × n squares, cut into triangles: it minimises J(v) = ½ a(v, v) − l(v) over the cone;
//! v is what a solver returns. The first term belongs to the mesh, the second to the algebra. Multigrid stops where its
//! estimate of |u^h − v|_a/|u^h|_a, by the residual and one more cycle, is below the tolerance: 1e-10, or a hundredth of the
//! first term. It is compared with elimination on every test problem too, and where it is slow: the block, f = (0, −cos πx), for
//! λ/μ from 0 to 1000, and pressed flat. For λ/μ > 100, or out of steps, elimination takes over, and no estimate is stated.
//!
//! Refuted if the order of |u − u^h|_a is off 1 by more than 0.1, if a solver to ten digits changes |u − v|_a by more than 1e-6 of
//! it or one to a hundredth by more than 1e-3, if J differs from that of elimination by 1e-11, or a contact set where contact
//! is not weak, if a true algebraic error is above its estimate, or if the error from the definition is off by 0.3 %.
//!
//! `cargo run --release --example section_2_speed_for_accuracy -- --n 16,64,256,1024 --cone midpoint`

// `at_most(x, b)` holds if x + its ± ≤ b, `near(x, b, t)` if |x − b| + its ± ≤ t, `holds(yes)` if yes; otherwise it
// fails, or is undecided within ±. Of several calls the worst counts.
use example_report::prelude::*;
use signorini::cone::Cone;
use signorini::contact::{Accuracy, ContactProblem, ContactSolution, Settings, Solver};
use signorini::fem::{Field, Form, Lame, gradients};
use signorini::mesh::{SideParts, mapped_grid};
use signorini::problems::{KnownSolution, TestProblem};
use signorini::rates::ConvergenceOrder;
use std::f64::consts::PI;
use std::time::Instant;

example! { seconds "Section 2, speed for accuracy", "|u − u^h|_a ≤ C h, whatever solves the discrete problem";
    /// squares along each side, coarsest mesh first
    n: Vec<usize> = "8,16,32,64,128,256" in "[4, 2048]",
    /// squares along each side for the other problems
    side: usize = "64" in "[8, 1024]",
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

/// All problems: the one with known solution on every mesh, and the others without.
fn problems(options: &Options, known: &KnownSolution) -> Result<Vec<(String, usize, ContactProblem)>> {
    let n = options.side;
    let mut all = Vec::new();
    for &n in &options.n {
        all.push(("known".to_owned(), n, known.problem(n)?));
    }
    for problem in TestProblem::all() {
        all.push((problem.to_string(), n, problem.problem(n)?));
    }
    let hard = [0.0, 1.0, 10.0, 100.0, 1000.0].map(|ratio| (format!("λ/μ = {ratio}"), ratio, 1.0));
    for (name, ratio, aspect) in hard.into_iter().chain([4.0, 20.0].map(|a| (format!("aspect {a}"), 1.0, a)))
    {
        let mesh = mapped_grid(n, n, SideParts::HANGING, |[x, y]| [x, y / aspect])?;
        let load = Field::Vector(&|[x, _]| [0.0, -(PI * x).cos()]).sample(mesh.nodes())?;
        all.push((name, n, ContactProblem::new(mesh, Form::elastic(Lame::new(ratio, 1.0)?), &load)?));
    }
    Ok(all)
}

fn run(options: &Options, out: &mut Report) -> Result<()> {
    out.column("error", "error", "|u − v|_a");
    out.column("definition", "definition", "the same by `by_definition`");
    out.column("algebraic", "algebraic", "|u^h − v|_a/|u^h|_a, u^h by the active set");
    out.column("estimate", "estimate", "what multigrid states");
    out.column("steps", "steps", "linear systems, barrier steps, or cycles");
    out.column("ms", "ms", "milliseconds; known: with mesh and assembly");
    let known = KnownSolution::three_halves();
    let multigrid = |accuracy| Settings { solver: Solver::Multigrid, accuracy, ..Settings::default() };
    let solvers = |is_known: bool, n: usize| {
        let all: [(&str, bool, Settings<'_>); 4] = [
            // Interior eliminated by a sparse factorisation, then guesses of the contact set on the edge: exact to rounding.
            ("active set", true, Solver::ActiveSet.into()),
            // Nested iteration; gradients with a V-cycle on the contact set in hand; stops by an estimate of |u^h − v|_a.
            ("multigrid, 1e-10", true, multigrid(Accuracy::Relative(Tolerance::new(1e-10)?))),
            ("multigrid, h/100", is_known, multigrid(Accuracy::OfDiscretisation(0.01))),
            // Primal-dual path (Clarabel) on all unknowns.
            ("interior point", is_known && n <= 64, Solver::InteriorPoint.into()),
        ];
        Ok::<_, Error>(all.into_iter().filter(|(_, runs, _)| *runs))
    };
    let mut errors = Vec::new();
    for (name, n, problem) in problems(options, &known)? {
        let is_known = name == "known";
        // On a closed contact edge multigrid leaves means to elimination.
        let cone = if problem.edge().is_closed() { Cone::Nodal } else { options.cone };
        let mut exact: Option<(f64, ContactSolution)> = None; // |u − u^h|_a and u^h
        for (solver, _, settings) in solvers(is_known, n)? {
            let start = Instant::now();
            let fresh = if is_known { Some(known.problem(n)?) } else { None }; // no solver finds another's factors
            let problem = fresh.as_ref().unwrap_or(&problem);
            let v = problem.solve(cone, settings)?;
            let ms = (1e5 * start.elapsed().as_secs_f64()).ceil() / 100.0;
            // Cubature of |∇u − ∇v|² on each triangle, refined towards the transition.
            let error = if is_known { known.error_norms(problem, &v.displacement)?.h1 } else { f64::NAN };
            let definition = if is_known { Some(by_definition(problem, &v.displacement)?) } else { None };
            let estimate = v.multigrid.as_ref().filter(|report| report.fallback.is_none());
            let estimate = estimate.and_then(|report| report.error).map(|e| e.relative_error());
            let mut algebraic = None;
            if let Some((of_mesh, u)) = &exact {
                let share = |part: f64, whole: f64| if part == 0.0 { 0.0 } else { (part / whole).abs() };
                let apart: Vec<f64> =
                    u.displacement.iter().zip(&v.displacement).map(|(a, b)| a - b).collect();
                let distance = share(problem.energy_norm(&apart)?, problem.energy_norm(&u.displacement)?);
                algebraic = Some(distance);
                let (change, of_j) = ((error / of_mesh - 1.0).abs(), share(v.energy - u.energy, u.energy));
                if solver.ends_with("h/100") {
                    out.check("multigrid: change of the error").at_most(change, 1e-3, "0.1 % of the error");
                } else {
                    if is_known {
                        out.check("solvers to 1e-10: change of error").at_most(change, 1e-6, "six digits");
                    }
                    out.check("two solvers: |ΔJ|/|J|").at_most(of_j, 1e-11, "rounding error");
                    if !u.margins.is_weak(1e-9) {
                        let other = v.contact_set.distance(&u.contact_set);
                        out.check("constraints active for one solver").at_most(other, 0.0, "uniqueness");
                    }
                }
                if let Some(estimate) = estimate {
                    // Two solutions in binary64 differ by 1e-13 whatever the estimate.
                    let over = distance / (estimate + 1e-13);
                    out.check("algebraic error/estimate").at_most(over, 1.0, "stated error estimate");
                }
            }
            if name == "λ/μ = 1000" && solver.starts_with("multigrid") {
                out.check("λ/μ = 1000: runs without fallback").holds(estimate.is_none(), "λ/μ > 100");
            }
            if let Some(definition) = definition {
                let over = definition / error;
                out.check("|u − v|_a: by_definition/library").near(over, 1.0, 3e-3, "edge midpoint rule");
            }
            if !solver.ends_with("h/100") {
                out.check("largest scaled KKT residual").at_most(v.kkt.worst(), 1e-8, "(2.5)");
            }
            let shown = is_known.then_some(error);
            out.row(
                cells! { problem: name.clone(), n, solver => error: shown, definition, algebraic, estimate,
                steps: v.work.iterations as usize, ms },
            );
            if exact.is_none() {
                errors.extend(shown.map(|error| (1.0 / n as f64, error)));
                exact = Some((error, v));
            }
        }
    }
    if let Some(order) = ConvergenceOrder::of(&errors) {
        out.check("order of |u − u^h|_a").near(order, 1.0, 0.1, "linear elements");
    }
    let name = format!("section_2_seconds_{}", options.cone);
    out.plot(&name, "True error against seconds", Axes::LogLog("milliseconds", "|u − v|_a"))
        .curve_by("solver", "ms", "error");
    Ok(())
}
