//! Section 2: your own body. A mesh of Gmsh, a load in x and y, a rigid floor under every contact
//! edge.
//!
//! Curves of the mesh are in physical groups `clamped` (Γ_D), `contact` (Γ_C, straight pieces, each
//! with its outward normal n) and `free`. With a(u, v) = ∫ σ(u) : ε(v), σ = 2μ ε + λ tr ε I, and
//! l(v) = ∫ f·v,
//!
//! ```text
//! u^h minimises J(v) = ½ a(v, v) − l(v) over                                             (2.9)
//! K^h = { v linear on triangles, v = 0 on Γ_D, v·n ≤ 0 at the nodes of Γ_C }.
//! ```
//!
//! Without a file: the L with corners (0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2), turned by 20°
//! about (0, 0), in 126 triangles of Gmsh; Γ_C is its side of length 2 on the slanted floor, Γ_D
//! the side of length 1 at the top.
//!
//! A load with one component makes the problem scalar: a(u, v) = ∫ ∇u·∇v, u ≤ 0 on Γ_C. No solution
//! is known, so what must hold for every body is checked, on the mesh and on refinements of it
//! (each triangle cut into four). Refuted if a condition of contact is violated by 1e-10 (scaled),
//! or by more than 1e-8 and ten times the rounding of J: if the resultants of load, clamp and
//! floors do not add up, if two solvers differ in J, or if J rises on a finer mesh (nested cones).
//!
//! As J(u^h) − J(u) ≈ A h^(2p) + B h², the order p of the error in the energy norm, at most 1, is
//! that of t(h) = 4 d(h/2) − d(h) ~ h^(2p), d(h) = J(h) − J(h/2), over the last halving; ±: its
//! largest change since three meshes before, or as many as there are (`order_of_squares`). It
//! decides nothing.
//!
//! ```text
//! cargo run --release --example section_2_own_body -- \
//!     --mesh FILE.msh --load "0, -0.1" --out DIR --files DIR
//! ```

use example_report::{Expression, prelude::*};
use signorini::cone::Cone;
use signorini::contact::{ContactProblem, ContactSolution, Solver, npy};
use signorini::fem::{Cubature, Field, Form, Lame};
use signorini::mesh::{Hierarchy, Part, Triangulation, parse_msh, read_msh};
use std::path::{Path, PathBuf};

example! { seconds "Section 2, your own body",
    "a body from Gmsh: u^h minimises J over K^h (2.9), forces in balance, every condition of (2.5) \
    met";
    /// Gmsh mesh (formats 2.0 to 4.1) with physical groups clamped, contact, free; default: an
    /// L-shape on a slanted floor
    mesh: Option<PathBuf> = "",
    /// volume load "fx, fy", or "f" for a scalar problem, in x, y, pi and the usual functions;
    /// default: the load of the L-shape
    load: String = "",
    /// Young's modulus E, one value or one per physical surface; E = 2.5, ν = 1/4 gives λ = μ = 1
    young: Vec<f64> = "2.5" in "(0, 1e300]",
    /// Poisson's ratio ν, as many values as for E
    poisson: Vec<f64> = "0.25" in "(-1, 0.5)",
    /// plane stress (a thin plate) instead of plane strain
    plane_stress: bool = "",
    /// number of meshes: the given one and its successive uniform refinements
    levels: usize = "5" in "[1, 8]",
    /// discrete cone: nodal (2.9) or midpoint (4.1)
    cone: Cone = "nodal",
    /// output directory for contact_edge.csv (u_N and σ_N at the nodes of the contact edges),
    /// body.vtu, nodes.npy, displacement.npy
    files: Option<PathBuf> = "",
}

/// Linear elements on the mesh; ∫ f·φᵢ by a rule of 4 × 4 points a triangle, exact for f of degree
/// 6.
fn problem(mesh: Triangulation, form: &Form, load: &[Expression]) -> Result<ContactProblem> {
    let none = vec![0.0; mesh.nodes().len() * load.len()];
    let mut problem = ContactProblem::new(mesh, form.clone(), &none)?;
    let rule = Cubature::new(4)?;
    match load {
        [f, g] => problem.add_volume_load(&Field::Vector(&|p| [f.at(p), g.at(p)]), &rule)?,
        _ => problem.add_volume_load(&Field::Scalar(&|p| load[0].at(p)), &rule)?,
    }
    Ok(problem)
}

fn run(options: &Options, out: &mut Report) -> Result<()> {
    let text = match (options.load.is_empty(), &options.mesh) {
        (true, None) => "0.015, 0.02 - 0.03*x",
        (true, Some(_)) => {
            return Err(Error::option(
                "load",
                "--mesh requires --load \"fx, fy\" (\"f\" for a scalar problem)",
            ));
        }
        _ => &options.load,
    };
    let parts = Expression::parse_list(text)?;
    if parts.len() > 2 {
        let what = format!("{} components, expected \"fx, fy\" or \"f\"", parts.len());
        return Err(Error::option("load", &what));
    }
    let (mesh, name) = match &options.mesh {
        Some(path) => (
            read_msh(path)?,
            path.file_stem().map_or("body".into(), |stem| stem.to_string_lossy().into_owned()),
        ),
        None => (parse_msh(include_str!("data/l_shape.msh"))?, "l_shape".to_owned()),
    };
    for (part, of) in [(Part::Dirichlet, "clamped"), (Part::Contact, "in contact")] {
        if !mesh.boundary().iter().any(|edge| edge.part == part) {
            let what = format!(
                "no curve is {of}: add Physical Curve(\"{}\") = {{..}}; the groups are {}",
                part.name(),
                mesh.groups().join(", ")
            );
            return Err(Error::option("mesh", &what));
        }
    }
    let mut remarks = mesh.remarks().to_vec();
    let surfaces = mesh.regions().iter().max().map_or(1, |&last| last as usize + 1);
    if options.young.len() != options.poisson.len() || ![1, surfaces].contains(&options.young.len())
    {
        let what =
            format!("expected as many values as for --poisson: 1, or one per surface ({surfaces})");
        return Err(Error::option("young", &what));
    }
    let lame = if options.plane_stress { Lame::plane_stress } else { Lame::plane_strain };
    let materials = options.young.iter().zip(&options.poisson).map(|(&e, &nu)| lame(e, nu));
    let form = if parts.len() == 1 {
        Form::LAPLACE
    } else {
        Form::Elastic { materials: materials.collect::<std::result::Result<_, _>>()? }
    };
    out.column(
        "touching",
        "touching",
        "active constraints: nodes (midpoint cone: segments) in contact",
    );
    out.column("second", "interior point", "how it ended; its J is compared where it converged");
    out.column("force", "force", "−∫ σ_N, in the unit of E times that of the mesh");
    let mut meshes = Hierarchy::new(mesh);
    let mut last: Option<(ContactProblem, ContactSolution)> = None;
    for level in 0..options.levels {
        if level > 0 {
            meshes.refine()?;
        }
        let problem = problem(meshes.finest().clone(), &form, &parts)?;
        // Guess which constraints are active, solve the linear equations, correct the guess by the
        // signs of gap and force.
        let u = problem.solve(options.cone, Solver::ActiveSet)?;
        // Primal-dual path through the interior of the cone (Clarabel): a duality gap of 1e-13.
        let other = problem.attempt(options.cone, Solver::InteriorPoint)?;
        let segments = problem.edge().segment_lengths().len();
        out.row(cells! { segments =>
        unknowns: problem.free_unknowns(), touching: u.contact_set.count(),
        force: u.contact_force, J: Measured::new(u.energy, u.energy_rounding),
        second: other.status.to_string() });
        // ε (Σᵢ uᵢ² (|K||u| + |F|)ᵢ²)^(1/2)/|J|, ε = 2^-52: what rounding of K and F leaves in J,
        // much for ν near 1/2.
        let rounding = if u.energy == 0.0 { 0.0 } else { u.energy_rounding / u.energy.abs() };
        let allowed = 1e-8 + 10.0 * rounding;
        // (2.5) and the equations: penetration over the largest displacement, pull over the largest
        // push, their product, and the largest entry of K u − F + Bᵀλ over that of |K||u| + |F|.
        out.check("penetration: max (B u)₊, scaled").at_most(u.kkt.gap, 1e-10, "(2.5)");
        out.check("tensile contact force: max (−λ)₊, scaled").at_most(u.kkt.sign, 1e-10, "(2.5)");
        let claim = out.check("complementarity: max |λ B u|, scaled");
        claim.at_most(u.kkt.complementarity, 1e-10, "(2.5)");
        let claim = out.check("equilibrium residual at free nodes, scaled");
        claim.at_most(u.kkt.balance, 1e-10, "(2.1)");
        // Resultants of F, of the reactions K u − F at the clamped nodes and of the floors, over
        // the size of their terms.
        let claim = out.check("resultant of load and reactions, scaled");
        claim.at_most(u.balance, allowed, "eight digits");
        let apart = |a: f64, b: f64| if a == b { 0.0 } else { (a / b - 1.0).abs() };
        if other.status.is_converged() {
            let of_j = apart(other.energy, u.energy);
            out.check("two solvers: |ΔJ|/|J|").at_most(of_j, allowed, "eight digits");
        }
        if let (Cone::Nodal, Some((_, before))) = (options.cone, &last) {
            let rise = (u.energy - before.energy) / before.energy.abs();
            let rise = if rise.is_nan() { 0.0 } else { rise };
            let claim = out.check("mesh refinement: relative increase of J");
            claim.at_most(rise, allowed, "nested cones");
        }
        last = Some((problem, u));
    }
    let j: Vec<f64> = out.series("segments", "J").into_iter().map(|(_, j)| j).collect();
    let order = order_of_squares(&j, 1).min(1.0);
    if j.len() >= 5 {
        out.note("order", order);
        out.note("order.error", order.error);
        let claim = out.observe("order of the error in the energy norm");
        claim.near(order, 0.5, 0.5, "corner singularities");
    } else {
        remarks.push("too few meshes for an order: --levels 5 or more".to_owned());
    }
    out.remark(remarks.join("\n"));
    let Some((problem, u)) = last else { return Ok(()) };
    if out.draws() {
        let (title, cone) = (name.replace('_', " "), options.cone);
        out.bodies(&title, &[(format!("section_2_own_{name}_body_{cone}"), &problem, &u)])?;
        out.contact_edge(&format!("section_2_own_{name}_edge_{cone}"), &title, &problem, &u);
    }
    options.files.as_deref().map_or(Ok(()), |directory| write_files(directory, &problem, &u))
}

/// contact_edge.csv has one line for each node of the contact edges: number of the edge, arc
/// length, node, u_N and σ_N.
fn write_files(directory: &Path, problem: &ContactProblem, u: &ContactSolution) -> Result<()> {
    let edge = problem.edge();
    let mut text = "edge,s,x,y,u_N,sigma_N\n".to_owned();
    for (number, piece) in edge.pieces().into_iter().enumerate() {
        for i in piece.clone() {
            let ([x, y], s) = (edge.points()[i], edge.arc()[i] - edge.arc()[piece.start]);
            let (normal, stress) = (u.normal_displacement[i], 0.0 - u.pressure[i]);
            text += &format!("{},{s},{x},{y},{normal},{stress}\n", number + 1);
        }
    }
    let components = problem.form().components();
    let files = [
        ("contact_edge.csv", text.into_bytes()),
        ("body.vtu", problem.to_vtu(u)?.into_bytes()),
        ("nodes.npy", npy(problem.mesh().nodes().as_flattened(), 2)?),
        ("displacement.npy", npy(&u.displacement, components)?),
    ];
    std::fs::create_dir_all(directory).map_err(|error| Error::file(directory, error))?;
    files.into_iter().try_for_each(|(name, bytes)| {
        let file = directory.join(name);
        std::fs::write(&file, bytes).map_err(|error| Error::file(&file, error))
    })
}
