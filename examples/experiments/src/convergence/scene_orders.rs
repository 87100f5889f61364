//! The regularity of every mesh scene beside the order of its error on nested meshes, and beside the exponent
//! read at the corner responsible, which is known far more sharply.

use super::corner_reading::CornerReading;
use super::mesh_rates::MeshRates;
use super::study::Quantity;
use signorini::Result;
use signorini::cone::Cone;
use signorini::contact::Solver;
use signorini::problems::{CornerSingularity, Parameters, TestProblem, solution_regularity};
use signorini::rates::ConvergenceOrder;

/// A scene with its regularity and what a rate study shows.
#[derive(Debug, Clone, PartialEq)]
pub struct SceneOrder {
    /// The scene.
    pub scene: TestProblem,
    /// The supremum of the τ with u ∈ H^τ, from corners and contact set.
    pub tau: f64,
    /// The corner responsible.
    pub corner: Option<CornerSingularity>,
    /// The same with the contact set of uniform squares alone, as fine as the finest of the study.
    pub on_squares: f64,
    /// Order of the error; `None` for too few levels.
    pub order: Option<ConvergenceOrder>,
    /// The exponent read at the corner; `None` for scenes that have none ([`CornerReading::of`]).
    pub reading: Option<CornerReading>,
}

impl SceneOrder {
    /// |order − min(1, τ − 1)| over what the order may be off by.
    pub fn deviation(&self) -> Option<f64> {
        self.order.map(|fit| (fit.order - (self.tau - 1.0).min(1.0)).abs() / fit.uncertainty)
    }

    /// Its numbers by name: tau, on_squares, and read with read_error where an exponent was read, border
    /// where contact begins or ends near that corner.
    pub fn numbers(&self) -> Vec<(&'static str, f64)> {
        let mut numbers = vec![("tau", self.tau), ("on_squares", self.on_squares)];
        if let Some(reading) = &self.reading {
            numbers.extend([("read", reading.exponent.value), ("read_error", reading.exponent.error)]);
            numbers.extend(reading.border.map(|border| ("border", border)));
        }
        numbers
    }

    /// Opening in degrees and exponent of the corner responsible: read, or else computed.
    pub fn point(&self) -> Option<(f64, f64)> {
        let read = self.reading.as_ref().map_or(self.tau - 1.0, |reading| reading.exponent.value);
        Some((self.corner.as_ref()?.wedge.angle().to_degrees(), read))
    }

    /// The reading whose distance from the exponent of its corner is the largest part of its error; `None`
    /// without readings.
    pub fn worst_reading(rows: &[Self]) -> Option<&CornerReading> {
        let all = rows.iter().filter_map(|row| row.reading.as_ref());
        all.max_by(|a, b| a.deviation().total_cmp(&b.deviation()))
    }

    /// The largest error of a reading; `None` without readings.
    pub fn widest_reading(rows: &[Self]) -> Option<f64> {
        let errors = rows.iter().filter_map(|row| row.reading.as_ref()).map(|reading| reading.exponent.error);
        errors.max_by(f64::total_cmp)
    }

    /// Scenes to which uniform squares give another τ.
    pub fn unseen(rows: &[Self]) -> usize {
        rows.iter().filter(|row| (row.on_squares - row.tau).abs() > SAME).count()
    }

    /// The largest deviation; `None` where an order is missing, NaN where one is.
    pub fn furthest(rows: &[Self]) -> Option<f64> {
        let all: Option<Vec<f64>> = rows.iter().map(Self::deviation).collect();
        Some(
            all?.into_iter()
                .fold(0.0, |m: f64, x| if x.is_nan() || m.is_nan() { f64::NAN } else { m.max(x) }),
        )
    }
}

/// Two suprema nearer than this are one.
const SAME: f64 = 1e-9;
/// Cells of the coarser mesh of a reading.
const CELLS: usize = 4;

/// All mesh scenes in the nodal cone on meshes of n, 2n, ... squares along each side; `report` is called
/// after each.
///
/// # Errors
/// As [`TestProblem::regularity`], [`MeshRates::study`] and [`CornerReading::of`].
pub fn scene_orders(coarsest: usize, levels: usize, mut report: impl FnMut()) -> Result<Vec<SceneOrder>> {
    let setting = Parameters::default();
    let mut rows = Vec::new();
    for scene in TestProblem::all() {
        let found = scene.regularity(&setting)?;
        let rates = MeshRates { scene, setting, constant_load: false, coarsest, levels };
        let study = rates.study(&[Cone::Nodal])?;
        let order = study.first().and_then(|study| study.fit(Quantity::Error));
        let problem = scene.problem_with(coarsest << (levels - 1), &setting)?;
        let on_squares = solution_regularity(&problem, &problem.solve(Cone::Nodal, Solver::ActiveSet)?)?.tau;
        let reading = CornerReading::of(scene, &setting, CELLS)?;
        let corner = found.responsible().cloned();
        rows.push(SceneOrder { scene, tau: found.tau, corner, on_squares, order, reading });
        report();
    }
    Ok(rows)
}
