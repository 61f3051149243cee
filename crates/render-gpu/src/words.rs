//! Host file: enums as words, in shot files and in messages. One table for each says which word means which value.

use glimt_sampling::resample::Scheme;
use glimt_smc::Path;
use serde::de::Error;
use serde::{Deserialize, Deserializer, Serializer};

use crate::kernels::candidates::CandidateSource;
use crate::kernels::frame::{Background, Filter, Pattern, Shadow, Tonemap};

/// A value that has a word.
pub trait Word: Copy + PartialEq + 'static {
    /// All words with their values.
    const WORDS: &'static [(&'static str, Self)];
    /// The words alone.
    const NAMES: &'static [&'static str];

    /// Its word.
    #[must_use]
    fn word(self) -> &'static str {
        let known = Self::WORDS.iter().find(|(_, value)| *value == self);
        known.map_or("", |(word, _)| word)
    }

    /// The value of a word.
    #[must_use]
    fn of_word(word: &str) -> Option<Self> {
        let known = Self::WORDS.iter().find(|(known, _)| *known == word);
        known.map(|(_, value)| *value)
    }
}

/// Gives enums their words.
macro_rules! words {
    ($($type:ty { $($variant:ident = $word:literal),+ })+) => {
        $(impl Word for $type {
            const WORDS: &'static [(&'static str, Self)] = &[$(($word, <$type>::$variant)),+];
            const NAMES: &'static [&'static str] = &[$($word),+];
        })+
    };
}

words! {
    Pattern { OwenSobol = "owen-sobol", Independent = "independent", Stratified = "stratified" }
    Filter { Box = "box", Centre = "centre" }
    Background { Environment = "environment", Transparent = "transparent" }
    Tonemap { Srgb = "srgb", Reinhard = "reinhard" }
    Shadow { Multiply = "multiply", Add = "add" }
    CandidateSource { Brdf = "brdf", Environment = "environment", Mixture = "mixture" }
    Path { Linear = "linear", Geometric = "geometric" }
    Scheme {
        Systematic = "systematic",
        Stratified = "stratified",
        Multinomial = "multinomial",
        Residual = "residual"
    }
}

/// For `#[serde(with = "…")]`: writes the word.
///
/// # Errors
/// The serializer's.
pub fn serialize<T: Word, S: Serializer>(value: &T, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.serialize_str(value.word())
}

/// For `#[serde(with = "…")]`: reads a word.
///
/// # Errors
/// An unknown word, with the known ones.
pub fn deserialize<'de, T: Word, D: Deserializer<'de>>(deserializer: D) -> Result<T, D::Error> {
    let word = String::deserialize(deserializer)?;
    T::of_word(&word).ok_or_else(|| D::Error::unknown_variant(&word, T::NAMES))
}
