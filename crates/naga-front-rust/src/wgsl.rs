//! The module as text: validated by naga, written by naga, with the source lines as comments.

use std::fmt::Write;

use naga::valid::{Capabilities, ModuleInfo, ValidationFlags, Validator};

use crate::diag::{Error, R, Span};
use crate::items::Items;

fn internal(what: &str, detail: String) -> Box<Error> {
    Box::new(Error {
        message: format!("{what}: {detail}"),
        span: None,
        help: Some("this is a fault of the front end: please report it with the kernel".into()),
        notes: Vec::new(),
    })
}

pub(crate) fn validate(module: &naga::Module) -> R<ModuleInfo> {
    Validator::new(ValidationFlags::all(), Capabilities::default())
        .validate(module)
        .map_err(|e| {
            let mut text = e.to_string();
            let mut source = std::error::Error::source(e.as_inner());
            while let Some(inner) = source {
                let _ = write!(text, ": {inner}");
                source = inner.source();
            }
            internal("naga refuses the module that was made", text)
        })
}

/// Writes a module that was lowered with markers.
pub(crate) fn write(module: &naga::Module, items: &Items) -> R<String> {
    let info = validate(module)?;
    let text =
        naga::back::wgsl::write_string(module, &info, naga::back::wgsl::WriterFlags::empty())
            .map_err(|e| internal("naga cannot write the module", e.to_string()))?;
    // naga may rename a function; it writes them in the order of the arena.
    let mut functions = module.functions.iter();
    let mut out = String::with_capacity(text.len());
    for line in text.lines() {
        let trimmed = line.trim_start();
        if trimmed.starts_with(&format!("var {}", crate::lower::marker())) {
            continue;
        }
        if let Some(code) = marker_code(trimmed) {
            let indent = &line[..line.len() - trimmed.len()];
            let (file, at) = (code >> 20, code & 0xf_ffff);
            let _ = writeln!(out, "{indent}// {}:{at}", place(items, file as usize));
            continue;
        }
        if line.starts_with("fn ")
            && let Some((handle, _)) = functions.next()
            && let Some((file, at)) = origin(module.functions.get_span(handle))
        {
            let _ = writeln!(out, "// {}:{at}", place(items, file));
        }
        out.push_str(line);
        out.push('\n');
    }
    Ok(out)
}

/// A function's place as naga's kind of span, which keeps it when functions are left out. It has no offsets into one text, as
/// naga's own have, but the file's number and the line.
pub(crate) fn span_of_origin(span: Span) -> naga::Span {
    naga::Span::new(span.file as u32, span.line as u32)
}

/// File and line.
fn origin(span: naga::Span) -> Option<(usize, usize)> {
    span.to_range().map(|range| (range.start, range.end))
}

fn place(items: &Items, file: usize) -> &str {
    items.files.get(file).map_or("?", |f| &f.display)
}

/// The line that a marker's store stands for.
fn marker_code(line: &str) -> Option<u32> {
    let rest = line.strip_prefix(crate::lower::marker())?;
    // naga numbers the variable where the name is taken: `name_1 = 42u;`
    let (_, value) = rest.split_once(" = ")?;
    value.strip_suffix("u;")?.parse().ok()
}
