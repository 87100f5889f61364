//! Contact costs nothing in the limit: errors beside those of interpolation and of the best approximation.

use signorini::cone::Cone;
use signorini::contact::Solver;
use signorini::mesh::Part;
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

/// Against the best approximation: with a contact load of half the size G is not the projection of u, and the quotient
/// stays away from one.
#[test]
fn the_projection_needs_the_contact_force() {
    let known = KnownSolution::three_halves();
    let quotient = |factor: f64| {
        let mut free = known.problem(32).unwrap();
        let norm = |v: &[f64]| known.error_norms(&known.problem(32).unwrap(), v).unwrap().energy;
        let u = free.solve(Cone::Midpoint, Solver::ActiveSet).unwrap().displacement;
        free.set_gap(|_| f64::from(1 << 30)).unwrap();
        let load = |x: f64| Ok([factor * known.normal_stress(x), 0.0]);
        free.add_boundary_load(Part::Contact, &|[x, _], _| load(x)).unwrap();
        norm(&u) / norm(&free.solve(Cone::Nodal, Solver::ActiveSet).unwrap().displacement)
    };
    let (whole, half) = (quotient(1.0), quotient(0.5));
    assert!((whole - 1.0).abs() < 0.01 && half < 0.9, "{whole} {half}");
}
