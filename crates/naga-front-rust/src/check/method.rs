//! Which impl a method, an associated function or an associated const comes from.

use std::collections::HashSet;

use crate::diag::{R, Span, err};
use crate::hir::ConstKey;
use crate::items::{Def, FnId};
use crate::resolve::Ns;
use crate::ty::{Substs, Table, Ty};

use super::types::names;
use super::{Checker, Scope};

/// A member found in an impl or as a trait's default.
#[derive(Clone, Debug)]
pub(super) struct Member {
    /// A function's or a const's id.
    pub(super) id: usize,
    pub(super) substs: Substs,
    table: Table,
}

/// Methods of the traits that core derives.
const DERIVED: [&str; 16] = [
    "clone",
    "clone_from",
    "clamp",
    "cmp",
    "default",
    "eq",
    "fmt",
    "ge",
    "gt",
    "hash",
    "le",
    "lt",
    "max",
    "min",
    "ne",
    "partial_cmp",
];

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Receiver {
    Value,
    Ref,
    Other,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum What {
    Fn,
    Const,
}

impl Checker<'_> {
    /// The trait that a path names from `module`; `None` for traits that were not handed to the front end.
    fn trait_of(&self, module: usize, path: &syn::Path, span: Span) -> Option<usize> {
        let found = self
            .items
            .find(module, &names(path), Ns::Type, span, &mut HashSet::new());
        match found {
            Ok(Some(Def::Trait(id))) => Some(id),
            _ => None,
        }
    }

    /// Tries impl `i`, with fresh generic arguments and its self type, in a table of its own: both, if `fits` says so.
    fn try_impl(
        &mut self,
        i: usize,
        fits: impl FnOnce(&mut Self, &Ty, &Substs) -> bool,
    ) -> Option<(Substs, Table)> {
        let item = &self.items.impls[i];
        let outer = self.table.clone();
        let substs = self.fresh(&item.generics);
        let scope = Scope {
            module: item.module,
            file: item.file,
            substs: substs.clone(),
            self_ty: None,
            generic: false,
        };
        // A type that cannot be lowered is not the one that is asked for.
        let fits = match self.within(scope, |c| c.ty(&item.self_ty)) {
            Ok(target) => fits(self, &target, &substs),
            Err(_) => false,
        };
        let table = std::mem::replace(&mut self.table, outer);
        fits.then_some((substs, table))
    }

    /// Whether impl `i` is for `ty`: its generic arguments, in a table of their own.
    fn impl_matches(&mut self, i: usize, ty: &Ty, span: Span) -> Option<(Substs, Table)> {
        self.try_impl(i, |c, target, substs| {
            c.table.unify(target, ty).is_ok() && c.bounds_hold(i, substs, span)
        })
    }

    /// Whether an impl's bounds on its parameters hold, as far as they name the program's own traits.
    fn bounds_hold(&mut self, i: usize, substs: &[(String, Ty)], span: Span) -> bool {
        let item = &self.items.impls[i];
        for param in item.generics.type_params() {
            let mut bounds: Vec<&syn::TypeParamBound> = param.bounds.iter().collect();
            for predicate in item
                .generics
                .where_clause
                .iter()
                .flat_map(|w| &w.predicates)
            {
                if let syn::WherePredicate::Type(t) = predicate
                    && matches!(&t.bounded_ty, syn::Type::Path(p) if p.path.is_ident(&param.ident))
                {
                    bounds.extend(t.bounds.iter());
                }
            }
            let Some((_, ty)) = substs.iter().find(|(n, _)| param.ident == n) else {
                continue;
            };
            let ty = self.zonk(ty);
            for bound in bounds {
                if let syn::TypeParamBound::Trait(t) = bound
                    && let Some(trait_id) = self.trait_of(item.module, &t.path, span)
                    && !matches!(ty, Ty::Var(_))
                    && !self.implements(&ty, trait_id, span)
                {
                    return false;
                }
            }
        }
        true
    }

    fn implements(&mut self, ty: &Ty, trait_id: usize, span: Span) -> bool {
        (0..self.items.impls.len()).any(|i| {
            let item = &self.items.impls[i];
            let named = item
                .trait_
                .as_ref()
                .and_then(|p| self.trait_of(item.module, p, span));
            named == Some(trait_id) && self.impl_matches(i, ty, span).is_some()
        })
    }

    /// Members called `name` of `ty`: those of inherent impls, and those of traits.
    fn members(
        &mut self,
        ty: &Ty,
        name: &str,
        what: What,
        only: Option<usize>,
        span: Span,
    ) -> R<(Vec<Member>, Vec<Member>)> {
        let mut inherent = Vec::new();
        let mut of_traits: Vec<Member> = Vec::new();
        let mut of_others = 0;
        for i in 0..self.items.impls.len() {
            let item = &self.items.impls[i];
            let own = match what {
                What::Fn => item.fns.get(name),
                What::Const => item.consts.get(name),
            }
            .copied();
            if let syn::Type::Reference(r) = &item.self_ty
                && r.mutability.is_some()
            {
                // For `&mut T`, which rustc tries after `T` and before others: not told apart here.
                let declared = item
                    .trait_
                    .as_ref()
                    .and_then(|p| self.trait_of(item.module, p, span));
                let has = own.is_some()
                    || declared.is_some_and(|t| self.items.traits[t].fns.contains_key(name));
                if what == What::Fn && has && self.reference_matches(i, ty) {
                    return Err(err(
                        span,
                        format!(
                            "`{name}` is ambiguous: an impl for `&mut` of this type has it too"
                        ),
                        "implement the trait for the type alone",
                    ));
                }
                continue;
            }
            if item.opaque && own.is_none() && self.impl_matches(i, ty, span).is_some() {
                return Err(err(
                    span,
                    format!(
                        "cannot tell where `{name}` comes from: an impl holds a macro call, which may define it"
                    ),
                    "write the impl out",
                ));
            }
            if let (Some(gate), Some(_)) = (&item.gate, own)
                && self.impl_matches(i, ty, span).is_some()
            {
                return Err(err(
                    span,
                    format!("`{name}` is host code here: an impl that has it stands behind {gate}"),
                    "shared code carries no `cfg`: rename one of them",
                ));
            }
            match &item.trait_ {
                None => {
                    if let (Some(id), None) = (own, only)
                        && let Some((substs, table)) = self.impl_matches(i, ty, span)
                    {
                        inherent.push(Member { id, substs, table });
                    }
                }
                Some(path) => {
                    let Some(t) = self.trait_of(item.module, path, span) else {
                        of_others +=
                            usize::from(own.is_some() && self.impl_matches(i, ty, span).is_some());
                        continue;
                    };
                    if only.is_some_and(|only| only != t) {
                        continue;
                    }
                    let default = match what {
                        What::Fn => self.items.traits[t].fns.get(name),
                        What::Const => self.items.traits[t].consts.get(name),
                    }
                    .copied();
                    let Some(declared) = default else { continue };
                    if let Some((mut substs, table)) = self.impl_matches(i, ty, span) {
                        if own.is_none() {
                            // The default's body stands in the trait: the impl's parameters mean nothing there.
                            substs.clear();
                        }
                        let id = own.unwrap_or(declared);
                        of_traits.push(Member { id, substs, table });
                    }
                }
            }
        }
        if inherent.is_empty() && !of_traits.is_empty() && of_others > 0 && only.is_none() {
            return Err(err(
                span,
                format!(
                    "`{name}` is ambiguous: a trait that was not handed to the front end has it too"
                ),
                "call it by its trait, as `Trait::name(value)`",
            ));
        }
        Ok((inherent, of_traits))
    }

    /// The one member called `name` of `ty`. `builtin` says that the language has one of that name too.
    pub(super) fn member(
        &mut self,
        ty: &Ty,
        name: &str,
        what: What,
        only: Option<usize>,
        builtin: bool,
        span: Span,
    ) -> R<Option<Member>> {
        let (mut inherent, mut of_traits) = self.members(ty, name, what, only, span)?;
        let ambiguous = |c: &Self, between: &str| {
            Err(err(
                span,
                format!("`{name}` on `{}` is ambiguous: {between}", c.show(ty)),
                "call it by its trait, as `Trait::name(value)`, or rename one of them",
            ))
        };
        if inherent.len() > 1 {
            return ambiguous(self, "several inherent impls have it");
        }
        if of_traits.len() > 1 {
            return ambiguous(self, "several trait impls have it");
        }
        if self.scope.generic && (builtin || !inherent.is_empty()) && !of_traits.is_empty() {
            return ambiguous(
                self,
                "the type itself has it, and so has a trait, and this code is generic",
            );
        }
        // rustc tries all that take the receiver by value before all that borrow it, whoever has them.
        if what == What::Fn && only.is_none() && !of_traits.is_empty() {
            let same =
                |a: &Member, b: &Member| self.receiver_kind(a.id) == self.receiver_kind(b.id);
            let differs = match inherent.first() {
                Some(own) => {
                    !same(own, &of_traits[0]) && self.receiver_kind(own.id) != Some(Receiver::Value)
                }
                None => builtin,
            };
            if differs {
                return ambiguous(self, "the type itself has it, and so has a trait");
            }
        }
        let own = matches!(ty, Ty::Struct(..) | Ty::Enum(_));
        if let (Some(inherent), false, None) = (inherent.first(), of_traits.is_empty(), only) {
            let (public, home) = match what {
                What::Fn => (
                    self.items.fns[inherent.id].public,
                    self.items.fns[inherent.id].outer,
                ),
                What::Const => (
                    self.items.consts[inherent.id].public,
                    self.items.consts[inherent.id].module,
                ),
            };
            if !public && !self.items.is_below(self.scope.module, home) {
                return ambiguous(
                    self,
                    "the type's own is private to another module, and a trait has it too",
                );
            }
        }
        if own
            && only.is_none()
            && inherent.is_empty()
            && !of_traits.is_empty()
            && DERIVED.contains(&name)
        {
            return ambiguous(
                self,
                "a derived trait may have it, and so has a trait of the program",
            );
        }
        if !self.scope.generic
            && !own
            && only.is_none()
            && !of_traits.is_empty()
            && !builtin
            && (what == What::Const || crate::builtins::is_inherent(name))
        {
            return ambiguous(
                self,
                "the type itself has it, though not in the subset, and so has a trait",
            );
        }
        if builtin && inherent.is_empty() {
            return Ok(None);
        }
        let chosen = inherent.pop().or_else(|| of_traits.pop());
        if let Some(m) = &chosen {
            self.table = m.table.clone();
        }
        Ok(chosen)
    }

    /// Whether an impl is for `&mut` of `ty`.
    fn reference_matches(&mut self, i: usize, ty: &Ty) -> bool {
        self.try_impl(i, |c, target, _| c.table.unify(target.behind(), ty).is_ok())
            .is_some()
    }

    /// Whether some impl of the trait with this last name is for `ty`.
    pub(super) fn has_impl(&mut self, ty: &Ty, trait_name: &str, span: Span) -> bool {
        (0..self.items.impls.len()).any(|i| {
            let last = self.items.impls[i]
                .trait_
                .as_ref()
                .and_then(|p| p.segments.last());
            last.is_some_and(|s| s.ident == trait_name) && self.impl_matches(i, ty, span).is_some()
        })
    }

    fn receiver_kind(&self, id: FnId) -> Option<Receiver> {
        Some(match &self.items.fns[id].sig.receiver()?.kind {
            syn::ReceiverKind::Value => Receiver::Value,
            syn::ReceiverKind::Reference(_, _, None) => Receiver::Ref,
            _ => Receiver::Other,
        })
    }

    /// Whether `==` on an enum compares its numbers: as derived, and nobody wrote another.
    pub(super) fn compares_numbers(&mut self, id: usize, span: Span) -> bool {
        let derives = self.items.enums[id]
            .item
            .attrs
            .iter()
            .any(|a| match &a.meta {
                syn::Meta::List(l) => {
                    l.path.is_ident("derive") && l.tokens.to_string().contains("PartialEq")
                }
                _ => false,
            });
        derives && !self.has_impl(&Ty::Enum(id), "PartialEq", span)
    }

    /// The impl of an operator's trait (`core::ops::Add` by its last name) for `ty`, right side `rhs`.
    pub(super) fn operator(
        &mut self,
        ty: &Ty,
        trait_name: &str,
        method: &str,
        rhs: Option<&Ty>,
        span: Span,
    ) -> R<Option<(FnId, Substs)>> {
        let mut found: Option<(FnId, Substs, Table)> = None;
        for i in 0..self.items.impls.len() {
            let item = &self.items.impls[i];
            let Some(path) = &item.trait_ else { continue };
            let (Some(last), Some(&id)) = (path.segments.last(), item.fns.get(method)) else {
                continue;
            };
            let path_names = names(path);
            let def = self.items.find(
                item.module,
                &path_names,
                Ns::Type,
                span,
                &mut HashSet::new(),
            );
            let is_core = matches!(&def, Ok(Some(Def::Extern(full))) if full.starts_with("core::ops::") && full.ends_with(trait_name));
            if !is_core {
                continue;
            }
            let Some((substs, mut table)) = self.impl_matches(i, ty, span) else {
                continue;
            };
            if let Some(rhs) = rhs {
                let written = match &last.arguments {
                    syn::PathArguments::AngleBracketed(a) => a.args.iter().find_map(|a| match a {
                        syn::GenericArgument::Type(t) => Some(t),
                        _ => None,
                    }),
                    _ => None,
                };
                let want = match written {
                    None => ty.clone(),
                    Some(t) => {
                        let scope = Scope {
                            module: item.module,
                            file: item.file,
                            substs: substs.clone(),
                            self_ty: Some(ty.clone()),
                            generic: false,
                        };
                        self.within(scope, |c| c.ty(t))?
                    }
                };
                if table.unify(&want, rhs).is_err() {
                    continue;
                }
            }
            if found.is_some() {
                return Err(err(
                    span,
                    format!(
                        "the operator's `{trait_name}` is ambiguous for `{}`",
                        self.show(ty)
                    ),
                    "annotate the right side's type",
                ));
            }
            found = Some((id, substs, table));
        }
        Ok(found.map(|(id, substs, table)| {
            self.table = table;
            (id, substs)
        }))
    }

    pub(super) fn const_key(&self, member: &Member, self_ty: &Ty) -> ConstKey {
        ConstKey {
            id: member.id,
            substs: member
                .substs
                .iter()
                .map(|(n, t)| (n.clone(), self.zonk(t)))
                .collect(),
            self_ty: Some(self.zonk(self_ty)),
        }
    }
}
