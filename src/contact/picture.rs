//! Pictures of a contact solution: the deformed body on its foundation, and the contact edge.

use super::problem::ContactProblem;
use super::solution::ContactSolution;
use crate::error::Result;
use crate::fem::stresses;
use crate::figures::{Axis, BodyPicture, Chart, Series};
use std::path::{Path, PathBuf};

/// The largest displacement is drawn at most this long, relative to the extent of the body.
const DRAWN: f64 = 0.25;
/// The largest pressure arrow, relative to the extent of the body.
const ARROW: f64 = 0.15;

impl ContactSolution {
    /// Draws the deformed elastic body with its largest shear stress and the contact pressure as `directory/name.svg`.
    ///
    /// Displacements are magnified by 1, 2 or 5 times a power of ten, said in the title.
    ///
    /// # Errors
    /// Those of [`stresses`] (a scalar problem has none) and of [`BodyPicture::save`].
    pub fn save_body(
        &self,
        problem: &ContactProblem,
        scene: &str,
        directory: &Path,
        name: &str,
    ) -> Result<PathBuf> {
        let mesh = problem.mesh();
        let shear: Vec<f64> = stresses(mesh, problem.form(), &self.displacement)?
            .iter()
            .map(|stress| stress.max_shear())
            .collect();
        let extent =
            mesh.nodes().iter().flatten().fold(0.0, |m: f64, x| m.max(x.abs())).max(f64::MIN_POSITIVE);
        let largest = self.displacement.iter().fold(0.0, |m: f64, u| m.max(u.abs()));
        let magnification = if largest > 0.0 { one_two_five(DRAWN * extent / largest) } else { 1.0 };
        let moved = |node: usize| -> [f64; 2] {
            std::array::from_fn(|axis| {
                mesh.nodes()[node][axis] + magnification * self.displacement[2 * node + axis]
            })
        };
        let nodes: Vec<[f64; 2]> = (0..mesh.nodes().len()).map(moved).collect();
        let strongest = self.pressure.iter().fold(0.0, |m: f64, p| m.max(p.abs()));
        let length = |p: f64| if strongest > 0.0 { ARROW * extent * p / strongest } else { 0.0 };
        let arrows: Vec<([f64; 2], [f64; 2])> = problem
            .edge()
            .nodes()
            .iter()
            .zip(&self.pressure)
            .filter(|&(_, &p)| p > 0.0)
            .map(|(&node, &p)| ([nodes[node][0], nodes[node][1] - length(p)], nodes[node]))
            .collect();
        let foundation = problem.edge().points().first().map(|point| point[1]);
        let picture = BodyPicture {
            title: format!("{scene}, displacement × {magnification}, {} cone", self.cone),
            nodes: &nodes,
            triangles: mesh.triangles(),
            values: &shear,
            value_name: "largest shear stress (unit: Lamé's μ)".to_owned(),
            arrows: &arrows,
            arrow_name: format!("contact pressure, largest {strongest:.3}"),
            foundation,
        };
        picture.save(directory, name)
    }

    /// Draws u_N and −σ_N along the contact edge, each over its largest value, as `directory/name.svg`.
    ///
    /// # Errors
    /// Those of [`Chart::save`].
    pub fn save_edge(
        &self,
        problem: &ContactProblem,
        scene: &str,
        directory: &Path,
        name: &str,
    ) -> Result<PathBuf> {
        let arc = problem.edge().arc();
        let scaled = |values: &[f64]| -> Vec<(f64, f64)> {
            let largest = values.iter().fold(0.0, |m: f64, v| m.max(v.abs()));
            let unit = if largest > 0.0 { largest } else { 1.0 };
            arc.iter().zip(values).map(|(&x, v)| (x, v / unit)).collect()
        };
        let title = format!("{scene}: displacement and pressure on the contact edge, {} cone", self.cone);
        Chart::new(
            title,
            Axis::linear("x along the contact edge"),
            Axis::linear("share of the largest value"),
        )
        .with(Series::line("u_N, displacement towards the foundation", scaled(&self.normal_displacement)))
        .with(Series::line_and_points("−σ_N, contact pressure", scaled(&self.pressure)))
        .save(directory, name)
    }
}

/// The largest 1, 2 or 5 times a power of ten not above `value` > 0.
fn one_two_five(value: f64) -> f64 {
    let decade = 10f64.powf(value.log10().floor());
    [5.0, 2.0, 1.0].into_iter().map(|m| m * decade).find(|&m| m <= value).unwrap_or(decade)
}
