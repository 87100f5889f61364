//! Section 2 on a strip: the energy errors computed from the edge alone, against whole fields and extended
//! precision.

use faer::linalg::solvers::Solve;
use faer::{Mat, Side};
use qd::Quad;
use signorini::cone::Cone;
use signorini::fem::Lame;
use signorini::problems::StripData;
use signorini::strip::{
    EdgeData, EdgeSolution, LateralCondition, Reference, StripKind, StripProblem,
};

/// The accuracy promised for every printed error, relative.
const PROMISED: f64 = 1e-8;
/// Fields are differences of values known to 1e-13 or so; errors are 1e-2 of them.
const FIELD: f64 = 1e-10;

fn scene(cells: usize, sides: LateralCondition) -> EdgeData {
    StripData::Transition { position: 0.37 }.data(1.75, cells, sides).unwrap()
}

/// a(u, v) on one layer of triangles over (bottom row, top row), two components per node.
fn layer(n: usize, lame: Lame) -> Mat<f64> {
    let mut matrix = Mat::<f64>::zeros(4 * n, 4 * n);
    for cell in 0..n {
        let right = (cell + 1) % n;
        let (bl, br, tr, tl) = (cell, right, n + right, n + cell);
        for (corners, gradients) in [
            ([bl, br, tr], [[-1.0, 0.0], [1.0, -1.0], [0.0, 1.0]]),
            ([bl, tr, tl], [[0.0, -1.0], [1.0, 0.0], [-1.0, 1.0f64]]),
        ] {
            for (a, ga) in corners.iter().zip(&gradients) {
                for (b, gb) in corners.iter().zip(&gradients) {
                    let product = ga[0] * gb[0] + ga[1] * gb[1];
                    for (i, j) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
                        let diagonal = if i == j { product } else { 0.0 };
                        let entry =
                            lame.lambda() * ga[i] * gb[j] + lame.mu() * (ga[j] * gb[i] + diagonal);
                        matrix[(2 * a + i, 2 * b + j)] += 0.5 * entry;
                    }
                }
            }
        }
    }
    matrix
}

/// A body of n × n squares between the edge and the clamped top, its rows eliminated from the top downwards.
struct Body {
    layer: Mat<f64>,
    /// how a row follows the one below it, from the top downwards: u_{j+1} = −(P + K_11)⁻¹ K_10 u_j
    steps: Vec<Mat<f64>>,
    /// the energy of the body on the edge
    edge: Mat<f64>,
}

impl Body {
    fn new(n: usize, lame: Lame) -> Self {
        let (layer, size) = (layer(n, lame), 2 * n);
        let block = |a: usize, b: usize| layer.submatrix(a * size, b * size, size, size).to_owned();
        let (mut edge, mut steps) = (block(0, 0), Vec::new());
        for _ in 0..n - 1 {
            let step = (&edge + block(1, 1)).llt(Side::Lower).unwrap().solve(&block(1, 0));
            edge = block(0, 0) - block(0, 1) * &step;
            steps.push(step);
        }
        Self { layer, steps, edge }
    }

    /// The discrete solution with the given edge row: rows from the edge to the clamped top.
    fn field(&self, edge: &[f64]) -> Vec<Vec<f64>> {
        let mut rows = vec![edge.to_vec()];
        for step in self.steps.iter().rev() {
            let below = rows.last().unwrap();
            let row = step * Mat::from_fn(edge.len(), 1, |i, _| below[i]);
            rows.push((0..edge.len()).map(|i| -row[(i, 0)]).collect());
        }
        rows.push(vec![0.0; edge.len()]);
        rows
    }

    /// (u_x, u_y) on the edge for given u_N without tangential force, by a dense solve.
    fn with_tangential(&self, normal: &[f64]) -> Vec<f64> {
        let n = normal.len();
        let part =
            |a: usize, b: usize| Mat::from_fn(n, n, |i, j| self.edge[(2 * i + a, 2 * j + b)]);
        let pull = part(0, 1) * Mat::from_fn(n, 1, |i, _| normal[i]);
        let x = part(0, 0).llt(Side::Lower).unwrap().solve(&pull);
        (0..n).flat_map(|i| [x[(i, 0)], -normal[i]]).collect()
    }
}

/// P1 interpolation to the grid of half the mesh size; squares cut from bottom left to top right.
fn refine(rows: &[Vec<f64>]) -> Vec<Vec<f64>> {
    let n = rows.len() - 1;
    let value = |i: usize, j: usize, k: usize| rows[j][2 * (i % n) + k];
    let between = |i: usize, j: usize, k: usize| {
        0.5 * (value(i / 2, j / 2, k) + value(i.div_ceil(2), j.div_ceil(2), k))
    };
    (0..=2 * n).map(|j| (0..4 * n).map(|m| between(m / 2, j, m % 2)).collect()).collect()
}

fn energy(layer: &Mat<f64>, rows: &[Vec<f64>]) -> f64 {
    rows.windows(2)
        .map(|pair| {
            let both = [pair[0].clone(), pair[1].clone()].concat();
            let u = Mat::from_fn(both.len(), 1, |i, _| both[i]);
            (u.transpose() * (layer * &u))[(0, 0)]
        })
        .sum()
}

/// |u − u_h|_a from the whole fields.
fn field_error(fine: &Mat<f64>, u: &[Vec<f64>], mut u_h: Vec<Vec<f64>>) -> f64 {
    while u_h.len() < u.len() {
        u_h = refine(&u_h);
    }
    let difference: Vec<Vec<f64>> =
        u.iter().zip(&u_h).map(|(a, b)| a.iter().zip(b).map(|(x, y)| x - y).collect()).collect();
    energy(fine, &difference).sqrt()
}

fn solve(problem: &StripProblem, n: usize, cone: Cone) -> EdgeSolution {
    problem.solve(n, cone).unwrap()
}

#[test]
fn elastic_error_is_that_of_the_fields() {
    let cells = 128;
    let lame = Lame::new(1.0, 1.0).unwrap();
    let scene = scene(cells, LateralCondition::Periodic);
    let problem = StripProblem::new(StripKind::Elastic, &scene, Reference::Nested, 2).unwrap();
    let fine = Body::new(cells, lame);
    let u = fine.field(&fine.with_tangential(scene.values()));
    for n in [8, 16, 32, 64] {
        let coarse = Body::new(n, lame);
        for cone in Cone::ALL {
            let values = solve(&problem, n, cone).values;
            let u_h = coarse.field(&coarse.with_tangential(&values));
            let expected = field_error(&fine.layer, &u, u_h);
            let got = problem.distance(n, &values).unwrap();
            let error = (got.value / expected - 1.0).abs();
            println!("elastic field {n} {cone}: {error:.1e}");
            assert!(error < FIELD, "{n} {cone}: {got} {expected}");
        }
    }
}

/// exp(2πi k/period), period a power of two, in double-double: products of half-angle roots.
fn root_of_unity(k: usize, period: usize) -> (Quad, Quad) {
    let (one, zero) = (Quad::from(1.0), Quad::from(0.0));
    let mut result = (one, zero);
    // exp(2πi/4), then square roots.
    let (mut c, mut s) = (zero, one);
    let (mut angle, half) = (period / 4, Quad::from(0.5));
    let times = |(a, b): (Quad, Quad), (x, y): (Quad, Quad)| (a * x - b * y, a * y + b * x);
    if k / (period / 2) % 2 == 1 {
        result = (-one, zero);
    }
    while angle > 0 {
        if k / angle % 2 == 1 {
            result = times(result, (c, s));
        }
        let root = ((one + c) * half).sqrt();
        s = s * half / root;
        c = root;
        angle /= 2;
    }
    result
}

/// exp(2πi k/period) for k < count, a power of two: each half of the table is the other one turned.
fn roots_of_unity(count: usize, period: usize) -> Vec<(Quad, Quad)> {
    let mut table = vec![(Quad::from(1.0), Quad::from(0.0))];
    while table.len() < count {
        let (c, s) = root_of_unity(table.len(), period);
        table.extend_from_within(..);
        let half = table.len() / 2;
        table[half..].iter_mut().for_each(|z| *z = (z.0 * c - z.1 * s, z.0 * s + z.1 * c));
    }
    table
}

/// Modes k = 0 ... n of the even extensions of two edge functions, in double-double: one transform of the
/// first plus i times the second, as the modes of even real functions are real.
fn cosine_modes(first: &[Quad], second: &[Quad]) -> (Vec<Quad>, Vec<Quad>) {
    let n = first.len() - 1;
    let period = 2 * n;
    let twiddles = roots_of_unity(n, period);
    let bits = period.trailing_zeros();
    let mut data: Vec<(Quad, Quad)> = (0..period)
        .map(|i| i.reverse_bits() >> (usize::BITS - bits))
        .map(|i| (first[i.min(period - i)], second[i.min(period - i)]))
        .collect();
    let mut half = 1;
    while half < period {
        for start in (0..period).step_by(2 * half) {
            for j in 0..half {
                let (c, s) = twiddles[j * (period / (2 * half))];
                let (a, (x, y)) = (data[start + j], data[start + j + half]);
                let b = (c * x + s * y, c * y - s * x);
                data[start + j] = (a.0 + b.0, a.1 + b.1);
                data[start + j + half] = (a.0 - b.0, a.1 - b.1);
            }
        }
        half *= 2;
    }
    data.truncate(n + 1);
    data.into_iter().unzip()
}

/// The scalar symbol with n = m at all modes, in double-double.
fn symbols(n: usize) -> Vec<Quad> {
    roots_of_unity(2 * n, 4 * n)
        .iter()
        .take(n + 1)
        .enumerate()
        .map(|(k, root)| symbol(k, n, root.1))
        .collect()
}

/// S at mode k from s = sin(πk/(2n)).
fn symbol(k: usize, n: usize, s: Quad) -> Quad {
    let (one, two) = (Quad::from(1.0), Quad::from(2.0));
    if k == 0 {
        return one / Quad::from(n as f64);
    }
    let root = (one + s * s).sqrt();
    // exp(2 m φ) = (s + √(1+s²))^{4m}
    let mut power = s + root;
    let mut exponent = 1;
    while exponent < 4 * n && power.0 < 1e60 {
        power = power * power;
        exponent *= 2;
    }
    let coth = if power.0 < 1e60 { one + two / (power - one) } else { one };
    two * s * root * coth
}

/// Σ'' S a b with the factor of the mode sum.
fn product(a: &[Quad], b: &[Quad], symbols: &[Quad]) -> Quad {
    let n = a.len() - 1;
    let mut sum = Quad::from(0.0);
    for k in 0..=n {
        let weight = if k == 0 || k == n { 0.5 } else { 1.0 };
        sum += Quad::from(weight) * symbols[k] * a[k] * b[k];
    }
    sum / Quad::from(2.0 * n as f64)
}

#[test]
fn scalar_error_holds_in_extended_precision() {
    extended(1 << 18, &[1 << 12, 1 << 16]);
    if crate::MANY {
        extended(1 << 20, &[1 << 18]);
    }
}

fn extended(cells: usize, levels: &[usize]) {
    let scene = scene(cells, LateralCondition::Natural);
    let problem = StripProblem::new(StripKind::Scalar, &scene, Reference::Nested, 2).unwrap();
    let long = |v: &[f64]| v.iter().map(|&x| Quad::from(x)).collect::<Vec<_>>();
    let fine_symbols: Vec<Quad> = symbols(cells);
    for (&n, cone) in levels.iter().flat_map(|n| Cone::ALL.map(|cone| (n, cone))) {
        let values = solve(&problem, n, cone).values;
        let coarse_symbols: Vec<Quad> = symbols(n);
        let g_h = cosine_modes(&long(&values), &vec![Quad::from(0.0); n + 1]).0;
        let ratio = cells / n;
        let prolonged: Vec<Quad> = (0..=cells)
            .map(|i| {
                let (cell, step) = ((i / ratio).min(n - 1), i - (i / ratio).min(n - 1) * ratio);
                let t = Quad::from(step as f64 / ratio as f64);
                Quad::from(values[cell]) * (Quad::from(1.0) - t) + Quad::from(values[cell + 1]) * t
            })
            .collect();
        let (g, p) = cosine_modes(&long(scene.values()), &prolonged);
        // a(u, P u_h) = ⟨A g, P g_h⟩ because u is discretely harmonic on the fine grid.
        let square = product(&g, &g, &fine_symbols)
            - Quad::from(2.0) * product(&g, &p, &fine_symbols)
            + product(&g_h, &g_h, &coarse_symbols);
        let expected = square.sqrt().0;
        let got = problem.distance(n, &values).unwrap().value;
        let error = (got / expected - 1.0).abs();
        println!("extended {n} {cone}: {error:.1e}");
        assert!(error < PROMISED, "{n} {cone}: {got} {expected}");
    }
}

#[test]
fn harmonic_reference_is_the_limit_of_nested_ones() {
    let coarse = scene(64, LateralCondition::Natural);
    let harmonic = StripProblem::new(StripKind::Scalar, &coarse, Reference::Harmonic, 2).unwrap();
    // The same piecewise linear edge shape on grids 2 ... 32 times as fine.
    let mut values = coarse.values().to_vec();
    let mut errors = Vec::new();
    let shape: Vec<f64> = (0..=16).map(|i| coarse.values()[4 * i] * 1.01).collect();
    for level in 1..=5 {
        let fine: Vec<f64> =
            (0..2 * values.len() - 1)
                .map(|i| {
                    if i % 2 == 0 {
                        values[i / 2]
                    } else {
                        0.5 * (values[i / 2] + values[i / 2 + 1])
                    }
                })
                .collect();
        values = fine;
        let forces = vec![0.0; values.len()];
        let scene =
            EdgeData::new(64 << level, LateralCondition::Natural, &values, &forces).unwrap();
        let nested = StripProblem::new(StripKind::Scalar, &scene, Reference::Nested, 2).unwrap();
        errors.push(nested.distance(16, &shape).unwrap().value.powi(2));
    }
    let limit = harmonic.distance(16, &shape).unwrap().value.powi(2);
    // The edge data are kinked: |u − u_fine|² behaves like h² |ln h|, so each halving gains a factor between
    // 3 and 4.5.
    let missing: Vec<f64> = errors.iter().map(|e| limit - e).collect();
    assert!(missing.iter().all(|&m| m > 0.0), "{missing:?}");
    for pair in missing.windows(2) {
        assert!((3.0..4.5).contains(&(pair[0] / pair[1])), "{missing:?}");
    }
    assert!(missing[4] < 1e-3 * limit);
}
