//! Q_h - R_h of [`super::regional`]: the values of the dual forms of the regional form and of the comparison
//! form over the piecewise linear functions on M equal elements, and their difference.
//!
//! If R of [`super::comparison`] has more than one node, windows are used at the ends. There b(x) grows faster
//! than the nodes resolve, and the mesh would have to be doubled many times. Therefore the part of f within ℓ/2
//! of an end is treated separately: on an interval of length ℓ, on meshes of widths h and h/8; then on ℓ/8,
//! with h/8 and h/64. The differences are added.

use super::comparison::{Comparison, Part};
use super::cosines::Cosines;
use crate::error::{Error, Result};
use crate::estimate::Tolerance;
use crate::gram::{GramOperator, add_mass, mass_linears};
use crate::mesh::Mesh;
use crate::numeric::conjugate_gradients::{ConjugateGradients, Step, System};
use crate::order::Order;
use crate::piecewise::PiecewisePolynomial;
use crate::quadrature::Rule;
use std::iter::once;

/// Factor between the interval and the first window, and between successive windows and their mesh sizes.
const WINDOW: usize = 16;
const FINER: usize = 8;
const WINDOWS: usize = 2;
/// Number of elements of f from which an end has a window.
const CROWD: usize = 4;
/// Rounding error of Q_h relative to ε M^{2ν}; it is below 0.02 in experiments.
const ROUNDING: f64 = 0.1;

/// The form m M + a A on equal elements.
struct Regional {
    operator: GramOperator,
    mass: (Vec<f64>, Vec<f64>),
    cosines: Cosines,
    weights: [f64; 2],
    symbol: f64,
}

impl System for Regional {
    type Error = Error;

    fn apply(&mut self, x: &[f64], out: &mut [f64]) -> Result<()> {
        let [m, a] = self.weights;
        out.iter_mut().zip(self.operator.apply(x)?).for_each(|(o, y)| *o = a * y);
        add_mass(m, &self.mass, x, out);
        Ok(())
    }

    fn precondition(&mut self, r: &[f64], out: &mut [f64]) -> Result<()> {
        self.cosines.solve(r, out, [self.weights[0], self.symbol])
    }
}

/// Q_h - R_h on one mesh, including the windows.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Missed {
    pub(super) value: f64,
    /// error of the iteration and of rounding
    pub(super) error: f64,
    pub(super) steps: u64,
}

/// The function f with mean zero on (0, 1).
pub(super) struct Rough<'a> {
    pub(super) u: &'a PiecewisePolynomial,
    pub(super) unit: f64,
    pub(super) mean: f64,
    pub(super) order: Order,
    pub(super) weights: [f64; 2],
    pub(super) comparison: Comparison,
}

impl Rough<'_> {
    pub(super) fn whole(&self) -> Part {
        Part::whole(self.u.mesh(), self.weights)
    }

    /// True if every element of f is divided into the same number of equal elements.
    pub(super) fn cuts_alike(&self, cells: usize) -> bool {
        let partition = self.u.mesh();
        partition.uniform_length().is_some() && cells.is_multiple_of(partition.len())
    }

    /// The loads ∫ f φ_i on M equal elements of a part, and ∫ θ f φ_i for every θ.
    fn loads(&self, part: &Part, cells: usize, shares: &[Vec<f64>]) -> Result<Vec<Vec<f64>>> {
        let partition = self.u.mesh();
        let rule = Rule::gauss_legendre(self.u.degree() / 2 + 2)?;
        let mut loads = vec![vec![0.0; cells + 1]; 1 + shares.len()];
        let mut add = |cell: usize, element: usize, [s0, s1]: [f64; 2], [t0, t1]: [f64; 2]| {
            // The part (s0, s1) of a cell is the part (t0, t1) of an element; its length is that of the element, which
            // the positions may have rounded to nothing.
            let h = (t1 - t0) * partition.lengths()[element] / (partition.total() * part.length);
            let mut here = [0.0; 2];
            for (x, w) in rule.iter() {
                let value =
                    self.u.pieces()[element].value(t0 + (t1 - t0) * x) / self.unit - self.mean;
                let s = s0 + (s1 - s0) * x;
                here[0] += w * h * value * (1.0 - s);
                here[1] += w * h * value * s;
            }
            let factors = shares.iter().map(|share| share[element - part.elements.start]);
            for (load, factor) in loads.iter_mut().zip(once(1.0).chain(factors)) {
                load[cell] += factor * here[0];
                load[cell + 1] += factor * here[1];
            }
        };
        if part.length == 1.0 && self.cuts_alike(cells) {
            let parts = cells / partition.len();
            for cell in 0..cells {
                let (element, part) = (cell / parts, (cell % parts) as f64);
                add(cell, element, [0.0, 1.0], [part / parts as f64, (part + 1.0) / parts as f64]);
            }
        } else {
            let scale = cells as f64 / part.length;
            let position = |i: usize| {
                ((partition.from_left()[i] / partition.total() - part.start) * scale)
                    .clamp(0.0, cells as f64)
            };
            let begin = position(part.elements.start);
            let mut cell = (begin as usize).min(cells - 1);
            let mut from = begin - cell as f64;
            for element in part.elements.clone() {
                let [start, end] = [position(element), position(element + 1)];
                let (length, mut at) = (end - start, 0.0f64);
                loop {
                    let last = cell + 1 == cells;
                    let to = (end - cell as f64).clamp(from, 1.0);
                    let reached = end <= (cell + 1) as f64 || last;
                    let until = if reached || length <= 0.0 {
                        1.0
                    } else {
                        ((cell + 1) as f64 - start) / length
                    };
                    let until = until.clamp(at, 1.0);
                    add(cell, element, [from, to], [at, until]);
                    if reached {
                        from = to;
                        if to >= 1.0 && !last {
                            (cell, from) = (cell + 1, 0.0);
                        }
                        break;
                    }
                    (cell, from, at) = (cell + 1, 0.0, until);
                }
            }
        }
        Ok(loads)
    }

    /// Q_h - R_h on a part.
    fn missed_on(&self, part: &Part, cells: usize, goal: f64) -> Result<Missed> {
        let mesh = Mesh::uniform(cells, 1.0)?;
        let shares = self.comparison.shares(self.u.mesh(), part);
        let mut loads = self.loads(part, cells, &shares)?;
        let mut load = loads.remove(0);
        if part.length < 1.0 {
            // the mean of a window alone
            let mean: f64 = load.iter().sum();
            let share = mean / cells as f64;
            load.iter_mut().for_each(|value| *value -= share);
            load[0] += 0.5 * share;
            load[cells] += 0.5 * share;
        }
        let symbol = part.weights[1] * self.comparison.constant;
        let mut system = Regional {
            operator: GramOperator::linears(&mesh, self.order, Tolerance::reference())?,
            mass: mass_linears(&mesh),
            cosines: Cosines::new(cells, self.order),
            weights: part.weights,
            symbol,
        };
        let nodes = &self.comparison.nodes;
        let known = if shares.is_empty() {
            system.cosines.form(&load, &[(&load, nodes[0])], symbol)?
        } else {
            let others: Vec<(&[f64], f64)> =
                loads.iter().map(Vec::as_slice).zip(nodes.iter().copied()).collect();
            system.cosines.form(&load, &others, symbol)?
        };
        let mut iteration = ConjugateGradients::new(load.len());
        iteration.start(&mut system, &load)?;
        let (mut x, mut value, mut last, mut steps) =
            (vec![0.0; load.len()], 0.0, f64::INFINITY, 0);
        for _ in 0..200 {
            let Step::Gain(gain) = iteration.step(&mut system, &mut x)? else { break };
            steps += 1;
            value += gain;
            let settled = gain.max(0.2 * last) <= 1e-2 * goal * value;
            last = gain;
            if settled {
                break;
            }
        }
        let rounding = ROUNDING * f64::EPSILON * (cells as f64).powf(2.0 * self.order.value());
        let error = if last.is_finite() { 2.0 * last } else { 0.0 } + (rounding + 1e-14) * value;
        Ok(Missed { value: value - known, error, steps })
    }

    /// Q_h - R_h on M equal elements, including the windows at the ends.
    pub(super) fn missed(&self, cells: usize, goal: f64) -> Result<Missed> {
        let whole = self.whole();
        let (mut sum, partition) = (self.missed_on(&whole, cells, goal)?, self.u.mesh());
        let (kept, windows) =
            (cells / WINDOW, if self.comparison.nodes.len() > 1 { WINDOWS } else { 0 });
        for depth in 0..windows {
            let length = kept as f64 / cells as f64 / FINER.pow(depth as u32) as f64;
            for right in [false, true] {
                let part = whole.window(partition, self.order, length, right);
                if part.elements.len() < CROWD {
                    continue;
                }
                for (cells, sign) in [(kept, -1.0), (kept * FINER, 1.0)] {
                    let missed = self.missed_on(&part, cells, goal)?;
                    sum.value += sign * length * missed.value;
                    sum.error += length * missed.error;
                    sum.steps += missed.steps;
                }
            }
        }
        Ok(sum)
    }
}
