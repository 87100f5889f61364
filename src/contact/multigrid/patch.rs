//! Contact on patches of a level: the contact set near some constraints, computed from functions supported near them.
//!
//! For an iterate x, J(x + d) is minimised over B (x + d) ≤ g and d in the patch: nodal functions within [`DEPTH`]
//! edges of the nodes of the constraints, and, if a contact interval of the midpoint cone extends beyond the
//! patch, the sawtooth on the part outside as an additional function, without which the interval could not
//! move. J does not increase, whichever contact set x has (local minimisation in addition to a linear
//! correction, as in truncated nonsmooth Newton methods: C. Gräser and R. Kornhuber, J. Comput. Math. 27
//! (2009)). The patch is condensed to its nodes on the edge, a dozen or two, and solved there by the active
//! set method. The ends of the contact intervals are determined mainly by nearby nodes; the next linear solve
//! reduces the error that remains. Cost for m constraints: O((m + DEPTH)³), independent of the number of
//! unknowns of the level.

use super::super::active_set::solve_on_edge;
use super::super::edge_problem::EdgeProblem;
use super::super::problem::ContactProblem;
use super::edge::Edge;
use super::level::Level;
use crate::cone::{Cone, ContactSet, Ends};
use crate::error::Result;
use crate::fem::{BlockMatrix, Condensation};
use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;

/// Number of mesh edges between the constraints and the boundary of their patch.
const DEPTH: usize = 8;
/// Distance of constraints beyond which they have separate patches.
const APART: usize = 2 * DEPTH;
/// Largest number of constraints of a patch, whose edge has a dense matrix.
const WIDEST: usize = 512;

/// Corrects the set near the given constraints (ascending), and the iterate accordingly.
pub(super) fn mend<L: Level>(
    (problem, level, edge, load): (&ContactProblem, &L, &Edge, &[f64]),
    x: &mut [f64],
    set: &mut ContactSet,
    constraints: &[usize],
) -> Result<()> {
    for near in constraints.chunk_by(|a, b| b - a <= APART) {
        let window = near[0]..near[near.len() - 1] + 1;
        if window.len() <= WIDEST {
            Patch::new(problem, edge, set, window).solve((problem, level, edge, load), x, set)?;
        }
    }
    Ok(())
}

struct Patch {
    /// Nodes of the edge; the first and the last one represent the part outside, if there is one.
    edge: Range<usize>,
    /// Their unknowns of u_N, and whether they are fixed.
    kept: Vec<(usize, bool)>,
    /// Map from unknowns of the body to unknowns of the patch, with a sign.
    number: BTreeMap<usize, (usize, f64)>,
    /// Nodes of the body; those that represent the part outside come last.
    nodes: Vec<usize>,
}

impl Patch {
    fn new(problem: &ContactProblem, edge: &Edge, set: &ContactSet, window: Range<usize>) -> Self {
        let (c, normals) = (problem.form.components(), problem.normal_unknowns());
        let last = normals.len() - 1;
        let right = edge.cone.support(window.end - 1).max().unwrap_or(window.start);
        let core = window.start.saturating_sub(DEPTH)..(right + DEPTH).min(last) + 1;
        let centre: Vec<usize> = (window.start..=right).map(|k| normals[k] / c).collect();
        let outside = (0..core.start).chain(core.end..=last).map(|k| normals[k] / c).collect();
        let mut inside = ball(problem, centre, &outside);
        inside.extend(core.clone().map(|k| normals[k] / c));
        let mut nodes: Vec<usize> = inside.into_iter().collect();
        let local = |unknown: usize, nodes: &[usize]| {
            nodes.binary_search(&(unknown / c)).unwrap_or(nodes.len()) * c + unknown % c
        };
        let unknowns = nodes.iter().flat_map(|node| node * c..(node + 1) * c);
        let free = unknowns.filter(|&unknown| !problem.prescribed[unknown]);
        let mut number: BTreeMap<usize, (usize, f64)> =
            free.map(|unknown| (unknown, (local(unknown, &nodes), 1.0))).collect();
        let mut kept: Vec<(usize, bool)> =
            core.clone().map(|k| (local(normals[k], &nodes), edge.fixed[k])).collect();
        let mut tail = |run: &[usize]| {
            let unknown = nodes.len() * c + normals[run[0]] % c;
            nodes.push(normals[run[0]] / c);
            let is_held = run.len() == 1 || run.iter().any(|&k| edge.fixed[k]);
            for (i, &k) in run.iter().enumerate().filter(|_| !is_held) {
                number.insert(normals[k], (unknown, if i.is_multiple_of(2) { 1.0 } else { -1.0 }));
            }
            (unknown, is_held)
        };
        let holds = |i: usize| edge.cone.kind() == Cone::Midpoint && set.contains(i);
        let mut reach = core.clone();
        if core.start > 0 {
            let first = (0..core.start).rev().take_while(|&k| k + 1 == core.start || holds(k));
            kept.insert(0, tail(&first.collect::<Vec<_>>()));
            reach.start -= 1;
        }
        if core.end <= last {
            let second = (core.end..=last).take_while(|&k| k == core.end || holds(k - 1));
            kept.push(tail(&second.collect::<Vec<_>>()));
            reach.end += 1;
        }
        Self { edge: reach, kept, number, nodes }
    }

    fn solve<L: Level>(
        &self,
        (problem, level, edge, load): (&ContactProblem, &L, &Edge, &[f64]),
        x: &mut [f64],
        set: &mut ContactSet,
    ) -> Result<()> {
        let c = problem.form.components();
        let unknowns = self.nodes.len() * c;
        let (mut rows, mut residual) = (vec![BTreeMap::new(); unknowns], vec![0.0; unknowns]);
        let mut held = vec![true; unknowns];
        for (&unknown, &(row, sign)) in &self.number {
            held[row] = false;
            residual[row] += sign * load[level.place(unknown)];
            for (column, value) in problem.row(unknown) {
                residual[row] -= sign * value * x[level.place(column)];
                if let Some(&(column, other)) = self.number.get(&column) {
                    *rows[row].entry(column).or_insert(0.0) += sign * other * value;
                }
            }
        }
        let points: Vec<_> = self.nodes.iter().map(|&node| problem.mesh.nodes()[node]).collect();
        let (normals, fixed): (Vec<usize>, Vec<bool>) = self.kept.iter().copied().unzip();
        let condensation =
            Condensation::new(&BlockMatrix::of_rows(c, &rows), &points, &held, &normals)?;
        let reduced = condensation.reduce(&residual);
        let cone = edge.cone.kind();
        let constraints = self.edge.start..self.edge.start + cone.constraints(self.edge.len());
        let on_edge = EdgeProblem {
            stiffness: condensation.schur(),
            load: reduced.kept(),
            bound: &edge.slack(x)[constraints.clone()],
            fixed: &fixed,
            cone,
            ends: Ends::Open,
        };
        let mut active = set.as_slice().to_vec();
        let found = solve_on_edge(&on_edge, ContactSet::new(&active[constraints.clone()]))?;
        if found.status.is_converged() {
            let change = condensation.recover(&reduced, &found.state.displacement);
            for (&unknown, &(local, sign)) in &self.number {
                x[level.place(unknown)] += sign * change[local];
            }
            active[constraints].copy_from_slice(found.set.as_slice());
            *set = ContactSet::new(&active);
        }
        Ok(())
    }
}

/// The nodes within [`DEPTH`] edges of the given ones, along paths that avoid `outside`.
fn ball(
    problem: &ContactProblem,
    centre: Vec<usize>,
    outside: &BTreeSet<usize>,
) -> BTreeSet<usize> {
    let c = problem.form.components();
    let mut found: BTreeSet<usize> = centre.iter().copied().collect();
    let mut layer = centre;
    for _ in 0..DEPTH {
        let rows = layer.iter().flat_map(|node| node * c..(node + 1) * c);
        let beside: BTreeSet<usize> =
            rows.flat_map(|unknown| problem.row(unknown)).map(|(column, _)| column / c).collect();
        layer = beside
            .into_iter()
            .filter(|node| !outside.contains(node) && found.insert(*node))
            .collect();
    }
    found
}
