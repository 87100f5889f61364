//! Appendix B, (4.6), (4.7) and the embeddings of Sections 3 and 4: constants of
//! interpolation.
//!
//! | paper | implementation |
//! | --- | --- |
//! | I^h u, Lagrange interpolation of degree one | affine on each element, equal to u at the nodes |
//! | e = u − I^h u, e' = u' − (mean of u' on the element) | everything is expressed in the slope v = u' |
//! | \|u\|\_{1+ν} = \|u'\|_ν | [`crate`], double integral over both orders of x and y |
//! | Lemma 6.1: ‖e‖₀ ≤ h^{1+ν} \|u\|\_{1+ν}, ‖e‖₁ ≤ h^ν \|u\|\_{1+ν} | [`interpolation_constant`] on an interval or a triangle |
//! | Lemma 6.2: best constants on a mesh | [`interpolation_constant`] on a mesh |
//! | (4.6), (4.7), (6.2): best constants | [`projection_constant`] |
//! | C(q) in (3.6), (3.10), (4.12), C(α) in (E3) | [`embedding_constant`] |
//!
//! All constants refer to the seminorm (1.1) as the paper defines it.

mod element;
mod elements;
mod embedding;
mod extremal;
mod forms;
mod mesh;
mod projection;
mod triangle;

pub use embedding::{Target, embedding_bound, embedding_constant};
pub use projection::projection_constant;

use crate::Mesh;
use crate::constant::{BestConstant, Domain, ErrorNorm, UnitOrder};
use crate::error::{Given, Result};
use crate::estimate::Tolerance;
use crate::order::SobolevOrder;

/// The best constant in ‖u − Iu‖ ≤ C |∇u|_s, where I is linear interpolation at the ends of an interval, the
/// nodes of a mesh or the corners of a triangle, 0 ≤ s ≤ 1; on the left the norm is the given [`ErrorNorm`].
///
/// |∇u|_s is the seminorm of order s of the gradient, for 0 < s < 1 the double integral over the domain; |∇u|₀ = ‖∇u‖,
/// |∇u|₁ = ‖D²u‖, to which (1−s)^{1/2} |u'|_s tends on an interval and ((1−s) 2/π)^{1/2} |∇u|_s in the plane. The limit
/// s → 0 of the double integral is not ‖∇u‖; for 0 < s < 1e-30 on an interval the constant for this limit is
/// returned.
///
/// # Method
///
/// **Interval (0, h).** For u with slope v, e = u − Iu has e' = v − v̄ and e(0) = e(h) = 0. The best constants are
/// h^{1+s} C_L2(s), h^s C_H1(s) with C_H1 = γ₁, the Poincaré constant [`gamma`](crate::gamma) for mean zero
/// on (0, 1), and h^s C_1(s, h) for the full norm, C_1(s, h)² = sup (‖e'‖² + h² ‖e‖²)/|v|²_s on (0, 1), which
/// increases with h. Extremal slopes are odd about the centre, behave like a constant plus r^a at the ends, r
/// the distance from the end, 2s < a < 2s + 1, and are analytic in the interior: with K odd Legendre
/// polynomials the constant is approached from below like K^{-4(a+1/2−s)}, in experiments like K^{-5.6}: 1e-9
/// at K = 16, 1e-13 at K = 64. Cost O(K⁴).
///
/// **Mesh.** The constant is at most that of the longest element, and smaller for several elements, because
/// |u|²\_{1+s} also contains the pairs of points in different elements. The value is a lower bound from slopes
/// that are linear on m cells per element, and the best constant exceeds it by at most `error`; the error
/// decreases like m^{-1-2s}, at most like m^{-2}. The matrices are dense; cost O((N m)³) for N elements.
///
/// **Triangle**, s ≥ 0.02. Orthonormal polynomials up to degree p and powers r^{2s} about the corners, times
/// polynomials in an angular variable, give a lower bound by a generalised eigenvalue problem. The bounds of degrees
/// p, p − 2, ... converge like p^{-k}, with k estimated from three of them; the constant is their extrapolated limit,
/// and its error the sum of the change of that limit from p − 2 to p, a part of its distance from the bound, and
/// twice the contribution of the last angular polynomial. p increases from 10, or from 14 for tolerances below 1e-5,
/// to 30 at most. `upper` is a proved bound up to rounding errors, from eigenvalues of matrices for cells similar to
/// the triangle: at most twice the constant for s ≥ 1/4; for the gradient at s = 1 it is Kobayashi's (Proc. Symp.
/// RIMS 1733 (2011) 58-77). The relative quadrature error is 3e-8.
///
/// ```
/// use fractional_sobolev::{Domain, ErrorNorm, interpolation_constant};
/// let slope = interpolation_constant(Domain::Interval(1.0), ErrorNorm::Derivative, 0.5, 1e-8)?;
/// assert!((slope.constant.value - 0.291_564_029).abs() < 1e-8); // the paper's constant is 1
/// // ‖∇(u − Iu)‖ ≤ C ‖D²u‖: Babuska and Aziz have 0.4929, Kobayashi 0.4916
/// let right = Domain::Triangle([[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]);
/// let found = interpolation_constant(right, ErrorNorm::Derivative, 1.0, 1e-5)?;
/// assert!((found.constant.value - 0.488_722_4).abs() < 1e-6);
/// assert!(found.upper.is_some_and(|upper| (upper.value - 0.491_596_0).abs() < 1e-7));
/// assert!(found.extremal()?.value(&[1.0, 0.0]).abs() < 1e-9); // zero at the corners
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
///
/// # Errors
/// [`Error::OutOfRange`](crate::Error::OutOfRange) for s outside [0, 1], below 0.02 on a triangle, for a length outside
/// [1e-150, 1e150] or an angle below 5.8 degrees; [`Error::Incompatible`](crate::Error::Incompatible) for another domain
/// or norm; [`Error::CountOutOfRange`](crate::Error::CountOutOfRange) for more than 1024 elements;
/// [`Error::ToleranceNotMet`](crate::Error::ToleranceNotMet).
#[doc(alias("interpolation error", "Lagrange interpolation", "Bramble-Hilbert"))]
pub fn interpolation_constant(
    domain: Domain,
    norm: ErrorNorm,
    s: impl Given<SobolevOrder>,
    tolerance: impl Given<Tolerance>,
) -> Result<BestConstant> {
    let (s, tolerance) = (UnitOrder::new(s.given()?)?, tolerance.given()?);
    match domain {
        Domain::Interval(h) => element::on_interval(h, norm, s, tolerance),
        Domain::Mesh(mesh) => mesh::on_mesh(mesh, norm, s, tolerance),
        Domain::Triangle(corners) => triangle::on_triangle(corners, norm, s, tolerance),
        _ => Err(domain.refused("interpolation", "Interval, Mesh or Triangle")),
    }
}

/// The value at x of the continuous piecewise linear function on a mesh of (0, 1).
fn linear_at(cells: &Mesh, values: &[f64], x: f64) -> Option<f64> {
    let cell = cell_of(cells, x)?;
    let t = (x - cells.from_left()[cell]) / cells.lengths()[cell];
    Some(values[cell] * (1.0 - t) + values[cell + 1] * t)
}

/// The cell of a mesh of (0, 1) that contains x.
fn cell_of(cells: &Mesh, x: f64) -> Option<usize> {
    let is_inside = (0.0..=1.0).contains(&x);
    let after = cells.from_left().partition_point(|&node| node <= x);
    is_inside.then(|| after.clamp(1, cells.len()) - 1)
}
