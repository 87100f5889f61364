//! Remark 4: the projection on piecewise constants gains nothing beyond H¹.
//!
//! π^h φ is the mean of φ on each of N = 1/h equal elements of (0, 1). By (4.6) the error ‖φ − π^h φ‖₀ has the order r for
//! φ in H^r, r ≤ 1. For φ in H¹, however smooth,
//!
//! ```text
//! ‖φ − π^h φ‖₀ = h ‖φ'‖₀ / √12 (1 + o(1)),
//! ```
//!
//! since φ − π^h φ is φ' times the distance from the centre of the element, whose mean square is h²/12. So the order is
//! min(r, 1); linear interpolation I^h φ goes on to order 2. Here φ = x^a, a = r − 1/2 + 0.005: barely in H^r.
//!
//! In (4.9) the error of the method is bounded by ∫ (σ_N − π^h σ_N)(u_N − π^h u_N), for u in H^τ of the power 2τ − 2 in h.
//! The product of the norms of both factors has, at τ = 7/4, σ_N in H^(1/4) and u_N in H^(5/4), only 1/4 + 1 (observed).
//!
//! The next term is smaller by h^q, q = |2a − 1|: what the first element contributes, where φ is not smooth. Refuted if an
//! order of ‖φ − π^h φ‖₀, its uncertainty included, is off min(r, 1) by more than 0.02 + h^q, h = 1/4096, or if on 65536
//! elements the error of a φ in H¹ is off h ‖φ'‖₀ / √12 by a larger part than h^min(q, 1).
//!
//! `cargo run --release --example remark_4_saturation -- --r 0.9,1.2,3`

use example_report::prelude::*;
use fractional_sobolev::{Gram, Mesh, gauss_legendre};
use nalgebra::{Cholesky, DMatrix, DVector, Dyn};
use signorini::rates::order_between;

example! { seconds "Remark 4", "‖φ − π^h φ‖₀ = h ‖φ'‖₀/√12 (1 + o(1)) for φ in H¹: the order is min(r, 1) for φ in H^r";
    /// orders r of smoothness
    r: Vec<f64> = "0.25,0.5,0.75,1.25,1.5,2,2.5,4" in "(0, 10]" slider "0.1 to 3",
}

/// ‖φ − π^h φ‖₀ and ‖φ − I^h φ‖₀ for φ = x^a on n equal elements: closed forms on the first, six Gauss points on each other.
fn errors(a: f64, n: usize) -> Result<[f64; 2]> {
    let (h, rule) = (1.0 / n as f64, gauss_legendre(6)?);
    let mut constant = h.powf(2.0 * a + 1.0) * (1.0 / (2.0 * a + 1.0) - 1.0 / (a + 1.0).powi(2));
    let mut linear = h.powf(2.0 * a + 1.0) * (1.0 / (2.0 * a + 1.0) - 2.0 / (a + 2.0) + 1.0 / 3.0);
    for k in 1..n {
        let (x, y) = (k as f64 * h, 1.0 / k as f64);
        let rise = |s: f64, power: f64| x.powf(power) * (power * s.ln_1p()).exp_m1(); // (x (1 + s))^power − x^power
        let mean = rise(y, a + 1.0) / ((a + 1.0) * h) - x.powf(a); // of φ − φ(x)
        constant += h * rule.integrate(|t| (rise(t * y, a) - mean).powi(2));
        linear += h * rule.integrate(|t| (rise(t * y, a) - t * rise(y, a)).powi(2));
    }
    Ok([constant.sqrt(), linear.sqrt()])
}

/// Four cells per element for the dual norm of H^(1/2): sup ∫ f ψ / ‖ψ‖_(1/2) over continuous ψ linear on each cell is
/// (bᵀ (A + M)⁻¹ b)^(1/2), bᵢ = ∫ f ψᵢ, M the masses and A the seminorm's form of the hat functions ψᵢ.
fn half_norm(n: usize) -> Result<Cholesky<f64, Dyn>> {
    let cells = 4 * n;
    let mut matrix = Gram::new(&Mesh::uniform(cells, 1.0)?, 0.5, 1e-10)?.to_dense()?; // closed forms
    for k in 0..cells {
        let mut block = matrix.view_mut((k, k), (2, 2));
        block += DMatrix::from_row_slice(2, 2, &[2.0, 1.0, 1.0, 2.0]) / (6 * cells) as f64;
    }
    Cholesky::new(matrix).ok_or_else(|| Error::Option("A + M is not positive definite".to_owned()))
}

/// ‖φ − π^h φ‖_(1/2,*) for φ = x^a: the loads b from the moments of x^a on each cell.
fn dual_error(a: f64, n: usize, norm: &Cholesky<f64, Dyn>) -> f64 {
    let (cells, c) = (4 * n, 1.0 / (4 * n) as f64);
    let integral = |x: f64, power: f64| x.powf(power + 1.0) / (power + 1.0);
    let mut load = DVector::zeros(cells + 1);
    for k in 0..cells {
        let (x, y, first) = (k as f64 * c, (k + 1) as f64 * c, (k / 4 * 4) as f64 * c);
        let mean = (integral(first + 4.0 * c, a) - integral(first, a)) / (4.0 * c);
        let all = integral(y, a) - integral(x, a);
        let rising = (integral(y, a + 1.0) - integral(x, a + 1.0) - x * all) / c;
        load[k] += all - rising - 0.5 * c * mean;
        load[k + 1] += rising - 0.5 * c * mean;
    }
    load.dot(&norm.solve(&load)).sqrt()
}

/// The order between the two finer of three meshes; it may be off by 3.5 times the change from the coarser two.
fn order(n: [usize; 3], error: [f64; 3]) -> Measured {
    let point = |k: usize| (1.0 / n[k] as f64, error[k]);
    let last = order_between(point(1), point(2));
    Measured::new(last, 3.5 * (last - order_between(point(0), point(1))))
}

fn run(options: &Options, out: &mut Report) -> Result<()> {
    let (meshes, few) = ([1 << 8, 1 << 12, 1 << 16], [64, 128, 256]); // dense matrices in the dual norm
    let norms = [half_norm(few[0])?, half_norm(few[1])?, half_norm(few[2])?];
    let mut found = Vec::new();
    for &r in &options.r {
        let a = r - 0.5 + 0.005;
        let all = [errors(a, meshes[0])?, errors(a, meshes[1])?, errors(a, meshes[2])?];
        let p0 = order(meshes, all.map(|e| e[0]));
        let dual = order(few, [0, 1, 2].map(|k| dual_error(a, few[k], &norms[k])));
        let in_h1 = a > 0.5; // ‖φ'‖₀ = a / √(2a − 1)
        let p1 = in_h1.then(|| order(meshes, all.map(|e| e[1])));
        let limit = in_h1.then(|| all[2][0] * meshes[2] as f64 * (12.0 * (2.0 * a - 1.0)).sqrt() / a);
        let next = |h: f64, most: f64| h.powf((2.0 * a - 1.0).abs().min(most));
        let claim = if r <= 1.0 { "r ≤ 1: order less r" } else { "r > 1: order less 1" };
        let (distance, source) = (p0 - r.min(1.0), if r <= 1.0 { "(4.6)" } else { "saturation" });
        out.check(claim).near(distance, 0.0, 0.02 + next(1.0 / 4096.0, f64::INFINITY), source);
        if let Some(limit) = limit {
            out.check("error over h ‖φ'‖₀/√12").near(limit, 1.0, next(1.0 / 65536.0, 1.0), "finest mesh");
        }
        if r > 1.0 {
            out.observe("r > 1, dual norm: r + 1/2 less order").at_least(
                -dual + (r + 0.5),
                0.0,
                "(4.7) beyond r = 1",
            );
            out.observe("r > 1, linear interpolation: order").at_least(p1, 1.0, "that of constants");
        }
        found.push((r, p0));
        out.row(cells! { r => p0, dual, limit, p1: p1.map(|p1| p1.value) });
    }
    let of = |r: f64| found.iter().find(|row| row.0 == r).map(|row| row.1);
    if let (Some(sigma), Some(u)) = (of(0.25), of(1.25)) {
        out.observe("τ = 7/4: order of the product of both norms").at_most(
            sigma + u,
            1.5,
            "2τ − 2 of the term",
        );
    }
    out.column("p0", "order", "of ‖φ − π^h φ‖₀, 4096 to 65536 elements");
    out.column("dual", "dual", "in the dual norm of H^(1/2), 128 to 256 elements");
    out.column("limit", "/ limit", "error over h ‖φ'‖₀/√12");
    out.column("p1", "linear", "order of ‖φ − I^h φ‖₀");
    let axes = Axes::Linear("r, smoothness of the function", "order, exponent of h");
    out.plot("remark_4_saturation", "Remark 4: saturation of the projection on constants", axes)
        .curve("r", "p0")
        .curve("r", "dual")
        .curve("r", "p1");
    Ok(())
}
