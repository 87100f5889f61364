//! Beside other programs: the same work on the same machine, seconds and error of each.
//!
//! Three tasks, each done by scripts that a reader can run (`benches/peers`, in Python):
//!
//! ```text
//! contact     the block on a rigid floor, linear elements on n × n squares, each cut in two:
//!             J(u^h) = min J over the nodal cone,  J(v) = ½ a(v, v) − l(v)
//! laplacian   (−Δ)^s u = 1 on (−1, 1), u = 0 outside, N linear elements: the energy ∫ u^h;
//!             equal elements, or graded: the nodes −1 + (2k/N)^4 and their mirror images
//! seminorm    |x^a|² of order s on (0, 1)
//! ```
//!
//! The block is the unit square in plane strain, λ = μ = 1, clamped at y = 1, with free sides,
//! under the load f = (0, −cos πx), interpolated at the nodes, with u_y ≥ 0 at the nodes of y = 0;
//! squares are cut from bottom left to top right. u^h is (2.9) of the paper and |·|_s its seminorm
//! (1.1); the paper has no fractional Laplacian, whose form is
//!
//! ```text
//! a(u, v) = c/2 ∬ (u(x) − u(y)) (v(x) − v(y)) / |x − y|^(1+2s) dx dy over ℝ²,
//! c = 4^s s Γ(s + 1/2) / (π^(1/2) Γ(1 − s)).
//! ```
//!
//! The tasks are done by scikit-fem and NGSolve with a primal-dual active set written by hand, by
//! NumPy's dense matrix, and by SciPy's adaptive double integral. The file `results.json` keeps
//! what `run.py` measured: processor seconds, and the numbers found. The lines of the file, over
//! which the loops run: the block for n = 64, 128, 256, 512 by all three programs; the Laplacian
//! for s = 1/4, 1/2, 3/4, equal and graded, N = 1024, 2048, 4096 by NumPy and 1024, 4096, 16384,
//! 65536 by this library, of which equal 1024 and 4096 are compared and graded 4096 and 65536 are
//! rows; and (a, s) = (0.5, 0.3), (1.3, 0.9), (0.3, 0.7), (0.1, 0.58). This file computes none of
//! the seconds. It computes what the numbers should be,
//!
//! ```text
//! J(u^h)    by this library, the same discrete problem;
//! ∫ u       = π 4^(−s) / (Γ(s + 1/2) Γ(s + 3/2)), Getoor's solution u = c (1 − x²)^s;
//! |x^a|²    by Beta functions,
//! ```
//!
//! and the column `error` is relative to them: it is rounding in the first task; 1 − ∫ u^h/∫ u in
//! the second, the error of the elements, or of NumPy's matrix where that is larger; and the error
//! of quadrature in the third.
//!
//! Refuted if J by two programs differs by more than 1e-9, relatively, or ∫ u^h on equal elements
//! by more than 1e-6; if ∫ u^h of this library is above ∫ u by more than 1e-11 of it, since −½ ∫
//! u^h is a minimum over fewer functions; or if its seminorm, computed again, is off by more than
//! its stated error. No check compares seconds. These bounds are chosen: 1e-9 is far above the
//! rounding of half a million unknowns, 1e-11 above that of ∫ u^h, and 1e-6 above what NumPy's
//! matrix loses. No number has an error bar; that of the seminorm is the denominator of its check.

use example_report::prelude::*;
use fractional_sobolev::{Function, Gram, Mesh, closed_forms};
use serde_json::Value;
use signorini::{cone::Cone, contact::Solver, problems::TestProblem};
use std::f64::consts::PI;

example! { seconds "Beside other programs",
    "the same work on one machine: seconds, and the error of each";
    /// block: n × n squares
    n: Vec<usize> = "256,512" in "[2, 512]",
    /// equal elements of the interval
    elements: Vec<usize> = "1024,4096" in "[2, 65536]",
}

/// What `benches/peers/run.py` measured.
const KEPT: &str = include_str!("../benches/peers/results.json");
/// The program of this library's lines.
const OURS: &str = "this library";

/// A line of the file.
struct Line(Value);

impl Line {
    /// A number of the line.
    fn get(&self, key: &str) -> Option<f64> {
        self.0[key].as_f64()
    }

    fn number(&self, key: &str) -> f64 {
        self.get(key).unwrap_or(f64::NAN)
    }

    fn word(&self, key: &str) -> String {
        self.0[key].as_str().unwrap_or_default().to_owned()
    }
}

/// The lines of a task.
fn lines(task: &str) -> Result<Vec<Line>> {
    let kept: Value = serde_json::from_str(KEPT)
        .map_err(|error| Error::file("benches/peers/results.json".as_ref(), error))?;
    let all = kept["lines"].as_array().cloned().unwrap_or_default();
    Ok(all.into_iter().filter(|line| line["task"] == task).map(Line).collect())
}

/// Γ(x) for x > 0: x Γ(x) = Γ(x + 1) up to 20, then Stirling's series; 14 digits.
fn gamma(x: f64) -> f64 {
    if x < 20.0 {
        return gamma(x + 1.0) / x;
    }
    let terms = [1.0 / 12.0, -1.0 / 360.0, 1.0 / 1260.0, -1.0 / 1680.0];
    let series: f64 = (0..4).map(|k| terms[k] / x.powi(2 * k as i32 + 1)).sum();
    (2.0 * PI / x).sqrt() * (x * x.ln() - x + series).exp()
}

/// ∫ u^h on N equal elements, by the toolkit.
fn energy(s: f64, elements: usize) -> Result<f64> {
    let mesh = Mesh::uniform(elements, 2.0)?;
    let half = 0.5 * closed_forms::fractional_laplacian_constant(s)?.value;
    let form = Gram::zero_outside(&mesh, s, 1e-12)?;
    let load = vec![2.0 / elements as f64 / half; form.len()];
    Ok(half * form.solve(&load)?.1.value)
}

/// Curves by name, a point at a time.
type Curves = Vec<(String, Vec<(f64, f64)>)>;

fn push(curves: &mut Curves, name: &str, point: (f64, f64)) {
    match curves.iter_mut().find(|(known, _)| known == name) {
        Some((_, points)) => points.push(point),
        None => curves.push((name.to_owned(), vec![point])),
    }
}

/// One discrete problem: the programs differ by rounding only.
fn contact(options: &Options, out: &mut Report) -> Result<()> {
    let mut curves = Curves::new();
    for line in lines("contact")? {
        let (n, program) = (line.number("n"), line.word("program"));
        let (data, solve) = (line.get("data s"), line.number("solution s"));
        push(&mut curves, &program, (n, data.unwrap_or(0.0) + solve));
        if options.n.iter().any(|&shown| shown as f64 == n) {
            let problem = TestProblem::Block.problem(n as usize)?;
            let u = problem.solve(Cone::Nodal, Solver::Auto)?;
            let error = (line.number("J") / u.energy - 1.0).abs();
            let task = format!("block, n = {n}");
            if program != OURS {
                let claim = out.check("J of another program, relative difference");
                claim.at_most(error, 1e-9, "one discrete problem");
            }
            out.row(cells! { task, program => data, product: None::<f64>, solve, error });
        }
    }
    let plot = out.plot("peers_contact", "The block in contact", Axes::LogLog("n", "seconds"));
    for (name, points) in curves {
        plot.line(&name, points);
    }
    Ok(())
}

/// The discrete minimum is one number on equal elements, and below ∫ u on all.
fn laplacian(options: &Options, out: &mut Report) -> Result<()> {
    let mut curves = Curves::new();
    for line in lines("laplacian")? {
        let (s, n) = (line.number("s"), line.number("N"));
        let (program, mesh) = (line.word("program"), line.word("mesh"));
        let exact = PI * 4f64.powf(-s) / (gamma(s + 0.5) * gamma(s + 1.5));
        let found = line.number("energy");
        let error = 1.0 - found / exact;
        let (data, product, solve) =
            (line.get("data s"), line.number("product s"), line.number("solution s"));
        if program != OURS
            && mesh == "equal"
            && options.elements.iter().any(|&shown| shown as f64 == n)
        {
            let claim = out.check("∫ u^h of another program, relative difference");
            let apart = (found / energy(s, n as usize)? - 1.0).abs();
            claim.at_most(apart, 1e-6, "one discrete problem");
        }
        if program == OURS {
            out.check("(∫ u^h − ∫ u)/∫ u of this library").at_most(
                -error,
                1e-11,
                "fewer functions",
            );
        }
        if s == 0.5 {
            let seconds = data.unwrap_or(0.0) + solve;
            push(&mut curves, &format!("{program}, {mesh}"), (seconds, error.abs()));
        }
        if mesh == "graded" && (n == 4096.0 || n == 65_536.0) {
            let task = format!("s = {s}, N = {n}");
            out.row(cells! { task, program => data, product, solve, error });
        }
    }
    let axes = Axes::LogLog("seconds", "relative error of the energy");
    let plot = out.plot("peers_laplacian", "(−Δ)^s u = 1, s = 1/2", axes);
    for (name, points) in curves {
        plot.line(&name, points);
    }
    Ok(())
}

fn seminorm(out: &mut Report) -> Result<()> {
    for line in lines("seminorm")? {
        let (a, s, program) = (line.number("a"), line.number("s"), line.word("program"));
        let exact = closed_forms::power_seminorm_squared(a, s)?.value;
        let error = (line.number("square") / exact - 1.0).abs();
        if program == OURS {
            let now = Function::from_fn(&[0.0, 1.0], |x| x.powf(a))?.seminorm(s, 1e-8)?;
            let off = (now.value - exact.sqrt()).abs();
            let claim = out.check("error of the toolkit's seminorm/its stated error");
            claim.at_most(off / now.error, 1.0, "stated");
        }
        let (task, solve) = (format!("|x^{a}|, s = {s}"), line.number("processor s"));
        out.row(cells! { task, program => data: None::<f64>, product: None::<f64>, solve, error });
    }
    Ok(())
}

fn run(options: &Options, out: &mut Report) -> Result<()> {
    out.column("data", "data, s", "processor seconds of one thread: mesh and matrix");
    out.column("product", "product, s", "of a product with the matrix");
    out.column("solve", "solution, s", "of the solution, or of the double integral");
    out.column("error", "error", "relative: of J, of ∫ u, of |x^a|²");
    contact(options, out)?;
    laplacian(options, out)?;
    seminorm(out)
}
