//! The legend below a chart, in rows that fit its width.

use super::canvas::{Anchor, Canvas, Paint};
use super::chart::{Bands, CHARACTER, Chart, LEFT, RIGHT, TEXT_SIZE, WIDTH};
use super::marks::draw_sample;
use super::series::Series;
use crate::Result;

const ROW: f64 = 22.0;

/// Entries in rows: each with its horizontal position.
pub(super) struct Legend<'a> {
    rows: Vec<Vec<(Entry<'a>, f64)>>,
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

impl<'a> Legend<'a> {
    pub(super) fn of(chart: &'a Chart) -> Self {
        let series = chart.series.iter().enumerate().map(|(k, s)| Entry::Series(s, k));
        let mut rows: Vec<Vec<(Entry<'_>, f64)>> = Vec::new();
        let mut x = f64::INFINITY;
        for entry in series.chain(chart.bands.iter().map(Entry::Bands)) {
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
        Self { rows }
    }

    pub(super) fn height(&self) -> f64 {
        ROW * self.rows.len() as f64
    }

    /// Draws it below `top`.
    pub(super) fn draw(&self, canvas: &Canvas<'_>, top: f64) -> Result<()> {
        for (k, row) in self.rows.iter().enumerate() {
            let y = top + ROW * (k as f64 + 0.5);
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
