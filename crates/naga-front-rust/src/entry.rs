//! Host file: entry points, where kernels meet buffers.

use std::rc::Rc;

use naga::{
    AddressSpace, ArraySize, Binding, BuiltIn, EntryPoint, Expression, FunctionArgument,
    GlobalVariable, ResourceBinding, ShaderStage, Span as NSpan, Statement, StorageAccess, Type,
    TypeInner,
};

use crate::argument::Signature;
use crate::check::Checker;
use crate::diag::{R, Span, err};
use crate::hir::{Body, Expr, Instance, Kind};
use crate::lower::{FnLowerer, Global, H, Lowerer, Shape, SliceVal, Val};
use crate::ty::{Table, Ty};
use crate::uniform::ParamsSpace;
use crate::{Buffer, EntryDesc, Param};

/// How an argument comes from buffers: what lies in `params`, and which slices there are.
enum Source {
    /// Member of the params struct.
    Param(u32),
    /// Slice, by its global.
    Slice(usize),
    Parts(Vec<Source>),
}

/// What an entry point or export was made of.
#[derive(Default)]
pub(crate) struct Bound {
    pub(crate) params: Vec<Param>,
    pub(crate) params_size: u32,
    pub(crate) params_in: ParamsSpace,
    pub(crate) buffers: Vec<Buffer>,
    pub(crate) signature: Signature,
    pub(crate) exports: Vec<naga::Handle<naga::Function>>,
    /// Buffers of exports that nobody named a binding for, and whose they are.
    pub(crate) unnamed: Vec<(Buffer, Span)>,
    /// Types of params members.
    members: Vec<(String, Ty)>,
}

impl Lowerer<'_> {
    pub(crate) fn storage(
        &mut self,
        name: &str,
        elem: &Ty,
        group: u32,
        binding: u32,
        writable: bool,
        span: Span,
    ) -> R<usize> {
        let base = self.naga_ty(elem, span)?;
        let stride = self.layout(base).to_stride();
        let inner = TypeInner::Array {
            base,
            size: ArraySize::Dynamic,
            stride,
        };
        let ty = self
            .module
            .types
            .insert(Type { name: None, inner }, NSpan::UNDEFINED);
        let access = if writable {
            StorageAccess::LOAD | StorageAccess::STORE
        } else {
            StorageAccess::LOAD
        };
        let handle = self.module.global_variables.append(
            GlobalVariable {
                name: Some(name.to_string()),
                space: AddressSpace::Storage { access },
                binding: Some(ResourceBinding { group, binding }),
                ty,
                init: None,
                memory_decorations: naga::MemoryDecorations::empty(),
            },
            NSpan::UNDEFINED,
        );
        self.globals.push(Global { handle });
        Ok(self.globals.len() - 1)
    }

    /// Finds the buffers behind a kernel's argument.
    fn source(
        &mut self,
        ty: &Ty,
        path: &str,
        bound: &mut Bound,
        writable: bool,
        span: Span,
    ) -> R<Source> {
        match ty {
            Ty::Slice(elem) => {
                if writable {
                    self.check_written_type(elem, &format!("the chunk `{path}`"), span)?;
                }
                let size = self.check_buffer_type(elem, "a slice", span)?;
                let binding = bound.buffers.len() as u32 + 1;
                let name = path.replace('.', "_");
                let global = self.storage(&name, elem, 0, binding, writable, span)?;
                bound.buffers.push(Buffer {
                    path: path.to_string(),
                    group: 0,
                    binding,
                    stride: size,
                    writable,
                });
                Ok(Source::Slice(global))
            }
            Ty::RefMut(_) => Err(err(
                span,
                format!(
                    "`{path}` is `&mut`, but a kernel has only its own element or chunk to write"
                ),
                "return the element, or take its chunk as `&mut [T]`",
            )),
            ty if self.holds_slices(ty, span)? => {
                let (names, types) = (self.field_names(ty), self.field_types(ty, span)?);
                let mut parts = Vec::new();
                for (name, ty) in names.iter().zip(&types) {
                    parts.push(self.source(
                        ty,
                        &format!("{path}.{name}"),
                        bound,
                        writable,
                        span,
                    )?);
                }
                Ok(Source::Parts(parts))
            }
            ty => {
                self.check_buffer_type(ty, "an argument", span)?;
                bound.members.push((path.to_string(), ty.clone()));
                Ok(Source::Param(bound.members.len() as u32 - 1))
            }
        }
    }

    /// Resolves `crate::path::function::<Args>` to an instance.
    pub(crate) fn instance(&mut self, path: &str) -> R<Instance> {
        let bad = |why: String| {
            Box::new(crate::diag::Error {
                message: why,
                span: None,
                help: Some("name it from its crate, as `my_crate::module::kernel`".into()),
                notes: Vec::new(),
            })
        };
        let parsed: syn::ExprPath =
            syn::parse_str(path).map_err(|e| bad(format!("`{path}` is not a path: {e}")))?;
        if parsed.path.segments.len() < 2 && parsed.qself.is_none() {
            return Err(bad(format!("`{path}` does not say which crate it is in")));
        }
        // From the crate's own root, where no import can hide its name.
        let mut parsed = parsed;
        let mut module = 0;
        if parsed.qself.is_none()
            && let Some(first) = parsed.path.segments.first_mut()
            && let Some(root) = self.items.crates.get(&first.ident.to_string())
        {
            module = *root;
            first.ident = syn::Ident::new("crate", first.ident.span());
        }
        let scope = crate::check::Scope {
            module,
            file: 0,
            substs: Vec::new(),
            self_ty: None,
            generic: false,
        };
        let mut c = Checker::new(self.items, scope);
        let instance = c.function_path(&parsed).map_err(|mut e| {
            // The path is the host's own text: there is no line of source to point at.
            e.span = None;
            e
        })?;
        let Some(instance) = instance else {
            return Err(bad(format!("`{path}` is not a function of the program")));
        };
        let substs: Vec<_> = instance
            .substs
            .iter()
            .map(|(n, t)| (n.clone(), c.table.zonk(t)))
            .collect();
        if let Some((name, _)) = substs.iter().find(|(_, t)| t.is_open()) {
            return Err(bad(format!(
                "the generic argument `{name}` of `{path}` is not given"
            )));
        }
        let self_ty = instance.self_ty.map(|t| c.table.zonk(&t));
        Ok(Instance {
            id: instance.id,
            substs,
            self_ty,
        })
    }

    /// The shape that an argument has when it comes straight from buffers.
    fn shape(source: &Source, chunk: bool) -> Shape {
        match source {
            Source::Param(_) => Shape::Plain,
            Source::Slice(global) => Shape::Slice {
                global: *global,
                whole: !chunk,
            },
            Source::Parts(list) => {
                Shape::Parts(list.iter().map(|s| Self::shape(s, chunk)).collect())
            }
        }
    }

    pub(crate) fn entry(&mut self, desc: &EntryDesc<'_>) -> R<Bound> {
        let instance = self.instance(desc.kernel)?;
        let items = self.items;
        let f = &items.fns[instance.id];
        let span = Span::of(f.file, &f.sig.ident);
        let body = self.body(&instance)?;
        let mut bound = Bound::default();
        let types: Vec<Ty> = body
            .params
            .iter()
            .map(|&id| body.ty(&body.locals[id].ty))
            .collect();
        if types.first() != Some(&Ty::U32) {
            return Err(err(
                span,
                "a kernel's first argument is the element's index",
                "write `id: u32` first",
            ));
        }
        for name in ["first", "count"] {
            bound.members.push((name.into(), Ty::U32));
        }
        // Which slices are chunks, the syntax says: `&mut [T]`.
        let by_type = |(arg, ty)| is_mut_reference(arg) && matches!(ty, &Ty::Slice(_));
        let chunks: Vec<bool> = f.sig.inputs.iter().zip(&types).map(by_type).collect();
        for (i, _) in chunks.iter().enumerate().filter(|(_, c)| **c) {
            let name = &body.locals[body.params[i]].name;
            bound.members.push((format!("{name}_len"), Ty::U32));
        }
        let mut sources = Vec::new();
        for (i, ty) in types.iter().enumerate().skip(1) {
            let at = Span::of(f.file, &f.sig.inputs[i]);
            let name = body.locals[body.params[i]].name.clone();
            if name == "out" || bound.members.iter().any(|(path, _)| *path == name) {
                return Err(err(
                    at,
                    format!("the entry point has an argument `{name}` of its own"),
                    "give the kernel's argument another name",
                ));
            }
            sources.push(self.source(ty, &name, &mut bound, chunks[i], at)?);
            let argument = self.argument(&f.sig.inputs[i], &name, ty, chunks[i], at)?;
            bound.signature.arguments.push(argument);
        }
        let mut shapes = vec![Shape::Plain];
        shapes.extend(
            sources
                .iter()
                .zip(&chunks[1..])
                .map(|(s, c)| Self::shape(s, *c)),
        );
        let kernel = self.function(&instance, &shapes, None, span)?;

        let out = match &kernel.ret_ty {
            Ty::Unit => None,
            ty if kernel.ret == Shape::Plain => {
                self.check_written_type(ty, "what the kernel returns", span)?;
                let stride = self.check_buffer_type(ty, "a slice", span)?;
                let binding = bound.buffers.len() as u32 + 1;
                let global = self.storage("out", ty, 0, binding, true, span)?;
                bound.signature.out = Some(self.rust_path(ty));
                bound.buffers.push(Buffer {
                    path: "out".into(),
                    group: 0,
                    binding,
                    stride,
                    writable: true,
                });
                Some(global)
            }
            _ => {
                return Err(err(
                    span,
                    "a kernel cannot return slices",
                    "return its element",
                ));
            }
        };
        if out.is_none() && !chunks.contains(&true) {
            return Err(err(
                span,
                "this kernel returns nothing and fills nothing",
                "return the element, or take its chunk as `&mut [T]`",
            ));
        }

        let mut members = Vec::new();
        for (path, ty) in &bound.members {
            let handle = self.naga_ty(ty, span)?;
            members.push((path.replace('.', "_"), handle));
            bound.params.push(Param {
                path: path.clone(),
                offset: 0,
                size: self.layout(handle).size,
            });
        }
        let (inner, params_in) = self.params_structure(members);
        bound.params_in = params_in;
        if let TypeInner::Struct { members, span } = &inner {
            bound.params_size = *span;
            for (param, member) in bound.params.iter_mut().zip(members) {
                param.offset = member.offset;
            }
        }
        let params_ty = self.module.types.insert(
            Type {
                name: Some("Params".into()),
                inner,
            },
            NSpan::UNDEFINED,
        );
        let params = self.module.global_variables.append(
            GlobalVariable {
                name: Some("params".into()),
                space: params_in.address_space(),
                binding: Some(ResourceBinding {
                    group: 0,
                    binding: 0,
                }),
                ty: params_ty,
                init: None,
                memory_decorations: naga::MemoryDecorations::empty(),
            },
            NSpan::UNDEFINED,
        );
        let function = self.entry_body(desc, &kernel, &sources, &chunks, params, out, span)?;
        self.module.entry_points.push(EntryPoint {
            name: desc.name.to_string(),
            stage: ShaderStage::Compute,
            early_depth_test: None,
            workgroup_size: [desc.workgroup_size, 1, 1],
            workgroup_size_overrides: None,
            function,
            mesh_info: None,
            task_payload: None,
            incoming_ray_payload: None,
        });
        Ok(bound)
    }

    fn entry_body(
        &mut self,
        desc: &EntryDesc<'_>,
        kernel: &crate::lower::Lowered,
        sources: &[Source],
        chunks: &[bool],
        params: naga::Handle<GlobalVariable>,
        out: Option<usize>,
        span: Span,
    ) -> R<naga::Function> {
        use naga::BinaryOperator as Op;
        let uvec3 = self.naga_ty(&Ty::Vec(crate::ty::Scalar::U32, 3), span)?;
        let mut f = FnLowerer::new(self, Rc::new(empty_body(span)), desc.name);
        for (name, built_in) in [
            ("id", BuiltIn::GlobalInvocationId),
            ("groups", BuiltIn::NumWorkGroups),
        ] {
            let binding = Some(Binding::BuiltIn(built_in));
            f.func.arguments.push(FunctionArgument {
                name: Some(name.into()),
                ty: uvec3,
                binding,
            });
        }
        let id = f.emit(Expression::FunctionArgument(0));
        let groups = f.emit(Expression::FunctionArgument(1));
        let (x, y) = (
            f.emit(Expression::AccessIndex { base: id, index: 0 }),
            f.emit(Expression::AccessIndex { base: id, index: 1 }),
        );
        let wide = f.emit(Expression::AccessIndex {
            base: groups,
            index: 0,
        });
        let size = f.emit(Expression::Literal(naga::Literal::U32(desc.workgroup_size)));
        let row = f.bin(Op::Multiply, wide, size);
        let above = f.bin(Op::Multiply, y, row);
        let local = f.bin(Op::Add, above, x);
        f.func.named_expressions.insert(local, "local".into());
        let buffer = f.emit(Expression::GlobalVariable(params));
        let read = |f: &mut FnLowerer<'_, '_>, index: u32| {
            let pointer = f.emit(Expression::AccessIndex {
                base: buffer,
                index,
            });
            f.emit(Expression::Load { pointer })
        };
        let count = read(&mut f, 1);
        let beyond = f.bin(Op::GreaterEqual, local, count);
        let mut leave = naga::Block::new();
        leave.push(Statement::Return { value: None }, NSpan::UNDEFINED);
        f.push(Statement::If {
            condition: beyond,
            accept: leave,
            reject: naga::Block::new(),
        });
        let first = read(&mut f, 0);
        let element = f.bin(Op::Add, first, local);
        let mut values = vec![Val::Plain(element)];
        let mut chunk_member = 2;
        for (source, is_chunk) in sources.iter().zip(&chunks[1..]) {
            let mut extent = None;
            if *is_chunk {
                let len = read(&mut f, chunk_member);
                chunk_member += 1;
                extent = Some((f.bin(Op::Multiply, local, len), len));
            }
            values.push(argument(&mut f, source, extent, &mut |f, i| read(f, i)));
        }
        let mut arguments = Vec::new();
        values.iter().for_each(|v| v.flatten(&mut arguments));
        let result = out.map(|_| f.emit(Expression::CallResult(kernel.handle)));
        f.push(Statement::Call {
            function: kernel.handle,
            arguments,
            result,
        });
        if let (Some(out), Some(value)) = (out, result) {
            let handle = f.l.globals[out].handle;
            let base = f.emit(Expression::GlobalVariable(handle));
            let pointer = f.emit(Expression::Access { base, index: local });
            f.push(Statement::Store { pointer, value });
        }
        Ok(f.into_function())
    }
}

/// An argument's value in the entry point.
fn argument(
    f: &mut FnLowerer<'_, '_>,
    source: &Source,
    extent: Option<(H, H)>,
    read: &mut impl FnMut(&mut FnLowerer<'_, '_>, u32) -> H,
) -> Val {
    match source {
        Source::Param(i) => Val::Plain(read(f, *i)),
        Source::Slice(global) => Val::Slice(SliceVal {
            global: *global,
            extent,
        }),
        Source::Parts(list) => {
            Val::Parts(list.iter().map(|s| argument(f, s, extent, read)).collect())
        }
    }
}

pub(crate) fn is_mut_reference(arg: &syn::FnArg) -> bool {
    match arg {
        syn::FnArg::Typed(p) => matches!(&*p.ty, syn::Type::Reference(r) if r.mutability.is_some()),
        syn::FnArg::Receiver(_) => false,
    }
}

fn empty_body(span: Span) -> Body {
    Body {
        name: String::new(),
        params: Vec::new(),
        locals: Vec::new(),
        ret: Ty::Unit,
        value: Expr {
            kind: Kind::Unit,
            ty: Ty::Unit,
            span,
        },
        table: Table::default(),
        span,
    }
}
