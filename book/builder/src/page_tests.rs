use super::*;
use crate::data::{Data, parse_object};
use std::path::Path;
use std::path::PathBuf;

fn page(name: &str, text: &str) -> Page {
    Page { file: PathBuf::from(format!("{name}.md")), html: format!("{name}.html"), text: text.to_owned() }
}

fn data() -> Data {
    let text = r#"{"ex": {"values": {"gamma": 0.5}, "verdict": "a < b", "columns": [], "rows": []}}"#;
    Data { examples: parse_object(Path::new("test"), text).unwrap(), ..Data::default() }
}

fn marked(pages: &[Page]) -> Result<Marked, Vec<Fault>> {
    let none = Path::new("none");
    mark(pages, &Sources { data: &data(), examples: none, tests: none, ideas: none, allowed: &[] })
}

#[test]
fn marks_survive_and_are_replaced() {
    let pages = [
        page("one", "So $x_1$ is {{value:gamma}} and {{verdict:ex}}.\n\n{{table:ex}}\n\nSee $\\eqref{far}$."),
        page("two", "$$\n\\begin{equation} y \\label{far} \\end{equation}\n$$"),
    ];
    let marked = marked(&pages).unwrap();
    assert!(!marked.texts[0].contains('$'));
    let built = format!("<p>{}</p>", marked.texts[0].replace("\n\n", "</p><p>"));
    let html = marked.unmark("one.html", &built).unwrap();
    assert!(html.contains("<msub><mi>x</mi><mn>1</mn></msub>"), "{html}");
    assert!(html.contains("is 0.5000 and a &lt; b."), "{html}");
    assert!(html.contains("</p><div class=\"table-wrapper\">"), "{html}");
    assert!(html.contains("href=\"two.html#far\""), "{html}");
    assert!(marked.unmark("print.html", &built).unwrap().contains("href=\"#far\""));
}

#[test]
fn quotation_marks_are_no_part_of_a_formula() {
    let marked = marked(&[page("p", "> so\n>\n> $$\n> x\n> $$\n>\n> $a > b$")]).unwrap();
    assert_eq!(marked.texts[0], "> so\n>\n> \u{E000}0\u{E001}\n>\n> \u{E000}1\u{E001}");
    let html = marked.unmark("p.html", &marked.texts[0]).unwrap();
    assert!(html.contains("<math display=\"block\"><mi>x</mi></math>"), "{html}");
    assert!(html.contains("<mo>&gt;</mo>"), "{html}");
}

#[test]
fn link_targets_and_code_may_hold_decimals() {
    let text = "[a](file-1.5.md) `0.25` <span style=\"width:0.5em\">x</span>";
    assert!(marked(&[page("p", text)]).is_ok());
}
