//! Host file: the generator and the sample pattern of `glimt-sampling`.

use glam::{UVec2, UVec4, Vec2};
use glimt_sampling::hash::{hash_u32, hash_uvec4, hash2, hash3};
use glimt_sampling::sobol::{owen_sobol, sobol_reversed};
use glimt_sampling::{OwenSobol, UniformSource, Xoshiro128PlusPlus, unit_f32, unit_vec2};
use glimt_statistics::stats::{Mean, chi_square, kolmogorov_smirnov, sidak, z_test};

/// Level of all statistical tests of this file together.
const ALPHA: f64 = 0.01;
/// No fewer than there are.
const TESTS: usize = 40;

fn alpha() -> f64 {
    sidak(ALPHA, TESTS)
}

fn generator(key: u32) -> Xoshiro128PlusPlus {
    Xoshiro128PlusPlus::stream(2026, 0, key)
}

// --- Generators ---

#[test]
fn xoshiro_equals_rand_xoshiro() {
    use rand_core::{Rng, SeedableRng};
    for seed in 0..500u64 {
        let seed = seed * 0x1234_5678_9abc_def1;
        let mut ours = Xoshiro128PlusPlus::seed_from_u64(seed);
        let mut theirs = rand_xoshiro::Xoshiro128PlusPlus::seed_from_u64(seed);
        for step in 0..1000 {
            assert_eq!(
                UniformSource::next_u32(&mut ours),
                theirs.next_u32(),
                "seed {seed}, step {step}"
            );
        }
    }
}

#[test]
fn rand_core_traits_equal_those_of_rand_xoshiro() {
    use rand_core::{Rng, SeedableRng};
    let mut seeds = vec![[0u8; 16], [255; 16]];
    for i in 0..100u8 {
        seeds.push(core::array::from_fn(|k| {
            i.wrapping_mul(37).wrapping_add(k as u8).wrapping_mul(i | 1)
        }));
    }
    for seed in seeds {
        let mut ours = Xoshiro128PlusPlus::from_seed(seed);
        let mut theirs = rand_xoshiro::Xoshiro128PlusPlus::from_seed(seed);
        for length in 0..40 {
            assert_eq!(Rng::next_u64(&mut ours), theirs.next_u64());
            assert_eq!(Rng::next_u32(&mut ours), theirs.next_u32());
            let (mut a, mut b) = (vec![0u8; length], vec![0u8; length]);
            ours.fill_bytes(&mut a);
            theirs.fill_bytes(&mut b);
            assert_eq!(a, b);
        }
    }
}

#[test]
fn streams_start_in_different_states() {
    let mut states = std::collections::HashSet::new();
    for seed in [0, 1, 2, u32::MAX] {
        for frame in 0..16 {
            for pixel in 0..4096 {
                assert!(states.insert(Xoshiro128PlusPlus::stream(seed, frame, pixel).state));
            }
        }
    }
}

/// First draws of neighbouring streams, and pairs of them, look like draws of one good generator.
#[test]
fn neighbouring_streams_are_independent() {
    const N: u32 = 1 << 18;
    let first =
        |frame: u32, pixel: u32| Xoshiro128PlusPlus::stream(1, frame, pixel).next_u32() >> 27;
    let mut pairs = [vec![0u64; 1024], vec![0u64; 1024]];
    for pixel in 0..N {
        let here = first(0, pixel);
        pairs[0][(here * 32 + first(0, pixel + 1)) as usize] += 1;
        pairs[1][(here * 32 + first(1, pixel)) as usize] += 1;
    }
    // Consecutive pairs share a draw, which leaves their counts' expectation and, on 1024 cells, their spread.
    let expected = vec![f64::from(N) / 1024.0; 1024];
    for counts in &pairs {
        chi_square(counts, &expected, alpha()).unwrap();
    }
}

/// Flipping any bit of the input flips every bit of the output about half of the time.
#[test]
fn hashes_avalanche() {
    const N: u32 = 1 << 14;
    let mut source = generator(1);
    let inputs: Vec<UVec4> = (0..N)
        .map(|_| UVec4::from_array([(); 4].map(|()| source.next_u32())))
        .collect();
    type Hash = fn(UVec4) -> u32;
    // Name, function, and how many of the four words it reads.
    let hashes: [(&str, Hash, usize); 7] = [
        ("hash_u32", |v| hash_u32(v.x), 1),
        ("hash2", |v| hash2(v.x, v.y), 2),
        ("hash3", |v| hash3(v.x, v.y, v.z), 3),
        ("hash_uvec4.x", |v| hash_uvec4(v).x, 4),
        ("hash_uvec4.y", |v| hash_uvec4(v).y, 4),
        ("hash_uvec4.z", |v| hash_uvec4(v).z, 4),
        ("hash_uvec4.w", |v| hash_uvec4(v).w, 4),
    ];
    for (name, hash, words) in hashes {
        for bit_in in 0..32 * words {
            let mut flips = [0u32; 32];
            for input in &inputs {
                let mut changed = *input;
                changed[bit_in / 32] ^= 1 << (bit_in % 32);
                let difference = hash(*input) ^ hash(changed);
                for (bit, count) in flips.iter_mut().enumerate() {
                    *count += (difference >> bit) & 1;
                }
            }
            for (bit_out, count) in flips.into_iter().enumerate() {
                let rate = f64::from(count) / f64::from(N);
                assert!(
                    (rate - 0.5).abs() <= 0.03,
                    "{name}: {bit_in} → {bit_out} flips at {rate}"
                );
            }
        }
    }
}

#[test]
fn unit_floats_stay_below_one() {
    assert_eq!(unit_f32(u32::MAX), 1.0 - f32::EPSILON / 2.0);
    assert_eq!(unit_f32(255), 0.0);
    assert_eq!(unit_f32(256), f32::EPSILON / 2.0);
    assert_eq!(
        unit_vec2(UVec2::new(1 << 31, 1 << 30)),
        Vec2::new(0.5, 0.25)
    );
}

// --- Sobol ---

#[test]
fn owen_sobol_equals_sobol_burley() {
    let seeds = (0..64)
        .chain((0..64).map(|i| hash_u32(i) | 1))
        .chain([u32::MAX]);
    for seed in seeds {
        for index in (0..600).chain((0..65_536).step_by(251)).chain([65_535]) {
            for dimension in 0..4 {
                // Their float is an exact multiple of 2⁻²³.
                let theirs = sobol_burley::sample(index, dimension, seed) * 8_388_608.0;
                assert_eq!(
                    owen_sobol(index, dimension, seed) >> 9,
                    theirs as u32,
                    "index {index}, dimension {dimension}, seed {seed}"
                );
            }
        }
    }
}

#[test]
fn sobol_before_scrambling_equals_sobol_burley() {
    for index in 0..65_536u32 {
        for dimension in 0..4 {
            let theirs = sobol_burley::parts::sobol_rev(index.reverse_bits(), dimension);
            assert_eq!(sobol_reversed(index, dimension), theirs);
        }
    }
}

#[test]
fn pattern_draws_are_padded_sets() {
    for index in [0, 1, 77, 65_535, 65_536, 200_000] {
        let seed = hash2(hash3(5, 6, 7), index >> 16);
        let expected = |d: u32| owen_sobol(index & 0xffff, d & 3, hash2(seed, d >> 2));
        let mut singles = OwenSobol::new(5, 6, 7, index);
        let mut pairs = OwenSobol::new(5, 6, 7, index);
        for d in (0..40).step_by(2) {
            assert_eq!(singles.next_u32(), expected(d));
            assert_eq!(singles.next_u32(), expected(d + 1));
            assert_eq!(pairs.next_uvec2(), UVec2::new(expected(d), expected(d + 1)));
        }
        // A single draw before a pair costs the pair its partner's place, not its stratification.
        let mut mixed = OwenSobol::new(5, 6, 7, index);
        assert_eq!(mixed.next_u32(), expected(0));
        assert_eq!(mixed.next_uvec2(), UVec2::new(expected(2), expected(3)));
        assert_eq!(mixed.next_u32(), expected(4));
        assert_eq!(mixed.next_uvec2(), UVec2::new(expected(6), expected(7)));
    }
}

/// The smallest `t` for which the 2ᵐ points are a (t, m, 2)-net in base 2: every elementary interval of area 2ᵗ⁻ᵐ holds
/// 2ᵗ of them.
fn net_quality(points: &[UVec2]) -> u32 {
    let m = points.len().trailing_zeros();
    let is_net = |t: u32| {
        (0..=m - t).all(|across| {
            let down = m - t - across;
            let mut counts = vec![0u32; 1 << (m - t)];
            for p in points {
                let column = (u64::from(p.x) << across) >> 32;
                let row = (u64::from(p.y) << down) >> 32;
                counts[(row << across | column) as usize] += 1;
            }
            counts.iter().all(|count| *count == 1 << t)
        })
    };
    (0..=m).find(|t| is_net(*t)).unwrap_or(m)
}

#[test]
fn pairs_of_dimensions_are_nets() {
    for key in 0..40 {
        for set in 0..3 {
            for m in 0..=10u32 {
                let mut pairs = [Vec::new(), Vec::new()];
                for index in 0..1 << m {
                    let mut point = OwenSobol::new(3, key, key * 977, index);
                    for _ in 0..2 * set {
                        point.next_uvec2();
                    }
                    pairs[0].push(point.next_uvec2());
                    pairs[1].push(point.next_uvec2());
                }
                assert_eq!(
                    net_quality(&pairs[0]),
                    0,
                    "dimensions 0 and 1, 2^{m} points"
                );
                // Joe and Kuo's third and fourth dimensions: perfect at 1, 2 and 16 points, within a factor 4 always.
                let t = net_quality(&pairs[1]);
                assert!(
                    t <= if m == 4 { 0 } else { 2 },
                    "dimensions 2 and 3, 2^{m} points: t = {t}"
                );
            }
        }
    }
}

/// Independent generators are no nets: the test above can fail.
#[test]
fn random_points_are_no_net() {
    let mut source = generator(2);
    let points: Vec<UVec2> = (0..256).map(|_| source.next_uvec2()).collect();
    assert!(net_quality(&points) > 2);
}

/// Over scramblings each point is uniform, in one dimension and in two, also across sets.
#[test]
fn scrambled_points_are_uniform() {
    const N: u32 = 1 << 16;
    for index in [0, 1, 6, 15] {
        let mut pairs = vec![vec![0u64; 256]; 3];
        for pixel in 0..N {
            let mut point = OwenSobol::new(9, 2, pixel, index);
            let draws = [(); 6].map(|()| point.next_u32() >> 28);
            for (counts, (a, b)) in pairs.iter_mut().zip([(0, 1), (2, 3), (1, 4)]) {
                counts[(draws[a] * 16 + draws[b]) as usize] += 1;
            }
        }
        for counts in &pairs {
            chi_square(counts, &vec![f64::from(N) / 256.0; 256], alpha()).unwrap();
        }
        let mut last: Vec<f64> = (0..N)
            .map(|frame| f64::from(OwenSobol::new(1, frame, 3, index).next_u32()) / 4_294_967_296.0)
            .collect();
        kolmogorov_smirnov(&mut last, |x| x, alpha()).unwrap();
    }
}

/// The mean over scramblings is the integral, and sixteen scrambled points know it better than sixteen random ones.
#[test]
fn pattern_is_unbiased_and_stratified() {
    // A disc, a smooth product over two sets, a ridge across a pair.
    type Integrand = fn([Vec2; 3]) -> f64;
    let integrands: [(Integrand, f64); 3] = [
        (
            |u| f64::from(u8::from(u[0].length_squared() < 1.0)),
            std::f64::consts::FRAC_PI_4,
        ),
        (|u| f64::from(u[0].x * u[1].y * u[2].x) * 8.0, 1.0),
        (|u| (f64::from(u[1].x + u[1].y) - 1.0).abs(), 1.0 / 3.0),
    ];
    for (f, integral) in integrands {
        let estimate = |draw: &mut dyn FnMut(u32, u32) -> [Vec2; 3]| {
            Mean::of((0..4096).map(|pixel| (0..16).map(|i| f(draw(pixel, i))).sum::<f64>() / 16.0))
        };
        let pattern = estimate(&mut |pixel, i| {
            let mut point = OwenSobol::new(1, 0, pixel, i);
            [(); 3].map(|()| unit_vec2(point.next_uvec2()))
        });
        let mut source = generator(3);
        let random = estimate(&mut |_, _| [(); 3].map(|()| unit_vec2(source.next_uvec2())));
        z_test(pattern, integral, alpha()).unwrap();
        z_test(random, integral, alpha()).unwrap();
        let gain = (random.standard_error / pattern.standard_error).powi(2);
        println!("variance of 16 random points over that of 16 scrambled ones: {gain:.1}");
        assert!(gain > 2.0);
    }
}
