//! Charts of rows.

use crate::cell::{Cell, Cells};
use crate::figures::{Axis, Chart, Mark, Series};

/// A picture before it is written.
#[derive(Debug, Clone)]
pub(crate) enum Picture {
    Plot(Plot),
    Chart(String, Chart),
    Svg(String, String),
}

/// The two axes, with their labels.
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
    fn axes(self) -> [Axis; 2] {
        match self {
            Axes::LogLog(x, y) => [Axis::logarithmic(x), Axis::logarithmic(y)],
            Axes::LogLinear(x, y) => [Axis::logarithmic(x), Axis::linear(y)],
            Axes::LinearLog(x, y) => [Axis::linear(x), Axis::logarithmic(y)],
            Axes::Linear(x, y) => [Axis::linear(x), Axis::linear(y)],
        }
    }
}

#[derive(Debug, Clone)]
enum Drawn {
    /// Column x, column y, one curve for each value of column `by`.
    Rows {
        mark: Mark,
        x: &'static str,
        y: &'static str,
        by: Option<&'static str>,
    },
    Given(Series),
}

/// A chart whose curves are columns of the rows.
#[derive(Debug, Clone)]
pub struct Plot {
    pub(crate) name: String,
    title: String,
    axes: Axes,
    drawn: Vec<Drawn>,
}

impl Plot {
    pub(crate) fn new(name: &str, title: &str, axes: Axes) -> Self {
        Self { name: name.to_owned(), title: title.to_owned(), axes, drawn: Vec::new() }
    }

    fn rows(&mut self, mark: Mark, x: &'static str, y: &'static str, by: Option<&'static str>) -> &mut Self {
        self.drawn.push(Drawn::Rows { mark, x, y, by });
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
        self.drawn.push(Drawn::Given(Series::dashed(name, points)));
        self
    }

    /// A dashed line y = C x^exponent through the first of these points, at their abscissae.
    pub fn power(&mut self, name: &str, points: &[(f64, f64)], exponent: f64) -> &mut Self {
        let place = |point: &(f64, f64)| (point.0, points[0].1 * (point.0 / points[0].0).powf(exponent));
        self.dashed_line(name, points.iter().map(place).collect())
    }

    /// A line through given points.
    pub fn line(&mut self, name: &str, points: Vec<(f64, f64)>) -> &mut Self {
        self.drawn.push(Drawn::Given(Series::line(name, points)));
        self
    }

    /// The chart of these rows; `title` gives the title of a column.
    pub(crate) fn chart(&self, rows: &[Cells], title: &dyn Fn(&str) -> String) -> Chart {
        let [x, y] = self.axes.axes();
        let mut chart = Chart::new(&self.title, x, y);
        for drawn in &self.drawn {
            match drawn {
                Drawn::Given(series) => chart = chart.with(series.clone()),
                Drawn::Rows { mark, x, y, by } => {
                    for (name, points) in curves(rows, x, y, *by, title) {
                        chart = chart.with(Series::new(name, points, *mark));
                    }
                }
            }
        }
        chart
    }
}

/// The curves of one instruction, with their names, in the order of the rows.
fn curves(
    rows: &[Cells],
    x: &str,
    y: &str,
    by: Option<&str>,
    title: &dyn Fn(&str) -> String,
) -> Vec<(String, Vec<(f64, f64)>)> {
    let mut curves: Vec<(String, Vec<(f64, f64)>)> = Vec::new();
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
        match curves.iter_mut().find(|(known, _)| *known == name) {
            Some((_, points)) => points.push(point),
            None => curves.push((name, vec![point])),
        }
    }
    curves
}
