//! Calls, methods, fields, indices, references, struct literals.

use crate::builtins::{self, Arg};
use crate::diag::{R, Span, err};
use crate::hir::{Builtin, Expr, Instance, Kind};
use crate::ty::{Scalar, Ty};

use super::Checker;
use super::method::What;
use super::path::{Callable, PathValue};

impl Checker<'_> {
    pub(super) fn call(&mut self, c: &syn::ExprCall, expect: Option<&Ty>) -> R<Expr> {
        let span = self.span(c);
        let mut func = &*c.func;
        while let syn::Expr::Paren(p) = func {
            func = &p.expr;
        }
        let syn::Expr::Path(p) = func else {
            return Err(err(
                span,
                "only functions can be called",
                "closures and function pointers do not exist on a GPU",
            ));
        };
        let args: Vec<&syn::Expr> = c.args.iter().collect();
        let callable = match self.path(p)? {
            PathValue::Callable(callable) => callable,
            PathValue::Expr(e) => {
                return Err(err(
                    span,
                    format!("a value of type `{}` cannot be called", self.show(&e.ty)),
                    "call a function",
                ));
            }
        };
        match callable {
            Callable::Fn(instance) => self.call_instance(instance, None, &args, expect, span),
            Callable::Some => {
                let [arg] = args.as_slice() else {
                    return Err(err(span, "`Some` takes one value", "write `Some(value)`"));
                };
                let payload = match expect.map(|t| self.zonk(t)) {
                    Some(Ty::Option(t)) => *t,
                    _ => self.table.var(),
                };
                let e = self.expr(arg, Some(&payload))?;
                let e = self.no_ref(e)?;
                let e = self.coerce(e, &payload)?;
                let ty = Ty::Option(Box::new(payload));
                Ok(Expr {
                    kind: Kind::Some(Box::new(e)),
                    ty,
                    span,
                })
            }
            Callable::TupleStruct(id, generic) => {
                let ty = Ty::Struct(id, generic);
                let mut fields = Vec::new();
                for (i, arg) in args.iter().enumerate() {
                    let want = self.field_type(&ty, i, span)?;
                    let e = self.expr(arg, Some(&want))?;
                    fields.push((i, self.coerce(e, &want)?));
                }
                Ok(Expr {
                    kind: Kind::Struct(fields, None),
                    ty,
                    span,
                })
            }
            Callable::Libm(name) => {
                let (op, n) = builtins::libm(&name).expect("the path was looked up");
                let mut list = Vec::new();
                for (i, arg) in args.iter().enumerate() {
                    let want = if name == "ldexpf" && i == 1 {
                        Ty::I32
                    } else {
                        Ty::F32
                    };
                    let e = self.expr(arg, Some(&want))?;
                    list.push(self.coerce(e, &want)?);
                }
                if list.len() != n {
                    return Err(err(
                        span,
                        format!("`{name}` takes {n} arguments"),
                        "see libm's documentation",
                    ));
                }
                Ok(self.builtin(op, list, Ty::F32, span))
            }
            Callable::Short(ty) => self.compose(&ty, &args, span),
            Callable::Builtin(ty, name) => self.builtin_assoc(&ty, &name, &args, span),
            Callable::OfTrait(t, name) => {
                let Some((first, _)) = args.split_first() else {
                    return Err(err(
                        span,
                        "this trait function has no receiver to find its type by",
                        "write `<Type as Trait>::name()`",
                    ));
                };
                let receiver = self.expr(first, None)?;
                let ty = self.zonk(receiver.ty.behind());
                let ty = match ty {
                    Ty::RefMut(t) => *t,
                    t => t,
                };
                let Some(m) = self.member(&ty, &name, What::Fn, Some(t), false, span)? else {
                    return Err(err(
                        span,
                        format!(
                            "`{}` does not implement this trait in the files given",
                            self.show(&ty)
                        ),
                        "hand the impl's file to the front end",
                    ));
                };
                let instance =
                    self.instantiate(m.id, m.substs, Some(ty), &syn::PathArguments::None, span)?;
                self.call_instance(instance, Some(receiver), &args[1..], expect, span)
            }
        }
    }

    /// Checks the arguments against the signature; `receiver` is the first of them where it is checked already.
    fn call_instance(
        &mut self,
        instance: Instance,
        receiver: Option<Expr>,
        args: &[&syn::Expr],
        expect: Option<&Ty>,
        span: Span,
    ) -> R<Expr> {
        let signature = self.signature(&instance, span)?;
        let given = args.len() + usize::from(receiver.is_some());
        if signature.params.len() != given {
            return Err(err(
                span,
                format!(
                    "expected {} arguments, found {given}",
                    signature.params.len()
                ),
                "check the call",
            ));
        }
        // What the result must be may settle generic arguments, as in rustc; a mismatch shows later.
        if let Some(want) = expect {
            let want = self.zonk(want);
            let ret = self.zonk(&signature.ret);
            let mut trial = self.table.clone();
            if !matches!(want, Ty::Var(_) | Ty::Never) && trial.unify(&ret, &want).is_ok() {
                self.table = trial;
            }
        }
        let mut list = Vec::new();
        let mut params = signature.params.iter();
        if let Some(r) = receiver {
            let want = params.next().expect("counted");
            list.push(self.receiver(r, want)?);
        }
        for (arg, want) in args.iter().zip(params) {
            let e = self.expr(arg, Some(want))?;
            list.push(self.coerce(e, want)?);
        }
        Ok(Expr {
            kind: Kind::Call(instance, list),
            ty: signature.ret,
            span,
        })
    }

    /// Borrows a receiver as the method wants it.
    fn receiver(&mut self, r: Expr, want: &Ty) -> R<Expr> {
        let have = self.zonk(&r.ty);
        let wants_mut = matches!(self.zonk(want), Ty::RefMut(_));
        let r = if wants_mut && !matches!(have, Ty::RefMut(_)) {
            Expr {
                ty: Ty::RefMut(Box::new(have)),
                span: r.span,
                kind: Kind::RefMut(Box::new(r)),
            }
        } else {
            r
        };
        self.coerce(r, want)
    }

    pub(super) fn method_call(&mut self, m: &syn::ExprMethodCall, expect: Option<&Ty>) -> R<Expr> {
        let span = self.span(&m.method);
        let whole = self.span(m);
        let name = m.method.to_string();
        let receiver = self.expr(&m.receiver, None)?;
        let ty = self.zonk(&receiver.ty).behind().clone();
        let args: Vec<&syn::Expr> = m.args.iter().collect();
        if let Ty::Slice(_) | Ty::Array(..) = ty
            && matches!(name.as_str(), "len" | "is_empty")
        {
            if self
                .member(&ty, &name, What::Fn, None, false, span)?
                .is_some()
            {
                return Err(err(
                    span,
                    format!(
                        "`{name}` on `{}` is ambiguous: a trait has it too",
                        self.show(&ty)
                    ),
                    "rename the trait's",
                ));
            }
            let base = self.value(receiver);
            let len = match &ty {
                Ty::Array(_, n) => match self.zonk(n) {
                    Ty::Const(n) => Expr {
                        kind: Kind::Int(n),
                        ty: Ty::Usize,
                        span: whole,
                    },
                    _ => {
                        return Err(err(
                            span,
                            "the array's length is not known here",
                            "annotate its type",
                        ));
                    }
                },
                _ => Expr {
                    kind: Kind::Len(Box::new(base)),
                    ty: Ty::Usize,
                    span: whole,
                },
            };
            return Ok(match name.as_str() {
                "len" => len,
                _ => self.builtin(Builtin::IsEmpty, vec![len], Ty::Bool, whole),
            });
        }
        if let (Ty::Mat(n), "col", [index]) = (&ty, name.as_str(), args.as_slice()) {
            let base = self.value(receiver);
            let index = self.expr(index, Some(&Ty::Usize))?;
            let index = self.coerce(index, &Ty::Usize)?;
            let ty = Ty::Vec(Scalar::F32, *n);
            return Ok(Expr {
                kind: Kind::Index(Box::new(base), Box::new(index)),
                ty,
                span: whole,
            });
        }
        if let Ty::Var(_) | Ty::IntVar(_) | Ty::FloatVar(_) = ty {
            return Err(err(
                span,
                format!("the type on which `{name}` is called is not known here"),
                "annotate it, as in `let x: u32 = …`",
            ));
        }
        let builtin = builtins::method(&ty, &name);
        let turbofish = match &m.turbofish {
            Some(t) => syn::PathArguments::AngleBracketed(t.clone()),
            None => syn::PathArguments::None,
        };
        if let Some(found) = self.member(&ty, &name, What::Fn, None, builtin.is_some(), span)? {
            let instance = self.instantiate(found.id, found.substs, Some(ty), &turbofish, span)?;
            if self.items.fns[instance.id].sig.receiver().is_none() {
                return Err(err(
                    span,
                    format!("`{name}` is not a method"),
                    "call it as `Type::name(…)`",
                ));
            }
            let call = self.call_instance(instance, Some(receiver), &args, expect, whole)?;
            return Ok(call);
        }
        match builtin {
            Some(method) => {
                let this = self.value(receiver);
                self.builtin_method(&ty, &name, method, this, &args, whole)
            }
            None => {
                let help = builtins::refused_method(&name).unwrap_or(
                    "hand the impl's file to the front end, or use what the subset knows",
                );
                Err(err(
                    span,
                    format!(
                        "`{}` has no method `{name}` that the front end knows",
                        self.show(&ty)
                    ),
                    help,
                ))
            }
        }
    }

    fn builtin_method(
        &mut self,
        ty: &Ty,
        name: &str,
        method: builtins::Method,
        this: Expr,
        args: &[&syn::Expr],
        span: Span,
    ) -> R<Expr> {
        if args.len() != method.args.len() {
            return Err(err(
                span,
                format!("`{name}` takes {} arguments", method.args.len()),
                "check the call",
            ));
        }
        let mut list = vec![this];
        for (arg, kind) in args.iter().zip(method.args) {
            let want = match kind {
                Arg::Same => ty.clone(),
                Arg::U32 => Ty::U32,
                Arg::F32 => Ty::F32,
                Arg::Scalar => ty.scalar().map_or(Ty::F32, Ty::of_scalar),
                Arg::VecF32(n) => Ty::Vec(Scalar::F32, *n),
                Arg::Payload => match ty {
                    Ty::Option(t) => (**t).clone(),
                    t => t.clone(),
                },
            };
            let e = self.expr(arg, Some(&want))?;
            list.push(self.coerce(e, &want)?);
        }
        Ok(self.builtin(method.op, list, method.ret, span))
    }

    fn builtin_assoc(&mut self, ty: &Ty, name: &str, args: &[&syn::Expr], span: Span) -> R<Expr> {
        match (ty, name) {
            (Ty::Vec(..), "new") | (Ty::Mat(_), "from_cols") => self.compose(ty, args, span),
            (Ty::Vec(s, n), "splat" | "from_array") => {
                let scalar = Ty::of_scalar(*s);
                let (want, op) = match name {
                    "splat" => (scalar, Builtin::Splat),
                    _ => (
                        Ty::Array(Box::new(scalar), Box::new(Ty::Const((*n).into()))),
                        Builtin::FromArray,
                    ),
                };
                self.one(ty, name, op, &want, args, span)
            }
            (Ty::Mat(n), "from_diagonal") => {
                let want = Ty::Vec(Scalar::F32, *n);
                self.one(ty, name, Builtin::FromDiagonal, &want, args, span)
            }
            (Ty::F32, "from_bits") => self.one(ty, name, Builtin::Bitcast, &Ty::U32, args, span),
            _ => {
                // `f32::max(a, b)` is `a.max(b)`.
                let method = builtins::method(ty, name);
                match (method, args.split_first()) {
                    (Some(method), Some((first, rest))) => {
                        let this = self.expr(first, Some(ty))?;
                        let this = self.coerce(this, ty)?;
                        self.builtin_method(ty, name, method, this, rest, span)
                    }
                    _ => Err(err(
                        span,
                        format!("`{name}` needs its arguments"),
                        "check the call",
                    )),
                }
            }
        }
    }

    fn one(
        &mut self,
        ty: &Ty,
        name: &str,
        op: Builtin,
        want: &Ty,
        args: &[&syn::Expr],
        span: Span,
    ) -> R<Expr> {
        let [arg] = args else {
            return Err(err(
                span,
                format!("`{name}` takes one argument"),
                "check the call",
            ));
        };
        let e = self.expr(arg, Some(want))?;
        let e = self.coerce(e, want)?;
        Ok(self.builtin(op, vec![e], ty.clone(), span))
    }

    fn compose(&mut self, ty: &Ty, args: &[&syn::Expr], span: Span) -> R<Expr> {
        let (n, want) = match ty {
            Ty::Vec(s, n) => (*n, Ty::of_scalar(*s)),
            Ty::Mat(n) => (*n, Ty::Vec(Scalar::F32, *n)),
            _ => {
                return Err(err(
                    span,
                    "this type has no such constructor",
                    "check the call",
                ));
            }
        };
        if args.len() != n as usize {
            return Err(err(
                span,
                format!("expected {n} components, found {}", args.len()),
                "check the call",
            ));
        }
        let mut list = Vec::new();
        for arg in args {
            let e = self.expr(arg, Some(&want))?;
            list.push(self.coerce(e, &want)?);
        }
        Ok(self.builtin(Builtin::Compose, list, ty.clone(), span))
    }

    /// The type of field `index` of a struct or tuple.
    pub(super) fn field_type(&mut self, ty: &Ty, index: usize, span: Span) -> R<Ty> {
        match self.zonk(ty) {
            Ty::Tuple(list) if index < list.len() => Ok(list[index].clone()),
            Ty::Struct(id, args) => {
                let item = &self.items.structs[id];
                crate::items::check_attrs(item.file, &item.item.attrs)?;
                let field = item.item.fields.iter().nth(index);
                let field = field.ok_or_else(|| err(span, "no such field", "check the struct"))?;
                crate::items::check_attrs(item.file, &field.attrs)?;
                let names = item.item.generics.params.iter().filter_map(|p| match p {
                    syn::GenericParam::Lifetime(_) => None,
                    syn::GenericParam::Type(t) => Some(t.ident.to_string()),
                    syn::GenericParam::Const(c) => Some(c.ident.to_string()),
                });
                let substs = names.zip(args.iter().cloned()).collect();
                if let syn::Type::Reference(r) = &field.ty
                    && r.mutability.is_some()
                {
                    return Err(err(
                        Span::of(item.file, &field.ty),
                        "a field cannot hold `&mut`",
                        "pass the `&mut` beside the struct, as an argument",
                    ));
                }
                let scope = super::Scope {
                    module: item.module,
                    file: item.file,
                    substs,
                    self_ty: Some(Ty::Struct(id, args.clone())),
                    generic: false,
                };
                self.within(scope, |c| c.ty(&field.ty))
            }
            other => Err(err(
                span,
                format!("`{}` has no such field", self.show(&other)),
                "check the type",
            )),
        }
    }

    pub(super) fn member_index(&self, ty: &Ty, member: &syn::Member) -> Option<usize> {
        match (self.zonk(ty), member) {
            (Ty::Struct(id, _), syn::Member::Named(name)) => self.items.structs[id]
                .item
                .fields
                .iter()
                .position(|f| f.ident.as_ref() == Some(name)),
            (Ty::Tuple(_) | Ty::Struct(..), syn::Member::Unnamed(i)) => Some(i.index as usize),
            _ => None,
        }
    }

    pub(super) fn field(&mut self, f: &syn::ExprField) -> R<Expr> {
        let span = self.span(f);
        let base = self.expr(&f.base, None)?;
        let base = self.value(base);
        let ty = self.zonk(&base.ty);
        if let (Ty::Vec(s, n), syn::Member::Named(name)) = (&ty, &f.member) {
            let name = name.to_string();
            if let Some(at) = ["x", "y", "z", "w"]
                .iter()
                .position(|c| *c == name)
                .filter(|i| *i < *n as usize)
            {
                return Ok(Expr {
                    kind: Kind::Component(Box::new(base), at as u32),
                    ty: Ty::of_scalar(*s),
                    span,
                });
            }
        }
        if let (Ty::Mat(n), syn::Member::Named(name)) = (&ty, &f.member) {
            let name = name.to_string();
            let axes = ["x_axis", "y_axis", "z_axis", "w_axis"];
            if let Some(at) = axes
                .iter()
                .position(|c| *c == name)
                .filter(|i| *i < *n as usize)
            {
                let ty = Ty::Vec(Scalar::F32, *n);
                return Ok(Expr {
                    kind: Kind::Component(Box::new(base), at as u32),
                    ty,
                    span,
                });
            }
        }
        let Some(index) = self.member_index(&ty, &f.member) else {
            let open = matches!(ty, Ty::Var(_));
            let help = if open {
                "annotate its type"
            } else {
                "check the type, or hand its file to the front end"
            };
            return Err(err(
                span,
                format!("no such field on `{}`", self.show(&ty)),
                help,
            ));
        };
        let ty = self.field_type(&ty, index, span)?;
        Ok(Expr {
            kind: Kind::Field(Box::new(base), index),
            ty,
            span,
        })
    }

    pub(super) fn index(&mut self, i: &syn::ExprIndex) -> R<Expr> {
        let span = self.span(i);
        let base = self.expr(&i.expr, None)?;
        let base = self.value(base);
        let ty = self.zonk(&base.ty);
        if let syn::Expr::Range(r) = &*i.index {
            let Ty::Slice(_) = ty else {
                return Err(err(
                    span,
                    format!("`{}` has no sub-slice", self.show(&ty)),
                    "only slices of buffers do: take `&[T]`",
                ));
            };
            if matches!(r.limits, syn::RangeLimits::Closed(_)) {
                return Err(err(
                    span,
                    "an inclusive range to sub-slice cannot be lowered",
                    "write `a..b + 1`",
                ));
            }
            let mut bound = |e: &Option<Box<syn::Expr>>| -> R<Option<Box<Expr>>> {
                let Some(e) = e else { return Ok(None) };
                let e = self.expr(e, Some(&Ty::Usize))?;
                Ok(Some(Box::new(self.coerce(e, &Ty::Usize)?)))
            };
            let (lo, hi) = (bound(&r.start)?, bound(&r.end)?);
            return Ok(Expr {
                kind: Kind::SubSlice(Box::new(base), lo, hi),
                ty,
                span,
            });
        }
        let elem = match &ty {
            Ty::Slice(t) | Ty::Array(t, _) => (**t).clone(),
            Ty::Vec(s, _) => Ty::of_scalar(*s),
            _ => {
                return Err(err(
                    span,
                    format!("`{}` cannot be indexed", self.show(&ty)),
                    "index slices, arrays and vectors; for a matrix there is `x_axis` and its kin",
                ));
            }
        };
        let index = self.expr(&i.index, Some(&Ty::Usize))?;
        let index = self.coerce(index, &Ty::Usize)?;
        Ok(Expr {
            kind: Kind::Index(Box::new(base), Box::new(index)),
            ty: elem,
            span,
        })
    }

    pub(super) fn reference(&mut self, r: &syn::ExprReference, expect: Option<&Ty>) -> R<Expr> {
        let span = self.span(r);
        let inner_expect = expect.map(|t| self.zonk(t).behind().clone());
        let inner = self.expr(&r.expr, inner_expect.as_ref())?;
        let ty = self.zonk(&inner.ty);
        if r.mutability.is_none() || matches!(ty, Ty::Slice(_)) {
            return Ok(self.value(inner));
        }
        match ty {
            // `&mut *r` is `r`.
            Ty::RefMut(_) => Ok(inner),
            ty => Ok(match inner.kind {
                Kind::Deref(r) => *r,
                _ => Expr {
                    ty: Ty::RefMut(Box::new(ty)),
                    span,
                    kind: Kind::RefMut(Box::new(inner)),
                },
            }),
        }
    }

    pub(super) fn struct_expr(&mut self, s: &syn::ExprStruct) -> R<Expr> {
        let span = self.span(s);
        if s.qself.is_some() {
            return Err(err(
                span,
                "associated types are not in the subset",
                "name the struct",
            ));
        }
        let path = syn::TypePath {
            attrs: Vec::new(),
            qself: None,
            path: s.path.clone(),
        };
        let mut ty = self.ty(&syn::Type::Path(path))?;
        if let (Ty::Struct(id, _), true) = (&ty, s.path.is_ident("Self")) {
            // `Self { … }` has the impl's own arguments.
            ty = self
                .scope
                .self_ty
                .clone()
                .unwrap_or(Ty::Struct(*id, Vec::new()));
        }
        let Ty::Struct(id, _) = ty else {
            return Err(err(
                span,
                format!("`{}` is not a struct", self.show(&ty)),
                "name a struct",
            ));
        };
        let mut fields = Vec::new();
        for f in &s.fields {
            crate::items::check_attrs(self.scope.file, &f.attrs)?;
            let Some(index) = self.member_index(&ty, &f.member) else {
                return Err(err(self.span(f), "no such field", "check the struct"));
            };
            let want = self.field_type(&ty, index, span)?;
            let e = self.expr(&f.expr, Some(&want))?;
            let e = self.coerce(e, &want)?;
            fields.push((index, e));
        }
        let base = match &s.rest {
            Some(rest) => {
                let e = self.expr(rest, Some(&ty))?;
                Some(Box::new(self.coerce(e, &ty)?))
            }
            None => None,
        };
        let all = self.items.structs[id].item.fields.len();
        if base.is_none() && fields.len() != all {
            return Err(err(
                span,
                format!("{} of {all} fields are given", fields.len()),
                "give every field, or `..base`",
            ));
        }
        Ok(Expr {
            kind: Kind::Struct(fields, base),
            ty,
            span,
        })
    }
}
