//! Host file: what OBJ, MTL, PLY and STL files say is what a loaded model has.

mod common;

use common::{Scratch, read_exr};
use flate2::Compression;
use flate2::write::GzEncoder;
use glam::{DVec3, Vec2, Vec3, Vec4};
use glimt::mesh::model::{Model, NormalCounts};
use glimt::notes::{Notes, Severity};
use glimt_render_gpu::prepare::scene::{Mesh, Opacity, Reflection, Wrap};
use std::fmt::Write as _;
use std::io::Write as _;

/// A loaded file, and what was said about it.
struct Read {
    model: Model,
    warnings: Vec<String>,
    notes: Vec<String>,
}

impl Read {
    fn mesh(&self) -> &Mesh {
        &self.model.meshes[0]
    }

    fn warns(&self, words: &str) {
        let mut all = self.warnings.iter();
        assert!(
            all.any(|w| w.contains(words)),
            "{words}: {:?}",
            self.warnings
        );
    }
}

fn read(t: &Scratch, name: &str) -> Read {
    let mut notes = Notes::default();
    let model = glimt::mesh::load(&t.file(""), name, 40.0, &mut notes).expect("a mesh");
    let (warnings, notes) = notes
        .take()
        .into_iter()
        .partition::<Vec<_>, _>(|note| note.severity == Severity::Warning);
    let texts = |list: Vec<glimt::notes::Note>| list.into_iter().map(|note| note.text).collect();
    Read {
        model,
        warnings: texts(warnings),
        notes: texts(notes),
    }
}

fn put(t: &Scratch, name: &str, content: impl AsRef<[u8]>) -> Read {
    t.put(name, content);
    read(t, name)
}

const CUBE_FACES: [[usize; 4]; 6] = [
    [1, 2, 4, 3],
    [5, 7, 8, 6],
    [1, 5, 6, 2],
    [3, 4, 8, 7],
    [1, 3, 7, 5],
    [2, 6, 8, 4],
];

/// The corners of a cube of side 2, as [`CUBE_FACES`] counts them.
fn cube_corners() -> impl Iterator<Item = [i32; 3]> {
    (0..8).map(|i| [i >> 2 & 1, i >> 1 & 1, i & 1].map(|bit| 2 * bit - 1))
}

/// A cube, with statements before its faces.
fn cube(before_faces: &str) -> String {
    let mut text = String::new();
    for [x, y, z] in cube_corners() {
        writeln!(text, "v {x} {y} {z}").unwrap();
    }
    text.push_str(before_faces);
    for [a, b, c, d] in CUBE_FACES {
        writeln!(text, "f {a} {b} {c} {d}").unwrap();
    }
    text
}

/// The area of each triangle, as a vector.
fn areas(mesh: &Mesh) -> impl Iterator<Item = Vec3> {
    mesh.indices.iter().map(|t| {
        let [a, b, c] = t.map(|i| mesh.positions[i as usize]);
        0.5 * (b - a).cross(c - a)
    })
}

fn area(mesh: &Mesh) -> f32 {
    areas(mesh).map(Vec3::length).sum()
}

/// The largest angle between a triangle and the normal of one of its corners, as a cosine.
fn least_cosine(mesh: &Mesh) -> f32 {
    let triangles = mesh.indices.iter().zip(areas(mesh));
    let cosines = triangles.flat_map(|(t, area)| {
        t.map(|i| mesh.normals[i as usize].normalize().dot(area.normalize()))
    });
    cosines.fold(1.0, f32::min)
}

#[test]
fn an_obj_cube_is_sharp_unless_its_group_is_smooth() {
    let t = Scratch::new("cubes");
    for (name, before, flat, creased) in [
        ("none", "", 0, 12),
        ("off", "s off\n", 12, 0),
        ("zero", "s 0\n", 12, 0),
    ] {
        let read = put(&t, &format!("{name}.obj"), cube(before));
        assert!(least_cosine(read.mesh()) > 0.999_999, "{name}");
        assert_eq!(read.mesh().positions.len(), 24);
        assert!((area(read.mesh()) - 24.0).abs() < 1e-5);
        let made = NormalCounts {
            flat,
            grouped: 0,
            creased,
        };
        assert_eq!(read.model.made_normals, made);
        assert!(read.warnings.is_empty(), "{:?}", read.warnings);
        assert_eq!(
            read.notes.len(),
            usize::from(creased > 0),
            "{:?}",
            read.notes
        );
    }
    let smooth = put(&t, "smooth.obj", cube("s 3\n"));
    let mesh = smooth.mesh();
    assert_eq!(mesh.positions.len(), 8);
    for (p, n) in mesh.positions.iter().zip(&mesh.normals) {
        assert!(n.abs_diff_eq(p.normalize(), 1e-6), "{p} {n}");
    }
    assert_eq!(smooth.model.made_normals.grouped, 12);
}

#[test]
fn smoothing_groups_end_at_each_other() {
    let t = Scratch::new("groups");
    // A roof of 20° in two groups, and in one.
    let roof = |groups: [&str; 2]| {
        format!(
            "v -1 0 0\nv 0 0 0.17632698\nv 1 0 0\nv -1 1 0\nv 0 1 0.17632698\nv 1 1 0\n{}f 1 2 5 4\n{}f 2 3 6 5\n",
            groups[0], groups[1]
        )
    };
    let cosine = |angle: f32| angle.to_radians().cos();
    for (groups, vertices, least) in [
        (["s 1\n", "s 2\n"], 8, 1.0),
        (["s 1\n", ""], 6, cosine(10.0)),
        (["s 1\n", "s off\n"], 8, 1.0),
        (["", ""], 6, cosine(10.0)),
    ] {
        let read = put(&t, "a.obj", roof(groups));
        assert_eq!(read.mesh().positions.len(), vertices, "{groups:?}");
        assert!(
            (least_cosine(read.mesh()) - least).abs() < 1e-5,
            "{groups:?}"
        );
    }
}

#[test]
fn crease_deg_is_a_key_of_an_object() {
    let t = Scratch::new("crease");
    t.exr("light.exr", 8, 4, |x, y, c| {
        ((x * 3 + y * 5 + c * 7) % 11) as f32
    });
    t.put("a.obj", cube(""));
    let shot = |crease: &str| {
        t.shot(
            "light.exr",
            &format!("[[object]]\nmesh = \"a.obj\"\n{crease}"),
        );
        t.run(&["render", "shot.toml", "--overwrite"])
    };
    let picture = |crease: &str| {
        shot(crease).ok();
        read_exr(&t.file("out/frame.0001.exr"))
    };
    let sharp = picture("");
    assert_eq!(picture("crease_deg = 89\n"), sharp);
    assert_ne!(picture("crease_deg = 91\n"), sharp);
    shot("crease_deg = 181\n").fails(2, &["crease_deg", "between 0 and 180"]);
}

#[test]
fn given_normals_and_coordinates_are_kept_in_each_group() {
    let t = Scratch::new("mixed");
    // The first face leans its normals, the second has neither normals nor coordinates, the third has both.
    let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 2 0 0\nv 2 1 0\nvn 0.6 0 0.8\nvt 0.25 0.75\n\
                f 1//1 2//1 3//1\nf 2 4 3\nf 2/1/1 5/1/1 6/1/1\n";
    let read = put(&t, "a.obj", text);
    let mesh = read.mesh();
    let corner = |triangle: usize, list: &[Vec3]| mesh.indices[triangle].map(|i| list[i as usize]);
    assert_eq!(corner(0, &mesh.normals), [Vec3::new(0.6, 0.0, 0.8); 3]);
    assert_eq!(corner(1, &mesh.normals), [Vec3::Z; 3]);
    assert_eq!(corner(2, &mesh.normals), [Vec3::new(0.6, 0.0, 0.8); 3]);
    let uv = |triangle: usize| mesh.indices[triangle].map(|i| mesh.uvs[i as usize]);
    assert_eq!(uv(1), [Vec2::ZERO; 3]);
    assert_eq!(uv(2), [Vec2::new(0.25, 0.25); 3]);
    assert_eq!(read.model.made_normals.creased, 1);
}

/// A C of height 3, as corners of one polygon, of area 7.
const C: [[i32; 2]; 8] = [
    [0, 0],
    [3, 0],
    [3, 1],
    [1, 1],
    [1, 2],
    [3, 2],
    [3, 3],
    [0, 3],
];

#[test]
fn concave_polygons_have_their_own_area() {
    let t = Scratch::new("concave");
    let corner = |[x, y]: &[i32; 2]| format!("{x} {y} 1\n");
    let lines: String = C.iter().map(corner).collect();
    let obj: String = C.iter().map(|c| format!("v {}", corner(c))).collect();
    put(&t, "a.obj", obj + "f 1 2 3 4 5 6 7 8\n");
    let header = "ply\nformat ascii 1.0\nelement vertex 8\nproperty float x\nproperty float y\nproperty float z\n\
                  element face 1\nproperty list uint uint vertex_index\nend_header\n";
    put(&t, "a.ply", format!("{header}{lines}8 0 1 2 3 4 5 6 7\n"));
    for name in ["a.obj", "a.ply"] {
        let read = read(&t, name);
        let sum: Vec3 = areas(read.mesh()).sum();
        assert!(sum.abs_diff_eq(7.0 * Vec3::Z, 1e-5), "{name}: {sum}");
        assert!((area(read.mesh()) - 7.0).abs() < 1e-5, "{name}");
        assert!(read.mesh().normals.iter().all(|n| *n == Vec3::Z));
    }
    let bow = "v 0 0 0\nv 3 3 0\nv 3 0 0\nv 0 1 0\nf 1 2 3 4\n";
    put(&t, "bow.obj", bow).warns("1 of its polygons cross themselves");
}

/// ((0.5 + 0.055)/1.055)^2.4
const HALF_SRGB: f32 = 0.214_041;

#[test]
fn vertex_colours_are_srgb_and_alpha_is_linear() {
    let t = Scratch::new("colours");
    let obj = put(
        &t,
        "a.obj",
        "v 0 0 0 1 0.5 0\nv 1 0 0 0 0 1\nv 0 1 0 1 1 1\nf 1 2 3\n",
    );
    let first = obj.mesh().colors[obj.mesh().indices[0][0] as usize];
    assert!(
        first.abs_diff_eq(Vec4::new(1.0, HALF_SRGB, 0.0, 1.0), 1e-5),
        "{first}"
    );
    assert_eq!(obj.model.materials[0].opacity, Opacity::Opaque);
    // White paint, which colours multiply.
    let Reflection::BlinnPhong { diffuse, .. } = obj.model.materials[0].reflection else {
        panic!("paint is matt");
    };
    assert_eq!(diffuse, Vec3::ONE);

    let ply = |kind: &str, rows: [&str; 3]| {
        let channels: String = ["red", "green", "blue", "alpha"]
            .map(|name| format!("property {kind} {name}\n"))
            .concat();
        let [a, b, c] = rows;
        format!(
            "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n{channels}\
             element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0 {a}\n1 0 0 {b}\n0 1 0 {c}\n3 0 1 2\n"
        )
    };
    let exact = Vec4::new(1.0, HALF_SRGB, 0.0, 0.2);
    let cases = [
        ("uchar", ["255 128 0 51", "0 0 0 255", "0 0 0 255"]),
        (
            "ushort",
            ["65535 32768 0 13107", "0 0 0 65535", "0 0 0 65535"],
        ),
        ("float", ["1 0.5 0 0.2", "0 0 0 1", "0 0 0 1"]),
    ];
    for (kind, rows) in cases {
        let read = put(&t, "a.ply", ply(kind, rows));
        let first = read.mesh().colors[read.mesh().indices[0][0] as usize];
        assert!(first.abs_diff_eq(exact, 3e-3), "{kind}: {first}");
        assert!(matches!(
            read.model.materials[0].opacity,
            Opacity::Blend { .. }
        ));
        assert!(
            read.notes.iter().any(|n| n.contains("sRGB")),
            "{:?}",
            read.notes
        );
    }
    // Of faces.
    let text = "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n\
                element face 2\nproperty list uchar int vertex_indices\nproperty uchar red\nproperty uchar green\n\
                property uchar blue\nend_header\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n3 0 1 2 255 0 0\n3 1 3 2 0 255 0\n";
    let read = put(&t, "faces.ply", text);
    let mesh = read.mesh();
    let of = |triangle: usize| mesh.indices[triangle].map(|i| mesh.colors[i as usize]);
    assert_eq!(of(0), [Vec4::new(1.0, 0.0, 0.0, 1.0); 3]);
    assert_eq!(of(1), [Vec4::new(0.0, 1.0, 0.0, 1.0); 3]);
}

/// A texture of one colour.
fn texture(t: &Scratch, name: &str, rgba: [u8; 4]) {
    image::RgbaImage::from_pixel(4, 2, image::Rgba(rgba))
        .save(t.file(name))
        .unwrap();
}

#[test]
fn a_ply_shows_the_pictures_that_it_names() {
    let t = Scratch::new("ply-picture");
    texture(&t, "my paint.png", [255, 0, 0, 255]);
    texture(&t, "other.png", [0, 255, 0, 255]);
    let head = "ply\nformat ascii 1.0\ncomment TextureFile my paint.png\n";
    let vertices = "0 0 0\n1 0 0\n0 1 0\n1 1 0\n";
    let places = "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n";
    let lists = "element face 2\nproperty list uchar int vertex_indices\nproperty list uchar float texcoord\n";
    let text = format!(
        "{head}{places}{lists}end_header\n{vertices}3 0 1 2 6 0 0 1 0 0 1\n3 1 3 2 6 0.5 0 1 1 0 1\n"
    );
    let read = put(&t, "a.ply", text);
    let mesh = read.mesh();
    let uv = |triangle: usize| mesh.indices[triangle].map(|i| mesh.uvs[i as usize]);
    assert_eq!(
        uv(0),
        [Vec2::new(0.0, 1.0), Vec2::new(1.0, 1.0), Vec2::ZERO]
    );
    assert_eq!(
        uv(1),
        [Vec2::new(0.5, 1.0), Vec2::new(1.0, 0.0), Vec2::ZERO]
    );
    // Two corners at one place differ, and two do not.
    assert_eq!(mesh.positions.len(), 5);
    let material = |read: &Read, i: usize| match &read.model.materials[i].reflection {
        Reflection::MetallicRoughness {
            base_color,
            base_color_texture: Some(texture),
            ..
        } => (
            *base_color,
            read.model.textures[texture.texture as usize].texels[0],
        ),
        other => panic!("{other:?}"),
    };
    assert_eq!(material(&read, 0), (Vec3::ONE, [255, 0, 0, 255]));
    assert_eq!(read.model.files.len(), 2);

    // Two pictures, and coordinates of vertices.
    let text = format!(
        "{head}comment TextureFile other.png\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n\
         property float s\nproperty float t\n{lists}property int texnumber\nend_header\n\
         0 0 0 0 0\n1 0 0 1 0\n0 1 0 0 1\n1 1 0 1 1\n3 0 1 2 6 0 0 1 0 0 1 0\n3 1 3 2 6 0 0 1 0 0 1 1\n"
    );
    let two = put(&t, "two.ply", text);
    assert_eq!(two.mesh().materials, [0, 1]);
    assert_eq!(material(&two, 1), (Vec3::ONE, [0, 255, 0, 255]));

    let bare = format!(
        "{head}{places}element face 1\nproperty list uchar int vertex_indices\nend_header\n{vertices}3 0 1 2\n"
    );
    put(&t, "bare.ply", bare).warns("no texture coordinates");
}

#[test]
fn ply_faces_may_come_first_and_count_in_any_type() {
    let t = Scratch::new("ply-order");
    let mut file = b"ply\nformat binary_big_endian 1.0\nelement face 1\nproperty list ushort short vertex_indices\n\
                     element vertex 4\nproperty double x\nproperty double y\nproperty double z\nend_header\n"
        .to_vec();
    file.extend(4u16.to_be_bytes());
    file.extend([0i16, 1, 2, 3].into_iter().flat_map(i16::to_be_bytes));
    let corners = [
        [0.0, 0.0, 0.0],
        [2.0, 0.0, 0.0],
        [2.0, 1.0, 0.0],
        [0.0, 1.0, 0.0f64],
    ];
    file.extend(corners.as_flattened().iter().flat_map(|x| x.to_be_bytes()));
    let read = put(&t, "a.ply", file);
    assert!((area(read.mesh()) - 2.0).abs() < 1e-6);
}

/// A small pyramid somewhere, as OBJ and as PLY of doubles.
fn pyramid(at: DVec3) -> (String, String) {
    let corners = [
        [-1.0, -1.0, 0.0],
        [1.0, -1.0, 0.0],
        [1.0, 1.0, 0.0],
        [-1.0, 1.0, 0.0],
        [0.0, 0.0, 1.001],
    ];
    let faces = [
        [0, 1, 4],
        [1, 2, 4],
        [2, 3, 4],
        [3, 0, 4],
        [0, 2, 1],
        [0, 3, 2],
    ];
    let mut obj = String::new();
    let mut ply = "ply\nformat ascii 1.0\nelement vertex 5\nproperty double x\nproperty double y\nproperty double z\n\
                   element face 6\nproperty list uchar int vertex_indices\nend_header\n"
        .to_owned();
    for corner in corners {
        let DVec3 { x, y, z } = at + DVec3::from(corner);
        writeln!(obj, "v {x:.4} {y:.4} {z:.4}").unwrap();
        writeln!(ply, "{x:.4} {y:.4} {z:.4}").unwrap();
    }
    for [a, b, c] in faces {
        writeln!(obj, "f {} {} {}", a + 1, b + 1, c + 1).unwrap();
        writeln!(ply, "3 {a} {b} {c}").unwrap();
    }
    (obj, ply)
}

#[test]
fn survey_coordinates_keep_their_millimetres() {
    let t = Scratch::new("survey");
    let far = DVec3::new(4_500_000.125, 600_000.375, 100.0);
    let (obj, ply) = pyramid(far);
    t.put("far.obj", obj);
    t.put("far.ply", ply);
    for name in ["far.obj", "far.ply"] {
        let read = read(&t, name);
        let mesh = read.mesh();
        let top = mesh
            .positions
            .iter()
            .fold(Vec3::NEG_INFINITY, |a, p| if p.z > a.z { *p } else { a });
        let exact = read.model.origin + top.as_dvec3();
        assert!(
            (exact - (far + DVec3::Z * 1.001)).length() < 1e-5,
            "{name}: {exact}"
        );
        assert!(read.warnings.is_empty(), "{:?}", read.warnings);
    }
    // What has 32 bits in the file has lost them.
    let text = "v 4500000 600000 100\nv 4500000.5 600000 100\nv 4500000 600000.5 100\nf 1 2 3\n";
    put(&t, "coarse.obj", text).warns("32-bit numbers");

    // Moved back, or seen there, it looks as the one at the origin.
    t.put("near.obj", pyramid(DVec3::ZERO).0);
    t.exr("light.exr", 8, 4, |x, y, c| {
        ((x * 3 + y * 5 + c * 7) % 11) as f32
    });
    let picture = |mesh: &str, translate: DVec3, at: DVec3| {
        let camera = [at + DVec3::new(-4.0, -1.0, 2.0), at].map(|p| p.to_array());
        t.put(
            "shot.toml",
            format!(
                "[image]\nsize = [32, 24]\nrays_per_pixel = 4\n[camera]\neye = {:?}\ntarget = {:?}\n[probe]\nframes = \"light.exr\"\n\
                 [[object]]\nmesh = \"{mesh}\"\nup = \"z\"\ntranslate = {:?}\n\
                 [[object]]\nmesh = \"plane\"\nscale = 8\ntranslate = {:?}\n",
                camera[0],
                camera[1],
                translate.to_array(),
                (at - DVec3::Z * 0.5).to_array()
            ),
        );
        t.run(&["render", "shot.toml", "--overwrite"]).ok();
        read_exr(&t.file("out/frame.0001.exr"))
    };
    let near = picture("near.obj", DVec3::ZERO, DVec3::ZERO);
    let likeness = |other: &[Vec<f32>]| {
        let pairs = near.iter().flatten().zip(other.iter().flatten());
        pairs.map(|(a, b)| (a - b).abs()).sum::<f32>() / near.iter().flatten().sum::<f32>()
    };
    for (name, seen) in [
        ("moved back", picture("far.obj", -far, DVec3::ZERO)),
        ("seen there", picture("far.ply", DVec3::ZERO, far)),
        ("moved there", picture("near.obj", far, far)),
    ] {
        assert!(likeness(&seen) < 2e-3, "{name}: {}", likeness(&seen));
    }
    assert!(likeness(&picture("near.obj", DVec3::X * 0.3, DVec3::ZERO)) > 0.01);
}

const QUAD: &str = "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nusemtl a\nf 1/1 2/2 3/3 4/4\n";

/// A quad with a material of these lines.
fn with_material(t: &Scratch, lines: &str) -> Read {
    t.put("a.mtl", format!("newmtl a\n{lines}\n"));
    put(t, "a.obj", format!("mtllib a.mtl\n{QUAD}"))
}

#[test]
fn options_of_maps_place_the_texture() {
    let t = Scratch::new("mtl-options");
    texture(&t, "paint.png", [255, 0, 0, 255]);
    let read = with_material(
        &t,
        "Kd 1 1 1\nmap_Kd -s 2 3 1 -o 0.25 0.5 0 -clamp on paint.png",
    );
    let Reflection::MetallicRoughness {
        base_color_texture: Some(texture),
        ..
    } = read.model.materials[0].reflection
    else {
        panic!("a picture");
    };
    // In the file's coordinates, whose v grows upwards, (u, v) looks at (2u + 0.25, 3v + 0.5).
    for (u, v) in [(0.0, 0.0), (1.0, 0.0), (0.3, 0.7)] {
        let found = texture.transform.transform_point2(Vec2::new(u, 1.0 - v));
        let exact = Vec2::new(2.0 * u + 0.25, 1.0 - (3.0 * v + 0.5));
        assert!(found.abs_diff_eq(exact, 1e-6), "{found} {exact}");
    }
    assert_eq!(read.model.textures[0].wrap, [Wrap::Clamp; 2]);
    assert!(read.warnings.is_empty(), "{:?}", read.warnings);
    with_material(&t, "map_Kd -mm 0.2 1 paint.png\ndisp paint.png")
        .warns("not used are map_Kd -mm, disp");
}

#[test]
fn transparency_emission_and_physical_values_are_used() {
    let t = Scratch::new("mtl-values");
    texture(&t, "half.png", [128, 128, 128, 255]);
    let alpha = |read: &Read| match read.model.materials[0].opacity {
        Opacity::Blend { alpha } => alpha,
        other => panic!("{other:?}"),
    };
    let factor = |lines: &str| alpha(&with_material(&t, lines)).factor;
    assert!((factor("Tr 0.75") - 0.25).abs() < 1e-6);
    assert!((factor("d 0.25") - 0.25).abs() < 1e-6);
    // Programs that write both mean d.
    assert!((factor("d 0.25\nTr 0.25") - 0.25).abs() < 1e-6);
    assert_eq!(
        with_material(&t, "d 1\nTr 0").model.materials[0].opacity,
        Opacity::Opaque
    );
    with_material(&t, "Tr 1").warns("fully transparent");
    let mapped = with_material(&t, "map_d half.png");
    let texture = alpha(&mapped).texture.expect("a texture");
    assert_eq!(
        mapped.model.textures[texture.texture as usize].texels[0][3],
        128
    );

    let glowing = with_material(&t, "Ke 2 3 4\nmap_Ke half.png");
    let material = &glowing.model.materials[0];
    assert_eq!(material.emission, Vec3::new(2.0, 3.0, 4.0));
    let texture = material.emission_texture.expect("a texture");
    assert!(glowing.model.textures[texture.texture as usize].srgb);
    assert_eq!(
        with_material(&t, "map_Ke half.png").model.materials[0].emission,
        Vec3::ONE
    );

    let physical = with_material(&t, "Kd 0.2 0.3 0.4\nPr 0.3\nPm 0.7\nmap_Pr half.png");
    let Reflection::MetallicRoughness {
        base_color,
        metallic,
        roughness,
        metallic_roughness_texture: Some(texture),
        ..
    } = physical.model.materials[0].reflection
    else {
        panic!("it is physical");
    };
    assert_eq!(
        (base_color, metallic, roughness),
        (Vec3::new(0.2, 0.3, 0.4), 0.7, 0.3)
    );
    let texel = physical.model.textures[texture.texture as usize].texels[0];
    // Green is roughness, and blue, which the file does not say, leaves metallic as it is.
    assert_eq!(texel[1..3], [128, 255]);
    with_material(&t, "illum 4").warns("refraction");
    with_material(&t, "Kd 1 x 1").warns("line 2");
}

#[test]
fn a_bump_map_is_a_height_unless_it_looks_like_normals() {
    let t = Scratch::new("mtl-bump");
    // Rises by a quarter of white a texel to the right; between the ends the slope is 1/4 · 0.5.
    image::RgbImage::from_fn(5, 3, |x, _| {
        image::Rgb([(x as f32 * 63.75).round() as u8; 3])
    })
    .save(t.file("height.png"))
    .unwrap();
    texture(&t, "normal.png", [128, 128, 255, 255]);
    let normal = |read: &Read| match read.model.materials[0].reflection {
        Reflection::MetallicRoughness {
            normal_texture: Some(texture),
            normal_scale,
            ..
        } => {
            let texture = &read.model.textures[texture.texture as usize];
            assert!(!texture.srgb);
            let texel =
                texture.texels[texture.size.x as usize + 2].map(|c| f32::from(c) / 127.5 - 1.0);
            (Vec3::new(texel[0], texel[1], texel[2]), normal_scale)
        }
        ref other => panic!("{other:?}"),
    };
    for name in ["bump", "map_Bump", "map_bump"] {
        let (n, scale) = normal(&with_material(&t, &format!("{name} -bm 0.5 height.png")));
        assert!(
            n.abs_diff_eq(Vec3::new(-0.125, 0.0, 1.0).normalize(), 0.01),
            "{name}: {n}"
        );
        assert_eq!(scale, 1.0);
    }
    let read = with_material(&t, "map_Bump -bm 0.5 normal.png");
    assert_eq!(normal(&read).1, 0.5);
    assert!(
        read.notes.iter().any(|n| n.contains("is a normal map")),
        "{:?}",
        read.notes
    );
    assert_eq!(normal(&with_material(&t, "norm normal.png")).1, 1.0);
}

#[test]
fn odd_files_of_other_programs_are_read() {
    let t = Scratch::new("odd");
    let diffuse = |read: &Read, index: usize| match read.model.materials[index].reflection {
        Reflection::BlinnPhong { diffuse, .. } => diffuse,
        ref other => panic!("{other:?}"),
    };
    let red = "newmtl red\nKd 0.8 0.1 0.1\n";
    t.put("x.mtl", [b"# \xfcber\n", red.as_bytes()].concat());
    t.put("my paints.mtl", red);
    let cases: [(&str, Vec<u8>); 5] = [
        (
            "latin1.obj",
            [b"# \xfcber\ng Gr\xfcn\n".as_slice(), b"mtllib x.mtl\n"].concat(),
        ),
        ("bom.obj", b"\xef\xbb\xbfmtllib .\\X.mtl\n".to_vec()),
        ("spaces.obj", b"mtllib my paints.mtl\n".to_vec()),
        ("folder.obj", b"mtllib C:\\work\\x.mtl\n".to_vec()),
        ("two.obj", b"mtllib gone.mtl x.mtl\n".to_vec()),
    ];
    for (name, head) in cases {
        let body = "usemtl red\nv 0 0 0\nv 1 0 \\\n 0\nv 0 1 0\nf -3 -2 \\\n -1\n";
        let read = put(&t, name, [&head, body.as_bytes()].concat());
        assert_eq!(diffuse(&read, 0), Vec3::new(0.8, 0.1, 0.1), "{name}");
        assert!((area(read.mesh()) - 0.5).abs() < 1e-6, "{name}");
        assert_eq!(
            read.warnings.is_empty(),
            name != "two.obj",
            "{:?}",
            read.warnings
        );
    }
    let mut gz = GzEncoder::new(Vec::new(), Compression::fast());
    gz.write_all(cube("").as_bytes()).unwrap();
    let packed = put(&t, "a.obj.gz", gz.finish().unwrap());
    assert!((area(packed.mesh()) - 24.0).abs() < 1e-5);
    put(
        &t,
        "a.obj",
        "mtllib x.mtl\nusemtl blue\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
    )
    .warns("`blue` is in none");
    put(
        &t,
        "a.obj",
        "usemtl blue\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
    )
    .warns("no material library");
    let bare = "mtllib y.mtl\nusemtl paint\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    texture(&t, "paint.png", [255, 0, 0, 255]);
    t.put("y.mtl", "newmtl paint\nmap_Kd paint.png\n");
    put(&t, "a.obj", bare).warns("1 triangles of material `paint` have no texture coordinates");
}

#[test]
fn stl_files_are_read() {
    let t = Scratch::new("stl");
    let corners: Vec<Vec3> = cube_corners()
        .map(|c| Vec3::from(c.map(|x| x as f32)))
        .collect();
    let triangles: Vec<[Vec3; 3]> = CUBE_FACES
        .iter()
        .flat_map(|[a, b, c, d]| [[a, b, c], [a, c, d]])
        .map(|t| t.map(|i| corners[i - 1]))
        .collect();
    let mut binary = vec![b' '; 80];
    binary.extend(12u32.to_le_bytes());
    let mut ascii = "solid cube\n".to_owned();
    for triangle in &triangles {
        binary.extend([0; 12]);
        ascii.push_str("facet normal 0 0 0\nouter loop\n");
        for p in triangle {
            binary.extend(p.to_array().into_iter().flat_map(f32::to_le_bytes));
            writeln!(ascii, "vertex {} {} {}", p.x, p.y, p.z).unwrap();
        }
        binary.extend([0; 2]);
        ascii.push_str("endloop\nendfacet\n");
    }
    ascii.push_str("endsolid cube\n");
    t.put("ascii.stl", ascii);
    t.put("binary.stl", binary);
    for name in ["ascii.stl", "binary.stl"] {
        let read = read(&t, name);
        assert!((area(read.mesh()) - 24.0).abs() < 1e-5, "{name}");
        assert!(least_cosine(read.mesh()) > 0.999_999, "{name}");
        assert_eq!(read.mesh().positions.len(), 24, "{name}");
    }
    let info = t.run(&["info", "binary.stl", "--json"]).ok();
    // Notes come as lines of their own.
    let mut lines = info
        .out
        .lines()
        .map(|line| serde_json::from_str(line).unwrap());
    let info: serde_json::Value = lines
        .find(|line: &serde_json::Value| line["kind"] == "mesh")
        .expect("what it holds");
    assert_eq!(info["triangles"], 12);
    assert_eq!(info["normals"]["creased"], 12);
}
