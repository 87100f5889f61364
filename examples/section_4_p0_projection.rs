//! (4.6), (4.7): the projection on piecewise constants, in L² and in the dual norm of H^(1/2).
//!
//! π^h φ is the mean of φ on each of N = 1/h equal elements of (0, 1), |φ|²_r = ∬ (φ(x) − φ(y))² / |x − y|^(1+2r) dx dy for
//! 0 < r < 1, |φ|₁ = ‖φ'‖₀, and ‖f‖_(1/2,*) is the largest ∫ f ψ over ψ with ‖ψ‖₀² + |ψ|²_(1/2) = 1. The paper uses
//!
//! ```text
//! ‖φ − π^h φ‖₀ ≤ C h^r |φ|_r   (4.6),      ‖φ − π^h φ‖_(1/2,*) ≤ C h^(r+1/2) |φ|_r   (4.7).
//! ```
//!
//! C(r) and C*(r) are the best constants of one element, C* for ∫ (φ − π^h φ)(ψ − π^h ψ) ≤ C* h^(r+1/2) |φ|_r |ψ|_(1/2); the
//! proof has C* ≤ C(r) C(1/2). S(N) is the largest quotient of both norms over all φ, on N elements.
//!
//! Refuted if S(N) h^−r or S(N) h^(−r−1/2) is above its constant, if C* is above C(r) C(1/2), or if an order of S(N), its
//! uncertainty included, is off r or r + 1/2 by more than 0.05. S(N)^−2 = A N^(2p) − B: B is what the pairs of points
//! outside (0, 1) would add to |φ|²_r; three meshes give the order p, which is not put in.
//!
//! `cargo run --release --example section_4_p0_projection -- --r 0.15,0.99`

use example_report::prelude::*;
use fractional_sobolev::{Domain, ErrorNorm, Gram, Mesh, projection_constant};
use nalgebra::DMatrix;

example! { seconds "(4.6), (4.7)", "‖φ − π^h φ‖₀ ≤ C h^r |φ|_r,  ‖φ − π^h φ‖_(1/2,*) ≤ C h^(r+1/2) |φ|_r  for 0 ≤ r ≤ 1";
    /// orders r
    r: Vec<f64> = "0.1,0.2,0.3,0.4,0.5,0.6,0.7,0.8,0.9,1" in "[0.05, 1]" slider "0.1 to 1",
}

/// S(N) in both norms over φ that are linear on each of some cells per element, given by nodal values: √λ, λ the largest with
/// Q φ = λ A φ. A holds |φ|²_r; Q = R for L², R = M − P the form of ‖φ − π^h φ‖₀², M the masses and P that of means; Q =
/// R (M + H)⁻¹ R for the dual norm, H the form of |ψ|²_(1/2), since ∫ (φ − π^h φ) ψ = φᵀ R ψ; and Q = R H⁻¹ R for C*(r), N = 1.
fn supremum(r: f64, elements: usize, cells: usize) -> Result<[f64; 3]> {
    let n = elements * cells;
    let c = 1.0 / n as f64;
    let mesh = Mesh::uniform(n, 1.0)?;
    let on_cells = |block: [f64; 4]| {
        let mut matrix = DMatrix::<f64>::zeros(n + 1, n + 1);
        for k in 0..n {
            let mut cell = matrix.view_mut((k, k), (2, 2));
            cell += DMatrix::from_row_slice(2, 2, &block);
        }
        matrix
    };
    let mass = on_cells([2.0, 1.0, 1.0, 2.0]) * (c / 6.0);
    let mut rest = mass.clone(); // M − P
    for first in (0..n).step_by(cells) {
        let weight = |k: usize| if k == first || k == first + cells { 0.5 } else { 1.0 }; // ∫ φ over the element, over c
        for (i, j) in (first..=first + cells).flat_map(|i| (first..=first + cells).map(move |j| (i, j))) {
            rest[(i, j)] -= weight(i) * weight(j) * c / cells as f64;
        }
    }
    let seminorm = |r: f64| -> Result<DMatrix<f64>> {
        // Gram: closed forms for every pair of hat functions
        if r == 1.0 {
            Ok(on_cells([1.0, -1.0, -1.0, 1.0]) / c)
        } else {
            Ok(Gram::new(&mesh, r, 1e-10)?.to_dense()?)
        }
    };
    let free = |matrix: DMatrix<f64>| matrix.remove_row(n).remove_column(n); // φ(1) = 0: constants change nothing
    let inverse = |h: DMatrix<f64>, rest: &DMatrix<f64>| match h.cholesky() {
        Some(h) => Ok(rest * h.solve(rest)),
        None => Err(Error::Option("the form is not positive definite".to_owned())),
    };
    let half = seminorm(0.5)?;
    let dual = free(inverse(&mass + &half, &rest)?);
    let rest = free(rest);
    let element = inverse(free(half), &rest)?;
    let a = free(seminorm(r)?);
    let largest = |q: &DMatrix<f64>| -> Result<f64> { Ok(largest_eigenvalue(q, &a)?.sqrt()) };
    Ok([largest(&rest)?, largest(&dual)?, largest(&element)?])
}

/// The order p of S^−2 = A N^(2p) − B from meshes of N/4, N/2 and N elements; S N^half is fitted, half = 0 or 1/2.
fn order(s: &[f64], half: f64) -> f64 {
    let square = |k: usize| (s[k] * 2f64.powf(k as f64 * half)).powi(-2);
    0.5 * ((square(2) - square(1)) / (square(1) - square(0))).log2() + half
}

fn run(options: &Options, out: &mut Report) -> Result<()> {
    const MESHES: [usize; 4] = [8, 16, 32, 64];
    // By the library: Legendre series for φ and ψ, largest eigenvalue; error: change when doubled.
    let constant = |norm, r: f64| -> Result<Measured> {
        Ok(projection_constant(Domain::Interval(1.0), norm, r, 1e-8)?.constant.into())
    };
    let half = constant(ErrorNorm::L2, 0.5)?;
    for &r in &options.r {
        let all = |cells: usize| MESHES.iter().map(|&n| supremum(r, n, cells)).collect::<Result<Vec<_>>>();
        let (fine, coarse, one) = (all(4)?, all(2)?, supremum(r, 1, 64)?);
        let (c, c_dual) = (constant(ErrorNorm::L2, r)?, constant(ErrorNorm::Dual, r)?);
        let chain = c * half;
        let mut orders = [Measured::NONE; 2];
        for (k, (label, constant, theory)) in
            [("(4.6)", c, r), ("(4.7)", c_dual, r + 0.5)].into_iter().enumerate()
        {
            let of = |all: &[[f64; 3]]| order(&all.iter().map(|s| s[k]).collect::<Vec<_>>(), theory - r);
            let p = of(&fine[1..]);
            // three times the change from coarser meshes, and what half as many cells change; rounding
            orders[k] =
                Measured::new(p, 3.0 * (p - of(&fine[..3])).abs() + (p - of(&coarse[1..])).abs() + 1e-5);
            out.check(format!("{label}: order of S(N) less {}", ["r", "r+1/2"][k])).near(
                orders[k] - theory,
                0.0,
                0.05,
                "theory",
            );
            let scaled = fine[3][k] * 64f64.powf(theory);
            out.check(format!("{label}: S(64) over its bound")).at_most(
                constant.recip() * scaled,
                1.0,
                "C(r), C*(r)",
            );
            let definition = constant.recip() * [one[0], one[2]][k];
            out.check(format!("{label}: `supremum` over C")).near(definition, 1.0, 1e-3, "64 cells");
        }
        out.check("C*(r) over C(r) C(1/2)").at_most(c_dual / chain, 1.0 + 1e-7, "proof of (4.7)");
        out.observe("the same: nearly sharp").at_least(c_dual / chain, 0.99, "equality at 1/2");
        out.row(cells! { r => c, one: one[0], order: orders[0], c_dual, order_dual: orders[1], chain: chain.value });
    }
    for (name, title, meaning) in [
        ("c", "C(r)", "best constant of (4.6) on one element"),
        ("one", "on cells", "the same from `supremum`"),
        ("order", "order", "of S(N), N = 16, 32, 64"),
        ("c_dual", "C*(r)", "best constant of (4.7)"),
        ("order_dual", "order", ""),
        ("chain", "chain", "C(r) C(1/2)"),
    ] {
        out.column(name, title, meaning);
    }
    let axes = Axes::Linear("r, smoothness of the function", "order, exponent of h");
    out.plot("section_4_p0_projection", "(4.6), (4.7): orders of the projection on constants", axes)
        .curve("r", "order")
        .curve("r", "order_dual")
        .dashed_line("r", vec![(0.0, 0.0), (1.0, 1.0)])
        .dashed_line("r + 1/2", vec![(0.0, 0.5), (1.0, 1.5)]);
    Ok(())
}
