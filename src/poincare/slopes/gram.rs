//! The Gram matrix of the squared seminorm |u|_ν² in the slope basis.
//!
//! A = ∬ L_k(s) L_l(t) K(s,t), K of [`super::kernel`]. Pairs of panels fall into three classes. *Separated*: tensor Gauss rule;
//! pairs whose kernel is below 1e-18 of the geometric mean of their self energies are skipped. *Touching* and *same*: the kernel is
//!
//! ν K = h^p [ ((x/h)^p − 1)/p + (1 − (d/h)^p)/p ] − ((y+e)^p − y^p)/p,
//!
//! d = |s−t|, x the distance of the further point from the near end of the interval, e and y the distances of the nearer
//! point from the near and the far end, h the size of the pair. Only d carries a singularity; on the touching pair it is
//! d/h = ρ g with g analytic, and (1 − (ρg)^p)/p = (1 − ρ^p)/p − ρ^p (g^p − 1)/p is integrated with the two Gauss rules of
//! [`super::rules`], which stay valid through ν = 1/2.
//! Cost: O(P² n²) kernel values for P panels, n points; O(P n²) once the skipped pairs dominate.

use super::kernel::{exp_quotient, kernel, ln_ratio, power_increment};
use super::local::Local;
use super::rules::{Pairs, Rules};
use super::space::{MOST_FUNCTIONS, SlopeSpace, Values};
use crate::error::Result;
use crate::estimate::Work;
use crate::sobolev::FractionalOrder;
use faer::Mat;
use rayon::prelude::*;

/// Interactions below this fraction of the self energies do not change any digit of the quotient.
const NEGLIGIBLE: f64 = 1e-18;

/// Panels that touch, or are closer than this fraction of their own extent, get 3/2 as many points.
const CLOSE: f64 = 0.7;
const CLOSE_POINTS: (usize, usize) = (3, 2);

/// Gram matrix of |u|_ν² with n-point rules, and the work it took; in the basis with hats where there is a `local` group.
pub(crate) fn seminorm_gram(
    space: &SlopeSpace,
    local: Option<&Local>,
    order: FractionalOrder,
    n: usize,
) -> Result<(Mat<f64>, Work)> {
    let assembly = Assembly::new(space, local, order, n)?;
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
            let sum = gram[(i, j)] + gram[(j, i)];
            gram[(i, j)] = sum;
            gram[(j, i)] = sum;
        }
    }
    if let Some(local) = local {
        gram = local.finish(space, gram, &assembly.rules.plain);
    }
    let nu = order.value();
    Ok((Mat::from_fn(size, size, |i, j| gram[(i, j)] / nu), work))
}

/// ∬ over one pair of panels of L_k(s) L_l(t) times the kernel.
type Block = [[f64; MOST_FUNCTIONS]; MOST_FUNCTIONS];

struct Assembly<'a> {
    space: &'a SlopeSpace,
    local: Option<&'a Local>,
    p: f64,
    rules: Rules,
    /// Basis at the points of the plain rule, times weight, per panel.
    weighted: Vec<Vec<Values>>,
    /// Rules with more points, for panels that touch or nearly do; the basis at the plain ones.
    close_rules: Rules,
    close_weighted: Vec<Vec<Values>>,
    /// Per panel of the local group: integrals of the basis, without and with the shifted kernel from P.
    from_origin: Vec<(Values, Values)>,
    /// Self energy of a step across each panel, roughly.
    scale: Vec<f64>,
}

impl<'a> Assembly<'a> {
    fn new(
        space: &'a SlopeSpace,
        local: Option<&'a Local>,
        order: FractionalOrder,
        n: usize,
    ) -> Result<Self> {
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
        let from_origin = local.map_or(Vec::new(), |local| {
            let kernel = |i: usize, x: f64| local.origin_kernel(local.position(space, i, x));
            let integrals = |i: usize| {
                let mut sums = ([0.0; MOST_FUNCTIONS + 1], [0.0; MOST_FUNCTIONS + 1]);
                for (values, &(x, _)) in weighted[i].iter().zip(&rules.plain) {
                    let value = if local.contains(space.panels[i].cell) { kernel(i, x) } else { 0.0 };
                    for k in 0..space.functions(i) {
                        sums.0[k] += values[k];
                        sums.1[k] += value * values[k];
                    }
                }
                sums
            };
            (0..space.panels.len()).map(integrals).collect()
        });
        let scale = (0..space.panels.len())
            .map(|i| {
                let half = 0.5 * space.panels[i].length;
                kernel(p, space.panel_left[i] + half, half, space.panel_right[i] + half)
            })
            .collect();
        Ok(Self { space, local, p, rules, weighted, close_rules, close_weighted, from_origin, scale })
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
        let classes = self.classes(i, j);
        let is_negligible = match (self.local, classes) {
            (Some(local), (true, _) | (_, true)) => local.is_negligible(space, s.cell, t.cell),
            _ => {
                let largest = kernel(self.p, left + s.length, gap, right + t.length);
                largest < NEGLIGIBLE * self.scale[i].sqrt() * self.scale[j].sqrt()
            }
        };
        if is_negligible {
            return None;
        }
        if let Some(local) = self.local
            && local.contains(s.cell)
            && local.contains(t.cell)
            && let Some(first_is_nearer) = local.is_nearer(space, i, j)
        {
            return Some(self.seen_from_origin(i, j, first_is_nearer));
        }
        let is_close = s.outside(gap, false).min(t.outside(gap, true)) < CLOSE;
        let (points, weighted) = if is_close {
            (&self.close_rules.plain, &self.close_weighted)
        } else {
            (&self.rules.plain, &self.weighted)
        };
        let far: Vec<(f64, f64)> =
            points.iter().map(|&(x, _)| (t.left_distance(x), right + t.right_distance(1.0 - x))).collect();
        let place = |panel: usize, x: f64| self.local.map_or(0.0, |local| local.position(space, panel, x));
        let at_t: Vec<f64> = points.iter().map(|&(x, _)| place(j, x)).collect();
        let alone_t: Vec<f64> =
            at_t.iter().map(|&t| self.local.map_or(0.0, |local| local.of_further(t))).collect();
        let mut block = [[0.0; MOST_FUNCTIONS]; MOST_FUNCTIONS];
        let (rows, columns) = (space.functions(i), space.functions(j));
        for (a, &(x, _)) in points.iter().enumerate() {
            let at_s = place(i, x);
            let alone_s = self.local.map_or(0.0, |local| local.of_nearer(at_s));
            let alpha = left + s.left_distance(x);
            let to_gap = s.right_distance(1.0 - x) + gap;
            let mut sums = [0.0; MOST_FUNCTIONS];
            for (b, &(in_t, beta)) in far.iter().enumerate() {
                let distance = to_gap + in_t;
                let value = match (self.local, classes) {
                    (Some(local), (true, true)) => alone_s + alone_t[b] + local.inside(distance),
                    (Some(local), (true, false)) => alone_s + local.leaving(at_s, at_t[b], distance),
                    (Some(local), (false, true)) => alone_t[b] + local.entering(at_s, at_t[b], distance),
                    _ => kernel(self.p, alpha, distance, beta),
                };
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

    /// Panels of the local group of which one is so much nearer to P that the kernel is that of P: a product of two integrals.
    fn seen_from_origin(&self, i: usize, j: usize, first_is_nearer: bool) -> Block {
        let (of_i, of_j) = if first_is_nearer {
            (&self.from_origin[i].0, &self.from_origin[j].1)
        } else {
            (&self.from_origin[i].1, &self.from_origin[j].0)
        };
        let mut block = [[0.0; MOST_FUNCTIONS]; MOST_FUNCTIONS];
        for k in 0..self.space.functions(i) {
            for l in 0..self.space.functions(j) {
                block[k][l] = of_i[k] * of_j[l];
            }
        }
        block
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
        let (mut of_s, mut of_t) = ([0.0; MOST_FUNCTIONS], [0.0; MOST_FUNCTIONS]);
        let (mut with_s, mut with_t) = ([0.0; MOST_FUNCTIONS], [0.0; MOST_FUNCTIONS]);
        for (q, &(x, _)) in self.close_rules.plain.iter().enumerate() {
            let (f, g) = (self.of_nearer(i, i + 1, size, x), self.of_further(i, i + 1, size, x));
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
        // The further point t at z, the nearer one at z ζ; on a panel that starts at the end, x = h z and (1 − z^p)/p is a weight.
        let near_left = space.panel_left[i] <= space.panel_right[i];
        let is_first = near_left && space.panel_left[i] == 0.0;
        let is_last = !near_left && space.panel_right[i] == 0.0;
        if is_first {
            each_pair(&self.rules.logarithm[1], &self.rules.plain, |z, zeta, w| {
                sum.add(z * zeta, z, -unit * w)
            });
        } else {
            each_pair(&self.rules.plain, &self.rules.plain, |z, zeta, w| {
                sum.add(z * zeta, z, w * z * self.of_further(i, i, size, z));
            });
        }
        // The nearer point s at 1 − c, the further one at 1 − c ζ.
        if is_last {
            each_pair(&self.rules.logarithm[1], &self.rules.plain, |c, zeta, w| {
                sum.add(1.0 - c, 1.0 - c * zeta, -unit * w);
            });
        } else {
            each_pair(&self.rules.plain, &self.rules.plain, |c, zeta, w| {
                sum.add(1.0 - c, 1.0 - c * zeta, w * c * self.of_nearer(i, i, size, 1.0 - c));
            });
        }
        sum.block
    }

    /// Whether the cells of two panels belong to the local group.
    fn classes(&self, i: usize, j: usize) -> (bool, bool) {
        let inside =
            |panel: usize| self.local.is_some_and(|local| local.is_shifted(self.space.panels[panel].cell));
        (inside(i), inside(j))
    }

    /// The part of ν K on panels i ≤ j of joint size h that depends on the nearer (left) point s only, at ξ of panel i.
    fn of_nearer(&self, i: usize, j: usize, size: f64, xi: f64) -> f64 {
        let space = self.space;
        let left = space.panel_left[i] + space.panels[i].left_distance(xi);
        let right = space.panel_right[i] + space.panels[i].right_distance(1.0 - xi);
        match (self.local, self.classes(i, j)) {
            (Some(local), (true, _)) => local.of_nearer(local.position(space, i, xi)),
            (Some(local), (false, true)) => self.inner(-local.position(space, i, xi), size),
            _ if space.panel_left[i] <= space.panel_right[j] => -self.outer(left, right),
            _ => self.inner(right, size),
        }
    }

    /// The part that depends on the further (right) point t only, at ξ of panel j.
    fn of_further(&self, i: usize, j: usize, size: f64, xi: f64) -> f64 {
        let space = self.space;
        let left = space.panel_left[j] + space.panels[j].left_distance(xi);
        let right = space.panel_right[j] + space.panels[j].right_distance(1.0 - xi);
        match (self.local, self.classes(i, j)) {
            (Some(local), (true, true)) => {
                local.of_further(local.position(space, j, xi)) + self.inner(local.unit(), size)
            }
            (Some(local), (false, true)) => local.of_further(local.position(space, j, xi)),
            (Some(local), (true, false)) => self.inner(local.position(space, j, xi), size),
            _ if space.panel_left[i] <= space.panel_right[j] => self.inner(left, size),
            _ => -self.outer(right, left),
        }
    }

    /// h^p ((x/h)^p − 1)/p.
    fn inner(&self, x: f64, size: f64) -> f64 {
        size.powf(self.p) * exp_quotient(self.p, ln_ratio(x, size))
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
