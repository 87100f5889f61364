//! |v|²_ν of a trace on a contact segment, by fast products with the Gram matrix of a uniform mesh; one
//! [`SeminormForm`] serves all segments of a mesh, because |v|²_{ν,T} = h_e^{1−2ν} |ṽ|²_ν on the reference
//! interval. Cost O(K log K) for K cells. The tests below compare it with adaptive quadrature.

use super::pair::{Segment, Traces};
use crate::error::{Error, Result, ToolkitError};
use fractional_sobolev::{Estimate, Gram, Mesh, Order, Tolerance, Work};

/// Relative rounding error of the fast product, with respect to Σ a_ii x_i².
const PRODUCT: f64 = 1e-13;

/// |·|²_ν on segments of K equal cells.
#[derive(Debug)]
pub(super) struct SeminormForm {
    order: Order,
    traces: Traces,
    cells: usize,
    /// The operator on (0, 1); `None` for a single constant.
    operator: Option<Gram>,
}

impl SeminormForm {
    /// The form for segments of `cells` cells.
    ///
    /// # Errors
    /// [`ToolkitError::InfiniteNorm`](crate::ToolkitError::InfiniteNorm) for piecewise constants and ν ≥ 1/2;
    /// [`ToolkitError::CountOutOfRange`](crate::ToolkitError::CountOutOfRange) without cells.
    pub(super) fn new(traces: Traces, order: Order, cells: usize) -> Result<Self> {
        if traces == Traces::Constants && order.offset() >= 0.0 {
            return Err(Error::Toolkit(ToolkitError::InfiniteNorm {
                order: order.value(),
                why: "a function with a jump is not in H^nu for nu >= 1/2",
            }));
        }
        let partition = Mesh::uniform(cells, 1.0)?;
        let operator = match traces {
            Traces::Constants if cells == 1 => None,
            Traces::Constants => Some(Gram::constants(&partition, order, Tolerance::reference())?),
            Traces::Linears => Some(Gram::new(&partition, order, Tolerance::reference())?),
        };
        Ok(Self { order, traces, cells, operator })
    }

    /// |v|²_{ν,T} of the trace with values `ends` at the ends of the cells of the segment.
    ///
    /// # Errors
    /// [`ToolkitError::LengthMismatch`](crate::ToolkitError::LengthMismatch) for a segment of another number of cells.
    pub(super) fn squared(&self, segment: &Segment<'_>, ends: &[[f64; 2]]) -> Result<Estimate> {
        if ends.len() != self.cells || segment.traces != self.traces {
            return Err(Error::Toolkit(ToolkitError::LengthMismatch {
                name: "cells of the segment",
                given: ends.len(),
                expected: self.cells,
            }));
        }
        let x = segment.coefficients(ends);
        let is_constant = x.iter().all(|&v| v == x[0]);
        let Some(operator) = self.operator.as_ref().filter(|_| !is_constant) else {
            return Ok(Estimate::new(0.0, 0.0, Work::default())?);
        };
        let mean = x.iter().sum::<f64>() / x.len() as f64;
        let product = operator.apply(&x)?;
        // The form vanishes on constants: subtracting the mean is exact and reduces rounding errors.
        let form: f64 = product.iter().zip(&x).map(|(y, v)| y * (v - mean)).sum();
        let size: f64 = operator.diagonal()?.iter().zip(&x).map(|(a, v)| a * (v - mean).powi(2)).sum();
        let scale = segment.length().powf(-2.0 * self.order.offset());
        Ok(Estimate::new(scale * form.max(0.0), scale * PRODUCT * size, Work::default())?)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::edge::ContactPair;
    use crate::problems::StripData;
    use crate::strip::LateralCondition;
    use fractional_sobolev::{Rule, gauss_legendre};

    /// The tolerance of the quadrature, with a factor for the cancellation in nearly constant traces.
    const METHODS: f64 = 1e-8;

    /// A trace of a segment.
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    enum SegmentTrace {
        /// −σ_N.
        Stress,
        /// u_N'.
        Slope,
    }

    /// Deepest bisection of a piece.
    const DEPTH: usize = 14;

    /// |v|²_ν = 2 ∫₀^h t^{−1−2ν} D(t) dt, D(t) = ∫₀^{h−t} (v(x+t) − v(x))² dx, by adaptive quadrature.
    ///
    /// D by evaluating v at points, the outer integral by bisection with two Gauss rules. D(t) = O(t) for jumps
    /// and O(t²) for continuous traces, so the first cell is taken in the variable s = t^{1−2ν} or t^{2−2ν}. Cost
    /// O(K²).
    fn seminorm_by_quadrature(
        segment: &Segment<'_>,
        which: SegmentTrace,
        order: Order,
        tolerance: Tolerance,
    ) -> Result<Estimate> {
        let ends = if which == SegmentTrace::Stress { segment.pressures } else { segment.slopes };
        // Constants have seminorm zero: without the first value nearly constant traces keep their digits.
        let ends: Vec<[f64; 2]> = ends.iter().map(|e| e.map(|v| v - ends[0][0])).collect();
        let inner = gauss_legendre(3)?;
        let (rule, finer) = (gauss_legendre(8)?, gauss_legendre(13)?);
        let cells = ends.len();
        // D(t) for t in units of a cell: between breaks of v and of v(· + t) the integrand is a polynomial.
        let difference = |t: f64| {
            let (whole, part) = (t.floor() as usize, t - t.floor());
            let mut sum = 0.0;
            let at = |e: [f64; 2], z: f64| e[0] + z * (e[1] - e[0]);
            for i in 0..cells.saturating_sub(whole) {
                // x + t lies in the cell `whole` further on, then in the next one; short lengths are not
                // differences.
                let (here, there, rest) = (ends[i], ends[i + whole], 1.0 - part);
                sum += rest
                    * inner.integrate(|s| {
                        let own = whole == 0;
                        let d = if own {
                            part * (here[1] - here[0])
                        } else {
                            at(there, part + s * rest) - at(here, s * rest)
                        };
                        d * d
                    });
                if let Some(&next) = ends.get(i + whole + 1) {
                    sum += part
                        * inner
                            .integrate(|s| (at(next, s * part) - at(here, 1.0 - (1.0 - s) * part)).powi(2));
                }
            }
            sum
        };
        let nu = order.value();
        let power = if segment.traces == Traces::Constants {
            -2.0 * order.offset()
        } else {
            2.0 * (1.0 - order.value())
        };
        // s = t^power: t^{−1−2ν} dt = t^{−2ν−power}/power ds
        let start = |s: f64| {
            let t = s.powf(1.0 / power);
            if t == 0.0 { 0.0 } else { difference(t) * t.powf(-2.0 * nu - power) / power }
        };
        let beyond = |t: f64| difference(t) * t.powf(-1.0 - 2.0 * nu);
        let mut adaptive = Adaptive { rule: &rule, finer: &finer, error: 0.0, points: 0 };
        let rough = adaptive.measure(&start, 0.0, 1.0).1.abs();
        let mut total = adaptive.integral(&start, 0.0, 1.0, tolerance.relative() * rough, DEPTH);
        for k in 1..cells {
            total +=
                adaptive.integral(&beyond, k as f64, k as f64 + 1.0, tolerance.relative() * rough, DEPTH);
        }
        let scale = 2.0 * segment.cell.powf(-2.0 * order.offset());
        let work = Work { points: adaptive.points, ..Work::default() };
        let estimate = Estimate::new(scale * total, scale * adaptive.error, work)?;
        // A constant trace has seminorm 0 and no relative error.
        if total > 0.0 && estimate.relative_error() > 10.0 * tolerance.relative() {
            let why = "the maximum number of bisections was reached";
            return Err(Error::not_met("squared seminorm", tolerance.relative(), estimate, why));
        }
        Ok(estimate)
    }

    /// Bisection with two Gauss rules.
    struct Adaptive<'a> {
        rule: &'a Rule,
        finer: &'a Rule,
        error: f64,
        points: u64,
    }

    impl Adaptive<'_> {
        fn measure(&mut self, f: &impl Fn(f64) -> f64, a: f64, b: f64) -> (f64, f64) {
            self.points += (self.rule.points().len() + self.finer.points().len()) as u64;
            let on = |rule: &Rule| (b - a) * rule.integrate(|t| f(a + t * (b - a)));
            (on(self.rule), on(self.finer))
        }

        fn integral(&mut self, f: &impl Fn(f64) -> f64, a: f64, b: f64, allowed: f64, depth: usize) -> f64 {
            let (coarse, fine) = self.measure(f, a, b);
            let error = (fine - coarse).abs();
            if error <= allowed.max(64.0 * f64::EPSILON * fine.abs()) || depth == 0 {
                // The finer rule is far better than their difference.
                self.error += 0.1 * error;
                return fine;
            }
            let middle = 0.5 * (a + b);
            self.integral(f, a, middle, allowed, depth - 1) + self.integral(f, middle, b, allowed, depth - 1)
        }
    }

    #[test]
    fn seminorms_on_a_segment_agree_with_quadrature() {
        let mut worst = 0.0f64;
        let mut compared = 0;
        for (tau, nus) in [(1.6, [0.05, 0.1, 0.25]), (1.75, [0.25, 0.35, 0.45]), (2.0, [0.5, 0.6, 0.75])] {
            for nu in nus {
                let order = Order::new(nu).unwrap();
                let traces = if nu < 0.5 { Traces::Constants } else { Traces::Linears };
                for source in ["transition", "transitions:9", "cantor:0.3"] {
                    let edge_data = source
                        .parse::<StripData>()
                        .unwrap()
                        .data(tau, 512, LateralCondition::Natural)
                        .unwrap();
                    let pair = ContactPair::of_data(&edge_data, traces).unwrap();
                    for n in [16, 32] {
                        let all = pair.norms(n, order, 2.0).unwrap();
                        for (segment, norms) in pair.segments(n).unwrap().zip(all) {
                            for (which, closed) in [
                                (SegmentTrace::Stress, norms.stress.seminorm_squared),
                                (SegmentTrace::Slope, norms.slope.seminorm_squared),
                            ] {
                                let asked = Tolerance::new(1e-10).unwrap();
                                let adaptive = seminorm_by_quadrature(&segment, which, order, asked).unwrap();
                                let difference = (adaptive.value - closed.value).abs();
                                // Below: nearly constant traces, whose seminorm is known absolutely.
                                let scale =
                                    closed.value.max(1e-6 * (norms.slope.l2 + norms.stress.l2).powi(2));
                                if scale > 0.0 {
                                    worst = worst.max(difference / scale);
                                    compared += 1;
                                    assert!(
                                        difference <= METHODS * scale,
                                        "{source} nu {nu} n {n} {which:?}: {} and {}",
                                        closed.value,
                                        adaptive.value
                                    );
                                }
                            }
                        }
                    }
                }
            }
        }
        println!("{compared} seminorms, worst relative difference {worst:.1e}");
        assert!(compared > 1000);
    }
}
