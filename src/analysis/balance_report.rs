//! The balance of θ: what is printed and drawn.

use crate::error::Result;
use crate::figures::{Axis, Chart, Series};
use crate::proof::{ElementBalance, Exponent, WorstPair, printed_theta};
use crate::report::{Column, Format, Headline, Table, Verdict};

/// Bounds and worst cases of one element length.
#[derive(Debug, Clone, PartialEq)]
pub struct BalanceRow {
    /// h.
    pub h: f64,
    /// The printed θ and the larger bound there.
    pub printed: [f64; 2],
    /// θ where the printed bounds cross and the bound there.
    pub crossing: [f64; 2],
    /// The same for the sharpened bounds.
    pub sharpened: [f64; 2],
    /// Worst case over the contact sets of the first case, of the second, for the printed θ.
    pub cases: [f64; 2],
    /// Worst case over all contact sets.
    pub worst: WorstPair,
    /// W of all contact intervals.
    pub pairs: Vec<WorstPair>,
}

/// Worst pair over the intervals with max(a, b) ≤ θ, and with max(a, b) ≥ θ; zero without any.
fn worst_of_cases(pairs: &[WorstPair], theta: f64) -> [f64; 2] {
    let worst = |keep: &dyn Fn(f64) -> bool| {
        let kept = pairs.iter().filter(|p| keep(p.ends[0].max(p.ends[1])));
        kept.fold(0.0, |m: f64, p| m.max(p.value))
    };
    [worst(&|a| a <= theta), worst(&|a| a >= theta)]
}

impl ElementBalance {
    /// Bounds and worst cases for the given element lengths.
    ///
    /// # Errors
    /// [`crate::Error::OutOfRange`] unless 0 < h < 1.
    pub fn rows(&self, lengths: &[f64]) -> Result<Vec<BalanceRow>> {
        lengths.iter().map(|&h| self.row(h)).collect()
    }

    fn row(&self, h: f64) -> Result<BalanceRow> {
        let theta = printed_theta(h, self.constants().tau())?;
        let pairs = self.worst_pairs(h)?;
        let larger = |theta: f64| self.first_bound(h, theta).max(self.second_bound(h, theta)[0]);
        let (crossing, sharpened) = (self.crossing(h, false), self.crossing(h, true));
        let sharp = self.sharpened_first_bound(h, sharpened).max(self.second_bound(h, sharpened)[1]);
        let none = WorstPair { ends: [0.0; 2], value: 0.0, direction: [0.0; 2] };
        let worst = pairs.iter().fold(none, |best, p| if p.value > best.value { *p } else { best });
        Ok(BalanceRow {
            h,
            printed: [theta, larger(theta)],
            crossing: [crossing, larger(crossing)],
            sharpened: [sharpened, sharp],
            cases: worst_of_cases(&pairs, theta),
            worst,
            pairs,
        })
    }

    /// Claim, table, verdict.
    ///
    /// # Errors
    /// [`crate::Error::CountOutOfRange`] with fewer than three lengths.
    pub fn headline(&self, rows: &[BalanceRow]) -> Result<Headline> {
        let fit = |value: &dyn Fn(&BalanceRow) -> f64| {
            Exponent::fit(&rows.iter().map(|r| (r.h, value(r))).collect::<Vec<_>>())
        };
        let exponents = [
            ("printed", fit(&|r| r.printed[1])?),
            ("crossing", fit(&|r| r.crossing[1])?),
            ("sharpened", fit(&|r| r.sharpened[1])?),
            ("worst", fit(&|r| r.worst.value)?),
        ];
        let [printed, _, sharpened, worst] = exponents.map(|(_, e)| e.value);
        let measured = format!(
            "exponents of h in the bound of one element: printed {printed:.3}, sharpened {sharpened:.3}, true worst case {worst:.3}"
        );
        let claim =
            "theta = h^(2 tau - 3), h^2 at tau = 2, balances the bounds of the first and the second case";
        let mut headline = Headline::new(
            "Section 3, Globally",
            claim,
            table(rows),
            measured,
            self.verdict(rows, printed - worst),
        );
        for (key, exponent) in exponents {
            headline.quote(format!("theta.balance.{key}"), exponent.value);
            headline.quote(format!("theta.balance.{key}.uncertainty"), exponent.uncertainty);
        }
        if let Some(finest) = rows.last() {
            headline.quote("theta.balance.loss", finest.printed[1] / finest.worst.value);
            headline.quote("theta.balance.crossing.theta", finest.crossing[0]);
            headline.quote("theta.balance.printed.theta", finest.printed[0]);
            headline.quote("theta.balance.worst.place", finest.worst.ends[0]);
        }
        Ok(headline)
    }

    /// No worst case may exceed the bound of its case, for any contact interval taken as the limit of its case.
    fn verdict(&self, rows: &[BalanceRow], lost: f64) -> Verdict {
        for row in rows {
            for pair in &row.pairs {
                let theta = pair.ends[0].max(pair.ends[1]);
                let first = self.sharpened_first_bound(row.h, theta);
                let second = self.second_bound(row.h, theta);
                let second = if theta <= 0.5 { second[0].min(second[1]) } else { f64::INFINITY };
                if pair.value > first.min(second) {
                    let [a, b] = pair.ends;
                    return Verdict::NotConfirmed(format!(
                        "h = {}, contact [{a}, 1 - {b}] exceeds a bound",
                        row.h
                    ));
                }
            }
        }
        Verdict::HoldsLoose(format!("h^{:.3} against the worst pair of an element", lost.abs()))
    }

    /// Bounds and worst cases over θ for one h.
    pub fn chart(&self, row: &BalanceRow) -> Chart {
        let h = row.h;
        let thetas: Vec<f64> = (2..=40).map(|k| 0.5f64.powf(0.25 * f64::from(k))).collect();
        let line =
            |f: &dyn Fn(f64) -> f64| -> Vec<(f64, f64)> { thetas.iter().map(|&t| (t, f(t))).collect() };
        let title = format!("One element, h = {h:.3e}, τ = {}", self.constants().tau());
        let y = Axis::logarithmic("∫σ(I^h u) per norms of σ_N and u_N'");
        let [low, high] = [row.worst.value, self.first_bound(h, 0.7).max(row.printed[1])];
        Chart::new(title, Axis::logarithmic("θ"), y)
            .with(Series::line("first case, printed (3.9)", line(&|t| self.first_bound(h, t))))
            .with(Series::line("second case, printed (3.14)", line(&|t| self.second_bound(h, t)[0])))
            .with(Series::dashed("first case, sharpened", line(&|t| self.sharpened_first_bound(h, t))))
            .with(Series::dashed("second case, corrected law", line(&|t| self.second_bound(h, t)[1])))
            .with(Series::points("true worst, first case", line(&|t| worst_of_cases(&row.pairs, t)[0])))
            .with(Series::line("true worst, second case", line(&|t| worst_of_cases(&row.pairs, t)[1])))
            .with(Series::dashed("printed θ", vec![(row.printed[0], 0.3 * low), (row.printed[0], high)]))
    }
}

fn table(rows: &[BalanceRow]) -> Table {
    let number = Format::Scientific(2);
    let mut table = Table::new(vec![
        Column::new("n", "1/h", Format::Plain, "length of the element"),
        Column::new("theta", "theta", number, "printed choice"),
        Column::new("bound", "B", number, "larger of both printed bounds there"),
        Column::new("crossing", "crossing", number, "theta at which the printed bounds agree"),
        Column::new("crossing_bound", "B cross", number, "both bounds there"),
        Column::new("sharp_crossing", "sharp", number, "theta at which the sharpened bounds agree"),
        Column::new("sharp_bound", "B sharp", number, "both bounds there"),
        Column::new(
            "first",
            "W first",
            number,
            "true worst case over contact sets of the first case, printed theta",
        ),
        Column::new("second", "W second", number, "the same, second case"),
        Column::new("worst", "W", number, "true worst case over all contact sets"),
        Column::new("place", "a", Format::Plain, "the worst contact set begins at a h"),
    ]);
    for row in rows {
        table.push(vec![
            (1.0 / row.h).into(),
            row.printed[0].into(),
            row.printed[1].into(),
            row.crossing[0].into(),
            row.crossing[1].into(),
            row.sharpened[0].into(),
            row.sharpened[1].into(),
            row.cases[0].into(),
            row.cases[1].into(),
            row.worst.value.into(),
            row.worst.ends[0].into(),
        ]);
    }
    table
}
