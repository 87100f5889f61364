//! The Gram matrix of ‖u‖₀²/ℓ, ℓ the length of the interval, in the slope basis, where a condition on a range
//! of cells determines the constant.
//!
//! The condition is ∫_E u = 0 on ranges E of cells, or u = 0 at a node (an empty range). Each basis function is
//! a constant to the left of its cell, a constant to the right of it, and a primitive of its slope inside; the
//! two constants follow from the condition. For function 0 of a cell (the step) they are (−1, 0) left of E,
//! (0, 1) right of E and (−e_r, e_l)/|E| between two ranges, e_l and e_r the lengths of E on either side, so
//! that no large numbers are subtracted; for the other functions of a cell outside E they are 0.

use super::space::{MOST_FUNCTIONS, SlopeSpace, Values, legendre_primitives};
use crate::error::Result;
use crate::quadrature::Rule;
use nalgebra::DMatrix;
use std::ops::Range;

/// The basis functions on their own cells, and the constants next to them.
#[derive(Debug, Clone)]
pub(crate) struct Primitives {
    /// The constants to the left and to the right of the cell, for each unknown.
    pub(crate) beside: Vec<(f64, f64)>,
    /// The integral of the function over its own cell, for each unknown.
    pub(crate) integral: Vec<f64>,
    /// The integrals of products over the cell, for each cell.
    products: Vec<Vec<Vec<f64>>>,
}

impl Primitives {
    /// The basis with mean zero over the cells of all ranges of `zones`, in order; if the only range is empty,
    /// with u = 0 at the node at its start.
    pub(crate) fn new(space: &SlopeSpace, zones: &[Range<usize>], n: usize) -> Result<Self> {
        let rule = Rule::gauss_legendre(n)?;
        let mut beside = Vec::with_capacity(space.dimension());
        let mut integral = Vec::with_capacity(space.dimension());
        let mut products = Vec::with_capacity(space.cells.len());
        let inside = || zones.iter().cloned().flatten();
        let length: f64 = inside().map(|cell| space.cells[cell].length).sum();
        for (index, cell) in space.cells.iter().enumerate() {
            let points = cell_points(space, index, &rule);
            let before =
                || inside().filter(|&i| i < index).map(|i| space.cells[i].length).sum::<f64>();
            let after =
                || inside().filter(|&i| i > index).map(|i| space.cells[i].length).sum::<f64>();
            let constants = if zones.iter().all(|zone| index < zone.start) {
                first_pair(-1.0, 0.0)
            } else if zones.iter().all(|zone| index >= zone.end) {
                first_pair(0.0, 1.0)
            } else if zones.iter().any(|zone| zone.contains(&index)) {
                mean_free(&points, cell.functions, before(), after(), length)
            } else {
                first_pair(-after() / length, before() / length)
            };
            let mut sums = [0.0; MOST_FUNCTIONS];
            let mut pairs = vec![vec![0.0; cell.functions]; cell.functions];
            for point in &points {
                let values = point.values(cell.functions, &constants);
                for k in 0..cell.functions {
                    sums[k] += point.weight * values[k];
                    for l in 0..cell.functions {
                        pairs[k][l] += point.weight * values[k] * values[l];
                    }
                }
            }
            beside.extend_from_slice(&constants[..cell.functions]);
            integral.extend_from_slice(&sums[..cell.functions]);
            products.push(pairs);
        }
        Ok(Self { beside, integral, products })
    }

    /// The mean of each basis function over the whole interval.
    pub(crate) fn means(&self, space: &SlopeSpace) -> Vec<f64> {
        let total: f64 = space.cells.iter().map(|cell| cell.length).sum();
        let cell_of = |c: usize| (space.first[c]..space.first[c + 1]).map(move |i| (c, i));
        (0..space.cells.len())
            .flat_map(cell_of)
            .map(|(c, i)| {
                let (left, right) = self.beside[i];
                (left * space.cell_left[c] + self.integral[i] + right * space.cell_right[c]) / total
            })
            .collect()
    }
}

/// A quadrature point of a cell: ξ, 1 − ξ and the weight with respect to x.
struct Point {
    xi: f64,
    complement: f64,
    weight: f64,
}

impl Point {
    /// The values of the basis functions: the step from the left to the right constant, and the primitives
    /// added to it.
    fn values(&self, functions: usize, beside: &[(f64, f64)]) -> Values {
        let mut values = legendre_primitives(functions, self.xi);
        values[0] = beside[0].0 * self.complement + beside[0].1 * self.xi;
        for k in 1..functions {
            values[k] += beside[k].0;
        }
        values
    }
}

fn cell_points(space: &SlopeSpace, cell: usize, rule: &Rule) -> Vec<Point> {
    let panels: Vec<_> = space.panels.iter().filter(|panel| panel.cell == cell).collect();
    let end = |panel: usize| panels.get(panel + 1).map_or(1.0, |next| next.start);
    let mut points = Vec::new();
    for (index, panel) in panels.iter().enumerate() {
        for (t, w) in rule.iter() {
            points.push(Point {
                xi: panel.in_cell(t),
                complement: (1.0 - end(index)) + panel.width * (1.0 - t),
                weight: w * panel.stretch(t),
            });
        }
    }
    points
}

fn first_pair(left: f64, right: f64) -> [(f64, f64); MOST_FUNCTIONS] {
    let mut pairs = [(0.0, 0.0); MOST_FUNCTIONS];
    pairs[0] = (left, right);
    pairs
}

/// The constants for which the mean over the zone vanishes, for the functions of a cell inside it.
fn mean_free(
    points: &[Point],
    functions: usize,
    before: f64,
    after: f64,
    length: f64,
) -> [(f64, f64); MOST_FUNCTIONS] {
    let mut sums = [0.0; MOST_FUNCTIONS];
    let mut falling = 0.0;
    for point in points {
        falling += point.weight * point.complement;
        let values = legendre_primitives(functions, point.xi);
        for k in 0..functions {
            sums[k] += point.weight * values[k];
        }
    }
    let mut constants = first_pair(-(after + sums[0]) / length, (before + falling) / length);
    for k in 1..functions {
        let constant = -sums[k] / length;
        constants[k] = (constant, constant);
    }
    constants
}

/// The Gram matrix of ‖u‖₀² divided by the length of the interval, so that its entries are of order one.
pub(crate) fn mass_gram(space: &SlopeSpace, primitives: &Primitives) -> DMatrix<f64> {
    let size = space.dimension();
    let total: f64 = space.cells.iter().map(|cell| cell.length).sum();
    let mut mass = DMatrix::<f64>::zeros(size, size);
    for (c, cell) in space.cells.iter().enumerate() {
        let left = space.cell_left[c];
        for k in 0..cell.functions {
            let i = space.first[c] + k;
            let (left_i, right_i) = primitives.beside[i];
            for l in 0..cell.functions {
                let j = space.first[c] + l;
                let (left_j, right_j) = primitives.beside[j];
                let value = left_i * left_j * left
                    + primitives.products[c][k][l]
                    + right_i * right_j * space.cell_right[c];
                mass[(i, j)] = value / total;
            }
            let mut between = 0.0;
            for d in c + 1..space.cells.len() {
                for l in 0..space.cells[d].functions {
                    let j = space.first[d] + l;
                    let (left_j, right_j) = primitives.beside[j];
                    let value = left_i * left_j * left
                        + left_j * primitives.integral[i]
                        + right_i * left_j * between
                        + right_i * primitives.integral[j]
                        + right_i * right_j * space.cell_right[d];
                    mass[(i, j)] = value / total;
                    mass[(j, i)] = value / total;
                }
                between += space.cells[d].length;
            }
        }
    }
    mass
}
