//! A drawing surface in user units on plotters' SVG backend.
//!
//! plotters rounds every coordinate to an integer, so the surface is ten times larger than its nominal size
//! and the view box scales it back. Ink is drawn in a colour that nothing else uses and replaced by
//! `currentColor` at the end.

use super::Colour;
use super::typeset::typeset;
use crate::{Error, Result};
use plotters::coord::Shift;
use plotters::element::{Circle, EmptyElement, PathElement, Polygon, Text};
use plotters::prelude::{DrawingArea, IntoDrawingArea, IntoFont, SVGBackend};
use plotters::style::text_anchor::{HPos, Pos, VPos};
use plotters::style::{Color, FontTransform, RGBAColor, RGBColor, ShapeStyle, TextStyle};

/// Drawing units per user unit.
const FINENESS: f64 = 10.0;
/// Stands for ink until the file is finished.
const INK: RGBColor = RGBColor(1, 2, 3);
const INK_TEXT: &str = "#010203";

/// What a stroke or a fill is drawn with.
#[derive(Debug, Clone, Copy)]
pub(super) enum Paint {
    Ink(f64),
    Colour(Colour, f64),
}

impl Paint {
    fn rgba(self) -> RGBAColor {
        match self {
            Paint::Ink(opacity) => INK.mix(opacity),
            Paint::Colour((r, g, b), opacity) => RGBColor(r, g, b).mix(opacity),
        }
    }
}

/// Where a text sits relative to its point.
#[derive(Debug, Clone, Copy)]
pub(super) enum Anchor {
    Left,
    Centre,
    Right,
    /// Centred, rotated to read upwards.
    Upwards,
}

pub(super) struct Canvas<'a> {
    area: DrawingArea<SVGBackend<'a>, Shift>,
}

impl Canvas<'_> {
    /// Draws on a surface of the given size and returns the finished SVG text; `title` is its accessible
    /// name.
    pub(super) fn draw(
        width: f64,
        height: f64,
        title: &str,
        content: impl FnOnce(&Canvas<'_>) -> Result<()>,
    ) -> Result<String> {
        let mut text = String::new();
        let (w, h) = (units(width) as u32, units(height) as u32);
        {
            let canvas = Canvas { area: SVGBackend::with_string(&mut text, (w, h)).into_drawing_area() };
            content(&canvas)?;
            canvas.area.present().map_err(failure)?;
        }
        Ok(finish(&text, width, height, title))
    }

    pub(super) fn line(&self, points: &[(f64, f64)], paint: Paint, width: f64) -> Result<()> {
        let path: Vec<_> = points.iter().map(|&p| pixel(p)).collect();
        self.area.draw(&PathElement::new(path, stroke(paint, width))).map_err(failure)
    }

    /// A line of dashes `on` long with gaps `off`, both in user units.
    pub(super) fn dashes(
        &self,
        points: &[(f64, f64)],
        paint: Paint,
        width: f64,
        (on, off): (f64, f64),
    ) -> Result<()> {
        let (mut pen_down, mut left) = (true, on);
        let mut dash: Vec<(f64, f64)> = points.first().copied().into_iter().collect();
        for pair in points.windows(2) {
            let (mut from, to) = (pair[0], pair[1]);
            let mut length = (to.0 - from.0).hypot(to.1 - from.1);
            while length > left {
                let s = left / length;
                from = (from.0 + s * (to.0 - from.0), from.1 + s * (to.1 - from.1));
                dash.push(from);
                if pen_down {
                    self.line(&dash, paint, width)?;
                }
                dash = vec![from];
                length -= left;
                pen_down = !pen_down;
                left = if pen_down { on } else { off };
            }
            left -= length;
            dash.push(to);
        }
        if pen_down { self.line(&dash, paint, width) } else { Ok(()) }
    }

    pub(super) fn polygon(&self, corners: &[(f64, f64)], paint: Paint) -> Result<()> {
        let corners: Vec<_> = corners.iter().map(|&p| pixel(p)).collect();
        self.area.draw(&Polygon::new(corners, paint.rgba().filled())).map_err(failure)
    }

    pub(super) fn disc(&self, centre: (f64, f64), radius: f64, paint: Paint) -> Result<()> {
        self.area.draw(&Circle::new(pixel(centre), units(radius), paint.rgba().filled())).map_err(failure)
    }

    pub(super) fn text(&self, words: &str, at: (f64, f64), size: f64, anchor: Anchor) -> Result<()> {
        let font = ("sans-serif", size * FINENESS).into_font();
        let (font, horizontal) = match anchor {
            Anchor::Left => (font, HPos::Left),
            Anchor::Centre => (font, HPos::Center),
            Anchor::Right => (font, HPos::Right),
            Anchor::Upwards => (font.transform(FontTransform::Rotate270), HPos::Center),
        };
        let style = TextStyle::from(font).color(&INK).pos(Pos::new(horizontal, VPos::Center));
        let element = EmptyElement::at(pixel(at)) + Text::new(words.to_owned(), (0, 0), style);
        self.area.draw(&element).map_err(failure)
    }
}

fn units(length: f64) -> i32 {
    (length * FINENESS).round() as i32
}

fn pixel((x, y): (f64, f64)) -> (i32, i32) {
    (units(x), units(y))
}

fn stroke(paint: Paint, width: f64) -> ShapeStyle {
    paint.rgba().stroke_width(units(width).max(1) as u32)
}

fn failure(error: impl std::fmt::Display) -> Error {
    Error::Figure { reason: error.to_string() }
}

fn finish(text: &str, width: f64, height: f64, title: &str) -> String {
    let head_end = text.find('>').map_or(0, |i| i + 1);
    let body = typeset(&text[head_end..].replace(INK_TEXT, "currentColor"));
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" aria-label=\"{}\" width=\"{width}\" \
         height=\"{height}\" viewBox=\"0 0 {} {}\">\n{STYLE}{body}",
        escape(title),
        units(width),
        units(height),
    )
}

/// Opened alone a picture has its own light and dark colours.
pub(super) const STYLE: &str = "<style>svg:root{color:#222;background:#fff}\
    @media(prefers-color-scheme:dark){svg:root{color:#ddd;background:#1b1b1b}}</style>";

/// A text for an attribute or an element.
pub(super) fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('"', "&quot;")
}
