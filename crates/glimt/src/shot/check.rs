//! Host file: what a shot must fulfil beyond being well-formed.

use super::parse::Source;
use super::{
    Backplate, Ball, Camera, Colour, Image, Mapping, Method, Output, Probe, Prt, Shot, range,
};
use crate::error::{Error, Result};
use glimt_render_gpu::prepare::bake;
use glimt_render_gpu::prepare::scene_build::MAX_COORDINATE;
use glimt_render_gpu::settings::SettingError;

/// Largest width or height of an image.
const MAX_SIDE: u32 = 32_768;

/// Most pixels of an image, 2²⁸: their linear and display values take 5 GiB.
const MAX_PIXELS: u64 = 1 << 28;

/// Most texels of an image that is read, whatever a shot allows.
const MAX_INPUT_TEXELS: u64 = 1 << 32;

/// Largest exposure either way, in stops: 2¹⁰⁰ is a number of 32 bits, and so is its inverse.
const MAX_EXPOSURE_EV: f32 = 100.0;

/// Checks every value of a shot.
///
/// # Errors
/// The first value that cannot be rendered, with its key, its place and what would do.
pub fn check(shot: &Shot, source: &Source) -> Result<()> {
    check_image(&shot.image, source)?;
    check_camera(shot, source)?;
    check_probe(&shot.probe, source)?;
    if let Some(plate) = &shot.backplate {
        check_plate(plate, source)?;
    }
    if let Some(colour) = &shot.probe.colour {
        check_colour(colour, source)?;
    }
    check_objects(shot, source)?;
    check_render(shot, source)?;
    check_output(&shot.output, source)
}

fn check_image(image: &Image, source: &Source) -> Result<()> {
    let bad = |key: &str, what: &str, fix: &str| Err(source.error(key, what).fix(fix));
    if image.size.iter().any(|&n| n == 0 || n > MAX_SIDE) {
        return bad("image.size", "a side is 0 or above 32768", "as [1280, 720]");
    }
    let [width, height] = image.size.map(u64::from);
    if width * height > MAX_PIXELS {
        return bad(
            "image.size",
            "it has more than 2^28 pixels",
            "as [1280, 720]; [16384, 16384] is the largest square",
        );
    }
    if image.rays_per_pixel == 0 || image.rays_per_pixel > 65_536 {
        return bad(
            "image.rays_per_pixel",
            "it is not between 1 and 65536",
            "16 is usual",
        );
    }
    if !(image.exposure_ev.abs() <= MAX_EXPOSURE_EV) {
        return bad(
            "image.exposure_ev",
            "it is not between -100 and 100 stops",
            "0 leaves the image as it is, 1 doubles its brightness",
        );
    }
    if !(image.pixel_aspect >= 0.05 && image.pixel_aspect <= 20.0) {
        return bad(
            "image.pixel_aspect",
            "it is not between 0.05 and 20",
            "1 is a square pixel, 2 one of an anamorphic lens",
        );
    }
    if !(1..=MAX_INPUT_TEXELS).contains(&image.max_texels) {
        return bad(
            "image.max_texels",
            "it is not between 1 and 2^32",
            "268435456 is the default, 16384 × 16384",
        );
    }
    Ok(())
}

fn check_probe(probe: &Probe, source: &Source) -> Result<()> {
    let bad = |key: &str, what: &str, fix: &str| Err(source.error(key, what).fix(fix));
    if probe.frames.is_empty() {
        return bad(
            "probe.frames",
            "the shot has no light",
            "name an image or a sequence, as [probe] frames = \"light.####.exr\"",
        );
    }
    finite(source, "probe.rotate_z_deg", &[probe.rotate_z_deg])?;
    if !(probe.scale >= 0.0 && probe.scale <= 1e12) {
        return bad(
            "probe.scale",
            "it is not between 0 and 1e12",
            "1 leaves the light as it is",
        );
    }
    if !(probe.fps > 0.0 && probe.fps <= 1000.0) {
        return bad("probe.fps", "it is not between 0 and 1000", "25 is usual");
    }
    if probe.mapping == Some(Mapping::MirrorBall) {
        check_ball(&probe.ball.clone().unwrap_or_default(), source)?;
    } else if probe.ball.is_some() {
        return bad(
            "probe.ball",
            "it belongs to mapping = \"mirror-ball\" alone",
            "remove it",
        );
    }
    Ok(())
}

fn check_plate(plate: &Backplate, source: &Source) -> Result<()> {
    let bad = |key: &str, what: &str, fix: &str| Err(source.error(key, what).fix(fix));
    if plate.frames.is_empty() {
        return bad(
            "backplate",
            "it names no footage",
            "as frames = \"plate.####.png\"; without the table the light is the background",
        );
    }
    if plate.fps.is_some_and(|fps| !(fps >= 0.1 && fps <= 1000.0)) {
        return bad(
            "backplate.fps",
            "it is not between 0.1 and 1000",
            "leave it out where the footage runs at probe.fps",
        );
    }
    Ok(())
}

fn check_render(shot: &Shot, source: &Source) -> Result<()> {
    let bad = |key: &str, what: &str, fix: &str| Err(source.error(key, what).fix(fix));
    let render = &shot.render;
    render.check().map_err(|e| refused(source, &e))?;
    check_prt(&render.prt, source)?;
    let estimator = render.estimator();
    let samples = estimator.map_or(1, |estimator| estimator.samples_per_ray());
    if u64::from(samples) * u64::from(shot.image.rays_per_pixel) > u64::from(u32::MAX) {
        return bad(
            "image.rays_per_pixel",
            &format!("with {samples} samples on each ray a pixel takes 2^32 of them"),
            "lower one of the two",
        );
    }
    let mut aovs = shot.output.aovs.iter();
    if let Some(aov) = aovs.find(|aov| !aov.is_given_by(render.method)) {
        let others = match aov.is_given_by(Method::Smc) {
            true => "\"smc\"",
            false => "\"cells\" or \"product\"",
        };
        let word = serde_json::to_string(aov).unwrap_or_default();
        return bad(
            "output.aovs",
            &format!("{word} belongs to another method"),
            &format!("leave it out, or set render.method = {others}"),
        );
    }
    if !render.frames.is_empty() {
        range::parse(&render.frames).map_err(|e| {
            let error = source.error("render.frames", e.what);
            error.fix(e.fix.unwrap_or_default())
        })?;
    }
    Ok(())
}

fn check_output(output: &Output, source: &Source) -> Result<()> {
    let bad = |key: &str, what: &str, fix: &str| Err(source.error(key, what).fix(fix));
    if output.dir.is_empty() {
        return bad("output.dir", "it is empty", "\".\" is the shot's folder");
    }
    if !output.aovs.is_empty() && !output.exr {
        return bad(
            "output.aovs",
            "they are layers of the EXR, and output.exr is false",
            "set output.exr = true, or leave the list empty",
        );
    }
    if !output.exr && !output.png && output.video.is_empty() {
        return bad(
            "output.exr",
            "nothing would be written",
            "turn on exr or png, or name a video",
        );
    }
    let video = std::path::Path::new(&output.video);
    if !output.video.is_empty() && video.extension().is_none_or(|e| e != "mp4") {
        return bad(
            "output.video",
            "the name does not end in .mp4",
            "as \"shot.mp4\"; empty for no video",
        );
    }
    Ok(())
}

/// Checks the keys of a mirror ball.
///
/// # Errors
/// As [`check`].
pub fn check_ball(ball: &Ball, source: &Source) -> Result<()> {
    let bad = |key: &str, what: &str, fix: &str| {
        Err(source.error(&format!("probe.ball.{key}"), what).fix(fix))
    };
    if !(ball.radius_mm > 0.0 && ball.radius_mm.is_finite()) {
        return bad(
            "radius_mm",
            "it is not above 0",
            "a ball of 100 mm across has 50",
        );
    }
    // The mapping's formulas are exact, and tested, up to 0.95.
    if !(ball.distance_mm * 0.95 >= ball.radius_mm) {
        return bad(
            "distance_mm",
            "the camera would stand in the ball, or touch it",
            "it is measured to the ball's centre; inf is an orthographic camera",
        );
    }
    if ball.centre_px.is_some() != ball.radius_px.is_some() {
        let key = if ball.centre_px.is_some() {
            "radius_px"
        } else {
            "centre_px"
        };
        return bad(
            key,
            "it is missing: centre_px and radius_px belong together",
            "give both, or none: then the ball is found",
        );
    }
    if ball.radius_px.is_some_and(|r| !(r >= 4.0 && r < 1e6)) {
        return bad(
            "radius_px",
            "it is not between 4 and 1e6",
            "leave it out to have the ball found",
        );
    }
    if let Some(centre) = ball.centre_px {
        finite(source, "probe.ball.centre_px", &centre)?;
    }
    for (key, v) in [("forward", ball.forward), ("up", ball.up)] {
        finite(source, &format!("probe.ball.{key}"), &v)?;
        if v == [0.0; 3] {
            return bad(
                key,
                "it has no length",
                "forward = [1, 0, 0] and up = [0, 0, 1] is a level camera",
            );
        }
    }
    let [forward, up] = [ball.forward, ball.up].map(|v| glam::Vec3::from(v).normalize());
    if !(forward.cross(up).length() > 1e-3) {
        return bad(
            "up",
            "it lies along forward",
            "choose a direction across it",
        );
    }
    if ball
        .size
        .is_some_and(|s| s.contains(&0) || s.iter().any(|&n| n > MAX_SIDE))
    {
        return bad("size", "a side is 0 or above 32768", "as [1024, 512]");
    }
    if ball.reflectance.iter().any(|r| !(*r > 0.0 && *r <= 1.0)) {
        return bad(
            "reflectance",
            "a channel is not above 0 and at most 1",
            "polished steel has about 0.6, silver 0.95",
        );
    }
    if !(ball.rim_px >= 0.0 && ball.rim_px <= 100.0) {
        return bad("rim_px", "it is not between 0 and 100", "1.5 is usual");
    }
    if !(ball.rig_deg >= 0.0 && ball.rig_deg <= 80.0) {
        return bad(
            "rig_deg",
            "it is not between 0 and 80",
            "0 leaves the camera's reflection in the light",
        );
    }
    Ok(())
}

/// What the renderer says of a setting, with the setting's place.
pub fn refused(source: &Source, error: &SettingError) -> Error {
    let key = match error.table {
        "" => format!("render.{}", error.key),
        table => format!("render.{table}.{}", error.key),
    };
    source.error(&key, &error.what).fix(error.fix)
}

fn check_prt(prt: &Prt, source: &Source) -> Result<()> {
    let bad = |key: &str, what: &str, fix: &str| {
        Err(source.error(&format!("render.prt.{key}"), what).fix(fix))
    };
    if !(1..=bake::MAX_BANDS).contains(&prt.bands) {
        return bad("bands", "it is not between 1 and 6", "5 is usual");
    }
    if !(1..=bake::MAX_DIRECTIONS).contains(&prt.directions) {
        return bad(
            "directions",
            "it is not between 1 and 1048576",
            "2500 is usual, 100 a draft",
        );
    }
    Ok(())
}

fn check_colour(colour: &Colour, source: &Source) -> Result<()> {
    let numbers = colour
        .matrix
        .iter()
        .flatten()
        .flatten()
        .chain(colour.gains.iter().flatten());
    if numbers.into_iter().any(|n| !(n.abs() <= 1e6)) {
        return Err(source
            .error("probe.colour", "a factor is not a number below 1e6")
            .fix("1 leaves a channel as it is"));
    }
    if colour
        .gains
        .is_some_and(|gains| gains.iter().any(|g| *g < 0.0))
    {
        return Err(source
            .error("probe.colour.gains", "one is below 0")
            .fix("1 leaves a channel as it is"));
    }
    if colour.grey.is_some() && !colour.patches.is_empty() {
        return Err(source
            .error("probe.colour.grey", "patches are given too")
            .fix("keep one of the two: patches match the backplate, grey needs none"));
    }
    Ok(())
}

fn check_camera(shot: &Shot, source: &Source) -> Result<()> {
    let camera = &shot.camera;
    let vectors = [("camera.eye", camera.eye), ("camera.target", camera.target)];
    for (key, vector) in vectors {
        if let Some(v) = vector {
            within_world(source, key, &v)?;
        }
    }
    finite(source, "camera.up", &camera.up)?;
    if camera.up == [0.0; 3] {
        return Err(source
            .error("camera.up", "it has no length")
            .fix("[0, 0, 1] is up in the world"));
    }
    if !(camera.fov_x_deg > 0.0 && camera.fov_x_deg < 180.0) {
        return Err(source
            .error("camera.fov_x_deg", "it is not between 0 and 180")
            .fix("40 is usual"));
    }
    if !camera.gltf.is_empty() && (camera.eye.is_some() || camera.target.is_some()) {
        return Err(source
            .error("camera.gltf", "eye or target is given too")
            .fix("keep one of the two ways to place the camera"));
    }
    check_keys(camera, source)
}

fn check_keys(camera: &Camera, source: &Source) -> Result<()> {
    if camera.keys.is_empty() {
        return Ok(());
    }
    if !camera.gltf.is_empty() || camera.eye.is_some() || camera.target.is_some() {
        let other = if camera.gltf.is_empty() {
            "eye or target"
        } else {
            "gltf"
        };
        return Err(source
            .error("camera.key", format!("camera.{other} is given too"))
            .fix("keep one of the ways to place the camera; keys say eye and target themselves"));
    }
    for (i, key) in camera.keys.iter().enumerate() {
        let name = |part: &str| format!("camera.key.{i}.{part}");
        within_world(source, &name("eye"), &key.eye)?;
        within_world(source, &name("target"), &key.target)?;
        if let Some(up) = key.up {
            finite(source, &name("up"), &up)?;
        }
        if key.fov_x_deg.is_some_and(|fov| !(fov > 0.0 && fov < 180.0)) {
            return Err(source
                .error(&name("fov_x_deg"), "it is not between 0 and 180")
                .fix("40 is usual"));
        }
        // Frames are counted in f32 between keys.
        if key.frame > 1 << 24 {
            return Err(source
                .error(&name("frame"), "it is above 16777216")
                .fix("check the number"));
        }
        let before = i.checked_sub(1).map(|before| camera.keys[before].frame);
        if let Some(before) = before.filter(|before| *before >= key.frame) {
            let what = match before == key.frame {
                true => format!("two keys are at frame {before}"),
                false => format!("it comes after the key at frame {before}"),
            };
            return Err(source
                .error(&name("frame"), what)
                .fix("list the keys by growing frames, each once"));
        }
    }
    Ok(())
}

fn check_objects(shot: &Shot, source: &Source) -> Result<()> {
    if shot.objects.is_empty() {
        return Err(source
            .error("object", "the shot has no object")
            .fix("add one, as [[object]] mesh = \"model.glb\""));
    }
    for (i, object) in shot.objects.iter().enumerate() {
        let key = |name: &str| format!("object.{i}.{name}");
        if object.mesh.is_empty() {
            return Err(source.error(&key("mesh"), "the object has no mesh").fix(
                "name a file (.glb .gltf .obj .ply .stl), or \"sphere\", \"plane\", \"armillary\" or \"helicopter\"",
            ));
        }
        within_world(source, &key("translate"), &object.translate)?;
        finite(source, &key("rotate_deg"), &object.rotate_deg)?;
        if !(object.scale.abs() >= 1.0 / MAX_COORDINATE && object.scale.abs() <= MAX_COORDINATE) {
            return Err(source
                .error(
                    &key("scale"),
                    "it is not between 1e-9 and 1e9, nor the negative of such a number",
                )
                .fix("1 leaves it as it is"));
        }
        if !(object.crease_deg >= 0.0 && object.crease_deg <= 180.0) {
            return Err(source
                .error(&key("crease_deg"), "it is not between 0 and 180")
                .fix("40 keeps the edges of most things sharp, and what is round round"));
        }
        if object.subdivide > 10 {
            return Err(source
                .error(&key("subdivide"), "it is above 10")
                .fix("each step makes four triangles of one: 6 makes 8192 of a plane"));
        }
        if let Some(material) = &object.material {
            check_material(material, i, source)?;
        }
        if !(object.reflection >= 0.0 && object.reflection <= 1.0) {
            return Err(source
                .error(&key("reflection"), "it is not between 0 and 1")
                .fix("0 is a matt surface"));
        }
        if object.reflection > 0.0 && object.catcher {
            return Err(source
                .error(
                    &key("reflection"),
                    "the object is a catcher, which takes shadows alone",
                )
                .fix("leave it out"));
        }
        if !(object.animation_offset_s.abs() <= 1e6) {
            return Err(source
                .error(&key("animation_offset_s"), "it is not between -1e6 and 1e6")
                .fix("0 begins with the animation's beginning"));
        }
        for (j, spin) in object.spins.iter().enumerate() {
            let key = |name: &str| key(&format!("spin.{j}.{name}"));
            within_world(source, &key("centre"), &spin.centre.map(f64::from))?;
            within_world(source, &key("axis"), &spin.axis.map(f64::from))?;
            if !(glam::Vec3::from(spin.axis).length() > 1e-6) {
                return Err(source
                    .error(&key("axis"), "it has no length")
                    .fix("[0, 0, 1] turns about the node's own z axis"));
            }
            if !(spin.deg_per_frame.abs() <= 1e6) {
                return Err(source
                    .error(&key("deg_per_frame"), "it is not between -1e6 and 1e6")
                    .fix("360 is a turn from each frame to the next, which looks still"));
            }
        }
    }
    Ok(())
}

fn check_material(material: &super::Material, object: usize, source: &Source) -> Result<()> {
    let key = |name: &str| format!("object.{object}.material.{name}");
    for (name, colour) in [
        ("diffuse", material.diffuse),
        ("specular", material.specular),
    ] {
        if colour.iter().any(|c| !(*c >= 0.0 && *c <= 1.0)) {
            return Err(source
                .error(&key(name), "a channel is not between 0 and 1")
                .fix("an albedo is the share of light that is reflected"));
        }
    }
    let sum = (0..3).map(|c| material.diffuse[c] + material.specular[c]);
    let largest = sum.fold(0.0, f32::max);
    if !(largest <= 1.000_001) {
        return Err(source
            .error(
                &key("diffuse"),
                format!("diffuse + specular is {largest:.3} in a channel: more light would leave than came"),
            )
            .fix("keep the sum at 1 or below"));
    }
    if !(material.exponent >= 0.0 && material.exponent <= 1e4) {
        return Err(source
            .error(&key("exponent"), "it is not between 0 and 10000")
            .fix("50 is glossy, 500 a near mirror"));
    }
    Ok(())
}

/// Vectors of the world reach as far as the renderer does.
fn within_world(source: &Source, key: &str, vector: &[f64; 3]) -> Result<()> {
    finite(source, key, &vector.map(|c| c as f32))?;
    if vector.iter().all(|c| c.abs() <= f64::from(MAX_COORDINATE)) {
        return Ok(());
    }
    Err(source
        .error(key, "it is beyond 1e9 units")
        .fix("the world ends there: use a larger unit"))
}

fn finite(source: &Source, key: &str, values: &[f32]) -> Result<()> {
    if values.iter().all(|v| v.is_finite()) {
        return Ok(());
    }
    let error: Error = source.error(key, "it is not a finite number");
    Err(error.fix("write a plain number"))
}
