//! Pictures of a contact solution: the deformed body on its foundation, and the contact edge.

use super::history::history_chart;
use super::listing::worst;
use crate::figures::{Axis, BodyPicture, Chart, Series};
use crate::{Headline, Output, Result};
use signorini::contact::Solver;
use signorini::fem::stresses;
use signorini::scenes::{SceneRun, SceneStudy};
use std::path::{Path, PathBuf};

/// The largest displacement is drawn at most this long, relative to the extent of the body.
const DRAWN: f64 = 0.25;
/// The largest pressure arrow, relative to the extent of the body.
const ARROW: f64 = 0.15;

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

/// The pictures of a scene, where figures are asked for: the body of an elastic one, also on meshes two, four
/// and eight times coarser than the coarsest for a picture that moves with h; the contact edge; the contact
/// sets of every step.
fn draw(headline: &mut Headline, study: &SceneStudy, last: &SceneRun, output: &Output) -> Result<()> {
    let Some(directory) = output.directory()? else {
        return Ok(());
    };
    let (scene, cone) = (study.scene, study.cone);
    let title = format!("Scene {scene}");
    let name = |what: &str| format!("section_2_{scene}_{what}_{cone}");
    if scene.is_elastic() {
        headline.figures.push(save_body(last, &title, directory, &name("body"))?);
    }
    headline.figures.push(edge_chart(last, &title).save(directory, &name("edge"))?);
    if let Some(chart) = history_chart(last, &title) {
        headline.figures.push(chart.save(directory, &name("history"))?);
    }
    let coarser = [8, 4, 2].map(|factor| study.n / factor);
    for n in coarser.into_iter().filter(|&n| n >= 2 && scene.is_elastic()) {
        let coarse = SceneStudy { n, levels: 1, solver: Some(Solver::ActiveSet), ..*study };
        for run in coarse.run()? {
            let name = format!("{}_{n}", name("body"));
            headline.figures.push(save_body(&run, &title, directory, &name)?);
        }
    }
    Ok(())
}

/// Draws the deformed elastic body with its largest shear stress and the contact pressure as
/// `directory/name.svg`.
///
/// Displacements are magnified by 1, 2 or 5 times a power of ten, said in the title.
///
/// # Errors
/// Those of [`stresses`] (a scalar problem has none) and of [`BodyPicture::save`].
fn save_body(run: &SceneRun, scene: &str, directory: &Path, name: &str) -> Result<PathBuf> {
    let SceneRun { problem, solution, .. } = run;
    let mesh = problem.mesh();
    let shear: Vec<f64> = stresses(mesh, problem.form(), &solution.displacement)?
        .iter()
        .map(|stress| stress.max_shear())
        .collect();
    let extent = mesh.nodes().iter().flatten().fold(0.0, |m: f64, x| m.max(x.abs())).max(f64::MIN_POSITIVE);
    let largest = solution.displacement.iter().fold(0.0, |m: f64, u| m.max(u.abs()));
    let magnification = if largest > 0.0 { one_two_five(DRAWN * extent / largest) } else { 1.0 };
    let moved = |node: usize| -> [f64; 2] {
        std::array::from_fn(|axis| {
            mesh.nodes()[node][axis] + magnification * solution.displacement[2 * node + axis]
        })
    };
    let nodes: Vec<[f64; 2]> = (0..mesh.nodes().len()).map(moved).collect();
    let strongest = solution.pressure.iter().fold(0.0, |m: f64, p| m.max(p.abs()));
    let length = |p: f64| if strongest > 0.0 { ARROW * extent * p / strongest } else { 0.0 };
    let arrows: Vec<([f64; 2], [f64; 2])> = problem
        .edge()
        .nodes()
        .iter()
        .zip(&solution.pressure)
        .filter(|&(_, &p)| p > 0.0)
        .map(|(&node, &p)| ([nodes[node][0], nodes[node][1] - length(p)], nodes[node]))
        .collect();
    let foundation = problem.edge().points().first().map(|point| point[1]);
    let picture = BodyPicture {
        title: format!("{scene}, displacement × {magnification}, {} cone", solution.cone),
        nodes: &nodes,
        triangles: mesh.triangles(),
        values: &shear,
        value_name: "largest shear stress (unit: Lamé's μ)".to_owned(),
        arrows: &arrows,
        arrow_name: format!("contact pressure, largest {strongest:.3}"),
        foundation,
    };
    picture.save(directory, name)
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

/// The largest 1, 2 or 5 times a power of ten not above `value` > 0.
fn one_two_five(value: f64) -> f64 {
    let decade = 10f64.powf(value.log10().floor());
    [5.0, 2.0, 1.0].into_iter().map(|m| m * decade).find(|&m| m <= value).unwrap_or(decade)
}
