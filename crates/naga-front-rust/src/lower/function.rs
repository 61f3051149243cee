//! One function: its arguments, its result, the statements as they are pushed.

use std::rc::Rc;

use naga::{Block, Expression, FunctionArgument, FunctionResult, Statement, Type, TypeInner};

use crate::diag::{R, Span, err};
use crate::hir::{Body, LocalId};
use crate::ty::Ty;

use super::{H, Lowered, Lowerer, Shape, Val};

/// How a local is kept.
#[derive(Clone, Debug)]
pub(crate) enum Binding {
    Value(Val),
    Var(H),
}

/// A loop that is being lowered.
pub(crate) struct LoopCtx {
    /// Where `break value` goes.
    pub(crate) result: Option<H>,
}

/// The variable whose stores mark source lines in the WGSL before they become comments.
pub(crate) const MARKER: &str = "naga_front_rust_line";

pub(crate) struct FnLowerer<'l, 'p> {
    pub(crate) l: &'l mut Lowerer<'p>,
    pub(crate) body: Rc<Body>,
    pub(crate) func: naga::Function,
    blocks: Vec<Block>,
    /// The open block has ended in `return`, `break` or `continue`: what follows is never reached.
    pub(crate) diverged: bool,
    pub(crate) locals: Vec<Option<Binding>>,
    pub(crate) loops: Vec<LoopCtx>,
    ret: Option<Shape>,
    marker: Option<H>,
    marked: (usize, usize),
}

impl<'l, 'p> FnLowerer<'l, 'p> {
    pub(crate) fn new(l: &'l mut Lowerer<'p>, body: Rc<Body>, name: &str) -> Self {
        let func = naga::Function {
            name: Some(name.to_string()),
            ..naga::Function::default()
        };
        let locals = vec![None; body.locals.len()];
        FnLowerer {
            l,
            body,
            func,
            blocks: vec![Block::new()],
            diverged: false,
            locals,
            loops: Vec::new(),
            ret: None,
            marker: None,
            marked: (usize::MAX, 0),
        }
    }

    pub(crate) fn lower(
        l: &'l mut Lowerer<'p>,
        body: Rc<Body>,
        shapes: &[Shape],
        name: Option<&str>,
    ) -> R<Lowered> {
        let span = body.span;
        let ret_ty = body.ty(&body.ret);
        let name = name.unwrap_or(&body.name).to_string();
        let mut f = FnLowerer::new(l, body.clone(), &name);
        f.arguments(shapes)?;
        let value = f.expr(&body.value)?;
        if !f.diverged {
            f.return_value(value, body.value.span)?;
        }
        f.finish_body(&ret_ty, span)?;
        let ret = f.ret.take().unwrap_or(Shape::Unit);
        let func = f.func;
        let origin = match l.markers {
            true => crate::wgsl::span_of_origin(span),
            false => naga::Span::UNDEFINED,
        };
        let handle = l.module.functions.append(func, origin);
        Ok(Lowered {
            handle,
            ret,
            ret_ty,
        })
    }

    /// Every path of a WGSL function returns, also those that Rust knows to be unreachable.
    fn finish_body(&mut self, ret_ty: &Ty, span: Span) -> R<()> {
        if self.func.result.is_none()
            && self.ret.is_none()
            && !matches!(ret_ty, Ty::Unit | Ty::Never)
        {
            // The body never returns (a loop without an end): the result type is the declared one.
            self.ret = Some(Shape::Plain);
            let ty = self.l.naga_ty(ret_ty, span)?;
            self.func.result = Some(FunctionResult { ty, binding: None });
        }
        if self.diverged {
            let value = match &self.func.result {
                Some(r) => {
                    let ty = r.ty;
                    Some(
                        self.func
                            .expressions
                            .append(Expression::ZeroValue(ty), naga::Span::UNDEFINED),
                    )
                }
                None => None,
            };
            let block = self.blocks.last_mut().expect("the body's block is open");
            if !matches!(block.last(), Some(Statement::Return { .. })) {
                block.push(Statement::Return { value }, naga::Span::UNDEFINED);
            }
        }
        self.func.body = self.blocks.pop().expect("the body's block is open");
        Ok(())
    }

    fn arguments(&mut self, shapes: &[Shape]) -> R<()> {
        let body = self.body.clone();
        let span = body.span;
        for (&id, shape) in body.params.iter().zip(shapes) {
            let local = &body.locals[id];
            let ty = body.ty(&local.ty);
            let name = if local.name == "self" {
                "this"
            } else {
                &local.name
            };
            let mut list = Vec::new();
            self.argument_types(&ty, shape, name, span, &mut list)?;
            let mut handles = Vec::new();
            for (name, ty) in list {
                let index = self.func.arguments.len() as u32;
                self.func.arguments.push(FunctionArgument {
                    name: Some(name),
                    ty,
                    binding: None,
                });
                handles.push(self.emit(Expression::FunctionArgument(index)));
            }
            let mut handles = handles.into_iter();
            let value = shape.build(&mut || handles.next().expect("one for each"));
            self.bind(id, value, span)?;
        }
        Ok(())
    }

    /// Names and types of the arguments into which a parameter falls apart.
    fn argument_types(
        &mut self,
        ty: &Ty,
        shape: &Shape,
        name: &str,
        span: Span,
        out: &mut Vec<(String, naga::Handle<Type>)>,
    ) -> R<()> {
        match shape {
            Shape::Unit => {}
            Shape::Plain => out.push((name.to_string(), self.l.naga_ty(ty, span)?)),
            Shape::Ptr => {
                let base = self.l.naga_ty(ty.behind(), span)?;
                let inner = TypeInner::Pointer {
                    base,
                    space: naga::AddressSpace::Function,
                };
                let handle = self
                    .l
                    .module
                    .types
                    .insert(Type { name: None, inner }, naga::Span::UNDEFINED);
                out.push((name.to_string(), handle));
            }
            Shape::Slice { whole: true, .. } => {}
            Shape::Slice { whole: false, .. } => {
                let u32_ty = self.l.naga_ty(&Ty::U32, span)?;
                out.push((format!("{name}_start"), u32_ty));
                out.push((format!("{name}_len"), u32_ty));
            }
            Shape::Parts(shapes) => {
                let names = self.l.field_names(ty);
                let types = self.l.field_types(ty, span)?;
                for ((field, ty), shape) in names.iter().zip(&types).zip(shapes) {
                    let below = if name == "this" {
                        field.clone()
                    } else {
                        format!("{name}_{field}")
                    };
                    self.argument_types(ty, shape, &below, span, out)?;
                }
            }
        }
        Ok(())
    }

    /// Pushes `return value`, and settles the function's result type by the first one.
    pub(crate) fn return_value(&mut self, value: Val, span: Span) -> R<()> {
        if self.diverged {
            return Ok(());
        }
        let ret_ty = self.body.ty(&self.body.ret);
        let shape = value.shape();
        match &self.ret {
            Some(known) if *known != shape => {
                return Err(err(
                    span,
                    "this function returns slices of different buffers or extents",
                    "return the index, or the bounds, and slice at the caller",
                ));
            }
            Some(_) => {}
            None => {
                self.ret = Some(shape.clone());
                let mut list = Vec::new();
                self.argument_types(&ret_ty, &shape, "value", span, &mut list)?;
                self.func.result = match list.len() {
                    0 => None,
                    1 => Some(FunctionResult {
                        ty: list[0].1,
                        binding: None,
                    }),
                    _ => {
                        let inner = self.l.structure(list);
                        let name = Some(format!("Returned_{}", self.body.name));
                        let ty = self
                            .l
                            .module
                            .types
                            .insert(Type { name, inner }, naga::Span::UNDEFINED);
                        Some(FunctionResult { ty, binding: None })
                    }
                };
            }
        }
        let mut parts = Vec::new();
        value.flatten(&mut parts);
        let value = match (parts.as_slice(), &self.func.result) {
            ([], _) => None,
            ([one], _) => Some(*one),
            (_, Some(result)) => {
                let ty = result.ty;
                Some(self.emit(Expression::Compose {
                    ty,
                    components: parts,
                }))
            }
            (_, None) => None,
        };
        self.push(Statement::Return { value });
        self.diverged = true;
        Ok(())
    }

    /// Binds a local to a value; one that is mutable or holds an array becomes a variable.
    pub(crate) fn bind(&mut self, id: LocalId, value: Val, span: Span) -> R<()> {
        let body = self.body.clone();
        let local = &body.locals[id];
        let ty = body.ty(&local.ty);
        let binding = match value {
            Val::Plain(h) if local.mutable || self.l.holds_array(&ty, span)? => {
                let ptr = self.variable(&local.name, &ty, span)?;
                self.push(Statement::Store {
                    pointer: ptr,
                    value: h,
                });
                Binding::Var(ptr)
            }
            Val::Slice(_) | Val::Parts(_) if local.mutable => {
                return Err(err(
                    span,
                    format!("`{}` holds slices and is `mut`", local.name),
                    "bind a new `let` instead of changing it",
                ));
            }
            Val::Unit if !matches!(ty, Ty::Unit | Ty::Never) => {
                // Behind a value that never comes: the name may still be read, in code that is never reached.
                let ty = self.l.naga_ty(&ty, span)?;
                Binding::Value(Val::Plain(self.emit(Expression::ZeroValue(ty))))
            }
            Val::Plain(h) => {
                self.name_expr(h, &local.name);
                Binding::Value(Val::Plain(h))
            }
            v => Binding::Value(v),
        };
        self.locals[id] = Some(binding);
        Ok(())
    }

    fn name_expr(&mut self, h: H, name: &str) {
        let e = &self.func.expressions[h];
        let nameable = !e.needs_pre_emit() && !matches!(e, Expression::CallResult(_));
        if nameable && !self.func.named_expressions.contains_key(&h) {
            self.func.named_expressions.insert(h, name.to_string());
        }
    }

    pub(crate) fn binding(&mut self, id: LocalId, span: Span) -> R<Binding> {
        match &self.locals[id] {
            Some(b) => Ok(b.clone()),
            None => Err(err(
                span,
                format!("`{}` has no value here", self.body.locals[id].name),
                "this is a fault of the front end: please report it",
            )),
        }
    }

    pub(crate) fn emit(&mut self, e: Expression) -> H {
        let ready = e.needs_pre_emit() || matches!(e, Expression::CallResult(_));
        let h = self.func.expressions.append(e, naga::Span::UNDEFINED);
        if !ready {
            self.push(Statement::Emit(naga::Range::new_from_bounds(h, h)));
        }
        h
    }

    pub(crate) fn push(&mut self, s: Statement) {
        if !self.diverged {
            let block = self.blocks.last_mut().expect("a block is open");
            block.push(s, naga::Span::UNDEFINED);
        }
    }

    /// Lowers into a block of its own: the block, and whether its end is never reached.
    pub(crate) fn block_of<T>(&mut self, f: impl FnOnce(&mut Self) -> R<T>) -> R<(Block, bool, T)> {
        let outer = std::mem::replace(&mut self.diverged, false);
        self.blocks.push(Block::new());
        let result = f(self);
        let block = self.blocks.pop().expect("pushed above");
        let diverged = std::mem::replace(&mut self.diverged, outer);
        Ok((block, diverged, result?))
    }

    /// Marks the source line of what follows.
    pub(crate) fn mark(&mut self, span: Span) {
        if !self.l.markers
            || self.diverged
            || (span.file, span.line) == self.marked
            || span.line == 0
        {
            return;
        }
        self.marked = (span.file, span.line);
        let ptr = match self.marker {
            Some(ptr) => ptr,
            None => {
                let ty = TypeInner::Scalar(naga::Scalar::U32);
                let ty = self.l.module.types.insert(
                    Type {
                        name: None,
                        inner: ty,
                    },
                    naga::Span::UNDEFINED,
                );
                let var = naga::LocalVariable {
                    name: Some(MARKER.into()),
                    ty,
                    init: None,
                };
                let var = self.func.local_variables.append(var, naga::Span::UNDEFINED);
                let ptr = self.emit(Expression::LocalVariable(var));
                self.marker = Some(ptr);
                ptr
            }
        };
        let code = (span.file as u32) << 20 | span.line as u32;
        let value = self.emit(Expression::Literal(naga::Literal::U32(code)));
        self.push(Statement::Store {
            pointer: ptr,
            value,
        });
    }

    /// Takes the finished naga function of code that was lowered without a body, as an entry point's.
    pub(crate) fn into_function(mut self) -> naga::Function {
        self.func.body = self.blocks.pop().expect("the body's block is open");
        self.func
    }
}

impl Lowerer<'_> {
    /// The names of a struct's or tuple's fields.
    pub(crate) fn field_names(&self, ty: &Ty) -> Vec<String> {
        match ty {
            Ty::Struct(id, _) => {
                let fields = &self.items.structs[*id].item.fields;
                let name = |(i, f): (usize, &syn::Field)| {
                    f.ident
                        .as_ref()
                        .map_or_else(|| i.to_string(), |n| n.to_string())
                };
                fields.iter().enumerate().map(name).collect()
            }
            Ty::Tuple(list) => (0..list.len()).map(|i| i.to_string()).collect(),
            _ => Vec::new(),
        }
    }
}
