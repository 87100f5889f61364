//! What orders of convergence decide: one row against the theorem of its cone, (4.14) beyond τ = 2.

use super::row::{RateRow, highest};
use crate::Finding;
use signorini::cone::Cone;
use signorini::rates::Bound;

/// Beyond τ = 2 orders creep up to one from below: they need to have come this near.
const NEAR_ONE: f64 = 0.1;

/// One order against (3.1), (4.2), a remark for fat Cantor sets, whose orders are not sharp; at τ = 2, whose
/// logarithm no order shows, the growth of error/bound; beyond τ = 2 order one. `words` name the scene.
pub fn against_theorem(key: String, words: &str, row: &RateRow) -> Finding {
    let [power, logarithm, one] = match row.study.cone {
        Cone::Nodal => ["(3.1)", "(3.2)", "(E4)"],
        Cone::Midpoint => ["(4.2)", "(4.3)", "(4.4)"],
    };
    let tau = row.study.tau;
    if tau == 2.0 {
        return Finding::claim(key, format!("{words}: error/bound does not grow, factor {{value}}"))
            .number_or(row.growth(), "too few levels")
            .at_most(1.0, logarithm)
            .otherwise(format!("{words}: error/bound grows, factor {{value}}"));
    }
    let (bound, source) = match Bound::Paper.exponent(tau) {
        Ok(exponent) if tau < 2.0 => (exponent, power.to_owned()),
        _ => (1.0 - NEAR_ONE, format!("{one}, less {NEAR_ONE}: orders creep up to one")),
    };
    let role: fn(String, String) -> Finding = if row.is_fat() { Finding::remark } else { Finding::claim };
    role(key, format!("{words}: the order of the error is {{value}} or less, not below {{bound}}"))
        .number_or(row.order().map(highest), "too few levels, or an error that is not a positive number")
        .at_least(bound, source)
        .otherwise(format!("{words}: the error has order {{value}} at most, below {{bound}}"))
}

/// Beyond τ = 2: the root of the consistency term, of which (4.14) says h^{τ−1}, against order one; key
/// `SCENE.term`.
pub fn term_above_one(row: &RateRow) -> Finding {
    let words = format!("{}: the root of the consistency term has order {{value}}", row.words());
    let number = row.term.map(|fit| (fit.order, fit.uncertainty));
    Finding::claim(format!("{}.term", row.key()), format!("{words}, above one"))
        .number_or(number, "too few levels, or no term")
        .at_least(1.0, "order one, that of the error; (4.14) has tau - 1")
        .otherwise(format!("{words}, below one"))
}
