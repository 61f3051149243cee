//! Constant arrays: one private variable of the module each, so that they can be indexed at run time.

use naga::{Expression, GlobalVariable, Handle, Span as NSpan};

use crate::diag::{R, err};
use crate::hir::{Body, Builtin, ConstKey, Expr, Kind};
use crate::konst;
use crate::ty::Ty;

use super::expr::literal;
use super::types::vector_size;
use super::{H, Lowerer};

impl Lowerer<'_> {
    pub(crate) fn table(
        &mut self,
        key: &ConstKey,
        span: crate::diag::Span,
    ) -> R<Handle<GlobalVariable>> {
        if let Some(h) = self.tables.get(key) {
            return Ok(*h);
        }
        let body = self.const_body(key)?;
        let init = self.global_expr(&body, &body.value)?;
        let ty = self.naga_ty(&body.ty(&body.ret), span)?;
        let global = GlobalVariable {
            name: Some(body.name.clone()),
            space: naga::AddressSpace::Private,
            binding: None,
            ty,
            init: Some(init),
            memory_decorations: naga::MemoryDecorations::empty(),
        };
        let handle = self
            .module
            .global_variables
            .append(global, NSpan::UNDEFINED);
        self.tables.insert(key.clone(), handle);
        Ok(handle)
    }

    fn global(&mut self, e: Expression) -> H {
        self.module.global_expressions.append(e, NSpan::UNDEFINED)
    }

    fn global_expr(&mut self, body: &Body, e: &Expr) -> R<H> {
        if let Some(lit) = konst::eval(self.items, &body.table, e) {
            return Ok(self.global(Expression::Literal(literal(lit))));
        }
        let ty = body.ty(&e.ty);
        let naga_ty = self.naga_ty(&ty, e.span)?;
        let components = match &e.kind {
            Kind::Array(list) | Kind::Tuple(list) | Kind::Builtin(Builtin::Compose, list) => list
                .iter()
                .map(|e| self.global_expr(body, e))
                .collect::<R<Vec<_>>>()?,
            Kind::Repeat(inner, n) => vec![self.global_expr(body, inner)?; *n as usize],
            Kind::Struct(fields, None) => {
                let mut list = vec![None; fields.len()];
                for (i, e) in fields {
                    list[*i] = Some(self.global_expr(body, e)?);
                }
                list.into_iter().flatten().collect()
            }
            Kind::Builtin(Builtin::Splat, list) => {
                let value = self.global_expr(body, &list[0])?;
                let Ty::Vec(_, n) = ty else {
                    return Err(err(
                        e.span,
                        "this is not a constant",
                        "write the components",
                    ));
                };
                return Ok(self.global(Expression::Splat {
                    size: vector_size(n),
                    value,
                }));
            }
            Kind::Const(key) => {
                let inner = self.const_body(key)?;
                return self.global_expr(&inner, &inner.value);
            }
            _ => {
                return Err(err(
                    e.span,
                    "the front end cannot compute this element of a constant table",
                    "use literals, consts, operators and casts, or hand the table over as a buffer",
                ));
            }
        };
        Ok(self.global(Expression::Compose {
            ty: naga_ty,
            components,
        }))
    }
}
