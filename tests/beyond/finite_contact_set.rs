//! Analytic loads: the square of stress and slope continues across the contact edge; its zeros are the ends of contact.

#[allow(dead_code, reason = "the functions of the example are used one by one")]
#[path = "../../examples/finite_contact_set.rs"]
mod example;

use signorini::cone::Cone;
use signorini::contact::Solver;
use signorini::problems::TestProblem;

/// The zero of P/Q about `end` from u on n × n squares, window 0.15.
fn predicted(problem: TestProblem, n: usize, c: f64) -> (f64, f64) {
    let u = problem.problem(n).unwrap().solve(Cone::Nodal, Solver::Multigrid).unwrap();
    let last = u.pressure.iter().take_while(|p| **p > 0.0).count() as f64 - 1.0;
    let (h, width) = (1.0 / n as f64, 0.15);
    let end = (last + 0.5) * h;
    let near = |x: f64| (4.0 * h..=width).contains(&(x - end).abs());
    let points: Vec<_> = example::samples(&u, c)
        .into_iter()
        .filter(|p| near(p.0))
        .map(|p| ((p.0 - end) / width, p.1))
        .collect();
    (end, end + width * example::Rational::fit(&points).unwrap().zero())
}

#[test]
fn the_end_predicted_on_a_coarse_mesh_lies_in_the_segment_of_a_mesh_eight_times_finer() {
    let c = 4.0 / 3.0; // 2μ(λ + μ)/(λ + 2μ), λ = μ = 1
    let (mesh, zero) = predicted(TestProblem::Block, 64, c);
    let (fine, _) = predicted(TestProblem::Block, 512, c);
    assert!((zero - fine).abs() <= 0.5 / 512.0, "{zero} {fine}");
    assert!((mesh - fine).abs() > 0.5 / 512.0, "the mesh itself would have done: {mesh} {fine}");
}

/// With another factor than c the two sides have different slopes, and no function without a pole fits them.
#[test]
fn a_wrong_factor_is_seen() {
    let misfit = |c: f64| {
        let u =
            TestProblem::Block.problem(256).unwrap().solve(Cone::Nodal, Solver::ActiveSet).unwrap();
        let points: Vec<_> = example::samples(&u, c)
            .into_iter()
            .filter(|p| (4.0 / 256.0..=0.15).contains(&(p.0 - 0.332).abs()))
            .map(|p| ((p.0 - 0.332) / 0.15, p.1))
            .collect();
        example::Rational::fit(&points).unwrap().misfit(&points)
    };
    let (right, wrong) = (misfit(4.0 / 3.0), misfit(1.0));
    assert!(wrong > 5.0 * right, "{right:e} {wrong:e}");
}

/// A known P/Q is recovered: zero 0.2, poles at ±2i.
#[test]
fn a_rational_function_is_recovered() {
    let f = |t: f64| (t - 0.2) * (1.0 + t + 0.3 * t.powi(3)) / (4.0 + t * t);
    let points: Vec<_> = (-20..=20).map(|i| f64::from(i) / 20.0).map(|t| (t, f(t))).collect();
    let found = example::Rational::fit(&points).unwrap();
    assert!((found.zero() - 0.2).abs() < 1e-9 && (found.pole() - 2.0).abs() < 1e-6);
}
