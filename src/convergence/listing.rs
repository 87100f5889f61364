//! A rate study as table, CSV, JSON and figure.

use super::bounds::Bound;
use super::study::{Quantity, RateStudy};
use crate::error::Result;
use crate::figures::{Axis, Chart, Series};
use crate::report::{Cell, Column, Format, Table};
use serde_json::{Value, json};
use std::fmt::Write as _;

/// The candidate bounds and their keys.
const BOUNDS: [(Bound, &str); 4] = [
    (Bound::Earlier, "earlier"),
    (Bound::Paper, "paper"),
    (Bound::Sharpened, "sharpened"),
    (Bound::Optimal, "optimal"),
];

impl RateStudy {
    /// One row per level: h, unknowns, error, ratio to the level before, order, error against the bounds, contact runs, seconds, and
    /// why a level is left out.
    ///
    /// # Errors
    /// As [`Bound::value`].
    pub fn table(&self) -> Result<Table> {
        let four = Format::Significant(4);
        let mut table = Table::new(vec![
            Column::new("cells", "1/h", Format::Significant(7), "contact segments per unit length"),
            Column::new("unknowns", "unknowns", Format::Scientific(1), ""),
            Column::new("error", "error", Format::Scientific(4), "energy norm of u - u_h"),
            Column::new("ratio", "ratio", Format::Fixed(3), "error of the row above over this one"),
            Column::new("order", "order", Format::Fixed(3), "log2 of the ratio"),
            Column::hidden("over_earlier"),
            Column::new("over_paper", "e/paper", four, "error over the bound of the theorem"),
            Column::hidden("over_sharpened"),
            Column::new("over_optimal", "e/optimal", four, "error over h^(tau-1)"),
            Column::new("term", "term", Format::Scientific(2), "consistency term of the cone, a square"),
            Column::new(
                "term_over_paper",
                "root/paper",
                four,
                "root of the term over the bound of the theorem",
            ),
            Column::new("runs", "runs", Format::Significant(6), "runs of active constraints"),
            Column::hidden("kkt"),
            Column::new("seconds", "s", Format::Significant(2), ""),
            Column::new("flag", "left out", Format::Plain, "why the level counts in no fit and no bound"),
        ]);
        for (k, level) in self.levels.iter().enumerate() {
            let h = level.mesh_size();
            let ratio = k.checked_sub(1).map(|before| self.levels[before].error / level.error);
            let ratio = ratio.filter(|r| r.is_finite() && *r > 0.0);
            let over = |e: f64| BOUNDS.map(|(bound, _)| bound.value(h, self.tau).map(|b| e / b));
            let [earlier, paper, sharpened, optimal] = over(level.error);
            let root = level.consistency.map(f64::sqrt);
            let root_over_paper = root.map(|e| Bound::Paper.value(h, self.tau).map(|b| e / b)).transpose()?;
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

    /// Scene, fits and table as text.
    ///
    /// # Errors
    /// As [`RateStudy::table`].
    pub fn text(&self) -> Result<String> {
        let fit = |quantity| self.fit(quantity).map_or("none".to_owned(), |fit| fit.to_string());
        Ok(format!(
            "{}, {} cone, tau = {}: error of order {}, root of the term {}; {} levels left out\n\n{}",
            self.scene,
            self.cone,
            self.tau,
            fit(Quantity::Error),
            fit(Quantity::Consistency),
            self.left_out(),
            self.table()?.text(),
        ))
    }

    /// One line per level, all digits, with a line of column names if `header`.
    ///
    /// # Errors
    /// As [`RateStudy::table`].
    pub fn csv(&self, header: bool) -> Result<String> {
        let table = self.table()?;
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
            let _ = writeln!(text, "\"{}\",{},{},{}", self.scene, self.cone, self.tau, cells.join(","));
        }
        Ok(text)
    }

    /// All of it as one JSON object: scene, cone, tau, norm, fits with their uncertainty, constants, levels.
    ///
    /// # Errors
    /// As [`Bound::value`].
    pub fn json(&self) -> Result<Value> {
        let fit = |quantity| {
            self.fit(quantity).map(|fit| {
                json!({
                    "order": fit.order,
                    "half_width": fit.half_width,
                    "model": fit.model.to_string(),
                    "from": fit.regime.0,
                    "to": fit.regime.1,
                })
            })
        };
        let mut constants = serde_json::Map::new();
        for (bound, name) in BOUNDS {
            constants.insert(name.to_owned(), json!(self.constant(Quantity::Error, bound)?));
        }
        Ok(json!({
            "scene": self.scene,
            "cone": self.cone.to_string(),
            "tau": self.tau,
            "norm": self.norm,
            "error_fit": fit(Quantity::Error),
            "term_fit": fit(Quantity::Consistency),
            "largest_error_over_bound": constants,
            "levels": self.levels.iter().map(|level| level.json()).collect::<Vec<_>>(),
        }))
    }

    /// Error and root of the consistency term against h, of this study and others of the same scene in other cones, with the bounds
    /// through the coarsest error.
    ///
    /// # Errors
    /// As [`Bound::value`].
    pub fn chart(&self, others: &[&RateStudy], title: impl Into<String>) -> Result<Chart> {
        let x = Axis::logarithmic("mesh size h (edge of length 1)");
        let mut chart = Chart::new(title, x, Axis::logarithmic("error in the energy norm, root of the term"));
        for study in std::iter::once(self).chain(others.iter().copied()) {
            let named = |what: &str| format!("{what}, {} cone", study.cone);
            chart = chart.with(Series::line_and_points(named("error"), study.points(Quantity::Error)));
            let terms: Vec<_> =
                study.points(Quantity::Consistency).into_iter().filter(|point| point.1 > 0.0).collect();
            if !terms.is_empty() {
                chart = chart.with(Series::line_and_points(named("term"), terms));
            }
        }
        let points = self.points(Quantity::Error);
        let Some(&(coarsest, error)) = points.first() else {
            return Ok(chart);
        };
        for bound in [Bound::Earlier, Bound::Paper, Bound::Optimal] {
            let constant = error / bound.value(coarsest, self.tau)?;
            let line: Result<Vec<_>> =
                points.iter().map(|&(h, _)| Ok((h, constant * bound.value(h, self.tau)?))).collect();
            chart = chart.with(Series::dashed(bound.name(self.tau)?, line?));
        }
        Ok(chart)
    }
}
