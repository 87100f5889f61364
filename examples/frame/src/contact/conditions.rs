//! The four conditions of a contact solution in words.

use crate::Finding;
use experiments::contact_levels::{SceneRun, energies_apart, sets_apart};
use signorini::cone::KktResiduals;

/// Key, words if met, words if not, figure.
pub type KktCondition = (&'static str, &'static str, &'static str, fn(&KktResiduals) -> f64);
/// Karush, Kuhn and Tucker, each scaled by the size of what it compares.
pub const CONDITIONS: [KktCondition; 4] = [
    ("balance", "forces balance at every node", "a node is off balance by {value}", |j| j.balance),
    ("sign", "the foundation only pushes", "the foundation pulls, {value} of its force", |j| j.sign),
    ("cone", "no solution leaves the cone", "a solution leaves the cone by {value}", |j| j.gap),
    ("gaps", "a force closes its gap", "a force keeps a gap, {value}", |j| j.complementarity),
];

/// Two solvers on each mesh: J to so many digits and what rounding leaves of it, and the contact sets.
pub fn solvers_agree(runs: &[SceneRun], digits: f64) -> [Finding; 2] {
    let sets = sets_apart(runs).map(|(apart, weak)| (apart as f64, weak as f64));
    let (apart, rounding) = energies_apart(runs).map_or((None, 0.0), |(d, u)| (Some((d, 0.0)), u));
    [
        Finding::claim("solvers", "two solvers without a common line agree in J, apart by {value}")
            .number_or(apart, "no mesh was solved twice")
            .at_most(digits + rounding, "eight digits, and the rounding of J")
            .otherwise("two solvers are apart by {value} in J")
            .told(),
        Finding::remark("sets", "both find the same contact set")
            .number_or(sets, "no mesh was solved twice")
            .at_most(0.0, "as many constraints differ as are weak"),
    ]
}
