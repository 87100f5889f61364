//! Contact solutions in VTK format.

use super::problem::ContactProblem;
use super::solution::ContactSolution;
use crate::error::Result;
use crate::fem::{gradients, stresses};
use crate::numeric::check::require_length;
use std::fmt::Write;

impl ContactProblem {
    /// The text of a `.vtu` file (VTK XML, unstructured grid, ASCII) for ParaView and meshio: the triangles with
    /// - `displacement` at the nodes, three components, or one number for a scalar problem;
    /// - `pressure` −σ_N at the nodes of the contact edge, 0 elsewhere, and its indicator `contact_edge`;
    /// - `stress` (σ_xx, σ_yy, σ_xy), or `gradient` (u_x, u_y, 0), constant on each triangle.
    ///
    /// All values are written with full binary64 precision.
    ///
    /// ```
    /// use signorini::{cone::Cone, contact::Solver, problems::TestProblem};
    /// let problem = TestProblem::Block.problem(4)?;
    /// let text = problem.to_vtu(&problem.solve(Cone::Nodal, Solver::ActiveSet)?)?;
    /// assert!(text.starts_with("<?xml") && text.contains("Name=\"pressure\""));
    /// // std::fs::write("block.vtu", text)
    /// # Ok::<(), signorini::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`ToolkitError::LengthMismatch`](crate::ToolkitError::LengthMismatch) for a solution of another problem.
    #[doc(alias("VTK", "ParaView", "meshio", "export", "write", "file"))]
    pub fn to_vtu(&self, solution: &ContactSolution) -> Result<String> {
        self.to_vtu_with(solution, &[])
    }

    /// The same with further values of the triangles: their name, and one number or three for each.
    pub(crate) fn to_vtu_with(
        &self,
        solution: &ContactSolution,
        further: &[(&str, usize, &[f64])],
    ) -> Result<String> {
        let (mesh, components) = (self.mesh(), self.form().components());
        let (nodes, triangles) = (mesh.nodes(), mesh.triangles());
        require_length("displacement", solution.displacement.len(), components * nodes.len())?;
        let edge = self.edge().nodes();
        require_length("pressure", solution.pressure.len(), edge.len())?;
        let (mut pressure, mut marker) = (vec![0.0; nodes.len()], vec![0.0; nodes.len()]);
        for (&node, &value) in edge.iter().zip(&solution.pressure) {
            (pressure[node], marker[node]) = (value, 1.0);
        }
        let planar = |values: &[f64]| -> Vec<f64> {
            values.chunks(2).flat_map(|v| [v[0], v[1], 0.0]).collect()
        };
        let (displacement, width, on_triangles) = if components == 2 {
            let stress = stresses(mesh, self.form(), &solution.displacement)?;
            let values: Vec<f64> = stress.iter().flat_map(|s| [s.xx, s.yy, s.xy]).collect();
            (planar(&solution.displacement), 3, ("stress", values))
        } else {
            let gradient = gradients(mesh, &solution.displacement)?;
            (solution.displacement.clone(), 1, ("gradient", planar(gradient.as_flattened())))
        };
        let points = planar(nodes.as_flattened());
        let mut text = String::from("<?xml version=\"1.0\"?>\n");
        text += "<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" byte_order=\"LittleEndian\">\n<UnstructuredGrid>\n";
        let (count, cells) = (nodes.len(), triangles.len());
        let _ = writeln!(
            text,
            "<Piece NumberOfPoints=\"{count}\" NumberOfCells=\"{cells}\">\n<PointData>"
        );
        array(&mut text, "Float64", "displacement", width, &displacement);
        array(&mut text, "Float64", "pressure", 1, &pressure);
        array(&mut text, "Float64", "contact_edge", 1, &marker);
        text += "</PointData>\n<CellData>\n";
        array(&mut text, "Float64", on_triangles.0, 3, &on_triangles.1);
        for &(name, components, values) in further {
            array(&mut text, "Float64", name, components, values);
        }
        text += "</CellData>\n<Points>\n";
        array(&mut text, "Float64", "Points", 3, &points);
        text += "</Points>\n<Cells>\n";
        array(&mut text, "Int64", "connectivity", 1, triangles.as_flattened());
        array(&mut text, "Int64", "offsets", 1, &(1..=cells).map(|k| 3 * k).collect::<Vec<_>>());
        // 5: the number of VTK for a triangle
        array(&mut text, "UInt8", "types", 1, &vec![5; cells]);
        text += "</Cells>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
        Ok(text)
    }
}

/// One array, twelve numbers a line.
fn array(
    text: &mut String,
    kind: &str,
    name: &str,
    components: usize,
    values: &[impl std::fmt::Debug],
) {
    // Readers take a number of components for a second index, which scalars do not have.
    let width = if components > 1 {
        format!(" NumberOfComponents=\"{components}\"")
    } else {
        String::new()
    };
    let _ = writeln!(text, "<DataArray type=\"{kind}\" Name=\"{name}\"{width} format=\"ascii\">");
    for line in values.chunks(12) {
        for value in line {
            let _ = write!(text, "{value:?} ");
        }
        text.push('\n');
    }
    text.push_str("</DataArray>\n");
}

#[cfg(test)]
mod tests {
    use crate::cone::Cone;
    use crate::contact::Solver;
    use crate::problems::TestProblem;

    fn numbers(text: &str, name: &str) -> Vec<f64> {
        let from = text.split_once(&format!("Name=\"{name}\"")).unwrap().1;
        let body = from.split_once(">\n").unwrap().1.split_once("</DataArray>").unwrap().0;
        body.split_whitespace().map(|word| word.parse().unwrap()).collect()
    }

    #[test]
    fn every_number_is_read_back_as_it_is() {
        let problem = TestProblem::Block.problem(6).unwrap();
        let u = problem.solve(Cone::Nodal, Solver::ActiveSet).unwrap();
        let text = problem.to_vtu(&u).unwrap();
        let displacement: Vec<f64> =
            numbers(&text, "displacement").chunks(3).flat_map(|v| [v[0], v[1]]).collect();
        assert_eq!(displacement, u.displacement);
        let pressure = numbers(&text, "pressure");
        assert!(
            problem.edge().nodes().iter().zip(&u.pressure).all(|(&node, p)| pressure[node] == *p)
        );
        assert_eq!(numbers(&text, "contact_edge").iter().sum::<f64>(), u.pressure.len() as f64);
        let connectivity = numbers(&text, "connectivity");
        assert_eq!(connectivity.len(), 3 * problem.mesh().triangles().len());
        let other = TestProblem::Block.problem(4).unwrap();
        assert!(other.to_vtu(&u).is_err());
    }
}
