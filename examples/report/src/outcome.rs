//! Results of an example: rows, checks, status; as JSON for the book.

use crate::cell::{Cell, Cells, column};
use crate::check::{Checked, Decision, Role};
use crate::figures::Plot;
use crate::files::write_whole;
use crate::words::greek;
use crate::{Error, Result};
use serde_json::{Map, Value, json};
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

/// The status of a statement, from its checks.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Verdict {
    /// Every check holds.
    True,
    /// True, and a stronger statement is true too.
    Loose,
    /// True, but the rate of growth is different.
    NotSharp,
    /// True in a corrected form; false as printed.
    FalseAsPrinted,
    /// No number was compared.
    Open,
    /// A check is undecided within the errors.
    Undecided,
    /// A check fails.
    Fails,
}

impl Verdict {
    /// True if every claim holds and at least one was decided by a number.
    pub fn is_confirmed(self) -> bool {
        !matches!(self, Verdict::Fails | Verdict::Undecided | Verdict::Open)
    }
}

impl std::fmt::Display for Verdict {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Verdict::True => "true",
            Verdict::Loose => "loose",
            Verdict::NotSharp => "not sharp",
            Verdict::FalseAsPrinted => "false as printed",
            Verdict::Open => "open",
            Verdict::Undecided => "undecided",
            Verdict::Fails => "fails",
        })
    }
}

/// The results of an example: rows, checks, quoted numbers and pictures.
#[derive(Debug, Clone, Default)]
pub struct Outcome {
    pub(crate) label: &'static str,
    pub(crate) statement: &'static str,
    pub(crate) rows: Vec<Cells>,
    pub(crate) checks: Vec<Checked>,
    pub(crate) notes: Vec<(String, f64)>,
    /// Name, title and meaning of columns.
    pub(crate) columns: Vec<(&'static str, &'static str, &'static str)>,
    pub(crate) bodies: Vec<(String, String)>,
    pub(crate) plots: Vec<Plot>,
    pub(crate) saved: Vec<PathBuf>,
    pub(crate) remark: String,
    pub(crate) seconds: f64,
}

impl Outcome {
    /// The status that follows from the checks.
    pub fn status(&self) -> Verdict {
        if self.has(Role::Claim, Decision::Fails) {
            Verdict::Fails
        } else if self.has(Role::Claim, Decision::Undecided) {
            Verdict::Undecided
        } else if !self.has(Role::Claim, Decision::Holds) {
            Verdict::Open
        } else if self.has(Role::AsPrinted, Decision::Fails) {
            Verdict::FalseAsPrinted
        } else if self.has(Role::NotSharp, Decision::Holds) {
            Verdict::NotSharp
        } else if self.has(Role::Stronger, Decision::Holds) {
            Verdict::Loose
        } else {
            Verdict::True
        }
    }

    /// True if a check of this role has this decision.
    pub fn has(&self, role: Role, decision: Decision) -> bool {
        self.checks.iter().any(|check| check.role == role && check.decision() == decision)
    }

    /// The ranges in which forms that fail as printed are true, such as "for θ ≤ 1/2".
    pub fn corrections(&self) -> Vec<&str> {
        let mut ranges: Vec<&str> = Vec::new();
        for check in &self.checks {
            let fails = check.role == Role::AsPrinted && check.decision() == Decision::Fails;
            if fails && !ranges.contains(&check.source.as_str()) {
                ranges.push(&check.source);
            }
        }
        ranges
    }

    /// All checks, in the order in which they were first reported.
    pub fn checks(&self) -> &[Checked] {
        &self.checks
    }

    /// The check with this key; `None` if there is none.
    pub fn check(&self, key: &str) -> Option<&Checked> {
        self.checks.iter().find(|check| check.key() == key)
    }

    /// Fault injection: moves the number of each check across its bound and back, and verifies that
    /// its mark, the status and the exit code change accordingly.
    ///
    /// # Errors [`Error::Option`] with the first check for which they do not change, or which has
    /// no source or no unique key.
    pub(crate) fn turns(&self) -> Result<()> {
        let fault =
            |label: &str, what: &str| Err(Error::option("fault", &format!("{label}: {what}")));
        let keys: BTreeSet<String> = self.checks.iter().map(Checked::key).collect();
        if keys.len() < self.checks.len() {
            return fault(self.label, "two checks have the same key");
        }
        let by_number = |(_, check): &(usize, &Checked)| check.decision() != Decision::ByProof;
        for (at, check) in self.checks.iter().enumerate().filter(by_number) {
            let label = format!("{}: {}", check.key(), check.comparison());
            if check.source.is_empty() {
                return fault(&label, "a bound without a source");
            }
            let mut lines = BTreeSet::new();
            for wanted in [Decision::Holds, Decision::Fails, Decision::Undecided] {
                let mut changed = self.clone();
                changed.checks[at] = check.moved(wanted);
                let moved = &changed.checks[at];
                lines.insert(format!("{} {}", wanted.mark_and_word().0, moved.comparison()));
                if moved.decision() != wanted || !changed.follows(check.role, wanted) {
                    return fault(&label, &format!("{wanted:?} gives {}", changed.status()));
                }
            }
            if lines.len() < 3 {
                return fault(&label, "two decisions print the same line");
            }
        }
        Ok(())
    }

    /// True if the status is one that follows from a check of this role and decision when all
    /// others hold.
    fn follows(&self, role: Role, decision: Decision) -> bool {
        use Verdict::{Fails, FalseAsPrinted, Loose, NotSharp, True, Undecided};
        let expected: &[Verdict] = match (role, decision) {
            (Role::Claim, Decision::Fails) => &[Fails],
            (Role::Claim, Decision::Undecided) => &[Undecided],
            (Role::AsPrinted, Decision::Fails) => &[FalseAsPrinted],
            (Role::NotSharp, Decision::Holds) => &[NotSharp, FalseAsPrinted],
            (Role::Stronger, Decision::Holds) => &[Loose, NotSharp, FalseAsPrinted],
            _ => &[True, Loose, NotSharp, FalseAsPrinted],
        };
        let fails =
            role == Role::Claim && matches!(decision, Decision::Fails | Decision::Undecided);
        expected.contains(&self.status()) && self.exit_code() == u8::from(fails)
    }

    /// Moves the number of a check across its bound; an error where no check has this key.
    pub(crate) fn plant(&mut self, key: &str) -> Result<()> {
        let keys: Vec<String> = self.checks.iter().map(Checked::key).collect();
        let Some(at) = keys.iter().position(|known| known == key) else {
            return Err(Error::option("fault", &format!("expected one of {}", keys.join(", "))));
        };
        self.checks[at] = self.checks[at].moved(Decision::Fails);
        Ok(())
    }

    /// 0 if every claim holds; 1 if one fails or is undecided, or if none was decided by a number.
    pub fn exit_code(&self) -> u8 {
        u8::from(!self.status().is_confirmed())
    }

    /// The number under this key: `column.row`, `column.row.error`, the key of a note or of a
    /// check; `None` if there is none or it is not finite.
    pub fn value(&self, key: &str) -> Option<f64> {
        self.values().into_iter().find(|(known, _)| known == key).map(|(_, value)| value)
    }

    /// All finite numbers that pages may quote, with their keys as in [`Outcome::value`].
    pub fn values(&self) -> Vec<(String, f64)> {
        let mut values = Vec::new();
        for row in &self.rows {
            let key = row.key();
            for (name, cell) in &row.found {
                let number = cell.number();
                let key = if key.is_empty() { (*name).to_owned() } else { format!("{name}.{key}") };
                values.push((key.clone(), number.value));
                if number.error > 0.0 {
                    values.push((format!("{key}.error"), number.error));
                }
            }
        }
        values.extend(self.notes.iter().cloned());
        values.extend(self.checks.iter().map(|check| (check.key(), check.value.value)));
        // What is not finite cannot be quoted: a page that does so fails by its key.
        values.retain(|(_, value)| value.is_finite());
        values
    }

    /// The numbers of a column, in the order of the rows; NaN for a row without one.
    pub fn numbers(&self, name: &str) -> Vec<f64> {
        self.rows.iter().map(|row| row.number(name)).collect()
    }

    /// The title of a column.
    fn title(&self, name: &str) -> String {
        if let Some((_, title, _)) = self.columns.iter().find(|(known, ..)| *known == name) {
            return (*title).to_owned();
        }
        let name = name.replace("_over_", "_/_");
        let letter =
            |word| greek().find(|(_, known)| *known == word).map_or(word, |(letter, _)| letter);
        let words: Vec<&str> = name.split('_').map(letter).collect();
        words
            .join(" ")
            .replace(" / ", "/")
            .replace("over ", "/ ")
            .replace(" 0", "₀")
            .replace(" 1", "₁")
    }

    /// Titles with meanings and names, and the cells of every row as texts.
    pub(crate) fn table(&self) -> (Vec<[String; 3]>, Vec<Vec<String>>) {
        let mut names: Vec<&'static str> = Vec::new();
        for (name, _) in self.rows.iter().flat_map(Cells::all) {
            if !names.contains(name) {
                names.push(name);
            }
        }
        let mut titles = Vec::new();
        let mut rows = vec![Vec::new(); self.rows.len()];
        for name in names {
            let cells: Vec<&Cell> =
                self.rows.iter().map(|row| row.get(name).unwrap_or(&Cell::Missing)).collect();
            let meaning = self
                .columns
                .iter()
                .find(|(known, ..)| *known == name)
                .map_or("", |(.., meaning)| meaning);
            for (k, texts) in column(&cells).into_iter().enumerate() {
                titles.push(if k == 0 {
                    [self.title(name), meaning.to_owned(), name.to_owned()]
                } else {
                    ["±".to_owned(), String::new(), format!("{name}_error")]
                });
                rows.iter_mut().zip(texts).for_each(|(row, text)| row.push(text));
            }
        }
        (titles, rows)
    }

    /// Draws every picture and writes it to the directory, a plot with its points as
    /// comma-separated values.
    ///
    /// # Errors
    /// [`Error::File`] if a file cannot be written.
    pub(crate) fn save_pictures(&mut self, directory: &Path) -> Result<()> {
        let place = |name: &str, ending: &str| directory.join(format!("{name}.{ending}"));
        for (name, svg) in &self.bodies {
            write_whole(&place(name, "svg"), svg)?;
            self.saved.push(place(name, "svg"));
        }
        for plot in &self.plots {
            let [svg, csv] = plot.files(&self.rows, &|name| self.title(name))?;
            write_whole(&place(&plot.name, "csv"), &csv)?;
            write_whole(&place(&plot.name, "svg"), &svg)?;
            self.saved.push(place(&plot.name, "svg"));
        }
        Ok(())
    }

    /// One JSON object per row, then one per check, which has the key `finding`.
    pub(crate) fn json_lines(&self) -> String {
        let row = |row: &Cells| {
            let mut object = Map::new();
            for (name, cell) in row.all() {
                object.insert((*name).to_owned(), cell.json());
                let error = cell.number().error;
                if error > 0.0 && error.is_finite() {
                    object.insert(format!("{name}_error"), json!(error));
                }
            }
            Value::Object(object)
        };
        let lines = self.rows.iter().map(row).chain(self.checks.iter().map(Checked::json));
        lines.map(|line| format!("{line}\n")).collect()
    }

    /// The outcome without its pictures as one JSON object: `label`, `claim`, `measured`,
    /// `verdict`, `confirmed`, `findings`, `values` by key, and the table as it is printed
    /// (`columns`, `rows`).
    pub(crate) fn json(&self) -> String {
        let values: Map<String, Value> =
            self.values().into_iter().map(|(key, value)| (key, json!(value))).collect();
        let (titles, rows) = self.table();
        let column = |words: &[String; 3]| {
            let [title, meaning, key] = words;
            json!({"key": key, "title": title, "meaning": meaning})
        };
        let is_told = |check: &&Checked| {
            check.decision() != Decision::ByProof && check.role != Role::Observed
        };
        let told: Vec<String> = self.checks.iter().filter(is_told).map(Checked::words).collect();
        json!({
            "label": self.label,
            "claim": self.statement,
            "measured": told.join("; "),
            "verdict": self.status().to_string(),
            "confirmed": self.status().is_confirmed(),
            "findings": self.checks.iter().map(Checked::json).collect::<Vec<_>>(),
            "values": values,
            "columns": titles.iter().map(column).collect::<Vec<_>>(),
            "rows": rows,
        })
        .to_string()
    }
}
