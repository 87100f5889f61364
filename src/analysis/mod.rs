//! What is printed and drawn of the rooms [`crate::edge`] and [`crate::proof`].

mod alternative_report;
mod falk_report;
mod profile_report;
mod worst_report;

pub use falk_report::{falk_chart, falk_headline};
pub use worst_report::{SearchRow, search_chart, search_headline, search_sets, search_size, worst_gaps};
