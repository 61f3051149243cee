//! Host file: the objects of a shot placed in the world, and the camera that looks at them.

use super::{Model, load};
use crate::error::{Error, Result, nearest};
use crate::notes::Notes;
use crate::shot::digest::{Hash, join};
use crate::shot::parse::Source;
use crate::shot::{self, Shot, Up};
use glam::{EulerRot, Mat3, Mat4, Quat, Vec3};
use glimt_render_gpu::host::scene::{Camera, Material, Object, SceneDescription};
use glimt_render_gpu::host::scene_build::MAX_COORDINATE;
use std::collections::HashMap;
use std::f32::consts::FRAC_PI_2;
use std::path::Path;

/// A scene with the camera of its shot.
#[derive(Clone, Debug)]
pub struct Placed {
    /// Meshes, materials, objects.
    pub scene: SceneDescription,
    /// Where it is seen from.
    pub camera: Camera,
    /// Hash of the contents of all mesh files.
    pub digest: Hash,
    /// Triangles, counting each placing of a mesh.
    pub triangles: usize,
    /// Which of the shot's objects each object of the scene is a part of.
    pub owners: Vec<usize>,
}

/// Loads the meshes of a shot and places them.
///
/// # Errors
/// A mesh cannot be loaded, or the camera cannot be placed.
pub fn place(shot: &Shot, source: &Source, base: &Path, notes: &mut Notes) -> Result<Placed> {
    let mut scene = SceneDescription::default();
    let mut loaded: HashMap<&str, Loaded> = HashMap::new();
    let mut digests = Vec::new();
    let mut cameras = Vec::new();
    let mut all: Option<(Vec3, Vec3)> = None;
    let mut subject: Option<(Vec3, Vec3)> = None;
    let mut triangles = 0;
    let mut owners = Vec::new();
    for (index, object) in shot.objects.iter().enumerate() {
        let name = object.mesh.as_str();
        if !loaded.contains_key(name) {
            let model = load(base, name, notes)?;
            loaded.insert(name, Loaded::new(model, &mut scene));
        }
        let entry = &loaded[name];
        let model = &entry.model;
        digests.push(model.digest(name)?);
        triangles += model.triangles();

        let transform = transform(object, model);
        let material = object.material.as_ref().map(|m| {
            scene.materials.push(Material::BlinnPhong {
                diffuse: m.diffuse.into(),
                specular: m.specular.into(),
                exponent: m.exponent,
            });
            scene.materials.len() as u32 - 1
        });
        scene.objects.extend(model.parts.iter().map(|part| Object {
            mesh: entry.first_mesh + part.mesh as u32,
            transform: transform * part.transform,
            material,
            catcher: object.catcher,
        }));
        owners.resize(scene.objects.len(), index);
        cameras.extend(model.cameras.iter().map(|camera| {
            let to_world = transform * camera.transform;
            (camera.name.clone(), to_world, camera.fov_y)
        }));
        if let Some(bounds) = model.bounds(transform) {
            let reach = bounds.0.abs().max(bounds.1.abs()).max_element();
            if !(reach <= MAX_COORDINATE) {
                let what = format!("the object reaches {reach:.1e} units from the origin");
                return Err(source
                    .error(&format!("object.{index}.scale"), what)
                    .fix("the world ends at 1e9 units: lower its scale, or move it nearer"));
            }
            grow(&mut all, bounds);
            // What is in the footage already is no more the subject than a floor.
            if name != "plane" && !object.catcher {
                grow(&mut subject, bounds);
            }
        }
    }
    let bounds = subject.or(all).unwrap_or((Vec3::NEG_ONE, Vec3::ONE));
    Ok(Placed {
        camera: camera(shot, source, bounds, &cameras)?,
        scene,
        digest: join(&digests),
        triangles,
        owners,
    })
}

/// A model whose meshes are in the scene, from `first_mesh` on.
struct Loaded {
    model: Model,
    first_mesh: u32,
}

impl Loaded {
    /// Moves a model's lists into the scene, and makes their indices the scene's.
    fn new(mut model: Model, scene: &mut SceneDescription) -> Self {
        let first_mesh = scene.meshes.len() as u32;
        let first_material = scene.materials.len() as u32;
        let first_texture = scene.textures.len() as u32;
        for material in &mut model.materials {
            if let Material::MetallicRoughness {
                base_color_texture,
                metallic_roughness_texture,
                normal_texture,
                ..
            } = material
            {
                let textures = [
                    base_color_texture,
                    metallic_roughness_texture,
                    normal_texture,
                ];
                for index in textures.into_iter().flatten() {
                    *index += first_texture;
                }
            }
        }
        // The model keeps its meshes for bounds and counts; materials and textures are the scene's from here on.
        scene.materials.append(&mut model.materials);
        scene.textures.append(&mut model.textures);
        scene
            .meshes
            .extend(model.meshes.iter().cloned().map(|mut mesh| {
                for material in &mut mesh.materials {
                    *material += first_material;
                }
                mesh
            }));
        Self { model, first_mesh }
    }
}

fn grow(bounds: &mut Option<(Vec3, Vec3)>, (low, high): (Vec3, Vec3)) {
    let (a, b) = bounds.unwrap_or((low, high));
    *bounds = Some((a.min(low), b.max(high)));
}

/// To the world's axes, scaled, turned about x, y, z (fixed axes), set on the ground, moved.
fn transform(object: &shot::Object, model: &Model) -> Mat4 {
    let default_up = if model.z_up { Up::Z } else { Up::Y };
    let up = match object.up.unwrap_or(default_up) {
        Up::Y => Mat4::from_rotation_x(FRAC_PI_2),
        Up::Z => Mat4::IDENTITY,
    };
    let [x, y, z] = object.rotate_deg.map(f32::to_radians);
    // Fixed axes x, y, z in this order are the moving axes z, y, x.
    let rotation = Mat4::from_quat(Quat::from_euler(EulerRot::ZYX, z, y, x));
    let turned = rotation * Mat4::from_scale(Vec3::splat(object.scale)) * up;
    let mut translate = Vec3::from(object.translate);
    if object.ground
        && let Some((low, _)) = model.bounds(turned)
    {
        translate.z -= low.z;
    }
    Mat4::from_translation(translate) * turned
}

/// The direction from which objects are looked at when a shot does not say: along +x, the middle of a lat-long map, from
/// a little to the side and above.
const VIEW_FROM: Vec3 = Vec3::new(-1.0, -0.45, 0.35);

fn camera(
    shot: &Shot,
    source: &Source,
    (low, high): (Vec3, Vec3),
    cameras: &[(String, Mat4, f32)],
) -> Result<Camera> {
    let keys = &shot.camera;
    let [width, height] = shot.image.size.map(|n| n as f32);
    if !keys.gltf.is_empty() {
        return from_gltf(keys, source, width / height, cameras);
    }
    let fov_x = keys.fov_x_deg.to_radians();
    let target = keys.target.map_or((low + high) * 0.5, Vec3::from);
    let eye = keys.eye.map_or_else(
        || {
            // A sphere around the bounds fills most of the narrower side.
            let radius = ((high - low).length() * 0.5).max(1e-6);
            let half_x = (0.5 * fov_x).tan();
            let half = half_x.min(half_x * height / width).atan();
            target + VIEW_FROM.normalize() * (radius / half.sin())
        },
        Vec3::from,
    );
    let up = Vec3::from(keys.up);
    if eye == target {
        return Err(source
            .error("camera.target", "it is where the eye is")
            .fix("the camera must look somewhere: move one of them"));
    }
    let forward = (target.as_dvec3() - eye.as_dvec3()).normalize();
    if !(forward.cross(up.as_dvec3().normalize()).length() > 1e-6) {
        let across = match forward.abs().min_position() {
            0 => "[1, 0, 0]",
            1 => "[0, 1, 0]",
            _ => "[0, 0, 1]",
        };
        return Err(source
            .error("camera.up", "it lies along the line of sight")
            .fix(format!("choose a direction across it, as {across}")));
    }
    Ok(Camera {
        eye,
        target,
        up,
        fov_x,
    })
}

fn from_gltf(
    keys: &shot::Camera,
    source: &Source,
    aspect: f32,
    cameras: &[(String, Mat4, f32)],
) -> Result<Camera> {
    let Some((_, to_world, fov_y)) = cameras.iter().find(|(name, ..)| *name == keys.gltf) else {
        let what = format!("no glTF file of the shot has a camera `{}`", keys.gltf);
        let error: Error = source.error("camera.gltf", what);
        let names: Vec<&str> = cameras.iter().map(|(name, ..)| name.as_str()).collect();
        return Err(match nearest(&keys.gltf, names.iter().copied()) {
            Some(near) => error.fix(format!("did you mean `{near}`?")),
            None if names.is_empty() => error.fix("there is none at all: give eye and target"),
            None => error.fix(format!("there are: {}", names.join(", "))),
        });
    };
    let axes = Mat3::from_mat4(*to_world);
    let eye = to_world.transform_point3(Vec3::ZERO);
    Ok(Camera {
        eye,
        target: eye - axes.z_axis.normalize(),
        up: axes.y_axis.normalize(),
        fov_x: 2.0 * ((0.5 * fov_y).tan() * aspect).atan(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn turns_about_fixed_axes_in_order() {
        let object = shot::Object {
            rotate_deg: [90.0, 0.0, 90.0],
            scale: 2.0,
            translate: [0.0, 0.0, 1.0],
            up: Some(Up::Z),
            ..shot::Object::default()
        };
        let matrix = transform(&object, &Model::default());
        // y → z by the turn about x, and stays so about z; x → y about z.
        let y = matrix.transform_point3(Vec3::Y);
        assert!((y - Vec3::new(0.0, 0.0, 3.0)).length() < 1e-5, "{y}");
        let x = matrix.transform_point3(Vec3::X);
        assert!((x - Vec3::new(0.0, 2.0, 1.0)).length() < 1e-5, "{x}");
    }

    #[test]
    fn y_up_becomes_z_up() {
        let matrix = transform(&shot::Object::default(), &Model::default());
        assert!((matrix.transform_point3(Vec3::Y) - Vec3::Z).length() < 1e-6);
        assert!((matrix.transform_point3(Vec3::Z) - Vec3::NEG_Y).length() < 1e-6);
    }
}
