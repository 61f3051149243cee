//! Host file: keys of how a shot is rendered. Those of an estimator are the renderer's own settings.

use super::{Pattern, Preset, words};
use glimt_render_gpu::methods::{self, Smc};
use glimt_render_gpu::prepare::bake::BakeSettings;
use glimt_render_gpu::settings::SettingError;
use serde::{Deserialize, Serialize};

/// The method that most use has no table of its own: its keys stand under `render`.
macro_rules! keys {
    (
        rays {
            Mis in mis = $mis:literal, $_e:literal, $_f:ident, $_l:ident;
            $($ray:ident in $ray_module:ident = $ray_word:literal, $_re:literal, $_rf:ident, $_rl:ident;)*
        }
        groups {
            $($group:ident in $group_module:ident = $group_word:literal, $_ge:literal, $_gf:ident, $_gl:ident;)*
        }
    ) => {
        tables! {
            $mis;
            $($ray in $ray_module = $ray_word;)*
            $($group in $group_module = $group_word;)*
        }
    };
}

/// Keys of methods that have a table.
macro_rules! tables {
    (
        $mis:literal;
        $($settings:ident in $module:ident = $word:literal;)*
    ) => {
        words! {
            /// How light is estimated, or that it is precomputed.
            Method {
                /// Multiple importance sampling.
                Mis = $mis,
                $(#[doc = concat!("The estimator `", $word, "`.")] $settings = $word,)*
                /// A control variate over light cells.
                #[default] Cells = "cells",
                /// Sequential Monte Carlo.
                Smc = "smc",
                /// Precomputed radiance transfer.
                Prt = "prt",
            }
        }

        /// The words of [`Method`], as help prints them.
        pub const METHODS: &str = concat!($mis, $("|", $word,)* "|cells|smc|prt");

        /// How it is rendered.
        #[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
        #[serde(default, deny_unknown_fields)]
        pub struct Render {
            /// Estimator of reflected light.
            pub method: Method,
            /// BRDF samples on each ray.
            pub brdf_samples: u32,
            /// Environment samples on each ray.
            pub env_samples: u32,
            /// Whether environment samples leave light that is no brighter than the map's mean to BRDF samples; without effect where
            /// one of the counts is 0.
            pub compensation: bool,
            $(#[doc = concat!("Of the method \"", $word, "\".")] pub $module: methods::$settings,)*
            /// Of the method "cells".
            pub cells: methods::Cells,
            /// Of the method "smc".
            pub smc: Smc,
            /// Of the method "prt".
            pub prt: Prt,
            /// Settings under one name; keys that are given beside it win.
            pub preset: Preset,
            /// Where the uniforms come from.
            #[serde(with = "glimt_render_gpu::words")]
            pub pattern: Pattern,
            /// Seed of the random streams.
            pub seed: u32,
            /// Frames of the shot, as `1-96`, `1-96x2` or `1,3,7-9`; all that the probe has, if empty.
            pub frames: String,
        }

        impl Default for Render {
            fn default() -> Self {
                let mis = methods::Mis::default();
                Self {
                    method: Method::default(),
                    brdf_samples: mis.brdf_samples,
                    env_samples: mis.env_samples,
                    compensation: mis.compensation,
                    $($module: methods::$settings::default(),)*
                    // With one where a method is named: see `choose_method`.
                    cells: methods::Cells { memory: false, ..methods::Cells::default() },
                    smc: Smc::default(),
                    prt: Prt::default(),
                    preset: Preset::None,
                    pattern: Pattern::OwenSobol,
                    seed: 1,
                    frames: String::new(),
                }
            }
        }

        impl Render {
            /// All estimators with their settings, the chosen one or not.
            fn estimators(&self) -> Vec<(Method, methods::Method)> {
                vec![
                    (Method::Mis, self.mis().into()),
                    $((Method::$settings, self.$module.into()),)*
                    (Method::Cells, self.cells.into()),
                    (Method::Smc, self.smc.into()),
                ]
            }
        }
    };
}

glimt_render_gpu::each_estimator!(keys);

impl Render {
    fn mis(&self) -> methods::Mis {
        methods::Mis {
            brdf_samples: self.brdf_samples,
            env_samples: self.env_samples,
            compensation: self.compensation,
        }
    }

    /// The estimator; `None` where light is precomputed.
    #[must_use]
    pub fn estimator(&self) -> Option<methods::Method> {
        let all = self.estimators().into_iter();
        let mut own = all.filter(|(method, _)| *method == self.method);
        own.next().map(|(_, estimator)| estimator)
    }

    /// Checks the settings of all methods, whichever is chosen.
    ///
    /// # Errors
    /// The first that is wrong.
    pub fn check(&self) -> Result<(), SettingError> {
        for (_, estimator) in self.estimators() {
            estimator.check()?;
        }
        self.prt.settings().check()
    }

    /// Whether each frame continues from the one before it.
    #[must_use]
    pub fn continues(&self) -> bool {
        match self.estimator() {
            Some(estimator) => estimator.has_memory(),
            None => self.prt.temporal > 0.0,
        }
    }
}

/// Precomputed radiance transfer, `render.method = "prt"` and `glimt bake`.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
#[serde(default, deny_unknown_fields)]
pub struct Prt {
    /// File of the transfer that `glimt bake` computes; beside the shot, as `SHOT.prt.glb`, if empty.
    pub bake: String,
    /// Bands of spherical harmonics, 1 to 6.
    pub bands: u32,
    /// Directions of the whole sphere in which visibility is looked for, at each vertex.
    pub directions: u32,
    /// How often the light map is halved before it is projected.
    pub level: u32,
    /// Width of the Hann window on the light's bands, against ringing: as wide as there are bands is usual; 0 for none.
    pub window: f32,
    /// How much of the frame before goes into the light of a frame: `(now + temporal · before)/(1 + temporal)`.
    pub temporal: f32,
    /// Whether objects cast shadows.
    pub shadows: bool,
}

impl Default for Prt {
    fn default() -> Self {
        let (bake, default) = (BakeSettings::default(), methods::Prt::default());
        Self {
            bake: String::new(),
            bands: bake.bands,
            directions: bake.directions,
            level: default.level,
            window: default.window,
            temporal: default.temporal,
            shadows: default.shadows,
        }
    }
}

impl Prt {
    /// As the renderer takes them.
    #[must_use]
    pub fn settings(&self) -> methods::Prt {
        methods::Prt {
            level: self.level,
            window: self.window,
            temporal: self.temporal,
            shadows: self.shadows,
        }
    }
}
