//! Theorems 3.1 and 4.1 on other problems: Cantor contact sets, corners, the elastic block.
//!
//! ‖u − u^h‖ ≤ C h^(τ² − 5τ/2 + 2) for u in H^τ, 3/2 < τ < 2, in the energy norm, u^h linear on triangles of size h with
//! values ≤ 0 at the nodes of the contact edge (nodal cone), or means ≤ 0 over its segments (midpoint cone).
//!
//! Contact sets, on the edge y = 0 of the unit square: g ≤ 0, λ ≥ 0, g λ = 0; u harmonic, g on the edge, 0 at y = 1, ∂u/∂n
//! = 0 at the sides, u_N = u, σ_N = −λ. `fat-cantor`: a gap L s^k in the middle of each of the 2^(k−1) pieces that remain,
//! k = 1, .. 15, s = 2^(−1/d), d = 4 − 2τ the dimension of the boundary, all gaps 1/2 long, ends rounded to the N =
//! 32·2^finest cells, as long as a gap has an inner node and the pieces a cell; in a gap (a, b) g = −(x − a)(b − x)/(b −
//! a), else λ = 1: half of 1/N from each cell in contact to its nodes. The set repeats itself where h falls by a factor
//! 2^(1/d). Bodies: `corner`, the angle 90°/(τ − 1) between a Dirichlet side and the contact edge, u ~ r^(τ−1), load −1, no
//! contact; `block`, plane strain, fixed on top. They are solved by multigrid to 1e-10; for u stands the solution on a mesh
//! of half the size.
//!
//! Squared error on the edge, n = 8, .. 2^finest, h = 1/n: v·A_n v is the energy of the discrete harmonic function on n × n
//! squares cut into triangles, edge values v; A_n = Σ S_k w_k w_kᵀ, w_k = (cos kπi/n)ᵢ, end nodes by half, S_k = (2/n) sinh
//! η coth nη, S_0 = 1/n², S_n by half, cosh η = 2 − cos(kπ/n). With P from n to N cells u^h has the edge values v that
//! minimise ½ v·A_n v − (A_N g + λ)·P v in the cone, e² = g·A_N g − 2 (A_N g)·P v + v·A_n v.
//!
//! Order: e² ≈ A h^(2p) + Σ c_j h^(q_j), q_j = 2, 3, 2p + 1, .., c_j normal with mean 0 and 0.3 to 1.5 of A h^(2p−q_j) on
//! the coarsest mesh, and a relative scatter from 1e-7 to 1: the mean of p over its likelihood; within ± of it lie 96 %.
//! Expected: τ − 1; periods of the set and smooth parts of u disturb it. Refuted if the order with its ± is below the
//! printed exponent.
// x.at_least(b): x ≥ b; near(x, b, t): |x − b| plus its error ≤ t. Of several calls the worst counts. observe: decides nothing.
use example_report::prelude::*;
use signorini::cone::Cone;
use signorini::contact::{Accuracy, ContactProblem, Settings, Solver};
use signorini::fem::Form;
use signorini::mesh::Hierarchy;
use signorini::problems::{NamedProblem, Parameters, StripData, TestProblem};
use signorini::rates::ConvergenceOrder;
use signorini::strip::{LateralCondition, Reference, StripKind, StripProblem};

example! { seconds "Theorems 3.1, 4.1", "other contact sets and bodies, u in H^τ:  ‖u − u^h‖ ≤ C h^(τ² − 5τ/2 + 2)";
    /// regularities τ of the solution
    tau: Vec<f64> = "1.55,1.65,1.75" in "(1.5, 2)" slider "1.55 to 1.95",
    /// contact sets on the edge of the square, or bodies
    problem: Vec<NamedProblem> = "fat-cantor",
    /// cone of the discrete problem
    cone: Cone = "nodal",
    /// meshes of 8, 16, .. 2^finest cells along the edge; of bodies 2, 4, .. 2^(finest - 6)
    finest: u32 = "12" in "[9, 17]" slider "9 to 13",
}

fn run(options: &Options, out: &mut Report) -> Result<()> {
    out.column("finest", "finest", "error on the finest mesh; of bodies over ‖u‖");
    for problem in &options.problem {
        for &asked in &options.tau {
            let Some((tau, points, reference)) = errors(problem, asked, options)? else { continue };
            let order = Measured::from(ConvergenceOrder::against(&points, reference));
            let (printed, optimal) = (tau * tau - 2.5 * tau + 2.0, tau - 1.0);
            let (full, finest) = (problem.to_string(), points[points.len() - 1].1);
            let name = full.split(':').next().unwrap_or(&full);
            out.row(cells! { problem: name, tau => finest, order, printed, optimal });
            let above = order.value + order.error - printed;
            out.check("order + ± − printed exponent").at_least(above, 0.0, "(3.1), (4.2)");
            out.observe(format!("order − (τ − 1), {name}")).near(order - optimal, 0.0, 0.1, "Drouet, Hild");
            let title = format!("{name}, {} cone, τ = {tau}", options.cone);
            let axes = Axes::LogLog("h", "‖u − u^h‖");
            let plot = out.plot(&format!("theorem_3_1_{name}_{tau}"), &title, axes);
            plot.power("the theorem", &points, printed)
                .power("h^(τ−1)", &points, optimal)
                .line("error", points);
        }
    }
    Ok(())
}

/// τ, the points (h, ‖u − u^h‖), and the mesh size of what stands for u where it is a discrete solution.
type Study = (f64, Vec<(f64, f64)>, Option<f64>);

fn errors(problem: &NamedProblem, tau: f64, options: &Options) -> Result<Option<Study>> {
    let levels = options.finest as usize - 6;
    let reference = Some(0.5 / (1 << levels) as f64);
    Ok(match problem {
        NamedProblem::Strip(strip) => Some((tau, on_square(strip, tau, options)?, None)),
        NamedProblem::Mesh(TestProblem::Corner) => {
            Some((tau, on_triangles(TestProblem::Corner, tau, options.cone, levels)?, reference))
        }
        // A body has one τ, from the exponents of its corners.
        NamedProblem::Mesh(_) if tau != options.tau[0] => None,
        NamedProblem::Mesh(body) => {
            let own = body.regularity(&Parameters::default())?.tau;
            Some((own, on_triangles(*body, tau, options.cone, levels)?, reference))
        }
    })
}

/// (h, ‖u − u^h‖) on an edge, by fast transforms in place of matrices, an active set and conjugate gradients to 1e-13.
fn on_square(strip: &StripData, tau: f64, options: &Options) -> Result<Vec<(f64, f64)>> {
    let data = strip.data(tau, 32 << options.finest, LateralCondition::Natural)?;
    let problem = StripProblem::new(StripKind::Scalar, &data, Reference::Nested, 8)?;
    let mut points = Vec::new();
    for n in (3..=options.finest).map(|k| 1usize << k) {
        let u = problem.operator(n)?.0.solve_contact(&problem.load(n)?, options.cone, None, 1e-13)?;
        points.push((1.0 / n as f64, problem.error(n, &u.values)?.value));
    }
    Ok(points)
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
