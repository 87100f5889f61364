//! The matrices of the seminorm (1.1) at work: the integral fractional Laplacian on an interval, by
//! piecewise linears on uniform and on graded meshes.
//!
//! The paper does not solve this equation. Its form is the square of the seminorm (1.1) over the
//! whole line, so the known solution tests the matrices that every constant of Lemmas 5.2 and 6.1
//! uses. For 0 < s < 1 let
//!
//! ```text
//! (−Δ)^s u(x) = C PV∫ (u(x) − u(y)) / |x − y|^(1+2s) dy over R,
//! C = 4^s Γ(s + 1/2) / (√π |Γ(−s)|),
//! ```
//!
//! and let u be the solution of (−Δ)^s u = 1 on (−1, 1) with u = 0 outside. Then
//!
//! ```text
//! u = (1 − x²)^s / Γ(1 + 2s),
//! |||u|||² = C/2 ∬ (u(x) − u(y))² / |x − y|^(1+2s) dx dy over R²
//!          = ∫ u = √π Γ(1 + s) / (Γ(3/2 + s) Γ(1 + 2s)).
//! ```
//!
//! The Galerkin solution u_h is orthogonal to its error, so |||u − u_h|||² = |||u|||² − |||u_h|||².
//! This file computes u_h on n elements and the order of the error in n. Since u grows like the
//! power s of the distance to an end, that order is
//!
//! ```text
//! 1/2 on uniform meshes,     2 − s for the nodes (2i/n)^β from each end, β = 2 (2 − s)
//! ```
//!
//! (Acosta & Borthagaray 2017 for the first; the second is that of interpolation). The order is
//! log₄ (e(n/4)/e(n)) of the two finest meshes, e = |||u − u_h|||/|||u|||; its ± is the sum of the
//! relative ± of both e over ln 4.
//!
//! Refuted if an order is off by 0.03 (0.08 on graded meshes, where both ends add a logarithm), if
//! `by_definition` gives another energy by 1e-9, or if between the two finest meshes the number of
//! iterations grows by more than 2: without a preconditioner it grows by the factor 4^s or more.
//! An order holds if it does on its whole ±, is refuted if it fails on the whole of it, and is
//! undecided otherwise; also where the order of the other kind of mesh, or growth by 4^s, would
//! pass as well.
//!
//! Other orders:
//!
//! `cargo run --release --example fractional_laplacian -- --s 0.4,0.6`

use example_report::prelude::*;
use fractional_sobolev::{Gram, Mesh};
use nalgebra::{Cholesky, DVector};
use std::f64::consts::PI;
use std::time::Instant;

example! { seconds "Fractional Laplacian",
    "(−Δ)^s u = 1 on (−1, 1):  ‖u − u_h‖ ≤ C n^(−1/2) on uniform, C n^(s−2) √ln n on graded meshes";
    /// orders s
    s: Vec<f64> = "0.25,0.75" in "[0.1, 0.9]" slider "0.1 to 0.9",
    /// meshes of 16, 64, .. 4^finest elements
    finest: u32 = "6" in "[4, 9]",
}

/// Smallest error that is shown.
const RESOLVED: f64 = 1e-6;

/// Elements of the mesh up to which the energy is found by elimination as well.
const ELIMINATED: usize = 256;

/// Nodes (2i/n)^β from each end of an interval of length 2.
fn two_sided(n: usize, beta: f64) -> Result<Mesh> {
    let half = Mesh::algebraic(n / 2, beta, 1.0)?;
    let lengths = half.lengths();
    Ok(Mesh::from_lengths(
        &lengths.iter().chain(lengths.iter().rev()).copied().collect::<Vec<_>>(),
    )?)
}

/// Γ(x) for x > 0: x Γ(x) = Γ(x + 1) up to 20, then Stirling's series; 14 digits.
fn gamma(x: f64) -> f64 {
    if x < 20.0 {
        return gamma(x + 1.0) / x;
    }
    let series = 1.0 / (12.0 * x) - 1.0 / (360.0 * x.powi(3)) + 1.0 / (1260.0 * x.powi(5))
        - 1.0 / (1680.0 * x.powi(7));
    (2.0 * PI / x).sqrt() * (x * x.ln() - x + series).exp()
}

/// bᵀ A⁻¹ b by elimination, with the regional matrix of a mesh that has an element of length 1e30
/// (s ≥ 1/2) or 1e60 on either side, where u vanishes: what lies beyond is below rounding.
fn by_definition(mesh: &Mesh, s: f64, load: &[f64]) -> Result<f64> {
    let far = if s < 0.5 { 1e60 } else { 1e30 };
    let wide = Mesh::from_lengths(&[&[far], mesh.lengths(), &[far]].concat())?;
    let regional = Gram::new(&wide, s, 1e-10)?.to_dense()?;
    let a = regional.view((2, 2), (load.len(), load.len()));
    let scale: Vec<f64> = (0..load.len()).map(|i| a[(i, i)].sqrt()).collect();
    let unit = a.map_with_location(|i, j, a| a / (scale[i] * scale[j]));
    let b = DVector::from_fn(load.len(), |i, _| load[i] / scale[i]);
    Ok(Cholesky::new(unit).map_or(f64::NAN, |factor| b.dot(&factor.solve(&b))))
}

/// One mesh of a curve.
struct Point {
    n: usize,
    seconds: f64,
    error: Measured,
    iterations: usize,
}

fn run(options: &Options, out: &mut Report) -> Result<()> {
    out.column("mesh", "mesh", "");
    out.column("error", "error", "|||u − u_h|||/|||u|||");
    out.column("steps", "iterations", "of preconditioned conjugate gradients");
    let mut curves: Vec<(String, Vec<Point>)> = Vec::new();
    for &s in &options.s {
        // |||u|||²
        let exact = PI.sqrt() * gamma(1.0 + s) / (gamma(1.5 + s) * gamma(1.0 + 2.0 * s));
        // C/2, with |Γ(−s)| = Γ(1 − s)/s
        let half = 0.5 * 4f64.powf(s) * gamma(s + 0.5) * s / (PI.sqrt() * gamma(1.0 - s));
        for mesh_name in ["uniform", "graded"] {
            let is_graded = mesh_name == "graded";
            let beta = if is_graded { 2.0 * (2.0 - s) } else { 1.0 };
            let mut points = Vec::new();
            for n in (2..=options.finest).map(|level| 4usize.pow(level)) {
                let mesh = two_sided(n, beta)?;
                // ∫ φᵢ / (C/2): A u = b with A the matrix of the double integral over R².
                let load: Vec<f64> =
                    mesh.lengths().windows(2).map(|h| 0.5 * (h[0] + h[1]) / half).collect();
                // Entries by closed forms and Gauss rules to rounding, products by FFT or
                // H²-matrices; conjugate gradients, preconditioned by a power of a tridiagonal
                // pencil. ± of the energy: what the last four steps gained, and the rounding of the
                // entries, 16 units each.
                let started = Instant::now();
                let (_, energy) = Gram::zero_outside(&mesh, s, 1e-13)?.solve(&load)?; // b·A⁻¹b
                let seconds = started.elapsed().as_secs_f64();
                let error = (-Measured::from(energy) * (half / exact) + 1.0).sqrt();
                // 1 − |||u_h|||²/|||u|||² has a ± of 1e-13 or more: it does not show less.
                if error.value < RESOLVED {
                    break;
                }
                let iterations = energy.work.iterations as usize;
                out.row(cells! { s, mesh: mesh_name, n => error, steps: iterations });
                points.push(Point { n, seconds, error, iterations });
                if n <= ELIMINATED {
                    let ratio = by_definition(&mesh, s, &load)? / energy.value;
                    let claim = out.check("energy: by_definition/library");
                    claim.differ_by_at_most(ratio, 1.0, 1e-9, "elimination");
                }
            }
            if let [.., before, last] = points.as_slice() {
                let growth = last.iterations as f64 - before.iterations as f64;
                let unconditioned = before.iterations as f64 * (4f64.powf(s) - 1.0);
                let claim = out
                    .check("CG iterations: increase from n/4 to n, largest n")
                    .undecided_if_also_true_of(unconditioned);
                claim.at_most(growth, 2.0, "bounded in n");
            }
            let (order, other, within) =
                if is_graded { (2.0 - s, 0.5, 0.08) } else { (0.5, 2.0 - s, 0.03) };
            let found = -out.exponent("n", "error");
            let claim =
                out.check(format!("s = {s}, {mesh_name}: order")).undecided_if_also_true_of(other);
            claim.whole_error_bars_differ_by_at_most(found, order, within, "regularity of u");
            curves.push((format!("s = {s}, {mesh_name}"), points));
        }
    }
    let title = "Errors in the energy norm";
    for (curve, points) in &curves {
        let over_n = points.iter().map(|point| (point.n as f64, point.error.value)).collect();
        let over_time = points.iter().map(|point| (point.seconds, point.error.value)).collect();
        out.plot("fractional_laplacian", title, Axes::LogLog("n", "error")).line(curve, over_n);
        out.plot("fractional_laplacian_seconds", title, Axes::LogLog("seconds", "error"))
            .line(curve, over_time);
    }
    Ok(())
}
