//! Host file: the keys of a simulated capture, with the default of every one.

use crate::shot::parse::Document;
use crate::shot::words;
use serde::{Deserialize, Serialize};

/// A simulated capture: what surrounds the ball, the ball and the camera before it, and what happens over time. Lengths are in
/// metres unless a name says otherwise; radiance is in the unit of the light map.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
#[serde(default, deny_unknown_fields)]
pub struct Synth {
    /// Number of frames; they are numbered from 1.
    pub frames: u32,
    /// Frames per second, for the shot that is written.
    pub fps: f32,
    /// Seed of shake, noise and clouds.
    pub seed: u32,
    /// The surroundings.
    pub light: Light,
    /// The camera before the ball.
    pub capture: Capture,
    /// The ball's surface.
    pub ball: Ball,
    /// The rig that is reflected in front.
    pub rig: Rig,
    /// Where the surroundings are.
    pub stage: Surroundings,
    /// The sun.
    pub sun: Sun,
    /// Lamps.
    #[serde(rename = "lamp")]
    pub lamps: Vec<Lamp>,
    /// Clouds.
    pub clouds: Clouds,
    /// What passes in front of the surroundings.
    pub occluder: Occluder,
    /// The ball camera's sensor.
    pub noise: Noise,
    /// The second camera.
    pub plate: Plate,
    /// The truth.
    pub truth: Truth,
    /// What is written.
    pub output: Output,
}

/// The surroundings: a lat-long map.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
#[serde(default, deny_unknown_fields)]
pub struct Light {
    /// A lat-long HDR image; the built-in sky, if empty.
    pub map: String,
    /// Turns it counter-clockwise, seen from above, in degrees.
    pub rotate_z_deg: f32,
    /// Factor on its radiance.
    pub scale: f32,
}

/// The camera before the ball. The defaults are those of Hajisharif et al. 2012, § 4.1.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
#[serde(default, deny_unknown_fields)]
pub struct Capture {
    /// Whether the ball is filmed. Without, the truth is the light.
    pub on: bool,
    /// Width and height in pixels.
    pub size: [u32; 2],
    /// Width of a pixel on the sensor, in micrometres.
    pub pixel_um: f32,
    /// Focal length in millimetres.
    pub lens_mm: f32,
    /// From the centre of projection to the ball's centre, in millimetres.
    pub distance_mm: f32,
    /// Radius of the ball, in millimetres; the paper names 50, 40 and 25.
    pub radius_mm: f32,
    /// Direction from the camera to the ball.
    pub forward: [f32; 3],
    /// A direction that is up in the image.
    pub up: [f32; 3],
    /// How far the ball's centre strays from the middle of the image along x and y, in pixels RMS.
    pub jitter_px: f32,
    /// How far the camera rolls, in degrees RMS.
    pub jitter_roll_deg: f32,
    /// Samples of a pixel that shows one texel of the light map; one that shows more takes more.
    pub supersampling: u32,
    /// Store 16-bit floats.
    pub half: bool,
}

/// The ball's surface.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
#[serde(default, deny_unknown_fields)]
pub struct Ball {
    /// Reflectance at normal incidence, linear RGB.
    pub tint: [f32; 3],
    /// Whether the reflectance rises towards the rim (Schlick's Fresnel).
    pub fresnel: bool,
}

/// A box around the ball camera that is reflected in the middle of the ball.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
#[serde(default, deny_unknown_fields)]
pub struct Rig {
    /// Whether there is one.
    pub on: bool,
    /// Half of its extent to the right, up and forward.
    pub half_size_m: [f32; 3],
    /// Its radiance, as a share of the mean radiance around it.
    pub albedo: f32,
}

words! {
    /// The shell on which the map lies.
    Shape {
        /// At infinity: moving changes nothing.
        #[default] Infinite = "infinite",
        /// A sphere.
        Sphere = "sphere",
        /// A box.
        Box = "box",
    }
}
words! {
    /// How plate frames are stored.
    PlateFormat {
        /// 8 bits, sRGB, clipped.
        #[default] Png = "png",
        /// Linear radiance.
        Exr = "exr",
    }
}

/// Where the surroundings are, and where the ball is carried through them.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
#[serde(default, deny_unknown_fields)]
pub struct Surroundings {
    /// The shell on which the map lies, sun and lamps included. Its centre, where the map was taken, is the origin.
    pub shape: Shape,
    /// Its whole extent along x, y and z; a sphere takes the first.
    pub size_m: [f32; 3],
    /// The ball's centre in the first frame.
    pub from_m: [f32; 3],
    /// The ball's centre in the last frame.
    pub to_m: [f32; 3],
}

/// The sun: the map's brightest blob, or that of the built-in sky.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
#[serde(default, deny_unknown_fields)]
pub struct Sun {
    /// Whether there is one. Without, the map's brightest blob is taken out.
    pub on: bool,
    /// Angular radius of the disc that takes the blob's place where it moves or has an irradiance of its own, in degrees.
    pub radius_deg: f32,
    /// Irradiance on what faces it, linear RGB; the map's own, if not given.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub irradiance: Option<[f32; 3]>,
    /// Azimuth (counter-clockwise from +x) and elevation in the first frame, in degrees; where the map has it, if not given.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub from_deg: Option<[f32; 2]>,
    /// The same in the last frame; that of the first, if not given.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub to_deg: Option<[f32; 2]>,
}

/// A lamp: a disc on the stage. With `to_…` it moves, at a constant rate in both angles, until the last frame.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
#[serde(default, deny_unknown_fields)]
pub struct Lamp {
    /// Counter-clockwise from +x, seen from above, in degrees.
    pub azimuth_deg: f32,
    /// Above the horizon, in degrees.
    pub elevation_deg: f32,
    /// Azimuth in the last frame, 360 more for an orbit; that of the first, if not given.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub to_azimuth_deg: Option<f32>,
    /// Elevation in the last frame; that of the first, if not given.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub to_elevation_deg: Option<f32>,
    /// Angular radius, in degrees.
    pub radius_deg: f32,
    /// Radiance before it flickers, linear RGB.
    pub radiance: [f32; 3],
    /// The share of it that flickering takes away at most.
    pub flicker: f32,
}

/// Clouds: a field of attenuation above the horizon that drifts before sky and sun.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
#[serde(default, deny_unknown_fields)]
pub struct Clouds {
    /// The share of the sky that they take up, 0 for none.
    pub cover: f32,
    /// Optical depth where they are thickest.
    pub depth: f32,
    /// Size of the largest ones, in heights of the layer above the ground.
    pub scale: f32,
    /// How far they drift from the first frame to the last along x and y, in heights of the layer.
    pub drift: [f32; 2],
}

/// A ball that passes at a finite distance, before everything.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
#[serde(default, deny_unknown_fields)]
pub struct Occluder {
    /// Its radius; 0 for none.
    pub radius_m: f32,
    /// Its centre in the first frame.
    pub from_m: [f32; 3],
    /// Its centre in the last frame.
    pub to_m: [f32; 3],
    /// Its radiance, linear RGB.
    pub radiance: [f32; 3],
}

/// The sensor: exposures that are fused into one radiance.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
#[serde(default, deny_unknown_fields)]
pub struct Noise {
    /// Exposures of a frame; 0 for a sensor without noise.
    pub exposures: u32,
    /// Stops from one to the next.
    pub stops: f32,
    /// Electrons at which a pixel clips.
    pub full_well: f32,
    /// Read noise in electrons RMS.
    pub read_noise: f32,
    /// Bits of the converter.
    pub bits: u32,
    /// Radiance at which the shortest exposure clips; a little above the brightest there is, if not given.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub clip_radiance: Option<f32>,
}

/// The second camera, which films the backplate. It is carried along with the first.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
#[serde(default, deny_unknown_fields)]
pub struct Plate {
    /// Whether there is one.
    pub on: bool,
    /// Width and height in pixels.
    pub size: [u32; 2],
    /// Horizontal field of view, in degrees.
    pub fov_x_deg: f32,
    /// From the ball camera, to the right, up and forward.
    pub offset_m: [f32; 3],
    /// Where it looks; as the ball camera, if not given.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub direction: Option<[f32; 3]>,
    /// How its frames are stored.
    pub format: PlateFormat,
    /// Its exposure in stops.
    pub exposure_ev: f32,
    /// Rays through each pixel.
    pub rays_per_pixel: u32,
    /// A display-referred lat-long picture of the same place to look at instead of the light map: sharper, and the same in
    /// every frame.
    pub panorama: String,
}

/// The truth.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
#[serde(default, deny_unknown_fields)]
pub struct Truth {
    /// Width and height of the lat-long maps.
    pub size: [u32; 2],
}

/// What is written.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
#[serde(default, deny_unknown_fields)]
pub struct Output {
    /// Folder.
    pub dir: String,
}

impl Document for Synth {
    const NAME: &'static str = "a simulated capture";
    const EXAMPLE: &'static str = "capture.radius_mm=40";
    const LISTS: &'static [&'static str] = &["lamp"];
}

impl Default for Synth {
    fn default() -> Self {
        Self {
            frames: 24,
            fps: 25.0,
            seed: 1,
            light: Light::default(),
            capture: Capture::default(),
            ball: Ball::default(),
            rig: Rig::default(),
            stage: Surroundings::default(),
            sun: Sun::default(),
            lamps: Vec::new(),
            clouds: Clouds::default(),
            occluder: Occluder::default(),
            noise: Noise::default(),
            plate: Plate::default(),
            truth: Truth::default(),
            output: Output::default(),
        }
    }
}

impl Default for Light {
    fn default() -> Self {
        Self {
            map: String::new(),
            rotate_z_deg: 0.0,
            scale: 1.0,
        }
    }
}

impl Default for Capture {
    fn default() -> Self {
        Self {
            on: true,
            size: [2400, 1700],
            pixel_um: 5.0,
            lens_mm: 100.0,
            distance_mm: 1250.0,
            radius_mm: 50.0,
            forward: [1.0, 0.0, 0.0],
            up: [0.0, 0.0, 1.0],
            jitter_px: 2.0,
            jitter_roll_deg: 0.1,
            supersampling: 4,
            half: false,
        }
    }
}

impl Default for Ball {
    fn default() -> Self {
        Self {
            tint: [0.72, 0.72, 0.70],
            fresnel: true,
        }
    }
}

impl Default for Rig {
    fn default() -> Self {
        Self {
            on: true,
            half_size_m: [0.12, 0.1, 0.15],
            albedo: 0.03,
        }
    }
}

impl Default for Surroundings {
    fn default() -> Self {
        Self {
            shape: Shape::Infinite,
            size_m: [20.0, 20.0, 20.0],
            from_m: [0.0; 3],
            to_m: [0.0; 3],
        }
    }
}

impl Default for Sun {
    fn default() -> Self {
        Self {
            on: true,
            radius_deg: 0.5,
            irradiance: None,
            from_deg: None,
            to_deg: None,
        }
    }
}

impl Default for Lamp {
    fn default() -> Self {
        Self {
            azimuth_deg: 0.0,
            elevation_deg: 30.0,
            to_azimuth_deg: None,
            to_elevation_deg: None,
            radius_deg: 2.0,
            radiance: [100.0; 3],
            flicker: 0.0,
        }
    }
}

impl Default for Clouds {
    fn default() -> Self {
        Self {
            cover: 0.0,
            depth: 2.0,
            scale: 1.0,
            drift: [1.0, 0.5],
        }
    }
}

impl Default for Occluder {
    fn default() -> Self {
        Self {
            radius_m: 0.0,
            from_m: [-1.0, 3.0, 0.0],
            to_m: [-1.0, -3.0, 0.0],
            radiance: [0.0; 3],
        }
    }
}

impl Default for Noise {
    fn default() -> Self {
        Self {
            exposures: 8,
            stops: 3.0,
            full_well: 30_000.0,
            read_noise: 4.0,
            bits: 14,
            clip_radiance: None,
        }
    }
}

impl Default for Plate {
    fn default() -> Self {
        Self {
            on: true,
            size: [1280, 720],
            fov_x_deg: 50.0,
            offset_m: [0.0, 0.12, 0.0],
            direction: None,
            format: PlateFormat::Png,
            exposure_ev: 0.0,
            rays_per_pixel: 4,
            panorama: String::new(),
        }
    }
}

impl Default for Truth {
    fn default() -> Self {
        Self { size: [1024, 512] }
    }
}

impl Default for Output {
    fn default() -> Self {
        Self {
            dir: "synth".to_owned(),
        }
    }
}
