//! Host file: sequential Monte Carlo samplers of incident light, for light that changes from frame to frame. `no_std`, no
//! alloc; glam types.
//!
//! **This version is empty.** The crate is where the sampler of Kronander, Dahlin, Jönsson, Kok, Schön, Unger: *Real-time
//! video based lighting using GPU raytracing* (EUSIPCO 2014), § 6, Eqs. 5 to 8, will be: a set of weighted directions at each
//! shading point that is carried from one frame's light to the next, by reweighting through intermediate distributions,
//! resampling where the effective sample size is low, and Metropolis-Hastings moves.

#![no_std]
