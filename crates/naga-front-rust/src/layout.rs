//! Whether a type has the same bytes in Rust and in WGSL.

use crate::diag::{Error, R, Span, err};
use crate::items::reprs;
use crate::lower::Lowerer;
use crate::ty::{Scalar, Ty};

/// Size and alignment.
type Layout = (u32, u32);

#[derive(Clone, Copy, PartialEq, Eq)]
enum Rules {
    Wgsl,
    /// Rust, with this alignment for `Vec4` and `Mat4`: glam's depends on the target.
    Rust(u32),
}

fn round_up(n: u32, align: u32) -> u32 {
    n.div_ceil(align) * align
}

impl Lowerer<'_> {
    /// Refuses a type that cannot lie in a buffer, with the reason.
    pub(crate) fn check_buffer_type(&mut self, ty: &Ty, what: &str, span: Span) -> R<u32> {
        if let Ty::Vec(_, 3) = ty
            && what.contains("slice")
        {
            return Err(err(
                span,
                format!(
                    "{what} of `{}` has elements of 12 bytes in Rust and of 16 in WGSL",
                    ty.show(self.items)
                ),
                "use Vec4, or a struct of three f32",
            ));
        }
        let wgsl = self.sizes(ty, Rules::Wgsl, span)?;
        for rust in [Rules::Rust(16), Rules::Rust(4)] {
            let size = self.sizes(ty, rust, span)?;
            let as_element = what.contains("slice") || matches!(ty, Ty::Struct(..));
            if size.0 != wgsl.0 && as_element {
                return Err(err(
                    span,
                    format!(
                        "`{}` takes {} bytes in Rust and {} in WGSL",
                        ty.show(self.items),
                        size.0,
                        wgsl.0
                    ),
                    "add padding fields until both agree, whether Vec4 is aligned to 4 or to 16 bytes",
                ));
            }
        }
        Ok(wgsl.0)
    }

    fn sizes(&mut self, ty: &Ty, rules: Rules, span: Span) -> R<Layout> {
        let layout = match ty {
            Ty::F32 | Ty::I32 | Ty::U32 => (4, 4),
            Ty::Vec(s, n) => {
                let size = 4 * u32::from(*n);
                match (rules, n) {
                    (Rules::Wgsl, 2) => (size, 8),
                    (Rules::Wgsl, _) => (size, 16),
                    (Rules::Rust(align), 4) if *s == Scalar::F32 => (size, align),
                    (Rules::Rust(_), _) => (size, 4),
                }
            }
            Ty::Mat(n) => match (rules, n) {
                (Rules::Wgsl, 2) => (16, 8),
                (Rules::Wgsl, 3) => (48, 16),
                (Rules::Wgsl, _) => (64, 16),
                (Rules::Rust(align), 2) => (16, align),
                (Rules::Rust(_), 3) => (36, 4),
                (Rules::Rust(align), _) => (64, align),
            },
            Ty::Array(elem, len) => {
                let (size, align) = self.sizes(elem, rules, span)?;
                let Ty::Const(n) = **len else {
                    return Err(err(span, "this array's length is not known", "annotate it"));
                };
                let stride = round_up(size, align);
                if rules == Rules::Wgsl && stride != self.sizes(elem, Rules::Rust(4), span)?.0 {
                    return Err(err(
                        span,
                        format!(
                            "the elements of `{}` lie {stride} bytes apart in WGSL and closer in Rust",
                            ty.show(self.items)
                        ),
                        "use elements of four components",
                    ));
                }
                (stride * n, align)
            }
            Ty::Struct(id, _) => return self.struct_sizes(*id, ty, rules, span),
            Ty::Enum(id) => self.enum_sizes(*id)?,
            _ => {
                return Err(err(
                    span,
                    format!("`{}` cannot lie in a buffer", ty.show(self.items)),
                    "buffers hold f32, u32, i32, fieldless #[repr(u32)] enums, glam vectors and matrices, arrays and #[repr(C)] structs of these",
                ));
            }
        };
        Ok(layout)
    }

    fn enum_sizes(&self, id: usize) -> R<Layout> {
        self.items.enum_numbers(id)?;
        if self.items.is_u32_enum(id) {
            return Ok((4, 4));
        }
        let item = &self.items.enums[id];
        Err(err(
            Span::of(item.file, &item.item.ident),
            format!(
                "`{}` lies in a buffer, but only #[repr(u32)] makes an enum a `u32` in Rust",
                item.item.ident
            ),
            "add #[repr(u32)], and no other `repr`",
        ))
    }

    /// Refuses a type that the GPU writes and the host reads where it holds an enum: buffers may hold any number, and Rust must
    /// never see an enum that is none of its variants. Enums only go up.
    pub(crate) fn check_written_type(&mut self, ty: &Ty, what: &str, span: Span) -> R<()> {
        let Some(id) = self.enum_in(ty, span)? else {
            return Ok(());
        };
        let name = &self.items.enums[id].item.ident;
        Err(err(
            span,
            format!(
                "{what} holds the enum `{name}`: what is read back from a GPU may be any number, and not each is a variant of `{name}`"
            ),
            format!(
                "store a `u32`, `value as u32`, and let the host check it; a kernel may only read `{name}` from buffers"
            ),
        ))
    }

    /// An enum that is part of a value of this type.
    fn enum_in(&mut self, ty: &Ty, span: Span) -> R<Option<usize>> {
        match ty {
            Ty::Enum(id) => Ok(Some(*id)),
            Ty::Array(element, _) => self.enum_in(element, span),
            Ty::Struct(..) => {
                for field in self.field_types(ty, span)? {
                    if let Some(id) = self.enum_in(&field, span)? {
                        return Ok(Some(id));
                    }
                }
                Ok(None)
            }
            _ => Ok(None),
        }
    }

    fn struct_sizes(&mut self, id: usize, ty: &Ty, rules: Rules, span: Span) -> R<Layout> {
        let items = self.items;
        let item = &items.structs[id];
        let at = Span::of(item.file, &item.item.ident);
        let reprs = reprs(&item.item.attrs);
        if let Some(other) = reprs.iter().find(|r| *r != "C") {
            return Err(err(
                at,
                format!(
                    "`{}` lies in a buffer, and WGSL has nothing like `repr({other})`",
                    ty.show(items)
                ),
                "write #[repr(C)] alone, and pad with fields",
            ));
        }
        let repr_c = !reprs.is_empty();
        if !repr_c {
            return Err(err(
                at,
                format!(
                    "`{}` lies in a buffer, but Rust may order its fields as it likes",
                    ty.show(items)
                ),
                "add #[repr(C)]",
            ));
        }
        let types = self.field_types(ty, span)?;
        if types.is_empty() {
            return Err(err(
                at,
                "an empty struct cannot lie in a buffer",
                "leave it away",
            ));
        }
        let offsets = |c: &mut Self, rules: Rules| -> R<(Vec<u32>, Layout)> {
            let (mut offset, mut alignment) = (0, 1);
            let mut list = Vec::new();
            for t in &types {
                let (size, align) = c.sizes(t, rules, at)?;
                offset = round_up(offset, align);
                list.push(offset);
                offset += size;
                alignment = alignment.max(align);
            }
            Ok((list, (round_up(offset, alignment), alignment)))
        };
        let (own, layout) = offsets(self, rules)?;
        if rules == Rules::Wgsl {
            for rust in [Rules::Rust(16), Rules::Rust(4)] {
                let (theirs, their_layout) = offsets(self, rust)?;
                if own != theirs || layout.0 != their_layout.0 {
                    let names = self.field_names(ty);
                    let mut notes: Vec<String> = Vec::new();
                    for ((name, w), r) in names.iter().zip(&own).zip(&theirs) {
                        notes.push(format!("field `{name}`: offset {r} in Rust, {w} in WGSL"));
                    }
                    notes.push(format!(
                        "size: {} in Rust, {} in WGSL",
                        their_layout.0, layout.0
                    ));
                    return Err(Box::new(Error {
                        message: format!("`{}` has other bytes in WGSL than in Rust", ty.show(items)),
                        span: Some(at),
                        help: Some(
                            "order the fields, or add padding, so that Vec2 lies at a multiple of 8, Vec3 and Vec4 at multiples of 16, and the size is a multiple of the largest"
                                .into(),
                        ),
                        notes,
                    }));
                }
            }
        }
        if rules == Rules::Wgsl && item.item.generics.params.is_empty() {
            let path = format!("{}::{}", items.modules[item.module].path, item.item.ident);
            let fields = self.field_names(ty).into_iter().zip(own).collect();
            let known = crate::StructLayout {
                path: path.clone(),
                size: layout.0,
                fields,
            };
            self.buffer_structs.insert(path, known);
        }
        Ok(layout)
    }
}
