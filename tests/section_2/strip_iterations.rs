//! Section 2 on a strip: inner iterations of every step stay bounded over levels, numbers of gaps, cones and
//! kinds.

use signorini::cone::Cone;
use signorini::problems::StripData;
use signorini::strip::{EdgeSolution, LateralCondition, Reference, StripKind, StripProblem};

/// Required of every step on every level.
const BOUND: usize = 30;

/// The most inner iterations of a step.
fn worst(name: &str, levels: &[EdgeSolution]) -> usize {
    assert!(levels.iter().all(|level| level.kkt.worst() < 1e-10), "{name}");
    levels.iter().flat_map(|level| &level.inner_iterations).copied().max().unwrap_or(0)
}

#[test]
fn inner_iterations_are_bounded_over_levels_gap_counts_cones_and_kinds() {
    for (kind, finest) in [(StripKind::Scalar, 14), (StripKind::Elastic, 12)] {
        for name in [
            "transition",
            "transitions:4",
            "transitions:64",
            "transitions:1024",
            "cantor:0.3",
            "fat-cantor:9",
        ] {
            let data: StripData = name.parse().unwrap();
            let sides = if kind == StripKind::Elastic {
                LateralCondition::Periodic
            } else {
                LateralCondition::Natural
            };
            let data = data.data(1.75, 32 << finest, sides).unwrap();
            let problem = StripProblem::new(kind, &data, Reference::Nested, 8).unwrap();
            for cone in Cone::ALL {
                let most = worst(name, &problem.solutions(cone, 8, 1 << finest).unwrap());
                assert!(most <= BOUND, "{kind} {cone} {name}: {most}");
            }
        }
    }
}
