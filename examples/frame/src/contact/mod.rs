//! Contact solutions on meshes as the examples of Section 2 show them: the table, the deformed body, the
//! contact edge, and the contact sets that an active-set iteration visits.

mod history;
mod listing;
mod picture;

pub use listing::{table, worst};
pub use picture::quote_and_draw;
