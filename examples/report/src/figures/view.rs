//! From places in the plane to user units of a picture.

use super::floor::Floor;
use std::fmt::Write as _;

pub(super) const WIDTH: f64 = 640.0;
pub(super) const MARGIN: f64 = 30.0;
pub(super) const TOP: f64 = 40.0;
/// The tallest a body is drawn.
const TALLEST: f64 = 420.0;
/// Room for the hatching of a floor.
const HATCH: f64 = 12.0;

/// Distance of the strokes of the hatching, and how far they reach along the line and off it.
const STEP: f64 = 9.0;
const STROKE: [f64; 2] = [6.0, 8.0];

pub(super) struct View {
    left: f64,
    top: f64,
    scale: f64,
    pub(super) height: f64,
}

impl View {
    pub(super) fn around(nodes: &[[f64; 2]], arrows: &[([f64; 2], [f64; 2])], floors: &[Floor]) -> Self {
        let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
        let tips = arrows.iter().flat_map(|(a, b)| [a, b]);
        for place in nodes.iter().chain(tips).chain(floors.iter().flat_map(|floor| &floor.ends)) {
            for axis in 0..2 {
                low[axis] = low[axis].min(place[axis]);
                high[axis] = high[axis].max(place[axis]);
            }
        }
        let span = [high[0] - low[0], high[1] - low[1]];
        let inner = WIDTH - 2.0 * MARGIN;
        let scale = (inner / span[0]).min(TALLEST / span[1]);
        let scale = if scale.is_finite() && scale > 0.0 { scale } else { 1.0 };
        Self {
            left: low[0] - 0.5 * (inner / scale - span[0]),
            top: high[1],
            scale,
            height: span[1] * scale + HATCH,
        }
    }

    pub(super) fn place(&self, [x, y]: [f64; 2]) -> (f64, f64) {
        (MARGIN + (x - self.left) * self.scale, TOP + (self.top - y) * self.scale)
    }

    /// Floors as one path: lines, hatched on the side away from the body.
    pub(super) fn floors(&self, floors: &[Floor]) -> String {
        let mut path = String::new();
        for floor in floors {
            let [(x0, y0), (x1, y1)] = floor.ends.map(|end| self.place(end));
            let length = (x1 - x0).hypot(y1 - y0);
            if length == 0.0 {
                continue;
            }
            let (dx, dy) = ((x1 - x0) / length, (y1 - y0) / length);
            let (nx, ny) = (floor.normal[0], -floor.normal[1]);
            let stroke = [nx * STROKE[1] - dx * STROKE[0], ny * STROKE[1] - dy * STROKE[0]];
            let _ = write!(path, "M{x0:.1} {y0:.1}L{x1:.1} {y1:.1}");
            for k in 0..=(length / STEP) as usize {
                let at = k as f64 * STEP;
                let (x, y) = (x0 + at * dx, y0 + at * dy);
                let _ = write!(path, "M{x:.1} {y:.1}l{:.1} {:.1}", stroke[0], stroke[1]);
            }
        }
        if path.is_empty() {
            return path;
        }
        format!("<path d=\"{path}\" fill=\"none\" stroke=\"currentColor\" stroke-opacity=\"0.7\"/>\n")
    }
}
