//! A figure of an example made part of a page: inline SVG that takes the ink of the page (light, dark, print)
//! and carries a label for those who do not see it.

use crate::markup::{Tag, escape, tags, well_formed};
use std::fmt::Write as _;

/// Ink written by chart writers that becomes the ink of the page.
const INK: [&str; 5] = ["black", "#000", "#000000", "rgb(0,0,0)", "rgb(0, 0, 0)"];
/// Paper written by chart writers that is left out.
const PAPER: [&str; 4] = ["white", "#fff", "#ffffff", "rgb(255,255,255)"];

/// The figure `name` as HTML: a `<figure>` with the SVG and its caption, which is also its label, and a link
/// to the numbers behind it where there are some.
///
/// # Errors
/// In words, when the text is no self-contained SVG.
pub fn inline(name: &str, text: &str, caption: &str, has_data: bool) -> Result<String, String> {
    let svg = svg(name, text, caption)?;
    let data = if has_data { data_link(name) } else { String::new() };
    Ok(format!(
        "<figure class=\"chart\">{svg}<figcaption>{}{data}</figcaption></figure>",
        escape(caption)
    ))
}

/// A link to the numbers behind the figure `name`.
pub fn data_link(name: &str) -> String {
    format!(" <a class=\"figure-data\" href=\"{}\" download>data (CSV)</a>", data_file(name))
}

/// Where these numbers are, below the directory of the pages.
pub fn data_file(name: &str) -> String {
    format!("data/{}.csv", name.replace('/', "."))
}

/// The SVG of the figure `name` alone, carrying a label.
///
/// # Errors
/// In words, when the text is no self-contained SVG.
pub fn svg(name: &str, svg: &str, label: &str) -> Result<String, String> {
    well_formed(svg).map_err(|what| format!("figure is not well-formed ({what})"))?;
    let mut html = String::new();
    let mut copied = 0;
    let mut is_root = true;
    for tag in tags(svg) {
        if is_root && tag.name != "svg" {
            return Err("figure does not start with <svg>".to_owned());
        }
        if matches!(tag.name, "script" | "image" | "foreignObject") {
            return Err(format!("figure contains <{}>", tag.name));
        }
        if !is_root && tag.name != "/style" {
            html.push_str(&svg[copied..tag.start]);
        }
        if matches!(tag.name, "style" | "/style") {
            // colours for a figure opened by itself; here they are the page's
        } else if is_root {
            push_root(&mut html, &tag, label)?;
        } else {
            push_tag(&mut html, &tag, name);
        }
        copied = tag.end;
        is_root = false;
    }
    if is_root { Err("figure is empty".to_owned()) } else { Ok(html) }
}

/// The root keeps its shape by its viewBox and takes the width of the page.
fn push_root(html: &mut String, tag: &Tag<'_>, label: &str) -> Result<(), String> {
    let length = |name| tag.attribute(name).map(|v| v.trim_end_matches("px"));
    let view = match (tag.attribute("viewBox"), length("width"), length("height")) {
        (Some(view), _, _) => view.to_owned(),
        (None, Some(width), Some(height)) => format!("0 0 {width} {height}"),
        _ => return Err("figure without viewBox and size".to_owned()),
    };
    let _ = write!(html, r#"<svg viewBox="{view}" role="img" aria-label="{}""#, escape(label));
    for (name, value) in tag.attributes() {
        let is_ours = matches!(name, "viewBox" | "width" | "height" | "role" | "aria-label");
        if !is_ours && !name.starts_with("xmlns") {
            push_attribute(html, name, value, "");
        }
    }
    html.push_str(if tag.closes_itself() { "/>" } else { ">" });
    Ok(())
}

fn push_tag(html: &mut String, tag: &Tag<'_>, figure: &str) {
    if tag.name.starts_with('/') {
        let _ = write!(html, "<{}>", tag.name);
        return;
    }
    let _ = write!(html, "<{}", tag.name);
    let prefix = figure.replace(|c: char| !c.is_ascii_alphanumeric(), "-");
    for (name, value) in tag.attributes() {
        push_attribute(html, name, value, &prefix);
    }
    html.push_str(if tag.closes_itself() { "/>" } else { ">" });
}

/// Names inside the figure get its name in front, so that two figures can stand on one page.
fn push_attribute(html: &mut String, name: &str, value: &str, prefix: &str) {
    let same = |list: &[&str]| list.iter().any(|c| c.eq_ignore_ascii_case(value));
    let value = match name {
        "id" => format!("{prefix}-{value}"),
        "href" | "xlink:href" => value.replace('#', &format!("#{prefix}-")),
        "fill" | "stroke" if same(&INK) => "currentColor".to_owned(),
        "fill" if same(&PAPER) => "none".to_owned(),
        _ => value.replace("url(#", &format!("url(#{prefix}-")),
    };
    let _ = write!(html, r#" {name}="{value}""#);
}
