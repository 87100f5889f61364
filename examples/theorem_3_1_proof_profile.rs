//! Theorem 3.1, its proof (Theorem 4.1 is its twin): both sides of every inequality, and a ladder of bounds.
//!
//! `cargo run --release --example theorem_3_1_proof_profile -- --scene fat-cantor --lines`

use example_frame::shown::ladder::{ladder_table, line_table, show, title};
use example_frame::{Finding, Headline, Result, within};
use experiments::convergence::Levels;
use experiments::proof::{LimitLine, LimitLines, Rung, limit_lines};
use experiments::proof::{ProofCase, ProofProfile, Resolution};
use signorini::problems::StripData;
use signorini::proof::{Section, Step, ThetaRule};
use std::process::ExitCode;

example_frame::options! {
    /// Compute both sides of every inequality of the proof on a manufactured pair (u_N, sigma_N)
    pub struct Options {
        /// A scene of the strip
        #[arg(long, default_value_t = StripData::transition(), help = StripData::names())]
        pub scene: StripData,
        /// Regularity the proof assumes, in (3/2, 2], for Theorem 4.1 in (3/2, 5/2)
        #[arg(long, default_value_t = 1.75, value_parser = within::<f64>("(1.5, 2.5)"))]
        pub tau: f64,
        /// Regularity the scene is built with; tau unless given
        #[arg(long)]
        pub scene_tau: Option<f64>,
        /// Exponent q of the embedding at tau = 2
        #[arg(long, default_value_t = 2.0, value_parser = within::<f64>("[2, 1e6]"))]
        pub q: f64,
        /// Mesh sizes h = 2^-COARSEST ... 2^-FINEST
        #[arg(long, default_value = "3-11")]
        pub levels: Levels,
        /// segment:K, 2^K fine cells per segment on every mesh, or edge:K, one grid of 2^K cells for all
        #[arg(long, default_value_t = Resolution::Segment(7))]
        pub resolution: Resolution,
        /// A fixed theta in (0, 1) instead of h^(2 tau - 3), h^2 at tau = 2
        #[arg(long)]
        pub theta: Option<f64>,
        /// Over how many positions in its cell a single transition is moved (odd)
        #[arg(long, default_value_t = 9)]
        pub positions: usize,
        /// Print the inequalities instead of the ladder
        #[arg(long)]
        pub lines: bool,
    }
    without_effect(options) {
        "positions" if !options.scene.moves() => "unless the scene is one transition",
    }
    check(options) {
        Ok(options.levels.require_count(3, "[3, 22]: an exponent takes three meshes")?)
    }
}

/// Both sides of every line on all meshes, and the rungs.
pub struct Computed {
    /// Every line.
    pub profile: ProofProfile,
    /// From the term to the final bound.
    pub rungs: Vec<Rung>,
    /// The lines for tau = 2 and beyond on several pairs.
    pub limits: LimitLines,
}

/// Profiles the proof on all meshes.
pub fn compute(section: Section, options: &Options) -> Result<Computed> {
    let Options { scene: source, tau, levels, resolution, positions, .. } = options.clone();
    let scene_tau = options.scene_tau.unwrap_or(tau);
    let rule = options.theta.map_or(ThetaRule::Printed { tau: tau.min(2.0) }, ThetaRule::Fixed);
    let case = ProofCase { section, source, tau, scene_tau, levels, resolution, rule, positions };
    case.require_valid()?;
    let profile = case.profile(&case.constants(options.q)?)?;
    let rungs = profile.ladder()?;
    Ok(Computed { profile, rungs, limits: limit_lines(section, options.q)? })
}

/// Rungs that coincide, and lines that are sharp, agree up to sums and constants, which are good to 1e-9.
const CONSTANTS: f64 = 1e-8;
/// Exponents of the losses come from nine meshes, on which the zones of a transition scatter.
const SCATTER: f64 = 0.05;

/// What decides: every line on every segment, every rung on every mesh, and where the exponent goes.
pub fn findings(options: &Options, Computed { profile, rungs, limits }: &Computed) -> Vec<Finding> {
    let (tau, printed, checks) = (options.tau, profile.printed_exponent(), profile.checks());
    let bounds = profile.lines().into_iter().filter(|line| !line.line.is_equality());
    let sharpest = bounds.max_by(|a, b| a.sharpest.total_cmp(&b.sharpest));
    let which = sharpest.as_ref().map_or(String::new(), |line| line.line.to_string());
    let rung = |step: Step| rungs.iter().find(|r| r.step == step);
    let exponent = |step: Step| rung(step).map(|r| (r.exponent.order, r.exponent.uncertainty));
    let loss = |step: Step| rung(step).and_then(|r| r.loss).map(|l| (l.order, l.uncertainty));
    let mut findings = vec![
        Finding::claim("lines", format!("of {checks} inequalities checked, {{value}} fail"))
            .number(profile.violations() as f64, 0.0)
            .at_most(0.0, "left side, right side and their errors")
            .told(),
        Finding::claim("sharpest", format!("the sharpest line is {which}, left/right at most {{value}}"))
            .number_or(sharpest.map(|line| (line.sharpest, 0.0)), "no line with a positive right side")
            .at_most(1.0 + CONSTANTS, "left <= right up to the error of the constants"),
        Finding::claim("ladder", "every rung of the ladder bounds the one below on every mesh")
            .number_or(profile.smallest_step().map(|step| (step, 0.0)), "no mesh with a positive term")
            .at_least(1.0 - CONSTANTS, "1 up to the error of the constants"),
        Finding::sharpness("loss", "h^{value} in the squared error on this scene")
            .number_or(exponent(Step::Term).map(|(value, u)| (value - printed, u)), "no exponent")
            .at_least(0.0, format!("{printed:.4}, the printed exponent")),
        Finding::remark("term", "the term itself falls like h^{value}, as an optimal error does")
            .number_or(exponent(Step::Term), "no exponent")
            .within(SCATTER, 2.0 * tau - 2.0, "2 tau - 2")
            .told(),
        Finding::claim("globally", "at tau = 2 bound over h^2 ln(1/h) has factors {value} or less per mesh")
            .number(limits.globally, 0.0)
            .at_most(1.0 + CONSTANTS, "(3.2), (4.3) with theta = h^2: no growth"),
    ];
    for LimitLine { line, pairs, count, violations, sharpest } in &limits.lines {
        let words = format!("{line}: left/right at most {{value}} on {count} segments of {pairs} pairs");
        let number = (*count > 0).then_some((*sharpest, 0.0));
        let claim = Finding::claim(line.key(), words).number_or(number, "no segment");
        findings.push(claim.at_most(1.0 + CONSTANTS, format!("left <= right; {violations} fail")));
    }
    // With another theta, and with the logarithm of tau = 2, the bound is no power of that exponent.
    if options.theta.is_none() && tau != 2.0 {
        findings.push(
            Finding::claim("bound", "the bound falls like h^{value}, the printed exponent")
                .number_or(exponent(Step::WholeEdge), "no exponent")
                .within(CONSTANTS, printed, "2 tau^2 - 5 tau + 4, above tau = 2 2 tau - 2")
                .told(),
        );
    }
    if options.theta.is_none() && tau < 2.0 {
        let (zone, law) = (loss(Step::ShortestZone), loss(Step::Law));
        findings.extend([
            Finding::remark("zone", "h^{value} is lost where every zone is taken as short as h_e theta")
                .number_or(zone, "no loss")
                .at_least(0.0, "no loss")
                .told(),
            Finding::remark("zone.law", "with the law of its constant that is the loss of the theorem")
                .number_or(zone.zip(law).map(|(a, b)| (a.0 + b.0, a.1 + b.1)), "no loss")
                .within(SCATTER, (2.0 * tau - 3.0) * (2.0 - tau), "(2 tau - 3)(2 - tau)"),
        ]);
    }
    findings
}

/// The outcome for Theorem 3.1.
pub fn run(options: &Options) -> Result<Headline> {
    outcome(Section::Three, "theorem_3_1_proof_profile", options)
}

/// The outcome of either theorem, figures saved as `name` and `name_slack`.
pub fn outcome(section: Section, name: &str, options: &Options) -> Result<Headline> {
    let computed = compute(section, options)?;
    let Computed { profile, rungs, .. } = &computed;
    let claim = "every line of the proof holds with explicit constants; a ladder shows which one loses order";
    let table = if options.lines { line_table(&profile.lines()) } else { ladder_table(section, rungs) };
    let mut headline = Headline::new(title(section).0, claim, table, findings(options, &computed));
    show(&mut headline, &options.output, name, profile, rungs)?;
    Ok(headline)
}

fn main() -> ExitCode {
    example_frame::main(run)
}
