//! Tables with explained columns: aligned text, or one JSON object per row with all digits.

use super::cell::{Cell, Format};
use super::missing::{UNKNOWN, reason};
use serde_json::{Map, Value};
use std::fmt::Write as _;

/// A column: its key in JSON, its title, how it is printed and what it means.
#[derive(Debug, Clone, PartialEq)]
pub struct Column {
    key: &'static str,
    title: String,
    format: Format,
    meaning: String,
    wrap: Option<usize>,
}

impl Column {
    /// A column with `key` in JSON and `title` in text; `meaning` is printed below the table unless empty.
    pub fn new(
        key: &'static str,
        title: impl Into<String>,
        format: Format,
        meaning: impl Into<String>,
    ) -> Self {
        Self { key, title: title.into(), format, meaning: meaning.into(), wrap: None }
    }

    /// A column that appears in JSON only.
    pub fn hidden(key: &'static str) -> Self {
        Self::new(key, key, Format::Hidden, "")
    }

    /// A column of words, broken into lines of at most `width` characters.
    pub fn words(key: &'static str, title: impl Into<String>, width: usize) -> Self {
        Self { wrap: Some(width.max(1)), ..Self::new(key, title, Format::Significant(6), "") }
    }

    /// The key in JSON.
    pub fn key(&self) -> &'static str {
        self.key
    }

    /// The title in text.
    pub fn title(&self) -> &str {
        &self.title
    }

    /// What the column means; may be empty.
    pub fn meaning(&self) -> &str {
        &self.meaning
    }

    /// The lines of a cell of this column.
    fn lines(&self, cell: &Cell) -> Vec<String> {
        let text = cell.text(self.format);
        self.wrap.map_or_else(|| vec![text.clone()], |width| wrapped(&text, width))
    }

    fn is_shown(&self) -> bool {
        self.format != Format::Hidden
    }
}

/// Rows of cells under explained columns.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Table {
    columns: Vec<Column>,
    rows: Vec<Vec<Cell>>,
}

impl Table {
    /// A table without rows.
    pub fn new(columns: Vec<Column>) -> Self {
        Self { columns, rows: Vec::new() }
    }

    /// The same table with these rows appended; each cell from a number, count, words or nothing.
    #[must_use]
    pub fn with_rows<R, C>(mut self, rows: impl IntoIterator<Item = R>) -> Self
    where
        R: IntoIterator<Item = C>,
        C: Into<Cell>,
    {
        rows.into_iter().for_each(|row| self.push(row.into_iter().map(Into::into).collect()));
        self
    }

    /// Appends a row. Missing cells are filled with [`Cell::Missing`], surplus ones dropped.
    pub fn push(&mut self, mut row: Vec<Cell>) {
        row.resize(self.columns.len(), Cell::Missing);
        self.rows.push(row);
    }

    /// The columns.
    pub fn columns(&self) -> &[Column] {
        &self.columns
    }

    /// The rows, each as long as the columns.
    pub fn rows(&self) -> &[Vec<Cell>] {
        &self.rows
    }

    /// The number in the given row under the column with the given key.
    pub fn number(&self, row: usize, key: &str) -> Option<f64> {
        let column = self.columns.iter().position(|c| c.key == key)?;
        match self.rows.get(row)?.get(column)? {
            Cell::Number(value) => Some(*value),
            Cell::Integer(value) => Some(*value as f64),
            _ => None,
        }
    }

    /// One JSON object per row, keys in the order of the columns; numbers with all their digits. Why there is
    /// a null stands beside it, `"missing": {key: reason}`.
    pub fn json_rows(&self) -> Vec<String> {
        self.rows.iter().map(|row| self.json_row(row).to_string()).collect()
    }

    /// The rows as comma-separated values under the keys of the columns, numbers with all their digits, the
    /// numbers of a list apart by blanks; nothing where an entry is missing.
    pub fn csv(&self) -> String {
        let keys: Vec<&str> = self.columns.iter().map(|column| column.key).collect();
        let mut text = keys.join(",") + "\n";
        for row in &self.rows {
            let cells: Vec<String> = row.iter().map(Cell::csv).collect();
            text += &(cells.join(",") + "\n");
        }
        text
    }

    fn json_row(&self, row: &[Cell]) -> Value {
        let cells = || self.columns.iter().zip(row);
        let entries = cells().map(|(column, cell)| (column.key.to_owned(), cell.json()));
        let mut object: Map<_, _> = entries.collect();
        let reasons = cells().filter_map(|(column, cell)| {
            Some((column.key.to_owned(), Value::from(cell.why_missing(reason(column.key))?)))
        });
        let reasons: Map<_, _> = reasons.collect();
        if !reasons.is_empty() {
            object.insert("missing".to_owned(), Value::Object(reasons));
        }
        Value::Object(object)
    }

    /// Keys of columns with a missing entry and no word why.
    pub fn unexplained(&self) -> Vec<&'static str> {
        let is_bare = |(j, column): &(usize, &Column)| {
            self.rows.iter().any(|row| row[*j].why_missing(reason(column.key)) == Some(UNKNOWN))
        };
        self.columns.iter().enumerate().filter(is_bare).map(|(_, column)| column.key).collect()
    }

    /// The columns that appear in the text form.
    pub fn shown_columns(&self) -> impl Iterator<Item = &Column> {
        self.columns.iter().filter(|column| column.is_shown())
    }

    /// The rows as they appear in the text form, unwrapped, one entry per shown column.
    pub fn text_rows(&self) -> Vec<Vec<String>> {
        let shown = |row: &Vec<Cell>| {
            let cells = row.iter().zip(&self.columns).filter(|(_, column)| column.is_shown());
            cells.map(|(cell, column)| cell.text(column.format)).collect()
        };
        self.rows.iter().map(shown).collect()
    }

    /// Aligned text: numbers to the right, words to the left, explanations of the columns below.
    pub fn text(&self) -> String {
        let shown: Vec<usize> = (0..self.columns.len()).filter(|&j| self.columns[j].is_shown()).collect();
        let cells: Vec<Vec<Vec<String>>> = self
            .rows
            .iter()
            .map(|row| shown.iter().map(|&j| self.columns[j].lines(&row[j])).collect())
            .collect();
        let layout: Vec<(usize, bool)> = shown
            .iter()
            .enumerate()
            .map(|(k, &j)| {
                let longest = cells.iter().flat_map(|row| &row[k]).map(|line| line.chars().count()).max();
                let width = longest.unwrap_or(0).max(self.columns[j].title.chars().count());
                let is_words = self.rows.iter().any(|row| matches!(row[j], Cell::Text(_) | Cell::List(_)));
                (width, is_words)
            })
            .collect();
        let mut text = String::new();
        let titles: Vec<String> = shown.iter().map(|&j| self.columns[j].title.clone()).collect();
        push_line(&mut text, &titles, &layout);
        let rule: Vec<String> = layout.iter().map(|&(width, _)| "-".repeat(width)).collect();
        push_line(&mut text, &rule, &layout);
        for row in &cells {
            for line in 0..row.iter().map(Vec::len).max().unwrap_or(0) {
                let part: Vec<String> =
                    row.iter().map(|c| c.get(line).cloned().unwrap_or_default()).collect();
                push_line(&mut text, &part, &layout);
            }
        }
        for &j in &shown {
            let Column { title, meaning, .. } = &self.columns[j];
            if !meaning.is_empty() {
                let _ = writeln!(text, "  {title}: {meaning}");
            }
        }
        text
    }
}

fn push_line(text: &mut String, cells: &[String], layout: &[(usize, bool)]) {
    let padded: Vec<String> = cells
        .iter()
        .zip(layout)
        .map(
            |(cell, &(width, words))| {
                if words { format!("{cell:<width$}") } else { format!("{cell:>width$}") }
            },
        )
        .collect();
    text.push_str(padded.join("  ").trim_end());
    text.push('\n');
}

/// Greedy line breaking at spaces; a longer word stands alone on its line.
pub(super) fn wrapped(words: &str, width: usize) -> Vec<String> {
    let mut lines = vec![String::new()];
    for word in words.split_whitespace() {
        let Some(line) = lines.last_mut() else { break };
        if line.is_empty() {
            line.push_str(word);
        } else if line.chars().count() + 1 + word.chars().count() <= width {
            line.push(' ');
            line.push_str(word);
        } else {
            lines.push(word.to_owned());
        }
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_is_aligned_and_json_keeps_digits() {
        let mut table = Table::new(vec![
            Column::new("nu", "nu", Format::Significant(3), "order"),
            Column::new("gamma", "gamma", Format::Significant(7), ""),
            Column::hidden("error"),
        ]);
        table.push(vec![0.5.into(), std::f64::consts::PI.into(), 1e-300.into()]);
        let text = table.text();
        assert_eq!(text.lines().nth(2), Some("0.500  3.141593"));
        assert!(text.ends_with("nu: order\n"));
        assert_eq!(table.json_rows()[0], r#"{"nu":0.5,"gamma":3.141592653589793,"error":1e-300}"#);
        assert_eq!(table.number(0, "error"), Some(1e-300));
    }

    #[test]
    fn words_are_wrapped_beside_numbers() {
        let mut table =
            Table::new(vec![Column::words("claim", "claim", 9), Column::new("s", "s", Format::Fixed(1), "")]);
        table.push(vec!["one two three four".into(), 1.0.into()]);
        assert_eq!(table.text(), "claim      s\n-------  ---\none two  1.0\nthree\nfour\n");
    }
}
