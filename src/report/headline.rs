//! The outcome of an example: claim, table, verdict, and where its figures are.

use super::table::Table;
use std::fmt;
use std::path::PathBuf;

/// What the computation says of the paper's statement.
#[derive(Debug, Clone, PartialEq)]
pub enum Verdict {
    /// The statement holds in every case computed.
    Holds,
    /// It holds and is not sharp; says by how much.
    HoldsLoose(String),
    /// The printed form fails; says where, and which form holds.
    PrintedFormFails(String),
    /// The computation contradicts the statement or could not decide; says why.
    NotConfirmed(String),
}

impl Verdict {
    /// True unless the statement could not be confirmed.
    pub fn is_confirmed(&self) -> bool {
        !matches!(self, Verdict::NotConfirmed(_))
    }
}

impl fmt::Display for Verdict {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Verdict::Holds => write!(f, "holds"),
            Verdict::HoldsLoose(how) => write!(f, "holds, loose by {how}"),
            Verdict::PrintedFormFails(how) => write!(f, "printed form fails: {how}"),
            Verdict::NotConfirmed(why) => write!(f, "not confirmed: {why}"),
        }
    }
}

/// Everything an example has to say, as data: printed, written as JSON, tested, and quoted by the book.
#[derive(Debug, Clone, PartialEq)]
pub struct Headline {
    /// The paper's label, for example "Lemma 5.2".
    pub label: String,
    /// The statement in one line.
    pub claim: String,
    /// The rows.
    pub table: Table,
    /// The most telling number in a few words, for the row of the tour.
    pub measured: String,
    /// What the computation says of the statement.
    pub verdict: Verdict,
    /// Figures written, if any were asked for.
    pub figures: Vec<PathBuf>,
    /// Numbers quoted elsewhere (book, README), by key; keys are lower case words joined by dots.
    pub values: Vec<(String, f64)>,
}

impl Headline {
    /// A headline without figures or quoted values.
    pub fn new(
        label: impl Into<String>,
        claim: impl Into<String>,
        table: Table,
        measured: impl Into<String>,
        verdict: Verdict,
    ) -> Self {
        Self {
            label: label.into(),
            claim: claim.into(),
            table,
            measured: measured.into(),
            verdict,
            figures: Vec::new(),
            values: Vec::new(),
        }
    }

    /// Adds a number to be quoted under `key`.
    pub fn quote(&mut self, key: impl Into<String>, value: f64) {
        self.values.push((key.into(), value));
    }
}

impl fmt::Display for Headline {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{}: {}\n", self.label, self.claim)?;
        writeln!(f, "{}", self.table.text())?;
        writeln!(f, "measured: {}", self.measured)?;
        writeln!(f, "verdict:  {}", self.verdict)?;
        for figure in &self.figures {
            writeln!(f, "figure:   {}", figure.display())?;
        }
        Ok(())
    }
}
