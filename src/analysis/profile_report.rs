//! What is printed and drawn of a profile.

use crate::error::Result;
use crate::figures::{Axis, Chart, Series};
use crate::proof::{Exponent, ProofProfile, Rung, Section};
use crate::report::{Column, Format, Headline, Table, Verdict};
use std::path::Path;

/// Lines whose slack is quoted, and under which name.
const LOSING: [(&str, &str); 4] = [
    ("(3.7) scaling of the norm", "scaling"),
    ("(3.12) Poincaré", "poincare"),
    ("(4.10) embedding", "embedding"),
    ("(4.11) Poincaré of u_N'", "poincare"),
];

/// Lines drawn in the chart of slacks.
const DRAWN: usize = 6;

/// An inequality over all meshes.
#[derive(Debug, Clone, PartialEq)]
struct Line {
    label: &'static str,
    count: usize,
    violations: usize,
    sharpest: f64,
    slack: Option<f64>,
    /// Exponent of right/left.
    exponent: Option<Exponent>,
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
        let table = if lines { self.line_table()? } else { Self::ladder_table(&rungs) };
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
            let named = LOSING.into_iter().find(|(label, _)| *label == line.label);
            if let (Some((_, name)), Some(exponent)) = (named, line.exponent) {
                headline.quote(format!("{key}.slack.{name}"), exponent.value);
                headline.quote(format!("{key}.slack.{name}.uncertainty"), exponent.uncertainty);
            }
        }
        headline.quote(format!("{key}.checks"), self.checks() as f64);
        headline.quote(format!("{key}.violations"), self.violations() as f64);
    }

    /// Inequalities checked.
    pub fn checks(&self) -> usize {
        self.levels.iter().flat_map(|l| &l.inequalities).map(|i| i.count).sum()
    }

    /// Inequalities that fail beyond the error of their two sides.
    pub fn violations(&self) -> usize {
        self.levels.iter().flat_map(|l| &l.inequalities).map(|i| i.violations).sum()
    }

    fn verdict(&self, rungs: &[Rung]) -> Verdict {
        let failed = self.violations();
        let missed: usize = self.levels.iter().map(|l| l.cases[2]).sum();
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
            .filter_map(|r| r.loss.map(|loss| (r.name, loss)))
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

    fn ladder_table(rungs: &[Rung]) -> Table {
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
                rung.name.into(),
                rung.lines.into(),
                rung.values[0].into(),
                rung.exponent.value.into(),
                rung.loss.map(|l| l.value).into(),
                rung.loss.map(|l| l.uncertainty).into(),
                rung.corrected.value.into(),
                rung.values[1].into(),
                rung.exponent.uncertainty.into(),
            ]);
        }
        table
    }

    fn lines(&self) -> Vec<Line> {
        let mut labels: Vec<&'static str> = Vec::new();
        for inequality in self.levels.iter().flat_map(|l| &l.inequalities) {
            if !labels.contains(&inequality.label) {
                labels.push(inequality.label);
            }
        }
        labels.sort_unstable();
        let of = |label| {
            let found: Vec<_> = self
                .levels
                .iter()
                .filter_map(|l| l.inequalities.iter().find(|i| i.label == label).map(|i| (l.h(), i)))
                .collect();
            let slacks: Vec<(f64, f64)> =
                found.iter().filter_map(|(h, i)| i.slack().map(|slack| (*h, slack))).collect();
            Line {
                label,
                count: found.iter().map(|(_, i)| i.count).sum(),
                violations: found.iter().map(|(_, i)| i.violations).sum(),
                sharpest: found.iter().fold(0.0, |m: f64, (_, i)| m.max(i.sharpest)),
                slack: slacks.last().map(|s| s.1),
                exponent: Exponent::fit(&slacks).ok(),
            }
        };
        labels.into_iter().map(of).collect()
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
                line.label.into(),
                line.count.into(),
                line.violations.into(),
                line.sharpest.into(),
                line.slack.into(),
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
            let points: Vec<(f64, f64)> = self.levels.iter().map(|l| (l.h(), l.rungs[k][0])).collect();
            let name = format!("{}: {:.2}", rung.name, rung.exponent.value);
            let series = if k == 0 || k == last {
                Series::line_and_points(name, points)
            } else {
                // Where the law of the constant costs nothing its rung lies on the one before: both must be seen.
                if rung.name.starts_with("law") {
                    Series::dashed(name, points)
                } else {
                    Series::line(name, points)
                }
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
        let mut lines: Vec<(f64, Line)> =
            self.lines().into_iter().filter_map(|line| line.exponent.map(|e| (e.value, line))).collect();
        lines.sort_by(|a, b| a.0.total_cmp(&b.0));
        for (exponent, line) in lines.into_iter().take(DRAWN) {
            let points = self.levels.iter().filter_map(|l| {
                let found = l.inequalities.iter().find(|i| i.label == line.label)?;
                Some((l.h(), found.slack()?))
            });
            let name = format!("{}: h^{exponent:.2}", line.label);
            chart = chart.with(Series::line_and_points(name, points.collect()));
        }
        chart
    }
}
