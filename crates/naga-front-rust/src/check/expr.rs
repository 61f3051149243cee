//! Expressions.

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
    pub(crate) fn expr(&mut self, e: &syn::Expr, expect: Option<&Ty>) -> R<Expr> {
        let span = self.span(e);
        crate::items::check_attrs(self.scope.file, attributes(e))?;
        let refuse =
            |what: &str, help: &str| Err(err(span, format!("{what} cannot be lowered"), help));
        match e {
            syn::Expr::Lit(l) => self.literal(l),
            syn::Expr::Paren(p) => self.expr(&p.expr, expect),
            syn::Expr::Group(p) => self.expr(&p.expr, expect),
            syn::Expr::Path(p) => match self.path(p)? {
                PathValue::Expr(e) => Ok(e),
                PathValue::Callable(_) => refuse(
                    "a function as a value",
                    "call it, or make the function generic over a trait",
                ),
            },
            syn::Expr::Unary(u) => self.unary(u, expect),
            syn::Expr::Binary(b) => self.binary(b),
            syn::Expr::Cast(c) => self.cast(c),
            syn::Expr::Assign(a) => self.assign(a),
            syn::Expr::Block(b) if b.label.is_none() => self.block(&b.block, expect),
            syn::Expr::If(i) => self.if_expr(i, expect),
            syn::Expr::Match(m) => self.match_expr(m, expect),
            syn::Expr::Loop(l) if l.label.is_none() => self.loop_expr(l, expect),
            syn::Expr::While(w) if w.label.is_none() => self.while_expr(w),
            syn::Expr::ForLoop(f) if f.label.is_none() => self.for_expr(f),
            syn::Expr::Block(_)
            | syn::Expr::Loop(_)
            | syn::Expr::While(_)
            | syn::Expr::ForLoop(_) => refuse(
                "a label",
                "put the inner loop into a function that returns, or use a flag",
            ),
            syn::Expr::Break(b) => self.break_expr(b),
            syn::Expr::Continue(c) if c.label.is_none() => Ok(Expr {
                kind: Kind::Continue,
                ty: Ty::Never,
                span,
            }),
            syn::Expr::Continue(_) => refuse(
                "a label",
                "put the inner loop into a function that returns, or use a flag",
            ),
            syn::Expr::Return(r) => {
                let ret = self.ret.clone();
                let value = match &r.expr {
                    Some(e) => {
                        let e = self.expr(e, Some(&ret))?;
                        Some(Box::new(self.coerce(e, &ret)?))
                    }
                    None => {
                        self.unify(&Ty::Unit, &ret, span)?;
                        None
                    }
                };
                Ok(Expr {
                    kind: Kind::Return(value),
                    ty: Ty::Never,
                    span,
                })
            }
            syn::Expr::Let(l) => {
                let scrutinee = self.expr(&l.expr, None)?;
                let scrutinee = self.scrutinee(scrutinee)?;
                let pat = self.pattern(&l.pat, &scrutinee.ty.clone())?;
                Ok(Expr {
                    kind: Kind::Let(Box::new(pat), Box::new(scrutinee)),
                    ty: Ty::Bool,
                    span,
                })
            }
            syn::Expr::Call(c) => self.call(c, expect),
            syn::Expr::MethodCall(m) => self.method_call(m, expect),
            syn::Expr::Field(f) => self.field(f),
            syn::Expr::Index(i) => self.index(i),
            syn::Expr::Reference(r) => self.reference(r, expect),
            syn::Expr::Struct(s) => self.struct_expr(s),
            syn::Expr::Tuple(t) if t.elems.is_empty() => Ok(Expr {
                kind: Kind::Unit,
                ty: Ty::Unit,
                span,
            }),
            syn::Expr::Tuple(t) => {
                let wants = match expect.map(|t| self.zonk(t)) {
                    Some(Ty::Tuple(v)) if v.len() == t.elems.len() => {
                        v.into_iter().map(Some).collect()
                    }
                    _ => vec![None; t.elems.len()],
                };
                let mut list = Vec::new();
                for (e, want) in t.elems.iter().zip(wants) {
                    let e = self.expr(e, want.as_ref())?;
                    list.push(self.no_ref(e)?);
                }
                let ty = Ty::Tuple(list.iter().map(|e| e.ty.clone()).collect());
                Ok(Expr {
                    kind: Kind::Tuple(list),
                    ty,
                    span,
                })
            }
            syn::Expr::Array(a) => {
                let elem = match expect.map(|t| self.zonk(t)) {
                    Some(Ty::Array(t, _)) => *t,
                    _ => self.table.var(),
                };
                let mut list = Vec::new();
                for e in &a.elems {
                    let e = self.expr(e, Some(&elem))?;
                    list.push(self.coerce(e, &elem)?);
                }
                let ty = Ty::Array(Box::new(elem), Box::new(Ty::Const(list.len() as u32)));
                Ok(Expr {
                    kind: Kind::Array(list),
                    ty,
                    span,
                })
            }
            syn::Expr::Repeat(r) => {
                let elem = match expect.map(|t| self.zonk(t)) {
                    Some(Ty::Array(t, _)) => *t,
                    _ => self.table.var(),
                };
                let len = self.array_len(&r.len)?;
                let Ty::Const(n) = self.zonk(&len) else {
                    return refuse("an inferred array length", "write the length");
                };
                let e = self.expr(&r.expr, Some(&elem))?;
                let e = self.coerce(e, &elem)?;
                let ty = Ty::Array(Box::new(elem), Box::new(len));
                Ok(Expr {
                    kind: Kind::Repeat(Box::new(e), n),
                    ty,
                    span,
                })
            }
            syn::Expr::Try(t) => {
                let e = self.expr(&t.expr, None)?;
                let e = self.value(e);
                let payload = self.table.var();
                let want = Ty::Option(Box::new(payload.clone()));
                let e = self.coerce(e, &want)?;
                let ret = self.ret.clone();
                let other = self.table.var();
                self.unify(&Ty::Option(Box::new(other)), &ret, span)?;
                // `e?` is `match e { Some(v) => v, None => return None }`.
                let v = self.declare("value", payload.clone(), false);
                let none = Expr {
                    kind: Kind::None,
                    ty: ret,
                    span,
                };
                let arms = vec![
                    crate::hir::Arm {
                        pat: crate::hir::Pat::Some(Box::new(crate::hir::Pat::Bind(v))),
                        guard: None,
                        body: Expr {
                            kind: Kind::Local(v),
                            ty: payload.clone(),
                            span,
                        },
                    },
                    crate::hir::Arm {
                        pat: crate::hir::Pat::Wild,
                        guard: None,
                        body: Expr {
                            kind: Kind::Return(Some(Box::new(none))),
                            ty: Ty::Never,
                            span,
                        },
                    },
                ];
                Ok(Expr {
                    kind: Kind::Match(Box::new(e), arms),
                    ty: payload,
                    span,
                })
            }
            syn::Expr::Macro(m) => self.macro_call(&m.mac),
            syn::Expr::Range(_) => refuse(
                "a range as a value",
                "use ranges in `for`, in patterns and to sub-slice",
            ),
            syn::Expr::Closure(_) => {
                refuse("a closure", "write a function, or a trait with a method")
            }
            syn::Expr::Unsafe(_) => refuse("`unsafe`", "shared code is safe Rust"),
            syn::Expr::Async(_) | syn::Expr::Await(_) => {
                refuse("`async`", "shared code is synchronous")
            }
            syn::Expr::RawAddr(_) => refuse("a raw pointer", "take a slice"),
            syn::Expr::Const(_) => refuse("a `const` block", "name the constant"),
            _ => refuse(
                "this expression",
                "use the expressions of the shared subset",
            ),
        }
    }

    pub(super) fn macro_call(&mut self, mac: &syn::Macro) -> R<Expr> {
        let span = self.span(mac);
        let name = mac
            .path
            .segments
            .last()
            .map(|s| s.ident.to_string())
            .unwrap_or_default();
        let of_core = !self
            .items
            .modules
            .iter()
            .any(|m| m.names.contains_key(&name));
        if of_core
            && ["debug_assert", "debug_assert_eq", "debug_assert_ne"].contains(&name.as_str())
        {
            return Ok(Expr {
                kind: Kind::Unit,
                ty: Ty::Unit,
                span,
            });
        }
        let help = match name.as_str() {
            "assert" | "assert_eq" | "assert_ne" | "panic" | "unreachable" | "todo"
            | "unimplemented" => {
                "kernels never panic: use `debug_assert!`, or return a value that says so"
            }
            "matches" => "write `match`, or compare with `==`",
            _ => "write the code out",
        };
        Err(err(
            span,
            format!("the macro `{name}!` cannot be lowered"),
            help,
        ))
    }

    fn literal(&mut self, l: &syn::ExprLit) -> R<Expr> {
        let span = self.span(l);
        let lit = |v, ty| {
            Ok(Expr {
                kind: Kind::Lit(v),
                ty,
                span,
            })
        };
        match &l.lit {
            syn::Lit::Bool(b) => lit(Lit::Bool(b.value), Ty::Bool),
            // In patterns a literal holds its own sign.
            syn::Lit::Int(i) if i.base10_digits().starts_with('-') => {
                let digits = format!(
                    "{}{}",
                    i.base10_digits().trim_start_matches('-'),
                    i.suffix()
                );
                let positive = syn::ExprLit {
                    attrs: Vec::new(),
                    lit: syn::Lit::Int(syn::LitInt::new(&digits, i.span())),
                };
                let inner = self.literal(&positive)?;
                let ty = inner.ty.clone();
                Ok(Expr {
                    kind: Kind::Unary(crate::hir::UnOp::Neg, Box::new(inner)),
                    ty,
                    span,
                })
            }
            syn::Lit::Float(f) if matches!(f.suffix(), "" | "f32") => {
                let v: f32 = f
                    .base10_parse()
                    .map_err(|e| err(span, e.to_string(), "write an f32"))?;
                if !v.is_finite() {
                    return Err(err(
                        span,
                        "this literal is outside f32",
                        "infinities do not exist in shared code",
                    ));
                }
                let ty = if f.suffix().is_empty() {
                    self.table.float_var()
                } else {
                    Ty::F32
                };
                self.floats.push((ty.clone(), span));
                lit(Lit::F32(v), ty)
            }
            syn::Lit::Int(i) => {
                if i.suffix() == "f32" {
                    let v: f32 = i
                        .base10_digits()
                        .parse()
                        .map_err(|_| err(span, "not an f32", "write an f32"))?;
                    return lit(Lit::F32(v), Ty::F32);
                }
                let too_big = || {
                    err(
                        span,
                        "this literal does not fit 32 bits",
                        "shared code has 32-bit numbers",
                    )
                };
                let v: u64 = i.base10_parse().map_err(|_| too_big())?;
                let v = u32::try_from(v).map_err(|_| too_big())?;
                let ty = match i.suffix() {
                    "" => self.table.int_var(),
                    "u32" => Ty::U32,
                    "i32" => Ty::I32,
                    "usize" => Ty::Usize,
                    other => {
                        return Err(err(
                            span,
                            format!("`{other}` is not in the subset"),
                            "use u32, i32 or usize",
                        ));
                    }
                };
                Ok(Expr {
                    kind: Kind::Int(v),
                    ty,
                    span,
                })
            }
            syn::Lit::Float(_) => Err(err(span, "f64 is not in the subset", "WGSL has f32 alone")),
            _ => Err(err(
                span,
                "this literal cannot be lowered",
                "use numbers and bools",
            )),
        }
    }

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
                self.items.check_enum(e)?;
                if !matches!(
                    self.items.enums[e].item.variants[v as usize].fields,
                    syn::Fields::Unit
                ) {
                    return Err(enum_with_fields(span));
                }
                return Ok(PathValue::Expr(Expr {
                    kind: Kind::Lit(Lit::U32(v)),
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
            self.items.check_enum(e)?;
            return Ok(PathValue::Expr(Expr {
                kind: Kind::Lit(Lit::U32(v as u32)),
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

/// The attributes of an expression: a `cfg` on one could change what the code means.
fn attributes(e: &syn::Expr) -> &[syn::Attribute] {
    match e {
        syn::Expr::Array(e) => &e.attrs,
        syn::Expr::Assign(e) => &e.attrs,
        syn::Expr::Async(e) => &e.attrs,
        syn::Expr::Await(e) => &e.attrs,
        syn::Expr::Binary(e) => &e.attrs,
        syn::Expr::Block(e) => &e.attrs,
        syn::Expr::Break(e) => &e.attrs,
        syn::Expr::Call(e) => &e.attrs,
        syn::Expr::Cast(e) => &e.attrs,
        syn::Expr::Closure(e) => &e.attrs,
        syn::Expr::Const(e) => &e.attrs,
        syn::Expr::Continue(e) => &e.attrs,
        syn::Expr::Field(e) => &e.attrs,
        syn::Expr::ForLoop(e) => &e.attrs,
        syn::Expr::Group(e) => &e.attrs,
        syn::Expr::If(e) => &e.attrs,
        syn::Expr::Index(e) => &e.attrs,
        syn::Expr::Infer(e) => &e.attrs,
        syn::Expr::Let(e) => &e.attrs,
        syn::Expr::Lit(e) => &e.attrs,
        syn::Expr::Loop(e) => &e.attrs,
        syn::Expr::Macro(e) => &e.attrs,
        syn::Expr::Match(e) => &e.attrs,
        syn::Expr::MethodCall(e) => &e.attrs,
        syn::Expr::Paren(e) => &e.attrs,
        syn::Expr::Path(e) => &e.attrs,
        syn::Expr::Range(e) => &e.attrs,
        syn::Expr::RawAddr(e) => &e.attrs,
        syn::Expr::Reference(e) => &e.attrs,
        syn::Expr::Repeat(e) => &e.attrs,
        syn::Expr::Return(e) => &e.attrs,
        syn::Expr::Struct(e) => &e.attrs,
        syn::Expr::Try(e) => &e.attrs,
        syn::Expr::Tuple(e) => &e.attrs,
        syn::Expr::Unary(e) => &e.attrs,
        syn::Expr::Unsafe(e) => &e.attrs,
        syn::Expr::While(e) => &e.attrs,
        syn::Expr::Yield(e) => &e.attrs,
        _ => &[],
    }
}
