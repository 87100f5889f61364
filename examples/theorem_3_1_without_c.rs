//! A bound of the error at τ = 2 with a number for C; Theorems 3.1 and 4.1 have an unknown C and a factor |ln h|^(1/2).
//!
//! Let u in H², |u|₂² = Σ ‖∂ᵢ∂ⱼ u_k‖² over the body, squares of side h cut into two triangles, energy norm ‖·‖. Then
//!
//! ```text
//! ‖u − u^h‖ ≤ C h |u|₂     for every contact set, every h and both cones,     C² = M A² + b² + 2π ϑ S c,
//! ```
//!
//! where (3.2) and (4.3) have an unknown constant and a factor |ln h|^(1/2). With ϑ = coth π and Lamé's constants λ, μ: A,
//! 1/A + tan(1/A) = 0: interpolation on a triangle with legs h, ‖∇(u − I u)‖ ≤ A h |u|₂ (Kikuchi, Liu 2006). M = 2μ + 2
//! max(λ, 0): ‖v‖² ≤ M ‖∇v‖².  S = (λ² + (λ + 2μ)²)^(1/2): |∇σ_N| by second derivatives. b = 0, nodal cone; b = (ϑ/π) S B,
//! midpoint cone, B = φ/√(2μ + 2 min(λ, 0)) of Korn's inequality, φ the golden ratio. Laplacian: M = S = B = 1. c:
//! consistency term of a segment over h² |σ_N|_½ |u_N'|_½; c = 2/27 is proved for every contact set (½ max x² (1 − x), page
//! `segment_constants`), 1/8 for the midpoint cone. Computed: K, the best constant of ‖σ_N‖₁ ‖u_N'‖₁, midpoint cone K/2;
//! and κ ≤ K, the best c for one transition. The terms with c and b need |u|₂ in the squares at the contact edge only: the
//! bound of the edge, smaller still.
//!
//! Problem: closed forms, u = −Re F or Westergaard's displacement of F, F = (z − 3/10)^(3/2) or ((z − 3/10)(7/10 − z))^(3/2).
//! Refuted if one error, plus 0.1 % for its quadrature, exceeds C h |u|₂.
//!
//! `cargo run --release --example theorem_3_1_without_c -- --finest 8 --lambda 100`

// `at_most(x, b)` holds if x + its ± ≤ b; otherwise it fails, or is undecided within ±. Of several calls the worst
// counts. Where `stronger` holds, the statement is loose. `observe` decides nothing.
use example_report::prelude::*;
use signorini::cone::Cone;
use signorini::contact::{ContactSolution, Settings, Start};
use signorini::fem::Lame;
use signorini::problems::KnownSolution;
use signorini::proof::{consistency_constant, half_plane_korn, product_constant};
use std::f64::consts::PI;

example! { seconds "A bound in numbers, τ = 2", "τ = 2, any contact set:  ‖u − u^h‖ ≤ C h |u|₂,  C a number";
    /// meshes of 4 × 4, 8 × 8, .. 2^finest × 2^finest squares
    finest: u32 = "7" in "[4, 11]" slider "4 to 7",
    /// Lamé's constant λ of the elastic bodies, μ = 1
    lambda: f64 = "1" in "[0, 1e12]" slider "0 to 100",
}

/// A: 1/A in (π/2, π) is where t cos t + sin t changes its sign; bisection.
fn interpolation() -> f64 {
    let (mut low, mut high) = (PI / 2.0, PI);
    while high - low > 1e-15 * high {
        let t = 0.5 * (low + high);
        if t * t.cos() + t.sin() > 0.0 { low = t } else { high = t }
    }
    1.0 / low
}

/// M A², and b² + 2π ϑ S c.
fn constants(lame: Option<Lame>, cone: Cone, c: f64) -> [f64; 2] {
    let theta = 1.0 / PI.tanh();
    let [m, s, b] = lame.map_or([1.0; 3], |lame| {
        let (lambda, mu) = (lame.lambda(), lame.mu());
        [2.0 * mu + 2.0 * lambda.max(0.0), lambda.hypot(lambda + 2.0 * mu), half_plane_korn(lame)]
    });
    let korn = if cone == Cone::Nodal { 0.0 } else { theta / PI * s * b };
    [m * interpolation().powi(2), korn * korn + 2.0 * PI * theta * s * c]
}

fn run(options: &Options, out: &mut Report) -> Result<()> {
    out.column("C", "C", "with the proved c");
    out.column("C_K", "C (K)", "with K in place of c; midpoint cone: K/2");
    out.column("C_kappa", "C (κ)", "with κ; midpoint cone: K/2");
    out.column("ends", "ends", "number of ends of contact");
    out.column("seminorm", "|u|₂", "over the square, by adaptive quadrature, its error added");
    out.column("error", "error", "on the finest mesh");
    out.column("bound", "C h |u|₂", "on the finest mesh");
    out.column("least", "least", "smallest C h |u|₂ over error, all meshes");
    out.column("edge", "edge", "largest bound of the edge over error, κ in place of c");
    let up = |found: Estimate| found.value + found.error;
    // Largest quotient of the two sides over the places of one gap, a one-dimensional search; errors added.
    let product = up(product_constant(Order::HALF, 1e-6)?.value);
    let transition = up(consistency_constant(Order::HALF, 1e-6)?.value);
    out.note("A", interpolation());
    let mut curves = Vec::new();
    for (body, lame) in [("scalar", None), ("elastic", Some(Lame::new(options.lambda, 1.0)?))] {
        for known in [KnownSolution::one_transition(lame), KnownSolution::two_transitions(lame)] {
            let whole = up(known.second_seminorm(1, 1e-2)?);
            for cone in [Cone::Nodal, Cone::Midpoint] {
                let c = match cone {
                    Cone::Nodal => [2.0 / 27.0, product, transition],
                    Cone::Midpoint => [0.125, 0.5 * product, 0.5 * product],
                };
                let (mut coarse, mut points): (Option<ContactSolution>, Vec<[f64; 3]>) = (None, Vec::new());
                for n in (2..=options.finest).map(|k| 1usize << k) {
                    let (h, problem) = (1.0 / n as f64, known.problem(n)?); // u prescribed on the other three sides
                    let start = coarse.as_ref().map_or(Start::Open, Start::Coarse);
                    let u = problem.solve(cone, Settings { start, ..Settings::default() })?; // active set
                    let error = known.error_norms(&problem, &u.displacement)?.energy; // four points a side, graded
                    let measured = Measured::new(error, 1e-3 * error);
                    let near = up(known.second_seminorm(n, 1e-2)?).min(whole); // |u|₂ in the n squares at the edge
                    let bounds = c.map(|c| {
                        let [body, edge] = constants(lame, cone, c);
                        [whole, near].map(|part| h * (body * whole * whole + edge * part * part).sqrt())
                    });
                    let ratio = measured / bounds[0][0];
                    out.check("error/(C h |u|₂), c = 2/27 or 1/8").at_most(ratio, 1.0, "proved");
                    let ratio = measured / bounds[2][0];
                    out.stronger("error/(C h |u|₂), c = κ or K/2").at_most(ratio, 1.0, "one transition");
                    out.stronger("error/bound with |u|₂ near the edge").at_most(
                        measured / bounds[2][1],
                        1.0,
                        "|u|₂ at the edge",
                    );
                    points.push([h, bounds[0][0] / error, bounds[2][1] / error]);
                    coarse = Some(u);
                    if n == 1 << options.finest {
                        let [c, c_k, c_kappa] =
                            c.map(|c| constants(lame, cone, c).iter().sum::<f64>().sqrt());
                        let least = smallest(points.iter().map(|point| point[1])).map(|least| least.value);
                        let edge = largest(points.iter().map(|point| point[2])).map(|most| most.value);
                        out.row(cells! { body, ends: known.transitions().len(), cone: cone.to_string() =>
                            C: c, C_K: c_k, C_kappa: c_kappa, seminorm: whole, error, bound: bounds[0][0], least, edge });
                    }
                }
                for pair in points.windows(2) {
                    out.observe("edge bound/error: growth per refinement").at_most(
                        pair[1][2] / pair[0][2],
                        1.001,
                        "quadrature error",
                    );
                }
                let points = points.iter().map(|point| (point[0], point[2])).collect();
                curves.push((format!("{body}, {} transitions, {cone}", known.transitions().len()), points));
            }
        }
    }
    let title = "How far the bound of the edge is from the error";
    let plot = out.plot("theorem_3_1_without_c", title, Axes::LogLinear("h", "bound/error"));
    for (name, points) in curves {
        plot.line(&name, points);
    }
    Ok(())
}
