//! A cell at a breakpoint, represented by points graded towards it: sufficient for kernels that are smooth
//! there.
//!
//! Gauss rules are used on layers of ratio 2/5. The layers end where ∫ e² over the remainder, e = u − u_h, is
//! small relative to the tolerance, or where the function cannot be evaluated any closer to the breakpoint.

use crate::error::Result;
use crate::quadrature::Rule;

/// Ratio of successive layers.
const RATIO: f64 = 0.4;
/// Smallest depth of the layers.
const LEAST: f64 = 1e-3;
/// Number of points of a layer: x^a is integrated to rounding.
const POINTS: usize = 12;

/// Points t and weights of the unit cell, and the values there.
pub(super) struct Sampled {
    pub(super) points: Vec<(f64, f64)>,
    pub(super) values: Vec<f64>,
    /// errors of ∫ e² and of ∫ e times the size of e: those of the last layer, on which a single rule is used
    pub(super) rest: f64,
}

impl Sampled {
    /// The samples of e at distances δ from the breakpoint, down to `closest`, in units of the cell;
    /// `mirrored` if the breakpoint is its right end.
    pub(super) fn new(
        closest: f64,
        mirrored: bool,
        tolerance: f64,
        e: impl Fn(f64) -> Result<f64>,
    ) -> Result<Self> {
        let rule = Rule::gauss_legendre(POINTS)?;
        let mut found = Self { points: Vec::new(), values: Vec::new(), rest: 0.0 };
        let place = |delta: f64| if mirrored { 1.0 - delta } else { delta };
        // Before the first layer nothing is known of how they shrink.
        let (mut end, mut sum, mut before) = (1.0, 0.0, 0.0);
        loop {
            let start = RATIO * end;
            let (mut layer, mut low, mut high) = (0.0, f64::INFINITY, f64::NEG_INFINITY);
            for (t, w) in rule.iter() {
                let value = found.add(place, start, end - start, (t, w), &e)?;
                layer += w * (end - start) * value * value;
                (low, high) = (low.min(value), high.max(value));
            }
            sum += layer;
            end = start;
            let ratio = layer / before;
            let squares = layer * ratio / (1.0 - ratio);
            before = layer;
            // ∫ e of what is left enters beside values like those of the cell.
            found.rest = squares + end * (high - low) * sum.sqrt();
            let settled = ratio < 1.0 && found.rest <= 1e-3 * tolerance * sum;
            if end < LEAST && (settled || high == low) {
                break;
            }
            if end <= closest {
                found.rest = end * high.abs().max(low.abs()).powi(2);
                break;
            }
        }
        for pair in rule.iter() {
            found.add(place, 0.0, end, pair, &e)?;
        }
        if found.rest.is_nan() {
            found.rest = 0.0;
        }
        Ok(found)
    }

    /// Adds a point of the rule on (start, start + width) and returns its value.
    fn add(
        &mut self,
        place: impl Fn(f64) -> f64,
        start: f64,
        width: f64,
        (t, w): (f64, f64),
        e: &impl Fn(f64) -> Result<f64>,
    ) -> Result<f64> {
        let delta = start + width * t;
        let value = e(delta)?;
        self.points.push((place(delta), w * width));
        self.values.push(value);
        Ok(value)
    }
}
