//! The layout of a plot on linear or logarithmic axes, with a legend below it, so that it never covers data.

use super::PALETTE;
use super::plot::{Mark, Plot, Series};
use super::scale::Scale;
use super::svg::{Canvas, INK};

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
const FONT_SIZE: f64 = 12.1;
/// Mean width of a character, for laying out words.
const CHARACTER: f64 = 8.4;

/// The plot of these series as SVG.
pub(super) fn chart(plot: &Plot, series: &[Series]) -> String {
    let names = series.iter().map(|s| &*s.name).chain(plot.bands.iter().map(|band| band.name));
    let legend = legend(names);
    let points = || series.iter().flat_map(|s| &s.points);
    let ends = plot.bands.iter().flat_map(|band| &band.intervals).flat_map(|&(a, b)| [a, b]);
    let frame = Frame {
        x: Scale::of(plot.ranges[0], points().map(|p| p.0).chain(ends), plot.logarithmic[0]),
        y: Scale::of(plot.ranges[1], points().map(|p| p.1), plot.logarithmic[1]),
        height: PLOT_HEIGHT.max(ROW * plot.row_names.len() as f64),
    };
    let rows = legend.last().map_or(0.0, |&(row, ..)| row + 1.0);
    let height = frame.height + BELOW + LEGEND * rows + TOP + 8.0;
    let mut canvas = Canvas::new([WIDTH, height], &plot.title, FONT_SIZE);
    canvas.text(&plot.title, (WIDTH / 2.0, TOP / 2.0), "middle", " font-size=\"12.9\"");
    for band in &plot.bands {
        for &(a, b) in &band.intervals {
            if let (Some(a), Some(b)) = (frame.x.position(a), frame.x.position(b)) {
                let (a, b) = (frame.across(a.clamp(0.0, 1.0)), frame.across(b.clamp(0.0, 1.0)));
                rectangle(&mut canvas, (a, frame.up(1.0)), (b, frame.up(0.0)), band.colour);
            }
        }
    }
    frame.draw_axes(plot, &mut canvas);
    for (k, series) in series.iter().enumerate() {
        let places: Vec<_> = series.points.iter().map(|&p| frame.place(p)).collect();
        for run in places.split(Option::is_none) {
            let run: Vec<_> = run.iter().flatten().copied().collect();
            draw_run(&mut canvas, series.mark, k, &run, &run);
        }
    }
    for (index, (row, x, name)) in legend.into_iter().enumerate() {
        let y = frame.up(0.0) + BELOW + LEGEND * (row + 0.5);
        match series.get(index) {
            Some(series) => {
                draw_run(&mut canvas, series.mark, index, &[(x, y), (x + 28.0, y)], &[(x + 14.0, y)])
            }
            None => {
                let colour = plot.bands[index - series.len()].colour;
                rectangle(&mut canvas, (x, y - 6.0), (x + 28.0, y + 6.0), colour);
            }
        }
        canvas.text(name, (x + 36.0, y), "start", "");
    }
    canvas.finish()
}

/// The names in rows that fit the width: row and horizontal position of each.
fn legend<'a>(names: impl Iterator<Item = &'a str>) -> Vec<(f64, f64, &'a str)> {
    let (mut row, mut x) = (-1.0, f64::INFINITY);
    let mut places = Vec::new();
    for name in names {
        let width = 44.0 + CHARACTER * name.chars().count() as f64;
        if x + width > WIDTH - RIGHT {
            (row, x) = (row + 1.0, LEFT);
        }
        places.push((row, x, name));
        x += width + 12.0;
    }
    places
}

fn rectangle(canvas: &mut Canvas, (left, top): (f64, f64), (right, bottom): (f64, f64), colour: &str) {
    canvas.polygon(&[(left, bottom), (right, bottom), (right, top), (left, top)], (colour, 0.25));
}

/// Part of a series in its colour: the line, and at the places its marker: discs, squares, diamonds, triangles in turn.
fn draw_run(canvas: &mut Canvas, mark: Mark, index: usize, line: &[(f64, f64)], places: &[(f64, f64)]) {
    let colour = PALETTE[index % PALETTE.len()];
    match mark {
        Mark::Line => return canvas.line(line, (colour, 1.0), 1.8, ""),
        Mark::Dashed => return canvas.line(line, (colour, 1.0), 1.6, " stroke-dasharray=\"7 4\""),
        Mark::LineAndPoints => canvas.line(line, (colour, 1.0), 1.5, ""),
        Mark::Points => {}
    }
    let r = 3.6;
    let corners: &[(f64, f64)] = match index % 4 {
        0 => return places.iter().for_each(|&centre| canvas.disc(centre, r, colour)),
        1 => &[(-0.9, -0.9), (0.9, -0.9), (0.9, 0.9), (-0.9, 0.9)],
        2 => &[(0.0, -1.25), (1.25, 0.0), (0.0, 1.25), (-1.25, 0.0)],
        _ => &[(0.0, -1.25), (1.1, 0.8), (-1.1, 0.8)],
    };
    for &(x, y) in places {
        let corners: Vec<_> = corners.iter().map(|&(a, b)| (x + r * a, y + r * b)).collect();
        canvas.polygon(&corners, (colour, 1.0));
    }
}

/// Both scales, and the height of the frame.
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

    fn draw_axes(&self, plot: &Plot, canvas: &mut Canvas) {
        let ([left, right], [bottom, top]) =
            ([0.0, 1.0].map(|s| self.across(s)), [0.0, 1.0].map(|t| self.up(t)));
        for (position, label) in self.x.ticks() {
            let x = self.across(position);
            canvas.line(&[(x, bottom), (x, top)], (INK, 0.15), 0.8, "");
            canvas.text(&label, (x, bottom + 14.0), "middle", "");
        }
        let row = |(k, name): (usize, &String)| Some((self.y.position(-(k as f64))?, name.clone()));
        let ticks = match &*plot.row_names {
            [] => self.y.ticks(),
            names => names.iter().enumerate().filter_map(row).collect(),
        };
        for (position, label) in ticks {
            let y = self.up(position);
            canvas.line(&[(left, y), (right, y)], (INK, 0.15), 0.8, "");
            canvas.text(&label, (left - 7.0, y), "end", "");
        }
        let corners = [(left, bottom), (right, bottom), (right, top), (left, top), (left, bottom)];
        canvas.line(&corners, (INK, 0.8), 1.0, "");
        canvas.text(plot.labels[0], (self.across(0.5), bottom + 39.0), "middle", "");
        let y = self.up(0.5);
        canvas.text(plot.labels[1], (14.0, y), "middle", &format!(" transform=\"rotate(270, 14, {y:.1})\""));
    }
}
