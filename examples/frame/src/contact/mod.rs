//! Contact solutions on meshes as the examples of Section 2 show them: the table, the deformed body, the
//! contact edge, and the contact sets that an active-set iteration visits.

mod body;
mod conditions;
mod csv;
mod history;
mod listing;
mod own;
mod picture;
mod roads;
mod subject;
mod two_roads;

pub use conditions::{CONDITIONS, KktCondition, solvers_agree};
pub use listing::{table, worst};
pub use own::{Load, Material, Own, OwnOptions};
pub use roads::{algebraic_chart, memory_chart, road_chart, road_costs, road_table};
pub use subject::ContactSubject;
pub use two_roads::{RoadsRow, compressibility_chart, two_roads_table};
