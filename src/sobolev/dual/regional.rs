//! The dual of the norm (1.1): piecewise linears on equal elements, with what they miss taken from a form
//! that is known twice.
//!
//! Let Q = ⟨f, (1 + A)^{-1} f⟩ with A of |·|²_ν, Q_h the same over the piecewise linears on M equal elements,
//! and R, R_h the two for the form of [`super::cosines`], R exact and R_h by one transform. At a jump of f
//! both representers have the same singularity x^{2ν}, and near it both meshes are the same: what R_h misses
//! is what Q_h misses, up to the next singularity x^{4ν} and the ends. So
//!   Q ≈ Q_h + R - R_h,
//! whose error falls like h^{min(1+4ν, 4-2ν)} per jump (that of Q_h like h^{1+2ν}), wherever the jumps lie
//! between the nodes: the mesh need not be that of f. M is doubled; the error is that of the doubling, and
//! where every element of f is cut alike and three values fall by the known factor, of the limit they point
//! to. Q_h is found by conjugate gradients with R_h's form as preconditioner (5 to 15 steps). The mean is
//! split off: its representer is itself. Rounding of the product grows like M^{2ν} and ends the doubling.
//! Lengths are in units of the interval: 1 + A becomes L^{2ν} + A over L^{2ν} (L ≤ 1) or 1 + L^{-2ν} A.

use super::cells::Cells;
use super::cosines::{Cosines, exact_form, symbol_constant};
use crate::error::{Error, Result};
use crate::estimate::{Estimate, Tolerance, Work};
use crate::numeric::conjugate_gradients::{ConjugateGradients, Step, System};
use crate::quadrature::Rule;
use crate::sobolev::gram::GramOperator;
use crate::sobolev::gram::dense::mass_linears;
use crate::sobolev::order::FractionalOrder;
use crate::sobolev::partition::Partition;
use crate::sobolev::piecewise::PiecewisePolynomial;

/// Equal elements at first and at most.
const FIRST: usize = 64;
const MOST: usize = 1 << 20;
/// Elements from which on a mesh is only halved if the tolerance is within reach, SPARE halvings granted.
const LARGE: usize = 1 << 18;
const SPARE: f64 = 0.0;
/// Rounding of Q_h relative to ε M^{2ν}; measured below 0.02.
const ROUNDING: f64 = 0.1;
/// A over 1 on the shortest element; its root, the share of layers, is below the last digit.
const NOTHING: f64 = 1e-40;
/// Values that fall by the known factor up to this share of it are taken to their limit.
const SAME_RATE: f64 = 0.35;

/// m M + a A on equal elements.
struct Regional {
    operator: GramOperator,
    mass: Vec<f64>,
    off: Vec<f64>,
    cosines: Cosines,
    weights: [f64; 2],
    symbol: f64,
}

impl System for Regional {
    fn apply(&mut self, x: &[f64], out: &mut [f64]) -> Result<()> {
        let [m, a] = self.weights;
        out.iter_mut().zip(self.operator.apply(x)?).for_each(|(o, y)| *o = a * y);
        for i in 0..x.len() {
            out[i] += m * self.mass[i] * x[i];
            if i + 1 < x.len() {
                out[i] += m * self.off[i] * x[i + 1];
                out[i + 1] += m * self.off[i] * x[i];
            }
        }
        Ok(())
    }

    fn precondition(&mut self, r: &[f64], out: &mut [f64]) -> Result<()> {
        let [m, a] = self.weights;
        self.cosines.solve(r, out, [m, a * self.symbol])
    }
}

/// One mesh: Q_h + R - R_h.
#[derive(Debug, Clone, Copy)]
struct Level {
    value: f64,
    /// of the iteration, and of rounding
    error: f64,
    steps: u64,
    /// every element of f is cut into the same number of equal elements
    alike: bool,
}

/// f without mean on (0, 1).
struct Rough<'a> {
    u: &'a PiecewisePolynomial,
    unit: f64,
    mean: f64,
    order: FractionalOrder,
    weights: [f64; 2],
    /// β and c of the form that is known twice, and R
    comparison: [f64; 2],
    exact: f64,
}

impl Rough<'_> {
    fn cuts_alike(&self, cells: usize) -> bool {
        let partition = self.u.partition();
        partition.uniform_length().is_some() && cells.is_multiple_of(partition.len())
    }

    /// ∫ f φ_i on M equal elements of (0, 1).
    fn load(&self, cells: usize) -> Result<Vec<f64>> {
        let partition = self.u.partition();
        let (count, total) = (partition.len(), partition.total());
        let rule = Rule::gauss_legendre(self.u.degree() / 2 + 2)?;
        let mut load = vec![0.0; cells + 1];
        let mut add = |cell: usize, element: usize, [s0, s1]: [f64; 2], [t0, t1]: [f64; 2]| {
            // the part (s0, s1) of a cell is the part (t0, t1) of an element
            let h = (s1 - s0) / cells as f64;
            for (x, w) in rule.iter() {
                let value = self.u.pieces()[element].value(t0 + (t1 - t0) * x) / self.unit - self.mean;
                let s = s0 + (s1 - s0) * x;
                load[cell] += w * h * value * (1.0 - s);
                load[cell + 1] += w * h * value * s;
            }
        };
        if self.cuts_alike(cells) {
            let parts = cells / count;
            for cell in 0..cells {
                let (element, part) = (cell / parts, (cell % parts) as f64);
                add(cell, element, [0.0, 1.0], [part / parts as f64, (part + 1.0) / parts as f64]);
            }
            return Ok(load);
        }
        let (mut cell, mut from) = (0, 0.0f64);
        for element in 0..count {
            let [start, end] =
                [element, element + 1].map(|i| partition.from_left()[i] / total * cells as f64);
            let (length, mut at) = (end - start, 0.0f64);
            loop {
                let last = cell + 1 == cells;
                let (to, reached) = ((end - cell as f64).clamp(from, 1.0), end <= (cell + 1) as f64 || last);
                let until = if reached || length <= 0.0 { 1.0 } else { ((cell + 1) as f64 - start) / length };
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
        Ok(load)
    }

    fn level(&self, cells: usize, goal: f64) -> Result<Level> {
        let mesh = Partition::uniform(cells, 1.0)?;
        let load = self.load(cells)?;
        let (mass, off) = mass_linears(&mesh);
        let mut system = Regional {
            operator: GramOperator::linears(&mesh, self.order, Tolerance::reference())?,
            mass,
            off,
            cosines: Cosines::new(cells, self.order),
            weights: self.weights,
            symbol: symbol_constant(self.order),
        };
        let missed = self.exact - system.cosines.form(&load, self.comparison)?;
        let mut iteration = ConjugateGradients::new(load.len());
        iteration.start(&mut system, &load)?;
        let (mut x, mut value, mut last, mut steps) = (vec![0.0; load.len()], 0.0, f64::INFINITY, 0);
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
        let error = if last.is_finite() { 2.0 * last } else { 0.0 };
        let alike = self.cuts_alike(cells);
        Ok(Level { value: value + missed, error: error + (rounding + 1e-14) * value, steps, alike })
    }

    /// The factor by which the difference of two levels falls at the next.
    fn rate(&self) -> f64 {
        let nu = self.order.value();
        (1.0 + 4.0 * nu).min(4.0 - 2.0 * nu).exp2()
    }

    /// The limit of the last levels, and its error.
    fn limit(&self, levels: &[Level]) -> Option<(f64, f64)> {
        let [.., a, b, c] = levels else { return None };
        let (before, last) = (b.value - a.value, c.value - b.value);
        let own = c.error + b.error;
        // Where jumps lie between the nodes one difference may be small by chance.
        let plain = (c.value, (2.0 * last.abs()).max(before.abs()) + own);
        let rate = self.rate();
        if !a.alike || ((before / last) / rate - 1.0).abs() > SAME_RATE {
            return Some(plain);
        }
        let corrections = [before, last].map(|difference| difference / (rate - 1.0));
        let limits = [b.value + corrections[0], c.value + corrections[1]];
        let error = (limits[1] - limits[0]).abs().max(0.1 * corrections[1].abs());
        Some(if error + own < plain.1 { (limits[1], error + own) } else { plain })
    }
}

impl PiecewisePolynomial {
    pub(super) fn dual_of_regional(&self, order: FractionalOrder, tolerance: Tolerance) -> Result<Estimate> {
        let unit = self.pieces().iter().map(|piece| piece.size()).fold(0.0, f64::max);
        if unit == 0.0 {
            return Estimate::new(0.0, 0.0, Work::default());
        }
        let (total, nu) = (self.partition().total(), order.value());
        let cells = Cells::new(self, unit)?;
        let mean = cells.mean();
        let rest = cells.minus(mean)?;
        let ulps = 8.0 * f64::EPSILON * mean.abs();
        let finish = |value: f64, error: f64, work: Work| {
            Estimate::new(mean * mean + value, error + ulps * (mean.abs() + value.max(0.0).sqrt()), work)?
                .sqrt()?
                .times(unit)?
                .times(total.sqrt())
        };
        let square = rest.square();
        // Q is at most ∥f∥²: what is left of a constant is its rounding
        if square <= ulps * ulps {
            return finish(0.0, square, Work { points: self.partition().len() as u64, ..Work::default() });
        }
        // 1 + A = (m + a A) / factor in units of the interval
        let scale = total.powf(2.0 * nu);
        let (weights, factor) = if total <= 1.0 { ([scale, 1.0], scale) } else { ([1.0, 1.0 / scale], 1.0) };
        let symbol = symbol_constant(order) * weights[1];
        // Layers far thinner than every element: u is f.
        if symbol * rest.shortest().powf(-2.0 * nu) < NOTHING {
            return finish(square, 4.0 * f64::EPSILON * square, Work::default());
        }
        // What A lacks of c A^ν in the middle: 2 ∫ over the outside.
        let lacking = 2.0 * 2f64.powf(2.0 * nu) / nu * weights[1];
        // Near order 1 the exact form with β takes too many passes.
        let beta = if order.complement() > 0.02 { (weights[0] - lacking).max(0.0) } else { 0.0 };
        let comparison = [beta, symbol];
        let goal = (1e-2 * tolerance.relative()).max(f64::EPSILON);
        let (exact, exact_error) = exact_form(rest, order, comparison, goal)?;
        let rough = Rough { u: self, unit, mean, order, weights, comparison, exact };
        let mut first = match self.partition().uniform_length() {
            Some(_) => self.partition().len(),
            None => (2 * self.partition().len()).next_power_of_two(),
        };
        // Above order 1/2 meshes coarser than that of f will often do.
        let coarser = if nu >= 0.5 { 64 } else { 4 };
        let least = (first / coarser).max(FIRST);
        while first > least && first.is_multiple_of(2) {
            first /= 2;
        }
        while first < FIRST {
            first *= 2;
        }
        while first > MOST {
            first = first.div_ceil(2);
        }
        let (mut levels, mut best, mut work): (Vec<Level>, Option<Estimate>, Work) =
            (Vec::new(), None, Work::default());
        let mut count = first;
        while count <= MOST {
            let level = rough.level(count, goal)?;
            work += Work { points: count as u64, iterations: level.steps, ..Work::default() };
            levels.push(level);
            if let Some((value, error)) = rough.limit(&levels) {
                let found = finish(factor * value, factor * (error + exact_error), work)?;
                if found.relative_error() <= tolerance.relative() {
                    return Ok(found);
                }
                if best.is_none_or(|best| found.error < best.error) {
                    best = Some(found);
                } else if best.is_some_and(|best| found.error > 4.0 * best.error) {
                    break;
                }
                // Large meshes are for those that may reach it.
                let gain = rough.rate().powf((MOST as f64 / count as f64).log2() + SPARE);
                if count >= LARGE && found.relative_error() > gain * tolerance.relative() {
                    break;
                }
            }
            count *= 2;
        }
        let why = "a million elements do not suffice for its jumps, or rounding of the form";
        Err(Error::best_of("dual norm", tolerance.relative(), best, why))
    }
}
