//! The example `remark_7_zone_location` confirms its statement.

#[path = "../examples/remark_7_zone_location.rs"]
#[allow(dead_code)]
mod example;

#[test]
fn statement_is_confirmed() {
    let headline = example::run(&example::Options::default()).unwrap();
    assert!(headline.verdict.is_confirmed(), "{headline}");
}
