//! Seconds of the contact solvers on the scenes of the accuracy tables: elimination, cold and nested starts,
//! both solvers.

use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};
use signorini::cone::Cone;
use signorini::contact::{Settings, Solver, Start};
use signorini::problems::TestProblem;
use std::hint::black_box;

fn both_solvers(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("block");
    group.sample_size(10);
    for n in [16, 32, 64] {
        for cone in Cone::ALL {
            for solver in [Solver::ActiveSet, Solver::InteriorPoint] {
                let name = BenchmarkId::new(format!("{cone} {solver}"), n);
                group.bench_with_input(name, &n, |bencher, &n| {
                    bencher.iter(|| black_box(TestProblem::Block.problem(n)?.solve(cone, solver)));
                });
            }
        }
    }
    group.finish();
}

fn cold_and_nested(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("start");
    group.sample_size(10);
    for cone in Cone::ALL {
        let Ok(coarse) = TestProblem::Block
            .problem(64)
            .and_then(|problem| problem.solve(cone, Solver::ActiveSet))
        else {
            continue;
        };
        let Ok(fine) = TestProblem::Block.problem(128) else { continue };
        group.bench_function(format!("{cone} cold"), |bencher| {
            bencher.iter(|| black_box(fine.solve(cone, Solver::ActiveSet)));
        });
        group.bench_function(format!("{cone} nested"), |bencher| {
            bencher.iter(|| {
                black_box(
                    fine.solve(
                        cone,
                        Settings { start: Start::Coarse(&coarse), ..Settings::default() },
                    ),
                )
            });
        });
    }
    group.finish();
}

criterion_group!(benches, both_solvers, cold_and_nested);
criterion_main!(benches);
