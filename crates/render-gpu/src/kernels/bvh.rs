//! Shared file: the way of a ray through a binary tree of boxes.

use glam::Vec3;

use super::opacity::is_passed;
use super::ray::{Hit, Ray};
use super::triangle::{SEE_THROUGH, Triangle, barycentrics, intersect};

/// Entries of the traversal's stack. No tree is built deeper.
pub const STACK_SIZE: usize = 64;

/// A node of the tree: an inner node with two children side by side, or a leaf with a run of triangles. 32 bytes.
#[derive(Clone, Copy, Debug, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
pub struct BvhNode {
    /// Lower corner of its box.
    pub min: Vec3,
    /// Number of triangles in a leaf; 0 in an inner node.
    pub count: u32,
    /// Upper corner of its box.
    pub max: Vec3,
    /// The first child (the second follows it), or the leaf's first triangle.
    pub first: u32,
}

/// Where the ray enters the node's box, in units of its direction; [`f32::MAX`] where it misses it or leaves it behind.
///
/// The far side is moved out by two rounding errors, which makes the test conservative (Ize 2013).
#[inline(always)]
fn box_distance(node: &BvhNode, ray: &Ray) -> f32 {
    let to_min = (node.min - ray.origin) * ray.inverse_direction;
    let to_max = (node.max - ray.origin) * ray.inverse_direction;
    let near = to_min.min(to_max).max_element();
    let far = to_min.max(to_max).min_element() * 1.000_000_4;
    if far >= near && far >= 0.0 {
        near
    } else {
        f32::MAX
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

/// Visits the nodes that the ray meets within `reach`, nearer children first. Returns the triangle that is hit first,
/// with its distance in `reach`; or, where `any` is set, the first one found that is not a catcher.
#[inline(always)]
#[allow(clippy::manual_swap)]
fn traverse(
    nodes: &[BvhNode],
    triangles: &[Triangle],
    surface: &[u32],
    ray: &Ray,
    reach: &mut f32,
    any: bool,
) -> u32 {
    if nodes.is_empty() || box_distance(&nodes[0], ray) >= *reach {
        return NONE;
    }
    let root = nodes[0];
    if root.count > 0 {
        return visit_leaf(triangles, surface, &root, ray, reach, NONE, any);
    }
    let mut best = NONE;
    let mut stack = [0u32; STACK_SIZE];
    let mut height = 0;
    let mut pair = root.first;
    loop {
        let mut near = nodes[pair as usize];
        let mut far = nodes[pair as usize + 1];
        let mut t_near = box_distance(&near, ray);
        let mut t_far = box_distance(&far, ray);
        // Swapping in place lets the CPU predict the order; choosing each value by `if` was a third slower.
        if t_near > t_far {
            let node = near;
            near = far;
            far = node;
            let t = t_near;
            t_near = t_far;
            t_far = t;
        }
        let mut into_near = t_near < *reach;
        if into_near && near.count > 0 {
            best = visit_leaf(triangles, surface, &near, ray, reach, best, any);
            if any && best != NONE {
                return best;
            }
            into_near = false;
        }
        let mut into_far = t_far < *reach;
        if into_far && far.count > 0 {
            best = visit_leaf(triangles, surface, &far, ray, reach, best, any);
            if any && best != NONE {
                return best;
            }
            into_far = false;
        }
        if into_near {
            pair = near.first;
            if into_far {
                stack[height] = far.first;
                height += 1;
            }
        } else if into_far {
            pair = far.first;
        } else if height > 0 {
            height -= 1;
            pair = stack[height];
        } else {
            return best;
        }
    }
}

/// The nearest triangle of the leaf within `reach`, which becomes its distance; `best` where there is none. With
/// `no_catcher` set, catchers are passed over.
#[inline(always)]
fn visit_leaf(
    triangles: &[Triangle],
    surface: &[u32],
    leaf: &BvhNode,
    ray: &Ray,
    reach: &mut f32,
    best: u32,
    no_catcher: bool,
) -> u32 {
    let mut nearest = best;
    for i in leaf.first..leaf.first + leaf.count {
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
        let node = nodes[stack[height] as usize];
        if box_distance(&node, ray) < t_max {
            if node.count == 0 {
                stack[height] = node.first;
                stack[height + 1] = node.first + 1;
                height += 2;
            }
            for i in node.first..node.first + node.count {
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
        assert_eq!(core::mem::size_of::<BvhNode>(), 32);
        assert_eq!(core::mem::offset_of!(BvhNode, count), 12);
        assert_eq!(core::mem::offset_of!(BvhNode, max), 16);
        assert_eq!(core::mem::offset_of!(BvhNode, first), 28);
    }
}
