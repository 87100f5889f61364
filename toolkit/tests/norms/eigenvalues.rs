//! Extreme eigenvalues of (Gram, mass) on intervals, against dense matrices and a value from the literature.

use crate::common::SplitMix;
use fractional_sobolev::closed_forms::fractional_laplacian_constant;
use fractional_sobolev::{Error, Gram, Mesh, Result};
use nalgebra::{Cholesky, DMatrix, SymmetricEigen};

/// Dense reduction by the mass matrix loses this much of the largest eigenvalue.
const DENSE: f64 = 1e-13;

fn unequal(count: usize, decades: f64) -> Result<Mesh> {
    let mut random = SplitMix::new(1);
    Mesh::from_lengths(
        &(0..count).map(|_| 10f64.powf(decades * random.uniform())).collect::<Vec<_>>(),
    )
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
    for mesh in [
        Mesh::uniform(200, 2.0)?,
        unequal(200, 0.5)?,
        unequal(200, 3.0)?,
        Mesh::algebraic(200, 3.0, 1.0)?,
    ] {
        for s in [0.3, 0.5, 0.8] {
            let mut forms =
                vec![(Gram::new(&mesh, s, 1e-7)?, 1), (Gram::zero_outside(&mesh, s, 1e-7)?, 0)];
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
    let mesh = Mesh::from_lengths(
        &lengths.iter().chain(lengths.iter().rev()).copied().collect::<Vec<_>>(),
    )?;
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
        let largest =
            |asked| Gram::new(&mesh, 0.5, asked).unwrap().extreme_eigenvalues().unwrap()[1];
        let fine = largest(1e-7);
        for asked in [1e-3, 1e-5] {
            let coarse = largest(asked);
            assert!(
                (coarse.value - fine.value).abs() <= coarse.error + fine.error,
                "{coarse} {fine}"
            );
        }
    }
}

/// The smallest positive eigenvalue of (A, M) for piecewise constants, by inverse iteration. A is a sum of squares of
/// differences: elimination keeps this form, without subtraction.
fn smallest_by_elimination(form: &Gram, mesh: &Mesh) -> Result<f64> {
    let (a, n) = (form.to_dense()?, form.len());
    let mut links = DMatrix::from_fn(n, n, |i, j| if i == j { 0.0 } else { -a[(i, j)] });
    let mut sums = vec![0.0; n];
    for k in 0..n - 1 {
        sums[k] = (k + 1..n).map(|j| links[(k, j)]).sum();
        for i in k + 1..n {
            for j in k + 1..n {
                if i != j {
                    links[(i, j)] += links[(i, k)] * links[(k, j)] / sums[k];
                }
            }
        }
    }
    let masses = mesh.lengths();
    let total: f64 = masses.iter().sum();
    let mut x: Vec<f64> = (0..n).map(|i| (1.3 * i as f64).cos()).collect();
    let (mut value, mut before) = (0.0, f64::INFINITY);
    // The steps are small where the second eigenvalue is near.
    while (before - value).abs() > 1e-15 * value {
        before = value;
        let mean = x.iter().zip(masses).map(|(x, m)| x * m).sum::<f64>() / total;
        let load: Vec<f64> = x.iter().zip(masses).map(|(x, m)| (x - mean) * m).collect();
        let mut y = load.clone();
        for k in 0..n - 1 {
            for i in k + 1..n {
                y[i] += links[(i, k)] / sums[k] * y[k];
            }
        }
        y[n - 1] = 0.0;
        for k in (0..n - 1).rev() {
            y[k] = (y[k] + (k + 1..n).map(|j| links[(k, j)] * y[j]).sum::<f64>()) / sums[k];
        }
        let form: f64 = y.iter().zip(&load).map(|(y, f)| y * f).sum();
        let mean = y.iter().zip(masses).map(|(y, m)| y * m).sum::<f64>() / total;
        let size: f64 = y.iter().zip(masses).map(|(y, m)| m * (y - mean).powi(2)).sum();
        value = form / size;
        x = y.iter().map(|y| (y - mean) / size.sqrt()).collect();
    }
    Ok(value)
}

/// The same for hat functions, by Cholesky factors of A + σ m mᵀ, m = M 1, scaled to a diagonal of 1: constants have the
/// eigenvalue σ times the length.
fn smallest_by_factors(form: &Gram, mesh: &Mesh) -> Result<f64> {
    let (mut a, n) = (form.to_dense()?, form.len());
    let m = form.mass(&vec![1.0; n])?;
    let total: f64 = mesh.lengths().iter().sum();
    // of the size of A: a much larger shift would round it away
    let shift = a.diagonal().sum() / total.powi(2);
    for i in 0..n {
        for j in 0..n {
            a[(i, j)] += shift * m[i] * m[j];
        }
    }
    let units: Vec<f64> = (0..n).map(|i| a[(i, i)].sqrt().recip()).collect();
    let scaled = DMatrix::from_fn(n, n, |i, j| units[i] * a[(i, j)] * units[j]);
    let factor = Cholesky::new(scaled).expect("positive definite");
    let mut x: Vec<f64> = (0..n).map(|i| (1.3 * i as f64).cos()).collect();
    let (mut value, mut before) = (0.0, f64::INFINITY);
    // The steps are small where the second eigenvalue is near.
    while (before - value).abs() > 1e-15 * value {
        before = value;
        let mean = x.iter().zip(&m).map(|(x, m)| x * m).sum::<f64>() / total;
        let centred: Vec<f64> = x.iter().map(|x| x - mean).collect();
        let load = form.mass(&centred)?;
        let right = nalgebra::DVector::from_fn(n, |i, _| units[i] * load[i]);
        let found = factor.solve(&right);
        let y: Vec<f64> = (0..n).map(|i| units[i] * found[i]).collect();
        let form_of: f64 = y.iter().zip(&load).map(|(y, f)| y * f).sum();
        let size: f64 = y.iter().zip(form.mass(&y)?).map(|(y, m)| y * m).sum();
        value = form_of / size;
        x = y.iter().map(|y| y / size.sqrt()).collect();
    }
    Ok(value)
}

#[test]
fn smallest_eigenvalues_of_random_unequal_meshes() -> Result<()> {
    let mut random = crate::hard::seeded(51);
    let (mut tried, mut refused) = (0, 0);
    for _ in 0..crate::hard::cases(2400) {
        let count = 4 + random.below(6);
        let lengths: Vec<f64> =
            (0..count).map(|_| 10f64.powf(random.between(-12.0, 0.0))).collect();
        let mesh = Mesh::from_lengths(&lengths)?;
        let below = 10f64.powf(random.between(-7.0, -1.0));
        let (form, exact) = if random.below(2) == 0 {
            let s = if random.below(2) == 0 { random.between(0.02, 0.48) } else { 0.5 - below };
            let form = Gram::constants(&mesh, s, 1e-10)?;
            let exact = smallest_by_elimination(&form, &mesh)?;
            (form, exact)
        } else {
            let s = if random.below(2) == 0 { random.between(0.1, 0.6) } else { 0.5 + below };
            let form = Gram::new(&mesh, s, 1e-10)?;
            let exact = smallest_by_factors(&form, &mesh)?;
            (form, exact)
        };
        tried += 1;
        let low = match form.extreme_eigenvalues() {
            Ok([low, high]) => {
                let largest = dense_eigenvalues(&form)?[form.len() - 1];
                let apart = (high.value - largest).abs();
                assert!(
                    apart <= high.error + 1e-11 * largest,
                    "{lengths:?} {form:?}: {high}, {largest}"
                );
                low
            }
            Err(error) => {
                refused += 1;
                // The best value may be that of the largest eigenvalue.
                match error.best() {
                    Some(best) if best.value < 10.0 * exact => best,
                    _ => continue,
                }
            }
        };
        let apart = (low.value - exact).abs();
        assert!(apart <= low.error + 1e-11 * exact, "{lengths:?} {form:?}: {low}, {exact}");
    }
    println!("smallest eigenvalues: {tried} tried, {refused} refused");
    assert!(100 * refused <= tried, "{refused} of {tried} refused");
    Ok(())
}

/// The second eigenvalue is 3.99e9, of which a block of three vectors once saw only the third one, 2.0e10.
#[test]
fn an_eigenvalue_that_the_block_has_not_seen_is_counted() -> Result<()> {
    let lengths = [
        5.618_374_335_365_645e-11,
        1.583_047_592_573_932_2e-10,
        1.899_398_179_693_843e-5,
        7.846_720_297_350_06e-11,
        0.061_493_194_174_350_44,
    ];
    // 60 digits
    let exact = 197_036.563_664_394_57;
    for asked in [1e-10, 1e-8, 1e-6] {
        let form =
            Gram::constants(&Mesh::from_lengths(&lengths)?, 0.433_917_194_934_909_27, asked)?;
        let [low, _] = form.extreme_eigenvalues()?;
        assert!((low.value - exact).abs() <= low.error, "{asked:e}: {low}");
    }
    Ok(())
}

/// The shortest element stands beside one a million times as long, which outweighed it in the start vector: the largest
/// eigenvalue was 1.8e12.
#[test]
fn the_largest_eigenvalue_beside_a_long_element() -> Result<()> {
    let lengths = [
        6.632_537_977_725_349e-8,
        0.440_871_814_557_295,
        0.026_522_258_319_289_973,
        0.160_476_561_698_425_28,
        3.400_768_914_401_899e-7,
        0.269_713_324_858_539_16,
        9.605_052_640_175_275e-6,
        9.165_661_417_677_115e-12,
    ];
    for s in [0.45, 0.499, 0.499_999] {
        let form = Gram::constants(&Mesh::from_lengths(&lengths)?, s, 1e-10)?;
        let (largest, [_, high]) = (dense_eigenvalues(&form)?[7], form.extreme_eigenvalues()?);
        assert!((high.value - largest).abs() <= high.error + DENSE * largest, "{high}, {largest}");
    }
    Ok(())
}

/// More functions than eigenvalues are counted for.
#[test]
fn smallest_eigenvalues_of_many_unequal_elements() -> Result<()> {
    let mut random = crate::hard::seeded(52);
    let mut refused = 0;
    let tried = crate::hard::cases(200);
    for _ in 0..tried {
        let count = 129 + random.below(60);
        let decades = random.between(0.5, 12.0);
        let lengths: Vec<f64> =
            (0..count).map(|_| 10f64.powf(-decades * random.uniform())).collect();
        let mesh = Mesh::from_lengths(&lengths)?;
        let s = random.between(0.02, 0.48);
        let form = Gram::constants(&mesh, s, 1e-9)?;
        let exact = smallest_by_elimination(&form, &mesh)?;
        match form.extreme_eigenvalues() {
            Ok([low, _]) => {
                let apart = (low.value - exact).abs();
                assert!(apart <= low.error + 1e-11 * exact, "{s} {lengths:?}: {low}, {exact}");
            }
            Err(_) => refused += 1,
        }
    }
    println!("many unequal elements: {tried} tried, {refused} refused");
    assert!(100 * refused <= tried, "{refused} of {tried} refused");
    Ok(())
}

/// Hat functions at a large order: residuals in the norm of M⁻¹ were 5e4 times the eigenvalue, by rounding alone.
#[test]
fn a_group_of_short_elements_between_long_ones_does_not_hide_the_smallest_eigenvalue() -> Result<()>
{
    // 60 digits
    for (case, exact) in [(41, 153.877_962_397_899_53), (55, 3.650_334_790_147_717)] {
        let mut drawn = (Vec::new(), 0.0);
        let mut random = SplitMix::new(5);
        for _ in 0..=case {
            let count = 10 + random.below(119);
            let decades = random.between(0.5, 12.0);
            let lengths = (0..count).map(|_| 10f64.powf(-decades * random.uniform())).collect();
            random.uniform();
            drawn = (lengths, random.between(0.02, 0.98));
        }
        let (lengths, s) = drawn;
        let [low, _] = Gram::new(&Mesh::from_lengths(&lengths)?, s, 1e-9)?.extreme_eigenvalues()?;
        assert!((low.value - exact).abs() <= low.error.min(1e-12 * exact), "{low}, {exact}");
    }
    Ok(())
}

/// Σ a_ii x_i² is so many times the smallest eigenvalue that rounding of xᵀ(A x) alone was above the tolerance.
#[test]
fn rounding_of_the_form_does_not_limit_the_smallest_eigenvalue() -> Result<()> {
    let mesh = unequal(4000, 3.0)?;
    for form in [Gram::new(&mesh, 0.5, 1e-11)?, Gram::zero_outside(&mesh, 0.5, 1e-11)?] {
        let [low, _] = form.extreme_eigenvalues()?;
        assert!(low.relative_error() <= 2.2e-11, "{low}");
    }
    Ok(())
}
