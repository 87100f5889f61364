//! From places in the plane to user units of a picture.

use super::floor::Floor;

pub(super) const WIDTH: f64 = 640.0;
pub(super) const MARGIN: f64 = 30.0;
pub(super) const TOP: f64 = 40.0;
/// The tallest a body is drawn.
const TALLEST: f64 = 420.0;
/// Room for the hatching of a floor.
const HATCH: f64 = 12.0;

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
}
