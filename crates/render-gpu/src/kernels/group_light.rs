//! Shared file: light that a group of a pixel's hits reflects, by one proposal for all of them.

use glam::{UVec2, Vec3, Vec4};
use glimt_brdf::BlinnPhong;
use glimt_light_cells::{LightCells, cosine_power4};
use glimt_probe::rotate::rotate_z;
use glimt_sampling::hash::hash2;
use glimt_sampling::uniform::{UniformSource, unit_f32, unit_vec2};

use super::environment::Environment;
use super::estimator::Reflected;
use super::groups::Group;
use super::pattern::{CELLS, COUNT, LIT_THROUGH, LOBE, PixelPattern};
use super::proposal::{CellAt, Expectation, Proposal};
use super::scene::{Scene, ShadingPoint};
use super::seen::SeenPoint;

/// The fewest and the most rays that a group is worth, on average.
const FEWEST: f32 = 0.02;
const MOST: f32 = 256.0;

/// The least spread of normals, in radians, for which samples of diffuse members are compared with the group's mean: 2°.
const SPREAD: f32 = 0.035;

/// The same where they have lobes: below it the lobes are as good as one.
const FLAT: f32 = 1e-3;

/// How many samples of a pixel each technique has drawn. Each counts its own, so that each has all of its points.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Drawn {
    /// By cells.
    pub cells: u32,
    /// By lobes.
    pub lobes: u32,
}

/// What estimating a group's light needs beside the group.
#[derive(Clone, Copy, Debug)]
pub struct GroupLight<'a> {
    /// The light.
    pub env: Environment<'a>,
    /// Its cells.
    pub cells: LightCells<'a>,
    /// What blocks it.
    pub scene: Scene<'a>,
    /// The pixel's pattern.
    pub pattern: PixelPattern,
    /// Shadow rays of a pixel: of one whose rays all hit something, or on average over the image where there is a threshold.
    pub rays: f32,
    /// τ: what a ray of a group is worth on average; 0 where all groups of equal size get equally many.
    pub threshold: f32,
}

/// A direction to look for light in, and the member that looks.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Look {
    /// In the map's coordinates.
    of_map: Vec3,
    /// In the world.
    direction: Vec3,
    texel: UVec2,
    /// The texel's cell.
    at: CellAt,
    cell: u32,
    /// The member's ray.
    ray: u32,
    /// Whether there is such a direction: a lobe may reflect below the horizon.
    is_possible: bool,
}

/// The member's lobe alone.
#[inline]
fn lobe_of(point: &ShadingPoint) -> BlinnPhong {
    BlinnPhong {
        diffuse: Vec3::ZERO,
        ..point.brdf
    }
}

/// `f = ρ(ωo, ω) ⟨ω·n⟩` of a point, 0 behind its shading normal.
#[inline]
fn reflectance(point: &ShadingPoint, wi: Vec3) -> Vec3 {
    if wi.z > 0.0 {
        return point.brdf.eval(point.wo, wi) * wi.z;
    }
    Vec3::ZERO
}

impl GroupLight<'_> {
    /// Light that a group reflects, a mean over its members. `number` is the group's in its pixel, `drawn` what the groups before it
    /// have drawn.
    #[inline]
    #[must_use]
    pub fn reflected<P: Expectation>(
        &self,
        group: &Group,
        number: u32,
        expected: &P,
        points: &mut [SeenPoint],
        drawn: &mut Drawn,
    ) -> Reflected {
        let representative = group.representative(points, self.env);
        let first = group.ray(0, points);
        let leader = points[first as usize];
        let expected = &expected.at_slot(leader.slot());
        let is_catcher = leader.is_catcher();
        let mut proposal = Proposal::new(&representative, &self.cells, expected, is_catcher);
        let mut source = self.pattern.point(COUNT, number);
        let start = unit_f32(source.next_u32());
        let share = group.members as f32 / self.pattern.rays as f32;
        let mut worth = self.rays * share;
        if self.threshold > 0.0 {
            worth = (proposal.total + proposal.lobe_worth) * share / self.threshold;
        }
        if proposal.is_sharp() {
            worth = worth.max(0.25 * self.rays * share);
        }
        worth = worth.clamp(FEWEST, MOST);
        if !(proposal.total > 0.0) && !(proposal.lobe_share > 0.0) {
            worth = 0.0;
        }
        let count = (worth + unit_f32(source.next_u32())) as u32;
        proposal.round_share(count);
        let divisor = if worth < 1.0 { worth } else { count as f32 };
        let key = hash2(self.pattern.ray_key(LIT_THROUGH), number);
        let mut lit = Vec3::ZERO;
        let mut blocked = Vec3::ZERO;
        for s in 0..count {
            let before = (s as f32 * proposal.lobe_share + start) as u32;
            let after = ((s + 1) as f32 * proposal.lobe_share + start) as u32;
            let look = if after > before {
                drawn.lobes += 1;
                self.look_by_lobe(group, &proposal, expected, drawn.lobes - 1, points)
            } else {
                drawn.cells += 1;
                self.look_by_cells(group, &proposal, expected, drawn.cells - 1, points)
            };
            if look.is_possible {
                let own = key.wrapping_add(s);
                let light = self.sample::<P>(group, &proposal, &look, own, points);
                lit += light.lit;
                blocked += light.blocked;
            }
        }
        points[first as usize].shadow_rays = count;
        points[first as usize].residual = (proposal.total + proposal.lobe_worth) * share;
        if count > 0 {
            lit /= divisor;
            blocked /= divisor;
        }
        if P::CONTROL && is_catcher {
            // Here `lit` is the light without objects.
            return Reflected {
                lit: proposal.open_integral + lit - blocked,
                blocked,
            };
        }
        Reflected {
            lit: proposal.integral + lit,
            blocked,
        }
    }

    #[inline]
    fn member(&self, group: &Group, word: u32, points: &mut [SeenPoint]) -> u32 {
        let k = (unit_f32(word) * group.members as f32) as u32;
        group.ray(k.min(group.members - 1), points)
    }

    #[inline]
    fn look_by_cells<P: Expectation>(
        &self,
        group: &Group,
        proposal: &Proposal,
        expected: &P,
        index: u32,
        points: &mut [SeenPoint],
    ) -> Look {
        let words = self.pattern.point_triple(CELLS, index);
        let ray = self.member(group, words.z, points);
        let drawn = proposal.sample_cells(words.truncate(), &self.cells, expected);
        Look {
            of_map: drawn.direction,
            direction: rotate_z(drawn.direction, self.env.rotation),
            texel: drawn.texel,
            at: drawn.at,
            cell: drawn.cell,
            ray,
            is_possible: true,
        }
    }

    #[inline]
    fn look_by_lobe<P: Expectation>(
        &self,
        group: &Group,
        proposal: &Proposal,
        expected: &P,
        index: u32,
        points: &mut [SeenPoint],
    ) -> Look {
        let words = self.pattern.point_triple(LOBE, index);
        let u = unit_vec2(words.truncate());
        let ray = self.member(group, words.z, points);
        let point = points[ray as usize].shading_point();
        let drawn = lobe_of(&point).sample(point.wo, 0, u);
        let direction = point.frame.to_world(drawn.wi);
        let texel = self.env.texel(direction);
        let cell = self.cells.cell_of(texel);
        Look {
            of_map: self.env.to_map(direction),
            direction,
            texel,
            at: proposal.cell(cell, &self.cells, expected),
            cell,
            ray,
            is_possible: drawn.pdf_sr > 0.0,
        }
    }

    /// What one direction contributes, before it is divided by their number.
    #[inline]
    fn sample<P: Expectation>(
        &self,
        group: &Group,
        proposal: &Proposal,
        look: &Look,
        key: u32,
        points: &mut [SeenPoint],
    ) -> Reflected {
        let point = points[look.ray as usize].shading_point();
        let wi = point.frame.to_local(look.direction);
        let at = look.at;
        let share = proposal.lobe_share;
        let mut pdf_sr = 0.0;
        if share < 1.0 {
            let by_cells = proposal.cells_pdf_sr(look.texel, look.cell, &at, &self.cells);
            pdf_sr = (1.0 - share) * by_cells;
        }
        if share > 0.0 {
            pdf_sr += share * lobe_of(&point).pdf_sr(point.wo, wi);
        }
        if !(pdf_sr > f32::MIN_POSITIVE) {
            return Reflected::NONE;
        }
        let radiance = self.env.radiance(look.texel);
        let f = reflectance(&point, wi);
        let is_seen = f.max_element() > 0.0 && point.geometric_normal.dot(look.direction) > 0.0;
        let arrives = is_seen && self.scene.is_lit(&point, look.direction, key);
        let mut lit = Vec3::ZERO;
        let mut blocked = Vec3::ZERO;
        if arrives {
            lit = f;
        } else if is_seen {
            blocked = f;
        }
        if P::CONTROL {
            let control = proposal.open_control(look.of_map, &at);
            let others = self.of_others(group, proposal, look, points);
            if proposal.is_catcher {
                lit = f - control + others;
            } else {
                lit += (others - control) * at.visibility;
            }
        }
        // The quotient is bounded where the radiance may be huge, so it comes first.
        Reflected {
            lit: radiance * (lit / pdf_sr),
            blocked: radiance * (blocked / pdf_sr),
        }
    }

    /// `f̄(ω) − f_k(ω)`: the mean over the members less that of the one that looks. Its mean over the members is 0, so it moves no
    /// estimate; it takes away the noise of who looks. Any functions f may stand here, so lobes have the group's exponent and eye, and a
    /// polynomial for a power. Where lobes draw samples, which do not cover other members' lobes, there are the diffuse parts alone.
    #[inline]
    fn of_others(
        &self,
        group: &Group,
        proposal: &Proposal,
        look: &Look,
        points: &mut [SeenPoint],
    ) -> Vec3 {
        if group.members < 2 {
            return Vec3::ZERO;
        }
        let of = &proposal.of;
        let spread = of.surface.spread;
        let with_lobes = of.surface.specular > 0.0 && !(proposal.lobe_share > 0.0) && spread > FLAT;
        if !(with_lobes || spread > SPREAD) {
            let normal = points[look.ray as usize].normal;
            let apart = of.mean_normal.dot(look.of_map) - normal.dot(look.direction);
            return of.diffuse * (core::f32::consts::FRAC_1_PI * apart);
        }
        let half = look.of_map + of.surface.wo;
        let half = rotate_z(half / half.length().max(1e-6), self.env.rotation);
        let mut diffuse = Vec3::ZERO;
        let mut lobes = 0.0;
        let mut own_diffuse = Vec3::ZERO;
        let mut own_lobe = 0.0;
        for quad in 0..group.members.div_ceil(4) {
            let mut cosines = [0.0; 4];
            let mut halves = [0.0; 4];
            let mut is_own = [0.0; 4];
            for lane in 0..4 {
                let k = 4 * quad + lane;
                if k < group.members {
                    let ray = group.ray(k, points);
                    let other = points[ray as usize];
                    let cosine = other.normal.dot(look.direction).max(0.0);
                    cosines[lane as usize] = cosine;
                    halves[lane as usize] = other.normal.dot(half).max(0.0);
                    diffuse += other.diffuse * cosine;
                    if ray == look.ray {
                        own_diffuse = other.diffuse * cosine;
                        is_own[lane as usize] = 1.0;
                    }
                }
            }
            if with_lobes {
                let cosine = Vec4::new(cosines[0], cosines[1], cosines[2], cosines[3]);
                let half = Vec4::new(halves[0], halves[1], halves[2], halves[3]);
                let own = Vec4::new(is_own[0], is_own[1], is_own[2], is_own[3]);
                let power = cosine_power4(Vec4::ONE - half * half, Vec4::splat(of.exponent));
                lobes += (power * cosine).element_sum();
                own_lobe += (power * cosine * own).element_sum();
            }
        }
        let share = 1.0 / group.members as f32;
        (diffuse * share - own_diffuse) * core::f32::consts::FRAC_1_PI
            + of.specular * (of.peak * (lobes * share - own_lobe))
    }
}
