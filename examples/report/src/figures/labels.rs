//! Names beside the curves, at the right of the plot, each with a line to the end of its curve.

use super::canvas::{Anchor, Canvas, Paint};
use super::chart::{CHARACTER, Chart, Frame};
use super::marks::{draw_sample, paint};
use super::series::Series;
use crate::Result;

/// Entries that a legend may have.
const MOST: usize = 6;
const SIZE: f64 = 14.0;
/// From line to line, and more from name to name: room for the letters of a narrow screen.
const LINE: f64 = 21.5;
const APART: f64 = 6.0;
/// Characters of a line, at which names are broken between words.
const CHARACTERS: usize = 24;
/// From the plot to the sample, from the sample to its name.
const GAP: f64 = 26.0;
const SAMPLE: f64 = 32.0;

/// Series with their names in lines; none for a chart with a legend.
pub(super) struct Labels<'a> {
    series: Vec<(usize, &'a Series, Vec<String>)>,
}

impl<'a> Labels<'a> {
    /// Whether series have their names beside them.
    pub(super) fn has(chart: &Chart) -> bool {
        chart.series.len() + chart.bands.len() > MOST
    }

    pub(super) fn of(chart: &'a Chart) -> Self {
        let series = chart.series.iter().enumerate().filter(|_| Self::has(chart));
        Self { series: series.map(|(k, series)| (k, series, broken(&series.name))).collect() }
    }

    /// All of them one below the other.
    pub(super) fn height(&self) -> f64 {
        self.series.iter().map(|(.., lines)| height(lines)).sum()
    }

    /// What is taken from the width of the plot.
    pub(super) fn width(&self) -> f64 {
        let longest = self.series.iter().flat_map(|(.., lines)| lines).map(|line| line.chars().count()).max();
        longest.map_or(0.0, |longest| GAP + SAMPLE + CHARACTER * SIZE * longest as f64 - 12.0)
    }

    /// Draws them in the order of the ends of their curves, none above another.
    pub(super) fn draw(&self, canvas: &Canvas<'_>, frame: &Frame) -> Result<()> {
        let mut shown: Vec<_> = self
            .series
            .iter()
            .filter_map(|(k, series, lines)| Some((end(frame, series)?, *k, *series, lines)))
            .collect();
        shown.sort_by(|a, b| a.0.1.total_cmp(&b.0.1));
        let heights: Vec<f64> = shown.iter().map(|label| height(label.3)).collect();
        let wanted: Vec<f64> = shown.iter().map(|label| label.0.1).collect();
        let bottom = frame.up(0.0).max(frame.up(1.0) + self.height());
        let places = apart(&wanted, &heights, (frame.up(1.0), bottom));
        let x = frame.across(1.0) + GAP;
        for ((end, k, series, lines), y) in shown.into_iter().zip(places) {
            canvas.line(&[end, (x - 4.0, y)], soft(paint(series)), 0.8)?;
            draw_sample(canvas, series, k, (x, y))?;
            for (j, line) in lines.iter().enumerate() {
                let y = y + LINE * (j as f64 - 0.5 * (lines.len() as f64 - 1.0));
                canvas.text(line, (x + SAMPLE, y), SIZE, Anchor::Left)?;
            }
        }
        Ok(())
    }
}

fn height(lines: &[String]) -> f64 {
    LINE * lines.len() as f64 + APART
}

fn soft(paint: Paint) -> Paint {
    match paint {
        Paint::Colour(colour, _) => Paint::Colour(colour, 0.6),
        ink => ink,
    }
}

/// The point of a series furthest to the right.
fn end(frame: &Frame, series: &Series) -> Option<(f64, f64)> {
    let places = series.points.iter().filter_map(|&point| frame.place(point));
    places.max_by(|a, b| a.0.total_cmp(&b.0))
}

/// A name in lines, broken between words.
fn broken(name: &str) -> Vec<String> {
    let mut lines = vec![String::new()];
    for word in name.split(' ') {
        match lines.last_mut() {
            Some(line) if line.is_empty() => line.push_str(word),
            Some(line) if line.chars().count() + word.chars().count() < CHARACTERS => {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(word.to_owned()),
        }
    }
    lines
}

/// Places in rising order, near those wanted, for labels of these heights without overlap: runs of labels that
/// touch are centred on the mean of what they want, inside (top, bottom) while there is room.
fn apart(wanted: &[f64], heights: &[f64], (top, bottom): (f64, f64)) -> Vec<f64> {
    // Runs: where they begin, how high they are, how many labels they hold.
    let mut runs: Vec<(f64, f64, Vec<f64>)> = Vec::new();
    for (&place, &height) in wanted.iter().zip(heights) {
        let mut run = (place - 0.5 * height, height, vec![place - 0.5 * height]);
        loop {
            run.0 = run.0.min(bottom - run.1).max(top);
            match runs.last() {
                Some(before) if before.0 + before.1 > run.0 => {}
                _ => break,
            }
            let Some(before) = runs.pop() else { break };
            // The beginnings that the labels of the joined run want for it.
            let starts: Vec<f64> =
                before.2.iter().copied().chain(run.2.iter().map(|start| start - before.1)).collect();
            run = (starts.iter().sum::<f64>() / starts.len() as f64, before.1 + run.1, starts);
        }
        runs.push(run);
    }
    let mut heights = heights.iter();
    let mut places = Vec::new();
    for (start, _, labels) in runs {
        let mut y = start;
        for height in heights.by_ref().take(labels.len()) {
            places.push(y + 0.5 * height);
            y += height;
        }
    }
    places
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn labels_keep_their_order_and_distance() {
        let heights = [16.0, 29.0, 16.0, 16.0];
        let places = apart(&[10.0, 12.0, 13.0, 200.0], &heights, (0.0, 320.0));
        for k in 1..4 {
            assert!(places[k] - places[k - 1] >= 0.5 * (heights[k] + heights[k - 1]) - 1e-9, "{places:?}");
        }
        assert!(places[0] >= 8.0 - 1e-9 && places[3] == 200.0, "{places:?}");
        let low = apart(&[318.0, 319.0], &[16.0, 16.0], (0.0, 320.0));
        assert!(low[1] <= 312.0 + 1e-9, "{low:?}");
    }

    #[test]
    fn long_names_are_broken_between_words() {
        let name = "fast product and its setup, geometric 1e-30, N 2000";
        assert!(broken(name).iter().all(|line| line.chars().count() <= CHARACTERS));
        assert_eq!(broken(name).join(" "), name);
    }
}
