//! Host file: the shot, with the default of every key. Only the probe and the objects have none.

pub mod check;
pub mod digest;
pub mod parse;
pub mod range;
mod render;

use crate::colour::encoding::Transfer;
use crate::colour::primaries::{self, Primaries};
pub use glimt_render_gpu::prepare::render::{Background, Filter, Pattern, Shadow, Tonemap};
pub use render::{METHODS, Method, Prt, Render};
use serde::{Deserialize, Serialize};

/// A shot: what is rendered, from where, under which light, how, and where it goes.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, Serialize)]
#[serde(default, deny_unknown_fields)]
pub struct Shot {
    /// The image.
    pub image: Image,
    /// Where it is seen from.
    pub camera: Camera,
    /// The light.
    pub probe: Probe,
    /// What stands in it.
    #[serde(rename = "object")]
    pub objects: Vec<Object>,
    /// Footage to lay the objects over.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub backplate: Option<Backplate>,
    /// How it is rendered.
    pub render: Render,
    /// What is written.
    pub output: Output,
}

/// The image.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
#[serde(default, deny_unknown_fields)]
pub struct Image {
    /// Width and height in pixels; where there is a backplate and this is not given, the backplate's.
    pub size: [u32; 2],
    /// Rays through each pixel.
    pub rays_per_pixel: u32,
    /// Where in its pixel a ray passes.
    #[serde(with = "glimt_render_gpu::words")]
    pub filter: Filter,
    /// Curve of the display image.
    #[serde(with = "glimt_render_gpu::words")]
    pub tonemap: Tonemap,
    /// Exposure of the display image, in stops.
    pub exposure_ev: f32,
    /// What is seen where no object is.
    #[serde(with = "glimt_render_gpu::words")]
    pub background: Background,
    /// The primaries that light and materials are rendered with.
    pub primaries: WorkingPrimaries,
    /// Width of a pixel over its height; where there is a backplate and this is not given, the backplate's.
    pub pixel_aspect: f32,
    /// The most texels that an image of light or footage may have: a file that says more is refused before it is read.
    pub max_texels: u64,
}

/// The default of `image.max_texels`: 16384 × 16384.
pub const MAX_TEXELS: u64 = 1 << 28;

/// A pinhole camera. Without `eye` and `target`, it looks at the objects from a little above.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
#[serde(default, deny_unknown_fields)]
pub struct Camera {
    /// Centre of projection.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub eye: Option<[f64; 3]>,
    /// A point in the middle of the image.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub target: Option<[f64; 3]>,
    /// A direction that is up in the image.
    pub up: [f32; 3],
    /// Horizontal field of view, in degrees.
    pub fov_x_deg: f32,
    /// Name of a camera in one of the glTF files, in place of all the above. It moves as its node does.
    pub gltf: String,
    /// What is between two keys.
    pub interpolation: Interpolation,
    /// Where it is in some frames, in place of `eye` and `target`; held before the first and after the last.
    #[serde(rename = "key", skip_serializing_if = "Vec::is_empty")]
    pub keys: Vec<CameraKey>,
}

/// The camera in one frame.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct CameraKey {
    /// Number of the frame.
    pub frame: i32,
    /// Centre of projection.
    pub eye: [f64; 3],
    /// A point in the middle of the image.
    pub target: [f64; 3],
    /// A direction that is up in the image; the camera's, if not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub up: Option<[f32; 3]>,
    /// Horizontal field of view, in degrees; the camera's, if not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub fov_x_deg: Option<f32>,
}

/// The light: HDR images of the surroundings.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
#[serde(default, deny_unknown_fields)]
pub struct Probe {
    /// File of a still, or of a sequence with `####` for the frame's number (or `%04d`, `$F4`, `@@@@`); `[#]` is a `#`.
    pub frames: String,
    /// How directions lie in the image; if not given, told by its proportions: 2:1 is lat-long, six squares are a cube.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub mapping: Option<Mapping>,
    /// Which layer, part or view of the file is the light; the one that is a picture by its name, if empty.
    #[serde(skip_serializing_if = "String::is_empty")]
    pub layer: String,
    /// The primaries of its colours; those that the file names, if not given.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub primaries: Option<NamedPrimaries>,
    /// Turns the light counter-clockwise, seen from above, in degrees.
    pub rotate_z_deg: f32,
    /// Factor on the radiance.
    pub scale: f32,
    /// Frames per second of the sequence, and of the video made from it; that of the backplate, if this is not given and the light is
    /// a still or as long as the backplate.
    pub fps: f32,
    /// Where the mirror ball is, for `mapping = "mirror-ball"`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub ball: Option<Ball>,
    /// How its colours become the backplate's.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub colour: Option<Colour>,
}

/// A mirror ball in the probe's frames, and what is made of it.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
#[serde(default, deny_unknown_fields)]
pub struct Ball {
    /// From the centre of projection to the ball's centre, in millimetres; `inf` for an orthographic camera.
    pub distance_mm: f32,
    /// Radius of the ball, in millimetres.
    pub radius_mm: f32,
    /// Centre of the ball in the image; found if not given.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub centre_px: Option<[f32; 2]>,
    /// Radius of the ball in the image; found if not given.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub radius_px: Option<f32>,
    /// Where the camera that films the ball looks, in the world.
    pub forward: [f32; 3],
    /// A direction that is up in its image.
    pub up: [f32; 3],
    /// Width and height of the lat-long map that is made, in texels; twice the ball's radius in pixels by once, if not given.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub size: Option<[u32; 2]>,
    /// Pixels that reach nearer to the ball's rim than this less one are not taken, since the background is mixed into them.
    pub rim_px: f32,
    /// Half-angle of the cone about the camera that is filled from its surroundings, in degrees: camera and rig, as they are
    /// reflected.
    pub rig_deg: f32,
    /// Share of the light that the ball reflects where it is seen straight on, red, green and blue; towards its rim it grows
    /// to 1 (Schlick's approximation of Fresnel's equations). 1 leaves the light as filmed.
    pub reflectance: [f32; 3],
    /// Whether roll of the camera is measured and removed.
    pub steady: bool,
}

/// How the probe's colours become the backplate's: first `matrix`, then `gains`, then what the patches say.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, Serialize)]
#[serde(default, deny_unknown_fields)]
pub struct Colour {
    /// Rows of a matrix for linear red, green and blue.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub matrix: Option<[[f32; 3]; 3]>,
    /// A factor for each channel.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub gains: Option<[f32; 3]>,
    /// A patch of the probe's images that is to be grey.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub grey: Option<Box4>,
    /// Patches that the probe and the backplate both show.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub patches: Vec<Patch>,
    /// The frame in which patches are read; the first, if not given.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub frame: Option<i32>,
}

/// A box in an image: left, top, width and height in pixels.
pub type Box4 = [u32; 4];

/// One surface in two images.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Patch {
    /// In the probe's.
    pub probe: Box4,
    /// In the backplate's.
    pub plate: Box4,
}

/// A mesh that stands in the scene. It is scaled, then turned about x, y, z (fixed axes), then moved.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
#[serde(default, deny_unknown_fields)]
pub struct Object {
    /// A mesh file, or `sphere` (radius 1), `plane` (2 × 2, facing +z), `armillary` (the sculpture of the demonstration), or
    /// `helicopter` (with the nodes `main rotor` and `tail rotor` to spin).
    pub mesh: String,
    /// Where it is moved to.
    pub translate: [f64; 3],
    /// Angles about x, y and z, in degrees.
    pub rotate_deg: [f32; 3],
    /// Factor on its size.
    pub scale: f32,
    /// The axis that is up in the file. Built-in meshes are made with z up.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub up: Option<Up>,
    /// Set its lowest point on z = 0 before it is moved.
    pub ground: bool,
    /// It is in the footage already: it takes shadows, hides what is behind it, and blocks no light.
    pub catcher: bool,
    /// Where a file has neither normals nor smoothing groups, faces that are turned by less than this against each other are smooth, in
    /// degrees: 0 makes all edges sharp, 180 none. Meshes of glTF files are flat then, as the format demands.
    pub crease_deg: f32,
    /// How often each triangle is cut in four: transfer (`render.method = "prt"`) is known at vertices alone.
    pub subdivide: u32,
    /// One material in place of the file's.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub material: Option<Material>,
    /// By the method "prt": how much of the light map it mirrors, beside its diffuse colour, 0 to 1.
    pub reflection: f32,
    /// Name of the animation of its file that plays, from the shot's first frame on; all of them if empty, none if `off`.
    pub animation: String,
    /// Whether it begins again after its last key, rather than to stay there.
    pub animation_loop: bool,
    /// Time of the animation in the shot's first frame, in seconds.
    pub animation_offset_s: f32,
    /// Nodes that turn.
    #[serde(rename = "spin", skip_serializing_if = "Vec::is_empty")]
    pub spins: Vec<Spin>,
}

/// The default of `object.N.crease_deg`.
pub const CREASE_DEG: f32 = 40.0;

/// The value of `object.N.animation` that plays none.
pub const ANIMATION_OFF: &str = "off";

/// A node that turns, with all that is in it, at a constant rate from the shot's first frame on.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Spin {
    /// Name of the node; all nodes of that name turn.
    pub node: String,
    /// The axis, in the node's own coordinates.
    #[serde(default = "z_axis")]
    pub axis: [f32; 3],
    /// A point of the axis, in the node's own coordinates.
    #[serde(default)]
    pub centre: [f32; 3],
    /// Degrees from one frame to the next, counter-clockwise seen from the axis's tip.
    pub deg_per_frame: f32,
}

fn z_axis() -> [f32; 3] {
    [0.0, 0.0, 1.0]
}

/// Blinn-Phong: `diffuse/π + specular · c(e) · (n·h)^e`.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
#[serde(default, deny_unknown_fields)]
pub struct Material {
    /// Diffuse albedo, linear RGB.
    pub diffuse: [f32; 3],
    /// Specular albedo at normal incidence, linear RGB.
    pub specular: [f32; 3],
    /// Exponent, 0 to 10⁴.
    pub exponent: f32,
}

/// Footage to lay the objects over: PNG, JPEG or TIFF, taken as sRGB unless the file says otherwise, or OpenEXR, linear.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, Serialize)]
#[serde(default, deny_unknown_fields)]
pub struct Backplate {
    /// File of a still, or of a sequence with `####` for the frame's number (or `%04d`, `$F4`, `@@@@`); `[#]` is a `#`.
    pub frames: String,
    /// How it takes shadows.
    #[serde(with = "glimt_render_gpu::words")]
    pub shadow: Shadow,
    /// How it is fitted to an image of other proportions.
    pub fit: Fit,
    /// Which layer, part or view of the file is the plate; the one that is a picture by its name, if empty.
    #[serde(skip_serializing_if = "String::is_empty")]
    pub layer: String,
    /// The primaries of its colours; those that the file names, if not given.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub primaries: Option<NamedPrimaries>,
    /// The curve of its numbers; that of its format, if not given.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub transfer: Option<NamedTransfer>,
    /// Frames per second, if not those of the probe: frames are then matched by time, from each one's first on.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub fps: Option<f32>,
    /// Number of its frame that belongs to the probe's first, less the probe's number. If not given, the first belongs to the first
    /// where both are equally long or their rates differ, and frames of one number belong together else.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub offset: Option<i32>,
}

/// What is written.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
#[serde(default, deny_unknown_fields)]
pub struct Output {
    /// Folder.
    pub dir: String,
    /// Linear float frames.
    pub exr: bool,
    /// Display frames.
    pub png: bool,
    /// An mp4 of the whole shot, if it has more than one frame; none if empty.
    pub video: String,
    /// Codec of the video.
    pub codec: Codec,
    /// Layers beside the image in the EXR.
    pub aovs: Vec<Aov>,
    /// The primaries of the EXR.
    pub primaries: OutputPrimaries,
}

macro_rules! words {
    ($(#[$doc:meta])* $name:ident { $($(#[$variant_doc:meta])* $variant:ident = $word:literal),+ $(,)? }) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, Serialize)]
        pub enum $name { $($(#[$variant_doc])* #[serde(rename = $word)] $variant),+ }
    };
}

pub(crate) use words;

words! {
    /// What is between two keys of the camera.
    Interpolation {
        /// A cubic curve through all keys.
        #[default] Smooth = "smooth",
        /// A straight line from each key to the next.
        Linear = "linear",
    }
}
words! {
    /// How directions lie in the probe's images.
    Mapping {
        /// Latitude and longitude, 2:1.
        #[default] LatLong = "lat-long",
        /// Angular map (light probe), 1:1.
        Angular = "angular",
        /// Photograph of a mirror ball.
        MirrorBall = "mirror-ball",
        /// Six faces: a row or a column of them, or a cross.
        Cube = "cube",
    }
}
words! {
    /// The primaries that light and materials are rendered with.
    WorkingPrimaries {
        /// Rec. 709.
        #[default] Rec709 = "rec709",
        /// AP1.
        AcesCg = "acescg",
    }
}
words! {
    /// The primaries of EXRs that are written.
    OutputPrimaries {
        /// Those of the backplate; without one, those that are rendered with.
        #[default] Plate = "plate",
        /// Rec. 709.
        Rec709 = "rec709",
        /// AP1.
        AcesCg = "acescg",
        /// AP0.
        Aces20651 = "aces2065-1",
    }
}
words! {
    /// Primaries of a file, in place of those that it names.
    NamedPrimaries {
        /// Rec. 709, also those of sRGB.
        #[default] Rec709 = "rec709",
        /// AP1.
        AcesCg = "acescg",
        /// AP0.
        Aces20651 = "aces2065-1",
        /// Rec. 2020.
        Rec2020 = "rec2020",
        /// P3 with the white D65.
        P3D65 = "p3-d65",
        /// Adobe RGB (1998).
        AdobeRgb = "adobe-rgb",
    }
}
words! {
    /// The curve of a file's numbers.
    NamedTransfer {
        /// That of sRGB.
        #[default] Srgb = "srgb",
        /// None.
        Linear = "linear",
        /// That of a camera by Rec. 709.
        Rec709 = "rec709",
    }
}
words! {
    /// The axis that is up in a mesh file.
    Up {
        /// As in glTF.
        #[default] Y = "y",
        /// As in the world here.
        Z = "z",
    }
}
words! {
    /// How a backplate is fitted to an image of other proportions.
    Fit {
        /// Stretched.
        #[default] Stretch = "stretch",
        /// Its middle, in its own proportions.
        Crop = "crop",
    }
}
words! {
    /// A layer beside the image.
    Aov {
        /// The objects alone, premultiplied.
        #[default] Object = "object",
        /// The share of the plate's light that is left.
        Catcher = "catcher",
        /// The catchers' radiance with the objects minus that without.
        Difference = "difference",
        /// Of the method "smc": the effective sample size, as a share of the particles.
        Ess = "ess",
        /// Of the method "smc": the logarithm of the normaliser's ratio between this frame and the one before.
        ZRatio = "z-ratio",
        /// Of the method "smc": frames since a ray was re-initialised.
        Age = "age",
        /// Of the method "smc": the share of rays that were re-initialised in this frame.
        Started = "started",
        /// Of the method "smc": sd(Z)/Z, the relative spread of the normalisers of a pixel's rays; 0 with one ray.
        ZSpread = "z-spread",
        /// Of the methods "cells" and "product": shadow rays of the pixel, without pilots.
        Rays = "rays",
        /// Of the methods "cells" and "product": the standard deviation, in luminance, that a shadow ray was expected to have. For
        /// "cells" it is what the expected visibilities leave of the light.
        VisibilityError = "visibility-error",
    }
}
words! {
    /// Settings under one name.
    Preset {
        /// None.
        #[default] None = "",
        /// The paper's samples, independent, on one ray through each pixel's centre: 15 + 15 by "mis", 20 of 400 candidates by "bis",
        /// 8 particles with 3 distributions between frames by "smc" (Kronander 2014), re-initialised by the ratio of normalisers,
        /// which is biased. Without compensation.
        Kronander = "kronander",
        /// 15 + 15 samples in strata, on one ray through each pixel's centre, without compensation.
        Stratified = "stratified",
    }
}
words! {
    /// Codec of the video.
    Codec {
        /// H.264 where `ffmpeg` is found, else AV1.
        #[default] Auto = "auto",
        /// AV1, encoded here.
        Av1 = "av1",
        /// H.264, encoded by `ffmpeg`.
        H264 = "h264",
    }
}

impl WorkingPrimaries {
    /// Their coordinates.
    #[must_use]
    pub fn primaries(self) -> Primaries {
        match self {
            Self::Rec709 => primaries::REC_709,
            Self::AcesCg => primaries::AP1,
        }
    }
}

impl OutputPrimaries {
    /// Their coordinates; `None` for those of the plate.
    #[must_use]
    pub fn primaries(self) -> Option<Primaries> {
        match self {
            Self::Plate => None,
            Self::Rec709 => Some(primaries::REC_709),
            Self::AcesCg => Some(primaries::AP1),
            Self::Aces20651 => Some(primaries::AP0),
        }
    }
}

impl NamedPrimaries {
    /// Their coordinates.
    #[must_use]
    pub fn primaries(self) -> Primaries {
        match self {
            Self::Rec709 => primaries::REC_709,
            Self::AcesCg => primaries::AP1,
            Self::Aces20651 => primaries::AP0,
            Self::Rec2020 => primaries::REC_2020,
            Self::P3D65 => primaries::P3_D65,
            Self::AdobeRgb => primaries::ADOBE_RGB,
        }
    }
}

impl NamedTransfer {
    /// The curve.
    #[must_use]
    pub fn transfer(self) -> Transfer {
        match self {
            Self::Srgb => Transfer::Srgb,
            Self::Linear => Transfer::Linear,
            Self::Rec709 => Transfer::Rec709,
        }
    }
}

impl Aov {
    /// Whether it reports how the method fares. The others are layers of the composite.
    #[must_use]
    pub fn is_diagnostic(self) -> bool {
        !matches!(self, Self::Object | Self::Catcher | Self::Difference)
    }

    /// Whether a method gives it.
    #[must_use]
    pub fn is_given_by(self, method: Method) -> bool {
        match self {
            Self::Object | Self::Catcher | Self::Difference => true,
            Self::Rays | Self::VisibilityError => {
                matches!(method, Method::Cells | Method::Product)
            }
            Self::Ess | Self::ZRatio | Self::Age | Self::Started | Self::ZSpread => {
                method == Method::Smc
            }
        }
    }
}

impl Default for Image {
    fn default() -> Self {
        Self {
            size: [1280, 720],
            rays_per_pixel: 16,
            filter: Filter::Box,
            tonemap: Tonemap::Srgb,
            exposure_ev: 0.0,
            background: Background::Environment,
            primaries: WorkingPrimaries::Rec709,
            pixel_aspect: 1.0,
            max_texels: MAX_TEXELS,
        }
    }
}

impl Default for Camera {
    fn default() -> Self {
        Self {
            eye: None,
            target: None,
            up: [0.0, 0.0, 1.0],
            fov_x_deg: 40.0,
            gltf: String::new(),
            interpolation: Interpolation::Smooth,
            keys: Vec::new(),
        }
    }
}

impl Default for Probe {
    fn default() -> Self {
        Self {
            frames: String::new(),
            mapping: None,
            layer: String::new(),
            primaries: None,
            rotate_z_deg: 0.0,
            scale: 1.0,
            fps: 25.0,
            ball: None,
            colour: None,
        }
    }
}

impl Default for Ball {
    fn default() -> Self {
        Self {
            distance_mm: 1250.0,
            radius_mm: 50.0,
            centre_px: None,
            radius_px: None,
            forward: [1.0, 0.0, 0.0],
            up: [0.0, 0.0, 1.0],
            size: None,
            rim_px: 1.5,
            rig_deg: 0.0,
            reflectance: [1.0; 3],
            steady: true,
        }
    }
}

impl Default for Object {
    fn default() -> Self {
        Self {
            mesh: String::new(),
            translate: [0.0; 3],
            rotate_deg: [0.0; 3],
            scale: 1.0,
            up: None,
            ground: false,
            catcher: false,
            crease_deg: CREASE_DEG,
            subdivide: 0,
            material: None,
            reflection: 0.0,
            animation: String::new(),
            animation_loop: false,
            animation_offset_s: 0.0,
            spins: Vec::new(),
        }
    }
}

impl Default for Material {
    fn default() -> Self {
        Self {
            diffuse: [0.5; 3],
            specular: [0.0; 3],
            exponent: 50.0,
        }
    }
}

impl Default for Output {
    fn default() -> Self {
        Self {
            dir: "out".to_owned(),
            exr: true,
            png: true,
            video: "shot.mp4".to_owned(),
            codec: Codec::Auto,
            aovs: Vec::new(),
            primaries: OutputPrimaries::Plate,
        }
    }
}
