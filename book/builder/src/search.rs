//! The index for looking up words without a server: every section of every page with its text, as a script
//! that the pages load when a reader looks for something (`book/style/search.js`).

use crate::chapter::Page;
use crate::markup::{Tag, tags};
use serde_json::json;
use std::path::Path;

/// File name of the index in the output.
pub const INDEX: &str = "search-index.js";
/// What stands inside these is no text.
const SKIPPED: [&str; 6] = ["svg", "math", "script", "style", "button", "summary"];

/// A section of a page.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Section {
    /// Its anchor; empty before the first heading.
    pub anchor: String,
    /// Its heading.
    pub title: String,
    /// Its words.
    pub text: String,
}

/// The sections of a built page.
pub fn sections(html: &str) -> Vec<Section> {
    let start = html.find("<main>").unwrap_or(0);
    let end = html.find("</main>").unwrap_or(html.len());
    let main = &html[start..end];
    let mut found: Vec<Section> = Vec::new();
    let (mut at, mut skipped, mut is_title) = (0, None::<&str>, false);
    for tag in tags(main) {
        let before = &main[at..tag.start];
        at = tag.end;
        if let Some(name) = skipped {
            let ends = tag.name.strip_prefix('/') == Some(name);
            skipped = skipped.filter(|_| !ends);
            continue;
        }
        if let Some(section) = found.last_mut() {
            push(if is_title { &mut section.title } else { &mut section.text }, before);
        }
        if let Some(anchor) = heading(&tag) {
            found.push(Section { anchor: anchor.to_owned(), title: String::new(), text: String::new() });
            is_title = true;
        } else if matches!(tag.name, "/h1" | "/h2" | "/h3") {
            is_title = false;
        } else if (SKIPPED.contains(&tag.name) || is_panel(&tag)) && !tag.closes_itself() {
            skipped = Some(tag.name);
        } else if let (false, Some(section)) = (is_inline(tag.name), found.last_mut()) {
            push(&mut section.text, " ");
        }
    }
    found.iter_mut().for_each(|section| {
        section.title = section.title.trim().to_owned();
        section.text = section.text.trim().to_owned();
    });
    found
}

fn heading<'a>(tag: &Tag<'a>) -> Option<&'a str> {
    matches!(tag.name, "h1" | "h2" | "h3").then(|| tag.attribute("id")).flatten()
}

/// Parameters are no text of the page.
fn is_panel(tag: &Tag<'_>) -> bool {
    tag.name == "details" && tag.attribute("class") == Some("try-it")
}

/// Tags within a word.
fn is_inline(name: &str) -> bool {
    let name = name.trim_start_matches('/');
    matches!(name, "a" | "b" | "em" | "strong" | "span" | "code" | "sub" | "sup" | "wbr" | "h1" | "h2" | "h3")
}

/// Adds text with single spaces and characters in place of their names.
fn push(to: &mut String, text: &str) {
    let named =
        [("&lt;", "<"), ("&gt;", ">"), ("&quot;", "\""), ("&#39;", "'"), ("&#x27;", "'"), ("&amp;", "&")];
    let plain = named.iter().fold(text.to_owned(), |text, (name, character)| text.replace(name, character));
    for character in plain.chars() {
        let character = if character.is_whitespace() { ' ' } else { character };
        if character != ' ' || !to.ends_with(' ') {
            to.push(character);
        }
    }
}

/// The script of the index, from the built pages in `output`.
///
/// # Errors
/// [`crate::error::Error::File`] when a page cannot be read.
pub fn script(output: &Path, pages: &[Page]) -> crate::error::Result<String> {
    let mut entries = Vec::new();
    for page in pages {
        let html = crate::error::read(&output.join(&page.html))?;
        let sections = sections(&html);
        let title = sections.first().map_or("", |section| section.title.as_str()).to_owned();
        entries.extend(sections.into_iter().map(|s| json!([page.html, s.anchor, title, s.title, s.text])));
    }
    Ok(format!("window.bookIndex = {};\n", serde_json::Value::from(entries)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sections_carry_their_words_and_nothing_drawn() {
        let html = "<nav>menu</nav><main><h1 id=\"a\"><a href=\"#a\">Theorem 3.1: <em>rates</em></a></h1>\
            <p>By E. Gagliardo &amp;\n others<math><mi>x</mi></math>; the du<b>al</b> norm.</p>\
            <svg viewBox=\"0 0 1 1\"><text>axis</text></svg><details class=\"try-it\"><p>tau</p></details><h2 id=\"b\">Second</h2><p>one</p><p>two</p></main><p>foot</p>";
        let found = sections(html);
        let section = |anchor: &str, title: &str, text: &str| Section {
            anchor: anchor.to_owned(),
            title: title.to_owned(),
            text: text.to_owned(),
        };
        let first = section("a", "Theorem 3.1: rates", "By E. Gagliardo & others; the dual norm.");
        assert_eq!(found, [first, section("b", "Second", "one two")]);
    }
}
