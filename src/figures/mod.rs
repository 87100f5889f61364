//! Charts and mesh pictures (SVG).
