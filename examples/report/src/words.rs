//! Keys made from text, and the names of Greek letters.

/// Letters, digits and hyphens; letters that a keyboard lacks by name.
pub(crate) fn slug(words: &str) -> String {
    let mut text = String::new();
    for c in words.chars() {
        let name = GREEK.iter().find(|(letter, _)| *letter == c).map(|(_, name)| *name);
        match name {
            Some(name) => text.push_str(name),
            None if c.is_ascii_alphanumeric() || c == '.' => text.push(c.to_ascii_lowercase()),
            None if !text.ends_with('-') => text.push('-'),
            None => {}
        }
    }
    text.trim_matches(['-', '.']).to_owned()
}

/// Greek letters with their names.
pub(crate) const GREEK: [(char, &str); 15] = [
    ('α', "alpha"),
    ('β', "beta"),
    ('γ', "gamma"),
    ('δ', "delta"),
    ('ε', "epsilon"),
    ('θ', "theta"),
    ('κ', "kappa"),
    ('λ', "lambda"),
    ('μ', "mu"),
    ('ν', "nu"),
    ('π', "pi"),
    ('σ', "sigma"),
    ('τ', "tau"),
    ('φ', "phi"),
    ('ω', "omega"),
];
