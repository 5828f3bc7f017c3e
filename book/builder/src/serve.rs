//! The server: the book on loopback, built again when a source changes.

use crate::build::{build, message};
use crate::project::Project;
use serde_json::json;
use std::error::Error;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::{Arc, Mutex};
use std::thread;
use std::time::{Duration, Instant, SystemTime};
use tiny_http::{Header, Request, Response, Server};

/// What the page asks for to know whether it is old.
#[derive(Default)]
struct Status {
    build: u64,
    error: Option<String>,
}

/// Asks for the status twice a second; loads the page anew after a build, shows what
/// is wrong above the old page.
const RELOAD: &str = "<script>(()=>{let seen;const box=document.createElement('pre');\
box.style.cssText='position:fixed;inset:auto 0 0 0;margin:0;padding:1em;max-height:50vh;overflow:auto;\
background:#7a1410;color:#fff;font:14px/1.4 monospace;white-space:pre-wrap;z-index:999';\
setInterval(async()=>{try{const s=await(await fetch('/__status')).json();\
if(seen===undefined)seen=s.build;if(s.build!==seen)location.reload();\
if(s.error){box.textContent=s.error;document.body.append(box)}else box.remove()}catch(e){}},500)})()</script>";

/// The sources of the book with their times: what makes it old when it changes.
fn sources(project: &Project) -> Vec<(PathBuf, Option<SystemTime>)> {
    let mut found = Vec::new();
    let mut pending: Vec<PathBuf> = [
        "book/src",
        "book/theme",
        "book/book.toml",
        "benches/record",
        "examples",
        "tests",
    ]
    .iter()
    .map(|part| project.path(part))
    .collect();
    while let Some(path) = pending.pop() {
        if path.is_dir() {
            let entries = fs::read_dir(&path).into_iter().flatten().flatten();
            pending.extend(entries.map(|entry| entry.path()));
        } else if let Ok(data) = fs::metadata(&path) {
            found.push((path, data.modified().ok()));
        }
    }
    found.sort();
    found
}

/// Builds and serves until it is stopped. A book that cannot be built is served as it
/// was, with the error shown above it.
///
/// # Errors
/// A port that is taken, or a first build that fails.
pub fn serve(project: &Project, port: u16, open: bool) -> Result<(), Box<dyn Error>> {
    let server = Server::http(("127.0.0.1", port)).map_err(|e| {
        format!(
            "cannot serve on 127.0.0.1:{port}: {e}; another port: cargo book --port {}",
            port.saturating_add(1)
        )
    })?;
    let out = project.path("book/book");
    let status = Arc::new(Mutex::new(Status::default()));
    let mut known = sources(project);
    eprintln!("Building the book …");
    rebuild(project, &out, &status);
    let address = format!(
        "http://127.0.0.1:{}/",
        server.server_addr().to_ip().map_or(port, |a| a.port())
    );
    eprintln!("Serving {address} (Ctrl+C stops; changes are built as you save)");
    if open {
        open_browser(&address);
    }
    let served = out.clone();
    let shared = Arc::clone(&status);
    thread::spawn(move || {
        for request in server.incoming_requests() {
            // A browser that hangs up is no concern of ours.
            let _ = answer(request, &served, &shared);
        }
    });
    loop {
        thread::sleep(Duration::from_millis(300));
        let now = sources(project);
        if now != known {
            known = now;
            rebuild(project, &out, &status);
        }
    }
}

fn rebuild(project: &Project, out: &Path, status: &Mutex<Status>) {
    let start = Instant::now();
    let done = build(project, out);
    let error = done.err().map(|error| message(error.as_ref()));
    match &error {
        None => eprintln!("Built in {:.1} s.", start.elapsed().as_secs_f64()),
        Some(error) => eprintln!("{error}\nThe last good book stays."),
    }
    if let Ok(mut status) = status.lock() {
        if error.is_none() {
            status.build += 1;
        }
        status.error = error;
    }
}

fn answer(request: Request, root: &Path, status: &Mutex<Status>) -> io::Result<()> {
    let url = request
        .url()
        .split(['?', '#'])
        .next()
        .unwrap_or("/")
        .to_owned();
    let header = |name: &str, value: &str| Header::from_bytes(name, value).ok();
    if url == "/__status" {
        let (build, error) = status
            .lock()
            .map(|s| (s.build, s.error.clone()))
            .unwrap_or_default();
        let body = json!({"build": build, "error": error}).to_string();
        let mut response = Response::from_string(body);
        response.headers_mut_push(header("Content-Type", "application/json"));
        return request.respond(response);
    }
    let Some(path) = file(root, &url) else {
        let page = fs::read(root.join("404.html")).unwrap_or_else(|_| b"not found".to_vec());
        let mut response = Response::from_data(page).with_status_code(404);
        response.headers_mut_push(header("Content-Type", "text/html; charset=utf-8"));
        return request.respond(response);
    };
    let mut bytes = fs::read(&path)?;
    let kind = content_type(&path);
    if kind.starts_with("text/html") {
        let page = String::from_utf8_lossy(&bytes);
        bytes = page
            .replacen("</body>", &format!("{RELOAD}</body>"), 1)
            .into_bytes();
    }
    let mut response = Response::from_data(bytes);
    response.headers_mut_push(header("Content-Type", kind));
    response.headers_mut_push(header("Cache-Control", "no-cache"));
    request.respond(response)
}

/// A header pushed if it could be made.
trait Push {
    fn headers_mut_push(&mut self, header: Option<Header>);
}

impl<R: io::Read> Push for Response<R> {
    fn headers_mut_push(&mut self, header: Option<Header>) {
        if let Some(header) = header {
            self.add_header(header);
        }
    }
}

/// The file for an address, if it lies in the book.
fn file(root: &Path, url: &str) -> Option<PathBuf> {
    let mut path = root.to_owned();
    for part in url.split('/').filter(|part| !part.is_empty()) {
        if part == ".." || part.contains(['\\', ':']) {
            return None;
        }
        path.push(part.replace("%20", " "));
    }
    if path.is_dir() {
        path.push("index.html");
    }
    path.is_file().then_some(path)
}

fn content_type(path: &Path) -> &'static str {
    match path.extension().and_then(|e| e.to_str()).unwrap_or("") {
        "html" => "text/html; charset=utf-8",
        "css" => "text/css; charset=utf-8",
        "js" => "text/javascript; charset=utf-8",
        "json" => "application/json",
        "svg" => "image/svg+xml",
        "png" => "image/png",
        "otf" => "font/otf",
        "ttf" => "font/ttf",
        "woff" => "font/woff",
        "woff2" => "font/woff2",
        "wasm" => "application/wasm",
        _ => "application/octet-stream",
    }
}

fn open_browser(address: &str) {
    let mut command = if cfg!(target_os = "windows") {
        let mut command = Command::new("cmd");
        command.args(["/C", "start", ""]);
        command
    } else if cfg!(target_os = "macos") {
        Command::new("open")
    } else {
        Command::new("xdg-open")
    };
    if let Err(error) = command.arg(address).spawn() {
        eprintln!("cannot open a browser ({error}); the address is {address}");
    }
}
