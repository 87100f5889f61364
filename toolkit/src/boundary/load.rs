//! Dual norms of a function of the point on the boundary of a polygon: sup ∫_Γ f v / ‖v‖_ν.
//!
//! The supremum over continuous piecewise linear v on a mesh is √(bᵀ(M+A)⁻¹b) with the loads b_i = ∫_Γ f φ_i of f itself,
//! so that no interpolation of f enters; f need not be in L². The loads are computed by Gauss rules on the elements, those
//! at a vertex being graded towards it by the factor 0.3. Their error, estimated from a rule with fewer points and from the
//! last layer, counts by its own dual norm. The limit under bisection is extrapolated as for values on a curve.

use super::curve::Curve;
use super::dual::{Loads, limit_of_suprema};
use super::formula::CurveFormula;
use crate::error::{Error, Result};
use crate::estimate::{Estimate, Tolerance};
use crate::mesh::Mesh;
use crate::numeric::parallel;
use crate::numeric::scale::unit_of;
use crate::order::Order;
use crate::quadrature::Rule;

/// Ratio of the length of an element to that of its neighbour farther from the vertex.
const RATIO: f64 = 0.3;
/// Largest number of layers of the first mesh at a vertex, and number of elements up to which they are added.
const LAYERS: usize = 3;
const FIRST: usize = 64;
/// Layers of the elements at a vertex for the loads: 0.3^80 is 1e-42.
const OF_LOADS: usize = 80;
/// Points of the rule for the loads, and of the one that is compared with it.
const POINTS: usize = 12;
const FEWER: usize = 9;
/// Bound of the contribution below the last layer, relative to that of its element.
const BELOW: f64 = 10.0;

impl CurveFormula<'_> {
    /// The norm of H^{−ν}(Γ), sup ∫_Γ f v / ‖v‖_ν over v ∈ H^ν(Γ).
    ///
    /// # Errors
    /// [`Error::NotFinite`] for a value that is not finite; [`Error::CountOutOfRange`] for more than 750 sides;
    /// [`Error::NotPositiveDefinite`]; [`Error::ToleranceNotMet`] with the best value.
    pub(crate) fn dual_of_slobodeckij(
        &self,
        order: Order,
        tolerance: Tolerance,
    ) -> Result<Estimate> {
        let sides = self.vertices.len();
        let range = "[3, 750]";
        if sides > 750 {
            let name = "sides of a polygon for a dual norm";
            return Err(Error::CountOutOfRange { name, value: sides, range });
        }
        let layers = (FIRST / (2 * sides)).clamp(1, LAYERS + 1) - 1;
        let mut lengths = Mesh::geometric(layers, RATIO, 0.5)?.lengths().to_vec();
        lengths.extend(lengths.clone().iter().rev());
        let mesh = Mesh::from_lengths(&lengths)?;
        let vertices: Vec<[f64; 2]> =
            self.vertices.iter().map(|vertex| vertex.map(|x| self.unit * x)).collect();
        let curve = Curve::closed(&vertices, &vec![mesh; sides])?;
        let size = unit_of(self.loads(&curve, 1.0)?.loads.iter().flatten());
        let found = limit_of_suprema(curve, order, tolerance, |curve| self.loads(curve, size));
        let back = |found: Estimate| found.times(size);
        found.map_err(|error| error.carry("dual norm", back)).and_then(back)
    }

    /// The loads divided by `size`.
    fn loads(&self, curve: &Curve, size: f64) -> Result<Loads> {
        let of_side = |side: usize| {
            let resolved = |(blur, h): (f64, f64)| {
                ((blur / h).ln() / RATIO.ln()).max(1.0).min(OF_LOADS as f64) as usize
            };
            let [first, last] = curve.end_lengths(side);
            let [left, right] = curve.blurs(side);
            [resolved((left, first)), resolved((right, last))]
        };
        let (fine, parts) = curve.graded_at_vertices(RATIO, of_side)?;
        let rules = [Rule::gauss_legendre(POINTS)?, Rule::gauss_legendre(FEWER)?];
        let of_part = |k: usize| {
            let part = &parts[k];
            let (h, whole) = (fine.element_length(k), curve.element_length(part.element));
            rules.each_ref().map(|rule| {
                let mut sums = [0.0; 2];
                for (x, w) in rule.iter() {
                    let at = fine.point(fine.place(k, x * h));
                    let share = ((part.start + x * h) / whole).min(1.0);
                    let value = (self.f)(at) / size * w * h;
                    sums[0] += value * (1.0 - share);
                    sums[1] += value * share;
                }
                sums
            })
        };
        let found: Vec<[[f64; 2]; 2]> = parallel::map(parts.len(), &of_part);
        let (mut loads, mut error) = (vec![[0.0; 2]; curve.len()], vec![[0.0; 2]; curve.len()]);
        for (part, [sums, fewer]) in parts.iter().zip(&found) {
            for k in 0..2 {
                if let Some(&value) = [sums[k], fewer[k]].iter().find(|sum| !sum.is_finite()) {
                    let (name, index) = ("value of the function", part.element);
                    return Err(Error::NotFinite { name, index, value });
                }
                loads[part.element][k] += sums[k];
                error[part.element][k] += (sums[k] - fewer[k]).abs();
                if part.at_vertex {
                    error[part.element][k] += BELOW * sums[k].abs();
                }
            }
        }
        let points = (parts.len() * (POINTS + FEWER)) as u64;
        Ok(Loads { loads, error, points })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SQUARE: [[f64; 2]; 4] = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];

    /// The errors of the loads for one layer at every vertex: elements of length 0.15 and 0.35.
    fn errors(f: impl Fn([f64; 2]) -> f64 + Sync) -> Vec<[f64; 2]> {
        let mut lengths = Mesh::geometric(1, RATIO, 0.5).unwrap().lengths().to_vec();
        lengths.extend(lengths.clone().iter().rev());
        let mesh = Mesh::from_lengths(&lengths).unwrap();
        let curve = Curve::closed(&SQUARE, &vec![mesh; 4]).unwrap();
        CurveFormula::new(&SQUARE, f).unwrap().loads(&curve, 1.0).unwrap().error
    }

    #[test]
    fn errors_of_the_parts_of_an_element_do_not_cancel() {
        // Kinks in two parts of the element (0, 0.15) of the first side, which ends at (1, 0).
        let kink =
            |c: f64, [x, y]: [f64; 2]| if y == 0.0 { (0.01 - (x - c).abs()).max(0.0) } else { 0.0 };
        let (one, other) = (errors(|at| kink(0.09, at)), errors(|at| kink(0.03, at)));
        for sign in [1.0, -1.0] {
            let both = errors(|at| kink(0.09, at) + sign * kink(0.03, at));
            for k in 0..2 {
                let sum = one[0][k] + other[0][k];
                assert!(one[0][k] > 0.0 && other[0][k] > 0.0, "{one:?} {other:?}");
                assert!((both[0][k] / sum - 1.0).abs() < 1e-12, "{sign}: {both:?} {sum}");
            }
        }
    }

    #[test]
    fn values_at_the_points_of_either_rule_must_be_finite() {
        // In the middle of an element lies a point of the rule with 9 points only.
        for bad in [f64::NAN, f64::INFINITY] {
            let f = |[x, y]: [f64; 2]| if y == 0.0 && (x - 0.325).abs() < 1e-9 { bad } else { 1.0 };
            let found = CurveFormula::new(&SQUARE, f)
                .unwrap()
                .dual_of_slobodeckij(Order::HALF, Tolerance::fast());
            assert!(matches!(found, Err(Error::NotFinite { .. })), "{found:?}");
        }
    }
}
