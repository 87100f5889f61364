//! Linear and logarithmic axes: the map from data to the unit interval, and ticks at round numbers.

/// Ticks on an axis.
const MOST: f64 = 6.0;

/// How an axis maps data to the unit interval.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Scale {
    low: f64,
    high: f64,
    logarithmic: bool,
}

impl Scale {
    /// An axis over this range, or one that shows all of `values`, with a little room on both
    /// sides. Values a logarithmic axis cannot show, and values that are not finite, do not count.
    pub(super) fn of(
        range: Option<(f64, f64)>,
        values: impl Iterator<Item = f64>,
        logarithmic: bool,
    ) -> Self {
        if let Some((low, high)) = range {
            return Self {
                low: transform(low, logarithmic),
                high: transform(high, logarithmic),
                logarithmic,
            };
        }
        let finite = values.map(|v| transform(v, logarithmic)).filter(|v| v.is_finite());
        let ends = (f64::INFINITY, f64::NEG_INFINITY);
        let (mut low, mut high) = finite.fold(ends, |(low, high), v| (low.min(v), high.max(v)));
        if low > high {
            (low, high) = (0.0, 1.0);
        }
        if high - low < 1e-12 * (1.0 + low.abs()) {
            (low, high) = (low - 0.5, high + 0.5);
        }
        let room = 0.04 * (high - low);
        Self { low: low - room, high: high + room, logarithmic }
    }

    /// The position of a value: 0 at the low end, 1 at the high end; `None` when it cannot be
    /// shown.
    pub(super) fn position(&self, value: f64) -> Option<f64> {
        let position = (transform(value, self.logarithmic) - self.low) / (self.high - self.low);
        position.is_finite().then_some(position)
    }

    /// About [`MOST`] ticks at round numbers: positions in the unit interval, and labels.
    pub(super) fn ticks(&self) -> Vec<(f64, String)> {
        let span = self.high - self.low;
        let ticks = if !self.logarithmic {
            self.linear()
        } else if span < 3.0 {
            self.few_decades()
        } else {
            let steps = [1.0, 2.0, 3.0, 5.0, 10.0, 20.0, 25.0, 50.0];
            let step = steps.into_iter().find(|&step| step >= span / MOST).unwrap_or(100.0);
            multiples(self.low, self.high, step).map(|k| (k, power_of_ten(k as i64))).collect()
        };
        ticks.into_iter().map(|(at, label)| ((at - self.low) / span, label)).collect()
    }

    fn few_decades(&self) -> Vec<(f64, String)> {
        let (first, last) = (self.low.floor() as i64, self.high.ceil() as i64);
        let mantissas = match self.high - self.low {
            span if span > 2.2 => vec![1.0, 3.0],
            span if span > 0.7 => vec![1.0, 2.0, 5.0],
            _ => (10..100).map(|k| f64::from(k) / 10.0).collect(),
        };
        let candidates: Vec<(f64, i64, f64)> = (first..=last)
            .flat_map(|k| mantissas.iter().map(move |&m: &f64| (k as f64 + m.log10(), k, m)))
            .filter(|&(at, ..)| at >= self.low && at <= self.high)
            .collect();
        let every =
            if mantissas.len() > 3 { candidates.len().div_ceil(MOST as usize).max(1) } else { 1 };
        let label = |k: i64, m: f64| {
            if (-3..4).contains(&k) {
                trimmed(m * 10f64.powi(k as i32), (1 - k).max(0) as usize)
            } else {
                format!("{}·{}", trimmed(m, 1), power_of_ten(k))
            }
        };
        candidates.iter().step_by(every).map(|&(at, k, m)| (at, label(k, m))).collect()
    }

    fn linear(&self) -> Vec<(f64, String)> {
        let raw = (self.high - self.low) / MOST;
        let decade = 10f64.powf(raw.log10().floor());
        let step = [1.0, 2.0, 2.5, 5.0, 10.0]
            .map(|m| m * decade)
            .into_iter()
            .find(|&s| s >= raw * 0.999)
            .unwrap_or(10.0 * decade);
        let largest = self.low.abs().max(self.high.abs());
        multiples(self.low, self.high, step).map(|at| (at, plain(at, step, largest))).collect()
    }
}

fn transform(value: f64, logarithmic: bool) -> f64 {
    if logarithmic { value.log10() } else { value }
}

fn multiples(low: f64, high: f64, step: f64) -> impl Iterator<Item = f64> {
    let first = (low / step).ceil() as i64;
    let last = (high / step).floor() as i64;
    (first..=last).map(move |k| k as f64 * step)
}

/// A tick of a linear axis: as many decimals as the step needs, one power of ten for very large or
/// small axes.
fn plain(at: f64, step: f64, largest: f64) -> String {
    if !(1e-2..1e5).contains(&largest) {
        if at.abs() < 0.5 * step {
            return "0".to_owned();
        }
        let exponent = largest.log10().floor() as i64;
        let unit = 10f64.powi(exponent as i32);
        let decimals = (-(step / unit).log10().floor()).max(0.0) as usize + 1;
        return format!("{}·{}", trimmed(at / unit, decimals), power_of_ten(exponent));
    }
    trimmed(at, (-step.log10().floor()).max(0.0) as usize + 1)
}

/// `value` with at most `decimals` digits after the point and no trailing zeros.
fn trimmed(value: f64, decimals: usize) -> String {
    let text = format!("{value:.decimals$}");
    let text =
        if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { &text };
    if text == "-0" { "0".to_owned() } else { text.replace('-', "−") }
}

/// A power of ten.
fn power_of_ten(k: i64) -> String {
    match k {
        0 => "1".to_owned(),
        1 => "10".to_owned(),
        _ => format!("10^{k}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn exact(low: f64, high: f64, logarithmic: bool) -> Scale {
        Scale::of(Some((low, high)), std::iter::empty(), logarithmic)
    }

    fn labels(scale: Scale) -> Vec<String> {
        scale.ticks().into_iter().map(|(_, label)| label).collect()
    }

    #[test]
    fn wide_logarithmic_axes_have_few_decades() {
        let labels = labels(exact(1e-300, 1.0, true));
        assert_eq!(labels, ["10^-300", "10^-250", "10^-200", "10^-150", "10^-100", "10^-50", "1"]);
    }

    #[test]
    fn narrow_axes_have_round_labels() {
        assert_eq!(labels(exact(0.0, 1.0, false)), ["0", "0.2", "0.4", "0.6", "0.8", "1"]);
        assert_eq!(labels(exact(0.1, 1.0, true)), ["0.1", "0.2", "0.5", "1"]);
        assert_eq!(
            labels(exact(0.0, 2e-3, false)),
            ["0", "0.5·10^-3", "1·10^-3", "1.5·10^-3", "2·10^-3"]
        );
    }

    #[test]
    fn what_cannot_be_shown_has_no_position() {
        let scale = Scale::of(None, [1.0, 10.0, f64::NAN, 0.0].into_iter(), true);
        assert_eq!(scale.position(0.0), None);
        assert_eq!(scale.position(f64::NAN), None);
        assert!(scale.position(1.0).is_some_and(|p| p > 0.0 && p < 0.1));
    }
}
