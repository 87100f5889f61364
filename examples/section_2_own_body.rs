//! Section 2: your own body. A mesh of Gmsh, what acts on it in x and y, a rigid floor under every
//! contact edge.
//!
//! The mesh has triangles, and its boundary curves are in physical groups: `clamped` (Γ_D),
//! `contact` (Γ_C, straight pieces, each with its outward normal n), `free` (Γ_N), or groups of
//! other names on which something acts. With σ(v) = 2μ ε(v) + λ tr ε(v) I put
//!
//! ```text
//! a(u, v) = ∫ σ(u) : ε(v),     l(v) = ∫ f·v + ∫_{Γ_N} F·v,     J(v) = ½ a(v, v) − l(v),
//! u^h minimises J over                                                                   (2.9)
//! { v linear on triangles, v = u_D on Γ_D, v·n ≤ g at the nodes of Γ_C }.
//! ```
//!
//! A load with one component makes the problem scalar: a(u, v) = ∫ ∇u·∇v, and u ≤ g on Γ_C.
//!
//! This file computes u^h on the mesh and on refinements of it, each triangle cut into four.
//! Without a file the body is the L with corners (0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2),
//! turned counterclockwise by 20° about (0, 0), in 126 triangles of Gmsh (`data/l_shape.msh`); Γ_C
//! is the turned side from (0, 0) to (2, 0), on the slanted floor, Γ_D that from (1, 2) to (0, 2);
//! λ = μ = 1, f = (0.015, 0.02 − 0.03 x), components and x along the axes of the mesh file, in
//! which the L is turned already. J tends to about −1.381e-3 on any meshes.
//!
//! No solution is known, so the checks are those that must hold for every body. Refuted if a
//! condition of contact, or the equilibrium at the free nodes, scaled, is violated by more than
//! 1e-10; or, by more than 1e-8 plus ten times the relative rounding of J, if the resultants of
//! load, clamp and floors (forces in both directions, over the sums of the moduli of their terms)
//! do not add up, if two solvers differ in J where the second converged, or if J rises on a finer
//! mesh by more than that beyond the ± of both meshes (undecided inside of it). Where 1e-8 plus ten
//! times that rounding is 1e-3 or more, resultants and solvers decide nothing. (The cones are
//! nested if there are no gaps and no prescribed displacements, which are interpolated.)
//!
//! Shown, and decided by nothing, is the order p of the error in the energy norm. It is computed
//! from J, as J(u^h) − J(u) ≈ A h^(2p) + B h²:
//!
//! ```text
//! d(h) = J(h) − J(h/2),   t(h) = 4 d(h/2) − d(h) ~ h^(2p),   p = ½ log₂ |t(h)/t(h/2)|, at most 1.
//! ```
//!
//! Its ± is the largest change of p since three meshes before, or as many as there are. The ± of J
//! is its rounding and the sum of |ΔF_i u_i|, ΔF the change of the load vector from a rule of 4 × 4
//! points on a triangle to one of 7 × 7: as dJ = −dF·u, that is what the rule misses of a load that
//! jumps, or varies within a triangle.
//!
//! With `--tolerance 1%` the error is guaranteed. A stress q in balance with the load, here div q +
//! f = 0, q n = F on Γ_N, q_T = 0 and q_N ≤ 0 on Γ_C, bounds J from below by J*(q) = −½ ∫ q : 𝒜⁻¹q
//! (g = 0, u_D = 0), and
//!
//! ```text
//! |||u − u^h|||² ≤ 2 (J(u^h) − J*(q)).
//! ```
//!
//! q is an antiderivative of the load plus the best stress of an Airy function on the triangles of
//! u^h; what of the load it misses is in the bound as oscillation, and is subtracted from J*(q)
//! (example `two_sided_energies`, `bounds::parts`). The fewest triangles that carry half of the
//! bound are bisected until it is 1 % of |||u|||. Refuted if a condition of contact or an equation,
//! scaled, is violated by more than 1e-10; if the largest J from below of all meshes is above the
//! smallest J from above; or if the resultants do not add up. No other number has a bar: what may
//! be wrong is in the bounds.
//!
//! `cargo run --release --example section_2_own_body -- --mesh FILE.msh --load "0, -0.1" --out DIR
//! --files DIR`

use example_report::{Expression, floor_names, prelude::*};
use signorini::bounds::{Enclosure, Ended, Refinement};
use signorini::cone::Cone;
use signorini::contact::{Body, ContactProblem, ContactSolution, Solver, npy};
use signorini::fem::{Form, Lame};
use signorini::mesh::{Hierarchy, Part, Point, parse_msh, read_msh_with};
use std::path::{Path, PathBuf};

example! { seconds "Section 2, your own body",
    "a body from Gmsh: u^h minimises J over K^h (2.9), forces in balance, every condition of (2.5) \
    met";
    /// Gmsh mesh (formats 2.0 to 4.1) with physical groups clamped, contact, free; default: an
    /// L-shape on a slanted floor
    mesh: Option<PathBuf> = "",
    /// volume load "fx, fy", or "f" for a scalar problem, in x, y, pi and the usual functions;
    /// "left=fx, fy; right=.." by physical surface
    load: String = "",
    /// traction on the free boundary, "Fx, Fy", or by physical curve "top=0, -1 + x; left=0.1, 0"
    traction: String = "",
    /// displacement of the clamped boundary, or by physical curve "clamp=0, 0.01*x"; default 0
    displacement: String = "",
    /// gap between body and floor along the normal, or by physical curve "floor=0.001*(x-1)^2";
    /// default 0
    gap: String = "",
    /// Young's modulus E, or one by physical surface "body=2.1e11,rim=7e10"; E = 2.5, ν = 1/4 gives
    /// λ = μ = 1
    young: String = "2.5",
    /// Poisson's ratio ν in (-1, 0.5), or by physical surface as for E
    poisson: String = "0.25",
    /// plane stress (a thin plate) instead of plane strain
    plane_stress: bool = "",
    /// number of meshes: the given one and its successive uniform refinements
    levels: usize = "5" in "[1, 8]",
    /// guaranteed error in the energy norm, such as 1%, instead of a number of meshes
    tolerance: String = "",
    /// largest number of unknowns on the way to the tolerance
    unknowns: usize = "1000000" in "[100, 10000000]",
    /// discrete cone: nodal (2.9) or midpoint (4.1)
    cone: Cone = "nodal",
    /// output directory for contact_edge.csv (u_N and σ_N at the nodes of the contact edges),
    /// body.vtu, nodes.npy, displacement.npy
    files: Option<PathBuf> = "",
}

/// Change of J under a finer rule, relative, above which the load is not resolved.
const UNRESOLVED: f64 = 1e-6;

/// What acts on a group or a region; without a name everywhere.
#[derive(Clone)]
struct Given {
    place: Option<String>,
    parts: Vec<Expression>,
}

/// "fx, fy" or "name=fx, fy; other=gx, gy".
fn given(option: &'static str, text: &str) -> Result<Vec<Given>> {
    let mut all: Vec<Given> = Vec::new();
    for piece in text.split(';').filter(|piece| !piece.trim().is_empty()) {
        let (place, text) = match piece.split_once('=') {
            Some((name, text)) => (Some(name.trim().to_owned()), text),
            None => (None, piece),
        };
        let parts =
            Expression::parse_list(text).map_err(|why| Error::option(option, &why.to_string()))?;
        let most = if option == "gap" { 1 } else { 2 };
        if parts.len() > most {
            let expected = if most == 1 { "one" } else { "\"fx, fy\" or \"f\"" };
            return Err(Error::option(
                option,
                &format!("{} components, expected {expected}", parts.len()),
            ));
        }
        let is_again = |one: &Given| one.place == place;
        // Loads and tractions by name add up; two without a name are a comma that became a
        // semicolon.
        let add_up = matches!(option, "load" | "traction") && place.is_some();
        if all.iter().any(is_again) && !add_up {
            let on = place.map_or("everywhere".to_owned(), |name| format!("on '{name}'"));
            let what = format!("given twice {on}: components are separated by a comma");
            return Err(Error::option(option, &what));
        }
        all.push(Given { place, parts });
    }
    Ok(all)
}

/// One number for every region: "2.5", or "body=2.1e11,rim=7e10".
fn by_region(option: &'static str, text: &str, regions: &[String]) -> Result<Vec<f64>> {
    let number = |word: &str| {
        let what = || format!("'{}' is not a finite number", word.trim());
        word.trim()
            .parse()
            .ok()
            .filter(|v: &f64| v.is_finite())
            .ok_or_else(|| Error::option(option, &what()))
    };
    if !text.contains('=') {
        if text.contains(',') {
            let names =
                regions.iter().map(|name| format!("{name}=..")).collect::<Vec<_>>().join(",");
            return Err(Error::option(
                option,
                &format!("several values are given by physical surface: {names}"),
            ));
        }
        return Ok(vec![number(text)?; regions.len()]);
    }
    let mut values = vec![None; regions.len()];
    for piece in text.split(',') {
        let missing = || Error::option(option, &format!("'{piece}': expected NAME=VALUE"));
        let (name, word) = piece.split_once('=').ok_or_else(missing)?;
        let place = regions.iter().position(|region| region == name.trim()).ok_or_else(|| {
            Error::option(
                option,
                &format!("no region '{}': the mesh has {}", name.trim(), regions.join(", ")),
            )
        })?;
        values[place] = Some(number(word)?);
    }
    let of = |(value, name): (Option<f64>, &String)| {
        value.ok_or_else(|| {
            Error::option(option, &format!("a value for the region '{name}' is missing"))
        })
    };
    values.into_iter().zip(regions).map(of).collect()
}

/// Adds what is given to a body: by `$all` without a name, by `$on` with one.
macro_rules! act {
    ($body:expr, $given:expr, $all:ident, $on:ident) => {
        $given.iter().cloned().fold($body, |body, Given { place, parts }| {
            match (parts.as_slice(), place) {
                ([f, g], place) => {
                    let (f, g) = (f.clone(), g.clone());
                    let both = move |p: Point| [f.at(p), g.at(p)];
                    if let Some(name) = place { body.$on(&name, both) } else { body.$all(both) }
                }
                ([f, ..], place) => {
                    let f = f.clone();
                    let one = move |p: Point| f.at(p);
                    if let Some(name) = place { body.$on(&name, one) } else { body.$all(one) }
                }
                ([], _) => body,
            }
        })
    };
}

/// The body of the options.
fn body(options: &Options) -> Result<Body<'static>> {
    let [mut load, traction, displacement, gap] = [
        given("load", &options.load)?,
        given("traction", &options.traction)?,
        given("displacement", &options.displacement)?,
        given("gap", &options.gap)?,
    ];
    if load.is_empty() && traction.is_empty() && displacement.is_empty() {
        if options.mesh.is_some() {
            let what = "--mesh requires --load \"fx, fy\" (\"f\" for a scalar problem), \
                --traction or --displacement";
            return Err(Error::option("load", what));
        }
        load = given("load", "0.015, 0.02 - 0.03*x")?;
    }
    let is_scalar = refuse_ignored(
        options,
        [("load", &load), ("traction", &traction), ("displacement", &displacement)],
    )?;
    // A curve on which something acts needs no other name.
    let places = |all: &[Given], part: Part| -> Vec<(String, Part)> {
        let names = all.iter().filter_map(|one| one.place.clone());
        names.filter(|name| Part::named(name).is_none()).map(|name| (name, part)).collect()
    };
    let acting =
        [(&traction, Part::Neumann), (&displacement, Part::Dirichlet), (&gap, Part::Contact)]
            .map(|(all, part)| places(all, part));
    let named = acting.concat();
    let parts: Vec<(&str, Part)> =
        named.iter().map(|(name, part)| (name.as_str(), *part)).collect();
    let mesh = match &options.mesh {
        Some(path) => read_msh_with(path, &parts)?,
        None => parse_msh(include_str!("data/l_shape.msh"))?,
    };
    for (part, of) in [(Part::Dirichlet, "clamped"), (Part::Contact, "in contact")] {
        if !mesh.boundary().iter().any(|edge| edge.part == part) {
            let by = match part {
                Part::Dirichlet => "--displacement \"NAME=0, 0\"",
                _ => "--gap NAME=0",
            };
            let what = format!(
                "no curve is {of}: add Physical Curve(\"{}\") = {{..}}, or choose one by {by}; \
                the groups are {}",
                part.name(),
                mesh.groups().join(", ")
            );
            return Err(Error::option("mesh", &what));
        }
    }
    let lame = if options.plane_stress { Lame::plane_stress } else { Lame::plane_strain };
    let regions = mesh.region_names();
    let young = by_region("young", &options.young, &regions)?;
    let poisson = by_region("poisson", &options.poisson, &regions)?;
    let materials = young.iter().zip(&poisson).map(|(&e, &nu)| lame(e, nu));
    let materials = materials.collect::<std::result::Result<_, _>>()?;
    let form = if is_scalar { Form::LAPLACE } else { Form::Elastic { materials } };
    let body = act!(Body::new(mesh, form), load, load, load_on);
    let body = act!(body, traction, traction, traction_on);
    let body = act!(body, displacement, displacement, displacement_on);
    Ok(gap.into_iter().fold(body, |body, Given { place, parts }| {
        let g = move |p: Point| parts[0].at(p);
        if let Some(name) = place { body.gap_on(&name, g) } else { body.gap(g) }
    }))
}

/// Whether the problem is scalar: all that acts has one component. Refuses what differs, and
/// options that would be ignored.
fn refuse_ignored(options: &Options, acting: [(&'static str, &Vec<Given>); 3]) -> Result<bool> {
    let of = |one: &Given| match &one.place {
        Some(name) => format!("that of '{name}'"),
        None => "what is given".to_owned(),
    };
    let (mut first, defaults) = (None, Options::default());
    for (option, one) in acting.into_iter().flat_map(|(o, all)| all.iter().map(move |g| (o, g))) {
        let count = one.parts.len();
        let (before, expected) = *first.get_or_insert((option, count));
        if count != expected {
            let what = format!(
                "{} has {count} component{}, expected {expected} as --{before} has: {}",
                of(one),
                if count == 1 { "" } else { "s" },
                if expected == 2 { "0 is \"0, 0\"" } else { "the problem is scalar" },
            );
            return Err(Error::option(option, &what));
        }
    }
    let is_scalar = first.is_some_and(|(_, count)| count == 1);
    let ignored = [
        ("young", options.young != defaults.young),
        ("poisson", options.poisson != defaults.poisson),
        ("plane-stress", options.plane_stress),
    ];
    for (option, is_given) in ignored {
        let what = "a load of one component makes the problem scalar, without a material: \
            write \"fx, fy\" for a force";
        Error::unless(!(is_scalar && is_given), option, what)?;
    }
    let is_guaranteed = !options.tolerance.is_empty();
    let what = "with --tolerance the program chooses the meshes";
    Error::unless(!is_guaranteed || options.levels == defaults.levels, "levels", what)?;
    let what = "limits the meshes of --tolerance, which is not given";
    Error::unless(is_guaranteed || options.unknowns == defaults.unknowns, "unknowns", what)?;
    Ok(is_scalar)
}

fn run(options: &Options, out: &mut Report) -> Result<()> {
    let body = body(options)?;
    let mut remarks = body.mesh().remarks().to_vec();
    if body.form().components() == 1 {
        remarks.push("one component: the scalar problem −Δu = f, u ≤ g on the floor".to_owned());
    }
    let (problem, u, vtu) = if options.tolerance.is_empty() {
        let (problem, u) = on_refinements(&body, options, out, &mut remarks)?;
        let vtu = problem.to_vtu(&u)?;
        (problem, u, vtu)
    } else {
        let found = to_tolerance(&body, options, out, &mut remarks)?;
        let vtu = found.to_vtu()?;
        (found.problem, found.solution, vtu)
    };
    for support in problem.supports(&u)? {
        let ([x, y], m) = (support.force, support.moment);
        remarks.push(match problem.form().components() {
            1 => format!("{} exerts the force {x:.6e}", support.group),
            _ => {
                format!(
                    "{} exerts the force ({x:.6e}, {y:.6e}), moment about (0, 0) {m:.6e}",
                    support.group
                )
            }
        });
    }
    out.remark(remarks.join("\n"));
    if out.draws() {
        let stem = options.mesh.as_ref().and_then(|path| path.file_stem());
        let name = stem.map_or("l_shape".into(), |stem| stem.to_string_lossy().into_owned());
        let (title, cone) = (name.replace('_', " "), options.cone);
        out.bodies(&title, &[(format!("section_2_own_{name}_body_{cone}"), &problem, &u)])?;
        out.contact_edge(&format!("section_2_own_{name}_edge_{cone}"), &title, &problem, &u);
    }
    options.files.as_deref().map_or(Ok(()), |directory| write_files(directory, &problem, &u, vtu))
}

/// The mesh and its uniform refinements; the last solution.
fn on_refinements(
    body: &Body<'_>,
    options: &Options,
    out: &mut Report,
    remarks: &mut Vec<String>,
) -> Result<(ContactProblem, ContactSolution)> {
    out.column(
        "touching",
        "touching",
        "active constraints: nodes (midpoint cone: segments) in contact",
    );
    out.column("second", "interior point", "how it ended; its J is compared where it converged");
    out.column("force", "force", "−∫ σ_N, in the unit of E times that of the mesh");
    let is_nested =
        options.displacement.is_empty() && options.gap.is_empty() && options.cone == Cone::Nodal;
    let mut meshes = Hierarchy::new(body.mesh().clone());
    let mut last: Option<(ContactProblem, ContactSolution)> = None;
    let mut missed_before = 0.0;
    for level in 0..options.levels {
        if level > 0 {
            meshes.refine()?;
        }
        let problem = body.problem_on(meshes.finest())?;
        // Every mesh has four times the unknowns of the one before.
        let done = (4f64.powi(level as i32) - 1.0) / (4f64.powi(options.levels as i32) - 1.0);
        let unknowns = problem.free_unknowns();
        let progress = |solver: &str| {
            let of = format!("mesh {} of {}", level + 1, options.levels);
            (done, format!("{of}, {unknowns} unknowns, {solver}"))
        };
        let (share, words) = progress("active set");
        out.progress(share, words);
        // Guess which constraints are active, solve the linear equations, correct the guess by the
        // signs of gap and force.
        let u = problem.solve(options.cone, Solver::ActiveSet)?;
        let (share, words) = progress("interior point");
        out.progress(share, words);
        // Primal-dual path through the interior of the cone (Clarabel): a duality gap of 1e-13.
        let other = problem.attempt(options.cone, Solver::InteriorPoint)?;
        let segments = problem.edge().segment_lengths().len();
        let missed = body.missed_load(problem.mesh(), &u.displacement)?; // |ΔJ|
        if missed > UNRESOLVED * u.energy.abs() {
            let what = "the rule does not resolve the load";
            out.remark(format!("{segments} segments: {what}, J ± {missed:.1e}"));
        }
        out.row(cells! { segments =>
        unknowns, touching: u.contact_set.count(),
        force: u.contact_force, J: Measured::new(u.energy, u.energy_rounding + missed),
        second: other.status.to_string() });
        // ε (Σᵢ uᵢ² (|K||u| + |F|)ᵢ²)^(1/2)/|J|, ε = 2^-52: what rounding of K and F leaves in J,
        // much for ν near 1/2.
        let rounding = if u.energy == 0.0 { 0.0 } else { u.energy_rounding / u.energy.abs() };
        let allowed = 1e-8 + 10.0 * rounding;
        const COARSE: f64 = 1e-3; // where such a difference would pass too, nothing is decided
        // (2.5) and the equations. B u: u·n at the nodes of Γ_C (midpoint cone: its means over the
        // segments), λ: its multipliers, the forces of the floor. Penetration over the largest
        // displacement, pull over the largest push, their product, and the largest entry of
        // K u − F + Bᵀλ over that of |K||u| + |F|.
        out.check("penetration: max (B u − g)₊, scaled").at_most(u.kkt.gap, 1e-10, "(2.5)");
        out.check("tensile contact force: max (−λ)₊, scaled").at_most(u.kkt.sign, 1e-10, "(2.5)");
        let claim = out.check("complementarity: max |λ (B u − g)|, scaled");
        claim.at_most(u.kkt.complementarity, 1e-10, "(2.5)");
        let claim = out.check("equilibrium residual at free nodes, scaled");
        claim.at_most(u.kkt.balance, 1e-10, "(2.1)");
        // Resultants of F, of the reactions K u − F at the clamped nodes and of the floors, over
        // the size of their terms.
        let claim =
            out.check("resultant of load and reactions, scaled").undecided_if_also_true_of(COARSE);
        claim.at_most(u.balance, allowed, "eight digits");
        let apart = |a: f64, b: f64| if a == b { 0.0 } else { (a / b - 1.0).abs() };
        if other.status.is_converged() {
            let of_j = apart(other.energy, u.energy);
            let claim = out.check("two solvers: |ΔJ|/|J|").undecided_if_also_true_of(COARSE);
            claim.at_most(of_j, allowed, "eight digits");
        }
        if let (true, Some((_, before))) = (is_nested, &last) {
            let rise = (u.energy - before.energy) / before.energy.abs();
            let rise = if rise.is_nan() { 0.0 } else { rise };
            let size = before.energy.abs().max(f64::MIN_POSITIVE);
            let rise = Measured::new(rise, (missed + missed_before) / size);
            let claim = out.check("mesh refinement: relative increase of J");
            claim.whole_error_bars_at_most(rise, allowed, "nested cones");
        }
        missed_before = missed;
        last = Some((problem, u));
    }
    let j: Vec<f64> = out.series("segments", "J").into_iter().map(|(_, j)| j).collect();
    let order = order_of_squares(&j, 1).min(1.0); // t(h)/t(h/2): neighbours
    if j.len() >= 5 {
        out.note("order", order);
        out.note("order.error", order.error);
        let claim = out.observe("order of the error in the energy norm");
        claim.whole_error_bars_at_least(order, 0.0, "corner singularities");
    } else {
        remarks.push("too few meshes for an order: --levels 5 or more".to_owned());
    }
    last.ok_or_else(|| Error::option("levels", "no mesh"))
}

/// Meshes that are fine where the bound of the error requires it, to the tolerance; the last
/// solution.
fn to_tolerance(
    body: &Body<'_>,
    options: &Options,
    out: &mut Report,
    remarks: &mut Vec<String>,
) -> Result<Enclosure> {
    let text = options.tolerance.trim();
    let (text, unit) = text.strip_suffix('%').map_or((text, 1.0), |text| (text, 0.01));
    let tolerance =
        text.trim().parse::<f64>().ok().map(|v| v * unit).filter(|&v| v > 0.0 && v < 1.0);
    let expected = || Error::option("tolerance", "expected a share of |||u|||, such as 1% or 0.01");
    let tolerance = tolerance.ok_or_else(expected)?;
    out.column("lower", "J from below", "J*(q) less the effect of oscillation and rounding");
    out.column("upper", "J from above", "J(u^h)");
    out.column("error", "error ≤", "of |||u − u^h|||, guaranteed");
    out.column("percent", "% of |||u|||", "the same relative to |||u|||");
    out.column(
        "force",
        "contact force",
        "−∫ σ_N(u), of all floors together, in an interval; none where a floor meets a clamp",
    );
    let refinement = Refinement {
        cone: options.cone,
        tolerance,
        unknowns: options.unknowns,
        ..Refinement::default()
    };
    let (mut highest, mut lowest) = (f64::NEG_INFINITY, f64::INFINITY);
    let (mut failed, mut first, mut forces_on) = (None, None, Vec::new());
    out.progress(0.0, format!("{} triangles", body.mesh().triangles().len()));
    let each = |found: &Enclosure| {
        let floors = 0..found.problem.edge().pieces().len();
        let forces = floors.map(|floor| body.contact_force(found, floor));
        forces_on = match forces.collect::<signorini::Result<Vec<_>>>() {
            Ok(forces) => forces,
            Err(error) => {
                failed.get_or_insert(error);
                return;
            }
        };
        let all = forces_on.iter().try_fold([0.0; 2], |[lower, upper], force| {
            force.as_ref().map(|force| [lower + force.lower, upper + force.upper])
        });
        let force =
            all.map_or("none".to_owned(), |[lower, upper]| format!("{lower:.4e} .. {upper:.4e}"));
        let (triangles, error) = (found.shares.len(), found.relative_error());
        let percent = 100.0 * error;
        let at_first = *first.get_or_insert(error);
        // The share of the digits of the error that are gained.
        let done = if at_first.is_finite() { (at_first / error).ln() } else { 0.0 }
            / (at_first.clamp(tolerance, 10.0) / tolerance).ln().max(f64::MIN_POSITIVE);
        let required = 100.0 * tolerance;
        let words = format!("error ≤ {percent:.3} %, {required} % required");
        out.progress(done, format!("{triangles} triangles, {words}"));
        (highest, lowest) = (highest.max(found.energy.lower), lowest.min(found.energy.upper));
        let energy = found.energy;
        out.row(cells! { triangles =>
        lower: energy.lower, upper: energy.upper, error: found.error, percent, force });
        let u = &found.solution;
        let claim = out.check("conditions of contact and equations, scaled");
        claim.at_most(u.kkt.worst(), 1e-10, "(2.5)");
        let rounding = if u.energy == 0.0 { 0.0 } else { u.energy_rounding / u.energy.abs() };
        let claim = out.check("resultant of load and reactions, scaled");
        claim.at_most(u.balance, 1e-8 + 10.0 * rounding, "eight digits");
        let apart = (highest - lowest) / lowest.abs();
        let claim = out.check("(highest J from below − lowest J from above)/|J|");
        claim.at_most(apart, 0.0, "J*(q) ≤ J(u) ≤ J(v) on every mesh");
    };
    let (found, ended) = refinement.run(body, each)?;
    failed.map_or(Ok(()), Err)?;
    let (error, percent) = (found.error, 100.0 * found.relative_error());
    remarks.push(if percent.is_finite() {
        format!(
            "guaranteed: the error in the energy norm is at most {error:.3e}, \
            {percent:.2} % of |||u|||"
        )
    } else {
        format!(
            "guaranteed: the error in the energy norm is at most {error:.3e}, \
            perhaps more than |||u|||"
        )
    });
    for (name, force) in floor_names(&found.problem).iter().zip(&forces_on) {
        if let (Some(force), true) = (force, forces_on.len() > 1) {
            remarks.push(format!(
                "guaranteed: the contact force of {name} is in {:.4e} .. {:.4e}",
                force.lower, force.upper
            ));
        }
    }
    match ended {
        Ended::Tolerance => {}
        Ended::Unknowns => remarks.push(format!(
            "the tolerance is not reached with {} unknowns: --unknowns allows more",
            options.unknowns
        )),
        _ => remarks.push(format!("the tolerance is not reached: {ended}")),
    }
    Ok(found)
}

/// contact_edge.csv has one line for each node of the contact edges: number of the edge, arc
/// length, node, u_N and σ_N, name of the floor.
fn write_files(
    directory: &Path,
    problem: &ContactProblem,
    u: &ContactSolution,
    vtu: String,
) -> Result<()> {
    let edge = problem.edge();
    let mut text = "edge,s,x,y,u_N,sigma_N,floor\n".to_owned();
    let names = floor_names(problem).into_iter().map(|name| name.replace([',', '"'], " "));
    for (number, (piece, name)) in edge.pieces().into_iter().zip(names).enumerate() {
        for i in piece.clone() {
            let ([x, y], s) = (edge.points()[i], edge.arc()[i] - edge.arc()[piece.start]);
            let (normal, stress) = (u.normal_displacement[i], 0.0 - u.pressure[i]);
            text += &format!("{},{s},{x},{y},{normal},{stress},{name}\n", number + 1);
        }
    }
    let components = problem.form().components();
    let files = [
        ("contact_edge.csv", text.into_bytes()),
        ("body.vtu", vtu.into_bytes()),
        ("nodes.npy", npy(problem.mesh().nodes().as_flattened(), 2)?),
        ("displacement.npy", npy(&u.displacement, components)?),
    ];
    std::fs::create_dir_all(directory).map_err(|error| Error::file(directory, error))?;
    files.into_iter().try_for_each(|(name, bytes)| {
        let file = directory.join(name);
        std::fs::write(&file, bytes).map_err(|error| Error::file(&file, error))
    })
}
