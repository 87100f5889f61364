//! Refinement: every triangle cut into four, or longest-edge bisection of some.
//!
//! In the second all edges of a marked triangle are bisected; a triangle with a bisected edge has its longest edge
//! bisected as well, until nothing changes. Then every triangle is cut at its longest edge, and the two pieces at their
//! other bisected edges, so the result is conforming. Angles remain at least half the smallest initial angle (I. G.
//! Rosenberg and F. Stenger, Math. Comp. 29 (1975); M. C. Rivara, Int. J. Numer. Meth. Engng 20 (1984)). Cost:
//! O(triangles) per sweep.

use super::edges::Edges;
use super::geometry::{BoundaryEdge, distance};
use super::names::{Interface, Names};
use super::triangulation::Triangulation;
use crate::error::Result;

/// A refined triangulation, the parents of its new nodes, and the triangle from which every triangle comes.
pub(super) type Refined = (Triangulation, Vec<[usize; 2]>, Vec<u32>);

/// The triangulation with the marked triangles refined.
pub(super) fn bisect(coarse: &Triangulation, marked: &[bool]) -> Result<Refined> {
    let edges = Edges::new(coarse.nodes().len(), coarse.triangles());
    let turned = turned_to_longest(coarse, &edges)?;
    let halved = closure(&turned, marked, edges.pairs().len());
    refined(coarse, (&edges, &turned), &halved, cut)
}

/// One red refinement.
///
/// Triangle (a, b, c) with edge midpoints p, q, r of ab, bc, ca becomes (a, p, r), (p, b, q), (r, q, c), (p, q, r).
pub(super) fn red(coarse: &Triangulation) -> Result<Refined> {
    let edges = Edges::new(coarse.nodes().len(), coarse.triangles());
    let sides = |&[a, b, c]: &[usize; 3]| {
        Ok(([a, b, c], [edges.find(a, b)?, edges.find(b, c)?, edges.find(c, a)?]))
    };
    let triangles = coarse.triangles().iter().map(sides).collect::<Result<Vec<_>>>()?;
    refined(
        coarse,
        (&edges, &triangles),
        &vec![true; edges.pairs().len()],
        |[a, b, c], middles, triangles| {
            if let [Some(p), Some(q), Some(r)] = middles {
                triangles.extend([[a, p, r], [p, b, q], [r, q, c], [p, q, r]]);
            }
        },
    )
}

/// The triangulation with the given edges bisected and every triangle cut at its midpoints by `cut`.
fn refined(
    coarse: &Triangulation,
    (edges, turned): (&Edges, &[Turned]),
    halved: &[bool],
    cut: impl Fn([usize; 3], [Option<usize>; 3], &mut Vec<[usize; 3]>),
) -> Result<Refined> {
    let mut nodes = coarse.nodes().to_vec();
    let mut parents = Vec::new();
    let mut middles = vec![None; halved.len()];
    for (edge, [a, b]) in edges.pairs().into_iter().enumerate().filter(|&(edge, _)| halved[edge]) {
        let (p, q) = (coarse.nodes()[a], coarse.nodes()[b]);
        middles[edge] = Some(nodes.len());
        nodes.push([0.5 * p[0] + 0.5 * q[0], 0.5 * p[1] + 0.5 * q[1]]);
        parents.push([a, b]);
    }
    let (mut triangles, mut regions, mut origins) = (Vec::new(), Vec::new(), Vec::new());
    for (t, &(corners, sides)) in turned.iter().enumerate() {
        cut(corners, sides.map(|edge| middles[edge]), &mut triangles);
        regions.resize(triangles.len(), coarse.region(t) as u32);
        origins.resize(triangles.len(), t as u32);
    }
    let pieces = |[a, b]: [usize; 2]| -> Result<Vec<[usize; 2]>> {
        Ok(middles[edges.find(a, b)?].map_or_else(|| vec![[a, b]], |m| vec![[a, m], [m, b]]))
    };
    let mut boundary = Vec::new();
    // The names of groups pass to the halves of edges and triangles.
    let mut names = Names { of_edges: Vec::new(), ..coarse.names().clone() };
    for (edge, &BoundaryEdge { nodes, part }) in coarse.boundary().iter().enumerate() {
        boundary.extend(pieces(nodes)?.into_iter().map(|nodes| BoundaryEdge { nodes, part }));
        if let Some(&group) = coarse.names().of_edges.get(edge) {
            names.of_edges.resize(boundary.len(), group);
        }
    }
    for Interface { edges, .. } in &mut names.interfaces {
        *edges = edges.iter().map(|&edge| pieces(edge)).collect::<Result<Vec<_>>>()?.concat();
    }
    let fine = Triangulation::trusted(nodes, triangles, boundary).with_names(names);
    let fine = if coarse.regions().is_empty() { fine } else { fine.with_regions(&regions)? };
    Ok((fine, parents, origins))
}

/// A triangle (a, b, c) with longest edge ab, and its edges ab, bc, ca.
type Turned = ([usize; 3], [usize; 3]);

/// Every triangle with its longest edge first; among edges of equal length the one with the larger pair of node
/// numbers is taken, so that the two triangles at an edge agree.
fn turned_to_longest(mesh: &Triangulation, edges: &Edges) -> Result<Vec<Turned>> {
    let turn = |&corners: &[usize; 3]| {
        let length = |k: usize| {
            let (a, b) = (corners[k], corners[(k + 1) % 3]);
            (distance(mesh.nodes()[a], mesh.nodes()[b]), [a.min(b), a.max(b)])
        };
        // Ties are broken by node numbers, the same on both sides of an edge.
        let longest = (1..3).fold(0, |best, k| if length(k) > length(best) { k } else { best });
        let [a, b, c] = [0, 1, 2].map(|k| corners[(longest + k) % 3]);
        Ok(([a, b, c], [edges.find(a, b)?, edges.find(b, c)?, edges.find(c, a)?]))
    };
    mesh.triangles().iter().map(turn).collect()
}

/// The edges to bisect: those of marked triangles, and the longest edge of every triangle with a bisected edge.
fn closure(turned: &[Turned], marked: &[bool], edges: usize) -> Vec<bool> {
    let mut halved = vec![false; edges];
    for ((_, sides), _) in turned.iter().zip(marked).filter(|&(_, &marked)| marked) {
        sides.iter().for_each(|&edge| halved[edge] = true);
    }
    let mut changed = true;
    while changed {
        changed = false;
        for &(_, [longest, second, third]) in turned {
            if !halved[longest] && (halved[second] || halved[third]) {
                halved[longest] = true;
                changed = true;
            }
        }
    }
    halved
}

/// Cuts (a, b, c) at the given midpoints of ab, bc, ca.
fn cut([a, b, c]: [usize; 3], middles: [Option<usize>; 3], triangles: &mut Vec<[usize; 3]>) {
    let [Some(m), bc, ca] = middles else {
        triangles.push([a, b, c]);
        return;
    };
    match ca {
        Some(q) => triangles.extend([[a, m, q], [m, c, q]]),
        None => triangles.push([a, m, c]),
    }
    match bc {
        Some(p) => triangles.extend([[m, b, p], [m, p, c]]),
        None => triangles.push([m, b, c]),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{Hierarchy, Part, SideParts, unit_square};

    fn smallest_angle(mesh: &Triangulation) -> f64 {
        (0..mesh.triangles().len())
            .flat_map(|t| {
                let p = mesh.corners(t);
                (0..3).map(move |k| {
                    let (a, b, c) = (p[k], p[(k + 1) % 3], p[(k + 2) % 3]);
                    let (u, v) = ([b[0] - a[0], b[1] - a[1]], [c[0] - a[0], c[1] - a[1]]);
                    (u[0] * v[1] - u[1] * v[0]).atan2(u[0] * v[0] + u[1] * v[1])
                })
            })
            .fold(f64::INFINITY, f64::min)
    }

    fn assert_sound(mesh: &Triangulation) {
        let checked = Triangulation::new(mesh.nodes(), mesh.triangles(), mesh.boundary());
        assert_eq!(&checked.unwrap(), mesh);
    }

    #[test]
    fn grading_toward_a_point_conforms_and_keeps_angles() {
        let mut hierarchy = Hierarchy::new(unit_square(4, SideParts::HANGING).unwrap());
        let first = smallest_angle(hierarchy.finest());
        for _ in 0..20 {
            hierarchy.refine_where(|mesh, t| mesh.corners(t).contains(&[0.25, 0.0])).unwrap();
        }
        let mesh = hierarchy.finest();
        assert_sound(mesh);
        assert!(smallest_angle(mesh) >= 0.5 * first - 1e-12);
        assert!(mesh.triangles().len() < 1500, "{}", mesh.triangles().len());
        let at_point = mesh.nodes().iter().map(|&p| distance(p, [0.25, 0.0])).filter(|&d| d > 0.0);
        assert_eq!(at_point.fold(f64::INFINITY, f64::min), 0.25 * 0.5_f64.powi(20));
    }

    #[test]
    fn names_pass_to_the_halves() {
        // The diagonal is a curve inside; regions are the two sides of it.
        let square = unit_square(1, SideParts::HANGING).unwrap();
        let [a, c] =
            [[0.0, 0.0], [1.0, 1.0]].map(|p| square.nodes().iter().position(|&q| q == p).unwrap());
        let diagonal = Interface { name: "weld".to_owned(), edges: vec![[a, c]] };
        let square = square.with_groups(&["floor", "right", "ceiling", "left"]).unwrap();
        let square =
            square.with_regions(&[0, 1]).unwrap().with_region_names(&["low", "high"]).unwrap();
        let mut hierarchy = Hierarchy::new(square.with_interfaces(vec![diagonal]));
        hierarchy.refine().unwrap();
        hierarchy.refine_where(|mesh, t| mesh.corners(t).contains(&[0.0, 0.0])).unwrap();
        let mesh = hierarchy.finest();
        let name = |[x, y]: [f64; 2]| match (x, y) {
            (_, 0.0) => "floor",
            (1.0, _) => "right",
            (_, 1.0) => "ceiling",
            _ => "left",
        };
        for (edge, sides) in mesh.boundary().iter().enumerate() {
            let [p, q] = mesh.ends(sides);
            assert_eq!(mesh.group(edge), name([0, 1].map(|k| 0.5 * (p[k] + q[k]))));
        }
        for t in 0..mesh.triangles().len() {
            let [a, b, c] = mesh.corners(t);
            let above = a[1] + b[1] + c[1] > a[0] + b[0] + c[0];
            assert_eq!(mesh.region_names()[mesh.region(t)] == "high", above);
        }
        let inside = &mesh.interfaces()[0];
        let length = |&[a, b]: &[usize; 2]| distance(mesh.nodes()[a], mesh.nodes()[b]);
        assert!((inside.edges.iter().map(length).sum::<f64>() - 2f64.sqrt()).abs() < 1e-15);
        assert_eq!(inside.edges.len(), 3);
        assert!(inside.edges.iter().flatten().all(|&k| mesh.nodes()[k][0] == mesh.nodes()[k][1]));
    }

    #[test]
    fn grading_toward_the_contact_edge_keeps_nested_functions() {
        let mut hierarchy = Hierarchy::new(unit_square(2, SideParts::HANGING).unwrap());
        for _ in 0..4 {
            let on = hierarchy.finest().nodes_on(Part::Contact);
            let touches =
                |mesh: &Triangulation, t: usize| mesh.triangles()[t].iter().any(|&node| on[node]);
            hierarchy.refine_where(touches).unwrap();
        }
        let mesh = hierarchy.finest();
        assert_sound(mesh);
        let affine = |mesh: &Triangulation| -> Vec<f64> {
            mesh.nodes().iter().map(|&[x, y]| 2.0 * x - y).collect()
        };
        let prolonged = hierarchy.prolong(0, 4, 1, &affine(&hierarchy.levels()[0])).unwrap();
        assert_eq!(prolonged, affine(mesh));
    }
}
