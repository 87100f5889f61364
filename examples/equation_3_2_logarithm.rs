//! (3.2), (4.3): at τ = 2, does the error need a power of |ln h|?
//!
//! For u in H² the paper proves ‖u − u^h‖ ≤ C h |ln h|^(1/2) (h is the size of the triangles, ‖·‖ the energy norm) for the nodal
//! cone, u^h ≤ 0 at the nodes of the contact edge (3.2), and for the midpoint cone, means over the segments ≤ 0 (4.3). With the
//! sharp form of Lemma 5.2 its proof gives h |ln h|^(1/4); later h was proved (Drouet and Hild 2015).
//!
//! Near an end of the contact set let u_N' (on one side) and σ_N (on the other) be like ℓ(r)^(−α), ℓ(r) = 2 + |ln r|: u is in
//! H² if and only if α > 1/2. Cells at distance r from it add h² ℓ(r)^(−2α) dr/r to the squared error, so that
//!
//! ```text
//! (‖u − u^h‖/h)² ≈ B + A ℓ(h)^q / q,     q = 1 − 2α:     no logarithm for q < 0,     |ln h|^(q/2) for q > 0.
//! ```
//!
//! q is measured: the increments of the left side over two halvings are like ℓ^(q−1), and q − 1 is their slope over ℓ in
//! logarithms, its ± the difference between both halves of the meshes. Refuted if for α > 1/2 ‖u − u^h‖ / (h |ln h|^(1/2)) grows
//! from the middle to the finest mesh; loose if also q < 0.
//!
//! Test problem: u harmonic on the unit square, 0 on top, ∂u/∂n = 0 on the sides, g ≤ 0 and the pressure λ chosen on the edge,
//! g λ = 0. `transition`: contact for x < a, λ = ℓ(a − x)^(−α), g = −δ ℓ(δ)^(−α), δ = d (2 − 2a − d)/(2 − 2a), d = x − a > 0, and
//! root mean squares over a = 5/12, 11/24. `transitions:11`: eleven equal gaps at equal distances with such data at both ends. `cantor:0.25`:
//! the gaps of the Cantor set that keeps a quarter at either end of an interval, g = −δ^(5/4) ℓ(δ)^(−α), nodal cone only.
//!
//! `cargo run --release --example equation_3_2_logarithm -- --problem transition --alpha 0,0.6,1.5 --finest 16`

// `at_most(x, b)` holds if x + its ± ≤ b, `at_least(x, b)` if x − its ± ≥ b, `near(x, b, t)` if |x − b| + its ± ≤ t;
// otherwise it fails, or is undecided within ±. Of several calls the worst counts. Where `stronger` holds, the
// statement is loose. `observe` decides nothing.
use example_report::prelude::*;
use signorini::cone::Cone;
use signorini::problems::{StripData, TransitionPowers};
use signorini::strip::{EdgeData, LateralCondition, Reference, StripKind, StripProblem};

example! { seconds "(3.2), (4.3)", "u in H²:  ‖u − u^h‖ ≤ C h |ln h|^(1/2),  both cones";
    /// contact sets on the edge
    problem: Vec<StripData> = "transition,transitions:11,cantor:0.25",
    /// slopes and pressures like |ln r|^-alpha
    alpha: Vec<f64> = "0,0.75,1" in "[0, 4]" slider "0 to 2",
    /// meshes of 8, 16, .. 2^finest cells along the edge
    finest: u32 = "14" in "[9, 18]",
}

/// (h, ‖u − u^h‖), coarsest first. u is the discrete harmonic function with the values g on N = 16·2^finest cells, and
/// u^h solves the problem with its load by iterating the active set, conjugate gradients and cosine transforms, to 1e-13.
/// The load of u is the discrete normal derivative of u on N cells plus ∫ λ over the cells (exact), summed onto the n cells by hats.
/// A function with coefficients c_k = Σ v_i cos kπi/n (end nodes by half) on the edge of n × n squares has the energy
/// ‖v‖² = Σ S_k c_k², S_k = (2/n) sinh η coth nη (k = 0, n by half), cosh η = 2 − cos(kπ/n). Errors against u on N cells lack
/// what u itself lacks: a square like h² − N^(−2) in place of h², which is made up for.
fn errors(edges: &[EdgeData], cone: Cone, finest: u32) -> Result<Vec<(f64, f64)>> {
    let mut squares = vec![0.0; finest as usize - 2];
    for edge in edges {
        let problem = StripProblem::new(StripKind::Scalar, edge, Reference::Nested, 8)?;
        let mut coarser = None;
        for (level, square) in (3..=finest).zip(&mut squares) {
            let n = 1 << level;
            let u = problem.operator(n)?.0.solve_contact(&problem.load(n)?, cone, coarser.as_ref(), 1e-13)?;
            let lacking = 1.0 - (n as f64 / edge.cells() as f64).powi(2);
            *square += problem.error(n, &u.values)?.value.powi(2) / lacking / edges.len() as f64;
            coarser = Some(u);
        }
    }
    Ok((3..=finest).zip(squares).map(|(level, square)| (0.5f64.powi(level as i32), square.sqrt())).collect())
}

/// Slope of ln y over ln x from the first to the last point; ± is the difference of the slopes of both halves.
fn slope(points: &[(f64, f64)]) -> Measured {
    let between = |a: (f64, f64), b: (f64, f64)| (b.1 / a.1).ln() / (b.0 / a.0).ln();
    let (Some(&first), Some(&last)) = (points.first(), points.last()) else { return Measured::NONE };
    let middle = points[points.len() / 2];
    Measured::new(between(first, last), between(first, middle) - between(middle, last))
}

fn run(options: &Options, out: &mut Report) -> Result<()> {
    let cells = 16usize << options.finest;
    out.column("expected", "1−2α", "");
    out.column("optimal", "e/h", "on the finest mesh, over that on the middle one; e = ‖u−u^h‖");
    out.column("sharp", "e/(h L^1/4)", "the same, L = |ln h|");
    out.column("paper", "e/(h L^1/2)", "the same");
    let mut curves = Vec::new();
    for problem in &options.problem {
        for &alpha in &options.alpha {
            let transition =
                |a: f64| TransitionPowers { opening: 1.0, pressure: 0.0, logarithm: alpha }.data(a, cells);
            let edges: Vec<EdgeData> = match problem.moves() {
                true => {
                    [5.0 / 12.0, 11.0 / 24.0].into_iter().map(transition).collect::<signorini::Result<_>>()?
                }
                false => vec![problem.damped_data(alpha, cells, LateralCondition::Natural)?],
            };
            // A Cantor set has measure zero, and the pressure is that of its last generation: the midpoint cone sees it.
            let cones: &[Cone] =
                if matches!(problem, StripData::Cantor { .. }) { &[Cone::Nodal] } else { &Cone::ALL };
            for &cone in cones {
                let points = errors(&edges, cone, options.finest)?;
                let ell = |h: f64| 2.0 - h.ln();
                let increments: Vec<(f64, f64)> = points
                    .windows(3)
                    .map(|p| (ell(p[1].0), (p[2].1 / p[2].0).powi(2) - (p[0].1 / p[0].0).powi(2)))
                    .collect();
                let skipped = increments.len() / 2; // the coarsest meshes
                let q = slope(&increments[skipped..]) + 1.0;
                let (middle, last) = (points[points.len() / 2], points[points.len() - 1]);
                let growth = |power: f64| {
                    let over = |(h, e): (f64, f64)| e / (h * (-h.ln()).powf(power));
                    over(last) / over(middle)
                };
                let [optimal, sharp, paper] = [0.0, 0.25, 0.5].map(growth);
                let name = problem.to_string().split(':').next().unwrap_or_default().to_owned();
                out.row(cells! { problem: name.clone(), alpha, cone: cone.to_string() => expected: 1.0 - 2.0 * alpha, q,
                    optimal, sharp, paper });
                if alpha > 0.5 {
                    out.check(format!("e/(h L^1/2) in H², {cone} cone")).at_most(paper, 1.0, "(3.2), (4.3)");
                    out.stronger(format!("q in H², {cone} cone")).at_most(q, 0.0, "no logarithm");
                    out.observe("e/h in H²").at_least(optimal, 1.0, "order h, no more");
                } else if alpha == 0.0 {
                    out.observe("q for α = 0, not in H²").at_least(q, 0.0, "|ln h|^(q/2)");
                }
                if problem.moves() {
                    let off = q - (1.0 - 2.0 * alpha);
                    out.observe("q − (1 − 2α), transition").near(off, 0.0, 0.2, "sum over the cells");
                    if cone == Cone::Nodal {
                        let points: Vec<(f64, f64)> =
                            points.iter().map(|(h, e)| (*h, e / h / (points[0].1 / points[0].0))).collect();
                        curves.push((format!("α = {alpha}"), points));
                    }
                }
            }
        }
    }
    let axes = Axes::LogLinear("h", "error/h over that at h = 1/8");
    let plot = out.plot("equation_3_2_logarithm", "τ = 2, nodal cone: does error/h grow?", axes);
    for (power, name) in [(0.25, "|ln h|^(1/4)"), (0.5, "|ln h|^(1/2)")] {
        let levels = (3..=options.finest).map(|level| 0.5f64.powi(level as i32));
        plot.dashed_line(name, levels.map(|h| (h, (h.ln() / 8f64.ln()).abs().powf(power))).collect());
    }
    for (name, points) in curves {
        plot.line(&name, points);
    }
    Ok(())
}
