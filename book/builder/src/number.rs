//! How a computed number is written on a page: digits by a short format, as HTML or as LaTeX.
//!
//! Formats: `s4` four significant digits (the default), `f3` three digits after the point, `e2` a mantissa
//! with two digits and a power of ten, `i` the nearest integer, `p1` percent with one digit after the point.

/// How many digits, in which notation.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Format {
    /// Significant digits; a power of ten outside 1e-3 ... 1e6.
    Significant(usize),
    /// Digits after the point.
    Fixed(usize),
    /// Digits after the point of the mantissa, with a power of ten.
    Power(usize),
    /// The nearest integer.
    Integer,
    /// Percent, digits after the point.
    Percent(usize),
}

impl Format {
    /// Reads `s4`, `f3`, `e2`, `i`, `p1`.
    pub fn parse(text: &str) -> Option<Self> {
        if text == "i" {
            return Some(Format::Integer);
        }
        let digits = |rest: &str| rest.parse::<usize>().ok().filter(|&d| d <= 17);
        match text.split_at_checked(1)? {
            ("s", rest) => digits(rest).filter(|&d| d > 0).map(Format::Significant),
            ("f", rest) => digits(rest).map(Format::Fixed),
            ("e", rest) => digits(rest).map(Format::Power),
            ("p", rest) => digits(rest).map(Format::Percent),
            _ => None,
        }
    }
}

/// A number as it is written: sign and digits, and a power of ten if any.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Written {
    mantissa: String,
    exponent: Option<i32>,
    suffix: &'static str,
}

impl Written {
    /// Writes `value` in the given format.
    pub fn new(value: f64, format: Format) -> Self {
        match format {
            Format::Fixed(digits) => Self::plain(format!("{value:.digits$}"), ""),
            Format::Integer => Self::plain(format!("{value:.0}"), ""),
            Format::Percent(digits) => Self::plain(format!("{:.digits$}", 100.0 * value), "%"),
            Format::Power(digits) => Self::from_text(&format!("{value:.digits$e}")),
            Format::Significant(digits) => Self::significant(value, digits),
        }
    }

    fn significant(value: f64, digits: usize) -> Self {
        let power = Self::from_text(&format!("{value:.*e}", digits - 1));
        match power.exponent {
            Some(exponent) if (-3..6).contains(&exponent) || value == 0.0 => {
                let decimals = usize::try_from(digits as i32 - 1 - exponent).unwrap_or(0);
                Self::plain(format!("{value:.decimals$}"), "")
            }
            _ => power,
        }
    }

    fn plain(text: String, suffix: &'static str) -> Self {
        // "-0.00" says nothing that "0.00" does not
        let is_zero = text.chars().all(|c| matches!(c, '-' | '0' | '.'));
        let mantissa = if is_zero { text.trim_start_matches('-').to_owned() } else { text };
        Self { mantissa, exponent: None, suffix }
    }

    /// Takes a number apart that was printed by Rust, such as `1.5e-7`; other text stays as it is, and a zero
    /// is 0.
    pub fn from_text(text: &str) -> Self {
        let parts = text
            .split_once('e')
            .filter(|(mantissa, _)| mantissa.parse::<f64>().is_ok())
            .and_then(|(mantissa, e)| Some((mantissa, e.parse::<i32>().ok()?)));
        let (mantissa, exponent) = match parts {
            Some((mantissa, _)) if mantissa.parse() == Ok(0.0) => ("0", None),
            Some((mantissa, e)) => (mantissa, Some(e)),
            None => (text, None),
        };
        Self { mantissa: mantissa.to_owned(), exponent, suffix: "" }
    }

    /// For running text.
    pub fn html(&self) -> String {
        let minus = |text: &str| text.replace('-', "\u{2212}");
        let is_number = self.mantissa.parse::<f64>().is_ok();
        let mantissa = if is_number { minus(&self.mantissa) } else { self.mantissa.clone() };
        let space = if self.suffix.is_empty() { "" } else { "\u{202f}" };
        match self.exponent {
            None => format!("{mantissa}{space}{}", self.suffix),
            Some(0) => mantissa,
            Some(e) if mantissa == "1" => format!("10<sup>{}</sup>", minus(&e.to_string())),
            Some(e) => format!("{mantissa}\u{202f}·\u{202f}10<sup>{}</sup>", minus(&e.to_string())),
        }
    }

    /// For formulas.
    pub fn latex(&self) -> String {
        match self.exponent {
            None if self.suffix.is_empty() => self.mantissa.clone(),
            None => format!(r"{}\,\%", self.mantissa),
            Some(0) => self.mantissa.clone(),
            Some(e) if self.mantissa == "1" => format!("10^{{{e}}}"),
            Some(e) => format!(r"{}\cdot 10^{{{e}}}", self.mantissa),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn html(value: f64, format: &str) -> String {
        Written::new(value, Format::parse(format).unwrap()).html()
    }

    #[test]
    fn formats_write_the_digits_they_name() {
        assert_eq!(html(0.291557, "s4"), "0.2916");
        assert_eq!(html(-0.291557, "f2"), "\u{2212}0.29");
        assert_eq!(html(1.5e-7, "s3"), "1.50\u{202f}·\u{202f}10<sup>\u{2212}7</sup>");
        assert_eq!(html(1234567.0, "e1"), "1.2\u{202f}·\u{202f}10<sup>6</sup>");
        assert_eq!(html(31.7, "i"), "32");
        assert_eq!(html(0.1234, "p1"), "12.3\u{202f}%");
        assert_eq!(html(-1e-9, "f2"), "0.00");
        assert_eq!(html(0.0, "s3"), "0");
        assert_eq!(Written::new(1.5e-7, Format::Power(1)).latex(), r"1.5\cdot 10^{-7}");
    }

    #[test]
    fn words_stay_words() {
        assert_eq!(Written::from_text("active-set").html(), "active-set");
        assert_eq!(Written::from_text("nodal").html(), "nodal");
        assert_eq!(Written::from_text("1e-3").html(), "10<sup>\u{2212}3</sup>");
        assert_eq!(Written::from_text("0.00e0").html(), "0");
        assert_eq!(Written::from_text("4.60e0").html(), "4.60");
    }
}
