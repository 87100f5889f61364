//! The smallest positive and the largest eigenvalue of A x = λ M x.
//!
//! For the smallest one, the preconditioner is the inverse spectral power, and the iteration starts
//! from a few long waves. For the largest one, the preconditioner is (κM − K)⁻¹, K the stiffness
//! matrix and κ slightly above the largest eigenvalue of (K, M), and the iteration starts from
//! vectors of the largest eigenvalues of (K, M), from hat functions where a_ii/m_ii is largest, and
//! from vectors of windows of [`WINDOW`] basis functions: vectors of large eigenvalues live on a
//! few short elements, of which there may be many groups far from each other. A Krylov space of
//! M⁻¹A is built in all windows of a row at once, each product being restricted to the windows, and
//! the windows with the largest Ritz values are used. Vectors that change sign from element to
//! element interact little at a distance, so that one product serves all windows. For at most [`DENSE`]
//! functions one start vector is the eigenvector of the dense matrices.
//!
//! Where rounding of xᵀ(A x) limits the smallest eigenvalue, xᵀA x is summed once more as |u|².
//!
//! The preconditioner of the smallest eigenvalue is far from A where short elements stand beside long
//! ones: a step between two long elements separated by one of length h has the energy h^{1−2s} or less, in
//! the interpolation space h^{-s}. If [`FIRST`] steps do not suffice, up to [`ELIMINATED`] functions, the
//! vector x comes from an elimination ([`super::elimination`]). With the residual r = A x − θ M x, z = A⁻¹r
//! and T = A⁻¹M, T x = (x − z)/θ: in the product of M, 1/λ_1 lies between the quotient q of T,
//!   q = 1/θ + rᵀz/θ²,  and  q + (|z|_M/θ)²/(q − 1/σ),
//! where one eigenvalue lies below σ. Both terms are squares: rounding of A x on short elements, which
//! makes r large in the norm of M⁻¹, changes z little.

use super::elimination::{Elimination, lowest};
use super::tridiagonal::{Basis, Network, Tridiagonal};
use super::{GramOperator, Spectral};
use crate::error::{Error, Result};
use crate::estimate::{Estimate, Tolerance, Work};
use crate::mesh::Mesh;
use crate::numeric::block_iteration::{Count, Pencil, SHARES, Smallest, smallest};
use crate::numeric::dense::symmetric_eigen;
use crate::numeric::pencil::Factored;
use crate::numeric::sum::pairwise_dot;
use nalgebra::DMatrix;
use std::cell::OnceCell;
use std::ops::Range;

/// Number of vectors in a block.
const BLOCK: usize = 3;

/// Largest number of steps, and of those for the smallest eigenvalue if elimination is possible after
/// them: uniform and graded meshes take fewer.
const STEPS: usize = 300;
const FIRST: usize = 60;

/// Largest number of functions for elimination: its cost is O(n³), its memory twice that of the matrix, 134 MB.
const ELIMINATED: usize = 4096;

/// Relative distance of κ from the largest eigenvalue of (K, M).
const ABOVE: f64 = 1e-4;

/// Number of basis functions in a window; the windows of a second row begin in the middle of those
/// of the first.
const WINDOW: usize = 48;

/// Dimension of the Krylov space of a window, and number of windows that are taken.
const KRYLOV: usize = 16;
const TAKEN: usize = 6;

/// Smallest share of a product that a new direction of a window has.
const NEW: f64 = 1e-8;

/// Relative distance above the largest eigenvalue found at which eigenvalues are counted, and the
/// message if there are more.
const ABOVE_LARGEST: f64 = 1e-9;
const LARGER: &str = "the block iteration converged to an eigenvalue that is not the largest one";

/// Largest number of basis functions for which the iteration for the largest eigenvalue also starts
/// from its vector by dense matrices: a third of a second. Among as few very unequal elements there
/// may be more groups of short ones than vectors in the block, which then converges slowly.
const DENSE: usize = 512;

/// Number of steps of inverse iteration for the start vectors.
const INVERSE: usize = 6;

/// Rounding error of xᵀA x, in units of ε Σ a_ii x_i².
const ROUNDING: f64 = 16.0;

/// Share of the tolerance up to which that error is accepted. Where it is larger the form is summed
/// once more as |u|², by positive terms.
const SMALL_SHARE: f64 = 0.1;

/// Largest number of basis functions for which eigenvalues are counted, and the size of an
/// eigenvalue of the matrix scaled to a diagonal of 1, per row, whose sign rounding may decide.
const COUNTED: usize = 128;
const UNDECIDED: f64 = 1e-12;

/// The matrix A in the forms in which it is needed.
pub(crate) struct Forms<'a> {
    pub(crate) operator: &'a GramOperator,
    pub(crate) spectral: &'a Spectral,
    /// the dense matrix
    pub(crate) dense: &'a dyn Fn() -> Result<DMatrix<f64>>,
    /// the conductances of its network between nodes, in the lower half, and to the ground
    pub(crate) network: &'a dyn Fn() -> Result<(DMatrix<f64>, Vec<f64>)>,
    /// xᵀA x as a sum of positive terms
    pub(crate) form: &'a dyn Fn(&[f64]) -> Result<Estimate>,
}

struct Small<'a> {
    matrix: &'a Forms<'a>,
    /// A and M as dense matrices, for counts
    matrices: OnceCell<[DMatrix<f64>; 2]>,
    has_constants: bool,
    mass: Network,
    mass_factor: Tridiagonal,
    tolerance: f64,
}

impl Pencil for Small<'_> {
    fn apply(&self, x: &[f64]) -> Result<Vec<f64>> {
        self.matrix.operator.apply(x)
    }

    fn mass(&self, x: &[f64]) -> Vec<f64> {
        self.mass.times(x)
    }

    fn precondition(&self, r: &[f64]) -> Vec<f64> {
        let mut out = vec![0.0; r.len()];
        self.matrix.spectral.times(r, &mut out);
        out
    }

    fn without_kernel(&self, x: &mut [f64]) -> bool {
        self.matrix.spectral.without_constant(x);
        self.has_constants
    }

    fn mass_inverse(&self, r: &[f64]) -> Vec<f64> {
        self.mass_factor.solve(r)
    }

    fn is_separated(&self) -> bool {
        true
    }

    /// By the signs of the eigenvalues of D (A − σ M) D, D² the inverse of the diagonal of A + σ M.
    fn counted_below(&self, sigma: f64) -> Result<Count> {
        let n = self.matrix.operator.dimension();
        if n > COUNTED {
            return Ok(Count::TooLarge);
        }
        let Some([a, m]) = self.matrices()? else { return Ok(Count::TooLarge) };
        let unit = |i: usize| (a[(i, i)] + sigma * m[(i, i)]).sqrt().recip();
        let scaled = DMatrix::from_fn(n, n, |i, j| {
            (a[(i, j)] * unit(i)) * unit(j) - (sigma * m[(i, j)] * unit(i)) * unit(j)
        });
        let Some((values, _)) = symmetric_eigen(&scaled) else { return Ok(Count::Undecided) };
        if values.iter().any(|value| value.abs() <= UNDECIDED * n as f64) {
            return Ok(Count::Undecided);
        }
        let below = values.iter().filter(|value| **value < 0.0).count();
        Ok(Count::Exact(below.saturating_sub(usize::from(self.has_constants))))
    }

    fn form(&self, x: &[f64], product: f64) -> Result<(f64, f64)> {
        let rounding = self.rounding(x);
        if rounding <= SMALL_SHARE * self.tolerance * product {
            return Ok((product, rounding));
        }
        let summed = (self.matrix.form)(x)?;
        Ok(if summed.error < rounding { (summed.value, summed.error) } else { (product, rounding) })
    }
}

impl Small<'_> {
    /// A and M as dense matrices, made once.
    fn matrices(&self) -> Result<Option<&[DMatrix<f64>; 2]>> {
        if self.matrices.get().is_none() {
            let n = self.matrix.operator.dimension();
            let mut mass = DMatrix::zeros(n, n);
            for j in 0..n {
                let unit: Vec<f64> = (0..n).map(|i| f64::from(i == j)).collect();
                mass.column_mut(j).copy_from_slice(&self.mass.times(&unit));
            }
            let _ = self.matrices.set([(self.matrix.dense)()?, mass]);
        }
        Ok(self.matrices.get())
    }

    /// The smallest eigenvalue by elimination, if all pivots are positive.
    fn by_elimination(&self) -> Result<Option<Smallest>> {
        let (between, ground) = (self.matrix.network)()?;
        let Some(elimination) = Elimination::new(between, ground) else { return Ok(None) };
        let Some(lowest) = lowest(&elimination, &self.mass) else { return Ok(None) };
        let x = lowest.vector;
        let (image, mass) = (self.apply(&x)?, self.mass.times(&x));
        let size = pairwise_dot(&x, &mass);
        let (form, rounding) = self.form(&x, pairwise_dot(&x, &image))?;
        let value = form / size;
        let residual: Vec<f64> = image.iter().zip(&mass).map(|(a, m)| a - value * m).collect();
        let z = elimination.solve_without_mean(&residual, &self.mass.times(&vec![1.0; x.len()]));
        let energy = pairwise_dot(&residual, &z).abs() / size;
        let square = pairwise_dot(&z, &self.mass.times(&z)) / size;
        let mut error = value * square.sqrt();
        if let Some(sigma) = self.above_first(value, lowest.second)? {
            error = error.min(energy + value * square / (1.0 - value / sigma));
        }
        Ok(Some(Smallest { value, error: error + rounding / size, steps: lowest.steps }))
    }

    /// A value above the first eigenvalue and, by a count or by the Ritz value, below the second one.
    fn above_first(&self, first: f64, second: f64) -> Result<Option<f64>> {
        if second <= first {
            return Ok(None);
        }
        let mut is_counted = false;
        for share in SHARES {
            let sigma = first + share * (second - first);
            match self.counted_below(sigma)? {
                Count::Exact(1) => return Ok(Some(sigma)),
                Count::Exact(_) => is_counted = true,
                Count::Undecided | Count::TooLarge => {}
            }
        }
        Ok((!is_counted).then_some(second))
    }

    /// A bound of the rounding error of the product of x with A x.
    fn rounding(&self, x: &[f64]) -> f64 {
        // |x|ᵀ|A||x| ≤ 2 Σ a_ii x_i² for a matrix with rows of sum zero and one positive entry.
        let terms = self.matrix.operator.diagonal().iter().zip(x).map(|(a, x)| a * x * x);
        ROUNDING * f64::EPSILON * terms.sum::<f64>()
    }
}

struct Large<'a> {
    small: Small<'a>,
    shifted: Tridiagonal,
}

impl Pencil for Large<'_> {
    fn apply(&self, x: &[f64]) -> Result<Vec<f64>> {
        Ok(self.small.matrix.operator.apply(x)?.into_iter().map(|y| -y).collect())
    }

    fn mass(&self, x: &[f64]) -> Vec<f64> {
        self.small.mass(x)
    }

    fn precondition(&self, r: &[f64]) -> Vec<f64> {
        self.shifted.solve(r)
    }

    // Constants have the smallest eigenvalue of −A; vectors of the largest ones of A are far from
    // them.
    fn without_kernel(&self, _: &mut [f64]) -> bool {
        false
    }

    fn mass_inverse(&self, r: &[f64]) -> Vec<f64> {
        self.small.mass_inverse(r)
    }

    fn is_separated(&self) -> bool {
        false
    }

    fn counted_below(&self, _: f64) -> Result<Count> {
        Ok(Count::Undecided)
    }

    fn form(&self, x: &[f64], product: f64) -> Result<(f64, f64)> {
        Ok((product, self.small.rounding(x)))
    }
}

/// The smallest positive and the largest eigenvalue.
pub(crate) fn extreme_eigenvalues(
    matrix: &Forms,
    mesh: &Mesh,
    basis: Basis,
    tolerance: Tolerance,
) -> Result<[Estimate; 2]> {
    let Forms { operator, spectral, .. } = *matrix;
    let count = basis.count(mesh);
    let mass = Network::new(mesh, basis, 0.0, 1.0);
    let small = Small {
        matrix,
        matrices: OnceCell::new(),
        has_constants: basis != Basis::InnerHats,
        mass_factor: mass.factor(),
        mass,
        tolerance: tolerance.relative(),
    };
    let waves = (1..=BLOCK.min(count)).map(|k| wave(mesh, basis, k));
    let start = waves
        .map(|mut x| {
            spectral.without_constant(&mut x);
            x
        })
        .collect();
    let can_eliminate = count <= ELIMINATED;
    let steps = if can_eliminate { FIRST } else { STEPS };
    let mut low = found(smallest(&small, start, tolerance.relative(), steps)?, tolerance);
    if can_eliminate && low.is_err() {
        let other = found(small.by_elimination()?, tolerance);
        low = match (low, other) {
            (Err(first), Err(second)) => Err(nearer(first, second)),
            (_, other) => other,
        };
    }
    let low = low?;

    let kappa = largest_of_tridiagonal(mesh, basis) * (1.0 + ABOVE);
    let shifted = Network::new(mesh, basis, -1.0, kappa).factor();
    // The form feels an end of the interval as a smaller stiffness: vectors that vanish there are
    // nearer.
    let inner = if basis == Basis::Hats { Basis::InnerHats } else { basis };
    let mut start = short_waves(mesh, inner);
    if basis == Basis::Hats {
        start.iter_mut().for_each(|x| {
            x.insert(0, 0.0);
            x.push(0.0);
        });
    }
    let mass_of = |i: usize| {
        let mut unit = small.mass.ground[i];
        unit += small.mass.between.get(i).copied().unwrap_or(0.0);
        unit + if i > 0 { small.mass.between[i - 1] } else { 0.0 }
    };
    let mut ranked: Vec<(f64, usize)> =
        operator.diagonal().iter().enumerate().map(|(i, a)| (a / mass_of(i), i)).collect();
    ranked.sort_by(|a, b| b.0.total_cmp(&a.0));
    let mut peaks: Vec<usize> = Vec::new();
    for (_, i) in ranked {
        if peaks.len() == BLOCK {
            break;
        }
        if peaks.iter().all(|p| p.abs_diff(i) > 2) {
            peaks.push(i);
        }
    }
    let quotient = |x: &[f64]| -> Result<f64> {
        Ok(pairwise_dot(x, &small.apply(x)?) / pairwise_dot(x, &small.mass(x)))
    };
    for peak in peaks {
        let mut unit = vec![0.0; count];
        unit[peak] = 1.0;
        let mut x = unit.clone();
        for offset in [-1, 1] {
            if let Some(x) = peak.checked_add_signed(offset).and_then(|i| x.get_mut(i)) {
                *x = -0.5;
            }
        }
        // On equal elements the sign alternates; beside a much longer element that one would
        // outweigh the peak.
        start.push(if quotient(&x)? >= quotient(&unit)? { x } else { unit });
    }
    if count <= DENSE
        && let Some([a, m]) = small.matrices()?
        && let Ok((_, x)) = Factored::new(m).and_then(|mass| mass.largest_eigenvalue(a))
    {
        start.insert(0, x);
    }
    let mut windows: Vec<(f64, Vec<f64>)> = Vec::new();
    for first in [0, WINDOW / 2] {
        for x in vectors_of_windows(&small, count, first)? {
            windows.push((quotient(&x)?, x));
        }
    }
    windows.sort_by(|a, b| b.0.total_cmp(&a.0));
    start.extend(windows.into_iter().take(TAKEN).map(|(_, x)| x));
    let large = Large { small, shifted };
    let high = found(smallest(&large, start, tolerance.relative(), STEPS)?, tolerance)?;
    let above = high.value * (1.0 + ABOVE_LARGEST) + high.error;
    let positive = count - usize::from(large.small.has_constants);
    match large.small.counted_below(above)? {
        Count::Exact(below) if below < positive => {
            Err(Error::out_of_reach("eigenvalue", tolerance.relative(), f64::INFINITY, LARGER))
        }
        _ => Ok([low, high]),
    }
}

/// The vectors of the largest Ritz values of windows, zero outside; the first window ends at
/// `first` if it is not 0.
fn vectors_of_windows(small: &Small, count: usize, first: usize) -> Result<Vec<Vec<f64>>> {
    let ends = (0..).map(|k| first + k * WINDOW).take_while(|&end| end < count);
    let edges: Vec<usize> =
        [0].into_iter().chain(ends.filter(|&end| end > 0)).chain([count]).collect();
    let windows: Vec<Range<usize>> = edges.windows(2).map(|pair| pair[0]..pair[1]).collect();
    // Basis, its products with A and M; orthonormal with respect to M in each window.
    let dot = |window: &Range<usize>, a: &[f64], b: &[f64]| {
        pairwise_dot(&a[window.clone()], &b[window.clone()])
    };
    let [mut basis, mut images, mut masses]: [Vec<Vec<f64>>; 3] = Default::default();
    let mut x: Vec<f64> = (0..count)
        .map(|i| if i % 2 == 0 { 1.0 } else { -1.0 } * (1.0 + 0.3 * (1.7 * i as f64).cos()))
        .collect();
    for _ in 0..KRYLOV {
        // No element belongs to two windows.
        windows.iter().for_each(|window| x[window.end - 1] = 0.0);
        for window in &windows {
            let before = dot(window, &x, &x);
            // Twice, since one pass leaves what rounding left of nearly dependent directions.
            for (v, m) in basis.iter().zip(&masses).chain(basis.iter().zip(&masses)) {
                let share = dot(window, m, &x);
                window.clone().for_each(|i| x[i] -= share * v[i]);
            }
            if dot(window, &x, &x) <= NEW * NEW * before {
                window.clone().for_each(|i| x[i] = 0.0); // the space of this window is exhausted
            }
        }
        let mut m = small.mass(&x);
        for window in &windows {
            let size = dot(window, &x, &m).sqrt();
            let factor = if size > 0.0 { size.recip() } else { 0.0 };
            window.clone().for_each(|i| (x[i], m[i]) = (factor * x[i], factor * m[i]));
        }
        let image = small.apply(&x)?;
        let next = small.mass_inverse(&image);
        basis.push(std::mem::replace(&mut x, next));
        images.push(image);
        masses.push(m);
    }
    let ritz = |window: &Range<usize>| {
        let form = DMatrix::from_fn(KRYLOV, KRYLOV, |i, j| dot(window, &basis[i], &images[j]));
        symmetric_eigen(&(0.5 * (&form + form.transpose())))
    };
    let value = |window: &Range<usize>| ritz(window)?.0.last().copied();
    let vector = |window: &Range<usize>| {
        let (_, vectors) = ritz(window)?;
        let mut x = vec![0.0; count];
        for (k, v) in basis.iter().enumerate() {
            window.clone().for_each(|i| x[i] += vectors[(k, KRYLOV - 1)] * v[i]);
        }
        Some(x)
    };
    let mut values: Vec<(f64, &Range<usize>)> = windows
        .iter()
        .filter_map(|window| Some((value(window)?, window)))
        .filter(|(value, _)| *value > 0.0)
        .collect();
    values.sort_by(|a, b| b.0.total_cmp(&a.0));
    Ok(values.into_iter().take(TAKEN).filter_map(|(_, window)| vector(window)).collect())
}

/// Vectors close to those of the largest eigenvalues of (K, M), by inverse iteration.
fn short_waves(mesh: &Mesh, basis: Basis) -> Vec<Vec<f64>> {
    let kappa = largest_of_tridiagonal(mesh, basis) * (1.0 + 1e-9);
    let (shifted, mass) =
        (Network::new(mesh, basis, -1.0, kappa).factor(), Network::new(mesh, basis, 0.0, 1.0));
    let next = |k: usize| {
        // Alternating, weighted by waves: none is orthogonal to short ones.
        let mut x = wave(mesh, basis, k);
        x.iter_mut().enumerate().for_each(|(i, x)| *x = if i % 2 == 0 { *x } else { -*x });
        for _ in 0..INVERSE {
            x = shifted.solve(&mass.times(&x));
            let size = x.iter().fold(0.0f64, |m, x| m.max(x.abs()));
            x.iter_mut().for_each(|x| *x /= size);
        }
        x
    };
    (1..=BLOCK.min(basis.count(mesh))).map(next).collect()
}

/// A cosine or sine with k half waves over the mesh.
fn wave(mesh: &Mesh, basis: Basis, k: usize) -> Vec<f64> {
    let phase = |x: f64| std::f64::consts::PI * k as f64 * x / mesh.total();
    match basis {
        Basis::Hats => mesh.from_left().iter().map(|&x| phase(x).cos()).collect(),
        Basis::InnerHats => {
            mesh.from_left()[1..mesh.len()].iter().map(|&x| phase(x).sin()).collect()
        }
        Basis::Indicators => {
            mesh.from_left().windows(2).map(|x| phase(0.5 * (x[0] + x[1])).cos()).collect()
        }
    }
}

/// The largest eigenvalue of (K, M) by bisection on the signs of the pivots of κM − K; relative
/// error 1e-9.
fn largest_of_tridiagonal(mesh: &Mesh, basis: Basis) -> f64 {
    let shortest = mesh.lengths().iter().copied().fold(f64::INFINITY, f64::min);
    let mut high = 12.0 / shortest / shortest * (1.0 + 1e-9);
    let mut low = 1e-3 * high;
    while high - low > 1e-9 * high {
        let middle = 0.5 * (low + high);
        let above = Network::new(mesh, basis, -1.0, middle).pivots().iter().all(|&d| d > 0.0);
        *(if above { &mut high } else { &mut low }) = middle;
    }
    high
}

fn found(result: Option<Smallest>, tolerance: Tolerance) -> Result<Estimate> {
    let failed = Error::Solver { reason: "the block eigenvalue iteration broke down".to_owned() };
    let found = result.ok_or(failed)?;
    let work = Work { iterations: found.steps as u64, ..Work::default() };
    let value = found.value.abs();
    let estimate = Estimate::new(value, found.error + tolerance.relative() * value, work)?;
    if found.error <= tolerance.relative() * value {
        return Ok(estimate);
    }
    Err(Error::not_met(
        "eigenvalue",
        tolerance.relative(),
        estimate,
        "the block iteration did not converge within the maximum number of steps",
    ))
}

/// The refusal with the smaller error.
fn nearer(first: Error, second: Error) -> Error {
    let error = |of: &Error| of.best().map_or(f64::INFINITY, |best| best.error);
    if error(&second) < error(&first) { second } else { first }
}
