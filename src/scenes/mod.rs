//! One registry of scenes, on meshes and on the edge of a strip: names, data, regularity, and the solution
//! where it is known.
//!
//! | | what | where |
//! | --- | --- | --- |
//! | [`Scene`] | a scene of either kind, by name | `scene` |
//! | [`MeshScene`] | bodies, loads, boundary parts; regularity from corner exponents | `mesh`, `regularity` |
//! | [`StripScene`] | pairs (u_N, λ) on a fine edge from which the load follows | `strip`, `contact_sets` |
//! | [`TransitionPowers`] | one transition with given powers and logarithms | `transition_powers` |
//! | [`StripCase`] | a strip scene with levels, cone and positions: what is solved | `case` |
//! | [`MeshScene::known_energy`] | minima that other packages have found | `known` |
//! | [`manufactured`] | a scalar scene whose solution is known in closed form | `manufactured` |
//!
//! A new strip scene is one variant of [`StripScene`] with its arm in `form`; names, help texts and errors
//! follow.

mod case;
mod contact_sets;
mod known;
pub mod manufactured;
mod mesh;
mod pressure;
mod regularity;
mod roads;
mod scene;
mod strip;
mod study;
mod transition_powers;

pub use case::StripCase;
pub use mesh::{MeshScene, Setting};
pub use regularity::clamped_free_exponent;
pub use roads::{Road, RoadRow, manufactured_by_every_road};
pub use scene::Scene;
pub use strip::StripScene;
pub use study::{SceneRun, SceneStudy, energies_apart, sets_apart};
pub use transition_powers::TransitionPowers;
