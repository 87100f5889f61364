//! Scenes built on the edge: choose u_N ≤ 0 and λ = −σ_N ≥ 0 with λ u_N = 0 freely, the load follows.
//!
//! On a fine edge of N cells with operator A (of a strip, or of the continuous harmonic problem) the pair (g, λ) solves
//! the contact problem with the edge load b = A g + λ. Regularity, Ω two-dimensional: u ∈ H^τ needs g ∈ H^{τ−1/2} and
//! λ ∈ H^{τ−3/2} on the edge.
//!
//! * g = −δ^p in each gap (a, b), δ = (x−a)(b−x)/(b−a); one end of exponent p lies in H^s for s < p + 1/2, gaps with
//!   boundary dimension d for s ≤ p + 1/2 − d/2. So p = τ − 1 + d/2 gives τ.
//! * transitions (d = 0): λ = dist^{τ−2} on the contact set, of the same regularity τ; τ = 5/2 is the natural r^{3/2}.
//! * fat Cantor: λ = 1 on C lies in H^{(1−d)/2}, so τ = 2 − d/2: d = 4 − 2τ, p = 1, and both data have regularity τ.
//! * Cantor of given ratio: d = ln 2/ln(1/ratio), λ = 1 on the pieces left at the last generation.
//!
//! "Of regularity τ" means the supremum of admissible orders, as always with powers.

use super::contact_sets::{Gap, cantor, fat_cantor, many_gaps};
use super::pressure::contact_forces;
use super::sides::{Sides, check_cells};
use crate::error::{Error, Result};
use crate::numeric::check::{require_finite, require_length};
use std::fmt;

/// Which contact set a scene has.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum SceneKind {
    /// Contact for x < position, none beyond; on periodic sides the gap ends half a period later.
    Transition {
        /// Place of the transition, in (0, 1).
        position: f64,
    },
    /// Gaps of equal length, as long as the contact pieces between them.
    Transitions {
        /// How many gaps.
        gaps: usize,
    },
    /// The Cantor set that keeps two pieces of relative length `ratio` in each of `depth` generations.
    Cantor {
        /// Relative length of the pieces, in (0, 1/2).
        ratio: f64,
        /// Generations.
        depth: usize,
    },
    /// A Cantor set of measure 1/2 whose boundary dimension 4 − 2τ makes both data of regularity τ.
    FatCantor {
        /// Generations.
        depth: usize,
    },
}

impl SceneKind {
    /// How many gaps the construction has; on a grid those without a free node, or without contact beside them, are left out
    /// with all that would follow them.
    pub fn gaps(self) -> u64 {
        match self {
            SceneKind::Transition { .. } => 1,
            SceneKind::Transitions { gaps } => gaps as u64,
            SceneKind::Cantor { depth, .. } | SceneKind::FatCantor { depth } => {
                1u64.checked_shl(depth.try_into().unwrap_or(u32::MAX)).unwrap_or(0).wrapping_sub(1)
            }
        }
    }
}

impl fmt::Display for SceneKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            SceneKind::Transition { position } => write!(f, "one transition at {position}"),
            SceneKind::Transitions { gaps } => write!(f, "{gaps} equal gaps"),
            SceneKind::Cantor { ratio, depth } => write!(f, "Cantor set of ratio {ratio}, depth {depth}"),
            SceneKind::FatCantor { depth } => write!(f, "fat Cantor set of depth {depth}"),
        }
    }
}

/// Complementary data on a fine edge.
#[derive(Debug, Clone, PartialEq)]
pub struct EdgeScene {
    cells: usize,
    sides: Sides,
    values: Vec<f64>,
    forces: Vec<f64>,
    regularity: Option<f64>,
}

impl EdgeScene {
    /// The scene with u_N = `values` ≤ 0 and nodal forces λ = `forces` ≥ 0 at the nodes of an edge of `cells` cells.
    ///
    /// # Errors
    /// [`Error::LengthMismatch`], [`Error::NotFinite`]; [`Error::OutOfRange`] for a wrong sign;
    /// [`Error::NotComplementary`] when both are nonzero at a node; [`Error::EmptyContact`] when no node has u_N = 0.
    pub fn new(cells: usize, sides: Sides, values: Vec<f64>, forces: Vec<f64>) -> Result<Self> {
        check_cells(cells, sides)?;
        for (name, field) in [("u_N", &values), ("lambda", &forces)] {
            require_length(name, field.len(), sides.nodes(cells))?;
            require_finite(name, field)?;
        }
        for (node, (&value, &force)) in values.iter().zip(&forces).enumerate() {
            Error::require("u_N", value, "(-inf, 0]", value <= 0.0)?;
            Error::require("lambda", force, "[0, inf)", force >= 0.0)?;
            if value != 0.0 && force != 0.0 {
                return Err(Error::NotComplementary { node, value, force });
            }
        }
        if values.iter().all(|&v| v != 0.0) {
            return Err(Error::EmptyContact { nodes: values.len() });
        }
        Ok(Self { cells, sides, values, forces, regularity: None })
    }

    /// A scene of the given kind with u of regularity `tau` ∈ (3/2, 5/2], on an edge of `cells` cells. Beyond 2 only transitions inside
    /// the edge: the gap of a single one on natural sides meets the side at a slope, where u leaves H² whatever τ is.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for τ, position or ratio outside their ranges (a fat Cantor set needs τ < 2),
    /// [`Error::CountOutOfRange`] for counts and where no gap has a free node on this grid, [`Error::EmptyContact`] when the transition leaves no contact node.
    pub fn build(kind: SceneKind, tau: f64, cells: usize, sides: Sides) -> Result<Self> {
        check_cells(cells, sides)?;
        Error::require("tau", tau, "(3/2, 5/2]", tau > 1.5 && tau <= 2.5)?;
        let is_smooth = match kind {
            SceneKind::Transitions { .. } => true,
            SceneKind::Transition { .. } => sides == Sides::Periodic,
            SceneKind::Cantor { .. } | SceneKind::FatCantor { .. } => false,
        };
        Error::require("tau", tau, "(3/2, 2] for this scene", tau <= 2.0 || is_smooth)?;
        let ContactSetShape { gaps, dimension, advance } = gaps_of(kind, tau, cells, sides)?;
        if gaps.is_empty() {
            return Err(Error::CountOutOfRange { name: "gaps on this grid", value: 0, range: "[1, inf)" });
        }
        let exponent = tau - 1.0 + 0.5 * dimension;
        let fractal = matches!(kind, SceneKind::Cantor { .. } | SceneKind::FatCantor { .. });
        let pressure = if fractal { 0.0 } else { tau - 2.0 };
        let h = 1.0 / cells as f64;
        let nodes = sides.nodes(cells);
        let mut values = vec![0.0; nodes];
        for gap in &gaps {
            for i in gap.left + 1..gap.right.min(gap.left + nodes) {
                let node = if sides == Sides::Periodic { i % cells } else { i };
                if node < nodes {
                    values[node] = -(h * depth_in(*gap, advance, i, cells, sides)).powf(exponent);
                }
            }
        }
        let forces = contact_forces(&values, cells, sides, pressure);
        let mut scene = Self::new(cells, sides, values, forces)?;
        scene.regularity = Some(tau);
        Ok(scene)
    }

    /// Reads u_N and λ (a density) from text: one line per node, two numbers per line, `#` starts a comment. The
    /// number of lines is 2^k + 1 with natural sides and 2^k with periodic ones.
    ///
    /// # Errors
    /// [`Error::Syntax`] naming the line that is not two numbers; [`Error::CountOutOfRange`] for the number of lines;
    /// and as [`EdgeScene::new`].
    pub fn from_samples(text: &str, sides: Sides) -> Result<Self> {
        let mut values = Vec::new();
        let mut densities = Vec::new();
        for (index, line) in text.lines().enumerate() {
            let content = line.split('#').next().unwrap_or("").trim();
            if content.is_empty() {
                continue;
            }
            let bad = || Error::Syntax {
                format: "samples",
                line: index + 1,
                reason: format!("expected two numbers, got '{line}'"),
            };
            let numbers: Vec<f64> = content
                .split(|c: char| c.is_whitespace() || c == ',')
                .filter(|word| !word.is_empty())
                .map(|word| word.parse().map_err(|_| bad()))
                .collect::<Result<_>>()?;
            let [value, density] = numbers[..] else {
                return Err(bad());
            };
            values.push(value);
            densities.push(density);
        }
        let (cells, range) = match sides {
            Sides::Natural => (values.len().saturating_sub(1), "the numbers 2^k + 1, k >= 1"),
            Sides::Periodic => (values.len(), "the numbers 2^k, k >= 1"),
        };
        if !cells.is_power_of_two() || cells < 2 {
            return Err(Error::CountOutOfRange { name: "lines of samples", value: values.len(), range });
        }
        let forces = (0..densities.len())
            .map(|i| {
                let at_side = sides == Sides::Natural && (i == 0 || i == cells);
                densities[i] * if at_side { 0.5 } else { 1.0 } / cells as f64
            })
            .collect();
        Self::new(cells, sides, values, forces)
    }

    /// Number of cells of the fine edge.
    pub fn cells(&self) -> usize {
        self.cells
    }

    /// What the sides do.
    pub fn sides(&self) -> Sides {
        self.sides
    }

    /// u_N at the nodes.
    pub fn values(&self) -> &[f64] {
        &self.values
    }

    /// λ at the nodes, as forces.
    pub fn forces(&self) -> &[f64] {
        &self.forces
    }

    /// τ, when it is known analytically.
    pub fn regularity(&self) -> Option<f64> {
        self.regularity
    }

    /// Number of gaps on the fine edge: maximal runs of nodes with u_N < 0.
    pub fn gaps(&self) -> usize {
        let open = |i: usize| self.values[i] < 0.0;
        let inner = (1..self.values.len()).filter(|&i| open(i) && !open(i - 1)).count();
        let first_is_new = self.sides == Sides::Natural || !open(self.values.len() - 1);
        inner + usize::from(open(0) && first_is_new)
    }
}

/// The gaps of a scene, their boundary dimension d, and how far beyond its left node a single gap begins (in cells, below 1).
struct ContactSetShape {
    gaps: Vec<Gap>,
    dimension: f64,
    advance: f64,
}

fn gaps_of(kind: SceneKind, tau: f64, cells: usize, sides: Sides) -> Result<ContactSetShape> {
    let shape = |gaps, dimension| ContactSetShape { gaps, dimension, advance: 0.0 };
    match kind {
        SceneKind::Transition { position } => {
            Error::require("position", position, "(0, 1)", position > 0.0 && position < 1.0)?;
            let place = position * cells as f64;
            let left = place as usize;
            let right = match sides {
                // Beyond the side: the gap never closes.
                Sides::Natural => usize::MAX,
                Sides::Periodic => left + cells / 2,
            };
            Ok(ContactSetShape { gaps: vec![Gap { left, right }], dimension: 0.0, advance: place.fract() })
        }
        SceneKind::Transitions { gaps } => Ok(shape(many_gaps(cells, gaps)?, 0.0)),
        SceneKind::Cantor { ratio, depth } => {
            Error::require("ratio", ratio, "(0, 1/2)", ratio > 0.0 && ratio < 0.5)?;
            check_depth(depth)?;
            let dimension = std::f64::consts::LN_2 / -ratio.ln();
            Ok(shape(cantor(cells, ratio, depth), dimension))
        }
        SceneKind::FatCantor { depth } => {
            Error::require("tau", tau, "(3/2, 2) for a fat Cantor set", tau < 2.0)?;
            check_depth(depth)?;
            let dimension = 4.0 - 2.0 * tau;
            Ok(shape(fat_cantor(cells, dimension, 0.5, depth), dimension))
        }
    }
}

fn check_depth(depth: usize) -> Result<()> {
    if (1..=64).contains(&depth) {
        Ok(())
    } else {
        Err(Error::CountOutOfRange { name: "depth", value: depth, range: "[1, 64]" })
    }
}

/// δ/h at node i of a gap from a = left + advance: (i − a)(b − i)/(b − a), or i − a when the gap ends beyond the side.
fn depth_in(gap: Gap, advance: f64, i: usize, cells: usize, sides: Sides) -> f64 {
    let left = (i - gap.left) as f64 - advance;
    if sides == Sides::Natural && gap.right > cells {
        left
    } else {
        left * (gap.right - i) as f64 / ((gap.right - gap.left) as f64 - advance)
    }
}
