//! Operations of core, libm and glam.

use naga::{BinaryOperator as NBin, Expression, MathFunction as M, ScalarKind, SwizzleComponent};

use crate::diag::R;
use crate::hir::{Builtin as B, Expr, Lit};
use crate::ty::{Scalar, Ty};

use super::types::vector_size;
use super::{FnLowerer, H, Val};

impl FnLowerer<'_, '_> {
    fn math(&mut self, fun: M, args: &[H]) -> H {
        self.emit(Expression::Math {
            fun,
            arg: args[0],
            arg1: args.get(1).copied(),
            arg2: args.get(2).copied(),
            arg3: None,
        })
    }

    fn component(&mut self, base: H, index: u32) -> H {
        self.emit(Expression::AccessIndex { base, index })
    }

    fn splat(&mut self, ty: &Ty, value: H) -> H {
        match ty {
            Ty::Vec(_, n) => self.emit(Expression::Splat {
                size: vector_size(*n),
                value,
            }),
            _ => value,
        }
    }

    fn number(&mut self, ty: &Ty, v: u32) -> H {
        let lit = match ty.scalar() {
            Some(Scalar::F32) => Lit::F32(v as f32),
            Some(Scalar::I32) => Lit::I32(v as i32),
            _ => Lit::U32(v),
        };
        let h = self.lit(lit);
        self.splat(ty, h)
    }

    fn select(&mut self, condition: H, accept: H, reject: H) -> H {
        self.emit(Expression::Select {
            condition,
            accept,
            reject,
        })
    }

    fn fold(&mut self, v: H, n: u8, mut f: impl FnMut(&mut Self, H, H) -> H) -> H {
        let mut sum = self.component(v, 0);
        for i in 1..n {
            let c = self.component(v, i.into());
            sum = f(self, sum, c);
        }
        sum
    }

    pub(crate) fn builtin(&mut self, op: B, args: &[Expr], e: &Expr) -> R<Val> {
        let span = e.span;
        let ty = self.body.ty(&e.ty);
        let types: Vec<Ty> = args.iter().map(|a| self.body.ty(&a.ty)).collect();
        let mut list = Vec::new();
        for a in args {
            list.push(self.plain(a)?);
        }
        let a = list.as_slice();
        let n = match &types[0] {
            Ty::Vec(_, n) | Ty::Mat(n) => *n,
            _ => 1,
        };
        let h = match op {
            B::Math(fun) => {
                let h = self.math(fun, a);
                match fun {
                    // Rust counts in u32 whatever it counts in.
                    M::CountOneBits | M::CountLeadingZeros | M::CountTrailingZeros => {
                        self.cast(h, &types[0], &Ty::U32)
                    }
                    _ => h,
                }
            }
            B::Ldexp => {
                // Exact for normal results, as libm's is; WGSL's own may round twice below them.
                self.math(M::Ldexp, a)
            }
            B::Compose => {
                let naga_ty = self.l.naga_ty(&ty, span)?;
                self.emit(Expression::Compose {
                    ty: naga_ty,
                    components: list,
                })
            }
            B::Splat => self.splat(&ty, a[0]),
            B::Swizzle(pattern, m) => {
                let pattern = pattern.map(|i| SwizzleComponent::XYZW[i as usize]);
                self.emit(Expression::Swizzle {
                    size: vector_size(m),
                    vector: a[0],
                    pattern,
                })
            }
            B::Truncate => {
                let pattern = SwizzleComponent::XYZW;
                self.emit(Expression::Swizzle {
                    size: vector_size(n - 1),
                    vector: a[0],
                    pattern,
                })
            }
            B::Bitcast => {
                let kind = if ty == Ty::F32 {
                    ScalarKind::Float
                } else {
                    ScalarKind::Uint
                };
                self.emit(Expression::As {
                    expr: a[0],
                    kind,
                    convert: None,
                })
            }
            B::Convert => self.cast(a[0], &types[0], &ty),
            B::Recip => {
                let one = self.number(&ty, 1);
                self.bin(NBin::Divide, one, a[0])
            }
            B::ElementSum => self.fold(a[0], n, |c, l, r| c.bin(NBin::Add, l, r)),
            B::ElementProduct => self.fold(a[0], n, |c, l, r| c.bin(NBin::Multiply, l, r)),
            B::MinElement => self.fold(a[0], n, |c, l, r| c.math(M::Min, &[l, r])),
            B::MaxElement => self.fold(a[0], n, |c, l, r| c.math(M::Max, &[l, r])),
            B::SignMask => {
                let bits = self.emit(Expression::As {
                    expr: a[0],
                    kind: ScalarKind::Uint,
                    convert: None,
                });
                let whole = Ty::Vec(Scalar::U32, n);
                let by = self.number(&whole, 31);
                let signs = self.bin(NBin::ShiftRight, bits, by);
                let components = (0..n).map(|i| self.lit(Lit::U32(1 << i))).collect();
                let naga_ty = self.l.naga_ty(&whole, span)?;
                let places = self.emit(Expression::Compose {
                    ty: naga_ty,
                    components,
                });
                self.math(M::Dot, &[signs, places])
            }
            B::LengthSquared => self.math(M::Dot, &[a[0], a[0]]),
            B::DistanceSquared => {
                let d = self.bin(NBin::Subtract, a[0], a[1]);
                self.math(M::Dot, &[d, d])
            }
            B::Lerp => {
                // glam: self (1 − t) + rhs t.
                let one = self.lit(Lit::F32(1.0));
                let s = self.bin(NBin::Subtract, one, a[2]);
                let l = self.bin(NBin::Multiply, a[0], s);
                let r = self.bin(NBin::Multiply, a[1], a[2]);
                self.bin(NBin::Add, l, r)
            }
            B::MulAdd => self.math(M::Fma, a),
            B::Copysign => {
                let bits = |c: &mut Self, v: H, mask: u32| {
                    let b = c.emit(Expression::As {
                        expr: v,
                        kind: ScalarKind::Uint,
                        convert: None,
                    });
                    let mask = c.lit(Lit::U32(mask));
                    c.bin(NBin::And, b, mask)
                };
                let magnitude = bits(self, a[0], 0x7fff_ffff);
                let sign = bits(self, a[1], 0x8000_0000);
                let both = self.bin(NBin::InclusiveOr, magnitude, sign);
                self.emit(Expression::As {
                    expr: both,
                    kind: ScalarKind::Float,
                    convert: None,
                })
            }
            B::SaturatingAdd => {
                let sum = self.bin(NBin::Add, a[0], a[1]);
                let wrapped = self.bin(NBin::Less, sum, a[0]);
                let max = self.lit(Lit::U32(u32::MAX));
                self.select(wrapped, max, sum)
            }
            B::SaturatingSub => {
                let m = self.math(M::Max, &[a[0], a[1]]);
                self.bin(NBin::Subtract, m, a[1])
            }
            B::AbsDiff => {
                let high = self.math(M::Max, &[a[0], a[1]]);
                let low = self.math(M::Min, &[a[0], a[1]]);
                self.bin(NBin::Subtract, high, low)
            }
            B::RotateLeft | B::RotateRight => {
                let bits = if types[0] == Ty::I32 {
                    self.cast(a[0], &Ty::I32, &Ty::U32)
                } else {
                    a[0]
                };
                let zero = self.lit(Lit::U32(0));
                let back = self.bin(NBin::Subtract, zero, a[1]);
                use crate::hir::BinOp as O;
                let (there, other) = if op == B::RotateLeft {
                    (O::Shl, O::Shr)
                } else {
                    (O::Shr, O::Shl)
                };
                let l = self.binary(there, bits, &Ty::U32, a[1], &Ty::U32)?;
                let r = self.binary(other, bits, &Ty::U32, back, &Ty::U32)?;
                let both = self.bin(NBin::InclusiveOr, l, r);
                if types[0] == Ty::I32 {
                    self.cast(both, &Ty::U32, &Ty::I32)
                } else {
                    both
                }
            }
            B::DivCeil => {
                let q = self.bin(NBin::Divide, a[0], a[1]);
                let r = self.bin(NBin::Modulo, a[0], a[1]);
                let zero = self.lit(Lit::U32(0));
                let some = self.bin(NBin::NotEqual, r, zero);
                let one = self.lit(Lit::U32(1));
                let more = self.bin(NBin::Add, q, one);
                self.select(some, more, q)
            }
            B::IsPowerOfTwo => {
                let ones = self.math(M::CountOneBits, &[a[0]]);
                let one = self.lit(Lit::U32(1));
                self.bin(NBin::Equal, ones, one)
            }
            B::IsSome => self.component(a[0], 0),
            B::IsNone => {
                let some = self.component(a[0], 0);
                self.emit(Expression::Unary {
                    op: naga::UnaryOperator::LogicalNot,
                    expr: some,
                })
            }
            B::UnwrapOr => {
                let some = self.component(a[0], 0);
                let value = self.component(a[0], 1);
                let simple = ty.is_number() || matches!(ty, Ty::Vec(..) | Ty::Bool | Ty::Enum(_));
                if simple {
                    self.select(some, value, a[1])
                } else {
                    let result = self.variable("chosen", &ty, span)?;
                    self.push(naga::Statement::Store {
                        pointer: result,
                        value: a[1],
                    });
                    let mut accept = naga::Block::new();
                    accept.push(
                        naga::Statement::Store {
                            pointer: result,
                            value,
                        },
                        naga::Span::UNDEFINED,
                    );
                    self.push(naga::Statement::If {
                        condition: some,
                        accept,
                        reject: naga::Block::new(),
                    });
                    self.emit(Expression::Load { pointer: result })
                }
            }
            B::With(i) => {
                let naga_ty = self.l.naga_ty(&ty, span)?;
                let mut components = Vec::new();
                for k in 0..n {
                    components.push(if u32::from(k) == i {
                        a[1]
                    } else {
                        self.component(a[0], k.into())
                    });
                }
                self.emit(Expression::Compose {
                    ty: naga_ty,
                    components,
                })
            }
            B::FromDiagonal => {
                let zero = self.lit(Lit::F32(0.0));
                let column = self.l.naga_ty(&types[0], span)?;
                let mut columns = Vec::new();
                for i in 0..n {
                    let mut components = vec![zero; n as usize];
                    components[i as usize] = self.component(a[0], i.into());
                    columns.push(self.emit(Expression::Compose {
                        ty: column,
                        components,
                    }));
                }
                let naga_ty = self.l.naga_ty(&ty, span)?;
                self.emit(Expression::Compose {
                    ty: naga_ty,
                    components: columns,
                })
            }
            B::ToArray | B::FromArray => {
                let n = match (&types[0], &ty) {
                    (Ty::Vec(_, n), _) | (_, Ty::Vec(_, n)) => *n,
                    _ => 1,
                };
                let naga_ty = self.l.naga_ty(&ty, span)?;
                let components = (0..n).map(|i| self.component(a[0], i.into())).collect();
                self.emit(Expression::Compose {
                    ty: naga_ty,
                    components,
                })
            }
            B::Op(bin) => self.binary(bin, a[0], &types[0], a[1], &types[1])?,
            B::WrappingNeg => {
                let zero = self.number(&ty, 0);
                self.bin(NBin::Subtract, zero, a[0])
            }
            B::IsEmpty => {
                let zero = self.lit(Lit::U32(0));
                self.bin(NBin::Equal, a[0], zero)
            }
        };
        Ok(Val::Plain(h))
    }
}
