//! Shared file: an image of the shared functions that no frame shows: pages of 32×32 values, one page for each subject.

use glam::{UVec2, Vec2, Vec3, Vec4};
use glimt_brdf::{BlinnPhong, Lambert};
use glimt_envmap_cdf::CompensatedCdf;
use glimt_probe::mirror_ball::MirrorBall;
use glimt_probe::{angular, rotate};
use glimt_sampling::{ShadingFrame, UniformSource, Xoshiro128PlusPlus, unit_vec2};
use glimt_sampling::{mis, warp};
use glimt_sh::{
    add_basis, basis, coefficient_band, coefficient_order, cosine_lobe, hann, meridian, ring,
    rotate_z, stratified_direction, temporal_filter,
};

/// Width and height of a page.
pub const PAGE_SIZE: u32 = 32;
/// Number of pages.
pub const PAGES: u32 = 9;

/// One value of the atlas. The pages follow each other.
#[must_use]
pub fn atlas(id: u32, env: CompensatedCdf<'_>) -> Vec4 {
    let cell = id % (PAGE_SIZE * PAGE_SIZE);
    let place = UVec2::new(cell % PAGE_SIZE, cell / PAGE_SIZE);
    let u = (place.as_vec2() + Vec2::splat(0.5)) / PAGE_SIZE as f32;
    match id / (PAGE_SIZE * PAGE_SIZE) {
        0 => angular_map(u),
        1 => turned(u),
        2 => warps(u),
        3 => weights(u),
        4 => compensated(cell, env),
        5 => matte(u),
        6 => metal(u),
        7 => mirror_ball(u),
        _ => harmonics(cell, u),
    }
}

fn angular_map(u: Vec2) -> Vec4 {
    let area = angular::solid_angle_sr_per_uv(u);
    if let Some(direction) = angular::uv_to_direction(u) {
        let back = angular::direction_to_uv(direction);
        return direction.extend(back.x + back.y + area);
    }
    Vec4::new(0.0, 0.0, 0.0, area)
}

fn turned(u: Vec2) -> Vec4 {
    let direction = Vec3::new(u.x, u.y, 0.5);
    rotate::rotate_z(direction, rotate::cos_sin_degrees(700.0 * u.x)).extend(u.y)
}

fn warps(u: Vec2) -> Vec4 {
    let disk = warp::sample_concentric_disk(u);
    let cap = warp::sample_cap(u, warp::cap_height(0.3 + u.y));
    let lobe = warp::sample_power_cosine(u, 20.0 * u.x);
    let sphere = warp::sample_uniform_sphere(u);
    let hemisphere = warp::sample_cosine_hemisphere(u);
    let directions = cap.direction + lobe.direction + sphere.direction + hemisphere.direction;
    let densities = cap.pdf_sr + lobe.pdf_sr + sphere.pdf_sr + hemisphere.pdf_sr;
    (directions + disk.extend(0.0)).extend(densities)
}

fn weights(u: Vec2) -> Vec4 {
    let frame = ShadingFrame::from_normal(Vec3::new(u.x, u.y, 0.7).normalize());
    Vec4::new(
        mis::balance_heuristic(2, u.x, 3, u.y),
        mis::power_heuristic(2, u.x, 3, u.y),
        mis::one_sample_density(0.3, u.x, u.y),
        frame.to_local(Vec3::X).x,
    )
}

fn compensated(cell: u32, env: CompensatedCdf<'_>) -> Vec4 {
    let mut source = Xoshiro128PlusPlus::stream(1, 2, cell);
    let sample = env.sample(source.next_uvec2());
    let other = env.balance_factor(sample.texel, 1, 2, 0.2);
    sample
        .direction
        .extend(sample.balance_factor(2, 1, 0.1) + other)
}

fn matte(u: Vec2) -> Vec4 {
    let surface = Lambert {
        diffuse: Vec3::new(0.8, 0.5, 0.2),
    };
    let sample = surface.sample(Vec3::Z, u);
    surface.eval(Vec3::Z, sample.wi).extend(sample.pdf_sr)
}

fn metal(u: Vec2) -> Vec4 {
    let surface = BlinnPhong::from_metallic_roughness(Vec3::new(0.9, 0.6, 0.3), u.x, u.y);
    let mut source = Xoshiro128PlusPlus::stream(3, 4, 5);
    let wo = Vec3::new(0.6, 0.0, 0.8);
    let sample = surface.sample(wo, source.next_u32(), unit_vec2(source.next_uvec2()));
    surface.eval(wo, sample.wi).extend(sample.pdf_sr)
}

fn mirror_ball(u: Vec2) -> Vec4 {
    let ball = MirrorBall::new(Vec3::new(0.8, 0.6, 0.0), Vec3::Z, 0.3);
    let ball = ball.image_turned(rotate::cos_sin_degrees(20.0));
    let p = 2.0 * u - Vec2::ONE;
    if let Some(seen) = ball.reflect(p) {
        let back = ball
            .direction_to_image(seen.direction)
            .unwrap_or(Vec2::ZERO);
        return (seen.direction + seen.normal).extend(back.x + 2.0 * back.y + seen.cos_incidence);
    }
    Vec4::ZERO
}

fn harmonics(cell: u32, u: Vec2) -> Vec4 {
    let d = stratified_direction(cell, UVec2::splat(PAGE_SIZE), u);
    let y = basis(d);
    let mut sums = y;
    add_basis(cell % 7, d, u.x, &mut sums);
    let k = cell % 36;
    let around = ring(u.x, u.y);
    let along = meridian(d.z, u.y);
    let (mut all, mut added) = (0.0, 0.0);
    for i in 0..36 {
        all += y[i] * (1.0 + i as f32);
        added += sums[i] * (1.0 + i as f32);
    }
    let mut factors = 0.0;
    for i in 0..11 {
        factors += around[i] * along[i + 10] + along[i] * (1.0 + i as f32);
    }
    let l = coefficient_band(k);
    let window = hann(l, 6.0 * u.x) + cosine_lobe(l);
    let turned = rotate_z(
        coefficient_order(k),
        u.x,
        u.y,
        rotate::cos_sin_degrees(90.0 * u.y),
    );
    Vec4::new(
        all,
        added,
        factors,
        window + temporal_filter(turned, u.x, 2.0 * u.y),
    )
}
