//! The program's items, as the files hold them.

use std::collections::HashMap;

use crate::diag::{R, Span, err};

pub(crate) type ModId = usize;
pub(crate) type FnId = usize;

/// What a name stands for.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Def {
    Mod(ModId),
    Struct(usize),
    Enum(usize),
    Variant(usize, u32),
    Fn(FnId),
    Const(usize),
    Trait(usize),
    Alias(usize),
    /// A path into `glam`, `libm` or `core`, known by name only.
    Extern(String),
}

/// A name in a module: an item, or a `use` that is resolved when it is looked up.
#[derive(Clone, Debug)]
pub(crate) struct Named {
    pub(crate) target: Target,
    /// Whether it is `pub` in any way.
    pub(crate) public: bool,
    /// Why the item cannot be reached by shared code, as `#[cfg(feature = "x")]`.
    pub(crate) gate: Option<String>,
}

#[derive(Clone, Debug)]
pub(crate) enum Target {
    Def(Def),
    Use(Vec<String>),
    /// `mod x;` whose file was not handed to the front end.
    Absent,
    /// `static`, `union`, macro: host code.
    Unsupported(&'static str),
}

/// `use path::*;`
#[derive(Clone, Debug)]
pub(crate) struct Glob {
    pub(crate) path: Vec<String>,
    pub(crate) gate: Option<String>,
}

#[derive(Debug, Default)]
pub(crate) struct Module {
    pub(crate) krate: usize,
    pub(crate) parent: Option<ModId>,
    /// From the crate: `my_crate::module`.
    pub(crate) path: String,
    pub(crate) names: HashMap<String, Vec<Named>>,
    pub(crate) globs: Vec<Glob>,
    /// Has a macro call among its items: what it defines, only rustc knows.
    pub(crate) opaque: bool,
    /// Stands for the items at the top of a function body: what it lacks, its parent has.
    pub(crate) block: bool,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Owner {
    Free,
    Impl(usize),
    Trait(usize),
}

#[derive(Debug)]
pub(crate) struct FnItem {
    /// Where the body stands: a module of its own where it has items.
    pub(crate) module: ModId,
    /// Where the signature stands.
    pub(crate) outer: ModId,
    /// Whether it is `pub` in any way.
    pub(crate) public: bool,
    pub(crate) file: usize,
    pub(crate) owner: Owner,
    pub(crate) sig: syn::Signature,
    pub(crate) body: Option<syn::Block>,
    pub(crate) attrs: Vec<syn::Attribute>,
}

#[derive(Debug)]
pub(crate) struct StructItem {
    pub(crate) module: ModId,
    pub(crate) file: usize,
    pub(crate) item: syn::ItemStruct,
}

#[derive(Debug)]
pub(crate) struct EnumItem {
    pub(crate) module: ModId,
    pub(crate) file: usize,
    pub(crate) item: syn::ItemEnum,
}

#[derive(Debug)]
pub(crate) struct ConstItem {
    /// Why it cannot be reached by shared code.
    pub(crate) gate: Option<String>,
    pub(crate) public: bool,
    pub(crate) module: ModId,
    pub(crate) file: usize,
    pub(crate) owner: Owner,
    pub(crate) name: String,
    pub(crate) ty: syn::Type,
    pub(crate) value: Option<syn::Expr>,
}

#[derive(Debug)]
pub(crate) struct TraitItem {
    pub(crate) name: String,
    pub(crate) generics: syn::Generics,
    pub(crate) fns: HashMap<String, FnId>,
    pub(crate) consts: HashMap<String, usize>,
}

#[derive(Debug)]
pub(crate) struct ImplItem {
    /// Has a macro call among its items: what it defines, only rustc knows.
    pub(crate) opaque: bool,
    /// The `cfg` that it stands behind: whether it is there, rustc alone knows.
    pub(crate) gate: Option<String>,
    pub(crate) module: ModId,
    pub(crate) file: usize,
    pub(crate) generics: syn::Generics,
    pub(crate) trait_: Option<syn::Path>,
    pub(crate) self_ty: syn::Type,
    pub(crate) fns: HashMap<String, FnId>,
    pub(crate) consts: HashMap<String, usize>,
}

#[derive(Debug)]
pub(crate) struct AliasItem {
    pub(crate) module: ModId,
    pub(crate) file: usize,
    pub(crate) item: syn::ItemType,
}

#[derive(Debug)]
pub(crate) struct File {
    pub(crate) display: String,
    pub(crate) text: String,
}

/// Everything that was parsed.
#[derive(Debug, Default)]
pub(crate) struct Items {
    pub(crate) files: Vec<File>,
    pub(crate) crates: HashMap<String, ModId>,
    pub(crate) modules: Vec<Module>,
    pub(crate) fns: Vec<FnItem>,
    pub(crate) structs: Vec<StructItem>,
    pub(crate) enums: Vec<EnumItem>,
    pub(crate) consts: Vec<ConstItem>,
    pub(crate) traits: Vec<TraitItem>,
    pub(crate) impls: Vec<ImplItem>,
    pub(crate) aliases: Vec<AliasItem>,
    /// Whether the item that is being taken in is `pub`.
    pub(crate) public: bool,
}

impl Items {
    /// The numbers of an enum's variants. Refuses what a shared enum cannot have: variants with fields, and numbers that its
    /// attributes do not make `u32`.
    pub(crate) fn enum_numbers(&self, id: usize) -> R<Vec<u32>> {
        let item = &self.enums[id];
        check_attrs(item.file, &item.item.attrs)?;
        let mut numbers = Vec::new();
        let mut next = 0u32;
        for v in &item.item.variants {
            let at = Span::of(item.file, v);
            check_attrs(item.file, &v.attrs)?;
            if !matches!(v.fields, syn::Fields::Unit) {
                return Err(err(
                    at,
                    "an enum with fields cannot be lowered",
                    "use a fieldless enum beside a struct, or `Option`",
                ));
            }
            if let Some((_, e)) = &v.discriminant {
                let value = match e {
                    syn::Expr::Lit(syn::ExprLit {
                        lit: syn::Lit::Int(n),
                        ..
                    }) => n.base10_parse::<u32>().ok(),
                    _ => None,
                };
                let Some(value) = value else {
                    return Err(err(
                        at,
                        "the front end does not know this variant's number",
                        "write it as a literal of 32 bits, without a sign",
                    ));
                };
                if value != next && !self.is_u32_enum(id) {
                    return Err(err(
                        at,
                        "the variants of a shared enum are numbered 0, 1, 2 … unless it is #[repr(u32)]",
                        "add #[repr(u32)], or leave the numbers away",
                    ));
                }
                next = value;
            }
            numbers.push(next);
            next = next.wrapping_add(1);
        }
        Ok(numbers)
    }

    /// Whether an enum is `#[repr(u32)]` and nothing else: its values are the same four bytes in Rust and in WGSL.
    pub(crate) fn is_u32_enum(&self, id: usize) -> bool {
        reprs(&self.enums[id].item.attrs) == ["u32"]
    }
}

/// What the `repr` attributes say, in order.
pub(crate) fn reprs(attrs: &[syn::Attribute]) -> Vec<String> {
    let mut list = Vec::new();
    for attr in attrs {
        if let syn::Meta::List(l) = &attr.meta
            && l.path.is_ident("repr")
        {
            let text = l.tokens.to_string();
            list.extend(text.split(',').map(|t| t.trim().to_string()));
        }
    }
    list
}

/// Refuses attributes that could change what a reached item means.
pub(crate) fn check_attrs(file: usize, attrs: &[syn::Attribute]) -> R<()> {
    const ALLOWED: [&str; 10] = [
        "inline",
        "must_use",
        "derive",
        "repr",
        "allow",
        "expect",
        "doc",
        "test",
        "deprecated",
        "warn",
    ];
    for attr in attrs {
        let path = attr.path();
        let first = path
            .segments
            .first()
            .map(|s| s.ident.to_string())
            .unwrap_or_default();
        if !ALLOWED.contains(&first.as_str()) && first != "clippy" && first != "rustfmt" {
            return Err(err(
                Span::of(file, attr),
                format!("the attribute `{first}` is not allowed on shared code"),
                "allowed are inline, must_use, derive, repr, allow, expect and docs; move host code to a host file",
            ));
        }
    }
    Ok(())
}
