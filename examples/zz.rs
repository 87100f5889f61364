use signorini::sobolev::*;
use signorini::*;
use std::time::Instant;
fn main() {
    let order = FractionalOrder::HALF;
    for n in [10_000usize, 100_000, 1_000_000] {
        for kind in ["uniform", "geometric 1e-30"] {
            let p = if kind == "uniform" {
                Partition::uniform(n, 1.0).unwrap()
            } else {
                Partition::geometric(n - 1, 1e-30f64.powf(1.0 / (n - 1) as f64), 1.0).unwrap()
            };
            let t = Instant::now();
            let a = GramOperator::linears(&p, order, Tolerance::new(1e-11).unwrap()).unwrap();
            let setup = t.elapsed().as_secs_f64();
            let x: Vec<f64> = (0..=n).map(|i| ((i * 7919) % 1000) as f64 / 1000.0 - 0.5).collect();
            let mut best = f64::MAX;
            for _ in 0..4 {
                let t = Instant::now();
                let y = a.apply(&x).unwrap();
                best = best.min(t.elapsed().as_secs_f64());
                assert!(y[0].is_finite());
            }
            println!(
                "{kind} N {n}: setup {setup:.2} s, product {best:.4} s, {:.1} numbers per unknown",
                a.bytes() as f64 / 8.0 / n as f64
            );
        }
    }
}
