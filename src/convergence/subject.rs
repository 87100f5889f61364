//! What a rate study solves.

use crate::scenes::{MeshScene, StripScene, TransitionPowers};
use crate::strip::StripKind;
use std::fmt;

/// A scene on a strip, or one transition of given powers.
#[derive(Debug, Clone, PartialEq)]
pub enum FamilyScene {
    /// From the registry.
    Named(StripScene),
    /// One transition with a gap that is mirrored at the side, at one and at two thirds of a cell.
    Powers(TransitionPowers),
}

impl FamilyScene {
    /// Without parameters: `transition`, `fat-cantor`.
    pub fn name(&self) -> &'static str {
        match self {
            FamilyScene::Named(scene) => scene.name(),
            FamilyScene::Powers(_) => "transition",
        }
    }
}

impl fmt::Display for FamilyScene {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            FamilyScene::Named(scene) => scene.fmt(f),
            FamilyScene::Powers(TransitionPowers { opening, pressure, logarithm }) => {
                write!(f, "transition r^{opening}, r^{pressure}, |ln r|^-{logarithm}")
            }
        }
    }
}

/// What a rate study solves.
#[derive(Debug, Clone, PartialEq)]
pub enum Subject {
    /// On a strip.
    Strip(StripKind, FamilyScene),
    /// A scene on meshes with its own load.
    Mesh(MeshScene),
    /// A corner of this opening in degrees, with the load of its scene or with f = −1.
    Corner {
        /// The opening.
        angle: f64,
        /// f = −1.
        constant_load: bool,
    },
}

impl Subject {
    /// Without parameters but the angle of a corner: `scalar transition`, `corner 120 f=-1`.
    pub fn name(&self) -> String {
        match self {
            Subject::Strip(kind, scene) => format!("{kind} {}", scene.name()),
            other => other.to_string(),
        }
    }
}

impl fmt::Display for Subject {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Subject::Strip(kind, scene) => write!(f, "{kind} {scene}"),
            Subject::Mesh(scene) => scene.fmt(f),
            Subject::Corner { angle, constant_load: true } => write!(f, "corner {angle} f=-1"),
            Subject::Corner { angle, constant_load: false } => write!(f, "corner {angle}"),
        }
    }
}
