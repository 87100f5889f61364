//! A test problem or a triangulation of the user on nested meshes, by one solver or by two, and how far two solutions
//! are apart: `section_2_elastic_contact`, `section_2_scalar_contact`, `section_2_own_body`.

mod comparison;
mod known;
mod levels;
mod own_body;
mod study;

pub use comparison::{energies_apart, sets_apart};
pub use known::known_energy;
pub use levels::{SceneRun, StudyProgress};
pub use own_body::OwnBody;
pub use study::SceneStudy;
