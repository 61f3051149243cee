//! Host file: a kernel's signature as a host's Rust writes it, so that a generator can write a typed struct of its arguments.

use crate::diag::{R, Span};
use crate::lower::Lowerer;
use crate::ty::Ty;

/// One argument of a kernel, as its Rust signature says.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Argument {
    /// Its name.
    pub name: String,
    /// Its type, without the reference that it may stand behind.
    pub ty: ArgumentType,
    /// Whether the kernel takes it by reference: `&T`, `&[T]` or `&mut [T]`; else by value.
    pub by_reference: bool,
    /// Whether it is `&mut [T]`: the element's own chunk of a buffer.
    pub is_chunk: bool,
}

/// The type of an argument, or of a field of a view. Paths are those that other crates write: `glam::Vec4`, `u32`,
/// `my_crate::module::Params`, whether or not each module on the way is public.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ArgumentType {
    /// A plain value, which lies in `params`. Path of its type.
    Value(String),
    /// A slice. Path of its elements' type.
    Slice(String),
    /// A struct that holds slices.
    View {
        /// Its path, without lifetimes.
        path: String,
        /// Names and types of its fields, in order, private ones among them.
        fields: Vec<(String, ArgumentType)>,
    },
}

/// What a kernel takes and returns.
#[derive(Default)]
pub(crate) struct Signature {
    pub(crate) arguments: Vec<Argument>,
    /// Type of the elements that it returns.
    pub(crate) out: Option<String>,
}

impl Lowerer<'_> {
    /// The argument that `syntax` declares; `ty` is its type with everything generic filled in.
    pub(crate) fn argument(
        &mut self,
        syntax: &syn::FnArg,
        name: &str,
        ty: &Ty,
        is_chunk: bool,
        span: Span,
    ) -> R<Argument> {
        let is_reference =
            matches!(syntax, syn::FnArg::Typed(p) if matches!(&*p.ty, syn::Type::Reference(_)));
        Ok(Argument {
            name: name.to_string(),
            ty: self.argument_type(ty, span)?,
            // A slice may hide its reference behind an alias.
            by_reference: is_reference || matches!(ty, Ty::Slice(_)),
            is_chunk,
        })
    }

    fn argument_type(&mut self, ty: &Ty, span: Span) -> R<ArgumentType> {
        Ok(match ty {
            Ty::Slice(element) => ArgumentType::Slice(self.rust_path(element)),
            ty if self.holds_slices(ty, span)? => {
                let (names, types) = (self.field_names(ty), self.field_types(ty, span)?);
                let mut fields = Vec::new();
                for (name, ty) in names.into_iter().zip(&types) {
                    fields.push((name, self.argument_type(ty, span)?));
                }
                ArgumentType::View {
                    path: self.rust_path(ty),
                    fields,
                }
            }
            ty => ArgumentType::Value(self.rust_path(ty)),
        })
    }

    /// A type as another crate writes it, without lifetimes.
    pub(crate) fn rust_path(&self, ty: &Ty) -> String {
        let list = |types: &[Ty]| {
            let paths: Vec<String> = types.iter().map(|t| self.rust_path(t)).collect();
            paths.join(", ")
        };
        let item = |module: usize, name: &syn::Ident| {
            let module = &self.items.modules[module].path;
            format!("{module}::{name}")
        };
        match ty {
            Ty::Vec(..) | Ty::Mat(_) => {
                format!("glam::{}", ty.show(self.items))
            }
            Ty::Array(element, len) => {
                format!("[{}; {}]", self.rust_path(element), len.show(self.items))
            }
            Ty::Slice(element) => format!("[{}]", self.rust_path(element)),
            Ty::Tuple(types) => format!("({})", list(types)),
            Ty::Option(inner) => format!("Option<{}>", self.rust_path(inner)),
            Ty::Struct(id, arguments) => {
                let of = &self.items.structs[*id];
                let path = item(of.module, &of.item.ident);
                if arguments.is_empty() {
                    path
                } else {
                    format!("{path}<{}>", list(arguments))
                }
            }
            Ty::Enum(id) => {
                let of = &self.items.enums[*id];
                item(of.module, &of.item.ident)
            }
            ty => ty.show(self.items),
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::{Argument, ArgumentType, CrateSource, EntryDesc, Program, Shader};

    const SHAPES: &str = "
        use glam::{UVec2, Vec4};
        pub mod light {
            #[repr(C)]
            pub struct Sun { pub colour: glam::Vec4 }
            pub struct Table<'a> { pub size: glam::UVec2, edges: &'a [u32] }
        }
        pub struct Pair<T>(pub T, pub T);
        pub struct Sky<'a, T> { pub suns: &'a [light::Sun], pub table: light::Table<'a>, pub kept: &'a [T] }
        pub type Words<'a> = &'a [u32];
        pub fn both<T>(
            id: u32, size: UVec2, sun: &light::Sun, weights: &[[f32; 4]], sky: &Sky<'_, T>, more: Sky<'_, Vec4>,
            words: Words<'_>, chunk: &mut [light::Sun],
        ) -> [Vec4; 2] {
            let k = id as usize;
            chunk[0].colour = sun.colour * weights[k][0] * sky.suns[k].colour + more.kept[k];
            let f = (sky.table.edges[k] + more.table.edges[k] + size.x + words[k]) as f32;
            [chunk[0].colour, Vec4::splat(f)]
        }
        pub fn fill(id: u32, cells: &mut [f32]) { cells[0] = id as f32; }";

    fn shader(kernel: &str) -> Shader {
        let files = [("lib.rs", SHAPES)];
        let program = Program::parse(&[CrateSource {
            name: "shapes",
            files: &files,
        }])
        .unwrap_or_else(|e| panic!("{e}"));
        program
            .entry(&EntryDesc {
                name: "entry",
                kernel,
                workgroup_size: 64,
            })
            .unwrap_or_else(|e| panic!("{e}"))
    }

    fn argument(name: &str, ty: ArgumentType, by_reference: bool, is_chunk: bool) -> Argument {
        Argument {
            name: name.into(),
            ty,
            by_reference,
            is_chunk,
        }
    }

    #[test]
    fn a_signature_is_told_as_its_host_writes_it() {
        let value = |path: &str| ArgumentType::Value(path.into());
        let slice = |path: &str| ArgumentType::Slice(path.into());
        let table = ArgumentType::View {
            path: "shapes::light::Table".into(),
            fields: vec![
                ("size".into(), value("glam::UVec2")),
                ("edges".into(), slice("u32")),
            ],
        };
        let sky = |kept: &str| ArgumentType::View {
            path: format!("shapes::Sky<{kept}>"),
            fields: vec![
                ("suns".into(), slice("shapes::light::Sun")),
                ("table".into(), table.clone()),
                ("kept".into(), slice(kept)),
            ],
        };
        let made = shader("shapes::both::<[u32; 2]>");
        assert_eq!(
            made.arguments,
            [
                argument("size", value("glam::UVec2"), false, false),
                argument("sun", value("shapes::light::Sun"), true, false),
                argument("weights", slice("[f32; 4]"), true, false),
                argument("sky", sky("[u32; 2]"), true, false),
                argument("more", sky("glam::Vec4"), false, false),
                argument("words", slice("u32"), true, false),
                argument("chunk", slice("shapes::light::Sun"), true, true),
            ]
        );
        assert_eq!(made.out.as_deref(), Some("[glam::Vec4; 2]"));
    }

    #[test]
    fn a_kernel_that_fills_chunks_alone_returns_no_elements() {
        let made = shader("shapes::fill");
        assert_eq!(made.out, None);
        let cells = ArgumentType::Slice("f32".into());
        assert_eq!(made.arguments, [argument("cells", cells, true, true)]);
    }
}
