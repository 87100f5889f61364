//! Theorem 3.1, its proof: (3.3)-(3.15) on computed pairs, each side by itself, and the ladder of bounds.

use experiments::convergence::Levels;
use experiments::proof::{ProofCase, Resolution};
use signorini::edge::{ContactPair, EdgeTrace, Interval, Traces};
use signorini::problems::StripData;
use signorini::proof::{Alternative, ProofConstants, Section, Step, ThetaRule};
use signorini::strip::{EdgeData, LateralCondition};

mod proof_cases;
#[allow(dead_code)]
#[path = "../examples/theorem_3_1_proof_profile.rs"]
mod theorem_3_1_proof_profile;

use proof_cases::{RUNG, all_cases};

const SECTION: Section = Section::Three;

#[test]
fn every_inequality_holds_on_more_than_two_hundred_cases() {
    let (cases, checks) = all_cases(SECTION, &[1.55, 1.65, 1.75, 1.9, 2.0]);
    println!("{cases} cases, {checks} inequalities");
    assert!(cases >= 200 && checks > 10_000, "{cases} cases, {checks} inequalities");
}

#[test]
fn the_losses_add_up_to_the_distance_from_the_printed_exponent() {
    let case = ProofCase::standard(SECTION).unwrap();
    let constants = case.constants(2.0).unwrap();
    assert!(case.levels.cells().count() >= 8);
    let profile = case.profile(&constants).unwrap();
    let ladder = profile.ladder().unwrap();
    let losses: f64 = ladder.iter().filter_map(|rung| rung.loss).map(|loss| loss.order).sum();
    let uncertainty: f64 = ladder.iter().filter_map(|rung| rung.loss).map(|loss| loss.uncertainty).sum();
    let distance = ladder[0].exponent.order - profile.printed_exponent();
    println!("losses {losses:.4}, distance {distance:.4}, uncertainties together {uncertainty:.4}");
    assert!((losses - distance).abs() <= uncertainty.min(1e-6), "{losses} and {distance}");
    // One transition: the term falls like h^(2 tau - 2), within the scatter of its position in the cell.
    assert!((ladder[0].exponent.order - 1.5).abs() < 0.05, "{:?}", ladder[0].exponent);
    // The eighth lost in the square is lost where the zone is taken as short as h_e theta: (2 tau - 3)(2 -
    // tau).
    let zone = ladder[4].loss.unwrap();
    let law = ladder[5].loss.unwrap();
    let together = zone.uncertainty + law.uncertainty;
    assert!((zone.order + law.order - 0.125).abs() <= together, "{zone:?} {law:?}");
}

#[test]
fn the_corrected_law_gives_the_square_root_of_the_logarithm() {
    let case = ProofCase {
        tau: 2.0,
        scene_tau: 2.0,
        rule: ThetaRule::Printed { tau: 2.0 },
        levels: Levels::new(3, 10).unwrap(),
        positions: 1,
        ..ProofCase::standard(SECTION).unwrap()
    };
    let profile = case.profile(&case.constants(2.0).unwrap()).unwrap();
    // Before the sum over the edge: the second case with its law over h^2 ln(1/h), over h^2 sqrt(ln(1/h)).
    let quotients: Vec<[f64; 2]> = profile
        .levels
        .iter()
        .map(|l| {
            let log = -l.h().ln();
            let (law, before) = (l.rung(Step::Law), l.rung(Step::ShortestZone).printed);
            [law.printed / before / log.sqrt(), law.corrected / before]
        })
        .collect();
    // gamma_theta ~ sqrt(ln(1/theta)): both quotients stay within a factor of their first value.
    for quotient in &quotients {
        for column in 0..2 {
            let ratio = quotient[column] / quotients[0][column];
            assert!((0.5..2.0).contains(&ratio), "{quotients:?}");
        }
        assert!(quotient[1] >= 1.0 - RUNG);
    }
}

#[test]
fn cases_of_pairs_are_those_of_traces() {
    for (source, tau) in
        [("transition:0.3", 1.75), ("transitions:7", 1.6), ("fat-cantor:6", 1.8), ("cantor:0.3", 1.9)]
    {
        let scene =
            source.parse::<StripData>().unwrap().data(tau, 1 << 12, LateralCondition::Natural).unwrap();
        let trace = EdgeTrace::of_data(&scene).unwrap();
        let pair = ContactPair::of_data(&scene, Traces::Constants).unwrap();
        let n = 64;
        let all = pair.norms(n, 0.2, 2.0).unwrap();
        for theta in [0.4, 0.11, 0.03] {
            for (i, norms) in all.iter().enumerate() {
                let reach = norms.length * theta;
                let first = norms.zero_distance.is_some_and(|d| d.iter().all(|&d| d < reach));
                let interval = Interval { start: i as f64 / n as f64, end: (i + 1) as f64 / n as f64 };
                let found = Alternative::on_segment(Section::Three, &trace, interval, theta).unwrap();
                assert_eq!(found.first(), first, "{source} theta {theta} segment {i}");
                assert!(first || norms.free_length >= reach, "{source} theta {theta} segment {i}");
                assert!(norms.nodal_term >= 0.0 && norms.midpoint_term >= -1e-12 * norms.force * norms.depth);
            }
        }
    }
}

#[test]
fn degenerate_pairs_have_finite_norms_and_no_violation() {
    let cells = 64;
    let touching: [(&str, &dyn Fn(usize) -> bool); 5] = [
        ("full contact", &|_| true),
        ("one contact point", &|i| i == 21),
        ("contact up to a vertex", &|i| i <= 32),
        ("contact on one segment", &|i| (16..=32).contains(&i)),
        ("contact at both ends", &|i| i <= 2 || i >= 62),
    ];
    let known = [1.75, 2.0].map(|tau| {
        let constants = ProofConstants::new(tau, 2.0, &[0.25]).unwrap();
        let gamma = constants.gamma(0.25).unwrap();
        (constants, gamma)
    });
    for (name, touches) in touching {
        let values = (0..=cells).map(|i| if touches(i) { 0.0 } else { -1.0 }).collect();
        // A force needs a contact cell beside its node.
        let carried = |i: usize| touches(i) && ((i > 0 && touches(i - 1)) || (i < cells && touches(i + 1)));
        let forces = (0..=cells).map(|i| if carried(i) { 1.0 } else { 0.0 }).collect();
        let scene = EdgeData::new(cells, LateralCondition::Natural, values, forces).unwrap();
        for tau in [1.75, 2.0] {
            let (constants, gamma) = &known[usize::from(tau == 2.0)];
            let traces = Traces::for_regularity(tau);
            let pair = ContactPair::of_data(&scene, traces).unwrap();
            for norms in pair.norms(4, constants.order(), constants.q()).unwrap() {
                assert!(
                    norms.displacement_norm_squared().is_finite() && norms.stress.norm_squared().is_finite()
                );
                let setting = signorini::proof::SegmentSetting {
                    theta: 0.25,
                    gamma: *gamma,
                    own_gamma: 0.0,
                    law: constants.law(0.25),
                };
                for check in signorini::proof::segment_checks(Section::Three, &norms, constants, &setting) {
                    assert!(check.holds(), "{name} tau {tau}: {check:?}");
                }
                for check in signorini::proof::segment_checks(Section::Four, &norms, constants, &setting) {
                    assert!(check.holds(), "{name} tau {tau}: {check:?}");
                }
            }
        }
    }
    // A force on an isolated contact point is no density.
    let values = (0..=8).map(|i| if i == 4 { 0.0 } else { -1.0 }).collect();
    let forces = (0..=8).map(|i| if i == 4 { 1.0 } else { 0.0 }).collect();
    let scene = EdgeData::new(8, LateralCondition::Natural, values, forces).unwrap();
    assert!(ContactPair::of_data(&scene, Traces::Constants).is_err());
}

#[test]
fn bad_profiles_are_refused() {
    let standard = || ProofCase::standard(SECTION).unwrap();
    let constants = ProofConstants::new(1.75, 2.0, &[]).unwrap();
    for case in [
        ProofCase { tau: 1.8, ..standard() },
        ProofCase { tau: 2.2, ..standard() },
        ProofCase { positions: 0, ..standard() },
        ProofCase { resolution: Resolution::Edge(11), ..standard() },
        ProofCase { resolution: Resolution::Segment(16), ..standard() },
        ProofCase { rule: ThetaRule::Fixed(1.5), ..standard() },
    ] {
        assert!(case.profile(&constants).is_err(), "{case:?}");
    }
    assert!(ProofConstants::new(1.5, 2.0, &[]).is_err() && ProofConstants::new(2.0, 1.0, &[]).is_err());
    assert!("edge".parse::<Resolution>().is_err() && "segment:0".parse::<Resolution>().is_err());
}

#[test]
fn the_example_finds_no_violation() {
    let headline = theorem_3_1_proof_profile::run(&theorem_3_1_proof_profile::Options::default()).unwrap();
    assert!(headline.verdict().is_confirmed(), "{}", headline.verdict());
    let value = |key: &str| headline.values.iter().find(|(k, _)| k == key).unwrap().1;
    assert_eq!(value("theorem.3.1.proof.violations"), 0.0);
    assert_eq!(value("theorem.3.1.proof.printed"), 1.375);
    assert!((value("theorem.3.1.proof.edge.exponent") - 1.375).abs() < 1e-9);
}
