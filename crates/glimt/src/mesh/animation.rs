//! Host file: animations of nodes, sampled at a time (glTF 2.0, Appendix C).

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
    /// The property, with a value for each key; with [`Interpolation::CubicSpline`] three: in-tangent, value, out-tangent.
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
}

impl Channel {
    /// Puts the property's value at a time into `parts`. Before the first key it is the first one's, after the last the last's.
    pub fn apply(&self, time_s: f32, parts: &mut Trs) {
        match &self.values {
            Values::Translation(values) => {
                parts.translation = self.sample(values, time_s, |a, b, s| a.lerp(b, s));
            }
            Values::Scale(values) => {
                parts.scale = self.sample(values, time_s, |a, b, s| a.lerp(b, s));
            }
            Values::Rotation(values) => {
                let sampled = match self.interpolation {
                    Interpolation::CubicSpline => {
                        let plain: Vec<Vec4> = values.iter().map(|q| Vec4::from(*q)).collect();
                        Quat::from_vec4(self.sample(&plain, time_s, |a, b, s| a.lerp(b, s)))
                    }
                    _ => self.sample(values, time_s, Quat::slerp),
                };
                // A spline may pass through 0, where no direction is better than another.
                let length = sampled.length();
                parts.rotation = match length > 1e-12 {
                    true => sampled / length,
                    false => Quat::IDENTITY,
                };
            }
        }
    }

    fn sample<T>(&self, values: &[T], time_s: f32, between: impl Fn(T, T, f32) -> T) -> T
    where
        T: Copy + Add<Output = T> + Mul<f32, Output = T>,
    {
        let is_cubic = self.interpolation == Interpolation::CubicSpline;
        let value = |key: usize| values[if is_cubic { 3 * key + 1 } else { key }];
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
                [values[3 * key + 2] * span, values[3 * after] * span],
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
