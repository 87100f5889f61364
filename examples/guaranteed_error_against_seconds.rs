//! A guaranteed error against seconds: uniform and adaptive meshes on three bodies.
//!
//! Let σ(v) be the stress of v (scalar: ∇v), |||v|||² = ∫ σ(v) : ε(v) = a(v, v), ‖q‖² = ∫ q : 𝒜⁻¹q,
//! and J(v) = ½ a(v, v) − ∫ f·v. u minimises J under v_N ≤ 0 on the contact edge, and u^h does so
//! among the linear elements that are ≤ 0 at the nodes of this edge. For a stress q with div q + f
//! = 0, q n = 0 on the free part, q_T = 0 and q_N ≤ 0 on the contact edge,
//!
//! ```text
//! |||u − u^h|||² ≤ bound² = ‖σ(u^h) − q‖² + 2∫ q_N u^h_N = 2 (J(u^h) − J*(q)),   J*(q) = −½ ‖q‖².
//! ```
//!
//! with ∫ q_N u^h_N over the contact edge. The paper has no such number. q is the best stress of
//! the form q_p + q_0. q_p has the load: q_p = diag(0, −∫₀ʸ f_y dt) for the block, f = (0, f_y),
//! and (−∫₀ˣ f dt, 0) for the scalar bodies. q_0 has no load, div q_0 = 0, and is taken on the
//! triangles of u^h. For the block it is the stress of an Airy function φ in the
//! Hsieh-Clough-Tocher space. There ∂φ/∂n is quadratic along edges, so that all tractions are
//! linear. (Example `two_sided_energies` writes out the problem for φ, in the reduced space.) For
//! the scalar bodies q_0 is (∂_y ψ, −∂_x ψ) with ψ continuous and quadratic on triangles. bound² is
//! a sum over triangles and contact segments. The first mesh is of squares with sides 1/4
//! (`block`), 1/2 (`L`) or 1/8 (`waves`), each cut by the diagonal from its lower left to its upper
//! right corner. On uniform meshes every triangle is cut into four by the midpoints of its edges.
//! On adaptive meshes the fewest triangles that carry half of bound² are bisected twice at their
//! longest edges, and neighbours so that no node hangs. Both problems, for u^h and for q, are
//! solved again (`Refinement`).
//!
//! - `block`: the elastic unit square, λ = μ = 1, clamped on top, f = (0, −cos πx), contact on the
//!   bottom edge.
//! - `L`: the scalar problem −Δu = 1 − x on (0, 2)² less [1, 2)², u = 0 on y = 2, u ≤ 0 on y = 0.
//! - `waves`: the scalar problem −Δu = cos 4πx + 1/10 on the unit square, u = 0 on top, u ≤ 0 on
//!   the bottom: three contact intervals.
//!
//! For linear elements no sequence of meshes has a better order than
//!
//! ```text
//! |||u − u^h||| = O(N^(−1/2)),        N the number of unknowns;
//! ```
//!
//! uniform meshes reach it only for u in H². Where u behaves like r^α at a corner or where the
//! boundary condition changes, their order is −α/2: α = 2/3 at the corner of the L, 0.7447 where
//! the clamped top of the block meets its free sides, the root of 8 sin²(απ/2) = 9 − 4α².
//!
//! The order is measured between the first mesh with at least a fiftieth of the largest number of
//! unknowns and the last mesh, the finest within this number. The claim is refuted if on adaptive
//! meshes the order is not −1/2 ± 0.03, if the order on uniform meshes is the better one by more
//! than 0.03, or if the bound rises on a finer mesh. That it never rises follows from nested spaces
//! for the scalar bodies. For the block it is only seen: Hsieh-Clough-Tocher spaces are not nested.
//! The bound holds for the computed u^h and q, even where the two are not quite the best, and
//! contains what rounding may have changed. So no number has an error bar. The 0.03 is chosen: over
//! a factor 16 in N it changes the bound by 9 %. The seconds are shown and decide nothing.
//!
//! `cargo run --release --example guaranteed_error_against_seconds -- --unknowns 300000 --out out`

use example_report::prelude::*;
use signorini::bounds::Refinement;
use signorini::contact::Body;
use signorini::fem::{Form, Lame};
use signorini::mesh::{Part, SideParts, unit_square, unit_squares};
use std::f64::consts::PI;
use std::time::Instant;

example! { seconds "A guaranteed error, its cost",
    "the bound of |||u − u^h||| falls like N^(−1/2) on adaptive meshes, whatever the corners";
    /// largest number of unknowns
    unknowns: usize = "20000" in "[20000, 2000000]",
}

/// One mesh of a sequence.
struct Point {
    unknowns: f64,
    bound: f64,
    seconds: f64,
}

fn bodies() -> signorini::Result<Vec<(&'static str, Body<'static>)>> {
    // HANGING: u = 0 on the top side, contact on the bottom side, the others free.
    let block = Body::new(unit_square(4, SideParts::HANGING)?, Form::elastic(Lame::new(1.0, 1.0)?))
        .load(|[x, _]: [f64; 2]| [0.0, -(PI * x).cos()]);
    let part = |[_, y]: [f64; 2]| match y {
        0.0 => Part::Contact,
        2.0 => Part::Dirichlet,
        _ => Part::Neumann,
    };
    let l = Body::new(unit_squares(2, &[[0, 0], [1, 0], [0, 1]], part)?, Form::LAPLACE)
        .load(|[x, _]: [f64; 2]| 1.0 - x);
    let waves = Body::new(unit_square(8, SideParts::HANGING)?, Form::LAPLACE)
        .load(|[x, _]: [f64; 2]| (4.0 * PI * x).cos() + 0.1);
    Ok(vec![("block", block), ("L", l), ("waves", waves)])
}

fn run(options: &Options, out: &mut Report) -> Result<()> {
    out.column(
        "relative",
        "bound/|||u|||",
        "guaranteed, on the last mesh; in place of |||u||| the smaller (−2J(u^h))^(1/2)",
    );
    out.column("order", "order in N", "of the bound");
    out.column("seconds", "s", "all meshes up to this one, both problems on each");
    let mut curves = Vec::new();
    for (body_name, body) in bodies()? {
        let mut orders = Vec::new();
        for (meshes, share) in [("uniform", 1.0), ("adaptive", 0.5)] {
            // A tolerance that is out of reach: the limit of unknowns ends the refinement. `share`
            // is the part of bound² whose triangles are bisected, and 1 cuts every triangle into
            // four by midpoints; `growth` 1: both problems are solved after each refinement.
            let refinement = Refinement {
                tolerance: 1e-9,
                unknowns: options.unknowns,
                share,
                growth: 1.0,
                ..Refinement::default()
            };
            let (start, mut points) = (Instant::now(), Vec::<Point>::new());
            let (last, _) = refinement.run(&body, |found| {
                points.push(Point {
                    unknowns: found.problem.free_unknowns() as f64,
                    bound: found.error,
                    seconds: start.elapsed().as_secs_f64(),
                });
            })?;
            let first =
                points.partition_point(|point| point.unknowns < 0.02 * options.unknowns as f64);
            let [begin, .., end] = &points[first..] else { continue };
            let order = (end.bound / begin.bound).ln() / (end.unknowns / begin.unknowns).ln();
            let rise =
                points.windows(2).map(|pair| pair[1].bound / pair[0].bound).fold(0.0, f64::max);
            out.check("bound on the finer mesh/bound").at_most(rise, 1.0, "no rise");
            if meshes == "adaptive" {
                let claim = out.check("adaptive meshes: order of the bound in N");
                claim.differ_by_at_most(order, -0.5, 0.03, "N^(−1/2)");
            }
            out.row(cells! { body: body_name, meshes => unknowns: end.unknowns as usize,
            relative: last.relative_error(), order, seconds: (1e3 * end.seconds).ceil() / 1e3 });
            orders.push(order);
            let line =
                points.iter().map(|point| (point.seconds, point.bound / last.norm.lower)).collect();
            curves.push((format!("{body_name}, {meshes}"), line));
        }
        if let [uniform, adaptive] = orders[..] {
            let claim = out.check("order, uniform less adaptive");
            claim.at_least(uniform - adaptive, -0.03, "no better order");
        }
    }
    let axes = Axes::LogLog("seconds", "guaranteed error / |||u|||");
    let plot = out.plot("guaranteed_error_against_seconds", "What a guaranteed error costs", axes);
    for (name, points) in curves {
        plot.line(&name, points);
    }
    Ok(())
}
