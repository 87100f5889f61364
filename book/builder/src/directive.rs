//! Directives of a page and what they stand for.
//!
//! | written | becomes |
//! | --- | --- |
//! | `{{value: key}}`, `{{value: key: format}}` | a computed number; formats in [`crate::number`] |
//! | `{{measured: example}}`, `verdict`, `claim`, `label` | that line of the example's headline |
//! | `{{finding: example/key}}` | the words of that finding, marked where it fails or is undecided, a fault where it is a claim; its comparison on hover |
//! | `{{findings: example}}` | all findings of the example: outcome, words, comparison |
//! | `{{table: example}}` | the example's table, with what its columns mean |
//! | `{{figure: name: caption}}` | the figure, inline; the caption is also its label |
//! | `{{slider: parameter: frames: caption}}` | several figures and a slider between them, see [`crate::slider`] |
//! | `{{idea: name: caption}}` | a picture of an idea, see [`crate::idea`] |
//! | `{{code: example: function}}` | that function of the example |
//! | `{{course: pages}}`, `{{course: plan}}` | the pages of the course with what is shown, run and asked; a plan of weeks |
//! | `{{example: name}}`, `{{test: file}}`, `{{test: file::function}}` | a name that must exist, in code type |

use crate::code;
use crate::course;
use crate::data::{Data, Unknown};
use crate::figure;
use crate::idea;
use crate::markup::escape;
use crate::number::{Format, Written};
use crate::slider;
use crate::stale::Named;
use crate::typography;
use serde_json::Value;
use std::fmt::Write as _;
use std::path::Path;

/// A table with more columns than this is set in small type.
const NARROW: usize = 9;
/// Rows that a table of numbers shows at once: longer ones scroll, and have so many rows in the plain pages.
pub const LONG: usize = 8;

/// What a page may draw on.
#[derive(Debug, Clone, Copy)]
pub struct Sources<'a> {
    /// What the examples computed.
    pub data: &'a Data,
    /// The directory of their programs.
    pub examples: &'a Path,
    /// The directory of the tests.
    pub tests: &'a Path,
    /// The directory of the pictures of ideas.
    pub ideas: &'a Path,
    /// Decimals that may be typed by hand.
    pub allowed: &'a [String],
}

/// What a directive stands for.
#[derive(Debug, Clone, PartialEq)]
pub enum Meaning {
    /// A number.
    Number(Written),
    /// Words of a headline, as HTML.
    Words(String),
    /// A name in code type.
    Name(String),
    /// HTML of its own paragraph.
    Block(String),
    /// Markdown of its own paragraph.
    Markdown(String),
}

/// Looks up what a directive stands for.
///
/// # Errors
/// In words, what is wrong with it.
pub fn resolve(text: &str, sources: &Sources<'_>) -> Result<Meaning, String> {
    let data = sources.data;
    let mut parts = text.splitn(3, ':').map(str::trim);
    let name = parts.next().unwrap_or("");
    let key = parts.next().unwrap_or("");
    let rest = parts.next();
    match (name, rest) {
        ("value", format) => value(key, format.unwrap_or("s4"), data).map(Meaning::Number),
        ("label" | "claim" | "measured" | "verdict", None) => data
            .text(key, name)
            .map(|words| Meaning::Words(typography::html(words)))
            .ok_or_else(|| Unknown::Missing.words("example")),
        ("finding", None) => {
            let found = data.finding(key).map_err(|e| e.words("finding"))?;
            finding(found).map(Meaning::Words)
        }
        ("findings", None) => findings(key, "", data).map(Meaning::Block),
        ("findings", Some(rest)) if rest.starts_with(WITHOUT) => {
            findings(key, &rest[WITHOUT.len()..], data).map(Meaning::Block)
        }
        ("example", None) => code::program(sources.examples, key).map(Meaning::Name),
        ("test", None) => code::test(sources.tests, key, None).map(Meaning::Name),
        ("test", Some(function)) => {
            let function = function.trim_start_matches(':').trim();
            code::test(sources.tests, key, Some(function)).map(Meaning::Name)
        }
        // The list of the course stands beside the pictures of ideas.
        ("course", None) => course::part(sources.ideas.parent().unwrap_or(sources.ideas), key)
            .map(Meaning::Markdown),
        ("code", Some(function)) => {
            code::block(sources.examples, key, function).map(Meaning::Markdown)
        }
        ("table", None) => table(key, data).map(Meaning::Block),
        ("figure", Some(caption)) if !caption.is_empty() => {
            let (full, svg) = data.figure(key).map_err(|e| e.words("figure"))?;
            figure::inline(full, svg, caption, data.series.contains_key(full)).map(Meaning::Block)
        }
        ("idea", Some(caption)) if !caption.is_empty() => {
            idea::inline(sources.ideas, key, caption).map(Meaning::Block)
        }
        ("slider", Some(rest)) => {
            match rest.split_once(':').map(|(list, caption)| (list, caption.trim())) {
                Some((list, caption)) if !caption.is_empty() => {
                    slider::inline(key, list, caption, data).map(Meaning::Block)
                }
                _ => Err("slider without a caption".to_owned()),
            }
        }
        ("figure" | "slider" | "idea", _) => Err(format!("{name} without a caption")),
        _ => Err("unknown directive".to_owned()),
    }
}

/// Full names of the figures that a directive shows, as far as they are there.
pub fn figures(text: &str, data: &Data) -> Vec<String> {
    let parts: Vec<&str> = text.splitn(4, ':').map(str::trim).collect();
    match parts.as_slice() {
        ["figure", name, ..] => {
            data.figure(name).map(|(full, _)| full.to_owned()).into_iter().collect()
        }
        ["slider", _, list, ..] => slider::frames(list, data)
            .unwrap_or_default()
            .into_iter()
            .map(|(_, name)| name)
            .collect(),
        _ => Vec::new(),
    }
}

/// Outcome, words and comparison of a finding; a claim that does not hold is none that a page may make.
fn parts(finding: &Value) -> Result<[&str; 3], String> {
    let [outcome, words, comparison] =
        ["outcome", "words", "comparison"].map(|key| finding[key].as_str());
    let (Some(outcome), Some(words), Some(comparison)) = (outcome, words, comparison) else {
        return Err("damaged finding: an outcome, words and a comparison are expected".to_owned());
    };
    let holds = matches!(outcome, "holds" | "by proof");
    if finding["role"] == "claim" && !holds {
        let outcome = if outcome == "fails" { "fails" } else { "is undecided" };
        return Err(format!("the claim {outcome}"));
    }
    Ok([outcome, words, comparison])
}

/// A sentence with its comparison; one that does not hold says so.
fn finding(finding: &Value) -> Result<String, String> {
    let [outcome, words, comparison] = parts(finding)?;
    let says_so = words.starts_with(outcome);
    let words = typography::html(words);
    let mark = match outcome {
        "fails" | "undecided" if !says_so => {
            format!("<strong class=\"outcome\">{outcome}:</strong> ")
        }
        _ => String::new(),
    };
    let class = outcome.replace(' ', "-");
    let title = escape(comparison);
    // A bar would end the cell of a table.
    let html = format!("<span class=\"finding {class}\" title=\"{title}\">{mark}{words}</span>");
    Ok(html.replace('|', "&#124;"))
}

/// Before the findings that a table leaves out.
const WITHOUT: &str = "without ";

/// The text of a page in which tables of findings leave out what its sentences state.
pub fn each_finding_once(page: &str) -> String {
    let (table, sentence) = ("{{findings: ", "{{finding: ");
    let stated = |example: &str| -> Vec<&str> {
        let sentences = page.split(sentence).skip(1).filter_map(|rest| rest.split_once("}}"));
        let keys = sentences.filter_map(|(key, _)| key.split_once('/'));
        keys.filter(|(owner, _)| *owner == example).map(|(_, key)| key.trim()).collect()
    };
    let mut parts = page.split(table);
    let mut text = parts.next().unwrap_or("").to_owned();
    for part in parts {
        text.push_str(table);
        match part.split_once("}}") {
            Some((example, rest)) if !stated(example).is_empty() => {
                let _ = write!(text, "{example}: {WITHOUT}{}}}}}{rest}", stated(example).join(" "));
            }
            _ => text.push_str(part),
        }
    }
    text
}

/// Findings of an example as a table, without those of the list; nothing if none is left.
fn findings(example: &str, without: &str, data: &Data) -> Result<String, String> {
    let headline = data.examples.get(example).ok_or_else(|| Unknown::Missing.words("example"))?;
    let list = headline["findings"].as_array().ok_or("the example has no findings")?;
    let mut html = "<div class=\"table-wrapper findings\"><table><tbody>".to_owned();
    let key = |finding: &Value| finding["finding"].as_str().unwrap_or("").to_owned();
    let is_left = |finding: &&Value| without.split(' ').all(|other| other != key(finding));
    if list.iter().filter(is_left).count() == 0 {
        return Ok(String::new());
    }
    for finding in list.iter().filter(is_left) {
        let [outcome, words, comparison] = parts(finding)?;
        // The comparison beside it has the numbers.
        let claim = finding.as_object().map_or(words, |finding| Named::of(finding).claim);
        let [outcome, words, comparison] = [outcome, claim, comparison].map(typography::html);
        let _ = write!(
            html,
            "<tr><td>{outcome}</td><td>{words}</td><td class=\"comparison\">{comparison}</td></tr>"
        );
    }
    html.push_str("</tbody></table></div>");
    Ok(html)
}

fn value(key: &str, format: &str, data: &Data) -> Result<Written, String> {
    let digits = Format::parse(format).ok_or_else(|| format!("unknown format {format}"))?;
    let value = data.value(key).map_err(|e| e.words("key"))?;
    Ok(Written::new(value, digits))
}

/// Titles with meanings of the columns, and the cells of every row.
type Cells<'a> = (Vec<[&'a str; 2]>, Vec<Vec<&'a str>>);

/// The table of a headline; `None` where a title is missing or a row does not have its cells.
fn cells(headline: &Value) -> Option<Cells<'_>> {
    let columns = headline["columns"].as_array()?.iter();
    let columns: Vec<[&str; 2]> = columns
        .map(|c| Some([c["title"].as_str()?, c["meaning"].as_str()?]))
        .collect::<Option<_>>()?;
    let rows = headline["rows"].as_array()?.iter().map(words).collect::<Option<Vec<_>>>()?;
    rows.iter().all(|row| row.len() == columns.len()).then_some((columns, rows))
}

/// The strings of an array of strings.
fn words(array: &Value) -> Option<Vec<&str>> {
    array.as_array()?.iter().map(Value::as_str).collect()
}

fn table(example: &str, data: &Data) -> Result<String, String> {
    let headline = data.examples.get(example).ok_or_else(|| Unknown::Missing.words("example"))?;
    let (columns, rows) =
        cells(headline).ok_or("damaged table: titles and rows of as many cells are expected")?;
    let width = if columns.len() > NARROW { " wide" } else { "" };
    let height = if rows.len() > LONG { " tall" } else { "" };
    let mut html = format!("<div class=\"table-wrapper{width}{height}\"><table><thead><tr>");
    for [title, _] in &columns {
        let _ = write!(html, "<th>{}</th>", typography::html(title));
    }
    html.push_str("</tr></thead><tbody>");
    for row in rows {
        html.push_str("<tr>");
        for cell in row {
            let _ = match cell.parse::<f64>() {
                Ok(_) => {
                    write!(html, "<td class=\"number\">{}</td>", Written::from_text(cell).html())
                }
                Err(_) => write!(html, "<td>{}</td>", typography::html(cell)),
            };
        }
        html.push_str("</tr>");
    }
    html.push_str("</tbody></table></div>");
    let meanings: Vec<String> = columns
        .iter()
        .filter(|[_, meaning]| !meaning.is_empty())
        .map(|[title, meaning]| {
            format!("<b>{}</b> {}", typography::html(title), typography::html(meaning))
        })
        .collect();
    if !meanings.is_empty() {
        let _ = write!(html, "<p class=\"table-key\">{}</p>", meanings.join("; "));
    }
    Ok(html)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::data::parse_object;

    fn data() -> Data {
        let text = r#"{"ex": {"verdict": "holds", "values": {"gamma": 0.29156}, "confirmed": true,
            "findings": [{"finding": "a", "outcome": "holds", "role": "claim", "words": "nu < 1", "comparison": "0.5 <= 1"},
                {"finding": "b", "outcome": "fails", "words": "no", "comparison": "2 > 1"}],
            "columns": [{"key": "nu", "title": "nu", "meaning": "order"}, {"key": "e", "title": "<e>", "meaning": ""}],
            "rows": [["0.5", "1e-3"], ["x", "-"]]}}"#;
        Data {
            examples: parse_object(Path::new("test"), text).unwrap(),
            figures: [("ex/f".to_owned(), "<svg viewBox=\"0 0 1 1\"/>".to_owned())].into(),
            ..Data::default()
        }
    }

    fn sources(data: &Data) -> Sources<'_> {
        let none = Path::new("none");
        Sources { data, examples: none, tests: none, ideas: none, allowed: &[] }
    }

    #[test]
    fn numbers_words_tables_and_figures_are_found() {
        let data = data();
        let sources = sources(&data);
        let number = |value, format| Ok(Meaning::Number(Written::new(value, format)));
        assert_eq!(resolve("value:gamma", &sources), number(0.29156, Format::Significant(4)));
        assert_eq!(resolve(" value : ex/gamma : f2 ", &sources), number(0.29156, Format::Fixed(2)));
        assert_eq!(resolve("verdict: ex", &sources), Ok(Meaning::Words("holds".into())));
        let Ok(Meaning::Words(held)) = resolve("finding: ex/a", &sources) else {
            panic!("no finding")
        };
        assert!(held.contains("class=\"finding holds\" title=\"0.5 &lt;= 1\">ν"), "{held}");
        let Ok(Meaning::Words(failed)) = resolve("finding: ex/b", &sources) else {
            panic!("no finding")
        };
        assert!(failed.contains("<strong class=\"outcome\">fails:</strong> no"), "{failed}");
        assert!(
            matches!(resolve("findings: ex", &sources), Ok(Meaning::Block(h)) if h.contains("2 &gt; 1"))
        );
        let once = each_finding_once("It is {{finding: ex/b}}.\n\n{{findings: ex}}\n");
        assert_eq!(once, "It is {{finding: ex/b}}.\n\n{{findings: ex: without b}}\n");
        assert_eq!(each_finding_once("{{findings: ex}}"), "{{findings: ex}}");
        assert!(
            matches!(resolve("findings: ex: without b", &sources), Ok(Meaning::Block(h)) if !h.contains("2 &gt; 1") && h.contains("&lt; 1"))
        );
        let none = resolve("findings: ex: without a b", &sources);
        assert_eq!(none, Ok(Meaning::Block(String::new())));
        let Ok(Meaning::Block(html)) = resolve("table:ex", &sources) else { panic!("no table") };
        assert!(html.contains("<th>&lt;e&gt;</th>"), "{html}");
        assert!(html.contains("10<sup>\u{2212}3</sup>"), "{html}");
        assert!(html.contains("<b>ν</b> order"), "{html}");
        assert!(
            matches!(resolve("figure:f:a: b", &sources), Ok(Meaning::Block(h)) if h.contains("a: b"))
        );
    }
}
