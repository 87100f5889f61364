//! Test problems manufactured on the edge of a strip: u_N ≤ 0 and λ = −σ_N ≥ 0 with λ u_N = 0 are chosen freely, and
//! the load follows.
//!
//! Regularity, Ω two-dimensional: u ∈ H^τ needs u_N ∈ H^{τ−1/2} and λ ∈ H^{τ−3/2} on the edge.
//!
//! * u_N = −δ^p in each non-contact interval (a, b), δ = (x−a)(b−x)/(b−a): near an isolated end of an
//!   interval u_N is in H^s for s < p + 1/2; if the ends form a set of dimension d, for s ≤ p + 1/2 − d/2. So
//!   p = τ − 1 + d/2 gives the regularity τ.
//! * transitions (d = 0): λ = dist^{τ−2} on the contact set, of the same regularity τ; τ = 5/2 is the natural
//!   r^{3/2}.
//! * fat Cantor: λ = 1 on C lies in H^{(1−d)/2}, so τ = 2 − d/2: d = 4 − 2τ, p = 1, and both data have
//!   regularity τ.
//! * Cantor of given ratio: d = ln 2/ln(1/ratio), λ = 1 on the intervals of the last generation.
//!
//! "Of regularity τ" refers to the supremum of admissible orders, as usual for powers.

use super::contact_sets::{Gap, cantor, check_depth, fat_cantor, many_gaps};
use super::gap_data::Gaps;
use super::named::unknown;
use crate::error::{Error, Result};
use crate::strip::{EdgeData, LateralCondition};
use crate::text::read_text;
use std::f64::consts::LN_2;
use std::fmt;
use std::path::PathBuf;
use std::str::{FromStr, Split};

/// Default position of a single transition: not close to a short binary fraction.
const POSITION: f64 = 0.381966;
/// Measure of a fat Cantor set on the edge of length 1.
const FAT_MEASURE: f64 = 0.5;

/// A test problem on the strip.
///
/// A name is `NAME[:PARAMETER[:PARAMETER]]`, with parameters in the order of the fields. Omitted parameters have
/// their default values; a file name cannot be omitted, and no parameter may be empty.
///
/// ```
/// use signorini::{problems::StripData, strip::LateralCondition};
/// let data = StripData::Transitions { gaps: 2 }.data(2.0, 64, LateralCondition::Natural)?;
/// // complementarity at every node, and the requested number of non-contact intervals
/// assert!(data.values().iter().zip(data.forces()).all(|(u, l)| *u <= 0.0 && *l >= 0.0 && u * l == 0.0));
/// assert_eq!(data.gaps(), 2);
/// # Ok::<(), signorini::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub enum StripData {
    /// Contact for x < position, no contact beyond; with periodic sides the non-contact interval ends half a
    /// period later.
    Transition {
        /// Position of the transition, in (0, 1).
        position: f64,
    },
    /// Non-contact intervals of equal length, separated by contact intervals of the same length.
    Transitions {
        /// Number of non-contact intervals.
        gaps: usize,
    },
    /// The Cantor set that keeps two intervals of relative length `ratio` in each of `depth` generations.
    Cantor {
        /// Relative length of these intervals, in (0, 1/2).
        ratio: f64,
        /// Number of generations.
        depth: usize,
    },
    /// A Cantor set of measure 1/2 whose boundary dimension 4 − 2τ gives both data the regularity τ.
    FatCantor {
        /// Number of generations.
        depth: usize,
    },
    /// Samples of u_N and λ from a file with two columns.
    Samples {
        /// Path of the file.
        file: PathBuf,
    },
}

impl StripData {
    /// One test problem of each kind, with default parameters.
    pub fn all() -> Vec<Self> {
        vec![
            StripData::transition(),
            StripData::Transitions { gaps: 16 },
            StripData::Cantor { ratio: 0.3, depth: 20 },
            StripData::FatCantor { depth: 15 },
            StripData::Samples { file: PathBuf::new() },
        ]
    }

    /// The name of the test problem without parameters.
    pub fn name(&self) -> &'static str {
        match self {
            StripData::Transition { .. } => "transition",
            StripData::Transitions { .. } => "transitions",
            StripData::Cantor { .. } => "cantor",
            StripData::FatCantor { .. } => "fat-cantor",
            StripData::Samples { .. } => "samples",
        }
    }

    /// The names and parameters of all test problems, for help texts and error messages.
    pub fn names() -> &'static str {
        "transition[:POSITION], transitions[:GAPS], cantor[:RATIO[:DEPTH]], fat-cantor[:DEPTH], samples:FILE"
    }

    /// The test problem with one transition at a generic point.
    ///
    /// The position x = 0.381966 is close to (3 − √5)/2, so that its place within its cell varies from one
    /// dyadic mesh to the next.
    ///
    /// ```
    /// let value = signorini::problems::StripData::transition().to_string();
    /// assert!(value.starts_with("transition"));
    /// ```
    pub const fn transition() -> Self {
        StripData::Transition { position: POSITION }
    }

    /// True for a single transition, whose position within its cell is varied in convergence studies.
    ///
    /// ```
    /// use signorini::problems::StripData;
    /// assert!(StripData::transition().moves() && !StripData::FatCantor { depth: 3 }.moves());
    /// ```
    pub fn moves(&self) -> bool {
        matches!(self, StripData::Transition { .. })
    }

    /// The pair (u_N, λ) with u of regularity τ = `tau` on an edge of `cells` cells; samples have their own
    /// number of cells and no regularity.
    ///
    /// 3/2 < τ ≤ 5/2 for equal gaps and for one transition with periodic sides, τ ≤ 2 for one transition with
    /// natural sides and for a Cantor set of given ratio, τ < 2 for a fat Cantor set. With natural sides the
    /// non-contact interval of a single transition reaches the lateral boundary, where the slope of u_N is
    /// not zero: u ∉ H².
    ///
    /// ```
    /// use signorini::{problems::StripData, strip::LateralCondition};
    /// let data = |tau| StripData::FatCantor { depth: 2 }.data(tau, 256, LateralCondition::Natural);
    /// assert_eq!((data(1.75)?.regularity(), data(1.75)?.gaps()), (Some(1.75), 3));
    /// assert!(data(2.0).is_err());
    /// # Ok::<(), signorini::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`ToolkitError::OutOfRange`](crate::ToolkitError::OutOfRange) for τ, position or ratio outside their
    /// ranges, [`ToolkitError::CountOutOfRange`](crate::ToolkitError::CountOutOfRange) for inadmissible
    /// counts and if no non-contact interval has a free node on this grid, [`Error::EmptyContact`] if no node
    /// is in contact; [`Error::File`] for a file that cannot be read, or with the message of an error of
    /// [`EdgeData::from_samples`].
    pub fn data(&self, tau: f64, cells: usize, sides: LateralCondition) -> Result<EdgeData> {
        match self {
            StripData::Samples { file } => EdgeData::from_samples(&read_text(file)?, sides)
                .map_err(|fault| Error::file(file, fault)),
            _ => self.powers(tau, 0.0, cells, sides),
        }
    }

    /// The pair at τ = 2 with u_N multiplied by ℓ(δ)^{−α} and λ by ℓ(dist)^{−α}, α = `logarithm`, ℓ(r) = 2 +
    /// ln(1/r).
    ///
    /// δ = (x − a)(b − x)/(b − a) on a non-contact interval (a, b), x − a if it reaches a natural side; dist
    /// is the distance to the nearest one, evaluated at the midpoints of the cells. At a transition the pair
    /// has the regularity of u ∈ H² for α > 1/2, for α = 0 only that of u ∈ H^τ, τ < 2.
    ///
    /// ```
    /// use signorini::{problems::StripData, strip::LateralCondition};
    /// let damped = |alpha| StripData::transition().damped_data(alpha, 64, LateralCondition::Natural);
    /// // ℓ ≥ 2 − ln r > 1: damping lowers every |u_N|
    /// let (plain, damped) = (damped(0.0)?, damped(1.0)?);
    /// assert!(plain.values().iter().zip(damped.values()).all(|(u, v)| u.abs() >= v.abs()));
    /// # Ok::<(), signorini::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`ToolkitError::OutOfRange`](crate::ToolkitError::OutOfRange) unless 0 ≤ α < ∞;
    /// [`ToolkitError::Incompatible`](crate::ToolkitError::Incompatible) for samples; the errors of
    /// [`StripData::data`].
    pub fn damped_data(
        &self,
        logarithm: f64,
        cells: usize,
        sides: LateralCondition,
    ) -> Result<EdgeData> {
        let is_in = logarithm >= 0.0 && logarithm.is_finite();
        Error::require("alpha", logarithm, "[0, inf)", is_in)?;
        self.powers(2.0, logarithm, cells, sides)
    }

    /// The pair of powers of the distance to the ends of gaps, multiplied by ℓ^{−α}, α = `logarithm`.
    fn powers(
        &self,
        tau: f64,
        logarithm: f64,
        cells: usize,
        sides: LateralCondition,
    ) -> Result<EdgeData> {
        sides.check_cells(cells)?;
        let (range, is_inside) = match self {
            // d = 4 − 2τ > 0
            StripData::FatCantor { .. } => ("(3/2, 2) for a fat Cantor set", tau < 2.0),
            // λ or the slope of u_N jumps.
            StripData::Cantor { .. } => ("(3/2, 2] for this problem", tau <= 2.0),
            StripData::Transition { .. } if sides == LateralCondition::Natural => {
                ("(3/2, 2] for this problem", tau <= 2.0)
            }
            // Up to the natural r^{3/2}.
            _ => ("(3/2, 5/2]", tau <= 2.5),
        };
        // Up to τ = 3/2 σ_N has no trace in L² in general.
        Error::require("tau", tau, range, tau > 1.5 && is_inside)?;
        let transitions =
            |gaps| Gaps { gaps, dimension: 0.0, pressure: tau - 2.0, logarithm, advance: 0.0 };
        let gaps = match *self {
            StripData::Transition { position } => {
                Error::require("position", position, "(0, 1)", position > 0.0 && position < 1.0)?;
                let start = position * cells as f64;
                let left = start as usize;
                let right = match sides {
                    LateralCondition::Natural => usize::MAX,
                    LateralCondition::Periodic => left + cells / 2,
                };
                Gaps { advance: start.fract(), ..transitions(vec![Gap { left, right }]) }
            }
            StripData::Transitions { gaps } => transitions(many_gaps(cells, gaps)?),
            StripData::Cantor { ratio, depth } => {
                Error::require("ratio", ratio, "(0, 1/2)", ratio > 0.0 && ratio < 0.5)?;
                check_depth(depth)?;
                let dimension = LN_2 / -ratio.ln();
                Gaps { dimension, pressure: 0.0, ..transitions(cantor(cells, ratio, depth)) }
            }
            StripData::FatCantor { depth } => {
                check_depth(depth)?;
                let dimension = 4.0 - 2.0 * tau;
                let gaps = fat_cantor(cells, dimension, FAT_MEASURE, depth);
                Gaps { dimension, pressure: 0.0, ..transitions(gaps) }
            }
            StripData::Samples { .. } => {
                let expected = "a test problem whose data are powers";
                return Err(Error::incompatible(
                    "test problem",
                    self,
                    "a logarithmic factor",
                    expected,
                ));
            }
        };
        gaps.pair(tau, cells, sides)
    }
}

impl fmt::Display for StripData {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())?;
        match self {
            StripData::Transition { position } => write!(f, ":{position}"),
            StripData::Transitions { gaps } => write!(f, ":{gaps}"),
            StripData::Cantor { ratio, depth } => write!(f, ":{ratio}:{depth}"),
            StripData::FatCantor { depth } => write!(f, ":{depth}"),
            StripData::Samples { file } => write!(f, ":{}", file.display()),
        }
    }
}

impl FromStr for StripData {
    type Err = Error;

    fn from_str(text: &str) -> Result<Self> {
        read(text).ok_or_else(|| unknown(text, Self::names()))
    }
}

/// The test problem with the given name; a file name may contain colons.
fn read(text: &str) -> Option<StripData> {
    if let Some(file) = text.strip_prefix("samples:") {
        return (!file.is_empty()).then(|| StripData::Samples { file: file.into() });
    }
    let mut words = text.split(':');
    let name = words.next()?;
    let mut problem = StripData::all().into_iter().find(|problem| problem.name() == name)?;
    match &mut problem {
        StripData::Transition { position } => set(position, &mut words)?,
        StripData::Transitions { gaps } => set(gaps, &mut words)?,
        StripData::Cantor { ratio, depth } => {
            set(ratio, &mut words)?;
            set(depth, &mut words)?;
        }
        StripData::FatCantor { depth } => set(depth, &mut words)?,
        StripData::Samples { .. } => return None,
    }
    let is_finite = match problem {
        StripData::Transition { position: number } | StripData::Cantor { ratio: number, .. } => {
            number.is_finite()
        }
        _ => true,
    };
    (is_finite && words.next().is_none()).then_some(problem)
}

/// Sets a parameter to the next word, if there is one; `None` if it is no number.
fn set<T: FromStr>(parameter: &mut T, words: &mut Split<'_, char>) -> Option<()> {
    if let Some(word) = words.next() {
        *parameter = word.parse().ok()?;
    }
    Some(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_logarithm_damps_both_data() {
        let (cells, alpha) = (1 << 10, 0.75);
        for source in
            [StripData::Transitions { gaps: 5 }, StripData::Cantor { ratio: 0.3, depth: 9 }]
        {
            let plain = source.data(2.0, cells, LateralCondition::Natural).unwrap();
            assert_eq!(
                source.damped_data(0.0, cells, LateralCondition::Natural).unwrap().values(),
                plain.values()
            );
            let damped = source.damped_data(alpha, cells, LateralCondition::Natural).unwrap();
            for (u, v) in plain.values().iter().zip(damped.values()).filter(|(u, _)| **u != 0.0) {
                // ℓ ≥ 2, and the weight of a depth between half a cell and 1.
                let weight = v / u;
                let least = (2.0 + (2.0 * cells as f64).ln()).powf(-alpha);
                assert!(weight >= least && weight <= 2f64.powf(-alpha), "{source}: {weight}");
            }
            let [total, less] = [&plain, &damped].map(|data| data.forces().iter().sum::<f64>());
            assert!(less < total * 2f64.powf(-alpha) && less > 0.0, "{source}: {less} {total}");
        }
        for bad in [-0.1, f64::NAN, f64::INFINITY] {
            assert!(
                StripData::Transitions { gaps: 5 }
                    .damped_data(bad, cells, LateralCondition::Natural)
                    .is_err()
            );
        }
        let samples = StripData::Samples { file: "edge.txt".into() };
        assert!(samples.damped_data(1.0, cells, LateralCondition::Natural).is_err());
        assert!(
            StripData::FatCantor { depth: 9 }
                .damped_data(1.0, cells, LateralCondition::Natural)
                .is_err()
        );
    }
}
