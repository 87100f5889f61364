//! Scenes built on the edge of a strip: choose u_N ≤ 0 and λ = −σ_N ≥ 0 with λ u_N = 0 freely, the load
//! follows.
//!
//! Regularity, Ω two-dimensional: u ∈ H^τ needs u_N ∈ H^{τ−1/2} and λ ∈ H^{τ−3/2} on the edge.
//!
//! * u_N = −δ^p in each gap (a, b), δ = (x−a)(b−x)/(b−a); one end of exponent p lies in H^s for s < p + 1/2,
//!   gaps with boundary dimension d for s ≤ p + 1/2 − d/2. So p = τ − 1 + d/2 gives τ.
//! * transitions (d = 0): λ = dist^{τ−2} on the contact set, of the same regularity τ; τ = 5/2 is the natural
//!   r^{3/2}.
//! * fat Cantor: λ = 1 on C lies in H^{(1−d)/2}, so τ = 2 − d/2: d = 4 − 2τ, p = 1, and both data have
//!   regularity τ.
//! * Cantor of given ratio: d = ln 2/ln(1/ratio), λ = 1 on the pieces left at the last generation.
//!
//! "Of regularity τ" means the supremum of admissible orders, as always with powers.

use super::contact_sets::{Gap, cantor, fat_cantor, many_gaps};
use super::pressure::contact_forces;
use crate::error::{Error, Result};
use crate::strip::{EdgeData, Sides};
use std::f64::consts::LN_2;
use std::fmt;
use std::path::PathBuf;
use std::str::FromStr;
use std::sync::LazyLock;

/// A scene of the strip. Its names, parameters, data and regularities are those of its arm in `form`.
#[derive(Debug, Clone, PartialEq)]
pub enum StripScene {
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
    /// Two columns u_N and λ in a file.
    Samples(PathBuf),
}

/// Position of a single transition unless given: far from every short binary fraction.
const POSITION: f64 = 0.381966;
/// Most generations of a Cantor set; no grid of at most 2^26 cells holds as many.
const LARGEST_DEPTH: usize = 64;
/// Share of the edge that a fat Cantor set covers.
const FAT_MEASURE: f64 = 0.5;

impl StripScene {
    /// One scene of each kind, with the parameters it has when its name gives none.
    fn all() -> [StripScene; 5] {
        [
            StripScene::transition(),
            StripScene::Transitions { gaps: 16 },
            StripScene::Cantor { ratio: 0.3, depth: 20 },
            StripScene::FatCantor { depth: 15 },
            StripScene::Samples(PathBuf::new()),
        ]
    }

    /// All that tells this scene from the others.
    fn form(&mut self) -> Form<'_> {
        match self {
            StripScene::Transition { position } => {
                let place = *position;
                Form {
                    name: "transition",
                    words: format!("one transition at {place}"),
                    parameters: vec![("POSITION", Slot::Number(position))],
                    gaps: Some(1),
                    tau: |sides| {
                        if sides == Sides::Periodic { TauRange::TRANSITION } else { TauRange::SLOPE }
                    },
                    data: Data::powers(move |grid| one_gap(place, grid)),
                }
            }
            StripScene::Transitions { gaps } => {
                let count = *gaps;
                Form {
                    name: "transitions",
                    words: format!("{count} equal gaps"),
                    parameters: vec![("COUNT", Slot::Count(gaps))],
                    gaps: Some(count as u64),
                    tau: |_| TauRange::TRANSITION,
                    data: Data::powers(move |grid| {
                        Ok(ContactSet::with_transitions(many_gaps(grid.cells, count)?, grid))
                    }),
                }
            }
            StripScene::Cantor { ratio, depth } => {
                let (kept, generations) = (*ratio, *depth);
                Form {
                    name: "cantor",
                    words: format!("Cantor set of ratio {kept}, depth {generations}"),
                    parameters: vec![("RATIO", Slot::Number(ratio)), ("DEPTH", Slot::Count(depth))],
                    gaps: Some(binary_gaps(generations)),
                    tau: |_| TauRange::SLOPE,
                    data: Data::powers(move |grid| {
                        Error::require("ratio", kept, "(0, 1/2)", kept > 0.0 && kept < 0.5)?;
                        check_depth(generations)?;
                        Ok(ContactSet::fractal(cantor(grid.cells, kept, generations), LN_2 / -kept.ln()))
                    }),
                }
            }
            StripScene::FatCantor { depth } => {
                let generations = *depth;
                Form {
                    name: "fat-cantor",
                    words: format!("fat Cantor set of depth {generations}"),
                    parameters: vec![("DEPTH", Slot::Count(depth))],
                    gaps: Some(binary_gaps(generations)),
                    tau: |_| TauRange::FAT_CANTOR,
                    data: Data::powers(move |grid| {
                        check_depth(generations)?;
                        let dimension = 4.0 - 2.0 * grid.tau;
                        let gaps = fat_cantor(grid.cells, dimension, FAT_MEASURE, generations);
                        Ok(ContactSet::fractal(gaps, dimension))
                    }),
                }
            }
            StripScene::Samples(file) => Form {
                name: "samples",
                words: format!("samples in {}", file.display()),
                data: Data::Samples(file.clone()),
                parameters: vec![("FILE", Slot::File(file))],
                gaps: None,
                tau: |_| TauRange::TRANSITION,
            },
        }
    }

    /// One transition at an irrational-looking place.
    pub const fn transition() -> Self {
        StripScene::Transition { position: POSITION }
    }

    /// The pair (u_N, λ) with u of regularity `tau` ∈ (3/2, 5/2] on an edge of `cells` cells; samples bring
    /// their own number of cells and no regularity. Beyond 2 only transitions inside the edge: the gap of a
    /// single one on natural sides meets the side at a slope, where u leaves H² whatever τ is.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for τ, position or ratio outside their ranges (a fat Cantor set needs τ < 2),
    /// [`Error::CountOutOfRange`] for counts and where no gap has a free node on this grid,
    /// [`Error::EmptyContact`] when the transition leaves no contact node; as [`EdgeData::from_samples`];
    /// [`Error::File`] for a file that cannot be read.
    pub fn data(&self, tau: f64, cells: usize, sides: Sides) -> Result<EdgeData> {
        let mut scene = self.clone();
        let form = scene.form();
        match form.data {
            Data::Samples(path) => {
                let text = std::fs::read_to_string(&path).map_err(|e| Error::file(&path, e))?;
                EdgeData::from_samples(&text, sides)
            }
            Data::Powers(set) => {
                sides.check_cells(cells)?;
                (form.tau)(sides).check(tau)?;
                let grid = Grid { tau, cells, sides };
                set(grid)?.pair(grid)
            }
        }
    }

    /// How many gaps the construction has, `None` for samples; on a grid those without a free node, or
    /// without contact beside them, are left out with all that would follow them.
    pub fn gaps(&self) -> Option<u64> {
        self.clone().form().gaps
    }

    /// The name without parameters: `transition`, `fat-cantor`.
    pub fn name(&self) -> &'static str {
        self.clone().form().name
    }

    /// The scene in words: `one transition at 0.4`, `fat Cantor set of depth 15`.
    pub fn words(&self) -> String {
        self.clone().form().words
    }

    /// The names and parameters of all strip scenes, for help texts and errors.
    pub fn names() -> &'static str {
        static NAMES: LazyLock<String> = LazyLock::new(|| {
            let names: Vec<String> =
                StripScene::all().iter_mut().map(|scene| scene.form().grammar()).collect();
            names.join(", ")
        });
        &NAMES
    }
}

/// All that tells one scene from another.
struct Form<'a> {
    name: &'static str,
    words: String,
    /// Parameters in the order of the name, each with its placeholder.
    parameters: Vec<(&'static str, Slot<'a>)>,
    /// How many gaps the construction has; `None` when they are given.
    gaps: Option<u64>,
    /// The regularities it can have.
    tau: fn(Sides) -> TauRange,
    data: Data,
}

/// A parameter of a name.
enum Slot<'a> {
    Number(&'a mut f64),
    Count(&'a mut usize),
    File(&'a mut PathBuf),
}

/// Where u_N and λ come from.
enum Data {
    /// Powers of the distance to the ends of gaps.
    Powers(Box<dyn Fn(Grid) -> Result<ContactSet>>),
    /// A file.
    Samples(PathBuf),
}

impl Data {
    fn powers(set: impl Fn(Grid) -> Result<ContactSet> + 'static) -> Self {
        Data::Powers(Box::new(set))
    }
}

impl Form<'_> {
    /// `cantor[:RATIO[:DEPTH]]`; the name of a file cannot be left out.
    fn grammar(&self) -> String {
        let mut text = self.name.to_owned();
        let mut brackets = 0;
        for (placeholder, slot) in &self.parameters {
            let is_needed = matches!(slot, Slot::File(_));
            text += if is_needed { ":" } else { "[:" };
            text += placeholder;
            brackets += usize::from(!is_needed);
        }
        text + &"]".repeat(brackets)
    }

    /// Sets the parameters to the words after the name, each behind a colon; `None` when they do not fit.
    fn read(self, mut rest: Option<&str>) -> Option<()> {
        for (_, slot) in self.parameters {
            let Some(text) = rest else {
                return if matches!(slot, Slot::File(_)) { None } else { Some(()) };
            };
            let (word, tail) = match &slot {
                Slot::File(_) => (text, None),
                _ => text.split_once(':').map_or((text, None), |(word, tail)| (word, Some(tail))),
            };
            match slot {
                Slot::Number(number) => *number = word.parse().ok()?,
                Slot::Count(count) => *count = word.parse().ok()?,
                Slot::File(path) => *path = Some(word).filter(|word| !word.is_empty())?.into(),
            }
            rest = tail;
        }
        rest.is_none().then_some(())
    }
}

impl fmt::Display for StripScene {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut scene = self.clone();
        let form = scene.form();
        f.write_str(form.name)?;
        for (_, slot) in form.parameters {
            match slot {
                Slot::Number(number) => write!(f, ":{number}")?,
                Slot::Count(count) => write!(f, ":{count}")?,
                Slot::File(path) => write!(f, ":{}", path.display())?,
            }
        }
        Ok(())
    }
}

impl FromStr for StripScene {
    type Err = Error;

    fn from_str(text: &str) -> Result<Self> {
        let (name, rest) = text.split_once(':').map_or((text, None), |(name, rest)| (name, Some(rest)));
        StripScene::all()
            .into_iter()
            .find_map(|mut scene| (scene.form().name == name).then_some(scene))
            .and_then(|mut scene| scene.form().read(rest).map(|()| scene))
            .ok_or_else(|| Error::UnknownName {
                what: "scene",
                given: text.to_owned(),
                expected: StripScene::names(),
            })
    }
}

/// Where a scene is built.
#[derive(Debug, Clone, Copy)]
struct Grid {
    tau: f64,
    cells: usize,
    sides: Sides,
}

/// The τ a scene can have.
struct TauRange {
    largest: f64,
    is_attained: bool,
    words: &'static str,
}

impl TauRange {
    /// Ends of gaps inside the edge: up to the natural r^{3/2}.
    const TRANSITION: TauRange = TauRange { largest: 2.5, is_attained: true, words: "(3/2, 5/2]" };
    /// The slope of u_N jumps somewhere, or λ does.
    const SLOPE: TauRange = TauRange { largest: 2.0, is_attained: true, words: "(3/2, 2] for this scene" };
    /// d = 4 − 2τ > 0.
    const FAT_CANTOR: TauRange =
        TauRange { largest: 2.0, is_attained: false, words: "(3/2, 2) for a fat Cantor set" };

    fn check(&self, tau: f64) -> Result<()> {
        let is_inside = tau < self.largest || self.is_attained && tau == self.largest;
        Error::require("tau", tau, self.words, tau > 1.5 && is_inside)?;
        Ok(())
    }
}

/// A contact set on a grid, and the powers of its data.
struct ContactSet {
    gaps: Vec<Gap>,
    /// Boundary dimension d.
    dimension: f64,
    /// λ = dist^q.
    pressure: f64,
    /// How far beyond its left node a single gap begins, in cells, below 1.
    advance: f64,
}

impl ContactSet {
    fn with_transitions(gaps: Vec<Gap>, grid: Grid) -> Self {
        Self { gaps, dimension: 0.0, pressure: grid.tau - 2.0, advance: 0.0 }
    }

    fn fractal(gaps: Vec<Gap>, dimension: f64) -> Self {
        Self { gaps, dimension, pressure: 0.0, advance: 0.0 }
    }

    /// u_N and λ.
    fn pair(&self, grid: Grid) -> Result<EdgeData> {
        let Grid { tau, cells, sides } = grid;
        if self.gaps.is_empty() {
            return Err(Error::CountOutOfRange { name: "gaps on this grid", value: 0, range: "[1, inf)" });
        }
        let exponent = tau - 1.0 + 0.5 * self.dimension;
        let h = 1.0 / cells as f64;
        let nodes = sides.nodes(cells);
        let mut values = vec![0.0; nodes];
        for &gap in &self.gaps {
            for i in gap.left + 1..gap.right.min(gap.left + nodes) {
                let node = if sides == Sides::Periodic { i % cells } else { i };
                if node < nodes {
                    values[node] = -(h * self.depth(gap, i, grid)).powf(exponent);
                }
            }
        }
        let forces = contact_forces(&values, cells, sides, self.pressure);
        Ok(EdgeData::new(cells, sides, values, forces)?.with_regularity(tau))
    }

    /// δ/h at node i of a gap from a = left + advance: (i − a)(b − i)/(b − a), or i − a when it ends beyond
    /// the side.
    fn depth(&self, gap: Gap, i: usize, grid: Grid) -> f64 {
        let left = (i - gap.left) as f64 - self.advance;
        if grid.sides == Sides::Natural && gap.right > grid.cells {
            left
        } else {
            left * (gap.right - i) as f64 / ((gap.right - gap.left) as f64 - self.advance)
        }
    }
}

/// The gap after one transition at `place`: to half a period later, or beyond the side.
fn one_gap(place: f64, grid: Grid) -> Result<ContactSet> {
    Error::require("position", place, "(0, 1)", place > 0.0 && place < 1.0)?;
    let start = place * grid.cells as f64;
    let left = start as usize;
    let right = match grid.sides {
        Sides::Natural => usize::MAX,
        Sides::Periodic => left + grid.cells / 2,
    };
    let set = ContactSet::with_transitions(vec![Gap { left, right }], grid);
    Ok(ContactSet { advance: start.fract(), ..set })
}

/// 2^depth − 1.
fn binary_gaps(depth: usize) -> u64 {
    1u64.checked_shl(depth.try_into().unwrap_or(u32::MAX)).unwrap_or(0).wrapping_sub(1)
}

fn check_depth(depth: usize) -> Result<()> {
    if (1..=LARGEST_DEPTH).contains(&depth) {
        Ok(())
    } else {
        Err(Error::CountOutOfRange { name: "depth", value: depth, range: "[1, 64]" })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

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
            assert_eq!(text.parse::<StripScene>().unwrap().to_string(), text);
        }
        assert_eq!("transition".parse(), Ok(StripScene::transition()));
        assert_eq!("cantor:0.2".parse(), Ok(StripScene::Cantor { ratio: 0.2, depth: 20 }));
        for bad in [
            "",
            "cliff",
            "transition:",
            "transition:x",
            "transitions:",
            "transitions:1.5",
            "transitions:1e300",
            "transitions:-1",
            "cantor::9",
            "cantor:0.2:",
            "fat-cantor:3:4",
            "samples",
            "samples:",
        ] {
            assert!(bad.parse::<StripScene>().is_err(), "{bad}");
        }
    }

    #[test]
    fn the_grammar_is_that_of_the_registry() {
        let names = "transition[:POSITION], transitions[:COUNT], cantor[:RATIO[:DEPTH]], fat-cantor[:DEPTH], \
                     samples:FILE";
        assert_eq!(StripScene::names(), names);
    }
}
