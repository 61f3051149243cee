//! naga types for the subset's types.

use std::num::NonZeroU32;

use naga::{ArraySize, Handle, Scalar as NScalar, StructMember, Type, TypeInner, VectorSize};

use crate::check::{Checker, Scope};
use crate::diag::{R, Span, err};
use crate::ty::{Scalar, Ty};

use super::Lowerer;

pub(crate) fn vector_size(n: u8) -> VectorSize {
    match n {
        2 => VectorSize::Bi,
        3 => VectorSize::Tri,
        _ => VectorSize::Quad,
    }
}

pub(crate) fn scalar(s: Scalar) -> NScalar {
    match s {
        Scalar::F32 => NScalar::F32,
        Scalar::I32 => NScalar::I32,
        Scalar::U32 => NScalar::U32,
    }
}

impl Lowerer<'_> {
    /// The types of a struct's or tuple's fields.
    pub(crate) fn field_types(&mut self, ty: &Ty, span: Span) -> R<Vec<Ty>> {
        if let Some(list) = self.fields.get(ty) {
            return Ok(list.clone());
        }
        let list = match ty {
            Ty::Tuple(list) => list.clone(),
            Ty::Struct(id, _) => {
                let item = &self.items.structs[*id];
                let scope = Scope {
                    module: item.module,
                    file: item.file,
                    substs: Vec::new(),
                    self_ty: None,
                    generic: false,
                };
                let mut c = Checker::new(self.items, scope);
                let n = item.item.fields.len();
                (0..n)
                    .map(|i| c.struct_field(ty, i, span))
                    .collect::<R<Vec<_>>>()?
            }
            _ => Vec::new(),
        };
        self.fields.insert(ty.clone(), list.clone());
        Ok(list)
    }

    /// Whether a value of this type holds slices, and so is not one value on the GPU.
    pub(crate) fn holds_slices(&mut self, ty: &Ty, span: Span) -> R<bool> {
        match ty {
            Ty::Slice(_) => Ok(true),
            Ty::Tuple(_) | Ty::Struct(..) => {
                for t in self.field_types(ty, span)? {
                    if self.holds_slices(&t, span)? {
                        return Ok(true);
                    }
                }
                Ok(false)
            }
            _ => Ok(false),
        }
    }

    /// Whether a value of this type holds an array, and so is better kept in a variable.
    pub(crate) fn holds_array(&mut self, ty: &Ty, span: Span) -> R<bool> {
        match ty {
            Ty::Array(..) => Ok(true),
            Ty::Option(t) => self.holds_array(t, span),
            Ty::Tuple(_) | Ty::Struct(..) => {
                for t in self.field_types(ty, span)? {
                    if self.holds_array(&t, span)? {
                        return Ok(true);
                    }
                }
                Ok(false)
            }
            _ => Ok(false),
        }
    }

    pub(crate) fn naga_ty(&mut self, ty: &Ty, span: Span) -> R<Handle<Type>> {
        if let Some(h) = self.types.get(ty) {
            return Ok(*h);
        }
        let (name, inner) = match ty {
            Ty::Bool => (None, TypeInner::Scalar(NScalar::BOOL)),
            Ty::F32 => (None, TypeInner::Scalar(NScalar::F32)),
            Ty::I32 | Ty::IntVar(_) => (None, TypeInner::Scalar(NScalar::I32)),
            Ty::U32 | Ty::Usize => (None, TypeInner::Scalar(NScalar::U32)),
            Ty::Enum(id) => {
                self.items.enum_numbers(*id)?;
                (None, TypeInner::Scalar(NScalar::U32))
            }
            Ty::Vec(s, n) => (
                None,
                TypeInner::Vector {
                    size: vector_size(*n),
                    scalar: scalar(*s),
                },
            ),
            Ty::Mat(n) => {
                let size = vector_size(*n);
                (
                    None,
                    TypeInner::Matrix {
                        columns: size,
                        rows: size,
                        scalar: NScalar::F32,
                    },
                )
            }
            Ty::Array(elem, len) => {
                let Ty::Const(n) = **len else {
                    return Err(err(
                        span,
                        "this array's length is not known",
                        "annotate its type",
                    ));
                };
                let n = NonZeroU32::new(n).ok_or_else(|| {
                    err(
                        span,
                        "an array of no elements cannot be lowered",
                        "WGSL has none: leave it away",
                    )
                })?;
                let base = self.naga_ty(elem, span)?;
                let stride = self.layout(base).to_stride();
                (
                    None,
                    TypeInner::Array {
                        base,
                        size: ArraySize::Constant(n),
                        stride,
                    },
                )
            }
            Ty::Option(inner) => {
                let flag = self.naga_ty(&Ty::Bool, span)?;
                let value = self.naga_ty(inner, span)?;
                let name = format!("Option_{}", self.type_name(inner));
                (
                    Some(name),
                    self.structure(vec![("is_some".into(), flag), ("value".into(), value)]),
                )
            }
            Ty::Tuple(list) => {
                let mut members = Vec::new();
                for (i, t) in list.iter().enumerate() {
                    members.push((
                        format!(
                            "f{}",
                            ["a", "b", "c", "d", "e", "f", "g", "h"]
                                .get(i)
                                .copied()
                                .unwrap_or("z")
                        ),
                        self.naga_ty(t, span)?,
                    ));
                }
                (Some(self.type_name(ty)), self.structure(members))
            }
            Ty::Struct(id, _) => {
                let items = self.items;
                let item = &items.structs[*id];
                let types = self.field_types(ty, span)?;
                if types.is_empty() {
                    // WGSL has no empty struct: a marker's one member is never read.
                    let flag = self.naga_ty(&Ty::U32, span)?;
                    (
                        Some(self.type_name(ty)),
                        self.structure(vec![("empty".into(), flag)]),
                    )
                } else {
                    let mut members = Vec::new();
                    for (i, (field, t)) in item.item.fields.iter().zip(&types).enumerate() {
                        let at = Span::of(item.file, field);
                        if *t == Ty::Unit {
                            return Err(err(
                                at,
                                "a field of type `()` cannot be lowered",
                                "leave it away",
                            ));
                        }
                        let name = field
                            .ident
                            .as_ref()
                            .map_or_else(|| format!("f{i}_"), |n| n.to_string());
                        members.push((name, self.naga_ty(t, at)?));
                    }
                    (Some(self.type_name(ty)), self.structure(members))
                }
            }
            Ty::Slice(_) => {
                return Err(err(
                    span,
                    "a slice cannot be part of this value",
                    "slices live in views: structs that are passed on, never stored, chosen or put in arrays",
                ));
            }
            Ty::RefMut(_) => {
                return Err(err(
                    span,
                    "`&mut` cannot be part of a value",
                    "pass it as an argument of its own",
                ));
            }
            Ty::Var(_) | Ty::FloatVar(_) => {
                return Err(err(span, "this type is not known", "annotate it"));
            }
            Ty::Unit | Ty::Never | Ty::Const(_) => {
                return Err(err(span, "`()` cannot be part of a value", "leave it away"));
            }
        };
        let handle = self
            .module
            .types
            .insert(Type { name, inner }, naga::Span::UNDEFINED);
        self.types.insert(ty.clone(), handle);
        Ok(handle)
    }

    pub(crate) fn layout(&mut self, ty: Handle<Type>) -> naga::proc::TypeLayout {
        self.layouter
            .update(self.module.to_ctx())
            .expect("every member type was made by `naga_ty`");
        self.layouter[ty]
    }

    /// A struct with WGSL's own offsets.
    pub(crate) fn structure(&mut self, members: Vec<(String, Handle<Type>)>) -> TypeInner {
        let mut offset = 0;
        let mut alignment = naga::proc::Alignment::ONE;
        let mut list = Vec::new();
        for (name, ty) in members {
            let layout = self.layout(ty);
            offset = layout.alignment.round_up(offset);
            alignment = alignment.max(layout.alignment);
            list.push(StructMember {
                name: Some(name),
                ty,
                binding: None,
                offset,
            });
            offset += layout.size;
        }
        TypeInner::Struct {
            members: list,
            span: alignment.round_up(offset),
        }
    }

    /// A name for a type in the shader.
    fn type_name(&self, ty: &Ty) -> String {
        let shown = match ty {
            Ty::Tuple(list) => {
                let parts: Vec<String> = list.iter().map(|t| self.type_name(t)).collect();
                format!("Tuple_{}", parts.join("_"))
            }
            ty => ty.show(self.items),
        };
        let clean: String = shown
            .chars()
            .map(|c| if c.is_alphanumeric() { c } else { '_' })
            .collect();
        let mut name = String::new();
        for part in clean.split('_').filter(|p| !p.is_empty()) {
            if !name.is_empty() {
                name.push('_');
            }
            name.push_str(part);
        }
        name
    }
}
