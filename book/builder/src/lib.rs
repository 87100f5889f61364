//! Builds the book of the library `signorini`: runs the examples, puts their numbers, tables and figures into
//! the chapters, renders the formulas, drives mdBook, and checks the result.
//!
//! A chapter is Markdown with formulas between dollars and directives ([`directive`]); nothing computed is
//! typed by hand. Every fault names file, line and the offending text.

pub mod chapter;
pub mod code;
pub mod coverage;
pub mod data;
pub mod decimal;
pub mod directive;
pub mod error;
pub mod examples;
pub mod exercises;
pub mod figure;
pub mod formula;
pub mod html;
pub mod idea;
pub mod include;
pub mod labels;
pub mod large;
pub mod letters;
pub mod live;
pub mod markup;
pub mod number;
pub mod options;
pub mod page;
pub mod paper;
pub mod scan;
pub mod sentence;
pub mod serve;
pub mod slider;
pub mod stale;
pub mod tables;
pub mod typography;
pub mod verify;

use data::Data;
use directive::Sources;
use error::{Fault, Result, none_of, read, write};
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

/// Where the parts of a book are.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Layout {
    /// The repository; faults name files relative to it.
    pub repository: PathBuf,
    /// The book: `book.toml`, `src`, `generated`, `allowed-decimals.txt`.
    pub book: PathBuf,
}

impl Layout {
    /// The layout of a repository that keeps its book in `book`.
    pub fn of(repository: &Path) -> Self {
        Self { repository: repository.to_owned(), book: repository.join("book") }
    }

    /// Where the committed data of the examples is.
    pub fn generated(&self) -> PathBuf {
        self.book.join("generated")
    }

    /// Where what large runs computed is kept.
    pub fn large(&self) -> PathBuf {
        self.generated().join("large")
    }

    /// All that pages may show: what examples computed, and large runs.
    ///
    /// # Errors
    /// Those of [`Data::read`]; [`error::Error::Faults`] where a large run was made with other arguments.
    pub fn data(&self) -> Result<Data> {
        let large = Data::read(&self.large())?;
        none_of(large::faults(&large::list(&self.book)?, &large))?;
        let mut data = Data::read(&self.generated())?;
        data.extend(large);
        Ok(data)
    }
}

/// Builds the pages from data that is there; returns the directory of the HTML.
///
/// # Errors
/// [`error::Error::Faults`] with every fault found, or what went wrong around them.
pub fn build(layout: &Layout, data: &Data) -> Result<PathBuf> {
    let pages = html::chapters(&layout.book, &layout.repository)?;
    let allowed = read(&layout.book.join("allowed-decimals.txt")).unwrap_or_default();
    let list = labels::list(&layout.repository)?;
    let mut faults = tables::stale(&list, &layout.repository)?;
    for page in &pages {
        faults.extend(include::faults(page, &layout.book.join("src")));
    }
    let (examples, tests) = (layout.repository.join("examples"), layout.repository.join("tests"));
    let allowed = decimal::allow_list(&allowed);
    faults.extend(labels::faults(&list, &layout.repository)?);
    faults.extend(exercises::faults(&exercises::list(&layout.book)?, &pages, &layout.book));
    faults.extend(coverage::faults(&pages, &layout.repository)?);
    let ideas = layout.book.join("ideas");
    let sources = Sources { data, examples: &examples, tests: &tests, ideas: &ideas, allowed: &allowed };
    let marked = match page::mark(&pages, &sources) {
        Ok(marked) => marked,
        Err(more) => {
            faults.extend(more);
            page::Marked::default()
        }
    };
    none_of(faults)?;
    let output = html::build(&layout.book, &marked)?;
    for (name, csv) in &data.series {
        write(&output.join(figure::data_file(name)), csv)?;
    }
    none_of(verify::faults(&output, &pages)?)?;
    Ok(output)
}

/// Fails where committed data is not what was computed now.
///
/// # Errors
/// [`error::Error::Faults`], each entry that differs.
pub fn check_fresh(layout: &Layout, committed: &Data, computed: &Data) -> Result<()> {
    let generated = layout.generated();
    let generated = generated.strip_prefix(&layout.repository).unwrap_or(&generated);
    let faults = stale::compare(committed, computed).into_iter().map(|stale| {
        let file = generated.join(&stale.file);
        let text = read(&layout.repository.join(&file)).unwrap_or_default();
        Fault::new(&file, line_of(&text, &stale.entry), format!("stale: {}", stale.what), stale.entry)
    });
    none_of(faults.collect())
}

/// The line of an entry such as `example/values/key` in pretty-printed JSON; 1 where it cannot be told.
fn line_of(text: &str, entry: &str) -> usize {
    let mut at = 0;
    for key in entry.split('/') {
        match text[at..].find(&format!("\"{key}\":")) {
            Some(k) => at += k,
            None => break,
        }
    }
    scan::line_at(text, at)
}

/// Only the figures that pages show are committed; all values are.
///
/// # Errors
/// When the chapters cannot be read.
pub fn shown(layout: &Layout, mut data: Data) -> Result<Data> {
    let mut names = BTreeSet::new();
    for page in html::chapters(&layout.book, &layout.repository)? {
        for piece in scan::pieces(&page.text).unwrap_or_default() {
            if piece.kind == scan::Kind::Directive {
                names.extend(directive::figures(piece.text, &data));
            }
        }
    }
    data.figures.retain(|name, _| names.contains(name));
    data.series.retain(|name, _| names.contains(name));
    Ok(data)
}
