//! The paper in one run: the steps of its proof, what each says, what is computed, and whether it is so.
//!
//! Every step runs an example and reads its numbers, so that tour and example cannot disagree; the formula behind a
//! number stands in the file of that example. The last column is the status that the checks of the example give: true;
//! loose: a stronger statement is true too; not sharp: another growth; false as printed: a repaired form is true.
//!
//! Refuted if a check of one of the examples fails.
//!
//! `cargo run --release --example tour -- --out out`

#![allow(clippy::duplicate_mod, reason = "twins share a file")]

use example_report::prelude::*;
use example_report::{Decision, Outcome, Role, Verdict};
use signorini::cone::Cone;

/// The examples are loaded here.
macro_rules! examples {
    ($($name:ident: $file:literal),* $(,)?) => {
        $(#[path = $file] #[allow(dead_code, reason = "only `outcome` is used here")] mod $name;)*
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

example! { long "Hild & Renard 2012", "an a priori error analysis of Signorini's problem, step by step";
    /// regularities τ of the last two steps
    tau: Vec<f64> = "1.55,1.75,1.95" in "(1.5, 2)",
}

/// The numbers of an example under these keys; an unknown key ends the tour.
fn at<const N: usize>(found: &Outcome, keys: [&str; N]) -> Result<[f64; N]> {
    let mut numbers = [0.0; N];
    for (number, key) in numbers.iter_mut().zip(keys) {
        *number =
            found.value(key).ok_or_else(|| Error::Option(format!("tour: no number with the key {key}")))?;
    }
    Ok(numbers)
}

/// One line, and the claims of its example.
fn line(out: &mut Report, step: &str, says: impl Into<String>, computed: String, found: &Outcome) {
    let repaired = found.checks().iter().any(|c| c.role == Role::NotSharp && c.decision() == Decision::Holds);
    let status = match found.status() {
        Verdict::FalseAsPrinted if repaired => "not sharp [a]".to_owned(),
        Verdict::FalseAsPrinted => "loose [b]".to_owned(),
        other => other.to_string(),
    };
    out.row(cells! { step, says: says.into() => computed, so_it_is: status });
    for check in found.checks().iter().filter(|check| check.role == Role::Claim) {
        out.check("claims that fail or are undecided")
            .holds(check.decision() <= Decision::Holds, "checks of the examples");
    }
}

fn run(options: &Options, out: &mut Report) -> Result<()> {
    for cone in [Cone::Nodal, Cone::Midpoint] {
        let found =
            block::outcome(&block::Options { n: vec![8, 16, 32], cone: vec![cone], ..Default::default() })?;
        let key = format!("touching.bodyblock.cone{cone}.n32");
        let [touching, apart] = at(&found, [&key, "two-solvers-j-j"])?;
        let of = if cone == Cone::Nodal { "33 nodes" } else { "32 segments" };
        let says = if cone == Cone::Nodal {
            "a block, two solvers: one solution (2.9)"
        } else {
            "  the same for means, (4.1)"
        };
        line(
            out,
            if cone == Cone::Nodal { "1" } else { "" },
            says,
            format!("{touching} of {of} touch ({apart:.0e})"),
            &found,
        );
    }
    let found = falk::outcome(&falk::Options::default())?;
    let [nodal, midpoint] = at(&found, ["c-nodal-cone", "c-midpoint-cone"])?;
    line(
        out,
        "2",
        "error² ≤ C (interpolation + term), (4.5)",
        format!("C = {nodal:.2} and {midpoint:.2} are enough"),
        &found,
    );
    let found = figure_3_2::outcome(&figure_3_2::Options::default())?;
    let [first, second, carried_by] = at(&found, ["first.n32", "second.n32", "carried_by.n32"])?;
    line(
        out,
        "3",
        "each segment: case 1 or 2 (Figure 3.2)",
        format!("{first} + {second} of 32; {carried_by} has the term"),
        &found,
    );
    let found = figure_4_1::outcome(&figure_4_1::Options::default())?;
    let [first, second] = at(&found, ["first.n32", "second.n32"])?;
    line(out, "", "  the same for means (Figure 4.1)", format!("{first} + {second} of 32"), &found);
    for (k, (nu, says)) in [("1/4", "C θ^(−1/4)"), ("1/2", "C ln(1/θ)"), ("3/4", "C")].into_iter().enumerate()
    {
        let order = Order::new([0.25, 0.5, 0.75][k])?;
        let found = lemma_5_2::outcome(&lemma_5_2::Options { nu: vec![order], ..Default::default() })?;
        let key =
            ["nu-0.25-exponent-of-theta", "slope-of-gamma-against-ln-1-theta", "gamma.nu0.75.theta1e-6"][k];
        let [number] = at(&found, [key])?;
        let computed = match k {
            0 => format!("θ^{number:.3}"),
            1 => format!("√({number:.3} ln(1/θ))"),
            _ => format!("{number:.4} at θ = 1e-6"),
        };
        let step = if k == 0 { "4" } else { "" };
        line(out, step, format!("case 2: γ ≤ {says}, ν = {nu} (Lemma 5.2)"), computed, &found);
    }
    let found = lemma_6_1::outcome(&lemma_6_1::Options::default())?;
    let [value, slope] = at(&found, ["first-line-best-constant-c", "second-line-seminorm-best-constant-c"])?;
    line(
        out,
        "5",
        "interpolation, constant 1 (Lemma 6.1)",
        format!("{value:.4} in L², {slope:.3} for slopes"),
        &found,
    );
    for &tau in &options.tau {
        let asked = theorem_3_1::Options { tau: vec![tau], ..Default::default() };
        let found = theorem_3_1::outcome(&asked)?;
        let key = |name: &str| format!("{name}.tau{tau}");
        let [order, error, printed] =
            at(&found, [&key("order"), &(key("order") + ".error"), &key("printed")])?;
        let computed = format!("{order:.4} ± {error:.0e}, optimal {:.2}", tau - 1.0);
        let step = if tau == options.tau[0] { "6" } else { "" };
        line(out, step, format!("τ = {tau}: error ≤ C h^{printed:.3} (Theorem 3.1)"), computed, &found);
    }
    let tau = options.tau.get(options.tau.len() / 2).copied().unwrap_or(1.75);
    let found = theorem_4_1::outcome(&theorem_4_1::Options { tau: vec![tau], ..Default::default() })?;
    let key = |name: &str| format!("{name}.tau{tau}");
    let [order, error, printed] = at(&found, [&key("order"), &(key("order") + ".error"), &key("printed")])?;
    let computed = format!("{order:.4} ± {error:.0e}, optimal {:.2}", tau - 1.0);
    line(out, "7", format!("τ = {tau}: error ≤ C h^{printed:.3} (Theorem 4.1)"), computed, &found);
    out.column("says", "the paper says", "");
    out.column("computed", "computed here", "");
    out.column("so_it_is", "so it is", "");
    out.remark("[a] and false as θ → 1: say θ ≤ 1/2    [b] full H¹ norm: for h ≤ 5.46 only\nnext: cargo book     one step: cargo run --release --example figure_3_2_alternative");
    Ok(())
}
