//! What of a page a laboratory may compute anew: marks around everything that stands for a directive of an
//! example with options, and a panel with its parameters behind the first table or figure.
//!
//! The marks carry the directive, so that `serve` resolves the same text against new data and the page puts
//! the answer in the same place.

use crate::data::Data;
use crate::directive;
use crate::markup::escape;
use crate::options::declared;
use crate::scan::{Kind, pieces};
use serde_json::Value;
use std::collections::BTreeSet;

/// Directives that are a table or a picture: a panel may stand behind one.
const BLOCKS: [&str; 4] = ["figure", "slider", "table", "findings"];

/// How a panel begins.
const PANEL: &str = "<details class=\"try-it\"";

/// The example that a directive draws on, if that is one alone.
pub fn example(text: &str, data: &Data) -> Option<String> {
    let mut parts = text.splitn(3, ':').map(str::trim);
    let (name, key) = (parts.next()?, parts.next()?);
    let known = |example: &str| data.examples.contains_key(example).then(|| example.to_owned());
    match name {
        "table" | "findings" | "measured" | "verdict" | "claim" | "label" => known(key),
        "value" | "finding" => known(key.split_once('/')?.0),
        "figure" | "slider" => {
            let figures = directive::figures(text, data);
            let examples: BTreeSet<&str> =
                figures.iter().filter_map(|f| Some(f.split_once('/')?.0)).collect();
            if examples.len() == 1 { known(examples.first()?) } else { None }
        }
        _ => None,
    }
}

/// Directives of a page, each with its example.
pub fn directives(page: &str, data: &Data) -> Vec<(String, String)> {
    let found = pieces(page).unwrap_or_default();
    let directives = found.iter().filter(|piece| piece.kind == Kind::Directive);
    directives
        .filter_map(|piece| Some((piece.text.trim().to_owned(), example(piece.text, data)?)))
        .collect()
}

/// Examples with options that show a table or a picture on the page.
pub fn examples(page: &str, data: &Data) -> BTreeSet<String> {
    let takes_options =
        |example: &String| data.options.get(example).is_some_and(|d| !declared(d).is_empty());
    let is_block = |text: &str| BLOCKS.contains(&text.split(':').next().unwrap_or("").trim());
    let found = directives(page, data).into_iter().filter(|(text, _)| is_block(text));
    found.map(|(_, example)| example).filter(takes_options).collect()
}

/// A part of a line that may be computed anew; whether it begins a sentence is remembered.
pub fn inline(text: &str, html: &str, begins: bool) -> String {
    let begins = if begins { " data-begins=\"\"" } else { "" };
    format!("<span data-live=\"{}\"{begins}>{html}</span>", escape(text.trim()))
}

/// A paragraph that may be computed anew.
pub fn block(text: &str, html: &str) -> String {
    format!("<div data-live=\"{}\">{html}</div>", escape(text.trim()))
}

/// A paragraph as it is printed: a panel stands behind it.
pub fn without_panel(html: &str) -> &str {
    html.split_once(PANEL).map_or(html, |(before, _)| before)
}

/// The panel of an example; its fields are made by `book/style/live.js` from the description inside.
pub fn panel(example: &str, description: &Value) -> String {
    // Inside a script only its end tag must not occur.
    let json = description.to_string().replace("</", "<\\/");
    let name = escape(example);
    format!(
        "{PANEL} data-example=\"{name}\"><summary>Try it: other parameters</summary>\
         <p class=\"try-help\">This page shows what was computed once. To compute with other parameters on this page, \
         run <code>cargo book serve</code> in the repository and open the address that it prints.</p>\
         <script type=\"application/json\" class=\"try-options\">{json}</script></details>"
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::data::parse_object;
    use std::path::Path;

    fn data() -> Data {
        let examples = r#"{"ex": {"rows": []}, "other": {"rows": []}}"#;
        let options = r#"{"ex": {"options": [{"name": "tau"}]}, "other": {"options": []}}"#;
        let svg = "<svg viewBox=\"0 0 1 1\"/>".to_owned();
        Data {
            examples: parse_object(Path::new("test"), examples).unwrap(),
            options: parse_object(Path::new("test"), options).unwrap(),
            figures: ["ex/a", "ex/b", "other/a"].map(|name| (name.to_owned(), svg.clone())).into(),
            ..Data::default()
        }
    }

    #[test]
    fn directives_belong_to_one_example() {
        let data = data();
        let of = |text: &str| example(text, &data);
        for text in [
            "table: ex",
            "finding: ex/key",
            "value: ex/key: s3",
            "figure: b: c",
            "slider: t: ex/*: c",
        ] {
            assert_eq!(of(text).as_deref(), Some("ex"), "{text}");
        }
        for text in [
            "value: key",
            "slider: t: x = ex/a, y = other/a: c",
            "table: none",
            "code: ex: run",
            "test: x",
        ] {
            assert_eq!(of(text), None, "{text}");
        }
    }

    #[test]
    fn a_description_cannot_end_its_script() {
        let html = panel("ex", &serde_json::json!({"about": "</script><b>"}));
        assert!(!html.contains("</script><b>"), "{html}");
    }
}
