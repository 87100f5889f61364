//! Consistency terms over families of contact sets at one τ: is any set near the exponent of the theorems?
//!
//! The terms are those of the exact data on the meshes 2^3 ... N/32; no discrete problem is solved. Beside
//! each stands its share of ½ h^{2τ−2} |σ_N|_{τ−3/2} |u_N'|_{τ−3/2}, which bounds every term
//! ([`signorini::proof::worst_ratio`]).
//!
//! A set shows its order only on meshes finer than its smallest piece. On coarser ones a Cantor set with σ_N
//! = −1 on short pieces looks like point forces, of order below the theorem's exponent; its norm
//! |σ_N|_{τ−3/2} is as large, so that the share tells the truth there. Cost: O(N log N) per set.

use crate::ErrorExt;
use signorini::cone::Cone;
use signorini::edge::{consistency_terms, edge_norms};
use signorini::problems::{StripData, TransitionPowers};
use signorini::strip::{EdgeData, LateralCondition};
use signorini::{Result, ToolkitError};
use std::fmt;

/// A family of contact sets.
#[derive(Debug, Clone, PartialEq)]
pub enum ContactFamily {
    /// One transition at nine positions, σ_N ~ r^pressure beside it.
    Transition {
        /// The power, above −1.
        pressure: f64,
    },
    /// A scene of the strip.
    Scene(StripData),
}

/// What the meshes show of a family.
#[derive(Debug, Clone, PartialEq)]
pub struct SetTerms {
    /// Length of the shortest gap or contact piece.
    pub shortest: f64,
    /// (1/h, term) coarsest first, sums over the positions: nodal and midpoint cone.
    pub terms: [Vec<(usize, f64)>; 2],
    /// Largest term over ½ h^{2τ−2} |σ_N|_{τ−3/2} |u_N'|_{τ−3/2} on the edge, for either cone.
    pub shares: [f64; 2],
}

/// Positions of a transition: odd, so that they are spread over the cells of every mesh.
const POSITIONS: usize = 9;
/// Place of the first one, and how far they are spread: one cell of the coarsest mesh.
const FIRST: f64 = 0.3;
const SPREAD: f64 = 0.125;
/// Coarsest mesh, and cells of the data per segment of the finest.
const COARSEST: usize = 8;
const CELLS_PER_SEGMENT: usize = 32;

impl ContactFamily {
    /// Transitions with three densities of σ_N, many transitions, Cantor sets of several ratios and depths,
    /// fat Cantor sets.
    pub fn all(tau: f64) -> Vec<Self> {
        let transitions = [tau - 2.0, 0.0, 0.5].map(|pressure| ContactFamily::Transition { pressure });
        let many = [3, 11, 47].map(|gaps| StripData::Transitions { gaps });
        let cantor = [(0.1, 2), (0.2, 3), (0.3, 4), (0.4, 5), (0.45, 6), (0.1, 20), (0.3, 20), (0.45, 20)]
            .map(|(ratio, depth)| StripData::Cantor { ratio, depth });
        let fat = [4, 30].map(|depth| StripData::FatCantor { depth });
        let scenes = many.into_iter().chain(cantor).chain(fat).map(ContactFamily::Scene);
        transitions.into_iter().chain(scenes).collect()
    }

    /// Its terms for data on `cells` cells.
    ///
    /// # Errors
    /// [`ToolkitError::OutOfRange`](signorini::ToolkitError::OutOfRange) for τ outside (3/2, 2); those of the scenes.
    pub fn terms(&self, tau: f64, cells: usize) -> Result<SetTerms> {
        ToolkitError::require("tau", tau, "(3/2, 2)", tau > 1.5 && tau < 2.0)?;
        let mut found = SetTerms { shortest: 1.0, terms: Default::default(), shares: [0.0; 2] };
        for data in self.data(tau, cells)? {
            found.add(&data, tau)?;
        }
        Ok(found)
    }

    fn data(&self, tau: f64, cells: usize) -> Result<Vec<EdgeData>> {
        match self {
            ContactFamily::Scene(scene) => Ok(vec![scene.data(tau, cells, LateralCondition::Natural)?]),
            &ContactFamily::Transition { pressure } => {
                let powers = TransitionPowers { pressure, ..TransitionPowers::of_regularity(tau) };
                let place = |k: usize| FIRST + SPREAD * k as f64 / POSITIONS as f64;
                (0..POSITIONS).map(|k| powers.data(place(k), cells)).collect()
            }
        }
    }
}

impl fmt::Display for ContactFamily {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            ContactFamily::Transition { pressure } => write!(f, "transition, sigma_N ~ r^{pressure:.2}"),
            ContactFamily::Scene(scene) => scene.fmt(f),
        }
    }
}

impl SetTerms {
    fn add(&mut self, data: &EdgeData, tau: f64) -> Result<()> {
        let norms = edge_norms(data, tau)?;
        self.shortest = self.shortest.min(shortest_piece(data));
        for (k, cone) in [Cone::Nodal, Cone::Midpoint].into_iter().enumerate() {
            let terms = terms_of(data, cone);
            for &(cells, term) in &terms {
                let bound = 0.5 * (cells as f64).powf(2.0 - 2.0 * tau) * norms.slope * norms.pressure;
                self.shares[k] = self.shares[k].max(term / bound);
            }
            if self.terms[k].is_empty() {
                self.terms[k] = terms;
            } else {
                self.terms[k].iter_mut().zip(terms).for_each(|(sum, term)| sum.1 += term.1);
            }
        }
        Ok(())
    }

    /// (h, root of the term), coarsest first, nodal and midpoint cone: what an order is fitted to.
    pub fn roots(&self) -> [Vec<(f64, f64)>; 2] {
        let root = |&(n, term): &(usize, f64)| (1.0 / n as f64, term.sqrt());
        [0, 1].map(|k| self.terms[k].iter().map(root).collect())
    }
}

/// Length of the shortest run of nodes that are all open or all in contact.
fn shortest_piece(data: &EdgeData) -> f64 {
    let values = data.values();
    let runs = values.chunk_by(|a, b| (*a < 0.0) == (*b < 0.0)).map(<[f64]>::len);
    runs.min().unwrap_or(0) as f64 / data.cells() as f64
}

/// Terms on the meshes of the search, coarsest first.
fn terms_of(data: &EdgeData, cone: Cone) -> Vec<(usize, f64)> {
    let mut terms = consistency_terms(data, cone);
    terms.retain(|&(cells, _)| cells >= COARSEST && CELLS_PER_SEGMENT * cells <= data.cells());
    terms.reverse();
    terms
}
