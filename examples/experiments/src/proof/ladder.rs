//! The ladder from the consistency term to the final bound, and exponents with their uncertainty.

use super::inequality_profile::InequalityProfile;
use super::profile::{LevelProfile, ProofProfile};
use crate::convergence::regression;
use signorini::proof::Inequality;
use signorini::proof::printed_exponent;
use signorini::proof::{Step, TwoLaws};
use signorini::rates::ConvergenceOrder;
use signorini::{Error, Result, ToolkitError};

/// A rung over all meshes.
#[derive(Debug, Clone, PartialEq)]
pub struct Rung {
    /// The step that leads to it.
    pub step: Step,
    /// Value on the finest mesh.
    pub finest: TwoLaws,
    /// Exponent of the value.
    pub exponent: ConvergenceOrder,
    /// What the step takes from the exponent; none for the first rung.
    pub loss: Option<ConvergenceOrder>,
    /// Exponent with the law that holds.
    pub corrected: ConvergenceOrder,
}

/// A line of the proof over all meshes.
#[derive(Debug, Clone, PartialEq)]
pub struct LineProfile {
    /// Which.
    pub line: Inequality,
    /// Segments with a positive right side.
    pub count: usize,
    /// Segments on which it fails beyond the error of its two sides.
    pub violations: usize,
    /// Largest left/right on a segment; 1 is sharp.
    pub sharpest: f64,
    /// h and right/left of the sums over the segments, coarsest mesh first.
    pub slacks: Vec<(f64, f64)>,
    /// Exponent of that slack in h, with three meshes at least.
    pub exponent: Option<ConvergenceOrder>,
}

impl ProofProfile {
    /// The rungs with their exponents and losses.
    ///
    /// # Errors
    /// [`ToolkitError::CountOutOfRange`](signorini::ToolkitError::CountOutOfRange) with fewer than three meshes on which every rung is positive.
    pub fn ladder(&self) -> Result<Vec<Rung>> {
        // Exponents and losses from the same meshes, so that the losses add up.
        let positive = |level: &&LevelProfile| Step::ALL.iter().all(|&step| level.rung(step).printed > 0.0);
        let levels: Vec<&LevelProfile> = self.levels.iter().filter(positive).collect();
        let few = || {
            let (name, value) = ("meshes with a positive consistency term", levels.len());
            Error::Toolkit(ToolkitError::CountOutOfRange { name, value, range: "[3, inf)" })
        };
        let finest = levels.last().ok_or_else(few)?;
        let fit = |value: &dyn Fn(&LevelProfile) -> f64| {
            let points: Vec<(f64, f64)> = levels.iter().map(|l| (l.h(), value(l))).collect();
            regression(&points).ok_or_else(few)
        };
        let rung = |step: Step, before: Option<Step>| -> Result<Rung> {
            let loss = |before: Step| fit(&|l| l.rung(before).printed / l.rung(step).printed);
            Ok(Rung {
                step,
                finest: finest.rung(step),
                exponent: fit(&|l| l.rung(step).printed)?,
                loss: before.map(loss).transpose()?,
                corrected: fit(&|l| l.rung(step).corrected)?,
            })
        };
        let before = std::iter::once(None).chain(Step::ALL.into_iter().map(Some));
        Step::ALL.into_iter().zip(before).map(|(step, before)| rung(step, before)).collect()
    }

    /// The smallest quotient of a rung and the one below, over all meshes; none where every term vanishes.
    pub fn smallest_step(&self) -> Option<f64> {
        let steps =
            Step::ALL.windows(2).flat_map(|pair| self.levels.iter().map(move |l| (l, pair[0], pair[1])));
        let quotient = |(l, below, above): (&LevelProfile, Step, Step)| {
            let (below, above) = (l.rung(below).printed, l.rung(above).printed);
            (below > 0.0).then(|| above / below)
        };
        steps.filter_map(quotient).reduce(f64::min)
    }

    /// Inequalities checked, all segments and meshes.
    pub fn checks(&self) -> usize {
        self.inequalities().map(|i| i.count).sum()
    }

    /// Inequalities that fail beyond the error of their two sides.
    pub fn violations(&self) -> usize {
        self.inequalities().map(|i| i.violations).sum()
    }

    fn inequalities(&self) -> impl Iterator<Item = &InequalityProfile> {
        self.levels.iter().flat_map(|l| &l.inequalities)
    }

    /// The lines over all meshes, in the order of the paper.
    pub fn lines(&self) -> Vec<LineProfile> {
        let mut lines: Vec<Inequality> = self.inequalities().map(|i| i.line).collect();
        lines.sort_unstable();
        lines.dedup();
        lines.into_iter().map(|line| self.line(line)).collect()
    }

    fn line(&self, line: Inequality) -> LineProfile {
        let on = |l: &LevelProfile| l.inequalities.iter().find(|i| i.line == line).map(|i| (l.h(), *i));
        let found: Vec<(f64, InequalityProfile)> = self.levels.iter().filter_map(on).collect();
        let slacks: Vec<(f64, f64)> =
            found.iter().filter_map(|(h, i)| i.slack().map(|slack| (*h, slack))).collect();
        LineProfile {
            line,
            count: found.iter().map(|(_, i)| i.count).sum(),
            violations: found.iter().map(|(_, i)| i.violations).sum(),
            sharpest: found.iter().fold(0.0, |m: f64, (_, i)| m.max(i.sharpest)),
            exponent: regression(&positive(&slacks)),
            slacks,
        }
    }

    /// 2τ² − 5τ + 4 below τ = 2, 2 at τ = 2 (times ln(1/h)), 2τ − 2 above: the printed exponent of the
    /// squared error.
    pub fn printed_exponent(&self) -> f64 {
        printed_exponent(self.case.tau)
    }
}

/// The points (h, value) with a positive value.
fn positive(points: &[(f64, f64)]) -> Vec<(f64, f64)> {
    points.iter().copied().filter(|point| point.1 > 0.0).collect()
}
