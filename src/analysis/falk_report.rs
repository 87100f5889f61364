//! What is printed and drawn of the terms of Falk's lemma.

use crate::contact::Cone;
use crate::error::Result;
use crate::figures::{Axis, Chart, Series};
use crate::proof::{Exponent, FalkRow};
use crate::report::{Column, Format, Headline, Table, Verdict};
use crate::scenes::StripCase;

/// The bound of the energy norm holds up to the rounding of squared errors, about 1e-12 of the largest term.
const ROUNDING: f64 = 1e-9;

/// A term with its name.
type Term = (&'static str, fn(&FalkRow) -> f64);

const TERMS: [Term; 6] = [
    ("squared error", |r| r.error),
    ("|u - v_h|^2", |r| r.approximation),
    ("int sigma (I^h u)", |r| r.consistency),
    ("second infimum", |r| r.second_infimum),
    ("(4.8), first part", |r| r.first_part),
    ("(4.8), second part", |r| r.second_part),
];

/// Claim, table and verdict of [`crate::proof::falk_terms`].
///
/// # Errors
/// [`crate::Error::CountOutOfRange`] with fewer than three meshes.
pub fn falk_headline(case: &StripCase, rows: &[FalkRow]) -> Result<Headline> {
    let cone = case.cone;
    let claim =
        "the squared error is at most C times approximation, consistency and (midpoint cone) nonconformity";
    let worst = rows.iter().map(|r| r.constant(cone)).fold(0.0, f64::max);
    let mut headline =
        Headline::new("Falk's lemma, (4.5), (4.8)", claim, table(cone, rows), "", verdict(cone, rows));
    let name = if cone == Cone::Nodal { "nodal" } else { "midpoint" };
    headline.quote(format!("falk.{name}.constant"), worst);
    let mut words = vec![format!("measured constant at most {worst:.4} (2 by the proof in the energy norm)")];
    for (key, (title, term)) in
        ["error", "approximation", "consistency", "second", "part.one", "part.two"].iter().zip(TERMS)
    {
        let points: Vec<(f64, f64)> = rows.iter().map(|r| (1.0 / r.n as f64, term(r).abs())).collect();
        if let Ok(exponent) = Exponent::fit(&points) {
            headline.quote(format!("falk.{name}.{key}.exponent"), exponent.value);
            if cone == Cone::Midpoint || *key == "error" || *key == "consistency" {
                words.push(format!("{title} ~ h^{:.2}", exponent.value));
            }
        }
    }
    if let Some(finest) = rows.last() {
        headline.quote(format!("falk.{name}.consistency.share"), finest.consistency / finest.error);
        headline.quote(format!("falk.{name}.first.infimum"), finest.first_infimum() / finest.error);
    }
    headline.measured = words.join("; ");
    Ok(headline)
}

fn verdict(cone: Cone, rows: &[FalkRow]) -> Verdict {
    let holds = rows.iter().all(|r| {
        let second = if cone == Cone::Midpoint { r.second_infimum } else { 0.0 };
        let bound = r.approximation + 2.0 * (r.consistency + second);
        // (4.8) bounds the second infimum by its two parts; in K^h the infimum is at most 0.
        let size = r.error + r.approximation;
        let split = r.second_infimum <= r.first_part + r.second_part + ROUNDING * size;
        let sign = cone == Cone::Midpoint || r.second_infimum <= ROUNDING * size;
        r.error <= bound + ROUNDING * size && split && sign && r.second_part >= 0.0
    });
    if holds { Verdict::Holds } else { Verdict::NotConfirmed("a bound of the lemma fails".to_owned()) }
}

fn table(cone: Cone, rows: &[FalkRow]) -> Table {
    let number = Format::Scientific(2);
    let mut table = Table::new(vec![
        Column::new("n", "1/h", Format::Plain, "contact segments"),
        Column::new("error", "error^2", number, "|u - u_h|^2, energy norm"),
        Column::new(
            "approximation",
            "approx",
            number,
            "|u - v_h|^2, v_h = I^h u on the edge, least energy inside",
        ),
        Column::new("consistency", "consist", number, "int sigma_N (I^h u)_N"),
        Column::new(
            "second_infimum",
            "2nd inf",
            number,
            "inf over K of int sigma_N (v - u_h)_N = -int sigma_N u_h,N",
        ),
        Column::new("first_part", "(4.8) 1", number, "-int (sigma_N - pi sigma_N)(u_h - u)_N"),
        Column::new("second_part", "(4.8) 2", number, "-int (sigma_N - pi sigma_N) u_N"),
        Column::new("bracket", "bracket", number, "approx + consist, midpoint cone: + 2nd inf"),
        Column::new("constant", "C", Format::Fixed(4), "error^2 / bracket"),
        Column::new(
            "split_constant",
            "C split",
            Format::Fixed(4),
            "the same with both parts of (4.8) for the 2nd inf",
        ),
        Column::new(
            "first_infimum",
            "inf/err^2",
            Format::Fixed(4),
            "infimum of |u - v_h|^2 + 2 int sigma_N (v_h - u)_N, attained at u_h, over error^2",
        ),
    ]);
    for row in rows {
        table.push(vec![
            row.n.into(),
            row.error.into(),
            row.approximation.into(),
            row.consistency.into(),
            row.second_infimum.into(),
            row.first_part.into(),
            row.second_part.into(),
            row.bracket(cone).into(),
            row.constant(cone).into(),
            (row.error / row.split_bracket(cone)).into(),
            (row.first_infimum() / row.error).into(),
        ]);
    }
    table
}

/// All terms over h, absolute values.
pub fn falk_chart(case: &StripCase, rows: &[FalkRow]) -> Chart {
    let cone = if case.cone == Cone::Nodal { "nodal cone" } else { "midpoint cone" };
    let title = format!("Terms of Falk's lemma, {cone}, scene {}, τ = {}", case.source, case.tau);
    let y = Axis::logarithmic("size of the term (squared energy norm)");
    let mut chart = Chart::new(title, Axis::logarithmic("h (edge = 1)"), y);
    let names =
        ["|u − u_h|²", "|u − I^h u|²", "∫σ(I^h u)", "|∫σ u_h|", "(4.8), first part", "(4.8), second part"];
    for (name, (_, term)) in names.into_iter().zip(TERMS) {
        let points = rows.iter().map(|r| (1.0 / r.n as f64, term(r).abs()));
        chart = chart.with(Series::line_and_points(name, points.collect()));
    }
    chart
}
