//! Theorem 4.1, its proof: (4.9)-(4.14) on computed pairs, each side by itself, and the ladder of bounds.

use experiments::convergence::Levels;
use experiments::proof::ProofCase;
use signorini::problems::StripData;
use signorini::proof::Section;

mod proof_cases;
#[allow(dead_code)]
#[path = "../examples/theorem_4_1_proof_profile.rs"]
mod theorem_4_1_proof_profile;

use proof_cases::all_cases;

const SECTION: Section = Section::Four;

#[test]
fn every_inequality_holds_on_more_than_two_hundred_cases() {
    let (cases, checks) = all_cases(SECTION, &[1.55, 1.65, 1.75, 1.9, 2.0]);
    println!("{cases} cases, {checks} inequalities");
    assert!(cases >= 200 && checks > 10_000, "{cases} cases, {checks} inequalities");
}

#[test]
fn above_two_every_segment_with_contact_obeys_4_14() {
    for tau in [2.05, 2.25, 2.45] {
        let case = ProofCase {
            tau,
            scene_tau: tau,
            levels: Levels::new(3, 8).unwrap(),
            ..ProofCase::standard(SECTION).unwrap()
        };
        let constants = case.constants(2.0).unwrap();
        let profile = case.profile(&constants).unwrap();
        assert_eq!(profile.violations(), 0, "tau {tau}");
        let ladder = profile.ladder().unwrap();
        let exponent = ladder[0].exponent;
        // h^(2 + 2 eps) is optimal on one transition.
        assert!((exponent.order - (2.0 * tau - 2.0)).abs() < 0.1, "tau {tau}: {exponent:?}");
        assert!((ladder[6].exponent.order - (2.0 * tau - 2.0)).abs() < 1e-9);
        let rough = ProofCase { source: StripData::Cantor { ratio: 0.3, depth: 5 }, ..case };
        assert!(rough.profile(&constants).is_err(), "only a transition is that smooth");
    }
}

#[test]
fn the_losses_add_up_to_the_distance_from_the_printed_exponent() {
    for source in ["transition", "fat-cantor"] {
        let case = ProofCase {
            source: source.parse::<StripData>().unwrap(),
            ..ProofCase::standard(SECTION).unwrap()
        };
        assert!(case.levels.cells().count() >= 8);
        let constants = case.constants(2.0).unwrap();
        let profile = case.profile(&constants).unwrap();
        let ladder = profile.ladder().unwrap();
        let losses: Vec<_> = ladder.iter().filter_map(|rung| rung.loss).collect();
        let sum: f64 = losses.iter().map(|loss| loss.order).sum();
        let uncertainty: f64 = losses.iter().map(|loss| loss.uncertainty).sum();
        let distance = ladder[0].exponent.order - profile.printed_exponent();
        println!("{source}: losses {sum:.4}, distance {distance:.4}, uncertainties {uncertainty:.4}");
        assert!((sum - distance).abs() <= uncertainty.min(1e-6), "{source}: {sum} and {distance}");
        let (zone, law) = (losses[3], losses[4]);
        let together = zone.uncertainty + law.uncertainty;
        assert!((zone.order + law.order - 0.125).abs() <= together, "{source}: {zone:?} {law:?}");
    }
}

#[test]
fn the_example_finds_no_violation() {
    let headline = theorem_4_1_proof_profile::run(&theorem_4_1_proof_profile::Options::default()).unwrap();
    assert!(headline.verdict().is_confirmed(), "{}", headline.verdict());
    let value = |key: &str| headline.values.iter().find(|(k, _)| k == key).unwrap().1;
    assert_eq!(value("theorem.4.1.proof.violations"), 0.0);
    assert!((value("theorem.4.1.proof.edge.exponent") - 1.375).abs() < 1e-9);
}
