//! The case τ = 2, (3.2) and (4.3): which power of |ln h| does the error need?
//!
//! Scenes: one transition whose slopes behave like |ln r|^{−α} ([`TransitionPowers`]); in H² exactly for α > 1/2. The cells at distance r
//! from the transition add up to e² ≈ h² ∫_h ℓ(r)^{−2α} dr/r = h² (c ± ℓ(h)^{1−2α}), ℓ(r) = 2 + |ln r|, so the model is
//!
//! e²/h² = B + A (ℓ^q − 1)/q,  ℓ = ℓ(h),  q = 1 − 2α.
//!
//! q ≤ 0: e/h is bounded, the bound h holds and is met; q > 0: e ~ h |ln h|^{q/2}. B, A and q by relative least squares on several windows of
//! levels; the half-width is twice the largest difference between them. Transitions at one and two thirds of a cell are averaged: doubling exchanges the two,
//! so that the mean has no phase at all.

use super::bounds::Bound;
use super::store::LevelStore;
use super::strip_rates::{RateStrip, SceneFamily};
use super::study::{Quantity, RateStudy};
use crate::contact::Cone;
use crate::error::{Error, Result};
use crate::figures::{Axis, Chart, Series};
use crate::report::{Column, Format, Headline, Table, Verdict};
use crate::scenes::TransitionPowers;
use crate::strip::{Levels, StripKind};

/// q of e²/h² = B + A (ℓ^q − 1)/q with its half-width, ℓ = 2 + |ln h|.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LogarithmFit {
    /// q.
    pub power: f64,
    /// What q may be off by.
    pub half_width: f64,
}

impl LogarithmFit {
    /// From (h, e), coarsest first; `None` for fewer than eight levels or an error that is not positive.
    pub fn of(points: &[(f64, f64)]) -> Option<Self> {
        let count = points.len();
        if count < 8 || !points.iter().all(|&(h, e)| h > 0.0 && h < 1.0 && e > 0.0 && e.is_finite()) {
            return None;
        }
        let first = (count / 4).min(count - 7);
        let windows = [(first, count), (first + 1, count), (first + 2, count), (first, count - 1)];
        let powers: Vec<f64> = windows.iter().map(|&(a, b)| best_power(&points[a..b])).collect();
        let half_width = 2.0 * powers.iter().fold(0.0, |w: f64, q| w.max((q - powers[0]).abs()));
        Some(Self { power: powers[0], half_width })
    }

    /// The power of |ln h| in the error that follows: q/2, or none for q ≤ 0.
    pub fn exponent(&self) -> f64 {
        0.5 * self.power.max(0.0)
    }
}

/// Powers q tried.
const RANGE: (f64, f64) = (-4.0, 2.0);

fn best_power(points: &[(f64, f64)]) -> f64 {
    const STEPS: usize = 120;
    let at = |k: usize| RANGE.0 + (RANGE.1 - RANGE.0) * k as f64 / STEPS as f64;
    let best =
        (0..=STEPS).min_by(|&a, &b| misfit(points, at(a)).total_cmp(&misfit(points, at(b)))).unwrap_or(STEPS);
    let (mut a, mut b) = (at(best.saturating_sub(1)), at((best + 1).min(STEPS)));
    let ratio = 0.5 * (5f64.sqrt() - 1.0);
    while b - a > 1e-6 {
        let (c, d) = (b - ratio * (b - a), a + ratio * (b - a));
        if misfit(points, c) < misfit(points, d) { b = d } else { a = c }
    }
    0.5 * (a + b)
}

/// Smallest Σ (model/e² − 1)² over B and A.
fn misfit(points: &[(f64, f64)], q: f64) -> f64 {
    let rows = points.iter().map(|&(h, e)| {
        let (size, log) = (h * h / (e * e), (2.0 + h.ln().abs()).ln());
        // (ℓ^q − 1)/q, ln ℓ at q = 0.
        let grown = if q == 0.0 { log } else { (q * log).exp_m1() / q };
        (size, size * grown)
    });
    let [mut uu, mut uv, mut vv, mut u1, mut v1] = [0.0; 5];
    for (u, v) in rows.clone() {
        uu += u * u;
        uv += u * v;
        vv += v * v;
        u1 += u;
        v1 += v;
    }
    let determinant = uu * vv - uv * uv;
    if determinant <= 1e-12 * uu * vv {
        return f64::INFINITY;
    }
    let (b, a) = ((vv * u1 - uv * v1) / determinant, (uu * v1 - uv * u1) / determinant);
    rows.map(|(u, v)| (b * u + a * v - 1.0).powi(2)).sum()
}

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
            member: Box::new(move |i, cells| powers.scene(start + (i + 1) as f64 / 3.0 * cell, cells)),
        };
        for cone in [Cone::Nodal, Cone::Midpoint] {
            studies.push(strip.study(&family, cone, &mut LevelStore::in_memory(), report)?);
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
        let mut row: Vec<crate::report::Cell> = vec![
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn powers_of_the_logarithm_are_told_apart() {
        let levels = |e: &dyn Fn(f64) -> f64| -> Vec<(f64, f64)> {
            (3..17).map(|k| 0.5f64.powi(k)).map(|h| (h, e(h))).collect()
        };
        for (q, b) in [(1.0, 3.0), (-0.5, 2.0), (-2.0, 1.0)] {
            let points = levels(&|h: f64| h * (b + 0.3 * (2.0 + h.ln().abs()).powf(q)).sqrt());
            let fit = LogarithmFit::of(&points).unwrap();
            assert!((fit.power - q).abs() < 1e-3 && fit.half_width < 1e-2, "{q}: {fit:?}");
        }
        assert!(LogarithmFit::of(&levels(&|h| h)[..5]).is_none());
    }
}
