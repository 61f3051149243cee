//! Host file: the vertices of a mesh whose corners have more than positions.

/// The end of a chain of vertices.
const NONE: u32 = u32::MAX;

/// How many vertices of one point are compared before another equal one is made. So the work for a point in which all corners
/// differ does not grow with the square of their number.
const MOST_COMPARED: usize = 64;

/// Makes vertices of corners. Those at one point that are alike are one vertex.
pub struct Joiner<K> {
    /// The newest vertex of each point.
    newest: Vec<u32>,
    /// For each vertex the one of the same point before it.
    before: Vec<u32>,
    /// The point of each vertex.
    pub points: Vec<u32>,
    /// What distinguishes each vertex from the others of its point.
    pub kinds: Vec<K>,
}

impl<K: Copy + PartialEq> Joiner<K> {
    /// No vertices of so many points.
    pub fn new(points: usize) -> Self {
        Self {
            newest: vec![NONE; points],
            before: Vec::with_capacity(points),
            points: Vec::with_capacity(points),
            kinds: Vec::with_capacity(points),
        }
    }

    /// The vertex of a corner at a point, which is below their number.
    pub fn vertex(&mut self, point: u32, kind: K) -> u32 {
        let newest = &mut self.newest[point as usize];
        let mut vertex = *newest;
        for _ in 0..MOST_COMPARED {
            if vertex == NONE {
                break;
            }
            if self.kinds[vertex as usize] == kind {
                return vertex;
            }
            vertex = self.before[vertex as usize];
        }
        let new = self.points.len() as u32;
        self.before.push(*newest);
        *newest = new;
        self.points.push(point);
        self.kinds.push(kind);
        new
    }
}

/// The values of a list at the points of vertices; none of an empty list.
pub fn pick<T: Copy>(list: &[T], points: &[u32]) -> Vec<T> {
    match list.is_empty() {
        true => Vec::new(),
        false => points.iter().map(|&point| list[point as usize]).collect(),
    }
}
