//! Dense Gram matrices of |·|_ν and of L² for piecewise constants (ν < 1/2) and continuous piecewise linear
//! functions.

use crate::error::{Error, Result};
use crate::kernel::cells::CellPairs;
use crate::mesh::Mesh;
use crate::numeric::parallel;
use crate::numeric::sum::RunningSum;
use crate::order::Order;
use nalgebra::DMatrix;

/// The N × N Gram matrix of |·|_ν for the indicator functions of the elements.
///
/// # Errors
/// [`Error::InfiniteNorm`] for ν ≥ 1/2: indicator functions are not in H^ν.
pub(crate) fn gram_constants(partition: &Mesh, order: Order) -> Result<DMatrix<f64>> {
    require_constants_finite(order)?;
    let cells = CellPairs::new(order);
    let n = partition.len();
    let rows: Vec<Vec<f64>> = parallel::map(n, &|i| {
        let mut row = vec![diagonal_constant(partition, &cells, i)];
        let mut gap = RunningSum::default();
        for j in i + 1..n {
            row.push(-2.0 * constants_on(partition, &cells, i, j, gap.value()));
            gap.add(partition.lengths()[j]);
        }
        row
    });
    Ok(symmetric(&rows))
}

/// The contribution of the exterior to the form of functions that vanish outside the interval, 2 ∫ u v ∫_{ext}
/// |x−y|^{-1-2ν}, for the hat functions of the inner nodes: its diagonal and its off-diagonal.
pub(crate) fn exterior_linears(partition: &Mesh, order: Order) -> (Vec<f64>, Vec<f64>) {
    let cells = CellPairs::new(order);
    let n = partition.len();
    // [left node squared, both, right node squared] of every element
    let shares: Vec<[f64; 3]> = parallel::map(n, &|e| {
        let h = partition.lengths()[e];
        let left = cells.against_exterior(h, partition.from_left()[e]);
        let right = cells.against_exterior(h, partition.from_right()[e + 1]);
        [left[0] + right[2], left[1] + right[1], left[2] + right[0]]
    });
    let diagonal = shares.windows(2).map(|pair| 2.0 * (pair[0][2] + pair[1][0])).collect();
    let inner = shares.get(1..n - 1).unwrap_or_default();
    (diagonal, inner.iter().map(|share| 2.0 * share[1]).collect())
}

/// The Gram matrix on the whole line for the hat functions of the inner nodes, and its row sums without
/// cancellation: the conductances to the ground of its network.
pub(crate) fn gram_zero_outside(partition: &Mesh, order: Order) -> (DMatrix<f64>, Vec<f64>) {
    let n = partition.len();
    let all = gram_linears(partition, order);
    let mut matrix = all.view((1, 1), (n - 1, n - 1)).into_owned();
    // Rows of the matrix of all nodes have sum zero.
    let mut sums: Vec<f64> = (1..n).map(|i| -all[(i, 0)] - all[(i, n)]).collect();
    let (diagonal, beside) = exterior_linears(partition, order);
    for (i, d) in diagonal.iter().enumerate() {
        matrix[(i, i)] += d;
        sums[i] += d;
    }
    for (i, b) in beside.iter().enumerate() {
        matrix[(i, i + 1)] += b;
        matrix[(i + 1, i)] += b;
        sums[i] += b;
        sums[i + 1] += b;
    }
    (matrix, sums)
}

/// The Gram matrix of |·|_ν for the hat functions of all N + 1 nodes.
///
/// # Method
///
/// The form is a(u, v) = ∫∫ (u(x)−u(y)) (v(x)−v(y)) / |x−y|^{1+2ν} dx dy over the square of the interval, (1.1)
/// of the paper: both orders of x and y are counted. Every entry is a sum of a few integrals of one sign, in
/// closed form or by rules exact to rounding (`kernel::cells`); only the entries of neighbouring hat functions
/// mix signs, by a bounded factor: their relative error reaches 3e-14 on very unequal elements. The diagonal is not adjusted to make the row sums zero, so that the row sums
/// are a check. Cost: O(N²); the entries of separate hat functions take about 16 kernel values.
pub(crate) fn gram_linears(partition: &Mesh, order: Order) -> DMatrix<f64> {
    let cells = CellPairs::new(order);
    let n = partition.len();
    let far: Vec<FarRow> = parallel::map(n, &|e| FarRow::new(partition, &cells, e));
    let mut rows: Vec<Vec<f64>> = (0..=n).map(|i| vec![0.0; n + 1 - i]).collect();
    for (e, far_row) in far.iter().enumerate() {
        // Cell e touches the nodes e (its far hat) and e + 1 (its near hat).
        for (offset, values) in far_row.values.iter().enumerate() {
            let node = e + 2 + offset;
            rows[e][node - e] += values[1];
            rows[e + 1][node - e - 1] += values[0];
        }
    }
    for i in 0..=n {
        rows[i][0] = diagonal_linear(partition, &cells, i);
        if i < n {
            rows[i][1] += neighbours_linear(partition, &cells, i);
        }
    }
    symmetric(&rows)
}

/// The Gram matrix of L² for hat functions: (diagonal, off-diagonal) of a tridiagonal matrix.
pub(crate) fn mass_linears(partition: &Mesh) -> (Vec<f64>, Vec<f64>) {
    let lengths = partition.lengths();
    let mut diagonal = vec![0.0; lengths.len() + 1];
    for (i, &h) in lengths.iter().enumerate() {
        diagonal[i] += h / 3.0;
        diagonal[i + 1] += h / 3.0;
    }
    (diagonal, lengths.iter().map(|h| h / 6.0).collect())
}

/// The same as a dense matrix.
pub(crate) fn mass_form(partition: &Mesh) -> DMatrix<f64> {
    let (diagonal, beside) = mass_linears(partition);
    tridiagonal(&diagonal, &beside)
}

/// The symmetric tridiagonal matrix with this diagonal and off-diagonal.
pub(crate) fn tridiagonal(diagonal: &[f64], beside: &[f64]) -> DMatrix<f64> {
    DMatrix::from_fn(diagonal.len(), diagonal.len(), |i, j| match i.abs_diff(j) {
        0 => diagonal[i],
        1 => beside[i.min(j)],
        _ => 0.0,
    })
}

/// Adds m M x to y, M the matrix of L² given by [`mass_linears`].
pub(crate) fn add_mass(
    m: f64,
    (diagonal, beside): &(Vec<f64>, Vec<f64>),
    x: &[f64],
    y: &mut [f64],
) {
    for i in 0..x.len() {
        y[i] += m * diagonal[i] * x[i];
        if i + 1 < x.len() {
            y[i] += m * beside[i] * x[i + 1];
            y[i + 1] += m * beside[i] * x[i];
        }
    }
}

pub(crate) fn require_constants_finite(order: Order) -> Result<()> {
    if order.is_below_half() {
        return Ok(());
    }
    Err(Error::InfiniteNorm {
        order: order.value(),
        why: "a function with a jump is not in H^nu for nu >= 1/2",
    })
}

/// ∫\_{cell i} ∫\_{cell j} |x−y|^{-1-2ν} for i < j, where the lengths between the cells add up to `gap`.
pub(crate) fn constants_on(
    partition: &Mesh,
    cells: &CellPairs,
    i: usize,
    j: usize,
    gap: f64,
) -> f64 {
    let (p, q) = (partition.lengths()[i], partition.lengths()[j]);
    if j == i + 1 { cells.touching_constants(p, q) } else { cells.separate_constants(p, q, gap) }
}

/// 2 ∫\_{cell} ∫\_{outside} |x−y|^{-1-2ν}.
pub(crate) fn diagonal_constant(partition: &Mesh, cells: &CellPairs, i: usize) -> f64 {
    let h = partition.lengths()[i];
    let outside = [partition.from_left()[i], partition.from_right()[i + 1]];
    let touching = |x: f64| if x > 0.0 { cells.touching_constants(h, x) } else { 0.0 };
    2.0 * (touching(outside[0]) + touching(outside[1]))
}

/// The contributions of cell e to the entries of its two hat functions with the hat functions of the nodes e +
/// 2, e + 3, ...
pub(crate) struct FarRow {
    /// `values[k]`: contributions of (node e + 1, node e) with node e + 2 + k
    pub(crate) values: Vec<[f64; 2]>,
}

impl FarRow {
    pub(crate) fn new(partition: &Mesh, cells: &CellPairs, e: usize) -> Self {
        let lengths = partition.lengths();
        let n = lengths.len();
        let mut values = vec![[0.0; 2]; n.saturating_sub(e + 1)];
        if e + 1 < n {
            // Only the hats that vanish at the common node are apart.
            values[0][1] -= 2.0 * cells.touching(lengths[e], lengths[e + 1]).product;
        }
        let mut gap = RunningSum::default();
        for f in e + 2..n {
            gap.add(lengths[f - 1]);
            let [near, far] = cells.separate(lengths[e], lengths[f], gap.value());
            let k = f - e - 2;
            for b in 0..2 {
                values[k + b][0] -= 2.0 * near[b];
                values[k + b][1] -= 2.0 * far[b];
            }
        }
        Self { values }
    }
}

/// The diagonal entry a(φ_i, φ_i).
pub(crate) fn diagonal_linear(partition: &Mesh, cells: &CellPairs, i: usize) -> f64 {
    let lengths = partition.lengths();
    let left = (i > 0).then(|| lengths[i - 1]);
    let right = lengths.get(i).copied();
    let mut sum = left.map_or(0.0, |h| cells.own(h)) + right.map_or(0.0, |h| cells.own(h));
    if let (Some(p), Some(q)) = (left, right) {
        sum += 2.0 * cells.touching(p, q).difference_squared;
    }
    let beyond = [
        (left, if i > 0 { partition.from_left()[i - 1] } else { 0.0 }, right),
        (right, partition.from_right().get(i + 1).copied().unwrap_or(0.0), left),
    ];
    for (cell, rest, other) in beyond {
        let Some(p) = cell else { continue };
        if rest > 0.0 {
            // On its own side the hat vanishes where the rest begins ...
            sum += 2.0 * cells.touching_square_constant(p, rest);
            // ... and the other cell of the hat lies between its peak and that rest.
            if let Some(q) = other {
                sum += 2.0 * cells.weighted_against_constant(q, rest, p)[0];
            }
        }
    }
    sum
}

/// The entry a(φ_i, φ_{i+1}) without the pair of cells i − 1, i + 1, which is counted with the separate cells.
pub(crate) fn neighbours_linear(partition: &Mesh, cells: &CellPairs, i: usize) -> f64 {
    let lengths = partition.lengths();
    let h = lengths[i];
    let mut sum = -cells.own(h);
    // Left of the shared cell: the cell of φ_i alone, then the rest, where both hats vanish. Right: mirrored.
    let left = (i > 0).then(|| (lengths[i - 1], partition.from_left()[i - 1]));
    let right = lengths.get(i + 1).map(|&q| (q, partition.from_right()[i + 2]));
    for (q, rest) in [left, right].into_iter().flatten() {
        sum += 2.0 * cells.touching(q, h).first;
        if rest > 0.0 {
            sum += 2.0 * cells.weighted_against_constant(h, rest, q)[1];
        }
    }
    sum
}

/// The symmetric matrix whose row i starts at its diagonal.
fn symmetric(rows: &[Vec<f64>]) -> DMatrix<f64> {
    DMatrix::from_fn(rows.len(), rows.len(), |i, j| {
        let (low, high) = (i.min(j), i.max(j));
        rows[low][high - low]
    })
}
