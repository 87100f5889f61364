//! The lines of the proofs for τ ≥ 2, (3.10), (3.15), (4.12), (4.13) and (4.14), on several pairs each.
//!
//! τ = 2, θ = h² and θ = 1/2: one transition, five gaps, and a Cantor set; (4.14): one transition of
//! regularity 2.05, 2.25 and 2.45. Cost: nine profiles of meshes h = 1/8 ... 1/256 at most.

use super::case::ProofCase;
use super::profile::LevelProfile;
use crate::convergence::Levels;
use signorini::Result;
use signorini::problems::StripData;
use signorini::proof::Inequality;
use signorini::proof::Section;
use signorini::proof::Step;
use signorini::proof::ThetaRule;

/// A line over all pairs on which it was checked.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LimitLine {
    /// The line.
    pub line: Inequality,
    /// How many pairs.
    pub pairs: usize,
    /// How many segments.
    pub count: usize,
    /// On how many it fails beyond the error of its sides.
    pub violations: usize,
    /// Largest left/right.
    pub sharpest: f64,
}

/// The end of a proof at τ = 2 and beyond.
#[derive(Debug, Clone, PartialEq)]
pub struct LimitLines {
    /// Every line that is stated for τ ≥ 2 only, in the order of the paper.
    pub lines: Vec<LimitLine>,
    /// "Globally" at τ = 2, θ = h²: the most that the bound on the whole edge over h² ln(1/h) is multiplied
    /// by from one mesh to the next, over all pairs.
    pub globally: f64,
}

/// The lines of a proof on every pair; `q` is the exponent of the embedding at τ = 2.
///
/// # Errors
/// As [`ProofCase::profile`].
pub fn limit_lines(section: Section, q: f64) -> Result<LimitLines> {
    let two = [
        StripData::transition(),
        StripData::Transitions { gaps: 5 },
        StripData::Cantor { ratio: 0.3, depth: 4 },
    ];
    let above: &[f64] = if section == Section::Four { &[2.05, 2.25, 2.45] } else { &[] };
    let pairs = two.into_iter().map(|source| (source, 2.0));
    let pairs = pairs.chain(above.iter().map(|&tau| (StripData::transition(), tau)));
    let (mut found, mut globally): (Vec<LimitLine>, f64) = (Vec::new(), 0.0);
    for (source, tau) in pairs {
        // With θ = h² no segment with a term is in the first case on these meshes; with θ = 1/2 there are
        // some.
        let rules = [ThetaRule::Printed { tau: 2.0 }, ThetaRule::Fixed(0.5)];
        let mut met: Vec<Inequality> = Vec::new();
        for rule in &rules[..if tau == 2.0 { 2 } else { 1 }] {
            let (levels, rule) = (Levels::new(3, 8)?, *rule);
            let source = source.clone();
            let case =
                ProofCase { source, tau, scene_tau: tau, levels, rule, ..ProofCase::standard(section)? };
            let profile = case.profile(&case.constants(q)?)?;
            if tau == 2.0 && rule == rules[0] {
                let over = |level: &LevelProfile| {
                    let h = level.h();
                    level.rung(Step::WholeEdge).printed / (h * h * (1.0 / h).ln())
                };
                let quotients: Vec<f64> = profile.levels.iter().map(over).collect();
                globally = quotients.windows(2).map(|pair| pair[1] / pair[0]).fold(globally, f64::max);
            }
            let lines = profile.lines();
            for line in lines.iter().filter(|found| found.line.is_limit() && found.count > 0) {
                let known = found.iter().position(|known| known.line == line.line);
                let place = known.unwrap_or_else(|| {
                    let (line, pairs, count) = (line.line, 0, 0);
                    found.push(LimitLine { line, pairs, count, violations: 0, sharpest: 0.0 });
                    found.len() - 1
                });
                let total = &mut found[place];
                if !met.contains(&line.line) {
                    met.push(line.line);
                    total.pairs += 1;
                }
                total.count += line.count;
                total.violations += line.violations;
                total.sharpest = total.sharpest.max(line.sharpest);
            }
        }
    }
    found.sort_by_key(|line| line.line);
    Ok(LimitLines { lines: found, globally })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_line_is_met_on_three_pairs() {
        for (section, labels) in
            [(Section::Three, ["(3.10)", "(3.15)"]), (Section::Four, ["(4.12)", "(4.13)"])]
        {
            let LimitLines { lines: found, globally } = limit_lines(section, 2.0).unwrap();
            assert!(globally > 0.5 && globally < 1.0 + 1e-8, "{section:?}: {globally}");
            for label in labels {
                assert!(found.iter().any(|line| line.line.to_string().starts_with(label)), "{label}");
            }
            for LimitLine { line, pairs, count, violations, sharpest } in found {
                assert!(pairs >= 2 && count > 0 && violations == 0, "{line}: {pairs} {count} {violations}");
                assert!(sharpest > 0.0 && sharpest <= 1.0, "{line}: {sharpest}");
            }
        }
    }
}
