//! Remark 7 as a theorem: of all sets of one measure the interval at an end has the largest constant.
//!
//! For a set E in (0, 1) of measure θ let γ(E) be the best constant in ‖u‖₀ ≤ γ |u|_ν for u in H^ν(0, 1), 0 < ν < 1, with
//! mean zero on E, |u|²_ν = ∬ (u(x) − u(y))² / |x − y|^(1+2ν) dx dy; or for u that vanishes on E. Then γ(E) ≤ γ((0, θ)).
//!
//! Proof (page `remark_7_rearrangement`): the decreasing rearrangement v* takes every range of values on a set of the same
//! measure as v. So ‖v*‖₀ = ‖v‖₀, the mean of v* over (0, θ) is the largest that v has over any set of measure θ, and
//! |v*|_ν ≤ |v|_ν. The last is a lemma on numbers f₁, ..., f_n: sorting lowers Σ (f_i − f_j)² over |i − j| ≤ k, for every k.
//!
//! Refuted if a random sequence, sorted, has a larger sum; if a random function, sorted, has a larger seminorm; or if a
//! random union of one to five intervals has a larger constant than the interval (0, θ) of the same measure.
//!
//! `cargo run --release --example remark_7_rearrangement -- --unions 1000`

use example_report::figures::{Axis, Chart, Series};
use example_report::prelude::*;
use fractional_sobolev::{Constraint, Function, Mesh, Zones, gamma};

example! { seconds "Remark 7, sharp", "γ(E) ≤ γ((0, θ)) for every E of measure θ:  |v*|_ν ≤ |v|_ν for v sorted";
    /// random sequences, and random functions of each kind
    functions: usize = "1000" in "[1, 1000000]",
    /// random unions of intervals
    unions: usize = "60" in "[1, 100000]",
}

/// Uniform in [0, 1), the same on every machine: SplitMix64.
struct Random(u64);

impl Random {
    fn uniform(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64
    }

    /// Positive numbers that differ by a factor of 30 at most, their sum given.
    fn shares(&mut self, count: usize, sum: f64) -> Vec<f64> {
        let raw: Vec<f64> = (0..count).map(|_| 30f64.powf(self.uniform())).collect();
        raw.iter().map(|share| share / raw.iter().sum::<f64>() * sum).collect()
    }
}

/// Σ (f_i − f_j)² over |i − j| ≤ k.
pub fn near_differences(f: &[f64], k: usize) -> f64 {
    let row = |i: usize| f[i + 1..].iter().take(k).map(|b| (f[i] - b).powi(2)).sum::<f64>();
    (0..f.len()).map(row).sum()
}

/// |v|²_ν for v = f_i on the i-th of n equal cells, ν < 1/2: n^(2ν−1) Σ ω(|i − j|) (f_i − f_j)² over i ≠ j, where ω(d) is
/// ∬ |d + x − y|^(−1−2ν) over two unit cells, a second difference of d^(1−2ν) / (−2ν (1 − 2ν)).
fn seminorm_squared(f: &[f64], nu: f64) -> f64 {
    let (n, p) = (f.len(), 1.0 - 2.0 * nu);
    let weight = |d: f64| ((d + 1.0).powf(p) - 2.0 * d.powf(p) + (d - 1.0).powf(p)) / (p * (p - 1.0));
    let pairs = (0..n).flat_map(|i| (0..i).map(move |j| (i, j)));
    2.0 * (n as f64).powf(-p)
        * pairs.map(|(i, j)| weight((i - j) as f64) * (f[i] - f[j]).powi(2)).sum::<f64>()
}

/// v* of a continuous piecewise linear v: linear between its values y, each at the measure of the set where v > y.
fn rearranged(mesh: &Mesh, values: &[f64]) -> Result<Function<'static>> {
    let mut levels = values.to_vec();
    levels.sort_by(|a, b| b.total_cmp(a));
    let above = |(pair, h): (&[f64], &f64), y: f64| {
        let (low, high) = (pair[0].min(pair[1]), pair[0].max(pair[1]));
        h * ((high - y) / (high - low)).clamp(0.0, 1.0)
    };
    let measure = |&y: &f64| values.windows(2).zip(mesh.lengths()).map(|part| above(part, y)).sum::<f64>();
    let nodes: Vec<f64> = levels.iter().map(measure).collect();
    let lengths = nodes.windows(2).map(|pair| pair[1] - pair[0]).collect();
    Ok(Function::linears(&Mesh::from_lengths(lengths)?, &levels)?)
}

/// A row: how many quotients, the largest and the mean.
fn report(out: &mut Report, what: &str, quotients: &[Measured]) {
    let tried = quotients.len();
    let mean = quotients.iter().map(|q| q.value).sum::<f64>() / tried.max(1) as f64;
    out.row(cells! { what => tried, largest: largest(quotients.iter().copied()).map(|q| q.value), mean });
}

fn run(options: &Options, out: &mut Report) -> Result<()> {
    out.column("what", "quotient", "sorted over given, and γ(E) over γ((0, θ))");
    let mut random = Random(7);
    let (mut sequences, mut steps, mut linears) = (Vec::new(), Vec::new(), Vec::new());
    for _ in 0..options.functions {
        // Whole numbers: the sums are exact.
        let f: Vec<f64> =
            (0..2 + (39.0 * random.uniform()) as usize).map(|_| (99.0 * random.uniform()).floor()).collect();
        let mut sorted = f.clone();
        sorted.sort_by(|a, b| b.total_cmp(a));
        for k in 1..f.len() {
            let (less, more) = (near_differences(&sorted, k), near_differences(&f, k));
            out.check("sequences: sorted − given sum").at_most(less - more, 0.0, "lemma");
            sequences.push(Measured::from(if more > 0.0 { less / more } else { 1.0 }));
        }
        // Steps, and the rearrangement by sorting; the library's is compared on the same function.
        let nu = 0.01 + 0.48 * random.uniform();
        let share = (seminorm_squared(&sorted, nu) / seminorm_squared(&f, nu)).sqrt();
        if share.is_finite() {
            let on = Mesh::uniform(f.len(), 1.0)?;
            let [given, less] = [&f, &sorted].map(|f| Function::piecewise(&on, 0, f)?.seminorm(nu, 1e-8));
            let by_library = Measured::from(less?) / given?;
            out.check("steps: library over formula").near(by_library / share, 1.0, 1e-7, "ω(d)");
            steps.push(Measured::from(share));
        }
        // Linear between random values on a random mesh; seminorms are closed forms on pairs of elements.
        let nu = 0.01 + 0.98 * random.uniform();
        let count = 2 + (10.0 * random.uniform()) as usize;
        let values: Vec<f64> = (0..=count).map(|_| random.uniform()).collect();
        let mesh = Mesh::from_lengths(random.shares(count, 1.0))?;
        let less = Measured::from(rearranged(&mesh, &values)?.seminorm(nu, 1e-8)?);
        linears.push(less / Function::linears(&mesh, &values)?.seminorm(nu, 1e-8)?);
    }
    for (what, shares) in [("steps", &steps), ("piecewise linear", &linears)] {
        for &share in shares {
            out.check("functions: |v*|_ν/|v|_ν").at_most(share, 1.0 + 1e-8, "theorem");
        }
        report(out, &format!("functions, {what}"), shares);
    }
    report(out, "sequences, every k", &sequences);
    let mut found = vec![Vec::new(); 5];
    for number in 0..options.unions {
        let (nu, theta) = (0.001 + 0.998 * random.uniform(), 0.9 * 1e-12f64.powf(random.uniform()));
        let count = 1 + (5.0 * random.uniform()) as usize;
        let (intervals, mut gaps) = (random.shares(count, theta), random.shares(count + 1, 1.0 - theta));
        if number % 4 == 0 && count > 1 {
            gaps[count] += std::mem::take(&mut gaps[0]); // from the left end on
        }
        let lengths: Vec<f64> =
            gaps.iter().zip(&intervals).flat_map(|(&gap, &interval)| [gap, interval]).collect();
        let (union, end) = (Zones::from_lengths(&lengths)?, Zones::from_start_and_length(0.0, theta)?);
        // γ² is the largest eigenvalue of (‖·‖₀², |·|²_ν) on polynomials on elements that shrink geometrically to all ends
        // of all intervals; its error is the change to a space of another shape.
        let solved = |zones: Zones| {
            let zone = if number % 2 == 0 {
                Constraint::mean_zero_on(zones)
            } else {
                Constraint::vanishing_on(zones)
            };
            gamma(nu, zone, 1e-3).map(|found| Measured::from(found.constant))
        };
        let Ok(constant) = solved(union) else { continue }; // rounding forbids three digits
        let over = constant / solved(end)?;
        out.check("unions: γ(E)/γ((0, θ))").at_most(over, 1.0 + 2e-3, "theorem");
        found[count - 1].push((theta, over));
    }
    for (k, unions) in found.iter().enumerate() {
        report(
            out,
            &format!("E of {} interval{}", k + 1, if k == 0 { "" } else { "s" }),
            &unions.iter().map(|union| union.1).collect::<Vec<_>>(),
        );
    }
    let computed = found.iter().map(Vec::len).sum::<usize>() as f64;
    out.check("unions with three digits").at_least(computed / options.unions as f64, 0.9, "rounding");
    out.proof("γ(E) ≤ γ((0, θ)), E measurable", "remark_7_rearrangement");
    let axes = (Axis::logarithmic("θ, measure of the zone"), Axis::linear("constant over that of (0, θ)"));
    let mut chart = Chart::new("Random zones of one to five intervals", axes.0, axes.1);
    for (k, unions) in found.iter().enumerate() {
        let points = unions.iter().map(|(theta, over)| (*theta, over.value)).collect();
        chart = chart.with(Series::points(format!("intervals: {}", k + 1), points));
    }
    out.chart("remark_7_unions", chart);
    Ok(())
}
