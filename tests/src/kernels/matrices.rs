//! Shared file: glam's matrices.

use super::input::{float, uint};
use glam::{Mat2, Mat3, Mat4, Vec2, Vec3, Vec4};

fn column(id: u32, floats: &[f32], k: u32) -> Vec3 {
    Vec3::new(
        float(id, floats, k),
        float(id, floats, k + 1),
        float(id, floats, k + 2),
    ) * 0.1
}

fn matrix3(id: u32, floats: &[f32]) -> Mat3 {
    Mat3::from_cols(
        column(id, floats, 0),
        column(id, floats, 3),
        column(id, floats, 5) + Vec3::X,
    )
}

fn matrix4(id: u32, floats: &[f32]) -> Mat4 {
    let m = matrix3(id, floats);
    Mat4::from_cols(
        m.x_axis.extend(0.5),
        m.y_axis.extend(-1.0),
        m.z_axis.extend(0.0),
        Vec4::W,
    )
}

/// Products with vectors and with each other.
pub fn products(id: u32, _ints: &[u32], floats: &[f32]) -> [f32; 8] {
    let m = matrix3(id, floats);
    let v = column(id, floats, 2);
    let a = m * v;
    let b = m.mul_vec3(v) + (m * m) * v;
    let c = (m * 2.0) * v + 0.5 * (m.transpose() * v);
    [
        a.x,
        a.y,
        a.z,
        b.x,
        b.y + b.z,
        c.x,
        c.y + c.z,
        m.determinant(),
    ]
}

/// Two and four dimensions.
pub fn sizes(id: u32, _ints: &[u32], floats: &[f32]) -> [f32; 8] {
    let v = column(id, floats, 4);
    let m2 = Mat2::from_cols(Vec2::new(v.x, v.y), Vec2::new(v.z, 1.0));
    let p = m2 * Vec2::new(2.0, v.x) + m2.mul_vec2(Vec2::ONE);
    let m4 = matrix4(id, floats);
    let q = m4 * v.extend(1.0) + m4.mul_vec4(Vec4::ONE);
    let r = Mat4::IDENTITY * m4.transpose().w_axis;
    [
        p.x,
        p.y,
        m2.determinant(),
        q.x,
        q.y,
        q.z + q.w,
        r.x + r.y,
        m4.determinant(),
    ]
}

/// Columns by name, by number, by a dynamic index.
pub fn columns(id: u32, ints: &[u32], floats: &[f32]) -> [f32; 8] {
    let mut m = matrix3(id, floats);
    m.y_axis = m.x_axis + Vec3::Y;
    m.z_axis.x += 2.0;
    let d = m.col((uint(id, ints, 0) % 3) as usize);
    let diagonal = Mat3::from_diagonal(Vec3::new(1.0, 2.0, 3.0)) + m - Mat3::ZERO;
    let last = diagonal.col(2);
    [
        d.x, d.y, d.z, m.y_axis.y, m.z_axis.x, last.x, last.y, last.z,
    ]
}

/// A matrix as the result.
pub fn result(id: u32, _ints: &[u32], floats: &[f32]) -> Mat4 {
    let m = matrix4(id, floats);
    m * Mat4::from_diagonal(Vec4::new(1.0, 2.0, 3.0, 4.0)) + Mat4::IDENTITY * float(id, floats, 7)
}
