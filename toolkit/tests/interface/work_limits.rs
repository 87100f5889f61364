//! Section 1: functions whose norms rounding spoils are refused at once, with a value and a way out; a limit
//! of work is kept by every norm that evaluates a closure.

use fractional_sobolev::{Error, Estimate, Function, Mesh, Order, Result, Tolerance, Triangles};
use std::sync::atomic::{AtomicU64, Ordering};

fn refusal(found: &Result<Estimate>) -> (Option<Estimate>, &'static str) {
    match found {
        Err(Error::ToleranceNotMet { best, why, .. }) => (*best, why),
        other => panic!("not refused: {other:?}"),
    }
}

#[test]
fn a_logarithm_of_rounded_distances_is_refused_quickly() {
    let rounded = Function::from_fn(&[0.0, 0.3, 1.0], |x: f64| (x - 0.3).abs().ln()).unwrap();
    let exact = Function::from_positions(&[0.0, 0.3, 1.0], |at| at.log_distance_to(1)).unwrap();
    for (order, tolerance) in [(0.45, 1e-6_f64), (0.45, 1e-10), (0.3, 1e-10), (0.49, 1e-4)] {
        let reference = exact.seminorm(order, tolerance.min(1e-6)).unwrap();
        let found = rounded.seminorm(order, tolerance);
        let (best, why) = refusal(&found);
        let best = best.expect("a value");
        assert!(
            (best.value - reference.value).abs() <= best.error + reference.error,
            "{best} {reference}"
        );
        assert!(why.contains("from_positions"), "{why}");
        // 43 s were 10⁹ evaluations.
        assert!(best.work.points < 5_000_000, "{best:?}");
    }
    // What rounding leaves room for is still answered.
    assert!(rounded.seminorm(0.2, 1e-6).is_ok() && rounded.seminorm(0.45, 1e-2).is_ok());
}

#[test]
fn every_norm_of_a_closure_keeps_a_limit_of_work() {
    let count = AtomicU64::new(0);
    let noisy = |x: f64| {
        count.fetch_add(1, Ordering::Relaxed);
        (1e4 * x).sin() + (1e9 * x).sin().abs()
    };
    let u = Function::from_fn(&[0.0, 1.0], noisy).unwrap();
    let mesh = Mesh::uniform(10, 1.0).unwrap();
    let field = Function::linears(&mesh, &[0.0; 11]).unwrap();
    let plane = Triangles::grid([2, 2], 1.0).unwrap();
    let w = Function::from_plane_positions(&plane, &[], |at| noisy(at.x()[0])).unwrap();
    for limit in [100, 10_000, 300_000] {
        let tolerance = Tolerance::new(1e-9).unwrap().with_work(limit);
        let order = Order::new(0.4).unwrap();
        type Norm<'a> = (&'a str, u64, &'a dyn Fn() -> Result<Estimate>);
        let norms: [Norm<'_>; 11] = [
            ("seminorm", 1, &|| u.seminorm(order, tolerance)),
            ("norm", 2, &|| u.norm(order, tolerance)),
            ("l2", 1, &|| u.norm(0.0, tolerance)),
            ("l3", 1, &|| u.lp(3.0, tolerance)),
            ("sup", 1, &|| u.lp(f64::INFINITY, tolerance)),
            ("mean", 2, &|| u.mean(tolerance)),
            ("dual", 2, &|| u.norm(-order, tolerance)),
            ("error", 2, &|| u.minus(&field).unwrap().norm(order, tolerance)),
            ("error in L2", 1, &|| u.minus(&field).unwrap().norm(0.0, tolerance)),
            ("plane", 1, &|| w.seminorm(order, tolerance)),
            ("plane L2", 1, &|| w.norm(0.0, tolerance)),
        ];
        for (name, integrals, norm) in norms {
            count.store(0, Ordering::Relaxed);
            let found = norm();
            let (_, why) = refusal(&found);
            let spent = count.load(Ordering::Relaxed);
            // Beside the limit: looks at the size, and in the plane a rule on every pair that was begun.
            let slack = if name.starts_with("plane") { 600_000 } else { 200 };
            assert!(spent <= integrals * (limit + slack), "{name}: {spent} of {limit}");
            if spent as f64 > 0.9 * limit as f64 && name != "mean" && name != "plane L2" {
                assert!(why.contains("work limit"), "{name}, {limit}: {why}");
            }
        }
    }
    // The limit is far from what smooth functions need.
    let smooth = Function::from_fn(&[0.0, 1.0], |x: f64| x.exp()).unwrap();
    let few = Tolerance::balanced().with_work(500_000);
    assert!(smooth.norm(0.5, few).is_ok() && smooth.norm(0.5, few.with_work(500)).is_err());
}

#[test]
fn a_refusal_for_the_limit_of_work_names_it() {
    let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    let u = Function::on_polygon(&square, |[x, y]| (9.0 * x).sin() + (y - 0.3).abs()).unwrap();
    let tolerance = Tolerance::new(1e-13).unwrap();
    for s in [-0.5, 0.0, 0.5, 1.0, 1.3] {
        let few = u.norm(s, tolerance.with_work(100));
        assert!(refusal(&few).1.contains("work limit"), "{s}: {few:?}");
    }
    assert!(!refusal(&u.norm(0.0, tolerance)).1.contains("work limit"));
    // In the plane the first accuracy may be within the limit and the next one not.
    let nodes = [[0.0, 0.0], [1.0, 0.0], [1.0, 0.05], [0.0, 0.05]];
    let plane = Triangles::new(&nodes, &[[0, 1, 2], [0, 2, 3]]).unwrap();
    let w = Function::on_triangles(&plane, 1, &[0.0, 1.0, -2.0, 1.0]).unwrap();
    let mut with_value = 0;
    for asked in [1e-10, 1e-12, 1e-13, 3e-14] {
        let tolerance = Tolerance::new(asked).unwrap();
        let answered = w.seminorm(0.5, tolerance).is_ok();
        for power in 10..28 {
            let found = w.seminorm(0.5, tolerance.with_work(1 << power));
            let Err(Error::ToleranceNotMet { best, why, .. }) = found else { continue };
            with_value += usize::from(best.is_some());
            assert!(!answered || why.contains("work limit"), "{power}: {why}");
        }
    }
    assert!(with_value > 0);
}
