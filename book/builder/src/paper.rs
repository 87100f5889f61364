//! Paper of a figure: room for the larger letters of a phone.
//!
//! On a narrow screen `book/style/book.css` sets every word of a figure in letters of `LETTERS` parts of its
//! 640, so that they can be read there. Words near an edge would leave the paper; so it is made as large as
//! they will need, and all frames of a slider as wide as the widest. Where that makes letters less than
//! `LEAST` pixels high they get larger ones, `--letters` of the figure. Long titles stand in two lines there,
//! lines of words close below each other get smaller letters (`DENSE`), and of words side by side that would
//! run into each other some are left out.

use crate::markup::{Tag, tags};

/// The size of letters on a narrow screen, in parts of paper 640 wide; the same number stands in the style.
const LETTERS: f64 = 19.0;
/// Letters of lines that are closer to each other than that, over the others.
const DENSE: f64 = 16.5 / 19.0;
/// The least size of letters, and the width of a figure, on a narrow screen, in pixels.
const LEAST: f64 = 11.1;
const NARROW: f64 = 374.0;
/// Characters of a centred line that a narrow screen has room for.
const LINE: usize = 66;
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
#[derive(Clone, Copy)]
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

    /// Whether others stand above, below or in them, in two lines.
    fn meets(&self, other: &Self, letters: f64) -> bool {
        let (wide, half) = (self.width(letters), 0.5 * other.width(letters));
        let left = self.x - self.before * wide;
        left < other.x + 0.5 * half && left + wide > other.x - 0.5 * half
    }
}

/// Words in one line on a wide screen, in two on a narrow one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cut {
    /// Where their tag begins in the text of the figure.
    pub start: usize,
    /// Where the second line begins.
    pub at: usize,
    /// The heights of both lines.
    pub y: (f64, f64),
}

/// Centred words that are long and have no tags in them, cut at the blank nearest to their middle: one of the
/// lines keeps its place; the other stands below it, above it at the top, or where no words are.
fn cuts(svg: &str, top: f64, letters: f64) -> Vec<Cut> {
    let all = words(svg, &[]);
    let long = |tag: &Tag<'_>| tag.attribute("text-anchor") == Some("middle") && tag.name == "text";
    let found = tags(svg).filter(long).filter_map(|tag| {
        let text = svg[tag.end..].split("</text>").next()?;
        let here = all.iter().find(|words| words.start == tag.start)?;
        if here.characters <= LINE || text.contains('<') {
            return None;
        }
        let start = text.len() - text.trim_start().len();
        let middle =
            |&(at, _): &(usize, char)| (2 * text[start..at].chars().count()).abs_diff(here.characters);
        let blanks = text.char_indices().filter(|&(at, c)| c == ' ' && at > start);
        let at = tag.end + blanks.min_by_key(middle)?.0;
        let is_free = |y: f64| {
            let meets = |other: &&Words| (other.y - y).abs() < letters && other.meets(here, letters);
            !all.iter().filter(|other| other.start != here.start).any(|other| meets(&other))
        };
        let (above, below) = (here.y - 1.1 * letters, here.y + 1.1 * letters);
        let mut places = [(above, (above, here.y)), (below, (here.y, below))];
        if here.y > top {
            places.reverse();
        }
        let free = places.into_iter().find(|(y, _)| is_free(*y));
        free.map(|(_, y)| Cut { start: tag.start, at, y })
    });
    found.collect()
}

/// The words of a figure that are not turned.
fn words(svg: &str, cuts: &[Cut]) -> Vec<Words> {
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
        let (x, y, characters) = (number("x")?, number("y")?, characters(svg, &tag));
        Some(Words { start: tag.start, x, y, characters, before, below })
    });
    let in_lines = |words: Words| match cuts.iter().find(|cut| cut.start == words.start) {
        // Of two lines the longer one is about half.
        Some(Cut { y, .. }) => {
            let line = |y| Words { y, characters: words.characters / 2 + 1, ..words };
            vec![line(y.0), line(y.1)]
        }
        None => vec![words],
    };
    let found = found.flat_map(in_lines);
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
    /// Those of a figure with letters of this size.
    fn of(svg: &str, cuts: &[Cut], letters: f64) -> Self {
        let all = words(svg, cuts);
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

/// A figure on paper with room for the letters of a narrow screen.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Sheet {
    /// The paper.
    pub view: View,
    /// Letters of a narrow screen.
    pub letters: f64,
    /// Words with another style.
    pub crowd: Crowd,
    /// Words in two lines.
    pub cuts: Vec<Cut>,
}

impl Sheet {
    /// Letters of the size of the style, or larger ones where the paper is so wide that they would be small.
    pub fn of(svg: &str, view: View) -> Self {
        let scale = if is_fine(view) { 10.0 } else { 1.0 };
        let at = |letters: f64| {
            let cuts = cuts(svg, view[1] + 0.2 * view[3], letters);
            let crowd = Crowd::of(svg, &cuts, letters);
            Self { view: room(&words(svg, &cuts), view, &crowd, letters), letters, crowd, cuts }
        };
        // Larger letters need more paper, which makes them smaller: a few rounds come close enough.
        (0..8).fold(at(scale * LETTERS), |sheet, _| {
            let least = least(sheet.view[2]);
            if sheet.letters < least { at(least.ceil()) } else { sheet }
        })
    }

    /// The attribute that sets letters larger than those of the style.
    pub fn style(&self) -> String {
        let usual = if is_fine(self.view) { 10.0 * LETTERS } else { LETTERS };
        style(self.letters, usual)
    }
}

fn style(letters: f64, usual: f64) -> String {
    if letters > usual { format!(r#" style="--letters:{letters:.0}px""#) } else { String::new() }
}

/// The least letters on paper of this width.
fn least(width: f64) -> f64 {
    LEAST * width / NARROW
}

/// The view that holds all words of a figure in letters of this size.
fn room(words: &[Words], view: View, crowd: &Crowd, letters: f64) -> View {
    let [mut left, mut top, width, height] = view;
    let (mut right, mut bottom) = (left + width, top + height);
    for words in words {
        let letters = if crowd.dense.contains(&words.start) { DENSE * letters } else { letters };
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

/// Figures one after the other on paper of one width, with the letters that it needs.
pub fn of_one_width(svgs: &[&str]) -> Vec<String> {
    let attribute = |svg: &str| tags(svg).next().and_then(|tag| tag.attribute("viewBox").map(str::to_owned));
    let views: Vec<Option<(String, View)>> =
        svgs.iter().map(|svg| attribute(svg).and_then(|text| Some((text.clone(), view(&text)?)))).collect();
    let all = || views.iter().flatten().map(|(_, view)| view);
    let left = all().map(|view| view[0]).fold(f64::INFINITY, f64::min);
    let right = all().map(|view| view[0] + view[2]).fold(f64::NEG_INFINITY, f64::max);
    let same = |(svg, found): (&&str, &Option<(String, View)>)| match found {
        Some((text, [_, top, _, height])) => {
            let wide = [left, *top, right - left, *height];
            let usual = if is_fine(wide) { 10.0 * LETTERS } else { LETTERS };
            let old = tags(svg).next().and_then(|tag| tag.attribute("style").map(str::to_owned));
            let bare =
                old.map_or((*svg).to_owned(), |old| svg.replacen(&format!(r#" style="{old}""#), "", 1));
            let set = format!(r#""{}"{}"#, written(wide), style(least(right - left).ceil(), usual));
            bare.replacen(&format!(r#""{text}""#), &set, 1)
        }
        None => (*svg).to_owned(),
    };
    svgs.iter().zip(&views).map(same).collect()
}

#[cfg(test)]
#[path = "paper_tests.rs"]
mod tests;
