//! u − u_h in H^ν: against closures with every node as a break, closed forms, and laws of many elements.

use crate::common::SplitMix;
use crate::hard::cases;
use fractional_sobolev::{DualOf, Error, Estimate, Function, Mesh, Order, Position, Tolerance};

fn order(nu: f64) -> Order {
    Order::new(nu).unwrap()
}

fn asked(tolerance: f64) -> Tolerance {
    Tolerance::new(tolerance).unwrap()
}

/// |x − c|^a + b sin(wx) and its break.
#[derive(Debug, Clone, Copy)]
struct Sample {
    c: f64,
    a: f64,
    b: f64,
    w: f64,
}

impl Sample {
    fn breaks(&self) -> Vec<f64> {
        if self.c > 0.0 { vec![0.0, self.c, 1.0] } else { vec![0.0, 1.0] }
    }

    fn value(&self, distance: f64, x: f64) -> f64 {
        distance.powf(self.a) + self.b * (self.w * x).sin()
    }

    fn function(self) -> Function<'static> {
        let k = usize::from(self.c > 0.0);
        Function::from_positions(&self.breaks(), move |at: Position| {
            self.value(at.distance_to(k), at.x())
        })
        .unwrap()
    }

    /// u − u_h with all nodes declared.
    fn by_closure<'a>(self, field: &'a Function<'_>) -> Function<'a> {
        let mut breaks = field.mesh().unwrap().nodes();
        breaks.push(self.c);
        breaks.sort_by(f64::total_cmp);
        breaks.dedup();
        let k = breaks.iter().position(|&x| x == self.c).unwrap();
        let nodes = field.mesh().unwrap().nodes();
        Function::from_positions(&breaks.clone(), move |at: Position| {
            let right = at.offset() > 0.0 || at.offset() == 0.0 && at.offset().is_sign_positive();
            let start = breaks[at.anchor() - usize::from(!right)];
            let element = nodes.partition_point(|&x| x <= start) - 1;
            let h = nodes[element + 1] - nodes[element];
            let t = (((breaks[at.anchor()] - nodes[element]) + at.offset()) / h).clamp(0.0, 1.0);
            self.value(at.distance_to(k), at.x()) - field.value_on(element, t).unwrap()
        })
        .unwrap()
    }
}

fn random_field(random: &mut SplitMix, sample: &Sample, count: usize) -> Function<'static> {
    let mut nodes: Vec<f64> = (1..count).map(|_| random.uniform()).chain([0.0, 1.0]).collect();
    if sample.c > 0.0 && random.uniform() < 0.5 {
        nodes.push(sample.c);
    }
    nodes.sort_by(f64::total_cmp);
    nodes.dedup_by(|b, a| *b - *a < 1e-6);
    *nodes.last_mut().unwrap() = 1.0;
    let off = 0.02 * random.uniform();
    let values: Vec<f64> = nodes
        .iter()
        .map(|&x| sample.value((x - sample.c).abs(), x) + off * (random.uniform() - 0.5))
        .collect();
    Function::linears(&Mesh::from_nodes(&nodes).unwrap(), &values).unwrap()
}

#[test]
fn random_errors_agree_with_closures_at_every_tolerance() {
    let mut random = SplitMix::new(11);
    for case in 0..cases(100) {
        let nu = 0.05 + 0.85 * random.uniform();
        let a = (nu - 0.5).max(-0.4) + 0.15 + 1.5 * random.uniform();
        let c = if random.uniform() < 0.3 { 0.0 } else { 0.1 + 0.8 * random.uniform() };
        let sample = Sample { c, a: a.max(0.05), b: random.uniform(), w: 8.0 * random.uniform() };
        let elements = 1 + (random.uniform() * 7.0) as usize;
        let field = random_field(&mut random, &sample, elements);
        let (u, closure) = (sample.function(), sample.by_closure(&field));
        let exact = Estimate::or_best(closure.seminorm(order(nu), asked(1e-8))).unwrap();
        let plain = Estimate::or_best(closure.norm(0.0, asked(1e-11))).unwrap();
        for tolerance in [1e-2, 1e-4, 1e-6] {
            let found = u.minus(&field).unwrap().seminorm(order(nu), asked(tolerance)).unwrap();
            let off = (found.value - exact.value).abs();
            let words = format!(
                "{case}: {sample:?} nu {nu} {tolerance} {:?}",
                field.mesh().unwrap().nodes()
            );
            assert!(off <= found.error + exact.error, "{words}: {found} {exact}");
            assert!(found.relative_error() <= tolerance, "{words}: {found}");
            let found = u.minus(&field).unwrap().norm(0.0, asked(tolerance)).unwrap();
            assert!(
                (found.value - plain.value).abs() <= found.error + plain.error,
                "{words}: {found} {plain}"
            );
        }
    }
}

#[test]
fn the_error_of_a_parabola_is_its_bubbles() {
    let u = Function::from_fn(&[0.0, 1.0], |x| x * x).unwrap();
    for (count, grading) in [(300, 1.0), (300, 3.0), (20_000, 2.0)] {
        let mesh = Mesh::algebraic(count, grading, 1.0).unwrap();
        let values: Vec<f64> = mesh.nodes().iter().map(|x| x * x).collect();
        let field = Function::linears(&mesh, &values).unwrap();
        let bubbles: Vec<f64> =
            mesh.lengths().iter().flat_map(|h| [0.0, -0.25 * h * h, 0.0]).collect();
        let exact = Function::piecewise(&mesh, 2, &bubbles).unwrap();
        for nu in [0.25, 0.5, 0.75] {
            let exact = exact.seminorm(order(nu), asked(1e-9)).unwrap();
            for tolerance in [1e-3, 1e-6] {
                let found = u.minus(&field).unwrap().seminorm(order(nu), asked(tolerance)).unwrap();
                let off = (found.value - exact.value).abs();
                assert!(
                    off <= found.error + exact.error,
                    "{count} {nu} {tolerance}: {found} {exact}"
                );
                assert!(found.work.total() < 20_000_000 + 8000 * count as u64, "{:?}", found.work);
            }
        }
    }
}

#[test]
fn smooth_ends_below_rounding_are_no_waves() {
    // At x = 1 the interpolant of x^0.75 on 10^5 equal elements is off by 10^-12: rounding is most of it there.
    let (a, nu) = (0.75, 0.5);
    let u = Function::from_positions(&[0.0, 1.0], |at| at.distance_to(0).powf(a)).unwrap();
    let error = |count: usize| {
        let mesh = Mesh::uniform(count, 1.0).unwrap();
        let values: Vec<f64> = mesh.from_left().iter().map(|x| x.powf(a)).collect();
        let field = Function::linears(&mesh, &values).unwrap();
        u.minus(&field).unwrap().seminorm(order(nu), asked(1e-6)).unwrap()
    };
    // The first elements alone count: scaling by x = t/N, and what ends at N elements is of the order 1/N².
    let (coarse, fine) = (error(20_000), error(100_000));
    let rate = (coarse.value / fine.value).ln() / 5f64.ln();
    assert!((rate - 0.75).abs() < 1e-4, "{rate} {coarse} {fine}");
}

#[test]
fn jumps_and_other_intervals_are_refused() {
    let u = Function::from_fn(&[0.0, 1.0], |x| x).unwrap();
    let steps = Function::piecewise(
        &Mesh::uniform(8, 1.0).unwrap(),
        0,
        &[0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0],
    )
    .unwrap();
    let found = u.minus(&steps).unwrap().seminorm(Order::HALF, Tolerance::fast());
    assert!(matches!(found, Err(Error::InfiniteNorm { .. })));
    assert!(u.minus(&steps).unwrap().seminorm(order(0.4), Tolerance::fast()).is_ok());
    let longer = Function::piecewise(&Mesh::uniform(8, 2.0).unwrap(), 0, &[0.0; 8]).unwrap();
    assert!(matches!(
        u.minus(&longer).unwrap().norm(0.0, Tolerance::fast()),
        Err(Error::OutOfRange { .. })
    ));
    let power = Function::power(0.2).unwrap();
    let singular = power.minus(&longer).unwrap().seminorm(order(0.8), Tolerance::fast());
    assert!(singular.is_err());
    let flat = Function::piecewise(&Mesh::uniform(8, 1.0).unwrap(), 0, &[0.0; 8]).unwrap();
    let singular = power.minus(&flat).unwrap().seminorm(order(0.8), Tolerance::fast());
    assert!(matches!(singular, Err(Error::InfiniteNorm { .. })), "{singular:?}");
}

#[test]
fn lebesgue_and_dual_norms_of_errors_are_those_of_the_difference() {
    // x^0.6 + 0.5 sin 4x against its interpolant: by a closure whose breaks are all nodes.
    let sample = Sample { c: 0.3, a: 0.6, b: 0.5, w: 4.0 };
    let u = sample.function();
    let mesh = Mesh::uniform(12, 1.0).unwrap();
    let values: Vec<f64> = mesh.nodes().iter().map(|x| sample.value((x - 0.3).abs(), *x)).collect();
    let field = Function::linears(&mesh, &values).unwrap();
    let all = sample.by_closure(&field);
    for q in [1.0, 2.0, 3.5] {
        let (a, b) = (
            u.minus(&field).unwrap().lp(q, 1e-6).unwrap(),
            Estimate::or_best(all.lp(q, 1e-6)).unwrap(),
        );
        assert!((a.value - b.value).abs() <= a.error + b.error, "{q}: {a} {b}");
    }
    let l2 = u.minus(&field).unwrap().norm(0.0, 1e-8).unwrap();
    assert!((u.minus(&field).unwrap().lp(2.0, 1e-8).unwrap().value / l2.value - 1.0).abs() < 1e-7);
    for of in [DualOf::Slobodeckij, DualOf::Interpolation, DualOf::InterpolationZero] {
        let a = u.minus(&field).unwrap().dual_norm(of, 0.5, 1e-5).unwrap();
        let b = Estimate::or_best(all.dual_norm(of, 0.5, 1e-5)).unwrap();
        assert!(
            (a.value - b.value).abs() <= a.error + b.error && a.value < l2.value,
            "{of:?}: {a} {b}"
        );
    }
    assert!(u.minus(&field).unwrap().lp(0.5, 1e-6).is_err());
}
