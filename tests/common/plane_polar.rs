//! r^a sin(bφ) on polygons seen from a corner, in polar coordinates: a computation apart from triangles and Duffy.
//!
//! With r = R(φ)ρ, r' = R(φ')ρ', v = ln(ρ/ρ') > 0 and κ = e^{-v} R(φ')/R(φ) one radius integrates to
//! R(φ)^{2a+2−2s}/(2a+2−2s); left are φ, φ' = φ ± ψ and v, on cells that shrink towards v = ψ = 0.

use fractional_sobolev::{Rule, gauss_legendre};
use std::f64::consts::PI;

/// Rings towards the singular point, and their ratio.
const RINGS: usize = 16;
const RATIO: f64 = 3.0;

/// A polygon with corners 0, P_1, ..., P_m, counterclockwise, P_1 on the first axis.
pub struct Star {
    /// Angles of P_1 ... P_m, and of every side between them the direction and the distance from 0.
    angles: Vec<f64>,
    sides: Vec<(f64, f64)>,
}

impl Star {
    pub fn new(points: &[[f64; 2]]) -> Self {
        let mut angles = vec![0.0f64];
        let sides = points
            .windows(2)
            .map(|ends| {
                let [[a, b], [c, d]] = [ends[0], ends[1]];
                angles.push(angles[angles.len() - 1] + (a * d - b * c).atan2(a * c + b * d));
                let (x, y) = (c - a, d - b);
                let length = x.hypot(y);
                ((-x).atan2(y), (a * y - b * x) / length)
            })
            .collect();
        Self { angles, sides }
    }

    fn log_radius(&self, phi: f64) -> f64 {
        let side =
            self.angles[1..self.angles.len() - 1].iter().filter(|&&angle| phi > angle).count();
        let (direction, height) = self.sides[side];
        (height / (phi - direction).cos()).ln()
    }

    /// |r^a sin(bφ)|²_s: rings of three rectangles towards v = ψ = 0, whose sums are geometric in the end.
    pub fn squared(&self, a: f64, b: f64, s: f64) -> f64 {
        let angle = self.angles[self.angles.len() - 1];
        let (gap, most) = (a + 1.0 - s, 0.3 * angle.min(1.0));
        let cuts: Vec<f64> =
            (0..=RINGS).map(|k| most * RATIO.powi(k as i32 - RINGS as i32)).collect();
        let mut psis = vec![most, angle];
        psis.extend(
            (2..)
                .map(|k| 0.3 * f64::from(k))
                .take_while(|&psi| psi < angle)
                .filter(|&psi| psi > most),
        );
        for from in &self.angles {
            psis.extend(
                self.angles.iter().map(|to| to - from).filter(|&psi| psi > most && psi < angle),
            );
        }
        psis.sort_by(f64::total_cmp);
        let depth = 26.0 / (1.0 + a.min(0.0));
        let mut vs = vec![most];
        while vs[vs.len() - 1] < depth {
            vs.push(vs[vs.len() - 1] * 1.5 + 0.1);
            let last = vs.len() - 1;
            vs[last] = vs[last].min(vs[last - 1] + 1.0);
        }
        let at = |psi: [f64; 2], v: [f64; 2]| self.rectangle([a, b, s], psi, v);
        let ring = |k: usize| {
            let (low, cell) = ([0.0, cuts[k]], [cuts[k], cuts[k + 1]]);
            at(low, cell) + at(cell, low) + at(cell, cell)
        };
        let quotient = RATIO.powf(2.0 * s - 2.0);
        let mut sum = ring(0) * quotient / (1.0 - quotient) + (0..RINGS).map(ring).sum::<f64>();
        let pairs = |cuts: &[f64]| -> Vec<[f64; 2]> {
            let cells = cuts.windows(2).filter(|cell| cell[1] > cell[0] + 1e-12);
            cells.map(|cell| [cell[0], cell[1]]).collect()
        };
        for psi in pairs(&psis) {
            sum += at(psi, [0.0, most]);
        }
        for v in pairs(&vs) {
            sum += at([0.0, most], v);
            sum += pairs(&psis).into_iter().map(|psi| at(psi, v)).sum::<f64>();
        }
        sum / gap
    }

    fn rectangle(&self, [a, b, s]: [f64; 3], psi: [f64; 2], v: [f64; 2]) -> f64 {
        let (rule, gap) = (gauss_legendre(11).unwrap(), a + 1.0 - s);
        let mut sum = 0.0;
        for (x, weight) in rule.iter() {
            let (psi, weight) = (psi[0] + (psi[1] - psi[0]) * x, weight * (psi[1] - psi[0]));
            let phis = self.phis(psi, &rule);
            for (y, w) in rule.iter() {
                let at = v[0] + (v[1] - v[0]) * y;
                let one = |g: f64, h: f64, own: f64, other: f64| {
                    let log = other - own - at;
                    let rest = -log.exp_m1();
                    let half = (0.5 * psi).sin();
                    let distance = rest * rest + 4.0 * (1.0 - rest) * half * half;
                    let difference = g - (a * log).exp() * h;
                    (2.0 * gap * own + 2.0 * log).exp()
                        * difference
                        * difference
                        * distance.powf(-1.0 - s)
                };
                let both = |&(phi, w, first, second): &(f64, f64, f64, f64)| {
                    let (g, h) = ((b * phi).sin(), (b * (phi + psi)).sin());
                    w * (one(g, h, first, second) + one(h, g, second, first))
                };
                sum += weight * w * (v[1] - v[0]) * phis.iter().map(both).sum::<f64>();
            }
        }
        sum
    }

    /// Points φ with weights, ln R(φ) and ln R(φ + ψ).
    fn phis(&self, psi: f64, rule: &Rule) -> Vec<(f64, f64, f64, f64)> {
        let end = self.angles[self.angles.len() - 1] - psi;
        let mut cuts: Vec<f64> =
            self.angles.iter().flat_map(|&angle| [angle, angle - psi]).collect();
        cuts.extend((1..).map(|k| 0.25 * PI * f64::from(k)).take_while(|&cut| cut < end));
        cuts.retain(|&cut| (0.0..=end).contains(&cut));
        cuts.sort_by(f64::total_cmp);
        let cell = |cut: &[f64]| -> Vec<(f64, f64, f64, f64)> {
            let (from, width) = (cut[0], cut[1] - cut[0]);
            let place = |(t, w): (f64, f64)| {
                let phi = from + width * t;
                (phi, w * width, self.log_radius(phi), self.log_radius(phi + psi))
            };
            rule.iter().map(place).collect()
        };
        cuts.windows(2).flat_map(cell).collect()
    }
}
