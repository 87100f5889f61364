//! One registry of scenes, on meshes and on the edge of a strip: names, data, regularity, and the solution
//! where it is known.
//!
//! | | what | where |
//! | --- | --- | --- |
//! | [`Scene`] | a scene of either kind, by name | `scene` |
//! | [`MeshScene`] | bodies, loads, boundary parts | `mesh` |
//! | [`MeshScene::regularity`], [`body_regularity`] | sup τ from corners and the contact set found | `regularity`, `corners` |
//! | [`StripScene`] | pairs (u_N, λ) on a fine edge from which the load follows | `strip`, `contact_sets`, `gap_data` |
//! | names and parameters | one block per scene; grammar, reading, writing | `registry` |
//! | [`TransitionPowers`] | one transition with given powers and logarithms | `transition_powers` |
//! | [`ClampedEnd`] | a body clamped up to the end of its contact edge, on polar rings | `clamped_end` |
//! | [`KnownSolution`] | problems on the square with known solution of given regularity, and errors against it | `known` |
//! | [`LoadedBody`] | bodies with loads that every mesh integrates exactly, solution unknown | `loaded_body` |
//!
//! A new scene is one block in `strip` or `mesh`: variant, name, parameters with defaults, data.
//! List of all, help texts, reading, writing and errors follow from it.

mod clamped_end;
mod contact_sets;
mod corners;
mod gap_data;
mod known;
mod loaded_body;
mod mesh;
mod pressure;
mod registry;
mod regularity;
mod scene;
mod strip;
mod tau_range;
mod transition_powers;

pub use clamped_end::ClampedEnd;
pub use corners::{BodyCorner, BodyRegularity, body_regularity};
pub use known::{EdgeDatum, KnownSolution};
pub use loaded_body::LoadedBody;
pub use mesh::{MeshScene, Setting};
pub use scene::Scene;
pub use strip::StripScene;
pub use transition_powers::TransitionPowers;
