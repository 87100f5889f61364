//! The outcome of an example: claim, table, findings, where its figures are; verdict and measured line
//! follow.

use super::finding::{Finding, Outcome};
use super::table::{Column, Table, wrapped};
use super::verdict::Verdict;
use crate::figures::Chart;
use crate::{Output, Result};
use serde_json::{Map, Value, json};
use std::fmt;
use std::path::PathBuf;

/// Lines of words are broken at this width.
const WIDTH: usize = 100;
/// Where the words after "measured:" and "verdict:" begin.
const INDENT: usize = 10;
/// Where the words of a finding begin, after its outcome.
const FINDING: usize = 13;
/// More findings than these are not all listed in the text: those that hold and are not told are counted.
const LISTED: usize = 10;

/// Everything an example has to say, as data: printed, written as JSON, tested, and quoted by the book.
#[derive(Debug, Clone, PartialEq)]
pub struct Headline {
    /// The paper's label, for example "Lemma 5.2".
    pub label: String,
    /// The statement in one line.
    pub claim: String,
    /// The rows.
    pub table: Table,
    /// What was found, each sentence decided by a number.
    pub findings: Vec<Finding>,
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
        findings: Vec<Finding>,
    ) -> Self {
        let (label, claim) = (label.into(), claim.into());
        Self { label, claim, table, findings, figures: Vec::new(), values: Vec::new() }
    }

    /// Adds a number to be quoted under `key`.
    pub fn quote(&mut self, key: impl Into<String>, value: f64) {
        self.values.push((key.into(), value));
    }

    /// Adds a number and its uncertainty, under `key` and `key.uncertainty`.
    pub fn quote_with(&mut self, key: &str, value: f64, uncertainty: f64) {
        self.quote(key, value);
        self.quote(format!("{key}.uncertainty"), uncertainty);
    }

    /// Adds the number of a finding to be quoted under another key, where there is one.
    pub fn quote_found(&mut self, finding: &str, key: impl Into<String>) {
        if let Some((value, _)) = self.finding(finding).and_then(Finding::measured) {
            self.quote(key, value);
        }
    }

    /// Draws and saves a chart as `name.svg` where figures are asked for; `chart` is not called otherwise.
    ///
    /// # Errors
    /// Those of the drawing and of the file.
    pub fn draw(&mut self, output: &Output, name: &str, chart: impl FnOnce() -> Result<Chart>) -> Result<()> {
        if let Some(directory) = output.directory()? {
            self.figures.push(chart()?.save(directory, name)?);
        }
        Ok(())
    }

    /// What the findings say of the statement.
    pub fn verdict(&self) -> Verdict {
        Verdict::of(&self.findings)
    }

    /// The words of the findings that are told; of the first one where none is.
    pub fn measured(&self) -> String {
        let told: Vec<String> = self.findings.iter().filter(|f| f.is_told()).map(Finding::words).collect();
        if told.is_empty() {
            return self.findings.first().map_or_else(|| "nothing".to_owned(), Finding::words);
        }
        told.join("; ")
    }

    /// How many findings have this outcome.
    pub fn count(&self, outcome: Outcome) -> usize {
        self.findings.iter().filter(|f| f.outcome() == outcome).count()
    }

    /// The finding with this key.
    pub fn finding(&self, key: &str) -> Option<&Finding> {
        self.findings.iter().find(|f| f.key() == key)
    }

    /// 0 where every claim holds, 1 where one is refuted or undecided.
    pub fn exit_code(&self) -> u8 {
        u8::from(!self.verdict().is_confirmed())
    }

    /// One JSON object per row of the table, then one per finding (told apart by the key `finding`).
    pub fn json_lines(&self) -> String {
        let findings = self.findings.iter().map(|f| f.json().to_string());
        self.table.json_rows().into_iter().chain(findings).map(|line| line + "\n").collect()
    }

    /// All of it but the figures as one JSON object: `label`, `claim`, `measured`, `verdict`, `confirmed`,
    /// `findings`, `values` by key, and the table as it is printed (`columns`, `rows`). Numbers carry all
    /// their digits.
    pub fn json(&self) -> String {
        // What is not finite cannot be quoted: a page that does so fails by its key.
        let finite = self.values.iter().filter(|(_, value)| value.is_finite());
        let values: Map<String, Value> = finite.map(|(k, v)| (k.clone(), json!(v))).collect();
        let column = |c: &Column| json!({"key": c.key(), "title": c.title(), "meaning": c.meaning()});
        let columns: Vec<Value> = self.table.shown_columns().map(column).collect();
        json!({
            "label": self.label,
            "claim": self.claim,
            "measured": self.measured(),
            "verdict": self.verdict().to_string(),
            "confirmed": self.verdict().is_confirmed(),
            "findings": self.findings.iter().map(Finding::json).collect::<Vec<_>>(),
            "values": values,
            "columns": columns,
            "rows": self.table.text_rows(),
        })
        .to_string()
    }

    /// The findings, decision first; of many only what is not simply true, and how many more hold.
    fn write_findings(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "findings:")?;
        let all = self.findings.len() <= LISTED;
        let (mut unlisted, hanging) = (0, format!("\n{:FINDING$}", ""));
        for finding in &self.findings {
            let outcome = finding.outcome();
            if !all && outcome == Outcome::Holds && !finding.is_told() {
                unlisted += 1;
                continue;
            }
            let words = format!("{} [{}]", finding.words(), finding.comparison());
            writeln!(f, "  {outcome:<10} {}", wrapped(&words, WIDTH - FINDING).join(&hanging))?;
        }
        if unlisted > 0 {
            writeln!(f, "  {:<10} {unlisted} more (all of them with --json)", Outcome::Holds)?;
        }
        Ok(())
    }
}

impl fmt::Display for Headline {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{}\n", wrapped(&format!("{}: {}", self.label, self.claim), WIDTH).join("\n"))?;
        writeln!(f, "{}", self.table.text())?;
        self.write_findings(f)?;
        for (name, words) in [("measured:", self.measured()), ("verdict: ", self.verdict().to_string())] {
            let hanging = format!("\n{:INDENT$}", "");
            writeln!(f, "{name} {}", wrapped(&words, WIDTH - INDENT).join(&hanging))?;
        }
        for figure in &self.figures {
            writeln!(f, "figure:   {}", figure.display())?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::super::Format;
    use super::*;

    #[test]
    fn json_carries_what_is_printed_found_and_quoted() {
        let mut table = Table::new(vec![
            Column::new("gamma", "gamma", Format::Significant(3), "constant"),
            Column::hidden("error"),
        ]);
        table.push(vec![0.291_557.into(), 1e-9.into()]);
        let found = Finding::claim("gamma", "much").number(0.291_557, 1e-9).at_most(0.5, "(5.1)");
        let mut headline = Headline::new("Lemma 5.2", "claim", table, vec![found]);
        headline.quote("gamma.one", 0.291_557);
        headline.quote("gamma.none", f64::INFINITY);
        let json: Value = serde_json::from_str(&headline.json()).unwrap();
        assert_eq!(json["values"], json!({"gamma.one": 0.291_557}));
        assert_eq!(json["rows"], json!([["0.292"]]));
        assert_eq!(json["columns"][0]["meaning"], "constant");
        assert_eq!(json["verdict"], "holds");
        assert_eq!(json["findings"][0]["outcome"], "holds");
        assert_eq!(headline.json_lines().lines().count(), 2);
        assert!(headline.to_string().contains("much [0.2915570000 +- 1e-9 <= 0.5, (5.1)]"), "{headline}");
    }

    #[test]
    fn of_many_findings_only_the_telling_ones_are_listed() {
        let found = |k: usize| Finding::claim(format!("k{k}"), "so").number(1.0, 0.0).at_most(2.0, "");
        let mut findings: Vec<Finding> = (0..20).map(found).collect();
        findings[3] = findings[3].with_number(3.0, 0.0);
        let headline = Headline::new("a", "b", Table::default(), findings);
        assert!(headline.to_string().contains("19 more"), "{headline}");
        assert_eq!(headline.exit_code(), 1);
        assert_eq!(headline.count(Outcome::Refuted), 1);
    }
}
