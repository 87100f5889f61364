//! The course, from one list, `course/course.toml`: its pages with what is shown, run and asked, its slides, and the plans.
//! `cargo book course` writes slides and sheets to `html/course` and the sheets with solutions to `html/solutions`, so that a
//! lecturer can leave these out; the directives `{{course: pages}}` and `{{course: four weeks}}` stand for its parts on a page.

use crate::chapter::Page;
use crate::directive::Sources;
use crate::error::{Error, Result, read, write};
use crate::{Layout, decimal, exercises, html, page};
use pulldown_cmark::{Options, Parser};
use std::fmt::Write as _;
use std::path::{Path, PathBuf};

/// The list, below the directory of the book.
pub const FILE: &str = "course/course.toml";
const STYLE: &str = include_str!("../../course/course.css");
/// Where the files go, below the built pages.
const DIRECTORIES: [&str; 2] = ["course", "solutions"];

fn list(book: &Path) -> Result<toml::Table> {
    let path = book.join(FILE);
    let text = read(&path)?;
    text.parse().map_err(|e: toml::de::Error| Error::Data { path, message: e.to_string() })
}

fn entries<'a>(table: &'a toml::Table, key: &str) -> Vec<&'a toml::Table> {
    let list = table.get(key).and_then(toml::Value::as_array);
    list.into_iter().flatten().filter_map(toml::Value::as_table).collect()
}

fn text<'a>(entry: &'a toml::Table, key: &str) -> &'a str {
    entry.get(key).and_then(toml::Value::as_str).unwrap_or("").trim()
}

/// The title of a page of the book.
fn title(book: &Path, name: &str) -> Result<String> {
    let page = read(&book.join("src").join(name).with_extension("md"))?;
    Ok(page.lines().next().unwrap_or("").trim_start_matches("# ").to_owned())
}

/// What `{{course: which}}` stands for, as Markdown: `pages`, or the name of a plan.
///
/// # Errors
/// In words, when the list cannot be read or has no such part.
pub fn part(book: &Path, which: &str) -> std::result::Result<String, String> {
    let list = list(book).map_err(|e| e.to_string())?;
    let pages = entries(&list, "page");
    let name = |page: &toml::Table| title(book, text(page, "name")).map_err(|e| e.to_string());
    let mut markdown = String::new();
    if which == "pages" {
        for (k, page) in (1..).zip(&pages) {
            let file = text(page, "name");
            let _ = write!(
                markdown,
                "{k}. [{}]({file}.md)\n    - *Show* {}.\n    - *Run* `{}`\n    - *Ask*: {}\n    - *Slides* `slides_{k}.html`, \
                 *sheet* `sheet_{k}.html`: the [exercises]({file}.md#exercises)\n",
                name(page)?,
                text(page, "show"),
                text(page, "run"),
                text(page, "ask"),
            );
        }
        return Ok(markdown);
    }
    let plan = entries(&list, "plan").into_iter().find(|plan| text(plan, "name") == which);
    let plan = plan.ok_or_else(|| format!("the course has no plan `{which}`"))?;
    let minutes = plan.get("minutes").and_then(toml::Value::as_integer).unwrap_or(0);
    let _ = write!(markdown, "| week | {minutes} minutes: pages, slides and sheets |\n| --- | --- |\n");
    let weeks = plan.get("sessions").and_then(toml::Value::as_array).into_iter().flatten();
    let mut next = 1;
    for (week, numbers) in (1..).zip(weeks) {
        let mut links = Vec::new();
        for number in numbers.as_array().into_iter().flatten().filter_map(toml::Value::as_integer) {
            let page = usize::try_from(number - 1).ok().and_then(|k| pages.get(k));
            let page = page.filter(|_| number == next).ok_or("a plan takes each page once, in order")?;
            next += 1;
            links.push(format!("{number}. [{}]({}.md)", name(page)?, text(page, "name")));
        }
        let _ = writeln!(markdown, "| {week} | {} |", links.join("; "));
    }
    if next != 1 + i64::try_from(pages.len()).unwrap_or(0) {
        return Err("a plan takes each page once, in order".to_owned());
    }
    Ok(markdown.trim_end().to_owned())
}

/// Writes slides, sheets and solutions; returns the files.
///
/// # Errors
/// [`Error::Faults`] as on pages of the book, [`Error::File`].
pub fn write_all(layout: &Layout) -> Result<Vec<PathBuf>> {
    let list = list(&layout.book)?;
    let exercises = exercises::list(&layout.book)?;
    let mut own = Vec::new();
    for (k, page) in (1..).zip(entries(&list, "page")) {
        let name = text(page, "name");
        let title = title(&layout.book, name)?;
        let sheet =
            |solutions| exercises::sheet(&title, exercises.get(name).map_or(&[], Vec::as_slice), solutions);
        own.push(one(DIRECTORIES[0], &format!("slides_{k}.html"), slides(&title, page)));
        own.push(one(DIRECTORIES[0], &format!("sheet_{k}.html"), sheet(false)));
        own.push(one(DIRECTORIES[1], &format!("sheet_{k}.html"), sheet(true)));
    }
    // All formulas at once, so that references have the numbers of the book.
    let mut pages = html::chapters(&layout.book, &layout.repository)?;
    let first = pages.len();
    pages.extend(own);
    let mut data = crate::committed(layout)?;
    data.options.clear();
    let allowed = decimal::allow_list(&read(&layout.book.join("allowed-decimals.txt")).unwrap_or_default());
    let (examples, tests) = (layout.repository.join("examples"), layout.repository.join("tests"));
    let ideas = layout.book.join("ideas");
    let sources =
        Sources { data: &data, examples: &examples, tests: &tests, ideas: &ideas, allowed: &allowed };
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
    body.replace(".md\"", ".html\"").replace(".md#", ".html#").replace("<h2>", "</section><section><h2>")
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
