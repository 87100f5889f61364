//! The report of an example.

use crate::cell::Cells;
use crate::check::{Claim, Role};
use crate::figures::body::{body_range, body_svg, edge_plot, trace_plot};
use crate::figures::{Axes, Plot};
use crate::outcome::Outcome;
use crate::{Declarations, Measured, Result};
use signorini::contact::{ContactProblem, ContactSolution};
use signorini::edge::{EdgeTrace, Interval};
use std::time::Instant;

/// The report of an example while it runs: rows, checks and pictures.
#[derive(Debug)]
pub struct Report {
    found: Outcome,
    pub(crate) draws: bool,
    started: Instant,
}

impl Report {
    /// An empty report under the label of an example.
    pub fn of<P: Declarations>() -> Self {
        Self::new(P::LABEL, P::STATEMENT)
    }

    pub(crate) fn new(label: &'static str, statement: &'static str) -> Self {
        let found = Outcome { label, statement, ..Outcome::default() };
        Self { found, draws: false, started: Instant::now() }
    }

    /// Sets the title and the meaning of the column of that name; without it the title is the name,
    /// with Greek letters in place of their names and a slash in place of `_over_`. The meaning is
    /// printed below the table.
    pub fn column(&mut self, name: &'static str, title: &'static str, meaning: &'static str) {
        if !self.found.columns.iter().any(|(known, ..)| *known == name) {
            self.found.columns.push((name, title, meaning));
        }
    }

    /// Adds a row; each number among its results can be quoted as `name.row`, for example
    /// `gamma.nu0.25.theta1e-3`.
    pub fn row(&mut self, cells: Cells) {
        self.found.rows.push(cells);
    }

    /// A claim that must hold.
    pub fn check(&mut self, claim: impl Into<String>) -> Claim<'_> {
        Claim::new(&mut self.found.checks, claim.into(), Role::Claim)
    }

    /// A claim in the paper's own form, which may fail; the source of its comparison is the range
    /// in which it is true, such as "for θ ≤ 1/2".
    pub fn as_printed(&mut self, claim: impl Into<String>) -> Claim<'_> {
        Claim::new(&mut self.found.checks, claim.into(), Role::AsPrinted)
    }

    /// A statement stronger than the paper's: if it holds, the paper's is loose.
    pub fn stronger(&mut self, claim: impl Into<String>) -> Claim<'_> {
        Claim::new(&mut self.found.checks, claim.into(), Role::Stronger)
    }

    /// A rate of growth different from the paper's: if it holds, the paper's is not sharp.
    pub fn not_sharp(&mut self, claim: impl Into<String>) -> Claim<'_> {
        Claim::new(&mut self.found.checks, claim.into(), Role::NotSharp)
    }

    /// A comparison that is shown but has no effect on the status.
    pub fn observe(&mut self, claim: impl Into<String>) -> Claim<'_> {
        Claim::new(&mut self.found.checks, claim.into(), Role::Observed)
    }

    /// Records a claim that is true by the proof on a page of the book, given by its file name
    /// without extension.
    pub fn proof(&mut self, claim: impl Into<String>, page: &'static str) {
        Claim::new(&mut self.found.checks, claim.into(), Role::Claim).by_proof(page);
    }

    /// Records a number to be quoted under this key.
    pub fn note(&mut self, key: impl Into<String>, value: impl Into<Measured>) {
        self.found.notes.push((key.into(), value.into().value));
    }

    /// Sets the remark that is printed last, to explain an unexpected number.
    pub fn remark(&mut self, words: impl Into<String>) {
        self.found.remark = words.into();
    }

    /// Sets the bar and the words beside the clock that a terminal shows while the example runs:
    /// `share` of the work is done, in [0, 1]; no bar for NaN.
    pub fn progress(&self, share: f64, words: impl Into<String>) {
        crate::command::show(share, words.into());
    }

    /// The numbers of these two columns in the last consecutive rows whose parameters differ only
    /// in `x`.
    pub fn series(&self, x: &str, y: &str) -> Vec<(f64, f64)> {
        self.measured(x, y).into_iter().map(|(x, y)| (x, y.value)).collect()
    }

    /// The same with the errors of y.
    fn measured(&self, x: &str, y: &str) -> Vec<(f64, Measured)> {
        let Some(last) = self.found.rows.last() else { return Vec::new() };
        let same = |row: &&Cells| {
            row.about.iter().zip(&last.about).all(|(a, b)| a.0 == b.0 && (a.0 == x || a.1 == b.1))
        };
        let rows = self.found.rows.iter().rev().take_while(same);
        let number =
            |row: &Cells, name: &str| row.get(name).map_or(Measured::NONE, |cell| cell.number());
        let mut points: Vec<(f64, Measured)> =
            rows.map(|row| (number(row, x).value, number(row, y))).collect();
        points.reverse();
        points
    }

    /// Slope of ln y against ln x between the last two rows of [`Report::series`], with the effect
    /// of the errors of y; [`Measured::NONE`] for fewer than two rows.
    pub fn exponent(&self, x: &str, y: &str) -> Measured {
        self.slope(x, y, f64::ln, f64::ln)
    }

    /// Slope of g(y) against f(x) between the last two rows of [`Report::series`], with the effect
    /// of the errors of y for a monotone g; [`Measured::NONE`] for fewer than two rows.
    pub fn slope(
        &self,
        x: &str,
        y: &str,
        f: impl Fn(f64) -> f64,
        g: impl Fn(f64) -> f64,
    ) -> Measured {
        let image = |y: Measured| {
            let value = g(y.value);
            let off = [y.value - y.error, y.value + y.error].map(|end| (g(end) - value).abs());
            Measured::new(value, if y.error == 0.0 { 0.0 } else { off[0].max(off[1]) })
        };
        match self.measured(x, y).as_slice() {
            [.., a, b] => (image(b.1) - image(a.1)) / (f(b.0) - f(a.0)),
            _ => Measured::NONE,
        }
    }

    /// The plot of that name, created if it does not exist; add curves to the plot returned.
    pub fn plot(&mut self, name: &str, title: &str, axes: Axes) -> &mut Plot {
        let plots = &mut self.found.plots;
        let known = plots.iter().position(|plot| plot.name == name);
        let at = known.unwrap_or(plots.len());
        if at == plots.len() {
            plots.push(Plot::new(name, title, axes));
        }
        &mut plots[at]
    }

    /// True if pictures were requested, so that data used by pictures only must be computed.
    pub fn draws(&self) -> bool {
        self.draws
    }

    /// Adds pictures of contact solutions as deformed bodies, one under each name, all with the
    /// colour scale of the last one: to its largest value, or to the value exceeded on one percent
    /// of the area if that is less than half of it, as near a corner of infinite stress.
    ///
    /// # Errors
    /// As for [`signorini::fem::stresses`].
    pub fn bodies(
        &mut self,
        title: &str,
        solved: &[(String, &ContactProblem, &ContactSolution)],
    ) -> Result<()> {
        let Some((_, problem, solution)) = solved.last() else { return Ok(()) };
        let range = body_range(problem, solution)?;
        for (name, problem, solution) in solved {
            self.found.bodies.push((name.clone(), body_svg(problem, solution, title, range)?));
        }
        Ok(())
    }

    /// Adds a picture that the example has drawn itself: the text of an SVG file.
    pub fn picture(&mut self, name: &str, svg: impl Into<String>) {
        self.found.bodies.push((name.to_owned(), svg.into()));
    }

    /// Adds a plot of u_N and −σ_N of a contact solution along its contact edges, each divided by
    /// the maximum of its absolute value.
    pub fn contact_edge(
        &mut self,
        name: &str,
        title: &str,
        problem: &ContactProblem,
        solution: &ContactSolution,
    ) {
        self.found.plots.push(edge_plot(name, title, problem, solution));
    }

    /// Adds a plot of u_N and −σ_N along an edge, each divided by the maximum of its absolute
    /// value; the segments in the first case of Figure 3.2 or 4.1, in the second case, and in both
    /// are shaded.
    pub fn edge_trace(&mut self, name: &str, edge: &EdgeTrace, cases: [Vec<Interval>; 3]) {
        self.found.plots.push(trace_plot(name, edge, cases));
    }

    /// The outcome of the example: everything recorded, and the elapsed time.
    pub fn close(self) -> Outcome {
        Outcome { seconds: self.started.elapsed().as_secs_f64(), ..self.found }
    }
}
