//! Section 1, (1.1): Gram matrices of |·|_ν against 40-digit references, entry by entry.

use fractional_sobolev::{Error, Gram, Mesh, Order};
use nalgebra::DMatrix;
use serde_json::Value;

/// Required of every entry: the closed forms lose at most a hundred ulps.
const ENTRY_TOLERANCE: f64 = 1e-12;
/// Row sums against the row's absolute sum: rounding of the entries, 1e-15 each.
const ROW_SUM_TOLERANCE: f64 = 1e-13;

fn cases() -> Vec<Value> {
    let text = include_str!("../reference/gram_reference.json");
    let data: Value = serde_json::from_str(text).unwrap();
    data["cases"].as_array().unwrap().clone()
}

/// A binary64 from its hexadecimal form.
fn from_hex(value: &Value) -> f64 {
    let body = value.as_str().unwrap().strip_prefix("0x").unwrap();
    let (mantissa, exponent) = body.split_once('p').unwrap();
    let whole = u64::from_str_radix(&mantissa.replace('.', ""), 16).unwrap() as f64;
    let fraction_bits = 4 * (mantissa.len() - 2) as i32;
    whole * 2f64.powi(-fraction_bits) * 2f64.powi(exponent.parse().unwrap())
}

fn mesh_and_order(case: &Value) -> (Mesh, Order) {
    let nodes: Vec<f64> = case["nodes_hex"].as_array().unwrap().iter().map(from_hex).collect();
    (Mesh::from_nodes(&nodes).unwrap(), Order::new(from_hex(&case["nu_hex"])).unwrap())
}

fn check_entries(case: &Value, key: &str, matrix: &DMatrix<f64>) {
    for (i, row) in case[key].as_array().unwrap().iter().enumerate() {
        for (j, entry) in row.as_array().unwrap().iter().enumerate() {
            let exact: f64 = entry.as_str().unwrap().parse().unwrap();
            let value = matrix[(i, j)];
            let error = ((value - exact) / exact).abs();
            assert!(
                error <= ENTRY_TOLERANCE,
                "{key} {} nu {} entry {i},{j}: {value:e} against {exact:e}, error {error:e} > {ENTRY_TOLERANCE:e}",
                case["mesh"],
                case["nu_f64"]
            );
        }
    }
}

fn check_row_sums(what: &str, matrix: &DMatrix<f64>) {
    for i in 0..matrix.nrows() {
        let row: Vec<f64> = (0..matrix.ncols()).map(|j| matrix[(i, j)]).collect();
        let (sum, scale) = (row.iter().sum::<f64>(), row.iter().map(|a| a.abs()).sum::<f64>());
        assert!(
            sum.abs() <= ROW_SUM_TOLERANCE * scale,
            "{what} row {i}: sum {sum:e}, scale {scale:e}"
        );
    }
}

#[test]
fn entries_of_linears_have_twelve_digits_on_every_mesh() {
    for case in cases() {
        let (partition, order) = mesh_and_order(&case);
        let matrix = Gram::new(&partition, order, 1e-8).unwrap().to_dense().unwrap();
        check_entries(&case, "P1", &matrix);
        check_row_sums(&format!("P1 {} nu {order}", case["mesh"]), &matrix);
    }
}

#[test]
fn entries_of_constants_have_twelve_digits_on_every_mesh() {
    let mut checked = 0;
    for case in cases().iter().filter(|case| !case["P0"].is_null()) {
        let (partition, order) = mesh_and_order(case);
        let matrix = Gram::constants(&partition, order, 1e-8).unwrap().to_dense().unwrap();
        check_entries(case, "P0", &matrix);
        check_row_sums(&format!("P0 {} nu {order}", case["mesh"]), &matrix);
        checked += 1;
    }
    assert!(checked >= 16, "{checked}");
}

#[test]
fn constants_have_no_seminorm_from_one_half_on() {
    let partition = Mesh::uniform(3, 1.0).unwrap();
    let outcome = Gram::constants(&partition, Order::HALF, 1e-8);
    assert!(matches!(outcome, Err(Error::InfiniteNorm { .. })), "{outcome:?}");
}
