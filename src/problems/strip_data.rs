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

use super::contact_sets::{cantor, check_depth, fat_cantor, generated_gaps, many_gaps};
use super::gap_data::{Gaps, Grid};
use super::registry::registry;
use super::tau_range::TauRange;
use crate::error::{Error, Result, ToolkitError};
use crate::strip::{EdgeData, LateralCondition};
use crate::text::read_text;
use std::f64::consts::LN_2;
use std::path::PathBuf;

/// Default position of a single transition: not close to a short binary fraction.
const POSITION: f64 = 0.381966;
/// Measure of a fat Cantor set on the edge of length 1.
const FAT_MEASURE: f64 = 0.5;

registry! {
    /// A test problem on the strip. Each variant is defined in one block of the source: parameters with defaults,
    /// data, admissible regularities.
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
    pub enum StripData: Form {
        /// Contact for x < position, no contact beyond; with periodic sides the non-contact interval ends half a
        /// period later.
        Transition("transition") {
            /// Position of the transition, in (0, 1).
            position: f64 = POSITION,
        } => Form {
            words: format!("one transition at {position}"),
            gaps: Some(1),
            tau: |sides| if sides == LateralCondition::Periodic { TauRange::TRANSITION } else { TauRange::SLOPE },
            data: Data::powers(move |grid| Gaps::after_transition(position, grid)),
        };

        /// Non-contact intervals of equal length, separated by contact intervals of the same length.
        Transitions("transitions") {
            /// Number of non-contact intervals.
            gaps: usize = 16,
        } => Form {
            words: format!("{gaps} equal gaps"),
            gaps: Some(gaps as u64),
            tau: |_| TauRange::TRANSITION,
            data: Data::powers(move |grid| {
                Ok(Gaps::with_transitions(many_gaps(grid.cells, gaps)?, grid))
            }),
        };

        /// The Cantor set that keeps two intervals of relative length `ratio` in each of `depth` generations.
        Cantor("cantor") {
            /// Relative length of these intervals, in (0, 1/2).
            ratio: f64 = 0.3,
            /// Number of generations.
            depth: usize = 20,
        } => Form {
            words: format!("Cantor set of ratio {ratio}, depth {depth}"),
            gaps: Some(generated_gaps(depth)),
            tau: |_| TauRange::SLOPE,
            data: Data::powers(move |grid| {
                Error::require("ratio", ratio, "(0, 1/2)", ratio > 0.0 && ratio < 0.5)?;
                check_depth(depth)?;
                Ok(Gaps::fractal(cantor(grid.cells, ratio, depth), LN_2 / -ratio.ln()))
            }),
        };

        /// A Cantor set of measure 1/2 whose boundary dimension 4 − 2τ gives both data the regularity τ.
        FatCantor("fat-cantor") {
            /// Number of generations.
            depth: usize = 15,
        } => Form {
            words: format!("fat Cantor set of depth {depth}"),
            gaps: Some(generated_gaps(depth)),
            tau: |_| TauRange::FAT_CANTOR,
            data: Data::powers(move |grid| {
                check_depth(depth)?;
                let dimension = 4.0 - 2.0 * grid.tau;
                Ok(Gaps::fractal(fat_cantor(grid.cells, dimension, FAT_MEASURE, depth), dimension))
            }),
        };

        /// Samples of u_N and λ from a file with two columns.
        Samples("samples") {
            /// Path of the file.
            file: PathBuf = PathBuf::new(),
        } => Form {
            words: format!("samples in {}", file.display()),
            gaps: None,
            tau: |_| TauRange::TRANSITION,
            data: Data::Samples(file),
        };
    }
}

/// The data that characterise a test problem.
struct Form {
    words: String,
    /// Number of non-contact intervals of the construction; `None` for samples.
    gaps: Option<u64>,
    /// The admissible regularities.
    tau: fn(LateralCondition) -> TauRange,
    data: Data,
}

/// The source of u_N and λ.
enum Data {
    /// Powers of the distance to the ends of gaps.
    Powers(Box<dyn Fn(Grid) -> Result<Gaps>>),
    /// Samples from a file.
    Samples(PathBuf),
}

impl Data {
    fn powers(gaps: impl Fn(Grid) -> Result<Gaps> + 'static) -> Self {
        Data::Powers(Box::new(gaps))
    }
}

impl StripData {
    /// The test problem with one transition at a generic point.
    ///
    /// The position x = 0.381966 is close to (3 − √5)/2, so that its place within its cell varies from one
    /// dyadic mesh to the next.
    ///
    /// ```
    /// let value = signorini::problems::StripData::transition().to_string();
    /// assert!(value.starts_with("transition"));
    /// # Ok::<(), signorini::Error>(())
    /// ```
    pub const fn transition() -> Self {
        StripData::Transition { position: POSITION }
    }

    /// True for a single transition, whose position within its cell is varied in convergence studies.
    ///
    /// ```
    /// use signorini::problems::StripData;
    /// assert!(StripData::transition().moves() && !StripData::FatCantor { depth: 3 }.moves());
    /// # Ok::<(), signorini::Error>(())
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
        let form = self.form();
        match form.data {
            Data::Samples(path) => {
                EdgeData::from_samples(&read_text(&path)?, sides).map_err(|fault| Error::file(&path, fault))
            }
            Data::Powers(gaps) => {
                sides.check_cells(cells)?;
                (form.tau)(sides).check(tau)?;
                let grid = Grid { tau, cells, sides };
                gaps(grid)?.pair(grid)
            }
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
    pub fn damped_data(&self, logarithm: f64, cells: usize, sides: LateralCondition) -> Result<EdgeData> {
        let is_in = logarithm >= 0.0 && logarithm.is_finite();
        Error::require("alpha", logarithm, "[0, inf)", is_in)?;
        let form = self.form();
        let Data::Powers(gaps) = form.data else {
            let (what, with, expected) =
                ("test problem", "a logarithmic factor", "a test problem whose data are powers");
            return Err(Error::Toolkit(ToolkitError::Incompatible {
                what,
                given: self.to_string(),
                with,
                expected,
            }));
        };
        sides.check_cells(cells)?;
        (form.tau)(sides).check(2.0)?;
        let grid = Grid { tau: 2.0, cells, sides };
        gaps(grid)?.damped(logarithm).pair(grid)
    }

    /// The number of non-contact intervals of the construction; `None` for samples. On a grid, intervals without a
    /// free node or without adjacent contact are omitted together with their descendants.
    ///
    /// ```
    /// // 2^depth − 1 gaps in a Cantor set of `depth` generations
    /// assert_eq!(signorini::problems::StripData::Cantor { ratio: 0.3, depth: 5 }.gaps(), Some(31));
    /// # Ok::<(), signorini::Error>(())
    /// ```
    pub fn gaps(&self) -> Option<u64> {
        self.form().gaps
    }

    /// A description of the test problem, such as `one transition at 0.4` or `fat Cantor set of depth 15`.
    ///
    /// ```
    /// use signorini::problems::StripData;
    /// assert_eq!(StripData::FatCantor { depth: 15 }.words(), "fat Cantor set of depth 15");
    /// # Ok::<(), signorini::Error>(())
    /// ```
    pub fn words(&self) -> String {
        self.form().words
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    #[test]
    fn names_are_read_back() {
        for text in [
            "transition:0.25",
            "transitions:7",
            "cantor:0.2:9",
            "fat-cantor:12",
            "samples:edge.txt",
            "samples:a:b",
        ] {
            assert_eq!(text.parse::<StripData>().unwrap().to_string(), text);
        }
        assert_eq!("transition".parse(), Ok(StripData::transition()));
        assert_eq!("cantor:0.2".parse(), Ok(StripData::Cantor { ratio: 0.2, depth: 20 }));
        for bad in ["transitions:1e300", "transitions:-1", "cantor::9", "cantor:0.2:", "fat-cantor:3:4"] {
            assert!(bad.parse::<StripData>().is_err(), "{bad}");
        }
    }

    #[test]
    fn a_logarithm_damps_both_data() {
        let (cells, alpha) = (1 << 10, 0.75);
        for source in [StripData::Transitions { gaps: 5 }, StripData::Cantor { ratio: 0.3, depth: 9 }] {
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
            StripData::FatCantor { depth: 9 }.damped_data(1.0, cells, LateralCondition::Natural).is_err()
        );
    }

    #[test]
    fn every_problem_has_words_and_data_of_its_own() {
        let sources = StripData::all();
        let words: BTreeSet<String> = sources.iter().map(StripData::words).collect();
        assert_eq!(words.len(), sources.len());
        for source in sources.iter().filter(|source| source.gaps().is_some()) {
            let data = source.data(1.75, 1 << 12, LateralCondition::Natural).unwrap();
            let planned = source.gaps().unwrap();
            assert!((1..=planned).contains(&(data.gaps() as u64)), "{source}: {} of {planned}", data.gaps());
            assert_eq!(data.regularity(), Some(1.75), "{source}");
        }
    }
}
