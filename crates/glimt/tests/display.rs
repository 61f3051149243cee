//! Host file: on a machine without a display the program looks for devices, and nothing else speaks on its standard error.

mod common;

use common::Scratch;
use std::path::Path;

#[test]
fn devices_are_found_without_a_display() {
    let drivers = Path::new("/usr/share/vulkan/icd.d");
    if !drivers.is_dir() {
        println!(
            "skipped: there is no Vulkan driver in {}",
            drivers.display()
        );
        return;
    }
    let t = Scratch::new("display");
    // The first three name displays. The last would turn off Mesa's layer, which looks for one where a program may show images.
    let variables = [
        "XDG_RUNTIME_DIR",
        "WAYLAND_DISPLAY",
        "DISPLAY",
        "NODEVICE_SELECT",
    ];
    let mut command = t.command(&["info"]);
    for variable in variables {
        command.env_remove(variable);
    }
    let output = command.output().expect("the program starts");
    let [out, err] =
        [output.stdout, output.stderr].map(|text| String::from_utf8_lossy(&text).into_owned());
    assert!(output.status.success(), "{err}");
    // The program's own lines begin so only where it fails.
    assert!(!err.lines().any(|line| line.starts_with("error")), "{err}");
    assert!(out.lines().any(|line| line.starts_with("gpu ")), "{out}");
}
