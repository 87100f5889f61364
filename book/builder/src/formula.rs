//! Formulas: LaTeX to MathML for the whole book at once, so that numbers and references run through all
//! pages.

use crate::markup;
use math_core::{LatexToMathML, MathCoreConfig, MathDisplay};
use std::collections::BTreeMap;

/// Short names for symbols of the paper, usable in every formula.
pub const MACROS: [(&str, &str); 6] = [
    ("R", r"\mathbb{R}"),
    ("dd", r"\,\mathrm{d}"),
    ("abs", r"\left|#1\right|"),
    ("norm", r"\left\|#1\right\|"),
    ("sigN", r"\sigma_{\mathrm N}"),
    ("uN", r"u_{\mathrm N}"),
];

/// A formula of a page.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Formula {
    /// Number of the page it stands on.
    pub page: usize,
    /// The line it starts at.
    pub line: usize,
    /// LaTeX, values filled in.
    pub latex: String,
    /// Displayed, or within a line.
    pub is_display: bool,
}

/// A formula that could not be used: which, why, the offending text.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Refused {
    /// Its place in the list.
    pub formula: usize,
    /// Why.
    pub what: String,
    /// The offending text.
    pub text: String,
}

/// Where a `\label` stands.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Label {
    /// Number of its page.
    pub page: usize,
    /// Its number in the book, without parentheses.
    pub number: String,
}

/// The labels of the book by name.
pub type Labels = BTreeMap<String, Label>;

/// MathML for each formula, in order, and the page of each label.
///
/// # Errors
/// Every formula that does not parse, every label given twice, every reference to a label that is nowhere.
pub fn convert(formulas: &[Formula]) -> Result<(Vec<String>, Labels), Vec<Refused>> {
    let mut refused = Vec::new();
    let mut labels = Labels::new();
    for (k, formula) in formulas.iter().enumerate() {
        for label in arguments(&formula.latex, r"\label{") {
            let is_plain = label.chars().all(|c| c.is_ascii_alphanumeric() || c == '-');
            if !is_plain {
                refused.push(refuse(k, "label not of letters, digits and hyphens", label));
            }
            if labels
                .insert(label.to_owned(), Label { page: formula.page, number: String::new() })
                .is_some()
            {
                refused.push(refuse(k, "label given twice", label));
            }
        }
    }
    for (k, formula) in formulas.iter().enumerate() {
        for label in arguments(&formula.latex, r"\eqref{") {
            if !labels.contains_key(label) {
                refused.push(refuse(k, "reference to an unknown label", label));
            }
        }
    }
    let mut converted = Vec::new();
    // A reference to each label tells its number.
    let reference = |(name, label): (&String, &Label)| Formula {
        page: label.page,
        line: 1,
        latex: format!("\\eqref{{{name}}}"),
        is_display: false,
    };
    let all: Vec<Formula> = formulas.iter().cloned().chain(labels.iter().map(reference)).collect();
    let mut results = mathml(&all);
    for (label, result) in labels.values_mut().zip(results.split_off(formulas.len())) {
        let text = result.unwrap_or_default();
        let number = text.split_once(">(").and_then(|(_, rest)| rest.split_once(")<"));
        label.number = number.map_or(String::new(), |(number, _)| number.to_owned());
    }
    for (k, (result, formula)) in results.into_iter().zip(formulas).enumerate() {
        match result {
            Ok(mathml) => converted.push(mathml),
            Err((what, at)) => {
                let text =
                    formula.latex.get(at).filter(|t| !t.is_empty()).unwrap_or(&formula.latex);
                let what = format!("formula does not parse ({what}) in {}", formula.latex.trim());
                refused.push(refuse(k, &what, text));
            }
        }
    }
    if refused.is_empty() { Ok((converted, labels)) } else { Err(refused) }
}

fn refuse(formula: usize, what: &str, text: &str) -> Refused {
    Refused { formula, what: what.to_owned(), text: text.to_owned() }
}

type Converted = Result<String, (String, std::ops::Range<usize>)>;

fn mathml(formulas: &[Formula]) -> Vec<Converted> {
    let macros = MACROS.map(|(name, meaning)| (name.to_owned(), meaning.to_owned()));
    let config = MathCoreConfig { macros: macros.into(), ..MathCoreConfig::default() };
    // The macros are constants and a test parses them; without them each formula that uses one is refused.
    let converter = LatexToMathML::new(config).unwrap_or_default();
    let snippets: Vec<(&str, MathDisplay)> = formulas
        .iter()
        .map(|f| {
            (f.latex.trim(), if f.is_display { MathDisplay::Block } else { MathDisplay::Inline })
        })
        .collect();
    let results = converter.convert_all(&snippets).into_iter().zip(formulas);
    results
        .map(|(result, formula)| {
            let lead = formula.latex.len() - formula.latex.trim_start().len();
            match result {
                Ok(result) => markup::well_formed(&result.mathml)
                    .map(|()| primes(&result.mathml))
                    .map_err(|what| (what, 0..0)),
                Err(e) => Err((e.error_message(), e.0.start + lead..e.0.end + lead)),
            }
        })
        .collect()
}

/// Primes at full size and lowered: Chromium does not take the font's glyph for a superscript (feature
/// `ssty`) and sets the one that is small and high already still smaller and higher.
fn primes(mathml: &str) -> String {
    const PRIME: &str = "<mo>′</mo>";
    const LOWERED: &str =
        r#"<mpadded voffset="-0.4em" height="0.2em"><mo scriptlevel="0">′</mo></mpadded>"#;
    ["</msup>", "</msubsup>"].iter().fold(mathml.to_owned(), |text, end| {
        text.replace(&format!("{PRIME}{end}"), &format!("{LOWERED}{end}"))
    })
}

/// The arguments of a command, such as the labels of `\label{...}`.
fn arguments<'a>(latex: &'a str, command: &'a str) -> impl Iterator<Item = &'a str> {
    latex
        .split(command)
        .skip(1)
        .filter_map(|rest| rest.split_once('}').map(|(argument, _)| argument))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn formula(page: usize, latex: &str) -> Formula {
        Formula { page, line: 1, latex: latex.to_owned(), is_display: true }
    }

    #[test]
    fn primes_are_lowered() {
        let (mathml, _) = convert(&[formula(0, r"u' + \uN'")]).unwrap();
        assert_eq!(mathml[0].matches("voffset").count(), 2, "{}", mathml[0]);
    }
}
