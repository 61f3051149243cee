//! Shared file: resampling of a set in its place.

use glimt_sampling::resample::{Comb, Scheme, sure_copies};
use glimt_sampling::uniform::UniformSource;

use crate::particle::{Particle, is_log_zero};
use crate::weights::make_equal;

/// Picks N of the N particles in proportion to their normalised weights, and gives each the weight 1/N.
///
/// A particle that is picked stays in its place; further copies of it go to the places of those that are not. A particle of weight
/// 0 is never picked. Draws [`words`](glimt_sampling::resample::words) words.
///
/// No room is needed beside the set: while it is resampled, the place of a weight holds the number of copies.
#[inline]
pub fn resample<U: UniformSource>(scheme: Scheme, particles: &mut [Particle], source: &mut U) {
    let n = particles.len();
    let scale = n as f32;
    let mut sure = 0;
    for i in 0..n {
        sure += sure_copies(scheme, particles[i].weight() * scale);
    }
    let mut comb = Comb::new(scheme, n as u32, sure, source);
    let mut last = n;
    let mut picks = 0;
    for i in 0..n {
        let possible = !is_log_zero(particles[i].log_weight);
        let copies = comb.take(particles[i].weight() * scale, source);
        particles[i].log_weight = copies as f32;
        picks += copies;
        if possible {
            last = i;
        }
    }
    let _ = comb.finish(source);
    if last < n {
        particles[last].log_weight += (n as u32).saturating_sub(picks) as f32;
        spread(particles);
    }
    make_equal(particles);
}

/// Copies states from places with copies to spare to those without any. The numbers of copies sum to N.
#[inline]
fn spread(particles: &mut [Particle]) {
    let n = particles.len();
    let mut donor = 0;
    for i in 0..n {
        if particles[i].log_weight == 0.0 {
            while donor < n && particles[donor].log_weight < 2.0 {
                donor += 1;
            }
            if donor == n {
                return;
            }
            particles[donor].log_weight -= 1.0;
            particles[i].state = particles[donor].state;
            particles[i].log_weight = 1.0;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::particle::LOG_ZERO;
    use glam::Vec3;
    use glimt_sampling::Xoshiro128PlusPlus;

    #[test]
    fn survivors_stay_and_their_copies_fill_the_gaps() {
        let weights = [0.0, 0.5, 0.0, 0.125, 0.375, 0.0, 0.0, 0.0f32];
        let log = |w: f32| if w > 0.0 { w.ln() } else { LOG_ZERO };
        let mut set: [Particle; 8] = core::array::from_fn(|i| Particle {
            state: Vec3::splat(i as f32),
            log_weight: log(weights[i]),
        });
        let mut source = Xoshiro128PlusPlus::stream(1, 2, 3);
        resample(Scheme::Systematic, &mut set, &mut source);
        let states = set.map(|p| p.state.x as u32);
        assert_eq!((states[1], states[3], states[4]), (1, 3, 4));
        let copies = |of| states.iter().filter(|s| **s == of).count();
        assert_eq!((copies(1), copies(3), copies(4)), (4, 1, 3));
        assert!(set.iter().all(|p| (p.weight() - 0.125).abs() < 1e-6));
    }
}
