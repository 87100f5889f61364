use signorini::cone::Cone; use signorini::contact::Body; use signorini::fem::*; use signorini::mesh::*; use signorini::bounds::*;
use std::f64::consts::PI;
fn main() -> signorini::Result<()> {
    for n in [64, 128, 256] {
        let body = Body::new(unit_square(n, SideParts::HANGING)?, Form::elastic(Lame::new(1.0, 1.0)?)).load(|[x, _]: [f64; 2]| [0.0, -(PI * x).cos()]);
        let t = std::time::Instant::now();
        let p = body.problem()?; let u = p.solve(Cone::Nodal, signorini::contact::Solver::ActiveSet)?;
        println!("primal {:?} {:?}", t.elapsed(), u.seconds);
        let t = std::time::Instant::now();
        let f = body.enclose(Cone::Nodal)?;
        println!("{n} {:?} {} {:?} rel {} {:?}", f.energy, f.error, f.norm, f.relative_error(), t.elapsed());
        if n == 64 { let f = body.enclose(Cone::Midpoint)?; println!("midpoint {:?} {} corr {} rel {}", f.energy, f.error, f.correction, f.relative_error()); }
    }
    let show = |f: &Enclosure| eprintln!("{} N {} J {:.10} {:.10} err {:.3e} rel {:.4} round {:.1e} steps {}", f.problem.mesh().triangles().len(), f.problem.free_unknowns(), f.energy.lower, f.energy.upper, f.error, f.relative_error(), f.rounding, f.dual_steps);
    let body = Body::new(unit_square(4, SideParts::HANGING)?, Form::elastic(Lame::new(1.0, 1.0)?)).load(|[x, _]: [f64; 2]| [0.0, -(PI * x).cos()]);
    for share in [0.5, 1.0] { 
    let t = std::time::Instant::now();
    let (_, e) = Refinement { tolerance: 0.01, unknowns: 300000, share, ..Refinement::default() }.run(&body, show)?;
    println!("{e} {:?}", t.elapsed()); }
    let mesh = unit_squares(2, &[[0, 0], [1, 0], [0, 1]], |[_x, y]: [f64; 2]| if y == 0.0 { Part::Contact } else if y == 2.0 { Part::Dirichlet } else { Part::Neumann })?;
    let body = Body::new(mesh, Form::LAPLACE).load(|[x, _]: [f64; 2]| 1.0 - x);
    for share in [0.5, 1.0] { 
    let t = std::time::Instant::now();
    let (_, e) = Refinement { tolerance: 0.01, unknowns: 300000, share, ..Refinement::default() }.run(&body, show)?;
    println!("{e} {:?}", t.elapsed());}
    Ok(())
}
