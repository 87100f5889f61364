//! The bound with numbers beside the error of problems of known solution: what decides, and the table.

use crate::{Cell, Column, Finding, Format, Table};
use experiments::proof::{NumberedRow, NumberedStudy};

/// Quadrature of the error.
const QUADRATURE: f64 = 1e-3;
/// From this tau on the bound should not be farther from the error than this.
const SHARP_FROM: f64 = 1.75;
const SHARP: f64 = 10.0;

/// The finding with the best quotient `of` the rows of the studies that are meant.
pub fn decided_by(
    finding: Finding,
    studies: &[NumberedStudy],
    is_meant: fn(&NumberedStudy) -> bool,
    of: fn(&NumberedRow) -> f64,
    better: fn(f64, f64) -> f64,
) -> Finding {
    let rows = studies.iter().filter(|study| is_meant(study)).flat_map(|study| &study.rows);
    let number = rows.map(of).reduce(better).map(|number| (number, QUADRATURE * number));
    finding.number_or(number, "no mesh")
}

/// Bound over error on a mesh.
pub fn effectivity(row: &NumberedRow) -> f64 {
    row.bound / row.error
}

/// Bound over error on every mesh, and from which tau on it is sharp.
pub fn numbered_findings(studies: &[NumberedStudy]) -> Vec<Finding> {
    let near = |row: &NumberedRow| row.near / row.error;
    let is_sharp = |study: &NumberedStudy| study.numbers.tau >= SHARP_FROM;
    let above = Finding::claim("above", "the bound is at least {value} times the error, on every mesh");
    let local = Finding::claim(
        "near",
        "with the interpolation error itself and the segment's norms, {value} times or more",
    );
    let sharp = Finding::claim("effectivity", "from tau = 1.75 on it is at most {value} times the error");
    let all = Finding::remark("all", "for every tau it is at most {value} times the error")
        .otherwise("over all tau it comes to {value} times the error, more than 10");
    vec![
        decided_by(above, studies, |_| true, effectivity, f64::min).at_least(1.0, "the error itself").told(),
        decided_by(local, studies, |_| true, near, f64::min).at_least(1.0, "the error itself"),
        decided_by(sharp, studies, is_sharp, effectivity, f64::max).at_most(SHARP, "effectivity 10").told(),
        decided_by(all, studies, |_| true, effectivity, f64::max).at_most(SHARP, "effectivity 10"),
    ]
}

/// Every mesh of every study; `constant` says what C(s) belongs to, `norm` how the error is measured.
pub fn numbered_table(studies: &[NumberedStudy], constant: &str, norm: &str) -> Table {
    let (number, two) = (Format::Scientific(3), Format::Fixed(2));
    let near = format!("from |u - I^h u|{norm} and the norms of the segment of the transition");
    let columns = vec![
        Column::new("tau", "tau", Format::Plain, ""),
        Column::words("cone", "cone", 8),
        Column::new("constant", "C(s)", Format::Fixed(5), constant),
        Column::new("segment", "K(nu)", Format::Fixed(5), "one segment"),
        Column::new("norm", "|u|_tau", Format::Fixed(4), "seminorm on a half disc that holds the square"),
        Column::new("n", "1/h", Format::Plain, "squares along each side"),
        Column::new("error", "error", number, format!("|u - u_h|{norm}")),
        Column::new("interpolation", "interp", number, format!("|u - I^h u|{norm}")),
        Column::new("bound", "bound", number, "from the norms of the body and the edge"),
        Column::new("effectivity", "bound/err", two, "effectivity"),
        Column::new("near", "near/err", two, near),
    ];
    Table::new(columns).with_rows(studies.iter().flat_map(|study| {
        let numbers = study.numbers;
        study.rows.iter().map(move |row| {
            let cone: Cell = study.cone.to_string().into();
            let known = [numbers.interpolation, numbers.segment, study.norm].map(Cell::from);
            let errors =
                [row.error, row.interpolation, row.bound, row.bound / row.error, row.near / row.error];
            let head = [numbers.tau.into(), cone];
            [head.as_slice(), &known, &[row.n.into()], &errors.map(Cell::from)].concat()
        })
    }))
}
