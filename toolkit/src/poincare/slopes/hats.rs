//! The basis of the group around a short zone: hat functions in place of steps, and the terms to be
//! added to the matrix of the seminorm after its assembly with the shifted kernel of [`super::local`].

use super::kernel::{kernel, power_increment};
use super::local::Local;
use super::space::SlopeSpace;
use nalgebra::DMatrix;

impl Local {
    /// The cells of G whose steps are combined into hat functions, in order.
    pub(super) fn steps(&self, space: &SlopeSpace) -> Vec<usize> {
        self.cells.clone().filter(|&c| self.has_hats && space.cells[c].functions > 0).collect()
    }

    /// The product Tᵀ M T, the matrix of a form in the basis with hat functions.
    pub(crate) fn transformed(&self, space: &SlopeSpace, mut matrix: DMatrix<f64>) -> DMatrix<f64> {
        let size = matrix.nrows();
        for pair in self.steps(space).windows(2) {
            let (i, j) = (space.first[pair[0]], space.first[pair[1]]);
            for k in 0..size {
                matrix[(i, k)] -= matrix[(j, k)];
            }
        }
        for pair in self.steps(space).windows(2) {
            let (i, j) = (space.first[pair[0]], space.first[pair[1]]);
            for k in 0..size {
                matrix[(k, i)] -= matrix[(k, j)];
            }
        }
        matrix
    }

    /// The product Tᵀ b.
    pub(crate) fn transformed_vector(&self, space: &SlopeSpace, mut vector: Vec<f64>) -> Vec<f64> {
        for pair in self.steps(space).windows(2) {
            vector[space.first[pair[0]]] -= vector[space.first[pair[1]]];
        }
        vector
    }

    /// The product T y: coefficients of steps from coefficients of hat functions.
    pub(crate) fn restored(&self, space: &SlopeSpace, mut vector: Vec<f64>) -> Vec<f64> {
        for pair in self.steps(space).windows(2).rev() {
            vector[space.first[pair[1]]] -= vector[space.first[pair[0]]];
        }
        vector
    }

    /// Completes ν times the Gram matrix assembled with the shifted kernel: transformation to hat functions,
    /// negligible entries, and the terms that the last step lacks.
    pub(crate) fn finish(
        &self,
        space: &SlopeSpace,
        gram: DMatrix<f64>,
        rule: &[(f64, f64)],
    ) -> DMatrix<f64> {
        if !self.has_hats {
            return gram;
        }
        let mut gram = self.transformed(space, gram);
        let steps = self.steps(space);
        let next =
            |c: usize| steps.iter().position(|&s| s == c).and_then(|k| steps.get(k + 1)).copied();
        for c in self.cells.clone() {
            for d in 0..space.cells.len() {
                let (first, second) = (c..=next(c).unwrap_or(c), d..=next(d).unwrap_or(d));
                let ranges = (self.range(space, first.clone()), self.range(space, second.clone()));
                let small_first = c != self.last() && self.is_apart(ranges.0.1, ranges.1.0);
                let small_second =
                    self.contains(d) && d != self.last() && self.is_apart(ranges.1.1, ranges.0.0);
                if small_first || small_second {
                    for i in space.first[c]..space.first[c + 1] {
                        for j in space.first[d]..space.first[d + 1] {
                            gram[(i, j)] = 0.0;
                            gram[(j, i)] = 0.0;
                        }
                    }
                }
            }
        }
        let kept = space.first[self.last()];
        let (a, b, c) = (self.left, self.right, self.unit);
        gram[(kept, kept)] += power_increment(self.p, c, a - c) - power_increment(self.p, b, a);
        for (panel, shape) in
            space.panels.iter().enumerate().filter(|(_, shape)| !self.contains(shape.cell))
        {
            for &(xi, w) in rule {
                let gap = self.position(space, panel, xi);
                let (before, after) = if gap > 0.0 {
                    (self.left, space.panel_right[panel] + shape.right_distance(1.0 - xi))
                } else {
                    (space.panel_left[panel] + shape.left_distance(xi), self.right)
                };
                let value = w * shape.width * kernel(self.p, before, gap.abs(), after);
                let slopes = space.slopes(panel, xi);
                for k in 0..space.functions(panel) {
                    let i = space.first_of_panel(panel) + k;
                    gram[(kept, i)] += value * slopes[k];
                    gram[(i, kept)] += value * slopes[k];
                }
            }
        }
        gram
    }
}
