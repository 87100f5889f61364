//! Pictures of means and zones: compactness, a function and its mean, products of means, sorting, a logarithm.

use super::pen::{BLUE, GREEN, INK, ORANGE, Pen};

/// The mean of a function over an interval, as exactly as a picture needs it.
pub(super) fn mean(f: impl Fn(f64) -> f64, from: f64, to: f64) -> f64 {
    (0..200).map(|k| f(from + (to - from) * (f64::from(k) + 0.5) / 200.0)).sum::<f64>() / 200.0
}

/// Functions of norm one with less and less seminorm over a zone on which their mean should be zero.
pub(super) fn flattening(n: u32) -> String {
    let mut pen = Pen::new(250.0, 180.0, 110.0);
    let swing = 0.45 / f64::from(n);
    pen.shade((0.0, 0.3), (-0.1, 1.45), ORANGE, 0.15);
    pen.words(0.15, 1.33, "zone", ORANGE);
    pen.line((0.0, 0.0), (1.0, 0.0), INK, "opacity=\"0.4\"");
    pen.dashed((0.0, 1.0), (1.0, 1.0));
    pen.note(0.87, 0.85, "a constant", INK);
    let v = |x: f64| 1.0 - swing * (9.0 * x + 0.4).cos();
    pen.graph(0.0, 1.0, BLUE, v);
    let mean = mean(v, 0.0, 0.3);
    pen.line((0.0, mean), (0.3, mean), ORANGE, "");
    pen.note(0.31, 0.07, "here the mean on the zone would have to be", ORANGE);
    pen.dot(0.3, 0.0, ORANGE);
    pen.words(0.5, -0.3, "less and less seminorm: the limit is a constant of norm one,", INK);
    pen.words(0.5, -0.48, "and the only constant with mean zero on the zone is zero", INK);
    pen.svg()
}

/// The function that is furthest from its mean at t, and the kernel that is its slope.
pub(super) fn deviation(t: f64) -> String {
    let mut pen = Pen::new(340.0, 110.0, 170.0);
    let v = |s: f64| if s < t { s * s / 2.0 } else { s * s / 2.0 - s + t };
    let mean = 1.0 / 6.0 - (1.0 - t) * (1.0 - t) / 2.0;
    pen.line((0.0, mean), (1.0, mean), GREEN, "stroke-dasharray=\"6 4\"");
    pen.note(1.01, mean - 0.02, "mean", GREEN);
    pen.graph(0.0, t, BLUE, v);
    pen.graph(t, 1.0, BLUE, v);
    pen.line((t, mean), (t, v(t)), ORANGE, "");
    pen.dot(t, v(t), ORANGE);
    pen.words(t, v(t) + 0.06, "x", ORANGE);
    pen.at(265.0, 50.0);
    pen.line((0.0, 0.0), (1.0, 0.0), INK, "opacity=\"0.4\"");
    pen.fill(&[(0.0, 0.0), (t, 0.0), (t, t)], BLUE);
    pen.fill(&[(t, 0.0), (t, t - 1.0), (1.0, 0.0)], BLUE);
    pen.line((0.0, 0.0), (t, t), BLUE, "");
    pen.line((t, t - 1.0), (1.0, 0.0), BLUE, "");
    pen.note(1.01, -0.1, "slope", BLUE);
    pen.words(0.5, -1.35, "orange: the deviation at x, the largest for this norm of the slope", INK);
    pen.svg()
}

/// Where the q-th power of a function that is not bounded has its weight; both over the logarithm of x.
pub(super) fn tall(q: f64) -> String {
    let mut pen = Pen::new(280.0, 220.0, 60.0);
    let power = 0.4;
    let age = |x: f64| 20.0 * (1.0 - x);
    let peak = power * q;
    let weight = |t: f64| 3.0 * ((t / peak).max(1e-9).ln() * peak - t + peak).exp();
    let mut area: Vec<(f64, f64)> =
        (0..=160).map(|k| f64::from(k) / 160.0).map(|x| (x, weight(age(x)))).collect();
    area.push((1.0, 0.0));
    area.push((0.0, 0.0));
    pen.fill(&area, ORANGE);
    pen.line((0.0, 0.0), (1.0, 0.0), INK, "opacity=\"0.4\"");
    pen.graph(0.0, 1.0, BLUE, |x| age(x).powf(power));
    pen.logarithms(-0.35);
    pen.note(0.72, 2.9, "ln(1/x) to the 2/5", BLUE);
    pen.words(
        0.5,
        -0.85,
        "orange: where the norm of L^q has its weight, the nearer to zero the larger q",
        INK,
    );
    pen.svg()
}

/// The ramp of the law at one half, over x and over its logarithm.
pub(super) fn ramp(length: f64) -> String {
    let mut pen = Pen::new(310.0, 120.0, 90.0);
    pen.line((0.0, 0.0), (1.0, 0.0), INK, "opacity=\"0.4\"");
    pen.graph_fine(|x| (1.0 + x.max(1e-99).ln() / length).max(0.0), BLUE);
    pen.note(0.85, 0.2, "over x", BLUE);
    pen.words(0.0, -0.2, "0", INK);
    pen.words(1.0, -0.2, "1", INK);
    pen.at(250.0, 90.0);
    let place = |t: f64| 1.0 - t / 20.0;
    pen.shade((0.0, place(length)), (0.0, 1.05), ORANGE, 0.15);
    if length < 20.0 {
        pen.note(0.01, 0.85, "the zone", ORANGE);
    }
    pen.line((0.0, 0.0), (1.0, 0.0), INK, "opacity=\"0.4\"");
    pen.line((0.0, 0.0), (place(length), 0.0), BLUE, "");
    pen.line((place(length), 0.0), (1.0, 1.0), BLUE, "");
    pen.note(0.6, 0.85, "over ln x", BLUE);
    pen.logarithms(-0.22);
    pen.words(0.5, -0.5, "through the logarithm the cheapest way down is a straight ramp", INK);
    pen.svg()
}

/// Twelve values as they stand, or sorted, and a zone of a quarter: three places, or the end.
pub(super) fn sorting(is_sorted: bool) -> String {
    let mut values = [0.35, 0.8, 0.15, 0.95, 0.7, 0.05, 0.5, 0.25, 0.6, 0.9, 0.45, 0.1];
    if is_sorted {
        values.sort_by(|a: &f64, b| b.total_cmp(a));
    }
    let zone = if is_sorted { [0, 1, 2] } else { [3, 4, 9] };
    let mut pen = Pen::new(270.0, 205.0, 170.0);
    let at = |k: usize| k as f64 / 12.0;
    for k in zone {
        pen.shade((at(k), at(k + 1)), (0.0, 1.05), ORANGE, 0.25);
    }
    pen.line((0.0, 0.0), (1.0, 0.0), INK, "opacity=\"0.4\"");
    pen.curve((0..12).flat_map(|k| [(at(k), values[k]), (at(k + 1), values[k])]), BLUE, "");
    let mean = zone.iter().map(|&k| values[k]).sum::<f64>() / 3.0;
    let steps: f64 = values.windows(2).map(|pair| (pair[1] - pair[0]).powi(2)).sum();
    pen.words(0.5, -0.12, &format!("mean over the orange quarter: {mean:.2}"), ORANGE);
    pen.words(0.5, -0.26, &format!("squared differences of neighbours, together: {steps:.2}"), BLUE);
    pen.svg()
}

/// The kernel over the distances that occur between two halves, and the one that the short proof puts for it.
pub(super) fn kernel(nu: f64) -> String {
    let mut pen = Pen::new(330.0, 40.0, 30.0);
    pen.shade((0.0, 0.5), (-0.5, 0.5), BLUE, 0.3);
    pen.shade((0.5, 1.0), (-0.5, 0.5), ORANGE, 0.3);
    pen.words(0.25, -0.15, "N: slope", BLUE);
    pen.words(0.75, -0.15, "E: pressure", ORANGE);
    pen.dot(0.0, 0.0, INK);
    pen.note(-0.03, 0.75, "x", INK);
    pen.at(275.0, 27.0);
    let value = |t: f64| t.powf(-1.0 - 2.0 * nu);
    let mut area: Vec<(f64, f64)> =
        (0..=80).map(|k| 0.5 + f64::from(k) / 160.0).map(|t| (t, value(t))).collect();
    area.push((0.5, 1.0));
    pen.fill(&area, GREEN);
    pen.graph(0.5, 1.0, GREEN, value);
    pen.dashed((0.0, 1.0), (1.0, 1.0));
    pen.line((0.0, 0.0), (1.0, 0.0), INK, "");
    pen.note(0.02, 1.2, "one, as in the short proof", INK);
    let mean = (4f64.powf(nu) - 1.0) / nu;
    pen.note(0.62, 4.0, &format!("its mean is {mean:.2}"), GREEN);
    pen.words(0.5, -1.3, "the weight of a pair (x, y), y in E; green: what the short proof gives away", INK);
    pen.svg()
}

/// On one segment with a gap at its end: both means, and their product.
pub(super) fn products(gap: f64) -> String {
    let mut pen = Pen::new(330.0, 40.0, 90.0);
    let displacement = |x: f64| -((gap - x).max(0.0) / gap).powf(1.2) * gap;
    let pressure = |x: f64| -((x - gap).max(0.0) / (1.0 - gap)).sqrt();
    let (u, s) = (mean(displacement, 0.0, 1.0), mean(pressure, 0.0, 1.0));
    let rows = [(40.0, u, "u_N", BLUE), (165.0, s, "σ_N", ORANGE)];
    for (k, (zero, mean, name, colour)) in rows.into_iter().enumerate() {
        pen.at(zero, 90.0);
        pen.line((0.0, 0.0), (1.0, 0.0), INK, "opacity=\"0.4\"");
        pen.shade((0.0, 1.0), (mean, 0.0), colour, 0.2);
        if k == 0 {
            pen.graph_fine(displacement, colour);
        } else {
            pen.graph_fine(pressure, colour);
        }
        pen.note(1.02, -0.1, name, colour);
        pen.note(1.02, mean.min(-0.3) - 0.05, "mean", colour);
    }
    pen.at(290.0, 90.0);
    pen.shade((0.0, 4.0 * u * s), (-0.1, 0.1), GREEN, 0.7);
    pen.note(0.0, 0.16, "the term of the segment: the product of the two means", GREEN);
    pen.words(0.5, -0.3, "small wherever the transition is: where one mean is large the other is not", INK);
    pen.svg()
}

/// The two errors of a projection, each with mean zero on every cell.
pub(super) fn orthogonal(cells: u32) -> String {
    let mut pen = Pen::new(300.0, 70.0, 90.0);
    let n = f64::from(cells);
    let mut errors = |zero: f64, colour: &str, name: &str, f: &dyn Fn(f64) -> f64| {
        pen.at(zero, 90.0);
        pen.line((0.0, 0.0), (1.0, 0.0), INK, "opacity=\"0.4\"");
        for k in 0..cells {
            let (a, b) = (f64::from(k) / n, f64::from(k + 1) / n);
            let mean = mean(f, a, b);
            let points = (0..=32).map(|j| a + (b - a) * f64::from(j) / 32.0).map(|x| (x, f(x) - mean));
            let mut area: Vec<(f64, f64)> = points.collect();
            area.extend([(b, 0.0), (a, 0.0)]);
            pen.fill(&area, colour);
        }
        pen.note(0.0, 0.62, name, colour);
    };
    errors(75.0, ORANGE, "φ minus its means", &|x| 1.7 * (x - 0.37).abs().sqrt());
    errors(200.0, BLUE, "ψ minus its means", &|x| (4.0 * x).sin() * 0.8);
    pen.words(0.5, -0.8, "against means the error of φ is zero: of ψ too only the error counts", INK);
    pen.svg()
}

/// The two cases of Section 4 on one segment: a short contact set, or a long one.
pub(super) fn short_or_long(is_long: bool) -> String {
    let (a, b) = if is_long { (0.2, 0.75) } else { (0.5, 0.6) };
    let mut pen = Pen::new(290.0, 70.0, 80.0);
    pen.shade((a, b), (-2.2, 0.2), if is_long { GREEN } else { ORANGE }, 0.18);
    pen.line((0.0, 0.0), (1.0, 0.0), INK, "opacity=\"0.4\"");
    let left = |x: f64| -0.6 * ((a - x).max(0.0) / 0.5).powf(1.3);
    let right = |x: f64| -0.6 * ((x - b).max(0.0) / 0.5).powf(1.3);
    let inside = |x: f64| if is_long { -8.0 * ((x - a) * (b - x)).max(0.0) * (x - 0.5).powi(2) } else { 0.0 };
    let u = |x: f64| left(x) + right(x) + inside(x);
    pen.graph_fine(u, BLUE);
    pen.note(1.02, -0.5, "u_N", BLUE);
    for x in [a, b] {
        pen.dot(x, 0.0, BLUE);
    }
    if is_long {
        pen.at(190.0, 22.0);
        pen.line((0.0, 0.0), (1.0, 0.0), INK, "opacity=\"0.4\"");
        pen.graph_fine(|x| (u(x + 1e-4) - u(x - 1e-4)) / 2e-4, BLUE);
        pen.note(1.02, 0.0, "slope", BLUE);
        pen.words(
            0.5,
            -4.0,
            "long: on the green piece the slope has mean zero, and Lemma 5.2 bounds it",
            INK,
        );
    } else {
        let mean = mean(u, 0.0, 1.0);
        pen.dashed((0.0, mean), (1.0, mean));
        pen.note(1.02, mean - 0.02, "mean", INK);
        pen.at(170.0, 80.0);
        pen.line((0.0, 0.0), (1.0, 0.0), INK, "opacity=\"0.4\"");
        pen.graph_fine(|x| -12.0 * ((x - a) * (b - x)).max(0.0).sqrt(), ORANGE);
        pen.note(1.02, -0.05, "σ_N", ORANGE);
        pen.words(
            0.5,
            -1.35,
            "short: all force sits on the orange piece; the displacement is near its mean",
            INK,
        );
    }
    pen.svg()
}
