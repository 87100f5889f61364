//! Registration of test problems: one block per test problem generates its variant, its entry in the list of all
//! problems, its name with parameters and defaults, and its form, that is the data that characterise it.
//!
//! A name is `NAME[:PARAMETER[:PARAMETER]]`, with parameters in the order of the fields. Omitted parameters have
//! their default values; a file name cannot be omitted, and no parameter may be empty.

use crate::error::{Error, Result, ToolkitError};
use std::fmt;
use std::path::PathBuf;

/// Defines an enum of test problems, `NAME: FORM { VARIANT("name") { field: TYPE = DEFAULT, ... } => FORM; ... }`,
/// with `all`, `name`, `names`, [`Display`](fmt::Display), [`FromStr`](std::str::FromStr), and `form`, in which the
/// fields are available by name. The types of fields are those of [`Slot`].
macro_rules! registry {
    (
        $(#[$about:meta])*
        pub enum $Problems:ident: $Form:ty {
            $(
                $(#[$variant_about:meta])*
                $Problem:ident($name:literal)
                $({ $($(#[$field_about:meta])* $field:ident: $kind:ty = $default:expr,)+ })?
                => $form:expr;
            )+
        }
    ) => {
        $(#[$about])*
        pub enum $Problems {
            $($(#[$variant_about])* $Problem $({ $($(#[$field_about])* $field: $kind,)+ })?,)+
        }

        impl $Problems {
            /// One test problem of each kind, with default parameters.
            pub fn all() -> Vec<Self> {
                vec![$($Problems::$Problem $({ $($field: $default),+ })?),+]
            }

            /// The name of the test problem without parameters.
            pub fn name(&self) -> &'static str {
                match self {
                    $($Problems::$Problem $({ $($field: _),+ })? => $name,)+
                }
            }

            /// The names and parameters of all test problems, for help texts and error messages.
            pub fn names() -> &'static str {
                static NAMES: std::sync::LazyLock<String> =
                    std::sync::LazyLock::new(|| $crate::problems::registry::grammar($Problems::all()));
                &NAMES
            }

            /// The data that characterise this test problem.
            fn form(&self) -> $Form {
                match self {
                    $($Problems::$Problem $({ $($field),+ })? => {
                        $($(let $field = std::borrow::ToOwned::to_owned($field);)+)?
                        $form
                    })+
                }
            }
        }

        impl $crate::problems::registry::Registered for $Problems {
            fn parts(&mut self) -> $crate::problems::registry::Parts<'_> {
                let name = self.name();
                let parameters = match self {
                    $($Problems::$Problem $({ $($field),+ })? => vec![$($((stringify!($field), $field.into())),+)?],)+
                };
                $crate::problems::registry::Parts { name, parameters }
            }
        }

        impl std::fmt::Display for $Problems {
            fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                $crate::problems::registry::Registered::parts(&mut self.to_owned()).write(f)
            }
        }

        impl std::str::FromStr for $Problems {
            type Err = $crate::error::Error;

            fn from_str(text: &str) -> $crate::error::Result<Self> {
                $crate::problems::registry::read(text, $Problems::all(), $Problems::names())
            }
        }
    };
}
pub(super) use registry;

/// A test problem whose name and parameters can be parsed and formatted.
pub(super) trait Registered {
    /// Name and parameters.
    fn parts(&mut self) -> Parts<'_>;
}

/// The parts of the name of a test problem.
pub(super) struct Parts<'a> {
    /// The name without parameters.
    pub(super) name: &'static str,
    /// The fields in order, each with its value.
    pub(super) parameters: Vec<(&'static str, Slot<'a>)>,
}

/// A parameter of a name.
pub(super) enum Slot<'a> {
    Number(&'a mut f64),
    Count(&'a mut usize),
    File(&'a mut PathBuf),
}

impl<'a> From<&'a mut f64> for Slot<'a> {
    fn from(number: &'a mut f64) -> Self {
        Slot::Number(number)
    }
}

impl<'a> From<&'a mut usize> for Slot<'a> {
    fn from(count: &'a mut usize) -> Self {
        Slot::Count(count)
    }
}

impl<'a> From<&'a mut PathBuf> for Slot<'a> {
    fn from(file: &'a mut PathBuf) -> Self {
        Slot::File(file)
    }
}

impl Slot<'_> {
    /// True for a file, which has no default.
    fn is_needed(&self) -> bool {
        matches!(self, Slot::File(_))
    }

    /// The text before the next colon and the rest; a file name may contain colons.
    fn cut<'t>(&self, text: &'t str) -> (&'t str, Option<&'t str>) {
        match self {
            Slot::File(_) => (text, None),
            _ => text.split_once(':').map_or((text, None), |(word, rest)| (word, Some(rest))),
        }
    }

    fn set(self, word: &str) -> Option<()> {
        match self {
            Slot::Number(number) => *number = word.parse().ok().filter(|value: &f64| value.is_finite())?,
            Slot::Count(count) => *count = word.parse().ok()?,
            Slot::File(path) => *path = Some(word).filter(|word| !word.is_empty())?.into(),
        }
        Some(())
    }
}

impl fmt::Display for Slot<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Slot::Number(number) => number.fmt(f),
            Slot::Count(count) => count.fmt(f),
            Slot::File(path) => path.display().fmt(f),
        }
    }
}

impl Parts<'_> {
    /// The grammar of the name, as in `cantor[:RATIO[:DEPTH]]`; a file name cannot be omitted.
    fn grammar(&self) -> String {
        let mut text = self.name.to_owned();
        let mut brackets = 0;
        for (field, slot) in &self.parameters {
            text += if slot.is_needed() { ":" } else { "[:" };
            text += &field.to_uppercase();
            brackets += usize::from(!slot.is_needed());
        }
        text + &"]".repeat(brackets)
    }

    /// Sets the parameters from the fields after the name, each preceded by a colon; `None` if they are not
    /// admissible.
    fn set(self, mut rest: Option<&str>) -> Option<()> {
        for (_, slot) in self.parameters {
            let Some(text) = rest else {
                return (!slot.is_needed()).then_some(());
            };
            let (word, tail) = slot.cut(text);
            slot.set(word)?;
            rest = tail;
        }
        rest.is_none().then_some(())
    }

    /// Writes the name with its parameters, as in `cantor:0.3:20`.
    pub(super) fn write(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name)?;
        self.parameters.iter().try_for_each(|(_, slot)| write!(f, ":{slot}"))
    }
}

/// The names and parameters of all test problems.
pub(super) fn grammar<S: Registered>(all: Vec<S>) -> String {
    let names: Vec<String> = all.into_iter().map(|mut problem| problem.parts().grammar()).collect();
    names.join(", ")
}

/// The test problem with the given name; `expected` lists the known names.
pub(super) fn read<S: Registered>(text: &str, all: Vec<S>, expected: &'static str) -> Result<S> {
    let (name, rest) = text.split_once(':').map_or((text, None), |(name, rest)| (name, Some(rest)));
    all.into_iter()
        .find_map(|mut problem| (problem.parts().name == name).then_some(problem))
        .and_then(|mut problem| problem.parts().set(rest).map(|()| problem))
        .ok_or_else(|| {
            Error::Toolkit(ToolkitError::UnknownName {
                what: "test problem",
                given: text.to_owned(),
                expected,
            })
        })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::problems::{NamedProblem, StripData, TestProblem};
    use std::collections::BTreeSet;
    use std::str::FromStr;

    /// Defaults are read back from name and grammar, wrong parameters refused by an error that lists all
    /// names.
    fn is_read_back<S>(all: &[S], names: &str) -> BTreeSet<String>
    where
        S: Registered + Clone + PartialEq + fmt::Debug + fmt::Display + FromStr<Err = Error>,
    {
        let refused = |text: &str| match text.parse::<S>() {
            Err(Error::Toolkit(ToolkitError::UnknownName { given, expected, .. })) => {
                given == text && expected == names
            }
            _ => false,
        };
        let mut known = BTreeSet::new();
        for problem in all {
            let mut copy = problem.clone();
            let Parts { name, parameters } = copy.parts();
            assert!(known.insert(name.to_owned()), "{name} twice");
            let fields: Vec<&str> = parameters.iter().map(|(field, _)| *field).collect();
            let is_needed = parameters.iter().any(|(_, slot)| slot.is_needed());
            let grammar = Parts { name, parameters }.grammar();
            assert!(names.split(", ").any(|entry| entry == grammar), "{grammar} is not in: {names}");
            assert!(fields.iter().all(|field| grammar.contains(&field.to_uppercase())), "{grammar}");
            if is_needed {
                assert!(refused(name) && refused(&format!("{name}:")), "{name}");
            } else {
                assert_eq!(name.parse(), Ok(problem.clone()));
                assert_eq!(problem.to_string().parse(), Ok(problem.clone()));
                assert_eq!(problem.to_string().split(':').count(), 1 + fields.len());
                // One parameter too many, an empty one in each place, one that is no number.
                for text in [format!("{problem}:1"), format!("{problem}:")] {
                    assert!(refused(&text), "{text}");
                }
                for place in 1..=fields.len() {
                    for wrong in ["", " ", "x", "1,5", "NaN", "inf", "1e400"] {
                        let written = problem.to_string();
                        let mut words: Vec<&str> = written.split(':').collect();
                        words[place] = wrong;
                        assert!(refused(&words.join(":")), "{words:?}");
                        assert!(refused(&words[..=place].join(":")), "{words:?}");
                    }
                }
            }
            assert!(refused(&format!("{name}x")) && refused(&name.to_uppercase()), "{name}");
        }
        assert!(refused("") && refused(":") && refused("no-such-problem"));
        assert_eq!(names.split(", ").count(), all.len());
        known
    }

    #[test]
    fn every_problem_is_read_back_and_wrong_names_are_refused() {
        let strip = is_read_back(&StripData::all(), StripData::names());
        let mesh = is_read_back(&TestProblem::all(), TestProblem::names());
        assert!(strip.is_disjoint(&mesh), "one name for two problems: {strip:?}, {mesh:?}");
        for name in strip.iter().chain(&mesh) {
            assert!(NamedProblem::names().contains(name.as_str()), "{name}");
        }
        let error = "no-such-problem".parse::<NamedProblem>().unwrap_err().to_string();
        assert!(error.contains(TestProblem::names()) && error.contains(StripData::names()), "{error}");
    }
}
