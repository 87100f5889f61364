//! Just enough of PDF, as a browser writes it, to find the pages of the places that links lead to: a table of
//! cross-references with fixed entries and objects in plain text. Anything else has no answer.

use std::collections::BTreeMap;

/// The number of the page, from one, of every named place; none where the file is built otherwise.
pub fn pages(file: &[u8]) -> Option<BTreeMap<String, usize>> {
    let objects = Objects::read(file)?;
    let root = objects.get(reference(&objects.trailer, "/Root ")?)?;
    let mut order = Vec::new();
    objects.push_pages(reference(&root, "/Pages ")?, &mut order, 0);
    let dests = objects.get(reference(&root, "/Dests ")?)?;
    let mut places = BTreeMap::new();
    for entry in dests.split(']') {
        let Some((name, target)) = entry.split_once('[') else { continue };
        let name = name.trim().trim_start_matches("<<").trim().strip_prefix('/')?;
        let page: usize = target.split_whitespace().next()?.parse().ok()?;
        let at = order.iter().position(|&other| other == page)?;
        places.insert(unescaped(name.trim()), at + 1);
    }
    Some(places)
}

/// The objects of a file by their offsets.
struct Objects<'a> {
    file: &'a [u8],
    offsets: Vec<usize>,
    trailer: String,
}

impl<'a> Objects<'a> {
    fn read(file: &'a [u8]) -> Option<Self> {
        let end = last(file, b"startxref")?;
        let start: usize = text(file, end)?.split_whitespace().nth(1)?.parse().ok()?;
        let table = text(file, start)?;
        let (entries, trailer) = table.split_once("trailer")?;
        let mut words = entries.split_whitespace();
        if (words.next(), words.next()) != (Some("xref"), Some("0")) {
            return None;
        }
        let count: usize = words.next()?.parse().ok()?;
        let offsets: Vec<usize> = words.step_by(3).map_while(|word| word.parse().ok()).collect();
        (offsets.len() == count).then(|| Self { file, offsets, trailer: trailer.to_owned() })
    }

    /// The text of an object.
    fn get(&self, number: usize) -> Option<String> {
        let at = *self.offsets.get(number)?;
        let rest = self.file.get(at..)?;
        let end = rest.windows(6).position(|word| word == b"endobj")?;
        let object = String::from_utf8_lossy(&rest[..end]).into_owned();
        object.strip_prefix(&format!("{number} 0 obj")).map(str::to_owned)
    }

    /// The pages below a node of the tree of pages, in order.
    fn push_pages(&self, number: usize, order: &mut Vec<usize>, depth: usize) {
        let Some(node) = self.get(number).filter(|_| depth < 32) else { return };
        match node.split_once("/Kids [").and_then(|(_, rest)| rest.split_once(']')) {
            Some((kids, _)) => {
                let numbers = kids.split_whitespace().step_by(3).filter_map(|word| word.parse().ok());
                numbers.for_each(|kid| self.push_pages(kid, order, depth + 1));
            }
            None => order.push(number),
        }
    }
}

/// The number behind a key, `/Root 7 0 R`.
fn reference(object: &str, key: &str) -> Option<usize> {
    object.split_once(key)?.1.split_whitespace().next()?.parse().ok()
}

fn text(file: &[u8], at: usize) -> Option<String> {
    file.get(at..).map(|rest| String::from_utf8_lossy(rest).into_owned())
}

fn last(file: &[u8], word: &[u8]) -> Option<usize> {
    file.windows(word.len()).rposition(|other| other == word)
}

/// A name with its characters: `#C3#A9` is é.
fn unescaped(name: &str) -> String {
    let mut bytes = Vec::new();
    let mut rest = name.as_bytes();
    while let Some((&first, behind)) = rest.split_first() {
        let code =
            behind.get(..2).and_then(|two| u8::from_str_radix(std::str::from_utf8(two).ok()?, 16).ok());
        match code.filter(|_| first == b'#') {
            Some(byte) => {
                bytes.push(byte);
                rest = &behind[2..];
            }
            None => {
                bytes.push(first);
                rest = behind;
            }
        }
    }
    String::from_utf8_lossy(&bytes).into_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A file of three pages in a tree of two levels.
    fn file() -> Vec<u8> {
        let objects = [
            "<</Type /Catalog\n/Pages 2 0 R\n/Dests 7 0 R>>",
            "<</Type /Pages /Count 3 /Kids [3 0 R 6 0 R]>>",
            "<</Type /Pages /Count 2 /Kids [4 0 R 5 0 R]>>",
            "<</Type /Page>>",
            "<</Type /Page>>",
            "<</Type /Page>>",
            "<</one [4 0 R /XYZ 0 1 0]\n/caf#C3#A9 [6 0 R /XYZ 0 1 0]\n/one-2 [5 0 R /XYZ 0 1 0]>>",
        ];
        let mut file = "%PDF-1.4\n".to_owned();
        let mut table = format!("xref\n0 {}\n0000000000 65535 f \n", objects.len() + 1);
        for (k, object) in objects.iter().enumerate() {
            table += &format!("{:010} 00000 n \n", file.len());
            file += &format!("{} 0 obj\n{object}\nendobj\n", k + 1);
        }
        let start = file.len();
        format!("{file}{table}trailer\n<</Size 8\n/Root 1 0 R>>\nstartxref\n{start}\n%%EOF").into_bytes()
    }

    #[test]
    fn places_have_the_numbers_of_their_pages() {
        let found = pages(&file()).unwrap();
        let expected = [("one", 1), ("one-2", 2), ("café", 3)].map(|(name, page)| (name.to_owned(), page));
        assert_eq!(found, expected.into());
    }

    #[test]
    fn another_kind_of_file_has_no_answer() {
        let file = file();
        for cut in 0..file.len() - 5 {
            let _ = pages(&file[..cut]);
        }
        assert_eq!(pages(&file[..file.len() - 30]), None);
        assert_eq!(pages(b"no pdf"), None);
        assert_eq!(pages(b"startxref 99999999"), None);
    }
}
