//! Line and point charts on linear or logarithmic axes, with a legend below the plot so that it never covers
//! data.

use super::canvas::{Anchor, Canvas, Paint};
use super::scale::Scale;
use super::series::{Axis, Mark, Series};
use super::{Colour, PALETTE};
use crate::Result;

const WIDTH: f64 = 640.0;
const PLOT_HEIGHT: f64 = 320.0;
const LEFT: f64 = 78.0;
const RIGHT: f64 = 22.0;
const TOP: f64 = 36.0;
/// Ticks and label of the horizontal axis.
const BELOW: f64 = 52.0;
const LEGEND_ROW: f64 = 20.0;
const TEXT_SIZE: f64 = 13.0;
/// Mean width of a character relative to the text size, for laying out the legend.
const CHARACTER: f64 = 0.56;

/// Vertical bands behind the data: intervals of the horizontal axis that belong together.
#[derive(Debug, Clone, PartialEq)]
struct Bands {
    name: String,
    intervals: Vec<(f64, f64)>,
    colour: Colour,
}

/// A chart: title, two axes, series, bands. Build it, then [`Chart::svg`] or [`Chart::save`].
#[derive(Debug, Clone, PartialEq)]
pub struct Chart {
    title: String,
    pub(super) x: Axis,
    pub(super) y: Axis,
    pub(super) series: Vec<Series>,
    bands: Vec<Bands>,
}

impl Chart {
    /// A chart without data.
    pub fn new(title: impl Into<String>, x: Axis, y: Axis) -> Self {
        Self { title: title.into(), x, y, series: Vec::new(), bands: Vec::new() }
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

    /// The chart as SVG text.
    ///
    /// # Errors
    /// [`crate::Error::Figure`] when the drawing backend fails.
    pub fn svg(&self) -> Result<String> {
        let rows = self.legend_rows();
        let height = TOP + PLOT_HEIGHT + BELOW + LEGEND_ROW * rows.len() as f64 + 8.0;
        Canvas::draw(WIDTH, height, &self.title, |canvas| {
            let frame = self.frame();
            canvas.text(&self.title, (WIDTH / 2.0, TOP / 2.0), TEXT_SIZE + 2.0, Anchor::Centre)?;
            self.draw_bands(canvas, &frame)?;
            self.draw_axes(canvas, &frame)?;
            self.series.iter().enumerate().try_for_each(|(k, s)| draw_series(canvas, &frame, s, k))?;
            self.draw_legend(canvas, &rows)
        })
    }

    fn frame(&self) -> Frame {
        let points = || self.series.iter().flat_map(|s| &s.points);
        let bars = self.series.iter().flat_map(|s| s.points.iter().zip(&s.half_bars));
        let ends = bars.flat_map(|(p, b)| [p.1 - b, p.1 + b]);
        let bands = self.bands.iter().flat_map(|b| &b.intervals).flat_map(|&(a, b)| [a, b]);
        Frame {
            x: self.x.scale(points().map(|p| p.0).chain(bands)),
            y: self.y.scale(points().map(|p| p.1).chain(ends)),
        }
    }

    fn draw_bands(&self, canvas: &Canvas<'_>, frame: &Frame) -> Result<()> {
        for band in &self.bands {
            for &(a, b) in &band.intervals {
                let (Some(a), Some(b)) = (frame.x.position(a), frame.x.position(b)) else {
                    continue;
                };
                let (a, b) = (across(a.clamp(0.0, 1.0)), across(b.clamp(0.0, 1.0)));
                let corners = [(a, up(0.0)), (b, up(0.0)), (b, up(1.0)), (a, up(1.0))];
                canvas.polygon(&corners, Paint::Colour(band.colour, 0.25))?;
            }
        }
        Ok(())
    }

    fn draw_axes(&self, canvas: &Canvas<'_>, frame: &Frame) -> Result<()> {
        for tick in self.x.ticks(&frame.x, 7) {
            let x = across(tick.position);
            canvas.line(&[(x, up(0.0)), (x, up(1.0))], Paint::Ink(0.15), 0.8)?;
            canvas.text(
                tick.label.as_deref().unwrap_or(""),
                (x, up(0.0) + 14.0),
                TEXT_SIZE,
                Anchor::Centre,
            )?;
        }
        for tick in self.y.ticks(&frame.y, 6) {
            let y = up(tick.position);
            canvas.line(&[(across(0.0), y), (across(1.0), y)], Paint::Ink(0.15), 0.8)?;
            canvas.text(
                tick.label.as_deref().unwrap_or(""),
                (across(0.0) - 7.0, y),
                TEXT_SIZE,
                Anchor::Right,
            )?;
        }
        let corners =
            [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0), (0.0, 0.0)].map(|(s, t)| (across(s), up(t)));
        canvas.line(&corners, Paint::Ink(0.8), 1.0)?;
        canvas.text(&self.x.label, (across(0.5), up(0.0) + 36.0), TEXT_SIZE, Anchor::Centre)?;
        canvas.text(&self.y.label, (14.0, up(0.5)), TEXT_SIZE, Anchor::Upwards)
    }

    /// Entries of the legend in rows that fit the width: (kind, horizontal position).
    fn legend_rows(&self) -> Vec<Vec<(Entry<'_>, f64)>> {
        let entries = self
            .series
            .iter()
            .enumerate()
            .map(|(k, s)| Entry::Series(s, k))
            .chain(self.bands.iter().map(Entry::Bands));
        let mut rows: Vec<Vec<(Entry<'_>, f64)>> = Vec::new();
        let mut x = f64::INFINITY;
        for entry in entries {
            let width = 44.0 + CHARACTER * TEXT_SIZE * entry.name().chars().count() as f64;
            if x + width > WIDTH - RIGHT {
                rows.push(Vec::new());
                x = LEFT;
            }
            if let Some(row) = rows.last_mut() {
                row.push((entry, x));
            }
            x += width + 12.0;
        }
        rows
    }

    fn draw_legend(&self, canvas: &Canvas<'_>, rows: &[Vec<(Entry<'_>, f64)>]) -> Result<()> {
        for (k, row) in rows.iter().enumerate() {
            let y = up(0.0) + BELOW + LEGEND_ROW * (k as f64 + 0.5);
            for (entry, x) in row {
                match entry {
                    Entry::Series(series, index) => draw_sample(canvas, series, *index, (*x, y))?,
                    Entry::Bands(bands) => {
                        let corners =
                            [(*x, y - 6.0), (x + 28.0, y - 6.0), (x + 28.0, y + 6.0), (*x, y + 6.0)];
                        canvas.polygon(&corners, Paint::Colour(bands.colour, 0.25))?;
                    }
                }
                canvas.text(entry.name(), (x + 36.0, y), TEXT_SIZE, Anchor::Left)?;
            }
        }
        Ok(())
    }
}

enum Entry<'a> {
    Series(&'a Series, usize),
    Bands(&'a Bands),
}

impl Entry<'_> {
    fn name(&self) -> &str {
        match self {
            Entry::Series(series, _) => &series.name,
            Entry::Bands(bands) => &bands.name,
        }
    }
}

struct Frame {
    x: Scale,
    y: Scale,
}

impl Frame {
    /// The place of a data point, if it can be shown inside the frame.
    fn place(&self, (x, y): (f64, f64)) -> Option<(f64, f64)> {
        let (s, t) = (self.x.position(x)?, self.y.position(y)?);
        let inside = |p: f64| (-0.001..=1.001).contains(&p);
        (inside(s) && inside(t)).then(|| (across(s), up(t)))
    }
}

fn across(s: f64) -> f64 {
    LEFT + s * (WIDTH - LEFT - RIGHT)
}

fn up(t: f64) -> f64 {
    TOP + (1.0 - t) * PLOT_HEIGHT
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

fn paint(series: &Series) -> Paint {
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

fn draw_sample(canvas: &Canvas<'_>, series: &Series, index: usize, (x, y): (f64, f64)) -> Result<()> {
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
