//! |w|²_s as a sum over pairs of triangles: all pairs directly, or near pairs directly and far pairs by
//! clusters.

use super::far::{FarField, Source};
use super::function::PlaneFunction;
use super::geometry::Point;
use super::leaves::LEVELS;
use super::means::{Means, Shape};
use super::simplex::{Corner, Simplex};
use super::tree::Tree;
use crate::error::Result;
use crate::estimate::{Estimate, Work};
use crate::numeric::parallel;
use crate::numeric::sum::{RunningSum, compensated};
use crate::root::ENTRY_ROUNDING;

/// Largest number of triangles for which all pairs are summed directly.
const DIRECT: usize = 200;
/// Safety factor: ratio of the error of a rule to its difference from the next rule.
const SAFETY: f64 = 3.0;
/// Smallest ratio of successive changes that is accepted.
const LEAST_CHANGE: f64 = 0.02;
/// Ratio of the error with q + 1 Chebyshev points to the change from q − 1 points: two steps, since odd and
/// even numbers of points have different errors and a single step may be small by accident.
const FAR_SAFETY: f64 = 0.5;
/// ln of the average gain per additional Chebyshev point at the nearest corners of separated clusters.
const FAR_GAIN: f64 = 2.7;
/// Smallest and largest number of Chebyshev points.
const FAR_POINTS: (usize, usize) = (4, 18);

/// The sums for one function, in units of its values and of its polygon.
pub(super) struct PairSum {
    shape: Shape,
    simplices: Vec<Simplex<1>>,
    triangles: Vec<[Point; 3]>,
    values: Vec<[f64; 3]>,
    areas: Vec<f64>,
}

type Part = ([f64; LEVELS], Work);

impl PairSum {
    pub(super) fn new(w: &PlaneFunction, unit: f64, extent: f64) -> Self {
        let mesh = w.mesh();
        let count = mesh.triangles().len();
        let triangles: Vec<[Point; 3]> =
            (0..count).map(|t| mesh.corners(t).map(|p| p.map(|x| x / extent))).collect();
        let values: Vec<[f64; 3]> = (0..count).map(|t| w.on(t).map(|value| value / unit)).collect();
        let corner = |t: usize, k: usize| Corner {
            node: mesh.triangles()[t][k],
            at: triangles[t][k],
            values: [values[t][k]],
        };
        let simplex = |t| Simplex::triangle(std::array::from_fn(|k| corner(t, k)));
        Self {
            shape: w.shape(),
            simplices: (0..count).map(simplex).collect(),
            areas: mesh.areas().iter().map(|area| area / extent / extent).collect(),
            triangles,
            values,
        }
    }

    /// The sum with integrals of the given accuracy.
    pub(super) fn squared(&self, means: &Means, s: f64, accuracy: f64) -> Result<Estimate> {
        let count = self.simplices.len();
        if count <= DIRECT {
            let row = |i: usize| self.near(means, &[i], &(i..count).collect::<Vec<_>>());
            let rows = parallel::map(count, &row).into_iter().collect::<Result<Vec<_>>>()?;
            return settled(&rows, 0.0, 0.0);
        }
        let tree = Tree::new(&self.triangles);
        let pairs = tree.pairs();
        let leaf = |index: usize| &tree.order[tree.clusters[index].first..tree.clusters[index].end];
        let near = |[a, b]: &[usize; 2]| self.near(means, leaf(*a), leaf(*b));
        let mut parts =
            parallel::over(&pairs.near, near).into_iter().collect::<Result<Vec<_>>>()?;
        let q = (-accuracy.ln() / FAR_GAIN).ceil() as usize;
        let q = q.clamp(FAR_POINTS.0, FAR_POINTS.1);
        let source =
            Source { triangles: &self.triangles, values: &self.values, areas: &self.areas };
        let mut far = [0.0; 2];
        for (sum, q) in far.iter_mut().zip([q - 1, q + 1]) {
            let field = FarField::new(&tree, &source, q, s)?;
            let found: Vec<(f64, u64)> = parallel::over(&pairs.far, |[a, b]| field.pair(*a, *b));
            *sum = 2.0 * compensated(found.iter().map(|part| part.0));
            let points = found.iter().map(|part| part.1).sum();
            parts.push((
                [0.0; LEVELS],
                Work { points, pairs: found.len() as u64, ..Work::default() },
            ));
        }
        settled(&parts, far[1], FAR_SAFETY * (far[1] - far[0]).abs())
    }

    /// The sum over all pairs of triangles from two lists; for a list with itself each pair is counted once.
    fn near(&self, means: &Means, first: &[usize], second: &[usize]) -> Result<Part> {
        let (mut sums, mut work) = ([RunningSum::default(); LEVELS], Work::default());
        let same = std::ptr::eq(first, second);
        for (k, &i) in first.iter().enumerate() {
            for &j in if same { &second[k..] } else { second } {
                let constants = self.shape == Shape::Constants;
                if constants && self.values[i][0] == self.values[j][0] {
                    continue;
                }
                let weight = [if i == j { 1.0 } else { 2.0 } * self.areas[i], self.areas[j]];
                let mean =
                    means.mean(&self.simplices[i], &self.simplices[j], weight, &mut work.points)?;
                work.pairs += 1;
                sums.iter_mut().zip(mean).for_each(|(sum, [[part]])| sum.add(part));
            }
        }
        Ok((sums.map(|sum| sum.value()), work))
    }
}

/// The second of three converging sums, with its error estimated from the third; a last change far below the
/// previous one is not trusted.
fn settled(parts: &[Part], far: f64, far_error: f64) -> Result<Estimate> {
    let [first, value, judge]: [f64; LEVELS] =
        std::array::from_fn(|k| compensated(parts.iter().map(|part| part.0[k])));
    let work = parts.iter().fold(Work::default(), |work, part| work + part.1);
    let (before, after) = ((value - first).abs(), (judge - value).abs());
    let error = SAFETY * after.max(LEAST_CHANGE * before) + far_error;
    Estimate::new(value + far, error + ENTRY_ROUNDING * (value + far), work)
}
