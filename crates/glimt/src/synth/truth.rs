//! Host file: the truth beside the frames: which directions the ball cannot show, the numbers of each frame, and a shot that
//! fits.

use super::geometry::{FrameTruth, ball, capture_params, focal_px, plate_camera};
use super::settings::{PlateFormat, Synth};
use crate::output::SOFTWARE;
use glam::{UVec2, Vec3};
use glimt_probe::latlong::texel_direction;
use glimt_render_gpu::kernels::stage::NO_HIT;
use rayon::prelude::*;
use serde_json::{Value, json};

/// In a mask: the ball shows this direction.
pub const MASK_SEEN: u8 = 0;
/// In a mask: the direction lies in the cone behind the ball.
pub const MASK_HIDDEN: u8 = 1;
/// In a mask: where the ball would show this direction, it shows the rig.
pub const MASK_RIG: u8 = 2;
/// In a mask of an unwarped map: the direction is shown by the ring before the rim alone, which is not trusted.
pub const MASK_RIM: u8 = 3;

/// What the ball shows of each direction: one of the `MASK_…` values for each texel of a lat-long map, by its centre.
pub(super) fn mask(synth: &Synth, size: UVec2) -> Vec<u8> {
    let steady = ball(synth);
    let capture = capture_params(synth, 1, Vec3::ZERO);
    let texel = |i: u32| {
        let d = texel_direction(UVec2::new(i % size.x, i / size.x), size);
        let seen = steady.direction_to_image(d).and_then(|p| steady.reflect(p));
        match seen {
            _ if steady.is_hidden(d) => MASK_HIDDEN,
            None => MASK_HIDDEN,
            Some(seen) => {
                let point = capture.ball_centre + seen.normal * capture.ball_radius;
                match capture.rig_distance(point, seen.direction) < NO_HIT {
                    true => MASK_RIG,
                    false => MASK_SEEN,
                }
            }
        }
    };
    (0..size.x * size.y).into_par_iter().map(texel).collect()
}

/// The numbers of all frames.
pub(super) fn truth_json(synth: &Synth, frames: &[FrameTruth]) -> Value {
    let steady = ball(synth);
    json!({
        "software": SOFTWARE,
        "capture": {
            "size": synth.capture.size,
            "focal_px": focal_px(synth),
            "distance_mm": synth.capture.distance_mm,
            "radius_mm": synth.capture.radius_mm,
            "radius_over_distance": steady.radius_over_distance,
            "hidden_half_angle_deg": steady.hidden_half_angle().to_degrees(),
            "forward": steady.forward.to_array(),
            "right": steady.right.to_array(),
            "up": steady.up.to_array(),
            "fps": synth.fps,
        },
        "maps": {
            "size": synth.truth.size,
            "frames": "latlong.####.exr",
            "mask": "mask.png",
            "mask_values": {"seen": MASK_SEEN, "hidden": MASK_HIDDEN, "rig": MASK_RIG},
        },
        "frames": frames,
    })
}

/// Half-angle in radians of a cone about the camera, seen from the ball, that holds the rig with a margin; 0 where there is
/// none.
pub fn rig_half_angle(synth: &Synth) -> f32 {
    if !synth.rig.on {
        return 0.0;
    }
    let [right, up, forward] = synth.rig.half_size_m;
    let distance = synth.capture.distance_mm * 1e-3 - forward;
    1.2 * right.hypot(up).atan2(distance.max(1e-3))
}

/// A shot of a sphere on a shadow catcher, where the ball is, as the plate's camera sees it.
pub(super) fn shot_toml(synth: &Synth) -> String {
    let steady = ball(synth);
    let capture = &synth.capture;
    let camera = plate_camera(synth, 1);
    let vector = |v: Vec3| format!("[{:?}, {:?}, {:?}]", v.x, v.y, v.z);
    let place = Vec3::from(synth.stage.from_m);
    let floor = place - 0.2 * Vec3::Z;
    // Without Fresnel's rise towards the rim the ball is grey throughout, which a scale undoes.
    let (reflectance, scale) = match synth.ball.fresnel {
        true => (Vec3::from(synth.ball.tint), 1.0),
        false => (Vec3::ONE, 1.0 / synth.ball.tint[1]),
    };
    let [width, height] = synth.plate.size;
    let backplate = match (synth.plate.on, synth.plate.format) {
        (false, _) => String::new(),
        (true, PlateFormat::Png) => "[backplate]\nframes = \"plate/plate.####.png\"\n\n".to_owned(),
        (true, PlateFormat::Exr) => "[backplate]\nframes = \"plate/plate.####.exr\"\n\n".to_owned(),
    };
    let probe = match capture.on {
        true => format!(
            "[probe]\nframes = \"capture/ball.####.exr\"\nmapping = \"mirror-ball\"\nfps = {fps:?}\nscale = {scale:?}\n\n\
             [probe.ball]\ndistance_mm = {distance:?}\nradius_mm = {radius:?}\nforward = {forward}\nup = {ball_up}\n\
             reflectance = {reflectance}\nrig_deg = {rig_deg:.1}\n\n",
            fps = synth.fps,
            distance = capture.distance_mm,
            radius = capture.radius_mm,
            forward = vector(steady.forward),
            ball_up = vector(steady.up),
            reflectance = vector(reflectance),
            rig_deg = rig_half_angle(synth).to_degrees(),
        ),
        false => format!(
            "[probe]\nframes = \"truth/latlong.####.exr\"\nfps = {:?}\n\n",
            synth.fps
        ),
    };
    format!(
        "# A sphere where the mirror ball was, seen by the second camera.\n\n\
         [image]\nsize = [{width}, {height}]\nexposure_ev = {exposure:?}\n\n\
         [camera]\neye = {eye}\ntarget = {target}\nup = {up}\nfov_x_deg = {fov:?}\n\n\
         {probe}\
         {backplate}\
         [[object]]\nmesh = \"sphere\"\nscale = 0.2\ntranslate = {place}\n\
         material = {{ diffuse = [0.3, 0.3, 0.3], specular = [0.6, 0.6, 0.6], exponent = 200 }}\n\n\
         [[object]]\nmesh = \"plane\"\nscale = 3\ntranslate = {floor}\ncatcher = true\n",
        exposure = synth.plate.exposure_ev,
        eye = vector(camera.eye),
        target = vector(camera.target),
        up = vector(camera.up),
        fov = synth.plate.fov_x_deg,
        place = vector(place),
        floor = vector(floor),
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_mask_is_the_hidden_cone_and_the_rig() {
        let mut synth = Synth::default();
        synth.capture.radius_mm = 200.0;
        let size = UVec2::new(256, 128);
        let with_rig = mask(&synth, size);
        synth.rig.on = false;
        let without = mask(&synth, size);
        let steady = ball(&synth);
        for (i, value) in without.iter().enumerate() {
            let d = texel_direction(UVec2::new(i as u32 % 256, i as u32 / 256), size);
            let expected = if steady.is_hidden(d) {
                MASK_HIDDEN
            } else {
                MASK_SEEN
            };
            assert_eq!(*value, expected, "{d}");
        }
        // The rig is about −x, and nowhere else.
        let at = |d: Vec3| {
            let texel = glimt_probe::latlong::direction_to_texel(d, size);
            with_rig[(texel.y * size.x + texel.x) as usize]
        };
        assert_eq!(at(Vec3::NEG_X), MASK_RIG);
        assert_eq!(at(Vec3::X), MASK_HIDDEN);
        assert_eq!(at(Vec3::Y), MASK_SEEN);
        let count = |mask: &[u8], value| mask.iter().filter(|v| **v == value).count();
        assert_eq!(count(&with_rig, MASK_HIDDEN), count(&without, MASK_HIDDEN));
        // 0.24 m × 0.2 m at 1 m from the ball, about: 0.048 sr, and a texel at the horizon has 6·10⁻⁴.
        let rig = count(&with_rig, MASK_RIG);
        assert!((70..90).contains(&rig), "{rig}");
    }

    #[test]
    fn the_shot_is_toml_and_names_what_is_written() {
        let shot: toml::Table = toml::from_str(&shot_toml(&Synth::default())).unwrap();
        assert_eq!(shot["probe"]["mapping"].as_str(), Some("mirror-ball"));
        assert_eq!(shot["probe"]["ball"]["radius_mm"].as_float(), Some(50.0));
        assert_eq!(
            shot["backplate"]["frames"].as_str(),
            Some("plate/plate.####.png")
        );
        let mut synth = Synth::default();
        synth.capture.on = false;
        let shot: toml::Table = toml::from_str(&shot_toml(&synth)).unwrap();
        let frames = shot["probe"]["frames"].as_str();
        assert_eq!(frames, Some("truth/latlong.####.exr"));
        assert!(shot["probe"].get("ball").is_none());
    }
}
