//! Code included from examples: the file and the anchor must exist (mdBook itself would pass over them in
//! silence), and Rust code must stand in a block marked `rust,ignore`, because chapters are documentation
//! tests.

use crate::chapter::Page;
use crate::error::Fault;
use std::path::Path;

/// Faults of the lines `{{#include path:anchor}}` of a page; paths are relative to `source`.
pub fn faults(page: &Page, source: &Path) -> Vec<Fault> {
    let mut found = Vec::new();
    let mut fence = "";
    for (k, line) in page.text.lines().enumerate() {
        if let Some(info) = line.trim_start().strip_prefix("```") {
            fence = info.trim();
        }
        let mut rest = line;
        while let Some((_, after)) = rest.split_once("{{#") {
            let (body, behind) = after.split_once("}}").unwrap_or((after, ""));
            if let Some(what) = fault(body, fence, source) {
                found.push(Fault::new(&page.file, k + 1, what, body));
            }
            rest = behind;
        }
    }
    found
}

fn fault(body: &str, fence: &str, source: &Path) -> Option<String> {
    let Some(target) = body.strip_prefix("include ") else {
        return Some("not an include".to_owned());
    };
    let (path, anchor) = target.trim().split_once(':').unwrap_or((target.trim(), ""));
    let Ok(text) = std::fs::read_to_string(source.join(path)) else {
        return Some("included file does not exist".to_owned());
    };
    let has = |mark: &str| {
        text.lines()
            .any(|line| line.split_once(mark).is_some_and(|(_, name)| name.trim() == anchor))
    };
    let is_found = anchor.is_empty() || (has("ANCHOR: ") && has("ANCHOR_END: "));
    if !is_found {
        return Some("included file has no such anchor".to_owned());
    }
    let is_rust = Path::new(path).extension().is_some_and(|e| e == "rs");
    (is_rust && fence != "rust,ignore")
        .then(|| "included Rust code not in a `rust,ignore` block".to_owned())
}

/// The lines that `path:anchor` names, without the marks of anchors; `None` where there are none.
pub fn text(target: &str, source: &Path) -> Option<String> {
    let (path, anchor) = target.trim().split_once(':').unwrap_or((target.trim(), ""));
    let text = std::fs::read_to_string(source.join(path)).ok()?;
    let is = |line: &str, mark: &str| {
        line.split_once(mark).is_some_and(|(_, name)| name.trim() == anchor)
    };
    let mut lines: Vec<&str> = text.lines().collect();
    if !anchor.is_empty() {
        let start = lines.iter().position(|line| is(line, "ANCHOR: "))?;
        let end = lines.iter().position(|line| is(line, "ANCHOR_END: "))?;
        lines = lines.get(start + 1..end)?.to_vec();
    }
    lines.retain(|line| !line.contains("ANCHOR: ") && !line.contains("ANCHOR_END: "));
    Some(lines.join("\n"))
}
