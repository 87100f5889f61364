//! The bytes of a Gmsh file: lines of text with their numbers, and the records of a section, in text or in binary.

use crate::error::{Error, Result};
use crate::text::quoted;
use std::borrow::Cow;
use std::str::FromStr;

const FORMAT: &str = "msh";

/// How the numbers of the sections of a binary file are stored.
#[derive(Debug, Clone, Copy)]
struct Binary {
    /// Whether the bytes of a number are in the other order than on this machine.
    swapped: bool,
    /// Bytes of a count or a tag of format 4.
    size: usize,
}

pub(super) struct Source<'a> {
    bytes: &'a [u8],
    /// The next byte to be read.
    at: usize,
    /// The number of the line read last, from 1.
    line: usize,
    /// What is left of the record, in text.
    record: &'a [u8],
    binary: Option<Binary>,
}

impl<'a> Source<'a> {
    /// The file with these bytes; a byte-order mark of UTF-8 is skipped.
    pub(super) fn of(bytes: &'a [u8]) -> Self {
        let at = if bytes.starts_with(b"\xef\xbb\xbf") { 3 } else { 0 };
        Self { bytes, at, line: 0, record: &[], binary: None }
    }

    /// The numbers of all sections that follow are binary: counts have `size` bytes. The first one is 1.
    pub(super) fn begin_binary(&mut self, size: usize) -> Result<()> {
        let bad = || Err(self.fault(&format!("the size of numbers is {size}, expected 4 or 8")));
        if size != 4 && size != 8 {
            return bad();
        }
        let one: [u8; 4] = self.take()?;
        let swapped = match i32::from_ne_bytes(one) {
            1 => false,
            0x0100_0000 => true,
            _ => return Err(self.fault("a binary file must begin with the number 1")),
        };
        self.binary = Some(Binary { swapped, size });
        Ok(())
    }

    pub(super) fn is_binary(&self) -> bool {
        self.binary.is_some()
    }

    /// The place that errors name: the number of the line, in a binary file that of the byte.
    pub(super) fn place(&self) -> usize {
        if self.binary.is_some() { self.at } else { self.line }
    }

    /// The next line that is not blank.
    fn line(&mut self) -> Option<&'a [u8]> {
        while self.at < self.bytes.len() {
            let rest = &self.bytes[self.at..];
            let length = rest.iter().position(|&byte| byte == b'\n').unwrap_or(rest.len());
            self.at = (self.at + length + 1).min(self.bytes.len());
            self.line += 1;
            let line = rest[..length].trim_ascii();
            if !line.is_empty() {
                return Some(line);
            }
        }
        None
    }

    /// The next line that is not blank as text; bytes that are not UTF-8 become U+FFFD.
    pub(super) fn next_line(&mut self) -> Result<Cow<'a, str>> {
        let line = self.line().ok_or_else(|| self.fault("unexpected end of file"))?;
        Ok(String::from_utf8_lossy(line))
    }

    /// The next line that is not blank, without reading it.
    pub(super) fn first_line(&self) -> Cow<'a, str> {
        let mut copy = Source { record: &[], binary: None, ..*self };
        copy.line().map_or(Cow::Borrowed(""), String::from_utf8_lossy)
    }

    /// The header of the next section; `None` at the end of the file.
    pub(super) fn next_header(&mut self) -> Result<Option<Cow<'a, str>>> {
        let Some(line) = self.line().map(String::from_utf8_lossy) else { return Ok(None) };
        if line.starts_with('$') && !line.starts_with("$End") {
            return Ok(Some(line));
        }
        Err(self.fault(&format!("expected the beginning of a section, found {}", quoted(&line))))
    }

    pub(super) fn skip_section(&mut self, header: &str) -> Result<()> {
        let end = header.replacen('$', "$End", 1);
        let begin = (self.at, self.line);
        if self.binary.is_some() {
            // Numbers may hold any byte, so the end need not be a line of its own.
            let found =
                self.bytes[self.at..].windows(end.len()).position(|part| part == end.as_bytes());
            if let Some(found) = found {
                self.at += found + end.len();
                return Ok(());
            }
        } else {
            while let Some(line) = self.line() {
                if line == end.as_bytes() {
                    return Ok(());
                }
            }
        }
        (self.at, self.line) = begin;
        Err(self.fault(&format!("the end of section {} is missing", quoted(header))))
    }

    pub(super) fn expect_end(&mut self, header: &str) -> Result<()> {
        let end = header.replacen('$', "$End", 1);
        let line = self.next_line()?;
        if line == end {
            return Ok(());
        }
        Err(self.fault(&format!("expected {end}, found {}", quoted(&line))))
    }

    /// The only number of the next line, which is text in binary files, too.
    pub(super) fn count(&mut self) -> Result<u64> {
        let line = self.next_line()?;
        self.number(&line)
    }

    /// Begins the next record: a line of text, or what follows in a binary file.
    pub(super) fn begin(&mut self) -> Result<()> {
        if self.binary.is_none() {
            self.record = self.line().ok_or_else(|| self.fault("unexpected end of file"))?;
        }
        Ok(())
    }

    /// Ends a record: nothing may be left of the line.
    pub(super) fn end(&self) -> Result<()> {
        match self.record.trim_ascii() {
            [] => Ok(()),
            rest => {
                let rest = quoted(&String::from_utf8_lossy(rest));
                Err(self.fault(&format!("the line has more numbers than expected: {rest}")))
            }
        }
    }

    /// Ends a record whose rest is of no interest: what is left of a line. In binary nothing is skipped.
    pub(super) fn end_early(&mut self) {
        self.record = &[];
    }

    fn word(&mut self) -> Result<Cow<'a, str>> {
        let rest = self.record.trim_ascii_start();
        if rest.is_empty() {
            return Err(self.fault("a number is missing"));
        }
        let length = rest.iter().position(u8::is_ascii_whitespace).unwrap_or(rest.len());
        self.record = &rest[length..];
        Ok(String::from_utf8_lossy(&rest[..length]))
    }

    fn number<T: FromStr>(&self, word: &str) -> Result<T> {
        word.parse()
            .map_err(|_| self.fault(&format!("{} is not an admissible number", quoted(word))))
    }

    fn take<const N: usize>(&mut self) -> Result<[u8; N]> {
        let bytes = self.bytes.get(self.at..).and_then(|rest| rest.first_chunk::<N>());
        let bytes = *bytes.ok_or_else(|| self.fault("unexpected end of file"))?;
        self.at += N;
        Ok(bytes)
    }

    fn in_order<const N: usize>(mut bytes: [u8; N], swapped: bool) -> [u8; N] {
        if swapped {
            bytes.reverse();
        }
        bytes
    }

    /// The next number of the record, a whole one.
    pub(super) fn int(&mut self) -> Result<i64> {
        match self.binary {
            Some(Binary { swapped, .. }) => {
                Ok(i64::from(i32::from_ne_bytes(Self::in_order(self.take()?, swapped))))
            }
            None => {
                let word = self.word()?;
                self.number(&word)
            }
        }
    }

    /// The next number of the record, a count or a tag that is not negative.
    pub(super) fn size(&mut self) -> Result<u64> {
        match self.binary {
            Some(Binary { swapped, size: 8 }) => {
                Ok(u64::from_ne_bytes(Self::in_order(self.take()?, swapped)))
            }
            Some(Binary { swapped, .. }) => {
                Ok(u64::from(u32::from_ne_bytes(Self::in_order(self.take()?, swapped))))
            }
            None => {
                let word = self.word()?;
                self.number(&word)
            }
        }
    }

    /// The next number of the record, a real one.
    pub(super) fn real(&mut self) -> Result<f64> {
        match self.binary {
            Some(Binary { swapped, .. }) => {
                Ok(f64::from_ne_bytes(Self::in_order(self.take()?, swapped)))
            }
            None => {
                let word = self.word()?;
                self.number(&word)
            }
        }
    }

    /// A tag of format 2 and 4.0: an `int` that is not negative.
    pub(super) fn tag(&mut self) -> Result<u64> {
        let tag = self.int()?;
        u64::try_from(tag).map_err(|_| self.fault(&format!("{tag} is not a valid number")))
    }

    /// The error at the present place.
    pub(super) fn fault(&self, reason: &str) -> Error {
        fault(self.is_binary(), self.place(), reason)
    }
}

/// The error at a place, in a binary file or in text.
pub(super) fn fault(is_binary: bool, place: usize, reason: &str) -> Error {
    match is_binary {
        true => Error::AtByte { format: FORMAT, byte: place, reason: reason.to_owned() },
        false => Error::Syntax { format: FORMAT, line: place, reason: reason.to_owned() },
    }
}

/// The error for invalid data at a place.
pub(super) fn at(is_binary: bool, place: usize, cause: Error) -> Error {
    match is_binary {
        true => Error::AtByte { format: FORMAT, byte: place, reason: cause.to_string() },
        false => Error::AtLine { format: FORMAT, line: place, cause: Box::new(cause) },
    }
}
