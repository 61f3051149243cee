//! Values known while lowering: array lengths and the elements of constant tables.

use crate::check::check_const;
use crate::hir::{BinOp, Body, Expr, Kind, Lit, UnOp};
use crate::items::Items;
use crate::ty::{Table, Ty};

/// The value of an integer expression, if it is one that can be computed here.
pub(crate) fn eval_u32(items: &Items, table: &Table, e: &Expr) -> Option<u32> {
    match eval(items, table, e)? {
        Lit::U32(v) => Some(v),
        Lit::I32(v) => u32::try_from(v).ok(),
        _ => None,
    }
}

/// The value of a const's body.
pub(crate) fn eval_body(items: &Items, body: &Body) -> Option<Lit> {
    eval(items, &body.table, &body.value)
}

/// The value of an expression made of literals, consts, operators and casts; `None` for all else.
pub(crate) fn eval(items: &Items, table: &Table, e: &Expr) -> Option<Lit> {
    let signed = || matches!(table.zonk(&e.ty), Ty::I32 | Ty::IntVar(_));
    match &e.kind {
        Kind::Lit(lit) => Some(*lit),
        Kind::Int(v) if signed() => i32::try_from(*v).ok().map(Lit::I32),
        Kind::Int(v) => Some(Lit::U32(*v)),
        Kind::Const(key) => eval_body(items, &check_const(items, key).ok()?),
        Kind::Block(stmts, Some(tail)) if stmts.is_empty() => eval(items, table, tail),
        Kind::Unary(op, inner) => {
            // `-2147483648`: the literal alone does not fit.
            if let (UnOp::Neg, Kind::Int(v), true) = (op, &inner.kind, signed()) {
                return Some(Lit::I32((*v as i32).wrapping_neg()));
            }
            match (op, eval(items, table, inner)?) {
                (UnOp::Neg, Lit::F32(v)) => Some(Lit::F32(-v)),
                (UnOp::Neg, Lit::I32(v)) => Some(Lit::I32(v.wrapping_neg())),
                (UnOp::Not, Lit::Bool(v)) => Some(Lit::Bool(!v)),
                (UnOp::Not, Lit::U32(v)) => Some(Lit::U32(!v)),
                (UnOp::Not, Lit::I32(v)) => Some(Lit::I32(!v)),
                _ => None,
            }
        }
        Kind::Cast(inner) => {
            let v = eval(items, table, inner)?;
            Some(match (v, table.zonk(&e.ty)) {
                (Lit::F32(v), Ty::F32) => Lit::F32(v),
                (Lit::F32(v), Ty::I32) => Lit::I32(v as i32),
                (Lit::F32(v), _) => Lit::U32(v as u32),
                (Lit::U32(v), Ty::F32) => Lit::F32(v as f32),
                (Lit::U32(v), Ty::I32) => Lit::I32(v as i32),
                (Lit::U32(v), _) => Lit::U32(v),
                (Lit::I32(v), Ty::F32) => Lit::F32(v as f32),
                (Lit::I32(v), Ty::I32) => Lit::I32(v),
                (Lit::I32(v), _) => Lit::U32(v as u32),
                (Lit::Bool(v), Ty::I32) => Lit::I32(v.into()),
                (Lit::Bool(v), _) => Lit::U32(v.into()),
            })
        }
        Kind::AndAnd(l, r) | Kind::OrOr(l, r) => {
            let Lit::Bool(left) = eval(items, table, l)? else {
                return None;
            };
            let and = matches!(e.kind, Kind::AndAnd(..));
            if left == and {
                eval(items, table, r)
            } else {
                Some(Lit::Bool(left))
            }
        }
        Kind::Binary(op, l, r) => {
            let (left, right) = (eval(items, table, l)?, eval(items, table, r)?);
            let value = binary(*op, left, right)?;
            // A host's usize keeps the bits that 32 do not.
            let lost = match (op, value, left) {
                (BinOp::Shl, Lit::U32(v), Lit::U32(_)) => {
                    binary(BinOp::Shr, Lit::U32(v), right) != Some(left)
                }
                _ => false,
            };
            if lost && table.zonk(&e.ty) == Ty::Usize {
                return None;
            }
            Some(value)
        }
        _ => None,
    }
}

fn binary(op: BinOp, l: Lit, r: Lit) -> Option<Lit> {
    use BinOp as O;
    if let O::Shl | O::Shr = op {
        let by = match r {
            Lit::U32(n) => n,
            Lit::I32(n) => n as u32,
            _ => return None,
        };
        if by > 31 {
            return None;
        }
        return match (l, op) {
            (Lit::U32(v), O::Shl) => Some(Lit::U32(v << by)),
            (Lit::U32(v), _) => Some(Lit::U32(v >> by)),
            (Lit::I32(v), O::Shl) => Some(Lit::I32(v << by)),
            (Lit::I32(v), _) => Some(Lit::I32(v >> by)),
            _ => None,
        };
    }
    let order = match (l, r) {
        (Lit::F32(a), Lit::F32(b)) => a.partial_cmp(&b),
        (Lit::U32(a), Lit::U32(b)) => Some(a.cmp(&b)),
        (Lit::I32(a), Lit::I32(b)) => Some(a.cmp(&b)),
        (Lit::Bool(a), Lit::Bool(b)) => Some(a.cmp(&b)),
        _ => None,
    };
    let compared = match op {
        O::Eq => Some(order?.is_eq()),
        O::Ne => Some(order?.is_ne()),
        O::Lt => Some(order?.is_lt()),
        O::Le => Some(order?.is_le()),
        O::Gt => Some(order?.is_gt()),
        O::Ge => Some(order?.is_ge()),
        _ => None,
    };
    if let Some(v) = compared {
        return Some(Lit::Bool(v));
    }
    Some(match (l, r) {
        (Lit::F32(a), Lit::F32(b)) => Lit::F32(match op {
            O::Add => a + b,
            O::Sub => a - b,
            O::Mul => a * b,
            O::Div => a / b,
            _ => return None,
        }),
        (Lit::U32(a), Lit::U32(b)) => Lit::U32(match op {
            O::Add => a.checked_add(b)?,
            O::Sub => a.checked_sub(b)?,
            O::Mul => a.checked_mul(b)?,
            O::Div => a.checked_div(b)?,
            O::Rem => a.checked_rem(b)?,
            O::And => a & b,
            O::Or => a | b,
            O::Xor => a ^ b,
            _ => return None,
        }),
        (Lit::I32(a), Lit::I32(b)) => Lit::I32(match op {
            O::Add => a.checked_add(b)?,
            O::Sub => a.checked_sub(b)?,
            O::Mul => a.checked_mul(b)?,
            O::Div => a.checked_div(b)?,
            O::Rem => a.checked_rem(b)?,
            O::And => a & b,
            O::Or => a | b,
            O::Xor => a ^ b,
            _ => return None,
        }),
        _ => return None,
    })
}
