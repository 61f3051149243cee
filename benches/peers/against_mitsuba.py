"""Holds glimt against Mitsuba 3: error² × time in shots that both render, each against a reference of its own.

    pip install mitsuba numpy        # and LLVM 16 or newer; DRJIT_LIBLLVM_PATH says where
    cargo build --release
    python benches/peers/against_mitsuba.py --data FOLDER --out FOLDER

FOLDER has `hdri/NAME_1k.hdr` and `models/stanford-bunny.obj`, as the shots below name them. Both programs read the same maps and
meshes, use two threads, a box filter, and direct light alone; times are of rendering, without files and compilation. Matt surfaces are
the same in both, and their pictures are compared. Lobes are not: glimt has a normalised Blinn-Phong lobe, Mitsuba a Beckmann conductor
of the same width, blended with a matt surface.
"""

import argparse
import json
import math
import pathlib
import subprocess
import time

import mitsuba as mi
import numpy as np

mi.set_variant("llvm_ad_rgb")
mi.set_log_level(mi.LogLevel.Error)
import drjit as dr  # noqa: E402 (of the variant)

SIZE = (128, 72)
SAMPLES = 64
FRAMES = 6
EYE, TARGET, FOV = (3.2, -4.0, 2.2), (0.0, 0.0, 0.8), 40.0
# Of glimt: a name, and keys.
CONTESTANTS = [
    ("cells-32", "render.method=cells render.cells.rays=32"),
    ("cells-96", "render.method=cells render.cells.rays=96"),
    ("mis-8+8", "render.method=mis render.brdf_samples=8 render.env_samples=8"),
]

parser = argparse.ArgumentParser()
parser.add_argument("--data", type=pathlib.Path, required=True)
parser.add_argument("--out", type=pathlib.Path, required=True)
parser.add_argument("--glimt", default="target/release/glimt")
parser.add_argument("--seeds", type=int, default=4)
parser.add_argument("--reference-samples", type=int, default=1 << 14)
parser.add_argument("shots", nargs="*", help="names of shots; all without any")
args = parser.parse_args()
args.out.mkdir(parents=True, exist_ok=True)


def read_map(name):
    bitmap = mi.Bitmap(str(args.data / "hdri" / f"{name}_1k.hdr"))
    return np.array(bitmap.convert(mi.Bitmap.PixelFormat.RGB, mi.Struct.Type.Float32, False))


def turning(light):
    step = light.shape[1] * 3 // 360
    return [np.roll(light, -step * frame, axis=1) for frame in range(FRAMES)]


def cut(before, after):
    return [before if frame < FRAMES // 2 else after for frame in range(FRAMES)]


def flickering(light):
    lamps = light.max(axis=2, keepdims=True) > 20 * light.mean()
    factors = np.random.default_rng(1).uniform(0.5, 1.5, FRAMES)
    return [np.where(lamps, light * factor, light).astype(np.float32) for factor in factors]


MATT = (0.7, 0.0, 0.0)
GLOSSY, SHARP = (0.3, 0.6, 50.0), (0.1, 0.9, 500.0)
# A mesh, its material (kd, ks, exponent), and the light of each frame.
SHOTS = {
    "matt sphere, sun": ("sphere", MATT, lambda: [read_map("spiaggia_di_mondello")]),
    "matt bunny, interior": ("bunny", MATT, lambda: [read_map("st_fagans_interior")]),
    "glossy bunny, studio": ("bunny", GLOSSY, lambda: [read_map("studio_small_03")]),
    "sharp sphere, warehouse": ("sphere", SHARP, lambda: [read_map("empty_warehouse_01")]),
    "glossy sphere, night": ("sphere", GLOSSY, lambda: [read_map("dikhololo_night")]),
    "video: matt bunny, turning": ("bunny", MATT, lambda: turning(read_map("st_fagans_interior"))),
    "video: glossy bunny, cut": (
        "bunny",
        GLOSSY,
        lambda: cut(read_map("studio_small_03"), read_map("empty_warehouse_01")),
    ),
    "video: glossy bunny, flicker": ("bunny", GLOSSY, lambda: flickering(read_map("studio_small_03"))),
}


def write_sphere(path):
    rows, columns = 64, 128
    lines = []
    for row in range(rows + 1):
        for column in range(columns):
            theta, phi = math.pi * row / rows, 2 * math.pi * column / columns
            n = (math.sin(theta) * math.cos(phi), math.sin(theta) * math.sin(phi), math.cos(theta))
            lines.append("v {} {} {}".format(*(round(c, 7) for c in (n[0], n[1], n[2] + 1.0))))
            lines.append("vn {} {} {}".format(*(round(c, 7) for c in n)))
    for row in range(rows):
        for column in range(columns):
            at = lambda r, c: r * columns + c % columns + 1
            a, b = at(row, column), at(row + 1, column)
            c, d = at(row + 1, column + 1), at(row, column + 1)
            if row + 1 < rows:
                lines.append(f"f {a}//{a} {b}//{b} {c}//{c}")
            if row > 0:
                lines.append(f"f {a}//{a} {c}//{c} {d}//{d}")
    path.write_text("\n".join(lines) + "\n")


def write_bunny(path):
    """The bunny, stood upright on the ground, with normals."""
    mesh = mi.load_dict({"type": "obj", "filename": str(args.data / "models" / "stanford-bunny.obj")})
    points = np.array(mi.traverse(mesh)["vertex_positions"]).reshape(-1, 3)[:, [0, 2, 1]] * [1, -1, 1]
    faces = np.array(mi.traverse(mesh)["faces"]).reshape(-1, 3)
    points = (points - [points[:, 0].mean(), points[:, 1].mean(), points[:, 2].min()]) * 11.0
    across = np.cross(points[faces[:, 1]] - points[faces[:, 0]], points[faces[:, 2]] - points[faces[:, 0]])
    normals = np.zeros_like(points)
    for corner in range(3):
        np.add.at(normals, faces[:, corner], across)
    normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-20)
    lines = [f"v {p[0]:.7f} {p[1]:.7f} {p[2]:.7f}\nvn {n[0]:.6f} {n[1]:.6f} {n[2]:.6f}" for p, n in zip(points, normals)]
    lines += ["f " + " ".join(f"{i + 1}//{i + 1}" for i in face) for face in faces]
    path.write_text("\n".join(lines) + "\n")


def write_plane(path):
    corners = [(-6, -6), (6, -6), (6, 6), (-6, 6)]
    lines = [f"v {x} {y} 0" for x, y in corners] + ["vn 0 0 1", "f 1//1 2//1 3//1", "f 1//1 3//1 4//1"]
    path.write_text("\n".join(lines) + "\n")


def mitsuba_scene(mesh, material, light, folder):
    kd, ks, exponent = material
    grey = lambda value: {"type": "rgb", "value": [value] * 3}
    bsdf = {"type": "diffuse", "reflectance": grey(kd)}
    if ks > 0:
        lobe = {
            "type": "roughconductor",
            "distribution": "beckmann",
            "alpha": math.sqrt(2 / (exponent + 2)),
            "material": "none",
            "specular_reflectance": grey(1.0),
        }
        bsdf = {"type": "blendbsdf", "weight": ks, "a": {"type": "diffuse", "reflectance": grey(kd / (1 - ks))}, "b": lobe}
    # glimt's +x, +y and +z are z, x and y of Mitsuba's map.
    to_world = mi.ScalarTransform4f(np.array([[0, 0, 1, 0], [1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 0, 1.0]]))
    return {
        "type": "scene",
        "integrator": {"type": "direct", "emitter_samples": 1, "bsdf_samples": 1, "hide_emitters": True},
        "sensor": {
            "type": "perspective",
            "fov": FOV,
            "fov_axis": "x",
            "to_world": mi.ScalarTransform4f().look_at(origin=EYE, target=TARGET, up=(0, 0, 1)),
            "film": {"type": "hdrfilm", "width": SIZE[0], "height": SIZE[1], "rfilter": {"type": "box"}, "pixel_format": "rgba"},
            "sampler": {"type": "multijitter", "sample_count": SAMPLES},
        },
        "light": {"type": "envmap", "bitmap": mi.Bitmap(light), "to_world": to_world},
        "mesh": {"type": "obj", "filename": str(folder / f"{mesh}.obj"), "bsdf": {"type": "twosided", "nested": bsdf}},
        "plane": {"type": "obj", "filename": str(folder / "plane.obj"), "bsdf": {"type": "diffuse", "reflectance": grey(0.5)}},
    }


def render_mitsuba(scene, samples, seed):
    begun = time.perf_counter()
    image = mi.render(scene, spp=samples, seed=seed)
    dr.eval(image)
    dr.sync_thread()
    return np.array(image, dtype=np.float64), time.perf_counter() - begun


def luminance(image):
    return image[..., :3] @ [0.2126, 0.7152, 0.0722]


def mitsuba_frame(scene):
    """Mean error², median seconds, and the reference's mean luminance."""
    part = 1 << 13
    parts = [render_mitsuba(scene, part, 1000 + k)[0] for k in range(args.reference_samples // part)]
    reference = np.mean(parts, axis=0)
    shown = reference[..., 3] > 0
    mean = luminance(reference)[shown].mean()
    errors, times = [], []
    for seed in range(args.seeds + 1):
        image, seconds = render_mitsuba(scene, SAMPLES, seed)
        # The first one compiles.
        if seed > 0:
            errors.append(((image - reference)[shown][:, :3] ** 2).mean() / mean**2)
            times.append(seconds)
    return np.mean(errors), np.median(times), mean


def write_shot(name, mesh, material, lights, folder):
    for frame, light in enumerate(lights, 1):
        mi.Bitmap(light).write(str(folder / f"light.{frame:04}.exr"))
    kd, ks, exponent = material
    frames = "light.####.exr" if len(lights) > 1 else "light.0001.exr"
    lobe = f", specular = [{ks}, {ks}, {ks}], exponent = {exponent}" if ks > 0 else ""
    text = f"""
[image]
size = [{SIZE[0]}, {SIZE[1]}]
background = "transparent"
filter = "box"
[camera]
eye = {list(EYE)}
target = {list(TARGET)}
fov_x_deg = {FOV}
[probe]
frames = "{frames}"
mapping = "lat-long"
[[object]]
mesh = "{mesh}.obj"
material = {{ diffuse = [{kd}, {kd}, {kd}]{lobe} }}
[[object]]
mesh = "plane.obj"
material = {{ diffuse = [0.5, 0.5, 0.5] }}
"""
    shot = folder / "shot.toml"
    shot.write_text(text.replace('.obj"\n', '.obj"\nup = "z"\n'))
    return shot


def compare_glimt(shot, frames):
    command = [args.glimt, "compare", str(shot), "--device", "cpu", "--equal-samples", "--seeds", str(args.seeds)]
    command += ["--rounds", "5", "--out", str(shot.parent / "compare"), "--quiet", "--reference-time", "40"]
    if frames > 1:
        command += ["--frames", f"1-{frames}", "--measure", ",".join(str(f) for f in range(2, frames + 1, 2))]
    for name, keys in CONTESTANTS:
        command += ["--contestant", f"{name}: {keys}"]
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
    return json.loads((shot.parent / "compare" / "compare.json").read_text())


print(f"mitsuba {mi.__version__}, {dr.thread_count()} threads; {subprocess.run([args.glimt, '--version'], capture_output=True, text=True).stdout.strip()}")
print("error² × time relative to Mitsuba: less is better\n")
products = {name: [] for name, _ in CONTESTANTS}
for name, (mesh, material, lights) in SHOTS.items():
    if args.shots and name not in args.shots:
        continue
    folder = args.out / name.replace(" ", "-").replace(",", "").replace(":", "")
    folder.mkdir(exist_ok=True)
    {"sphere": write_sphere, "bunny": write_bunny}[mesh](folder / f"{mesh}.obj")
    write_plane(folder / "plane.obj")
    lights = lights()
    found = compare_glimt(write_shot(name, mesh, material, lights, folder), len(lights))
    # As many frames as glimt is measured in: one, or every second.
    measured = lights if len(lights) == 1 else lights[1::2]
    peers = [mitsuba_frame(mi.load_dict(mitsuba_scene(mesh, material, light, folder))) for light in measured]
    peer = np.mean([error for error, _, _ in peers]) * np.mean([seconds for _, seconds, _ in peers])
    ours = np.mean([reference["mean_luminance"] for reference in found["references"]])
    theirs = np.mean([mean for _, _, mean in peers])
    line = [f"{name}: Mitsuba E {math.sqrt(np.mean([e for e, _, _ in peers])):.4f}, {1000 * np.mean([t for _, t, _ in peers]):.0f} ms"]
    for contestant in found["contestants"]:
        error, seconds = contestant["overall"]["error"]["value"], contestant["time"]["median"]
        ratio = error**2 * seconds / peer
        products[contestant["name"]].append((name, ratio))
        line.append(f"{contestant['name']} E {error:.4f}, {1000 * seconds:.0f} ms: {ratio:.2f}")
    print("; ".join(line) + f"; mean luminance {ours / theirs:.4f} of Mitsuba's", flush=True)
for contestant, ratios in products.items():
    for kind, is_video in [("stills", False), ("videos", True)]:
        own = [ratio for name, ratio in ratios if name.startswith("video") == is_video]
        if own:
            print(f"{contestant}, geometric mean of {len(own)} {kind}: {math.exp(np.mean(np.log(own))):.2f}")
