//! Pictures of a contact solution: the deformed body, and the contact edge.

use super::body::Body;
use super::history::history_chart;
use super::listing::worst;
use crate::figures::{Axis, Chart, Series};
use crate::{Headline, Output, Result};
use experiments::contact_levels::{SceneRun, SceneStudy};
use signorini::contact::Solver;
use std::ops::Range;

/// What figures are called.
pub(super) struct Drawing {
    /// In the keys of quoted numbers.
    pub(super) key: String,
    /// In the names of files.
    pub(super) file: String,
    /// In titles.
    pub(super) title: String,
}

impl Drawing {
    fn name(&self, what: &str, run: &SceneRun) -> String {
        format!("section_2_{}_{what}_{}", self.file, run.solution.cone)
    }
}

/// Quotes energy, force, active constraints and the worst condition of the finest mesh as
/// `section.2.KEY.CONE.WHAT`, and draws it where figures are asked for: its body, the contact edge, the
/// contact sets of every step. Returns the ends of the scale of colour.
///
/// # Errors
/// Those of the files.
pub(super) fn quote_and_draw(
    headline: &mut Headline,
    drawing: &Drawing,
    runs: &[SceneRun],
    output: &Output,
) -> Result<Option<(f64, f64)>> {
    let finest = runs.last().map(|run| run.n);
    let Some(last) = runs.iter().find(|run| Some(run.n) == finest) else {
        return Ok(None);
    };
    let (solution, key) = (&last.solution, &drawing.key);
    let kkt = worst(runs.iter().map(|run| run.solution.kkt.worst()));
    let active = solution.contact_set.count() as f64;
    let (energy, force) = (solution.energy, solution.contact_force);
    for (what, value) in [("energy", energy), ("force", force), ("active", active), ("kkt", kkt)] {
        headline.quote(format!("section.2.{key}.{}.{what}", solution.cone), value);
    }
    let Some(directory) = output.directory()? else {
        return Ok(None);
    };
    let body = Body::of(last)?;
    let range = body.range();
    headline.figures.push(body.save(&drawing.title, directory, &drawing.name("body", last), range)?);
    headline.figures.push(edge_chart(last, &drawing.title).save(directory, &drawing.name("edge", last))?);
    if let Some(chart) = history_chart(last, &drawing.title) {
        headline.figures.push(chart.save(directory, &drawing.name("history", last))?);
    }
    Ok(Some(range))
}

/// The body of a scene on meshes two, four and eight times coarser than the coarsest, for a picture that
/// moves with h, on one scale of colour.
///
/// # Errors
/// Those of the solutions and of the files.
pub(super) fn draw_coarser(
    headline: &mut Headline,
    study: &SceneStudy,
    drawing: &Drawing,
    range: (f64, f64),
    output: &Output,
) -> Result<()> {
    let Some(directory) = output.directory()? else {
        return Ok(());
    };
    let coarser = [8, 4, 2].map(|factor| study.n / factor);
    for n in coarser.into_iter().filter(|&n| n >= 2) {
        let coarse = SceneStudy { n, levels: 1, solver: Some(Solver::ActiveSet), ..*study };
        for run in coarse.run()? {
            let name = format!("{}_{n}", drawing.name("body", &run));
            headline.figures.push(Body::of(&run)?.save(&drawing.title, directory, &name, range)?);
        }
    }
    Ok(())
}

/// u_N and −σ_N along the contact edges, each over its largest value.
fn edge_chart(run: &SceneRun, scene: &str) -> Chart {
    let SceneRun { problem, solution, .. } = run;
    let pieces = problem.edge().pieces();
    let scaled = |values: &[f64], piece: Range<usize>| -> Vec<(f64, f64)> {
        let largest = values.iter().fold(0.0, |m: f64, v| m.max(v.abs()));
        let unit = if largest > 0.0 { largest } else { 1.0 };
        piece.map(|i| (problem.edge().arc()[i], values[i] / unit)).collect()
    };
    let title = format!("{scene}: displacement and pressure on the contact edge, {} cone", solution.cone);
    let (x, y) =
        (Axis::linear("distance along the contact edge"), Axis::linear("share of the largest value"));
    let count = pieces.len();
    pieces.into_iter().enumerate().fold(Chart::new(title, x, y), |chart, (number, piece)| {
        let which = if count > 1 { format!(", edge {}", number + 1) } else { String::new() };
        let displacement = scaled(&solution.normal_displacement, piece.clone());
        chart
            .with(Series::line(format!("u_N, displacement towards the foundation{which}"), displacement))
            .with(Series::line_and_points(
                format!("−σ_N, contact pressure{which}"),
                scaled(&solution.pressure, piece),
            ))
    })
}
