//! Section 1, corners: norms of corner singularities r^a sin(πφ/ω) on polygons, up to the limit of finiteness.
//!
//! At a corner of angle ω solutions behave like w = r^a sin(πφ/ω), r and φ polar coordinates. The seminorm
//! |w|²_s = ∬ (w(x) − w(y))² / |x − y|^(2+2s) is finite for a + 1 − s > 0 only; on a sector of radius R it is
//! proportional to R^(a+1−s). So the norm on a polygon lies between those of the largest sector inside and the smallest
//! outside, and all three agree as a + 1 − s → 0.
//!
//! Refuted if two triangulations of one polygon give different norms, if a norm is outside its two sectors, if polygon
//! and inner sector differ by more than a + 1 − s relatively, or if a norm is given for a + 1 − s ≤ 0.
//!
//! `cargo run --release --example section_1_closures_in_the_plane -- --gap 0.3,1e-4 --s 0.8`

use example_report::prelude::*;
use fractional_sobolev::{Error as Refusal, Function, Triangles};
use std::f64::consts::{PI, SQRT_2};

example! { seconds "Section 1, corners", "r^a sin(πφ/ω) has its norm of order s up to the limit a + 1 − s = 0, and none beyond";
    /// a + 1 − s: by what the exponent a is above the limit
    gap: Vec<f64> = "0.5,1e-2,1e-6" in "(0, 20]",
    /// order s
    s: Order = "0.6" in "(0, 1)" slider "0.1 to 0.9",
    /// relative tolerance
    tolerance: Tolerance = "1e-6",
}

/// A polygon 0, P₁, ..., P_m with its corner at 0: the angle ω there, radii of the inner and the outer sector.
struct Polygon {
    name: &'static str,
    points: Vec<[f64; 2]>,
    angle: f64,
    radii: [f64; 2],
}

fn polygons() -> [Polygon; 4] {
    let wedge = |name, degrees: f64, parts: i32| {
        let (angle, part) = (degrees.to_radians(), degrees.to_radians() / f64::from(parts));
        let points =
            (0..=parts).map(|k| [(part * f64::from(k)).cos(), (part * f64::from(k)).sin()]).collect();
        Polygon { name, points, angle, radii: [(0.5 * part).cos(), 1.0] }
    };
    let points = vec![[1.0, 0.0], [1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0], [0.0, -1.0]];
    let l_shape = Polygon { name: "L-shape", points, angle: 1.5 * PI, radii: [1.0, SQRT_2] };
    [wedge("60°", 60.0, 1), wedge("90°", 90.0, 1), wedge("150°", 150.0, 2), l_shape]
}

/// |w|_s from the values of w alone, on triangles with a node at the corner, or (`cut`) on these cut near the corner.
/// Rings of triangles that halve towards the corner, in ln r, until the sum over rings is below the tolerance.
fn on_polygon(
    options: &Options,
    polygon: &Polygon,
    gap: f64,
    cut: bool,
) -> fractional_sobolev::Result<Estimate> {
    let (a, b) = (gap - (1.0 - options.s.value()), PI / polygon.angle);
    let star = Triangles::star(&polygon.points)?;
    let mesh = if cut { star.cut_at(0, 0.45)? } else { star };
    let w = Function::from_plane_positions(&mesh, &[(0, a)], |at| {
        at.radius(0).powf(a) * (b * at.angle(0)).sin()
    })?;
    w.seminorm(options.s, options.tolerance)
}

fn run(options: &Options, out: &mut Report) -> Result<()> {
    for polygon in polygons() {
        for &gap in &options.gap {
            let [norm, again] =
                [on_polygon(options, &polygon, gap, false)?, on_polygon(options, &polygon, gap, true)?];
            let apart = (Measured::from(norm.value) / again.value - 1.0).abs();
            out.check("two triangulations, relative distance").at_most(
                apart,
                options.tolerance.relative(),
                "tolerance",
            );
            // On a sector polar coordinates leave one integral over the quotient of the radii.
            let on_sector = |radius: f64| {
                let w = Function::sector_power(
                    gap - (1.0 - options.s.value()),
                    PI / polygon.angle,
                    polygon.angle,
                    radius,
                )?;
                w.seminorm(options.s, options.tolerance)
            };
            let (inner, outer) =
                (Measured::from(on_sector(polygon.radii[0])?), Measured::from(on_sector(polygon.radii[1])?));
            out.check("inner sector over polygon").at_most(inner / norm, 1.0, "a part has a part");
            let ratio = Measured::from(norm) / outer;
            out.check("polygon over outer sector").at_most(ratio, 1.0, "a part has a part");
            let share = (-(inner / norm) + 1.0) / gap;
            out.check("(1 − inner sector/polygon)/(a + 1 − s)").at_most(share, 1.0, "R^(a+1−s), R < e r");
            out.row(cells! { polygon: polygon.name, gap => norm, inner: inner.value, apart: apart.value });
        }
    }
    for gap in [0.0, -1e-9, -0.2] {
        let refused =
            matches!(on_polygon(options, &polygons()[0], gap, false), Err(Refusal::InfiniteNorm { .. }));
        out.check("no norm for a + 1 − s ≤ 0").holds(refused, "rings do not decay");
    }
    out.column("gap", "a+1−s", "");
    out.column("norm", "|w|_s", "");
    out.column("inner", "inner sector", "");
    out.column("apart", "apart", "relative distance of the norms on two triangulations");
    out.plot("section_1_closures_in_the_plane", "Norms of r^a sin(πφ/ω)", Axes::LogLog("a + 1 − s", "|w|_s"))
        .curve_by("polygon", "gap", "norm");
    Ok(())
}
