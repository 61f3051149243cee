//! Blocks, `let`, control flow, assignment.

use std::collections::HashMap;

use crate::diag::{R, err};
use crate::hir::{Arm, Expr, Kind, Stmt, UnOp};
use crate::items::check_attrs;
use crate::ty::Ty;

use super::{Checker, Loop};

impl Checker<'_> {
    /// Runs `f` with a scope of names of its own.
    fn scoped<T>(&mut self, f: impl FnOnce(&mut Self) -> R<T>) -> R<T> {
        self.names.push(HashMap::new());
        let result = f(self);
        self.names.pop();
        result
    }

    pub(super) fn block(&mut self, b: &syn::Block, expect: Option<&Ty>) -> R<Expr> {
        let span = self.span(b);
        self.scoped(|c| {
            let mut stmts = Vec::new();
            let mut tail = None;
            let mut diverges = false;
            for (i, stmt) in b.stmts.iter().enumerate() {
                let last = i + 1 == b.stmts.len();
                match stmt {
                    syn::Stmt::Expr(e, None) if last => {
                        let e = c.expr(e, expect)?;
                        tail = Some(Box::new(e));
                    }
                    syn::Stmt::Expr(e, semi) => {
                        let want = if semi.is_none() {
                            Some(&Ty::Unit)
                        } else {
                            None
                        };
                        let e = c.expr(e, want)?;
                        diverges |= matches!(c.zonk(&e.ty), Ty::Never);
                        stmts.push(Stmt::Expr(e));
                    }
                    syn::Stmt::Macro(m) => {
                        let e = c.macro_call(&m.mac)?;
                        stmts.push(Stmt::Expr(e));
                    }
                    syn::Stmt::Local(l) => {
                        let stmt = c.let_stmt(l)?;
                        if let Stmt::Let { init: Some(e), .. } = &stmt {
                            diverges |= matches!(c.zonk(&e.ty), Ty::Never);
                        }
                        stmts.push(stmt);
                    }
                    syn::Stmt::Item(item) => {
                        return Err(err(
                            c.span(item),
                            "an item inside a block cannot be lowered",
                            "move it to the top of the function, or to the module",
                        ));
                    }
                }
            }
            let ty = match &tail {
                Some(t) if !diverges => t.ty.clone(),
                None if !diverges => Ty::Unit,
                _ => Ty::Never,
            };
            Ok(Expr {
                kind: Kind::Block(stmts, tail),
                ty,
                span,
            })
        })
    }

    fn let_stmt(&mut self, l: &syn::Local) -> R<Stmt> {
        let span = self.span(l);
        check_attrs(self.scope.file, &l.attrs)?;
        let (pat, written) = match &l.pat {
            syn::Pat::Type(t) => (&*t.pat, Some(self.ty(&t.ty)?)),
            pat => (pat, None),
        };
        let Some(init) = &l.init else {
            let ty = written.unwrap_or_else(|| self.table.var());
            let syn::Pat::Ident(i) = pat else {
                return Err(err(
                    span,
                    "a pattern without a value cannot be lowered",
                    "declare each name by itself",
                ));
            };
            // Assigned later, once: a variable on the GPU.
            let id = self.declare(&i.ident.to_string(), ty, true);
            return Ok(Stmt::Let {
                pat: crate::hir::Pat::Bind(id),
                init: None,
                otherwise: None,
                span,
            });
        };
        let mut value = self.expr(&init.expr, written.as_ref())?;
        if let Some(ty) = &written {
            value = self.coerce(value, ty)?;
        }
        if let Ty::RefMut(_) = self.zonk(&value.ty) {
            return Err(err(
                span,
                "`&mut` cannot be kept in a variable",
                "use the place itself, or pass `&mut place` to a function",
            ));
        }
        let otherwise = match &init.diverge {
            Some((_, e)) => {
                let e = self.expr(e, None)?;
                Some(Box::new(e))
            }
            None => None,
        };
        let pat = self.pattern(pat, &value.ty.clone())?;
        Ok(Stmt::Let {
            pat,
            init: Some(Box::new(value)),
            otherwise,
            span,
        })
    }

    /// A condition with its bindings in scope for `f`.
    fn condition(&mut self, e: &syn::Expr) -> R<Expr> {
        let e = self.expr(e, Some(&Ty::Bool))?;
        self.coerce(e, &Ty::Bool)
    }

    /// The common type of branches.
    fn join(&mut self, into: &mut Option<Ty>, branch: Expr) -> R<Expr> {
        let branch = self.no_ref(branch)?;
        let branch = match into {
            Some(want) if !matches!(self.zonk(want), Ty::RefMut(_)) => {
                if matches!(self.zonk(&branch.ty), Ty::Never) {
                    branch
                } else {
                    let want = want.clone();
                    self.coerce(branch, &want)?
                }
            }
            _ => branch,
        };
        if into.is_none() && !matches!(self.zonk(&branch.ty), Ty::Never) {
            *into = Some(branch.ty.clone());
        }
        Ok(branch)
    }

    pub(super) fn if_expr(&mut self, i: &syn::ExprIf, expect: Option<&Ty>) -> R<Expr> {
        let span = self.span(i);
        let mut ty = None;
        let (cond, then) = self.scoped(|c| {
            let cond = c.condition(&i.cond)?;
            let then = c.block(&i.then_branch, expect)?;
            Ok((cond, then))
        })?;
        let Some((_, other)) = &i.else_branch else {
            return Ok(Expr {
                kind: Kind::If(Box::new(cond), Box::new(then), None),
                ty: Ty::Unit,
                span,
            });
        };
        let then = self.join(&mut ty, then)?;
        let hint = ty.clone().or(expect.cloned());
        let other = self.expr(other, hint.as_ref())?;
        let other = self.join(&mut ty, other)?;
        let ty = ty.unwrap_or(Ty::Never);
        Ok(Expr {
            kind: Kind::If(Box::new(cond), Box::new(then), Some(Box::new(other))),
            ty,
            span,
        })
    }

    pub(super) fn match_expr(&mut self, m: &syn::ExprMatch, expect: Option<&Ty>) -> R<Expr> {
        let span = self.span(m);
        let scrutinee = self.expr(&m.expr, None)?;
        let scrutinee = self.scrutinee(scrutinee)?;
        let mut ty = None;
        let mut arms = Vec::new();
        for arm in &m.arms {
            check_attrs(self.scope.file, &arm.attrs)?;
            let hint = ty.clone().or(expect.cloned());
            let (pat, guard, body) = self.scoped(|c| {
                let (pat, guard) = match &arm.pat {
                    syn::Pat::Guard(g) => (&*g.pat, Some(&*g.guard)),
                    pat => (pat, None),
                };
                let pat = c.pattern(pat, &scrutinee.ty.clone())?;
                let guard = match guard {
                    Some(g) => Some(c.condition(g)?),
                    None => None,
                };
                let body = c.expr(&arm.body, hint.as_ref())?;
                Ok((pat, guard, body))
            })?;
            let body = self.join(&mut ty, body)?;
            arms.push(Arm { pat, guard, body });
        }
        let ty = ty.unwrap_or(Ty::Never);
        Ok(Expr {
            kind: Kind::Match(Box::new(scrutinee), arms),
            ty,
            span,
        })
    }

    pub(super) fn loop_expr(&mut self, l: &syn::ExprLoop, expect: Option<&Ty>) -> R<Expr> {
        let span = self.span(l);
        let value = match expect {
            Some(t) if !matches!(self.zonk(t), Ty::Unit) => t.clone(),
            _ => self.table.var(),
        };
        self.loops.push(Loop {
            value: Some(value.clone()),
            broken: false,
        });
        let body = self.block(&l.body, Some(&Ty::Unit))?;
        let ended = self.loops.pop().expect("pushed above");
        let ty = match (ended.broken, self.zonk(&value)) {
            (false, _) => Ty::Never,
            (true, Ty::Var(_)) => Ty::Unit,
            (true, ty) => ty,
        };
        Ok(Expr {
            kind: Kind::Loop(Box::new(body)),
            ty,
            span,
        })
    }

    pub(super) fn while_expr(&mut self, w: &syn::ExprWhile) -> R<Expr> {
        let span = self.span(w);
        self.loops.push(Loop {
            value: None,
            broken: false,
        });
        let (cond, body) = self.scoped(|c| {
            let cond = c.condition(&w.cond)?;
            let body = c.block(&w.body, Some(&Ty::Unit))?;
            Ok((cond, body))
        })?;
        self.loops.pop();
        // `while c { b }` is `loop { if c { b } else { break } }`.
        let stop = Expr {
            kind: Kind::Break(None),
            ty: Ty::Never,
            span: cond.span,
        };
        let body = match cond.kind {
            Kind::Let(..) | Kind::AndAnd(..) => Expr {
                span,
                ty: Ty::Unit,
                kind: Kind::If(Box::new(cond), Box::new(body), Some(Box::new(stop))),
            },
            _ => {
                let at = cond.span;
                let not = Expr {
                    kind: Kind::Unary(UnOp::Not, Box::new(cond)),
                    ty: Ty::Bool,
                    span: at,
                };
                let leave = Expr {
                    kind: Kind::If(Box::new(not), Box::new(stop), None),
                    ty: Ty::Unit,
                    span: at,
                };
                Expr {
                    kind: Kind::Block(vec![Stmt::Expr(leave), Stmt::Expr(body)], None),
                    ty: Ty::Unit,
                    span,
                }
            }
        };
        Ok(Expr {
            kind: Kind::Loop(Box::new(body)),
            ty: Ty::Unit,
            span,
        })
    }

    pub(super) fn for_expr(&mut self, f: &syn::ExprForLoop) -> R<Expr> {
        let span = self.span(f);
        let mut range = &*f.expr;
        while let syn::Expr::Paren(p) = range {
            range = &p.expr;
        }
        let syn::Expr::Range(r) = range else {
            return Err(err(
                self.span(&f.expr),
                "`for` runs over ranges only: iterators cannot be lowered",
                "write `for i in 0..s.len()`",
            ));
        };
        let (Some(lo), Some(hi)) = (&r.start, &r.end) else {
            return Err(err(
                self.span(r),
                "this range has no end",
                "write `for i in a..b`",
            ));
        };
        let lo = self.expr(lo, None)?;
        let lo = self.value(lo);
        let hi = self.expr(hi, Some(&lo.ty.clone()))?;
        let ty = lo.ty.clone();
        let hi = self.coerce(hi, &ty)?;
        if !self.zonk(&ty).is_int() {
            return Err(err(
                self.span(r),
                "`for` runs over integers",
                "use u32, i32 or usize",
            ));
        }
        let inclusive = matches!(r.limits, syn::RangeLimits::Closed(_));
        self.loops.push(Loop {
            value: None,
            broken: false,
        });
        let (pat, body) = self.scoped(|c| {
            let pat = c.pattern(&f.pat, &ty)?;
            let body = c.block(&f.body, Some(&Ty::Unit))?;
            Ok((pat, body))
        })?;
        self.loops.pop();
        let (pat, lo, hi, body) = (Box::new(pat), Box::new(lo), Box::new(hi), Box::new(body));
        Ok(Expr {
            kind: Kind::ForRange {
                pat,
                lo,
                hi,
                inclusive,
                body,
            },
            ty: Ty::Unit,
            span,
        })
    }

    pub(super) fn break_expr(&mut self, b: &syn::ExprBreak) -> R<Expr> {
        let span = self.span(b);
        if b.label.is_some() {
            return Err(err(
                span,
                "a label cannot be lowered",
                "put the inner loop into a function that returns, or use a flag",
            ));
        }
        let Some(current) = self.loops.last_mut() else {
            return Err(err(span, "`break` outside a loop", "use `return`"));
        };
        current.broken = true;
        let want = current.value.clone();
        let value = match (&b.expr, want) {
            (Some(e), Some(want)) => {
                let e = self.expr(e, Some(&want))?;
                Some(Box::new(self.coerce(e, &want)?))
            }
            (Some(_), None) => {
                return Err(err(span, "`break` with a value needs `loop`", "use `loop`"));
            }
            (None, Some(want)) => {
                self.unify(&Ty::Unit, &want, span)?;
                None
            }
            (None, None) => None,
        };
        Ok(Expr {
            kind: Kind::Break(value),
            ty: Ty::Never,
            span,
        })
    }

    pub(super) fn assign(&mut self, a: &syn::ExprAssign) -> R<Expr> {
        let span = self.span(a);
        if let syn::Expr::Infer(_) = &*a.left {
            let value = self.expr(&a.right, None)?;
            return Ok(Expr {
                kind: Kind::Block(vec![Stmt::Expr(value)], None),
                ty: Ty::Unit,
                span,
            });
        }
        if let syn::Expr::Tuple(_) | syn::Expr::Struct(_) | syn::Expr::Array(_) = &*a.left {
            return Err(err(
                span,
                "assignment to a pattern cannot be lowered",
                "assign each place by itself",
            ));
        }
        let place = self.expr(&a.left, None)?;
        let place = self.no_ref(place)?;
        let want = place.ty.clone();
        let value = self.expr(&a.right, Some(&want))?;
        let value = self.coerce(value, &want)?;
        if let Ty::Slice(_) = self.zonk(&want) {
            return Err(err(
                span,
                "a slice cannot be assigned again",
                "bind a new `let`",
            ));
        }
        Ok(Expr {
            kind: Kind::Assign(Box::new(place), Box::new(value)),
            ty: Ty::Unit,
            span,
        })
    }

    /// What is matched on: a value, never `&mut`, whose bindings would be references.
    pub(super) fn scrutinee(&mut self, e: Expr) -> R<Expr> {
        if let Ty::RefMut(_) = self.zonk(&e.ty) {
            return Err(err(
                e.span,
                "matching on `&mut` would bind references",
                "match on the value: `*r`",
            ));
        }
        Ok(e)
    }
}
