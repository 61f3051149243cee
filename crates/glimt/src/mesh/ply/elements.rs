//! Host file: vertices and faces of PLY files, as the library hands them over, property by property.

use glam::{DVec3, Vec2, Vec3, Vec4};
use ply_rs_bw::ply::{BeginList, ElementDef, PropertyAccess, PropertyAccessResult};
use std::ops::Range;

/// A vertex. Properties that are not named here are skipped.
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
const CHANNELS: [[&str; 3]; 4] = [
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

/// Vertices as lists of what they have: each of them is as long as the positions, or empty.
#[derive(Default)]
pub(super) struct Vertices {
    pub(super) positions: Vec<DVec3>,
    pub(super) normals: Vec<Vec3>,
    /// With v growing upwards.
    pub(super) uvs: Vec<Vec2>,
    /// See [`Vertex::color`].
    pub(super) colors: Vec<Vec4>,
}

impl Vertices {
    /// Adds vertices of an element.
    pub(super) fn extend(&mut self, list: &[Vertex], element: &ElementDef) {
        let uvs = [["s", "t"], ["u", "v"], ["texture_u", "texture_v"]];
        self.positions.extend(list.iter().map(|v| v.position));
        if has_all(element, &["nx", "ny", "nz"]) {
            self.normals.extend(list.iter().map(|v| v.normal));
        }
        if uvs.iter().any(|names| has_all(element, names)) {
            self.uvs.extend(list.iter().map(|v| v.uv));
        }
        if has_color(element) {
            self.colors.extend(list.iter().map(|v| v.color));
        }
    }
}

/// Polygons or strips, one after the other.
#[derive(Default)]
pub(super) struct Faces {
    /// The corners of all of them; see [`Face::indices`].
    pub(super) corners: Vec<i32>,
    /// Index after the last corner of each.
    pub(super) ends: Vec<usize>,
    /// Texture coordinates of each corner, with v growing upwards; or empty.
    pub(super) uvs: Vec<Vec2>,
    /// Of each the picture that it shows; or empty.
    pub(super) textures: Vec<u32>,
    /// Of each its colour, see [`Vertex::color`]; or empty.
    pub(super) colors: Vec<Vec4>,
}

impl Faces {
    /// Adds faces of an element.
    pub(super) fn extend(&mut self, list: &[Face], element: &ElementDef) {
        let has_uvs = has_all(element, &["texcoord"]) || has_all(element, &["texcoords"]);
        for face in list {
            self.corners.extend_from_slice(&face.indices);
            self.ends.push(self.corners.len());
            if has_uvs {
                let (uvs, _) = face.uvs.as_chunks::<2>();
                self.uvs.extend(uvs.iter().map(|&uv| Vec2::from(uv)));
                self.uvs.resize(self.corners.len(), Vec2::ZERO);
            }
        }
        if has_all(element, &["texnumber"]) {
            self.textures.extend(list.iter().map(|face| face.texture));
        }
        if has_color(element) {
            self.colors.extend(list.iter().map(|face| face.color));
        }
    }

    /// The corners of each.
    pub(super) fn ranges(&self) -> impl Iterator<Item = Range<usize>> {
        let starts = std::iter::once(0).chain(self.ends.iter().copied());
        starts.zip(&self.ends).map(|(start, end)| start..*end)
    }
}

fn has_all(element: &ElementDef, names: &[&str]) -> bool {
    let mut names = names.iter();
    names.all(|name| element.properties.contains_key(*name))
}

fn has_color(element: &ElementDef) -> bool {
    let mut channels = CHANNELS[..3].iter();
    channels.all(|names| names.iter().any(|name| has_all(element, &[name])))
}

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
