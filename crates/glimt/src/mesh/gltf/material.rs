//! Host file: glTF materials.

use super::Reader;
use super::texture::Use;
use crate::error::Result;
use ::gltf::Material as Source;
use ::gltf::material::AlphaMode;
use glam::Vec3;
use glimt_render_gpu::prepare::scene::{Alpha, Material, Opacity, Reflection, TextureRef};
use serde_json::Value;

/// Roughness below this acts as this.
const LEAST_ROUGHNESS: f32 = 0.12;

/// Extensions that change the look of a material and are not supported, with the factor that switches each on and its default.
const UNSUPPORTED: [(&str, &str, f64); 10] = [
    ("KHR_materials_transmission", "transmissionFactor", 0.0),
    (
        "KHR_materials_diffuse_transmission",
        "diffuseTransmissionFactor",
        0.0,
    ),
    ("KHR_materials_volume", "thicknessFactor", 0.0),
    ("KHR_materials_volume_scatter", "", 1.0),
    ("KHR_materials_clearcoat", "clearcoatFactor", 0.0),
    ("KHR_materials_sheen", "sheenColorFactor", 0.0),
    ("KHR_materials_iridescence", "iridescenceFactor", 0.0),
    ("KHR_materials_anisotropy", "anisotropyStrength", 0.0),
    ("KHR_materials_dispersion", "dispersion", 0.0),
    ("KHR_materials_pbrSpecularGlossiness", "", 1.0),
];

/// Whether an extension of materials is remarked on where a material uses it.
pub(super) fn is_remarked(extension: &str) -> bool {
    UNSUPPORTED.iter().any(|(name, ..)| *name == extension)
}

/// The textures of a material that are used.
struct Uses {
    base_color: Option<Use>,
    metallic_roughness: Option<Use>,
    normal: Option<Use>,
    emission: Option<Use>,
}

impl Uses {
    fn of(material: &Source<'_>) -> Self {
        let pbr = material.pbr_metallic_roughness();
        let is_lit = !is_unlit(material);
        Self {
            base_color: pbr.base_color_texture().map(|t| Use::of(&t)),
            metallic_roughness: pbr
                .metallic_roughness_texture()
                .filter(|_| is_lit)
                .map(|t| Use::of(&t)),
            normal: material
                .normal_texture()
                .filter(|_| is_lit)
                .map(|t| Use::of_normals(&t)),
            emission: material
                .emissive_texture()
                .filter(|_| is_lit && material.emissive_factor() != [0.0; 3])
                .map(|t| Use::of(&t)),
        }
    }

    fn sets(&self) -> impl Iterator<Item = u32> {
        let all = [
            self.base_color,
            self.metallic_roughness,
            self.normal,
            self.emission,
        ];
        all.into_iter().flatten().map(|of| of.set)
    }
}

/// The set of texture coordinates that a material's base colour is looked up by, or else its other textures; `None` without any.
pub(super) fn texture_set(material: &Source<'_>) -> Option<u32> {
    Uses::of(material).sets().next()
}

fn is_unlit(material: &Source<'_>) -> bool {
    material.extension_value("KHR_materials_unlit").is_some()
}

impl Reader<'_> {
    /// The index of a material, which is read when it is first used.
    pub(super) fn material(&mut self, material: &Source<'_>) -> Result<u32> {
        if let Some(&index) = self.materials.get(&material.index()) {
            return Ok(index);
        }
        let name = match (material.name(), material.index()) {
            (Some(name), _) => name.to_owned(),
            (None, Some(index)) => format!("material {index}"),
            (None, None) => "default".to_owned(),
        };
        let uses = Uses::of(material);
        let base_color_texture = self.texture_ref(uses.base_color, true)?;
        let read = Material {
            opacity: opacity(material, base_color_texture),
            emission: emission(material),
            emission_texture: self.texture_ref(uses.emission, true)?,
            reflection: self.reflection(material, &uses, base_color_texture)?,
        };
        self.remark_on(material, &uses, &read, &name)?;
        let index = self.model.materials.len() as u32;
        self.model.materials.push(read);
        self.model.material_names.push(name);
        self.materials.insert(material.index(), index);
        Ok(index)
    }

    fn reflection(
        &mut self,
        material: &Source<'_>,
        uses: &Uses,
        base_color_texture: Option<TextureRef>,
    ) -> Result<Reflection> {
        let pbr = material.pbr_metallic_roughness();
        let [r, g, b, _] = pbr.base_color_factor();
        let base_color = Vec3::new(r, g, b);
        if is_unlit(material) {
            return Ok(Reflection::Unlit {
                color: base_color,
                color_texture: base_color_texture,
            });
        }
        Ok(Reflection::MetallicRoughness {
            base_color,
            metallic: pbr.metallic_factor(),
            roughness: pbr.roughness_factor(),
            base_color_texture,
            metallic_roughness_texture: self.texture_ref(uses.metallic_roughness, false)?,
            normal_texture: self.texture_ref(uses.normal, false)?,
            normal_scale: material.normal_texture().map_or(1.0, |t| t.scale()),
        })
    }

    /// Says what a material will lack.
    fn remark_on(
        &mut self,
        source: &Source<'_>,
        uses: &Uses,
        read: &Material,
        name: &str,
    ) -> Result<()> {
        let (file, notes) = (self.file, &mut *self.notes);
        let said = |what: &str| format!("material `{name}` {what}");
        for (extension, key, default) in UNSUPPORTED {
            let value = source.extension_value(extension);
            if value.is_some_and(|value| is_on(&value[key], default)) {
                let what = said(&format!("uses {extension}, which is not supported"));
                notes.defect(file, &what, "rendered without it")?;
            }
        }
        if read.emission != Vec3::ZERO {
            notes.note(file, said("glows: it is seen, and lights nothing else"));
        }
        if uses.sets().any(|set| Some(set) != uses.sets().next()) {
            let what = said("uses several sets of texture coordinates");
            notes.defect(file, &what, "the base colour's is taken for all")?;
        }
        let Reflection::MetallicRoughness {
            roughness,
            metallic_roughness_texture,
            ..
        } = read.reflection
        else {
            return Ok(());
        };
        // With a texture, as its mean is.
        let factor = metallic_roughness_texture.map_or(1.0, |t| {
            let texels = &self.model.textures[t.texture as usize].texels;
            let sum: u64 = texels.iter().map(|t| u64::from(t[1])).sum();
            sum as f32 / (255 * texels.len().max(1)) as f32
        });
        let roughness = roughness * factor;
        if roughness < LEAST_ROUGHNESS {
            let what = said(&format!("has roughness {roughness:.2}"));
            let workaround =
                format!("rendered with the least, {LEAST_ROUGHNESS}: mirrors look blurred");
            notes.defect(file, &what, &workaround)?;
        }
        Ok(())
    }
}

/// Whether a factor, or a channel of it, is not 0.
fn is_on(factor: &Value, default: f64) -> bool {
    let is_on = |value: &Value| value.as_f64() != Some(0.0);
    match factor {
        Value::Null => default != 0.0,
        Value::Array(channels) => channels.iter().any(is_on),
        value => is_on(value),
    }
}

/// The factor times the strength of `KHR_materials_emissive_strength`; what is unlit emits nothing besides.
fn emission(material: &Source<'_>) -> Vec3 {
    if is_unlit(material) {
        return Vec3::ZERO;
    }
    let extension = material.extension_value("KHR_materials_emissive_strength");
    let strength = extension.and_then(|e| e["emissiveStrength"].as_f64());
    let factor = Vec3::from(material.emissive_factor()) * strength.unwrap_or(1.0) as f32;
    factor.clamp(Vec3::ZERO, Vec3::MAX)
}

fn opacity(material: &Source<'_>, base_color_texture: Option<TextureRef>) -> Opacity {
    let [.., factor] = material.pbr_metallic_roughness().base_color_factor();
    let alpha = Alpha {
        factor: factor.clamp(0.0, 1.0),
        texture: base_color_texture,
    };
    match material.alpha_mode() {
        AlphaMode::Opaque => Opacity::Opaque,
        AlphaMode::Mask => Opacity::Mask {
            cutoff: material.alpha_cutoff().unwrap_or(0.5),
            alpha,
        },
        AlphaMode::Blend => Opacity::Blend { alpha },
    }
}
