//! Programs of sheet 2. `cargo course skeleton contact` writes this file with holes.

use course::{check, near};
use signorini::Result;
use signorini::cone::Cone;
use signorini::contact::Solver;
use signorini::problems::TestProblem;

/// The minimum of ½ v·Av − f·v over v ≤ 0, by `steps` sweeps of projected Gauss-Seidel steps from zero.
fn gauss_seidel(a: &[Vec<f64>], f: &[f64], steps: usize) -> Vec<f64> {
    // solution: solve row i for v[i], then take the smaller of it and zero
    let mut v = vec![0.0; f.len()];
    for _ in 0..steps {
        for i in 0..v.len() {
            let others: f64 = (0..v.len()).filter(|&k| k != i).map(|k| a[i][k] * v[k]).sum();
            v[i] = ((f[i] - others) / a[i][i]).min(0.0);
        }
    }
    v
    // end
}

/// The largest violation of v ≤ 0, σ = Av − f ≤ 0 and v σ = 0 over all components.
fn residual(a: &[Vec<f64>], f: &[f64], v: &[f64]) -> f64 {
    // solution: a maximum over the rows
    let force = |i: usize| a[i].iter().zip(v).map(|(a, v)| a * v).sum::<f64>() - f[i];
    (0..v.len())
        .map(|i| v[i].max(force(i)).max((v[i] * force(i)).abs()).max(0.0))
        .fold(0.0, f64::max)
    // end
}

/// Whether values at the nodes of an edge belong to the nodal cone, and to the midpoint cone.
fn cones(values: &[f64]) -> [bool; 2] {
    // solution: all values; all means of two neighbours
    [values.iter().all(|&v| v <= 0.0), values.windows(2).all(|pair| pair[0] + pair[1] <= 0.0)]
    // end
}

/// By how much the minimal energy of the block on `n` segments is lower in the midpoint cone.
fn gain(n: usize) -> Result<f64> {
    // solution: solve twice, subtract
    let problem = TestProblem::Block.problem(n)?;
    let nodal = problem.solve(Cone::Nodal, Solver::ActiveSet)?;
    let midpoint = problem.solve(Cone::Midpoint, Solver::ActiveSet)?;
    Ok(nodal.energy - midpoint.energy)
    // end
}

/// How many nodes of the contact edge of the block touch the floor, in the nodal cone on `n` segments.
fn touching(n: usize) -> Result<usize> {
    // solution: count the normal displacements that are zero
    let solution = TestProblem::Block.problem(n)?.solve(Cone::Nodal, Solver::ActiveSet)?;
    Ok(solution.normal_displacement.iter().filter(|u| u.abs() < 1e-12).count())
    // end
}

/// A string with `n` inner nodes, stiffness matrix (−1, 2, −1).
fn string(n: usize) -> Vec<Vec<f64>> {
    let entry = |i: usize, k: usize| match i.abs_diff(k) {
        0 => 2.0,
        1 => -1.0,
        _ => 0.0,
    };
    (0..n).map(|i| (0..n).map(|k| entry(i, k)).collect()).collect()
}

#[test]
fn gauss_seidel_finds_the_minimum() {
    let load: Vec<f64> = (0..9).map(|i| if i < 4 { -0.1 } else { 0.2 }).collect();
    let v = gauss_seidel(&string(9), &load, 2000);
    check(
        "gauss_seidel",
        "a string of 9 nodes, 2000 sweeps",
        &v,
        "v₁ < 0 and v₉ = 0",
        v[0] < 0.0 && v[8] == 0.0,
    );
    near(
        "gauss_seidel or residual",
        "residual of the same string",
        residual(&string(9), &load, &v),
        0.0,
        1e-12,
    );
}

#[test]
fn residual_sees_each_violation() {
    let a = string(2);
    near(
        "residual",
        "f = (0, 0), v = (1/2, 0): v > 0",
        residual(&a, &[0.0, 0.0], &[0.5, 0.0]),
        1.0,
        0.0,
    );
    near(
        "residual",
        "f = (−1, 0), v = 0: the stop pulls",
        residual(&a, &[-1.0, 0.0], &[0.0, 0.0]),
        1.0,
        0.0,
    );
    near(
        "residual",
        "f = (0, 1), v = 0: the solution",
        residual(&a, &[0.0, 1.0], &[0.0, 0.0]),
        0.0,
        0.0,
    );
}

#[test]
fn cones_of_a_sawtooth() {
    let cases = [
        ([-1.0, 0.0, -2.0], [true, true]),
        ([1.0, -1.0, 1.0], [false, true]),
        ([1.0, 0.0, -1.0], [false, false]),
    ];
    for (values, expected) in cases {
        let found = cones(&values);
        check("cones", &format!("{values:?}"), found, &format!("{expected:?}"), found == expected);
    }
}

#[test]
fn gain_is_positive_and_falls() {
    let gains: Vec<f64> = [8, 16, 32].map(|n| gain(n).unwrap()).to_vec();
    let falls = gains[2] > 0.0 && gains[0] > gains[1] && gains[1] > gains[2];
    check("gain", "8, 16, 32 segments", &gains, "positive and falling", falls);
}

#[test]
fn touching_nodes_of_the_block() {
    let found = touching(32).unwrap();
    check("touching", "32 segments", found, "11", found == 11);
}
