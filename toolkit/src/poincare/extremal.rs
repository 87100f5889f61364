//! The function that attains the Poincaré constant of (5.4), given by its slopes.

use super::discrete::Discrete;
use super::slopes::space::{SlopeSpace, legendre_primitives};
use crate::constant::OnInterval;

/// A function u with ‖u‖₀ = 1 on (0,1) that is positive where |u| is largest.
#[derive(Debug, Clone)]
pub(super) struct SlopeSum {
    /// One function of a slope space, or several with their weights if they are extrapolated from larger
    /// orders.
    terms: Vec<(f64, SlopeFunction)>,
    /// True if the terms are functions of 1 − x.
    is_mirrored: bool,
}

impl SlopeSum {
    pub(super) fn new(discrete: &Discrete, coefficients: Vec<f64>) -> Self {
        Self { terms: vec![(1.0, SlopeFunction::new(discrete, coefficients))], is_mirrored: false }
    }

    /// The function u(1 − x).
    pub(super) fn mirrored(self) -> Self {
        Self { is_mirrored: !self.is_mirrored, ..self }
    }

    /// Σ w_k u_k for functions of nearby orders, after their signs are made to agree.
    pub(super) fn combined(weights: &[f64], functions: Vec<Self>) -> Self {
        let first = functions.first().map_or(Vec::new(), |u| u.profile(1));
        let agrees =
            |u: &Self| first.iter().map(|&(x, value)| value * u.value(x)).sum::<f64>() >= 0.0;
        let mut terms = Vec::new();
        for (&weight, function) in weights.iter().zip(functions) {
            let weight = if agrees(&function) { weight } else { -weight };
            terms.extend(function.terms.into_iter().map(|(inner, u)| (weight * inner, u)));
        }
        Self { terms, is_mirrored: false }
    }

    fn profile_of_terms(&self, per_cell: usize) -> Vec<(f64, f64)> {
        match self.terms.as_slice() {
            [] => Vec::new(),
            [(weight, only)] => {
                only.profile(per_cell).into_iter().map(|(x, u)| (x, weight * u)).collect()
            }
            [(_, first), ..] => {
                first.profile(per_cell).iter().map(|&(x, _)| (x, self.value_of_terms(x))).collect()
            }
        }
    }

    fn value_of_terms(&self, x: f64) -> f64 {
        self.terms.iter().map(|(weight, u)| weight * u.value(x)).sum()
    }
}

impl OnInterval for SlopeSum {
    fn value(&self, x: f64) -> f64 {
        self.value_of_terms(if self.is_mirrored { 1.0 - x } else { x })
    }

    fn profile(&self, per_cell: usize) -> Vec<(f64, f64)> {
        let points = self.profile_of_terms(per_cell);
        if self.is_mirrored {
            return points.into_iter().rev().map(|(x, u)| (1.0 - x, u)).collect();
        }
        points
    }
}

/// A function of one slope space.
#[derive(Debug, Clone)]
struct SlopeFunction {
    space: SlopeSpace,
    unit: f64,
    coefficients: Vec<f64>,
    /// The values at the left ends of the cells, and at 1.
    nodes: Vec<f64>,
}

impl SlopeFunction {
    fn new(discrete: &Discrete, coefficients: Vec<f64>) -> Self {
        let space = discrete.space.clone();
        let beside = &discrete.primitives.beside;
        // Value at a node: the right constants of the cells before it, the left constants of those after it.
        let sum = |range: std::ops::Range<usize>, side: fn(&(f64, f64)) -> f64| -> f64 {
            range.map(|i| coefficients[i] * side(&beside[i])).sum()
        };
        let nodes: Vec<f64> = space
            .first
            .iter()
            .map(|&split| sum(0..split, |c| c.1) + sum(split..coefficients.len(), |c| c.0))
            .collect();
        let mut function = Self { space, unit: discrete.unit, coefficients, nodes };
        let largest = function
            .nodes
            .iter()
            .copied()
            .fold(0.0, |a: f64, b| if b.abs() > a.abs() { b } else { a });
        if largest < 0.0 {
            function.nodes.iter_mut().for_each(|value| *value = -*value);
            function.coefficients.iter_mut().for_each(|value| *value = -*value);
        }
        function
    }

    fn profile(&self, per_cell: usize) -> Vec<(f64, f64)> {
        let mut points = Vec::new();
        for (index, cell) in self.space.cells.iter().enumerate() {
            for k in 0..per_cell.max(1) {
                let xi = k as f64 / per_cell.max(1) as f64;
                let x = self.space.cell_left[index] + cell.left_distance(xi);
                points.push((x * self.unit, self.in_cell(index, xi)));
            }
        }
        points.push((1.0, self.nodes[self.nodes.len() - 1]));
        points
    }

    fn value(&self, x: f64) -> f64 {
        let cells = &self.space.cells;
        if x <= 0.0 {
            return self.nodes[0];
        }
        if x >= 1.0 {
            return self.nodes[cells.len()];
        }
        let (index, xi) = if x < 0.5 {
            let position = x / self.unit;
            let index = self.space.cell_left.partition_point(|&left| left <= position) - 1;
            (index, cells[index].coordinate(position - self.space.cell_left[index]))
        } else {
            let position = (1.0 - x) / self.unit;
            let index = self.space.cell_right.partition_point(|&right| right > position);
            let index = index.min(cells.len() - 1);
            let from_right = position - self.space.cell_right[index];
            (index, 1.0 - cells[index].mirrored().coordinate(from_right))
        };
        self.in_cell(index, xi.clamp(0.0, 1.0))
    }

    fn in_cell(&self, cell: usize, xi: f64) -> f64 {
        let functions = self.space.cells[cell].functions;
        if functions == 0 {
            return self.nodes[cell];
        }
        let first = self.space.first[cell];
        let primitives = legendre_primitives(functions, xi);
        let inner: f64 = (1..functions).map(|k| self.coefficients[first + k] * primitives[k]).sum();
        (1.0 - xi) * self.nodes[cell] + xi * self.nodes[cell + 1] + inner
    }
}
