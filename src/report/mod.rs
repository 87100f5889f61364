//! What an example says: a claim, one short table, a verdict; as text for people and as JSON rows for programs.

mod cell;
mod headline;
mod table;

pub use cell::{Cell, Format};
pub use headline::{Headline, Verdict};
pub use table::{Column, Table};
