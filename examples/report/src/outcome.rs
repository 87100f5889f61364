//! Results of an example: rows, checks, status; as JSON for the book.

use crate::cell::{Cells, column};
use crate::check::{Checked, Decision, Role};
use crate::plot::Picture;
use crate::words::GREEK;
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
    /// The name of the status.
    pub fn word(self) -> &'static str {
        match self {
            Verdict::True => "true",
            Verdict::Loose => "loose",
            Verdict::NotSharp => "not sharp",
            Verdict::FalseAsPrinted => "false as printed",
            Verdict::Open => "open",
            Verdict::Undecided => "undecided",
            Verdict::Fails => "fails",
        }
    }

    /// The status that follows from these checks.
    pub fn of(checks: &[Checked]) -> Self {
        let has = |role: Role, decision: Decision| {
            checks.iter().any(|c| c.role() == role && c.decision() == decision)
        };
        if has(Role::Claim, Decision::Fails) {
            Verdict::Fails
        } else if has(Role::Claim, Decision::Undecided) {
            Verdict::Undecided
        } else if !has(Role::Claim, Decision::Holds) {
            Verdict::Open
        } else if has(Role::AsPrinted, Decision::Fails) {
            Verdict::FalseAsPrinted
        } else if has(Role::NotSharp, Decision::Holds) {
            Verdict::NotSharp
        } else if has(Role::Stronger, Decision::Holds) {
            Verdict::Loose
        } else {
            Verdict::True
        }
    }

    /// True if every claim holds and at least one was decided by a number.
    pub fn is_confirmed(self) -> bool {
        !matches!(self, Verdict::Fails | Verdict::Undecided | Verdict::Open)
    }
}

/// The results of an example: rows, checks, quoted numbers and pictures.
#[derive(Debug, Clone)]
pub struct Outcome {
    pub(crate) label: String,
    pub(crate) statement: String,
    pub(crate) rows: Vec<Cells>,
    pub(crate) checks: Vec<Checked>,
    pub(crate) notes: Vec<(String, f64)>,
    pub(crate) columns: Vec<(&'static str, &'static str, &'static str)>,
    pub(crate) pictures: Vec<Picture>,
    pub(crate) saved: Vec<PathBuf>,
    pub(crate) remark: String,
    pub(crate) seconds: f64,
}

impl Outcome {
    /// The paper's label.
    pub fn label(&self) -> &str {
        &self.label
    }

    /// The status that follows from the checks.
    pub fn status(&self) -> Verdict {
        Verdict::of(&self.checks)
    }

    /// All checks, in the order in which they were first reported.
    pub fn checks(&self) -> &[Checked] {
        &self.checks
    }

    /// The check with this key; `None` if there is none.
    pub fn check(&self, key: &str) -> Option<&Checked> {
        self.checks.iter().find(|check| check.key() == key)
    }

    /// The outcome with one check replaced, for fault injection in tests.
    #[must_use]
    pub fn with_check(&self, at: usize, check: Checked) -> Self {
        let mut changed = self.clone();
        changed.checks[at] = check;
        changed
    }

    /// Fault injection: moves the number of each check across its bound and back, and verifies that its mark,
    /// the status and the exit code change accordingly.
    ///
    /// # Errors
    /// [`Error::Option`] with the first check for which they do not change, or which has no source or no
    /// unique key.
    pub(crate) fn turns(&self) -> Result<()> {
        let fault = |label: &str, what: &str| Err(Error::option("fault", &format!("{label}: {what}")));
        let keys: BTreeSet<String> = self.checks.iter().map(Checked::key).collect();
        if keys.len() < self.checks.len() {
            return fault(&self.label, "two checks have the same key");
        }
        let by_number = |(_, check): &(usize, &Checked)| check.decision() != Decision::ByProof;
        for (at, check) in self.checks.iter().enumerate().filter(by_number) {
            let label = format!("{}: {}", check.key(), check.comparison());
            if check.source().is_empty() {
                return fault(&label, "a bound without a source");
            }
            let mut lines = BTreeSet::new();
            for wanted in [Decision::Holds, Decision::Fails, Decision::Undecided] {
                let moved = check.moved(wanted);
                lines.insert(format!("{} {}", wanted.mark(), moved.comparison()));
                let (is_moved, changed) = (moved.decision() == wanted, self.with_check(at, moved));
                if !is_moved || !changed.follows(check.role(), wanted) {
                    return fault(&label, &format!("{wanted:?} gives {}", changed.status().word()));
                }
            }
            if lines.len() < 3 {
                return fault(&label, "two decisions print the same line");
            }
        }
        Ok(())
    }

    /// True if status and exit code agree with one check of this role and decision when all others hold.
    fn follows(&self, role: Role, decision: Decision) -> bool {
        let (status, code) = (self.status(), self.exit_code());
        match (role, decision) {
            (Role::Claim, Decision::Fails) => code == 1 && status == Verdict::Fails,
            (Role::Claim, Decision::Undecided) => code == 1 && status == Verdict::Undecided,
            (Role::AsPrinted, Decision::Fails) => code == 0 && status == Verdict::FalseAsPrinted,
            (Role::NotSharp, Decision::Holds) => {
                code == 0 && matches!(status, Verdict::NotSharp | Verdict::FalseAsPrinted)
            }
            (Role::Stronger, Decision::Holds) => {
                code == 0 && !matches!(status, Verdict::True | Verdict::Open)
            }
            _ => code == 0,
        }
    }

    /// Moves the number of a check across its bound.
    ///
    /// # Errors
    /// [`Error::Option`] where no check has this key.
    pub(crate) fn plant(&mut self, key: &str) -> Result<()> {
        let known: Vec<String> = self.checks.iter().map(Checked::key).collect();
        let check = self.checks.iter_mut().find(|check| check.key() == key);
        let check =
            check.ok_or_else(|| Error::option("fault", &format!("expected one of {}", known.join(", "))))?;
        *check = check.moved(Decision::Fails);
        Ok(())
    }

    /// 0 if every claim holds; 1 if one fails or is undecided, or if none was decided by a number.
    pub fn exit_code(&self) -> u8 {
        u8::from(!self.status().is_confirmed())
    }

    /// The number under this key: `column.row`, `column.row.error`, the key of a note or of a check; `None`
    /// if there is none or it is not finite.
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
        values.extend(self.checks.iter().map(|check| (check.key(), check.value().value)));
        // What is not finite cannot be quoted: a page that does so fails by its key.
        values.retain(|(_, value)| value.is_finite());
        values
    }

    /// The numbers of a column, in the order of the rows; NaN for a row without one.
    pub fn numbers(&self, name: &str) -> Vec<f64> {
        self.rows.iter().map(|row| row.number(name)).collect()
    }

    /// The title of a column.
    pub(crate) fn title(&self, name: &str) -> String {
        let given =
            self.columns.iter().find(|(known, ..)| *known == name).map(|(_, title, _)| (*title).to_owned());
        given.unwrap_or_else(|| {
            let greek = |word: &str| {
                GREEK
                    .iter()
                    .find(|(_, known)| *known == word)
                    .map_or(word.to_owned(), |(letter, _)| letter.to_string())
            };
            let words: Vec<String> = name.replace("_over_", "_/_").split('_').map(greek).collect();
            words.join(" ").replace(" / ", "/").replace("over ", "/ ").replace(" 0", "₀").replace(" 1", "₁")
        })
    }

    /// Titles with meanings and names, and the cells of every row as texts.
    pub(crate) fn table(&self) -> (Vec<[String; 3]>, Vec<Vec<String>>) {
        let mut names: Vec<&'static str> = Vec::new();
        for (name, _) in self.rows.iter().flat_map(Cells::all) {
            if !names.contains(name) {
                names.push(name);
            }
        }
        let missing = crate::Cell::Missing;
        let mut titles = Vec::new();
        let mut rows = vec![Vec::new(); self.rows.len()];
        for name in names {
            let cells: Vec<&crate::Cell> =
                self.rows.iter().map(|row| row.get(name).unwrap_or(&missing)).collect();
            let meaning =
                self.columns.iter().find(|(known, ..)| *known == name).map_or("", |(.., meaning)| meaning);
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

    /// Draws every picture and writes it to the directory.
    ///
    /// # Errors
    /// [`Error::Figure`] if a picture cannot be drawn, [`Error::File`] if a file cannot be written.
    pub fn save_pictures(&mut self, directory: &Path) -> Result<()> {
        for picture in &self.pictures {
            let path = match picture {
                Picture::Plot(plot) => {
                    plot.chart(&self.rows, &|name| self.title(name)).save(directory, &plot.name)?
                }
                Picture::Chart(name, chart) => chart.save(directory, name)?,
                Picture::Svg(name, svg) => crate::figures::save_svg(svg, directory, name)?,
            };
            self.saved.push(path);
        }
        Ok(())
    }

    /// One JSON object per row, then one per check, which has the key `finding`.
    pub fn json_lines(&self) -> String {
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

    /// The outcome without its pictures as one JSON object: `label`, `claim`, `measured`, `verdict`,
    /// `confirmed`, `findings`, `values` by key, and the table as it is printed (`columns`, `rows`).
    pub fn json(&self) -> String {
        let values: Map<String, Value> =
            self.values().into_iter().map(|(key, value)| (key, json!(value))).collect();
        let (titles, rows) = self.table();
        let columns: Vec<Value> = titles
            .iter()
            .map(|[title, meaning, key]| json!({"key": key, "title": title, "meaning": meaning}))
            .collect();
        json!({
            "label": self.label,
            "claim": self.statement,
            "measured": self.measured(),
            "verdict": self.status().word(),
            "confirmed": self.status().is_confirmed(),
            "findings": self.checks.iter().map(Checked::json).collect::<Vec<_>>(),
            "values": values,
            "columns": columns,
            "rows": rows,
        })
        .to_string()
    }

    /// The checks that a number decided, as text.
    fn measured(&self) -> String {
        let told = self
            .checks
            .iter()
            .filter(|check| check.decision() != Decision::ByProof && check.role() != Role::Observed);
        told.map(Checked::words).collect::<Vec<_>>().join("; ")
    }
}
