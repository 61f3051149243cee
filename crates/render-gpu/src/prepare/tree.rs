//! Host file: the tree of boxes over a scene's triangles.

use std::time::Duration;

use glam::Vec3;
use obvhs::BvhBuildParams;
use obvhs::bvh2::builder::build_bvh2_from_tris;

use crate::kernels::bvh::{BvhNode, STACK_SIZE};
use crate::kernels::triangle::Triangle;

/// Most triangles in a leaf of a balanced tree.
const LEAF: usize = 4;

/// The tree over the triangles (at least one), and the order in which its leaves want them. It is never deeper than the
/// traversal's stack.
pub(super) fn build_tree(triangles: &[Triangle]) -> (Vec<BvhNode>, Vec<u32>) {
    let boxed: Vec<_> = triangles
        .iter()
        .map(|t| obvhs::triangle::Triangle {
            v0: t.v0.into(),
            v1: t.v1.into(),
            v2: t.v2.into(),
        })
        .collect();
    // Without spatial splits, so that every triangle is stored once.
    let params = BvhBuildParams {
        pre_split: false,
        ..BvhBuildParams::slow_build()
    };
    let mut tree = build_bvh2_from_tris(&boxed, params, &mut Duration::default());
    tree.reorder_in_stack_traversal_order();
    let nodes = if tree.depth(0) <= STACK_SIZE {
        bytemuck::cast_slice(&tree.nodes).to_vec()
    } else {
        // Many triangles at one place make a list of a tree, for there is nothing to choose between them.
        let in_order: Vec<_> = tree
            .primitive_indices
            .iter()
            .map(|&i| triangles[i as usize])
            .collect();
        balanced_tree(&in_order)
    };
    (nodes, tree.primitive_indices)
}

/// A tree that halves the triangles in the order given, so that its depth is the logarithm of their number.
fn balanced_tree(triangles: &[Triangle]) -> Vec<BvhNode> {
    let mut nodes = vec![leaf(triangles, 0)];
    let mut unsplit = vec![(0, 0..triangles.len())];
    while let Some((node, range)) = unsplit.pop() {
        if range.len() <= LEAF {
            continue;
        }
        let middle = range.start + range.len() / 2;
        let first = nodes.len();
        nodes[node].count = 0;
        nodes[node].first = first as u32;
        for (child, half) in [range.start..middle, middle..range.end]
            .into_iter()
            .enumerate()
        {
            nodes.push(leaf(&triangles[half.clone()], half.start));
            unsplit.push((first + child, half));
        }
    }
    nodes
}

/// A leaf around `triangles`, of which the first is number `first`.
fn leaf(triangles: &[Triangle], first: usize) -> BvhNode {
    let corners = || triangles.iter().flat_map(|t| [t.v0, t.v1, t.v2]);
    BvhNode {
        min: corners().fold(Vec3::MAX, Vec3::min),
        count: triangles.len() as u32,
        max: corners().fold(Vec3::MIN, Vec3::max),
        first: first as u32,
    }
}

/// Fits every box of a tree to what is in it again, from the leaves up.
///
/// Children stand behind their parents.
pub(super) fn refit(nodes: &mut [BvhNode], triangles: &[Triangle]) {
    for index in (0..nodes.len()).rev() {
        let BvhNode { count, first, .. } = nodes[index];
        let at = first as usize;
        (nodes[index].min, nodes[index].max) = if count == 0 {
            let [a, b] = [nodes[at], nodes[at + 1]];
            (a.min.min(b.min), a.max.max(b.max))
        } else {
            let fitted = leaf(&triangles[at..at + count as usize], at);
            (fitted.min, fitted.max)
        };
    }
}

/// What a ray through the root's box is expected to cost: boxes and triangles that it has to be tested against, by the
/// surface area heuristic.
pub(super) fn sah_cost(nodes: &[BvhNode]) -> f64 {
    let area = |node: &BvhNode| {
        let size = (node.max - node.min).as_dvec3();
        size.x * size.y + size.y * size.z + size.z * size.x
    };
    let weighted = nodes.iter().map(|node| match node.count {
        0 => 2.0 * area(node),
        triangles => f64::from(triangles) * area(node),
    });
    weighted.sum::<f64>() / area(&nodes[0]).max(f64::MIN_POSITIVE)
}

#[cfg(test)]
mod tests {
    use super::*;
    use bytemuck::Zeroable;
    use glam::vec3;

    fn scattered(count: u32) -> Vec<Triangle> {
        let triangle = |i: u32| {
            let at = |k: u32| f32::from((i.wrapping_mul(k) % 1009) as u16) * 0.01;
            let v0 = vec3(at(7919), at(104_729), at(1_299_709));
            Triangle {
                v0,
                v1: v0 + vec3(0.3, 0.0, 0.1),
                v2: v0 + vec3(0.0, 0.2, 0.1),
                ..Zeroable::zeroed()
            }
        };
        (0..count).map(triangle).collect()
    }

    #[test]
    fn refitting_what_has_not_moved_changes_nothing() {
        // Of all at one place the tree is a balanced one.
        for triangles in [scattered(3000), vec![scattered(1)[0]; 3000]] {
            let (nodes, order) = build_tree(&triangles);
            for (index, node) in nodes.iter().enumerate() {
                assert!(node.count > 0 || node.first as usize > index);
            }
            let ordered: Vec<Triangle> = order.iter().map(|&i| triangles[i as usize]).collect();
            let mut refitted = nodes.clone();
            refit(&mut refitted, &ordered);
            assert_eq!(refitted, nodes);
            // And what has moved is found to cost more.
            let mixed: Vec<Triangle> = (0..ordered.len())
                .map(|i| ordered[i * 1117 % ordered.len()])
                .collect();
            refit(&mut refitted, &mixed);
            let ratio = sah_cost(&refitted) / sah_cost(&nodes);
            assert!(ratio > 2.0 || triangles[0] == triangles[1], "{ratio}");
        }
    }
}
