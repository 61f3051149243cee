//! Shared file: the same names as elsewhere, with other meanings.

/// A number.
pub const STEP: u32 = 12;

/// Named like others elsewhere.
pub fn who() -> u32 {
    300 + super::who()
}

/// A struct whose method is named like a function.
#[derive(Clone, Copy, Debug)]
pub struct Who {
    /// A number.
    pub value: u32,
}

impl Who {
    /// Named like others elsewhere.
    #[must_use]
    pub fn who(self) -> u32 {
        self.value + who()
    }
}
