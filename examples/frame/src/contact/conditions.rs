//! The four conditions of a contact solution in words.

use signorini::cone::Judgement;

/// Key, words if met, words if not, figure.
pub type Condition = (&'static str, &'static str, &'static str, fn(&Judgement) -> f64);
/// Karush, Kuhn and Tucker, each scaled by the size of what it compares.
pub const CONDITIONS: [Condition; 4] = [
    ("balance", "forces balance at every node", "a node is off balance by {value}", |j| j.balance),
    ("sign", "the foundation only pushes", "the foundation pulls, {value} of its force", |j| j.sign),
    ("cone", "no solution leaves the cone", "a solution leaves the cone by {value}", |j| j.gap),
    ("gaps", "a force closes its gap", "a force keeps a gap, {value}", |j| j.complementarity),
];
