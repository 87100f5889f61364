//! The consistency terms of Sections 3 and 4 for the exact data of a test problem, on all grids coarser than that of
//! the data.
//!
//! Both depend only on the exact u_N and σ_N = −λ; no discrete problem is solved:
//!
//! * nodal cone: ∫ σ_N (I^h u)_N dΓ = −Σ_j (P'λ)_j u_N(x_j), P' the restriction of forces to the coarse
//!   nodes;
//! * midpoint cone: ∫ (σ_N − π^h σ_N)(π^h u_N − u_N) dΓ = −Σ_T (1/h_e) ∫_T λ ∫_T u_N, h_e the length of the
//!   segment T, because λ u_N = 0.
//!
//! Both are sums of nonnegative terms. Cost: O(N) for all grids together.

use crate::cone::Cone;
use crate::strip::{EdgeData, LateralCondition, restrict};

/// The consistency terms on N/2, N/4, ... cells, as pairs (cells, term), finest grid first; N is the number of cells
/// of the data, and the sequence ends at 2 or at the first odd number of cells.
///
/// No discrete problem is solved. The nodal term vanishes on every grid that has the transitions among its nodes.
///
/// ```
/// use signorini::{cone::Cone, edge::consistency_terms, problems::StripData, strip::LateralCondition};
/// let data = StripData::Transitions { gaps: 4 }.data(1.75, 1 << 8, LateralCondition::Periodic)?;
/// let terms = consistency_terms(&data, Cone::Nodal);
/// assert!(terms.iter().all(|&(_, term)| term >= 0.0));
/// assert!(terms.contains(&(16, 0.0)) && !terms.contains(&(8, 0.0)));
/// # Ok::<(), signorini::Error>(())
/// ```
pub fn consistency_terms(edge_data: &EdgeData, cone: Cone) -> Vec<(usize, f64)> {
    match cone {
        Cone::Nodal => nodal(edge_data),
        Cone::Midpoint => midpoint(edge_data),
    }
}

/// N/2, N/4, ..., 2, as long as the number is even.
fn halvings(cells: usize) -> impl Iterator<Item = usize> {
    std::iter::successors(Some(cells), |&n| (n % 2 == 0 && n > 2).then_some(n / 2)).skip(1)
}

/// −Σ_j (P'λ)_j u_N(x_j) on each grid: the coarse forces follow from the finer ones by λ_j + (λ_{j−1} + λ_{j+1})/2, the
/// coarse values by injection.
fn nodal(edge_data: &EdgeData) -> Vec<(usize, f64)> {
    let mut forces = edge_data.forces().to_vec();
    halvings(edge_data.cells())
        .map(|cells| {
            forces = restrict(&forces, edge_data.sides());
            let stride = edge_data.cells() / cells;
            let values = edge_data.values().iter().step_by(stride);
            (cells, forces.iter().zip(values).fold(0.0, |sum, (force, value)| sum - force * value))
        })
        .collect()
}

/// (1/h) Σ_T (∫_T λ)(−∫_T u_N) on each grid: both integrals over a coarse cell are the sums over its two halves.
fn midpoint(edge_data: &EdgeData) -> Vec<(usize, f64)> {
    let (values, forces, sides) = (edge_data.values(), edge_data.forces(), edge_data.sides());
    let next = |i: usize| if i + 1 < values.len() { i + 1 } else { 0 };
    let h = 1.0 / edge_data.cells() as f64;
    // A force inside the edge counts half in each of its cells.
    let share = |i: usize| {
        let at_side = sides == LateralCondition::Natural && (i == 0 || i == edge_data.cells());
        forces[i] * if at_side { 1.0 } else { 0.5 }
    };
    let mut held: Vec<f64> = (0..edge_data.cells()).map(|i| share(i) + share(next(i))).collect();
    let mut open: Vec<f64> =
        (0..edge_data.cells()).map(|i| -0.5 * h * (values[i] + values[next(i)])).collect();
    halvings(edge_data.cells())
        .map(|cells| {
            for sums in [&mut held, &mut open] {
                *sums = sums.chunks(2).map(|pair| pair.iter().sum()).collect();
            }
            let products =
                held.iter().zip(&open).fold(0.0, |sum, (force, area)| sum + force * area);
            (cells, products * cells as f64)
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::problems::StripData;

    #[test]
    fn one_kink_against_the_integrals() {
        // λ = 1 left of a, u_N = −(x − a) right of it, a = 3/8 + t/8 in the cell (3/8, 1/2) of length h =
        // 1/8: nodal ½ t²(1−t) h², midpoint t · ½(1−t)² h².
        let (cells, h, t) = (1 << 16, 0.125, 0.3);
        let kind = StripData::Transition { position: 0.375 + t * h };
        let edge_data = kind.data(2.0, cells, LateralCondition::Natural).unwrap();
        // The force at the last contact node is missing: one fine cell in t h.
        let rounding = 4.0 / (t * h * cells as f64);
        for (cone, exact) in [
            (Cone::Nodal, 0.5 * t * t * (1.0 - t) * h * h),
            (Cone::Midpoint, 0.5 * t * (1.0 - t).powi(2) * h * h),
        ] {
            let terms = consistency_terms(&edge_data, cone);
            let (_, term) = terms[terms.iter().position(|&(n, _)| n == 8).unwrap()];
            assert!((term / exact - 1.0).abs() < rounding, "{cone}: {term} {exact}");
        }
    }
}
