use signorini::sobolev::*;
use signorini::*;
use std::time::Instant;
fn main() {
    let half = FractionalOrder::HALF;
    for (a, nu) in [
        (1.0, "0.25"),
        (0.6, "0.1"),
        (0.6, "0.99"),
        (1.0, "0.999"),
        (0.51, "0.99"),
        (0.1, "0.5"),
        (-0.249, "0.25"),
        (-0.489, "0.01"),
        (0.001, "0.5"),
        (3.7, "0.6"),
    ] {
        let order: FractionalOrder = nu.parse().unwrap();
        let exact = closed_forms::power(a, order).unwrap().value.sqrt();
        for tol in [1e-3, 1e-6, 1e-9, 1e-11] {
            let f = SingularFunction::new(&[0.0, 1.0], |x: f64| x.powf(a)).unwrap();
            let t = Instant::now();
            match f.seminorm(order, Tolerance::new(tol).unwrap()) {
                Ok(e) => println!(
                    "x^{a} nu {nu} tol {tol:e}: true {:.1e} est {:.1e} time {:.1e} points {}",
                    (e.value / exact - 1.0).abs(),
                    e.relative_error(),
                    t.elapsed().as_secs_f64(),
                    e.work.points
                ),
                Err(e) => println!("x^{a} nu {nu} tol {tol:e}: {e} {:.1e}", t.elapsed().as_secs_f64()),
            }
        }
    }
    for al in [0.1, 0.25, 0.4] {
        let exact = closed_forms::log_power(al).unwrap().value.sqrt();
        for tol in [1e-3, 1e-6, 1e-9, 1e-11] {
            let f = SingularFunction::from_positions(&[0.0, 1.0], |p: Position| {
                if p.anchor() == 0 { (-p.offset().ln()).powf(al) } else { (-(p.offset().ln_1p())).powf(al) }
            })
            .unwrap();
            let t = Instant::now();
            match f.seminorm(half, Tolerance::new(tol).unwrap()) {
                Ok(e) => println!(
                    "log^{al} tol {tol:e}: true {:.1e} est {:.1e} time {:.1e} points {}",
                    (e.value / exact - 1.0).abs(),
                    e.relative_error(),
                    t.elapsed().as_secs_f64(),
                    e.work.points
                ),
                Err(e) => println!("log^{al} tol {tol:e}: {e} {:.1e}", t.elapsed().as_secs_f64()),
            }
        }
    }
}
