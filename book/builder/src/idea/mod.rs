//! Pictures of an idea: `{{idea: name: caption}}`. They show no result, so no example draws them: a segment
//! with its zones, a wave with its nodes, a staircase. Some are frames of a slider.

mod bounds;
mod edge;
mod functions;
mod grids;
mod heat;
mod means;
mod numbers;
mod pen;
mod plane;
mod rates;
mod whole;

use crate::markup::escape;
use crate::{figure, slider};

/// Parameter and frames, each with its label.
type Frames = (&'static str, Vec<(String, String)>);

/// The picture `name` as HTML with its caption.
///
/// # Errors
/// In words, a name that is not there.
pub fn inline(name: &str, caption: &str) -> Result<String, String> {
    let (parameter, frames) = frames(name).ok_or("unknown idea")?;
    let mut drawn = Vec::new();
    for (label, svg) in frames {
        let spoken = format!("{caption}; {parameter}: {label}");
        drawn.push((label.clone(), figure::svg(&format!("idea/{name}-{label}"), &svg, &spoken)?));
    }
    Ok(match drawn.as_slice() {
        [(_, svg)] => {
            format!("<figure class=\"chart\">{svg}<figcaption>{}</figcaption></figure>", escape(caption))
        }
        _ => slider::html(parameter, &drawn, caption),
    })
}

/// Name and frames of an idea.
type Idea = (&'static str, fn() -> Frames);

/// Every idea by name, in the order of the book.
const IDEAS: [Idea; 58] = [
    ("condition", || ("place on the edge", over(&[0.1, 0.3, 0.5, 0.7, 0.9], whole::condition))),
    ("letters", || one(whole::letters())),
    ("argument", || one(grids::argument())),
    ("whole_boundary", || {
        let words = ["below", "on all sides", "a sawtooth"];
        ("contact", named(&words, plane::whole_boundary))
    }),
    ("cones", || ("cone", named(&["nodal", "midpoint"], |k| edge::cones(k == 1)))),
    ("step", || ("ν", over(&[0.1, 0.25, 0.4, 0.5, 0.6, 0.75], heat::step))),
    ("hat", || ("ν", over(&[0.1, 0.3, 0.5, 0.7, 0.9, 0.99], heat::hat))),
    ("trace", || ("frequency", over(&[1, 2, 4, 8], heat::trace))),
    ("transition", || ("τ", over(&[1.25, 1.5, 1.75, 2.0, 2.25, 2.5], rates::transition))),
    ("projections", || one(bounds::projections())),
    ("wave", || ("cells", over(&[4, 8, 16, 32], functions::wave))),
    ("figure_3_2", || ("θ", over(&[0.05, 0.1, 0.15, 0.25, 0.35, 0.45], edge::nodal_alternative))),
    ("figure_4_1", || ("θ", over(&[0.1, 0.2, 0.25, 0.3, 0.4, 0.5], edge::midpoint_alternative))),
    ("fat_cantor", || ("generation", over(&[1, 2, 3, 4, 5, 6], edge::fat_cantor))),
    ("slopes", || ("τ", over(&[1.55, 1.65, 1.75, 1.85, 1.95], rates::slopes))),
    ("products", || ("gap", over(&[0.1, 0.3, 0.5, 0.7, 0.9], means::products))),
    ("worst_set", || ("|N|", over(&[0.1, 0.25, 0.4, 0.5, 0.6, 0.75, 0.9], edge::worst_set))),
    ("flattening", || {
        let draw = |k| means::flattening([1, 2, 4, 8][k]);
        ("seminorm", named(&["1", "1/2", "1/4", "1/8"], draw))
    }),
    ("stretching", || ("θ", over(&[0.25, 0.35, 0.5, 0.7], functions::stretching))),
    ("truncated", || ("L", over(&[2.0, 4.0, 8.0, 16.0], functions::truncated))),
    ("pinned", || ("half width", over(&[0.15, 0.05, 0.01, 0.0], bounds::pinned))),
    ("odd", || ("θ", over(&[0.1, 0.3, 0.6], functions::odd))),
    ("interpolation", || ("cells", over(&[1, 2, 4, 8], bounds::interpolation))),
    ("deviation", || ("place", over(&[0.0, 0.25, 0.5, 0.75, 1.0], means::deviation))),
    ("triangle", || {
        let draw = |k: usize| plane::triangle([1, 2, 4][k]);
        ("triangles", named(&["1", "4", "16"], draw))
    }),
    ("needle", || ("δ", over(&[0.5, 0.25, 0.1, 0.04], plane::needle))),
    ("element_pairs", || ("elements", over(&[1, 2, 4, 8, 16], heat::element_pairs))),
    ("orthogonal", || ("cells", over(&[2, 4, 8, 16], means::orthogonal))),
    ("staircase", || ("cells", over(&[4, 8, 16, 32], functions::staircase))),
    ("tall", || ("q", over(&[2.0, 5.0, 10.0, 20.0], means::tall))),
    ("ladder", || ("τ", over(&[1.55, 1.65, 1.75, 1.85, 1.95], rates::ladder))),
    ("short_or_long", || ("contact", named(&["short", "long"], |k| means::short_or_long(k == 1)))),
    ("balance", || ("1/h", over(&[4.0, 16.0, 64.0, 256.0], bounds::balance))),
    ("shells", || ("α", over(&[0.0, 0.25, 0.5, 0.75, 1.0], rates::shells))),
    ("face", || ("size of the gaps", over(&[0.4, 0.2, 0.1, 0.04], plane::face))),
    ("sorting", || ("values", named(&["as they stand", "sorted"], |k| means::sorting(k == 1)))),
    ("ramp", || ("L", over(&[2.0, 5.0, 10.0, 20.0], means::ramp))),
    ("kernel", || ("ν", over(&[0.1, 0.25, 0.5, 0.75, 0.9], means::kernel))),
    ("rectangles", || ("1/h", over(&[4, 8, 16, 32], grids::rectangles))),
    ("constants", || ("constant", named(&["C", "K", "P"], numbers::constants))),
    ("strains", || ("part of the gradient", named(&["trace", "no trace", "rotation"], numbers::strains))),
    ("limit", || one(numbers::limit())),
    ("segment_pairs", || ("1/h", over(&[2, 4, 8, 16], heat::segment_pairs))),
    ("touching", || {
        let words = ["one triangle", "an edge", "a corner", "nothing"];
        ("in common", named(&words, plane::touching))
    }),
    ("fan", || ("ρ", named(&["1", "1/2", "1/4", "1/8"], numbers::fan))),
    ("digits", || ("effort", named(&["1", "2", "4", "8"], numbers::digits))),
    ("one_number", || ("frequency", over(&[1, 2, 4, 8], heat::one_number))),
    ("wedge", || ("opening in degrees", over(&[100, 120, 150, 210, 270, 330], plane::wedge))),
    ("oscillation", || ("Poisson's ratio", over(&[0.0, 0.25, 0.4], plane::oscillation))),
    ("v_cycle", || one(grids::v_cycle())),
    ("magnitudes", || one(rates::magnitudes())),
    ("elimination", || ("rows", over(&[0, 1, 2, 4, 8], grids::elimination))),
    ("toolkit", || one(whole::toolkit())),
    ("repairs", || one(whole::repairs())),
    ("longer_half", || ("contact", over(&[0.2, 0.4, 0.6, 0.8], whole::longer_half))),
    ("card", || one(whole::card())),
    ("meetings", || one(whole::meetings())),
    ("years", || one(whole::years())),
];

fn one(svg: String) -> Frames {
    ("", vec![(String::new(), svg)])
}

/// A frame for each value of a parameter.
fn over<T: Copy + ToString>(values: &[T], draw: impl Fn(T) -> String) -> Vec<(String, String)> {
    values.iter().map(|&value| (value.to_string(), draw(value))).collect()
}

/// A frame for each name.
fn named(names: &[&str], draw: impl Fn(usize) -> String) -> Vec<(String, String)> {
    names.iter().enumerate().map(|(k, &name)| (name.to_owned(), draw(k))).collect()
}

fn frames(name: &str) -> Option<Frames> {
    IDEAS.iter().find(|(known, _)| *known == name).map(|(_, draw)| draw())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_idea_is_a_picture_and_an_unknown_one_is_refused() {
        for (name, _) in IDEAS {
            let html = inline(name, "what it shows").unwrap();
            assert!(crate::markup::well_formed(&html.replace(" hidden", "")).is_ok(), "{name}");
            let faults = ["NaN", "inf,", "Minf", "Linf", "\"inf"];
            assert!(!faults.iter().any(|fault| html.contains(fault)), "{name}");
        }
        assert!(inline("nothing", "c").is_err());
    }

    /// The case that a frame names is that of its zones: contact lies between 1/5 and 7/10.
    #[test]
    fn the_alternative_turns_where_the_zones_meet_the_zeros() {
        for (theta, words) in [(0.1, "no zero near a₁"), (0.25, "no zero near a₂"), (0.35, "first case")]
        {
            assert!(edge::nodal_alternative(theta).contains(words), "{theta}");
        }
        assert!(edge::midpoint_alternative(0.2).contains("second case"));
        assert!(edge::midpoint_alternative(0.4).contains("first case"));
    }
}
