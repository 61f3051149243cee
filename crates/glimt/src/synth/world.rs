//! Host file: the light of a frame: the map with its sun where it stands, clouds before it, and lamps; on a stage, with what
//! passes in front.

use super::clouds::transmittance;
use super::disc::add_disc;
use super::geometry::{SunTruth, on_path, time_of};
use super::settings::{Lamp, Shape, Synth};
use super::sky;
use super::sun::{self, Blob};
use glam::{DVec3, UVec2, Vec2, Vec3, Vec4};
use glimt_probe::latlong::{texel_direction, texel_solid_angle_sr};
use glimt_probe::rotate::{cos_sin_degrees, rotate_z};
use glimt_render_gpu::kernels::environment::bilinear;
use glimt_render_gpu::kernels::stage::{
    STAGE_BOX, STAGE_INFINITE, STAGE_SPHERE, Stage, StageParams,
};
use rayon::prelude::*;
use std::sync::OnceLock;

/// Width of a map from which on discs of a quarter of a degree keep their shape.
const FINE_WIDTH: u32 = 1024;

/// Arc of the sun in the built-in sky, where none is given: azimuth and elevation in degrees.
const BUILT_IN_ARC: [[f32; 2]; 2] = [[75.0, 14.0], [40.0, 45.0]];

/// What surrounds the ball in a frame.
#[derive(Clone, Debug)]
pub struct World {
    texels: Vec<Vec4>,
    params: StageParams,
    sun: Option<SunTruth>,
}

impl World {
    /// What kernels see of it.
    pub fn stage(&self) -> Stage<'_> {
        Stage {
            texels: &self.texels,
            params: self.params,
        }
    }

    /// Its sun.
    pub fn sun(&self) -> Option<SunTruth> {
        self.sun
    }

    /// The mean radiance of the map over all directions.
    pub fn mean_radiance(&self) -> Vec3 {
        let size = self.params.size;
        let rows = self.texels.chunks(size.x as usize).enumerate();
        let flux = rows.map(|(row, texels)| {
            let sum: DVec3 = texels.iter().map(|t| t.truncate().as_dvec3()).sum();
            sum * f64::from(texel_solid_angle_sr(row as u32, size))
        });
        (flux.sum::<DVec3>() / (4.0 * std::f64::consts::PI)).as_vec3()
    }

    /// The largest value of a channel.
    pub fn brightest(&self) -> f32 {
        let channels = self.texels.par_iter().map(|t| t.truncate().max_element());
        channels
            .reduce(|| 0.0, f32::max)
            .max(self.params.occluder_radiance.max_element())
    }

    /// A still picture at infinity, turned as the light is.
    pub(super) fn still(synth: &Synth, size: UVec2, texels: Vec<Vec4>) -> Self {
        Self {
            texels,
            params: StageParams {
                shape: STAGE_INFINITE,
                occluder_radius: 0.0,
                ..stage_params(synth, 1, size)
            },
            sun: None,
        }
    }
}

/// The map without what changes from frame to frame.
#[derive(Clone, Debug)]
pub(super) enum Base {
    /// The built-in sky; kept where its sun stands still.
    Sky { still: OnceLock<Vec<Vec4>> },
    /// A map, the blob of its sun taken out where that is drawn again.
    Map {
        size: UVec2,
        texels: Vec<Vec4>,
        blob: Option<Blob>,
    },
}

impl Base {
    /// The built-in sky.
    pub(super) fn sky() -> Self {
        Self::Sky {
            still: OnceLock::new(),
        }
    }

    /// Prepares a map: scaled, made finer where something small is drawn into it, its sun found, and taken out where it is to
    /// move.
    pub(super) fn of_map(synth: &Synth, size: UVec2, mut texels: Vec<Vec4>) -> Self {
        for texel in &mut texels {
            *texel *= synth.light.scale;
        }
        let drawn = is_sun_drawn(synth) || !synth.lamps.is_empty() || synth.clouds.cover > 0.0;
        let (size, mut texels) = match drawn && size.x < FINE_WIDTH {
            true => finer(size, &texels, FINE_WIDTH.div_ceil(size.x)),
            false => (size, texels),
        };
        let blob = match is_sun_drawn(synth) || !synth.sun.on {
            true => sun::take_out(&mut texels, size),
            false => sun::find(&texels, size),
        };
        Self::Map { size, texels, blob }
    }

    /// The sun of a frame, in the world.
    fn place_sun(&self, synth: &Synth, frame: u32) -> Option<Blob> {
        let keys = &synth.sun;
        if !keys.on {
            return None;
        }
        let time = time_of(synth, frame);
        let given = keys.irradiance.map(|e| Vec3::from(e).as_dvec3());
        match self {
            Self::Sky { .. } => {
                let irradiance = given.unwrap_or_else(|| {
                    // One irradiance along the whole arc: that in its middle.
                    let elevation = built_in_sun(synth, 0.5).z.asin();
                    sky::sun_irradiance(elevation).as_dvec3() * f64::from(synth.light.scale)
                });
                Some(Blob {
                    direction: built_in_sun(synth, time),
                    irradiance,
                })
            }
            Self::Map { blob, .. } => {
                let turn = cos_sin_degrees(synth.light.rotate_z_deg);
                let own = blob.map(|blob| rotate_z(blob.direction.as_vec3(), turn).as_dvec3());
                Some(Blob {
                    direction: sun::on_arc(keys, time).or(own)?.normalize(),
                    irradiance: given.or(blob.map(|blob| blob.irradiance))?,
                })
            }
        }
    }

    /// The sun of a frame.
    pub(super) fn sun(&self, synth: &Synth, frame: u32) -> Option<SunTruth> {
        self.place_sun(synth, frame).map(|blob| SunTruth {
            direction: blob.direction.to_array(),
            irradiance: blob.irradiance.to_array(),
        })
    }

    /// The light of a frame.
    pub(super) fn world(&self, synth: &Synth, frame: u32) -> World {
        let time = time_of(synth, frame);
        let turn = cos_sin_degrees(synth.light.rotate_z_deg);
        // Discs are drawn and clouds drift in the world; the map is turned when it is looked up.
        let to_map = |d: DVec3| {
            let turned = rotate_z(d.as_vec3(), Vec2::new(turn.x, -turn.y));
            turned.as_dvec3().normalize()
        };
        let placed = self.place_sun(synth, frame);
        let (size, mut texels) = match self {
            Self::Sky { still } => {
                let size = sky::SIZE;
                let scale = synth.light.scale;
                let made = || {
                    let sun = to_map(built_in_sun(synth, time)).as_vec3();
                    let irradiance = placed.map_or(DVec3::ZERO, |blob| blob.irradiance);
                    let irradiance = irradiance.as_vec3() / scale.max(1e-30);
                    let mut texels = sky::clear_sky(size, sun, irradiance);
                    for texel in &mut texels {
                        *texel *= scale;
                    }
                    texels
                };
                let is_still = built_in_sun(synth, 0.0) == built_in_sun(synth, 1.0);
                let texels = match is_still {
                    true => still.get_or_init(made).clone(),
                    false => made(),
                };
                (size, texels)
            }
            Self::Map { size, texels, .. } => (*size, texels.clone()),
        };
        if let (Some(blob), true) = (
            placed,
            matches!(self, Self::Sky { .. }) || is_sun_drawn(synth),
        ) {
            let radius = synth.sun.radius_deg;
            add_disc(
                &mut texels,
                size,
                to_map(blob.direction),
                f64::from(radius).to_radians(),
                sun::disc_radiance(blob.irradiance, radius),
            );
        }
        if synth.clouds.cover > 0.0 {
            let lit = cloud_radiance(&texels, size);
            texels.par_iter_mut().enumerate().for_each(|(i, texel)| {
                let at = UVec2::new(i as u32 % size.x, i as u32 / size.x);
                let d = rotate_z(texel_direction(at, size), turn);
                let through = transmittance(&synth.clouds, synth.seed, d, time);
                *texel = *texel * through + lit * (1.0 - through);
            });
        }
        for (index, lamp) in synth.lamps.iter().enumerate() {
            let direction = place_lamp(lamp, time);
            let level = 1.0 - lamp.flicker * flicker(f64::from(frame), index as f64);
            add_disc(
                &mut texels,
                size,
                to_map(direction),
                f64::from(lamp.radius_deg).to_radians(),
                level * Vec3::from(lamp.radiance),
            );
        }
        World {
            texels,
            params: stage_params(synth, frame, size),
            sun: self.sun(synth, frame),
        }
    }
}

/// Where a lamp is at time `time`, 0 in the first frame and 1 in the last.
fn place_lamp(lamp: &Lamp, time: f64) -> DVec3 {
    let between = |from: f32, to: Option<f32>| {
        let (from, to) = (f64::from(from), f64::from(to.unwrap_or(from)));
        from + (to - from) * time
    };
    sun::from_angles(
        between(lamp.azimuth_deg, lamp.to_azimuth_deg),
        between(lamp.elevation_deg, lamp.to_elevation_deg),
    )
}

/// Whether the sun is drawn as a disc, rather than left as the map has it.
fn is_sun_drawn(synth: &Synth) -> bool {
    synth.sun.on && (synth.sun.from_deg.is_some() || synth.sun.irradiance.is_some())
}

/// Where the sun of the built-in sky stands.
fn built_in_sun(synth: &Synth, time: f64) -> DVec3 {
    let given = &synth.sun;
    let arc = super::settings::Sun {
        from_deg: given.from_deg.or(Some(BUILT_IN_ARC[0])),
        to_deg: given.to_deg.or(given.from_deg).or(Some(BUILT_IN_ARC[1])),
        ..given.clone()
    };
    sun::on_arc(&arc, time).unwrap_or(DVec3::Z)
}

/// The same map with `factor` times as many texels along each side.
fn finer(size: UVec2, texels: &[Vec4], factor: u32) -> (UVec2, Vec<Vec4>) {
    let fine = size * factor;
    let texel = |i: u32| {
        let d = texel_direction(UVec2::new(i % fine.x, i / fine.x), fine);
        bilinear(texels, size, d).extend(1.0)
    };
    let list = (0..fine.x * fine.y).into_par_iter().map(texel).collect();
    (fine, list)
}

fn stage_params(synth: &Synth, frame: u32, size: UVec2) -> StageParams {
    let (stage, occluder) = (&synth.stage, &synth.occluder);
    StageParams {
        half_size: 0.5 * Vec3::from(stage.size_m),
        shape: match stage.shape {
            Shape::Infinite => STAGE_INFINITE,
            Shape::Sphere => STAGE_SPHERE,
            Shape::Box => STAGE_BOX,
        },
        occluder_centre: on_path(synth, frame, occluder.from_m, occluder.to_m).as_vec3(),
        occluder_radius: occluder.radius_m,
        occluder_radiance: Vec3::from(occluder.radiance),
        unused: 0.0,
        size,
        rotation: cos_sin_degrees(synth.light.rotate_z_deg),
    }
}

/// Radiance of a cloud: a matte white sheet lit from above as the ground is, which lets a part of that through.
fn cloud_radiance(texels: &[Vec4], size: UVec2) -> Vec4 {
    const THROUGH: f32 = 0.45;
    let columns = size.x as usize;
    let sky = texels[..(size.y / 2) as usize * columns]
        .chunks(columns)
        .enumerate();
    let irradiance: Vec3 = sky
        .map(|(row, texels)| {
            let sum: Vec3 = texels.iter().map(|t| t.truncate()).sum();
            let up = texel_direction(UVec2::new(0, row as u32), size).z;
            sum * (up * texel_solid_angle_sr(row as u32, size))
        })
        .sum();
    (irradiance * (THROUGH * std::f32::consts::FRAC_1_PI)).extend(1.0)
}

/// A restless number in [0, 1]: two sines whose periods share no multiple.
fn flicker(frame: f64, phase: f64) -> f32 {
    (0.5 + 0.25 * ((1.9 * frame + phase).sin() + (3.1 * frame + 2.0 * phase).sin())) as f32
}

#[cfg(test)]
mod tests {
    use super::*;

    fn flux(world: &World) -> DVec3 {
        let size = world.params.size;
        let texels = world.texels.iter().enumerate();
        let power = texels.map(|(i, t)| {
            let area = f64::from(texel_solid_angle_sr(i as u32 / size.x, size));
            t.truncate().as_dvec3() * area
        });
        power.sum()
    }

    /// A grey sky with a blob of a sun that has two texels and a halo.
    fn map() -> (UVec2, Vec<Vec4>) {
        let size = UVec2::new(256, 128);
        let mut texels = vec![Vec4::splat(0.5); 256 * 128];
        texels[40 * 256 + 100] = Vec4::new(4000.0, 3500.0, 3000.0, 1.0);
        texels[40 * 256 + 101] = Vec4::new(2000.0, 1500.0, 1000.0, 1.0);
        (size, texels)
    }

    #[test]
    fn the_sun_keeps_its_energy_along_its_arc() {
        let mut synth = Synth::default();
        synth.sun.from_deg = Some([80.0, 3.0]);
        synth.sun.to_deg = Some([-150.0, 85.0]);
        synth.light.rotate_z_deg = 33.0;
        let (size, texels) = map();
        let base = Base::of_map(&synth, size, texels);
        let first = flux(&base.world(&synth, 1));
        for frame in 2..=24 {
            let ratio = flux(&base.world(&synth, frame)) / first - 1.0;
            assert!(ratio.abs().max_element() < 1e-4, "{frame}: {ratio}");
        }
        // It is the energy that the map had.
        let mut still = synth.clone();
        still.sun.from_deg = None;
        let (size, texels) = map();
        let own = Base::of_map(&still, size, texels);
        let ratio = flux(&own.world(&still, 1)) / first - 1.0;
        assert!(ratio.abs().max_element() < 5e-3, "{ratio}");
        // Another irradiance is not taken for the same.
        synth.sun.irradiance = Some([1.0, 1.0, 1.0]);
        let ratio = flux(&base.world(&synth, 1)) / first - 1.0;
        assert!(!(ratio.abs().max_element() < 1e-4));
    }

    /// The brightest texel is where the truth says the sun stands.
    #[test]
    fn the_sun_stands_where_the_truth_says() {
        for rotate in [0.0, 70.0] {
            for drawn in [true, false] {
                let mut synth = Synth::default();
                synth.light.rotate_z_deg = rotate;
                synth.sun.from_deg = drawn.then_some([20.0, 40.0]);
                let (size, texels) = map();
                let base = Base::of_map(&synth, size, texels);
                let world = base.world(&synth, 5);
                let sun = DVec3::from(world.sun().unwrap().direction).as_vec3();
                let stage = world.stage();
                let seen = stage.radiance(Vec3::ZERO, sun).x;
                assert!(seen > 100.0, "{rotate} {drawn}: {seen}");
            }
        }
    }

    #[test]
    fn lamps_move() {
        let lamp = Lamp {
            azimuth_deg: 10.0,
            elevation_deg: 20.0,
            to_azimuth_deg: Some(370.0),
            to_elevation_deg: Some(60.0),
            ..Lamp::default()
        };
        for (time, azimuth, elevation) in
            [(0.0, 10.0, 20.0), (0.25, 100.0, 30.0), (1.0, 10.0, 60.0)]
        {
            let expected = sun::from_angles(azimuth, elevation);
            assert!(place_lamp(&lamp, time).distance(expected) < 1e-12, "{time}");
        }
        let still = Lamp {
            to_azimuth_deg: None,
            to_elevation_deg: None,
            ..lamp.clone()
        };
        assert_eq!(place_lamp(&still, 0.7), place_lamp(&lamp, 0.0));
        // It is drawn there.
        let mut synth = Synth {
            lamps: vec![lamp],
            ..Synth::default()
        };
        synth.sun.from_deg = Some([200.0, 50.0]);
        let (size, texels) = map();
        let base = Base::of_map(&synth, size, texels);
        for (frame, time) in [(1, 0.0), (13, 12.0 / 23.0)] {
            let world = base.world(&synth, frame);
            let radiance = |time| {
                let d = place_lamp(&synth.lamps[0], time).as_vec3();
                world.stage().radiance(Vec3::ZERO, d).x
            };
            assert!(radiance(time) > 90.0 && radiance(time + 0.2) < 10.0);
        }
    }

    #[test]
    fn the_built_in_sky_has_a_moving_sun_and_lamps_flicker() {
        let lamp = super::super::settings::Lamp {
            flicker: 0.5,
            ..Default::default()
        };
        let mut synth = Synth {
            lamps: vec![lamp],
            ..Synth::default()
        };
        let first = Base::sky().world(&synth, 1);
        let last = Base::sky().world(&synth, 24);
        assert!(first.sun().unwrap().direction[2] < last.sun().unwrap().direction[2]);
        assert!((flux(&first) - flux(&last)).length() > 0.0);
        assert!(first.brightest() > 1e4);
        synth.sun.on = false;
        let dark = Base::sky().world(&synth, 1);
        assert!(dark.sun().is_none() && dark.brightest() < first.brightest() / 100.0);
    }
}
