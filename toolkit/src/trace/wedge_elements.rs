//! Finite elements in the angle: polynomials on a mesh graded towards both edges of a wedge, and c θ^{2s−1} on
//! the first element, the singular part of the function of least energy.
//!
//! With ψ = 1 − η, η(0) = 0, the energy is E(1) − 2 r·η + η·Mη, M the matrix of the form and r·η its value
//! for 1 and η. The terms with the kernel K_τ are formed from differences of the basis functions, so that
//! constants do not contribute to them and there is no cancellation.

use super::angular_kernel::AngularKernel;
use crate::closed_forms;
use crate::error::Result;
use crate::order::Order;
use crate::quadrature::Rule;
use nalgebra::DMatrix;
use std::f64::consts::PI;

/// The discretisation parameters: degree, number of points of a rule, number of levels of rules graded towards
/// a singular point, length of the first element.
#[derive(Clone, Copy)]
pub(super) struct Fineness {
    pub(super) degree: usize,
    pub(super) points: usize,
    pub(super) levels: i32,
    pub(super) first: f64,
}

/// Ratio of neighbouring elements and of neighbouring cells of a graded rule, and number of elements next to
/// the far edge.
const RATIO: f64 = 0.2;
const CELL_RATIO: f64 = 0.15;
const FAR: i32 = 4;

/// Points and weights on (0, 1).
type Points = Vec<(f64, f64)>;

/// The quadratic form of the energy.
pub(super) struct AngularForm {
    pub(super) matrix: DMatrix<f64>,
    pub(super) linear: Vec<f64>,
    pub(super) constant: f64,
}

/// The mesh on (0, ω) with its rules.
pub(super) struct WedgeElements {
    order: Order,
    angle: f64,
    /// The ends of the elements, from 0 to ω.
    cuts: Vec<f64>,
    /// Local nodes with their barycentric weights.
    nodes: Points,
    plain: Points,
    /// The rules for pairs within one element, for touching elements, and towards 0.
    same: Points,
    touching: Points,
    graded: Points,
}

/// A rule for t^β times the sum of a smooth function and less singular terms; its weights do not contain the
/// power.
fn graded(beta: f64, fineness: Fineness) -> Result<Points> {
    let (n, last) = (fineness.points, CELL_RATIO.powi(fineness.levels));
    let inner = Rule::gauss_jacobi(n, 0.0, beta)?;
    let mut all: Points = inner.iter().map(|(t, w)| (last * t, last * w * t.powf(-beta))).collect();
    let plain = Rule::gauss_legendre(n)?;
    for level in (0..fineness.levels).rev() {
        let (low, high) = (CELL_RATIO.powi(level + 1), CELL_RATIO.powi(level));
        all.extend(plain.iter().map(|(t, w)| (low + (high - low) * t, (high - low) * w)));
    }
    Ok(all)
}

impl WedgeElements {
    pub(super) fn new(order: Order, angle: f64, fineness: Fineness) -> Result<Self> {
        let (s, p) = (order.value(), fineness.degree);
        let half = 0.5 * angle;
        let left = ((fineness.first / half).ln() / RATIO.ln()).ceil() as i32;
        let mut cuts = vec![0.0];
        cuts.extend((0..=left).rev().map(|k| half * RATIO.powi(k)));
        cuts.extend((1..=FAR).map(|k| angle - half * RATIO.powi(k)));
        cuts.push(angle);
        let nodes = (0..=p).map(|i| {
            let ends = if i == 0 || i == p { 0.5 } else { 1.0 };
            let x = (0.5 * PI * i as f64 / p as f64).sin().powi(2);
            (x, if i % 2 == 0 { ends } else { -ends })
        });
        Ok(Self {
            order,
            angle,
            cuts,
            nodes: nodes.collect(),
            plain: Rule::gauss_legendre(fineness.points)?.iter().collect(),
            same: graded(1.0 - 2.0 * s, fineness)?,
            touching: graded(2.0 - 2.0 * s, fineness)?,
            graded: graded(0.0, fineness)?,
        })
    }

    /// An angle below every distance of two points of the rules, which is as small as 1−s near s = 1.
    pub(super) fn smallest(&self) -> f64 {
        let shortest = (0..self.cuts.len() - 1).map(|e| self.size(e)).fold(self.angle, f64::min);
        let rules = [&self.plain, &self.same, &self.touching, &self.graded];
        let nearest = rules.into_iter().flatten().map(|&(t, _)| t).fold(1.0, f64::min);
        0.5 * nearest * shortest
    }

    fn size(&self, e: usize) -> f64 {
        self.cuts[e + 1] - self.cuts[e]
    }

    /// The first unknown of an element and the number of its unknowns: 0 is the value at the end of the first
    /// element.
    fn unknowns(&self, e: usize) -> (usize, usize) {
        let p = self.nodes.len() - 1;
        if e == 0 { (0, 1) } else { ((e - 1) * p, p + 1) }
    }

    /// The values of the basis of element e at the local position x.
    fn basis(&self, e: usize, x: f64, values: &mut [f64]) {
        if e == 0 {
            values[0] = x.powf(2.0 * self.order.offset());
            return;
        }
        let mut total = 0.0;
        for (value, &(at, weight)) in values.iter_mut().zip(&self.nodes) {
            *value = if x == at { 1e300 } else { weight / (x - at) };
            total += *value;
        }
        values.iter_mut().for_each(|value| *value /= total);
    }

    /// (local position in e, in f, distance, weight) for a rule for pairs of elements e ≤ f.
    fn pairs(&self, e: usize, f: usize) -> Vec<[f64; 4]> {
        let (h, k) = (self.size(e), self.size(f));
        let mut all = Vec::new();
        let inside = if e == 0 { &self.graded } else { &self.plain };
        if e == f {
            for &(a, v) in &self.same {
                for &(y, w) in inside {
                    let low = y * (1.0 - a);
                    all.push([low, low + a, h * a, v * w * (1.0 - a) * h * h]);
                }
            }
        } else if f == e + 1 {
            // θ = end of e − h u, θ' = start of f + k v, (u, v) = ρ (1, κ) or ρ (κ, 1); u → 1 is singular for
            // e = 0.
            let towards_one = |rule: &Points| -> Points {
                if e > 0 {
                    return rule.clone();
                }
                let low = rule.iter().map(|&(t, w)| (0.5 * t, 0.5 * w));
                low.chain(self.graded.iter().map(|&(t, w)| (1.0 - 0.5 * t, 0.5 * w))).collect()
            };
            let (outer, inner) = (towards_one(&self.touching), towards_one(&self.plain));
            for &(rho, v) in &outer {
                for &(kappa, w) in &inner {
                    for (x, y) in [(rho, rho * kappa), (rho * kappa, rho)] {
                        all.push([1.0 - x, y, h * x + k * y, v * w * rho * h * k]);
                    }
                }
            }
        } else {
            for &(x, v) in inside {
                for &(y, w) in &self.plain {
                    let distance = self.cuts[f] - self.cuts[e] + k * y - h * x;
                    all.push([x, y, distance, v * w * h * k]);
                }
            }
        }
        all
    }

    /// The energy with the kernel for one τ; if `mirrored`, with the mirror image at ω.
    pub(super) fn form(&self, kernel: &AngularKernel, mirrored: bool) -> Result<AngularForm> {
        let elements = self.cuts.len() - 1;
        let (last, count) = self.unknowns(elements - 1);
        let size = last + count;
        let mut form = AngularForm {
            matrix: DMatrix::zeros(size, size),
            linear: vec![0.0; size],
            constant: 0.0,
        };
        form.matrix[(0, 0)] = self.first_energy()?;
        for e in 0..elements {
            for f in e..elements {
                self.add(e, f, kernel, mirrored, &mut form);
            }
        }
        Ok(form)
    }

    fn add(
        &self,
        e: usize,
        f: usize,
        kernel: &AngularKernel,
        mirrored: bool,
        form: &mut AngularForm,
    ) {
        let ((start, n), (other, m)) = (self.unknowns(e), self.unknowns(f));
        let offset = if f <= e + 1 { other - start } else { n };
        let all = offset + m;
        let place = |i: usize| if f <= e + 1 || i < n { start + i } else { other + i - n };
        let (mut block, mut linear) = (vec![0.0; all * all], vec![0.0; all]);
        let (mut a, mut b) = (vec![0.0; all], vec![0.0; all]);
        for [x, y, distance, weight] in self.pairs(e, f) {
            self.basis(e, x, &mut a[..n]);
            self.basis(f, y, &mut b[offset..]);
            let [mut near, mut rest] = kernel.at(distance);
            if (e, f) == (0, 0) {
                // In closed form.
                near = 0.0;
            }
            if mirrored {
                let to_end =
                    |e: usize, x: f64| self.angle - self.cuts[e + 1] + self.size(e) * (1.0 - x);
                let [k, d] = kernel.at(to_end(e, x) + to_end(f, y));
                (near, rest) = (near + k, rest + d);
            }
            let (near, rest) = (2.0 * weight * near, 2.0 * weight * rest);
            form.constant += 2.0 * rest;
            for i in 0..all {
                let step = near * (a[i] - b[i]);
                linear[i] += rest * (a[i] + b[i]);
                for j in 0..=i {
                    block[i * all + j] += step * (a[j] - b[j]) + rest * (a[i] * a[j] + b[i] * b[j]);
                }
            }
        }
        for i in 0..all {
            form.linear[place(i)] += linear[i];
            for j in 0..=i {
                form.matrix[(place(i), place(j))] += block[i * all + j];
                if i != j {
                    form.matrix[(place(j), place(i))] += block[i * all + j];
                }
            }
        }
    }

    /// The double integral of (θ/x₀)^{2s−1} on (0, x₀) with the leading part of the kernel.
    fn first_energy(&self) -> Result<f64> {
        let s = self.order.value();
        let leading = PI.sqrt() * libm::tgamma(s + 0.5) / libm::tgamma(s + 1.0);
        let power =
            closed_forms::power_seminorm_squared(2.0 * self.order.offset(), self.order)?.value;
        Ok(leading * self.cuts[1].powf(1.0 - 2.0 * s) * power)
    }
}
