//! Host file: animations of nodes and of morph targets, sampled at a time (glTF 2.0, Appendix C).

use super::node::Trs;
use glam::{Quat, Vec3, Vec4};
use std::ops::{Add, Mul};

/// An animation: channels that play together.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Animation {
    /// Its name.
    pub name: String,
    /// What it moves.
    pub channels: Vec<Channel>,
}

impl Animation {
    /// Time of its last key, in seconds; it begins at 0.
    pub fn duration_s(&self) -> f32 {
        let ends = self.channels.iter().filter_map(|c| c.times_s.last());
        ends.copied().fold(0.0, f32::max)
    }
}

/// How one property of one node moves.
#[derive(Clone, Debug, PartialEq)]
pub struct Channel {
    /// Index of the node.
    pub node: usize,
    /// Times of the keys in seconds: finite, growing, at least one.
    pub times_s: Vec<f32>,
    /// What is between two keys.
    pub interpolation: Interpolation,
    /// The property, with a value for each key; with [`Interpolation::CubicSpline`] three: in-tangent, value, out-tangent. Weights
    /// have such a value for each morph target: of each key first the in-tangents of all.
    pub values: Values,
}

/// What is between two keys.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Interpolation {
    /// The first of them.
    Step,
    /// A straight line; for rotations the shorter arc, at constant speed.
    Linear,
    /// A cubic Hermite spline.
    CubicSpline,
}

/// Values of a property of a node.
#[derive(Clone, Debug, PartialEq)]
pub enum Values {
    /// Where its origin is moved to.
    Translation(Vec<Vec3>),
    /// How it is turned.
    Rotation(Vec<Quat>),
    /// Its size along each axis.
    Scale(Vec<Vec3>),
    /// How far the morph targets of its mesh have come.
    Weights(Vec<f32>),
}

impl Values {
    /// How many numbers, vectors or rotations there are.
    pub fn len(&self) -> usize {
        match self {
            Self::Translation(list) | Self::Scale(list) => list.len(),
            Self::Rotation(list) => list.len(),
            Self::Weights(list) => list.len(),
        }
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Whether each of them is finite.
    pub fn is_finite(&self) -> bool {
        match self {
            Self::Translation(list) | Self::Scale(list) => list.iter().all(|v| v.is_finite()),
            Self::Rotation(list) => list.iter().all(|q| q.is_finite()),
            Self::Weights(list) => list.iter().all(|w| w.is_finite()),
        }
    }
}

impl Channel {
    /// Puts the property's value at a time into `parts`, or into `weights`. Before the first key it is the first one's, after the
    /// last the last's.
    pub fn apply(&self, time_s: f32, parts: &mut Trs, weights: &mut [f32]) {
        match &self.values {
            Values::Translation(values) => {
                parts.translation = self.sample(|i| values[i], time_s, |a, b, s| a.lerp(b, s));
            }
            Values::Scale(values) => {
                parts.scale = self.sample(|i| values[i], time_s, |a, b, s| a.lerp(b, s));
            }
            Values::Rotation(values) => {
                let sampled = match self.interpolation {
                    Interpolation::CubicSpline => {
                        let plain = |i: usize| Vec4::from(values[i]);
                        Quat::from_vec4(self.sample(plain, time_s, |a, b, s| a.lerp(b, s)))
                    }
                    _ => self.sample(|i| values[i], time_s, Quat::slerp),
                };
                // A spline may pass through 0, where no direction is better than another.
                let length = sampled.length();
                parts.rotation = match length > 1e-12 {
                    true => sampled / length,
                    false => Quat::IDENTITY,
                };
            }
            Values::Weights(values) => {
                let targets = weights.len();
                for (target, weight) in weights.iter_mut().enumerate() {
                    let value = |i: usize| values[i * targets + target];
                    *weight = self.sample(value, time_s, |a, b, s| a + (b - a) * s);
                }
            }
        }
    }

    /// The value at a time, of `values` by their numbers.
    fn sample<T>(
        &self,
        values: impl Fn(usize) -> T,
        time_s: f32,
        between: impl Fn(T, T, f32) -> T,
    ) -> T
    where
        T: Copy + Add<Output = T> + Mul<f32, Output = T>,
    {
        let is_cubic = self.interpolation == Interpolation::CubicSpline;
        let value = |key: usize| values(if is_cubic { 3 * key + 1 } else { key });
        let after = self.times_s.partition_point(|&key| key <= time_s);
        if after == 0 {
            return value(0);
        }
        let key = after - 1;
        if after == self.times_s.len() {
            return value(key);
        }
        let span = self.times_s[after] - self.times_s[key];
        let s = (time_s - self.times_s[key]) / span;
        match self.interpolation {
            Interpolation::Step => value(key),
            Interpolation::Linear => between(value(key), value(after), s),
            Interpolation::CubicSpline => hermite(
                s,
                [value(key), value(after)],
                [values(3 * key + 2) * span, values(3 * after) * span],
            ),
        }
    }
}

/// The cubic that goes from one value to the other as s goes from 0 to 1, with these derivatives by s at the ends.
pub fn hermite<T>(s: f32, values: [T; 2], slopes: [T; 2]) -> T
where
    T: Copy + Add<Output = T> + Mul<f32, Output = T>,
{
    let (s2, s3) = (s * s, s * s * s);
    values[0] * (2.0 * s3 - 3.0 * s2 + 1.0)
        + slopes[0] * (s3 - 2.0 * s2 + s)
        + values[1] * (3.0 * s2 - 2.0 * s3)
        + slopes[1] * (s3 - s2)
}
