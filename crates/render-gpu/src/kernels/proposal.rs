//! Shared file: where a group of hits looks for light: a density over directions, made of weights of light cells and of the lobe's own,
//! with a function near the integrand whose integral is known.

use glam::{UVec2, Vec3, Vec4};
use glimt_light_cells::{CellSurface, CellTerms, LightCells, QUADS, ROWS, field};
use glimt_probe::latlong::{direction_in_texel, texel_solid_angle_sr};
use glimt_sampling::hash::hash2;
use glimt_sampling::uniform::{unit_f32, unit_vec2};

use super::groups::Representative;

/// The share of the weights that goes to all cells alike that a surface may see, by their light alone.
const DEFENCE: f32 = 1e-3;

/// Quads of a row of cells.
const ROW_QUADS: usize = (QUADS / ROWS) as usize;

/// The greatest f32 below 1.
const BELOW_ONE: f32 = 1.0 - 1.0 / 16_777_216.0;

/// Below this cosine between normal and eye a lobe's highlight is too sharp for cells.
const GRAZING: f32 = 0.3;

/// Above this exponent a lobe may leave out the light that a cell's samples go to, and reflect the rest of it.
const SHARP: f32 = 40.0;

/// The least share of rays that such lobes get, so that no sample's value is out of bounds, and the most of any.
const LEAST_TO_LOBE: f32 = 0.2;
const MOST_TO_LOBE: f32 = 0.95;

/// What is expected of the visibility of cells, from rays that have been traced before.
pub trait Expectation {
    /// Whether it is good for a control variate. Else cells are weighted by what they reflect.
    const CONTROL: bool;

    /// What is known around a point of this slot: see [`SeenPoint::slot`](super::seen::SeenPoint::slot).
    fn at_slot(&self, slot: u32) -> Self;

    /// The share of the light of cells `4 · quad` on that is expected to arrive, 0 to 1.
    fn quad(&self, quad: u32) -> Vec4;
}

/// Nothing is known of it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Unknown;

impl Expectation for Unknown {
    const CONTROL: bool = false;

    #[inline]
    fn at_slot(&self, _slot: u32) -> Unknown {
        Unknown
    }

    #[inline]
    fn quad(&self, _quad: u32) -> Vec4 {
        Vec4::ZERO
    }
}

/// One cell as a proposal has it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CellAt {
    /// Its weight, without the defensive share.
    pub weight: f32,
    /// Its flux where the surface may see it, else 0.
    pub live: f32,
    /// Cosine of its mean direction, at least 0.
    pub cosine: f32,
    /// Whether the surface sees all of it.
    pub is_full: bool,
    /// The lobe's part of it.
    pub lobe: f32,
    /// The share of its light that is expected to arrive.
    pub visibility: f32,
}

impl CellAt {
    /// Cell `lane` of four.
    #[inline]
    fn new(lane: usize, weight: Vec4, flux: Vec4, terms: &CellTerms, visibility: Vec4) -> CellAt {
        CellAt {
            weight: weight[lane],
            live: (flux * terms.live)[lane],
            cosine: terms.cosine[lane],
            is_full: terms.full[lane] > 0.5,
            lobe: terms.lobe[lane],
            visibility: visibility[lane],
        }
    }
}

/// A direction with its texel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CellDraw {
    /// The cell as the proposal has it.
    pub at: CellAt,
    /// Unit vector in the map's coordinates.
    pub direction: Vec3,
    /// Its texel.
    pub texel: UVec2,
    /// The texel's cell.
    pub cell: u32,
}

/// A density over directions for a group of hits.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Proposal {
    /// What the group's members have in common; its surface has the share β of the lobe that cells sample.
    pub of: Representative,
    /// Weights of quads of cells, with the defensive share.
    quads: [f32; QUADS as usize],
    /// Those of rows of cells.
    rows: [f32; ROWS as usize],
    /// W: their sum.
    pub total: f32,
    /// What a cell's [`CellAt::live`] adds to its weight.
    defence: f32,
    /// B: what the lobe's own samples are worth beside W.
    pub lobe_worth: f32,
    /// φ: the share of samples that the lobe draws.
    pub lobe_share: f32,
    /// Γ: the integral of the control variate; 0 without one.
    pub integral: Vec3,
    /// That of the control variate where nothing blocks light; 0 but for catchers.
    pub open_integral: Vec3,
    /// Whether it is for a catcher, whose blocked light has no control variate.
    pub is_catcher: bool,
}

/// Sums over all cells.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Totals {
    quads: [f32; QUADS as usize],
    lives: [f32; QUADS as usize],
    weight: f32,
    live: f32,
    /// Of a = s Λ: Σ a, Σ a κ², Σ a p̂; and Σ s Q, Σ s Ω.
    lobe: f32,
    lobe_spread: f32,
    lobe_visible: f32,
    lobe_square: f32,
    lobe_area: f32,
    /// Γ by diffuse reflection and by the lobe, without kd/π and ks.
    diffuse: Vec3,
    specular: Vec3,
    /// As those, where nothing blocks light.
    open_diffuse: Vec3,
    open_specular: Vec3,
}

/// One channel of Γ over four cells: its diffuse part where the cells are seen whole, and where not.
#[inline]
fn channel_sum(
    cells: &LightCells<'_>,
    quad: u32,
    channel: u32,
    normal: Vec3,
    full: Vec4,
    cut: Vec4,
) -> f32 {
    let list = field::MOMENT + 3 * channel;
    let moment = cells.quad(list, quad) * normal.x
        + cells.quad(list + 1, quad) * normal.y
        + cells.quad(list + 2, quad) * normal.z;
    let radiance = cells.quad(field::RADIANCE + channel, quad);
    (full * moment + cut * radiance).element_sum()
}

/// As [`channel_sum`], of all channels.
#[inline]
fn diffuse_sum(cells: &LightCells<'_>, quad: u32, normal: Vec3, full: Vec4, cut: Vec4) -> Vec3 {
    Vec3::new(
        channel_sum(cells, quad, 0, normal, full, cut),
        channel_sum(cells, quad, 1, normal, full, cut),
        channel_sum(cells, quad, 2, normal, full, cut),
    )
}

/// The sum over four cells of factors times radiance.
#[inline]
fn radiance_sum(cells: &LightCells<'_>, quad: u32, factors: Vec4) -> Vec3 {
    Vec3::new(
        (cells.quad(field::RADIANCE, quad) * factors).element_sum(),
        (cells.quad(field::RADIANCE + 1, quad) * factors).element_sum(),
        (cells.quad(field::RADIANCE + 2, quad) * factors).element_sum(),
    )
}

#[inline]
fn weigh<P: Expectation>(
    of: &Representative,
    cells: &LightCells<'_>,
    expected: &P,
    is_catcher: bool,
) -> Totals {
    let surface = of.surface;
    let has_lobe = surface.specular > 0.0;
    let mut t = Totals {
        quads: [0.0; QUADS as usize],
        lives: [0.0; QUADS as usize],
        weight: 0.0,
        live: 0.0,
        lobe: 0.0,
        lobe_spread: 0.0,
        lobe_visible: 0.0,
        lobe_square: 0.0,
        lobe_area: 0.0,
        diffuse: Vec3::ZERO,
        specular: Vec3::ZERO,
        open_diffuse: Vec3::ZERO,
        open_specular: Vec3::ZERO,
    };
    for quad in 0..QUADS {
        let flux = cells.quad(field::FLUX, quad);
        let terms = cells.terms(&surface, quad);
        let live = (flux * terms.live).element_sum();
        // Half of all cells lie below the horizon, and many of a night's are black.
        if live > 0.0 {
            let visibility = expected.quad(quad);
            let own = weights::<P>(&surface, &terms, flux, visibility, is_catcher);
            let weight = own.element_sum();
            if P::CONTROL {
                let full = terms.full * visibility;
                let cut = (visibility - full) * terms.cosine;
                t.diffuse += diffuse_sum(cells, quad, of.mean_normal, full, cut);
                if is_catcher {
                    let cut = (Vec4::ONE - terms.full) * terms.cosine;
                    let open = diffuse_sum(cells, quad, of.mean_normal, terms.full, cut);
                    t.open_diffuse += open;
                    t.open_specular += radiance_sum(cells, quad, terms.lobe);
                }
            }
            if has_lobe {
                let a = terms.lobe * flux;
                let spread = a * terms.lobe_spread * terms.lobe_spread;
                t.lobe += a.element_sum();
                t.lobe_spread += spread.element_sum();
                t.lobe_visible += (a * visibility).element_sum();
                t.lobe_square += (terms.lobe * cells.quad(field::SQUARE, quad)).element_sum();
                t.lobe_area += (terms.lobe * cells.quad(field::SOLID_ANGLE, quad)).element_sum();
                if P::CONTROL {
                    t.specular += radiance_sum(cells, quad, terms.lobe * visibility);
                }
            }
            t.quads[quad as usize] = weight;
            t.lives[quad as usize] = live;
            t.weight += weight;
            t.live += live;
        }
    }
    t
}

#[inline]
fn weights<P: Expectation>(
    surface: &CellSurface,
    terms: &CellTerms,
    flux: Vec4,
    visibility: Vec4,
    is_catcher: bool,
) -> Vec4 {
    if P::CONTROL && is_catcher {
        surface.blocked_weights(terms, flux, visibility)
    } else if P::CONTROL {
        surface.residual_weights(terms, flux, visibility)
    } else {
        surface.product_weights(terms, flux)
    }
}

/// What a share of the lobe that cells leave to its own samples is worth, beside weights of cells: `a` is what the lobe reflects
/// of all cells, `visible` the share of it that is expected to arrive, `variance` the light's relative variance under the lobe.
#[inline]
fn worth<P: Expectation>(a: f32, visible: f32, variance: f32) -> f32 {
    if P::CONTROL {
        return a * libm::sqrtf(visible * (1.0 - visible) + visible * variance);
    }
    // Product weights are in units of the light itself; half of it is taken to arrive.
    a * libm::sqrtf(1.0 + 2.0 * variance)
}

/// Whether a surface has a lobe that cells alone are too coarse for.
#[inline]
fn is_sharp(surface: &CellSurface) -> bool {
    let is_flat = surface.normal.dot(surface.wo) < GRAZING;
    surface.specular > 0.0 && (is_flat || surface.exponent > SHARP)
}

impl Proposal {
    /// The proposal of a group.
    #[inline]
    #[must_use]
    pub fn new<P: Expectation>(
        of: &Representative,
        cells: &LightCells<'_>,
        expected: &P,
        is_catcher: bool,
    ) -> Proposal {
        let mut of = *of;
        let mut sums = weigh(&of, cells, expected, is_catcher);
        let first = sums;
        let mut lobe_worth = 0.0;
        let mut least_share = 0.0;
        let mut share = 1.0;
        if of.surface.specular > 0.0 && sums.lobe > 0.0 {
            // Relative variances of a sample of the lobe's light: drawn through cells, and drawn from the lobe.
            let by_cells = sums.lobe_spread / sums.lobe;
            let by_lobe = (sums.lobe_square / sums.lobe * (sums.lobe_area / sums.lobe) - 1.0)
                .clamp(1e-4, 1e6);
            share = by_lobe / (by_lobe + by_cells);
            if share > 0.9 {
                share = 1.0;
            } else if share < 0.1 {
                share = 0.0;
            }
            let a = sums.lobe * of.surface.specular;
            let visible = (sums.lobe_visible / sums.lobe).min(1.0);
            if share < 1.0 {
                lobe_worth = (1.0 - share) * worth::<P>(a, visible, by_lobe);
                of.surface.share = share;
                sums = weigh(&of, cells, expected, is_catcher);
            }
        }
        if is_sharp(&of.surface) {
            least_share = LEAST_TO_LOBE;
        }
        let mut defence = 0.0;
        if sums.live > 0.0 {
            defence = DEFENCE * sums.weight / sums.live;
        }
        let mut total = 0.0;
        let mut quads = [0.0; QUADS as usize];
        let mut rows = [0.0; ROWS as usize];
        for row in 0..ROWS as usize {
            let mut of_row = 0.0;
            for quad in row * ROW_QUADS..(row + 1) * ROW_QUADS {
                let weight = sums.quads[quad] + defence * sums.lives[quad];
                quads[quad] = weight;
                of_row += weight;
            }
            rows[row] = of_row;
            total += of_row;
        }
        let all = total + lobe_worth;
        let mut lobe_share = 0.0;
        if all > 0.0 {
            lobe_share = (lobe_worth / all).clamp(least_share, MOST_TO_LOBE);
            if !(total > 0.0) {
                lobe_share = 1.0;
            }
        }
        let kd = of.diffuse * core::f32::consts::FRAC_1_PI;
        Proposal {
            integral: kd * first.diffuse + of.specular * (first.specular * share),
            open_integral: kd * first.open_diffuse + of.specular * (first.open_specular * share),
            is_catcher,
            of,
            quads,
            rows,
            total,
            defence,
            lobe_worth,
            lobe_share,
        }
    }

    /// Makes φ the share that a whole number of `count` samples has, where that leaves samples to both techniques: how many the lobe
    /// draws is not left to chance then.
    #[inline]
    pub fn round_share(&mut self, count: u32) {
        let lobes = libm::floorf(self.lobe_share * count as f32 + 0.5);
        if lobes > 0.0 && lobes < count as f32 {
            self.lobe_share = lobes / count as f32;
        }
    }

    /// Whether it has a lobe that cells alone are too coarse for.
    #[inline]
    #[must_use]
    pub fn is_sharp(&self) -> bool {
        is_sharp(&self.of.surface)
    }

    /// Cell `cell` as this proposal has it.
    #[inline]
    #[must_use]
    pub fn cell<P: Expectation>(&self, cell: u32, cells: &LightCells<'_>, expected: &P) -> CellAt {
        let quad = cell / 4;
        let flux = cells.quad(field::FLUX, quad);
        let terms = cells.terms(&self.of.surface, quad);
        let visibility = expected.quad(quad);
        let weight = weights::<P>(&self.of.surface, &terms, flux, visibility, self.is_catcher);
        CellAt::new((cell % 4) as usize, weight, flux, &terms, visibility)
    }

    /// Density of the cells' samples in a texel of the cell `at`, in 1/sr.
    #[inline]
    #[must_use]
    pub fn cells_pdf_sr(
        &self,
        texel: UVec2,
        cell: u32,
        at: &CellAt,
        cells: &LightCells<'_>,
    ) -> f32 {
        if !(self.total > 0.0) {
            return 0.0;
        }
        let weight = at.weight + self.defence * at.live;
        let pmf = weight / self.total * cells.pmf_in_cell(texel, cell);
        pmf / texel_solid_angle_sr(texel.y, cells.size)
    }

    /// The control variate `g(ω)` in a direction of the cell `at`, in the map's coordinates, over the visibility that is expected there.
    #[inline]
    #[must_use]
    pub fn open_control(&self, direction: Vec3, at: &CellAt) -> Vec3 {
        let cosine = if at.is_full {
            self.of.mean_normal.dot(direction)
        } else {
            at.cosine
        };
        let kd = self.of.diffuse * core::f32::consts::FRAC_1_PI;
        kd * cosine + self.of.specular * at.lobe
    }

    /// Draws a direction by the cells: the row of cells and the row of texels by `u.y`, the columns by `u.x`. The weights sum to
    /// more than 0.
    #[inline]
    #[must_use]
    pub fn sample_cells<P: Expectation>(
        &self,
        u: UVec2,
        cells: &LightCells<'_>,
        expected: &P,
    ) -> CellDraw {
        // The last row, quad and cell of positive weight stands where rounding leaves the target beyond the sum.
        let mut row_place = Place::new(unit_f32(u.y) * self.total);
        for row in 0..ROWS {
            row_place.offer(row, self.rows[row as usize]);
        }
        let first = row_place.index * ROW_QUADS as u32;
        let target = unit_f32(u.x) * row_place.width;
        let mut quad_place = Place::new(target);
        for quad in first..first + ROW_QUADS as u32 {
            quad_place.offer(quad, self.quads[quad as usize]);
        }
        let quad = quad_place.index;
        let flux = cells.quad(field::FLUX, quad);
        let terms = cells.terms(&self.of.surface, quad);
        let visibility = expected.quad(quad);
        let surface = &self.of.surface;
        let weight = weights::<P>(surface, &terms, flux, visibility, self.is_catcher);
        let all = weight + flux * terms.live * self.defence;
        let mut cell_place = Place {
            sum: quad_place.first,
            ..Place::new(target)
        };
        cell_place.offer(0, all.x);
        cell_place.offer(1, all.y);
        cell_place.offer(2, all.z);
        cell_place.offer(3, all.w);
        let lane = cell_place.index;
        let cell = 4 * quad + lane;
        let hash = hash2(u.x, u.y);
        let within = UVec2::new(
            cell_place.word(row_place.width, hash & 0xffff),
            row_place.word(self.total, hash >> 16),
        );
        let drawn = cells.sample(cell, within);
        let place = hash2(hash, u.x);
        let place = UVec2::new(place << 16, place & 0xffff_0000);
        CellDraw {
            direction: direction_in_texel(drawn.texel, cells.size, unit_vec2(place)),
            texel: drawn.texel,
            cell,
            at: CellAt::new(lane as usize, weight, flux, &terms, visibility),
        }
    }
}

/// The interval of a running sum that a number falls into.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Place {
    target: f32,
    /// The sum so far.
    sum: f32,
    /// The interval's number, its lower edge and its width.
    index: u32,
    first: f32,
    width: f32,
    is_found: bool,
}

impl Place {
    #[inline]
    fn new(target: f32) -> Place {
        Place {
            target,
            sum: 0.0,
            index: 0,
            first: 0.0,
            width: 0.0,
            is_found: false,
        }
    }

    /// The next interval.
    #[inline]
    fn offer(&mut self, index: u32, width: f32) {
        if width > 0.0 && !self.is_found {
            self.index = index;
            self.first = self.sum;
            self.width = width;
        }
        self.sum += width;
        self.is_found = self.is_found || self.sum > self.target;
    }

    /// Where in its interval the target lies, as a uniform word, refined below the 24 bits that it had of `whole` by 16 bits of
    /// `fraction`.
    #[inline]
    fn word(&self, whole: f32, fraction: u32) -> u32 {
        let unit = whole * (1.0 / 16_777_216.0);
        let fine = self.target - self.first + unit * (fraction as f32 * (1.0 / 65_536.0));
        let place = (fine / self.width.max(f32::MIN_POSITIVE)).clamp(0.0, BELOW_ONE);
        ((place * 16_777_216.0) as u32) << 8 | (fraction & 0xff)
    }
}
