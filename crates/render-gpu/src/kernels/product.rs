//! Shared file: light by samples of the product of light and reflection, one proposal for each group of a pixel's hits.

use super::environment::Environment;
use super::estimator::Reflected;
use super::frame::FrameParams;
use super::group_light::{Drawn, GroupLight};
use super::groups::next_group;
use super::proposal::{Expectation, Unknown};
use super::scene::Scene;
use super::seen::SeenPoint;
use super::shade::RaySample;

/// How a pixel's light is estimated by groups. 16 bytes.
#[derive(Clone, Copy, Debug, PartialEq, bytemuck::NoUninit)]
#[repr(C)]
pub struct Product {
    /// Shadow rays of a pixel whose camera rays all hit something, on average.
    pub rays: f32,
    /// Fills 16 bytes.
    pub unused_a: u32,
    /// Fills 16 bytes.
    pub unused_b: u32,
    /// Fills 16 bytes.
    pub unused_c: u32,
}

/// What the camera rays of the tile's pixel `pixel` show: `points` are their hits, whose groups it finds.
///
/// `L̂ = Σ L(ω) f_k(ω) V_k(ω)/(D q(ω))` over a group's samples, each for a member k drawn evenly, is what each member shows.
/// q mixes cells of the light, weighted by what the group's mean reflects of them, and the members' lobes.
pub fn shade_product<S: RaySample>(
    pixel: u32,
    frame: &FrameParams,
    product: &Product,
    env: Environment<'_>,
    scene: Scene<'_>,
    points: &mut [SeenPoint],
    samples: &mut [S],
) {
    shade_groups(
        pixel,
        frame,
        product.rays,
        0.0,
        &Unknown,
        env,
        scene,
        points,
        samples,
    );
}

/// As [`shade_product`], where something may be known of the visibility of cells.
#[inline]
pub fn shade_groups<P: Expectation, S: RaySample>(
    pixel: u32,
    frame: &FrameParams,
    rays: f32,
    threshold: f32,
    expected: &P,
    env: Environment<'_>,
    scene: Scene<'_>,
    points: &mut [SeenPoint],
    samples: &mut [S],
) {
    let first = pixel * frame.rays_per_pixel;
    let light = GroupLight {
        env,
        cells: env.cells(),
        scene,
        pattern: frame.pattern_of(first),
        rays,
        threshold,
    };
    let mut drawn = Drawn { cells: 0, lobes: 0 };
    let mut leader = 0;
    let mut filled = 0;
    let mut number = 0;
    let mut group = next_group(points, &mut leader, filled);
    while group.members > 0 {
        let reflected = light.reflected(&group, number, expected, points, &mut drawn);
        for k in 0..group.members {
            let ray = group.ray(k, points);
            let point = points[ray as usize];
            let own = Reflected {
                lit: reflected.lit + point.emission,
                blocked: reflected.blocked,
            };
            samples[ray as usize] = S::of_surface(&own, point.is_catcher());
        }
        filled += group.members;
        number += 1;
        group = next_group(points, &mut leader, filled);
    }
    for ray in 0..frame.rays_per_pixel {
        if !points[ray as usize].is_hit() {
            let camera_ray = frame.camera_ray(&frame.pattern_of(first + ray));
            samples[ray as usize] = S::of_background(&camera_ray, frame, env.map());
        }
    }
}
