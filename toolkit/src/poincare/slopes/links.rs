//! Functions that vanish on several intervals: u must return to zero between two of them.
//!
//! Each interval is represented by a cell on which u is constant; that all constants agree is one condition for
//! every gap between two intervals, Σ x = 0 over the steps of the gap. In the basis of steps, the step of the
//! longest cell is expressed by the others; in the basis with hat functions of [`super::local`], where a
//! coefficient is the value of u at the right end of its cell, the coefficient at the end of every gap equals
//! the one before the first interval.

use super::local::Local;
use super::space::SlopeSpace;
use nalgebra::DMatrix;
use std::ops::Range;

/// Unknowns that are determined by others, each with its terms: x_k = Σ c x_j.
#[derive(Debug, Clone, Default)]
pub(crate) struct Links {
    links: Vec<(usize, Vec<(usize, f64)>)>,
}

impl Links {
    /// The conditions that u has the same value on all cells of `zones`, ranges in order.
    pub(crate) fn new(space: &SlopeSpace, local: Option<&Local>, zones: &[Range<usize>]) -> Self {
        let step = |cell: usize| space.first[cell];
        let link = |pair: &[Range<usize>]| -> Option<(usize, Vec<(usize, f64)>)> {
            let gap = pair[0].end..pair[1].start;
            match local.filter(|local| local.has_hats) {
                Some(local) => {
                    let before =
                        local.steps(space).into_iter().take_while(|&c| c < zones[0].start).last();
                    Some((
                        step(gap.last()?),
                        before.map(|cell| (step(cell), 1.0)).into_iter().collect(),
                    ))
                }
                None => {
                    let length = |cell: &usize| space.cells[*cell].length;
                    let longest = gap.clone().max_by(|a, b| length(a).total_cmp(&length(b)))?;
                    let others = gap.filter(|&cell| cell != longest).map(|cell| (step(cell), -1.0));
                    Some((step(longest), others.collect()))
                }
            }
        };
        Self { links: zones.windows(2).filter_map(link).collect() }
    }

    /// The matrix of a form on the remaining unknowns.
    pub(crate) fn reduced(&self, mut matrix: DMatrix<f64>) -> DMatrix<f64> {
        if self.links.is_empty() {
            return matrix;
        }
        let size = matrix.nrows();
        for (from, terms) in &self.links {
            for &(to, factor) in terms {
                for k in 0..size {
                    matrix[(to, k)] += factor * matrix[(*from, k)];
                }
            }
            for &(to, factor) in terms {
                for k in 0..size {
                    matrix[(k, to)] += factor * matrix[(k, *from)];
                }
            }
        }
        let kept = self.kept(size);
        DMatrix::from_fn(kept.len(), kept.len(), |i, j| matrix[(kept[i], kept[j])])
    }

    /// The vector of a functional on the remaining unknowns.
    pub(crate) fn reduced_vector(&self, mut vector: Vec<f64>) -> Vec<f64> {
        for (from, terms) in &self.links {
            for &(to, factor) in terms {
                vector[to] += factor * vector[*from];
            }
        }
        self.kept(vector.len()).into_iter().map(|k| vector[k]).collect()
    }

    /// All unknowns, from the remaining ones.
    pub(crate) fn expanded(&self, vector: Vec<f64>) -> Vec<f64> {
        if self.links.is_empty() {
            return vector;
        }
        let size = vector.len() + self.links.len();
        let mut all = vec![0.0; size];
        for (k, value) in self.kept(size).into_iter().zip(vector) {
            all[k] = value;
        }
        for (from, terms) in &self.links {
            all[*from] = terms.iter().map(|&(to, factor)| factor * all[to]).sum();
        }
        all
    }

    fn kept(&self, size: usize) -> Vec<usize> {
        (0..size).filter(|k| self.links.iter().all(|(from, _)| from != k)).collect()
    }
}
