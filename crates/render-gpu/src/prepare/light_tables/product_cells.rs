//! Host file: a light map in 32 × 16 cells of nearly equal area, for the method `product`.

use std::f64::consts::PI;

use glam::{DVec3, UVec2};
use glimt_envmap_cdf::{BuildError, build_row_into};
use glimt_probe::latlong::{texel_direction, texel_solid_angle_sr, uv_to_direction};
use glimt_sampling::luminance;
use rayon::prelude::*;

use super::{Light, LightTable};
use crate::kernels::product::{
    CELL_WORDS, COLUMNS, ROWS, first_column, first_edge, first_word, words,
};
use crate::methods::product::CELLS;

/// Where rows of cells begin, the cells, then the edges of each cell's texel rows: see [`first_word`].
pub(super) const TABLE: LightTable = LightTable {
    name: CELLS,
    first: first_word,
    words,
    build,
};

/// A cell that has been summed up.
struct Cell {
    words: [u32; CELL_WORDS as usize],
    /// Edges of its texel rows.
    edges: Vec<u32>,
}

fn build(light: &mut Light<'_>, own: &mut [u32]) -> Result<(), BuildError> {
    let (size, light) = (light.size, &*light);
    let starts: Vec<u32> = (0..=ROWS).map(|row| first_row(row, size.y)).collect();
    own[..starts.len()].copy_from_slice(&starts);
    let cells = (0..ROWS * COLUMNS)
        .into_par_iter()
        .map(|cell| {
            let (column, row) = (cell % COLUMNS, (cell / COLUMNS) as usize);
            let columns = [column, column + 1].map(|c| first_column(c, size.x));
            sum_up(light, columns, [starts[row], starts[row + 1]])
        })
        .collect::<Result<Vec<Cell>, BuildError>>()?;
    for (number, cell) in (0..).zip(&cells) {
        let (column, row) = (number % COLUMNS, number / COLUMNS);
        let at = (ROWS + 1 + number * CELL_WORDS) as usize;
        own[at..][..cell.words.len()].copy_from_slice(&cell.words);
        let at = first_edge(column, row, starts[row as usize], size.y) as usize;
        own[at..][..cell.edges.len()].copy_from_slice(&cell.edges);
    }
    Ok(())
}

/// The first texel row of row `row` of cells: equal steps in cos θ.
fn first_row(row: u32, height: u32) -> u32 {
    let cos = 1.0 - 2.0 * f64::from(row) / f64::from(ROWS);
    (f64::from(height) * cos.acos() / PI).round() as u32
}

fn sum_up(
    light: &Light<'_>,
    [left, right]: [u32; 2],
    [top, bottom]: [u32; 2],
) -> Result<Cell, BuildError> {
    let size = light.size;
    let mut edges = vec![0; (bottom - top) as usize + 1];
    let (mut flux, mut towards, mut weights) = (0.0, DVec3::ZERO, Vec::new());
    for y in top..bottom {
        let area = f64::from(texel_solid_angle_sr(y, size));
        let mut of_row = 0.0;
        for x in left..right {
            let texel = light.texels[(y * size.x + x) as usize];
            let own = f64::from(luminance(texel.truncate())) * area;
            of_row += own;
            towards += texel_direction(UVec2::new(x, y), size).as_dvec3() * own;
        }
        weights.push(of_row as f32);
        flux += of_row;
    }
    if left < right && top < bottom {
        build_row_into(weights, &mut edges)?;
    }
    let corners = corners([left, right], [top, bottom], size);
    let middle: DVec3 = corners.iter().sum();
    let mean = towards.try_normalize().or(middle.try_normalize());
    let mean = mean.unwrap_or(DVec3::Z);
    let angle = |corner: &DVec3| mean.dot(*corner).clamp(-1.0, 1.0).acos();
    let radius = corners.iter().map(angle).fold(0.0, f64::max);
    let direction = mean.as_vec3();
    let values = [
        direction.x,
        direction.y,
        direction.z,
        flux as f32,
        radius as f32,
    ];
    Ok(Cell {
        words: values.map(f32::to_bits),
        edges,
    })
}

/// Points of a cell's edge: its corners, and the middles between them.
fn corners(columns: [u32; 2], rows: [u32; 2], size: UVec2) -> Vec<DVec3> {
    let mean = |[a, b]: [u32; 2], n: u32| {
        let [a, b] = [a, b].map(|x| f64::from(x) / f64::from(n));
        [a, 0.5 * (a + b), b]
    };
    let (us, vs) = (mean(columns, size.x), mean(rows, size.y));
    let each = us.iter().flat_map(|u| vs.iter().map(move |v| (*u, *v)));
    each.map(|(u, v)| uv_to_direction(glam::DVec2::new(u, v).as_vec2()).as_dvec3())
        .collect()
}
