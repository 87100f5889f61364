//! Section 4: the cone (4.1), means over the contact segments.

use crate::reference_squares::check_against_reference;
use signorini::cone::Cone;
use signorini::contact::Solver;
use signorini::problems::TestProblem;

#[test]
fn block_midpoint_matches_five_packages() {
    check_against_reference("E2", TestProblem::Block, Cone::Midpoint);
}

#[test]
fn membrane_midpoint_matches_five_packages() {
    check_against_reference("S2", TestProblem::Membrane, Cone::Midpoint);
}

#[test]
fn larger_cone_has_smaller_energy() {
    // The nodal cone lies inside the midpoint cone, so its minimum is not below.
    for scene in [TestProblem::Block, TestProblem::Membrane] {
        let problem = scene.problem(16).unwrap();
        let [nodal, midpoint] =
            Cone::ALL.map(|cone| problem.solve(cone, Solver::ActiveSet).unwrap().energy);
        assert!(midpoint <= nodal, "{scene}: {midpoint} > {nodal}");
    }
}

#[test]
fn contact_runs_carry_a_sawtooth() {
    // Means vanish on a run of active segments, so nodal values alternate in sign with one amplitude.
    let solution =
        TestProblem::Block.problem(16).unwrap().solve(Cone::Midpoint, Solver::ActiveSet).unwrap();
    let run = solution.contact_set.runs()[0].clone();
    let amplitude = solution.normal_displacement[run.start];
    assert!(amplitude != 0.0);
    for k in run {
        let sum = solution.normal_displacement[k] + solution.normal_displacement[k + 1];
        assert!(sum.abs() <= 1e-15, "segment {k}: {sum:e} beside amplitude {amplitude:e}");
    }
}
