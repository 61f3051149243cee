//! Host file: generated Rust that describes the shaders.

use std::fmt::Write;

use naga_front_rust::{Shader, StructLayout};

use crate::entries::EntrySpec;
use crate::sources::SharedCrate;

/// A type's path as the renderer's crate writes it.
pub(super) fn own_path(path: &str) -> String {
    path.replace("glimt_render_gpu::", "crate::")
        // Its module is private, and the crate's root names it.
        .replace("glimt_envmap_cdf::env_cdf::", "glimt_envmap_cdf::")
}

/// One constant for each entry.
pub(super) fn entries(shaders: &[(EntrySpec, Shader)]) -> String {
    let mut out = String::from(
        "use std::borrow::Cow::Borrowed;\n\nuse glimt_executor::{BufferSlot, Entry, ParamField, ParamsSpace};\n",
    );
    for (spec, shader) in shaders {
        entry(&mut out, spec, shader);
    }
    out
}

fn entry(out: &mut String, spec: &EntrySpec, shader: &Shader) {
    let name = &spec.name;
    let _ = write!(
        out,
        "\n/// `{}` as a compute entry point.\npub static {}: Entry = Entry {{\n    name: Borrowed(\"{name}\"),\n    kernel: Borrowed(\"{}\"),\n    wgsl: Borrowed(include_str!(\"{name}.wgsl\")),\n    workgroup_size: {},\n    params_size: {},\n    params_space: ParamsSpace::{:?},\n    params: Borrowed(&[\n",
        own_path(&spec.kernel).trim_start_matches("crate::kernels::"),
        name.to_uppercase(),
        spec.kernel,
        shader.workgroup_size,
        shader.params_size,
        shader.params_in,
    );
    for p in &shader.params {
        let _ = writeln!(
            out,
            "        ParamField::new(\"{}\", {}, {}),",
            p.path, p.offset, p.size
        );
    }
    let _ = write!(out, "    ]),\n    buffers: Borrowed(&[\n");
    for b in &shader.buffers {
        let _ = writeln!(
            out,
            "        BufferSlot::new(\"{}\", {}, {}, {}),",
            b.path, b.binding, b.stride, b.writable
        );
    }
    let _ = write!(out, "    ]),\n}};\n");
}

/// Assertions that each struct in a buffer has the bytes that its shader expects.
///
/// They are checked where tests are built, since a struct that has just changed must not keep this file from being written.
pub(super) fn layout(shaders: &[(EntrySpec, Shader)]) -> String {
    let mut structs: Vec<&StructLayout> = Vec::new();
    for layout in shaders.iter().flat_map(|(_, shader)| &shader.structs) {
        if !structs.contains(&layout) {
            structs.push(layout);
        }
    }
    structs.sort_by(|a, b| a.path.cmp(&b.path));
    let mut out = String::from("use core::mem::{offset_of, size_of};\n\nconst _: () = {\n");
    for s in structs {
        let path = own_path(&s.path);
        let _ = writeln!(out, "    assert!(size_of::<{path}>() == {});", s.size);
        for (field, offset) in &s.fields {
            let _ = writeln!(out, "    assert!(offset_of!({path}, {field}) == {offset});");
        }
    }
    out.push_str("};\n");
    out
}

/// The list of shared files, for a front end.
pub(super) fn sources(crates: &[SharedCrate]) -> String {
    let own = crates.iter().find(|own| own.name == "glimt_render_gpu");
    let files = own.map_or(&[][..], |own| &own.files);
    let mut out = String::from(
        "/// Path below `src/` and text of each.\npub(crate) const FILES: &[(&str, &str)] = &[\n",
    );
    for (path, _) in files {
        let _ = writeln!(out, "    (\"{path}\", include_str!(\"../{path}\")),");
    }
    out.push_str("];\n");
    out
}
