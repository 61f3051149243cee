//! Operators.

use crate::diag::{R, Span, err};
use crate::hir::{BinOp, Builtin, Expr, Instance, Kind, Lit, UnOp};
use crate::ty::{Scalar, Substs, Ty};

use super::Checker;

/// The operator, and whether it assigns.
fn operator(op: &syn::BinOp) -> Option<(BinOp, bool)> {
    use syn::BinOp as S;
    Some(match op {
        S::Add(_) => (BinOp::Add, false),
        S::Sub(_) => (BinOp::Sub, false),
        S::Mul(_) => (BinOp::Mul, false),
        S::Div(_) => (BinOp::Div, false),
        S::Rem(_) => (BinOp::Rem, false),
        S::BitXor(_) => (BinOp::Xor, false),
        S::BitAnd(_) => (BinOp::And, false),
        S::BitOr(_) => (BinOp::Or, false),
        S::Shl(_) => (BinOp::Shl, false),
        S::Shr(_) => (BinOp::Shr, false),
        S::Eq(_) => (BinOp::Eq, false),
        S::Ne(_) => (BinOp::Ne, false),
        S::Lt(_) => (BinOp::Lt, false),
        S::Le(_) => (BinOp::Le, false),
        S::Gt(_) => (BinOp::Gt, false),
        S::Ge(_) => (BinOp::Ge, false),
        S::AddAssign(_) => (BinOp::Add, true),
        S::SubAssign(_) => (BinOp::Sub, true),
        S::MulAssign(_) => (BinOp::Mul, true),
        S::DivAssign(_) => (BinOp::Div, true),
        S::RemAssign(_) => (BinOp::Rem, true),
        S::BitXorAssign(_) => (BinOp::Xor, true),
        S::BitAndAssign(_) => (BinOp::And, true),
        S::BitOrAssign(_) => (BinOp::Or, true),
        S::ShlAssign(_) => (BinOp::Shl, true),
        S::ShrAssign(_) => (BinOp::Shr, true),
        _ => return None,
    })
}

fn trait_of(op: BinOp) -> Option<(&'static str, &'static str)> {
    Some(match op {
        BinOp::Add => ("Add", "add"),
        BinOp::Sub => ("Sub", "sub"),
        BinOp::Mul => ("Mul", "mul"),
        BinOp::Div => ("Div", "div"),
        BinOp::Rem => ("Rem", "rem"),
        BinOp::And => ("BitAnd", "bitand"),
        BinOp::Or => ("BitOr", "bitor"),
        BinOp::Xor => ("BitXor", "bitxor"),
        BinOp::Shl => ("Shl", "shl"),
        BinOp::Shr => ("Shr", "shr"),
        _ => return None,
    })
}

impl Checker<'_> {
    pub(super) fn binary(&mut self, b: &syn::ExprBinary) -> R<Expr> {
        let span = self.span(b);
        let short = |kind: fn(Box<Expr>, Box<Expr>) -> Kind, c: &mut Self| {
            let l = c.expr(&b.left, Some(&Ty::Bool))?;
            let l = c.coerce(l, &Ty::Bool)?;
            let r = c.expr(&b.right, Some(&Ty::Bool))?;
            let r = c.coerce(r, &Ty::Bool)?;
            Ok(Expr {
                kind: kind(Box::new(l), Box::new(r)),
                ty: Ty::Bool,
                span,
            })
        };
        match b.op {
            syn::BinOp::And(_) => return short(Kind::AndAnd, self),
            syn::BinOp::Or(_) => return short(Kind::OrOr, self),
            _ => {}
        }
        let Some((op, assigns)) = operator(&b.op) else {
            return Err(err(span, "this operator cannot be lowered", "write it out"));
        };
        if assigns {
            return self.assign_op(b, op, span);
        }
        let left = self.expr(&b.left, None)?;
        let left = self.value(left);
        let right = self.expr(&b.right, None)?;
        let right = self.value(right);
        if matches!(op, BinOp::Eq | BinOp::Ne)
            && self.zonk(&left.ty) == Ty::F32
            && same_place(&left, &right)
        {
            return Err(err(
                span,
                "comparing a float with itself asks whether it is NaN",
                "a GPU may assume there is no NaN: guard the operation's input by comparison",
            ));
        }
        let kind = Kind::Binary;
        if let Some(ty) = self.op_type(op, &left.ty.clone(), &right.ty.clone(), span)? {
            return Ok(Expr {
                kind: kind(op, Box::new(left), Box::new(right)),
                ty,
                span,
            });
        }
        let Some((instance, ty)) =
            self.op_impl(op, "", &left.ty.clone(), &right.ty.clone(), span)?
        else {
            return Err(self.no_operator(op, &left.ty, &right.ty, span));
        };
        Ok(Expr {
            kind: Kind::Call(instance, vec![left, right]),
            ty,
            span,
        })
    }

    fn assign_op(&mut self, b: &syn::ExprBinary, op: BinOp, span: Span) -> R<Expr> {
        let place = self.expr(&b.left, None)?;
        let place = self.value(place);
        let right = self.expr(&b.right, None)?;
        let right = self.value(right);
        let (l, r) = (place.ty.clone(), right.ty.clone());
        if let Some(ty) = self.op_type(op, &l, &r, span)? {
            let by_reference =
                matches!(&*b.right, syn::Expr::Reference(_)) || self.may_be_reference(&right);
            let overloaded = self.scope.generic || by_reference;
            if overloaded && !place.is_quiet() && !right.is_quiet() {
                return Err(err(
                    span,
                    "which side is computed first depends on whether the operator is overloaded here",
                    "bind the right side with `let` first",
                ));
            }
            self.unify(&ty, &l, span)?;
            let kind = Kind::AssignOp(op, Box::new(place), Box::new(right));
            return Ok(Expr {
                kind,
                ty: Ty::Unit,
                span,
            });
        }
        // `a += b` on one's own type: `AddAssign` alone is what Rust calls.
        let Some((instance, _)) = self.op_impl(op, "Assign", &l, &r, span)? else {
            return Err(self.no_operator(op, &l, &r, span));
        };
        let this = Expr {
            ty: Ty::RefMut(Box::new(l)),
            span,
            kind: Kind::RefMut(Box::new(place)),
        };
        Ok(Expr {
            kind: Kind::Call(instance, vec![this, right]),
            ty: Ty::Unit,
            span,
        })
    }

    /// Whether rustc may see a reference where the front end, which knows none, sees its value.
    fn may_be_reference(&self, e: &Expr) -> bool {
        match &e.kind {
            Kind::Call(instance, _) => {
                let output = &self.items.fns[instance.id].sig.output;
                !matches!(output, syn::ReturnType::Type(_, t) if !matches!(**t, syn::Type::Reference(_)))
            }
            Kind::Binary(..) | Kind::Unary(..) | Kind::Cast(_) | Kind::Builtin(..) => false,
            _ => true,
        }
    }

    fn no_operator(&self, op: BinOp, l: &Ty, r: &Ty, span: Span) -> Box<crate::diag::Error> {
        let open = matches!(self.zonk(l), Ty::Var(_)) || matches!(self.zonk(r), Ty::Var(_));
        if open {
            return err(
                span,
                "the type of an operand is not known here",
                "annotate it",
            );
        }
        let help = match op {
            BinOp::Eq | BinOp::Ne | BinOp::Lt | BinOp::Le | BinOp::Gt | BinOp::Ge => {
                "compare numbers, bools and fieldless enums; write out the others"
            }
            _ => "use numbers, glam vectors and matrices, or implement the operator's trait",
        };
        err(
            span,
            format!(
                "`{}` is not known for `{}` and `{}`",
                op.symbol(),
                self.show(l),
                self.show(r)
            ),
            help,
        )
    }

    /// The result type of a built-in operator; `None` where the types need an impl.
    fn op_type(&mut self, op: BinOp, l: &Ty, r: &Ty, span: Span) -> R<Option<Ty>> {
        use BinOp as O;
        let (l, r) = (self.zonk(l), self.zonk(r));
        let compares = matches!(op, O::Eq | O::Ne | O::Lt | O::Le | O::Gt | O::Ge);
        let bits = matches!(op, O::And | O::Or | O::Xor);
        let shifts = matches!(op, O::Shl | O::Shr);
        if (matches!(l, Ty::Never)) || matches!(r, Ty::Never) {
            return Ok(Some(Ty::Never));
        }
        if shifts {
            let distance = r.is_int()
                || matches!((&l, &r), (Ty::Vec(_, n), Ty::Vec(s, m)) if n == m && *s != Scalar::F32);
            let shifted = l.is_int() || matches!(l, Ty::Vec(s, _) if s != Scalar::F32);
            return Ok((shifted && distance).then_some(l));
        }
        // Enums and bools.
        if compares {
            if let Ty::Enum(id) = l
                && !self.compares_numbers(id, span)
            {
                return Err(err(
                    span,
                    format!("`==` on `{}` is not the derived one", self.show(&l)),
                    "derive PartialEq, or call a function that compares",
                ));
            }
            let scalar = |t: &Ty| t.is_number() || matches!(t, Ty::Bool | Ty::Enum(_));
            if scalar(&l) || scalar(&r) {
                self.unify(&r, &l, span)?;
                let ok =
                    matches!(op, O::Eq | O::Ne) || !matches!(self.zonk(&l), Ty::Bool | Ty::Enum(_));
                return Ok(ok.then_some(Ty::Bool));
            }
            return Ok(None);
        }
        if l == Ty::Bool || r == Ty::Bool {
            self.unify(&l, &r, span)?;
            return Ok(bits.then_some(Ty::Bool));
        }
        match (&l, &r) {
            (Ty::Vec(s, n), Ty::Vec(t, m)) if s == t && n == m => {
                Ok((!bits || *s != Scalar::F32).then(|| l.clone()))
            }
            (Ty::Vec(s, _), other) if other.is_number() => {
                self.unify(other, &Ty::of_scalar(*s), span)?;
                Ok((!bits || *s != Scalar::F32).then(|| l.clone()))
            }
            (other, Ty::Vec(s, _)) if other.is_number() => {
                self.unify(other, &Ty::of_scalar(*s), span)?;
                Ok((!bits).then(|| r.clone()))
            }
            (Ty::Mat(n), Ty::Mat(m)) if n == m => {
                Ok(matches!(op, O::Add | O::Sub | O::Mul).then(|| l.clone()))
            }
            (Ty::Mat(n), Ty::Vec(Scalar::F32, m)) if n == m => {
                Ok((op == O::Mul).then(|| r.clone()))
            }
            (Ty::Mat(_), Ty::F32 | Ty::FloatVar(_)) => {
                self.unify(&r, &Ty::F32, span)?;
                Ok((op == O::Mul).then(|| l.clone()))
            }
            (Ty::F32 | Ty::FloatVar(_), Ty::Mat(_)) => {
                self.unify(&l, &Ty::F32, span)?;
                Ok((op == O::Mul).then(|| r.clone()))
            }
            _ if l.is_number() && r.is_number() => {
                self.unify(&r, &l, span)?;
                let ty = self.zonk(&l);
                Ok((!bits || ty.is_int()).then_some(ty))
            }
            (Ty::Var(_), t) | (t, Ty::Var(_)) if t.is_number() => {
                self.unify(&l, &r, span)?;
                Ok(Some(self.zonk(&l)))
            }
            _ => Ok(None),
        }
    }

    fn op_impl(
        &mut self,
        op: BinOp,
        suffix: &str,
        l: &Ty,
        r: &Ty,
        span: Span,
    ) -> R<Option<(Instance, Ty)>> {
        let Some((trait_name, method)) = trait_of(op) else {
            return Ok(None);
        };
        let (trait_name, method) = match suffix {
            "" => (trait_name.to_string(), method.to_string()),
            _ => (
                format!("{trait_name}{suffix}"),
                format!("{method}_{}", suffix.to_lowercase()),
            ),
        };
        let found = self.operator(l, &trait_name, &method, Some(r), span)?;
        self.op_call(found, l, span)
    }

    fn op_call(
        &mut self,
        found: Option<(usize, Substs)>,
        this: &Ty,
        span: Span,
    ) -> R<Option<(Instance, Ty)>> {
        let Some((id, substs)) = found else {
            return Ok(None);
        };
        let instance = self.instantiate(
            id,
            substs,
            Some(self.zonk(this)),
            &syn::PathArguments::None,
            span,
        )?;
        let ret = self.op_ret(&instance, span)?;
        Ok(Some((instance, ret)))
    }

    /// An operator's result: its written type, where `Self::Output` is what the impl says it is.
    fn op_ret(&mut self, instance: &Instance, span: Span) -> R<Ty> {
        let f = &self.items.fns[instance.id];
        if let syn::ReturnType::Type(_, t) = &f.sig.output
            && let syn::Type::Path(p) = &**t
            && p.path.segments.len() == 2
            && p.path.segments[1].ident == "Output"
        {
            return Err(err(
                Span::of(f.file, t),
                "associated types are not in the subset",
                "write the operator's result type instead of `Self::Output`",
            ));
        }
        Ok(self.signature(instance, span)?.ret)
    }

    pub(super) fn unary(&mut self, u: &syn::ExprUnary, expect: Option<&Ty>) -> R<Expr> {
        let span = self.span(u);
        match u.op {
            syn::UnOp::Deref(_) => {
                let inner = self.expr(&u.expr, None)?;
                let ty = self.zonk(&inner.ty);
                if matches!(ty, Ty::Struct(..) | Ty::Enum(_)) && self.has_impl(&ty, "Deref", span) {
                    return Err(err(
                        span,
                        "a `Deref` of one's own cannot be lowered",
                        "call a function that gives the part",
                    ));
                }
                Ok(self.value(inner))
            }
            syn::UnOp::Neg(_) => {
                // A negative literal is one value: `-2147483648` has no positive twin.
                if let syn::Expr::Lit(syn::ExprLit {
                    lit: syn::Lit::Float(_),
                    ..
                }) = &*u.expr
                {
                    let e = self.expr(&u.expr, expect)?;
                    if let Kind::Lit(Lit::F32(v)) = e.kind {
                        return Ok(Expr {
                            kind: Kind::Lit(Lit::F32(-v)),
                            ty: e.ty,
                            span,
                        });
                    }
                }
                let e = self.expr(&u.expr, expect)?;
                self.unary_op(UnOp::Neg, e, span)
            }
            syn::UnOp::Not(_) => {
                let e = self.expr(&u.expr, expect)?;
                self.unary_op(UnOp::Not, e, span)
            }
            _ => Err(err(span, "this operator cannot be lowered", "write it out")),
        }
    }

    fn unary_op(&mut self, op: UnOp, e: Expr, span: Span) -> R<Expr> {
        let e = self.value(e);
        let ty = self.zonk(&e.ty);
        let ok = match (&ty, op) {
            (Ty::F32 | Ty::FloatVar(_) | Ty::I32 | Ty::IntVar(_), UnOp::Neg) => true,
            (Ty::Vec(s, _), UnOp::Neg) => *s != Scalar::U32,
            (Ty::Mat(_), UnOp::Neg) => false,
            (Ty::Bool | Ty::I32 | Ty::U32 | Ty::IntVar(_), UnOp::Not) => true,
            (Ty::Vec(s, _), UnOp::Not) => *s != Scalar::F32,
            _ => false,
        };
        if ok {
            return Ok(Expr {
                kind: Kind::Unary(op, Box::new(e)),
                ty,
                span,
            });
        }
        let (name, method) = if op == UnOp::Neg {
            ("Neg", "neg")
        } else {
            ("Not", "not")
        };
        let found = self.operator(&ty, name, method, None, span)?;
        match self.op_call(found, &ty, span)? {
            Some((instance, ty)) => Ok(Expr {
                kind: Kind::Call(instance, vec![e]),
                ty,
                span,
            }),
            None => Err(err(
                span,
                format!("`{name}` is not known for `{}`", self.show(&ty)),
                "negate i32, f32 and vectors of them; `!` is for bool, i32, u32 and vectors of them",
            )),
        }
    }

    pub(super) fn cast(&mut self, c: &syn::ExprCast) -> R<Expr> {
        let span = self.span(c);
        let target = self.ty(&c.ty)?;
        let e = self.expr(&c.expr, None)?;
        let e = self.value(e);
        if let (Ty::FloatVar(_), Ty::F32, Kind::Lit(_)) = (self.zonk(&e.ty), &target, &e.kind) {
            self.unify(&e.ty.clone(), &target, span)?;
        }
        // `1 as u32` is a u32, as in Rust; a variable whose type is open stays so, and may become i32.
        if let (Ty::IntVar(_), true, true) = (self.zonk(&e.ty), target.is_int(), is_literal(&e)) {
            self.unify(&e.ty.clone(), &target, span)?;
        }
        let from = self.zonk(&e.ty);
        let ok = match (&from, &target) {
            (f, t) if f.is_number() && t.is_number() => true,
            (Ty::Bool | Ty::Enum(_), t) => t.is_int(),
            _ => false,
        };
        if !ok {
            return Err(err(
                span,
                format!(
                    "`{}` cannot be cast to `{}`",
                    self.show(&from),
                    self.show(&target)
                ),
                "cast numbers, bools and fieldless enums; for vectors there are `as_vec3()` and its kin",
            ));
        }
        Ok(Expr {
            kind: Kind::Cast(Box::new(e)),
            ty: target,
            span,
        })
    }

    pub(super) fn builtin(&self, op: Builtin, args: Vec<Expr>, ty: Ty, span: Span) -> Expr {
        Expr {
            kind: Kind::Builtin(op, args),
            ty,
            span,
        }
    }
}

fn is_literal(e: &Expr) -> bool {
    match &e.kind {
        Kind::Int(_) => true,
        Kind::Unary(_, inner) => is_literal(inner),
        _ => false,
    }
}

fn same_place(a: &Expr, b: &Expr) -> bool {
    match (&a.kind, &b.kind) {
        (Kind::Local(a), Kind::Local(b)) => a == b,
        (Kind::Field(a, i), Kind::Field(b, j)) => i == j && same_place(a, b),
        (Kind::Component(a, i), Kind::Component(b, j)) => i == j && same_place(a, b),
        (Kind::Deref(a), Kind::Deref(b)) => same_place(a, b),
        _ => false,
    }
}
