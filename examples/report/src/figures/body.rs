//! The deformed body of a contact solution: an elastic body on its floors, coloured by its largest shear stress, or a
//! membrane seen from the side, coloured by its displacement; arrows are the contact pressure. And its contact edge.

use super::{Axis, BodyPicture, Chart, Floor, PALETTE, Series, picture::short};
use crate::Result;
use signorini::contact::{ContactProblem, ContactSolution};
use signorini::edge::{EdgeTrace, Interval};
use signorini::fem::stresses;

/// The largest displacement is drawn at most this long, relative to the extent of the body.
const DRAWN: f64 = 0.25;
/// The largest arrow, and how far a floor reaches beyond its edge, relative to that extent.
const ARROW: f64 = 0.15;
const FLOOR: f64 = 0.08;
/// How far a step into the page moves a membrane to the right and upwards.
const ASIDE: [f64; 2] = [0.4, 0.45];

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
    range: (f64, f64),
) -> Result<String> {
    let (mesh, u, edge) = (problem.mesh(), &solution.displacement, problem.edge());
    let is_elastic = problem.form().components() == 2;
    let side = |k: usize| {
        let coordinates = || mesh.nodes().iter().map(|p| p[k]);
        coordinates().fold(f64::NEG_INFINITY, f64::max) - coordinates().fold(f64::INFINITY, f64::min)
    };
    let extent = side(0).max(side(1)).max(f64::MIN_POSITIVE);
    let largest = u.iter().fold(0.0, |m: f64, u| m.max(u.abs()));
    let magnification = if largest > 0.0 { one_two_five(DRAWN * extent / largest) } else { 1.0 };
    let moved = |(node, &[x, y]): (usize, &[f64; 2])| match is_elastic {
        true => [x + magnification * u[2 * node], y + magnification * u[2 * node + 1]],
        false => [x + ASIDE[0] * y, ASIDE[1] * y + magnification * u[node]],
    };
    let nodes: Vec<[f64; 2]> = mesh.nodes().iter().enumerate().map(moved).collect();
    let strongest = solution.pressure.iter().fold(0.0, |m: f64, p| m.max(p.abs()));
    // The floor presses against the normal; what keeps a membrane down presses from above.
    let outward = if is_elastic { edge.normals()? } else { vec![[0.0, 1.0]; edge.pieces().len()] };
    let (mut arrows, mut floors) = (Vec::new(), Vec::new());
    for (piece, normal) in edge.pieces().into_iter().zip(outward) {
        for i in piece.clone().filter(|&i| solution.pressure[i] > 0.0) {
            let tip = nodes[edge.nodes()[i]];
            let length = ARROW * extent * solution.pressure[i] / strongest;
            arrows.push(([tip[0] + length * normal[0], tip[1] + length * normal[1]], tip));
        }
        if is_elastic {
            let places: Vec<_> = edge.nodes()[piece.clone()].iter().map(|&node| nodes[node]).collect();
            floors.push(Floor::under(edge.points()[piece.start], normal, &places, FLOOR * extent));
        }
    }
    let (value_name, unit) = match is_elastic {
        true => ("largest shear stress, in the unit of λ and μ", " in that unit"),
        false => ("displacement u", ""),
    };
    let picture = BodyPicture {
        title: format!("{title}, displacement × {}, {} cone", short(magnification), solution.cone),
        nodes: &nodes,
        triangles: mesh.triangles(),
        values: &body_values(problem, solution)?,
        range: Some(range),
        value_name: value_name.to_owned(),
        arrows: &arrows,
        arrow_name: format!("contact pressure, largest {}{unit}", short(strongest)),
        floors: &floors,
    };
    picture.svg()
}

/// u_N and −σ_N along the contact edges, each over its largest value.
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

/// u_N and −σ_N along an edge, each over its largest value, with the segments shaded that are in the first case, in
/// the second one, or in both, of Figure 3.2 or 4.1.
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
