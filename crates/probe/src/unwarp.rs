//! Host file: from the photograph of a mirror ball to a lat-long map: which pixels make each texel, and what was never seen.
//!
//! A texel is the mean of the photograph over the texel's own solid angle. Where a texel is larger than a pixel, pixels count
//! by the area that the texel covers of them; where it is thinner, as towards the rim, the photograph is interpolated
//! linearly across it. No weight is negative, so that no light rings.
//!
//! What the ball hides, and what its last pixels mix with the background, is filled with the harmonic function that agrees
//! with the seen surroundings along its edge: the smoothest there is (Laplace's equation, by Poisson's kernel in the
//! stereographic projection, which keeps it harmonic). The same can be done with the reflection of camera and rig.

use core::f32::consts::PI;

use glam::{UVec2, Vec2, Vec3};

use crate::latlong;
use crate::mirror_ball::{MirrorBall, image_to_pixel};
use crate::trig::cos_sin_pi;

/// A pixel of the photograph with its share in a texel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tap {
    /// Column and row.
    pub pixel: UVec2,
    /// Its share; those of a texel have no particular sum.
    pub weight: f32,
}

/// The ball's outline in a photograph, in pixels; pixel (i, j)'s centre stands at (i + ½, j + ½).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Outline {
    /// Its centre.
    pub centre: Vec2,
    /// Its radius.
    pub radius: f32,
}

/// What became of a direction.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Visibility {
    /// The photograph shows it.
    Seen,
    /// In the cone behind the ball, which no pixel shows.
    Hidden,
    /// Shown by the last pixels before the rim alone, which the background is mixed into.
    Rim,
    /// Behind camera and rig.
    Rig,
}

/// Why an [`Unwarp`] cannot be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum UnwarpError {
    /// The map or the photograph has no texel, or more than 2³¹.
    Size,
    /// The outline is not finite, or its radius is below four pixels.
    Outline,
    /// The outline does not lie within the photograph.
    Cut,
}

impl core::fmt::Display for UnwarpError {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.write_str(match self {
            UnwarpError::Size => "an image needs at least one texel and at most 2^31",
            UnwarpError::Outline => "the ball's radius must be four pixels at least",
            UnwarpError::Cut => "the ball is cut by the border of the image",
        })
    }
}

impl core::error::Error for UnwarpError {}

/// A lat-long map to be made from the photograph of a mirror ball.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Unwarp {
    ball: MirrorBall,
    outline: Outline,
    photo: UVec2,
    size: UVec2,
    /// The largest |p| that is looked up.
    usable: f32,
    /// Square of the distance from the ball's centre, in pixels, that no corner of a pixel that is taken exceeds.
    reach2: f32,
    /// Cosine of the half-angle about `−forward` that the rig covers; 2 where there is none.
    rig_cos: f32,
    /// Parts that a texel is cut into along each side, so that none is wide beside the filled cone.
    parts: u32,
}

/// Arcs that the edge of a filled cone is cut into, and pixels taken from each.
const ARCS: u32 = 48;
const PIXELS_OF_ARC: u32 = 4;
/// Distance in pixels between the places where the photograph is read, where a texel covers several pixels.
const SPACING: f32 = 1.0;
/// Longest edge of a texel in the photograph that counts as straight.
const STRAIGHT: f32 = 4.0;

impl Unwarp {
    /// A map of `size` texels from a photograph of `photo` pixels in which `ball` has the outline `outline`.
    ///
    /// Pixels that reach nearer to the rim than `rim_px − 1` pixels are not taken, since the background may be mixed into
    /// them: 1 takes all that lie within the outline.
    ///
    /// # Errors
    /// An [`UnwarpError`].
    pub fn new(
        ball: MirrorBall,
        outline: Outline,
        photo: UVec2,
        size: UVec2,
        rim_px: f32,
    ) -> Result<Unwarp, UnwarpError> {
        let texels = |s: UVec2| u64::from(s.x) * u64::from(s.y);
        let fine = |s: UVec2| s.min_element() > 0 && texels(s) <= 1 << 31;
        if !fine(photo) || !fine(size) {
            return Err(UnwarpError::Size);
        }
        let Outline { centre, radius } = outline;
        if !(centre.is_finite() && radius >= 4.0 && radius < 1e6) {
            return Err(UnwarpError::Outline);
        }
        let low = (centre - Vec2::splat(radius)).min_element();
        let high = (centre + Vec2::splat(radius) - photo.as_vec2()).max_element();
        if low < -0.5 || high > 0.5 {
            return Err(UnwarpError::Cut);
        }
        // Half a pixel more than is distrusted: so the pixel that a usable point lies in is one that may be taken.
        let rim = rim_px.clamp(0.0, 0.25 * radius);
        let usable = 1.0 - (rim + 0.5) / radius;
        let reach = radius - rim + 1.0;
        let mut unwarp = Unwarp {
            ball,
            outline,
            photo,
            size,
            usable,
            reach2: reach * reach,
            rig_cos: 2.0,
            parts: 1,
        };
        let texel = PI / size.min_element() as f32;
        unwarp.parts =
            libm::ceilf(4.0 * texel / unwarp.filled_half_angle()).clamp(1.0, 64.0) as u32;
        Ok(unwarp)
    }

    /// The same with the cone of `half_angle` radians about the direction to the camera filled, which shows the camera
    /// itself and its rig.
    #[must_use]
    pub fn with_rig(self, half_angle: f32) -> Unwarp {
        let rig_cos = if half_angle > 0.0 {
            libm::cosf(half_angle.min(1.5))
        } else {
            2.0
        };
        Unwarp { rig_cos, ..self }
    }

    /// Half-angle in radians of the cone behind the ball that is filled: the hidden one and the rim's.
    #[must_use]
    pub fn filled_half_angle(&self) -> f32 {
        let edge = self.ball.image_to_direction(Vec2::new(self.usable, 0.0));
        edge.map_or(0.0, |d| {
            libm::acosf(d.dot(self.ball.forward).clamp(-1.0, 1.0))
        })
    }

    /// What became of the direction `d` (unit length).
    #[must_use]
    pub fn visibility(&self, d: Vec3) -> Visibility {
        match self.ball.direction_to_image(d) {
            None => Visibility::Hidden,
            Some(p) if p.length() > self.usable => Visibility::Rim,
            Some(_) => self.rig_or_seen(d),
        }
    }

    fn rig_or_seen(&self, d: Vec3) -> Visibility {
        if -d.dot(self.ball.forward) > self.rig_cos {
            Visibility::Rig
        } else {
            Visibility::Seen
        }
    }

    /// The usable image point nearest to `p`.
    fn clip(&self, p: Vec2) -> Vec2 {
        let length2 = p.length_squared();
        if length2 > self.usable * self.usable {
            p * (self.usable / libm::sqrtf(length2))
        } else {
            p
        }
    }

    /// Tells the taps of a texel, in no order, some pixels several times; their weights have no particular sum. Says what
    /// became of the texel's middle.
    ///
    /// `corners` are those of [`corner`] around the texel, for this ball: upper left, upper right, lower left, lower right.
    /// They do not depend on where in the photograph the ball is, so who unwarps many frames keeps them.
    pub fn texel(&self, texel: UVec2, corners: [Vec2; 4], mut tap: impl FnMut(Tap)) -> Visibility {
        let middle = latlong::texel_direction(texel, self.size);
        let longest = corners.map(Vec2::length_squared);
        let inside = longest.into_iter().fold(0.0, f32::max) < self.usable * self.usable;
        let visibility = if inside && self.parts == 1 {
            self.rig_or_seen(middle)
        } else {
            self.visibility(middle)
        };
        match visibility {
            Visibility::Hidden | Visibility::Rim => {
                let cos_edge = libm::cosf(self.filled_half_angle());
                self.fill(middle, self.ball.forward, cos_edge, &mut tap);
            }
            Visibility::Rig => self.fill(middle, -self.ball.forward, self.rig_cos, &mut tap),
            Visibility::Seen if self.parts == 1 => {
                let rows = texel.y as f32 / self.size.y as f32;
                let corners = corners.map(|p| self.clip(p));
                self.quad(corners, rows, 1.0 / self.size.y as f32, &mut tap);
            }
            Visibility::Seen => self.parts(texel, &mut tap),
        }
        visibility
    }

    /// `(1 − cos i)^5` at the middle of a texel between these corners (see [`Unwarp::texel`]); that of the edge which it is
    /// filled from, where it is.
    #[must_use]
    pub fn grazing(&self, corners: [Vec2; 4]) -> f32 {
        let [a, b, c, d] = corners;
        let x = 1.0 - self.ball.cos_incidence(self.clip(0.25 * (a + b + c + d)));
        let x2 = x * x;
        x2 * x2 * x
    }

    /// A texel too wide to be one piece.
    fn parts(&self, texel: UVec2, tap: &mut impl FnMut(Tap)) {
        let step = Vec2::ONE / (self.size.as_vec2() * self.parts as f32);
        for y in 0..self.parts {
            for x in 0..self.parts {
                let at = (texel * self.parts + UVec2::new(x, y)).as_vec2();
                let point = |dx: f32, dy: f32| {
                    latlong::uv_to_direction(((at + Vec2::new(dx, dy)) * step).min(Vec2::ONE))
                };
                if self.visibility(point(0.5, 0.5)) == Visibility::Seen {
                    let corners = [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (1.0, 1.0)]
                        .map(|(dx, dy)| self.clip(image_point(&self.ball, point(dx, dy))));
                    // Pieces count by their area, as the rows of a quad do.
                    self.quad(corners, at.y * step.y, step.y, tap);
                }
            }
        }
    }

    /// Taps of the part of the map between four corners, from `v` on `height` high.
    fn quad(&self, corners: [Vec2; 4], v: f32, height: f32, tap: &mut impl FnMut(Tap)) {
        let r = self.outline.radius;
        let [a, b, c, d] = corners.map(|p| p * r);
        let along = 0.5 * ((b + d) - (a + c));
        let down = 0.5 * ((c + d) - (a + b));
        let longest = along
            .length_squared()
            .max(down.length_squared())
            .max((along + down).length_squared())
            .max((along - down).length_squared());
        let longest = libm::sqrtf(longest);
        let thickness = along.perp_dot(down).abs() / longest.max(1e-12);
        // Towards the rim a texel is a long arc about the ball's centre, not a straight strip.
        let nearest = a.length_squared().min(d.length_squared());
        let curved = longest > STRAIGHT && nearest > 0.25 * r * r;

        let counts = [along.length(), down.length()].map(|l| libm::ceilf(l / SPACING).max(1.0));
        let spacing = (along.length() / counts[0]).max(down.length() / counts[1]);
        let width = spacing.max(1.0 - thickness).min(1.0);
        let polar = curved.then(|| Polar::new([a, b, c, d]));
        for y in 0..counts[1] as u32 {
            let t = (y as f32 + 0.5) / counts[1];
            // The solid angle of a strip goes with the sine of θ.
            let weight = cos_sin_pi(v + t * height).y / (counts[0] * counts[1]);
            for x in 0..counts[0] as u32 {
                let s = (x as f32 + 0.5) / counts[0];
                let place = match &polar {
                    Some(polar) => polar.at(s, t),
                    None => a.lerp(b, s).lerp(c.lerp(d, s), t),
                };
                self.read(self.outline.centre + place, width, weight, tap);
            }
        }
    }

    /// Taps of a square of the photograph, `width` ≤ 1 pixels wide, about `place`: each pixel by the area it shares.
    fn read(&self, place: Vec2, width: f32, weight: f32, tap: &mut impl FnMut(Tap)) {
        let low = place - Vec2::splat(0.5 * width);
        let first = low.floor();
        let share =
            ((low + Vec2::splat(width) - first - Vec2::ONE) / width).clamp(Vec2::ZERO, Vec2::ONE);
        for (dx, wx) in [(0, 1.0 - share.x), (1, share.x)] {
            for (dy, wy) in [(0, 1.0 - share.y), (1, share.y)] {
                let (x, y) = (first.x as i64 + dx, first.y as i64 + dy);
                let w = weight * wx * wy;
                if w > 0.0 {
                    self.tap(x, y, w, tap);
                }
            }
        }
    }

    fn tap(&self, x: i64, y: i64, weight: f32, tap: &mut impl FnMut(Tap)) {
        let middle = Vec2::new(x as f32 + 0.5, y as f32 + 0.5) - self.outline.centre;
        let corner = middle.abs() + Vec2::splat(0.5);
        if corner.length_squared() > self.reach2 {
            return;
        }
        let x = x.clamp(0, i64::from(self.photo.x) - 1) as u32;
        let y = y.clamp(0, i64::from(self.photo.y) - 1) as u32;
        tap(Tap {
            pixel: UVec2::new(x, y),
            weight,
        });
    }

    /// Taps of a direction inside the cone about `axis`: the edge's pixels, weighed by Poisson's kernel.
    fn fill(&self, d: Vec3, axis: Vec3, cos_edge: f32, tap: &mut impl FnMut(Tap)) {
        let ball = &self.ball;
        let side = Vec2::new(d.dot(ball.right), -d.dot(ball.up));
        // The stereographic radius, tan(γ/2) = sin γ / (1 + cos γ), in units of the edge's.
        let sin_edge = libm::sqrtf((1.0 - cos_edge * cos_edge).max(1e-12));
        let edge = sin_edge / (1.0 + cos_edge);
        let rho = side.length() / (1.0 + d.dot(axis)) / edge;
        // Nearer to the edge than its arcs are long the kernel is narrower than they.
        let rho = rho.clamp(0.0, 1.0 - 3.0 / ARCS as f32);
        let towards = side.normalize_or(Vec2::X);
        for arc in 0..ARCS * PIXELS_OF_ARC {
            let turn = cos_sin_pi(2.0 * arc as f32 / (ARCS * PIXELS_OF_ARC) as f32 - 1.0);
            let across = ball.right * turn.x - ball.up * turn.y;
            let p = self.clip(image_point(&self.ball, axis * cos_edge + across * sin_edge));
            let cosine = turn.dot(towards);
            let kernel = (1.0 - rho * rho) / (1.0 - 2.0 * rho * cosine + rho * rho);
            let at = image_to_pixel(p, self.outline.centre, self.outline.radius);
            let at = at.floor();
            self.tap(at.x as i64, at.y as i64, kernel, tap);
        }
    }
}

/// Image point of a direction; of one in the hidden cone, the nearest on the rim.
fn image_point(ball: &MirrorBall, d: Vec3) -> Vec2 {
    ball.direction_to_image(d)
        .unwrap_or_else(|| Vec2::new(d.dot(ball.right), -d.dot(ball.up)).normalize_or(Vec2::X))
}

/// Image point of a corner of the grid of a lat-long map of `size` texels: `at` of them from the left and from the top, up
/// to `size`. One in the hidden cone gives the nearest point of the rim.
#[must_use]
pub fn corner(ball: &MirrorBall, at: UVec2, size: UVec2) -> Vec2 {
    image_point(
        ball,
        latlong::uv_to_direction(at.as_vec2() / size.as_vec2()),
    )
}

/// Four points about the origin, interpolated in radius and angle.
struct Polar {
    radii: [f32; 4],
    angles: [f32; 4],
}

impl Polar {
    fn new(points: [Vec2; 4]) -> Polar {
        let first = libm::atan2f(points[0].y, points[0].x);
        let angles = points.map(|p| {
            let a = libm::atan2f(p.y, p.x) - first;
            first + a - 2.0 * PI * libm::floorf(a / (2.0 * PI) + 0.5)
        });
        Polar {
            radii: points.map(Vec2::length),
            angles,
        }
    }

    fn at(&self, s: f32, t: f32) -> Vec2 {
        let mix = |[a, b, c, d]: [f32; 4]| {
            let upper = a + (b - a) * s;
            upper + (c + (d - c) * s - upper) * t
        };
        let angle = mix(self.angles) / PI;
        cos_sin_pi(angle - 2.0 * libm::floorf(0.5 * angle + 0.5)) * mix(self.radii)
    }
}
