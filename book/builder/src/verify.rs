//! The built pages, looked at as a browser would: every link and every anchor leads somewhere, nothing is
//! fetched from elsewhere, every formula is well-formed.

use crate::chapter::Page;
use crate::data::names;
use crate::error::{Fault, Result, read};
use crate::markup::{tags, well_formed};
use crate::scan::line_at;
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

/// A built page: its links and the anchors it offers.
struct Built {
    links: Vec<String>,
    anchors: BTreeSet<String>,
    bad_formulas: Vec<String>,
}

/// Faults of the built pages in `output`, each traced to the source page where that is possible.
///
/// # Errors
/// [`crate::error::Error::File`] when a built page cannot be read.
pub fn faults(output: &Path, pages: &[Page]) -> Result<Vec<Fault>> {
    let mut built = BTreeMap::new();
    for name in names(output)?.into_iter().filter(|name| name.ends_with(".html")) {
        let page = look(&read(&output.join(&name))?);
        built.insert(name, page);
    }
    let mut found = Vec::new();
    for (name, page) in &built {
        for link in &page.links {
            if let Some(what) = dead(link, name, &built, output) {
                found.push(locate(what, link, name, pages));
            }
        }
        for (what, formula) in page.bad_formulas.iter().map(|f| ("formula is not well-formed", f)) {
            found.push(locate(what, formula, name, pages));
        }
    }
    Ok(found)
}

fn look(html: &str) -> Built {
    let mut built = Built { links: Vec::new(), anchors: BTreeSet::new(), bad_formulas: Vec::new() };
    for tag in tags(html) {
        for (name, value) in tag.attributes() {
            match name {
                "href" | "src" | "xlink:href" | "srcset" | "poster" | "action" => {
                    built.links.push(value.to_owned())
                }
                "id" | "name" => drop(built.anchors.insert(value.to_owned())),
                _ => {}
            }
        }
        if tag.name == "math" {
            let end = html[tag.start..].find("</math>").map_or(html.len(), |k| tag.start + k + 7);
            if let Err(what) = well_formed(&html[tag.start..end]) {
                built.bad_formulas.push(what);
            }
        }
    }
    built
}

/// Why a link of page `name` leads nowhere, if so.
fn dead(
    link: &str,
    name: &str,
    built: &BTreeMap<String, Built>,
    output: &Path,
) -> Option<&'static str> {
    if link.contains("://") || link.starts_with("//") || link.starts_with("data:") {
        return Some("link out of the book");
    }
    let (path, anchor) = link.split_once('#').unwrap_or((link, ""));
    let path = path.split('?').next().unwrap_or("");
    let target = if path.is_empty() { name } else { path.trim_start_matches("./") };
    let Some(page) = built.get(target) else {
        return (!output.join(target).is_file()).then_some("dead link");
    };
    let leads_nowhere = !anchor.is_empty() && !page.anchors.contains(anchor);
    leads_nowhere.then_some("dead anchor")
}

/// The source line that a fault of a built page comes from.
fn locate(what: &str, link: &str, name: &str, pages: &[Page]) -> Fault {
    let home =
        if name == "index.html" { pages.first() } else { pages.iter().find(|p| p.html == name) };
    let Some(page) = home else {
        return Fault::new(Path::new(name), 1, what, link);
    };
    let written = link.replace(".html", ".md");
    let at = page.text.find(link).or_else(|| page.text.find(&written));
    Fault::new(&page.file, line_at(&page.text, at.unwrap_or(0)), what, link)
}
