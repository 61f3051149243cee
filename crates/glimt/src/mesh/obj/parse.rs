//! Host file: the statements of a Wavefront OBJ file, as lists.

use crate::error::{Error, Result};
use crate::mesh::lines::{Lines, number, split_word, text, words};
use glam::{DVec3, Vec2, Vec3, Vec4};
use std::collections::{BTreeMap, HashMap};
use std::path::Path;

/// The index of what a corner lacks.
pub(super) const NONE: u32 = u32::MAX;

/// What an OBJ file says. Indices count from 0, and are in range.
#[derive(Debug, Default)]
pub(super) struct Parsed {
    /// `v`.
    pub(super) positions: Vec<DVec3>,
    /// Colours of positions as they are written, alpha 1 where none is; one for each position, or empty.
    pub(super) colors: Vec<Vec4>,
    /// `vt`, with v growing upwards.
    pub(super) uvs: Vec<Vec2>,
    /// `vn`.
    pub(super) normals: Vec<Vec3>,
    /// Corners of all faces, one face after the other.
    pub(super) corners: Vec<Corner>,
    /// Faces of at least three corners.
    pub(super) faces: Vec<Face>,
    /// What holds for faces.
    pub(super) states: Vec<State>,
    /// Names of `usemtl`, each once.
    pub(super) materials: Vec<String>,
    /// What follows each `mtllib`.
    pub(super) libraries: Vec<String>,
    /// How often there was what is read past.
    pub(super) skipped: BTreeMap<&'static str, usize>,
}

/// Indices of a corner's position, texture coordinate and normal; [`NONE`] for what it lacks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Corner {
    /// Of its position.
    pub(super) position: u32,
    /// Of its texture coordinate.
    pub(super) uv: u32,
    /// Of its normal.
    pub(super) normal: u32,
}

/// A face.
#[derive(Clone, Copy, Debug)]
pub(super) struct Face {
    /// Index after that of its last corner. Its first corner follows the last face's.
    pub(super) end: u32,
    /// Index of its state.
    pub(super) state: u32,
}

/// What holds for the faces that follow.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct State {
    /// Index of its name; [`NONE`] before any `usemtl`.
    pub(super) material: u32,
    /// `s`.
    pub(super) smoothing: Smoothing,
}

/// Where a face's missing normals come from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Smoothing {
    /// The file does not say: `s` has not been seen.
    Unsaid,
    /// `s off` or `s 0`: the face is flat.
    Off,
    /// The face is smooth with faces of this group.
    Group(u32),
}

/// Reads the statements of a file.
///
/// # Errors
/// A statement is broken, or a face names what is not there; the error names the line.
pub(super) fn parse(file: &Path, bytes: &[u8]) -> Result<Parsed> {
    let mut reader = Reader {
        parsed: Parsed::default(),
        state: State {
            material: NONE,
            smoothing: Smoothing::Unsaid,
        },
        known: HashMap::new(),
    };
    for (number, line) in Lines::new(file, bytes)? {
        reader
            .statement(&line)
            .map_err(|what| broken(file, number, what))?;
    }
    let parsed = reader.parsed;
    match parsed.find_outside() {
        None => Ok(parsed),
        Some((face, what)) => Err(broken(file, line_of_face(file, bytes, face)?, what)),
    }
}

fn broken(file: &Path, line: usize, what: String) -> Error {
    Error::input(file, what)
        .at_line(line, 1)
        .fix("the file is broken: export it again")
}

/// The line of the face of that index.
fn line_of_face(file: &Path, bytes: &[u8], face: usize) -> Result<usize> {
    let is_face = |line: &[u8]| {
        let (word, rest) = split_word(line);
        is_face(word) && words(rest).count() >= 3
    };
    let mut faces = Lines::new(file, bytes)?.filter(|(_, line)| is_face(line));
    Ok(faces.nth(face).map_or(1, |(number, _)| number))
}

fn is_face(word: &[u8]) -> bool {
    matches!(word, b"f" | b"fo")
}

impl Parsed {
    /// The corners of each face.
    pub(super) fn polygons(&self) -> impl Iterator<Item = (std::ops::Range<u32>, State)> {
        let mut start = 0;
        self.faces.iter().map(move |face| {
            let range = start..face.end;
            start = face.end;
            (range, self.states[face.state as usize])
        })
    }

    /// The first face with an index beyond the file's lists, and what is wrong with it.
    fn find_outside(&self) -> Option<(usize, String)> {
        let counts = [self.positions.len(), self.uvs.len(), self.normals.len()];
        let beyond = |index: u32, count: usize| index != NONE && index as usize >= count;
        let at = self.corners.iter().position(|c| {
            c.position as usize >= counts[0]
                || beyond(c.uv, counts[1])
                || beyond(c.normal, counts[2])
        })?;
        let face = self.faces.partition_point(|face| face.end as usize <= at);
        let Corner {
            position,
            uv,
            normal,
        } = self.corners[at];
        let found = [position, uv, normal].into_iter().zip(counts).zip(KINDS);
        for ((index, count), kind) in found {
            if beyond(index, count) {
                return Some((face, missing(kind, i64::from(index) + 1, count)));
            }
        }
        None
    }
}

const KINDS: [&str; 3] = ["position", "texture coordinate", "normal"];

fn missing(kind: &str, index: i64, count: usize) -> String {
    format!("{kind} {index} does not exist: the file has {count}")
}

struct Reader {
    parsed: Parsed,
    state: State,
    known: HashMap<String, u32>,
}

type Statement = std::result::Result<(), String>;

impl Reader {
    fn statement(&mut self, line: &[u8]) -> Statement {
        let (word, rest) = split_word(line);
        let parsed = &mut self.parsed;
        match word {
            b"v" => return self.vertex(rest),
            b"vt" => {
                let mut numbers = words(rest).map(number);
                let (Some(Some(u)), v) = (numbers.next(), numbers.next().unwrap_or(Some(0.0)))
                else {
                    return Err("a texture coordinate needs numbers".to_owned());
                };
                let v = v.ok_or("a texture coordinate needs numbers")?;
                parsed.uvs.push(Vec2::new(u as f32, v as f32));
            }
            b"vn" => {
                let [x, y, z] = three(rest).ok_or("a normal needs three numbers")?;
                parsed.normals.push(Vec3::new(x as f32, y as f32, z as f32));
            }
            _ if is_face(word) => return self.face(rest),
            b"s" => {
                self.state.smoothing = match rest {
                    b"off" | b"0" => Smoothing::Off,
                    b"on" => Smoothing::Group(1),
                    rest => match number(rest) {
                        Some(group) => Smoothing::Group(group as u32),
                        None => return Err(format!("`{}` is no smoothing group", text(rest))),
                    },
                };
            }
            b"usemtl" => {
                let count = self.known.len() as u32;
                let name = text(rest);
                self.state.material = *self.known.entry(name.clone()).or_insert_with(|| {
                    parsed.materials.push(name);
                    count
                });
            }
            b"mtllib" => parsed.libraries.push(text(rest)),
            b"p" | b"l" => *parsed.skipped.entry("points and lines").or_default() += 1,
            b"curv" | b"curv2" | b"surf" => {
                *parsed
                    .skipped
                    .entry("free-form curves and surfaces")
                    .or_default() += 1;
            }
            // Names of groups, what belongs to free-form surfaces, and what programs add.
            _ => {}
        }
        Ok(())
    }

    /// `v x y z`, with a weight of rational curves, or with red, green, blue and perhaps alpha.
    fn vertex(&mut self, rest: &[u8]) -> Statement {
        let parsed = &mut self.parsed;
        let mut values = [0.0; 7];
        let mut count = 0;
        for word in words(rest).take(7) {
            values[count] = number(word).ok_or_else(|| format!("`{}` is no number", text(word)))?;
            count += 1;
        }
        if count < 3 {
            return Err("a position needs three numbers".to_owned());
        }
        let [x, y, z, r, g, b, a] = values;
        if count >= 6 {
            parsed.colors.resize(parsed.positions.len(), Vec4::ONE);
            let alpha = if count == 7 { a } else { 1.0 };
            let color = [r, g, b, alpha].map(|c| c as f32);
            parsed.colors.push(color.into());
        } else if !parsed.colors.is_empty() {
            parsed.colors.push(Vec4::ONE);
        }
        parsed.positions.push(DVec3::new(x, y, z));
        Ok(())
    }

    fn face(&mut self, rest: &[u8]) -> Statement {
        let parsed = &mut self.parsed;
        let start = parsed.corners.len();
        let counts = [
            parsed.positions.len(),
            parsed.uvs.len(),
            parsed.normals.len(),
        ];
        for word in words(rest) {
            let corner = corner(word, counts)?;
            parsed.corners.push(corner);
        }
        if parsed.corners.len() < start + 3 {
            // As a point or a line.
            parsed.corners.truncate(start);
            *parsed
                .skipped
                .entry("faces of fewer than three corners")
                .or_default() += 1;
            return Ok(());
        }
        if parsed.states.last() != Some(&self.state) {
            parsed.states.push(self.state);
        }
        let too_large = "it has more than four billion corners";
        parsed.faces.push(Face {
            end: u32::try_from(parsed.corners.len()).map_err(|_| too_large)?,
            state: parsed.states.len() as u32 - 1,
        });
        Ok(())
    }
}

fn three(rest: &[u8]) -> Option<[f64; 3]> {
    let mut numbers = words(rest).map(number);
    let mut next = || numbers.next().flatten();
    Some([next()?, next()?, next()?])
}

/// `position`, `position/uv`, `position//normal` or `position/uv/normal`; negative ones count from the end of what is there so far.
fn corner(word: &[u8], counts: [usize; 3]) -> std::result::Result<Corner, String> {
    let mut indices = [NONE; 3];
    let mut rest = word;
    for (place, index) in indices.iter_mut().enumerate() {
        let end = rest.iter().position(|b| *b == b'/').unwrap_or(rest.len());
        let part = &rest[..end];
        if !part.is_empty() {
            let value =
                integer(part).ok_or_else(|| format!("`{}` is no corner of a face", text(word)))?;
            let count = counts[place];
            let from_zero = match value {
                1.. => value - 1,
                0 => -1,
                _ => count as i64 + value,
            };
            *index = match u32::try_from(from_zero) {
                Ok(index) if index != NONE => index,
                _ => return Err(missing(KINDS[place], value, count)),
            };
        }
        rest = rest.get(end + 1..).unwrap_or(&[]);
    }
    let [position, uv, normal] = indices;
    if position == NONE {
        return Err(format!("`{}` is no corner of a face", text(word)));
    }
    Ok(Corner {
        position,
        uv,
        normal,
    })
}

/// A whole number of up to 18 digits.
fn integer(word: &[u8]) -> Option<i64> {
    let (digits, sign) = match word {
        [b'-', digits @ ..] => (digits, -1),
        [b'+', digits @ ..] => (digits, 1),
        digits => (digits, 1),
    };
    if digits.is_empty() || digits.len() > 18 {
        return None;
    }
    let mut value = 0;
    for digit in digits {
        if !digit.is_ascii_digit() {
            return None;
        }
        value = 10 * value + i64::from(digit - b'0');
    }
    Some(sign * value)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parsed(text: &str) -> Result<Parsed> {
        parse(Path::new("a.obj"), text.as_bytes())
    }

    #[test]
    fn corners_of_all_forms() {
        let text =
            "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvn 0 0 1\nf 1/1/1 2//1 3/1\nf -3 -2/-1/-1 -1\n";
        let corner = |position, uv, normal| Corner {
            position,
            uv,
            normal,
        };
        let expected = [
            corner(0, 0, 0),
            corner(1, NONE, 0),
            corner(2, 0, NONE),
            corner(0, NONE, NONE),
            corner(1, 0, 0),
            corner(2, NONE, NONE),
        ];
        assert_eq!(parsed(text).unwrap().corners, expected);
    }

    #[test]
    fn states_follow_faces() {
        let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nusemtl my paint\ns 2\nf 1 2 3\ns off\nusemtl other\n\
                    usemtl my paint\nf 1 2 3\nl 1 2\nf 1 2\n";
        let parsed = parsed(text).unwrap();
        let states: Vec<State> = parsed.polygons().map(|(_, state)| state).collect();
        let state = |material, smoothing| State {
            material,
            smoothing,
        };
        let expected = [
            state(NONE, Smoothing::Unsaid),
            state(0, Smoothing::Group(2)),
            state(0, Smoothing::Off),
        ];
        assert_eq!(states, expected);
        assert_eq!(parsed.materials, ["my paint", "other"]);
        assert_eq!(parsed.skipped.values().sum::<usize>(), 2);
    }

    #[test]
    fn a_face_may_come_before_its_vertices() {
        let text = "f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\n";
        assert_eq!(parsed(text).unwrap().faces.len(), 1);
    }

    #[test]
    fn errors_name_the_line() {
        let cases = [
            ("v 0 0\n", "a.obj:1:1", "three numbers"),
            ("v 0 0 zero\n", "a.obj:1:1", "`zero` is no number"),
            ("v 0 0 0\nvt x\n", "a.obj:2:1", "texture coordinate"),
            ("v 0 0 0\nvn 0 1\n", "a.obj:2:1", "a normal"),
            (
                "v 0 0 0\nf 1 1 0\n",
                "a.obj:2:1",
                "position 0 does not exist: the file has 1",
            ),
            ("v 0 0 0\nf 1 -2 1\n", "a.obj:2:1", "position -2"),
            (
                "v 0 0 0\nf 1 1 1\nf 1 1\n\nf 1 1 2\n",
                "a.obj:5:1",
                "position 2",
            ),
            (
                "v 0 0 0\nf 1/1 1 1\n",
                "a.obj:2:1",
                "texture coordinate 1 does not exist",
            ),
            ("v 0 0 0\nf 1//4 1 1\n", "a.obj:2:1", "normal 4"),
            ("v 0 0 0\nf 1 1 1.5\n", "a.obj:2:1", "`1.5` is no corner"),
            ("v 0 0 0\nf /1 1 1\n", "a.obj:2:1", "`/1` is no corner"),
            (
                "v 0 0 0\nf 1 1 99999999999999999999\n",
                "a.obj:2:1",
                "is no corner",
            ),
        ];
        for (text, place, what) in cases {
            let error = parsed(text).unwrap_err().to_string();
            assert!(
                error.contains(place) && error.contains(what),
                "{text:?}: {error}"
            );
        }
    }

    #[test]
    fn colours_and_weights() {
        let text = "v 0 0 0\nv 1 0 0 0.5\nv 0 1 0 0.25 0.5 1\nv 0 1 0 1 0 0 0.5\nv 0 0 0\n";
        let parsed = parsed(text).unwrap();
        let expected = [
            Vec4::ONE,
            Vec4::ONE,
            Vec4::new(0.25, 0.5, 1.0, 1.0),
            Vec4::new(1.0, 0.0, 0.0, 0.5),
            Vec4::ONE,
        ];
        assert_eq!(parsed.colors, expected);
    }
}
