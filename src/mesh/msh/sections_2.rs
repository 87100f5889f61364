//! The sections of format 2.2: one line for a node, one for an element with its group.

use super::lines::Lines;
use super::raw::{Element, Raw, Surface};
use crate::error::Result;

impl Raw {
    pub(super) fn read_list_of_nodes(&mut self, lines: &mut Lines<'_>) -> Result<()> {
        let [total] = lines.exactly::<u64, 1>()?;
        for _ in 0..total {
            let [tag, x, y, z] = lines.exactly::<f64, 4>()?;
            if tag < 1.0 || tag.fract() != 0.0 || tag > 9e15 {
                return Err(lines.fault(&format!("{tag:?} is not a valid node number")));
            }
            self.add_node(tag as u64, [x, y, z], lines)?;
        }
        self.require_nodes(total, lines)
    }

    /// Number, kind, number of tags, tags (group and curve or surface come first), nodes.
    pub(super) fn read_list_of_elements(&mut self, lines: &mut Lines<'_>) -> Result<()> {
        let [total] = lines.exactly::<u64, 1>()?;
        for _ in 0..total {
            let numbers: Vec<i64> = lines.numbers()?;
            let short = || lines.fault("the nodes of the element are missing");
            let [_, kind, tags, rest @ ..] = numbers.as_slice() else { return Err(short()) };
            let tags = usize::try_from(*tags).ok().filter(|&tags| tags <= rest.len()).ok_or_else(short)?;
            let (tags, nodes) = rest.split_at(tags);
            let group = tags.first().and_then(|group| group.checked_abs()).filter(|&group| group != 0);
            let line = lines.number();
            match kind {
                1 => self.lines.push(Element { line, of: group, nodes: corners(nodes).ok_or_else(short)? }),
                2 => {
                    let of = Surface { entity: tags.get(1).copied().unwrap_or(0), group };
                    self.triangles.push(Element { line, of, nodes: corners(nodes).ok_or_else(short)? });
                }
                15 => {}
                other => return Err(Self::unknown_kind(*other, lines)),
            }
        }
        Ok(())
    }
}

/// The tags of the nodes of an element; `None` for another number of nodes.
fn corners<const N: usize>(nodes: &[i64]) -> Option<[u64; N]> {
    let nodes: Vec<u64> = nodes.iter().map(|&node| u64::try_from(node).ok()).collect::<Option<_>>()?;
    nodes.try_into().ok()
}
