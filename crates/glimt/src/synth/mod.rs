//! Host file: the simulated capture: a mirror ball filmed in a known light, with the truth beside it.
//!
//! No one can say what an HDR video light probe should have recorded; of a simulated one it is known. [`Filming`] holds what
//! does not change from frame to frame; [`Filming::film_frame`] films the ball as a camera with shake and noise does,
//! [`Filming::film_plate`] what a second camera sees, and [`Filming::truth_map`] what an ideal probe in the ball's place
//! would have recorded. All three look at one function of radiance, [`World`]: a lat-long map on a shell, in which sun, lamps
//! and clouds are drawn, and a ball that passes before it.
//!
//! ```
//! use glam::{UVec2, Vec4};
//! use glimt::device::Processor;
//! use glimt::synth::{Filming, Synth};
//! let mut synth = Synth::default();
//! synth.capture.size = [24, 17];
//! synth.capture.pixel_um = 500.0;
//! let grey = (UVec2::new(4, 2), vec![Vec4::ONE; 8]);
//! let filming = Filming::new(synth, Some(grey), None);
//! let frame = filming.film_frame(&Processor::Cpu, &filming.world(1), 1)?;
//! assert_eq!(frame.pixels.len(), 24 * 17);
//! assert!((frame.truth.radius_px - 8.0).abs() < 0.1);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Source: S. Hajisharif, J. Kronander, E. Miandji, J. Unger: *Real-time image based lighting with streaming HDR-light probe
//! sequences*, SIGRAD 2012, § 4.1 (ball, lens and distance); C. Schlick: *An inexpensive BRDF model for physically-based
//! rendering*, 1994 (Fresnel); M. Granados et al.: *Optimal HDR reconstruction with linear digital cameras*, CVPR 2010
//! (exposures weighted by the inverse of their variance).

pub mod check;
mod clouds;
mod disc;
mod film;
mod geometry;
mod job;
mod settings;
mod sky;
mod sun;
mod truth;
mod world;

pub use film::{Filming, SynthFrame};
pub use geometry::{FrameTruth, Shake, SunTruth};
pub use job::run;
pub use settings::{
    Ball, Capture, Clouds, Lamp, Light, Noise, Occluder, Output, Plate, PlateFormat, Rig, Shape,
    Sun, Surroundings, Synth, Truth,
};
pub use truth::{MASK_HIDDEN, MASK_RIG, MASK_RIM, MASK_SEEN, rig_half_angle};
pub use world::World;
