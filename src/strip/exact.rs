//! Exact energy-norm errors of the scalar strip from its edge alone.
//!
//! g is the exact edge shape on a fine grid of N cells; u is either the discrete solution on the fine strip or the
//! continuous harmonic function above the piecewise linear g. For a coarse solution with edge shape g_h, no volume load,
//!
//! |u − u_h|²_a = ⟨T d, d⟩ + ⟨G g_h, g_h⟩,  d = g − P g_h:
//!
//! the fine energy of the difference at the edge, and what the coarse mesh stores too much in the interior (module
//! `defect`). Both are sums of nonnegative terms over modes, so nothing cancels; the plain difference of energies loses
//! six and more digits at n = 2^18. Cost: one transform of length N per error.

use super::defect::{halving, harmonic_defect, harmonic_symbol};
use super::edge::EdgeOperator;
use super::edge_data::EdgeData;
use super::scalar::{EdgeLoad, check_layers, scalar_symbol};
use super::sides::Sides;
use super::transfer::{prolong, restrict};
use crate::error::{Error, Result};
use crate::estimate::{Estimate, Work};
use crate::numeric::check::require_length;
use std::f64::consts::PI;
use std::fmt;
use std::str::FromStr;

/// What the discrete solutions are compared with.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Reference {
    /// The discrete solution on the strip of the fine grid.
    Nested,
    /// The continuous harmonic function above the fine edge data.
    Harmonic,
}

impl fmt::Display for Reference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Reference::Nested => "nested",
            Reference::Harmonic => "harmonic",
        })
    }
}

impl FromStr for Reference {
    type Err = Error;

    fn from_str(text: &str) -> Result<Self> {
        match text {
            "nested" => Ok(Reference::Nested),
            "harmonic" => Ok(Reference::Harmonic),
            _ => Err(Error::UnknownName {
                what: "reference",
                given: text.to_owned(),
                expected: "nested or harmonic",
            }),
        }
    }
}

/// Exact edge data g, λ on a fine grid, its loads on all coarser grids, and errors against it.
#[derive(Debug, Clone)]
pub struct ExactEdge {
    values: Vec<f64>,
    /// |g|_a.
    norm: f64,
    cells: usize,
    layers_per_cell: (usize, usize),
    reference: Reference,
    operator: EdgeOperator,
    /// Loads on N, N/2, N/4, ... cells.
    loads: Vec<Vec<f64>>,
    /// G on N/2, N/4, ... cells (nested reference only).
    defects: Vec<Vec<f64>>,
}

impl ExactEdge {
    /// The scene as exact solution on the strip of height `height.0/height.1`; natural sides.
    ///
    /// # Errors
    /// [`Error::DoesNotFit`] for a periodic scene, [`Error::CountOutOfRange`] unless N is a power of two and the
    /// height gives a whole number of layers on it.
    pub fn scalar(scene: &EdgeData, height: (usize, usize), reference: Reference) -> Result<Self> {
        if scene.sides() != Sides::Natural {
            return Err(Error::DoesNotFit {
                what: "sides",
                given: format!("{:?}", scene.sides()),
                expected: "natural sides for the scalar strip",
            });
        }
        let cells = scene.cells();
        power_of_two(cells)?;
        let layers = layers_on(cells, height)? as f64;
        let symbol = (0..=cells)
            .map(|k| {
                let theta = PI * k as f64 / cells as f64;
                match reference {
                    Reference::Nested => scalar_symbol(theta, layers),
                    Reference::Harmonic => harmonic_symbol(theta, layers),
                }
            })
            .collect();
        let operator = EdgeOperator::new(cells, Sides::Natural, symbol)?;
        let defects = match reference {
            Reference::Nested => nested_defects(cells, layers),
            Reference::Harmonic => Vec::new(),
        };
        let mut exact = Self {
            values: Vec::new(),
            norm: 0.0,
            cells,
            layers_per_cell: height,
            reference,
            operator,
            loads: Vec::new(),
            defects,
        };
        exact.set_scene(scene)?;
        Ok(exact)
    }

    /// Replaces the scene by another one on the same fine grid.
    ///
    /// # Errors
    /// [`Error::LengthMismatch`] when the grid is another one.
    pub fn set_scene(&mut self, scene: &EdgeData) -> Result<()> {
        let mut force = self.operator.apply(scene.values())?;
        force.iter_mut().zip(scene.forces()).for_each(|(b, l)| *b += l);
        self.loads = pyramid(force, Sides::Natural);
        self.values = scene.values().to_vec();
        self.norm = self.operator.energy(scene.values())?.sqrt();
        Ok(())
    }

    /// Number of cells N of the fine grid.
    pub fn cells(&self) -> usize {
        self.cells
    }

    /// Layers of the strip with `cells` cells.
    ///
    /// # Errors
    /// [`Error::CountOutOfRange`] when the height is not a whole number of them.
    pub fn layers(&self, cells: usize) -> Result<usize> {
        layers_on(cells, self.layers_per_cell)
    }

    /// The load of the scene on the edge of `cells` cells.
    ///
    /// # Errors
    /// [`Error::CountOutOfRange`] unless `cells` is N divided by a power of two.
    pub fn load(&self, cells: usize) -> Result<EdgeLoad> {
        let level = self.level(cells)?;
        Ok(EdgeLoad::on_edge(self.loads[level].clone()))
    }

    /// |u − u_h|_a, the energy norm of the error of the discrete solution with edge values `values` on `cells` cells.
    ///
    /// # Errors
    /// As [`ExactEdge::load`]; [`Error::LengthMismatch`].
    pub fn error(&self, cells: usize, values: &[f64]) -> Result<Estimate> {
        let level = self.level(cells)?;
        require_length("edge values", values.len(), cells + 1)?;
        let mut fine = values.to_vec();
        for step in (0..level).rev() {
            fine = prolong(&fine, (self.cells >> step) + 1);
        }
        let difference: Vec<f64> = self.values.iter().zip(&fine).map(|(g, p)| g - p).collect();
        let edge = self.operator.energy(&difference)?;
        let interior = self.interior(level, cells, values)?;
        let square = edge + interior;
        // d is known to ε|g|; by Cauchy and Schwarz that moves |u − u_h| by at most ε |g|_a.
        let shift = f64::EPSILON * self.norm;
        let work = Work { points: self.values.len() as u64, ..Work::default() };
        Estimate::new(square.sqrt(), shift + 1e-14 * square.sqrt(), work)
    }

    /// ⟨G g_h, g_h⟩.
    fn interior(&self, level: usize, cells: usize, values: &[f64]) -> Result<f64> {
        let layers = self.layers(cells)? as f64;
        let coarse = EdgeOperator::new(cells, Sides::Natural, vec![1.0; cells + 1])?;
        let modes = coarse.modes(values);
        Ok(match self.reference {
            Reference::Nested if level == 0 => 0.0,
            Reference::Nested => coarse.mode_sum(&modes, |k| self.defects[level - 1][k]),
            Reference::Harmonic => {
                coarse.mode_sum(&modes, |k| harmonic_defect(PI * k as f64 / cells as f64, layers))
            }
        })
    }

    fn level(&self, cells: usize) -> Result<usize> {
        level_of(self.cells, cells, self.loads.len())
    }
}

/// How often `fine` is halved to give `cells`, less than `levels` times.
pub(crate) fn level_of(fine: usize, cells: usize, levels: usize) -> Result<usize> {
    let level = (0..levels).find(|&level| fine >> level == cells);
    level.ok_or(Error::CountOutOfRange {
        name: "cells",
        value: cells,
        range: "the halvings of the reference grid",
    })
}

pub(crate) fn power_of_two(cells: usize) -> Result<()> {
    if cells.is_power_of_two() && cells >= 2 {
        Ok(())
    } else {
        Err(Error::CountOutOfRange { name: "cells", value: cells, range: "the powers of two from 2" })
    }
}

/// n·height as a whole number.
pub(crate) fn layers_on(cells: usize, height: (usize, usize)) -> Result<usize> {
    let (up, down) = height;
    if down == 0 || !(cells * up).is_multiple_of(down) {
        return Err(Error::CountOutOfRange {
            name: "cells",
            value: cells,
            range: "the numbers n with n·height whole",
        });
    }
    let layers = cells * up / down;
    check_layers(layers)?;
    Ok(layers)
}

/// The load and its restrictions P'b, P'P'b, ... down to two cells.
pub(crate) fn pyramid(force: Vec<f64>, sides: Sides) -> Vec<Vec<f64>> {
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

/// G on N/2, N/4, ..., 2 cells against N cells with `layers` layers.
fn nested_defects(cells: usize, layers: f64) -> Vec<Vec<f64>> {
    let mut defects: Vec<Vec<f64>> = Vec::new();
    let (mut n, mut m) = (cells / 2, 0.5 * layers);
    while n >= 2 {
        let finer = defects.last();
        let level = (0..=n)
            .map(|k| {
                let theta = PI * k as f64 / n as f64;
                let own = halving(theta, m);
                finer.map_or(own, |g| {
                    let (s, c) = (0.25 * theta).sin_cos();
                    own + 2.0 * (c.powi(4) * g[k] + s.powi(4) * g[2 * n - k])
                })
            })
            .collect();
        defects.push(level);
        n /= 2;
        m *= 0.5;
    }
    defects
}
