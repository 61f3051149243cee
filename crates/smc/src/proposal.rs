//! Shared file: where a particle may move.

use glam::{UVec3, Vec3};
use glimt_sampling::math::ShadingFrame;
use glimt_sampling::uniform::unit_vec2;
use glimt_sampling::warp::sample_cap;

/// A place to move to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Proposed {
    /// ω′.
    pub state: Vec3,
    /// `q(ω → ω′)`, in any unit as long as it is that of `backward`; 0 for an impossible proposal, which is a rejection.
    pub forward: f32,
    /// `q(ω′ → ω)`.
    pub backward: f32,
}

impl Proposed {
    /// Nowhere.
    pub const IMPOSSIBLE: Proposed = Proposed {
        state: Vec3::Z,
        forward: 0.0,
        backward: 0.0,
    };
}

/// A density `q(ω → ω′)` to propose moves from.
pub trait Proposal {
    /// A place to move to from `from`, made of three uniform words, of which x and y are one two-dimensional sample.
    fn propose(&self, from: Vec3, u: UVec3) -> Proposed;
}

/// Uniform over the spherical cap about a unit vector: symmetric, so that its density cancels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CapMove {
    /// Height `1 − cos α` of a cap of angular radius α, as [`cap_height`](glimt_sampling::warp::cap_height) gives it.
    pub height: f32,
}

impl Proposal for CapMove {
    #[inline]
    fn propose(&self, from: Vec3, u: UVec3) -> Proposed {
        let local = sample_cap(unit_vec2(u.truncate()), self.height).direction;
        Proposed {
            // Rounding would lengthen or shorten the state a little at each of many moves.
            state: ShadingFrame::from_normal(from).to_world(local).normalize(),
            forward: 1.0,
            backward: 1.0,
        }
    }
}

/// A density that does not depend on where the particle is.
pub trait StateSampler {
    /// A state with its density, 0 for an impossible one, of three uniform words.
    fn sample(&self, u: UVec3) -> Sampled;

    /// The density of [`StateSampler::sample`] at `state`.
    fn pdf(&self, state: Vec3) -> f32;
}

/// A state that was drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sampled {
    /// The state.
    pub state: Vec3,
    /// Its density; 0 for an impossible one.
    pub pdf: f32,
}

/// Independent draws: `q(ω → ω′) = q(ω′)`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Independent<S> {
    /// Where they come from.
    pub sampler: S,
}

impl<S: StateSampler> Proposal for Independent<S> {
    #[inline]
    fn propose(&self, from: Vec3, u: UVec3) -> Proposed {
        let drawn = self.sampler.sample(u);
        Proposed {
            state: drawn.state,
            forward: drawn.pdf,
            backward: self.sampler.pdf(from),
        }
    }
}

/// Two kernels of which each move takes one, with a probability that does not depend on the state, and with its own density: so
/// each leaves the target invariant, and so does their mixture (Tierney 1994).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mixture<A, B> {
    /// Probability of `first`.
    pub pmf_first: f32,
    /// Taken with probability `pmf_first`.
    pub first: A,
    /// Taken otherwise.
    pub second: B,
}

impl<A: Proposal, B: Proposal> Proposal for Mixture<A, B> {
    /// The third word chooses, and what is left of it is a uniform word again.
    #[inline]
    fn propose(&self, from: Vec3, u: UVec3) -> Proposed {
        let split = split_word(u.z, self.pmf_first);
        let rest = UVec3::new(u.x, u.y, split.word);
        if split.first {
            self.first.propose(from, rest)
        } else {
            self.second.propose(from, rest)
        }
    }
}

/// A choice, and the word that is left of the one that made it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Split {
    /// Whether the first alternative was chosen.
    pub first: bool,
    /// Uniform, given the choice; of as many bits as the choice has left.
    pub word: u32,
}

/// Chooses the first of two alternatives with probability `pmf_first` (0 to 1, to 16 bits) by the upper half of a uniform word,
/// and makes a new word of the rest.
///
/// ```
/// use glimt_smc::split_word;
/// assert!(split_word(0, 0.25).first && !split_word(1 << 30, 0.25).first);
/// assert!(!split_word(0, 0.0).first && split_word(u32::MAX, 1.0).first);
/// ```
#[inline]
#[must_use]
pub fn split_word(word: u32, pmf_first: f32) -> Split {
    // In units of 2⁻¹⁶.
    let edge = (pmf_first.clamp(0.0, 1.0) * 65_536.0) as u32;
    let first = (word >> 16) < edge;
    let width = if first { edge } else { 65_536 - edge };
    // Uniform below width · 2¹⁶; its quotient by the width is the new word, 16 bits at a time.
    let place = if first {
        word
    } else {
        word.wrapping_sub(edge << 16)
    };
    let width = width.max(1);
    let upper = place / width;
    let lower = (place % width) * 65_536 / width;
    Split {
        first,
        word: (upper << 16).wrapping_add(lower),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_left_of_a_choice_covers_all_words_evenly() {
        for pmf in [0.1, 0.25, 0.5, 0.9, 1.0] {
            let mut bins = [[0u32; 16]; 2];
            for i in 0..1u32 << 20 {
                let split = split_word(i << 12, pmf);
                bins[usize::from(split.first)][(split.word >> 28) as usize] += 1;
            }
            for (side, share) in [(1, pmf), (0, 1.0 - pmf)] {
                for count in bins[side] {
                    let expected = share * 65_536.0;
                    assert!(
                        (count as f32 - expected).abs() < 20.0,
                        "{pmf} {count} {expected}"
                    );
                }
            }
        }
    }

    #[test]
    fn cap_moves_keep_unit_length_and_stay_in_the_cap() {
        let cap = CapMove {
            height: glimt_sampling::warp::cap_height(0.1),
        };
        let mut state = Vec3::new(0.48, 0.6, -0.64);
        for i in 0..10_000u32 {
            let u = UVec3::new(
                i.wrapping_mul(0x9e37_79b9),
                i.wrapping_mul(0x85eb_ca6b),
                i.wrapping_mul(0xc2b2_ae35),
            );
            let moved = cap.propose(state, u);
            assert!(moved.state.dot(state) > libm::cosf(0.1) - 1e-5);
            state = moved.state;
        }
        assert!((state.length() - 1.0).abs() < 1e-6);
    }
}
