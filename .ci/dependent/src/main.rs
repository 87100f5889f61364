//! What a dependent of the published crates may write: a norm by the toolkit, contact of a block by the contact library.
use fractional_sobolev::Function;
use signorini::{cone::Cone, contact::Solver, problems::KnownSolution};

fn main() -> signorini::Result<()> {
    let norm = Function::from_fn(&[0.0, 1.0], |x| x.sqrt())?.seminorm(0.5, 1e-8)?;
    let known = KnownSolution::one_transition(None);
    let problem = known.problem(16)?;
    let solution = problem.solve(Cone::Nodal, Solver::ActiveSet)?;
    let error = known.error_norms(&problem, &solution.displacement)?.energy;
    println!("|sqrt(x)|_1/2 = {norm}; ‖u − u_h‖ = {error:.3e} for h = 1/16");
    Ok(())
}
