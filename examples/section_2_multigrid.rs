//! Section 2: every test problem, and what is hard, by multigrid and by elimination.
//!
//! Both solve the discrete problem (2.9) or (4.1): min J(v) = ½ a(v, v) − l(v) over the cone, linear elements on a grid of
//! n × n squares. Elimination: one sparse factorisation down to the contact edge, then an active set, exact to rounding.
//! Multigrid: from the solution on every other line of the grid, contact set included; conjugate gradients with one V-cycle
//! (symmetric Gauss-Seidel) on the contact set in hand, which the signs of forces and gaps correct. It stops where its own
//! estimate of the algebraic error |u^h − v|_a/|u^h|_a, by the residual and one more cycle, is below the tolerance.
//!
//! Hard cases: the block for λ/μ from 0 to 1000 (a sweep over nodes hardly moves a field without divergence), and the block
//! pressed flat, triangles with legs h and h/aspect (a sweep over nodes is slow along the short side). Where λ/μ > 100, or
//! where there is no coarser mesh, or the tolerance is not reached, elimination takes over and the column says so.
//!
//! Expected: the same solution twice. Refuted if J differs by more than 1e-11 (the square of the tolerance, and rounding),
//! if a contact set differs where contact is not weak, if a true algebraic error is above its estimate, or if elimination does
//! not take over for λ/μ > 100.
//!
//! `cargo run --release --example section_2_multigrid -- --n 512 --cone midpoint`

use example_report::prelude::*;
use signorini::cone::Cone;
use signorini::contact::{Accuracy, ContactProblem, Fallback, Settings, Solver};
use signorini::fem::{Field, Form, Lame};
use signorini::mesh::{SideParts, mapped_grid};
use signorini::problems::TestProblem;
use std::f64::consts::PI;

example! { seconds "Section 2, multigrid", "multigrid and elimination: one J, one contact set, |u^h − v|_a below its estimate, or elimination takes over";
    /// squares along each side
    n: usize = "64" in "[8, 1024]",
    /// discrete cone: nodal (2.9) or midpoint (4.1)
    cone: Cone = "nodal",
    /// algebraic error asked of multigrid, relative, energy norm; 1e-10 at most in the hard cases
    tolerance: Tolerance = "1e-12",
}

/// The block, f = (0, −cos πx), with λ = ratio and μ = 1, of height 1/aspect.
fn block(n: usize, ratio: f64, aspect: f64) -> Result<ContactProblem> {
    let mesh = mapped_grid(n, n, SideParts::HANGING, |[x, y]| [x, y / aspect])?;
    let load = Field::Vector(&|[x, _]| [0.0, -(PI * x).cos()]).sample(mesh.nodes())?;
    Ok(ContactProblem::new(mesh, Form::elastic(Lame::new(ratio, 1.0)?), &load)?)
}

fn run(options: &Options, out: &mut Report) -> Result<()> {
    out.column("change", "ΔJ/J", "relative difference of J");
    out.column("algebraic", "algebraic", "|u^h − v|_a/|u^h|_a, u^h by elimination");
    out.column("estimate", "estimate", "what multigrid states for it; – where elimination took over");
    out.column("gradients", "gradients", "gradient steps on the finest mesh");
    out.column("factor", "factor", "of the error in one cycle alone");
    out.column("sets", "sets", "contact sets tried, at most on one mesh");
    let n = options.n;
    let mut cases: Vec<(String, ContactProblem, bool)> = Vec::new();
    for problem in TestProblem::all() {
        cases.push((problem.to_string(), problem.problem(n)?, false));
    }
    for ratio in [0.0, 1.0, 10.0, 100.0, 1000.0] {
        cases.push((format!("λ/μ = {ratio}"), block(n, ratio, 1.0)?, true));
    }
    for aspect in [4.0, 20.0, 100.0] {
        cases.push((format!("aspect {aspect}"), block(n, 1.0, aspect)?, true));
    }
    for (name, problem, is_hard) in cases {
        // On a closed contact edge multigrid leaves means to elimination.
        let cone = if problem.edge().is_closed() { Cone::Nodal } else { options.cone };
        let tolerance =
            if is_hard { options.tolerance.relative().max(1e-10) } else { options.tolerance.relative() };
        let accuracy = Accuracy::Relative(Tolerance::new(tolerance)?);
        let v =
            problem.solve(cone, Settings { solver: Solver::Multigrid, accuracy, ..Settings::default() })?;
        let u = problem.solve(cone, Solver::ActiveSet)?;
        let report = v.multigrid.as_ref().filter(|report| report.fallback.is_none());
        let share = |part: f64, whole: f64| if part == 0.0 { 0.0 } else { (part / whole).abs() };
        let change = share(v.energy - u.energy, u.energy);
        let apart: Vec<f64> = v.displacement.iter().zip(&u.displacement).map(|(a, b)| a - b).collect();
        let algebraic = share(problem.energy_norm(&apart)?, problem.energy_norm(&u.displacement)?);
        let estimate = report.and_then(|report| report.error).map(|error| error.relative_error());
        let finest = report.and_then(|report| report.levels.last());
        let sets = report
            .map(|report| report.levels.iter().map(|l| l.steps).fold(report.coarsest_steps, usize::max));
        out.row(
            cells! { problem: name.clone() => touching: u.contact_set.count(), change, algebraic, estimate,
            gradients: finest.map(|l| l.gradient_steps), factor: finest.map(|l| l.factor), sets },
        );
        out.check("relative difference of J").at_most(change, 1e-11, "tolerance², rounding");
        if !u.margins.is_weak(1e-9) {
            let other = v.contact_set.distance(&u.contact_set);
            out.check("constraints active for one only").at_most(other, 0.0, "the same sets");
        }
        let ended = v.status.is_converged() && u.status.is_converged();
        out.check("both end with a solution").holds(ended, "no step limit");
        match estimate {
            // Two solutions in binary64 differ by 1e-13 whatever the estimate.
            Some(estimate) => out.check("algebraic error over its estimate").at_most(
                algebraic / (estimate + 1e-13),
                1.0,
                "stated",
            ),
            None if name == "λ/μ = 1000" => {
                let why = v.multigrid.as_ref().and_then(|report| report.fallback);
                out.check("λ/μ = 1000: elimination takes over")
                    .holds(why == Some(Fallback::NearlyIncompressible), "λ/μ > 100");
            }
            None => {}
        }
        if let (Some(sets), Cone::Nodal) = (sets, cone) {
            out.observe("nodal cone: contact sets tried on a mesh").at_most(
                sets,
                3.0,
                "three linear systems",
            );
        }
    }
    out.plot(
        "section_2_multigrid",
        "Gradient steps over the contraction of one cycle",
        Axes::Linear("factor of one cycle", "gradient steps"),
    )
    .points("factor", "gradients");
    Ok(())
}
