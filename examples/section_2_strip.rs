//! Theorem 3.1 on a strip: the contact problem on a square is one on its contact edge.
//!
//! On a uniform grid of the unit square the nodes of the inside can be eliminated without an error.
//! A function on the edge y = 0 is a sum of waves cos kπx at its n + 1 nodes. With u = 0 on top,
//! free sides, the five-point stencil and n × n squares, the discrete harmonic function above the
//! wave c = cos kπx has the energy
//!
//! ```text
//! S_k Σ c(x_i)², end nodes by half,   S_k = sinh η coth nη,  cosh η = 2 − cos(kπ/n),  S_0 = 1/n,
//! ```
//!
//! with η from sinh(η/2) = sin(kπ/2n): from cosh η half of the digits would be lost. So the contact
//! problem is to minimise, over the g with g ≤ 0 at the nodes of the edge (midpoint cone: with
//! means ≤ 0 over the cells),
//!
//! ```text
//! J(g) = ½ g·A g − b·g,     A: times S_k in every wave (cosine transforms);  b: forces at nodes.
//! ```
//!
//! This file solves it on finer and finer meshes, compares the coarse solutions with those of the
//! square itself (`by_definition`), and computes the error for a chosen u: values g ≤ 0 and a
//! pressure λ ≥ 0, g λ = 0, on N = 32 · 2^finest cells, half of the integral of λ over a cell in
//! contact at each of its nodes. u^h has the load A_N g + λ, tested with its own hat functions.
//! With its values g_h and the interpolation P from n to N cells the error is
//!
//! ```text
//! ‖u − u^h‖² = g·A_N g − 2 (A_N g)·P g_h + g_h·A_n g_h.
//! ```
//!
//! The contact sets:
//!
//! ```text
//! transition   contact for x < a = 0.381966, g = −(x − a)^(τ−1) up to x = 1, λ = r^(τ−2),
//!              r the distance to the last node before a
//! fat-cantor   for k = 1, .. 15 a gap L s^k is taken out of the middle of each of the 2^(k−1)
//!              pieces that remain, s = 2^(−1/(4 − 2τ)), with L so that all of these gaps are 1/2
//!              long together; ends are rounded to nodes, as long as a gap has an inner node and
//!              the pieces a cell;
//!              g = −(x − a)(b − x)/(b − a) in a gap (a, b), λ = 1 in contact
//! ```
//!
//! Refuted if for n ≤ 32 (scalar problem, nodal cone) a solution and that of the square differ by
//! more than 1e-7 of the largest |g| (Gauss-Seidel stops at a change of 1e-13 a sweep, which leaves
//! about 1e-12); if a condition of contact, or an equation of the edge problem, scaled, is violated
//! by more than 1e-10; if a linear problem takes more than 30 iterations of conjugate gradients,
//! whatever n and the contact set; or if the order of `transition` plus its ± is below the exponent
//! p = τ² − 5τ/2 + 2 of (3.1). (At τ = 2 p is the slope of h |ln h|^(1/2), (3.2), between the first
//! and the last mesh.) It is undecided if the ± is 0.1 or more, since then an order of p − 0.1
//! would pass as well. The order is ln(e_1/e_m)/ln(h_1/h_m) over the meshes 1, .. m, and its ± is
//! the difference of the same quotient over 1, .. k and over k, .. m, k = 1 + m/2 rounded down
//! (default: n = 8, .. 512 and 512, .. 16384), because the transition has another place in its cell
//! on every mesh. Cantor sets repeat themselves after a factor s in h, too few times here: their
//! order is shown and decides nothing.
//!
//! ```text
//! cargo run --release --example section_2_strip -- \
//!     --problem cantor:0.3,transitions:11 --tau 1.6 --finest 16
//! ```

use example_report::prelude::*;
use signorini::cone::Cone;
use signorini::problems::StripData;
use signorini::rates::Bound;
use signorini::strip::{Reference, StripKind, StripProblem};

example! { quick "Theorem 3.1 on a strip",
    "the square is eliminated exactly: J(g) = ½ gᵀA g − bᵀg on its edge;  \
    ‖u − u^h‖ ≤ C h^(τ² − 5τ/2 + 2)";
    /// contact sets on the edge
    problem: Vec<StripData> = "transition,fat-cantor",
    /// regularity τ of the solution
    tau: f64 = "1.75" in "(1.5, 2]" slider "1.55 to 1.9",
    /// meshes of 8, 16, .. 2^finest cells along the edge
    finest: u32 = "14" in "[7, 17]" slider "7 to 14",
    /// discrete cone: nodal (2.9) or midpoint (4.1)
    cone: Cone = "nodal",
    /// scalar, or elastic with periodic sides
    kind: StripKind = "scalar",
}

/// u on the edge from the square itself: (n + 1) n unknowns, (K u)ᵢ = Σ w (uᵢ − uⱼ) over the
/// neighbours j on the grid, w = 1 inside and 1/2 along the boundary; forces b on the edge.
/// Gauss-Seidel steps, over-relaxed by 1.9, put u > 0 on the edge back to 0, until a sweep changes
/// no value by more than 1e-13 of the largest.
fn by_definition(n: usize, b: &[f64]) -> Vec<f64> {
    // node (i, j) has the number (n + 1) j + i; j = n is held
    let mut u = vec![0.0_f64; (n + 1) * (n + 1)];
    let (mut change, mut size) = (1.0_f64, 1.0_f64);
    while change > 1e-13 * size {
        (change, size) = (0.0, 0.0);
        for (j, i) in (0..n).flat_map(|j| (0..=n).map(move |i| (j, i))) {
            let (at, side) = ((n + 1) * j + i, |on: bool| if on { 0.5 } else { 1.0 });
            let (mut sum, mut diagonal) = (if j == 0 { b[i] } else { 0.0 }, 0.0);
            let mut add = |exists: bool, other: usize, w: f64| {
                if exists {
                    (sum, diagonal) = (sum + w * u[other], diagonal + w);
                }
            };
            add(i > 0, at.wrapping_sub(1), side(j == 0));
            add(i < n, at + 1, side(j == 0));
            add(j > 0, at.wrapping_sub(n + 1), side(i == 0 || i == n));
            add(true, at + n + 1, side(i == 0 || i == n));
            let step = u[at] + 1.9 * (sum / diagonal - u[at]);
            let next = if j == 0 { step.min(0.0) } else { step };
            (change, size) = (change.max((next - u[at]).abs()), size.max(next.abs()));
            u[at] = next;
        }
    }
    u.truncate(n + 1);
    u
}

fn run(options: &Options, out: &mut Report) -> Result<()> {
    let Options { tau, finest, cone, kind, .. } = *options;
    out.column("unknowns", "unknowns", "of the two-dimensional problem");
    out.column("error", "‖u − u^h‖", "energy norm, its square a finite sum over the waves");
    out.column("intervals", "intervals", "runs of consecutive nodes in contact");
    out.column("steps", "steps", "linear problems");
    out.column("inner", "inner", "most inner iterations in a step");
    for strip in &options.problem {
        let name = strip.name();
        let data = strip.data(tau, 32 << finest, kind.sides())?;
        let problem = StripProblem::new(kind, &data, Reference::Nested, 8)?;
        let mut errors: Vec<(f64, Measured)> = Vec::new();
        // Primal-dual active set on the edge, from the contact set of the mesh before (first:
        // none); each linear problem by conjugate gradients to 1e-13, preconditioned by the inverse
        // of |d²/dx²|^(1/2) on each gap (sine transforms). kkt: equations, signs, g λ, over the
        // largest terms.
        for u in &problem.solutions(cone, 8, 1 << finest)? {
            let n = u.cells;
            // b: A g + λ of the fine edge, tested with the hat functions of this one
            let load = problem.load(n)?;
            let error = problem.error(u)?; // the formula of the header, wave by wave: rounding only
            let unknowns = if kind == StripKind::Scalar { (n + 1) * n } else { 2 * n * n };
            let inner = u.inner_iterations.iter().copied().max().unwrap_or(0);
            if kind == StripKind::Scalar && cone == Cone::Nodal && n <= 32 {
                let size = u.values.iter().fold(f64::MIN_POSITIVE, |m, g| m.max(g.abs()));
                let square = by_definition(n, &load);
                let apart = square.iter().zip(&u.values).map(|(a, g)| (a - g).abs());
                let apart = apart.fold(0.0, f64::max) / size;
                let claim = out.check("u, edge and square: relative difference");
                claim.at_most(apart, 1e-7, "Gauss-Seidel on the square");
            }
            out.check("largest scaled KKT residual").at_most(u.kkt.worst(), 1e-10, "(2.5)");
            out.check("max inner CG iterations per step").at_most(inner, 30.0, "uniform in n");
            out.row(cells! { problem: name, n => unknowns, error: error.value,
            intervals: u.contact.runs().len(), steps: u.steps(), inner });
            errors.push((1.0 / n as f64, Measured::from(error)));
        }
        let order = exponent_of(&errors);
        let meshes = || errors.iter().map(|&(h, _)| h);
        let Some(tau) = data.regularity() else { continue }; // samples of a file have none
        let (h, error) = errors[0];
        let first = (h, error.value);
        let bound = Bound::Paper.through(first, meshes(), tau)?;
        let printed = exponent_of(&bound).value; // at τ = 2 the logarithm counts
        out.note(format!("order.{name}"), order);
        out.note(format!("order.{name}.error"), order.error);
        let (claim, above) =
            (format!("{name}: order + error − p"), order.value + order.error - printed);
        match name {
            // Undecided where an order 0.1 below would pass as well.
            "transition" => out.check(claim).undecided_if_also_true_of(order.error - 0.1).at_least(
                above,
                0.0,
                "p = τ² − 5τ/2 + 2, (3.1)",
            ),
            _ => out.observe(claim).at_least(above, 0.0, "p = τ² − 5τ/2 + 2, (3.1)"),
        }
        let axes = Axes::LogLog("h", "‖u − u^h‖");
        out.plot(
            &format!("section_2_strip_{name}"),
            &format!("{name}, {cone} cone, τ = {tau}"),
            axes,
        )
        .line("error", errors.iter().map(|&(h, e)| (h, e.value)).collect())
        .dashed_line("Theorem 3.1", bound)
        .dashed_line("h^(τ − 1)", Bound::Optimal.through(first, meshes(), tau)?);
    }
    Ok(())
}
