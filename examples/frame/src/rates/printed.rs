//! The rates that the introduction prints, (E1)-(E4), (N1), (N2), and the scenes that stand for them.

use super::plan::{both_cones, on_meshes};
use super::row::RateRow;
use crate::Result;
use experiments::convergence::{Levels, SceneFamily, StripGroup, TransitionRates};
use signorini::problems::{StripData, TransitionPowers};
use signorini::strip::StripKind;

/// What stands for a regularity. On a strip: one transition, one in H² (slopes like |ln r|^{−1}), 22, a fat
/// Cantor set, an elastic one and one in H²; on meshes: one transition, one in H².
#[derive(Debug, Clone, Copy, PartialEq)]
#[allow(missing_docs)]
pub enum Shape {
    Transition,
    InH2,
    Many,
    FatCantor,
    Elastic,
    ElasticInH2,
    Mesh,
    MeshInH2,
}

/// A printed rate.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Printed {
    /// Of its findings.
    pub key: &'static str,
    /// In the paper.
    pub label: &'static str,
    /// Supremum of the τ with u ∈ H^τ, attained at τ = 2 in H².
    pub tau: f64,
    /// The scene.
    pub shape: Shape,
    /// "finite" where the paper asks for finitely many transitions.
    pub assumption: &'static str,
    /// As printed.
    pub rate: &'static str,
    /// The power of h in it.
    pub exponent: f64,
}

/// (E2) and (N1) as printed.
const E2: &str = "h^(tau/2-1/4)";
const N1: &str = "h^(tau^2-5tau/2+2)";
const OPTIMAL: &str = "h^(tau-1)";
const E3: &str = "h |ln h|^(1/2) ... h";

const fn row(key: &'static str, label: &'static str, tau: f64, shape: Shape) -> Printed {
    Printed { key, label, tau, shape, assumption: "", rate: OPTIMAL, exponent: tau - 1.0 }
}

impl Printed {
    /// In the order of the paper.
    pub const ALL: [Printed; 18] = [
        row("e1.below", "(E1)", 1.4, Shape::Transition),
        row("e1.below.mesh", "(E1)", 1.4, Shape::Mesh),
        row("e1", "(E1)", 1.5, Shape::Transition),
        row("e1.mesh", "(E1)", 1.5, Shape::Mesh),
        row("e2", "(E2)", 1.75, Shape::FatCantor).rate(E2, 0.625),
        row("e2.finite", "(E2)", 1.75, Shape::Transition).finite(),
        row("n1.cantor", "(N1)", 1.75, Shape::FatCantor).rate(N1, 0.6875),
        row("n1.many", "(N1)", 1.75, Shape::Many).rate(N1, 0.6875),
        row("e3", "(E3)", 2.0, Shape::Many).rate("h^(3/4)", 0.75),
        row("e3.finite", "(E3)", 2.0, Shape::InH2).rate(E3, 1.0).finite(),
        row("e3.finite.mesh", "(E3)", 2.0, Shape::MeshInH2).rate(E3, 1.0).finite(),
        row("e3.finite.elastic", "(E3)", 2.0, Shape::ElasticInH2).rate(E3, 1.0).finite(),
        row("n2", "(N2)", 2.0, Shape::InH2).rate("h |ln h|^(1/2)", 1.0),
        row("e4", "(E4)", 2.25, Shape::Transition).rate("h", 1.0),
        row("e4.elastic", "(E4)", 2.25, Shape::Elastic).rate("h", 1.0),
        row("e4.mesh", "(E4)", 2.25, Shape::Mesh).rate("h", 1.0),
        row("e4.natural", "(E4)", 2.5, Shape::Transition).rate("h", 1.0),
        row("e4.natural.mesh", "(E4)", 2.5, Shape::Mesh).rate("h", 1.0),
    ];

    const fn rate(self, rate: &'static str, exponent: f64) -> Self {
        Self { rate, exponent, ..self }
    }

    const fn finite(self) -> Self {
        Self { assumption: "finite", ..self }
    }

    /// The scene for a table.
    pub fn scene(&self) -> &'static str {
        match self.shape {
            Shape::Transition => "transition",
            Shape::InH2 => "transition in H^2",
            Shape::Many => "transitions",
            Shape::FatCantor => "fat-cantor",
            Shape::Elastic => "elastic transition",
            Shape::ElasticInH2 => "elastic transition in H^2",
            Shape::Mesh => "mesh transition",
            Shape::MeshInH2 => "mesh transition in H^2",
        }
    }

    fn is_on_mesh(&self) -> bool {
        matches!(self.shape, Shape::Mesh | Shape::MeshInH2)
    }

    fn powers(&self) -> TransitionPowers {
        match self.shape {
            Shape::InH2 | Shape::MeshInH2 => TransitionPowers { opening: 1.0, pressure: 0.0, logarithm: 1.0 },
            _ => TransitionPowers::of_regularity(self.tau),
        }
    }

    /// # Errors
    /// As [`SceneFamily::named`].
    fn family(&self, kind: StripKind, coarsest: usize) -> signorini::Result<SceneFamily<'static>> {
        let named = |scene, count| SceneFamily::named(&scene, self.tau, kind, coarsest, count);
        match self.shape {
            Shape::Many => named(StripData::Transitions { gaps: 11 }, 1),
            Shape::FatCantor => named(StripData::FatCantor { depth: 30 }, 1),
            Shape::Elastic => named(StripData::transition(), POSITIONS),
            Shape::ElasticInH2 => {
                SceneFamily::damped(&StripData::transition(), 1.0, kind, coarsest, POSITIONS)
            }
            _ => Ok(SceneFamily::at_thirds(self.powers(), self.tau, coarsest)),
        }
    }

    /// # Errors
    /// Those of the studies.
    fn on_meshes(&self, levels: usize) -> Result<[RateRow; 2]> {
        let (powers, tau, whole_boundary, coarsest) = (self.powers(), self.tau, false, COARSEST);
        on_meshes(&TransitionRates { powers, tau, whole_boundary, coarsest, levels })
    }
}

/// Positions of the elastic transition in its cell, and squares of the coarsest mesh.
const POSITIONS: usize = 5;
const COARSEST: usize = 2;

/// All printed rates with the scenes that stand for them solved in both cones, nodal first, on these levels
/// of a strip and so many meshes; scenes on strips that come twice are solved once.
///
/// # Errors
/// Those of the studies.
pub fn printed_rates(levels: Levels, meshes: usize) -> Result<Vec<(Printed, [RateRow; 2])>> {
    let reference = (16 * levels.finest_cells()).min(1 << 22);
    let mut rows = Vec::new();
    for kind in [StripKind::Scalar, StripKind::Elastic] {
        let is_elastic = |row: &Printed| matches!(row.shape, Shape::Elastic | Shape::ElasticInH2);
        let is_of_kind = |row: &Printed| is_elastic(row) == (kind == StripKind::Elastic);
        let these: Vec<Printed> =
            Printed::ALL.into_iter().filter(|row| !row.is_on_mesh() && is_of_kind(row)).collect();
        let mut group = StripGroup::new(kind, levels, reference);
        let family = |row: &Printed| row.family(kind, levels.coarsest_cells());
        group.families = these.iter().map(family).collect::<signorini::Result<_>>()?;
        rows.extend(these.into_iter().zip(both_cones(&group)?));
    }
    for row in Printed::ALL.into_iter().filter(Printed::is_on_mesh) {
        rows.push((row, row.on_meshes(meshes)?));
    }
    rows.sort_by_key(|(row, _)| Printed::ALL.iter().position(|other| other.key == row.key));
    Ok(rows)
}
