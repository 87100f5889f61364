//! The regularity of every mesh scene beside the order of its error on nested meshes.

use super::fit::Fit;
use super::mesh_rates::MeshRates;
use super::study::Quantity;
use crate::cone::Cone;
use crate::error::Result;
use crate::scenes::{BodyCorner, MeshScene, Setting};

/// A scene with its regularity and what a rate study shows.
#[derive(Debug, Clone, PartialEq)]
pub struct SceneOrder {
    /// The scene.
    pub scene: MeshScene,
    /// The supremum of the τ with u ∈ H^τ, from corners and contact set.
    pub tau: f64,
    /// The corner responsible.
    pub corner: Option<BodyCorner>,
    /// Order of the error; `None` for too few levels.
    pub order: Option<Fit>,
}

impl SceneOrder {
    /// |order − min(1, τ − 1)| over what the order may be off by.
    pub fn deviation(&self) -> Option<f64> {
        self.order.map(|fit| (fit.order - (self.tau - 1.0).min(1.0)).abs() / fit.half_width)
    }

    /// The largest deviation; `None` where an order is missing, NaN where one is.
    pub fn furthest(rows: &[Self]) -> Option<f64> {
        let all: Option<Vec<f64>> = rows.iter().map(Self::deviation).collect();
        Some(
            all?.into_iter()
                .fold(0.0, |m: f64, x| if x.is_nan() || m.is_nan() { f64::NAN } else { m.max(x) }),
        )
    }
}

/// All mesh scenes in the nodal cone on meshes of n, 2n, ... squares along each side; `report` is called
/// after each.
///
/// # Errors
/// As [`MeshScene::regularity`] and [`MeshRates::study`].
pub fn scene_orders(coarsest: usize, levels: usize, mut report: impl FnMut()) -> Result<Vec<SceneOrder>> {
    let setting = Setting::default();
    let mut rows = Vec::new();
    for scene in MeshScene::all() {
        let found = scene.regularity(&setting)?;
        let rates = MeshRates { scene, setting, constant_load: false, coarsest, levels };
        let study = rates.study(&[Cone::Nodal])?;
        let order = study.first().and_then(|study| study.fit(Quantity::Error));
        rows.push(SceneOrder { scene, tau: found.tau, corner: found.responsible().cloned(), order });
        report();
    }
    Ok(rows)
}
