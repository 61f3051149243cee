//! Host file: samples of the product of light and reflection, by cells of the light map.

use super::{CDF, Memoryless, scaled};
use crate::kernels::product;
use crate::settings::{SettingError, at_most, between, settings};

/// Name of the cells' table.
pub(crate) const CELLS: &str = "product cells";

settings! {
    /// Product sampling: the light is sampled by 32 × 16 cells in proportion to their share of what the point reflects, and combined
    /// with samples of the material by the balance heuristic.
    Product in "product" {
        /// BRDF samples N_ρ on each ray; at least 1, since they alone find light where all of a cell's product is in its corner.
        brdf_samples: u32 = 1, between(1, 65_536), "1 is usual";
        /// Samples N_P of the product on each ray.
        env_samples: u32 = 1, at_most(65_536), "1 is usual";
    }
}

impl Memoryless for Product {
    type Params = product::Product;

    fn check_all(&self) -> Result<(), SettingError> {
        self.check()
    }

    fn params(&self) -> product::Product {
        product::Product {
            brdf_samples: self.brdf_samples,
            env_samples: self.env_samples,
        }
    }

    fn reads(&self, table: &str) -> bool {
        [CDF, CELLS].contains(&table)
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
            ("product.brdf_samples", other(self.brdf_samples)),
            ("product.env_samples", other(self.env_samples)),
        ]
    }

    fn describe(&self) -> String {
        format!("{} + {} of the product", self.brdf_samples, self.env_samples)
    }
}
