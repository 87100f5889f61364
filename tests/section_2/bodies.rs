//! Section 2: bodies of one's own. Meshes of Gmsh in both formats, loads as expressions, several contact
//! edges, and what is written of them.

#[allow(dead_code)]
#[path = "../../examples/section_2_own_body.rs"]
mod section_2_own_body;

use example_report::Outcome;
use section_2_own_body::Options;
use signorini::Error;
use signorini::ToolkitError;
use signorini::cone::Cone;
use signorini::contact::{ContactProblem, ContactSolution, Fallback, Settings, Solver, Start};
use signorini::fem::{Cubature, Field, Form, Lame, stresses};
use signorini::mesh::{ContactEdge, Triangulation, parse_msh, read_msh};
use std::path::{Path, PathBuf};

const L_SHAPE: &str = include_str!("../../examples/data/l_shape.msh");
const L_SHAPE_2: &str = include_str!("../reference/l_shape_2.2.msh");
const GROOVE: &str = include_str!("../../examples/data/groove.msh");

/// Sums over some hundred nodes of numbers of order one.
const SUMS: f64 = 1e-12;

fn repository(file: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(file)
}

fn elastic() -> Form {
    Form::elastic(Lame::new(1.0, 1.0).unwrap())
}

#[test]
fn both_formats_of_gmsh_hold_the_same_body() {
    let (four, two) = (parse_msh(L_SHAPE).unwrap(), parse_msh(L_SHAPE_2).unwrap());
    assert_eq!(four, two);
    assert_eq!(read_msh(repository("examples/data/l_shape.msh")), Ok(four.clone()));
    // The floor rises by 20 degrees; the normal points down and to the right.
    let normal = ContactEdge::of(&four).unwrap().normal().unwrap();
    let angle = 20_f64.to_radians();
    assert!(
        (normal[0] - angle.sin()).abs() < SUMS && (normal[1] + angle.cos()).abs() < SUMS,
        "{normal:?}"
    );
    for (good, bad) in [
        ("$EndNodes\n", "1 0 0 0\n$EndNodes\n"),
        ("36 2 2 4 1", "36 3 2 4 1"),
        ("\"contact\"", "\"floor\""),
        ("2.2 0", "3 0"),
    ] {
        let text = L_SHAPE_2.replacen(good, bad, 1);
        assert!(text != L_SHAPE_2 && parse_msh(&text).is_err(), "{bad}");
    }
    // Names in other words, a clockwise surface.
    let renamed =
        L_SHAPE.replace("\"contact\"", "\"Contact_1\"").replace("\"clamped\"", "\"Dirichlet\"");
    let renamed = parse_msh(&renamed).unwrap();
    assert_eq!((renamed.boundary(), renamed.triangles()), (four.boundary(), four.triangles()));
    assert!(renamed.groups().contains(&"Contact_1") && four.groups().contains(&"contact"));
    let out_of_plane = L_SHAPE_2.replacen("\n1 0 0 0\n", "\n1 0 0 0.5\n", 1);
    let Err(Error::AtLine { line, cause, .. }) = parse_msh(&out_of_plane) else {
        panic!("not in a plane")
    };
    assert!(out_of_plane.lines().nth(line - 1).is_some_and(|line| !line.is_empty()), "line {line}");
    assert!(matches!(*cause, Error::Toolkit(ToolkitError::Node { .. })), "{cause}");
}

fn problem(mesh: &Triangulation, load: &Field<'_>) -> ContactProblem {
    let none = vec![0.0; mesh.nodes().len() * 2];
    let mut problem = ContactProblem::new(mesh.clone(), elastic(), &none).unwrap();
    problem.add_volume_load(load, &Cubature::new(4).unwrap()).unwrap();
    problem
}

fn solved(mesh: &Triangulation, load: &Field<'_>) -> [ContactSolution; 2] {
    let problem = problem(mesh, load);
    [Solver::ActiveSet, Solver::InteriorPoint]
        .map(|solver| problem.solve(Cone::Nodal, solver).unwrap())
}

#[test]
fn a_slanted_floor_is_a_turned_one() {
    // The L turned back by 20 degrees stands on a horizontal floor; its load turns with it.
    let slanted = parse_msh(L_SHAPE).unwrap();
    let (sin, cos) = 20_f64.to_radians().sin_cos();
    let level = slanted.clone().mapped(|[x, y]| [cos * x + sin * y, cos * y - sin * x]).unwrap();
    let f = |[x, y]: [f64; 2]| [0.15 * x, 0.2 - 0.3 * x + 0.1 * y];
    let g = |[x, y]: [f64; 2]| {
        let [a, b] = f([cos * x - sin * y, sin * x + cos * y]);
        [cos * a + sin * b, cos * b - sin * a]
    };
    let one = solved(&slanted, &Field::Vector(&f));
    let other = solved(&level, &Field::Vector(&g));
    assert!(ContactEdge::of(&level).unwrap().normal().unwrap()[1] < -1.0 + SUMS);
    for (a, b) in one.iter().zip(&other) {
        assert!((a.energy / b.energy - 1.0).abs() < SUMS && a.contact_set == b.contact_set);
        for (u, v) in a.normal_displacement.iter().zip(&b.normal_displacement) {
            assert!((u - v).abs() < SUMS, "{u} {v}");
        }
        for (p, q) in a.pressure.iter().zip(&b.pressure) {
            assert!((p - q).abs() < 10.0 * SUMS, "{p} {q}");
        }
    }
    // A planted fault: the load does not turn.
    let wrong = solved(&level, &Field::Vector(&f));
    assert!((wrong[0].energy / one[0].energy - 1.0).abs() > 1e-3);
}

#[test]
fn two_contact_edges_have_two_normals() {
    let mesh = parse_msh(GROOVE).unwrap();
    let edge = ContactEdge::in_pieces(&mesh).unwrap();
    assert!(ContactEdge::of(&mesh).is_err() && edge.pieces().len() == 2);
    let form = elastic();
    let load = |[x, y]: [f64; 2]| [0.2 * y, -0.5 - 0.3 * x];
    let problem = problem(&mesh, &Field::Vector(&load));
    let by_sets = problem.solve(Cone::Nodal, Solver::ActiveSet).unwrap();
    let by_barrier = problem.solve(Cone::Nodal, Solver::InteriorPoint).unwrap();
    assert!((by_sets.energy / by_barrier.energy - 1.0).abs() < 1e-8);
    assert!(by_sets.kkt.worst() < SUMS && by_sets.balance < SUMS, "{:?}", by_sets.kkt);
    // The conditions once more, in Cartesian components: ∫ σ(u_h) ∇φ_i − ∫ f φ_i is the force of the floors, along the
    // normals. f φ_i is of degree two: its integral is a third of the area times the sum over the midpoints of the sides.
    let mut rest = vec![0.0; by_sets.displacement.len()];
    let stress = stresses(&mesh, &form, &by_sets.displacement).unwrap();
    for (nodes, s) in mesh.triangles().iter().zip(&stress) {
        let p = nodes.map(|node| mesh.nodes()[node]);
        let twice =
            (p[1][0] - p[0][0]) * (p[2][1] - p[0][1]) - (p[2][0] - p[0][0]) * (p[1][1] - p[0][1]);
        for k in 0..3 {
            let (a, b) = (p[(k + 1) % 3], p[(k + 2) % 3]);
            // twice the area times ∇φ_k
            let slope = [a[1] - b[1], b[0] - a[0]];
            let force = [s.xx * slope[0] + s.xy * slope[1], s.xy * slope[0] + s.yy * slope[1]];
            let middle = |q: [f64; 2]| load([0.5 * (p[k][0] + q[0]), 0.5 * (p[k][1] + q[1])]);
            let (f, g) = (middle(a), middle(b));
            for c in 0..2 {
                rest[2 * nodes[k] + c] += 0.5 * force[c] - twice * (f[c] + g[c]) / 12.0;
            }
        }
    }
    let (lengths, normals) = (edge.nodal_lengths(), edge.normals().unwrap());
    assert!((normals[0][0] + normals[1][0]).abs() > 1e-3, "the two slopes differ");
    let mut pushed = [0, 0];
    for (number, piece) in edge.pieces().into_iter().enumerate() {
        for i in piece {
            let node = edge.nodes()[i];
            let u = [by_sets.displacement[2 * node], by_sets.displacement[2 * node + 1]];
            let inward = u[0] * normals[number][0] + u[1] * normals[number][1];
            assert!(inward < SUMS && (inward - by_sets.normal_displacement[i]).abs() < SUMS);
            assert!(by_sets.pressure[i] * inward > -SUMS && by_sets.pressure[i] >= 0.0);
            pushed[number] += usize::from(by_sets.pressure[i] > 0.0);
            for k in 0..2 {
                rest[2 * node + k] += by_sets.pressure[i] * lengths[i] * normals[number][k];
            }
        }
    }
    assert!(pushed[0] > 0 && pushed[1] > 0, "{pushed:?}");
    let held = mesh.nodes_on(signorini::mesh::Part::Dirichlet);
    for node in (0..held.len()).filter(|&node| !held[node]) {
        assert!(rest[2 * node].abs() < SUMS && rest[2 * node + 1].abs() < SUMS, "{node}");
    }
    // What one chain needs is refused, what elimination can do it does.
    assert!(matches!(
        problem.solve(Cone::Midpoint, Solver::ActiveSet),
        Err(Error::Toolkit(ToolkitError::Incompatible { .. }))
    ));
    let nested = Settings { start: Start::Coarse(&by_sets), ..Settings::default() };
    assert!(problem.contact_mesh().is_err() && problem.solve(Cone::Nodal, nested).is_err());
    let cycles = problem.solve(Cone::Nodal, Solver::Multigrid).unwrap();
    assert_eq!(cycles.energy, by_sets.energy);
    assert_eq!(cycles.multigrid.unwrap().fallback, Some(Fallback::SeveralEdges));
}

#[test]
fn contact_edges_that_meet_are_refused() {
    // The free bottom of the groove becomes contact, too: one bent chain.
    let bent = GROOVE.replace("\"free\"", "\"contact\"");
    let mesh = parse_msh(&bent).unwrap();
    let none = vec![0.0; 2 * mesh.nodes().len()];
    assert!(matches!(
        ContactProblem::new(mesh, elastic(), &none),
        Err(Error::Toolkit(ToolkitError::Edge { .. }))
    ));
}

fn outcome(options: &Options) -> Result<Outcome, String> {
    section_2_own_body::outcome(options).map_err(|error| error.to_string())
}

#[test]
fn bad_bodies_are_refused_in_one_clear_line() {
    let mesh = Some(repository("examples/data/l_shape.msh"));
    let load = |load: &str| Options { load: load.to_owned(), ..Default::default() };
    for (options, why) in [
        (load("z, 0"), "unknown name 'z': expected x, y, pi"),
        (load("sin x, 0"), "needs its argument in parentheses"),
        (load("x y, 0"), "operator missing"),
        (load("1, 2, 3"), "3 components"),
        (Options { mesh, ..Default::default() }, "--mesh requires --load"),
        (load("ln(x - 1), 0"), "load is not finite: NaN at ("),
        (load("0, 1/(x - x)"), "load is not finite: inf at ("),
        (
            Options { traction: "0, 1/(x - x)".to_owned(), ..Default::default() },
            "traction is not finite: inf at (",
        ),
        (
            Options { displacement: "0, ln(-1)".to_owned(), ..Default::default() },
            "prescribed displacement is not finite: NaN at (",
        ),
        (
            Options { gap: "sqrt(-1)".to_owned(), ..Default::default() },
            "gap is not finite: NaN at (",
        ),
        (Options { poisson: "0.5".to_owned(), ..Default::default() }, "Poisson's ratio"),
        (
            Options { young: "1, 2".to_owned(), ..Default::default() },
            "by physical surface: body=..",
        ),
        (
            Options { young: "rim=2".to_owned(), ..Default::default() },
            "no region 'rim': the mesh has body",
        ),
        (Options { young: "two".to_owned(), ..Default::default() }, "'two' is not a finite number"),
        (
            Options { traction: "top=0, 1".to_owned(), ..Default::default() },
            "no free boundary group 'top': it has free",
        ),
        (Options { gap: "0, 1".to_owned(), ..Default::default() }, "2 components, expected one"),
        (Options { gap: "0; 1".to_owned(), ..Default::default() }, "given twice everywhere"),
        // A semicolon in place of the comma made the problem scalar.
        (load("0; -1"), "--load: given twice everywhere: components are separated by a comma"),
        (
            Options { displacement: "1".to_owned(), ..load("0, 1") },
            "--displacement: what is given has 1 component, expected 2 as --load has: 0 is \"0, 0\"",
        ),
        (
            Options { traction: "free=1".to_owned(), ..load("0, 1") },
            "--traction: that of 'free' has 1 component, expected 2",
        ),
        (Options { young: "2e11".to_owned(), ..load("-1") }, "--young: a load of one component"),
        (Options { plane_stress: true, ..load("-1") }, "--plane-stress: a load of one component"),
        (
            Options { levels: 2, tolerance: "5%".to_owned(), ..Default::default() },
            "--levels: with --tolerance the program chooses the meshes",
        ),
        (Options { unknowns: 500, ..Default::default() }, "--unknowns: limits the meshes of"),
        (load("x<1, 0"), "--load: expression 'x<1': unknown character '<'"),
        (
            Options { traction: "free=0, z".to_owned(), ..Default::default() },
            "--traction: expression 'z': unknown name 'z'",
        ),
        (Options { tolerance: "0".to_owned(), ..Default::default() }, "such as 1% or 0.01"),
        (Options { mesh: Some("no/such.msh".into()), ..load("0, 1") }, "no/such.msh"),
    ] {
        let error = outcome(&options).expect_err(why);
        assert!(error.contains(why) && !error.contains('\n'), "{error}");
    }
}

#[test]
fn a_mesh_without_a_clamp_or_a_floor_is_refused_with_what_to_do() {
    let directory = std::env::temp_dir().join(format!("signorini-groups-{}", std::process::id()));
    std::fs::create_dir_all(&directory).unwrap();
    let body = directory.join("body.msh");
    for (group, why) in [
        (
            "clamped",
            "no curve is clamped: add Physical Curve(\"clamped\") = {..}, or choose one by \
             --displacement \"NAME=0, 0\"; the groups are contact, free",
        ),
        (
            "contact",
            "no curve is in contact: add Physical Curve(\"contact\") = {..}, or choose one by \
             --gap NAME=0; the groups are free, clamped",
        ),
    ] {
        std::fs::write(&body, L_SHAPE.replace(&format!("\"{group}\""), "\"free\"")).unwrap();
        let options =
            Options { mesh: Some(body.clone()), load: "0, 1".to_owned(), ..Default::default() };
        let error = outcome(&options).unwrap_err();
        assert!(error.contains(why), "{error}");
    }
    std::fs::remove_dir_all(&directory).unwrap();
}

#[test]
fn the_file_holds_the_contact_edges() {
    let directory = std::env::temp_dir().join(format!("signorini-own-{}", std::process::id()));
    let options = Options {
        mesh: Some(repository("examples/data/groove.msh")),
        load: "0.2*y, -0.5 - 0.3*x".to_owned(),
        levels: 2,
        files: Some(directory.clone()),
        ..Default::default()
    };
    let found = outcome(&options).unwrap();
    let text = std::fs::read_to_string(directory.join("contact_edge.csv")).unwrap();
    let mut rows = text.lines();
    assert_eq!(rows.next(), Some("edge,s,x,y,u_N,sigma_N,floor"));
    let rows: Vec<(&str, &str)> = rows.map(|row| row.rsplit_once(',').unwrap()).collect();
    let floor = |edge: &str| rows.iter().find(|(row, _)| row.starts_with(edge)).unwrap().1;
    assert_eq!([floor("1,"), floor("2,")], ["contact right", "contact left"]);
    let numbers: Vec<Vec<f64>> = rows
        .iter()
        .map(|(row, _)| row.split(',').map(|word| word.parse().unwrap()).collect())
        .collect();
    assert!(numbers.iter().all(|row| row.len() == 6 && row[4] <= 1e-12 && row[5] <= 0.0));
    // The trapezoidal rule of sigma_N on each edge gives the force of the floors back.
    let mut force = 0.0;
    for pair in numbers.windows(2).filter(|pair| pair[0][0] == pair[1][0]) {
        force -= 0.5 * (pair[1][1] - pair[0][1]) * (pair[0][5] + pair[1][5]);
    }
    let expected = found.numbers("force")[1];
    assert!((force / expected - 1.0).abs() < 1e-9, "{force} {expected}");
    assert_eq!(numbers.iter().filter(|row| row[1] == 0.0).count(), 2, "two edges begin");
    std::fs::remove_dir_all(&directory).unwrap();
}

#[test]
fn two_floors_to_a_tolerance_fit_on_a_screen_by_name() {
    let options = Options {
        mesh: Some(repository("examples/data/groove.msh")),
        load: "0.02*y, -0.05 - 0.03*x".to_owned(),
        tolerance: "30%".to_owned(),
        ..Default::default()
    };
    let text = outcome(&options).unwrap().text(false);
    assert!(text.lines().all(|line| line.chars().count() <= 100), "{text}");
    // One interval for every floor, by its name, and the balance of forces.
    for floor in ["contact left", "contact right"] {
        let line = format!("guaranteed: the contact force of {floor} is in ");
        assert!(text.contains(&line), "{text}");
    }
    assert!(text.contains("✓ resultant of load and reactions, scaled"), "{text}");
    // What ends early says what allows more.
    let options = Options { tolerance: "1%".to_owned(), unknowns: 400, ..options };
    let text = outcome(&options).unwrap().text(false);
    assert!(text.contains("not reached with 400 unknowns: --unknowns allows more"), "{text}");
}

#[test]
fn a_load_of_one_component_is_announced_as_scalar() {
    let options = Options { load: "-1".to_owned(), levels: 1, ..Default::default() };
    let text = outcome(&options).unwrap().text(false);
    assert!(text.contains("one component: the scalar problem −Δu = f"), "{text}");
}
