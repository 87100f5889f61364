//! The wedge: opening, medium, boundary conditions on its two sides, and the factors of its characteristic
//! function.
//!
//! Sides: clamped D (u = 0), free N (σ n = 0), frictionless contact, closed C (u_N = 0, σ_T = 0). With κ = 3 − 4 ν_P
//!
//! | sides | characteristic equation | factors |
//! | --- | --- | --- |
//! | N-N | sin²(λω) = λ² sin²ω | sin λω + λ sin ω even, sin λω − λ sin ω odd |
//! | D-D | sin²(λω) = (λ/κ)² sin²ω | κ sin λω − λ sin ω even, κ sin λω + λ sin ω odd |
//! | D-N | sin²(λω) = ((κ+1)² − 4 λ² sin²ω)/(4κ) | one |
//! | C-N | sin 2λω + λ sin 2ω = 0 | the even half of N-N at 2ω |
//! | C-D | κ sin 2λω − λ sin 2ω = 0 | the even half of D-D at 2ω |
//! | C-C | sin (λ−1)ω sin (λ+1)ω = 0 | two |
//!
//! u_N = 0 and σ_T = 0 on the line θ = 0 mean that u is symmetric about it, hence the even halves. The equations are
//! those of M. L. Williams, J. Appl. Mech. 19 (1952) 526-528; each is the determinant of the four conditions in the
//! basis of module `basis`, as verified by the tests. λ = 0 of the even and odd parts is a translation or no field.
//! λ = 1 is the rigid rotation for N-N; as κ → 1 the zero of D-D near 1 becomes the constant pressure, with u → 0.
//!
//! Scalar (Laplace): closed contact means u = 0, as for a clamped side; D-D and N-N sin λω = 0, D-N cos λω = 0.

use super::factor::{Factor, Fields};
use crate::error::{Error, Result, ToolkitError};
use crate::numeric::real::Real;
use qd::Quad;
use std::fmt;
use std::str::FromStr;

/// The boundary condition on a side.
///
/// u_N = u·n with the outward normal, σ_N = n·σn, σ_T the shear stress; contact has u_N ≤ 0, σ_N ≤ 0, σ_N u_N = 0.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum SideCondition {
    /// Clamped: u = 0.
    Clamped,
    /// Free: no traction.
    Free,
    /// Frictionless contact, closed: u_N = 0, σ_T = 0, σ_N ≤ 0. Scalar: u = 0, ∂u/∂n ≤ 0.
    Closed,
    /// Contact, open: no traction, and u_N ≤ 0. Its exponents are those of a free side.
    Open,
}

impl SideCondition {
    /// The letter of the condition: D, N, C, or O for an open part of the contact edge.
    pub fn letter(self) -> char {
        match self {
            SideCondition::Clamped => 'D',
            SideCondition::Free => 'N',
            SideCondition::Closed => 'C',
            SideCondition::Open => 'O',
        }
    }
}

/// The conditions on the two sides of a wedge, θ = 0 first.
///
/// ```
/// use signorini::singular::{SideCondition, SideConditions};
/// let sides: SideConditions = "c-n".parse()?;
/// assert_eq!(sides, SideConditions(SideCondition::Closed, SideCondition::Free));
/// assert_eq!(sides.to_string(), "C-N");
/// # Ok::<(), signorini::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct SideConditions(pub SideCondition, pub SideCondition);

impl SideConditions {
    /// The six unordered pairs with different exponents in elasticity, where O has those of N: N-N, D-D, D-N,
    /// C-N, C-D, C-C.
    pub const ALL: [SideConditions; 6] = [
        SideConditions(SideCondition::Free, SideCondition::Free),
        SideConditions(SideCondition::Clamped, SideCondition::Clamped),
        SideConditions(SideCondition::Clamped, SideCondition::Free),
        SideConditions(SideCondition::Closed, SideCondition::Free),
        SideConditions(SideCondition::Closed, SideCondition::Clamped),
        SideConditions(SideCondition::Closed, SideCondition::Closed),
    ];
}

impl fmt::Display for SideConditions {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}-{}", self.0.letter(), self.1.letter())
    }
}

impl FromStr for SideConditions {
    type Err = Error;

    /// Two of the letters D, N, C, O, as in `D-N`.
    fn from_str(text: &str) -> Result<Self> {
        let side = |letter: &str| {
            let all = [
                SideCondition::Clamped,
                SideCondition::Free,
                SideCondition::Closed,
                SideCondition::Open,
            ];
            all.into_iter().find(|side| letter.eq_ignore_ascii_case(&side.letter().to_string()))
        };
        let sides =
            text.split_once('-').and_then(|(a, b)| Some(SideConditions(side(a)?, side(b)?)));
        sides.ok_or_else(|| {
            Error::Toolkit(ToolkitError::UnknownName {
                what: "pair of sides",
                given: text.to_owned(),
                expected: "two of D (clamped), N (free), C (contact, closed), O (contact, open), as in D-N",
            })
        })
    }
}

/// The material of the wedge.
///
/// The exponents do not depend on the shear modulus. Plane stress with Poisson's ratio ν is plane strain with
/// Poisson's ratio ν/(1 + ν).
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Medium {
    /// The Laplace equation.
    Scalar,
    /// Plane strain with this Poisson's ratio, in (−1, 1/2).
    PlaneStrain(f64),
}

/// A wedge {0 < θ < ω} with homogeneous conditions on both sides.
///
/// The exponents depend only on the opening, the unordered pair of sides and Poisson's ratio; a reflected wedge has
/// the same exponents.
///
/// ```
/// use signorini::singular::{Medium, Wedge};
/// let wedge = |sides: &str| Wedge::new(2.0, sides.parse()?, Medium::PlaneStrain(0.3));
/// assert_eq!(wedge("D-N")?.exponents()?.places(), wedge("N-D")?.exponents()?.places());
/// # Ok::<(), signorini::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Wedge {
    angle: f64,
    sides: SideConditions,
    medium: Medium,
}

/// Smallest opening: at 1e-5 the factor of N-N is proportional to ω³ and has six correct digits on the paths.
const SMALLEST: f64 = 1e-5;

impl Wedge {
    /// The wedge with the given side conditions and medium and an opening angle in [1e-5, 2π], in radians.
    ///
    /// ```
    /// use signorini::singular::{Medium, SideConditions, Wedge};
    /// let crack = Wedge::new(std::f64::consts::TAU, "N-N".parse()?, Medium::PlaneStrain(0.3))?;
    /// let first = &crack.exponents()?.exponents[0];
    /// assert!((first.re.value - 0.5).abs() < 1e-15 && first.multiplicity == 2);
    /// # Ok::<(), signorini::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`ToolkitError::OutOfRange`](crate::ToolkitError::OutOfRange) for an opening outside this interval,
    /// or a Poisson's ratio outside (−1, 1/2).
    pub fn new(angle: f64, sides: SideConditions, medium: Medium) -> Result<Self> {
        let is_opening = (SMALLEST..=std::f64::consts::TAU).contains(&angle);
        Error::require("opening angle", angle, "[1e-5, 2 pi]", is_opening)?;
        if let Medium::PlaneStrain(poisson) = medium {
            Error::require(
                "Poisson's ratio",
                poisson,
                "(-1, 1/2)",
                poisson > -1.0 && poisson < 0.5,
            )?;
        }
        Ok(Self { angle, sides, medium })
    }

    /// The opening ω.
    pub fn angle(&self) -> f64 {
        self.angle
    }

    /// The conditions on the sides.
    pub fn sides(&self) -> SideConditions {
        self.sides
    }

    /// The medium.
    pub fn medium(&self) -> Medium {
        self.medium
    }

    /// κ = 3 − 4 ν_P; 3 for a scalar medium, where it is not used.
    pub(super) fn kappa(&self) -> f64 {
        match self.medium {
            Medium::Scalar => 3.0,
            Medium::PlaneStrain(poisson) => 3.0 - 4.0 * poisson,
        }
    }

    /// The sides in the order C, D, N, and whether they were exchanged; the exponents are the same.
    pub(super) fn ordered(&self) -> ([SideCondition; 2], bool) {
        let plain = |side| match (side, self.medium) {
            (SideCondition::Open, _) => SideCondition::Free,
            (SideCondition::Closed, Medium::Scalar) => SideCondition::Clamped,
            (side, _) => side,
        };
        let rank = |side| {
            [SideCondition::Closed, SideCondition::Clamped, SideCondition::Free]
                .iter()
                .position(|&s| s == side)
        };
        let (a, b) = (plain(self.sides.0), plain(self.sides.1));
        if rank(a) <= rank(b) { ([a, b], false) } else { ([b, a], true) }
    }

    /// The factors of the characteristic function.
    pub(super) fn factors(&self) -> Vec<Factor> {
        let ([first, second], _) = self.ordered();
        let one = Quad::ONE;
        let angle = Quad::from(self.angle);
        let sine =
            |fields, height, angle: Quad, slope| Factor::sine(fields, height, 0.0, angle, slope);
        let Medium::PlaneStrain(poisson) = self.medium else {
            let equal = first == second;
            let factor = if equal {
                sine(Fields::Scalar, one, angle, Quad::ZERO)
            } else {
                Factor::cosine(angle)
            };
            return vec![factor];
        };
        let excess = Quad::from(2.0) - Quad::from(4.0) * Quad::from(poisson);
        let kappa = one + excess;
        let (opening, doubled) = (angle.circular().0, angle + angle);
        let reflected = doubled.circular().0;
        match (first, second) {
            (SideCondition::Closed, SideCondition::Closed) => vec![
                Factor::sine(Fields::Inner, one, -1.0, angle, Quad::ZERO),
                Factor::sine(Fields::Outer, one, 1.0, angle, Quad::ZERO),
            ],
            (SideCondition::Closed, SideCondition::Clamped) => {
                vec![sine(Fields::Reflected, kappa, doubled, -reflected)]
            }
            (SideCondition::Closed, _) => vec![sine(Fields::Reflected, one, doubled, reflected)],
            (SideCondition::Clamped, SideCondition::Clamped) => {
                vec![
                    sine(Fields::Even, kappa, angle, -opening),
                    sine(Fields::Odd, kappa, angle, opening),
                ]
            }
            (SideCondition::Clamped, _) => vec![Factor::mixed(angle, excess)],
            _ => vec![
                sine(Fields::Even, one, angle, opening),
                sine(Fields::Odd, one, angle, -opening),
            ],
        }
    }
}
