//! The outcome of an example: claim, table, verdict, and where its figures are.

use super::table::{Table, wrapped};
use serde_json::{Map, Value, json};
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

    /// Of two verdicts the one that says more against the printed statement; the first where they weigh the same.
    #[must_use]
    pub fn graver(self, other: Verdict) -> Verdict {
        if other.weight() > self.weight() { other } else { self }
    }

    fn weight(&self) -> u8 {
        match self {
            Verdict::Holds => 0,
            Verdict::HoldsLoose(_) => 1,
            Verdict::PrintedFormFails(_) => 2,
            Verdict::NotConfirmed(_) => 3,
        }
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

/// Lines of words are broken at this width.
const WIDTH: usize = 100;
/// Where the words after "measured:" and "verdict:" begin.
const INDENT: usize = 10;

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

    /// All of it but the figures as one JSON object: `label`, `claim`, `measured`, `verdict`, `confirmed`, `values`
    /// by key, and the table as it is printed (`columns`, `rows`). Numbers carry all their digits.
    pub fn json(&self) -> String {
        let values: Map<String, Value> = self.values.iter().map(|(k, v)| (k.clone(), json!(v))).collect();
        let column = |c: &super::Column| json!({"key": c.key(), "title": c.title(), "meaning": c.meaning()});
        let columns: Vec<Value> = self.table.shown_columns().map(column).collect();
        json!({
            "label": self.label,
            "claim": self.claim,
            "measured": self.measured,
            "verdict": self.verdict.to_string(),
            "confirmed": self.verdict.is_confirmed(),
            "values": values,
            "columns": columns,
            "rows": self.table.text_rows(),
        })
        .to_string()
    }
}

impl fmt::Display for Headline {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{}\n", wrapped(&format!("{}: {}", self.label, self.claim), WIDTH).join("\n"))?;
        writeln!(f, "{}", self.table.text())?;
        for (name, words) in [("measured:", &self.measured), ("verdict: ", &self.verdict.to_string())] {
            let hanging = format!("\n{:INDENT$}", "");
            writeln!(f, "{name} {}", wrapped(words, WIDTH - INDENT).join(&hanging))?;
        }
        for figure in &self.figures {
            writeln!(f, "figure:   {}", figure.display())?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Column, Format};
    use super::*;

    #[test]
    fn json_carries_what_is_printed_and_quoted() {
        let mut table = Table::new(vec![
            Column::new("gamma", "gamma", Format::Significant(3), "constant"),
            Column::hidden("error"),
        ]);
        table.push(vec![0.291_557.into(), 1e-9.into()]);
        let mut headline = Headline::new("Lemma 5.2", "claim", table, "much", Verdict::Holds);
        headline.quote("gamma.one", 0.291_557);
        let json: Value = serde_json::from_str(&headline.json()).unwrap();
        assert_eq!(json["values"]["gamma.one"], 0.291_557);
        assert_eq!(json["rows"], json!([["0.292"]]));
        assert_eq!(json["columns"][0]["meaning"], "constant");
        assert_eq!(json["verdict"], "holds");
    }
}
