//! Expressions that are not control flow.

use naga::{BinaryOperator as NBin, Expression, Literal, ScalarKind, Statement, UnaryOperator};

use crate::diag::{R, Span, err};
use crate::hir::{BinOp, Expr, Instance, Kind, Lit, UnOp};
use crate::konst;
use crate::ty::{Scalar, Ty};

use super::place::Place;
use super::{FnLowerer, H, Shape, Val};

/// A literal of the type that it has.
pub(crate) fn literal(lit: Lit) -> Literal {
    match lit {
        Lit::F32(v) => Literal::F32(v),
        Lit::I32(v) => Literal::I32(v),
        Lit::U32(v) => Literal::U32(v),
        Lit::Bool(v) => Literal::Bool(v),
    }
}

impl FnLowerer<'_, '_> {
    /// The one value of a plain expression.
    pub(crate) fn plain(&mut self, e: &Expr) -> R<H> {
        match self.expr(e)? {
            Val::Plain(h) => Ok(h),
            // The value of what never ends: anything of the type will do.
            Val::Unit => {
                let ty = self.body.ty(&e.ty);
                let ty = if ty == Ty::Never { Ty::U32 } else { ty };
                let ty = self.l.naga_ty(&ty, e.span)?;
                Ok(self.emit(Expression::ZeroValue(ty)))
            }
            Val::Slice(_) | Val::Parts(_) => Err(err(
                e.span,
                "a slice cannot be part of this value",
                "slices live in views: structs that are passed on, never stored, chosen or put in arrays",
            )),
            Val::Ptr(_) => Err(err(
                e.span,
                "`&mut` cannot be part of a value",
                "pass it as an argument of its own",
            )),
        }
    }

    pub(crate) fn lit(&mut self, lit: Lit) -> H {
        self.emit(Expression::Literal(literal(lit)))
    }

    pub(crate) fn bin(&mut self, op: NBin, left: H, right: H) -> H {
        self.emit(Expression::Binary { op, left, right })
    }

    pub(crate) fn expr(&mut self, e: &Expr) -> R<Val> {
        let span = e.span;
        let plain = |h: H| Ok(Val::Plain(h));
        match &e.kind {
            Kind::Lit(lit) => plain(self.lit(*lit)),
            Kind::Int(v) => match self.body.ty(&e.ty) {
                Ty::I32 => {
                    let v = i32::try_from(*v)
                        .map_err(|_| err(span, "this literal does not fit i32", "use u32"))?;
                    plain(self.lit(Lit::I32(v)))
                }
                _ => plain(self.lit(Lit::U32(*v))),
            },
            Kind::Unit => Ok(Val::Unit),
            Kind::Local(_)
            | Kind::Field(..)
            | Kind::Component(..)
            | Kind::Index(..)
            | Kind::Deref(_) => {
                let place = self.place(e)?;
                Ok(self.read(place))
            }
            Kind::Const(key) => {
                let body = self.l.const_body(key)?;
                if let Some(lit) = konst::eval_body(self.l.items, &body) {
                    if matches!(lit, Lit::F32(v) if !v.is_finite()) {
                        return Err(not_finite(span));
                    }
                    return plain(self.lit(lit));
                }
                if let Ty::Array(..) = body.ty(&body.ret) {
                    let place = self.place(e)?;
                    return Ok(self.read(place));
                }
                // Lowered where it stands, as if it were written there.
                let locals = vec![None; body.locals.len()];
                let outer = (
                    std::mem::replace(&mut self.body, body.clone()),
                    std::mem::replace(&mut self.locals, locals),
                );
                let value = self.expr(&body.value);
                (self.body, self.locals) = outer;
                value
            }
            Kind::SubSlice(base, lo, hi) => self.sub_slice(base, lo.as_deref(), hi.as_deref()),
            Kind::Len(base) => match self.expr(base)? {
                Val::Slice(s) => plain(self.slice_len(&s)),
                _ => Err(err(
                    span,
                    "this slice is not part of a buffer",
                    "take `&[T]` as an argument",
                )),
            },
            Kind::RefMut(_) => Err(err(
                span,
                "`&mut` stands here outside a call",
                "pass `&mut place` to a function; it cannot be stored",
            )),
            Kind::Struct(fields, base) => self.struct_value(e, fields, base.as_deref()),
            Kind::Tuple(list) => {
                let values = list.iter().map(|e| self.expr(e)).collect::<R<Vec<_>>>()?;
                self.assemble(&self.body.ty(&e.ty), values, span)
            }
            Kind::Array(list) => {
                let components = list.iter().map(|e| self.plain(e)).collect::<R<Vec<_>>>()?;
                let ty = self.l.naga_ty(&self.body.ty(&e.ty), span)?;
                plain(self.emit(Expression::Compose { ty, components }))
            }
            Kind::Repeat(inner, n) => {
                let value = self.plain(inner)?;
                let ty = self.l.naga_ty(&self.body.ty(&e.ty), span)?;
                plain(self.emit(Expression::Compose {
                    ty,
                    components: vec![value; *n as usize],
                }))
            }
            Kind::Some(inner) => {
                let value = self.plain(inner)?;
                let ty = self.l.naga_ty(&self.body.ty(&e.ty), span)?;
                let yes = self.lit(Lit::Bool(true));
                plain(self.emit(Expression::Compose {
                    ty,
                    components: vec![yes, value],
                }))
            }
            Kind::None => {
                let ty = self.l.naga_ty(&self.body.ty(&e.ty), span)?;
                plain(self.emit(Expression::ZeroValue(ty)))
            }
            Kind::Unary(op, inner) => {
                if *op == UnOp::Not && self.body.ty(&e.ty) == Ty::Usize {
                    return Err(err(
                        span,
                        "`!` on usize sets more bits on a host than on a GPU",
                        "use u32",
                    ));
                }
                if let Some(lit) = konst::eval(self.l.items, &self.body.table, e) {
                    let lit = match (lit, self.body.ty(&e.ty)) {
                        (Lit::U32(v), Ty::I32) => Lit::I32(v as i32),
                        (lit, _) => lit,
                    };
                    return plain(self.lit(lit));
                }
                let v = self.plain(inner)?;
                let op = match (op, self.body.ty(&inner.ty)) {
                    (UnOp::Neg, _) => UnaryOperator::Negate,
                    (UnOp::Not, Ty::Bool) => UnaryOperator::LogicalNot,
                    (UnOp::Not, _) => UnaryOperator::BitwiseNot,
                };
                plain(self.emit(Expression::Unary { op, expr: v }))
            }
            Kind::Binary(op, l, r) => {
                self.check_constants(*op, e, l, r)?;
                // WGSL refuses a constant shift that drops bits; Rust drops them.
                if matches!(op, BinOp::Shl | BinOp::Shr)
                    && let Some(lit) = konst::eval(self.l.items, &self.body.table, e)
                {
                    return plain(self.lit(lit));
                }
                let left = self.plain(l)?;
                let right = self.plain(r)?;
                let (lt, rt) = (self.body.ty(&l.ty), self.body.ty(&r.ty));
                plain(self.binary(*op, left, &lt, right, &rt)?)
            }
            Kind::AndAnd(l, r) => self.short(l, r, true),
            Kind::OrOr(l, r) => self.short(l, r, false),
            Kind::Cast(inner) => {
                let v = self.plain(inner)?;
                let (from, to) = (self.body.ty(&inner.ty), self.body.ty(&e.ty));
                plain(self.cast(v, &from, &to))
            }
            Kind::Builtin(op, args) => self.builtin(*op, args, e),
            Kind::Call(instance, args) => self.call(instance, args, span),
            _ => self.control(e),
        }
    }

    /// Refuses constants that WGSL has not: infinite ones, and what leaves 32 bits.
    fn check_constants(&self, op: BinOp, e: &Expr, left: &Expr, right: &Expr) -> R<()> {
        let value = |e: &Expr| konst::eval(self.l.items, &self.body.table, e);
        let (left, right, whole) = (value(left), value(right), value(e));
        let ty = self.body.ty(&e.ty);
        let shifts = matches!(op, BinOp::Shl | BinOp::Shr);
        // What does not fold although both sides do leaves 32 bits. A shift of u32 or i32 drops them, as in Rust.
        let lost = ty.is_int() && whole.is_none() && left.is_some() && right.is_some();
        let far = matches!(right, Some(Lit::U32(32..) | Lit::I32(..0 | 32..)));
        if ty == Ty::Usize && shifts && (far || lost) {
            return Err(err(
                e.span,
                "this shift leaves 32 bits, which are a GPU's usize",
                "use u32",
            ));
        }
        if lost && !shifts {
            return Err(err(
                e.span,
                "this constant does not fit 32 bits",
                "use wrapping operations on u32",
            ));
        }
        let by_zero = op == BinOp::Div && right == Some(Lit::F32(0.0));
        if by_zero || matches!(whole, Some(Lit::F32(v)) if !v.is_finite()) {
            return Err(not_finite(e.span));
        }
        Ok(())
    }

    pub(crate) fn cast(&mut self, v: H, from: &Ty, to: &Ty) -> H {
        let scalar = |t: &Ty| match t {
            Ty::Enum(_) => Some(Scalar::U32),
            t => t.scalar(),
        };
        if scalar(from) == scalar(to) && *from != Ty::Bool {
            return v;
        }
        let kind = match to.scalar() {
            Some(Scalar::F32) => ScalarKind::Float,
            Some(Scalar::I32) => ScalarKind::Sint,
            _ => ScalarKind::Uint,
        };
        self.emit(Expression::As {
            expr: v,
            kind,
            convert: Some(4),
        })
    }

    /// A built-in binary operator on lowered operands.
    pub(crate) fn binary(&mut self, op: BinOp, left: H, lt: &Ty, right: H, rt: &Ty) -> R<H> {
        use BinOp as O;
        let (mut left, mut right) = (left, right);
        let op = match op {
            O::Add => NBin::Add,
            O::Sub => NBin::Subtract,
            O::Mul => NBin::Multiply,
            O::Div => NBin::Divide,
            O::Rem => NBin::Modulo,
            O::And => NBin::And,
            O::Or => NBin::InclusiveOr,
            O::Xor => NBin::ExclusiveOr,
            O::Shl => NBin::ShiftLeft,
            O::Shr => NBin::ShiftRight,
            O::Eq => NBin::Equal,
            O::Ne => NBin::NotEqual,
            O::Lt => NBin::Less,
            O::Le => NBin::LessEqual,
            O::Gt => NBin::Greater,
            O::Ge => NBin::GreaterEqual,
        };
        let splat = |c: &mut Self, value: H, like: &Ty| match like {
            Ty::Vec(_, n) => c.emit(Expression::Splat {
                size: super::types::vector_size(*n),
                value,
            }),
            _ => value,
        };
        if matches!(op, NBin::ShiftLeft | NBin::ShiftRight) {
            // Rust masks the distance in release builds; some back ends leave a distance of 32 or more undefined.
            let literal = match self.func.expressions[right] {
                Expression::Literal(Literal::U32(v)) => Some(v),
                Expression::Literal(Literal::I32(v)) => Some(v as u32),
                _ => None,
            };
            right = match literal {
                Some(v) => self.lit(Lit::U32(v & 31)),
                None => {
                    let unsigned = match rt {
                        Ty::Vec(_, n) => Ty::Vec(Scalar::U32, *n),
                        _ => Ty::U32,
                    };
                    let distance = self.cast(right, rt, &unsigned);
                    let mask = self.lit(Lit::U32(31));
                    let mask = splat(self, mask, rt);
                    self.bin(NBin::And, distance, mask)
                }
            };
            if !matches!(rt, Ty::Vec(..)) {
                right = splat(self, right, lt);
            }
            return Ok(self.bin(op, left, right));
        }
        if op == NBin::ExclusiveOr && *lt == Ty::Bool {
            return Ok(self.bin(NBin::NotEqual, left, right));
        }
        // naga mixes vectors and scalars in float products alone.
        let mixes = op == NBin::Multiply
            && lt.scalar() != Some(Scalar::I32)
            && lt.scalar() != Some(Scalar::U32);
        if !mixes {
            match (lt, rt) {
                (Ty::Vec(..), t) if t.is_number() => right = splat(self, right, lt),
                (t, Ty::Vec(..)) if t.is_number() => left = splat(self, left, rt),
                _ => {}
            }
        }
        Ok(self.bin(op, left, right))
    }

    /// `&&` and `||`: the right side is computed only where Rust computes it, if it does anything.
    fn short(&mut self, l: &Expr, r: &Expr, and: bool) -> R<Val> {
        let left = self.plain(l)?;
        if r.is_pure() {
            let right = self.plain(r)?;
            let op = if and {
                NBin::LogicalAnd
            } else {
                NBin::LogicalOr
            };
            return Ok(Val::Plain(self.bin(op, left, right)));
        }
        let result = self.variable(if and { "both" } else { "either" }, &Ty::Bool, l.span)?;
        self.push(Statement::Store {
            pointer: result,
            value: left,
        });
        let (block, _, ()) = self.block_of(|c| {
            let right = c.plain(r)?;
            c.push(Statement::Store {
                pointer: result,
                value: right,
            });
            Ok(())
        })?;
        let (accept, reject) = if and {
            (block, naga::Block::new())
        } else {
            (naga::Block::new(), block)
        };
        self.push(Statement::If {
            condition: left,
            accept,
            reject,
        });
        Ok(self.read(Place::Ptr(result)))
    }

    /// A struct or tuple from its fields' values.
    pub(crate) fn assemble(&mut self, ty: &Ty, values: Vec<Val>, span: Span) -> R<Val> {
        if self.l.holds_slices(ty, span)? {
            return Ok(Val::Parts(values));
        }
        let naga_ty = self.l.naga_ty(ty, span)?;
        if values.is_empty() {
            return Ok(Val::Plain(self.emit(Expression::ZeroValue(naga_ty))));
        }
        let types = self.l.field_types(ty, span)?;
        let mut components = Vec::new();
        for (value, field) in values.into_iter().zip(types) {
            components.push(match value {
                Val::Plain(h) => h,
                _ => {
                    let ty = self.l.naga_ty(&field, span)?;
                    self.emit(Expression::ZeroValue(ty))
                }
            });
        }
        Ok(Val::Plain(self.emit(Expression::Compose {
            ty: naga_ty,
            components,
        })))
    }

    fn struct_value(&mut self, e: &Expr, fields: &[(usize, Expr)], base: Option<&Expr>) -> R<Val> {
        let ty = self.body.ty(&e.ty);
        let n = self.l.field_types(&ty, e.span)?.len();
        let mut values: Vec<Option<Val>> = vec![None; n];
        for (index, field) in fields {
            values[*index] = Some(self.expr(field)?);
        }
        if let Some(base) = base {
            let place = self.place(base)?;
            for (i, value) in values.iter_mut().enumerate().filter(|(_, v)| v.is_none()) {
                let part = match &place {
                    Place::Ptr(ptr) => {
                        let ptr = self.emit(Expression::AccessIndex {
                            base: *ptr,
                            index: i as u32,
                        });
                        self.read(Place::Ptr(ptr))
                    }
                    Place::Val(Val::Parts(parts)) => parts[i].clone(),
                    Place::Val(Val::Plain(v)) => Val::Plain(self.emit(Expression::AccessIndex {
                        base: *v,
                        index: i as u32,
                    })),
                    Place::Val(v) => v.clone(),
                };
                *value = Some(part);
            }
        }
        let values = values.into_iter().map(|v| v.unwrap_or(Val::Unit)).collect();
        self.assemble(&ty, values, e.span)
    }

    fn call(&mut self, instance: &Instance, args: &[Expr], span: Span) -> R<Val> {
        let zonked = Instance {
            id: instance.id,
            substs: instance
                .substs
                .iter()
                .map(|(n, t)| (n.clone(), self.body.ty(t)))
                .collect(),
            self_ty: instance.self_ty.as_ref().map(|t| self.body.ty(t)),
        };
        if let Some((name, _)) = zonked.substs.iter().find(|(_, t)| t.is_open()) {
            return Err(err(
                span,
                format!("the generic argument `{name}` is not known here"),
                "write it: `function::<Type>(…)`",
            ));
        }
        let mut values = Vec::new();
        // `&mut` of a part of a variable: a copy is handed over, and written back after the call.
        let mut write_back: Vec<(H, H)> = Vec::new();
        for arg in args {
            let value = match &arg.kind {
                Kind::RefMut(inner) => {
                    inner.no_const()?;
                    let ty = self.body.ty(&inner.ty);
                    match self.place(inner)? {
                        Place::Ptr(ptr) if self.is_whole(ptr) => Val::Ptr(ptr),
                        Place::Ptr(ptr) => {
                            let copy = self.variable("borrowed", &ty, arg.span)?;
                            let value = self.emit(Expression::Load { pointer: ptr });
                            self.push(Statement::Store {
                                pointer: copy,
                                value,
                            });
                            write_back.push((ptr, copy));
                            Val::Ptr(copy)
                        }
                        Place::Val(Val::Plain(value)) if is_temporary(inner) => {
                            let copy = self.variable("borrowed", &ty, arg.span)?;
                            self.push(Statement::Store {
                                pointer: copy,
                                value,
                            });
                            Val::Ptr(copy)
                        }
                        Place::Val(Val::Ptr(ptr)) => Val::Ptr(ptr),
                        Place::Val(Val::Plain(_)) => {
                            return Err(err(
                                arg.span,
                                "`&mut` of this would change a copy",
                                "borrow a `mut` variable",
                            ));
                        }
                        Place::Val(_) => {
                            return Err(err(
                                arg.span,
                                "`&mut` of a value that holds slices",
                                "pass its parts",
                            ));
                        }
                    }
                }
                _ => match (self.expr(arg)?, self.body.ty(&arg.ty)) {
                    (Val::Unit, Ty::Unit) => Val::Unit,
                    (Val::Unit, ty) => {
                        let ty = if ty == Ty::Never { Ty::U32 } else { ty };
                        let ty = self.l.naga_ty(&ty, arg.span)?;
                        Val::Plain(self.emit(Expression::ZeroValue(ty)))
                    }
                    (v, _) => v,
                },
            };
            values.push(value);
        }
        if self.diverged {
            return Ok(Val::Unit);
        }
        let shapes: Vec<Shape> = values.iter().map(Val::shape).collect();
        let callee = self.l.function(&zonked, &shapes, None, span)?;
        let mut arguments = Vec::new();
        values.iter().for_each(|v| v.flatten(&mut arguments));
        let result = self.l.module.functions[callee.handle]
            .result
            .is_some()
            .then(|| self.emit(Expression::CallResult(callee.handle)));
        self.push(Statement::Call {
            function: callee.handle,
            arguments,
            result,
        });
        for (ptr, copy) in write_back {
            let value = self.emit(Expression::Load { pointer: copy });
            self.push(Statement::Store {
                pointer: ptr,
                value,
            });
        }
        if callee.ret_ty == Ty::Never {
            return Ok(Val::Unit);
        }
        let mut count = Vec::new();
        let mut dummy = || {
            count.push(());
            result.unwrap_or_else(|| unreachable!("a shape with numbers has a result"))
        };
        let value = callee.ret.build(&mut dummy);
        match (count.len(), result) {
            (0 | 1, _) | (_, None) => Ok(value),
            (_, Some(result)) => {
                let mut index = 0;
                Ok(callee.ret.build(&mut || {
                    let h = self.emit(Expression::AccessIndex {
                        base: result,
                        index,
                    });
                    index += 1;
                    h
                }))
            }
        }
    }

    /// Whether a pointer is to a whole variable, as WGSL wants its pointer arguments.
    fn is_whole(&self, ptr: H) -> bool {
        matches!(
            self.func.expressions[ptr],
            Expression::LocalVariable(_) | Expression::FunctionArgument(_)
        )
    }
}

fn not_finite(span: Span) -> Box<crate::diag::Error> {
    err(
        span,
        "this constant is infinite or not a number",
        "infinities and NaN do not exist in shared code: use `f32::MAX`, or a flag",
    )
}

/// Whether an expression makes a value of its own, which nobody else can see.
fn is_temporary(e: &Expr) -> bool {
    matches!(
        e.kind,
        Kind::Call(..)
            | Kind::Struct(..)
            | Kind::Builtin(..)
            | Kind::Tuple(_)
            | Kind::Array(_)
            | Kind::Repeat(..)
            | Kind::Lit(_)
            | Kind::Int(_)
            | Kind::Some(_)
            | Kind::None
            | Kind::Unary(..)
            | Kind::Binary(..)
            | Kind::Cast(_)
    )
}
