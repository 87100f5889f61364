//! Scenes by name, as given on a command line.

use super::scene::{EdgeScene, SceneKind};
use super::sides::Sides;
use crate::error::{Error, Result};
use std::fmt;
use std::path::PathBuf;
use std::str::FromStr;

/// Where a scene comes from: `transition[:POSITION]`, `transitions:COUNT`, `cantor[:RATIO[:DEPTH]]`, `fat-cantor[:DEPTH]` or
/// `samples:FILE`.
#[derive(Debug, Clone, PartialEq)]
pub enum SceneSource {
    /// Built from powers on a contact set.
    Built(SceneKind),
    /// Two columns u_N and λ in a file.
    Samples(PathBuf),
}

/// Position of a single transition unless given: far from every short binary fraction.
const POSITION: f64 = 0.381966;

impl SceneSource {
    /// One transition at an irrational-looking place.
    pub const fn transition() -> Self {
        SceneSource::Built(SceneKind::Transition { position: POSITION })
    }

    /// The scene on an edge of `cells` cells; samples bring their own number of cells.
    ///
    /// # Errors
    /// As [`EdgeScene::build`] and [`EdgeScene::from_samples`]; [`Error::File`] for a file that cannot be read.
    pub fn scene(&self, tau: f64, cells: usize, sides: Sides) -> Result<EdgeScene> {
        match self {
            SceneSource::Built(kind) => EdgeScene::build(*kind, tau, cells, sides),
            SceneSource::Samples(path) => {
                let text = std::fs::read_to_string(path).map_err(|e| Error::file(path, e))?;
                EdgeScene::from_samples(&text, sides)
            }
        }
    }
}

impl fmt::Display for SceneSource {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            SceneSource::Built(SceneKind::Transition { position }) => write!(f, "transition:{position}"),
            SceneSource::Built(SceneKind::Transitions { gaps }) => write!(f, "transitions:{gaps}"),
            SceneSource::Built(SceneKind::Cantor { ratio, depth }) => write!(f, "cantor:{ratio}:{depth}"),
            SceneSource::Built(SceneKind::FatCantor { depth }) => write!(f, "fat-cantor:{depth}"),
            SceneSource::Samples(path) => write!(f, "samples:{}", path.display()),
        }
    }
}

impl FromStr for SceneSource {
    type Err = Error;

    fn from_str(text: &str) -> Result<Self> {
        let unknown = || Error::UnknownName {
            what: "scene",
            given: text.to_owned(),
            expected: "transition[:POSITION], transitions:COUNT, cantor[:RATIO[:DEPTH]], fat-cantor[:DEPTH] or samples:FILE",
        };
        let (name, rest) = text.split_once(':').unwrap_or((text, ""));
        if name == "samples" && !rest.is_empty() {
            return Ok(SceneSource::Samples(PathBuf::from(rest)));
        }
        let mut words = rest.split(':').filter(|word| !word.is_empty());
        let kind = match name {
            "transition" => SceneKind::Transition { position: next(&mut words, POSITION, unknown)? },
            "transitions" => SceneKind::Transitions { gaps: next(&mut words, 16, unknown)? },
            "cantor" => SceneKind::Cantor {
                ratio: next(&mut words, 0.3, unknown)?,
                depth: next(&mut words, 20, unknown)?,
            },
            "fat-cantor" => SceneKind::FatCantor { depth: next(&mut words, 15, unknown)? },
            _ => return Err(unknown()),
        };
        if words.next().is_some() {
            return Err(unknown());
        }
        Ok(SceneSource::Built(kind))
    }
}

/// The next word as a number, or the default without one.
fn next<'a, T: FromStr>(
    words: &mut impl Iterator<Item = &'a str>,
    default: T,
    bad: impl Fn() -> Error,
) -> Result<T> {
    words.next().map_or(Ok(default), |word| word.parse().map_err(|_| bad()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_read_back() {
        for text in ["transition:0.25", "transitions:7", "cantor:0.2:9", "fat-cantor:12", "samples:edge.txt"]
        {
            assert_eq!(text.parse::<SceneSource>().unwrap().to_string(), text);
        }
        assert_eq!("transition".parse(), Ok(SceneSource::transition()));
        for bad in [
            "",
            "cliff",
            "transition:x",
            "transitions:1.5",
            "transitions:1e300",
            "transitions:-1",
            "fat-cantor:3:4",
            "samples:",
        ] {
            assert!(bad.parse::<SceneSource>().is_err(), "{bad}");
        }
    }
}
