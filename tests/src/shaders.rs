//! Host file: the text of every shader of the workspace, for checks by other compilers than the one that runs them.

use std::io;
use std::path::Path;

use glimt_generate::{ENTRY_FOLDER, root};
use glimt_render_gpu::gpu::HAND_WRITTEN;

/// A shader as the renderer or a user gives it to a compiler.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ShaderText {
    /// Its file from the workspace's root; of a shader that is composed of several, its entry points.
    pub name: String,
    /// The text, whole.
    pub wgsl: String,
}

impl ShaderText {
    /// Whether it is composed of a file written by hand and of functions made from Rust.
    #[must_use]
    pub fn is_written_by_hand(&self) -> bool {
        self.name.starts_with(BY_HAND)
    }
}

/// What the names of composed shaders begin with.
const BY_HAND: &str = "by hand: ";

/// All shaders, sorted: the files that are checked in, generated and exported, and those that are written by hand, composed
/// with the functions that they call.
///
/// # Errors
///
/// A folder or a file cannot be read.
pub fn all() -> io::Result<Vec<ShaderText>> {
    let mut folders = vec![ENTRY_FOLDER.to_owned()];
    for entry in std::fs::read_dir(root().join("crates"))? {
        let name = entry?.file_name();
        folders.push(format!("crates/{}/wgsl", name.to_string_lossy()));
    }
    let mut out = Vec::new();
    for folder in folders.iter().filter(|folder| root().join(folder).is_dir()) {
        for entry in std::fs::read_dir(root().join(folder))? {
            let path = Path::new(folder).join(entry?.file_name());
            if path.extension().is_some_and(|e| e == "wgsl") {
                let wgsl = std::fs::read_to_string(root().join(&path))?;
                let name = path.to_string_lossy().replace('\\', "/");
                out.push(ShaderText { name, wgsl });
            }
        }
    }
    out.extend(HAND_WRITTEN.iter().map(|wgsl| ShaderText {
        name: format!("{BY_HAND}{}", entry_points(wgsl).join(", ")),
        wgsl: (*wgsl).to_owned(),
    }));
    out.sort_by(|a, b| a.name.cmp(&b.name));
    Ok(out)
}

/// What naga reads in a shader.
///
/// # Errors
///
/// The shader's text with what is wrong marked.
pub fn module(wgsl: &str) -> Result<naga::Module, String> {
    naga::front::wgsl::parse_str(wgsl).map_err(|e| e.emit_to_string(wgsl))
}

/// Names of a shader's entry points, in the order of the text; none if naga cannot read it.
fn entry_points(wgsl: &str) -> Vec<String> {
    let points = module(wgsl)
        .map(|module| module.entry_points)
        .unwrap_or_default();
    points.into_iter().map(|point| point.name).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_shader_is_left_out() {
        let all = all().expect("the shaders");
        for spec in glimt_generate::entries::all() {
            let shader = all
                .iter()
                .find(|s| s.name.ends_with(&format!("/{}.wgsl", spec.name)));
            let shader = shader.unwrap_or_else(|| panic!("{} is left out", spec.name));
            assert_eq!(entry_points(&shader.wgsl), [spec.name]);
        }
        for shipped in [
            glimt_brdf::WGSL,
            glimt_envmap_cdf::WGSL,
            glimt_light_cells::WGSL,
            glimt_probe::WGSL,
            glimt_sampling::WGSL,
            glimt_smc::WGSL,
            glimt_sh::WGSL,
        ] {
            assert!(all.iter().any(|s| s.wgsl == shipped));
        }
        let by_hand: Vec<_> = all.iter().filter(|s| s.is_written_by_hand()).collect();
        assert_eq!(by_hand.len(), HAND_WRITTEN.len());
        assert!(
            by_hand
                .iter()
                .any(|s| s.name == "by hand: project, sum_parts")
        );
    }
}
