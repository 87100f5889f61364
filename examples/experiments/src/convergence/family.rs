//! Families of scenes on a strip: a scene, or one at several positions whose errors are averaged.

use super::subject::FamilyScene;
use signorini::problems::{StripData, TransitionPowers};
use signorini::strip::{EdgeData, LateralCondition, StripKind};
use signorini::{Error, Result, ToolkitError};

/// One family of scenes: a scene, or one at several positions whose errors are averaged.
pub struct SceneFamily<'a> {
    /// Which scene.
    pub scene: FamilyScene,
    /// The supremum of the τ with u ∈ H^τ.
    pub tau: f64,
    /// How many members.
    pub count: usize,
    /// Member i on an edge of so many cells.
    pub member: Box<dyn Fn(usize, usize) -> Result<EdgeData> + 'a>,
}

impl SceneFamily<'static> {
    /// A named scene. One transition has a gap that is mirrored at natural sides ([`TransitionPowers`]) and
    /// is moved over `positions` places of a cell, spread over the cells of every level when odd.
    ///
    /// # Errors
    /// [`ToolkitError::CountOutOfRange`](signorini::ToolkitError::CountOutOfRange) for no position.
    pub fn named(
        source: &StripData,
        tau: f64,
        kind: StripKind,
        coarsest: usize,
        positions: usize,
    ) -> Result<Self> {
        if positions == 0 || positions > 1024 {
            return Err(Error::Toolkit(ToolkitError::CountOutOfRange {
                name: "positions",
                value: positions,
                range: "[1, 1024]",
            }));
        }
        let sides = kind.sides();
        let scene = FamilyScene::Named(source.clone());
        let source = source.clone();
        Ok(match source {
            StripData::Transition { position } => Self {
                scene,
                tau,
                count: positions,
                member: Box::new(move |i, cells| {
                    let position = position + i as f64 / positions as f64 / coarsest as f64;
                    match sides {
                        LateralCondition::Natural => {
                            TransitionPowers::of_regularity(tau).data(position, cells)
                        }
                        LateralCondition::Periodic => {
                            StripData::Transition { position }.data(tau, cells, sides)
                        }
                    }
                }),
            },
            _ => Self {
                scene,
                tau,
                count: 1,
                member: Box::new(move |_, cells| source.data(tau, cells, sides)),
            },
        })
    }

    /// A named scene at τ = 2 with data times ℓ^{−α} ([`StripData::damped_data`]); one transition is moved
    /// over `positions` places of a cell of the coarsest level.
    ///
    /// # Errors
    /// As [`SceneFamily::named`].
    pub fn damped(
        source: &StripData,
        logarithm: f64,
        kind: StripKind,
        coarsest: usize,
        positions: usize,
    ) -> Result<Self> {
        let named = Self::named(source, 2.0, kind, coarsest, positions)?;
        let (source, sides) = (source.clone(), kind.sides());
        let scene = FamilyScene::Damped(source.clone(), logarithm);
        let member = move |i: usize, cells| match source {
            StripData::Transition { position } => {
                let position = position + i as f64 / positions as f64 / coarsest as f64;
                StripData::Transition { position }.damped_data(logarithm, cells, sides)
            }
            _ => source.damped_data(logarithm, cells, sides),
        };
        Ok(Self { scene, member: Box::new(member), ..named })
    }

    /// One transition of given powers near x = 0.4, at one and at two thirds of a coarsest cell: doubling
    /// exchanges the two, so that the mean has no phase at all.
    pub fn at_thirds(powers: TransitionPowers, tau: f64, coarsest: usize) -> Self {
        let cell = 1.0 / coarsest as f64;
        let start = (0.4 / cell).floor() * cell;
        let member = move |i: usize, cells| powers.data(start + (i + 1) as f64 / 3.0 * cell, cells);
        Self { scene: FamilyScene::Powers(powers), tau, count: 2, member: Box::new(member) }
    }
}
