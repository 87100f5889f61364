//! The example `remark_6_point_condition` confirms its statement.

#[path = "../examples/remark_6_point_condition.rs"]
#[allow(dead_code)]
mod example;

#[test]
fn statement_is_confirmed() {
    let headline = example::run(&example::Options::default()).unwrap();
    assert!(headline.verdict.is_confirmed(), "{headline}");
}
