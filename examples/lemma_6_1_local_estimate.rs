//! Lemma 6.1: linear interpolation on one interval, with the constant 1.
//!
//! For u on an interval of length h let I u be the straight line through its end points, and
//! |u|²_(1+ν) = |u'|²_ν = ∬ (u'(x) − u'(y))² / |x − y|^(1+2ν) dx dy over the interval, 0 < ν < 1. The lemma says
//!
//! ```text
//! ‖u − I u‖₀ ≤ h^(1+ν) |u|_(1+ν),        ‖u − I u‖₁ ≤ h^ν |u|_(1+ν).
//! ```
//!
//! ‖u − I u‖₀ and |u − I u|₁ = ‖(u − I u)'‖₀ scale in h as their bounds do: their best constants C₀(ν), C₁(ν) are
//! computed on (0, 1). The full norm ‖·‖₁² = ‖·‖₀² + |·|₁² does not: its best constant C(ν, h) lies between h C₀ and
//! (C₁² + h² C₀²)^(1/2), so the second line holds for h ≤ h₁ = (1 − C₁²)^(1/2) / C₀ and fails for h ≥ h₂ = 1 / C₀.
//!
//! Refuted if C₀, C₁ or C(ν, 0.99 h₁) is above 1, if a random function passes C₀ or C₁, or if the matrices of the definition
//! give other values of C₀ and C₁, by 0.3 %. ν = 1e-300 stands for ν → 0, where the constants are largest.
//!
//! `cargo run --release --example lemma_6_1_local_estimate -- --nu 0.05,0.5,0.95`

use example_report::prelude::*;
use fractional_sobolev::{Domain::Interval, ErrorNorm, Gram, Mesh, gauss_legendre, interpolation_constant};
use nalgebra::{DMatrix, DVector};

example! { quick "Lemma 6.1", "‖u − I u‖₀ ≤ h^(1+ν) |u|_(1+ν),  ‖u − I u‖₁ ≤ h^ν |u|_(1+ν)  on an interval of length h";
    /// orders ν
    nu: Vec<Order> = "1e-300,0.1,0.25,0.5,0.75,0.9,0.95" in "(0, 1)" slider "0.02 to 0.98",
    /// random functions for each order
    functions: usize = "200" in "[1, 100000]",
}

/// D₀ and D₁, for slopes u' = v that are linear on each element, given by nodal values: (D₀ v)ⱼ = √wⱼ (u − I u)(xⱼ) and
/// (D₁ v)ⱼ = √wⱼ (u − I u)'(xⱼ), three Gauss points xⱼ on each element. So ‖D₀ v‖ = ‖u − I u‖₀, ‖D₁ v‖ = |u − I u|₁.
fn interpolation_error(mesh: &Mesh) -> Result<[DMatrix<f64>; 2]> {
    let (x, h, n, rule) = (mesh.nodes(), mesh.lengths(), mesh.len(), gauss_legendre(3)?);
    let [mut d0, mut d1] = [(); 2].map(|()| DMatrix::zeros(3 * n, n + 1));
    for node in 0..=n {
        let v = DVector::from_fn(n + 1, |k, _| f64::from(k == node)); // the hat function of this node
        let mut u = vec![0.0]; // u(x) = ∫ v over (0, x), at the nodes; (I u)(x) = u(1) x
        (0..n).for_each(|k| u.push(u[k] + h[k] * (v[k] + v[k + 1]) / 2.0));
        for k in 0..n {
            for (j, (t, w)) in (3 * k..).zip(rule.iter()) {
                let slope = v[k] + t * (v[k + 1] - v[k]);
                let value = u[k] + h[k] * t * (v[k] + slope) / 2.0;
                d0[(j, node)] = (w * h[k]).sqrt() * (value - u[n] * (x[k] + t * h[k]));
                d1[(j, node)] = (w * h[k]).sqrt() * (slope - u[n]);
            }
        }
    }
    Ok([d0, d1])
}

/// Best constant on (0, h): v a sum of odd Legendre polynomials, largest eigenvalue; error: change when doubled.
fn best(h: f64, norm: ErrorNorm, nu: Order) -> Result<Measured> {
    Ok(Measured::from(interpolation_constant(Interval(h), norm, nu, 1e-10)?.constant) / h.powf(nu.value()))
}

fn run(options: &Options, out: &mut Report) -> Result<()> {
    let mesh = Mesh::graded(&[0.0, 1.0], 40, 0.8)?; // elements shorter by a factor 0.8 towards both ends
    let (x, n) = (mesh.nodes(), mesh.len());
    let d = interpolation_error(&mesh)?.map(|d| d.remove_column(n)); // v(1) = 0: a constant in v changes nothing
    let mut state = 1u64; // of Knuth's linear congruential generator
    let mut random = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 * 2f64.powi(-53) // in (0, 1)
    };
    for &nu in &options.nu {
        let a = Gram::new(&mesh, nu, 1e-10)?.to_dense()?.remove_row(n).remove_column(n); // |v|²_ν = vᵀ A v, closed forms
        let mut tried = [0.0f64; 2];
        for _ in 0..options.functions {
            // A line with noise, times a power between ν − 1/2 and 1 of the distance to the nearer end.
            let (size, power) = (10f64.powf(-3.0 * random()), nu.offset() + (1.0 - nu.offset()) * random());
            let mut noise = |x: f64| size * (random() - 0.5) * x.powf(power);
            let v = DVector::from_fn(n, |k, _| 1.0 - x[k] + noise(x[k].min(1.0 - x[k]).max(x[1])));
            tried = [0, 1].map(|k| tried[k].max((&d[k] * &v).norm() / v.dot(&(&a * &v)).sqrt()));
        }
        let constants = [best(1.0, ErrorNorm::L2, nu)?, best(1.0, ErrorNorm::Derivative, nu)?];
        let mut on_mesh = [0.0; 2];
        for (k, claim) in ["first line", "second line, seminorm"].into_iter().enumerate() {
            on_mesh[k] = largest_eigenvalue(&(d[k].transpose() * &d[k]), &a)?.sqrt(); // of all v on the mesh
            let [tried, on_mesh] = [tried[k], on_mesh[k]].map(|quotient| constants[k].recip() * quotient);
            out.check(claim).at_most(constants[k], 1.0, "printed");
            out.check("random functions, over C").at_most(tried, 1.0, "C₀, C₁");
            out.check("from the definition, over C").near(on_mesh, 1.0, 3e-3, "D₀, D₁, A");
            let smaller = [0.16, 0.51][k];
            out.stronger(format!("{claim}, constant {smaller}")).at_most(constants[k], smaller, "ν → 0");
        }
        let [c0, c1] = constants.map(|c| c.value);
        let (h1, h2) = ((1.0 - c1 * c1).sqrt() / c0, 1.0 / c0);
        let [short, long] = [best(0.99 * h1, ErrorNorm::H1, nu)?, best(1.01 * h2, ErrorNorm::H1, nu)?];
        out.check("second line, full norm, h = 0.99 h₁").at_most(short, 1.0, "printed");
        out.as_printed("second line, full norm, h = 1.01 h₂").at_most(long, 1.0, "for h ≤ 5.4");
        out.row(cells! { nu => tried_0: tried[0], mesh_0: on_mesh[0], best_0: constants[0],
        tried_1: tried[1], mesh_1: on_mesh[1], best_1: constants[1], h1 });
    }
    out.column("tried_0", "tried C₀", "largest quotient of the random functions");
    out.column("mesh_0", "mesh C₀", "of all piecewise linear slopes on the mesh");
    out.column("h1", "h₁", "the second line holds for h ≤ h₁ and fails for h ≥ h₂ = 1/C₀");
    let others = [("best_0", "C₀"), ("tried_1", "tried C₁"), ("mesh_1", "mesh C₁"), ("best_1", "C₁")];
    others.into_iter().for_each(|(name, title)| out.column(name, title, ""));
    let axes = Axes::Linear("ν, order", "constant");
    out.plot("lemma_6_1_local_estimate", "Lemma 6.1: the constant 1 and the best ones", axes)
        .dashed_line("printed: 1", options.nu.iter().map(|nu| (nu.value(), 1.0)).collect())
        .curve("nu", "best_1")
        .points("nu", "tried_1")
        .curve("nu", "best_0")
        .points("nu", "tried_0");
    Ok(())
}
