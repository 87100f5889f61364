//! The consistency term on one segment over all contact sets: a bound independent of the contact set.
//!
//! T = (0, 1) after scaling, ν = τ − 3/2, E = {u_N = 0}, N its complement; σ_N = 0 on N, u_N' = 0 almost everywhere
//! on E. The seminorm alone controls functions that vanish on a set: restricting the double integral to pairs with
//! one point in the set, and using |x − y| ≤ 1,
//!
//! 2|N| ‖σ_N‖² ≤ |σ_N|²_ν,  2|E| ‖u_N'‖² ≤ |u_N'|²_ν.
//!
//! Hence ‖σ_N‖_{L¹} ≤ (|E|/2|N|)^{1/2} |σ_N|_ν and, as u_N vanishes somewhere,
//! max|u_N| ≤ ‖u_N'‖_{L¹} ≤ (|N|/2|E|)^{1/2} |u_N'|_ν. In the product the measures cancel:
//!
//! ∫_T σ_N (I^h u)_N ≤ ½ h_e^{2τ−2} |σ_N|_{τ−3/2,T} |u_N'|_{τ−3/2,T},
//!
//! and the same bound holds for ∫_T (σ_N − π^h σ_N)(π^h u_N − u_N) ≤ ‖σ_N‖_{L¹} max|u_N|, for every E and
//! 3/2 < τ ≤ 2: the optimal rate without distinction of cases, without θ and without a logarithm. (The use of both
//! measures is due to Drouet and Hild, SIAM J. Numer. Anal. 53 (2015) 1488-1507.) The paper bounds each factor
//! separately, with a factor θ^{τ−2} for the first.
//!
//! Is ½ sharp? For the nodal cone I^h u is nonzero only because of non-contact intervals at the ends of T; closing
//! the others enlarges the space of σ_N and, as u_N ≤ 0, does not increase the norm of u_N': the worst set is the
//! complement of (0, a) and (1 − b, 1). For given a, b the best σ_N and u_N are obtained from two linear systems with
//! Gram matrices of piecewise constants on meshes graded to all ends; the value is a lower bound of the supremum, too
//! small by a few per cent because of the mesh. For one non-contact interval `one_gap_ratio` is accurate to
//! rounding, and `consistency_constant` is the maximum. Cost: O(cells³) per set.

use fractional_sobolev::{Gram, Mesh, Order};
use nalgebra::{Cholesky, DMatrix, Matrix2, SMatrix};
use signorini::cone::Cone;

/// Number of layers of cells of each part of the segment on the coarsest mesh: 2 (layers + 1) cells with ratio 1/4;
/// the smallest has 4⁻⁹ of the length of its part.
const LAYERS: usize = 9;
const RATIO: f64 = 0.25;
/// Largest number of bisections of every cell: 320 cells in each part.
const HALVINGS: u32 = 4;

/// The supremum of the consistency term divided by |σ_N|_ν |u_N'|_ν, ν = τ − 3/2, on (0, 1) with non-contact
/// intervals (0, left) and (1 − right, 1) and contact between them; `left` may be 0. It is at most ½.
///
/// The value is that of conforming trial functions, a lower bound of the supremum; the error estimate is the change
/// at the last bisection, which bounds the remaining error if the values converge at least linearly in the cell
/// length (order 2 − 2ν > 1). For one non-contact interval of length b the nodal ratio for b equals the midpoint
/// ratio for 1 − b.
///
/// Returns the value and its error; panics if the largest number of bisections does not give the relative error asked for.
pub fn worst_ratio(cone: Cone, tau: f64, left: f64, right: f64, asked: f64) -> (f64, f64) {
    let order = Order::new(tau - 1.5).unwrap();
    let mut before = lower_bound(cone, order, left, right, 0);
    for halvings in 1..=HALVINGS {
        let value = lower_bound(cone, order, left, right, halvings);
        let change = (value - before).abs();
        if change <= asked * value {
            return (value, change);
        }
        before = value;
    }
    panic!("{cone} {tau} {left} {right}: {asked} is not met");
}

/// The ratio for the best piecewise constants on a graded mesh, with every cell bisected this many times.
fn lower_bound(cone: Cone, order: Order, left: f64, right: f64, halvings: u32) -> f64 {
    let points: Vec<f64> =
        [0.0, left, 1.0 - right, 1.0].into_iter().skip(usize::from(left == 0.0)).collect();
    let partition = halved(&Mesh::graded(&points, LAYERS, RATIO).unwrap(), halvings);
    let per_part = partition.len() / (points.len() - 1);
    let gram = Gram::constants(&partition, order, 1e-8).unwrap().to_dense().unwrap();
    let first = if left > 0.0 { per_part } else { 0 };
    let contact: Vec<usize> = (first..first + per_part).collect();
    let open: Vec<usize> = (0..first).chain(first + per_part..partition.len()).collect();
    let length = |k: usize| partition.lengths()[k];
    let middle = |k: usize| partition.from_left()[k] + 0.5 * length(k);
    let is_left = |k: usize| k < first;
    match cone {
        Cone::Nodal => {
            // σ against 1 − x and x; u(0) = −∫ over the left gap, u(1) = ∫ over the right one: a singular
            // value of 2 × 2 matrices.
            let weights = [
                contact.iter().map(|&k| length(k) * (1.0 - middle(k))).collect::<Vec<_>>(),
                contact.iter().map(|&k| length(k) * middle(k)).collect(),
            ];
            let ends = [true, false].map(|side| {
                open.iter()
                    .map(|&k| if is_left(k) == side { length(k) } else { 0.0 })
                    .collect::<Vec<_>>()
            });
            let s = inverse_form(&gram, &contact, &weights);
            let m = inverse_form(&gram, &open, &ends);
            // Signs: both displacements are negative, so the mixed term of the slopes changes its sign.
            let product = Matrix2::new(m[(0, 0)], -m[(0, 1)], -m[(1, 0)], m[(1, 1)]) * s;
            let (trace, determinant) = (product.trace(), product.determinant());
            (0.5 * trace + (0.25 * trace * trace - determinant).max(0.0).sqrt()).sqrt()
        }
        Cone::Midpoint => {
            let total: Vec<f64> = contact.iter().map(|&k| length(k)).collect();
            let area: Vec<f64> = open
                .iter()
                .map(|&k| length(k) * if is_left(k) { -middle(k) } else { 1.0 - middle(k) })
                .collect();
            let s = inverse_form(&gram, &contact, &[total])[(0, 0)];
            let m = inverse_form(&gram, &open, &[area])[(0, 0)];
            (s * m).sqrt()
        }
    }
}

/// The mesh with every cell divided into 2^halvings equal cells.
fn halved(partition: &Mesh, halvings: u32) -> Mesh {
    let parts = 1usize << halvings;
    let cut = |&length: &f64| std::iter::repeat_n(length / parts as f64, parts);
    Mesh::from_lengths(&partition.lengths().iter().flat_map(cut).collect::<Vec<_>>()).unwrap()
}

/// b_i' G⁻¹ b_j, G the rows and columns `cells` of the Gram matrix.
fn inverse_form<const N: usize>(
    gram: &DMatrix<f64>,
    cells: &[usize],
    b: &[Vec<f64>; N],
) -> SMatrix<f64, N, N> {
    // Scaled to a unit diagonal: lengths range over many decades.
    let scale: Vec<f64> = cells.iter().map(|&k| gram[(k, k)].sqrt()).collect();
    let matrix = DMatrix::from_fn(cells.len(), cells.len(), |i, j| {
        gram[(cells[i], cells[j])] / (scale[i] * scale[j])
    });
    let factor = Cholesky::new(matrix).unwrap();
    let right = DMatrix::from_fn(cells.len(), N, |i, j| b[j][i] / scale[i]);
    let solution = factor.solve(&right);
    let form = |i: usize, j: usize| {
        (0..cells.len()).map(|k| right[(k, i)] * solution[(k, j)]).sum::<f64>()
    };
    SMatrix::from_fn(form)
}

#[test]
fn no_contact_set_passes_one_half() {
    for cone in [Cone::Nodal, Cone::Midpoint] {
        for tau in [1.51, 1.75, 1.99] {
            for right in [1e-6, 0.1, 0.5, 0.9] {
                for left in [0.0, 1e-6, 0.05] {
                    // Near τ = 2 constants leave the space and no tolerance is met: the bound holds on any mesh.
                    let order = Order::new(tau - 1.5).unwrap();
                    let ratio = lower_bound(cone, order, left, right, 0);
                    assert!(ratio > 0.0 && ratio <= 0.5, "{cone} {tau} {left} {right}: {ratio}");
                }
            }
        }
    }
}

#[test]
fn the_ratio_is_invariant_under_reflection() {
    let [left, right] =
        [(0.1, 0.3), (0.3, 0.1)].map(|(a, b)| worst_ratio(Cone::Nodal, 1.75, a, b, 0.1).0);
    assert!((left / right - 1.0).abs() < 1e-10, "{left} {right}");
}

#[test]
fn one_gap_and_its_complement_exchange_the_cones() {
    for gap in [0.1, 0.35, 0.7] {
        let (nodal, error) = worst_ratio(Cone::Nodal, 1.75, 0.0, gap, 0.02);
        let (midpoint, other) = worst_ratio(Cone::Midpoint, 1.75, 0.0, 1.0 - gap, 0.02);
        assert!((nodal - midpoint).abs() <= error + other, "gap {gap}: {nodal} {midpoint}");
    }
}

#[test]
fn a_finer_mesh_raises_the_lower_bound_within_the_error() {
    let (coarse, error) = worst_ratio(Cone::Nodal, 1.75, 0.0, 0.3, 0.1);
    let (fine, _) = worst_ratio(Cone::Nodal, 1.75, 0.0, 0.3, 0.01);
    assert!(fine >= coarse && fine <= coarse + error, "{coarse} {fine}");
}
