//! Mesh files as people bring them: what is read gives the body of the reference bit by bit, what is not is refused
//! with what to do, as the table of the page says.

use crate::common::SplitMix;
use signorini::Error;
use signorini::cone::Cone;
use signorini::contact::{ContactProblem, Solver};
use signorini::fem::{Cubature, Field, Form, Lame};
use signorini::mesh::{Hierarchy, Part, Triangulation, parse_msh, parse_msh_with};
use std::fmt::Write as _;

/// The page with the table.
const PAGE: &str = include_str!("../../book/src/your_own_body.md");
const BEGIN: &str = "| file | what happens |\n| --- | --- |\n";

/// A block of two surfaces, in contact at one half of its bottom, clamped on its left.
const NODES: [[f64; 2]; 8] = [
    [0.0, 0.0],
    [1.0, 0.0],
    [2.0, 0.0],
    [2.0, 1.0],
    [1.0, 1.0],
    [0.0, 1.0],
    [0.5, 0.5],
    [1.5, 0.5],
];
/// Group, curve, nodes.
const LINES: [[i32; 4]; 6] =
    [[1, 1, 1, 2], [2, 2, 2, 3], [3, 3, 3, 4], [3, 4, 4, 5], [3, 5, 5, 6], [2, 6, 6, 1]];
/// Surface, nodes.
const TRIANGLES: [[i32; 4]; 8] = [
    [1, 1, 2, 7],
    [1, 6, 1, 7],
    [1, 2, 5, 7],
    [1, 5, 6, 7],
    [2, 2, 3, 8],
    [2, 5, 2, 8],
    [2, 3, 4, 8],
    [2, 4, 5, 8],
];
const NAMES: &str = "1 1 \"contact\"\n1 2 \"clamped\"\n1 3 \"free\"\n2 5 \"body\"\n";
const BODY: i32 = 5;

/// How a file is written.
#[derive(Clone, Copy)]
struct How {
    version: &'static str,
    binary: bool,
    /// Bytes of a number in the order of the other kind of machine.
    swapped: bool,
    parametric: bool,
    /// Each surface is a part, and a part has a group of its own, too.
    partitioned: bool,
    /// Triangles of six nodes and lines of three.
    second_order: bool,
}

const TEXT: How = How {
    version: "4.1",
    binary: false,
    swapped: false,
    parametric: false,
    partitioned: false,
    second_order: false,
};

/// A file in text or in binary.
struct File {
    bytes: Vec<u8>,
    how: How,
}

impl File {
    fn text(&mut self, text: &str) {
        self.bytes.extend_from_slice(text.as_bytes());
    }

    fn number<const N: usize>(&mut self, mut bytes: [u8; N], text: &str) {
        if !self.how.binary {
            return self.text(&format!("{text} "));
        }
        if self.how.swapped {
            bytes.reverse();
        }
        self.bytes.extend(bytes);
    }

    fn ints(&mut self, values: &[i32]) {
        values.iter().for_each(|value| self.number(value.to_ne_bytes(), &value.to_string()));
    }

    fn sizes(&mut self, values: &[usize]) {
        values
            .iter()
            .for_each(|&value| self.number((value as u64).to_ne_bytes(), &value.to_string()));
    }

    fn reals(&mut self, values: &[f64]) {
        values.iter().for_each(|value| self.number(value.to_ne_bytes(), &value.to_string()));
    }

    /// The end of a line of text.
    fn line(&mut self) {
        if !self.how.binary {
            self.text("\n");
        }
    }
}

/// The block in a file.
fn written(how: How) -> Vec<u8> {
    let mut file = File { bytes: Vec::new(), how };
    file.text(&format!("$MeshFormat\n{} {} 8\n", how.version, i32::from(how.binary)));
    if how.binary {
        file.ints(&[1]);
        file.text("\n");
    }
    let names = if how.version == "2.0" {
        NAMES.replace("\n1 ", "\n").replace("\n2 5", "\n5")
    } else {
        NAMES.into()
    };
    let names = if how.version == "2.0" { names.replacen("1 1", "1", 1) } else { names };
    let part = if how.partitioned { "2 6 \"_part{1}_physical{5}_dim{2}_tag{1}\"\n" } else { "" };
    let count = 4 + usize::from(how.partitioned);
    file.text(&format!(
        "$EndMeshFormat\n$PhysicalNames\n{count}\n{names}{part}$EndPhysicalNames\n"
    ));
    match how.version.starts_with('4') {
        true => write_blocks(&mut file),
        false => write_lists(&mut file),
    }
    file.bytes
}

/// All nodes of an element: the corners, then the middles of the sides.
fn nodes_of(corners: &[i32], how: How) -> Vec<i32> {
    let middle = |k: usize| {
        let (a, b) = (corners[k], corners[(k + 1) % corners.len()]);
        100 + 10 * a.min(b) + a.max(b)
    };
    let sides = if corners.len() == 2 { 1 } else { 3 };
    corners.iter().copied().chain((0..sides).filter(|_| how.second_order).map(middle)).collect()
}

/// Numbers and places of all nodes.
fn all_nodes(how: How) -> Vec<(i32, [f64; 3])> {
    let mut all: Vec<(i32, [f64; 3])> = (1..).zip(NODES.map(|[x, y]| [x, y, 0.0])).collect();
    if how.second_order {
        let mut middles: Vec<i32> = TRIANGLES
            .iter()
            .flat_map(|[_, corners @ ..]| nodes_of(corners, how)[3..].to_vec())
            .collect();
        middles.sort_unstable();
        middles.dedup();
        let half = |k: i32| {
            let [p, q] = [(k - 100) / 10, (k - 100) % 10].map(|node| NODES[node as usize - 1]);
            (k, [0.5 * (p[0] + q[0]), 0.5 * (p[1] + q[1]), 0.0])
        };
        all.extend(middles.into_iter().map(half));
    }
    all
}

fn write_blocks(file: &mut File) {
    let how = file.how;
    let is_old = how.version == "4.0";
    let bounding_box = [0.0, 0.0, 0.0, 2.0, 1.0, 0.0];
    let entity = |file: &mut File, head: &[i32], groups: &[i32]| {
        file.ints(head);
        file.reals(&bounding_box);
        file.sizes(&[groups.len()]);
        file.ints(groups);
        file.sizes(&[1]);
        file.ints(&[1]);
        file.line();
    };
    file.text("$Entities\n");
    file.sizes(&[1, 6, 2, 0]);
    file.line();
    file.ints(&[1]);
    file.reals(&bounding_box[..if is_old { 6 } else { 3 }]);
    file.sizes(&[0]);
    file.line();
    LINES.iter().for_each(|[group, curve, ..]| entity(file, &[*curve], &[*group]));
    [1, 2].iter().for_each(|surface| entity(file, &[*surface], &[BODY]));
    file.text(if how.binary { "\n$EndEntities\n" } else { "$EndEntities\n" });
    if how.partitioned {
        file.text("$PartitionedEntities\n");
        file.sizes(&[2]);
        file.line();
        file.sizes(&[1]);
        file.line();
        file.ints(&[9, 1]);
        file.line();
        file.sizes(&[0, 6, 2, 0]);
        file.line();
        // Tag, dimension and tag of what it is a part of, one partition; pieces of curves name no group themselves.
        for [group, curve, ..] in LINES {
            let part = |file: &mut File| {
                file.ints(&[10 + curve, 1, curve]);
                file.sizes(&[1]);
            };
            part(file);
            entity(file, &[1], if curve % 2 == 0 { &[] } else { std::slice::from_ref(&group) });
        }
        for surface in [1, 2] {
            file.ints(&[10 + surface, 2, surface]);
            file.sizes(&[1]);
            entity(file, &[surface], if surface == 1 { &[BODY, 6] } else { &[BODY] });
        }
        file.text(if how.binary {
            "\n$EndPartitionedEntities\n"
        } else {
            "$EndPartitionedEntities\n"
        });
    }
    let offset = if how.partitioned { 10 } else { 0 };
    let blocks = |file: &mut File, counts: &[usize]| {
        file.sizes(counts);
        file.line();
    };
    let block = |file: &mut File, [dimension, tag, kind]: [i32; 3], count: usize| {
        let head = if is_old { [tag, dimension, kind] } else { [dimension, tag, kind] };
        file.ints(&head);
        file.sizes(&[count]);
        file.line();
    };
    let nodes = all_nodes(how);
    let count = nodes.len();
    file.text("$Nodes\n");
    blocks(file, &[1, count, 1, 300][..if is_old { 2 } else { 4 }]);
    block(file, [2, 1 + offset, i32::from(how.parametric)], count);
    let place = |file: &mut File, [x, y, z]: [f64; 3]| {
        file.reals(&[x, y, z, x, y][..if how.parametric { 5 } else { 3 }]);
        file.line();
    };
    if is_old {
        for (tag, at) in nodes {
            file.ints(&[tag]);
            place(file, at);
        }
    } else {
        for &(tag, _) in &nodes {
            file.sizes(&[tag as usize]);
            file.line();
        }
        nodes.iter().for_each(|&(_, at)| place(file, at));
    }
    file.text(if how.binary { "\n$EndNodes\n$Elements\n" } else { "$EndNodes\n$Elements\n" });
    blocks(file, &[8, 14, 1, 14][..if is_old { 2 } else { 4 }]);
    let element = |file: &mut File, tag: usize, corners: &[i32]| {
        let all: Vec<i32> = [tag as i32].into_iter().chain(nodes_of(corners, how)).collect();
        match is_old {
            true => file.ints(&all),
            false => all.iter().for_each(|&number| file.sizes(&[number as usize])),
        }
        file.line();
    };
    let kinds = if how.second_order { [8, 9] } else { [1, 2] };
    for (k, [_, curve, corners @ ..]) in LINES.iter().enumerate() {
        block(file, [1, *curve + offset, kinds[0]], 1);
        element(file, k + 1, corners);
    }
    for (surface, four) in [1, 2].into_iter().zip(TRIANGLES.chunks(4)) {
        block(file, [2, surface + offset, kinds[1]], 4);
        for (k, [_, corners @ ..]) in four.iter().enumerate() {
            element(file, 7 + 4 * (surface as usize - 1) + k, corners);
        }
    }
    file.text(if how.binary { "\n$EndElements\n" } else { "$EndElements\n" });
}

fn write_lists(file: &mut File) {
    let how = file.how;
    let section = if how.parametric { "ParametricNodes" } else { "Nodes" };
    let nodes = all_nodes(how);
    file.text(&format!("${section}\n{}\n", nodes.len()));
    for (tag, [x, y, z]) in nodes {
        file.ints(&[tag]);
        file.reals(&[x, y, z]);
        if how.parametric {
            // Dimension and tag of its entity, then parameters: here nodes of both surfaces, and one of a point.
            file.ints(if tag == 1 { &[0, 1] } else { &[2, 1] });
            file.reals(&[x, y][..if tag == 1 { 0 } else { 2 }]);
        }
        file.line();
    }
    let end = if how.binary { "\n" } else { "" };
    file.text(&format!("{end}$End{section}\n$Elements\n14\n"));
    let kinds = if how.second_order { [8, 9] } else { [1, 2] };
    let tags = |group: i32, entity: i32| match how.partitioned {
        true => vec![group, entity, 1, entity],
        false => vec![group, entity],
    };
    let lines = LINES
        .iter()
        .map(|[group, curve, corners @ ..]| (kinds[0], tags(*group, *curve), &corners[..]));
    let triangles =
        TRIANGLES.iter().map(|[of, corners @ ..]| (kinds[1], tags(BODY, *of), &corners[..]));
    for (k, (kind, tags, corners)) in (1..).zip(lines.chain(triangles)) {
        match how.binary {
            true => file.ints(&[kind, 1, tags.len() as i32, k]),
            false => file.ints(&[k, kind, tags.len() as i32]),
        }
        file.ints(&tags);
        file.ints(&nodes_of(corners, how));
        file.line();
    }
    file.text(&format!("{end}$EndElements\n"));
}

/// J of the block under a load to the lower right, with the nodal cone.
fn energy(mesh: Triangulation) -> f64 {
    let none = vec![0.0; 2 * mesh.nodes().len()];
    let form = Form::elastic(Lame::new(1.0, 1.0).unwrap());
    let mut problem = ContactProblem::new(mesh, form, &none).unwrap();
    let load = |[x, y]: [f64; 2]| [0.1 * y, -0.1 - 0.05 * x];
    problem.add_volume_load(&Field::Vector(&load), &Cubature::new(4).unwrap()).unwrap();
    problem.solve(Cone::Nodal, Solver::ActiveSet).unwrap().energy
}

/// A change of the text of the block in format 4.1, or of another one.
fn changed(text: &str, changes: &[(&str, &str)]) -> Vec<u8> {
    let mut text = text.to_owned();
    for (old, new) in changes {
        assert!(text.contains(old), "'{old}' does not occur");
        text = text.replacen(old, new, 1);
    }
    text.into_bytes()
}

/// Kinds of files, each with one example.
fn files() -> Vec<(&'static str, Vec<u8>)> {
    let of = |version: &'static str| How { version, ..TEXT };
    let text = |how: How| String::from_utf8(written(how)).unwrap();
    let (four, two) = (text(TEXT), text(of("2.2")));
    let shared = |bytes: &[u8]| bytes.to_vec();
    let utf_16: Vec<u8> =
        [0xfeff].into_iter().chain(two.encode_utf16()).flat_map(u16::to_le_bytes).collect();
    let mut cut = written(How { binary: true, ..TEXT });
    cut.truncate(cut.len() - 100);
    let two_groups = [("1 0 0 0 2 1 0 1 1 1 1 ", "1 0 0 0 2 1 0 2 1 3 1 1 ")];
    vec![
        ("4.1", written(TEXT)),
        ("4.1, binary", written(How { binary: true, ..TEXT })),
        (
            "4.1, binary of a machine with the other order of bytes",
            written(How { binary: true, swapped: true, ..TEXT }),
        ),
        ("4.1, parametric nodes", written(How { parametric: true, ..TEXT })),
        ("4.1, parametric nodes, binary", written(How { parametric: true, binary: true, ..TEXT })),
        ("4.1, partitioned", written(How { partitioned: true, ..TEXT })),
        ("4.1, partitioned by Gmsh", shared(include_bytes!("../data/msh/partitioned_41.msh"))),
        ("4.1, partitioned, binary", written(How { partitioned: true, binary: true, ..TEXT })),
        ("4.0", written(of("4.0"))),
        ("4.0, binary", written(How { binary: true, ..of("4.0") })),
        (
            "4.0, parametric, partitioned",
            written(How { parametric: true, partitioned: true, ..of("4.0") }),
        ),
        ("2.2", written(of("2.2"))),
        ("2.2, binary", written(How { binary: true, ..of("2.2") })),
        (
            "2.2, binary of a machine with the other order of bytes",
            written(How { binary: true, swapped: true, ..of("2.2") }),
        ),
        ("2.2, parametric nodes", shared(include_bytes!("../data/msh/parametric_22.msh"))),
        (
            "2.2, parametric nodes, binary",
            written(How { parametric: true, binary: true, ..of("2.2") }),
        ),
        ("2.2, partitioned, binary", written(How { partitioned: true, binary: true, ..of("2.2") })),
        ("2.1", written(of("2.1"))),
        ("2.0", written(of("2.0"))),
        ("with a byte-order mark", [b"\xef\xbb\xbf".to_vec(), written(TEXT)].concat()),
        ("with line ends of Windows", four.replace('\n', "\r\n").into_bytes()),
        (
            "with data and comments",
            [
                written(of("2.2")),
                b"$Comments\nmine\n$EndComments\n$NodeData\n1\n\"u\"\n1\n0.5\n3\n0\n1\n2\n1 0.25\n8 4\n\
                  $EndNodeData\n"
                    .to_vec(),
            ]
            .concat(),
        ),
        (
            "numbers with gaps, in any order",
            changed(
                &two,
                &[
                    ("\n8 1.5 0.5 0 \n", "\n900 1.5 0.5 0 \n"),
                    ("2 3 8 \n", "2 3 900 \n"),
                    ("5 2 8 \n", "5 2 900 \n"),
                    ("3 4 8 \n", "3 4 900 \n"),
                    ("4 5 8 \n", "4 5 900 \n"),
                ],
            ),
        ),
        ("second-order triangles", written(How { second_order: true, ..TEXT })),
        (
            "second-order triangles, 2.2, binary",
            written(How { second_order: true, binary: true, ..of("2.2") }),
        ),
        (
            "triangles in both orientations",
            shared(include_bytes!("../data/msh/mixed_orientation_22.msh")),
        ),
        ("a curve inside with a group", shared(include_bytes!("../data/msh/interface_curve.msh"))),
        ("a Physical Point", shared(include_bytes!("../data/msh/physical_point_clamped.msh"))),
        (
            "a group without elements",
            changed(&two, &[("$PhysicalNames\n4\n", "$PhysicalNames\n5\n1 9 \"hole\"\n")]),
        ),
        (
            "groups in other words",
            two.replace("\"clamped\"", "\"Fixed\"")
                .replace("\"free\"", "\"free_top\"")
                .into_bytes(),
        ),
        ("no Physical Surface", shared(include_bytes!("../data/msh/no_physical_surface.msh"))),
        ("a boundary curve without a group", changed(&two, &[("1 1 2 1 1 1 2", "1 1 2 0 1 1 2")])),
        ("a curve in two groups", changed(&four, &two_groups)),
        // Format 2 lists the elements of a curve or a surface once for each of its groups.
        (
            "a curve in two groups, 2.2",
            changed(&two, &[("\n14\n1 1 2 1 1 1 2 \n", "\n15\n15 1 2 3 1 1 2\n1 1 2 1 1 1 2 \n")]),
        ),
        (
            "a surface in two groups, 2.2",
            changed(
                &two,
                &[
                    ("$PhysicalNames\n4\n", "$PhysicalNames\n5\n2 6 \"skin\"\n"),
                    ("\n14\n1 1 2 1 1 1 2 \n", "\n15\n15 2 2 6 1 1 2 7\n1 1 2 1 1 1 2 \n"),
                ],
            ),
        ),
        (
            "a triangle listed twice",
            changed(&two, &[("\n14\n1 1 2 1 1 1 2 \n", "\n15\n15 2 2 5 1 1 2 7\n1 1 2 1 1 1 2 \n")]),
        ),
        ("a curve with another name", changed(&two, &[("\"free\"", "\"top\"")])),
        (
            "a curve inside called contact",
            changed(
                &String::from_utf8_lossy(include_bytes!("../data/msh/interface_curve.msh")),
                &[("\"interface\"", "\"contact inside\"")],
            ),
        ),
        ("quadrangles", changed(&two, &[("14 2 2 5 2 4 5 8", "14 3 2 5 2 3 4 5 8")])),
        ("a 3-D mesh", changed(&two, &[("14 2 2 5 2 4 5 8", "14 4 2 5 2 3 4 5 8")])),
        ("a body out of its plane", changed(&two, &[("\n7 0.5 0.5 0 ", "\n7 0.5 0.5 0.1 ")])),
        ("a folded mesh", changed(&two, &[("\n8 1.5 0.5 0 ", "\n8 0.8 0.5 0 ")])),
        ("a triangle without area", changed(&two, &[("\n8 1.5 0.5 0 ", "\n8 1.5 0 0 ")])),
        ("a binary file that was cut", cut),
        ("format 1", shared(include_bytes!("../data/msh/format_1.msh"))),
        ("format 3", changed(&two, &[("2.2 0 8", "3 0 8")])),
        ("a mesh of FreeFEM", b"8 8 6\n0 0 1\n1 0 1\n".to_vec()),
        ("a mesh of Fluent", b"(0 \"GAMBIT\")\n".to_vec()),
        ("text in UTF-16", utf_16),
        ("a `.geo` file", b"h = 0.25;\nPoint(1) = {0, 0, 0, h};\n".to_vec()),
        (
            "a `.geo` file that begins with a comment",
            b"// an L\nSetFactory(\"OpenCASCADE\");\n".to_vec(),
        ),
        ("a mesh of Abaqus", b"*Heading\n body\n*NODE\n1, 0, 0, 0\n".to_vec()),
        ("a mesh of Nastran", b"$ Created by Gmsh\nGRID,1,0,0.0,0.0,0.0\nENDDATA\n".to_vec()),
        ("a file of VTK", b"# vtk DataFile Version 2.0\nbody\nASCII\n".to_vec()),
        ("compressed by gzip", b"\x1f\x8b\x08\x08\x00\x01\x02\x03body.msh\x00\xb3\xd6\n".to_vec()),
    ]
}

/// What happens with a file, as the table says it.
fn outcome(bytes: &[u8]) -> String {
    match parse_msh(bytes) {
        Ok(mesh) if mesh.remarks().is_empty() => "read".to_owned(),
        Ok(mesh) => format!("read; {}", mesh.remarks().join("; ")),
        Err(error) => format!("`{error}`"),
    }
}

/// Compares a file that is read, and J on its body, with the copy that `python/tests/test_kinds.py`
/// solves by meshio and SciPy; with the variable SIGNORINI_WRITE_KINDS the copy is written.
fn keep(kind: &str, bytes: &[u8], energy: f64) {
    let name: String = kind.chars().filter(|c| *c != ',').collect();
    let name = name.replace(|c: char| !c.is_alphanumeric() && c != '.', "_");
    let directory = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/msh/kinds");
    let file = |ending: &str| directory.join(format!("{name}.{ending}"));
    if std::env::var_os("SIGNORINI_WRITE_KINDS").is_some() {
        std::fs::write(file("msh"), bytes).unwrap();
        std::fs::write(file("energy"), format!("{energy:?}\n")).unwrap();
    }
    if cfg!(target_endian = "little") {
        let known = std::fs::read(file("msh")).unwrap_or_default();
        assert!(known == bytes, "{kind}: SIGNORINI_WRITE_KINDS=1 writes its copy");
    }
    let known: f64 = std::fs::read_to_string(file("energy")).unwrap().trim().parse().unwrap();
    assert!((energy / known - 1.0).abs() < 1e-14, "{kind}: {energy} {known}");
}

#[test]
fn every_kind_of_file_is_read_or_refused_as_the_page_says() {
    let reference = parse_msh(written(TEXT)).unwrap();
    let (mut table, mut read) = (BEGIN.to_owned(), 0);
    for (kind, bytes) in files() {
        let happens = outcome(&bytes);
        writeln!(table, "| {kind} | {happens} |").unwrap();
        let Ok(mesh) = parse_msh(&bytes) else { continue };
        read += 1;
        keep(kind, &bytes, energy(mesh.clone()));
        assert_eq!(mesh.nodes(), reference.nodes(), "{kind}");
        assert_eq!(mesh.triangles(), reference.triangles(), "{kind}");
        assert_eq!(mesh.region_names(), ["body"], "{kind}");
        let edges = |mesh: &Triangulation| {
            let mut edges: Vec<_> =
                mesh.boundary().iter().map(|edge| (edge.nodes, edge.part as u8)).collect();
            edges.sort_unstable();
            edges
        };
        if !kind.starts_with("a curve inside")
            && ![
                "partitioned by Gmsh",
                "a Physical Point",
                "both orientations",
                "2.2, parametric nodes",
            ]
            .iter()
            .any(|other| kind.ends_with(other))
        {
            assert_eq!(edges(&mesh), edges(&reference), "{kind}");
            assert_eq!(energy(mesh), energy(reference.clone()), "{kind}");
        } else {
            assert!(energy(mesh) < 0.0, "{kind}");
        }
    }
    assert!(read >= 30, "{read}");
    assert!(PAGE.contains(&table), "the table of book/src/your_own_body.md should be\n{table}");
}

#[test]
fn a_file_of_the_shared_cases_is_the_same_block() {
    // In these files the whole bottom is in contact, only the left side is clamped.
    let parts = |bytes: &[u8]| energy(parse_msh(bytes).unwrap());
    let one = parts(include_bytes!("../data/msh/parametric_22.msh"));
    for other in [
        &include_bytes!("../data/msh/partitioned_41.msh")[..],
        include_bytes!("../data/msh/mixed_orientation_22.msh"),
        include_bytes!("../data/msh/interface_curve.msh"),
        include_bytes!("../data/msh/physical_point_clamped.msh"),
    ] {
        assert!((parts(other) / one - 1.0).abs() < 1e-14);
    }
}

#[test]
fn a_curve_inside_is_an_interface_on_every_refinement() {
    let mesh = parse_msh(include_bytes!("../data/msh/interface_curve.msh")).unwrap();
    assert_eq!(mesh.interfaces().len(), 1);
    let mut meshes = Hierarchy::refined(mesh, 2).unwrap();
    meshes.refine_where(|mesh, t| mesh.corners(t).contains(&[1.0, 0.0])).unwrap();
    let fine = meshes.finest();
    let inside = &fine.interfaces()[0];
    assert_eq!(inside.name, "interface");
    let mut length = 0.0;
    for &[a, b] in &inside.edges {
        let ([x, y], [p, q]) = (fine.nodes()[a], fine.nodes()[b]);
        assert_eq!([x, p], [1.0; 2]);
        assert!(fine.triangles().iter().filter(|t| t.contains(&a) && t.contains(&b)).count() == 2);
        length += (q - y).abs();
    }
    assert_eq!((length, inside.edges.len()), (1.0, 5));
}

#[test]
fn parts_are_given_to_groups_with_other_names() {
    let text = String::from_utf8(written(How { version: "2.2", ..TEXT })).unwrap();
    let text = text.replace("\"contact\"", "\"floor\"").replace("\"clamped\"", "\"Wall\"");
    let mesh = |parts: &[(&str, Part)]| parse_msh_with(&text, parts);
    let named = [("floor", Part::Contact), ("wall", Part::Dirichlet)];
    let read = mesh(&named).unwrap();
    assert_eq!(read.groups(), ["floor", "Wall", "free"]);
    assert_eq!(energy(read), energy(parse_msh(written(TEXT)).unwrap()));
    assert!(mesh(&named[..1]).unwrap_err().to_string().contains("boundary part 'Wall'"));
    let wrong = mesh(&[named[0], named[1], ("cieling", Part::Neumann)]).unwrap_err();
    // No line of the file is at fault.
    assert!(matches!(wrong, Error::NoGroup { .. }));
    assert!(
        wrong.to_string().contains("no boundary group 'cieling': it has Wall, floor, free"),
        "{wrong}"
    );
    let wrong = mesh(&[named[0], named[1], ("free", Part::Contact)]).unwrap_err().to_string();
    assert!(wrong.contains("boundary part 'contact for the group free'"), "{wrong}");
    // One curve, two things that act: which of them was meant is not decided by their order.
    let wrong = mesh(&[named[0], named[1], ("Floor", Part::Dirichlet)]).unwrap_err().to_string();
    assert!(wrong.contains("boundary part 'contact and clamped for the group Floor'"), "{wrong}");
    assert!(mesh(&[named[0], named[1], named[0]]).is_ok());
}

#[test]
fn binary_files_with_wrong_bytes_are_read_or_refused_in_one_line() {
    let binary = |how: How| written(How { binary: true, ..how });
    let old = How { version: "2.2", ..TEXT };
    let seeds = [
        binary(TEXT),
        binary(How { partitioned: true, parametric: true, ..TEXT }),
        binary(How { version: "4.0", swapped: true, ..TEXT }),
        binary(old),
        binary(How { parametric: true, second_order: true, ..old }),
    ];
    let mut random = SplitMix::new(54);
    let mut refused = 0;
    for _ in 0..if crate::MANY { 200_000 } else { 5_000 } {
        let mut bytes = seeds[random.below(seeds.len())].clone();
        for _ in 0..=random.below(3) {
            let at = random.below(bytes.len());
            match random.below(4) {
                0 => bytes.truncate(at + 1),
                1 => bytes[at] = random.below(256) as u8,
                2 => bytes[at] ^= 1 << random.below(8),
                _ => drop(bytes.splice(at..(at + 8).min(bytes.len()), [255; 8])),
            }
        }
        if let Err(error) = parse_msh(&bytes) {
            let text = error.to_string();
            assert!(text.lines().count() == 1 && text.len() < 300, "{text}");
            refused += 1;
        }
    }
    assert!(refused > 1000, "{refused}");
}
