//! Host file: how an object of a shot moves: the animations of its file, and the nodes that the shot spins.

use crate::error::Result;
use crate::mesh::animation::{Animation, Channel, Values};
use crate::mesh::model::Model;
use crate::mesh::node::{Node, NodePose, Trs, names, to_file};
use crate::notes::Notes;
use crate::shot::parse::Source;
use crate::shot::{self, ANIMATION_OFF};
use glam::{Mat4, Quat, Vec3};
use std::collections::HashSet;
use std::path::Path;

/// The nodes of an object, and what moves them.
#[derive(Clone, Debug, Default)]
pub struct Motion {
    nodes: Vec<Node>,
    /// Those that play.
    animations: Vec<Animation>,
    is_looped: bool,
    offset_s: f64,
    spins: Vec<Spin>,
    /// Of each node, whether it moves a part of the model: one that stands at it, or within it, or follows it as a joint.
    carries: Vec<bool>,
    /// Of each node, whether a part stands at it that has morph targets.
    morphs: Vec<bool>,
}

/// A node that turns at a constant rate.
#[derive(Clone, Debug)]
struct Spin {
    node: usize,
    axis: Vec3,
    centre: Vec3,
    deg_per_frame: f64,
}

impl Motion {
    /// What the keys of object number `index` say of its model. Of animations that move the same nodes the first plays, if none is
    /// named.
    ///
    /// # Errors
    /// The model has no such animation or node; the message names those that it has. With strict `notes` also animations that move the
    /// same nodes.
    pub fn new(
        object: &shot::Object,
        index: usize,
        model: &Model,
        source: &Source,
        notes: &mut Notes,
    ) -> Result<Self> {
        let animations = match object.animation.as_str() {
            ANIMATION_OFF => Vec::new(),
            "" => compatible(object, model, notes)?,
            name => {
                let found = model.animations.iter().find(|a| a.name == name);
                let known: Vec<&str> = model.animations.iter().map(|a| a.name.as_str()).collect();
                let missing = || {
                    let key = format!("object.{index}.animation");
                    let what = format!("{} has no animation `{name}`", object.mesh);
                    source.error(&key, what).fix_name(name, &known)
                };
                vec![found.ok_or_else(missing)?.clone()]
            }
        };
        let mut spins = Vec::new();
        for (number, spin) in object.spins.iter().enumerate() {
            let named = |node: &Node| node.name == spin.node;
            let known = names(&model.nodes);
            if !known.contains(&spin.node.as_str()) {
                let key = format!("object.{index}.spin.{number}.node");
                let what = format!("{} has no node `{}`", object.mesh, spin.node);
                return Err(source.error(&key, what).fix_name(&spin.node, &known));
            }
            let all = model.nodes.iter().enumerate();
            let found = all.filter(|(_, node)| named(node));
            spins.extend(found.map(|(node, _)| Spin {
                node,
                axis: Vec3::from(spin.axis).normalize(),
                centre: spin.centre.into(),
                deg_per_frame: spin.deg_per_frame.into(),
            }));
        }
        Ok(Self {
            nodes: model.nodes.clone(),
            animations,
            is_looped: object.animation_loop,
            offset_s: object.animation_offset_s.into(),
            spins,
            carries: carriers(model),
            morphs: morphed(model),
        })
    }

    /// Whether it moves at all.
    pub fn is_moving(&self) -> bool {
        let mut animations = self.animations.iter();
        !self.spins.is_empty() || animations.any(|a| !a.channels.is_empty())
    }

    /// What moves, in words; nothing where nothing does.
    pub fn describe(&self) -> Vec<String> {
        self.played(|_| true).chain(self.spun(|_| true)).collect()
    }

    /// What moves a part first: the object's key that makes it, and in words. Cameras of the file may move alone.
    pub fn moving_part(&self) -> Option<(&'static str, String)> {
        let moves = |channel: &Channel| match channel.values {
            Values::Weights(_) => self.morphs[channel.node],
            _ => self.carries[channel.node],
        };
        let played = self.played(moves).map(|what| ("animation", what));
        let spun = self.spun(|node| self.carries[node]);
        let spun = spun.map(|what| ("spin", what));
        played.chain(spun).next()
    }

    /// The animations that have such a channel.
    fn played(&self, is_meant: impl Fn(&Channel) -> bool) -> impl Iterator<Item = String> {
        let again = if self.is_looped {
            ", again and again"
        } else {
            ""
        };
        let playing = self
            .animations
            .iter()
            .filter(move |a| a.channels.iter().any(&is_meant));
        playing.map(move |a| format!("animation `{}`, {} s{again}", a.name, a.duration_s()))
    }

    /// The spins of such nodes.
    fn spun(&self, is_meant: impl Fn(usize) -> bool) -> impl Iterator<Item = String> {
        let spins = self.spins.iter().filter(move |spin| is_meant(spin.node));
        spins.map(|spin| {
            let name = &self.nodes[spin.node].name;
            format!(
                "node `{name}` turns by {} degrees a frame",
                spin.deg_per_frame
            )
        })
    }

    /// How the nodes stand `frames` frames after the shot's first.
    pub fn nodes_at(&self, frames: i64, fps: f32) -> NodePose {
        let mut moved: Vec<Option<Trs>> = vec![None; self.nodes.len()];
        let weights = self.nodes.iter().map(|node| node.weights.clone());
        let mut weights: Vec<Vec<f32>> = weights.collect();
        let time_s = frames as f64 / f64::from(fps) + self.offset_s;
        for animation in &self.animations {
            let duration_s = f64::from(animation.duration_s());
            let time_s = match self.is_looped && duration_s > 0.0 {
                true => time_s.rem_euclid(duration_s),
                false => time_s,
            };
            // As its keys are stored, so that a frame on a key is neither before nor behind it.
            let time_s = time_s as f32;
            for channel in &animation.channels {
                let mut parts = moved[channel.node].unwrap_or(self.nodes[channel.node].parts);
                channel.apply(time_s, &mut parts, &mut weights[channel.node]);
                if !matches!(channel.values, Values::Weights(_)) {
                    moved[channel.node] = Some(parts);
                }
            }
        }
        let mut spun = vec![Mat4::IDENTITY; self.nodes.len()];
        for spin in &self.spins {
            // Whole turns are taken off before there are few digits left.
            let angle = (spin.deg_per_frame * frames as f64).rem_euclid(360.0);
            let turn = Quat::from_axis_angle(spin.axis, angle.to_radians() as f32);
            spun[spin.node] *= Mat4::from_translation(spin.centre)
                * Mat4::from_quat(turn)
                * Mat4::from_translation(-spin.centre);
        }
        let to_file = to_file(&self.nodes, |index, node| {
            let local = moved[index].map_or(node.local, |parts| parts.matrix());
            match spun[index] == Mat4::IDENTITY {
                true => local,
                false => local * spun[index],
            }
        });
        NodePose { to_file, weights }
    }
}

/// The animations of a model but for those that move a node which an earlier one moves, with a warning.
fn compatible(object: &shot::Object, model: &Model, notes: &mut Notes) -> Result<Vec<Animation>> {
    let mut nodes = HashSet::new();
    let mut playing: Vec<Animation> = Vec::new();
    let mut left_out = Vec::new();
    for animation in &model.animations {
        let own: HashSet<usize> = animation.channels.iter().map(|c| c.node).collect();
        if nodes.is_disjoint(&own) {
            nodes.extend(own);
            playing.push(animation.clone());
        } else {
            left_out.push(format!("`{}`", animation.name));
        }
    }
    if let Some(first) = playing.first().filter(|_| !left_out.is_empty()) {
        let file = model
            .files
            .first()
            .map_or(Path::new(&object.mesh), |file| file);
        let what = format!(
            "its animations move the same nodes: `{}` plays, and {} do not",
            first.name,
            left_out.join(", ")
        );
        notes.guess(file, &what, "name one with the object's key `animation`")?;
    }
    Ok(playing)
}

/// Of each node of a model, whether it moves a part.
fn carriers(model: &Model) -> Vec<bool> {
    let mut carries = vec![false; model.nodes.len()];
    for part in &model.parts {
        match part.skin {
            None => carries[part.node] = true,
            Some(skin) => {
                for &joint in &model.skins[skin].joints {
                    carries[joint] = true;
                }
            }
        }
    }
    // Nodes come after those that they stand in.
    for (index, node) in model.nodes.iter().enumerate().rev() {
        if let Some(parent) = node.parent
            && carries[index]
        {
            carries[parent] = true;
        }
    }
    carries
}

/// Of each node of a model, whether a part stands at it that has morph targets.
fn morphed(model: &Model) -> Vec<bool> {
    let mut morphs = vec![false; model.nodes.len()];
    for part in &model.parts {
        let deform = model.deforms.get(&part.mesh);
        morphs[part.node] |= deform.is_some_and(|deform| !deform.targets.is_empty());
    }
    morphs
}
