//! Plots of columns of the rows or of given points: as SVG, and as comma-separated values.

use super::PALETTE;
use super::chart::chart;
use crate::cell::{Cell, Cells};
use crate::{Error, Result};
use plotters::style::RGBColor;
use std::fmt::Write as _;
use std::path::Path;

/// Digits of a table behind the first one: a picture shows four, and processors agree on these.
const DIGITS: usize = 7;

/// The two axes, with their labels. A logarithmic axis does not show values ≤ 0.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Axes {
    /// Both logarithmic.
    LogLog(&'static str, &'static str),
    /// The first logarithmic.
    LogLinear(&'static str, &'static str),
    /// The second logarithmic.
    LinearLog(&'static str, &'static str),
    /// Both linear.
    Linear(&'static str, &'static str),
}

impl Axes {
    /// Both labels, and whether the axes are logarithmic.
    fn parts(self) -> ([&'static str; 2], [bool; 2]) {
        match self {
            Axes::LogLog(x, y) => ([x, y], [true, true]),
            Axes::LogLinear(x, y) => ([x, y], [true, false]),
            Axes::LinearLog(x, y) => ([x, y], [false, true]),
            Axes::Linear(x, y) => ([x, y], [false, false]),
        }
    }
}

/// How a series is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Mark {
    Line,
    Dashed,
    Points,
    LineAndPoints,
}

/// A named sequence of points.
#[derive(Debug, Clone)]
pub(super) struct Series {
    pub(super) name: String,
    pub(super) points: Vec<(f64, f64)>,
    pub(super) mark: Mark,
}

/// Vertical bands behind the data: intervals of the horizontal axis that belong together.
#[derive(Debug, Clone)]
pub(super) struct Bands {
    pub(super) name: &'static str,
    pub(super) intervals: Vec<(f64, f64)>,
    pub(super) colour: RGBColor,
}

#[derive(Debug, Clone)]
enum Drawn {
    /// Column y over column x, one curve for each value of column `by`.
    Rows {
        mark: Mark,
        x: &'static str,
        y: &'static str,
        by: Option<&'static str>,
    },
    Given(Series),
}

/// A plot whose curves are columns of the rows, or go through given points. Curves have the colours
/// of the palette in turn; from the eighth one on, where the colours repeat, a plain line has
/// markers.
#[derive(Debug, Clone)]
pub struct Plot {
    pub(crate) name: String,
    pub(super) title: String,
    pub(super) labels: [&'static str; 2],
    pub(super) logarithmic: [bool; 2],
    pub(super) ranges: [Option<(f64, f64)>; 2],
    /// Names of rows in place of the ticks of the vertical axis.
    pub(super) row_names: Vec<String>,
    pub(super) bands: Vec<Bands>,
    drawn: Vec<Drawn>,
}

impl Plot {
    pub(crate) fn new(name: &str, title: &str, axes: Axes) -> Self {
        let (labels, logarithmic) = axes.parts();
        Self {
            name: name.to_owned(),
            title: title.to_owned(),
            labels,
            logarithmic,
            ranges: [None; 2],
            row_names: Vec::new(),
            bands: Vec::new(),
            drawn: Vec::new(),
        }
    }

    /// Sets the intervals that the axes show, in place of those that fit the data.
    pub fn ranges(&mut self, x: (f64, f64), y: (f64, f64)) -> &mut Self {
        self.ranges = [Some(x), Some(y)];
        self
    }

    /// Makes the vertical axis one of named rows from top to bottom, row k at −k.
    pub fn named_rows(&mut self, names: Vec<String>) -> &mut Self {
        self.ranges[1] = Some((0.5 - names.len() as f64, 0.5));
        self.row_names = names;
        self
    }

    fn rows(
        &mut self,
        mark: Mark,
        x: &'static str,
        y: &'static str,
        by: Option<&'static str>,
    ) -> &mut Self {
        self.drawn.push(Drawn::Rows { mark, x, y, by });
        self
    }

    pub(super) fn given(&mut self, mark: Mark, name: &str, points: Vec<(f64, f64)>) -> &mut Self {
        self.drawn.push(Drawn::Given(Series { name: name.to_owned(), points, mark }));
        self
    }

    /// Column y over column x: points joined by a line.
    pub fn curve(&mut self, x: &'static str, y: &'static str) -> &mut Self {
        self.rows(Mark::LineAndPoints, x, y, None)
    }

    /// A curve for each value of a third column.
    pub fn curve_by(&mut self, by: &'static str, x: &'static str, y: &'static str) -> &mut Self {
        self.rows(Mark::LineAndPoints, x, y, Some(by))
    }

    /// Column y over column x: points only.
    pub fn points(&mut self, x: &'static str, y: &'static str) -> &mut Self {
        self.rows(Mark::Points, x, y, None)
    }

    /// Points for each value of a third column.
    pub fn points_by(&mut self, by: &'static str, x: &'static str, y: &'static str) -> &mut Self {
        self.rows(Mark::Points, x, y, Some(by))
    }

    /// Column y over column x as a dashed line, for bounds and laws.
    pub fn dashed(&mut self, x: &'static str, y: &'static str) -> &mut Self {
        self.rows(Mark::Dashed, x, y, None)
    }

    /// A dashed line for each value of a third column.
    pub fn dashed_by(&mut self, by: &'static str, x: &'static str, y: &'static str) -> &mut Self {
        self.rows(Mark::Dashed, x, y, Some(by))
    }

    /// A dashed line through given points.
    pub fn dashed_line(&mut self, name: &str, points: Vec<(f64, f64)>) -> &mut Self {
        self.given(Mark::Dashed, name, points)
    }

    /// A dashed line y = C x^exponent through the first of these points, at their abscissae.
    pub fn power(&mut self, name: &str, points: &[(f64, f64)], exponent: f64) -> &mut Self {
        let place =
            |point: &(f64, f64)| (point.0, points[0].1 * (point.0 / points[0].0).powf(exponent));
        self.dashed_line(name, points.iter().map(place).collect())
    }

    /// A line through given points.
    pub fn line(&mut self, name: &str, points: Vec<(f64, f64)>) -> &mut Self {
        self.given(Mark::Line, name, points)
    }

    /// Given points.
    pub fn given_points(&mut self, name: &str, points: Vec<(f64, f64)>) -> &mut Self {
        self.given(Mark::Points, name, points)
    }

    /// The plot of these rows as SVG and its points as comma-separated values; `title` gives the
    /// title of a column.
    ///
    /// # Errors
    /// [`Error::File`] if plotters cannot draw.
    pub(crate) fn files(
        &self,
        rows: &[Cells],
        title: &dyn Fn(&str) -> String,
    ) -> Result<[String; 2]> {
        let mut series: Vec<Series> = Vec::new();
        for drawn in &self.drawn {
            match drawn {
                Drawn::Given(given) => series.push(given.clone()),
                Drawn::Rows { mark, x, y, by } => {
                    let start = series.len();
                    for row in rows {
                        let point = (row.number(x), row.number(y));
                        if !(point.0.is_finite() && point.1.is_finite()) {
                            continue;
                        }
                        let which = by.and_then(|by| match row.get(by)? {
                            Cell::Text(words) => Some(format!(", {words}")),
                            other => Some(format!(", {} = {}", title(by), other.short())),
                        });
                        let name = title(y) + &which.unwrap_or_default();
                        match series[start..].iter_mut().find(|known| known.name == name) {
                            Some(known) => known.points.push(point),
                            None => series.push(Series { name, points: vec![point], mark: *mark }),
                        }
                    }
                }
            }
        }
        let repeated = series.iter_mut().skip(PALETTE.len());
        repeated.filter(|s| s.mark == Mark::Line).for_each(|s| s.mark = Mark::LineAndPoints);
        let svg =
            chart(self, &series).map_err(|error| Error::file(Path::new(&self.name), error))?;
        Ok([svg, self.csv(&series)])
    }

    /// One line per point: series, x, y, and a column for the half length of a bar. The heads of
    /// the columns are the labels of the axes.
    fn csv(&self, series: &[Series]) -> String {
        let [x, y] = self.labels.map(quoted);
        let mut text = format!("series,{x},{y},half bar\n");
        for series in series {
            let name = quoted(&series.name);
            for &(x, y) in &series.points {
                let _ = writeln!(text, "{name},{},{},", written(x), written(y));
            }
        }
        text
    }
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
    fn every_point_is_a_line() {
        let mut plot = Plot::new("p", "a < b", Axes::LogLinear("x, length", "y"));
        plot.given_points("a \"b\"", vec![(1.0, 0.123_456_789), (1e-30, 2.0), (0.0, 1.0)]);
        let [svg, csv] = plot.files(&[], &str::to_owned).unwrap();
        let lines = "series,\"x, length\",\"y\",half bar\n\
            \"a \"\"b\"\"\",1,0.12345679,\n\"a \"\"b\"\"\",1e-30,2,\n\"a \"\"b\"\"\",0,1,\n";
        assert_eq!(csv, lines);
        assert!(
            svg.contains("aria-label=\"a &lt; b\"") && !svg.contains("NaN") && !svg.contains("inf")
        );
    }
}
