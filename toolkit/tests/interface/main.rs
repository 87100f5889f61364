//! What the toolkit shows to a caller: documentation, errors, refusals, limits of work.

mod documented;
mod errors_with_index;
mod refusals;
mod work_limits;
