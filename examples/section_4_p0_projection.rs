//! (4.6), (4.7), Remark 4: the projection on piecewise constants, in L² and in the dual norm of H^(1/2), and its limit.
//!
//! π^h φ is the mean of φ on each of N = 1/h equal elements of (0, 1), |φ|²_r = ∬ (φ(x) − φ(y))² / |x − y|^(1+2r) dx dy for
//! 0 < r < 1, |φ|₁ = ‖φ'‖₀, and ‖f‖_(1/2,*) is the largest ∫ f ψ over ψ with ‖ψ‖₀² + |ψ|²_(1/2) = 1. The paper uses
//!
//! ```text
//! ‖φ − π^h φ‖₀ ≤ C h^r |φ|_r   (4.6),      ‖φ − π^h φ‖_(1/2,*) ≤ C h^(r+1/2) |φ|_r   (4.7)      for r ≤ 1, and Remark 4:
//! ‖φ − π^h φ‖₀ = h ‖φ'‖₀ / √12 (1 + o(1)) for φ in H¹, since φ − π^h φ is φ' times the distance from the centre.
//! ```
//!
//! C(r) and C*(r) are the best constants of one element, C* for ∫ (φ − π^h φ)(ψ − π^h ψ) ≤ C* h^(r+1/2) |φ|_r |ψ|_(1/2); the
//! proof has C* ≤ C(r) C(1/2). S(N) is the largest quotient over all φ, on N elements. S(N)^−2 = A N^(2p) − B: B is what
//! the pairs of points outside (0, 1) would add to |φ|²_r; three meshes give the order p. For r > 1 φ = x^a, a = r − 0.495,
//! barely in H^r, with a next term smaller by h^q, q = 2a − 1.
//!
//! Refuted if S(N) h^−r or S(N) h^(−r−1/2) is above its constant, C* is above C(r) C(1/2), an order of S(N) with its ± is off
//! r or r + 1/2 by 0.05, that of x^a off 1 by 0.02 + 4096^−q, or its error off h ‖φ'‖₀/√12 by the part h^min(q, 1).

// `at_most(x, b)` holds if x + its ± ≤ b, `at_least(x, b)` if x − its ± ≥ b, `near(x, b, t)` if |x − b| + its ± ≤ t;
// otherwise it fails, or is undecided within ±. Of several calls the worst counts. `observe` decides nothing.
use example_report::prelude::*;
use fractional_sobolev::{Domain, ErrorNorm, Gram, Mesh, gauss_legendre, projection_constant};
use nalgebra::DMatrix;

example! { seconds "(4.6), (4.7)", "‖φ − π^h φ‖₀ ≤ C h^r |φ|_r,  ‖φ − π^h φ‖_(1/2,*) ≤ C h^(r+1/2) |φ|_r,  r ≤ 1 only";
    /// orders r up to 1
    r: Vec<f64> = "0.1,0.2,0.3,0.4,0.5,0.6,0.7,0.8,0.9,1" in "[0.05, 1]" slider "0.1 to 1",
    /// orders r above 1
    beyond: Vec<f64> = "1.25,1.5,2,2.5,4" in "[1.01, 10]" slider "1.1 to 3",
}

/// S(N) in both norms, and C*(r) for N = 1, over φ linear on each of some cells per element, given by nodal values: √λ, λ the
/// largest with Q φ = λ A φ. A holds |φ|²_r; Q = R for L², R = M − P the form of ‖φ − π^h φ‖₀², M the masses and P that of means;
/// Q = R (M + H)⁻¹ R for the dual norm, H the form of |ψ|²_(1/2), since ∫ (φ − π^h φ) ψ = φᵀ R ψ; and Q = R H⁻¹ R for C*(r).
fn supremum(r: f64, elements: usize, cells: usize) -> Result<[f64; 3]> {
    let n = elements * cells;
    let (mesh, c) = (Mesh::uniform(n, 1.0)?, 1.0 / n as f64);
    let mass = mass_matrix(&mesh);
    let mut rest = mass.clone(); // M − P
    for first in (0..n).step_by(cells) {
        let weight = |k: usize| if k == first || k == first + cells { 0.5 } else { 1.0 }; // ∫ φ over the element, over c
        for (i, j) in (first..=first + cells).flat_map(|i| (first..=first + cells).map(move |j| (i, j))) {
            rest[(i, j)] -= weight(i) * weight(j) * c / cells as f64;
        }
    }
    let seminorm = |r: f64| -> Result<DMatrix<f64>> {
        if r < 1.0 {
            return Ok(Gram::new(&mesh, r, 1e-10)?.to_dense()?); // closed forms for every pair of hat functions
        }
        Ok(DMatrix::from_fn(n + 1, n + 1, |i, j| match i.abs_diff(j) {
            0 if i == 0 || i == n => 1.0 / c,
            0 => 2.0 / c,
            1 => -1.0 / c,
            _ => 0.0,
        }))
    };
    let free = |matrix: DMatrix<f64>| matrix.remove_row(n).remove_column(n); // φ(1) = 0: constants change nothing
    let inverse = |h: DMatrix<f64>, rest: &DMatrix<f64>| match h.cholesky() {
        Some(h) => Ok(rest * h.solve(rest)),
        None => Err(Error::Option("the form is not positive definite".to_owned())),
    };
    let half = seminorm(0.5)?;
    let dual = free(inverse(&mass + &half, &rest)?);
    let rest = free(rest);
    let (element, a) = (inverse(free(half), &rest)?, free(seminorm(r)?));
    let largest = |q: &DMatrix<f64>| -> Result<f64> { Ok(largest_eigenvalue(q, &a)?.sqrt()) };
    Ok([largest(&rest)?, largest(&dual)?, largest(&element)?])
}

/// The order p of S^−2 = A N^(2p) − B from meshes of N/4, N/2 and N elements; S N^half is fitted, half = 0 or 1/2.
fn order(s: &[f64], half: f64) -> f64 {
    let square = |k: usize| (s[k] * 2f64.powf(k as f64 * half)).powi(-2);
    0.5 * ((square(2) - square(1)) / (square(1) - square(0))).log2() + half
}

/// ‖φ − π^h φ‖₀ for φ = x^a on n equal elements: closed form on the first, six Gauss points on each other.
fn error_of_power(a: f64, n: usize) -> Result<f64> {
    let (h, rule) = (1.0 / n as f64, gauss_legendre(6)?);
    let mut square = h.powf(2.0 * a + 1.0) * (1.0 / (2.0 * a + 1.0) - 1.0 / (a + 1.0).powi(2));
    for k in 1..n {
        let (x, y) = (k as f64 * h, 1.0 / k as f64);
        let rise = |s: f64, power: f64| x.powf(power) * (power * s.ln_1p()).exp_m1(); // (x (1 + s))^power − x^power
        let mean = rise(y, a + 1.0) / ((a + 1.0) * h) - x.powf(a); // of φ − φ(x)
        square += h * rule.integrate(|t| (rise(t * y, a) - mean).powi(2));
    }
    Ok(square.sqrt())
}

fn run(options: &Options, out: &mut Report) -> Result<()> {
    out.column("c", "C(r)", "best constant of (4.6) on one element");
    out.column("one", "on cells", "the same from `supremum`");
    out.column("order", "order", "of S(N), N = 16, 32, 64; r > 1: of ‖x^a − π^h x^a‖₀");
    out.column("c_dual", "C*(r)", "best constant of (4.7)");
    out.column("order_dual", "order", "in the dual norm");
    out.column("limit", "/ limit", "‖x^a − π^h x^a‖₀ over h ‖φ'‖₀/√12, 65536 elements");
    // By the library: Legendre series for φ and ψ, largest eigenvalue; error: change when doubled.
    let constant = |norm, r: f64| -> Result<Measured> {
        Ok(projection_constant(Domain::Interval(1.0), norm, r, 1e-8)?.constant.into())
    };
    let half = constant(ErrorNorm::L2, 0.5)?;
    for &r in &options.r {
        let all = |cells: usize| [8, 16, 32, 64].into_iter().map(|n| supremum(r, n, cells)).collect();
        let (fine, coarse): (Result<Vec<_>>, Result<Vec<_>>) = (all(4), all(2));
        let (fine, coarse, one) = (fine?, coarse?, supremum(r, 1, 64)?);
        let (c, c_dual) = (constant(ErrorNorm::L2, r)?, constant(ErrorNorm::Dual, r)?);
        let (chain, mut orders) = (c * half, [Measured::NONE; 2]);
        for (k, (label, constant, theory)) in
            [("(4.6)", c, r), ("(4.7)", c_dual, r + 0.5)].into_iter().enumerate()
        {
            let of = |all: &[[f64; 3]]| order(&all.iter().map(|s| s[k]).collect::<Vec<_>>(), theory - r);
            let p = of(&fine[1..]);
            // three times the change from coarser meshes, and what half as many cells change; rounding
            let error = 3.0 * (p - of(&fine[..3])).abs() + (p - of(&coarse[1..])).abs() + 1e-5;
            orders[k] = Measured::new(p, error);
            let claim = format!("{label}: order of S(N), deviation from {}", ["r", "r+1/2"][k]);
            out.check(claim).near(orders[k] - theory, 0.0, 0.05, "exponents of (4.6), (4.7)");
            let scaled = constant.recip() * (fine[3][k] * 64f64.powf(theory));
            out.check(format!("{label}: S(64)/upper bound")).at_most(scaled, 1.0, "C(r), C*(r)");
            let definition = constant.recip() * [one[0], one[2]][k];
            out.check(format!("{label}: finite elements/library")).near(definition, 1.0, 1e-3, "64 cells");
        }
        out.check("C*(r)/(C(r) C(1/2))").at_most(c_dual / chain, 1.0 + 1e-7, "proof of (4.7)");
        out.observe("min C*(r)/(C(r) C(1/2)) over r").at_least(c_dual / chain, 0.99, "equality at r = 1/2");
        out.row(cells! { r => c, one: one[0], order: orders[0], c_dual, order_dual: orders[1] });
    }
    for &r in &options.beyond {
        let a = r - 0.5 + 0.005;
        let e = [error_of_power(a, 1 << 8)?, error_of_power(a, 1 << 12)?, error_of_power(a, 1 << 16)?];
        let between = |k: usize| (e[k] / e[k + 1]).log2() / 4.0;
        let order = Measured::new(between(1), 3.5 * (between(1) - between(0)).abs());
        let limit = e[2] * 65536.0 * (12.0 * (2.0 * a - 1.0)).sqrt() / a; // ‖φ'‖₀ = a / √(2a − 1)
        let next = 4096f64.powf(1.0 - 2.0 * a);
        out.check("r > 1: order − 1").against(r - 1.0).near(order - 1.0, 0.0, 0.02 + next, "Remark 4");
        let part = 65536f64.powf(-(2.0 * a - 1.0).min(1.0));
        out.check("r > 1: √12 ‖φ − π^h φ‖₀/(h ‖φ'‖₀)").against(0.0).near(
            limit,
            1.0,
            part,
            "Remark 4, finest mesh",
        );
        out.row(cells! { r => order, limit });
    }
    let axes = Axes::Linear("r, smoothness of the function", "order, exponent of h");
    out.plot("section_4_p0_projection", "(4.6), (4.7): orders of the projection on constants", axes)
        .curve("r", "order")
        .curve("r", "order_dual")
        .dashed_line("min(r, 1)", vec![(0.0, 0.0), (1.0, 1.0), (4.0, 1.0)])
        .dashed_line("r + 1/2", vec![(0.0, 0.5), (1.0, 1.5)]);
    Ok(())
}
