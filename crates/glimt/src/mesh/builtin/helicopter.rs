//! Host file: a light helicopter on its skids, with rotors to be spun. It stands on z = 0, nose towards +x, in metres.
//!
//! Its nodes are `helicopter` and in it `fuselage`, `canopy`, `tail boom`, `skids`, `main rotor` and `tail rotor`; the rotors
//! turn about their own z axes.

use super::solid::{Placement, Ring, Solid};
use crate::mesh::model::{Model, Part};
use crate::mesh::node::{Node, Trs};
use glam::{DMat3, DVec2, DVec3, Quat, UVec2, Vec3, dvec2, dvec3, uvec2, vec3};
use glimt_render_gpu::prepare::scene::{Material, Reflection};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

// Indices into the model's materials.
const PAINT: u32 = 0;
const WHITE: u32 = 1;
const GLASS: u32 = 2;
const BLADE: u32 = 3;
const METAL: u32 = 4;
const MATT: u32 = 5;
const CHROME: u32 = 6;
const TIP: u32 = 7;

/// Where the main rotor's hub is.
const HUB: Vec3 = vec3(0.0, 0.0, 2.86);
/// Where the tail rotor's hub is.
const TAIL_HUB: Vec3 = vec3(-4.95, -0.3, 2.12);

/// The helicopter with its materials.
pub(super) fn model() -> Model {
    let at = |name: &str, translation| Node::at(name, Some(0), translation);
    let upright = Quat::from_rotation_x(std::f32::consts::FRAC_PI_2);
    let tail_rotor = Trs {
        translation: TAIL_HUB,
        rotation: upright,
        ..Trs::IDENTITY
    };
    let nodes = vec![
        Node::at("helicopter", None, Vec3::ZERO),
        at("fuselage", Vec3::ZERO),
        at("canopy", Vec3::ZERO),
        at("tail boom", Vec3::ZERO),
        at("skids", Vec3::ZERO),
        at("main rotor", HUB),
        Node {
            local: tail_rotor.matrix(),
            parts: tail_rotor,
            ..at("tail rotor", TAIL_HUB)
        },
    ];
    let pieces = [
        fuselage as fn(&mut Solid),
        canopy,
        tail_boom,
        skids,
        main_rotor,
        tail_rotor_blades,
    ];
    let names = nodes.iter().skip(1).map(|node| node.name.as_str());
    let meshes = names.zip(pieces).map(|(name, piece)| {
        let mut solid = Solid::named(name);
        piece(&mut solid);
        solid.into_mesh()
    });
    let (materials, material_names) = materials().into_iter().unzip();
    Model {
        meshes: meshes.collect(),
        parts: (0..6)
            .map(|mesh| Part {
                mesh,
                node: mesh + 1,
                skin: None,
            })
            .collect(),
        nodes,
        materials,
        material_names,
        z_up: true,
        ..Model::default()
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
        material("paint", vec3(0.42, 0.03, 0.02), Vec3::splat(0.22), 300.0),
        material("white", Vec3::splat(0.55), Vec3::splat(0.15), 120.0),
        material("glass", vec3(0.01, 0.014, 0.018), Vec3::splat(0.5), 500.0),
        material("blade", Vec3::splat(0.04), Vec3::splat(0.30), 60.0),
        material("metal", Vec3::splat(0.12), Vec3::splat(0.55), 30.0),
        material("matt", Vec3::splat(0.05), Vec3::ZERO, 0.0),
        material("chrome", Vec3::splat(0.03), Vec3::splat(0.85), 450.0),
        material("tip", vec3(0.65, 0.42, 0.02), Vec3::splat(0.08), 80.0),
    ]
}

/// A point of the pod's skin, `off` of its size above it: `along` from its tail at 0 to its nose at 1, `angle` from +y over
/// the top.
fn pod(along: f64, angle: f64, off: f64) -> DVec3 {
    let theta = PI * (1.0 - along);
    // Blunt in front, drawn out and up towards the boom.
    let x = 0.25 + if along > 0.5 { 1.75 } else { 2.15 } * theta.cos();
    let swell = theta
        .sin()
        .max(0.0)
        .powf(if along > 0.5 { 0.85 } else { 1.15 });
    let (sin, cos) = angle.sin_cos();
    // Flatter below than above, a little squared.
    let square = (cos.powi(4) + sin.powi(4)).powf(-0.25).min(1.1);
    let half = dvec2(0.74, if sin > 0.0 { 0.92 } else { 0.66 }) * (swell * square * (1.0 + off));
    let centre = 1.32 + 0.35 * (1.0 - along).powi(2) - 0.12 * along * along;
    dvec3(x, half.x * cos, centre + half.y * sin)
}

/// Where along the pod the glass begins.
const GLASS_FROM: f64 = 0.46;
/// The angle above the horizon down to which the glass reaches.
const GLASS_LOW: f64 = -0.28;

fn fuselage(solid: &mut Solid) {
    solid.patch(PAINT, uvec2(40, 14), |uv| {
        pod(GLASS_FROM * uv.y, TAU * uv.x, 0.0)
    });
    let ahead = move |v: f64| GLASS_FROM + (1.0 - GLASS_FROM) * v;
    let belly = PI + 2.0 * GLASS_LOW;
    solid.patch(WHITE, uvec2(20, 16), move |uv| {
        pod(ahead(uv.y), PI - GLASS_LOW + belly * uv.x, 0.0)
    });
    // The cowling, with the mast and its swash plate.
    solid.patch(WHITE, uvec2(28, 14), |uv| {
        let theta = PI * (1.0 - uv.y);
        let (sin, cos) = (TAU * uv.x).sin_cos();
        let ring = theta.sin();
        dvec3(
            -0.35 + 1.25 * theta.cos(),
            0.42 * ring * cos,
            2.1 + 0.40 * ring * sin,
        )
    });
    let top = f64::from(HUB.z);
    solid.rod(
        CHROME,
        uvec2(16, 1),
        [2.3, top],
        |_| 0.055,
        &Placement::IDENTITY,
    );
    solid.ring(
        METAL,
        uvec2(24, 10),
        &Ring::plain(0.13, dvec2(0.05, 0.03)),
        &Placement::at_height(2.58),
    );
    for side in [-1.0, 1.0] {
        // Exhausts, black inside.
        let path = move |s: f64| dvec3(-0.95 - 0.35 * s, side * (0.28 + 0.14 * s), 2.05 + 0.1 * s);
        tube(solid, METAL, uvec2(14, 3), path, DVec3::Z, |_| 0.09);
        ball(solid, MATT, path(0.93), 0.085);
    }
    ball(solid, PAINT, dvec3(-0.75, 0.0, 2.48), 0.07);
}

/// Glass from the doors to the nose, with its frame.
fn canopy(solid: &mut Solid) {
    let ahead = move |v: f64| GLASS_FROM + (1.0 - GLASS_FROM) * v;
    let over = PI - 2.0 * GLASS_LOW;
    solid.patch(GLASS, uvec2(36, 20), move |uv| {
        pod(ahead(uv.y), GLASS_LOW + over * uv.x, 0.0)
    });
    let strip = |solid: &mut Solid, along: [f64; 2], angle: [f64; 2], cells: UVec2| {
        solid.patch(PAINT, cells, move |uv| {
            let at = along[0] + (along[1] - along[0]) * uv.y;
            pod(at, angle[0] + (angle[1] - angle[0]) * uv.x, 0.012)
        });
    };
    let around = [GLASS_LOW, PI - GLASS_LOW];
    for along in [[0.445, 0.475], [0.60, 0.615]] {
        strip(solid, along, around, uvec2(36, 1));
    }
    strip(
        solid,
        [0.46, 0.97],
        [FRAC_PI_2 - 0.035, FRAC_PI_2 + 0.035],
        uvec2(2, 20),
    );
    for low in [GLASS_LOW, PI - GLASS_LOW] {
        strip(solid, [0.46, 0.97], [low - 0.04, low + 0.04], uvec2(2, 20));
    }
}

fn tail_boom(solid: &mut Solid) {
    let path = |s: f64| dvec3(-1.25 - 3.75 * s, 0.0, 1.72 + 0.30 * s);
    tube(solid, PAINT, uvec2(24, 8), path, DVec3::Y, |s| {
        0.27 - 0.15 * s
    });
    ball(solid, PAINT, path(1.0), 0.12);
    // A white band.
    tube(
        solid,
        WHITE,
        uvec2(24, 1),
        |s| path(0.62 + 0.10 * s),
        DVec3::Y,
        |s| 0.274 - 0.15 * (0.62 + 0.10 * s),
    );
    let swept = |from: DVec3, span: DVec3, chord: [f64; 2]| Wing {
        from,
        span,
        chord: DVec3::X,
        widths: chord,
        thickness: 0.14,
        sweep: 0.0,
    };
    let up = swept(
        dvec3(-4.72, 0.0, 1.98),
        dvec3(-0.55, 0.0, 1.02),
        [0.62, 0.36],
    );
    let down = swept(
        dvec3(-4.72, 0.0, 2.02),
        dvec3(-0.30, 0.0, -0.72),
        [0.52, 0.28],
    );
    up.add(solid, WHITE, uvec2(20, 8), [0.0, 1.0], true);
    down.add(solid, WHITE, uvec2(20, 8), [0.0, 1.0], true);
    for side in [-1.0, 1.0] {
        let tail = swept(
            dvec3(-3.6, 0.0, 1.9),
            dvec3(-0.1, 0.95 * side, 0.0),
            [0.48, 0.36],
        );
        tail.add(solid, WHITE, uvec2(20, 8), [0.0, 1.0], true);
    }
    // The tail rotor's gear.
    let hub = TAIL_HUB.as_dvec3();
    tube(
        solid,
        METAL,
        uvec2(14, 1),
        move |s| dvec3(hub.x, 0.05 + (hub.y - 0.05) * s, hub.z),
        DVec3::X,
        |_| 0.05,
    );
}

fn skids(solid: &mut Solid) {
    for side in [-1.0, 1.0] {
        let y = 1.0 * side;
        let path = move |s: f64| {
            let x = -1.5 + 3.3 * s;
            let bow = ((s - 0.8) / 0.2).max(0.0);
            dvec3(x, y, 0.055 + 0.30 * bow * bow)
        };
        tube(solid, METAL, uvec2(12, 20), path, DVec3::Y, |_| 0.055);
        for end in [0.0, 1.0] {
            ball(solid, METAL, path(end), 0.055);
        }
        for x in [-0.75, 0.95] {
            let leg = move |s: f64| {
                let (a, b, c) = (
                    dvec2(y, 0.06),
                    dvec2(0.86 * side, 0.62),
                    dvec2(0.25 * side, 0.80),
                );
                let p = a.lerp(b, s).lerp(b.lerp(c, s), s);
                dvec3(x, p.x, p.y)
            };
            tube(solid, METAL, uvec2(10, 8), leg, DVec3::X, |_| 0.042);
        }
    }
}

fn main_rotor(solid: &mut Solid) {
    hub(solid, 0.17, 0.09);
    for blade in 0..4 {
        let angle = TAU * (f64::from(blade) / 4.0 + 0.06);
        rotor_blade(solid, angle, [0.18, 4.35], [0.26, 0.22], 0.14);
    }
}

fn tail_rotor_blades(solid: &mut Solid) {
    hub(solid, 0.07, 0.05);
    for blade in 0..2 {
        rotor_blade(
            solid,
            PI * f64::from(blade),
            [0.06, 0.78],
            [0.14, 0.12],
            0.0,
        );
    }
}

/// A flattened ball about the origin.
fn hub(solid: &mut Solid, radius: f64, half_height: f64) {
    solid.patch(CHROME, uvec2(18, 9), move |uv| {
        let theta = PI * (1.0 - uv.y);
        let (sin, cos) = (TAU * uv.x).sin_cos();
        let ring = radius * theta.sin();
        dvec3(ring * cos, ring * sin, half_height * theta.cos())
    });
}

/// A blade that turns counter-clockwise, its grip at the root and its painted tip; it rises by `cone` towards the tip.
fn rotor_blade(solid: &mut Solid, angle: f64, reach: [f64; 2], widths: [f64; 2], cone: f64) {
    let out = dvec3(angle.cos(), angle.sin(), 0.0);
    let ahead = DVec3::Z.cross(out);
    let long = reach[1] - reach[0];
    let root = 0.10 * long;
    let blade = Wing {
        from: out * (reach[0] + root),
        span: out * (long - root) + DVec3::Z * cone,
        // The leading edge stands a little higher: it lifts.
        chord: (ahead + 0.14 * DVec3::Z).normalize(),
        widths,
        thickness: 0.13,
        sweep: 0.0,
    };
    blade.add(solid, BLADE, uvec2(14, 5), [0.0, 0.9], false);
    blade.add(solid, TIP, uvec2(14, 4), [0.9, 1.0], true);
    let grip = 0.16 * widths[0];
    tube(
        solid,
        METAL,
        uvec2(12, 1),
        move |s| out * (reach[0] * 0.6 + (reach[0] * 0.4 + 1.4 * root) * s),
        ahead,
        move |_| grip,
    );
}

/// A wing of elliptic sections, from its root along its span.
struct Wing {
    from: DVec3,
    span: DVec3,
    /// The direction of its leading edge, unit length.
    chord: DVec3,
    /// From edge to edge at root and tip.
    widths: [f64; 2],
    /// As a share of the width.
    thickness: f64,
    /// How far the tip lies behind the root.
    sweep: f64,
}

impl Wing {
    /// Adds a stretch of it; with `ends` it is closed at the tip by a curve.
    fn add(&self, solid: &mut Solid, material: u32, cells: UVec2, stretch: [f64; 2], ends: bool) {
        let normal = self.span.cross(self.chord).normalize();
        let [from, to] = stretch;
        solid.patch(material, cells, |uv| {
            // Closer together towards a closed tip, where it curves.
            let v = if ends {
                1.0 - (1.0 - uv.y).max(0.0).powf(1.6)
            } else {
                uv.y
            };
            let s = from + (to - from) * v;
            let close = if ends {
                (1.0 - v.max(0.0).powi(6)).max(0.0).sqrt()
            } else {
                1.0
            };
            let width = (self.widths[0] + (self.widths[1] - self.widths[0]) * s) * close;
            let (sin, cos) = (TAU * uv.x).sin_cos();
            self.from + self.span * s - self.chord * self.sweep * s
                + 0.5 * width * (self.chord * cos + normal * self.thickness * sin)
        });
    }
}

/// A tube along a path that bends across `side` alone, open at both ends.
fn tube(
    solid: &mut Solid,
    material: u32,
    cells: UVec2,
    path: impl Fn(f64) -> DVec3,
    side: DVec3,
    radius: impl Fn(f64) -> f64,
) {
    solid.patch(material, cells, |uv| {
        let step = 1e-4;
        let along = (path(uv.y + step) - path(uv.y - step)).normalize();
        let across = (side - along * side.dot(along)).normalize();
        let normal = along.cross(across);
        let circle = DVec2::from_angle(TAU * uv.x);
        path(uv.y) + radius(uv.y) * (across * circle.x + normal * circle.y)
    });
}

fn ball(solid: &mut Solid, material: u32, centre: DVec3, radius: f64) {
    let place = Placement {
        turn: DMat3::IDENTITY,
        origin: centre,
    };
    solid.ball(material, uvec2(10, 6), radius, &place);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn faces_look_as_their_normals_do() {
        let model = model();
        for mesh in &model.meshes {
            for triangle in &mesh.indices {
                let [a, b, c] = triangle.map(|i| mesh.positions[i as usize]);
                let face = (b - a).cross(c - a).normalize();
                for i in triangle {
                    let agreement = face.dot(mesh.normals[*i as usize]);
                    assert!(agreement > 0.1, "{}: {agreement} at {a}", mesh.name);
                }
            }
        }
    }

    #[test]
    fn it_stands_on_the_ground_and_its_blades_clear_the_boom() {
        let model = model();
        let (low, high) = model.bounds(&model.rest(), glam::Mat4::IDENTITY).unwrap();
        assert!(low.z.abs() < 2e-3 && high.z < 3.5, "{low} {high}");
        let triangles = model.triangles();
        assert!((3000..13_000).contains(&triangles), "{triangles}");
        let part = |name: &str| {
            let mesh = model.meshes.iter().find(|mesh| mesh.name == name).unwrap();
            mesh.positions.iter()
        };
        let boom = part("tail boom").map(|p| p.z);
        let fin = boom.fold(f32::MIN, f32::max);
        let blades = part("main rotor").map(|p| p.x.hypot(p.y));
        let reach = blades.fold(f32::MIN, f32::max);
        // The fin is higher than the blades are low; they must not reach it.
        let before = part("tail boom")
            .filter(|p| p.z > HUB.z - 0.2)
            .map(|p| -p.x);
        let nearest = before.fold(f32::MAX, f32::min);
        assert!(fin > HUB.z && reach < nearest, "{reach} {nearest}");
    }
}
