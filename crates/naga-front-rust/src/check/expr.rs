//! Expressions.

use crate::diag::{R, err};
use crate::hir::{Expr, Kind, Lit};
use crate::ty::Ty;

use super::Checker;
use super::path::PathValue;

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
