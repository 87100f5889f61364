//! From a request to an answer; everything that is not expected is refused before anything is looked up.

use super::laboratory::Laboratory;
use super::render::render;
use super::run::{Outcome, Refusal, run};
use crate::options::arguments;
use http_body_util::{BodyExt, Full, Limited};
use hyper::body::{Bytes, Incoming};
use hyper::header::{self, HeaderMap, HeaderName, HeaderValue};
use hyper::{Method, Request, Response, StatusCode};
use serde_json::{Map, Value, json};
use std::convert::Infallible;
use std::net::SocketAddr;
use std::sync::Arc;
use tokio::time::timeout;

type Answer = Response<Full<Bytes>>;
/// Status and words of a refusal.
type Refused = (StatusCode, String);

/// Where a page sends what it asks.
const RUN: &str = "/run";
/// Headers of every answer: nothing is loaded from elsewhere, no other page frames or reads this one.
const HEADERS: [(HeaderName, &str); 6] = [
    (
        header::CONTENT_SECURITY_POLICY,
        "default-src 'self'; script-src 'self' 'unsafe-inline'; style-src 'self' 'unsafe-inline'; \
         img-src 'self' data:; object-src 'none'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'",
    ),
    (header::X_CONTENT_TYPE_OPTIONS, "nosniff"),
    (header::X_FRAME_OPTIONS, "DENY"),
    (header::REFERRER_POLICY, "no-referrer"),
    (header::CACHE_CONTROL, "no-store"),
    (HeaderName::from_static("cross-origin-resource-policy"), "same-origin"),
];

/// Answers one request.
pub(super) async fn answer(
    request: Request<Incoming>,
    address: SocketAddr,
    laboratory: &Laboratory,
) -> Result<Answer, Infallible> {
    let is_head = request.method() == Method::HEAD;
    let mut answer = match reply(request, address, laboratory).await {
        Ok(answer) => answer,
        Err((status, words)) => {
            let mut answer =
                written("application/json", json!({"error": words}).to_string().into_bytes());
            *answer.status_mut() = status;
            // What is left of a refused request is not read as the next one.
            answer.headers_mut().insert(header::CONNECTION, HeaderValue::from_static("close"));
            answer
        }
    };
    for (name, value) in HEADERS {
        answer.headers_mut().insert(name, HeaderValue::from_static(value));
    }
    if is_head {
        *answer.body_mut() = Full::default();
    }
    Ok(answer)
}

fn written(kind: &'static str, content: Vec<u8>) -> Answer {
    let mut answer = Response::new(Full::new(Bytes::from(content)));
    answer.headers_mut().insert(header::CONTENT_TYPE, HeaderValue::from_static(kind));
    answer
}

fn refused(status: StatusCode, words: impl Into<String>) -> Refused {
    (status, words.into())
}

async fn reply(
    request: Request<Incoming>,
    address: SocketAddr,
    laboratory: &Laboratory,
) -> Result<Answer, Refused> {
    let host = host(request.headers(), address)?;
    if request.uri().authority().is_some() {
        return Err(refused(StatusCode::BAD_REQUEST, "not a proxy"));
    }
    match *request.method() {
        Method::GET | Method::HEAD => {
            let file = laboratory.file(request.uri().path());
            let file = file.ok_or_else(|| refused(StatusCode::NOT_FOUND, "no such page"))?;
            Ok(written(file.kind, file.content.clone()))
        }
        Method::POST => compute(request, &host, laboratory).await,
        _ => Err(refused(StatusCode::METHOD_NOT_ALLOWED, "not answered")),
    }
}

/// The one value of a header; two are as bad as none.
fn single<'h>(headers: &'h HeaderMap, name: &HeaderName) -> Option<&'h str> {
    let mut values = headers.get_all(name).iter();
    let value = values.next()?.to_str().ok()?;
    values.next().is_none().then_some(value)
}

/// `Host`, which must name this server: a name that somebody else resolves to this machine is refused.
fn host(headers: &HeaderMap, address: SocketAddr) -> Result<String, Refused> {
    let port = address.port();
    let ours = [format!("127.0.0.1:{port}"), format!("localhost:{port}")];
    let host = single(headers, &header::HOST).unwrap_or("");
    let found = ours.into_iter().find(|name| name == host);
    found.ok_or_else(|| refused(StatusCode::MISDIRECTED_REQUEST, "not this host"))
}

/// What a page asks, and its outcome in the words of the page.
async fn compute(
    request: Request<Incoming>,
    host: &str,
    laboratory: &Laboratory,
) -> Result<Answer, Refused> {
    let headers = request.headers();
    if single(headers, &header::ORIGIN) != Some(&format!("http://{host}")) {
        return Err(refused(StatusCode::FORBIDDEN, "not from a page of this book"));
    }
    if request.uri().path() != RUN || request.uri().query().is_some() {
        return Err(refused(StatusCode::NOT_FOUND, "nothing is computed there"));
    }
    if single(headers, &header::CONTENT_TYPE) != Some("application/json") {
        return Err(refused(StatusCode::UNSUPPORTED_MEDIA_TYPE, "not JSON"));
    }
    let limits = *laboratory.limits();
    let body = Limited::new(request.into_body(), limits.body).collect();
    let body = timeout(limits.request, body).await;
    let body = body.map_err(|_| refused(StatusCode::REQUEST_TIMEOUT, "too slow"))?;
    let body =
        body.map_err(|_| refused(StatusCode::PAYLOAD_TOO_LARGE, "too long or broken"))?.to_bytes();
    let asked: Map<String, Value> = serde_json::from_slice(&body)
        .map_err(|_| refused(StatusCode::BAD_REQUEST, "not a JSON object"))?;
    let question = Question::read(&asked, laboratory)
        .map_err(|words| refused(StatusCode::UNPROCESSABLE_ENTITY, words))?;
    let outcome = outcome(&question, laboratory).await?;
    let json = render(laboratory, question.example, question.page, &outcome);
    Ok(written("application/json", json.to_string().into_bytes()))
}

/// A request that was understood.
struct Question<'a> {
    example: &'a str,
    /// Source of the page that asks.
    page: &'a str,
    arguments: Vec<String>,
}

impl<'a> Question<'a> {
    fn read(asked: &'a Map<String, Value>, laboratory: &'a Laboratory) -> Result<Self, String> {
        let known = |key: &String| matches!(key.as_str(), "example" | "page" | "options");
        if !asked.keys().all(known) {
            return Err("an unknown entry".to_owned());
        }
        let text = |key: &str| asked.get(key).and_then(Value::as_str);
        let example = text("example").filter(|name| laboratory.program(name).is_some());
        let example = example.ok_or("an unknown example")?;
        let page = text("page").and_then(|name| laboratory.page(name)).ok_or("an unknown page")?;
        let options = asked.get("options").and_then(Value::as_object).ok_or("no options")?;
        let description =
            laboratory.data().options.get(example).ok_or("an example without options")?;
        Ok(Self { example, page, arguments: arguments(description, options)? })
    }
}

/// An outcome that is kept, or that of a run once the one before has ended.
async fn outcome(
    question: &Question<'_>,
    laboratory: &Laboratory,
) -> Result<Arc<Outcome>, Refused> {
    let key = (question.example.to_owned(), question.arguments.clone());
    if let Some(kept) = laboratory.recall(&key) {
        return Ok(kept);
    }
    let limits = laboratory.limits();
    let turn = timeout(limits.patience, laboratory.turn.acquire()).await;
    let _turn = turn.map_err(|_| refused(StatusCode::CONFLICT, "another run is not finished"))?;
    let program = laboratory.program(question.example);
    let program = program.ok_or_else(|| refused(StatusCode::NOT_FOUND, "an unknown example"))?;
    match run(program, &question.arguments, limits).await {
        Ok(outcome) => {
            let outcome = Arc::new(outcome);
            laboratory.keep(key, &outcome);
            Ok(outcome)
        }
        Err(Refusal::Parameters(words)) => Err(refused(StatusCode::UNPROCESSABLE_ENTITY, words)),
        Err(Refusal::Run(words)) => Err(refused(StatusCode::SERVICE_UNAVAILABLE, words)),
    }
}
