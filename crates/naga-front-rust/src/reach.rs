//! Host file: leaves out of a module what its entry point, or its exports, never reach. A host binds only what is left.

use naga::compact::{KeepUnused, compact};
use naga::{
    EntryPoint, Expression, Function, GlobalVariable, Handle, LocalVariable, Module,
    ResourceBinding, ShaderStage, Span, Statement, TypeInner,
};

use crate::Buffer;
use crate::diag::{R, err};
use crate::entry::Bound;
use crate::wgsl::validate;

/// Removes what is not reached, and numbers the buffers of an entry point 1, 2, … again. Exports keep the bindings that their
/// author chose.
pub(crate) fn keep_reached(module: &mut Module, bound: &mut Bound) -> R<()> {
    // `compact` panics on a module that is not valid.
    validate(module)?;
    let has_entry_point = !module.entry_points.is_empty();
    if !has_entry_point {
        let root = calls_all(module, &bound.exports);
        module.entry_points.push(root);
    }
    compact(module, KeepUnused::No);
    if !has_entry_point {
        module.entry_points.clear();
    }
    let is_left = |buffer: &Buffer| {
        let mut globals = module.global_variables.iter();
        globals.any(|(_, global)| is_buffer(module, global, buffer))
    };
    if let Some((buffer, span)) = bound.unnamed.iter().find(|(buffer, _)| is_left(buffer)) {
        return Err(err(
            *span,
            format!("the buffer `{}` has no binding", buffer.path),
            "name its group and binding in `ExportDesc::buffers`",
        ));
    }
    bound.buffers.retain(is_left);
    if has_entry_point {
        renumber(module, &mut bound.buffers);
    }
    Ok(())
}

fn is_buffer(module: &Module, global: &GlobalVariable, buffer: &Buffer) -> bool {
    let binding = ResourceBinding {
        group: buffer.group,
        binding: buffer.binding,
    };
    // Exports may bind slices of several types to one buffer.
    let stride = match module.types[global.ty].inner {
        TypeInner::Array { stride, .. } => Some(stride),
        _ => None,
    };
    global.binding == Some(binding) && stride == Some(buffer.stride)
}

fn renumber(module: &mut Module, buffers: &mut [Buffer]) {
    for (binding, buffer) in (1..).zip(buffers) {
        for (_, global) in module.global_variables.iter_mut() {
            // Upwards, to numbers no larger than before: none is met twice.
            if let Some(at) = &mut global.binding
                && at.binding == buffer.binding
            {
                at.binding = binding;
            }
        }
        buffer.binding = binding;
    }
}

/// An entry point that calls every export, so that what they reach is reached.
fn calls_all(module: &Module, exports: &[Handle<Function>]) -> EntryPoint {
    let mut root = Function::default();
    for &function in exports {
        let callee = &module.functions[function];
        let mut arguments = Vec::new();
        for argument in &callee.arguments {
            let value = match module.types[argument.ty].inner {
                TypeInner::Pointer { base: ty, .. } => {
                    let variable = LocalVariable {
                        name: None,
                        ty,
                        init: None,
                    };
                    Expression::LocalVariable(
                        root.local_variables.append(variable, Span::UNDEFINED),
                    )
                }
                _ => Expression::ZeroValue(argument.ty),
            };
            arguments.push(root.expressions.append(value, Span::UNDEFINED));
        }
        let result = callee.result.as_ref().map(|_| {
            let result = Expression::CallResult(function);
            root.expressions.append(result, Span::UNDEFINED)
        });
        let call = Statement::Call {
            function,
            arguments,
            result,
        };
        root.body.push(call, Span::UNDEFINED);
    }
    EntryPoint {
        name: "root".into(),
        stage: ShaderStage::Compute,
        early_depth_test: None,
        workgroup_size: [1, 1, 1],
        workgroup_size_overrides: None,
        function: root,
        mesh_info: None,
        task_payload: None,
        incoming_ray_payload: None,
    }
}

#[cfg(test)]
mod tests {
    use crate::{CrateSource, EntryDesc, ExportDesc, Program};

    const LIBRARY: &str = "
        pub struct Tables<'a> { pub edges: &'a [u32], pub texels: &'a [glam::Vec4], pub names: &'a [f32] }
        impl<'a> Tables<'a> {
            pub fn length(&self) -> u32 { self.names.len() as u32 }
            pub fn edge(&self, i: u32) -> u32 { self.edges[i as usize] }
        }
        pub fn kernel(id: u32, idle: &[u32], tables: Tables<'_>, cells: &mut [f32]) -> u32 {
            tables.length() + cells.len() as u32
        }";

    fn program() -> Program {
        let files = [("lib.rs", LIBRARY)];
        let library = CrateSource {
            name: "library",
            files: &files,
        };
        Program::parse(&[library]).unwrap_or_else(|e| panic!("{e}"))
    }

    #[test]
    fn slices_that_a_kernel_never_reaches_are_not_bound() {
        let entry = EntryDesc {
            name: "entry",
            kernel: "library::kernel",
            workgroup_size: 64,
        };
        let shader = program().entry(&entry).unwrap_or_else(|e| panic!("{e}"));
        let left: Vec<_> = shader
            .buffers
            .iter()
            .map(|b| (b.path.as_str(), b.binding))
            .collect();
        // A length alone needs the buffer; that of a chunk is an argument.
        assert_eq!(left, [("tables.names", 1), ("out", 2)]);
        let bindings = shader.wgsl.matches("@binding(").count();
        assert_eq!(bindings, 3, "{}", shader.wgsl);
        assert_eq!(shader.module.global_variables.len(), 3);
    }

    #[test]
    fn exports_bind_what_they_reach_where_their_author_says() {
        let edge = [("edge", "library::Tables::edge")];
        let both = [edge[0], ("count", "library::Tables::length")];
        let buffers = [("edges", 1, 7), ("texels", 1, 8)];
        let program = program();
        let shader = program
            .exports(&ExportDesc {
                functions: &edge,
                buffers: &buffers,
            })
            .unwrap_or_else(|e| panic!("{e}"));
        let left: Vec<_> = shader
            .buffers
            .iter()
            .map(|b| (b.path.as_str(), b.group, b.binding))
            .collect();
        assert_eq!(left, [("edges", 1, 7)]);
        assert!(shader.module.entry_points.is_empty());

        let error = program
            .exports(&ExportDesc {
                functions: &both,
                buffers: &buffers,
            })
            .expect_err("`names` has no binding and is reached");
        let text = error.to_string();
        assert!(text.contains("the buffer `names` has no binding"), "{text}");
    }
}
