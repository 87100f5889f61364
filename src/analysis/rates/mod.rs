//! Why no contact set is bad: worst pairs on one segment, worst gaps, and norms of the data on the edge.

mod element;
mod norms;
mod worst;

pub use element::worst_ratio;
pub use norms::{EdgeNorms, edge_norm, edge_norms};
pub use worst::{SearchRow, search_chart, search_headline, search_sets, search_size, worst_gaps};
