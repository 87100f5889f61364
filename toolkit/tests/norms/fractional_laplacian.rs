//! The integral fractional Laplacian on an interval: its matrix, its constant, solutions and rates.

use fractional_sobolev::closed_forms::{fractional_laplacian_constant, hat_seminorm_squared};
use fractional_sobolev::{Error, Gram, Mesh, Result};

/// Dense factors of a few hundred unknowns lose this much.
const DENSE: f64 = 1e-11;

/// Observed orders oscillate about their limit by less.
const ORDER: f64 = 0.03;

fn graded(count: usize, exponent: f64) -> Result<Mesh> {
    let half = Mesh::algebraic(count / 2, exponent, 1.0)?;
    let lengths = half.lengths();
    Mesh::from_lengths(&lengths.iter().chain(lengths.iter().rev()).copied().collect::<Vec<_>>())
}

/// ∫ φ_i of the inner hats.
fn load_of_one(mesh: &Mesh) -> Vec<f64> {
    mesh.lengths().windows(2).map(|h| 0.5 * (h[0] + h[1])).collect()
}

/// ∫ u for (−Δ)^s u = 1 on (−1, 1): Γ(1/2) Γ(1 + s)/(Γ(3/2 + s) Γ(1 + 2s)), by mpmath to 20 digits.
const ENERGIES: [(f64, f64); 3] = [
    (0.25, 1.972_450_079_459_092_6),
    (0.5, std::f64::consts::FRAC_PI_2),
    (0.75, 1.081_565_184_107_655_6),
];

/// C(1, s) ‖u − u_h‖²/2 relative to the energy, by Galerkin orthogonality.
fn relative_error(mesh: &Mesh, s: f64, exact: f64) -> Result<(f64, u64)> {
    let half = 0.5 * fractional_laplacian_constant(s)?.value;
    let load: Vec<f64> = load_of_one(mesh).iter().map(|b| b / half).collect();
    let (_, energy) = Gram::zero_outside(mesh, s, 1e-13)?.solve(&load)?;
    Ok(((1.0 - half * energy.value / exact).sqrt(), energy.work.iterations))
}

#[test]
fn the_diagonal_is_the_seminorm_of_a_hat_on_the_line() -> Result<()> {
    let mesh = Mesh::from_lengths(&[0.2, 1e-6, 0.3, 0.1, 2.0])?;
    for s in [0.05, 0.5, 0.93] {
        let dense = Gram::zero_outside(&mesh, s, 1e-12)?.to_dense()?;
        for (i, h) in mesh.lengths().windows(2).enumerate() {
            // Half lines as elements so long that what lies beyond them is below rounding.
            let far = 1e40f64.powf(0.5 / s).min(1e200);
            let hat = hat_seminorm_squared(far, h[0], h[1], far, s)?.value;
            assert!((dense[(i, i)] / hat - 1.0).abs() < 1e-12, "{s} {i}: {} {hat}", dense[(i, i)]);
        }
    }
    Ok(())
}

#[test]
fn products_and_solutions_are_those_of_the_dense_matrix() -> Result<()> {
    for mesh in
        [Mesh::uniform(300, 1.0)?, graded(300, 4.0)?, Mesh::graded(&[0.0, 0.3, 1.0], 15, 0.5)?]
    {
        for s in [0.1, 0.5, 0.9] {
            let form = Gram::zero_outside(&mesh, s, 1e-13)?;
            let dense = form.to_dense()?;
            let load = load_of_one(&mesh);
            let (x, energy) = form.solve(&load)?;
            let n = form.len();
            let scale: Vec<f64> = (0..n).map(|i| dense[(i, i)].sqrt()).collect();
            let scaled = dense.map_with_location(|i, j, a| a / scale[i] / scale[j]);
            let b = nalgebra::DVector::from_fn(n, |i, _| load[i] / scale[i]);
            let exact = nalgebra::Cholesky::new(scaled).expect("positive definite").solve(&b);
            let dense_energy = b.dot(&exact);
            assert!(
                (energy.value / dense_energy - 1.0).abs() < DENSE,
                "{s}: {energy} {dense_energy}"
            );
            assert!((energy.value - dense_energy).abs() <= energy.error + DENSE * dense_energy);
            let largest = x.iter().fold(0.0f64, |m, x| m.max(x.abs()));
            let worst = (0..n).map(|i| (x[i] - exact[i] / scale[i]).abs()).fold(0.0, f64::max);
            assert!(worst < 1e-9 * largest, "{s}: {worst:e} of {largest:e}");
        }
    }
    Ok(())
}

#[test]
fn orders_are_one_half_on_uniform_and_two_minus_s_on_graded_meshes() -> Result<()> {
    for (s, exact) in ENERGIES {
        for (theory, exponent) in [(0.5, 1.0), (2.0 - s, 2.0 * (2.0 - s))] {
            let error =
                |n: usize| Ok::<_, Error>(relative_error(&graded(n, exponent)?, s, exact)?.0);
            let order = (error(500)? / error(1000)?).log2();
            // At the exponent 2(2 − s) both ends contribute a logarithm.
            let tolerance = if exponent > 1.0 { 0.1 } else { ORDER };
            assert!(
                (order - theory).abs() < tolerance,
                "s = {s}, exponent {exponent}: order {order}"
            );
        }
    }
    Ok(())
}

#[test]
fn the_energy_is_known_to_its_error_on_a_hundred_thousand_unequal_elements() -> Result<()> {
    let (s, exact) = ENERGIES[2];
    let (error, iterations) = relative_error(&graded(100_000, 2.0 * (2.0 - s))?, s, exact)?;
    // n^{s−2} with the factor of coarse meshes: products must keep 1e-12 of the energy.
    let expected = 1.6 * 1e5f64.powf(s - 2.0);
    assert!(
        error > 0.5 * expected && error < 4.0 * expected,
        "{s}: {error:e} against {expected:e}"
    );
    assert!(iterations <= 26);
    Ok(())
}

#[test]
fn iterations_depend_neither_on_the_number_of_elements_nor_on_the_grading() -> Result<()> {
    for (s, exact) in ENERGIES {
        for exponent in [1.0, 2.0 * (2.0 - s), 8.0] {
            for n in [100, 1000, 10_000] {
                let (_, iterations) = relative_error(&graded(n, exponent)?, s, 1.001 * exact)?;
                assert!(iterations <= 26, "s = {s}, exponent {exponent}, {n}: {iterations}");
            }
        }
    }
    Ok(())
}

#[test]
fn a_load_with_a_mean_is_refused_where_constants_have_no_seminorm() -> Result<()> {
    let mesh = Mesh::uniform(10, 1.0)?;
    assert!(matches!(
        Gram::new(&mesh, 0.5, 1e-8)?.solve(&[1.0; 11]),
        Err(Error::OutOfRange { .. })
    ));
    assert!(matches!(
        Gram::zero_outside(&Mesh::uniform(1, 1.0)?, 0.5, 1e-8),
        Err(Error::CountOutOfRange { .. })
    ));
    let (x, energy) = Gram::zero_outside(&mesh, 0.5, 1e-8)?.solve(&[0.0; 9])?;
    assert!(x == [0.0; 9] && energy.value == 0.0);
    let form = Gram::constants(&mesh, 0.3, 1e-10)?;
    let x: Vec<f64> = (0..10).map(|i| i as f64 - 4.5).collect();
    let (solved, _) = form.solve(&form.apply(&x)?)?;
    assert!(solved.iter().zip(&x).all(|(a, b)| (a - b).abs() < 1e-8), "{solved:?}");
    Ok(())
}
