//! Host file: animations of a glTF file: what moves its nodes, and the weights of morph targets.

use super::Reader;
use super::accessor::Whole;
use crate::error::Result;
use crate::mesh::animation::{Animation, Channel, Interpolation, Values};
use ::gltf::accessor::DataType;
use ::gltf::animation::{Interpolation as Between, Property};
use glam::{Quat, Vec3};
use std::collections::HashMap;

const FLOATS: [DataType; 1] = [DataType::F32];
const FRACTIONS: [DataType; 5] = [
    DataType::F32,
    DataType::I8,
    DataType::U8,
    DataType::I16,
    DataType::U16,
];

impl Reader<'_> {
    /// Reads the animations. Channels of nodes that are not in the scene, whose indices `nodes` gives, are left out.
    pub(super) fn read_animations(&mut self, nodes: &HashMap<usize, usize>) -> Result<()> {
        for animation in self.document.animations() {
            let unnamed = format!("animation {}", animation.index());
            let mut read = Animation {
                name: animation.name().unwrap_or(&unnamed).to_owned(),
                channels: Vec::new(),
            };
            for (index, channel) in animation.channels().enumerate() {
                if let Some(&node) = nodes.get(&channel.target().node().index()) {
                    let place = format!("animation `{}`, channel {index}", read.name);
                    let channel = self.read_channel(&channel, node);
                    read.channels.extend(channel.map_err(|e| e.at(&place))?);
                }
            }
            self.model.animations.push(read);
        }
        Ok(())
    }

    /// A channel; `None` of weights where there is nothing to weigh.
    fn read_channel(
        &self,
        channel: &::gltf::animation::Channel<'_>,
        node: usize,
    ) -> Result<Option<Channel>> {
        let sampler = channel.sampler();
        let interpolation = match sampler.interpolation() {
            Between::Step => Interpolation::Step,
            Between::Linear => Interpolation::Linear,
            Between::CubicSpline => Interpolation::CubicSpline,
        };
        let times = self.floats(
            &sampler.input(),
            &FLOATS,
            Whole::AsMarked,
            "the list of its times",
        )?;
        let times_s: Vec<f32> = times.into_iter().map(|[time]| time).collect();
        let grows = times_s.windows(2).all(|pair| pair[0] < pair[1]);
        if !grows || times_s.iter().any(|t| !t.is_finite()) {
            return Err(self.error("the times of its keys do not grow"));
        }
        let output = sampler.output();
        let (what, fractions) = ("the list of its values", Whole::Fractions);
        let vectors = || -> Result<Vec<Vec3>> {
            let read = self.floats(&output, &FLOATS, Whole::AsMarked, what)?;
            Ok(read.into_iter().map(Vec3::from_array).collect())
        };
        let (values, of_key) = match channel.target().property() {
            Property::Translation => (Values::Translation(vectors()?), 1),
            Property::Scale => (Values::Scale(vectors()?), 1),
            Property::Rotation => {
                let read = self.floats(&output, &FRACTIONS, fractions, what)?;
                let read = read.into_iter().map(Quat::from_array);
                (Values::Rotation(read.collect()), 1)
            }
            Property::MorphTargetWeights => {
                let targets = self.model.nodes[node].weights.len();
                if targets == 0 {
                    return Ok(None);
                }
                let read = self.floats(&output, &FRACTIONS, fractions, what)?;
                let read = read.into_iter().map(|[weight]| weight);
                (Values::Weights(read.collect()), targets)
            }
        };
        let each = match interpolation {
            Interpolation::CubicSpline => 3 * of_key,
            _ => of_key,
        };
        if times_s.is_empty() || times_s.len().checked_mul(each) != Some(values.len()) {
            let (keys, values) = (times_s.len(), values.len());
            return Err(self.error(format!("it has {values} values for {keys} keys")));
        }
        if !values.is_finite() {
            return Err(self.error("a value is not finite"));
        }
        Ok(Some(Channel {
            node,
            times_s,
            interpolation,
            values,
        }))
    }
}
