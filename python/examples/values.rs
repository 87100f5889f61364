//! Numbers of the Rust libraries, bit by bit, for `tests/test_rust.py`: one name and the bits of value and error a line.

use fractional_sobolev::{
    Constraint, Curve, Domain, DualOf, ErrorNorm, Estimate, Function, Gram, Mesh, Result,
    Triangles, gamma, interpolation_constant,
};
use signorini::cone::Cone;
use signorini::contact::{ContactProblem, Solver};
use signorini::fem::{Field, Form, Lame};
use signorini::mesh::{SideParts, unit_square};

fn show(name: &str, found: Estimate) {
    println!("{name} {:016x} {:016x}", found.value.to_bits(), found.error.to_bits());
}

fn main() -> Result<()> {
    let kink = Function::from_fn(&[0.0, 0.3, 1.0], |x| (x - 0.3).abs())?;
    show("norm", kink.norm(0.45, 1e-8)?);
    show("seminorm", kink.seminorm(0.7, 1e-8)?);
    let power = Function::from_positions(&[0.0, 0.3, 1.0], |at| at.distance_to(1).sqrt())?;
    show("distances", power.seminorm(0.6, 1e-8)?);
    let nodes: Vec<f64> = (0..=1000).map(|k| f64::from(k) / 1000.0).collect();
    let mesh = Mesh::from_nodes(&nodes)?;
    let values: Vec<f64> = nodes.iter().map(|x| x * (1.0 - x)).collect();
    show("array", Function::linears(&mesh, &values)?.norm(0.5, 1e-8)?);
    let load = Function::piecewise(&Mesh::from_nodes(&[0.0, 0.5, 1.0])?, 0, &[1.0, -1.0])?;
    show("dual", load.dual_norm(DualOf::Slobodeckij, 0.5, 1e-8)?);
    let interpolant = Function::linears(&Mesh::from_nodes(&[0.0, 0.5, 1.0])?, &[0.0, 0.25, 1.0])?;
    let square = Function::from_fn(&[0.0, 1.0], |x| x * x)?;
    show("error", square.minus(&interpolant)?.norm(0.5, 1e-6)?);
    for (k, value) in Gram::new(&Mesh::from_nodes(&[0.0, 0.25, 0.5, 1.0])?, 0.3, 1e-12)?
        .apply(&[1.0, 2.0, -1.0, 0.5])?
        .into_iter()
        .enumerate()
    {
        show(&format!("gram{k}"), Estimate::new(value, 0.0, Default::default())?);
    }
    let curve = Curve::algebraic(&[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]], 8, 2.0)?;
    let values: Vec<f64> = curve.nodes().iter().map(|[x, y]| x * y).collect();
    show("boundary", Function::on_curve(&curve, 1, &values)?.norm(-0.5, 1e-8)?);
    let plane =
        Triangles::new(&[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 1.0]], &[[0, 1, 3], [0, 3, 2]])?;
    show("plane", Function::on_triangles(&plane, 1, &[0.0, 1.0, 0.0, 1.0])?.norm(0.5, 1e-6)?);
    show("poincare", gamma(0.5, Constraint::mean_zero_on(0.0..1e-6), 1e-8)?.constant);
    let interval = interpolation_constant(Domain::Interval(1.0), ErrorNorm::Derivative, 0.5, 1e-9)?;
    show("interpolation", interval.constant);
    match hanging_square() {
        Ok(force) => show("contact", Estimate::new(force, 0.0, Default::default())?),
        Err(error) => println!("contact {error}"),
    }
    Ok(())
}

/// The contact force of a square that hangs over a floor.
fn hanging_square() -> signorini::Result<f64> {
    let mesh = unit_square(8, SideParts::HANGING)?;
    let load = Field::Vector(&|[x, _]| [0.0, 1.0 - 3.0 * x]).sample(mesh.nodes())?;
    let problem = ContactProblem::new(mesh, Form::elastic(Lame::new(1.0, 1.0)?), &load)?;
    Ok(problem.solve(Cone::Nodal, Solver::ActiveSet)?.contact_force)
}
