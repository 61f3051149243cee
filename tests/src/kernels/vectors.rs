//! Shared file: glam's vectors.

use super::input::{float, int, uint};
use glam::swizzles::*;
use glam::{
    IVec2, IVec3, IVec4, UVec2, UVec3, UVec4, Vec2, Vec3, Vec4, ivec2, ivec3, uvec2, uvec3, uvec4,
    vec2, vec3, vec4,
};

fn v2(id: u32, floats: &[f32], k: u32) -> Vec2 {
    Vec2::new(float(id, floats, k), float(id, floats, k + 1))
}

fn v3(id: u32, floats: &[f32], k: u32) -> Vec3 {
    Vec3::new(
        float(id, floats, k),
        float(id, floats, k + 1),
        float(id, floats, k + 2),
    )
}

fn v4(id: u32, floats: &[f32], k: u32) -> Vec4 {
    vec4(
        float(id, floats, k),
        float(id, floats, k + 1),
        float(id, floats, k + 2),
        float(id, floats, k + 3),
    )
}

fn u4(id: u32, ints: &[u32], k: u32) -> UVec4 {
    uvec4(
        uint(id, ints, k),
        uint(id, ints, k + 1),
        uint(id, ints, k + 2),
        uint(id, ints, k + 3),
    )
}

/// Operators between vectors.
pub fn operators(id: u32, _ints: &[u32], floats: &[f32]) -> Vec4 {
    let (a, b) = (v4(id, floats, 0), v4(id, floats, 4));
    let safe = b.abs() + 0.5;
    let mut c = a + b * a - b / safe;
    c += a;
    c -= b * 0.25;
    c *= safe;
    c /= safe + Vec4::ONE;
    -c
}

/// Operators with a scalar on either side.
pub fn scalar_sides(id: u32, _ints: &[u32], floats: &[f32]) -> Vec3Pair {
    let (a, s) = (v3(id, floats, 0), float(id, floats, 3));
    let d = a.abs() + 0.5;
    let mut low = a * s + 2.0 * a - a / 4.0;
    low *= 0.5;
    low += 1.0;
    low -= s;
    low /= 3.0;
    Vec3Pair {
        low,
        pad: s,
        high: 1.0 / d + (1.0 - a) + (s + a) - (a + 2.0) % 1e6,
        pad2: 0.0,
    }
}

/// Two padded vectors.
#[derive(Clone, Copy, Debug, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
pub struct Vec3Pair {
    /// One.
    pub low: Vec3,
    /// Fills the fourth component.
    pub pad: f32,
    /// Another.
    pub high: Vec3,
    /// Fills the fourth component.
    pub pad2: f32,
}

/// Products, lengths and directions.
pub fn geometry(id: u32, _ints: &[u32], floats: &[f32]) -> [f32; 8] {
    let (a, b) = (v3(id, floats, 0), v3(id, floats, 3));
    let n = (b + Vec3::new(0.0, 0.0, 25.0)).normalize();
    let cross = a.cross(b);
    let reflected = a.reflect(n);
    [
        a.dot(b) * 0.01,
        cross.x * 0.01,
        cross.y * 0.01 + cross.z * 0.02,
        a.length(),
        a.length_squared() * 0.01,
        a.distance(b),
        a.distance_squared(b) * 0.01,
        reflected.x + 2.0 * reflected.y + 3.0 * reflected.z,
    ]
}

/// Componentwise functions.
pub fn componentwise(id: u32, _ints: &[u32], floats: &[f32]) -> [f32; 8] {
    let (a, b) = (v4(id, floats, 0), v4(id, floats, 4));
    let lerped = a.lerp(b, 0.25);
    let fused = a.mul_add(b, Vec4::splat(0.5));
    let clamped = a.clamp(Vec4::NEG_ONE, Vec4::splat(3.0));
    let recip = (a.abs() + 1.0).recip();
    let signs = a.is_negative_bitmask() + 16 * b.xy().is_negative_bitmask();
    [
        a.min(b).element_sum(),
        a.max(b).element_sum(),
        lerped.x + lerped.w,
        fused.y,
        clamped.element_sum(),
        recip.z + signs as f32,
        (a * 0.1).element_product() + a.min_element() + b.max_element(),
        a.floor().y + a.ceil().z,
    ]
}

/// Swizzles, and growing and shrinking.
pub fn swizzles(id: u32, _ints: &[u32], floats: &[f32]) -> Vec4 {
    let a = v4(id, floats, 0);
    let b = a.xyz().extend(a.x) + a.wzyx() + a.xxyy();
    let c = b.xy() + b.yx() - b.zz();
    let d = b.truncate().truncate() + vec2(b.w, b.z);
    c.extend(d.x).extend(d.y)
}

/// Swizzles of two and three components.
pub fn small_swizzles(id: u32, _ints: &[u32], floats: &[f32]) -> [f32; 6] {
    let a = v3(id, floats, 0);
    let b = v2(id, floats, 3);
    let (p, q, r) = (a.zyx(), a.yz(), b.yx());
    let s = a.xz() + b.xx();
    [p.x, p.z - q.x, q.y, r.x, r.y + s.x, s.y]
}

/// Constants, arrays, splats.
pub fn constants(id: u32, _ints: &[u32], floats: &[f32]) -> [f32; 8] {
    let s = float(id, floats, 0);
    let sum = Vec3::X * s + Vec3::Y * 2.0 + Vec3::NEG_Z;
    let ones = Vec2::ONE + Vec2::splat(s) + Vec2::NEG_X;
    let array = (Vec4::W + Vec4::ZERO).to_array();
    let back = Vec3::from_array([s, 1.0, array[3]]);
    [
        sum.x,
        sum.y,
        sum.z,
        ones.x,
        ones.y,
        back.x + back.y,
        back.z,
        array[0],
    ]
}

/// Components by name and by a dynamic index, read and written.
pub fn components(id: u32, ints: &[u32], floats: &[f32]) -> Vec4 {
    let mut a = v4(id, floats, 0);
    let i = (uint(id, ints, 0) % 4) as usize;
    let j = (uint(id, ints, 1) % 4) as usize;
    a.x = a[i] + 1.0;
    a[j] = a.y * 2.0;
    a.z += 3.0;
    a[i] -= 0.5;
    a.with_w(a.w + a[3]).with_x(a[j] + a.x)
}

/// Unsigned vectors.
pub fn unsigned(id: u32, ints: &[u32], _floats: &[f32]) -> UVec4 {
    let (a, b) = (u4(id, ints, 0), u4(id, ints, 4));
    let mut c = a.wrapping_add(b).wrapping_mul(b | 1).wrapping_sub(a >> 3);
    c ^= a.min(b) & 0x00FF_FF00;
    c = c ^ (a.max(b) << 2);
    c ^ !(a & b) ^ UVec4::splat(7) ^ UVec4::X
}

/// Unsigned vectors of two and three components.
pub fn small_unsigned(id: u32, ints: &[u32], floats: &[f32]) -> [u32; 8] {
    let a = uvec3(uint(id, ints, 0), uint(id, ints, 1), uint(id, ints, 2));
    let b = UVec2::new(uint(id, ints, 3) >> 8, 5);
    let c = a.xy() ^ b * 3;
    let f = vec3(
        float(id, floats, 0),
        float(id, floats, 1),
        float(id, floats, 2),
    )
    .abs()
        * 100.0;
    let whole = f.as_uvec3();
    let e = (a / (whole + UVec3::ONE)).wrapping_add(a % (whole + 2));
    [
        c.x,
        c.y,
        e.x,
        e.y.wrapping_add(e.z),
        whole.element_sum(),
        uvec2(whole.x, whole.y).as_ivec2().x as u32,
        (b.y == uvec2(b.x, 5).y) as u32,
        a.as_ivec3().z as u32,
    ]
}

/// Signed vectors.
pub fn signed(id: u32, ints: &[u32], floats: &[f32]) -> IVec4 {
    let a = u4(id, ints, 0).as_ivec4();
    let b = ivec3(int(id, ints, 4) >> 4, int(id, ints, 5) >> 4, -3);
    let c = (b - ivec3(1, 2, 3) * 2 + IVec3::NEG_ONE) / 3;
    let d = a.wrapping_add(c.extend(7)).wrapping_mul(IVec4::splat(5));
    let f = v2(id, floats, 0).as_ivec2() - ivec2(4, 4);
    d.min(a).max(IVec4::new(f.x, f.y, -f.x, 1) * 1000) ^ (-c.abs()).extend(0)
}

/// Vectors of integers as floats.
pub fn conversions(id: u32, ints: &[u32], _floats: &[f32]) -> [f32; 8] {
    let a = u4(id, ints, 0) >> 8u32;
    let b = IVec2::new(int(id, ints, 4) >> 8, int(id, ints, 5) >> 8);
    let f = a.as_vec4() / 1e6;
    let g = b.as_vec2() / 1e6;
    let h = (a.truncate() + UVec3::new(1, 2, 3)).as_vec3() / 1e6;
    [f.x, f.y, f.z, f.w, g.x, g.y, h.x, h.y + h.z]
}

/// Sums and products of integers.
pub fn integer_products(id: u32, ints: &[u32], _floats: &[f32]) -> [u32; 4] {
    let a = u4(id, ints, 0) & 0xFFF;
    let b = u4(id, ints, 4) & 0xFFF;
    [
        a.dot(b),
        a.element_sum(),
        (a & 0xFF).element_product(),
        a.max_element() - a.min_element(),
    ]
}
