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
    /// # Ok::<(), signorini::Error>(())
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
        mesh.or_else(|_: Error| text.parse().map(NamedProblem::Strip)).map_err(|_: Error| {
            Error::Toolkit(ToolkitError::UnknownName {
                what: "test problem",
                given: text.to_owned(),
                expected: NamedProblem::names(),
            })
        })
    }
}
