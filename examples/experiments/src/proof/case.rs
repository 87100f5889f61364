//! What the proofs are profiled on: a manufactured pair, mesh sizes, the resolution and θ as a function of h.

use super::resolution::Resolution;
use crate::ErrorExt;
use crate::convergence::Levels;
use signorini::edge::{ContactPair, Traces};
use signorini::problems::StripData;
use signorini::proof::ProofConstants;
use signorini::proof::Section;
use signorini::proof::ThetaRule;
use signorini::strip::LateralCondition;
use signorini::{Error, Result, ToolkitError};

/// Largest number of positions of a transition.
const POSITIONS: usize = 64;
/// Largest number of cells of the edge.
const LARGEST: usize = 1 << 20;

/// What is profiled.
#[derive(Debug, Clone, PartialEq)]
pub struct ProofCase {
    /// Theorem 3.1 or 4.1.
    pub section: Section,
    /// The manufactured pair; above τ = 2 a single transition.
    pub source: StripData,
    /// The regularity the proof assumes, 3/2 < τ < 5/2 (at most 2 in Section 3).
    pub tau: f64,
    /// The regularity the pair is built with: its norms of order τ are the better resolved the larger the
    /// difference.
    pub scene_tau: f64,
    /// Mesh sizes.
    pub levels: Levels,
    /// How finely the pair is resolved.
    pub resolution: Resolution,
    /// θ as a function of h; not used above τ = 2.
    pub rule: ThetaRule,
    /// Over how many positions in the coarsest cell a single transition is moved; an odd number.
    pub positions: usize,
}

impl ProofCase {
    /// τ = 7/4, one transition at nine positions, h = 1/8 ... 1/2048 with 128 cells per segment, θ =
    /// h^{2τ−3}.
    ///
    /// # Errors
    /// None: the levels are valid.
    pub fn standard(section: Section) -> Result<Self> {
        Ok(Self {
            section,
            source: StripData::transition(),
            tau: 1.75,
            scene_tau: 1.75,
            levels: Levels::new(3, 11)?,
            resolution: Resolution::Segment(7),
            rule: ThetaRule::Printed { tau: 1.75 },
            positions: 9,
        })
    }

    /// The zones whose Poincaré constants the profile needs: θ of every mesh, and the powers of 1/2 down to a
    /// fine cell.
    ///
    /// # Errors
    /// [`ToolkitError::OutOfRange`](signorini::ToolkitError::OutOfRange) for τ or θ outside their ranges.
    pub fn zones(&self) -> Result<Vec<f64>> {
        if self.tau > 2.0 {
            return Ok(Vec::new());
        }
        let coarsest = self.levels.coarsest_cells();
        let cells = self.resolution.cells(coarsest) / coarsest;
        let powers = (0..=cells.max(1).ilog2()).map(|k| Ok(0.5f64.powi(k as i32)));
        self.levels.cells().map(|n| self.rule.theta(1.0 / n as f64)).chain(powers).collect()
    }

    /// Constants for this case alone.
    ///
    /// # Errors
    /// As [`ProofCase::zones`] and [`ProofConstants::new`].
    pub fn constants(&self, q: f64) -> Result<ProofConstants> {
        ProofConstants::new(self.tau, q, &self.zones()?)
    }

    /// Fails where τ, θ, the resolution, the positions or the parameters of the scene do not fit, before
    /// anything is computed.
    ///
    /// # Errors
    /// [`ToolkitError::OutOfRange`](signorini::ToolkitError::OutOfRange), [`ToolkitError::CountOutOfRange`](signorini::ToolkitError::CountOutOfRange), those of the scene.
    pub fn require_valid(&self) -> Result<()> {
        self.zones()?;
        self.require_fitting()?;
        let cells = self.resolution.cells(self.levels.coarsest_cells());
        let tau = if self.tau > 2.0 { 2.0 } else { self.scene_tau };
        self.source.data(tau, cells, LateralCondition::Natural).map(|_| ())
    }

    /// Fails where τ, the constants, the resolution or the positions do not fit.
    pub(super) fn check(&self, constants: &ProofConstants) -> Result<()> {
        let same = constants.tau() == self.tau;
        ToolkitError::require("tau of the constants", constants.tau(), "the regularity of the case", same)?;
        self.require_fitting()
    }

    fn require_fitting(&self) -> Result<()> {
        let largest = if self.section == Section::Three { 2.0 } else { 2.5 };
        let admissible = self.tau > 1.5 && self.tau <= largest && self.tau < 2.5;
        ToolkitError::require("tau", self.tau, "(3/2, 2], in Section 4 (3/2, 5/2)", admissible)?;
        let finest = self.levels.cells().last().unwrap_or(1);
        let cells = self.resolution.cells(finest);
        if cells > LARGEST || cells < 2 * finest {
            let range = "[2 per segment, 2^20]";
            return Err(Error::Toolkit(ToolkitError::CountOutOfRange {
                name: "cells of the finest edge",
                value: cells,
                range,
            }));
        }
        if !(1..=POSITIONS).contains(&self.positions) {
            return Err(Error::Toolkit(ToolkitError::CountOutOfRange {
                name: "positions",
                value: self.positions,
                range: "[1, 64]",
            }));
        }
        Ok(())
    }

    /// The pair at every position, on an edge of so many cells.
    pub(super) fn pairs(&self, cells: usize, traces: Traces) -> Result<Vec<ContactPair>> {
        let step = 1.0 / (self.levels.coarsest_cells() * self.positions) as f64;
        let StripData::Transition { position } = self.source else {
            ToolkitError::require("tau", self.tau, "(3/2, 2] but for a single transition", self.tau <= 2.0)?;
            let scene = self.source.data(self.scene_tau, cells, LateralCondition::Natural)?;
            return Ok(vec![ContactPair::of_data(&scene, traces)?]);
        };
        (0..self.positions)
            .map(|i| {
                let position = position + i as f64 * step;
                if self.tau > 2.0 {
                    return ContactPair::smooth_transition(cells, position, self.scene_tau);
                }
                let source = StripData::Transition { position };
                let scene = source.data(self.scene_tau, cells, LateralCondition::Natural)?;
                ContactPair::of_data(&scene, traces)
            })
            .collect()
    }
}
