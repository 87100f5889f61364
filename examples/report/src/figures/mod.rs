//! Charts and mesh pictures as SVG, legible on light and dark backgrounds, on screen and on paper.
//!
//! Axes, ticks and text are drawn in `currentColor`, so that an inlined figure has the text colour of the
//! page; opened alone it has light and dark colours of its own. Series use six colours of the palette of
//! Okabe and Ito, which are distinguishable with any kind of colour vision, and grey; points have four
//! markers in turn.

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

/// The palette, in the order in which the series of a chart are coloured.
pub const PALETTE: [Colour; 7] = [
    (0, 114, 178),
    (213, 94, 0),
    (0, 158, 115),
    (204, 121, 167),
    (230, 159, 0),
    (86, 180, 233),
    (120, 120, 120),
];
