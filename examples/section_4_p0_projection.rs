//! (4.6), (4.7) and Remark 4: the projection on piecewise constants, in L² and in the dual norm of
//! H^(1/2), and its limit.
//!
//! Let π^h φ be the mean of φ on each of N = 1/h equal elements of (0, 1), and
//!
//! ```text
//! |φ|²_r = ∬ (φ(x) − φ(y))² / |x − y|^(1+2r) dx dy for 0 < r < 1,        |φ|₁ = ‖φ'‖₀,
//! ‖f‖_(1/2,*) = max ∫ f ψ over ‖ψ‖₀² + |ψ|²_(1/2) = 1.
//! ```
//!
//! The paper uses the first two; the third says what its Remark 4 means:
//!
//! ```text
//! ‖φ − π^h φ‖₀ ≤ C h^r |φ|_r                   (4.6),     for r ≤ 1,
//! ‖φ − π^h φ‖_(1/2,*) ≤ C h^(r+1/2) |φ|_r       (4.7),     for r ≤ 1,
//! ‖φ − π^h φ‖₀ = h ‖φ'‖₀ / √12 (1 + o(1))      Remark 4,  for φ in H¹
//! ```
//!
//! There is no better order for smoother φ, because φ − π^h φ is φ' times the distance from the
//! centre of the element, to first order.
//!
//! This file computes the best constants of one element, C(r) of (4.6) and C*(r) of
//!
//! ```text
//! ∫ (φ − π^h φ)(ψ − π^h ψ) ≤ C* h^(r+1/2) |φ|_r |ψ|_(1/2),        C*(r) ≤ C(r) C(1/2),
//! ```
//!
//! and the largest quotients S(N) of (4.6) and (4.7) over all φ on N elements. Their order p
//! follows from three meshes and S(N)^(−2) = A N^(2p) − B, where B is what the pairs of points
//! outside (0, 1) would add to |φ|²_r. For r > 1 it takes φ = x^a, a = r − 0.495, which is barely
//! in H^r; its next term is smaller by h^q, q = 2a − 1.
//!
//! Refuted if S(N) h^(−r) or S(N) h^(−r−1/2) is above its constant, C* is above C(r) C(1/2) by more
//! than 1e-7 of it, √λ on one element of 64 cells is off C(r) or C*(r) by 1e-3, or an order of S(N)
//! with its ± is off r or r + 1/2 by 0.05, that of x^a off 1 by 0.02 + 4096^(−q), or its error off
//! h ‖φ'‖₀/√12 by the part h^min(q, 1). That C*(r) is at least 0.99 C(r) C(1/2) is observed only,
//! and refutes nothing. Undecided while a bound lies inside of an error bar; for r > 1 also if the
//! tolerance 0.02 + 4096^(−q) of the order is so wide that the order r would pass as well.
//!
//! Other orders, up to 1 and above:
//!
//! `cargo run --release --example section_4_p0_projection -- --r 0.25 --beyond 1.75`

use example_report::prelude::*;
use fractional_sobolev::{Domain, ErrorNorm, Gram, Mesh, gauss_legendre, projection_constant};
use nalgebra::DMatrix;

example! { seconds "(4.6), (4.7)",
    "‖φ − π^h φ‖₀ ≤ C h^r |φ|_r,  ‖φ − π^h φ‖_(1/2,*) ≤ C h^(r+1/2) |φ|_r,  r ≤ 1 only";
    /// orders r up to 1
    r: Vec<f64> = "0.1,0.2,0.3,0.4,0.5,0.6,0.7,0.8,0.9,1" in "[0.05, 1]" slider "0.1 to 1",
    /// orders r above 1
    beyond: Vec<f64> = "1.25,1.5,2,2.5,4" in "[1.01, 10]" slider "1.1 to 3",
}

/// Largest quotients over all φ.
struct Suprema {
    /// S(N) of ‖φ − π^h φ‖₀/|φ|_r.
    l2: f64,
    /// S(N) of ‖φ − π^h φ‖_(1/2,*)/|φ|_r.
    dual: f64,
    /// C*(r), if there is one element.
    element: f64,
}

/// The suprema over φ that are linear on each of some cells per element, from their nodal values:
/// √λ for the largest λ with Q φ = λ A φ, where φᵀ A φ = |φ|²_r. Let φᵀ M φ = ‖φ‖₀², φᵀ R φ =
/// ‖φ − π^h φ‖₀² and ψᵀ H ψ = |ψ|²_(1/2). Since ∫ (φ − π^h φ) ψ = φᵀ R ψ,
///
/// ```text
/// Q = R for `l2`,        Q = R (M + H)⁻¹ R for `dual`,        Q = R H⁻¹ R for `element`.
/// ```
fn suprema(r: f64, elements: usize, cells: usize) -> Result<Suprema> {
    let n = elements * cells;
    let (mesh, c) = (Mesh::uniform(n, 1.0)?, 1.0 / n as f64);
    let mass = mass_matrix(&mesh);
    // R: ∫ φ² less, on each element, (∫ φ)² over its length
    let mut rest = mass.clone();
    for first in (0..n).step_by(cells) {
        // ∫ φ over the element, over c
        let weight = |k: usize| if k == first || k == first + cells { 0.5 } else { 1.0 };
        for i in first..=first + cells {
            for j in first..=first + cells {
                rest[(i, j)] -= weight(i) * weight(j) * c / cells as f64;
            }
        }
    }
    let seminorm = |r: f64| -> Result<DMatrix<f64>> {
        if r < 1.0 {
            // closed forms for every pair of hat functions
            return Ok(Gram::new(&mesh, r, 1e-10)?.to_dense()?);
        }
        Ok(DMatrix::from_fn(n + 1, n + 1, |i, j| match i.abs_diff(j) {
            0 if i == 0 || i == n => 1.0 / c,
            0 => 2.0 / c,
            1 => -1.0 / c,
            _ => 0.0,
        }))
    };
    // φ(1) = 0: constants change nothing
    let free = |matrix: DMatrix<f64>| matrix.remove_row(n).remove_column(n);
    let inverse = |h: DMatrix<f64>, rest: &DMatrix<f64>| match h.cholesky() {
        Some(h) => Ok(rest * h.solve(rest)),
        None => Err(Error::Option("the form is not positive definite".to_owned())),
    };
    let half = seminorm(0.5)?;
    let dual = free(inverse(&mass + &half, &rest)?);
    let rest = free(rest);
    let (element, a) = (inverse(free(half), &rest)?, free(seminorm(r)?));
    let largest = |q: &DMatrix<f64>| -> Result<f64> { Ok(largest_eigenvalue(q, &a)?.sqrt()) };
    Ok(Suprema { l2: largest(&rest)?, dual: largest(&dual)?, element: largest(&element)? })
}

/// The order p of S(N) with S^−2 = A N^(2p) − B, from N, 2N and 4N elements. For (4.7), `half` is
/// 1/2 and p − 1/2 is fitted to S N^(1/2); for (4.6), `half` is 0.
fn order(s: &[f64], half: f64) -> f64 {
    let square = |k: usize| (s[k] * 2f64.powf(k as f64 * half)).powi(-2);
    half - 0.5 * order_of_increments([square(0), square(1), square(2)])
}

/// ‖φ − π^h φ‖₀ for φ = x^a on n equal elements: closed form on the first, six Gauss points on each
/// other.
fn error_of_power(a: f64, n: usize) -> Result<f64> {
    let (h, rule) = (1.0 / n as f64, gauss_legendre(6)?);
    let mut square = h.powf(2.0 * a + 1.0) * (1.0 / (2.0 * a + 1.0) - 1.0 / (a + 1.0).powi(2));
    for k in 1..n {
        let (x, y) = (k as f64 * h, 1.0 / k as f64);
        // (x (1 + s))^power − x^power
        let rise = |s: f64, power: f64| x.powf(power) * (power * s.ln_1p()).exp_m1();
        let mean = rise(y, a + 1.0) / ((a + 1.0) * h) - x.powf(a); // of φ − φ(x)
        square += h * rule.integrate(|t| (rise(t * y, a) - mean).powi(2));
    }
    Ok(square.sqrt())
}

fn run(options: &Options, out: &mut Report) -> Result<()> {
    out.column("c", "C(r)", "best constant of (4.6) on one element");
    out.column("one", "on cells", "the same from `suprema`");
    out.column("order", "order", "of S(N), N = 16, 32, 64; r > 1: of ‖x^a − π^h x^a‖₀");
    out.column("c_dual", "C*(r)", "best constant of (4.7)");
    out.column("order_dual", "order", "in the dual norm");
    out.column("limit", "/ limit", "‖x^a − π^h x^a‖₀ over h ‖φ'‖₀/√12, 65536 elements");
    // The library takes Legendre polynomials for φ and ψ in Q φ = λ A φ; ±: change if the degree is
    // doubled.
    let constant = |norm, r: f64| -> Result<Measured> {
        Ok(projection_constant(Domain::Interval(1.0), norm, r, 1e-8)?.constant.into())
    };
    let half = constant(ErrorNorm::L2, 0.5)?;
    for &r in &options.r {
        // S(N) for N = 8, 16, 32, 64, with four and with two cells per element
        let series = |cells: usize| -> Result<Vec<Suprema>> {
            [8, 16, 32, 64].into_iter().map(|n| suprema(r, n, cells)).collect()
        };
        let (fine, coarse, one) = (series(4)?, series(2)?, suprema(r, 1, 64)?);
        let (c, c_dual) = (constant(ErrorNorm::L2, r)?, constant(ErrorNorm::Dual, r)?);

        // For (4.6) and for (4.7): the order of S(N), its bound, and the value on one element.
        let mut compare = |label: &str,
                           power: &str,
                           theory: f64,
                           constant: Measured,
                           on_one: f64,
                           of: fn(&Suprema) -> f64| {
            let fine: Vec<f64> = fine.iter().map(of).collect();
            let coarse: Vec<f64> = coarse.iter().map(of).collect();
            let p = order(&fine[1..], theory - r);
            // ±: three times the change from coarser meshes, the change by half as many cells, and
            // rounding
            let by_meshes = 3.0 * (p - order(&fine[..3], theory - r)).abs();
            let by_cells = (p - order(&coarse[1..], theory - r)).abs();
            let p = Measured::new(p, by_meshes + by_cells + 1e-5);
            let claim = out.check(format!("{label}: order of S(N), deviation from {power}"));
            claim.whole_error_bars_differ_by_at_most(
                p - theory,
                0.0,
                0.05,
                "exponents of (4.6), (4.7)",
            );
            let scaled = constant.recip() * (fine[3] * 64f64.powf(theory));
            let claim = out.check(format!("{label}: S(64)/upper bound"));
            claim.whole_error_bars_at_most(scaled, 1.0, "C(r), C*(r)");
            let ratio = constant.recip() * on_one;
            let claim = out.check(format!("{label}: finite elements/library"));
            claim.whole_error_bars_differ_by_at_most(ratio, 1.0, 1e-3, "64 cells");
            p
        };
        let order = compare("(4.6)", "r", r, c, one.l2, |found| found.l2);
        let order_dual =
            compare("(4.7)", "r+1/2", r + 0.5, c_dual, one.element, |found| found.dual);
        let chain = c * half;
        let claim = out.check("C*(r)/(C(r) C(1/2))");
        claim.whole_error_bars_at_most(c_dual / chain, 1.0 + 1e-7, "proof of (4.7)");
        let claim = out.observe("min C*(r)/(C(r) C(1/2)) over r");
        claim.whole_error_bars_at_least(c_dual / chain, 0.99, "equality at r = 1/2");
        out.row(cells! { r => c, one: one.l2, order, c_dual, order_dual });
    }
    for &r in &options.beyond {
        let a = r - 0.5 + 0.005;
        let e =
            [error_of_power(a, 1 << 8)?, error_of_power(a, 1 << 12)?, error_of_power(a, 1 << 16)?];
        let h = [8, 12, 16].map(|power| 0.5f64.powi(power));
        let before = exponent_between((h[0], e[0]), (h[1], e[1])).value;
        let last = exponent_between((h[1], e[1]), (h[2], e[2])).value;
        let order = Measured::new(last, 3.5 * (last - before).abs());
        let limit = e[2] * 65536.0 * (12.0 * (2.0 * a - 1.0)).sqrt() / a; // ‖φ'‖₀ = a / √(2a − 1)
        let next = 4096f64.powf(1.0 - 2.0 * a);
        let claim = out.check("r > 1: order − 1").undecided_if_also_true_of(r - 1.0);
        claim.whole_error_bars_differ_by_at_most(order - 1.0, 0.0, 0.02 + next, "Remark 4");
        let part = 65536f64.powf(-(2.0 * a - 1.0).min(1.0));
        let claim = out.check("r > 1: √12 ‖φ − π^h φ‖₀/(h ‖φ'‖₀)");
        claim.differ_by_at_most(limit, 1.0, part, "Remark 4, finest mesh");
        out.row(cells! { r => order, limit });
    }
    let axes = Axes::Linear("r, smoothness of the function", "order, exponent of h");
    out.plot(
        "section_4_p0_projection",
        "(4.6), (4.7): orders of the projection on constants",
        axes,
    )
    .curve("r", "order")
    .curve("r", "order_dual")
    .dashed_line("min(r, 1)", vec![(0.0, 0.0), (1.0, 1.0), (4.0, 1.0)])
    .dashed_line("r + 1/2", vec![(0.0, 0.5), (1.0, 1.5)]);
    Ok(())
}
