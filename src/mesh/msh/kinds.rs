//! The element types of Gmsh that may occur in the mesh of a plane body.

/// What an element of a file is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Shape {
    Point,
    Line,
    Triangle,
}

/// The shape of an element type, and its number of nodes, the corners first.
///
/// # Errors
/// What to do about another type.
pub(super) fn kind(number: i64) -> Result<(Shape, usize), String> {
    let nodes = |shape, count| Ok((shape, count));
    let refuse = |what: &str| Err(format!("element type {number} is {what}"));
    match number {
        15 => nodes(Shape::Point, 1),
        1 => nodes(Shape::Line, 2),
        8 => nodes(Shape::Line, 3),
        26 => nodes(Shape::Line, 4),
        27 => nodes(Shape::Line, 5),
        28 => nodes(Shape::Line, 6),
        2 => nodes(Shape::Triangle, 3),
        9 => nodes(Shape::Triangle, 6),
        20 => nodes(Shape::Triangle, 9),
        21 => nodes(Shape::Triangle, 10),
        22 => nodes(Shape::Triangle, 12),
        23 | 24 => nodes(Shape::Triangle, 15),
        25 => nodes(Shape::Triangle, 21),
        3 | 10 | 16 | 36..=41 | 47..=51 => {
            refuse("a quadrangle: only triangles are read; mesh the body without Recombine")
        }
        4..=7 | 11..=14 | 17..=19 | 29..=33 | 71..=126 => {
            refuse("a solid: the body must be plane; mesh its cross-section by gmsh -2")
        }
        _ => refuse("unknown: only points, lines and triangles are read"),
    }
}
