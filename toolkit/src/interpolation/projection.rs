//! (4.6) and (4.7): best constants of the L² projection π^h onto piecewise constants.

use super::element::{
    converge, odd_degrees, of_mean, pointwise, require_length, seminorm_gram, stiffness_gram,
};
use super::elements::ElementMesh;
use super::extremal::largest;
use super::forms::{dual_projection_form, projection_form, seminorm_form};
use crate::constant::{BestConstant, Domain, ErrorNorm, UnitOrder};
use crate::error::{Error, Given, Result};
use crate::estimate::{Estimate, Tolerance, Work};
use crate::numeric::dense::Cholesky;
use crate::numeric::pencil::Factored;
use crate::order::SobolevOrder;
use crate::{Mesh, Order};
use nalgebra::DMatrix;
use std::f64::consts::FRAC_1_PI;

/// Number of cells per element of the first mesh.
const FIRST: usize = 4;

/// The best constant in ‖φ − π φ‖ ≤ C |φ|_s, where πφ is the mean of φ on the interval or on every element of
/// the mesh, 0 ≤ s ≤ 1; on the left the norm is the given [`ErrorNorm`]; |φ|₀ = ‖φ‖ and |φ|₁ = ‖φ'‖.
///
/// # Method
///
/// On an interval of length h, with the Legendre basis as in
/// [`interpolation_constant`](crate::interpolation_constant), γ₁ the Poincaré constant
/// [`gamma`](crate::gamma) for mean zero on (0, 1):
///
/// ```text
/// (4.6)  L2      C(s) h^s,  C(s) = γ₁(s) for 0 < s < 1, C(0) = 1, C(1) = 1/π
/// (4.7)  Dual    C*(s) h^{s+1/2},  C*(s) = sup ∫ (φ − φ̄) ψ / (|φ|_s |ψ|_{1/2}) on (0, 1)
/// (6.2)  At(x)   κ(x/h) h^{1/2},  κ(t)² = (t³ + (1−t)³)/3, for s = 1
/// ```
///
/// The dual norm on an interval is dual to the seminorm |ψ|\_{1/2}, so that (4.7) follows element by element:
/// Σ_I |·|²_{s,I} ≤ |·|²_{s,Γ}, I the elements, Γ the interval of the mesh. The square of C* is the largest
/// eigenvalue of A_{1/2}⁻¹ x = λ A_r x, A_r the matrix of
/// |·|²_s in an L²-orthonormal basis; the chain of estimates in the paper gives γ₁(s) γ₁(1/2) instead, which is equal
/// at s = 1/2.
///
/// On a mesh `Dual` is dual to the full norm (1.1) of order 1/2 on the whole interval. The value is a lower
/// bound from piecewise linear functions on cells, and the best constant exceeds it by at most `error`; the
/// matrices are dense, with at most 4096 cells. On N equal elements the constant decreases like N^{-s}, in
/// the dual norm like N^{-s-1/2}.
///
/// ```
/// use fractional_sobolev::{Domain, ErrorNorm, Mesh, projection_constant};
/// let of = |norm, s| projection_constant(Domain::Interval(1.0), norm, s, 1e-8).map(|found| found.constant.value);
/// assert!((of(ErrorNorm::L2, 1.0)? - std::f64::consts::FRAC_1_PI).abs() < 1e-15);
/// assert!((of(ErrorNorm::Dual, 0.5)? - of(ErrorNorm::L2, 0.5)?.powi(2)).abs() < 1e-8);
/// // four elements, s = 1: h/π, attained by cos(4πx)
/// let mesh = Domain::Mesh(Mesh::uniform(4, 1.0)?);
/// let found = projection_constant(mesh, ErrorNorm::L2, 1.0, 1e-3)?.constant;
/// assert!((found.value - 0.25 * std::f64::consts::FRAC_1_PI).abs() <= found.error);
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
///
/// # Errors
/// [`Error::OutOfRange`] for s outside [0, 1], a length outside [1e-150, 1e150] or a point outside the
/// interval; [`Error::Incompatible`] for another domain or norm; [`Error::CountOutOfRange`] for more than
/// 1024 elements; [`Error::ToleranceNotMet`].
#[doc(alias("L2 projection", "Poincare-Wirtinger"))]
pub fn projection_constant(
    domain: Domain,
    norm: ErrorNorm,
    s: impl Given<SobolevOrder>,
    tolerance: impl Given<Tolerance>,
) -> Result<BestConstant> {
    let (s, tolerance) = (UnitOrder::new(s.given()?)?, tolerance.given()?);
    let found = match &domain {
        Domain::Interval(h) => on_one(require_length(*h)?, norm, s, tolerance),
        Domain::Mesh(mesh) => on_mesh(mesh, norm, s, tolerance),
        _ => return Err(domain.refused("projection", "Interval or Mesh")),
    }?;
    let order = match s {
        UnitOrder::Zero => SobolevOrder::Zero,
        UnitOrder::Inner(order) => SobolevOrder::Fractional(order),
        UnitOrder::One => SobolevOrder::One,
    };
    Ok(found.with_others(move |norm| projection_constant(domain.clone(), norm, order, tolerance)))
}

fn on_one(h: f64, norm: ErrorNorm, r: UnitOrder, tolerance: Tolerance) -> Result<BestConstant> {
    let none = Work::default();
    match (norm, r) {
        (ErrorNorm::L2, UnitOrder::Zero) => Ok(BestConstant::exact(Estimate::new(1.0, 0.0, none)?)),
        (ErrorNorm::L2, UnitOrder::One) => {
            BestConstant::exact(Estimate::new(FRAC_1_PI, 0.0, none)?).times(h)
        }
        (ErrorNorm::L2, UnitOrder::Inner(order)) => of_mean(h, order, tolerance),
        (ErrorNorm::Dual, r) => {
            let factor = h.powf(r.value() + 0.5);
            let constant = dual(r, tolerance)
                .map_err(|error| error.carry("projection constant", |best| best.times(factor)))?;
            BestConstant::new(constant, constant, None).times(factor)
        }
        (ErrorNorm::At(x), UnitOrder::One) => {
            BestConstant::exact(pointwise(x / h)?).times(h.sqrt())
        }
        (ErrorNorm::At(_), _) => {
            Err(norm.refused("an order below 1", "L2 or Dual; At(x) for r = 1"))
        }
        _ => Err(norm.refused("projection", "L2, Dual or At(x)")),
    }
}

/// The constant C*(r).
fn dual(r: UnitOrder, tolerance: Tolerance) -> Result<Estimate> {
    converge("projection constant in the dual norm", tolerance, |count| {
        let degrees = odd_degrees(count);
        let (half, mut work) = seminorm_gram(Order::HALF, &degrees)?;
        let broken =
            || Error::NotPositiveDefinite { what: "Gram matrix of the seminorm", pivot: count };
        let inverse =
            Cholesky::new(&half).ok_or_else(broken)?.solve(&DMatrix::identity(count, count));
        let form = match r {
            UnitOrder::Zero => DMatrix::identity(count, count),
            UnitOrder::One => stiffness_gram(&degrees),
            UnitOrder::Inner(order) => {
                let (gram, cost) = seminorm_gram(order, &degrees)?;
                work += cost;
                gram
            }
        };
        let (top, _) = Factored::new(&form)?.largest_eigenvalue(&inverse)?;
        work.factorizations += 3;
        Ok((top.sqrt(), work))
    })
}

fn on_mesh(
    mesh: &Mesh,
    norm: ErrorNorm,
    r: UnitOrder,
    tolerance: Tolerance,
) -> Result<BestConstant> {
    let total = require_length(mesh.total())?;
    let power = match norm {
        ErrorNorm::L2 => r.value(),
        ErrorNorm::Dual => r.value() + 0.5,
        _ => return Err(norm.refused("projection on a mesh", "L2 or Dual")),
    };
    let forms = |cells: &ElementMesh| {
        let form = match norm {
            ErrorNorm::Dual => dual_projection_form(cells, total)?,
            _ => projection_form(cells),
        };
        Ok((seminorm_form(cells.cells(), r), form))
    };
    let factor = total.powf(power);
    let found = largest(mesh, FIRST, tolerance, forms)
        .map_err(|error| error.carry("projection constant", |best| best.times(factor)))?;
    let constant = found.root.times(factor)?;
    let unit = total.powf(r.value() - 0.5);
    let value = move |x: f64| super::linear_at(found.mesh.cells(), &found.values, x / total);
    Ok(BestConstant::new(constant, constant, None).with_extremal(move |point| {
        point.first().and_then(|&x| value(x)).map_or(f64::NAN, |value| unit * value)
    }))
}
