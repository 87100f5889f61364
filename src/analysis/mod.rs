//! What is printed and drawn of the rooms [`crate::edge`] and [`crate::proof`].

mod alternative_report;
mod balance_report;
mod contact_source;
mod falk_report;
mod profile_report;
mod worst_report;

pub use balance_report::BalanceRow;
pub use contact_source::ContactSource;
pub use falk_report::{falk_chart, falk_headline};
pub use worst_report::{SearchRow, search_chart, search_headline, search_sets, search_size, worst_gaps};
