//! Host file: product sampling by cells: its density against what it draws and against sums over all texels, and its mean against
//! quadrature.

use glam::{UVec2, UVec3, Vec3, Vec4};
use glimt_brdf::BlinnPhong;
use glimt_render_gpu::kernels::environment::Environment;
use glimt_render_gpu::kernels::product::{
    CELLS, CellLobe, Product, cell_of, pmf_in_cell, sample_in_cell,
};
use glimt_render_gpu::kernels::scene::ShadingPoint;
use glimt_render_gpu::methods;
use glimt_render_gpu::prepare::env::{EnvMap, PreparedEnv};
use glimt_render_gpu::prepare::render::{Pattern, RenderSettings};
use glimt_sampling::math::ShadingFrame;
use glimt_sampling::uniform::UniformSource;
use glimt_sampling::xoshiro::Xoshiro128PlusPlus;
use glimt_statistics::stats::{Verdict, chi_square, sidak};
use glimt_tests::unbiased::{Case, assert_unbiased, scene, settings};

/// Maps: an uneven one with a sun, a constant one, suns at a pole and at the seam, tiny ones, one with black rows.
fn maps() -> Vec<(&'static str, PreparedEnv)> {
    let map = |name, (x, y): (u32, u32), texel: &dyn Fn(u32, u32) -> f32, turn: f32| {
        let texels = (0..y).flat_map(|row| (0..x).map(move |column| (column, row)));
        let texels = texels.map(|(column, row)| Vec4::splat(texel(column, row)));
        let env = EnvMap::new(UVec2::new(x, y), texels.collect()).unwrap();
        (name, env.prepare(turn).unwrap())
    };
    vec![
        map(
            "uneven",
            (100, 50),
            &|x, y| {
                if (x, y) == (71, 11) {
                    900.0
                } else {
                    0.2 + ((x * 7 + y * 3) % 11) as f32
                }
            },
            35.0,
        ),
        map("constant", (64, 32), &|_, _| 2.0, 0.0),
        map(
            "pole",
            (64, 32),
            &|x, y| if (x, y) == (0, 0) { 5.0 } else { 0.0 },
            10.0,
        ),
        map(
            "seam",
            (64, 32),
            &|x, y| if (x, y) == (63, 16) { 1e6 } else { 1.0 },
            0.0,
        ),
        map("one texel", (1, 1), &|_, _| 3.0, 0.0),
        map("six texels", (3, 2), &|x, y| (x + 2 * y) as f32, 0.0),
        map(
            "half black",
            (48, 24),
            &|x, y| if y < 12 { (1 + x % 5) as f32 } else { 0.0 },
            0.0,
        ),
        map("black", (8, 4), &|_, _| 0.0, 0.0),
    ]
}

/// Points that look up, sideways and askew, matt, glossy and nearly mirroring.
fn points() -> Vec<ShadingPoint> {
    let point = |normal: Vec3, wo: Vec3, diffuse: f32, exponent: f32| {
        let frame = ShadingFrame::from_normal(normal.normalize());
        ShadingPoint {
            origin: Vec3::ZERO,
            geometric_normal: frame.n,
            frame,
            wo: wo.normalize(),
            brdf: BlinnPhong {
                diffuse: Vec3::splat(diffuse),
                specular: Vec3::splat(0.9 - diffuse),
                exponent,
            },
            emission: Vec3::ZERO,
        }
    };
    vec![
        point(Vec3::Z, Vec3::Z, 0.9, 0.0),
        point(
            Vec3::new(1.0, 0.2, 0.1),
            Vec3::new(0.5, -0.3, 0.6),
            0.3,
            50.0,
        ),
        point(
            Vec3::new(-0.3, 0.7, -0.4),
            Vec3::new(-0.8, 0.1, 0.3),
            0.05,
            2000.0,
        ),
    ]
}

const PRODUCT: Product = Product {
    brdf_samples: 1,
    env_samples: 1,
};

fn texels(env: Environment<'_>) -> impl Iterator<Item = UVec2> {
    let size = env.size;
    (0..size.x * size.y).map(move |i| UVec2::new(i % size.x, i / size.x))
}

#[test]
fn within_a_cell_probabilities_are_of_the_light_and_sum_to_one() {
    for (name, env) in maps() {
        let env = env.view();
        let mut sums = vec![0.0; CELLS as usize];
        for texel in texels(env) {
            let pmf = f64::from(pmf_in_cell(texel, cell_of(texel, env), env));
            assert_eq!(pmf > 0.0, env.radiance(texel).x > 0.0, "{name} {texel}");
            sums[cell_of(texel, env) as usize] += pmf;
        }
        for (cell, sum) in sums.iter().enumerate() {
            assert!(
                *sum == 0.0 || (sum - 1.0).abs() < 1e-5,
                "{name}, cell {cell}: {sum}"
            );
        }
        let is_black = env.texels.iter().all(|t| t.x == 0.0);
        assert_eq!(sums.iter().all(|sum| *sum == 0.0), is_black, "{name}");
    }
}

#[test]
fn densities_integrate_to_one() {
    for (name, env) in maps() {
        let env = env.view();
        for (number, point) in points().iter().enumerate() {
            let lobe = CellLobe::new(point, env);
            let total = PRODUCT.total(&lobe, env);
            let mass = |texel: UVec2| {
                let area = glimt_probe::latlong::texel_solid_angle_sr(texel.y, env.size);
                f64::from(PRODUCT.pdf_sr(texel, total, &lobe, env) * area)
            };
            let sum: f64 = texels(env).map(mass).sum();
            let wanted = if total > 0.0 { 1.0 } else { 0.0 };
            assert!((sum - wanted).abs() < 1e-4, "{name}, point {number}: {sum}");
        }
    }
}

/// What is drawn, held against a density.
fn judge(
    env: Environment<'_>,
    point: &ShadingPoint,
    pdf: impl Fn(UVec2, f32, &CellLobe) -> f32,
    alpha: f64,
) -> Verdict {
    const DRAWS: u32 = 200_000;
    let lobe = CellLobe::new(point, env);
    let total = PRODUCT.total(&lobe, env);
    let mut counts = vec![0; (env.size.x * env.size.y) as usize];
    let mut random = Xoshiro128PlusPlus::stream(5, 1, 2);
    for _ in 0..DRAWS {
        let pair = random.next_uvec2();
        let u = UVec3::new(pair.x, pair.y, random.next_u32());
        let drawn = PRODUCT.sample(u, total, &lobe, env);
        let area = glimt_probe::latlong::texel_solid_angle_sr(drawn.texel.y, env.size);
        let told = PRODUCT.pdf_sr(drawn.texel, total, &lobe, env) * area;
        assert!(
            (drawn.pmf - told).abs() <= 1e-4 * told,
            "{} {told}",
            drawn.pmf
        );
        counts[(drawn.texel.y * env.size.x + drawn.texel.x) as usize] += 1;
    }
    let expected: Vec<f64> = texels(env)
        .map(|texel| {
            let area = glimt_probe::latlong::texel_solid_angle_sr(texel.y, env.size);
            f64::from(pdf(texel, total, &lobe) * area) * f64::from(DRAWS)
        })
        .collect();
    chi_square(&counts, &expected, alpha)
}

#[test]
fn texels_are_drawn_by_their_density() {
    let cases: Vec<_> = maps();
    let alpha = sidak(0.01, 3 * cases.len());
    for (name, env) in &cases {
        let env = env.view();
        for (number, point) in points().iter().enumerate() {
            let lobe = CellLobe::new(point, env);
            if PRODUCT.total(&lobe, env) > 0.0 {
                let verdict = judge(
                    env,
                    point,
                    |texel, total, lobe| PRODUCT.pdf_sr(texel, total, lobe, env),
                    alpha,
                );
                verdict.unwrap_or_else(|why| panic!("{name}, point {number}: {why}"));
            }
        }
    }
}

/// The test above can fail: a density that takes another point's lobe, or forgets the cells, is noticed.
#[test]
fn wrong_densities_are_noticed() {
    let cases = maps();
    let env = cases[0].1.view();
    let points = points();
    let other = CellLobe::new(&points[0], env);
    let other_total = PRODUCT.total(&other, env);
    let wrong = judge(
        env,
        &points[1],
        |texel, _, _| PRODUCT.pdf_sr(texel, other_total, &other, env),
        0.01,
    );
    assert!(wrong.is_err());
    let by_light = |texel: UVec2, _: f32, _: &CellLobe| env.cdf().texel_pdf_sr(texel);
    assert!(judge(env, &points[1], by_light, 0.01).is_err());
}

#[test]
fn a_texel_is_one_of_its_cell() {
    for (name, env) in maps() {
        let env = env.view();
        let mut random = Xoshiro128PlusPlus::stream(9, 9, 9);
        for texel in
            texels(env).filter(|texel| pmf_in_cell(*texel, cell_of(*texel, env), env) > 0.0)
        {
            let cell = cell_of(texel, env);
            for u in [UVec2::ZERO, UVec2::MAX, random.next_uvec2()] {
                let drawn = sample_in_cell(cell, u, env);
                assert_eq!(cell_of(drawn.texel, env), cell, "{name}");
                assert_eq!(drawn.pmf, pmf_in_cell(drawn.texel, cell, env), "{name}");
            }
        }
    }
}

#[test]
fn means_are_the_integral() {
    let case = |name, rays, [brdf_samples, env_samples]: [u32; 2], pattern| Case {
        name,
        settings: RenderSettings {
            method: methods::Product {
                brdf_samples,
                env_samples,
            }
            .into(),
            ..settings(rays, pattern)
        },
    };
    for material in [
        scene(0.8, 0.0, 1.0),
        scene(0.3, 0.6, 50.0),
        scene(0.1, 0.9, 500.0),
    ] {
        let cases = [
            case("Owen-Sobol 1 + 1", 4, [1, 1], Pattern::OwenSobol),
            case("independent 1 + 3", 2, [1, 3], Pattern::Independent),
            case("stratified 2 + 1", 2, [2, 1], Pattern::Stratified),
            case("of the BRDF alone", 8, [1, 0], Pattern::OwenSobol),
        ];
        assert_unbiased(&material, 50.0, &cases[..3]);
        if material.exponent < 100.0 {
            assert_unbiased(&material, 5.0, &cases[3..]);
        }
    }
}
