//! Theorem 4.1, its proof: (4.9)-(4.14) on computed pairs, each side by itself, and the ladder of bounds.

use signorini::proof::{ProofCase, ProofConstants, Resolution, Section, ThetaRule};
use signorini::scenes::StripScene;
use signorini::strip::Levels;

#[allow(dead_code)]
#[path = "../examples/theorem_4_1_proof_profile.rs"]
mod theorem_4_1_proof_profile;

const SECTION: Section = Section::Four;
/// Rungs that coincide agree to the rounding of their sums and to the error of the constants, about 1e-9.
const RUNG: f64 = 1e-8;

/// A linear congruential generator with a fixed seed.
struct Random(u64);

impl Random {
    /// In (0, 1).
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        ((self.0 >> 33) as f64 + 0.5) / (1u64 << 31) as f64
    }
}

fn scenes(tau: f64, random: &mut Random) -> Vec<StripScene> {
    let rough = if tau < 2.0 {
        StripScene::FatCantor { depth: 3 + (6.0 * random.next()) as usize }
    } else {
        StripScene::Cantor { ratio: 0.4, depth: 8 }
    };
    vec![
        StripScene::Transition { position: 0.05 + 0.9 * random.next() },
        StripScene::Transitions { gaps: 3 + (20.0 * random.next()) as usize },
        StripScene::Cantor { ratio: 0.2 + 0.2 * random.next(), depth: 8 },
        rough,
    ]
}

/// Every inequality on scenes x h x theta x tau; returns (cases, inequalities).
fn all_cases(taus: &[f64]) -> (usize, usize) {
    let mut random = Random(2012);
    let (mut cases, mut checks) = (0, 0);
    for &tau in taus {
        let mut constants = ProofConstants::new(tau, 2.0).unwrap();
        for level in [2, 4, 6] {
            for kind in scenes(tau, &mut random) {
                for rule in [
                    ThetaRule::Printed { tau },
                    ThetaRule::Fixed(0.5),
                    ThetaRule::Fixed(0.1),
                    ThetaRule::Fixed(0.01),
                ] {
                    let case = ProofCase {
                        section: SECTION,
                        source: kind.clone(),
                        tau,
                        scene_tau: tau,
                        levels: Levels::new(level, level).unwrap(),
                        resolution: Resolution::Segment(6),
                        rule,
                        positions: 1,
                    };
                    let profile = case.profile(&mut constants).unwrap();
                    let level = &profile.levels[0];
                    for inequality in &level.inequalities {
                        assert_eq!(
                            inequality.violations, 0,
                            "{} fails: {kind}, tau {tau}, n {}, theta {}, left/right {}",
                            inequality.label, level.n, level.theta, inequality.sharpest
                        );
                        checks += inequality.count;
                    }
                    assert_eq!(
                        level.cases[2], 0,
                        "a segment in neither case: {kind}, tau {tau}, n {}",
                        level.n
                    );
                    let rungs = level.rungs.map(|values| values[0]);
                    assert!(
                        rungs.windows(2).all(|pair| pair[0] <= pair[1] * (1.0 + RUNG)),
                        "a rung is below the one it bounds: {kind}, tau {tau}, n {}, {rungs:?}",
                        level.n
                    );
                    cases += 1;
                }
            }
        }
    }
    (cases, checks)
}

#[test]
fn every_inequality_holds_on_more_than_two_hundred_cases() {
    let (cases, checks) = all_cases(&[1.55, 1.65, 1.75, 1.9, 2.0]);
    println!("{cases} cases, {checks} inequalities");
    assert!(cases >= 200 && checks > 10_000, "{cases} cases, {checks} inequalities");
}

#[test]
fn above_two_every_segment_with_contact_obeys_4_14() {
    for tau in [2.05, 2.25, 2.45] {
        let mut constants = ProofConstants::new(tau, 2.0).unwrap();
        let case = ProofCase {
            tau,
            scene_tau: tau,
            levels: Levels::new(3, 8).unwrap(),
            ..ProofCase::standard(SECTION).unwrap()
        };
        let profile = case.profile(&mut constants).unwrap();
        assert_eq!(profile.violations(), 0, "tau {tau}");
        let ladder = profile.ladder().unwrap();
        let exponent = ladder[0].exponent;
        // h^(2 + 2 eps) is optimal on one transition.
        assert!((exponent.value - (2.0 * tau - 2.0)).abs() < 0.1, "tau {tau}: {exponent:?}");
        assert!((ladder[6].exponent.value - (2.0 * tau - 2.0)).abs() < 1e-9);
        let rough = ProofCase { source: StripScene::Cantor { ratio: 0.3, depth: 5 }, ..case };
        assert!(rough.profile(&mut constants).is_err(), "only a transition is that smooth");
    }
}

#[test]
fn the_losses_add_up_to_the_distance_from_the_printed_exponent() {
    let mut constants = ProofConstants::new(1.75, 2.0).unwrap();
    for source in ["transition", "fat-cantor"] {
        let case = ProofCase {
            source: source.parse::<StripScene>().unwrap(),
            ..ProofCase::standard(SECTION).unwrap()
        };
        assert!(case.levels.cells().count() >= 8);
        let profile = case.profile(&mut constants).unwrap();
        let ladder = profile.ladder().unwrap();
        let losses: Vec<_> = ladder.iter().filter_map(|rung| rung.loss).collect();
        let sum: f64 = losses.iter().map(|loss| loss.value).sum();
        let uncertainty: f64 = losses.iter().map(|loss| loss.uncertainty).sum();
        let distance = ladder[0].exponent.value - profile.printed_exponent();
        println!("{source}: losses {sum:.4}, distance {distance:.4}, uncertainties {uncertainty:.4}");
        assert!((sum - distance).abs() <= uncertainty.min(1e-6), "{source}: {sum} and {distance}");
        let (zone, law) = (losses[3], losses[4]);
        let together = zone.uncertainty + law.uncertainty;
        assert!((zone.value + law.value - 0.125).abs() <= together, "{source}: {zone:?} {law:?}");
    }
}

#[test]
fn the_example_finds_no_violation() {
    let headline = theorem_4_1_proof_profile::run(&theorem_4_1_proof_profile::Options::default()).unwrap();
    assert!(headline.verdict.is_confirmed(), "{}", headline.verdict);
    let value = |key: &str| headline.values.iter().find(|(k, _)| k == key).unwrap().1;
    assert_eq!(value("theorem.4.1.proof.violations"), 0.0);
    assert!((value("theorem.4.1.proof.edge.exponent") - 1.375).abs() < 1e-9);
}
