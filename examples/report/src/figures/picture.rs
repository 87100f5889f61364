//! A triangulated body in its deformed place, coloured by a quantity per triangle, with arrows on its contact
//! edge.
//!
//! Triangles of one colour share one SVG path, so a mesh of 10⁵ triangles is a file of a few dozen elements.

use super::Colour;
use super::data::save_svg;
use super::floor::Floor;
use super::scale::power_of_ten;
use super::view::{MARGIN, TOP, View, WIDTH};
use crate::Result;
use fractional_sobolev::Error;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};

/// Colour bar with its words.
const BELOW: f64 = 70.0;
const SHADES: usize = 16;

/// What to draw: places of the nodes, triangles, one value per triangle, arrows.
#[derive(Debug, Clone)]
pub struct BodyPicture<'a> {
    /// Title, also the accessible name.
    pub title: String,
    /// Deformed places of the nodes.
    pub nodes: &'a [[f64; 2]],
    /// Triangles by node numbers.
    pub triangles: &'a [[usize; 3]],
    /// One value per triangle.
    pub values: &'a [f64],
    /// The values at both ends of the scale of colour; those of the values where not given.
    pub range: Option<(f64, f64)>,
    /// What the values are.
    pub value_name: String,
    /// Arrows from their tails to the places they press on.
    pub arrows: &'a [([f64; 2], [f64; 2])],
    /// What the arrows are; also written below.
    pub arrow_name: String,
    /// Rigid floors.
    pub floors: &'a [Floor],
}

impl BodyPicture<'_> {
    /// The picture as SVG text.
    ///
    /// # Errors
    /// [`Error::LengthMismatch`] unless there is one value per triangle; [`Error::NotFinite`] for a place or
    /// value that is not finite; [`Error::CountOutOfRange`] for a node number that does not exist.
    pub fn svg(&self) -> Result<String> {
        self.check()?;
        let view = View::around(self.nodes, self.arrows, self.floors);
        let height = TOP + view.height + BELOW;
        let mut svg = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" aria-label=\"{0}\" width=\"{WIDTH}\" \
             height=\"{height:.0}\" viewBox=\"0 0 {WIDTH} {height:.0}\">\n<style>svg:root{{color:#222;background:#fff}}\
             @media(prefers-color-scheme:dark){{svg:root{{color:#ddd;background:#1b1b1b}}}}</style>\n\
             <g font-family=\"sans-serif\" font-size=\"15\" fill=\"currentColor\">\n\
             <text x=\"{1}\" y=\"24\" font-size=\"16\" text-anchor=\"middle\">{0}</text>\n",
            escape(&self.title),
            WIDTH / 2.0,
        );
        svg.push_str(&view.floors(self.floors));
        self.push_triangles(&mut svg, &view);
        self.push_arrows(&mut svg, &view);
        self.push_colour_bar(&mut svg, height);
        svg.push_str("</g>\n</svg>\n");
        Ok(svg)
    }

    /// Writes `directory/name.svg` and returns its path.
    ///
    /// # Errors
    /// As [`BodyPicture::svg`], and [`crate::Error::File`] when the file cannot be written.
    pub fn save(&self, directory: &Path, name: &str) -> Result<PathBuf> {
        save_svg(&self.svg()?, directory, name)
    }

    fn check(&self) -> fractional_sobolev::Result<()> {
        if self.values.len() != self.triangles.len() {
            let (given, expected) = (self.values.len(), self.triangles.len());
            return Err(Error::LengthMismatch { name: "values per triangle", given, expected });
        }
        let arrows = self.arrows.iter().flat_map(|(a, b)| [a, b]);
        let numbers = self.nodes.iter().chain(arrows).flatten().chain(self.values);
        if let Some((index, &value)) = numbers.enumerate().find(|(_, v)| !v.is_finite()) {
            return Err(Error::NotFinite { name: "picture data", index, value });
        }
        match self.triangles.iter().flatten().find(|&&k| k >= self.nodes.len()) {
            Some(&value) => {
                Err(Error::CountOutOfRange { name: "node number", value, range: "the nodes given" })
            }
            None => Ok(()),
        }
    }

    fn value_range(&self) -> (f64, f64) {
        if let Some(range) = self.range {
            return range;
        }
        let low = self.values.iter().copied().fold(f64::INFINITY, f64::min);
        let high = self.values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        if low > high { (0.0, 0.0) } else { (low, high) }
    }

    fn push_triangles(&self, svg: &mut String, view: &View) {
        let (low, high) = self.value_range();
        let mut paths = vec![String::new(); SHADES];
        for (triangle, &value) in self.triangles.iter().zip(self.values) {
            let s = if high > low { (value - low) / (high - low) } else { 0.0 };
            let path = &mut paths[((s * SHADES as f64) as usize).min(SHADES - 1)];
            for (corner, &node) in triangle.iter().enumerate() {
                let (x, y) = view.place(self.nodes[node]);
                let _ = write!(path, "{}{x:.2} {y:.2}", if corner == 0 { 'M' } else { 'L' });
            }
            path.push('Z');
        }
        // Large meshes show their values, small ones also their edges.
        let edge = if self.triangles.len() <= 20_000 { 0.25 } else { 0.0 };
        for (k, path) in paths.iter().enumerate().filter(|(_, path)| !path.is_empty()) {
            let (r, g, b) = shade((k as f64 + 0.5) / SHADES as f64);
            let _ = writeln!(
                svg,
                "<path d=\"{path}\" fill=\"rgb({r},{g},{b})\" stroke=\"#333\" stroke-width=\"{edge}\" stroke-opacity=\"0.6\"/>"
            );
        }
    }

    fn push_arrows(&self, svg: &mut String, view: &View) {
        let mut path = String::new();
        for &(tail, tip) in self.arrows {
            let ((x0, y0), (x1, y1)) = (view.place(tail), view.place(tip));
            let length = (x1 - x0).hypot(y1 - y0);
            if length < 0.5 {
                continue;
            }
            let head = 4.0f64.min(length);
            let (dx, dy) = ((x1 - x0) / length * head, (y1 - y0) / length * head);
            let _ = write!(
                path,
                "M{x0:.1} {y0:.1}L{x1:.1} {y1:.1}M{:.1} {:.1}L{x1:.1} {y1:.1}L{:.1} {:.1}",
                x1 - dx - 0.5 * dy,
                y1 - dy + 0.5 * dx,
                x1 - dx + 0.5 * dy,
                y1 - dy - 0.5 * dx,
            );
        }
        if !path.is_empty() {
            let _ = writeln!(
                svg,
                "<path d=\"{path}\" fill=\"none\" stroke=\"rgb(213,94,0)\" stroke-width=\"1.3\"/>"
            );
        }
    }

    fn push_colour_bar(&self, svg: &mut String, height: f64) {
        let (low, high) = self.value_range();
        let (left, width, y) = (MARGIN, 190.0, height - 40.0);
        for k in 0..SHADES {
            let (r, g, b) = shade((k as f64 + 0.5) / SHADES as f64);
            let step = width / SHADES as f64;
            let x = left + k as f64 * step;
            let _ = writeln!(
                svg,
                "<rect x=\"{x:.2}\" y=\"{y:.1}\" width=\"{step:.2}\" height=\"12\" fill=\"rgb({r},{g},{b})\"/>"
            );
        }
        let below = y + 29.0;
        let _ = writeln!(svg, "<text x=\"{left}\" y=\"{below:.1}\">{}</text>", short(low));
        let _ = writeln!(
            svg,
            "<text x=\"{:.1}\" y=\"{below:.1}\" text-anchor=\"end\">{}</text>",
            left + width,
            short(high)
        );
        let _ = writeln!(
            svg,
            "<text x=\"{:.1}\" y=\"{:.1}\">{}</text>",
            left + width + 14.0,
            y + 7.0,
            escape(&self.value_name)
        );
        if !self.arrow_name.is_empty() {
            let _ = writeln!(
                svg,
                "<text x=\"{:.1}\" y=\"{below:.1}\"><tspan fill=\"rgb(213,94,0)\">→</tspan> {}</text>",
                left + width + 14.0,
                escape(&self.arrow_name)
            );
        }
    }
}

/// From dark blue through green to yellow, of rising lightness (the ends and middle of the viridis map).
fn shade(s: f64) -> Colour {
    const STOPS: [(f64, f64, f64); 5] = [
        (68.0, 1.0, 84.0),
        (59.0, 82.0, 139.0),
        (33.0, 145.0, 140.0),
        (94.0, 201.0, 98.0),
        (253.0, 231.0, 37.0),
    ];
    let at = s.clamp(0.0, 1.0) * (STOPS.len() - 1) as f64;
    let k = (at as usize).min(STOPS.len() - 2);
    let mix = |a: f64, b: f64| (a + (at - k as f64) * (b - a)).round() as u8;
    let (low, high) = (STOPS[k], STOPS[k + 1]);
    (mix(low.0, high.0), mix(low.1, high.1), mix(low.2, high.2))
}

/// Three significant digits, with a raised exponent where that is shorter.
pub(super) fn short(value: f64) -> String {
    let rounded: f64 = format!("{value:.2e}").parse().unwrap_or(value);
    if rounded == 0.0 || (1e-3..1e5).contains(&rounded.abs()) || !rounded.is_finite() {
        return rounded.to_string();
    }
    let exponent = rounded.abs().log10().floor();
    let mantissa: f64 = format!("{:.2}", rounded / 10f64.powf(exponent)).parse().unwrap_or(rounded);
    if mantissa == 1.0 {
        return power_of_ten(exponent as i64);
    }
    format!("{mantissa}·{}", power_of_ten(exponent as i64))
}

fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('"', "&quot;")
}
