//! Host file: functions for shaders that are written by hand, whose slices are bound to buffers by name.

use crate::diag::{R, Span, err};
use crate::entry::{Bound, is_mut_reference};
use crate::lower::{Lowerer, Shape};
use crate::ty::Ty;
use crate::{Buffer, ExportDesc};

/// The group of buffers that nobody named a binding for.
const NO_GROUP: u32 = u32::MAX;

impl Lowerer<'_> {
    pub(crate) fn exports(&mut self, desc: &ExportDesc<'_>) -> R<Bound> {
        let items = self.items;
        let mut bound = Bound::default();
        let mut made: Vec<(String, usize, Ty)> = Vec::new();
        for (name, path) in desc.functions {
            let plain = |why: &str, help: &str| {
                Err(Box::new(crate::diag::Error {
                    message: format!("the export `{name}` {why}"),
                    span: None,
                    help: Some(help.into()),
                    notes: Vec::new(),
                }))
            };
            if name.ends_with(|c: char| c.is_ascii_digit() || c == '_')
                || syn::parse_str::<syn::Ident>(name).is_err()
            {
                return plain(
                    "would be renamed",
                    "choose a plain name that does not end in a digit or `_`",
                );
            }
            let instance = self.instance(path)?;
            let f = &items.fns[instance.id];
            let span = Span::of(f.file, &f.sig.ident);
            let body = self.body(&instance)?;
            let slice = |id: &usize| matches!(body.ty(&body.locals[*id].ty), Ty::Slice(_));
            if f.sig
                .inputs
                .iter()
                .zip(&body.params)
                .any(|(arg, id)| is_mut_reference(arg) && slice(id))
            {
                return Err(err(
                    span,
                    "an export cannot write to a slice",
                    "return the value",
                ));
            }
            let mut shapes = Vec::new();
            for &id in &body.params {
                let local = &body.locals[id];
                let ty = body.ty(&local.ty);
                let path = if local.name == "self" {
                    String::new()
                } else {
                    local.name.clone()
                };
                shapes.push(self.export_shape(&ty, &path, desc, &mut made, &mut bound, span)?);
            }
            let lowered = self.function(&instance, &shapes, Some(name), span)?;
            // It may have been lowered before, as something that another export calls.
            let taken = desc
                .functions
                .iter()
                .take_while(|(n, _)| n != name)
                .any(|(n, _)| self.module.functions[lowered.handle].name.as_deref() == Some(*n));
            if taken {
                return plain("is another export's function", "export each function once");
            }
            self.module.functions.get_mut(lowered.handle).name = Some((*name).to_string());
            bound.exports.push(lowered.handle);
            if !matches!(lowered.ret, Shape::Plain | Shape::Unit) {
                return Err(err(
                    span,
                    "an export cannot return slices",
                    "return a value",
                ));
            }
        }
        Ok(bound)
    }

    fn export_shape(
        &mut self,
        ty: &Ty,
        path: &str,
        desc: &ExportDesc<'_>,
        made: &mut Vec<(String, usize, Ty)>,
        bound: &mut Bound,
        span: Span,
    ) -> R<Shape> {
        match ty {
            Ty::Slice(elem) => {
                let name = path.replace('.', "_");
                let stride = self.check_buffer_type(elem, "a slice", span)?;
                if let Some((_, global, _)) =
                    made.iter().find(|(n, _, t)| *n == name && *t == **elem)
                {
                    return Ok(Shape::Slice {
                        global: *global,
                        whole: true,
                    });
                }
                let given = desc.buffers.iter().find(|(n, _, _)| *n == name);
                let (group, binding) = match given {
                    Some((_, group, binding)) => (*group, *binding),
                    // Enough for a slice that no export reaches.
                    None => (NO_GROUP, bound.unnamed.len() as u32),
                };
                let global = self.storage(&name, elem, group, binding, false, span)?;
                let buffer = Buffer {
                    path: name.clone(),
                    group,
                    binding,
                    stride,
                    writable: false,
                };
                match given {
                    Some(_) => bound.buffers.push(buffer),
                    None => bound.unnamed.push((buffer, span)),
                }
                made.push((name, global, (**elem).clone()));
                Ok(Shape::Slice {
                    global,
                    whole: true,
                })
            }
            Ty::RefMut(_) => Ok(Shape::Ptr),
            ty if self.holds_slices(ty, span)? => {
                let (names, types) = (self.field_names(ty), self.field_types(ty, span)?);
                let mut parts = Vec::new();
                for (name, ty) in names.iter().zip(&types) {
                    let below = if path.is_empty() {
                        name.clone()
                    } else {
                        format!("{path}.{name}")
                    };
                    parts.push(self.export_shape(ty, &below, desc, made, bound, span)?);
                }
                Ok(Shape::Parts(parts))
            }
            _ => Ok(Shape::Plain),
        }
    }
}
