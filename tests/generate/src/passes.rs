//! Host file: generated Rust that gives each kernel a struct of its arguments, so that executors of all kinds take the same ones.

use std::fmt::Write;

use naga_front_rust::{Argument, ArgumentType, Shader};

use crate::describe::own_path;
use crate::entries::EntrySpec;

/// Structs of arguments for the views that kernels take, then a pass for each kernel.
pub(super) fn text(shaders: &[(EntrySpec, Shader)]) -> String {
    let mut out = String::from(
        "use glimt_executor::{Binder, Entry, Host, HostMemory, Memory, Pass};\n\nuse super::entries;\n",
    );
    let mut known = Vec::new();
    for argument in shaders.iter().flat_map(|(_, shader)| &shader.arguments) {
        view(&mut out, &argument.ty, &mut known);
    }
    for (spec, shader) in shaders {
        pass(&mut out, spec, shader);
    }
    out
}

/// The name of the struct that stands for a view in any memory.
fn view_name(path: &str) -> String {
    let last = path.split('<').next().unwrap_or(path);
    format!("{}Arg", last.rsplit("::").next().unwrap_or(last))
}

fn view(out: &mut String, ty: &ArgumentType, known: &mut Vec<String>) {
    let ArgumentType::View { path, fields } = ty else {
        return;
    };
    for (_, field) in fields {
        view(out, field, known);
    }
    if known.contains(path) {
        return;
    }
    known.push(path.clone());
    let (name, own) = (view_name(path), own_path(path));
    let _ = writeln!(
        out,
        "\n/// [`{own}`] in some memory.\n#[derive(Clone, Copy)]\npub struct {name}<'a, M: Memory> {{"
    );
    for (field, ty) in fields {
        let _ = writeln!(
            out,
            "    /// Its `{field}`.\n    pub {field}: {},",
            field_type(ty)
        );
    }
    let _ = writeln!(
        out,
        "}}\n\nimpl<'a, M: Memory> {name}<'a, M> {{\n    /// The same for a shorter time: [`Memory::shorten`].\n    #[must_use]\n    pub fn shorten<'b>(self) -> {name}<'b, M>\n    where\n        'a: 'b,\n    {{\n        {name} {{"
    );
    for (field, ty) in fields {
        let field_for = match ty {
            ArgumentType::Value(_) => format!("self.{field}"),
            ArgumentType::Slice(_) => format!("M::shorten(self.{field})"),
            ArgumentType::View { .. } => format!("self.{field}.shorten()"),
        };
        let _ = writeln!(out, "            {field}: {field_for},");
    }
    let _ = writeln!(
        out,
        "        }}\n    }}\n}}\n\nimpl<'a, M: HostMemory> {name}<'a, M> {{\n    /// What the kernel takes.\n    #[inline]\n    pub fn view(self) -> {own}<'a> {{\n        {own} {{"
    );
    for (field, ty) in fields {
        let _ = writeln!(
            out,
            "            {field}: {},",
            on_host(ty, &format!("self.{field}"))
        );
    }
    let _ = writeln!(
        out,
        "        }}\n    }}\n}}\n\nimpl<'a> From<{own}<'a>> for {name}<'a, Host> {{\n    fn from(view: {own}<'a>) -> Self {{\n        Self {{"
    );
    for (field, ty) in fields {
        let into = match ty {
            ArgumentType::View { .. } => ".into()",
            _ => "",
        };
        let _ = writeln!(out, "            {field}: view.{field}{into},");
    }
    let _ = writeln!(out, "        }}\n    }}\n}}");
}

/// The type of a field that is no chunk.
fn field_type(ty: &ArgumentType) -> String {
    match ty {
        ArgumentType::Value(path) => own_path(path),
        ArgumentType::Slice(path) => format!("M::Slice<'a, {}>", own_path(path)),
        ArgumentType::View { path, .. } => format!("{}<'a, M>", view_name(path)),
    }
}

/// What the kernel takes of a field.
fn on_host(ty: &ArgumentType, field: &str) -> String {
    match ty {
        ArgumentType::Value(_) => field.to_owned(),
        ArgumentType::Slice(_) => format!("M::values({field})"),
        ArgumentType::View { .. } => format!("{field}.view()"),
    }
}

/// `shade_mis` as `ShadeMis`.
fn camel(name: &str) -> String {
    let words = name.split('_');
    words
        .map(|word| {
            let (first, rest) = word.split_at(1);
            format!("{}{rest}", first.to_uppercase())
        })
        .collect()
}

/// What a pass writes: its chunks, then what the kernel returns. Names and types of their values.
fn written(shader: &Shader) -> Vec<(&str, String)> {
    let chunks = shader.arguments.iter().filter(|argument| argument.is_chunk);
    let mut list: Vec<(&str, String)> = chunks
        .map(|argument| match &argument.ty {
            ArgumentType::Slice(path) => (&*argument.name, own_path(path)),
            other => unreachable!("a chunk of {other:?}"),
        })
        .collect();
    list.extend(shader.out.as_deref().map(|path| ("out", own_path(path))));
    list
}

fn pass(out: &mut String, spec: &EntrySpec, shader: &Shader) {
    let (name, kernel) = (camel(&spec.name), own_path(&spec.kernel));
    let written = written(shader);
    let read: Vec<&Argument> = shader.arguments.iter().filter(|a| !a.is_chunk).collect();
    let _ = writeln!(
        out,
        "\n/// `{}` with its arguments.\npub struct {name}<'a, M: Memory> {{",
        kernel.trim_start_matches("crate::kernels::")
    );
    for argument in &read {
        let ty = match (&argument.ty, argument.by_reference) {
            (ArgumentType::Value(path), true) => format!("&'a {}", own_path(path)),
            (ty, _) => field_type(ty),
        };
        let _ = writeln!(
            out,
            "    /// The kernel's `{0}`.\n    pub {0}: {ty},",
            argument.name
        );
    }
    for (field, ty) in &written {
        let what = match *field {
            "out" => "What the kernel returns".to_owned(),
            field => format!("The kernel's own `{field}`"),
        };
        let _ = writeln!(
            out,
            "    /// {what}.\n    pub {field}: M::Chunks<'a, {ty}>,"
        );
    }
    let _ = writeln!(
        out,
        "}}\n\nimpl<'a, M: Memory> Pass for {name}<'a, M> {{\n    type Memory = M;\n\n    fn entry() -> &'static Entry {{\n        &entries::{}\n    }}\n",
        spec.name.to_uppercase()
    );
    bind(out, shader, &read);
    on_the_host(out, &kernel, shader, &read, &written);
    out.push_str("}\n");
}

/// `Pass::bind`: what the shader reaches, in the order of its entry.
fn bind(out: &mut String, shader: &Shader, read: &[&Argument]) {
    let _ = writeln!(out, "    fn bind(&self, binder: &mut impl Binder<M>) {{");
    for (index, param) in shader.params.iter().enumerate() {
        let path = &param.path;
        let argument = path.split('.').next().unwrap_or(path);
        let Some(argument) = read.iter().find(|a| a.name == argument) else {
            // `first`, `count`, and lengths of chunks: the launcher's own.
            continue;
        };
        let is_reference = argument.by_reference && matches!(argument.ty, ArgumentType::Value(_));
        let mark = if is_reference { "" } else { "&" };
        let _ = writeln!(out, "        binder.value({index}, {mark}self.{path});");
    }
    for (index, buffer) in shader.buffers.iter().enumerate() {
        let path = &buffer.path;
        let _ = match (buffer.writable, path == "out") {
            (false, _) => writeln!(out, "        binder.slice({index}, self.{path});"),
            (true, true) => writeln!(out, "        binder.out({index}, &self.{path});"),
            (true, false) => {
                let of = |p: &naga_front_rust::Param| p.path == format!("{path}_len");
                let field = shader.params.iter().position(of).unwrap_or(usize::MAX);
                writeln!(
                    out,
                    "        binder.chunks({index}, {field}, &self.{path});"
                )
            }
        };
    }
    let _ = writeln!(out, "    }}\n");
}

/// The functions of `Pass` for memory that the program reads.
fn on_the_host(
    out: &mut String,
    kernel: &str,
    shader: &Shader,
    read: &[&Argument],
    written: &[(&str, String)],
) {
    let bound = "    where\n        M: HostMemory,\n    {";
    let counts: Vec<String> = written
        .iter()
        .map(|(field, _)| format!("M::count(&self.{field})"))
        .collect();
    let least = counts[1..].iter().fold(counts[0].clone(), |least, count| {
        format!("{least}.min({count})")
    });
    let _ = writeln!(
        out,
        "    fn elements(&self) -> usize\n{bound}\n        {least}\n    }}\n"
    );

    let _ = writeln!(
        out,
        "    fn split_at(self, at: usize) -> (Self, Self)\n{bound}"
    );
    for (field, _) in written {
        let _ = writeln!(
            out,
            "        let ({field}, rest_of_{field}) = M::split_at(self.{field}, at);"
        );
    }
    let fields: Vec<&str> = read.iter().map(|argument| &*argument.name).collect();
    let halves = ["", "rest_of_"].map(|prefix| {
        let shared = fields.iter().map(|field| format!("{field}: self.{field}"));
        let own = written.iter().map(|(field, _)| match prefix {
            "" => (*field).to_owned(),
            prefix => format!("{field}: {prefix}{field}"),
        });
        let all: Vec<String> = shared.chain(own).collect();
        format!("Self {{ {} }}", all.join(", "))
    });
    let _ = writeln!(
        out,
        "        (\n            {},\n            {},\n        )\n    }}\n",
        halves[0], halves[1]
    );

    let _ = writeln!(out, "    fn compute(self, first: u32)\n{bound}");
    let mut pattern = "id".to_owned();
    let mut list = "(first..)".to_owned();
    for (field, _) in written {
        pattern = format!("({pattern}, {field})");
        list = format!("{list}.zip(M::each(self.{field}))");
    }
    for argument in read
        .iter()
        .filter(|a| !matches!(a.ty, ArgumentType::Value(_)))
    {
        let value = on_host(&argument.ty, &format!("self.{}", argument.name));
        let _ = writeln!(out, "        let {} = {value};", argument.name);
    }
    let arguments = shader.arguments.iter().map(|argument| match &argument.ty {
        _ if argument.is_chunk => argument.name.clone(),
        ArgumentType::Value(_) => format!("self.{}", argument.name),
        ArgumentType::Slice(_) => argument.name.clone(),
        ArgumentType::View { .. } if argument.by_reference => format!("&{}", argument.name),
        ArgumentType::View { .. } => argument.name.clone(),
    });
    let arguments: Vec<String> = std::iter::once("id".to_owned()).chain(arguments).collect();
    let call = format!("{kernel}({})", arguments.join(", "));
    let statement = match shader.out {
        Some(_) => format!("out[0] = {call};"),
        None => format!("{call};"),
    };
    let _ = writeln!(
        out,
        "        for {pattern} in {list} {{\n            {statement}\n        }}\n    }}"
    );
}
