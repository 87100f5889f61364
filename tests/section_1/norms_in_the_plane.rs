//! Section 1 in the plane: closed form and both limits on another mesh and other orders.

#[allow(dead_code)]
#[path = "../../examples/section_1_norms_in_the_plane.rs"]
mod example;

use example_report::Verdict;

#[test]
fn the_norm_has_its_closed_form_and_its_limits() {
    for squares in [1, 3, 7] {
        let s = ["0.01", "0.37", "1/2-1e-10", "0.62", "0.9999999999"]
            .map(|s| s.parse().unwrap())
            .to_vec();
        let found =
            example::outcome(&example::Options { squares, s, ..Default::default() }).unwrap();
        assert!(
            found.status() == Verdict::True && found.checks().len() == 10,
            "{}",
            found.text(false)
        );
    }
}
