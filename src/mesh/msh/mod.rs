//! Reading Gmsh meshes: the formats 2.0, 2.1, 2.2, 4.0 and 4.1 in text or in binary (Gmsh reference manual, sections
//! "MSH file format" and "MSH file format version 2"; format 4.0 as Gmsh 4.0 wrote it).
//!
//! Lines of curves in a physical group become boundary edges, or interfaces if they lie inside the body; triangles the
//! mesh, physical surfaces its regions in ascending order of their tags. Elements of higher order are read by their
//! corners. The boundary condition on a curve is given by the name of its group, case-insensitively, up to the first
//! blank, `_` or `-`:
//!
//! | name | part |
//! | --- | --- |
//! | `clamped`, `fixed`, `dirichlet` | [`Part::Dirichlet`] |
//! | `contact` | [`Part::Contact`] |
//! | `free`, `neumann` | [`Part::Neumann`] |
//!
//! Thus `contact left` and `contact_2` are contact, too. Groups with other names are given with their parts, or lie
//! inside the body. Each curve belongs to at most one group. Nodes in no triangle (points of the geometry) are omitted.
//! All triangles lie in one plane z = const up to rounding; those that are clockwise are turned. What is not used is
//! in [`Triangulation::remarks`]. The result passes the checks of [`Triangulation::new`]. Cost: O(N log N) for N
//! elements; no memory is reserved on the basis of counts in the file.

mod kinds;
mod raw;
mod sections;
mod source;

use self::raw::Raw;
use self::sections::Four;
use self::source::Source;
use crate::error::Result;
use crate::mesh::geometry::Part;
use crate::mesh::triangulation::Triangulation;
use crate::text::{quoted, read_bytes};
use std::collections::BTreeSet;
use std::path::Path;

/// The triangulation in a `.msh` file of Gmsh.
///
/// ```no_run
/// let mesh = signorini::mesh::read_msh("body.msh")?;
/// println!("{} triangles, h = {}", mesh.triangles().len(), mesh.mesh_size());
/// # Ok::<(), signorini::Error>(())
/// ```
///
/// # Errors
/// [`File`](crate::Error::File) if the file cannot be read, and the errors of [`parse_msh`].
pub fn read_msh(path: impl AsRef<Path>) -> Result<Triangulation> {
    read_msh_with(path, &[])
}

/// The triangulation in a `.msh` file of Gmsh, with the boundary parts of groups whose names do not state them.
///
/// ```no_run
/// use signorini::mesh::{Part, read_msh_with};
/// let mesh = read_msh_with("bracket.msh", &[("floor", Part::Contact), ("wall", Part::Dirichlet)])?;
/// # Ok::<(), signorini::Error>(())
/// ```
///
/// # Errors
/// As for [`read_msh`] and [`Triangulation::from_groups`].
pub fn read_msh_with(path: impl AsRef<Path>, parts: &[(&str, Part)]) -> Result<Triangulation> {
    parse_msh_with(&read_bytes(path.as_ref())?, parts)
}

/// The triangulation in the content of a `.msh` file.
///
/// ```
/// let text = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n\
///     $PhysicalNames\n3\n1 1 \"contact\"\n1 2 \"free\"\n1 3 \"clamped\"\n$EndPhysicalNames\n\
///     $Nodes\n3\n1 0 0 0\n2 1 0 0\n3 0 1 0\n$EndNodes\n\
///     $Elements\n4\n1 1 2 1 1 1 2\n2 1 2 2 2 2 3\n3 1 2 3 3 3 1\n4 2 2 0 1 1 2 3\n$EndElements\n";
/// let mesh = signorini::mesh::parse_msh(text)?;
/// assert_eq!((mesh.triangles().len(), mesh.boundary().len()), (1, 3));
/// # Ok::<(), signorini::Error>(())
/// ```
///
/// # Errors
/// [`Syntax`](crate::Error::Syntax) with the line at which a text does not follow the format;
/// [`AtLine`](crate::Error::AtLine) with the line of invalid data:
/// [`UnknownName`](crate::ToolkitError::UnknownName) for a group that is not a boundary part,
/// [`Node`](crate::ToolkitError::Node) for a node with a different z, and the errors of
/// [`Triangulation::new`]. [`AtByte`](crate::Error::AtByte) for both in a binary file.
pub fn parse_msh(content: impl AsRef<[u8]>) -> Result<Triangulation> {
    parse_msh_with(content, &[])
}

/// As [`parse_msh`], with the boundary parts of groups whose names do not state them.
///
/// # Errors
/// As for [`parse_msh`] and [`Triangulation::from_groups`].
pub fn parse_msh_with(content: impl AsRef<[u8]>, parts: &[(&str, Part)]) -> Result<Triangulation> {
    let mut source = Source::of(content.as_ref());
    refuse_others(&source)?;
    let mut raw = Raw::default();
    let (mut format, mut known) = (None, BTreeSet::new());
    while let Some(header) = source.next_header()? {
        let is_read = [
            "$MeshFormat",
            "$PhysicalNames",
            "$Entities",
            "$PartitionedEntities",
            "$Nodes",
            "$ParametricNodes",
            "$Elements",
        ];
        if is_read.contains(&&*header) && !known.insert(header.to_string()) {
            return Err(source.fault(&format!("duplicate section {header}")));
        }
        match (&*header, format) {
            ("$MeshFormat", _) => {
                format = Some(read_format(&mut source)?);
                raw.is_binary = source.is_binary();
            }
            ("$PhysicalNames", _) => raw.read_names(&mut source)?,
            ("$Entities", Some(Format::Four(four))) => raw.read_entities(&mut source, four)?,
            ("$PartitionedEntities", Some(Format::Four(four))) => {
                raw.read_partitioned_entities(&mut source, four)?;
            }
            ("$Nodes", Some(Format::Four(four))) => raw.read_blocks_of_nodes(&mut source, four)?,
            ("$Elements", Some(Format::Four(four))) => {
                raw.read_blocks_of_elements(&mut source, four)?
            }
            ("$Nodes", Some(Format::Two)) => raw.read_list_of_nodes(&mut source, false)?,
            ("$ParametricNodes", Some(Format::Two)) => raw.read_list_of_nodes(&mut source, true)?,
            ("$Elements", Some(Format::Two)) => raw.read_list_of_elements(&mut source)?,
            (
                "$Nodes" | "$ParametricNodes" | "$Elements" | "$Entities" | "$PartitionedEntities",
                None,
            ) => {
                return Err(source.fault("$MeshFormat must precede all other sections"));
            }
            _ => {
                source.skip_section(&header)?;
                continue;
            }
        }
        source.expect_end(&header)?;
    }
    if format.is_none() {
        return Err(source.fault("no $MeshFormat section: not a .msh file of Gmsh"));
    }
    raw.triangulation(parts, source.place())
}

/// The supported formats.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Format {
    Four(Four),
    Two,
}

/// Version, 0 for text or 1 for binary, size of a number.
fn read_format(source: &mut Source<'_>) -> Result<Format> {
    let line = source.next_line()?;
    let mut words = line.split_whitespace();
    let version = words.next().unwrap_or("");
    let format = match version {
        "4.1" => Format::Four(Four::One),
        "4" | "4.0" => Format::Four(Four::Zero),
        "2" | "2.0" | "2.1" | "2.2" => Format::Two,
        _ => {
            let found = quoted(version);
            let what = "expected 2.0 to 2.2, 4.0 or 4.1: gmsh body.msh -save -format msh41 -o new.msh converts it";
            return Err(source.fault(&format!("found format {found}, {what}")));
        }
    };
    match words.next() {
        Some("0") => {}
        Some("1") => {
            let size = words.next().and_then(|word| word.parse().ok()).unwrap_or(0);
            source.begin_binary(size)?;
        }
        _ => return Err(source.fault("expected 0 (text) or 1 (binary) behind the format")),
    }
    Ok(format)
}

/// Names the format of files that end in `.msh` and are not of this kind.
fn refuse_others(source: &Source<'_>) -> Result<()> {
    let first = source.first_line();
    let is_count = |word: &str| word.parse::<u64>().is_ok();
    let what = if first == "$NOD" {
        "format 1 of Gmsh, in which groups have no names: mesh the .geo file again, or convert by gmsh body.msh -save \
         -format msh41 -o new.msh; its groups are then called 1, 2, ..."
    } else if first.split_whitespace().count() == 3 && first.split_whitespace().all(is_count) {
        "a mesh of FreeFEM, not of Gmsh: its nodes, triangles and edges can be given to Python as arrays"
    } else if first.starts_with('(') {
        "a mesh of Fluent, not of Gmsh: meshio convert -i ansys body.msh -o gmsh new.msh converts it"
    } else if first.starts_with("\u{fffd}\u{fffd}") {
        "not a text in UTF-8: Windows PowerShell writes UTF-16 by >; use gmsh -o body.msh"
    } else if first.starts_with("\u{1f}\u{fffd}") {
        "compressed by gzip: gunzip body.msh.gz writes body.msh"
    } else if first.is_empty() || is_header(&first) {
        return Ok(());
    } else if first.contains(';') || first.starts_with("//") || first.starts_with("/*") {
        "a geometry, not a mesh: gmsh -2 body.geo meshes it and writes body.msh"
    } else {
        return Err(at_first_line(
            &first,
            &format!(
                "found {}, expected $MeshFormat: not a mesh of Gmsh; one that meshio reads can be given to Python, \
             contact.solve(meshio.read(\"body.inp\"), ..)",
                quoted(&first)
            ),
        ));
    };
    Err(at_first_line(&first, what))
}

/// Whether a line is the header of a section: `$` and a letter.
fn is_header(line: &str) -> bool {
    line.strip_prefix('$').is_some_and(|name| name.starts_with(|c: char| c.is_ascii_alphabetic()))
}

fn at_first_line(first: &str, what: &str) -> crate::Error {
    let mut copy = Source::of(first.as_bytes());
    copy.next_line().ok();
    copy.fault(what)
}
