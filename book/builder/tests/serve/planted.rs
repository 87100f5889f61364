//! An example for the tests of `cargo book serve`: it answers, waits, fails, writes or takes memory as it is
//! told, and leaves a line beside its program each time it is started.

use std::io::Write;
use std::path::PathBuf;
use std::time::Duration;

fn main() -> std::io::Result<()> {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let option =
        |name: &str| words.iter().find_map(|word| word.strip_prefix(&format!("--{name}=")));
    let path = |name: &str| {
        words.iter().position(|w| w == name).and_then(|k| words.get(k + 1)).map(PathBuf::from)
    };
    let (Some(values), Some(out)) = (path("--values"), path("--out")) else {
        std::process::exit(3)
    };
    let log = std::env::current_exe()?.with_extension("log");
    let mut log = std::fs::File::options().create(true).append(true).open(log)?;
    writeln!(log, "{}", words.join(" "))?;
    std::fs::create_dir_all(&out)?;
    match option("mode").unwrap_or("answer") {
        "wait" => std::thread::sleep(Duration::from_secs(600)),
        "refuse" => {
            eprintln!("error: x = 3 is outside [0, 1]\nand more");
            std::process::exit(2);
        }
        "crash" => std::process::exit(101),
        "silent" => return Ok(()),
        "write" => {
            let mut file = std::fs::File::create(out.join("much.svg"))?;
            loop {
                file.write_all(&[b'x'; 1 << 16])?;
            }
        }
        "grow" => {
            let mut held: Vec<Vec<u8>> = Vec::new();
            loop {
                held.push(vec![1; 1 << 22]);
                std::thread::sleep(Duration::from_millis(1));
            }
        }
        _ => {}
    }
    let x = option("x").unwrap_or("0.5");
    let finding = format!(
        r#"{{"finding": "k", "outcome": "holds", "words": "now x is {x}", "comparison": "0 <= 1"}}"#
    );
    let head =
        r#""label": "l", "claim": "c", "measured": "m", "verdict": "holds", "confirmed": true"#;
    let table =
        format!(r#""columns": [{{"key": "x", "title": "x", "meaning": ""}}], "rows": [["{x}"]]"#);
    let json = format!(r#"{{{head}, "values": {{"x": {x}}}, "findings": [{finding}], {table}}}"#);
    std::fs::write(values, json)?;
    let svg = format!(
        "<svg viewBox=\"0 0 10 10\" xmlns=\"http://www.w3.org/2000/svg\"><text>x = {x}</text></svg>"
    );
    std::fs::write(out.join("chart.svg"), svg)
}
