//! Host file: where `params` lies: in a uniform buffer where WGSL allows its members there, else in a storage buffer.
//!
//! In a uniform buffer structs and arrays begin at multiples of 16, elements of arrays lie at multiples of 16, and what follows
//! a struct begins at a multiple of 16 (WGSL § 14.4.1, Address Space Layout Constraints).

use naga::proc::{Alignment, Layouter};
use naga::{AddressSpace, Handle, Module, StorageAccess, Type, TypeInner};

use crate::lower::Lowerer;

/// The kind of buffer that `params` is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum ParamsSpace {
    /// A uniform buffer.
    #[default]
    Uniform,
    /// A read-only storage buffer: a member holds what a uniform buffer cannot, as `[f32; 6]`, or all are larger than 64 KiB.
    Storage,
}

impl ParamsSpace {
    pub(crate) fn address_space(self) -> AddressSpace {
        match self {
            ParamsSpace::Uniform => AddressSpace::Uniform,
            ParamsSpace::Storage => AddressSpace::Storage {
                access: StorageAccess::LOAD,
            },
        }
    }
}

/// What WebGPU promises for `maxUniformBufferBindingSize`.
const MOST_BYTES: u32 = 64 << 10;
const STEP: Alignment = Alignment::MIN_UNIFORM;

impl Lowerer<'_> {
    /// The struct of these members, as a uniform buffer holds it if one can.
    pub(crate) fn params_structure(
        &mut self,
        members: Vec<(String, Handle<Type>)>,
    ) -> (TypeInner, ParamsSpace) {
        let can_hold = members.iter().all(|(_, ty)| fits(&self.module, *ty));
        let mut inner = self.structure(members);
        if can_hold
            && let TypeInner::Struct {
                ref mut members,
                ref mut span,
            } = inner
        {
            let mut end = 0;
            for member in members.iter_mut() {
                let layout = self.layout(member.ty);
                let ty = &self.module.types[member.ty].inner;
                let alignment = match ty {
                    TypeInner::Struct { .. } | TypeInner::Array { .. } => STEP,
                    _ => layout.alignment,
                };
                member.offset = alignment.max(layout.alignment).round_up(end);
                end = member.offset + size_in_uniform(ty, layout.size);
            }
            let size = STEP.round_up(end);
            if size <= MOST_BYTES {
                *span = size;
                return (inner, ParamsSpace::Uniform);
            }
            // Back to a storage buffer's offsets.
            let names = members.iter().map(|m| m.name.clone().unwrap_or_default());
            let again = names.zip(members.iter().map(|m| m.ty)).collect();
            inner = self.structure(again);
        }
        (inner, ParamsSpace::Storage)
    }
}

/// Bytes to where the next member may begin.
fn size_in_uniform(ty: &TypeInner, size: u32) -> u32 {
    match ty {
        TypeInner::Struct { .. } => STEP.round_up(size),
        _ => size,
    }
}

/// Whether a uniform buffer may hold a value of this type.
fn fits(module: &Module, ty: Handle<Type>) -> bool {
    match &module.types[ty].inner {
        TypeInner::Array { base, stride, .. } => STEP.is_aligned(*stride) && fits(module, *base),
        TypeInner::Struct { members, .. } => {
            let mut end = 0;
            members.iter().all(|member| {
                let inner = &module.types[member.ty].inner;
                let is_placed = match inner {
                    TypeInner::Struct { .. } | TypeInner::Array { .. } => {
                        STEP.is_aligned(member.offset)
                    }
                    _ => true,
                };
                let is_clear = member.offset >= end;
                end = match inner {
                    TypeInner::Struct { span, .. } => member.offset + size_in_uniform(inner, *span),
                    _ => 0,
                };
                is_placed && is_clear && fits(module, member.ty)
            })
        }
        _ => true,
    }
}

/// Which members of the params struct WGSL would not place where they lie, had they no attribute: they need `@align(16)`.
pub(crate) fn needs_alignment(module: &Module) -> Vec<bool> {
    let mut globals = module.global_variables.iter().map(|(_, global)| global);
    let uniform = globals.find(|global| global.space == AddressSpace::Uniform);
    let Some(TypeInner::Struct { members, .. }) =
        uniform.map(|global| &module.types[global.ty].inner)
    else {
        return Vec::new();
    };
    let mut layouter = Layouter::default();
    layouter
        .update(module.to_ctx())
        .expect("the module was validated");
    let mut end = 0;
    let needs = |member: &naga::StructMember| {
        let layout = layouter[member.ty];
        let plain = layout.alignment.round_up(end);
        end = member.offset + layout.size;
        plain != member.offset
    };
    members.iter().map(needs).collect()
}

#[cfg(test)]
mod tests {
    use naga::TypeInner;

    use super::ParamsSpace;
    use crate::{CrateSource, EntryDesc, Program, Shader};

    fn shader(arguments: &str) -> Shader {
        let text = format!(
            "#[repr(C)] pub struct Five {{ pub a: f32, pub b: f32, pub c: f32, pub d: f32, pub e: f32 }}
             #[repr(C)] pub struct Six {{ pub list: [f32; 6] }}
             #[repr(C)] pub struct Pair {{ pub five: Five, pub after: f32 }}
             #[repr(C)] pub struct Params {{ pub rows: [glam::Vec4; 3] }}
             pub fn k(id: u32, {arguments}) -> u32 {{ id }}"
        );
        let files = [("lib.rs", text.as_str())];
        let program = Program::parse(&[CrateSource {
            name: "krate",
            files: &files,
        }])
        .unwrap_or_else(|e| panic!("{e}"));
        program
            .entry(&EntryDesc {
                name: "entry",
                kernel: "krate::k",
                workgroup_size: 64,
            })
            .unwrap_or_else(|e| panic!("{e}"))
    }

    fn offsets(shader: &Shader) -> Vec<(&str, u32)> {
        let params = shader.params.iter();
        params.map(|p| (p.path.as_str(), p.offset)).collect()
    }

    /// Offsets of the struct that the text's `params` is.
    fn written_offsets(shader: &Shader) -> Vec<u32> {
        let module = naga::front::wgsl::parse_str(&shader.wgsl).expect("naga reads what it wrote");
        crate::wgsl::validate(&module).unwrap_or_else(|e| panic!("{}\n{}", e.message, shader.wgsl));
        let (_, params) = module
            .global_variables
            .iter()
            .find(|(_, global)| global.name.as_deref() == Some("params"))
            .expect("params");
        match &module.types[params.ty].inner {
            TypeInner::Struct { members, .. } => members.iter().map(|m| m.offset).collect(),
            other => panic!("{other:?}"),
        }
    }

    #[test]
    fn members_lie_where_a_uniform_buffer_wants_them() {
        let made = shader(
            "x: u32, five: &Five, y: u32, rows: &Params, z: f32, v: glam::Vec3, w: f32, last: &Five",
        );
        assert_eq!(made.params_in, ParamsSpace::Uniform);
        let expected = [
            ("first", 0),
            ("count", 4),
            ("x", 8),
            // A struct begins at a multiple of 16, and so does what follows it.
            ("five", 16),
            ("y", 48),
            ("rows", 64),
            ("z", 112),
            ("v", 128),
            ("w", 140),
            ("last", 144),
        ];
        assert_eq!(offsets(&made), expected);
        assert_eq!(made.params_size, 176);
        assert!(made.wgsl.contains("var<uniform> params:"), "{}", made.wgsl);
        assert_eq!(written_offsets(&made), expected.map(|(_, offset)| offset));
    }

    #[test]
    fn what_a_uniform_buffer_cannot_hold_lies_in_a_storage_buffer() {
        for arguments in ["six: &Six, y: u32", "list: [u32; 4]", "pair: &Pair"] {
            let made = shader(arguments);
            assert_eq!(made.params_in, ParamsSpace::Storage, "{arguments}");
            assert!(made.wgsl.contains("var<storage> params:"), "{}", made.wgsl);
            // Without gaps.
            assert_eq!(made.params[2].offset, 8, "{arguments}");
            let of_shader: Vec<u32> = made.params.iter().map(|p| p.offset).collect();
            assert_eq!(written_offsets(&made), of_shader);
        }
    }

    #[test]
    fn a_uniform_buffer_ends_at_64_kib() {
        let rows = |n: u32| shader(&format!("five: &Five, rows: [glam::Vec4; {n}]"));
        // `first`, `count` and `five` take 48 bytes.
        let most = rows(4093);
        assert_eq!(most.params_in, ParamsSpace::Uniform);
        assert_eq!(most.params_size, 64 << 10);
        let more = rows(4094);
        assert_eq!(more.params_in, ParamsSpace::Storage);
        assert_eq!(offsets(&more)[2..], [("five", 8), ("rows", 32)]);
    }
}
