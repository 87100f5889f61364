//! Why a row has no entry in a column: a key means the same in all examples.

/// Keys with the reason why a number can be missing, where nothing of the row says it in words.
const REASONS: [(&str, &str); 53] = [
    ("K_whole", "the seminorm of the whole body is not known in closed form"),
    ("algebraic", "no second solution to compare with"),
    ("algebraic_error", "a direct solver: rounding only"),
    ("alpha", "a critical exponent below nu = 1/2: no Hoelder constant"),
    ("bound", "a function that is not in the space of the remark"),
    ("c_whole", "the seminorm of the whole body is not known in closed form"),
    ("coarse", "the state at the end goes on through all resolved radii"),
    ("constant", "the norm of the solution is not computed for this scene"),
    ("error", "no number was computed: the row says why"),
    ("error_ratio", "no coarser mesh with digits"),
    ("estimate", "only multigrid estimates its algebraic error"),
    ("exponent", "too few levels with a slack above rounding"),
    ("explained", "the constant itself is not computed at this length, only its bounds"),
    ("factor", "another solver took over"),
    ("falk", "takes a rate, and a rate takes three meshes"),
    ("fine", "the state at the end goes on through all resolved radii"),
    ("flag", "a level that counts in every fit and every bound"),
    ("full", "a function that is not in the space of the remark"),
    ("half_width", "too few levels with digits for a fit"),
    ("hoelder", "a critical exponent below nu = 1/2: no Hoelder constant"),
    ("hoelder_growth", "a critical exponent below nu = 1/2: no Hoelder constant"),
    ("iterations_cold", "the first mesh begins cold, and multigrid is not started twice"),
    ("kappa_whole", "the seminorm of the whole body is not known in closed form"),
    ("lagrange", "the function is not in H^1"),
    ("limit", "the function is not in H^1"),
    ("loss", "a line without a loss of its own"),
    ("mesh_derivative", "best constants on a mesh are computed up to 1024 elements, and for few of these"),
    ("mesh_l2", "best constants on a mesh are computed up to 1024 elements, and for few of these"),
    ("mesh_long", "best constants on a mesh are computed up to 1024 elements, and for few of these"),
    ("nodal", "no term on some level, or too few levels for a fit"),
    ("nodal_half", "no term on some level, or too few levels for a fit"),
    ("midpoint", "no term on some level, or too few levels for a fit"),
    ("midpoint_half", "no term on some level, or too few levels for a fit"),
    ("order", "takes two meshes with digits"),
    ("outer", "no gap within the resolved radii"),
    ("poisson", "a scalar problem"),
    ("power", "no pressure at the end"),
    ("ratio", "the constant itself is not computed at this length, only its bounds"),
    ("rest", "the constant itself is not computed at this length, only its bounds"),
    ("share", "the seminorm of the whole body is not known in closed form"),
    ("smooth_rate", "a rate takes three meshes"),
    ("smooth_rate_error", "a rate takes three meshes"),
    ("square", "the constant itself is not computed at this length, only its bounds"),
    ("steps", "another solver took over"),
    ("term", "no exact solution is known that gives the term"),
    ("term_half_width", "no consistency term on some level, or too few levels for a fit"),
    ("term_order", "no consistency term on some level, or too few levels for a fit"),
    ("term_over_paper", "no exact solution is known that gives the term"),
    ("term_ratio", "no consistency term on any level"),
    ("theta", "below the range of binary64: its logarithm is given"),
    ("to_half", "a step is in H^s for s < 1/2 only"),
    ("tried", "another solver took over"),
    ("uncertainty", "no number, hence no uncertainty of it"),
];

/// Where no reason is known.
pub(super) const UNKNOWN: &str = "not reported";

/// The reason for a column, by its key; some are said once for several columns.
pub(super) fn reason(key: &str) -> &'static str {
    let known = |key: &str| REASONS.iter().find(|(known, _)| *known == key).map(|(_, reason)| *reason);
    let found = known(key).or_else(|| match key {
        "true_error" => Some("no closed form, or the norm is infinite"),
        "wave_rate" | "wave_rate_error" => known("smooth_rate"),
        _ => None,
    });
    found.unwrap_or(UNKNOWN)
}
