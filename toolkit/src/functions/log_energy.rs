//! |u|²_ν of a function with breakpoints, in logarithmic coordinates along its sides.
//!
//! Of two points the deeper one (larger t) is the outer variable:
//! |u|²_ν = 2 Σ_a ∫₀^∞ ℓ_a(t) dt,  ℓ_a(t) = δ Σ_b ∫₀^t ε (u(x)−u(y))² |x−y|^{-1-2ν} dt′,
//! x = c_a ± δ(t), y = c_b ± ε(t′).
//!
//! On the side of x itself the integrand is singular like s^{1-2ν} as s = t − t′ → 0 and is integrated by
//! [`Rule::power_weight`] with the difference quotient; all other pairs are smooth functions of (t, t′). Each ℓ_a
//! is smooth for t > 0, and its decay depends on u at the breakpoint ([`super::arm_integral`]). Distances have
//! full relative accuracy: δ(e^s − 1) on one side, δ + ε across a breakpoint, R(1−e^{-t}) + R(1−e^{-t′}) across
//! a midpoint.

use super::arm::Arm;
use super::arm_integral::ArmIntegral;
use super::deep_tail::DeepTail;
use super::function::SingularFunction;
use super::level::{Density, Level, LevelValue};
use super::octaves::Slope;
use super::resolution::missed;
use crate::error::Result;
use crate::kernel::power::PowerKernel;
use crate::order::Order;
use crate::quadrature::Rule;

/// Depth of a point at which other breakpoints are effectively infinitely far in t.
const NEAR_DEPTH: f64 = 3.0;
/// Two rules agree if they differ by at most this multiple of their rounding error.
const NOISE: f64 = 4.0;

/// Values of u on one cell of one side.
struct CellSamples {
    t: Vec<f64>,
    /// w h ε
    weight: Vec<f64>,
    epsilon: Vec<f64>,
    value: Vec<f64>,
}

/// The double integral at one level of accuracy.
pub(crate) struct LogEnergy<'a> {
    function: &'a SingularFunction<'a>,
    arms: Vec<Arm>,
    samples: Vec<Vec<CellSamples>>,
    kernel: PowerKernel,
    rule: Rule,
    near: Rule,
    /// rule away from the other breakpoints, whose distance is e^t δ: with fewer points, not so close to s = 0,
    /// fewer digits are lost
    near_deep: Rule,
    level: Level,
    /// S, the unit of all lengths: the length of the longest side
    unit: f64,
    points: u64,
}

/// The outer point.
#[derive(Clone, Copy)]
struct Outer {
    arm: usize,
    t: f64,
    delta: f64,
    value: f64,
}

impl<'a> LogEnergy<'a> {
    pub(crate) fn new(
        function: &'a SingularFunction<'a>,
        order: Order,
        level: Level,
    ) -> Result<Self> {
        let arms = function.arms();
        let kernel = PowerKernel::new(order);
        Ok(Self {
            function,
            samples: arms.iter().map(|_| Vec::new()).collect(),
            unit: arms.iter().map(|arm| arm.length).fold(0.0, f64::max),
            arms,
            kernel,
            rule: Rule::gauss_legendre(level.points)?,
            near: Rule::power_weight(level.points + 6, kernel.two_minus)?,
            near_deep: Rule::power_weight(level.points / 2 + 3, kernel.two_minus)?,
            level,
            points: 0,
        })
    }

    /// The squared seminorm to a relative accuracy of about `tolerance`, as far as this level permits.
    pub(crate) fn compute(mut self, tolerance: f64) -> Result<LevelValue> {
        let shortest = self.arms.iter().map(|arm| arm.length).fold(f64::INFINITY, f64::min);
        let spread = (self.unit / shortest).ln();
        let order = 0.5 * self.kernel.twice;
        let integral =
            ArmIntegral::new(self.level, tolerance, spread, order, self.kernel.one_minus)?;
        let (mut value, mut tail, mut rounding) = (0.0, 0.0, 0.0);
        let factor = 2.0 * self.kernel.scaling(self.unit);
        let mut sides = Vec::with_capacity(self.arms.len());
        for arm in 0..self.arms.len() {
            let depth = self.arms[arm].depth;
            let end = self.tail(arm)?;
            let found =
                integral.integrate(depth, value, end.as_ref(), &[], |t| self.density(arm, t))?;
            value += found.limit.value;
            tail += found.limit.error;
            rounding = found.rounding.hypot(rounding);
            sides.push(factor * found.limit.value);
        }
        let (missed, points) = missed(self.function, self.level, self.kernel)?;
        Ok(LevelValue {
            value: factor * value,
            sides,
            tail: factor * tail,
            rounding: factor * rounding,
            missed,
            of_rules: None,
            points: self.points + points,
        })
    }

    /// The tail of a side below 1e-300, for functions that can be evaluated there.
    fn tail(&self, arm: usize) -> Result<Option<DeepTail<'a>>> {
        if !self.function.is_known_at_any_depth() {
            return Ok(None);
        }
        let anchor = self.arms[arm].anchor;
        let other = (0..self.arms.len()).find(|&b| b != arm && self.arms[b].anchor == anchor);
        let other = other.map(|other| self.arms[other]);
        DeepTail::new(self.function, self.arms[arm], other, self.kernel, self.level, self.unit)
            .map(Some)
    }

    /// ℓ_a(t) in units of S.
    fn density(&mut self, arm: usize, t: f64) -> Result<Density> {
        let delta = self.arms[arm].delta(t);
        let x = Outer { arm, t, delta, value: self.function.along(&self.arms[arm], t, delta)? };
        let h = self.level.width;
        let (mut sum, before) = (Density::default(), self.points);
        for other in 0..self.arms.len() {
            // Full cells; on the own arm they stop between h/2 and 3h/2 from t.
            let reach = if other == arm { (t / h - 0.5).floor() } else { (t / h).floor() };
            let available = (self.arms[other].depth / h).floor().max(1.0);
            let cells = reach.max(0.0).min(available) as usize;
            self.prepare(other, cells)?;
            sum = sum + self.full_cells(x, other, cells);
            let from = cells as f64 * h;
            sum = sum
                + if other == arm {
                    self.near_piece(x, t - from)?
                } else if reach > available {
                    self.blurred_rest(x, other)?
                } else {
                    self.partial_cell(x, other, from)?
                };
        }
        self.function.spend(self.points - before)?;
        Ok(sum)
    }

    /// Samples of the first `cells` cells of a side.
    fn prepare(&mut self, arm: usize, cells: usize) -> Result<()> {
        let h = self.level.width;
        while self.samples[arm].len() < cells {
            let from = self.samples[arm].len() as f64 * h;
            let cell = self.sample(arm, from, h)?;
            self.samples[arm].push(cell);
        }
        Ok(())
    }

    fn sample(&self, arm: usize, from: f64, width: f64) -> Result<CellSamples> {
        let geometry = &self.arms[arm];
        let t: Vec<f64> = self.rule.points().iter().map(|p| from + width * p).collect();
        let epsilon: Vec<f64> = t.iter().map(|&t| geometry.delta(t)).collect();
        let value = t
            .iter()
            .zip(&epsilon)
            .map(|(&t, &e)| self.function.along(geometry, t, e))
            .collect::<Result<_>>()?;
        let weight = epsilon.iter().zip(self.rule.weights()).map(|(e, w)| w * width * e).collect();
        Ok(CellSamples { t, weight, epsilon, value })
    }

    fn full_cells(&mut self, x: Outer, other: usize, cells: usize) -> Density {
        self.points += (cells * self.level.points) as u64;
        self.samples[other][..cells]
            .iter()
            .fold(Density::default(), |sum, cell| sum + self.against(x, other, cell))
    }

    fn partial_cell(&mut self, x: Outer, other: usize, from: f64) -> Result<Density> {
        if x.t <= from {
            return Ok(Density::default());
        }
        let cell = self.sample(other, from, x.t - from)?;
        self.points += self.level.points as u64;
        Ok(self.against(x, other, &cell))
    }

    /// The remainder of a side whose function cannot be evaluated closer to its breakpoint; the function is
    /// continued by a constant.
    fn blurred_rest(&mut self, x: Outer, other: usize) -> Result<Density> {
        let arm = &self.arms[other];
        let from = (arm.depth / self.level.width).floor().max(1.0) * self.level.width;
        let end = arm.delta(from);
        let cell = CellSamples {
            t: vec![from],
            weight: vec![end],
            epsilon: vec![0.5 * end],
            value: vec![self.function.at(arm, end)?],
        };
        Ok(self.against(x, other, &cell))
    }

    /// Σ weight (u(x)−u(y))² δ |x−y|^{-1-2ν} over a cell.
    fn against(&self, x: Outer, other: usize, cell: &CellSamples) -> Density {
        let (mut sum, mut rounding) = (0.0, 0.0);
        let (mut last_distance, mut last_power) = (f64::NAN, 0.0);
        for i in 0..cell.t.len() {
            let distance = self.distance(x, other, cell.t[i], cell.epsilon[i]);
            if distance != last_distance {
                // δ |x−y|^{-2ν} in units of S, without overflow
                last_power = (x.delta / distance).powf(self.kernel.twice);
                last_distance = distance;
            }
            let difference = x.value - cell.value[i];
            let weight = cell.weight[i] / distance * last_power;
            sum += weight * difference * difference;
            rounding += weight * difference.abs() * (x.value.abs() + cell.value[i].abs());
        }
        let scale = self.kernel.scaling(x.delta / self.unit);
        // Independent roundings add as squares do: the sum of n like terms, divided by √n.
        Density {
            value: sum * scale,
            rounding: rounding / (cell.t.len() as f64).sqrt() * scale * f64::EPSILON,
        }
    }

    fn distance(&self, x: Outer, other: usize, t: f64, epsilon: f64) -> f64 {
        let (a, b) = (&self.arms[x.arm], &self.arms[other]);
        if x.arm == other {
            // Full cells of the own arm end h/2 before x.
            epsilon - x.delta
        } else if a.anchor == b.anchor {
            x.delta + epsilon
        } else if x.arm / 2 == other / 2 {
            a.length * -((-x.t).exp_m1() + (-t).exp_m1())
        } else {
            // Arms of one break or one interval are treated above; between others lies at least half an
            // interval.
            let (left, left_delta, right, right_delta) = if a.anchor < b.anchor {
                (a, x.delta, b, epsilon)
            } else {
                (b, epsilon, a, x.delta)
            };
            self.between(left.anchor, right.anchor) - left.sign * left_delta
                + right.sign * right_delta
        }
    }

    /// Sum of the interval lengths between two breakpoints.
    fn between(&self, left: usize, right: usize) -> f64 {
        (left..right).map(|k| 2.0 * self.arms[2 * k].length).sum()
    }

    /// The contribution of the side of x itself, at t − s with 0 < s < `reach`.
    fn near_piece(&mut self, x: Outer, reach: f64) -> Result<Density> {
        let fine = self.near_by(x, reach, &self.near)?;
        self.points += (self.level.points + 6) as u64;
        if x.t - reach <= NEAR_DEPTH {
            return Ok(fine);
        }
        // Fewer digits are lost by the other rule, which is too coarse where u varies on the scale of t.
        let coarse = self.near_by(x, reach, &self.near_deep)?;
        self.points += (self.level.points / 2 + 3) as u64;
        let is_resolved = (fine.value - coarse.value).abs() <= NOISE * fine.rounding;
        Ok(if is_resolved { coarse } else { fine })
    }

    /// The same by the given rule.
    fn near_by(&self, x: Outer, reach: f64, rule: &Rule) -> Result<Density> {
        let arm = self.arms[x.arm];
        let spot = self.function.spot_at(x.t);
        let (mut sum, mut of_values, mut of_slopes, mut of_places) = (0.0, 0.0_f64, 0.0, 0.0);
        for (node, w) in rule.iter() {
            let s = reach * node;
            // From δ itself, so that δ and ε keep their quotient e^s however deep they lie.
            let y = x.delta * s.exp();
            // The difference of two values has their rounding errors over s, the slope of a polynomial has not.
            // Rounding of x moves values by more than that, and of these a polynomial has the steepest slopes.
            let slope =
                spot.filter(|_| arm.blur == 0.0).and_then(|at| self.function.slope_at(&arm, at, s));
            let quotient = match slope {
                Some(found) => found.value,
                None => (x.value - self.function.farther(&arm, spot, s, y)?) / s,
            };
            let stretch = s.exp_m1() / s;
            // δ ε (u−v)² (δ (e^s−1))^{-1-2ν} = δ^{1-2ν} s^{1-2ν} e^s q² ((e^s−1)/s)^{-1-2ν}
            let weight = w * s.exp() / stretch * stretch.powf(-self.kernel.twice);
            sum += weight * quotient * quotient;
            let blur = arm.blur * quotient.abs() / x.delta;
            // Independent roundings add as squares do; slopes of one polynomial are off to the same side.
            let noise = weight * quotient.abs();
            match slope {
                Some(Slope { steep, .. }) => {
                    of_slopes += noise * steep * 2.0 * f64::EPSILON * x.value.abs();
                }
                None => {
                    let size = f64::EPSILON * (2.0 * x.value - s * quotient).abs();
                    of_values = of_values.hypot(noise * size / s);
                    of_places += noise * blur / s;
                }
            }
        }
        // ∫₀^reach s^{1-2ν} f ds = reach^{2-2ν} Σ w f
        let scale = reach.powf(self.kernel.two_minus) * self.kernel.scaling(x.delta / self.unit);
        // That of x also differs from one outer point to the next, each with its own nearest pair: the root mean square.
        let of_places = of_places / (self.level.points as f64).sqrt();
        Ok(Density { value: sum * scale, rounding: (of_values + of_slopes + of_places) * scale })
    }
}
