//! A chart before it is drawn: title, axes, series, bands; and the frame in which it is drawn.

use super::scale::Scale;
use super::series::{Axis, Mark, Series};
use super::{Colour, PALETTE};

pub(super) const WIDTH: f64 = 640.0;
pub(super) const PLOT_HEIGHT: f64 = 320.0;
/// From row to row of named rows, with room for the letters of a narrow screen.
pub(super) const ROW: f64 = 21.5;
pub(super) const LEFT: f64 = 88.0;
pub(super) const RIGHT: f64 = 22.0;
pub(super) const TOP: f64 = 36.0;
/// Ticks and label of the horizontal axis.
pub(super) const BELOW: f64 = 56.0;
pub(super) const TEXT_SIZE: f64 = 15.0;
/// Mean width of a character relative to the text size, for laying out words.
pub(super) const CHARACTER: f64 = 0.56;

/// Vertical bands behind the data: intervals of the horizontal axis that belong together.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Bands {
    pub(super) name: String,
    pub(super) intervals: Vec<(f64, f64)>,
    pub(super) colour: Colour,
}

/// A chart: title, two axes, series, bands. Build it, then [`Chart::svg`].
#[derive(Debug, Clone, PartialEq)]
pub struct Chart {
    pub(super) title: String,
    pub(super) x: Axis,
    pub(super) y: Axis,
    pub(super) series: Vec<Series>,
    pub(super) bands: Vec<Bands>,
    /// Places where curves end in a singularity, in the colour of their series.
    pub(super) asymptotes: Vec<(f64, Colour)>,
}

impl Chart {
    /// A chart without data.
    pub fn new(title: impl Into<String>, x: Axis, y: Axis) -> Self {
        Self { title: title.into(), x, y, series: Vec::new(), bands: Vec::new(), asymptotes: Vec::new() }
    }

    /// Adds a series; it takes the next colour of the palette unless it brings its own. Where the colours come round
    /// again a line has markers.
    #[must_use]
    pub fn with(mut self, mut series: Series) -> Self {
        if self.series.len() >= PALETTE.len() && series.mark == Mark::Line {
            series.mark = Mark::LineAndPoints;
        }
        let colour = series.colour.unwrap_or(PALETTE[self.series.len() % PALETTE.len()]);
        self.series.push(series.colour(colour));
        self
    }

    /// Shades intervals of the horizontal axis.
    #[must_use]
    pub fn with_bands(mut self, name: impl Into<String>, intervals: Vec<(f64, f64)>, colour: Colour) -> Self {
        self.bands.push(Bands { name: name.into(), intervals, colour });
        self
    }

    /// Draws where the last series ends in a singularity, as a dotted vertical line in its colour.
    #[must_use]
    pub fn with_asymptote(mut self, at: f64) -> Self {
        let colour = self.series.last().and_then(|series| series.colour).unwrap_or(PALETTE[0]);
        self.asymptotes.push((at, colour));
        self
    }
}

/// The plot: both scales, its width and its height.
pub(super) struct Frame {
    pub(super) x: Scale,
    pub(super) y: Scale,
    pub(super) width: f64,
    pub(super) height: f64,
}

impl Frame {
    /// The place of a data point, if it can be shown inside the frame.
    pub(super) fn place(&self, (x, y): (f64, f64)) -> Option<(f64, f64)> {
        let (s, t) = (self.x.position(x)?, self.y.position(y)?);
        let inside = |p: f64| (-0.001..=1.001).contains(&p);
        (inside(s) && inside(t)).then(|| (self.across(s), self.up(t)))
    }

    pub(super) fn across(&self, s: f64) -> f64 {
        LEFT + s * self.width
    }

    pub(super) fn up(&self, t: f64) -> f64 {
        TOP + (1.0 - t) * self.height
    }
}
