//! Lowers a subset of Rust to [`naga`] IR and WGSL: one source for the CPU and the GPU.
//!
//! A *shared file* is plain Rust: `no_std`, glam types, slices, generics, traits. rustc compiles it
//! for the CPU. This crate parses the same text with `syn`, resolves its names, infers its types, makes one copy of
//! each generic function for each set of arguments, and lowers what is reached from a kernel to a [`naga::Module`], which
//! naga validates and writes as WGSL. What it cannot lower it refuses, with an error that names file, line and fix.
//! `SUBSET.md` beside this crate's `Cargo.toml` says what shared code may contain.
//!
//! ```
//! use naga_front_rust::{CrateSource, EntryDesc, Program};
//!
//! let text = "
//!     /// One cell of an explicit heat step.
//!     pub fn heat(id: u32, rate: f32, cells: &[f32]) -> f32 {
//!         let i = id as usize;
//!         if i == 0 || i + 1 == cells.len() {
//!             return cells[i];
//!         }
//!         cells[i] + rate * (cells[i - 1] - 2.0 * cells[i] + cells[i + 1])
//!     }";
//! let program = Program::parse(&[CrateSource { name: "heat", files: &[("lib.rs", text)] }])?;
//! let shader = program.entry(&EntryDesc { name: "heat", kernel: "heat::heat", workgroup_size: 64 })?;
//! assert!(shader.wgsl.contains("@compute @workgroup_size(64, 1, 1)"));
//! assert_eq!(shader.buffers[0].path, "cells");
//! # Ok::<(), naga_front_rust::Diagnostic>(())
//! ```
//!
//! # What an entry point expects of its host
//!
//! All bindings are in group 0. Binding 0 is `params`, a uniform buffer where WGSL allows it, else a read-only storage buffer
//! ([`Shader::params_in`]), whose members are [`Shader::params`]:
//! `first`, `count`, a `<name>_len` for each chunk argument, then the kernel's plain arguments. The slices follow,
//! then `out`; a slice that the kernel never touches is left out and has no binding. Invocation `local = id.y * (num_workgroups.x * workgroup_size) + id.x` computes element `first + local` and
//! writes `out[local]`; those at or beyond `count` do nothing. A chunk argument gets
//! `chunk[local * len .. (local + 1) * len]`.

#![deny(unsafe_code)]

mod argument;
mod builtins;
mod check;
mod diag;
mod entry;
mod export;
mod hir;
mod items;
mod konst;
mod layout;
mod load;
mod lower;
mod reach;
mod resolve;
mod ty;
mod uniform;
mod wgsl;

pub use argument::{Argument, ArgumentType};
pub use diag::{Diagnostic, Location};
pub use uniform::ParamsSpace;

use diag::{Error, R};
use items::Items;
use lower::Lowerer;

/// A crate's shared files: pairs of path below `src/` and text. With `lib.rs` among them, its `mod` items say which file is
/// which module; a single file is the crate's root; several files without `lib.rs` are a module each.
#[derive(Clone, Copy, Debug)]
pub struct CrateSource<'a> {
    /// The name by which other crates `use` it.
    pub name: &'a str,
    /// `(path below src/, text)`.
    pub files: &'a [(&'a str, &'a str)],
}

impl<'a> From<(&'a str, &'a [(&'a str, &'a str)])> for CrateSource<'a> {
    fn from((name, files): (&'a str, &'a [(&'a str, &'a str)])) -> Self {
        CrateSource { name, files }
    }
}

/// A kernel to make an entry point of.
#[derive(Clone, Copy, Debug)]
pub struct EntryDesc<'a> {
    /// Name of the entry point in the shader.
    pub name: &'a str,
    /// Path from the crate, with generic arguments where there are any: `my_crate::module::kernel::<my_crate::Target>`.
    pub kernel: &'a str,
    /// Invocations in a workgroup.
    pub workgroup_size: u32,
}

/// Functions for people who write their own shaders.
#[derive(Clone, Copy, Debug)]
pub struct ExportDesc<'a> {
    /// Name in the shader, and path from the crate.
    pub functions: &'a [(&'a str, &'a str)],
    /// Group and binding of each buffer that the functions' slices are bound to. A buffer's name is the path of the slice with `_`
    /// for `.`, and without `self`: `marginal` for `self.marginal`, `env_marginal` for the field of a parameter `env`.
    /// Functions that name the same buffer share it. A slice that no function reaches needs none.
    pub buffers: &'a [(&'a str, u32, u32)],
}

/// One plain argument in the `params` buffer.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Param {
    /// Path from the kernel's argument: `frame`, `env.size`.
    pub path: String,
    /// Bytes from the buffer's start.
    pub offset: u32,
    /// Bytes of the value.
    pub size: u32,
}

/// One slice of a kernel's arguments, or `out`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Buffer {
    /// Path from the kernel's argument: `env.marginal`; `out` for what it returns.
    pub path: String,
    /// Bind group.
    pub group: u32,
    /// Binding in the group.
    pub binding: u32,
    /// Bytes from one element to the next.
    pub stride: u32,
    /// Whether the kernel may write to it.
    pub writable: bool,
}

/// A `#[repr(C)]` struct that lies in a buffer: the same bytes in Rust and in WGSL, as far as the front end can tell. Hosts assert
/// it with `size_of` and `offset_of!`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct StructLayout {
    /// Path from the crate: `my_crate::module::Frame`.
    pub path: String,
    /// Bytes of the whole.
    pub size: u32,
    /// Name of each field, and its bytes from the start.
    pub fields: Vec<(String, u32)>,
}

/// A lowered kernel or set of exports.
#[derive(Clone, Debug)]
pub struct Shader {
    /// The shader as WGSL, with `// crate/src/file.rs:line` comments.
    pub wgsl: String,
    /// The same, for naga's other back ends (SPIR-V, MSL, HLSL).
    pub module: naga::Module,
    /// What naga's validator found out about [`Shader::module`].
    pub info: naga::valid::ModuleInfo,
    /// Name of the entry point; empty for exports.
    pub entry_point: String,
    /// Invocations in a workgroup; 0 for exports.
    pub workgroup_size: u32,
    /// The members of the `params` buffer.
    pub params: Vec<Param>,
    /// Bytes of the `params` buffer.
    pub params_size: u32,
    /// Whether `params` is a uniform or a storage buffer.
    pub params_in: ParamsSpace,
    /// The other buffers, in the order of their bindings: those that the kernel reaches. A slice that it never reads, as one of
    /// a view's, is not among them.
    pub buffers: Vec<Buffer>,
    /// What the kernel takes after the element's index, as its Rust signature says; empty for exports.
    pub arguments: Vec<Argument>,
    /// Path of the type of the elements that the kernel returns; none where it fills chunks alone.
    pub out: Option<String>,
    /// The structs that lie in buffers.
    pub structs: Vec<StructLayout>,
}

/// Parsed crates, ready to be lowered.
#[derive(Debug)]
pub struct Program {
    items: Items,
}

impl Program {
    /// Parses the crates. Their order does not matter; `glam`, `libm` and `core` are known and need no files.
    ///
    /// # Errors
    ///
    /// A file that does not parse, or a crate's name that is taken.
    pub fn parse(crates: &[CrateSource<'_>]) -> Result<Program, Diagnostic> {
        let mut program = Program {
            items: Items::default(),
        };
        for c in crates {
            program
                .items
                .add_crate(c.name, c.files)
                .map_err(|e| program.diagnose(*e))?;
        }
        Ok(program)
    }

    /// Lowers a kernel to a compute entry point.
    ///
    /// # Errors
    ///
    /// Anything reached from the kernel that is not in the subset, or that is ambiguous.
    pub fn entry(&self, desc: &EntryDesc<'_>) -> Result<Shader, Diagnostic> {
        if desc.workgroup_size == 0 {
            return Err(self.diagnose(Error {
                message: "the workgroup size is 0".into(),
                span: None,
                help: Some("64 suits most adapters".into()),
                notes: Vec::new(),
            }));
        }
        self.shader(&[desc.name], desc.workgroup_size, |l| l.entry(desc))
    }

    /// Lowers functions to be called from a shader of one's own.
    ///
    /// # Errors
    ///
    /// As [`Program::entry`]; also a slice whose buffer has no binding, and a name that WGSL would not keep.
    pub fn exports(&self, desc: &ExportDesc<'_>) -> Result<Shader, Diagnostic> {
        let names: Vec<&str> = desc.functions.iter().map(|(name, _)| *name).collect();
        self.shader(&names, 0, |l| l.exports(desc))
    }

    fn shader(
        &self,
        names: &[&str],
        workgroup_size: u32,
        make: impl Fn(&mut Lowerer<'_>) -> R<entry::Bound>,
    ) -> Result<Shader, Diagnostic> {
        let run = || -> R<Shader> {
            let lower = |markers: bool| -> R<(Lowerer<'_>, entry::Bound)> {
                let mut lowerer = Lowerer::new(&self.items, markers);
                let mut bound = make(&mut lowerer)?;
                reach::keep_reached(&mut lowerer.module, &mut bound)?;
                Ok((lowerer, bound))
            };
            let (marked, _) = lower(true)?;
            let wgsl = wgsl::write(&marked.module, &self.items)?;
            check_names(names, &wgsl)?;
            let (plain, bound) = lower(false)?;
            let info = wgsl::validate(&plain.module)?;
            Ok(Shader {
                wgsl,
                info,
                entry_point: match names {
                    [name] if workgroup_size > 0 => (*name).to_string(),
                    _ => String::new(),
                },
                workgroup_size,
                params: bound.params,
                params_size: bound.params_size,
                params_in: bound.params_in,
                buffers: bound.buffers,
                arguments: bound.signature.arguments,
                out: bound.signature.out,
                module: plain.module,
                structs: plain.buffer_structs.into_values().collect(),
            })
        };
        run().map_err(|e| self.diagnose(*e))
    }

    fn diagnose(&self, e: Error) -> Diagnostic {
        let location = e.span.and_then(|s| {
            let file = self.items.files.get(s.file)?;
            let source_line = file.text.lines().nth(s.line.saturating_sub(1))?.to_string();
            let width = s
                .width
                .min(source_line.chars().count().saturating_sub(s.column))
                .max(1);
            Some(Box::new(Location {
                file: file.display.clone(),
                line: s.line,
                column: s.column + 1,
                source_line,
                width,
            }))
        });
        Diagnostic {
            message: e.message,
            location,
            help: e.help,
            notes: e.notes,
        }
    }
}

/// Whoever asks for a function by its name must find it: WGSL has reserved words, and naga renames what ends in a digit.
fn check_names(names: &[&str], wgsl: &str) -> R<()> {
    match names
        .iter()
        .find(|name| !wgsl.contains(&format!("fn {name}(")))
    {
        None => Ok(()),
        Some(name) => Err(Box::new(Error {
            message: format!("the name `{name}` would be another in WGSL"),
            span: None,
            help: Some(
                "choose a plain name that is no word of WGSL and does not end in a digit or `_`"
                    .into(),
            ),
            notes: Vec::new(),
        })),
    }
}
