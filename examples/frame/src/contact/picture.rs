//! Pictures of a contact solution: the deformed body, and the contact edge.

use super::body::Body;
use super::history::history_chart;
use super::listing::worst;
use crate::figures::{Axis, Chart, Series};
use crate::{Headline, Output, Result};
use signorini::contact::Solver;
use signorini::scenes::{SceneRun, SceneStudy};

/// Quotes energy, force, active constraints and the worst condition of the finest mesh as
/// `section.2.SCENE.CONE.WHAT`, and draws it.
///
/// # Errors
/// Those of the coarser solutions and of the files.
pub fn quote_and_draw(
    headline: &mut Headline,
    study: &SceneStudy,
    runs: &[SceneRun],
    output: &Output,
) -> Result<()> {
    let finest = runs.last().map(|run| run.n);
    let Some(last) = runs.iter().find(|run| Some(run.n) == finest) else {
        return Ok(());
    };
    let kkt = worst(runs.iter().map(|run| run.solution.judgement.worst()));
    let active = last.solution.contact_set.count() as f64;
    let (energy, force) = (last.solution.energy, last.solution.contact_force);
    for (key, value) in [("energy", energy), ("force", force), ("active", active), ("kkt", kkt)] {
        headline.quote(format!("section.2.{}.{}.{key}", study.scene, study.cone), value);
    }
    draw(headline, study, last, output)
}

/// The pictures of a scene, where figures are asked for: its body, also on meshes two, four and eight times
/// coarser than the coarsest for a picture that moves with h, on one scale of colour; the contact edge; the
/// contact sets of every step.
fn draw(headline: &mut Headline, study: &SceneStudy, last: &SceneRun, output: &Output) -> Result<()> {
    let Some(directory) = output.directory()? else {
        return Ok(());
    };
    let (scene, cone) = (study.scene, study.cone);
    let title = format!("Scene {scene}");
    let name = |what: &str| format!("section_2_{scene}_{what}_{cone}");
    let body = Body::of(last)?;
    let range = body.range();
    headline.figures.push(body.save(&title, directory, &name("body"), range)?);
    headline.figures.push(edge_chart(last, &title).save(directory, &name("edge"))?);
    if let Some(chart) = history_chart(last, &title) {
        headline.figures.push(chart.save(directory, &name("history"))?);
    }
    let coarser = [8, 4, 2].map(|factor| study.n / factor);
    for n in coarser.into_iter().filter(|&n| n >= 2) {
        let coarse = SceneStudy { n, levels: 1, solver: Some(Solver::ActiveSet), ..*study };
        for run in coarse.run()? {
            let name = format!("{}_{n}", name("body"));
            headline.figures.push(Body::of(&run)?.save(&title, directory, &name, range)?);
        }
    }
    Ok(())
}

/// u_N and −σ_N along the contact edge, each over its largest value.
fn edge_chart(run: &SceneRun, scene: &str) -> Chart {
    let SceneRun { problem, solution, .. } = run;
    let arc = problem.edge().arc();
    let scaled = |values: &[f64]| -> Vec<(f64, f64)> {
        let largest = values.iter().fold(0.0, |m: f64, v| m.max(v.abs()));
        let unit = if largest > 0.0 { largest } else { 1.0 };
        arc.iter().zip(values).map(|(&x, v)| (x, v / unit)).collect()
    };
    let title = format!("{scene}: displacement and pressure on the contact edge, {} cone", solution.cone);
    Chart::new(title, Axis::linear("x along the contact edge"), Axis::linear("share of the largest value"))
        .with(Series::line("u_N, displacement towards the foundation", scaled(&solution.normal_displacement)))
        .with(Series::line_and_points("−σ_N, contact pressure", scaled(&solution.pressure)))
}
