//! Options of an example: declaration, parsing by clap, and description for the pages of the book.

use crate::{Error, Result};
use clap::{Arg, ArgAction, Command, arg};
use fractional_sobolev::{Order, Tolerance};
use serde_json::{Value, json};
use signorini::cone::Cone;
use signorini::problems::{NamedProblem, StripData, TestProblem};
use signorini::singular::SideConditions;
use signorini::strip::StripKind;
use std::path::{Path, PathBuf};

/// Options of an example; implemented by [`crate::example!`].
pub trait Declarations: Sized {
    /// The paper's label.
    const LABEL: &'static str;
    /// The statement, in one or two lines.
    const STATEMENT: &'static str;
    /// `quick`, `seconds` or `long`.
    const COST: &'static str;

    /// All options.
    fn declared() -> Vec<Declared>;

    /// Parses all options; `given` returns the text of an option, from its name and default.
    ///
    /// # Errors
    /// The first option that cannot be parsed or is out of its range.
    fn read(given: &dyn Fn(&str, &str) -> String) -> Result<Self>;
}

/// The declaration of one option.
#[derive(Debug, Clone)]
pub struct Declared {
    name: &'static str,
    help: &'static str,
    default: &'static str,
    range: &'static str,
    slider: &'static str,
    kind: &'static str,
    list: bool,
    choices: Vec<String>,
}

impl Declared {
    /// An option of type `T`; `range` such as "(0, 1]", `slider` such as "0.1 to 10" or "0.1 to 10
    /// by factors"; each may be empty.
    pub fn of<T: OptionValue>([name, help, default, range, slider]: [&'static str; 5]) -> Self {
        let help = help.trim();
        Self {
            name,
            help,
            default,
            range,
            slider,
            kind: T::KIND,
            list: T::LIST,
            choices: T::choices(),
        }
    }

    fn argument(&self) -> Arg {
        let mut help = self.help.to_owned();
        if !self.range.is_empty() {
            help += &format!(", in {}", self.range);
        }
        if !self.choices.is_empty() {
            help += &format!(": {}", self.choices.join(", "));
        }
        let argument = Arg::new(self.name).long(self.name.replace('_', "-")).help(help);
        if self.kind == "flag" {
            return argument.action(ArgAction::SetTrue);
        }
        // A value may be a negative number, so that `--nu -0.1` is answered by what it means;
        // `-0.5,0` is no number.
        let argument = match (self.kind, self.list) {
            ("text", _) | ("number", true) => argument.allow_hyphen_values(true),
            _ => argument.allow_negative_numbers(true),
        };
        if self.default.is_empty() { argument } else { argument.default_value(self.default) }
    }

    /// The description for the pages of the book; `None` for an option that they do not offer.
    fn json(&self) -> Option<Value> {
        if matches!(self.kind, "file" | "text") {
            return None;
        }
        let mut option = json!({
            "name": self.name.replace('_', "-"),
            "help": self.help,
            "kind": self.kind,
            "list": self.list,
            "default": self.default,
        });
        if !self.choices.is_empty() {
            option["choices"] = json!(self.choices);
        }
        if let Some((low, high)) = ends(self.range) {
            option["range"] = json!([low, high]);
        }
        let steps = self.slider.strip_suffix(" by factors");
        if let Some((low, high)) = steps.unwrap_or(self.slider).split_once(" to ")
            && let (Ok(low), Ok(high)) = (low.parse::<f64>(), high.parse::<f64>())
        {
            option["slider"] = json!([low, high]);
            option["scale"] = json!(if steps.is_some() { "factors" } else { "steps" });
        }
        Some(option)
    }
}

/// What an example declares, as values: what reads them is compiled once, not in every example.
pub(crate) struct About {
    pub(crate) label: &'static str,
    pub(crate) statement: &'static str,
    cost: &'static str,
    options: Vec<Declared>,
}

impl About {
    pub(crate) fn of<P: Declarations>() -> Self {
        let (label, statement, cost) = (P::LABEL, P::STATEMENT, P::COST);
        Self { label, statement, cost, options: P::declared() }
    }

    fn title(&self) -> String {
        format!("{}: {}", self.label, self.statement)
    }
}

/// `--describe`: the options, from which a page makes its input fields and sliders.
pub(crate) fn describe(about: &About) -> Value {
    let options: Vec<Value> = about.options.iter().filter_map(Declared::json).collect();
    json!({"about": about.title(), "cost": about.cost, "options": options})
}

/// How to read a report; the end of `--help`.
const LEGEND: &str = "\
How to read the report:
  Each line below the table is a check: mark, claim, number, bound, source of the bound.
  ✓ holds   ✗ fails   ? undecided within the errors   ∎ proved on that page of the book
  A number x with an error ± counts with its whole error bar, from x − ± to x + ±:
    x ≤ b      holds if x + ± ≤ b       fails if x − ± > b       undecided in between
    x ≥ b      holds if x − ± ≥ b       fails if x + ± < b
    x = b ± t  holds if |x − b| + ± ≤ t   fails if |x − b| − ± > t
  Of several cases of one check the worst is shown, with their number.
  The last line is the status of the statement, from its checks:
    true               every claim holds
    loose              true, and a stronger statement is true too
    not sharp          true, and the true rate of growth is another
    false as printed   the paper's own form fails; a corrected one is true
    fails, undecided   a claim does or is: exit code 1 (an error: 2)";

/// The command line of an example.
pub(crate) fn command(about: &About) -> Command {
    let path = std::env::args().next().unwrap_or_default();
    let name = Path::new(&path).file_stem().map_or("example".into(), |stem| stem.to_string_lossy());
    Command::new(name.into_owned())
        .about(about.title())
        .after_help(LEGEND)
        .args(about.options.iter().map(Declared::argument))
        .arg(arg!(--json "one JSON object per row and check, with all digits"))
        .arg(arg!(--out <PATH> "directory for pictures (SVG)"))
        .arg(
            arg!(--values <PATH> "file for the whole outcome as one JSON object, read by the book")
                .hide(true),
        )
        .arg(arg!(--describe "print the options as JSON, without a computation").hide(true))
        .arg(
            arg!(--fault <CHECK>)
                .help("move the value of a check across its bound; `every`: each in turn")
                .hide(true),
        )
}

/// The value of an option; a number has to lie in the range.
///
/// # Errors
/// [`Error::Option`] with the reason.
pub fn read_option<T: OptionValue>(
    name: &str,
    text: &str,
    default: &str,
    range: &str,
) -> Result<T> {
    if T::LIST && text.trim().is_empty() && !default.is_empty() {
        return Err(Error::option(name, "a value is missing"));
    }
    T::read(text, range).map_err(|what| Error::option(name, &what))
}

/// Whether a number lies in an interval such as "(0, 1]".
fn within(place: f64, range: &str) -> std::result::Result<(), String> {
    if !place.is_finite() {
        return Err("not a finite number".to_owned());
    }
    let Some((low, high)) = ends(range) else { return Ok(()) };
    let is_inside = (place > low || range.starts_with('[') && place == low)
        && (place < high || range.ends_with(']') && place == high);
    if is_inside { Ok(()) } else { Err(format!("{place} is not in {range}")) }
}

fn ends(range: &str) -> Option<(f64, f64)> {
    let (low, high) = range.strip_prefix(['(', '['])?.strip_suffix([')', ']'])?.split_once(',')?;
    Some((low.trim().parse().ok()?, high.trim().parse().ok()?))
}

/// A type of option values.
pub trait OptionValue: Sized {
    /// The kind of input field on a page.
    const KIND: &'static str;
    /// True if a comma-separated list is expected.
    const LIST: bool = false;

    /// Parses the text of the command line; a number has to lie in the range, unless that is empty.
    ///
    /// # Errors
    /// The reason, as text.
    fn read(text: &str, range: &str) -> std::result::Result<Self, String>;

    /// The admissible names; empty for a number.
    fn choices() -> Vec<String> {
        Vec::new()
    }
}

/// Types that are read by their own `FromStr`: the kind for the page, the number, and the
/// admissible names.
macro_rules! option_value {
    ($($kind:ty, $word:literal $(, at $place:expr)? $(, of $words:expr)?;)*) => {
        $(impl OptionValue for $kind {
            const KIND: &'static str = $word;
            fn read(text: &str, _range: &str) -> std::result::Result<Self, String> {
                let value = text.trim().parse::<$kind>().map_err(|error| error.to_string())?;
                $(
                let place: fn(&$kind) -> f64 = $place;
                within(place(&value), _range)?;
                )?
                Ok(value)
            }
            $(fn choices() -> Vec<String> {
                $words
            })?
        })*
    };
}

option_value! {
    f64, "number", at |x| *x;
    usize, "integer", at |x| *x as f64;
    u32, "integer", at |x| f64::from(*x);
    Order, "order", at |x| x.value();
    Tolerance, "tolerance";
    String, "text";
    PathBuf, "file";
    Cone, "choice", of Cone::ALL.iter().map(ToString::to_string).collect();
    StripKind, "choice", of vec!["scalar".to_owned(), "elastic".to_owned()];
    SideConditions, "choice", of SideConditions::ALL.iter().map(ToString::to_string).collect();
    TestProblem, "named", of bodies();
    StripData, "named", of strips();
    NamedProblem, "named", of [bodies(), strips()].concat();
}

impl OptionValue for bool {
    const KIND: &'static str = "flag";
    fn read(text: &str, _range: &str) -> std::result::Result<Self, String> {
        Ok(text == "true")
    }
}

impl<T: OptionValue> OptionValue for Vec<T> {
    const KIND: &'static str = T::KIND;
    const LIST: bool = true;
    fn read(text: &str, range: &str) -> std::result::Result<Self, String> {
        if text.trim().is_empty() {
            return Ok(Vec::new());
        }
        text.split(',').map(|part| T::read(part, range)).collect()
    }
    fn choices() -> Vec<String> {
        T::choices()
    }
}

impl<T: OptionValue> OptionValue for Option<T> {
    const KIND: &'static str = T::KIND;
    fn read(text: &str, range: &str) -> std::result::Result<Self, String> {
        if text.trim().is_empty() { Ok(None) } else { T::read(text, range).map(Some) }
    }
    fn choices() -> Vec<String> {
        T::choices()
    }
}

/// Problems on strips that need no file.
fn strips() -> Vec<String> {
    let names = StripData::all().into_iter().map(|data| data.name().to_owned());
    names.filter(|name| name.parse::<StripData>().is_ok()).collect()
}

fn bodies() -> Vec<String> {
    TestProblem::all().iter().map(|problem| problem.name().to_owned()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_choice_is_read() {
        fn are_read<T: OptionValue>(tails: &[&str]) {
            for word in T::choices() {
                let mut all = tails.iter().map(|tail| format!("{word}{tail}"));
                assert!(all.any(|text| T::read(&text, "").is_ok()), "{word}");
            }
        }
        are_read::<Cone>(&[""]);
        are_read::<StripKind>(&[""]);
        are_read::<SideConditions>(&[""]);
        are_read::<NamedProblem>(&["", ":0.5", ":0.3:4"]);
    }
}
