//! The cases of Figure 3.2 or 4.1 on the contact set of a fine solution, over a sequence of coarser meshes.

use super::alternatives::{checked_theta, printed_theta};
use super::classification::{Classification, Section};
use super::edge_trace::EdgeTrace;
use super::orders::observed_orders;
use crate::contact::{Cone, Solver};
use crate::error::{Error, Result};
use crate::figures::{Axis, Chart, PALETTE, Series};
use crate::report::{Column, Format, Table, Verdict};
use crate::scenes::Scene;

/// The fine solution has this many segments in each of the finest contact segments classified.
const REFERENCE_FACTOR: usize = 8;
/// Largest n: a reference with 2048 squares along each side.
const LARGEST: usize = 256;
/// u_N counts as zero below this, relative to its largest value: far above rounding, far below one cell's opening.
const ZERO: f64 = 1e-12;

/// Names of the cases, as columns and bands.
const CASES: [&str; 3] = ["first", "second", "both"];

/// How θ follows from h = 1/n.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ThetaRule {
    /// θ = h^{2τ−3}, at τ = 2 θ = h²: the paper's choice.
    Printed {
        /// Sobolev regularity, 3/2 < τ ≤ 2.
        tau: f64,
    },
    /// The same θ on every mesh.
    Fixed(f64),
}

impl ThetaRule {
    fn theta(self, h: f64) -> Result<f64> {
        match self {
            ThetaRule::Printed { tau } => printed_theta(h, tau),
            ThetaRule::Fixed(theta) => checked_theta(theta),
        }
    }
}

/// One mesh of a study.
#[derive(Debug, Clone, PartialEq)]
pub struct AlternativeRow {
    /// Contact segments per unit length.
    pub n: usize,
    /// θ on this mesh.
    pub theta: f64,
    /// Its contact segments.
    pub classification: Classification,
}

/// The meshes n/4, n/2, n of one scene, classified on the nodal solution with 8n squares along each side.
#[derive(Debug, Clone, PartialEq)]
pub struct AlternativeStudy {
    section: Section,
    scene: Scene,
    trace: EdgeTrace,
    rows: Vec<AlternativeRow>,
}

impl AlternativeStudy {
    /// Solves the scene on 8n x 8n squares and classifies the contact segments of the meshes n/4, n/2 and n.
    ///
    /// # Errors
    /// [`Error::CountOutOfRange`] unless n is a multiple of 4 from 8 to 256; [`Error::OutOfRange`] for τ or θ.
    pub fn new(section: Section, scene: Scene, n: usize, rule: ThetaRule) -> Result<Self> {
        if !(8..=LARGEST).contains(&n) || !n.is_multiple_of(4) {
            return Err(Error::CountOutOfRange {
                name: "n",
                value: n,
                range: "the multiples of 4 from 8 to 256",
            });
        }
        // A bad θ or τ is found before the work.
        let meshes = [n / 4, n / 2, n];
        let thetas = meshes.iter().map(|&m| rule.theta(1.0 / m as f64)).collect::<Result<Vec<f64>>>()?;
        let problem = scene.problem(REFERENCE_FACTOR * n)?;
        let solution = problem.solve(Cone::Nodal, Solver::ActiveSet)?;
        let largest = solution.normal_displacement.iter().fold(0.0, |m: f64, u| m.max(u.abs()));
        let arc = problem.edge().arc().to_vec();
        let trace = EdgeTrace::new(arc, solution.normal_displacement, solution.multiplier, ZERO * largest)?;
        let rows = meshes.into_iter().zip(thetas).map(|(m, theta)| {
            let vertices: Vec<f64> = (0..=m).map(|i| i as f64 / m as f64).collect();
            let classification = Classification::new(section, &trace, &vertices, theta)?;
            Ok(AlternativeRow { n: m, theta, classification })
        });
        let rows = rows.collect::<Result<Vec<_>>>()?;
        Ok(Self { section, scene, trace, rows })
    }

    /// The meshes, coarsest first.
    pub fn rows(&self) -> &[AlternativeRow] {
        &self.rows
    }

    /// Counts and consistency terms by case, one row per mesh.
    ///
    /// # Errors
    /// None in practice: the lengths agree.
    pub fn table(&self) -> Result<Table> {
        let count = Format::Significant(3);
        let share = Format::Scientific(2);
        let mut table = Table::new(vec![
            Column::new("n", "1/h", count, "contact segments per unit length"),
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
            table.push(vec![
                row.n.into(),
                row.theta.into(),
                found.count("first").into(),
                found.count("second").into(),
                found.count("both").into(),
                found.count("none").into(),
                found.term("first").into(),
                found.term("second").into(),
                found.term("both").into(),
                order.into(),
            ]);
        }
        Ok(table)
    }

    /// Holds when every segment of every mesh is in a case.
    pub fn verdict(&self) -> Verdict {
        let missed: usize = self.rows.iter().map(|r| r.classification.count("none")).sum();
        match missed {
            0 => Verdict::Holds,
            _ => Verdict::NotConfirmed(format!("{missed} segments are in neither case")),
        }
    }

    /// "11 first, 20 second, 1 both of 32 segments; second case carries 100 % of the term", on the finest mesh.
    pub fn measured(&self) -> String {
        let Some(row) = self.rows.last() else { return String::new() };
        let found = &row.classification;
        let counts = CASES.map(|name| format!("{} {name}", found.count(name))).join(", ");
        let total = found.total();
        let largest =
            CASES.into_iter().max_by(|a, b| found.term(a).total_cmp(&found.term(b))).unwrap_or("first");
        let share = if total > 0.0 { 100.0 * found.term(largest) / total } else { 0.0 };
        format!("{counts} of {} segments; {largest} carries {share:.0} % of the term", found.segments().len())
    }

    /// The finest mesh: cases as bands behind u_N and the contact pressure of the fine solution.
    pub fn chart(&self) -> Option<Chart> {
        let row = self.rows.last()?;
        let scaled = |values: &[f64]| -> Vec<(f64, f64)> {
            let largest = values.iter().fold(0.0, |m: f64, v| m.max(v.abs()));
            let unit = if largest > 0.0 { largest } else { 1.0 };
            self.trace.nodes().iter().zip(values).map(|(&x, v)| (x, v / unit)).collect()
        };
        let figure = if self.section == Section::Three { "Figure 3.2" } else { "Figure 4.1" };
        let title = format!("{figure} on scene {}, 1/h = {}, θ = {:.3}", self.scene, row.n, row.theta);
        let x = Axis::linear("x along the contact edge (side of the square = 1)");
        let mut chart = Chart::new(title, x, Axis::linear("share of the largest value"))
            .with(Series::line("u_N", scaled(self.trace.displacement())))
            .with(Series::line("−σ_N, contact pressure", scaled(&self.trace.pressure())));
        for (name, colour) in CASES.into_iter().zip([PALETTE[4], PALETTE[5], PALETTE[2]]) {
            let intervals = row.classification.intervals(name);
            if !intervals.is_empty() {
                chart = chart.with_bands(
                    format!("{name} case").replace("both case", "both cases"),
                    intervals,
                    colour,
                );
            }
        }
        Some(chart)
    }
}
