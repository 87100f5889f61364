//! A pen for schematic pictures: a strip of paper 640 wide, x in (0, 1) along it, y as the picture says.

use std::fmt::Write as _;

/// Colours of the charts: displacement and second zone, pressure, what is good, what is shaded.
pub(super) const BLUE: &str = "#0072b2";
pub(super) const ORANGE: &str = "#d55e00";
pub(super) const GREEN: &str = "#009e73";
pub(super) const INK: &str = "black";

/// Left and right end of the axis on the paper.
const LEFT: f64 = 70.0;
const RIGHT: f64 = 590.0;
/// The unit of y that makes lengths equal in all directions.
pub(super) const SQUARE: f64 = RIGHT - LEFT;

/// Characters of a line, and from one line to the next.
const LINE: usize = 66;
const LEADING: f64 = 22.0;

/// A picture that grows.
pub(super) struct Pen {
    height: f64,
    zero: f64,
    unit: f64,
    body: String,
}

impl Pen {
    /// Paper of this height; y = 0 at `zero` from the top, one unit of y is `unit` long and points upwards.
    pub(super) fn new(height: f64, zero: f64, unit: f64) -> Self {
        Self { height, zero, unit, body: String::new() }
    }

    /// The same paper, another place for y = 0.
    pub(super) fn at(&mut self, zero: f64, unit: f64) {
        (self.zero, self.unit) = (zero, unit);
    }

    fn x(&self, x: f64) -> f64 {
        LEFT + (RIGHT - LEFT) * x
    }

    fn y(&self, y: f64) -> f64 {
        self.zero - self.unit * y
    }

    pub(super) fn curve(&mut self, points: impl IntoIterator<Item = (f64, f64)>, colour: &str, style: &str) {
        let mut path = String::new();
        for (k, (x, y)) in points.into_iter().enumerate() {
            let _ = write!(path, "{}{:.1} {:.1}", if k == 0 { 'M' } else { 'L' }, self.x(x), self.y(y));
        }
        let _ = write!(
            self.body,
            r#"<path d="{path}" fill="none" stroke="{colour}" stroke-width="2.5" {style}/>"#
        );
    }

    /// The graph of a function over an interval.
    pub(super) fn graph(&mut self, from: f64, to: f64, colour: &str, f: impl Fn(f64) -> f64) {
        let points = (0..=160).map(|k| from + (to - from) * f64::from(k) / 160.0).map(|x| (x, f(x)));
        self.curve(points.collect::<Vec<_>>(), colour, "");
    }

    /// The graph of a function that oscillates.
    pub(super) fn graph_fine(&mut self, f: impl Fn(f64) -> f64, colour: &str) {
        let points = (0..=1200).map(|k| f64::from(k) / 1200.0).map(|x| (x, f(x)));
        self.curve(points.collect::<Vec<_>>(), colour, "");
    }

    pub(super) fn line(&mut self, from: (f64, f64), to: (f64, f64), colour: &str, style: &str) {
        self.curve([from, to], colour, style);
    }

    pub(super) fn dashed(&mut self, from: (f64, f64), to: (f64, f64)) {
        self.line(from, to, INK, r#"stroke-dasharray="5 5" opacity="0.5""#);
    }

    /// A shaded rectangle.
    pub(super) fn shade(
        &mut self,
        (left, right): (f64, f64),
        (low, high): (f64, f64),
        colour: &str,
        opacity: f64,
    ) {
        let (x, y) = (self.x(left), self.y(high));
        let (width, height) = (self.x(right) - x, self.y(low) - y);
        let size = format!(r#"x="{x:.1}" y="{y:.1}" width="{width:.1}" height="{height:.1}""#);
        let _ = write!(self.body, r#"<rect {size} fill="{colour}" fill-opacity="{opacity}"/>"#);
    }

    /// A shaded polygon.
    pub(super) fn fill(&mut self, points: &[(f64, f64)], colour: &str) {
        self.area(points, colour, 0.35);
    }

    /// A polygon of any opacity.
    pub(super) fn area(&mut self, points: &[(f64, f64)], colour: &str, opacity: f64) {
        let corners: Vec<String> =
            points.iter().map(|&(x, y)| format!("{:.1},{:.1}", self.x(x), self.y(y))).collect();
        let _ = write!(
            self.body,
            r#"<polygon points="{}" fill="{colour}" fill-opacity="{opacity:.2}"/>"#,
            corners.join(" ")
        );
    }

    /// A circle of a radius in units of x.
    pub(super) fn circle(&mut self, (x, y): (f64, f64), radius: f64, colour: &str) {
        let _ = write!(
            self.body,
            r#"<circle cx="{:.1}" cy="{:.1}" r="{:.1}" fill="none" stroke="{colour}" stroke-width="2"/>"#,
            self.x(x),
            self.y(y),
            radius * (RIGHT - LEFT)
        );
    }

    /// A thin line.
    pub(super) fn thin(&mut self, points: &[(f64, f64)], colour: &str, opacity: f64) {
        let path: Vec<String> =
            points.iter().map(|&(x, y)| format!("{:.1} {:.1}", self.x(x), self.y(y))).collect();
        let _ = write!(
            self.body,
            r#"<path d="M{}" fill="none" stroke="{colour}" stroke-opacity="{opacity}"/>"#,
            path.join("L")
        );
    }

    pub(super) fn dot(&mut self, x: f64, y: f64, colour: &str) {
        let _ = write!(
            self.body,
            r#"<circle cx="{:.1}" cy="{:.1}" r="4.5" fill="{colour}"/>"#,
            self.x(x),
            self.y(y)
        );
    }

    /// Words centred at a point; more than a phone has room for stand in two lines.
    pub(super) fn words(&mut self, x: f64, y: f64, words: &str, colour: &str) {
        let count = words.chars().count();
        let middle = |&(at, _): &(usize, char)| (2 * words[..at].chars().count()).abs_diff(count);
        match words.char_indices().filter(|&(_, c)| c == ' ').min_by_key(middle) {
            Some((cut, _)) if count > LINE => {
                self.text(x, y, &words[..cut], colour, "middle");
                let y = y - LEADING / self.unit;
                self.text(x, y, &words[cut + 1..], colour, "middle");
            }
            _ => self.text(x, y, words, colour, "middle"),
        }
    }

    /// Words that begin at a point.
    pub(super) fn note(&mut self, x: f64, y: f64, words: &str, colour: &str) {
        self.text(x, y, words, colour, "start");
    }

    /// Words that end at a point.
    pub(super) fn ending(&mut self, x: f64, y: f64, words: &str, colour: &str) {
        self.text(x, y, words, colour, "end");
    }

    /// Labels at y of a logarithmic axis from e^-20 to 1.
    pub(super) fn logarithms(&mut self, y: f64) {
        for t in [0, 5, 10, 15, 20] {
            let label = if t == 0 { "1".to_owned() } else { format!("e^-{t}") };
            self.words(1.0 - f64::from(t) / 20.0, y, &label, INK);
        }
    }

    fn text(&mut self, x: f64, y: f64, words: &str, colour: &str, anchor: &str) {
        self.height = self.height.max(self.y(y) + 8.0);
        let place = format!(r#"x="{:.1}" y="{:.1}""#, self.x(x), self.y(y));
        // Subscripts and powers: u_N, e^-5.
        let set = |words: &str, mark: &str, shift: i32| {
            words.split(mark).enumerate().fold(String::new(), |text, (k, part)| {
                if k == 0 {
                    return part.to_owned();
                }
                let end = part.find(|c: char| !c.is_alphanumeric() && c != '-').unwrap_or(part.len());
                let (low, rest) = part.split_at(end);
                text + &format!(
                    r#"<tspan dy="{shift}" font-size="0.75em">{low}</tspan><tspan dy="{}">{rest}</tspan>"#,
                    -shift
                )
            })
        };
        let words = set(&set(&crate::markup::escape(words), "_", 4), "^", -6);
        let _ = write!(self.body, r#"<text {place} fill="{colour}" text-anchor="{anchor}">{words}</text>"#);
    }

    /// Cells of a square of n by n, gathered by colour.
    pub(super) fn cells(
        &mut self,
        n: usize,
        top: f64,
        side: f64,
        level: impl Fn(usize, usize) -> usize,
        colours: &[String],
    ) {
        let left = (640.0 - side) / 2.0;
        let cell = side / n as f64;
        for (k, colour) in colours.iter().enumerate() {
            let mut path = String::new();
            for i in 0..n {
                for j in (0..n).filter(|&j| level(i, j) == k) {
                    let (x, y) = (left + cell * i as f64, top + side - cell * (j + 1) as f64);
                    let _ = write!(path, "M{x:.1} {y:.1}h{cell:.1}v{cell:.1}h-{cell:.1}z");
                }
            }
            if !path.is_empty() {
                let _ = write!(self.body, r#"<path d="{path}" fill="{colour}"/>"#);
            }
        }
        let frame = format!(r#"x="{left}" y="{top}" width="{side}" height="{side}""#);
        let _ = write!(self.body, r#"<rect {frame} fill="none" stroke="black"/>"#);
    }

    /// The picture as SVG.
    pub(super) fn svg(self) -> String {
        let head = format!(r#"viewBox="0 0 640 {}" font-family="sans-serif" font-size="15""#, self.height);
        format!(r#"<svg xmlns="http://www.w3.org/2000/svg" {head}>{}</svg>"#, self.body)
    }
}
