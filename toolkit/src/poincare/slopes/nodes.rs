//! Gauss rules on the panels, with the terms of the kernel that depend on only one point.
//!
//! The number of points follows from the required digits, from the degree of the slopes on the panel (a
//! polynomial on a long cell has a low degree on each of its panels) and from the nearest singularity of the
//! kernel: an n-point rule is exact up to degree 2n − 1, and the Chebyshev coefficients of the kernel decrease
//! like ϱ^{−k}, ϱ the parameter of the Bernstein ellipse through the singularity, and at most as fast as
//! those of eˣ because the panels are exponential.

use super::kernel::power_increment;
use super::local::Local;
use super::rules::Pairs;
use super::space::{MOST_FUNCTIONS, SlopeSpace, Values, legendre};
use crate::error::Result;
use crate::quadrature::Rule;
use std::f64::consts::LN_10;
use std::sync::OnceLock;

/// Available numbers of points.
const SIZES: [usize; 14] = [3, 4, 5, 6, 7, 8, 10, 12, 14, 16, 18, 21, 24, 27];

/// One point of a panel.
pub(crate) struct Node {
    /// Distances from the ends of the panel.
    pub(crate) from_left: f64,
    pub(crate) from_right: f64,
    /// Distances x and y from the ends of the interval, and their p-th powers.
    pub(crate) x: f64,
    pub(crate) y: f64,
    pub(crate) x_power: f64,
    pub(crate) y_power: f64,
    /// (ℓ^p − x^p)/p and (ℓ^p − y^p)/p, ℓ = x + y.
    pub(crate) beyond_x: f64,
    pub(crate) beyond_y: f64,
    /// Signed distance from the point P of the local group, the power of its modulus, and the terms of the
    /// shifted kernel that depend on one point.
    pub(crate) position: f64,
    pub(crate) position_power: f64,
    pub(crate) nearer: f64,
    pub(crate) further: f64,
    /// The values of the basis of the cell times the weight.
    pub(crate) weighted: Values,
}

/// Rules of all sizes on all panels, computed at their first use.
pub(crate) struct Nodes {
    rules: Vec<Pairs>,
    panels: Vec<Vec<OnceLock<Vec<Node>>>>,
    /// For each panel, the degree of the slopes and the distance of the nearest end of the interval in units of
    /// the panel.
    degrees: Vec<usize>,
    isolation: Vec<f64>,
}

impl Nodes {
    /// The rules with up to `most` points; slopes are resolved to `digits` digits.
    pub(crate) fn new(space: &SlopeSpace, most: usize, digits: f64) -> Result<Self> {
        let sizes = SIZES.iter().copied().filter(|&n| n < most).chain([most]);
        let rules = sizes
            .map(|n| Ok(Rule::gauss_legendre(n)?.iter().collect()))
            .collect::<Result<Vec<Pairs>>>()?;
        let count = space.panels.len();
        let panels = (0..count).map(|_| rules.iter().map(|_| OnceLock::new()).collect()).collect();
        let degrees = (0..count)
            .map(|i| degree_on_panel(space, i, &rules[rules.len() - 1], digits))
            .collect();
        let isolation = (0..count)
            .map(|i| {
                let panel = &space.panels[i];
                let left = panel.outside(space.panel_left[i], true);
                left.min(panel.outside(space.panel_right[i], false))
            })
            .collect();
        Ok(Self { rules, panels, degrees, isolation })
    }

    /// The index of the rule for `digits` digits over panel i, whose distance from the nearest singular point
    /// is `outside` times its length.
    pub(crate) fn choose(&self, i: usize, outside: f64, digits: f64) -> usize {
        let beside = 1.0 + 2.0 * outside.min(self.isolation[i]);
        let ellipse = beside + (beside * beside - 1.0).sqrt();
        let degree = (digits * LN_10 / ellipse.ln()).max(exponential_degree(digits));
        let points = 0.5 * (self.degrees[i] as f64 + degree) + 1.0;
        self.rules
            .iter()
            .position(|rule| rule.len() as f64 >= points)
            .unwrap_or(self.rules.len() - 1)
    }

    /// The points of panel i.
    pub(crate) fn get(
        &self,
        space: &SlopeSpace,
        local: Option<&Local>,
        p: f64,
        (i, rule): (usize, usize),
    ) -> &[Node] {
        self.panels[i][rule].get_or_init(|| {
            let node = |&(xi, w): &(f64, f64)| node(space, local, p, i, (xi, w));
            self.rules[rule].iter().map(node).collect()
        })
    }
}

fn node(space: &SlopeSpace, local: Option<&Local>, p: f64, i: usize, (xi, w): (f64, f64)) -> Node {
    let panel = &space.panels[i];
    let (from_left, from_right) = (panel.left_distance(xi), panel.right_distance(1.0 - xi));
    let (x, y) = (space.panel_left[i] + from_left, space.panel_right[i] + from_right);
    let position = local.map_or(0.0, |local| local.position(space, i, xi));
    let mut weighted = space.slopes(i, xi);
    weighted.iter_mut().for_each(|value| *value *= w * panel.width);
    Node {
        from_left,
        from_right,
        x,
        y,
        x_power: x.powf(p),
        y_power: y.powf(p),
        beyond_x: power_increment(p, x, y),
        beyond_y: power_increment(p, y, x),
        position,
        position_power: position.abs().powf(p),
        nearer: local.map_or(0.0, |local| local.of_nearer(position)),
        further: local.map_or(0.0, |local| local.of_further(position)),
        weighted,
    }
}

/// The degree that approximates eˣ on (−1, 1) to the given number of digits: its Chebyshev coefficients are
/// about 2^{1−k}/k!.
fn exponential_degree(digits: f64) -> f64 {
    let (mut degree, mut logarithm) = (0.0, 0.0);
    while logarithm < digits && degree < 30.0 {
        degree += 1.0;
        logarithm += (2.0f64 * degree).log10();
    }
    degree
}

/// The degree of the slopes of a cell on one of its panels, up to which their Legendre coefficients exceed
/// 10^−`digits`.
fn degree_on_panel(space: &SlopeSpace, i: usize, rule: &Pairs, digits: f64) -> usize {
    let functions = space.functions(i);
    let mut coefficients = [[0.0; MOST_FUNCTIONS + 1]; MOST_FUNCTIONS];
    for &(xi, w) in rule {
        let (here, cell) = (legendre(functions, xi), space.slopes(i, xi));
        for (row, value) in coefficients.iter_mut().zip(cell).take(functions) {
            row.iter_mut().zip(here).for_each(|(c, basis)| *c += w * value * basis);
        }
    }
    let least = 10f64.powf(-digits);
    let matters = |m: &usize| coefficients.iter().any(|row| row[*m].abs() > least);
    (0..functions).rev().find(matters).unwrap_or(0)
}
