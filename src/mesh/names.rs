//! Names of the groups of a mesh: of its boundary edges, of its regions, and of curves inside the body.

use super::geometry::Part;

/// A curve inside the body that has a name.
///
/// Nothing acts on it; its edges are edges of triangles on every refinement.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Interface {
    /// The name of its group.
    pub name: String,
    /// Its edges by their nodes, in the order and direction of the file.
    pub edges: Vec<[usize; 2]>,
}

/// The names of a triangulation; empty unless they were given.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(super) struct Names {
    /// Names of the boundary groups.
    pub(super) groups: Vec<String>,
    /// For every boundary edge the index of its group; empty if the edges have no names.
    pub(super) of_edges: Vec<u32>,
    /// Names of the regions by their numbers; empty if they have none.
    pub(super) regions: Vec<String>,
    pub(super) interfaces: Vec<Interface>,
    pub(super) remarks: Vec<String>,
}

impl Names {
    /// Distinct names in order of first appearance, and the index of each given one.
    pub(super) fn numbered(given: &[&str]) -> (Vec<String>, Vec<u32>) {
        let mut names: Vec<String> = Vec::new();
        let mut index = std::collections::HashMap::new();
        let numbers = given.iter().map(|&name| {
            *index.entry(name.to_owned()).or_insert_with(|| {
                names.push(name.to_owned());
                names.len() as u32 - 1
            })
        });
        let numbers = numbers.collect();
        (names, numbers)
    }
}

impl Part {
    /// The name of a boundary group without a name of its own: `clamped`, `free` or `contact`.
    ///
    /// ```
    /// use signorini::mesh::Part;
    /// assert_eq!(Part::Dirichlet.name(), "clamped");
    /// assert_eq!(Part::named("Fixed left"), Some(Part::Dirichlet));
    /// ```
    pub fn name(self) -> &'static str {
        match self {
            Part::Dirichlet => "clamped",
            Part::Neumann => "free",
            Part::Contact => "contact",
        }
    }

    /// The part that a group's name states, case-insensitively, up to the first blank, `_` or `-`: `clamped`, `fixed`
    /// or `dirichlet`; `free` or `neumann`; `contact`. `None` for any other name.
    pub fn named(group: &str) -> Option<Self> {
        match group.to_lowercase().split([' ', '_', '-']).next().unwrap_or_default() {
            "clamped" | "fixed" | "dirichlet" => Some(Part::Dirichlet),
            "free" | "neumann" => Some(Part::Neumann),
            "contact" => Some(Part::Contact),
            _ => None,
        }
    }
}
