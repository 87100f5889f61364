//! Theorem 3.1, its proof: (3.3)-(3.15) on computed pairs, each side by itself, and the ladder of bounds.

use signorini::edge::{ContactPair, EdgeTrace, Interval, Traces};
use signorini::problems::StripData;
use signorini::proof::{Alternative, ProofConstants, Section, Step, ThetaRule};
use signorini::strip::{EdgeData, LateralCondition};

#[allow(dead_code)]
#[path = "../../examples/theorem_3_1_proof_profile.rs"]
mod theorem_3_1_proof_profile;

use crate::proof_cases::{RUNG, all_cases, checked, pair};

const SECTION: Section = Section::Three;

#[test]
fn every_inequality_holds_on_more_than_two_hundred_cases() {
    let (cases, checks) = all_cases(SECTION, &[1.55, 1.65, 1.75, 1.9, 2.0]);
    println!("{cases} cases, {checks} inequalities");
    assert!(cases >= 200 && checks > 10_000, "{cases} cases, {checks} inequalities");
}

#[test]
fn the_example_has_the_sides_of_the_library() {
    let constants = ProofConstants::new(1.75, 2.0, &[0.25]).unwrap();
    for problem in ["transition:0.3", "transitions:7", "fat-cantor:6"] {
        for norms in
            pair(&problem.parse().unwrap(), 1.75, 32).norms(32, constants.order(), constants.q()).unwrap()
        {
            let gamma = constants.gamma(0.25).unwrap();
            let setting = signorini::proof::SegmentSetting {
                theta: 0.25,
                gamma,
                own_gamma: gamma,
                law: constants.law(0.25),
            };
            let theirs = signorini::proof::segment_checks(SECTION, &norms, &constants, &setting);
            let (own, _) = theorem_3_1_proof_profile::lines(&norms, &constants, 0.25).unwrap();
            assert_eq!(own.len(), theirs.len(), "{problem}");
            for (name, left, right, _) in own.iter().filter(|line| line.2 > 0.0 && !line.0.contains("Young"))
            {
                let close = |a: f64, b: f64| (a - b).abs() <= 1e-12 * (a.abs() + b.abs());
                let found = theirs.iter().any(|check| {
                    name.starts_with(check.inequality.to_string().split(' ').next().unwrap_or_default())
                        && (close(left / right, check.left / check.right) || check.is_equality)
                });
                assert!(found, "{problem}: {name}: {left} {right} {theirs:?}");
            }
        }
    }
}

#[test]
fn the_corrected_law_gives_the_square_root_of_the_logarithm() {
    let (meshes, problem) = ((3..=10).map(|level| 1usize << level), StripData::transition());
    let theta = |n: usize| ThetaRule::Printed { tau: 2.0 }.theta(1.0 / n as f64).unwrap();
    let constants = ProofConstants::new(2.0, 2.0, &meshes.clone().map(theta).collect::<Vec<f64>>()).unwrap();
    // Before the sum over the edge: the second case with its law over h^2 ln(1/h), over h^2 sqrt(ln(1/h)).
    let quotients: Vec<[f64; 2]> = meshes
        .map(|n| {
            let level = checked(SECTION, &pair(&problem, 2.0, n), n, theta(n), &constants, "transition");
            let log = (n as f64).ln();
            let (law, before) =
                (level.rungs[Step::Law as usize], level.rungs[Step::ShortestZone as usize].printed);
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
fn the_example_finds_no_violation() {
    for tau in [1.55, 1.9] {
        let options = theorem_3_1_proof_profile::Options { tau, ..Default::default() };
        let outcome = theorem_3_1_proof_profile::outcome(&options).unwrap();
        assert!(outcome.status().is_confirmed(), "{}", outcome.text(false));
    }
}
