//! Host file: the sculpture: an armillary sphere on a turned pedestal. It stands on z = 0, in metres.

use super::solid::{Knurl, Placement, Ring, Solid, around_z};
use crate::mesh::model::Model;
use glam::{DMat3, DVec2, DVec3, UVec2, Vec3, dvec2, uvec2, vec3};
use glimt_render_gpu::prepare::scene::{Material, Reflection};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// Latitude of the place where it stands: its axis points at the celestial pole.
const LATITUDE: f64 = 50.0 * PI / 180.0;

/// Height of the sphere's centre above the floor [m].
const CENTRE: f64 = 1.72;

// Indices into the model's materials.
const STONE: u32 = 0;
const LACQUER: u32 = 1;
const BRASS: u32 = 2;
const ENAMEL: u32 = 3;
const SILVER: u32 = 4;
const IVORY: u32 = 5;

/// The sculpture with its materials.
pub(super) fn model() -> Model {
    let mut sculpture = Solid::named("armillary");
    pedestal(&mut sculpture);
    cradle(&mut sculpture);
    sphere(&mut sculpture);
    let (materials, names) = materials().into_iter().unzip();
    Model {
        materials,
        material_names: names,
        z_up: true,
        ..Model::of_mesh(sculpture.into_mesh())
    }
}

fn materials() -> Vec<(Material, String)> {
    let material = |name: &str, diffuse, specular, exponent| {
        let material = Material::from(Reflection::BlinnPhong {
            diffuse,
            specular,
            exponent,
        });
        (material, name.to_owned())
    };
    vec![
        material("stone", vec3(0.60, 0.54, 0.46), Vec3::ZERO, 0.0),
        material("lacquer", vec3(0.36, 0.03, 0.02), Vec3::splat(0.12), 120.0),
        material(
            "brass",
            vec3(0.21, 0.12, 0.035),
            vec3(0.68, 0.47, 0.20),
            40.0,
        ),
        material("enamel", vec3(0.015, 0.09, 0.34), Vec3::splat(0.20), 400.0),
        material("silver", Vec3::splat(0.02), vec3(0.93, 0.92, 0.90), 6000.0),
        material("ivory", vec3(0.66, 0.60, 0.48), Vec3::splat(0.08), 90.0),
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
    let stone: [(UVec2, DVec2, DVec2, f64); 11] = [
        (flat, at(0.80, 0.0), at(0.80, 0.085), 0.0),
        (fine, at(0.80, 0.085), at(0.78, 0.105), 0.008),
        (flat, at(0.78, 0.105), at(0.62, 0.105), 0.0),
        (fine, at(0.62, 0.105), at(0.62, 0.185), 0.04),
        (flat, at(0.62, 0.185), at(0.56, 0.185), 0.0),
        (fine, at(0.56, 0.185), at(0.38, 0.315), -0.07),
        (flat, at(0.38, 0.315), at(0.41, 0.315), 0.0),
        (fine, at(0.41, 0.315), at(0.41, 0.375), 0.03),
        (flat, at(0.41, 0.375), at(0.30, 0.375), 0.0),
        (flat, at(0.30, 0.375), at(0.30, 0.40), 0.0),
        (flat, at(0.30, 0.40), at(0.08, 0.40), 0.0),
    ];
    for (cells, a, b, bulge) in stone {
        solid.lathe(STONE, cells, arc(a, b, bulge));
    }
    // The vase: a slow wave in height, 20 flutes around that fade towards its ends.
    solid.patch(LACQUER, uvec2(320, 72), |uv| {
        let t = uv.y;
        let wave = 0.5 - 0.5 * (TAU * (0.16 + 0.82 * t.powf(0.85))).cos();
        let body = 0.075 + 0.19 * wave.powf(1.3);
        let flutes = 0.024 * (PI * t).sin().max(0.0) * (10.0 * TAU * uv.x).sin().abs();
        around_z(uv.x, body - flutes) + (0.40 + 0.46 * t) * DVec3::Z
    });
    for (height, radius, half) in [
        (0.418, 0.145, dvec2(0.030, 0.020)),
        (0.852, 0.085, dvec2(0.035, 0.022)),
    ] {
        let place = Placement {
            turn: DMat3::IDENTITY,
            origin: height * DVec3::Z,
        };
        solid.ring(BRASS, uvec2(128, 24), &Ring::plain(radius, half), &place);
    }
    solid.lathe(
        BRASS,
        uvec2(96, 24),
        arc(at(0.09, 0.86), at(0.0, 0.93), 0.03),
    );
}

/// Four lacquered bows that carry the horizon, the one ring that does not tilt.
fn cradle(solid: &mut Solid) {
    let centre = CENTRE * DVec3::Z;
    let level = Placement {
        turn: DMat3::IDENTITY,
        origin: centre,
    };
    solid.ring(
        ENAMEL,
        uvec2(360, 28),
        &Ring {
            radius: 0.90,
            half: dvec2(0.060, 0.022),
            knurl: Knurl {
                count: 72.0,
                depth: 0.012,
            },
        },
        &level,
    );
    for bow in 0..4 {
        let out = around_z((f64::from(bow) + 0.5) / 4.0, 1.0);
        let side = DVec3::Z.cross(out);
        solid.patch(LACQUER, uvec2(20, 64), |uv| {
            let angle = -FRAC_PI_2 * (0.985 - 0.985 * uv.y);
            let along = angle.cos() * out + angle.sin() * DVec3::Z;
            let section = 0.030 * circle(uv.x);
            centre + (0.87 + section.y) * along + section.x * side
        });
    }
}

/// A circle's point, counter-clockwise.
fn circle(turns: f64) -> DVec2 {
    let (sin, cos) = (TAU * turns).sin_cos();
    dvec2(cos, sin)
}

/// Meridian, equator, tropics, colures and ecliptic about the polar axis, and a globe.
fn sphere(solid: &mut Solid) {
    let polar = Placement {
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
        &Ring {
            radius: 0.79,
            half: dvec2(0.024, 0.036),
            knurl,
        },
        &polar.turned(upright),
    );
    for turn in [FRAC_PI_2 * 0.5, -FRAC_PI_2 * 0.5] {
        let colure = polar.turned(DMat3::from_rotation_z(turn) * upright);
        solid.ring(
            BRASS,
            around,
            &Ring::plain(0.705, dvec2(0.014, 0.022)),
            &colure,
        );
    }
    solid.ring(
        BRASS,
        around,
        &Ring::plain(0.715, dvec2(0.018, 0.045)),
        &polar,
    );
    for latitude in [obliquity, -obliquity] {
        let tropic = polar.raised(0.705 * latitude.sin());
        let radius = 0.705 * latitude.cos();
        solid.ring(
            BRASS,
            around,
            &Ring::plain(radius, dvec2(0.014, 0.020)),
            &tropic,
        );
    }
    let ecliptic = polar.turned(DMat3::from_rotation_x(obliquity));
    solid.ring(
        IVORY,
        around,
        &Ring::plain(0.66, dvec2(0.012, 0.070)),
        &ecliptic,
    );
    globe(solid, &polar);
    axis(solid, &polar);
}

/// A globe of enamel with meridians and parallels cut into it.
fn globe(solid: &mut Solid, polar: &Placement) {
    solid.patch(SILVER, uvec2(288, 144), |uv| {
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
fn axis(solid: &mut Solid, polar: &Placement) {
    let ball = uvec2(64, 32);
    solid.rod(BRASS, uvec2(40, 1), [-1.0, 1.0], |_| 0.018, polar);
    solid.ball(SILVER, ball, 0.055, &polar.raised(1.0));
    solid.ball(SILVER, ball, 0.055, &polar.raised(-1.0));
    let point = |z: f64| (0.035 * (1.22 - z) / 0.17).max(0.0);
    solid.rod(BRASS, uvec2(40, 12), [1.05, 1.22], point, polar);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_sculpture_is_sound() {
        let model = model();
        let mesh = &model.meshes[0];
        assert!(mesh.indices.len() >= 20_000, "{}", mesh.indices.len());
        assert_eq!(mesh.indices.len(), mesh.materials.len());
        assert_eq!(mesh.positions.len(), mesh.normals.len());
        assert!(mesh.normals.iter().all(|n| (n.length() - 1.0).abs() < 1e-5));
        assert!(
            mesh.materials
                .iter()
                .all(|m| (*m as usize) < model.materials.len())
        );
        assert!(mesh.positions.iter().all(|p| p.z > -1e-6));
    }

    /// Shading normals look to the side from which a triangle is counter-clockwise.
    #[test]
    fn normals_and_windings_agree() {
        let model = model();
        let mesh = &model.meshes[0];
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
