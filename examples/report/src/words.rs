//! Keys made from text, and the names of Greek letters.

/// Greek letters with their names.
pub(crate) fn greek() -> impl Iterator<Item = (&'static str, &'static str)> {
    let letters = "α alpha, β beta, γ gamma, δ delta, ε epsilon, θ theta, κ kappa, λ lambda, \
        μ mu, ν nu, π pi, σ sigma, τ tau, φ phi, ω omega";
    letters.split(", ").filter_map(|pair| pair.split_once(' '))
}

/// Letters, digits, points and hyphens; letters that a keyboard lacks by name.
pub(crate) fn slug(words: &str) -> String {
    let named = greek().fold(words.to_owned(), |text, (letter, name)| text.replace(letter, name));
    let mut text = String::new();
    for c in named.chars() {
        if c.is_ascii_alphanumeric() || c == '.' {
            text.push(c.to_ascii_lowercase());
        } else if !text.ends_with('-') {
            text.push('-');
        }
    }
    text.trim_matches(['-', '.']).to_owned()
}
