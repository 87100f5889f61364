//! Falk's lemma, term by term, for both cones: the first line of the proofs of Theorems 3.1 and 4.1.
//!
//! u solves Signorini's problem, u^h the discrete one: P1 elements on squares of size h cut into triangles, u^h ≤ 0 at the
//! nodes of the contact edge (nodal cone) or in the mean over each segment (midpoint cone); ∫ is over the contact edge,
//! σ_N ≤ 0 the stress there, I^h u has the values of u at the nodes of the edge and least energy inside (at most that of the
//! interpolant, so that C ≤ 2 asks more), π is the mean over each segment. With ‖·‖ the energy norm
//!
//! ```text
//! ‖u − u^h‖² ≤ C (‖u − I^h u‖² + ∫ σ_N (I^h u − u))                     nodal cone, Section 3
//! ‖u − u^h‖² ≤ C (‖u − I^h u‖² + ∫ σ_N (I^h u − u) − ∫ σ_N u^h)         midpoint cone (4.5): inf ∫ σ_N (v − u^h) is at v = 0
//! − ∫ σ_N u^h ≤ − ∫ (σ_N − π σ_N)(u^h − u) − ∫ (σ_N − π σ_N) u          (4.8)
//! ```
//!
//! u^h minimises ‖u − v‖² + 2 ∫ σ_N (v − u) over the v of the cone; Young's inequality gives C = 2. Refuted if the minimum,
//! ‖u − u^h‖² − 2 ∫ −σ_N u^h, is above the value at I^h u, which decides C ≤ 2 as well; or if (4.8) fails: its right less its left
//! side is −∫ πσ_N u^h, so that it asks the sign of the means of u^h.
//!
//! Test problem: as in Theorem 3.1, u is harmonic on the unit square, 0 on top, ∂u/∂n = 0 on the sides, with the values
//! g ≤ 0 and the pressure λ = −σ_N ≥ 0, g λ = 0, chosen on the edge. `transition`: contact for x < a = 5/12 and 11/24, the
//! terms are means over both a, C is mean over mean; λ = (a − x)^(τ−2), g = −δ^(τ−1), δ = d (2 − 2a − d)/(2 − 2a), d = x − a > 0.
//! The fine edge has N = 64·2^finest cells. u is the discrete harmonic function on N × N squares with the values g; the forces
//! λ_j at its nodes are ∫ λ over a cell, half to each node (the cell of a: all to its left node); the load on the edge is
//! ∂u/∂n of that function plus λ, so that it is the solution. Other sets: see the page of the strip.
//!
//! `cargo run --release --example falk_terms -- --problem fat-cantor --tau 1.6`

// `at_most(x, b)` holds if x + its ± ≤ b, `at_least(x, b)` if x − its ± ≥ b, `near(x, b, t)` if |x − b| + its ± ≤ t;
// otherwise it fails, or is undecided within ±. Of several calls the worst counts. `observe` decides nothing.
use example_report::prelude::*;
use signorini::cone::Cone;
use signorini::problems::{StripData, TransitionPowers};
use signorini::proof::printed_exponent;
use signorini::strip::{EdgeData, EdgeSolution, LateralCondition, Reference, StripKind, StripProblem};
use std::f64::consts::PI;

example! { quick "Falk's lemma, (4.5), (4.8)", "‖u−u^h‖² ≤ C (‖u−I^h u‖² + ∫σ(I^h u−u)); midpoint cone: −∫σu^h added";
    /// prescribed contact set on the edge
    problem: StripData = "transition",
    /// regularity τ of the solution
    tau: f64 = "1.75" in "(1.5, 2]" slider "1.55 to 2",
    /// meshes of 8, 16, .. 2^finest cells along the edge
    finest: u32 = "10" in "[5, 14]",
}

/// ‖u − v‖², u discrete harmonic with values g on N cells, v with values on n. In waves c_k = Σ v_i cos kπi/n (end nodes
/// by half), k = 0, .., n, the energy is ‖v‖² = Σ S_k c_k², S_k = (2/n) sinh η coth nη (k = 0, n by half), cosh η = 2 − cos(kπ/n).
fn by_definition(g: &[f64], v: &[f64]) -> f64 {
    let form = |v: &[f64], w: &[f64]| -> f64 {
        let n = v.len() - 1;
        let half = |i: usize| if i == 0 || i == n { 0.5 } else { 1.0 };
        let wave = |v: &[f64], k: usize| -> f64 {
            v.iter()
                .enumerate()
                .map(|(i, v)| half(i) * v * ((k * i % (2 * n)) as f64 * PI / n as f64).cos())
                .sum()
        };
        let symbol = |k: usize| match (2.0 - (k as f64 * PI / n as f64).cos()).acosh() {
            0.0 => 1.0 / (n * n) as f64,
            eta => 2.0 * half(k) / n as f64 * eta.sinh() / (n as f64 * eta).tanh(),
        };
        (0..=n).map(|k| symbol(k) * wave(v, k) * wave(w, k)).sum()
    };
    let on_fine: Vec<f64> = (0..g.len()).map(|j| linear(v, j, (g.len() - 1) / (v.len() - 1))).collect();
    form(g, g) - 2.0 * form(g, &on_fine) + form(v, v)
}

/// The piecewise linear function with these nodal values at the fine node j, with so many fine cells to a cell.
fn linear(v: &[f64], j: usize, cells: usize) -> f64 {
    let (i, s) = (j / cells, (j % cells) as f64 / cells as f64);
    if s == 0.0 { v[i] } else { v[i] + s * (v[i + 1] - v[i]) }
}

/// ‖u − u^h‖², ‖u − I^h u‖², ∫ σ_N (I^h u − u), − ∫ σ_N u^h and the two parts of (4.8), on n cells; −σ_N is a force λ_j at
/// every node of the fine edge.
pub fn terms(edge: &EdgeData, problem: &StripProblem, u: &EdgeSolution) -> Result<[f64; 6]> {
    let (g, force, n, cells) = (edge.values(), edge.forces(), u.cells, edge.cells() / u.cells);
    let nodal: Vec<f64> = g.iter().copied().step_by(cells).collect(); // I^h u
    let work = |v: &[f64]| force.iter().enumerate().map(|(j, f)| f * linear(v, j, cells)).sum::<f64>();
    // Σ of the force on a segment times the means of u^h and of u; a force at a common node belongs to both by half.
    let mut means = [0.0, 0.0];
    for s in 0..n {
        let (a, b) = (s * cells, (s + 1) * cells);
        let share = |j: usize| if j == a && s > 0 || j == b && s + 1 < n { 0.5 } else { 1.0 };
        let on_segment = (a..=b).map(|j| share(j) * force[j]).sum::<f64>();
        means[0] += on_segment * 0.5 * (u.values[s] + u.values[s + 1]);
        means[1] += on_segment * (a..b).map(|j| 0.5 * (g[j] + g[j + 1])).sum::<f64>() / cells as f64;
    }
    // ‖u − v‖² as in `by_definition`, by fast transforms.
    let square = |v: &[f64]| -> Result<f64> { Ok(problem.distance(n, v)?.value.powi(2)) };
    let second = work(&u.values);
    Ok([square(&u.values)?, square(&nodal)?, -work(&nodal), second, second - means[0] + means[1], -means[1]])
}

fn run(options: &Options, out: &mut Report) -> Result<()> {
    let &Options { ref problem, tau, finest } = options;
    let edges = |cells: usize| -> signorini::Result<Vec<EdgeData>> {
        let transition = |a: f64| TransitionPowers::of_regularity(tau).data(a, cells);
        if problem.moves() {
            return [5.0 / 12.0, 11.0 / 24.0].into_iter().map(transition).collect();
        }
        Ok(vec![problem.data(tau, cells, LateralCondition::Natural)?])
    };
    for (name, title, meaning) in [
        ("error", "‖u−u^h‖²", ""),
        ("interpolation", "‖u−I^h u‖²", ""),
        ("consistency", "∫σ(I^h u−u)", ""),
        ("second", "−∫σu^h", ""),
        ("part_one", "part 1", "−∫ (σ − πσ)(u^h − u) of (4.8)"),
        ("part_two", "part 2", "−∫ (σ − πσ) u"),
        ("constant", "C", "the first column over the bracket"),
    ] {
        out.column(name, title, meaning);
    }
    let (fine, coarse) = (edges(64 << finest)?, edges(512)?);
    for cone in [Cone::Nodal, Cone::Midpoint] {
        for edge in &coarse {
            let exact = StripProblem::new(StripKind::Scalar, edge, Reference::Nested, 8)?;
            let u = exact.solve(8, cone)?;
            let quotient = by_definition(edge.values(), &u.values) / exact.error(&u)?.value.powi(2);
            out.check("‖u−u^h‖², n = 8: by_definition/library").near(quotient, 1.0, 1e-9, "`by_definition`");
        }
        let exact = fine.iter().map(|edge| StripProblem::new(StripKind::Scalar, edge, Reference::Nested, 8));
        let exact = exact.collect::<signorini::Result<Vec<StripProblem>>>()?;
        for n in (3..=finest).map(|level| 1 << level) {
            let mut mean = [0.0; 6];
            for (edge, exact) in fine.iter().zip(&exact) {
                // u^h: the active set is iterated, with conjugate gradients for the values at the edge, to 1e-13 of the load.
                let found = terms(edge, exact, &exact.solve(n, cone)?)?;
                mean.iter_mut().zip(found).for_each(|(sum, term)| *sum += term / fine.len() as f64);
            }
            let [error, interpolation, consistency, second, part_one, part_two] = mean;
            let bracket = interpolation + consistency + if cone == Cone::Midpoint { second } else { 0.0 };
            let constant = error / bracket;
            out.row(
                cells! { cone: cone.to_string(), n => error, interpolation, consistency, second, part_one,
                part_two, constant },
            );
            // Squares are sums over waves of differences squared: rounding 1e-16 of each wave, 1e-9 of the sum at most.
            let rounded = |value: f64| Measured::new(value, 1e-9 * value.abs());
            out.check(format!("C, {cone} cone")).at_most(rounded(constant), 2.0, "Young's inequality");
            let ratio = rounded((error - 2.0 * second) / (interpolation + 2.0 * consistency));
            out.check("‖u−v‖²+2∫σ(v−u): value at u^h/at I^h u").at_most(ratio, 1.0, "u^h minimises it");
            let excess = (second - part_one - part_two) / (error + interpolation);
            out.check("(4.8): left − right side, relative").at_most(excess, 1e-9, "πσ ≤ 0, πu^h ≤ 0");
            let sign = second / (error + interpolation); // over squares, as the excess
            match cone {
                Cone::Nodal => out.check("nodal cone: −∫σu^h, relative").at_most(sign, 1e-9, "u^h ≤ 0"),
                Cone::Midpoint => out.observe("−∫σu^h, midpoint cone").at_most(sign, 1e-9, "either sign"),
            }
        }
    }
    let order = -out.exponent("n", "consistency"); // between the last two meshes
    out.observe("order of ∫σ(I^h u−u) in h").at_least(order, printed_exponent(tau), "2τ² − 5τ + 4");
    let (error, consistency) = (out.series("n", "error"), out.series("n", "consistency"));
    if let (Some(error), Some(consistency)) = (error.last(), consistency.last()) {
        out.note("share", consistency.1 / error.1);
    }
    out.plot("falk_terms", "Terms of Falk's lemma", Axes::LogLog("n = 1/h", "term"))
        .curve_by("cone", "n", "error")
        .curve_by("cone", "n", "interpolation")
        .curve_by("cone", "n", "consistency");
    Ok(())
}
