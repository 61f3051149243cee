//! Paths in expression position: locals, consts, functions, constructors, associated items.

use crate::builtins;
use crate::diag::{R, err};
use crate::hir::{Builtin, ConstKey, Expr, Kind, Lit};
use crate::items::Def;
use crate::resolve::Ns;
use crate::ty::Ty;

use super::Checker;
use super::method::What;
use super::types::names;

/// What a path in expression position stands for.
pub(super) enum PathValue {
    Expr(Expr),
    /// A function item with its generic arguments still open, or a constructor.
    Callable(Callable),
}

pub(super) enum Callable {
    Fn(crate::hir::Instance),
    /// Method `name` of a built-in type, or an associated function such as `Vec3::new`.
    Builtin(Ty, String),
    Libm(String),
    /// `vec3(…)`.
    Short(Ty),
    TupleStruct(usize, Vec<Ty>),
    Some,
    /// `Trait::method(receiver, …)`.
    OfTrait(usize, String),
}

impl Checker<'_> {
    /// A path in expression position.
    pub(super) fn path(&mut self, p: &syn::ExprPath) -> R<PathValue> {
        let span = self.span(p);
        let path = names(&p.path);
        let last = p.path.segments.last().expect("a path has a segment");
        if let Some(q) = &p.qself {
            // `<T as Trait>::name` or `<T>::name`.
            let ty = self.ty(&q.ty)?;
            let only = if q.position > 0 {
                match self
                    .items
                    .resolve(self.scope.module, &path[..q.position], Ns::Type, span)?
                {
                    Def::Trait(t) => Some(t),
                    _ => {
                        return Err(err(
                            span,
                            "not a trait of the program",
                            "name a trait that is in a shared file",
                        ));
                    }
                }
            } else {
                None
            };
            return self.assoc(&ty, &last.ident.to_string(), &last.arguments, only, span);
        }
        if let [name] = path.as_slice() {
            if let Some(id) = self.local(name) {
                let ty = self.locals[id].ty.clone();
                return Ok(PathValue::Expr(Expr {
                    kind: Kind::Local(id),
                    ty,
                    span,
                }));
            }
            if let Some((_, Ty::Const(n))) = self.scope.substs.iter().find(|(n, _)| n == name) {
                return Ok(PathValue::Expr(Expr {
                    kind: Kind::Int(*n),
                    ty: Ty::Usize,
                    span,
                }));
            }
            if name == "Self" {
                return match self.scope.self_ty.clone() {
                    Some(Ty::Struct(id, args)) => self.constructor(id, args, span),
                    _ => Err(err(
                        span,
                        "`Self` is not a tuple struct here",
                        "name the type",
                    )),
                };
            }
        }
        // A generic parameter hides whatever else has its name.
        if path.len() == 2
            && let Some((_, ty)) = self.scope.substs.iter().find(|(n, _)| *n == path[0])
        {
            let ty = ty.clone();
            return self.assoc(&ty, &last.ident.to_string(), &last.arguments, None, span);
        }
        let mut busy = std::collections::HashSet::new();
        let found = self
            .items
            .find(self.scope.module, &path, Ns::Value, span, &mut busy)?;
        match found {
            Some(Def::Fn(id)) => {
                let instance = self.instantiate(id, Vec::new(), None, &last.arguments, span)?;
                return Ok(PathValue::Callable(Callable::Fn(instance)));
            }
            Some(Def::Const(id)) => {
                let key = ConstKey {
                    id,
                    substs: Vec::new(),
                    self_ty: None,
                };
                return self.const_value(key, span).map(PathValue::Expr);
            }
            Some(Def::Variant(e, v)) => {
                let number = self.items.enum_numbers(e)?[v as usize];
                return Ok(PathValue::Expr(Expr {
                    kind: Kind::Lit(Lit::U32(number)),
                    ty: Ty::Enum(e),
                    span,
                }));
            }
            Some(Def::Struct(id)) => {
                let args = self.generic_args(
                    &self.items.structs[id].item.generics,
                    &last.arguments,
                    span,
                )?;
                let args = args.into_iter().map(|(_, t)| t).collect();
                return self.constructor(id, args, span);
            }
            Some(Def::Extern(full))
                if path.len() == 1 || !full.starts_with("glam::") || glam_function(&full) =>
            {
                return self.extern_value(&full, span);
            }
            _ => {}
        }
        if let [name] = path.as_slice() {
            return match name.as_str() {
                "Some" => Ok(PathValue::Callable(Callable::Some)),
                "None" => {
                    let payload = self.table.var();
                    let ty = Ty::Option(Box::new(payload));
                    Ok(PathValue::Expr(Expr {
                        kind: Kind::None,
                        ty,
                        span,
                    }))
                }
                _ => Err(err(
                    span,
                    match self.items.import_of(self.scope.module, name) {
                        Some(path) => {
                            format!("cannot find `{name}`: `use {path}` leads to no file given")
                        }
                        None => format!("cannot find `{name}` here"),
                    },
                    "hand its file to the front end, or import it by name",
                )),
            };
        }
        // `Type::name`: everything before the last name is a type, or a trait.
        let (head, name) = (&path[..path.len() - 1], last.ident.to_string());
        let mut busy = std::collections::HashSet::new();
        match self
            .items
            .find(self.scope.module, head, Ns::Type, span, &mut busy)?
        {
            Some(Def::Trait(t)) => return Ok(PathValue::Callable(Callable::OfTrait(t, name))),
            Some(Def::Mod(_)) => {
                return Err(err(
                    span,
                    format!("cannot find `{name}` in `{}`", head.join("::")),
                    "check the name, or hand its file to the front end",
                ));
            }
            _ => {}
        }
        let owner = syn::Path {
            leading_colon: p.path.leading_colon,
            segments: p
                .path
                .segments
                .iter()
                .take(path.len() - 1)
                .cloned()
                .collect(),
        };
        let ty = self.ty(&syn::Type::Path(syn::TypePath {
            attrs: Vec::new(),
            qself: None,
            path: owner,
        }))?;
        self.assoc(&ty, &name, &last.arguments, None, span)
    }

    fn constructor(&mut self, id: usize, args: Vec<Ty>, span: crate::diag::Span) -> R<PathValue> {
        match &self.items.structs[id].item.fields {
            syn::Fields::Unit => Ok(PathValue::Expr(Expr {
                kind: Kind::Struct(Vec::new(), None),
                ty: Ty::Struct(id, args),
                span,
            })),
            syn::Fields::Unnamed(_) => Ok(PathValue::Callable(Callable::TupleStruct(id, args))),
            syn::Fields::Named(_) => Err(err(
                span,
                "this struct has named fields",
                "write `Name { field: value }`",
            )),
        }
    }

    fn extern_value(&mut self, full: &str, span: crate::diag::Span) -> R<PathValue> {
        if let Some(name) = full.strip_prefix("libm::") {
            if builtins::libm(name).is_none() {
                let help = if name.ends_with('f') {
                    "see the subset for the functions it knows"
                } else {
                    "f64 is not in the subset: use the function that ends in `f`"
                };
                return Err(err(
                    span,
                    format!("libm's `{name}` is not in the subset"),
                    help,
                ));
            }
            return Ok(PathValue::Callable(Callable::Libm(name.to_string())));
        }
        if let Some(name) = full.strip_prefix("glam::")
            && let Some(ty) = name.rsplit("::").next().and_then(builtins::glam_short)
        {
            return Ok(PathValue::Callable(Callable::Short(ty)));
        }
        if let Some(lit) = builtins::core_const(full) {
            let ty = match lit {
                crate::hir::Lit::F32(_) => Ty::F32,
                crate::hir::Lit::I32(_) => Ty::I32,
                crate::hir::Lit::U32(_) => Ty::U32,
                crate::hir::Lit::Bool(_) => Ty::Bool,
            };
            return Ok(PathValue::Expr(Expr {
                kind: Kind::Lit(lit),
                ty,
                span,
            }));
        }
        Err(err(
            span,
            format!("`{full}` is not in the subset"),
            "see the subset for what it knows of core, libm and glam",
        ))
    }

    /// `ty::name`.
    fn assoc(
        &mut self,
        ty: &Ty,
        name: &str,
        args: &syn::PathArguments,
        only: Option<usize>,
        span: crate::diag::Span,
    ) -> R<PathValue> {
        let ty = self.zonk(ty);
        if let Ty::Enum(e) = ty
            && let Some(v) = self.items.enums[e]
                .item
                .variants
                .iter()
                .position(|v| v.ident == name)
        {
            let number = self.items.enum_numbers(e)?[v];
            return Ok(PathValue::Expr(Expr {
                kind: Kind::Lit(Lit::U32(number)),
                ty,
                span,
            }));
        }
        let known_const = builtins::assoc_const(&ty, name);
        if let Some(m) = self.member(&ty, name, What::Const, only, known_const.is_some(), span)? {
            let key = self.const_key(&m, &ty);
            return self.const_value(key, span).map(PathValue::Expr);
        }
        if let Some(value) = known_const {
            return Ok(PathValue::Expr(self.builtin_const(&ty, value, span)));
        }
        if ty == Ty::F32 && ["NAN", "INFINITY", "NEG_INFINITY"].contains(&name) {
            return Err(err(
                span,
                format!("`f32::{name}` does not exist on every GPU"),
                "use `f32::MAX`, or a flag",
            ));
        }
        let builtin = builtins::method(&ty, name).is_some() || assoc_fn(&ty, name);
        if let Some(m) = self.member(&ty, name, What::Fn, only, builtin, span)? {
            let instance = self.instantiate(m.id, m.substs, Some(ty), args, span)?;
            return Ok(PathValue::Callable(Callable::Fn(instance)));
        }
        if builtin {
            return Ok(PathValue::Callable(Callable::Builtin(ty, name.to_string())));
        }
        let help = builtins::refused_method(name)
            .unwrap_or("hand the impl's file to the front end, or use what the subset knows");
        Err(err(
            span,
            format!(
                "`{}` has no `{name}` that the front end knows",
                self.show(&ty)
            ),
            help,
        ))
    }

    fn const_value(&mut self, key: ConstKey, span: crate::diag::Span) -> R<Expr> {
        let item = &self.items.consts[key.id];
        if let Some(gate) = &item.gate {
            return Err(err(
                span,
                format!("`{}` is host code here: {gate}", item.name),
                "shared code carries no `cfg`: give the variants different names",
            ));
        }
        let scope = super::Scope {
            module: item.module,
            file: item.file,
            substs: key.substs.clone(),
            self_ty: key.self_ty.clone(),
            generic: false,
        };
        let ty = self.within(scope, |c| c.ty(&item.ty))?;
        Ok(Expr {
            kind: Kind::Const(key),
            ty,
            span,
        })
    }

    fn builtin_const(&mut self, ty: &Ty, value: builtins::Value, span: crate::diag::Span) -> Expr {
        let number = |v: f64, ty: &Ty| {
            let (lit, ty) = match ty.scalar() {
                Some(crate::ty::Scalar::I32) => (Lit::I32(v as i32), Ty::I32),
                Some(crate::ty::Scalar::U32) => (Lit::U32(v as u32), Ty::U32),
                _ => (Lit::F32(v as f32), Ty::F32),
            };
            Expr {
                kind: Kind::Lit(lit),
                ty,
                span,
            }
        };
        let kind = match value {
            builtins::Value::Lit(lit) => Kind::Lit(lit),
            builtins::Value::Splat(v) => match ty {
                Ty::Mat(n) => {
                    let column = Ty::Vec(crate::ty::Scalar::F32, *n);
                    let zero = Expr {
                        kind: Kind::Builtin(Builtin::Splat, vec![number(v, &column)]),
                        ty: column,
                        span,
                    };
                    Kind::Builtin(Builtin::Compose, vec![zero; *n as usize])
                }
                _ => Kind::Builtin(Builtin::Splat, vec![number(v, ty)]),
            },
            builtins::Value::Parts(parts) => Kind::Builtin(
                Builtin::Compose,
                parts.into_iter().map(|v| number(v, ty)).collect(),
            ),
            builtins::Value::Identity => {
                let Ty::Mat(n) = ty else {
                    unreachable!("only matrices have an identity")
                };
                let column = Ty::Vec(crate::ty::Scalar::F32, *n);
                let one = Expr {
                    kind: Kind::Builtin(Builtin::Splat, vec![number(1.0, &column)]),
                    ty: column,
                    span,
                };
                Kind::Builtin(Builtin::FromDiagonal, vec![one])
            }
        };
        Expr {
            kind,
            ty: ty.clone(),
            span,
        }
    }
}

/// Associated functions (without a receiver) of the built-in types.
pub(super) fn assoc_fn(ty: &Ty, name: &str) -> bool {
    match ty {
        Ty::Vec(..) => matches!(name, "new" | "splat" | "from_array"),
        Ty::Mat(_) => matches!(name, "from_cols" | "from_diagonal"),
        Ty::F32 => name == "from_bits",
        _ => false,
    }
}

fn glam_function(full: &str) -> bool {
    full.rsplit("::")
        .next()
        .is_some_and(|n| builtins::glam_short(n).is_some())
}

pub(super) fn enum_with_fields(span: crate::diag::Span) -> Box<crate::diag::Error> {
    err(
        span,
        "an enum with fields cannot be lowered",
        "use a fieldless enum beside a struct, or `Option`",
    )
}
