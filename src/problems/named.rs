//! A test problem of either kind, by name: `block`, `corner`, `transition:0.4`, `fat-cantor`, ...

use super::strip_data::StripData;
use super::test_problem::TestProblem;
use crate::error::{Error, Result, ToolkitError};
use std::fmt;
use std::str::FromStr;
use std::sync::LazyLock;

/// A test problem on a mesh or on the strip.
///
/// The displayed text can be parsed and gives the same problem.
///
/// ```
/// use signorini::problems::NamedProblem;
/// let problem: NamedProblem = "transition:0.4".parse()?;
/// assert!(matches!(problem, NamedProblem::Strip(_)));
/// assert_eq!(problem.to_string().parse::<NamedProblem>()?, problem);
/// assert!(matches!("block".parse()?, NamedProblem::Mesh(_)));
/// # Ok::<(), signorini::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub enum NamedProblem {
    /// A two-dimensional problem on a mesh.
    Mesh(TestProblem),
    /// A problem manufactured on the edge of the strip.
    Strip(StripData),
}

impl NamedProblem {
    /// The names and parameters of all test problems, for help texts and error messages.
    ///
    /// ```
    /// use signorini::problems::{NamedProblem, StripData, TestProblem};
    /// let names = NamedProblem::names();
    /// assert!(TestProblem::all().iter().all(|problem| names.contains(problem.name())));
    /// assert!(StripData::all().iter().all(|data| names.contains(data.name())));
    /// ```
    pub fn names() -> &'static str {
        static NAMES: LazyLock<String> =
            LazyLock::new(|| format!("{}, {}", TestProblem::names(), StripData::names()));
        &NAMES
    }
}

impl From<TestProblem> for NamedProblem {
    fn from(problem: TestProblem) -> Self {
        NamedProblem::Mesh(problem)
    }
}

impl From<StripData> for NamedProblem {
    fn from(problem: StripData) -> Self {
        NamedProblem::Strip(problem)
    }
}

impl fmt::Display for NamedProblem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            NamedProblem::Mesh(problem) => problem.fmt(f),
            NamedProblem::Strip(problem) => problem.fmt(f),
        }
    }
}

impl FromStr for NamedProblem {
    type Err = Error;

    fn from_str(text: &str) -> Result<Self> {
        let mesh = text.parse().map(NamedProblem::Mesh);
        mesh.or_else(|_: Error| text.parse().map(NamedProblem::Strip))
            .map_err(|_: Error| unknown(text, NamedProblem::names()))
    }
}

/// The error for a text that is not the name of a test problem; `expected` lists the known names.
pub(super) fn unknown(text: &str, expected: &'static str) -> Error {
    Error::Toolkit(ToolkitError::UnknownName {
        what: "test problem",
        given: text.to_owned(),
        expected,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn is_refused(text: &str) -> bool {
        let is_unknown = |expected: &str, error: Error| match error {
            Error::Toolkit(ToolkitError::UnknownName { given, expected: known, .. }) => {
                given == text && known == expected
            }
            _ => false,
        };
        text.parse::<TestProblem>().is_err_and(|error| is_unknown(TestProblem::names(), error))
            && text.parse::<StripData>().is_err_and(|error| is_unknown(StripData::names(), error))
            && text
                .parse::<NamedProblem>()
                .is_err_and(|error| is_unknown(NamedProblem::names(), error))
    }

    #[test]
    fn every_problem_is_read_back_and_wrong_names_are_refused() {
        let meshes = TestProblem::all().into_iter().map(NamedProblem::from);
        let all: Vec<NamedProblem> =
            meshes.chain(StripData::all().into_iter().map(Into::into)).collect();
        assert_eq!(all.len(), NamedProblem::names().split(", ").count());
        for problem in all {
            let written = problem.to_string();
            let name = written.split(':').next().unwrap();
            assert!(is_refused(&format!("{name}x")) && is_refused(&name.to_uppercase()), "{name}");
            if name == "samples" {
                assert!(is_refused("samples") && is_refused("samples:"));
                continue;
            }
            assert_eq!(written.parse(), Ok(problem.clone()));
            assert_eq!(name.parse(), Ok(problem), "parameters with their default values");
            // One parameter too many, an empty one in each place, one that is no number.
            assert!(
                is_refused(&format!("{written}:1")) && is_refused(&format!("{written}:")),
                "{written}"
            );
            for place in 1..written.split(':').count() {
                for wrong in ["", " ", "x", "1,5", "NaN", "inf", "1e400"] {
                    let mut words: Vec<&str> = written.split(':').collect();
                    words[place] = wrong;
                    assert!(is_refused(&words.join(":")), "{words:?}");
                    assert!(is_refused(&words[..=place].join(":")), "{words:?}");
                }
            }
        }
        for text in ["cantor:0.2:9", "samples:edge.txt", "samples:a:b"] {
            assert_eq!(text.parse::<NamedProblem>().unwrap().to_string(), text);
        }
        assert_eq!("cantor:0.2".parse(), Ok(StripData::Cantor { ratio: 0.2, depth: 20 }));
        assert!(is_refused("") && is_refused(":") && is_refused("transitions:1e300"));
    }
}
