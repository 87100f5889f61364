//! Section 2 on a strip: random loads against a dense solver, extreme data, bad input.

use crate::common::SplitMix;
use faer::Mat;
use signorini::cone::{Cone, Ends};
use signorini::fem::Lame;
use signorini::problems::StripData;
use signorini::strip::{
    EdgeData, EdgeOperator, LateralCondition, Reference, Strip, StripKind, StripProblem,
};

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
            let (forces, held) = (
                size(&force) + size(&product),
                chain.apply_transposed(&solution.multiplier).unwrap(),
            );
            assert!(
                (0..33).all(|i| (product[i] + held[i] - force[i]).abs() <= KKT * forces),
                "{cone}"
            );
            for (i, gap) in chain.apply(w).into_iter().enumerate() {
                let multiplier = solution.multiplier[i];
                assert!(
                    multiplier >= -KKT * forces && gap <= KKT * size(w),
                    "{cone} {i}: {multiplier} {gap}"
                );
                assert!(
                    multiplier == 0.0 || gap.abs() <= KKT * size(w),
                    "{cone} {i}: {multiplier} {gap}"
                );
            }
        }
    }
}

fn smoothed(raw: &[f64], mean: f64, times: usize) -> Vec<f64> {
    let n = raw.len();
    let mut force = raw.to_vec();
    for _ in 0..times {
        force = (0..n)
            .map(|i| 0.25 * (force[(i + n - 1) % n] + 2.0 * force[i] + force[(i + 1) % n]))
            .collect();
    }
    force.iter().map(|f| f + mean).collect()
}

#[test]
fn no_contact_and_full_contact() {
    let scalar = Strip::scalar(16, 16).unwrap();
    let elastic = Strip::elastic(16, 16, Lame::new(1.0, 1.0).unwrap()).unwrap();
    for operator in [scalar.operator(), elastic.operator()] {
        for cone in Cone::ALL {
            let weights = |sign: f64| {
                (0..operator.nodes()).map(|i| sign * operator.weight(i)).collect::<Vec<_>>()
            };
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
    for (scene, tau, words) in [
        (StripData::Cantor { ratio: 0.3, depth: 3 }, 2.1, "tau"),
        (transition, 2.1, "tau"),
        (StripData::FatCantor { depth: 5 }, 2.0, "fat Cantor"),
        (StripData::FatCantor { depth: 0 }, 1.75, "depth"),
        (StripData::Cantor { ratio: 0.5, depth: 3 }, 1.75, "ratio"),
        (StripData::Transition { position: 1.0 }, 1.75, "position"),
        (StripData::Transitions { gaps: 64 }, 1.75, "non-contact intervals"),
    ] {
        refused(build(scene, tau), words);
    }
    for (values, forces, words) in [
        ([-1.0; 3], [0.0; 3], "empty"),
        ([0.0, -1.0, 0.0], [0.0, 1.0, 0.0], "both nonzero"),
        ([0.0, 1.0, 0.0], [0.0; 3], "u_N"),
        ([0.0, -1.0, 0.0], [-1.0, 0.0, 0.0], "lambda"),
        ([0.0, f64::NAN, 0.0], [0.0; 3], "not finite"),
    ] {
        refused(EdgeData::new(2, LateralCondition::Natural, &values, &forces), words);
    }
    refused(EdgeData::new(4, LateralCondition::Natural, &[0.0; 4], &[0.0; 4]), "length");
    let odd = EdgeData::new(6, LateralCondition::Natural, &[0.0; 7], &[0.0; 7]).unwrap();
    let scalar = |data| StripProblem::new(StripKind::Scalar, data, Reference::Nested, 2);
    refused(scalar(&odd), "{2, 4, 8, 16, ...}");
    let ring = EdgeData::new(8, LateralCondition::Periodic, &[0.0; 8], &[0.0; 8]).unwrap();
    refused(scalar(&ring), "lateral condition");
    let flat = EdgeData::new(8, LateralCondition::Natural, &[0.0; 9], &[0.0; 9]).unwrap();
    let exact = scalar(&flat).unwrap();
    refused(exact.load(16), "cells");
    refused(exact.load(3), "cells");
    refused(exact.distance(4, &[0.0; 4]), "length");
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
