//! Contact solutions on meshes as the examples of Section 2 show them: the table, the deformed body, the
//! contact edge, and the contact sets that an active-set iteration visits.

mod body;
mod conditions;
mod history;
mod listing;
mod picture;
mod roads;
mod two_roads;
mod watch;

pub use conditions::{CONDITIONS, Condition, solvers_agree};
pub use listing::{table, worst};
pub use picture::quote_and_draw;
pub use roads::{algebraic_chart, road_chart, road_table};
pub use two_roads::{RoadsRow, compressibility_chart, two_roads_table};
pub use watch::watched;
