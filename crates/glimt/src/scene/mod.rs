//! Host file: the objects and the camera of a shot, in the world and in each frame.

pub(crate) mod colours;
pub mod motion;
pub mod place;
pub mod view;
