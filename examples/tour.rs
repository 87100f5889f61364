//! The paper in one run: the steps of its proof, what each says, what is computed, and whether it
//! is so.
//!
//! Every step runs an example, which returns the numbers that it is known for; the formula behind a
//! number stands in the file of that example. The last column follows from the checks of the
//! example:
//!
//! ```text
//! true               every claim holds;
//! loose              a stronger statement holds too;
//! not sharp          another rate of growth holds;
//! [a]                a form as printed fails; below the table is where it is true.
//! ```
//!
//! Refuted if a check of one of the examples fails.
//!
//! `cargo run --release --example tour -- --out out`

#![allow(clippy::duplicate_mod, reason = "twins share a file")]

use example_report::prelude::*;
use example_report::{Decision, Declarations, Outcome, Role};
use signorini::cone::Cone;

/// The examples are loaded here.
macro_rules! examples {
    ($($name:ident: $file:literal),* $(,)?) => {
        $(
            #[path = $file]
            #[allow(dead_code, reason = "only `run` is used here")]
            mod $name;
        )*
    };
}
examples! {
    block: "section_2_elastic_contact.rs",
    falk: "falk_terms.rs",
    figure_3_2: "figure_3_2_alternative.rs",
    figure_4_1: "figure_4_1_alternative.rs",
    lemma_5_2: "lemma_5_2_poincare_scaling.rs",
    lemma_6_1: "lemma_6_1_local_estimate.rs",
    theorem_3_1: "theorem_3_1_rates.rs",
    theorem_4_1: "theorem_4_1_rates.rs",
}

example! { long "Hild & Renard 2012",
    "an a priori error analysis of Signorini's problem, step by step";
    /// regularities τ of the last two steps
    tau: Vec<f64> = "1.55,1.75,1.95" in "(1.5, 2)",
}

/// Runs an example: what it returns, and its checks.
fn run_example<P: Declarations, T>(
    run: fn(&P, &mut Report) -> Result<T>,
    options: &P,
) -> Result<(T, Outcome)> {
    let mut report = Report::of::<P>();
    let known = run(options, &mut report)?;
    Ok((known, report.close()))
}

/// The lines of the tour.
struct Lines<'a> {
    out: &'a mut Report,
    /// Where forms that fail as printed are true: footnotes a, b, ..
    corrections: Vec<String>,
}

impl Lines<'_> {
    /// One line, and the claims of its example.
    fn add(&mut self, step: &str, says: &str, computed: String, found: &Outcome) {
        for check in found.checks().iter().filter(|check| check.role == Role::Claim) {
            let claim = self.out.check("claims that fail or are undecided");
            claim.holds(check.decision() <= Decision::Holds, "checks of the examples");
        }
        let mut words = Vec::new();
        if !found.status().is_confirmed() {
            words.push(found.status().to_string());
        }
        if found.has(Role::NotSharp, Decision::Holds) {
            words.push("not sharp".to_owned());
        }
        if found.has(Role::Stronger, Decision::Holds) {
            words.push("loose".to_owned());
        }
        for range in found.corrections() {
            if !self.corrections.iter().any(|known| known == range) {
                self.corrections.push(range.to_owned());
            }
            let at = self.corrections.iter().position(|known| known == range).unwrap_or(0);
            words.push(format!("[{}]", ('a'..='z').nth(at).unwrap_or('z')));
        }
        let so_it_is = if words.is_empty() { "true".to_owned() } else { words.join(" ") };
        self.out.row(cells! { step, says => computed, so_it_is });
    }
}

fn run(options: &Options, out: &mut Report) -> Result<()> {
    let mut lines = Lines { out, corrections: Vec::new() };

    for cone in [Cone::Nodal, Cone::Midpoint] {
        let asked =
            block::Options { n: vec![8, 16, 32], cone: vec![cone], ..block::Options::default() };
        let (solved, found) = run_example(block::run, &asked)?;
        let apart = solved.iter().map(|solved| solved.two_solvers).fold(0.0, f64::max);
        let blocks = solved.iter().filter(|solved| solved.body == "block");
        let touching = blocks.map(|solved| solved.u.contact_set.count()).next_back().unwrap_or(0);
        let (step, says, of) = match cone {
            Cone::Nodal => ("1", "a block, two solvers: one solution (2.9)", "33 nodes"),
            Cone::Midpoint => ("", "  the same for means, (4.1)", "32 segments"),
        };
        lines.add(step, says, format!("{touching} of {of} touch ({apart:.0e})"), &found);
    }

    let (c, found) = run_example(falk::run, &falk::Options::default())?;
    let computed = format!("C = {:.2} and {:.2} are enough", c.nodal, c.midpoint);
    lines.add("2", "error² ≤ C (interpolation + term), (4.5)", computed, &found);

    let (rows, found) = run_example(figure_3_2::run, &figure_3_2::Options::default())?;
    if let Some(figure_3_2::Row { n, first, second, carried_by }) = rows.last() {
        let computed = format!("{first} + {second} of {n}; {carried_by} has the term");
        lines.add("3", "each segment: case 1 or 2 (Figure 3.2)", computed, &found);
    }
    let (rows, found) = run_example(figure_4_1::run, &figure_4_1::Options::default())?;
    if let Some(figure_4_1::Row { n, first, second }) = rows.last() {
        let computed = format!("{first} + {second} of {n}");
        lines.add("", "  the same for means (Figure 4.1)", computed, &found);
    }

    for (step, nu, value, bound) in
        [("4", "1/4", 0.25, "C θ^(−1/4)"), ("", "1/2", 0.5, "C ln(1/θ)"), ("", "3/4", 0.75, "C")]
    {
        let order = Order::new(value)?;
        let asked = lemma_5_2::Options { nu: vec![order], ..lemma_5_2::Options::default() };
        let (growths, found) = run_example(lemma_5_2::run, &asked)?;
        for lemma_5_2::Growth { nu: order, growth, theta, gamma } in &growths {
            let computed = match order.offset() {
                below if below < 0.0 => format!("θ^{:.3}", growth),
                0.0 => format!("√({:.3} ln(1/θ))", growth),
                _ => format!("{gamma:.4} at θ = {theta:e}"),
            };
            let says = format!("case 2: γ ≤ {bound}, ν = {nu} (Lemma 5.2)");
            lines.add(step, &says, computed, &found);
        }
    }

    let (constants, found) = run_example(lemma_6_1::run, &lemma_6_1::Options::default())?;
    let l2 = constants.iter().map(|best| best.l2).fold(0.0, f64::max);
    let slope = constants.iter().map(|best| best.slope).fold(0.0, f64::max);
    let computed = format!("{l2:.4} in L², {slope:.3} for slopes");
    lines.add("5", "interpolation, constant 1 (Lemma 6.1)", computed, &found);

    for (k, &tau) in options.tau.iter().enumerate() {
        let asked = theorem_3_1::Options { tau: vec![tau], ..theorem_3_1::Options::default() };
        let (rates, found) = run_example(theorem_3_1::run, &asked)?;
        for theorem_3_1::Rate { printed, optimal, order } in &rates {
            let says = format!("τ = {tau}: error ≤ C h^{printed:.3} (Theorem 3.1)");
            let (order, error) = (order.value, order.error);
            let computed = format!("{order:.4} ± {error:.0e}, optimal {optimal:.2}");
            lines.add(if k == 0 { "6" } else { "" }, &says, computed, &found);
        }
    }
    if let Some(&tau) = options.tau.get(options.tau.len() / 2) {
        let asked = theorem_4_1::Options { tau: vec![tau], ..theorem_4_1::Options::default() };
        let (rates, found) = run_example(theorem_4_1::run, &asked)?;
        for theorem_4_1::Rate { printed, optimal, order } in &rates {
            let says = format!("τ = {tau}: error ≤ C h^{printed:.3} (Theorem 4.1)");
            let (order, error) = (order.value, order.error);
            let computed = format!("{order:.4} ± {error:.0e}, optimal {optimal:.2}");
            lines.add("7", &says, computed, &found);
        }
    }

    let mut notes = String::new();
    for (letter, range) in ('a'..='z').zip(&lines.corrections) {
        notes += &format!("[{letter}] false as printed; it is true {range}    ");
    }
    out.column("says", "the paper says", "");
    out.column("computed", "computed here", "");
    out.column("so_it_is", "so it is", "");
    out.remark(format!(
        "{}\nnext: cargo book     one step: cargo run --release --example figure_3_2_alternative",
        notes.trim_end()
    ));
    Ok(())
}
