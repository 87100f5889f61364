//! Every inequality of one section on scenes x h x theta x tau: what the proofs of both theorems are held to.

use experiments::convergence::Levels;
use experiments::proof::{ProofCase, Resolution};
use signorini::problems::StripData;
use signorini::proof::{ProofConstants, Section, Step, ThetaRule};

/// Rungs that coincide agree to the rounding of their sums and to the error of the constants, about 1e-9.
pub const RUNG: f64 = 1e-8;

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
        let mut planned = Vec::new();
        for level in [2, 4, 6] {
            for kind in scenes(tau, &mut random) {
                planned.extend(rules(tau).map(|rule| ProofCase {
                    section,
                    source: kind.clone(),
                    tau,
                    scene_tau: tau,
                    levels: Levels::new(level, level).unwrap(),
                    resolution: Resolution::Segment(6),
                    rule,
                    positions: 1,
                }));
            }
        }
        let zones: Vec<f64> = planned.iter().flat_map(|case| case.zones().unwrap()).collect();
        let constants = ProofConstants::new(tau, 2.0, &zones).unwrap();
        for case in &planned {
            checks += checked(case, &constants);
        }
        cases += planned.len();
    }
    (cases, checks)
}

/// No inequality fails, every segment is in a case, every rung bounds the one before; returns the
/// inequalities.
fn checked(case: &ProofCase, constants: &ProofConstants) -> usize {
    let profile = case.profile(constants).unwrap();
    let (level, name) = (&profile.levels[0], format!("{}, tau {}", case.source, case.tau));
    for inequality in &level.inequalities {
        assert_eq!(
            inequality.violations, 0,
            "{} fails: {name}, n {}, theta {}, left/right {}",
            inequality.line, level.n, level.theta, inequality.sharpest
        );
    }
    assert_eq!(level.cases.neither, 0, "a segment in neither case: {name}, n {}", level.n);
    let rungs = Step::ALL.map(|step| level.rung(step).printed);
    assert!(
        rungs.windows(2).all(|pair| pair[0] <= pair[1] * (1.0 + RUNG)),
        "a rung is below the one it bounds: {name}, n {}, {rungs:?}",
        level.n
    );
    profile.checks()
}
