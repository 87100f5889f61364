//! Plots and pictures of bodies as SVG, legible on light and dark backgrounds, on screen and on paper.
//!
//! Axes, ticks and text are drawn in `currentColor`, so that an inlined figure has the text colour of the
//! page; opened alone it has light and dark colours of its own. Series use six colours of the palette of
//! Okabe and Ito, which are distinguishable with any kind of colour vision, and grey; points have four
//! markers in turn.

pub(crate) mod body;
mod chart;
mod plot;
mod scale;
mod svg;

pub use plot::{Axes, Plot};

/// The palette, in the order in which the series of a plot are coloured.
const PALETTE: [&str; 7] = [
    "rgb(0,114,178)",
    "rgb(213,94,0)",
    "rgb(0,158,115)",
    "rgb(204,121,167)",
    "rgb(230,159,0)",
    "rgb(86,180,233)",
    "rgb(120,120,120)",
];
