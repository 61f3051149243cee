//! Host file: what people write for the program, and what it writes and reads again: shots, settings of simulated film, states of
//! samplers, transfer, and frames that are there already.

use super::gltf;
use super::images::{picture, png_of, radiance_flat};
use super::meshes::RENDER;
use super::{Maker, words};
use crate::serve::program;
use crate::trial::put;
use std::fs;

/// A shot that is fast to render.
const SMALL: &str = "[image]\nsize = [8, 6]\nrays_per_pixel = 1\n[probe]\nframes = \"light.hdr\"\n[[object]]\nmesh = \"a.glb\"\n\
    translate = [0.0, 0.0, 1.0]\n[output]\nvideo = \"\"\npng = false\n";

const SHOTS: [&str; 3] = [
    // Everything that a camera, a light and an object may have.
    "[image]\nsize = [16, 9]\nrays_per_pixel = 4\nfilter = \"box\"\ntonemap = \"srgb\"\nexposure_ev = 0.5\nbackground = \"environment\"\nprimaries = \"acescg\"\n\
     pixel_aspect = 1.5\nmax_texels = 100000\n\
     [camera]\nup = [0.0, 0.0, 1.0]\nfov_x_deg = 40.0\ninterpolation = \"smooth\"\n\
     [[camera.key]]\nframe = 1\neye = [5.0, 0.0, 2.0]\ntarget = [0.0, 0.0, 0.0]\nfov_x_deg = 30.0\n\
     [[camera.key]]\nframe = 5\neye = [5.0, 1.0, 2.0]\ntarget = [0.0, 0.0, 0.5]\nup = [0.0, 0.1, 1.0]\n\
     [probe]\nframes = \"light.hdr\"\nmapping = \"lat-long\"\nrotate_z_deg = 30.0\nscale = 1.5\nfps = 24.0\nprimaries = \"rec2020\"\n\
     [probe.colour]\nmatrix = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]\ngains = [1.0, 1.1, 0.9]\n\
     [[object]]\nmesh = \"a.glb\"\ntranslate = [0.0, 1.0, 0.0]\nrotate_deg = [0.0, 10.0, 20.0]\nscale = 0.5\n\
     up = \"z\"\nground = true\n\
     subdivide = 1\ncrease_deg = 30.0\nanimation = \"all\"\nanimation_loop = true\nanimation_offset_s = 0.5\n\
     [object.material]\ndiffuse = [0.5, 0.5, 0.5]\nspecular = [0.1, 0.1, 0.1]\nexponent = 50.0\n\
     [[object.spin]]\nnode = \"root\"\naxis = [0.0, 0.0, 1.0]\ncentre = [0.0, 0.0, 0.0]\ndeg_per_frame = 15.0\n\
     [[object]]\nmesh = \"plane\"\nscale = 4.0\ncatcher = true\n\
     [backplate]\nframes = \"a.png\"\nshadow = \"multiply\"\nfit = \"crop\"\nfps = 24.0\nprimaries = \"p3-d65\"\n\
     transfer = \"rec709\"\noffset = 3\n\
     [render]\nframes = \"1-5\"\nmethod = \"mis\"\nseed = 3\npattern = \"owen-sobol\"\n\
     [output]\ndir = \"out\"\nexr = true\npng = true\nvideo = \"shot.mp4\"\ncodec = \"av1\"\n\
     primaries = \"plate\"\naovs = [\"object\", \"catcher\"]\n",
    // A mirror ball.
    "[image]\nsize = [16, 9]\n[camera]\neye = [4.0, 0.0, 1.0]\ntarget = [0.0, 0.0, 0.0]\n\
     [probe]\nframes = \"light.####.hdr\"\nmapping = \"mirror-ball\"\n\
     [probe.ball]\ndistance_mm = 1000.0\nradius_mm = 40.0\ncentre_px = [10.0, 5.0]\nradius_px = 4.5\nforward = [1.0, 0.0, 0.0]\n\
     up = [0.0, 0.0, 1.0]\nsize = [16, 8]\nrim_px = 0.5\nrig_deg = 5.0\nreflectance = [0.9, 0.9, 0.9]\nsteady = false\n\
     [probe.colour]\ngrey = [1, 1, 2, 2]\nframe = 1\n[[object]]\nmesh = \"sphere\"\n",
    // Transfer, and methods with settings of their own.
    "[image]\nsize = [16, 9]\n[probe]\nframes = \"light.hdr\"\n[[object]]\nmesh = \"helicopter\"\nsubdivide = 1\n\
     [camera]\ngltf = \"\"\n[render]\nmethod = \"bis\"\npreset = \"kronander\"\n\
     [render.prt]\nbands = 4\ndirections = 100\ntemporal = 0.5\n\
     [render.smc]\nparticles = 8\n",
];

const SYNTH: &str = "frames = 2\nfps = 25.0\n[light]\nrotate_z_deg = 10.0\nscale = 2.0\n[capture]\nsize = [120, 85]\npixel_um = 100\n\
    [plate]\nsize = [48, 27]\n[truth]\nsize = [32, 16]\n[[lamp]]\nazimuth_deg = 40.0\nelevation_deg = 30.0\nradius_deg = 5.0\n\
    radiance = [100.0, 90.0, 80.0]\nflicker = 0.1\n[clouds]\ncover = 0.3\n[noise]\nexposures = 4\n";

pub(super) fn add(maker: &mut Maker<'_>) -> Result<(), String> {
    let light = radiance_flat();
    let mesh = gltf::binary()?;
    let plate = png_of(&picture().into())?;
    let fixed: [(&str, &[u8]); 4] = [
        ("light.hdr", &light),
        ("light.0001.hdr", &light),
        ("a.glb", &mesh[0]),
        ("a.png", &plate),
    ];
    for shot in SHOTS {
        let files = vec![("shot.toml".to_owned(), shot.as_bytes().to_vec())];
        maker.add("shot", files, &fixed, &["info shot.toml", "load shot.toml"])?;
    }
    let files = vec![("synth.toml".to_owned(), SYNTH.as_bytes().to_vec())];
    maker.add("synth", files, &[], &["synth synth.toml"])?;

    let folder = maker.work.join("written");
    fs::create_dir_all(&folder).map_err(|e| e.to_string())?;
    for (name, bytes) in [("light.hdr", &light), ("a.glb", &mesh[1])] {
        put(&folder.join(name), bytes)?;
    }
    put(&folder.join("shot.toml"), SMALL.as_bytes())?;
    let written = |command: &str, name: &str| {
        let words = words(&folder, command);
        let words: Vec<&str> = words.iter().map(String::as_str).collect();
        program(&words).map_err(|e| format!("{command}: {e}"))?;
        let file = folder.join(name);
        fs::read(&file).map_err(|e| format!("{}: {e}", file.display()))
    };
    let fixed: [(&str, &[u8]); 3] = [
        ("light.hdr", &light),
        ("a.glb", &mesh[1]),
        ("shot.toml", SMALL.as_bytes()),
    ];
    let smc = "render shot.toml --device cpu --out out --method smc --state-out a.state";
    let files = vec![("a.state".to_owned(), written(smc, "a.state")?)];
    let more = "render shot.toml --device cpu --out out --method smc --state-in a.state";
    maker.add("state", files, &fixed, &[more])?;

    let bake = "bake shot.toml --device cpu --directions 16 --bands 3 -o shot.prt.glb";
    let files = vec![("shot.prt.glb".to_owned(), written(bake, "shot.prt.glb")?)];
    let prt = format!("{RENDER} --method prt --set render.prt.bands=3");
    maker.add("bake", files, &fixed, &[&prt])?;

    let frame = "out/frame.0001.exr";
    let files = vec![(frame.to_owned(), written(RENDER, frame)?)];
    maker.add("frame", files, &fixed, &[RENDER])?;
    Ok(())
}
