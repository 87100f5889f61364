//! The outcome on a terminal: one screen of at most 100 columns.

use crate::Outcome;
use crate::check::{Checked, Decision, Role};
use crate::outcome::Verdict;
use comfy_table::{CellAlignment, Table, presets};
use std::fmt::Write as _;

/// Largest width of a line; smaller if the variable COLUMNS is.
const WIDTH: usize = 100;
/// Largest number of rows shown; of more rows only the first and last ones are.
const ROWS: usize = 24;
const ENDS: usize = 11;
/// Least width of the column of claims.
const CLAIM: usize = 30;
/// Largest number of checks shown; further checks that hold are only counted.
const CHECKS: usize = 12;

/// Width of a line: the variable COLUMNS if it is set, in [40, 100].
pub(crate) fn line_width() -> usize {
    let columns = std::env::var("COLUMNS").ok().and_then(|text| text.parse().ok());
    columns.unwrap_or(WIDTH).clamp(40, WIDTH)
}

impl Outcome {
    /// The outcome as text: statement, table, checks, status; coloured if `in_colour`.
    pub fn text(&self, in_colour: bool) -> String {
        let width = line_width();
        let mut text = String::new();
        let head = wrapped(&format!("{}   {}", self.label, self.statement), width);
        let _ = writeln!(text, "{}\n", head.join("\n    "));
        if !self.rows.is_empty() {
            text.push_str(&self.table_text(width));
            text.push('\n');
        }
        text.push_str(&self.checks_text(width, in_colour));
        let status = self.status();
        let colour = if status.is_confirmed() { GREEN } else { RED };
        let mut last = format!("  status: {}", painted(&status.to_string(), colour, in_colour));
        match status {
            Verdict::FalseAsPrinted => {
                let _ = write!(last, "; it is true {}", self.corrections().join(" and "));
            }
            Verdict::Loose => last.push_str(": a stronger statement is true too"),
            Verdict::NotSharp => last.push_str(": the true rate of growth is another"),
            _ => {}
        }
        if let [.., path] = self.saved.as_slice() {
            let others = self.saved.len() - 1;
            let more = if others > 0 { format!(" and {others} more") } else { String::new() };
            let _ = write!(last, "     picture: {}{more}", path.display());
        }
        let _ = writeln!(text, "{last}     {:.1} s", self.seconds);
        for paragraph in self.remark.lines() {
            let _ = writeln!(text, "  {}", wrapped(paragraph, width - 2).join("\n  "));
        }
        text
    }

    fn table_text(&self, width: usize) -> String {
        let (titles, rows) = self.table();
        let mut table = Table::new();
        table.load_preset(presets::NOTHING);
        table.set_header(titles.iter().map(|[title, ..]| title));
        let is_number = |text: &str| {
            text.is_empty()
                || text.starts_with(|c: char| c.is_ascii_digit() || "-−–∞".contains(c))
                    && !text.contains(' ')
        };
        let all = rows.len() <= ROWS;
        for (k, row) in rows.iter().enumerate() {
            if all || k < ENDS || k + ENDS >= rows.len() {
                table.add_row(row);
            } else if k == ENDS {
                table.add_row([format!("… {} more", rows.len() - 2 * ENDS)]);
            }
        }
        for (k, column) in table.column_iter_mut().enumerate() {
            column.set_padding((0, 2));
            if 2 * rows.iter().filter(|row| is_number(&row[k])).count() > rows.len() {
                column.set_cell_alignment(CellAlignment::Right);
            }
        }
        let mut text = String::new();
        for line in table.to_string().lines() {
            let _ = writeln!(text, "  {}", line.trim_end());
        }
        let explained = titles.iter().filter(|[_, meaning, _]| !meaning.is_empty());
        let explained: Vec<String> =
            explained.map(|[title, meaning, _]| format!("{title}: {meaning}")).collect();
        for line in wrapped(&explained.join("; "), width - 2).iter().filter(|line| !line.is_empty())
        {
            let _ = writeln!(text, "  {line}");
        }
        text
    }

    fn checks_text(&self, width: usize, in_colour: bool) -> String {
        let is_shown = |(k, check): &(usize, &Checked)| {
            let is_plain = check.decision() <= Decision::Holds && check.role != Role::AsPrinted;
            self.checks.len() <= CHECKS || *k + 1 < CHECKS || !is_plain
        };
        let checks: Vec<&Checked> =
            self.checks.iter().enumerate().filter(is_shown).map(|(_, check)| check).collect();
        let hidden = self.checks.len() - checks.len();
        let widest = |k: usize, proved: bool| {
            let of_kind =
                checks.iter().filter(|check| (check.decision() == Decision::ByProof) == proved);
            of_kind.map(|check| check.parts()[k].chars().count()).max().unwrap_or(0)
        };
        // A proof has a page in place of bound and source.
        let (value, bound, page) =
            (widest(0, false).max(widest(0, true)), widest(1, false), widest(1, true));
        let longest = checks.iter().map(|check| claim(check).chars().count()).max().unwrap_or(0);
        let room = width.saturating_sub(value + bound.max(page) + 7).max(CLAIM);
        let is_beside = |check: &Checked, words: usize| {
            source(check).chars().count() <= width.saturating_sub(words + value + bound + 9)
        };
        // The width with the fewest lines, and of those the largest: a claim is broken, or its
        // source is on the next line.
        let lines = |words: &usize| -> usize {
            let of = |check: &&Checked| {
                wrapped(&claim(check), *words).len() + usize::from(!is_beside(check, *words))
            };
            checks.iter().map(of).sum()
        };
        let words =
            (CLAIM.min(longest)..=longest.min(room)).rev().min_by_key(lines).unwrap_or(longest);
        let mut text = String::new();
        for check in checks {
            let [number, relation] = check.parts();
            let mut claim = wrapped(&claim(check), words).into_iter();
            let mark = painted(
                &check.decision().mark_and_word().0.to_string(),
                mark_colour(check),
                in_colour,
            );
            let first = claim.next().unwrap_or_default();
            let mut line = format!("  {mark} {first:<words$}  {number:>value$} {relation:<bound$}");
            let source = source(check);
            let beside = is_beside(check, words);
            if beside {
                let _ = write!(line, "  {source}");
            }
            let _ = writeln!(text, "{}", line.trim_end());
            for rest in claim {
                let _ = writeln!(text, "    {rest}");
            }
            if !beside {
                for rest in wrapped(&source, width - 8) {
                    let _ = writeln!(text, "      {rest}");
                }
            }
        }
        if hidden > 0 {
            let _ = writeln!(text, "  ✓ {hidden} more checks hold (all of them with --json)");
        }
        text
    }
}

fn claim(check: &Checked) -> String {
    let failed = check.role == Role::AsPrinted && check.decision() == Decision::Fails;
    format!("{}{}", if failed { "as printed: " } else { "" }, check.claim)
}

/// The source of the bound, and the number of cases of which the worst is shown.
fn source(check: &Checked) -> String {
    if check.cases > 1 {
        format!("{}, worst of {}", check.source, check.cases)
    } else {
        check.source.clone()
    }
}

const GREEN: u8 = 32;
const RED: u8 = 31;
const YELLOW: u8 = 33;

fn mark_colour(check: &Checked) -> u8 {
    match (check.decision(), check.role) {
        (Decision::ByProof | Decision::Holds, _) => GREEN,
        (Decision::Fails, Role::Claim) => RED,
        _ => YELLOW,
    }
}

fn painted(text: &str, colour: u8, in_colour: bool) -> String {
    if in_colour { format!("\u{1b}[{colour}m{text}\u{1b}[0m") } else { text.to_owned() }
}

/// Greedy line breaking at spaces; a longer word stands alone on its line.
fn wrapped(words: &str, width: usize) -> Vec<String> {
    let mut lines = vec![String::new()];
    for word in words.split(' ') {
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
