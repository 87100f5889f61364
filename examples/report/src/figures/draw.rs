//! Line and point charts on linear or logarithmic axes, with a legend below the plot, so that it never covers data.

use super::canvas::{Anchor, Canvas, Paint};
use super::chart::{BELOW, Chart, Frame, LEFT, PLOT_HEIGHT, RIGHT, ROW, TEXT_SIZE, TOP, WIDTH};
use super::legend::Legend;
use super::marks::{draw_run, paint};
use super::series::Series;
use crate::Result;

impl Chart {
    /// The chart as SVG text.
    ///
    /// # Errors
    /// [`crate::Error::Figure`] when the drawing backend fails.
    pub fn svg(&self) -> Result<String> {
        let legend = Legend::of(self);
        let frame = self.frame();
        let height = frame.height + BELOW + legend.height() + TOP + 8.0;
        Canvas::draw(WIDTH, height, &self.title, |canvas| {
            canvas.text(&self.title, (WIDTH / 2.0, TOP / 2.0), TEXT_SIZE + 1.0, Anchor::Centre)?;
            self.draw_bands(canvas, &frame)?;
            self.draw_axes(canvas, &frame)?;
            self.draw_asymptotes(canvas, &frame)?;
            self.series.iter().enumerate().try_for_each(|(k, s)| draw_series(canvas, &frame, s, k))?;
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

    fn frame(&self) -> Frame {
        let points = || self.series.iter().flat_map(|s| &s.points);
        let bars = self.series.iter().flat_map(|s| s.points.iter().zip(&s.half_bars));
        let ends = bars.flat_map(|(p, b)| [p.1 - b, p.1 + b]);
        let bands = self.bands.iter().flat_map(|b| &b.intervals).flat_map(|&(a, b)| [a, b]);
        let asymptotes = self.asymptotes.iter().map(|asymptote| asymptote.0);
        Frame {
            x: self.x.scale(points().map(|p| p.0).chain(bands).chain(asymptotes)),
            y: self.y.scale(points().map(|p| p.1).chain(ends)),
            width: WIDTH - LEFT - RIGHT,
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figures::Axis;

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
