//! What the rate studies of Theorems 3.1 and 4.1 share: options, the resumable run, files.

mod figure;
mod introduction;
mod listing;
mod logarithm;
mod store;
mod theorem;

use crate::{HasOutput, Output, progress};
use clap::Parser;
pub use figure::{FigureRates, figure_chart, figure_headline};
pub use introduction::{introduction_chart, introduction_headline, introduction_rows, introduction_studies};
use listing::{csv, errors_chart, level_table, study_json};
pub use logarithm::{logarithm_chart, logarithm_headline, logarithm_studies};
use signorini::contact::Cone;
use signorini::convergence::{MeshRates, NoMemory, Quantity, RateStrip, RateStudy, SceneFamily};
use signorini::report::{Headline, Verdict};
use signorini::scenes::{Scene, Setting};
use signorini::strip::{Levels, StripKind};
use signorini::{Error, Result};
use std::path::Path;
pub use store::LevelStore;
pub use theorem::{TheoremPlan, theorem_headline};

/// Errors and consistency terms against h for many regularities; with --scene one scene level by level
#[derive(Debug, Clone, Parser)]
pub struct RateOptions {
    /// One scene, level by level
    #[arg(long, help = format!("One scene, level by level: {}", Scene::names()))]
    pub scene: Option<Scene>,
    /// Regularities (default: 1.55 to 1.95, 2, 2.1)
    #[arg(long, value_delimiter = ',', value_parser = regularity)]
    pub tau: Vec<f64>,
    /// Strip of --scene: scalar or elastic
    #[arg(long, default_value_t = StripKind::Scalar)]
    pub kind: StripKind,
    /// Levels of --scene: n = 2^level cells along the edge
    #[arg(long, default_value = "3-12")]
    pub levels: Levels,
    /// Positions of a single transition in its cell over which --scene averages
    #[arg(long, default_value_t = 7)]
    pub positions: usize,
    /// The study of the book: minutes; finished levels are kept in a file under --out and not computed again
    #[arg(long)]
    pub full: bool,
    /// Where the outcome goes
    #[command(flatten)]
    pub output: Output,
}

fn regularity(text: &str) -> Result<f64> {
    let unknown =
        || Error::UnknownName { what: "tau", given: text.to_owned(), expected: "a number in (3/2, 5/2]" };
    let tau: f64 = text.parse().map_err(|_| unknown())?;
    Error::require("tau", tau, "(3/2, 5/2]", tau > 1.5 && tau <= 2.5)
}

impl Default for RateOptions {
    fn default() -> Self {
        Self::parse_from(["rates"])
    }
}

impl HasOutput for RateOptions {
    fn output(&self) -> &Output {
        &self.output
    }
}

/// The study of Theorem 3.1 (nodal cone) or 4.1 (midpoint cone).
///
/// # Errors
/// Those of the studies and of files.
pub fn rates(cone: Cone, options: &RateOptions) -> Result<Headline> {
    let name = if cone == Cone::Nodal { "theorem_3_1" } else { "theorem_4_1" };
    if let Some(scene) = &options.scene {
        return one_scene(cone, name, scene, options);
    }
    let mut plan = if options.full { TheoremPlan::full()? } else { TheoremPlan::short()? };
    if !options.tau.is_empty() {
        plan = plan.with_taus(&options.tau);
        if plan.steps() == 0 {
            return Err(Error::UnknownName {
                what: "tau",
                given: format!("{:?}", options.tau),
                expected: "1.55, 1.65, ..., 1.95, 2 or 2.1; with --scene any in (3/2, 5/2]",
            });
        }
    }
    let directory = options.output.directory()?;
    let mut store = match directory {
        Some(directory) if options.full => LevelStore::open(&directory.join(format!("{name}_levels.jsonl")))?,
        _ => LevelStore::in_memory(),
    };
    let known = store.len();
    let bar = progress(plan.steps());
    let studies = plan.run(cone, &mut store, &mut || bar.inc(1))?;
    bar.finish_and_clear();
    let mut headline = theorem_headline(cone, &studies)?;
    if known > 0 {
        headline.measured += &format!("; {known} levels taken from an earlier run");
    }
    if let Some(directory) = directory {
        write_studies(&studies, directory, name)?;
        if let Some(study) = studies.iter().find(|study| study.tau == 1.75 && study.norm.is_some()) {
            let other = other_cone(cone, &plan, &mut store)?;
            let chart = errors_chart(study, &[&other], format!("{}, tau = 7/4, both cones", headline.label))?;
            headline.figures.push(chart.save(directory, &format!("{name}_errors"))?);
        }
    }
    Ok(headline)
}

/// The first case of the plan at τ = 7/4 in the other cone, to stand in the same figure.
fn other_cone(cone: Cone, plan: &TheoremPlan, store: &mut LevelStore) -> Result<RateStudy> {
    let mut first = plan.clone().with_taus(&[1.75]);
    first.strips.truncate(1);
    first.strips.iter_mut().for_each(|group| group.cases.truncate(1));
    first.corners.clear();
    let other = if cone == Cone::Nodal { Cone::Midpoint } else { Cone::Nodal };
    Ok(first.run(other, store, &mut || ())?.remove(0))
}

/// One scene level by level.
fn one_scene(cone: Cone, name: &str, scene: &Scene, options: &RateOptions) -> Result<Headline> {
    let tau = options.tau.first().copied().unwrap_or(1.75);
    let count = options.levels.cells().count();
    let study = match scene {
        Scene::Strip(source) => {
            let finest = options.levels.cells().max().unwrap_or(2);
            let mut strip = RateStrip::new(options.kind, options.levels, (32 * finest).min(1 << 22))?;
            let coarsest = options.levels.coarsest_cells();
            let family = SceneFamily::named(source, tau, options.kind, coarsest, options.positions)?;
            let bar = progress((count * family.count) as u64);
            let study = strip.study(&family, cone, &mut NoMemory, &mut || bar.inc(1))?;
            bar.finish_and_clear();
            study
        }
        Scene::Mesh(scene) => {
            let coarsest = options.levels.coarsest_cells();
            let rates = MeshRates {
                scene: *scene,
                setting: Setting::default(),
                constant_load: false,
                coarsest,
                levels: count,
            };
            rates.study(&[cone])?.remove(0)
        }
    };
    let mut headline = theorem_headline(cone, std::slice::from_ref(&study))?;
    let Some(fit) = study.fit(Quantity::Error) else {
        return Err(Error::CountOutOfRange {
            name: "levels that count",
            value: count - study.left_out(),
            range: "[5, inf)",
        });
    };
    headline.table = level_table(&study)?;
    headline.claim = format!("{}, {}", study.scene, headline.claim);
    headline.measured = format!("order {fit}; {} levels left out", study.left_out());
    if headline.verdict.is_confirmed() {
        headline.verdict = Verdict::HoldsLoose(format!(
            "what lies between the bound and the order {:.3} +- {:.3}",
            fit.order, fit.half_width
        ));
    }
    if let Some(directory) = options.output.directory()? {
        write_studies(std::slice::from_ref(&study), directory, name)?;
        let chart = errors_chart(&study, &[], format!("{}, {cone} cone", study.scene))?;
        headline.figures.push(chart.save(directory, &format!("{name}_errors"))?);
    }
    Ok(headline)
}

/// All levels as CSV and all studies as JSON.
fn write_studies(studies: &[RateStudy], directory: &Path, name: &str) -> Result<()> {
    let csv: Vec<String> =
        studies.iter().enumerate().map(|(k, study)| csv(study, k == 0)).collect::<Result<_>>()?;
    let json: Vec<String> =
        studies.iter().map(|study| Ok(study_json(study)?.to_string())).collect::<Result<_>>()?;
    for (ending, text) in [("csv", csv.concat()), ("json", format!("[{}]\n", json.join(",\n")))] {
        let path = directory.join(format!("{name}_levels.{ending}"));
        std::fs::write(&path, text).map_err(|e| Error::file(&path, e))?;
    }
    Ok(())
}
