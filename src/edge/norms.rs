//! The norms on the right-hand side of the theorems, on the contact edge.
//!
//! The proofs of Sections 3 and 4 use u only through ‖u_N‖_{τ−1/2} and ‖σ_N‖_{τ−3/2} on Γ_C. For 3/2 < τ < 2 both
//! reduce to seminorms of order ν = τ − 3/2 < 1/2, of u_N' and of σ_N. The piecewise constant slopes of u_N and
//! densities of σ_N on the grid of the test problem therefore have finite norms, computed without discretisation
//! error by the Gram matrix of piecewise constants in O(N log N). Powers of regularity exactly τ are not in H^τ;
//! their norms on a grid of N cells grow like (ln N)^{1/2}.

use crate::error::Result;
use crate::strip::{EdgeData, LateralCondition};
use fractional_sobolev::{Gram, Mesh, Order, Tolerance};

/// The norms and seminorms of the data of a test problem on the contact edge.
///
/// ν = τ − 3/2; ‖u_N‖²_{τ−1/2} = ‖u_N‖₀² + ‖u_N'‖₀² + |u_N'|²_ν and ‖σ_N‖²_{τ−3/2} = ‖σ_N‖₀² + |σ_N|²_ν, with the
/// Sobolev-Slobodeckij seminorm (1.1) on the edge of length 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EdgeNorms {
    /// The norm (‖u_N‖²_{τ−1/2} + ‖σ_N‖²_{τ−3/2})^{1/2}.
    pub norm: f64,
    /// The seminorm |u_N'|_{τ−3/2}.
    pub slope: f64,
    /// The seminorm |σ_N|_{τ−3/2}.
    pub pressure: f64,
}

/// The norms and seminorms of the data, for 3/2 < τ < 2.
///
/// Each nodal force is distributed over the adjacent cells, one half to each. Cost: O(N log N) for N cells.
///
/// ```
/// use signorini::{edge::edge_norms, problems::StripData, strip::LateralCondition};
/// let data = StripData::Transition { position: 0.3 }.data(1.75, 256, LateralCondition::Natural)?;
/// let norms = edge_norms(&data, 1.75)?;
/// assert!(norms.norm.powi(2) >= norms.slope.powi(2) + norms.pressure.powi(2));
/// assert!(edge_norms(&data, 2.0).is_err());
/// # Ok::<(), signorini::Error>(())
/// ```
///
/// # Errors
/// [`ToolkitError::OutOfRange`](crate::ToolkitError::OutOfRange) for τ ≤ 3/2 and
/// τ ≥ 5/2, [`ToolkitError::InfiniteNorm`](crate::ToolkitError::InfiniteNorm) for 2 ≤ τ < 5/2, where the norm
/// of a discontinuous slope is infinite.
pub fn edge_norms(edge_data: &EdgeData, tau: f64) -> Result<EdgeNorms> {
    let order = Order::half_plus(tau - 2.0)?;
    let (values, cells) = (edge_data.values(), edge_data.cells());
    let h = 1.0 / cells as f64;
    let next = |i: usize| if i + 1 < values.len() { i + 1 } else { 0 };
    let slopes: Vec<f64> = (0..cells).map(|i| (values[next(i)] - values[i]) / h).collect();
    // One half of each nodal force belongs to each adjacent cell.
    let share = |i: usize| {
        let at_side = edge_data.sides() == LateralCondition::Natural && (i == 0 || i == cells);
        edge_data.forces()[i] * if at_side { 1.0 } else { 0.5 } / h
    };
    let densities: Vec<f64> = (0..cells).map(|i| share(i) + share(next(i))).collect();
    let gram = Gram::constants(&Mesh::uniform(cells, 1.0)?, order, Tolerance::balanced())?;
    let seminorm = |x: &[f64]| -> Result<f64> {
        Ok(gram.apply(x)?.iter().zip(x).map(|(y, x)| x * y).sum::<f64>().max(0.0))
    };
    let mass = |x: &[f64]| x.iter().map(|x| x * x * h).sum::<f64>();
    // Piecewise linear u_N: ∫ over a cell is h (a² + ab + b²)/3.
    let square = |i: usize| values[i] * values[i] + values[i] * values[next(i)] + values[next(i)].powi(2);
    let below = (0..cells).map(|i| square(i) * h / 3.0).sum::<f64>();
    let norm = (below + mass(&slopes) + seminorm(&slopes)? + mass(&densities) + seminorm(&densities)?).sqrt();
    Ok(EdgeNorms { norm, slope: seminorm(&slopes)?.sqrt(), pressure: seminorm(&densities)?.sqrt() })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::problems::TransitionPowers;
    use fractional_sobolev::Function;

    #[test]
    fn the_grid_gives_the_norm_of_the_powers() {
        // τ = 1.9 edge_data measured at 1.75: u_N = −(x − a)^{0.9}, λ = (a − x)^{−0.1}, by quadrature of the
        // functions themselves.
        let (a, tau, at) = (0.4, 1.9, 1.75);
        let order = Order::new(at - 1.5).unwrap();
        let power = |sign: f64, p: f64| {
            Function::from_positions(&[0.0, a, 1.0], move |x| {
                let d = if x.anchor() == 1 { x.offset() } else { x.x() - a };
                if sign * d > 0.0 { d.abs().powf(p) } else { 0.0 }
            })
            .unwrap()
        };
        let tolerance = Tolerance::balanced();
        // δ = d (c − d)/c with c = 2(1 − a), mirrored at the side.
        let c = 2.0 * (1.0 - a);
        let opening = |f: fn(f64, f64, f64) -> f64| {
            Function::from_positions(&[0.0, a, 1.0], move |x| {
                let d = if x.anchor() == 1 { x.offset() } else { x.x() - a };
                if d > 0.0 { f(d, c, tau) } else { 0.0 }
            })
            .unwrap()
        };
        let u = opening(|d, c, tau| (d * (c - d) / c).powf(tau - 1.0));
        let slope =
            opening(|d, c, tau| (tau - 1.0) * (d * (c - d) / c).powf(tau - 2.0) * (1.0 - 2.0 * d / c));
        let u = u.with_gradient(vec![slope]);
        let u_norm = u.norm(order.plus_one(), tolerance).unwrap().value;
        let pressure = power(-1.0, tau - 2.0).norm(order, tolerance).unwrap().value;
        let exact = u_norm.hypot(pressure);
        // What the grid does not resolve falls like N^{−2(1.9 − 1.75)} in the squares: extrapolated, the next
        // terms are left.
        let square = |cells: usize| {
            let edge_data = TransitionPowers::of_regularity(tau).data(a, cells).unwrap();
            edge_norms(&edge_data, at).unwrap().norm.powi(2)
        };
        let (coarse, fine, ratio) = (square(1 << 14), square(1 << 16), 4f64.powf(-0.3));
        let limit = ((fine - ratio * coarse) / (1.0 - ratio)).sqrt();
        assert!((limit / exact - 1.0).abs() < 5e-3, "{limit} {exact}");
        let edge_data = TransitionPowers::of_regularity(tau).data(a, 64).unwrap();
        assert!(edge_norms(&edge_data, 2.0).is_err() && edge_norms(&edge_data, 1.5).is_err());
    }
}
