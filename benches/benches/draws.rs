//! Host file: what one direction with its density costs, drawn from the inversion tables and from an alias table, at
//! three sizes; both are first checked to draw from the same distribution.

use glam::{UVec2, Vec2, Vec3};
use glimt_benches::{Contest, inputs::procedural_map};
use glimt_envmap_cdf::{EnvCdf, build_into, luminance_weights, required_len};
use glimt_probe::latlong::{direction_in_texel, texel_solid_angle_sr};
use glimt_sampling::uniform::{UniformSource, unit_vec2};
use glimt_sampling::xoshiro::Xoshiro128PlusPlus;

const DRAWS: u32 = 1 << 20;

fn main() {
    for size in [(512, 256), (1024, 512), (2048, 1024)].map(UVec2::from) {
        let map = procedural_map(size);
        let len = required_len(size.x, size.y).expect("a size that tables have");
        let (mut marginal, mut conditional) = (vec![0; len.marginal], vec![0; len.conditional]);
        let columns = size.x as usize;
        let row = |y: u32| luminance_weights(&map[y as usize * columns..][..columns]);
        build_into(size, row, &mut marginal, &mut conditional).expect("tables of the right length");
        let env = EnvCdf {
            size,
            marginal: &marginal,
            conditional: &conditional,
        };
        let alias = AliasTable::new(&env);
        check_same_distribution(&env, &alias);

        // The uniforms are made in both, at the same price.
        Contest::new(
            &format!("One direction with its density, {}×{}", size.x, size.y),
            "draw",
            f64::from(DRAWS),
        )
        .entry("inversion (two binary searches)", || {
            sum(|source| {
                let sample = env.sample(source.next_uvec2());
                (sample.direction, sample.pdf_sr)
            })
        })
        .entry("alias table", || sum(|source| alias.sample(source)))
        .entry("the uniforms alone", || {
            sum(|source| (unit_vec2(source.next_uvec2()).extend(1.0), 1.0))
        })
        .run(21);
    }
}

/// Draws and adds up, so that nothing is left out.
fn sum(mut draw: impl FnMut(&mut Xoshiro128PlusPlus) -> (Vec3, f32)) -> Vec3 {
    let mut source = Xoshiro128PlusPlus::stream(1, 2, 3);
    let mut total = Vec3::ZERO;
    for _ in 0..DRAWS {
        let (direction, pdf_sr) = draw(&mut source);
        total += direction * pdf_sr;
    }
    total
}

/// Walker's alias table in Vose's construction (1991), one entry a texel, the densities beside it.
struct AliasTable {
    size: UVec2,
    entries: Vec<AliasEntry>,
    pdf_sr: Vec<f32>,
}

#[derive(Clone, Copy)]
struct AliasEntry {
    /// Of the 2³² words, how many stay with this texel.
    threshold: u32,
    alias: u32,
}

impl AliasTable {
    /// A table of the same texel probabilities as `env`'s.
    fn new(env: &EnvCdf<'_>) -> Self {
        let size = env.size;
        let count = (size.x * size.y) as usize;
        let texel = |i: usize| UVec2::new(i as u32 % size.x, i as u32 / size.x);
        let pdf_sr: Vec<f32> = (0..count).map(|i| env.texel_pdf_sr(texel(i))).collect();
        let mass = |i: usize| f64::from(pdf_sr[i] * texel_solid_angle_sr(texel(i).y, size));
        let total: f64 = (0..count).map(mass).sum();
        let mut scaled: Vec<f64> = (0..count).map(|i| mass(i) * count as f64 / total).collect();
        let (mut small, mut large): (Vec<usize>, Vec<usize>) =
            (0..count).partition(|i| scaled[*i] < 1.0);
        let stay = |i: usize| AliasEntry {
            threshold: u32::MAX,
            alias: i as u32,
        };
        let mut entries: Vec<AliasEntry> = (0..count).map(stay).collect();
        while let (Some(low), Some(&high)) = (small.pop(), large.last()) {
            entries[low] = AliasEntry {
                threshold: (scaled[low] * 4_294_967_296.0) as u32,
                alias: high as u32,
            };
            scaled[high] -= 1.0 - scaled[low];
            if scaled[high] < 1.0 {
                large.pop();
                small.push(high);
            }
        }
        Self {
            size,
            entries,
            pdf_sr,
        }
    }

    fn pick(&self, u: UVec2) -> u32 {
        let i = ((u64::from(u.x) * self.entries.len() as u64) >> 32) as u32;
        let entry = self.entries[i as usize];
        if u.y < entry.threshold {
            i
        } else {
            entry.alias
        }
    }

    fn sample(&self, source: &mut Xoshiro128PlusPlus) -> (Vec3, f32) {
        let index = self.pick(source.next_uvec2());
        let texel = UVec2::new(index % self.size.x, index / self.size.x);
        let inside: Vec2 = unit_vec2(source.next_uvec2());
        let direction = direction_in_texel(texel, self.size, inside);
        (direction, self.pdf_sr[index as usize])
    }
}

/// Panics unless both draw from one distribution: a chi² test of two samples over 32×16 blocks of texels.
fn check_same_distribution(env: &EnvCdf<'_>, alias: &AliasTable) {
    let count = |texel_of: &mut dyn FnMut() -> UVec2| {
        let mut counts = vec![0_u32; 512];
        for _ in 0..DRAWS {
            let texel = texel_of() * UVec2::new(32, 16) / env.size;
            counts[(texel.y * 32 + texel.x) as usize] += 1;
        }
        counts
    };
    let mut source = Xoshiro128PlusPlus::stream(4, 5, 6);
    let by_inversion = count(&mut || env.sample(source.next_uvec2()).texel);
    let mut source = Xoshiro128PlusPlus::stream(7, 8, 9);
    let by_alias = count(&mut || {
        let index = alias.pick(source.next_uvec2());
        UVec2::new(index % env.size.x, index / env.size.x)
    });
    // Cells with few draws are pooled into one.
    let mut cells: Vec<(f64, f64)> = Vec::new();
    let mut pool = (0.0, 0.0);
    for (a, b) in by_inversion.iter().zip(&by_alias) {
        let (a, b) = (f64::from(*a), f64::from(*b));
        if a + b >= 20.0 {
            cells.push((a, b));
        } else {
            pool = (pool.0 + a, pool.1 + b);
        }
    }
    if pool.0 + pool.1 >= 20.0 {
        cells.push(pool);
    }
    let chi2: f64 = cells.iter().map(|(a, b)| (a - b).powi(2) / (a + b)).sum();
    let degrees = (cells.len() - 1) as f64;
    // Wilson and Hilferty 1931: the cube root of chi²/k is nearly normal.
    let z =
        ((chi2 / degrees).cbrt() - (1.0 - 2.0 / (9.0 * degrees))) / (2.0 / (9.0 * degrees)).sqrt();
    assert!(
        z < 3.1,
        "the tables disagree: chi² {chi2:.1} with {degrees} degrees of freedom"
    );
    println!(
        "\nchi² of inversion against alias: {chi2:.1} with {degrees} degrees of freedom, z = {z:.2}"
    );
}
