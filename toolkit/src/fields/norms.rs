//! Norms of u − u_h for a function with declared breakpoints and a piecewise polynomial.

use super::cells::{Content, FieldCells, FieldEnergies};
use super::fit::Difference;
use super::patch::{by_polynomials, patch};
use crate::energy::energy;
use crate::error::{Error, Result};
use crate::estimate::{Estimate, Tolerance, Work};
use crate::functions::{Normalized, SingularFunction, Units};
use crate::numeric::sum::RunningSum;
use crate::order::Order;
use crate::piecewise::{Cell, Piece, PiecewisePolynomial};
use crate::quadrature::Rule;
use crate::root::{accept, root_of_squares};

/// Shares of the tolerance of the square for the far pairs, and for all patches.
const SHARE: f64 = 0.2;
/// Number of standard deviations by which independent rounding errors may exceed their expectation.
const ROUNDING_SAFETY: f64 = 4.0;
/// Message: what limits the accuracy.
pub(super) const LIMIT: &str = "rounding of the function dominates the small difference, or the limit at a breakpoint is not resolved";

/// The difference u − u_h of a function with declared breakpoints and a piecewise polynomial on many elements:
/// an interpolant or a finite element solution. Its norms are those of other functions.
///
/// # Method
///
/// The elements are cut at the breakpoints of u and until none is longer than its distance to the nearest one.
/// Away from the breakpoints u − u_h is replaced by polynomials of degree 5 to 20, chosen by the decay of their
/// coefficients, and the double integral is computed pair by pair for near cells and by moments for far ones,
/// as for [`PiecewisePolynomial::seminorm`]. The two elements next to a breakpoint form a patch: over pairs in
/// it the integral is that of [`SingularFunction::seminorm`] of the difference, which also detects infinite
/// seminorms; in pairs with all other cells the patch is represented by points graded towards the breakpoint.
/// Cost O(N log(1/τ)²): seconds for 10⁵ elements.
///
/// The error includes the interpolation of the kernel, the last coefficients, the patches, and the rounding of
/// u compared with a difference that may be 10¹⁰ times smaller; rounding errors at different points are treated
/// as independent.
#[doc(alias("Gagliardo", "Slobodeckij", "finite element error", "interpolation error"))]
#[derive(Debug, Clone, Copy)]
pub(crate) struct FieldError<'a> {
    pub(super) function: &'a SingularFunction<'a>,
    pub(super) field: &'a PiecewisePolynomial,
}

impl SingularFunction<'_> {
    /// The difference u − u_h, both on the same interval, for its norms.
    pub(crate) fn minus<'b>(&'b self, field: &'b PiecewisePolynomial) -> FieldError<'b> {
        FieldError { function: self, field }
    }
}

impl FieldError<'_> {
    /// The seminorm |u − u_h|_ν.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless both are defined on the same interval; [`Error::InfiniteNorm`] if u_h jumps
    /// and ν ≥ 1/2, and as [`SingularFunction::seminorm`]; [`Error::ToleranceNotMet`] with the best value.
    pub(crate) fn seminorm(&self, order: Order, tolerance: Tolerance) -> Result<Estimate> {
        accept("seminorm", self.parts(order, tolerance)?[0], tolerance, LIMIT)
    }

    /// The norm ||u − u_h||_ν, the square of which is the sum of the squares of the L² norm and of the
    /// seminorm.
    ///
    /// # Errors
    /// As [`FieldError::seminorm`].
    pub(crate) fn norm(&self, order: Order, tolerance: Tolerance) -> Result<Estimate> {
        accept("norm", root_of_squares(&self.parts(order, tolerance)?)?, tolerance, LIMIT)
    }

    /// The L² norm ||u − u_h||.
    ///
    /// # Errors
    /// As [`FieldError::seminorm`], except for infinite seminorms.
    pub(crate) fn l2_norm(&self, tolerance: Tolerance) -> Result<Estimate> {
        let (Normalized { units, u }, field) = self.normalized(tolerance)?;
        let cells =
            FieldCells::new(&Difference { function: &u, field: &field }, tolerance.relative())?;
        accept("L^2 norm", units.in_lq(2.0, l2(&cells)?)?, tolerance, LIMIT)
    }

    /// Both functions divided by the size of u, on the unit interval.
    pub(super) fn normalized(
        &self,
        tolerance: Tolerance,
    ) -> Result<(Normalized<'_>, PiecewisePolynomial)> {
        let normalized = self.function.normalized(tolerance)?;
        let Units { length, size } = normalized.units;
        let field = self.field.scaled_by(1.0 / size).on(self.field.mesh().over(length)?);
        Ok((normalized, field))
    }

    /// The seminorm and the L² norm.
    fn parts(&self, order: Order, tolerance: Tolerance) -> Result<[Estimate; 2]> {
        let (Normalized { units, u }, field) = self.normalized(tolerance)?;
        let difference = Difference { function: &u, field: &field };
        let cells = FieldCells::new(&difference, tolerance.relative())?;
        if !order.is_below_half() && cells.jumps_apart() {
            let why = "a piecewise polynomial with a jump is not in H^nu for nu >= 1/2";
            return Err(Error::InfiniteNorm { order: order.value(), why });
        }
        let back = |squared: Estimate| units.seminorm(order, squared.sqrt()?);
        let seminorm = squared(&difference, &cells, order, tolerance)
            .map_err(|error| error.carry("seminorm", back))
            .and_then(back)?;
        Ok([seminorm, units.in_lq(2.0, l2(&cells)?)?])
    }
}

/// The square |u − u_h|²_ν.
fn squared(
    difference: &Difference,
    cells: &FieldCells,
    order: Order,
    tolerance: Tolerance,
) -> Result<Estimate> {
    let target = SHARE * tolerance.relative();
    let energies = FieldEnergies::new(cells, order, target)?;
    let apart = energy(&cells.partition, &energies, order, target)?;
    let mut patches: Vec<(SingularFunction, Estimate)> = Vec::new();
    for k in 0..difference.function.breaks().len() {
        let first = cells.parts.iter().position(|part| part.patch == Some(k)).unwrap_or(0);
        let count = cells.parts[first..].iter().take_while(|part| part.patch == Some(k)).count();
        let parts = &cells.parts[first..first + count];
        let function = patch(difference.function, difference.field, k, parts)?;
        let coarse = Tolerance::new(1e-2)?.with_work(tolerance.work());
        let rough = match Estimate::or_best(function.seminorm(order, coarse)) {
            Err(refused @ Error::ToleranceNotMet { .. }) => {
                by_polynomials(difference, parts, order, tolerance)?.ok_or(refused)?
            }
            other => other?,
        };
        patches.push((function, rough));
    }
    let share = |rough: &Estimate| rough.value * rough.value;
    let whole = apart.value + patches.iter().map(|(_, rough)| share(rough)).sum::<f64>();
    let (mut value, mut error, mut work) = (RunningSum::default(), apart.error, apart.work);
    value.add(apart.value);
    for (function, rough) in &patches {
        // Where a patch counts for little, few of its digits do.
        let asked = SHARE * tolerance.relative() * whole / (share(rough) * patches.len() as f64);
        let found = if asked >= 1e-2 || rough.value == 0.0 {
            *rough
        } else {
            let asked = Tolerance::new(asked.max(1e-14))?.with_work(tolerance.work());
            // What refuses more digits without a value leaves those that are known.
            match Estimate::or_best(function.seminorm(order, asked)) {
                Err(Error::ToleranceNotMet { .. } | Error::NotFinite { .. }) => *rough,
                other => other?,
            }
        };
        value.add(found.value * found.value);
        error += (2.0 * found.value + found.error) * found.error;
        work += found.work;
    }
    let rest = leftovers(&energies, cells, order);
    error += (2.0 * value.value().sqrt() + rest.cut.sqrt()) * rest.cut.sqrt() + rest.beyond;
    error += ROUNDING_SAFETY * (2.0 * rest.mixed.sqrt() + rest.noise);
    Estimate::new(
        value.value(),
        error,
        work + Work { points: cells.parts.len() as u64, ..Work::default() },
    )
}

/// The errors of the polynomials and of the samples.
#[derive(Default)]
struct Leftovers {
    /// |r|²_ν of the remainder r beyond the last coefficients
    cut: f64,
    /// the same for the remainder on singular cells
    beyond: f64,
    /// |n|²_ν of the rounding errors, and Σ (e n)² of their products with the difference
    noise: f64,
    mixed: f64,
}

fn leftovers(energies: &FieldEnergies, cells: &FieldCells, order: Order) -> Leftovers {
    let nu = order.value();
    // ∫ |x−y|^{-1-2ν} dy beyond both ends of an interval of length one, from its ends or its middle
    let outside = 2.0 / nu;
    let own = 2.0 / ((1.0 - nu) * (3.0 - 2.0 * nu));
    let mut sum = Leftovers::default();
    for (content, part) in cells.contents.iter().zip(&cells.parts) {
        let scaling = part.length.powf(1.0 - 2.0 * nu);
        match content {
            Content::Smooth { piece, rest, noise } => {
                let count = piece.bubbles.len();
                let mut last = Piece { left: 0.0, right: 0.0, bubbles: vec![0.0; count] };
                last.bubbles[count - 1] = *rest;
                let cell = Cell { length: part.length, piece: &last };
                let alone = energies.rules.pairs(piece.degree()).own(cell).value;
                sum.cut += 2.0 * (alone + outside * scaling * (0.25 * rest).powi(2));
                let size = piece.size() + (piece.right - piece.left).abs();
                sum.noise += (own + outside) * scaling * noise * noise;
                sum.mixed += ((own + outside) * scaling * size * noise).powi(2);
            }
            Content::Singular(sampled) => sum.beyond += 4.0 * outside * scaling * sampled.rest,
        }
    }
    sum
}

/// The L² norm ||u − u_h||.
pub(super) fn l2(cells: &FieldCells) -> Result<Estimate> {
    let (mut value, mut error, mut noise) = (RunningSum::default(), 0.0, 0.0_f64);
    for (content, part) in cells.contents.iter().zip(&cells.parts) {
        match content {
            Content::Smooth { piece, rest, noise: rounding } => {
                let rule = Rule::gauss_legendre(piece.degree() + 1)?;
                let square = rule.integrate(|t| piece.value(t).powi(2));
                value.add(part.length * square);
                error += part.length * (2.0 * square.sqrt() + 0.25 * rest) * 0.25 * rest;
                noise = noise.hypot(part.length * (square.sqrt() + rounding) * rounding);
            }
            Content::Singular(sampled) => {
                let pairs = sampled.points.iter().zip(&sampled.values);
                value.add(part.length * pairs.map(|((_, w), e)| w * e * e).sum::<f64>());
                error += part.length * sampled.rest;
            }
        }
    }
    let rounding = 32.0 * f64::EPSILON * value.value() + ROUNDING_SAFETY * noise;
    Estimate::new(value.value(), error + rounding, Work::default())?.sqrt()
}
