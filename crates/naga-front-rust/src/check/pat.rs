//! Patterns.

use std::collections::HashSet;

use crate::diag::{R, err};
use crate::hir::{ConstKey, Expr, Kind, Pat};
use crate::items::Def;
use crate::resolve::Ns;
use crate::ty::Ty;

use super::Checker;
use super::path::PathValue;

impl Checker<'_> {
    /// A pattern for a value of type `ty`; declares its bindings.
    pub(super) fn pattern(&mut self, p: &syn::Pat, ty: &Ty) -> R<Pat> {
        let span = self.span(p);
        let ty = &self.zonk(ty);
        match p {
            syn::Pat::Wild(_) => Ok(Pat::Wild),
            syn::Pat::Paren(p) => self.pattern(&p.pat, ty),
            syn::Pat::Reference(r) => self.pattern(&r.pat, ty),
            syn::Pat::Type(t) => {
                let written = self.ty(&t.ty)?;
                self.unify(&written, ty, span)?;
                self.pattern(&t.pat, &written)
            }
            syn::Pat::Ident(i) => {
                let name = i.ident.to_string();
                if i.by_ref.is_some() {
                    return Err(err(
                        span,
                        "`ref` patterns cannot be lowered",
                        "bind the value, then use it",
                    ));
                }
                if let Some((_, inner)) = &i.subpat {
                    let id = self.declare(&name, ty.clone(), i.mutability.is_some());
                    return Ok(Pat::At(id, Box::new(self.pattern(inner, ty)?)));
                }
                if i.mutability.is_none() {
                    if name == "None" {
                        return self.option_pattern(None, ty, span);
                    }
                    let found = self.items.find(
                        self.scope.module,
                        std::slice::from_ref(&name),
                        Ns::Value,
                        span,
                        &mut HashSet::new(),
                    )?;
                    let unknown = found.is_none()
                        && (self.items.import_of(self.scope.module, &name).is_some()
                            || name.starts_with(|c: char| c.is_uppercase()));
                    if unknown || matches!(found, Some(Def::Extern(_))) {
                        return Err(err(
                            span,
                            format!("`{name}` may be a constant that the front end does not know"),
                            "hand its file to the front end, compare in a guard, or bind a lower-case name",
                        ));
                    }
                    if matches!(
                        found,
                        Some(Def::Const(_) | Def::Variant(..) | Def::Struct(_))
                    ) {
                        let path = syn::ExprPath {
                            attrs: Vec::new(),
                            qself: None,
                            path: i.ident.clone().into(),
                        };
                        return self.value_pattern(&path, ty);
                    }
                }
                if let Ty::RefMut(_) = ty {
                    return Err(err(
                        span,
                        "`&mut` cannot be kept in a variable",
                        "use the place itself",
                    ));
                }
                Ok(Pat::Bind(self.declare(
                    &name,
                    ty.clone(),
                    i.mutability.is_some(),
                )))
            }
            syn::Pat::Path(path) => self.value_pattern(path, ty),
            syn::Pat::Lit(l) => {
                let e = self.expr(&syn::Expr::Lit(l.clone()), Some(ty))?;
                self.value_of(e, ty)
            }
            syn::Pat::Range(r) => {
                let mut end = |e: &Option<Box<syn::Expr>>| -> R<Option<Box<Expr>>> {
                    let Some(e) = e else { return Ok(None) };
                    let e = self.expr(e, Some(ty))?;
                    Ok(Some(Box::new(self.coerce(e, ty)?)))
                };
                let (lo, hi) = (end(&r.start)?, end(&r.end)?);
                Ok(Pat::Range(
                    lo,
                    hi,
                    matches!(r.limits, syn::RangeLimits::Closed(_)),
                ))
            }
            syn::Pat::Tuple(t) => {
                let vars = match ty {
                    Ty::Tuple(list) => list.clone(),
                    _ => {
                        let list: Vec<Ty> = t.elems.iter().map(|_| self.table.var()).collect();
                        self.unify(&Ty::Tuple(list.clone()), ty, span)?;
                        list
                    }
                };
                self.sequence(&t.elems, &vars, span)
            }
            syn::Pat::TupleStruct(t) => {
                let path = super::types::names(&t.path);
                if path == ["Some"] && t.elems.len() == 1 {
                    return self.option_pattern(Some(&t.elems[0]), ty, span);
                }
                let Ty::Struct(..) = ty else {
                    return Err(super::path::enum_with_fields(span));
                };
                let mut vars = Vec::new();
                for i in 0..t.elems.len() {
                    vars.push(self.field_type(ty, i, span)?);
                }
                self.sequence(&t.elems, &vars, span)
            }
            syn::Pat::Struct(_) if !matches!(ty, Ty::Struct(..)) => Err(err(
                span,
                "a pattern with braces is for structs",
                "write the variant's path alone",
            )),
            syn::Pat::Struct(s) => {
                let mut fields = Vec::new();
                for f in &s.fields {
                    let Some(index) = self.member_index(ty, &f.member) else {
                        return Err(err(self.span(f), "no such field", "check the struct"));
                    };
                    let want = self.field_type(ty, index, span)?;
                    fields.push((index, self.pattern(&f.pat, &want)?));
                }
                Ok(Pat::Fields(fields))
            }
            syn::Pat::Or(o) => {
                let mut list = Vec::new();
                let before = self.locals.len();
                for case in &o.cases {
                    list.push(self.pattern(case, ty)?);
                }
                if self.locals.len() != before {
                    return Err(err(
                        span,
                        "alternatives that bind names cannot be lowered",
                        "write one arm for each",
                    ));
                }
                Ok(Pat::Or(list))
            }
            syn::Pat::Guard(_) => Err(err(
                span,
                "a guard is allowed on a whole arm only",
                "move it to the arm",
            )),
            syn::Pat::Slice(_) => Err(err(
                span,
                "a slice pattern cannot be lowered",
                "index the slice",
            )),
            _ => Err(err(
                span,
                "this pattern cannot be lowered",
                "use the patterns of the shared subset",
            )),
        }
    }

    fn sequence(
        &mut self,
        elems: &syn::punctuated::Punctuated<syn::Pat, syn::Token![,]>,
        types: &[Ty],
        span: crate::diag::Span,
    ) -> R<Pat> {
        if elems.iter().any(|p| matches!(p, syn::Pat::Rest(_))) {
            return Err(err(
                span,
                "`..` in a tuple pattern cannot be lowered",
                "write `_` for each field",
            ));
        }
        if elems.len() != types.len() {
            return Err(err(
                span,
                "the pattern has another number of fields",
                "write `_` for the others",
            ));
        }
        let mut fields = Vec::new();
        for (i, (p, ty)) in elems.iter().zip(types).enumerate() {
            fields.push((i, self.pattern(p, ty)?));
        }
        Ok(Pat::Fields(fields))
    }

    fn option_pattern(
        &mut self,
        inner: Option<&syn::Pat>,
        ty: &Ty,
        span: crate::diag::Span,
    ) -> R<Pat> {
        let payload = self.table.var();
        self.unify(&Ty::Option(Box::new(payload.clone())), ty, span)?;
        match inner {
            Some(p) => Ok(Pat::Some(Box::new(self.pattern(p, &payload)?))),
            None => Ok(Pat::None),
        }
    }

    fn value_pattern(&mut self, path: &syn::ExprPath, ty: &Ty) -> R<Pat> {
        let span = self.span(path);
        match self.path(path)? {
            PathValue::Expr(e) => {
                if let (Kind::Lit(crate::hir::Lit::U32(v)), Ty::Enum(_)) = (&e.kind, &e.ty) {
                    let v = *v;
                    self.unify(&e.ty, ty, span)?;
                    return Ok(Pat::Variant(v));
                }
                if let Kind::None = e.kind {
                    self.unify(&e.ty, ty, span)?;
                    return Ok(Pat::None);
                }
                if let Kind::Struct(fields, None) = &e.kind
                    && fields.is_empty()
                {
                    self.unify(&e.ty, ty, span)?;
                    return Ok(Pat::Wild);
                }
                self.value_of(e, ty)
            }
            PathValue::Callable(_) => Err(err(span, "this pattern needs its fields", "write them")),
        }
    }

    fn value_of(&mut self, e: Expr, ty: &Ty) -> R<Pat> {
        let e = self.coerce(e, ty)?;
        if let Kind::Const(ConstKey { .. }) | Kind::Lit(_) | Kind::Int(_) | Kind::Unary(..) = e.kind
        {
            Ok(Pat::Value(Box::new(e)))
        } else {
            Err(err(
                e.span,
                "this pattern is not a constant",
                "use literals and consts",
            ))
        }
    }
}
