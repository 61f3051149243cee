//! Host file: cells of light maps against sums over all texels in f64, and what is drawn of them against its density.

use glam::{DVec3, UVec2, Vec3, Vec4};
use glimt_light_cells::{
    BuildError, CELLS, COLUMNS, CellSurface, LightCells, build_into, field, required_words,
};
use glimt_probe::latlong::{direction_in_texel, texel_solid_angle_sr};
use glimt_sampling::uniform::{UniformSource, unit_vec2};
use glimt_sampling::{Xoshiro128PlusPlus, luminance};
use glimt_statistics::stats::{Verdict, chi_square, sidak};

/// A map with its table.
struct Map {
    name: &'static str,
    size: UVec2,
    texels: Vec<Vec4>,
    words: Vec<u32>,
}

impl Map {
    fn new(name: &'static str, (x, y): (u32, u32), texel: impl Fn(u32, u32) -> Vec3) -> Map {
        let size = UVec2::new(x, y);
        let places = (0..y).flat_map(|row| (0..x).map(move |column| (column, row)));
        let texels: Vec<Vec4> = places
            .map(|(column, row)| texel(column, row).extend(7.0))
            .collect();
        let mut words = vec![0; required_words(size).unwrap()];
        let row = |y: u32| &texels[(y * x) as usize..][..x as usize];
        build_into(size, row, &mut words).unwrap();
        Map {
            name,
            size,
            texels,
            words,
        }
    }

    /// Its cells, behind other words.
    fn with_cells<T>(&self, then: impl FnOnce(LightCells<'_>) -> T) -> T {
        let mut words = vec![u32::MAX; 3];
        words.extend(&self.words);
        then(LightCells {
            size: self.size,
            words: &words,
            start: 3,
        })
    }

    fn places(&self) -> impl Iterator<Item = UVec2> {
        let size = self.size;
        (0..size.x * size.y).map(move |i| UVec2::new(i % size.x, i / size.x))
    }

    fn radiance(&self, texel: UVec2) -> Vec3 {
        self.texels[(texel.y * self.size.x + texel.x) as usize].truncate()
    }
}

/// Maps: an uneven one with a sun, a constant one, suns at a pole and at the seam, tiny and odd ones, one with black rows, a black one.
fn maps() -> Vec<Map> {
    let grey = Vec3::splat;
    vec![
        Map::new("uneven", (100, 50), |x, y| match (x, y) {
            (71, 11) => Vec3::new(900.0, 700.0, 300.0),
            _ => Vec3::new(0.2, 0.3, 0.5) + grey(((x * 7 + y * 3) % 11) as f32),
        }),
        Map::new("constant", (64, 32), |_, _| grey(2.0)),
        Map::new("pole", (64, 32), |x, y| {
            grey(if (x, y) == (0, 0) { 5.0 } else { 0.0 })
        }),
        Map::new("seam", (64, 32), |x, y| {
            grey(if (x, y) == (63, 16) { 1e6 } else { 1.0 })
        }),
        Map::new("one texel", (1, 1), |_, _| grey(3.0)),
        Map::new("six texels", (3, 2), |x, y| grey((x + 2 * y) as f32)),
        Map::new("half black", (48, 24), |x, y| {
            grey(if y < 12 { (1 + x % 5) as f32 } else { 0.0 })
        }),
        Map::new("black", (8, 4), |_, _| grey(0.0)),
    ]
}

/// The mean of directions over a texel, by a fine grid in both angles.
fn mean_direction(texel: UVec2, size: UVec2) -> DVec3 {
    const GRID: u32 = 64;
    let place = |first: u32, i: u32, n: u32| {
        (f64::from(first) + (f64::from(i) + 0.5) / f64::from(GRID)) / f64::from(n)
    };
    let (mut level, mut z, mut area) = (0.0, 0.0, 0.0);
    let (mut x, mut y) = (0.0, 0.0);
    for i in 0..GRID {
        let theta = std::f64::consts::PI * place(texel.y, i, size.y);
        let phi = std::f64::consts::PI * (1.0 - 2.0 * place(texel.x, i, size.x));
        level += theta.sin() * theta.sin();
        z += theta.cos() * theta.sin();
        area += theta.sin();
        x += phi.cos() / f64::from(GRID);
        y += phi.sin() / f64::from(GRID);
    }
    DVec3::new(level * x, level * y, z) / area
}

#[test]
fn sums_are_those_over_the_texels() {
    for map in maps() {
        map.with_cells(|cells| {
            let mut sums = vec![[0.0_f64; 18]; CELLS as usize];
            let mut largest = [0.0_f64; 18];
            for texel in map.places() {
                let area = f64::from(texel_solid_angle_sr(texel.y, map.size));
                let (l, d) = (
                    map.radiance(texel).as_dvec3(),
                    mean_direction(texel, map.size),
                );
                let y = f64::from(luminance(map.radiance(texel)));
                let own = &mut sums[cells.cell_of(texel) as usize];
                let mut add = |list: u32, value: f64| own[list as usize] += value * area;
                add(field::FLUX, y);
                add(field::SQUARE, y * y);
                add(field::SOLID_ANGLE, 1.0);
                for channel in 0..3 {
                    add(field::RADIANCE + channel, l[channel as usize]);
                    for axis in 0..3 {
                        let list = field::MOMENT + 3 * channel + axis;
                        add(list, l[channel as usize] * d[axis as usize]);
                    }
                }
            }
            for own in &sums {
                for (largest, value) in largest.iter_mut().zip(own) {
                    *largest = largest.max(value.abs());
                }
            }
            for (cell, own) in (0..).zip(&sums) {
                for list in (0..field::DIRECTION).chain([field::SOLID_ANGLE]) {
                    let (found, sum) = (f64::from(cells.value(list, cell)), own[list as usize]);
                    // At a pole the grid of angles is good to 6·10⁻⁵.
                    let tolerance = 1e-4 * sum.abs() + 1e-6 * largest[field::FLUX as usize];
                    assert!(
                        (found - sum).abs() <= tolerance + 1e-6 * largest[list as usize],
                        "{}, cell {cell}, list {list}: {found} {sum}",
                        map.name
                    );
                }
            }
        });
    }
}

#[test]
fn cells_have_nearly_equal_areas() {
    let map = Map::new("usual", (1024, 512), |_, _| Vec3::ONE);
    map.with_cells(|cells| {
        for cell in 0..CELLS {
            let share = cells.value(field::SOLID_ANGLE, cell) * CELLS as f32
                / (4.0 * core::f32::consts::PI);
            assert!((share - 1.0).abs() < 0.05, "cell {cell}: {share}");
        }
    });
}

#[test]
fn within_a_cell_probabilities_sum_to_one() {
    for map in maps() {
        map.with_cells(|cells| {
            let mut sums = vec![0.0; CELLS as usize];
            for texel in map.places() {
                let cell = cells.cell_of(texel);
                let pmf = f64::from(cells.pmf_in_cell(texel, cell));
                assert_eq!(
                    pmf > 0.0,
                    map.radiance(texel).x > 0.0,
                    "{} {texel}",
                    map.name
                );
                sums[cell as usize] += pmf;
            }
            for (cell, sum) in sums.iter().enumerate() {
                let fits = *sum == 0.0 || (sum - 1.0).abs() < 1e-5;
                assert!(fits, "{}, cell {cell}: {sum}", map.name);
            }
        });
    }
}

/// Texels that are drawn of a cell, held against a probability.
fn judge(map: &Map, cell: u32, pmf: impl Fn(UVec2) -> f32, alpha: f64) -> Verdict {
    const DRAWS: u32 = 100_000;
    map.with_cells(|cells| {
        let own: Vec<UVec2> = map.places().filter(|t| cells.cell_of(*t) == cell).collect();
        let mut counts = vec![0; own.len()];
        let mut random = Xoshiro128PlusPlus::stream(5, cell, 2);
        for _ in 0..DRAWS {
            let drawn = cells.sample(cell, random.next_uvec2());
            assert_eq!(drawn.pmf, cells.pmf_in_cell(drawn.texel, cell));
            let at = own.iter().position(|texel| *texel == drawn.texel);
            counts[at.expect("a texel of the cell")] += 1;
        }
        let expected: Vec<f64> = own
            .iter()
            .map(|texel| f64::from(pmf(*texel)) * f64::from(DRAWS))
            .collect();
        chi_square(&counts, &expected, alpha)
    })
}

#[test]
fn texels_are_drawn_by_their_probability() {
    let maps = maps();
    let alpha = sidak(0.01, 4 * maps.len());
    for map in &maps {
        for cell in [3, 117, 250, 511] {
            let flux = map.with_cells(|cells| cells.value(field::FLUX, cell));
            if flux > 0.0 {
                let pmf = |texel| map.with_cells(|cells| cells.pmf_in_cell(texel, cell));
                judge(map, cell, pmf, alpha)
                    .unwrap_or_else(|why| panic!("{}, cell {cell}: {why}", map.name));
            }
        }
    }
}

/// The test above can fail: an even probability is noticed in an uneven cell.
#[test]
fn a_wrong_probability_is_noticed() {
    let map = &maps()[0];
    let count = map.with_cells(|cells| map.places().filter(|t| cells.cell_of(*t) == 117).count());
    assert!(judge(map, 117, |_| 1.0 / count as f32, 0.01).is_err());
}

/// Directions of a cell lie within its radius, and a surface sees none of a cell that it calls dead, and all of one that it calls full.
#[test]
fn what_a_surface_sees_is_bounded() {
    let mut random = Xoshiro128PlusPlus::stream(3, 1, 4);
    let mut direction = || {
        let u = unit_vec2(random.next_uvec2());
        glimt_probe::latlong::uv_to_direction(u)
    };
    for map in maps() {
        map.with_cells(|cells| {
            let surfaces: Vec<CellSurface> = (0..40)
                .map(|_| CellSurface::new(direction(), direction(), 0.5, 0.5, 30.0, 1.0, 0.0))
                .collect();
            let size = map.size;
            for texel in map.places() {
                let cell = cells.cell_of(texel);
                let list = |list| cells.value(list, cell);
                let d = Vec3::new(
                    list(field::DIRECTION),
                    list(field::DIRECTION + 1),
                    list(field::DIRECTION + 2),
                );
                for corner in [
                    [0.0, 0.0],
                    [0.999, 0.0],
                    [0.5, 0.5],
                    [0.0, 0.999],
                    [0.999, 0.999],
                ] {
                    let w = direction_in_texel(texel, size, corner.into());
                    let angle = d.cross(w).length().atan2(d.dot(w));
                    assert!(angle <= list(field::RADIUS) + 1e-4, "{} {texel}", map.name);
                    for surface in &surfaces {
                        let terms = cells.terms(surface, cell / 4);
                        let (live, full) = (
                            terms.live[(cell % 4) as usize],
                            terms.full[(cell % 4) as usize],
                        );
                        let cosine = surface.normal.dot(w);
                        assert!(live == 1.0 || cosine <= 1e-6, "{} {texel}", map.name);
                        assert!(full == 0.0 || cosine >= -1e-6, "{} {texel}", map.name);
                    }
                }
            }
        });
    }
}

/// Even light is spread over its cell, a lamp is not, and a lobe is seen as sharp as it is where a lamp makes most of the light.
#[test]
fn light_lies_as_far_apart_as_it_does() {
    let lamp = UVec2::new(40, 30);
    let even = Map::new("even", (256, 128), |_, _| Vec3::ONE);
    let map = Map::new("a lamp", (256, 128), |x, y| {
        Vec3::splat(if UVec2::new(x, y) == lamp { 1e4 } else { 1.0 })
    });
    even.with_cells(|cells| {
        for cell in COLUMNS..CELLS - COLUMNS {
            let share = cells.value(field::SPREAD, cell) / cells.value(field::RADIUS, cell);
            assert!((0.8..=1.0).contains(&share), "cell {cell}: {share}");
        }
    });
    map.with_cells(|cells| {
        let cell = cells.cell_of(lamp);
        let spread = cells.value(field::SPREAD, cell);
        assert!(spread < 0.2 * cells.value(field::RADIUS, cell), "{spread}");
        let towards = direction_in_texel(lamp, map.size, [0.5, 0.5].into());
        for (exponent, off) in [(50.0, 0.3_f32), (500.0, 0.1), (2000.0, 0.05)] {
            // The eye stands where the lamp's reflection is seen `off` radians beside its middle.
            let normal = (towards + Vec3::new(0.1, 0.2, 0.3)).normalize();
            let mirrored = 2.0 * normal.dot(towards) * normal - towards;
            let aside = mirrored.cross(normal).normalize();
            let wo = (mirrored * off.cos() + aside * off.sin()).normalize();
            let surface = CellSurface::new(normal, wo, 0.0, 1.0, exponent, 1.0, 0.0);
            let brdf = glimt_brdf::BlinnPhong {
                diffuse: Vec3::ZERO,
                specular: Vec3::ONE,
                exponent,
            };
            let frame = glimt_sampling::math::ShadingFrame::from_normal(normal);
            let (wo, wi) = (frame.to_local(wo), frame.to_local(towards));
            let wanted = brdf.eval(wo, wi).x * wi.z;
            let found = cells.terms(&surface, cell / 4).lobe[(cell % 4) as usize];
            assert!(
                (found / wanted - 1.0).abs() < 0.15,
                "e = {exponent}: {found}, not {wanted}"
            );
        }
    });
}

/// The sum of the lobe over the cells is near its integral under a smooth light.
#[test]
fn lobes_add_up_to_what_they_reflect() {
    let map = Map::new("constant", (256, 128), |_, _| Vec3::ONE);
    map.with_cells(|cells| {
        for (exponent, height) in [(5.0, 0.9), (50.0, 0.8), (500.0, 0.9)] {
            let side = libm::sqrtf(1.0 - height * height);
            let wo = Vec3::new(side, 0.0, height);
            let surface = CellSurface::new(Vec3::Z, wo, 0.0, 1.0, exponent, 1.0, 0.0);
            let sum: f32 = (0..CELLS / 4)
                .map(|quad| {
                    (cells.terms(&surface, quad).lobe * cells.quad(field::FLUX, quad)).element_sum()
                })
                .sum();
            let brdf = glimt_brdf::BlinnPhong {
                diffuse: Vec3::ZERO,
                specular: Vec3::ONE,
                exponent,
            };
            let whole: f64 = map
                .places()
                .map(|texel| {
                    let w = direction_in_texel(texel, map.size, glam::Vec2::splat(0.5));
                    let area = texel_solid_angle_sr(texel.y, map.size);
                    f64::from(brdf.eval(wo, w).x * w.z.max(0.0) * area)
                })
                .sum();
            let ratio = f64::from(sum) / whole;
            assert!((ratio - 1.0).abs() < 0.25, "e = {exponent}: {ratio}");
        }
    });
}

#[test]
fn wrong_sizes_are_refused() {
    let rows = [[Vec4::ONE; 4]; 2];
    let row = |y: u32| &rows[y as usize][..];
    let size = UVec2::new(4, 2);
    assert_eq!(
        build_into(UVec2::new(0, 2), row, &mut []),
        Err(BuildError::Size(UVec2::new(0, 2)))
    );
    let expected = required_words(size).unwrap();
    assert_eq!(
        build_into(size, row, &mut [0; 9]),
        Err(BuildError::Len { expected, found: 9 })
    );
    let short = |y: u32| &rows[y as usize][..3];
    assert_eq!(
        build_into(size, short, &mut vec![0; expected]),
        Err(BuildError::Len {
            expected: 4,
            found: 3
        })
    );
}
