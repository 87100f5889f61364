//! A rate study as table, CSV, JSON and figure.

use super::row::RateRow;
use super::store::level_json;
use crate::figures::{Axis, Chart, Series};
use crate::files::write_whole;
use crate::{Cell, Column, Format, Headline, Result, Table};
use experiments::convergence::{Quantity, RateStudy};
use serde_json::{Value, json};
use signorini::rates::Bound;
use std::fmt::Write as _;
use std::path::Path;

/// The candidate bounds and their keys.
const BOUNDS: [(Bound, &str); 4] = [
    (Bound::Earlier, "earlier"),
    (Bound::Paper, "paper"),
    (Bound::Sharpened, "sharpened"),
    (Bound::Optimal, "optimal"),
];

/// One row per level: h, unknowns, error, ratio to the level before, order, error against the bounds, contact
/// runs, seconds, and why a level is left out.
///
/// # Errors
/// As [`Bound::value`].
pub fn level_table(study: &RateStudy) -> Result<Table> {
    let four = Format::Significant(4);
    let mut table = Table::new(vec![
        Column::new("cells", "1/h", Format::Significant(7), "contact segments per unit length"),
        Column::new("unknowns", "unknowns", Format::Scientific(1), ""),
        Column::new("error", "error", Format::Scientific(4), "energy norm of u - u_h"),
        Column::new("error_ratio", "ratio", Format::Fixed(3), "error of the row above over this one"),
        Column::new("order", "order", Format::Fixed(3), "log2 of the ratio"),
        Column::hidden("over_earlier"),
        Column::new("over_paper", "e/paper", four, "error over the bound of the theorem"),
        Column::hidden("over_sharpened"),
        Column::new("over_optimal", "e/optimal", four, "error over h^(tau-1)"),
        Column::new("term", "term", Format::Scientific(2), "consistency term of the cone, a square"),
        Column::new("term_over_paper", "root/paper", four, "root of the term over the bound of the theorem"),
        Column::new("runs", "runs", Format::Significant(6), "runs of active constraints"),
        Column::hidden("kkt"),
        Column::new("seconds", "s", Format::Significant(2), ""),
        Column::new("flag", "left out", Format::Plain, "why the level counts in no fit and no bound"),
    ]);
    for (k, level) in study.levels.iter().enumerate() {
        let h = level.mesh_size();
        let ratio = k.checked_sub(1).map(|before| study.levels[before].error / level.error);
        let ratio = ratio.filter(|r| r.is_finite() && *r > 0.0);
        let over = |e: f64| BOUNDS.map(|(bound, _)| bound.value(h, study.tau).map(|b| e / b));
        let [earlier, paper, sharpened, optimal] = over(level.error);
        let root = level.consistency.map(f64::sqrt);
        let root_over_paper = root.map(|e| Bound::Paper.value(h, study.tau).map(|b| e / b)).transpose()?;
        table.push(vec![
            level.cells.into(),
            level.unknowns.into(),
            level.error.into(),
            ratio.into(),
            ratio.map(f64::log2).into(),
            earlier?.into(),
            paper?.into(),
            sharpened?.into(),
            optimal?.into(),
            level.consistency.into(),
            root_over_paper.into(),
            level.contact_runs.into(),
            level.kkt.into(),
            level.seconds.into(),
            level.flag.map_or(Cell::Missing, |flag| flag.to_string().into()),
        ]);
    }
    Ok(table)
}

/// One line per level, all digits, with a line of column names if `header`.
///
/// # Errors
/// As [`level_table`].
fn csv(study: &RateStudy, header: bool) -> Result<String> {
    let table = level_table(study)?;
    let mut text = String::new();
    if header {
        let keys: Vec<&str> = table.columns().iter().map(Column::key).collect();
        let _ = writeln!(text, "scene,cone,tau,{}", keys.join(","));
    }
    for row in table.rows() {
        let cells: Vec<String> = row
            .iter()
            .map(|cell| match cell {
                Cell::Number(value) => value.to_string(),
                Cell::Integer(value) => value.to_string(),
                Cell::Text(words) => words.clone(),
                Cell::List(_) | Cell::Missing => String::new(),
            })
            .collect();
        let _ = writeln!(text, "\"{}\",{},{},{}", study.subject, study.cone, study.tau, cells.join(","));
    }
    Ok(text)
}

/// All of it as one JSON object: scene, cone, tau, norm, fits with their uncertainty, constants, levels.
///
/// # Errors
/// As [`Bound::value`].
fn study_json(study: &RateStudy) -> Result<Value> {
    let fit = |quantity| {
        study.fit(quantity).map(|fit| {
            json!({
                "order": fit.order,
                "half_width": fit.uncertainty,
                "model": fit.model.to_string(),
                "from": fit.regime.0,
                "to": fit.regime.1,
            })
        })
    };
    let mut constants = serde_json::Map::new();
    for (bound, name) in BOUNDS {
        constants.insert(name.to_owned(), json!(study.constant(Quantity::Error, bound)?));
    }
    Ok(json!({
        "scene": study.subject.to_string(),
        "cone": study.cone.to_string(),
        "tau": study.tau,
        "norm": study.norm,
        "error_fit": fit(Quantity::Error),
        "term_fit": fit(Quantity::Consistency),
        "largest_error_over_bound": constants,
        "levels": study.levels.iter().map(level_json).collect::<Vec<_>>(),
    }))
}

/// Error and root of the consistency term against h, with the bounds through the coarsest error; one range for
/// all charts of a slider.
///
/// # Errors
/// As [`Bound::value`].
fn errors_chart(study: &RateStudy, title: impl Into<String>, (low, high): (f64, f64)) -> Result<Chart> {
    let x = Axis::logarithmic("mesh size h (edge of length 1)");
    let y = Axis::logarithmic("error in the energy norm, root of the term").range(low, high);
    let mut chart = Chart::new(title, x, y);
    let named = |what: &str| format!("{what}, {} cone", study.cone);
    chart = chart.with(Series::line_and_points(named("error"), study.points(Quantity::Error)));
    let terms: Vec<_> =
        study.points(Quantity::Consistency).into_iter().filter(|point| point.1 > 0.0).collect();
    if !terms.is_empty() {
        chart = chart.with(Series::line_and_points(named("term"), terms));
    }
    let points = study.points(Quantity::Error);
    let Some(&(coarsest, error)) = points.first() else {
        return Ok(chart);
    };
    for bound in [Bound::Earlier, Bound::Paper, Bound::Optimal] {
        let constant = error / bound.value(coarsest, study.tau)?;
        let line: Result<Vec<_>> =
            points.iter().map(|&(h, _)| Ok((h, constant * bound.value(h, study.tau)?))).collect();
        chart = chart.with(Series::dashed(bound_name(bound, study.tau)?, line?));
    }
    Ok(chart)
}

/// "h^0.6875, the theorem".
fn bound_name(bound: Bound, tau: f64) -> Result<String> {
    let exponent = bound.exponent(tau)?;
    let power = if exponent == 1.0 { "h".to_owned() } else { format!("h^{exponent:.4}") };
    let logarithm = match bound.logarithm(tau) {
        0.0 => String::new(),
        power => format!(" |ln h|^{power}"),
    };
    let whose = match bound {
        Bound::Earlier => "before the paper",
        Bound::Paper => "the theorem",
        Bound::Sharpened => "the theorem, sharpened",
        Bound::Optimal => "optimal",
    };
    Ok(format!("{power}{logarithm}, {whose}"))
}

/// All levels as CSV and all studies as JSON: `name_levels.csv` and `name_levels.json`.
///
/// # Errors
/// [`signorini::Error::File`] where they cannot be written; as [`Bound::value`].
fn write_studies(rows: &[RateRow], directory: &Path, name: &str) -> Result<()> {
    let studies = || rows.iter().map(|row| &row.study);
    let csv: Vec<String> =
        studies().enumerate().map(|(k, study)| csv(study, k == 0)).collect::<Result<_>>()?;
    let json: Vec<String> =
        studies().map(|study| Ok(study_json(study)?.to_string())).collect::<Result<_>>()?;
    for (ending, text) in [("csv", csv.concat()), ("json", format!("[{}]\n", json.join(",\n")))] {
        let path = directory.join(format!("{name}_levels.{ending}"));
        write_whole(&path, &text)?;
    }
    Ok(())
}

/// Errors and roots of terms of all studies lie between these.
fn range<'a>(studies: impl Iterator<Item = &'a RateStudy>) -> (f64, f64) {
    let points = studies.flat_map(|s| [s.points(Quantity::Error), s.points(Quantity::Consistency)]).flatten();
    let sizes = points.map(|point| point.1).filter(|&size| size > 0.0);
    let (low, high) = sizes.fold((f64::MAX, 0.0f64), |(low, high), size| (low.min(size), high.max(size)));
    if low <= high { (low / 1.5, high * 1.5) } else { (0.1, 1.0) }
}

/// Where figures are asked for: all levels in files, and a chart of the first scene for each of its τ, as
/// `NAME_errors_TAU`.
///
/// # Errors
/// Those of the files and the drawing; as [`Bound::value`].
pub fn write_and_draw(headline: &mut Headline, rows: &[RateRow], directory: &Path, name: &str) -> Result<()> {
    write_studies(rows, directory, name)?;
    let Some(first) = rows.first() else { return Ok(()) };
    let shown: Vec<&RateRow> = rows.iter().filter(|row| row.study.subject == first.study.subject).collect();
    let range = range(shown.iter().map(|row| &row.study));
    for row in shown {
        let chart = errors_chart(&row.study, format!("{}: {}", headline.label, row.words()), range)?;
        headline.figures.push(chart.save(directory, &format!("{name}_errors_{}", row.study.tau))?);
    }
    Ok(())
}
