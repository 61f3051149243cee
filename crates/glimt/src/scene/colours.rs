//! Host file: the colours of a scene's materials, textures and vertices, brought to the primaries that light is rendered with.

use crate::colour::primaries::{Primaries, REC_709};
use glam::{DMat3, Vec3};
use glimt_render_gpu::prepare::plate::{linear_to_srgb8, srgb8_to_linear};
use glimt_render_gpu::prepare::scene::{Reflection, SceneDescription};
use rayon::prelude::*;

/// Converts all colours, which files and shots give with Rec. 709 primaries. Products of them, as of a texture and a factor, are then
/// products in the new primaries. Textures of numbers stay as they are.
pub(crate) fn convert(scene: &mut SceneDescription, working: &Primaries) {
    let Some(matrix) = REC_709.matrix_to(working) else {
        return;
    };
    for material in &mut scene.materials {
        match &mut material.reflection {
            Reflection::BlinnPhong {
                diffuse, specular, ..
            } => {
                *diffuse = albedo(&matrix, *diffuse);
                *specular = albedo(&matrix, *specular);
                // Where their sum was 1, rounding must not lift it above.
                let most = (*diffuse + *specular).max_element();
                if most > 1.0 {
                    (*diffuse, *specular) = (*diffuse / most, *specular / most);
                }
            }
            Reflection::MetallicRoughness { base_color, .. } => {
                *base_color = albedo(&matrix, *base_color);
            }
            Reflection::Unlit { color, .. } => *color = light(&matrix, *color),
        }
        material.emission = light(&matrix, material.emission);
    }
    for texture in scene.textures.iter_mut().filter(|texture| texture.srgb) {
        texture.texels.par_iter_mut().for_each(|[r, g, b, _]| {
            let colour = Vec3::from([*r, *g, *b].map(srgb8_to_linear));
            [*r, *g, *b] = light(&matrix, colour).to_array().map(linear_to_srgb8);
        });
    }
    for colour in scene.meshes.iter_mut().flat_map(|mesh| &mut mesh.colors) {
        *colour = albedo(&matrix, colour.truncate()).extend(colour.w);
    }
}

/// A colour that is not negative.
fn light(matrix: &DMat3, colour: Vec3) -> Vec3 {
    (*matrix * colour.as_dvec3()).as_vec3().max(Vec3::ZERO)
}

/// A colour in [0, 1].
fn albedo(matrix: &DMat3, colour: Vec3) -> Vec3 {
    light(matrix, colour).min(Vec3::ONE)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::colour::primaries::AP1;
    use glam::UVec2;
    use glimt_render_gpu::prepare::scene::{Texture, Wrap};

    #[test]
    fn colours_are_converted_and_numbers_are_not() {
        let grey = [188, 188, 188, 7];
        let red = [255, 0, 0, 9];
        let texture = |srgb| Texture {
            size: UVec2::new(2, 1),
            texels: vec![grey, red],
            srgb,
            wrap: [Wrap::Repeat; 2],
        };
        let material = Reflection::BlinnPhong {
            diffuse: Vec3::X,
            specular: Vec3::ZERO,
            exponent: 1.0,
        };
        let mut scene = SceneDescription {
            materials: vec![material.into()],
            textures: vec![texture(true), texture(false)],
            ..SceneDescription::default()
        };
        let plain = scene.clone();
        convert(&mut scene, &REC_709);
        assert_eq!(scene.materials, plain.materials);
        convert(&mut scene, &AP1);
        // Red of Rec. 709 in ACEScg (ACES, TB-2014-004 with the Bradford transform): 0.6131, 0.0702, 0.0206.
        let Reflection::BlinnPhong { diffuse, .. } = scene.materials[0].reflection else {
            panic!("another material");
        };
        let expected = Vec3::new(0.6131, 0.0702, 0.0206);
        assert!(diffuse.abs_diff_eq(expected, 2e-4), "{diffuse}");
        assert_eq!(scene.textures[0].texels[0], grey);
        let codes = expected.to_array().map(linear_to_srgb8);
        let [r, g, b, a] = scene.textures[0].texels[1];
        assert_eq!(([r, g, b], a), (codes, 9));
        assert_eq!(scene.textures[1].texels, [grey, red]);
    }
}
