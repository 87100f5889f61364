//! Every inequality of one section on scenes x h x theta x tau: what the proofs of both theorems are held to.

use signorini::edge::{ContactPair, SegmentNorms, Traces};
use signorini::problems::StripData;
use signorini::proof::{
    Alternative, ProofConstants, Section, SegmentSetting, Step, ThetaRule, TwoLaws, segment_chain,
    segment_checks,
};
use signorini::strip::LateralCondition;

/// Rungs that coincide agree to the rounding of their sums and to the error of the constants, about 1e-9.
pub const RUNG: f64 = 1e-8;

/// The bounds of one mesh in the order of [`Step::ALL`], and how many inequalities were checked.
pub struct Level {
    /// Sums over the segments.
    pub rungs: [TwoLaws; Step::ALL.len()],
    /// Inequalities.
    pub checks: usize,
}

/// θ with γ_θ, and γ for the zone of a segment that is in the second case only.
fn setting(section: Section, norms: &SegmentNorms, theta: f64, constants: &ProofConstants) -> SegmentSetting {
    let gamma = constants.gamma(theta).unwrap();
    let zone = match section {
        Section::Three => Some(norms.free_length),
        Section::Four => norms.contact_diameter(),
    };
    let zone = zone.filter(|zone| {
        !Alternative::of_norms(section, norms, theta).first()
            && (*zone < norms.length || section == Section::Four)
    });
    let own_gamma = zone.map_or(gamma, |zone| constants.gamma_below(zone / norms.length).unwrap().min(gamma));
    SegmentSetting { theta, gamma, own_gamma, law: constants.law(theta) }
}

/// No inequality fails on n segments, every segment is in a case, every rung bounds the one before.
pub fn checked(
    section: Section,
    pair: &ContactPair,
    n: usize,
    theta: f64,
    constants: &ProofConstants,
    name: &str,
) -> Level {
    let mut level = Level { rungs: Default::default(), checks: 0 };
    for norms in pair.norms(n, constants.order(), constants.q()).unwrap() {
        let setting = setting(section, &norms, theta, constants);
        for check in segment_checks(section, &norms, constants, &setting) {
            assert!(check.holds(), "{name}, n {n}, theta {theta}: {check:?}");
            level.checks += 1;
        }
        let case = Alternative::of_norms(section, &norms, theta);
        assert!(case != Alternative::Neither, "a segment in neither case: {name}, n {n}");
        let chain = segment_chain(section, &norms, constants, &setting);
        level.rungs.iter_mut().zip(chain).for_each(|(sum, part)| sum.add(part, 1.0));
    }
    let whole = &pair.norms(1, constants.order(), constants.q()).unwrap()[0];
    let squares = 0.5 * (whole.stress.norm_squared() + whole.displacement_norm_squared());
    let factors = constants.edge_factor(section, 1.0 / n as f64, theta);
    level.rungs[Step::WholeEdge as usize] = factors.map(|factor| factor * squares);
    assert!(
        level.rungs.windows(2).all(|pair| pair[0].printed <= pair[1].printed * (1.0 + RUNG)),
        "a rung is below the one it bounds: {name}, n {n}, {:?}",
        level.rungs
    );
    level
}

/// A problem of the strip as a pair of functions, 64 cells to a segment.
pub fn pair(problem: &StripData, tau: f64, n: usize) -> ContactPair {
    let data = problem.data(tau, 64 * n, LateralCondition::Natural).unwrap();
    ContactPair::of_data(&data, Traces::for_regularity(tau)).unwrap()
}

/// A linear congruential generator with a fixed seed.
struct Random(u64);

impl Random {
    /// In (0, 1).
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        ((self.0 >> 33) as f64 + 0.5) / (1u64 << 31) as f64
    }
}

fn scenes(tau: f64, random: &mut Random) -> Vec<StripData> {
    let rough = if tau < 2.0 {
        StripData::FatCantor { depth: 3 + (6.0 * random.next()) as usize }
    } else {
        StripData::Cantor { ratio: 0.4, depth: 8 }
    };
    vec![
        StripData::Transition { position: 0.05 + 0.9 * random.next() },
        StripData::Transitions { gaps: 3 + (20.0 * random.next()) as usize },
        StripData::Cantor { ratio: 0.2 + 0.2 * random.next(), depth: 8 },
        rough,
    ]
}

/// The printed theta and three fixed ones.
fn rules(tau: f64) -> [ThetaRule; 4] {
    [ThetaRule::Printed { tau }, ThetaRule::Fixed(0.5), ThetaRule::Fixed(0.1), ThetaRule::Fixed(0.01)]
}

/// Every inequality on scenes x h x theta x tau; returns (cases, inequalities).
pub fn all_cases(section: Section, taus: &[f64]) -> (usize, usize) {
    let mut random = Random(2012);
    let (mut cases, mut checks) = (0, 0);
    for &tau in taus {
        let meshes = [4, 16, 64];
        let thetas = |n: usize| rules(tau).map(|rule| rule.theta(1.0 / n as f64).unwrap());
        let zones: Vec<f64> = meshes.iter().flat_map(|&n| thetas(n)).collect();
        let constants = ProofConstants::new(tau, 2.0, &zones).unwrap();
        for n in meshes {
            for problem in scenes(tau, &mut random) {
                let pair = pair(&problem, tau, n);
                for theta in thetas(n) {
                    let name = format!("{problem}, tau {tau}");
                    checks += checked(section, &pair, n, theta, &constants, &name).checks;
                    cases += 1;
                }
            }
        }
    }
    (cases, checks)
}
