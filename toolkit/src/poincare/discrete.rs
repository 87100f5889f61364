//! The constrained problem on one slope space.
//!
//! The interval is a sequence of parts; the condition holds on one or several of them, where a part of length
//! zero is a point. Lengths are divided by the square root of the shortest one, so that all of them lie between
//! 1e-150 and 1e150.
//!
//! Scaling of the results: γ² scales like the power 2ν of the length of the interval, and the mass matrices
//! are divided by this length, 1/unit, hence γ = √λ · unit^{ν−1/2}; the dual norm of a mean value scales the
//! same way.

use super::constraint::{Condition, Constraint};
use super::mesh::{MeshModel, PANEL_SPREAD};
use super::slopes::gram::seminorm_gram;
use super::slopes::links::Links;
use super::slopes::local::Local;
use super::slopes::mass::{Primitives, mass_gram};
use super::slopes::space::SlopeSpace;
use crate::Order;
use crate::error::Result;
use crate::estimate::Work;
use crate::numeric::pencil::Factored;
use nalgebra::DMatrix;
use std::ops::Range;

/// The space, its matrices and their factorization.
#[derive(Debug, Clone)]
pub(crate) struct Discrete {
    pub(crate) space: SlopeSpace,
    /// The group of cells with a different basis, for a short zone in the interior.
    local: Option<Local>,
    /// The conditions that u returns to zero between two intervals on which it vanishes.
    links: Links,
    /// The basis functions that satisfy the condition.
    pub(crate) primitives: Primitives,
    /// The unit of length.
    pub(crate) unit: f64,
    /// The factor from quotients of the scaled problem to quotients on (0,1).
    pub(crate) factor: f64,
    pub(crate) factored: Factored,
    points: usize,
    pub(crate) work: Work,
}

/// The dual norm N of the mean value on the constrained space, and the data that sharpen the bound γ² ≤ γ₁² +
/// N².
///
/// In the inner product of |·|_ν, let T be the operator of ‖u − mean u‖₀² and e the unit vector along the
/// representer of the mean: γ² is the largest eigenvalue of T + N² e⊗e. All entries are in the units of the
/// scaled problem.
pub(crate) struct DualNorm {
    /// N².
    pub(crate) square: f64,
    /// ⟨Te, e⟩.
    pub(crate) rayleigh: f64,
    /// ‖Te‖².
    pub(crate) image: f64,
}

impl Discrete {
    pub(crate) fn new(order: Order, constraint: &Constraint, model: &MeshModel) -> Result<Self> {
        let shortest = constraint.shortest();
        let unit = shortest.sqrt();
        let parts: Vec<f64> = constraint.parts.iter().map(|l| l / unit).collect();
        let vanishes = constraint.condition == Condition::Vanishing;
        let (cells, ranges) = model.cells(&parts, if vanishes { &constraint.zones } else { &[] });
        let zones: Vec<Range<usize>> =
            constraint.zones.iter().map(|&part| ranges[part].clone()).collect();
        let hull = zones[0].start..zones[zones.len() - 1].end;
        let space = SlopeSpace::new(cells, PANEL_SPREAD);
        let local = Local::new(&space, &hull, order.one_minus_twice());
        let links =
            if vanishes { Links::new(&space, local.as_ref(), &zones) } else { Links::default() };
        let (gram, mut work) = seminorm_gram(&space, local.as_ref(), order, model.points())?;
        let points = model.points() + 4;
        let primitives = Primitives::new(&space, &zones, points)?;
        let factored = Factored::new(&links.reduced(gram))?;
        work.factorizations += 1;
        let factor = unit.powf(order.offset());
        Ok(Self { space, local, links, primitives, unit, factor, factored, points, work })
    }

    /// The constant γ and the coefficients of the extremal function.
    pub(crate) fn largest_quotient(&mut self) -> Result<(f64, Vec<f64>)> {
        let mass = self.mass(&self.primitives);
        let (square, vector) = self.factored.largest_eigenvalue(&mass)?;
        self.work.factorizations += 1;
        let vector = self.links.expanded(vector);
        let vector = match &self.local {
            Some(local) => local.restored(&self.space, vector),
            None => vector,
        };
        Ok((square.sqrt() * self.factor, vector))
    }

    /// The mass matrix in the basis of the factorized matrix.
    fn mass(&self, primitives: &Primitives) -> DMatrix<f64> {
        let mass = mass_gram(&self.space, primitives);
        self.links.reduced(match &self.local {
            Some(local) => local.transformed(&self.space, mass),
            None => mass,
        })
    }

    /// The dual norm of the functional that maps u to its mean over the whole interval.
    pub(crate) fn dual_norm(&self) -> Result<DualNorm> {
        let mut mean = self.primitives.means(&self.space);
        if let Some(local) = &self.local {
            mean = local.transformed_vector(&self.space, mean);
        }
        let mean = self.links.reduced_vector(mean);
        let representer = self.factored.solve(&mean);
        let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(x, y)| x * y).sum::<f64>();
        let square = dot(&mean, &representer);
        if square <= 0.0 {
            return Ok(DualNorm { square: 0.0, rayleigh: 0.0, image: 0.0 });
        }
        let whole = 0..self.space.cells.len();
        let centred = Primitives::new(&self.space, std::slice::from_ref(&whole), self.points)?;
        let mass = self.mass(&centred);
        let size = mean.len();
        let unit: Vec<f64> = representer.iter().map(|x| x / square.sqrt()).collect();
        let moved: Vec<f64> =
            (0..size).map(|i| (0..size).map(|j| mass[(i, j)] * unit[j]).sum()).collect();
        let rayleigh = dot(&unit, &moved);
        let image = dot(&moved, &self.factored.solve(&moved));
        Ok(DualNorm { square, rayleigh, image })
    }
}

impl DualNorm {
    /// An upper bound of γ², given γ₁² in the same units: the smaller of γ₁² + N² and the largest eigenvalue of
    /// the matrix (N² + ⟨Te,e⟩, σ; σ, γ₁²), σ² = ‖Te‖² − ⟨Te,e⟩², because T ≤ γ₁² on the complement of e.
    pub(crate) fn upper_bound(&self, whole_square: f64) -> f64 {
        let first = self.square + self.rayleigh;
        let coupling = (self.image - self.rayleigh * self.rayleigh).max(0.0);
        let half = 0.5 * (first - whole_square);
        let centre = 0.5 * (first + whole_square);
        (centre + (half * half + coupling).sqrt()).min(self.square + whole_square)
    }
}
