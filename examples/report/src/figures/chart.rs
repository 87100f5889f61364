//! The layout of a plot on linear or logarithmic axes, with a legend below it, so that it never
//! covers data. Lines and markers are plotters' elements on its SVG backend.

use super::PALETTE;
use super::plot::{Mark, Plot, Series};
use super::scale::Scale;
use super::svg::{Canvas, FINENESS, INK_OF_SHAPES};
use plotters::backend::SVGBackend;
use plotters::coord::Shift;
use plotters::drawing::{DrawingArea, DrawingAreaErrorKind, IntoDrawingArea};
use plotters::element::{Circle, DashedPathElement, PathElement, Polygon};
use plotters::style::{Color, RGBColor};

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

/// A place in user units.
type Place = (f64, f64);
type Failure = DrawingAreaErrorKind<std::io::Error>;

/// The plot of these series as SVG.
///
/// # Errors
/// Those of plotters.
pub(super) fn chart(plot: &Plot, series: &[Series]) -> Result<String, Failure> {
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
    let size = [WIDTH, frame.height + BELOW + LEGEND * rows + TOP + 8.0];
    let places = legend.into_iter().map(|(row, x, name)| {
        let y = frame.up(0.0) + BELOW + LEGEND * (row + 0.5);
        ((x, y), name)
    });
    let places: Vec<(Place, &str)> = places.collect();
    let mut shapes = String::new();
    draw_shapes(plot, series, &frame, &places, Surface::new(&mut shapes, size))?;
    let mut canvas = Canvas::new(size, &plot.title, FONT_SIZE);
    canvas.shapes(&shapes);
    canvas.text(&plot.title, (WIDTH / 2.0, TOP / 2.0), "middle", " font-size=\"12.9\"");
    frame.label_axes(plot, &mut canvas);
    for ((x, y), name) in places {
        canvas.text(name, (x + 36.0, y), "start", "");
    }
    Ok(canvas.finish())
}

/// Everything but the words.
fn draw_shapes(
    plot: &Plot,
    series: &[Series],
    frame: &Frame,
    legend: &[(Place, &str)],
    surface: Surface<'_>,
) -> Result<(), Failure> {
    for band in &plot.bands {
        for &(a, b) in &band.intervals {
            if let (Some(a), Some(b)) = (frame.x.position(a), frame.x.position(b)) {
                let (a, b) = (frame.across(a.clamp(0.0, 1.0)), frame.across(b.clamp(0.0, 1.0)));
                surface.rectangle((a, frame.up(1.0)), (b, frame.up(0.0)), band.colour)?;
            }
        }
    }
    frame.draw(plot, &surface)?;
    for (k, series) in series.iter().enumerate() {
        let places: Vec<_> = series.points.iter().map(|&p| frame.place(p)).collect();
        for run in places.split(Option::is_none) {
            let run: Vec<_> = run.iter().flatten().copied().collect();
            surface.run(series.mark, k, &run, &run)?;
        }
    }
    for (index, &((x, y), _)) in legend.iter().enumerate() {
        match series.get(index) {
            Some(series) => {
                surface.run(series.mark, index, &[(x, y), (x + 28.0, y)], &[(x + 14.0, y)])?;
            }
            None => {
                let colour = plot.bands[index - series.len()].colour;
                surface.rectangle((x, y - 6.0), (x + 28.0, y + 6.0), colour)?;
            }
        }
    }
    surface.0.present()
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

/// A drawing area of plotters, in user units.
struct Surface<'a>(DrawingArea<SVGBackend<'a>, Shift>);

impl<'a> Surface<'a> {
    fn new(text: &'a mut String, size: [f64; 2]) -> Self {
        let [width, height] = size.map(|length| units(length) as u32);
        Self(SVGBackend::with_string(text, (width, height)).into_drawing_area())
    }

    fn line(
        &self,
        points: &[Place],
        (colour, opacity): (RGBColor, f64),
        width: f64,
    ) -> Result<(), Failure> {
        let style = colour.mix(opacity).stroke_width(units(width) as u32);
        self.0.draw(&PathElement::new(pixels(points), style))
    }

    fn polygon(&self, corners: &[Place], colour: RGBColor, opacity: f64) -> Result<(), Failure> {
        self.0.draw(&Polygon::new(pixels(corners), colour.mix(opacity).filled()))
    }

    fn rectangle(
        &self,
        (left, top): Place,
        (right, bottom): Place,
        colour: RGBColor,
    ) -> Result<(), Failure> {
        self.polygon(&[(left, bottom), (right, bottom), (right, top), (left, top)], colour, 0.25)
    }

    /// Part of a series in its colour: the line, and at the places its marker: discs, squares,
    /// diamonds, triangles in turn.
    fn run(
        &self,
        mark: Mark,
        index: usize,
        line: &[Place],
        places: &[Place],
    ) -> Result<(), Failure> {
        let colour = PALETTE[index % PALETTE.len()];
        match mark {
            Mark::Line => return self.line(line, (colour, 1.0), 1.8),
            Mark::Dashed => {
                let (dash, gap, style) =
                    (units(7.0), units(4.0), colour.stroke_width(units(1.6) as u32));
                return self.0.draw(&DashedPathElement::new(pixels(line), dash, gap, style));
            }
            Mark::LineAndPoints => self.line(line, (colour, 1.0), 1.5)?,
            Mark::Points => {}
        }
        let r = 3.6;
        let corners: &[Place] = match index % 4 {
            0 => &[],
            1 => &[(-0.9, -0.9), (0.9, -0.9), (0.9, 0.9), (-0.9, 0.9)],
            2 => &[(0.0, -1.25), (1.25, 0.0), (0.0, 1.25), (-1.25, 0.0)],
            _ => &[(0.0, -1.25), (1.1, 0.8), (-1.1, 0.8)],
        };
        for &(x, y) in places {
            if corners.is_empty() {
                self.0.draw(&Circle::new(pixel((x, y)), units(r), colour.filled()))?;
            } else {
                let corners: Vec<_> =
                    corners.iter().map(|&(a, b)| (x + r * a, y + r * b)).collect();
                self.polygon(&corners, colour, 1.0)?;
            }
        }
        Ok(())
    }
}

fn units(length: f64) -> i32 {
    (FINENESS * length).round() as i32
}

fn pixel((x, y): Place) -> (i32, i32) {
    (units(x), units(y))
}

fn pixels(points: &[Place]) -> Vec<(i32, i32)> {
    points.iter().copied().map(pixel).collect()
}

/// Both scales, and the height of the frame.
struct Frame {
    x: Scale,
    y: Scale,
    height: f64,
}

impl Frame {
    /// The place of a data point, if it can be shown inside the frame.
    fn place(&self, (x, y): Place) -> Option<Place> {
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

    /// The positions and labels of the ticks of the vertical axis: its own, or the names of rows.
    fn rows(&self, plot: &Plot) -> Vec<(f64, String)> {
        let row = |(k, name): (usize, &String)| Some((self.y.position(-(k as f64))?, name.clone()));
        match &*plot.row_names {
            [] => self.y.ticks(),
            names => names.iter().enumerate().filter_map(row).collect(),
        }
    }

    fn draw(&self, plot: &Plot, surface: &Surface<'_>) -> Result<(), Failure> {
        let ([left, right], [bottom, top]) =
            ([0.0, 1.0].map(|s| self.across(s)), [0.0, 1.0].map(|t| self.up(t)));
        for (position, _) in self.x.ticks() {
            let x = self.across(position);
            surface.line(&[(x, bottom), (x, top)], (INK_OF_SHAPES, 0.15), 0.8)?;
        }
        for (position, _) in self.rows(plot) {
            let y = self.up(position);
            surface.line(&[(left, y), (right, y)], (INK_OF_SHAPES, 0.15), 0.8)?;
        }
        let corners = [(left, bottom), (right, bottom), (right, top), (left, top), (left, bottom)];
        surface.line(&corners, (INK_OF_SHAPES, 0.8), 1.0)
    }

    fn label_axes(&self, plot: &Plot, canvas: &mut Canvas) {
        let (left, bottom) = (self.across(0.0), self.up(0.0));
        for (position, label) in self.x.ticks() {
            canvas.text(&label, (self.across(position), bottom + 14.0), "middle", "");
        }
        for (position, label) in self.rows(plot) {
            canvas.text(&label, (left - 7.0, self.up(position)), "end", "");
        }
        canvas.text(plot.labels[0], (self.across(0.5), bottom + 39.0), "middle", "");
        let y = self.up(0.5);
        canvas.text(
            plot.labels[1],
            (14.0, y),
            "middle",
            &format!(" transform=\"rotate(270, 14, {y:.1})\""),
        );
    }
}
