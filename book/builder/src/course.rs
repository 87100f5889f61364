//! The course, from one list, `course/course.toml`: its pages with what is shown, run and asked, its slides, and the plans. The
//! directives `{{course: pages}}` and `{{course: four weeks}}` stand for its parts on a page; [`crate::slides`] writes the rest.

use crate::error::{Error, Result, read};
use std::fmt::Write as _;
use std::path::Path;

/// The list, below the directory of the book.
pub const FILE: &str = "course/course.toml";

/// The list.
///
/// # Errors
/// [`Error::File`], [`Error::Data`].
pub fn list(book: &Path) -> Result<toml::Table> {
    let path = book.join(FILE);
    let text = read(&path)?;
    text.parse().map_err(|e: toml::de::Error| Error::Data { path, message: e.to_string() })
}

/// The tables of an array.
pub fn entries<'a>(table: &'a toml::Table, key: &str) -> Vec<&'a toml::Table> {
    let list = table.get(key).and_then(toml::Value::as_array);
    list.into_iter().flatten().filter_map(toml::Value::as_table).collect()
}

/// A text of a table; empty where there is none.
pub fn text<'a>(entry: &'a toml::Table, key: &str) -> &'a str {
    entry.get(key).and_then(toml::Value::as_str).unwrap_or("").trim()
}

/// The title of a page of the book.
///
/// # Errors
/// [`Error::File`].
pub fn title(book: &Path, name: &str) -> Result<String> {
    let page = read(&book.join("src").join(name).with_extension("md"))?;
    Ok(page.lines().next().unwrap_or("").trim_start_matches("# ").to_owned())
}

/// The minutes of `10 the block, 15 the proof`.
fn clock_minutes(clock: &str) -> i64 {
    clock.split(", ").filter_map(|part| part.split_once(' ')?.0.parse::<i64>().ok()).sum()
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
                "{k}. [{}]({file}.md)\n    - *Minutes*: {}.\n    - *Show* {}.\n    - *Run* `{}`\n    - *Ask*: {} (*Answer*: {})\n    \
                 - *Slides* `slides_{k}.html`, *sheet* `sheet_{k}.html`: the [exercises]({file}.md#exercises)\n",
                name(page)?,
                text(page, "clock"),
                text(page, "show"),
                text(page, "run"),
                text(page, "ask"),
                text(page, "answer"),
            );
        }
        return Ok(markdown);
    }
    let plan = entries(&list, "plan").into_iter().find(|plan| text(plan, "name") == which);
    let plan = plan.ok_or_else(|| format!("the course has no plan `{which}`"))?;
    let minutes = plan.get("minutes").and_then(toml::Value::as_integer).unwrap_or(0);
    let _ =
        write!(markdown, "| week | {minutes} minutes: pages, slides and sheets |\n| --- | --- |\n");
    let weeks = plan.get("sessions").and_then(toml::Value::as_array).into_iter().flatten();
    let mut next = 1;
    for (week, numbers) in (1..).zip(weeks) {
        let (mut links, mut clock) = (Vec::new(), 0);
        for number in numbers.as_array().into_iter().flatten().filter_map(toml::Value::as_integer) {
            let page = usize::try_from(number - 1).ok().and_then(|k| pages.get(k));
            let page =
                page.filter(|_| number == next).ok_or("a plan takes each page once, in order")?;
            next += 1;
            clock += clock_minutes(text(page, "clock"));
            links.push(format!("{number}. [{}]({}.md)", name(page)?, text(page, "name")));
        }
        let has_clock = plan.get("clock").and_then(toml::Value::as_bool) == Some(true);
        if has_clock && clock != minutes {
            return Err(format!("week {week}: {clock} minutes by the clock, {minutes} planned"));
        }
        let _ = writeln!(markdown, "| {week} | {} |", links.join("; "));
    }
    if next != 1 + i64::try_from(pages.len()).unwrap_or(0) {
        return Err("a plan takes each page once, in order".to_owned());
    }
    Ok(markdown.trim_end().to_owned())
}
