//! Paper of a figure: room for the larger letters of a phone.
//!
//! On a narrow screen `book/style/book.css` sets every word of a figure in letters of `LETTERS` parts of its
//! 640, so that they can be read there. Words near an edge would leave the paper; so it is made as large as
//! they will need, and all frames of a slider as wide as the widest. Lines of words close below each other
//! get smaller letters there (`DENSE`), and of words side by side that would run into each other some are
//! left out.

use crate::markup::{Tag, tags};

/// The size of letters on a narrow screen, in parts of paper 640 wide; the same number stands in the style.
const LETTERS: f64 = 19.0;
/// Letters of lines that are closer to each other than that.
const DENSE: f64 = 16.5;
/// Width of words over the size of letters: for each character, and once more, since few may all be wide.
const WIDTH: (f64, f64) = (0.47, 0.8);
/// Paper in parts of a tenth.
const FINE: f64 = 6400.0;

/// The view of a figure: left, top, width, height.
pub type View = [f64; 4];

/// Numbers of a `viewBox`.
pub fn view(text: &str) -> Option<View> {
    let numbers: Vec<f64> = text.split_whitespace().filter_map(|word| word.parse().ok()).collect();
    numbers.try_into().ok()
}

/// A view as the attribute has it.
pub fn written(view: View) -> String {
    view.map(|number| format!("{number:.0}")).join(" ")
}

/// Whether the figure is drawn in tenths, so that its letters are ten times as large.
pub fn is_fine(view: View) -> bool {
    view[2] >= FINE
}

/// Words of a figure.
struct Words {
    /// Where their tag begins in the text of the figure.
    start: usize,
    x: f64,
    y: f64,
    characters: usize,
    /// The part of their width that stands before x.
    before: f64,
    /// The part of their letters that stands below y.
    below: f64,
}

impl Words {
    fn width(&self, letters: f64) -> f64 {
        letters * (WIDTH.0 * self.characters as f64 + WIDTH.1)
    }
}

/// The words of a figure that are not turned.
fn words(svg: &str) -> Vec<Words> {
    let upright = tags(svg).filter(|tag| tag.name == "text" && tag.attribute("transform").is_none());
    let found = upright.filter_map(|tag| {
        let number = |name| tag.attribute(name).and_then(|value: &str| value.parse::<f64>().ok());
        let before = match tag.attribute("text-anchor") {
            Some("middle") => 0.5,
            Some("end") => 1.0,
            _ => 0.0,
        };
        // Words stand on their line, or are centred at it.
        let below = if tag.attribute("dy").is_some() { 0.6 } else { 0.3 };
        let characters = characters(svg, &tag);
        Some(Words { start: tag.start, x: number("x")?, y: number("y")?, characters, before, below })
    });
    found.filter(|words| words.characters > 0).collect()
}

/// Words that need another style on a narrow screen, by where their tags begin.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Crowd {
    /// Lines close to each other.
    pub dense: Vec<usize>,
    /// Words left out.
    pub spare: Vec<usize>,
}

impl Crowd {
    /// Those of a figure.
    pub fn of(svg: &str, view: View) -> Self {
        let (letters, all) = (letters(view), words(svg));
        let is_close = |a: &Words, b: &Words| a.x == b.x && a.y != b.y && (a.y - b.y).abs() < 0.95 * letters;
        let dense = all.iter().filter(|a| all.iter().any(|b| is_close(a, b)));
        // Along a line only labels of an axis stand one after the other.
        let mut row: Vec<&Words> = all.iter().filter(|words| words.before == 0.5).collect();
        row.sort_by(|a, b| a.y.total_cmp(&b.y).then(a.x.total_cmp(&b.x)));
        let mut spare = Vec::new();
        let mut last: Option<&Words> = None;
        for words in row {
            let is_free = |kept: &Words| {
                kept.y != words.y || words.x - kept.x >= 0.45 * (kept.width(letters) + words.width(letters))
            };
            if last.is_none_or(is_free) {
                last = Some(words);
            } else {
                spare.push(words.start);
            }
        }
        Self { dense: dense.map(|words| words.start).collect(), spare }
    }

    /// The class of the words whose tag begins there.
    pub fn class(&self, start: usize) -> Option<&'static str> {
        let is_in = |list: &[usize]| list.contains(&start);
        is_in(&self.spare).then_some("spare").or(is_in(&self.dense).then_some("dense"))
    }
}

/// The size of letters of a figure.
fn letters(view: View) -> f64 {
    if is_fine(view) { 10.0 * LETTERS } else { LETTERS }
}

/// The view that holds all words of a figure in large letters.
pub fn room(svg: &str, view: View) -> View {
    let crowd = Crowd::of(svg, view);
    let [mut left, mut top, width, height] = view;
    let (mut right, mut bottom) = (left + width, top + height);
    for words in words(svg) {
        let dense = if crowd.dense.contains(&words.start) { DENSE / LETTERS } else { 1.0 };
        let letters = dense * letters(view);
        let wide = words.width(letters);
        left = left.min(words.x - words.before * wide);
        right = right.max(words.x + (1.0 - words.before) * wide);
        top = top.min(words.y - (1.1 - words.below) * letters);
        bottom = bottom.max(words.y + words.below * letters);
    }
    [left.floor(), top.floor(), (right - left).ceil(), (bottom - top).ceil()]
}

/// Characters of a text, without the tags in it.
fn characters(svg: &str, tag: &Tag<'_>) -> usize {
    let text = svg[tag.end..].split("</text>").next().unwrap_or("").trim();
    let mut is_tag = false;
    text.chars()
        .filter(|&c| {
            is_tag = c == '<' || is_tag && c != '>';
            !is_tag && c != '>'
        })
        .count()
}

/// Figures one after the other on paper of one width.
pub fn of_one_width(svgs: &[&str]) -> Vec<String> {
    let attribute = |svg: &str| tags(svg).next().and_then(|tag| tag.attribute("viewBox").map(str::to_owned));
    let views: Vec<Option<(String, View)>> =
        svgs.iter().map(|svg| attribute(svg).and_then(|text| Some((text.clone(), view(&text)?)))).collect();
    let all = || views.iter().flatten().map(|(_, view)| view);
    let left = all().map(|view| view[0]).fold(f64::INFINITY, f64::min);
    let right = all().map(|view| view[0] + view[2]).fold(f64::NEG_INFINITY, f64::max);
    let same = |(svg, found): (&&str, &Option<(String, View)>)| match found {
        Some((text, [_, top, _, height])) => {
            svg.replacen(text.as_str(), &written([left, *top, right - left, *height]), 1)
        }
        None => (*svg).to_owned(),
    };
    svgs.iter().zip(&views).map(same).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_at_an_edge_get_room_and_others_leave_the_paper_as_it_is() {
        let paper = [0.0, 0.0, 640.0, 300.0];
        let at = |place: &str, words: &str| room(&format!("<svg><text {place}>{words}</text></svg>"), paper);
        assert_eq!(at(r#"x="300" y="100""#, "in the middle"), paper);
        assert_eq!(at(r#"x="600" y="100""#, "<tspan>ten</tspan> 5678 t"), [0.0, 0.0, 705.0, 300.0]);
        assert_eq!(at(r#"x="10" y="100" text-anchor="end""#, "four"), [-41.0, 0.0, 681.0, 300.0]);
        assert_eq!(at(r#"x="10" y="100" text-anchor="middle""#, "four"), [-16.0, 0.0, 656.0, 300.0]);
        assert_eq!(at(r#"x="300" y="2""#, "w"), [0.0, -14.0, 640.0, 314.0]);
        assert_eq!(at(r#"x="300" y="2" transform="rotate(270)""#, "w"), paper);
        let fine = room(r#"<text x="5500" y="900">four</text>"#, [0.0, 0.0, 6400.0, 3000.0]);
        assert_eq!(fine, [0.0, 0.0, 6400.0, 3000.0]);
        assert!(is_fine(fine) && !is_fine(paper));
    }

    #[test]
    fn close_lines_get_smaller_letters_and_labels_of_an_axis_do_not_run_into_each_other() {
        let view = [0.0, 0.0, 640.0, 300.0];
        let text = |x: u32, y: u32, anchor: &str| {
            format!("<text x=\"{x}\" y=\"{y}\" text-anchor=\"{anchor}\">0.07</text>")
        };
        let svg = [text(500, 100, "start"), text(500, 115, "start"), text(500, 140, "start")].concat();
        let crowd = Crowd::of(&svg, view);
        let classes: Vec<_> = tags(&svg).filter(|t| t.name == "text").map(|t| crowd.class(t.start)).collect();
        assert_eq!(classes, [Some("dense"), Some("dense"), None]);
        let svg = [100, 130, 160, 190].map(|x| text(x, 200, "middle")).concat() + &text(110, 260, "middle");
        let crowd = Crowd::of(&svg, view);
        let classes: Vec<_> = tags(&svg).filter(|t| t.name == "text").map(|t| crowd.class(t.start)).collect();
        assert_eq!(classes, [None, Some("spare"), None, Some("spare"), None]);
    }

    #[test]
    fn frames_share_their_width_and_keep_their_height() {
        let frames = [r#"<svg viewBox="-10 0 650 300"/>"#, r#"<svg viewBox="0 0 660 320"/>"#, "<p/>"];
        let same = [r#"<svg viewBox="-10 0 670 300"/>"#, r#"<svg viewBox="-10 0 670 320"/>"#, "<p/>"];
        assert_eq!(of_one_width(&frames), same);
    }
}
