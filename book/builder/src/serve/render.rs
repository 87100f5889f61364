//! An outcome put in the words of a page: every directive of the example on that page, resolved against it.

use super::laboratory::Laboratory;
use super::run::Outcome;
use crate::data::Data;
use crate::directive::{self, Meaning};
use crate::{figure, live, sentence};
use serde_json::{Map, Value, json};
use std::collections::BTreeSet;

/// `seconds`, `blocks` by directive (null where the outcome has no such entry), `begins`: those that read
/// otherwise where they begin a sentence, `more`: figures that the page does not show.
pub(super) fn render(
    laboratory: &Laboratory,
    example: &str,
    page: &str,
    outcome: &Outcome,
) -> Value {
    let mut data: Data = laboratory.data().clone();
    let of_example = |name: &str| name.split_once('/').is_some_and(|(owner, _)| owner == example);
    let directives = live::directives(page, &data);
    data.figures.retain(|name, _| !of_example(name));
    data.series.retain(|name, _| !of_example(name));
    let figures =
        outcome.figures.iter().map(|(name, svg)| (format!("{example}/{name}"), svg.clone()));
    data.figures.extend(figures);
    data.examples.insert(example.to_owned(), Value::Object(outcome.headline.clone()));
    let (mut blocks, mut begins) = (Map::new(), Map::new());
    let mut shown = BTreeSet::new();
    laboratory.with_sources(&data, |sources| {
        for (text, _) in directives.into_iter().filter(|(_, owner)| owner == example) {
            let html = match directive::resolve(&text, sources) {
                Ok(Meaning::Number(number)) => Value::from(number.html()),
                Ok(Meaning::Words(html)) => {
                    begins.insert(text.clone(), sentence::capitalised(&html).into());
                    Value::from(html)
                }
                Ok(Meaning::Block(html)) => Value::from(html),
                _ => Value::Null,
            };
            if !html.is_null() {
                shown.extend(directive::figures(&text, &data));
            }
            blocks.insert(text, html);
        }
    });
    let others = data.figures.iter().filter(|(name, _)| of_example(name) && !shown.contains(*name));
    let more: Vec<String> =
        others.filter_map(|(name, svg)| figure::inline(name, svg, name, false).ok()).collect();
    let verdict = outcome.headline.get("verdict").cloned().unwrap_or(Value::Null);
    json!({"seconds": outcome.seconds, "verdict": verdict, "blocks": blocks, "begins": begins, "more": more})
}
