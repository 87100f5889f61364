//! Theorem 3.1: the rate of convergence, whatever the contact set.
//!
//! Let u in H^τ solve Signorini's problem and u^h the discrete one (2.9): linear on triangles of size h, u^h ≤ 0 at the
//! nodes of the contact edge (the nodal cone). In the energy norm ‖·‖, which is equivalent to that of H¹,
//!
//! ```text
//! ‖u − u^h‖ ≤ C h^(τ² − 5τ/2 + 2)   for 3/2 < τ < 2   (3.1),      C h |ln h|^(1/2)   for τ = 2   (3.2).
//! ```
//!
//! The order found is τ − 1 (proved by Drouet and Hild in 2015): (τ − 3/2)(2 − τ) more, at most 1/16.
//!
//! Test problem: on the edge y = 0 of the unit square choose g ≤ 0 and a pressure λ ≥ 0 with g λ = 0; u is harmonic, g on
//! the edge, 0 on top, ∂u/∂n = 0 on the sides, and the edge carries the load for which λ is the pressure. So the contact
//! set is chosen and u is known. `transition`: contact for x < a, λ = (a − x)^(τ−2), and g = −δ^(τ−1) for d = x − a > 0,
//! δ = d (2 − 2a − d)/(2 − 2a): u in H^s for s < τ only. Errors are root mean squares over a = 5/12 and 11/24: halving h
//! exchanges their places in the cell, 1/3 and 2/3. In place of u stands its values on a grid 32 times finer than the last.
//! `fat-cantor`: contact on a Cantor set of measure 1/2, which repeats itself only where h falls by a factor 2^(1/(4 − 2τ)):
//! its orders are shown and decide nothing.
//!
//! Refuted if the error of `transition` over its printed bound keeps growing: where error/bound ~ h^(−δ) its increments from
//! mesh to mesh grow by 2^δ; here they are negative, or fall by 0.95 and more, so that their sum is bounded. Also refuted
//! if the library's error differs from that of `by_definition` by one part in a million. Loose if measured orders, less
//! what they may be off by (±), are above the printed exponent.
//!
//! `cargo run --release --example theorem_3_1_rates -- --problem transitions:3,corner --tau 1.75 --finest 13`

use example_report::prelude::*;
use nalgebra::{DMatrix, DVector};
use signorini::cone::Cone;
use signorini::contact::{Accuracy, ContactProblem, Settings, Solver};
use signorini::fem::Form;
use signorini::mesh::Hierarchy;
use signorini::problems::{NamedProblem, Parameters, StripData, TestProblem, TransitionPowers};
use signorini::rates::{Bound, ConvergenceOrder, order_between};
use signorini::strip::{EdgeData, LateralCondition, Reference, StripKind, StripProblem};
use std::f64::consts::PI;

example! { seconds "Theorem 3.1", "nodal cone, u in H^τ:  ‖u − u^h‖ ≤ C h^(τ² − 5τ/2 + 2),  τ = 2: C h |ln h|^(1/2)";
    /// regularities τ of the solution
    tau: Vec<f64> = "1.55,1.65,1.75,1.85,1.95,2" in "(1.5, 2]" slider "1.55 to 1.95",
    /// contact sets on the edge of the square, or bodies
    problem: Vec<NamedProblem> = "transition,fat-cantor",
    /// meshes of 8, 16, .. 2^finest cells along the edge; of bodies 2, 4, .. 2^(finest - 6)
    finest: u32 = "12" in "[9, 17]" slider "9 to 13",
}

/// ‖u − u^h‖ with matrices, u^h on n × n squares (cut into triangles), u on N × N. A function on the edge is a sum of
/// waves c_k = cos kπx at the nodes; the discrete harmonic function above c_k, zero on top, has ‖·‖² = S_k Σ c_k² (end
/// nodes by half), S_k = sinh η coth nη, cosh η = 2 − cos(kπ/n): the five-point stencil, row by row. So ‖·‖² = v·A_n v.
fn by_definition(data: &EdgeData, n: usize, cone: Cone) -> Result<f64> {
    let energy = |n: usize| {
        let half = |i: usize| if i == 0 || i == n { 0.5 } else { 1.0 };
        let angle = |k: usize| k as f64 * PI / n as f64;
        let waves = DMatrix::from_fn(n + 1, n + 1, |k, i| half(i) * (angle(k) * i as f64).cos());
        let symbol = DVector::from_fn(n + 1, |k, _| match (2.0 - angle(k).cos()).acosh() {
            0.0 => 1.0 / (n * n) as f64,
            eta => 2.0 * half(k) / n as f64 * eta.sinh() / (n as f64 * eta).tanh(),
        });
        waves.tr_mul(&(DMatrix::from_diagonal(&symbol) * &waves))
    };
    let (coarse, ratio) = (energy(n), n as f64 / data.cells() as f64);
    let g = DVector::from_column_slice(data.values());
    let force = energy(data.cells()) * &g; // A_N g
    let inside =
        DMatrix::from_fn(g.len(), n + 1, |j, i| (1.0 - (j as f64 * ratio - i as f64).abs()).max(0.0));
    let load = inside.tr_mul(&(&force + DVector::from_column_slice(data.forces()))); // of A_N g + λ on n cells
    let bound = match cone {
        Cone::Nodal => DMatrix::identity(n + 1, n + 1), // values at the nodes ≤ 0
        Cone::Midpoint => DMatrix::from_fn(n, n + 1, |s, i| if i == s || i == s + 1 { 0.5 } else { 0.0 }), // means ≤ 0
    };
    let mut pressed = DVector::from_element(bound.nrows(), 1.0);
    for _ in 0..100 {
        // Minimise ½ v·A_n v − load·v, with a spring of stiffness 1e9 at every condition that was violated last.
        let springs = bound.tr_mul(&(DMatrix::from_diagonal(&pressed) * &bound)) * 1e9;
        let v =
            (&coarse + springs).lu().solve(&load).ok_or_else(|| Error::option("tau", "a singular system"))?;
        let next = (&bound * &v).map(|value| f64::from(u8::from(value > 0.0)));
        if next == pressed {
            return Ok((g.dot(&force) - 2.0 * force.dot(&(inside * &v)) + v.dot(&(coarse * &v))).sqrt());
        }
        pressed = next;
    }
    Err(Error::option("tau", "the active set does not settle"))
}

/// Solve, halve h, fit: for either theorem.
pub fn rates(cone: Cone, options: &Options, out: &mut Report) -> Result<()> {
    out.column("e_32", "h = 1/32", "error, a = 5/12, for u on 256 × 256 squares");
    out.column("definition", "definition", "the same by `by_definition`");
    out.column("finest", "finest", "error on the finest mesh, for u on one 32 times finer");
    out.column("printed", "printed", "order of the printed bound, τ = 2: on the last two meshes");
    let pairs = || options.problem.iter().flat_map(|p| options.tau.iter().map(move |&tau| (p, tau)));
    if !pairs().any(|(problem, tau)| admits(problem, tau, options)) {
        return Err(Error::option("tau", "at most 1.75 for fat-cantor"));
    }
    for (problem, tau) in pairs() {
        let (full, mut compared) = (problem.to_string(), [None; 2]);
        let short = full.split(':').next().unwrap_or(&full);
        let name = if short.parse().as_ref() == Ok(problem) { short } else { &full }; // parameters that are not the default
        if let NamedProblem::Strip(strip) = problem
            && admits(problem, tau, options)
        {
            let data = &edges(strip, tau, 256)?[..1];
            for (n, (_, library)) in [8, 16, 32].into_iter().zip(on_square(data, cone, &[8, 16, 32])?) {
                let definition = by_definition(&data[0], n, cone)?;
                let check = out.check("by_definition over the library, h = 1/8, 1/16, 1/32");
                check.near(definition / library, 1.0, 1e-6, "stiffness of the springs");
                compared = [library, definition].map(Some);
            }
        }
        let Some((tau, points, reference)) = errors(problem, tau, cone, options)? else { continue };
        // p of e ≈ A h^p beside slower or smooth terms; ±: all p that explain the errors as well lie within it.
        let mut order = Measured::from(ConvergenceOrder::against(&points, reference));
        if reference.is_none() {
            // Half of the change by taking e² − e²(finest u) for e².
            let fine = ConvergenceOrder::against(&points, Some(0.5f64.powi(options.finest as i32 + 5)));
            order.error = order.error.max(0.5 * (order - Measured::from(fine)).value.abs());
        }
        let bound = Bound::Paper.through(points[0], points.iter().map(|point| point.0), tau)?;
        let over: Vec<f64> = points.iter().zip(&bound).map(|(error, bound)| error.1 / bound.1).collect();
        let ([.., bound_before, bound_last], [.., before, middle, last]) = (&bound[..], &over[..]) else {
            continue;
        };
        let (printed, [e_32, definition]) = (order_between(*bound_before, *bound_last), compared);
        let finest = points[points.len() - 1].1;
        out.row(
            cells! { problem: name, tau => e_32, definition, finest, order, printed, optimal: tau - 1.0 },
        );
        if tau < 2.0 {
            let observed = out.observe(format!("order − (τ − 1), {name}"));
            observed.near(order - (tau - 1.0), 0.0, 0.1, "Drouet, Hild 2015");
        }
        if name == "transition" {
            // Below 0 where error/bound falls; below 1 its increments fall and it is bounded; above 1 it grows like h^(−δ).
            let which = if tau < 2.0 { "3/2 < τ < 2".to_owned() } else { format!("τ = {tau}") };
            let check = out.check(format!("{which}: increment of error/bound over the one before"));
            check.at_most((last - middle) / (middle - before).abs(), 0.95, "bounded; |ln h|^(1/2): 0.96");
        }
        if name == "transition" && (tau - 1.5) * (2.0 - tau) > 0.05 {
            let stronger = out.stronger("order − printed exponent, where τ − 1 is 0.05 above it");
            stronger.at_least(order - printed, 0.0, "(3.1), (4.2)");
        }
        let theorem = if cone == Cone::Nodal { "theorem_3_1" } else { "theorem_4_1" };
        let drawn = if name == "transition" { "errors" } else { name };
        let title = format!("{name}, {cone} cone, τ = {tau}");
        let optimal = Bound::Optimal.through(points[0], points.iter().map(|point| point.0), tau)?;
        out.plot(&format!("{theorem}_{drawn}_{tau}"), &title, Axes::LogLog("h", "‖u − u^h‖"))
            .line("error", points)
            .dashed_line("the theorem", bound)
            .dashed_line("h^(τ−1)", optimal);
    }
    if options.tau.contains(&2.0) {
        out.remark(
            "τ = 2: on these meshes the logarithm lowers the order of the bound itself, see its column",
        );
    }
    Ok(())
}

fn run(options: &Options, out: &mut Report) -> Result<()> {
    rates(Cone::Nodal, options, out)
}

/// Whether the problem has this τ: the boundary of the fat Cantor set has dimension 4 − 2τ, which near τ = 2 only meshes
/// that are far finer show; a body has one τ of its own.
fn admits(problem: &NamedProblem, tau: f64, options: &Options) -> bool {
    match problem {
        NamedProblem::Strip(StripData::FatCantor { .. }) => tau <= 1.75,
        NamedProblem::Strip(_) | NamedProblem::Mesh(TestProblem::Corner) => true,
        NamedProblem::Mesh(_) => tau == options.tau[0],
    }
}

/// τ, the points (h, ‖u − u^h‖), and the mesh size of what stands for u where it is a discrete solution.
type Study = (f64, Vec<(f64, f64)>, Option<f64>);

fn errors(problem: &NamedProblem, tau: f64, cone: Cone, options: &Options) -> Result<Option<Study>> {
    let (cells, levels): (Vec<usize>, _) =
        ((3..=options.finest).map(|k| 1 << k).collect(), options.finest as usize - 6);
    Ok(match problem {
        _ if !admits(problem, tau, options) => None,
        NamedProblem::Strip(strip) => {
            Some((tau, on_square(&edges(strip, tau, 32 << options.finest)?, cone, &cells)?, None))
        }
        NamedProblem::Mesh(body) => {
            let own = match body {
                TestProblem::Corner => tau,
                _ => body.regularity(&Parameters::default())?.tau, // from the exponents of its corners
            };
            Some((own, on_triangles(*body, tau, cone, levels)?, Some(0.5 / (1 << levels) as f64)))
        }
    })
}

/// g at the nodes of an edge of so many cells, and λ as forces: its integral over a cell, half to either end; what is left
/// beside a goes to the last node in contact. Of `transition` for both a.
fn edges(strip: &StripData, tau: f64, cells: usize) -> signorini::Result<Vec<EdgeData>> {
    let transition = |a: f64| TransitionPowers::of_regularity(tau).data(a, cells);
    match strip.moves() {
        true => [5.0 / 12.0, 11.0 / 24.0].into_iter().map(transition).collect(),
        false => Ok(vec![strip.data(tau, cells, LateralCondition::Natural)?]),
    }
}

/// (h, ‖u − u^h‖) as in `by_definition`, by fast transforms in place of matrices, and by conjugate gradients on the active
/// set to 1e-13; ‖u − u^h‖² is a sum of positive terms over k.
fn on_square(data: &[EdgeData], cone: Cone, cells: &[usize]) -> Result<Vec<(f64, f64)>> {
    let mut squares = vec![0.0; cells.len()];
    for data in data {
        let problem = StripProblem::new(StripKind::Scalar, data, Reference::Nested, cells[0])?;
        let mut coarser = None;
        for (&n, square) in cells.iter().zip(&mut squares) {
            let u = problem.operator(n)?.0.solve_contact(&problem.load(n)?, cone, coarser.as_ref(), 1e-13)?;
            *square += problem.error(n, &u.values)?.value.powi(2);
            coarser = Some(u);
        }
    }
    let mean = |square: f64| (square / data.len() as f64).sqrt();
    Ok(cells.iter().zip(squares).map(|(&n, square)| (1.0 / n as f64, mean(square))).collect())
}

/// (h, ‖u − u^h‖/‖u‖) of a body by multigrid to 1e-10, with u^h on the mesh after the last in place of u. The corner has
/// the angle 90°/(τ − 1), at which u ~ r^(τ−1), and the load −1: no contact.
fn on_triangles(body: TestProblem, tau: f64, cone: Cone, levels: usize) -> Result<Vec<(f64, f64)>> {
    let setting = Parameters { angle: 90.0 / (tau - 1.0), ..Parameters::default() };
    let hierarchy = Hierarchy::refined(body.mesh_with(2, &setting)?, levels)?;
    let solve = |level: usize, cone: Cone| -> signorini::Result<_> {
        let mesh = hierarchy.levels()[level].clone();
        let load = vec![-1.0; mesh.nodes().len()];
        let problem = match body {
            TestProblem::Corner => ContactProblem::new(mesh, Form::LAPLACE, &load)?,
            _ => body.on_with(mesh, &setting)?,
        };
        let (accuracy, below) = (Accuracy::Relative(Tolerance::new(1e-10)?), hierarchy.up_to(level));
        let how =
            Settings { solver: Solver::Multigrid, accuracy, hierarchy: Some(&below), ..Settings::default() };
        let u = problem.solve(cone, how)?.displacement;
        Ok((problem, u))
    };
    let (finest, u) = solve(levels, Cone::Nodal)?;
    let norm = finest.energy_norm(&u)?;
    let error = |k: usize| finest.nested_energy_error(&hierarchy, (k, &solve(k, cone)?.1), (levels, &u));
    (0..levels).map(|k| Ok((0.5 / (1 << k) as f64, error(k)? / norm))).collect()
}
