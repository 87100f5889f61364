//! What is printed and drawn of a profile.

use crate::error::Result;
use crate::figures::{Axis, Chart, Series};
use crate::proof::{Line, LineProfile, ProofProfile, Rung, Section, Step};
use crate::report::{Column, Format, Headline, Table, Verdict};
use std::path::Path;

/// Lines whose slack is quoted, and under which name.
const LOSING: [(Line, &str); 4] = [
    (Line::NormScaling, "scaling"),
    (Line::StressPoincare, "poincare"),
    (Line::StressEmbedding, "embedding"),
    (Line::SlopePoincare, "poincare"),
];

/// Lines drawn in the chart of slacks.
const DRAWN: usize = 6;

fn name(step: Step) -> &'static str {
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

fn lines(section: Section, step: Step) -> &'static str {
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

impl ProofProfile {
    /// Claim, the ladder as table (`lines`: the inequalities instead), figures saved as `name` and `name_slack`.
    ///
    /// # Errors
    /// As [`ProofProfile::ladder`]; those of writing the figures.
    pub fn headline(&self, directory: Option<&Path>, name: &str, lines: bool) -> Result<Headline> {
        let (label, key) = match self.case.section {
            Section::Three => ("Theorem 3.1, proof", "theorem.3.1.proof"),
            Section::Four => ("Theorem 4.1, proof", "theorem.4.1.proof"),
        };
        let claim = "every line of the proof holds with its explicit constant; a ladder shows which line loses the order";
        let rungs = self.ladder()?;
        let table = if lines { self.line_table()? } else { self.ladder_table(&rungs) };
        let mut headline = Headline::new(label, claim, table, self.words(&rungs), self.verdict(&rungs));
        self.quote(&mut headline, key, &rungs);
        if let Some(directory) = directory {
            headline.figures.push(self.ladder_chart(&rungs).save(directory, name)?);
            headline.figures.push(self.slack_chart().save(directory, &format!("{name}_slack"))?);
        }
        Ok(headline)
    }

    fn quote(&self, headline: &mut Headline, key: &str, rungs: &[Rung]) {
        headline.quote(format!("{key}.printed"), self.printed_exponent());
        let keys = ["term", "hoelder", "interpolation", "own", "theta", "law", "edge"];
        for (rung, step) in rungs.iter().zip(keys) {
            headline.quote(format!("{key}.{step}.exponent"), rung.exponent.value);
            headline.quote(format!("{key}.{step}.corrected"), rung.corrected.value);
            if let Some(loss) = rung.loss {
                headline.quote(format!("{key}.{step}.loss"), loss.value);
                headline.quote(format!("{key}.{step}.uncertainty"), loss.uncertainty);
            }
        }
        for line in self.lines() {
            let named = LOSING.into_iter().find(|(label, _)| *label == line.line);
            if let (Some((_, name)), Some(exponent)) = (named, line.exponent) {
                headline.quote(format!("{key}.slack.{name}"), exponent.value);
                headline.quote(format!("{key}.slack.{name}.uncertainty"), exponent.uncertainty);
            }
        }
        headline.quote(format!("{key}.checks"), self.checks() as f64);
        headline.quote(format!("{key}.violations"), self.violations() as f64);
    }

    fn verdict(&self, rungs: &[Rung]) -> Verdict {
        let failed = self.violations();
        let missed: usize = self.levels.iter().map(|l| l.cases.neither).sum();
        if failed > 0 || missed > 0 {
            return Verdict::NotConfirmed(format!(
                "{failed} inequalities fail, {missed} segments are in neither case"
            ));
        }
        let (first, last) = (&rungs[0], &rungs[rungs.len() - 1]);
        let lost = first.exponent.value - last.exponent.value;
        if lost < 0.0 {
            return Verdict::Holds; // the bound falls faster here than its limit law: meshes too coarse, or a rougher scene
        }
        Verdict::HoldsLoose(format!("{lost:.3} in the exponent of the squared error on this scene"))
    }

    /// Which rungs lose the order, in words.
    fn words(&self, rungs: &[Rung]) -> String {
        let (first, last) = (&rungs[0], &rungs[rungs.len() - 1]);
        let largest = rungs
            .iter()
            .filter_map(|r| r.loss.map(|loss| (name(r.step), loss)))
            .max_by(|a, b| a.1.value.total_cmp(&b.1.value));
        let (name, loss) = largest.unwrap_or(("", first.exponent));
        let missed = 2.0 * self.case.tau - 2.0 - self.printed_exponent();
        format!(
            "{} inequalities checked, {} fail; the term falls like h^{:.3}, the bound like h^{:.3} (printed {:.3}); most is \
             lost at \"{name}\": {:.3} ± {:.3}; the printed exponent is {missed:.3} below the optimal one, {:.4} in the error",
            self.checks(),
            self.violations(),
            first.exponent.value,
            last.exponent.value,
            self.printed_exponent(),
            loss.value,
            loss.uncertainty,
            0.5 * missed,
        )
    }

    fn ladder_table(&self, rungs: &[Rung]) -> Table {
        let mut table = Table::new(vec![
            Column::words("step", "step", 38),
            Column::words("lines", "lines of the paper", 20),
            Column::new(
                "value",
                "value",
                Format::Scientific(2),
                "bound of the consistency term on the finest mesh",
            ),
            Column::new("exponent", "exponent", Format::Fixed(3), "slope of the bound in h over all meshes"),
            Column::new("loss", "loss", Format::Fixed(3), "what the step takes from the exponent"),
            Column::new(
                "uncertainty",
                "+-",
                Format::Fixed(3),
                "uncertainty of the loss: scatter or curvature",
            ),
            Column::new(
                "corrected",
                "corrected",
                Format::Fixed(3),
                "exponent with the law of the Poincaré constant that holds: square root of the logarithm at tau = 2",
            ),
            Column::hidden("corrected_value"),
            Column::hidden("exponent_uncertainty"),
        ]);
        for rung in rungs {
            table.push(vec![
                name(rung.step).into(),
                lines(self.case.section, rung.step).into(),
                rung.finest.printed.into(),
                rung.exponent.value.into(),
                rung.loss.map(|l| l.value).into(),
                rung.loss.map(|l| l.uncertainty).into(),
                rung.corrected.value.into(),
                rung.finest.corrected.into(),
                rung.exponent.uncertainty.into(),
            ]);
        }
        table
    }

    /// One row per inequality.
    ///
    /// # Errors
    /// None in practice.
    pub fn line_table(&self) -> Result<Table> {
        let mut table = Table::new(vec![
            Column::words("line", "line of the proof", 30),
            Column::new("count", "checked", Format::Plain, "segments with a positive right side, all meshes"),
            Column::new("violations", "fail", Format::Plain, "fail beyond the error of both sides"),
            Column::new(
                "sharpest",
                "left/right",
                Format::Significant(4),
                "the largest on a segment; 1 is sharp",
            ),
            Column::new(
                "slack",
                "slack",
                Format::Significant(4),
                "right/left of the sums on the finest mesh",
            ),
            Column::new(
                "exponent",
                "exponent",
                Format::Fixed(3),
                "of the slack in h: negative where the line loses order",
            ),
            Column::new("uncertainty", "+-", Format::Fixed(3), "its uncertainty"),
        ]);
        for line in self.lines() {
            table.push(vec![
                line.line.to_string().into(),
                line.count.into(),
                line.violations.into(),
                line.sharpest.into(),
                line.slacks.last().map(|s| s.1).into(),
                line.exponent.map(|e| e.value).into(),
                line.exponent.map(|e| e.uncertainty).into(),
            ]);
        }
        Ok(table)
    }

    /// The rungs over h: from the consistency term up to the final bound.
    pub fn ladder_chart(&self, rungs: &[Rung]) -> Chart {
        let theorem = if self.case.section == Section::Three { "Theorem 3.1" } else { "Theorem 4.1" };
        let title = format!("{theorem}, scene {}, τ = {}", self.case.source, self.case.tau);
        let x = Axis::logarithmic("h (edge = 1)");
        let mut chart = Chart::new(title, x, Axis::logarithmic("bound of the consistency term"));
        let last = rungs.len() - 1;
        for (k, rung) in rungs.iter().enumerate() {
            let points: Vec<(f64, f64)> =
                self.levels.iter().map(|l| (l.h(), l.rung(rung.step).printed)).collect();
            let name = format!("{}: {:.2}", name(rung.step), rung.exponent.value);
            let series = if k == 0 || k == last {
                Series::line_and_points(name, points)
            } else {
                // Where the law of the constant costs nothing its rung lies on the one before: both must be seen.
                if rung.step == Step::Law { Series::dashed(name, points) } else { Series::line(name, points) }
            };
            chart = chart.with(series);
        }
        chart
    }

    /// right/left over h of the lines that lose most order.
    pub fn slack_chart(&self) -> Chart {
        let title = format!("The lines of the proof that lose most, τ = {}", self.case.tau);
        let y = Axis::logarithmic("right side / left side, sums over the segments");
        let mut chart = Chart::new(title, Axis::logarithmic("h (edge = 1)"), y);
        let mut lines: Vec<(f64, LineProfile)> =
            self.lines().into_iter().filter_map(|line| line.exponent.map(|e| (e.value, line))).collect();
        lines.sort_by(|a, b| a.0.total_cmp(&b.0));
        for (exponent, line) in lines.into_iter().take(DRAWN) {
            let name = format!("{}: h^{exponent:.2}", line.line);
            chart = chart.with(Series::line_and_points(name, line.slacks));
        }
        chart
    }
}
