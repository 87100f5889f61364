//! What `extremes` plants: hard input with its value found another way, and input that has no answer.

use fractional_sobolev::{Constraint, Function, Gram, Mesh, Order, Tolerance, closed_forms, gamma, law};
use signorini::cone::Cone;
use signorini::contact::Solver;
use signorini::mesh::{Part, SideParts, unit_square};
use signorini::problems::{Parameters, TestProblem};
use signorini::{Error, Result, ToolkitError};

/// A value and the same value found another way.
pub type Pair = (f64, f64);
/// Planted, what is computed and against what, and the computation.
pub type Hard = (&'static str, &'static str, fn() -> Result<Pair>);
/// Planted, what is asked, the question, and whether an error is the one that names what is wrong.
pub type Bad = (&'static str, &'static str, fn() -> Result<f64>, fn(&Error) -> bool);

/// Input that is hard and admissible.
pub const ADMISSIBLE: [Hard; 14] = [
    ("order 1e-300", "seminorm of x, closed form", || ramp(Order::new(1e-300)?, 1.0, 1.0)),
    ("order 1 - 2^-52", "seminorm of x, closed form", || ramp(Order::new(1.0 - f64::EPSILON)?, 1.0, 1.0)),
    ("interval of length 1e-300", "seminorm of a ramp, scaling", || ramp(Order::new(0.3)?, 1e-300, 1.0)),
    ("interval of length 1e300", "seminorm of a ramp, scaling", || ramp(Order::new(0.9)?, 1e300, 1.0)),
    ("values of size 1e150", "seminorm of a ramp, scaling", || ramp(Order::new(0.7)?, 1.0, 1e150)),
    ("cells of length 1e-300 beside 1", "seminorm of a hat, same over 1e-20", || {
        Ok((hat(1e-300)?, hat(1e-20)?))
    }),
    ("a million cells", "seminorm of a step, closed form", million_cells),
    ("zone of length 1e-300, order 1/2", "gamma, uniform law", short_zone),
    ("zone 1e-300, order 3/4", "gamma, one point", || {
        let order = Order::new(0.75)?;
        let zone = gamma(order, Constraint::mean_zero_on(0.0..1e-300), Tolerance::balanced())?.constant;
        Ok((zone.value, gamma(order, Constraint::vanishing_at(0.0), Tolerance::balanced())?.constant.value))
    }),
    ("load of size 1e-150", "contact force, scaling", || scaled_load(1e-150)),
    ("load of size 1e150", "contact force, scaling", || scaled_load(1e150)),
    ("Poisson's ratio 1/2 - 1e-6", "energy, other solver", || {
        energies(TestProblem::Incompressible, Parameters { poisson: 0.5 - 1e-6, ..Parameters::default() })
    }),
    ("contact nowhere", "energy, other solver", || energies(TestProblem::Free, Parameters::default())),
    ("contact everywhere", "contact force, other solver", || {
        let solution = TestProblem::Closed.problem(16)?.solve(Cone::Nodal, Solver::ActiveSet)?;
        let other = TestProblem::Closed.problem(16)?.solve(Cone::Nodal, Solver::InteriorPoint)?;
        Ok((solution.contact_force, other.contact_force))
    }),
];

/// Input that has no answer.
pub const INADMISSIBLE: [Bad; 8] = [
    ("order NaN", "any norm", || Ok(Order::new(f64::NAN)?.value()), out_of_range),
    (
        "a step, order 1/2",
        "seminorm",
        || {
            let step = Function::from_fn(&[0.0, 0.5, 1.0], |x: f64| if x < 0.5 { 0.0 } else { 1.0 })?;
            Ok(step.seminorm(Order::HALF, Tolerance::fast())?.value)
        },
        infinite,
    ),
    (
        "|ln x|^0.6, order 1/2",
        "seminorm",
        || {
            let slow = Function::from_positions(&[0.0, 1.0], |at| match at.anchor() {
                0 => (-at.offset().ln()).powf(0.6),
                _ => (-at.offset().ln_1p()).powf(0.6),
            })?;
            Ok(slow.seminorm(Order::HALF, Tolerance::fast())?.value)
        },
        infinite,
    ),
    (
        "a function with value NaN",
        "seminorm",
        || {
            let torn = Function::from_fn(&[0.0, 1.0], |x: f64| if x > 0.5 { f64::NAN } else { x })?;
            Ok(torn.seminorm(Order::HALF, Tolerance::fast())?.value)
        },
        |error| matches!(error, Error::Toolkit(ToolkitError::NotFinite { .. })),
    ),
    (
        "a node given twice",
        "any norm",
        || Ok(Mesh::from_nodes(&[0.0, 0.5, 0.5, 1.0])?.nodes()[0]),
        |error| matches!(error, Error::Toolkit(ToolkitError::EntryOutOfRange { .. })),
    ),
    (
        "a zone of length 0, order 1/2",
        "gamma",
        || Ok(gamma(Order::HALF, Constraint::mean_zero_on(0.0..0.0), Tolerance::fast())?.constant.value),
        out_of_range,
    ),
    ("16 digits asked", "gamma", || Ok(Tolerance::new(1e-16)?.relative()), out_of_range),
    (
        "a body that nothing holds",
        "displacement",
        || {
            let sides = SideParts {
                bottom: Part::Contact,
                right: Part::Neumann,
                top: Part::Neumann,
                left: Part::Neumann,
            };
            Ok(TestProblem::Block.on(unit_square(4, sides)?)?.solve(Cone::Nodal, Solver::ActiveSet)?.energy)
        },
        |error| matches!(error, Error::Toolkit(ToolkitError::CountOutOfRange { .. })),
    ),
];

/// A parameter outside its range.
fn out_of_range(error: &Error) -> bool {
    matches!(error, Error::Toolkit(ToolkitError::OutOfRange { .. }))
}

fn infinite(error: &Error) -> bool {
    matches!(error, Error::Toolkit(ToolkitError::InfiniteNorm { .. }))
}

/// |x|_ν on (0, L), height H: H L^{1/2 − ν} / √((1−ν)(3−2ν)).
fn ramp(order: Order, length: f64, height: f64) -> Result<Pair> {
    let values = [0.0, 0.25, 0.5, 0.75, 1.0].map(|v| v * height);
    let u = Function::linears(&Mesh::uniform(4, length)?, &values)?;
    let unit = ((1.0 - order.value()) * (1.0 + 2.0 * (1.0 - order.value()))).sqrt().recip();
    let exact = height * unit * length.powf(-order.offset());
    Ok((u.seminorm(order, Tolerance::reference())?.value, exact))
}

/// At ν = 1/2 the seminorm does not see scale.
fn hat(width: f64) -> Result<f64> {
    let mesh = Mesh::from_lengths(vec![1.0, width, width, 1.0])?;
    let u = Function::linears(&mesh, &[0.0, 0.0, 1.0, 0.0, 0.0])?;
    Ok(u.seminorm(Order::HALF, Tolerance::reference())?.value)
}

fn million_cells() -> Result<Pair> {
    let (n, order) = (1_000_000, Order::new(0.25)?);
    let operator = Gram::constants(&Mesh::uniform(n, 1.0)?, order, Tolerance::reference())?;
    let step: Vec<f64> = (0..n).map(|i| if i < n / 2 { 0.0 } else { 1.0 }).collect();
    let form: f64 = step.iter().zip(operator.apply(&step)?).map(|(x, y)| x * y).sum();
    Ok((form, closed_forms::jump_seminorm_squared(0.5, 0.5, order)?.value))
}

fn short_zone() -> Result<Pair> {
    let (order, tolerance) = (Order::HALF, Tolerance::new(1e-10)?);
    let found = gamma(order, Constraint::mean_zero_on(0.0..1e-300), tolerance)?.constant;
    Ok((found.value, law(order, 0.0, tolerance)?.at(1e-300)?.value))
}

fn scaled_load(load_scale: f64) -> Result<Pair> {
    let force = |load_scale| -> Result<f64> {
        let problem =
            TestProblem::Block.problem_with(16, &Parameters { load_scale, ..Parameters::default() })?;
        Ok(problem.solve(Cone::Nodal, Solver::ActiveSet)?.contact_force)
    };
    Ok((force(load_scale)?, load_scale * force(1.0)?))
}

fn energies(scene: TestProblem, setting: Parameters) -> Result<Pair> {
    let problem = scene.problem_with(16, &setting)?;
    let energy = |solver| problem.solve(Cone::Nodal, solver).map(|solution| solution.energy);
    Ok((energy(Solver::ActiveSet)?, energy(Solver::InteriorPoint)?))
}
