//! What the attacks share: how many cases, and what became of them.

pub mod references;

use crate::common::SplitMix;
use fractional_sobolev::{Error, Estimate, Result};

/// The share of the target; `SIGNORINI_ATTACK=10` takes ten times as many cases.
pub fn cases(default: usize) -> usize {
    let factor = std::env::var("SIGNORINI_ATTACK").map_or(1.0, |text| {
        text.parse().unwrap_or_else(|_| panic!("SIGNORINI_ATTACK = {text} is not a number"))
    });
    (crate::SHARE * default as f64 * factor).ceil() as usize
}

/// Of the family; `SIGNORINI_SEED=7` takes other cases.
pub fn seeded(family: u64) -> SplitMix {
    let seed = std::env::var("SIGNORINI_SEED")
        .map_or(0, |text| text.parse().unwrap_or_else(|_| panic!("SIGNORINI_SEED = {text} is not a number")));
    SplitMix::new(family + 1000 * seed)
}

/// What became of the cases of one family.
#[derive(Debug, Default)]
pub struct Count {
    answered: usize,
    refused: usize,
    worst: f64,
    violations: Vec<String>,
}

impl Count {
    /// An answer is right to its own error beside `rounding` of the exact value; a refusal gives a reason.
    /// That a finite norm is infinite, or no number, is no reason, it is a wrong answer.
    pub fn judge(
        &mut self,
        case: impl FnOnce() -> String,
        found: &Result<Estimate>,
        exact: f64,
        rounding: f64,
    ) {
        assert!(exact.is_finite() && exact >= 0.0, "reference of {}: {exact:e}", case());
        match found {
            Ok(found) => {
                self.answered += 1;
                let share = (found.value - exact).abs() / (found.error + rounding * exact);
                let share = if share.is_nan() { f64::from(u8::from(found.value != exact)) } else { share };
                self.worst = self.worst.max(share);
                if share > 1.0 {
                    let relative = found.value / exact - 1.0;
                    self.violation(format!("{}: {found}, exact {exact:.15e}, off by {relative:.1e}", case()));
                }
            }
            Err(error @ (Error::InfiniteNorm { .. } | Error::NotFinite { .. })) => {
                self.violation(format!("{}: {error}", case()));
            }
            Err(_) => self.refused += 1,
        }
    }

    /// A case that went wrong.
    pub fn violation(&mut self, what: String) {
        self.violations.push(what);
    }

    /// Prints the counts; fails on violations, on too few cases, and when more than `refusals` of them (as a
    /// share) were refused.
    pub fn close(self, family: &str, at_least: usize, refusals: f64) {
        let Self { answered, refused, worst, violations } = self;
        let tried = answered + refused + violations.len();
        println!(
            "{family}: {tried} tried, {answered} answered (worst error {worst:.2} of the estimate), {refused} \
             refused, {} violations",
            violations.len()
        );
        assert!(
            violations.is_empty(),
            "{family}, {}: {:#?}",
            violations.len(),
            &violations[..violations.len().min(12)]
        );
        assert!(tried >= at_least, "{family}: {tried} of {at_least} cases");
        assert!(refused as f64 <= refusals * tried as f64, "{family}: {refused} of {tried} refused");
    }
}
