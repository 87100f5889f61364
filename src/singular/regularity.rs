//! The exponents admitted by the sign conditions of contact, and the regularity of a solution at a corner.
//!
//! Near the corner u = Σ c r^λ U(θ) + a smoother function. Where a side is in contact σ_N ≤ 0; where it is an open
//! part of the contact edge and the other side (clamped or closed) fixes the corner itself, u_N ≤ 0. The leading term
//! of the sum must satisfy this for one sign of c. A term with a complex exponent changes sign infinitely often and
//! cannot lead. On the flat transition C-O the functions for λ = 1/2, 3/2, ... have u_N σ_N alternating in sign:
//! r^{1/2} violates a sign condition with either sign, r^{3/2} satisfies both conditions with one sign.
//!
//! r^λ U(θ), if it is not a polynomial, lies in H^s for s < 1 + Re λ. Hence u ∈ H^τ for τ < 1 + Re λ with the first
//! exponent that is neither excluded nor polynomial. The terms that follow a leading exponent above one with a strict
//! sign are not subject to the conditions. Data are assumed to be smooth; for integer exponents, and loads that
//! coincide with one, r^k ln r may occur for k ≥ 2, which limits τ to at most 3.

use super::mode::Mode;
use super::spectrum::{Exponent, LARGEST};
use super::wedge::{SideCondition, Wedge};
use crate::error::Result;

/// Values on a side below this tolerance, relative to a largest displacement of one, count as zero.
const ZERO: f64 = 1e-9;

/// The effect of the sign conditions of contact on a leading term r^λ U(θ).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SignCondition {
    /// No condition: stress and opening vanish on the contact edge.
    Neutral,
    /// The term may lead with one sign of its coefficient.
    Signed,
    /// The term violates a condition with either sign.
    Excluded,
}

/// The regularity of a solution at a corner.
#[derive(Debug, Clone, PartialEq)]
pub struct CornerRegularity {
    /// Supremum of the τ with u ∈ H^τ near the corner for all smooth data for which no term r^k ln r occurs;
    /// 4 if no exponent below 3 limits it.
    pub tau: f64,
    /// The exponent that limits τ; `None` if no exponent below 3 does.
    pub exponent: Option<Exponent>,
}

impl Wedge {
    /// Whether a leading term with this exponent satisfies the sign conditions on the contact sides: without
    /// condition, with one sign of its coefficient, or with neither.
    ///
    /// ```
    /// use signorini::singular::{Medium, SignCondition, Wedge};
    /// let flat = Wedge::new(std::f64::consts::PI, "C-O".parse()?, Medium::PlaneStrain(0.3))?;
    /// let all = flat.exponents()?.exponents;
    /// let at = |re: f64| all.iter().find(|lambda| (lambda.re.value - re).abs() < 1e-10);
    /// assert_eq!(at(0.5).map(|lambda| flat.sign_condition(lambda)), Some(SignCondition::Excluded));
    /// assert_eq!(at(1.5).map(|lambda| flat.sign_condition(lambda)), Some(SignCondition::Signed));
    /// # Ok::<(), signorini::Error>(())
    /// ```
    pub fn sign_condition(&self, exponent: &Exponent) -> SignCondition {
        let rows: Vec<[f64; 2]> = exponent.modes.iter().map(|mode| self.signs(mode)).collect();
        let is_neutral = |signs: &[f64; 2]| signs.iter().all(|value| value.abs() <= ZERO);
        if rows.iter().any(is_neutral) {
            return SignCondition::Neutral;
        }
        if exponent.is_complex() {
            return SignCondition::Excluded;
        }
        match rows[..] {
            // c v₁ ≤ 0 and c v₂ ≤ 0 for some c ≠ 0
            [[first, second]] if first * second < -ZERO * ZERO => SignCondition::Excluded,
            // Two conditions or fewer on two coefficients or more: two half-planes through 0 share a ray.
            _ => SignCondition::Signed,
        }
    }

    /// The quantity that must be nonpositive on each side: σ_N in contact, u_N where the side is open and the other
    /// side fixes the corner.
    fn signs(&self, mode: &Mode) -> [f64; 2] {
        let sides = [self.sides().0, self.sides().1];
        [0, 1].map(|k| {
            let (displacement, stress) = mode.contact(k == 1);
            let is_held = matches!(sides[1 - k], SideCondition::Clamped | SideCondition::Closed);
            let number = match sides[k] {
                SideCondition::Closed => stress,
                SideCondition::Open if is_held => displacement,
                _ => return 0.0,
            };
            if number.im.abs() > number.re.abs() { number.im } else { number.re }
        })
    }

    /// The supremum of the τ with u ∈ H^τ near the corner, and the exponent that determines it.
    ///
    /// τ = 1 + Re λ with the first λ that is neither excluded nor polynomial; after a polynomial leading term
    /// with a strict sign no exponent is excluded. At a transition from contact to no contact on a straight
    /// side the sign conditions exclude r^{1/2}: u ∈ H^τ for τ < 5/2.
    ///
    /// ```
    /// use signorini::singular::{Medium, Wedge};
    /// let flat = |sides: &str| Wedge::new(std::f64::consts::PI, sides.parse()?, Medium::PlaneStrain(0.3));
    /// assert!((flat("C-O")?.regularity()?.tau - 2.5).abs() < 1e-12);
    /// assert!((flat("C-N")?.regularity()?.tau - 1.5).abs() < 1e-12);
    /// # Ok::<(), signorini::Error>(())
    /// ```
    ///
    /// # Errors
    /// As for [`Wedge::exponents`].
    pub fn regularity(&self) -> Result<CornerRegularity> {
        let mut is_decided = false;
        for exponent in self.exponents()?.exponents {
            let condition = self.sign_condition(&exponent);
            if condition == SignCondition::Excluded && !is_decided {
                continue;
            }
            if !exponent.is_polynomial() {
                return Ok(CornerRegularity {
                    tau: 1.0 + exponent.re.value,
                    exponent: Some(exponent),
                });
            }
            // A polynomial with a strict sign may lead, and the following terms are then free of conditions.
            is_decided |= condition == SignCondition::Signed;
        }
        Ok(CornerRegularity { tau: 1.0 + LARGEST, exponent: None })
    }
}
