//! Section 2, Remark 1: a membrane under a table, the scalar Signorini problem.
//!
//! u on the square Ω = (0, 1)² is zero on the top edge Γ_D, free on both sides, and may not be positive on the bottom
//! edge Γ_C, with a(u, v) = ∫ ∇u·∇v, l(v) = ∫ f v, J(v) = ½ a(v, v) − l(v) and f = cos 2πx + 3/10:
//!
//! ```text
//! −Δu = f in Ω,     u ≤ 0,   ∂u/∂n ≤ 0,   u ∂u/∂n = 0   on Γ_C         (2.5) with u for u_N, ∂u/∂n for σ_N
//! u^h minimises J over   K^h = { v^h = 0 on Γ_D, v^h ≤ 0 at the nodes of Γ_C }              (2.9), nodal
//!                              { v^h = 0 on Γ_D, ∫ v^h ≤ 0 on every segment of Γ_C }        (4.1), midpoint
//! ```
//!
//! v^h is continuous and linear on the triangles of a grid of n × n squares, each cut from bottom left to top right. In
//! place of f stands its interpolant. (Remark 1 itself has −Δu + u = f and Γ_C = ∂Ω: example `remark_1_whole_boundary`.)
//!
//! Expected: contact at both ends of the edge, one gap between; the same J by solvers without a common line. Refuted if
//! a condition of (2.5), scaled, is violated by more than 1e-10, if forces do not balance, if two solvers differ in J by
//! more than eight digits or the loop in this file by more than four, or if the contact set has another shape.
//!
//! `cargo run --release --example section_2_scalar_contact -- --n 64,128 --out out`

use example_report::prelude::*;
use signorini::cone::Cone;
use signorini::contact::{ContactProblem, Solver};
use signorini::fem::Form;
use signorini::mesh::{Part, SideParts, Triangulation, unit_square};
use std::f64::consts::PI;

example! { quick "Remark 1", "scalar: u^h minimises J over K^h:  u ≤ 0,  ∂u/∂n ≤ 0,  u ∂u/∂n = 0 on Γ_C (2.5);  contact at both ends";
    /// squares along each side, coarsest mesh first
    n: Vec<usize> = "4,8,16,32" in "[4, 512]",
    /// discrete cones: nodal (2.9), midpoint (4.1)
    cone: Vec<Cone> = "nodal,midpoint",
}

const SIDES: SideParts =
    SideParts { bottom: Part::Contact, right: Part::Neumann, top: Part::Dirichlet, left: Part::Neumann };

fn load([x, _]: [f64; 2]) -> f64 {
    (2.0 * PI * x).cos() + 0.3
}

/// J of the nodal cone from its definition. On these triangles (K u)ᵢ = Σ w (uᵢ − uⱼ) over the neighbours j on the grid,
/// w = 1 inside and 1/2 along the boundary. Gauss-Seidel steps, over-relaxed by 1.9, put u > 0 on Γ_C back to 0, until a
/// sweep changes no value by more than 1e-11.
fn by_definition(mesh: &Triangulation, n: usize) -> f64 {
    let mut f = vec![0.0; mesh.nodes().len()]; // ∫ (interpolant of f) φᵢ: area (f₁ + f₂ + f₃ + fᵢ)/12 on each triangle
    for nodes in mesh.triangles() {
        let values = nodes.map(|node| load(mesh.nodes()[node]));
        for (&node, value) in nodes.iter().zip(values) {
            f[node] += 0.5 / (n * n) as f64 / 12.0 * (values.iter().sum::<f64>() + value);
        }
    }
    let mut u = vec![0.0; f.len()]; // node (i, j), 0 ≤ i, j ≤ n, has the number (n + 1) j + i; j = n is Γ_D
    let form = |u: &[f64], i: usize, j: usize| {
        let (at, across, along) =
            ((n + 1) * j + i, if j == 0 { 0.5 } else { 1.0 }, if i == 0 || i == n { 0.5 } else { 1.0 });
        let near = [
            (i > 0, at.wrapping_sub(1), across),
            (i < n, at + 1, across),
            (j > 0, at.wrapping_sub(n + 1), along),
            (j < n, at + n + 1, along),
        ];
        let near = near.into_iter().filter(|(exists, ..)| *exists);
        near.fold((0.0, 0.0), |(sum, diagonal), (_, other, w)| (sum + w * (u[at] - u[other]), diagonal + w))
    };
    let mut change = 1.0_f64;
    while change > 1e-11 {
        change = 0.0;
        for (i, j) in (0..n).flat_map(|j| (0..=n).map(move |i| (i, j))) {
            let (at, (product, diagonal)) = ((n + 1) * j + i, form(&u, i, j));
            let step = u[at] + 1.9 * (f[at] - product) / diagonal;
            let next = if j == 0 { step.min(0.0) } else { step };
            change = change.max((next - u[at]).abs());
            u[at] = next;
        }
    }
    let energy = |i: usize, j: usize| u[(n + 1) * j + i] * (0.5 * form(&u, i, j).0 - f[(n + 1) * j + i]);
    (0..n).flat_map(|j| (0..=n).map(move |i| (i, j))).map(|(i, j)| energy(i, j)).sum()
}

fn run(options: &Options, out: &mut Report) -> Result<()> {
    out.column("touching", "touching", "active constraints: nodes, or segments of the midpoint cone");
    out.column("force", "force", "−∫ ∂u/∂n");
    out.column("definition", "J, here", "J by the loop in this file");
    out.column("differ", "solvers", "relative difference of J between two solvers");
    let mut solved = Vec::new();
    for (&n, &cone) in options.n.iter().flat_map(|n| options.cone.iter().map(move |cone| (n, cone))) {
        let mesh = unit_square(n, SIDES)?;
        let nodal_load: Vec<f64> = mesh.nodes().iter().map(|&point| load(point)).collect();
        let problem = ContactProblem::new(mesh.clone(), Form::LAPLACE, &nodal_load)?;
        // Guess which constraints are active, solve K u + Bᵀλ = F with these as equations, correct the guess by the signs
        // of B u and λ, until it reproduces itself. Rows of B: u at a node, or its mean on a segment. Exact to rounding.
        let u = problem.solve(cone, Solver::ActiveSet)?;
        // Primal-dual path through the interior of the cone (Clarabel) on the same K, F, B: a duality gap of 1e-13.
        let other = problem.solve(cone, Solver::InteriorPoint)?;
        let definition = if cone == Cone::Nodal && n <= 64 { Some(by_definition(&mesh, n)) } else { None };
        // λᵢ = −∫ ∂u/∂n φᵢ (nodal) or −∫ ∂u/∂n over a segment (midpoint), and (B u)ᵢ, each over its largest size.
        let push = u.multiplier.iter().fold(f64::MIN_POSITIVE, |m, l| m.max(l.abs()));
        let scaled = || u.multiplier.iter().zip(&u.gap).map(|(l, g)| (l / push, g / u.displacement_scale));
        let worst = |of: fn((f64, f64)) -> f64| scaled().map(of).fold(0.0, f64::max);
        let differ = (other.energy / u.energy - 1.0).abs();
        out.row(
            cells! { cone: cone.to_string(), n => touching: u.contact_set.count(), force: u.contact_force,
            J: Measured::new(u.energy, u.energy_rounding), definition, differ },
        );
        out.check("not above the table: B u ≤ 0").at_most(worst(|(_, g)| g), 1e-10, "(2.5)");
        out.check("the table does not pull: λ ≥ 0").at_most(worst(|(l, _)| -l), 1e-10, "(2.5)");
        out.check("force only in contact: λ B u = 0").at_most(worst(|(l, g)| (l * g).abs()), 1e-10, "(2.5)");
        // Largest entry of K u − F + Bᵀλ over that of |K||u| + |F|; then loads, reactions of Γ_D, forces of the table.
        out.check("equations at free nodes").at_most(u.kkt.balance, 1e-10, "(2.1)");
        out.check("sum of all forces").at_most(u.balance, 1e-8, "eight digits");
        out.check("two solvers, change of J").at_most(differ, 1e-8, "eight digits");
        if let Some(j) = definition {
            out.check("J by the loop here, change").at_most((j / u.energy - 1.0).abs(), 1e-4, "four digits");
        }
        let (active, last) = (|i: usize| u.contact_set.contains(i), u.contact_set.constraints() - 1);
        let changes = (0..last).filter(|&i| active(i) != active(i + 1)).count();
        if n >= 8 {
            // coarser meshes do not see the gap
            let off = (changes as f64 - 2.0).abs();
            out.check("|ends of gaps − 2|, n ≥ 8").at_most(off, 0.0, "one gap, f < 0");
        }
        out.check("contact at both ends").holds(active(0) && active(last), "f > 0 there");
        solved.push((cone, n, problem, u));
    }
    for &cone in if out.draws() { options.cone.as_slice() } else { &[] } {
        let of_cone = || solved.iter().filter(move |(kind, ..)| *kind == cone);
        let name = |n| format!("section_2_membrane_body_{cone}_{n}");
        let named: Vec<_> = of_cone().map(|(_, n, problem, u)| (name(n), problem, u)).collect();
        out.bodies("Membrane", &named)?;
        if let Some((.., problem, u)) = of_cone().next_back() {
            out.contact_edge(format!("section_2_membrane_edge_{cone}"), "Membrane", problem, u);
        }
    }
    Ok(())
}
