//! Section 2 on a strip: random loads against a dense solver, extreme data, bad input.

use crate::common::SplitMix;
use faer::Mat;
use signorini::Error;
use signorini::ToolkitError;
use signorini::cone::{Cone, Ends};
use signorini::fem::Lame;
use signorini::problems::StripData;
use signorini::strip::{EdgeData, EdgeOperator, LateralCondition, Reference, Strip, StripKind, StripProblem};

#[path = "../../examples/section_2_strip.rs"]
#[allow(dead_code)]
mod example;

/// KKT figures of a solution that counts as solved.
const KKT: f64 = 1e-10;
/// Relative residual asked of the contact iteration.
const SOLVED: f64 = 1e-13;
/// J by two computations: second order in the residual, so rounding times the condition of a few hundred unknowns.
const ENERGY: f64 = 1e-10;

fn dense(operator: &EdgeOperator) -> Mat<f64> {
    let n = operator.nodes();
    let columns: Vec<Vec<f64>> = (0..n)
        .map(|j| {
            let mut unit = vec![0.0; n];
            unit[j] = 1.0;
            operator.apply(&unit).unwrap()
        })
        .collect();
    Mat::from_fn(n, n, |i, j| 0.5 * (columns[j][i] + columns[i][j]))
}

fn solve(operator: &EdgeOperator, force: Vec<f64>, cone: Cone) -> signorini::strip::EdgeSolution {
    operator.solve_contact(&force, cone, None, SOLVED).unwrap()
}

/// A rough load, its mean, and how often it is smoothed.
fn random_load(random: &mut SplitMix, count: usize) -> Vec<f64> {
    let raw: Vec<f64> = (0..count).map(|_| random.between(-1.0, 1.0)).collect();
    let mean = random.between(-0.3, 0.3);
    smoothed(&raw, mean, random.below(8))
}

#[test]
fn random_loads_have_the_energy_of_the_dense_solver() {
    let mut random = SplitMix::new(32);
    let strip = Strip::scalar(32, 32).unwrap();
    let matrix = dense(strip.operator());
    for _ in 0..200 {
        let force = random_load(&mut random, 33);
        for cone in Cone::ALL {
            let solution = solve(strip.operator(), force.clone(), cone);
            assert!(solution.status.is_converged(), "{cone}: {}", solution.status);
            assert!(solution.kkt.worst() < KKT, "{cone}: {:?}", solution.kkt);
            // The conditions of the dense problem, which has one solution.
            let (w, chain) = (&solution.values, cone.on(33, Ends::Open));
            let product: Vec<f64> =
                (0..33).map(|i| (0..33).map(|j| matrix[(i, j)] * w[j]).sum::<f64>()).collect();
            let energy = (0..33).map(|i| (0.5 * product[i] - force[i]) * w[i]).sum::<f64>();
            assert!(
                (solution.energy - energy).abs() <= ENERGY * energy.abs(),
                "{} {energy}",
                solution.energy
            );
            let size = |values: &[f64]| values.iter().fold(0.0f64, |m, v| m.max(v.abs()));
            let (forces, held) =
                (size(&force) + size(&product), chain.apply_transposed(&solution.multiplier).unwrap());
            assert!((0..33).all(|i| (product[i] + held[i] - force[i]).abs() <= KKT * forces), "{cone}");
            for (i, gap) in chain.apply(w).into_iter().enumerate() {
                let multiplier = solution.multiplier[i];
                assert!(
                    multiplier >= -KKT * forces && gap <= KKT * size(w),
                    "{cone} {i}: {multiplier} {gap}"
                );
                assert!(multiplier == 0.0 || gap.abs() <= KKT * size(w), "{cone} {i}: {multiplier} {gap}");
            }
        }
    }
}

#[test]
fn random_loads_are_solved_on_the_ring() {
    let mut random = SplitMix::new(256);
    let strip = Strip::elastic(256, 256, Lame::new(1.0, 1.0).unwrap()).unwrap();
    for _ in 0..200 {
        let force = random_load(&mut random, 256);
        for cone in Cone::ALL {
            let solution = solve(strip.operator(), force.clone(), cone);
            assert!(solution.status.is_converged(), "{cone}: {}", solution.status);
            assert!(solution.kkt.worst() < KKT, "{cone}: {:?}", solution.kkt);
        }
    }
}

fn smoothed(raw: &[f64], mean: f64, times: usize) -> Vec<f64> {
    let n = raw.len();
    let mut force = raw.to_vec();
    for _ in 0..times {
        force =
            (0..n).map(|i| 0.25 * (force[(i + n - 1) % n] + 2.0 * force[i] + force[(i + 1) % n])).collect();
    }
    force.iter().map(|f| f + mean).collect()
}

#[test]
fn scaling_the_load_scales_the_answer() {
    let strip = Strip::scalar(64, 64).unwrap();
    let force: Vec<f64> = (0..65).map(|i| (0.2 * i as f64).cos() + 0.1).collect();
    for cone in Cone::ALL {
        let one = solve(strip.operator(), force.clone(), cone);
        for scale in [1e-150, 1e150] {
            let other = solve(strip.operator(), force.iter().map(|f| f * scale).collect(), cone);
            assert_eq!(one.contact, other.contact);
            let size = one.values.iter().fold(0.0f64, |m, v| m.max(v.abs()));
            for (a, b) in one.values.iter().zip(&other.values) {
                assert!((a - b / scale).abs() <= 1e-12 * size);
            }
        }
        let huge: Vec<f64> = force.iter().map(|f| f * 1e300).collect();
        let refused = strip.operator().solve_contact(&huge, cone, None, SOLVED);
        assert!(matches!(refused, Err(Error::Toolkit(ToolkitError::NotFinite { name: "energy", .. }))));
    }
}

#[test]
fn no_contact_and_full_contact() {
    let scalar = Strip::scalar(16, 16).unwrap();
    let elastic = Strip::elastic(16, 16, Lame::new(1.0, 1.0).unwrap()).unwrap();
    for operator in [scalar.operator(), elastic.operator()] {
        for cone in Cone::ALL {
            let weights =
                |sign: f64| (0..operator.nodes()).map(|i| sign * operator.weight(i)).collect::<Vec<_>>();
            let free = solve(operator, weights(-1.0), cone);
            assert!(free.status.is_converged() && free.contact.count() == 0);
            let closed = solve(operator, weights(1.0), cone);
            assert!(closed.status.is_converged(), "{cone} {}", closed.status);
            assert_eq!(closed.contact.count(), closed.contact.constraints(), "{cone}");
            assert!(closed.values.iter().all(|v| v.abs() < 1e-12) && closed.kkt.worst() < 1e-12);
            let nothing = solve(operator, vec![0.0; operator.nodes()], cone);
            assert!(nothing.status.is_converged() && nothing.energy == 0.0);
        }
    }
    let smallest = Strip::scalar(2, 1).unwrap();
    assert!(solve(smallest.operator(), vec![1.0, -1.0, 0.5], Cone::Midpoint).kkt.worst() < 1e-12);
}

fn refused<T: std::fmt::Debug, E: std::fmt::Display + std::fmt::Debug>(
    outcome: std::result::Result<T, E>,
    words: &str,
) {
    let text = outcome.unwrap_err().to_string();
    assert!(text.contains(words), "'{text}' does not say '{words}'");
}

#[test]
fn bad_scenes_are_named() {
    let build = |kind: StripData, tau| kind.data(tau, 64, LateralCondition::Natural);
    let transition = StripData::Transition { position: 0.4 };
    for tau in [1.5, 2.6, f64::NAN, -1.0] {
        refused(build(transition.clone(), tau), "tau");
    }
    refused(build(StripData::Cantor { ratio: 0.3, depth: 3 }, 2.1), "tau");
    refused(build(transition.clone(), 2.1), "tau");
    refused(build(StripData::FatCantor { depth: 5 }, 2.0), "fat Cantor");
    refused(build(StripData::FatCantor { depth: 0 }, 1.75), "depth");
    refused(build(StripData::Cantor { ratio: 0.5, depth: 3 }, 1.75), "ratio");
    refused(build(StripData::Transition { position: 1.0 }, 1.75), "position");
    refused(build(StripData::Transitions { gaps: 64 }, 1.75), "gaps");
    refused(EdgeData::new(2, LateralCondition::Natural, vec![-1.0; 3], vec![0.0; 3]), "empty");
    refused(
        EdgeData::new(2, LateralCondition::Natural, vec![0.0, -1.0, 0.0], vec![0.0, 1.0, 0.0]),
        "both nonzero",
    );
    refused(EdgeData::new(2, LateralCondition::Natural, vec![0.0, 1.0, 0.0], vec![0.0; 3]), "u_N");
    refused(
        EdgeData::new(2, LateralCondition::Natural, vec![0.0, -1.0, 0.0], vec![-1.0, 0.0, 0.0]),
        "lambda",
    );
    refused(
        EdgeData::new(2, LateralCondition::Natural, vec![0.0, f64::NAN, 0.0], vec![0.0; 3]),
        "not finite",
    );
    refused(EdgeData::new(4, LateralCondition::Natural, vec![0.0; 4], vec![0.0; 4]), "length");
    let odd = EdgeData::new(6, LateralCondition::Natural, vec![0.0; 7], vec![0.0; 7]).unwrap();
    let scalar = |data| StripProblem::new(StripKind::Scalar, data, Reference::Nested, 2);
    refused(scalar(&odd), "powers of two");
    let ring = EdgeData::new(8, LateralCondition::Periodic, vec![0.0; 8], vec![0.0; 8]).unwrap();
    refused(scalar(&ring), "sides");
    let flat = EdgeData::new(8, LateralCondition::Natural, vec![0.0; 9], vec![0.0; 9]).unwrap();
    let exact = scalar(&flat).unwrap();
    refused(exact.load(16), "cells");
    refused(exact.load(3), "cells");
    refused(exact.error(4, &[0.0; 4]), "length");
}

#[test]
fn samples_are_read_or_refused_by_line() {
    let good = "# u_N lambda\n0 1\n0, 0.5\n-0.1 0\n-0.2 0 # open\n-0.1 0\n";
    let scene = EdgeData::from_samples(good, LateralCondition::Natural).unwrap();
    assert_eq!((scene.cells(), scene.gaps(), scene.regularity()), (4, 1, None));
    assert_eq!(scene.forces(), [0.125, 0.125, 0.0, 0.0, 0.0]);
    refused(EdgeData::from_samples("0 1\n0\n0 0\n", LateralCondition::Natural), "line 2");
    refused(EdgeData::from_samples("0 1\n0 0 0\n0 0\n", LateralCondition::Natural), "line 2");
    refused(EdgeData::from_samples("0 1\n0 0\nx 0\n", LateralCondition::Natural), "line 3");
    refused(EdgeData::from_samples("0 1\n0 0\n", LateralCondition::Natural), "lines of samples");
    refused(EdgeData::from_samples("", LateralCondition::Periodic), "lines of samples");
    refused(EdgeData::from_samples("0 1\n-1 1\n0 0\n", LateralCondition::Natural), "both nonzero");
    refused(EdgeData::from_samples("0 inf\n0 0\n0 0\n", LateralCondition::Natural), "not finite");
}

fn run(
    problem: &str,
    tau: f64,
    kind: StripKind,
    cone: Cone,
) -> example_report::Result<example_report::Outcome> {
    let problem = vec![problem.parse()?];
    example::outcome(&example::Options { problem, tau, finest: 9, cone, kind })
}

#[test]
fn example_runs_and_refuses() {
    use StripKind::{Elastic, Scalar};
    for (problem, tau, kind, cone) in [
        ("transitions:1", 1.75, Elastic, Cone::Midpoint),
        ("cantor", 1.75, Scalar, Cone::Nodal),
        ("fat-cantor:6", 1.75, Elastic, Cone::Nodal),
        ("transitions:2", 2.0, Scalar, Cone::Midpoint),
        ("transition:0.3", 1.6, Scalar, Cone::Nodal),
    ] {
        let found = run(problem, tau, kind, cone).unwrap();
        let text = found.text(false);
        for key in ["largest-scaled-kkt-residual", "inner-iterations-of-a-step"] {
            assert_eq!(found.check(key).unwrap().decision(), example_report::Decision::Holds, "{text}");
        }
        assert!(found.numbers("error").windows(2).all(|pair| pair[1] > 0.0 && pair[1] < pair[0]), "{text}");
    }
    for count in ["0", "100000000", "4611686018427387904", "18446744073709551615"] {
        refused(run(&format!("transitions:{count}"), 1.75, Scalar, Cone::Nodal), "gaps");
    }
    for problem in ["cantor:0.3:65", "cantor:0.3:18446744073709551615", "fat-cantor:65", "fat-cantor:0"] {
        refused(run(problem, 1.75, Scalar, Cone::Nodal), "depth");
    }
    // Sets whose gaps have no node on the grid: nothing to converge to, no order that is not a number.
    refused(run("cantor:0.499999999", 1.75, Scalar, Cone::Nodal), "gaps");
    refused(run("fat-cantor", 1.9999, Scalar, Cone::Nodal), "gaps");
    refused(run("samples:/nowhere/at-all", 1.75, Scalar, Cone::Nodal), "/nowhere/at-all");
    assert!("samples:".parse::<StripData>().is_err());
}

#[test]
fn samples_run_without_a_regularity() {
    let path = std::env::temp_dir().join(format!("signorini-samples-{}", std::process::id()));
    let rows: String = (0..=512)
        .map(|i| if i < 200 { "0 1\n".to_owned() } else { format!("{} 0\n", -(f64::from(i - 199) / 512.0)) })
        .collect();
    std::fs::write(&path, rows).unwrap();
    let problem = format!("samples:{}", path.display());
    let found = run(&problem, 1.75, StripKind::Scalar, Cone::Nodal).unwrap();
    assert!(found.checks().iter().all(|check| !check.claim().contains("order")), "{}", found.text(false));
    std::fs::write(&path, "0 0\n".repeat(33)).unwrap();
    refused(run(&problem, 1.75, StripKind::Scalar, Cone::Nodal), "");
    std::fs::remove_file(&path).unwrap();
}
