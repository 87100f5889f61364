//! Extremes: the hardest admissible input gets digits; input without an answer gets an error that
//! names what is wrong.
//!
//! This file computes fourteen hard numbers and compares each with a value found another way. It
//! asks eight questions that have no answer, and shows their error messages whole. The numbers, and
//! their second values:
//!
//! ```text
//! |ramp|_ν, H x/L on (0, L), four linear elements    H L^(1/2−ν) / √((1 − ν)(3 − 2ν))
//! |hat|_(1/2), elements of lengths 1, w, w, 1        √(8 ln 2) as w → 0
//! |step|²_(1/4), 0 and 1 on halves of (0, 1)         (√(1/2) + √(1/2) − 1) / (ν (1 − 2ν)), ν = 1/4
//! γ, mean zero on (0, θ), ν = 1/2                    γ² = A L + c + d/γ² + e/γ⁴, L = ln(1/θ),
//!                                                    A = 3/(2π²) (example `lemma_5_2_exact_law`)
//! γ, mean zero on (0, θ), ν = 3/4                    γ₀ for u(0) = 0 (example `remark_6_..`)
//! contact force of `block` under s times its load    s times that for s = 1
//! J of `block` with E = 2.5 and Poisson's ratio      the same by the interior point method, which
//! 1/2 − 1e-6; lifted; pressed everywhere             shares only the matrices
//! ```
//!
//! where |u|²_ν = ∬ (u(x) − u(y))² / |x − y|^(1+2ν) dx dy, (1.1), and γ is the best constant in
//! ‖u‖₀ ≤ γ |u|_ν, that of Lemma 5.2 in (5.4); u(0) = 0 is the case of Remark 6. `block` is the
//! unit square in plane strain, λ = μ = 1, fixed at y = 1, contact at y = 0, with the load (0, −cos
//! πx), replaced by its linear interpolant between the nodes, and linear elements on 16 × 16
//! squares, each cut from bottom left to top right, with free sides, problem (2.9): J(v) = ½ a(v,
//! v) − l(v) at its minimum; the contact force is −∫ σ_N, the sum of the forces of the floor at the
//! nodes. The load is (0, 1) or (0, −1) for the last two. c, d and e are numbers: N² = A L + c is
//! the squared norm of u ↦ mean on (0, 1) − mean on (0, θ) on a very short zone, and with its
//! representer R and (K u, v) = ∫ (u − ū)(v − v̄) in the scalar product of |·| d = (R, K R), e =
//! (R, K² R); γ² is the fixed point of the formula.
//!
//! With d = |number/second value − 1| and e the sum of both relative errors (0 for a formula, and
//! for the contact force), a number is right if d + e ≤ 1e-9, refuted if d − e > 1e-9, and
//! undecided between; in the same way 2e-3 below. Refuted too if input without an answer gets one,
//! or if its error is not of the kind that the input calls for: a number, a count or an entry out
//! of range, an infinite norm, a value that is not finite (`BAD`). A hard input that gets an error
//! ends the program. Why 1e-9: γ is requested to 1e-10, and Poisson's ratio 1/2 − 1e-6 loses six
//! digits; the others have twelve and more. Refuted too if for θ = 1e-20, 1e-65, .. 1e-290 γ of
//! order 1/2, requested to 1e-3, differs from its law by more than 2e-3.
//!
//! `cargo run --release --example extremes`

use example_report::prelude::*;
use fractional_sobolev::{Constraint, Function, Gram, Mesh, closed_forms, gamma, law};
use signorini::cone::Cone::Nodal;
use signorini::contact::Solver::{ActiveSet, InteriorPoint};
use signorini::mesh::{Part, SideParts, unit_square};
use signorini::problems::{Parameters, TestProblem};
use signorini::{Error as Refusal, Result as Answer};
use std::f64::consts::LN_2;

example! { seconds "Extremes",
    "hard input gets its value to 1e-9, input without an answer an error that names what is wrong";
}

/// The value found, and the same found another way.
struct Pair {
    found: Measured,
    expected: Measured,
}

/// |H x/L|_ν on (0, L) is H L^(1/2−ν) / √((1−ν)(3−2ν)); beside it four linear elements.
fn ramp(order: Order, length: f64, height: f64) -> Answer<Pair> {
    let values = [0.0, 0.25, 0.5, 0.75, 1.0].map(|v| v * height);
    // Closed forms of the double integral, one for each pair of elements; error: their rounding.
    let u = Function::linears(&Mesh::uniform(4, length)?, &values)?;
    let unit = ((1.0 - order.value()) * (3.0 - 2.0 * order.value())).sqrt().recip();
    let expected = height * unit * length.powf(-order.offset());
    Ok(Pair { found: u.seminorm(order, 1e-12)?.into(), expected: expected.into() })
}

/// At ν = 1/2 the seminorm does not see scale: a hat over elements of length w beside 1 tends to
/// √(8 ln 2) as w → 0.
fn hat(w: f64) -> Answer<Measured> {
    let u = Function::linears(&Mesh::from_lengths(&[1.0, w, w, 1.0])?, &[0.0, 0.0, 1.0, 0.0, 0.0])?;
    Ok(u.seminorm(0.5, 1e-12)?.into())
}

/// The form of a step on a million elements by the fast product with the Gram matrix.
fn million_elements() -> Answer<Pair> {
    let n = 1_000_000;
    // The matrix depends on |i − j| only: its product is a convolution, by fast transforms.
    let gram = Gram::constants(&Mesh::uniform(n, 1.0)?, 0.25, 1e-12)?;
    let step: Vec<f64> = (0..n).map(|i| if i < n / 2 { 0.0 } else { 1.0 }).collect();
    let form: f64 = step.iter().zip(gram.apply(&step)?).map(|(x, y)| x * y).sum();
    let expected = closed_forms::jump_seminorm_squared(0.5, 0.5, 0.25)?;
    Ok(Pair { found: form.into(), expected: expected.into() })
}

/// γ of mean zero on (0, 1e-300): γ² is the largest eigenvalue of (‖·‖₀², |·|²) on functions whose
/// slopes are polynomials in ln r, r the distance to the nearest of 0, θ, 1, on elements that grow
/// geometrically away from there; error: the change to a smaller space of that kind.
fn short_zone(nu: f64) -> Answer<Measured> {
    Ok(gamma(nu, Constraint::mean_zero_on(0.0..1e-300), 1e-10)?.constant.into())
}

/// The contact force is proportional to the load: the same code twice, which shows that nothing
/// overflows.
fn scaled_load(scale: f64) -> Answer<Pair> {
    let force = |load_scale| -> Answer<f64> {
        let problem = TestProblem::Block
            .problem_with(16, &Parameters { load_scale, ..Parameters::default() })?;
        Ok(problem.solve(Nodal, ActiveSet)?.contact_force)
    };
    Ok(Pair { found: force(scale)?.into(), expected: (scale * force(1.0)?).into() })
}

/// The energy by the active set and by the interior point, which share no line but the assembly.
fn energies(problem: TestProblem, parameters: &Parameters) -> Answer<Pair> {
    let problem = problem.problem_with(16, parameters)?;
    let [found, expected] = [ActiveSet, InteriorPoint].map(|solver| problem.solve(Nodal, solver));
    let (found, expected) = (found?, expected?);
    Ok(Pair {
        found: (found.energy, found.energy_rounding).into(),
        expected: (expected.energy, expected.energy_rounding).into(),
    })
}

/// A hard number.
struct Hard {
    /// What is hard.
    input: &'static str,
    /// What is computed, and the second value.
    value: &'static str,
    compute: fn() -> Answer<Pair>,
}

const fn hard(input: &'static str, value: &'static str, compute: fn() -> Answer<Pair>) -> Hard {
    Hard { input, value, compute }
}

const HARD: [Hard; 14] = [
    hard("order 1e-300", "|x|_ν, closed form", || ramp(Order::new(1e-300)?, 1.0, 1.0)),
    hard("order 1 − 2^-52", "|x|_ν, closed form", || {
        ramp(Order::new(1.0 - f64::EPSILON)?, 1.0, 1.0)
    }),
    hard("length 1e-300", "|ramp|_ν, scaling", || ramp(Order::new(0.3)?, 1e-300, 1.0)),
    hard("length 1e300", "|ramp|_ν, scaling", || ramp(Order::new(0.9)?, 1e300, 1.0)),
    hard("values of size 1e150", "|ramp|_ν, scaling", || ramp(Order::new(0.7)?, 1.0, 1e150)),
    hard("elements 1e-300 beside 1", "|hat|_ν, √(8 ln 2)", || {
        Ok(Pair { found: hat(1e-300)?, expected: (8.0 * LN_2).sqrt().into() })
    }),
    hard("a million elements", "form of a step, closed form", million_elements),
    hard("zone 1e-300, ν = 1/2", "γ, its law as θ → 0", || {
        Ok(Pair { found: short_zone(0.5)?, expected: law(0.5, 0.0, 1e-10)?.at(1e-300)?.into() })
    }),
    hard("zone 1e-300, ν = 3/4", "γ, that of u(0) = 0", || {
        let limit = gamma(0.75, Constraint::vanishing_at(0.0), 1e-10)?.constant;
        Ok(Pair { found: short_zone(0.75)?, expected: limit.into() })
    }),
    hard("load of size 1e-150", "contact force, scaling", || scaled_load(1e-150)),
    hard("load of size 1e150", "contact force, scaling", || scaled_load(1e150)),
    hard("Poisson's ratio 1/2 − 1e-6", "energy, other solver", || {
        energies(
            TestProblem::Incompressible,
            &Parameters { poisson: 0.5 - 1e-6, ..Parameters::default() },
        )
    }),
    hard("contact nowhere", "energy, other solver", || {
        energies(TestProblem::Free, &Parameters::default())
    }),
    hard("contact everywhere", "energy, other solver", || {
        energies(TestProblem::Closed, &Parameters::default())
    }),
];

/// A question without an answer.
struct Bad {
    /// What is wrong.
    input: &'static str,
    /// The kind of error that it calls for.
    kind: &'static str,
    ask: fn() -> Answer<f64>,
}

const fn bad(input: &'static str, kind: &'static str, ask: fn() -> Answer<f64>) -> Bad {
    Bad { input, kind, ask }
}

const BAD: [Bad; 8] = [
    bad("order NaN", "OutOfRange", || Ok(Order::new(f64::NAN)?.value())),
    bad("a step, order 1/2", "InfiniteNorm", || {
        let step = Function::from_fn(&[0.0, 0.5, 1.0], |x: f64| if x < 0.5 { 0.0 } else { 1.0 })?;
        Ok(step.seminorm(0.5, 1e-3)?.value)
    }),
    bad("|ln x|^0.6, order 1/2", "InfiniteNorm", || {
        Ok(Function::from_fn(&[0.0, 1.0], |x: f64| (-x.ln()).powf(0.6))?.seminorm(0.5, 1e-3)?.value)
    }),
    bad("a function with value NaN", "NotFinite", || {
        let torn = Function::from_fn(&[0.0, 1.0], |x: f64| if x > 0.5 { f64::NAN } else { x })?;
        Ok(torn.seminorm(0.5, 1e-3)?.value)
    }),
    bad("a node given twice", "EntryOutOfRange", || {
        Ok(Mesh::from_nodes(&[0.0, 0.5, 0.5, 1.0])?.total())
    }),
    bad("a zone of length 0, ν = 1/2", "OutOfRange", || {
        Ok(gamma(0.5, Constraint::mean_zero_on(0.0..0.0), 1e-3)?.constant.value)
    }),
    bad("16 digits asked", "OutOfRange", || Ok(Tolerance::new(1e-16)?.relative())),
    bad("a body that nothing holds", "CountOutOfRange", || {
        let free = Part::Neumann;
        let sides = SideParts { bottom: Part::Contact, right: free, top: free, left: free };
        Ok(TestProblem::Block.on(unit_square(4, sides)?)?.solve(Nodal, ActiveSet)?.energy)
    }),
];

fn run(_: &Options, out: &mut Report) -> Result<()> {
    for Hard { input, value, compute } in HARD {
        let Pair { found, expected } = compute()?;
        let error = (found / expected - 1.0).abs();
        let answer = format!("{:.9e}", found.value);
        out.row(cells! { planted: input, beside: value => answer, error: error.value });
        let claim = out.check("relative difference from the reference value");
        claim.whole_error_bars_at_most(error, 1e-9, "accuracy required");
    }
    let mut messages = "The messages:".to_owned();
    for Bad { input, kind, ask } in BAD {
        let (is_named, message) = match ask() {
            Err(Refusal::Toolkit(refusal)) => {
                (format!("{refusal:?}").starts_with(kind), refusal.to_string())
            }
            other => (false, format!("{other:?}")),
        };
        let claim = out.check("invalid inputs without the expected error");
        claim.holds(is_named, "kind of error");
        messages += &format!("\n{input}: {message}");
    }
    out.remark(messages);
    out.column("planted", "input", "");
    out.column("beside", "value", "what is computed, and the reference value");
    out.column("answer", "answer", "the value, or the kind of error: messages below");
    out.column("error", "error", "relative difference from the reference value");

    let zones: Vec<f64> = (20..=290).step_by(45).map(|k| 10f64.powi(-k)).collect();
    let limit = law(0.5, 0.0, 1e-3)?;
    let (mut curve, mut dashed) = (Vec::new(), Vec::new());
    for theta in zones {
        let found =
            Measured::from(gamma(0.5, Constraint::mean_zero_on(0.0..theta), 1e-3)?.constant);
        let law = Measured::from(limit.at(theta)?);
        curve.push((theta, found.value));
        dashed.push((theta, law.value));
        let ratio = found / law;
        let claim = out.check("ν = 1/2: γ/asymptotic law, θ = 1e-20 .. 1e-290");
        claim.whole_error_bars_differ_by_at_most(ratio, 1.0, 2e-3, "1e-3 for each");
    }
    let axes = Axes::LogLinear("θ, length of the zone", "γ");
    out.plot("extremes_zone", "Poincaré constant of order 1/2", axes)
        .line("computed", curve)
        .dashed_line("law as θ → 0", dashed);
    Ok(())
}
