//! `section_2_singular_exponents`: the list of exponents beside a count over one rectangle and beside the eigenvalues
//! on the arc, over a grid of openings, sides and Poisson's ratios.

use signorini::Result;
use signorini::singular::{Exponent, LARGEST, Medium, SideConditions, Wedge};
use std::f64::consts::TAU;

/// Zeros nearer than this are compared by their mean: the nearer they are, the fewer digits their own
/// eigenvalues keep.
const NEAR: f64 = 0.05;
/// Next to 0 and 3 one computation may see what the other counts as outside.
const MARGIN: f64 = 1e-3;
/// Degree of the polynomials on the arc: this, and four per radian.
const DEGREE: f64 = 24.0;

/// A list of exponents compared with two independent computations.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ExponentCheck {
    /// Zeros in the list, with multiplicities.
    pub listed: usize,
    /// Zeros by the argument principle, from half the first exponent to next to 3.
    pub counted: usize,
    /// Largest distance of an exponent from the eigenvalues on the arc, relative; of nearby ones that of
    /// their means. Infinite where their numbers differ.
    pub apart: f64,
}

impl ExponentCheck {
    /// The six pairs of sides, each with the openings 2π/n, 2 · 2π/n, ..., 2π and each with these Poisson's
    /// ratios; `report` is called after each opening.
    ///
    /// # Errors
    /// As [`Wedge::new`] and [`ExponentCheck::of`].
    pub fn on_grid(openings: u32, ratios: &[f64], mut report: impl FnMut()) -> Result<Vec<Self>> {
        let mut grid = Vec::new();
        for opening in 1..=openings {
            let angle = f64::from(opening) / f64::from(openings) * TAU;
            for sides in SideConditions::ALL {
                for &ratio in ratios {
                    grid.push(Self::of(&Wedge::new(angle, sides, Medium::PlaneStrain(ratio))?)?);
                }
            }
            report();
        }
        Ok(grid)
    }

    /// How many lists differ from their count.
    pub fn lost(grid: &[Self]) -> usize {
        grid.iter().filter(|check| check.listed != check.counted).count()
    }

    /// The largest distance; NaN where one is.
    pub fn furthest(grid: &[Self]) -> f64 {
        grid.iter()
            .map(|check| check.apart)
            .fold(0.0, |m: f64, x| if x.is_nan() || m.is_nan() { f64::NAN } else { m.max(x) })
    }
}

impl ExponentCheck {
    /// The list of one wedge, its count, and its eigenvalues on the arc. Cost: some ten milliseconds.
    ///
    /// # Errors
    /// As [`Wedge::exponents`], [`Wedge::count`], [`Wedge::exponents_on_arc`].
    pub fn of(wedge: &Wedge) -> Result<Self> {
        let spectrum = wedge.exponents()?;
        let re = |place: Option<&Exponent>| place.map_or(1.0, |exponent| exponent.re.value);
        let (first, last) = (re(spectrum.exponents.first()), re(spectrum.exponents.last()));
        let counted = wedge.count(0.5 * first, LARGEST - 0.02 * (LARGEST - last))?;
        let inside = |z: &(f64, f64)| z.0 > MARGIN && z.0 < LARGEST - MARGIN;
        let listed: Vec<(f64, f64)> = spectrum.places().into_iter().filter(inside).collect();
        let height = 0.5 + listed.iter().map(|z| z.1).fold(0.0, f64::max);
        let degree = (DEGREE + 4.0 * wedge.angle()) as usize;
        let arc = wedge.exponents_on_arc(degree, height)?;
        let arc: Vec<(f64, f64)> = arc.into_iter().map(|z| (z.re, z.im)).filter(inside).collect();
        let apart = listed.iter().map(|&z| apart(z, &listed, &arc)).fold(0.0, f64::max);
        let apart = if arc.len() == listed.len() { apart } else { f64::INFINITY };
        Ok(Self { listed: spectrum.zeros(), counted, apart })
    }
}

/// Relative distance of the means of what lies near z on both lists; infinite where the numbers differ.
fn apart(z: (f64, f64), ours: &[(f64, f64)], theirs: &[(f64, f64)]) -> f64 {
    let sum = |list: &[(f64, f64)]| {
        let near = list.iter().filter(|other| (other.0 - z.0).hypot(other.1 - z.1) < NEAR);
        near.fold((0, 0.0, 0.0), |(count, re, im), other| (count + 1, re + other.0, im + other.1))
    };
    let (a, b) = (sum(ours), sum(theirs));
    if a.0 == b.0 { (a.1 - b.1).hypot(a.2 - b.2) / a.1.hypot(a.2) } else { f64::INFINITY }
}
