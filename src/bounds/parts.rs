//! The bound as a sum over triangles and contact segments.
//!
//! For v in K and q with traction as in [`super`], d = σ(v) − q, and every w with w = 0 on Γ_D
//!
//! ```text
//! l(w) = ∫ q : ε(w) − ∫_{Γ_C} q_N w_N + osc(w),      |osc(w)| ≤ osc |||w|||,
//! |||u − v|||² + ∫ σ_N(u) (v_N − g) + ∫ q_N (u_N − g) = ∫ d : ε(v − u) + ∫ q_N (v_N − g) − osc(v − u)
//! ```
//!
//! where the three terms on the left are not negative. With A = |||d|||* + osc and b = ∫ q_N (v_N − g) ≥ 0,
//!
//! ```text
//! |||u − v||| ≤ (A + (A² + 4 b)^(1/2))/2,        2 (J(v) − J(u)) ≤ A² + 2 b.
//! ```
//!
//! Without oscillation A² + 2b = 2 (J(v) − J*(q)). The oscillation: on a triangle of diameter h, with Payne and
//! Weinberger's constant h/π and Korn's constant K for mean-free rotation, K² ≤ 1 + 2/sin²(α/4), α the smallest angle,
//!
//! ```text
//! osc_T = ( (h/π) K ‖f − f_T‖_T + Σ_E h K (|E|/|T| (1/π² + 1/π))^(1/2) ‖F − q n‖_E ) (2 min(μ, λ + μ))^(−1/2)
//! ```
//!
//! (scalar: K = 1 and without the last factor), because what is left over of f and of F on a triangle has no resultant
//! and no moment.

use super::dual::Dual;
use super::element::Value;
use super::rule::combine;
use super::setting::Setting;
use crate::error::Result;
use crate::fem::Element;
use crate::mesh::{Part, Point, distance, doubled_area};
use rayon::prelude::*;
use std::f64::consts::PI;

/// The parts of the bound.
#[derive(Debug, Clone)]
pub(super) struct Parts {
    /// |||d|||*² of every triangle.
    pub(super) distance: Vec<f64>,
    /// osc of every triangle.
    pub(super) oscillation: Vec<f64>,
    /// ∫ |q_N| (g − v_N) of every contact segment, by number of the border.
    pub(super) contact: Vec<f64>,
    /// −J*(q) of every triangle and segment, summed, for comparison.
    pub(super) complementary: f64,
}

impl Parts {
    /// |||d|||* + osc.
    pub(super) fn reach(&self) -> f64 {
        let osc: f64 = self.oscillation.iter().map(|v| v * v).sum();
        self.distance.iter().sum::<f64>().max(0.0).sqrt() + osc.sqrt()
    }

    /// b.
    pub(super) fn work(&self) -> f64 {
        self.contact.iter().sum::<f64>().max(0.0)
    }
}

impl Setting<'_, '_> {
    /// σ(v) of a P1 function on a triangle, or its gradient.
    pub(super) fn stress_of(&self, t: usize, displacement: &[f64]) -> Value {
        let element = Element::new(self.mesh.corners(t));
        let c = self.components;
        let gradient = |axis: usize| {
            element.gradient(self.mesh.triangles()[t].map(|node| displacement[c * node + axis]))
        };
        self.stress_from(t, [gradient(0), gradient(c - 1)])
    }

    /// The stress of the given gradients of the components.
    pub(super) fn stress_from(&self, t: usize, [[xx, xy], [yx, yy]]: [Point; 2]) -> Value {
        match self.material(t) {
            None => [xx, xy, 0.0],
            Some(material) => {
                let (pressure, shear) = (material.lambda() * (xx + yy), material.mu());
                [pressure + 2.0 * shear * xx, pressure + 2.0 * shear * yy, shear * (xy + yx)]
            }
        }
    }

    /// The parts for a function given by its nodal values; v_N ≤ g is required.
    pub(super) fn parts(&self, displacement: &[f64], dual: &Dual) -> Result<Parts> {
        let per_triangle: Vec<[f64; 3]> = (0..self.sides.len())
            .into_par_iter()
            .with_min_len(256)
            .map(|t| self.on_triangle(t, displacement, dual))
            .collect::<Result<_>>()?;
        let mut complementary: f64 = per_triangle.iter().map(|part| part[2]).sum();
        let mut contact = vec![0.0; self.borders.len()];
        for (number, border) in self.borders.iter().enumerate() {
            let corners = self.mesh.corners(border.triangle);
            let (a, b) = (corners[border.side], corners[(border.side + 1) % 3]);
            let side = self.side(border.triangle, border.side);
            if border.part == Part::Contact {
                let [p, r] = dual.pressure[number];
                if p == 0.0 && r == 0.0 {
                    continue;
                }
                let [i, j] = [0, 1].map(|end| self.mesh.triangles()[border.triangle][(border.side + end) % 3]);
                let normal = |node: usize| match self.components {
                    1 => displacement[node],
                    _ => displacement[2 * node] * side.normal[0] + displacement[2 * node + 1] * side.normal[1],
                };
                for (s, weight) in self.edge_rule.iter() {
                    let point = [a[0] + s * (b[0] - a[0]), a[1] + s * (b[1] - a[1])];
                    let gap = self.body.gap_at(point)?;
                    let pressure = weight * side.length * (p + s * (r - p));
                    contact[number] += pressure * (gap - (1.0 - s) * normal(i) - s * normal(j));
                    complementary += pressure * gap;
                }
            }
            if border.part == Part::Dirichlet {
                for (s, weight) in self.edge_rule.iter() {
                    let point = [a[0] + s * (b[0] - a[0]), a[1] + s * (b[1] - a[1])];
                    let [x, y] = self.body.displacement_at(point)?;
                    if x == 0.0 && y == 0.0 {
                        continue;
                    }
                    let shares = [1.0 - s, s, 0.0];
                    let mut value = combine(&shares, &dual.fields[border.triangle][border.side]);
                    let exact = self.exact_at(point);
                    (0..3).for_each(|c| value[c] += exact[c]);
                    let [n, t] = super::element::traction(self.components, value, &side);
                    let given = match self.components {
                        1 => n * x,
                        _ => {
                            n * (x * side.normal[0] + y * side.normal[1])
                                + t * (x * side.tangent[0] + y * side.tangent[1])
                        }
                    };
                    complementary -= weight * side.length * given;
                }
            }
        }
        Ok(Parts {
            distance: per_triangle.iter().map(|part| part[0]).collect(),
            oscillation: per_triangle.iter().map(|part| part[1]).collect(),
            contact,
            complementary,
        })
    }

    /// |||d|||*², osc and ½ ∫ q : 𝒜⁻¹ q of a triangle.
    fn on_triangle(&self, t: usize, displacement: &[f64], dual: &Dual) -> Result<[f64; 3]> {
        let inner = self.compliance(t);
        let (stress, field) = (self.stress_of(t, displacement), &dual.fields[t]);
        let reaction = self.reaction();
        let nodes = self.mesh.triangles()[t];
        let corners = self.mesh.corners(t);
        let element = Element::new(corners);
        let has_lift = !self.lifts[t].is_empty();
        // div q is constant: that of the linear field on its first piece.
        let divergence = if reaction > 0.0 { divergence(corners, field) } else { 0.0 };
        let (mut distance, mut energy) = (0.0, 0.0);
        self.at_points(t, |k, shares, point, weight| {
            let mut value = combine(shares, &field[k]);
            let exact = self.exact_at(point);
            (0..3).for_each(|c| value[c] += exact[c]);
            let mut off = [0, 1, 2].map(|c| stress[c] - value[c]);
            energy += 0.5 * weight * inner(&value, &value);
            let mut v = 0.0;
            if has_lift || reaction > 0.0 {
                let at = element.barycentric(corners, point);
                if reaction > 0.0 {
                    v = (0..3).map(|i| at[i] * displacement[nodes[i]]).sum();
                }
                if let Some((own, values)) = self.lifted_at(t, at, &element) {
                    (0..3).for_each(|c| off[c] += own[c]);
                    v += values[0];
                }
            }
            distance += weight * inner(&off, &off);
            if reaction > 0.0 {
                let source = self.body.load_at(self.mesh.region(t), point)?[0] + divergence;
                distance += weight * (source - reaction * v).powi(2) / reaction;
                energy += 0.5 * weight * source * source / reaction;
            }
            Ok(())
        })?;
        Ok([distance, self.oscillation_of(t, dual.left_over[t]), energy])
    }

    /// osc_T.
    fn oscillation_of(&self, t: usize, volume: f64) -> f64 {
        let corners = self.mesh.corners(t);
        let area = 0.5 * doubled_area(corners);
        let lengths = [0, 1, 2].map(|k| distance(corners[k], corners[(k + 1) % 3]));
        let diameter = lengths.iter().fold(0.0, |m: f64, l| m.max(*l));
        let (korn, factor) = match self.material(t) {
            None => (1.0, 1.0),
            Some(material) => {
                // The smallest angle lies opposite to the shortest side; area = ½ a b sin α.
                let shortest = (0..3).fold(0, |best, k| if lengths[k] < lengths[best] { k } else { best });
                let (a, b) = (lengths[(shortest + 1) % 3], lengths[(shortest + 2) % 3]);
                let angle = (2.0 * area / (a * b)).min(1.0).asin();
                let korn = (1.0 + 2.0 / (0.25 * angle).sin().powi(2)).sqrt();
                (korn, (2.0 * material.mu().min(material.lambda() + material.mu())).powf(-0.5))
            }
        };
        let mut sum = diameter / PI * volume;
        for k in 0..3 {
            if let Some(border) = self.border_of[self.sides[t][k].edge] {
                let rest = self.borders[border].left_over;
                sum += diameter * (lengths[k] / area * (1.0 / (PI * PI) + 1.0 / PI)).sqrt() * rest;
            }
        }
        korn * factor * sum
    }
}

/// The divergence of a flux that is linear on the whole triangle.
fn divergence(corners: [Point; 3], field: &super::element::Linear) -> f64 {
    let piece = super::element::pieces(corners)[0];
    let element = Element::new(piece);
    (0..3)
        .map(|m| element.gradients[m][0] * field[0][m][0] + element.gradients[m][1] * field[0][m][1])
        .sum()
}
