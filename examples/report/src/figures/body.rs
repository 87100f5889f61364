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
use signorini::mesh::{BoundaryEdge, Part};
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
/// Share of the area, and of the pressed length of all floors, whose largest values are cut off in
/// a picture if they exceed the others by the factor.
const PEAK: f64 = 0.01;
const FACTOR: f64 = 2.0;
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

/// The colours of a body range from the least value to the largest one, without peaks.
pub(crate) fn body_range(
    problem: &ContactProblem,
    solution: &ContactSolution,
) -> Result<(f64, f64)> {
    let values = body_values(problem, solution)?;
    let low = values.iter().fold(f64::INFINITY, |low, &value| low.min(value));
    let high = values.iter().fold(f64::NEG_INFINITY, |high, &value| high.max(value));
    if problem.form().components() == 1 {
        return Ok((low, high));
    }
    let mesh = problem.mesh();
    let areas = (0..values.len()).map(|t| {
        let [a, b, c] = mesh.corners(t).map(Point::from);
        (b - a).perp(&(c - a)).abs()
    });
    Ok((low, without_peaks(values.iter().copied().zip(areas).collect())))
}

/// The largest of these (value, weight), or the value exceeded on a share [`PEAK`] of the weight if
/// the largest one is more than [`FACTOR`] times that.
fn without_peaks(mut values: Vec<(f64, f64)>) -> f64 {
    values.sort_by(|a, b| b.0.total_cmp(&a.0));
    let most = values.first().map_or(0.0, |first| first.0);
    let mut rest = PEAK * values.iter().map(|(_, weight)| weight).sum::<f64>();
    let usual = values.iter().find(|(_, weight)| {
        rest -= weight;
        rest < 0.0
    });
    let usual = usual.map_or(most, |one| one.0);
    if usual > 0.0 && most > FACTOR * usual { usual } else { most }
}

/// The name of every contact edge: that of its group, or those of its groups, numbered where
/// several edges have the same.
pub fn floor_names(problem: &ContactProblem) -> Vec<String> {
    let (mesh, edge) = (problem.mesh(), problem.edge());
    let mut piece_of = std::collections::HashMap::new();
    for (number, piece) in edge.pieces().into_iter().enumerate() {
        piece_of.extend(edge.nodes()[piece].iter().map(|&node| (node, number)));
    }
    let mut groups = vec![Vec::new(); edge.pieces().len()];
    let contact = |side: &BoundaryEdge| side.part == Part::Contact;
    for (number, side) in mesh.boundary().iter().enumerate().filter(|(_, side)| contact(side)) {
        let Some(&piece) = side.nodes.iter().find_map(|node| piece_of.get(node)) else { continue };
        if !groups[piece].contains(&mesh.group(number)) {
            groups[piece].push(mesh.group(number));
        }
    }
    let names: Vec<String> = groups.iter().map(|names| names.join(" and ")).collect();
    let numbered = |(k, name): (usize, &String)| {
        let same = |other: &&String| *other == name;
        match names.iter().filter(same).count() {
            1 => name.clone(),
            _ => format!("{name} {}", names[..=k].iter().filter(same).count()),
        }
    };
    names.iter().enumerate().map(numbered).collect()
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
    let lengths = edge.nodal_lengths();
    let pressed = solution.pressure.iter().copied().zip(lengths.iter().copied());
    let unit = without_peaks(pressed.filter(|&(pressure, _)| pressure > 0.0).collect());
    // The floor presses against the normal; what keeps a membrane down presses from above.
    let outward = if is_elastic { edge.normals()? } else { vec![[0.0, 1.0]; edge.pieces().len()] };
    let (mut arrows, mut floors) = (Vec::new(), Vec::new());
    for (piece, normal) in edge.pieces().into_iter().zip(outward.into_iter().map(Point::from)) {
        for i in piece.clone().filter(|&i| solution.pressure[i] > 0.0) {
            let (tip, share) = (nodes[edge.nodes()[i]], solution.pressure[i] / unit);
            arrows.push([tip + normal * (ARROW * extent * share.min(FACTOR)), tip]);
        }
        if is_elastic {
            // At the distance of the gap, magnified as the displacement: under every node, in order
            // along the edge, and straight on beyond both ends.
            let (point, along) =
                (Point::from(edge.points()[piece.start]), Point::new(-normal.y, normal.x));
            let under = |i: usize| {
                let s = (nodes[edge.nodes()[i]] - point).dot(&along);
                (s, point + along * s + normal * (magnification * problem.gap()[i]))
            };
            let mut places: Vec<(f64, Point)> = piece.map(under).collect();
            places.sort_by(|a, b| a.0.total_cmp(&b.0));
            let mut line: Vec<Point> = places.into_iter().map(|(_, place)| place).collect();
            if let ([first, ..], [.., last]) = (line.as_slice(), line.as_slice()) {
                let beyond = along * (FLOOR * extent);
                let (before, after) = (first - beyond, last + beyond);
                line.insert(0, before);
                line.push(after);
            }
            floors.push((line, normal));
        }
    }
    let (value_name, unit_name) = match is_elastic {
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
    let path: String = floors
        .into_iter()
        .map(|(line, normal)| floor(line.into_iter().map(view), normal))
        .collect();
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
    // The colours end below a peak, which is in words.
    let highest = body_values(problem, solution)?.into_iter().fold(low, f64::max);
    let peak = if highest > high { format!(", to {}", short(highest)) } else { String::new() };
    canvas.text(&format!("{value_name}{peak}"), (right + 14.0, above), "start", "");
    canvas.text("→", (right + 14.0, below), "start", &format!(" fill=\"{}\"", css(PALETTE[1])));
    let cut = if strongest > FACTOR * unit {
        format!(", arrows to {}", short(FACTOR * unit))
    } else {
        String::new()
    };
    let pressure = format!("contact pressure to {}{unit_name}{cut}", short(strongest));
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
fn floor(line: impl Iterator<Item = Point>, normal: Point) -> String {
    let places: Vec<Point> = line.collect();
    let (mut path, mut strokes, mut next) = (String::new(), String::new(), 0.0);
    for (k, place) in places.iter().enumerate() {
        path += &step(if k == 0 { 'M' } else { 'L' }, *place);
    }
    for (from, to) in places.iter().zip(places.iter().skip(1)) {
        let length = (to - from).norm();
        if length == 0.0 {
            continue;
        }
        let along = (to - from) / length;
        let stroke = step('l', Point::new(normal.x, -normal.y) * STROKE[1] - along * STROKE[0]);
        while next <= length {
            strokes += &(step('M', from + along * next) + &stroke);
            next += STEP;
        }
        next -= length;
    }
    path + &strokes
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

/// Nodes of all contact edges from which on markers would merge.
const MARKED: usize = 60;

/// u_N and −σ_N along the contact edges, each divided by its maximum, which the legend states.
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
    for (piece, name) in pieces.iter().zip(floor_names(problem)) {
        // The name and the values of a curve. A name is no formula: nothing in it is lowered.
        let curve = |what: &str, values: &[f64]| -> (String, Vec<(f64, f64)>) {
            let largest = values.iter().fold(0.0, |m: f64, v| m.max(v.abs()));
            let unit = if largest > 0.0 { largest } else { 1.0 };
            let points = piece.clone().map(|i| (edge.arc()[i], values[i] / unit)).collect();
            let name = name.replace(['_', '^'], " ");
            let which = if pieces.len() > 1 { format!(", {name}") } else { String::new() };
            (format!("{what}{which}: 1 is {}", short(largest)), points)
        };
        let (name, points) = curve("u_N, displacement", &solution.normal_displacement);
        plot.line(&name, points);
        let (name, points) = curve("−σ_N, contact pressure", &solution.pressure);
        let is_long = solution.pressure.len() > MARKED;
        let mark = if is_long { Mark::Line } else { Mark::LineAndPoints };
        plot.given(mark, &name, points);
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

    /// All M and L places of the first path with this attribute.
    fn places(picture: &str, attribute: &str) -> Vec<(char, f64, f64)> {
        let at = picture.find(attribute).unwrap();
        let path = &picture[picture[..at].rfind("d=\"M").unwrap() + 3..at];
        let path = &path[..path.find('"').unwrap()];
        let steps = path.split_inclusive(|c: char| c.is_ascii_alphabetic()).collect::<Vec<_>>();
        let letters = steps.iter().filter_map(|step| step.chars().last());
        let numbers = steps.iter().skip(1).map(|step| {
            let words = step.trim_end_matches(|c: char| c.is_ascii_alphabetic()).split(' ');
            words.filter_map(|word| word.parse().ok()).collect::<Vec<f64>>()
        });
        let pairs = letters.zip(numbers).filter(|(_, pair)| pair.len() == 2);
        pairs.map(|(letter, pair)| (letter, pair[0], pair[1])).collect()
    }

    /// A block over a floor with a gap that grows to the right, pressed down.
    fn over_a_gap() -> (ContactProblem, ContactSolution) {
        let mesh = signorini::mesh::unit_square(8, signorini::mesh::SideParts::HANGING).unwrap();
        let load: Vec<f64> = mesh.nodes().iter().flat_map(|_| [0.0, -1.0]).collect();
        let form = Form::elastic(Lame::new(1.0, 1.0).unwrap());
        let mut problem = ContactProblem::new(mesh, form, &load).unwrap();
        problem.set_gap(|[x, _]| 0.05 + 0.05 * x * x).unwrap();
        let solution = problem.solve(Cone::Nodal, Solver::ActiveSet).unwrap();
        (problem, solution)
    }

    #[test]
    fn a_floor_is_drawn_at_its_gap() {
        let (problem, solution) = over_a_gap();
        assert!(solution.pressure.iter().any(|&pressure| pressure > 0.0));
        let picture = body_svg(&problem, &solution, "block", (0.0, 1.0)).unwrap();
        let floor = places(&picture, "stroke-opacity=\"0.7\"");
        let line: Vec<_> = floor.iter().take_while(|place| place.0 != 'l').collect();
        let line = &line[..problem.edge().nodes().len() + 2];
        // A node in contact lies on the floor, which the tip of its arrow shows; y points down.
        let arrows = places(&picture, "stroke=\"#D55E00\"");
        let tips = arrows.windows(2).filter(|pair| pair[0].0 == 'M' && pair[1].0 == 'L');
        let mut found = 0;
        for &(_, x, y) in tips.map(|pair| &pair[1]) {
            let on_floor = |place: &&(char, f64, f64)| (place.1 - x).hypot(place.2 - y) < 0.3;
            assert!(line.iter().any(on_floor), "({x}, {y}): {line:?}");
            found += 1;
        }
        assert!(found >= 6, "{found}: two strokes for every arrow");
        assert!(line[1].2 + 1.0 < line[line.len() - 2].2, "the gap grows to the right: {line:?}");
    }

    #[test]
    fn a_peak_does_not_decide_the_scale() {
        let flat: Vec<(f64, f64)> = (0..1000).map(|k| (f64::from(k) / 1000.0, 1.0)).collect();
        assert_eq!(without_peaks(flat.clone()), 0.999);
        let peak = [flat, vec![(1e6, 0.5), (1e3, 0.5)]].concat();
        assert!((without_peaks(peak) - 0.99).abs() < 2e-3);
        assert_eq!(without_peaks(Vec::new()), 0.0);
    }

    #[test]
    fn the_curves_of_an_edge_have_its_name_and_their_unit() {
        let mesh = parse_msh(include_str!("../../../data/groove.msh")).unwrap();
        let load: Vec<f64> = mesh.nodes().iter().flat_map(|_| [0.0, -0.1]).collect();
        let form = Form::elastic(Lame::new(1.0, 1.0).unwrap());
        let problem = ContactProblem::new(mesh, form, &load).unwrap();
        let solution = problem.solve(Cone::Nodal, Solver::ActiveSet).unwrap();
        let mut names = floor_names(&problem);
        names.sort_unstable();
        assert_eq!(names, ["contact left", "contact right"]);
        let plot = format!("{:?}", edge_plot("edge", "groove", &problem, &solution));
        let largest = solution.pressure.iter().fold(0.0_f64, |m, p| m.max(*p));
        assert!(plot.contains("−σ_N, contact pressure, contact left: 1 is "), "{plot}");
        assert!(plot.contains(&format!(": 1 is {}", short(largest))), "{plot}");
    }
}
