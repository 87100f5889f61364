//! The Gram matrix of the squared seminorm |u|_ν² in the slope basis.
//!
//! A_kl = ∬ L_k(s) L_l(t) K(s,t) ds dt, L_k the slopes of the basis functions, K of [`super::kernel`]. Pairs
//! of panels fall into two classes: those with a gap between them ([`super::separated`]; pairs whose kernel
//! is below 1e-18 of the geometric mean of their self energies are skipped), and those of a panel with itself
//! or its neighbour ([`super::adjacent`]). Cost: O(P²) kernel values for P panels, with a factor that
//! decreases from several hundred to ten with the distance; O(P) once the skipped pairs dominate.

use super::adjacent::{Adjacent, Block, EMPTY};
use super::kernel::{exp_quotient, kernel, ln_ratio, power_increment};
use super::local::Local;
use super::nodes::Nodes;
use super::space::{MOST_FUNCTIONS, SlopeSpace, Values, legendre};
use crate::Order;
use crate::error::Result;
use crate::estimate::Work;
use crate::numeric::parallel;
use crate::quadrature::Rule;
use nalgebra::DMatrix;

/// Panels that touch, or nearly touch, have up to 3/2 times as many points.
const CLOSE_POINTS: (usize, usize) = (3, 2);
/// Slopes of lower degree than elsewhere in the space are used where the energy is negligible (see the mesh):
/// the number of points for them ...
const COARSE_POINTS: usize = 6;
/// ... their largest number of functions, and the number of digits required for their energy.
const COARSE_FUNCTIONS: usize = 2;
const COARSE_DIGITS: f64 = 6.0;

/// The Gram matrix of |u|_ν² with n-point rules, and its work; in the basis with hat functions if there is a
/// `local` group.
pub(crate) fn seminorm_gram(
    space: &SlopeSpace,
    local: Option<&Local>,
    order: Order,
    n: usize,
) -> Result<(DMatrix<f64>, Work)> {
    let assembly = Assembly::new(space, local, order, n)?;
    let size = space.dimension();
    // One accumulator per thread; rows are dealt out in turn because they grow shorter.
    let threads = rayon::current_num_threads();
    let parts: Vec<(DMatrix<f64>, Work)> = parallel::map(threads, &|part| {
        let (mut gram, mut work) = (DMatrix::zeros(size, size), Work::default());
        for i in (part..space.panels.len()).step_by(threads) {
            assembly.add_row(i, &mut gram, &mut work);
        }
        (gram, work)
    });
    let (mut gram, mut work) = (DMatrix::<f64>::zeros(size, size), Work::default());
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
        gram = local.finish(space, gram, &assembly.plain);
    }
    let nu = order.value();
    Ok((DMatrix::from_fn(size, size, |i, j| gram[(i, j)] / nu), work))
}

/// The data for the computation of the blocks.
pub(super) struct Assembly<'a> {
    pub(super) space: &'a SlopeSpace,
    pub(super) local: Option<&'a Local>,
    pub(super) p: f64,
    plain: Vec<(f64, f64)>,
    pub(super) nodes: Nodes,
    fine: Adjacent,
    coarse: Adjacent,
    /// Number of digits required for the integrals of a fine panel.
    digits: f64,
    /// Legendre coefficients of the basis of the cell on each panel, times the width of the panel.
    restrictions: Vec<Block>,
    /// For each panel of the local group: integrals of the basis, without and with the shifted kernel from P.
    pub(super) from_origin: Vec<(Values, Values)>,
    /// Rough self energy of a step across each panel.
    pub(super) scale: Vec<f64>,
}

impl<'a> Assembly<'a> {
    fn new(
        space: &'a SlopeSpace,
        local: Option<&'a Local>,
        order: Order,
        n: usize,
    ) -> Result<Self> {
        let p = order.one_minus_twice();
        let functions = space.cells.iter().map(|cell| cell.functions).max().unwrap_or(1);
        let close = |n: usize| CLOSE_POINTS.0 * n / CLOSE_POINTS.1;
        let plain: Vec<(f64, f64)> = Rule::gauss_legendre(n)?.iter().collect();
        let digits = n as f64 - 2.5;
        let few = COARSE_POINTS.min(n);
        let scale = |i: usize| {
            let half = 0.5 * space.panels[i].length;
            kernel(p, space.panel_left[i] + half, half, space.panel_right[i] + half)
        };
        let from_origin = local.map_or(Vec::new(), |local| from_origin(space, local, &plain));
        Ok(Self {
            space,
            local,
            p,
            nodes: Nodes::new(space, close(n), digits)?,
            fine: Adjacent::new(functions, p, n, close(n))?,
            coarse: Adjacent::new(COARSE_FUNCTIONS, p, few, close(few))?,
            digits,
            restrictions: (0..space.panels.len()).map(|i| restriction(space, i, &plain)).collect(),
            from_origin,
            scale: (0..space.panels.len()).map(scale).collect(),
            plain,
        })
    }

    /// True for a coarse panel outside the local group, where hat functions are differences of steps at
    /// full accuracy.
    fn is_coarse(&self, i: usize) -> bool {
        self.space.functions(i) <= COARSE_FUNCTIONS && !self.classes(i, i).0
    }

    /// The number of digits required for integrals over panel i.
    pub(super) fn digits(&self, i: usize) -> f64 {
        if self.is_coarse(i) { COARSE_DIGITS.min(self.digits) } else { self.digits }
    }

    /// Adds the pairs (i, j), j ≥ i, each once; the caller symmetrizes the matrix.
    fn add_row(&self, i: usize, gram: &mut DMatrix<f64>, work: &mut Work) {
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

    fn add(&self, gram: &mut DMatrix<f64>, i: usize, j: usize, block: &Block) {
        let (row, column) = (self.space.first_of_panel(i), self.space.first_of_panel(j));
        for k in 0..self.space.functions(i) {
            for l in 0..self.space.functions(j) {
                gram[(row + k, column + l)] += block[k][l];
            }
        }
    }

    /// The block of panels i and i + 1.
    fn touching(&self, i: usize, work: &mut Work) -> Block {
        let space = self.space;
        let (s, t) = (&space.panels[i], &space.panels[i + 1]);
        let size = s.length + t.length;
        let rules =
            if self.is_coarse(i) && self.is_coarse(i + 1) { &self.coarse } else { &self.fine };
        work.points += rules.points().1;
        let nearer = |xi: f64| self.of_nearer(i, i + 1, size, xi);
        let further = |xi: f64| self.of_further(i, i + 1, size, xi);
        self.in_cells(i, i + 1, &rules.touching((s, t), nearer, further))
    }

    /// The block of the triangle s < t of panel i with itself.
    fn same(&self, i: usize, work: &mut Work) -> Block {
        let space = self.space;
        let size = space.panels[i].length;
        let rules = if self.is_coarse(i) { &self.coarse } else { &self.fine };
        work.points += rules.points().0;
        let nearer = |xi: f64| self.of_nearer(i, i, size, xi);
        let further = |xi: f64| self.of_further(i, i, size, xi);
        let near_left = space.panel_left[i] <= space.panel_right[i];
        let at_left_end = near_left && space.panel_left[i] == 0.0;
        let at_right_end = !near_left && space.panel_right[i] == 0.0;
        let block = rules.same(
            &space.panels[i],
            (!at_right_end).then_some(&nearer),
            (!at_left_end).then_some(&further),
        );
        self.in_cells(i, i, &block)
    }

    /// The block in the basis of the cells, from Legendre polynomials of two panels.
    fn in_cells(&self, i: usize, j: usize, block: &Block) -> Block {
        let (of_i, of_j) = (&self.restrictions[i], &self.restrictions[j]);
        let (rows, columns) = (self.space.functions(i), self.space.functions(j));
        let (mut half, mut whole) = (EMPTY, EMPTY);
        for m in 0..rows {
            for l in 0..columns {
                half[m][l] = (0..columns).map(|q| block[m][q] * of_j[q][l]).sum();
            }
        }
        for k in 0..rows {
            for l in 0..columns {
                whole[k][l] = (0..rows).map(|m| of_i[m][k] * half[m][l]).sum();
            }
        }
        whole
    }

    /// For each of two panels, true if its cell belongs to the local group.
    pub(super) fn classes(&self, i: usize, j: usize) -> (bool, bool) {
        let inside = |panel: usize| {
            self.local.is_some_and(|local| local.is_shifted(self.space.panels[panel].cell))
        };
        (inside(i), inside(j))
    }

    /// The part of ν K on panels i ≤ j of joint size h that depends only on the nearer (left) point s, at ξ of
    /// panel i.
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

    /// The part that depends only on the farther (right) point t, at ξ of panel j.
    fn of_further(&self, i: usize, j: usize, size: f64, xi: f64) -> f64 {
        let space = self.space;
        let left = space.panel_left[j] + space.panels[j].left_distance(xi);
        let right = space.panel_right[j] + space.panels[j].right_distance(1.0 - xi);
        match (self.local, self.classes(i, j)) {
            (Some(local), (true, true)) => {
                local.of_further(local.position(space, j, xi)) + self.inner(local.unit, size)
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

/// Integrals of the basis over each panel, without and with the kernel from P.
fn from_origin(space: &SlopeSpace, local: &Local, rule: &[(f64, f64)]) -> Vec<(Values, Values)> {
    let integrals = |i: usize| {
        let mut sums = ([0.0; MOST_FUNCTIONS + 1], [0.0; MOST_FUNCTIONS + 1]);
        if !local.contains(space.panels[i].cell) {
            return sums;
        }
        for &(xi, w) in rule {
            let values = space.slopes(i, xi);
            let weight = w * space.panels[i].width;
            let value = local.origin_kernel(local.position(space, i, xi));
            for k in 0..space.functions(i) {
                sums.0[k] += weight * values[k];
                sums.1[k] += weight * value * values[k];
            }
        }
        sums
    };
    (0..space.panels.len()).map(integrals).collect()
}

/// Legendre coefficients of the basis of the cell on panel i: row m, column k, times the width of the panel.
fn restriction(space: &SlopeSpace, i: usize, rule: &[(f64, f64)]) -> Block {
    let functions = space.functions(i);
    let mut coefficients = EMPTY;
    for &(xi, w) in rule {
        let (here, cell) = (legendre(functions, xi), space.slopes(i, xi));
        for m in 0..functions {
            for k in 0..functions {
                coefficients[m][k] += w * space.panels[i].width * here[m] * cell[k];
            }
        }
    }
    coefficients
}
