//! Control flow, patterns and assignment.

use naga::{BinaryOperator as NBin, Block, Expression, Statement, UnaryOperator};

use crate::diag::{R, Span, err};
use crate::hir::{Arm, BinOp, Expr, Kind, Lit, Pat, Stmt};
use crate::ty::Ty;

use super::function::{Binding, LoopCtx};
use super::place::Place;
use super::{FnLowerer, H, Val};

impl FnLowerer<'_, '_> {
    pub(crate) fn control(&mut self, e: &Expr) -> R<Val> {
        let span = e.span;
        match &e.kind {
            Kind::Block(stmts, tail) => {
                for stmt in stmts {
                    self.stmt(stmt)?;
                }
                match tail {
                    Some(tail) => {
                        self.mark(tail.span);
                        self.expr(tail)
                    }
                    None => Ok(Val::Unit),
                }
            }
            Kind::If(cond, then, other) => self.if_else(e, cond, then, other.as_deref()),
            Kind::Let(pat, scrutinee) => {
                let test = self.let_condition(pat, scrutinee)?;
                Ok(Val::Plain(match test {
                    Some(h) => h,
                    None => self.lit(Lit::Bool(true)),
                }))
            }
            Kind::Match(scrutinee, arms) => {
                let value = self.expr(scrutinee)?;
                let ty = self.body.ty(&scrutinee.ty);
                let result = self.result_var(e)?;
                self.arms(&value, &ty, arms, result)?;
                Ok(self.take(result))
            }
            Kind::Loop(body) => {
                let result = self.result_var(e)?;
                self.loops.push(LoopCtx { result });
                let (block, _, ()) = self.block_of(|c| c.discard(body))?;
                self.loops.pop();
                self.push(Statement::Loop {
                    body: block,
                    continuing: Block::new(),
                    break_if: None,
                });
                if self.body.ty(&e.ty) == Ty::Never {
                    self.diverged = true;
                }
                Ok(self.take(result))
            }
            Kind::ForRange {
                pat,
                lo,
                hi,
                inclusive,
                body,
            } => self.for_range(pat, lo, hi, *inclusive, body),
            Kind::Break(value) => {
                let result = self.loops.last().and_then(|l| l.result);
                if let Some(value) = value {
                    let v = self.expr(value)?;
                    self.put(result, v, value.span)?;
                }
                self.push(Statement::Break);
                self.diverged = true;
                Ok(Val::Unit)
            }
            Kind::Continue => {
                self.push(Statement::Continue);
                self.diverged = true;
                Ok(Val::Unit)
            }
            Kind::Return(value) => {
                let v = match value {
                    Some(e) => self.expr(e)?,
                    None => Val::Unit,
                };
                self.return_value(v, span)?;
                Ok(Val::Unit)
            }
            Kind::Assign(place, value) => {
                // Rust computes the value first, then the place.
                let v = self.plain(value)?;
                let ptr = self.pointer(place)?;
                self.push(Statement::Store {
                    pointer: ptr,
                    value: v,
                });
                Ok(Val::Unit)
            }
            Kind::AssignOp(op, place, value) => self.assign_op(*op, place, value),
            _ => Err(err(
                span,
                "this expression cannot be lowered here",
                "use the expressions of the shared subset",
            )),
        }
    }

    fn assign_op(&mut self, op: BinOp, place: &Expr, value: &Expr) -> R<Val> {
        let (pt, vt) = (self.body.ty(&place.ty), self.body.ty(&value.ty));
        // As rustc does: primitive types compute the right side first, all others the place.
        let primitive = |t: &Ty| t.is_number() || *t == Ty::Bool;
        let (ptr, right) = if primitive(&pt) && primitive(&vt) {
            let right = self.plain(value)?;
            (self.pointer(place)?, right)
        } else {
            let ptr = self.pointer(place)?;
            (ptr, self.plain(value)?)
        };
        let left = self.emit(Expression::Load { pointer: ptr });
        let result = self.binary(op, left, &pt, right, &vt)?;
        self.push(Statement::Store {
            pointer: ptr,
            value: result,
        });
        Ok(Val::Unit)
    }

    fn pointer(&mut self, place: &Expr) -> R<H> {
        place.no_const()?;
        match self.place(place)? {
            Place::Ptr(ptr) => Ok(ptr),
            Place::Val(_) => Err(err(
                place.span,
                "this cannot be assigned",
                "assign to a `mut` variable or a chunk's element",
            )),
        }
    }

    /// Lowers an expression for what it does.
    fn discard(&mut self, e: &Expr) -> R<()> {
        self.expr(e).map(|_| ())
    }

    fn stmt(&mut self, stmt: &Stmt) -> R<()> {
        match stmt {
            Stmt::Expr(e) => {
                self.mark(e.span);
                self.discard(e)
            }
            Stmt::Let {
                pat: Pat::Bind(id),
                init: None,
                span,
                ..
            } => {
                let ty = self.body.ty(&self.body.locals[*id].ty.clone());
                if self.l.holds_slices(&ty, *span)? {
                    return Err(err(
                        *span,
                        "a slice cannot be assigned later",
                        "bind it where it is declared",
                    ));
                }
                if !matches!(ty, Ty::Unit | Ty::Never) {
                    let name = self.body.locals[*id].name.clone();
                    let ptr = self.variable(&name, &ty, *span)?;
                    self.locals[*id] = Some(Binding::Var(ptr));
                }
                Ok(())
            }
            Stmt::Let {
                pat,
                init,
                otherwise,
                span,
            } => {
                self.mark(*span);
                let Some(init) = init else { return Ok(()) };
                let value = self.expr(init)?;
                let ty = self.body.ty(&init.ty);
                if let Some(otherwise) = otherwise
                    && let Some(test) = self.test(&value, &ty, pat, *span)?
                {
                    let not = self.emit(Expression::Unary {
                        op: UnaryOperator::LogicalNot,
                        expr: test,
                    });
                    let (block, _, ()) = self.block_of(|c| c.discard(otherwise))?;
                    self.push(Statement::If {
                        condition: not,
                        accept: block,
                        reject: Block::new(),
                    });
                }
                self.bind_pattern(&value, &ty, pat, *span)
            }
        }
    }

    /// A variable for the value of an expression that has branches, if it has a value.
    fn result_var(&mut self, e: &Expr) -> R<Option<H>> {
        let ty = self.body.ty(&e.ty);
        match ty {
            Ty::Unit | Ty::Never => Ok(None),
            ty => {
                if self.l.holds_slices(&ty, e.span)? {
                    return Err(err(
                        e.span,
                        "a slice cannot be chosen at run time",
                        "choose an index or bounds instead, and slice afterwards",
                    ));
                }
                self.variable("chosen", &ty, e.span).map(Some)
            }
        }
    }

    fn put(&mut self, result: Option<H>, value: Val, span: Span) -> R<()> {
        match (result, value) {
            (Some(pointer), Val::Plain(value)) => {
                self.push(Statement::Store { pointer, value });
                Ok(())
            }
            (None, _) | (_, Val::Unit) => Ok(()),
            _ => Err(err(
                span,
                "a slice cannot be chosen at run time",
                "choose an index or bounds instead",
            )),
        }
    }

    fn take(&mut self, result: Option<H>) -> Val {
        match result {
            Some(ptr) => self.read(Place::Ptr(ptr)),
            None => Val::Unit,
        }
    }

    fn branch(&mut self, e: &Expr, result: Option<H>) -> R<()> {
        let v = self.expr(e)?;
        self.put(result, v, e.span)
    }

    fn if_else(&mut self, e: &Expr, cond: &Expr, then: &Expr, other: Option<&Expr>) -> R<Val> {
        let result = self.result_var(e)?;
        let mut conjuncts = Vec::new();
        split(cond, &mut conjuncts);
        let binds = conjuncts.iter().any(|c| matches!(c.kind, Kind::Let(..)));
        if !binds || conjuncts.len() == 1 {
            let condition = self.plain(cond)?;
            let (accept, a, ()) = self.block_of(|c| c.branch(then, result))?;
            let (reject, b) = match other {
                Some(other) => {
                    let (block, diverged, ()) = self.block_of(|c| c.branch(other, result))?;
                    (block, diverged)
                }
                None => (Block::new(), false),
            };
            self.push(Statement::If {
                condition,
                accept,
                reject,
            });
            self.diverged |= a && b;
            return Ok(self.take(result));
        }
        // A chain that binds: each condition stands inside the one before, and the `else` after all of them.
        let missed = match other {
            Some(_) => {
                let ptr = self.variable("missed", &Ty::Bool, cond.span)?;
                let value = self.lit(Lit::Bool(true));
                self.push(Statement::Store {
                    pointer: ptr,
                    value,
                });
                Some(ptr)
            }
            None => None,
        };
        self.chain(&conjuncts, then, result, missed)?;
        if let (Some(other), Some(missed)) = (other, missed) {
            let condition = self.emit(Expression::Load { pointer: missed });
            let (accept, _, ()) = self.block_of(|c| c.branch(other, result))?;
            self.push(Statement::If {
                condition,
                accept,
                reject: Block::new(),
            });
        }
        Ok(self.take(result))
    }

    fn chain(
        &mut self,
        conjuncts: &[&Expr],
        then: &Expr,
        result: Option<H>,
        missed: Option<H>,
    ) -> R<()> {
        let Some((first, rest)) = conjuncts.split_first() else {
            if let Some(pointer) = missed {
                let value = self.lit(Lit::Bool(false));
                self.push(Statement::Store { pointer, value });
            }
            return self.branch(then, result);
        };
        let condition = self.plain(first)?;
        let (accept, _, ()) = self.block_of(|c| c.chain(rest, then, result, missed))?;
        self.push(Statement::If {
            condition,
            accept,
            reject: Block::new(),
        });
        Ok(())
    }

    fn let_condition(&mut self, pat: &Pat, scrutinee: &Expr) -> R<Option<H>> {
        let value = self.expr(scrutinee)?;
        let ty = self.body.ty(&scrutinee.ty);
        let test = self.test(&value, &ty, pat, scrutinee.span)?;
        self.bind_pattern(&value, &ty, pat, scrutinee.span)?;
        Ok(test)
    }

    fn arms(&mut self, value: &Val, ty: &Ty, arms: &[Arm], result: Option<H>) -> R<()> {
        let Some((arm, rest)) = arms.split_first() else {
            return Ok(());
        };
        let at = arm.body.span;
        let mut test = self.test(value, ty, &arm.pat, at)?;
        // Bindings only read the value: they may be made before it is known that the pattern fits.
        self.bind_pattern(value, ty, &arm.pat, at)?;
        if let Some(guard) = &arm.guard {
            test = Some(match test {
                None => self.plain(guard)?,
                Some(test) => {
                    let both = self.variable("fits", &Ty::Bool, at)?;
                    self.push(Statement::Store {
                        pointer: both,
                        value: test,
                    });
                    let (accept, _, ()) = self.block_of(|c| {
                        let g = c.plain(guard)?;
                        c.push(Statement::Store {
                            pointer: both,
                            value: g,
                        });
                        Ok(())
                    })?;
                    self.push(Statement::If {
                        condition: test,
                        accept,
                        reject: Block::new(),
                    });
                    self.emit(Expression::Load { pointer: both })
                }
            });
        }
        // The arms are exhaustive, so the last one needs no test.
        let Some(condition) = test.filter(|_| !rest.is_empty()) else {
            self.mark(at);
            return self.branch(&arm.body, result);
        };
        let (accept, a, ()) = self.block_of(|c| {
            c.mark(at);
            c.branch(&arm.body, result)
        })?;
        let (reject, b, ()) = self.block_of(|c| c.arms(value, ty, rest, result))?;
        self.push(Statement::If {
            condition,
            accept,
            reject,
        });
        self.diverged |= a && b;
        Ok(())
    }

    /// Whether `value` fits the pattern; `None` where it always does.
    fn test(&mut self, value: &Val, ty: &Ty, pat: &Pat, span: Span) -> R<Option<H>> {
        Ok(match pat {
            Pat::Wild | Pat::Bind(_) => None,
            Pat::At(_, inner) => self.test(value, ty, inner, span)?,
            Pat::Value(e) => {
                let v = self.of(value, ty, span)?;
                let e = self.plain(e)?;
                Some(self.bin(NBin::Equal, v, e))
            }
            Pat::Range(lo, hi, inclusive) => {
                let v = self.of(value, ty, span)?;
                let low = match lo {
                    Some(e) => {
                        let e = self.plain(e)?;
                        Some(self.bin(NBin::GreaterEqual, v, e))
                    }
                    None => None,
                };
                let high = match hi {
                    Some(e) => {
                        let e = self.plain(e)?;
                        let op = if *inclusive {
                            NBin::LessEqual
                        } else {
                            NBin::Less
                        };
                        Some(self.bin(op, v, e))
                    }
                    None => None,
                };
                self.all(low, high)
            }
            Pat::Variant(i) => {
                let v = self.of(value, ty, span)?;
                let i = self.lit(Lit::U32(*i));
                Some(self.bin(NBin::Equal, v, i))
            }
            Pat::None => {
                let flag = self.part(value, ty, 0, span)?;
                let flag = self.of(&flag, &Ty::Bool, span)?;
                Some(self.emit(Expression::Unary {
                    op: UnaryOperator::LogicalNot,
                    expr: flag,
                }))
            }
            Pat::Some(inner) => {
                let flag = self.part(value, ty, 0, span)?;
                let flag = self.of(&flag, &Ty::Bool, span)?;
                let Ty::Option(payload) = ty else {
                    return Ok(Some(flag));
                };
                let inside = self.part(value, ty, 1, span)?;
                let test = self.test(&inside, payload, inner, span)?;
                self.all(Some(flag), test)
            }
            Pat::Fields(fields) => {
                let types = self.l.field_types(ty, span)?;
                let mut test = None;
                for (i, p) in fields {
                    let part = self.part(value, ty, *i, span)?;
                    let one = self.test(&part, &types[*i], p, span)?;
                    test = self.all(test, one);
                }
                test
            }
            Pat::Or(list) => {
                let mut test = None;
                for p in list {
                    let Some(one) = self.test(value, ty, p, span)? else {
                        return Ok(None);
                    };
                    test = Some(match test {
                        Some(t) => self.bin(NBin::LogicalOr, t, one),
                        None => one,
                    });
                }
                test
            }
        })
    }

    fn bind_pattern(&mut self, value: &Val, ty: &Ty, pat: &Pat, span: Span) -> R<()> {
        match pat {
            Pat::Bind(id) => self.bind(*id, value.clone(), span),
            Pat::At(id, inner) => {
                self.bind(*id, value.clone(), span)?;
                self.bind_pattern(value, ty, inner, span)
            }
            Pat::Some(inner) => {
                let Ty::Option(payload) = ty else {
                    return Ok(());
                };
                let part = self.part(value, ty, 1, span)?;
                self.bind_pattern(&part, payload, inner, span)
            }
            Pat::Fields(fields) => {
                let types = self.l.field_types(ty, span)?;
                for (i, p) in fields {
                    let part = self.part(value, ty, *i, span)?;
                    self.bind_pattern(&part, &types[*i], p, span)?;
                }
                Ok(())
            }
            Pat::Wild
            | Pat::Value(_)
            | Pat::Range(..)
            | Pat::Variant(_)
            | Pat::None
            | Pat::Or(_) => Ok(()),
        }
    }

    /// Part `i` of a value.
    fn part(&mut self, value: &Val, ty: &Ty, i: usize, span: Span) -> R<Val> {
        match value {
            Val::Parts(parts) => Ok(parts[i].clone()),
            v => {
                let base = self.of(v, ty, span)?;
                Ok(Val::Plain(self.emit(Expression::AccessIndex {
                    base,
                    index: i as u32,
                })))
            }
        }
    }

    /// A value as one expression.
    fn of(&mut self, value: &Val, ty: &Ty, span: Span) -> R<H> {
        match value {
            Val::Plain(h) => Ok(*h),
            Val::Unit => {
                let ty = self.l.naga_ty(ty, span)?;
                Ok(self.emit(Expression::ZeroValue(ty)))
            }
            _ => Err(err(
                span,
                "this pattern cannot look into a slice",
                "index it",
            )),
        }
    }

    fn all(&mut self, a: Option<H>, b: Option<H>) -> Option<H> {
        match (a, b) {
            (Some(a), Some(b)) => Some(self.bin(NBin::LogicalAnd, a, b)),
            (a, b) => a.or(b),
        }
    }

    fn for_range(
        &mut self,
        pat: &Pat,
        lo: &Expr,
        hi: &Expr,
        inclusive: bool,
        body: &Expr,
    ) -> R<Val> {
        let ty = self.body.ty(&lo.ty);
        let one = if ty == Ty::I32 {
            Lit::I32(1)
        } else {
            Lit::U32(1)
        };
        let first = self.plain(lo)?;
        let last = self.plain(hi)?;
        let counter = self.variable("counter", &ty, lo.span)?;
        self.push(Statement::Store {
            pointer: counter,
            value: first,
        });
        self.loops.push(LoopCtx { result: None });
        let (block, _, ()) = self.block_of(|c| {
            let i = c.emit(Expression::Load { pointer: counter });
            let op = if inclusive {
                NBin::Greater
            } else {
                NBin::GreaterEqual
            };
            let done = c.bin(op, i, last);
            let mut stop = Block::new();
            stop.push(Statement::Break, naga::Span::UNDEFINED);
            c.push(Statement::If {
                condition: done,
                accept: stop,
                reject: Block::new(),
            });
            c.bind_pattern(&Val::Plain(i), &ty, pat, lo.span)?;
            c.discard(body)
        })?;
        self.loops.pop();
        let (continuing, _, break_if) = self.block_of(|c| {
            let i = c.emit(Expression::Load { pointer: counter });
            // An inclusive range may end at the type's largest value: it stops before it wraps.
            let break_if = inclusive.then(|| c.bin(NBin::Equal, i, last));
            let one = c.lit(one);
            let next = c.bin(NBin::Add, i, one);
            c.push(Statement::Store {
                pointer: counter,
                value: next,
            });
            Ok(break_if)
        })?;
        self.push(Statement::Loop {
            body: block,
            continuing,
            break_if,
        });
        Ok(Val::Unit)
    }
}

/// The parts of `a && b && c`.
fn split<'e>(cond: &'e Expr, out: &mut Vec<&'e Expr>) {
    match &cond.kind {
        Kind::AndAnd(l, r) => {
            split(l, out);
            split(r, out);
        }
        _ => out.push(cond),
    }
}
