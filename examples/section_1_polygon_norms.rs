//! Section 1, boundaries: norms of order ν and −ν on the boundary Γ of a polygon, with the distance
//! in the plane.
//!
//! The paper measures σ_N in a space dual to traces. On the boundary of a polygon, 0 < ν < 1,
//!
//! ```text
//! |v|²_ν = ∫_Γ∫_Γ (v(x) − v(y))² / |x − y|^(1+2ν) ds ds,
//! ‖v‖²_ν = ∫_Γ v² ds + |v|²_ν,        ‖g‖_−ν = sup ∫_Γ g v ds / ‖v‖_ν.
//! ```
//!
//! This file computes norms of x₁, of a hat function and of the normal n₁ on a square and an
//! L-shape, and compares them with three facts. At ν = 1/2 the integrands of |x₁|² and |x₂|² add up
//! to one, so by symmetry of square and L-shape |x₁|² = L²/2, L the length of Γ. The hat function φ
//! of a right angle tends to |φ|² = 4 + 2 ln 2 + 4G − π (G Catalan's constant) as its elements
//! shrink. The normal n₁ satisfies ∫ n₁ x₁ ds = area, hence area ≤ ‖n₁‖_−ν ‖x₁‖_ν.
//!
//! Refuted if 2|x₁|²/L² is off 1 by 1e-6; if |φ|², extrapolated by c/n from the last two n, is off
//! its limit by 0.2 %; or if area/(‖n₁‖ ‖x₁‖) exceeds 1 by more than the error of ‖n₁‖.
//! Undecided while a bound lies inside of an error bar.
//!
//! `cargo run --release --example section_1_polygon_norms -- --nu 0.3`

use example_report::prelude::*;
use fractional_sobolev::{Curve, Function, Mesh};
use std::f64::consts::{LN_2, PI};

example! { seconds "Section 1, boundaries",
    "norms of order ν and −ν on polygons agree with closed forms";
    /// order ν; closed forms on polygons are known for ν = 1/2
    nu: Order = "1/2" in "(0, 1)" slider "0.1 to 0.9",
    /// numbers of elements per unit length, increasing
    n: Vec<usize> = "4,8,16" in "[2, 200]",
}

const CATALAN: f64 = 0.915_965_594_177_219;

/// Name, vertices with a right angle at the first, area.
fn polygons() -> [(&'static str, Vec<[f64; 2]>, f64); 2] {
    let square = vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    let l_shape = vec![[0.0, 0.0], [0.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0], [-1.0, 0.0]];
    [("square", square, 1.0), ("L-shape", l_shape, 3.0)]
}

/// Limit of v + c/n^order from the last two of a series.
fn limit(series: &[(f64, Measured)], order: i32) -> Measured {
    let [.., (n, coarse), (m, fine)] = series else { return Measured::NONE };
    *fine + (*fine - *coarse) / ((m / n).powi(order) - 1.0)
}

fn run(options: &Options, out: &mut Report) -> Result<()> {
    let nu = options.nu;
    for (polygon, vertices, area) in polygons() {
        let sides = vertices.len();
        let side = |k: usize| {
            let ([a, b], [c, d]) = (vertices[k], vertices[(k + 1) % sides]);
            ((c - a).hypot(d - b), d - b)
        };
        let mut corners = Vec::new();
        for &n in &options.n {
            let on_side = |k: usize| {
                let (length, _) = side(k);
                Mesh::uniform(n * length.round() as usize, 1.0)
            };
            let meshes = (0..sides).map(on_side).collect::<fractional_sobolev::Result<Vec<_>>>()?;
            let curve = Curve::closed(&vertices, &meshes)?;
            // Continuous, linear on each element. All pairs of elements: closed forms for
            // neighbours, Gauss rules else.
            let x: Vec<f64> = curve.nodes().iter().map(|node| node[0]).collect();
            let x = Function::on_curve(&curve, 1, &x)?;
            let twice =
                Measured::from(x.seminorm(nu, 1e-6)?).squared() * 2.0 / curve.length().powi(2);
            let hat: Vec<f64> = (0..curve.len()).map(|k| if k == 0 { 1.0 } else { 0.0 }).collect();
            let hat =
                Measured::from(Function::on_curve(&curve, 1, &hat)?.seminorm(nu, 1e-6)?).squared();
            corners.push((n as f64, hat));
            // n₁ is constant on each side, (rise of y)/length. ‖n₁‖_−ν is the supremum over
            // continuous linear v, s = (bᵀ G⁻¹ b)^(1/2), G the Gram matrix of ‖·‖_ν, b = ∫ n₁ φᵢ,
            // on n elements a side, with nodes at distances (1/2) (2k/n)^3, k ≤ n/2, times the side
            // from its corners; on these elements halved; and on those halved again. From s₀, s₁,
            // s₂ the limit is s₂ + (s₂ − s₁)²/((s₁ − s₀) − (s₂ − s₁)), ± the second summand.
            let graded = Curve::algebraic(&vertices, n, 3.0)?;
            let normal: Vec<f64> = (0..graded.len())
                .map(|e| side(e / n))
                .map(|(length, rise)| rise / length)
                .collect();
            let dual = Estimate::or_best(Function::on_curve(&graded, 0, &normal)?.norm(-nu, 1e-3))?;
            let duality = Measured::from(area) / (Measured::from(dual) * x.norm(nu, 1e-6)?);
            out.row(cells! { polygon, n =>
                twice: twice.value, hat: hat.value, dual: dual.value, duality: duality.value
            });
            if nu == Order::HALF {
                let claim = out.check("2|x₁|²/L²");
                claim.whole_error_bars_differ_by_at_most(twice, 1.0, 1e-6, "|x₁|² + |x₂|² = L²");
            }
            let claim = out.check("area/(‖n₁‖ ‖x₁‖)");
            claim.whole_error_bars_at_most(duality, 1.0, "∫ n₁ x₁ ds = area");
        }
        if nu == Order::HALF {
            let exact = 4.0 + 2.0 * LN_2 + 4.0 * CATALAN - PI;
            let ratio = limit(&corners, 1) / exact;
            let claim = out.check("extrapolated |φ|²/exact limit");
            claim.whole_error_bars_differ_by_at_most(ratio, 1.0, 2e-3, "4 + 2 ln 2 + 4G − π");
        }
    }
    out.column("n", "n", "elements on the length 1");
    out.column("twice", "2|x₁|²/L²", "");
    out.column("hat", "|φ|²", "hat function of the corner (0, 0)");
    out.column("dual", "‖n₁‖_−ν", "");
    out.column("duality", "area/(‖n₁‖ ‖x₁‖)", "");
    let axes = Axes::LogLinear("elements on the length 1", "|φ|² of the corner (0, 0)");
    let exact =
        options.n.iter().map(|&n| (n as f64, 4.0 + 2.0 * LN_2 + 4.0 * CATALAN - PI)).collect();
    let plot = out.plot("section_1_polygon_norms", "Hat function of a right angle", axes);
    plot.curve_by("polygon", "n", "hat").dashed_line("limit", exact);
    Ok(())
}
