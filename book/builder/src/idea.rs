//! Pictures of an idea: `{{idea: name: caption}}` includes `book/ideas/name.svg`, or the frames
//! `name.1.svg`, `name.2.svg`, .. of a slider, whose roots carry `data-parameter` and `data-label`. They show
//! no result, so no example draws them.

use crate::data::names;
use crate::markup::{escape, tags};
use crate::slider::Frame;
use crate::{figure, slider};
use std::path::Path;

/// The frames of a picture: each file, and its label where there are several.
///
/// # Errors
/// In words, a name that is not there.
pub fn frames(ideas: &Path, name: &str) -> Result<Vec<Frame>, String> {
    let is_frame = |file: &str| {
        let rest = file.strip_prefix(name).and_then(|rest| rest.strip_suffix("svg"));
        rest.is_some_and(|rest| rest.trim_matches('.').chars().all(|c| c.is_ascii_digit()))
    };
    let files = names(ideas).unwrap_or_default().into_iter().filter(|file| is_frame(file));
    let found: Vec<Frame> = files
        .filter_map(|file| {
            let svg = std::fs::read_to_string(ideas.join(&file)).ok()?;
            Some((attribute(&svg, "data-label"), file))
        })
        .collect();
    if name.is_empty() || found.is_empty() { Err("unknown idea".to_owned()) } else { Ok(found) }
}

/// An attribute of the root.
fn attribute(svg: &str, name: &str) -> String {
    tags(svg).next().and_then(|tag| tag.attribute(name)).unwrap_or("").to_owned()
}

/// What the slider of a picture moves, such as θ.
pub fn parameter(ideas: &Path, file: &str) -> String {
    std::fs::read_to_string(ideas.join(file))
        .map_or(String::new(), |svg| attribute(&svg, "data-parameter"))
}

/// The picture `name` as HTML with its caption.
///
/// # Errors
/// In words, a name that is not there, a file that is no picture.
pub fn inline(ideas: &Path, name: &str, caption: &str) -> Result<String, String> {
    let mut drawn = Vec::new();
    let mut parameter = String::new();
    for (label, file) in frames(ideas, name)? {
        let text = std::fs::read_to_string(ideas.join(&file)).map_err(|e| e.to_string())?;
        parameter = attribute(&text, "data-parameter");
        let spoken = format!("{caption}; {parameter}: {label}");
        drawn.push((label.clone(), figure::svg(&format!("idea/{name}-{label}"), &text, &spoken)?));
    }
    Ok(match drawn.as_slice() {
        [(_, svg)] => {
            format!(
                "<figure class=\"chart\">{svg}<figcaption>{}</figcaption></figure>",
                escape(caption)
            )
        }
        _ => slider::html(&parameter, &drawn, caption),
    })
}
