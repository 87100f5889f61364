//! The levels of a case of the strip at all its positions, and their mean.
//!
//! The observed order of a transition alternates with its position in the cell; the mean of |u − u_h|² over
//! evenly spread positions has no such phase.

use super::level_loop::Level;
use super::strip_case::StripCase;
use super::strip_levels::strip_levels;
use fractional_sobolev::{Estimate, Work};
use signorini::problems::StripData;
use signorini::rates::order_between;
use signorini::strip::{EdgeData, StripProblem};
use signorini::{Error, Result, ToolkitError};

/// The levels of a case at every position.
#[derive(Debug, Clone, PartialEq)]
pub struct CaseStudy {
    /// One level study per position.
    pub studies: Vec<Vec<Level>>,
    /// Root mean square over the positions of |u − u_h|_a on each level.
    pub errors: Vec<Estimate>,
    /// τ, when it is known.
    pub regularity: Option<f64>,
    /// Gaps of the scene on its grid.
    pub gaps: usize,
    /// Gaps of its construction, `None` for samples.
    pub planned_gaps: Option<u64>,
    /// Cells of the grid of the scene.
    pub scene_cells: usize,
}

/// How all levels of a case were solved.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Solved {
    /// The worst KKT figure.
    pub worst_kkt: f64,
    /// Number of levels whose iteration did not converge.
    pub unsolved: f64,
    /// The most inner iterations of a step.
    pub most_inner: f64,
}

impl CaseStudy {
    /// Solves all levels of a case at all positions; `report` is called after each level.
    ///
    /// # Errors
    /// As [`StripCase::sources`], [`signorini::problems::StripData::data`], [`StripProblem::new`] and
    /// [`strip_levels`].
    pub fn of(case: &StripCase, mut report: impl FnMut(&Level)) -> Result<Self> {
        let sources = case.sources()?;
        let build =
            |source: &StripData| source.data(case.tau, case.levels.reference_cells(), case.kind.sides());
        let first: EdgeData = build(&sources[0])?;
        let finest = case.levels.finest_cells();
        if first.cells() < finest {
            return Err(Error::Toolkit(ToolkitError::LengthMismatch {
                name: "cells of the scene (lower the finest of --levels, or give finer samples): the edge",
                given: first.cells(),
                expected: finest,
            }));
        }
        let mut problem = StripProblem::new(case.kind, &first, case.reference, case.levels.coarsest_cells())?;
        let mut studies = Vec::new();
        for source in &sources {
            if !studies.is_empty() {
                problem.set_data(&build(source)?)?;
            }
            studies.push(strip_levels(&problem, case.levels, case.cone, &mut report)?);
        }
        let errors = mean_errors(&studies)?;
        let planned_gaps = case.source.gaps();
        let (regularity, gaps, scene_cells) = (first.regularity(), first.gaps(), first.cells());
        Ok(Self { studies, errors, regularity, gaps, planned_gaps, scene_cells })
    }

    /// How the levels were solved, over all positions.
    pub fn solved(&self) -> Solved {
        Solved {
            worst_kkt: self.levels().fold(0.0, |worst: f64, level| worst.max(level.facts.kkt)),
            unsolved: self.levels().filter(|level| !level.facts.status.is_converged()).count() as f64,
            most_inner: self.levels().map(|level| level.facts.most_inner()).max().unwrap_or(0) as f64,
        }
    }

    /// The gaps in words: `1 gap`, or `15 of 255 gaps` where the grid holds fewer than the construction has.
    pub fn gaps_text(&self) -> String {
        let plural = |count: u64| if count == 1 { "gap" } else { "gaps" };
        match self.planned_gaps {
            Some(planned) if planned != self.gaps as u64 => {
                format!("{} of {planned} {}", self.gaps, plural(planned))
            }
            _ => format!("{} {}", self.gaps, plural(self.gaps as u64)),
        }
    }

    /// Why gaps of the construction are missing, if some are.
    pub fn missing_gaps(&self) -> Option<String> {
        let missing = self.planned_gaps?.checked_sub(self.gaps as u64).filter(|&count| count > 0)?;
        let cells = self.scene_cells;
        Some(format!("{missing} gaps left out, under 2 cells wide or too near on the grid of {cells} cells"))
    }

    /// One row of numbers per level, of the first position but for the errors: n, unknowns, |u − u_h|_a, what
    /// it may be off by, log₂ of the ratio of errors, contact runs, linear problems, most inner iterations in
    /// one, worst KKT figure, seconds, seconds for the error. What does not exist is NaN.
    pub fn rows(&self) -> Vec<[f64; 11]> {
        let order = |i: usize| {
            let point = |k: usize| (1.0 / self.studies[0][k].facts.cells as f64, self.errors[k].value);
            let order = i.checked_sub(1).map(|k| order_between(point(k), point(i)));
            order.filter(|order| order.is_finite()).unwrap_or(f64::NAN)
        };
        let row = |(i, level): (usize, &Level)| {
            let Level { facts, seconds, error_seconds, .. } = level;
            let (n, error) = (facts.cells as f64, self.errors[i]);
            let counts = [facts.contact_runs, facts.inner_iterations.len(), facts.most_inner()];
            let [runs, steps, inner] = counts.map(|count| count as f64);
            let (unknowns, kkt, seconds, error_seconds) =
                (facts.unknowns, facts.kkt, *seconds, *error_seconds);
            [n, unknowns, error.value, error.error, order(i), runs, steps, inner, kkt, seconds, error_seconds]
        };
        self.studies[0].iter().enumerate().map(row).collect()
    }

    /// All levels at all positions.
    pub fn levels(&self) -> impl Iterator<Item = &Level> {
        self.studies.iter().flatten()
    }
}

/// Root mean square of the errors of several studies over the same levels.
///
/// # Errors
/// [`ToolkitError::LengthMismatch`](signorini::ToolkitError::LengthMismatch) for studies of different lengths; [`ToolkitError::CountOutOfRange`](signorini::ToolkitError::CountOutOfRange) without any.
pub fn mean_errors(studies: &[Vec<Level>]) -> Result<Vec<Estimate>> {
    let Some(first) = studies.first() else {
        return Err(Error::Toolkit(ToolkitError::CountOutOfRange {
            name: "studies",
            value: 0,
            range: "[1, inf)",
        }));
    };
    for study in studies {
        if study.len() != first.len() {
            let (name, given, expected) = ("study", study.len(), first.len());
            return Err(Error::Toolkit(ToolkitError::LengthMismatch { name, given, expected }));
        }
    }
    let count = studies.len() as f64;
    (0..first.len())
        .map(|i| {
            let errors = || studies.iter().map(|study| study[i].error);
            let mean = (errors().map(|e| e.value * e.value).sum::<f64>() / count).sqrt();
            let bound = errors().map(|e| e.error).fold(0.0, f64::max);
            let work = errors().fold(Work::default(), |w, e| w + e.work);
            Ok(Estimate::new(mean, bound, work)?)
        })
        .collect()
}
