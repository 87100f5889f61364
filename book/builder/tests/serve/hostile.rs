//! Requests that a page of the book would never send: each is refused and starts no program.

use super::http::{Book, answer, short};
use super::lists::{BODIES, EXAMPLES, HOSTS, METHODS, NAMES, ORIGINS, PAGES, PATHS, VALUES, words};
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
    let good = asked(book, "planted", "first.html", &json!({"x": "0.4"}));
    let good = String::from_utf8(good).unwrap();
    assert!(good.contains(from), "{from}");
    good.replacen(from, to, 1).into_bytes()
}

fn attempts(book: &Book) -> Vec<Attempt> {
    let (host, port) = (book.host(), book.address.port().to_string());
    let with_port = |text: &str| text.replace("PORT", &port);
    let mut all: Vec<Attempt> = Vec::new();
    let mut push = |what: String, bytes: Vec<u8>| all.push((what, bytes));
    for name in words(HOSTS).iter().map(|name| with_port(name)) {
        let get = format!("GET / HTTP/1.1\r\nHost: {name}\r\nConnection: close\r\n\r\n");
        push(format!("GET, host {name}"), get.into_bytes());
        push(format!("POST, host {name}"), changed(book, &format!("Host: {host}"), &format!("Host: {name}")));
    }
    for origin in words(ORIGINS).iter().map(|name| with_port(name)) {
        let (from, to) = (format!("Origin: http://{host}"), format!("Origin: {origin}"));
        push(format!("origin {origin}"), changed(book, &from, &to));
    }
    for path in words(PATHS) {
        let get = format!("GET {path} HTTP/1.1\r\nHost: {host}\r\nConnection: close\r\n\r\n");
        push(format!("path {path}"), get.into_bytes());
    }
    for path in ["/run?x=1", "/run/", "/RUN", "/", "/first.html", "/../run", "/run/../run"] {
        push(format!("POST {path}"), changed(book, "POST /run ", &format!("POST {path} ")));
    }
    for method in words(METHODS) {
        push(method.clone(), changed(book, "POST", &method));
    }
    for (name, values) in VALUES {
        for value in words(values).iter().filter(|value| value.trim() != "0.5" && value.trim() != "block") {
            // A value of blanks alone is the default.
            let value = if value.trim().is_empty() { "8,8" } else { value.as_str() };
            let value = if value == "wait\n" { "wait\nx" } else { value };
            push(format!("{name} = {value:?}"), asked(book, "planted", "first.html", &json!({name: value})));
        }
    }
    for name in words(NAMES) {
        push(format!("option {name:?}"), asked(book, "planted", "first.html", &json!({name: "0.4"})));
    }
    for example in words(EXAMPLES) {
        push(format!("example {example:?}"), asked(book, &example, "first.html", &json!({})));
    }
    for page in words(PAGES) {
        push(format!("page {page:?}"), asked(book, "planted", &page, &json!({})));
    }
    for body in BODIES {
        push(format!("body {body}"), book.post(body));
    }
    for kind in
        ["text/plain", "application/x-www-form-urlencoded", "multipart/form-data", "application/json; x", ""]
    {
        push(format!("type {kind}"), changed(book, "application/json", kind));
    }
    let long = "9".repeat(300);
    push("long value".into(), asked(book, "planted", "first.html", &json!({"x": long})));
    push("long list".into(), asked(book, "planted", "first.html", &json!({"nu": "0.1,".repeat(17) + "0.1"})));
    push("body of a megabyte".into(), book.post(&"x".repeat(1 << 20)));
    push("deep JSON".into(), book.post(&"[".repeat(4000)));
    let (megabyte, own) = ("y".repeat(1 << 20), format!("Origin: http://{host}\r\n"));
    for (what, from, to) in [
        ("no origin", own.as_str(), String::new()),
        ("two origins", "Origin:", format!("{own}Origin:")),
        ("two hosts", "Host:", format!("Host: {host}\r\nHost:")),
        ("no host", &format!("Host: {host}\r\n"), String::new()),
        ("header of a megabyte", "Host:", format!("X: {megabyte}\r\nHost:")),
        ("a thousand headers", "Host:", "X: y\r\n".repeat(1000) + "Host:"),
        ("address of a megabyte", "POST /run", format!("POST /{megabyte}")),
        ("a proxy", "POST /run", format!("POST http://{host}/run")),
        ("another's proxy", "POST /run", "POST http://evil.example/run".to_owned()),
        ("two lengths", "Content-Length:", "Content-Length: 1\r\nContent-Length:".to_owned()),
        ("length and chunks", "Content-Length:", "Transfer-Encoding: x\r\nContent-Length:".to_owned()),
        ("negative length", "Content-Length: ", "Content-Length: -".to_owned()),
        ("HTTP/3.0", "HTTP/1.1", "HTTP/3.0".to_owned()),
    ] {
        push(what.into(), changed(book, from, &to));
    }
    push("connect".into(), format!("CONNECT evil.example:443 HTTP/1.1\r\nHost: {host}\r\n\r\n").into_bytes());
    push("HTTP/0.9".into(), b"GET /\r\n\r\n".to_vec());
    push("binary".into(), vec![0xff; 512]);
    push("TLS".into(), b"\x16\x03\x01\x02\x00\x01\x00\x01\xfc\x03\x03".repeat(40));
    push("nothing but ends of lines".into(), b"\r\n".repeat(20_000));
    push("HTTP/2".into(), b"PRI * HTTP/2.0\r\n\r\nSM\r\n\r\n".to_vec());
    let chunks = format!("8000\r\n{}\r\n0\r\n\r\n", "x".repeat(0x8000));
    let head = format!(
        "POST /run HTTP/1.1\r\nHost: {host}\r\nOrigin: http://{host}\r\nContent-Type: application/json\r\n"
    );
    push("long chunks".into(), format!("{head}Transfer-Encoding: chunked\r\n\r\n{chunks}").into_bytes());
    push("broken chunks".into(), format!("{head}Transfer-Encoding: chunked\r\n\r\nzz\r\n").into_bytes());
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
    println!("{} hostile requests refused", all.len());
}

#[test]
fn slow_requests_are_cut_off_and_keep_nobody_waiting() {
    let book = Book::serve(short());
    let host = book.host();
    let head = format!(
        "POST /run HTTP/1.1\r\nHost: {host}\r\nOrigin: http://{host}\r\nContent-Type: application/json\r\n"
    );
    let slow = [
        String::new(),
        "POST /ru".to_owned(),
        head.clone(),
        format!("{head}Content-Length: 100\r\n\r\n"),
        format!("{head}Content-Length: 100\r\n\r\n{{\"example\""),
        format!("{head}Transfer-Encoding: chunked\r\n\r\n5\r\n{{"),
    ];
    let mut open: Vec<TcpStream> = Vec::new();
    for start in slow.iter().cycle().take(48) {
        let mut stream = TcpStream::connect(book.address).unwrap();
        stream.write_all(start.as_bytes()).unwrap();
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

/// More connections than are answered at once: the others wait until the idle ones are cut off.
#[test]
fn a_crowd_is_cut_off() {
    let book = Book::serve(short());
    let crowd: Vec<TcpStream> = (0..200).map(|_| TcpStream::connect(book.address).unwrap()).collect();
    let (status, _) = book.get("/first.html");
    assert_eq!(status, 200);
    drop(crowd);
}
