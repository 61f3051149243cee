//! Places: what can be assigned, borrowed, or read in part.

use naga::{Expression, LocalVariable, Statement};

use crate::diag::{R, err};
use crate::hir::{Expr, Kind};
use crate::ty::Ty;

use super::function::Binding;
use super::{FnLowerer, H, SliceVal, Val};

/// A pointer, or a value that no pointer leads to.
#[derive(Clone, Debug)]
pub(crate) enum Place {
    Ptr(H),
    Val(Val),
}

impl FnLowerer<'_, '_> {
    pub(crate) fn place(&mut self, e: &Expr) -> R<Place> {
        let span = e.span;
        Ok(match &e.kind {
            Kind::Local(id) => match self.binding(*id, span)? {
                Binding::Var(ptr) => Place::Ptr(ptr),
                Binding::Value(v) => Place::Val(v),
            },
            Kind::Deref(r) => match self.expr(r)? {
                Val::Ptr(ptr) => Place::Ptr(ptr),
                v => Place::Val(v),
            },
            Kind::Field(base, i) => match self.place(base)? {
                Place::Ptr(ptr) => Place::Ptr(self.emit(Expression::AccessIndex {
                    base: ptr,
                    index: *i as u32,
                })),
                Place::Val(Val::Parts(mut parts)) => Place::Val(parts.swap_remove(*i)),
                Place::Val(Val::Plain(v)) => {
                    Place::Val(Val::Plain(self.emit(Expression::AccessIndex {
                        base: v,
                        index: *i as u32,
                    })))
                }
                Place::Val(v) => Place::Val(v),
            },
            Kind::Component(base, i) => match self.place(base)? {
                Place::Ptr(ptr) => Place::Ptr(self.emit(Expression::AccessIndex {
                    base: ptr,
                    index: *i,
                })),
                Place::Val(Val::Plain(v)) => Place::Val(Val::Plain(
                    self.emit(Expression::AccessIndex { base: v, index: *i }),
                )),
                Place::Val(v) => Place::Val(v),
            },
            Kind::Index(base, index) => self.indexed(base, index)?,
            Kind::Const(key) => match self.body.ty(&e.ty) {
                Ty::Array(..) => {
                    let global = self.l.table(key, span)?;
                    Place::Ptr(self.emit(Expression::GlobalVariable(global)))
                }
                _ => Place::Val(self.expr(e)?),
            },
            _ => Place::Val(self.expr(e)?),
        })
    }

    fn indexed(&mut self, base: &Expr, index: &Expr) -> R<Place> {
        let place = self.place(base)?;
        let fixed = match index.kind {
            Kind::Int(v) => Some(v),
            _ => None,
        };
        if let Place::Val(Val::Slice(s)) = place {
            let i = self.plain(index)?;
            let at = match s.extent {
                Some((start, _)) => self.emit(Expression::Binary {
                    op: naga::BinaryOperator::Add,
                    left: start,
                    right: i,
                }),
                None => i,
            };
            let handle = self.l.globals[s.global].handle;
            let buffer = self.emit(Expression::GlobalVariable(handle));
            return Ok(Place::Ptr(self.emit(Expression::Access {
                base: buffer,
                index: at,
            })));
        }
        let array = matches!(self.body.ty(&base.ty), Ty::Array(..) | Ty::Mat(_));
        let place = match place {
            // A value has no address: where the index is computed, the array is put in a variable first.
            Place::Val(Val::Plain(v)) if array && fixed.is_none() => {
                let ty = self.body.ty(&base.ty);
                let ptr = self.variable("spilled", &ty, base.span)?;
                self.push(Statement::Store {
                    pointer: ptr,
                    value: v,
                });
                Place::Ptr(ptr)
            }
            place => place,
        };
        let (base, is_ptr) = match place {
            Place::Ptr(ptr) => (ptr, true),
            Place::Val(Val::Plain(v)) => (v, false),
            Place::Val(_) => return Ok(Place::Val(Val::Unit)),
        };
        let access = match fixed {
            Some(index) => Expression::AccessIndex { base, index },
            None => {
                let index = self.plain(index)?;
                Expression::Access { base, index }
            }
        };
        let h = self.emit(access);
        Ok(if is_ptr {
            Place::Ptr(h)
        } else {
            Place::Val(Val::Plain(h))
        })
    }

    /// The value at a place.
    pub(crate) fn read(&mut self, place: Place) -> Val {
        match place {
            Place::Ptr(pointer) => Val::Plain(self.emit(Expression::Load { pointer })),
            Place::Val(v) => v,
        }
    }

    /// A new local variable, without a value.
    pub(crate) fn variable(&mut self, name: &str, ty: &Ty, span: crate::diag::Span) -> R<H> {
        let ty = self.l.naga_ty(ty, span)?;
        let var = LocalVariable {
            name: Some(name.to_string()),
            ty,
            init: None,
        };
        let handle = self.func.local_variables.append(var, naga::Span::UNDEFINED);
        Ok(self.emit(Expression::LocalVariable(handle)))
    }

    /// A part of a slice: `&s[lo..hi]`.
    pub(crate) fn sub_slice(
        &mut self,
        base: &Expr,
        lo: Option<&Expr>,
        hi: Option<&Expr>,
    ) -> R<Val> {
        let Val::Slice(s) = self.expr(base)? else {
            return Err(err(
                base.span,
                "this slice is not part of a buffer",
                "take `&[T]` as an argument",
            ));
        };
        let lo = match lo {
            Some(e) => Some(self.plain(e)?),
            None => None,
        };
        let hi = match hi {
            Some(e) => self.plain(e)?,
            None => self.slice_len(&s),
        };
        let zero = |c: &mut Self| c.emit(Expression::Literal(naga::Literal::U32(0)));
        let add = naga::BinaryOperator::Add;
        let (start, len) = match (s.extent, lo) {
            (None, None) => (zero(self), hi),
            (Some((start, _)), None) => (start, hi),
            (outer, Some(lo)) => {
                let start = match outer {
                    Some((start, _)) => self.emit(Expression::Binary {
                        op: add,
                        left: start,
                        right: lo,
                    }),
                    None => lo,
                };
                let op = naga::BinaryOperator::Subtract;
                (
                    start,
                    self.emit(Expression::Binary {
                        op,
                        left: hi,
                        right: lo,
                    }),
                )
            }
        };
        Ok(Val::Slice(SliceVal {
            global: s.global,
            extent: Some((start, len)),
        }))
    }

    pub(crate) fn slice_len(&mut self, s: &SliceVal) -> H {
        match s.extent {
            Some((_, len)) => len,
            None => {
                let handle = self.l.globals[s.global].handle;
                let buffer = self.emit(Expression::GlobalVariable(handle));
                self.emit(Expression::ArrayLength(buffer))
            }
        }
    }
}
