//! Contact costs nothing in the limit: errors beside those of interpolation and of the best approximation.

use signorini::cone::Cone;
use signorini::contact::Solver;
use signorini::problems::KnownSolution;

/// The theorem on triangulations, without a strip: the squared error less that of interpolation, over h², falls.
#[test]
fn what_is_above_interpolation_is_of_higher_order() {
    let known = KnownSolution::one_transition(None);
    let above = |n: usize| {
        let problem = known.problem(n).unwrap();
        let u = problem.solve(Cone::Nodal, Solver::ActiveSet).unwrap();
        let square = |v: &[f64]| known.error_norms(&problem, v).unwrap().energy.powi(2);
        (square(&u.displacement) - square(&known.interpolant(&problem).unwrap())) * (n * n) as f64
    };
    let [coarse, fine] = [8, 64].map(above);
    assert!(fine < 0.5 * coarse.abs().max(1e-3), "{coarse:e} {fine:e}");
}
