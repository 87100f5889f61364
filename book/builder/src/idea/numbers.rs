//! Pictures of constants and of how they are computed: where each lives on a mesh, parts of a gradient, a
//! limit of meshes, pairs at a corner, points or triangles.

use super::grids::grid;
use super::pen::{BLUE, GREEN, INK, ORANGE, Pen, SQUARE};

/// Where the constants of the theorem live on the mesh above the contact edge: C on triangles, K and P on
/// segments.
pub(super) fn constants(kind: usize) -> String {
    let mut pen = Pen::new(300.0, 225.0, SQUARE);
    let (n, rows) = (8u32, 3u32);
    let h = 1.0 / f64::from(n);
    grid(&mut pen, n, rows, 0.35);
    let at = |i: u32, j: u32| (h * f64::from(i), h * f64::from(j));
    if kind == 0 {
        for i in 0..n {
            for j in 0..rows {
                let (a, c) = (at(i, j), at(i + 1, j + 1));
                let opacity = if (i, j) == (5, 1) { 0.9 } else { 0.18 };
                pen.area(&[a, at(i + 1, j), c], BLUE, opacity);
                pen.area(&[a, at(i, j + 1), c], BLUE, 0.18);
            }
        }
    } else {
        for i in 0..n {
            let (x, _) = at(i, 0);
            let (opacity, colour) = (if i == 5 { 1.0 } else { 0.35 }, if kind == 1 { ORANGE } else { GREEN });
            pen.shade((x + 0.004, x + h - 0.004), (-0.012, 0.012), colour, opacity);
        }
    }
    pen.line((0.0, 0.0), (1.0, 0.0), INK, "");
    let words = [
        ["C(s), one triangle: what interpolation loses of the gradient", "both cones"],
        [
            "K(ν), one segment: pressure times slope, each in its part of it",
            "half of K for the midpoint cone",
        ],
        ["P(ν), one segment: the pressure against its mean", "the midpoint cone alone"],
    ];
    let colour = [BLUE, ORANGE, GREEN][kind];
    pen.words(0.5, -0.065, words[kind][0], colour);
    pen.words(0.5, -0.108, words[kind][1], INK);
    pen.svg()
}

/// What a gradient does to a square: a part with trace, a symmetric part without, a rotation.
pub(super) fn strains(kind: usize) -> String {
    let mut pen = Pen::new(300.0, 130.0, SQUARE);
    let t = 0.25;
    let [[a, b], [c, d]] = [[[t, 0.0], [0.0, t]], [[t, 0.0], [0.0, -t]], [[0.0, -t], [t, 0.0]]][kind];
    let half = 0.14;
    let square = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0)];
    let moved = |(x, y): (f64, f64)| (0.5 + half * (x + a * x + b * y), half * (y + c * x + d * y));
    let body: Vec<(f64, f64)> = square.into_iter().map(moved).collect();
    let colour = [BLUE, ORANGE, INK][kind];
    pen.area(&body, colour, 0.25);
    pen.curve(body, colour, "");
    pen.curve(
        square.map(|(x, y)| (0.5 + half * x, half * y)),
        INK,
        "stroke-dasharray=\"5 5\" opacity=\"0.6\"",
    );
    for k in -1..=1 {
        let s = f64::from(k) / 1.5;
        for line in [[(s, -1.0), (s, 1.0)], [(-1.0, s), (1.0, s)]] {
            pen.thin(&line.map(moved), colour, 0.5);
        }
    }
    let words = [
        ["the part with trace, half the divergence times I", "its square costs 2(λ + μ)"],
        ["the symmetric part without trace", "its square costs 2μ"],
        ["the rotation", "it costs nothing"],
    ];
    pen.words(0.5, -0.24, words[kind][0], colour);
    pen.words(0.5, -0.285, words[kind][1], INK);
    pen.svg()
}

/// A norm on three meshes over the power of the mesh size by which it misses; lines through two give a limit.
pub(super) fn limit() -> String {
    let mut pen = Pen::new(330.0, 300.0, 280.0);
    let value = |x: f64| 0.95 - 0.75 * x + 0.2 * x * x;
    let xs = [0.9, 0.45, 0.225];
    pen.line((0.0, 0.0), (1.0, 0.0), INK, "");
    pen.line((0.0, 0.0), (0.0, 1.0), INK, "");
    let limits: Vec<f64> = xs
        .windows(2)
        .map(|pair| value(pair[1]) - pair[1] * (value(pair[0]) - value(pair[1])) / (pair[0] - pair[1]))
        .collect();
    for (k, pair) in xs.windows(2).enumerate() {
        pen.line((pair[0], value(pair[0])), (0.0, limits[k]), [ORANGE, BLUE][k], "stroke-dasharray=\"6 4\"");
        pen.dot(0.0, limits[k], [ORANGE, BLUE][k]);
    }
    let error = (limits[1] - limits[0]).abs() + 0.5 * (limits[1] - value(xs[2]));
    pen.shade((-0.035, -0.015), (limits[1] - error, limits[1] + error), GREEN, 0.8);
    for (x, name) in xs.into_iter().zip(["coarse", "half of it", "a quarter"]) {
        pen.dot(x, value(x), INK);
        pen.words(x, -0.075, name, INK);
    }
    pen.note(0.31, 0.93, "the limit of the finest two meshes", BLUE);
    pen.note(0.31, 0.85, "the limit of the two before", ORANGE);
    pen.note(0.31, 0.77, "what the limit may be off by", GREEN);
    pen.note(0.6, 0.65, "the norm on a mesh", INK);
    pen.words(0.0, -0.075, "h = 0", INK);
    pen.svg()
}

/// Two triangles with a common corner, and a pair of points at ρ and ρτ on its two rays.
pub(super) fn fan(halvings: usize) -> String {
    let rho = 0.5f64.powi(halvings as i32);
    let mut pen = Pen::new(330.0, 175.0, SQUARE);
    let tip = (0.08, -0.02);
    let at = |(x, y): (f64, f64), r: f64| (tip.0 + r * x, tip.1 + r * y);
    let first = [(0.82, 0.12), (0.62, 0.31)];
    let second = [(0.84, -0.06), (0.7, -0.24)];
    for (edge, colour) in [(first, BLUE), (second, ORANGE)] {
        for k in 0..4 {
            let r = 0.5f64.powi(k);
            let opacity = if (rho - r).abs() < 1e-9 { 0.4 } else { 0.1 };
            pen.area(&[tip, at(edge[0], r), at(edge[1], r)], colour, opacity);
            pen.thin(&[at(edge[0], r), at(edge[1], r)], colour, 0.7);
        }
        pen.thin(&[at(edge[0], 1.0), tip, at(edge[1], 1.0)], colour, 0.9);
    }
    let middle = |edge: [(f64, f64); 2]| (0.5 * (edge[0].0 + edge[1].0), 0.5 * (edge[0].1 + edge[1].1));
    let (x, y) = (at(middle(first), rho), at(middle(second), 0.7 * rho));
    pen.thin(&[tip, x], INK, 0.6);
    pen.thin(&[tip, y], INK, 0.6);
    pen.line(x, y, GREEN, "");
    pen.dot(x.0, x.1, BLUE);
    pen.dot(y.0, y.1, ORANGE);
    pen.dot(tip.0, tip.1, INK);
    pen.words(tip.0 - 0.03, tip.1 - 0.012, "P", INK);
    let name = ["x = P + e", "x = P + e/2", "x = P + e/4", "x = P + e/8"][halvings];
    pen.note(0.05, 0.24, name, BLUE);
    pen.note(0.05, -0.21, "y, in the same ratio", ORANGE);
    pen.words(
        0.5,
        -0.285,
        "every pair is one of full size, shrunk: the kernel takes a power of ρ, only the function is asked at every scale",
        INK,
    );
    pen.svg()
}

/// Digits from more points in the same triangles, or from more triangles.
pub(super) fn digits(doublings: usize) -> String {
    let mut pen = Pen::new(330.0, 235.0, SQUARE);
    let n = 1u32 << doublings;
    let side = 0.36;
    for (left, is_mesh) in [(0.05, false), (0.59, true)] {
        let cells = if is_mesh { 2 * n } else { 1 };
        let h = side / f64::from(cells);
        for k in 0..=cells {
            let t = h * f64::from(k);
            pen.thin(&[(left + t, 0.0), (left + t, side)], INK, 0.6);
            pen.thin(&[(left, t), (left + side, t)], INK, 0.6);
        }
        for k in 0..cells {
            let t = h * f64::from(k);
            pen.thin(&[(left + t, 0.0), (left + side, side - t)], INK, 0.6);
            if k > 0 {
                pen.thin(&[(left, t), (left + side - t, side)], INK, 0.6);
            }
        }
        if !is_mesh {
            // Points n by n in each triangle, from the square by one edge pulled together.
            for k in 0..n * n {
                let share = |k: u32| (f64::from(k) + 0.5) / f64::from(n);
                let (u, v) = (share(k / n), share(k % n));
                let (x, y) = (side * u * v, side * u * (1.0 - v));
                pen.circle((left + x, y), 0.003, BLUE);
                pen.circle((left + side - x, side - y), 0.003, BLUE);
            }
        }
    }
    // Digits as the laws have them: proportional to the points, or to the logarithm of the cells.
    let bars = [
        (0.05, 0.045 * f64::from(n), BLUE, "digits by points"),
        (0.59, 0.011 * f64::from(doublings as u32 + 1), ORANGE, "by triangles"),
    ];
    for (left, long, colour, name) in bars {
        pen.shade((left, left + long), (-0.055, -0.025), colour, 0.8);
        pen.note(left, -0.095, name, colour);
    }
    pen.words(
        0.5,
        -0.15,
        "twice the points: twice the digits; half the mesh size: as many more as before",
        INK,
    );
    pen.svg()
}
