//! Theorems 3.1 and 4.1, both cones: orders of error and consistency term, with bounds from both sides.

use crate::program::outcome;
use signorini::Result;
use signorini::cone::Cone;
use signorini::edge::consistency_terms;
use signorini::problems::{StripData, TransitionPowers};
use signorini::rates::Bound;
use signorini::strip::{EdgeData, LateralCondition, Reference, StripKind, StripProblem};

/// The window of h is finite: orders of known solutions come out this close to τ − 1.
const ORDER: f64 = 0.02;
/// The term has one value per position of a transition; few of them are averaged.
const TERM: f64 = 0.03;

/// Order and slope of the error, and slope of the root of the consistency term, as root mean squares over some data, h =
/// 2^-from to 2^-to; the data on a grid 16 times finer. The problem of some data is set up once for both cones.
fn orders(kind: StripKind, data: &[EdgeData], (from, to): (u32, u32)) -> [(Cone, [f64; 3]); 2] {
    let mut squares = Cone::ALL.map(|cone| (cone, vec![[0.0; 2]; (to - from + 1) as usize]));
    for data in data {
        let problem = StripProblem::new(kind, data, Reference::Nested, 1 << from).unwrap();
        for (cone, squares) in &mut squares {
            let terms = consistency_terms(data, *cone);
            for (found, square) in
                problem.solutions(*cone, 1 << from, 1 << to).unwrap().iter().zip(squares)
            {
                let n = found.cells;
                assert!(found.kkt.worst() < 1e-10, "{n}: {:?}", found.kkt);
                let term = terms.iter().find(|term| term.0 == n).unwrap().1;
                square[0] += problem.error(found).unwrap().value.powi(2);
                square[1] += term;
            }
        }
    }
    squares.map(|(cone, squares)| {
        let points = |k: usize| -> Vec<(f64, f64)> {
            let root =
                |(level, square): (u32, &[f64; 2])| (0.5f64.powi(level as i32), square[k].sqrt());
            (from..=to).zip(&squares).map(root).collect()
        };
        (cone, [order(&points(0)), slope(&points(0)), slope(&points(1))])
    })
}

/// The p of the best e² = A h^(2p) + B h², least squares of the relative deviations: for each p a linear problem for A and
/// B, p by steps of 1e-4. Independent of the reading of the examples, which takes differences of the last meshes.
fn order(points: &[(f64, f64)]) -> f64 {
    let deviation = |p: f64| {
        let columns = points.iter().map(|(h, e)| [h.powf(2.0 * p) / (e * e), h * h / (e * e)]);
        let [mut aa, mut ab, mut bb, mut a, mut b] = [0.0; 5];
        for [x, y] in columns {
            (aa, ab, bb, a, b) = (aa + x * x, ab + x * y, bb + y * y, a + x, b + y);
        }
        // Σ (1 − A x − B y)² at its least: the count less the part that is explained.
        -(bb * a * a - 2.0 * ab * a * b + aa * b * b) / (aa * bb - ab * ab)
    };
    let places = (3000..9990).map(|k| 1e-4 * f64::from(k));
    places.min_by(|p, q| deviation(*p).total_cmp(&deviation(*q))).unwrap()
}

/// Regression of ln q against ln h over the finer half of the meshes: the term is a power of h alone.
fn slope(points: &[(f64, f64)]) -> f64 {
    let finer: Vec<(f64, f64)> =
        points[points.len() / 2..].iter().map(|(h, q)| (h.ln(), q.ln())).collect();
    let mean = |of: fn(&(f64, f64)) -> f64| finer.iter().map(of).sum::<f64>() / finer.len() as f64;
    let (x, y) = (mean(|point| point.0), mean(|point| point.1));
    let product: f64 = finer.iter().map(|point| (point.0 - x) * (point.1 - y)).sum();
    product / finer.iter().map(|point| (point.0 - x).powi(2)).sum::<f64>()
}

fn check(kind: StripKind, levels: (u32, u32), data: impl Fn(f64, usize) -> Result<Vec<EdgeData>>) {
    let taus = [1.55, 1.65, 1.75, 1.85, 1.95];
    for tau in taus {
        for (cone, [error, _, term]) in orders(kind, &data(tau, 16 << levels.1).unwrap(), levels) {
            let name = format!("{kind} {cone} tau {tau}: error {error}, term {term}");
            let off = [error, term].map(|order| (order - (tau - 1.0)).abs());
            assert!(off[0] < ORDER && off[1] < TERM, "{name}");
            let printed = Bound::Paper.exponent(tau).unwrap();
            assert!(error >= printed && term + TERM >= printed, "{name}");
        }
    }
}

#[test]
fn single_transitions_have_order_tau_minus_one() {
    let place = |k: u32| 0.381966 + f64::from(k) / 56.0;
    check(StripKind::Scalar, (3, 12), |tau, cells| {
        (0..7).map(|k| TransitionPowers::of_regularity(tau).data(place(k), cells)).collect()
    });
    check(StripKind::Elastic, (3, 12), |tau, cells| {
        let data = |k| {
            StripData::Transition { position: place(k) }.data(
                tau,
                cells,
                LateralCondition::Periodic,
            )
        };
        (0..7).map(data).collect()
    });
}

#[test]
fn many_transitions_have_order_tau_minus_one() {
    check(StripKind::Scalar, (6, 14), |tau, cells| {
        Ok(vec![StripData::Transitions { gaps: 11 }.data(tau, cells, LateralCondition::Natural)?])
    });
}

/// Beyond τ = 2 the error has order one, to which it creeps up, and the root of the term the order τ − 1.
#[test]
fn smooth_transitions_have_order_one() {
    for tau in [2.1, 2.25, 2.4] {
        let place = |k: u32| {
            TransitionPowers::of_regularity(tau).data(0.381966 + f64::from(k) / 56.0, 16 << 12)
        };
        let data = (0..7).map(place).collect::<Result<Vec<_>>>().unwrap();
        for (cone, [_, error, term]) in orders(StripKind::Scalar, &data, (3, 12)) {
            assert!(error > 0.9 && error < 1.0 + ORDER, "{cone} {tau}: {error}");
            assert!((term - (tau - 1.0)).abs() < TERM, "{cone} {tau}: {term}");
        }
    }
}

/// Corners on triangulations, h from 1/4 to 1/256.
#[test]
fn corners_have_the_order_of_their_opening() {
    for cone in ["nodal", "midpoint"] {
        let arguments = ["--problem=corner", "--tau=1.6,1.75,1.9", "--cone", cone];
        let (_, found) = outcome("theorem_3_1_bodies", &arguments);
        for tau in [1.6, 1.75, 1.9] {
            let order = found["values"][format!("order.problemcorner.tau{tau}")].as_f64().unwrap();
            assert!((order - (tau - 1.0)).abs() < 0.05, "{cone} {tau}: {order}");
        }
    }
}
