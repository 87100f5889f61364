//! A scene of either solver: of the mesh solver, or of the strip.

use crate::error::{Error, Result};
use crate::scenes::Scene;
use crate::strip::SceneSource;
use std::fmt;
use std::str::FromStr;

/// Largest n on a mesh: a reference with 2048 squares along each side.
const MESH_LARGEST: usize = 256;
/// Largest n on a strip: a reference of 2^20 cells.
const STRIP_LARGEST: usize = 1 << 14;

/// A scene of either solver.
#[derive(Debug, Clone, PartialEq)]
pub enum ContactSource {
    /// Two-dimensional, by the mesh solver.
    Mesh(Scene),
    /// Manufactured on the edge of the strip.
    Strip(SceneSource),
}

impl ContactSource {
    /// The largest n that can be asked for.
    pub fn largest(&self) -> usize {
        match self {
            ContactSource::Mesh(_) => MESH_LARGEST,
            ContactSource::Strip(_) => STRIP_LARGEST,
        }
    }
}

impl From<Scene> for ContactSource {
    fn from(scene: Scene) -> Self {
        ContactSource::Mesh(scene)
    }
}

impl From<SceneSource> for ContactSource {
    fn from(source: SceneSource) -> Self {
        ContactSource::Strip(source)
    }
}

impl fmt::Display for ContactSource {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            ContactSource::Mesh(scene) => scene.fmt(f),
            ContactSource::Strip(source) => source.fmt(f),
        }
    }
}

impl FromStr for ContactSource {
    type Err = Error;

    fn from_str(text: &str) -> Result<Self> {
        let unknown = |_| Error::UnknownName {
            what: "scene",
            given: text.to_owned(),
            expected: "a mesh scene (block, membrane, free, closed, ...) or a strip scene (transition[:POSITION], \
                       transitions:COUNT, cantor[:RATIO[:DEPTH]], fat-cantor[:DEPTH], samples:FILE)",
        };
        text.parse::<Scene>()
            .map(ContactSource::Mesh)
            .or_else(|_| text.parse().map(ContactSource::Strip))
            .map_err(unknown)
    }
}
