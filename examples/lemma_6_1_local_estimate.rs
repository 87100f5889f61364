//! Lemma 6.1: linear interpolation on one interval, with the constant 1. For u on an interval of
//! length h let I u be the straight line through its end points, and |u|_(1+ν) = |u'|_ν with |v|²_ν
//! = ∬ (v(x) − v(y))² / |x − y|^(1+2ν) dx dy over the interval, 0 < ν < 1. The lemma: ‖u − I u‖₀ ≤
//! h^(1+ν) |u|_(1+ν) and ‖u − I u‖₁ ≤ h^ν |u|_(1+ν).
//!
//! ‖u − I u‖₀ and |u − I u|₁ = ‖(u − I u)'‖₀ scale in h as their bounds do: best constants C₀, C₁
//! on (0, 1). The full norm ‖·‖₁² = ‖·‖₀² + |·|₁² does not; its best constant is at least h C₀: the
//! second line fails for h > 1/C₀, and holds for h ≤ h₁ = √(1 − C₁²)/C₀. Refuted if C₀ or C₁ is
//! above 1, or if the matrices of `by_definition` give others by 0.3 %. ν = 1e-300 stands for ν →
//! 0.
use example_report::prelude::*;
use fractional_sobolev::{Domain::Interval, ErrorNorm, Gram, Mesh, interpolation_constant};
use nalgebra::{DMatrix, DVector};

example! { quick "Lemma 6.1",
    "‖u − I u‖₀ ≤ h^(1+ν) |u|_(1+ν),  ‖u − I u‖₁ ≤ h^ν |u|_(1+ν)  on an interval of length h";
    /// orders ν
    nu: Vec<Order> = "1e-300,0.1,0.25,0.5,0.75,0.9,0.95" in "(0, 1)" slider "0.02 to 0.98",
}

/// C₀ and C₁ on 160 equal elements: √λ for the largest λ with Eᵀ M E v = λ A v, v the nodal values
/// of u', M and A the matrices of ‖·‖₀² and |·|²_ν (closed form), E those of v ↦ u − I u (there
/// linear between nodes) and v ↦ (u − I u)'.
fn by_definition(nu: Order) -> Result<[f64; 2]> {
    let (n, mesh) = (160, Mesh::uniform(160, 1.0)?);
    let [m, a] = [mass_matrix(&mesh), Gram::new(&mesh, nu, 1e-10)?.to_dense()?];
    // of φᵢ below xₖ
    let cells = |k: usize, i: usize| f64::from(u8::from(0 < i && i <= k) + u8::from(i < k));
    // ∫ φᵢ over (0, xₖ)
    let integral = DMatrix::from_fn(n + 1, n + 1, |k, i| 0.5 * cells(k, i) / n as f64);
    let rise = integral.row(n); // u(1) − u(0) = ∫ v, the slope of I u
    let value = &integral - DVector::from(mesh.nodes()) * rise;
    let slope = DMatrix::identity(n + 1, n + 1) - DVector::from_element(n + 1, 1.0) * rise;
    // u − I u does not see a constant in v: take the one with ∫ v = 0
    let a = a + rise.transpose() * rise;
    let largest = |e: DMatrix<f64>| largest_eigenvalue(&(e.transpose() * &m * &e), &a);
    Ok([largest(value)?.sqrt(), largest(slope)?.sqrt()])
}

fn run(options: &Options, out: &mut Report) -> Result<()> {
    for &nu in &options.nu {
        // The same eigenvalues, v a sum of odd Legendre polynomials; error: the change when their
        // number is doubled.
        let best = |h: f64, norm: ErrorNorm| interpolation_constant(Interval(h), norm, nu, 1e-10);
        let constants = [best(1.0, ErrorNorm::L2)?, best(1.0, ErrorNorm::Derivative)?];
        let ([best_0, best_1], [mesh_0, mesh_1]) =
            (constants.map(|best| Measured::from(best.constant)), by_definition(nu)?);
        let (c0, c1) = (best_0.value, best_1.value);
        // ‖u − I u‖₁² ≤ (h² C₀² + C₁²) h^(2ν) |u|²: the second line holds for h ≤ h₁
        let h1 = (1.0 - c1 * c1).sqrt() / c0;
        out.row(cells! { nu => mesh_0, best_0, mesh_1, best_1, h1 });
        out.check("first line: best constant C₀").at_most(best_0, 1.0, "Lemma 6.1");
        out.check("second line, seminorm: best constant C₁").at_most(best_1, 1.0, "Lemma 6.1");
        out.check("first line: by_definition/C₀").near(
            best_0.recip() * mesh_0,
            1.0,
            3e-3,
            "eigenproblem",
        );
        out.check("second line: by_definition/C₁").near(
            best_1.recip() * mesh_1,
            1.0,
            3e-3,
            "eigenproblem",
        );
        out.stronger("first line: max C₀ over ν").at_most(best_0, 0.16, "supremum as ν → 0");
        out.stronger("second line, seminorm: max C₁ over ν").at_most(
            best_1,
            0.51,
            "supremum as ν → 0",
        );
        let full = |h: f64| {
            best(h, ErrorNorm::H1).map(|best| Measured::from(best.constant) / h.powf(nu.value()))
        };
        out.check("second line, full norm, h = 0.99 h₁").at_most(
            full(0.99 * h1)?,
            1.0,
            "Lemma 6.1",
        );
        out.as_printed("second line, full norm, h = 1.01/C₀").at_most(
            full(1.01 / c0)?,
            1.0,
            "for h ≤ 5.4",
        );
    }
    let axes = Axes::Linear("ν", "constant");
    out.plot("lemma_6_1_local_estimate", "Best constants, 1 printed", axes)
        .curve("nu", "best_1")
        .curve("nu", "best_0");
    Ok(())
}
