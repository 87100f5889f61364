//! One contact segment, followed through the whole argument: the segment of the block's contact edge with the largest term.
use example_report::prelude::*;
use fractional_sobolev::{Constraint, Domain, ErrorNorm, Gram, Mesh, embedding_bound, gamma, interpolation_constant};
use signorini::cone::Cone;
use signorini::contact::Solver;
use signorini::problems::TestProblem;
use signorini::proof::consistency_constant;

example! { quick "Sections 3 and 4, one segment", "the bounds";
    /// segments of the contact edge
    n: usize = "16" in "[4, 32]",
    /// regularity τ in the bounds
    tau: f64 = "1.75" in "(1.5, 2)",
    /// cells
    cells: usize = "32" in "[8, 64]",
}
fn run(options: &Options, out: &mut Report) -> Result<()> {
    let (n, k, tau) = (options.n, options.cells, options.tau);
    let u = TestProblem::Block.problem(n * k)?.solve(Cone::Nodal, Solver::ActiveSet)?;
    let (g, force) = (&u.normal_displacement, &u.multiplier);
    let h = 1.0 / n as f64;
    let term = |s: usize| -> f64 {
        let (a, b) = (s * k, (s + 1) * k);
        (a + 1..b).map(|i| { let t = (i - a) as f64 / k as f64; -force[i] * ((1.0 - t) * g[a] + t * g[b]) }).sum()
    };
    let terms: Vec<f64> = (0..n).map(term).collect();
    eprintln!("{terms:?}");
    let s = (0..n).max_by(|&a, &b| terms[a].total_cmp(&terms[b])).unwrap_or(0);
    let a = s * k;
    let cell = h / k as f64;
    let slopes: Vec<f64> = (a..a + k).map(|i| (g[i + 1] - g[i]) / cell).collect();
    let share = |i: usize| force[i] * if i == 0 { 1.0 } else { 0.5 } / cell;
    let pressure: Vec<f64> = (a..a + k).map(|i| share(i) + share(i + 1)).collect();
    let order = Order::half_plus(tau - 2.0)?;
    let gram = Gram::constants(&Mesh::uniform(k, h)?, order, Tolerance::balanced())?;
    let semi = |x: &[f64]| -> Result<f64> { Ok(gram.apply(x)?.iter().zip(x).map(|(y, x)| x * y).sum::<f64>().sqrt()) };
    let l2 = |x: &[f64]| (x.iter().map(|x| x * x).sum::<f64>() * cell).sqrt();
    let (su, sp) = (semi(&slopes)?, semi(&pressure)?);
    let nu = tau - 1.5;
    let q = 1.0 / (2.0 - tau);
    let c_q = embedding_bound(order, q)?;
    let c_i = interpolation_constant(Domain::Interval(1.0), ErrorNorm::L2, order, 1e-8)?.constant.value;
    let last = (0..=k).filter(|i| g[a + i] >= 0.0).max().unwrap_or(0);
    let r = 1.0 - last as f64 / k as f64;
    let l1: f64 = pressure.iter().sum::<f64>() * cell;
    let depth = g[a].abs().max(g[a + k].abs());
    let first = |theta: f64| c_q * h * theta.powf(1.0 - 1.0 / q) * su.hypot(l2(&slopes)) * sp.hypot(l2(&pressure));
    let second = |theta: f64| -> Result<f64> { Ok(c_i * h.powf(2.0 * tau - 2.0) * gamma(order, Constraint::mean_zero_on(0.0..theta), 1e-6)?.constant.value * su * sp) };
    let theta = h.powf(2.0 * nu);
    let ie: f64 = (0..k).map(|i| { let t = (i as f64 + 0.5) / k as f64; ((1.0 - t) * g[a] + t * g[a + k] - 0.5 * (g[a + i] + g[a + i + 1])).powi(2) * cell }).sum::<f64>().sqrt();
    let kappa = consistency_constant(order, 1e-9)?.value.value;
    eprintln!("s {s} r {r} term {:e} l1*depth {:e} l2*ie {:e} su {su} sp {sp} l2 {} {}  depth {depth:e} l1 {l1}", terms[s], l1 * depth, l2(&pressure) * ie, l2(&slopes), l2(&pressure));
    eprintln!("theta {theta} first {:e} at r {:e} second {:e} at r {:e} half {:e} kappa {:e}", first(theta), first(r), second(theta)?, second(r)?, 0.5 * h.powf(2.0 * nu + 1.0) * su * sp, kappa * h.powf(2.0 * nu + 1.0) * su * sp);
    Ok(())
}
