//! Scalar problems on the unit square with one transition of given regularity and known solution.
//!
//! With z = x − a + iy, a on the bottom edge, ℓ = 2 − ln z, p = τ − 1 and s = 4: u = Re F − s y,
//!
//! F = i z^p / sin πp,  at p = 1: F = i z ℓ^{1−α} / (π (1 − α)),  and i z ln ℓ / π for α = 1.
//!
//! u is harmonic. On y = 0 it is zero to the right of a, and to the left it is −r^p, at p = 1 asymptotically −r
//! ℓ(r)^{−α}: contact on [a, 1]. There σ_N = −r^q ℓ(r)^{−α}; the edge carries the load g = ∂u/∂n − σ_N, as on a strip
//! ([`TransitionPowers`]). The term −s y makes u negative on the other sides and is represented exactly by the
//! elements.
//!
//! * *three Dirichlet sides*: −Δu = 0, u is prescribed on them;
//! * *the whole boundary*, Remark 1 as printed: −Δu + u = f = u, u ≤ 0 on all four sides, g = ∂u/∂n where
//!   there is no contact. The normal, and with it the load, is discontinuous at the corners; u is continuous.
//!
//! Loads are integrated by rules graded toward the transition a: on both parts of its segment, of length L,
//! x = a ± L t^12 with Gauss points t in (0, 1).

use crate::error::{Error, Result};
use crate::mesh::{Part, Point, Triangulation, distance};
use crate::problems::TransitionPowers;
use fractional_sobolev::{Rule, gauss_legendre};
use fractional_sobolev_numeric::transforms::Complex;
use std::f64::consts::PI;
use std::fmt;

/// The slope s: larger than Re F / y on the other three sides for all admissible p, where that is at most 3.5.
const SLOPE: f64 = 4.0;

/// Number of points along each side of a triangle for errors, for p < 1 and for p ≥ 1; one less for loads.
const POINTS: [usize; 2] = [5, 4];
/// Gauss points on a segment, and m: t^{mp−1} is smooth enough for p ≥ 3/10.
const EDGE_POINTS: usize = 24;
const GRADING: i32 = 12;

/// A problem with one transition on a mesh.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Harmonic {
    pub(super) powers: TransitionPowers,
    pub(super) position: f64,
    pub(super) whole_boundary: bool,
}

impl Harmonic {
    /// The solution with the powers of a transition at `position`, with contact conditions on the bottom or on the
    /// whole boundary.
    pub(super) fn new(
        powers: TransitionPowers,
        position: f64,
        whole_boundary: bool,
    ) -> Result<Self> {
        let TransitionPowers { opening, pressure, logarithm } = powers;
        let is_in =
            (0.3..=1.5).contains(&opening) && (opening == 1.0 || (opening - 1.0).abs() > 0.0999);
        Error::require("p", opening, "the union of [3/10, 9/10], {1} and [11/10, 3/2]", is_in)?;
        Error::require("q", pressure, "(-1, inf)", pressure > -1.0 && pressure.is_finite())?;
        let is_log = logarithm == 0.0 || opening == 1.0 && logarithm > 0.0 && logarithm.is_finite();
        Error::require("alpha", logarithm, "{0}; [0, inf) if p = 1", is_log)?;
        Error::require("position", position, "(0, 1)", position > 0.0 && position < 1.0)?;
        Ok(Self { powers, position, whole_boundary })
    }

    /// F and F' at the point (x − a, y).
    fn potential(&self, x: f64, y: f64) -> [Complex<f64>; 2] {
        let (r, phi) = (x.hypot(y), y.atan2(x));
        let TransitionPowers { opening: p, logarithm: alpha, .. } = self.powers;
        let z = Complex::new(x, y);
        if p != 1.0 {
            let power = Complex::from_polar(p * r.powf(p - 1.0), (p - 1.0) * phi);
            let slope = Complex::<f64>::I * power / (p * PI).sin();
            // z^p → 0 where z^{p−1} is not finite.
            let value = if r == 0.0 { Complex::ZERO } else { slope * z / p };
            return [value, slope];
        }
        let ell = Complex::new(2.0 - r.ln(), -phi);
        let (whole, below) = if alpha == 1.0 {
            (ell.ln(), ell.inv())
        } else {
            (ell.powf(1.0 - alpha) / (1.0 - alpha), ell.powf(-alpha))
        };
        let factor = Complex::<f64>::I / PI;
        let value = if r == 0.0 { Complex::ZERO } else { factor * z * whole };
        [value, factor * (whole - below)]
    }

    /// u.
    pub(super) fn displacement(&self, [x, y]: Point) -> f64 {
        self.potential(x - self.position, y)[0].re - SLOPE * y
    }

    /// ∇u.
    pub(super) fn gradient(&self, [x, y]: Point) -> Point {
        let slope = self.potential(x - self.position, y)[1];
        [slope.re, -slope.im - SLOPE]
    }

    /// σ_N on the bottom at the distance x − a.
    pub(super) fn normal_stress(&self, beyond: f64) -> f64 {
        if beyond <= 0.0 {
            return 0.0;
        }
        let TransitionPowers { pressure, logarithm, .. } = self.powers;
        -beyond.powf(pressure) * (2.0 - beyond.ln()).powf(-logarithm)
    }

    /// Number of points along each side of a triangle for errors.
    pub(super) fn points(&self) -> usize {
        POINTS[usize::from(self.powers.opening >= 1.0)]
    }

    /// ∫ g φ_i over the contact part.
    pub(super) fn edge_load(&self, mesh: &Triangulation) -> Result<Vec<f64>> {
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
                let [p, q] = self
                    .gradient([from[0] + t * (to[0] - from[0]), from[1] + t * (to[1] - from[1])]);
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

impl fmt::Display for Harmonic {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let TransitionPowers { opening, pressure, logarithm } = self.powers;
        let where_ = if self.whole_boundary { "whole boundary" } else { "bottom" };
        write!(
            f,
            "mesh transition r^{opening}, r^{pressure}, |ln r|^-{logarithm}, contact on the {where_}"
        )
    }
}

#[cfg(test)]
pub(super) mod tests {
    use super::super::{Formula, KnownSolution, rule};
    use super::*;
    use crate::mesh::doubled_area;

    pub(in super::super) fn all_known(whole_boundary: bool) -> Vec<Harmonic> {
        let of_tau = [1.4, 1.5, 1.75, 2.1, 2.25, 2.5].map(TransitionPowers::of_regularity);
        let of_log = [0.0, 0.75, 1.0, 1.5].map(|logarithm| TransitionPowers {
            opening: 1.0,
            pressure: 0.0,
            logarithm,
        });
        let all = of_tau.into_iter().chain(of_log);
        all.map(|powers| Harmonic::new(powers, 1.0 / 3.0, whole_boundary).unwrap()).collect()
    }

    #[test]
    fn signs_and_derivatives_are_those_claimed() {
        for known in all_known(true) {
            for i in 1..100 {
                let t = f64::from(i) / 100.0;
                let bottom = known.displacement([t, 0.0]);
                let beyond = t - known.position;
                assert!(
                    if beyond > 0.0 { bottom.abs() < 1e-15 } else { bottom < 0.0 },
                    "{known} {t} {bottom}"
                );
                assert!(
                    known.normal_stress(beyond) <= 0.0
                        && bottom * known.normal_stress(beyond) == 0.0,
                    "{known} {t}"
                );
                for point in [[0.0, t], [1.0, t], [t, 1.0]] {
                    assert!(known.displacement(point) < 0.0, "{known} {point:?}");
                }
            }
            // Central differences: h² times third derivatives, ε/h of rounding.
            let (h, [x, y]) = (1e-4, [0.7, 0.3]);
            let around =
                [[x + h, y], [x - h, y], [x, y + h], [x, y - h]].map(|p| known.displacement(p));
            let [p, q] = known.gradient([x, y]);
            assert!(((around[0] - around[1]) / (2.0 * h) - p).abs() < 1e-7, "{known}");
            assert!(((around[2] - around[3]) / (2.0 * h) - q).abs() < 1e-7, "{known}");
            let laplace = (around.iter().sum::<f64>() - 4.0 * known.displacement([x, y])) / (h * h);
            assert!(laplace.abs() < 1e-5, "{known}: {laplace}");
            // u_N = −r^p, and at p = 1 near −r ℓ^{−α}.
            let r = 1e-9;
            let (found, p) = (-known.displacement([known.position - r, 0.0]), known.powers.opening);
            let expected = r.powf(p) * (2.0 - r.ln()).powf(-known.powers.logarithm);
            let near = if known.powers.logarithm == 0.0 { 1e-5 } else { 0.05 };
            assert!((found / expected - 1.0).abs() < near, "{known}: {found} {expected}");
        }
    }

    /// a(u, φ_i) = ∫ f φ_i + ∫ (g + σ_N) φ_i at every node off the Dirichlet boundary: u solves the problem
    /// of its loads.
    #[test]
    fn the_loads_are_those_of_u() {
        let n = 4;
        for whole_boundary in [false, true] {
            for known in all_known(whole_boundary) {
                let problem =
                    KnownSolution { formula: Formula::Harmonic(known) }.problem(n).unwrap();
                let mesh = problem.mesh();
                let held = mesh.nodes_on(Part::Dirichlet);
                let mut work = vec![0.0; mesh.nodes().len()];
                let rule = rule(10, &[known.position]).unwrap();
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
                            work[node] +=
                                weight * (p * slope[0] + q * slope[1] + reaction * u * share);
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
                    for (t, weight, beyond) in known.points_on_bottom(start, 1.0 / n as f64, &rule)
                    {
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
