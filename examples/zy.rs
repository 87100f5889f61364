use signorini::sobolev::*;
use signorini::*;
fn main() {
    for al in [0.4] {
        let exact = closed_forms::log_power(al).unwrap().value.sqrt();
        let f = SingularFunction::from_positions(&[0.0, 1.0], |p: Position| {
            if p.anchor() == 0 { (-p.offset().ln()).powf(al) } else { (-(p.offset().ln_1p())).powf(al) }
        })
        .unwrap();
        for tol in [1e-10, 3e-11, 2e-11] {
            match f.seminorm(FractionalOrder::HALF, Tolerance::new(tol).unwrap()) {
                Ok(e) => println!(
                    "log^{al} tol {tol:e}: true {:.1e} est {:.1e} points {}",
                    (e.value / exact - 1.0).abs(),
                    e.relative_error(),
                    e.work.points
                ),
                Err(e) => println!("log^{al} tol {tol:e}: {e}"),
            }
        }
    }
}
