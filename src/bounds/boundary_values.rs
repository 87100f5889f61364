//! Displacements prescribed on Γ_D that are not linear on its edges.
//!
//! With e = u_D − I u_D on an edge from a to b of a triangle, e = λ_a λ_b (c_0 + c_1 r + c_2 r²), r = λ_b − λ_a, is carried
//! into the triangle by the same polynomial in barycentric coordinates: it vanishes on the other two sides, and added to
//! u^h it gives a function with the values u_D, of which the bound is one. u_D is taken as its polynomial of degree four
//! on every edge.

use super::element::Value;
use super::setting::{Border, Setting};
use crate::error::Result;
use crate::fem::Element;
use crate::mesh::{Part, Point, doubled_area};

/// A prescribed displacement whose deviation from its interpolant is below this multiple of it is linear.
const LINEAR: f64 = 1e-13;

/// c_0, c_1, c_2 for every component.
#[derive(Debug, Clone, Copy)]
pub(super) struct Lift {
    side: usize,
    coefficients: [[f64; 3]; 2],
}

impl Lift {
    /// z and its gradient (rows: components) at a point with the given barycentric coordinates.
    fn at(&self, element: &Element, shares: [f64; 3]) -> ([f64; 2], [Point; 2]) {
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

impl Setting<'_, '_> {
    /// The lift of one edge, `None` if u_D is linear there.
    pub(super) fn lift_of(&self, border: &Border) -> Result<Option<Lift>> {
        if border.part != Part::Dirichlet {
            return Ok(None);
        }
        let corners = self.mesh.corners(border.triangle);
        let (a, b) = (corners[border.side], corners[(border.side + 1) % 3]);
        let at = |s: f64| self.body.displacement_at([a[0] + s * (b[0] - a[0]), a[1] + s * (b[1] - a[1])]);
        let (first, last) = (at(0.0)?, at(1.0)?);
        // e/(s(1 − s)) at r = −½, 0, ½.
        let mut samples = [[0.0; 3]; 2];
        let (mut largest, mut deviation) = (0.0_f64, 0.0_f64);
        for (k, s) in [0.25, 0.5, 0.75].into_iter().enumerate() {
            let value = at(s)?;
            for c in 0..2 {
                let off = value[c] - (1.0 - s) * first[c] - s * last[c];
                largest = largest.max(value[c].abs());
                deviation = deviation.max(off.abs());
                samples[c][k] = off / (s * (1.0 - s));
            }
        }
        if deviation <= LINEAR * largest {
            return Ok(None);
        }
        let coefficients =
            samples.map(|[low, middle, high]| [middle, high - low, 2.0 * (low + high - 2.0 * middle)]);
        Ok(Some(Lift { side: border.side, coefficients }))
    }

    /// The stress of the lifts of a triangle at a point, and the value (scalar).
    pub(super) fn lifted_at(&self, t: usize, shares: [f64; 3], element: &Element) -> Option<(Value, [f64; 2])> {
        let mut sum: Option<(Value, [f64; 2])> = None;
        for lift in self.lifts[t].iter() {
            let (value, [gx, gy]) = lift.at(element, shares);
            let stress = self.stress_from(t, [gx, gy]);
            let (total, values) = sum.get_or_insert(([0.0; 3], [0.0; 2]));
            (0..3).for_each(|c| total[c] += stress[c]);
            (0..2).for_each(|c| values[c] += value[c]);
        }
        sum
    }

    /// J(v + z) − J(v) for the sum z of all lifts.
    pub(super) fn lift_energy(&self, displacement: &[f64]) -> Result<f64> {
        let mut sum = 0.0;
        for (t, lifts) in self.lifts.iter().enumerate() {
            if lifts.is_empty() {
                continue;
            }
            let (corners, nodes) = (self.mesh.corners(t), self.mesh.triangles()[t]);
            debug_assert!(doubled_area(corners) > 0.0);
            let (element, inner) = (Element::new(corners), self.compliance(t));
            let stress = self.stress_of(t, displacement);
            let reaction = self.reaction();
            self.at_points(t, |_, _, point, weight| {
                let shares = element.barycentric(corners, point);
                if let Some((own, value)) = self.lifted_at(t, shares, &element) {
                    let load = self.body.load_at(self.mesh.region(t), point)?;
                    let v: f64 = if reaction > 0.0 {
                        (0..3).map(|i| shares[i] * displacement[nodes[i]]).sum()
                    } else {
                        0.0
                    };
                    sum += weight
                        * (inner(&stress, &own) + 0.5 * inner(&own, &own)
                            + reaction * value[0] * (v + 0.5 * value[0])
                            - load[0] * value[0]
                            - load[1] * value[1]);
                }
                Ok(())
            })?;
        }
        Ok(sum)
    }
}
