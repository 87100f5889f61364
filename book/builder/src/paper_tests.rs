//! Tests of the paper of figures.

use super::*;

#[test]
fn words_at_an_edge_get_room_and_others_leave_the_paper_as_it_is() {
    let paper = [0.0, 0.0, 640.0, 300.0];
    let at =
        |place: &str, words: &str| Sheet::of(&format!("<svg><text {place}>{words}</text></svg>"), paper).view;
    assert_eq!(at(r#"x="300" y="100""#, "in the middle"), paper);
    assert_eq!(at(r#"x="600" y="100""#, "<tspan>ten</tspan> 5678 t"), [0.0, 0.0, 721.0, 300.0]);
    assert_eq!(at(r#"x="10" y="100" text-anchor="end""#, "four"), [-47.0, 0.0, 687.0, 300.0]);
    assert_eq!(at(r#"x="10" y="100" text-anchor="middle""#, "four"), [-17.0, 0.0, 657.0, 300.0]);
    assert_eq!(at(r#"x="300" y="2""#, "w"), [0.0, -14.0, 640.0, 314.0]);
    assert_eq!(at(r#"x="300" y="2" transform="rotate(270)""#, "w"), paper);
    let fine = Sheet::of(r#"<text x="5500" y="900">four</text>"#, [0.0, 0.0, 6400.0, 3000.0]).view;
    assert_eq!(fine, [0.0, 0.0, 6400.0, 3000.0]);
    assert!(is_fine(fine) && !is_fine(paper));
}

#[test]
fn close_lines_get_smaller_letters_and_labels_of_an_axis_do_not_run_into_each_other() {
    let text = |x: u32, y: u32, anchor: &str| {
        format!("<text x=\"{x}\" y=\"{y}\" text-anchor=\"{anchor}\">0.07</text>")
    };
    let svg = [text(500, 100, "start"), text(500, 115, "start"), text(500, 140, "start")].concat();
    let crowd = Crowd::of(&svg, &[], LETTERS);
    let classes: Vec<_> = tags(&svg).filter(|t| t.name == "text").map(|t| crowd.class(t.start)).collect();
    assert_eq!(classes, [Some("dense"), Some("dense"), None]);
    let svg = [100, 130, 160, 190].map(|x| text(x, 200, "middle")).concat() + &text(110, 260, "middle");
    let crowd = Crowd::of(&svg, &[], LETTERS);
    let classes: Vec<_> = tags(&svg).filter(|t| t.name == "text").map(|t| crowd.class(t.start)).collect();
    assert_eq!(classes, [None, Some("spare"), None, Some("spare"), None]);
}

#[test]
fn wide_paper_gets_larger_letters_and_long_titles_two_lines() {
    let paper = [0.0, 0.0, 640.0, 300.0];
    let wide = Sheet::of(r#"<text x="600" y="100">names</text>"#, paper);
    assert!(wide.letters >= LEAST * wide.view[2] / NARROW && wide.letters < 22.0, "{wide:?}");
    assert_eq!(wide.style(), format!(r#" style="--letters:{}px""#, wide.letters));
    let title = "word ".repeat(14);
    let line = format!(r#"<text x="320" y="24" text-anchor="middle">{title}</text>"#);
    let sheet = |more: &str| Sheet::of(&(line.clone() + more), paper);
    let tag = tags(&line).next().unwrap();
    assert_eq!((sheet("").view, sheet("").style()), ([0.0, -13.0, 640.0, 313.0], String::new()));
    let cut = Cut { start: 0, at: tag.end + 34, y: (24.0 - 1.1 * LETTERS, 24.0) };
    assert_eq!(sheet("").cuts, [cut]);
    let other = r#"<text x="300" y="5">0.4</text>"#;
    assert_eq!(sheet(other).cuts, [Cut { y: (24.0, 24.0 + 1.1 * LETTERS), ..cut }]);
    assert!(Sheet::of(&line.replace("word w", "word<b>w"), paper).cuts.is_empty());
}

#[test]
fn frames_share_their_width_and_keep_their_height() {
    let frames = [r#"<svg viewBox="-10 0 650 300"/>"#, r#"<svg viewBox="0 0 660 320"/>"#, "<p/>"];
    let style = r#"style="--letters:20px""#;
    let same = ["300", "320"].map(|height| format!(r#"<svg viewBox="-10 0 670 {height}" {style}/>"#));
    assert_eq!(of_one_width(&frames), [same.as_slice(), &["<p/>".to_owned()]].concat());
}
