//! Frames of a figure with a slider to move between them: `{{slider: parameter: frames: caption}}`.
//!
//! Frames are separated by commas; each is `label = example/figure`, or `example/prefix*` for all figures of
//! that prefix, labelled by the rest of their names. Numeric labels are put in order. Without JavaScript, and
//! on paper, the middle frame is shown alone; with it, `book/style/slider.js` adds a native range input,
//! which the keyboard moves.

use crate::data::Data;
use crate::figure;
use crate::markup::escape;
use std::fmt::Write as _;

/// A frame: its label, and the full name of its figure or the figure itself.
pub type Frame = (String, String);

/// The frames of a list, in order.
///
/// # Errors
/// In words, a figure that is not there.
pub fn frames(list: &str, data: &Data) -> Result<Vec<Frame>, String> {
    let mut found: Vec<Frame> = Vec::new();
    for item in list.split(',').map(str::trim) {
        if let Some(prefix) = item.strip_suffix('*') {
            let rest = |name: &String| Some((name.strip_prefix(prefix)?.to_owned(), name.clone()));
            found.extend(data.figures.keys().filter_map(rest));
        } else {
            let (label, name) =
                item.split_once('=').ok_or("a frame is `label = figure` or `prefix*`")?;
            let (full, _) = data.figure(name.trim()).map_err(|e| e.words("figure"))?;
            found.push((label.trim().to_owned(), full.to_owned()));
        }
    }
    if found.len() < 2 {
        return Err("a slider needs two frames (does `cargo book` need to be run?)".to_owned());
    }
    if found.iter().all(|(label, _)| label.parse::<f64>().is_ok()) {
        let number = |frame: &Frame| frame.0.parse::<f64>().unwrap_or(0.0);
        found.sort_by(|a, b| number(a).total_cmp(&number(b)));
    }
    Ok(found)
}

/// The slider as HTML.
///
/// # Errors
/// In words, what is wrong with a frame or a figure.
pub fn inline(parameter: &str, list: &str, caption: &str, data: &Data) -> Result<String, String> {
    let mut drawn = Vec::new();
    for (label, name) in frames(list, data)? {
        let spoken = format!("{caption}; {parameter}: {label}");
        let link =
            if data.series.contains_key(&name) { figure::data_link(&name) } else { String::new() };
        drawn.push((label, figure::svg(&name, &data.figures[&name], &spoken)? + &link));
    }
    Ok(html(parameter, &drawn, caption))
}

/// Frames with their labels and the slider between them.
pub fn html(parameter: &str, frames: &[Frame], caption: &str) -> String {
    let shown = (frames.len() - 1) / 2;
    let mut html = format!(
        "<figure class=\"chart\"><figure-slider data-parameter=\"{}\" data-shown=\"{shown}\">",
        escape(parameter)
    );
    for (k, (label, svg)) in frames.iter().enumerate() {
        let hidden = if k == shown { "" } else { " hidden" };
        let _ = write!(
            html,
            "<div class=\"frame\" data-label=\"{}\"{hidden}>{svg}</div>",
            escape(label)
        );
    }
    let _ = write!(html, "</figure-slider><figcaption>{}</figcaption></figure>", escape(caption));
    html
}

#[cfg(test)]
mod tests {
    use super::*;

    fn data() -> Data {
        let names = ["ex/edge_1e-1", "ex/edge_1e-3", "ex/edge_1e-2", "ex/other"];
        let svg = || "<svg viewBox=\"0 0 1 1\"><path d=\"M0 0\"/></svg>".to_owned();
        Data { figures: names.map(|name| (name.to_owned(), svg())).into(), ..Data::default() }
    }

    #[test]
    fn frames_are_listed_or_found_by_prefix_in_order() {
        let labels = |list: &str| {
            frames(list, &data()).map(|f| f.into_iter().map(|(label, _)| label).collect::<Vec<_>>())
        };
        assert_eq!(labels("ex/edge_*").unwrap(), ["1e-3", "1e-2", "1e-1"]);
        assert_eq!(labels("b = other, a = ex/edge_1e-1").unwrap(), ["b", "a"]);
        for bad in ["ex/none*", "a = other", "a = none, b = other", "other, other"] {
            assert!(labels(bad).is_err(), "{bad}");
        }
    }
}
