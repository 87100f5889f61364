//! The deformed body of a contact solution: an elastic body on its floors, coloured by its largest
//! shear stress, or a membrane seen from the side, coloured by its displacement; arrows are the
//! contact pressure. Plots of the contact edge.
//!
//! Triangles of one colour share one SVG path, so a mesh of 10⁵ triangles is a file of a few dozen
//! elements.

use super::PALETTE;
use super::plot::{Axes, Bands, Mark, Plot};
use super::svg::{Canvas, INK, css};
use crate::Result;
use crate::cell::shortest;
use nalgebra::{Vector2, Vector3};
use signorini::contact::{ContactProblem, ContactSolution};
use signorini::edge::{EdgeTrace, Interval};
use signorini::fem::stresses;
use std::fmt::Write as _;

/// Sizes in user units: the picture, its margins, the tallest body, the colour bar with its labels
/// below.
const WIDTH: f64 = 640.0;
const MARGIN: f64 = 30.0;
const TOP: f64 = 40.0;
const TALLEST: f64 = 420.0;
const BELOW: f64 = 70.0;
const BAR: f64 = 190.0;
const FONT_SIZE: f64 = 15.0;
/// Hatching of a floor: its room, the distance of its strokes, and how far these reach along the
/// line and off it.
const HATCH: f64 = 12.0;
const STEP: f64 = 9.0;
const STROKE: [f64; 2] = [6.0, 8.0];
const SHADES: usize = 16;
/// Relative to the extent of the body: the largest displacement drawn, the largest arrow, and how
/// far a floor reaches beyond its edge.
const DRAWN: f64 = 0.25;
const ARROW: f64 = 0.15;
const FLOOR: f64 = 0.08;
/// How far a step into the page moves a membrane to the right and upwards.
const ASIDE: [f64; 2] = [0.4, 0.45];

type Point = Vector2<f64>;

/// One value per triangle: what colours the body.
pub(crate) fn body_values(
    problem: &ContactProblem,
    solution: &ContactSolution,
) -> Result<Vec<f64>> {
    let (mesh, u) = (problem.mesh(), &solution.displacement);
    if problem.form().components() == 2 {
        return Ok(stresses(mesh, problem.form(), u)?
            .iter()
            .map(|stress| stress.max_shear())
            .collect());
    }
    Ok(mesh.triangles().iter().map(|t| t.map(|node| u[node]).iter().sum::<f64>() / 3.0).collect())
}

/// The body in its deformed place, displacements magnified by 1, 2 or 5 times a power of ten, on
/// this scale of colour.
pub(crate) fn body_svg(
    problem: &ContactProblem,
    solution: &ContactSolution,
    title: &str,
    (low, high): (f64, f64),
) -> Result<String> {
    let (mesh, u, edge) = (problem.mesh(), &solution.displacement, problem.edge());
    let is_elastic = problem.form().components() == 2;
    let [width, height] =
        spans(mesh.nodes().iter().map(|&p| Point::from(p))).map(|(low, high)| high - low);
    let extent = width.max(height).max(f64::MIN_POSITIVE);
    let largest = u.iter().fold(0.0, |m: f64, u| m.max(u.abs()));
    let magnification = if largest > 0.0 { one_two_five(DRAWN * extent / largest) } else { 1.0 };
    let moved = |(node, &[x, y]): (usize, &[f64; 2])| match is_elastic {
        true => Point::new(x + magnification * u[2 * node], y + magnification * u[2 * node + 1]),
        false => Point::new(x + ASIDE[0] * y, ASIDE[1] * y + magnification * u[node]),
    };
    let nodes: Vec<Point> = mesh.nodes().iter().enumerate().map(moved).collect();
    let strongest = solution.pressure.iter().fold(0.0, |m: f64, p| m.max(p.abs()));
    // The floor presses against the normal; what keeps a membrane down presses from above.
    let outward = if is_elastic { edge.normals()? } else { vec![[0.0, 1.0]; edge.pieces().len()] };
    let (mut arrows, mut floors) = (Vec::new(), Vec::new());
    for (piece, normal) in edge.pieces().into_iter().zip(outward.into_iter().map(Point::from)) {
        for i in piece.clone().filter(|&i| solution.pressure[i] > 0.0) {
            let tip = nodes[edge.nodes()[i]];
            arrows.push([tip + normal * (ARROW * extent * solution.pressure[i] / strongest), tip]);
        }
        if is_elastic {
            // The line through the edge, under all of its nodes and beyond.
            let (point, along) =
                (Point::from(edge.points()[piece.start]), Point::new(-normal.y, normal.x));
            let places = edge.nodes()[piece].iter().map(|&node| (nodes[node] - point).dot(&along));
            let (start, end) = places.fold((0.0_f64, 0.0_f64), |(a, b), s| (a.min(s), b.max(s)));
            let ends = [start - FLOOR * extent, end + FLOOR * extent].map(|s| point + along * s);
            floors.push((ends, normal));
        }
    }
    let (value_name, unit) = match is_elastic {
        true => ("largest shear stress, in the unit of λ and μ", " in that unit"),
        false => ("displacement u", ""),
    };
    let drawn =
        nodes.iter().chain(arrows.iter().flatten()).chain(floors.iter().flat_map(|floor| &floor.0));
    let [x, y] = spans(drawn.copied());
    let (width, inner) = (x.1 - x.0, WIDTH - 2.0 * MARGIN);
    let scale = (inner / width).min(TALLEST / (y.1 - y.0));
    let scale = if scale.is_finite() && scale > 0.0 { scale } else { 1.0 };
    let corner = Point::new(x.0 - 0.5 * (inner / scale - width), y.1);
    let view =
        |p: Point| Point::new(MARGIN + (p.x - corner.x) * scale, TOP + (corner.y - p.y) * scale);
    let height = (TOP + (y.1 - y.0) * scale + HATCH + BELOW).round();
    let title = format!("{title}, displacement × {}, {} cone", short(magnification), solution.cone);
    let mut canvas = Canvas::new([WIDTH, height], &title, FONT_SIZE);
    canvas.text(&title, (WIDTH / 2.0, 20.0), "middle", " font-size=\"16\"");
    let path: String =
        floors.into_iter().map(|(ends, normal)| floor(ends.map(view), normal)).collect();
    canvas.path(&path, &format!("fill=\"none\" stroke=\"{INK}\" stroke-opacity=\"0.7\""));
    let share = |value: f64| if high > low { (value - low) / (high - low) } else { 0.0 };
    let mut paths = vec![String::new(); SHADES];
    for (triangle, value) in mesh.triangles().iter().zip(body_values(problem, solution)?) {
        let path = &mut paths[((share(value) * SHADES as f64) as usize).min(SHADES - 1)];
        for (letter, &node) in ['M', 'L', 'L'].into_iter().zip(triangle) {
            let place = view(nodes[node]);
            let _ = write!(path, "{letter}{:.2} {:.2}", place.x, place.y);
        }
        path.push('Z');
    }
    // Large meshes show their values, small ones also their edges.
    let line = if mesh.triangles().len() <= 20_000 { 0.25 } else { 0.0 };
    for (k, path) in paths.iter().enumerate() {
        let edges = format!("stroke=\"#333\" stroke-width=\"{line}\" stroke-opacity=\"0.6\"");
        canvas.path(path, &format!("fill=\"{}\" {edges}", shade(k)));
    }
    let path: String = arrows.into_iter().map(|ends| arrow(ends.map(view))).collect();
    canvas
        .path(&path, &format!("fill=\"none\" stroke=\"{}\" stroke-width=\"1.3\"", css(PALETTE[1])));
    let (top, step) = (height - 40.0, BAR / SHADES as f64);
    for k in 0..SHADES {
        let x = MARGIN + k as f64 * step;
        canvas.path(
            &format!("M{x:.2} {top}h{step:.2}v12h-{step:.2}Z"),
            &format!("fill=\"{}\"", shade(k)),
        );
    }
    let (above, below, right) = (top + 3.0, top + 25.0, MARGIN + BAR);
    canvas.text(&short(low), (MARGIN, below), "start", "");
    canvas.text(&short(high), (right, below), "end", "");
    canvas.text(value_name, (right + 14.0, above), "start", "");
    canvas.text("→", (right + 14.0, below), "start", &format!(" fill=\"{}\"", css(PALETTE[1])));
    let pressure = format!("contact pressure, largest {}{unit}", short(strongest));
    canvas.text(&pressure, (right + 33.0, below), "start", "");
    Ok(canvas.finish())
}

/// The least interval of each coordinate that holds all points.
fn spans(points: impl Iterator<Item = Point>) -> [(f64, f64); 2] {
    let none = [(f64::INFINITY, f64::NEG_INFINITY); 2];
    points.fold(none, |[x, y], p| [(x.0.min(p.x), x.1.max(p.x)), (y.0.min(p.y), y.1.max(p.y))])
}

/// A step of a path to a place, or by a distance.
fn step(letter: char, to: Point) -> String {
    format!("{letter}{:.1} {:.1}", to.x, to.y)
}

/// A line in the picture, hatched on the side of the normal, whose second component points up.
fn floor([from, to]: [Point; 2], normal: Point) -> String {
    let (length, along) = ((to - from).norm(), (to - from).normalize());
    let stroke = step('l', Point::new(normal.x, -normal.y) * STROKE[1] - along * STROKE[0]);
    let strokes = (0..=(length / STEP) as usize)
        .map(|k| step('M', from + along * (k as f64 * STEP)) + &stroke);
    step('M', from) + &step('L', to) + &strokes.collect::<String>()
}

/// An arrow from the first place to the second; nothing where it is too short to be seen.
fn arrow([from, to]: [Point; 2]) -> String {
    let length = (to - from).norm();
    if length < 0.5 {
        return String::new();
    }
    let back = (from - to) * (4.0f64.min(length) / length);
    let aside = Point::new(back.y, -back.x) * 0.5;
    let head = [step('M', to + back + aside), step('L', to), step('L', to + back - aside)];
    step('M', from) + &step('L', to) + &head.concat()
}

/// u_N and −σ_N along the contact edges, each divided by its maximum.
pub(crate) fn edge_plot(
    name: &str,
    title: &str,
    problem: &ContactProblem,
    solution: &ContactSolution,
) -> Plot {
    let edge = problem.edge();
    let title =
        format!("{title}: displacement and pressure on the contact edge, {} cone", solution.cone);
    let axes = Axes::Linear("distance along the contact edge", "share of the largest value");
    let mut plot = Plot::new(name, &title, axes);
    let pieces = edge.pieces();
    for (number, piece) in pieces.iter().enumerate() {
        let scaled = |values: &[f64]| -> Vec<(f64, f64)> {
            let largest = values.iter().fold(0.0, |m: f64, v| m.max(v.abs()));
            let unit = if largest > 0.0 { largest } else { 1.0 };
            piece.clone().map(|i| (edge.arc()[i], values[i] / unit)).collect()
        };
        let which = if pieces.len() > 1 { format!(", edge {}", number + 1) } else { String::new() };
        plot.line(&format!("u_N, displacement{which}"), scaled(&solution.normal_displacement));
        let pressure = format!("−σ_N, contact pressure{which}");
        plot.given(Mark::LineAndPoints, &pressure, scaled(&solution.pressure));
    }
    plot
}

/// u_N and −σ_N along an edge, each divided by its maximum; the segments of the three cases are
/// shaded.
pub(crate) fn trace_plot(name: &str, edge: &EdgeTrace, cases: [Vec<Interval>; 3]) -> Plot {
    let title = format!("{} segments of a contact edge", cases.iter().map(Vec::len).sum::<usize>());
    let mut plot = Plot::new(name, &title, Axes::Linear("x", "share of the largest value"));
    for (name, values) in [("u_N", edge.displacement()), ("−σ_N", &edge.pressure())] {
        let largest = values.iter().fold(f64::MIN_POSITIVE, |m: f64, v| m.max(v.abs()));
        let points = edge.nodes().iter().zip(values).map(|(&x, v)| (x, v / largest));
        plot.line(name, points.step_by(values.len().div_ceil(2000)).collect());
    }
    let names = [("first case", 4), ("second case", 5), ("both cases", 2)];
    for (segments, (name, colour)) in cases.iter().zip(names) {
        let intervals = segments.iter().map(|segment| (segment.start, segment.end)).collect();
        plot.bands.push(Bands { name, intervals, colour: PALETTE[colour] });
    }
    plot
}

/// The largest 1, 2 or 5 times a power of ten not above `value` > 0.
fn one_two_five(value: f64) -> f64 {
    let decade = 10f64.powf(value.log10().floor());
    [5.0, 2.0, 1.0].into_iter().map(|m| m * decade).find(|&m| m <= value).unwrap_or(decade)
}

/// Colour k of the scale: from dark blue through green to yellow, of rising lightness (stops of the
/// viridis map).
fn shade(k: usize) -> String {
    const STOPS: [Vector3<f64>; 5] = [
        Vector3::new(68.0, 1.0, 84.0),
        Vector3::new(59.0, 82.0, 139.0),
        Vector3::new(33.0, 145.0, 140.0),
        Vector3::new(94.0, 201.0, 98.0),
        Vector3::new(253.0, 231.0, 37.0),
    ];
    let at = (k as f64 + 0.5) / SHADES as f64 * (STOPS.len() - 1) as f64;
    let colour = STOPS[at as usize].lerp(&STOPS[at as usize + 1], at.fract());
    format!("rgb({:.0},{:.0},{:.0})", colour.x, colour.y, colour.z)
}

/// Three significant digits.
fn short(value: f64) -> String {
    shortest(format!("{value:.2e}").parse().unwrap_or(value))
}

#[cfg(test)]
mod tests {
    use super::*;
    use signorini::cone::Cone;
    use signorini::contact::Solver;
    use signorini::fem::{Form, Lame};
    use signorini::mesh::parse_msh;

    /// The first number pairs of the first path with this attribute: x, y of "M", then of "L".
    fn first_stroke(picture: &str, attribute: &str) -> [f64; 2] {
        let at = picture.find(attribute).unwrap();
        let start = picture[..at].rfind("d=\"M").unwrap() + 4;
        let words =
            picture[start..at].split(|c: char| !(c.is_ascii_digit() || c == '.' || c == '-'));
        let numbers: Vec<f64> = words.filter_map(|word| word.parse().ok()).take(4).collect();
        let (dx, dy) = (numbers[2] - numbers[0], numbers[3] - numbers[1]);
        [dx / dx.hypot(dy), dy / dx.hypot(dy)]
    }

    #[test]
    fn floor_and_arrows_follow_the_normal_of_a_slanted_edge() {
        let mesh = parse_msh(include_str!("../../../data/l_shape.msh")).unwrap();
        let load: Vec<f64> =
            mesh.nodes().iter().flat_map(|p| [0.015, 0.02 - 0.03 * p[0]]).collect();
        let form = Form::elastic(Lame::new(1.0, 1.0).unwrap());
        let problem = ContactProblem::new(mesh, form, &load).unwrap();
        let solution = problem.solve(Cone::Nodal, Solver::ActiveSet).unwrap();
        let picture = body_svg(&problem, &solution, "L", (0.0, 1.0)).unwrap();
        // The floor rises by 20 degrees and presses upwards to the left; y of a picture points
        // down. One decimal is written.
        let (sin, cos) = 20_f64.to_radians().sin_cos();
        let [dx, dy] = first_stroke(&picture, "stroke=\"#D55E00\"");
        assert!((dx + sin).abs() < 0.02 && (dy + cos).abs() < 0.02);
        let [dx, dy] = first_stroke(&picture, "stroke-opacity=\"0.7\"");
        assert!((dx - cos).abs() < 0.02 && (dy + sin).abs() < 0.02);
    }
}
