//! Shared file: the way of a ray through a tree of boxes, four at a time.

use glam::{Vec3, Vec4};

use super::opacity::is_passed;
use super::ray::{Hit, Ray};
use super::triangle::{SEE_THROUGH, Triangle, barycentrics, intersect};

/// Entries of the traversal's stack. No tree needs more.
pub const STACK_SIZE: usize = 64;

/// Children of a node.
pub const WIDTH: usize = 4;

/// A node of the tree: up to four children, each with its box, and each a node or a run of triangles. 112 bytes.
///
/// Their boxes lie side by side, so that one pass of vector operations tests a ray against all four.
#[derive(Clone, Copy, Debug, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
pub struct BvhNode {
    /// Lower corners of the children's boxes: x of all four, then y, then z.
    pub min_x: Vec4,
    /// See `min_x`.
    pub min_y: Vec4,
    /// See `min_x`.
    pub min_z: Vec4,
    /// Upper corners, likewise.
    pub max_x: Vec4,
    /// See `max_x`.
    pub max_y: Vec4,
    /// See `max_x`.
    pub max_z: Vec4,
    /// Each child's index among the nodes; [`LEAF`] with the index of its first triangle, whose [`Triangle::run`] says how many it has;
    /// 0 where there is no child, for the root is nobody's.
    pub children: [u32; WIDTH],
}

/// Bit of a child that is a run of triangles.
pub const LEAF: u32 = 1 << 31;

/// What a ray meets of a node's children.
struct Met {
    /// Bit `i` is set where it meets the box of child `i`.
    children: u32,
    /// Where it enters each box, in units of its direction; 0 where it starts inside.
    distances: [f32; WIDTH],
}

/// Which boxes of a node's children the ray meets within `reach`.
///
/// The far side is moved out by two rounding errors, which makes the test conservative (Ize 2013).
#[inline(always)]
fn meet(node: &BvhNode, ray: &Ray, reach: f32) -> Met {
    let (x, y, z) = (ray.origin.x, ray.origin.y, ray.origin.z);
    let inverse = ray.inverse_direction;
    let to_min_x = (node.min_x - x) * inverse.x;
    let to_max_x = (node.max_x - x) * inverse.x;
    let to_min_y = (node.min_y - y) * inverse.y;
    let to_max_y = (node.max_y - y) * inverse.y;
    let to_min_z = (node.min_z - z) * inverse.z;
    let to_max_z = (node.max_z - z) * inverse.z;
    let near_x = to_min_x.min(to_max_x);
    let near_y = to_min_y.min(to_max_y);
    let near_z = to_min_z.min(to_max_z);
    let far_x = to_min_x.max(to_max_x);
    let far_y = to_min_y.max(to_max_y);
    let far_z = to_min_z.max(to_max_z);
    let distances = near_x.max(near_y).max(near_z.max(Vec4::ZERO));
    let far = far_x.min(far_y).min(far_z) * 1.000_000_4;
    let room = far.min(Vec4::splat(reach)) - distances;
    Met {
        children: 15 - room.is_negative_bitmask(),
        distances: distances.to_array(),
    }
}

/// What the ray hits first at a distance in `(0, t_max)`. Surfaces that let it pass are not hit. What lies in the plane of a catcher is
/// hit before it.
///
/// `nodes[0]` is the root, `surface` the buffer of [`material`](super::material). An empty tree is never hit.
#[must_use]
pub fn closest_hit(
    nodes: &[BvhNode],
    triangles: &[Triangle],
    surface: &[u32],
    ray: &Ray,
    t_max: f32,
) -> Option<Hit> {
    let mut t = t_max;
    let index = traverse(nodes, triangles, surface, ray, &mut t, false);
    if index == NONE {
        return None;
    }
    let triangle = &triangles[index as usize];
    if triangle.is_catcher() {
        // Without the setback that its distance had.
        t = intersect(triangle, ray, f32::MAX);
    }
    Some(Hit {
        triangle: index,
        t,
        barycentrics: barycentrics(triangle, ray),
    })
}

/// Whether anything blocks the ray at a distance in `(0, t_max)`. Catchers do not, nor do surfaces that let it pass.
#[must_use]
pub fn any_hit(
    nodes: &[BvhNode],
    triangles: &[Triangle],
    surface: &[u32],
    ray: &Ray,
    t_max: f32,
) -> bool {
    let mut t = t_max;
    traverse(nodes, triangles, surface, ray, &mut t, true) != NONE
}

/// Index of no triangle.
const NONE: u32 = u32::MAX;

/// Visits the nodes that the ray meets within `reach`, the nearest child of each first. Returns the triangle that is hit first,
/// with its distance in `reach`; or, where `any` is set, the first one found that is not a catcher.
#[inline(always)]
fn traverse(
    nodes: &[BvhNode],
    triangles: &[Triangle],
    surface: &[u32],
    ray: &Ray,
    reach: &mut f32,
    any: bool,
) -> u32 {
    if nodes.is_empty() {
        return NONE;
    }
    let mut best = NONE;
    let mut stack = [0u32; STACK_SIZE];
    let mut height = 0;
    let mut at = 0;
    loop {
        // The root is no child, so 0 stands for none.
        let mut next = 0;
        if at < LEAF {
            let node = &nodes[at as usize];
            let met = meet(node, ray, *reach);
            let mut distance = f32::MAX;
            // Children are asked for one after the other: so a CPU predicts which are met, and begins to load them.
            for i in 0..WIDTH {
                let child = node.children[i];
                if (met.children >> i) & 1 != 0 {
                    // What is not next waits.
                    let mut waiting = next;
                    if any {
                        next = child;
                    } else if met.distances[i] < distance {
                        distance = met.distances[i];
                        next = child;
                    } else {
                        waiting = child;
                    }
                    if waiting > 0 {
                        stack[height] = waiting;
                        height += 1;
                    }
                }
            }
        } else {
            best = visit_leaf(triangles, surface, at - LEAF, ray, reach, best, any);
            if any && best != NONE {
                return best;
            }
        }
        if next == 0 {
            if height == 0 {
                return best;
            }
            height -= 1;
            next = stack[height];
        }
        at = next;
    }
}

/// The nearest triangle of the leaf that begins at `first` within `reach`, which becomes its distance; `best` where there is none. With
/// `no_catcher` set, catchers are passed over.
#[inline(always)]
fn visit_leaf(
    triangles: &[Triangle],
    surface: &[u32],
    first: u32,
    ray: &Ray,
    reach: &mut f32,
    best: u32,
    no_catcher: bool,
) -> u32 {
    let mut nearest = best;
    for i in first..first + triangles[first as usize].run {
        let mut t = intersect(&triangles[i as usize], ray, *reach);
        // Asked only of a triangle that is hit, so that the tests cost nothing on the way.
        if t < *reach && triangles[i as usize].object >= SEE_THROUGH {
            t = held(i, &triangles[i as usize], surface, ray, t, no_catcher);
        }
        if t < *reach {
            *reach = t;
            nearest = i;
        }
    }
    nearest
}

/// The distance at which a triangle that is hit at `t` counts, which is of a catcher or may let the ray pass: [`f32::MAX`] where it lets
/// it pass, or, with `no_catcher` set, is a catcher.
#[inline(never)]
fn held(
    index: u32,
    triangle: &Triangle,
    surface: &[u32],
    ray: &Ray,
    t: f32,
    no_catcher: bool,
) -> f32 {
    if triangle.is_see_through() && is_passed(index, triangle, surface, ray) {
        return f32::MAX;
    }
    if !triangle.is_catcher() {
        return t;
    }
    if no_catcher {
        return f32::MAX;
    }
    t + triangle.setback(ray, t)
}

/// Of which triangles [`any_hit_of`] asks.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Asked {
    /// Those of this object; those of all others where `own` is not set.
    pub object: u32,
    /// See `object`.
    pub own: bool,
    /// Nearer than this, not those whose outside is where `way` leads.
    pub near: f32,
    /// See `near`.
    pub way: Vec3,
}

/// Whether one of the triangles that are asked of blocks the ray at a distance in `(0, t_max)`. Catchers do not, nor do surfaces that
/// let it pass.
///
/// For few rays: it visits nodes in no order.
#[must_use]
pub fn any_hit_of(
    nodes: &[BvhNode],
    triangles: &[Triangle],
    surface: &[u32],
    ray: &Ray,
    t_max: f32,
    asked: &Asked,
) -> bool {
    if nodes.is_empty() {
        return false;
    }
    let mut stack = [0u32; STACK_SIZE];
    let mut height = 1;
    while height > 0 {
        height -= 1;
        let at = stack[height];
        if at < LEAF {
            let node = &nodes[at as usize];
            let met = meet(node, ray, t_max);
            for i in 0..WIDTH {
                if (met.children >> i) & 1 != 0 && node.children[i] > 0 {
                    stack[height] = node.children[i];
                    height += 1;
                }
            }
        } else {
            let first = at - LEAF;
            for i in first..first + triangles[first as usize].run {
                let triangle = &triangles[i as usize];
                if !triangle.is_catcher() && (triangle.object_index() == asked.object) == asked.own
                {
                    let t = intersect(triangle, ray, t_max);
                    let is_met = t < t_max
                        && !(triangle.is_see_through() && is_passed(i, triangle, surface, ray));
                    if is_met && !(t < asked.near && triangle.outward().dot(asked.way) > 0.0) {
                        return true;
                    }
                }
            }
        }
    }
    false
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn layout_is_that_of_wgsl() {
        assert_eq!(core::mem::size_of::<BvhNode>(), 112);
        assert_eq!(core::mem::offset_of!(BvhNode, max_x), 48);
        assert_eq!(core::mem::offset_of!(BvhNode, children), 96);
    }
}
