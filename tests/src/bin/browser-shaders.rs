//! Host file: compiles every shader of the workspace in a browser, by its WebGPU:
//! `cargo run --release --bin browser-shaders -- BROWSER`. `scripts/check-wgsl-in-browser.sh` installs one.
//!
//! naga takes texts that Tint, the compiler of Chromium, refuses. This serves the texts and a page on localhost, starts the
//! browser without a window, and prints what its compiler says. It fails where a shader has an error, where the browser does
//! not answer, and where it compiles a text that it must refuse.

use std::io::{self, BufRead, BufReader, Read, Write};
use std::net::{TcpListener, TcpStream};
use std::process::{Child, Command, ExitCode, Stdio};
use std::sync::Arc;
use std::sync::mpsc::{self, Sender};
use std::time::Duration;

use glimt_tests::shaders::{self, ShaderText};

/// How long the browser may take for everything.
const PATIENCE: Duration = Duration::from_secs(180);

/// A text that the compiler must refuse: a decimal above the largest `f32`, which naga takes.
const REFUSED: &str = "const LARGEST: f32 = 340282350000000000000000000000000000000f;";

/// Asks for each shader, compiles it, and sends a line for each message and one at its end.
const PAGE: &str = "<!doctype html><meta charset=utf-8><title>shaders</title><script type=module>
const lines = [];
try {
    const adapter = await navigator.gpu.requestAdapter();
    const device = await adapter.requestDevice();
    for (let i = 0; i < COUNT; i++) {
        const code = await (await fetch('/shader/' + i)).text();
        const info = await device.createShaderModule({ code }).getCompilationInfo();
        for (const m of info.messages) {
            const text = m.message.replaceAll('\\n', ' ');
            lines.push(`${i} ${m.type} line ${m.lineNum}: ${text}`);
        }
        lines.push(`${i} compiled`);
    }
} catch (error) {
    lines.push('failed ' + error);
}
await fetch('/messages', { method: 'POST', body: lines.join('\\n') });
</script>";

fn main() -> ExitCode {
    let Some(browser) = std::env::args().nth(1) else {
        eprintln!("usage: browser-shaders BROWSER");
        return ExitCode::FAILURE;
    };
    match check(&browser) {
        Ok(0) => ExitCode::SUCCESS,
        Ok(errors) => {
            println!("{errors} shaders do not compile in the browser");
            ExitCode::FAILURE
        }
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

/// Compiles all shaders, prints what the browser says, and returns how many have an error.
fn check(browser: &str) -> Result<usize, Box<dyn std::error::Error>> {
    let mut texts = shaders::all()?;
    texts.push(ShaderText {
        name: "a text that must be refused".to_owned(),
        wgsl: REFUSED.to_owned(),
    });
    let texts: Arc<[ShaderText]> = texts.into();

    let listener = TcpListener::bind("127.0.0.1:0")?;
    let address = format!("http://localhost:{}/", listener.local_addr()?.port());
    let (sender, receiver) = mpsc::channel();
    let served = Arc::clone(&texts);
    std::thread::spawn(move || {
        for stream in listener.incoming().flatten() {
            let (served, sender) = (Arc::clone(&served), sender.clone());
            // A browser opens connections ahead of its requests; each waits on a thread of its own.
            std::thread::spawn(move || answer(stream, &served, &sender));
        }
    });
    let window = Browser::open(browser, &address)?;
    let messages = receiver
        .recv_timeout(PATIENCE)
        .map_err(|_| format!("{browser} did not answer within {} s", PATIENCE.as_secs()))?;
    drop(window);

    let mut errors = 0;
    for (i, text) in texts.iter().enumerate() {
        let prefix = format!("{i} ");
        let said: Vec<&str> = messages
            .lines()
            .filter_map(|l| l.strip_prefix(&prefix))
            .collect();
        if !said.contains(&"compiled") {
            return Err(
                format!("{}: the browser did not compile it: {messages}", text.name).into(),
            );
        }
        let is_wrong = said.iter().any(|message| message.starts_with("error "));
        if i + 1 == texts.len() {
            if !is_wrong {
                return Err(format!("the browser compiles {}", text.name).into());
            }
            continue;
        }
        errors += usize::from(is_wrong);
        println!("{} {}", if is_wrong { "FAILED" } else { "ok" }, text.name);
        for message in said.iter().filter(|message| **message != "compiled") {
            println!("    {message}");
        }
    }
    Ok(errors)
}

/// Answers one request: the page, a shader, or the page's messages.
fn answer(stream: TcpStream, texts: &[ShaderText], messages: &Sender<String>) -> io::Result<()> {
    let mut reader = BufReader::new(&stream);
    let mut request = String::new();
    reader.read_line(&mut request)?;
    let mut length = 0;
    loop {
        let mut line = String::new();
        reader.read_line(&mut line)?;
        let Some((key, value)) = line.split_once(':') else {
            break;
        };
        if key.eq_ignore_ascii_case("content-length") {
            length = value.trim().parse().unwrap_or(0);
        }
    }
    let mut body = String::new();
    reader.take(length).read_to_string(&mut body)?;

    let path = request.split(' ').nth(1).unwrap_or_default();
    let shader = path
        .strip_prefix("/shader/")
        .and_then(|i| texts.get(i.parse::<usize>().ok()?));
    let (status, kind, content) = match (path, shader) {
        ("/", _) => {
            let page = PAGE.replace("COUNT", &texts.len().to_string());
            ("200 OK", "text/html", page)
        }
        (_, Some(text)) => ("200 OK", "text/plain; charset=utf-8", text.wgsl.clone()),
        ("/messages", _) => ("200 OK", "text/plain", String::new()),
        _ => ("404 Not Found", "text/plain", String::new()),
    };
    let length = content.len();
    write!(
        &stream,
        "HTTP/1.1 {status}\r\nContent-Type: {kind}\r\nContent-Length: {length}\r\nConnection: close\r\n\r\n{content}"
    )?;
    if path == "/messages" {
        // Where the check has ended already, nobody listens.
        let _ = messages.send(body);
    }
    Ok(())
}

/// A browser without a window, with a profile of its own; both end with this value.
struct Browser {
    process: Child,
    profile: std::path::PathBuf,
}

impl Browser {
    fn open(program: &str, address: &str) -> io::Result<Self> {
        let name = format!("glimt-browser-{}", std::process::id());
        let profile = std::env::temp_dir().join(name);
        let process = Command::new(program)
            .args([
                "--headless",
                // A browser that root runs refuses its sandbox; it sees nothing but this page.
                "--no-sandbox",
                "--disable-quic",
                "--no-first-run",
                "--disable-background-networking",
                "--disable-component-update",
                "--disable-sync",
                "--enable-unsafe-webgpu",
                "--use-webgpu-adapter=swiftshader",
            ])
            .arg(format!("--user-data-dir={}", profile.display()))
            .arg(address)
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .spawn()
            .map_err(|e| io::Error::new(e.kind(), format!("{program}: {e}")))?;
        Ok(Self { process, profile })
    }
}

impl Drop for Browser {
    fn drop(&mut self) {
        let _ = self.process.kill();
        let _ = self.process.wait();
        let _ = std::fs::remove_dir_all(&self.profile);
    }
}
