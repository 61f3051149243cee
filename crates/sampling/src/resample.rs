//! Shared file: resampling: choosing n of weighted items so that each is expected in proportion to its weight.
//!
//! Four schemes, all in one pass over the weights and without storage: the picks are the teeth of a [`Comb`] that is
//! laid along the cumulative weights, and each item gets as many copies as teeth fall on it. Weights come as *expected
//! copies* `n w_i / Σ w`. (Douc, Cappé, Moulines 2005 compare the schemes.)

use crate::uniform::{UniformSource, unit_f32};

/// How the teeth of a comb lie. All are unbiased: an item of expected copies e gets e on average. In a buffer it is its number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u32)]
pub enum Scheme {
    /// One uniform for all teeth, which are equally spaced: an item gets ⌊e⌋ or ⌈e⌉ copies. Draws one word.
    Systematic = 0,
    /// One uniform for each tooth within a stratum of its own. Draws n words.
    Stratified = 1,
    /// Independent picks. Draws n words.
    Multinomial = 2,
    /// ⌊e⌋ copies of each item for sure, the rest by independent picks among what is left over. Draws n words.
    Residual = 3,
}

/// How many words one resampling to `picks` items draws, whatever the weights.
#[inline]
#[must_use]
pub fn words(scheme: Scheme, picks: u32) -> u32 {
    if scheme == Scheme::Systematic {
        1
    } else {
        picks
    }
}

/// Draws the words of a resampling that does not take place, so that a stream stays in step.
#[inline]
pub fn skip<U: UniformSource>(scheme: Scheme, picks: u32, source: &mut U) {
    for _ in 0..words(scheme, picks) {
        source.next_u32();
    }
}

/// Copies that an item gets for sure: `⌊e⌋` under [`Scheme::Residual`], none under the others.
#[inline]
#[must_use]
pub fn sure_copies(scheme: Scheme, expected: f32) -> u32 {
    if scheme == Scheme::Residual {
        expected as u32
    } else {
        0
    }
}

/// Picks being made, in one pass over the items.
///
/// ```
/// use glimt_sampling::resample::{Comb, Scheme};
/// use glimt_sampling::Xoshiro128PlusPlus;
/// let mut source = Xoshiro128PlusPlus::stream(1, 0, 0);
/// // Four picks from weights 1 : 0 : 3 are one and three copies, wherever the teeth lie.
/// let mut comb = Comb::new(Scheme::Systematic, 4, 0, &mut source);
/// let copies = [1.0, 0.0, 3.0].map(|expected| comb.take(expected, &mut source));
/// assert_eq!((copies, comb.finish(&mut source)), ([1, 0, 3], 0));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Comb {
    scheme: Scheme,
    /// Picks in all.
    picks: u32,
    /// Teeth: the picks that are not sure.
    teeth: u32,
    /// Teeth that are behind.
    made: u32,
    /// Where the next tooth is, in expected copies.
    next: f32,
    /// How far the items so far reach, in expected copies.
    reach: f32,
    /// The systematic offset, or the share of the comb that multinomial teeth have left.
    state: f32,
}

impl Comb {
    /// A comb of `picks` picks, of which `sure` are sure: the sum of [`sure_copies`] over all items.
    #[inline]
    #[must_use]
    pub fn new<U: UniformSource>(scheme: Scheme, picks: u32, sure: u32, source: &mut U) -> Comb {
        let mut comb = Comb {
            scheme,
            picks,
            teeth: picks.saturating_sub(sure),
            made: 0,
            next: 0.0,
            reach: 0.0,
            state: 1.0,
        };
        if scheme == Scheme::Systematic {
            comb.state = unit_f32(source.next_u32());
        }
        comb.place_tooth(source);
        comb
    }

    /// How many picks fall on the next item, which is expected to get `expected ≥ 0` copies. None on an item of weight 0,
    /// for any uniforms.
    #[inline]
    #[must_use]
    pub fn take<U: UniformSource>(&mut self, expected: f32, source: &mut U) -> u32 {
        let sure = sure_copies(self.scheme, expected);
        self.reach += expected - sure as f32;
        let before = self.made;
        while self.made < self.teeth && self.next < self.reach {
            self.made += 1;
            self.place_tooth(source);
        }
        sure + (self.made - before)
    }

    /// Picks that rounding has left at the end, nearly always 0: they belong to the last item of positive weight. Draws the
    /// words that the scheme has not needed.
    #[inline]
    #[must_use]
    pub fn finish<U: UniformSource>(&mut self, source: &mut U) -> u32 {
        let left = self.teeth - self.made;
        if self.scheme != Scheme::Systematic {
            // One word was drawn for each tooth that was placed, the waiting one among them.
            let drawn = self.teeth.min(self.made + 1);
            for _ in drawn..self.picks {
                source.next_u32();
            }
        }
        self.made = self.teeth;
        left
    }

    /// Puts the next tooth in its place.
    #[inline]
    fn place_tooth<U: UniformSource>(&mut self, source: &mut U) {
        if self.made >= self.teeth {
            return;
        }
        let first = self.made as f32;
        if self.scheme == Scheme::Systematic {
            self.next = first + self.state;
        } else if self.scheme == Scheme::Stratified {
            self.next = first + unit_f32(source.next_u32());
        } else {
            // The least of m uniforms leaves 1 − x = v^(1/m) above it, and the others are uniform there.
            let v = 1.0 - unit_f32(source.next_u32());
            let left = (self.teeth - self.made) as f32;
            self.state *= libm::powf(v, 1.0 / left);
            self.next = (1.0 - self.state) * self.teeth as f32;
        }
    }
}

/// Writes the indices of `ancestors.len()` items that are picked with probabilities in proportion to `weights`, in ascending
/// order.
///
/// Weights are at least 0 and finite, of any scale; an item of weight 0 is never picked. Where all weights are 0, or there are
/// none, nothing is written and the result is false.
///
/// ```
/// use glimt_sampling::resample::{Scheme, ancestors_into};
/// use glimt_sampling::Xoshiro128PlusPlus;
/// let mut ancestors = [0; 4];
/// let mut source = Xoshiro128PlusPlus::stream(1, 0, 0);
/// assert!(ancestors_into(Scheme::Residual, &[2.0, 0.0, 6.0], &mut ancestors, &mut source));
/// assert_eq!(ancestors, [0, 2, 2, 2]);
/// ```
pub fn ancestors_into<U: UniformSource>(
    scheme: Scheme,
    weights: &[f32],
    ancestors: &mut [u32],
    source: &mut U,
) -> bool {
    let picks = ancestors.len() as u32;
    let mut largest = 0.0f32;
    for i in 0..weights.len() {
        largest = largest.max(weights[i]);
    }
    if !(largest > 0.0) {
        skip(scheme, picks, source);
        return false;
    }
    // In units of the largest weight no sum overflows, and no quotient of small weights.
    let mut total = 0.0;
    for i in 0..weights.len() {
        total += weights[i] / largest;
    }
    let scale = picks as f32 / total;
    let mut sure = 0;
    for i in 0..weights.len() {
        sure += sure_copies(scheme, weights[i] / largest * scale);
    }
    let mut comb = Comb::new(scheme, picks, sure, source);
    let mut filled = 0;
    let mut last = 0;
    for i in 0..weights.len() {
        let copies = comb.take(weights[i] / largest * scale, source);
        for _ in 0..copies {
            if filled < picks {
                ancestors[filled as usize] = i as u32;
                filled += 1;
            }
        }
        if weights[i] > 0.0 {
            last = i as u32;
        }
    }
    let _ = comb.finish(source);
    while filled < picks {
        ancestors[filled as usize] = last;
        filled += 1;
    }
    true
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A source of one word.
    struct Constant(u32);

    impl UniformSource for Constant {
        fn next_u32(&mut self) -> u32 {
            self.0
        }
    }

    const SCHEMES: [Scheme; 4] = [
        Scheme::Systematic,
        Scheme::Stratified,
        Scheme::Multinomial,
        Scheme::Residual,
    ];

    #[test]
    fn a_weight_of_zero_is_never_picked_at_either_end_of_the_uniforms() {
        let tiny = f32::MIN_POSITIVE;
        let cases: [&[f32]; 6] = [
            &[0.0, 1.0, 0.0],
            &[1.0, 0.0],
            &[0.0, 0.0, 1.0],
            &[0.0, 0.1, 0.0, 0.2, 0.7, 0.0, 0.0],
            &[0.0, tiny, 0.0, 1.0, 0.0],
            &[0.0, 1.0e30, 0.0, 1.0, 0.0],
        ];
        for scheme in SCHEMES {
            for weights in cases {
                for u in [0, 1, u32::MAX / 2, u32::MAX - 1, u32::MAX] {
                    for n in 1..20 {
                        let mut ancestors = [0; 20];
                        let ancestors = &mut ancestors[..n];
                        assert!(ancestors_into(scheme, weights, ancestors, &mut Constant(u)));
                        for &a in ancestors.iter() {
                            assert!(weights[a as usize] > 0.0, "{scheme:?} {weights:?} {u} {n}");
                        }
                    }
                }
            }
        }
    }

    #[test]
    fn no_weights_pick_nothing_but_draw_as_ever() {
        struct Counting(u32);
        impl UniformSource for Counting {
            fn next_u32(&mut self) -> u32 {
                self.0 += 1;
                self.0.wrapping_mul(0x9e37_79b9)
            }
        }
        for scheme in SCHEMES {
            for weights in [
                &[0.0, 0.0][..],
                &[],
                &[0.5, 0.25, 0.25],
                &[1.0],
                &[0.1, 0.9],
            ] {
                let mut source = Counting(0);
                let mut ancestors = [7; 5];
                let picked = ancestors_into(scheme, weights, &mut ancestors, &mut source);
                assert_eq!(picked, weights.iter().sum::<f32>() > 0.0);
                assert_eq!(source.0, words(scheme, 5), "{scheme:?} {weights:?}");
            }
        }
    }
}
