//! Figure 3.2, and Figure 4.1 as its twin: the case of every contact segment, and what it adds to the
//! consistency term.
//!
//! `cargo run --release --example figure_3_2_alternative -- --scene fat-cantor --tau 1.7 --n 256 --meshes 8`
//! The same with `--over-theta` in place of `--meshes 8`: the finest mesh for θ = 1/2, 1/4, ...

use example_frame::shown::alternatives::{CASES, edge_chart, shares_chart, table};
use example_frame::{Finding, Headline, Result};
use experiments::convergence::regression;
use experiments::proof::{Against, AlternativeCase, AlternativeStudy};
use signorini::problems::{NamedProblem, TestProblem};
use signorini::proof::{Alternative, Section, ThetaRule, printed_exponent};
use std::process::ExitCode;

example_frame::options! {
    /// Classify every contact segment of meshes ..., n/2, n and add up the consistency term by case
    pub struct Options: Quick {
        /// A scene of a mesh or of the strip
        #[arg(long, default_value_t = NamedProblem::Mesh(TestProblem::Block), help = NamedProblem::names())]
        pub scene: NamedProblem,
        /// Contact segments of the finest mesh classified
        #[arg(long, default_value_t = 32)]
        pub n: usize,
        /// How many meshes, each with half the segments of the next
        #[arg(long, default_value_t = 3)]
        pub meshes: usize,
        /// Sobolev regularity of a strip scene, and in theta = h^(2 tau - 3), h^2 at tau = 2
        #[arg(long, default_value_t = 1.75)]
        pub tau: f64,
        /// A fixed theta in (0, 1) instead
        #[arg(long)]
        pub theta: Option<f64>,
        /// On whose contact set: reference (the fine solution) or itself (the discrete solution of each mesh)
        #[arg(long, default_value_t = Against::Reference)]
        pub against: Against,
        /// The finest mesh for theta = 1/2, 1/4, ... instead of several meshes
        #[arg(long)]
        pub over_theta: bool,
    }
    without_effect(options) {
        "meshes" if options.over_theta => "beside --over-theta",
        "theta" if options.over_theta => "beside --over-theta",
    }
}

/// The segments on the contact set asked for, and those of the finest mesh on the other one.
pub struct Computed {
    /// On the contact set asked for.
    pub study: AlternativeStudy,
    /// On the other one.
    pub other: AlternativeStudy,
}

/// Classifies the segments of all meshes, or for all θ.
pub fn compute(section: Section, options: &Options) -> Result<Computed> {
    let Options { scene: source, n, tau, against, .. } = options.clone();
    let meshes = if options.over_theta { 1 } else { options.meshes };
    let rule = options.theta.map_or(ThetaRule::Printed { tau }, ThetaRule::Fixed);
    let case = AlternativeCase { section, source, n, meshes, rule, tau, against };
    let study =
        |case: &AlternativeCase| if options.over_theta { case.over_theta() } else { case.over_size() };
    let other = AlternativeCase { meshes: 1, against: case.against.other(), ..case.clone() };
    Ok(Computed { study: study(&case)?, other: study(&other)? })
}

/// Part of the whole term below which a segment carries none of it: rounding of sums of its forces.
const CARRIES: f64 = 1e-12;

/// What decides: which segments carry the term, and whether the discrete contact set says the same.
pub fn findings(section: Section, options: &Options, Computed { study, other }: &Computed) -> Vec<Finding> {
    let last = study.rows.last();
    let ends = study.trace.transitions() as f64;
    let carriers = last.map(|row| (row.classification.carriers(CARRIES) as f64, 0.0));
    let pair = last.zip(other.rows.last()).map(|(a, b)| (&a.classification, &b.classification));
    let moved = pair.map(|(a, b)| (a.differences(b) as f64, 0.0));
    let carried = last.map(|row| row.classification.term(Alternative::Second) / row.classification.total());
    let totals: Vec<(f64, f64)> = study
        .rows
        .iter()
        .map(|r| (1.0 / r.n as f64, r.classification.total()))
        .filter(|t| t.1 > 0.0)
        .collect();
    let order = regression(&totals).filter(|_| !options.over_theta);
    let order = order.map(|found| (found.order, found.uncertainty));
    let none = "no mesh was classified";
    let no_share =
        if last.is_some() { "the whole term is zero: no case carries a share of it" } else { none };
    let mut findings = vec![
        Finding::claim("cases", "every segment is in a case, for every theta").by_proof(page(section)),
        Finding::claim("carriers", "{count:segment} with the whole term, no more than transition points")
            .number_or(carriers, none)
            .at_most(ends, "ends of the contact set inside the edge")
            .otherwise("{count:segment} with the term, more than transition points: {bound}")
            .told(),
        Finding::claim("discrete", "u_h puts {count:segment} into another case than the reference")
            .number_or(moved, none)
            .at_most(ends, "one segment per transition point")
            .otherwise("u_h puts {count:segment} into another case, more than transition points"),
        Finding::remark("second.carries", "the second case alone carries {percent} % of the term")
            .number_or(carried.filter(|share| share.is_finite()).map(|share| (share, CARRIES)), no_share)
            .at_least(0.5, "half of the term")
            .otherwise("the second case alone carries {percent} % of the term, the first or both the rest")
            .told(),
        Finding::remark("order", "the term falls like h^{value}, not more slowly than the theorem says")
            .number_or(order, "fewer than three meshes with a positive term")
            .at_least(printed_exponent(options.tau), "2 tau^2 - 5 tau + 4, 2 at tau = 2"),
    ];
    if section == Section::Three {
        let own = if study.case.against == Against::Itself { study } else { other };
        let own = own.rows.last().map(|row| row.classification.total());
        findings.push(
            Finding::claim("own.term", "u_h has no such term of its own: force times gap is 0 at every node")
                .number_or(own.map(|own| (own, 0.0)), none)
                .at_most(0.0, "complementarity at the nodes"),
        );
    }
    findings
}

fn page(section: Section) -> &'static str {
    if section == Section::Three { "figure_3_2_alternative" } else { "figure_4_1_alternative" }
}

/// The outcome for Section 3.
pub fn run(options: &Options) -> Result<Headline> {
    outcome(Section::Three, options)
}

/// The outcome of either section; figures `PAGE_h_N` or `PAGE_theta_THETA`, and `PAGE_shares`.
pub fn outcome(section: Section, options: &Options) -> Result<Headline> {
    let computed = compute(section, options)?;
    let (label, key, claim) = match section {
        Section::Three => (
            "Figure 3.2",
            "figure.3.2",
            "u_N has a zero near both vertices of a segment or sigma_N = 0 near one",
        ),
        Section::Four => (
            "Figure 4.1",
            "figure.4.1",
            "the contact set of a segment has diameter at most, or at least, h_e theta",
        ),
    };
    let found = findings(section, options, &computed);
    let mut headline = Headline::new(label, claim, table(&computed.study)?, found);
    if let Some(finest) = computed.study.rows.last() {
        for (case, name, _) in CASES {
            headline.quote(format!("{key}.{name}.count"), finest.classification.count(case) as f64);
            headline.quote(format!("{key}.{name}.term"), finest.classification.term(case));
        }
        headline.quote(format!("{key}.theta"), finest.theta);
    }
    for row in &computed.study.rows {
        let frame = if options.over_theta { format!("theta_{}", row.theta) } else { format!("h_{}", row.n) };
        let name = format!("{}_{frame}", page(section));
        headline.draw(&options.output, &name, || Ok(edge_chart(label, &computed.study, row)))?;
    }
    let shares = || Ok(shares_chart(label, options.over_theta, &computed.study));
    headline.draw(&options.output, &format!("{}_shares", page(section)), shares)?;
    Ok(headline)
}

fn main() -> ExitCode {
    example_frame::main(run)
}
