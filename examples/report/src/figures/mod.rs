//! Charts and mesh pictures as SVG that reads in light and dark, on screen and on paper.
//!
//! Ink (axes, ticks, words) is `currentColor`, so a figure inlined in a page takes the page's colour; opened
//! alone it brings its own light and dark colours. Series use the eight-colour palette of Okabe and Ito, told
//! apart by people with any kind of colour vision, and every series also has its own marker.

pub(crate) mod body;
mod canvas;
mod chart;
mod scale;
mod typeset;

pub use body::edge_trace;
pub use chart::{Axis, Chart, Series};
pub(crate) use chart::{Mark, save_svg};

/// A colour as red, green, blue.
pub type Colour = (u8, u8, u8);

/// The palette, in the order series take it.
pub const PALETTE: [Colour; 7] = [
    (0, 114, 178),
    (213, 94, 0),
    (0, 158, 115),
    (204, 121, 167),
    (230, 159, 0),
    (86, 180, 233),
    (120, 120, 120),
];
