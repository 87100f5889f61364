//! A bad entry of a list is named by its index and its value, wherever the toolkit takes lists.

use fractional_sobolev::{Curve, Error, Function, Gram, Load, Mesh, Result, Triangles, Zones};

/// (index, value) that the error names, in its fields and in its words.
fn named(result: Result<()>) -> (usize, f64) {
    let error = result.unwrap_err();
    let text = error.to_string();
    match error {
        Error::NotFinite { index, value, .. } | Error::EntryOutOfRange { index, value, .. } => {
            assert!(
                text.contains(&format!("index {index}")) && text.contains(&value.to_string()),
                "{text}"
            );
            (index, value)
        }
        other => panic!("{other}"),
    }
}

/// A closed curve with two elements on every side.
fn polygon(vertices: &[[f64; 2]]) -> Result<()> {
    Curve::closed(vertices, &vec![two(); vertices.len()]).map(drop)
}

fn two() -> Mesh {
    Mesh::uniform(2, 1.0).unwrap()
}

#[test]
fn entries_that_are_no_numbers_are_named() {
    let nan = f64::NAN;
    let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    let curve = || Curve::algebraic(&square, 2, 1.0).unwrap();
    let triangles = || Triangles::new(&[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]], &[[0, 1, 2]]).unwrap();
    let mut values = [0.0; 8];
    values[5] = nan;
    let found = [
        (1, Mesh::from_nodes(&[0.0, nan, 1.0]).map(drop)),
        (1, Mesh::from_lengths(&[1.0, nan]).map(drop)),
        (2, Function::linears(&two(), &[0.0, 1.0, nan]).map(drop)),
        (0, Function::piecewise(&two(), 0, &[nan, 1.0]).map(drop)),
        (2, Function::piecewise(&two(), 1, [[0.0, 1.0], [nan, 1.0]].as_flattened()).map(drop)),
        (1, Load::new(&two(), &[0.0, nan, 1.0]).map(drop)),
        (2, Gram::new(&two(), 0.5, 1e-8).unwrap().apply(&[0.0, 0.0, nan]).map(drop)),
        (1, Function::from_fn(&[0.0, nan, 1.0], |x| x).map(drop)),
        (5, Function::on_curve(&curve(), 1, &values).map(drop)),
        (5, Function::on_curve(&curve(), 0, &values).map(drop)),
        (2, Function::on_triangles(&triangles(), 1, &[0.0, 0.0, nan]).map(drop)),
        (2, polygon(&[[0.0, 0.0], [1.0, 0.0], [1.0, nan]])),
        (1, Zones::union(&[0.1..0.2, nan..0.1]).map(drop)),
        (1, Zones::union(&[0.1..0.2, 0.5..nan]).map(drop)),
    ];
    for (k, (index, result)) in found.into_iter().enumerate() {
        let (at, value) = named(result);
        assert!(at == index && value.is_nan(), "case {k}: {at}, {value}");
    }
}

#[test]
fn entries_that_are_out_of_range_are_named() {
    let found = [
        (2, 0.5, Mesh::from_nodes(&[0.0, 0.5, 0.5, 1.0]).map(drop)),
        (1, -1.0, Mesh::from_lengths(&[1.0, -1.0, 1.0]).map(drop)),
        (2, 0.2, Mesh::graded(&[0.0, 0.5, 0.2, 1.0], 3, 0.5).map(drop)),
        (2, 0.2, Function::from_fn(&[0.0, 0.3, 0.2, 1.0], |x| x).map(drop)),
        (1, 0.3, Zones::union(&[0.1..0.4, 0.3..0.4]).map(drop)),
        (1, -0.2, Zones::from_lengths(&[0.1, 0.1, 0.1, -0.2]).map(drop)),
        (1, 0.0, polygon(&[[0.0, 0.0], [1.0, 0.0], [1.0, 0.0], [0.0, 1.0]])),
        (2, 0.0, polygon(&[[0.0, 0.0], [0.0, 1.0], [1.0, 1.0], [0.5, 1.0]])),
        (0, 0.0, polygon(&[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [2.0, 0.0]])),
        (3, f64::INFINITY, polygon(&[[-1e308, 0.0], [0.0, 0.0], [0.0, 1.0], [1e308, 0.0]])),
    ];
    for (k, (index, value, result)) in found.into_iter().enumerate() {
        assert_eq!(named(result), (index, value), "case {k}");
    }
}

#[test]
fn lengths_of_lists_are_named_with_what_was_expected() {
    let short = Function::linears(&two(), &[0.0]).unwrap_err();
    assert_eq!(short.to_string(), "nodal values: length 1, expected 3");
    assert!(matches!(
        Load::new(&two(), &[0.0]),
        Err(Error::LengthMismatch { given: 1, expected: 3, .. })
    ));
    assert!(matches!(Mesh::uniform(3, -1.0), Err(Error::OutOfRange { value: -1.0, .. })));
}
