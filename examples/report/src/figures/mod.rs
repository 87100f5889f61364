//! Plots and pictures of bodies as SVG, legible on light and dark backgrounds, on screen and on
//! paper.
//!
//! Axes, ticks and text are drawn in `currentColor`, so that an inlined figure has the text colour
//! of the page; opened alone it has light and dark colours of its own. Series use six colours of
//! the palette of Okabe and Ito, which are distinguishable with any kind of colour vision, and
//! grey; points have four markers in turn.

pub(crate) mod body;
mod chart;
mod plot;
mod scale;
mod svg;

use plotters::style::RGBColor;

pub use body::floor_names;
pub use plot::{Axes, Plot};

/// The palette, in the order in which the series of a plot are coloured.
const PALETTE: [RGBColor; 7] = [
    RGBColor(0, 114, 178),
    RGBColor(213, 94, 0),
    RGBColor(0, 158, 115),
    RGBColor(204, 121, 167),
    RGBColor(230, 159, 0),
    RGBColor(86, 180, 233),
    RGBColor(120, 120, 120),
];
