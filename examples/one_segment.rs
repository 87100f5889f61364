//! One contact segment through the whole argument: that of the block in which the contact set ends,
//! and every bound of its term.
//!
//! The block: unit square, plane strain, λ = μ = 1, fixed at y = 1, load (0, −cos πx), u_N ≤ 0 at
//! the nodes of y = 0. Its P1 solution on n k × n k squares, exact by an active set, stands for u;
//! a segment T of length h = 1/n has k cells. On a cell u_N is linear and σ_N constant, half of
//! each nodal force to either side. term = ∫ σ_N I u_N over T, I u_N: the chord of u_N over T.
//!
//! With ν = τ − 3/2, q = 1/(2 − τ), |·|_ν and ‖·‖_ν on T, r h the distance of the further end of T
//! from the contact set: depth × force = max |I u_N| ∫ |σ_N|;  error × pressure = ‖I u_N − u_N‖₀
//! ‖σ_N‖₀; first(θ) = C_q h θ^(1−1/q) ‖σ_N‖_ν ‖u_N'‖_ν, θ ≥ r, (3.9);  second(θ) = C_I γ_θ h^(2τ−2)
//! |σ_N|_ν |u_N'|_ν, θ ≤ r, (3.14); half: ½ h^(2τ−2) |σ_N|_ν |u_N'|_ν; κ in place of ½: the best
//! constant for one gap at an end. C_q of ‖v‖_(L^q) ≤ C_q ‖v‖_ν, C_I of Lemma 6.1, γ_θ of Lemma
//! 5.2. ±: the change when k is halved.
//!
//! Refuted if more segments carry a term (1e-12 of the sum) than the contact set has ends, or if a
//! bound is below the term.
use example_report::prelude::*;
use fractional_sobolev::{
    Constraint, Domain, ErrorNorm, Gram, Mesh, embedding_bound, gamma, interpolation_constant,
};
use signorini::cone::Cone;
use signorini::contact::Solver;
use signorini::problems::TestProblem;
use signorini::proof::consistency_constant;
use std::fmt::Write as _;

example! { seconds "Sections 3 and 4, one segment",
    "the term of the segment in which contact ends, below all its bounds";
    /// segments of the contact edge
    n: usize = "16" in "[4, 24]",
    /// regularity τ in the bounds
    tau: f64 = "1.75" in "(1.5, 2)" slider "1.55 to 1.95",
}

/// Cells of a segment.
const CELLS: usize = 32;

/// The segment with the largest term, cut into k cells.
struct Segment {
    h: f64,
    /// u_N at the k + 1 nodes.
    u: Vec<f64>,
    /// −σ_N on the k cells.
    pressure: Vec<f64>,
    /// Number of the segment, from the left; how many segments carry a term; this term over the sum
    /// of all.
    place: usize,
    carry: usize,
    term: f64,
}

/// The term of every segment, and the segment with the largest one.
fn find(n: usize, k: usize) -> Result<Segment> {
    let solution = TestProblem::Block.problem(n * k)?.solve(Cone::Nodal, Solver::ActiveSet)?;
    let (u, force) = (&solution.normal_displacement, &solution.multiplier);
    let mut terms = Vec::new();
    for a in (0..n).map(|s| s * k) {
        let chord = |i: usize| u[a] + (i - a) as f64 / k as f64 * (u[a + k] - u[a]); // I u_N
        terms.push((a + 1..a + k).map(|i| -force[i] * chord(i)).sum::<f64>()); // 0 at the ends of T
    }
    let largest = terms.iter().copied().fold(0.0, f64::max);
    let place = terms.iter().position(|&term| term == largest).unwrap_or(0);
    let carry = terms.iter().filter(|&&term| term > 1e-12 * largest).count();
    let (a, cell) = (place * k, 1.0 / (n * k) as f64);
    let share = |i: usize| force[i] / cell * if i == 0 || i == n * k { 1.0 } else { 0.5 };
    let pressure = (a..a + k).map(|i| share(i) + share(i + 1)).collect();
    Ok(Segment {
        h: 1.0 / n as f64,
        u: u[a..=a + k].to_vec(),
        pressure,
        place,
        carry,
        term: largest,
    })
}

impl Segment {
    fn cells(&self) -> usize {
        self.pressure.len()
    }

    /// I u_N at place t of T, 0 ≤ t ≤ 1.
    fn chord(&self, t: f64) -> f64 {
        (1.0 - t) * self.u[0] + t * self.u[self.cells()]
    }

    /// The distance of the further end of T from the contact set, over h.
    fn r(&self) -> f64 {
        let touching: Vec<usize> = (0..=self.cells()).filter(|&i| self.u[i] >= 0.0).collect();
        let [Some(first), Some(last)] = [touching.first(), touching.last()] else { return 1.0 };
        (*first).max(self.cells() - last) as f64 / self.cells() as f64
    }

    /// All bounds of the term, in the order of the pages.
    fn bounds(&self, tau: f64) -> Result<Vec<(&'static str, f64)>> {
        let (k, h, nu, q) = (self.cells(), self.h, Order::half_plus(tau - 2.0)?, 1.0 / (2.0 - tau));
        let cell = h / k as f64;
        let slope: Vec<f64> = self.u.windows(2).map(|pair| (pair[1] - pair[0]) / cell).collect();
        let gram = Gram::constants(&Mesh::uniform(k, h)?, nu, Tolerance::balanced())?;
        let seminorm = |v: &[f64]| -> Result<f64> {
            Ok(gram.apply(v)?.iter().zip(v).map(|(y, x)| x * y).sum::<f64>().max(0.0).sqrt())
        };
        let norm = |v: &[f64]| (v.iter().map(|v| v * v).sum::<f64>() * cell).sqrt();
        let both = seminorm(&self.pressure)? * seminorm(&slope)?;
        let full = norm(&self.pressure).hypot(seminorm(&self.pressure)?)
            * norm(&slope).hypot(seminorm(&slope)?);
        // ‖I u_N − u_N‖₀: linear on each cell, e and f at its ends.
        let error = |i: usize| self.chord(i as f64 / k as f64) - self.u[i];
        let square = |e: f64, f: f64| (e * e + e * f + f * f) / 3.0;
        let interpolation =
            ((0..k).map(|i| square(error(i), error(i + 1))).sum::<f64>() * cell).sqrt();
        let force: f64 = self.pressure.iter().sum::<f64>() * cell;
        let depth = self.u[0].abs().max(self.u[k].abs());
        let printed = h.powf(2.0 * tau - 3.0);
        let above = |constant: Estimate| constant.value + constant.error;
        let c_i =
            above(interpolation_constant(Domain::Interval(1.0), ErrorNorm::L2, nu, 1e-8)?.constant);
        let first = |theta: f64| -> Result<f64> {
            Ok(embedding_bound(nu, q)? * h * theta.powf(1.0 - 1.0 / q) * full)
        };
        let second = |theta: f64| -> Result<f64> {
            let gamma = above(gamma(nu, Constraint::mean_zero_on(0.0..theta), 1e-6)?.constant);
            Ok(c_i * gamma * h.powf(2.0 * tau - 2.0) * both)
        };
        let kappa = above(consistency_constant(nu, 1e-9)?.value);
        Ok(vec![
            ("depth × force", depth * force),
            ("error × pressure", interpolation * norm(&self.pressure)),
            ("(3.9), θ = r", first(self.r())?),
            ("(3.14), θ = r", second(self.r())?),
            ("(3.14), θ printed", second(printed.min(self.r()))?),
            ("one half", 0.5 * h.powf(2.0 * tau - 2.0) * both),
            ("κ", kappa * h.powf(2.0 * tau - 2.0) * both),
        ])
    }
}

fn run(options: &Options, out: &mut Report) -> Result<()> {
    let (n, tau) = (options.n, options.tau);
    let [fine, coarse] = [find(n, CELLS)?, find(n, CELLS / 2)?];
    out.column("bound", "bound", "h^(2τ−2) |σ_N|_ν |u_N'|_ν times ½ and κ; ν = τ − 3/2");
    out.column("times", "bound/term", "±: half as many cells");
    out.check("segments that carry the term").at_most(fine.carry, 1.0, "ends of the contact set");
    let keys = ["rectangle", "product", "first", "second", "second.printed", "half", "kappa"];
    let mut bars = vec![("the term", 1.0)];
    for (key, ((bound, value), (_, other))) in
        keys.iter().zip(fine.bounds(tau)?.iter().zip(coarse.bounds(tau)?))
    {
        let times =
            Measured::new(value / fine.term, (value / fine.term - other / coarse.term).abs());
        out.row(cells! { bound: *bound => times });
        out.check("term/bound").at_most(times.recip(), 1.0, "the proofs of Sections 3 and 4");
        out.note(format!("times.{key}"), times.value);
        bars.push((*bound, times.value));
    }
    out.note("term", fine.term);
    out.note("r", fine.r());
    out.note("theta", fine.h.powf(2.0 * tau - 3.0));
    out.note("place", (fine.place + 1) as f64);
    for page in 1..=8 {
        out.picture(&format!("one_segment_{page}"), drawing(&fine, &bars, page));
    }
    Ok(())
}

const BLUE: &str = "#0072b2";
const RED: &str = "#d55e00";
const GREEN: &str = "#009e73";

/// The drawing of one page of the course: T from x = 60 to x = 440, above it u_N, below it σ_N and
/// the product σ_N I u_N, at the right the bounds over the term on a logarithmic scale. Each page
/// adds to the one before.
fn drawing(segment: &Segment, bars: &[(&str, f64)], page: usize) -> String {
    let k = segment.cells();
    let x = |t: f64| 60.0 + 380.0 * t;
    let depth = segment.u.iter().fold(0.0, |m: f64, u| m.max(-u));
    let most = segment.pressure.iter().fold(0.0, |m: f64, p| m.max(*p));
    let chord = |i: usize| segment.chord(i as f64 / k as f64);
    let middle = |i: usize| segment.chord((i as f64 + 0.5) / k as f64);
    let products: Vec<f64> = (0..k).map(|i| -segment.pressure[i] * middle(i)).collect();
    let peak = products.iter().fold(f64::MIN_POSITIVE, |m: f64, p| m.max(*p));
    let (top, low, area) = (70.0, 215.0, 355.0); // u = 0, σ_N = 0, and the base of the product
    let down = |value: f64, largest: f64| 80.0 * value.abs() / largest;
    let mut svg = String::from(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" viewBox=\"0 0 640 380\" \
         width=\"640\" height=\"380\" \
         font-family=\"sans-serif\" font-size=\"15\">\n\
         <style>svg:root{color:#222;background:#fff}\
         @media(prefers-color-scheme:dark){svg:root{color:#ddd;background:#1b1b1b}}</style>\n",
    );
    let line = |svg: &mut String, points: &[(f64, f64)], style: &str| {
        let points: Vec<String> = points.iter().map(|(x, y)| format!("{x:.1},{y:.1}")).collect();
        let _ = writeln!(svg, "<polyline points=\"{}\" fill=\"none\" {style}/>", points.join(" "));
    };
    let filled = |svg: &mut String, points: &[(f64, f64)], colour: &str, opacity: f64| {
        let points: Vec<String> = points.iter().map(|(x, y)| format!("{x:.1},{y:.1}")).collect();
        let _ = writeln!(
            svg,
            "<polygon points=\"{}\" fill=\"{colour}\" fill-opacity=\"{opacity}\"/>",
            points.join(" ")
        );
    };
    let text = |svg: &mut String, (x, y): (f64, f64), anchor: &str, colour: &str, words: &str| {
        let _ = writeln!(
            svg,
            "<text x=\"{x:.1}\" y=\"{y:.1}\" text-anchor=\"{anchor}\" \
             fill=\"{colour}\">{words}</text>"
        );
    };
    let sub = "<tspan dy=\"4\" font-size=\"75%\">N</tspan>";
    let end = 1.0 - segment.r();
    let thin = "stroke=\"currentColor\" stroke-width=\"1.2\" opacity=\"0.6\"";

    // Zones of Lemma 5.2, and of Figure 3.2 with θ = r.
    if page >= 6 {
        filled(
            &mut svg,
            &[
                (x(end), top - 22.0),
                (x(1.0), top - 22.0),
                (x(1.0), low + 82.0),
                (x(end), low + 82.0),
            ],
            RED,
            0.10,
        );
        text(
            &mut svg,
            (0.5 * (x(end) + x(1.0)), low + 60.0),
            "middle",
            RED,
            "no pressure: the zone, length rh",
        );
    }
    let u: Vec<_> =
        (0..=k).map(|i| (x(i as f64 / k as f64), top + down(segment.u[i], depth))).collect();
    let i_u: Vec<_> =
        (0..=k).map(|i| (x(i as f64 / k as f64), top + down(chord(i), depth))).collect();
    if page >= 4 {
        let between: Vec<_> = u.iter().copied().chain(i_u.iter().rev().copied()).collect();
        filled(&mut svg, &between, GREEN, 0.25);
        text(&mut svg, (x(0.42), top + 66.0), "middle", GREEN, "error of Iu");
    }
    line(&mut svg, &[(x(0.0), top), (x(1.0), top)], thin);
    line(&mut svg, &u, &format!("stroke=\"{BLUE}\" stroke-width=\"2.5\""));
    text(&mut svg, (50.0, top + 5.0), "end", "currentColor", "0");
    text(&mut svg, (x(1.0) - 4.0, top + 100.0), "end", BLUE, &format!("u{sub}"));
    for t in [0.0, 1.0] {
        line(
            &mut svg,
            &[(x(t), top - 6.0), (x(t), top + 6.0)],
            "stroke=\"currentColor\" stroke-width=\"1.5\"",
        );
    }
    let _ =
        writeln!(svg, "<circle cx=\"{:.1}\" cy=\"{top}\" r=\"4\" fill=\"currentColor\"/>", x(end));
    text(&mut svg, (x(0.5 * end), top - 10.0), "middle", "currentColor", "contact");
    text(&mut svg, (x(0.5 + 0.5 * end), top - 10.0), "middle", "currentColor", "gap");
    text(
        &mut svg,
        (x(0.0), 30.0),
        "start",
        "currentColor",
        &format!("segment T, number {} from the left", segment.place + 1),
    );
    if page >= 2 {
        let stairs: Vec<_> = (0..k)
            .flat_map(|i| {
                [i, i + 1].map(|j| (x(j as f64 / k as f64), low + down(segment.pressure[i], most)))
            })
            .collect();
        line(&mut svg, &[(x(0.0), low), (x(1.0), low)], thin);
        line(&mut svg, &stairs, &format!("stroke=\"{RED}\" stroke-width=\"2.5\""));
        text(&mut svg, (50.0, low + 5.0), "end", "currentColor", "0");
        text(&mut svg, (x(0.0) + 8.0, low + 28.0), "start", RED, &format!("σ{sub}"));
    }
    if page >= 3 {
        line(
            &mut svg,
            &i_u,
            &format!("stroke=\"{BLUE}\" stroke-width=\"2\" stroke-dasharray=\"6 4\""),
        );
        text(&mut svg, (x(0.10), top + 34.0), "middle", BLUE, "Iu");
        let mut shape = vec![(x(0.0), area)];
        shape.extend(
            (0..k).map(|i| (x((i as f64 + 0.5) / k as f64), area - 45.0 * products[i] / peak)),
        );
        shape.push((x(1.0), area));
        filled(&mut svg, &shape, "currentColor", 0.45);
        line(&mut svg, &[(x(0.0), area), (x(1.0), area)], thin);
        text(
            &mut svg,
            (x(end) + 12.0, area - 14.0),
            "start",
            "currentColor",
            &format!("area of σ{sub}<tspan dy=\"-4\"> </tspan>Iu: the term"),
        );
    }
    if page >= 5 {
        for [from, to] in [[0.0, segment.r()], [1.0, end]] {
            let y = top + if from == 0.0 { 112.0 } else { 124.0 };
            line(
                &mut svg,
                &[(x(from), y), (x(to), y)],
                &format!("stroke=\"{GREEN}\" stroke-width=\"3\""),
            );
        }
        text(&mut svg, (x(0.0) - 6.0, top + 122.0), "end", GREEN, "rh");
    }
    // The bars that the page has reached.
    let shown: &[usize] = match page {
        0..=2 => &[],
        3 => &[0],
        4 => &[0, 2],
        5 => &[0, 2, 1, 3],
        6 => &[0, 2, 1, 3, 4],
        7 => &[0, 2, 1, 3, 4, 5],
        _ => &[0, 2, 1, 3, 4, 5, 6, 7],
    };
    let largest = bars.iter().fold(1.0, |m: f64, bar| m.max(bar.1)).ln();
    if !shown.is_empty() {
        text(&mut svg, (465.0, 30.0), "start", "currentColor", "in units of the term");
    }
    for (row, &which) in shown.iter().enumerate() {
        let (name, times) = bars[which];
        let y = 50.0 + 40.0 * row as f64;
        let width = 8.0 + 140.0 * times.ln() / largest;
        let colour = if which == 0 {
            "currentColor"
        } else if which >= 6 {
            BLUE
        } else {
            GREEN
        };
        text(&mut svg, (465.0, y), "start", colour, name);
        filled(
            &mut svg,
            &[
                (465.0, y + 5.0),
                (465.0 + width, y + 5.0),
                (465.0 + width, y + 17.0),
                (465.0, y + 17.0),
            ],
            colour,
            0.6,
        );
        let written = if times < 10.0 { format!("{times:.1}") } else { format!("{times:.0}") };
        text(&mut svg, (630.0, y), "end", colour, &written);
    }
    svg + "</svg>\n"
}
