//! Code of an example shown on a page: one function of the file, with the comment above it.

use std::path::Path;

/// The function `name` of the example as a Markdown block.
///
/// # Errors
/// In words, when there is no such example or function.
pub fn block(examples: &Path, example: &str, name: &str) -> Result<String, String> {
    let file = examples.join(example).with_extension("rs");
    let source = std::fs::read_to_string(file).map_err(|_| "unknown example".to_owned())?;
    let code = function(&source, name).ok_or("the example has no such function")?;
    Ok(format!("```rust,ignore\n{code}\n```"))
}

/// A function at the outermost level of formatted code, with the comments and attributes above it.
fn function(source: &str, name: &str) -> Option<String> {
    let lines: Vec<&str> = source.lines().collect();
    let is_head = |line: &str| {
        let head = line.strip_prefix("pub ").unwrap_or(line);
        head.strip_prefix("fn ")
            .and_then(|rest| rest.strip_prefix(name))
            .is_some_and(|rest| rest.starts_with(['(', '<']))
    };
    let head = lines.iter().position(|line| is_head(line))?;
    let above = |line: &&&str| line.starts_with("//") || line.starts_with("#[");
    let first = head - lines[..head].iter().rev().take_while(above).count();
    let is_one_line = lines[head].ends_with(" }") || lines[head].ends_with("{}");
    let last = if is_one_line { head } else { head + lines[head..].iter().position(|line| *line == "}")? };
    Some(lines[first..=last].join("\n"))
}

#[cfg(test)]
mod tests {
    use super::*;

    const SOURCE: &str = "use x;\n\n/// Runs.\n#[must_use]\npub fn run(o: &O) -> u8 {\n    if a {\n        1\n    }\n}\n\n\
                          fn run_all() {}\n\nfn one() -> u8 { 1 }\n";

    #[test]
    fn functions_are_cut_out_whole() {
        let run = function(SOURCE, "run").unwrap();
        assert!(run.starts_with("/// Runs.\n#[must_use]\npub fn run(") && run.ends_with("    }\n}"), "{run}");
        assert_eq!(function(SOURCE, "one").unwrap(), "fn one() -> u8 { 1 }");
        assert_eq!(function(SOURCE, "two"), None);
        assert!(block(Path::new("/nowhere"), "x", "run").is_err());
    }
}
