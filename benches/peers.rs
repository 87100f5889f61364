//! The work of the scripts in `benches/peers` by the two libraries, in processor seconds of all threads: the block in contact,
//! (−Δ)^s u = 1 on an interval, and the seminorm of a power. `cargo bench --package signorini-benches --bench peers`

use fractional_sobolev::{Function, Gram, Mesh, closed_forms};
use signorini::cone::Cone;
use signorini::contact::Solver;
use signorini::problems::TestProblem;
use std::error::Error;

/// Processor seconds of this process so far, to 1/100 s: fields 14 and 15 of /proc/self/stat.
fn processor() -> f64 {
    let text = std::fs::read_to_string("/proc/self/stat").unwrap_or_default();
    let fields: Vec<f64> = text
        .rsplit(')')
        .next()
        .unwrap_or("")
        .split_whitespace()
        .skip(11)
        .take(2)
        .flat_map(str::parse)
        .collect();
    fields.iter().sum::<f64>() / 100.0
}

/// Processor seconds of f: the mean over so many runs that they take a quarter of a second.
fn timed<T>(mut f: impl FnMut() -> Result<T, Box<dyn Error>>) -> Result<(T, f64), Box<dyn Error>> {
    let start = processor();
    let mut runs = 1.0;
    loop {
        let result = f()?;
        let taken = processor() - start;
        if taken > 0.25 {
            return Ok((result, taken / runs));
        }
        runs += 1.0;
    }
}

fn contact() -> Result<(), Box<dyn Error>> {
    println!("   n  data s  solution s  nodes in contact  J");
    for n in [64, 128, 256, 512] {
        let (problem, data) = timed(|| Ok(TestProblem::Block.problem(n)?))?;
        let (u, seconds) = timed(|| Ok(problem.solve(Cone::Nodal, Solver::Auto)?))?;
        println!(
            "{n:4}  {data:6.3}  {seconds:10.3}  {:16}  {:.15e}",
            u.contact_set.count(),
            u.energy
        );
    }
    Ok(())
}

fn laplacian() -> Result<(), Box<dyn Error>> {
    println!("\n   s      N  mesh    data s  product s  solution s  energy            rel. error");
    for s in [0.25, 0.5, 0.75] {
        // ∫ u of Getoor's solution u = c (1 − x²)^s: 2^(−2s) π/(Γ(s + 1/2) Γ(s + 3/2)).
        let exact =
            std::f64::consts::PI / (4f64.powf(s) * libm::tgamma(s + 0.5) * libm::tgamma(s + 1.5));
        let form_constant = 0.5 * closed_forms::fractional_laplacian_constant(s)?.value;
        for n in [1024, 4096, 16_384, 65_536] {
            for graded in [false, true] {
                let half =
                    |k: usize| (2.0 * k as f64 / n as f64).powf(if graded { 4.0 } else { 1.0 });
                let lengths: Vec<f64> = (0..n / 2).map(|k| half(k + 1) - half(k)).collect();
                let lengths: Vec<f64> =
                    lengths.iter().chain(lengths.iter().rev()).copied().collect();
                let mesh = Mesh::from_lengths(&lengths)?;
                let load: Vec<f64> =
                    lengths.windows(2).map(|h| 0.5 * (h[0] + h[1]) / form_constant).collect();
                let (form, prepared) = timed(|| {
                    let form = Gram::zero_outside(&mesh, s, 1e-10)?;
                    form.apply(&load)?;
                    Ok(form)
                })?;
                let (_, product) = timed(|| Ok(form.apply(&load)?))?;
                let ((_, energy), solution) = timed(|| Ok(form.solve(&load)?))?;
                let (energy, name) =
                    (form_constant * energy.value, if graded { "graded" } else { "equal" });
                println!(
                    "{s:4}  {n:5}  {name:6}  {prepared:13.3}  {product:9.6}  {solution:10.3}  {energy:.14}  {:10.1e}",
                    1.0 - energy / exact
                );
            }
        }
    }
    Ok(())
}

fn seminorm() -> Result<(), Box<dyn Error>> {
    println!("\n   a     s  processor s  square              stated error  true error");
    for (a, s) in [(0.5, 0.3), (1.3, 0.9), (0.3, 0.7), (0.1, 0.58)] {
        let exact = closed_forms::power_seminorm_squared(a, s)?.value;
        let (found, seconds) =
            timed(|| Ok(Function::from_fn(&[0.0, 1.0], |x| x.powf(a))?.seminorm(s, 1e-8)?))?;
        let (square, stated) = (found.value.powi(2), 2.0 * found.error / found.value);
        println!(
            "{a:4}  {s:4}  {seconds:11.4}  {square:.16}  {stated:12.1e}  {:10.1e}",
            (square / exact - 1.0).abs()
        );
    }
    Ok(())
}

fn main() -> Result<(), Box<dyn Error>> {
    contact()?;
    laplacian()?;
    seminorm()
}
