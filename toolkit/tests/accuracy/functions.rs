//! Random functions and loads, all norms, tolerances 1e-2 ... 1e-12: every answer lies within its own error of a
//! reference (a closed form, or another method), every refusal carries a value that encloses it, and every call
//! keeps its limit of work.

use crate::common::SplitMix;
use crate::hard::cases;
use crate::hard::references;
use fractional_sobolev::{
    Curve, DualOf, Error, Estimate, Function, Mesh, Order, Position, Result, Tolerance, Work, closed_forms,
    gauss_legendre,
};
use std::f64::consts::PI;

/// Cases of each family.
const CASES: usize = 20;
/// Evaluations of one call at most.
const WORK: u64 = 4 * Tolerance::WORK;
/// Cases of which the largest part may lie below the smallest number.
const DEEP: &str = "deep";
/// Rounding of the references.
const ROUNDING: f64 = 1e-13;

/// What was asked of what, what came out, and the reference.
struct Case {
    what: String,
    tolerance: Tolerance,
    found: Result<Estimate>,
    reference: Estimate,
}

fn case(
    what: String,
    tolerance: Tolerance,
    reference: Estimate,
    compute: impl FnOnce(Tolerance) -> Result<Estimate>,
) -> Case {
    Case { what, tolerance, found: compute(tolerance), reference }
}

fn exactly(value: f64) -> Estimate {
    Estimate::new(value, ROUNDING * value, Work::default()).unwrap()
}

/// Where there is no second method only the work is judged.
fn nothing_known() -> Estimate {
    Estimate { value: 0.0, error: f64::MAX, work: Work::default() }
}

fn tolerance(random: &mut SplitMix) -> Tolerance {
    Tolerance::new(10f64.powf(random.between(-12.0, -2.0))).unwrap()
}

fn reference() -> Tolerance {
    Tolerance::new(1e-13).unwrap()
}

fn order(random: &mut SplitMix, high: f64) -> Order {
    if high > 0.5 && random.below(4) == 0 {
        return Order::HALF;
    }
    Order::new(random.between(0.02, high)).unwrap()
}

/// Lengths of equal, unequal, graded elements.
fn partition(random: &mut SplitMix, count: usize) -> Mesh {
    match random.below(4) {
        0 => Mesh::uniform(count, 1.0).unwrap(),
        1 => Mesh::algebraic(count, random.between(1.5, 4.0), 1.0).unwrap(),
        2 => {
            let half = Mesh::algebraic(count.div_ceil(2), random.between(1.5, 3.0), 0.5).unwrap();
            let both = half.lengths().iter().chain(half.lengths().iter().rev());
            Mesh::from_lengths(both.copied().collect()).unwrap()
        }
        _ => Mesh::from_lengths((0..count).map(|_| random.between(0.1, 1.0)).collect()).unwrap(),
    }
}

/// Up to 10^{2...5} elements, evenly in the exponent; the largest only when many cases are asked for.
fn count(random: &mut SplitMix, decades: f64) -> usize {
    let most = if cases(10) > 10 { decades } else { decades.min(3.5) };
    10f64.powf(random.between(0.5, most)) as usize
}

/// x^a on (c, c + L), times s.
fn power(random: &mut SplitMix) -> Case {
    let (order, asked) = (order(random, 0.97), tolerance(random));
    let a = order.offset() + 10f64.powf(random.between(-2.0, 0.4));
    let (start, length) = (random.between(-3.0, 3.0), 10f64.powf(random.between(-2.0, 2.0)));
    let exact = closed_forms::power_seminorm_squared(a, order).unwrap().value.sqrt()
        * length.powf(a - order.offset());
    let end = start + length;
    let kind = random.below(2);
    let u = if kind == 0 {
        Function::from_positions(&[start, end], |at| at.distance_to(0).powf(a)).unwrap()
    } else {
        Function::from_fn(&[start, end], |x: f64| (x - start).abs().powf(a)).unwrap()
    };
    let reference = Estimate { error: 1e-12 * exact, ..exactly(exact) };
    case(format!("x^{a} on ({start}, {end}), {order}, {kind}"), asked, reference, |asked| {
        u.seminorm(order, asked)
    })
}

/// |ln x|^α at ν = 1/2.
fn logarithm(random: &mut SplitMix) -> Case {
    let (alpha, asked) = (random.between(0.05, 0.47), tolerance(random));
    let exact = exactly(closed_forms::log_power_seminorm_squared(alpha).unwrap().value.sqrt());
    let log = Function::from_log_distances(&[0.0, 1.0], move |at| match at.anchor() {
        0 => (-at.log_distance()).powf(alpha),
        // The distance to 1 is −ln x; at small α its power is far from 0 where it underflows.
        _ if at.log_distance() < -46.0 => (alpha * at.log_distance()).exp(),
        _ => (-at.offset().ln_1p()).powf(alpha),
    });
    let log = log.unwrap();
    case(format!("log:{alpha}"), asked, exact, |asked| log.seminorm(Order::HALF, asked))
}

/// ∥x^a |ln x|^α∥_q = (Γ(αq + 1)/(aq + 1)^{αq+1})^{1/q} for αq whole; q = 1, 2, 4.
fn lebesgue(random: &mut SplitMix) -> Case {
    let q = [1.0, 2.0, 4.0][random.below(3)];
    let whole = random.below(7);
    let (alpha, asked) = (whole as f64 / q, tolerance(random));
    let a = (10f64.powf(random.between(-1.9, 0.5)) - 1.0) / q;
    let factorial: f64 = (1..=whole).map(|k| k as f64).product();
    let exact = (factorial / (a * q + 1.0).powi(whole as i32 + 1)).powf(1.0 / q);
    let by_log = random.below(2) == 0;
    let f = move |at: Position| match at.anchor() {
        0 => (a * at.log_distance()).exp() * (-at.log_distance()).powf(alpha),
        _ => (1.0 + at.offset()).powf(a) * (-at.offset().ln_1p()).powf(alpha),
    };
    let u = if by_log {
        Function::from_log_distances(&[0.0, 1.0], f).unwrap()
    } else {
        Function::from_positions(&[0.0, 1.0], f).unwrap()
    };
    let reference = Estimate { error: 1e-12 * exact, ..exactly(exact) };
    let name = if a * q < -0.9 { DEEP } else { "" };
    case(format!("{name} x^{a} |ln x|^{alpha} in L^{q}, {by_log}"), asked, reference, |asked| u.lp(q, asked))
}

/// Powers at both sides of random breaks, a logarithm, a smooth part; against the norm of u − 0, which cuts
/// the interval into cells and patches.
fn closure(random: &mut SplitMix) -> Case {
    let (order, asked) = (order(random, 0.9), tolerance(random));
    let count = 1 + random.below(3);
    let mut breaks: Vec<f64> = vec![0.0, 1.0];
    breaks.extend((0..count).map(|k| (k as f64 + random.between(0.2, 0.8)) / count as f64));
    breaks.sort_by(f64::total_cmp);
    let logs = random.below(3) == 0 && order.value() < 0.45;
    let terms: Vec<[f64; 3]> = (0..breaks.len())
        .map(|_| {
            let a = order.offset().max(0.0) + random.between(0.05, 1.5);
            [random.between(-1.0, 1.0), a, if logs { random.between(-1.0, 1.0) } else { 0.0 }]
        })
        .collect();
    let [wave, slope] = [random.between(0.0, 6.0), random.between(-1.0, 1.0)];
    let f = |at: Position| {
        let parts = terms.iter().enumerate().map(|(k, [c, a, log])| {
            let logarithm = if *log == 0.0 { 0.0 } else { log * at.log_distance_to(k) };
            c * at.distance_to(k).powf(*a) + logarithm
        });
        parts.sum::<f64>() + slope * (wave * at.x()).sin()
    };
    let u = Function::from_positions(&breaks, f).unwrap();
    let zero = Function::piecewise(&Mesh::uniform(17, 1.0).unwrap(), 0, &[0.0; 17]).unwrap();
    // This method is slower: at weak singularities its work is limited.
    let second = |norm: bool| {
        let tight = Tolerance::new((0.1 * asked.relative()).max(1e-9)).unwrap().with_work(1 << 22);
        let found = if norm {
            u.minus(&zero).unwrap().norm(order, tight)
        } else {
            u.minus(&zero).unwrap().seminorm(order, tight)
        };
        Estimate::or_best(found).ok()
    };
    let norm = random.below(2) == 0;
    let what = format!("closure with breaks {breaks:?}, terms {terms:?}, sin {wave}, {order}, norm {norm}");
    case(what, asked, second(norm).unwrap_or_else(nothing_known), |asked| {
        if norm { u.norm(order, asked) } else { u.seminorm(order, asked) }
    })
}

/// cos kπx with many waves or few.
fn wave(random: &mut SplitMix) -> Case {
    let (order, asked) = (order(random, 0.97), tolerance(random));
    let k = 10f64.powf(random.between(0.0, 3.3)) as u32;
    let rule = gauss_legendre(16).unwrap();
    let exact = references::cosine(k, order, &rule).sqrt();
    let u = Function::from_fn(&[0.0, 1.0], |x: f64| (f64::from(k) * PI * x).cos()).unwrap();
    let reference = Estimate { error: 1e-11 * exact, ..exactly(exact) };
    case(format!("cos {k} pi x, {order}"), asked, reference, |asked| u.seminorm(order, asked))
}

/// The power x^k as a polynomial of degree k on any partition.
fn monomial(random: &mut SplitMix) -> Case {
    let (order, asked) = (order(random, 0.97), tolerance(random));
    let degree = 1 + random.below(8);
    let cells = count(random, 4.0);
    let mesh = partition(random, cells);
    let (total, cells) = (mesh.total(), mesh.len());
    let u = Function::interpolate(&mesh, degree, |x| (x / total).powi(degree as i32)).unwrap();
    let exact = closed_forms::power_seminorm_squared(degree as f64, order).unwrap().value.sqrt()
        * total.powf(-order.offset());
    // x is rounded at the ends of small elements
    let reference = Estimate { error: 1e-12 * exact, ..exactly(exact) };
    case(format!("x^{degree} on {cells} cells, {order}"), asked, reference, |asked| u.seminorm(order, asked))
}

/// Random values at nodes; against the same function on halved elements.
fn linear(random: &mut SplitMix) -> Case {
    let (order, asked) = (order(random, 0.97), tolerance(random));
    let cells = count(random, 5.0);
    let mesh = partition(random, cells);
    let values: Vec<f64> = (0..=mesh.len()).map(|_| random.between(-1.0, 1.0)).collect();
    let u = Function::linears(&mesh, &values).unwrap();
    let halves = halved(&u);
    let second = Estimate::or_best(halves.seminorm(order, Tolerance::new(1e-11).unwrap())).unwrap();
    let what = format!("linears on {} elements, {order}", u.mesh().unwrap().len());
    case(what, asked, second, |asked| u.seminorm(order, asked))
}

/// Every element cut in two.
fn halved(u: &Function<'_>) -> Function<'static> {
    let lengths = u.mesh().unwrap().lengths().iter().flat_map(|h| [0.5 * h, 0.5 * h]).collect();
    let at = |k: usize, t: f64| u.value(k, t).unwrap();
    let ends: Vec<[f64; 2]> = (0..u.mesh().unwrap().len())
        .flat_map(|k| [[at(k, 0.0), at(k, 0.5)], [at(k, 0.5), at(k, 1.0)]])
        .collect();
    Function::piecewise(&Mesh::from_lengths(lengths).unwrap(), 1, ends.as_flattened()).unwrap()
}

/// L^q of random linears: ∫ |l|^q on an element is (r |r|^q − l |l|^q)/((q + 1)(r − l)) h.
fn lebesgue_of_linears(random: &mut SplitMix) -> Case {
    let asked = tolerance(random);
    let cells = count(random, 5.0);
    let mesh = partition(random, cells);
    let q = [1.0, 1.5, 2.0, 3.0, 7.0][random.below(5)];
    let values: Vec<f64> = (0..=mesh.len()).map(|_| random.between(-1.0, 1.0)).collect();
    let power = |v: f64| v * v.abs().powf(q);
    let share = |(w, h): (&[f64], &f64)| {
        if (w[1] - w[0]).abs() < 1e-4 {
            h * (0.5 * (w[0] + w[1])).abs().powf(q)
        } else {
            h * (power(w[1]) - power(w[0])) / ((q + 1.0) * (w[1] - w[0]))
        }
    };
    let exact = values.windows(2).zip(mesh.lengths()).map(share).sum::<f64>().powf(1.0 / q);
    let cells = mesh.len();
    let u = Function::linears(&mesh, &values).unwrap();
    let reference = Estimate { error: 1e-9 * exact, ..exactly(exact) };
    case(format!("linears on {cells} in L^{q}"), asked, reference, |asked| u.lp(q, asked))
}

/// u − u_h for u = x^a and its interpolant; against the seminorm of the difference with all nodes as breaks.
fn error_of_field(random: &mut SplitMix) -> Case {
    let (order, asked) = (order(random, 0.9), tolerance(random));
    let a = order.offset().max(0.0) + random.between(0.1, 2.0);
    let cells = 2 + random.below(9);
    let mesh = partition(random, cells);
    let nodes: Vec<f64> = mesh.nodes();
    let total = mesh.total();
    let values: Vec<f64> = nodes.iter().map(|x| (x / total).powf(a)).collect();
    let field = Function::linears(&mesh, &values).unwrap();
    let u = Function::from_positions(&[0.0, total], |at| (at.distance_to(0) / total).powf(a)).unwrap();
    let difference = |at: Position| {
        let k = at.anchor();
        let right = at.offset() > 0.0 || at.offset() == 0.0 && at.offset().is_sign_positive();
        let i = if right { k } else { k - 1 };
        let slope = (values[i + 1] - values[i]) / (nodes[i + 1] - nodes[i]);
        (at.distance_to(0) / total).powf(a) - values[k] - slope * at.offset()
    };
    let second = Function::from_positions(&nodes, difference).unwrap();
    let tight = Tolerance::new(1e-9).unwrap();
    let reference = Estimate::or_best(second.seminorm(order, tight)).unwrap();
    // x^a beside a difference of 1e-4: rounding of x
    let reference = Estimate { error: reference.error + 1e-11 * reference.value + 1e-14, ..reference };
    let what = format!("x^{a} less its interpolant on {cells}, {order}");
    case(what, asked, reference, |asked| u.minus(&field).unwrap().seminorm(order, asked))
}

/// The boundary of a random convex polygon, linears on it; against halved elements, and scaled.
fn boundary(random: &mut SplitMix) -> Case {
    let (order, asked) = (order(random, 0.9), tolerance(random));
    let corners = 3 + random.below(4);
    let vertices: Vec<[f64; 2]> = (0..corners)
        .map(|k| {
            let angle = 2.0 * PI * (k as f64 + random.between(-0.3, 0.3)) / corners as f64;
            [angle.cos() + 2.0, 1.7 * angle.sin()]
        })
        .collect();
    let cells = 2 + random.below(30);
    let meshes: Vec<Mesh> = (0..corners).map(|_| partition(random, cells)).collect();
    let coarse = Curve::closed(&vertices, &meshes).unwrap();
    let values: Vec<f64> = (0..coarse.nodes().len()).map(|_| random.between(-1.0, 1.0)).collect();
    let u = Function::on_curve(&coarse, 1, &values).unwrap();
    let halves: Vec<Mesh> = meshes
        .iter()
        .map(|mesh| {
            let lengths = mesh.lengths().iter().flat_map(|h| [0.5 * h, 0.5 * h]).collect();
            Mesh::from_lengths(lengths).unwrap()
        })
        .collect();
    let larger: Vec<[f64; 2]> = vertices.iter().map(|[x, y]| [4.0 * x, 4.0 * y]).collect();
    let count = values.len();
    let between: Vec<f64> =
        (0..2 * count).map(|k| 0.5 * (values[k / 2] + values[k.div_ceil(2) % count])).collect();
    let second = Function::on_curve(&Curve::closed(&larger, &halves).unwrap(), 1, &between).unwrap();
    let found = Estimate::or_best(second.seminorm(order, Tolerance::new(1e-11).unwrap())).unwrap();
    let reference = found.times(4f64.powf(order.offset())).unwrap();
    let what = format!("linears on {corners} sides of {cells}, {order}");
    case(what, asked, reference, |asked| u.seminorm(order, asked))
}

/// Steps ±1, random values, ramps.
fn load(random: &mut SplitMix, decades: f64) -> (Function<'static>, String) {
    let cells = count(random, decades);
    let mesh = partition(random, cells);
    let (cells, equal) = (mesh.len(), mesh.lengths().windows(2).all(|pair| pair[0] == pair[1]));
    let kind = random.below(3);
    let ends: Vec<[f64; 2]> = (0..cells)
        .map(|k| match kind {
            0 => [(2 * random.below(2)) as f64 - 1.0; 2],
            1 => [random.between(-1.0, 1.0); 2],
            _ => [random.between(-1.0, 1.0), (k as f64).sin()],
        })
        .collect();
    let load = Function::piecewise(&mesh, 1, ends.as_flattened()).unwrap();
    (load, format!("load {kind} on {cells} elements, equal: {equal}"))
}

/// Dual norms of interpolation spaces; against the halved partition, at a tighter tolerance.
fn interpolation_load(random: &mut SplitMix) -> Case {
    let (order, asked) = (order(random, 0.97), tolerance(random));
    let (u, what) = load(random, 5.0);
    let of = [DualOf::Interpolation, DualOf::InterpolationZero][random.below(2)];
    let second = Estimate::or_best(halved(&u).dual_norm(of, order, reference())).unwrap();
    case(format!("{what}, {of:?}, {order}"), asked, second, |asked| u.dual_norm(of, order, asked))
}

/// The dual norm (1.1); against the same load with an element cut at an odd place, so that no mesh fits.
fn regional_load(random: &mut SplitMix) -> Case {
    let (order, asked) = (order(random, 0.9), tolerance(random));
    let (u, what) = load(random, 4.0);
    let share = random.between(0.3, 0.4);
    let (mut lengths, mut ends) = (Vec::new(), Vec::new());
    for (k, h) in u.mesh().unwrap().lengths().iter().enumerate() {
        let at = |t: f64| u.value(k, t).unwrap();
        lengths.extend([share * h, (1.0 - share) * h]);
        ends.extend([[at(0.0), at(share)], [at(share), at(1.0)]]);
    }
    let cut = Mesh::from_lengths(lengths).unwrap();
    let cut = Function::piecewise(&cut, 1, ends.as_flattened()).unwrap();
    let of = DualOf::Slobodeckij;
    let second = Estimate::or_best(cut.dual_norm(of, order, asked.relative().max(1e-6))).unwrap();
    case(format!("{what}, {of:?}, {order}"), asked, second, |asked| u.dual_norm(of, order, asked))
}

/// The dual norm of a closure; against its interpolant on a graded mesh, which leaves what L² bounds.
fn closure_load(random: &mut SplitMix) -> Case {
    let (order, asked) = (order(random, 0.9), tolerance(random));
    let (a, at) = (random.between(-0.4, 1.0), random.between(0.2, 0.8));
    let of = [DualOf::Interpolation, DualOf::InterpolationZero][random.below(2)];
    let f = |p: Position| p.distance_to(1).powf(a) + p.x();
    let u = Function::from_positions(&[0.0, at, 1.0], f).unwrap();
    // The same without the declared place of the distance: the other half of the interval first.
    let g = |p: Position| p.distance_to(1).powf(a) + 1.0 - p.x();
    let mirrored = Function::from_positions(&[0.0, 1.0 - at, 1.0], g).unwrap();
    let second = Estimate::or_best(mirrored.dual_norm(of, order, 1e-12)).unwrap();
    let what = format!("|x - {at}|^{a} + x as a load, {of:?}, {order}");
    case(what, asked, second, |asked| u.dual_norm(of, order, asked))
}

/// Waves as a load: cos kπx has the norm (1 + k²π²)^{-ν/2}/√2 in the dual of interpolation.
fn wave_load(random: &mut SplitMix) -> Case {
    let (order, asked) = (order(random, 0.97), tolerance(random));
    let k = 1 + random.below(12);
    let frequency = k as f64 * PI;
    let u = Function::from_fn(&[0.0, 1.0], |x: f64| (frequency * x).cos()).unwrap();
    let exact = exactly((1.0 + frequency * frequency).powf(-0.5 * order.value()) / 2f64.sqrt());
    case(format!("cos {k} pi x as a load, {order}"), asked, exact, |asked| {
        u.dual_norm(DualOf::Interpolation, order, asked)
    })
}

type Family = (&'static str, fn(&mut SplitMix) -> Case);

const FAMILIES: [Family; 15] = [
    ("powers", power),
    ("logarithms", logarithm),
    ("L^q of powers and logarithms", lebesgue),
    ("closures with breaks", closure),
    ("waves", wave),
    ("P1 ... P8", monomial),
    ("P1, random", linear),
    ("L^q of P1", lebesgue_of_linears),
    ("u - u_h", error_of_field),
    ("polygons", boundary),
    ("loads, interpolation", interpolation_load),
    ("loads, (1.1)", regional_load),
    ("closures as loads", closure_load),
    ("waves as loads", wave_load),
    ("L^q again", lebesgue),
];

/// The fault of a case, if any.
fn fault(case: &Case) -> Option<String> {
    let Case { what, tolerance, found, reference } = case;
    let apart = |found: &Estimate| (found.value - reference.value).abs() > found.error + reference.error;
    let told = match found {
        Ok(found) if apart(found) => format!("{found:?} is dishonest"),
        Ok(found) if found.relative_error() > tolerance.relative().max(8e-15) => {
            format!("{found:?} misses the tolerance")
        }
        Err(Error::ToleranceNotMet { best: Some(best), .. }) if apart(best) => {
            format!("the refusal {best:?} is dishonest")
        }
        // No value at all is an answer where most of the norm lies beyond what can be evaluated.
        Err(Error::ToleranceNotMet { best, reached, .. }) if best.is_some() || what.starts_with(DEEP) => {
            assert!(best.is_some() || *reached == f64::INFINITY);
            String::new()
        }
        Err(error) => format!("no value: {error}"),
        Ok(_) => String::new(),
    };
    let work = Estimate::or_best(found.clone()).map_or(0, |found| found.work.points);
    let long = if work > WORK { format!("{work} evaluations") } else { String::new() };
    let is_fine = told.is_empty() && long.is_empty();
    (!is_fine).then(|| format!("{what}, asked {tolerance}: {told} {long}; reference {reference}"))
}

#[test]
fn random_functions_and_loads_are_honest() {
    let (mut faults, mut tried, mut refused) = (Vec::new(), 0, 0);
    let only = std::env::var("SIGNORINI_FAMILY").unwrap_or_default();
    for (seed, (family, make)) in FAMILIES.iter().enumerate() {
        if !family.contains(&only) {
            continue;
        }
        let mut random = SplitMix::new(77 + seed as u64);
        let (mut kept, mut sharp) = (0, 0.0_f64);
        for _ in 0..cases(CASES) {
            let case = make(&mut random);
            tried += 1;
            match &case.found {
                Ok(found) => {
                    kept += 1;
                    let off = (found.value - case.reference.value).abs() - case.reference.error;
                    sharp = sharp.max(off / found.error);
                }
                Err(_) => refused += 1,
            }
            faults.extend(fault(&case).map(|fault| format!("{family}: {fault}")));
        }
        println!("{family}: {} tried, {kept} answered, error/estimate {sharp:.2}", cases(CASES));
    }
    println!("{tried} tried, {refused} refused, {} faults", faults.len());
    assert!(faults.is_empty(), "{}", faults.join("\n"));
    assert!(3 * refused < tried, "{refused} of {tried} refused");
}

#[test]
fn wrong_answers_are_found() {
    let made = |value: f64, error: f64, points: u64, found: bool| {
        let estimate = Estimate { value, error, work: Work { points, ..Work::default() } };
        let (asked, reached, best) = (1e-6, estimate.relative_error(), Some(estimate));
        let refusal = Err(Error::ToleranceNotMet { what: "norm", asked, reached, best, why: "made" });
        let tolerance = Tolerance::new(1e-6).unwrap();
        let found = if found { Ok(estimate) } else { refusal };
        fault(&Case { what: "made".to_owned(), tolerance, found, reference: exactly(1.0) })
    };
    assert!(made(1.0 + 1e-8, 1e-7, 1, true).is_none() && made(1.0, 1e-3, 1, false).is_none());
    for (value, error, points, found, what) in [
        (1.0 + 1e-6, 1e-7, 1, true, "an error above its estimate"),
        (1.0, 1e-3, 1, true, "an answer beside its tolerance"),
        (1.0, 1e-7, WORK + 1, true, "an answer beside its limit of work"),
        (1.1, 1e-3, 1, false, "a refusal that does not enclose"),
    ] {
        assert!(made(value, error, points, found).is_some(), "{what}");
    }
}
