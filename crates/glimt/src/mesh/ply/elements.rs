//! Host file: vertices and faces of PLY files, as the library hands them over, property by property.

use glam::{DVec3, Vec2, Vec3, Vec4};
use ply_rs_bw::ply::{BeginList, PropertyAccess, PropertyAccessResult};

/// A vertex. Properties that are not named here are skipped.
#[derive(Clone, Copy)]
pub(super) struct Vertex {
    pub(super) position: DVec3,
    pub(super) normal: Vec3,
    pub(super) uv: Vec2,
    /// As it is written, where 1 is white: whole numbers are divided by their type's largest.
    pub(super) color: Vec4,
}

impl Vertex {
    fn set(&mut self, name: &str, value: f64, white: f64) -> PropertyAccessResult {
        match name {
            "x" => self.position.x = value,
            "y" => self.position.y = value,
            "z" => self.position.z = value,
            "nx" => self.normal.x = value as f32,
            "ny" => self.normal.y = value as f32,
            "nz" => self.normal.z = value as f32,
            "s" | "u" | "texture_u" => self.uv.x = value as f32,
            "t" | "v" | "texture_v" => self.uv.y = value as f32,
            _ => return set_color(&mut self.color, name, value / white),
        }
        PropertyAccessResult::Set
    }
}

/// Names of a colour's channels.
pub(super) const CHANNELS: [[&str; 3]; 4] = [
    ["red", "r", "diffuse_red"],
    ["green", "g", "diffuse_green"],
    ["blue", "b", "diffuse_blue"],
    ["alpha", "a", "diffuse_alpha"],
];

fn set_color(color: &mut Vec4, name: &str, value: f64) -> PropertyAccessResult {
    match CHANNELS.iter().position(|names| names.contains(&name)) {
        Some(channel) => color[channel] = value as f32,
        None => return PropertyAccessResult::Ignored,
    }
    PropertyAccessResult::Set
}

/// A polygon or the strips of a mesh.
pub(super) struct Face {
    /// Vertices; those above 2³¹ − 1 are as negative numbers.
    pub(super) indices: Vec<i32>,
    /// Texture coordinates, two for each corner; or empty.
    pub(super) uvs: Vec<f32>,
    /// Which of the file's pictures it shows.
    pub(super) texture: u32,
    /// See [`Vertex::color`].
    pub(super) color: Vec4,
}

impl Face {
    fn set(&mut self, name: &str, value: f64, white: f64) -> PropertyAccessResult {
        if name != "texnumber" {
            return set_color(&mut self.color, name, value / white);
        }
        self.texture = value as u32;
        PropertyAccessResult::Set
    }

    fn set_list<I>(
        &mut self,
        name: &str,
        list: Vec<I>,
        index: impl Fn(I) -> i32,
    ) -> PropertyAccessResult {
        if !is_indices(name) {
            return PropertyAccessResult::Ignored;
        }
        self.indices = list.into_iter().map(index).collect();
        PropertyAccessResult::Set
    }
}

fn is_indices(name: &str) -> bool {
    matches!(name, "vertex_indices" | "vertex_index")
}

fn is_uvs(name: &str) -> bool {
    matches!(name, "texcoord" | "texcoords")
}

/// An element that is read past.
pub(super) struct Skipped;

macro_rules! setters {
    ($($name:ident($value:ty) = $white:expr),+) => {
        $(fn $name(&mut self, name: &str, value: $value) -> PropertyAccessResult {
            self.set(name, f64::from(value), $white)
        })+
    };
}

macro_rules! scalars {
    () => {
        setters!(
            set_char(i8) = 127.0,
            set_uchar(u8) = 255.0,
            set_short(i16) = 32767.0,
            set_ushort(u16) = 65535.0,
            set_int(i32) = 255.0,
            set_uint(u32) = 255.0,
            set_float(f32) = 1.0,
            set_double(f64) = 1.0
        );
    };
}

macro_rules! lists {
    ($($name:ident($value:ty)),+) => {
        $(fn $name(&mut self, name: &str, list: Vec<$value>) -> PropertyAccessResult {
            self.set_list(name, list, |index| index as i32)
        })+
    };
}

impl PropertyAccess for Vertex {
    fn new() -> Self {
        Self {
            position: DVec3::ZERO,
            normal: Vec3::ZERO,
            uv: Vec2::ZERO,
            color: Vec4::ONE,
        }
    }
    scalars!();
}

impl PropertyAccess for Face {
    fn new() -> Self {
        Self {
            indices: Vec::new(),
            uvs: Vec::new(),
            texture: 0,
            color: Vec4::ONE,
        }
    }

    fn begin_list_int(&mut self, name: &str, _: usize) -> BeginList<'_, i32> {
        match is_indices(name) {
            true => BeginList::Fill(&mut self.indices),
            false => BeginList::UseSetter,
        }
    }

    fn begin_list_float(&mut self, name: &str, _: usize) -> BeginList<'_, f32> {
        match is_uvs(name) {
            true => BeginList::Fill(&mut self.uvs),
            false => BeginList::UseSetter,
        }
    }

    fn set_list_double(&mut self, name: &str, list: Vec<f64>) -> PropertyAccessResult {
        if !is_uvs(name) {
            return PropertyAccessResult::Ignored;
        }
        self.uvs = list.into_iter().map(|value| value as f32).collect();
        PropertyAccessResult::Set
    }

    scalars!();
    lists!(
        set_list_char(i8),
        set_list_uchar(u8),
        set_list_short(i16),
        set_list_ushort(u16),
        set_list_uint(u32)
    );
}

impl PropertyAccess for Skipped {
    fn new() -> Self {
        Self
    }
}
