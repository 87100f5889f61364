//! The last table of the notation page: letters with several meanings, and the pages of each. No page may stand
//! under two meanings of a letter, or under a letter that its formulas do not use.

use crate::chapter::Page;
use crate::error::Fault;
use crate::letters::tokens;
use crate::scan::line_at;
use crate::symbol::{formulas, symbol};
use std::collections::BTreeSet;

/// The section of the notation page of letters with several meanings.
pub(crate) const SEVERAL: &str = "## One letter, several pages";

/// A row of the last table: a letter, and for each of its meanings the pages that it lists.
pub(crate) struct Row {
    /// The letter, with its index.
    pub(crate) symbol: String,
    base: String,
    line: usize,
    /// The pages of each meaning.
    pub(crate) meanings: Vec<BTreeSet<String>>,
}

/// The rows of the table.
pub(crate) fn rows(notation: &Page) -> Vec<Row> {
    let at = notation.text.find(SEVERAL).unwrap_or(notation.text.len());
    let first = line_at(&notation.text, at);
    let lines = notation.text[at..].lines().enumerate();
    let row = |(k, line): (usize, &str)| {
        let (cell, rest) = line.strip_prefix("| $")?.split_once("$ | ")?;
        let all = tokens(cell);
        let (symbol, _) = symbol(&all)?;
        let meanings = rest.split([';', '|']).map(|part| {
            let targets = part.split("](").skip(1).filter_map(|rest| rest.split_once(".md"));
            targets.map(|(name, _)| format!("{name}.html")).collect()
        });
        Some(Row { symbol, base: all[0].clone(), line: first + k, meanings: meanings.collect() })
    };
    lines.filter_map(row).collect()
}

/// Pages under two meanings, or under a letter that they do not use.
pub(crate) fn row_faults(notation: &Page, rows: &[Row], pages: &[Page]) -> Vec<Fault> {
    let mut faults = Vec::new();
    for row in rows {
        let mut seen = BTreeSet::new();
        for html in row.meanings.iter().flatten() {
            let uses = |page: &&Page| formulas(page).iter().any(|(_, all)| all.contains(&row.base));
            let is_used = pages.iter().find(|page| page.html == *html).is_some_and(|page| uses(&page));
            let text = || format!("{} on {html}", row.symbol);
            if !seen.insert(html) {
                faults.push(Fault::new(&notation.file, row.line, "two meanings on one page", text()));
            } else if !is_used {
                faults.push(Fault::new(
                    &notation.file,
                    row.line,
                    "a letter that the page does not use",
                    text(),
                ));
            }
        }
    }
    faults
}
