//! Host file: one definition of each setting: its name, its default, what it may be, and help. What a shot file says is read into
//! the structs that renderers take.

/// Why a setting was refused.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{key}: {what}; {fix}")]
pub struct SettingError {
    /// The table that it belongs to, as `smc`; empty for one that stands in none.
    pub table: &'static str,
    /// Its name.
    pub key: &'static str,
    /// What is wrong with it.
    pub what: String,
    /// What would do.
    pub fix: &'static str,
}

/// A number in messages: large ones shortly.
pub(crate) trait Shown: PartialOrd + Copy {
    /// Its text.
    fn shown(self) -> String;
}

impl Shown for u32 {
    fn shown(self) -> String {
        self.to_string()
    }
}

impl Shown for f32 {
    fn shown(self) -> String {
        match self.abs() >= 1e5 {
            true => format!("{self:e}"),
            false => self.to_string(),
        }
    }
}

/// Refuses what is not in `[low, high]`, NaN among it.
pub(crate) fn between<T: Shown>(low: T, high: T) -> impl Fn(&T) -> Option<String> {
    move |value| {
        let fits = *value >= low && *value <= high;
        let what = || format!("it is not between {} and {}", low.shown(), high.shown());
        (!fits).then(what)
    }
}

/// Refuses what is above `high`.
pub(crate) fn at_most<T: Shown>(high: T) -> impl Fn(&T) -> Option<String> {
    move |value| (!(*value <= high)).then(|| format!("it is above {}", high.shown()))
}

/// Takes everything.
pub(crate) fn any<T>(_: &T) -> Option<String> {
    None
}

/// Defines a struct of settings. Each key has its help, type, default, what it may be (a function of its value that says what is
/// wrong) and what to do where it is wrong.
macro_rules! settings {
    (
        $(#[$doc:meta])*
        $name:ident in $table:literal {
            $($(#[$key_doc:meta])* $key:ident: $type:ty = $default:expr, $refused:expr, $fix:literal;)+
        }
    ) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq, serde::Deserialize, serde::Serialize)]
        #[serde(default, deny_unknown_fields)]
        pub struct $name {
            $($(#[$key_doc])* pub $key: $type,)+
        }

        impl Default for $name {
            fn default() -> Self {
                Self { $($key: $default,)+ }
            }
        }

        impl $name {
            /// The table of its keys in a shot, below `render`; empty where they stand there themselves.
            pub const TABLE: &'static str = $table;

            /// The names of its keys.
            pub const KEYS: &'static [&'static str] = &[$(stringify!($key)),+];

            /// Checks each setting by itself.
            ///
            /// # Errors
            /// The first one that is out of its range.
            pub fn check(&self) -> Result<(), $crate::settings::SettingError> {
                $(
                    if let Some(what) = ($refused)(&self.$key) {
                        return Err($crate::settings::SettingError {
                            table: $table,
                            key: stringify!($key),
                            what,
                            fix: $fix,
                        });
                    }
                )+
                Ok(())
            }
        }
    };
}

pub(crate) use settings;
