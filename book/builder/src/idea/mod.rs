//! Pictures of an idea: `{{idea: name: caption}}`. They show no result, so no example draws them: a segment
//! with its zones, a wave with its nodes, a staircase. Some are frames of a slider.

mod bounds;
mod edge;
mod functions;
mod pen;

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

fn frames(name: &str) -> Option<Frames> {
    fn over<T: Copy + ToString>(values: &[T], draw: impl Fn(T) -> String) -> Vec<(String, String)> {
        values.iter().map(|&value| (value.to_string(), draw(value))).collect()
    }
    Some(match name {
        "figure_3_2" => ("θ", over(&[0.05, 0.1, 0.15, 0.25, 0.35, 0.45], edge::nodal_alternative)),
        "figure_4_1" => ("θ", over(&[0.1, 0.2, 0.25, 0.3, 0.4, 0.5], edge::midpoint_alternative)),
        "cones" => {
            let cone = |word: &str, is_midpoint| (word.to_owned(), edge::cones(is_midpoint));
            ("cone", vec![cone("nodal", false), cone("midpoint", true)])
        }
        "worst_set" => ("|N|", over(&[0.1, 0.25, 0.4, 0.5, 0.6, 0.75, 0.9], edge::worst_set)),
        "fat_cantor" => ("generation", over(&[1, 2, 3, 4, 5, 6], edge::fat_cantor)),
        "step" => ("ν", over(&[0.1, 0.25, 0.4, 0.5, 0.6, 0.75], functions::step)),
        "hat" => ("ν", over(&[0.1, 0.3, 0.5, 0.7, 0.9, 0.99], functions::hat)),
        "wave" => ("cells", over(&[4, 8, 16, 32], functions::wave)),
        "staircase" => ("cells", over(&[4, 8, 16, 32], functions::staircase)),
        "truncated" => ("L", over(&[2.0, 4.0, 8.0, 16.0], functions::truncated)),
        "stretching" => ("θ", over(&[0.25, 0.35, 0.5, 0.7], functions::stretching)),
        "odd" => ("θ", over(&[0.1, 0.3, 0.6], functions::odd)),
        "projections" => ("", vec![(String::new(), bounds::projections())]),
        "balance" => ("1/h", over(&[4.0, 16.0, 64.0, 256.0], bounds::balance)),
        "interpolation" => ("cells", over(&[1, 2, 4, 8], bounds::interpolation)),
        "pinned" => ("half width", over(&[0.15, 0.05, 0.01, 0.0], bounds::pinned)),
        _ => return None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_idea_is_a_picture_and_an_unknown_one_is_refused() {
        let names = [
            "figure_3_2",
            "figure_4_1",
            "cones",
            "worst_set",
            "fat_cantor",
            "step",
            "hat",
            "wave",
            "staircase",
            "truncated",
            "stretching",
            "odd",
            "projections",
            "balance",
            "interpolation",
            "pinned",
        ];
        for name in names {
            let html = inline(name, "what it shows").unwrap();
            assert!(crate::markup::well_formed(&html.replace(" hidden", "")).is_ok(), "{name}");
            assert!(!html.contains("NaN") && !html.contains("inf,"), "{name}");
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
