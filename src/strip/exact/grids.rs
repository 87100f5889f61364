//! The grids N, N/2, N/4, ... below the grid of the exact data, with their layers and loads.

use crate::error::{Error, Result, ToolkitError};
use crate::strip::operator::scalar::check_layers;
use crate::strip::sides::LateralCondition;
use crate::strip::transfer::restrict;

/// The number of halvings, less than `levels`, from `fine` to `cells`.
pub(crate) fn level_of(fine: usize, cells: usize, levels: usize) -> Result<usize> {
    let level = (0..levels).find(|&level| fine >> level == cells);
    level.ok_or(Error::Toolkit(ToolkitError::CountOutOfRange {
        name: "cells",
        value: cells,
        range: "{N, N/2, N/4, ...}, N the number of cells of the reference grid",
    }))
}

pub(crate) fn power_of_two(cells: usize) -> Result<()> {
    if cells.is_power_of_two() && cells >= 2 {
        Ok(())
    } else {
        Err(Error::Toolkit(ToolkitError::CountOutOfRange {
            name: "cells",
            value: cells,
            range: "{2, 4, 8, 16, ...}",
        }))
    }
}

/// n·height as a whole number.
pub(crate) fn layers_on(cells: usize, height: (usize, usize)) -> Result<usize> {
    let (up, down) = height;
    if down == 0 || !(cells * up).is_multiple_of(down) {
        return Err(Error::Toolkit(ToolkitError::CountOutOfRange {
            name: "cells",
            value: cells,
            range: "{n: n*height is an integer}",
        }));
    }
    let layers = cells * up / down;
    check_layers(layers)?;
    Ok(layers)
}

/// The load and its restrictions P'b, P'P'b, ... down to two cells.
pub(crate) fn pyramid(force: Vec<f64>, sides: LateralCondition) -> Vec<Vec<f64>> {
    let smallest = sides.nodes(2);
    let mut loads = vec![force];
    while let Some(last) = loads.last() {
        if last.len() <= smallest {
            break;
        }
        let coarse = restrict(last, sides);
        loads.push(coarse);
    }
    loads
}
