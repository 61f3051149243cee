//! Host file: bidirectional importance sampling (Kronander 2014, Eqs. 3 and 4).

use super::{CandidateSource, Memoryless, scaled};
use crate::kernels::bis;
use crate::settings::{SettingError, any, between, settings};

settings! {
    /// Bidirectional importance sampling: directions picked of many candidates for the product of light and reflection; shadow
    /// rays for those alone.
    Bis in "bis" {
        /// Candidates M on each ray.
        candidates: u32 = 32, between(1, 65_536), "the paper has 400 candidates and 20 samples";
        /// Directions N that are picked of them, each with a shadow ray.
        samples: u32 = 2, between(1, 65_536), "the paper has 400 candidates and 20 samples";
        /// Where candidates come from. The paper's BRDF alone misses a sun on a glossy object: at 30 shadow rays its error was 15
        /// to 20 times that of the mixture.
        #[serde(with = "crate::words")]
        source: CandidateSource = CandidateSource::Mixture, any, "";
    }
}

impl Memoryless for Bis {
    type Params = bis::Bis;

    fn check_all(&self) -> Result<(), SettingError> {
        self.check()
    }

    fn params(&self) -> bis::Bis {
        bis::Bis {
            candidates: self.candidates,
            samples: self.samples,
            source: self.source,
        }
    }

    fn samples_per_ray(&self) -> u32 {
        self.candidates.max(self.samples)
    }

    fn cost(&self) -> [u32; 2] {
        [self.candidates, self.samples]
    }

    fn count(&self) -> u32 {
        self.samples
    }

    fn with_count(&self, count: u32) -> Vec<(&'static str, u32)> {
        let candidates = scaled(self.candidates, count, self.samples);
        vec![("bis.candidates", candidates), ("bis.samples", count)]
    }

    fn describe(&self) -> String {
        format!("M = {}, N = {}", self.candidates, self.samples)
    }
}
