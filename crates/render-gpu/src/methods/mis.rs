//! Host file: multiple importance sampling (Kronander 2014, Eq. 2).

use super::{Memoryless, scaled};
use crate::kernels::mis;
use crate::settings::{SettingError, at_most, settings};

settings! {
    /// Multiple importance sampling: samples of the material and of the light, combined by the balance heuristic. One of the two
    /// counts may be 0, which leaves the other strategy alone.
    Mis in "" {
        /// BRDF samples N_ρ on each ray.
        brdf_samples: u32 = 1, at_most(65_536), "1 is usual";
        /// Environment samples N_L on each ray.
        env_samples: u32 = 1, at_most(65_536), "1 is usual";
    }
}

impl Memoryless for Mis {
    type Params = mis::Mis;

    fn check_all(&self) -> Result<(), SettingError> {
        self.check()?;
        if self.brdf_samples + self.env_samples > 0 {
            return Ok(());
        }
        Err(SettingError {
            table: Self::TABLE,
            key: "brdf_samples",
            what: "it is 0, and render.env_samples too".to_owned(),
            fix: "one of them must be at least 1",
        })
    }

    fn params(&self) -> mis::Mis {
        mis::Mis {
            brdf_samples: self.brdf_samples,
            env_samples: self.env_samples,
        }
    }

    fn samples_per_ray(&self) -> u32 {
        self.brdf_samples.max(self.env_samples)
    }

    fn cost(&self) -> [u32; 2] {
        [self.brdf_samples, self.env_samples]
    }

    fn count(&self) -> u32 {
        self.samples_per_ray()
    }

    fn with_count(&self, count: u32) -> Vec<(&'static str, u32)> {
        let other = |n| scaled(n, count, self.count());
        vec![
            ("brdf_samples", other(self.brdf_samples)),
            ("env_samples", other(self.env_samples)),
        ]
    }

    fn describe(&self) -> String {
        format!("{} + {}", self.brdf_samples, self.env_samples)
    }
}
