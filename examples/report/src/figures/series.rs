//! What a chart is made of: axes and series.

use super::Colour;
use super::scale::{Scale, Tick};

/// An axis: its label (with the unit, or the word nondimensional left to the label), scale and optional
/// range.
#[derive(Debug, Clone, PartialEq)]
pub struct Axis {
    pub(super) label: String,
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
        Self { label: label.into(), logarithmic: true, range: None, rows: Vec::new() }
    }

    /// Named rows from above: row k is drawn at −k.
    pub fn rows(names: Vec<String>) -> Self {
        let range = Some((0.5 - names.len() as f64, 0.5));
        Self { label: String::new(), logarithmic: false, range, rows: names }
    }

    /// How many named rows it has.
    pub(super) fn row_count(&self) -> usize {
        self.rows.len()
    }

    /// The same axis over exactly [low, high].
    pub fn range(mut self, low: f64, high: f64) -> Self {
        self.range = Some((low, high));
        self
    }

    /// The scale that shows the given values, or the range asked for.
    pub(super) fn scale(&self, values: impl Iterator<Item = f64>) -> Scale {
        match self.range {
            Some((low, high)) => Scale::exact(low, high, self.logarithmic),
            None => Scale::fit(values, self.logarithmic),
        }
    }

    /// The ticks of its scale: the rows, or at most about `most` round numbers.
    pub(super) fn ticks(&self, scale: &Scale, most: usize) -> Vec<Tick> {
        if self.rows.is_empty() {
            return scale.ticks(most);
        }
        let row = |(k, name): (usize, &String)| {
            let position = scale.position(-(k as f64))?;
            Some(Tick { position, label: Some(name.clone()) })
        };
        self.rows.iter().enumerate().filter_map(row).collect()
    }
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Mark {
    Line,
    Dashed,
    Points,
    LineAndPoints,
}

/// A named sequence of points, drawn as a line, as points, or both.
#[derive(Debug, Clone, PartialEq)]
pub struct Series {
    pub(super) name: String,
    pub(super) points: Vec<(f64, f64)>,
    pub(super) half_bars: Vec<f64>,
    pub(super) mark: Mark,
    pub(super) colour: Option<Colour>,
}

impl Series {
    fn new(name: impl Into<String>, points: Vec<(f64, f64)>, mark: Mark) -> Self {
        Self { name: name.into(), points, half_bars: Vec::new(), mark, colour: None }
    }

    /// A line through the points.
    pub fn line(name: impl Into<String>, points: Vec<(f64, f64)>) -> Self {
        Self::new(name, points, Mark::Line)
    }

    /// A dashed line: bounds and theory.
    pub fn dashed(name: impl Into<String>, points: Vec<(f64, f64)>) -> Self {
        Self::new(name, points, Mark::Dashed)
    }

    /// Points only: measurements.
    pub fn points(name: impl Into<String>, points: Vec<(f64, f64)>) -> Self {
        Self::new(name, points, Mark::Points)
    }

    /// Points joined by a line.
    pub fn line_and_points(name: impl Into<String>, points: Vec<(f64, f64)>) -> Self {
        Self::new(name, points, Mark::LineAndPoints)
    }

    /// Error bars of the given half heights, one per point.
    pub fn bars(mut self, half_bars: Vec<f64>) -> Self {
        self.half_bars = half_bars;
        self
    }

    /// A fixed colour instead of the next one of the palette.
    pub fn colour(mut self, colour: Colour) -> Self {
        self.colour = Some(colour);
        self
    }
}
