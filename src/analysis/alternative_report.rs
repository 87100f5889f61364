//! What is printed and drawn of a study of the alternatives.

use crate::convergence::observed_orders;
use crate::error::Result;
use crate::figures::{Axis, Chart, PALETTE, Series};
use crate::proof::{Against, AlternativeStudy, Classification, Section};
use crate::report::{Column, Format, Headline, Table, Verdict};
use std::path::Path;

/// Names of the cases, as columns and bands.
const CASES: [&str; 3] = ["first", "second", "both"];
/// Points of a trace that are drawn.
const DRAWN: usize = 2000;

impl AlternativeStudy {
    /// Claim, table, verdict and quoted values, and the figures saved as `name` and `name_shares`.
    ///
    /// # Errors
    /// Those of writing the figures.
    pub fn headline(&self, directory: Option<&Path>, name: &str) -> Result<Headline> {
        let (label, key, claim) = match self.case.section {
            Section::Three => (
                "Figure 3.2",
                "figure.3.2",
                "on every contact segment u_N has a zero near both vertices or sigma_N = 0 near one",
            ),
            Section::Four => (
                "Figure 4.1",
                "figure.4.1",
                "on every contact segment the contact set has diameter at most h_e theta or at least h_e theta",
            ),
        };
        let mut headline = Headline::new(label, claim, self.table()?, self.measured(), self.verdict());
        if let Some(finest) = self.rows.last() {
            for case in CASES {
                headline.quote(format!("{key}.{case}.count"), finest.classification.count(case) as f64);
                headline.quote(format!("{key}.{case}.term"), finest.classification.term(case));
            }
            headline.quote(format!("{key}.theta"), finest.theta);
        }
        if let Some(directory) = directory {
            if let Some(chart) = self.chart() {
                headline.figures.push(chart.save(directory, name)?);
            }
            headline.figures.push(self.shares_chart().save(directory, &format!("{name}_shares"))?);
        }
        Ok(headline)
    }

    /// Counts and consistency terms by case, one row per mesh or θ.
    ///
    /// # Errors
    /// None in practice: the lengths agree.
    pub fn table(&self) -> Result<Table> {
        let count = Format::Significant(3);
        let share = Format::Scientific(2);
        let mut table = Table::new(vec![
            Column::new("n", "1/h", Format::Plain, "contact segments per unit length"),
            Column::new("theta", "theta", Format::Significant(3), "share of a segment that counts as near"),
            Column::new("first", "first", count, "segments in the first case only"),
            Column::new("second", "second", count, "segments in the second case only"),
            Column::new("both", "both", count, "segments in both cases"),
            Column::new("none", "none", count, "segments in neither: would contradict the paper"),
            Column::new("term_first", "term, first", share, "their part of the consistency term"),
            Column::new("term_second", "term, second", share, ""),
            Column::new("term_both", "term, both", share, ""),
            Column::new("order", "order", Format::Fixed(2), "observed order of the whole term in h"),
        ]);
        let sizes: Vec<f64> = self.rows.iter().map(|r| 1.0 / r.n as f64).collect();
        let totals: Vec<f64> = self.rows.iter().map(|r| r.classification.total()).collect();
        for (row, order) in self.rows.iter().zip(observed_orders(&sizes, &totals)?) {
            let found = &row.classification;
            let mut cells = vec![row.n.into(), row.theta.into()];
            cells.extend(["first", "second", "both", "none"].map(|name| found.count(name).into()));
            cells.extend(CASES.map(|name| found.term(name).into()));
            cells.push(order.into());
            table.push(cells);
        }
        Ok(table)
    }

    /// Holds when every segment of every row is in a case.
    pub fn verdict(&self) -> Verdict {
        let missed: usize = self.rows.iter().map(|r| r.classification.count("none")).sum();
        match missed {
            0 => Verdict::Holds,
            _ => Verdict::NotConfirmed(format!("{missed} segments are in neither case")),
        }
    }

    /// "on the reference: 11 first, 20 second, 1 both of 32 segments; second carries 100 % of the term", for the last row.
    pub fn measured(&self) -> String {
        let Some(row) = self.rows.last() else { return String::new() };
        let found = &row.classification;
        let counts = CASES.map(|name| format!("{} {name}", found.count(name))).join(", ");
        let whose = match self.case.against {
            Against::Reference => "on the fine reference",
            Against::Itself => "on u_h itself",
        };
        let total = found.total();
        let carried = match CASES.into_iter().max_by(|a, b| found.term(a).total_cmp(&found.term(b))) {
            Some(largest) if total > 0.0 => {
                format!("{largest} carries {:.0} % of the term", 100.0 * found.term(largest) / total)
            }
            _ => "the term is zero".to_owned(),
        };
        format!("{whose}, {counts} of {} segments; {carried}", found.segments().len())
    }

    /// The last row: cases as bands behind u_N and the contact pressure.
    pub fn chart(&self) -> Option<Chart> {
        let row = self.rows.last()?;
        let step = self.trace.nodes().len().div_ceil(DRAWN);
        let scaled = |values: &[f64]| -> Vec<(f64, f64)> {
            let largest = values.iter().fold(0.0, |m: f64, v| m.max(v.abs()));
            let unit = if largest > 0.0 { largest } else { 1.0 };
            self.trace.nodes().iter().zip(values).step_by(step).map(|(&x, v)| (x, v / unit)).collect()
        };
        let title =
            format!("{} on scene {}, 1/h = {}, θ = {:.3}", self.figure(), self.case.source, row.n, row.theta);
        let x = Axis::linear("x along the contact edge (side of the square = 1)");
        let mut chart = Chart::new(title, x, Axis::linear("share of the largest value"))
            .with(Series::line("u_N", scaled(self.trace.displacement())))
            .with(Series::line("−σ_N, contact pressure", scaled(&self.trace.pressure())));
        for (name, colour) in CASES.into_iter().zip([PALETTE[4], PALETTE[5], PALETTE[2]]) {
            let intervals = row.classification.intervals(name);
            if !intervals.is_empty() {
                let label = format!("{name} case").replace("both case", "both cases");
                chart = chart.with_bands(label, intervals, colour);
            }
        }
        Some(chart)
    }

    /// Shares of the segments (dashed) and of the consistency term by case, over h or over θ.
    pub fn shares_chart(&self) -> Chart {
        let over_theta = self.rows.first().map(|r| r.n) == self.rows.last().map(|r| r.n);
        let label = if over_theta { "θ" } else { "h (edge = 1)" };
        let title = format!("{} on scene {}: what each case carries", self.figure(), self.case.source);
        let y = Axis::linear("share").range(-0.05, 1.05);
        let mut chart = Chart::new(title, Axis::logarithmic(label), y);
        for (name, colour) in CASES.into_iter().zip([PALETTE[4], PALETTE[5], PALETTE[2]]) {
            let points = |share: &dyn Fn(&Classification) -> f64| -> Vec<(f64, f64)> {
                self.rows
                    .iter()
                    .map(|r| (if over_theta { r.theta } else { 1.0 / r.n as f64 }, share(&r.classification)))
                    .filter(|(_, share)| share.is_finite())
                    .collect()
            };
            let term = points(&|c| c.term(name) / c.total());
            let count = points(&|c| c.count(name) as f64 / c.segments().len() as f64);
            chart = chart
                .with(Series::line_and_points(format!("{name}: share of the term"), term).colour(colour))
                .with(Series::dashed(format!("{name}: share of the segments"), count).colour(colour));
        }
        chart
    }

    fn figure(&self) -> &'static str {
        if self.case.section == Section::Three { "Figure 3.2" } else { "Figure 4.1" }
    }
}
