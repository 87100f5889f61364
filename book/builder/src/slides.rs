//! Slides and sheets of the course: `cargo book course` writes them to `html/course`, and the sheets with solutions to
//! `html/solutions`, so that a lecturer can leave these out.

use crate::chapter::Page;
use crate::course::{entries, list, text, title};
use crate::data::Data;
use crate::directive::Sources;
use crate::error::{Error, Result, read, write};
use crate::layout::Layout;
use crate::{decimal, exercises, html, page};
use pulldown_cmark::{Options, Parser};
use std::fmt::Write as _;
use std::path::{Path, PathBuf};

const STYLE: &str = include_str!("../../course/course.css");
/// Where the files go, below the built pages.
const DIRECTORIES: [&str; 2] = ["course", "solutions"];

/// Writes slides, sheets and solutions with the numbers of `data`; returns the files.
///
/// # Errors
/// [`Error::Faults`] as on pages of the book, [`Error::File`].
pub fn write_all(layout: &Layout, mut data: Data) -> Result<Vec<PathBuf>> {
    let list = list(&layout.book)?;
    let exercises = exercises::list(&layout.book)?;
    let mut own = Vec::new();
    for (k, page) in (1..).zip(entries(&list, "page")) {
        let name = text(page, "name");
        let title = title(&layout.book, name)?;
        let sheet = |solutions| {
            exercises::sheet(&title, exercises.get(name).map_or(&[], Vec::as_slice), solutions)
        };
        own.push(one(DIRECTORIES[0], &format!("slides_{k}.html"), slides(&title, page)));
        own.push(one(DIRECTORIES[0], &format!("sheet_{k}.html"), sheet(false)));
        own.push(one(DIRECTORIES[1], &format!("sheet_{k}.html"), sheet(true)));
    }
    // All formulas at once, so that references have the numbers of the book.
    let mut pages = html::chapters(&layout.book, &layout.repository)?;
    let first = pages.len();
    pages.extend(own);
    data.options.clear();
    let allowed =
        decimal::allow_list(&read(&layout.book.join("allowed-decimals.txt")).unwrap_or_default());
    let (examples, tests) = (layout.repository.join("examples"), layout.repository.join("tests"));
    let ideas = layout.book.join("ideas");
    let sources = Sources {
        data: &data,
        examples: &examples,
        tests: &tests,
        ideas: &ideas,
        allowed: &allowed,
    };
    let marked = page::mark(&pages, &sources).map_err(Error::Faults)?;
    let mut files = Vec::new();
    for (page, text) in pages.iter().zip(&marked.texts).skip(first) {
        let file = layout.book.join("html").join(&page.html);
        let body = marked.unmark(&page.html, &markdown(text)).map_err(Error::Mdbook)?;
        write(&file, document(&page.html, &body))?;
        files.push(file);
    }
    Ok(files)
}

fn one(directory: &str, name: &str, text: String) -> Page {
    let html = format!("{directory}/{name}");
    Page { file: Path::new("book").join(&html), html, text }
}

/// A title, then one section for each slide.
fn slides(title: &str, page: &toml::Table) -> String {
    let mut all = format!("# {title}\n\n{}\n", text(page, "ask"));
    for slide in entries(page, "slide") {
        let [title, picture, lines] = ["title", "picture", "lines"].map(|key| text(slide, key));
        let _ = write!(all, "\n## {title}\n\n{picture}\n\n{lines}\n");
    }
    let _ = write!(all, "\n## To run\n\n```sh\n{}\n```\n", text(page, "run"));
    all
}

/// HTML of Markdown; each heading of the second level begins a section, which the slides show as one page.
fn markdown(text: &str) -> String {
    let mut body = String::new();
    // The pages of the book list the letters of a formula that the notation defines.
    let lines: Vec<&str> = text.lines().filter(|line| !line.starts_with("*Letters:*")).collect();
    let text = lines.join("\n");
    pulldown_cmark::html::push_html(&mut body, Parser::new_ext(&text, Options::ENABLE_TABLES));
    body.replace(".md\"", ".html\"")
        .replace(".md#", ".html#")
        .replace("<h2>", "</section><section><h2>")
}

/// The files stand one directory below the pages.
fn document(name: &str, body: &str) -> String {
    let kind = if name.contains("slides_") { "slides" } else { "sheet" };
    let title = body.split("<h1>").nth(1).and_then(|rest| rest.split("</h1>").next()).unwrap_or("");
    let body = body.replace("href=\"", "href=\"../").replace("href=\"../http", "href=\"http");
    format!(
        "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>{title}</title>\
         <style>{STYLE}</style></head>\n<body class=\"{kind}\"><section>{body}</section></body></html>\n"
    )
}
