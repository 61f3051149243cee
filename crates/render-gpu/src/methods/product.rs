//! Host file: samples of the product of light and reflection, by groups of a pixel's hits.

use super::{LIGHT_CELLS, Memoryless};
use crate::kernels::product;
use crate::settings::{SettingError, between, settings};

settings! {
    /// Product sampling: the hits of a pixel that lie on one surface share a proposal, which weighs the light's 512 cells by what the
    /// surface reflects of them. Lobes that are sharper than the cells are sampled by themselves.
    Product in "product" {
        /// Shadow rays of a pixel whose camera rays all hit something, on average.
        rays: u32 = 32, between(1, 65_536), "32 is usual";
    }
}

impl Memoryless for Product {
    type Params = product::Product;

    fn check_all(&self) -> Result<(), SettingError> {
        self.check()
    }

    fn params(&self) -> product::Product {
        product::Product {
            rays: self.rays as f32,
            unused_a: 0,
            unused_b: 0,
            unused_c: 0,
        }
    }

    fn reads(&self, table: &str) -> bool {
        table == LIGHT_CELLS
    }

    fn samples_per_ray(&self) -> u32 {
        1
    }

    fn cost(&self) -> [u32; 2] {
        [self.rays, 0]
    }

    fn count(&self) -> u32 {
        self.rays
    }

    fn with_count(&self, count: u32) -> Vec<(&'static str, u32)> {
        vec![("product.rays", count)]
    }

    fn describe(&self) -> String {
        format!("{} rays a pixel", self.rays)
    }
}
