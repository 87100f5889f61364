//! The contact problem whose solution behaves like r^p at one transition, on the mesh with n × n squares.

use super::power::{Power, TRANSITION};
use crate::contact::ContactProblem;
use crate::error::Result;
use crate::fem::Form;
use crate::mesh::{Part, SideParts, unit_square};

impl Power {
    /// The problem without its Dirichlet data; the load of the edge is integrated exactly.
    pub(super) fn problem(&self, n: usize) -> Result<ContactProblem> {
        let given = Part::Dirichlet;
        let mesh =
            unit_square(n, SideParts { bottom: Part::Contact, right: given, top: given, left: given })?;
        let form = self.lame.map_or(Form::LAPLACE, Form::elastic);
        let (c, mut load) = (form.components(), vec![0.0; mesh.nodes().len() * form.components()]);
        // In the direction of n: u_N is u, or −u_y.
        let normal = if c == 2 { -1.0 } else { 1.0 };
        let (h, q) = (1.0 / n as f64, self.power - 1.0);
        // ∫ r^q over the part and ∫ r^{q+1}, with r from `near` to `far`.
        let moment = |k: f64, near: f64, far: f64| (far.powf(q + k) - near.powf(q + k)) / (q + k);
        for i in 0..n {
            let (left, right) = (i as f64 * h, (i + 1) as f64 * h);
            for (size, side) in self.loads().into_iter().zip([-1.0, 1.0]) {
                let (low, high) =
                    if side < 0.0 { (left, right.min(TRANSITION)) } else { (left.max(TRANSITION), right) };
                if low >= high {
                    continue;
                }
                let distances = [low, high].map(|x| side * (x - TRANSITION));
                let (near, far) = (distances[0].min(distances[1]).max(0.0), distances[0].max(distances[1]));
                let (whole, first) = (moment(1.0, near, far), moment(2.0, near, far));
                // The hat function of the right node is (x − left)/h, x = a ± r.
                let right_part = ((TRANSITION - left) * whole + side * first) / h;
                load[(i + 2) * c - 1] += normal * size * right_part;
                load[(i + 1) * c - 1] += normal * size * (whole - right_part);
            }
        }
        let nothing = vec![0.0; load.len()];
        let mut problem = ContactProblem::new(mesh, form, &nothing)?;
        problem.add_load(&load)?;
        Ok(problem)
    }
}
