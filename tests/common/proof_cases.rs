//! Every line of the proof of one theorem, as its example writes it, on scenes x h x theta x tau.

use signorini::edge::{ContactPair, SegmentNorms, Traces};
use signorini::problems::StripData;
use signorini::proof::ProofConstants;
use signorini::strip::{EdgeData, LateralCondition};

/// Bounds that coincide agree to the rounding of their sums and to the error of the constants, about 1e-9.
const BOUNDS: f64 = 1e-8;
/// Relative error of sums and constants beside that of the seminorms: 1e-10 from the embedding constant.
const SUMS: f64 = 1e-9;

/// Name, left and right side of a line, and the size of what cancels in them, ∞ for an equality.
pub type Line = (&'static str, f64, f64, f64);
/// The lines of a segment, and the bounds of the integral on it.
pub type Lines = (Vec<Line>, Option<[f64; 4]>);

/// The proof of one theorem.
pub struct Proof {
    /// The lines of a segment with θ; a segment in neither case is an error there.
    pub lines: fn(&SegmentNorms, &ProofConstants, f64) -> Lines,
    /// The factor of the squared norms on the whole edge, for h and θ.
    pub factor: fn(&ProofConstants, f64, f64) -> f64,
}

/// left ≤ right, or left = right, within the error of both sides.
fn holds((name, left, right, size): Line, t: &SegmentNorms) -> bool {
    let relative = SUMS + t.stress.seminorm_error() + t.slope.seminorm_error();
    match size.is_infinite() {
        true => {
            let size = if name.starts_with("(3.4)") { t.depth } else { t.force * t.depth };
            (left - right).abs() <= SUMS * (left.abs() + right.abs()) + 1e-12 * size
        }
        false => left - right <= relative * (left.abs() + right.abs()) + 64.0 * f64::EPSILON * size,
    }
}

impl Proof {
    /// No line fails on n segments, and every bound is at least the one before: how many lines, and the sums of the
    /// bounds over the segments, the last one with the norms of the whole edge.
    pub fn checked(
        &self,
        pair: &ContactPair,
        n: usize,
        theta: f64,
        c: &ProofConstants,
        case: &str,
    ) -> (usize, [f64; 5]) {
        let (mut count, mut sums) = (0, [0.0; 5]);
        for t in pair.norms(n, c.order(), c.q()).unwrap() {
            let (lines, chain) = (self.lines)(&t, c, theta);
            let failed = lines.iter().find(|&&line| !holds(line, &t));
            assert!(failed.is_none(), "{case}, n {n}, theta {theta}: {failed:?}");
            count += lines.len();
            sums.iter_mut().zip(chain.unwrap_or_default()).for_each(|(sum, bound)| *sum += bound);
        }
        let whole = &pair.norms(1, c.order(), c.q()).unwrap()[0];
        let squares = 0.5 * (whole.stress.norm_squared() + whole.displacement_norm_squared());
        sums[4] = (self.factor)(c, 1.0 / n as f64, theta) * squares;
        let ascends = sums.windows(2).all(|pair| pair[0] <= pair[1] * (1.0 + BOUNDS));
        assert!(ascends, "a bound is below the one before: {case}, n {n}, theta {theta}, {sums:?}");
        (count, sums)
    }

    /// The printed θ and three fixed ones on the scenes of every τ: more than 200 cases, more than 10 000 lines.
    pub fn holds_on_all_cases(&self) {
        let mut state = 2012_u64;
        let mut random = move || {
            state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            ((state >> 33) as f64 + 0.5) / (1u64 << 31) as f64
        };
        let (mut cases, mut count) = (0, 0);
        for tau in [1.55, 1.65, 1.75, 1.9, 2.0] {
            let meshes = [4, 16, 64];
            let thetas = |n: usize| [printed_theta(n, tau), 0.5, 0.1, 0.01];
            let zones: Vec<f64> = meshes.iter().flat_map(|&n| thetas(n)).collect();
            let constants = ProofConstants::new(tau, 2.0, &zones).unwrap();
            for n in meshes {
                for problem in scenes(tau, &mut random) {
                    let pair = pair(&problem, tau, n);
                    for theta in thetas(n) {
                        count += self
                            .checked(&pair, n, theta, &constants, &format!("{problem}, tau {tau}"))
                            .0;
                        cases += 1;
                    }
                }
            }
        }
        println!("{cases} cases, {count} lines");
        assert!(cases >= 200 && count > 10_000, "{cases} cases, {count} lines");
    }

    /// Contact everywhere, at one point, up to a vertex, on one segment, at both ends: finite norms, and the lines.
    pub fn holds_on_degenerate_pairs(&self) {
        let cells = 64;
        let touching: [(&str, &dyn Fn(usize) -> bool); 5] = [
            ("full contact", &|_| true),
            ("one contact point", &|i| i == 21),
            ("contact up to a vertex", &|i| i <= 32),
            ("contact on one segment", &|i| (16..=32).contains(&i)),
            ("contact at both ends", &|i| i <= 2 || i >= 62),
        ];
        for tau in [1.75, 2.0] {
            let constants = ProofConstants::new(tau, 2.0, &[0.25]).unwrap();
            for (name, touches) in touching {
                let values: Vec<f64> =
                    (0..=cells).map(|i| if touches(i) { 0.0 } else { -1.0 }).collect();
                // A force needs a contact cell beside its node.
                let carried = |i: usize| {
                    touches(i) && ((i > 0 && touches(i - 1)) || (i < cells && touches(i + 1)))
                };
                let forces: Vec<f64> =
                    (0..=cells).map(|i| if carried(i) { 1.0 } else { 0.0 }).collect();
                let scene =
                    EdgeData::new(cells, LateralCondition::Natural, &values, &forces).unwrap();
                let pair = ContactPair::of_data(&scene, Traces::for_regularity(tau)).unwrap();
                for norms in pair.norms(4, constants.order(), constants.q()).unwrap() {
                    let squares = [norms.displacement_norm_squared(), norms.stress.norm_squared()];
                    assert!(
                        squares.iter().all(|square| square.is_finite()),
                        "{name} tau {tau}: {squares:?}"
                    );
                }
                self.checked(&pair, 4, 0.25, &constants, name);
            }
        }
    }
}

/// h^{2τ−3}, at τ = 2 h².
pub fn printed_theta(n: usize, tau: f64) -> f64 {
    (1.0 / n as f64).powf(if tau == 2.0 { 2.0 } else { 2.0 * tau - 3.0 })
}

/// A problem of the strip as a pair of functions, 64 cells to a segment.
pub fn pair(problem: &StripData, tau: f64, n: usize) -> ContactPair {
    let data = problem.data(tau, 64 * n, LateralCondition::Natural).unwrap();
    ContactPair::of_data(&data, Traces::for_regularity(tau)).unwrap()
}

fn scenes(tau: f64, random: &mut impl FnMut() -> f64) -> [StripData; 4] {
    let rough = match tau < 2.0 {
        true => StripData::FatCantor { depth: 3 + (6.0 * random()) as usize },
        false => StripData::Cantor { ratio: 0.4, depth: 8 },
    };
    [
        StripData::Transition { position: 0.05 + 0.9 * random() },
        StripData::Transitions { gaps: 3 + (20.0 * random()) as usize },
        StripData::Cantor { ratio: 0.2 + 0.2 * random(), depth: 8 },
        rough,
    ]
}
