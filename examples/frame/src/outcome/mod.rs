//! What an example says: a claim, one short table, findings, and what follows from them; as text and as JSON.

mod cell;
mod finding;
mod headline;
mod missing;
mod table;
mod verdict;

pub use cell::{Cell, Format};
pub use finding::{Finding, Outcome, Relation, Role};
pub use headline::Headline;
pub use table::{Column, Table};
pub use verdict::Verdict;
