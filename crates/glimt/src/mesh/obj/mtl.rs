//! Host file: the statements of a Wavefront MTL file.

use crate::error::Result;
use crate::mesh::lines::{Lines, number, split_word, text, words};
use crate::notes::Notes;
use glam::{Vec2, Vec3};
use std::path::Path;

/// A material as its file has it; `None` for what it does not say.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Mtl {
    /// `newmtl`.
    pub(super) name: String,
    /// `Kd`.
    pub(super) diffuse: Option<Vec3>,
    /// `Ks`.
    pub(super) specular: Option<Vec3>,
    /// `Ke`.
    pub(super) emission: Option<Vec3>,
    /// `Ns`.
    pub(super) exponent: Option<f32>,
    /// `d`.
    pub(super) dissolve: Option<f32>,
    /// `Tr`.
    pub(super) transparency: Option<f32>,
    /// `illum`.
    pub(super) model: Option<i32>,
    /// `Pr`.
    pub(super) roughness: Option<f32>,
    /// `Pm`.
    pub(super) metallic: Option<f32>,
    /// `map_Kd`.
    pub(super) diffuse_map: Option<Map>,
    /// `map_Ke`.
    pub(super) emission_map: Option<Map>,
    /// `map_d`.
    pub(super) dissolve_map: Option<Map>,
    /// `map_Tr`.
    pub(super) transparency_map: Option<Map>,
    /// `bump`, `map_Bump`.
    pub(super) bump_map: Option<Map>,
    /// `norm`.
    pub(super) normal_map: Option<Map>,
    /// `map_Pr`.
    pub(super) roughness_map: Option<Map>,
    /// `map_Pm`.
    pub(super) metallic_map: Option<Map>,
    /// Statements and options that change a picture and are not used.
    pub(super) unused: Vec<String>,
}

/// A picture, and how it lies on a surface.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Map {
    /// Its file, as the MTL writes it.
    pub(super) file: String,
    /// `-s`: how often it repeats along u and v.
    pub(super) scale: Vec2,
    /// `-o`: added to texture coordinates, after the scale; v grows upwards.
    pub(super) offset: Vec2,
    /// `-clamp on`.
    pub(super) clamp: bool,
    /// `-bm`.
    pub(super) bump: f32,
}

/// Reads the materials of a file. Lines whose numbers are broken are left out, with a warning that names them.
///
/// # Errors
/// The file is UTF-16.
pub(super) fn parse(file: &Path, bytes: &[u8], notes: &mut Notes) -> Result<Vec<Mtl>> {
    let mut list: Vec<Mtl> = Vec::new();
    for (number, line) in Lines::new(file, bytes)? {
        let (word, rest) = split_word(&line);
        if word == b"newmtl" {
            list.push(Mtl {
                name: text(rest),
                ..Mtl::default()
            });
        } else if let Some(material) = list.last_mut()
            && let Err(what) = statement(material, word, rest)
        {
            notes.warn(file, format!("line {number}: {what}; the line is left out"));
        }
    }
    Ok(list)
}

fn statement(material: &mut Mtl, word: &[u8], rest: &[u8]) -> std::result::Result<(), String> {
    let name = text(word);
    let value = || -> std::result::Result<f32, String> {
        let value = words(rest).next().and_then(number);
        let value = value.filter(|value| value.is_finite());
        let value =
            value.ok_or_else(|| format!("`{name}` needs a number, not `{}`", text(rest)))?;
        Ok(value as f32)
    };
    let unused = &mut material.unused;
    match name.to_ascii_lowercase().as_str() {
        "kd" => material.diffuse = color(&name, rest, unused)?,
        "ks" => material.specular = color(&name, rest, unused)?,
        "ke" => material.emission = color(&name, rest, unused)?,
        "tf" => {
            let filter = color(&name, rest, unused)?;
            if filter.is_some_and(|filter| filter != Vec3::ONE && filter != Vec3::ZERO) {
                unused.push(name);
            }
        }
        "ns" => material.exponent = Some(value()?),
        "d" => match split_word(rest) {
            (b"-halo", factor) => {
                let factor = number(factor).ok_or("`d -halo` needs a number")?;
                material.dissolve = Some(factor as f32);
                unused.push("d -halo".to_owned());
            }
            _ => material.dissolve = Some(value()?),
        },
        "tr" => material.transparency = Some(value()?),
        "illum" => material.model = Some(value()? as i32),
        "pr" => material.roughness = Some(value()?),
        "pm" => material.metallic = Some(value()?),
        "map_kd" => material.diffuse_map = map(&name, rest, unused),
        "map_ke" => material.emission_map = map(&name, rest, unused),
        "map_d" => material.dissolve_map = map(&name, rest, unused),
        "map_tr" => material.transparency_map = map(&name, rest, unused),
        "bump" | "map_bump" => material.bump_map = map(&name, rest, unused),
        "norm" | "map_norm" => material.normal_map = map(&name, rest, unused),
        "map_pr" => material.roughness_map = map(&name, rest, unused),
        "map_pm" => material.metallic_map = map(&name, rest, unused),
        // A factor of 0 switches sheen and coats off.
        "ps" | "pc" | "aniso" if value()? != 0.0 => unused.push(name),
        "map_ks" | "map_ns" | "map_ps" | "disp" | "map_disp" | "decal" | "refl" | "map_refl" => {
            unused.push(name)
        }
        // Ambient light, refraction and what belongs to an unused statement: no picture is made of them.
        _ => {}
    }
    Ok(())
}

/// `r g b`, `r` alone for grey, or `xyz x y z`.
fn color(
    name: &str,
    rest: &[u8],
    unused: &mut Vec<String>,
) -> std::result::Result<Option<Vec3>, String> {
    let (first, after) = split_word(rest);
    if first == b"spectral" {
        unused.push(format!("{name} spectral"));
        return Ok(None);
    }
    let is_xyz = first == b"xyz";
    let numbers = if is_xyz { after } else { rest };
    let read: Option<Vec<f64>> = words(numbers).take(3).map(number).collect();
    let wrong = || format!("`{name}` needs three numbers, not `{}`", text(rest));
    let values = match read.ok_or_else(wrong)?[..] {
        [grey] => Vec3::splat(grey as f32),
        [r, g, b] => Vec3::new(r as f32, g as f32, b as f32),
        _ => return Err(wrong()),
    };
    if !values.is_finite() {
        return Err(wrong());
    }
    // CIE XYZ with the white point D65 to Rec. 709.
    let to_rgb = glam::Mat3::from_cols(
        Vec3::new(3.240_97, -0.969_244, 0.055_63),
        Vec3::new(-1.537_383, 1.875_968, -0.203_977),
        Vec3::new(-0.498_611, 0.041_555, 1.056_972),
    );
    Ok(Some(if is_xyz { to_rgb * values } else { values }))
}

/// Options, then the name of a file, which may have spaces in it.
fn map(name: &str, mut rest: &[u8], unused: &mut Vec<String>) -> Option<Map> {
    let mut map = Map {
        file: String::new(),
        scale: Vec2::ONE,
        offset: Vec2::ZERO,
        clamp: false,
        bump: 1.0,
    };
    while let (option @ [b'-', letter, ..], mut after) = split_word(rest)
        && letter.is_ascii_alphabetic()
    {
        // The last word is the file's name, be it a number.
        let mut numbers: Vec<f32> = Vec::new();
        let most = match option {
            b"-s" | b"-o" | b"-t" => 3,
            b"-mm" => 2,
            b"-bm" | b"-boost" | b"-texres" => 1,
            _ => 0,
        };
        while numbers.len() < most
            && let (word, next) = split_word(after)
            && let Some(value) = number(word)
            && !next.is_empty()
        {
            numbers.push(value as f32);
            after = next;
        }
        let pair = |rest: f32| match numbers[..] {
            [] => Vec2::splat(rest),
            [u] => Vec2::new(u, rest),
            [u, v, ..] => Vec2::new(u, v),
        };
        let mut switch = || {
            let (word, next) = split_word(after);
            after = next;
            word == b"on"
        };
        let changes = match option {
            b"-s" => {
                map.scale = pair(1.0);
                false
            }
            b"-o" => {
                map.offset = pair(0.0);
                false
            }
            b"-bm" => {
                map.bump = numbers.first().copied().unwrap_or(1.0);
                false
            }
            b"-clamp" => {
                map.clamp = switch();
                false
            }
            // How a picture is filtered.
            b"-blendu" | b"-blendv" => {
                switch();
                false
            }
            b"-boost" | b"-texres" => false,
            b"-cc" => switch(),
            b"-mm" => numbers[..] != [0.0, 1.0],
            b"-t" => numbers.iter().any(|t| *t != 0.0),
            b"-imfchan" | b"-type" => {
                switch();
                true
            }
            _ => {
                // The name of a file that begins so.
                break;
            }
        };
        if changes {
            unused.push(format!("{name} {}", text(option)));
        }
        rest = after;
    }
    let file = text(rest.trim_ascii());
    map.file = file.trim_matches('"').to_owned();
    (!map.file.is_empty()).then_some(map)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(lines: &str) -> Mtl {
        let text = format!("newmtl a\n{lines}\n");
        parse(Path::new("a.mtl"), text.as_bytes(), &mut Notes::default())
            .unwrap()
            .swap_remove(0)
    }

    #[test]
    fn options_of_maps() {
        let map = |line: &str| read(line).diffuse_map.unwrap();
        let plain = map("map_Kd my paint.png");
        assert_eq!(
            (plain.file.as_str(), plain.scale, plain.clamp),
            ("my paint.png", Vec2::ONE, false)
        );
        let all = map("map_Kd -s 2 3 1 -o 0.5 -clamp on -blendu off -bm 0.2 -mm 0 1 a.png");
        assert_eq!(
            (all.scale, all.offset),
            (Vec2::new(2.0, 3.0), Vec2::new(0.5, 0.0))
        );
        assert!(all.clamp && all.bump == 0.2 && all.file == "a.png");
        assert_eq!(map("map_Kd -s 2 7").file, "7");
        assert_eq!(map("map_Kd -odd.png").file, "-odd.png");
        assert_eq!(map("map_Kd \"a b.png\"").file, "a b.png");
        assert!(read("map_Kd -mm 0 1 a.png").unused.is_empty());
        assert_eq!(read("map_Kd -mm 0.1 2 a.png").unused, ["map_Kd -mm"]);
        assert_eq!(read("bump -imfchan r a.png").unused, ["bump -imfchan"]);
        assert_eq!(read("map_Kd").diffuse_map, None);
    }

    #[test]
    fn values() {
        let m = read(
            "Kd 0.5\nKe 1 2 3\nTr 0.25\nillum 2\nPr 0.3\nPm 1\nNs 20\nKa 1 1 1\nmap_Ks a.png\nPs 0\nPc 1",
        );
        assert_eq!(m.diffuse, Some(Vec3::splat(0.5)));
        assert_eq!(m.emission, Some(Vec3::new(1.0, 2.0, 3.0)));
        assert_eq!((m.transparency, m.model), (Some(0.25), Some(2)));
        assert_eq!(
            (m.roughness, m.metallic, m.exponent),
            (Some(0.3), Some(1.0), Some(20.0))
        );
        assert_eq!(m.unused, ["map_Ks", "Pc"]);
        // The white of D65.
        let white = read("Kd xyz 0.95047 1 1.08883").diffuse.unwrap();
        assert!(white.abs_diff_eq(Vec3::ONE, 1e-3), "{white}");
    }

    #[test]
    fn warnings_name_the_line() {
        for line in ["Kd 1 x 1", "Kd 1 1", "Ns", "d -halo x", "Kd nan 1 1"] {
            let text = format!("\nnewmtl a\n{line}\nNi 1\nillum 2\n");
            let mut notes = Notes::default();
            let list = parse(Path::new("a.mtl"), text.as_bytes(), &mut notes).unwrap();
            assert_eq!(list[0].model, Some(2));
            let said = notes.take();
            assert!(said[0].text.starts_with("line 3: "), "{said:?}");
        }
    }
}
