//! A scene of either kind, by name: `block`, `corner`, `transition:0.4`, `fat-cantor`, ...

use super::mesh::MeshScene;
use super::strip::StripScene;
use crate::error::{Error, Result, ToolkitError};
use std::fmt;
use std::str::FromStr;
use std::sync::LazyLock;

/// A scene of the mesh solver or of the strip.
#[derive(Debug, Clone, PartialEq)]
pub enum Scene {
    /// Two-dimensional, on a mesh.
    Mesh(MeshScene),
    /// Manufactured on the edge of the strip.
    Strip(StripScene),
}

impl Scene {
    /// The names and parameters of all scenes, for help texts and errors.
    pub fn names() -> &'static str {
        static NAMES: LazyLock<String> =
            LazyLock::new(|| format!("{}, {}", MeshScene::names(), StripScene::names()));
        &NAMES
    }
}

impl From<MeshScene> for Scene {
    fn from(scene: MeshScene) -> Self {
        Scene::Mesh(scene)
    }
}

impl From<StripScene> for Scene {
    fn from(scene: StripScene) -> Self {
        Scene::Strip(scene)
    }
}

impl fmt::Display for Scene {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Scene::Mesh(scene) => scene.fmt(f),
            Scene::Strip(scene) => scene.fmt(f),
        }
    }
}

impl FromStr for Scene {
    type Err = Error;

    fn from_str(text: &str) -> Result<Self> {
        let mesh = text.parse().map(Scene::Mesh);
        mesh.or_else(|_: Error| text.parse().map(Scene::Strip)).map_err(|_: Error| {
            Error::Toolkit(ToolkitError::UnknownName {
                what: "scene",
                given: text.to_owned(),
                expected: Scene::names(),
            })
        })
    }
}
