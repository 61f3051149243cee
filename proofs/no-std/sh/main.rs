//! Host file: `glimt-sh` linked alone, without std and alloc.

#![no_std]
#![no_main]

#[path = "../rt.rs"]
mod rt;

use core::f32::consts::PI;
use core::hint::black_box;
use glam::{Mat3, UVec2, Vec2, Vec3};
use glimt_sh::{
    Projection, RingTable, SampledProjection, ShError, build_ring_table_into, evaluate, irradiance,
    ring_table_len, rotated, stratified_direction,
};

const SIZE: UVec2 = UVec2::new(32, 16);

/// Under a sky of radiance 1 irradiance is π, and the sky stays above unless it is turned; samples find the same.
fn is_right() -> bool {
    projected() == Ok(true) && sampled()
}

fn projected() -> Result<bool, ShError> {
    let mut table = [0.0; 256];
    let table = &mut table[..ring_table_len(SIZE.x, 4, 3)?];
    build_ring_table_into(SIZE.x, 4, 3, table)?;
    let table = RingTable::new(SIZE.x, 4, 3, table)?;
    let mut projection = Projection::new(4, SIZE)?;
    let row = black_box([[1.0f32; 3]; SIZE.x as usize]);
    for y in 0..SIZE.y / 2 {
        projection.add_row(y, &table.row_sums(row.as_flattened())?)?;
    }
    let light = irradiance(&projection.coefficients());
    let turn = Mat3::from_cols(Vec3::Y, Vec3::Z, Vec3::X);
    let above = evaluate(&light, Vec3::Z).x;
    let aside = evaluate(&rotated(&light, &turn), Vec3::X).x;
    Ok((above - PI).abs() < 0.15 && (above - aside).abs() < 1e-4)
}

fn sampled() -> bool {
    let mut samples = SampledProjection::new();
    for i in 0..100 {
        let d = stratified_direction(i, UVec2::splat(10), Vec2::splat(black_box(0.5)));
        samples.add(d, d.z.max(0.0));
    }
    (samples.coefficients()[0] - 0.886).abs() < 0.01
}
