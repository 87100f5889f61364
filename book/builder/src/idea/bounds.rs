//! Pictures of estimates: projections on cones, two bounds that cross, interpolation, a pinned function.

use super::pen::{BLUE, GREEN, INK, ORANGE, Pen};

/// Falk's lemma as geometry: distances are energy norms, and the solution is the nearest point of the cone.
pub(super) fn projections() -> String {
    let mut pen = Pen::new(330.0, 290.0, 250.0);
    // K and, inside it, K^h: wedges with the same tip.
    pen.fill(&[(0.05, 0.0), (0.95, 0.1), (0.95, 0.95), (0.3, 0.95)], BLUE);
    pen.fill(&[(0.05, 0.0), (0.95, 0.28), (0.95, 0.8), (0.5, 0.8)], GREEN);
    pen.note(0.82, 0.87, "K", INK);
    pen.note(0.82, 0.62, "K^h", INK);
    // Without the constraint the minimum lies outside; u and u^h are its nearest points.
    let (free, u, discrete, any) = ((0.62, -0.07), (0.6166, 0.063), (0.6026, 0.1719), (0.78, 0.32));
    pen.dashed(free, discrete);
    pen.line(u, any, ORANGE, "");
    pen.line(u, discrete, INK, "");
    for ((x, y), name, colour, right) in [
        (free, "minimum without constraint", INK, 0.015),
        (u, "u", INK, 0.015),
        (discrete, "u^h", INK, -0.04),
        (any, "any other v^h", INK, 0.015),
    ] {
        pen.dot(x, y, colour);
        pen.note(x + right, y - 0.02, name, colour);
    }
    pen.svg()
}

/// The bounds of both cases over θ, constants one, τ = 7/4, and where they cross.
pub(super) fn balance(cells: f64) -> String {
    let (tau, h) = (1.75f64, 1.0 / cells);
    let mut pen = Pen::new(300.0, 30.0, 25.0);
    // θ from 1/1000 to one, bounds from one down to 10^-4.
    let theta = |x: f64| 10f64.powf(3.0 * (x - 1.0));
    let height = |bound: f64| 2.0 * bound.log10();
    pen.line((0.0, -9.6), (1.0, -9.6), INK, "");
    pen.line((0.0, -9.6), (0.0, 1.0), INK, "");
    let first = |x: f64| height(h * theta(x).powf(tau - 1.0));
    let second = |x: f64| height(h.powf(2.0 * tau - 2.0) * theta(x).powf(tau - 2.0));
    pen.graph(0.0, 1.0, BLUE, first);
    pen.graph(0.0, 1.0, ORANGE, second);
    let cross = 1.0 + h.powf(2.0 * tau - 3.0).log10() / 3.0;
    pen.dashed((cross, -9.6), (cross, first(cross)));
    pen.dot(cross, first(cross), GREEN);
    pen.words(cross, first(cross) + 0.6, "θ = √h", GREEN);
    pen.note(0.08, first(0.08) + 0.9, "first case", BLUE);
    pen.note(0.08, second(0.08) + 0.4, "second case", ORANGE);
    for (x, label) in [(0.0, "1/1000"), (1.0 / 3.0, "1/100"), (2.0 / 3.0, "1/10"), (1.0, "1")] {
        pen.words(x, -10.5, label, INK);
    }
    pen.svg()
}

/// A function, its interpolant and the mean slope on one element.
pub(super) fn interpolation(cells: u32) -> String {
    let v = |x: f64| 0.25 + 0.5 * (1.0 - (2.0 * x - 0.9).abs().powf(1.3));
    let mut pen = Pen::new(270.0, 230.0, 250.0);
    let n = f64::from(cells);
    for k in 0..cells {
        let (a, b) = (f64::from(k) / n, f64::from(k + 1) / n);
        let mut edge: Vec<(f64, f64)> =
            (0..=24).map(|j| a + (b - a) * f64::from(j) / 24.0).map(|x| (x, v(x))).collect();
        edge.push((b, v(b)));
        pen.fill(&edge, ORANGE);
        pen.line((a, v(a)), (b, v(b)), GREEN, "");
        pen.dot(a, v(a), GREEN);
        pen.dot(b, v(b), GREEN);
    }
    pen.graph(0.0, 1.0, BLUE, v);
    pen.words(0.5, -0.08, "on each element the slope of the interpolant is the mean of the slope", INK);
    pen.svg()
}

/// One, pulled down to zero on a zone: cheap below one half, where the dip may be as narrow as one likes.
pub(super) fn pinned(theta: f64) -> String {
    let mut pen = Pen::new(250.0, 200.0, 150.0);
    let dip = |power: f64| move |x: f64| ((x - 0.5).abs() - theta).max(0.0).powf(power) * 0.5f64.powf(-power);
    pen.line((0.0, 0.0), (1.0, 0.0), INK, "opacity=\"0.4\"");
    pen.shade((0.5 - theta, 0.5 + theta), (-0.03, 1.1), ORANGE, 0.2);
    pen.graph_fine(dip(0.06), BLUE);
    pen.graph_fine(dip(0.4), GREEN);
    pen.dot(0.5, 0.0, INK);
    pen.note(0.02, 1.16, "below one half: almost one, and nearly no energy", BLUE);
    pen.note(0.67, 0.1, "above: it comes up slowly", GREEN);
    pen.words(0.5, -0.22, "what holds a function down: a zone, and at last a point", INK);
    pen.svg()
}
