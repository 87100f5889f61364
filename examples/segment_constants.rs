//! The sharp constants of one contact segment: how much of the factor 1/2 is lost on the worst
//! contact set.
//!
//! On a segment T = (0, 1) let E be the set where u_N = 0 and N the rest. A pressure σ vanishes on
//! N, a slope w = u_N' on E; |·|_ν is the seminorm ∬ (v(x) − v(y))² / |x − y|^(1+2ν) dx dy on T ×
//! T, its root, ν = τ − 3/2 in (0, 1). Then
//!
//! ```text
//! ‖σ‖_L1 ‖w‖_L1 ≤ K |σ|_ν |w|_ν for every E,      consistency term ≤ κ |σ|_ν |w|_ν for one gap N at an end, either cone,
//! term of the midpoint cone ≤ κ̄ |σ|_ν |w|_ν for every E;      with |x − y| ≤ 1 in the kernel alone the constant is 1/2.
//! ```
//!
//! The term is ∫ σ (I^h u_N) of (3.11), and −∫ (σ − π^h σ) u_N of (4.9) in the midpoint cone, π^h
//! the mean over T. For the gap N = (e, 1), w ≤ 0, it is ∫ x |σ| · ‖w‖_L1 (nodal) and ‖σ‖_L1 ∫ (1 −
//! x) |w| (midpoint): the same constants, with σ and w exchanged. For K an interval at an end is
//! the worst E: sorting |σ| and |w| raises neither seminorm.
//!
//! The best constants are K = max B(e) B(1−e), κ = max A(e) B(1−e); κ̄ = max B(e) D(1−e) is an
//! upper bound; the maxima over the length e of E, where B, A, D are the largest ∫ m w / |w|_ν of
//! functions w on (0, 1) that vanish on (e, 1), with m = 1, x, e − x. By potentials (|w|²_ν ≥ ∫ k
//! w² with k(x) = 2 ∫ |x − y|^(−1−2ν) dy over (e, 1), the pairs with y off the support), K ≤ c = ν
//! / (2 (4^ν − 1)). Where σ(x) ≠ 0, I^h u_N(x) = x ∫ w over (x, 1) − (1 − x) ∫ w over (0, x), ∫ u_N
//! = ∫ (1 − y) w over (x, 1) − ∫ y w over (0, x); only pairs with σ(y) = w(x) = 0 count, so for
//! every E and either cone term ≤ c₂ |σ|_ν |w|_ν, c₂ = ½ max x^(1+2ν) (1 − x) = ½ (1 +
//! 2ν)^(1+2ν)/(2 + 2ν)^(2+2ν) (page `segment_constants`). (On segments of length h all constants
//! have the factor h^(2ν+1) = h^(2τ−2).)
//!
//! Refuted if κ ≤ κ̄ ≤ K ≤ c or κ̄ ≤ c₂ fails, if a constant is off the bounds of the strong form
//! by more than 1e-8, or off the products of `moment_on_mesh` at the same e by more than 1 %.
//!
//! `cargo run --release --example segment_constants -- --nu 0.49,0.5,0.51`

use example_report::prelude::*;
use fractional_sobolev::{Gram, Mesh};
use nalgebra::DVector;
use signorini::proof::{consistency_constant, midpoint_bound, product_bound, product_constant};

example! { seconds "Sharp constants",
    "term of one segment ≤ κ h^(2τ−2) |σ_N|_ν |u_N'|_ν, κ far below 1/2";
    /// orders ν = τ − 3/2
    nu: Vec<Order> = "0.001,0.25,0.5,0.75,0.999" in "[0.001, 0.999]" slider "0.02 to 0.98",
}

/// The largest ∫ m w / |w|_ν from its definition: (bᵀ A⁻¹ b)^(1/2) over the continuous piecewise
/// linear w that vanish on (e, 1), A the seminorm's form of the hat functions of the nodes before
/// e, bᵢ = ∫ m φᵢ. Elements shrink by 0.7 towards 0, e, 1.
fn moment_on_mesh(nu: Order, e: f64, m: impl Fn(f64) -> f64) -> Result<f64> {
    let mesh = Mesh::graded(&[0.0, e, 1.0], 20, 0.7)?;
    let (x, free) = (mesh.nodes(), mesh.len() / 2); // the nodes 0 .. free − 1 lie before e
    let form = Gram::new(&mesh, nu, 1e-10)?.to_dense()?.view((0, 0), (free, free)).into_owned();
    // ∫ m φ_b over the element between the nodes a and b, m linear
    let over = |a: usize, b: usize| (x[b] - x[a]).abs() * (m(x[a]) + 2.0 * m(x[b])) / 6.0;
    let load =
        DVector::from_fn(free, |i, _| over(i + 1, i) + if i > 0 { over(i - 1, i) } else { 0.0 });
    let solution = form
        .cholesky()
        .ok_or_else(|| Error::Option("the matrix is not positive definite".to_owned()))?
        .solve(&load);
    Ok(load.dot(&solution).sqrt())
}

fn run(options: &Options, out: &mut Report) -> Result<()> {
    for &nu in &options.nu {
        // Moments: functions whose slopes are polynomials on graded cells, a linear system; ±: the
        // change between two such spaces, of both factors. The maximum over e in (0, 1) by golden
        // section, at `found.contact`.
        let found = [
            product_constant(nu, 1e-9)?,
            consistency_constant(nu, 1e-9)?,
            midpoint_bound(nu, 1e-9)?,
        ];
        let [product, kappa, midpoint] = found.map(|found| Measured::from(found.value));
        let (c, e, one) = (product_bound(nu), found.map(|found| found.contact), |_: f64| 1.0);
        let power = 1.0 + 2.0 * nu.value();
        let pairs = 0.5 * power.powf(power) / (1.0 + power).powf(1.0 + power);
        let definition = [
            moment_on_mesh(nu, e[0], one)? * moment_on_mesh(nu, 1.0 - e[0], one)?,
            moment_on_mesh(nu, e[1], |x| x)? * moment_on_mesh(nu, 1.0 - e[1], one)?,
            moment_on_mesh(nu, e[2], one)? * moment_on_mesh(nu, 1.0 - e[2], |x| 1.0 - e[2] - x)?,
        ];
        for (found, definition) in found.iter().zip(definition) {
            let value = Measured::from(found.value);
            // Strong form: (A v, w) = (v, w)_ν, and for every v, with r = m − A v, the moment M has
            // ∫ (m + r) v ≤ M² ≤ ∫ (m + r) v + ∫ r²/k; v, a polynomial on each graded cell, by
            // least squares of r.
            let [low, high] = found.bounds()?;
            let ratio = value / Measured::new(0.5 * (low + high), 0.5 * (high - low));
            let claim = out.check("ratio of K, κ, κ̄ to strong-form bounds");
            claim.near(ratio, 1.0, 1e-8, "residual bounds");
            let quotient = value.recip() * definition;
            out.check("K, κ, κ̄ on a mesh/library value").near(quotient, 1.0, 0.01, "hat functions");
        }
        out.check("κ/κ̄").at_most(kappa / midpoint, 1.0, "special case: one gap");
        out.check("κ̄/K").at_most(midpoint / product, 1.0, "product of L¹ norms");
        out.check("K/c").at_most(product / c, 1.0, "bound by potentials");
        out.check("κ̄/c₂").at_most(midpoint / pairs, 1.0, "bound by pairs of points");
        out.stronger("max κ over ν").at_most(kappa, 0.07, "maximum as ν → 0");
        // As ν → 1 |w|²_ν ≈ ‖w'‖²/(1 − ν), so B(e)² ≈ (1 − ν) e³/3 and K ≈ (1 − ν)/24, at e = 1/2.
        let left = 0.5 - nu.offset(); // 1 − ν
        let quotient = (product * (24.0 / left) - 1.0) / left;
        out.observe("(24 K/(1−ν) − 1)/(1−ν)").at_most(quotient, 4.0, "K/(1−ν) → 1/24");
        out.row(
            cells! { nu => c, pairs, product, by_definition: definition[0], kappa, midpoint: midpoint.value },
        );
    }
    out.proof("‖σ‖_L1 ‖w‖_L1 ≤ c |σ|_ν |w|_ν for every E", "segment_constants");
    for (name, title, meaning) in [
        ("c", "c", "by potentials"),
        ("pairs", "c₂", "by pairs"),
        ("product", "K", "product of L1 norms, every E"),
        ("by_definition", "on a mesh", "K by `moment_on_mesh`"),
        ("kappa", "κ", "term, one gap"),
        ("midpoint", "κ̄", "midpoint cone, every E"),
    ] {
        out.column(name, title, meaning);
    }
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
