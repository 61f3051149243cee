//! Host file: the tree of boxes over a scene's triangles.

use std::collections::HashMap;
use std::time::Duration;

use bytemuck::{Pod, Zeroable};
use glam::{Vec3, Vec4};
use obvhs::BvhBuildParams;
use obvhs::bvh2::builder::build_bvh2_from_tris;
use rayon::prelude::*;

use crate::kernels::bvh::{BvhNode, LEAF, STACK_SIZE, WIDTH};
use crate::kernels::triangle::Triangle;

/// Most triangles in a leaf of a balanced tree.
const BALANCED_LEAF: usize = 4;

/// Trees of more triangles than this are improved less: it takes most of the time of building them.
const MANY: usize = 1 << 20;

/// More triangles than this in one and the same box make one leaf. The builder merges such boxes one at a time, which takes time in
/// proportion to the square of their number; and who meets one of them meets all.
const MOST_ALIKE: usize = 16;

/// Coordinates of the box of a child that is not there, where no ray goes.
const FAR: f32 = 1e18;

/// A node of the binary tree that the builder makes: an inner node with two children side by side, or a leaf with a run of triangles.
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
#[repr(C)]
struct BinaryNode {
    min: Vec3,
    /// Number of triangles in a leaf; 0 in an inner node.
    count: u32,
    max: Vec3,
    /// The first child (the second follows it), or the leaf's first triangle.
    first: u32,
}

impl BinaryNode {
    fn area(&self) -> f32 {
        half_area(self.min, self.max)
    }
}

/// A tree over triangles.
pub(super) struct BuiltTree {
    /// No traversal's stack gets higher than [`STACK_SIZE`]. Children stand behind their parents.
    pub(super) nodes: Vec<BvhNode>,
    /// The order in which its leaves want the triangles.
    pub(super) order: Vec<u32>,
    /// Of each triangle in that order, its [`Triangle::run`].
    pub(super) runs: Vec<u32>,
}

impl BuiltTree {
    fn new(binary: &[BinaryNode], order: Vec<u32>) -> Self {
        let mut runs = vec![0; order.len()];
        for leaf in binary.iter().filter(|node| node.count > 0) {
            let own = &mut runs[leaf.first as usize..][..leaf.count as usize];
            for (run, left) in own.iter_mut().rev().zip(1..) {
                *run = left;
            }
        }
        Self {
            nodes: widen(binary),
            order,
            runs,
        }
    }
}

/// The tree over the triangles, at least one and fewer than [`LEAF`].
pub(super) fn build_tree(triangles: &[Triangle]) -> BuiltTree {
    let (nodes, order) = match groups_alike(triangles) {
        None => build_of_single(triangles),
        Some(groups) => build_of_groups(triangles, &groups),
    };
    let tree = BuiltTree::new(&nodes, order);
    if stack_needed(&tree.nodes) <= STACK_SIZE {
        return tree;
    }
    let order = tree.order;
    // Many triangles at one place make a list of a tree, for there is nothing to choose between them.
    let in_order: Vec<_> = order.iter().map(|&i| triangles[i as usize]).collect();
    BuiltTree::new(&balanced_tree(&in_order), order)
}

/// A triangle's box, to the bit.
fn box_bits(t: &Triangle) -> [u32; 6] {
    let (low, high) = (t.a().min(t.b()).min(t.c()), t.a().max(t.b()).max(t.c()));
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
fn build_of_groups(triangles: &[Triangle], groups: &[Vec<u32>]) -> (Vec<BinaryNode>, Vec<u32>) {
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
fn build_of_single(triangles: &[Triangle]) -> (Vec<BinaryNode>, Vec<u32>) {
    let boxed: Vec<_> = triangles
        .iter()
        .map(|t| obvhs::triangle::Triangle {
            v0: t.a().into(),
            v1: t.b().into(),
            v2: t.c().into(),
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
    let nodes = bytemuck::cast_slice(&tree.nodes).to_vec();
    (nodes, tree.primitive_indices)
}

/// A tree that halves the triangles in the order given, so that its depth is the logarithm of their number.
fn balanced_tree(triangles: &[Triangle]) -> Vec<BinaryNode> {
    let mut nodes = vec![leaf(triangles, 0)];
    let mut unsplit = vec![(0, 0..triangles.len())];
    while let Some((node, range)) = unsplit.pop() {
        if range.len() <= BALANCED_LEAF {
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
fn leaf(triangles: &[Triangle], first: usize) -> BinaryNode {
    let (min, max) = bounds_of(triangles);
    BinaryNode {
        min,
        count: triangles.len() as u32,
        max,
        first: first as u32,
    }
}

fn bounds_of(triangles: &[Triangle]) -> (Vec3, Vec3) {
    let corners = || triangles.iter().flat_map(|t| [t.a(), t.b(), t.c()]);
    (
        corners().fold(Vec3::MAX, Vec3::min),
        corners().fold(Vec3::MIN, Vec3::max),
    )
}

fn half_area(min: Vec3, max: Vec3) -> f32 {
    let size = max - min;
    size.x * size.y + size.y * size.z + size.z * size.x
}

/// The same tree with up to four children a node. Children stand behind their parents.
fn widen(binary: &[BinaryNode]) -> Vec<BvhNode> {
    let mut tree = vec![BvhNode::EMPTY];
    let mut unfilled = vec![(0, 0)];
    while let Some((from, to)) = unfilled.pop() {
        for (child, source) in below(binary, from).into_iter().enumerate() {
            let BinaryNode {
                min,
                max,
                count,
                first,
            } = binary[source];
            tree[to].set_bounds(child, min, max);
            tree[to].children[child] = LEAF | first;
            if count == 0 {
                tree[to].children[child] = tree.len() as u32;
                unfilled.push((source, tree.len()));
                tree.push(BvhNode::EMPTY);
            }
        }
    }
    tree
}

/// What stands below node `from`: up to [`WIDTH`] nodes, the largest opened first. Of a leaf it is the leaf itself.
fn below(binary: &[BinaryNode], from: usize) -> Vec<usize> {
    let mut nodes = vec![from];
    while nodes.len() < WIDTH {
        let inner = (0..nodes.len()).filter(|i| binary[nodes[*i]].count == 0);
        let area = |i: &usize| binary[nodes[*i]].area();
        let Some(largest) = inner.max_by(|a, b| area(a).total_cmp(&area(b))) else {
            break;
        };
        let first = binary[nodes[largest]].first as usize;
        nodes[largest] = first;
        nodes.push(first + 1);
    }
    nodes
}

impl BvhNode {
    /// Without children.
    const EMPTY: Self = Self {
        min_x: Vec4::splat(FAR),
        min_y: Vec4::splat(FAR),
        min_z: Vec4::splat(FAR),
        max_x: Vec4::splat(FAR),
        max_y: Vec4::splat(FAR),
        max_z: Vec4::splat(FAR),
        children: [0; WIDTH],
    };

    fn set_bounds(&mut self, child: usize, min: Vec3, max: Vec3) {
        (self.min_x[child], self.max_x[child]) = (min.x, max.x);
        (self.min_y[child], self.max_y[child]) = (min.y, max.y);
        (self.min_z[child], self.max_z[child]) = (min.z, max.z);
    }

    /// Numbers of the children that are there.
    fn children(&self) -> impl Iterator<Item = usize> + Clone {
        let children = self.children;
        (0..WIDTH).filter(move |i| children[*i] > 0)
    }

    /// The child's box.
    fn bounds(&self, child: usize) -> (Vec3, Vec3) {
        let min = Vec3::new(self.min_x[child], self.min_y[child], self.min_z[child]);
        let max = Vec3::new(self.max_x[child], self.max_y[child], self.max_z[child]);
        (min, max)
    }

    /// The box around its children.
    pub(super) fn whole(&self) -> (Vec3, Vec3) {
        let join = |(min, max): (Vec3, Vec3), child| {
            let (low, high) = self.bounds(child);
            (min.min(low), max.max(high))
        };
        self.children().fold((Vec3::MAX, Vec3::MIN), join)
    }
}

/// The most children that wait on a traversal's stack.
fn stack_needed(tree: &[BvhNode]) -> usize {
    let mut needed = vec![0; tree.len()];
    for (index, node) in tree.iter().enumerate().rev() {
        let below = |child: usize| match node.children[child] {
            leaf if leaf >= LEAF => 0,
            inner => needed[inner as usize],
        };
        let deepest = node.children().map(below).max().unwrap_or(0);
        needed[index] = deepest + node.children().count() - 1;
    }
    needed[0]
}

/// The triangles of the leaf that begins at `first`.
fn leaf_at(triangles: &[Triangle], first: u32) -> &[Triangle] {
    let own = &triangles[first as usize..];
    &own[..own[0].run as usize]
}

/// Fits every box of a tree to what is in it again, from the leaves up.
pub(super) fn refit(tree: &mut [BvhNode], triangles: &[Triangle]) {
    for index in (0..tree.len()).rev() {
        let node = tree[index];
        for child in node.children() {
            let (min, max) = match node.children[child] {
                leaf if leaf >= LEAF => bounds_of(leaf_at(triangles, leaf - LEAF)),
                inner => tree[inner as usize].whole(),
            };
            tree[index].set_bounds(child, min, max);
        }
    }
}

/// What a ray through the root's box is expected to cost: nodes, each as much as two triangles, and triangles that it has to be tested
/// against, by the surface area heuristic.
pub(super) fn sah_cost(tree: &[BvhNode], triangles: &[Triangle]) -> f64 {
    let area = |(min, max): (Vec3, Vec3)| f64::from(half_area(min, max));
    let of_child = |node: &BvhNode, child: usize| {
        let tests = match node.children[child] {
            leaf if leaf >= LEAF => leaf_at(triangles, leaf - LEAF).len() as f64,
            _ => 2.0,
        };
        tests * area(node.bounds(child))
    };
    let all = tree
        .iter()
        .flat_map(|node| node.children().map(move |child| of_child(node, child)));
    all.sum::<f64>() / area(tree[0].whole()).max(f64::MIN_POSITIVE)
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::vec3;

    fn scattered(count: u32) -> Vec<Triangle> {
        let triangle = |i: u32| {
            let at = |k: u32| f32::from((i.wrapping_mul(k) % 1009) as u16) * 0.01;
            let v0 = vec3(at(7919), at(104_729), at(1_299_709));
            Triangle::new(v0, v0 + vec3(0.3, 0.0, 0.1), v0 + vec3(0.0, 0.2, 0.1))
        };
        (0..count).map(triangle).collect()
    }

    /// Quadratic builders take minutes for this.
    #[test]
    fn many_copies_of_a_triangle_are_one_leaf() {
        let mut triangles = scattered(500);
        let copies = 100_000;
        triangles.extend(vec![scattered(77)[76]; copies]);
        let BuiltTree { nodes, order, runs } = build_tree(&triangles);
        let mut sorted = order.clone();
        sorted.sort_unstable();
        assert!(sorted.into_iter().eq(0..triangles.len() as u32));
        let children = nodes.iter().flat_map(|n| n.children().map(move |i| (n, i)));
        let leaves: Vec<_> = children.filter(|(n, i)| n.children[*i] >= LEAF).collect();
        let run = |(node, i): &(&BvhNode, usize)| runs[(node.children[*i] - LEAF) as usize];
        assert!(leaves.iter().map(run).max().unwrap() as usize > copies);
        let mut next = vec![0; triangles.len()];
        for (node, i) in &leaves {
            let (min, max) = node.bounds(*i);
            let first = (node.children[*i] - LEAF) as usize;
            for &index in &order[first..first + runs[first] as usize] {
                next[index as usize] += 1;
                let t = &triangles[index as usize];
                assert!(t.a().cmpge(min).all() && t.a().cmple(max).all());
            }
        }
        assert!(next.iter().all(|times| *times == 1));
    }

    #[test]
    fn refitting_what_has_not_moved_changes_nothing() {
        // Of all at one place the tree is a balanced one.
        for triangles in [scattered(3000), vec![scattered(1)[0]; 3000]] {
            let BuiltTree { nodes, order, runs } = build_tree(&triangles);
            for (index, node) in nodes.iter().enumerate() {
                for child in node.children() {
                    assert!(node.children[child] as usize > index);
                }
            }
            let with_run = |(i, run): (&u32, &u32)| Triangle {
                run: *run,
                ..triangles[*i as usize]
            };
            let ordered: Vec<Triangle> = order.iter().zip(&runs).map(with_run).collect();
            let mut refitted = nodes.clone();
            refit(&mut refitted, &ordered);
            assert_eq!(refitted, nodes);
            // And what has moved is found to cost more.
            let mixed: Vec<Triangle> = (0..ordered.len())
                .map(|i| Triangle {
                    run: runs[i],
                    ..ordered[i * 1117 % ordered.len()]
                })
                .collect();
            refit(&mut refitted, &mixed);
            let ratio = sah_cost(&refitted, &mixed) / sah_cost(&nodes, &ordered);
            assert!(ratio > 2.0 || triangles[0] == triangles[1], "{ratio}");
        }
    }
}
