//! The second method on the condensed edge: min ½ w'S w − b'w over { B w ≤ g } by the interior point method.
//!
//! The elimination is that of the active set method; the contact set is found independently. Cost: about 15
//! factorizations of a dense matrix of the size of the edge, where the full problem would require as many sparse
//! factorizations of the whole body.

use super::active_set::EdgeOutcome;
use super::edge_problem::{EdgeProblem, EdgeState};
use super::program::{LEFT, Program, constraint_matrix};
use crate::cone::ContactSet;
use crate::error::Result;
use crate::numeric::scale::largest;
use clarabel::algebra::CscMatrix;

/// The solution of the edge problem; a constraint is active if its force exceeds its gap times the stiffness.
///
/// # Errors
/// [`ToolkitError::LengthMismatch`](crate::ToolkitError::LengthMismatch) if sizes differ,
/// [`crate::error::Error::Solver`] for an error of Clarabel.
pub(super) fn edge_interior_point(problem: &EdgeProblem<'_>) -> Result<EdgeOutcome> {
    let cone = problem.edge_cone();
    problem.check(&ContactSet::empty(cone.constraints()))?;
    let free: Vec<usize> = (0..problem.load.len()).filter(|&i| !problem.fixed[i]).collect();
    let mut number = vec![None; problem.load.len()];
    free.iter().enumerate().for_each(|(k, &node)| number[node] = Some(k));
    let nodes: Vec<usize> = (0..problem.load.len()).collect();
    let constraints: Vec<usize> = (0..cone.constraints()).filter(|&i| !problem.is_settled(i)).collect();
    let stiff = free.iter().map(|&i| problem.stiffness[(i, i)]).fold(0.0, f64::max);
    let answer = Program {
        upper: upper_triangle(problem, &free, stiff),
        stiff,
        load: free.iter().map(|&i| problem.load[i]).collect(),
        rows: constraint_matrix(cone, &constraints, &nodes, &number, free.len()),
        bound: constraints.iter().map(|&i| problem.bound[i]).collect(),
    }
    .solve()?;
    let mut displacement = vec![0.0; problem.load.len()];
    free.iter().zip(&answer.unknowns).for_each(|(&node, &value)| displacement[node] = value);
    let mut multiplier = vec![0.0; cone.constraints()];
    constraints.iter().zip(&answer.multiplier).for_each(|(&i, &value)| multiplier[i] = value);
    let gap: Vec<f64> = cone.apply(&displacement).iter().zip(problem.bound).map(|(w, g)| w - g).collect();
    let stiffness =
        |i: usize| cone.support(i).map(|node| problem.stiffness[(node, node)]).fold(0.0, f64::max);
    let active = |i: usize| multiplier[i] > stiffness(i) * gap[i].abs();
    let set = ContactSet::new(&(0..gap.len()).map(active).collect::<Vec<_>>());
    if set.count() == 0 && largest(&multiplier) <= LEFT * largest(problem.load) {
        // Without contact, small multipliers left by the barrier are set to zero; the balance verifies this.
        multiplier.iter_mut().for_each(|l| *l = 0.0);
    }
    let state = EdgeState { displacement, multiplier, gap };
    let steps = answer.iterations as usize;
    Ok(EdgeOutcome { state, set, status: answer.status, history: Vec::new(), steps })
}

/// The upper triangle of S / `stiff` on the free nodes, by columns.
fn upper_triangle(problem: &EdgeProblem<'_>, free: &[usize], stiff: f64) -> CscMatrix<f64> {
    let (mut starts, mut rows, mut values) = (vec![0], Vec::new(), Vec::new());
    for (column, &node) in free.iter().enumerate() {
        rows.extend(0..=column);
        values.extend(free[..=column].iter().map(|&other| problem.stiffness[(other, node)] / stiff));
        starts.push(rows.len());
    }
    CscMatrix::new(free.len(), free.len(), starts, rows, values)
}
