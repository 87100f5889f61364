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
//! | [`StripCase`] | a strip scene with levels, cone and positions: what is solved | `case` |
//! | [`ClampedEnd`] | a body clamped up to the end of its contact edge, on polar rings | `clamped_end` |
//! | [`MeshScene::known_energy`] | minima that other packages have found | `known` |
//! | [`manufactured`] | a scalar scene whose solution is known in closed form | `manufactured` |
//! | [`MeshTransition`] | one transition of given regularity, on the bottom or the whole boundary | `mesh_transition` |
//! | [`ClosedForm`] | the same with one transition or two, scalar and elastic, with second derivatives | `closed_form` |
//! | [`RoughTransition`] | a known solution of any regularity about one transition, scalar and elastic | `rough_transition` |
//! | [`LoadedBody`] | bodies with loads that every mesh integrates exactly, solution unknown | `loaded_body` |
//!
//! A new scene is one block in `strip` or `mesh`: variant, name, parameters with defaults, data.
//! List of all, help texts, reading, writing and errors follow from it.

mod case;
mod clamped_end;
mod closed_form;
mod closed_form_levels;
mod contact_sets;
mod corners;
mod gap_data;
mod known;
mod loaded_body;
pub mod manufactured;
mod mesh;
mod mesh_transition;
mod mesh_transition_problem;
mod pressure;
mod registry;
mod regularity;
mod rough_transition;
mod rough_transition_levels;
mod scene;
mod strip;
mod tau_range;
mod transition_powers;

pub use case::StripCase;
pub use clamped_end::ClampedEnd;
pub use closed_form::ClosedForm;
pub use closed_form_levels::ClosedFormLevel;
pub use corners::{BodyCorner, BodyRegularity, body_regularity};
pub use loaded_body::LoadedBody;
pub use mesh::{MeshScene, Setting};
pub use mesh_transition::MeshTransition;
pub use rough_transition::{EdgeDatum, RoughTransition};
pub use rough_transition_levels::RoughLevel;
pub use scene::Scene;
pub use strip::StripScene;
pub use transition_powers::TransitionPowers;
