//! Section 2 on a strip: the Fourier reduction against finite element meshes of the same grid, which know no
//! modes.
//!
//! Scalar: the mesh solver of the library. Elastic: triangles assembled here on a mesh whose left and right
//! sides are identified, all rows but the edge eliminated by dense Cholesky factorizations; the solution of the
//! strip meets the Karush-Kuhn-Tucker conditions of the dense problem, which has no other.

use faer::linalg::solvers::Solve;
use faer::{Mat, Side};
use signorini::cone::{Cone, Ends};
use signorini::contact::Solver;
use signorini::fem::Lame;
use signorini::problems::TestProblem;
use signorini::strip::Strip;
use std::f64::consts::PI;

/// J of both computations: rounding times the condition n² of the mesh matrices (n = 128), with a margin.
const ENERGY: f64 = 1e-11;
/// Balance of forces, sign and complementarity, relative: the same.
const KKT: f64 = 1e-11;
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

/// Stiffness between two rows of nodes and the loads of one layer of triangles, sides identified.
struct Layer {
    /// 4n × 4n over (bottom row, top row), two components per node.
    stiffness: Mat<f64>,
    /// The same for ∫ f_h·v with nodal values of f.
    mass: Mat<f64>,
}

fn layer(n: usize, lame: Lame) -> Layer {
    let mut stiffness = Mat::<f64>::zeros(4 * n, 4 * n);
    let mut mass = Mat::<f64>::zeros(4 * n, 4 * n);
    let h = 1.0 / n as f64;
    let (lambda, mu) = (lame.lambda(), lame.mu());
    for cell in 0..n {
        let right = (cell + 1) % n;
        // bottom left, bottom right, top right, top left
        let corner = [cell, right, n + right, n + cell];
        // Gradients of the hat functions times h, on the triangles below and above the diagonal.
        let triangles = [
            ([corner[0], corner[1], corner[2]], [[-1.0, 0.0], [1.0, -1.0], [0.0, 1.0]]),
            ([corner[0], corner[2], corner[3]], [[0.0, -1.0], [1.0, 0.0], [-1.0, 1.0]]),
        ];
        for (nodes, gradients) in triangles {
            for (a, ga) in nodes.iter().zip(&gradients) {
                for (b, gb) in nodes.iter().zip(&gradients) {
                    let product: f64 = ga[0] * gb[0] + ga[1] * gb[1];
                    for i in 0..2 {
                        for j in 0..2 {
                            let identity = if i == j { 1.0 } else { 0.0 };
                            let entry = lambda * ga[i] * gb[j] + mu * (ga[j] * gb[i] + identity * product);
                            stiffness[(2 * a + i, 2 * b + j)] += 0.5 * entry;
                            let weight = if a == b { 2.0 } else { 1.0 };
                            mass[(2 * a + i, 2 * b + j)] += identity * weight * h * h / 24.0;
                        }
                    }
                }
            }
        }
    }
    Layer { stiffness, mass }
}

/// Edge stiffness over (u_x, u_y) of every edge node, edge load and constant, by dense elimination from the
/// top.
fn eliminate(n: usize, lame: Lame, f: impl Fn(f64, f64) -> [f64; 2]) -> (Mat<f64>, Mat<f64>, f64) {
    let Layer { stiffness, mass } = layer(n, lame);
    let rows = 2 * n;
    let row_of_f =
        |j: usize| -> Vec<f64> { (0..n).flat_map(|i| f(i as f64 / n as f64, j as f64 / n as f64)).collect() };
    let layer_load = |j: usize| -> Mat<f64> {
        let values: Vec<f64> = [row_of_f(j), row_of_f(j + 1)].concat();
        &mass * Mat::from_fn(2 * rows, 1, |i, _| values[i])
    };
    let block = |a: usize, b: usize| stiffness.submatrix(a * rows, b * rows, rows, rows).to_owned();
    // The top row is clamped: only the bottom half of the uppermost layer remains.
    let top = layer_load(n - 1);
    let mut above = block(0, 0);
    let mut load = top.submatrix(0, 0, rows, 1).to_owned();
    let mut constant = 0.0;
    for j in (0..n - 1).rev() {
        let forces = layer_load(j);
        let pivot = &above + block(1, 1);
        let known = &load + forces.submatrix(rows, 0, rows, 1);
        let factor = pivot.llt(Side::Lower).unwrap();
        let released = factor.solve(&known);
        constant -= 0.5 * (known.transpose() * &released)[(0, 0)];
        above = block(0, 0) - block(0, 1) * factor.solve(&block(1, 0));
        load = forces.submatrix(0, 0, rows, 1).to_owned() - block(0, 1) * released;
    }
    (above, load, constant)
}

/// The normal problem: tangential components eliminated, u_N = −u_y.
fn normal_problem(edge: &Mat<f64>, load: &Mat<f64>, constant: f64) -> (Mat<f64>, Vec<f64>, f64) {
    let n = edge.nrows() / 2;
    let part = |a: usize, b: usize| Mat::from_fn(n, n, |i, j| edge[(2 * i + a, 2 * j + b)]);
    let [x, y] = [0, 1].map(|axis| Mat::from_fn(n, 1, |i, _| load[(2 * i + axis, 0)]));
    let factor = part(0, 0).llt(Side::Lower).unwrap();
    let stiffness = part(1, 1) - part(1, 0) * factor.solve(&part(0, 1));
    let released = factor.solve(&x);
    let force = y - part(1, 0) * &released;
    let constant = constant - 0.5 * (x.transpose() * released)[(0, 0)];
    (stiffness, (0..n).map(|i| -force[(i, 0)]).collect(), constant)
}

#[test]
fn elastic_strip_and_periodic_mesh_agree() {
    let lame = Lame::new(1.0, 1.0).unwrap();
    let f = |x: f64, y: f64| {
        [0.3 * (2.0 * PI * x).sin() * (1.0 + y), 0.1 * (4.0 * PI * x).sin() - (2.0 * PI * x).cos()]
    };
    for n in [8, 16, 32, 64] {
        let strip = Strip::elastic(n, n, lame).unwrap();
        let (load, below) = strip.condense(f).unwrap();
        let (edge, force, constant) = eliminate(n, lame, f);
        let (stiffness, force, constant) = normal_problem(&edge, &force, constant);
        for cone in Cone::ALL {
            let solution = strip.operator().solve_contact(&load, cone, None, SOLVED).unwrap();
            assert!(solution.status.is_converged(), "{n} {cone}: {}", solution.status);
            let w = &solution.values;
            let product: Vec<f64> =
                (0..n).map(|i| (0..n).map(|j| stiffness[(i, j)] * w[j]).sum::<f64>()).collect();
            let energy = constant + (0..n).map(|i| (0.5 * product[i] - force[i]) * w[i]).sum::<f64>();
            let error = ((solution.energy + below) / energy - 1.0).abs();
            println!("elastic {n} {cone}: J apart by {error:.1e}");
            assert!(error < ENERGY, "{n} {cone}: {} {energy}", solution.energy + below);
            let ring = cone.on(n, Ends::Joined);
            let held = ring.apply_transposed(&solution.multiplier).unwrap();
            let gap = ring.apply(w);
            let size = |values: &[f64]| values.iter().fold(0.0f64, |m, v| m.max(v.abs()));
            let forces = size(&force) + size(&product);
            for i in 0..n {
                let off = product[i] + held[i] - force[i];
                assert!(off.abs() <= KKT * forces, "{n} {cone} node {i}: {off:e}");
            }
            for i in 0..ring.constraints() {
                let (multiplier, gap) = (solution.multiplier[i], gap[i]);
                assert!(multiplier >= -KKT * forces && gap <= KKT * size(w), "{n} {cone} {i}");
                let is_active = solution.contact.contains(i);
                assert!(
                    if is_active { gap.abs() <= KKT * size(w) } else { multiplier == 0.0 },
                    "{n} {cone} {i}"
                );
            }
        }
    }
}
