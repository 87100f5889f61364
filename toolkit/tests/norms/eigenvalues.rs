//! Extreme eigenvalues of (Gram, mass) on intervals, against dense matrices and a value from the literature.

use crate::common::SplitMix;
use fractional_sobolev::closed_forms::fractional_laplacian_constant;
use fractional_sobolev::{Error, Gram, Mesh, Result};
use nalgebra::{Cholesky, DMatrix, SymmetricEigen};

/// Dense reduction by the mass matrix loses this much of the largest eigenvalue.
const DENSE: f64 = 1e-13;

fn unequal(count: usize, decades: f64) -> Result<Mesh> {
    let mut random = SplitMix::new(1);
    Mesh::from_lengths(&(0..count).map(|_| 10f64.powf(decades * random.uniform())).collect::<Vec<_>>())
}

fn dense_eigenvalues(form: &Gram) -> Result<Vec<f64>> {
    let n = form.len();
    let mut mass = DMatrix::zeros(n, n);
    for j in 0..n {
        let unit: Vec<f64> = (0..n).map(|i| f64::from(i == j)).collect();
        mass.column_mut(j).copy_from_slice(&form.mass(&unit)?);
    }
    let lower = Cholesky::new(mass).expect("positive definite").l();
    let half = lower.solve_lower_triangular(&form.to_dense()?).expect("regular").transpose();
    let reduced = lower.solve_lower_triangular(&half).expect("regular");
    let symmetric = (&reduced + reduced.transpose()) * 0.5;
    let mut values: Vec<f64> = SymmetricEigen::new(symmetric).eigenvalues.iter().copied().collect();
    values.sort_by(f64::total_cmp);
    Ok(values)
}

#[test]
fn both_ends_of_the_spectrum_are_those_of_the_dense_matrices() -> Result<()> {
    for mesh in
        [Mesh::uniform(200, 2.0)?, unequal(200, 0.5)?, unequal(200, 3.0)?, Mesh::algebraic(200, 3.0, 1.0)?]
    {
        for s in [0.3, 0.5, 0.8] {
            let mut forms = vec![(Gram::new(&mesh, s, 1e-7)?, 1), (Gram::zero_outside(&mesh, s, 1e-7)?, 0)];
            if s < 0.5 {
                forms.push((Gram::constants(&mesh, s, 1e-7)?, 1));
            }
            for (form, first) in forms {
                let exact = dense_eigenvalues(&form)?;
                let largest = exact[exact.len() - 1];
                let [low, high] = form.extreme_eigenvalues()?;
                for (found, exact) in [(low, exact[first]), (high, largest)] {
                    let difference = (found.value - exact).abs();
                    let admissible = found.error + DENSE * largest;
                    assert!(difference <= admissible, "{s} {form:?}: {found} against {exact}");
                    assert!(found.relative_error() <= 2e-7);
                }
            }
        }
    }
    Ok(())
}

/// The lowest eigenvalue of (−Δ)^{1/2} on (−1, 1): Kwaśnicki, J. Funct. Anal. 262 (2012), 2379-2402.
const LOWEST: f64 = 1.157_773_883_697_7;

#[test]
fn the_lowest_eigenvalue_of_the_root_of_the_laplacian_is_the_known_one() -> Result<()> {
    let half = Mesh::algebraic(1500, 3.0, 1.0)?;
    let lengths = half.lengths();
    let mesh = Mesh::from_lengths(&lengths.iter().chain(lengths.iter().rev()).copied().collect::<Vec<_>>())?;
    let constant = 0.5 * fractional_laplacian_constant(0.5)?.value;
    let [low, _] = Gram::zero_outside(&mesh, 0.5, 1e-10)?.extreme_eigenvalues()?;
    // From above, by the square of the error of piecewise linears, n^{-3}.
    let excess = constant * low.value / LOWEST - 1.0;
    assert!(excess > 0.0 && excess < 1e-8, "{excess:e}");
    Ok(())
}

#[test]
fn too_few_functions_are_refused() -> Result<()> {
    let form = Gram::zero_outside(&Mesh::uniform(4, 1.0)?, 0.5, 1e-6)?;
    assert!(matches!(form.extreme_eigenvalues(), Err(Error::CountOutOfRange { .. })));
    Ok(())
}

/// Thousands of groups of short elements have eigenvalues within a percent of the largest one.
#[test]
fn the_largest_eigenvalue_of_a_random_mesh_does_not_depend_on_the_tolerance() {
    let mut random = SplitMix::new(17);
    for _ in 0..2 {
        let nodes: Vec<f64> = (0..20_000).map(|i| f64::from(i) + 0.8 * random.uniform()).collect();
        let mesh = Mesh::from_nodes(&nodes).unwrap();
        let largest = |asked| Gram::new(&mesh, 0.5, asked).unwrap().extreme_eigenvalues().unwrap()[1];
        let fine = largest(1e-7);
        for asked in [1e-3, 1e-5] {
            let coarse = largest(asked);
            assert!((coarse.value - fine.value).abs() <= coarse.error + fine.error, "{coarse} {fine}");
        }
    }
}
