//! From syntax to [`hir`](crate::hir): names, types, methods. One function instance at a time, with concrete generics.

mod call;
mod expr;
mod method;
mod op;
mod pat;
mod path;
mod stmt;
mod types;

use std::collections::HashMap;

use crate::diag::{R, Span, err};
use crate::hir::{Body, ConstKey, Expr, Instance, Kind, Local, LocalId};
use crate::items::{Items, ModId, Owner, check_attrs};
use crate::ty::{Substs, Table, Ty};

/// Where a piece of syntax stands: what its names and its `Self` mean.
#[derive(Clone, Debug)]
pub(crate) struct Scope {
    pub(crate) module: ModId,
    pub(crate) file: usize,
    pub(crate) substs: Substs,
    pub(crate) self_ty: Option<Ty>,
    /// The code is generic, so a method found on the concrete type may not be the one that rustc chose by bounds.
    pub(crate) generic: bool,
}

pub(crate) struct Checker<'p> {
    pub(crate) items: &'p Items,
    pub(crate) scope: Scope,
    pub(crate) table: Table,
    locals: Vec<Local>,
    names: Vec<HashMap<String, LocalId>>,
    ret: Ty,
    loops: Vec<Loop>,
    /// Float literals whose type was open.
    floats: Vec<(Ty, Span)>,
}

/// A loop being checked: the type of `break value`, where `loop` may have one.
struct Loop {
    value: Option<Ty>,
    broken: bool,
}

impl<'p> Checker<'p> {
    pub(crate) fn new(items: &'p Items, scope: Scope) -> Self {
        Checker {
            items,
            scope,
            table: Table::default(),
            locals: Vec::new(),
            names: vec![HashMap::new()],
            ret: Ty::Unit,
            loops: Vec::new(),
            floats: Vec::new(),
        }
    }

    fn span(&self, tokens: &impl syn::spanned::Spanned) -> Span {
        Span::of(self.scope.file, tokens)
    }

    fn show(&self, ty: &Ty) -> String {
        self.table.zonk(ty).show(self.items)
    }

    fn zonk(&self, ty: &Ty) -> Ty {
        self.table.zonk(ty)
    }

    fn declare(&mut self, name: &str, ty: Ty, mutable: bool) -> LocalId {
        let id = self.locals.len();
        self.locals.push(Local {
            name: name.to_string(),
            ty,
            mutable,
        });
        self.names
            .last_mut()
            .expect("a scope is always open")
            .insert(name.to_string(), id);
        id
    }

    fn local(&self, name: &str) -> Option<LocalId> {
        self.names
            .iter()
            .rev()
            .find_map(|scope| scope.get(name).copied())
    }

    /// Makes `expr` fit `want`: `&mut T` gives `T` where a value is wanted.
    fn coerce(&mut self, expr: Expr, want: &Ty) -> R<Expr> {
        let have = self.zonk(&expr.ty);
        let want = self.zonk(want);
        let expr = match (&have, &want) {
            (Ty::RefMut(inner), w) if !matches!(w, Ty::RefMut(_) | Ty::Var(_)) => Expr {
                ty: (**inner).clone(),
                span: expr.span,
                kind: Kind::Deref(Box::new(expr)),
            },
            _ => expr,
        };
        self.unify(&expr.ty.clone(), &want, expr.span)?;
        Ok(expr)
    }

    fn unify(&mut self, have: &Ty, want: &Ty, span: Span) -> R<()> {
        if self.table.unify(have, want).is_ok() {
            return Ok(());
        }
        let (have, want) = (self.zonk(have), self.zonk(want));
        if matches!((&have, &want), (Ty::Array(..), Ty::Slice(_))) {
            return Err(err(
                span,
                "an array does not become a slice in shared code",
                "take `&[T; N]` in the function, generic over `const N: usize`",
            ));
        }
        Err(err(
            span,
            format!(
                "expected `{}`, found `{}`",
                want.show(self.items),
                have.show(self.items)
            ),
            "the front end and rustc disagree here: annotate the type, or simplify the expression",
        ))
    }

    /// Refuses `&mut` where Rust would keep the reference and a copy would take its place.
    fn no_ref(&self, expr: Expr) -> R<Expr> {
        if let Ty::RefMut(_) = self.zonk(&expr.ty) {
            return Err(err(
                expr.span,
                "`&mut` cannot be kept in a value, chosen, or assigned",
                "use the place itself, or pass `&mut place` to a function in each branch",
            ));
        }
        Ok(expr)
    }

    /// Reads through `&mut`.
    fn value(&self, expr: Expr) -> Expr {
        match self.zonk(&expr.ty) {
            Ty::RefMut(inner) => Expr {
                ty: *inner,
                span: expr.span,
                kind: Kind::Deref(Box::new(expr)),
            },
            ty => Expr { ty, ..expr },
        }
    }

    fn finish(self, name: String, params: Vec<LocalId>, value: Expr, span: Span) -> R<Body> {
        for (ty, at) in &self.floats {
            if let Ty::FloatVar(_) = self.zonk(ty) {
                return Err(err(
                    *at,
                    "this float is an f64 in Rust: nothing makes it an f32",
                    "write its type: `1.0_f32`",
                ));
            }
        }
        Ok(Body {
            name,
            params,
            locals: self.locals,
            ret: self.ret,
            value,
            table: self.table,
            span,
        })
    }
}

/// The scope in which a function's signature and body stand.
pub(crate) fn fn_scope(items: &Items, instance: &Instance) -> Scope {
    let f = &items.fns[instance.id];
    Scope {
        module: f.module,
        file: f.file,
        substs: instance.substs.clone(),
        self_ty: instance.self_ty.clone(),
        generic: !instance.substs.is_empty() || matches!(f.owner, Owner::Trait(_)),
    }
}

/// Checks the body of a function for given generic arguments.
pub(crate) fn check_fn(items: &Items, instance: &Instance) -> R<Body> {
    let f = &items.fns[instance.id];
    let mut c = Checker::new(items, fn_scope(items, instance));
    let span = c.span(&f.sig.ident);
    check_attrs(f.file, &f.attrs)?;
    let Some(block) = &f.body else {
        return Err(err(
            span,
            format!("`{}` has no body here", f.sig.ident),
            "give the trait method a default, or implement it for the type",
        ));
    };
    let refuse = |what: &str| {
        Err(err(
            span,
            format!("{what} cannot be lowered"),
            "write a plain `fn`",
        ))
    };
    if f.sig.asyncness.is_some() {
        return refuse("an `async fn`");
    }
    if !matches!(f.sig.safety, syn::Safety::Default) {
        return refuse("an `unsafe fn`");
    }
    if f.sig.variadic.is_some() || f.sig.abi.is_some() {
        return refuse("an `extern fn`");
    }
    let signature = c.signature(instance, span)?;
    c.ret = signature.ret.clone();
    let mut params = Vec::new();
    let mut unpack = Vec::new();
    for (arg, ty) in f.sig.inputs.iter().zip(signature.params) {
        let (syn::FnArg::Receiver(syn::Receiver { attrs, .. })
        | syn::FnArg::Typed(syn::PatType { attrs, .. })) = arg;
        check_attrs(f.file, attrs)?;
        match arg {
            syn::FnArg::Receiver(r) => params.push(c.declare("self", ty, r.mutability.is_some())),
            syn::FnArg::Typed(p) => match &*p.pat {
                syn::Pat::Ident(i) if i.subpat.is_none() && i.by_ref.is_none() => {
                    params.push(c.declare(&i.ident.to_string(), ty, i.mutability.is_some()));
                }
                syn::Pat::Wild(_) => params.push(c.declare("unused", ty, false)),
                pat => {
                    let id = c.declare("parts", ty.clone(), false);
                    params.push(id);
                    unpack.push((id, pat, ty));
                }
            },
        }
    }
    let mut stmts = Vec::new();
    for (id, pat, ty) in unpack {
        let at = c.span(pat);
        let pat = c.pattern(pat, &ty)?;
        let init = Expr {
            kind: Kind::Local(id),
            ty,
            span: at,
        };
        stmts.push(crate::hir::Stmt::Let {
            pat,
            init: Some(Box::new(init)),
            otherwise: None,
            span: at,
        });
    }
    let ret = c.ret.clone();
    let mut value = c.block(block, Some(&ret))?;
    if !matches!(c.zonk(&value.ty), Ty::Never) {
        value = c.coerce(value, &ret)?;
    }
    if !stmts.is_empty() {
        value = Expr {
            ty: value.ty.clone(),
            span: value.span,
            kind: Kind::Block(stmts, Some(Box::new(value))),
        };
    }
    let name = match f.owner {
        Owner::Free => f.sig.ident.to_string(),
        _ => {
            let owner = instance
                .self_ty
                .as_ref()
                .map(|t| t.show(items))
                .unwrap_or_default();
            let owner: String = owner
                .chars()
                .map(|c| if c.is_alphanumeric() { c } else { '_' })
                .collect();
            format!("{}_{}", owner.trim_matches('_'), f.sig.ident)
        }
    };
    c.finish(name, params, value, span)
}

/// Checks the value of a const.
pub(crate) fn check_const(items: &Items, key: &ConstKey) -> R<Body> {
    let item = &items.consts[key.id];
    let scope = Scope {
        module: item.module,
        file: item.file,
        substs: key.substs.clone(),
        self_ty: key.self_ty.clone(),
        generic: !key.substs.is_empty() || matches!(item.owner, Owner::Trait(_)),
    };
    let mut c = Checker::new(items, scope);
    let span = c.span(&item.ty);
    let open = key.substs.iter().any(|(_, t)| t.is_open())
        || key.self_ty.as_ref().is_some_and(Ty::is_open);
    if open {
        return Err(err(
            span,
            format!(
                "the types that `{}` belongs to are not known where it is used",
                item.name
            ),
            "write them: `Type::<Argument>::NAME`",
        ));
    }
    let Some(value) = &item.value else {
        return Err(err(
            span,
            format!(
                "the associated const `{}` has no value for this type",
                item.name
            ),
            "define it in the impl, or give it a default in the trait",
        ));
    };
    let ty = c.ty(&item.ty)?;
    c.ret = ty.clone();
    let value = c.expr(value, Some(&ty))?;
    let value = c.coerce(value, &ty)?;
    c.finish(item.name.clone(), Vec::new(), value, span)
}

impl Checker<'_> {
    /// The type of a field of a struct with known arguments.
    pub(crate) fn struct_field(&mut self, ty: &Ty, index: usize, span: Span) -> R<Ty> {
        self.field_type(ty, index, span)
    }

    /// A path from the host to a function of the program.
    pub(crate) fn function_path(&mut self, path: &syn::ExprPath) -> R<Option<Instance>> {
        Ok(match self.path(path)? {
            path::PathValue::Callable(path::Callable::Fn(instance)) => Some(instance),
            _ => None,
        })
    }
}
