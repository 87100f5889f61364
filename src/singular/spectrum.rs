//! All exponents of a wedge with 0 < Re λ < 3.

use super::mode::Mode;
use super::wedge::Wedge;
use super::zeros::{SAME, Zero, count_in_strip, zeros_in_strip};
use crate::error::{Error, Result};
use fractional_sobolev::{Estimate, Work};

/// Upper limit of the real parts of the exponents computed.
pub const LARGEST: f64 = 3.0;

/// An exponent λ; a conjugate pair is represented by the member with Im λ > 0.
///
/// r^λ U(θ) oscillates like r^{Re λ} cos(Im λ ln r) for complex λ. At a flat transition from clamped to free in plane
/// strain λ = 1/2 ± iε, ε = ln(3 − 4ν)/(2π).
///
/// ```
/// use signorini::singular::{Medium, Wedge};
/// let flat = Wedge::new(std::f64::consts::PI, "D-N".parse()?, Medium::PlaneStrain(0.3))?;
/// let first = &flat.exponents()?.exponents[0];
/// assert!((first.re.value - 0.5).abs() < 1e-14);
/// assert!((first.im.value - 1.8f64.ln() / std::f64::consts::TAU).abs() < 1e-14);
/// assert!(first.is_complex() && first.zeros() == 2);
/// # Ok::<(), signorini::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Exponent {
    /// The real part Re λ.
    pub re: Estimate,
    /// The imaginary part Im λ ≥ 0; exactly zero for a real exponent.
    pub im: Estimate,
    /// Multiplicity as a zero of the characteristic function.
    pub multiplicity: usize,
    /// The linearly independent angular functions; fewer than the multiplicity if r^λ ln r occurs.
    pub modes: Vec<Mode>,
}

impl Exponent {
    /// True if Im λ ≠ 0.
    pub fn is_complex(&self) -> bool {
        self.im.value > 0.0
    }

    /// The number of zeros of the characteristic function that this exponent stands for: its multiplicity, doubled for a
    /// conjugate pair.
    pub fn zeros(&self) -> usize {
        self.multiplicity * if self.is_complex() { 2 } else { 1 }
    }

    /// True if r^λ ln r occurs, that is if there are fewer angular functions than the multiplicity.
    ///
    /// ```
    /// use signorini::singular::{Medium, Wedge};
    /// let crack = Wedge::new(std::f64::consts::TAU, "N-N".parse()?, Medium::PlaneStrain(0.3))?;
    /// // Two independent functions belong to the double exponent 1/2 of a crack: no r^{1/2} ln r.
    /// assert!(!crack.exponents()?.exponents[0].has_logarithm());
    /// # Ok::<(), signorini::Error>(())
    /// ```
    pub fn has_logarithm(&self) -> bool {
        self.modes.len() < self.multiplicity
    }

    /// True if all its functions r^λ U(θ) are polynomials in x and y: an integer exponent without logarithm.
    ///
    /// Homogeneous harmonic functions of positive integer degree are polynomials, and so are κφ − z conj φ′ − conj ψ
    /// with φ, ψ powers z^k.
    ///
    /// ```
    /// use signorini::singular::{Medium, Wedge};
    /// let flat = Wedge::new(std::f64::consts::PI, "N-N".parse()?, Medium::Scalar)?;
    /// // On a straight free side the functions are Re (x + iy)^k: the solution is smooth.
    /// assert!(flat.exponents()?.exponents.iter().all(|lambda| lambda.is_polynomial()));
    /// assert!(flat.first_singular()?.is_none());
    /// # Ok::<(), signorini::Error>(())
    /// ```
    pub fn is_polynomial(&self) -> bool {
        let off = (self.re.value - self.re.value.round()).abs();
        !self.is_complex() && !self.has_logarithm() && off <= SAME * self.re.value
    }
}

/// The exponents of a wedge, ordered by increasing real part. There is no tolerance: the iteration for the
/// zeros converges to rounding accuracy, and the error estimates account for the digits lost at double zeros.
#[derive(Debug, Clone, PartialEq)]
pub struct Spectrum {
    /// The exponents with 0 < Re λ < 3.
    pub exponents: Vec<Exponent>,
    /// The work: the number of points at which characteristic functions were evaluated to count zeros.
    pub work: Work,
}

impl Spectrum {
    /// The number of zeros in the list, with multiplicities.
    pub fn zeros(&self) -> usize {
        self.exponents.iter().map(Exponent::zeros).sum()
    }

    /// All zeros as (Re λ, Im λ), repeated according to multiplicity, with both members of each conjugate pair.
    ///
    /// Their number is [`Spectrum::zeros`].
    ///
    /// ```
    /// use signorini::singular::{Medium, Wedge};
    /// let flat = Wedge::new(std::f64::consts::PI, "D-N".parse()?, Medium::PlaneStrain(0.3))?;
    /// let spectrum = flat.exponents()?;
    /// assert_eq!(spectrum.places().len(), spectrum.zeros());
    /// assert!(spectrum.places().iter().map(|place| place.1).sum::<f64>().abs() < 1e-14);
    /// # Ok::<(), signorini::Error>(())
    /// ```
    pub fn places(&self) -> Vec<(f64, f64)> {
        let mut all = Vec::new();
        for exponent in &self.exponents {
            let (re, im) = (exponent.re.value, exponent.im.value);
            for _ in 0..exponent.multiplicity {
                all.push((re, im));
                if exponent.is_complex() {
                    all.push((re, -im));
                }
            }
        }
        all
    }
}

impl Wedge {
    /// All exponents with 0 < Re λ < 3. Exponents within 1e-12 of 0 or 3 are excluded; exponents that agree to a
    /// relative distance of 1e-12 are identified. Each error estimate accounts for the rounding of the characteristic
    /// function, evaluated in double-double, and of the result; the opening and Poisson's ratio are taken as exact.
    /// Cost: about a millisecond.
    ///
    /// ```
    /// use signorini::singular::{Medium, Wedge};
    /// let corner = Wedge::new(1.5 * std::f64::consts::PI, "D-D".parse()?, Medium::Scalar)?;
    /// let found: Vec<f64> = corner.exponents()?.exponents.iter().map(|lambda| lambda.re.value).collect();
    /// // sin λω = 0 at the re-entrant corner: λ = 2k/3.
    /// assert_eq!(found.len(), 4);
    /// assert!(found.iter().enumerate().all(|(k, re)| (re - 2.0 * (k + 1) as f64 / 3.0).abs() < 1e-14));
    /// # Ok::<(), signorini::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`ToolkitError::ToleranceNotMet`](crate::ToolkitError::ToleranceNotMet) if the count of zeros fails on all
    /// paths tried, which can happen for three zeros within 1e-5 of each other.
    pub fn exponents(&self) -> Result<Spectrum> {
        let mut work = Work::default();
        let mut found: Vec<(Zero, Mode)> = Vec::new();
        for factor in self.factors() {
            for zero in zeros_in_strip(&factor, LARGEST, &mut work.points)? {
                found.push((zero, Mode::of(self, factor.fields, zero.place)?));
            }
        }
        found.sort_by(|(a, _), (b, _)| {
            a.place.re.total_cmp(&b.place.re).then(a.place.im.total_cmp(&b.place.im))
        });
        let mut exponents: Vec<Exponent> = Vec::new();
        for (zero, mode) in found {
            let same = exponents.iter_mut().find(|known| {
                let off = (known.re.value - zero.place.re).hypot(known.im.value - zero.place.im);
                off <= SAME * zero.place.norm()
            });
            match same {
                Some(known) => {
                    known.multiplicity += zero.multiplicity;
                    known.modes.push(mode);
                }
                None => exponents.push(Exponent {
                    re: Estimate::new(zero.place.re, zero.error, Work::default())?,
                    im: Estimate::new(zero.place.im, zero.error, Work::default())?,
                    multiplicity: zero.multiplicity,
                    modes: vec![mode],
                }),
            }
        }
        Ok(Spectrum { exponents, work })
    }

    /// The first exponent whose functions are not all polynomials, regardless of the sign conditions of
    /// contact; `None` if there is none with Re λ < 3.
    ///
    /// ```
    /// use signorini::singular::{Medium, Wedge};
    /// let corner = Wedge::new(1.5 * std::f64::consts::PI, "N-N".parse()?, Medium::PlaneStrain(0.3))?;
    /// let first = corner.first_singular()?.map_or(0.0, |lambda| lambda.re.value);
    /// // The least root of sin²(λω) = λ² sin²ω, whatever the material.
    /// assert!((first - 0.5444837).abs() < 1e-7);
    /// # Ok::<(), signorini::Error>(())
    /// ```
    ///
    /// # Errors
    /// As for [`Wedge::exponents`].
    pub fn first_singular(&self) -> Result<Option<Exponent>> {
        Ok(self.exponents()?.exponents.into_iter().find(|exponent| !exponent.is_polynomial()))
    }

    /// Number of zeros of the characteristic function with left < Re λ < right, with multiplicities, by the argument
    /// principle on one rectangle per factor. A zero at λ = 0, which corresponds to a translation or to no
    /// field at all, is counted if left < 0 < right.
    ///
    /// The number is (1/2πi) ∮ f'/f over the rectangle, f the characteristic function; it is independent of the list
    /// of exponents.
    ///
    /// ```
    /// use signorini::singular::{Medium, Wedge};
    /// let crack = Wedge::new(std::f64::consts::TAU, "N-N".parse()?, Medium::PlaneStrain(0.3))?;
    /// // 1/2, 1, 3/2, 2, 5/2, each twice.
    /// assert_eq!((crack.count(0.2, 2.8)?, crack.exponents()?.zeros()), (10, 10));
    /// # Ok::<(), signorini::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`ToolkitError::OutOfRange`](crate::ToolkitError::OutOfRange) unless −3 ≤ left < right ≤ 4;
    /// [`ToolkitError::ToleranceNotMet`](crate::ToolkitError::ToleranceNotMet) if a zero is too close to
    /// one of the lines Re λ = left, right.
    pub fn count(&self, left: f64, right: f64) -> Result<usize> {
        Error::require("left end", left, "[-3, right end)", left >= -LARGEST && left < right)?;
        Error::require("right end", right, "(left end, 4]", right <= LARGEST + 1.0)?;
        let mut points = 0;
        let mut count = |factor| count_in_strip(factor, left, right, &mut points);
        let counts: Option<Vec<usize>> = self.factors().iter().map(&mut count).collect();
        let why = "a zero is too close to one of the lines";
        let near = Error::out_of_reach("number of zeros between two lines", SAME, 1.0, why);
        Ok(counts.ok_or(near)?.into_iter().sum())
    }
}
