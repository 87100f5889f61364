//! Meshes from outside: what is wrong is named, what is right is read, nothing panics.

use signorini::Error;
use signorini::ToolkitError;
use signorini::cone::Cone;
use signorini::contact::ContactProblem;
use signorini::fem::{Form, Lame};
use signorini::mesh::{
    BoundaryEdge, Part, SideParts, Triangulation, mapped_grid, parse_msh, read_msh, unit_square,
};

/// Two squares of unit size side by side, each in two triangles; node 20 is a point of the geometry only.
const GOOD: &str = include_str!("../data/two_squares.msh");

fn elastic() -> Form {
    Form::elastic(Lame::new(1.0, 1.0).unwrap())
}

#[test]
fn gmsh_faults_are_named() {
    let faults = [
        ("4.1 0 8", "2.2 0 8"),
        ("4.1 0 8", "4.1 1 8"),
        ("4.1 0 8", "4.1 2 8"),
        ("1 7 1 20\n2 1 0 7", "1 8 1 20\n2 1 0 7"),
        ("8 1 2 5", "8 1 2 9"),
        ("8 1 2 5", "8 1 2 2"),
        ("8 1 2 5", "8 1 2"),
        ("2 1 2 2\n8", "2 1 3 2\n8"),
        ("\"Contact\"", "\"Obstacle\""),
        ("1 0 0 0 2 0 0 1 3 2 20 -20", "1 0 0 0 2 0 0 0 2 20 -20"),
        ("0 1 0\n1 1 0", "0 1 0\nnan 1 0"),
        ("7 11 1 11", "7 10 1 11"),
        ("$EndNodes", "$EndElements"),
        ("5\n6\n20", "5\n5\n20"),
    ];
    for (good, bad) in faults {
        let text = GOOD.replacen(good, bad, 1);
        assert_ne!(text, GOOD, "{good} does not occur");
        assert!(parse_msh(&text).is_err(), "{bad} was accepted");
    }
    // A triangle without area: its line, and its number in the file.
    let flat = GOOD.replacen("1 1 0\n2 1 0", "1 0 0\n2 1 0", 1);
    let Err(Error::AtLine { line, cause, .. }) = parse_msh(&flat) else { panic!("{flat}") };
    assert_eq!(flat.lines().nth(line - 1), Some("8 1 2 5"));
    assert!(
        matches!(*cause, Error::Toolkit(ToolkitError::Triangle { triangle: 8, .. })),
        "{cause}"
    );
    // Listed in the other direction it is turned; folded over its neighbour it is not.
    let (read, good) =
        (parse_msh(GOOD.replacen("8 1 2 5", "8 1 5 2", 1)).unwrap(), parse_msh(GOOD).unwrap());
    assert_eq!(read.triangles(), good.triangles());
    assert_eq!(read.remarks(), ["1 of 4 triangles is listed clockwise and was turned"]);
    let folded = parse_msh(GOOD.replacen("0 1 0\n1 1 0", "3 1 0\n1 1 0", 1)).unwrap_err();
    assert!(folded.to_string().contains("overlap"), "{folded}");
    assert!(matches!(parse_msh(""), Err(Error::Syntax { .. })));
    assert!(matches!(read_msh("no/such/file.msh"), Err(Error::File { .. })));
}

#[test]
fn problems_that_hang_in_the_air_are_errors() {
    let load = |mesh: &Triangulation| vec![1.0; 2 * mesh.nodes().len()];
    let free = SideParts { top: Part::Neumann, ..SideParts::HANGING };
    let mesh = unit_square(3, free).unwrap();
    let values = load(&mesh);
    assert!(matches!(
        ContactProblem::new(mesh.clone(), elastic(), &values),
        Err(Error::Toolkit(ToolkitError::CountOutOfRange { name: "Dirichlet edges", .. }))
    ));
    // The floor alone holds a membrane that is pressed onto it, and not one that is lifted.
    let scalar = |load: &[f64]| {
        let problem = ContactProblem::new(mesh.clone(), Form::LAPLACE, load)?;
        problem.solve(Cone::Nodal, signorini::contact::Solver::ActiveSet)
    };
    assert!(scalar(&values[..16]).is_ok() && scalar(&[-1.0; 16]).is_err());
    let reaction = Form::Scalar { reaction: 1.0 };
    assert!(ContactProblem::new(mesh.clone(), reaction, &values[..16]).is_ok());
    assert!(
        ContactProblem::new(
            unit_square(3, SideParts::HANGING).unwrap(),
            Form::Scalar { reaction: -1.0 },
            &[0.0; 16]
        )
        .is_err()
    );

    let bent =
        mapped_grid(4, 2, SideParts::HANGING, |[x, y]| [x, y - 0.2 * (1.0 - y) * x * x]).unwrap();
    let values = load(&bent);
    assert!(matches!(
        ContactProblem::new(bent, elastic(), &values),
        Err(Error::Toolkit(ToolkitError::Edge { .. }))
    ));

    let none = unit_square(2, SideParts { bottom: Part::Neumann, ..SideParts::HANGING }).unwrap();
    let values = load(&none);
    assert!(matches!(
        ContactProblem::new(none, elastic(), &values),
        Err(Error::Toolkit(ToolkitError::CountOutOfRange { name: "contact edges", .. }))
    ));
}

#[test]
fn a_body_that_nothing_holds_is_named_before_any_factorization() {
    let held = unit_square(4, SideParts::HANGING).unwrap();
    let count = held.nodes().len();
    let mut nodes = held.nodes().to_vec();
    nodes.extend(held.nodes().iter().map(|&[x, y]| [x + 3.0, y]));
    let mut triangles = held.triangles().to_vec();
    triangles.extend(held.triangles().iter().map(|t| t.map(|node| node + count)));
    let mut boundary = held.boundary().to_vec();
    boundary.extend(held.boundary().iter().map(|edge| BoundaryEdge {
        nodes: edge.nodes.map(|node| node + count),
        part: Part::Neumann,
    }));
    let mesh = Triangulation::new(&nodes, &triangles, &boundary).unwrap();
    let load = vec![1.0; 2 * mesh.nodes().len()];
    for (form, values) in [(elastic(), &load[..]), (Form::LAPLACE, &load[..2 * count])] {
        let failed = ContactProblem::new(mesh.clone(), form, values).unwrap_err();
        assert_eq!(failed, Error::NotHeld { triangles: 32, node: 25, place: [3.0, 0.0] });
        assert!(
            failed
                .to_string()
                .contains("the body of 32 triangles with node 25 at (3, 0) has no edge")
        );
    }
    // A reaction term holds it.
    assert!(ContactProblem::new(mesh, Form::Scalar { reaction: 1.0 }, &load[..2 * count]).is_ok());
}

#[test]
fn nodes_of_a_file_are_called_by_its_numbers() {
    let of = |text: &str| match parse_msh(text) {
        Err(Error::AtLine { cause, .. }) => *cause,
        Ok(mesh) => ContactProblem::new(mesh, elastic(), &[0.0; 12]).unwrap_err(),
        Err(other) => other,
    };
    let edge = |text: &str| match of(text) {
        Error::Toolkit(ToolkitError::Edge { nodes, .. }) => nodes,
        other => panic!("{other}"),
    };
    // The bottom has no label: its first edge is that of nodes 1 and 2 of the file, 0 and 1 in the mesh.
    let unlabelled = GOOD.replacen("1 0 0 0 2 0 0 1 3 2 20 -20", "1 0 0 0 2 0 0 0 2 20 -20", 1);
    let said = of(&unlabelled).to_string();
    assert!(said.starts_with("msh, line 44: edge 1-2 from (0, 0) to (1, 0) is on"), "{said}");
    // Node 3 of the file is off the line: node 2 leaves that from 1 to 3, found when the problem is made.
    let bent = GOOD.replacen("1 0 0\n2 0 0", "1 0 0\n2 -0.25 0", 1);
    assert_eq!(edge(&bent), [1, 2]);
    // A second triangle, of the nodes 10, 30 and 20, that no edge holds.
    let text = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n\
         $PhysicalNames\n3\n1 1 \"contact\"\n1 2 \"free\"\n1 3 \"clamped\"\n$EndPhysicalNames\n\
         $Nodes\n6\n3 0 0 0\n5 1 0 0\n7 0 1 0\n10 4 0 0\n20 4 1 0\n30 5 0 0\n$EndNodes\n\
         $Elements\n8\n1 1 2 1 1 3 5\n2 1 2 2 2 5 7\n3 1 2 3 3 7 3\n4 2 2 0 1 3 5 7\n\
         5 1 2 2 2 10 30\n6 1 2 2 2 30 20\n7 1 2 2 2 20 10\n8 2 2 0 1 10 30 20\n$EndElements\n";
    assert_eq!(of(text), Error::NotHeld { triangles: 1, node: 10, place: [4.0, 0.0] });
}

#[test]
fn a_bad_entry_of_an_edge_is_named_by_its_index() {
    use signorini::cone::ContactSet;
    use signorini::edge::{EdgeTrace, radial_intervals};
    let trace = |x: Vec<f64>, y: Vec<f64>| EdgeTrace::new(&x, &y, &[0.0; 2], 0.0).map(drop);
    let set = ContactSet::new(&[true, false, true]);
    let not_finite = trace(vec![0.0, f64::NAN], vec![0.0; 2]);
    assert!(matches!(not_finite, Err(Error::Toolkit(ToolkitError::NotFinite { index: 1, .. }))));
    let found = [
        (1, 0.5, trace(vec![0.0, 1.0], vec![0.0, 0.5])),
        (2, 1.0, radial_intervals(&[0.0, 2.0, 1.0], &set).map(drop)),
    ];
    for (at, bad, result) in found {
        let named = matches!(result, Err(Error::Toolkit(ToolkitError::EntryOutOfRange { index, value, .. }))
            if index == at && value == bad);
        assert!(named, "{at}");
    }
}

#[test]
fn a_segment_constant_refused_carries_its_best_value() {
    use signorini::proof::one_gap_ratio;
    let ratio = |asked: f64| one_gap_ratio(Cone::Nodal, 0.25, 0.3, asked);
    let (met, best) = (ratio(0.02).unwrap(), ratio(1e-15).unwrap_err().best().unwrap());
    assert!((best.value - met.value).abs() <= best.error + met.error, "{best} {met}");
}
