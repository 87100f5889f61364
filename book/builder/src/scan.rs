//! Cuts a chapter into prose, code, formulas and directives, before Markdown sees it.
//!
//! `$..$` and `$$..$$` are formulas, `{{name: ...}}` a directive of this builder, `{{#include ...}}` one of
//! mdBook (left alone). Nothing is looked for inside code (fenced, or between backticks) and HTML comments.
//! `\$` is a dollar sign. A formula may run over lines and not over an empty line.

use std::ops::Range;

/// What a piece of a chapter is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// Text that Markdown formats.
    Prose,
    /// Code or comment, kept as it is.
    Code,
    /// A formula within a line; the text is LaTeX without the dollars.
    Inline,
    /// A displayed formula; the text is LaTeX without the dollars.
    Display,
    /// What stands between `{{` and `}}`.
    Directive,
}

/// A piece of a chapter: its kind, its text without delimiters, and where it starts with them (bytes).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Piece<'a> {
    /// What it is.
    pub kind: Kind,
    /// Its text.
    pub text: &'a str,
    /// Offset of `text` in the chapter.
    pub start: usize,
}

/// Something that was opened and not closed: offset and what is missing.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Unclosed {
    /// Where it was opened (bytes).
    pub start: usize,
    /// What is missing.
    pub what: &'static str,
}

/// The line, from 1, in which the byte at `offset` stands.
pub fn line_at(text: &str, offset: usize) -> usize {
    1 + text.as_bytes()[..offset.min(text.len())].iter().filter(|&&b| b == b'\n').count()
}

/// Cuts a chapter into pieces; together they cover it, delimiters left out.
///
/// # Errors
/// The first formula or directive that is not closed.
pub fn pieces(text: &str) -> Result<Vec<Piece<'_>>, Unclosed> {
    let mut found = Vec::new();
    let mut at = 0;
    let mut prose = 0;
    while at < text.len() {
        let Some((kind, inner, end)) = opens(text, at)? else {
            at += text[at..].chars().next().map_or(1, char::len_utf8);
            continue;
        };
        if kind == Kind::Prose {
            at = end; // an escaped character
            continue;
        }
        push(&mut found, text, Kind::Prose, prose..at);
        push(&mut found, text, kind, inner);
        at = end;
        prose = end;
    }
    push(&mut found, text, Kind::Prose, prose..text.len());
    Ok(found)
}

fn push<'a>(found: &mut Vec<Piece<'a>>, text: &'a str, kind: Kind, range: Range<usize>) {
    if !range.is_empty() || matches!(kind, Kind::Inline | Kind::Display | Kind::Directive) {
        found.push(Piece { kind, start: range.start, text: &text[range] });
    }
}

type Opening = Option<(Kind, Range<usize>, usize)>;

/// What opens at byte `at`: its kind, the range of its text, and where it ends.
fn opens(text: &str, at: usize) -> Result<Opening, Unclosed> {
    let rest = &text[at..];
    if rest.starts_with('\\') {
        let escaped = rest.chars().nth(1).map_or(0, char::len_utf8);
        return Ok(Some((Kind::Prose, at..at, at + 1 + escaped)));
    }
    if rest.starts_with("<!--") {
        let end = rest.find("-->").map_or(text.len(), |k| at + k + 3);
        return Ok(Some((Kind::Code, at..end, end)));
    }
    if rest.starts_with('`') || rest.starts_with("~~~") {
        return Ok(code(text, at).map(|end| (Kind::Code, at..end, end)));
    }
    if rest.starts_with("{{#") {
        let end = rest.find("}}").map_or(text.len(), |k| at + k + 2);
        return Ok(Some((Kind::Code, at..end, end)));
    }
    if rest.starts_with("{{") {
        let Some(length) = rest.find("}}") else {
            return Err(Unclosed { start: at, what: "directive without `}}`" });
        };
        return Ok(Some((Kind::Directive, at + 2..at + length, at + length + 2)));
    }
    if rest.starts_with("$$") {
        return formula(text, at, "$$", Kind::Display).map(Some);
    }
    if rest.starts_with('$') {
        return formula(text, at, "$", Kind::Inline).map(Some);
    }
    Ok(None)
}

fn formula(
    text: &str,
    at: usize,
    dollars: &str,
    kind: Kind,
) -> Result<(Kind, Range<usize>, usize), Unclosed> {
    let start = at + dollars.len();
    let rest = &text[start..];
    let paragraph = ["\n\n", "\n>\n"].iter().filter_map(|gap| rest.find(gap)).min();
    let paragraph = paragraph.map_or(text.len(), |k| start + k);
    let mut k = start;
    while k < paragraph {
        if text[k..].starts_with('\\') {
            k += 1 + text[k + 1..].chars().next().map_or(0, char::len_utf8);
        } else if text[k..].starts_with(dollars) {
            return Ok((kind, start..k, k + dollars.len()));
        } else {
            k += text[k..].chars().next().map_or(1, char::len_utf8);
        }
    }
    Err(Unclosed { start: at, what: "formula without its closing dollar" })
}

/// The end of code opened at `at` by backticks or tildes; `None` when it is no code after all.
fn code(text: &str, at: usize) -> Option<usize> {
    let mark = text[at..].chars().next()?;
    let run = text[at..].chars().take_while(|&c| c == mark).count();
    let fence = &text[at..at + run];
    let line_start = text[..at].rfind('\n').map_or(0, |k| k + 1);
    let opens_line = text[line_start..at].chars().all(|c| c == ' ' || c == '>');
    if run >= 3 && opens_line {
        let mut k = at + text[at..].find('\n')? + 1;
        while k < text.len() {
            let end = text[k..].find('\n').map_or(text.len(), |n| k + n + 1);
            let line = text[k..end].trim_start_matches([' ', '>']).trim_end();
            if line.starts_with(fence) && line.chars().all(|c| c == mark) {
                return Some(end);
            }
            k = end;
        }
        return Some(text.len());
    }
    if mark == '~' {
        return None;
    }
    let mut k = at + run;
    while let Some(next) = text[k..].find('`') {
        let from = k + next;
        let length = text[from..].chars().take_while(|&c| c == '`').count();
        if length == run {
            return Some(from + length);
        }
        k = from + length;
    }
    // Backticks that nothing closes are text; skip the whole run.
    Some(at + run)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn kinds(text: &str) -> Vec<(Kind, &str)> {
        pieces(text).unwrap().iter().map(|p| (p.kind, p.text)).collect()
    }

    #[test]
    fn code_comments_and_escapes_hide_dollars() {
        for text in [
            "`$x$`",
            "``a ` $x$``",
            "```sh\necho $HOME $x\n```\n",
            "<!-- $x$ -->",
            "{{#include a.rs:b}}",
        ] {
            assert_eq!(kinds(text), vec![(Kind::Code, text)], "{text}");
        }
        assert_eq!(kinds(r"costs 3\$ and 4\$"), vec![(Kind::Prose, r"costs 3\$ and 4\$")]);
        assert_eq!(kinds(r"$a\$b$"), vec![(Kind::Inline, r"a\$b")]);
    }
}
