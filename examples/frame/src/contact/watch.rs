//! A study on a terminal: which mesh, which solver, and how far multigrid is.

use crate::{Result, announce_memory, progress};
use signorini::scenes::{SceneRun, SceneStudy};

/// Runs a study and shows where it is.
///
/// # Errors
/// Those of [`SceneStudy::run_observed`]; more memory than the machine has.
pub fn watched(study: &SceneStudy) -> Result<Vec<SceneRun>> {
    announce_memory(study.bytes())?;
    let bar = progress(2 * study.levels as u64);
    let runs = study.run_observed(|at| {
        bar.set_message(at.to_string());
        bar.inc(u64::from(at.multigrid.is_none()));
        Ok(())
    })?;
    bar.finish_and_clear();
    Ok(runs)
}
