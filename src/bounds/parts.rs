//! The bound as a sum over triangles and contact segments.
//!
//! For v in K and q with traction as in [`super`], d = σ(v) − q, and every w with w = 0 on Γ_D
//!
//! ```text
//! l(w) = ∫ q : ε(w) − ∫_{Γ_C} q_N w_N + osc(w),      |osc(w)| ≤ osc |||w|||,
//! |||u − v|||² + ∫ σ_N(u) (v_N − g) + ∫ q_N (u_N − g)
//!     = ∫ d : ε(v − u) + ∫ q_N (v_N − g) − osc(v − u)
//! ```
//!
//! where the three terms on the left are not negative. With A = |||d|||* + osc and b = ∫ q_N (v_N −
//! g) ≥ 0,
//!
//! ```text
//! |||u − v||| ≤ (A + (A² + 4 b)^(1/2))/2,        2 (J(v) − J(u)) ≤ A² + 2 b.
//! ```
//!
//! Without oscillation A² + 2b = 2 (J(v) − J*(q)). The oscillation: on a triangle of diameter h,
//! with Payne and Weinberger's constant h/π and Korn's constant K for mean-free rotation, K² ≤ 1 +
//! 2/sin²(α/4), α the smallest angle,
//!
//! ```text
//! osc_T = ( (h/π) K ‖f − f_T‖_T + Σ_E h K (|E|/|T| (1/π² + 1/π))^(1/2) ‖F − q n‖_E )
//!         · (2 min(μ, λ + μ))^(−1/2)
//! ```
//!
//! (scalar: K = 1 and without the last factor), because what is left over of f and of F on a
//! triangle has no resultant and no moment. On one mesh osc² = Σ osc_T².
//!
//! With a reaction term −Δu + c u = f no equilibrium is required: the residual r = c v − f − div q
//! is paired with w beside d, and A² has the further terms ‖r‖_T²/c. Where it is better only its
//! mean r̄ has: as |||w|||_T² ≥ (π²/h² + c) ‖w − w̄‖_T², the rest may be oscillation,
//!
//! ```text
//! |∫_T (r − r̄) w| ≤ (π²/h² + c)^(−1/2) ‖r − r̄‖_T |||w|||_T,
//! ```
//!
//! and is where ‖d‖_T and this factor add up to less than (‖d‖_T² + ‖r − r̄‖_T²/c)^(1/2).
//!
//! A stress of a coarser mesh leaves osc_H on its triangles H, and the displacement of the mesh
//! leaves rest_T on its triangles T. w may live on the few T where the rest is large, so the two
//! are not added triangle by triangle, but
//!
//! ```text
//! Σ_H osc_H |||w|||_H + Σ_T rest_T |||w|||_T
//!     ≤ Σ_H (osc_H + (Σ_{T ⊂ H} rest_T²)^(1/2)) |||w|||_H ≤ osc |||w|||,
//! osc² = Σ_H (osc_H + (Σ_{T ⊂ H} rest_T²)^(1/2))²
//! ```
//!
//! by Cauchy and Schwarz's inequality in H, and then over all H; on one mesh osc_T and rest_T are
//! added.

use super::dual::Dual;
use super::element::{Linear, Value, combine, pieces, traction};
use super::setting::{Border, QUADRATURE, Sample, Setting};
use crate::error::Result;
use crate::fem::Element;
use crate::mesh::{Part, Point, distance, doubled_area};
use crate::numeric::parallel;
use std::f64::consts::PI;

/// The parts of the bound.
#[derive(Debug, Clone)]
pub(super) struct Parts {
    /// |||d|||*² of every triangle.
    pub(super) distance: Vec<f64>,
    /// osc of every triangle, or its part of osc on the triangle of the stress in which it lies.
    pub(super) oscillation: Vec<f64>,
    /// ∫ |q_N| (g − v_N) of every contact segment, by number of the border.
    pub(super) contact: Vec<f64>,
    /// −J*(q).
    pub(super) complementary: f64,
    /// The mean of q on every triangle.
    pub(super) means: Vec<Value>,
}

/// |||d|||*², the oscillation of the displacement, ½ ∫ q : 𝒜⁻¹q and the mean of q on a triangle.
#[derive(Default)]
struct OnTriangle {
    distance: f64,
    rest: f64,
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
        let per_triangle: Vec<OnTriangle> = parallel::map_together(self.sides.len(), 256, &|t| {
            self.on_triangle(t, displacement, dual)
        })
        .into_iter()
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
                    let exact = self.exact_at(point);
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
        let rest: Vec<f64> = per_triangle.iter().map(|part| part.rest).collect();
        Ok(Parts {
            distance: per_triangle.iter().map(|part| part.distance).collect(),
            oscillation: oscillations(|t| self.host(t), &dual.oscillation, &rest),
            means: per_triangle.iter().map(|part| part.mean).collect(),
            contact,
            complementary,
        })
    }

    /// d = σ(v) − q at the samples of a triangle for v with the constant stress σ(v); with a
    /// reaction term also what is carried of r = c v − f − div q, and the oscillation of the rest.
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
        let samples = self.samples(t, QUADRATURE);
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
        found.rest = rest;
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
            for Sample { point, weight, .. } in self.samples(t, QUADRATURE) {
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

/// osc by triangle: the squares of those of a host add up to (osc_H + (Σ rest_T²)^(1/2))².
///
/// `of_stress` are the parts of osc_H, whose squares add up to osc_H², and `rest` the rest_T.
fn oscillations(host: impl Fn(usize) -> usize, of_stress: &[f64], rest: &[f64]) -> Vec<f64> {
    let hosts = (0..rest.len()).map(|t| host(t) + 1).max().unwrap_or(0);
    let mut sums = vec![[0.0_f64; 2]; hosts];
    for (t, (osc, rest)) in of_stress.iter().zip(rest).enumerate() {
        let [sum, more] = &mut sums[host(t)];
        (*sum, *more) = (sum.hypot(*osc), more.hypot(*rest));
    }
    (0..rest.len())
        .map(|t| match sums[host(t)] {
            [0.0, 0.0] => 0.0,
            [osc, more] => of_stress[t].hypot(rest[t]) * ((osc + more) / osc.hypot(more)),
        })
        .collect()
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bounds::Traction;
    use crate::contact::Body;
    use crate::fem::Form;
    use crate::mesh::{Hierarchy, SideParts, unit_square};

    fn norm(values: &[f64]) -> f64 {
        values.iter().map(|v| v * v).sum::<f64>().sqrt()
    }

    /// Σ_H osc_H |||w|||_H + Σ_T rest_T |||w|||_T is not above osc |||w|||, and reaches it for some
    /// w on one host.
    #[test]
    fn no_displacement_sees_more_than_the_oscillation() {
        let hosts = [0, 0, 1, 0, 1, 2];
        let of_stress = [0.3, 0.4, 0.2, 1.2, 0.1, 0.0];
        let mut state = 11_u64;
        let mut random = || {
            state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            (state >> 11) as f64 / (1_u64 << 53) as f64
        };
        let of_host = |values: &[f64], host: usize| -> f64 {
            (0..6).filter(|&t| hosts[t] == host).map(|t| values[t] * values[t]).sum::<f64>().sqrt()
        };
        let sees = |rest: &[f64], w: &[f64]| -> f64 {
            (0..3).map(|host| of_host(&of_stress, host) * of_host(w, host)).sum::<f64>()
                + rest.iter().zip(w).map(|(rest, w)| rest * w).sum::<f64>()
        };
        let bound = |rest: &[f64]| norm(&oscillations(|t| hosts[t], &of_stress, rest));
        let alone = [0.0, 1.0, 0.0, 0.0, 0.0, 0.0];
        // w on the second triangle only, of the host whose osc is 1.3.
        let only = sees(&alone, &alone);
        assert!((only - 2.3).abs() < 1e-15 && only <= bound(&alone), "{only} {}", bound(&alone));
        let mut closest = 0.0_f64;
        for _ in 0..20_000 {
            let rest: Vec<f64> = (0..6).map(|_| random()).collect();
            let w: Vec<f64> = (0..6).map(|_| random().powi(3)).collect();
            let share = sees(&rest, &w) / (bound(&rest) * norm(&w));
            assert!(share <= 1.0 + 1e-14, "{rest:?} {w:?}: {share}");
            closest = closest.max(share);
        }
        assert!(closest > 0.97, "{closest}");
        // On one mesh the two of a triangle are added.
        let same = oscillations(|t| t, &of_stress, &[0.5; 6]);
        assert!(same.iter().zip(of_stress).all(|(all, osc)| (all - osc - 0.5).abs() < 1e-15));
    }

    /// A reaction term and a flux with a corner: an older stress leaves oscillation on its
    /// triangles, the displacement of a finer mesh on its own.
    #[test]
    fn an_older_stress_and_a_reaction_term_are_added_by_triangle_of_the_stress() {
        let flux = |[x, y]: Point| (7.0 * x + 5.0 * y).sin();
        let body =
            Body::new(unit_square(2, SideParts::HANGING).unwrap(), Form::Scalar { reaction: 0.1 })
                .load(|[x, y]: Point| 20.0 * (9.0 * x).sin() * (x - y))
                .traction(flux);
        let setting = Setting::new(&body, body.mesh(), Traction::Linear).unwrap();
        let touches = vec![[false; 2]; setting.borders.len()];
        let dual = setting.best_stress(&touches).unwrap();
        let mut meshes = Hierarchy::new(body.mesh().clone());
        // Some triangles are cut, so that the hosts have one or several.
        meshes.refine_where(|_, t| t % 3 == 0).unwrap();
        let fine = setting.refined(meshes.finest(), meshes.origins().to_vec()).unwrap();
        let older = setting.transferred(&fine, &dual).unwrap();
        let displacement: Vec<f64> =
            meshes.finest().nodes().iter().map(|[x, y]| -x * (1.0 - y)).collect();
        let parts = fine.parts(&displacement, &older).unwrap();
        let rest: Vec<f64> = (0..meshes.finest().triangles().len())
            .map(|t| {
                let stress = fine.stress_of(t, &displacement);
                let of_v = (&displacement[..], &stress);
                fine.distances(t, &fine.samples(t, QUADRATURE), of_v, &older.fields[t]).unwrap().1
            })
            .collect();
        let hosts = body.mesh().triangles().len();
        let mut square = 0.0;
        for host in 0..hosts {
            let own: Vec<f64> =
                (0..rest.len()).filter(|&t| fine.host(t) == host).map(|t| rest[t]).collect();
            square += (dual.oscillation[host] + norm(&own)).powi(2);
        }
        println!("{:.6} {:.6}, {:?}", parts.osc(), square.sqrt(), rest);
        assert!(rest.iter().filter(|rest| **rest > 0.0).count() > 3, "{rest:?}");
        assert!(dual.oscillation.iter().filter(|osc| **osc > 0.0).count() > 3);
        assert!((parts.osc() / square.sqrt() - 1.0).abs() < 1e-12);
    }
}
