//! Arrows between the rooms of the two libraries point downwards only, and no circle runs through the files of the
//! report and of the builder. Read from the sources: paths that begin with `crate`, or leave their room by `super`,
//! names that the root re-exports followed to their room. Code behind `#[cfg(test)]` does not count.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

/// Rooms of the two crates from the ground up: a room may use those before it.
const ROOMS: [(&str, &str); 2] = [
    (
        "toolkit/src",
        "value error estimate numeric quadrature order root grading mesh nearly_one kernel gram energy closed_forms \
         piecewise functions dual resolved boundary plane corner load fields function matrix constant trace poincare interpolation",
    ),
    (
        "src",
        "error text numeric mesh fem cone contact bounds strip singular problems edge rates proof",
    ),
];
/// Crates whose rooms are not ranked.
const OTHERS: [&str; 2] = ["examples/report/src", "book/builder/src"];

type Arrows = BTreeMap<String, BTreeSet<String>>;

/// The code without comments and tests.
fn code(path: &Path) -> String {
    let text = std::fs::read_to_string(path).unwrap();
    let text = text.split("#[cfg(test)]\nmod ").next().unwrap_or("");
    text.lines().filter_map(|line| line.split("//").next()).collect::<Vec<_>>().join("\n")
}

fn files(directory: &Path) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(directory).unwrap().map(|entry| entry.unwrap().path());
    let inside = |path: PathBuf| if path.is_dir() { files(&path) } else { vec![path] };
    entries.flat_map(inside).filter(|path| path.extension().is_some_and(|e| e == "rs")).collect()
}

/// The first words of what follows every `root` in the code, `root::{a::b, c}` taken apart.
fn named<'a>(code: &'a str, root: &str) -> Vec<&'a str> {
    let word = |text: &'a str| {
        text.trim_start().split(|c: char| !c.is_alphanumeric() && c != '_').next().unwrap()
    };
    let mut found = Vec::new();
    for rest in code.split(root).skip(1) {
        let Some(group) = rest.strip_prefix('{') else {
            found.push(word(rest));
            continue;
        };
        let (mut depth, mut start) = (0, 0);
        for (at, c) in group.char_indices() {
            match c {
                ',' | '}' if depth == 0 => {
                    found.push(word(&group[start..at]));
                    start = at + 1;
                    if c == '}' {
                        break;
                    }
                }
                '{' => depth += 1,
                '}' => depth -= 1,
                _ => {}
            }
        }
    }
    found
}

fn arrows(source: &Path) -> Arrows {
    let files = files(source);
    let room = |path: &Path| {
        let first = path.strip_prefix(source).unwrap().components().next().unwrap();
        first.as_os_str().to_str().unwrap().trim_end_matches(".rs").to_owned()
    };
    let rooms: BTreeSet<String> = files.iter().map(|path| room(path)).collect();
    // What the root re-exports, by its room.
    let root = code(&source.join("lib.rs"));
    let exported: BTreeMap<&str, &str> = root
        .split(';')
        .filter_map(|statement| statement.split_once("use ")?.1.split_once("::"))
        .flat_map(|(room, names)| names.split([',', '{', '}']).map(move |name| (name.trim(), room)))
        .collect();
    let mut found: Arrows = BTreeMap::new();
    for path in files.iter().filter(|path| !["lib", "main", "book"].contains(&&*room(path))) {
        let depth = path.strip_prefix(source).unwrap().components().count()
            - usize::from(path.ends_with("mod.rs"));
        let code = code(path).replace(&"super::".repeat(depth), "crate::");
        let own = room(path);
        let targets =
            named(&code, "crate::").into_iter().filter_map(|name| match rooms.contains(name) {
                true => Some(name.to_owned()),
                false => exported.get(name).map(|&room| room.to_owned()),
            });
        let targets = targets.filter(|target| *target != own);
        found.entry(own.clone()).or_default().extend(targets.collect::<Vec<_>>());
    }
    found
}

/// The arrows that do not point to a room before.
fn upwards(arrows: &Arrows, rooms: &[&str]) -> Vec<String> {
    let rank = |name: &str| rooms.iter().position(|room| *room == name);
    let all = arrows.iter().flat_map(|(from, targets)| targets.iter().map(move |to| (from, to)));
    all.filter(|(from, to)| rank(from).is_none() || rank(to).is_none() || rank(to) >= rank(from))
        .map(|(from, to)| format!("{from} -> {to}"))
        .collect()
}

/// The rooms that are left when rooms without an arrow to another one that is left are taken away, again and again.
fn circle(mut arrows: Arrows) -> Vec<String> {
    loop {
        let left: BTreeSet<String> = arrows.keys().cloned().collect();
        let before = arrows.len();
        arrows.retain(|_, targets| targets.iter().any(|to| left.contains(to)));
        if arrows.len() == before {
            return arrows.into_keys().collect();
        }
    }
}

#[test]
fn arrows_between_rooms_point_downwards_and_in_no_circle() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    for (source, rooms) in ROOMS {
        let found = arrows(&root.join(source));
        assert!(found.len() > 10, "{source}: little was read");
        let upwards = upwards(&found, &rooms.split_whitespace().collect::<Vec<_>>());
        assert!(upwards.is_empty(), "{source}: {upwards:#?}");
    }
    for source in OTHERS {
        let found = arrows(&root.join(source));
        assert!(found.values().map(BTreeSet::len).sum::<usize>() > 15, "{source}: little was read");
        assert_eq!(circle(found), Vec::<String>::new(), "{source}");
    }
}
