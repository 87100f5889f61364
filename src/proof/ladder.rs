//! The ladder from the consistency term to the final bound, and exponents with their uncertainty.

use super::exponent::Exponent;
use super::profile::{LevelProfile, ProofProfile};
use super::section::Section;
use super::step::RUNGS;
use crate::error::{Error, Result};

/// A rung over all meshes.
#[derive(Debug, Clone, PartialEq)]
pub struct Rung {
    /// The step that leads to it.
    pub name: &'static str,
    /// The paper's lines.
    pub lines: &'static str,
    /// Value on the finest mesh: with the printed law of γ_θ, and with the one that holds.
    pub values: [f64; 2],
    /// Exponent of the value.
    pub exponent: Exponent,
    /// What the step takes from the exponent; none for the first rung.
    pub loss: Option<Exponent>,
    /// Exponent with the law that holds.
    pub corrected: Exponent,
}

const NAMES: [&str; RUNGS] = [
    "consistency term",
    "Hölder's inequality",
    "interpolation, distance to a zero",
    "embedding, Poincaré on its own zone",
    "as if every zone were h_e theta",
    "law of the Poincaré constant",
    "Young, norms of the whole edge",
];

const LINES_THREE: [&str; RUNGS] = [
    "",
    "(3.3), (3.11)",
    "(3.3)-(3.5), (3.13)",
    "(3.8), (3.12)",
    "(3.9), (3.12)",
    "(5.1), (5.2)",
    "(3.9), (3.14), sum",
];

const LINES_FOUR: [&str; RUNGS] = [
    "(4.9)",
    "(4.10), (4.11)",
    "(6.2), (4.6)",
    "(4.10), (4.11)",
    "(4.10), (4.11)",
    "(5.1), (5.2)",
    "Globally",
];

impl ProofProfile {
    /// The rungs with their exponents and losses.
    ///
    /// # Errors
    /// [`Error::CountOutOfRange`] with fewer than three meshes on which every rung is positive.
    pub fn ladder(&self) -> Result<Vec<Rung>> {
        let lines = if self.case.section == Section::Three { LINES_THREE } else { LINES_FOUR };
        // Exponents and losses from the same meshes, so that the losses add up.
        let levels: Vec<_> =
            self.levels.iter().filter(|l| l.rungs.iter().all(|values| values[0] > 0.0)).collect();
        let Some(finest) = levels.last().filter(|_| levels.len() > 2) else {
            let (name, value) = ("meshes with a positive consistency term", levels.len());
            return Err(Error::CountOutOfRange { name, value, range: "[3, inf)" });
        };
        let fit = |value: &dyn Fn(&LevelProfile) -> f64| {
            Exponent::fit(&levels.iter().map(|l| (l.h(), value(l))).collect::<Vec<_>>())
        };
        (0..RUNGS)
            .map(|rung| {
                let before = rung.checked_sub(1);
                Ok(Rung {
                    name: NAMES[rung],
                    lines: lines[rung],
                    values: finest.rungs[rung],
                    exponent: fit(&|l| l.rungs[rung][0])?,
                    loss: before.map(|b| fit(&|l| l.rungs[b][0] / l.rungs[rung][0])).transpose()?,
                    corrected: fit(&|l| l.rungs[rung][1])?,
                })
            })
            .collect()
    }

    /// 2τ² − 5τ + 4 below τ = 2, 2 at τ = 2 (times ln(1/h)), 2τ − 2 above: the printed exponent of the squared error.
    pub fn printed_exponent(&self) -> f64 {
        let tau = self.case.tau;
        if tau < 2.0 { 2.0 * tau * tau - 5.0 * tau + 4.0 } else { 2.0 * tau - 2.0 }
    }
}
