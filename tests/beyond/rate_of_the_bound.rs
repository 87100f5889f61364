//! The one-dimensional part of the rate of the computed bound: densities on the contact edge that keep sign, resultant and
//! moment, and the integral of pressure times gap. Page `rate_of_the_bound`. Pressures and gaps are positive here.

use std::f64::consts::LN_2;

/// Resultant and moment about the left end of a pressure on a segment.
#[derive(Clone, Copy, Default)]
struct Force {
    resultant: f64,
    moment: f64,
}

/// The linear density on every segment of length h, by its values at both ends, and the resultants of segments whose centre
/// is off the middle third.
fn signed_projection(h: f64, forces: &[Force]) -> (Vec<[f64; 2]>, Vec<f64>) {
    let last = forces.len() - 1;
    let mut density = vec![[0.0; 2]; forces.len()];
    let mut moved = Vec::new();
    for (i, &Force { resultant, moment }) in
        forces.iter().enumerate().filter(|(_, f)| f.resultant > 0.0)
    {
        let (height, centre) = (2.0 * resultant / h, moment / resultant / h);
        if (1.0 / 3.0..=2.0 / 3.0).contains(&centre) {
            density[i][0] += height * (2.0 - 3.0 * centre);
            density[i][1] += height * (3.0 * centre - 1.0);
            continue;
        }
        moved.push(resultant);
        let (near, far, is_end) =
            if centre < 0.5 { (0, i.wrapping_sub(1), i == 0) } else { (1, i + 1, i == last) };
        let share = if is_end { 1.0 } else { 0.5 * (1.0 + 3.0 * centre.min(1.0 - centre)) };
        density[i][near] += height * share;
        if !is_end {
            density[far][1 - near] += height * (1.0 - share);
        }
    }
    (density, moved)
}

/// Numbers in [0, 1), the same on every machine.
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }

    fn below(&mut self, n: usize) -> usize {
        (self.next() * n as f64) as usize
    }
}

/// A random contact set on `segments` segments of length one with `cells` cells each: the pressure on each cell, and the gap at
/// the ends of the cells, zero where there is pressure, linear between. None without contact.
fn random_edge(random: &mut Random, segments: usize, cells: usize) -> Option<(Vec<f64>, Vec<f64>)> {
    let n = segments * cells;
    let (mut pressure, mut gap) = (vec![0.0; n], vec![0.0; n + 1]);
    let mean = [2, 5, 12, 30][random.below(4)];
    let (mut from, mut is_contact, mut touches) = (0, random.next() < 0.5, false);
    while from < n {
        let to = n.min(from + 1 + random.below(2 * mean));
        if is_contact {
            touches = true;
            let power = [0.0, 1.0, 6.0][random.below(3)];
            pressure[from..to].iter_mut().for_each(|p| *p = random.next().powf(power));
        } else {
            // A gap of the whole edge's end is open there; inside it closes at both ends.
            let open = usize::from(from > 0)..(to - from) + usize::from(to == n);
            open.for_each(|k| gap[from + k] = random.next());
        }
        (from, is_contact) = (to, !is_contact);
    }
    touches.then_some((pressure, gap))
}

fn forces(pressure: &[f64], cells: usize) -> Vec<Force> {
    let width = 1.0 / cells as f64;
    let force = |part: &[f64]| Force {
        resultant: part.iter().sum::<f64>() * width,
        moment: part.iter().zip(0..).map(|(p, k)| p * (f64::from(k) + 0.5)).sum::<f64>()
            * width
            * width,
    };
    pressure.chunks(cells).map(force).collect()
}

/// ∫ of the density times the gap, exactly.
fn pressure_times_gap(density: &[[f64; 2]], gap: &[f64], cells: usize) -> f64 {
    let width = 1.0 / cells as f64;
    let on_cell = |k: usize| {
        let [a, b] = density[k / cells];
        let at = |x: f64| a + (b - a) * x;
        let left = (k % cells) as f64 * width;
        let (p, q, d, e) = (at(left), at(left + width), gap[k], gap[k + 1]);
        width * (2.0 * p * d + 2.0 * q * e + p * e + q * d) / 6.0
    };
    (0..gap.len() - 1).map(on_cell).sum()
}

/// The squared seminorm of order ν < 1/2 of a function that is constant on cells, in closed form.
fn squared_seminorm(values: &[f64], width: f64, nu: f64) -> f64 {
    let power = 1.0 - 2.0 * nu;
    let g = |t: usize| -(t as f64).powf(power) / (2.0 * nu * power);
    let weight = |d: usize| g(d + 1) - 2.0 * g(d) + g(d - 1);
    let pair = |i: usize, j: usize| 2.0 * weight(i - j) * (values[i] - values[j]).powi(2);
    (0..values.len()).flat_map(|i| (0..i).map(move |j| pair(i, j))).sum::<f64>() * width.powf(power)
}

fn random_edges() -> impl Iterator<Item = (usize, Vec<f64>, Vec<f64>)> {
    let mut random = Random(57);
    let count = if crate::MANY { 20_000 } else { 1000 };
    (0..count).filter_map(move |_| {
        let (segments, cells) = ([1, 2, 3, 6][random.below(4)], [4, 8, 12][random.below(3)]);
        random_edge(&mut random, segments, cells).map(|(pressure, gap)| (cells, pressure, gap))
    })
}

#[test]
fn the_signed_projection_keeps_sign_resultant_and_moment() {
    let mut moved_inside = 0;
    for (cells, pressure, _) in random_edges() {
        let forces = forces(&pressure, cells);
        let (density, moved) = signed_projection(1.0, &forces);
        assert!(density.iter().flatten().all(|&end| end >= -1e-12));
        let all = |of: &dyn Fn(usize) -> f64| (0..forces.len()).map(of).sum::<f64>();
        let resultants =
            [all(&|i| forces[i].resultant), all(&|i| 0.5 * (density[i][0] + density[i][1]))];
        assert!((resultants[0] - resultants[1]).abs() < 1e-11 * (1.0 + resultants[0]));
        let off = |k: usize, low: f64, high: f64| {
            let Force { resultant, moment } = forces[k];
            resultant > 0.0 && (moment < low * resultant || moment > high * resultant)
        };
        if !off(0, 1.0 / 3.0, 1.0) && !off(forces.len() - 1, 0.0, 2.0 / 3.0) {
            let own = |i: usize| forces[i].moment + i as f64 * forces[i].resultant;
            let new = |i: usize| {
                density[i][0] / 6.0
                    + density[i][1] / 3.0
                    + 0.5 * i as f64 * (density[i][0] + density[i][1])
            };
            assert!((all(&own) - all(&new)).abs() < 1e-11 * (1.0 + all(&own)));
            moved_inside += moved.len();
        }
        // R <= sqrt(3) h^(1/2) ||pressure - mean|| where the centre is off the middle third.
        let mut moved = moved.iter();
        for (part, force) in pressure.chunks(cells).zip(&forces) {
            if force.resultant > 0.0
                && !(1.0..=2.0).contains(&(3.0 * force.moment / force.resultant))
            {
                let squares = part.iter().map(|p| (p - force.resultant).powi(2)).sum::<f64>();
                let bound = (3.0 * squares / cells as f64).sqrt();
                assert!(moved.next().is_some_and(|r| *r <= bound * (1.0 + 1e-12)));
            }
        }
    }
    assert!(moved_inside > 50, "{moved_inside}");
}

#[test]
fn pressure_times_gap_is_below_its_bound() {
    let mut largest: f64 = 0.0;
    for (cells, pressure, gap) in random_edges() {
        let width = 1.0 / cells as f64;
        let slope: Vec<f64> = gap.windows(2).map(|ends| (ends[1] - ends[0]) / width).collect();
        let (density, _) = signed_projection(1.0, &forces(&pressure, cells));
        let term = pressure_times_gap(&density, &gap, cells);
        for nu in [0.05, 0.25, 0.45] {
            let product =
                squared_seminorm(&pressure, width, nu) * squared_seminorm(&slope, width, nu);
            assert!(term <= 0.5 * product.sqrt(), "{nu}: {term} {product}");
            if product > 0.0 {
                largest = largest.max(term / product.sqrt());
            }
        }
    }
    assert!(largest > 0.01, "no term near its bound: {largest}");
}

/// A contact edge (0, 1) in pieces without a singularity inside: pressure and gap at x on piece k.
struct Edge {
    ends: Vec<f64>,
    at: Box<dyn Fn(usize, f64) -> [f64; 2]>,
}

/// Pressure (a − x)^(τ−2) for x < a, gap (x − a)^(τ−1) for x > a.
fn transition(a: f64, tau: f64) -> Edge {
    let halves = |k: i32| 0.5f64.powi(k);
    let left = (0..50).map(|k| a * (1.0 - halves(k)));
    let right = (0..50).rev().map(|k| a + (1.0 - a) * halves(k));
    let at = move |_, x: f64| {
        if x < a { [(a - x).powf(tau - 2.0), 0.0] } else { [0.0, (x - a).powf(tau - 1.0)] }
    };
    Edge { ends: left.chain([a]).chain(right).collect(), at: Box::new(at) }
}

/// Pressure one outside the gaps of a fat Cantor set in (start, start + size), in them the distance from their ends.
fn fat_cantor(start: f64, size: f64, first: f64, ratio: f64, levels: u32) -> Edge {
    fn gaps(low: f64, high: f64, length: f64, ratio: f64, levels: u32, found: &mut Vec<[f64; 2]>) {
        if levels > 0 {
            let middle = 0.5 * (low + high);
            let gap = [middle - 0.5 * length, middle + 0.5 * length];
            gaps(low, gap[0], length * ratio, ratio, levels - 1, found);
            found.push(gap);
            gaps(gap[1], high, length * ratio, ratio, levels - 1, found);
        }
    }
    let mut found = Vec::new();
    gaps(0.0, 1.0, first, ratio, levels, &mut found);
    let inner = found.iter().flatten().map(|x| start + size * x);
    let ends: Vec<f64> = [0.0].into_iter().chain(inner).chain([1.0]).collect();
    let pieces = ends.clone();
    let at = move |k: usize, x: f64| {
        if k.is_multiple_of(2) { [1.0, 0.0] } else { [0.0, (x - pieces[k]).min(pieces[k + 1] - x)] }
    };
    Edge { ends, at: Box::new(at) }
}

/// ∫ q_N u_N and the sum of the squared moved resultants on n equal segments.
fn both_parts(edge: &Edge, n: usize) -> [f64; 2] {
    let rule = [
        (0.5 - 0.6f64.sqrt() / 2.0, 5.0 / 18.0),
        (0.5, 4.0 / 9.0),
        (0.5 + 0.6f64.sqrt() / 2.0, 5.0 / 18.0),
    ];
    let h = 1.0 / n as f64;
    let (mut forces, mut open) = (vec![Force::default(); n], Vec::new());
    for (k, piece) in edge.ends.windows(2).enumerate() {
        let mut x = piece[0];
        while x < piece[1] {
            let segment = ((x / h * (1.0 + 1e-12)) as usize).min(n - 1);
            // Halves of a gap are pieces: its middle is a kink.
            let middle = 0.5 * (piece[0] + piece[1]);
            let next = if x < middle { middle } else { piece[1] };
            let mut end = next.min((segment + 1) as f64 * h);
            if end <= x {
                end = next;
            }
            for (place, weight) in rule {
                let (y, weight) = (x + place * (end - x), weight * (end - x));
                let ([pressure, gap], local) = ((edge.at)(k, y), y - segment as f64 * h);
                forces[segment].resultant += weight * pressure;
                forces[segment].moment += weight * pressure * local;
                if gap > 0.0 {
                    open.push((segment, local, weight * gap));
                }
            }
            x = end;
        }
    }
    let (density, moved) = signed_projection(h, &forces);
    let at = |&(segment, local, gap): &(usize, f64, f64)| {
        let [a, b]: [f64; 2] = density[segment];
        gap * (a + (b - a) * local / h)
    };
    [open.iter().map(at).sum(), moved.iter().map(|r| r * r).sum()]
}

/// Slope of the logarithm of the largest value over some places, over seven halvings, by least squares.
fn orders(edges: &[Edge]) -> [f64; 2] {
    let levels: Vec<i32> = (6..=13).collect();
    let largest = |k: i32, part: usize| {
        edges.iter().map(|edge| both_parts(edge, 1 << k)[part]).fold(0.0, f64::max).ln() / -LN_2
    };
    let mean = levels.iter().map(|&k| f64::from(k)).sum::<f64>() / levels.len() as f64;
    let square: f64 = levels.iter().map(|&k| (f64::from(k) - mean).powi(2)).sum();
    [0, 1].map(|part| {
        levels.iter().map(|&k| (f64::from(k) - mean) * largest(k, part)).sum::<f64>() / square
    })
}

#[test]
fn both_parts_have_the_order_of_the_theorem() {
    let places = [0.237, 0.312, 0.419, 0.523, 0.571, 0.618, 0.707, 0.779];
    for tau in [1.55, 1.65, 1.75, 1.85, 1.95] {
        let edges = places.map(|a| transition(a, tau));
        let [term, moved] = orders(&edges);
        assert!((term - (2.0 * tau - 2.0)).abs() < 0.05, "{tau}: {term}");
        assert!(moved > 2.0 * tau - 2.0 - 0.15, "{tau}: {moved}");
    }
    for (first, ratio, levels) in [(0.25, 0.25, 8), (0.2, 0.3, 9), (0.15, 0.35, 10), (0.1, 0.4, 11)]
    {
        // Indicators of the set are in H^ν for 2ν < 1 − ln 2/ln(1/ratio).
        let order = 2.0 + LN_2 / f64::ln(ratio);
        let edges =
            [0.03, 0.06, 0.11, 0.17].map(|start| fat_cantor(start, 0.8, first, ratio, levels));
        let [term, moved] = orders(&edges);
        assert!((term - order).abs() < 0.06, "{ratio}: {term} {order}");
        assert!(moved > order - 0.2, "{ratio}: {moved} {order}");
    }
}

/// ∫ σ M u − Σ ū ∫ σ = Σ (ū_i − ū_(i−1)) ∫ σ G_i, M u linear between the averages of neighbouring means, ∫ G_i = 0.
#[test]
fn averages_differ_from_means_by_oscillations() {
    let mut random = Random(4);
    for (cells, pressure, _) in random_edges().take(300) {
        let segments = pressure.len() / cells;
        let means: Vec<f64> = (0..segments).map(|_| random.next()).collect();
        let averages =
            (0..=segments).map(|i| 0.5 * (means[i.saturating_sub(1)] + means[i.min(segments - 1)]));
        let averages: Vec<f64> = averages.collect();
        let forces = forces(&pressure, cells);
        let linear =
            |i: usize, [a, b]: [f64; 2]| a * forces[i].resultant + (b - a) * forces[i].moment;
        let all: f64 = (0..segments).map(|i| linear(i, [averages[i], averages[i + 1]])).sum();
        let by_means: f64 = (0..segments).map(|i| linear(i, [means[i]; 2])).sum();
        let oscillation = |i: usize| {
            (means[i] - means[i - 1]) * (linear(i - 1, [0.0, 0.5]) + linear(i, [-0.5, 0.0]))
        };
        let rest: f64 = (1..segments).map(oscillation).sum();
        assert!(
            (all - by_means - rest).abs() < 1e-12 * (1.0 + all.abs()),
            "{all} {by_means} {rest}"
        );
    }
}
