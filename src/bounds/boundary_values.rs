//! Displacements prescribed on Γ_D that are not linear on its edges.
//!
//! With e = u_D − I u_D on an edge from a to b of a triangle, e = λ_a λ_b (c_0 + c_1 r + c_2 r²), r
//! = λ_b − λ_a, is carried into the triangle by the same polynomial in barycentric coordinates: it
//! vanishes on the other two sides, and added to u^h it gives a function with the values u_D, of
//! which the bound is one. u_D is taken as a polynomial of degree four on every edge, with the same
//! values at the ends and the same moments ∫ e r^k, k = 0, 1, 2, so that linear tractions do the
//! same work.

use crate::error::Result;
use crate::fem::Element;
use crate::mesh::Point;
use fractional_sobolev::Rule;

/// A prescribed displacement whose deviation from its interpolant is below this multiple of it is
/// linear.
const LINEAR: f64 = 1e-13;

/// c_0, c_1, c_2 for every component.
#[derive(Debug, Clone, Copy)]
pub(super) struct Lift {
    side: usize,
    coefficients: [[f64; 3]; 2],
}

impl Lift {
    /// The lift of u_D on one side, given along it from 0 to 1; `None` if u_D is linear there.
    pub(super) fn through(
        side: usize,
        rule: &Rule,
        at: impl Fn(f64) -> Result<Point>,
    ) -> Result<Option<Self>> {
        let (first, last) = (at(0.0)?, at(1.0)?);
        let deviation_at = |s: f64| -> Result<[Point; 2]> {
            let value = at(s)?;
            Ok([value, [0, 1].map(|c| value[c] - (1.0 - s) * first[c] - s * last[c])])
        };
        let (mut largest, mut deviation) = (0.0_f64, 0.0_f64);
        for s in [0.25, 0.5, 0.75] {
            let [value, off] = deviation_at(s)?;
            for c in 0..2 {
                largest = largest.max(value[c].abs());
                deviation = deviation.max(off[c].abs());
            }
        }
        if deviation <= LINEAR * largest {
            return Ok(None);
        }
        let mut moments = [[0.0; 3]; 2];
        for (s, weight) in rule.iter() {
            let ([_, off], r) = (deviation_at(s)?, 2.0 * s - 1.0);
            for (row, off) in moments.iter_mut().zip(off) {
                for (sum, power) in row.iter_mut().zip([1.0, r, r * r]) {
                    *sum += weight * power * off;
                }
            }
        }
        // ∫ s(1 − s) r^k ds = 1/6, 1/30, 1/70 for k = 0, 2, 4.
        let coefficients = moments
            .map(|[m0, m1, m2]| [11.25 * m0 - 26.25 * m2, 30.0 * m1, 131.25 * m2 - 26.25 * m0]);
        Ok(Some(Self { side, coefficients }))
    }

    /// z and its gradient (rows: components) at a point with the given barycentric coordinates.
    pub(super) fn at(&self, element: &Element, shares: [f64; 3]) -> ([f64; 2], [Point; 2]) {
        let (a, b) = (self.side, (self.side + 1) % 3);
        let (la, lb, ga, gb) = (shares[a], shares[b], element.gradients[a], element.gradients[b]);
        let (product, r) = (la * lb, lb - la);
        let of_product = [0, 1].map(|axis| la * gb[axis] + lb * ga[axis]);
        let of_r = [0, 1].map(|axis| gb[axis] - ga[axis]);
        let value = self.coefficients.map(|[c0, c1, c2]| product * (c0 + r * (c1 + r * c2)));
        let gradient = self.coefficients.map(|[c0, c1, c2]| {
            let (polynomial, slope) = (c0 + r * (c1 + r * c2), c1 + 2.0 * r * c2);
            [0, 1].map(|axis| polynomial * of_product[axis] + product * slope * of_r[axis])
        });
        (value, gradient)
    }
}
