//! The deformed body of a contact solution: an elastic body on its foundation, coloured by its largest shear
//! stress, or a membrane seen from the side, coloured by its displacement; with the contact pressure. Every
//! contact edge of an elastic body has its own floor, seen along its own normal.

use crate::Result;
use crate::figures::{BodyPicture, Floor, short};
use experiments::contact_levels::SceneRun;
use signorini::fem::stresses;
use std::ops::Range;
use std::path::{Path, PathBuf};

/// The largest displacement is drawn at most this long, relative to the extent of the body.
const DRAWN: f64 = 0.25;
/// The largest pressure arrow, relative to the extent of the body.
const ARROW: f64 = 0.15;
/// How far a floor reaches beyond its edge, relative to the extent of the body.
const FLOOR: f64 = 0.08;
/// How far a step into the page moves a membrane to the right and upwards.
const ASIDE: [f64; 2] = [0.4, 0.45];

/// Deformed places, a value for each triangle, arrows; displacements are magnified by 1, 2 or 5 times a power
/// of ten.
pub(super) struct Body<'a> {
    run: &'a SceneRun,
    magnification: f64,
    nodes: Vec<[f64; 2]>,
    values: Vec<f64>,
    arrows: Vec<([f64; 2], [f64; 2])>,
    floors: Vec<Floor>,
    /// The largest pressure.
    strongest: f64,
}

impl<'a> Body<'a> {
    /// # Errors
    /// Those of [`stresses`].
    pub(super) fn of(run: &'a SceneRun) -> Result<Self> {
        let SceneRun { problem, solution, .. } = run;
        let (mesh, u) = (problem.mesh(), &solution.displacement);
        let extent = extent(mesh.nodes()).max(f64::MIN_POSITIVE);
        let largest = u.iter().fold(0.0, |m: f64, u| m.max(u.abs()));
        let magnification = if largest > 0.0 { one_two_five(DRAWN * extent / largest) } else { 1.0 };
        let is_elastic = u.len() > mesh.nodes().len();
        let moved = |(node, &[x, y]): (usize, &[f64; 2])| {
            if is_elastic {
                [x + magnification * u[2 * node], y + magnification * u[2 * node + 1]]
            } else {
                [x + ASIDE[0] * y, ASIDE[1] * y + magnification * u[node]]
            }
        };
        let nodes: Vec<[f64; 2]> = mesh.nodes().iter().enumerate().map(moved).collect();
        let values = if is_elastic {
            stresses(mesh, problem.form(), u)?.iter().map(|stress| stress.max_shear()).collect()
        } else {
            mesh.triangles()
                .iter()
                .map(|corners| corners.map(|node| u[node]).iter().sum::<f64>() / 3.0)
                .collect()
        };
        let strongest = solution.pressure.iter().fold(0.0, |m: f64, p| m.max(p.abs()));
        let edge = problem.edge();
        // The floor presses against the normal; what keeps a membrane down presses from above.
        let outward = if is_elastic { edge.normals()? } else { vec![[0.0, 1.0]; edge.pieces().len()] };
        let pieces = || edge.pieces().into_iter().zip(&outward);
        let arrow = |i: usize, normal: &[f64; 2]| {
            let tip = nodes[edge.nodes()[i]];
            let length = ARROW * extent * solution.pressure[i] / strongest;
            ([tip[0] + length * normal[0], tip[1] + length * normal[1]], tip)
        };
        let pressed = |i: &usize| solution.pressure[*i] > 0.0;
        let arrows = pieces().flat_map(|(piece, n)| piece.filter(pressed).map(move |i| (i, n)));
        let arrows = arrows.map(|(i, n)| arrow(i, n)).collect();
        let floor = |(piece, &normal): (Range<usize>, &[f64; 2])| {
            let places: Vec<[f64; 2]> = edge.nodes()[piece.clone()].iter().map(|&node| nodes[node]).collect();
            Floor::under(edge.points()[piece.start], normal, &places, FLOOR * extent)
        };
        let floors = if is_elastic { pieces().map(floor).collect() } else { Vec::new() };
        Ok(Self { run, magnification, nodes, values, arrows, floors, strongest })
    }

    /// The smallest and the largest value.
    pub(super) fn range(&self) -> (f64, f64) {
        let ends = (f64::INFINITY, f64::NEG_INFINITY);
        self.values.iter().fold(ends, |(low, high), &value| (low.min(value), high.max(value)))
    }

    /// Draws it as `directory/name.svg`, on this scale of colour.
    ///
    /// # Errors
    /// Those of [`BodyPicture::save`].
    pub(super) fn save(
        &self,
        scene: &str,
        directory: &Path,
        name: &str,
        range: (f64, f64),
    ) -> Result<PathBuf> {
        let SceneRun { problem, solution, .. } = self.run;
        let is_elastic = solution.displacement.len() > self.nodes.len();
        let value_name =
            if is_elastic { "largest shear stress, in the unit of λ and μ" } else { "displacement u" };
        let same = if is_elastic { " in that unit" } else { "" };
        let picture = BodyPicture {
            title: format!("{scene}, displacement × {}, {} cone", short(self.magnification), solution.cone),
            nodes: &self.nodes,
            triangles: problem.mesh().triangles(),
            values: &self.values,
            range: Some(range),
            value_name: value_name.to_owned(),
            arrows: &self.arrows,
            arrow_name: format!("contact pressure, largest {}{same}", short(self.strongest)),
            floors: &self.floors,
        };
        picture.save(directory, name)
    }
}

/// The longer side of the box around the nodes.
fn extent(nodes: &[[f64; 2]]) -> f64 {
    let side = |k: usize| {
        let ends = (f64::INFINITY, f64::NEG_INFINITY);
        let (low, high) = nodes.iter().fold(ends, |(low, high), p| (low.min(p[k]), high.max(p[k])));
        high - low
    };
    side(0).max(side(1))
}

/// The largest 1, 2 or 5 times a power of ten not above `value` > 0.
fn one_two_five(value: f64) -> f64 {
    let decade = 10f64.powf(value.log10().floor());
    [5.0, 2.0, 1.0].into_iter().map(|m| m * decade).find(|&m| m <= value).unwrap_or(decade)
}
