//! Lemma 6.2: linear interpolation on a mesh, with the constant 1.
//!
//! I^h u is the piecewise linear interpolant of u at the nodes of a mesh of an interval Γ, h the
//! length of the largest element, and |u|²_(1+ν) = ∬ (u'(x) − u'(y))² / |x − y|^(1+2ν) dx dy over Γ
//! × Γ, 0 < ν < 1. The lemma says
//!
//! ```text
//! ‖u − I^h u‖₀ ≤ h^(1+ν) |u|_(1+ν),        ‖u − I^h u‖₁ ≤ h^ν |u|_(1+ν).
//! ```
//!
//! The squares of Lemma 6.1 are added over the elements, so its best constants C₀(ν) of the first
//! line and C₁(ν) of |u − I^h u|₁ serve every mesh. On N equal elements the best constants are
//! smaller, since |u|_(1+ν) also has the pairs of points in different elements. All are maxima over
//! trial functions, hence lower bounds: they can refute "≤ 1", and ± says how much is missing.
//! Unequal meshes rest on the sum of squares alone.
//!
//! With the full norm, ‖·‖₁² = ‖·‖₀² + |·|₁², the second line needs h ≤ h*(ν) < ∞, the length at
//! which the best constant is 1: above 5.4 for every ν (example `lemma_6_1_local_estimate`). On
//! elements of length h = 2/C₀ the quotient is at least h C₀(mesh) = 2 C₀(mesh)/C₀ > 1 for the
//! meshes here: there the line as printed fails.
//!
//! Refuted if C₀, C₁ or the constant of the full norm at h = 1 is above 1, if the best constant of
//! a mesh is above that of one element, or if `of_mesh` and the library differ by more than 3 %.
//! False as printed if the full norm at h = 2/C₀ is above 1. A claim beyond the lemma, C₀ ≤ 0.16,
//! refutes only itself. Undecided while a bound lies inside of an error bar.
//!
//! `cargo run --release --example lemma_6_2_global_estimate -- --nu 0.1,0.4`

use example_report::prelude::*;
use fractional_sobolev::{Domain, ErrorNorm, Gram, Mesh, gauss_legendre, interpolation_constant};
use nalgebra::DMatrix;

example! { quick "Lemma 6.2",
    "‖u − I^h u‖₀ ≤ h^(1+ν) |u|_(1+ν),  ‖u − I^h u‖₁ ≤ h^ν |u|_(1+ν)  on a mesh";
    /// orders ν
    nu: Vec<Order> = "0.25,0.5,0.75" in "(0, 1)" slider "0.02 to 0.98",
    /// numbers N of equal elements
    elements: Vec<usize> = "1,2,4,8,16" in "[1, 32]",
}

/// Best constants on a mesh, over those powers of h that make them independent of its scale.
struct OfMesh {
    /// Of ‖u − I^h u‖₀, over h^(1+ν).
    l2: f64,
    /// Of |u − I^h u|₁, over h^ν.
    slope: f64,
    /// Of ‖u − I^h u‖₁, over h^ν.
    full: f64,
}

/// Best constants on N elements of length h, from their definition. u' = v is linear on each of 12
/// cells per element, given by its nodal values; the elements are scaled to length 1. The constants
/// are √λ, λ the largest with DᵀD v = λ A v, where vᵀ A v = |v|²_ν (closed form) and ‖D v‖ is
/// ‖u − I^h u‖₀ for `l2`, |u − I^h u|₁ for `slope`, both squared and added for `full`.
fn of_mesh(nu: Order, elements: usize, h: f64) -> Result<OfMesh> {
    const CELLS: usize = 12;
    let (n, cell) = (elements * CELLS, 1.0 / CELLS as f64);
    let rule = gauss_legendre(3)?; // three points on each cell: exact here
    // Rows: Gauss points, times the root of the weight; columns: hat functions v of nodes 0 ..
    // n − 1. v = 0 at the last node, since constants change nothing.
    let mut values = DMatrix::zeros(3 * n, n);
    let mut slopes = DMatrix::zeros(3 * n, n);
    for node in 0..n {
        let v = |k: usize| if k == node { 1.0 } else { 0.0 };
        for first in (0..n).step_by(CELLS) {
            let cells = first..first + CELLS;
            let rise: f64 = cells.clone().map(|k| cell * (v(k) + v(k + 1)) / 2.0).sum(); // of I^h u
            let mut u = 0.0; // ∫ v from the start of the element
            for k in cells {
                for (j, (t, w)) in rule.iter().enumerate() {
                    let x = ((k - first) as f64 + t) * cell; // place in the element
                    let slope = v(k) + t * (v(k + 1) - v(k));
                    let value = u + cell * t * (v(k) + slope) / 2.0;
                    let weight = (w * cell).sqrt();
                    values[(3 * k + j, node)] = weight * (value - rise * x);
                    slopes[(3 * k + j, node)] = weight * (slope - rise);
                }
                u += cell * (v(k) + v(k + 1)) / 2.0;
            }
        }
    }
    let fine = Mesh::uniform(n, elements as f64)?;
    let a = Gram::new(&fine, nu, 1e-8)?.to_dense()?.remove_row(n).remove_column(n);
    let (l2, slope) = (values.transpose() * values, slopes.transpose() * slopes);
    let full = &slope + &l2 * (h * h);
    Ok(OfMesh {
        l2: largest_eigenvalue(&l2, &a)?.sqrt(),
        slope: largest_eigenvalue(&slope, &a)?.sqrt(),
        full: largest_eigenvalue(&full, &a)?.sqrt(),
    })
}

fn run(options: &Options, out: &mut Report) -> Result<()> {
    let mut smallest_share = 1.0f64;
    for &nu in &options.nu {
        // On one element: v a sum of odd Legendre polynomials, largest eigenvalue; ±: the change
        // when their number is doubled.
        let best = |norm: ErrorNorm| -> Result<Measured> {
            Ok(interpolation_constant(Domain::Interval(1.0), norm, nu, 1e-8)?.constant.into())
        };
        let (c0, c1) = (best(ErrorNorm::L2)?, best(ErrorNorm::Derivative)?);
        let short = best(ErrorNorm::H1)?;
        out.check("first line: best constant C₀").whole_error_bars_at_most(c0, 1.0, "Lemma 6.2");
        let claim = out.check("second line, seminorm: best constant C₁");
        claim.whole_error_bars_at_most(c1, 1.0, "Lemma 6.2");
        let claim = out.check("second line, full norm: constant, h = 1");
        claim.whole_error_bars_at_most(short, 1.0, "Lemma 6.2");
        let claim = out.stronger("first line: max C₀ over ν");
        claim.whole_error_bars_at_most(c0, 0.16, "supremum 0.1587 as ν → 0");
        for &elements in &options.elements {
            let mesh = of_mesh(nu, elements, 2.0 / c0.value)?;
            let shares = [c0.recip() * mesh.l2, c1.recip() * mesh.slope];
            smallest_share = smallest_share.min(shares[1].value);
            let share = largest(shares);
            let claim = out.check("best constants, mesh/single element");
            claim.whole_error_bars_at_most(share, 1.0 + 1e-9, "sum over elements");
            let claim = out.as_printed("second line, full norm: constant, h = 2/C₀");
            claim.at_most(mesh.full, 1.0, "for h ≤ 5.4");
            // The library takes the space of `of_mesh` with 2, 4, 8, .. cells per element, until
            // the gain is below 1 %, which is ±.
            let domain = Domain::Mesh(Mesh::uniform(elements, elements as f64)?);
            let library = interpolation_constant(domain, ErrorNorm::Derivative, nu, 0.01)?.constant;
            let ratio = Measured::from(library).recip() * mesh.slope;
            let claim = out.check("C₁(mesh) from matrices/library value");
            claim.whole_error_bars_differ_by_at_most(ratio, 1.0, 0.03, "matrix eigenproblem");
            out.row(cells! { nu, elements => mesh_0: mesh.l2, c_0: c0.value, mesh_1: mesh.slope,
            library_1: library.value, c_1: c1.value, long: mesh.full });
        }
    }
    out.note("mesh_share", smallest_share); // of C₁
    out.column("mesh_0", "mesh, L²", "best constant of ‖u − I^h u‖₀ on N elements, by `of_mesh`");
    out.column("c_0", "C₀", "the same on one element");
    out.column("mesh_1", "mesh, |·|₁", "of |u − I^h u|₁");
    out.column("library_1", "library", "the same by the library");
    out.column("c_1", "C₁", "on one element");
    out.column("long", "long", "of ‖u − I^h u‖₁ on elements of length h = 2/C₀");
    let axes = Axes::LogLog("N, number of elements", "quotient, printed bound 1");
    out.plot(
        "lemma_6_2_global_estimate",
        "Lemma 6.2: the second line on N elements, seminorm",
        axes,
    )
    .curve_by("nu", "elements", "mesh_1")
    .dashed_by("nu", "elements", "c_1");
    Ok(())
}
