//! Pictures in the plane: a triangle and its interpolant, needles, faces, pairs of triangles, a wedge, an end
//! that oscillates, a body in contact on all sides.

use super::pen::{BLUE, GREEN, INK, ORANGE, Pen, SQUARE};
use std::f64::consts::{LN_10, PI};

/// The square: clamped above and in contact below; in contact on all sides; the sawtooth that no mean sees.
pub(super) fn whole_boundary(kind: usize) -> String {
    let mut pen = Pen::new(320.0, 270.0, SQUARE);
    let side = 0.42;
    let corner = [(0.29, 0.0), (0.29 + side, 0.0), (0.29 + side, side), (0.29, side)];
    // A point of the boundary: side and share of it, moved outwards by `out`.
    let place = |s: f64, out: f64| {
        let (k, t) = ((s.floor() as usize) % 4, s.fract());
        let (a, b) = (corner[k], corner[(k + 1) % 4]);
        // At a corner along the bisector.
        let normals = [
            [(0.0, -1.0), (1.0, 0.0), (0.0, 1.0), (-1.0, 0.0)],
            [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)],
        ];
        let normal = normals[usize::from(t == 0.0)][k];
        (a.0 + (b.0 - a.0) * t + out * normal.0, a.1 + (b.1 - a.1) * t + out * normal.1)
    };
    pen.area(&corner, INK, 0.07);
    if kind == 2 {
        let teeth: Vec<(f64, f64)> = (0..=32)
            .map(|k| place(f64::from(k % 32) / 8.0, if k % 2 == 0 { 0.025 } else { -0.025 }))
            .collect();
        pen.curve(teeth, BLUE, "");
        pen.thin(&[corner[0], corner[1], corner[2], corner[3], corner[0]], INK, 0.6);
        for k in 0..32 {
            let (x, y) = place((f64::from(k) + 0.5) / 8.0, 0.0);
            pen.dot(x, y, GREEN);
        }
    } else {
        let parts = [(0.0, 0.3, ORANGE), (0.3, 0.7, BLUE), (0.7, 1.0, ORANGE)];
        for k in 0..if kind == 0 { 1 } else { 4 } {
            for (from, to, colour) in parts {
                let ends = [place(k as f64 + from + 1e-9, 0.0), place(k as f64 + to - 1e-9, 0.0)];
                pen.curve(ends, colour, "style=\"stroke-width:6\"");
            }
        }
        if kind == 0 {
            pen.curve([corner[2], corner[3]], INK, "style=\"stroke-width:7\"");
            pen.words(0.5, side + 0.03, "clamped", INK);
            pen.thin(&[corner[1], corner[2]], INK, 0.6);
            pen.thin(&[corner[3], corner[0]], INK, 0.6);
        }
        pen.note(0.76, 0.2, "contact", ORANGE);
        pen.note(0.76, 0.14, "gap", BLUE);
    }
    let words = [
        "the membrane: clamped above, one contact edge below",
        "Remark 1: nothing is clamped, every side is a contact edge, a ring",
        "on a ring with an even number of segments a sawtooth has mean zero on every segment",
    ];
    pen.words(0.5, -0.07, words[kind], INK);
    pen.svg()
}

/// A function above a triangle and its interpolant on n² triangles, drawn from the side.
pub(super) fn triangle(n: usize) -> String {
    let mut pen = Pen::new(330.0, 300.0, 315.0);
    let height = |x: f64, y: f64| 0.25 + 0.55 * x.hypot(y).powf(0.4);
    let shown = |x: f64, y: f64, z: f64| (0.06 + 0.72 * x + 0.3 * y, 0.32 * y + z * 0.75);
    let at = |i: usize, j: usize| (i as f64 / n as f64, j as f64 / n as f64);
    let lifted = |(x, y): (f64, f64)| shown(x, y, height(x, y));
    let base: Vec<(f64, f64)> =
        [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (0.0, 0.0)].map(|(x, y)| shown(x, y, 0.0)).to_vec();
    pen.area(&base, INK, 0.07);
    for i in 0..n {
        for j in 0..n - i {
            let mut corners = vec![[at(i, j), at(i + 1, j), at(i, j + 1)]];
            if i + j + 2 <= n {
                corners.push([at(i + 1, j + 1), at(i + 1, j), at(i, j + 1)]);
            }
            for [a, b, c] in corners {
                let flat: Vec<(f64, f64)> = [a, b, c, a].map(|(x, y)| shown(x, y, 0.0)).to_vec();
                pen.thin(&flat, INK, 0.5);
                pen.area(&[lifted(a), lifted(b), lifted(c)], GREEN, 0.35);
                pen.curve([lifted(a), lifted(b), lifted(c), lifted(a)], GREEN, "");
            }
        }
    }
    // Lines of the function at fixed x and at fixed y.
    for k in 0..=8 {
        let t = f64::from(k) / 8.0;
        let along = (0..=40).map(|j| (1.0 - t) * f64::from(j) / 40.0);
        let lines: [Vec<(f64, f64)>; 2] =
            [along.clone().map(|s| lifted((t, s))).collect(), along.map(|s| lifted((s, t))).collect()];
        lines.iter().for_each(|line| pen.thin(line, BLUE, 0.9));
    }
    for i in 0..=n {
        for j in 0..=n - i {
            let (x, y) = at(i, j);
            pen.thin(&[shown(x, y, 0.0), lifted((x, y))], INK, 0.5);
            let (x, y) = lifted((x, y));
            pen.dot(x, y, GREEN);
        }
    }
    pen.words(0.42, -0.05, "blue: the function; green: linear, right at the corners", INK);
    pen.svg()
}

/// A needle of width δ: the gradient of x²/2 along it, and the distance at which pairs feel its width.
pub(super) fn needle(width: f64) -> String {
    let mut pen = Pen::new(320.0, 160.0, SQUARE);
    let (tip, length) = (0.05, 0.9);
    let half = |x: f64| 0.5 * width * (x - tip);
    for k in 0..18 {
        let (a, b) = (tip + length * f64::from(k) / 18.0, tip + length * f64::from(k + 1) / 18.0);
        let piece = [(a, -half(a)), (b, -half(b)), (b, half(b)), (a, half(a))];
        pen.area(&piece, BLUE, 0.05 + 0.75 * f64::from(k) / 17.0);
    }
    let whole = tip + length;
    pen.thin(&[(tip, 0.0), (whole, -half(whole)), (whole, half(whole)), (tip, 0.0)], INK, 0.9);
    pen.circle((0.6, 0.0), 0.5 * width * length, ORANGE);
    pen.dot(0.6, 0.0, ORANGE);
    pen.words(0.4, 0.265, "blue: the size of the gradient, the same across the needle", BLUE);
    pen.words(0.5, -0.28, "orange: how far pairs look as in the plane; farther away they see a line", ORANGE);
    pen.svg()
}

/// A face in contact but for three corners of size r.
pub(super) fn face(size: f64) -> String {
    let mut pen = Pen::new(330.0, 270.0, SQUARE);
    let corners = [(0.26, 0.0), (0.74, 0.0), (0.5, 0.48 * 0.75f64.sqrt())];
    pen.area(&corners, ORANGE, 0.45);
    for k in 0..3 {
        let toward = |to: (f64, f64)| {
            (corners[k].0 + size * (to.0 - corners[k].0), corners[k].1 + size * (to.1 - corners[k].1))
        };
        let gap = [corners[k], toward(corners[(k + 1) % 3]), toward(corners[(k + 2) % 3])];
        pen.area(&gap, BLUE, 1.0);
        pen.dot(corners[k].0, corners[k].1, INK);
    }
    pen.words(0.5, 0.15, "contact: σ_N = −1", INK);
    pen.note(0.76, 0.005, "u = −1", BLUE);
    pen.ending(0.24, 0.005, "u = −1", BLUE);
    pen.note(0.53, 0.41, "u = −1", BLUE);
    pen.words(
        0.5,
        -0.07,
        "the interpolant sees the corners only: it is −1 on all of the face, however small the gaps",
        INK,
    );
    pen.svg()
}

/// Two triangles as their integral meets them: one twice, a common edge, a common corner, apart.
pub(super) fn touching(kind: usize) -> String {
    let mut pen = Pen::new(290.0, 235.0, SQUARE);
    let first = [(0.3, 0.05), (0.55, 0.02), (0.42, 0.36)];
    let second = match kind {
        0 => first,
        1 => [first[1], first[2], (0.72, 0.3)],
        2 => [first[1], (0.82, 0.04), (0.72, 0.34)],
        _ => [(0.68, 0.05), (0.92, 0.02), (0.82, 0.34)],
    };
    pen.area(&first, BLUE, 0.35);
    pen.area(&second, ORANGE, 0.35);
    let common: Vec<(f64, f64)> = first.into_iter().filter(|p| second.contains(p)).collect();
    match common.as_slice() {
        [p] => pen.dot(p.0, p.1, GREEN),
        [p, q] => pen.line(*p, *q, GREEN, "style=\"stroke-width:5\""),
        _ => {}
    }
    let centre = |t: [(f64, f64); 3], a: f64| {
        (a * t[0].0 + 0.5 * (1.0 - a) * (t[1].0 + t[2].0), a * t[0].1 + 0.5 * (1.0 - a) * (t[1].1 + t[2].1))
    };
    let (x, y) = (centre(first, 0.5), centre(second, if kind == 0 { 0.2 } else { 0.4 }));
    pen.line(x, y, INK, "stroke-dasharray=\"4 4\"");
    for (name, p) in [("x", x), ("y", y)] {
        pen.dot(p.0, p.1, INK);
        pen.words(p.0, p.1 + 0.025, name, INK);
    }
    let words = [
        "one triangle: three steps leave a corner and the edge opposite it",
        "a common edge: two steps leave pairs that do not touch",
        "a common corner: one step leaves a segment and a triangle that do not touch",
        "apart: nothing is singular, Gauss rules do it",
    ];
    pen.words(0.5, -0.07, words[kind], INK);
    pen.svg()
}

/// Level lines of the first singular function of a wedge, equal conditions on both sides, Laplace's equation.
pub(super) fn wedge(opening: u32) -> String {
    let mut pen = Pen::new(370.0, 170.0, SQUARE);
    let (centre, radius) = (0.5, 0.27);
    let exponent = 180.0 / f64::from(opening);
    let omega = f64::from(opening) * PI / 180.0;
    let at = |r: f64, angle: f64| (centre + radius * r * angle.cos(), radius * r * angle.sin());
    let mut body = vec![(centre, 0.0)];
    body.extend((0..=90).map(|k| at(1.0, omega * f64::from(k) / 90.0)));
    pen.area(&body, INK, 0.07);
    for k in 1..10 {
        let level = f64::from(k) / 10.0;
        let radius = |angle: f64| (level / (exponent * angle).sin().max(1e-9)).powf(1.0 / exponent);
        let line = (0..=300).map(|j| omega * f64::from(j) / 300.0).map(|angle| (radius(angle), angle));
        let line: Vec<(f64, f64)> = line.filter(|(r, _)| *r <= 1.0).map(|(r, a)| at(r, a)).collect();
        pen.thin(&line, BLUE, 1.0);
    }
    pen.line((centre, 0.0), at(1.0, 0.0), INK, "");
    pen.line((centre, 0.0), at(1.0, omega), INK, "");
    pen.words(
        0.5,
        -0.32,
        &format!("first exponent λ = {exponent:.2}: regularity below {:.2}", 1.0 + exponent),
        INK,
    );
    let words = if exponent < 1.0 {
        "the lines crowd at the corner: the gradient is infinite there"
    } else {
        "the lines keep away from the corner: the gradient vanishes there"
    };
    pen.words(0.5, -0.36, words, BLUE);
    pen.svg()
}

/// The gap beside a clamped end without the condition of contact, over the square root of the distance.
pub(super) fn oscillation(poisson: f64) -> String {
    let mut pen = Pen::new(310.0, 100.0, 70.0);
    const DECADES: f64 = 60.0;
    let epsilon = (3.0 - 4.0 * poisson).ln() / (2.0 * PI);
    let value = |x: f64| (epsilon * DECADES * LN_10 * (1.0 - x) + 0.9).sin();
    let points = || (0..=600).map(|k| f64::from(k) / 600.0);
    let mut below: Vec<(f64, f64)> = points().map(|x| (x, value(x).min(0.0))).collect();
    below.extend([(1.0, 0.0), (0.0, 0.0)]);
    pen.fill(&below, ORANGE);
    pen.line((0.0, 0.0), (1.0, 0.0), INK, "opacity=\"0.4\"");
    pen.graph_fine(value, BLUE);
    pen.note(0.0, 1.2, "without the condition: the gap over √r changes sign for ever", BLUE);
    pen.note(0.0, -1.3, "orange: it would penetrate", ORANGE);
    let closed = 1.0 - (PI - 0.9) / (epsilon * DECADES * LN_10);
    pen.at(235.0, 14.0);
    pen.shade((0.0, closed.max(0.0)), (-0.6, 0.6), ORANGE, 0.8);
    pen.shade((closed.max(0.0), 1.0), (-0.6, 0.6), BLUE, 0.3);
    pen.note(0.0, 1.2, "with it: contact, up to the end", INK);
    for (k, label) in ["10^-60", "10^-40", "10^-20", "1"].into_iter().enumerate() {
        pen.words(k as f64 / 3.0, -2.2, label, INK);
    }
    pen.words(0.5, -4.2, "distance r from the clamped end", INK);
    pen.svg()
}
