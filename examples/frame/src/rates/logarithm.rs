//! The studies and the outcome of (3.2), (4.3).

use signorini::cone::Cone;
use signorini::convergence::Bound;
use signorini::convergence::{LogarithmFit, NoMemory};
use signorini::convergence::{Quantity, RateStudy};
use signorini::convergence::{RateStrip, SceneFamily};
use signorini::error::{Error, Result};
use signorini::figures::{Axis, Chart, Series};
use signorini::report::{Column, Format, Headline, Table, Verdict};
use signorini::scenes::TransitionPowers;
use signorini::strip::{Levels, StripKind};

/// Powers α of the scenes: a kink outside H², and two in it.
const SCENES: [f64; 3] = [0.0, 1.0, 1.5];

/// The studies of all scenes in both cones, scene after scene, nodal first. `reference` as in [`RateStrip::new`].
///
/// # Errors
/// Those of [`RateStrip::study`].
pub fn logarithm_studies(
    levels: Levels,
    reference: usize,
    report: &mut dyn FnMut(),
) -> Result<Vec<RateStudy>> {
    let mut strip = RateStrip::new(StripKind::Scalar, levels, reference)?;
    let cell = 1.0 / levels.coarsest_cells() as f64;
    let start = (0.4 / cell).floor() * cell;
    let mut studies = Vec::new();
    for alpha in SCENES {
        let powers = TransitionPowers { opening: 1.0, pressure: 0.0, logarithm: alpha };
        let family = SceneFamily {
            name: if alpha == 0.0 { "kink".to_owned() } else { format!("|ln r|^-{alpha}") },
            tau: 2.0,
            count: 2,
            member: Box::new(move |i, cells| powers.data(start + (i + 1) as f64 / 3.0 * cell, cells)),
        };
        for cone in [Cone::Nodal, Cone::Midpoint] {
            studies.push(strip.study(&family, cone, &mut NoMemory, report)?);
        }
    }
    Ok(studies)
}

/// Table, verdict and quoted numbers.
///
/// # Errors
/// [`Error::CountOutOfRange`] for fewer than eight levels that count; as [`Bound::value`].
pub fn logarithm_headline(studies: &[RateStudy]) -> Result<Headline> {
    let three = Format::Fixed(3);
    let mut columns = vec![
        Column::new(
            "scene",
            "slopes like",
            Format::Plain,
            "kink: a jump, u in H^s for s < 2 only; the others lie in H^2",
        ),
        Column::new("cone", "cone", Format::Plain, ""),
        Column::new("expected", "1-2a", Format::Plain, "q expected for slopes like |ln r|^-a"),
        Column::new("power", "q", three, "(e/h)^2 = B + A(l^q - 1)/q, l = 2 + |ln h|"),
        Column::new("half_width", "+-", three, "what q may be off by"),
        Column::new("exponent", "needed", three, "power of |ln h| in the error: q/2, none for q <= 0"),
    ];
    for (key, title) in [("optimal", "e/h"), ("sharpened", "e/hL^1/4"), ("paper", "e/hL^1/2")] {
        columns.push(Column::new(key, title, three, "finest level that counts over the middle one"));
    }
    columns.push(Column::new("left_out", "out", Format::Plain, "levels left out"));
    let mut table = Table::new(columns);
    let mut quotes = Vec::new();
    let mut confirmed = true;
    for (k, study) in studies.iter().enumerate() {
        let alpha = SCENES[(k / 2).min(SCENES.len() - 1)];
        let points = study.points(Quantity::Error);
        let Some(fit) = LogarithmFit::of(&points) else {
            return Err(Error::CountOutOfRange {
                name: "levels that count",
                value: points.len(),
                range: "[8, inf)",
            });
        };
        let mut row: Vec<signorini::report::Cell> = vec![
            study.scene.trim_start_matches("scalar ").into(),
            study.cone.to_string().into(),
            (1.0 - 2.0 * alpha).into(),
            fit.power.into(),
            fit.half_width.into(),
            fit.exponent().into(),
        ];
        for bound in [Bound::Optimal, Bound::Sharpened, Bound::Paper] {
            let ratios = study.ratios(Quantity::Error, bound)?;
            row.push((ratios[ratios.len() - 1] / ratios[ratios.len() / 2]).into());
        }
        row.push(study.left_out().into());
        table.push(row);
        confirmed &= study.is_bounded(Quantity::Error, Bound::Paper)?;
        confirmed &= alpha < 0.5 || fit.power - fit.half_width < 0.0;
        let key = format!("equation.3.2.{}.{:.0}", study.cone, 100.0 * alpha);
        quotes.push((format!("{key}.q"), fit.power));
        quotes.push((format!("{key}.half"), fit.half_width));
    }
    let claim = "u in H^2: the error is at most C h |ln h|^(1/2); with the sharp Lemma 5.2 C h |ln h|^(1/4); proved later: C h";
    let range = studies.first().map(|study| study.points(Quantity::Error)).unwrap_or_default();
    let ends = match (range.first(), range.last()) {
        (Some(a), Some(b)) => format!("h = 2^{:.0} ... 2^{:.0}", a.0.log2(), b.0.log2()),
        _ => String::new(),
    };
    let measured = format!(
        "{ends}: in H^2 e/h is bounded and does not vanish; only the kink, outside H^2, grows like |ln h|^(1/2)"
    );
    let verdict = if confirmed {
        Verdict::HoldsLoose("the whole logarithm: in H^2 the error is of order h".to_owned())
    } else {
        Verdict::NotConfirmed("a scene in H^2 needs a power of |ln h|, or outgrows the bound".to_owned())
    };
    let mut headline = Headline::new("(3.2), (4.3)", claim, table, measured, verdict);
    quotes.into_iter().for_each(|(key, value)| headline.quote(key, value));
    Ok(headline)
}

/// e/h against h for all scenes, relative to the coarsest level.
pub fn logarithm_chart(studies: &[RateStudy]) -> Chart {
    let y = Axis::linear("error over h, relative to the coarsest level");
    let mut chart =
        Chart::new("tau = 2: does error/h grow?", Axis::logarithmic("mesh size h (edge of length 1)"), y);
    for study in studies.iter().filter(|study| study.cone == Cone::Nodal) {
        let points = study.points(Quantity::Error);
        let Some(&(h, e)) = points.first() else { continue };
        let relative = points.iter().map(|&(k, f)| (k, f / k / (e / h))).collect();
        chart = chart.with(Series::line_and_points(study.scene.trim_start_matches("scalar "), relative));
    }
    let Some(first) = studies.first() else { return chart };
    let points = first.points(Quantity::Error);
    let Some(&(coarsest, _)) = points.first() else { return chart };
    for (name, power) in [("|ln h|^1/4", 0.25), ("|ln h|^1/2", 0.5)] {
        let line = points.iter().map(|&(h, _)| (h, (h.ln() / coarsest.ln()).powf(power))).collect();
        chart = chart.with(Series::dashed(name, line));
    }
    chart
}
