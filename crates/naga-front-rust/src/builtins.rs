//! What the front end knows of `core`, `libm` and `glam`: names, and the operation that each stands for.

use naga::MathFunction as M;

use crate::hir::{BinOp, Builtin as B, Lit};
use crate::ty::{Scalar, Ty};

/// A glam type by its name.
pub(crate) fn glam_type(name: &str) -> Option<Ty> {
    let n = name
        .chars()
        .last()?
        .to_digit(10)
        .filter(|n| (2..=4).contains(n))? as u8;
    Some(match &name[..name.len() - 1] {
        "Vec" => Ty::Vec(Scalar::F32, n),
        "UVec" => Ty::Vec(Scalar::U32, n),
        "IVec" => Ty::Vec(Scalar::I32, n),
        "Mat" => Ty::Mat(n),
        _ => return None,
    })
}

/// A primitive type by its name.
pub(crate) fn primitive(name: &str) -> Option<Ty> {
    Some(match name {
        "f32" => Ty::F32,
        "i32" => Ty::I32,
        "u32" => Ty::U32,
        "usize" => Ty::Usize,
        "bool" => Ty::Bool,
        _ => return None,
    })
}

/// Whether a glob import of glam or libm brings this path.
pub(crate) fn is_known_extern(path: &str) -> bool {
    match path.split_once("::") {
        Some(("glam", name)) => glam_type(name).is_some() || glam_short(name).is_some(),
        Some(("libm", name)) => libm(name).is_some(),
        Some(("core", "f32::consts")) => true,
        Some(("core", rest)) => rest
            .strip_prefix("f32::consts::")
            .is_some_and(|n| consts_f32(n).is_some()),
        _ => false,
    }
}

/// glam's free constructors: `vec3(x, y, z)`.
pub(crate) fn glam_short(name: &str) -> Option<Ty> {
    let mut upper = name.to_string();
    let first = if name.starts_with('u') || name.starts_with('i') {
        2
    } else {
        1
    };
    if !name.is_ascii() || name.len() < 4 || name != name.to_lowercase() {
        return None;
    }
    upper.replace_range(..first, &name[..first].to_uppercase());
    glam_type(&upper).filter(|t| matches!(t, Ty::Vec(..)))
}

/// A function of `libm` on `f32`: the operation and how many arguments it takes.
pub(crate) fn libm(name: &str) -> Option<(B, usize)> {
    let one = |m| Some((B::Math(m), 1));
    match name {
        "sqrtf" => one(M::Sqrt),
        "sinf" => one(M::Sin),
        "cosf" => one(M::Cos),
        "tanf" => one(M::Tan),
        "asinf" => one(M::Asin),
        "acosf" => one(M::Acos),
        "atanf" => one(M::Atan),
        "sinhf" => one(M::Sinh),
        "coshf" => one(M::Cosh),
        "tanhf" => one(M::Tanh),
        "expf" => one(M::Exp),
        "exp2f" => one(M::Exp2),
        "logf" => one(M::Log),
        "log2f" => one(M::Log2),
        "fabsf" => one(M::Abs),
        "floorf" => one(M::Floor),
        "ceilf" => one(M::Ceil),
        "truncf" => one(M::Trunc),
        "atan2f" => Some((B::Math(M::Atan2), 2)),
        "powf" => Some((B::Math(M::Pow), 2)),
        "fminf" => Some((B::Math(M::Min), 2)),
        "fmaxf" => Some((B::Math(M::Max), 2)),
        "ldexpf" => Some((B::Ldexp, 2)),
        _ => None,
    }
}

fn consts_f32(name: &str) -> Option<f32> {
    use core::f32::consts as c;
    Some(match name {
        "PI" => c::PI,
        "TAU" => c::TAU,
        "E" => c::E,
        "SQRT_2" => c::SQRT_2,
        "LN_2" => c::LN_2,
        "LN_10" => c::LN_10,
        "LOG2_E" => c::LOG2_E,
        "LOG2_10" => c::LOG2_10,
        "LOG10_E" => c::LOG10_E,
        "LOG10_2" => c::LOG10_2,
        "FRAC_PI_2" => c::FRAC_PI_2,
        "FRAC_PI_3" => c::FRAC_PI_3,
        "FRAC_PI_4" => c::FRAC_PI_4,
        "FRAC_PI_6" => c::FRAC_PI_6,
        "FRAC_PI_8" => c::FRAC_PI_8,
        "FRAC_1_PI" => c::FRAC_1_PI,
        "FRAC_2_PI" => c::FRAC_2_PI,
        "FRAC_1_SQRT_2" => c::FRAC_1_SQRT_2,
        "FRAC_2_SQRT_PI" => c::FRAC_2_SQRT_PI,
        _ => return None,
    })
}

/// A constant of `core` by its whole path, as `core::f32::consts::PI`.
pub(crate) fn core_const(path: &str) -> Option<Lit> {
    let rest = path.strip_prefix("core::")?;
    if let Some(name) = rest.strip_prefix("f32::consts::") {
        return consts_f32(name).map(Lit::F32);
    }
    let (ty, name) = rest.split_once("::")?;
    match assoc_const(&primitive(ty)?, name)? {
        Value::Lit(lit) => Some(lit),
        Value::Splat(_) | Value::Parts(_) | Value::Identity => None,
    }
}

/// The value of an associated const of a built-in type.
pub(crate) enum Value {
    Lit(Lit),
    Splat(f64),
    Parts(Vec<f64>),
    /// The identity matrix.
    Identity,
}

/// An associated const of a built-in type.
pub(crate) fn assoc_const(ty: &Ty, name: &str) -> Option<Value> {
    Some(match (ty, name) {
        (Ty::F32, "EPSILON") => Value::Lit(Lit::F32(f32::EPSILON)),
        (Ty::F32, "MAX") => Value::Lit(Lit::F32(f32::MAX)),
        (Ty::F32, "MIN") => Value::Lit(Lit::F32(f32::MIN)),
        (Ty::F32, "MIN_POSITIVE") => Value::Lit(Lit::F32(f32::MIN_POSITIVE)),
        (Ty::U32, "MAX") => Value::Lit(Lit::U32(u32::MAX)),
        (Ty::U32, "MIN") => Value::Lit(Lit::U32(0)),
        (Ty::I32, "MAX") => Value::Lit(Lit::I32(i32::MAX)),
        (Ty::I32, "MIN") => Value::Lit(Lit::I32(i32::MIN)),
        (Ty::I32 | Ty::U32, "BITS") => Value::Lit(Lit::U32(32)),
        (Ty::Vec(..) | Ty::Mat(_), "ZERO") => Value::Splat(0.0),
        (Ty::Mat(_), "IDENTITY") => Value::Identity,
        (Ty::Vec(..), "ONE") => Value::Splat(1.0),
        (Ty::Vec(s, _), "NEG_ONE") if *s != Scalar::U32 => Value::Splat(-1.0),
        (Ty::Vec(s, n), axis) => {
            let (axis, sign) = match axis.strip_prefix("NEG_") {
                Some(axis) if *s != Scalar::U32 => (axis, -1.0),
                Some(_) => return None,
                None => (axis, 1.0),
            };
            let at = ["X", "Y", "Z", "W"]
                .iter()
                .position(|a| *a == axis)
                .filter(|i| *i < *n as usize)?;
            let mut parts = vec![0.0; *n as usize];
            parts[at] = sign;
            Value::Parts(parts)
        }
        _ => return None,
    })
}

/// What the arguments after the receiver are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Arg {
    /// The receiver's own type.
    Same,
    U32,
    F32,
    /// The vector's scalar.
    Scalar,
    /// The option's payload.
    Payload,
    /// A vector of `n` components of `f32`.
    VecF32(u8),
}

/// A method of a built-in type: operation, arguments after the receiver, result.
pub(crate) struct Method {
    pub(crate) op: B,
    pub(crate) args: &'static [Arg],
    pub(crate) ret: Ty,
}

/// Looks a method up on a built-in type.
pub(crate) fn method(ty: &Ty, name: &str) -> Option<Method> {
    use Arg::{Payload, Same, Scalar as S, U32};
    let same = |op, args| {
        Some(Method {
            op,
            args,
            ret: ty.clone(),
        })
    };
    let to = |op, args, ret| Some(Method { op, args, ret });
    let math = |m, args| same(B::Math(m), args);
    match ty {
        Ty::F32 => match name {
            "min" => math(M::Min, &[Same]),
            "max" => math(M::Max, &[Same]),
            "clamp" => math(M::Clamp, &[Same, Same]),
            "abs" => math(M::Abs, &[]),
            "recip" => same(B::Recip, &[]),
            "mul_add" => same(B::MulAdd, &[Same, Same]),
            "copysign" => same(B::Copysign, &[Same]),
            "to_bits" => to(B::Bitcast, &[], Ty::U32),
            _ => None,
        },
        Ty::U32 | Ty::I32 | Ty::Usize => {
            let unsigned = ty.is_unsigned();
            // A host's `usize` is wider: only what does not depend on its width.
            let fixed = *ty != Ty::Usize;
            match name {
                "min" => math(M::Min, &[Same]),
                "max" => math(M::Max, &[Same]),
                "clamp" => math(M::Clamp, &[Same, Same]),
                "abs" | "wrapping_abs" if !unsigned => math(M::Abs, &[]),
                "wrapping_add" if fixed => same(B::Op(BinOp::Add), &[Same]),
                "wrapping_sub" if fixed => same(B::Op(BinOp::Sub), &[Same]),
                "wrapping_mul" if fixed => same(B::Op(BinOp::Mul), &[Same]),
                "wrapping_neg" if fixed => same(B::WrappingNeg, &[]),
                "wrapping_shl" if fixed => same(B::Op(BinOp::Shl), &[U32]),
                "wrapping_shr" if fixed => same(B::Op(BinOp::Shr), &[U32]),
                "saturating_add" if unsigned && fixed => same(B::SaturatingAdd, &[Same]),
                "saturating_sub" if unsigned => same(B::SaturatingSub, &[Same]),
                "abs_diff" if unsigned => same(B::AbsDiff, &[Same]),
                "div_ceil" if unsigned => same(B::DivCeil, &[Same]),
                "is_power_of_two" if unsigned => to(B::IsPowerOfTwo, &[], Ty::Bool),
                "rotate_left" if fixed => same(B::RotateLeft, &[U32]),
                "rotate_right" if fixed => same(B::RotateRight, &[U32]),
                "reverse_bits" if fixed => math(M::ReverseBits, &[]),
                "count_ones" if fixed => to(B::Math(M::CountOneBits), &[], Ty::U32),
                "leading_zeros" if fixed => to(B::Math(M::CountLeadingZeros), &[], Ty::U32),
                "trailing_zeros" if fixed => to(B::Math(M::CountTrailingZeros), &[], Ty::U32),
                _ => None,
            }
        }
        Ty::Option(t) => match name {
            "is_some" => to(B::IsSome, &[], Ty::Bool),
            "is_none" => to(B::IsNone, &[], Ty::Bool),
            "unwrap_or" => to(B::UnwrapOr, &[Payload], (**t).clone()),
            _ => None,
        },
        Ty::Vec(scalar, n) => {
            let (scalar, n) = (*scalar, *n);
            let float = scalar == Scalar::F32;
            let one = Ty::of_scalar(scalar);
            match name {
                "min" => math(M::Min, &[Same]),
                "max" => math(M::Max, &[Same]),
                "clamp" => math(M::Clamp, &[Same, Same]),
                "abs" if scalar != Scalar::U32 => math(M::Abs, &[]),
                "dot" => to(B::Math(M::Dot), &[Same], one),
                "element_sum" => to(B::ElementSum, &[], one),
                "element_product" => to(B::ElementProduct, &[], one),
                "min_element" => to(B::MinElement, &[], one),
                "max_element" => to(B::MaxElement, &[], one),
                "extend" if n < 4 => to(B::Compose, &[S], Ty::Vec(scalar, n + 1)),
                "truncate" if n > 2 => to(B::Truncate, &[], Ty::Vec(scalar, n - 1)),
                "to_array" => to(
                    B::ToArray,
                    &[],
                    Ty::Array(Box::new(one), Box::new(Ty::Const(n.into()))),
                ),
                "with_x" => same(B::With(0), &[S]),
                "with_y" => same(B::With(1), &[S]),
                "with_z" if n > 2 => same(B::With(2), &[S]),
                "with_w" if n > 3 => same(B::With(3), &[S]),
                "is_negative_bitmask" if float => to(B::SignMask, &[], Ty::U32),
                "length_squared" => to(B::LengthSquared, &[], one),
                "distance_squared" if float => to(B::DistanceSquared, &[Same], one),
                "length" if float => to(B::Math(M::Length), &[], one),
                "distance" if float => to(B::Math(M::Distance), &[Same], one),
                "normalize" if float => math(M::Normalize, &[]),
                "cross" if float && n == 3 => math(M::Cross, &[Same]),
                "floor" if float => math(M::Floor, &[]),
                "ceil" if float => math(M::Ceil, &[]),
                "trunc" if float => math(M::Trunc, &[]),
                "recip" if float => same(B::Recip, &[]),
                "lerp" if float => same(B::Lerp, &[Same, Arg::F32]),
                "mul_add" if float => same(B::MulAdd, &[Same, Same]),
                "reflect" if float => math(M::Reflect, &[Same]),
                "wrapping_add" if !float => same(B::Op(BinOp::Add), &[Same]),
                "wrapping_sub" if !float => same(B::Op(BinOp::Sub), &[Same]),
                "wrapping_mul" if !float => same(B::Op(BinOp::Mul), &[Same]),
                _ => {
                    let as_vec = |prefix: &str| {
                        name.strip_prefix(prefix).and_then(|d| d.parse::<u8>().ok()) == Some(n)
                    };
                    if as_vec("as_vec") {
                        return to(B::Convert, &[], Ty::Vec(Scalar::F32, n));
                    } else if as_vec("as_uvec") {
                        return to(B::Convert, &[], Ty::Vec(Scalar::U32, n));
                    } else if as_vec("as_ivec") {
                        return to(B::Convert, &[], Ty::Vec(Scalar::I32, n));
                    }
                    let (pattern, m) = swizzle(name, n)?;
                    to(B::Swizzle(pattern, m), &[], Ty::Vec(scalar, m))
                }
            }
        }
        Ty::Mat(n) => match (name, n) {
            ("transpose", _) => math(M::Transpose, &[]),
            ("determinant", _) => to(B::Math(M::Determinant), &[], Ty::F32),
            ("mul_vec2", 2) => to(
                B::Op(BinOp::Mul),
                &[Arg::VecF32(2)],
                Ty::Vec(Scalar::F32, 2),
            ),
            ("mul_vec3", 3) => to(
                B::Op(BinOp::Mul),
                &[Arg::VecF32(3)],
                Ty::Vec(Scalar::F32, 3),
            ),
            ("mul_vec4", 4) => to(
                B::Op(BinOp::Mul),
                &[Arg::VecF32(4)],
                Ty::Vec(Scalar::F32, 4),
            ),
            _ => None,
        },
        _ => None,
    }
}

fn swizzle(name: &str, n: u8) -> Option<([u8; 4], u8)> {
    if !(2..=4).contains(&name.len()) {
        return None;
    }
    let mut pattern = [0; 4];
    for (i, c) in name.chars().enumerate() {
        let at = "xyzw".find(c).filter(|at| *at < n as usize)?;
        pattern[i] = at as u8;
    }
    Some((pattern, name.len() as u8))
}

/// Methods that mean something else on a GPU, with what to write instead.
pub(crate) fn refused_method(name: &str) -> Option<&'static str> {
    Some(match name {
        "round" => "ties go elsewhere on a GPU: write `libm::floorf(x + 0.5)`",
        "signum" => "zero has a sign in Rust and none in WGSL: compare with `< 0.0`",
        "is_nan" | "is_finite" | "is_infinite" | "is_normal" => {
            "a GPU may assume there is no NaN: guard the operation's input by comparison"
        }
        "fract" | "fract_gl" => {
            "glam's `fract` truncates and WGSL's floors: write `x - libm::floorf(x)`"
        }
        "rem_euclid" | "div_euclid" => "write the remainder out with `%` and a comparison",
        "sqrt" | "sin" | "cos" | "tan" | "exp" | "ln" | "powf" | "powi" | "atan2" | "acos"
        | "asin" | "floor" | "ceil" | "exp2" | "log2" | "sin_cos" | "trunc" => {
            "shared code calls libm, so that every host computes the same bits: `libm::sqrtf(x)`"
        }
        "checked_add" | "checked_sub" | "checked_mul" | "checked_div" | "overflowing_add"
        | "overflowing_sub" | "overflowing_mul" => {
            "compare before the operation, or use `wrapping_*`"
        }
        "normalize_or_zero" | "try_normalize" | "normalize_or" => {
            "test `length_squared()` against zero first"
        }
        "iter" | "iter_mut" | "into_iter" | "chunks" | "windows" => "write `for i in 0..s.len()`",
        "unwrap" | "expect" => "kernels never panic: write `let Some(x) = … else { return … }`",
        _ => return None,
    })
}

/// Whether glam or core has a method of this name on some built-in type. rustc prefers it to any trait's, so a trait's
/// method of that name is not what a plain call on a built-in type means.
pub(crate) fn is_inherent(name: &str) -> bool {
    INHERENT.split_whitespace().any(|n| n == name)
        || (2..=4).contains(&name.len()) && name.chars().all(|c| "xyzw".contains(c))
}

const INHERENT: &str = "
    abs abs_diff abs_diff_eq abs_sub acos acosh add_mat2 add_mat3 add_mat4 algebraic_add algebraic_div
    algebraic_mul algebraic_rem algebraic_sub angle_between angle_to any_orthogonal_vector any_orthonormal_pair
    any_orthonormal_vector as_dmat2 as_dmat3 as_dmat4 as_dvec2 as_dvec3 as_dvec4 as_i16vec2 as_i16vec3 as_i16vec4
    as_i64vec2 as_i64vec3 as_i64vec4 as_i8vec2 as_i8vec3 as_i8vec4 as_isizevec2 as_isizevec3 as_isizevec4 as_ivec2
    as_ivec3 as_ivec4 as_u16vec2 as_u16vec3 as_u16vec4 as_u64vec2 as_u64vec3 as_u64vec4 as_u8vec2 as_u8vec3
    as_u8vec4 as_usizevec2 as_usizevec3 as_usizevec4 as_uvec2 as_uvec3 as_uvec4 as_vec2 as_vec3 as_vec3a as_vec4
    asin asinh atan atan2 atanh cast_signed cast_unsigned cbrt ceil chebyshev_distance checked_abs checked_add
    checked_add_signed checked_add_unsigned checked_div checked_div_euclid checked_ilog checked_ilog10
    checked_ilog2 checked_isqrt checked_manhattan_distance checked_mul checked_neg checked_next_multiple_of
    checked_next_power_of_two checked_pow checked_rem checked_rem_euclid checked_shl checked_shr
    checked_signed_diff checked_sub checked_sub_signed checked_sub_unsigned clamp clamp_length clamp_length_max
    clamp_length_min classify clone cmp cmpeq cmpge cmpgt cmple cmplt cmpne col col_mut copysign cos cosh
    count_ones count_zeros cross determinant diagonal distance distance_squared div_ceil div_euclid div_scalar dot
    dot_into_vec element_product element_sum eq erf exp exp2 exp_m1 extend floor fract fract_gl ge gt hypot ilog
    ilog10 ilog2 inverse inverse_or_zero is_finite is_finite_mask is_infinite is_multiple_of is_nan is_nan_mask
    is_negative is_negative_bitmask is_negative_mask is_none is_normal is_normalized is_positive is_power_of_two
    is_sign_negative is_sign_positive is_some is_subnormal isqrt le leading_ones leading_zeros length length_recip
    length_squared lerp lerp_monotonic ln ln_1p log log10 log2 lt manhattan_distance max max_element max_position
    maximum midpoint min min_element min_position minimum move_towards mul_add mul_diagonal_scale mul_mat2
    mul_mat3 mul_mat4 mul_scalar mul_transpose_vec2 mul_transpose_vec3 mul_transpose_vec4 mul_vec2 mul_vec3
    mul_vec3a mul_vec4 ne neg next_down next_multiple_of next_power_of_two next_up normalize normalize_and_length
    normalize_or normalize_or_zero not overflowing_abs overflowing_add overflowing_mul overflowing_neg
    overflowing_pow overflowing_shl overflowing_shr overflowing_sub partial_cmp perp perp_dot pow powf powi
    project project_onto project_onto_normalized project_point3 project_point3a recip reflect refract reject_from
    reject_from_normalized rem_euclid reverse_bits rotate rotate_angle rotate_axis rotate_left rotate_right
    rotate_towards rotate_x rotate_y rotate_z round round_ties_even row saturate saturating_abs saturating_add
    saturating_add_signed saturating_add_unsigned saturating_div saturating_mul saturating_neg saturating_pow
    saturating_sub saturating_sub_unsigned set_row signum sin sin_cos sinh slerp smoothstep sqrt step sub_mat2
    sub_mat3 sub_mat4 swap_bytes tan tanh then then_some to_angle to_array to_be to_be_bytes to_bits to_cols_array
    to_cols_array_2d to_degrees to_euler to_homogeneous to_int_unchecked to_le to_le_bytes to_ne_bytes to_radians
    to_rows_array to_scale_rotation_translation to_vec3a total_cmp trailing_ones trailing_zeros transform_point2
    transform_point3 transform_point3a transform_vector2 transform_vector3 transform_vector3a transpose
    transpose_mul_vec2 transpose_mul_vec3 transpose_mul_vec4 trunc truncate try_inverse try_normalize unsigned_abs
    unwrap_or with_w with_x with_y with_z wrapping_abs wrapping_add wrapping_add_signed wrapping_add_unsigned
    wrapping_div wrapping_mul wrapping_neg wrapping_pow wrapping_rem wrapping_shl wrapping_shr wrapping_sub
    wrapping_sub_unsigned write_cols_to_slice write_to_slice
    from_angle from_axis_angle from_cols_array from_cols_array_2d from_cols_slice from_euler from_homogeneous from_mat2 from_mat3
    from_mat3_minor from_mat3_translation from_mat3a from_mat3a_minor from_mat4 from_mat4_minor from_quat from_rotation_translation
    from_rotation_x from_rotation_y from_rotation_z from_rows from_rows_array from_rows_slice from_scale from_scale_angle
    from_scale_angle_translation from_scale_rotation_translation from_slice from_translation map select new splat from_array from_cols
    from_diagonal from_bits from_str_radix from_be from_le from_be_bytes from_le_bytes from_ne_bytes or xor and zip unzip take replace
    insert flatten copied cloned unwrap unwrap_or_default unwrap_or_else unwrap_unchecked expect as_ref as_mut as_deref as_deref_mut
    as_slice and_then or_else filter get_or_insert get_or_insert_with inspect is_none_or is_some_and iter iter_mut map_or map_or_else
    ok_or ok_or_else take_if transpose first last first_mut last_mut get get_mut swap fill reverse contains starts_with ends_with
    sort sort_unstable binary_search chunks chunks_exact windows split split_at split_first split_last concat join copy_from_slice
    copy_within rotate_left rotate_right each_ref len is_empty to_vec into_iter
";
