//! Line and point charts on linear or logarithmic axes, with a legend below the plot, so that it never covers
//! data; the data of a chart as comma-separated values.

use super::canvas::{Anchor, Canvas, Paint};
use super::scale::{Scale, Tick};
use super::{Colour, PALETTE};
use crate::Result;
use crate::files::write_whole;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};

const WIDTH: f64 = 640.0;
const PLOT_HEIGHT: f64 = 320.0;
/// From row to row of named rows, with room for the letters of a narrow screen; and of the legend.
const ROW: f64 = 21.5;
const LEGEND: f64 = 22.0;
const LEFT: f64 = 88.0;
const RIGHT: f64 = 22.0;
const TOP: f64 = 36.0;
/// Ticks and label of the horizontal axis.
const BELOW: f64 = 56.0;
const TEXT_SIZE: f64 = 15.0;
/// Mean width of a character relative to the text size, for laying out words.
const CHARACTER: f64 = 0.56;
/// Digits of a table behind the first one: a picture shows four, and processors agree on these.
const DIGITS: usize = 7;

/// An axis: label, scale and optional range.
#[derive(Debug, Clone, PartialEq)]
pub struct Axis {
    label: String,
    logarithmic: bool,
    range: Option<(f64, f64)>,
    rows: Vec<String>,
}

impl Axis {
    /// A linear axis that fits the data.
    pub fn linear(label: impl Into<String>) -> Self {
        Self { label: label.into(), logarithmic: false, range: None, rows: Vec::new() }
    }

    /// A base-ten logarithmic axis that fits the positive data; values ≤ 0 are not drawn.
    pub fn logarithmic(label: impl Into<String>) -> Self {
        Self { logarithmic: true, ..Self::linear(label) }
    }

    /// An axis of named rows from top to bottom, row k at −k.
    pub fn rows(names: Vec<String>) -> Self {
        Self { range: Some((0.5 - names.len() as f64, 0.5)), rows: names, ..Self::linear("") }
    }

    /// The same axis with the range \[low, high\].
    pub fn range(mut self, low: f64, high: f64) -> Self {
        self.range = Some((low, high));
        self
    }

    /// The scale that shows the given values, or the range asked for.
    fn scale(&self, values: impl Iterator<Item = f64>) -> Scale {
        match self.range {
            Some((low, high)) => Scale::exact(low, high, self.logarithmic),
            None => Scale::fit(values, self.logarithmic),
        }
    }

    /// The ticks of its scale: the rows, or round numbers.
    fn ticks(&self, scale: &Scale) -> Vec<Tick> {
        if self.rows.is_empty() {
            return scale.ticks();
        }
        let row = |(k, name): (usize, &String)| {
            Some(Tick { position: scale.position(-(k as f64))?, label: name.clone() })
        };
        self.rows.iter().enumerate().filter_map(row).collect()
    }
}

/// How a series is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Mark {
    Line,
    Dashed,
    Points,
    LineAndPoints,
}

/// A named sequence of points, drawn as a line, as points, or both.
#[derive(Debug, Clone, PartialEq)]
pub struct Series {
    name: String,
    points: Vec<(f64, f64)>,
    mark: Mark,
}

impl Series {
    pub(crate) fn new(name: impl Into<String>, points: Vec<(f64, f64)>, mark: Mark) -> Self {
        Self { name: name.into(), points, mark }
    }

    /// A line through the points.
    pub fn line(name: impl Into<String>, points: Vec<(f64, f64)>) -> Self {
        Self::new(name, points, Mark::Line)
    }

    /// A dashed line through the points, for bounds and theory.
    pub fn dashed(name: impl Into<String>, points: Vec<(f64, f64)>) -> Self {
        Self::new(name, points, Mark::Dashed)
    }

    /// Points only, for measurements.
    pub fn points(name: impl Into<String>, points: Vec<(f64, f64)>) -> Self {
        Self::new(name, points, Mark::Points)
    }

    /// Points joined by a line.
    pub fn line_and_points(name: impl Into<String>, points: Vec<(f64, f64)>) -> Self {
        Self::new(name, points, Mark::LineAndPoints)
    }
}

/// Vertical bands behind the data: intervals of the horizontal axis that belong together.
#[derive(Debug, Clone, PartialEq)]
struct Bands {
    name: String,
    intervals: Vec<(f64, f64)>,
    colour: Colour,
}

/// A chart: title, two axes, series, bands. Build it, then [`Chart::svg`].
#[derive(Debug, Clone, PartialEq)]
pub struct Chart {
    title: String,
    x: Axis,
    y: Axis,
    series: Vec<Series>,
    bands: Vec<Bands>,
}

impl Chart {
    /// A chart without data.
    pub fn new(title: impl Into<String>, x: Axis, y: Axis) -> Self {
        Self { title: title.into(), x, y, series: Vec::new(), bands: Vec::new() }
    }

    /// The chart with one more series, in the next colour of the palette. From the eighth series on, where
    /// the colours repeat, a plain line has markers.
    #[must_use]
    pub fn with(mut self, mut series: Series) -> Self {
        if self.series.len() >= PALETTE.len() && series.mark == Mark::Line {
            series.mark = Mark::LineAndPoints;
        }
        self.series.push(series);
        self
    }

    /// Shades intervals of the horizontal axis.
    #[must_use]
    pub(super) fn with_bands(mut self, name: &str, intervals: Vec<(f64, f64)>, colour: Colour) -> Self {
        self.bands.push(Bands { name: name.to_owned(), intervals, colour });
        self
    }

    /// Writes `directory/name.svg` and `directory/name.csv` and returns the path of the first.
    ///
    /// # Errors
    /// [`crate::Error::Figure`] when the drawing backend fails, [`crate::Error::File`] when a file cannot
    /// be written.
    pub(crate) fn save(&self, directory: &Path, name: &str) -> Result<PathBuf> {
        write_whole(&directory.join(format!("{name}.csv")), &self.csv())?;
        save_svg(&self.svg()?, directory, name)
    }

    /// One line per point: series, x, y, and a column for the half length of a bar. The heads of the columns are the
    /// labels of the axes.
    fn csv(&self) -> String {
        let [x, y] = [&self.x.label, &self.y.label].map(|label| quoted(label));
        let mut text = format!("series,{x},{y},half bar\n");
        for series in &self.series {
            let name = quoted(&series.name);
            for &(x, y) in &series.points {
                let _ = writeln!(text, "{name},{},{},", written(x), written(y));
            }
        }
        text
    }

    /// The chart as SVG text.
    ///
    /// # Errors
    /// [`crate::Error::Figure`] when the drawing backend fails.
    pub fn svg(&self) -> Result<String> {
        let legend = self.legend();
        let points = || self.series.iter().flat_map(|s| &s.points);
        let bands = self.bands.iter().flat_map(|b| &b.intervals).flat_map(|&(a, b)| [a, b]);
        let frame = Frame {
            x: self.x.scale(points().map(|p| p.0).chain(bands)),
            y: self.y.scale(points().map(|p| p.1)),
            height: PLOT_HEIGHT.max(ROW * self.y.rows.len() as f64),
        };
        let height = frame.height + BELOW + LEGEND * legend.len() as f64 + TOP + 8.0;
        Canvas::draw(WIDTH, height, &self.title, |canvas| {
            canvas.text(&self.title, (WIDTH / 2.0, TOP / 2.0), TEXT_SIZE + 1.0, Anchor::Centre)?;
            self.draw_bands(canvas, &frame)?;
            self.draw_axes(canvas, &frame)?;
            for (k, series) in self.series.iter().enumerate() {
                let places: Vec<_> = series.points.iter().map(|&p| frame.place(p)).collect();
                for run in places.split(Option::is_none) {
                    let run: Vec<_> = run.iter().flatten().copied().collect();
                    draw_run(canvas, series.mark, k, &run)?;
                }
            }
            for (row, entries) in legend.iter().enumerate() {
                let y = frame.up(0.0) + BELOW + LEGEND * (row as f64 + 0.5);
                entries.iter().try_for_each(|&(index, x)| self.draw_entry(canvas, index, (x, y)))?;
            }
            Ok(())
        })
    }

    /// Series, then bands, in rows that fit the width: number and horizontal position of each.
    fn legend(&self) -> Vec<Vec<(usize, f64)>> {
        let names = self.series.iter().map(|s| &s.name).chain(self.bands.iter().map(|b| &b.name));
        let mut rows: Vec<Vec<(usize, f64)>> = Vec::new();
        let mut x = f64::INFINITY;
        for (index, name) in names.enumerate() {
            let width = 44.0 + CHARACTER * TEXT_SIZE * name.chars().count() as f64;
            if x + width > WIDTH - RIGHT {
                rows.push(Vec::new());
                x = LEFT;
            }
            if let Some(row) = rows.last_mut() {
                row.push((index, x));
            }
            x += width + 12.0;
        }
        rows
    }

    fn draw_entry(&self, canvas: &Canvas<'_>, index: usize, (x, y): (f64, f64)) -> Result<()> {
        let (line, middle) = ([(x, y), (x + 28.0, y)], [(x + 14.0, y)]);
        let name = match self.series.get(index) {
            None => {
                let bands = &self.bands[index - self.series.len()];
                let corners = [(x, y - 6.0), (x + 28.0, y - 6.0), (x + 28.0, y + 6.0), (x, y + 6.0)];
                canvas.polygon(&corners, Paint::Colour(bands.colour, 0.25))?;
                &bands.name
            }
            Some(Series { mark: Mark::LineAndPoints, name, .. }) => {
                canvas.line(&line, paint(index), 1.5)?;
                draw_run(canvas, Mark::Points, index, &middle)?;
                name
            }
            Some(Series { mark: Mark::Points, name, .. }) => {
                draw_run(canvas, Mark::Points, index, &middle)?;
                name
            }
            Some(Series { mark, name, .. }) => {
                draw_run(canvas, *mark, index, &line)?;
                name
            }
        };
        canvas.text(name, (x + 36.0, y), TEXT_SIZE, Anchor::Left)
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
        let (bottom, grid) = (frame.up(0.0), Paint::Ink(0.15));
        for tick in self.x.ticks(&frame.x) {
            let x = frame.across(tick.position);
            canvas.line(&[(x, bottom), (x, frame.up(1.0))], grid, 0.8)?;
            canvas.text(&tick.label, (x, bottom + 14.0), TEXT_SIZE, Anchor::Centre)?;
        }
        for tick in self.y.ticks(&frame.y) {
            let y = frame.up(tick.position);
            canvas.line(&[(frame.across(0.0), y), (frame.across(1.0), y)], grid, 0.8)?;
            canvas.text(&tick.label, (frame.across(0.0) - 7.0, y), TEXT_SIZE, Anchor::Right)?;
        }
        let corners = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0), (0.0, 0.0)];
        canvas.line(&corners.map(|(s, t)| (frame.across(s), frame.up(t))), Paint::Ink(0.8), 1.0)?;
        canvas.text(&self.x.label, (frame.across(0.5), bottom + 39.0), TEXT_SIZE, Anchor::Centre)?;
        canvas.text(&self.y.label, (14.0, frame.up(0.5)), TEXT_SIZE, Anchor::Upwards)
    }
}

/// The plot: both scales, and its height.
struct Frame {
    x: Scale,
    y: Scale,
    height: f64,
}

impl Frame {
    /// The place of a data point, if it can be shown inside the frame.
    fn place(&self, (x, y): (f64, f64)) -> Option<(f64, f64)> {
        let (s, t) = (self.x.position(x)?, self.y.position(y)?);
        let inside = |p: f64| (-0.001..=1.001).contains(&p);
        (inside(s) && inside(t)).then(|| (self.across(s), self.up(t)))
    }

    fn across(&self, s: f64) -> f64 {
        LEFT + s * (WIDTH - LEFT - RIGHT)
    }

    fn up(&self, t: f64) -> f64 {
        TOP + (1.0 - t) * self.height
    }
}

fn paint(index: usize) -> Paint {
    Paint::Colour(PALETTE[index % PALETTE.len()], 1.0)
}

/// Points in a row as the series of this number draws them; markers are discs, squares, diamonds and triangles in turn.
fn draw_run(canvas: &Canvas<'_>, mark: Mark, index: usize, run: &[(f64, f64)]) -> Result<()> {
    let paint = paint(index);
    match mark {
        Mark::Line => return canvas.line(run, paint, 1.8),
        Mark::Dashed => return canvas.dashes(run, paint, 1.6, (7.0, 4.0)),
        Mark::LineAndPoints => canvas.line(run, paint, 1.5)?,
        Mark::Points => {}
    }
    let r = 3.6;
    let corners: &[(f64, f64)] = match index % 4 {
        0 => return run.iter().try_for_each(|&centre| canvas.disc(centre, r, paint)),
        1 => &[(-0.9, -0.9), (0.9, -0.9), (0.9, 0.9), (-0.9, 0.9)],
        2 => &[(0.0, -1.25), (1.25, 0.0), (0.0, 1.25), (-1.25, 0.0)],
        _ => &[(0.0, -1.25), (1.1, 0.8), (-1.1, 0.8)],
    };
    run.iter().try_for_each(|&(x, y)| {
        let corners: Vec<_> = corners.iter().map(|&(a, b)| (x + r * a, y + r * b)).collect();
        canvas.polygon(&corners, paint)
    })
}

/// Writes a picture and returns its path.
pub(crate) fn save_svg(text: &str, directory: &Path, name: &str) -> Result<PathBuf> {
    let path = directory.join(format!("{name}.svg"));
    write_whole(&path, text)?;
    Ok(path)
}

/// Text in quotes, quotes in it doubled.
fn quoted(text: &str) -> String {
    format!("\"{}\"", text.replace('"', "\"\""))
}

/// A number rounded to eight digits, written as briefly as possible.
fn written(value: f64) -> String {
    let rounded = format!("{value:.DIGITS$e}").parse::<f64>().unwrap_or(value);
    let plain = rounded.to_string();
    if plain.len() > 12 { format!("{rounded:e}") } else { plain }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_chart_is_svg_with_ink_in_the_colour_of_the_page() {
        let chart = Chart::new("a < b", Axis::logarithmic("h"), Axis::logarithmic("error"))
            .with(Series::points("measured", vec![(0.1, 1e-2), (0.01, 1e-4), (0.001, f64::NAN)]))
            .with(Series::dashed("h²", vec![(0.1, 1e-2), (0.001, 1e-6)]));
        let svg = chart.svg().unwrap();
        assert!(svg.starts_with("<svg") && svg.trim_end().ends_with("</svg>"));
        assert!(svg.contains("currentColor") && !svg.contains("#010203"));
        assert!(svg.contains("aria-label=\"a &lt; b\"") && !svg.contains("NaN"));
    }

    #[test]
    fn every_point_is_a_line() {
        let series = Series::points("a \"b\"", vec![(1.0, 0.123_456_789), (1e-30, 2.0)]);
        let chart = Chart::new("t", Axis::linear("x, length"), Axis::linear("y")).with(series);
        let lines = "series,\"x, length\",\"y\",half bar\n\
            \"a \"\"b\"\"\",1,0.12345679,\n\"a \"\"b\"\"\",1e-30,2,\n";
        assert_eq!(chart.csv(), lines);
    }
}
