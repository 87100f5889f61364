//! Reading Gmsh meshes: the ASCII formats 4.1 and 2.2 (Gmsh reference manual, sections "MSH file format" and
//! "MSH file format version 2").
//!
//! Two-node lines of curves in a physical group become boundary edges, three-node triangles the mesh,
//! physical surfaces its regions in ascending order of their tags. The boundary condition on a curve is
//! given by the name of its group, case-insensitively, up to the first blank, `_` or `-`:
//!
//! | name | part |
//! | --- | --- |
//! | `clamped`, `fixed`, `dirichlet` | [`Part::Dirichlet`](super::Part::Dirichlet) |
//! | `contact` | [`Part::Contact`](super::Part::Contact) |
//! | `free`, `neumann` | [`Part::Neumann`](super::Part::Neumann) |
//!
//! Thus `contact left` and `contact_2` are contact, too. Each curve belongs to at most one group. Nodes in no
//! triangle (points of the geometry) are omitted. All triangles lie in one plane z = const; a surface whose triangles
//! are all clockwise is reoriented. The result passes the checks of [`Triangulation::new`]. Cost: O(N log N)
//! for N lines; no memory is reserved on the basis of counts in the file.

mod lines;
mod raw;
mod sections;

use self::lines::Lines;
use self::raw::Raw;
use crate::error::Result;
use crate::mesh::triangulation::Triangulation;
use crate::text::{quoted, read_text};
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
    // Binary files also state their format in a line of text.
    parse_msh(&read_text(path.as_ref())?)
}

/// The triangulation in the text of a `.msh` file.
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
/// [`Syntax`](crate::Error::Syntax) with the line at which the text does not follow the format, also for binary
/// files; [`AtLine`](crate::Error::AtLine) with the line of invalid data:
/// [`UnknownName`](crate::ToolkitError::UnknownName) for a group that is not a boundary part,
/// [`Node`](crate::ToolkitError::Node) for a node with a different z, and the errors of
/// [`Triangulation::new`].
pub fn parse_msh(text: &str) -> Result<Triangulation> {
    let mut raw = Raw::default();
    let mut lines = Lines::of(text);
    let (mut format, mut known) = (None, BTreeSet::new());
    while let Some(header) = lines.next_header()? {
        let is_read = ["$MeshFormat", "$PhysicalNames", "$Entities", "$Nodes", "$Elements"].contains(&header);
        if is_read && !known.insert(header) {
            return Err(lines.fault(&format!("duplicate section {header}")));
        }
        match (header, format) {
            ("$MeshFormat", _) => format = Some(read_format(&mut lines)?),
            ("$PhysicalNames", _) => raw.read_names(&mut lines)?,
            ("$Entities", Some(Format::Four)) => raw.read_entities(&mut lines)?,
            ("$Nodes", Some(Format::Four)) => raw.read_blocks_of_nodes(&mut lines)?,
            ("$Elements", Some(Format::Four)) => raw.read_blocks_of_elements(&mut lines)?,
            ("$Nodes", Some(Format::Two)) => raw.read_list_of_nodes(&mut lines)?,
            ("$Elements", Some(Format::Two)) => raw.read_list_of_elements(&mut lines)?,
            ("$Nodes" | "$Elements" | "$Entities", None) => {
                return Err(lines.fault("$MeshFormat must precede all other sections"));
            }
            _ => {
                lines.skip_section(header)?;
                continue;
            }
        }
        lines.expect_end(header)?;
    }
    if format.is_none() {
        return Err(lines.fault("no $MeshFormat section: not a .msh file of Gmsh"));
    }
    raw.triangulation(lines.number())
}

/// The supported formats.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Format {
    Four,
    Two,
}

fn read_format(lines: &mut Lines<'_>) -> Result<Format> {
    let line = lines.next_line()?;
    let mut words = line.split_whitespace();
    match (words.next(), words.next()) {
        (Some("4.1" | "2.2"), Some("1")) => {
            Err(lines.fault("the file is binary: save as ASCII (gmsh -bin 0, or Mesh.Binary = 0)"))
        }
        (Some("4.1"), Some("0")) => Ok(Format::Four),
        (Some("2.2"), Some("0")) => Ok(Format::Two),
        (version, _) => {
            let found = quoted(version.unwrap_or(""));
            let why = format!("found format {found}, expected 4.1 or 2.2: save as ASCII in one of these");
            Err(lines.fault(&why))
        }
    }
}
