//! (3.6), (3.10), (4.12), (E3): lower and upper bounds of the constants of H^ν(0,1) ⊂ L^q(0,1) and of
//! H^{3/2}(0,1) ⊂ C^{0,α}.

mod hoelder;
mod trial;
mod upper;

use super::linear_at;
use crate::Order;
use crate::constant::BestConstant;
use crate::error::{Error, Given, Result};
use crate::estimate::{Estimate, Tolerance};
use crate::order::SobolevOrder;
use hoelder::EndIncrements;
use trial::EmbeddingSpace;
use upper::upper_bound;

/// The space into which H^s(0, 1) is embedded. A plain number q denotes L^q.
///
/// ```
/// use fractional_sobolev::{Target, embedding_bound};
/// // Hölder's inequality: C(1/2) ≤ C(q) with q = 1/(1 − 1/2)
/// let upper = |s: f64, into| embedding_bound(s, into).map(|found| found.upper);
/// assert_eq!(upper(1.5, Target::Hoelder(0.5))?, upper(0.5, Target::Lq(2.0))?);
/// assert_eq!(embedding_bound(0.5, 2.0)?.constant.value, 1.0);
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Target {
    /// The space L^q(0, 1).
    Lq(f64),
    /// The space C^{0,α}\[0, 1\], with the seminorm sup |u(x) − u(y)|/|x − y|^α.
    Hoelder(f64),
}

impl Given<Target> for Target {
    fn given(self) -> Result<Target> {
        Ok(self)
    }
}

impl Given<Target> for f64 {
    fn given(self) -> Result<Target> {
        Ok(Target::Lq(self))
    }
}

/// The embeddings for which there is a method.
#[derive(Clone, Copy)]
enum Embedding {
    Lq(Order, f64),
    Hoelder(f64),
}

impl Embedding {
    fn new(s: SobolevOrder, into: Target) -> Result<Self> {
        match (s, into) {
            (SobolevOrder::Fractional(order), Target::Lq(q)) => {
                upper::check(order, q).map(|()| Self::Lq(order, q))
            }
            (SobolevOrder::OnePlus(Order::HALF), Target::Hoelder(alpha)) => {
                Error::require("alpha", alpha, "(0, 1)", alpha > 0.0 && alpha < 1.0)
                    .map(Self::Hoelder)
            }
            _ => Err(Error::Incompatible {
                what: "embedding into",
                given: format!("{into:?}"),
                with: "this order",
                expected: "Lq with 0 < s <= 1/2 or Hoelder with s = 3/2",
            }),
        }
    }

    /// The quotient of u = 1.
    fn of_one(self) -> f64 {
        match self {
            Self::Lq(..) => 1.0,
            Self::Hoelder(_) => 0.0,
        }
    }

    fn bound(self) -> Result<Estimate> {
        match self {
            Self::Lq(order, q) => upper_bound(order, q),
            // |∫ v| ≤ |x−y|^{1−1/q} ‖v‖_q, and |x−y| ≤ 1 for q < 2
            Self::Hoelder(alpha) => upper_bound(Order::HALF, (1.0 - alpha).recip().max(2.0)),
        }
    }
}

/// The best constant between quick bounds: C in ‖u‖_q ≤ C ‖u‖_s for all u ∈ H^s(0, 1), 0 < s ≤ 1/2, 2 ≤ q ≤ 2/(1−2s), q ≤ 1e6, or,
/// with s = 3/2, in |u(x) − u(y)| ≤ C |x − y|^α ‖u‖\_{3/2}, 0 < α ≤ 1 − 1e-6. `upper`, rounded up, is that of
/// [`embedding_constant`]: max_k (m_k/w_k)^{1/2} over the Fourier index k, with m_k, w_k in closed form; `lower` is the
/// quotient of u = 1, which is 1 (0 for the Hölder constant).
///
/// ```
/// let upper = fractional_sobolev::embedding_bound(0.5, 100.0)?.upper;
/// assert!(upper.is_some_and(|upper| (upper.value - 3.532_235).abs() < 1e-6));
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
///
/// # Errors
/// [`Error::OutOfRange`] and [`Error::Incompatible`] for all other embeddings.
#[doc(alias("Sobolev inequality"))]
pub fn embedding_bound(
    s: impl Given<SobolevOrder>,
    into: impl Given<Target>,
) -> Result<BestConstant> {
    let embedding = Embedding::new(s.given()?, into.given()?)?;
    let (lower, upper) = (embedding.of_one(), embedding.bound()?);
    BestConstant::between(lower, upper.value, upper.work)
}

/// The best constant in ‖u‖_q ≤ C ‖u‖_s for all u ∈ H^s(0, 1), with the full norm (1.1), 0 < s ≤ 1/2, 2 ≤ q ≤
/// 2/(1−2s), q ≤ 1e6; or, with s = 3/2, in |u(x) − u(y)| ≤ C |x − y|^α ‖u‖\_{3/2}, 0 < α ≤ 1 − 1e-6.
///
/// `lower` is computed to the tolerance, `upper` is rounded up; `constant` is the midpoint of the interval
/// between them, whose width does not depend on the tolerance: the best constant is known only if `upper` is
/// 1, the quotient of u = 1. At s = 1/2 both bounds grow like √q, `lower` like (3/(4π²e))^{1/2} √q = 0.1672
/// √q, `upper` like (q/8)^{1/2}.
///
/// # Method
///
/// For s = 1/2 the range of q is 2 ≤ q < ∞. C ≥ 1, as u = 1 shows.
///
/// **Lower bound.** Piecewise linear functions on a mesh graded geometrically towards 0 and the iteration u ←
/// B⁻¹ ∫ |u|^{q−2} u φ_i, φ_i the hat functions and B the matrix of ‖·‖²_s, which increases the quotient. For
/// the Hölder constant, the largest value over the nodes θ of θ^{−α} times the norm of the functional v ↦
/// ∫₀^θ v, v = u'. Cost: O(N³) once, N a few hundred to about a thousand, and O(N²) per step; the factorized
/// matrix of the last order is cached.
///
/// **Upper bound.** Let c_k be the Fourier coefficients of the even reflection of u to a circle. The double integral
/// on the circle has a closed form, so that ‖u‖²_s ≥ Σ w_k |c_k|² with explicit w_k, and Beckner's sharp
/// inequality (Ann. of Math. 138 (1993) 213-242) is ‖u‖²_q ≤ Σ m_k |c_k|² with explicit m_k: C² ≤ max_k
/// m_k/w_k. For the Hölder constant C(α), Hölder's inequality gives C(α) ≤ C(q), q = max(2, 1/(1−α)), C(q)
/// the constant of s = 1/2. Cost: one pass over k.
///
/// ```
/// use fractional_sobolev::{Target, embedding_constant};
/// let found = embedding_constant(0.5, 24.0, 1e-8)?; // ‖u‖_{L^24} ≤ C ‖u‖_{1/2}
/// assert!(found.lower.value > 1.07 && found.upper.is_some_and(|upper| upper.value < 1.71));
/// let u = found.extremal()?;
/// assert!(u.value(&[0.0]) > 2.0 * u.value(&[1.0]));
/// assert_eq!(embedding_constant(0.25, 4.0, 1e-8)?.constant.value, 1.0); // attained by u = 1
/// let hoelder = embedding_constant(1.5, Target::Hoelder(0.9), 1e-8)?;
/// assert!(hoelder.upper.is_some_and(|upper| hoelder.lower.value < upper.value));
/// # Ok::<(), fractional_sobolev::Error>(())
/// ```
///
/// # Errors
/// [`Error::OutOfRange`] and [`Error::Incompatible`] for another embedding; [`Error::ToleranceNotMet`] if the norms
/// of `lower` do not meet the tolerance.
#[doc(alias("Sobolev embedding", "Sobolev inequality"))]
pub fn embedding_constant(
    s: impl Given<SobolevOrder>,
    into: impl Given<Target>,
    tolerance: impl Given<Tolerance>,
) -> Result<BestConstant> {
    let (embedding, tolerance) = (Embedding::new(s.given()?, into.given()?)?, tolerance.given()?);
    let upper = embedding.bound()?;
    match embedding {
        Embedding::Lq(order, q) => {
            let found = EmbeddingSpace::of(order, q)?.climb(q, tolerance)?;
            let between = between(found.quotient, upper)?;
            Ok(BestConstant::new(between, found.quotient, Some(upper)).with_extremal(
                move |point| {
                    let value = |&x: &f64| linear_at(&found.mesh, &found.values, x);
                    point.first().and_then(value).unwrap_or(f64::NAN)
                },
            ))
        }
        Embedding::Hoelder(alpha) => {
            let mesh = trial::graded((1.0 - alpha).recip())?;
            let (lower, _) = EndIncrements::on(&mesh)?.constant(alpha)?;
            Ok(BestConstant::new(between(lower, upper)?, lower, Some(upper)))
        }
    }
}

/// The interval between two bounds as an estimate; the upper bound if it is 1, which is attained.
fn between(lower: Estimate, upper: Estimate) -> Result<Estimate> {
    let work = lower.work + upper.work;
    if upper.value <= 1.0 && lower.value + lower.error >= upper.value {
        return Estimate::new(upper.value, 0.0, work);
    }
    let [low, high] = [lower.value - lower.error, upper.value];
    Estimate::new(0.5 * (low + high), 0.5 * (high - low), work)
}
