//! The sections of format 4.1 (entities with their groups, blocks of nodes and elements by entity) and of format 2.2
//! (one line for a node, one for an element with its group).

use super::lines::Lines;
use super::raw::{Element, Raw, Surface};
use crate::error::Result;

impl Raw {
    pub(super) fn read_entities(&mut self, lines: &mut Lines<'_>) -> Result<()> {
        let counts: [u64; 4] = lines.exactly()?;
        for (dimension, count) in (0..4).zip(counts) {
            // Tag, then a point or a bounding box, then the number of groups.
            let at = if dimension == 0 { 4 } else { 7 };
            for _ in 0..count {
                let numbers: Vec<f64> = lines.numbers()?;
                let groups = numbers.get(at).copied().unwrap_or(0.0);
                if let (true, Some(&tag), Some(&group)) = (groups > 0.0, numbers.first(), numbers.get(at + 1))
                {
                    if groups > 1.0 && (dimension == 1 || dimension == 2) {
                        let what = if dimension == 1 { "curve" } else { "surface" };
                        let (tag, groups) = (tag as i64, groups as u64);
                        let why = format!("{what} {tag} is in {groups} physical groups, expected one");
                        return Err(lines.fault(&why));
                    }
                    // A negative tag means reversed orientation of the curve.
                    self.groups.insert((dimension, tag as i64), group.abs() as i64);
                }
            }
        }
        Ok(())
    }

    pub(super) fn read_blocks_of_nodes(&mut self, lines: &mut Lines<'_>) -> Result<()> {
        let [blocks, total, _, _] = lines.exactly::<u64, 4>()?;
        for _ in 0..blocks {
            let [_, _, parametric, count] = lines.exactly::<i64, 4>()?;
            if parametric != 0 {
                return Err(lines.fault("parametric nodes are not supported"));
            }
            let mut tags = Vec::new();
            for _ in 0..lines.count(count)? {
                tags.push(lines.exactly::<u64, 1>()?[0]);
            }
            for tag in tags {
                let place = lines.exactly::<f64, 3>()?;
                self.add_node(tag, place, lines)?;
            }
        }
        self.require_nodes(total, lines)
    }

    pub(super) fn read_blocks_of_elements(&mut self, lines: &mut Lines<'_>) -> Result<()> {
        let [blocks, total, _, _] = lines.exactly::<u64, 4>()?;
        let mut seen = 0;
        for _ in 0..blocks {
            let [_, entity, kind, count] = lines.exactly::<i64, 4>()?;
            let group = |dimension| self.groups.get(&(dimension, entity)).copied();
            let (on_curve, surface) = (group(1), Surface { entity, group: group(2) });
            for _ in 0..lines.count(count)? {
                seen += 1;
                match kind {
                    1 => {
                        let (_, nodes) = lines.tagged()?;
                        self.lines.push(Element { line: lines.number(), of: on_curve, nodes });
                    }
                    2 => {
                        let (_, nodes) = lines.tagged()?;
                        self.triangles.push(Element { line: lines.number(), of: surface, nodes });
                    }
                    15 => {
                        lines.exactly::<u64, 2>()?;
                    }
                    other => return Err(Self::unknown_kind(other, lines)),
                }
            }
        }
        if seen != total {
            return Err(lines.fault(&format!("found {seen} elements, expected {total}")));
        }
        Ok(())
    }

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
