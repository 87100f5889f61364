//! A rigid floor under a straight contact edge.

/// The line from one end to the other, and its normal, away from the body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Floor {
    /// The two ends.
    pub ends: [[f64; 2]; 2],
    /// Unit normal.
    pub normal: [f64; 2],
}

impl Floor {
    /// The floor through a point, under all of these places and so much longer at both ends.
    pub fn under(point: [f64; 2], normal: [f64; 2], places: &[[f64; 2]], beyond: f64) -> Self {
        let along = [-normal[1], normal[0]];
        let position = |p: &[f64; 2]| (p[0] - point[0]) * along[0] + (p[1] - point[1]) * along[1];
        let positions = places.iter().map(position);
        let (low, high) = positions.fold((0.0_f64, 0.0_f64), |(low, high), s| (low.min(s), high.max(s)));
        let at = |s: f64| [point[0] + s * along[0], point[1] + s * along[1]];
        Self { ends: [at(low - beyond), at(high + beyond)], normal }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_floor_lies_along_its_edge() {
        let normal = [0.6, -0.8];
        let floor = Floor::under([1.0, 1.0], normal, &[[1.8, 1.6], [1.0, 1.5]], 0.5);
        for [x, y] in floor.ends {
            assert!(((x - 1.0) * normal[0] + (y - 1.0) * normal[1]).abs() < 1e-15);
        }
        let [[x0, y0], [x1, y1]] = floor.ends;
        assert!(((x1 - x0).hypot(y1 - y0) - 2.0).abs() < 1e-15);
    }
}
