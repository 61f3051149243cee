//! Host file: animations of a glTF file, as far as they move nodes.

use super::Reader;
use crate::error::Result;
use crate::mesh::animation::{Animation, Channel, Interpolation, Values};
use ::gltf::accessor::{Accessor, DataType, Dimensions};
use ::gltf::animation::util::ReadOutputs;
use ::gltf::animation::{Interpolation as Between, Property};
use glam::{Quat, Vec3};
use std::collections::HashMap;

impl Reader<'_> {
    /// Reads the animations. Channels of nodes that are not in the scene, whose indices `nodes` gives, and of morph targets
    /// are left out.
    pub(super) fn read_animations(&mut self, nodes: &HashMap<usize, usize>) -> Result<()> {
        for animation in self.document.animations() {
            let unnamed = format!("animation {}", animation.index());
            let mut read = Animation {
                name: animation.name().unwrap_or(&unnamed).to_owned(),
                channels: Vec::new(),
            };
            for (index, channel) in animation.channels().enumerate() {
                if channel.target().property() == Property::MorphTargetWeights {
                    continue;
                }
                if let Some(&node) = nodes.get(&channel.target().node().index()) {
                    let place = format!("animation `{}`, channel {index}", read.name);
                    read.channels
                        .push(self.read_channel(&channel, node, &place)?);
                }
            }
            self.model.animations.push(read);
        }
        Ok(())
    }

    fn read_channel(
        &self,
        channel: &::gltf::animation::Channel<'_>,
        node: usize,
        place: &str,
    ) -> Result<Channel> {
        let error = |what: &str| self.error(what).at(place);
        let sampler = channel.sampler();
        let (input, output) = (sampler.input(), sampler.output());
        let is = |a: &Accessor<'_>, dimensions, types: &[DataType]| {
            a.dimensions() == dimensions && types.contains(&a.data_type())
        };
        let floats = [DataType::F32];
        let quaternions = [
            DataType::F32,
            DataType::I8,
            DataType::U8,
            DataType::I16,
            DataType::U16,
        ];
        if !is(&input, Dimensions::Scalar, &floats) {
            return Err(error("its times are not floats"));
        }
        let fits = match channel.target().property() {
            Property::Rotation => is(&output, Dimensions::Vec4, &quaternions),
            _ => is(&output, Dimensions::Vec3, &floats),
        };
        if !fits {
            return Err(error("its values are of the wrong type"));
        }
        let interpolation = match sampler.interpolation() {
            Between::Step => Interpolation::Step,
            Between::Linear => Interpolation::Linear,
            Between::CubicSpline => Interpolation::CubicSpline,
        };
        let each = match interpolation {
            Interpolation::CubicSpline => 3,
            _ => 1,
        };
        if input.count() == 0 || output.count() != each * input.count() {
            let (keys, values) = (input.count(), output.count());
            return Err(error(&format!("it has {values} values for {keys} keys")));
        }
        let reader = channel.reader(|buffer| Some(&self.buffers[buffer.index()]));
        let beyond = || error("its keys reach beyond their buffer");
        let times_s: Vec<f32> = reader.read_inputs().ok_or_else(beyond)?.collect();
        let grows = times_s.windows(2).all(|pair| pair[0] < pair[1]);
        if !grows || times_s.iter().any(|t| !t.is_finite()) {
            return Err(error("the times of its keys do not grow"));
        }
        let vectors =
            |list: Vec<[f32; 3]>| -> Vec<Vec3> { list.into_iter().map(Vec3::from).collect() };
        let values = match reader.read_outputs().ok_or_else(beyond)? {
            ReadOutputs::Translations(list) => Values::Translation(vectors(list.collect())),
            ReadOutputs::Scales(list) => Values::Scale(vectors(list.collect())),
            ReadOutputs::Rotations(list) => {
                let list = list.into_f32().map(Quat::from_array);
                Values::Rotation(list.collect())
            }
            ReadOutputs::MorphTargetWeights(_) => return Err(error("its values are not places")),
        };
        let is_finite = match &values {
            Values::Translation(list) | Values::Scale(list) => list.iter().all(|v| v.is_finite()),
            Values::Rotation(list) => list.iter().all(|q| q.is_finite()),
        };
        if !is_finite {
            return Err(error("a value is not finite"));
        }
        Ok(Channel {
            node,
            times_s,
            interpolation,
            values,
        })
    }
}
