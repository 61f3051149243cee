//! Host file: the sculpture: an armillary sphere on a turned pedestal, on the floor of a sundial.
//!
//! Its axis points at the celestial pole, and the hour lines inlaid in the floor start where that axis meets it: the
//! axis' shadow tells the hour.

use super::solid::{Knurl, Place, Solid, around_z};
use super::sun::LATITUDE;
use glam::{DMat3, DVec2, DVec3, Mat4, UVec2, Vec3, dvec2, dvec3, uvec2, vec3};
use glimt_render_gpu::host::scene::{Material, Object, SceneDescription};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// Diffuse albedo of the floor.
pub(super) const FLOOR: Vec3 = vec3(0.34, 0.32, 0.29);

/// Height of the sphere's centre above the floor [m].
const CENTRE: f64 = 1.72;

// Indices into the scene's materials.
const PAVING: u32 = 0;
const INLAY: u32 = 1;
const STONE: u32 = 2;
const LACQUER: u32 = 3;
const BRASS: u32 = 4;
const ENAMEL: u32 = 5;
const SILVER: u32 = 6;

/// The scene of the shot; it is the same in all frames.
pub fn scene() -> SceneDescription {
    let mut sculpture = Solid::named("armillary sphere");
    pedestal(&mut sculpture);
    cradle(&mut sculpture);
    sphere(&mut sculpture);
    let mut ground = Solid::named("sundial");
    floor(&mut ground);
    let object = |mesh| Object {
        mesh,
        transform: Mat4::IDENTITY,
        material: None,
    };
    SceneDescription {
        meshes: vec![ground.into_mesh(), sculpture.into_mesh()],
        materials: materials(),
        textures: Vec::new(),
        objects: vec![object(0), object(1)],
    }
}

fn materials() -> Vec<Material> {
    let material = |diffuse, specular, exponent| Material::BlinnPhong {
        diffuse,
        specular,
        exponent,
    };
    vec![
        material(FLOOR, Vec3::ZERO, 0.0),
        material(vec3(0.07, 0.06, 0.05), Vec3::splat(0.04), 60.0),
        material(vec3(0.58, 0.53, 0.46), Vec3::ZERO, 0.0),
        material(vec3(0.30, 0.025, 0.02), Vec3::splat(0.16), 90.0),
        material(vec3(0.03, 0.02, 0.005), vec3(0.93, 0.71, 0.36), 2500.0),
        material(vec3(0.015, 0.07, 0.26), Vec3::splat(0.22), 400.0),
        material(Vec3::splat(0.01), vec3(0.94, 0.93, 0.91), 8000.0),
    ]
}

/// A profile that bulges or is hollowed between two points, by `bulge` to the right of the way from `a` to `b`.
fn arc(a: DVec2, b: DVec2, bulge: f64) -> impl Fn(f64) -> DVec2 {
    let right = dvec2(b.y - a.y, a.x - b.x).normalize();
    move |t| a.lerp(b, t) + right * bulge * (1.0 - (2.0 * t - 1.0).powi(2))
}

/// Stone steps and mouldings, a fluted vase of lacquer, collars of brass. Each piece is a part of the profile.
fn pedestal(solid: &mut Solid) {
    let fine = uvec2(240, 12);
    let flat = uvec2(240, 1);
    let at = dvec2;
    let stone: [(UVec2, DVec2, DVec2, f64); 12] = [
        (flat, at(0.86, 0.0), at(0.86, 0.085), 0.0),
        (fine, at(0.86, 0.085), at(0.84, 0.105), 0.008),
        (flat, at(0.84, 0.105), at(0.70, 0.105), 0.0),
        (flat, at(0.70, 0.105), at(0.70, 0.18), 0.0),
        (fine, at(0.70, 0.18), at(0.68, 0.20), 0.008),
        (flat, at(0.68, 0.20), at(0.54, 0.20), 0.0),
        (fine, at(0.54, 0.20), at(0.54, 0.30), 0.05),
        (flat, at(0.54, 0.30), at(0.48, 0.30), 0.0),
        (fine, at(0.48, 0.30), at(0.36, 0.42), -0.055),
        (flat, at(0.36, 0.42), at(0.39, 0.42), 0.0),
        (fine, at(0.39, 0.42), at(0.39, 0.48), 0.03),
        (flat, at(0.39, 0.48), at(0.10, 0.48), 0.0),
    ];
    for (cells, a, b, bulge) in stone {
        solid.lathe(STONE, cells, arc(a, b, bulge));
    }
    // The vase: a slow wave in height, 20 flutes around that fade towards its ends.
    solid.patch(LACQUER, uvec2(320, 72), |uv| {
        let t = uv.y;
        let wave = 0.5 - 0.5 * (TAU * (0.12 + 0.86 * t.powf(0.75))).cos();
        let body = 0.085 + 0.20 * wave.powf(1.2);
        let flutes = 0.024 * (PI * t).sin().max(0.0) * (10.0 * TAU * uv.x).sin().abs();
        around_z(uv.x, body - flutes) + (0.48 + 0.36 * t) * DVec3::Z
    });
    for (height, radius, half) in [
        (0.495, 0.155, dvec2(0.030, 0.020)),
        (0.845, 0.100, dvec2(0.035, 0.022)),
    ] {
        let place = Place {
            turn: DMat3::IDENTITY,
            origin: height * DVec3::Z,
        };
        solid.ring(BRASS, uvec2(128, 24), radius, half, Knurl::NONE, &place);
    }
    solid.lathe(
        BRASS,
        uvec2(96, 24),
        arc(at(0.09, 0.86), at(0.0, 0.93), 0.03),
    );
}

/// Four bows of stone-white lacquer that carry the horizon, the one ring that does not tilt.
fn cradle(solid: &mut Solid) {
    let centre = CENTRE * DVec3::Z;
    let level = Place {
        turn: DMat3::IDENTITY,
        origin: centre,
    };
    solid.ring(
        BRASS,
        uvec2(360, 28),
        0.90,
        dvec2(0.060, 0.022),
        Knurl {
            count: 72.0,
            depth: 0.012,
        },
        &level,
    );
    for bow in 0..4 {
        let out = around_z((f64::from(bow) + 0.5) / 4.0, 1.0);
        let side = DVec3::Z.cross(out);
        solid.patch(LACQUER, uvec2(20, 64), |uv| {
            let angle = -FRAC_PI_2 * (0.985 - 0.985 * uv.y);
            let along = angle.cos() * out + angle.sin() * DVec3::Z;
            let section = 0.030 * rounded_section(uv.x);
            centre + (0.87 + section.y) * along + section.x * side
        });
    }
}

/// A circle's point, counter-clockwise.
fn rounded_section(turns: f64) -> DVec2 {
    let (sin, cos) = (TAU * turns).sin_cos();
    dvec2(cos, sin)
}

/// Meridian, equator, tropics, colures and ecliptic about the polar axis, and a globe.
fn sphere(solid: &mut Solid) {
    let polar = Place {
        turn: DMat3::from_rotation_y(LATITUDE - FRAC_PI_2),
        origin: CENTRE * DVec3::Z,
    };
    let upright = DMat3::from_rotation_x(FRAC_PI_2);
    let obliquity = 23.44_f64.to_radians();
    let around = uvec2(288, 24);
    let knurl = Knurl {
        count: 96.0,
        depth: 0.010,
    };
    solid.ring(
        BRASS,
        uvec2(384, 28),
        0.79,
        dvec2(0.024, 0.036),
        knurl,
        &polar.turned(upright),
    );
    for turn in [FRAC_PI_2 * 0.5, -FRAC_PI_2 * 0.5] {
        let colure = polar.turned(DMat3::from_rotation_z(turn) * upright);
        solid.ring(
            BRASS,
            around,
            0.705,
            dvec2(0.014, 0.022),
            Knurl::NONE,
            &colure,
        );
    }
    solid.ring(
        BRASS,
        around,
        0.715,
        dvec2(0.018, 0.045),
        Knurl::NONE,
        &polar,
    );
    for latitude in [obliquity, -obliquity] {
        let tropic = polar.raised(0.705 * latitude.sin());
        let radius = 0.705 * latitude.cos();
        solid.ring(
            BRASS,
            around,
            radius,
            dvec2(0.014, 0.020),
            Knurl::NONE,
            &tropic,
        );
    }
    let ecliptic = polar.turned(DMat3::from_rotation_x(obliquity));
    solid.ring(
        SILVER,
        around,
        0.66,
        dvec2(0.012, 0.070),
        Knurl::NONE,
        &ecliptic,
    );
    globe(solid, &polar);
    axis(solid, &polar);
}

/// A globe of enamel with meridians and parallels cut into it.
fn globe(solid: &mut Solid, polar: &Place) {
    solid.patch(ENAMEL, uvec2(288, 144), |uv| {
        let theta = (1.0 - uv.y) * PI;
        let meridians = groove(12.0 * uv.x, 0.06 / theta.sin().abs().max(0.05));
        let parallels = groove(12.0 * uv.y, 0.10);
        let radius = 0.25 - 0.010 * meridians.max(parallels);
        polar.at(around_z(uv.x, radius * theta.sin()) + radius * theta.cos() * DVec3::Z)
    });
}

/// 1 where `x` is a whole number, falling smoothly to 0 at `width` from it.
fn groove(x: f64, width: f64) -> f64 {
    let t = ((x - x.round()).abs() / width).min(1.0);
    (1.0 - t * t).powi(2)
}

/// The rod through both poles, with a ball and a point at its ends.
fn axis(solid: &mut Solid, polar: &Place) {
    let ball = uvec2(64, 32);
    solid.rod(BRASS, uvec2(40, 1), [-1.0, 1.0], |_| 0.018, polar);
    solid.ball(SILVER, ball, 0.055, &polar.raised(1.0));
    solid.ball(SILVER, ball, 0.055, &polar.raised(-1.0));
    let point = |z: f64| (0.035 * (1.22 - z) / 0.17).max(0.0);
    solid.rod(BRASS, uvec2(40, 12), [1.05, 1.22], point, polar);
}

/// The floor, cut along circles and rays about the foot of the axis; the hour lines and three circles are inlaid.
fn floor(solid: &mut Solid) {
    let foot = dvec3(CENTRE / LATITUDE.tan(), 0.0, 0.0);
    // Radii and whether the band that starts there is a circle of inlay.
    let bands = [
        (0.0, false),
        (1.10, true),
        (1.14, false),
        (3.60, true),
        (3.65, false),
        (4.35, true),
        (4.42, false),
        (12.0, false),
        (40.0, false),
        (160.0, false),
    ];
    let mut rays: Vec<(f64, bool)> = (-6..=6)
        .flat_map(|hour: i32| {
            let turns = hour_line(hour) / TAU;
            let half = if hour % 3 == 0 { 0.0016 } else { 0.0009 };
            [(turns - half, true), (turns + half, false)]
        })
        .collect();
    rays.extend((1..12).map(|i| (0.76 + 0.04 * f64::from(i), false)));
    rays.sort_by(|a, b| a.0.total_cmp(&b.0));
    for (i, &(from, ray_inlaid)) in rays.iter().enumerate() {
        let to = if i + 1 < rays.len() {
            rays[i + 1].0
        } else {
            rays[0].0 + 1.0
        };
        for (band, &(inner, circle_inlaid)) in bands[..bands.len() - 1].iter().enumerate() {
            let outer = bands[band + 1].0;
            let between_circles = (1.10..4.35).contains(&inner);
            let inlaid = circle_inlaid || (ray_inlaid && between_circles);
            let material = if inlaid { INLAY } else { PAVING };
            let cells = uvec2(((to - from) / 0.01).ceil() as u32, 1);
            solid.patch(material, cells, |uv| {
                let radius = outer + (inner - outer) * uv.y;
                foot + around_z(from + (to - from) * uv.x, radius)
            });
        }
    }
}

/// Where the axis' shadow falls at an hour after noon: its angle about the foot, counter-clockwise from +x (south)
/// [rad]; north is π. `tan ψ = sin φ tan H` on a horizontal dial.
fn hour_line(hour: i32) -> f64 {
    let h = f64::from(hour) * PI / 12.0;
    PI - (LATITUDE.sin() * h.sin()).atan2(h.cos())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_scene_is_what_was_promised() {
        let scene = scene();
        let triangles: usize = scene.meshes.iter().map(|m| m.indices.len()).sum();
        assert!(triangles >= 20_000, "{triangles}");
        for mesh in &scene.meshes {
            assert_eq!(mesh.indices.len(), mesh.materials.len());
            assert_eq!(mesh.positions.len(), mesh.normals.len());
            assert!(mesh.normals.iter().all(|n| (n.length() - 1.0).abs() < 1e-5));
            assert!(
                mesh.materials
                    .iter()
                    .all(|m| (*m as usize) < scene.materials.len())
            );
            assert!(mesh.positions.iter().all(|p| p.z > -1e-6));
        }
    }

    /// Shading normals look to the side from which a triangle is counter-clockwise.
    #[test]
    fn normals_and_windings_agree() {
        for mesh in scene().meshes {
            for triangle in &mesh.indices {
                let [a, b, c] = triangle.map(|i| mesh.positions[i as usize]);
                let face = (b - a).cross(c - a).normalize();
                for i in triangle {
                    let agreement = face.dot(mesh.normals[*i as usize]);
                    assert!(agreement > 0.2, "{}: {agreement} at {a}", mesh.name);
                }
            }
        }
    }

    /// The plane of the axis and the sun meets the floor in the hour line.
    #[test]
    fn the_dial_is_right() {
        let axis = dvec3(-LATITUDE.cos(), 0.0, LATITUDE.sin());
        for hour in -5..=5 {
            let h = f64::from(hour) * PI / 12.0;
            let (sin_l, cos_l) = LATITUDE.sin_cos();
            let sun = dvec3(h.cos() * sin_l, -h.sin(), cos_l * h.cos());
            let line = around_z(hour_line(hour) / TAU, 1.0);
            assert!(axis.cross(sun).dot(line).abs() < 1e-12);
            assert!(line.dot(sun) < 1e-12, "the shadow falls away from the sun");
        }
    }
}
