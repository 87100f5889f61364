//! Saving a figure: the picture, and the numbers behind a chart as a table of comma-separated values beside
//! it.

use super::chart::Chart;
use crate::Result;
use crate::files::write_whole;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};

/// Digits behind the first one: a picture shows four, and processors agree on these.
const DIGITS: usize = 7;

impl Chart {
    /// Writes `directory/name.svg` and `directory/name.csv` and returns the path of the first.
    ///
    /// # Errors
    /// [`crate::Error::Figure`] when the drawing backend fails, [`crate::Error::File`] when a file cannot
    /// be written.
    pub fn save(&self, directory: &Path, name: &str) -> Result<PathBuf> {
        save(&self.csv(), directory, &format!("{name}.csv"))?;
        save_svg(&self.svg()?, directory, name)
    }

    /// One line per point: series, x, y, and half the length of its bar if it has one. The heads of the
    /// columns are the labels of the axes.
    fn csv(&self) -> String {
        let [x, y] = [&self.x.label, &self.y.label].map(|label| quoted(label));
        let mut text = format!("series,{x},{y},half bar\n");
        for series in &self.series {
            let name = quoted(&series.name);
            for (k, &(x, y)) in series.points.iter().enumerate() {
                let bar = series.half_bars.get(k).map(|&bar| written(bar)).unwrap_or_default();
                let _ = writeln!(text, "{name},{},{},{bar}", written(x), written(y));
            }
        }
        text
    }
}

/// Writes a picture and returns its path.
pub(crate) fn save_svg(text: &str, directory: &Path, name: &str) -> Result<PathBuf> {
    save(text, directory, &format!("{name}.svg"))
}

fn save(text: &str, directory: &Path, file: &str) -> Result<PathBuf> {
    let path = directory.join(file);
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
    use super::super::{Axis, Series};
    use super::*;

    #[test]
    fn every_point_is_a_line() {
        let series =
            Series::points("a \"b\"", vec![(1.0, 0.123_456_789), (1e-30, 2.0)]).bars(vec![0.5, 0.25]);
        let chart = Chart::new("t", Axis::linear("x, length"), Axis::linear("y")).with(series);
        let lines = "series,\"x, length\",\"y\",half bar\n\
            \"a \"\"b\"\"\",1,0.12345679,0.5\n\"a \"\"b\"\"\",1e-30,2,0.25\n";
        assert_eq!(chart.csv(), lines);
    }
}
