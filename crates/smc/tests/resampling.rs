//! Host file: a set of particles is resampled by the picks of the four schemes.

use glam::Vec3;
use glimt_sampling::resample::{Scheme, ancestors_into};
use glimt_sampling::{UniformSource, Xoshiro128PlusPlus};
use glimt_smc::{LOG_ZERO, Particle, resample::resample, weights::normalise};

const SCHEMES: [Scheme; 4] = [
    Scheme::Systematic,
    Scheme::Stratified,
    Scheme::Multinomial,
    Scheme::Residual,
];

/// How often each item is picked.
fn copies<U: UniformSource>(scheme: Scheme, weights: &[f32], n: usize, source: &mut U) -> Vec<u32> {
    let mut ancestors = vec![u32::MAX; n];
    assert!(ancestors_into(scheme, weights, &mut ancestors, source));
    let mut copies = vec![0; weights.len()];
    for a in ancestors {
        copies[a as usize] += 1;
    }
    copies
}

/// In a set of particles the same items are picked, equally often, from the same stream; and survivors stay in their places.
#[test]
fn a_set_is_resampled_as_a_list_of_ancestors_is() {
    for scheme in SCHEMES {
        let (mut checked, mut dying) = (0, 0);
        for key in 0..5000u32 {
            let mut source = Xoshiro128PlusPlus::stream(6, 0, key);
            let n = 1 + (key % 13) as usize;
            let mut set: Vec<Particle> = (0..n)
                .map(|i| {
                    let word = source.next_u32();
                    let log_weight = if word & 3 == 0 {
                        LOG_ZERO
                    } else {
                        5.0 * (word >> 8) as f32 / 16_777_216.0
                    };
                    Particle {
                        state: Vec3::splat(i as f32),
                        log_weight,
                    }
                })
                .collect();
            if normalise(&mut set) == LOG_ZERO {
                continue;
            }
            let weights: Vec<f32> = set.iter().map(Particle::weight).collect();
            let mut twin = source;
            let picked = copies(scheme, &weights, n, &mut twin);
            resample(scheme, &mut set, &mut source);
            assert_eq!(
                source, twin,
                "{scheme:?} {key}: the streams are out of step"
            );
            let mut found = vec![0; n];
            for (i, particle) in set.iter().enumerate() {
                let ancestor = particle.state.x as usize;
                found[ancestor] += 1;
                assert!(
                    picked[i] == 0 || ancestor == i,
                    "{scheme:?} {key}: {i} has moved"
                );
                assert!((particle.weight() * n as f32 - 1.0).abs() < 1e-5);
            }
            assert_eq!(found, picked, "{scheme:?} {key}: {weights:?}");
            checked += 1;
            dying += picked.iter().filter(|c| **c == 0).count();
        }
        assert!(checked > 4000 && dying > 4000);
    }
}
