//! `--csv DIR`: the rows, and displacement and stress along the contact edges, with their units in the
//! header.

use super::own::OwnOptions;
use crate::files::{require_writable, write_whole};
use crate::{Result, Table};
use experiments::contact_levels::SceneRun;
use signorini::Error;
use std::fmt::Write as _;

const ROWS: &str = "rows.csv";
const EDGE: &str = "contact_edge.csv";
const UNITS: &str = "# Units: lengths and displacements in the unit of the mesh. Stress and pressure in the unit of lambda and mu\n\
    # (of E). Volume load: that unit over length. Force: stress times length, for a body of thickness 1.\n";

/// The directory, before anything is computed.
///
/// # Errors
/// [`Error::File`] where it cannot be made or written.
pub(super) fn prepare(own: &OwnOptions) -> Result<()> {
    let Some(directory) = own.csv.as_deref() else {
        return Ok(());
    };
    std::fs::create_dir_all(directory).map_err(|e| Error::file(directory, e))?;
    for name in [ROWS, EDGE] {
        require_writable(&directory.join(name))?;
    }
    Ok(())
}

/// Both files, where they are asked for; the edge is that of the finest mesh, by the first solver.
///
/// # Errors
/// [`Error::File`].
pub(super) fn write(own: &OwnOptions, table: &Table, runs: &[SceneRun]) -> Result<()> {
    let Some(directory) = own.csv.as_deref() else {
        return Ok(());
    };
    let mut rows = format!("# Solutions of a contact problem, one row each.\n{UNITS}");
    for column in table.columns().iter().filter(|column| !column.meaning().is_empty()) {
        let _ = writeln!(rows, "# {}: {}", column.key(), column.meaning());
    }
    write_whole(&directory.join(ROWS), &(rows + &table.csv()))?;
    let finest = runs.last().map(|run| run.n);
    if let Some(run) = runs.iter().find(|run| Some(run.n) == finest) {
        write_whole(&directory.join(EDGE), &edge(run)?)?;
    }
    Ok(())
}

/// One line for every node of the contact edges.
fn edge(run: &SceneRun) -> Result<String> {
    let SceneRun { problem, solution, .. } = run;
    let edge = problem.edge();
    let is_elastic = problem.form().components() == 2;
    let mut text = format!(
        "# The contact edge: {} cone, solver {}, {} segments.\n{UNITS}\
         # edge: its number; s: arc length from the first node of that edge, the body on its left; x, y: the node.\n",
        solution.cone, solution.solver, run.n
    );
    text += if is_elastic {
        "# normal_x, normal_y: outward normal. u_N: displacement along it, <= 0. sigma_N: nodal contact force over\n\
         # the length that belongs to the node, <= 0.\n\
         edge,s,x,y,normal_x,normal_y,u_N,sigma_N\n"
    } else {
        "# u_N: u, <= 0. sigma_N: nodal contact force over the length that belongs to the node, <= 0.\n\
         edge,s,x,y,u_N,sigma_N\n"
    };
    let normals = if is_elastic { edge.normals()? } else { Vec::new() };
    for (number, piece) in edge.pieces().into_iter().enumerate() {
        let from = edge.arc()[piece.start];
        for i in piece {
            let [x, y] = edge.points()[i];
            let _ = write!(text, "{},{},{x},{y},", number + 1, edge.arc()[i] - from);
            if let Some([a, b]) = normals.get(number) {
                let _ = write!(text, "{a},{b},");
            }
            // Without a force the stress is 0, not -0.
            let (displacement, stress) = (solution.normal_displacement[i], 0.0 - solution.pressure[i]);
            let _ = writeln!(text, "{displacement},{stress}");
        }
    }
    Ok(text)
}
