//! Integrals over one element by Gauss panels that grow away from a singular point; 12 points on each leave
//! 1e-16.
//!
//! ‖v − v̄‖² and ‖∫(v − v̄)‖² are formed from the difference v(x) − v(x₀), x₀ an end of the element: nothing
//! cancels on elements far shorter than their distance from the singular point.

use fractional_sobolev::Result;
use fractional_sobolev::{Rule, gauss_legendre};

/// Gauss points per panel: a function analytic up to one panel length away is integrated to 6^{-24}.
const POINTS: usize = 12;

/// ‖u − I u‖² and ‖(u − I u)'‖² on one element.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Squares {
    pub(super) error: f64,
    pub(super) slope: f64,
    pub(super) points: u64,
}

/// Panels that fill (0, h), each as long as allowed where it starts.
pub(super) fn panels(h: f64, longest: impl Fn(f64) -> f64) -> Vec<f64> {
    let mut panels = Vec::new();
    let mut done = 0.0;
    while done < h {
        let rest = h - done;
        let length = if rest <= 1.5 * longest(done) { rest } else { longest(done) };
        panels.push(length);
        done += length;
    }
    panels
}

/// Gauss rules for panels as long as their distance from a singular point, and for much shorter ones.
#[derive(Debug, Clone)]
pub(in crate::interpolation) struct PanelRules {
    pub(super) long: Rule,
    short: Rule,
}

impl PanelRules {
    pub(in crate::interpolation) fn new() -> Result<Self> {
        Ok(Self { long: gauss_legendre(POINTS)?, short: gauss_legendre(POINTS / 2)? })
    }

    /// At an eighth of the distance the radius of analyticity is 34 half lengths: half the points do.
    pub(super) fn choose(&self, h: f64, distance: f64) -> &Rule {
        if 8.0 * h <= distance { &self.short } else { &self.long }
    }
}

/// The squares from v(left + d) − v(x₀) as a function of d, x₀ fixed.
pub(super) fn panel_squares(panels: &[f64], difference: impl Fn(f64) -> f64, rule: &Rule) -> Squares {
    let h: f64 = panels.iter().sum();
    let over = |start: f64, length: f64, shift: f64| {
        length * rule.integrate(|t| difference(start + length * t) - shift)
    };
    let (mut start, mut integral) = (0.0, 0.0);
    for &length in panels {
        integral += over(start, length, 0.0);
        start += length;
    }
    let mean = integral / h;
    let mut squares = Squares::default();
    let (mut start, mut error) = (0.0, 0.0);
    for &length in panels {
        for (t, w) in rule.iter() {
            let deviation = difference(start + length * t) - mean;
            squares.slope += length * w * deviation * deviation;
            squares.error += length * w * (error + over(start, length * t, mean)).powi(2);
        }
        squares.points += (rule.points().len() * rule.points().len()) as u64;
        error += over(start, length, mean);
        start += length;
    }
    squares
}
