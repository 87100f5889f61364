//! From marked pages to HTML: mdBook, then the marks, the math font and the style.

use crate::chapter::Page;
use crate::data::names;
use crate::error::{Error, Result, read, write};
use crate::page::{self, Marked};
use crate::{directive, exercises};
use mdbook_driver::MDBook;
use mdbook_driver::book::BookItem;
use std::path::{Path, PathBuf};

/// File name of the math font in the output; the style sheet names the same.
pub const FONT: &str = "NewCMMath-Regular.otf";

/// The chapters of the book at `root`, in order, each with its exercises, named relative to `base` in
/// messages.
///
/// # Errors
/// [`Error::Mdbook`] when the summary or a chapter cannot be read; chapters must stand in one directory.
pub fn chapters(root: &Path, base: &Path) -> Result<Vec<Page>> {
    let book = load(root)?;
    let source = book.source_dir();
    let mut pages = Vec::new();
    for item in book.iter() {
        let BookItem::Chapter(chapter) = item else { continue };
        let Some(path) = &chapter.path else { continue };
        if path.components().count() != 1 {
            return Err(Error::Mdbook(format!("chapter not directly in src: {}", path.display())));
        }
        let file = source.join(path);
        pages.push(Page {
            text: read(&file)?,
            file: file.strip_prefix(base).map_or(file.clone(), Path::to_owned),
            html: path.with_extension("html").display().to_string(),
        });
    }
    exercises::append(&mut pages, &exercises::list(root)?);
    for page in &mut pages {
        page.text = directive::each_finding_once(&page.text);
    }
    Ok(pages)
}

fn load(root: &Path) -> Result<MDBook> {
    MDBook::load(root).map_err(|e| Error::Mdbook(format!("{e:#}")))
}

/// Builds the book at `root` from its marked pages; returns the output directory.
///
/// # Errors
/// [`Error::Mdbook`], [`Error::File`].
pub fn build(root: &Path, marked: &Marked) -> Result<PathBuf> {
    let mut book = load(root)?;
    let mut texts = marked.texts.iter();
    book.book.for_each_mut(|item| {
        if let BookItem::Chapter(chapter) = item
            && chapter.path.is_some()
            && let Some(text) = texts.next()
        {
            chapter.content.clone_from(text);
        }
    });
    book.build().map_err(|e| Error::Mdbook(format!("{e:#}")))?;
    let output = book.build_dir_for("html");
    for name in names(&output)?.into_iter().filter(|name| name.ends_with(".html")) {
        let file = output.join(&name);
        let html = marked
            .unmark(&name, &read(&file)?)
            .map_err(|what| Error::Mdbook(format!("{name}: {what}")))?;
        write(&file, html)?;
    }
    for name in names(&output)?.into_iter().filter(|name| name.starts_with("searchindex")) {
        let file = output.join(&name);
        write(&file, page::without_marks(&read(&file)?))?;
    }
    write(&output.join("fonts").join(FONT), math_font()?)?;
    Ok(output)
}

/// New Computer Modern Math, regular, found among the fonts of the crate by its PostScript name.
fn math_font() -> Result<&'static [u8]> {
    let name = FONT.trim_end_matches(".otf").as_bytes();
    typst_assets::fonts()
        .find(|font| font[..font.len().min(1 << 16)].windows(name.len()).any(|w| w == name))
        .ok_or_else(|| Error::Mdbook(format!("no font {FONT} in typst-assets")))
}
