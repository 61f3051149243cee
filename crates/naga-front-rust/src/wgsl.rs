//! The module as text: validated by naga, written by naga, with the source lines as comments.

use std::borrow::Cow;
use std::fmt::Write;

use naga::valid::{Capabilities, ModuleInfo, ValidationFlags, Validator};

use crate::diag::{Error, R, Span};
use crate::items::Items;
use crate::uniform::needs_alignment;

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
    let mut members = needs_alignment(module).into_iter();
    let params_head = format!("struct {} {{", uniform_type(&text).unwrap_or_default());
    let mut is_in_params = false;
    let mut out = String::with_capacity(text.len());
    for line in text.lines() {
        let line = &*with_largest_as_hexadecimal(line);
        let trimmed = line.trim_start();
        if is_in_params && trimmed != "}" {
            let align = match members.next() {
                Some(true) => "@align(16) ",
                _ => "",
            };
            let indent = &line[..line.len() - trimmed.len()];
            let _ = writeln!(out, "{indent}{align}{trimmed}");
            continue;
        }
        is_in_params = line == params_head;
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

/// The name that naga gave to the type of the uniform variable.
fn uniform_type(text: &str) -> Option<&str> {
    let mut lines = text.lines();
    let declared = lines.find_map(|line| line.strip_prefix("var<uniform> "))?;
    let (_, ty) = declared.split_once(": ")?;
    ty.strip_suffix(';')
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

/// The largest f32 as a literal that every reader of WGSL takes.
const LARGEST: &str = "0x1.fffffep+127f";

/// Replaces decimal literals of [`f32::MAX`]. naga writes the fewest digits that are read back as the same bits, and for this one
/// they make a decimal above it, `3.4028235e38`, which WGSL lets a reader refuse (Tint does). All others lie in range.
fn with_largest_as_hexadecimal(line: &str) -> Cow<'_, str> {
    let is_part = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '.';
    let is_too_large = |word: &str| {
        let digits = word.strip_suffix('f').unwrap_or_default();
        let is_decimal = digits.starts_with(|c: char| c.is_ascii_digit())
            && digits.chars().all(|c| c.is_ascii_digit() || c == '.');
        is_decimal
            && digits
                .parse::<f64>()
                .is_ok_and(|value| value > f64::from(f32::MAX))
    };
    let mut words = line.split(|c| !is_part(c));
    if !words.any(is_too_large) {
        return Cow::Borrowed(line);
    }
    let mut out = String::with_capacity(line.len());
    let mut rest = line;
    while !rest.is_empty() {
        let end = rest.find(|c| !is_part(c)).unwrap_or(rest.len());
        let (word, after) = rest.split_at(end);
        out.push_str(if is_too_large(word) { LARGEST } else { word });
        let next = after.find(is_part).unwrap_or(after.len());
        out.push_str(&after[..next]);
        rest = &after[next..];
    }
    Cow::Owned(out)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{CrateSource, EntryDesc, Program};

    /// The f32 literals of all functions of the module that naga reads from `text`, as bits; those of negated ones with their
    /// sign.
    fn literals(text: &str) -> Vec<u32> {
        let module = naga::front::wgsl::parse_str(text).expect("naga reads what it wrote");
        let functions = module.functions.iter().map(|(_, function)| function);
        let entries = module.entry_points.iter().map(|entry| &entry.function);
        let mut bits = Vec::new();
        for function in functions.chain(entries) {
            for (_, expression) in function.expressions.iter() {
                if let naga::Expression::Literal(naga::Literal::F32(value)) = expression {
                    bits.push(value.to_bits());
                }
            }
        }
        bits
    }

    #[test]
    fn every_float_is_read_back_with_the_same_bits() {
        let below = f32::from_bits(f32::MAX.to_bits() - 1);
        let values = [
            f32::MAX,
            f32::MIN,
            below,
            -below,
            f32::MIN_POSITIVE,
            0.1,
            16_777_216.0,
            1e10,
        ];
        let sum: Vec<String> = values
            .iter()
            .map(|v| format!("floats[{}] * {v:e}_f32", v.to_bits()))
            .collect();
        let source = format!(
            "pub fn k(id: u32, floats: &[f32]) -> f32 {{ {} + f32::MAX - f32::MIN }}",
            sum.join(" + ")
        );
        let files = [("lib.rs", source.as_str())];
        let program = Program::parse(&[CrateSource {
            name: "krate",
            files: &files,
        }])
        .unwrap_or_else(|e| panic!("{e}"));
        let shader = program
            .entry(&EntryDesc {
                name: "entry",
                kernel: "krate::k",
                workgroup_size: 64,
            })
            .unwrap_or_else(|e| panic!("{e}"));
        let found = literals(&shader.wgsl);
        for value in values {
            assert!(
                found.contains(&value.to_bits()),
                "{value:e} in {}",
                shader.wgsl
            );
        }
        assert_eq!(shader.wgsl.matches(LARGEST).count(), 4, "{}", shader.wgsl);
        assert!(!shader.wgsl.contains("34028235"), "{}", shader.wgsl);
    }

    #[test]
    fn only_literals_above_the_largest_float_are_replaced() {
        let max = f32::MAX;
        assert_eq!(
            with_largest_as_hexadecimal(&format!("    x = (-{max}f + a.x{max}f);")),
            format!("    x = (-{LARGEST} + a.x{max}f);")
        );
        let below = f32::from_bits(max.to_bits() - 1);
        for line in [
            format!("return {below}f;"),
            "v4_ = vec4<f32>(1f, 0.5f, 4294967295f, f);".into(),
        ] {
            assert_eq!(with_largest_as_hexadecimal(&line), line);
        }
    }
}
