//! One assertion for every random case with a known answer, and how many cases are taken.

pub mod references;

use crate::common::SplitMix;
use fractional_sobolev::{Error, Estimate, Result, Tolerance, Work};
use std::time::Instant;

/// Seconds from which a case is slow.
const SLOW: f64 = 0.5;

/// The share of the target; `SIGNORINI_ATTACK=10` takes ten times as many cases.
pub fn cases(default: usize) -> usize {
    let factor = std::env::var("SIGNORINI_ATTACK").map_or(1.0, |text| {
        text.parse().unwrap_or_else(|_| panic!("SIGNORINI_ATTACK = {text} is not a number"))
    });
    (crate::SHARE * default as f64 * factor).ceil() as usize
}

/// The same for cases that take a tenth of a second each: in the short run a third of them.
pub fn costly_cases(default: usize) -> usize {
    if crate::SHARE < 1.0 { cases(default).div_ceil(3) } else { cases(default) }
}

/// Of the family; `SIGNORINI_SEED=7` takes other cases.
pub fn seeded(family: u64) -> SplitMix {
    let seed = std::env::var("SIGNORINI_SEED").map_or(0, |text| {
        text.parse().unwrap_or_else(|_| panic!("SIGNORINI_SEED = {text} is not a number"))
    });
    SplitMix::new(family + 1000 * seed)
}

/// 10^u, u uniform.
pub fn decades(random: &mut SplitMix, low: f64, high: f64) -> f64 {
    10f64.powf(random.between(low, high))
}

/// What was asked of what, what came out, and the known answer with its own error.
pub struct Case {
    pub what: String,
    /// `None` for a closed form, which takes no tolerance.
    pub asked: Option<Tolerance>,
    pub found: Result<Estimate>,
    pub exact: Estimate,
    /// A refusal may carry no value: the largest part of the norm lies below the smallest number.
    pub is_deep: bool,
}

impl Case {
    /// `rounding`, relative, is that of the known answer.
    pub fn new(
        what: String,
        asked: Tolerance,
        (exact, rounding): (f64, f64),
        ask: impl FnOnce(Tolerance) -> Result<Estimate>,
    ) -> Self {
        let exact = Estimate { value: exact, error: rounding * exact.abs(), work: Work::default() };
        Self { what, asked: Some(asked), found: ask(asked), exact, is_deep: true }
    }

    /// Beside another computation, every refusal with a value.
    pub fn beside(
        what: String,
        asked: Tolerance,
        exact: Estimate,
        ask: impl FnOnce(Tolerance) -> Result<Estimate>,
    ) -> Self {
        Self { what, asked: Some(asked), found: ask(asked), exact, is_deep: false }
    }

    /// An answer is right to its own error, meets its tolerance and keeps its limit of work; a refusal encloses the
    /// known answer. That a finite norm is infinite, or no number, is a wrong answer.
    pub fn fault(&self) -> Option<String> {
        let Self { what, asked, found, exact, is_deep } = self;
        assert!(exact.value.is_finite() && exact.error.is_finite(), "reference of {what}: {exact}");
        let apart = |found: &Estimate| {
            let off = (found.value - exact.value).abs() - found.error - exact.error;
            off > 0.0 || off.is_nan()
        };
        let message = match found {
            Ok(found) if apart(found) => "dishonest",
            Ok(found)
                if asked
                    .is_some_and(|t| found.error > t.relative().max(8e-15) * found.value.abs()) =>
            {
                "misses the tolerance"
            }
            Ok(found) if found.work.points > 4 * Tolerance::WORK => "works beyond its limit",
            Ok(_) => return None,
            Err(Error::ToleranceNotMet { best: Some(best), .. }) => {
                if apart(best) {
                    "a dishonest refusal"
                } else if best.work.points > 4 * Tolerance::WORK {
                    "works beyond its limit"
                } else {
                    return None;
                }
            }
            Err(Error::ToleranceNotMet { best: None, reached, .. })
                if *is_deep && *reached == f64::INFINITY =>
            {
                return None;
            }
            Err(_) => "no value",
        };
        Some(format!("{what}, asked {asked:?}: {message}, {found:?}; exact {exact}"))
    }
}

/// How a case is drawn, how many are, and the share of them that may be refused.
pub type Family = (&'static str, usize, f64, fn(&mut SplitMix) -> Case);

/// Draws and judges the cases of all families; `SIGNORINI_FAMILY=log` only of those with such a name, and
/// `SIGNORINI_REFUSED=1` prints what is refused or slow. How many times the true error, or rounding, every stated error is.
pub fn judge(first: u64, families: &[Family]) -> Vec<f64> {
    let only = std::env::var("SIGNORINI_FAMILY").unwrap_or_default();
    let shows = std::env::var("SIGNORINI_REFUSED").is_ok();
    let (mut faults, mut all) = (Vec::new(), Vec::new());
    for (seed, (family, count, refusals, draw)) in (first..).zip(families) {
        if !family.contains(&only) {
            continue;
        }
        let (mut random, mut refused, count) = (seeded(seed), 0, cases(*count));
        let mut careful = Vec::new();
        for _ in 0..count {
            let start = Instant::now();
            let case = draw(&mut random);
            if shows && start.elapsed().as_secs_f64() > SLOW {
                println!("{family}: {} took {:.1?}", case.what, start.elapsed());
            }
            match &case.found {
                Ok(found) => {
                    let off = (found.value - case.exact.value).abs();
                    let ratio = found.error / off.max(4.0 * f64::EPSILON * case.exact.value.abs());
                    // 0 ± 0 for a function that is 0
                    careful.push(if ratio.is_nan() { 1.0 } else { ratio });
                }
                Err(error) => {
                    refused += 1;
                    if shows {
                        println!("{family}: {}, exact {}: {error:?}", case.what, case.exact);
                    }
                }
            }
            faults.extend(case.fault().map(|fault| format!("{family}: {fault}")));
        }
        let within = match median(&careful) {
            Some(median) => format!(", half of the errors are within {median:.0} of the true ones"),
            None => String::new(),
        };
        println!("{family}: {count} tried, {refused} refused{within}");
        all.extend(careful);
        if f64::from(refused) > refusals * count as f64 {
            faults.push(format!("{family}: {refused} of {count} refused"));
        }
    }
    assert!(faults.is_empty(), "{}: {:#?}", faults.len(), &faults[..faults.len().min(12)]);
    all
}

/// The value in the middle, if there is one.
pub fn median(values: &[f64]) -> Option<f64> {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    sorted.get(sorted.len() / 2).copied()
}
