//! A rate study as table, figure and verdict, the same for both theorems.

use super::orders::Bound;
use super::rate_study::RateStudy;
use crate::error::Result;
use crate::figures::{Axis, Chart, Series};
use crate::report::{Column, Format, Table, Verdict};

/// error/bound may grow by this factor from a level to the next before it counts as growing: the spread of pre-asymptotic levels.
const GROWTH: f64 = 1.05;

impl RateStudy {
    /// One row per level: h, unknowns, error, order, error against the paper's and the optimal bound.
    ///
    /// # Errors
    /// As [`RateStudy::ratios`].
    pub fn table(&self) -> Result<Table> {
        let count = Format::Significant(3);
        let mut table = Table::new(vec![
            Column::new("n", "1/h", count, "contact segments per unit length"),
            Column::new("unknowns", "unknowns", count, ""),
            Column::new("error", "error", Format::Scientific(3), "energy norm of u_ref - u_h, relative"),
            Column::new("order", "order", Format::Fixed(3), "observed against the row above"),
            Column::new(
                "over_paper",
                "error/paper",
                Format::Significant(4),
                "error over the bound of the theorem",
            ),
            Column::new("over_optimal", "error/optimal", Format::Significant(4), "error over h^(tau-1)"),
            Column::new("active", "active", count, "active constraints"),
            Column::hidden("kkt"),
            Column::new("seconds", "s", Format::Significant(2), ""),
        ]);
        let (paper, optimal) = (self.ratios(Bound::Paper)?, self.ratios(Bound::Optimal)?);
        for (k, row) in self.rows.iter().enumerate() {
            table.push(vec![
                row.n.into(),
                row.unknowns.into(),
                row.error.into(),
                row.order.into(),
                paper[k].into(),
                optimal[k].into(),
                row.active.into(),
                row.judgement.into(),
                row.seconds.into(),
            ]);
        }
        Ok(table)
    }

    /// Errors against h with the two bounds, each passing through the coarsest error.
    ///
    /// # Errors
    /// As [`RateStudy::ratios`].
    pub fn chart(&self, title: impl Into<String>) -> Result<Chart> {
        let tau = self.tau;
        let through_first = |bound: Bound| -> Result<Vec<(f64, f64)>> {
            let first = &self.rows[0];
            let constant = first.error / bound.value(first.mesh_size, tau)?;
            self.rows.iter().map(|r| Ok((r.mesh_size, constant * bound.value(r.mesh_size, tau)?))).collect()
        };
        let name = |bound: Bound| -> Result<String> { Ok(format!("h^{:.3}", bound.exponent(tau)?)) };
        let paper = if tau == 2.0 { "h |ln h|^1/2".to_owned() } else { name(Bound::Paper)? };
        let measured = self.rows.iter().map(|r| (r.mesh_size, r.error)).collect();
        let x = Axis::logarithmic("h, length of a contact segment (side of the square = 1)");
        Ok(Chart::new(title, x, Axis::logarithmic("relative error in the energy norm"))
            .with(Series::line_and_points("measured", measured))
            .with(Series::dashed(format!("{paper}, the theorem"), through_first(Bound::Paper)?))
            .with(Series::dashed(
                format!("{}, optimal", name(Bound::Optimal)?),
                through_first(Bound::Optimal)?,
            )))
    }

    /// "order 0.84 to 0.87 on the last three steps".
    pub fn measured(&self) -> String {
        match self.order_range() {
            Some((low, high)) => format!("order {low:.3} to {high:.3} on the finest steps"),
            None => "no order: an error vanished".to_owned(),
        }
    }

    /// Whether error/bound stays bounded, and by which power of h the bound is beaten.
    ///
    /// # Errors
    /// As [`RateStudy::ratios`].
    pub fn verdict(&self) -> Result<Verdict> {
        let ratios = self.ratios(Bound::Paper)?;
        let (first, last) = (ratios[0], ratios[ratios.len() - 1]);
        let grows = ratios.windows(2).find(|pair| pair[1].is_nan() || pair[1] > GROWTH * pair[0]);
        if let Some(&[before, after]) = grows {
            return Ok(Verdict::NotConfirmed(format!("error/bound grows from {before:.3} to {after:.3}")));
        }
        if self.tau == 2.0 {
            // The bound differs from the optimal one by a logarithm only: a power of h would misname the gap.
            let optimal = self.ratios(Bound::Optimal)?;
            let range =
                optimal.iter().fold((f64::INFINITY, 0.0), |(a, b): (f64, f64), &r| (a.min(r), b.max(r)));
            let words = format!("the logarithm: error/h stays between {:.3} and {:.3}", range.0, range.1);
            return Ok(Verdict::HoldsLoose(words));
        }
        let span = (self.rows[0].mesh_size / self.rows[self.rows.len() - 1].mesh_size).ln();
        let beaten = (first / last).ln() / span;
        Ok(if beaten < 0.01 {
            Verdict::Holds
        } else {
            Verdict::HoldsLoose(format!("h^{beaten:.2} on these meshes"))
        })
    }
}
