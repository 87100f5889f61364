//! Elimination of all but a few kept unknowns: a multifrontal Cholesky factorization on a dissection tree.
//!
//! With interior unknowns i (neither prescribed nor kept) and kept unknowns k,
//!
//! K = [[K_ii, K_ik], [K_ki, K_kk]],   S = K_kk − K_ki K_ii⁻¹ K_ik,   b = F_k − K_ki K_ii⁻¹ F_i.
//!
//! The kept unknowns are ordered last, so S is K_kk plus the update matrix that reaches the root: for the
//! normal displacements of the contact edge it is the discrete Steklov-Poincaré operator. The contact
//! iteration requires only S and b; the factorization is computed once. Every node of the tree is a dense
//! front (faer: Cholesky, triangular solve, symmetric product); independent subtrees are processed in
//! parallel (I. S. Duff and J. K. Reid, ACM TOMS 9 (1983)). Cost for N nodes of a quasi-uniform mesh:
//! O(N^{3/2}) operations, O(N log N) memory.

use super::dissection::{Tree, dissect};
use super::front::{Front, Ordering, Update};
use super::matrix::BlockMatrix;
use super::pool::Pool;
use crate::error::Result;
use crate::mesh::Point;
use crate::numeric::check::require_length;
use crate::numeric::check::require_memory;
use faer::Mat;

/// Smallest number of nodes of a subtree that is a separate task.
const TASK: usize = 2000;

/// Largest set of nodes of a mesh that is eliminated at once.
const LEAF: usize = 40;

/// Bytes per unknown and level of nested dissection.
const BYTES_PER_DEPTH: usize = 100;

/// Position of an unknown that is prescribed.
const PRESCRIBED: u32 = u32::MAX;

/// The factorization of K_ii and the Schur complement S = K_kk − K_ki K_ii⁻¹ K_ik, i the eliminated unknowns and
/// k the kept ones.
#[derive(Debug)]
pub(crate) struct Condensation {
    /// Position in the elimination order of every unknown.
    positions: Vec<u32>,
    /// The unknown at every position.
    unknowns: Vec<u32>,
    fronts: Vec<Front>,
    interior: usize,
    schur: Mat<f64>,
}

/// A right-hand side after forward elimination.
#[derive(Debug, Clone)]
pub(crate) struct Reduced {
    values: Vec<f64>,
    interior: usize,
}

impl Reduced {
    /// The condensed load b = F_k − K_ki K_ii⁻¹ F_i, in the order of the kept unknowns.
    pub(crate) fn kept(&self) -> &[f64] {
        &self.values[self.interior..]
    }
}

impl Condensation {
    /// The condensation to the unknowns in `kept`: all others that are not `prescribed` are eliminated; `points` are
    /// the node coordinates. Kept unknowns are never eliminated, prescribed or not.
    ///
    /// For the Laplacian on a square with Dirichlet conditions at the top, S is symmetric positive definite, and its
    /// row sums are the reactions to a unit displacement of the contact edge; the example computes their sum.
    ///
    /// # Errors
    /// [`ToolkitError::NotPositiveDefinite`](crate::ToolkitError::NotPositiveDefinite) with the unknown
    /// whose pivot vanished: some part of the body has no Dirichlet boundary.
    /// [`ToolkitError::LengthMismatch`](crate::ToolkitError::LengthMismatch) if the lengths of the arrays differ;
    /// [`ToolkitError::TooLarge`](crate::ToolkitError::TooLarge) if there is not enough memory for the fronts.
    pub(crate) fn new(
        matrix: &BlockMatrix,
        points: &[Point],
        prescribed: &[bool],
        kept: &[usize],
    ) -> Result<Self> {
        Self::with_leaves(LEAF, matrix, points, prescribed, kept)
    }

    /// The same with sets of at most `leaf` nodes that are eliminated at once, as dense matrices: small ones save memory
    /// where nodes have few neighbours.
    ///
    /// # Errors
    /// As for [`Condensation::new`].
    pub(crate) fn with_leaves(
        leaf: usize,
        matrix: &BlockMatrix,
        points: &[Point],
        prescribed: &[bool],
        kept: &[usize],
    ) -> Result<Self> {
        require_length("points", points.len(), matrix.nodes())?;
        require_length("prescribed", prescribed.len(), matrix.unknowns())?;
        // 4.4 GB at two million unknowns of a plane mesh.
        let depth = matrix.unknowns().max(2).ilog2() as usize;
        require_memory("unknowns to be eliminated", matrix.unknowns(), BYTES_PER_DEPTH * depth)?;
        let c = matrix.components();
        let mut is_kept = vec![false; matrix.unknowns()];
        kept.iter().for_each(|&unknown| is_kept[unknown] = true);
        let interior_at = |node: usize| {
            (node * c..(node + 1) * c).filter(|&unknown| !prescribed[unknown] && !is_kept[unknown])
        };
        // Interior unknowns adjacent to kept ones are eliminated after the tree.
        let has_kept = |node: usize| (node * c..(node + 1) * c).any(|unknown| is_kept[unknown]);
        let (late, early): (Vec<u32>, Vec<u32>) = (0..matrix.nodes() as u32)
            .filter(|&node| interior_at(node as usize).next().is_some())
            .partition(|&node| has_kept(node as usize));
        let tree = dissect(matrix, points, early, leaf);
        let mut unknowns = Vec::with_capacity(matrix.unknowns());
        let mut number = |nodes: &[u32]| {
            let first = unknowns.len();
            unknowns.extend(
                nodes.iter().flat_map(|&node| interior_at(node as usize)).map(|u| u as u32),
            );
            first..unknowns.len()
        };
        let tree = NumberedTree::new(tree, &mut number);
        let last = number(&late);
        let interior = last.end;
        unknowns.extend(kept.iter().map(|&unknown| unknown as u32));
        let mut positions = vec![PRESCRIBED; matrix.unknowns()];
        for (position, &unknown) in unknowns.iter().enumerate() {
            positions[unknown as usize] = position as u32;
        }
        let ordering =
            Ordering { matrix, positions: &positions, unknowns: &unknowns, pool: Pool::default() };
        let (mut fronts, update) = tree.eliminate(&ordering)?;
        let rows: Vec<u32> = (interior as u32..unknowns.len() as u32).collect();
        let (front, root) = Front::eliminate(&ordering, last, Some(rows), vec![update])?;
        fronts.push(front);
        let schur = whole_schur(&ordering, root, interior);
        Ok(Self { positions, unknowns, fronts, interior, schur })
    }

    /// The Schur complement S, symmetric, in the order of the kept unknowns.
    pub(crate) fn schur(&self) -> &Mat<f64> {
        &self.schur
    }

    /// The right-hand side after forward elimination of a load on all unknowns; entries at prescribed unknowns are
    /// ignored.
    ///
    /// One pass from the leaves to the root of the elimination tree: O(N log N) operations for N unknowns.
    pub(crate) fn reduce(&self, load: &[f64]) -> Reduced {
        let mut values: Vec<f64> =
            self.unknowns.iter().map(|&unknown| load[unknown as usize]).collect();
        self.fronts.iter().for_each(|front| front.forward(&mut values));
        Reduced { values, interior: self.interior }
    }

    /// The values of all unknowns computed from the kept ones; prescribed unknowns that are not kept are 0.
    ///
    /// u_i = K_ii⁻¹ (F_i − K_ik u_k) by back substitution from the root to the leaves: O(N log N) operations. The result is
    /// node-major, in the unknowns of the matrix.
    pub(crate) fn recover(&self, reduced: &Reduced, kept: &[f64]) -> Vec<f64> {
        let mut values = reduced.values.clone();
        values[self.interior..].copy_from_slice(kept);
        self.fronts.iter().rev().for_each(|front| front.backward(&mut values));
        let at =
            |&position: &u32| if position == PRESCRIBED { 0.0 } else { values[position as usize] };
        self.positions.iter().map(at).collect()
    }
}

/// The root's update plus the entries of K between kept unknowns, both triangles.
fn whole_schur(ordering: &Ordering<'_>, root: Update, interior: usize) -> Mat<f64> {
    let size = ordering.unknowns.len() - interior;
    let mut schur = Mat::from_fn(size, size, |i, j| root.at(i.max(j), i.min(j)));
    for i in 0..size {
        let unknown = ordering.unknowns[interior + i] as usize;
        for (column, value) in ordering.matrix.row(unknown) {
            let position = ordering.positions[column];
            if position != PRESCRIBED && position as usize >= interior {
                schur[(i, position as usize - interior)] += value;
            }
        }
    }
    schur
}

/// A tree whose pivots have their positions.
struct NumberedTree {
    pivots: std::ops::Range<usize>,
    children: Vec<NumberedTree>,
    size: usize,
}

impl NumberedTree {
    fn new(tree: Tree, number: &mut impl FnMut(&[u32]) -> std::ops::Range<usize>) -> Self {
        let children = tree.children.into_iter().map(|child| Self::new(child, number)).collect();
        Self { children, pivots: number(&tree.pivots), size: tree.size }
    }

    /// The fronts of the subtree in postorder and the update of its root.
    fn eliminate(self, ordering: &Ordering<'_>) -> Result<(Vec<Front>, Update)> {
        let mut children = self.children;
        let done = match (children.pop(), children.pop()) {
            (Some(one), Some(two)) if one.size.min(two.size) >= TASK => {
                // Popped in reverse: `two` comes first in the elimination order.
                let (two, one) =
                    rayon::join(|| two.eliminate(ordering), || one.eliminate(ordering));
                vec![two?, one?]
            }
            (one, two) => {
                let in_order = two.into_iter().chain(one);
                in_order.map(|child| child.eliminate(ordering)).collect::<Result<_>>()?
            }
        };
        let mut fronts = Vec::new();
        let mut updates = Vec::new();
        for (part, update) in done {
            fronts.extend(part);
            updates.push(update);
        }
        let (front, update) = Front::eliminate(ordering, self.pivots, None, updates)?;
        fronts.push(front);
        Ok((fronts, update))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fem::{Form, Frame, stiffness};
    use crate::mesh::{ContactEdge, Part, SideParts, unit_square};

    /// With values 1 at the bottom and 0 at the top the discrete harmonic function is 1 − y, of energy 1.
    #[test]
    fn an_affine_function_is_recovered_with_its_energy() {
        let mesh = unit_square(4, SideParts::HANGING).unwrap();
        let matrix = stiffness(&mesh, &Form::LAPLACE, &Frame::cartesian());
        let (edge, fixed) = (ContactEdge::of(&mesh).unwrap(), mesh.nodes_on(Part::Dirichlet));
        let condensed = Condensation::new(&matrix, mesh.nodes(), &fixed, edge.nodes()).unwrap();
        let u = condensed.recover(&condensed.reduce(&[0.0; 25]), &[1.0; 5]);
        assert!(u.iter().zip(mesh.nodes()).all(|(u, [_, y])| (u - (1.0 - y)).abs() < 1e-13));
        let energy: f64 =
            (0..5).flat_map(|i| (0..5).map(move |j| (i, j))).map(|at| condensed.schur()[at]).sum();
        assert!((energy - 1.0).abs() < 1e-13);
    }
}
