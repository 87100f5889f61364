//! Cells of the slope space and the panels into which they are divided for quadrature.
//!
//! A cell is an interval of positive length with a map ξ ∈ (0,1) ↦ x: affine, or exponential away from a point
//! at which the function is singular (r = r₀ (r₁/r₀)^ξ, r the distance from that point). Positions are never
//! stored: every distance is a sum of lengths, so that it keeps its relative accuracy, however small it is.

/// The parametrization of a cell.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Grading {
    /// x is affine in ξ.
    Uniform,
    /// ln of the distance from a point on the left is affine in ξ; `inner` is that distance at ξ = 0.
    FromLeft {
        /// Distance of the left end from the singular point.
        inner: f64,
        /// ln of the ratio of the two distances.
        spread: f64,
    },
    /// The mirror image: `inner` is the distance of the right end (ξ = 1) from a point on the right.
    FromRight {
        /// Distance of the right end from the singular point.
        inner: f64,
        /// ln of the ratio of the two distances.
        spread: f64,
    },
}

impl Grading {
    fn mirrored(self) -> Self {
        match self {
            Grading::Uniform => Grading::Uniform,
            Grading::FromLeft { inner, spread } => Grading::FromRight { inner, spread },
            Grading::FromRight { inner, spread } => Grading::FromLeft { inner, spread },
        }
    }

    /// The distance of the point ξ from the left end.
    fn left_distance(self, length: f64, xi: f64) -> f64 {
        match self {
            Grading::Uniform => length * xi,
            Grading::FromLeft { inner, spread } => inner * (xi * spread).exp_m1(),
            Grading::FromRight { inner, spread } => -inner * spread.exp() * (-xi * spread).exp_m1(),
        }
    }
}

/// An interval with its parametrization and the degree of the slopes du/dξ on it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Cell {
    pub(crate) length: f64,
    pub(crate) grading: Grading,
    /// Number of slope functions: Legendre polynomials of degree 0, ..., `functions` − 1; zero if u is constant
    /// on the cell.
    pub(crate) functions: usize,
}

impl Cell {
    pub(crate) fn uniform(length: f64, functions: usize) -> Self {
        Self { length, grading: Grading::Uniform, functions }
    }

    /// The cell between the distances `inner` and `inner` e^`spread` to the right of a point.
    pub(crate) fn from_left(inner: f64, spread: f64, functions: usize) -> Self {
        Self {
            length: inner * spread.exp_m1(),
            grading: Grading::FromLeft { inner, spread },
            functions,
        }
    }

    /// The reflection of the cell.
    pub(crate) fn mirrored(self) -> Self {
        Self { grading: self.grading.mirrored(), ..self }
    }

    /// The distance of the point ξ from the left end.
    pub(crate) fn left_distance(&self, xi: f64) -> f64 {
        self.grading.left_distance(self.length, xi)
    }

    /// The coordinate ξ of the point at the given distance from the left end.
    pub(crate) fn coordinate(&self, distance: f64) -> f64 {
        match self.grading {
            Grading::Uniform => distance / self.length,
            Grading::FromLeft { inner, spread } => (distance / inner).ln_1p() / spread,
            Grading::FromRight { inner, spread } => {
                -(-distance / (inner * spread.exp())).ln_1p() / spread
            }
        }
    }

    /// The panels into which the cell is divided at equal steps of ξ, each with a spread of at most `largest`.
    pub(crate) fn panels(&self, cell: usize, largest: f64) -> Vec<Panel> {
        let pieces = match self.grading {
            Grading::Uniform => 1,
            Grading::FromLeft { spread, .. } | Grading::FromRight { spread, .. } => {
                (spread / largest).ceil().max(1.0) as usize
            }
        };
        let width = 1.0 / pieces as f64;
        (0..pieces)
            .map(|k| {
                let (grading, length) = match self.grading {
                    Grading::Uniform => (Grading::Uniform, self.length),
                    Grading::FromLeft { inner, spread } => {
                        let (inner, spread) =
                            (inner * (spread * k as f64 * width).exp(), spread * width);
                        (Grading::FromLeft { inner, spread }, inner * spread.exp_m1())
                    }
                    Grading::FromRight { inner, spread } => {
                        let steps = (pieces - 1 - k) as f64;
                        let (inner, spread) =
                            (inner * (spread * steps * width).exp(), spread * width);
                        (Grading::FromRight { inner, spread }, inner * spread.exp_m1())
                    }
                };
                Panel { cell, start: k as f64 * width, width, length, grading }
            })
            .collect()
    }
}

/// Distance, in units of the length of the panel, beyond which singularities have no effect.
const FAR: f64 = 20.0;
/// Distance, relative to that of the panel, below which a point is identified with the one to which the panel
/// is graded.
const AT_ORIGIN: f64 = 1e-9;

/// A piece of a cell, short enough for Gauss rules. Its own coordinate ξ runs from 0 at the left end to 1 at
/// the right end.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Panel {
    /// The cell to which it belongs.
    pub(crate) cell: usize,
    /// Its start in the coordinate of the cell.
    pub(crate) start: f64,
    /// Its extent in the coordinate of the cell.
    pub(crate) width: f64,
    pub(crate) length: f64,
    grading: Grading,
}

impl Panel {
    /// The distance of the point ξ from the left end.
    pub(crate) fn left_distance(&self, xi: f64) -> f64 {
        self.grading.left_distance(self.length, xi)
    }

    /// The distance of the point ξ = 1 − `eta` from the right end.
    pub(crate) fn right_distance(&self, eta: f64) -> f64 {
        self.grading.mirrored().left_distance(self.length, eta)
    }

    /// The distance between the points ξ and ξ + `step` of the panel.
    pub(crate) fn between(&self, xi: f64, step: f64) -> f64 {
        match self.grading {
            Grading::Uniform => self.length * step,
            Grading::FromLeft { inner, spread } => {
                inner * (xi * spread).exp() * (step * spread).exp_m1()
            }
            Grading::FromRight { inner, spread } => {
                inner * ((1.0 - xi - step) * spread).exp() * (step * spread).exp_m1()
            }
        }
    }

    /// The distance from the panel, in ξ, of the point at distance `gap` from one of its ends; at most [`FAR`].
    /// Beyond the point to which the panel is graded the preimage is complex, at a distance of at least
    /// π/spread: this counts as 1 for a spread up to 2.
    pub(crate) fn outside(&self, gap: f64, on_the_left: bool) -> f64 {
        let grading = if on_the_left { self.grading } else { self.grading.mirrored() };
        let xi = match grading {
            Grading::Uniform => gap / self.length,
            Grading::FromLeft { inner, .. } if (gap - inner).abs() < AT_ORIGIN * inner => FAR,
            Grading::FromLeft { inner, spread } if gap < inner => -(-gap / inner).ln_1p() / spread,
            Grading::FromLeft { .. } => 1.0,
            Grading::FromRight { inner, spread } => (gap / (inner * spread.exp())).ln_1p() / spread,
        };
        xi.min(FAR)
    }

    /// The derivative dx/dξ at ξ.
    pub(crate) fn stretch(&self, xi: f64) -> f64 {
        match self.grading {
            Grading::Uniform => self.length,
            Grading::FromLeft { inner, spread } => inner * spread * (xi * spread).exp(),
            Grading::FromRight { inner, spread } => inner * spread * ((1.0 - xi) * spread).exp(),
        }
    }

    /// The coordinate in the cell of the panel's point ξ.
    pub(crate) fn in_cell(&self, xi: f64) -> f64 {
        self.start + self.width * xi
    }
}
