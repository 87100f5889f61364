//! Functions of x and y from the command line: `"-cos(pi*x) - 0.5"`.
//!
//! ```text
//! sum     = [+|-] product {(+|-) product}
//! product = power {(*|/) power}
//! power   = operand [^ operand]
//! operand = number | x | y | pi | e | name(sum) | name(sum, sum) | (sum)
//! ```
//!
//! with the names of [`FUNCTIONS`] and [`OF_TWO`]; angles in radians, `log` and `ln` natural. What is read in two ways is
//! refused: two operands in a row, as in `x y` or `2 3`, two powers, as in `2^3^2`, two signs, as in `2*-x`.

use std::fmt;

/// Functions of one argument.
const FUNCTIONS: [(&str, fn(f64) -> f64); 21] = [
    ("abs", f64::abs),
    ("signum", f64::signum),
    ("sin", f64::sin),
    ("cos", f64::cos),
    ("tan", f64::tan),
    ("asin", f64::asin),
    ("acos", f64::acos),
    ("atan", f64::atan),
    ("sinh", f64::sinh),
    ("cosh", f64::cosh),
    ("tanh", f64::tanh),
    ("asinh", f64::asinh),
    ("acosh", f64::acosh),
    ("atanh", f64::atanh),
    ("floor", f64::floor),
    ("exp", f64::exp),
    ("sqrt", f64::sqrt),
    ("cbrt", f64::cbrt),
    ("ln", f64::ln),
    ("log", f64::ln),
    ("log10", f64::log10),
];
/// Functions of two arguments.
const OF_TWO: [(&str, fn(f64, f64) -> f64); 3] =
    [("min", f64::min), ("max", f64::max), ("atan2", f64::atan2)];
/// Characters of a text at most.
const LONGEST: usize = 2000;
/// Deepest parentheses.
const DEEPEST: usize = 50;

/// A function of x and y.
#[derive(Debug, Clone)]
pub struct Expression {
    text: String,
    root: Node,
}

#[derive(Debug, Clone)]
enum Node {
    Number(f64),
    /// x or y
    Axis(usize),
    OfOne(fn(f64) -> f64, Box<Node>),
    OfTwo(fn(f64, f64) -> f64, Box<[Node; 2]>),
}

/// A value or what is wrong with a text, in one line.
pub type Read<T> = std::result::Result<T, String>;

impl Expression {
    /// The function that a text says.
    ///
    /// # Errors
    /// The text and what is wrong with it: a name that is not known (and those that are), two operands in a row, a sign, a
    /// power or a function that needs parentheses.
    pub fn parse(text: &str) -> Read<Self> {
        let text = text.trim();
        if text.len() > LONGEST {
            return Err(format!("an expression of more than {LONGEST} characters"));
        }
        let mut reader = Reader { rest: text, depth: 0 };
        let root = if text.is_empty() { Err("is empty".to_owned()) } else { reader.sum() };
        let root = root.and_then(|root| reader.end().map(|()| root));
        let root = root.map_err(|why| format!("expression '{text}': {why}"))?;
        Ok(Self { text: text.to_owned(), root })
    }

    /// The functions in a list with commas; commas inside parentheses belong to a function of two arguments.
    ///
    /// # Errors
    /// As [`Expression::parse`].
    pub fn parse_list(text: &str) -> Read<Vec<Self>> {
        let mut depth = 0_i64;
        let parts = text.split(|c| {
            depth += i64::from(c == '(') - i64::from(c == ')');
            c == ',' && depth == 0
        });
        parts.map(Self::parse).collect()
    }

    /// The value; NaN where it is not defined.
    pub fn at(&self, point: [f64; 2]) -> f64 {
        self.root.at(point)
    }
}

impl fmt::Display for Expression {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text)
    }
}

impl Node {
    fn at(&self, point: [f64; 2]) -> f64 {
        match self {
            Self::Number(value) => *value,
            Self::Axis(axis) => point[*axis],
            Self::OfOne(f, of) => f(of.at(point)),
            Self::OfTwo(f, of) => f(of[0].at(point), of[1].at(point)),
        }
    }

    fn of_two(f: fn(f64, f64) -> f64, a: Self, b: Self) -> Self {
        Self::OfTwo(f, Box::new([a, b]))
    }
}

/// What is left of a text, and how many parentheses are open.
struct Reader<'a> {
    rest: &'a str,
    depth: usize,
}

impl<'a> Reader<'a> {
    fn next(&mut self) -> Option<char> {
        self.rest = self.rest.trim_start();
        self.rest.chars().next()
    }

    /// Whether the next character is this one, which is then read.
    fn takes(&mut self, sign: char) -> bool {
        let found = self.next() == Some(sign);
        if found {
            self.rest = &self.rest[sign.len_utf8()..];
        }
        found
    }

    fn sum(&mut self) -> Read<Node> {
        let is_negative = self.takes('-');
        if !is_negative && !self.takes('+') && matches!(self.next(), Some('*' | '/' | '^')) {
            return Err("a sign has nothing before it".to_owned());
        }
        let mut sum = self.product()?;
        if is_negative {
            sum = Node::OfOne(|a| -a, Box::new(sum));
        }
        loop {
            if self.takes('+') {
                sum = Node::of_two(|a, b| a + b, sum, self.product()?);
            } else if self.takes('-') {
                sum = Node::of_two(|a, b| a - b, sum, self.product()?);
            } else {
                return Ok(sum);
            }
        }
    }

    fn product(&mut self) -> Read<Node> {
        let mut product = self.power()?;
        loop {
            if self.takes('*') {
                if self.next() == Some('*') {
                    return Err("'**' is not a sign: a power is x^2".to_owned());
                }
                product = Node::of_two(|a, b| a * b, product, self.power()?);
            } else if self.takes('/') {
                product = Node::of_two(|a, b| a / b, product, self.power()?);
            } else {
                return Ok(product);
            }
        }
    }

    fn power(&mut self) -> Read<Node> {
        let base = self.operand()?;
        if !self.takes('^') {
            return Ok(base);
        }
        let power = Node::of_two(f64::powf, base, self.operand()?);
        if self.next() == Some('^') {
            return Err("two powers in a row need parentheses: a^(b^c) or (a^b)^c".to_owned());
        }
        Ok(power)
    }

    fn operand(&mut self) -> Read<Node> {
        match self.next() {
            None => Err("cannot be read: it ends before an operand".to_owned()),
            Some('+' | '-' | '*' | '/' | '^') => {
                Err("two signs in a row: a signed factor needs parentheses, as in 2*(-x)".to_owned())
            }
            Some('(') => self.arguments("a parenthesis").map(|[inner]| inner),
            Some('0'..='9' | '.') => {
                let word = self.word(number_length(self.rest));
                word.parse().map(Node::Number).map_err(|_| format!("'{word}' is not a number"))
            }
            Some(c) if c.is_alphabetic() || c == '_' => {
                let end = self.rest.find(|c: char| !c.is_alphanumeric() && c != '_');
                let name = self.word(end.unwrap_or(self.rest.len()));
                self.named(name)
            }
            Some(c @ (')' | ',')) => Err(format!("cannot be read: there is no operand before '{c}'")),
            Some(c) => Err(meaningless(c)),
        }
    }

    fn named(&mut self, name: &str) -> Read<Node> {
        use std::f64::consts::{E, PI};
        let of_one = FUNCTIONS.iter().find(|(known, _)| *known == name);
        let of_two = OF_TWO.iter().find(|(known, _)| *known == name);
        if (of_one.is_some() || of_two.is_some()) && self.next() != Some('(') {
            return Err(format!("'{name}' needs its argument in parentheses: {name}(..)"));
        }
        match (name, of_one, of_two) {
            ("x", ..) => Ok(Node::Axis(0)),
            ("y", ..) => Ok(Node::Axis(1)),
            ("pi" | "π", ..) => Ok(Node::Number(PI)),
            ("e", ..) => Ok(Node::Number(E)),
            (_, Some((_, f)), _) => self.arguments(name).map(|[of]| Node::OfOne(*f, Box::new(of))),
            (_, _, Some((_, f))) => self.arguments(name).map(|of| Node::OfTwo(*f, Box::new(of))),
            _ => {
                let names =
                    FUNCTIONS.iter().map(|(name, _)| *name).chain(OF_TWO.iter().map(|(name, _)| *name));
                let known = names.collect::<Vec<_>>().join(", ");
                Err(format!("unknown name '{name}': known are x, y, pi, e, {known}"))
            }
        }
    }

    /// The N arguments in parentheses.
    fn arguments<const N: usize>(&mut self, name: &str) -> Read<[Node; N]> {
        self.takes('(');
        self.depth += 1;
        if self.depth > DEEPEST {
            return Err(format!("parentheses more than {DEEPEST} deep"));
        }
        let mut arguments = vec![self.sum()?];
        while self.takes(',') {
            arguments.push(self.sum()?);
        }
        if self.next().is_none() {
            return Err("a parenthesis is not closed".to_owned());
        }
        if !self.takes(')') {
            return Err(self.unexpected());
        }
        self.depth -= 1;
        let count = arguments.len();
        arguments.try_into().map_err(|_| format!("{name} has {count} arguments, and takes {N}"))
    }

    /// Nothing is left.
    fn end(&mut self) -> Read<()> {
        match self.next() {
            None => Ok(()),
            Some(')') => Err("a parenthesis is closed that was not opened".to_owned()),
            Some(',') => Err("a comma between arguments of no function".to_owned()),
            Some(_) => Err(self.unexpected()),
        }
    }

    /// What is wrong where an operand is complete and something else than a sign follows.
    fn unexpected(&mut self) -> String {
        match self.next() {
            Some(c) if c.is_alphanumeric() || "_.(".contains(c) => {
                "cannot be read: two operands in a row; a product is x*y".to_owned()
            }
            Some(c) => meaningless(c),
            None => "cannot be read".to_owned(),
        }
    }

    fn word(&mut self, length: usize) -> &'a str {
        let (word, rest) = self.rest.split_at(length);
        self.rest = rest;
        word
    }
}

fn meaningless(c: char) -> String {
    format!("'{c}' has no meaning; there are + - * / ^ and parentheses")
}

/// How far a number reaches, exponent included.
fn number_length(text: &str) -> usize {
    let digits = |from: usize| {
        text[from..].find(|c: char| !c.is_ascii_digit() && c != '.').map_or(text.len(), |k| from + k)
    };
    let mantissa = digits(0);
    let sign = match &text.as_bytes()[mantissa..] {
        [b'e' | b'E', b'+' | b'-', b'0'..=b'9', ..] => 2,
        [b'e' | b'E', b'0'..=b'9', ..] => 1,
        _ => return mantissa,
    };
    let from = mantissa + sign;
    text[from..].find(|c: char| !c.is_ascii_digit()).map_or(text.len(), |k| from + k)
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
            ("x y", "two operands in a row"),
            ("y 2", "two operands in a row"),
            ("pi x", "two operands in a row"),
            ("2 3", "two operands in a row"),
            ("max(x y, 1)", "two operands in a row"),
            ("(x) y", "two operands in a row"),
            ("x sin(y)", "two operands in a row"),
            ("1 e3", "two operands in a row"),
            ("max(x, 1", "is not closed"),
            ("x, y", "arguments of no function"),
            ("x & y", "'&' has no meaning"),
            ("1.2.3", "is not a number"),
            ("{x}", "has no meaning"),
            ("sin()", "cannot be read"),
        ];
        for (text, why) in faults {
            let error = Expression::parse(text).unwrap_err();
            assert!(error.contains(why) && !error.contains('\n'), "{text}: {error}");
        }
        for depth in [60, 900] {
            let deep = "(".repeat(depth) + "x" + &")".repeat(depth);
            assert!(Expression::parse(&deep).is_err());
        }
        assert!(Expression::parse(&"x+".repeat(2000)).is_err());
    }

    /// An expression with a value of its own.
    enum Tree {
        Leaf(&'static str, f64),
        Negative(Box<Tree>),
        Binary(char, Box<[Tree; 2]>),
        Call(&'static str, Vec<Tree>),
    }

    struct Random(u64);

    impl Random {
        fn below(&mut self, count: u64) -> u64 {
            self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            (self.0 >> 33) % count
        }

        fn tree(&mut self, depth: u64, point: [f64; 2]) -> Tree {
            if depth == 0 || self.below(6) == 0 {
                let leaves = [
                    ("x", point[0]),
                    ("y", point[1]),
                    ("pi", 3.141592653589793),
                    ("e", 2.718281828459045),
                    ("0.5", 0.5),
                    ("3", 3.0),
                    ("1e-2", 0.01),
                    ("2.5E+1", 25.0),
                    (".25", 0.25),
                ];
                let (text, value) = leaves[self.below(9) as usize];
                return Tree::Leaf(text, value);
            }
            let below = |random: &mut Self| Box::new(random.tree(depth - 1, point));
            match self.below(8) {
                0 => Tree::Negative(below(self)),
                1 => Tree::Call(
                    ["sin", "exp", "abs", "sqrt", "atan", "ln"][self.below(6) as usize],
                    vec![*below(self)],
                ),
                2 => Tree::Call(["min", "max"][self.below(2) as usize], vec![*below(self), *below(self)]),
                k => {
                    let pair = [*below(self), *below(self)];
                    Tree::Binary(['+', '-', '*', '/', '^'][k as usize - 3], Box::new(pair))
                }
            }
        }

        /// Nothing, or what separates words on paper.
        fn space(&mut self) -> &'static str {
            ["", "", " ", "  "][self.below(4) as usize]
        }
    }

    impl Tree {
        fn value(&self) -> f64 {
            match self {
                Self::Leaf(_, value) => *value,
                Self::Negative(of) => 0.0 - of.value(),
                Self::Binary(sign, of) => {
                    let (a, b) = (of[0].value(), of[1].value());
                    match sign {
                        '+' => b + a,
                        '-' => a - b,
                        '*' => b * a,
                        '/' => a / b,
                        _ => a.powf(b),
                    }
                }
                Self::Call(name, of) => match *name {
                    "sin" => of[0].value().sin(),
                    "exp" => of[0].value().exp(),
                    "abs" => of[0].value().abs(),
                    "sqrt" => of[0].value().sqrt(),
                    "atan" => of[0].value().atan(),
                    "ln" => of[0].value().ln(),
                    "min" => of[0].value().min(of[1].value()),
                    _ => of[0].value().max(of[1].value()),
                },
            }
        }

        /// 1 of sums and signs, 2 of products, 3 of powers, 4 of operands.
        fn rank(&self) -> u8 {
            match self {
                Self::Negative(_) | Self::Binary('+' | '-', _) => 1,
                Self::Binary('*' | '/', _) => 2,
                Self::Binary(..) => 3,
                Self::Leaf(..) | Self::Call(..) => 4,
            }
        }

        /// With parentheses where the rank is below `least`, or a sign would follow a sign; some more at random.
        fn text(&self, least: u8, opens: bool, random: &mut Random) -> String {
            let is_signed = matches!(self, Self::Negative(_)) && !opens;
            if self.rank() < least || is_signed || random.below(8) == 0 {
                return format!("({})", self.text(0, true, random));
            }
            match self {
                Self::Leaf(text, _) => (*text).to_owned(),
                Self::Negative(of) => format!("-{}{}", random.space(), of.text(2, false, random)),
                Self::Binary(sign, of) => {
                    let ranks = match sign {
                        '+' => [1, 2],
                        '-' => [1, 2],
                        '*' | '/' => [2, 3],
                        _ => [4, 4],
                    };
                    let left = of[0].text(ranks[0], opens && ranks[0] == 1, random);
                    let right = of[1].text(ranks[1], false, random);
                    format!("{left}{}{sign}{}{right}", random.space(), random.space())
                }
                Self::Call(name, of) => {
                    let of: Vec<String> = of.iter().map(|of| of.text(0, true, random)).collect();
                    format!("{name}{}({})", random.space(), of.join(", "))
                }
            }
        }
    }

    #[test]
    fn random_expressions_have_the_value_of_their_tree() {
        let mut random = Random(35);
        for _ in 0..500 {
            let point = [random.below(400) as f64 / 100.0 - 2.0, random.below(400) as f64 / 100.0 - 2.0];
            let depth = 1 + random.below(5);
            let tree = random.tree(depth, point);
            let text = tree.text(0, true, &mut random);
            let found = Expression::parse(&text).unwrap_or_else(|why| panic!("{why}"));
            let (found, exact) = (found.at(point), tree.value());
            let is_same = found == exact || found.is_nan() && exact.is_nan();
            assert!(is_same, "{text} at {point:?}: {found}, {exact}");
        }
    }
}
