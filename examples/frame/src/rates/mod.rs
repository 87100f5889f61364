//! What the rate studies of Theorems 3.1 and 4.1, Figure 3.1 and the introduction share: rows with fits, tables, files, the store.

mod listing;
mod plan;
mod row;
mod store;

pub use listing::{errors_chart, level_table, write_studies};
pub use plan::{RatePlan, both_cones};
pub use row::{
    HALF_WIDTH, OrderSeries, RateRow, complete, exponents_chart, fit_cells, largest, lowest, rate_table,
};
pub use store::LevelStore;
