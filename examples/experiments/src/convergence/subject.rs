//! What a rate study solves.

use signorini::problems::{StripData, TestProblem, TransitionPowers};
use signorini::strip::StripKind;
use std::fmt;

/// A scene on a strip, or one transition of given powers.
#[derive(Debug, Clone, PartialEq)]
pub enum FamilyScene {
    /// From the registry.
    Named(StripData),
    /// From the registry at τ = 2, times ℓ^{−α}.
    Damped(StripData, f64),
    /// One transition with a gap that is mirrored at the side, at one and at two thirds of a cell.
    Powers(TransitionPowers),
}

impl FamilyScene {
    /// Without parameters: `transition`, `fat-cantor`.
    pub fn name(&self) -> &'static str {
        match self {
            FamilyScene::Named(scene) | FamilyScene::Damped(scene, _) => scene.name(),
            FamilyScene::Powers(_) => "transition",
        }
    }
}

impl fmt::Display for FamilyScene {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            FamilyScene::Named(scene) => scene.fmt(f),
            FamilyScene::Damped(scene, alpha) => write!(f, "{scene}, |ln r|^-{alpha}"),
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
    Mesh(TestProblem),
    /// A corner of this opening in degrees, with the load of its scene or with f = −1.
    Corner {
        /// The opening.
        angle: f64,
        /// f = −1.
        constant_load: bool,
    },
    /// One transition on meshes, with contact conditions on the bottom of the square or everywhere.
    Transition {
        /// Of opening and pressure.
        powers: TransitionPowers,
        /// Everywhere, with a reaction term.
        whole_boundary: bool,
    },
}

impl Subject {
    /// Without parameters but the angle of a corner: `scalar transition`, `corner 120 f=-1`.
    pub fn name(&self) -> String {
        match self {
            Subject::Strip(kind, scene) => format!("{kind} {}", scene.name()),
            Subject::Transition { whole_boundary: false, .. } => "mesh transition".to_owned(),
            Subject::Transition { whole_boundary: true, .. } => "closed transition".to_owned(),
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
            Subject::Transition { powers, whole_boundary } => {
                let place = if *whole_boundary { "closed" } else { "mesh" };
                write!(f, "{place} {}", FamilyScene::Powers(*powers))
            }
            Subject::Corner { angle, constant_load: false } => write!(f, "corner {angle}"),
        }
    }
}
