//! The experiment behind Theorems 3.1 and 4.1: many regularities τ, scenes on strips and corners on meshes, one cone.
//!
//! On strips the exact solution is known, and with it error and consistency term; one transition is averaged over its place in the
//! cell. Corners between a Dirichlet side and the contact edge, opened to ω, have u ~ r^{π/(2ω)} and τ = 1 + π/(2ω): 7/4 at 120
//! degrees. Fat Cantor sets repeat themselves after a factor 2^{1/(4−2τ)} in h, so that only τ ≤ 1.8 shows several periods. At corners f = −1 is constant and u < 0 by the maximum principle: the contact edge is free, the corner is all there is.

use signorini::cone::Cone;
use signorini::convergence::Bound;
use signorini::convergence::Fit;
use signorini::convergence::LevelMemory;
use signorini::convergence::MeshRates;
use signorini::convergence::{Quantity, RateStudy};
use signorini::convergence::{RateStrip, SceneFamily};
use signorini::error::Result;
use signorini::report::{Cell, Column, Format, Headline, Table, Verdict};
use signorini::scenes::StripScene;
use signorini::scenes::{MeshScene, Setting};
use signorini::strip::{Levels, StripKind};

/// Scenes on one strip: its levels, its reference grid, and each scene with its τ.
#[derive(Debug, Clone)]
pub struct StripGroup {
    /// Which strip.
    pub kind: StripKind,
    /// The levels.
    pub levels: Levels,
    /// The reference grid has 2 to this power cells.
    pub reference: u32,
    /// Scene, τ, positions of a single transition.
    pub cases: Vec<(StripScene, f64, usize)>,
}

/// What to study.
#[derive(Debug, Clone)]
pub struct TheoremPlan {
    /// Scenes on strips.
    pub strips: Vec<StripGroup>,
    /// Openings ω in degrees.
    pub corners: Vec<f64>,
    /// Squares along each side of the coarsest mesh of a corner, and the number of meshes.
    pub meshes: (usize, usize),
}

/// Openings of the corners: 120 degrees is τ = 7/4.
const CORNERS: [f64; 4] = [100.0, 120.0, 135.0, 150.0];
/// Many transitions: 22 of them, none at a node of a dyadic mesh.
const GAPS: usize = 11;

impl TheoremPlan {
    /// Some seconds of work: one transition, `many` transitions, fat Cantor sets, corners.
    ///
    /// # Errors
    /// None for these values.
    pub fn short() -> Result<Self> {
        let five = [1.55, 1.65, 1.75, 1.85, 1.95];
        let all: Vec<f64> = five.into_iter().chain([2.0, 2.1]).collect();
        Ok(Self {
            strips: vec![
                group(StripKind::Scalar, (3, 12), 17, &transition(&all, 7))?,
                group(StripKind::Elastic, (3, 12), 17, &transition(&[1.55, 1.75, 1.95], 5))?,
                group(
                    StripKind::Scalar,
                    (6, 14),
                    18,
                    &[many(&five), fat_cantor(&[1.55, 1.65, 1.75])].concat(),
                )?,
            ],
            corners: CORNERS.to_vec(),
            meshes: (3, 7),
        })
    }

    /// The study of the book: minutes.
    ///
    /// # Errors
    /// None for these values.
    pub fn full() -> Result<Self> {
        let nine: Vec<f64> =
            (0..9).map(|k| 1.55 + 0.05 * f64::from(k)).map(|t| (t * 100.0).round() / 100.0).collect();
        let all: Vec<f64> = nine.iter().copied().chain([2.0, 2.1]).collect();
        let rough = [many(&all), fat_cantor(&nine[..6])].concat();
        Ok(Self {
            strips: vec![
                group(StripKind::Scalar, (3, 16), 20, &transition(&all, 5))?,
                group(StripKind::Elastic, (3, 16), 20, &transition(&all, 5))?,
                group(StripKind::Scalar, (6, 16), 20, &rough)?,
                group(StripKind::Elastic, (6, 16), 20, &rough)?,
            ],
            corners: CORNERS.to_vec(),
            meshes: (4, 8),
        })
    }

    /// Only these regularities (corners have their own and stay only where theirs is among them).
    #[must_use]
    pub fn with_taus(mut self, taus: &[f64]) -> Self {
        for group in &mut self.strips {
            group.cases.retain(|case| taus.contains(&case.1));
        }
        self.strips.retain(|group| !group.cases.is_empty());
        self.corners.retain(|angle| taus.iter().any(|tau| (1.0 + 90.0 / angle - tau).abs() < 1e-3));
        self
    }

    /// Steps of a progress bar: levels of strips at all positions, and corners.
    pub fn steps(&self) -> u64 {
        let strips = self
            .strips
            .iter()
            .map(|group| group.levels.cells().count() * group.cases.iter().map(|case| case.2).sum::<usize>());
        (strips.sum::<usize>() + self.corners.len()) as u64
    }

    /// All studies in one cone; finished levels of strips are taken from the store.
    ///
    /// # Errors
    /// Those of [`RateStrip::study`] and [`MeshRates::study`].
    pub fn run(
        &self,
        cone: Cone,
        store: &mut dyn LevelMemory,
        report: &mut dyn FnMut(),
    ) -> Result<Vec<RateStudy>> {
        let mut studies = Vec::new();
        for group in &self.strips {
            let mut strip = RateStrip::new(group.kind, group.levels, 1 << group.reference)?;
            for (source, tau, positions) in &group.cases {
                let coarsest = group.levels.coarsest_cells();
                let family = SceneFamily::named(source, *tau, group.kind, coarsest, *positions)?;
                studies.push(strip.study(&family, cone, store, report)?);
            }
        }
        for &angle in &self.corners {
            let (coarsest, levels) = self.meshes;
            let setting = Setting { angle, ..Setting::default() };
            let corner =
                MeshRates { scene: MeshScene::Corner, setting, constant_load: true, coarsest, levels };
            studies.extend(corner.study(&[cone])?);
            report();
        }
        Ok(studies)
    }
}

type Cases = Vec<(StripScene, f64, usize)>;

fn group(
    kind: StripKind,
    (from, to): (u32, u32),
    reference: u32,
    cases: &[(StripScene, f64, usize)],
) -> Result<StripGroup> {
    Ok(StripGroup { kind, levels: Levels::new(from, to)?, reference, cases: cases.to_vec() })
}

fn transition(taus: &[f64], positions: usize) -> Cases {
    taus.iter().map(|&tau| (StripScene::transition(), tau, positions)).collect()
}

fn many(taus: &[f64]) -> Cases {
    taus.iter().map(|&tau| (StripScene::Transitions { gaps: GAPS }, tau, 1)).collect()
}

fn fat_cantor(taus: &[f64]) -> Cases {
    taus.iter().map(|&tau| (StripScene::FatCantor { depth: 30 }, tau, 1)).collect()
}

/// Table, verdict and quoted numbers of a set of studies in one cone.
///
/// # Errors
/// As [`Bound::value`].
pub fn theorem_headline(cone: Cone, studies: &[RateStudy]) -> Result<Headline> {
    let number = if cone == Cone::Nodal { "3.1" } else { "4.1" };
    let mut table = Table::new(columns());
    let mut unbounded = Vec::new();
    let (mut furthest, mut least) = (0.0f64, f64::INFINITY);
    let mut quotes = Vec::new();
    for study in studies {
        table.push(row(study)?);
        for quantity in [Quantity::Error, Quantity::Consistency] {
            if !study.is_bounded(quantity, Bound::Paper)? {
                unbounded.push(format!("{} at tau = {:.3}", study.scene, study.tau));
            }
        }
        let Some(fit) = study.fit(Quantity::Error) else { continue };
        let optimal = Bound::Optimal.exponent(study.tau)?;
        if study.tau < 2.0 {
            least = least.min(fit.order - Bound::Paper.exponent(study.tau)?);
            if !study.scene.contains("cantor") {
                furthest = furthest.max((fit.order - optimal).abs());
            }
        }
        let key = format!("theorem.{number}.{}.{:.0}", key_words(&study.scene), 100.0 * study.tau);
        quotes.push((format!("{key}.order"), fit.order));
        quotes.push((format!("{key}.half"), fit.half_width));
        quotes.push((format!("{key}.ratio"), study.constant(Quantity::Error, Bound::Paper)?));
    }
    let claim = format!(
        "u in H^tau, 3/2 < tau < 2: the error of the {cone} cone is at most C h^(tau^2-5tau/2+2); tau = 2: C h |ln h|^(1/2)"
    );
    let measured = format!(
        "3/2 < tau < 2: orders within {furthest:.3} of tau - 1 (fat Cantor sets apart), at least {least:.3} above the theorem's exponent"
    );
    let verdict = if unbounded.is_empty() {
        Verdict::HoldsLoose(format!("h^{least:.2} and more: every scene with tau < 2 has the optimal order"))
    } else {
        Verdict::NotConfirmed(format!("error/bound grows: {}", unbounded.join(", ")))
    };
    let mut headline = Headline::new(format!("Theorem {number}"), claim, table, measured, verdict);
    headline.quote(format!("theorem.{number}.furthest.from.optimal"), furthest);
    headline.quote(format!("theorem.{number}.least.above.paper"), least);
    quotes.into_iter().for_each(|(key, value)| headline.quote(key, value));
    Ok(headline)
}

/// "scalar.transition", "corner.120": the first words of a scene and the angle of a corner.
fn key_words(scene: &str) -> String {
    let words = scene.split([' ', ':', ',']).filter(|word| !word.is_empty());
    words.take(2).collect::<Vec<_>>().join(".")
}

fn columns() -> Vec<Column> {
    let three = Format::Fixed(3);
    let two = Format::Significant(3);
    vec![
        Column::new("scene", "scene", Format::Plain, ""),
        Column::new("tau", "tau", Format::Significant(4), "supremum of the tau with u in H^tau"),
        Column::new("order", "order", three, "of the error in h"),
        Column::new("half_width", "+-", three, "what the order may be off by"),
        Column::new(
            "model",
            "orders",
            Format::Plain,
            "which orders were told apart: p alone, beside the smooth part 1, beside 1 and 3/2",
        ),
        Column::hidden("optimal"),
        Column::new("paper", "paper", three, "exponent of the theorem"),
        Column::new("beaten", "beaten", three, "order less exponent of the theorem"),
        Column::new("ratio", "e/bound", two, "largest error over the bound of the theorem, C = 1"),
        Column::new(
            "constant",
            "C",
            Format::Significant(2),
            "the same over the norms of u_N and sigma_N on the edge",
        ),
        Column::new("term_order", "term", three, "order of the root of the consistency term"),
        Column::new("term_half_width", "+-", three, ""),
        Column::new("term_ratio", "t/bound", two, "largest root of the term over the bound"),
        Column::new(
            "left_out",
            "out",
            Format::Plain,
            "levels left out: not converged, digits lost, near the reference",
        ),
    ]
}

fn row(study: &RateStudy) -> Result<Vec<Cell>> {
    let (error, term) = (study.fit(Quantity::Error), study.fit(Quantity::Consistency));
    let paper = Bound::Paper.exponent(study.tau)?;
    let ratio = study.constant(Quantity::Error, Bound::Paper)?;
    let term_ratio = study.constant(Quantity::Consistency, Bound::Paper)?;
    Ok(vec![
        short_name(&study.scene).into(),
        study.tau.into(),
        error.map(|fit| fit.order).into(),
        error.map(|fit| fit.half_width).into(),
        error.map_or(Cell::Missing, |fit: Fit| fit.model.to_string().into()),
        Bound::Optimal.exponent(study.tau)?.into(),
        paper.into(),
        error.map(|fit| fit.order - paper).into(),
        ratio.into(),
        study.norm.map(|norm| ratio / norm).into(),
        term.map(|fit| fit.order).into(),
        term.map(|fit| fit.half_width).into(),
        (term_ratio > 0.0).then_some(term_ratio).into(),
        study.left_out().into(),
    ])
}

/// Without the numbers behind the name of a scene on a strip.
fn short_name(scene: &str) -> String {
    scene.split(':').next().unwrap_or(scene).to_owned()
}
