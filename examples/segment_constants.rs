//! The sharp constants of one contact segment: how much of the factor 1/2 is lost on the worst
//! contact set.
//!
//! Let T = (0, 1) be a segment, E the set where u_N = 0, and N the rest of T. The pressure σ
//! vanishes on N, the slope w = u_N' on E. With ν = τ − 3/2 in (0, 1), |v|²_ν = ∬
//! (v(x) − v(y))² / |x − y|^(1+2ν) dx dy over T × T, and π^h the mean over T, the term that the
//! proofs bound is
//!
//! ```text
//! ∫ σ I^h u_N   (3.11), nodal cone,        −∫ (σ − π^h σ) u_N   (4.9), midpoint cone.
//! ```
//!
//! This file computes three best constants. The first and the third hold for every E, the second
//! for one gap N at an end of T, in either cone:
//!
//! ```text
//! ‖σ‖_L1 ‖w‖_L1 ≤ K |σ|_ν |w|_ν,        term ≤ κ |σ|_ν |w|_ν,        (4.9) ≤ κ̄ |σ|_ν |w|_ν.
//! ```
//!
//! The bound |x − y| ≤ 1 in the kernel alone gives 1/2 for all of them. On a segment of length h
//! all have the factor h^(2ν+1) = h^(2τ−2).
//!
//! For the gap N = (e, 1) and w ≤ 0 the term is ∫ x |σ| · ‖w‖_L1 (nodal) or ‖σ‖_L1 ∫ (1 − x) |w|
//! (midpoint): the same constants with σ and w exchanged. For K an interval at an end is the worst
//! E, because sorting |σ| and |w| raises neither seminorm. So with the largest moments
//!
//! ```text
//! B(e), A(e), D(e) = max ∫ m w / |w|_ν over w = 0 on (e, 1),     m(x) = 1, x, e − x,
//! K = max_e B(e) B(1−e),     κ = max_e A(e) B(1−e),     κ̄ ≤ max_e B(e) D(1−e);
//! ```
//!
//! κ̄ stands for this bound: (4.9) is ‖σ‖_L1 |∫ u_N|, and ∫ u_N the integral of w times its
//! distance to the end of its gap, at most e − x after |w| is sorted to decrease on an interval of
//! the length of N, which raises no seminorm. Two bounds without a maximum are proved on the page
//! `segment_constants`:
//!
//! ```text
//! K ≤ c = ν / (2 (4^ν − 1)):       |w|²_ν ≥ ∫ k w², k(x) = 2 ∫ |x − y|^(−1−2ν) dy over (e, 1);
//! κ̄ ≤ c₂ = ½ max_x x^(1+2ν) (1 − x) = ½ (1 + 2ν)^(1+2ν)/(2 + 2ν)^(2+2ν) ≤ 1/8,
//! ```
//!
//! the second for every E and either cone: where σ(x) ≠ 0, I^h u_N(x) and ∫ u_N are integrals of w
//! against kernels, and only pairs of points with σ(y) = w(x) = 0 count.
//!
//! Refuted if κ ≤ κ̄ ≤ K ≤ c or κ̄ ≤ c₂ fails, if a constant is off the bounds of the strong form
//! by more than 1e-8, or off the maximum of `scan` by more than 1 %. The factor 1/2 is loose if κ ≤
//! 1/8. Shown, and decided by nothing: (24 K/(1−ν) − 1)/(1−ν) ≤ 4. Undecided while a bound lies
//! inside of an error bar.
//!
//! `cargo run --release --example segment_constants -- --nu 0.49,0.5,0.51`

use example_report::prelude::*;
use fractional_sobolev::{Gram, Mesh};
use nalgebra::{Cholesky, DVector};
use signorini::proof::{consistency_constant, midpoint_bound, product_bound, product_constant};

example! { seconds "Sharp constants",
    "term of one segment ≤ c₂ h^(2τ−2) |σ_N|_ν |u_N'|_ν, c₂ ≤ 1/8; with one gap at an end κ ≤ c₂";
    /// orders ν = τ − 3/2
    nu: Vec<Order> = "0.001,0.25,0.5,0.75,0.999" in "[0.001, 0.999]" slider "0.02 to 0.98",
}

/// The largest moments ∫ m w / |w|_ν of functions w that vanish on (e, 1).
struct Moments {
    b: f64,
    a: f64,
    d: f64,
}

/// The moments from their definition: (ℓ·G⁻¹ℓ)^(1/2) over the continuous piecewise linear w that
/// vanish on (e, 1), G the matrix of |·|²_ν for the hat functions φᵢ of the nodes before e, and
/// ℓᵢ = ∫ m φᵢ. The elements shrink by 0.7 towards 0, towards e from both sides, and towards 1.
fn moments(nu: Order, e: f64) -> Result<Moments> {
    let mesh = Mesh::graded(&[0.0, e, 1.0], 20, 0.7)?;
    let (x, free) = (mesh.nodes(), mesh.len() / 2); // the nodes 0 .. free − 1 lie before e
    let form = Gram::new(&mesh, nu, 1e-10)?.to_dense()?.view((0, 0), (free, free)).into_owned();
    let failed = || Error::Option("the matrix is not positive definite".to_owned());
    let factor = Cholesky::new(form).ok_or_else(failed)?;
    let largest = |m: &dyn Fn(f64) -> f64| {
        // ∫ m φ_j over the element between the nodes i and j, m linear
        let over = |i: usize, j: usize| (x[j] - x[i]).abs() * (m(x[i]) + 2.0 * m(x[j])) / 6.0;
        let load = DVector::from_fn(free, |i, _| {
            over(i + 1, i) + if i > 0 { over(i - 1, i) } else { 0.0 }
        });
        load.dot(&factor.solve(&load)).sqrt()
    };
    Ok(Moments { b: largest(&|_| 1.0), a: largest(&|x| x), d: largest(&|x| e - x) })
}

/// Best constants of a segment.
struct Constants {
    k: f64,
    kappa: f64,
    kappa_bar: f64,
}

/// The maxima over e = 1/40, 2/40, .. 39/40.
fn scan(nu: Order) -> Result<Constants> {
    let lengths = 1..40usize;
    let all = lengths.map(|k| moments(nu, k as f64 / 40.0)).collect::<Result<Vec<Moments>>>()?;
    let pairs = || all.iter().zip(all.iter().rev()); // of e and 1 − e
    Ok(Constants {
        k: pairs().map(|(at, rest)| at.b * rest.b).fold(0.0, f64::max),
        kappa: pairs().map(|(at, rest)| at.a * rest.b).fold(0.0, f64::max),
        kappa_bar: pairs().map(|(at, rest)| at.b * rest.d).fold(0.0, f64::max),
    })
}

fn run(options: &Options, out: &mut Report) -> Result<()> {
    for &nu in &options.nu {
        // The same maxima by golden section in e; the moments from a linear system for functions
        // whose slopes are polynomials on graded cells; ±: the change between two such spaces.
        let product = product_constant(nu, 1e-9)?.best;
        let one_gap = consistency_constant(nu, 1e-9)?.best;
        let every = midpoint_bound(nu, 1e-9)?.best;
        let scanned = scan(nu)?;
        for (found, on_mesh) in
            [(&product, scanned.k), (&one_gap, scanned.kappa), (&every, scanned.kappa_bar)]
        {
            let value = Measured::from(found.constant);
            // Strong form: let (A v, w) = (v, w)_ν. For every v, with r = m − A v, the moment M has
            // ∫ (m + r) v ≤ M² ≤ ∫ (m + r) v + ∫ r²/k; v, a polynomial on each graded cell, by
            // least squares of r.
            let bounds = found.bounded()?;
            let high = bounds.upper.map_or(f64::NAN, |upper| upper.value);
            let low = bounds.lower.value;
            let ratio = value / Measured::new(0.5 * (low + high), 0.5 * (high - low));
            let claim = out.check("ratio of K, κ, κ̄ to strong-form bounds");
            claim.whole_error_bars_differ_by_at_most(ratio, 1.0, 1e-8, "residual bounds");
            let claim = out.check("K, κ, κ̄ on a mesh/library value");
            claim.whole_error_bars_differ_by_at_most(
                value.recip() * on_mesh,
                1.0,
                0.01,
                "hat functions",
            );
        }

        let [k, kappa, kappa_bar] =
            [&product, &one_gap, &every].map(|found| Measured::from(found.constant));
        let c = product_bound(nu);
        let power = 1.0 + 2.0 * nu.value();
        let c_2 = 0.5 * power.powf(power) / (1.0 + power).powf(1.0 + power);
        out.check("κ/κ̄").whole_error_bars_at_most(kappa / kappa_bar, 1.0, "special case: one gap");
        out.check("κ̄/K").whole_error_bars_at_most(kappa_bar / k, 1.0, "product of L¹ norms");
        out.check("K/c").whole_error_bars_at_most(k / c, 1.0, "bound by potentials");
        let claim = out.check("κ̄/c₂");
        claim.whole_error_bars_at_most(kappa_bar / c_2, 1.0, "bound by pairs of points");
        out.stronger("max κ over ν").whole_error_bars_at_most(kappa, 0.125, "c₂ ≤ 1/8");
        // As ν → 1 |w|²_ν ≈ ‖w'‖²/(1 − ν), so B(e)² ≈ (1 − ν) e³/3 and K ≈ (1 − ν)/24, at e = 1/2.
        let left = 0.5 - nu.offset(); // 1 − ν
        let quotient = (k * (24.0 / left) - 1.0) / left;
        let claim = out.observe("(24 K/(1−ν) − 1)/(1−ν)");
        claim.whole_error_bars_at_most(quotient, 4.0, "K/(1−ν) → 1/24");
        out.row(cells! { nu => c, pairs: c_2, product: k, by_definition: scanned.k,
        kappa, midpoint: kappa_bar.value });
    }
    out.proof("‖σ‖_L1 ‖w‖_L1 ≤ c |σ|_ν |w|_ν for every E", "segment_constants");
    out.column("c", "c", "bound of K by potentials");
    out.column("pairs", "c₂", "bound of κ̄ by pairs of points");
    out.column("product", "K", "product of L¹ norms, every E");
    out.column("by_definition", "on a mesh", "K by `scan`");
    out.column("kappa", "κ", "term, one gap");
    out.column("midpoint", "κ̄", "midpoint cone, every E");
    let half = options.nu.iter().map(|nu| (nu.value(), 0.5)).collect();
    let axes = Axes::Linear("ν = τ − 3/2", "constant");
    out.plot("segment_constants", "Bounds of the term of one segment", axes)
        .dashed_line("1/2", half)
        .curve("nu", "c")
        .curve("nu", "pairs")
        .curve("nu", "product")
        .curve("nu", "midpoint")
        .curve("nu", "kappa");
    Ok(())
}
