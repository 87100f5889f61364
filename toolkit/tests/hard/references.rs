//! Squared seminorms by formulas of their own: sums of positive terms, singular ends taken out by hand.

use fractional_sobolev::{Order, Rule};
use std::f64::consts::{LN_2, PI};

/// ∫₀^∞ f for f smooth on [0, ∞) that falls like e^{-cy}: trapezoidal sum in τ, y = exp(τ − e^{-τ}).
fn half_line(c: f64, f: impl Fn(f64) -> f64) -> f64 {
    const STEP: f64 = 1.0 / 8.0;
    let mut sum = 0.0;
    for k in -29.. {
        let tau = STEP * f64::from(k);
        let fall = (-tau).exp();
        let y = (tau - fall).exp();
        sum += STEP * y * (1.0 + fall) * f(y);
        if y > 1.0 && c * y > 45.0 {
            return sum;
        }
    }
    unreachable!("y grows")
}

/// 2 − 2ν, exact near ν = 1.
fn two_minus(order: Order) -> f64 {
    if order.offset() > 0.0 { 1.0 - 2.0 * order.offset() } else { 2.0 * (1.0 - order.value()) }
}

/// R^{1−2ν}, the exponent as exact as it is known.
pub fn scale(r: f64, order: Order) -> f64 {
    if order.value() < 0.25 {
        let root = r.powf(-order.value());
        r * root * root
    } else {
        r.powf(-2.0 * order.offset())
    }
}

/// |x^a|²_ν on (0, 1) = (a − ν + 1/2)^{-1} ∫₀¹ (1−t^a)² (1−t)^{-1-2ν} dt. Above t = 1/2 in w = 1 − t, where
/// (1−t^a)² = a²w² + ..., the first term is integrated by hand; below in s = −ln t.
pub fn power(a: f64, order: Order) -> f64 {
    let (nu, p) = (order.value(), two_minus(order));
    let near = half_line(p + 1.0, |y| {
        let w = 0.5 * (-y).exp();
        let h = -(a * (-w).ln_1p()).exp_m1() / w;
        if w < 1e-290 { 0.0 } else { (h - a) * (h + a) * w.powf(p) }
    });
    let taken_out = a * a * 0.5f64.powf(p) / p;
    let fall = if a < 0.0 { 2.0 * (0.5 + a) } else { 1.0 };
    let far = half_line(fall, |y| {
        let s = LN_2 + y;
        let rise = (-a.abs() * s).exp_m1();
        rise * rise * (-fall * s).exp() * (-(-s).exp_m1()).powf(-1.0 - 2.0 * nu)
    });
    (near + taken_out + far) / (a - order.offset())
}

/// |x^a ln x|²_ν on (0, 1) = 2 ∫₀¹ ((B + A/p)² + (A/p)²)/p (1−t)^{-1-2ν} dt, A = 1 − t^a, B = t^a ln t, p = 2(a − ν + 1/2):
/// the integral over y of (u(y) − u(ty))² y^{-2ν} = y^{p−1} (A ln y − B)². As [`power`], A and B are O(1 − t).
pub fn power_with_logarithm(a: f64, order: Order) -> f64 {
    let (nu, two_minus, p) = (order.value(), two_minus(order), 2.0 * (a - order.offset()));
    // Over (1 − t)².
    let square =
        |a_over: f64, b_over: f64| ((b_over + a_over / p).powi(2) + (a_over / p).powi(2)) / p;
    let at_one = square(a, -1.0);
    let near = half_line(two_minus + 1.0, |y| {
        let w = 0.5 * (-y).exp();
        let log = (-w).ln_1p();
        let off = square(-(a * log).exp_m1() / w, (a * log).exp() * log / w) - at_one;
        if w < 1e-290 { 0.0 } else { off * w.powf(two_minus) }
    });
    let fall = if a < 0.0 { 2.0 * (0.5 + a) } else { 1.0 };
    let far = half_line(fall, |y| {
        let s = LN_2 + y;
        // For a < 0 over t^a, the square of which is in `fall`.
        let (rise, power) =
            if a < 0.0 { ((a * s).exp_m1(), 1.0) } else { (-(-a * s).exp_m1(), (-a * s).exp()) };
        square(rise, -power * s) * (-fall * s).exp() * (-(-s).exp_m1()).powf(-1.0 - 2.0 * nu)
    });
    2.0 * (near + at_one * 0.5f64.powf(two_minus) / two_minus + far)
}

/// 2 ∫₀¹∫₀¹ (x^a ± y^a)² (x+y)^{-1-2ν} dy dx = 2/(a − ν + 1/2) ∫₀¹ (1 ± t^a)² (1+t)^{-1-2ν} dt.
pub fn two_powers(a: f64, order: Order, sign: f64) -> f64 {
    let fall = if a < 0.0 { 2.0 * (0.5 + a) } else { 1.0 };
    let integral = half_line(fall, |s| {
        let power = (-a.abs() * s).exp();
        let sum = if sign < 0.0 { -(-a.abs() * s).exp_m1() } else { 1.0 + power };
        sum * sum * (-fall * s).exp() * (1.0 + (-s).exp()).powf(-1.0 - 2.0 * order.value())
    });
    2.0 * integral / (a - order.offset())
}

/// ||ln x|^α|²_{1/2} = 2 ∫₀^∞ r^{2α+1} / (4 sinh²(r/2)) dr ∫₀^∞ ((1+t)^α − t^α)² dt, both cut at 1.
pub fn log_power(alpha: f64) -> f64 {
    let quotient = |r: f64| (0.5 * r / (0.5 * r).sinh()).powi(2);
    let first = 0.5 / alpha
        + half_line(2.0, |y| (-2.0 * alpha * y).exp() * (quotient((-y).exp()) - 1.0))
        + half_line(1.0, |y| {
            let r = 1.0 + y;
            if r > 700.0 { 0.0 } else { r.powf(2.0 * alpha - 1.0) * quotient(r) }
        });
    let below = half_line(1.0, |y| {
        // t = e^{-y}; ln(1 + 1/t) = y + ln(1 + e^{-y})
        let rise = (alpha * (y + (-y).exp().ln_1p())).exp_m1();
        rise * rise * (-(1.0 + 2.0 * alpha) * y).exp()
    });
    let above = half_line(1.0, |y| {
        // t = e^y, s = 1/t
        let s = (-y).exp();
        let g = (alpha * s.ln_1p()).exp_m1() / s;
        if s < 1e-290 { 0.0 } else { (g - alpha) * (g + alpha) * (-2.0 * (0.5 - alpha) * y).exp() }
    });
    2.0 * first * (below + alpha * alpha / (2.0 * (0.5 - alpha)) + above)
}

/// ln of the unit in which |ln x|^α is of size 1 at the order ν < 1/2: its values where t^{2α} e^{−(1−2ν)t}
/// is largest.
pub fn log_unit(alpha: f64, order: Order) -> f64 {
    (alpha * ((2.0 * alpha / (-2.0 * order.offset())).ln() - 1.0)).max(0.0)
}

/// (1e-140)^{LEAST} is nothing.
pub const LEAST: f64 = 0.12;

/// ||ln x|^α|²_ν for ν < 1/2 in the unit of [`log_unit`]: with x = e^{−t−r}, y = e^{−t},
/// 2 ∫₀^∞ e^{−(1−2ν)t} ∫₀^∞ ((t+r)^α − t^α)² e^{−r} (1−e^{−r})^{-1-2ν} dr dt, trapezoidal sums in τ; near 0
/// the integrand is homogeneous of degree 2α − 2ν − 1, and [`LEAST`] is what 2α + 1 − 2ν is at least.
pub fn log_power_below_half(alpha: f64, order: Order) -> f64 {
    const STEP: f64 = 1.0 / 48.0;
    let (decay, twice, unit) =
        ((-2.0 * order.offset()), 2.0 * order.value(), log_unit(alpha, order));
    let points = |c: f64| -> Vec<(f64, f64)> {
        let point = |k: i32| {
            let tau = STEP * f64::from(k);
            let fall = (-tau).exp();
            let y = (tau - fall).exp();
            (y, STEP * y * (1.0 + fall))
        };
        // Down to 1e-140, up to where e^{-cy} with a power of y is nothing.
        (-277..).map(point).take_while(|(y, _)| c * y < 60.0 + 8.0 * alpha).collect()
    };
    let inner: Vec<[f64; 3]> = points(1.0)
        .into_iter()
        .map(|(r, w)| [r, w, (-r).exp() * (-(-r).exp_m1()).powf(-1.0 - twice)])
        .collect();
    let mut sum = 0.0;
    for (t, w) in points(decay) {
        // In the unit: (t+r)^α − t^α = t^α expm1(α ln(1 + r/t))
        let ground = alpha * t.ln() - unit - 0.5 * decay * t;
        let row: f64 = inner
            .iter()
            .map(|&[r, v, kernel]| {
                let growth = alpha * (r / t).ln_1p();
                let rise = if growth < 1.0 {
                    growth.exp_m1() * ground.exp()
                } else {
                    (ground + growth).exp() - ground.exp()
                };
                v * kernel * rise * rise
            })
            .sum();
        sum += w * row;
    }
    2.0 * sum
}

/// |cos kπx|²_ν on (0, 1) = 4 ω^{2ν} ∫₀^ω sin²(v/2) [1 − (v − sin v)/ω] v^{-1-2ν} dv, ω = kπ; Gauss's rule on
/// every half period, the term v²/4 of the first one by hand.
pub fn cosine(k: u32, order: Order, rule: &Rule) -> f64 {
    let (nu, p, omega) = (order.value(), 2.0 * (1.0 - order.value()), f64::from(k) * PI);
    let density = |v: f64| (0.5 * v).sin().powi(2) * (1.0 - (v - v.sin()) / omega);
    let first = 0.25 * PI.powf(p) / p
        + half_line(p + 1.0, |y| {
            let v = PI * (-y).exp();
            if v < 1e-150 { 0.0 } else { (density(v) / (v * v) - 0.25) * v.powf(p) }
        });
    let rest: f64 = (1..k)
        .map(|j| {
            rule.integrate(|t| {
                let v = PI * (f64::from(j) + t);
                PI * density(v) * v.powf(-1.0 - 2.0 * nu)
            })
        })
        .sum();
    4.0 * omega.powf(2.0 * nu) * (first + rest)
}

/// |u|²_ν of a function that is linear from `ends[i][0]` to `ends[i][1]` on elements of the given lengths.
pub fn linears(lengths: &[f64], ends: &[[f64; 2]], order: Order, rule: &Rule) -> f64 {
    let mut sum = 0.0;
    for (i, (&p, u)) in lengths.iter().zip(ends).enumerate() {
        let rise = u[1] - u[0];
        sum += rise * rise * scale(p, order)
            / ((1.0 - order.value()) * (1.0 + 2.0 * (1.0 - order.value())));
        for j in i + 1..lengths.len() {
            let v = ends[j];
            let distance = lengths[i + 1..j].iter().sum();
            let (left, right) = ([p, u[0] - u[1]], [lengths[j], v[1] - v[0]]);
            let (short, long, jump) = if p <= lengths[j] {
                (left, right, v[0] - u[1])
            } else {
                (right, left, u[1] - v[0])
            };
            sum += 2.0 * pair(distance, short, long, jump, order, rule);
        }
    }
    sum
}

/// ∫₀^p ∫₀^q (D + b y/q − a x/p)² (d+x+y)^{-1-2ν} dy dx for p ≤ q, in r = x + y: the integral across is
/// exact, the one in r by Gauss's rule on panels (r, 2r + d). At d = 0 a jump D comes with a = b = 0.
fn pair(d: f64, [p, a]: [f64; 2], [q, b]: [f64; 2], jump: f64, order: Order, rule: &Rule) -> f64 {
    let exponent = -1.0 - 2.0 * order.value();
    // Two points are exact for squares of linear functions.
    let mean = |difference: &dyn Fn(f64) -> f64| {
        let half = 0.5 / 3f64.sqrt();
        0.5 * (difference(0.5 - half).powi(2) + difference(0.5 + half).powi(2))
    };
    let panel = |from: f64, to: f64, origin: f64, sign: f64, inside: &dyn Fn(f64) -> (f64, f64)| {
        let start = origin + sign * from;
        let part = rule.integrate(|t| {
            let r = from + (to - from) * t;
            let (width, mean) = inside(r);
            width / start * mean * ((origin + sign * r) / start).powf(exponent)
        });
        (to - from) / start * part * scale(start, order)
    };
    let (mut sum, mut from) = (RunningSum::default(), 0.0);
    if d == 0.0 {
        let slope = b * (p / q);
        let squares = if jump == 0.0 {
            (a * a - a * slope + slope * slope) / 3.0 / (1.0 + 2.0 * (1.0 - order.value()))
        } else {
            jump * jump / (-2.0 * order.offset())
        };
        // ∫₀^p r (r/p)² (a² − a b p/q + (b p/q)²)/3 r^{-1-2ν} dr has the exponent 3 − 2ν.
        sum.add(squares * scale(p, order));
        from = p;
    }
    while from < p {
        let to = (2.0 * from + d).min(p);
        sum.add(panel(from, to, d, 1.0, &|r| {
            (r, mean(&|t| jump + b * (r * (1.0 - t) / q) - a * (r * t / p)))
        }));
        from = to;
    }
    while from < q {
        let to = (2.0 * from + d).min(q);
        sum.add(panel(from, to, d, 1.0, &|r| (p, mean(&|t| jump + b * ((r - p * t) / q) - a * t))));
        from = to;
    }
    // r = p + q − s: the corner of the far ends
    sum.add(panel(0.0, p, d + q + p, -1.0, &|s| {
        (s, mean(&|t| jump + b * (1.0 - s * (1.0 - t) / q) - a * (1.0 - s * t / p)))
    }));
    sum.value()
}

/// A running sum with Neumaier's compensation (ZAMM 54, 1974): error about 1 ulp of Σ|terms| ε² n, whatever
/// the count.
#[derive(Debug, Clone, Copy, Default)]
struct RunningSum {
    sum: f64,
    carry: f64,
}

impl RunningSum {
    /// One more term.
    fn add(&mut self, term: f64) {
        let next = self.sum + term;
        self.carry += if self.sum.abs() >= term.abs() {
            (self.sum - next) + term
        } else {
            (term - next) + self.sum
        };
        self.sum = next;
    }

    /// The sum so far.
    fn value(&self) -> f64 {
        self.sum + self.carry
    }
}
