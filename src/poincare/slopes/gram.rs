//! The Gram matrix of the squared seminorm |u|_ν² in the slope basis.
//!
//! A = ∬ L_k(s) L_l(t) K(s,t), K of [`super::kernel`]. Pairs of panels fall into three classes. *Separated*: tensor Gauss rule;
//! pairs whose kernel is below 1e-22 of the geometric mean of their self energies are skipped. *Touching* and *same*: the kernel is
//!
//! ν K = h^p [ ((x/h)^p − 1)/p + (1 − (d/h)^p)/p ] − ((y+e)^p − y^p)/p,
//!
//! d = |s−t|, x the distance of the further point from the near end of the interval, e and y the distances of the nearer
//! point from the near and the far end, h the size of the pair. Only d carries a singularity; on the touching pair it is
//! d/h = ρ g with g analytic, and (1 − (ρg)^p)/p = (1 − ρ^p)/p − ρ^p (g^p − 1)/p is integrated with the two Gauss rules of
//! [`super::rules`], which stay valid through ν = 1/2.
//! Cost: O(P² n²) kernel values for P panels, n points; O(P n²) once the skipped pairs dominate.

use super::kernel::{exp_quotient, kernel, power_increment};
use super::rules::{Pairs, Rules};
use super::space::{MOST_FUNCTIONS, SlopeSpace, Values};
use crate::error::Result;
use crate::estimate::Work;
use crate::sobolev::FractionalOrder;
use faer::Mat;
use rayon::prelude::*;

/// Interactions below this fraction of the self energies cannot change any digit of f64.
const NEGLIGIBLE: f64 = 1e-22;

/// Panels that touch, or are closer than this fraction of their own extent, get 3/2 as many points.
const CLOSE: f64 = 0.7;
const CLOSE_POINTS: (usize, usize) = (3, 2);

/// Gram matrix of |u|_ν² with n-point rules, and the work it took.
pub(crate) fn seminorm_gram(
    space: &SlopeSpace,
    order: FractionalOrder,
    n: usize,
) -> Result<(Mat<f64>, Work)> {
    let assembly = Assembly::new(space, order, n)?;
    let size = space.dimension();
    // One accumulator per thread; rows are dealt out in turn because they grow shorter.
    let threads = rayon::current_num_threads();
    let parts: Vec<(Mat<f64>, Work)> = (0..threads)
        .into_par_iter()
        .map(|part| {
            let (mut gram, mut work) = (Mat::zeros(size, size), Work::default());
            for i in (part..space.panels.len()).step_by(threads) {
                assembly.add_row(i, &mut gram, &mut work);
            }
            (gram, work)
        })
        .collect();
    let (mut gram, mut work) = (Mat::<f64>::zeros(size, size), Work::default());
    for (part, counted) in &parts {
        gram += part;
        work += *counted;
    }
    for j in 0..size {
        for i in 0..=j {
            let sum = (gram[(i, j)] + gram[(j, i)]) / order.value();
            gram[(i, j)] = sum;
            gram[(j, i)] = sum;
        }
    }
    Ok((gram, work))
}

/// ∬ over one pair of panels of L_k(s) L_l(t) times the kernel.
type Block = [[f64; MOST_FUNCTIONS]; MOST_FUNCTIONS];

struct Assembly<'a> {
    space: &'a SlopeSpace,
    p: f64,
    rules: Rules,
    /// Basis at the points of the plain rule, times weight, per panel.
    weighted: Vec<Vec<Values>>,
    /// Rules with more points, for panels that touch or nearly do; the basis at the plain ones.
    close_rules: Rules,
    close_weighted: Vec<Vec<Values>>,
    /// Self energy of a step across each panel, roughly.
    scale: Vec<f64>,
}

impl<'a> Assembly<'a> {
    fn new(space: &'a SlopeSpace, order: FractionalOrder, n: usize) -> Result<Self> {
        let p = order.one_minus_twice();
        let rules = Rules::new(n, p)?;
        let weighted_basis = |rule: &Pairs| -> Vec<Vec<Values>> {
            let at = |i: usize, &(t, w): &(f64, f64)| {
                let weight = w * space.panels[i].width;
                space.slopes(i, t).map(|value| value * weight)
            };
            (0..space.panels.len()).map(|i| rule.iter().map(|point| at(i, point)).collect()).collect()
        };
        let weighted = weighted_basis(&rules.plain);
        let close_rules = Rules::new(CLOSE_POINTS.0 * n / CLOSE_POINTS.1, p)?;
        let close_weighted = weighted_basis(&close_rules.plain);
        let scale = (0..space.panels.len())
            .map(|i| {
                let half = 0.5 * space.panels[i].length;
                kernel(p, space.panel_left[i] + half, half, space.panel_right[i] + half)
            })
            .collect();
        Ok(Self { space, p, rules, weighted, close_rules, close_weighted, scale })
    }

    /// Adds the pairs (i, j), j ≥ i, each once: the caller symmetrizes.
    fn add_row(&self, i: usize, gram: &mut Mat<f64>, work: &mut Work) {
        let space = self.space;
        if space.functions(i) == 0 {
            return;
        }
        let mut gap = 0.0;
        for j in i..space.panels.len() {
            if space.functions(j) > 0 {
                let block = match j - i {
                    0 => Some(self.same(i, work)),
                    1 => Some(self.touching(i, work)),
                    _ => self.separated(i, j, gap, work),
                };
                if let Some(block) = block {
                    work.pairs += 1;
                    self.add(gram, i, j, &block);
                }
            }
            if j > i {
                gap += space.panels[j].length;
            }
        }
    }

    fn add(&self, gram: &mut Mat<f64>, i: usize, j: usize, block: &Block) {
        let (row, column) = (self.space.first_of_panel(i), self.space.first_of_panel(j));
        for k in 0..self.space.functions(i) {
            for l in 0..self.space.functions(j) {
                gram[(row + k, column + l)] += block[k][l];
            }
        }
    }

    fn separated(&self, i: usize, j: usize, gap: f64, work: &mut Work) -> Option<Block> {
        let space = self.space;
        let (s, t) = (&space.panels[i], &space.panels[j]);
        let (left, right) = (space.panel_left[i], space.panel_right[j]);
        let largest = kernel(self.p, left + s.length, gap, right + t.length);
        if largest < NEGLIGIBLE * self.scale[i].sqrt() * self.scale[j].sqrt() {
            return None;
        }
        let is_close = s.outside(gap, false).min(t.outside(gap, true)) < CLOSE;
        let (points, weighted) = if is_close {
            (&self.close_rules.plain, &self.close_weighted)
        } else {
            (&self.rules.plain, &self.weighted)
        };
        let far: Vec<(f64, f64)> =
            points.iter().map(|&(x, _)| (t.left_distance(x), right + t.right_distance(1.0 - x))).collect();
        let mut block = [[0.0; MOST_FUNCTIONS]; MOST_FUNCTIONS];
        let (rows, columns) = (space.functions(i), space.functions(j));
        for (a, &(x, _)) in points.iter().enumerate() {
            let alpha = left + s.left_distance(x);
            let to_gap = s.right_distance(1.0 - x) + gap;
            let mut sums = [0.0; MOST_FUNCTIONS];
            for (b, &(in_t, beta)) in far.iter().enumerate() {
                let value = kernel(self.p, alpha, to_gap + in_t, beta);
                for l in 0..columns {
                    sums[l] += value * weighted[j][b][l];
                }
            }
            for k in 0..rows {
                for l in 0..columns {
                    block[k][l] += weighted[i][a][k] * sums[l];
                }
            }
        }
        work.points += (points.len() * points.len()) as u64;
        Some(block)
    }

    /// Panels i and i + 1. Corner coordinates: distances ρ, ρσ (in ξ) from the common point, both orders.
    fn touching(&self, i: usize, work: &mut Work) -> Block {
        let space = self.space;
        let (s, t) = (&space.panels[i], &space.panels[i + 1]);
        let size = s.length + t.length;
        let unit = size.powf(self.p);
        let mut sum = Sum::new(space, i, i + 1);
        for &(rho_rule, is_power) in
            &[(&self.close_rules.power[1], true), (&self.close_rules.logarithm[1], false)]
        {
            for &(rho, w) in rho_rule {
                for &(sigma, v) in &self.close_rules.plain {
                    for (a, b) in [(rho, rho * sigma), (rho * sigma, rho)] {
                        let value = if is_power {
                            let ratio = (s.right_distance(a) + t.left_distance(b)) / (rho * size);
                            -exp_quotient(self.p, ratio.ln())
                        } else {
                            1.0
                        };
                        sum.add(1.0 - a, b, unit * w * v * value);
                    }
                }
            }
        }
        work.points += 4 * (self.close_rules.plain.len() * self.close_rules.plain.len()) as u64;
        // The remaining terms depend on one of the two points only.
        let near_left = space.panel_left[i] <= space.panel_right[i + 1];
        let (mut of_s, mut of_t) = ([0.0; MOST_FUNCTIONS], [0.0; MOST_FUNCTIONS]);
        let (mut with_s, mut with_t) = ([0.0; MOST_FUNCTIONS], [0.0; MOST_FUNCTIONS]);
        for (q, &(x, _)) in self.close_rules.plain.iter().enumerate() {
            let left_distance = |panel: usize| space.panel_left[panel] + space.panels[panel].left_distance(x);
            let right_distance =
                |panel: usize| space.panel_right[panel] + space.panels[panel].right_distance(1.0 - x);
            let (f, g) = if near_left {
                (-self.outer(left_distance(i), right_distance(i)), self.inner(left_distance(i + 1), size))
            } else {
                (
                    self.inner(right_distance(i), size),
                    -self.outer(right_distance(i + 1), left_distance(i + 1)),
                )
            };
            for k in 0..space.functions(i) {
                of_s[k] += self.close_weighted[i][q][k];
                with_s[k] += f * self.close_weighted[i][q][k];
            }
            for l in 0..space.functions(i + 1) {
                of_t[l] += self.close_weighted[i + 1][q][l];
                with_t[l] += g * self.close_weighted[i + 1][q][l];
            }
        }
        for k in 0..space.functions(i) {
            for l in 0..space.functions(i + 1) {
                sum.block[k][l] += with_s[k] * of_t[l] + of_s[k] * with_t[l];
            }
        }
        sum.block
    }

    /// The triangle s < t of panel i with itself.
    fn same(&self, i: usize, work: &mut Work) -> Block {
        let space = self.space;
        let panel = &space.panels[i];
        let size = panel.length;
        let unit = size.powf(self.p);
        let mut sum = Sum::new(space, i, i);
        for &(step_rule, is_power) in &[(&self.rules.power[0], true), (&self.rules.logarithm[0], false)] {
            for &(step, w) in step_rule {
                for &(zeta, v) in &self.rules.plain {
                    let xi = (1.0 - step) * zeta;
                    let value = if is_power {
                        -exp_quotient(self.p, (panel.between(xi, step) / (step * size)).ln())
                    } else {
                        1.0
                    };
                    sum.add(xi, xi + step, unit * w * v * (1.0 - step) * value);
                }
            }
        }
        work.points += 2 * (self.rules.plain.len() * self.rules.plain.len()) as u64;
        let near_left = space.panel_left[i] <= space.panel_right[i];
        let (near, far) = if near_left {
            (space.panel_left[i], space.panel_right[i])
        } else {
            (space.panel_right[i], space.panel_left[i])
        };
        // Distances of the panel's points from the near end of the panel and from its far end.
        let from_near = |z: f64| if near_left { panel.left_distance(z) } else { panel.right_distance(z) };
        let from_far = |z: f64| if near_left { panel.right_distance(z) } else { panel.left_distance(z) };
        // z: near-end coordinate of the further point, z ζ that of the nearer one.
        let mut place = |z: f64, zeta: f64, value: f64| {
            let (nearer, further) = (z * zeta, z);
            if near_left {
                sum.add(nearer, further, value);
            } else {
                sum.add(1.0 - further, 1.0 - nearer, value);
            }
        };
        if near == 0.0 {
            // The panel starts at the end: x = h z, and (1 − z^p)/p is a weight.
            each_pair(&self.rules.logarithm[1], &self.rules.plain, |z, zeta, w| place(z, zeta, -unit * w));
        } else {
            each_pair(&self.rules.plain, &self.rules.plain, |z, zeta, w| {
                place(z, zeta, w * z * self.inner(near + from_near(z), size));
            });
        }
        // c: far-end coordinate of the nearer point, c ζ that of the further one.
        each_pair(&self.rules.plain, &self.rules.plain, |c, zeta, w| {
            let value = -w * c * self.outer(near + from_near(1.0 - c), far + from_far(c));
            let (nearer, further) = (1.0 - c, 1.0 - c * zeta);
            if near_left {
                sum.add(nearer, further, value);
            } else {
                sum.add(1.0 - further, 1.0 - nearer, value);
            }
        });
        sum.block
    }

    /// h^p ((x/h)^p − 1)/p.
    fn inner(&self, x: f64, size: f64) -> f64 {
        size.powf(self.p) * exp_quotient(self.p, (x / size).ln())
    }

    /// ((y+e)^p − y^p)/p.
    fn outer(&self, e: f64, y: f64) -> f64 {
        power_increment(self.p, y, e)
    }
}

fn each_pair(first: &Pairs, second: &Pairs, mut visit: impl FnMut(f64, f64, f64)) {
    for &(x, w) in first {
        for &(y, v) in second {
            visit(x, y, w * v);
        }
    }
}

/// Σ value L_k(s) L_l(t) over points of a pair of panels.
struct Sum<'a> {
    space: &'a SlopeSpace,
    panels: (usize, usize),
    jacobian: f64,
    block: Block,
}

impl<'a> Sum<'a> {
    fn new(space: &'a SlopeSpace, i: usize, j: usize) -> Self {
        Self {
            space,
            panels: (i, j),
            jacobian: space.panels[i].width * space.panels[j].width,
            block: [[0.0; MOST_FUNCTIONS]; MOST_FUNCTIONS],
        }
    }

    fn add(&mut self, xi: f64, eta: f64, value: f64) {
        let (i, j) = self.panels;
        let s = self.space.slopes(i, xi);
        let t = self.space.slopes(j, eta);
        let value = value * self.jacobian;
        for k in 0..self.space.functions(i) {
            for l in 0..self.space.functions(j) {
                self.block[k][l] += value * s[k] * t[l];
            }
        }
    }
}
