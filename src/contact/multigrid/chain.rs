//! The coarse problems of a problem: the same form on coarser meshes, loads P'F with the prolongation P, gaps
//! and prescribed values at the coarse nodes.
//!
//! On nested meshes the coarse matrices are P'KP and the coarse problems minimise the same functional over coarser
//! functions. On the image of a grid under a map that is not affine this holds approximately.

use super::super::operator::Operator;
use super::super::problem::ContactProblem;
use super::link::Link;
use crate::error::{Error, Result, ToolkitError};
use crate::mesh::{ContactEdge, Grid, Hierarchy, Part, Triangulation};

/// Largest number of nodes of a grid that is not coarsened.
const COARSEST: usize = 100;

/// The coarse problems of a problem, coarsest first.
pub(super) struct Chain {
    /// One coarse problem for every level but the finest.
    pub(super) problems: Vec<ContactProblem>,
    /// For every level k, the two nodes whose midpoint is a given node of level k + 1.
    pub(super) parents: Vec<Vec<[u32; 2]>>,
    /// The same relation along the contact edge.
    pub(super) links: Vec<Link>,
}

impl Chain {
    /// The chain given by the hierarchy, or by omitting every other line of a grid; empty if neither exists.
    pub(super) fn of(problem: &ContactProblem, hierarchy: Option<&Hierarchy>) -> Result<Self> {
        let mut meshes: Vec<(Triangulation, Vec<[u32; 2]>)> = Vec::new();
        if let Some(hierarchy) = hierarchy {
            check(problem, hierarchy)?;
            for level in (1..hierarchy.levels().len()).rev() {
                meshes.push((hierarchy.levels()[level - 1].clone(), hierarchy.parents(level)));
            }
        } else {
            let mut grid = Grid::of(&problem.mesh);
            while let Some(fine) = grid.filter(|fine| fine.nodes() > COARSEST) {
                let mesh = meshes.last().map_or(&problem.mesh, |(mesh, _)| mesh);
                let made = fine.coarse_mesh(mesh);
                grid = made.as_ref().map(|(coarse, _)| *coarse);
                if let Some((coarse, mesh)) = made {
                    meshes.push((mesh, fine.parents(coarse)));
                }
            }
        }
        let mut chain = Self { problems: Vec::new(), parents: Vec::new(), links: Vec::new() };
        for (mesh, parents) in meshes {
            let fine = chain.problems.last().unwrap_or(problem);
            let coarse = coarse_problem(fine, mesh, &parents)?;
            chain.links.push(Link::new(&fine.edge, &coarse.edge, &parents)?);
            chain.problems.push(coarse);
            chain.parents.push(parents);
        }
        chain.problems.reverse();
        chain.parents.reverse();
        chain.links.reverse();
        Ok(chain)
    }
}

fn check(problem: &ContactProblem, hierarchy: &Hierarchy) -> Result<()> {
    let (given, expected) = (hierarchy.finest().nodes(), problem.mesh.nodes());
    if given == expected && hierarchy.finest().triangles() == problem.mesh.triangles() {
        return Ok(());
    }
    let name = "nodes of the finest mesh of the hierarchy (the mesh of the problem)";
    Err(Error::Toolkit(ToolkitError::LengthMismatch {
        name,
        given: given.len(),
        expected: expected.len(),
    }))
}

/// The problem on a coarser mesh.
fn coarse_problem(
    fine: &ContactProblem,
    mesh: Triangulation,
    parents: &[[u32; 2]],
) -> Result<ContactProblem> {
    let c = fine.form.components();
    let unknowns = mesh.nodes().len() * c;
    let edge = ContactEdge::of(&mesh)?;
    let held = mesh.nodes_on(Part::Dirichlet);
    let (mut load, mut values) = (vec![0.0; unknowns], vec![0.0; unknowns]);
    for (node, &[a, b]) in parents.iter().enumerate() {
        for k in 0..c {
            let half = 0.5 * fine.load[node * c + k];
            load[a as usize * c + k] += half;
            load[b as usize * c + k] += half;
            if a == b {
                values[a as usize * c + k] = fine.values[node * c + k];
            }
        }
    }
    let mut gaps = std::collections::HashMap::new();
    for (&node, &gap) in fine.edge.nodes().iter().zip(&fine.gap) {
        let [a, b] = parents[node];
        if a == b {
            gaps.insert(a as usize, gap);
        }
    }
    let gap = edge.nodes().iter().map(|node| gaps.get(node).copied().unwrap_or(0.0)).collect();
    Ok(ContactProblem {
        operator: Operator::of(&mesh, &fine.form, &fine.frames),
        prescribed: held.iter().flat_map(|&held| std::iter::repeat_n(held, c)).collect(),
        form: fine.form.clone(),
        frames: fine.frames.clone(),
        preparation_seconds: 0.0,
        mesh,
        edge,
        load,
        values,
        gap,
        floats: false,
    })
}
