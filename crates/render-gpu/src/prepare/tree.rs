//! Host file: the tree of boxes over a scene's triangles.

use std::collections::HashMap;
use std::time::Duration;

use glam::Vec3;
use obvhs::BvhBuildParams;
use obvhs::bvh2::builder::build_bvh2_from_tris;
use rayon::prelude::*;

use crate::kernels::bvh::{BvhNode, STACK_SIZE};
use crate::kernels::triangle::Triangle;

/// Most triangles in a leaf of a balanced tree.
const LEAF: usize = 4;

/// Trees of more triangles than this are improved less: it takes most of the time of building them.
const MANY: usize = 1 << 20;

/// More triangles than this in one and the same box make one leaf. The builder merges such boxes one at a time, which takes time in
/// proportion to the square of their number; and who meets one of them meets all.
const MOST_ALIKE: usize = 16;

/// The tree over the triangles (at least one), and the order in which its leaves want them. It is never deeper than the
/// traversal's stack.
pub(super) fn build_tree(triangles: &[Triangle]) -> (Vec<BvhNode>, Vec<u32>) {
    match groups_alike(triangles) {
        None => build_of_single(triangles),
        Some(groups) => build_of_groups(triangles, &groups),
    }
}

/// A triangle's box, to the bit.
fn box_bits(t: &Triangle) -> [u32; 6] {
    let (low, high) = (t.v0.min(t.v1).min(t.v2), t.v0.max(t.v1).max(t.v2));
    [low.x, low.y, low.z, high.x, high.y, high.z].map(f32::to_bits)
}

/// The triangles of each box, in order; `None` where no box has more than [`MOST_ALIKE`].
fn groups_alike(triangles: &[Triangle]) -> Option<Vec<Vec<u32>>> {
    // Which boxes are alike shows in hashes, which are sorted faster.
    let hash = |t: &Triangle| {
        let mix = |hash: u64, word: u32| {
            (hash ^ u64::from(word))
                .wrapping_mul(0x9e37_79b9_7f4a_7c15)
                .rotate_left(29)
        };
        box_bits(t).into_iter().fold(0, mix)
    };
    let mut hashes: Vec<u64> = triangles.par_iter().map(hash).collect();
    hashes.par_sort_unstable();
    if !hashes
        .windows(MOST_ALIKE + 1)
        .any(|w| w[0] == w[MOST_ALIKE])
    {
        return None;
    }
    let mut places = HashMap::new();
    let mut groups: Vec<Vec<u32>> = Vec::new();
    for (index, triangle) in (0..).zip(triangles) {
        let place = *places.entry(box_bits(triangle)).or_insert(groups.len());
        match groups.get_mut(place) {
            Some(group) => group.push(index),
            None => groups.push(vec![index]),
        }
    }
    Some(groups)
}

/// A tree over the first triangle of each group, whose leaves hold all of it.
fn build_of_groups(triangles: &[Triangle], groups: &[Vec<u32>]) -> (Vec<BvhNode>, Vec<u32>) {
    let first = |group: &Vec<u32>| triangles[group[0] as usize];
    let firsts: Vec<Triangle> = groups.iter().map(first).collect();
    let (mut nodes, order) = build_of_single(&firsts);
    let mut whole = Vec::with_capacity(triangles.len());
    for leaf in nodes.iter_mut().filter(|node| node.count > 0) {
        let start = whole.len();
        let range = leaf.first as usize..(leaf.first + leaf.count) as usize;
        for group in &order[range] {
            whole.extend_from_slice(&groups[*group as usize]);
        }
        leaf.first = start as u32;
        leaf.count = (whole.len() - start) as u32;
    }
    (nodes, whole)
}

/// A tree over triangles of which few are alike.
fn build_of_single(triangles: &[Triangle]) -> (Vec<BvhNode>, Vec<u32>) {
    let boxed: Vec<_> = triangles
        .iter()
        .map(|t| obvhs::triangle::Triangle {
            v0: t.v0.into(),
            v1: t.v1.into(),
            v2: t.v2.into(),
        })
        .collect();
    let slow = BvhBuildParams::slow_build();
    // Without spatial splits, so that every triangle is stored once.
    let params = match triangles.len() <= MANY {
        true => BvhBuildParams {
            pre_split: false,
            ..slow
        },
        false => BvhBuildParams {
            pre_split: false,
            reinsertion_batch_ratio: slow.reinsertion_batch_ratio * 0.2,
            ..slow
        },
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

    /// Quadratic builders take minutes for this.
    #[test]
    fn many_copies_of_a_triangle_are_one_leaf() {
        let mut triangles = scattered(500);
        let copies = 100_000;
        triangles.extend(vec![scattered(77)[76]; copies]);
        let (nodes, order) = build_tree(&triangles);
        let mut sorted = order.clone();
        sorted.sort_unstable();
        assert!(sorted.into_iter().eq(0..triangles.len() as u32));
        let leaves: Vec<&BvhNode> = nodes.iter().filter(|node| node.count > 0).collect();
        let largest = leaves.iter().max_by_key(|leaf| leaf.count).unwrap();
        assert!(largest.count as usize > copies);
        let mut next = vec![0; triangles.len()];
        for node in leaves {
            let range = node.first as usize..(node.first + node.count) as usize;
            for &index in &order[range.clone()] {
                next[index as usize] += 1;
                let t = &triangles[index as usize];
                assert!(t.v0.cmpge(node.min).all() && t.v0.cmple(node.max).all());
            }
        }
        assert!(next.iter().all(|times| *times == 1));
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
