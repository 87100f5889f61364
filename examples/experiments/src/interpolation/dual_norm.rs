//! The dual norm of (4.7): ‖f‖\_{1/2,*} = sup ∫ f ψ / ‖ψ‖\_{1/2} over ψ ∈ H^{1/2}(I), with the full norm
//! (1.1), on one mesh for many f. The toolkit's dual norms are in [`fractional_sobolev::Function::norm`].

use crate::scale::unit_of;
use fractional_sobolev::Mesh;
use fractional_sobolev::gauss_legendre;
use fractional_sobolev::{Error, Result};
use fractional_sobolev::{Estimate, Work};
use fractional_sobolev::{Gram, Order};
use nalgebra::Cholesky;
use nalgebra::DMatrix;
use nalgebra::Dyn;

/// Gauss points per cell: f is smooth on each.
const POINTS: usize = 8;

/// Largest number of cells for which dense matrices are built.
const MAX_CELLS: usize = 4096;

/// Rounding of the solve, relative.
const ROUNDING: f64 = 1e-12;

/// ‖·‖_{1/2,*} on the cells of an interval, factorized once.
///
/// # Method
///
/// Over the continuous piecewise linears ψ on given cells the supremum is (bᵀ (A + M)⁻¹ b)^{1/2}, b_i = ∫ f
/// ψ_i: a lower bound that rises as the cells are refined. The representer is in H¹ for f ∈ L², so halving
/// the cells at least halves what is missing of the square; the difference from the cells twice as long is
/// the error estimate. Cost O(N³).
#[derive(Debug, Clone)]
pub(crate) struct DualNorm {
    cells: Mesh,
    fine: Solver,
    /// On the cells joined in pairs.
    coarse: Solver,
}

/// A + M + m mᵀ/|I|², factorized, and m, the integrals of the hats.
///
/// The representer of 1 is 1, so f splits into its mean f̄ and a rest whose representer has mean zero and
/// does not see m mᵀ, ‖f‖² = |I| f̄² + ‖f − f̄‖². On an interval as short as 1e-100, A + M alone is singular
/// to rounding.
#[derive(Debug, Clone)]
struct Solver {
    factor: Cholesky<f64, Dyn>,
    integrals: Vec<f64>,
}

impl DualNorm {
    /// On an even number of cells.
    ///
    /// # Errors
    /// [`Error::CountOutOfRange`] for an odd number of cells or more than 4096 (the matrices are dense).
    pub(crate) fn new(cells: &Mesh) -> Result<Self> {
        let count = cells.len();
        if !count.is_multiple_of(2) || count > MAX_CELLS {
            return Err(Error::CountOutOfRange { name: "cells", value: count, range: "even, <= 4096" });
        }
        let pairs = cells.lengths().chunks(2).map(|pair| pair.iter().sum()).collect();
        let coarse = Solver::new(&Mesh::from_lengths(pairs)?)?;
        Ok(Self { cells: cells.clone(), fine: Solver::new(cells)?, coarse })
    }

    /// The cells.
    pub(crate) fn cells(&self) -> &Mesh {
        &self.cells
    }

    /// ‖f‖_{1/2,*} for f smooth on each cell; f is called with a cell and the local coordinate in (0, 1).
    ///
    /// # Errors
    /// [`Error::NotFinite`] for a value of f or a norm beyond the range of binary64.
    pub(crate) fn of(&self, f: impl Fn(usize, f64) -> f64) -> Result<Estimate> {
        let rule = gauss_legendre(POINTS)?;
        let count = self.cells.len();
        let values: Vec<f64> =
            (0..count).flat_map(|i| rule.iter().map(move |(t, _)| (i, t))).map(|(i, t)| f(i, t)).collect();
        require_finite("function", &values)?;
        // In units of the largest value: products with the lengths of the cells must not underflow.
        let unit = unit_of(&values);
        let mut load = vec![0.0; count + 1];
        for (i, (&h, values)) in
            self.cells.lengths().iter().zip(values.chunks(rule.points().len())).enumerate()
        {
            for ((t, w), value) in rule.iter().zip(values) {
                load[i] += h * w * (value / unit) * (1.0 - t);
                load[i + 1] += h * w * (value / unit) * t;
            }
        }
        times(self.of_load(&load)?, unit)
    }

    /// ‖f‖\_{1/2,*} from the integrals b_i = ∫ f ψ_i of f against the hats of all nodes.
    ///
    /// # Errors
    /// [`Error::LengthMismatch`] unless there is an integral per node, [`Error::NotFinite`] for a bad one.
    pub(crate) fn of_load(&self, load: &[f64]) -> Result<Estimate> {
        let count = self.cells.len();
        require_length("load", load.len(), count + 1)?;
        require_finite("load", load)?;
        let unit = unit_of(load);
        let load: Vec<f64> = load.iter().map(|b| b / unit).collect();
        let fine = self.fine.squared(&load);
        let coarse = self.coarse.squared(&self.load_on_pairs(&load));
        let value = fine.sqrt();
        let missing = (fine - coarse).max(0.0);
        // The mean is rounded; on a short interval it weighs far more than what is left of f.
        let absolute: f64 = load.iter().map(|b| b.abs()).sum();
        let rounding = ROUNDING * value + 4.0 * f64::EPSILON * absolute / self.cells.total().sqrt();
        let work = Work { points: (POINTS * count) as u64, factorizations: 2, ..Work::default() };
        times(Estimate::new(value, (fine + missing).sqrt() - value + rounding, work)?, unit)
    }

    /// A hat on joined cells is a hat plus parts of its two neighbours.
    fn load_on_pairs(&self, load: &[f64]) -> Vec<f64> {
        let mut joined: Vec<f64> = load.iter().step_by(2).copied().collect();
        for (k, pair) in self.cells.lengths().chunks(2).enumerate() {
            let middle = load[2 * k + 1] / (pair[0] + pair[1]);
            joined[k] += middle * pair[1];
            joined[k + 1] += middle * pair[0];
        }
        joined
    }
}

fn require_length(name: &'static str, given: usize, expected: usize) -> Result<()> {
    if given == expected { Ok(()) } else { Err(Error::LengthMismatch { name, given, expected }) }
}

fn require_finite(name: &'static str, values: &[f64]) -> Result<()> {
    match values.iter().enumerate().find(|(_, value)| !value.is_finite()) {
        Some((index, &value)) => Err(Error::NotFinite { name, index, value }),
        None => Ok(()),
    }
}

/// Integrals of the hats over the interval, for all nodes.
fn hat_integrals(cells: &Mesh) -> Vec<f64> {
    let mut integrals = vec![0.0; cells.len() + 1];
    for (i, h) in cells.lengths().iter().enumerate() {
        integrals[i] += 0.5 * h;
        integrals[i + 1] += 0.5 * h;
    }
    integrals
}

/// Gram matrix of L².
fn mass_form(cells: &Mesh) -> DMatrix<f64> {
    let mut mass = DMatrix::zeros(cells.len() + 1, cells.len() + 1);
    for (i, &h) in cells.lengths().iter().enumerate() {
        for (row, column, share) in [(i, i, 3.0), (i + 1, i + 1, 3.0), (i, i + 1, 6.0), (i + 1, i, 6.0)] {
            mass[(row, column)] += h / share;
        }
    }
    mass
}

/// The norm in a unit, restored; what falls below the range of binary64 is 0 with an error above 0.
fn times(norm: Estimate, unit: f64) -> Result<Estimate> {
    let smallest = if norm.value > 0.0 { f64::MIN_POSITIVE } else { 0.0 };
    Estimate::new(unit * norm.value, unit * norm.error + smallest, norm.work)
}

impl Solver {
    fn new(cells: &Mesh) -> Result<Self> {
        let integrals = hat_integrals(cells);
        let total = cells.total();
        let norm = Gram::new(cells, Order::HALF, 1e-8)?.to_dense()? + mass_form(cells);
        let size = integrals.len();
        let fixed = DMatrix::from_fn(size, size, |i, j| {
            norm[(i, j)] + (integrals[i] / total) * (integrals[j] / total)
        });
        let broken = || Error::NotPositiveDefinite { what: "Gram matrix of the H^{1/2} norm", pivot: size };
        Ok(Self { factor: Cholesky::new(fixed).ok_or_else(broken)?, integrals })
    }

    /// The squared dual norm of a load.
    fn squared(&self, load: &[f64]) -> f64 {
        let total: f64 = self.integrals.iter().sum();
        let mean = load.iter().sum::<f64>() / total;
        let rest = DMatrix::from_fn(load.len(), 1, |i, _| load[i] - mean * self.integrals[i]);
        let representer = self.factor.solve(&rest);
        let of_rest: f64 = (0..load.len()).map(|i| rest[(i, 0)] * representer[(i, 0)]).sum();
        mean * total * mean + of_rest
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use fractional_sobolev::Function;

    #[test]
    fn the_dual_norm_of_a_constant_is_the_constant() {
        for cells in [Mesh::uniform(8, 1.0).unwrap(), Mesh::graded(&[0.0, 1.0], 4, 0.3).unwrap()] {
            let norm = DualNorm::new(&cells).unwrap().of(|_, _| -3.0).unwrap();
            assert!((norm.value - 3.0).abs() < 1e-12, "{norm}");
            assert!(norm.error < 1e-10);
        }
        assert!(DualNorm::new(&Mesh::uniform(3, 1.0).unwrap()).is_err());
        let norm = DualNorm::new(&Mesh::uniform(2, 1.0).unwrap()).unwrap();
        assert!(norm.of(|_, _| f64::NAN).is_err() && norm.of_load(&[1.0]).is_err());
    }

    #[test]
    fn refinement_stays_within_the_error() {
        let norm = |n: usize| {
            let cells = Mesh::uniform(n, 1.0).unwrap();
            DualNorm::new(&cells).unwrap().of(|i, t| (3.0 * (i as f64 + t) / n as f64).sin()).unwrap()
        };
        let finest = norm(256);
        for n in [8, 16, 32, 64] {
            let coarse = norm(n);
            let missing = finest.value - coarse.value;
            assert!((0.0..=coarse.error).contains(&missing), "{n}: {coarse} against {finest}");
        }
    }

    /// Lengths and heights.
    const SIZES: [(f64, f64); 15] = [
        (1e-100, 1.0),
        (1e100, 1.0),
        (1.0, 1e-100),
        (1.0, 1e100),
        (1e-60, 1e60),
        (1e-150, 1.0),
        (1e150, 1.0),
        (1e-300, 1.0),
        (1e300, 1.0),
        (1.0, 1e-160),
        (1.0, 1e160),
        (1.0, 1e-300),
        (1.0, 1e300),
        (1e-300, 1e-300),
        (1e300, 1e300),
    ];

    #[test]
    fn dual_norms_keep_their_digits_at_any_size() {
        for (length, height) in SIZES {
            let cells = Mesh::uniform(8, length).unwrap();
            let dual = DualNorm::new(&cells).unwrap();
            // The dual norm of a constant v on an interval of length h is v h^{1/2}.
            let (constant, exact) = (dual.of(|_, _| height), height * length.sqrt());
            if exact.is_finite() {
                let constant = constant.unwrap();
                let error = (constant.value - exact).abs();
                // Below the range of binary64 the answer is 0 or subnormal, within its error.
                assert!(
                    error <= 1e-10 * exact + constant.error,
                    "h {length} height {height}: {constant} {exact}"
                );
                assert!(constant.error <= 1e-10 * exact + 1e-307, "h {length} height {height}: {constant}");
            } else {
                assert!(matches!(constant, Err(Error::NotFinite { .. })), "{constant:?}");
            }
            // A sawtooth of mean zero scales like v h on a short interval; the rounding of its mean weighs
            // h^{-1/2} times more.
            if length <= 1e-60 && length * height > 1e-290 {
                let saw = |dual: &DualNorm, unit: f64| {
                    dual.of(|i, _| if i % 2 == 0 { unit } else { -unit }).unwrap()
                };
                let moderate = DualNorm::new(&Mesh::uniform(8, 2f64.powi(-20)).unwrap()).unwrap();
                let reference = saw(&moderate, 1.0).value * 2f64.powi(20) * height * length;
                let found = saw(&dual, height);
                assert!(
                    (found.value - reference).abs() <= 1e-4 * reference + found.error,
                    "h {length}: {found}"
                );
            }
        }
    }

    #[test]
    fn what_cannot_be_held_is_refused() {
        assert!(matches!(
            DualNorm::new(&Mesh::uniform(5000, 1.0).unwrap()),
            Err(Error::CountOutOfRange { .. })
        ));
        let dual = DualNorm::new(&Mesh::uniform(2, 1e-100).unwrap()).unwrap();
        // On an interval of length h the dual norm of 1 is h^{1/2}.
        let norm = dual.of(|_, _| 1.0).unwrap();
        assert!((norm.value / 1e-50 - 1.0).abs() < 1e-10, "{norm}");
        assert!(dual.of(|_, _| f64::INFINITY).is_err());
    }

    #[test]
    fn the_solve_agrees_with_the_one_on_any_mesh() {
        // The same functional through a solve with the fast operator.
        let cells = Mesh::uniform(256, 1.0).unwrap();
        let load: Vec<f64> = (0..=256).map(|i| f64::from((37 * i) % 101) / 101.0 - 0.3).collect();
        let dense = DualNorm::new(&cells).unwrap().of_load(&load).unwrap();
        let other = Function::load(&cells, &load).unwrap().norm(-0.5, 1e-8).unwrap();
        assert!((dense.value / other.value - 1.0).abs() < 1e-8, "{dense} {other}");
    }
}
