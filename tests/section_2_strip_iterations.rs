//! Section 2 on a strip: inner iterations of every step stay bounded over levels, numbers of gaps, cones and
//! kinds.

use experiments::convergence::{CaseStudy, Level, Levels, StripCase, strip_levels};
use signorini::cone::Cone;
use signorini::problems::StripData;
use signorini::strip::{LateralCondition, Reference, StripKind, StripProblem};

/// Required of every step on every level.
const BOUND: usize = 30;

/// The most inner iterations of a step, printed with the gaps resolved on each level.
fn worst(name: &str, levels: &[Level]) -> usize {
    let most = |level: &Level| level.facts.most_inner();
    let rows: Vec<String> = levels
        .iter()
        .map(|level| {
            format!("2^{}: {} runs, {}", level.facts.cells.ilog2(), level.facts.contact_runs, most(level))
        })
        .collect();
    println!("{name}: {}", rows.join("; "));
    assert!(levels.iter().all(|level| level.facts.status.is_converged()), "{name}");
    levels.iter().map(most).max().unwrap_or(0)
}

#[test]
fn inner_iterations_are_bounded_over_levels_gap_counts_cones_and_kinds() {
    for kind in [StripKind::Scalar, StripKind::Elastic] {
        let finest = if kind == StripKind::Scalar { 14 } else { 12 };
        for cone in Cone::ALL {
            for scene in [
                "transition",
                "transitions:4",
                "transitions:64",
                "transitions:1024",
                "cantor:0.3",
                "fat-cantor:9",
            ] {
                let case = StripCase {
                    kind,
                    levels: Levels::new(3, finest).unwrap(),
                    source: scene.parse().unwrap(),
                    tau: 1.75,
                    cone,
                    reference: Reference::Nested,
                    positions: 1,
                };
                let study = CaseStudy::of(&case, |_| {}).unwrap();
                let most =
                    worst(&format!("{kind} {cone} {scene} ({})", study.gaps_text()), &study.studies[0]);
                assert!(most <= BOUND, "{kind} {cone} {scene}: {most}");
            }
        }
    }
}

#[test]
fn a_fat_cantor_set_of_over_thirty_thousand_gaps_needs_no_more() {
    // The set lives on 2^22 cells; levels to 2^16 resolve the gaps of two of their cells or more.
    let scene = StripData::FatCantor { depth: 15 }.data(1.55, 1 << 22, LateralCondition::Natural).unwrap();
    assert!(scene.gaps() > 30_000, "{}", scene.gaps());
    let problem = StripProblem::new(StripKind::Scalar, &scene, Reference::Nested, 8).unwrap();
    for cone in Cone::ALL {
        let levels = strip_levels(&problem, Levels::new(3, 16).unwrap(), cone, |_| {}).unwrap();
        let most = worst(&format!("{cone} fat Cantor, {} gaps", scene.gaps()), &levels);
        assert!(most <= BOUND, "{cone}: {most}");
        assert!(levels[levels.len() - 1].facts.contact_runs > 1000);
    }
}
