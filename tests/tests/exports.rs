//! Host file: shaders that nobody generated use the WGSL that the crates ship, and find what the crates' Rust finds.

use std::collections::BTreeMap;

use glam::{UVec2, Vec2, Vec3, Vec4};
use glimt_brdf::{BlinnPhong, Lambert};
use glimt_envmap_cdf::EnvCdf;
use glimt_executor::{BufferSlot, Entry, ParamField, ParamsSpace};
use glimt_probe::latlong;
use glimt_render_gpu::gpu::{Arg, GpuContext};
use glimt_render_gpu::prepare::env::EnvMap;
use glimt_sampling::resample::{Comb, Scheme};
use glimt_sampling::ris::{RisPicks, RisSum};
use glimt_sampling::{OwenSobol, UniformSource, Xoshiro128PlusPlus, unit_vec2};
use glimt_smc::{Bridge, Endpoints, Particle};
use glimt_tests::gpu::adapter_or_skip;
use glimt_tests::worst::worst;

const COUNT: u32 = 10_000;

/// What a person writes around a crate's functions: bindings, and a main that calls them.
const MAIN: &str = "
struct Params { first: u32, count: u32, size: vec2<u32> }
@group(0) @binding(0) var<storage, read> params: Params;
@group(0) @binding(3) var<storage, read_write> out: array<vec4<f32>>;

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) gid: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>) {
    let local = gid.y * (groups.x * 64u) + gid.x;
    if local >= params.count { return; }
    let id = params.first + local;
    out[local] = value(id);
}
";

/// Runs `value(id)` of a hand-written shader over `COUNT` ids.
fn run(
    context: &GpuContext,
    shipped: &str,
    by_hand: &str,
    tables: [&[u32]; 2],
    size: UVec2,
) -> Vec<Vec4> {
    let uses_tables = shipped.contains("@group");
    let slot = BufferSlot::new;
    let mut buffers = vec![slot("out", 3, 16, true)];
    if uses_tables {
        buffers.push(slot("marginal", 1, 4, false));
        buffers.push(slot("conditional", 2, 4, false));
    }
    let entry = Entry {
        name: "main".into(),
        kernel: "".into(),
        params_space: ParamsSpace::Storage,
        wgsl: format!("{shipped}{MAIN}{by_hand}").into(),
        workgroup_size: 64,
        params_size: 16,
        params: vec![
            ParamField::new("first", 0, 4),
            ParamField::new("count", 4, 4),
            ParamField::new("size", 8, 8),
        ]
        .into(),
        buffers: buffers.into(),
    };
    let out = context.buffer("out", u64::from(COUNT) * 16).unwrap();
    let marginal = context.buffer_of("marginal", tables[0]).unwrap();
    let conditional = context.buffer_of("conditional", tables[1]).unwrap();
    let size = size.to_array();
    let mut args = vec![
        ("size", Arg::Value(bytemuck::bytes_of(&size))),
        ("out", Arg::Buffer(&out)),
    ];
    if uses_tables {
        args.push(("marginal", Arg::Buffer(&marginal)));
        args.push(("conditional", Arg::Buffer(&conditional)));
    }
    context.launch(&entry, &args, 0, COUNT).unwrap();
    let words: Vec<[f32; 4]> = context.read(&out, COUNT as usize).unwrap();
    words.into_iter().map(Vec4::from_array).collect()
}

/// The largest difference between a shader's values and Rust's, relative to the largest value; NaN where there is one.
fn difference(gpu: &[Vec4], cpu: impl Fn(u32) -> Vec4) -> f64 {
    let largest = worst((0..COUNT).flat_map(|id| cpu(id).abs().to_array()));
    assert!(largest > 0.0);
    let differences = (0..COUNT).zip(gpu);
    worst(differences.flat_map(|(id, g)| (cpu(id) - *g).abs().to_array())) / largest
}

#[test]
fn a_nan_is_a_difference() {
    let mut gpu = vec![Vec4::ONE; COUNT as usize];
    assert_eq!(difference(&gpu, |_| Vec4::ONE), 0.0);
    gpu[7].y = f32::NAN;
    assert!(difference(&gpu, |_| Vec4::ONE).is_nan());
}

/// The uniforms of element `id`, as `value` draws them too.
fn words(id: u32) -> UVec2 {
    OwenSobol::new(7, 0, id, 0).next_uvec2()
}

#[test]
fn sampling() {
    let Some(context) = adapter_or_skip("exports") else {
        return;
    };
    let by_hand = "
fn value(id: u32) -> vec4<f32> {
    var source = owen_sobol(7u, 0u, id, 0u);
    let u = owen_sobol_next(&source);
    var stream = xoshiro_stream(7u, 1u, id);
    _ = xoshiro_next(&stream);
    return vec4(unit_pair(u), unit_float(xoshiro_next(&stream)), balance_heuristic(1u, f32(id), 2u, 30.0));
}";
    let gpu = run(
        &context,
        glimt_sampling::WGSL,
        by_hand,
        [&[0], &[0]],
        UVec2::ONE,
    );
    let cpu = |id: u32| {
        let mut stream = Xoshiro128PlusPlus::stream(7, 1, id);
        stream.next_u32();
        let last = glimt_sampling::unit_f32(stream.next_u32());
        unit_vec2(words(id))
            .extend(last)
            .extend(glimt_sampling::mis::balance_heuristic(
                1, id as f32, 2, 30.0,
            ))
    };
    let found = difference(&gpu, cpu);
    assert!(found <= 1e-6, "{found}");
    let wrong = difference(&gpu, |id| cpu(id + 1));
    assert!(!(wrong <= 1e-6), "another element's numbers pass");
}

/// Importance resampling and four picks from eight weights, in a shader of one's own.
#[test]
fn resampling() {
    let Some(context) = adapter_or_skip("exports") else {
        return;
    };
    let by_hand = "
fn value(id: u32) -> vec4<f32> {
    var weights: array<f32, 8>;
    var stream = xoshiro_stream(7u, 2u, id);
    var sum = ris_sum();
    for (var i = 0; i < 8; i++) {
        weights[i] = f32(xoshiro_next(&stream) >> 28u);
        ris_add(&sum, weights[i]);
    }
    var picks = ris_picks(sum, 3u, xoshiro_next(&stream));
    var comb = resample_comb(id % 3u, 4u, 0u, &stream);
    var taken = vec2(0u);
    for (var i = 0; i < 8; i++) {
        taken.x = taken.x * 4u + ris_take(&picks, weights[i]);
        taken.y = taken.y * 5u + resample_take(&comb, weights[i] / (8.0 * ris_normaliser(sum)) * 4.0, &stream);
    }
    let left = resample_finish(&comb, &stream);
    let cap = sample_cap(unit_pair(vec2(xoshiro_next(&stream), xoshiro_next(&stream))), 0.1);
    return vec4(vec2<f32>(taken), f32(left) + ris_normaliser(sum) + cap.direction.x, f32(ris_is_done(picks)));
}";
    let gpu = run(
        &context,
        glimt_sampling::WGSL,
        by_hand,
        [&[0], &[0]],
        UVec2::ONE,
    );
    let cpu = |id: u32| {
        let mut stream = Xoshiro128PlusPlus::stream(7, 2, id);
        let mut sum = RisSum::new();
        let weights: [f32; 8] = std::array::from_fn(|_| {
            let weight = (stream.next_u32() >> 28) as f32;
            sum.add(weight);
            weight
        });
        let mut picks = RisPicks::new(&sum, 3, stream.next_u32());
        let scheme = [Scheme::Systematic, Scheme::Stratified, Scheme::Multinomial][id as usize % 3];
        let mut comb = Comb::new(scheme, 4, 0, &mut stream);
        let mut taken = UVec2::ZERO;
        for weight in weights {
            let expected = weight / (8.0 * sum.normaliser()) * 4.0;
            taken.x = taken.x * 4 + picks.take(weight);
            taken.y = taken.y * 5 + comb.take(expected, &mut stream);
        }
        let left = comb.finish(&mut stream);
        let u = unit_vec2(stream.next_uvec2());
        let cap = glimt_sampling::warp::sample_cap(u, 0.1).direction;
        let done = f32::from(u8::from(picks.is_done()));
        taken
            .as_vec2()
            .extend(left as f32 + sum.normaliser() + cap.x)
            .extend(done)
    };
    let margin = |(id, gpu): (u32, &Vec4)| {
        let cpu = cpu(id);
        let picked_alike = cpu.x == gpu.x && cpu.y == gpu.y && cpu.w == gpu.w;
        !(picked_alike && (cpu.z - gpu.z).abs() <= 1e-4)
    };
    // A tooth that falls on the edge between two items may go to either.
    let differing = (0..COUNT).zip(&gpu).filter(|pair| margin(*pair)).count();
    assert!(
        differing * 1000 <= COUNT as usize,
        "{differing} of {COUNT} differ"
    );
    let wrong = (1..COUNT).zip(&gpu).filter(|pair| margin(*pair)).count();
    assert!(wrong * 2 > COUNT as usize, "another element's picks pass");
}

/// What the sampler's steps are made of, beside the generator of another crate.
#[test]
fn sequential_sampling() {
    let Some(context) = adapter_or_skip("exports") else {
        return;
    };
    let by_hand = "
fn value(id: u32) -> vec4<f32> {
    var stream = xoshiro_stream(7u, 3u, id);
    let u = unit_float(xoshiro_next(&stream));
    let ends = Endpoints(unit_float(xoshiro_next(&stream)), 2.0 * unit_float(xoshiro_next(&stream)));
    let bridge = Bridge(id % 2u, 3u);
    let density = smc_bridge_density(bridge, 1u + id % 4u, ends);
    let split = smc_split_word(xoshiro_next(&stream), 0.3);
    let weight = smc_particle_weight(Particle(vec3(0.0), -4.0 * u));
    let accepted = smc_accept(u, 0.5, 1.0, 0.25, 1.0);
    let flags = select(0u, 1u, split.first) + select(0u, 2u, accepted) + smc_bridge_steps(bridge) * 4u;
    return vec4(density, weight, f32(split.word >> 8u) / 16777216.0, f32(flags));
}";
    let both = format!("{}{}", glimt_sampling::WGSL, glimt_smc::WGSL);
    let gpu = run(&context, &both, by_hand, [&[0], &[0]], UVec2::ONE);
    let found = difference(&gpu, |id| {
        let mut stream = Xoshiro128PlusPlus::stream(7, 3, id);
        let u = glimt_sampling::unit_f32(stream.next_u32());
        let mut end = || glimt_sampling::unit_f32(stream.next_u32());
        let ends = Endpoints {
            previous: end(),
            current: 2.0 * end(),
        };
        let bridge = if id % 2 == 0 {
            Bridge::linear(3)
        } else {
            Bridge::geometric(3)
        };
        let split = glimt_smc::split_word(stream.next_u32(), 0.3);
        let particle = Particle {
            state: Vec3::ZERO,
            log_weight: -4.0 * u,
        };
        let accepted = glimt_smc::accept(u, 0.5, 1.0, 0.25, 1.0);
        let flags = u32::from(split.first) + 2 * u32::from(accepted) + 4 * bridge.steps();
        Vec4::new(
            bridge.density(1 + id % 4, ends),
            particle.weight(),
            glimt_sampling::unit_f32(split.word),
            flags as f32,
        )
    });
    // Relative to flags of up to 19; a flag that differs is 5 %.
    assert!(found <= 1e-4, "{found}");
}

#[test]
fn environment_tables() {
    let Some(context) = adapter_or_skip("exports") else {
        return;
    };
    let size = UVec2::new(32, 16);
    let mut texels = vec![Vec4::new(0.1, 0.2, 0.3, 0.0); 512];
    texels[5 * 32 + 9] = Vec4::new(900.0, 800.0, 500.0, 0.0);
    texels[3 * 32..4 * 32].fill(Vec4::ZERO);
    let prepared = EnvMap::new(size, texels).unwrap().prepare(0.0).unwrap();
    let cdf: EnvCdf<'_> = prepared.view().cdf();
    let by_hand = "
fn value(id: u32) -> vec4<f32> {
    // Any two words will do: what counts is that both processors get the same.
    let u = vec2(id * 2654435761u, id * 2246822519u);
    let s = env_sample(params.size, u);
    return vec4(s.direction, s.pdf_sr + env_pdf_sr(params.size, s.direction));
}";
    let cpu = |id: u32| {
        let u = UVec2::new(
            id.wrapping_mul(2_654_435_761),
            id.wrapping_mul(2_246_822_519),
        );
        let s = cdf.sample(u);
        s.direction.extend(s.pdf_sr + cdf.pdf_sr(s.direction))
    };
    // A buffer may be longer than its table: rounded up, or kept for larger maps. What it holds behind the table counts for
    // nothing.
    for (words, behind) in [(0, 0), (4096, 0), (4096, u32::MAX), (4096, 1 << 29)] {
        let padded = |table: &[u32]| {
            let mut padded = table.to_vec();
            padded.resize(table.len().max(words), behind);
            padded
        };
        let rows = &cdf.marginal[..=size.y as usize];
        let [marginal, conditional] = [rows, cdf.conditional].map(padded);
        let tables = [marginal.as_slice(), &conditional];
        let gpu = run(&context, glimt_envmap_cdf::WGSL, by_hand, tables, size);
        let found = difference(&gpu, cpu);
        assert!(found <= 1e-5, "{words} words, {behind} behind: {found}");
    }
}

#[test]
fn reflection() {
    let Some(context) = adapter_or_skip("exports") else {
        return;
    };
    let by_hand = "
fn value(id: u32) -> vec4<f32> {
    let f = f32(id) / 10000.0;
    let wo = normalize(vec3(f, 0.2, 1.0 - 0.5 * f));
    let wi = normalize(vec3(-f, -0.1, 1.0));
    let model = BlinnPhong(vec3(0.3, 0.2, 0.1), vec3(0.4), 50.0);
    return vec4(blinn_phong_eval(model, wo, wi), blinn_phong_pdf_sr(model, wo, wi));
}";
    let gpu = run(
        &context,
        glimt_brdf::WGSL,
        by_hand,
        [&[0], &[0]],
        UVec2::ONE,
    );
    let model = BlinnPhong::new(Vec3::new(0.3, 0.2, 0.1), Vec3::splat(0.4), 50.0).unwrap();
    let found = difference(&gpu, |id| {
        let f = id as f32 / 10_000.0;
        let wo = Vec3::new(f, 0.2, 1.0 - 0.5 * f).normalize();
        let wi = Vec3::new(-f, -0.1, 1.0).normalize();
        model.eval(wo, wi).extend(model.pdf_sr(wo, wi))
    });
    // A software adapter's powers are off by as much.
    assert!(found <= 3e-3, "{found}");
}

#[test]
fn mappings() {
    let Some(context) = adapter_or_skip("exports") else {
        return;
    };
    let by_hand = "
fn value(id: u32) -> vec4<f32> {
    let uv = vec2(f32(id % 100u) + 0.5, f32(id / 100u) + 0.5) / 100.0;
    let d = lat_long_direction(uv);
    return vec4(d, lat_long_uv(d).x + 10.0 * lat_long_texel_solid_angle_sr(id % 50u, vec2(100u, 50u)));
}";
    let gpu = run(
        &context,
        glimt_probe::WGSL,
        by_hand,
        [&[0], &[0]],
        UVec2::ONE,
    );
    let found = difference(&gpu, |id| {
        let uv = Vec2::new((id % 100) as f32 + 0.5, (id / 100) as f32 + 0.5) / 100.0;
        let d = latlong::uv_to_direction(uv);
        let area = latlong::texel_solid_angle_sr(id % 50, UVec2::new(100, 50));
        d.extend(latlong::direction_to_uv(d).x + 10.0 * area)
    });
    assert!(found <= 1e-5, "{found}");
}

#[test]
fn harmonics() {
    let Some(context) = adapter_or_skip("exports") else {
        return;
    };
    let by_hand = "
fn value(id: u32) -> vec4<f32> {
    let d = sh_stratified_direction(id, vec2(100u, 100u), vec2(0.5));
    let k = id % 36u;
    let y = sh_basis(d);
    var sums = array<f32, 36>();
    sh_add_basis(id % 7u, d, 2.0, &sums);
    let turned = sh_rotate_z(sh_coefficient_order(k), y[k], 0.5, vec2(0.6, 0.8));
    return vec4(y[k], sums[k], sh_temporal_filter(turned, 1.0, 0.5), sh_hann(sh_coefficient_band(k), 5.0) * sh_cosine_lobe(k % 6u));
}";
    let gpu = run(&context, glimt_sh::WGSL, by_hand, [&[0], &[0]], UVec2::ONE);
    let cpu = |id: u32| {
        let d = glimt_sh::stratified_direction(id, UVec2::splat(100), Vec2::splat(0.5));
        let k = id % 36;
        let y = glimt_sh::basis(d);
        let mut sums = [0.0; 36];
        glimt_sh::add_basis(id % 7, d, 2.0, &mut sums);
        let order = glimt_sh::coefficient_order(k);
        let turned = glimt_sh::rotate_z(order, y[k as usize], 0.5, Vec2::new(0.6, 0.8));
        let window = glimt_sh::hann(glimt_sh::coefficient_band(k), 5.0);
        Vec4::new(
            y[k as usize],
            sums[k as usize],
            glimt_sh::temporal_filter(turned, 1.0, 0.5),
            window * glimt_sh::cosine_lobe(k % 6),
        )
    };
    let found = difference(&gpu, cpu);
    assert!(found <= 1e-6, "{found}");
    let wrong = difference(&gpu, |id| cpu(id + 1));
    assert!(!(wrong <= 1e-6), "another element's numbers pass");
}

/// The functions and structs of a text: each with its name, its text, and for a function the line of Rust that it was made of.
fn items(text: &str) -> Vec<(&str, String, &str)> {
    let (mut items, mut before, mut lines) = (Vec::new(), "", text.lines());
    while let Some(line) = lines.next() {
        let head = line.strip_prefix("fn ").or(line.strip_prefix("struct "));
        if let Some(head) = head {
            let name = head.split(['(', ' ']).next().unwrap();
            let body = lines.by_ref().take_while(|line| *line != "}");
            let mut item: String = [line]
                .into_iter()
                .chain(body)
                .collect::<Vec<_>>()
                .join("\n");
            item += "\n}\n";
            items.push((name, item, before));
        }
        before = line;
    }
    items
}

/// A text without those of its items.
fn without(text: &str, names: &[&str]) -> String {
    let left_out = items(text)
        .into_iter()
        .filter(|item| names.contains(&item.0));
    left_out.fold(text.to_owned(), |text, item| text.replacen(&item.1, "", 1))
}

/// What the crates say beside their WGSL: which names stand in several, and that one copy of each will do.
#[test]
fn several_together() {
    let all = [
        ("brdf", glimt_brdf::WGSL),
        ("envmap_cdf", glimt_envmap_cdf::WGSL),
        ("probe", glimt_probe::WGSL),
        ("sampling", glimt_sampling::WGSL),
        ("sh", glimt_sh::WGSL),
        ("smc", glimt_smc::WGSL),
    ];
    let mut owners: BTreeMap<String, (String, Vec<&str>)> = BTreeMap::new();
    for (krate, text) in all {
        for (name, item, origin) in items(text) {
            // Names of locals may differ; the line of Rust may not.
            let same = if origin.is_empty() {
                item
            } else {
                origin.to_owned()
            };
            let (first, crates) = owners
                .entry(name.to_owned())
                .or_insert((same.clone(), vec![]));
            crates.push(krate);
            assert_eq!(*first, same, "{name}");
        }
    }
    owners.retain(|_, (_, crates)| crates.len() > 1);
    let shared = owners.iter();
    let shared: Vec<_> = shared
        .map(|(name, (_, crates))| format!("{name}: {}", crates.join(", ")))
        .collect();
    let documented = [
        "DirectionSample: brdf, sampling, sh",
        "cos_sin_pi: envmap_cdf, probe",
        "cos_sin_turns: brdf, sampling, sh",
        "hash2_: envmap_cdf, sampling",
        "hash_u32_: envmap_cdf, sampling",
        "sample_cap: sampling, sh",
    ];
    assert_eq!(shared, documented);
    let Some(context) = adapter_or_skip("exports") else {
        return;
    };
    let three = [
        glimt_brdf::WGSL,
        &without(glimt_sampling::WGSL, &["DirectionSample", "cos_sin_turns"]),
        &without(
            glimt_sh::WGSL,
            &["DirectionSample", "cos_sin_turns", "sample_cap"],
        ),
    ];
    let by_hand = "
fn value(id: u32) -> vec4<f32> {
    let u = unit_pair(vec2(id * 2654435761u, id * 2246822519u));
    let d = sample_cap(u, 2.0).direction;
    let lobe = lambert_eval(Lambert(vec3(0.5)), d, d);
    return vec4(d.x, sh_basis(d)[3], sh_stratified_direction(id, vec2(10u, 10u), u).z, lobe.x);
}";
    let gpu = run(&context, &three.concat(), by_hand, [&[0], &[0]], UVec2::ONE);
    let found = difference(&gpu, |id| {
        let word = |factor: u32| id.wrapping_mul(factor);
        let u = unit_vec2(UVec2::new(word(2_654_435_761), word(2_246_822_519)));
        let d = glimt_sampling::warp::sample_cap(u, 2.0).direction;
        let z = glimt_sh::stratified_direction(id, UVec2::splat(10), u).z;
        let lobe = Lambert::new(Vec3::splat(0.5)).unwrap().eval(d, d);
        Vec4::new(d.x, glimt_sh::basis(d)[3], z, lobe.x)
    });
    assert!(found <= 1e-5, "{found}");
}
