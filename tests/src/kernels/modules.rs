//! Shared file: names, and what they mean where.

use super::deep::{self, names, names::Who as Renamed};
use super::input::uint;
use crate::kernels::deep::who as deep_who;

/// Named like others elsewhere.
pub fn who() -> u32 {
    100
}

mod inner {
    use super::super::deep::names::*;

    pub(super) const STEP_TWICE: u32 = STEP * 2;

    pub(super) fn who() -> u32 {
        // This module's own function hides the glob's.
        400 + super::who()
    }

    pub(super) fn made() -> Who {
        Who {
            value: self::who() + STEP,
        }
    }

    pub(super) mod innermost {
        pub(in super::super) use super::super::deep::names::who;

        pub(in super::super) fn up() -> u32 {
            super::who() + super::super::who()
        }
    }
}

use inner::innermost;

mod prelude {
    pub(super) use super::super::deep::constants::BASE;
    pub(super) use super::inner::made;
}

use prelude::*;

/// Functions of one name in many modules, each called by its own path.
pub fn paths(id: u32, ints: &[u32], _floats: &[f32]) -> [u32; 8] {
    let a = uint(id, ints, 0) & 0xFFFF;
    [
        a + who() + self::who(),
        a + deep::who() + super::deep::names::who(),
        a + names::who(),
        a + inner::who() + inner::STEP_TWICE,
        a + innermost::up() + innermost::who(),
        a + deep_who() + crate::kernels::modules::who(),
        made().who() + Renamed { value: a }.who() + BASE,
        local(a),
    ]
}

/// A local hides a function, from where it is declared.
fn local(a: u32) -> u32 {
    let from_item = who();
    let who = a ^ 3;
    who + from_item
}
