//! Section 1, the plane: norms of fractional order on triangulations, and their limits at one half and at one.
//!
//! ```text
//! |w|²_s = ∫_Ω∫_Ω (w(x) − w(y))² / |x − y|^(2+2s) dx dy,     0 < s < 1,   Ω the unit square.
//! ```
//!
//! Three facts decide. For w = x₁ the integral has a closed form, which no triangulation may change: here a grid whose
//! inner nodes are moved at random. As s → 1, (1 − s)|w|²_s → (π/2) ∫ |∇w|² (Bourgain, Brezis & Mironescu 2001). For the
//! step that is 1 below the diagonal and 0 above, the norm is finite for s < 1/2 only, and (1 − 2s)|w|²_s tends to four
//! times the length of the jump, here 4√2.
//!
//! Refuted if |x₁|_s is further from its closed form than asked, or from 1 over a limit by 1e-6 at s = 1 − 1e-8 and
//! s = 1/2 − 1e-8, or if a step is given a norm for s ≥ 1/2 or refused one below.
//!
//! `cargo run --release --example section_1_norms_in_the_plane -- --squares 9 --s 0.1,0.3,0.6,0.9`

use example_report::prelude::*;
use fractional_sobolev::{Function, Triangles, closed_forms};
use std::f64::consts::{FRAC_PI_2, SQRT_2};

example! { seconds "Section 1, the plane", "|w|_s on triangles has its digits, on every mesh and up to the limits s → 1/2 and s → 1";
    /// squares in a row of the grid that is moved and cut into triangles
    squares: usize = "4" in "[1, 40]" slider "1 to 10",
    /// orders s
    s: Vec<Order> = "0.05,0.25,0.45,1/2-1e-8,1/2,0.75,0.95,0.99999999" in "(0, 1)" slider "0.02 to 0.98",
    /// relative tolerance
    tolerance: Tolerance = "1e-10",
}

/// The unit square in triangles, inner nodes moved by up to a fifth of a square: multiples of the golden ratio.
fn moved_grid(squares: usize) -> Result<Triangles> {
    let h = 1.0 / squares as f64;
    let mut k = 0.0;
    let mut by = || {
        k += 1.0;
        0.4 * h * ((k * 0.618_033_988_749_895_f64).fract() - 0.5)
    };
    let is_inner = |x: f64| x > 0.5 * h && x < 1.0 - 0.5 * h;
    let moved = |[x, y]: [f64; 2]| if is_inner(x) && is_inner(y) { [x + by(), y + by()] } else { [x, y] };
    Ok(Triangles::grid([squares, squares], h)?.mapped(moved)?)
}

fn run(options: &Options, out: &mut Report) -> Result<()> {
    let mesh = moved_grid(options.squares)?;
    let x: Vec<f64> = mesh.nodes().iter().map(|node| node[0]).collect();
    let coordinate = Function::on_triangles(&mesh, 1, &x)?; // continuous, linear on each triangle
    let step = Function::on_triangles(&Triangles::grid([1, 1], 1.0)?, 0, &[1.0, 0.0])?; // constant on two triangles
    for &s in &options.s {
        // Pairs of triangles: one, two or no common nodes by regularizing transformations, each integral over the
        // singular variable exact, Gauss rules for the rest; error: change from one degree to the next.
        let found = coordinate.seminorm(s, options.tolerance)?;
        let exact = closed_forms::coordinate_on_square_seminorm_squared(s)?.sqrt()?;
        let error = (Measured::from(found.value) / Measured::from(exact) - 1.0).abs();
        out.check("distance to the closed form of |x₁|_s").at_most(
            error,
            options.tolerance.relative(),
            "tolerance",
        );
        let to_one = Measured::from(found).squared() * (1.0 - s.value()) / FRAC_PI_2;
        if (1.0 - s.value()) < 1e-7 {
            out.check("s → 1: (1 − s)|x₁|² over π/2").near(to_one, 1.0, 1e-6, "∫ |∇x₁|² = 1");
        }
        let found_step = step.seminorm(s, options.tolerance).ok();
        out.check("a step has a norm for s < 1/2 only")
            .holds(found_step.is_some() == (s.offset() < 0.0), "1/(1 − 2s)");
        let to_half =
            found_step.map(|found| Measured::from(found).squared() * (-2.0 * s.offset()) / (4.0 * SQRT_2));
        if let Some(near) = to_half.filter(|_| s.offset() > -1e-7) {
            out.check("s → 1/2: (1 − 2s)|step|² over 4√2").near(near, 1.0, 1e-6, "4 times the length");
        }
        out.row(cells! { s => coordinate: found, error: error.value, to_one: to_one.value, step: found_step,
        to_half: to_half.map(|half| half.value) });
    }
    out.column("coordinate", "|x₁|_s", "");
    out.column("to_one", "to one", "(1 − s)|x₁|² over π/2");
    out.column("step", "|step|_s", "");
    out.column("to_half", "to half", "(1 − 2s)|step|² over 4√2");
    out.plot(
        "section_1_norms_in_the_plane",
        "Squared norms over their limits",
        Axes::Linear("s", "over the limit"),
    )
    .curve("s", "to_one")
    .curve("s", "to_half")
    .dashed_line("1", vec![(0.0, 1.0), (1.0, 1.0)]);
    Ok(())
}
