//! Host file: precomputed transfer against closed forms and quadrature, where surfaces meet and touch, and on both processors.

use glam::{DVec3, Mat4, Vec3, vec3};
use glimt_render_gpu::generated::entries::TRANSFER;
use glimt_render_gpu::gpu::{self, Arg, GpuScene};
use glimt_render_gpu::kernels::transfer::{STATE, transfer};
use glimt_render_gpu::prepare::bake::{BakeSettings, bake, for_kernels};
use glimt_render_gpu::prepare::scene::{Material, Mesh, Object, Reflection, SceneDescription};
use glimt_render_gpu::prepare::scene_build::SceneBuffers;
use glimt_render_gpu::prepare::transfer::Transfer;
use glimt_sh::{basis, cosine_lobe};
use glimt_tests::gpu::adapter_or_skip;
use std::f64::consts::PI;

const BANDS: u32 = 6;

fn settings(directions: u32, seed: u32) -> BakeSettings {
    BakeSettings {
        bands: BANDS,
        directions,
        seed,
    }
}

/// Meshes where they are, each with whether it is a catcher.
fn scene(parts: Vec<(Mesh, bool)>) -> SceneBuffers {
    let objects = (0..).zip(&parts).map(|(mesh, (_, catcher))| Object {
        mesh,
        transform: Mat4::IDENTITY,
        material: None,
        catcher: *catcher,
    });
    SceneBuffers::build(&SceneDescription {
        objects: objects.collect(),
        meshes: parts.into_iter().map(|(mesh, _)| mesh).collect(),
        materials: vec![Material::from(Reflection::BlinnPhong {
            diffuse: Vec3::splat(0.5),
            specular: Vec3::ZERO,
            exponent: 0.0,
        })],
        textures: Vec::new(),
    })
    .expect("a scene")
}

fn mesh(positions: Vec<Vec3>, normals: Vec<Vec3>, indices: Vec<[u32; 3]>) -> Mesh {
    Mesh {
        name: "mesh".to_owned(),
        positions,
        normals,
        indices,
        materials: vec![0],
        ..Mesh::default()
    }
}

/// A parallelogram with vertices of its own.
fn quad(corner: Vec3, u: Vec3, v: Vec3) -> Mesh {
    let n = u.cross(v).normalize();
    mesh(
        vec![corner, corner + u, corner + u + v, corner + v],
        vec![n; 4],
        vec![[0, 1, 2], [0, 2, 3]],
    )
}

fn joined(meshes: &[Mesh]) -> Mesh {
    let mut all = mesh(Vec::new(), Vec::new(), Vec::new());
    for part in meshes {
        let first = all.positions.len() as u32;
        all.positions.extend(&part.positions);
        all.normals.extend(&part.normals);
        all.indices
            .extend(part.indices.iter().map(|face| face.map(|i| first + i)));
    }
    all
}

/// A box with four vertices on each side.
fn cuboid(low: Vec3, high: Vec3) -> Mesh {
    let d = high - low;
    let [x, y, z] = [Vec3::X * d.x, Vec3::Y * d.y, Vec3::Z * d.z];
    joined(&[
        quad(low, y, x),
        quad(low + z, x, y),
        quad(low, x, z),
        quad(low + y, z, x),
        quad(low, z, y),
        quad(low + x, y, z),
    ])
}

/// A grid of squares in a plane of constant z.
fn floor(z: f32, half: f32, cells: u32) -> Mesh {
    let side = cells + 1;
    let at = |i: u32| half * (2.0 * i as f32 / cells as f32 - 1.0);
    let places = (0..side * side).map(|i| vec3(at(i % side), at(i / side), z));
    let squares = (0..cells * cells).map(|i| i / cells * side + i % cells);
    let faces = squares.flat_map(|a| [[a, a + 1, a + side + 1], [a, a + side + 1, a + side]]);
    mesh(places.collect(), Vec::new(), faces.collect())
}

/// A sphere in rings; its poles are its first and last vertices.
fn sphere(centre: Vec3, radius: f32, rings: u32, sectors: u32) -> Mesh {
    let mut positions = vec![centre + radius * Vec3::Z];
    for ring in 1..rings {
        let (sin, cos) = (std::f32::consts::PI * ring as f32 / rings as f32).sin_cos();
        for sector in 0..sectors {
            let (y, x) = (std::f32::consts::TAU * sector as f32 / sectors as f32).sin_cos();
            positions.push(centre + radius * vec3(sin * x, sin * y, cos));
        }
    }
    positions.push(centre - radius * Vec3::Z);
    let south = positions.len() as u32 - 1;
    let at = |ring: u32, sector: u32| 1 + (ring - 1) * sectors + sector % sectors;
    let mut faces = Vec::new();
    for s in 0..sectors {
        faces.push([0, at(1, s), at(1, s + 1)]);
        for ring in 1..rings - 1 {
            let [a, b] = [at(ring, s), at(ring, s + 1)];
            let [c, d] = [at(ring + 1, s), at(ring + 1, s + 1)];
            faces.extend([[a, c, b], [b, c, d]]);
        }
        faces.push([south, at(rings - 1, s + 1), at(rings - 1, s)]);
    }
    mesh(positions, Vec::new(), faces)
}

fn transfer_of(scene: &SceneBuffers, settings: &BakeSettings) -> Transfer {
    bake(scene, settings, &|_| ()).expect("a transfer").transfer
}

fn at(list: &[f32], vertex: usize) -> [f32; 36] {
    list[vertex * 36..][..36].try_into().expect("six bands")
}

/// What no occluder leaves of it.
fn closed_form(normal: Vec3) -> [f32; 36] {
    let y = basis(normal);
    std::array::from_fn(|k| cosine_lobe((k as f32).sqrt() as u32) * y[k])
}

/// `∫ ⟨n·ω⟩ y_lm(ω) dω` over the directions that are visible.
fn quadrature(normal: Vec3, visible: impl Fn(DVec3) -> bool) -> [f32; 36] {
    const ROWS: u32 = 720;
    let mut sums = [0.0f64; 36];
    for row in 0..ROWS {
        let z = 1.0 - 2.0 * (f64::from(row) + 0.5) / f64::from(ROWS);
        for column in 0..2 * ROWS {
            let (sin, cos) = (PI * (f64::from(column) + 0.5) / f64::from(ROWS)).sin_cos();
            let radius = (1.0 - z * z).sqrt();
            let d = DVec3::new(radius * cos, radius * sin, z);
            let cosine = normal.as_dvec3().dot(d);
            if cosine > 0.0 && visible(d) {
                let y = basis(d.as_vec3());
                for (sum, y) in sums.iter_mut().zip(y) {
                    *sum += cosine * f64::from(y);
                }
            }
        }
    }
    let area = 4.0 * PI / f64::from(2 * ROWS * ROWS);
    sums.map(|sum| (sum * area) as f32)
}

/// Root of the mean square of the difference.
fn rms(a: &[f32], b: &[f32]) -> f64 {
    assert_eq!(a.len(), b.len());
    let squares = a.iter().zip(b).map(|(a, b)| f64::from(a - b).powi(2));
    (squares.sum::<f64>() / a.len() as f64).sqrt()
}

/// Points that nothing touches, with the normals given, and a triangle far away that is a catcher.
fn loose(normals: &[Vec3]) -> SceneBuffers {
    let mut positions: Vec<Vec3> = normals.iter().map(|n| *n * 3.0).collect();
    let mut normals = normals.to_vec();
    let first = positions.len() as u32;
    positions.extend([
        vec3(0.0, 0.0, -90.0),
        vec3(1.0, 0.0, -90.0),
        vec3(0.0, 1.0, -90.0),
    ]);
    normals.extend([Vec3::Z; 3]);
    let faces = vec![[first, first + 1, first + 2]];
    scene(vec![(mesh(positions, normals, faces), true)])
}

fn many_normals(count: u32) -> Vec<Vec3> {
    let golden = 2.399_963;
    let normal = |i: u32| {
        let z = 1.0 - 2.0 * (i as f32 + 0.5) / count as f32;
        let (sin, cos) = (golden * i as f32).sin_cos();
        vec3(cos, sin, 0.0) * (1.0 - z * z).sqrt() + Vec3::Z * z
    };
    (0..count).map(normal).collect()
}

#[test]
fn nothing_in_the_way_gives_the_closed_form() {
    let normals = many_normals(300);
    let scene = loose(&normals);
    let mut errors = Vec::new();
    for directions in [7, 100, 900, 2500, 10_007] {
        let made = transfer_of(&scene, &settings(directions, 1));
        assert!(made.blocked.iter().all(|c| *c == 0.0));
        let square = |(i, n): (usize, &Vec3)| rms(&at(&made.lit, i), &closed_form(*n)).powi(2);
        let mean = normals.iter().enumerate().map(square).sum::<f64>() / normals.len() as f64;
        errors.push((directions, mean.sqrt()));
    }
    println!("{errors:?}");
    // Independent directions: variance (4π)² ⟨T²y²⟩/N, with ⟨T²⟩ = 1/6 and ⟨y²⟩ about 1/4π.
    let independent = |n: u32| (4.0 * PI / 6.0 / f64::from(n)).sqrt();
    for &(n, error) in &errors {
        assert!(error < independent(n), "{n}: {error} of {}", independent(n));
    }
    let of = |n| errors.iter().find(|e| e.0 == n).expect("measured").1;
    // Strata make it fall nearly as 1/N, while independent directions make it a fifth.
    assert!(of(2500) < of(100) / 12.0, "{errors:?}");
    assert!(of(2500) < 0.15 * independent(2500), "{errors:?}");
    assert!(of(10_007) < of(2500) / 2.5, "{errors:?}");

    // The comparator sees a Condon–Shortley sign.
    let made = transfer_of(&scene, &settings(2500, 1));
    let other = |n: Vec3| closed_form(vec3(-n.x, n.y, n.z));
    let aside = normals.iter().position(|n| n.x > 0.7).expect("one");
    let wrong = rms(&at(&made.lit, aside), &other(normals[aside]));
    assert!(wrong > 30.0 * of(2500), "{wrong}");
}

#[test]
fn any_number_of_directions_is_unbiased() {
    for n in [1, 2, 3, 7, 13, 100] {
        let normal = vec3(0.48, -0.6, 0.64);
        let scene = loose(&[normal; 4000]);
        let made = transfer_of(&scene, &settings(n, 3));
        let truth = closed_form(normal);
        for k in 0..36 {
            let values = (0..4000).map(|v| f64::from(made.lit[v * 36 + k]));
            let (sum, squares) = values.fold((0.0, 0.0), |(s, q), x| (s + x, q + x * x));
            let mean = sum / 4000.0;
            let error = ((squares / 4000.0 - mean * mean) / 4000.0).sqrt();
            let off = (mean - f64::from(truth[k])) / error;
            assert!(off.abs() < 4.5, "{n} directions, coefficient {k}: {off} σ");
        }
    }
}

#[test]
fn a_roof_over_half_the_sky() {
    let roof = quad(vec3(0.0, -3e4, 1.0), Vec3::X * 3e4, Vec3::Y * 6e4);
    let ground = floor(0.0, 0.5, 2);
    let scene = scene(vec![(ground, false), (roof, false)]);
    let made = transfer_of(&scene, &settings(40_000, 1));
    // The middle of the grid; the roof is above x > 0.
    let lit = quadrature(Vec3::Z, |d| d.x < 0.0);
    let blocked = quadrature(Vec3::Z, |d| d.x > 0.0);
    let errors = [
        rms(&at(&made.lit, 4), &lit),
        rms(&at(&made.blocked, 4), &blocked),
    ];
    assert!(errors.iter().all(|e| *e < 2e-3), "{errors:?}");
    // Another vertex sees the roof's edge elsewhere; the comparator sees that.
    let other = rms(&at(&made.lit, 3), &lit);
    assert!(other > 2e-2, "{other}");
    // Both parts together are the whole.
    let whole: Vec<f32> = (0..36)
        .map(|k| made.lit[4 * 36 + k] + made.blocked[4 * 36 + k])
        .collect();
    assert!(rms(&whole, &closed_form(Vec3::Z)) < 1e-3);
}

/// The vertex of `scene` at a place and with a normal.
fn vertex(scene: &SceneBuffers, object: u32, place: Vec3, normal: Vec3) -> usize {
    let vertices = scene.vertices().expect("vertices");
    let found = vertices.iter().position(|v| {
        v.object == object && v.position.distance(place) < 1e-6 && v.normal.distance(normal) < 1e-3
    });
    found.unwrap_or_else(|| panic!("no vertex of {object} at {place} with {normal}"))
}

#[test]
fn the_corner_of_a_room_sees_an_octant() {
    for origin in [Vec3::ZERO, vec3(31.7, -55.1, 12.3)] {
        let walls = [
            quad(origin, Vec3::X, Vec3::Y),
            quad(origin, Vec3::Y, Vec3::Z),
            quad(origin, Vec3::Z, Vec3::X),
        ];
        // Sides with normals of their own, in one object and in three; and one normal for all.
        let mut welded = joined(&walls);
        let diagonal = Vec3::ONE.normalize();
        for (p, n) in welded.positions.iter().zip(&mut welded.normals) {
            if *p == origin {
                *n = diagonal;
            }
        }
        let cases = [
            (
                scene(vec![(joined(&walls), false)]),
                vec![(0, Vec3::X), (0, Vec3::Y), (0, Vec3::Z)],
            ),
            (
                scene(walls.iter().map(|w| (w.clone(), false)).collect()),
                vec![(1, Vec3::X), (2, Vec3::Y), (0, Vec3::Z)],
            ),
            (scene(vec![(welded, false)]), vec![(0, diagonal)]),
        ];
        for (scene, corners) in cases {
            let made = transfer_of(&scene, &settings(10_000, 1));
            for (object, normal) in corners {
                let v = vertex(&scene, object, origin, normal);
                let truth = quadrature(normal, |d| d.min_element() > 0.0);
                let error = rms(&at(&made.lit, v), &truth);
                assert!(error < 6e-3, "{origin} {object} {normal}: {error}");
                let open = rms(&at(&made.lit, v), &closed_form(normal));
                assert!(open > 5e-2, "{open}");
            }
        }
    }
}

#[test]
fn what_is_convex_blocks_none_of_its_own_light() {
    let far = vec3(731.0, -250.0, 90.0);
    let mut welded = cuboid(Vec3::ZERO, Vec3::ONE);
    for (p, n) in welded.positions.iter().zip(&mut welded.normals) {
        *n = (*p - 0.5).normalize();
    }
    for (name, part) in [
        ("fine", sphere(Vec3::ZERO, 1.0, 40, 80)),
        ("coarse", sphere(Vec3::ZERO, 1.0, 4, 5)),
        ("far", sphere(far, 1.0, 12, 24)),
        ("box", cuboid(vec3(-1.0, -2.0, 0.0), vec3(1.0, 3.0, 0.5))),
        ("welded", welded),
        ("quad", quad(vec3(5.0, 5.0, 5.0), Vec3::X, Vec3::Z)),
    ] {
        let scene = scene(vec![(part, false)]);
        let made = transfer_of(&scene, &settings(400, 1));
        let n = made.blocked.len() / 36;
        let blocked = (0..n)
            .filter(|v| at(&made.blocked, *v) != [0.0; 36])
            .count();
        assert_eq!(blocked, 0, "{name}: {blocked} of {n} vertices");
    }
}

#[test]
fn what_stands_on_the_ground_is_dark_below() {
    for z in [0.0, 0.7, -123.4] {
        let up = Vec3::Z * z;
        // The grid's vertices lie on the box's walls and corners, too, and under it.
        let ground = floor(z, 4.0, 8);
        let cube = cuboid(up + vec3(-1.0, -1.0, 0.0), up + vec3(1.0, 1.0, 2.0));
        let both = scene(vec![(cube, false), (ground.clone(), false)]);
        let made = transfer_of(&both, &settings(2500, 1));
        // Far from the origin rays start so far above the ground that some pass beyond its end.
        let is_dark = |c: [f32; 36]| c.iter().all(|c| c.abs() < 1e-5);
        let dark = |v| is_dark(at(&made.lit, v));
        let corner = |x, y, n| vertex(&both, 0, up + vec3(x, y, 0.0), n);
        for (x, y) in [(-1.0, -1.0), (1.0, 1.0), (1.0, -1.0)] {
            assert!(dark(corner(x, y, Vec3::NEG_Z)), "the box's underside");
        }
        let wall = corner(1.0, -1.0, Vec3::X);
        let truth = quadrature(Vec3::X, |d| d.z > 0.0);
        let error = rms(&at(&made.lit, wall), &truth);
        assert!(error < 1e-2, "the foot of a wall: {error}");
        assert!(
            dark(vertex(&both, 1, up, Vec3::Z)),
            "the ground under the box"
        );
        // Where the box's wall meets the ground, both sides of it or the outer one.
        let foot = vertex(&both, 1, up + vec3(1.0, 0.0, 0.0), Vec3::Z);
        let outside = quadrature(Vec3::Z, |d| d.x > 0.0);
        let error = rms(&at(&made.lit, foot), &outside);
        assert!(error < 1e-2, "the ground at a wall: {error}");

        // A ball touches it in one point.
        let ball = sphere(up + Vec3::Z, 1.0, 32, 64);
        let south = ball.positions.len() - 1;
        let touching = scene(vec![(ball.clone(), false), (ground.clone(), false)]);
        let made = transfer_of(&touching, &settings(900, 1));
        assert!(is_dark(at(&made.lit, south)), "the ball's lowest point");
        // The faces around that rise by a slope of 0.05, beneath which light comes in.
        let faint = |c: [f32; 36]| c[0].abs() < 0.01 * closed_form(Vec3::Z)[0];
        let under = vertex(&touching, 1, up, Vec3::Z);
        assert!(faint(at(&made.lit, under)), "the ground's point");
        assert_eq!(at(&made.blocked, 0), [0.0; 36], "the ball's top");

        // A catcher blocks nothing, touched or not, and takes shadows itself.
        let over_catcher = scene(vec![(ball, false), (ground, true)]);
        let made = transfer_of(&over_catcher, &settings(900, 1));
        assert!(made.blocked[..(south + 1) * 36].iter().all(|c| *c == 0.0));
        let under = vertex(&over_catcher, 1, up, Vec3::Z);
        assert!(faint(at(&made.lit, under)));
    }
}

/// The same faces, their corners the other way round.
fn wound_backwards(mut mesh: Mesh) -> Mesh {
    for face in &mut mesh.indices {
        face.swap(1, 2);
    }
    mesh
}

/// An adapter may end loops early, as a software one does. Then the count of directions says so; where it is whole, so are the sums.
#[test]
fn directions_that_were_not_gone_through_are_missed() {
    let Some(context) = adapter_or_skip("directions_that_were_not_gone_through_are_missed") else {
        return;
    };
    let ball = sphere(vec3(0.0, 0.0, 1.5), 1.0, 64, 128);
    let sheet = quad(vec3(-1.0, -1.0, 0.0), 2.0 * Vec3::X, 2.0 * Vec3::Y);
    let scene = scene(vec![(sheet, false), (ball, false)]);
    let known = &for_kernels(&scene.vertices().unwrap(), 0)[..4];
    let uploaded = GpuScene::new(&context, &scene).unwrap();
    let vertices = context.buffer_of("vertices", known).unwrap();
    for directions in [100, 1 << 16] {
        let params = settings(directions, 1).params();
        let [lit, blocked] = [0; 2].map(|_| context.buffer("sums", 4 * 36 * 4).unwrap());
        let state = context.buffer("state", 4 * 4 * STATE as u64).unwrap();
        let rays = context.buffer("rays", 4 * 4).unwrap();
        let mut args = vec![
            ("params", Arg::Value(bytemuck::bytes_of(&params))),
            ("vertices", Arg::Buffer(&vertices)),
            ("state", Arg::Chunk(&state, STATE as u32)),
            ("lit", Arg::Chunk(&lit, 36)),
            ("blocked", Arg::Chunk(&blocked, 36)),
            ("out", Arg::Buffer(&rays)),
        ];
        args.extend(uploaded.tree_args());
        context.launch(&TRANSFER, &args, 0, 4).unwrap();
        let gone: Vec<u32> = context.read(&state, 4 * STATE).unwrap();
        let made: Vec<f32> = context.read(&lit, 4 * 36).unwrap();
        for v in 0..4 {
            let mut own = [[0.0; 36]; 2];
            let [lit, blocked] = &mut own;
            let (mut kept, view) = ([0; STATE], scene.view());
            let at_v = v as u32;
            let (nodes, triangles) = (view.nodes, view.triangles);
            let _ = transfer(
                at_v,
                &params,
                nodes,
                triangles,
                view.surface,
                known,
                &mut kept,
                lit,
                blocked,
            );
            assert_eq!(kept[STATE - 1], directions);
            let is_whole = gone[v * STATE + STATE - 1] == directions;
            let error = rms(&at(&made, v), lit);
            assert_eq!(is_whole, error < 1e-4, "{directions}: {error}");
            assert!(is_whole || directions > 100);
        }
    }
}

/// Whether the transfer of a vertex is all there and nothing of it blocked.
fn is_open(made: &Transfer, v: usize, normal: Vec3) -> bool {
    at(&made.blocked, v) == [0.0; 36] && rms(&at(&made.lit, v), &closed_form(normal)) < 0.02
}

#[test]
fn what_lies_in_a_plane_and_faces_the_same_way_is_not_covered() {
    let context = adapter_or_skip("what_lies_in_a_plane_and_faces_the_same_way_is_not_covered");
    let by_each = |scene: &SceneBuffers, look: &dyn Fn(&Transfer)| {
        let settings = settings(2500, 1);
        look(&transfer_of(scene, &settings));
        if let Some(context) = &context {
            let made = gpu::bake(context, scene, &settings, &|_| ());
            look(&made.expect("a transfer").transfer);
        }
    };
    for (origin, x, y) in [
        (Vec3::ZERO, Vec3::X, Vec3::Y),
        (vec3(3.0, -1.0, 0.7), Vec3::X, Vec3::Y),
        (vec3(0.3, 0.1, -0.2), vec3(0.6, 0.0, 0.8), Vec3::Y),
    ] {
        let n = x.cross(y);
        let sheet = |half: f32, height: f32| {
            let corner = origin + n * height - half * (x + y);
            quad(corner, 2.0 * half * x, 2.0 * half * y)
        };
        // In the plane, and so far above it as rays start.
        for height in [0.0, 0.5, 1.5] {
            let height = height * 3.0 / 262_144.0;
            for backwards in [false, true] {
                let wound = |mesh: Mesh| match backwards {
                    true => wound_backwards(mesh),
                    false => mesh,
                };
                let parts = [sheet(0.3, height), sheet(1.0, 0.0)];
                let flat = scene(parts.map(|part| (wound(part), false)).to_vec());
                by_each(&flat, &|made| {
                    let open = (0..8).filter(|v| is_open(made, *v, n)).count();
                    assert_eq!(open, 8, "{origin}, {height} above, {backwards}");
                });
                // What faces the other way lies face down, and is dark.
                let mut lid = sheet(0.3, height);
                lid.normals = vec![-n; 4];
                let covered = scene(vec![(wound(lid), false), (wound(sheet(1.0, 0.0)), false)]);
                by_each(&covered, &|made| {
                    let dark = |v: usize| at(&made.lit, v).iter().all(|c| c.abs() < 1e-4);
                    assert!((0..4).all(dark), "{origin}, {height} above, {backwards}");
                    assert!((4..8).all(|v| is_open(made, v, n)));
                });
            }
        }
    }
    // Boxes of one height that overlap.
    let boxes = scene(vec![
        (cuboid(Vec3::ZERO, Vec3::ONE), false),
        (cuboid(vec3(0.5, 0.5, 0.0), vec3(1.5, 1.5, 1.0)), false),
    ]);
    by_each(&boxes, &|made| {
        for (object, place) in [(0, vec3(1.0, 1.0, 1.0)), (1, vec3(0.5, 0.5, 1.0))] {
            let v = vertex(&boxes, object, place, Vec3::Z);
            assert!(is_open(made, v, Vec3::Z), "{object}");
        }
    });
    // A box that stands on a rug on a floor: along its wall half the light is left, and beneath it none.
    let block = cuboid(vec3(-0.5, -0.5, 0.0), vec3(0.5, 0.7, 1.0));
    let stack = scene(vec![
        (floor(0.0, 1.0, 4), false),
        (floor(0.0, 3.0, 2), false),
        (block, false),
    ]);
    by_each(&stack, &|made| {
        let edge = vertex(&stack, 0, vec3(0.0, -0.5, 0.0), Vec3::Z);
        let outside = quadrature(Vec3::Z, |d| d.y < 0.0);
        let error = rms(&at(&made.lit, edge), &outside);
        assert!(error < 1e-2, "the rug at the box: {error}");
        let under = vertex(&stack, 0, Vec3::ZERO, Vec3::Z);
        assert!(at(&made.lit, under).iter().all(|c| c.abs() < 1e-5));
    });
}

#[test]
fn vertices_without_normal_or_face_get_zeros_and_odd_meshes_no_nan() {
    // A vertex that no face uses, one whose faces cancel, three faces at one edge, and no normals given.
    let odd = mesh(
        vec![
            Vec3::ZERO,
            Vec3::X,
            Vec3::Y,
            Vec3::Z,
            vec3(0.0, -1.0, -1.0),
            vec3(9.0, 9.0, 9.0),
        ],
        Vec::new(),
        vec![[0, 1, 2], [0, 1, 3], [1, 0, 4], [0, 0, 1]],
    );
    let two_sided = mesh(
        vec![
            vec3(5.0, 0.0, 0.0),
            vec3(6.0, 0.0, 0.0),
            vec3(5.0, 1.0, 0.0),
        ],
        Vec::new(),
        vec![[0, 1, 2], [0, 2, 1]],
    );
    let scene = scene(vec![(odd, false), (two_sided, false)]);
    let made = transfer_of(&scene, &settings(100, 1));
    made.check(9).expect("numbers");
    for v in 5..9 {
        assert_eq!(at(&made.lit, v), [0.0; 36], "{v}");
        assert_eq!(at(&made.blocked, v), [0.0; 36], "{v}");
    }
    assert!(at(&made.lit, 0)[0] > 0.0);
}

/// A ball and a torus-like ring of boxes on the ground.
fn clutter() -> SceneBuffers {
    let mut parts = vec![
        (floor(0.0, 3.0, 24), false),
        (sphere(vec3(0.2, 0.1, 0.8), 0.8, 24, 48), false),
    ];
    for i in 0..7 {
        let (sin, cos) = (i as f32 * 0.9).sin_cos();
        let p = vec3(1.7 * cos, 1.7 * sin, 0.0);
        parts.push((
            cuboid(p - vec3(0.2, 0.2, 0.0), p + vec3(0.2, 0.3, 1.1)),
            i == 3,
        ));
    }
    scene(parts)
}

#[test]
fn threads_change_no_bit_and_seeds_do() {
    let scene = clutter();
    let one = rayon::ThreadPoolBuilder::new()
        .num_threads(1)
        .build()
        .expect("a thread");
    let alone = one.install(|| transfer_of(&scene, &settings(100, 1)));
    let three = rayon::ThreadPoolBuilder::new()
        .num_threads(3)
        .build()
        .expect("threads");
    assert_eq!(
        alone,
        three.install(|| transfer_of(&scene, &settings(100, 1)))
    );
    assert_ne!(alone, transfer_of(&scene, &settings(100, 2)));
}

#[test]
fn both_processors_compute_the_same() {
    let Some(context) = adapter_or_skip("both_processors_compute_the_same") else {
        return;
    };
    let scene = clutter();
    // The last one takes several dispatches a vertex.
    for (bands, directions) in [(6, 100), (3, 37), (1, 25), (2, 900)] {
        let settings = BakeSettings {
            bands,
            directions,
            seed: 5,
        };
        let cpu = bake(&scene, &settings, &|_| ()).expect("a transfer");
        let told = std::cell::Cell::new(0.0);
        let gpu =
            gpu::bake(&context, &scene, &settings, &|share| told.set(share)).expect("a transfer");
        assert_eq!(told.get(), 1.0);
        // A direction on the horizon, or a ray along an edge, may fall either way.
        assert!(
            cpu.rays.abs_diff(gpu.rays) <= cpu.rays / 10_000,
            "{} {}",
            cpu.rays,
            gpu.rays
        );
        let n = (bands * bands) as usize;
        let vertices = cpu.transfer.lit.len() / n;
        let differs = |v: &usize| {
            let pairs = [
                (&cpu.transfer.lit, &gpu.transfer.lit),
                (&cpu.transfer.blocked, &gpu.transfer.blocked),
            ];
            let own = v * n..(v + 1) * n;
            pairs.iter().any(|(a, b)| {
                let mut pairs = a[own.clone()].iter().zip(&b[own.clone()]);
                pairs.any(|(a, b)| (a - b).abs() > 2e-5)
            })
        };
        let other = (0..vertices).filter(differs).count();
        println!("{other} of {vertices} vertices see another thing in a direction");
        assert!(other <= vertices / 100, "{other} of {vertices}");
        // What is nowhere blocked is so on both.
        let top = vertex(&scene, 1, vec3(0.2, 0.1, 1.6), Vec3::Z);
        assert!(
            gpu.transfer.blocked[top * n..(top + 1) * n]
                .iter()
                .all(|c| *c == 0.0)
        );
        // Another seed differs everywhere: the comparator sees it.
        let seed = 6;
        let wrong = bake(&scene, &BakeSettings { seed, ..settings }, &|_| ()).expect("a transfer");
        assert!(rms(&wrong.transfer.lit, &gpu.transfer.lit) > 1e-3);
    }
}
