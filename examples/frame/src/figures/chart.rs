//! Line and point charts on linear or logarithmic axes. Up to six entries have a legend below the plot, so
//! that it never covers data; more have their names beside the curves.

use super::canvas::{Anchor, Canvas, Paint};
use super::labels::Labels;
use super::legend::Legend;
use super::scale::Scale;
use super::series::{Axis, Mark, Series};
use super::{Colour, PALETTE};
use crate::Result;

pub(super) const WIDTH: f64 = 640.0;
const PLOT_HEIGHT: f64 = 320.0;
/// From row to row of named rows, with room for the letters of a narrow screen.
const ROW: f64 = 21.5;
pub(super) const LEFT: f64 = 88.0;
pub(super) const RIGHT: f64 = 22.0;
const TOP: f64 = 36.0;
/// Ticks and label of the horizontal axis.
pub(super) const BELOW: f64 = 56.0;
pub(super) const TEXT_SIZE: f64 = 15.0;
/// Mean width of a character relative to the text size, for laying out words.
pub(super) const CHARACTER: f64 = 0.56;

/// Vertical bands behind the data: intervals of the horizontal axis that belong together.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Bands {
    pub(super) name: String,
    intervals: Vec<(f64, f64)>,
    pub(super) colour: Colour,
}

/// A chart: title, two axes, series, bands. Build it, then [`Chart::svg`] or [`Chart::save`].
#[derive(Debug, Clone, PartialEq)]
pub struct Chart {
    title: String,
    pub(super) x: Axis,
    pub(super) y: Axis,
    pub(super) series: Vec<Series>,
    pub(super) bands: Vec<Bands>,
    /// Places where curves end in a singularity, in the colour of their series.
    asymptotes: Vec<(f64, Colour)>,
}

impl Chart {
    /// A chart without data.
    pub fn new(title: impl Into<String>, x: Axis, y: Axis) -> Self {
        Self { title: title.into(), x, y, series: Vec::new(), bands: Vec::new(), asymptotes: Vec::new() }
    }

    /// Adds a series; it takes the next colour of the palette unless it brings its own.
    #[must_use]
    pub fn with(mut self, series: Series) -> Self {
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

    /// The chart as SVG text.
    ///
    /// # Errors
    /// [`crate::Error::Figure`] when the drawing backend fails.
    pub fn svg(&self) -> Result<String> {
        let (labels, legend) = (Labels::of(self), Legend::of(self));
        let frame = self.frame(labels.width());
        let height = (frame.height + BELOW + legend.height()).max(labels.height()) + TOP + 8.0;
        Canvas::draw(WIDTH, height, &self.title, |canvas| {
            canvas.text(&self.title, (WIDTH / 2.0, TOP / 2.0), TEXT_SIZE + 1.0, Anchor::Centre)?;
            self.draw_bands(canvas, &frame)?;
            self.draw_axes(canvas, &frame)?;
            self.draw_asymptotes(canvas, &frame)?;
            self.series.iter().enumerate().try_for_each(|(k, s)| draw_series(canvas, &frame, s, k))?;
            labels.draw(canvas, &frame)?;
            legend.draw(canvas, frame.up(0.0) + BELOW)
        })
    }

    fn draw_asymptotes(&self, canvas: &Canvas<'_>, frame: &Frame) -> Result<()> {
        for &(at, colour) in &self.asymptotes {
            if let Some(x) = frame.x.position(at).map(|s| frame.across(s)) {
                let ends = [(x, frame.up(0.0)), (x, frame.up(1.0))];
                canvas.dashes(&ends, Paint::Colour(colour, 1.0), 1.2, (2.0, 4.0))?;
            }
        }
        Ok(())
    }

    fn frame(&self, labels: f64) -> Frame {
        let points = || self.series.iter().flat_map(|s| &s.points);
        let bars = self.series.iter().flat_map(|s| s.points.iter().zip(&s.half_bars));
        let ends = bars.flat_map(|(p, b)| [p.1 - b, p.1 + b]);
        let bands = self.bands.iter().flat_map(|b| &b.intervals).flat_map(|&(a, b)| [a, b]);
        let asymptotes = self.asymptotes.iter().map(|asymptote| asymptote.0);
        Frame {
            x: self.x.scale(points().map(|p| p.0).chain(bands).chain(asymptotes)),
            y: self.y.scale(points().map(|p| p.1).chain(ends)),
            width: WIDTH - LEFT - RIGHT - labels,
            height: PLOT_HEIGHT.max(ROW * self.y.row_count() as f64),
        }
    }

    fn draw_bands(&self, canvas: &Canvas<'_>, frame: &Frame) -> Result<()> {
        for band in &self.bands {
            for &(a, b) in &band.intervals {
                let (Some(a), Some(b)) = (frame.x.position(a), frame.x.position(b)) else {
                    continue;
                };
                let (a, b) = (frame.across(a.clamp(0.0, 1.0)), frame.across(b.clamp(0.0, 1.0)));
                let corners =
                    [(a, frame.up(0.0)), (b, frame.up(0.0)), (b, frame.up(1.0)), (a, frame.up(1.0))];
                canvas.polygon(&corners, Paint::Colour(band.colour, 0.25))?;
            }
        }
        Ok(())
    }

    fn draw_axes(&self, canvas: &Canvas<'_>, frame: &Frame) -> Result<()> {
        for tick in self.x.ticks(&frame.x, (frame.width / 80.0) as usize) {
            let x = frame.across(tick.position);
            canvas.line(&[(x, frame.up(0.0)), (x, frame.up(1.0))], Paint::Ink(0.15), 0.8)?;
            canvas.text(
                tick.label.as_deref().unwrap_or(""),
                (x, frame.up(0.0) + 14.0),
                TEXT_SIZE,
                Anchor::Centre,
            )?;
        }
        for tick in self.y.ticks(&frame.y, 6) {
            let y = frame.up(tick.position);
            canvas.line(&[(frame.across(0.0), y), (frame.across(1.0), y)], Paint::Ink(0.15), 0.8)?;
            canvas.text(
                tick.label.as_deref().unwrap_or(""),
                (frame.across(0.0) - 7.0, y),
                TEXT_SIZE,
                Anchor::Right,
            )?;
        }
        let corners = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0), (0.0, 0.0)]
            .map(|(s, t)| (frame.across(s), frame.up(t)));
        canvas.line(&corners, Paint::Ink(0.8), 1.0)?;
        canvas.text(&self.x.label, (frame.across(0.5), frame.up(0.0) + 39.0), TEXT_SIZE, Anchor::Centre)?;
        canvas.text(&self.y.label, (14.0, frame.up(0.5)), TEXT_SIZE, Anchor::Upwards)
    }
}

/// The plot: both scales, its width and its height.
pub(super) struct Frame {
    x: Scale,
    y: Scale,
    width: f64,
    height: f64,
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

fn draw_series(canvas: &Canvas<'_>, frame: &Frame, series: &Series, index: usize) -> Result<()> {
    let places: Vec<Option<(f64, f64)>> = series.points.iter().map(|&p| frame.place(p)).collect();
    for run in places.split(Option::is_none) {
        let run: Vec<(f64, f64)> = run.iter().flatten().copied().collect();
        draw_run(canvas, series, index, &run)?;
    }
    for (&(x, y), &half) in series.points.iter().zip(&series.half_bars) {
        let ends = [frame.place((x, y - half)), frame.place((x, y + half))];
        if let [Some(low), Some(high)] = ends {
            canvas.line(&[low, high], paint(series), 1.2)?;
            for (cx, cy) in [low, high] {
                canvas.line(&[(cx - 3.0, cy), (cx + 3.0, cy)], paint(series), 1.2)?;
            }
        }
    }
    Ok(())
}

pub(super) fn paint(series: &Series) -> Paint {
    Paint::Colour(series.colour.unwrap_or(PALETTE[0]), 1.0)
}

fn draw_run(canvas: &Canvas<'_>, series: &Series, index: usize, run: &[(f64, f64)]) -> Result<()> {
    match series.mark {
        Mark::Line => canvas.line(run, paint(series), 1.8),
        Mark::Dashed => canvas.dashes(run, paint(series), 1.6, (7.0, 4.0)),
        Mark::Points => run.iter().try_for_each(|&p| draw_marker(canvas, series, index, p)),
        Mark::LineAndPoints => {
            canvas.line(run, paint(series), 1.5)?;
            run.iter().try_for_each(|&p| draw_marker(canvas, series, index, p))
        }
    }
}

pub(super) fn draw_sample(
    canvas: &Canvas<'_>,
    series: &Series,
    index: usize,
    (x, y): (f64, f64),
) -> Result<()> {
    match series.mark {
        Mark::Points => draw_marker(canvas, series, index, (x + 14.0, y)),
        Mark::LineAndPoints => {
            canvas.line(&[(x, y), (x + 28.0, y)], paint(series), 1.5)?;
            draw_marker(canvas, series, index, (x + 14.0, y))
        }
        Mark::Line | Mark::Dashed => draw_run(canvas, series, index, &[(x, y), (x + 28.0, y)]),
    }
}

/// Discs, squares, diamonds and triangles in turn.
fn draw_marker(canvas: &Canvas<'_>, series: &Series, index: usize, (x, y): (f64, f64)) -> Result<()> {
    let r = 3.6;
    let corners: Vec<(f64, f64)> = match index % 4 {
        0 => return canvas.disc((x, y), r, paint(series)),
        1 => vec![(-0.9, -0.9), (0.9, -0.9), (0.9, 0.9), (-0.9, 0.9)],
        2 => vec![(0.0, -1.25), (1.25, 0.0), (0.0, 1.25), (-1.25, 0.0)],
        _ => vec![(0.0, -1.25), (1.1, 0.8), (-1.1, 0.8)],
    };
    let corners: Vec<(f64, f64)> = corners.into_iter().map(|(a, b)| (x + r * a, y + r * b)).collect();
    canvas.polygon(&corners, paint(series))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_chart_is_svg_with_ink_in_the_colour_of_the_page() {
        let chart = Chart::new("a < b", Axis::logarithmic("h"), Axis::logarithmic("error"))
            .with(
                Series::points("measured", vec![(0.1, 1e-2), (0.01, 1e-4), (0.001, f64::NAN)])
                    .bars(vec![1e-3, 1e-5, 0.0]),
            )
            .with(Series::dashed("h²", vec![(0.1, 1e-2), (0.001, 1e-6)]));
        let svg = chart.svg().unwrap();
        assert!(svg.starts_with("<svg") && svg.trim_end().ends_with("</svg>"));
        assert!(svg.contains("currentColor") && !svg.contains("#010203"));
        assert!(svg.contains("aria-label=\"a &lt; b\"") && !svg.contains("NaN"));
    }
}
