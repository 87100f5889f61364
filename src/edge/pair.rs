//! A complementary pair (u_N, σ_N) on the contact edge, represented by functions of finite norm.
//!
//! The inequalities of Sections 3 and 4 hold for functions of finite norm. On N equal cells of the edge (0, 1):
//!
//! | traces | u_N | u_N' | σ_N | \|u_N'\|_ν, \|σ_N\|_ν finite for |
//! | --- | --- | --- | --- | --- |
//! | [`Traces::Constants`] | linear on cells, continuous | constant on cells | as u_N' | ν < 1/2 (τ < 2) |
//! | [`Traces::Linears`] | quadratic on cells, C¹ | linear, continuous | as u_N' | ν < 3/2; used for 2 ≤ τ < 5/2 |
//!
//! *Constants.* u_N interpolates the nodal values. A nodal force λ_i is distributed evenly over those of the adjacent
//! cells (one or two) whose end points are both in contact, so that ∫ σ_N = −Σ λ_i, and on every cell u_N = 0 or
//! σ_N = 0.
//!
//! *Linears.* u_N' has the nodal values (u_{i+1} − u_{i−1})/(2δ), hence u_N(x_i) = (u_{i−1} + 2u_i + u_{i+1})/4: the
//! quadratic spline of the data, which is ≤ 0 and vanishes on a cell only when four nodal values do (at the ends of
//! the edge the data are extrapolated linearly). σ_N takes the nodal densities where both adjacent cells are in
//! contact, and 0 at all other nodes.
//!
//! In both cases u_N ≤ 0, σ_N ≤ 0 and σ_N u_N = 0 hold exactly at every point: the pair is the exact solution of a
//! contact problem on a strip, and every inequality of the proof applies to it with the norms of the continuous
//! functions.

use crate::error::{Error, Result};
use crate::strip::{EdgeData, LateralCondition};

/// The piecewise polynomials that represent u_N' and σ_N.
///
/// A piecewise constant function has a finite seminorm of order ν only for ν < 1/2, a continuous piecewise linear one
/// for ν < 3/2.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Traces {
    /// Piecewise constant: orders ν < 1/2.
    Constants,
    /// Continuous and piecewise linear: orders ν ≥ 1/2.
    Linears,
}

impl Traces {
    /// The kind of traces whose norms of order τ − 3/2 are finite.
    ///
    /// `Constants` for τ < 2, `Linears` for τ ≥ 2.
    ///
    /// ```
    /// use signorini::edge::Traces;
    /// assert_eq!(Traces::for_regularity(1.75), Traces::Constants);
    /// assert_eq!(Traces::for_regularity(2.0), Traces::Linears);
    /// ```
    pub fn for_regularity(tau: f64) -> Self {
        if tau < 2.0 { Traces::Constants } else { Traces::Linears }
    }
}

/// A pair (u_N, σ_N) on N equal cells of (0, 1), complementary at every point.
#[derive(Debug, Clone, PartialEq)]
pub struct ContactPair {
    traces: Traces,
    /// u_N at the nodes.
    values: Vec<f64>,
    /// u_N' at the left and right end of each cell.
    slopes: Vec<[f64; 2]>,
    /// −σ_N at the left and right end of each cell.
    pressures: Vec<[f64; 2]>,
}

impl ContactPair {
    /// The pair (u_N, σ_N) of a test problem of the strip; a periodic edge is cut at 0.
    ///
    /// ∫ σ_N = −Σ λ_i for [`Traces::Constants`], ∫ σ_N ≥ −Σ λ_i for [`Traces::Linears`]. The example verifies
    /// the consistency bound with the constant 1/2 on every segment,
    /// ∫_T σ_N (I^h u)_N ≤ ½ h_e^{2τ−2} |σ_N|_ν |u_N'|_ν.
    ///
    /// ```
    /// use signorini::edge::{ContactPair, Traces};
    /// use signorini::{problems::StripData, strip::LateralCondition};
    /// let data = StripData::Transition { position: 0.3 }.data(1.75, 256, LateralCondition::Natural)?;
    /// for norms in ContactPair::of_data(&data, Traces::Constants)?.norms(8, 0.25, 2.0)? {
    ///     let product = norms.stress.seminorm() * norms.slope.seminorm();
    ///     assert!(norms.nodal_term <= 0.5 * norms.length.powf(1.5) * product + 1e-14);
    /// }
    /// # Ok::<(), signorini::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::NotComplementary`] for [`Traces::Constants`] if no cell adjacent to a node with a force is in
    /// contact.
    pub fn of_data(edge_data: &EdgeData, traces: Traces) -> Result<Self> {
        let (mut values, mut forces) = (edge_data.values().to_vec(), edge_data.forces().to_vec());
        if edge_data.sides() == LateralCondition::Periodic {
            values.push(values[0]);
            // The force at a common node belongs to the cells on both sides.
            forces[0] *= 0.5;
            forces.push(forces[0]);
        }
        match traces {
            Traces::Constants => Self::constants(values, &forces),
            Traces::Linears => Ok(Self::linears(&values, &forces)),
        }
    }

    /// u_N' = (u_{i+1} − u_i)/δ on cell i; a force λ_i gives the density λ_i/(mδ) on each of the m ∈ {1, 2} closed cells at
    /// its node.
    fn constants(values: Vec<f64>, forces: &[f64]) -> Result<Self> {
        let cells = values.len() - 1;
        let n = cells as f64;
        let touching = |cell: usize| values[cell] == 0.0 && values[cell + 1] == 0.0;
        let mut pressures = vec![[0.0; 2]; cells];
        for (node, &force) in forces.iter().enumerate().filter(|(_, force)| **force != 0.0) {
            let beside = [node.checked_sub(1), (node < cells).then_some(node)];
            let carriers = beside.iter().flatten().filter(|&&cell| touching(cell)).count();
            if carriers == 0 {
                return Err(Error::NotComplementary { node, value: values[node], force });
            }
            for cell in beside.into_iter().flatten().filter(|&cell| touching(cell)) {
                let density = force * n / carriers as f64;
                pressures[cell].iter_mut().for_each(|p| *p += density);
            }
        }
        let slopes = values.windows(2).map(|u| [(u[1] - u[0]) * n; 2]).collect();
        Ok(Self { traces: Traces::Constants, values, slopes, pressures })
    }

    /// u_N' = (u_{i+1} − u_{i−1})/(2δ) at inner nodes, the one-sided quotient at the ends; densities λ_i/δ (2λ_i/δ at the
    /// ends) where both cells are closed.
    fn linears(data: &[f64], forces: &[f64]) -> Self {
        let cells = data.len() - 1;
        let n = cells as f64;
        let slope = |cell: usize| (data[cell + 1] - data[cell]) * n;
        let nodal_slope = |i: usize| match i {
            0 => slope(0),
            _ if i == cells => slope(cells - 1),
            _ => 0.5 * (data[i + 1] - data[i - 1]) * n,
        };
        let value = |i: usize| {
            if i == 0 || i == cells {
                data[i]
            } else {
                0.25 * (data[i - 1] + 2.0 * data[i] + data[i + 1])
            }
        };
        let values: Vec<f64> = (0..=cells).map(value).collect();
        let pressure = |i: usize| {
            let closed = values[i.saturating_sub(1)..=(i + 1).min(cells)].iter().all(|&u| u == 0.0);
            let share = if i == 0 || i == cells { 2.0 } else { 1.0 };
            if closed { share * n * forces[i] } else { 0.0 }
        };
        let ends = |f: &dyn Fn(usize) -> f64| -> Vec<[f64; 2]> {
            let nodal: Vec<f64> = (0..=cells).map(f).collect();
            nodal.windows(2).map(|pair| [pair[0], pair[1]]).collect()
        };
        let (slopes, pressures) = (ends(&nodal_slope), ends(&pressure));
        Self { traces: Traces::Linears, values, slopes, pressures }
    }

    /// The pair of kind [`Traces::Linears`] of the data u_N = −(x − a)₊^{τ−1}, σ_N = −(a − x)₊^{τ−2}: one
    /// transition, at x = a, of regularity 2 ≤ τ < 5/2.
    ///
    /// The leading terms of a solution of regularity τ near a transition: contact for x < a, no contact for x > a, so
    /// the segments left of a have u_N' = 0 and those right of a have σ_N = 0.
    ///
    /// ```
    /// use signorini::edge::ContactPair;
    /// let norms = ContactPair::smooth_transition(256, 0.5, 2.25)?.norms(4, 0.75, 2.0)?;
    /// assert_eq!(norms[0].depth, 0.0);
    /// assert_eq!(norms[3].force, 0.0);
    /// assert!(norms[0].force > 0.0 && norms[3].depth > 0.0);
    /// # Ok::<(), signorini::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`ToolkitError::OutOfRange`](crate::ToolkitError::OutOfRange) for a outside (0, 1) or τ outside [2, 5/2); as
    /// for [`EdgeData::new`] for the number of cells.
    pub fn smooth_transition(cells: usize, a: f64, tau: f64) -> Result<Self> {
        Error::require("position", a, "(0, 1)", a > 0.0 && a < 1.0)?;
        Error::require("tau", tau, "[2, 5/2)", (2.0..2.5).contains(&tau))?;
        let n = cells as f64;
        let place = |i: usize| i as f64 / n - a;
        let values =
            (0..=cells).map(|i| 0.0 - place(i).max(0.0).powf(tau - 1.0)).collect::<Vec<_>>();
        let force = |i: usize| {
            let share = if i == 0 || i == cells { 0.5 } else { 1.0 };
            if place(i) < 0.0 { share * (-place(i)).powf(tau - 2.0) / n } else { 0.0 }
        };
        let edge_data = EdgeData::new(
            cells,
            LateralCondition::Natural,
            &values,
            &(0..=cells).map(force).collect::<Vec<_>>(),
        )?;
        Self::of_data(&edge_data, Traces::Linears)
    }

    pub(super) fn traces(&self) -> Traces {
        self.traces
    }

    /// The number N of cells.
    pub fn cells(&self) -> usize {
        self.slopes.len()
    }

    /// The n equal contact segments of a coarse mesh.
    ///
    /// # Errors
    /// [`ToolkitError::CountOutOfRange`](crate::ToolkitError::CountOutOfRange) unless n divides N.
    pub(super) fn segments(&self, n: usize) -> Result<impl Iterator<Item = Segment<'_>>> {
        if n == 0 || !self.cells().is_multiple_of(n) {
            let range = "the set of divisors of the number of grid cells";
            return Err(Error::count("segments", n, range));
        }
        let width = self.cells() / n;
        Ok((0..n).map(move |i| self.segment(i * width, width)))
    }

    fn segment(&self, first: usize, width: usize) -> Segment<'_> {
        Segment {
            traces: self.traces,
            cell: 1.0 / self.cells() as f64,
            values: &self.values[first..=first + width],
            slopes: &self.slopes[first..first + width],
            pressures: &self.pressures[first..first + width],
        }
    }
}

/// The pair on one segment T ∩ Γ_C.
#[derive(Debug, Clone, Copy)]
pub(super) struct Segment<'a> {
    pub(super) traces: Traces,
    /// Length of a cell.
    pub(super) cell: f64,
    pub(super) values: &'a [f64],
    pub(super) slopes: &'a [[f64; 2]],
    pub(super) pressures: &'a [[f64; 2]],
}

impl Segment<'_> {
    /// h_e.
    pub(super) fn length(&self) -> f64 {
        self.cell * self.slopes.len() as f64
    }

    /// The degrees of freedom of a trace: one per cell, or one per node.
    pub(super) fn coefficients(&self, ends: &[[f64; 2]]) -> Vec<f64> {
        let mut left: Vec<f64> = ends.iter().map(|e| e[0]).collect();
        if let (Traces::Linears, Some(last)) = (self.traces, ends.last()) {
            left.push(last[1]);
        }
        left
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::problems::StripData;

    #[test]
    fn pairs_are_complementary_at_every_point_and_keep_the_force() {
        for (name, tau) in [
            ("transition", 1.75),
            ("transitions:5", 1.6),
            ("fat-cantor:6", 1.8),
            ("cantor:0.3", 2.0),
        ] {
            for sides in [LateralCondition::Natural, LateralCondition::Periodic] {
                let source: StripData = name.parse().unwrap();
                let edge_data = source.data(tau, 1 << 10, sides).unwrap();
                for traces in [Traces::Constants, Traces::Linears] {
                    let pair = ContactPair::of_data(&edge_data, traces).unwrap();
                    let edge = pair.segment(0, pair.cells());
                    for i in 0..pair.cells() {
                        let open = edge.values[i] != 0.0
                            || edge.values[i + 1] != 0.0
                            || edge.slopes[i] != [0.0; 2];
                        assert!(
                            edge.values[i] <= 0.0 && edge.pressures[i].iter().all(|&p| p >= 0.0)
                        );
                        assert!(
                            !open || edge.pressures[i] == [0.0; 2],
                            "{name} {traces:?} cell {i}"
                        );
                    }
                    let total: f64 =
                        edge.pressures.iter().map(|p| 0.5 * (p[0] + p[1])).sum::<f64>() * edge.cell;
                    let force: f64 = edge_data.forces().iter().sum();
                    match traces {
                        Traces::Constants => {
                            assert!((total - force).abs() < 1e-12 * force, "{name}")
                        }
                        Traces::Linears => assert!(total <= force && total > 0.0, "{name}"),
                    }
                }
            }
        }
    }

    #[test]
    fn the_slope_integrates_to_the_displacement() {
        let pair = ContactPair::smooth_transition(1 << 8, 0.3, 2.25).unwrap();
        let edge = pair.segment(0, pair.cells());
        for i in 0..pair.cells() {
            let step = 0.5 * edge.cell * (edge.slopes[i][0] + edge.slopes[i][1]);
            assert!((edge.values[i + 1] - edge.values[i] - step).abs() < 1e-14);
        }
        assert!(pair.segments(3).is_err() && pair.segments(0).is_err() && pair.segments(4).is_ok());
        assert!(ContactPair::smooth_transition(256, 0.3, 1.9).is_err());
    }
}
