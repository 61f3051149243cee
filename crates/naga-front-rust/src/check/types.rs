//! Types as they are written.

use crate::builtins;
use crate::diag::{R, err};
use crate::hir::Instance;
use crate::items::{Def, Owner};
use crate::konst;
use crate::resolve::Ns;
use crate::ty::{Substs, Ty};

use super::{Checker, Scope};

/// A function's parameter and result types.
pub(crate) struct Signature {
    pub(crate) params: Vec<Ty>,
    pub(crate) ret: Ty,
}

/// The names in a path, without their arguments.
pub(crate) fn names(path: &syn::Path) -> Vec<String> {
    let mut list: Vec<String> = path.segments.iter().map(|s| s.ident.to_string()).collect();
    if path.leading_colon.is_some() {
        list.insert(0, String::new());
    }
    list
}

/// The name that stands for the `i`-th parameter's type, where that is `impl Trait`.
pub(crate) fn impl_trait_name(i: usize) -> String {
    format!("impl#{i}")
}

impl Checker<'_> {
    /// Runs `f` as if the code stood in `scope`.
    pub(super) fn within<T>(&mut self, scope: Scope, f: impl FnOnce(&mut Self) -> R<T>) -> R<T> {
        let outer = std::mem::replace(&mut self.scope, scope);
        let result = f(self);
        self.scope = outer;
        result
    }

    pub(crate) fn ty(&mut self, ty: &syn::Type) -> R<Ty> {
        let span = self.span(ty);
        match ty {
            syn::Type::Paren(t) => self.ty(&t.elem),
            syn::Type::Group(t) => self.ty(&t.elem),
            syn::Type::Infer(_) => Ok(self.table.var()),
            syn::Type::Never(_) => Ok(Ty::Never),
            syn::Type::Tuple(t) if t.elems.is_empty() => Ok(Ty::Unit),
            syn::Type::Tuple(t) => {
                let list = t.elems.iter().map(|t| self.ty(t)).collect::<R<Vec<_>>>()?;
                Ok(Ty::Tuple(list))
            }
            syn::Type::Slice(t) => Ok(Ty::Slice(Box::new(self.ty(&t.elem)?))),
            syn::Type::Array(t) => {
                let elem = self.ty(&t.elem)?;
                let len = self.array_len(&t.len)?;
                Ok(Ty::Array(Box::new(elem), Box::new(len)))
            }
            syn::Type::Reference(r) => {
                let inner = self.ty(&r.elem)?;
                Ok(match inner {
                    // A chunk is a slice that may be written; which it is, its buffer says.
                    Ty::Slice(_) => inner,
                    inner if r.mutability.is_some() => Ty::RefMut(Box::new(inner)),
                    inner => inner,
                })
            }
            syn::Type::Path(p) => self.path_type(p),
            syn::Type::ImplTrait(_) => Err(err(
                span,
                "`impl Trait` stands for a type only as a parameter",
                "return the concrete type",
            )),
            syn::Type::TraitObject(_) => Err(err(
                span,
                "`dyn Trait` cannot be lowered: a GPU has no function pointers",
                "make the function generic over the trait",
            )),
            syn::Type::FnPtr(_) => Err(err(
                span,
                "a function pointer cannot be lowered",
                "make the function generic over a trait",
            )),
            syn::Type::Ptr(_) => Err(err(span, "a raw pointer cannot be lowered", "take a slice")),
            _ => Err(err(
                span,
                "this type cannot be lowered",
                "use the types of the shared subset",
            )),
        }
    }

    pub(super) fn array_len(&mut self, len: &syn::Expr) -> R<Ty> {
        let span = self.span(len);
        match len {
            syn::Expr::Infer(_) => return Ok(self.table.var()),
            // A const parameter may still be open at a call: it is inferred with the rest.
            syn::Expr::Path(p) if p.qself.is_none() => {
                let name = p.path.get_ident();
                let found = self
                    .scope
                    .substs
                    .iter()
                    .find(|(n, _)| name.is_some_and(|i| i == n));
                if let Some((_, ty)) = found {
                    return Ok(ty.clone());
                }
            }
            syn::Expr::Block(b) if b.block.stmts.len() == 1 => {
                if let syn::Stmt::Expr(inner, None) = &b.block.stmts[0] {
                    return self.array_len(inner);
                }
            }
            _ => {}
        }
        let checked = self.expr(len, Some(&Ty::Usize))?;
        match konst::eval_u32(self.items, &self.table, &checked) {
            Some(n) => Ok(Ty::Const(n)),
            None => Err(err(
                span,
                "this length is not a constant that the front end can compute",
                "use literals, consts, const generics and their arithmetic",
            )),
        }
    }

    fn path_type(&mut self, p: &syn::TypePath) -> R<Ty> {
        let span = self.span(p);
        if p.qself.is_some() {
            return Err(err(
                span,
                "associated types are not in the subset",
                "make the type a generic parameter of the function",
            ));
        }
        let path = names(&p.path);
        if let [name] = path.as_slice() {
            if name == "Self" {
                return self
                    .scope
                    .self_ty
                    .clone()
                    .ok_or_else(|| err(span, "`Self` has no meaning here", "name the type"));
            }
            if let Some((_, ty)) = self.scope.substs.iter().find(|(n, _)| n == name) {
                return Ok(ty.clone());
            }
        } else if path.len() == 2
            && (path[0] == "Self" || self.scope.substs.iter().any(|(n, _)| *n == path[0]))
        {
            return Err(err(
                span,
                "associated types are not in the subset",
                "make the type a generic parameter of the function",
            ));
        }
        let args = &p
            .path
            .segments
            .last()
            .expect("a path has a segment")
            .arguments;
        let mut busy = std::collections::HashSet::new();
        let def = self
            .items
            .find(self.scope.module, &path, Ns::Type, span, &mut busy)?;
        match def {
            Some(Def::Struct(id)) => {
                let item = &self.items.structs[id];
                let args = self.generic_args(&item.item.generics, args, span)?;
                Ok(Ty::Struct(id, args.into_iter().map(|(_, t)| t).collect()))
            }
            Some(Def::Enum(id)) => Ok(Ty::Enum(id)),
            Some(Def::Alias(id)) => {
                let alias = &self.items.aliases[id];
                let substs = self.generic_args(&alias.item.generics, args, span)?;
                let scope = Scope {
                    module: alias.module,
                    file: alias.file,
                    substs,
                    self_ty: None,
                    generic: false,
                };
                self.within(scope, |c| c.ty(&alias.item.ty))
            }
            Some(Def::Extern(full)) => self.extern_type(&full, args, span),
            Some(_) => Err(err(
                span,
                format!("`{}` is not a type", path.join("::")),
                "name a type",
            )),
            None if path.len() == 1 => self.extern_type(&format!("core::{}", path[0]), args, span),
            None => Err(err(
                span,
                format!("cannot find the type `{}`", path.join("::")),
                "hand its file to the front end, or import it",
            )),
        }
    }

    fn extern_type(
        &mut self,
        full: &str,
        args: &syn::PathArguments,
        span: crate::diag::Span,
    ) -> R<Ty> {
        let last = full.rsplit("::").next().unwrap_or(full);
        if full.starts_with("glam::") {
            if let Some(ty) = builtins::glam_type(last) {
                return Ok(ty);
            }
            return Err(err(
                span,
                format!("glam's `{last}` is not in the subset"),
                "use Vec2–4, UVec2–4, IVec2–4 or Mat2–4",
            ));
        }
        if let Some(ty) = builtins::primitive(last) {
            return Ok(ty);
        }
        if last == "Option" {
            if let syn::PathArguments::AngleBracketed(a) = args
                && let Some(syn::GenericArgument::Type(t)) = a.args.first()
            {
                return Ok(Ty::Option(Box::new(self.ty(t)?)));
            }
            return Ok(Ty::Option(Box::new(self.table.var())));
        }
        let wide = ["u64", "i64", "u128", "i128", "isize", "f64"].contains(&last);
        let narrow = ["u8", "i8", "u16", "i16", "f16", "char", "str"].contains(&last);
        Err(if wide {
            err(
                span,
                format!("`{last}` is 64 bits wide or may be"),
                "WGSL has 32-bit numbers: use u32, i32, usize or f32",
            )
        } else if narrow {
            err(
                span,
                format!("`{last}` does not exist on a GPU"),
                "use u32, and shifts and masks to unpack",
            )
        } else {
            err(
                span,
                format!("cannot find the type `{last}`"),
                "hand its file to the front end, import it, or use a type of the subset",
            )
        })
    }

    /// Generic parameters by name, from written arguments or fresh variables.
    pub(super) fn generic_args(
        &mut self,
        generics: &syn::Generics,
        args: &syn::PathArguments,
        span: crate::diag::Span,
    ) -> R<Substs> {
        let mut written = match args {
            syn::PathArguments::AngleBracketed(a) => a.args.iter().collect::<Vec<_>>(),
            _ => Vec::new(),
        };
        written.retain(|a| !matches!(a, syn::GenericArgument::Lifetime(_)));
        let mut written = written.into_iter();
        let mut out = Vec::new();
        for param in &generics.params {
            let name = match param {
                syn::GenericParam::Lifetime(_) => continue,
                syn::GenericParam::Type(t) => t.ident.to_string(),
                syn::GenericParam::Const(c) => c.ident.to_string(),
            };
            let ty = match (written.next(), param) {
                (Some(syn::GenericArgument::Type(t)), syn::GenericParam::Const(_)) => {
                    // `Foo<N>` parses `N` as a type.
                    self.ty(t)?
                }
                (Some(syn::GenericArgument::Type(t)), _) => self.ty(t)?,
                (Some(syn::GenericArgument::Const(e)), _) => self.array_len(e)?,
                (Some(_), _) => {
                    return Err(err(
                        span,
                        "this generic argument cannot be lowered",
                        "write types and constants only",
                    ));
                }
                (None, syn::GenericParam::Type(t)) if t.default.is_some() => {
                    return Err(err(
                        span,
                        "the default of a generic parameter cannot be lowered",
                        "write the argument",
                    ));
                }
                (None, _) => self.table.var(),
            };
            out.push((name, ty));
        }
        Ok(out)
    }

    /// Fresh variables for a list of generic parameters.
    pub(super) fn fresh(&mut self, generics: &syn::Generics) -> Substs {
        let mut out = Vec::new();
        for param in &generics.params {
            match param {
                syn::GenericParam::Lifetime(_) => {}
                syn::GenericParam::Type(t) => out.push((t.ident.to_string(), self.table.var())),
                syn::GenericParam::Const(c) => out.push((c.ident.to_string(), self.table.var())),
            }
        }
        out
    }

    /// The types of a function's parameters and result, under an instance's generic arguments.
    pub(crate) fn signature(
        &mut self,
        instance: &Instance,
        span: crate::diag::Span,
    ) -> R<Signature> {
        let f = &self.items.fns[instance.id];
        // The items at the top of the body are not in scope here.
        let scope = Scope {
            module: f.outer,
            ..super::fn_scope(self.items, instance)
        };
        self.within(scope, |c| {
            let mut params = Vec::new();
            for (i, arg) in f.sig.inputs.iter().enumerate() {
                let ty = match arg {
                    syn::FnArg::Receiver(r) => {
                        let this = c.scope.self_ty.clone().ok_or_else(|| {
                            err(
                                span,
                                "`self` has no type here",
                                "call the method on a value",
                            )
                        })?;
                        match &r.kind {
                            syn::ReceiverKind::Value => this,
                            syn::ReceiverKind::Reference(_, _, None) => this,
                            syn::ReceiverKind::Reference(_, _, Some(_)) => {
                                Ty::RefMut(Box::new(this))
                            }
                            _ => {
                                return Err(err(
                                    c.span(r),
                                    "this kind of `self` cannot be lowered",
                                    "write `self`, `&self` or `&mut self`",
                                ));
                            }
                        }
                    }
                    syn::FnArg::Typed(p) => {
                        if let Some((_, is_mut)) = impl_trait(&p.ty) {
                            let name = impl_trait_name(i);
                            let found = c.scope.substs.iter().find(|(n, _)| *n == name);
                            let inner = found.map(|(_, t)| t.clone()).unwrap_or(Ty::Unit);
                            if is_mut {
                                Ty::RefMut(Box::new(inner))
                            } else {
                                inner
                            }
                        } else {
                            c.ty(&p.ty)?
                        }
                    }
                };
                params.push(ty);
            }
            let ret = match &f.sig.output {
                syn::ReturnType::Default => Ty::Unit,
                syn::ReturnType::Type(_, t) => {
                    if let syn::Type::Reference(r) = &**t
                        && r.mutability.is_some()
                    {
                        return Err(err(
                            c.span(t),
                            "a function cannot return `&mut`",
                            "return the value, or its index",
                        ));
                    }
                    c.ty(t)?
                }
            };
            Ok(Signature { params, ret })
        })
    }

    /// The generic arguments with which a function is called: the owner's, its own, and one for each `impl Trait`.
    pub(super) fn instantiate(
        &mut self,
        id: usize,
        mut owner: Substs,
        self_ty: Option<Ty>,
        turbofish: &syn::PathArguments,
        span: crate::diag::Span,
    ) -> R<Instance> {
        let f = &self.items.fns[id];
        if let Owner::Trait(t) = f.owner
            && self.items.traits[t]
                .generics
                .params
                .iter()
                .any(|p| !matches!(p, syn::GenericParam::Lifetime(_)))
        {
            return Err(err(
                span,
                format!("the trait `{}` is generic", self.items.traits[t].name),
                "make its methods generic instead",
            ));
        }
        owner.extend(self.generic_args(&f.sig.generics, turbofish, span)?);
        for (i, arg) in f.sig.inputs.iter().enumerate() {
            if let syn::FnArg::Typed(p) = arg
                && impl_trait(&p.ty).is_some()
            {
                owner.push((impl_trait_name(i), self.table.var()));
            }
        }
        Ok(Instance {
            id,
            substs: owner,
            self_ty,
        })
    }
}

/// `impl Trait`, `&impl Trait` or `&mut impl Trait`, and whether it is the last.
fn impl_trait(ty: &syn::Type) -> Option<(&syn::TypeImplTrait, bool)> {
    match ty {
        syn::Type::ImplTrait(t) => Some((t, false)),
        syn::Type::Reference(r) => match &*r.elem {
            syn::Type::ImplTrait(t) => Some((t, r.mutability.is_some())),
            syn::Type::Paren(p) => match &*p.elem {
                syn::Type::ImplTrait(t) => Some((t, r.mutability.is_some())),
                _ => None,
            },
            _ => None,
        },
        _ => None,
    }
}
