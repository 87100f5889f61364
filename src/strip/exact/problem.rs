//! Either strip with an exact solution, behind one face.

use super::elastic::ExactElastic;
use super::reference::Reference;
use super::scalar::ExactEdge;
use crate::error::{Error, Result, ToolkitError};
use crate::fem::Lame;
use crate::strip::edge_data::EdgeData;
use crate::strip::operator::edge::EdgeOperator;
use crate::strip::operator::scalar::ScalarStrip;
use crate::strip::sides::LateralCondition;
use fractional_sobolev::Estimate;
use std::fmt;
use std::str::FromStr;

/// Which strip.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum StripKind {
    /// Laplace, natural sides.
    Scalar,
    /// Elasticity, periodic sides.
    Elastic,
}

impl StripKind {
    /// The sides of this kind of strip.
    pub fn sides(self) -> LateralCondition {
        match self {
            StripKind::Scalar => LateralCondition::Natural,
            StripKind::Elastic => LateralCondition::Periodic,
        }
    }
}

impl fmt::Display for StripKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            StripKind::Scalar => "scalar",
            StripKind::Elastic => "elastic",
        })
    }
}

impl FromStr for StripKind {
    type Err = Error;

    fn from_str(text: &str) -> Result<Self> {
        match text {
            "scalar" => Ok(StripKind::Scalar),
            "elastic" => Ok(StripKind::Elastic),
            _ => Err(Error::Toolkit(ToolkitError::UnknownName {
                what: "kind",
                given: text.to_owned(),
                expected: "scalar or elastic",
            })),
        }
    }
}

/// Complementary data as exact solution on a unit square strip.
#[derive(Debug, Clone)]
pub struct StripProblem(Exact);

#[derive(Debug, Clone)]
enum Exact {
    Scalar(ExactEdge),
    Elastic(ExactElastic),
}

impl StripProblem {
    /// Height 1; elastic: λ = μ = 1, compared with the discrete solution on the grid of the test problem only.
    ///
    /// # Errors
    /// As [`EdgeData::new`], [`ToolkitError::Incompatible`] for sides of the other kind, [`ToolkitError::CountOutOfRange`] unless the
    /// number of cells is a power of two; [`ToolkitError::Incompatible`](crate::ToolkitError::Incompatible) for a continuous elastic
    /// reference.
    pub fn new(kind: StripKind, scene: &EdgeData, reference: Reference, coarsest: usize) -> Result<Self> {
        Ok(Self(match kind {
            StripKind::Scalar => Exact::Scalar(ExactEdge::scalar(scene, (1, 1), reference)?),
            StripKind::Elastic if reference != Reference::Nested => {
                return Err(Error::Toolkit(ToolkitError::Incompatible {
                    what: "reference",
                    given: reference.to_string(),
                    with: "the elastic strip",
                    expected: "nested",
                }));
            }
            StripKind::Elastic => {
                Exact::Elastic(ExactElastic::new(scene, (1, 1), Lame::new(1.0, 1.0)?, coarsest)?)
            }
        }))
    }

    /// Replaces the test problem by another one on the same grid; much cheaper than a new problem.
    ///
    /// # Errors
    /// [`ToolkitError::LengthMismatch`](crate::ToolkitError::LengthMismatch) when the grid is another one.
    pub fn set_scene(&mut self, scene: &EdgeData) -> Result<()> {
        match &mut self.0 {
            Exact::Scalar(exact) => exact.set_scene(scene),
            Exact::Elastic(exact) => exact.set_scene(scene),
        }
    }

    /// The edge operator on `cells` cells and the number of unknowns it stands for.
    ///
    /// # Errors
    /// [`ToolkitError::CountOutOfRange`](crate::ToolkitError::CountOutOfRange) for a level that does not exist.
    pub fn operator(&self, cells: usize) -> Result<(EdgeOperator, f64)> {
        match &self.0 {
            Exact::Scalar(exact) => {
                let strip = ScalarStrip::new(cells, exact.layers(cells)?)?;
                let unknowns = strip.virtual_unknowns();
                Ok((strip.into_operator(), unknowns))
            }
            Exact::Elastic(exact) => {
                let unknowns = 2.0 * cells as f64 * exact.layers(cells)? as f64;
                Ok((exact.operator(cells)?, unknowns))
            }
        }
    }

    /// b: the nodal forces of the load on the edge of `cells` cells.
    ///
    /// # Errors
    /// [`ToolkitError::CountOutOfRange`](crate::ToolkitError::CountOutOfRange) for a level that does not exist.
    pub fn load(&self, cells: usize) -> Result<Vec<f64>> {
        match &self.0 {
            Exact::Scalar(exact) => exact.load(cells),
            Exact::Elastic(exact) => exact.load(cells),
        }
    }

    /// |u − u_h|_a for the discrete solution with edge values `values` on `cells` cells. It takes no tolerance: the
    /// energy is a finite sum of nonnegative terms over modes, and the error is its rounding.
    ///
    /// # Errors
    /// [`ToolkitError::CountOutOfRange`](crate::ToolkitError::CountOutOfRange) for a level that does not exist, [`ToolkitError::LengthMismatch`](crate::ToolkitError::LengthMismatch).
    pub fn error(&self, cells: usize, values: &[f64]) -> Result<Estimate> {
        match &self.0 {
            Exact::Scalar(exact) => exact.error(cells, values),
            Exact::Elastic(exact) => exact.error(cells, values),
        }
    }
}
