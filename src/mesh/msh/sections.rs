//! The sections of the formats 4 (entities with their groups, blocks of nodes and elements by entity) and 2 (one
//! record for a node, one for an element with its group), in text or in binary.

use super::kinds::{Shape, kind};
use super::raw::{Element, Raw};
use super::source::Source;
use crate::error::Result;

/// The formats with blocks by entity.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Four {
    /// 4.0: tags are of type `int`, points have a bounding box, and the tag of an entity precedes its dimension.
    Zero,
    /// 4.1: tags of nodes and elements are of type `size_t`, points have coordinates.
    One,
}

impl Raw {
    /// Dimension, tag and name; no dimension in format 2.0.
    pub(super) fn read_names(&mut self, source: &mut Source<'_>) -> Result<()> {
        for _ in 0..source.count()? {
            let line = source.next_line()?;
            let bad = || source.fault("expected dimension, tag and \"name\"");
            let (head, name) = line.split_once('"').ok_or_else(bad)?;
            let numbers: Vec<i64> = head
                .split_whitespace()
                .map(|word| word.parse().map_err(|_| bad()))
                .collect::<Result<_>>()?;
            let (dimension, tag) = match numbers[..] {
                [dimension, tag] => (i32::try_from(dimension).map_err(|_| bad())?, tag),
                [tag] => (Self::ANY_DIMENSION, tag),
                _ => return Err(bad()),
            };
            self.names.insert((dimension, tag), name.trim_end_matches('"').to_owned());
        }
        Ok(())
    }

    /// Four counts; then for each point, curve, surface and volume its tag, coordinates or bounding box, groups, and
    /// what bounds it.
    pub(super) fn read_entities(&mut self, source: &mut Source<'_>, format: Four) -> Result<()> {
        source.begin()?;
        let counts = [source.size()?, source.size()?, source.size()?, source.size()?];
        source.end()?;
        for (dimension, count) in (0..4).zip(counts) {
            for _ in 0..count {
                source.begin()?;
                let tag = source.int()?;
                self.read_groups(source, format, (dimension, tag))?;
            }
        }
        Ok(())
    }

    /// Numbers of partitions and of ghost entities, and as for entities, with dimension and tag of the entity that
    /// each is a part of.
    pub(super) fn read_partitioned_entities(
        &mut self,
        source: &mut Source<'_>,
        format: Four,
    ) -> Result<()> {
        source.begin()?;
        source.size()?;
        if source.is_binary() {
            for _ in 0..source.size()? {
                source.int()?;
                source.int()?;
            }
        } else {
            source.end()?;
            source.begin()?;
            // The ghosts are on lines of their own.
            for _ in 0..source.size()? {
                source.begin()?;
                source.end_early();
            }
            source.end()?;
            source.begin()?;
        }
        let counts = [source.size()?, source.size()?, source.size()?, source.size()?];
        source.end()?;
        for (dimension, count) in (0..4).zip(counts) {
            for _ in 0..count {
                source.begin()?;
                let tag = source.int()?;
                let parent = (i32::try_from(source.int()?).unwrap_or(-1), source.int()?);
                for _ in 0..source.size()? {
                    source.int()?;
                }
                self.read_groups(source, format, (dimension, tag))?;
                // A piece of a curve belongs to the groups of the curve; an interface of partitions to none.
                let is_piece =
                    parent.0 == dimension && !self.groups.contains_key(&(dimension, tag));
                if let (true, Some(groups)) = (is_piece, self.groups.get(&parent).cloned()) {
                    self.groups.insert((dimension, tag), groups);
                }
            }
        }
        Ok(())
    }

    /// Coordinates or a bounding box, groups, and what bounds the entity.
    fn read_groups(
        &mut self,
        source: &mut Source<'_>,
        format: Four,
        entity: (i32, i64),
    ) -> Result<()> {
        let is_point = entity.0 == 0;
        for _ in 0..if is_point && format == Four::One { 3 } else { 6 } {
            source.real()?;
        }
        let mut groups = Vec::new();
        for _ in 0..source.size()? {
            // A negative tag means reversed orientation of the curve.
            groups.push(source.int()?.abs());
        }
        if !groups.is_empty() {
            self.groups.insert(entity, groups);
        }
        if source.is_binary() && !is_point {
            for _ in 0..source.size()? {
                source.int()?;
            }
        }
        source.end_early();
        Ok(())
    }

    /// Dimension and tag of the entity of a block, in either order, and one further number.
    fn block(source: &mut Source<'_>, format: Four) -> Result<(i64, i64, i64, u64)> {
        source.begin()?;
        let (a, b, kind, count) = (source.int()?, source.int()?, source.int()?, source.size()?);
        source.end()?;
        Ok(match format {
            Four::Zero => (b, a, kind, count),
            Four::One => (a, b, kind, count),
        })
    }

    /// The numbers of blocks and of their members; format 4.1 also has the smallest and largest tag.
    fn blocks(source: &mut Source<'_>, format: Four) -> Result<[u64; 2]> {
        source.begin()?;
        let counts = [source.size()?, source.size()?];
        if format == Four::One {
            source.size()?;
            source.size()?;
        }
        source.end()?;
        Ok(counts)
    }

    pub(super) fn read_blocks_of_nodes(
        &mut self,
        source: &mut Source<'_>,
        format: Four,
    ) -> Result<()> {
        let [blocks, total] = Self::blocks(source, format)?;
        for _ in 0..blocks {
            let (dimension, _, parametric, count) = Self::block(source, format)?;
            // A node on a curve or a surface may have its parameters there.
            let parameters = if parametric != 0 { dimension } else { 0 };
            if format == Four::Zero {
                for _ in 0..count {
                    source.begin()?;
                    let tag = source.tag()?;
                    self.read_place(source, tag, parameters)?;
                }
                continue;
            }
            let mut tags = Vec::new();
            for _ in 0..count {
                source.begin()?;
                tags.push(source.size()?);
                source.end()?;
            }
            for tag in tags {
                source.begin()?;
                self.read_place(source, tag, parameters)?;
            }
        }
        self.require_nodes(total, source)
    }

    /// Three coordinates and the parameters of a node.
    fn read_place(&mut self, source: &mut Source<'_>, tag: u64, parameters: i64) -> Result<()> {
        let place = [source.real()?, source.real()?, source.real()?];
        for _ in 0..parameters {
            source.real()?;
        }
        source.end()?;
        self.add_node(tag, place, source)
    }

    pub(super) fn read_blocks_of_elements(
        &mut self,
        source: &mut Source<'_>,
        format: Four,
    ) -> Result<()> {
        let [blocks, total] = Self::blocks(source, format)?;
        let mut seen = 0;
        for _ in 0..blocks {
            let (_, entity, number, count) = Self::block(source, format)?;
            let shape = kind(number).map_err(|why| source.fault(&why))?;
            let tag = |source: &mut Source<'_>| match format {
                Four::Zero => source.tag(),
                Four::One => source.size(),
            };
            for _ in 0..count {
                source.begin()?;
                seen += 1;
                let element =
                    Element { tag: tag(source)?, entity, group: 0, ..Element::at(source.place()) };
                self.read_element(source, shape, element, tag)?;
            }
        }
        if seen != total {
            return Err(source.fault(&format!("found {seen} elements, expected {total}")));
        }
        Ok(())
    }

    /// The nodes of an element, corners first.
    fn read_element(
        &mut self,
        source: &mut Source<'_>,
        (shape, nodes): (Shape, usize),
        mut element: Element,
        tag: impl Fn(&mut Source<'_>) -> Result<u64>,
    ) -> Result<()> {
        for k in 0..nodes {
            let node = tag(source)?;
            if let Some(place) = element.nodes.get_mut(k) {
                *place = node;
            }
        }
        source.end()?;
        self.higher |= nodes > 3 || shape == Shape::Line && nodes > 2;
        match shape {
            Shape::Point => self.points.push((element.entity, element.group)),
            Shape::Line => self.lines.push(element),
            Shape::Triangle => self.triangles.push(element),
        }
        Ok(())
    }

    /// One record for a node; with parameters also dimension and tag of its entity.
    pub(super) fn read_list_of_nodes(
        &mut self,
        source: &mut Source<'_>,
        parametric: bool,
    ) -> Result<()> {
        let total = source.count()?;
        for _ in 0..total {
            source.begin()?;
            let tag = source.tag()?;
            if tag == 0 {
                return Err(source.fault("0 is not a valid number of a node"));
            }
            let place = [source.real()?, source.real()?, source.real()?];
            if parametric {
                let (dimension, _) = (source.int()?, source.int()?);
                for _ in 0..if dimension < 3 { dimension } else { 0 } {
                    source.real()?;
                }
                source.end_early();
            }
            source.end()?;
            self.add_node(tag, place, source)?;
        }
        self.require_nodes(total, source)
    }

    /// Number, type, number of tags, tags (group and curve or surface come first), nodes; in binary the type and the
    /// number of tags come once for several elements.
    pub(super) fn read_list_of_elements(&mut self, source: &mut Source<'_>) -> Result<()> {
        let total = source.count()?;
        let mut seen = 0;
        while seen < total {
            source.begin()?;
            let mut one = 0;
            let (number, count, tags) = if source.is_binary() {
                (source.int()?, source.tag()?, source.tag()?)
            } else {
                one = source.tag()?;
                (source.int()?, 1, source.tag()?)
            };
            let shape = kind(number).map_err(|why| source.fault(&why))?;
            for _ in 0..count {
                let mut element = Element::at(source.place());
                element.tag = if source.is_binary() { source.tag()? } else { one };
                for k in 0..tags {
                    let tag = source.int()?;
                    match k {
                        0 => element.group = tag.saturating_abs(),
                        1 => element.entity = tag,
                        _ => {}
                    }
                }
                self.read_element(source, shape, element, |source| source.tag())?;
            }
            seen += count;
        }
        match seen == total {
            true => Ok(()),
            false => Err(source.fault(&format!("found {seen} elements, expected {total}"))),
        }
    }
}
