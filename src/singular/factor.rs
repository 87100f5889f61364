//! The entire functions whose zeros are the exponents: values, bounds, rounding errors.
//!
//! | factor | f(λ) | where |
//! | --- | --- | --- |
//! | sine | p sin((λ + s) w) + q λ | equal sides, split by symmetry; one side in frictionless contact |
//! | cosine | cos(λ w) | scalar, clamped/free |
//! | mixed | 4κ cos²(λω) + (κ − 1)² − 4 λ² sin²ω | clamped/free |
//!
//! The mixed factor is sin²(λω) = ((κ + 1)² − 4 λ² sin²ω)/(4κ) in a form without cancellation as κ → 1. All factors
//! are real on the real axis; f″ is bounded explicitly, so that a path can be followed in steps on which the argument
//! of f changes by less than a right angle.

use crate::numeric::real::{Real, sine_cosine};
use faer::c64;
use fractional_sobolev_numeric::transforms::Complex;
use qd::Quad;

/// The fields that belong to the zeros of a factor, in the basis of module `basis`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Fields {
    /// Scalar: one function.
    Scalar,
    /// Even about the middle of the wedge.
    Even,
    /// Odd about the middle of the wedge.
    Odd,
    /// Even about the first side, which is in frictionless contact.
    Reflected,
    /// Contact on both sides: z^λ, the terms with the angle (λ − 1) θ.
    Inner,
    /// Contact on both sides: the terms with the angle (λ + 1) θ.
    Outer,
    /// Clamped at the first side.
    Clamped,
}

#[derive(Debug, Clone, Copy)]
enum Shape {
    Sine { height: Quad, shift: f64, slope: Quad },
    Cosine,
    Mixed { kappa: Quad, excess: Quad, sine: Quad },
}

/// One factor of a characteristic function.
#[derive(Debug, Clone, Copy)]
pub(super) struct Factor {
    shape: Shape,
    /// w.
    angle: Quad,
    pub(super) fields: Fields,
}

impl Factor {
    /// p sin((λ + s) w) + q λ.
    pub(super) fn sine(fields: Fields, height: Quad, shift: f64, angle: Quad, slope: Quad) -> Self {
        Self { shape: Shape::Sine { height, shift, slope }, angle, fields }
    }

    /// cos(λ w).
    pub(super) fn cosine(angle: Quad) -> Self {
        Self { shape: Shape::Cosine, angle, fields: Fields::Scalar }
    }

    /// The factor for clamped/free; `excess` is κ − 1.
    pub(super) fn mixed(angle: Quad, excess: Quad) -> Self {
        let shape = Shape::Mixed { kappa: excess + Quad::ONE, excess, sine: angle.circular().0 };
        Self { shape, angle, fields: Fields::Clamped }
    }

    /// f, f′, f″.
    pub(super) fn values<T: Real>(&self, z: Complex<T>) -> [Complex<T>; 3] {
        let real = |x: Quad| Complex::new(T::of(x), T::zero());
        let (w, number) = (real(self.angle), |x: f64| real(Quad::from(x)));
        match self.shape {
            Shape::Sine { height, shift, slope } => {
                let (sine, cosine) = sine_cosine((z + number(shift)) * w);
                let (p, q) = (real(height), real(slope));
                [p * sine + q * z, p * w * cosine + q, -(p * w * w * sine)]
            }
            Shape::Cosine => {
                let (sine, cosine) = sine_cosine(z * w);
                [cosine, -(w * sine), -(w * w * cosine)]
            }
            Shape::Mixed { kappa, excess, sine } => {
                let (s, c) = sine_cosine(z * w);
                let (k, e, b) =
                    (number(4.0) * real(kappa), real(excess), number(4.0) * real(sine * sine));
                let two = number(2.0);
                let first = -(two * k * w * s * c) - two * b * z;
                [
                    k * c * c + e * e - b * z * z,
                    first,
                    -(two * k * w * w * (c * c - s * s)) - two * b,
                ]
            }
        }
    }

    /// An upper bound of |f″| for |λ| ≤ reach and |Im λ| ≤ height.
    pub(super) fn bend(&self, reach: f64, height: f64) -> f64 {
        let w = self.angle.0;
        match self.shape {
            Shape::Sine { height: p, shift, .. } => {
                p.0.abs() * w * w * largest_sine(w, reach, shift, height)
            }
            Shape::Cosine => w * w * (w * height).cosh(),
            Shape::Mixed { kappa, sine, .. } => {
                8.0 * kappa.0 * w * w * (2.0 * w * height).cosh() + 8.0 * sine.0 * sine.0
            }
        }
    }

    /// The sum of the absolute values of the terms of f at λ: the scale of its rounding error.
    pub(super) fn terms(&self, z: c64) -> f64 {
        let w = self.angle.0;
        match self.shape {
            Shape::Sine { height, shift, slope } => {
                let sine = largest_sine(w, z.norm(), shift, z.im.abs());
                height.0.abs() * sine + slope.0.abs() * z.norm()
            }
            Shape::Cosine => (w * z.im).cosh(),
            Shape::Mixed { kappa, excess, sine } => {
                4.0 * kappa.0 * (w * z.im).cosh().powi(2)
                    + excess.0 * excess.0
                    + 4.0 * (z.norm() * sine.0).powi(2)
            }
        }
    }

    /// A height above which f has no zero with |Re λ| ≤ reach: at and above it the exponential exceeds twice the
    /// linear part.
    pub(super) fn ceiling(&self, reach: f64) -> f64 {
        let w = self.angle.0;
        // grown sinh(w η) ≥ 3/2 (least + slope (reach + η)); both sides are convex and w grown ≥ slope.
        let (grown, least, slope) = match self.shape {
            Shape::Sine { height, slope, .. } => (height.0.abs(), 0.0, slope.0.abs()),
            Shape::Cosine => (1.0, 0.0, 0.0),
            Shape::Mixed { kappa, excess, sine } => {
                (2.0 * kappa.0.sqrt(), excess.0.abs(), 2.0 * sine.0.abs())
            }
        };
        let mut height = 0.5 / w;
        while grown * (w * height).sinh() < 1.5 * (least + slope * (reach + height)) {
            height *= 1.25;
        }
        height
    }
}

/// An upper bound of |sin((λ + s) w)|: cosh of the imaginary part, and sinh of the modulus.
fn largest_sine(w: f64, reach: f64, shift: f64, height: f64) -> f64 {
    let modulus = w * (reach + shift.abs());
    let exponential = (w * height).cosh();
    if modulus < 1.0 { modulus.sinh().min(exponential) } else { exponential }
}
