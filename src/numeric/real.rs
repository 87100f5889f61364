//! binary64 and double-double under one trait, with sin and cos of complex numbers: for differences of matrices and
//! for close zeros, where binary64 loses too many digits.
//!
//! sin(x + iy) = sin x cosh y + i cos x sinh y. In double-double the nearest multiple of π/2 is subtracted from x,
//! and Taylor series up to the power 31 are used; hyperbolic functions are computed by their series up to 1, and by
//! the exponential beyond. The absolute error is a few 1e-32 times cosh y for |x| up to some hundreds.

use fractional_sobolev_numeric::transforms::{Complex, Num};
use qd::Quad;
use std::ops::Neg;

/// Terms of the series: powers up to 31 and 30 of a number below 1.
const TERMS: u32 = 15;

/// A real field: binary64 or double-double.
pub(crate) trait Real: Num + Copy + Neg<Output = Self> + From<f64> {
    /// Relative change at which a quadratically convergent iteration stops: about the square root of the rounding
    /// error, with a margin.
    const SETTLED: f64;
    /// The nearest number of the field.
    fn of(x: Quad) -> Self;
    /// The nearest binary64.
    fn approximate(self) -> f64;
    /// (sin x, cos x).
    fn circular(self) -> (Self, Self);
    /// (sinh x, cosh x).
    fn hyperbolic(self) -> (Self, Self);
}

impl Real for f64 {
    const SETTLED: f64 = 1e-10;

    fn of(x: Quad) -> Self {
        x.0
    }

    fn approximate(self) -> f64 {
        self
    }

    fn circular(self) -> (Self, Self) {
        self.sin_cos()
    }

    fn hyperbolic(self) -> (Self, Self) {
        (self.sinh(), self.cosh())
    }
}

impl Real for Quad {
    const SETTLED: f64 = 1e-18;

    fn of(x: Quad) -> Self {
        x
    }

    fn approximate(self) -> f64 {
        self.0
    }

    fn circular(self) -> (Self, Self) {
        let quarter = Quad::PI / Quad::from(2.0);
        let turns = (self / quarter).0.round();
        let (sine, cosine) = series(self - quarter * Quad::from(turns), -1.0);
        match turns.rem_euclid(4.0) as u8 {
            0 => (sine, cosine),
            1 => (cosine, -sine),
            2 => (-sine, -cosine),
            _ => (-cosine, sine),
        }
    }

    fn hyperbolic(self) -> (Self, Self) {
        if self.0.abs() <= 1.0 {
            return series(self, 1.0);
        }
        let (grown, half) = (self.exp(), Quad::from(0.5));
        let shrunk = grown.recip();
        (half * (grown - shrunk), half * (grown + shrunk))
    }
}

/// Σ (sign x²)^k x/(2k+1)! and Σ (sign x²)^k/(2k)!.
fn series(x: Quad, sign: f64) -> (Quad, Quad) {
    let square = x * x * Quad::from(sign);
    let (mut odd, mut even) = (Quad::ONE, Quad::ONE);
    for j in (1..=TERMS).rev().map(|k| 2.0 * f64::from(k)) {
        odd = Quad::ONE + square * odd / Quad::from(j * (j + 1.0));
        even = Quad::ONE + square * even / Quad::from(j * (j - 1.0));
    }
    (x * odd, even)
}

/// (sin z, cos z).
pub(crate) fn sine_cosine<T: Real>(z: Complex<T>) -> (Complex<T>, Complex<T>) {
    let ((s, c), (sh, ch)) = (z.re.circular(), z.im.hyperbolic());
    (Complex::new(s * ch, c * sh), Complex::new(c * ch, -(s * sh)))
}

/// √z by Newton's method from the root in binary64.
pub(crate) fn square_root(z: Complex<Quad>) -> Complex<Quad> {
    let start = Complex::new(z.re.0, z.im.0).sqrt();
    if start.norm() == 0.0 {
        return Complex::new(Quad::ZERO, Quad::ZERO);
    }
    let half = Quad::from(0.5);
    let wide = Complex::new(Quad::from(start.re), Quad::from(start.im));
    (0..2).fold(wide, |root, _| (root + z / root).scale(half))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Rounding of some twenty operations.
    const ROUNDING: f64 = 1e-30;

    #[test]
    fn identities_hold_to_thirty_digits() {
        let one = Complex::new(Quad::ONE, Quad::ZERO);
        for (x, y) in [(0.3, 0.0), (1.0, 0.2), (3.1, -0.9), (-7.7, 1.3), (25.0, 2.5), (37.2, -0.01)]
        {
            let z = Complex::new(Quad::from(x), Quad::from(y));
            let (s, c) = sine_cosine(z);
            let size = (1.0f64 + y.abs()).cosh().powi(2);
            let off = s * s + c * c - one;
            assert!(off.re.0.abs().max(off.im.0.abs()) < ROUNDING * size, "{x} {y}: {off:?}");
            // The double angle by the functions themselves.
            let (double, _) = sine_cosine(z + z);
            let off = double - (s * c + s * c);
            assert!(
                off.re.0.abs().max(off.im.0.abs()) < 10.0 * ROUNDING * size,
                "{x} {y}: {off:?}"
            );
            let exact = Complex::new(x, y).sin();
            assert!(
                (s.re.0 - exact.re).abs().max((s.im.0 - exact.im).abs()) < 1e-14 * size,
                "{x} {y}"
            );
            let root = square_root(z);
            let off = root * root - z;
            assert!(
                off.re.0.abs().max(off.im.0.abs()) < ROUNDING * z.re.0.abs(),
                "{x} {y}: {off:?}"
            );
        }
    }

    #[test]
    fn a_sine_near_its_zero_keeps_its_digits() {
        // sin of the binary64 number next to π is what that number lacks.
        let (sine, _) = Quad::from(std::f64::consts::PI).circular();
        assert!((sine.0 / 1.224_646_799_147_353_2e-16 - 1.0).abs() < 1e-15, "{sine:?}");
        // sin 1 = 0.84147098480789650665250232163030, whose head as a binary64 number is too small by this:
        let (sine, _) = Quad::ONE.circular();
        let rest = (sine - Quad::from(0.841_470_984_807_896_5)).0;
        assert!((rest - 1.776_845_092_935_536e-18).abs() < ROUNDING, "{rest:e}");
    }
}
