//! Host file: multiple importance sampling (Kronander 2014, Eq. 2).

use super::{CDF, Memoryless, scaled};
use crate::kernels::mis;
use crate::settings::{SettingError, any, at_most, settings};

/// Name of the tables that draw directions where a light is brighter than its mean.
pub(crate) const COMPENSATED_CDF: &str = "compensated cdf";

settings! {
    /// Multiple importance sampling: samples of the material and of the light, combined by the balance heuristic. One of the two
    /// counts may be 0, which leaves the other strategy alone.
    Mis in "" {
        /// BRDF samples N_ρ on each ray.
        brdf_samples: u32 = 1, at_most(65_536), "1 is usual";
        /// Environment samples N_L on each ray.
        env_samples: u32 = 1, at_most(65_536), "1 is usual";
        /// Whether environment samples leave light that is no brighter than the map's mean to BRDF samples (Karlík et al. 2019). Without
        /// effect where one of the counts is 0: samples of the environment alone must find all light.
        compensation: bool = true, any, "";
    }
}

impl Mis {
    /// Whether both strategies are there, so that one may leave light to the other.
    fn compensates(&self) -> bool {
        self.compensation && self.brdf_samples > 0 && self.env_samples > 0
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

    fn reads(&self, table: &str) -> bool {
        match self.compensates() {
            true => table == COMPENSATED_CDF,
            false => table == CDF,
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
