//! The contact problem with one transition and known solution.
//!
//! Loads are integrated by rules graded toward the transition a: on both parts of its segment, of length L,
//! x = a ± L t^12 with Gauss points t in (0, 1).

use super::harmonic::{Harmonic, SLOPE};
use crate::contact::ContactProblem;
use crate::error::Result;
use crate::fem::{Cubature, Field, Form};
use crate::mesh::{Part, Point, SideParts, Triangulation, distance, unit_square};
use fractional_sobolev::{Rule, gauss_legendre};

/// Number of points along each side of a triangle for errors, for p < 1 and for p ≥ 1; one less for loads.
const POINTS: [usize; 2] = [5, 4];
/// Gauss points on a segment, and m: t^{mp−1} is smooth enough for p ≥ 3/10.
const EDGE_POINTS: usize = 24;
const GRADING: i32 = 12;

impl Harmonic {
    /// The problem on the structured mesh with n × n squares.
    ///
    /// # Errors
    /// [`ToolkitError::CountOutOfRange`](crate::ToolkitError::CountOutOfRange) unless 1 ≤ n ≤ 16384.
    pub(super) fn problem(&self, n: usize) -> Result<ContactProblem> {
        let other = if self.whole_boundary { Part::Contact } else { Part::Dirichlet };
        let mesh =
            unit_square(n, SideParts { bottom: Part::Contact, right: other, top: other, left: other })?;
        let load = self.edge_load(&mesh)?;
        let zero = vec![0.0; load.len()];
        let u = |point: Point| self.displacement(point);
        let mut problem = if self.whole_boundary {
            let mut problem = ContactProblem::new(mesh, self.form(), &zero)?;
            problem.add_volume_load(&Field::Scalar(&u), &self.rule(self.points() - 1)?)?;
            problem
        } else {
            let mut problem = ContactProblem::new(mesh, self.form(), &zero)?;
            problem.set_dirichlet(&Field::Scalar(&u))?;
            problem
        };
        problem.add_load(&load)?;
        Ok(problem)
    }

    /// The bilinear form.
    pub(super) fn form(&self) -> Form {
        if self.whole_boundary { Form::Scalar { reaction: 1.0 } } else { Form::LAPLACE }
    }

    /// Number of points along each side of a triangle for errors.
    pub(super) fn points(&self) -> usize {
        POINTS[usize::from(self.powers.opening >= 1.0)]
    }

    fn rule(&self, points: usize) -> Result<Cubature> {
        Ok(Cubature::new(points)?.singular_at(&[[self.position, 0.0]]))
    }

    /// ∫ g φ_i over the contact part.
    fn edge_load(&self, mesh: &Triangulation) -> Result<Vec<f64>> {
        let rule = gauss_legendre(EDGE_POINTS)?;
        let mut load = vec![0.0; mesh.nodes().len()];
        for edge in mesh.boundary().iter().filter(|edge| edge.part == Part::Contact) {
            let [from, to] = mesh.ends(edge);
            let length = distance(from, to);
            let normal = [(to[1] - from[1]) / length, (from[0] - to[0]) / length];
            let mut add = |t: f64, weight: f64, density: f64| {
                for (node, share) in edge.nodes.into_iter().zip([1.0 - t, t]) {
                    load[node] += weight * length * share * density;
                }
            };
            if from[1] == 0.0 && to[1] == 0.0 {
                for (t, weight, beyond) in self.points_on_bottom(from[0], length, &rule) {
                    let slope = self.potential(beyond, 0.0)[1].im + SLOPE;
                    add(t, weight, slope - self.normal_stress(beyond));
                }
                continue;
            }
            for (t, weight) in rule.iter() {
                let [p, q] =
                    self.gradient([from[0] + t * (to[0] - from[0]), from[1] + t * (to[1] - from[1])]);
                add(t, weight, p * normal[0] + q * normal[1]);
            }
        }
        Ok(load)
    }

    /// (t, weight, x − a) on the segment x = start + t · length, graded toward a if it contains a.
    fn points_on_bottom(&self, start: f64, length: f64, rule: &Rule) -> Vec<(f64, f64, f64)> {
        let cut = (self.position - start) / length;
        if !(0.0..=1.0).contains(&cut) {
            return rule.iter().map(|(t, weight)| (t, weight, (t - cut) * length)).collect();
        }
        let halves = [(-1.0, cut), (1.0, 1.0 - cut)];
        halves
            .iter()
            .flat_map(|&(side, width)| {
                rule.iter().map(move |(s, weight)| {
                    let distance = width * s.powi(GRADING);
                    let stretch = width * f64::from(GRADING) * s.powi(GRADING - 1);
                    (cut + side * distance, weight * stretch, side * distance * length)
                })
            })
            .collect()
    }
}

#[cfg(test)]
mod tests {
    use super::super::harmonic::tests::all_known;
    use super::*;
    use crate::mesh::doubled_area;

    /// a(u, φ_i) = ∫ f φ_i + ∫ (g + σ_N) φ_i at every node off the Dirichlet boundary: u solves the problem
    /// of its loads.
    #[test]
    fn the_loads_are_those_of_u() {
        let n = 4;
        for whole_boundary in [false, true] {
            for known in all_known(whole_boundary) {
                let problem = known.problem(n).unwrap();
                let mesh = problem.mesh();
                let held = mesh.nodes_on(Part::Dirichlet);
                let mut work = vec![0.0; mesh.nodes().len()];
                let rule = known.rule(10).unwrap();
                let reaction = f64::from(u8::from(whole_boundary));
                let mut volume = work.clone();
                for (t, corners) in mesh.triangles().iter().enumerate() {
                    let triangle = mesh.corners(t);
                    for (k, &node) in corners.iter().enumerate() {
                        let (b, c) = (triangle[(k + 1) % 3], triangle[(k + 2) % 3]);
                        let doubled = doubled_area(triangle);
                        let slope = [(b[1] - c[1]) / doubled, (c[0] - b[0]) / doubled];
                        rule.on(triangle, &mut |point, weight| {
                            let ([p, q], u) = (known.gradient(point), known.displacement(point));
                            let share = doubled_area([point, b, c]) / doubled;
                            work[node] += weight * (p * slope[0] + q * slope[1] + reaction * u * share);
                            volume[node] += weight * reaction * u * share;
                            Ok(())
                        })
                        .unwrap();
                    }
                }
                let mut load = known.edge_load(mesh).unwrap();
                let rule = gauss_legendre(EDGE_POINTS).unwrap();
                for i in 0..n {
                    let start = i as f64 / n as f64;
                    for (t, weight, beyond) in known.points_on_bottom(start, 1.0 / n as f64, &rule) {
                        for (node, share) in [(i, 1.0 - t), (i + 1, t)] {
                            load[node] += weight * share / n as f64 * known.normal_stress(beyond);
                        }
                    }
                }
                for node in (0..work.len()).filter(|&node| !held[node]) {
                    let off = work[node] - volume[node] - load[node];
                    assert!(off.abs() < 2e-6, "{known} node {node}: {off:e}");
                }
            }
        }
    }
}
