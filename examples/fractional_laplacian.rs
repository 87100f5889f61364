//! The integral fractional Laplacian on an interval, by piecewise linears on uniform and on graded
//! meshes.
//!
//! For 0 < s < 1 let (−Δ)^s u(x) = C PV∫ (u(x) − u(y)) / |x − y|^(1+2s) dy over the whole line,
//! with C = 4^s Γ(s + 1/2) / (√π |Γ(−s)|), and u the solution of (−Δ)^s u = 1 on (−1, 1), u = 0
//! outside: u = (1 − x²)^s / Γ(1 + 2s). Its energy is C/2 ∬ (u(x) − u(y))² / |x − y|^(1+2s) dx dy
//! over R² = ∫ u = √π Γ(1 + s) / (Γ(3/2 + s) Γ(1 + 2s)). Galerkin solutions u_h are orthogonal to
//! their error, so that the square of the energy norm of u − u_h is the difference of the energies.
//!
//! u grows like the power s of the distance to an end: the order in the number n of elements is 1/2
//! on uniform meshes and 2 − s on meshes with the nodes (2i/n)^β from each end, β = 2 (2 − s)
//! (Acosta & Borthagaray 2017 for the first; the second is that of interpolation). Refuted if an
//! order is off by 0.03 (0.08 on graded meshes, where both ends add a logarithm), if a solution
//! takes more than 25 iterations, or if `by_definition` gives another energy by 1e-9.

use example_report::prelude::*;
use fractional_sobolev::{Gram, Mesh, closed_forms::fractional_laplacian_constant};
use nalgebra::{Cholesky, DVector};
use std::f64::consts::PI;
use std::time::Instant;

example! { seconds "Fractional Laplacian",
    "(−Δ)^s u = 1 on (−1, 1):  ‖u − u_h‖ ≤ C n^(−1/2) on uniform, C n^(s−2) on graded meshes";
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

fn run(options: &Options, out: &mut Report) -> Result<()> {
    out.column("error", "error", "√(energy of u − energy of u_h) over the root of the energy of u");
    out.column(
        "steps",
        "iterations",
        "of conjugate gradients, preconditioned by a power of a tridiagonal pencil",
    );
    let mut curves = Vec::new();
    for &s in &options.s {
        let exact = PI.sqrt() * gamma(1.0 + s) / (gamma(1.5 + s) * gamma(1.0 + 2.0 * s));
        let half = 0.5 * fractional_laplacian_constant(s)?.value;
        for (mesh_name, beta, order, within) in
            [("uniform", 1.0, 0.5, 0.03), ("graded", 2.0 * (2.0 - s), 2.0 - s, 0.08)]
        {
            let mut measured = Vec::new();
            for n in (2..=options.finest).map(|level| 4usize.pow(level)) {
                let mesh = two_sided(n, beta)?;
                // ∫ φ_i / (C/2): A u = b with A of the double integral over the line.
                let load: Vec<f64> =
                    mesh.lengths().windows(2).map(|h| 0.5 * (h[0] + h[1]) / half).collect();
                let started = Instant::now();
                // Entries by closed forms and Gauss rules to rounding, products by FFT or
                // H²-matrices.
                let (_, energy) = Gram::zero_outside(&mesh, s, 1e-13)?.solve(&load)?;
                let seconds = started.elapsed().as_secs_f64();
                let (error, steps) =
                    ((1.0 - half * energy.value / exact).sqrt(), energy.work.iterations as usize);
                // The difference of two energies, each to 1e-13, does not show less.
                if error < RESOLVED {
                    break;
                }
                out.row(cells! { s, mesh: mesh_name, n => error, steps });
                measured.push(([n as f64, seconds], error));
                out.check("CG iterations").at_most(steps, 25, "uniform in n");
                if n <= ELIMINATED {
                    let definition = by_definition(&mesh, s, &load)?;
                    let claim = out.check("energy: by_definition/library");
                    claim.near(definition / energy.value, 1.0, 1e-9, "elimination");
                }
            }
            let found = out.exponent("n", "error") * -1.0;
            let claim = out.check(format!("s = {s}, {mesh_name}: order"));
            claim.near(found, order, within, "regularity of u");
            curves.push((format!("s = {s}, {mesh_name}"), measured));
        }
    }
    for (k, name, title) in
        [(0, "fractional_laplacian", "n"), (1, "fractional_laplacian_seconds", "seconds")]
    {
        let plot = out.plot(name, "Errors in the energy norm", Axes::LogLog(title, "error"));
        for (curve, points) in &curves {
            plot.line(curve, points.iter().map(|&(x, error)| (x[k], error)).collect());
        }
    }
    Ok(())
}
