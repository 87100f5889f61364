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
//!
//! With a reaction term −Δu + c u = f no equilibrium is required: the residual r = c v − f − div q is paired with w beside
//! d, and A² has the further terms ‖r‖_T²/c. Where it is better only its mean r̄ has: as |||w|||_T² ≥ (π²/h² + c) ‖w − w̄‖_T²,
//! the rest may be oscillation,
//!
//! ```text
//! |∫_T (r − r̄) w| ≤ (π²/h² + c)^(−1/2) ‖r − r̄‖_T |||w|||_T,
//! ```
//!
//! and is where ‖d‖_T and this factor add up to less than (‖d‖_T² + ‖r − r̄‖_T²/c)^(1/2).

use super::dual::Dual;
use super::element::{Linear, Value, combine, pieces, traction};
use super::setting::{Border, Sample, Setting};
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
    /// −J*(q).
    pub(super) complementary: f64,
    /// The mean of q on every triangle.
    pub(super) means: Vec<Value>,
}

/// |||d|||*², osc, ½ ∫ q : 𝒜⁻¹q and the mean of q on a triangle.
#[derive(Default)]
struct OnTriangle {
    distance: f64,
    oscillation: f64,
    energy: f64,
    mean: Value,
}

/// |||z|||² and J(v + z) − J(v) on a triangle, z the lift of u_D.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Lifted {
    pub(super) square: f64,
    pub(super) gained: f64,
}

impl Parts {
    /// |||d|||* + osc.
    pub(super) fn reach(&self) -> f64 {
        self.distance.iter().sum::<f64>().max(0.0).sqrt() + self.osc()
    }

    /// osc.
    pub(super) fn osc(&self) -> f64 {
        self.oscillation.iter().map(|v| v * v).sum::<f64>().sqrt()
    }

    /// b.
    pub(super) fn work(&self) -> f64 {
        self.contact.iter().sum::<f64>().max(0.0)
    }
}

impl Setting<'_, '_> {
    /// v_N (scalar: v) at both ends of an edge of the boundary.
    pub(super) fn normal_at(&self, border: &Border, displacement: &[f64]) -> [f64; 2] {
        let normal = self.side(border.triangle, border.side).normal;
        [0, 1].map(|end| {
            let node = self.mesh.triangles()[border.triangle][(border.side + end) % 3];
            match self.components {
                1 => displacement[node],
                _ => displacement[2 * node] * normal[0] + displacement[2 * node + 1] * normal[1],
            }
        })
    }

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
        let per_triangle: Vec<OnTriangle> = (0..self.sides.len())
            .into_par_iter()
            .with_min_len(256)
            .map(|t| self.on_triangle(t, displacement, dual))
            .collect::<Result<_>>()?;
        let mut complementary: f64 = per_triangle.iter().map(|part| part.energy).sum();
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
                let [first, last] = self.normal_at(border, displacement);
                for (s, weight) in self.edge_rule.iter() {
                    let point = [a[0] + s * (b[0] - a[0]), a[1] + s * (b[1] - a[1])];
                    let gap = self.body.gap_at(self.mesh.group(border.number), point)?;
                    let pressure = weight * side.length * (p + s * (r - p));
                    contact[number] += pressure * (gap - (1.0 - s) * first - s * last);
                    complementary += pressure * gap;
                }
            }
            if border.part == Part::Dirichlet {
                for (s, weight) in self.edge_rule.iter() {
                    let point = [a[0] + s * (b[0] - a[0]), a[1] + s * (b[1] - a[1])];
                    let [x, y] =
                        self.body.displacement_at(self.mesh.group(border.number), point)?;
                    if x == 0.0 && y == 0.0 {
                        continue;
                    }
                    let (piece, shares) = self.on_side(border.triangle, border.side, s, point);
                    let mut value = combine(&shares, &dual.fields[border.triangle][piece]);
                    let exact = self.exact_at(&[point])[0];
                    (0..3).for_each(|c| value[c] += exact[c]);
                    if let Some(own) = self.own_of(border.triangle) {
                        let more = own.at(piece, shares);
                        (0..3).for_each(|c| value[c] += more[c]);
                    }
                    let [n, t] = traction(self.components, value, &side);
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
            distance: per_triangle.iter().map(|part| part.distance).collect(),
            oscillation: per_triangle.iter().map(|part| part.oscillation).collect(),
            means: per_triangle.iter().map(|part| part.mean).collect(),
            contact,
            complementary,
        })
    }

    /// d = σ(v) − q at the samples of a triangle for v with the constant stress σ(v); with a reaction term also what is
    /// carried of r = c v − f − div q, and the oscillation of the rest.
    pub(super) fn distances(
        &self,
        t: usize,
        samples: &[Sample],
        (displacement, stress): (&[f64], &Value),
        field: &Linear,
    ) -> Result<(Vec<(Value, f64)>, f64)> {
        let reaction = self.reaction();
        let mut found = Vec::with_capacity(samples.len());
        let is_plain = self.lifts[t].is_empty() && reaction == 0.0;
        let (corners, nodes) = (self.mesh.corners(t), self.mesh.triangles()[t]);
        let element = Element::new(corners);
        for sample in samples {
            let value = sample.stress(field);
            let mut off = [stress[0] - value[0], stress[1] - value[1], stress[2] - value[2]];
            let mut residual = 0.0;
            if !is_plain {
                let at = element.barycentric(corners, sample.point);
                let lifted = self.lifted_at(t, at, &element);
                if let Some((own, _)) = lifted {
                    (0..3).for_each(|c| off[c] += own[c]);
                }
                if reaction > 0.0 {
                    let linear: f64 = (0..3).map(|i| at[i] * displacement[nodes[i]]).sum();
                    let v = linear + lifted.map_or(0.0, |(_, values)| values[0]);
                    residual = reaction * v - self.source(t, sample, field)?;
                }
            }
            found.push((off, residual));
        }
        if reaction == 0.0 {
            return Ok((found, 0.0));
        }
        let inner = self.compliance(t);
        let weights = || samples.iter().map(|sample| sample.weight);
        let area: f64 = weights().sum();
        let mean = found.iter().zip(weights()).map(|((_, r), w)| w * r).sum::<f64>() / area;
        let rest: f64 =
            found.iter().zip(weights()).map(|((_, r), w)| w * (r - mean) * (r - mean)).sum();
        let own: f64 = found.iter().zip(weights()).map(|((d, _), w)| w * inner(d, d)).sum();
        let waves = (PI / diameter(corners)).powi(2);
        let oscillation = (rest / (waves + reaction)).sqrt();
        if own.sqrt() + oscillation >= (own + rest / reaction).sqrt() {
            return Ok((found, 0.0));
        }
        found.iter_mut().for_each(|(_, r)| *r = mean);
        Ok((found, oscillation))
    }

    /// f + div q at a point, for a problem with reaction term.
    fn source(&self, t: usize, sample: &Sample, field: &Linear) -> Result<f64> {
        let load = self.body.load_at(self.mesh.region(t), sample.point)?[0];
        Ok(load + divergence(self.host_corners(t), field))
    }

    fn on_triangle(&self, t: usize, displacement: &[f64], dual: &Dual) -> Result<OnTriangle> {
        let (inner, field, reaction) = (self.compliance(t), &dual.fields[t], self.reaction());
        let stress = self.stress_of(t, displacement);
        let mut found = OnTriangle::default();
        let mut area = 0.0;
        let samples = self.samples(t);
        let (distances, rest) = self.distances(t, &samples, (displacement, &stress), field)?;
        for (sample, (off, residual)) in samples.iter().zip(&distances) {
            let (value, weight) = (sample.stress(field), sample.weight);
            found.distance += weight * inner(off, off);
            found.energy += 0.5 * weight * inner(&value, &value);
            area += weight;
            (0..3).for_each(|c| found.mean[c] += weight * value[c]);
            if reaction > 0.0 {
                found.distance += weight * residual * residual / reaction;
                found.energy += 0.5 * weight * self.source(t, sample, field)?.powi(2) / reaction;
            }
        }
        found.mean.iter_mut().for_each(|mean| *mean /= area);
        found.oscillation = dual.oscillation[t] + rest;
        Ok(found)
    }

    /// The stress of the lifts of a triangle at a point, and the value (scalar).
    pub(super) fn lifted_at(
        &self,
        t: usize,
        shares: [f64; 3],
        element: &Element,
    ) -> Option<(Value, [f64; 2])> {
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

    /// What the sum z of all lifts changes, by triangle.
    pub(super) fn lift_energies(&self, displacement: &[f64]) -> Result<Vec<Lifted>> {
        let reaction = self.reaction();
        let mut found = vec![Lifted::default(); self.lifts.len()];
        for (t, lifted) in found.iter_mut().enumerate() {
            if self.lifts[t].is_empty() {
                continue;
            }
            let (corners, nodes) = (self.mesh.corners(t), self.mesh.triangles()[t]);
            let (element, inner) = (Element::new(corners), self.compliance(t));
            let stress = self.stress_of(t, displacement);
            for Sample { point, weight, .. } in self.samples(t) {
                let shares = element.barycentric(corners, point);
                if let Some((own, value)) = self.lifted_at(t, shares, &element) {
                    let load = self.body.load_at(self.mesh.region(t), point)?;
                    let v: f64 = if reaction > 0.0 {
                        (0..3).map(|i| shares[i] * displacement[nodes[i]]).sum()
                    } else {
                        0.0
                    };
                    let square = inner(&own, &own) + reaction * value[0] * value[0];
                    lifted.square += weight * square;
                    lifted.gained += weight
                        * (inner(&stress, &own) + 0.5 * square + reaction * value[0] * v
                            - load[0] * value[0]
                            - load[1] * value[1]);
                }
            }
        }
        Ok(found)
    }

    /// osc_T.
    pub(super) fn oscillation_of(&self, t: usize, volume: f64) -> f64 {
        let corners = self.mesh.corners(t);
        let area = 0.5 * doubled_area(corners);
        let lengths = [0, 1, 2].map(|k| distance(corners[k], corners[(k + 1) % 3]));
        let diameter = diameter(corners);
        let (korn, factor) = match self.material(t) {
            None => (1.0, 1.0),
            Some(material) => {
                // The smallest angle lies opposite to the shortest side; area = ½ a b sin α.
                let shortest =
                    (0..3).fold(0, |best, k| if lengths[k] < lengths[best] { k } else { best });
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

/// The longest side.
fn diameter(corners: [Point; 3]) -> f64 {
    (0..3).fold(0.0, |m: f64, k| m.max(distance(corners[k], corners[(k + 1) % 3])))
}

/// The divergence of a flux that is linear on the whole triangle.
fn divergence(corners: [Point; 3], field: &Linear) -> f64 {
    let piece = pieces(corners)[0];
    let element = Element::new(piece);
    (0..3)
        .map(|m| {
            element.gradients[m][0] * field[0][m][0] + element.gradients[m][1] * field[0][m][1]
        })
        .sum()
}
