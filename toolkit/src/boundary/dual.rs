//! Dual norms on polygonal curves: sup ∫_Γ f v / ||v||_ν over piecewise linear functions, and its limit under
//! mesh refinement.

use super::curve::Curve;
use super::function::BoundaryFunction;
use super::pairs::CurvePairs;
use crate::error::{Error, Result};
use crate::estimate::{Estimate, SPENT, Tolerance, Work};
use crate::numeric::dense::Cholesky;
use crate::numeric::parallel;
use crate::order::Order;
use nalgebra::DMatrix;

/// Largest number of elements of the finest mesh: about a second of kernel evaluations and a dense
/// factorization.
const MOST: usize = 1500;
/// Relative accuracy of the matrix entries.
const ENTRIES: f64 = 1e-13;
/// Relative rounding error of the factorization.
const ROUNDING: f64 = 1e-12;
/// Message: what limits the accuracy.
const LIMIT: &str =
    "1500 elements do not suffice: grade the mesh towards the corners and the jumps";

impl BoundaryFunction {
    /// The norm of H^{−ν}(Γ), sup ∫_Γ f v / ||v||_ν over v ∈ H^ν(Γ), in which normal derivatives and boundary
    /// densities are measured.
    ///
    /// # Method
    ///
    /// On a mesh the supremum over continuous piecewise linear functions is √(bᵀ(M+A)⁻¹b), a lower bound,
    /// computed by one dense factorization. The mesh is bisected up to 1500 elements. If the increments d_k
    /// shrink by a factor r, the limit is extrapolated as v_k + d_k r/(1−r); its error is its last change, or
    /// its distance to v_k if only one limit is available. Meshes graded towards the corners and the jumps of f
    /// give more digits.
    ///
    /// # Errors
    /// [`Error::CountOutOfRange`] for more than 1500 elements, [`Error::NotPositiveDefinite`],
    /// [`Error::ToleranceNotMet`] with the best value.
    pub(super) fn dual_of_slobodeckij(
        &self,
        order: Order,
        tolerance: Tolerance,
    ) -> Result<Estimate> {
        if self.curve().len() > MOST {
            let (name, range) = ("elements of a dual norm", "[1, 1500]");
            return Err(Error::CountOutOfRange { name, value: self.curve().len(), range });
        }
        let mut ends = self.ends().to_vec();
        limit_of_suprema(self.curve().clone(), order, tolerance, |curve| {
            while ends.len() < curve.len() {
                ends = ends
                    .iter()
                    .flat_map(|&[a, b]| [[a, 0.5 * (a + b)], [0.5 * (a + b), b]])
                    .collect();
            }
            let of = |(e, &[a, b]): (usize, &[f64; 2])| {
                let h = curve.element_length(e);
                [h * (2.0 * a + b) / 6.0, h * (a + 2.0 * b) / 6.0]
            };
            let loads = ends.iter().enumerate().map(of).collect();
            Ok(Loads { points: 0, error: vec![[0.0; 2]; curve.len()], loads })
        })
    }
}

/// ∫ f (1−s) and ∫ f s over every element, s the local coordinate, and their errors.
pub(super) struct Loads {
    pub(super) loads: Vec<[f64; 2]>,
    pub(super) error: Vec<[f64; 2]>,
    pub(super) points: u64,
}

/// The limit of sup ∫_Γ f v / ||v||_ν over continuous piecewise linear functions v on bisected meshes. The error of the
/// loads counts by its own dual norm, on the finest mesh.
pub(super) fn limit_of_suprema(
    mut curve: Curve,
    order: Order,
    tolerance: Tolerance,
    mut loads: impl FnMut(&Curve) -> Result<Loads>,
) -> Result<Estimate> {
    let (mut values, mut limits): (Vec<f64>, Vec<f64>) = (Vec::new(), Vec::new());
    let (mut best, mut work): (Option<Estimate>, Work) = (None, Work::default());
    loop {
        let of = loads(&curve)?;
        let [value, error] = suprema(&curve, [&of.loads, &of.error], order)?;
        values.push(value);
        work += Work {
            factorizations: 1,
            pairs: (curve.len() * curve.len() / 2) as u64,
            points: of.points,
            ..Work::default()
        };
        if let Some(found) = limit(&values, &mut limits, work)? {
            let found = Estimate::new(found.value, found.error + error, found.work)?;
            if found.value == 0.0 || found.relative_error() <= tolerance.relative() {
                return Ok(found);
            }
            best = Some(best.filter(|best| best.error <= found.error).unwrap_or(found));
        }
        let is_spent = work.points > tolerance.work();
        if 2 * curve.len() > MOST || is_spent {
            let why = if is_spent { SPENT } else { LIMIT };
            return Err(Error::best_of("dual norm", tolerance.relative(), best, why));
        }
        curve = curve.halved()?;
    }
}

/// The extrapolated limit of the values on bisected meshes; `None` for fewer than three values, unless they
/// agree.
fn limit(values: &[f64], limits: &mut Vec<f64>, work: Work) -> Result<Option<Estimate>> {
    let [.., a, b, c] = values[..] else { return Ok(None) };
    let (first, second) = (b - a, c - b);
    let rounding = ROUNDING * c;
    let ratio = second / first;
    let is_settled = second.abs() <= rounding;
    let found = if is_settled { c } else { c + second * ratio / (1.0 - ratio) };
    let shrinks = ratio > 0.0 && ratio < 0.9;
    if !(is_settled || shrinks) {
        return Estimate::new(c, 10.0 * second.abs() + rounding, work).map(Some);
    }
    let change = limits
        .last()
        .map_or((found - c).abs(), |last| (found - last).abs().max(0.05 * (found - c).abs()));
    limits.push(found);
    Estimate::new(found, change + rounding, work).map(Some)
}

/// The suprema √(bᵀ(M+A)⁻¹b) on one mesh of two loads, each given by its integrals against the two linear functions of
/// every element.
fn suprema(curve: &Curve, loads: [&[[f64; 2]]; 2], order: Order) -> Result<[f64; 2]> {
    let n = curve.len();
    let nodes = n + usize::from(!curve.is_closed());
    let pairs = CurvePairs::new(curve, order, false, ENTRIES, Tolerance::WORK)?;
    let rows: Vec<Vec<[[f64; 4]; 4]>> = parallel::map(n, &|e| {
        let form = |f: usize| {
            let mut local = [[0.0; 4]; 4];
            pairs.visit(e, f, &mut |w, s, t| {
                let difference = [1.0 - s, s, t - 1.0, -t];
                for (row, a) in local.iter_mut().zip(difference) {
                    row.iter_mut().zip(difference).for_each(|(entry, b)| *entry += w * a * b);
                }
            });
            local
        };
        (e + 1..n).map(form).collect()
    });
    pairs.require_all()?;
    let mut matrix = DMatrix::<f64>::zeros(nodes, nodes);
    let mut load = DMatrix::<f64>::zeros(nodes, 2);
    for (e, row) in rows.iter().enumerate() {
        let (h, [i, j]) = (curve.element_length(e), curve.nodes_of(e));
        let own = pairs.own(h);
        for (k, l, mass) in [(i, i, 3.0), (j, j, 3.0), (i, j, 6.0), (j, i, 6.0)] {
            matrix[(k, l)] += h / mass + if k == l { own } else { -own };
        }
        for (column, parts) in loads.iter().enumerate() {
            load[(i, column)] += parts[e][0];
            load[(j, column)] += parts[e][1];
        }
        for (f, local) in (e + 1..).zip(row) {
            let [k, l] = curve.nodes_of(f);
            let places = [i, j, k, l];
            for (row, values) in places.iter().zip(local) {
                places
                    .iter()
                    .zip(values)
                    .for_each(|(column, value)| matrix[(*row, *column)] += value);
            }
        }
    }
    let factored = Cholesky::new(&matrix)
        .ok_or(Error::NotPositiveDefinite { what: "Gram matrix of H^nu", pivot: 0 })?;
    let solution = factored.solve(&load);
    // A square below zero is rounding; one that is not a number stays one.
    let root = |square: f64| if square < 0.0 { 0.0 } else { square.sqrt() };
    Ok([0, 1].map(|k| root(load.column(k).dot(&solution.column(k)))))
}
