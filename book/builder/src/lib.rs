//! Builds the book of the library `signorini`: runs the examples, puts their numbers, tables and figures into
//! the chapters, renders the formulas, drives mdBook, and checks the result.
//!
//! A chapter is Markdown with formulas between dollars and directives ([`directive`]); nothing computed is
//! typed by hand. Every fault names file, line and the offending text.

pub mod chapter;
pub mod code;
pub mod course;
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
pub mod layout;
pub mod letters;
pub mod live;
pub mod markup;
pub mod number;
pub mod options;
pub mod page;
pub mod plain;
pub mod scan;
pub mod sentence;
pub mod serve;
pub mod slider;
pub mod slides;
pub mod stale;
pub mod tables;
pub mod typography;
pub mod verify;

use data::Data;
use directive::Sources;
use error::{Fault, Result, none_of, read, write};
pub use layout::Layout;
use std::collections::BTreeSet;
use std::path::PathBuf;

/// All that pages may show: what examples computed, and large runs.
///
/// # Errors
/// Those of [`Data::read`]; [`error::Error::Faults`] where a large run was made with other arguments.
pub fn committed(layout: &Layout) -> Result<Data> {
    let large = Data::read(&layout.large())?;
    let runs = large::list(&layout.book)?;
    none_of(large::faults(&runs, &large))?;
    let mut data = Data::read(&layout.generated())?;
    none_of(large::other_words(&runs, &large, &data))?;
    data.extend(large);
    Ok(data)
}

/// Builds the pages from data that is there; returns the directory of the HTML.
///
/// # Errors
/// [`error::Error::Faults`] with every fault found, or what went wrong around them.
pub fn build(layout: &Layout, data: &Data) -> Result<PathBuf> {
    let (output, plain) = pages(layout, data)?;
    plain::renew(layout, &plain)?;
    Ok(output)
}

/// As [`build`], and fails where the committed plain pages are not what it would write.
///
/// # Errors
/// Those of [`build`].
pub fn check_pages(layout: &Layout, data: &Data) -> Result<PathBuf> {
    let (output, plain) = pages(layout, data)?;
    none_of(plain::stale(layout, &plain)?)?;
    Ok(output)
}

/// The directory of the HTML, and the pages as plain Markdown.
fn pages(layout: &Layout, data: &Data) -> Result<(PathBuf, Vec<(String, String)>)> {
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
    let sources =
        Sources { data, examples: &examples, tests: &tests, ideas: &ideas, allowed: &allowed };
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
    let plain = plain::edition(layout, &pages, &sources, &marked.labels)?;
    none_of(plain::refused(&plain))?;
    Ok((output, plain))
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
        Fault::new(
            &file,
            line_of(&text, &stale.entry),
            format!("stale: {}", stale.what),
            stale.entry,
        )
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
