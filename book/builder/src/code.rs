//! Code that a page shows or names: one function of an example with the comment above it; the name of an
//! example or of a test, which must exist.

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

/// The name of an example.
///
/// # Errors
/// In words, when there is none of that name.
pub fn program(examples: &Path, name: &str) -> Result<String, String> {
    let file = examples.join(name).with_extension("rs");
    if file.is_file() { Ok(name.to_owned()) } else { Err("unknown example".to_owned()) }
}

/// The name of a test file, or of a test in it: `lemma`, or `norms/products` for a module of a target.
///
/// # Errors
/// In words, when there is no such file, or no test of that name in it.
pub fn test(tests: &Path, file: &str, function: Option<&str>) -> Result<String, String> {
    // The toolkit has tests of its own.
    let directories = [tests.to_owned(), tests.with_file_name("toolkit").join("tests")];
    let read = |directory: &std::path::PathBuf| {
        std::fs::read_to_string(directory.join(file).with_extension("rs"))
    };
    let source = read(&directories[0]).or_else(|_| read(&directories[1]));
    let source = source.map_err(|_| "unknown test file".to_owned())?;
    let Some(function) = function else { return Ok(file.to_owned()) };
    let head = format!("fn {function}(");
    let mut lines = source.lines().map(str::trim);
    while lines.by_ref().any(|line| line.starts_with("#[test]")) {
        let heads = lines.by_ref().find(|line| line.starts_with("fn "));
        if heads.is_some_and(|line| line.starts_with(&head)) {
            return Ok(format!("{file}::{function}"));
        }
    }
    Err("the test file has no such test".to_owned())
}

/// A function at the outermost level of formatted code, with the comments and attributes above it.
fn function(source: &str, name: &str) -> Option<String> {
    let lines: Vec<&str> = source.lines().collect();
    let is_head = |line: &str| {
        let head =
            ["pub(crate) ", "pub "].iter().find_map(|open| line.strip_prefix(open)).unwrap_or(line);
        head.strip_prefix("fn ")
            .and_then(|rest| rest.strip_prefix(name))
            .is_some_and(|rest| rest.starts_with(['(', '<']))
    };
    let head = lines.iter().position(|line| is_head(line))?;
    let above = |line: &&&str| line.starts_with("//") || line.starts_with("#[");
    let first = head - lines[..head].iter().rev().take_while(above).count();
    let is_one_line = lines[head].ends_with(" }") || lines[head].ends_with("{}");
    let last = if is_one_line {
        head
    } else {
        head + lines[head..].iter().position(|line| *line == "}")?
    };
    Some(lines[first..=last].join("\n"))
}
