//! A small book that is served, and requests to it, byte by byte.

use book_builder::data::Data;
use book_builder::serve::{Laboratory, Limits, Server};
use book_builder::{Layout, build};
use serde_json::{Value, json};
use std::io::{Read, Write};
use std::net::{SocketAddr, TcpStream};
use std::path::Path;
use std::time::Duration;
use tempfile::TempDir;

pub const PAGE: &str = "# First {#first}

{{figure: planted/chart: A chart}}

{{table: planted}}

It is said: {{finding: planted/k}}; and {{value: planted/x: s3}}. {{finding: planted/k}}.
";

/// Limits that a test can wait for.
pub fn short() -> Limits {
    Limits {
        run: Duration::from_millis(1500),
        request: Duration::from_millis(400),
        patience: Duration::from_millis(300),
        output: 1 << 20,
        memory: 256 << 20,
        ..Limits::default()
    }
}

/// A book of one page, its server, and the log of its one program.
pub struct Book {
    directory: TempDir,
    pub address: SocketAddr,
}

impl Book {
    pub fn serve(limits: Limits) -> Self {
        let directory = tempfile::tempdir().unwrap();
        let root = directory.path();
        let write = |path: &str, text: &str| {
            let path = root.join(path);
            std::fs::create_dir_all(path.parent().unwrap()).unwrap();
            std::fs::write(path, text).unwrap();
        };
        let book = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
        let kept = |file: &str| std::fs::read_to_string(book.join(file)).unwrap();
        for file in
            ["book.toml", "style/book.css", "style/slider.js", "style/fit.js", "style/live.js"]
        {
            write(&format!("book/{file}"), &kept(file));
        }
        write("book/src/SUMMARY.md", "# Summary\n\n- [First](first.md)\n");
        write("book/src/first.md", PAGE);
        write(
            "src/book.rs",
            "    // chapters\n    readme: \"../../README.md\",\n    first: \"first.md\",\n    // end of chapters\n",
        );
        write("examples/planted.rs", "fn main() {}\n");
        write("secret.txt", "secret");
        let layout = Layout::of(root);
        let data = data();
        let output = build(&layout, &data).unwrap();
        // Its own copy, so that its log is its own.
        let program = root.join("planted");
        std::fs::copy(env!("CARGO_BIN_EXE_planted"), &program).unwrap();
        let laboratory = Laboratory::new(&layout, data, &output, &[program], limits).unwrap();
        let server = Server::bind(laboratory, 0).unwrap();
        let address = server.address();
        // Ends with the process of the tests.
        std::thread::spawn(move || server_runs(server));
        Self { directory, address }
    }

    /// The command lines of all runs so far.
    pub fn runs(&self) -> Vec<String> {
        let log =
            std::fs::read_to_string(self.directory.path().join("planted.log")).unwrap_or_default();
        log.lines().map(str::to_owned).collect()
    }

    /// The program that is run.
    pub fn program(&self) -> String {
        self.directory.path().join("planted").display().to_string()
    }

    /// Sends bytes and returns the status and the body; status 0 where the connection was closed without an
    /// answer.
    pub fn raw(&self, bytes: &[u8]) -> (u16, String) {
        let mut stream = TcpStream::connect(self.address).unwrap();
        stream.set_read_timeout(Some(Duration::from_secs(20))).unwrap();
        // A server that refuses early may close before all is sent.
        let _ = stream.write_all(bytes);
        answer(&mut stream)
    }

    pub fn host(&self) -> String {
        self.address.to_string()
    }

    pub fn get(&self, path: &str) -> (u16, String) {
        self.raw(
            format!("GET {path} HTTP/1.1\r\nHost: {}\r\nConnection: close\r\n\r\n", self.host())
                .as_bytes(),
        )
    }

    /// A request to compute, as the page sends it.
    pub fn post(&self, body: &str) -> Vec<u8> {
        let host = self.host();
        format!(
            "POST /run HTTP/1.1\r\nHost: {host}\r\nOrigin: http://{host}\r\nContent-Type: application/json\r\n\
             Connection: close\r\nContent-Length: {}\r\n\r\n{body}",
            body.len()
        )
        .into_bytes()
    }

    pub fn ask(&self, options: &Value) -> (u16, Value) {
        let body =
            json!({"example": "planted", "page": "first.html", "options": options}).to_string();
        let (status, text) = self.raw(&self.post(&body));
        (status, serde_json::from_str(&text).unwrap_or(Value::Null))
    }
}

fn server_runs(server: Server) {
    server.run().unwrap();
}

/// Reads to the end: every request here asks for the connection to be closed.
pub fn answer(stream: &mut TcpStream) -> (u16, String) {
    let mut bytes = Vec::new();
    let _ = stream.read_to_end(&mut bytes);
    let text = String::from_utf8_lossy(&bytes).into_owned();
    let (head, body) = text.split_once("\r\n\r\n").unwrap_or((&text, ""));
    let status = head.split(' ').nth(1).and_then(|word| word.parse().ok()).unwrap_or(0);
    (status, body.to_owned())
}

fn data() -> Data {
    let example = json!({
        "label": "l", "claim": "c", "measured": "m", "verdict": "holds", "confirmed": true, "values": {"x": 0.5},
        "findings": [{"finding": "k", "outcome": "holds", "words": "now x is 1/2", "comparison": "0 <= 1"}],
        "columns": [{"key": "x", "title": "x", "meaning": ""}], "rows": [["0.5"]],
    });
    let modes = ["answer", "wait", "refuse", "crash", "silent", "write", "grow"];
    let options = json!({"about": "planted", "cost": "quick", "options": [
        {"name": "x", "help": "a number", "kind": "number", "list": false, "default": "0.5", "range": [0.0, 1.0],
            "slider": [0.0, 1.0], "scale": "steps"},
        {"name": "nu", "help": "orders", "kind": "order", "list": true, "default": "0.5", "range": [0.0, 1.0]},
        {"name": "n", "help": "count", "kind": "integer", "list": false, "default": "8", "range": [1.0, 64.0]},
        {"name": "tolerance", "help": "accuracy", "kind": "tolerance", "list": false, "default": "balanced"},
        {"name": "levels", "help": "levels", "kind": "levels", "list": false, "default": "3-9"},
        {"name": "scene", "help": "scene", "kind": "named", "list": false, "default": "block", "choices": ["block", "cantor"]},
        {"name": "lines", "help": "more", "kind": "flag", "list": false, "default": ""},
        {"name": "mode", "help": "mode", "kind": "choice", "list": false, "default": "answer", "choices": modes},
    ]});
    let svg = "<svg viewBox=\"0 0 10 10\" xmlns=\"http://www.w3.org/2000/svg\"><text>x = 1/2</text></svg>"
        .to_owned();
    Data {
        examples: [("planted".to_owned(), example)].into_iter().collect(),
        options: [("planted".to_owned(), options)].into_iter().collect(),
        figures: [("planted/chart".to_owned(), svg)].into(),
        ..Data::default()
    }
}
