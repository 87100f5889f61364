//! Nested refinement with all levels stored: uniform (red), or local by longest-edge bisection.
//!
//! In uniform refinement every triangle is cut into four similar ones by its edge midpoints, so the P1 spaces are
//! nested and a function of level k is a function of level k + 1: its value at a new node is the mean over the ends
//! of the bisected edge. Cost of a refinement: O(number of triangles).

use super::bisection::{bisect, red};
use super::geometry::{Point, distance, middle};
use super::triangulation::Triangulation;
use crate::error::{Error, Result};
use crate::numeric::check::require_length;
use crate::numeric::check::require_memory;

/// Bytes per triangle of a refined mesh: its corners, half a node, and the edges it is made from.
const BYTES_OF_TRIANGLE: usize = 60;

/// A triangulation and its refinements, coarsest first.
///
/// The P1 spaces are nested, V₀ ⊂ V₁ ⊂ ..., so the minimum of an energy over V_k does not increase with k.
#[derive(Debug, Clone)]
pub struct Hierarchy {
    levels: Vec<Triangulation>,
    /// For level k > 0, the two parents of every node that is new on it.
    parents: Vec<Vec<[usize; 2]>>,
    /// The triangle of the level before from which every triangle of the finest level comes.
    origins: Vec<u32>,
}

impl Hierarchy {
    /// The hierarchy that consists of a single level.
    pub fn new(coarsest: Triangulation) -> Self {
        Self { levels: vec![coarsest], parents: Vec::new(), origins: Vec::new() }
    }

    /// The hierarchy of `coarsest` and `times` uniform refinements.
    ///
    /// ```
    /// use signorini::mesh::{Hierarchy, SideParts, unit_square};
    /// let hierarchy = Hierarchy::refined(unit_square(2, SideParts::HANGING)?, 3)?;
    /// assert_eq!(hierarchy.finest().triangles().len(), 8 * 64);
    /// # Ok::<(), signorini::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`ToolkitError::CountOutOfRange`](crate::ToolkitError::CountOutOfRange) if the finest level would have more
    /// than 2^32 triangles, [`ToolkitError::TooLarge`](crate::ToolkitError::TooLarge) if there is not enough memory.
    pub fn refined(coarsest: Triangulation, times: usize) -> Result<Self> {
        let mut hierarchy = Self::new(coarsest);
        for _ in 0..times {
            hierarchy.refine()?;
        }
        Ok(hierarchy)
    }

    /// Adds a level by uniform refinement.
    ///
    /// It has four times as many triangles, all similar to their parents: the mesh size is halved.
    ///
    /// ```
    /// use signorini::mesh::{Hierarchy, SideParts, unit_square};
    /// let mut hierarchy = Hierarchy::new(unit_square(2, SideParts::HANGING)?);
    /// hierarchy.refine()?;
    /// let [coarse, fine] = [0, 1].map(|level| hierarchy.levels()[level].clone());
    /// assert_eq!((coarse.triangles().len(), fine.triangles().len()), (8, 32));
    /// assert_eq!(fine.mesh_size(), 0.5 * coarse.mesh_size());
    /// # Ok::<(), signorini::Error>(())
    /// ```
    ///
    /// # Errors
    /// As for [`Hierarchy::refined`].
    pub fn refine(&mut self) -> Result<()> {
        let coarse = self.finest();
        if coarse.triangles().len() > 1 << 30 {
            return Err(Error::count("triangles to refine", coarse.triangles().len(), "[1, 2^30]"));
        }
        require_memory("triangles", 4 * coarse.triangles().len(), BYTES_OF_TRIANGLE)?;
        let (fine, parents, origins) = red(coarse)?;
        self.levels.push(fine);
        self.parents.push(parents);
        self.origins = origins;
        Ok(())
    }

    /// Adds a level on which the triangles selected by `marked` are cut into four, and their neighbours as required
    /// for a conforming mesh with angles bounded below (longest-edge bisection).
    ///
    /// ```
    /// use signorini::mesh::{Hierarchy, Part, SideParts, unit_square};
    /// let mut hierarchy = Hierarchy::new(unit_square(4, SideParts::HANGING)?);
    /// let on = hierarchy.finest().nodes_on(Part::Contact);
    /// hierarchy.refine_where(|mesh, t| mesh.triangles()[t].iter().any(|&node| on[node]))?;
    /// assert!(hierarchy.finest().triangles().len() > 32);
    /// # Ok::<(), signorini::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`ToolkitError::Edge`](crate::ToolkitError::Edge) for an inconsistent triangulation; memory is not
    /// checked.
    pub fn refine_where(&mut self, marked: impl Fn(&Triangulation, usize) -> bool) -> Result<()> {
        let coarse = self.finest();
        let chosen: Vec<bool> = (0..coarse.triangles().len()).map(|t| marked(coarse, t)).collect();
        let (fine, parents, origins) = bisect(coarse, &chosen)?;
        self.levels.push(fine);
        self.parents.push(parents);
        self.origins = origins;
        Ok(())
    }

    /// Adds `times` levels around a point: on level k = 0, 1, ... the triangles whose centroid is closer to the point
    /// than 2^−k `radius` are cut. The meshes of successive annuli are similar.
    ///
    /// ```
    /// use signorini::mesh::{Hierarchy, SideParts, unit_square};
    /// let mut hierarchy = Hierarchy::new(unit_square(4, SideParts::HANGING)?);
    /// hierarchy.refine_around([0.5, 0.0], 0.5, 2)?;
    /// let sizes: Vec<f64> = hierarchy.levels().iter().map(|mesh| mesh.mesh_size()).collect();
    /// assert!(sizes.windows(2).all(|pair| pair[1] <= pair[0]));
    /// assert!(hierarchy.refine_around([0.5, 0.0], 0.0, 1).is_err());
    /// # Ok::<(), signorini::Error>(())
    /// ```
    ///
    /// # Errors
    /// As for [`Hierarchy::refine_where`]; [`ToolkitError::OutOfRange`](crate::ToolkitError::OutOfRange)
    /// unless the radius is positive and finite.
    pub fn refine_around(&mut self, point: Point, radius: f64, times: usize) -> Result<()> {
        Error::require("radius", radius, "(0, inf)", radius > 0.0 && radius.is_finite())?;
        let mut radius = radius;
        for _ in 0..times {
            self.refine_where(|mesh, t| distance(middle(mesh.corners(t)), point) < radius)?;
            radius *= 0.5;
        }
        Ok(())
    }

    /// The levels, coarsest first.
    pub fn levels(&self) -> &[Triangulation] {
        &self.levels
    }

    /// The finest level.
    pub fn finest(&self) -> &Triangulation {
        // A hierarchy is never empty: it starts with one level and only grows.
        &self.levels[self.levels.len() - 1]
    }

    /// The hierarchy of the levels up to the given one; all of them if there are fewer.
    ///
    /// ```
    /// use signorini::mesh::{Hierarchy, SideParts, unit_square};
    /// let hierarchy = Hierarchy::refined(unit_square(1, SideParts::HANGING)?, 2)?;
    /// assert_eq!(hierarchy.up_to(1).finest(), &hierarchy.levels()[1]);
    /// assert_eq!(hierarchy.up_to(9).levels().len(), 3);
    /// # Ok::<(), signorini::Error>(())
    /// ```
    #[must_use]
    pub fn up_to(&self, level: usize) -> Self {
        let last = level.min(self.levels.len() - 1);
        Self {
            levels: self.levels[..=last].to_vec(),
            parents: self.parents[..last].to_vec(),
            origins: Vec::new(),
        }
    }

    /// The triangle of the level before from which every triangle of the finest level comes.
    pub(crate) fn origins(&self) -> &[u32] {
        &self.origins
    }

    /// Keeps the finest level only.
    pub(crate) fn forget(&mut self) {
        self.levels.drain(..self.levels.len() - 1);
        self.parents.clear();
    }

    /// The two nodes of level k − 1 in the middle of which every node of level k > 0 lies; twice the same for
    /// a node that was there already.
    pub(crate) fn parents(&self, level: usize) -> Vec<[u32; 2]> {
        let old = 0..self.levels[level - 1].nodes().len() as u32;
        let new = self.parents[level - 1].iter().map(|pair| pair.map(|node| node as u32));
        old.map(|node| [node; 2]).chain(new).collect()
    }

    /// The nodal values on level `to` ≥ `from` of the function with nodal values `values` on level `from`,
    /// `components` per node.
    ///
    /// ```
    /// use signorini::mesh::{Hierarchy, SideParts, unit_square};
    /// let hierarchy = Hierarchy::refined(unit_square(1, SideParts::HANGING)?, 1)?;
    /// let x: Vec<f64> = hierarchy.levels()[0].nodes().iter().map(|p| p[0]).collect();
    /// let fine = hierarchy.prolong(0, 1, 1, &x)?;
    /// assert!(fine.iter().zip(hierarchy.finest().nodes()).all(|(u, p)| *u == p[0]));
    /// # Ok::<(), signorini::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`ToolkitError::CountOutOfRange`](crate::ToolkitError::CountOutOfRange) for levels that do not exist or are in
    /// the wrong order, [`ToolkitError::LengthMismatch`](crate::ToolkitError::LengthMismatch) for a wrong number of
    /// values.
    pub fn prolong(
        &self,
        from: usize,
        to: usize,
        components: usize,
        values: &[f64],
    ) -> Result<Vec<f64>> {
        if from > to || to >= self.levels.len() {
            return Err(Error::count("target level", to, "[source level, finest level]"));
        }
        require_length("nodal values", values.len(), self.levels[from].nodes().len() * components)?;
        let mut values = values.to_vec();
        for parents in &self.parents[from..to] {
            values.reserve(parents.len() * components);
            for &[a, b] in parents {
                for c in 0..components {
                    values
                        .push(0.5 * values[a * components + c] + 0.5 * values[b * components + c]);
                }
            }
        }
        Ok(values)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{SideParts, unit_square};

    #[test]
    fn red_refinement_of_the_square_is_the_finer_square() {
        let hierarchy = Hierarchy::refined(unit_square(2, SideParts::HANGING).unwrap(), 2).unwrap();
        let key = |mesh: &Triangulation| {
            let mut corners: Vec<_> = (0..mesh.triangles().len())
                .map(|t| {
                    let mut corners =
                        mesh.corners(t).map(|[x, y]| ((x * 8.0) as usize, (y * 8.0) as usize));
                    corners.sort_unstable();
                    corners
                })
                .collect();
            corners.sort_unstable();
            corners
        };
        assert_eq!(key(hierarchy.finest()), key(&unit_square(8, SideParts::HANGING).unwrap()));
        let checked = Triangulation::new(
            hierarchy.finest().nodes(),
            hierarchy.finest().triangles(),
            hierarchy.finest().boundary(),
        );
        assert_eq!(&checked.unwrap(), hierarchy.finest());
    }

    #[test]
    fn shells_around_a_point_are_the_same_but_for_scale() {
        let mut hierarchy = Hierarchy::new(unit_square(16, SideParts::HANGING).unwrap());
        hierarchy.refine_around([1.0, 0.0], 0.25, 30).unwrap();
        let counts: Vec<usize> =
            hierarchy.levels().iter().map(|mesh| mesh.triangles().len()).collect();
        let added: Vec<usize> = counts.windows(2).map(|pair| pair[1] - pair[0]).collect();
        assert!(added[4..].windows(3).all(|three| three[0] == three[2]), "{added:?}");
        for wrong in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            assert!(hierarchy.refine_around([1.0, 0.0], wrong, 1).is_err());
        }
    }
}
