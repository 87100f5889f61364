//! The strip on the scenes of its accuracy tables: product, contact and exact error, over n and cones.
//!
//! `cargo bench --package signorini-benches --bench strip`; the errors that belong to these times are printed by
//! the example `section_2_strip`.

use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};
use signorini::cone::Cone;
use signorini::fem::Lame;
use signorini::problems::StripData;
use signorini::strip::{Reference, Strip, StripKind, StripProblem};
use std::hint::black_box;

const REFERENCE: usize = 1 << 18;

fn problem(kind: StripKind, scene: StripData, tau: f64) -> StripProblem {
    let scene = scene.data(tau, REFERENCE, kind.sides()).expect("the scene exists");
    StripProblem::new(kind, &scene, Reference::Nested, 1 << 12)
        .expect("the reference grid is a power of two")
}

fn edge_operator(c: &mut Criterion) {
    let mut group = c.benchmark_group("edge operator");
    group.sample_size(20);
    let scalar = problem(StripKind::Scalar, StripData::Transition { position: 0.381966 }, 1.75);
    for level in [12, 14, 16] {
        let operator = scalar.operator(1 << level).expect("a level of the reference grid");
        let g: Vec<f64> = (0..operator.nodes()).map(|i| (i as f64).sin()).collect();
        group.bench_function(BenchmarkId::new("product", format!("2^{level}")), |b| {
            b.iter(|| operator.apply(black_box(&g)).expect("lengths agree"));
        });
    }
    let lame = Lame::new(1.0, 1.0).expect("an admissible material");
    group.bench_function("elastic symbol 2^16", |b| {
        b.iter(|| Strip::elastic(1 << 16, 1 << 16, black_box(lame)).expect("powers of two"));
    });
    group.finish();
}

fn contact(c: &mut Criterion) {
    let mut group = c.benchmark_group("contact, cold start");
    group.sample_size(10);
    let scenes = [
        ("transition", StripData::Transition { position: 0.381966 }, 1.75),
        ("fat Cantor", StripData::FatCantor { depth: 12 }, 1.55),
    ];
    for kind in [StripKind::Scalar, StripKind::Elastic] {
        for (name, scene, tau) in scenes.clone() {
            let problem = problem(kind, scene, tau);
            for cone in Cone::ALL {
                let n = 1 << 14;
                let operator = problem.operator(n).expect("a level of the reference grid");
                let load = problem.load(n).expect("a level of the reference grid");
                let solve = || operator.solve_contact(&load, cone, None, 1e-13).expect("data fit");
                group.bench_function(format!("{kind}, {name}, {cone}, 2^14"), |b| b.iter(solve));
                let values = solve().values;
                if cone == Cone::Nodal {
                    group.bench_function(format!("{kind}, {name}, exact error, 2^14"), |b| {
                        b.iter(|| problem.distance(n, black_box(&values)).expect("lengths agree"));
                    });
                }
            }
        }
    }
    group.finish();
}

criterion_group!(benches, edge_operator, contact);
criterion_main!(benches);
