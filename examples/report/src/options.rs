//! Options of an example: declaration, parsing by clap, and description for the pages of the book.

use crate::{Error, Result};
use clap::{Arg, ArgAction, Command};
use fractional_sobolev::{Order, Tolerance};
use serde_json::{Value, json};
use signorini::cone::Cone;
use signorini::problems::{NamedProblem, StripData, TestProblem};
use signorini::singular::SideConditions;
use signorini::strip::StripKind;

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

    /// Parses all options.
    ///
    /// # Errors
    /// The first option that cannot be parsed.
    fn read(given: &dyn Fn(&str) -> String) -> Result<Self>;

    /// The options of an empty command line.
    ///
    /// # Panics
    /// A default that cannot be parsed: an error of the declaration.
    fn of_defaults() -> Self {
        let declared = Self::declared();
        let default = |name: &str| {
            declared
                .iter()
                .find(|option| option.name == name)
                .map_or(String::new(), |option| option.default.to_owned())
        };
        Self::read(&default).unwrap_or_else(|error| panic!("{}: {error}", Self::LABEL))
    }
}

/// The declaration of one option.
#[derive(Debug, Clone)]
pub struct Declared {
    pub(crate) name: &'static str,
    help: &'static str,
    pub(crate) default: &'static str,
    range: &'static str,
    slider: &'static str,
    pub(crate) kind: &'static str,
    list: bool,
    choices: Vec<String>,
    check: fn(&str, &str) -> std::result::Result<(), String>,
}

impl Declared {
    /// An option of type `T`; `range` such as "(0, 1]", `slider` such as "0.1 to 10" or "0.1 to 10 by
    /// factors"; each may be empty.
    pub fn of<T: OptionValue>(
        name: &'static str,
        help: &'static str,
        default: &'static str,
        range: &'static str,
        slider: &'static str,
    ) -> Self {
        let check = |text: &str, range: &str| {
            let value = T::read(text)?;
            value.places().into_iter().try_for_each(|place| within(place, range))
        };
        Self {
            name,
            help: help.trim(),
            default,
            range,
            slider,
            kind: T::KIND,
            list: T::LIST,
            choices: T::choices(),
            check,
        }
    }

    /// Checks that a text is a value of this option.
    pub(crate) fn check(&self, text: &str) -> Result<()> {
        if self.list && text.trim().is_empty() && !self.default.is_empty() {
            return Err(Error::option(self.name, "a value is missing"));
        }
        (self.check)(text, self.range).map_err(|what| Error::option(self.name, &what))
    }

    pub(crate) fn argument(&self) -> Arg {
        let long = self.name.replace('_', "-");
        let range = if self.range.is_empty() { String::new() } else { format!(", in {}", self.range) };
        let choices =
            if self.choices.is_empty() { String::new() } else { format!(": {}", self.choices.join(", ")) };
        let argument = Arg::new(self.name).long(long).help(format!("{}{range}{choices}", self.help));
        if self.kind == "flag" {
            return argument.action(ArgAction::SetTrue);
        }
        // A value may be a negative number, so that `--nu -0.1` is answered by what it means.
        let argument = match self.kind {
            // Also a list of numbers, since `-0.5,0` is none.
            "text" => argument.allow_hyphen_values(true),
            "number" if self.list => argument.allow_hyphen_values(true),
            _ => argument.allow_negative_numbers(true),
        };
        if self.default.is_empty() { argument } else { argument.default_value(self.default) }
    }

    /// The description for the pages of the book; `None` for an option that they do not offer.
    fn json(&self) -> Option<Value> {
        let offered = !matches!(self.kind, "file" | "text");
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
        let (by_factors, slider) = match self.slider.strip_suffix(" by factors") {
            Some(slider) => (true, slider),
            None => (false, self.slider),
        };
        if let Some((Ok(low), Ok(high))) =
            slider.split_once(" to ").map(|(a, b)| (a.parse::<f64>(), b.parse::<f64>()))
        {
            option["slider"] = json!([low, high]);
            option["scale"] = json!(if by_factors { "factors" } else { "steps" });
        }
        offered.then_some(option)
    }
}

/// `--describe`: the options, from which a page makes its input fields and sliders.
pub(crate) fn describe<P: Declarations>() -> Value {
    let options: Vec<Value> = P::declared().iter().filter_map(Declared::json).collect();
    json!({"about": format!("{}: {}", P::LABEL, P::STATEMENT), "cost": P::COST, "options": options})
}

/// The command line of an example.
pub(crate) fn command<P: Declarations>() -> Command {
    let name = std::env::args().next().unwrap_or_default();
    let name = std::path::Path::new(&name)
        .file_stem()
        .map_or("example".to_owned(), |n| n.to_string_lossy().into_owned());
    let flag = |name: &'static str, help: &'static str| {
        Arg::new(name).long(name).help(help).action(ArgAction::SetTrue)
    };
    let file =
        |name: &'static str, help: &'static str| Arg::new(name).long(name).help(help).value_name("PATH");
    Command::new(name)
        .about(format!("{}: {}", P::LABEL, P::STATEMENT))
        .args(P::declared().iter().map(Declared::argument))
        .arg(flag("json", "one JSON object per row and check, with all digits"))
        .arg(file("out", "directory for pictures (SVG)"))
        .arg(file("values", "file for the whole outcome as one JSON object, read by the book").hide(true))
        .arg(flag("describe", "print the options as JSON, without a computation").hide(true))
        .arg(
            Arg::new("fault")
                .long("fault")
                .value_name("CHECK")
                .help("move the value of a check across its bound; with `every`, each check in turn, outcome unchanged")
                .hide(true),
        )
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

    /// Parses the text of the command line.
    ///
    /// # Errors
    /// The reason, as text.
    fn read(text: &str) -> std::result::Result<Self, String>;

    /// The admissible names; empty for a number.
    fn choices() -> Vec<String> {
        Vec::new()
    }

    /// The numbers that have to lie in the interval of the option.
    fn places(&self) -> Vec<f64> {
        Vec::new()
    }
}

/// Types that are read by their own `FromStr`: the kind for the page, the number, and the admissible names.
macro_rules! option_value {
    ($($kind:ty, $word:literal $(, at $place:expr)? $(, of $words:expr)?;)*) => {
        $(impl OptionValue for $kind {
            const KIND: &'static str = $word;
            fn read(text: &str) -> std::result::Result<Self, String> {
                text.trim().parse::<$kind>().map_err(|error| error.to_string())
            }
            $(
            #[allow(clippy::redundant_closure_call, reason = "one expression per type")]
            fn places(&self) -> Vec<f64> {
                vec![($place)(self)]
            })?
            $(fn choices() -> Vec<String> {
                $words
            })?
        })*
    };
}

option_value! {
    f64, "number", at |x: &f64| *x;
    usize, "integer", at |x: &usize| *x as f64;
    u32, "integer", at |x: &u32| f64::from(*x);
    Order, "order", at |x: &Order| x.value();
    Tolerance, "tolerance";
    String, "text";
    std::path::PathBuf, "file";
    Cone, "choice", of Cone::ALL.iter().map(ToString::to_string).collect();
    StripKind, "choice", of vec!["scalar".to_owned(), "elastic".to_owned()];
    SideConditions, "choice", of SideConditions::ALL.iter().map(ToString::to_string).collect();
    TestProblem, "named", of bodies();
    StripData, "named", of strips();
    NamedProblem, "named", of [bodies(), strips()].concat();
}

impl OptionValue for bool {
    const KIND: &'static str = "flag";
    fn read(text: &str) -> std::result::Result<Self, String> {
        match text {
            "true" => Ok(true),
            "" | "false" => Ok(false),
            _ => Err("true or false".to_owned()),
        }
    }
}

impl<T: OptionValue> OptionValue for Vec<T> {
    const KIND: &'static str = T::KIND;
    const LIST: bool = true;
    fn read(text: &str) -> std::result::Result<Self, String> {
        if text.trim().is_empty() {
            return Ok(Vec::new());
        }
        text.split(',').map(T::read).collect()
    }
    fn choices() -> Vec<String> {
        T::choices()
    }
    fn places(&self) -> Vec<f64> {
        self.iter().flat_map(T::places).collect()
    }
}

impl<T: OptionValue> OptionValue for Option<T> {
    const KIND: &'static str = T::KIND;
    fn read(text: &str) -> std::result::Result<Self, String> {
        if text.trim().is_empty() { Ok(None) } else { T::read(text).map(Some) }
    }
    fn choices() -> Vec<String> {
        T::choices()
    }
    fn places(&self) -> Vec<f64> {
        self.iter().flat_map(T::places).collect()
    }
}

/// Problems on strips that need no file.
fn strips() -> Vec<String> {
    let named = StripData::all().iter().map(|data| data.name().to_owned()).collect::<Vec<_>>();
    named.into_iter().filter(|name| name.parse::<StripData>().is_ok()).collect()
}

fn bodies() -> Vec<String> {
    TestProblem::all().iter().map(|problem| problem.name().to_owned()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_are_read_and_bounded() {
        let option = Declared::of::<Vec<Order>>("nu", " orders", "1/4,1/2", "(0, 1)", "0.02 to 0.98");
        for good in ["0.25,1/2", "1/2+1e-12"] {
            assert_eq!(option.check(good), Ok(()), "{good}");
        }
        for bad in ["0", "1", "x", "0.5,nan"] {
            assert!(option.check(bad).is_err(), "{bad}");
        }
        let number = Declared::of::<f64>("tau", "", "1.75", "(1.5, 2]", "");
        assert!(number.check("2").is_ok() && number.check("1.5").is_err() && number.check("inf").is_err());
        assert_eq!(Option::<f64>::read(""), Ok(None));
    }

    #[test]
    fn pages_learn_kind_range_and_slider() {
        let said = Declared::of::<f64>("load_scale", "scale", "1", "(0, 1e9]", "0.1 to 10 by factors")
            .json()
            .unwrap();
        assert_eq!(said["name"], "load-scale");
        assert_eq!((&said["slider"], &said["scale"]), (&json!([0.1, 10.0]), &json!("factors")));
        assert_eq!(Declared::of::<String>("load", "", "", "", "").json(), None);
        let said = Declared::of::<Cone>("cone", "", "nodal", "", "").json().unwrap();
        assert_eq!(said["choices"], json!(Cone::ALL.map(|cone| cone.to_string())));
    }

    #[test]
    fn every_choice_is_read() {
        fn are_read<T: OptionValue>(tails: &[&str]) {
            for word in T::choices() {
                let mut all = tails.iter().map(|tail| format!("{word}{tail}"));
                assert!(all.any(|text| T::read(&text).is_ok()), "{word}");
            }
        }
        are_read::<Cone>(&[""]);
        are_read::<StripKind>(&[""]);
        are_read::<SideConditions>(&[""]);
        are_read::<NamedProblem>(&["", ":0.5", ":0.3:4"]);
    }
}
