//! Falk's lemma, term by term, for both cones: the first line of the proofs of Theorems 3.1 and
//! 4.1.
//!
//! Let u solve Signorini's problem, with the stress σ_N ≤ 0 on the contact edge, and let u^h be its
//! P1 approximation: u^h ≤ 0 at the nodes of the edge (nodal cone), or in the mean over each
//! segment (midpoint cone). I^h u has the values of u at the nodes of the edge and least energy
//! inside, π is the mean over each segment, ∫ is over the edge, ‖·‖ the energy norm. The paper uses
//!
//! ```text
//! ‖u − u^h‖² ≤ C (‖u − I^h u‖² + ∫ σ_N (I^h u − u))                     nodal cone, Section 3
//! ‖u − u^h‖² ≤ C (‖u − I^h u‖² + ∫ σ_N (I^h u − u) − ∫ σ_N u^h)         midpoint cone (4.5)
//! − ∫ σ_N u^h ≤ − ∫ (σ_N − π σ_N)(u^h − u) − ∫ (σ_N − π σ_N) u          (4.8)
//! ```
//!
//! ((4.5) has an infimum of ∫ σ_N (v − u^h) over v, attained at v = 0). This file computes every
//! term on meshes h = 1/8 .. 2^(−finest), and the C that is enough. Why C ≤ 2: among the v of the
//! cone u^h minimises
//!
//! ```text
//! F(v) = ‖u − v‖² + 2 ∫ σ_N (v − u),     so F(u^h) ≤ F(I^h u); with ∫ σ_N u = 0 that is
//! ‖u − u^h‖² ≤ ‖u − I^h u‖² + 2 ∫ σ_N (I^h u − u) − 2 ∫ σ_N u^h ≤ 2 (bracket);
//! ```
//!
//! in the nodal cone −∫ σ_N u^h ≤ 0 is dropped. Refuted if F(u^h) is above F(I^h u), or C above 2;
//! or if (4.8) fails: its right less its left side is ∫ πσ_N u^h ≥ 0, as the means of σ_N and of
//! u^h are ≤ 0; or if −∫ σ_N u^h is above 0 in the nodal cone (both by more than 1e-9 of
//! ‖u − u^h‖² + ‖u − I^h u‖²); or if `by_definition` and the library differ by 1e-9. Undecided
//! while a bound lies inside of an error bar, which is rounding.
//!
//! Test problem: as in Theorem 3.1 (`theorem_3_1_rates`), u is harmonic on the unit square, 0 on
//! top, ∂u/∂n = 0 on the sides, with the values g ≤ 0 and the pressure λ = −σ_N ≥ 0, g λ = 0,
//! chosen on the edge. For `transition`
//!
//! ```text
//! g = −(d (2 − 2a − d)/(2 − 2a))^(τ−1), d = x − a, for x > a;     λ = (a − x)^(τ−2) for x < a,
//! ```
//!
//! the integral of λ over a fine cell half to each of its nodes, that from the last node below a up
//! to a to that node; the terms are means over the places a = 5/12 and 11/24, and C is mean over
//! mean. The fine edge has N = 64·2^finest cells; u is the discrete harmonic function on N × N
//! squares with the values g there, and the load on the edge is ∂u/∂n of that function plus the
//! forces of λ, so that u is the solution. Other sets: see `section_2_strip`.
//!
//! `cargo run --release --example falk_terms -- --problem fat-cantor --tau 1.6`

use example_report::prelude::*;
use signorini::cone::Cone;
use signorini::problems::{StripData, TransitionPowers};
use signorini::strip::{
    EdgeData, EdgeSolution, LateralCondition, Reference, StripKind, StripProblem,
};
use std::f64::consts::PI;

example! { quick "Falk's lemma, (4.5), (4.8)",
    "‖u−u^h‖² ≤ C (‖u−I^h u‖² + ∫σ(I^h u−u)); midpoint cone: −∫σu^h added";
    /// prescribed contact set on the edge
    problem: StripData = "transition",
    /// regularity τ of the solution
    tau: f64 = "1.75" in "(1.5, 2]" slider "1.55 to 2",
    /// meshes of 8, 16, .. 2^finest cells along the edge
    finest: u32 = "10" in "[5, 14]",
}

/// ‖u − v‖², u discrete harmonic with values g on N cells, v with values on n. In waves c_k = Σ v_i
/// cos kπi/n (end nodes by half), k = 0, .., n, the energy is ‖v‖² = Σ S_k c_k², S_k = (2/n) sinh η
/// coth nη (k = 0, n by half), sinh(η/2) = sin(kπ/2n), S_0 = 1/n².
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
        let symbol = |k: usize| match 2.0 * (0.5 * k as f64 * PI / n as f64).sin().asinh() {
            0.0 => 1.0 / (n * n) as f64,
            eta => 2.0 * half(k) / n as f64 * eta.sinh() / (n as f64 * eta).tanh(),
        };
        (0..=n).map(|k| symbol(k) * wave(v, k) * wave(w, k)).sum()
    };
    let on_fine: Vec<f64> =
        (0..g.len()).map(|j| linear(v, j, (g.len() - 1) / (v.len() - 1))).collect();
    form(g, g) - 2.0 * form(g, &on_fine) + form(v, v)
}

/// The piecewise linear function with these nodal values at the fine node j, with so many fine
/// cells to a cell.
fn linear(v: &[f64], j: usize, cells: usize) -> f64 {
    let (i, s) = (j / cells, (j % cells) as f64 / cells as f64);
    if s == 0.0 { v[i] } else { v[i] + s * (v[i + 1] - v[i]) }
}

/// The terms of both lines.
#[derive(Debug, Default)]
pub struct Terms {
    /// ‖u − u^h‖².
    pub error: f64,
    /// ‖u − I^h u‖².
    pub interpolation: f64,
    /// Rounding of the larger of these two squares, as stated by the library.
    pub rounding: f64,
    /// ∫ σ_N (I^h u − u).
    pub consistency: f64,
    /// −∫ σ_N u^h.
    pub second: f64,
    /// −∫ (σ_N − π σ_N)(u^h − u) of (4.8).
    pub part_one: f64,
    /// −∫ (σ_N − π σ_N) u of (4.8).
    pub part_two: f64,
}

/// The terms on n cells; −σ_N is a force λ_j at every node of the fine edge.
pub fn terms(edge: &EdgeData, problem: &StripProblem, u: &EdgeSolution) -> Result<Terms> {
    let (g, force, n, cells) = (edge.values(), edge.forces(), u.cells, edge.cells() / u.cells);
    let nodal: Vec<f64> = g.iter().copied().step_by(cells).collect(); // I^h u
    let work =
        |v: &[f64]| force.iter().enumerate().map(|(j, f)| f * linear(v, j, cells)).sum::<f64>();
    // Σ of the force on a segment times the means of u^h and of u; a force at a common node belongs
    // to both by half.
    let (mut of_u_h, mut of_u) = (0.0, 0.0);
    for s in 0..n {
        let (a, b) = (s * cells, (s + 1) * cells);
        let share = |j: usize| if j == a && s > 0 || j == b && s + 1 < n { 0.5 } else { 1.0 };
        let on_segment: f64 = (a..=b).map(|j| share(j) * force[j]).sum();
        let area: f64 = (a..b).map(|j| 0.5 * (g[j] + g[j + 1])).sum();
        of_u_h += on_segment * 0.5 * (u.values[s] + u.values[s + 1]);
        of_u += on_segment * area / cells as f64;
    }
    // ‖u − v‖² as in `by_definition`, by fast transforms.
    let square =
        |v: &[f64]| -> Result<Measured> { Ok(Measured::from(problem.distance(n, v)?).squared()) };
    let (error, interpolation) = (square(&u.values)?, square(&nodal)?);
    let second = work(&u.values);
    Ok(Terms {
        error: error.value,
        interpolation: interpolation.value,
        rounding: error.error.max(interpolation.error),
        consistency: -work(&nodal),
        second,
        part_one: second - of_u_h + of_u,
        part_two: -of_u,
    })
}

/// The largest C of each cone.
pub struct Constants {
    /// For the nodal cone.
    pub nodal: f64,
    /// For the midpoint cone.
    pub midpoint: f64,
}

pub(crate) fn run(options: &Options, out: &mut Report) -> Result<Constants> {
    let &Options { ref problem, tau, finest } = options;
    let edges = |cells: usize| -> signorini::Result<Vec<EdgeData>> {
        let transition = |a: f64| TransitionPowers::of_regularity(tau).data(a, cells);
        if problem.moves() {
            return [5.0 / 12.0, 11.0 / 24.0].into_iter().map(transition).collect();
        }
        Ok(vec![problem.data(tau, cells, LateralCondition::Natural)?])
    };
    out.column("error", "‖u−u^h‖²", "");
    out.column("interpolation", "‖u−I^h u‖²", "");
    out.column("consistency", "∫σ(I^h u−u)", "");
    out.column("second", "−∫σu^h", "");
    out.column("part_one", "part 1", "−∫ (σ − πσ)(u^h − u) of (4.8)");
    out.column("part_two", "part 2", "−∫ (σ − πσ) u");
    out.column("constant", "C", "the first column over the bracket");
    let (fine, coarse) = (edges(64 << finest)?, edges(512)?);
    let problems = fine
        .iter()
        .map(|edge| Ok(StripProblem::new(StripKind::Scalar, edge, Reference::Nested, 8)?))
        .collect::<Result<Vec<StripProblem>>>()?;
    let mut largest = Constants { nodal: 0.0, midpoint: 0.0 };
    for cone in [Cone::Nodal, Cone::Midpoint] {
        for edge in &coarse {
            let exact = StripProblem::new(StripKind::Scalar, edge, Reference::Nested, 8)?;
            let u_h = exact.solve(8, cone)?;
            let library = Measured::from(exact.error(&u_h)?).squared();
            let ratio = library.recip() * by_definition(edge.values(), &u_h.values);
            let claim = out.check("‖u−u^h‖², n = 8: by_definition/library");
            claim.whole_error_bars_differ_by_at_most(ratio, 1.0, 1e-9, "`by_definition`");
        }
        for n in (3..=finest).map(|level| 1 << level) {
            // Means over the places of the transition.
            let mut mean = Terms::default();
            for (edge, exact) in fine.iter().zip(&problems) {
                // Active set; conjugate gradients for the values at the edge, to 1e-13 of the load.
                let u_h = exact.solve(n, cone)?;
                let found = terms(edge, exact, &u_h)?;
                let share = 1.0 / fine.len() as f64;
                mean.error += share * found.error;
                mean.interpolation += share * found.interpolation;
                mean.rounding += share * found.rounding;
                mean.consistency += share * found.consistency;
                mean.second += share * found.second;
                mean.part_one += share * found.part_one;
                mean.part_two += share * found.part_two;
            }
            let Terms { error, interpolation, rounding, .. } = mean;
            let Terms { consistency, second, part_one, part_two, .. } = mean;
            let bracket = match cone {
                Cone::Nodal => interpolation + consistency,
                Cone::Midpoint => interpolation + consistency + second,
            };
            let constant = error / bracket;
            match cone {
                Cone::Nodal => largest.nodal = constant.max(largest.nodal),
                Cone::Midpoint => largest.midpoint = constant.max(largest.midpoint),
            }
            out.row(cells! { cone: cone.to_string(), n =>
                error, interpolation, consistency, second, part_one, part_two, constant
            });

            let [square, bracket] = [error, bracket].map(|value| Measured::new(value, rounding));
            let claim = out.check(format!("C, {cone} cone"));
            claim.whole_error_bars_at_most(square / bracket, 2.0, "F(u^h) ≤ F(I^h u)");
            let of_interpolant = Measured::new(interpolation, rounding) + 2.0 * consistency;
            let ratio = (square - 2.0 * second) / of_interpolant;
            let claim = out.check("‖u−v‖²+2∫σ(v−u): value at u^h/at I^h u");
            claim.whole_error_bars_at_most(ratio, 1.0, "u^h minimises it");
            let scale = error + interpolation;
            let excess = (second - part_one - part_two) / scale;
            let claim = out.check("(4.8): left − right side, relative");
            claim.at_most(excess, 1e-9, "πσ ≤ 0, πu^h ≤ 0");
            if cone == Cone::Nodal {
                let claim = out.check("nodal cone: −∫σu^h, relative");
                claim.at_most(second / scale, 1e-9, "u^h ≤ 0");
            } else {
                let claim = out.observe("−∫σu^h, midpoint cone");
                claim.at_most(second / scale, 1e-9, "either sign");
            }
        }
    }
    let order = -out.exponent("n", "consistency"); // between the last two meshes
    let printed = if tau < 2.0 { 2.0 * tau * tau - 5.0 * tau + 4.0 } else { 2.0 * tau - 2.0 };
    let claim = out.observe("order of ∫σ(I^h u−u) in h");
    claim.whole_error_bars_at_least(order, printed, "2τ² − 5τ + 4");
    let last = |column: &str| out.series("n", column).last().map(|&(_, value)| value);
    if let (Some(error), Some(consistency)) = (last("error"), last("consistency")) {
        out.note("share", consistency / error);
    }
    out.plot("falk_terms", "Terms of Falk's lemma", Axes::LogLog("n = 1/h", "term"))
        .curve_by("cone", "n", "error")
        .curve_by("cone", "n", "interpolation")
        .curve_by("cone", "n", "consistency");
    Ok(largest)
}
