//! Loads, tractions, displacements and gaps on groups of the boundary and on regions, by name.

use signorini::bounds::{Enclosure, Ended, Refinement, Traction};
use signorini::cone::Cone;
use signorini::contact::{Body, Solver};
use signorini::fem::{Form, Lame};
use signorini::mesh::{Hierarchy, Part, SideParts, Triangulation, unit_square};
use signorini::{Error, ToolkitError};

/// A bridge: (0, 4) × (0, 2) without (1, 3) × (0, 1), in squares of side 1/2 cut in two. Its feet are `contact a` and
/// `contact b`, clamped on top of them (`clamped a`, `clamped b`); its deck, above y = 1, is a region of its own.
fn bridge() -> Triangulation {
    let (mut nodes, mut triangles, mut regions) = (Vec::new(), Vec::new(), Vec::new());
    let node = |i: usize, j: usize| j * 9 + i;
    (0..45).for_each(|k| nodes.push([0.5 * (k % 9) as f64, 0.5 * (k / 9) as f64]));
    let is_inside = |i: usize, j: usize| j >= 2 || !(2..6).contains(&i);
    let mut sides = std::collections::BTreeMap::new();
    for (i, j) in (0..4).flat_map(|j| (0..8).map(move |i| (i, j))).filter(|&(i, j)| is_inside(i, j))
    {
        let [a, b, c, d] = [node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)];
        for triangle in [[a, b, c], [a, c, d]] {
            triangles.push(triangle);
            regions.push(if j >= 2 { "deck" } else { "feet" });
            for k in 0..3 {
                let (p, q) = (triangle[k], triangle[(k + 1) % 3]);
                *sides.entry((p.min(q), p.max(q))).or_insert(0) += 1;
            }
        }
    }
    let group = |p: usize, q: usize| {
        let [x, y] = [0, 1].map(|axis| 0.5 * (nodes[p][axis] + nodes[q][axis]));
        match () {
            () if y == 0.0 && x < 2.0 => "contact a",
            () if y == 0.0 => "contact b",
            () if y == 2.0 && x < 1.0 => "clamped a",
            () if y == 2.0 && x > 3.0 => "clamped b",
            () if x == 0.0 => "free left",
            () if x == 4.0 => "free right",
            () => "free",
        }
    };
    let outside = sides.iter().filter(|(_, count)| **count == 1);
    let edges: Vec<([usize; 2], &str)> =
        outside.map(|(&(p, q), _)| ([p, q], group(p, q))).collect();
    Triangulation::from_groups(&nodes, &triangles, &regions, &edges, &[]).unwrap()
}

fn materials(mesh: &Triangulation) -> Form {
    let names = mesh.region_names();
    let of = |name: &String| Lame::new(1.0, if name == "feet" { 2.0 } else { 1.0 }).unwrap();
    Form::Elastic { materials: names.iter().map(of).collect() }
}

/// Two floors with gaps, a traction on one side, a displacement on one of two clamps, a load on the deck only.
fn loaded<'a>() -> Body<'a> {
    let mesh = bridge();
    let form = materials(&mesh);
    Body::new(mesh, form)
        .load_on("deck", |[x, _]: [f64; 2]| [0.0, -0.1 - 0.05 * x])
        .traction_on("free left", |[_, y]: [f64; 2]| [0.1 * y, 0.02])
        .displacement_on("clamped b", |[x, _]: [f64; 2]| [0.0, -0.02 * (x - 2.0)])
        .gap_on("contact a", |_| 0.001)
        .gap_on("contact b", |[x, _]| 0.002 * (x - 3.0) * (x - 3.0))
}

#[test]
fn each_acts_on_its_group_and_forces_balance() {
    let body = loaded();
    let problem = body.problem().unwrap();
    let u = problem.solve(Cone::Nodal, Solver::ActiveSet).unwrap();
    assert!(u.kkt.worst() < 1e-12 && u.balance < 1e-12, "{:?} {}", u.kkt, u.balance);
    // ∫ (0.1 + 0.05 x) over (0, 4) × (1, 2), ∫ (0.1 y, 0.02) over (0, 2): by hand.
    let given = [0.2, -0.8 + 0.04];
    assert!((u.reaction[0] + given[0]).abs() < 1e-13, "{:?}", u.reaction);
    assert!((u.reaction[1] + given[1] + u.contact_force).abs() < 1e-13, "{:?}", u.reaction);
    // Both feet are pressed to their own floors, and the gaps are those of their groups.
    let pieces = problem.edge().pieces();
    assert_eq!(pieces.len(), 2);
    for piece in pieces {
        assert!(piece.clone().any(|i| u.contact_set.contains(i)));
        for i in piece {
            let [x, _] = problem.edge().points()[i];
            let gap = if x < 2.0 { 0.001 } else { 0.002 * (x - 3.0) * (x - 3.0) };
            assert!((u.normal_displacement[i] - gap - u.gap[i]).abs() < 1e-16);
        }
    }
    for (node, &[x, y]) in problem.mesh().nodes().iter().enumerate() {
        if y == 2.0 && !(1.0 < x && x < 3.0) {
            let down = if x >= 3.0 { -0.02 * (x - 2.0) } else { 0.0 };
            let [a, b] = [u.displacement[2 * node], u.displacement[2 * node + 1]];
            assert!(a == 0.0 && (b - down).abs() < 1e-16);
        }
    }
}

#[test]
fn the_bound_is_above_the_error_on_a_finer_mesh() {
    let body = loaded();
    let meshes = Hierarchy::refined(bridge(), 3).unwrap();
    let fine = body.problem_on(meshes.finest()).unwrap();
    let u = fine.solve(Cone::Nodal, Solver::ActiveSet).unwrap();
    let found = body.enclose(Cone::Nodal).unwrap();
    let coarse = &found.solution.displacement;
    let error = fine.nested_energy_error(&meshes, (0, coarse), (3, &u.displacement)).unwrap();
    println!("bound {:.6} error {error:.6} ratio {:.3}", found.error, found.error / error);
    assert!(error < found.error && found.error < 2.0 * error, "{error} {}", found.error);
    assert!(found.energy.contains(u.energy));
    for floor in 0..2 {
        let force = body.contact_force(&found, floor).unwrap().unwrap();
        let piece = fine.edge().pieces()[floor].clone();
        let fine_force: f64 = piece.map(|i| u.multiplier[i]).sum();
        println!("floor {floor}: {force:?} contains {fine_force}");
        assert!(force.contains(fine_force));
    }
}

#[test]
fn a_first_mesh_whose_bound_exceeds_the_norm_is_refined() {
    // Linear tractions are too good for it: their bound is below the norm on the first mesh.
    let tractions = Traction::Reduced;
    let refinement = Refinement { tolerance: 0.5, tractions, ..Refinement::default() };
    let (mut first, mut meshes) = (None, 0);
    let each = |found: &Enclosure| {
        first.get_or_insert(found.norm.lower);
        meshes += 1;
    };
    let (found, ended) = refinement.run(&loaded(), each).unwrap();
    assert!(first == Some(0.0) && meshes > 1, "{first:?} {meshes}");
    assert!(ended == Ended::Tolerance && found.relative_error() <= 0.5);
}

#[test]
fn an_unknown_name_is_answered_by_those_of_the_mesh() {
    let none = |_: [f64; 2]| [0.0, 0.0];
    let body = || Body::new(bridge(), materials(&bridge()));
    let said = |body: Body| match body.problem().unwrap_err() {
        error @ Error::NoGroup { .. } => error.to_string(),
        other => panic!("{other}"),
    };
    let of = |what: &str, known: &str| format!("the mesh has no {what}: it has {known}");
    assert_eq!(said(body().load_on("arch", none)), of("region 'arch'", "feet, deck"));
    let free = "free, free left, free right";
    let found = said(body().traction_on("clamped a", none));
    let mut known: Vec<&str> = found
        .split_once("has no free boundary group 'clamped a': it has ")
        .unwrap()
        .1
        .split(", ")
        .collect();
    known.sort_unstable();
    assert_eq!(known.join(", "), free);
    let clamps = "clamped a, clamped b";
    assert_eq!(
        said(body().displacement_on("free", none)),
        of("clamped boundary group 'free'", clamps)
    );
    assert_eq!(
        said(body().gap_on("floor", |_| 0.0)),
        of("contact boundary group 'floor'", "contact a, contact b")
    );
    // The bound says the same.
    assert!(matches!(
        body().gap_on("floor", |_| 0.0).enclose(Cone::Nodal),
        Err(Error::NoGroup { .. })
    ));
}

#[test]
fn two_displacements_at_a_common_node_have_to_agree() {
    let nodes = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    let edges =
        [([0, 1], "contact"), ([1, 2], "clamped right"), ([2, 3], "clamped top"), ([3, 0], "free")];
    let mesh =
        Triangulation::from_groups(&nodes, &[[0, 1, 2], [0, 2, 3]], &[], &edges, &[]).unwrap();
    let body = Body::new(mesh, Form::LAPLACE).displacement_on("clamped top", |[x, _]| x - 1.0);
    assert!(body.problem().is_ok());
    let torn = body.displacement_on("clamped right", |[_, y]: [f64; 2]| y);
    assert!(matches!(
        torn.problem().unwrap_err(),
        Error::Toolkit(ToolkitError::Node { node: 2, .. })
    ));
}

#[test]
fn names_and_everywhere_are_the_same_on_one_group() {
    let mesh = bridge();
    let form = materials(&mesh);
    let f = |[x, y]: [f64; 2]| [0.1 * y, -0.1 * x];
    let whole = Body::new(mesh.clone(), form.clone())
        .load(f)
        .traction(f)
        .displacement(f)
        .gap(|[x, _]| 0.01 * x);
    let mut parts = Body::new(mesh.clone(), form).gap_on("contact a", |_| 9.0);
    for region in mesh.region_names() {
        parts = parts.load_on(&region, f);
    }
    let of = |part: Part| {
        let all = mesh.boundary().iter().enumerate().filter(move |(_, edge)| edge.part == part);
        all.map(|(number, _)| mesh.group(number)).collect::<std::collections::BTreeSet<&str>>()
    };
    for group in of(Part::Neumann) {
        parts = parts.traction_on(group, f);
    }
    for group in of(Part::Dirichlet) {
        parts = parts.displacement_on(group, f);
    }
    for group in of(Part::Contact) {
        // The one of a name is before that of all groups, and the later before the earlier.
        parts = parts.gap_on(group, |[x, _]| 0.01 * x).gap(|_| 7.0);
    }
    let [a, b] = [whole, parts].map(|body| {
        let u = body.problem().unwrap().solve(Cone::Nodal, Solver::ActiveSet).unwrap();
        (u.energy, u.displacement)
    });
    assert!((a.0 - b.0).abs() < 1e-14 * a.0.abs());
    assert!(a.1.iter().zip(&b.1).all(|(u, v)| (u - v).abs() < 1e-14));
}

/// A clamp that ends on the floor and is prescribed beyond it leaves no admissible displacement: said, with the place.
#[test]
fn a_clamp_beyond_the_floor_is_said() {
    let sides = SideParts { left: Part::Dirichlet, ..SideParts::HANGING };
    let mesh = unit_square(4, sides).unwrap();
    let ends: Vec<[f64; 2]> = {
        let held = mesh.nodes_on(Part::Dirichlet);
        let on_floor = |i: &usize| held[*i] && mesh.nodes()[*i][1] == 0.0;
        (0..held.len()).filter(on_floor).map(|i| mesh.nodes()[i]).collect()
    };
    assert!(!ends.is_empty());
    let form = Form::elastic(Lame::new(1.0, 1.0).unwrap());
    let body = |down: f64| {
        Body::new(mesh.clone(), form.clone())
            .load(|_: [f64; 2]| [0.0, -1.0])
            .gap(|_: [f64; 2]| 0.25)
            .displacement(move |_: [f64; 2]| [0.0, -down])
    };
    for solver in [Solver::ActiveSet, Solver::InteriorPoint, Solver::Multigrid] {
        let solve = |down| body(down).problem_on(&mesh).unwrap().solve(Cone::Nodal, solver);
        assert!(solve(0.25).is_ok(), "{solver}");
        match solve(0.5) {
            Err(Error::BeyondFloor { place, displacement, gap }) => {
                assert!(ends.contains(&place), "{place:?}");
                assert_eq!((displacement, gap), (0.5, 0.25));
            }
            other => panic!("{solver}: {other:?}"),
        }
    }
    // The midpoint cone has no constraint at the clamp: its solution exists, the exact one does not.
    let far = body(0.5);
    assert!(far.problem_on(&mesh).unwrap().solve(Cone::Midpoint, Solver::ActiveSet).is_ok());
    let enclosed = far.enclose(Cone::Midpoint);
    assert!(matches!(enclosed, Err(Error::BeyondFloor { .. })), "{enclosed:?}");
    assert!(body(0.25).enclose(Cone::Midpoint).is_ok());
}
