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
