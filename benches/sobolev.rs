//! Criterion timings of the fractional-Sobolev toolkit, on the cases of the accuracy table in
//! `examples/speed_for_accuracy.rs`.
#![allow(missing_docs)] // criterion_group writes public items of its own

use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};
use fractional_sobolev::{Function, Gram, Mesh, Order, Tolerance};
use std::hint::black_box;

fn closures(c: &mut Criterion) {
    let mut group = c.benchmark_group("closure x^0.6, nu 0.25");
    let order = Order::new(0.25).unwrap();
    let u = Function::from_fn(&[0.0, 1.0], |x: f64| x.powf(0.6)).unwrap();
    for asked in [1e-3, 1e-7, 1e-11] {
        let tolerance = Tolerance::new(asked).unwrap();
        group.bench_with_input(BenchmarkId::from_parameter(tolerance), &tolerance, |b, &t| {
            b.iter(|| u.seminorm(order, black_box(t)).unwrap());
        });
    }
    group.finish();
}

fn dense(c: &mut Criterion) {
    let partition = Mesh::geometric(199, 0.8, 1.0).unwrap();
    c.bench_function("dense Gram matrix, 200 graded elements", |b| {
        b.iter(|| Gram::new(black_box(&partition), 0.5, 1e-8).unwrap().to_dense().unwrap());
    });
}

fn products(c: &mut Criterion) {
    let mut group = c.benchmark_group("fast product");
    for n in [10_000, 100_000] {
        let graded = Mesh::geometric(n - 1, 1e-30f64.powf(1.0 / (n - 1) as f64), 1.0).unwrap();
        for (name, partition) in [("uniform", Mesh::uniform(n, 1.0).unwrap()), ("graded", graded)] {
            let operator = Gram::new(&partition, 0.5, 1e-11).unwrap();
            let x: Vec<f64> = (0..=n).map(|i| ((i * 7919) % 1000) as f64).collect();
            operator.apply(&x).unwrap(); // prepares the product
            group.bench_function(BenchmarkId::new(name, n), |b| {
                b.iter(|| operator.apply(black_box(&x)).unwrap())
            });
        }
    }
    group.finish();
}

criterion_group!(benches, closures, dense, products);
criterion_main!(benches);
