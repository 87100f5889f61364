//! Level after level: the discrete solutions of one scene and their exact errors.
//!
//! Each level starts from the contact set of the coarser one. The observed order between n/2 and n is log₂ of the ratio of
//! errors. For a transition it alternates with the position of the transition in its cell.

use super::edge::EdgeOperator;
use super::edge_data::EdgeData;
use super::exact::{ExactEdge, Reference};
use super::exact_elastic::ExactElastic;
use super::scalar::{EdgeLoad, ScalarStrip};
use super::sides::Sides;
use super::solution::{EdgeSolution, Settings};
use super::solve::solve_contact;
use crate::cone::{Cone, Status};
use crate::error::{Error, Result};
use crate::estimate::Estimate;
use crate::fem::Lame;
use std::fmt;
use std::str::FromStr;
use std::time::Instant;

/// Levels n = 2^coarsest ... 2^finest; read from `3-14`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Levels {
    coarsest: u32,
    finest: u32,
}

impl Levels {
    /// 1 ≤ coarsest ≤ finest ≤ 22.
    ///
    /// # Errors
    /// [`Error::CountOutOfRange`] otherwise.
    pub fn new(coarsest: u32, finest: u32) -> Result<Self> {
        for (name, value) in [("coarsest level", coarsest), ("finest level", finest)] {
            if !(1..=22).contains(&value) {
                return Err(Error::CountOutOfRange { name, value: value as usize, range: "[1, 22]" });
            }
        }
        if coarsest > finest {
            return Err(Error::CountOutOfRange {
                name: "coarsest level",
                value: coarsest as usize,
                range: "[1, finest level]",
            });
        }
        Ok(Self { coarsest, finest })
    }

    /// The numbers of cells, coarsest first.
    pub fn cells(self) -> impl Iterator<Item = usize> {
        (self.coarsest..=self.finest).map(|level| 1 << level)
    }

    /// Cells of the coarsest level.
    pub fn coarsest_cells(self) -> usize {
        1 << self.coarsest
    }

    /// Cells of the finest level.
    pub fn finest_cells(self) -> usize {
        1 << self.finest
    }

    /// Cells of the grid the scene lives on: 64 times the finest level, but not above 2^20 unless four times the finest level is.
    pub fn reference_cells(self) -> usize {
        1 << (self.finest + 6).min(20).max(self.finest + 2)
    }
}

impl fmt::Display for Levels {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}-{}", self.coarsest, self.finest)
    }
}

impl FromStr for Levels {
    type Err = Error;

    fn from_str(text: &str) -> Result<Self> {
        let unknown = || Error::UnknownName {
            what: "levels",
            given: text.to_owned(),
            expected: "COARSEST-FINEST, powers of two, for example 3-14",
        };
        let (coarsest, finest) = text.split_once('-').ok_or_else(unknown)?;
        let number = |word: &str| word.trim().parse().map_err(|_| unknown());
        Self::new(number(coarsest)?, number(finest)?)
    }
}

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
    pub fn sides(self) -> Sides {
        match self {
            StripKind::Scalar => Sides::Natural,
            StripKind::Elastic => Sides::Periodic,
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
            _ => Err(Error::UnknownName {
                what: "kind",
                given: text.to_owned(),
                expected: "scalar or elastic",
            }),
        }
    }
}

/// A scene with its exact solution on a unit square strip.
#[derive(Debug, Clone)]
pub enum StripProblem {
    /// Scalar.
    Scalar(ExactEdge),
    /// Elastic, λ = μ = 1.
    Elastic(ExactElastic),
}

impl StripProblem {
    /// Height 1; elastic: λ = μ = 1, compared with the discrete solution on the grid of the scene only.
    ///
    /// # Errors
    /// As [`ExactEdge::scalar`] and [`ExactElastic::new`]; [`Error::DoesNotFit`] for a continuous elastic reference.
    pub fn new(kind: StripKind, scene: &EdgeData, reference: Reference, coarsest: usize) -> Result<Self> {
        Ok(match kind {
            StripKind::Scalar => Self::Scalar(ExactEdge::scalar(scene, (1, 1), reference)?),
            StripKind::Elastic if reference != Reference::Nested => {
                return Err(Error::DoesNotFit {
                    what: "reference",
                    given: reference.to_string(),
                    expected: "nested for the elastic strip",
                });
            }
            StripKind::Elastic => {
                Self::Elastic(ExactElastic::new(scene, (1, 1), Lame::new(1.0, 1.0)?, coarsest)?)
            }
        })
    }

    /// Replaces the scene by another one on the same grid; much cheaper than a new problem.
    ///
    /// # Errors
    /// [`Error::LengthMismatch`] when the grid is another one.
    pub fn set_scene(&mut self, scene: &EdgeData) -> Result<()> {
        match self {
            Self::Scalar(exact) => exact.set_scene(scene),
            Self::Elastic(exact) => exact.set_scene(scene),
        }
    }

    /// The edge operator on `cells` cells and the number of unknowns it stands for.
    ///
    /// # Errors
    /// [`Error::CountOutOfRange`] for a level that does not exist.
    pub fn operator(&self, cells: usize) -> Result<(EdgeOperator, f64)> {
        match self {
            Self::Scalar(exact) => {
                let strip = ScalarStrip::new(cells, exact.layers(cells)?)?;
                let unknowns = strip.virtual_unknowns();
                Ok((strip.into_operator(), unknowns))
            }
            Self::Elastic(exact) => {
                let unknowns = 2.0 * cells as f64 * exact.layers(cells)? as f64;
                Ok((exact.operator(cells)?, unknowns))
            }
        }
    }

    /// The load on `cells` cells.
    ///
    /// # Errors
    /// [`Error::CountOutOfRange`] for a level that does not exist.
    pub fn load(&self, cells: usize) -> Result<EdgeLoad> {
        match self {
            Self::Scalar(exact) => exact.load(cells),
            Self::Elastic(exact) => exact.load(cells),
        }
    }

    /// |u − u_h|_a.
    ///
    /// # Errors
    /// [`Error::CountOutOfRange`] for a level that does not exist, [`Error::LengthMismatch`].
    pub fn error(&self, cells: usize, values: &[f64]) -> Result<Estimate> {
        match self {
            Self::Scalar(exact) => exact.error(cells, values),
            Self::Elastic(exact) => exact.error(cells, values),
        }
    }
}

/// What is kept of one level.
#[derive(Debug, Clone, PartialEq)]
pub struct Level {
    /// Cells n; h = 1/n.
    pub cells: usize,
    /// Unknowns of the two-dimensional problem this stands for.
    pub virtual_unknowns: f64,
    /// |u − u_h|_a.
    pub error: Estimate,
    /// Maximal runs of active constraints.
    pub contact_runs: usize,
    /// Inner iterations of each step.
    pub inner_iterations: Vec<usize>,
    /// How the contact iteration ended.
    pub status: Status,
    /// The worst KKT figure.
    pub kkt: f64,
    /// Seconds for operator, load and contact.
    pub seconds: f64,
    /// Seconds for the error.
    pub error_seconds: f64,
}

/// Solves all levels, each from the coarser one; `report` is called after each.
///
/// # Errors
/// Those of the parts; a level that did not converge is not an error but a status.
pub fn study(
    problem: &StripProblem,
    levels: Levels,
    cone: Cone,
    mut report: impl FnMut(&Level),
) -> Result<Vec<Level>> {
    let mut previous: Option<EdgeSolution> = None;
    let mut rows = Vec::new();
    for cells in levels.cells() {
        let start = Instant::now();
        let (operator, virtual_unknowns) = problem.operator(cells)?;
        let load = problem.load(cells)?;
        let solution = solve_contact(&operator, &load, cone, previous.as_ref(), &Settings::default())?;
        let seconds = start.elapsed().as_secs_f64();
        let error = problem.error(cells, &solution.values)?;
        let level = Level {
            cells,
            virtual_unknowns,
            error,
            contact_runs: solution.contact.runs().len(),
            inner_iterations: solution.inner_iterations.clone(),
            status: solution.status,
            kkt: solution.judgement.worst(),
            seconds,
            error_seconds: start.elapsed().as_secs_f64() - seconds,
        };
        report(&level);
        rows.push(level);
        previous = Some(solution);
    }
    Ok(rows)
}
