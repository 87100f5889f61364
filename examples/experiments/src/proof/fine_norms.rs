//! Seminorms of a solution that is not known, from its discrete solutions on three fine meshes of the unit
//! square.
//!
//! * |∇u|_s, s = τ − 1: of the recovered gradient [`recovered_gradients`], a continuous piecewise linear
//!   field, all components together, by [`Gram`]; at τ = 2 ‖D²u‖ as the L² norm of its gradient.
//! * |σ_N|_ν, |u_N'|_ν, ν = τ − 3/2, on the edge: of the piecewise linear functions through contact forces
//!   over lengths and through means of the slopes on both sides; linear continuation at both ends.
//!
//! For u just in H^σ, σ > τ, what a mesh does not resolve at the roughest point is of size h^{2(σ−τ)} in the
//! squares, as are errors of order h at the boundary for σ ≤ 5/2. With that power the squares on two meshes
//! have a limit; the error is what the limit differs from that of the coarser two, and half of what it is
//! away from the finest. An estimate, not a bound.

use crate::ErrorExt;
use fractional_sobolev::{Estimate, Gram, Mesh, Order, Tolerance, Work};
use signorini::contact::{ContactProblem, ContactSolution};
use signorini::fem::gradients;
use signorini::mesh::Triangulation;
use signorini::{Error, Result, ToolkitError};

/// Of the kernels.
const ACCURACY: f64 = 1e-6;
/// Beyond this regularity errors at the boundary count.
const SMOOTHEST: f64 = 2.5;
/// Part of the step from the finest mesh to the limit that may be wrong.
const TRUST: f64 = 0.5;

/// The seminorms that the theorem with numbers needs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FineNorms {
    /// |∇u|_{τ−1}, ‖D²u‖ at τ = 2.
    pub body: Estimate,
    /// |σ_N|_ν.
    pub pressure: Estimate,
    /// |u_N'|_ν.
    pub slope: Estimate,
}

/// The forms for one τ on the grid of n × n squares.
pub struct FineForms {
    n: usize,
    /// None at τ = 2.
    body: Option<Gram>,
    edge: Gram,
}

impl FineForms {
    /// For 3/2 < τ ≤ 2.
    ///
    /// # Errors
    /// [`ToolkitError::OutOfRange`](signorini::ToolkitError::OutOfRange) for another τ; as [`Gram::on_grid`].
    pub fn new(tau: f64, n: usize) -> Result<Self> {
        ToolkitError::require("tau", tau, "(3/2, 2]", tau > 1.5 && tau <= 2.0)?;
        let (asked, h) = (Tolerance::new(ACCURACY)?, 1.0 / n as f64);
        let body =
            if tau == 2.0 { None } else { Some(Gram::on_grid([n, n], h, Order::new(tau - 1.0)?, asked)?) };
        let edge = Gram::new(&Mesh::uniform(n, 1.0)?, Order::half_plus(tau - 2.0)?, asked)?;
        Ok(Self { n, body, edge })
    }

    /// |∇u|², |σ_N|², |u_N'|² of a discrete solution on the same grid.
    ///
    /// # Errors
    /// [`ToolkitError::LengthMismatch`](signorini::ToolkitError::LengthMismatch) for another mesh.
    pub fn squares(&self, problem: &ContactProblem, solution: &ContactSolution) -> Result<[f64; 3]> {
        let edge = |values: &[f64]| -> Result<f64> { Ok(product(&self.edge.apply(values)?, values)) };
        let pressure = &solution.pressure;
        let pressure = continued(pressure[1..pressure.len() - 1].to_vec())
            .into_iter()
            .map(|p| p.max(0.0))
            .collect::<Vec<_>>();
        let u = &solution.normal_displacement;
        let cells: Vec<f64> = u.windows(2).map(|pair| (pair[1] - pair[0]) * self.n as f64).collect();
        let slope = continued(cells.windows(2).map(|pair| 0.5 * (pair[0] + pair[1])).collect());
        Ok([self.body(problem, &solution.displacement)?, edge(&pressure)?, edge(&slope)?])
    }

    fn body(&self, problem: &ContactProblem, displacement: &[f64]) -> Result<f64> {
        let (mesh, c) = (problem.mesh(), problem.form().components());
        let row = self.n + 1;
        // Nodes of a refined mesh come in any order, those of the grid row by row.
        let place = |[x, y]: [f64; 2]| {
            let [i, j] = [x, y].map(|t| (t * self.n as f64).round() as usize);
            j * row + i
        };
        let mut sum = 0.0;
        for axis in 0..c {
            let values: Vec<f64> = displacement.iter().skip(axis).step_by(c).copied().collect();
            let recovered = recovered_gradients(mesh, &values)?;
            for d in 0..2 {
                let component: Vec<f64> = recovered.iter().map(|gradient| gradient[d]).collect();
                sum += match &self.body {
                    None => {
                        let squares = gradients(mesh, &component)?.into_iter().map(|[x, y]| x * x + y * y);
                        squares.sum::<f64>() / mesh.triangles().len() as f64
                    }
                    Some(form) => {
                        let mut grid = vec![0.0; row * row];
                        for (value, &node) in component.iter().zip(mesh.nodes()) {
                            grid[place(node)] = *value;
                        }
                        product(&form.apply(&grid)?, &grid)
                    }
                };
            }
        }
        Ok(sum)
    }
}

impl FineNorms {
    /// From the squares on meshes of size 4h, 2h, h and the supremum of the σ with u ∈ H^σ.
    ///
    /// # Errors
    /// [`ToolkitError::InfiniteNorm`](signorini::ToolkitError::InfiniteNorm) for τ ≥ σ.
    pub fn extrapolated(tau: f64, smoothness: f64, squares: &[[f64; 3]; 3]) -> Result<Self> {
        if tau >= smoothness {
            let why = "the solution is rougher at one of its corners or transitions";
            return Err(Error::Toolkit(ToolkitError::InfiniteNorm { order: tau, why }));
        }
        let ratio = (2.0 * (smoothness.min(SMOOTHEST) - tau)).exp2();
        let one = |k: usize| -> Result<Estimate> {
            let [coarse, middle, fine] = squares.map(|level| level[k]);
            let limit = |before: f64, last: f64| last + (last - before) / (ratio - 1.0);
            let (before, last) = (limit(coarse, middle), limit(middle, fine));
            let error = (last - before).abs() + TRUST * (last - fine).abs();
            Ok(Estimate::new(last.max(0.0), error, Work::default())?.sqrt()?)
        };
        Ok(Self { body: one(0)?, pressure: one(1)?, slope: one(2)? })
    }
}

/// Values at inner nodes, with linear continuation to both ends.
fn continued(inner: Vec<f64>) -> Vec<f64> {
    let last = inner.len() - 1;
    let ends = [(0, 1.min(last)), (last, last.saturating_sub(1))];
    let [first, end] = ends.map(|(near, far)| 2.0 * inner[near] - inner[far]);
    [&[first], inner.as_slice(), &[end]].concat()
}

fn product(image: &[f64], values: &[f64]) -> f64 {
    image.iter().zip(values).map(|(a, b)| a * b).sum::<f64>().max(0.0)
}

/// Nodal values of a continuous piecewise linear field: at each node the mean of ∇v over the triangles there,
/// weighted by area; for scalar nodal values. On uniform meshes of order h² inside and h at the boundary.
///
/// Reference: M. Zlámal, Some superconvergence results in the finite element method, LNM 606 (1977) 353-362.
///
/// # Errors
/// As [`gradients`].
fn recovered_gradients(mesh: &Triangulation, values: &[f64]) -> Result<Vec<[f64; 2]>> {
    let mut sums = vec![([0.0; 2], 0.0); mesh.nodes().len()];
    for (t, gradient) in gradients(mesh, values)?.into_iter().enumerate() {
        let [a, b, c] = mesh.corners(t);
        let area = 0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]));
        for node in mesh.triangles()[t] {
            let (sum, weight) = &mut sums[node];
            (0..2).for_each(|d| sum[d] += area * gradient[d]);
            *weight += area;
        }
    }
    // A node of no triangle has no gradient.
    Ok(sums.into_iter().map(|(sum, w)| if w > 0.0 { sum.map(|s| s / w) } else { sum }).collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use signorini::mesh::{SideParts, unit_square};

    #[test]
    fn gradients_of_quadratic_functions_are_exact_inside() {
        let mesh = unit_square(8, SideParts::HANGING).unwrap();
        let values: Vec<f64> = mesh.nodes().iter().map(|[x, y]| x * x - 3.0 * x * y + 0.5 * y).collect();
        for (found, [x, y]) in recovered_gradients(&mesh, &values).unwrap().iter().zip(mesh.nodes()) {
            let exact = [2.0 * x - 3.0 * y, 0.5 - 3.0 * x];
            let apart = (found[0] - exact[0]).hypot(found[1] - exact[1]);
            let is_inside = [x, y].iter().all(|c| **c > 0.0 && **c < 1.0);
            assert!(apart < if is_inside { 1e-13 } else { 0.4 }, "{x} {y}: {apart}");
        }
    }
}
