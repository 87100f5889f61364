//! Lines and markers of a series.

use super::PALETTE;
use super::canvas::{Canvas, Paint};
use super::series::{Mark, Series};
use crate::Result;

pub(super) fn paint(series: &Series) -> Paint {
    Paint::Colour(series.colour.unwrap_or(PALETTE[0]), 1.0)
}

pub(super) fn draw_run(canvas: &Canvas<'_>, series: &Series, index: usize, run: &[(f64, f64)]) -> Result<()> {
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
