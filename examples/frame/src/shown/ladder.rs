//! Tables and figures of the proof profiles: the ladder of bounds and the lines.

use crate::figures::{Axis, Chart, Series};
use crate::{Column, Format, Headline, Output, Result, Table};
use experiments::proof::{LineProfile, ProofProfile, Rung};
use signorini::proof::{Inequality, Section, Step};
use signorini::rates::ConvergenceOrder;

/// Lines drawn in the chart of slacks.
const DRAWN: usize = 6;

/// The step in words.
pub fn name(step: Step) -> &'static str {
    match step {
        Step::Term => "consistency term",
        Step::Hoelder => "Hölder's inequality",
        Step::Interpolation => "interpolation, distance to a zero",
        Step::OwnZone => "embedding, Poincaré on its own zone",
        Step::ShortestZone => "as if every zone were h_e theta",
        Step::Law => "law of the Poincaré constant",
        Step::WholeEdge => "Young, norms of the whole edge",
    }
}

/// The lines of the paper that a step is made of.
pub fn lines(section: Section, step: Step) -> &'static str {
    match (section, step) {
        (Section::Three, Step::Term) => "",
        (Section::Three, Step::Hoelder) => "(3.3), (3.11)",
        (Section::Three, Step::Interpolation) => "(3.3)-(3.5), (3.13)",
        (Section::Three, Step::OwnZone) => "(3.8), (3.12)",
        (Section::Three, Step::ShortestZone) => "(3.9), (3.12)",
        (_, Step::Law) => "(5.1), (5.2)",
        (Section::Three, Step::WholeEdge) => "(3.9), (3.14), sum",
        (Section::Four, Step::Term) => "(4.9)",
        (Section::Four, Step::Interpolation) => "(6.2), (4.6)",
        (Section::Four, Step::Hoelder | Step::OwnZone | Step::ShortestZone) => "(4.10), (4.11)",
        (Section::Four, Step::WholeEdge) => "Globally",
    }
}

/// Section, key in values, title of a chart.
pub fn title(section: Section) -> (&'static str, &'static str, &'static str) {
    match section {
        Section::Three => ("Theorem 3.1, proof", "theorem.3.1.proof", "Theorem 3.1"),
        Section::Four => ("Theorem 4.1, proof", "theorem.4.1.proof", "Theorem 4.1"),
    }
}

/// One row per rung.
pub fn ladder_table(section: Section, rungs: &[Rung]) -> Table {
    let three = Format::Fixed(3);
    let columns = vec![
        Column::words("step", "step", 38),
        Column::words("lines", "lines of the paper", 20),
        Column::new(
            "value",
            "value",
            Format::Scientific(2),
            "bound of the consistency term on the finest mesh",
        ),
        Column::new(
            "exponent",
            "exponent",
            three,
            "slope of the bound in h over the finer half of the meshes",
        ),
        Column::new("loss", "loss", three, "what the step takes from the exponent"),
        Column::new("uncertainty", "+-", three, "of the loss: scatter, or curvature over the meshes"),
        Column::new(
            "corrected",
            "corrected",
            three,
            "exponent with the law of the Poincaré constant that holds",
        ),
        Column::hidden("corrected_value"),
        Column::hidden("exponent_uncertainty"),
    ];
    let mut table = Table::new(columns);
    for rung in rungs {
        table.push(vec![
            name(rung.step).into(),
            lines(section, rung.step).into(),
            rung.finest.printed.into(),
            rung.exponent.order.into(),
            rung.loss.map(|l| l.order).into(),
            rung.loss.map(|l| l.uncertainty).into(),
            rung.corrected.order.into(),
            rung.finest.corrected.into(),
            rung.exponent.uncertainty.into(),
        ]);
    }
    table
}

/// One row per line of the proof.
pub fn line_table(lines: &[LineProfile]) -> Table {
    let four = Format::Significant(4);
    let columns = vec![
        Column::words("line", "line of the proof", 30),
        Column::new("count", "checked", Format::Plain, "segments with a positive right side, all meshes"),
        Column::new("violations", "fail", Format::Plain, "fail beyond the error of both sides"),
        Column::new("sharpest", "left/right", four, "the largest on a segment; 1 is sharp"),
        Column::new("slack", "slack", four, "right/left of the sums on the finest mesh"),
        Column::new(
            "exponent",
            "exponent",
            Format::Fixed(3),
            "of the slack in h: negative where the line loses order",
        ),
        Column::new("uncertainty", "+-", Format::Fixed(3), "its uncertainty"),
    ];
    let mut table = Table::new(columns);
    for line in lines {
        table.push(vec![
            line.line.to_string().into(),
            line.count.into(),
            line.violations.into(),
            line.sharpest.into(),
            line.slacks.last().map(|s| s.1).into(),
            line.exponent.map(|e| e.order).into(),
            line.exponent.map(|e| e.uncertainty).into(),
        ]);
    }
    table
}

/// The rungs over h: from the consistency term up to the final bound.
pub fn ladder_chart(profile: &ProofProfile, rungs: &[Rung]) -> Chart {
    let (_, _, theorem) = title(profile.case.section);
    let title = format!("{theorem}, scene {}, τ = {}", profile.case.source, profile.case.tau);
    let y = Axis::logarithmic("bound of the consistency term");
    let mut chart = Chart::new(title, Axis::logarithmic("h (edge = 1)"), y);
    for rung in rungs {
        let points: Vec<(f64, f64)> =
            profile.levels.iter().map(|l| (l.h(), l.rung(rung.step).printed)).collect();
        let name = format!("{}: {:.2}", name(rung.step), rung.exponent.order);
        chart = chart.with(match rung.step {
            Step::Term | Step::WholeEdge => Series::line_and_points(name, points),
            // Where the law of the constant costs nothing its rung lies on the one before: both must be seen.
            Step::Law => Series::dashed(name, points),
            _ => Series::line(name, points),
        });
    }
    chart
}

/// right/left over h of the lines that lose most order.
pub fn slack_chart(profile: &ProofProfile) -> Chart {
    let title = format!("The lines of the proof that lose most, τ = {}", profile.case.tau);
    let y = Axis::logarithmic("right side / left side, sums over the segments");
    let mut chart = Chart::new(title, Axis::logarithmic("h (edge = 1)"), y);
    let with_exponent = |line: LineProfile| line.exponent.map(|exponent| (exponent, line));
    let mut lines: Vec<(ConvergenceOrder, LineProfile)> =
        profile.lines().into_iter().filter_map(with_exponent).collect();
    lines.sort_by(|a, b| a.0.order.total_cmp(&b.0.order));
    for (exponent, line) in lines.into_iter().take(DRAWN) {
        let name = format!("{}: h^{:.2}", line.line, exponent.order);
        chart = chart.with(Series::line_and_points(name, line.slacks));
    }
    chart
}

/// Quotes the numbers of a ladder, and draws it and the slack of its lines as `name` and `name_slack`.
///
/// # Errors
/// Those of the drawing and of the files.
pub fn show(
    headline: &mut Headline,
    output: &Output,
    name: &str,
    profile: &ProofProfile,
    rungs: &[Rung],
) -> Result<()> {
    quote(headline, title(profile.case.section).1, profile, rungs);
    headline.draw(output, name, || Ok(ladder_chart(profile, rungs)))?;
    headline.draw(output, &format!("{name}_slack"), || Ok(slack_chart(profile)))
}

/// Quotes exponents and losses of the rungs, slacks and counts, under `key`.
pub fn quote(headline: &mut Headline, key: &str, profile: &ProofProfile, rungs: &[Rung]) {
    headline.quote(format!("{key}.printed"), profile.printed_exponent());
    for rung in rungs {
        let step = short_name(rung.step);
        headline.quote(format!("{key}.{step}.exponent"), rung.exponent.order);
        headline.quote(format!("{key}.{step}.corrected"), rung.corrected.order);
        if let Some(loss) = rung.loss {
            headline.quote(format!("{key}.{step}.loss"), loss.order);
            headline.quote(format!("{key}.{step}.uncertainty"), loss.uncertainty);
        }
    }
    for line in profile.lines() {
        let name = match line.line {
            Inequality::NormScaling => "scaling",
            Inequality::StressEmbedding => "embedding",
            Inequality::StressPoincare | Inequality::SlopePoincare => "poincare",
            _ => continue,
        };
        if let Some(exponent) = line.exponent {
            headline.quote_with(&format!("{key}.slack.{name}"), exponent.order, exponent.uncertainty);
        }
    }
    headline.quote(format!("{key}.checks"), profile.checks() as f64);
    headline.quote(format!("{key}.violations"), profile.violations() as f64);
}

/// The step in the keys of quoted values.
fn short_name(step: Step) -> &'static str {
    match step {
        Step::Term => "term",
        Step::Hoelder => "hoelder",
        Step::Interpolation => "interpolation",
        Step::OwnZone => "own",
        Step::ShortestZone => "theta",
        Step::Law => "law",
        Step::WholeEdge => "edge",
    }
}
