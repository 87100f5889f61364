//! Section 2: a block on a floor and a membrane under a table, (2.1)-(2.9) and (4.1).
//!
//! `block` is an elastic square Ω = (0, 1)², clamped on its top edge Γ_D and free on both sides.
//! With its bottom edge Γ_C it lies on a rigid floor without friction; the load f = (0, −cos πx)
//! presses its left half down and lifts its right half. Let
//!
//! ```text
//! σ(u) = 2μ ε(u) + λ tr ε(u) I,        a(u, v) = ∫ σ(u) : ε(v),
//! l(v) = ∫ f·v,                        J(v) = ½ a(v, v) − l(v),
//! u_N = u·n,   σ_N = n·σ(u)n,   n = (0, −1) the outward normal of Γ_C.
//! ```
//!
//! `membrane` is the scalar problem of Remark 1 on the same square: a(u, v) = ∫ ∇u·∇v, f = cos
//! 2πx + 3/10, u for u_N, ∂u/∂n for σ_N. The paper's discrete problem is: u^h minimises J over
//!
//! ```text
//! K^h = { v^h = 0 on Γ_D, v_N ≤ 0 at the nodes of Γ_C }              (2.9), nodal cone,
//!       { v^h = 0 on Γ_D, ∫ v_N ≤ 0 on every segment of Γ_C }        (4.1), midpoint cone,
//! ```
//!
//! and it has one solution, because a is elliptic (Korn) and the cone is convex and closed. It is
//! known by
//!
//! ```text
//! u_N ≤ 0,   σ_N ≤ 0,   u_N σ_N = 0   on Γ_C, in the sense of the cone.                  (2.5)
//! ```
//!
//! This file computes it: v^h is continuous and linear on the triangles of a grid of n × n squares,
//! each cut from bottom left to top right; in place of f stands its interpolant. With the stiffness
//! matrix K, the load F and the rows of B that give u_N at a node or its mean over a segment, the
//! forces p of the floor satisfy K u + Bᵀp = F at the free nodes (those not on Γ_D), B u ≤ 0,
//! p ≥ 0, p·B u = 0.
//!
//! Refuted if one of these conditions, scaled, is violated by more than 1e-10; if forces do not
//! balance; if two solvers of these equations, or for the nodal cone a loop in this file with its
//! own K and F, differ in J by more than 1e-8, widened by ten times what rounding of K and F leaves
//! in J (for λ ≫ μ); or if J of the midpoint cone, which contains K^h, is higher.
//!
//! `cargo run --release --example section_2_elastic_contact -- --n 64 --poisson 0.3 --out out`

use example_report::prelude::*;
use signorini::cone::Cone;
use signorini::contact::{ContactProblem, ContactSolution, Solver};
use signorini::fem::{Form, Lame};
use signorini::mesh::{Part, SideParts, Triangulation, unit_square};
use std::collections::BTreeMap;
use std::f64::consts::PI;

example! { quick "Section 2, (2.9)",
    "u^h minimises J over K^h:  u_N ≤ 0,  σ_N ≤ 0,  u_N σ_N = 0 on Γ_C (2.5);  K^h by nodes, \
    (4.1) by means";
    /// squares along each side, coarsest mesh first
    n: Vec<usize> = "4,8,16,32" in "[2, 512]",
    /// discrete cones: nodal (2.9), midpoint (4.1)
    cone: Vec<Cone> = "nodal,midpoint",
    /// Poisson's ratio λ/(2(λ + μ)); μ = 1
    poisson: f64 = "0.25" in "(-1, 0.5)" slider "-0.5 to 0.49",
}

const SIDES: SideParts = SideParts {
    bottom: Part::Contact,
    right: Part::Neumann,
    top: Part::Dirichlet,
    left: Part::Neumann,
};

/// f at a place: two components for the block, one for the membrane.
fn load(body: &str, [x, _]: [f64; 2]) -> Vec<f64> {
    if body == "block" { vec![0.0, -(PI * x).cos()] } else { vec![(2.0 * PI * x).cos() + 0.3] }
}

/// J of the nodal cone from its definition: stiffness and load by the formulas of linear triangles,
/// then Gauss-Seidel steps, over-relaxed by 1.9, each of which minimises J in one unknown and puts
/// u_N > 0 on Γ_C back to 0. It ends when a sweep changes no unknown by more than 1e-11; nothing
/// where 20 000 sweeps do not suffice (λ ≫ μ).
fn by_definition(body: &str, mesh: &Triangulation, lambda: f64, mu: f64) -> Option<f64> {
    let (top, bottom) = (mesh.nodes_on(Part::Dirichlet), mesh.nodes_on(Part::Contact));
    let parts = load(body, [0.0; 2]).len(); // unknown parts·node + c is component c
    let unknowns = parts * mesh.nodes().len();
    let (mut k, mut f) = (vec![BTreeMap::<usize, f64>::new(); unknowns], vec![0.0; unknowns]);
    for nodes in mesh.triangles() {
        let [p, q, r] = nodes.map(|node| mesh.nodes()[node]);
        let area = 0.5 * ((q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]));
        // ∇φ of a node: the opposite side turned by a right angle, over twice the area.
        let grad = [(q, r), (r, p), (p, q)]
            .map(|(a, b)| [(a[1] - b[1]) / (2.0 * area), (b[0] - a[0]) / (2.0 * area)]);
        for (i, c) in (0..3).flat_map(|i| (0..parts).map(move |c| (i, c))) {
            let loads = nodes.map(|node| load(body, mesh.nodes()[node])[c]);
            // ∫ (interpolant of f) φᵢ
            f[parts * nodes[i] + c] += area / 12.0 * (loads.iter().sum::<f64>() + loads[i]);
            for (j, d) in (0..3).flat_map(|j| (0..parts).map(move |d| (j, d))) {
                // σ(φⱼ e_d) : ε(φᵢ e_c) = λ ∂_c φᵢ ∂_d φⱼ + μ (∂_d φᵢ ∂_c φⱼ + δ_cd ∇φᵢ·∇φⱼ);
                // membrane: ∇φᵢ·∇φⱼ
                let product = grad[i][0] * grad[j][0] + grad[i][1] * grad[j][1];
                let both = if c == d { product } else { 0.0 };
                let elastic =
                    lambda * grad[i][c] * grad[j][d] + mu * (grad[i][d] * grad[j][c] + both);
                let entry = area * if parts == 2 { elastic } else { product };
                *k[parts * nodes[i] + c].entry(parts * nodes[j] + d).or_default() += entry;
            }
        }
    }
    let diagonal: Vec<f64> = (0..unknowns).map(|i| k[i][&i]).collect();
    let k: Vec<Vec<(usize, f64)>> = k.into_iter().map(|row| row.into_iter().collect()).collect();
    // ANCHOR: gauss_seidel
    // (K u)ᵢ
    let row = |i: usize, u: &[f64]| k[i].iter().map(|&(j, entry)| entry * u[j]).sum::<f64>();
    let mut u = vec![0.0; unknowns];
    for _ in 0..20_000 {
        let mut change = 0.0_f64;
        for i in (0..unknowns).filter(|i| !top[i / parts]) {
            let step = u[i] + 1.9 * (f[i] - row(i, &u)) / diagonal[i];
            let next = match (bottom[i / parts], i % parts) {
                (true, 0) if parts == 1 => step.min(0.0), // u ≤ 0
                (true, 1) => step.max(0.0),               // u_N = −u_y ≤ 0
                _ => step,
            };
            change = change.max((next - u[i]).abs());
            u[i] = next;
        }
        if change < 1e-11 {
            return Some((0..unknowns).map(|i| u[i] * (0.5 * row(i, &u) - f[i])).sum());
        }
    }
    // ANCHOR_END: gauss_seidel
    None
}

/// Numbers in intervals: "0–3, 7".
fn in_intervals(numbers: impl Iterator<Item = usize>) -> String {
    let mut intervals: Vec<[usize; 2]> = Vec::new();
    for i in numbers {
        match intervals.last_mut() {
            Some([_, last]) if *last + 1 == i => *last = i,
            _ => intervals.push([i, i]),
        }
    }
    let words = |[a, b]: &[usize; 2]| if a == b { a.to_string() } else { format!("{a}–{b}") };
    intervals.iter().map(words).collect::<Vec<_>>().join(", ")
}

/// The steps of the active set method: on a set B u = 0 holds and the floor may pull, off it the
/// body may sink in. The nodes with (B u)ᵢ > 0 enter the set and those with pᵢ < 0 leave it; a set
/// with neither is that of the solution.
fn show_steps(out: &mut Report, n: usize, u: &ContactSolution) {
    let mut before = vec![false; u.contact_set.constraints()];
    let mut words =
        format!("steps of the active set, block, nodal, n = {n}; nodes from the left, from 0:");
    let mut rows: Vec<Vec<(f64, f64)>> = Vec::new();
    for (k, step) in u.steps.iter().enumerate() {
        let now = step.set.as_slice();
        let enters = in_intervals((0..now.len()).filter(|&i| now[i] && !before[i]));
        let leaves = in_intervals((0..now.len()).filter(|&i| !now[i] && before[i]));
        // (B u)₊ over the largest |u|, (−p)₊ over the largest entry of |K||u| + |F|, as in the
        // checks.
        let residual =
            (step.penetration / u.displacement_scale()).max(step.tension / u.force_scale());
        let enter = if enters.is_empty() { String::new() } else { format!(", {enters} enter") };
        let leave = if leaves.is_empty() { String::new() } else { format!(", {leaves} leave") };
        words += &format!(
            "\n{}: {} nodes{enter}{leave}; J = {:.6}, residual {residual:.1e}",
            k + 1,
            step.set.count(),
            step.energy
        );
        let points = (0..now.len()).filter(|&i| now[i]).map(|i| (i as f64 / n as f64, -(k as f64)));
        rows.push(points.collect());
        before = now.to_vec();
    }
    let names: Vec<String> = (0..rows.len()).map(|k| format!("step {}", k + 1)).collect();
    let axes = Axes::Linear("x", "");
    let plot = out.plot("section_2_active_sets", "Nodes in contact, step by step", axes);
    plot.ranges((0.0, 1.0), (0.0, 1.0)).named_rows(names);
    plot.given_points("in contact", rows.concat());
    out.remark(words);
}

/// A discrete solution.
pub struct Solved {
    /// `block` or `membrane`.
    pub body: &'static str,
    /// The cone.
    pub cone: Cone,
    /// Squares along each side.
    pub n: usize,
    /// The discrete problem.
    pub problem: ContactProblem,
    /// Its solution.
    pub u: ContactSolution,
    /// |ΔJ|/|J| of two solvers.
    pub two_solvers: f64,
}

/// Solves one problem, and reports its row and its checks.
fn solve(
    body: &'static str,
    cone: Cone,
    n: usize,
    options: &Options,
    out: &mut Report,
) -> Result<Solved> {
    let (lambda, mu) = (2.0 * options.poisson / (1.0 - 2.0 * options.poisson), 1.0);
    let form = if body == "block" { Form::elastic(Lame::new(lambda, mu)?) } else { Form::LAPLACE };
    let mesh = unit_square(n, SIDES)?;
    let nodal_load: Vec<f64> = mesh.nodes().iter().flat_map(|&point| load(body, point)).collect();
    let problem = ContactProblem::new(mesh.clone(), form, &nodal_load)?;
    // Guess which constraints are active, solve K u + Bᵀp = F with these as equations, correct the
    // guess by the signs of B u and p, until it reproduces itself. Exact to rounding.
    let u = problem.solve(cone, Solver::ActiveSet)?;
    // Primal-dual path through the interior of the cone (Clarabel) on the same K, F, B: a duality
    // gap of 1e-13.
    let other = problem.solve(cone, Solver::InteriorPoint)?;
    let has_loop = cone == Cone::Nodal && n <= 64;
    let definition = if has_loop { by_definition(body, &mesh, lambda, mu) } else { None };
    out.row(cells! { body, cone: cone.to_string(), n => touching: u.contact_set.count(),
    force: u.contact_force, J: Measured::new(u.energy, u.energy_rounding), definition });

    // B u over the largest |u|, p over the largest p (−∫ σ_N φᵢ, or −∫ σ_N over a segment); the
    // largest entry of K u − F + Bᵀp at a free node over that of |K||u| + |F|.
    out.check("penetration: max (B u)₊, scaled").at_most(u.kkt.gap, 1e-10, "(2.5)");
    out.check("tensile contact force: max (−p)₊, scaled").at_most(u.kkt.sign, 1e-10, "(2.5)");
    let claim = out.check("complementarity: max |p B u|, scaled");
    claim.at_most(u.kkt.complementarity, 1e-10, "(2.5)");
    let claim = out.check("equilibrium residual at free nodes, scaled");
    claim.at_most(u.kkt.balance, 1e-10, "(2.1)");
    // ε (Σᵢ uᵢ² (|K||u| + |F|)ᵢ²)^(1/2)/|J|, ε = 2^-52: what rounding of K and F leaves in J; much
    // for λ ≫ μ.
    let allowed = 1e-8 + 10.0 * u.energy_rounding / u.energy.abs();
    const COARSE: f64 = 1e-3; // where such a difference would pass too, nothing is decided
    // Loads, reactions of Γ_D and forces of the floor in both directions, over the size of the
    // terms.
    let claim = out.check("resultant of all forces, scaled").undecided_if_also_true_of(COARSE);
    claim.at_most(u.balance, allowed, "global equilibrium");
    let apart = |j: f64| (j / u.energy - 1.0).abs();
    let two_solvers = apart(other.energy);
    let claim = out.check("two solvers: |ΔJ|/|J|").undecided_if_also_true_of(COARSE);
    claim.at_most(two_solvers, allowed, "eight digits");
    if let Some(j) = definition {
        let claim = out.check("J: |by_definition/library − 1|").undecided_if_also_true_of(COARSE);
        claim.at_most(apart(j), allowed, "eight digits");
    }
    Ok(Solved { body, cone, n, problem, u, two_solvers })
}

pub(crate) fn run(options: &Options, out: &mut Report) -> Result<Vec<Solved>> {
    out.column("touching", "touching", "active constraints: nodes, or segments (midpoint cone)");
    out.column("force", "force", "−∫ σ_N");
    out.column("definition", "J, here", "J by the loop in this file");
    let mut solved: Vec<Solved> = Vec::new();
    for body in ["block", "membrane"] {
        for &n in &options.n {
            for &cone in &options.cone {
                let new = solve(body, cone, n, options, out)?;
                let is_nodal = |s: &&Solved| s.body == body && s.cone == Cone::Nodal && s.n == n;
                if cone == Cone::Midpoint
                    && let Some(nodal) = solved.iter().find(is_nodal)
                {
                    let higher = (new.u.energy - nodal.u.energy) / nodal.u.energy.abs();
                    let claim = out.check("(J_midpoint − J_nodal)/|J_nodal|");
                    claim.at_most(higher, 1e-12, "(4.1) contains K^h");
                }
                solved.push(new);
            }
        }
    }
    let finest = |run: &&Solved| run.body == "block" && run.cone == Cone::Nodal;
    if let Some(run) = solved.iter().rfind(finest) {
        show_steps(out, run.n, &run.u);
    }
    if out.draws() {
        draw(&solved, options, out)?;
    }
    Ok(solved)
}

/// The deformed bodies, and the contact edge of the finest mesh.
fn draw(solved: &[Solved], options: &Options, out: &mut Report) -> Result<()> {
    for (body, title) in [("block", "Block"), ("membrane", "Membrane")] {
        for &cone in &options.cone {
            let those = solved.iter().filter(|s| s.body == body && s.cone == cone);
            let name = |n: usize| format!("section_2_{body}_body_{cone}_{n}");
            let named: Vec<_> = those.map(|s| (name(s.n), &s.problem, &s.u)).collect();
            out.bodies(title, &named)?;
            if let Some((_, problem, u)) = named.last() {
                out.contact_edge(&format!("section_2_{body}_edge_{cone}"), title, problem, u);
            }
        }
    }
    Ok(())
}
