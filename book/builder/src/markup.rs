//! Just enough of markup to look into MathML, SVG and the built pages: tags, attributes, balance.

/// A start tag in a text: name, where it starts and ends (bytes), and its inner text.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Tag<'a> {
    /// The name, `svg` of `<svg width="1">`; `/svg` of an end tag.
    pub name: &'a str,
    /// What stands between name and bracket.
    pub inner: &'a str,
    /// Offset of `<`.
    pub start: usize,
    /// Offset behind `>`.
    pub end: usize,
}

impl<'a> Tag<'a> {
    /// The value of an attribute in quotes.
    pub fn attribute(&self, name: &str) -> Option<&'a str> {
        self.attributes().find(|(n, _)| *n == name).map(|(_, value)| value)
    }

    /// All attributes with a value in quotes.
    pub fn attributes(&self) -> impl Iterator<Item = (&'a str, &'a str)> {
        let mut rest = self.inner;
        std::iter::from_fn(move || {
            let (before, after) = rest.split_once('=')?;
            let quote = after.chars().next().filter(|c| matches!(c, '"' | '\''))?;
            let (value, next) = after[1..].split_once(quote)?;
            rest = next;
            Some((before.split_whitespace().last().unwrap_or(""), value))
        })
    }

    /// True for `<path .../>`.
    pub fn closes_itself(&self) -> bool {
        self.inner.ends_with('/')
    }
}

/// The tags of a text in order; comments, declarations and the text of scripts are passed over.
pub fn tags(text: &str) -> impl Iterator<Item = Tag<'_>> {
    let mut at = 0;
    std::iter::from_fn(move || {
        loop {
            let start = at + text[at..].find('<')?;
            if let Some(rest) = text[start..].strip_prefix("<!--") {
                at = start + 4 + rest.find("-->")? + 3;
                continue;
            }
            let end = tag_end(text, start)?;
            let body = &text[start + 1..end - 1];
            at = end;
            if body.starts_with(['!', '?']) {
                continue;
            }
            let cut = body.find(|c: char| c.is_whitespace()).unwrap_or(body.len());
            let name = body[..cut].trim_end_matches('/');
            if name == "script" {
                at = end + text[end..].find("</script").unwrap_or(0);
            }
            let inner = if body.len() > name.len() { &body[name.len()..] } else { "" };
            return Some(Tag { name, inner, start, end });
        }
    })
}

/// Behind the `>` that closes the tag at `start`; a `>` in quotes does not.
fn tag_end(text: &str, start: usize) -> Option<usize> {
    let mut quote = None;
    for (k, c) in text[start..].char_indices() {
        match (quote, c) {
            (None, '>') => return Some(start + k + 1),
            (None, '"' | '\'') => quote = Some(c),
            (Some(q), _) if q == c => quote = None,
            _ => {}
        }
    }
    None
}

/// Every tag closed by its own end tag, in XML's sense.
///
/// # Errors
/// The first tag that is not.
pub fn well_formed(text: &str) -> Result<(), String> {
    let mut open: Vec<&str> = Vec::new();
    for tag in tags(text) {
        if let Some(name) = tag.name.strip_prefix('/') {
            if open.pop() != Some(name) {
                return Err(format!("</{name}> closes nothing"));
            }
        } else if !tag.closes_itself() {
            open.push(tag.name);
        }
    }
    open.last().map_or(Ok(()), |name| Err(format!("<{name}> is not closed")))
}

/// Text made safe between tags and in attributes.
pub fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}
