//! The deformed body of a contact solution: an elastic body on its floors, coloured by its largest shear stress, or a
//! membrane seen from the side, coloured by its displacement; arrows are the contact pressure. Charts of the
//! contact edge.
//!
//! Triangles of one colour share one SVG path, so a mesh of 10⁵ triangles is a file of a few dozen elements.

use super::canvas::{STYLE, escape};
use super::scale::power_of_ten;
use super::{Axis, Chart, PALETTE, Series};
use crate::Result;
use signorini::contact::{ContactProblem, ContactSolution};
use signorini::edge::{EdgeTrace, Interval};
use signorini::fem::stresses;
use std::fmt::Write as _;

/// Sizes in user units: the picture, its margins, the tallest body, the colour bar with its labels below.
const WIDTH: f64 = 640.0;
const MARGIN: f64 = 30.0;
const TOP: f64 = 40.0;
const TALLEST: f64 = 420.0;
const BELOW: f64 = 70.0;
/// Hatching of a floor: its room, the distance of its strokes, and how far these reach along the line and off it.
const HATCH: f64 = 12.0;
const STEP: f64 = 9.0;
const STROKE: [f64; 2] = [6.0, 8.0];
const SHADES: usize = 16;
/// Relative to the extent of the body: the largest displacement drawn, the largest arrow, and how far a floor reaches
/// beyond its edge.
const DRAWN: f64 = 0.25;
const ARROW: f64 = 0.15;
const FLOOR: f64 = 0.08;
/// How far a step into the page moves a membrane to the right and upwards.
const ASIDE: [f64; 2] = [0.4, 0.45];

type Point = [f64; 2];

/// One value per triangle: what colours the body.
pub(crate) fn body_values(problem: &ContactProblem, solution: &ContactSolution) -> Result<Vec<f64>> {
    let (mesh, u) = (problem.mesh(), &solution.displacement);
    if problem.form().components() == 2 {
        return Ok(stresses(mesh, problem.form(), u)?.iter().map(|stress| stress.max_shear()).collect());
    }
    Ok(mesh.triangles().iter().map(|t| t.map(|node| u[node]).iter().sum::<f64>() / 3.0).collect())
}

/// The body in its deformed place, displacements magnified by 1, 2 or 5 times a power of ten, on this scale of colour.
pub(crate) fn body_svg(
    problem: &ContactProblem,
    solution: &ContactSolution,
    title: &str,
    (low, high): (f64, f64),
) -> Result<String> {
    let (mesh, u, edge) = (problem.mesh(), &solution.displacement, problem.edge());
    let is_elastic = problem.form().components() == 2;
    let [width, height] = spans(mesh.nodes().iter()).map(|(low, high)| high - low);
    let extent = width.max(height).max(f64::MIN_POSITIVE);
    let largest = u.iter().fold(0.0, |m: f64, u| m.max(u.abs()));
    let magnification = if largest > 0.0 { one_two_five(DRAWN * extent / largest) } else { 1.0 };
    let moved = |(node, &[x, y]): (usize, &Point)| match is_elastic {
        true => [x + magnification * u[2 * node], y + magnification * u[2 * node + 1]],
        false => [x + ASIDE[0] * y, ASIDE[1] * y + magnification * u[node]],
    };
    let nodes: Vec<Point> = mesh.nodes().iter().enumerate().map(moved).collect();
    let strongest = solution.pressure.iter().fold(0.0, |m: f64, p| m.max(p.abs()));
    // The floor presses against the normal; what keeps a membrane down presses from above.
    let outward = if is_elastic { edge.normals()? } else { vec![[0.0, 1.0]; edge.pieces().len()] };
    let (mut arrows, mut floors) = (Vec::new(), Vec::new());
    for (piece, normal) in edge.pieces().into_iter().zip(outward) {
        for i in piece.clone().filter(|&i| solution.pressure[i] > 0.0) {
            let tip = nodes[edge.nodes()[i]];
            let length = ARROW * extent * solution.pressure[i] / strongest;
            arrows.push([[tip[0] + length * normal[0], tip[1] + length * normal[1]], tip]);
        }
        if is_elastic {
            // The line through the edge, under all of its nodes and beyond.
            let (point, along) = (edge.points()[piece.start], [-normal[1], normal[0]]);
            let place = |p: Point| (p[0] - point[0]) * along[0] + (p[1] - point[1]) * along[1];
            let places = edge.nodes()[piece].iter().map(|&node| place(nodes[node]));
            let (start, end) = places.fold((0.0_f64, 0.0_f64), |(a, b), s| (a.min(s), b.max(s)));
            let at = |s: f64| [point[0] + s * along[0], point[1] + s * along[1]];
            floors.push(([at(start - FLOOR * extent), at(end + FLOOR * extent)], normal));
        }
    }
    let (value_name, unit) = match is_elastic {
        true => ("largest shear stress, in the unit of λ and μ", " in that unit"),
        false => ("displacement u", ""),
    };
    let drawn = nodes.iter().chain(arrows.iter().flatten()).chain(floors.iter().flat_map(|floor| &floor.0));
    let view = View::of(spans(drawn));
    let height = TOP + view.height + BELOW;
    let title = format!("{title}, displacement × {}, {} cone", short(magnification), solution.cone);
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" aria-label=\"{0}\" width=\"{WIDTH}\" \
         height=\"{height:.0}\" viewBox=\"0 0 {WIDTH} {height:.0}\">\n{STYLE}\n\
         <g font-family=\"sans-serif\" font-size=\"15\" fill=\"currentColor\">\n\
         <text x=\"{1}\" y=\"24\" font-size=\"16\" text-anchor=\"middle\">{0}</text>\n",
        escape(&title),
        WIDTH / 2.0,
    );
    let path: String = floors.into_iter().map(|(ends, normal)| view.floor(ends, normal)).collect();
    if !path.is_empty() {
        let ink = "stroke=\"currentColor\" stroke-opacity=\"0.7\"";
        let _ = writeln!(svg, "<path d=\"{path}\" fill=\"none\" {ink}/>");
    }
    let share = |value: f64| if high > low { (value - low) / (high - low) } else { 0.0 };
    let mut paths = vec![String::new(); SHADES];
    for (triangle, value) in mesh.triangles().iter().zip(body_values(problem, solution)?) {
        let path = &mut paths[((share(value) * SHADES as f64) as usize).min(SHADES - 1)];
        for (letter, &node) in ['M', 'L', 'L'].into_iter().zip(triangle) {
            let (x, y) = view.place(nodes[node]);
            let _ = write!(path, "{letter}{x:.2} {y:.2}");
        }
        path.push('Z');
    }
    // Large meshes show their values, small ones also their edges.
    let line = if mesh.triangles().len() <= 20_000 { 0.25 } else { 0.0 };
    for (k, path) in paths.iter().enumerate().filter(|(_, path)| !path.is_empty()) {
        let (fill, stroke) = (shade(k), "stroke=\"#333\"");
        let _ = writeln!(
            svg,
            "<path d=\"{path}\" {fill} {stroke} stroke-width=\"{line}\" stroke-opacity=\"0.6\"/>"
        );
    }
    let path: String = arrows.into_iter().map(|ends| view.arrow(ends)).collect();
    if !path.is_empty() {
        let ink = "stroke=\"rgb(213,94,0)\" stroke-width=\"1.3\"";
        let _ = writeln!(svg, "<path d=\"{path}\" fill=\"none\" {ink}/>");
    }
    let (bar, y, step) = (190.0, height - 40.0, 190.0 / SHADES as f64);
    for k in 0..SHADES {
        let (x, size) = (MARGIN + k as f64 * step, format!("width=\"{step:.2}\" height=\"12\""));
        let _ = writeln!(svg, "<rect x=\"{x:.2}\" y=\"{y:.1}\" {size} {}/>", shade(k));
    }
    let (below, right) = (y + 29.0, MARGIN + bar);
    let (beside, above) = (right + 14.0, y + 7.0);
    let _ = write!(
        svg,
        "<text x=\"{MARGIN}\" y=\"{below:.1}\">{}</text>\n\
         <text x=\"{right:.1}\" y=\"{below:.1}\" text-anchor=\"end\">{}</text>\n\
         <text x=\"{beside:.1}\" y=\"{above:.1}\">{value_name}</text>\n\
         <text x=\"{beside:.1}\" y=\"{below:.1}\"><tspan fill=\"rgb(213,94,0)\">→</tspan> contact pressure, largest \
         {}{unit}</text>\n</g>\n</svg>\n",
        short(low),
        short(high),
        short(strongest),
    );
    Ok(svg)
}

/// The least interval of each coordinate that holds all points.
fn spans<'a>(points: impl Iterator<Item = &'a Point>) -> [(f64, f64); 2] {
    let none = [(f64::INFINITY, f64::NEG_INFINITY); 2];
    points.fold(none, |[x, y], p| [(x.0.min(p[0]), x.1.max(p[0])), (y.0.min(p[1]), y.1.max(p[1]))])
}

/// The map from points of the plane to user units of a picture.
struct View {
    left: f64,
    top: f64,
    scale: f64,
    height: f64,
}

impl View {
    fn of([x, y]: [(f64, f64); 2]) -> Self {
        let (span, inner) = ([x.1 - x.0, y.1 - y.0], WIDTH - 2.0 * MARGIN);
        let scale = (inner / span[0]).min(TALLEST / span[1]);
        let scale = if scale.is_finite() && scale > 0.0 { scale } else { 1.0 };
        let left = x.0 - 0.5 * (inner / scale - span[0]);
        Self { left, top: y.1, scale, height: span[1] * scale + HATCH }
    }

    fn place(&self, [x, y]: Point) -> (f64, f64) {
        (MARGIN + (x - self.left) * self.scale, TOP + (self.top - y) * self.scale)
    }

    /// Both ends, the unit vector from the first to the second, and the distance.
    fn stroke(&self, ends: [Point; 2]) -> ([(f64, f64); 2], (f64, f64), f64) {
        let [(x0, y0), (x1, y1)] = ends.map(|end| self.place(end));
        let length = (x1 - x0).hypot(y1 - y0);
        ([(x0, y0), (x1, y1)], ((x1 - x0) / length, (y1 - y0) / length), length)
    }

    /// A line, hatched on the side of the normal.
    fn floor(&self, ends: [Point; 2], normal: Point) -> String {
        let ([(x0, y0), (x1, y1)], (dx, dy), length) = self.stroke(ends);
        let hatch = [normal[0] * STROKE[1] - dx * STROKE[0], -normal[1] * STROKE[1] - dy * STROKE[0]];
        let mut path = format!("M{x0:.1} {y0:.1}L{x1:.1} {y1:.1}");
        for at in (0..=(length / STEP) as usize).map(|k| k as f64 * STEP) {
            let (x, y) = (x0 + at * dx, y0 + at * dy);
            let _ = write!(path, "M{x:.1} {y:.1}l{:.1} {:.1}", hatch[0], hatch[1]);
        }
        path
    }

    /// An arrow from the first place to the second; nothing where it is too short to be seen.
    fn arrow(&self, ends: [Point; 2]) -> String {
        let ([(x0, y0), (x1, y1)], (dx, dy), length) = self.stroke(ends);
        if length < 0.5 {
            return String::new();
        }
        let head = 4.0f64.min(length);
        let (dx, dy) = (dx * head, dy * head);
        format!(
            "M{x0:.1} {y0:.1}L{x1:.1} {y1:.1}M{:.1} {:.1}L{x1:.1} {y1:.1}L{:.1} {:.1}",
            x1 - dx - 0.5 * dy,
            y1 - dy + 0.5 * dx,
            x1 - dx + 0.5 * dy,
            y1 - dy - 0.5 * dx,
        )
    }
}

/// u_N and −σ_N along the contact edges, each divided by its maximum.
pub(crate) fn edge_chart(problem: &ContactProblem, solution: &ContactSolution, title: &str) -> Chart {
    let edge = problem.edge();
    let title = format!("{title}: displacement and pressure on the contact edge, {} cone", solution.cone);
    let axes = ["distance along the contact edge", "share of the largest value"].map(Axis::linear);
    let [x, y] = axes;
    let mut chart = Chart::new(title, x, y);
    let pieces = edge.pieces();
    for (number, piece) in pieces.iter().enumerate() {
        let scaled = |values: &[f64]| -> Vec<(f64, f64)> {
            let largest = values.iter().fold(0.0, |m: f64, v| m.max(v.abs()));
            let unit = if largest > 0.0 { largest } else { 1.0 };
            piece.clone().map(|i| (edge.arc()[i], values[i] / unit)).collect()
        };
        let which = if pieces.len() > 1 { format!(", edge {}", number + 1) } else { String::new() };
        chart = chart
            .with(Series::line(format!("u_N, displacement{which}"), scaled(&solution.normal_displacement)))
            .with(Series::line_and_points(
                format!("−σ_N, contact pressure{which}"),
                scaled(&solution.pressure),
            ));
    }
    chart
}

/// The chart of u_N and −σ_N along an edge, each divided by the maximum of its absolute value; the segments
/// in the first case of Figure 3.2 or 4.1, in the second case, and in both are shaded.
pub fn edge_trace(edge: &EdgeTrace, cases: [Vec<Interval>; 3]) -> Chart {
    let title = format!("{} segments of a contact edge", cases.iter().map(Vec::len).sum::<usize>());
    let mut chart = Chart::new(title, Axis::linear("x"), Axis::linear("share of the largest value"));
    for (name, values) in [("u_N", edge.displacement()), ("−σ_N", &edge.pressure())] {
        let largest = values.iter().fold(f64::MIN_POSITIVE, |m: f64, v| m.max(v.abs()));
        let points = edge.nodes().iter().zip(values).map(|(&x, v)| (x, v / largest));
        chart = chart.with(Series::line(name, points.step_by(values.len().div_ceil(2000)).collect()));
    }
    for (segments, (name, colour)) in
        cases.iter().zip([("first case", 4), ("second case", 5), ("both cases", 2)])
    {
        let ends = segments.iter().map(|segment| (segment.start, segment.end));
        chart = chart.with_bands(name, ends.collect(), PALETTE[colour]);
    }
    chart
}

/// The largest 1, 2 or 5 times a power of ten not above `value` > 0.
fn one_two_five(value: f64) -> f64 {
    let decade = 10f64.powf(value.log10().floor());
    [5.0, 2.0, 1.0].into_iter().map(|m| m * decade).find(|&m| m <= value).unwrap_or(decade)
}

/// Colour k of the scale: from dark blue through green to yellow, of rising lightness (stops of the viridis map).
fn shade(k: usize) -> String {
    const STOPS: [[f64; 3]; 5] = [
        [68.0, 1.0, 84.0],
        [59.0, 82.0, 139.0],
        [33.0, 145.0, 140.0],
        [94.0, 201.0, 98.0],
        [253.0, 231.0, 37.0],
    ];
    let at = (k as f64 + 0.5) / SHADES as f64 * (STOPS.len() - 1) as f64;
    let (stop, part) = (at as usize, at.fract());
    let [r, g, b] =
        [0, 1, 2].map(|c| (STOPS[stop][c] + part * (STOPS[stop + 1][c] - STOPS[stop][c])).round());
    format!("fill=\"rgb({r},{g},{b})\"")
}

/// Three significant digits, with a raised exponent where that is shorter.
fn short(value: f64) -> String {
    let rounded: f64 = format!("{value:.2e}").parse().unwrap_or(value);
    if rounded == 0.0 || (1e-3..1e5).contains(&rounded.abs()) || !rounded.is_finite() {
        return rounded.to_string();
    }
    let exponent = rounded.abs().log10().floor();
    let mantissa: f64 = format!("{:.2}", rounded / 10f64.powf(exponent)).parse().unwrap_or(rounded);
    if mantissa == 1.0 {
        return power_of_ten(exponent as i64);
    }
    format!("{mantissa}·{}", power_of_ten(exponent as i64))
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
        let words = picture[start..at].split(|c: char| !(c.is_ascii_digit() || c == '.' || c == '-'));
        let numbers: Vec<f64> = words.filter_map(|word| word.parse().ok()).take(4).collect();
        let (dx, dy) = (numbers[2] - numbers[0], numbers[3] - numbers[1]);
        [dx / dx.hypot(dy), dy / dx.hypot(dy)]
    }

    #[test]
    fn floor_and_arrows_follow_the_normal_of_a_slanted_edge() {
        let mesh = parse_msh(include_str!("../../../data/l_shape.msh")).unwrap();
        let load: Vec<f64> = mesh.nodes().iter().flat_map(|p| [0.015, 0.02 - 0.03 * p[0]]).collect();
        let form = Form::elastic(Lame::new(1.0, 1.0).unwrap());
        let problem = ContactProblem::new(mesh, form, &load).unwrap();
        let solution = problem.solve(Cone::Nodal, Solver::ActiveSet).unwrap();
        let picture = body_svg(&problem, &solution, "L", (0.0, 1.0)).unwrap();
        // The floor rises by 20 degrees and presses upwards to the left; y of a picture points down. One decimal is written.
        let (sin, cos) = 20_f64.to_radians().sin_cos();
        let [dx, dy] = first_stroke(&picture, "stroke=\"rgb(213,94,0)\"");
        assert!((dx + sin).abs() < 0.02 && (dy + cos).abs() < 0.02);
        let [dx, dy] = first_stroke(&picture, "stroke-opacity=\"0.7\"");
        assert!((dx - cos).abs() < 0.02 && (dy + sin).abs() < 0.02);
    }
}
