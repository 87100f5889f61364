//! Section 1: over 500 random cases with known norms the error estimates are honest and the tolerances are
//! met.

use fractional_sobolev::{Estimate, Function, Mesh, Order, Position, Result, Tolerance, closed_forms};

/// Cases of each of the five kinds.
const CASES: usize = 110;
/// True error over estimated error, in every case.
const HONESTY: f64 = 10.0;
/// Cases out of a hundred that must meet the tolerance they asked for.
const MET_PER_CENT: usize = 99;

/// A linear congruential sequence (Knuth's MMIX constants), fixed seed.
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.next()
    }

    /// 1e-3 ... 1e-9, evenly in the exponent.
    fn tolerance(&mut self) -> Tolerance {
        Tolerance::new(10f64.powf(self.between(-9.0, -3.0))).unwrap()
    }

    fn order(&mut self, high: f64) -> Order {
        Order::new(self.between(0.02, high)).unwrap()
    }

    /// Up to 12 elements, of lengths over eight decades.
    fn mesh(&mut self) -> Mesh {
        let count = 1 + (12.0 * self.next()) as usize;
        Mesh::from_lengths((0..count).map(|_| 10f64.powf(self.between(-8.0, 0.0))).collect()).unwrap()
    }
}

/// What was asked, what came out, and the exact value.
struct Case {
    what: String,
    tolerance: Tolerance,
    outcome: Result<Estimate>,
    exact: f64,
}

fn power(random: &mut Random) -> Case {
    let order = random.order(0.98);
    let a = order.offset() + random.between(0.02, 3.0);
    let tolerance = random.tolerance();
    let u = Function::from_fn(&[0.0, 1.0], |x: f64| x.powf(a)).unwrap();
    Case {
        what: format!("x^{a}, nu {order}"),
        tolerance,
        outcome: u.seminorm(order, tolerance),
        exact: closed_forms::power_seminorm_squared(a, order).unwrap().value.sqrt(),
    }
}

fn jump(random: &mut Random) -> Case {
    let order = random.order(0.48);
    let at = random.between(0.01, 0.99);
    let tolerance = random.tolerance();
    let step = |p: Position| f64::from(u8::from(p.anchor() == 2 || p.anchor() == 1 && p.offset() > 0.0));
    let u = Function::from_positions(&[0.0, at, 1.0], step).unwrap();
    Case {
        what: format!("jump at {at}, nu {order}"),
        tolerance,
        outcome: u.seminorm(order, tolerance),
        exact: closed_forms::jump_seminorm_squared(at, 1.0 - at, order).unwrap().value.sqrt(),
    }
}

fn hat(random: &mut Random) -> Case {
    let order = random.order(0.95);
    let tolerance = random.tolerance();
    let [before, rise, fall, after] = [0.0; 4].map(|_| random.between(0.05, 1.0));
    let breaks = [0.0, before, before + rise, before + rise + fall, before + rise + fall + after];
    let u =
        Function::from_fn(&breaks, |x: f64| ((x - breaks[1]) / rise).min((breaks[3] - x) / fall).max(0.0))
            .unwrap();
    Case {
        what: format!("hat {breaks:?}, nu {order}"),
        tolerance,
        outcome: u.seminorm(order, tolerance),
        exact: closed_forms::hat_seminorm_squared(before, rise, fall, after, order).unwrap().value.sqrt(),
    }
}

fn monomial(random: &mut Random) -> Case {
    let order = random.order(0.98);
    let partition = random.mesh();
    let degree = 1 + (5.0 * random.next()) as usize;
    let tolerance = random.tolerance();
    let total = partition.total();
    let u = Function::interpolate(&partition, degree, |x| (x / total).powi(degree as i32)).unwrap();
    // |(x/L)^k|_ν on (0, L) is L^{1/2−ν} times that on (0, 1).
    let exact = closed_forms::power_seminorm_squared(degree as f64, order).unwrap().value.sqrt()
        * total.powf(-order.offset());
    Case {
        what: format!("degree {degree}, nu {order}"),
        tolerance,
        outcome: u.seminorm(order, tolerance),
        exact,
    }
}

fn linear(random: &mut Random) -> Case {
    let order = random.order(0.98);
    let partition = random.mesh();
    let tolerance = random.tolerance();
    let values: Vec<f64> = (0..=partition.len()).map(|_| random.between(-1.0, 1.0)).collect();
    let u = Function::linears(&partition, &values).unwrap();
    // The second road: the same function as one of degree two goes through quadrature on pairs.
    let quadratic: Vec<f64> = values.windows(2).flat_map(|w| [w[0], 0.5 * (w[0] + w[1]), w[1]]).collect();
    let v = Function::piecewise(&partition, 2, &quadratic).unwrap();
    Case {
        what: format!("linears on {} elements, nu {order}", partition.len()),
        tolerance,
        outcome: u.seminorm(order, tolerance),
        exact: v.seminorm(order, Tolerance::reference()).unwrap().value,
    }
}

#[test]
fn estimates_are_honest_and_tolerances_are_met() {
    let mut random = Random(2012);
    let kinds: [fn(&mut Random) -> Case; 5] = [power, jump, hat, monomial, linear];
    let (mut cases, mut met, mut worst) = (0, 0, 0.0f64);
    for kind in kinds {
        for _ in 0..CASES {
            let case = kind(&mut random);
            cases += 1;
            match case.outcome {
                Ok(estimate) => {
                    let error = (estimate.value - case.exact).abs();
                    // The exact value is itself rounded.
                    let honest = estimate.error.max(4.0 * f64::EPSILON * case.exact);
                    worst = worst.max(error / honest);
                    assert!(
                        error <= HONESTY * honest,
                        "{}: error {error:e}, estimate {:e}",
                        case.what,
                        estimate.error
                    );
                    met += usize::from(error <= case.tolerance.relative() * case.exact);
                }
                Err(error) => println!("{}, asked {}: {error}", case.what, case.tolerance),
            }
        }
    }
    println!("{cases} cases, {met} within the tolerance, worst error/estimate {worst:.2}");
    assert!(cases >= 500 && 100 * met >= MET_PER_CENT * cases, "{met} of {cases}");
}
