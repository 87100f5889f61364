//! Section 2 on a strip: the Fourier reduction against the mesh solver of the library on the same grid, which knows no
//! modes; elastic in `strip.rs`.

use signorini::cone::Cone;
use signorini::contact::Solver;
use signorini::problems::TestProblem;
use signorini::strip::Strip;
use std::f64::consts::PI;

/// J of both computations: rounding times the condition n² of the mesh matrices (n = 128), with a margin.
const ENERGY: f64 = 1e-11;
/// Relative residual asked of the contact iteration.
const SOLVED: f64 = 1e-13;

#[test]
fn scalar_strip_and_mesh_agree() {
    for n in [8, 16, 32, 64, 128] {
        let problem = TestProblem::Membrane.problem(n).unwrap();
        let strip = Strip::scalar(n, n).unwrap();
        let (force, constant) = strip.condense(|x, _| [(2.0 * PI * x).cos() + 0.3, 0.0]).unwrap();
        let points = problem.edge().points();
        let reversed = points[0][0] > points[1][0];
        for cone in Cone::ALL {
            let mesh = problem.solve(cone, Solver::ActiveSet).unwrap();
            let edge = strip.operator().solve_contact(&force, cone, None, SOLVED).unwrap();
            assert!(edge.status.is_converged(), "{n} {cone}: {}", edge.status);
            let energy = edge.energy + constant;
            let error = (energy / mesh.energy - 1.0).abs();
            println!("scalar {n} {cone}: J apart by {error:.1e}");
            assert!(error < ENERGY, "{n} {cone}: {energy} {}", mesh.energy);
            let mut set = mesh.contact_set.as_slice().to_vec();
            if reversed {
                set.reverse();
            }
            assert_eq!(edge.contact.as_slice(), set, "{n} {cone}");
        }
    }
}
