//! What the rate studies of Theorems 3.1 and 4.1, Figure 3.1 and the introduction share: rows with fits,
//! tables, charts, files, the store.

mod charts;
mod claims;
mod listing;
mod logarithms;
mod plan;
mod printed;
mod row;
mod store;

pub use charts::{error_over_h, orders_on_curves, printed_and_measured};
pub use claims::{against_theorem, term_above_one};
pub use listing::{level_table, write_and_draw};
pub use logarithms::LogarithmRow;
pub use plan::{RatePlan, both_cones, on_meshes};
pub use printed::{Printed, Shape, printed_rates};
pub use row::{
    HALF_WIDTH, RateRow, complete, fit_cells, highest, largest, lowest, order_columns, rate_table,
    term_remarks,
};
pub use store::LevelStore;

/// An order with a wider bar is no order.
pub const STEADY: f64 = 0.1;
