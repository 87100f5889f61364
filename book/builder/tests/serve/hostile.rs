//! Requests that a page of the book would never send: each is refused and starts no program.

use super::http::{Book, answer, short};
use super::lists::{
    BODIES, EXAMPLES, HOSTS, METHODS, NAMES, ORIGINS, PAGES, PATHS, TYPES, VALUES, words,
};
use serde_json::{Value, json};
use std::io::Write;
use std::net::TcpStream;
use std::time::{Duration, Instant};

/// What is tried, and the bytes.
type Attempt = (String, Vec<u8>);

fn asked(book: &Book, example: &str, page: &str, options: &Value) -> Vec<u8> {
    book.post(&json!({"example": example, "page": page, "options": options}).to_string())
}

/// A good request with one part replaced.
fn changed(book: &Book, from: &str, to: &str) -> Vec<u8> {
    let good =
        String::from_utf8(asked(book, "planted", "first.html", &json!({"x": "0.4"}))).unwrap();
    assert!(good.contains(from), "{from}");
    good.replacen(from, to, 1).into_bytes()
}

fn attempts(book: &Book) -> Vec<Attempt> {
    let (host, port) = (book.host(), book.address.port().to_string());
    let own = format!("Origin: http://{host}\r\n");
    let get = |path: &str, host: &str| {
        format!("GET {path} HTTP/1.1\r\nHost: {host}\r\nConnection: close\r\n\r\n").into_bytes()
    };
    let long = "y".repeat(1 << 20);
    let mut all: Vec<Attempt> = Vec::new();
    let mut push =
        |what: &str, word: &str, bytes: Vec<u8>| all.push((format!("{what} {word:?}"), bytes));
    for name in words(HOSTS).iter().map(|name| name.replace("PORT", &port)) {
        push("GET, host", &name, get("/", &name));
        push(
            "POST, host",
            &name,
            changed(book, &format!("Host: {host}"), &format!("Host: {name}")),
        );
    }
    for name in words(ORIGINS).iter().map(|name| name.replace("PORT", &port)) {
        push("origin", &name, changed(book, &own, &format!("Origin: {name}\r\n")));
    }
    words(PATHS).iter().for_each(|path| push("path", path, get(path, &host)));
    for path in ["/run?x=1", "/run/", "/RUN", "/", "/first.html", "/../run", "/run/../run"] {
        push("POST", path, changed(book, "POST /run ", &format!("POST {path} ")));
    }
    words(METHODS).iter().for_each(|method| push("method", method, changed(book, "POST", method)));
    words(TYPES)
        .iter()
        .for_each(|kind| push("type", kind, changed(book, "application/json", kind)));
    let options = |options: &Value| asked(book, "planted", "first.html", options);
    for (name, values) in VALUES {
        words(values).iter().for_each(|value| push(name, value, options(&json!({name: value}))));
    }
    words(NAMES).iter().for_each(|name| push("option", name, options(&json!({name: "0.4"}))));
    push("value of", "300 digits", options(&json!({"x": "9".repeat(300)})));
    push("list of", "18 entries", options(&json!({"nu": "0.1,".repeat(17) + "0.1"})));
    for example in words(EXAMPLES) {
        push("example", &example, asked(book, &example, "first.html", &json!({})));
    }
    words(PAGES)
        .iter()
        .for_each(|page| push("page", page, asked(book, "planted", page, &json!({}))));
    for body in BODIES.replace('~', "\"").split('|').chain([long.as_str(), &"[".repeat(4000)]) {
        push("body", &body[..body.len().min(80)], book.post(body));
    }
    for (what, from, to) in [
        ("no origin", own.as_str(), String::new()),
        ("two origins", "Origin:", format!("{own}Origin:")),
        ("two hosts", "Host:", format!("Host: {host}\r\nHost:")),
        ("header of a megabyte", "Host:", format!("X: {long}\r\nHost:")),
        ("a thousand headers", "Host:", "X: y\r\n".repeat(1000) + "Host:"),
        ("address of a megabyte", "POST /run", format!("POST /{long}")),
        ("another's proxy", "POST /run", "POST http://evil.example/run".to_owned()),
        ("two lengths", "Content-Length:", "Content-Length: 1\r\nContent-Length:".to_owned()),
    ] {
        push(what, "", changed(book, from, &to));
    }
    push("binary", "", vec![0xff; 512]);
    all
}

#[test]
fn hostile_requests_are_refused_and_start_nothing() {
    let book = Book::serve(short());
    let all = attempts(&book);
    assert!(all.len() >= 200, "{}", all.len());
    for (what, bytes) in &all {
        let (status, body) = book.raw(bytes);
        assert!(status == 0 || (400..=505).contains(&status), "{what}: {status} {body}");
        assert!(!body.contains("secret"), "{what}: {body}");
    }
    assert_eq!(book.runs(), Vec::<String>::new(), "a refused request started a program");
    // The list is of any worth only if the request that it spoils is answered.
    let (status, found) = book.ask(&json!({"x": "0.4"}));
    assert_eq!(status, 200, "{found}");
    assert_eq!(book.runs().len(), 1);
}

#[test]
fn slow_requests_are_cut_off_and_keep_nobody_waiting() {
    let book = Book::serve(short());
    let whole = String::from_utf8(book.post(r#"{"example": "planted"}"#)).unwrap();
    let mut open: Vec<TcpStream> = Vec::new();
    for share in (0..48).map(|k| k % 6) {
        let mut stream = TcpStream::connect(book.address).unwrap();
        stream.write_all(&whole.as_bytes()[..share * (whole.len() - 1) / 5]).unwrap();
        open.push(stream);
    }
    let start = Instant::now();
    let (status, _) = book.ask(&json!({"x": "0.4"}));
    assert_eq!(status, 200);
    assert!(start.elapsed() < Duration::from_secs(10), "{:?}", start.elapsed());
    for mut stream in open {
        stream.set_read_timeout(Some(Duration::from_secs(10))).unwrap();
        let (status, _) = answer(&mut stream);
        assert!(matches!(status, 0 | 408), "{status}");
    }
    assert!(start.elapsed() < Duration::from_secs(20), "{:?}", start.elapsed());
    assert_eq!(book.runs().len(), 1);
}
