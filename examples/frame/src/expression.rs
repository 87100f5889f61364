//! Functions of x and y from the command line: `"-cos(pi*x) - 0.5"`.
//!
//! Parsed once, by exmex, and evaluated in binary64. Before exmex sees a text, every sign, power and name in
//! it is given the meaning it has on paper or refused: exmex reads -x^2 as (-x)^2, 2^3^2 as (2^3)^2 and
//! sin x^2 as (sin x)^2, and does not read 1e-3.
//!
//! Numbers, `x`, `y`, `pi`, `e`, `+ - * / ^`, parentheses, and the functions of [`FUNCTIONS`] and
//! [`OF_TWO`] with their arguments in parentheses. Angles in radians, `log` and `ln` natural.

use crate::{Error, Result};
use exmex::{Express, FlatEx};
use std::fmt;

/// Functions of one argument.
const FUNCTIONS: [&str; 21] = [
    "abs", "signum", "sin", "cos", "tan", "asin", "acos", "atan", "sinh", "cosh", "tanh", "asinh", "acosh",
    "atanh", "floor", "exp", "sqrt", "cbrt", "ln", "log", "log10",
];
/// Functions of two arguments.
const OF_TWO: [&str; 3] = ["min", "max", "atan2"];
/// Longest text: beyond it nobody reads what he wrote.
const LONGEST: usize = 2000;
/// Deepest parentheses.
const DEEPEST: usize = 50;

/// A function of x and y.
#[derive(Debug, Clone)]
pub struct Expression {
    text: String,
    parsed: FlatEx<f64>,
    /// Which coordinate each variable of `parsed` is.
    axes: Vec<usize>,
}

/// What a text consists of.
#[derive(Debug, Clone, PartialEq)]
enum Token {
    Number(f64),
    /// x or y.
    Variable(char),
    /// pi or e, as exmex calls it.
    Constant(&'static str),
    Function(String),
    Sign(char),
}

impl Expression {
    /// The function that a text says.
    ///
    /// # Errors
    /// [`Error::Option`] with the text and what is wrong with it: a name that is not known (and those that
    /// are), a sign, a power or a function that needs parentheses, whatever exmex refuses.
    pub fn parse(text: &str) -> Result<Self> {
        let fault = |why: String| Error::Option(format!("expression '{}': {why}", text.trim()));
        if text.len() > LONGEST {
            return Err(Error::Option(format!("an expression of more than {LONGEST} characters")));
        }
        let tokens = tokens(text).and_then(|tokens| check(&tokens).map(|()| tokens)).map_err(fault)?;
        let parsed: FlatEx<f64> =
            exmex::parse(&written(&tokens)).map_err(|e| fault(format!("cannot be read ({e})")))?;
        let axes = parsed.var_names().iter().map(|name| usize::from(name == "y")).collect();
        Ok(Self { text: text.trim().to_owned(), parsed, axes })
    }

    /// The functions in a list with commas; commas inside parentheses belong to a function of two arguments.
    ///
    /// # Errors
    /// As [`Expression::parse`].
    pub fn parse_list(text: &str) -> Result<Vec<Self>> {
        let (mut depth, mut start, mut parts) = (0_i64, 0, Vec::new());
        for (at, c) in text.char_indices() {
            match c {
                '(' => depth += 1,
                ')' => depth -= 1,
                ',' if depth == 0 => {
                    parts.push(&text[start..at]);
                    start = at + 1;
                }
                _ => {}
            }
        }
        parts.push(&text[start..]);
        parts.into_iter().map(Self::parse).collect()
    }

    /// The value; NaN where it is not defined.
    pub fn at(&self, point: [f64; 2]) -> f64 {
        let values: Vec<f64> = self.axes.iter().map(|&axis| point[axis]).collect();
        self.parsed.eval(&values).unwrap_or(f64::NAN)
    }
}

impl fmt::Display for Expression {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text)
    }
}

type Checked<T> = std::result::Result<T, String>;

fn tokens(text: &str) -> Checked<Vec<Token>> {
    let mut tokens = Vec::new();
    let mut rest = text.trim_start();
    while let Some(c) = rest.chars().next() {
        let length = match c {
            '0'..='9' | '.' => number_length(rest),
            c if c.is_alphabetic() || c == '_' => {
                rest.find(|c: char| !c.is_alphanumeric() && c != '_').unwrap_or(rest.len())
            }
            _ => c.len_utf8(),
        };
        let (word, after) = rest.split_at(length);
        tokens.push(match c {
            '0'..='9' | '.' => {
                let number = word.parse().map_err(|_| format!("'{word}' is not a number"))?;
                Token::Number(number)
            }
            '+' | '-' | '*' | '/' | '^' | '(' | ')' | ',' => Token::Sign(c),
            c if c.is_alphabetic() || c == '_' => named(word)?,
            _ => return Err(format!("'{c}' has no meaning; there are + - * / ^ and parentheses")),
        });
        rest = after.trim_start();
    }
    Ok(tokens)
}

/// How far a number reaches, exponent included.
fn number_length(text: &str) -> usize {
    let digits = |from: usize| {
        text[from..].find(|c: char| !c.is_ascii_digit() && c != '.').map_or(text.len(), |k| from + k)
    };
    let mantissa = digits(0);
    let rest = &text[mantissa..];
    let sign = match rest.as_bytes() {
        [b'e' | b'E', b'+' | b'-', b'0'..=b'9', ..] => 2,
        [b'e' | b'E', b'0'..=b'9', ..] => 1,
        _ => return mantissa,
    };
    let from = mantissa + sign;
    text[from..].find(|c: char| !c.is_ascii_digit()).map_or(text.len(), |k| from + k)
}

fn named(word: &str) -> Checked<Token> {
    match word {
        "x" | "y" => Ok(Token::Variable(if word == "x" { 'x' } else { 'y' })),
        "pi" | "π" => Ok(Token::Constant("PI")),
        "e" => Ok(Token::Constant("E")),
        _ if FUNCTIONS.contains(&word) || OF_TWO.contains(&word) => Ok(Token::Function(word.to_owned())),
        _ => Err(format!(
            "unknown name '{word}': known are x, y, pi, e, {}, {}",
            FUNCTIONS.join(", "),
            OF_TWO.join(", ")
        )),
    }
}

/// Every sign stands where its meaning is beyond doubt.
fn check(tokens: &[Token]) -> Checked<()> {
    use Token::{Function, Sign};
    if tokens.is_empty() {
        return Err("is empty".to_owned());
    }
    let (mut powers, mut depth) = (vec![false], 0_usize);
    for (at, token) in tokens.iter().enumerate() {
        let before = at.checked_sub(1).map(|k| &tokens[k]);
        let opens = matches!(before, None | Some(Sign('(' | ',')));
        match token {
            Function(name) if tokens.get(at + 1) != Some(&Sign('(')) => {
                return Err(format!("'{name}' needs its argument in parentheses: {name}(..)"));
            }
            Sign('-' | '+') if matches!(before, Some(Sign('+' | '-' | '*' | '/' | '^'))) => {
                return Err("two signs in a row: a signed factor needs parentheses, as in 2*(-x)".to_owned());
            }
            Sign('*') if before == Some(&Sign('*')) => {
                return Err("'**' is not a sign: a power is x^2".to_owned());
            }
            Sign('*' | '/' | '^') if opens => return Err("a sign has nothing before it".to_owned()),
            Sign('^') if powers.last() == Some(&true) => {
                return Err("two powers in a row need parentheses: a^(b^c) or (a^b)^c".to_owned());
            }
            Sign('^') => set(&mut powers, true),
            Sign('+' | '-' | '*' | '/') => set(&mut powers, false),
            Sign('(') => {
                depth += 1;
                powers.push(false);
            }
            Sign(')') => {
                depth = depth.checked_sub(1).ok_or("a parenthesis is closed that was not opened")?;
                powers.pop();
            }
            Sign(',') if depth == 0 => return Err("a comma between arguments of no function".to_owned()),
            Sign(',') => set(&mut powers, false),
            _ => {}
        }
        if depth > DEEPEST {
            return Err(format!("parentheses more than {DEEPEST} deep"));
        }
    }
    if depth > 0 { Err("a parenthesis is not closed".to_owned()) } else { arguments(tokens) }
}

fn set(powers: &mut [bool], value: bool) {
    if let Some(last) = powers.last_mut() {
        *last = value;
    }
}

/// Functions have as many arguments as they take, and commas stand nowhere else.
fn arguments(tokens: &[Token]) -> Checked<()> {
    let mut open: Vec<(Option<&str>, usize)> = Vec::new();
    for (at, token) in tokens.iter().enumerate() {
        match token {
            Token::Sign('(') => {
                let name = at.checked_sub(1).and_then(|k| match &tokens[k] {
                    Token::Function(name) => Some(name.as_str()),
                    _ => None,
                });
                open.push((name, 1));
            }
            Token::Sign(',') => open.iter_mut().last().into_iter().for_each(|(_, count)| *count += 1),
            Token::Sign(')') => {
                let Some((name, count)) = open.pop() else { continue };
                let takes = 1 + usize::from(name.is_some_and(|name| OF_TWO.contains(&name)));
                if count != takes {
                    let name = name.unwrap_or("a parenthesis");
                    return Err(format!("{name} has {count} arguments, and takes {takes}"));
                }
            }
            _ => {}
        }
    }
    Ok(())
}

/// As exmex reads it: a sign that opens a term has a zero before it.
fn written(tokens: &[Token]) -> String {
    let mut text = String::new();
    let mut opens = true;
    for token in tokens {
        match token {
            Token::Number(number) => text += &number.to_string(),
            Token::Variable(name) => text.push(*name),
            Token::Constant(name) => text += name,
            Token::Function(name) => text += name,
            Token::Sign(sign @ ('-' | '+')) if opens => {
                text.push('0');
                text.push(*sign);
            }
            Token::Sign(sign) => text.push(*sign),
        }
        opens = matches!(token, Token::Sign('(' | ','));
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn expressions_mean_what_they_mean_on_paper() {
        let (x, y) = (0.75_f64, -1.5_f64);
        let pi = std::f64::consts::PI;
        let cases: [(&str, f64); 16] = [
            ("-x^2", -x * x),
            ("2 - x^2*3", 2.0 - x * x * 3.0),
            ("(-x)^2", x * x),
            ("1e-3*x", 1e-3 * x),
            ("2.5E+2 + .5", 250.5),
            ("-cos(pi*x) - 0.5", -(pi * x).cos() - 0.5),
            ("max(x, y) + min(-x^2, y)", x + y),
            ("atan2(y, x)*2", 2.0 * y.atan2(x)),
            ("x/y*3", x / y * 3.0),
            ("x - y - 1 + 2", x - y + 1.0),
            ("exp(-x^2)", (-x * x).exp()),
            ("2^(-1)", 0.5),
            ("(2^3)^2 + 2^(3^2)", 576.0),
            ("x^2 + y^2", x * x + y * y),
            ("log(e)+ln(e^2)+log10(100)", 5.0),
            ("abs(y)*signum(y)", y),
        ];
        for (text, value) in cases {
            let found = Expression::parse(text).unwrap().at([x, y]);
            assert!((found - value).abs() <= 4.0 * f64::EPSILON * value.abs().max(1.0), "{text}: {found}");
        }
        assert!(Expression::parse("sqrt(-1 - x^2)").unwrap().at([0.0, 0.0]).is_nan());
        let list = Expression::parse_list("max(x, 1), -y").unwrap();
        assert_eq!((list.len(), list[0].at([3.0, 0.0]), list[1].at([0.0, 2.0])), (2, 3.0, -2.0));
    }

    #[test]
    fn what_is_not_clear_is_refused_in_one_line() {
        let faults = [
            ("x + z", "unknown name 'z': known are x, y, pi, e, abs"),
            ("sin x", "'sin' needs its argument in parentheses"),
            ("2*-x", "two signs in a row"),
            ("2^-1", "two signs in a row"),
            ("x**2", "a power is x^2"),
            ("2^3^2", "two powers in a row"),
            ("max(x)", "max has 1 arguments, and takes 2"),
            ("sin(x, y)", "sin has 2 arguments"),
            ("(x, y)", "a parenthesis has 2 arguments"),
            ("(x", "is not closed"),
            ("x)", "was not opened"),
            ("", "is empty"),
            ("*x", "nothing before it"),
            ("x*", "cannot be read"),
            ("2x", "cannot be read"),
            ("2 (x)", "cannot be read"),
            ("x & y", "'&' has no meaning"),
            ("1.2.3", "is not a number"),
            ("{x}", "has no meaning"),
            ("sin()", "cannot be read"),
        ];
        for (text, why) in faults {
            let error = Expression::parse(text).unwrap_err().to_string();
            assert!(error.contains(why) && !error.contains('\n'), "{text}: {error}");
        }
        for depth in [60, 900] {
            let deep = "(".repeat(depth) + "x" + &")".repeat(depth);
            assert!(Expression::parse(&deep).is_err());
        }
        assert!(Expression::parse(&"x+".repeat(2000)).is_err());
    }
}
